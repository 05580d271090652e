"""The verdict: shape, word and colour, the reasons and what to do; remarks for experts on demand."""

from __future__ import annotations

from enum import StrEnum

from PySide6.QtCore import QCoreApplication, QSize, Qt
from PySide6.QtGui import QGuiApplication, QResizeEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QScrollArea, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from beltgui.app.theme import px, theme

# More text than fits in this height, px, scrolls; in a low window it may get as low as the smaller one.
HIGHEST_PX, LOWEST_PX = 210, 84


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
        self._more: tuple[str, ...] = ()
        self._build()
        self.setVisible(False)
        theme().changed.connect(self.updateGeometry)

    @property
    def kind(self) -> BannerKind | None:
        """What is said now; None for nothing."""
        return self._kind

    def say(
        self,
        kind: BannerKind | None,
        headline: str = "",
        lines: tuple[str, ...] = (),
        more: tuple[str, ...] = (),
    ) -> None:
        """Show a verdict.

        Args:
            kind: Gives shape, word and colour; None hides the banner.
            headline: One line, in the language of the screen.
            lines: Reasons and what to do, one each.
            more: Worth knowing for who wants to, one each; shown on demand.
        """
        if (kind, headline, lines, more) == (self._kind, self._headline, self._lines, self._more):
            return
        if kind is None or more != self._more:
            self.more_button.setChecked(False)
        self._kind, self._headline, self._lines, self._more = kind, headline, lines, more
        self.setVisible(kind is not None)
        if kind is None:
            return
        look = _LOOKS.get(kind, "info")
        if self.property("banner") != look:
            self.setProperty("banner", look)
            self.style().polish(self)
        self.word.setText(f"{_SHAPES[kind]}  {kind_word(kind)}")
        self.setAccessibleName(self.text())
        self._write_body()

    def text(self) -> str:
        """All it says."""
        if self._kind is None:
            return ""
        parts = (kind_word(self._kind), self._headline, *self._lines, *self._more)
        return "\n".join(part for part in parts if part)

    def retranslate(self) -> None:
        """Write again in the present language; the page says anew what it said."""
        self.copy_button.setText(self.tr("Copy"))
        self.copy_button.setToolTip(self.tr("Copy this text"))
        self.copy_button.setAccessibleName(self.tr("Copy the verdict"))
        kind, headline, lines, more = self._kind, self._headline, self._lines, self._more
        self._kind = None
        self.say(kind, headline, lines, more)

    def _build(self) -> None:
        self.word = QLabel(self)
        self.word.setProperty("title", "2")
        self.word.setWordWrap(True)
        # All looks have the same borders, and a frame notes them when it gets its first look.
        self.setProperty("banner", "info")
        self.more_button, self.copy_button = QToolButton(self), QToolButton(self)
        self.more_button.setObjectName("banner_more")
        self.copy_button.setObjectName("banner_copy")
        for button in (self.more_button, self.copy_button):
            button.setProperty("link", "true")
        self.more_button.setCheckable(True)
        self.more_button.toggled.connect(self._write_body)
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
        links = QHBoxLayout()
        links.setSpacing(12)
        links.addWidget(self.more_button)
        links.addStretch(1)
        links.addWidget(self.copy_button)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(4, 0, 0, 0)
        layout.setSpacing(2)
        layout.addWidget(self.word)
        layout.addWidget(self._scroll, 1)
        layout.addLayout(links)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)
        self.retranslate()

    def _copy(self) -> None:
        QGuiApplication.clipboard().setText(self.text())

    def _write_body(self) -> None:
        shown = self.more_button.isChecked()
        self.more_button.setVisible(bool(self._more))
        self.more_button.setText(self.tr("Less ▴") if shown else self.tr("More ▾"))
        self.more_button.setAccessibleName(self.tr("Less of the verdict") if shown else self.tr("More of the verdict"))
        parts = (self._headline, *self._lines, *(self._more if shown else ()))
        self.body.setText("\n".join(part for part in parts if part))
        self._scroll.setVisible(bool(self.body.text()))
        self._scroll.verticalScrollBar().setValue(0)
        self.updateGeometry()

    def hasHeightForWidth(self) -> bool:  # noqa: N802
        """The layout's own rule would count the scroll area's wish; see `sizeHint`."""
        return False

    def sizeHint(self) -> QSize:  # noqa: N802
        """As high as its text at the present width, within limits."""
        return QSize(px(200), self._height())

    def minimumSizeHint(self) -> QSize:  # noqa: N802
        """The word and two lines; the rest scrolls."""
        return QSize(px(120), min(self._height(), px(LOWEST_PX)))

    def _height(self) -> int:
        self.ensurePolished()
        outer, inner = self.contentsMargins(), self.layout().contentsMargins()
        aside = outer.left() + outer.right() + inner.left() + inner.right()
        above = outer.top() + outer.bottom() + inner.top() + inner.bottom()
        width = max(self.width() - aside, px(120))
        spacing = self.layout().spacing()
        body = self.body.heightForWidth(width) + spacing if self.body.text() else 0
        whole = above + self.word.heightForWidth(width) + body + spacing + self.copy_button.sizeHint().height()
        return min(whole + px(4), px(HIGHEST_PX))

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802
        """Other line breaks at another width."""
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self.updateGeometry()
