"""The page of a step: 3D view, plots and samples, and on the right what to do and how good it is.

One page serves all six steps (there is one 3D view in a window): it keeps the newest view of every step and shows the
one chosen with `set_step`.

Object names that a driver finds:
    step_page, right_panel, step_title, step_purpose, step_instruction, rhythm, side_scroll, scene_view, banner,
    banner_more, banner_copy, numbers, numbers_all, checks, suggestion, live_values, step_progress, primary_button,
    solve_button, start_over_button, samples_table, samples_flagged, undo_button, redo_button,
    delete_button, plots, plot_tabs, plot_whole, question_panel, question_text, question_motion, question_picture,
    question_done, question_not_now, question_move, question_hold, question_series, panel_<step> (see the steps' own
    panels for what is in them).
"""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QResizeEvent, QShowEvent
from PySide6.QtWidgets import QHBoxLayout, QSplitter, QTabWidget, QWidget

from beltgui.app.theme import px, theme
from beltgui.engine import messages
from beltgui.steps.state import STEPS, StepState
from beltgui.viewmodel.step import Action, StepView
from beltgui.widgets.plots_area import PlotsArea
from beltgui.widgets.samples_table import SamplesTable
from beltgui.wizard.panels import make_panels
from beltgui.wizard.rhythm import Press, phase_of, primary_of
from beltgui.wizard.side import WIDTH_PX, SidePanel
from beltgui.wizard.verdict import verdict_of

# Of the page's height, up to this many pixels on a small screen.
BOTTOM_SHARE, BOTTOM_PX = 0.36, 250
# Of the page's width, between the panel's own least width and this one.
SIDE_SHARE, WIDEST_PX = 0.2, 420


