"""The verdict: shape, word and colour, the reasons and what to do."""

from __future__ import annotations

from enum import StrEnum

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QGuiApplication, QResizeEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QScrollArea, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from beltgui.app.theme import px, theme


class BannerKind(StrEnum):
    """What is said."""

    ACCEPTED = "accepted"
    OK = "ok"
    REJECTED = "rejected"
    PROVISIONAL = "provisional"
    MISSING = "missing"
    STALE = "stale"
    BLOCKED = "blocked"
    FAILED = "failed"
    INFO = "info"


_SHAPES = {
    BannerKind.ACCEPTED: "✔",
    BannerKind.OK: "✔",
    BannerKind.REJECTED: "✖",
    BannerKind.PROVISIONAL: "◐",
    BannerKind.MISSING: "○",
    BannerKind.STALE: "◆",
    BannerKind.BLOCKED: "■",
    BannerKind.FAILED: "✖",
    BannerKind.INFO: "●",
}
_LOOKS = {
    BannerKind.ACCEPTED: "good",
    BannerKind.OK: "good",
    BannerKind.REJECTED: "bad",
    BannerKind.STALE: "warn",
    BannerKind.BLOCKED: "warn",
    BannerKind.FAILED: "bad",
}


def kind_word(kind: BannerKind) -> str:
    """The word of a verdict."""
    translate = QCoreApplication.translate
    return {
        BannerKind.ACCEPTED: translate("Banner", "Accepted"),
        BannerKind.OK: translate("Banner", "Good — can be accepted"),
        BannerKind.REJECTED: translate("Banner", "Rejected"),
        BannerKind.PROVISIONAL: translate("Banner", "Provisional"),
        BannerKind.MISSING: translate("Banner", "No result yet"),
        BannerKind.STALE: translate("Banner", "Stale"),
        BannerKind.BLOCKED: translate("Banner", "Cannot begin yet"),
        BannerKind.FAILED: translate("Banner", "Failed"),
        BannerKind.INFO: "",
    }[kind]


class Banner(QFrame):
    """A coloured frame with a word, a headline and reasons; long ones scroll; all of it can be copied."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("banner")
        self._kind: BannerKind | None = None
        self._headline = ""
        self._lines: tuple[str, ...] = ()
        self._build()
        self.setVisible(False)
        theme().changed.connect(self._fit)

    @property
    def kind(self) -> BannerKind | None:
        """What is said now; None for nothing."""
        return self._kind

    def say(self, kind: BannerKind | None, headline: str = "", lines: tuple[str, ...] = ()) -> None:
        """Show a verdict.

        Args:
            kind: Gives shape, word and colour; None hides the banner.
            headline: One line, in the language of the screen.
            lines: Reasons and what to do, one each.
        """
        if (kind, headline, lines) == (self._kind, self._headline, self._lines):
            return
        self._kind, self._headline, self._lines = kind, headline, lines
        self.setVisible(kind is not None)
        if kind is None:
            return
        look = _LOOKS.get(kind, "info")
        if self.property("banner") != look:
            self.setProperty("banner", look)
            self.style().polish(self)
        self.word.setText(f"{_SHAPES[kind]}  {kind_word(kind)}")
        self.body.setText("\n".join(part for part in (headline, *lines) if part))
        self.setAccessibleName(self.text())
        self._fit()
        self._scroll.verticalScrollBar().setValue(0)

    def text(self) -> str:
        """All it says."""
        if self._kind is None:
            return ""
        return "\n".join(part for part in (kind_word(self._kind), self._headline, *self._lines) if part)

    def retranslate(self) -> None:
        """Write again in the present language; the page says anew what it said."""
        self.copy_button.setText(self.tr("Copy"))
        self.copy_button.setToolTip(self.tr("Copy this text"))
        self.copy_button.setAccessibleName(self.tr("Copy the verdict"))
        kind, headline, lines = self._kind, self._headline, self._lines
        self._kind = None
        self.say(kind, headline, lines)

    def _build(self) -> None:
        self.word = QLabel(self)
        self.word.setProperty("title", "2")
        self.word.setWordWrap(True)
        self.copy_button = QToolButton(self)
        self.copy_button.setObjectName("banner_copy")
        self.copy_button.setProperty("quiet", "true")
        self.copy_button.clicked.connect(self._copy)
        self.body = QLabel(self)
        self.body.setTextFormat(Qt.TextFormat.PlainText)
        self.body.setWordWrap(True)
        self.body.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.body.setTextInteractionFlags(
            Qt.TextInteractionFlag.TextSelectableByMouse | Qt.TextInteractionFlag.TextSelectableByKeyboard
        )
        self._scroll = QScrollArea(self)
        self._scroll.setWidgetResizable(True)
        self._scroll.setFrameShape(QFrame.Shape.NoFrame)
        self._scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._scroll.setMinimumHeight(0)
        self._scroll.setWidget(self.body)
        self._scroll.viewport().setAutoFillBackground(False)
        self.body.setAutoFillBackground(False)
        head = QHBoxLayout()
        head.addWidget(self.word, 1)
        head.addWidget(self.copy_button, 0, Qt.AlignmentFlag.AlignTop)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 4, 4, 4)
        layout.setSpacing(2)
        layout.addLayout(head)
        layout.addWidget(self._scroll, 1)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        self.retranslate()

    def _copy(self) -> None:
        QGuiApplication.clipboard().setText(self.text())

    def _fit(self) -> None:
        height = self._height()
        if height != self.height():
            self.setFixedHeight(height)

    def _text_width(self) -> int:
        return max(self.width() - px(34), px(120))

    def _height(self) -> int:
        self.ensurePolished()
        head = max(self.word.heightForWidth(max(self._text_width() - self.copy_button.sizeHint().width(), 60)),
                   self.copy_button.sizeHint().height())  # fmt: skip
        body = self.body.heightForWidth(self._text_width()) if self.body.text() else 0
        return min(head + body + px(26), px(210))

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802
        """Other line breaks at another width."""
        super().resizeEvent(event)
        self._fit()
