"""The menus: what the window can do, each with a mnemonic and where it is often used a shortcut."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication, QObject, Qt
from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QMenu

from beltgui.app import language, settings
from beltgui.app.opengl import why_no_window
from beltgui.app.theme import theme
from beltgui.steps.state import STEPS
from beltgui.widgets.words import step_word

if TYPE_CHECKING:
    from beltgui.app.window import MainWindow

SPEEDS = (1, 5, 20, 100)


class Menus(QObject):
    """Builds the menu bar; builds it again when the language changes."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self.actions: dict[str, QAction] = {}
        self._menus: list[QMenu] = []
        self.write()

    def write(self) -> None:
        """Build all menus in the present language."""
        for menu in self._menus:
            menu.deleteLater()
        self._menus = []
        self.actions = {}
        self._session()
        self._step()
        self._view()
        self._simulation()
        self._help()

    def enable(self, *, session: bool, running: bool, read_only: bool) -> None:
        """What can be done now."""
        can = {
            "new": not running,
            "open": not running,
            "open_read_only": not running,
            "compare": session and not running,
            "export": session and not running and not read_only,
            **{f"fault_{name}": session and not read_only for name in faults()},
            **{f"step_{step}": session for step in STEPS},
            "step_before": session,
            "step_after": session,
            "tour": session,
            "scene_window": session and not why_no_window(),
        }
        for name, on in can.items():
            self.actions[name].setEnabled(on)
        self._recent.setEnabled(not running)

    def mark_step(self, step: str) -> None:
        """Tick the step that is looked at."""
        self.actions[f"step_{step}"].setChecked(True)

    def _session(self) -> None:
        menu = self._menu(self.tr("&Session"))
        window = self._window
        self._add(menu, "new", self.tr("&New…"), window.new_session, "Ctrl+N")
        self._add(menu, "open", self.tr("&Open…"), window.doors.ask_open, "Ctrl+O")
        self._add(menu, "open_read_only", self.tr("Open &read-only…"), window.doors.ask_open_read_only, "Ctrl+Shift+O")
        self._recent = menu.addMenu(self.tr("Re&cent"))
        self._recent.aboutToShow.connect(self._fill_recent)
        menu.addSeparator()
        self._add(menu, "compare", self.tr("Co&mpare with…"), window.doors.ask_compare)
        self._add(menu, "export", self.tr("&Export…"), window.doors.ask_export, "Ctrl+E")
        menu.addSeparator()
        self._add(menu, "quit", self.tr("&Quit"), window.close, "Ctrl+Q")

    def _step(self) -> None:
        menu = self._menu(self.tr("Ste&p"))
        group = QActionGroup(menu)
        for number, step in enumerate(STEPS, start=1):
            action = self._add(menu, f"step_{step}", f"&{number}  {step_word(step)}",
                               lambda of=step: self._window.look_at(of), f"Ctrl+{number}")  # fmt: skip
            action.setCheckable(True)
            group.addAction(action)
        menu.addSeparator()
        self._add(menu, "step_before", self.tr("Step &before"), lambda: self._window.look_by(-1), "Ctrl+PgUp")
        self._add(menu, "step_after", self.tr("Step &after"), lambda: self._window.look_by(+1), "Ctrl+PgDown")
        menu.addSeparator()
        stop = self._add(menu, "stop", self.tr("&Stop every motion at once"), self._window.stop, "F12")
        stop.setShortcutContext(Qt.ShortcutContext.ApplicationShortcut)  # from every window of the program

    def _view(self) -> None:
        menu = self._menu(self.tr("&View"))
        group = QActionGroup(menu)
        for choice, text in (("system", self.tr("As the &system")), ("light", self.tr("&Light")),
                             ("dark", self.tr("&Dark"))):  # fmt: skip
            action = self._add(menu, f"theme_{choice}", text, lambda of=choice: theme().choose(of))
            action.setCheckable(True)
            action.setChecked(theme().choice == choice)
            group.addAction(action)
        menu.addSeparator()
        tongues = QActionGroup(menu)
        # Each language is called by its own name, whatever the language of the screen.
        for code, text in language.LANGUAGES.items():
            action = self._add(menu, f"language_{code}", text, lambda of=code: self._window.speak(of))
            action.setCheckable(True)
            action.setChecked(language.current() == code)
            tongues.addAction(action)
        menu.addSeparator()
        beside = self._add(menu, "scene_window", self.tr("&3D view in a window of its own"),
                           self._window.open_scene_window, "F11")  # fmt: skip
        beside.setToolTip(why_no_window())
        menu.setToolTipsVisible(bool(why_no_window()))
        menu.addSeparator()
        larger = self._add(menu, "larger", self.tr("Lar&ger text"), lambda: theme().resize(+1))
        larger.setShortcuts([QKeySequence("Ctrl++"), QKeySequence("Ctrl+=")])
        self._add(menu, "smaller", self.tr("S&maller text"), lambda: theme().resize(-1), "Ctrl+-")
        self._add(menu, "usual", self.tr("&Usual text"), lambda: theme().resize(0), "Ctrl+0")

    def _simulation(self) -> None:
        menu = self._menu(self.tr("S&imulation"))
        training = menu.addMenu(self.tr("Let something go &wrong (training)"))
        for name, text in faults().items():
            if name == "restore all":
                training.addSeparator()
            self._add(training, f"fault_{name}", text, lambda of=name: self._window.simulate_fault(of))
        speeds = menu.addMenu(self.tr("&Speed of the next session"))
        group = QActionGroup(speeds)
        for speed in SPEEDS:
            text = self.tr("{count} times real time").format(count=speed)
            action = self._add(speeds, f"speed_{speed}", text, lambda of=speed: settings.keep("speed", str(of)))
            action.setCheckable(True)
            action.setChecked(chosen_speed() == speed)
            group.addAction(action)

    def _help(self) -> None:
        menu = self._menu(self.tr("&Help"))
        action = self._window.help_panel.toggleViewAction()
        action.setText(self.tr("&Help of the step"))
        action.setShortcut("F1")
        menu.addAction(action)
        self._add(menu, "tour", self.tr("&Tour"), self._window.begin_tour)
        self._add(menu, "keyboard", self.tr("&Keyboard…"), self._window.show_keyboard)
        menu.addSeparator()
        self._add(menu, "about", self.tr("&About…"), self._window.show_about)

    def _menu(self, title: str) -> QMenu:
        menu = self._window.menu_bar.addMenu(title)
        self._menus.append(menu)
        return menu

    def _add(self, menu: QMenu, name: str, text: str, do: Callable[[], object], shortcut: str = "") -> QAction:
        action = QAction(text, menu)
        action.setObjectName(f"action_{name}")
        if shortcut:
            action.setShortcut(QKeySequence(shortcut))
        action.triggered.connect(lambda _=False: do())
        menu.addAction(action)
        self.actions[name] = action
        return action

    def _fill_recent(self) -> None:
        self._recent.clear()
        for number, folder in enumerate(settings.recent_sessions(), start=1):
            action = self._recent.addAction(f"&{number}  {Path(folder).name}")
            action.setToolTip(folder)
            action.triggered.connect(lambda _=False, of=folder: self._window.doors.open(of))
        if self._recent.isEmpty():
            self._recent.addAction(self.tr("(none)")).setEnabled(False)


def chosen_speed() -> int:
    """How many times faster than real time the next simulated cell runs."""
    kept = settings.text("speed")
    return int(kept) if kept.isdigit() and int(kept) in SPEEDS else 20


def faults() -> dict[str, str]:
    """What can go wrong in the simulated cell: the engine's name and how the screen calls it."""
    translate = QCoreApplication.translate
    return {
        "ball moved": translate("Menus", "The reference ball moves by 0.5 mm"),
        "blade slipped": translate("Menus", "The blade slips in its clamp"),
        "wheel worn": translate("Menus", "The wheel of grinder fine is worn by 0.3 mm"),
        "head zero shifted": translate("Menus", "The zero of grinder fine's head sensor shifts by 0.1°"),
        "scanner lost": translate("Menus", "The scanner is lost"),
        "robot lost": translate("Menus", "The robot is lost"),
        "stage lost": translate("Menus", "The stage is lost"),
        "grinder fine lost": translate("Menus", "Grinder fine is lost"),
        "restore all": translate("Menus", "Put everything right again"),
    }