class StepPage(QWidget):
    """Shows one step at a time; says with signals what the person wants.

    Args:
        scene_view: The 3D view, or what offers the same as `beltgui.widgets.scene_view.SceneView`; None makes one.
        parent: Of the widget.

    Signals:
        command: A command of `beltgui.engine.messages` for the engine.
        step_wanted: Name of the step that the person wants to go to (`Next step: Base`).
        export_wanted: The person wants to write robot programs (a folder has to be asked for).
    """

    command = Signal(object)
    step_wanted = Signal(str)
    export_wanted = Signal()

    def __init__(self, scene_view: Any = None, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("step_page")
        self._views: dict[str, StepView] = {}
        self._step = STEPS[0]
        self._job: messages.JobStarted | None = None
        self._read_only = False
        self._lock: tuple[str, ...] = ()
        self._moved_by_hand = False
        if scene_view is None:
            from beltgui.widgets.scene_view import SceneView

            scene_view = SceneView(self)
        self.scene: Any = scene_view
        self.panels = make_panels()
        self._build()
        self._connect()
        self.set_step(self._step)

    @property
    def step(self) -> str:
        """The step on the page."""
        return self._step

    def set_step(self, step: str) -> None:
        """Show this step (one of `STEPS`)."""
        if step not in STEPS:
            raise ValueError(f"step '{step}': expected one of {', '.join(STEPS)}.")
        self._step = step
        self.side.show_step(step)
        while self.tables.count() > 1:
            self.tables.removeTab(1)
        for table in self.panels[step].tables:
            self.tables.addTab(table, "")
        self._name_tables()
        self.panels[step].entered()
        self._refresh()

    def show_step(self, view: StepView) -> None:
        """Keep and, if it is the step on the page, show a view; one with a smaller generation is dropped."""
        known = self._views.get(view.step)
        if known is not None and view.generation < known.generation:
            return
        self._views[view.step] = view
        if view.step == self._step:
            self._refresh()

    def take_focus(self) -> None:
        """The keyboard is on the next thing to do, as soon as there is one."""
        self.side.await_focus()

    def forget(self) -> None:
        """Another session: drop all views."""
        self._views = {}
        self.show_job(None)
        self.show_question(None)
        self.scene.show_robot(None)
        self._refresh()

    def show_question(self, question: messages.Question | None) -> None:
        """Ask the person, or take the question away."""
        if question is not None:
            # Both at once, if only for a moment, would need more height than a small screen has.
            self.side.banner.say(None)
        self.question.ask(question)
        self.scene.show_motion(question.path if question is not None else None)
        self._refresh_actions()

    def show_job(self, job: messages.JobStarted | None, progress: messages.JobProgress | None = None) -> None:
        """Work has begun, goes on, or (None) has ended."""
        changed = job != self._job
        self._job = job
        self.side.progress.show_job(job, progress)
        if job is None:
            self.question.end()
            self.scene.show_motion(None)
        if changed:
            self._refresh_actions()

    def show_cell(self, cell: messages.CellMoved) -> None:
        """Where robot and stage are."""
        self.side.live.show_cell(cell)
        self.scene.show_robot(cell.base_from_flange)

    def stop_pressed(self) -> None:
        """Stop was pressed: the hold button counts as let go."""
        self.question.let_go()

    def set_export_lock(self, why: tuple[str, ...]) -> None:
        """Why export is locked (sentences of the engine); empty frees it."""
        self._lock = why
        self.panels["error_surface"].set_export_lock(why)

    def set_read_only(self, read_only: bool) -> None:
        """Only look: nothing can be edited or started."""
        self._read_only = read_only
        self._refresh()

    def set_language_changed(self) -> None:
        """Write again in the present language."""
        self.side.retranslate()
        self.samples.retranslate()
        self.plots.retranslate()
        self._name_tables()
        self._refresh()

    def shut_down(self) -> None:
        """Free the 3D view; must be called before the widget goes."""
        self.question.let_go()
        self.scene.shut_down()

    # ---- events

    def showEvent(self, event: QShowEvent) -> None:  # noqa: N802
        """The 3D view begins to draw when it is first seen."""
        super().showEvent(event)
        self.scene.prepare()
        self._share_out()

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802
        """The right panel's width follows the page's, the bottom's height too until a person has moved it."""
        super().resizeEvent(event)
        self._set_width()
        self._share_out()

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802
        """Another language."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self.set_language_changed()

    # ---- within

    def _build(self) -> None:
        self.plots = PlotsArea(self)
        self.samples = SamplesTable(self)
        self.tables = QTabWidget(self)
        self.tables.setObjectName("tables")
        self.tables.setDocumentMode(True)
        self.tables.setTabBarAutoHide(True)
        # Its bar takes the keyboard itself; a hidden bar as its stand-in would be where Tab gets stuck.
        self.tables.setFocusProxy(None)
        self.tables.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.tables.addTab(self.samples, "")
        self.side = SidePanel(self.panels, self)
        self.question = self.side.question
        self.bottom = QSplitter(Qt.Orientation.Horizontal, self)
        self.bottom.setObjectName("bottom")
        self.bottom.addWidget(self.plots)
        self.bottom.addWidget(self.tables)
        self.left = QSplitter(Qt.Orientation.Vertical, self)
        self.left.setObjectName("left")
        self.left.addWidget(self.scene)
        self.left.addWidget(self.bottom)
        self.left.setStretchFactor(0, 3)
        self.left.setStretchFactor(1, 2)
        for splitter in (self.bottom, self.left):
            splitter.setChildrenCollapsible(False)
            splitter.setHandleWidth(5)
            splitter.splitterMoved.connect(self._note_hand)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        layout.addWidget(self.left, 1)
        layout.addWidget(self.side)
        self._set_width()

    def _connect(self) -> None:
        theme().changed.connect(self._set_width)
        self.samples.include_wanted.connect(
            lambda sample, on: self.command.emit(messages.Include(self._step, sample, on))
        )
        self.samples.delete_wanted.connect(lambda sample: self.command.emit(messages.Delete(self._step, sample)))
        self.samples.undo_wanted.connect(lambda: self.command.emit(messages.Undo(self._step)))
        self.samples.redo_wanted.connect(lambda: self.command.emit(messages.Redo(self._step)))
        self.samples.chosen.connect(self.plots.choose)
        self.plots.chosen.connect(self.samples.choose)
        self.side.pressed.connect(self._pressed)
        self.side.solve_wanted.connect(lambda: self.command.emit(messages.Solve(self._step)))
        self.side.start_over_wanted.connect(lambda: self.command.emit(messages.StartOver(self._step)))
        self.question.command.connect(self.command)
        for panel in self.panels.values():
            panel.command.connect(self.command)
            panel.export_wanted.connect(self.export_wanted)
            panel.pick_mode_wanted.connect(self.scene.set_pick_mode)
            panel.scene_changed.connect(self._show_scene)
        self.scene.picked_point.connect(
            lambda item, xyz, second: self.panels[self._step].picked_point(item, xyz, second)
        )
        self.scene.picked_face.connect(lambda face, second: self.panels[self._step].picked_face(face))

    def _pressed(self, press: Press) -> None:
        if press is Press.NEXT:
            self.step_wanted.emit(STEPS[STEPS.index(self._step) + 1])
        elif press is Press.EXPORT:
            self.export_wanted.emit()
        elif press is not Press.WAIT:
            kinds = {Press.ACQUIRE: messages.Acquire, Press.SOLVE: messages.Solve, Press.ACCEPT: messages.Accept}
            self.command.emit(kinds[press](self._step))

    def _refresh(self) -> None:
        view = self._views.get(self._step)
        content = view.content if view is not None else None
        self.plots.show_plots(content.plots if content else ())
        if bool(content and content.plots) != self.plots.isVisibleTo(self.bottom):
            self.plots.setVisible(bool(content and content.plots))
            self._share_out()
        # Whether it may be used now is said by `set_editable`, also when work ends without another view.
        offered = view.actions if view is not None else frozenset()
        self.samples.show_samples(
            content.columns if content else (), content.rows if content else (),
            undo=Action.UNDO in offered, redo=Action.REDO in offered,
        )  # fmt: skip
        # Undo and redo are beside the table: what was deleted or started over must come back from there.
        wanted = bool((content and (content.plots or content.rows)) or offered & {Action.UNDO, Action.REDO})
        if wanted != self.bottom.isVisibleTo(self):
            self.bottom.setVisible(wanted)
            self._share_out()
        if view is not None:
            self.panels[self._step].show_view(view)
        self._show_scene()
        self._refresh_actions()

    def _refresh_actions(self) -> None:
        view = self._views.get(self._step)
        moving = self._job is not None and self._job.motion
        editable = not self._read_only and not moving
        self.samples.set_editable(editable)
        self.panels[self._step].set_editable(editable)
        asked = self.question.question is not None
        if view is None:
            view = StepView(self._step, 0, StepState.NOT_STARTED, "", (), frozenset(), None)
        acquiring = self._job is not None and self._job.motion and self._job.step == self._step
        self.side.show_view(view, phase_of(view, acquiring), asked=asked)
        self.side.show_primary(primary_of(view, busy=self._job is not None, read_only=self._read_only), asked=asked)
        self.side.solve_button.setEnabled(self._may(Action.SOLVE))
        self.side.start_over_button.setEnabled(self._may(Action.START_OVER))
        if asked:
            self.side.banner.say(None)
        else:
            self.side.banner.say(*verdict_of(view))

    def _name_tables(self) -> None:
        self.tables.setTabText(0, self.tr("Samples"))
        for place, table in enumerate(self.panels[self._step].tables, start=1):
            self.tables.setTabText(place, table.accessibleName())

    def _show_scene(self) -> None:
        view = self._views.get(self._step)
        content = view.content if view is not None else None
        if content is None:
            self.scene.show_scene(None)
        else:
            self.scene.show_scene(self.panels[self._step].scene_of(content), content.second_scene)

    def _may(self, action: Action) -> bool:
        view = self._views.get(self._step)
        if view is None or action not in view.actions or self._read_only:
            return False
        return self._job is None

    def _note_hand(self) -> None:
        self._moved_by_hand = True

    def _set_width(self) -> None:
        self.side.setFixedWidth(min(max(px(WIDTH_PX), int(self.width() * SIDE_SHARE)), px(WIDEST_PX)))

    def _share_out(self) -> None:
        if self._moved_by_hand:
            return
        bottom = max(min(int(self.height() * BOTTOM_SHARE), px(BOTTOM_PX)), self.height() * 3 // 10)
        self.left.setSizes([self.height() - bottom, bottom])
        width = self.width() - self.side.width()
        self.bottom.setSizes([width * 12 // 25, width * 13 // 25])
