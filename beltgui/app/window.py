"""The main window: rail of steps, 3D view, one primary button, verdict banner, strip of devices."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

from PySide6.QtCore import QUrl
from PySide6.QtGui import QCloseEvent, QDesktopServices, QShowEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QMainWindow, QProgressBar, QPushButton, QVBoxLayout, QWidget

from beltgui.app.rail import StepRail
from beltgui.app.view3d import make_view
from beltgui.app.worker import Work, Worker
from beltgui.demo import DemoResult, run_demo
from beltgui.jobs import Job
from beltgui.steps.state import StepEvent
from resources import blade_type_path

BANNER_STYLE = "padding: 10px; border-radius: 4px; font-size: 15px; color: white; background: {};"
DEVICES = ("scanner", "stage", "robot", "grinder rough", "grinder fine")


class MainWindow(QMainWindow):
    """Commissions the simulated cell and shows how each step ends.

    Args:
        config: Cell file; None takes the simulated cell's own.
        blade_type: Which of the blade types to show and to commission with.
        out_dir: Where the session and the report go; None makes a new folder for each run.
        resolution: Of the simulated scanner.
        grid: Probing points in u and v; None takes the blade type's own.
    """

    def __init__(
        self,
        *,
        config: Path | None = None,
        blade_type: str = "dr95",
        out_dir: Path | None = None,
        resolution: int | str = "demo",
        grid: tuple[int, int] | None = None,
    ) -> None:
        super().__init__()
        self._resolution = resolution
        self._grid = grid
        self._config = config
        self._blade_type = blade_type
        self._out_dir = out_dir
        self._workers: list[Worker] = []
        self._report: Path | None = None
        self._closed = False
        self.setWindowTitle("beltcal — simulated cell")
        self.resize(1280, 800)
        self._build()

    def _build(self) -> None:
        self.rail = StepRail(self)
        self.view = make_view(self)
        self.banner = QLabel(self)
        self.banner.setWordWrap(True)
        self.start_button = QPushButton("Commission the simulated cell", self)
        self.start_button.setMinimumHeight(48)
        self.start_button.clicked.connect(self.start)
        self.cancel_button = QPushButton("Cancel", self)
        self.cancel_button.setMinimumHeight(48)
        self.cancel_button.clicked.connect(self.cancel)
        self.report_button = QPushButton("Open the report", self)
        self.report_button.setMinimumHeight(48)
        self.report_button.clicked.connect(self._open_report)
        self.progress = QProgressBar(self)
        self.progress.setRange(0, 1000)
        self.progress_text = QLabel(self)
        devices = QLabel("    ".join(f"■ {name}: simulated" for name in DEVICES), self)
        devices.setObjectName("devices")

        buttons = QHBoxLayout()
        buttons.addWidget(self.start_button, 2)
        buttons.addWidget(self.cancel_button)
        buttons.addWidget(self.report_button)
        right = QVBoxLayout()
        right.addWidget(self.banner)
        right.addWidget(self.view, 1)
        right.addWidget(self.progress_text)
        right.addWidget(self.progress)
        right.addLayout(buttons)
        right.addWidget(devices)
        body = QWidget(self)
        layout = QHBoxLayout(body)
        layout.addWidget(self.rail)
        layout.addLayout(right, 1)
        self.setCentralWidget(body)
        self._show_idle(
            "Calibrates a simulated cell from nothing: six steps, each checked on data kept out of its fit. "
            "No real device moves.",
            "#495057",
        )

    def showEvent(self, event: QShowEvent) -> None:  # noqa: N802  (Qt's name)
        """Load the blade once the window is there; reading STEP takes a second or two."""
        super().showEvent(event)
        if not self._workers:
            self._run(lambda job, _: load_blade(self._blade_type), self._show_blade)

    def start(self) -> None:
        """Begin the commissioning."""
        folder = self._out_dir or Path(tempfile.mkdtemp(prefix="beltcal_"))
        self.rail.reset()
        self._report = None
        self._set_running(True)
        self._say("Commissioning the simulated cell.", "#0b5ed7")

        def work(job: Job, on_step: Any) -> DemoResult:
            return run_demo(folder, blade_type=self._blade_type, config=self._config, resolution=self._resolution,
                            grid=self._grid, job=job, on_step=on_step)  # fmt: skip

        self._run(work, self._show_result)

    def cancel(self) -> None:
        """Ask the running work to end."""
        for worker in self._workers:
            worker.cancel()

    def _run(self, work: Work, on_done: Any) -> None:
        worker = Worker(work)
        self._workers.append(worker)
        worker.progressed.connect(self._show_progress)
        worker.step_changed.connect(self._show_step)
        worker.done.connect(on_done)
        worker.refused.connect(lambda text: self._show_idle(f"✖ Refused: {text}", "#b02a37"))
        worker.cancelled.connect(lambda: self._show_idle("◆ Cancelled. What was kept stays kept.", "#997404"))
        worker.crashed.connect(self._raise)
        worker.start()

    def _raise(self, error: Exception) -> None:
        self._show_idle("✖ The program has a fault; details are in the log.", "#b02a37")
        raise error

    def _show_progress(self, fraction: float, message: str) -> None:
        self.progress.setValue(round(1000 * fraction))
        self.progress_text.setText(message)

    def _show_step(self, event: StepEvent) -> None:
        self.rail.show_event(event)

    def _show_result(self, result: DemoResult) -> None:
        self._report = result.report
        if result.accepted:
            self._show_idle(f"✔ Accepted. {result.headline}", "#146c43")
        else:
            self._show_idle(f"✖ Rejected. {result.headline}", "#b02a37")

    def _show_blade(self, mesh: Any) -> None:
        if self._closed:
            return  # what a worker sent at its very end arrives after the view has gone
        self.view.plotter.add_mesh(mesh, name="blade", color="#adb5bd", smooth_shading=True, split_sharp_edges=True)
        self.view.plotter.add_text(f"Blade type {self._blade_type.upper()}, {{W}}, mm", name="label", font_size=9,
                                   color="#212529")
        self.view.plotter.add_axes()
        self.view.plotter.camera_position = "iso"
        self.view.refresh()

    def _show_idle(self, text: str, colour: str) -> None:
        self._set_running(False)
        self._say(text, colour)

    def _say(self, text: str, colour: str) -> None:
        self.banner.setText(text)
        self.banner.setStyleSheet(BANNER_STYLE.format(colour))

    def _set_running(self, running: bool) -> None:
        self.start_button.setEnabled(not running)
        self.cancel_button.setEnabled(running)
        self.report_button.setEnabled(self._report is not None and not running)
        self.progress.setVisible(running)
        self.progress_text.setVisible(running)

    def _open_report(self) -> None:
        QDesktopServices.openUrl(QUrl.fromLocalFile(str(self._report)))

    def closeEvent(self, event: QCloseEvent) -> None:  # noqa: N802  (Qt's name)
        """End the work and free the view before the window goes."""
        self.cancel()
        for worker in self._workers:
            worker.wait()
        self._closed = True
        self.view.shut_down()
        super().closeEvent(event)


def load_blade(blade_type: str) -> Any:
    """The blade as a pyvista mesh (mm, {W}), tessellated from its STEP file."""
    from beltgui.report.scenes import blade_mesh
    from core.cad import read_step
    from core.cad.blade_type import read_blade_type

    return blade_mesh(read_step(read_blade_type(blade_type_path(blade_type)).step_path))
