"""The window without a mouse: from the start page to the accepted ball step."""

import subprocess
import sys
from pathlib import Path
from shutil import which

ROOT = Path(__file__).resolve().parents[2]


def test_the_keyboard_alone_gets_from_the_start_page_to_an_accepted_step(tmp_path: Path) -> None:
    """In a process of its own, because a process has one Qt platform."""
    for tool in ("xvfb-run", "xdotool"):
        assert which(tool), f"{tool} is missing; `make setup` installs it"
    words = ["xvfb-run", "-a", "-s", "-screen 0 1280x800x24", "env", "QT_QPA_PLATFORM=xcb", sys.executable,
             "-m", "tests.on_screen.keyboard", "--out", str(tmp_path)]  # fmt: skip
    run = subprocess.run(words, capture_output=True, text=True, timeout=300, check=False, cwd=ROOT)
    assert run.returncode == 0, run.stdout + run.stderr
