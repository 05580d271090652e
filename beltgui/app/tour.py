"""The tour: a card that explains one part of the window after the other, with a frame around that part.

Nothing is blocked meanwhile. Frame and card are native windows, because the 3D view is one and would cover them.
"""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QMainWindow, QPushButton, QVBoxLayout, QWidget

from beltgui.app import settings
from beltgui.app.theme import colour, px

STEP_KEYS = {Qt.Key.Key_Right: +1, Qt.Key.Key_PageDown: +1, Qt.Key.Key_Left: -1, Qt.Key.Key_PageUp: -1}


@dataclass(frozen=True)
class Stop:
    """One stop: the object name of what is framed, and what is said."""

    widget: str
    title: str
    text: str


def seen() -> bool:
    """The tour has been seen, skipped or offered before."""
    return settings.text("tour_seen") == "yes"


def keep_seen() -> None:
    """It need not be offered again."""
    settings.keep("tour_seen", "yes")


class Tour(QObject):
    """Shows around in a window.

    Signals:
        ended: Seen to the end or skipped.
    """

    ended = Signal()

    def __init__(self, window: QMainWindow) -> None:
        super().__init__(window)
        self._window = window
        self._place = 0
        self._bars = [QWidget(window) for _ in range(4)]
        for bar in self._bars:
            bar.setAttribute(Qt.WidgetAttribute.WA_NativeWindow)
            bar.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
            bar.setObjectName("tour_frame")
            bar.setAutoFillBackground(True)
        self.card = Card(window)
        self.card.next_button.clicked.connect(lambda: self.go(+1))
        self.card.back_button.clicked.connect(lambda: self.go(-1))
        self.card.skip_button.clicked.connect(self.end)
        self.card.stepped.connect(self.go)
        self._stops = self._write()
        # What is framed moves when the window or its middle changes its size, e.g. as a message appears above it.
        self._watched = (window, window.centralWidget())
        for widget in self._watched:
            widget.installEventFilter(self)
        self._show()
        self.card.next_button.setFocus()

    @property
    def place(self) -> int:
        """Number of the stop, from 0."""
        return self._place

    @property
    def stops(self) -> tuple[Stop, ...]:
        """All stops."""
        return self._stops

    def go(self, by: int) -> None:
        """Next (+1) or back (-1); after the last one the tour ends."""
        if self._place + by >= len(self._stops):
            self.end()
            return
        self._place = max(0, self._place + by)
        self._show()

    def end(self) -> None:
        """End the tour; it is not offered again."""
        keep_seen()
        for widget in self._watched:
            widget.removeEventFilter(self)
        for widget in (*self._bars, self.card):
            widget.hide()
            widget.deleteLater()
        self.ended.emit()
        self.deleteLater()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802  (Qt's name)
        """Follow the window's size and language."""
        if event.type() in (QEvent.Type.Resize, QEvent.Type.Move):
            self._lay_out()
        elif event.type() == QEvent.Type.LanguageChange and watched is self._window:
            self._stops = self._write()
            self._show()
        return super().eventFilter(watched, event)

    def _show(self) -> None:
        stop = self._stops[self._place]
        last = self._place == len(self._stops) - 1
        self.card.write(stop.title, stop.text, f"{self._place + 1} / {len(self._stops)}", self._place == 0, last)
        self._lay_out()

    def _lay_out(self) -> None:
        area = self._window.rect()
        target = self._window.findChild(QWidget, self._stops[self._place].widget)
        if target is None or not target.isVisible():
            target = self._window.centralWidget()
        frame = QRect(target.mapTo(self._window, QPoint(0, 0)), target.size()).intersected(area)
        width = px(4)
        frame = frame.adjusted(-width, -width, width, width).intersected(area)
        sides = (
            QRect(frame.left(), frame.top(), frame.width(), width),
            QRect(frame.left(), frame.bottom() - width + 1, frame.width(), width),
            QRect(frame.left(), frame.top(), width, frame.height()),
            QRect(frame.right() - width + 1, frame.top(), width, frame.height()),
        )
        for bar, side in zip(self._bars, sides, strict=True):
            bar.setStyleSheet(f"background: {colour('accent')};")
            bar.setGeometry(side)
            bar.show()
            bar.raise_()
        self.card.setFixedWidth(px(340))
        self.card.adjustSize()
        self.card.move(_beside(frame, self.card.size().width(), self.card.size().height(), area))
        self.card.show()
        self.card.raise_()

    def _write(self) -> tuple[Stop, ...]:
        return (
            Stop("rail", self.tr("Six steps"),
                 self.tr("From top to bottom. Each says in a word and a sign how it stands. Click one, or press Ctrl+1 "
                         "to Ctrl+6, to look at it; looking changes nothing.")),
            Stop("right_panel", self.tr("What to do"),
                 self.tr("Here you read what to mount, what the result is and how good it is. Every number has its "
                         "unit and its uncertainty.")),
            Stop("primary_button", self.tr("The next thing to do"),
                 self.tr("There is one large coloured button. It takes the samples, then accepts the result. When in "
                         "doubt, this is the one to press.")),
            Stop("right_panel", self.tr("You decide about every motion"),
                 self.tr("Before the robot moves, its path is drawn and you are asked here: confirm it, or hold the "
                         "button down and the robot moves only as long as you hold.")),
            Stop("stop_button", self.tr("Stop"),
                 self.tr("Stops every motion at once, always: by this button, by Esc or by F12. In danger use the "
                         "cell's emergency stop; this program is not a safety function.")),
            Stop("scene_view", self.tr("The picture"),
                 self.tr("What was measured, on what is expected. Turn it with the left button, zoom with the wheel.")),
            Stop("samples_table", self.tr("The samples"),
                 self.tr("Each with its residual. Untick one and the step is solved again at once; nothing is lost, "
                         "undo brings it back.")),
            Stop("banner", self.tr("The verdict"),
                 self.tr("Accepted or rejected, why, and what to do about it. It rests on data that the fit has not "
                         "seen, never on small residuals alone.")),
            Stop("device_strip", self.tr("The devices"),
                 self.tr("Each device says how it is and since when. On the simulated cell nothing real moves.")),
            Stop("help_button", self.tr("Help"),
                 self.tr("F1 explains the step you look at: what to mount, what to watch, what a rejection means. This "
                         "tour is in the Help menu.")),
        )  # fmt: skip


class Card(QFrame):
    """What is said at a stop; arrow keys go on and back, as the buttons do.

    Signals:
        stepped: +1 or -1.
    """

    stepped = Signal(int)

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_NativeWindow)
        self.setObjectName("tour_card")
        self.setProperty("panel", True)
        self._title = QLabel(self)
        self._title.setProperty("title", 2)
        self._text = QLabel(self)
        self._text.setObjectName("tour_text")
        self._text.setWordWrap(True)
        self._count = QLabel(self)
        self._count.setProperty("tone", "muted")
        self.skip_button = QPushButton(self)
        self.skip_button.setObjectName("tour_skip")
        self.back_button = QPushButton(self)
        self.back_button.setObjectName("tour_back")
        self.next_button = QPushButton(self)
        self.next_button.setObjectName("tour_next")
        self.next_button.setDefault(True)
        row = QHBoxLayout()
        row.addWidget(self._count, 1)
        for button in (self.skip_button, self.back_button, self.next_button):
            button.setAutoDefault(True)
            button.installEventFilter(self)
            row.addWidget(button)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(px(14), px(12), px(14), px(12))
        layout.setSpacing(px(8))
        layout.addWidget(self._title)
        layout.addWidget(self._text)
        layout.addLayout(row)

    def write(self, title: str, text: str, count: str, first: bool, last: bool) -> None:
        """Show a stop."""
        self._title.setText(title)
        self._text.setText(text)
        self._count.setText(count)
        self.skip_button.setText(self.tr("Skip"))
        self.back_button.setText(self.tr("Back"))
        self.back_button.setDisabled(first)
        self.next_button.setText(self.tr("Done") if last else self.tr("Next"))
        self.setAccessibleName(title)
        self.setAccessibleDescription(text)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802  (Qt's name)
        """Right and left go on and back instead of moving the focus between the buttons."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress and event.key() in STEP_KEYS:
            self.stepped.emit(STEP_KEYS[event.key()])
            return True
        return super().eventFilter(watched, event)


def _beside(frame: QRect, width: int, height: int, area: QRect) -> QPoint:
    """Where a card goes so that it does not cover the frame, if there is room beside it; else in its middle."""
    gap = px(10)
    places = (
        QPoint(frame.right() + gap, frame.top()),
        QPoint(frame.left() - gap - width, frame.top()),
        QPoint(frame.left(), frame.bottom() + gap),
        QPoint(frame.left(), frame.top() - gap - height),
    )
    for place in places:
        x = min(max(place.x(), area.left() + gap), area.right() - gap - width)
        y = min(max(place.y(), area.top() + gap), area.bottom() - gap - height)
        if not QRect(x, y, width, height).intersects(frame):
            return QPoint(x, y)
    return QPoint(frame.center().x() - width // 2, frame.center().y() - height // 2)
