"""The steps' own panels: picked pairs, chosen faces, settings of the error surface, the lock of the export."""

from collections.abc import Iterator
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QLabel, QPushButton, QRadioButton, QSlider, QTableView
from pytestqt.qtbot import QtBot

from beltgui.engine.messages import Choose, JobStarted
from beltgui.steps.state import StepState
from beltgui.viewmodel.step import Action, Column, SampleRow, Use
from beltgui.wizard.page import StepPage
from tests.beltgui.wizard_canned import FakeScene, scene, view

HALF = {"row": -2, "name": "pair 2", "scan_mm": [1.0, 2.0, 3.0], "cad_mm": None, "included": True, "worst": False}
WHOLE = {"row": -1, "name": "pair 1", "scan_mm": [4.0, 5.0, 6.0], "cad_mm": [7.0, 8.0, 9.0], "included": False,
         "worst": True, "distance_mm": 1.0}  # fmt: skip
PLAIN = {"name": "pair 1", "scan_mm": [4.0, 5.0, 6.0], "cad_mm": [7.0, 8.0, 9.0], "included": False}
FACES = tuple(
    SampleRow(k, f"face {k}", ("plane", 10.0 if k < 4 else None), Use.FIT if k < 4 else Use.EXCLUDED, k < 4)
    for k in range(1, 7)
)
FACES_TABLE = ((Column("type", "Type", "", None), Column("rms", "RMS", "µm", 1)), FACES)
CHOICES = (
    {"key": "grinder", "title": "Grinder", "value": "fine", "options": ("rough", "fine")},
    {"key": "show_section", "title": "Section at v", "value": 0.3, "low": 0.1, "high": 0.9, "unit": ""},
    {"key": "show_exaggeration", "title": "Compensation drawn", "value": 50.0, "low": 1.0, "high": 1001.0, "unit": "x"},
)
TABLES = ({"key": "rejected", "title": "Rejected points", "rows": (("line 1", 0.1, 0.2, 300.0, None),), "columns": (
    Column("line", "line", decimals=None), Column("u", "u", decimals=4), Column("v", "v", decimals=4),
    Column("error", "normal error", "µm", 0), Column("deviation", "off the surface", "µm", 0))},)  # fmt: skip


@pytest.fixture
def page(qtbot: QtBot) -> Iterator[StepPage]:
    made = StepPage(FakeScene())
    qtbot.addWidget(made)
    made.resize(1086, 710)
    made.show()
    yield made
    made.shut_down()


@pytest.fixture
def said(page: StepPage) -> list[Any]:
    commands: list[Any] = []
    page.command.connect(commands.append)
    return commands


def show(page: StepPage, step: str, generation: int = 1, **extra: Any) -> None:
    page.set_step(step)
    page.show_step(view(step, generation, extra=extra))


# ---- ball, base, tool


def test_the_suggested_sample_is_added_to_the_plan(page: StepPage, said: list[Any]) -> None:
    show(page, "ball")
    take = page.panels["ball"].findChild(QPushButton, "take_suggested")
    assert take.isHidden()
    show(page, "ball", suggested=[1.0, 2.0, 3.0, 4.0], extra=[[0.0, 0.0, 0.0, 0.0]])
    take.click()
    assert said == [Choose("ball", "extra", [[0.0, 0.0, 0.0, 0.0], [1.0, 2.0, 3.0, 4.0]])]


def test_a_suggested_touch_goes_to_the_cone_or_to_a_shaft(page: StepPage, said: list[Any]) -> None:
    cone = {"translation_mm": [1.0, 2.0, 3.0], "euler_zyx_deg": [0.0, 0.0, 10.0]}
    take = page.panels["tool"].findChild(QPushButton, "take_suggested")
    show(page, "tool", suggested=cone)
    take.click()
    show(page, "tool", 2, suggested={"grinder": "fine", "angle_deg": 30.0}, extra_shafts={"fine": [10.0]})
    take.click()
    assert said == [Choose("tool", "extra_cone", [cone]), Choose("tool", "extra_shafts", {"fine": [10.0, 30.0]})]


