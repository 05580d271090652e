"""The whole commissioning as a person does it in the window, and what can be done with the session afterwards.

The tests share one window and one session, in which every step is accepted before and after each of them.
"""

import json
import re
import shutil
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QDialog, QLabel, QLineEdit, QListWidget, QTableWidget, QToolButton
from pytestqt.qtbot import QtBot

from beltgui.engine.messages import Accept, JobEnded, Question
from beltgui.steps.state import STEPS, TITLES
from beltgui.viewmodel.scene import Mesh, Points
from beltgui.viewmodel.step import Action
from core.frames import inverse, transform_points
from core.path import read_urscript
from core.rough.pairs import kabsch
from tests.beltgui.walk_person import AtTheWindow, forget_all

CONTROL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
# What each step says when its samples are there: how many, and what its headline is about.
SAMPLES = {"ball": 20, "base": 15, "rough": 2, "fine": 2, "tool": 26, "error_surface": 21}
HEADLINES = {
    "ball": "held-out ball", "base": "held-out ball", "rough": "found automatically", "fine": "RMS on the faces",
    "tool": "held-out shaft mark", "error_surface": "held-out error",
}  # fmt: skip
MOUNTED = {"ball": "ball", "rough": "blade", "tool": "stylus", "error_surface": "blade"}
A_NUMBER = re.compile(r"-?\d+\.\d+ (mm|deg|µm|%|N)")


@dataclass
class Seen:
    """What the window said on the way through a step."""

    prepare: str = ""
    asked: list[str] = field(default_factory=list)
    cancelled: str = ""
    go_on: str = ""
    kept: int = 0
    working: str = ""
    rhythm: list[str] = field(default_factory=list)
    banner: str = ""
    rail: str = ""
    numbers: str = ""
    checks: str = ""
    rows: int = 0
    flags: list[str] = field(default_factory=list)
    plots: list[str] = field(default_factory=list)
    scene: str = ""
    drawn: float = 0.0
    accepted: str = ""
    next: str = ""


@dataclass
class Walked:
    """The window after the walk.

    Attributes:
        at: The window.
        folder: Of the session.
        seen: By step.
        copy: The session as it was when all was accepted.
        sizes: Of the window on the way.
        written: What the dialog after the export said and listed.
    """

    at: AtTheWindow
    folder: Path
    seen: dict[str, Seen]
    copy: Path
    sizes: set[tuple[int, int]] = field(default_factory=set)
    written: tuple[str, list[str]] = ("", [])


@pytest.fixture(scope="module")
def walked(request: pytest.FixtureRequest, qapp: object, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Walked]:
    """From the first click to the robot programs; each step is cancelled once on the way and gone on with."""
    home = tmp_path_factory.mktemp("walk")
    forget_all(home / "settings")
    at = AtTheWindow(QtBot(request))
    try:
        done = Walked(at, home / "session", {}, home / "copy")
        at.client.event.connect(lambda _: done.sizes.add((at.window.width(), at.window.height())))
        at.begin(done.folder)
        for step in STEPS:
            done.seen[step] = through(at, step)
        shutil.copytree(done.folder, done.copy)
        done.written = export(at, done.folder / "programs")
        yield done
    finally:
        at.close()


def through(at: AtTheWindow, step: str) -> Seen:
    seen = Seen(prepare=at.words("primary_button"), rhythm=[at.page.side.rhythm.accessibleName()])
    assert at.page.step == step
    ended, asked = len(at.of(JobEnded)), len(at.of(Question))
    at.start()
    # Of two scans the first is hardly there before the second one is: those steps are cancelled at their beginning.
    at.answer_all(lambda: at.rows() >= 3 or (SAMPLES[step] == 2 and "running" in at.rail(step)))
    seen.working = f"{at.words('job_title')}|{at.words('primary_button')}|{at.rail(step)}"
    seen.rhythm.append(at.page.side.rhythm.accessibleName())
    at.click("job_cancel")
    at.wait("the work has ended", lambda: len(at.of(JobEnded)) > ended and not at.busy())
    seen.cancelled, seen.kept = f"{at.of(JobEnded)[-1].how}: {at.message()}", at.rows()
    seen.go_on = at.words("primary_button")
    assert at.take().how == "done", at.everything()
    seen.asked = [question.text for question in at.of(Question)[asked:]]
    seen.rhythm.append(at.page.side.rhythm.accessibleName())
    seen.banner, seen.rail, seen.rows = at.banner(), at.rail(step), at.rows()
    if at.seen("numbers_all"):
        at.find(QToolButton, "numbers_all").click()
    seen.numbers, seen.checks = at.numbers(), at.checks()
    tabs = at.page.plots.tabs
    seen.plots = [tabs.tabText(place) for place in range(tabs.count())]
    at.wait("the scene is drawn", lambda: drawn(at) > 0.005)
    seen.scene, seen.drawn = at.page.scene.canvas.accessibleDescription(), drawn(at)
    at.accept()
    seen.rhythm.append(at.page.side.rhythm.accessibleName())
    seen.accepted, seen.next = at.banner(), at.words("primary_button")
    if step != STEPS[-1]:
        at.click("primary_button")
    return seen


