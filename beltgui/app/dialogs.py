"""Windows beside the main one. None of them blocks it, so that Stop is always within reach."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QCoreApplication, Qt, QUrl, Signal
from PySide6.QtGui import QColor, QDesktopServices, QFontDatabase, QGuiApplication, QHideEvent, QShowEvent
from PySide6.QtWidgets import (
    QDialog,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QLineEdit,
    QListWidget,
    QPlainTextEdit,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from beltgui import __version__
from beltgui.app.choose import ask_folder, to_front
from beltgui.app.language import sentence
from beltgui.app.theme import colour, px
from beltgui.engine.messages import Compared, ComparedRow, Exported
from beltgui.widgets.words import step_word


class Beside(QDialog):
    """A window beside the main one: not modal, gone when closed."""

    def __init__(self, name: str, title: str, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName(name)
        self.setWindowTitle(title)
        self.setModal(False)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.body = QVBoxLayout(self)
        self._buttons = QHBoxLayout()
        self._buttons.addStretch(1)

    def showEvent(self, event: QShowEvent) -> None:  # noqa: N802  (Qt's name)
        """The keyboard is here while it is open, also where no window manager sees to that."""
        super().showEvent(event)
        to_front(self)

    def hideEvent(self, event: QHideEvent) -> None:  # noqa: N802  (Qt's name)
        """The keyboard goes back to where it came from."""
        super().hideEvent(event)
        parent = self.parentWidget()
        if parent is not None and parent.window().isVisible():
            parent.window().activateWindow()

    def finish(self) -> None:
        """Add the row of buttons at the end."""
        close = self.add_button(self.tr("&Close"), "close")
        close.clicked.connect(self.close)
        close.setDefault(True)
        self.body.addLayout(self._buttons)

    def add_button(self, text: str, name: str) -> QPushButton:
        """A button in the last row."""
        button = QPushButton(text, self)
        button.setObjectName(f"{self.objectName()}_{name}")
        self._buttons.addWidget(button)
        return button


class CompareDialog(Beside):
    """Two sessions side by side."""

    def __init__(self, compared: Compared, parent: QWidget) -> None:
        super().__init__("compare_dialog", "", parent)
        self.setWindowTitle(self.tr("Compared with {name}").format(name=Path(compared.folder).name))
        told = QLabel(
            self.tr("A number has changed where it moved by more than both uncertainties together (k = 2) allow."), self
        )
        told.setWordWrap(True)
        self.table = QTableWidget(len(compared.rows), 7, self)
        self.table.setObjectName("compare_table")
        self.table.setAccessibleName(self.tr("Numbers of both sessions"))
        self.table.setHorizontalHeaderLabels(
            [self.tr("Step"), self.tr("What"), self.tr("This session"), self.tr("The other"), self.tr("Moved"),
             self.tr("By chance up to (k = 2)"), ""]
        )  # fmt: skip
        self.table.setEditTriggers(QTableWidget.EditTrigger.NoEditTriggers)
        self.table.verticalHeader().hide()
        for number, row in enumerate(compared.rows):
            self._fill(number, row)
        self.table.resizeColumnsToContents()
        self.table.horizontalHeader().setSectionResizeMode(1, QHeaderView.ResizeMode.Stretch)
        self.body.addWidget(told)
        self.body.addWidget(self.table)
        self.resize(px(860), px(480))
        self.finish()

    def _fill(self, number: int, row: ComparedRow) -> None:
        changed = row.moved is not None and row.chance is not None and abs(row.moved) > row.chance
        verdict = "" if row.moved is None or row.chance is None else (
            self.tr("◆ changed") if changed else self.tr("✔ the same")
        )  # fmt: skip
        cells = (
            step_word(row.step), sentence(row.what), _number(row.here, row.unit), _number(row.there, row.unit),
            _number(row.moved, row.unit, sign=True), _number(row.chance, row.unit), verdict,
        )  # fmt: skip
        for column, text in enumerate(cells):
            item = QTableWidgetItem(text)
            if column in (2, 3, 4, 5):
                item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
            if changed and column in (4, 6):
                item.setForeground(QColor(colour("warn")))
            self.table.setItem(number, column, item)


class ExportDialog(Beside):
    """Where robot programs and report are to be written: proposed, so that Enter is enough.

    Signals:
        chosen: The folder; it is made if there is none.
    """

    chosen = Signal(str)

    def __init__(self, proposed: Path, parent: QWidget) -> None:
        super().__init__("export_dialog", "", parent)
        self.setWindowTitle(self.tr("Write robot programs"))
        self._proposed = proposed
        title = QLabel(self.tr("Write robot programs and report"), self)
        title.setProperty("title", "2")
        told = QLabel(self.tr("To this folder; it is made if there is none:"), self)
        self.folder = QLineEdit(str(proposed), self)
        self.folder.setObjectName("export_folder")
        self.folder.setAccessibleName(told.text())
        self.folder.setMinimumWidth(px(520))
        self.folder.textChanged.connect(lambda text: self.write_button.setEnabled(bool(text.strip())))
        other = QPushButton(self.tr("C&hoose…"), self)
        other.setObjectName("export_choose")
        other.setAccessibleName(self.tr("Choose another folder"))
        other.clicked.connect(self._choose)
        row = QHBoxLayout()
        row.addWidget(self.folder, 1)
        row.addWidget(other)
        self.body.addWidget(title)
        self.body.addWidget(told)
        self.body.addLayout(row)
        self.write_button = self.add_button(self.tr("&Write"), "write")
        self.write_button.setProperty("primary", True)
        self.write_button.clicked.connect(self._write)
        self.finish()
        self.write_button.setDefault(True)
        self.folder.setFocus()

    def _choose(self) -> None:
        ask_folder(self, self.tr("Folder for robot programs and report"), self._proposed.parent, self.folder.setText)

    def _write(self) -> None:
        self.chosen.emit(self.folder.text().strip())
        self.close()


class ExportedDialog(Beside):
    """What was written, and where."""

    def __init__(self, exported: Exported, parent: QWidget) -> None:
        super().__init__("exported_dialog", "", parent)
        self.setWindowTitle(self.tr("Exported"))
        folder = Path(exported.files[0]).parent if exported.files else Path()
        told = QLabel(self.tr("✔ {count} files were written to {folder}").format(count=len(exported.files),
                                                                                 folder=folder), self)  # fmt: skip
        told.setWordWrap(True)
        told.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.files = QListWidget(self)
        self.files.setObjectName("exported_files")
        self.files.setAccessibleName(self.tr("Files that were written"))
        self.files.addItems([Path(file).name for file in exported.files])
        self.body.addWidget(told)
        self.body.addWidget(self.files)
        show = self.add_button(self.tr("&Open the folder"), "open_folder")
        show.clicked.connect(lambda: QDesktopServices.openUrl(QUrl.fromLocalFile(str(folder))))
        self.resize(px(560), px(360))
        self.finish()


class FaultDialog(Beside):
    """A fault of the program, to be copied and sent to whoever maintains it."""

    def __init__(self, text: str, parent: QWidget) -> None:
        super().__init__("fault_dialog", "", parent)
        self.setWindowTitle(self.tr("A fault of the program"))
        told = QLabel(
            self.tr("This is not your mistake. What was taken is kept. Copy the text below and give it to whoever "
                    "looks after the program."), self
        )  # fmt: skip
        told.setWordWrap(True)
        self.text = QPlainTextEdit(text, self)
        self.text.setObjectName("fault_text")
        self.text.setAccessibleName(self.tr("Text of the fault"))
        self.text.setReadOnly(True)
        self.text.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        copy = self.add_button(self.tr("Co&py"), "copy")
        copy.clicked.connect(lambda: QGuiApplication.clipboard().setText(text))
        self.body.addWidget(told)
        self.body.addWidget(self.text)
        self.resize(px(720), px(420))
        self.finish()


class TextDialog(Beside):
    """A page of text."""

    def __init__(self, name: str, title: str, html: str, parent: QWidget) -> None:
        super().__init__(name, title, parent)
        label = QLabel(html, self)
        label.setObjectName(f"{name}_text")
        label.setTextFormat(Qt.TextFormat.RichText)
        label.setWordWrap(True)
        label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        label.setMinimumWidth(px(440))
        self.body.addWidget(label)
        self.finish()


def keyboard_dialog(parent: QWidget) -> TextDialog:
    """All shortcuts."""
    translate = QCoreApplication.translate
    rows = (
        ("Esc, F12", translate("Keyboard", "Stop every motion at once")),
        ("Ctrl+1 … Ctrl+6", translate("Keyboard", "Look at a step")),
        ("Ctrl+PgUp, Ctrl+PgDown", translate("Keyboard", "Step before, step after")),
        ("Tab, Shift+Tab", translate("Keyboard", "Next, previous control")),
        (
            translate("Keyboard", "Space"),
            translate("Keyboard", "Press a button, tick a sample; hold it on the motion button to keep moving"),
        ),
        ("Ctrl+Enter", translate("Keyboard", "The next thing to do (the large coloured button)")),
        ("Ctrl+Z, Ctrl+Shift+Z", translate("Keyboard", "Undo, redo an edit of the step's samples")),
        (translate("Keyboard", "Delete"), translate("Keyboard", "Delete the chosen sample")),
        ("Ctrl+N, Ctrl+O, Ctrl+Shift+O", translate("Keyboard", "New session, open, open read-only")),
        ("Ctrl+E", translate("Keyboard", "Export robot programs and report")),
        ("Ctrl++, Ctrl+-, Ctrl+0", translate("Keyboard", "Larger, smaller, usual text")),
        ("F11", translate("Keyboard", "3D view in a window of its own; there: the whole screen, Esc closes it")),
        ("F1", translate("Keyboard", "Help of the step")),
        (translate("Keyboard", "Alt + underlined letter"), translate("Keyboard", "Menu or button")),
    )
    lines = "".join(f"<tr><td style='padding: 3px 14px 3px 0'><b>{keys}</b></td><td>{what}</td></tr>"
                    for keys, what in rows)  # fmt: skip
    return TextDialog("keyboard_dialog", translate("Keyboard", "Keyboard"), f"<table>{lines}</table>", parent)


def about_dialog(parent: QWidget, engine: str) -> TextDialog:
    """Which version this is, and what it is not."""
    translate = QCoreApplication.translate
    paragraphs = (
        f"<b>beltcal {__version__}</b>",
        translate("About", "Commissions a robotic abrasive-belt grinding cell for turbine blades: six steps, each "
                  "checked on data that its fit has not seen."),
        translate("About", "Engine: {version}").format(version=engine or "–"),
        "<b>" + translate("About", "This program is not a safety function.") + "</b> "
        + translate("About", "It asks for motions and can ask for a stop. Whatever protects people is the cell's own: "
                    "guards, enabling switch, emergency stop."),
    )  # fmt: skip
    html = "".join(f"<p>{text}</p>" for text in paragraphs)
    return TextDialog("about_dialog", translate("About", "About beltcal"), html, parent)


def _number(value: float | None, unit: str, *, sign: bool = False) -> str:
    if value is None:
        return "–"
    return f"{value:+.4g} {unit}" if sign else f"{value:.4g} {unit}"