def test_how_far_the_touches_are_is_said_for_the_cone_and_for_each_grinder(page: StepPage) -> None:
    show(page, "tool", parts=(
        {"grinder": "", "done": 12, "planned": 12},
        {"grinder": "rough", "done": 2, "planned": 6, "rest": True},
        {"grinder": "fine", "done": 6, "planned": 6, "rest": False},
    ))  # fmt: skip
    assert page.panels["tool"].findChild(QLabel, "tool_kinds").text().splitlines() == [
        "✔ Cone: 12 of 12 touches",
        "○ Grinder rough: 2 of 6 touches",
        "○ Grinder fine: 6 of 6 touches, head's stop not read yet",
    ]


# ---- rough


def test_the_method_is_chosen(page: StepPage, said: list[Any]) -> None:
    show(page, "rough", method="automatic", pairs=[])
    assert page.scene.told["mode"] == "none"
    page.findChild(QRadioButton, "rough_pairs").click()
    assert said == [Choose("rough", "method", "pairs")]
    show(page, "rough", 2, method="pairs", pairs=[])
    assert page.scene.told["mode"] == "point"
    page.findChild(QRadioButton, "rough_automatic").click()
    assert said[1:] == [Choose("rough", "method", "automatic")]


def test_a_pick_begins_a_pair_and_the_other_side_ends_it(page: StepPage, said: list[Any]) -> None:
    show(page, "rough", method="pairs", pairs=[WHOLE], next_name="pair 2", message="Pick 2 more.")
    assert page.findChild(QLabel, "rough_message").text() == "Pick 2 more."
    page.scene.picked_point.emit("scan", (1.0, 2.0, 3.0), False)
    half = {"name": "pair 2", "scan_mm": [1.0, 2.0, 3.0], "cad_mm": None, "included": True}
    assert said == [Choose("rough", "pairs", [PLAIN, half])]
    show(page, "rough", 2, method="pairs", pairs=[WHOLE, HALF])
    page.scene.picked_point.emit("blade", (9.0, 9.0, 9.0), True)
    assert said[1:] == [Choose("rough", "pairs", [PLAIN, {**half, "cad_mm": [9.0, 9.0, 9.0]}])]


def test_a_second_pick_on_the_same_side_takes_the_place_of_the_first(page: StepPage, said: list[Any]) -> None:
    show(page, "rough", method="pairs", pairs=[HALF])
    page.scene.picked_point.emit("scan", (5.0, 5.0, 5.0), False)
    assert said[0].value == [{"name": "pair 2", "scan_mm": [5.0, 5.0, 5.0], "cad_mm": None, "included": True}]


def test_a_half_picked_pair_can_be_forgotten(page: StepPage, said: list[Any]) -> None:
    show(page, "rough", method="pairs", pairs=[WHOLE])
    again = page.findChild(QPushButton, "rough_again")
    assert again.isHidden()
    show(page, "rough", 2, method="pairs", pairs=[WHOLE, HALF])
    again.click()
    assert said == [Choose("rough", "pairs", [PLAIN])]


def test_nothing_is_picked_while_the_robot_moves_or_by_who_only_looks(page: StepPage, said: list[Any]) -> None:
    show(page, "rough", method="pairs", pairs=[])
    page.show_job(JobStarted(1, "Scanning", "rough", motion=True))
    assert page.scene.told["mode"] == "none"
    page.scene.picked_point.emit("scan", (1.0, 2.0, 3.0), False)
    page.show_job(None)
    assert page.scene.told["mode"] == "point"
    page.set_read_only(True)
    page.scene.picked_point.emit("scan", (1.0, 2.0, 3.0), False)
    assert said == []


# ---- fine


def fine(page: StepPage, generation: int = 1, **extra: Any) -> None:
    show(page, "fine", generation, **{"faces_table": FACES_TABLE, "chosen_faces": (1, 2, 3), "default_faces": (1, 2),
                                      "hold": "", "scenes": {}, **extra})  # fmt: skip


def test_a_click_on_a_face_chooses_it_or_takes_it_off(page: StepPage, said: list[Any]) -> None:
    fine(page)
    assert page.scene.told["mode"] == "face"
    page.scene.picked_face.emit(5, False)
    page.scene.picked_face.emit(2, False)
    page.scene.picked_face.emit(77, False)
    page.scene.picked_face.emit(3, False)  # leaves the type's own faces, which are no choice
    assert said == [Choose("fine", "faces", faces) for faces in ([1, 2, 3, 5], [1, 3], None)]


