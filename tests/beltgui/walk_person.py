"""A person at the window: real engine, rooms, page and 3D view on the simulated cell, used with mouse and keys only."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

from PySide6.QtCore import QEvent, QPoint, QRect, QSettings, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QFileDialog,
    QLabel,
    QLineEdit,
    QStyle,
    QStyleOptionViewItem,
    QTableView,
    QWidget,
)
from pytestqt.exceptions import TimeoutError as QtTimeoutError
from pytestqt.qtbot import QtBot

from beltgui.app import language, settings
from beltgui.app.backends import LocalBackend
from beltgui.app.client import Backend, Deliver, Ended, EngineClient
from beltgui.app.theme import theme
from beltgui.app.window import MainWindow
from beltgui.engine.messages import Command, Event, JobEnded, JobStarted, NewSession, Question, Refused
from beltgui.steps.state import STEPS, StepState
from beltgui.viewmodel.step import StepView
from beltgui.widgets.scene_view import SceneView
from beltgui.wizard.page import StepPage

W = TypeVar("W", bound=QWidget)
LEFT = Qt.MouseButton.LeftButton
WAIT_S = 90.0
GRID = (25, 18)


class CoarseCell:
    """An engine whose new sessions are on a coarse cell, which the start page does not ask for."""

    def __init__(self, backend: Backend, speed: float, grid: tuple[int, int]) -> None:
        self._backend, self._speed, self._grid = backend, speed, grid

    def start(self, deliver: Deliver, ended: Ended) -> None:
        self._backend.start(deliver, ended)

    def send(self, command: Command) -> None:
        if isinstance(command, NewSession):
            command = replace(command, resolution="test", speed=self._speed, grid=self._grid)
        self._backend.send(command)

    def close(self) -> None:
        self._backend.close()


def forget_all(folder: Path) -> None:
    """As on a computer where the program was never used, but for the tour."""
    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, str(folder))
    settings.keep("tour_seen", "yes")
    settings.keep("person", "Ada")
    theme().choose("light")
    language.install(language.ENGLISH)


class AtTheWindow:
    """One window with its engine; `close` it.

    Attributes:
        said: Every event of the engine so far, in order.
        closed: It has been closed.
    """

    def __init__(
        self, qtbot: QtBot, *, backend: Callable[[], Backend] = LocalBackend, speed: float = 0.0,
        grid: tuple[int, int] = GRID, own_process: bool = False,
    ) -> None:  # fmt: skip
        self.qtbot = qtbot
        self.said: list[Event] = []
        self.closed = False
        self.client = EngineClient(lambda: CoarseCell(backend(), speed, grid))
        self.client.event.connect(self.said.append)
        self.window = MainWindow(self.client, make_page=lambda parent: _page(parent, own_process))
        self.window.closed.connect(self.client.close)
        self.window.resize(1280, 800)
        self.window.show()
        qtbot.waitExposed(self.window)
        self.client.start()
        self.window.add_page()

    @property
    def page(self) -> StepPage:
        assert self.window.page is not None
        return self.window.page

    def close(self) -> None:
        """Close the window as a person does, wait until it is gone, and drop it."""
        self.window.close()
        self.wait("the window is closed", lambda: not self.window.isVisible())
        self.closed = True
        self.client.close()
        self.client.deleteLater()
        self.window.deleteLater()
        QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)

    # ---- looking

    def wait(self, what: str, condition: Callable[[], bool], timeout_s: float = WAIT_S) -> None:
        """Until it is so; otherwise the error says what is on the screen."""
        try:
            self.qtbot.waitUntil(lambda: bool(condition()), timeout=round(1000 * timeout_s))
        except QtTimeoutError:
            raise AssertionError(f"not within {timeout_s:g} s: {what}. On the screen:\n{self.everything()}") from None

    def everything(self) -> str:
        """What the window says, for messages of failure."""
        return "\n".join((self.rail(), self.message(), self.banner(), self.question(), str(self.window.known.job)))

    def find(self, kind: type[W], name: str) -> W:
        """The widget of that name that can be seen, in the window or a dialog beside it."""
        found = [widget for widget in self.window.findChildren(kind, name) if widget.isVisible()]
        assert len(found) == 1, f"{len(found)} visible widgets '{name}'. On the screen:\n{self.everything()}"
        return found[0]

    def seen(self, name: str) -> bool:
        return any(widget.isVisible() for widget in self.window.findChildren(QWidget, name))

    def usable(self, name: str) -> bool:
        return any(w.isVisible() and w.isEnabled() for w in self.window.findChildren(QWidget, name))

    def words(self, name: str) -> str:
        """What a label or a button says; empty while it cannot be seen."""
        if not self.seen(name):
            return ""
        widget: Any = self.find(QWidget, name)
        assert isinstance(widget, QLabel | QAbstractButton)
        return widget.text()

    def rail(self, step: str = "") -> str:
        """What the rail says of a step, or of all."""
        entries = self.window.rail.entries
        return entries[step].text_shown() if step else "\n".join(entry.text_shown() for entry in entries.values())

    def states(self) -> dict[str, str]:
        """The states' words by step."""
        return {step: str(self.window.known.views[step].state) for step in STEPS}

    def banner(self) -> str:
        return self.page.side.banner.text() if self.page.side.banner.isVisible() else ""

    def numbers(self) -> str:
        return self.page.side.numbers.text() if self.page.side.numbers.isVisible() else ""

    def checks(self) -> str:
        return self.page.side.checks.text() if self.page.side.checks.isVisible() else ""

    def question(self) -> str:
        return self.page.question.text() if self.page.question.isVisible() else ""

    def message(self) -> str:
        return self.window.message.text()

    def rows(self) -> int:
        """Of the table."""
        return self.page.samples.model.rowCount()

    def view(self, step: str) -> StepView:
        return self.window.known.views[step]

    def busy(self) -> bool:
        return self.window.known.job is not None

    def of(self, kind: type) -> list[Any]:
        """What the engine said of a kind."""
        return [event for event in self.said if isinstance(event, kind)]

    # ---- acting

    def click(self, name: str) -> None:
        """With the mouse, in the middle of what can be seen of it."""
        self.wait(f"'{name}' can be clicked", lambda: self.usable(name))
        widget = self.find(QWidget, name)
        seen = widget.visibleRegion().boundingRect()
        assert not seen.isEmpty(), f"'{name}' is covered or scrolled away"
        QTest.mouseClick(widget, LEFT, Qt.KeyboardModifier.NoModifier, _hot_spot(widget, seen))

    def key(self, key: Qt.Key, modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier) -> None:
        QTest.keyClick(self.window, key, modifiers)

    def menu(self, name: str) -> None:
        """An entry of the menus."""
        action = self.window.menus.actions[name]
        assert action.isEnabled(), name
        action.trigger()

    def begin(self, folder: Path) -> None:
        """A new session, from the start page."""
        edit = self.find(QLineEdit, "folder")
        edit.selectAll()
        QTest.keyClicks(edit, str(folder))
        self.click("begin")
        self.until_open()

    def open(self, folder: Path, how: str = "open") -> None:
        """An existing session, by the menu and the dialog."""
        self.menu(how)
        self.choose_folder(folder)
        self.until_open()

    def choose_folder(self, folder: Path) -> None:
        dialog = self.find(QFileDialog, "folder_dialog")
        dialog.setDirectory(str(folder.parent))
        dialog.selectFile(folder.name)
        dialog.accept()

    def until_open(self) -> None:
        """The session is open and every step has been solved again."""
        ended = len(self.of(JobEnded))
        self.wait("the session is open", lambda: len(self.of(JobEnded)) > ended and not self.busy())
        self.wait("all steps are shown", lambda: len(self.window.known.views) == len(STEPS))

    def look_at(self, step: str) -> None:
        """Through the rail."""
        QTest.mouseClick(self.window.rail.entries[step], LEFT)
        assert self.page.step == step

    def start(self) -> None:
        """Press the large button for work and wait until it has begun."""
        begun = len(self.of(JobStarted))
        self.click("primary_button")
        self.wait("the work has begun", lambda: len(self.of(JobStarted)) > begun)

    def asked(self) -> bool:
        """A question waits for an answer."""
        return self.usable("question_done") or self.usable("question_move")

    def until_asked(self, words: str = "") -> None:
        """Until the person is asked something (that has these words)."""
        self.wait(f"a question with '{words}'", lambda: self.asked() and words in self.question())

    def answer(self, *, series: bool = True) -> None:
        """Say yes to the question on the screen."""
        number = self.of(Question)[-1].number
        if self.usable("question_done"):
            self.click("question_done")
        else:
            if series and not self.page.question.series.isChecked():
                self.click("question_series")
            self.click("question_move")
        self.wait("the answer is taken", lambda: not self.asked() or self.of(Question)[-1].number != number)

    def answer_all(self, until: Callable[[], bool] = lambda: False, *, series: bool = True) -> None:
        """Say yes to everything until the work is over, or until something else is so."""
        while True:
            self.wait("a question or the end of the work", lambda: self.asked() or not self.busy() or until())
            if until() or not self.asked():
                return
            self.answer(series=series)

    def take(self) -> JobEnded:
        """Take what is missing in the step on the page; how it ended."""
        ended = len(self.of(JobEnded))
        self.start()
        self.answer_all()
        self.wait("the work is over", lambda: len(self.of(JobEnded)) > ended and not self.busy())
        return self.of(JobEnded)[-1]

    def accept(self) -> None:
        """The large button says Accept: press it."""
        self.wait("the result can be accepted", lambda: self.words("primary_button") == "Accept")
        self.click("primary_button")
        step = self.page.step
        self.wait("it is accepted", lambda: self.view(step).state is StepState.ACCEPTED)

    def press_primary(self, words: str) -> None:
        """The large button, which must say this; wait for the end of the work."""
        self.wait(f"the large button says '{words}'", lambda: self.words("primary_button").startswith(words))
        self.during(lambda: self.click("primary_button"))

    def during(self, do: Callable[[], object]) -> JobEnded:
        """Do something that is work without questions, and wait for the end of the work."""
        ended = len(self.of(JobEnded))
        do()
        self.wait("the work is over", lambda: len(self.of(JobEnded)) > ended and not self.busy())
        return self.of(JobEnded)[-1]

    def choose_row(self, row: int) -> int:
        """A row of the table of samples; the sample's id."""
        view = self.find(QTableView, "samples_table")
        index = view.model().index(row, 0)
        view.scrollTo(index)
        QTest.mouseClick(view.viewport(), LEFT, Qt.KeyboardModifier.NoModifier,
                         QPoint(view.visualRect(view.model().index(row, 1)).center()))  # fmt: skip
        chosen = self.page.samples.chosen_id()
        assert chosen is not None
        return chosen

    def tick(self, row: int) -> JobEnded:
        """A click on the tick box of a sample; it is solved again at once."""
        view = self.find(QTableView, "samples_table")
        index = view.model().index(row, 0)
        view.scrollTo(index)
        option = QStyleOptionViewItem()
        view.itemDelegate().initStyleOption(option, index)
        option.rect = view.visualRect(index)
        option.widget = view
        box = view.style().subElementRect(QStyle.SubElement.SE_ItemViewItemCheckIndicator, option, view)
        return self.during(
            lambda: QTest.mouseClick(view.viewport(), LEFT, Qt.KeyboardModifier.NoModifier, box.center())
        )

    def refusals(self) -> list[str]:
        """What the engine refused."""
        return [event.text for event in self.of(Refused)]


def _hot_spot(widget: QWidget, seen: QRect) -> QPoint:
    """Where a click acts: of a check box on the box, which is at its left edge."""
    return QPoint(seen.left() + 8, seen.center().y()) if widget.inherits("QCheckBox") else seen.center()


def _page(parent: QWidget, own_process: bool) -> StepPage:
    return StepPage(SceneView(parent, own_process=own_process), parent)
