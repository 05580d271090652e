"""Start of the application: what it refuses, and a whole start and end on a screen, in a process of its own."""

import subprocess
import sys
from pathlib import Path
from shutil import which

import pytest

from beltgui.app.main import run
from beltgui.cli.main import main
from core.errors import InputError

SESSION = """
import os, sys
from pathlib import Path

FOLDER = sys.argv[1]


def check(window):
    from beltgui.engine.messages import Ready, SessionOpened

    said = []

    def hear(event):
        said.append(type(event))
        if isinstance(event, Ready):
            start = window.start_page
            start.folder.setText(FOLDER)
            start.begin_button.click()
        if SessionOpened in said and window.page is not None and window.isVisible():
            print("opened", window.top_bar.blade.text(), window.stop_enabled())
            window.client.event.disconnect(hear)
            window.close()

    window.client.event.connect(hear)


def begin():
    from beltgui.app import window as module

    made = module.MainWindow.__init__

    def make(self, *words, **named):
        made(self, *words, **named)
        check(self)

    module.MainWindow.__init__ = make
    module.MainWindow.stop_enabled = lambda self: self.top_bar.stop_button.isEnabled()
    from beltgui.cli.main import main

    code = main(["gui", "--sim", "--person", "Ada", "--theme", "dark", "--language", "en"])
    from beltgui.app.theme import theme

    print("ended", code, theme().name)


if __name__ == "__main__":
    begin()
"""


def test_real_devices_are_refused_for_now() -> None:
    with pytest.raises(InputError, match="Start it with --sim"):
        run(sim=False)


def test_without_a_screen_it_says_what_to_do(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"):
        monkeypatch.delenv(name, raising=False)
    with pytest.raises(InputError, match=r"there is no screen.*xvfb-run"):
        run(sim=True)


@pytest.mark.parametrize(
    "words", [["--session", "nowhere"], ["--config", "nowhere.toml"], ["--theme", "pink"], ["--language", "tlh"]]
)
def test_words_that_cannot_be_used_are_refused(
    words: list[str], capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["gui", "--sim", *words]) == 2
    assert words[1] in capsys.readouterr().err


def test_it_starts_begins_a_session_and_ends_on_a_screen(tmp_path: Path) -> None:
    assert which("xvfb-run"), "xvfb-run is missing; `make setup` installs it"
    script = tmp_path / "start.py"
    script.write_text(SESSION)
    words = ["xvfb-run", "-a", "-s", "-screen 0 1280x800x24", "env", "QT_QPA_PLATFORM=xcb",
             f"XDG_CONFIG_HOME={tmp_path / 'settings'}", f"PYTHONPATH={Path(__file__).parents[2]}", sys.executable,
             str(script), str(tmp_path / "session")]  # fmt: skip
    done = subprocess.run(words, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines() == ["opened DR95  ·  DR95-0001  ·  Ada True", "ended 0 dark"], done.stderr
    assert (tmp_path / "session" / "session.db").is_file()
    assert "Traceback" not in done.stderr
