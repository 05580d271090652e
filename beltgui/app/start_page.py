"""The first thing a person sees: who works on which blade, and where the session is kept."""

from __future__ import annotations

import getpass
import re
import tomllib
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QEvent, QStandardPaths, Qt, Signal
from PySide6.QtGui import QPixmap, QShowEvent
from PySide6.QtWidgets import (
    QButtonGroup,
    QFormLayout,
    QFrame,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QScrollArea,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from beltgui.app import settings
from beltgui.app.choose import ask_folder
from beltgui.app.language import sentence
from beltgui.app.notice import Notice
from beltgui.app.theme import px, theme
from beltgui.steps.state import STEPS
from beltgui.widgets.words import step_word
from resources import blade_type_names, blade_type_path


@dataclass(frozen=True)
class BladeChoice:
    """What the start page needs of a blade type."""

    name: str
    description: str
    serial_pattern: str
    picture: Path


@dataclass(frozen=True)
class Begin:
    """What the person has entered."""

    person: str
    blade_type: str
    serial: str
    folder: str


def blade_choices() -> tuple[BladeChoice, ...]:
    """The blade types that come with the program."""
    found = []
    for name in blade_type_names():
        path = blade_type_path(name)
        blade = tomllib.loads(path.read_text(encoding="utf-8"))["blade"]
        found.append(BladeChoice(name, blade["description"], blade["serial_pattern"], path.with_suffix(".png")))
    return tuple(found)


class StartPage(QScrollArea):
    """Asks for what a session needs, or opens an earlier one.

    Signals:
        begin: (`Begin`) Begin a session.
        begin_with_tour: (`Begin`) The same, and show around.
        open_wanted: A session is to be chosen.
        recent_wanted: This session is to be opened.
        back_wanted: Back to the session that is open.
    """

    begin = Signal(object)
    begin_with_tour = Signal(object)
    open_wanted = Signal()
    recent_wanted = Signal(str)
    back_wanted = Signal()

    def __init__(self, person: str = "", parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("start_page")
        self.setWidgetResizable(True)
        self._choices = blade_choices()
        self._folder_is_ours = True
        self._busy = False
        self._serials = {choice.name: "" for choice in self._choices}
        self._build(person or settings.text("person") or getpass.getuser())
        self.refresh()
        theme().changed.connect(self._dress)
        self._dress()
        self._write()

    # ---- content

    def entered(self) -> Begin:
        """What is in the fields."""
        return Begin(self.person.text().strip(), self.blade_type().name.lower(), self.serial.text().strip(),
                     self.folder.text().strip())  # fmt: skip

    def blade_type(self) -> BladeChoice:
        """The chosen blade type."""
        return self._choices[max(self._blades.checkedId(), 0)]

    def missing(self) -> str:
        """What is still missing, as a sentence; empty if nothing is."""
        if not self.person.text().strip():
            return self.tr("Enter your name: it is kept with every decision.")
        pattern = self.blade_type().serial_pattern
        if not re.fullmatch(pattern, self.serial.text().strip()):
            example = pattern.replace("[0-9]{4}", "0001")
            return self.tr(
                "The serial number does not belong to this blade type; expected for instance {example}."
            ).format(example=example)
        if not self.folder.text().strip():
            return self.tr("Choose a folder for the session.")
        if (Path(self.folder.text().strip()) / "session.db").exists():
            return self.tr("This folder holds a session already. Open that one, or choose another folder.")
        return ""

    def set_busy(self, busy: bool) -> None:
        """A session is being opened: nothing can be entered meanwhile."""
        self._busy = busy
        self._body.setEnabled(not busy)
        self._check()

    def refuse(self, text: str) -> None:
        """Say why the session could not be opened."""
        self.set_busy(False)
        self.notice.say("bad", sentence(text))
        self.ensureWidgetVisible(self.notice)

    def refresh(self, *, session_open: bool = False) -> None:
        """Show the recent sessions and propose a new folder."""
        self.set_busy(False)
        self.back_button.setVisible(session_open)
        self.notice.hide()
        while (item := self._recent.takeAt(0)) is not None:
            item.widget().deleteLater()
        folders = [folder for folder in settings.recent_sessions() if (Path(folder) / "session.db").exists()]
        for number, folder in enumerate(folders[:4]):
            button = QPushButton(Path(folder).name, self._body)
            button.setObjectName(f"recent_{number}")
            button.setToolTip(folder)
            button.setProperty("quiet", True)
            button.setStyleSheet("text-align: left;")
            button.clicked.connect(lambda _=False, of=folder: self.recent_wanted.emit(of))
            self._recent.addWidget(button)
        self._recent_title.setVisible(bool(folders))
        self._folder_is_ours = True
        self._propose_folder()

    def showEvent(self, event: QShowEvent) -> None:  # noqa: N802  (Qt's name)
        """The keyboard begins at the name."""
        super().showEvent(event)
        self.person.setFocus()

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802  (Qt's name)
        """Follow the language."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._write()

    # ---- building

    def _build(self, person: str) -> None:
        outer = QWidget(self)
        centre = QHBoxLayout(outer)
        centre.addStretch(1)
        self._body = QWidget(outer)
        centre.addWidget(self._body, 10)
        centre.addStretch(1)
        self.setWidget(outer)

        self._title = QLabel(self._body)
        self._title.setProperty("title", 1)
        self._purpose = QLabel(self._body)
        self._purpose.setWordWrap(True)
        self.notice = Notice("start_notice", self._body)
        self._columns = QHBoxLayout()
        self._columns.addWidget(self._form(person), 3)
        self._columns.addWidget(self._side(), 2)
        self._not_safety = QLabel(self._body)
        self._not_safety.setWordWrap(True)
        self._not_safety.setProperty("tone", "muted")
        self._layout = QVBoxLayout(self._body)
        for widget in (self._title, self._purpose, self.notice):
            self._layout.addWidget(widget)
        self._layout.addLayout(self._columns)
        self._layout.addWidget(self._not_safety)
        self._layout.addStretch(1)
        self._wire()

    def _form(self, person: str) -> QWidget:
        panel = QFrame(self._body)
        panel.setProperty("panel", True)
        self._person_label, self._blade_label, self._serial_label, self._folder_label = (
            QLabel(panel) for _ in range(4)
        )
        self.person = QLineEdit(person, panel)
        self.person.setObjectName("person")
        self.serial = QLineEdit(panel)
        self.serial.setObjectName("serial")
        self.folder = QLineEdit(panel)
        self.folder.setObjectName("folder")
        self.folder_button = QPushButton(panel)
        self.folder_button.setObjectName("choose_folder")
        self.folder_button.clicked.connect(self._choose_folder)
        self._missing = QLabel(panel)
        self._missing.setObjectName("missing")
        self._missing.setWordWrap(True)
        self._missing.setProperty("tone", "warn")
        self.begin_button = QPushButton(panel)
        self.begin_button.setObjectName("begin")
        self.begin_button.setProperty("primary", True)
        self.begin_button.setDefault(True)
        self.begin_button.clicked.connect(lambda: self._go(self.begin))
        self._form_layout = QFormLayout(panel)
        self._form_layout.setLabelAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self._form_layout.addRow(self._person_label, self.person)
        self._form_layout.addRow(self._blade_label, self._blade_cards(panel))
        self._form_layout.addRow(self._serial_label, self.serial)
        where = QHBoxLayout()
        where.addWidget(self.folder, 1)
        where.addWidget(self.folder_button)
        self._form_layout.addRow(self._folder_label, where)
        self._form_layout.addRow("", self._missing)
        self._form_layout.addRow("", self.begin_button)
        for label, field in ((self._person_label, self.person), (self._serial_label, self.serial),
                             (self._folder_label, self.folder)):  # fmt: skip
            label.setBuddy(field)
        return panel

    def _wire(self) -> None:
        for field in (self.person, self.serial, self.folder):
            field.textChanged.connect(self._check)
            field.returnPressed.connect(lambda: self._go(self.begin))
        self.serial.textEdited.connect(self._serial_edited)
        self.folder.textEdited.connect(self._folder_edited)
        self._blades.idToggled.connect(self._blade_chosen)
        self._blades.button(0).setChecked(True)

    def _blade_cards(self, parent: QWidget) -> QWidget:
        holder = QWidget(parent)
        row = QHBoxLayout(holder)
        row.setContentsMargins(0, 0, 0, 0)
        self._blades = QButtonGroup(holder)
        for number, choice in enumerate(self._choices):
            card = QToolButton(holder)
            card.setObjectName(f"blade_{choice.name.lower()}")
            card.setText(choice.name)
            card.setCheckable(True)
            card.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextUnderIcon)
            if choice.picture.exists():
                card.setIcon(QPixmap(str(choice.picture)))
            self._blades.addButton(card, number)
            row.addWidget(card)
        self._description = QLabel(holder)
        self._description.setObjectName("blade_description")
        self._description.setWordWrap(True)
        self._description.setProperty("tone", "muted")
        row.addWidget(self._description, 1)
        return holder

    def _side(self) -> QWidget:
        panel = QFrame(self._body)
        panel.setProperty("panel", True)
        self._steps_title = QLabel(panel)
        self._steps_title.setProperty("title", 2)
        self._steps = QLabel(panel)
        self._steps.setWordWrap(True)
        self.tour_button = QPushButton(panel)
        self.tour_button.setObjectName("take_tour")
        self.tour_button.clicked.connect(lambda: self._go(self.begin_with_tour))
        self.open_button = QPushButton(panel)
        self.open_button.setObjectName("open_session")
        self.open_button.clicked.connect(self.open_wanted)
        self.back_button = QPushButton(panel)
        self.back_button.setObjectName("back_to_session")
        self.back_button.clicked.connect(self.back_wanted)
        self._recent_title = QLabel(panel)
        self._recent_title.setProperty("title", 2)
        self._recent = QVBoxLayout()
        self._side_layout = QVBoxLayout(panel)
        for widget in (self._steps_title, self._steps, self.tour_button, self.open_button, self.back_button,
                       self._recent_title):  # fmt: skip
            self._side_layout.addWidget(widget)
        self._side_layout.addLayout(self._recent)
        self._side_layout.addStretch(1)
        return panel

    # ---- words and sizes

    def _write(self) -> None:
        self._title.setText(self.tr("Commission a belt grinding cell"))
        self._purpose.setText(
            self.tr("Six steps bring the cell up so that it grinds a turbine blade where the CAD model says. Each step "
                    "is measured, solved, checked on data it has not seen, and accepted by you.")
        )  # fmt: skip
        self._person_label.setText(self.tr("Your &name"))
        self._blade_label.setText(self.tr("Blade type"))
        self._serial_label.setText(self.tr("Serial n&umber"))
        self._folder_label.setText(self.tr("&Folder"))
        self.folder_button.setText(self.tr("Choose…"))
        self.folder_button.setAccessibleName(self.tr("Choose the session's folder"))
        self.begin_button.setText(self.tr("&Begin on the simulated cell"))
        self.tour_button.setText(self.tr("Begin and take the &tour (2 minutes)"))
        self.open_button.setText(self.tr("&Open a session…"))
        self.back_button.setText(self.tr("Bac&k to the open session"))
        self._recent_title.setText(self.tr("Recent sessions"))
        self._steps_title.setText(self.tr("The six steps"))
        lines = [f"{number}  <b>{step_word(step)}</b> – {text}" for number, (step, text) in
                 enumerate(zip(STEPS, self._what_for(), strict=True), start=1)]  # fmt: skip
        self._steps.setText("<br>".join(lines))
        self._not_safety.setText(
            self.tr("The simulated cell is computed: no real device moves. Everything is kept on disk as it is taken; "
                    "you may close the window or lose power at any time. This program is not a safety function.")
        )  # fmt: skip
        for field, label in ((self.person, self._person_label), (self.serial, self._serial_label),
                             (self.folder, self._folder_label)):  # fmt: skip
            field.setAccessibleName(label.text().replace("&", ""))
        self._check()
        self._describe()

    def _what_for(self) -> tuple[str, ...]:
        return (
            self.tr("where the scanner sits on its stage"),
            self.tr("where the scanner's stage stands to the robot"),
            self.tr("where the blade is clamped, roughly"),
            self.tr("where the blade is, exactly"),
            self.tr("where the contact wheels are"),
            self.tr("what is left, by touching, and the corrected programs"),
        )

    def _dress(self) -> None:
        self._body.setMaximumWidth(px(1120))
        self._layout.setSpacing(px(10))
        self._layout.setContentsMargins(px(16), px(14), px(16), px(10))
        self._columns.setSpacing(px(14))
        for layout in (self._form_layout, self._side_layout):
            layout.setContentsMargins(px(16), px(14), px(16), px(14))
            layout.setSpacing(px(10))
        for button in self._blades.buttons():
            button.setIconSize(button.iconSize().scaled(px(132), px(96), Qt.AspectRatioMode.IgnoreAspectRatio))

    # ---- what the person does

    def _check(self) -> None:
        text = self.tr("Opening…") if self._busy else self.missing()
        self._missing.setText(text)
        self._missing.setVisible(bool(text))
        for button in (self.begin_button, self.tour_button):
            button.setEnabled(not text)

    def _serial_edited(self, text: str) -> None:
        self._serials[self.blade_type().name] = text
        self._propose_folder()

    def _folder_edited(self) -> None:
        self._folder_is_ours = False

    def _blade_chosen(self, _: int, on: bool) -> None:
        if on:
            choice = self.blade_type()
            kept = self._serials[choice.name] or choice.serial_pattern.replace("[0-9]{4}", "0001")
            self.serial.setText(kept)
            self._propose_folder()
            self._describe()

    def _describe(self) -> None:
        self._description.setText(sentence(self.blade_type().description))
        for button, choice in zip(self._blades.buttons(), self._choices, strict=True):
            button.setAccessibleName(self.tr("Blade type {name}").format(name=choice.name))

    def _propose_folder(self) -> None:
        if self._folder_is_ours:
            documents = QStandardPaths.writableLocation(QStandardPaths.StandardLocation.DocumentsLocation)
            name = f"{datetime.now():%Y-%m-%d_%H%M%S}_{self.serial.text().strip() or 'blade'}"
            self.folder.setText(str(Path(documents) / "beltcal" / name))

    def _choose_folder(self) -> None:
        ask_folder(self, self.tr("Folder for the session"), Path(self.folder.text()).parent, self._take_folder)

    def _take_folder(self, folder: str) -> None:
        self._folder_is_ours = False
        self.folder.setText(folder)

    def _go(self, signal: object) -> None:
        if not self._busy and not self.missing():
            entered = self.entered()
            settings.keep("person", entered.person)
            signal.emit(entered)
