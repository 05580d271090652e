"""The 3D view in a window of its own: draws and closes on a screen, twice; is refused with a reason where it cannot."""

import os
import subprocess
import sys
from pathlib import Path
from shutil import which

import numpy as np
from PySide6.QtWidgets import QToolButton
from pytestqt.qtbot import QtBot

from beltgui.viewmodel.scene import Frame, Scene
from beltgui.widgets.scene_view import SceneView

ROOT = Path(__file__).parents[2]
TIMEOUT_S = 120.0

ON_A_SCREEN = """
import gc, sys, threading
import numpy as np
from PySide6.QtCore import QEvent, QTimer
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QApplication
from beltgui.app.theme import colour, theme
from beltgui.viewmodel.scene import Mesh, Role, Scene
from beltgui.widgets.scene_view import SceneView

OPENINGS = 2
LEFT_BEHIND = ("QtInteractor", "vtkGenericOpenGLRenderWindow", "SceneWindow", "Glass", "WindowDrawer", "Scenery")


def scene(number):
    corners = np.array([(-30.0, -20.0, 0.0), (30.0, -20.0, 0.0), (30.0, 20.0, 0.0), (-30.0, 20.0, 0.0)], np.float32)
    role = (Role.BLADE, Role.OUTLIER)[number % 2]
    plate = Mesh("plate", corners, np.array([(0, 1, 2), (0, 2, 3)], np.int32), role)
    return Scene(f"A plate {number}", "M", (plate,), "top", ((role, "the plate"),))


def hue(name):
    return QColor(name).hueF()


class Look:
    def __init__(self, application):
        self.application, self.opened = application, 0
        self.view = SceneView(own_process=False)
        self.view.resize(400, 300)
        self.view.show()
        self.view.show_scene(scene(0))
        self.open()

    def open(self):
        self.view.open_window()
        self.window = self.view.window_beside
        self.view.open_window()
        assert self.view.window_beside is self.window, "there is one"
        self.steps = iter((self.first, self.second))
        self.window.picture_shown.connect(self.soon)

    def soon(self):  # when the frame is on the screen
        self.window.picture_shown.disconnect(self.soon)
        interactor = self.window._drawer.interactor
        interactor.frameSwapped.connect(self.swapped)
        interactor.update()

    def swapped(self):
        self.window._drawer.interactor.frameSwapped.disconnect(self.swapped)
        QTimer.singleShot(0, next(self.steps))

    def picture(self):
        shot = self.window.screen().grabWindow(self.window.winId()).toImage()
        middle = shot.pixelColor(shot.width() // 2, shot.height() // 2)
        title = {shot.pixelColor(x, y).name() for x in range(200) for y in range(40)}
        return middle, shot.pixelColor(shot.width() // 2, 5).name(), len(title) > 2

    def first(self):
        middle, background, written = self.picture()
        near = abs(middle.hueF() - hue(colour(Role.BLADE))) < 0.1
        print(self.opened, near, background == colour("scene"), written, flush=True)
        self.window.picture_shown.connect(self.soon)
        self.view.show_scene(scene(1))  # and it follows

    def second(self):
        middle, _, _ = self.picture()
        print(self.opened, abs(middle.hueF() - hue(colour(Role.OUTLIER))) < 0.1, flush=True)
        self.view.show_scene(scene(0))
        self.window.destroyed.connect(self.gone)
        if self.opened == OPENINGS - 1:
            self.view.close()  # takes the window along
        else:
            self.window.close()
        del self.window

    def gone(self):
        QTimer.singleShot(0, self.after)

    def after(self):
        import pyvista.plotting.plotter as plotter

        gc.collect()
        left = [type(thing).__name__ for thing in gc.get_objects() if type(thing).__name__ in LEFT_BEHIND]
        print("left", left, len(plotter._ALL_PLOTTERS), threading.active_count(), self.view.window_beside, flush=True)
        self.opened += 1
        if self.opened < OPENINGS:
            self.open()
        else:
            self.application.quit()


if __name__ == "__main__":
    application = QApplication(sys.argv[:1])
    application.setQuitOnLastWindowClosed(False)
    theme().choose("light")
    look = Look(application)
    code = application.exec()
    print("closed", "pyvista" in sys.modules, flush=True)
    sys.exit(code)
"""


def test_on_a_screen_it_draws_follows_and_leaves_nothing_behind(tmp_path: Path) -> None:
    assert which("xvfb-run"), "xvfb-run is missing; `make setup` installs it"
    script = tmp_path / "look.py"
    script.write_text(ON_A_SCREEN, encoding="utf-8")
    words = ["xvfb-run", "-a", "-s", "-screen 0 1280x900x24", "env", "QT_QPA_PLATFORM=xcb", f"PYTHONPATH={ROOT}",
             f"XDG_CONFIG_HOME={tmp_path}", sys.executable, "-X", "faulthandler", str(script)]  # fmt: skip
    run = subprocess.run(words, capture_output=True, text=True, timeout=TIMEOUT_S, check=False, env={**os.environ})
    assert run.returncode == 0, run.stdout + run.stderr
    once = ["{0} True True True", "{0} True", "left [] 0 1 None"]
    expected = [line.format(number) for number in (0, 1) for line in once]
    assert run.stdout.splitlines() == [*expected, "closed True"], run.stdout + run.stderr
    assert "Traceback" not in run.stderr, run.stderr


def test_without_opengl_it_is_disabled_with_the_reason(qtbot: QtBot) -> None:
    view = SceneView(own_process=False)
    qtbot.addWidget(view)
    view.show_scene(Scene("A frame", "M", (Frame("{M}", np.eye(4)),), "top"))
    button = view.findChild(QToolButton, "scene_own_window")
    assert not button.isEnabled()
    assert "needs OpenGL" in button.toolTip() and "offscreen" in button.toolTip()
    view.open_window()
    assert view.window_beside is None
    view.shut_down()
