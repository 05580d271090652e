"""The bar at the top: which session and blade, who works, what runs, Cancel, and the large Stop."""

from __future__ import annotations

from PySide6.QtCore import QEvent, Signal
from PySide6.QtWidgets import QHBoxLayout, QProgressBar, QPushButton, QVBoxLayout, QWidget

from beltgui.app.elided import ElidedLabel
from beltgui.app.language import sentence
from beltgui.app.theme import px, theme
from beltgui.engine.messages import JobProgress, JobStarted, SessionOpened


class TopBar(QWidget):
    """Always there; its Stop button is always enabled.

    Signals:
        stop: Stop everything at once.
        cancel: End the work at its next report.
        help: Show or hide the help.
    """

    stop = Signal()
    cancel = Signal()
    help = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("top_bar")
        self._session: SessionOpened | None = None
        self._job: JobStarted | None = None
        self._progress: JobProgress | None = None
        self._cancelled: int | None = None
        self.name = ElidedLabel(1, self)
        self.name.setObjectName("session_name")
        self.name.setProperty("title", 2)
        self.blade = ElidedLabel(1, self)
        self.blade.setObjectName("session_blade")
        self.blade.setProperty("tone", "muted")
        self.job_title = ElidedLabel(1, self)
        self.job_title.setObjectName("job_title")
        self.job_bar = QProgressBar(self)
        self.job_bar.setObjectName("job_progress")
        self.job_bar.setRange(0, 1000)
        self.job_cancel = QPushButton(self)
        self.job_cancel.setObjectName("job_cancel")
        self.job_cancel.clicked.connect(self._cancel)
        self.help_button = QPushButton("?", self)
        self.help_button.setObjectName("help_button")
        self.help_button.clicked.connect(self.help)
        self.stop_button = QPushButton(self)
        self.stop_button.setObjectName("stop_button")
        self.stop_button.setProperty("stop", True)
        # Stop acts when it is pressed, not when it is let go.
        self.stop_button.pressed.connect(self.stop)

        words = QVBoxLayout()
        words.setSpacing(0)
        words.addWidget(self.name)
        words.addWidget(self.blade)
        work = QVBoxLayout()
        work.setSpacing(2)
        work.addWidget(self.job_title)
        work.addWidget(self.job_bar)
        self._layout = QHBoxLayout(self)
        self._layout.addLayout(words, 3)
        self._layout.addLayout(work, 4)
        self._layout.addWidget(self.job_cancel)
        self._layout.addWidget(self.help_button)
        self._layout.addWidget(self.stop_button)
        theme().changed.connect(self._dress)
        self._dress()
        self.write()

    def show_session(self, session: SessionOpened | None) -> None:
        """Show which session is open."""
        self._session = session
        self.write()

    def show_job(self, job: JobStarted | None, progress: JobProgress | None) -> None:
        """Show what runs and how far it is."""
        self._job, self._progress = job, progress
        self.write()

    def write(self) -> None:
        """Write in the present language."""
        session, job, progress = self._session, self._job, self._progress
        info = {} if session is None else session.info
        self.name.setText(self.tr("No session is open") if session is None else session.folder.rstrip("/\\")
                          .replace("\\", "/").rsplit("/", 1)[-1])  # fmt: skip
        if session is not None:
            self.name.setToolTip(session.folder)
        words = [] if session is None else [
            str(info.get("blade_type", "")).upper(), str(info.get("serial", "")), session.person
        ]  # fmt: skip
        self.blade.setText("  ·  ".join(filter(None, words)))
        self.blade.setVisible(session is not None)
        running = job is not None
        self.job_title.setVisible(running)
        self.job_bar.setVisible(running)
        self.job_cancel.setVisible(running)
        if job is not None:
            text = sentence(progress.text) if progress is not None and progress.text else ""
            self.job_title.setText(" – ".join(filter(None, (sentence(job.title), text))))
            self.job_bar.setValue(0 if progress is None else round(1000 * progress.fraction))
        ending = job is not None and job.job == self._cancelled
        self.job_cancel.setEnabled(not ending)
        self.job_cancel.setText(self.tr("Cancelling…") if ending else self.tr("Cancel"))
        self.job_cancel.setToolTip(self.tr("Ends the work at the next sample. What has been taken is kept."))
        self.job_cancel.setAccessibleName(self.tr("Cancel the work"))
        self.job_bar.setAccessibleName(self.tr("Progress of the work"))
        self.help_button.setToolTip(self.tr("Help of this step (F1)"))
        self.help_button.setAccessibleName(self.tr("Help of this step"))
        self.stop_button.setText(self.tr("STOP"))
        self.stop_button.setToolTip(self.tr("Stops every motion at once (Esc or F12). Not a safety function: "
                                            "use the emergency stop in danger."))  # fmt: skip
        self.stop_button.setAccessibleName(self.tr("Stop every motion at once"))

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802  (Qt's name)
        """Follow the language."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self.write()

    def _cancel(self) -> None:
        if self._job is not None:
            self._cancelled = self._job.job
            self.write()
            self.cancel.emit()

    def _dress(self) -> None:
        self._layout.setContentsMargins(px(10), px(6), px(10), px(6))
        self._layout.setSpacing(px(10))
