"""The whole commissioning in a real window, with mouse and keyboard; its pictures stay in `out/screens`."""

import subprocess
import sys
from pathlib import Path
from shutil import which

import numpy as np
from PIL import Image

ROOT = Path(__file__).resolve().parents[2]
PICTURES = ROOT / "out" / "screens"
SIZE = (1280, 800)


def test_a_person_with_mouse_and_keyboard_gets_from_the_first_click_to_the_robot_program() -> None:
    """In a process of its own, because a process has one Qt platform."""
    for tool in ("xvfb-run", "xdotool"):
        assert which(tool), f"{tool} is missing; `make setup` installs it"
    for old in PICTURES.glob("*.png"):
        old.unlink()
    words = ["xvfb-run", "-a", "-s", f"-screen 0 {SIZE[0]}x{SIZE[1]}x24", "env", "QT_QPA_PLATFORM=xcb", sys.executable,
             "-m", "tests.on_screen.walk", "--out", str(PICTURES)]  # fmt: skip
    run = subprocess.run(words, capture_output=True, text=True, timeout=600, check=False, cwd=ROOT)
    assert run.returncode == 0, run.stdout + run.stderr
    pictures = sorted(PICTURES.glob("*.png"))
    assert len(pictures) >= 25 and pictures[-1].stem.endswith("exported")
    for path in pictures:
        with Image.open(path) as image:
            assert image.size == SIZE
            assert np.asarray(image.convert("L")).std() > 5.0, f"{path} is empty"
