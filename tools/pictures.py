"""Makes the pictures of the README: `.venv/bin/python tools/pictures.py`, about ten minutes.

A driver with mouse and keyboard walks through the whole commissioning in a real window on a virtual screen; what it
photographs is what a user sees. The report's pictures come from a demonstration run.
"""

from __future__ import annotations

import base64
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
IMAGES = ROOT / "docs" / "images"
# Pictures of the walk that stand still in the README and the documentation, by the names the walk gives them.
STILLS = {
    "start": "start.png",
    "ball_result": "ball.png",
    "base_move": "motion.png",
    "base_result": "base.png",
    "rough_result": "rough.png",
    "fine_result": "fine.png",
    "tool_result": "tool.png",
    "error_surface_accepted": "error_surface.png",
}
# One turn of the animation: the six steps, how long each picture stays in ms.
FRAMES = (
    ("start", 1600), ("ball_done", 1600), ("ball_move", 1600), ("ball_result", 2400), ("base_move", 1600),
    ("base_result", 2400), ("rough_result", 2400), ("fine_result", 2400), ("tool_done", 1600), ("tool_result", 2400),
    ("error_surface_move", 1600), ("error_surface_result", 2400), ("error_surface_accepted", 2000), ("exported", 3000),
)  # fmt: skip
ANIMATION, ANIMATION_PX, ANIMATION_COLOURS = "six_steps.gif", (960, 600), 128
# The same step in the other theme and the other language.
OTHER = (("dark", "en", "error_surface_accepted", "dark.png"), ("light", "zh_CN", "fine_result", "chinese.png"))
# Pictures of the report, by their captions' beginnings.
REPORT_PICTURES = {
    "The scan on the CAD model": "scan_on_cad.png",
    "True normal error along every stroke": "before_and_after.png",
}


def main() -> int:
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder)
        shots = walk(out / "walk", "light", "en")
        for name, file in STILLS.items():
            shutil.copyfile(shots[name], IMAGES / file)
        animate([(shots[name], stay_ms) for name, stay_ms in FRAMES if name in shots])
        for theme, language, name, file in OTHER:
            shutil.copyfile(walk(out / file, theme, language)[name], IMAGES / file)
        report(out / "demo")
    return 0


def walk(out: Path, theme: str, language: str) -> dict[str, Path]:
    """All pictures of one walk, by name."""
    words = ["xvfb-run", "-a", "-s", "-screen 0 1280x800x24", sys.executable, "-m", "tests.on_screen.walk",
             "--out", str(out), "--theme", theme, "--language", language, "--resolution", "demo"]  # fmt: skip
    subprocess.run(words, check=True, cwd=ROOT)
    return {re.sub(r"^\d+_", "", path.stem): path for path in sorted(out.glob("*.png"))}


def animate(frames: list[tuple[Path, int]]) -> None:
    """The animation, small enough for a page."""
    pictures = [
        Image.open(path).convert("RGB").resize(ANIMATION_PX, Image.Resampling.LANCZOS)
        .quantize(ANIMATION_COLOURS, dither=Image.Dither.NONE)
        for path, _ in frames
    ]  # fmt: skip
    pictures[0].save(IMAGES / ANIMATION, save_all=True, append_images=pictures[1:],
                     duration=[stay_ms for _, stay_ms in frames], loop=0, optimize=True)  # fmt: skip


def report(out: Path) -> None:
    """The pictures of a demonstration's report."""
    from beltgui.demo import run_demo

    html = run_demo(out).report.read_text(encoding="utf-8")
    for caption, data in re.findall(r'<img alt="([^"]*)" src="data:image/png;base64,([^"]+)"', html):
        for beginning, name in REPORT_PICTURES.items():
            if caption.startswith(beginning):
                (IMAGES / name).write_bytes(base64.b64decode(data))


if __name__ == "__main__":
    sys.exit(main())
