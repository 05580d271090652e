"""The main window: puts what the engine says where a person sees it, and what a person does before the engine."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QCloseEvent, QGuiApplication, QKeySequence, QShortcut
from PySide6.QtWidgets import QDialog, QHBoxLayout, QLabel, QMainWindow, QMenuBar, QStackedWidget, QVBoxLayout, QWidget

from beltgui.app import dialogs, language, settings
from beltgui.app.client import EngineClient
from beltgui.app.closing import Closing
from beltgui.app.device_strip import DeviceStrip
from beltgui.app.doors import Doors
from beltgui.app.help_panel import HelpPanel
from beltgui.app.known import Known
from beltgui.app.language import sentence
from beltgui.app.lock import export_lock
from beltgui.app.menus import Menus
from beltgui.app.notice import Notice
from beltgui.app.rail import StepRail
from beltgui.app.start_page import Begin, StartPage
from beltgui.app.theme import theme
from beltgui.app.top_bar import TopBar
from beltgui.app.tour import Tour, keep_seen, seen
from beltgui.engine.messages import (
    Cancel,
    CellMoved,
    Compared,
    Crashed,
    DevicesChanged,
    Event,
    Exported,
    Hold,
    JobEnded,
    JobProgress,
    JobStarted,
    Question,
    QuestionGone,
    Ready,
    Refused,
    SessionOpened,
    SimulateFault,
    StepChanged,
    Stop,
)
from beltgui.steps.state import STEPS, StepState

if TYPE_CHECKING:
    from beltgui.wizard.page import StepPage


class MainWindow(QMainWindow):
    """All of the application that a person sees.

    Signals:
        closed: The window has closed and the engine is to be ended.

    Args:
        client: The engine; started by whoever made it.
        make_page: Makes the page of the steps.
        config: Cell file for new sessions; None takes the simulated cell's own.
        person: Who works; empty takes the one who worked last.
    """

    closed = Signal()

    def __init__(
        self,
        client: EngineClient,
        *,
        make_page: Callable[[QWidget], StepPage],
        config: Path | None = None,
        person: str = "",
    ) -> None:
        super().__init__()
        self.setObjectName("main_window")
        self.client = client
        self.known = Known()
        self.page: StepPage | None = None
        self.tour: Tour | None = None
        self._make_page = make_page
        self._step = STEPS[0]
        self._looked = False
        self._tour_wanted = False
        self._engine_version = ""
        self._build(person, config)
        self.closing = Closing(client, self.close, self)
        client.event.connect(self.show_event)
        client.ended.connect(self._engine_ended)
        client.restarted.connect(self._engine_starting)
        self._write()
        self._refresh()
        self._fit_screen()

    # ---- building

    def _build(self, person: str, config: Path | None) -> None:
        self.top_bar = TopBar(self)
        self.top_bar.stop.connect(self.stop)
        self.top_bar.cancel.connect(lambda: self.client.send(Cancel()))
        self.read_only_notice = Notice("read_only_notice", self)
        self.engine_notice = Notice("engine_notice", self)
        self.message = Notice("message", self)
        self.start_page = StartPage(person, self)
        self.doors = Doors(
            self, self.client, self.start_page, config, export_lock=self._export_lock, say=self.message.say,
            session_folder=lambda: None if self.known.session is None else self.known.session.folder,
        )  # fmt: skip
        self.start_page.begin.connect(lambda entered: self._begin(entered, tour=False))
        self.start_page.begin_with_tour.connect(lambda entered: self._begin(entered, tour=True))
        self.start_page.open_wanted.connect(self.doors.ask_open)
        self.start_page.recent_wanted.connect(self.doors.open)
        self.start_page.back_wanted.connect(self._show_work)
        self.rail = StepRail(self)
        self.rail.chosen.connect(self.look_at)
        self._loading = QLabel(self)
        self._loading.setObjectName("loading")
        self._work = QWidget(self)
        self._work_layout = QHBoxLayout(self._work)
        self._work_layout.setContentsMargins(0, 0, 0, 0)
        self._work_layout.addWidget(self.rail)
        self._work_layout.addWidget(self._loading, 1)
        self.stack = QStackedWidget(self)
        self.stack.addWidget(self.start_page)
        self.stack.addWidget(self._work)
        self.device_strip = DeviceStrip(self)
        # Menus, top bar and notices are above docked panels, so that Stop stays in its corner.
        self.menu_bar = QMenuBar()
        head = QWidget(self)
        layout = QVBoxLayout(head)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        for widget in (self.menu_bar, self.top_bar, self.read_only_notice, self.engine_notice, self.message):
            layout.addWidget(widget)
        self.setMenuWidget(head)
        self.setCentralWidget(self.stack)
        self.statusBar().setSizeGripEnabled(False)
        self.statusBar().addWidget(self.device_strip, 1)
        self.help_panel = HelpPanel(self)
        self.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, self.help_panel)
        self.help_panel.hide()
        self.top_bar.help.connect(self.help_panel.toggleViewAction().trigger)
        self.menus = Menus(self)
        # Esc stops from this window; in a window beside it closes that one, there F12 stops.
        QShortcut(QKeySequence(Qt.Key.Key_Escape), self).activated.connect(self.stop)

    def add_page(self) -> None:
        """Make the page of the steps and show on it what is known already."""
        page = self._make_page(self._work)
        self._work_layout.replaceWidget(self._loading, page)
        self._loading.deleteLater()
        self.page = page
        page.command.connect(self.client.send)
        page.step_wanted.connect(self.look_at)
        page.export_wanted.connect(self.doors.ask_export)
        self._fill_page()

    def _fill_page(self) -> None:
        if self.page is None:
            return
        self.page.forget()
        self.page.set_read_only(self.known.read_only or not self.client.running)
        for view in self.known.views.values():
            self.page.show_step(view)
        self.page.set_step(self._step)
        self.page.set_export_lock(self._export_lock())
        self.page.show_job(self.known.job, self.known.progress)
        self.page.show_question(self.known.question)
        if self.known.cell is not None:
            self.page.show_cell(self.known.cell)

    def _fit_screen(self) -> None:
        there = QGuiApplication.primaryScreen().availableGeometry()
        share = 1.0 if there.width() < theme().px(1400) else 0.92
        self.resize(round(there.width() * share), round(there.height() * share))
        self.move(there.center() - self.rect().center())

    # ---- what the engine says

    def show_event(self, event: Event) -> None:
        """Show an event of the engine."""
        self.known.note(event)
        match event:
            case Ready(software=software):
                self._engine_version = software
                self.engine_notice.hide()
            case SessionOpened():
                self._session_opened(event)
            case StepChanged(view=view):
                self._step_changed(view.step)
            case JobStarted():
                self.message.hide()
                self._refresh()
            case JobProgress():
                self.top_bar.show_job(self.known.job, event)
                if self.page is not None:
                    self.page.show_job(self.known.job, event)
            case JobEnded():
                self._job_ended(event)
            case Question() | QuestionGone():
                if self.page is not None:
                    self.page.show_question(self.known.question)
                if isinstance(event, Question) and self.known.job is not None:
                    self.look_at(self.known.job.step)
            case DevicesChanged(devices=devices):
                self.device_strip.show_devices(devices)
            case CellMoved():
                if self.page is not None:
                    self.page.show_cell(event)
            case Refused(text=text):
                self._refused(text)
            case Compared():
                dialogs.CompareDialog(event, self).show()
            case Exported():
                dialogs.ExportedDialog(event, self).show()
            case Crashed(text=text):
                self._show_fault(text)

    def _session_opened(self, session: SessionOpened) -> None:
        settings.add_recent(session.folder)
        self._looked = False
        self._step = STEPS[0]
        self.message.hide()
        self.rail.reset()
        self._show_work()
        self._fill_page()
        self.look_at(self._step)
        self._looked = False
        self._write()
        self._refresh()
        if self.page is not None:
            self.page.take_focus()
        if self._tour_wanted:
            self.begin_tour()
        elif not session.read_only and not seen():
            # Offered once.
            keep_seen()
            self.message.say("info", self.tr("New here? A tour of two minutes shows what is where; it is also in the "
                                             "Help menu."), self.tr("&Take the tour"), self.begin_tour)  # fmt: skip
        self._tour_wanted = False

    def _step_changed(self, step: str) -> None:
        view = self.known.views[step]
        self.rail.show_view(view)
        if self.page is not None:
            self.page.show_step(view)
            self.page.set_export_lock(self._export_lock())
        if not self._looked and len(self.known.views) == len(STEPS):
            waiting = (name for name in STEPS if self.known.views[name].state is not StepState.ACCEPTED)
            self.look_at(next(waiting, STEPS[-1]))

    def _job_ended(self, event: JobEnded) -> None:
        self._refresh()
        match event.how:
            case "cancelled":
                self.message.say("warn", self.tr("Cancelled. What was taken is kept."))
            case "stopped":
                self.message.say("warn", self.tr("Stopped. What was taken is kept; begin again when it is safe."))
            case "refused":
                self.message.say("warn", sentence(event.message))
            case "crashed":
                self._show_fault(event.message)
        self.closing.all_stopped()

    def _refused(self, text: str) -> None:
        if self.stack.currentWidget() is self.start_page:
            self.start_page.refuse(text)
        else:
            self.start_page.set_busy(False)
            self.message.say("warn", sentence(text))

    def _show_fault(self, text: str) -> None:
        self.start_page.set_busy(False)
        self.message.say("bad", self.tr("The program has a fault. What was taken is kept."), details=text)

    def _engine_ended(self, why: str) -> None:
        self.known.engine_gone()
        self.device_strip.show_devices(self.known.devices)
        self.start_page.set_busy(False)
        self.engine_notice.say(
            "bad", self.tr("The engine has ended; nothing is asked of the cell any more. Everything that was taken is "
                           "kept."), self.tr("Start it &again"), self.client.restart, details=why, stays=True,
        )  # fmt: skip
        self._refresh()
        self.closing.all_stopped()

    def _engine_starting(self) -> None:
        self.engine_notice.say("info", self.tr("The engine is starting…"), stays=True)

    # ---- what a person does

    def look_at(self, step: str) -> None:
        """Show a step; this changes nothing."""
        self._looked = True
        self._step = step
        self.rail.mark(step)
        self.help_panel.set_step(step)
        self.menus.mark_step(step)
        if self.page is not None:
            self.page.set_step(step)

    def look_by(self, by: int) -> None:
        """Show the step before (-1) or after (+1)."""
        self.look_at(STEPS[min(max(STEPS.index(self._step) + by, 0), len(STEPS) - 1)])

    def stop(self) -> None:
        """Stop every motion at once."""
        self.client.send(Stop())
        if self.page is not None:
            self.page.stop_pressed()
        if self.tour is not None:
            self.tour.end()
        if not self.client.running:
            text = self.tr("The engine has ended, so no motion is asked for. In danger use the emergency stop.")
        elif self.known.moving:
            text = self.tr("Stop has been sent.")
        else:
            text = self.tr("Stop has been sent; nothing was under way.")
        self.message.say("warn", text)

    def new_session(self) -> None:
        """Show the start page."""
        self.start_page.refresh(session_open=self.known.session is not None)
        self.stack.setCurrentWidget(self.start_page)
        self.start_page.person.setFocus()

    def _begin(self, entered: Begin, *, tour: bool) -> None:
        self._tour_wanted = tour
        self.doors.begin(entered)

    def simulate_fault(self, name: str) -> None:
        """Let something go wrong in the simulated cell."""
        self.client.send(SimulateFault(name))

    def speak(self, code: str) -> None:
        """Show everything in a language, and remember it."""
        settings.keep("language", code)
        language.install(code)

    def begin_tour(self) -> None:
        """Show around."""
        self.message.hide()
        if self.tour is None:
            self.tour = Tour(self)
            self.tour.ended.connect(self._tour_ended)

    def _tour_ended(self) -> None:
        self.tour = None
        self.rail.entries[self._step].setFocus()

    def open_scene_window(self) -> None:
        """Show the 3D view in a window of its own too."""
        if self.page is not None:
            self.page.scene.open_window()

    def show_keyboard(self) -> None:
        """Show all shortcuts."""
        dialogs.keyboard_dialog(self).show()

    def show_about(self) -> None:
        """Show what this is."""
        dialogs.about_dialog(self, self._engine_version).show()

    # ---- keeping the window true

    def _show_work(self) -> None:
        self.start_page.set_busy(False)
        self.stack.setCurrentWidget(self._work)

    def _refresh(self) -> None:
        session, running = self.known.session, self.known.job is not None
        self.top_bar.show_session(session)
        self.top_bar.show_job(self.known.job, self.known.progress)
        self.menus.enable(session=session is not None, running=running, read_only=self.known.read_only)
        if self.page is not None:
            self.page.set_read_only(self.known.read_only or not self.client.running)
            self.page.show_job(self.known.job, self.known.progress)
            self.page.show_question(self.known.question)

    def _export_lock(self) -> tuple[str, ...]:
        return export_lock(self.known)

    def _write(self) -> None:
        session = self.known.session
        if self.page is None:
            self._loading.setText(self.tr("The picture is being prepared…"))
        if session is None:
            self.setWindowTitle(self.tr("beltcal – simulated cell"))
            return
        info = session.info
        self.setWindowTitle(self.tr("{session} – beltcal, simulated cell").format(session=Path(session.folder).name))
        self.device_strip.show_who(session.person, str(info.get("blade_type", "")).upper(), str(info.get("serial", "")))
        if session.read_only:
            self.read_only_notice.say("info", self.tr("Read-only: you look at this session, nothing can be changed."),
                                      stays=True)  # fmt: skip
        else:
            self.read_only_notice.hide()

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802  (Qt's name)
        """Follow the language; a motion that is held ends when the window is left."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self.menus.write()
            self.menus.mark_step(self._step)
            self._write()
            self._refresh()
            if self.page is not None:
                self.page.set_export_lock(self._export_lock())
        elif event.type() == QEvent.Type.ActivationChange and not self.isActiveWindow() and self.known.job is not None:
            self.client.send(Hold(False))

    # ---- closing

    def closeEvent(self, event: QCloseEvent) -> None:  # noqa: N802  (Qt's name)
        """Stop what moves, then close; nothing needs saving."""
        if not self.closing.may_close(self.known.moving):
            self.stack.setEnabled(False)
            self.message.say("warn", self.tr("Stopping, then closing. Everything is kept; nothing needs saving."),
                             stays=True)  # fmt: skip
            event.ignore()
            return
        event.accept()
        self.hide()  # what follows may take a moment, and nobody should look at a window that does not answer
        if self.tour is not None:
            self.tour.end()
        for dialog in self.findChildren(QDialog):
            dialog.close()
        if self.page is not None:
            self.page.shut_down()
        self.closed.emit()