def test_faces_are_ticked_in_their_table_too(page: StepPage, said: list[Any], qtbot: QtBot) -> None:
    fine(page)
    assert page.tables.tabText(1) == "Faces"
    page.tables.setCurrentIndex(1)
    table = page.findChild(QTableView, "faces_table")
    table.selectRow(0)
    qtbot.keyClick(table, Qt.Key.Key_Space)
    assert said == [Choose("fine", "faces", [2, 3])]
    page.set_step("ball")
    assert page.tables.count() == 1


def test_reset_to_the_types_faces(page: StepPage, said: list[Any]) -> None:
    fine(page)
    reset = page.findChild(QPushButton, "fine_reset")
    reset.click()
    assert said == [Choose("fine", "faces", None)]
    fine(page, 2, chosen_faces=(1, 2))
    assert not reset.isEnabled()


def test_faces_that_leave_the_blade_free_are_told(page: StepPage) -> None:
    fine(page)
    hold = page.findChild(QLabel, "fine_hold")
    assert hold.isHidden()
    fine(page, 2, hold="The chosen faces leave the blade free to move.")
    assert hold.text() == "▲ The chosen faces leave the blade free to move."


def test_other_colours_are_another_picture(page: StepPage) -> None:
    other = scene()
    fine(page, scenes={"signed distance": other})
    colours = page.findChild(QComboBox, "fine_colours")
    colours.setCurrentIndex(1)
    colours.activated.emit(1)
    assert page.scene.told["scene"][0] is other
    later = scene()
    fine(page, 2, scenes={"signed distance": later})
    assert page.scene.told["scene"][0] is later
    fine(page, 3)
    assert page.scene.told["scene"][0] is not later
    assert colours.isHidden()


# ---- error surface


def test_settings_are_chosen_from_a_list_and_with_sliders(page: StepPage, said: list[Any], qtbot: QtBot) -> None:
    show(page, "error_surface", choices=CHOICES, tables=TABLES)
    grinders = page.findChild(QComboBox, "choice_grinder")
    assert grinders.currentText() == "fine"
    grinders.setCurrentIndex(0)
    grinders.activated.emit(0)
    assert said == [Choose("error_surface", "grinder", "rough")]
    slider = page.findChild(QSlider, "choice_show_section")
    assert slider.value() == 50
    slider.setValue(100)
    slider.setValue(150)
    qtbot.waitUntil(lambda: len(said) == 2)
    assert said[1].key == "show_section"
    assert said[1].value == pytest.approx(0.7)


def test_sliders_show_value_and_unit_and_follow_the_engine(page: StepPage) -> None:
    show(page, "error_surface", choices=CHOICES, tables=TABLES)
    panel = page.panels["error_surface"]
    assert panel._rows["show_exaggeration"].shown.text() == "50 x"
    assert panel._rows["show_section"].shown.text() == "0.300"
    show(page, "error_surface", 2, choices=({**CHOICES[1], "value": 0.5},), tables=TABLES)
    assert panel._rows["show_section"].shown.text() == "0.500"


def test_rejected_points_are_listed(page: StepPage) -> None:
    show(page, "error_surface", choices=CHOICES, tables=TABLES)
    assert [page.tables.tabText(k) for k in range(3)] == ["Samples", "Rejected points", "Robot programs"]
    model = page.findChild(QTableView, "table_rejected").model()
    assert [model.index(0, k).data() for k in range(5)] == ["line 1", "0.1000", "0.2000", "300", "–"]
    assert model.headerData(3, Qt.Orientation.Horizontal, Qt.ItemDataRole.DisplayRole) == "normal error\nµm"


def test_export_is_locked_with_its_reasons(page: StepPage, qtbot: QtBot) -> None:
    page.set_step("error_surface")
    page.show_step(view("error_surface", state=StepState.ACCEPTED, actions={Action.EXPORT}))
    export = page.findChild(QPushButton, "export_button")
    lock = page.findChild(QLabel, "export_lock")
    assert export.isEnabled()
    with qtbot.waitSignal(page.export_wanted):
        export.click()
    page.set_export_lock(("The base step is stale.",))
    assert not export.isEnabled()
    assert lock.text() == "Export is locked:\n■ The base step is stale."
    page.set_export_lock(())
    assert lock.isHidden()
