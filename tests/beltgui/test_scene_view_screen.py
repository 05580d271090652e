"""The 3D view in processes of its own: on a screen, and when the window's process is killed."""

import os
import signal
import subprocess
import sys
import time
from shutil import which

TIMEOUT_S = 120.0

PRELUDE = """
import os, signal, sys
import numpy as np
from PySide6.QtCore import QPointF, Qt, QTimer
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from beltgui.viewmodel.scene import Frame, Points, Role, Scene
from beltgui.widgets.scene_view import SceneView

def scene():
    x, y = np.meshgrid(np.arange(-30.0, 31.0, 10.0), np.arange(-20.0, 21.0, 10.0))
    xyz = np.stack([x.ravel(), y.ravel(), 0.0 * x.ravel()], axis=1).astype(np.float32)
    cloud = Points("scan", xyz, Role.OUTLIER, size_px=5.0, pickable=True)
    return Scene("A scan", "M", (cloud, Frame("{M}", np.eye(4))), "top")

def show(then):
    application = QApplication(sys.argv[:1])
    view = SceneView()
    view.resize(800, 600)
    view.show()
    view.prepare()
    view.show_scene(scene())
    view.set_pick_mode("point")
    view.picture_shown.connect(lambda: then(application, view))
    return application.exec()
"""

ON_A_SCREEN = (
    PRELUDE
    + """
def look(application, view):
    picked = []
    view.picked_point.connect(lambda *args: picked.append(args))
    rect = view.canvas.rects()[0]
    place, _ = view.canvas.panes[0].camera.project(np.array([20.0, -10.0, 0.0]), rect.width(), rect.height())
    QTest.mouseClick(view.canvas, Qt.MouseButton.LeftButton, pos=QPointF(*place[0]).toPoint())
    colours = {view.screenshot().pixelColor(x, 300).name() for x in range(800)}
    print(QGuiApplication.platformName(), picked[0][0], picked[0][1].tolist(), picked[0][2], len(colours) > 3)
    view.close()
    application.quit()

if __name__ == "__main__":
    code = show(look)
    print("closed", flush=True)
    sys.exit(code)
"""
)

KILLED = (
    PRELUDE
    + """
def die(application, view):
    print(view.drawing_pid, flush=True)
    os.kill(os.getpid(), signal.SIGKILL)

if __name__ == "__main__":
    show(die)
"""
)


def test_on_a_screen_it_draws_picks_and_closes(tmp_path: os.PathLike[str]) -> None:
    assert which("xvfb-run"), "xvfb-run is missing; `make setup` installs it"
    script = os.path.join(tmp_path, "look.py")
    with open(script, "w", encoding="utf-8") as file:
        file.write(ON_A_SCREEN)
    words = ["xvfb-run", "-a", "-s", "-screen 0 1280x800x24", "env", "QT_QPA_PLATFORM=xcb", sys.executable, script]
    run = subprocess.run(words, capture_output=True, text=True, timeout=TIMEOUT_S, check=False, env=environment())
    assert run.returncode == 0, run.stderr
    assert run.stdout.split("\n")[:2] == ["xcb scan [20.0, -10.0, 0.0] False True", "closed"], run.stdout + run.stderr
    assert "leaked" not in run.stderr, run.stderr


def test_the_drawing_process_ends_with_the_window_that_is_killed(tmp_path: os.PathLike[str]) -> None:
    script = os.path.join(tmp_path, "die.py")
    with open(script, "w", encoding="utf-8") as file:
        file.write(KILLED)
    here = {**environment(), "QT_QPA_PLATFORM": "offscreen"}
    with open(os.path.join(tmp_path, "said"), "w+", encoding="utf-8") as said:
        run = subprocess.run([sys.executable, script], stdout=said, timeout=TIMEOUT_S, check=False, env=here)
        said.seek(0)
        words = said.read()
    assert run.returncode == -signal.SIGKILL
    deadline = time.monotonic() + TIMEOUT_S
    while is_running(int(words)):
        assert time.monotonic() < deadline, "the drawing process outlives its window"
        os.sched_yield()


def environment() -> dict[str, str]:
    return {**os.environ, "PYTHONPATH": os.pathsep.join([os.getcwd(), os.environ.get("PYTHONPATH", "")])}


def is_running(pid: int) -> bool:
    """Whether there is such a process that has not ended (one that nobody has waited for yet has)."""
    try:
        with open(f"/proc/{pid}/stat", encoding="utf-8") as file:
            return file.read().rpartition(")")[2].split()[0] not in ("Z", "X")
    except (FileNotFoundError, ProcessLookupError):
        return False
