"""Makes the pictures of the README: `xvfb-run -a -s "-screen 0 1280x800x24" .venv/bin/python tools/pictures.py`.

Runs the application's own window on the simulated cell until the verdict and takes the report's pictures from the same
run, so that they show what a user gets.
"""

from __future__ import annotations

import base64
import re
import sys
import tempfile
from pathlib import Path

IMAGES = Path(__file__).resolve().parents[1] / "docs" / "images"
# Order of the pictures in the report, by their captions' beginnings.
REPORT_PICTURES = {
    "The scan on the CAD model": "scan_on_cad.png",
    "The measured normal error on the airfoil": "error_on_blade.png",
    "True normal error along every stroke": "before_and_after.png",
}


def main() -> int:
    from PySide6.QtCore import QTimer
    from PySide6.QtWidgets import QApplication

    from beltgui.app.window import MainWindow

    application = QApplication(sys.argv[:1])
    with tempfile.TemporaryDirectory() as folder:
        window = MainWindow(out_dir=Path(folder))
        window.show()

        def begin() -> None:
            window.start()
            window._workers[-1].finished.connect(lambda: QTimer.singleShot(1000, finish))

        def finish() -> None:
            screen = application.primaryScreen()
            screen.grabWindow(0, 0, 0, window.width(), window.height()).save(str(IMAGES / "window.png"))
            save_report_pictures((Path(folder) / "report.html").read_text(encoding="utf-8"))
            window.close()

        QTimer.singleShot(6000, begin)
        return int(application.exec())


def save_report_pictures(html: str) -> None:
    for caption, data in re.findall(r'<img alt="([^"]*)" src="data:image/png;base64,([^"]+)"', html):
        for beginning, name in REPORT_PICTURES.items():
            if caption.startswith(beginning):
                (IMAGES / name).write_bytes(base64.b64decode(data))


if __name__ == "__main__":
    sys.exit(main())
