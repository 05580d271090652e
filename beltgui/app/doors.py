"""Ways into a session and out of it: begin, open, compare, export. Asking for a folder blocks nothing."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QWidget

from beltgui.app.choose import ask_folder, where_sessions_are
from beltgui.app.client import EngineClient
from beltgui.app.dialogs import ExportDialog
from beltgui.app.menus import chosen_speed
from beltgui.app.start_page import Begin, StartPage
from beltgui.engine.messages import Compare, Export, NewSession, OpenSession

# Within a session's folder, where robot programs are written unless another folder is chosen.
PROGRAMS = "programs"


class Doors(QObject):
    """Sends the commands that concern a whole session.

    Args:
        window: The dialogs' parent.
        client: The engine.
        start_page: Where the person's name is.
        config: Cell file for new sessions; None takes the simulated cell's own.
        export_lock: Why export is locked.
        say: Shows a sentence.
        session_folder: Folder of the open session, or None.
    """

    def __init__(
        self,
        window: QWidget,
        client: EngineClient,
        start_page: StartPage,
        config: Path | None,
        *,
        export_lock: Callable[[], tuple[str, ...]],
        say: Callable[[str, str], None],
        session_folder: Callable[[], str | None],
    ) -> None:
        super().__init__(window)
        self._window, self._client, self._start_page, self._config = window, client, start_page, config
        self._export_lock, self._say, self._session_folder = export_lock, say, session_folder

    def begin(self, entered: Begin) -> None:
        """Begin a session with what has been entered."""
        self._start_page.set_busy(True)
        cell_file = None if self._config is None else str(self._config)
        self._client.send(NewSession(entered.folder, entered.person, entered.blade_type, entered.serial, cell_file,
                                     speed=float(chosen_speed())))  # fmt: skip

    def open(self, folder: str, *, read_only: bool = False) -> None:
        """Open a session."""
        self._start_page.notice.hide()
        self._start_page.set_busy(True)
        self._client.send(OpenSession(folder, self._start_page.entered().person, read_only))

    def ask_open(self) -> None:
        """Let a session be chosen, and open it."""
        ask_folder(self._window, self.tr("Open the session in this folder"), where_sessions_are(), self.open)

    def ask_open_read_only(self) -> None:
        """Let a session be chosen, and look at it."""
        ask_folder(self._window, self.tr("Look at the session in this folder"), where_sessions_are(),
                   lambda folder: self.open(folder, read_only=True))  # fmt: skip

    def ask_compare(self) -> None:
        """Let another session be chosen, and compare with it."""
        ask_folder(self._window, self.tr("Compare with the session in this folder"), where_sessions_are(),
                   lambda folder: self._client.send(Compare(folder)))  # fmt: skip

    def ask_export(self) -> None:
        """Propose a folder, and export to the one that is chosen; say why not while it is locked."""
        folder = self._session_folder()
        if lock := self._export_lock():
            self._say("warn", "\n".join((self.tr("Export is locked:"), *lock)))
        elif folder is not None:
            dialog = ExportDialog(Path(folder) / PROGRAMS, self._window)
            dialog.chosen.connect(lambda chosen: self._client.send(Export(chosen)))
            dialog.show()