def drawn(at: AtTheWindow) -> float:
    """Which part of the picture is not background, beside what is written over it."""
    image = at.page.scene.screenshot().convertToFormat(QImage.Format.Format_RGB888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    picture = rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(int)
    middle = picture[image.height() // 3 : -80, image.width() // 4 : -120]
    return float((np.abs(middle - picture[5, image.width() // 2]).max(axis=2) > 24).mean())


def export(at: AtTheWindow, folder: Path) -> tuple[str, list[str]]:
    at.click("primary_button")
    assert at.find(QLineEdit, "export_folder").text() == str(folder)
    at.click("export_dialog_write")
    at.wait("the programs are written", lambda: at.seen("exported_dialog"))
    listed = at.find(QListWidget, "exported_files")
    names = [listed.item(row).text() for row in range(listed.count())]
    told = next(label.text() for label in at.find(QDialog, "exported_dialog").findChildren(QLabel))
    at.click("exported_dialog_close")
    at.wait("the dialog is closed", lambda: not at.seen("exported_dialog"))
    return told, names


# ---- the way through


@pytest.mark.parametrize("step", STEPS)
def test_each_step_goes_from_prepare_to_accepted(walked: Walked, step: str) -> None:
    seen = walked.seen[step]
    assert seen.prepare not in ("", "Accept") and not seen.prepare.startswith("Go on")
    if step in MOUNTED:
        assert any(text.startswith(f"Mount the {MOUNTED[step]}") for text in seen.asked)
    assert "Taking samples" in seen.working and "▶  running" in seen.working
    phases = [line.removeprefix("Phase of the step: ") for line in seen.rhythm]
    assert phases == ["prepare", "acquire", "accept", "done"]
    assert seen.rows == SAMPLES[step]
    assert seen.banner.startswith("Good — can be accepted\n") and HEADLINES[step] in seen.banner
    assert HEADLINES[step] in seen.rail and "▶  ready to accept" in seen.rail
    assert seen.accepted.startswith("Accepted\n") and HEADLINES[step] in seen.accepted
    following = [*STEPS, ""][STEPS.index(step) + 1]
    assert seen.next == (f"Next step: {TITLES[following]}" if following else "Write robot programs …")


@pytest.mark.parametrize("step", STEPS)
def test_each_result_has_units_uncertainty_a_held_out_check_a_plot_and_a_picture(walked: Walked, step: str) -> None:
    seen = walked.seen[step]
    lines = seen.numbers.splitlines()
    assert len(lines) >= 4
    for line in lines:
        assert re.search(r" \d+$", line) or A_NUMBER.search(line) or re.search(r"\d (mm|deg|µm|%|N|x)?", line), line
    assert any("± " in line and "(k = 2)" in line and A_NUMBER.search(line) for line in lines), seen.numbers
    checks = seen.checks.splitlines()
    assert checks and all(line.startswith("✔") and "limit" in line for line in checks), seen.checks
    assert seen.plots and all(seen.plots)
    assert seen.scene and seen.drawn > 0.005


@pytest.mark.parametrize("step", STEPS)
def test_each_step_can_be_cancelled_and_gone_on_with_where_it_stood(walked: Walked, step: str) -> None:
    seen = walked.seen[step]
    assert seen.cancelled == "cancelled: ◆  Cancelled. What was taken is kept."
    if seen.kept == 0:
        assert seen.go_on == seen.prepare
    elif SAMPLES[step] > 2:
        assert 3 <= seen.kept < SAMPLES[step]
        assert re.match(rf"Go on \({seen.kept} of {SAMPLES[step]} \w+", seen.go_on)


def test_the_window_keeps_its_size(walked: Walked) -> None:
    assert walked.sizes == {(1280, 800)}


def test_the_rail_and_the_devices_say_how_all_stands(walked: Walked) -> None:
    for step in STEPS:
        assert re.fullmatch(rf"\d  {TITLES[step]} ✔  accepted .*{HEADLINES[step]}.*", walked.at.rail(step))
    strip = walked.at.window.device_strip.text()
    for device in ("Scanner", "Stage", "Robot", "Grinder rough", "Grinder fine"):
        assert f"{device}: simulated" in strip


def test_the_programs_are_on_the_disk_as_it_was_said(walked: Walked) -> None:
    told, names = walked.written
    folder = walked.folder / "programs"
    assert f"{len(names)} files were written to {folder}" in told
    assert sorted(path.name for path in folder.iterdir()) == sorted(names)
    programs = [name for name in names if name.endswith(".script")]
    assert programs == ["transverse.script", "longitudinal.script"]
    proof = {entry["path"]: entry for entry in json.loads((folder / "programs.proof.json").read_text())["programs"]}
    for name in programs:
        text = (folder / name).read_text()
        poses = read_urscript(text)
        assert len(poses) == proof[name]["poses"] and np.isfinite(poses).all()
        assert proof[name]["max_contact_mm"] < 1e-3
        speeds = [float(found) for found in re.findall(r" v=([\d.]+)", text)]
        assert len(speeds) == len(poses) and max(speeds) <= 0.25
    assert "held" in (folder / "report.html").read_text()


# ---- edits


@pytest.fixture
def done(walked: Walked) -> Iterator[AtTheWindow]:
    """The window with everything accepted, which it has to be again afterwards."""
    assert set(walked.at.states().values()) == {"accepted"}, walked.at.rail()
    yield walked.at
    assert set(walked.at.states().values()) == {"accepted"}, walked.at.rail()


def locked(at: AtTheWindow) -> str:
    """What the window says when an export is asked for."""
    at.key(Qt.Key.Key_E, CONTROL)
    assert not at.seen("export_dialog"), "the export is not locked"
    return at.message()


def test_a_sample_is_left_out_and_taken_back(done: AtTheWindow) -> None:
    at = done
    at.look_at("ball")
    assert at.tick(4).how == "done"
    assert at.states() == {
        "ball": "running", "base": "stale", "rough": "stale", "fine": "stale", "tool": "accepted",
        "error_surface": "stale",
    }  # fmt: skip
    row = at.page.samples.model.sample(4)
    assert not row.included and at.words("primary_button") == "Accept"
    assert "ready to accept" in at.rail("ball") and "◆  stale" in at.rail("base")
    at.look_at("base")
    banner = at.banner()
    assert banner.startswith("Stale\nStale because:\n")
    assert re.search(r"Ball was solved again and waits to be accepted: .* moved by \d+\.\d+ mm", banner)
    assert "Redo: Ball (accept), then Base (solve again, no new samples needed)." in banner
    at.look_at("error_surface")
    assert not at.usable("export_button") and Action.EXPORT not in at.view("error_surface").actions
    lock = locked(at)
    assert "Export is locked:" in lock and "Ball: running" in lock and "Base: stale. Ball was solved again" in lock
    assert "Stylus and tool" not in lock
    assert "Base: stale. Ball was solved again" in at.words("export_lock")
    at.look_at("ball")
    assert at.during(lambda: at.click("undo_button")).how == "done"
    assert at.page.samples.model.sample(4).included
    assert set(at.states().values()) == {"accepted"}
    at.during(lambda: at.key(Qt.Key.Key_Z, CONTROL | SHIFT))
    assert not at.page.samples.model.sample(4).included and at.states()["fine"] == "stale"
    at.during(lambda: at.key(Qt.Key.Key_Z, CONTROL))
    at.look_at("error_surface")
    assert at.usable("export_button") and at.words("export_lock") == ""


def test_one_sample_is_deleted_and_taken_again(done: AtTheWindow) -> None:
    at = done
    at.look_at("base")
    gone = at.choose_row(4)
    assert at.during(lambda: at.click("delete_button")).how == "done"
    ids = [row.id for row in at.view("base").content.rows]
    assert at.rows() == 14 and gone not in ids
    assert at.words("primary_button") == "Go on (14 of 15 scans)"
    assert at.take().how == "done"
    # The pose, and the closing scan after it: the earlier one does not speak for what was taken since.
    new, closing = (row for row in at.view("base").content.rows if row.id not in ids)
    assert new.name == "pose 5" and closing.name == "pose 1 again" and new.id > gone
    at.accept()
    assert at.states()["fine"] == at.states()["error_surface"] == "stale" and at.states()["rough"] == "accepted"
    at.look_at("fine")
    assert re.search(r"Base was accepted again: .* moved by \d+\.\d+ mm and \d+\.\d+ deg", at.banner())
    for step in ("fine", "error_surface"):
        at.look_at(step)
        at.press_primary("Solve again")
        at.accept()
    at.look_at("base")
    at.during(lambda: at.click("undo_button"))  # the one taken since goes, the deleted one comes back
    there = {row.id for row in at.view("base").content.rows}
    assert gone in there and new.id not in there
    assert at.states()["base"] == "running" and "The samples changed" in " ".join(at.view("base").why)
    at.during(lambda: at.click("redo_button"))
    there = {row.id for row in at.view("base").content.rows}
    assert gone not in there and new.id in there


def test_starting_over_and_back(done: AtTheWindow) -> None:
    at = done
    at.look_at("tool")
    assert at.during(lambda: at.click("start_over_button")).how == "done"
    assert at.rows() == 0 and at.numbers() == ""
    assert at.states()["tool"] == "stale" and at.states()["error_surface"] == "stale"
    assert "Stylus and tool: stale" in locked(at)
    at.during(lambda: at.click("undo_button"))
    assert at.rows() == 26 and set(at.states().values()) == {"accepted"}
    at.during(lambda: at.click("redo_button"))
    assert at.rows() == 0
    assert at.words("primary_button") == "Mount and touch"
    at.during(lambda: at.click("undo_button"))


def test_faces_are_chosen_by_a_click_in_the_picture(done: AtTheWindow) -> None:
    at = done
    at.look_at("fine")
    chosen = set(at.view("fine").content.extra["chosen_faces"])
    face = min(chosen)
    at.during(lambda: at.page.scene.picked_face.emit(face, False))
    assert set(at.view("fine").content.extra["chosen_faces"]) == chosen - {face}
    assert at.states()["fine"] != "accepted" and at.states()["error_surface"] == "stale"
    at.during(lambda: at.click("fine_reset"))
    assert set(at.view("fine").content.extra["chosen_faces"]) == chosen
    for _ in range(2):
        at.during(lambda: at.click("undo_button"))


def test_another_session_is_compared(done: AtTheWindow, walked: Walked) -> None:
    at = done
    at.look_at("ball")
    at.tick(6)
    at.menu("compare")
    at.during(lambda: at.choose_folder(walked.copy))
    at.wait("the comparison", lambda: at.seen("compare_table"))
    table = at.find(QTableWidget, "compare_table")
    lines = ["|".join(table.item(row, column).text() for column in range(7)) for row in range(table.rowCount())]
    assert {line.split("|")[0] for line in lines} == set(TITLES.values())
    ball = [line for line in lines if line.startswith("Ball|")]
    assert any(re.search(r"\|[+-]\d.* mm\|\d.* mm\|✔ the same$", line) for line in ball), lines
    at.click("compare_dialog_close")
    at.during(lambda: at.click("undo_button"))


# ---- what goes wrong is named


def rejected(at: AtTheWindow) -> str:
    """The banner of a rejected result, which cannot be accepted in any way."""
    assert at.banner().startswith("Rejected\n"), at.everything()
    step = at.page.step
    assert at.states()[step] == "failed" and "✖  failed" in at.rail(step)
    assert not (at.usable("primary_button") and at.words("primary_button") == "Accept")
    refusals = len(at.refusals())
    at.client.send(Accept(step))
    at.wait("accepting is refused", lambda: len(at.refusals()) > refusals)
    assert at.refusals()[-1].startswith(f"{TITLES[step]} was rejected and cannot be accepted.")
    assert "was rejected and cannot be accepted" in at.message()
    assert f"{TITLES[step]}: failed" in locked(at)
    return at.banner()


def test_a_ball_that_moved_between_the_scans_rejects_the_base(done: AtTheWindow) -> None:
    at = done
    at.look_at("base")
    at.during(lambda: at.click("start_over_button"))
    ended = len(at.of(JobEnded))
    at.start()
    at.answer_all(lambda: at.rows() >= 5 and at.asked(), series=False)
    at.menu("fault_ball moved")
    at.answer_all()
    at.wait("the work is over", lambda: len(at.of(JobEnded)) > ended and not at.busy())
    banner = rejected(at)
    assert "ball" in banner and "has moved meanwhile" in banner
    assert "✖" in at.checks()
    at.menu("fault_restore all")
    at.during(lambda: at.click("undo_button"))


def test_a_blade_that_slips_while_it_is_probed_rejects_the_error_surface(done: AtTheWindow) -> None:
    at = done
    at.look_at("error_surface")
    at.during(lambda: at.click("start_over_button"))
    ended = len(at.of(JobEnded))
    at.start()
    at.answer_all(lambda: at.rows() >= 5)
    at.menu("fault_blade slipped")
    at.answer_all()
    at.wait("the work is over", lambda: len(at.of(JobEnded)) > ended and not at.busy())
    banner = rejected(at)
    assert "blade" in banner.lower() and "fasten" in banner, banner
    assert re.search(r"✖ Blade after probing, moved in its clamp: \d+.* µm, limit \d+ µm", at.checks())
    at.menu("fault_restore all")
    at.during(lambda: at.click("undo_button"))


def test_a_shifted_head_zero_is_told_by_the_error_surface(done: AtTheWindow) -> None:
    at = done
    at.look_at("error_surface")
    at.during(lambda: at.click("start_over_button"))
    at.menu("fault_head zero shifted")
    at.take()
    banner = rejected(at)
    assert "head" in banner and "calibrate the tool again" in banner
    assert re.search(r"✖ Wheel at the head's stop, moved since the tool step: \d+.* µm, limit 30 µm", at.checks())
    assert not at.usable("export_button")
    at.menu("fault_restore all")
    at.during(lambda: at.click("undo_button"))


def test_a_wrong_pair_is_named_and_left_out(done: AtTheWindow) -> None:
    at = done
    at.look_at("rough")
    edits, pairs = len(at.of(JobEnded)), pairs_of_the_blade(at)
    at.during(lambda: at.click("rough_pairs"))
    for number, (on_scan, on_cad) in enumerate(pairs, start=1):
        if number == 3:
            on_cad = on_cad + np.array([0.0, 0.0, 25.0])
        at.during(lambda p=on_scan: at.page.scene.picked_point.emit("scan", p, False))
        assert f"Pick 'pair {number}' on the CAD model too." == at.words("rough_message")
        at.during(lambda p=on_cad: at.page.scene.picked_point.emit("blade", p, True))
    banner = rejected(at)
    assert "pair 3" in banner, banner
    flagged = [row for row in at.view("rough").content.rows if row.flag]
    assert [row.name for row in flagged] == ["pair 3"]
    at.tick(at.page.samples.model.row_of(flagged[0].id))
    assert at.banner().startswith("Good — can be accepted"), at.banner()
    for _ in range(len(at.of(JobEnded)) - edits):
        at.during(lambda: at.click("undo_button"))
    assert at.page.panels["rough"].automatic.isChecked()


def pairs_of_the_blade(at: AtTheWindow, count: int = 5) -> list[tuple[Any, Any]]:
    """Places that are on the scan, {M}, with the same places on the CAD model, {W}, mm; far from each other."""
    content = at.view("rough").content
    scan = np.concatenate([np.asarray(item.xyz, float) for item in content.scene.items
                           if isinstance(item, Points) and item.pickable])  # fmt: skip
    model = next(item for item in content.scene.items if isinstance(item, Mesh) and item.name == "blade")
    cad = next(item for item in content.second_scene.items if isinstance(item, Mesh) and item.name == "blade")
    measure_from_work = kabsch(np.asarray(model.vertices, float), np.asarray(cad.vertices, float))
    chosen = [int(np.argmax(np.linalg.norm(scan - scan.mean(axis=0), axis=1)))]
    while len(chosen) < count:
        far = np.min([np.linalg.norm(scan - scan[one], axis=1) for one in chosen], axis=0)
        chosen.append(int(np.argmax(far)))
    on_scan = scan[chosen]
    return list(zip(on_scan, transform_points(inverse(measure_from_work), on_scan), strict=True))
