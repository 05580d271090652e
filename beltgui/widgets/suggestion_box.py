"""The next best pose or touch, and what it would improve."""

from __future__ import annotations

from PySide6.QtWidgets import QFrame, QLabel, QVBoxLayout, QWidget

from beltgui.app.language import sentence
from beltgui.viewmodel.step import Suggestion


class SuggestionBox(QFrame):
    """Shown only when there is something to gain."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("suggestion")
        self.setProperty("banner", "info")
        self._suggestion: Suggestion | None = None
        self._title, self._text, self._gain = (QLabel(self) for _ in range(3))
        self._title.setProperty("tone", "accent")
        self._gain.setProperty("tone", "muted")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 4, 4, 4)
        layout.setSpacing(2)
        for label in (self._title, self._text, self._gain):
            label.setWordWrap(True)
            layout.addWidget(label)
        self.retranslate()

    def show_suggestion(self, suggestion: Suggestion | None) -> None:
        """Show it, or nothing."""
        self._suggestion = suggestion
        self.setVisible(suggestion is not None)
        if suggestion is None:
            return
        self._text.setText(sentence(suggestion.text))
        self._gain.setText(self.tr("Would improve: {what}").format(what=sentence(suggestion.improves)))
        self._gain.setVisible(bool(suggestion.improves))
        self.setAccessibleName(self.text())

    def retranslate(self) -> None:
        """Write again in the present language."""
        self._title.setText(self.tr("➜ Suggested next"))
        self.show_suggestion(self._suggestion)

    def text(self) -> str:
        """All it says."""
        return " ".join(label.text() for label in (self._title, self._text, self._gain) if not label.isHidden())
