"""The table of samples: ticking, deleting, selection that stays, sorting, words, thousands of rows."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QModelIndex, QPoint, Qt
from PySide6.QtWidgets import QTableView
from pytestqt.qtbot import QtBot

from beltgui.viewmodel.step import Column, SampleRow, Use
from beltgui.widgets.samples_model import SHARE_ROLE, SamplesModel
from beltgui.widgets.samples_table import SamplesTable
from tests.beltgui.wizard_canned import COLUMNS, rows


@pytest.fixture
def table(qtbot: QtBot) -> SamplesTable:
    made = SamplesTable()
    qtbot.addWidget(made)
    made.resize(700, 300)
    made.show()
    made.show_samples(COLUMNS, rows())
    return made


def texts(model: SamplesModel, row: int) -> list[str]:
    return [model.index(row, column).data() for column in range(model.columnCount())]


def test_units_are_in_the_heads_and_words_in_the_cells(table: SamplesTable) -> None:
    model = table.model
    heads = [model.headerData(k, Qt.Orientation.Horizontal, Qt.ItemDataRole.DisplayRole) for k in range(6)]
    assert heads == ["Sample", "Stage x\nmm", "Residual\nmm", "Radius\nmm", "Use", "Remark"]
    assert texts(model, 3) == ["▲ scan 4", "80.00", "0.0710", "12.7090", "fit", "▲ worst"]
    assert model.index(3, 0).data(Qt.ItemDataRole.ToolTipRole) == "Farthest from the fit."
    assert texts(model, 7)[4] == "held out"


def test_what_is_not_known_is_a_dash(table: SamplesTable) -> None:
    assert texts(table.model, 5) == ["scan 6", "90.00", "–", "–", "left out", ""]


def test_bars_are_relative_to_the_largest_residual(table: SamplesTable) -> None:
    model = table.model
    assert model.index(3, 2).data(SHARE_ROLE) == 1.0
    assert -1.0 < model.index(0, 2).data(SHARE_ROLE) < 0.0
    assert model.index(0, 1).data(SHARE_ROLE) is None
    assert model.index(5, 2).data(SHARE_ROLE) is None


def test_a_click_on_a_tick_box_asks_and_changes_nothing_itself(qtbot: QtBot, table: SamplesTable) -> None:
    view = table.view
    cell = view.visualRect(table.model.index(1, 0))
    with qtbot.waitSignal(table.include_wanted) as asked:
        qtbot.mouseClick(
            view.viewport(), Qt.MouseButton.LeftButton, pos=cell.topLeft() + QPoint(10, cell.height() // 2)
        )
    assert asked.args == [2, False]
    assert table.model.sample(1).included


def test_space_toggles_and_delete_deletes_the_chosen_sample(qtbot: QtBot, table: SamplesTable) -> None:
    table.choose(6)
    with qtbot.waitSignal(table.include_wanted) as ticked:
        qtbot.keyClick(table.view, Qt.Key.Key_Space)
    assert ticked.args == [6, True]
    with qtbot.waitSignal(table.delete_wanted) as deleted:
        qtbot.keyClick(table.view, Qt.Key.Key_Delete)
    assert deleted.args == [6]


def test_the_menu_names_what_it_does(qtbot: QtBot, table: SamplesTable) -> None:
    table.choose(6)
    menu = table.menu()
    assert [action.text() for action in menu.actions()] == ["Take into the fit", "Delete"]
    with qtbot.waitSignal(table.delete_wanted) as deleted:
        menu.actions()[1].trigger()
    assert deleted.args == [6]
    table.choose(1)
    assert table.menu().actions()[0].text() == "Leave out of the fit"


def test_nothing_can_be_edited_while_it_is_not_allowed(qtbot: QtBot, table: SamplesTable) -> None:
    table.choose(1)
    table.set_editable(False)
    asked = []
    table.include_wanted.connect(lambda *args: asked.append(args))
    table.delete_wanted.connect(lambda *args: asked.append(args))
    qtbot.keyClick(table.view, Qt.Key.Key_Space)
    qtbot.keyClick(table.view, Qt.Key.Key_Delete)
    assert not asked
    assert not table.delete_button.isEnabled()
    assert not any(action.isEnabled() for action in table.menu().actions())
    assert not table.model.flags(table.model.index(0, 0)) & Qt.ItemFlag.ItemIsUserCheckable


def test_a_sample_that_cannot_be_left_out_has_no_tick_to_click(qtbot: QtBot, table: SamplesTable) -> None:
    fixed = (replace(rows()[0], can_exclude=False), *rows()[1:])
    table.show_samples(COLUMNS, fixed)
    assert not table.model.flags(table.model.index(0, 0)) & Qt.ItemFlag.ItemIsUserCheckable
    table.choose(1)
    with qtbot.assertNotEmitted(table.include_wanted):
        qtbot.keyClick(table.view, Qt.Key.Key_Space)


def test_undo_and_redo_are_offered_when_there_is_something(qtbot: QtBot, table: SamplesTable) -> None:
    assert not table.undo_button.isEnabled()
    table.show_samples(COLUMNS, rows(), undo=True, redo=True)
    with qtbot.waitSignals([table.undo_wanted, table.redo_wanted]):
        table.undo_button.click()
        table.redo_button.click()


@pytest.mark.parametrize("change", ["values", "append", "remove", "other"])
def test_the_chosen_sample_stays_chosen(table: SamplesTable, change: str) -> None:
    table.choose(9)
    old = rows()
    new = {
        "values": tuple(replace(row, cells=(1.0, 2.0, 3.0)) for row in old),
        "append": (*old, SampleRow(99, "scan 21", (1.0, 2.0, 3.0), Use.FIT)),
        "remove": tuple(row for row in old if row.id != 4),
        "other": tuple(row for row in old if row.id % 3 == 0),
    }[change]
    table.show_samples(COLUMNS, new)
    assert table.chosen_id() == 9
    assert [table.model.sample(k).id for k in range(table.model.rowCount())] == [row.id for row in new]


def test_a_sample_that_goes_is_not_chosen_any_more(table: SamplesTable) -> None:
    table.choose(4)
    table.show_samples(COLUMNS, tuple(row for row in rows() if row.id != 4))
    table.choose(None)
    assert table.chosen_id() is None


def test_negative_ids_are_ids_like_others(qtbot: QtBot, table: SamplesTable) -> None:
    table.show_samples(COLUMNS, tuple(replace(row, id=-row.id) for row in rows(4)))
    table.choose(-1)
    assert table.chosen_id() == -1
    with qtbot.waitSignal(table.delete_wanted) as deleted:
        qtbot.keyClick(table.view, Qt.Key.Key_Delete)
    assert deleted.args == [-1]


def test_a_click_on_a_head_sorts_and_what_is_not_known_comes_last(table: SamplesTable) -> None:
    head = table.view.horizontalHeader()
    table.choose(4)
    head.sectionClicked.emit(2)
    assert table.model.sample(19).id == 6
    assert table.model.sample(18).id == 4
    head.sectionClicked.emit(2)
    assert table.model.sample(0).id == 4
    assert table.chosen_id() == 4
    head.sectionClicked.emit(2)
    assert [table.model.sample(k).id for k in range(20)] == list(range(1, 21))


def test_only_what_stands_out(table: SamplesTable) -> None:
    table.flagged_only.setChecked(True)
    assert [table.model.sample(k).id for k in range(table.model.rowCount())] == [4, 6]


def test_other_columns_begin_anew(table: SamplesTable) -> None:
    table.show_samples((Column("kind", "Kind", "", None),), (SampleRow(1, "touch 1", ("cone",), Use.FIT),))
    assert texts(table.model, 0) == ["touch 1", "cone", "fit", ""]


def test_four_thousand_rows_are_updated_in_place(qtbot: QtBot, table: SamplesTable) -> None:
    many = rows(4000)
    table.show_samples(COLUMNS, many)
    table.choose(3000)
    resets, changed = [], []
    table.model.modelReset.connect(lambda: resets.append(1))
    table.model.dataChanged.connect(lambda first, last: changed.append((first.row(), last.row())))
    table.show_samples(COLUMNS, tuple(replace(row, included=False) if row.id == 3000 else row for row in many))
    assert not resets
    assert len(changed) == 1
    assert table.chosen_id() == 3000
    assert not table.model.sample(2999).included


def test_the_root_has_rows_and_cells_have_none(table: SamplesTable) -> None:
    assert table.model.rowCount(QModelIndex()) == 20
    assert table.model.rowCount(table.model.index(0, 0)) == 0
    assert isinstance(table.findChild(QTableView, "samples_table"), QTableView)
