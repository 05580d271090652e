"""How far the work is."""

from __future__ import annotations

from PySide6.QtWidgets import QLabel, QProgressBar, QSizePolicy, QVBoxLayout, QWidget

from beltgui.app.language import sentence
from beltgui.engine.messages import JobProgress, JobStarted


class ProgressLine(QWidget):
    """Visible while work is under way; the window's top bar has the button that ends it."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("step_progress")
        self._job: JobStarted | None = None
        self._progress: JobProgress | None = None
        self.text_label = QLabel(self)
        self.text_label.setWordWrap(True)
        self.bar = QProgressBar(self)
        self.bar.setRange(0, 1000)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(2)
        layout.addWidget(self.text_label)
        layout.addWidget(self.bar)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)
        self.setVisible(False)
        self.retranslate()

    def show_job(self, job: JobStarted | None, progress: JobProgress | None = None) -> None:
        """Work has begun, goes on, or (None) has ended."""
        self._job, self._progress = job, progress
        self.setVisible(job is not None)
        if job is None:
            return
        title, text = sentence(job.title), sentence(progress.text) if progress is not None else ""
        self.text_label.setText(f"{title}: {text}" if text and text != title else title)
        fraction = 0.0 if progress is None else progress.fraction
        self.bar.setValue(round(1000.0 * min(max(fraction, 0.0), 1.0)))

    def retranslate(self) -> None:
        """Write again in the present language."""
        self.bar.setAccessibleName(self.tr("Progress"))
        self.show_job(self._job, self._progress)
