"""How long `beltcal gui --sim` takes to start, beside a bare PySide6 window in the same run.

`python -m benchmarks.start_up [--runs 5] [--size 1280x800]`

Without a screen it opens one with xvfb-run. One start of each warms the disk's cache, then a bare window and the
program start in turns; medians. CPU is what the window's process has used until then, which other work on the machine
hardly changes. The times run from the start of the process, those of the session from its beginning:

- painted: the window has been painted once;
- usable: the page of the steps is there, and the engine takes commands;
- step page: a new session is open, and the step's main button can be pressed;
- picture: the first 3D picture (the blade, in the rough step) is on the screen.

Goal: usable in less than 3 s.
"""

from __future__ import annotations

import argparse
import os
import statistics
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

GOAL_S = 3.0
LIMIT_S = 120.0
MARKS = ("painted", "usable", "step page", "picture")


def bare() -> None:
    """A window of PySide6 and nothing else."""
    from PySide6.QtCore import QTimer
    from PySide6.QtWidgets import QApplication, QLabel

    application = QApplication(sys.argv[:1])

    class Window(QLabel):
        def paintEvent(self, event: Any) -> None:  # noqa: N802  (Qt's name)
            super().paintEvent(event)
            mark("painted")
            QTimer.singleShot(0, application.quit)

    window = Window("A window")
    window.resize(800, 600)
    window.show()
    application.exec()


def mark(name: str) -> None:
    """Tell the parent that this has been reached; the clock is the computer's, the same in every process."""
    print(f"{name}: {time.monotonic()} {time.process_time()}", flush=True)


def program() -> None:
    """The program, watched from within; it begins a session when it can and closes after the first picture."""
    import beltgui.app.main as module
    from benchmarks.window_drive import scratch, with_own_settings

    dress = module._dress
    with scratch() as folder:

        def watched(application: Any, *words: Any) -> None:
            with_own_settings(Path(folder))
            dress(application, *words)
            watch(application, Path(folder))

        module._dress = watched
        from beltgui.cli.main import main

        main(["gui", "--sim"])


def watch(application: Any, folder: Path) -> None:
    """Mark what is reached; a filter sees the first painting, then events and a timer tell the rest."""
    from PySide6.QtCore import QEvent, QObject, QTimer
    from PySide6.QtWidgets import QWidget

    from beltgui.engine.messages import JobEnded, NewSession, Ready
    from benchmarks.window_drive import PERSON

    state: dict[str, Any] = {"ready": False, "begun": 0.0}

    class Filter(QObject):
        def eventFilter(self, thing: QObject, event: QEvent) -> bool:  # noqa: N802  (Qt's name)
            if isinstance(thing, QWidget) and thing.objectName() == "main_window":
                if event.type() == QEvent.Type.Show and "window" not in state:
                    state["window"] = thing
                    thing.client.event.connect(hear)
                elif event.type() == QEvent.Type.Paint:
                    application.removeEventFilter(self)
                    QTimer.singleShot(0, lambda: mark("painted"))
                    look.start()
            return False

    def hear(event: object) -> None:
        if isinstance(event, Ready):
            state["ready"] = True
        elif isinstance(event, JobEnded):
            mark("step page")
            state["window"].page.scene.picture_shown.connect(seen)
            state["window"].look_at("rough")

    def seen() -> None:
        state["window"].page.scene.picture_shown.disconnect(seen)
        mark("picture")
        QTimer.singleShot(0, state["window"].close)

    def begin_when_usable() -> None:
        window = state["window"]
        if window.page is not None and state["ready"]:
            look.stop()
            mark("usable")
            window.client.send(NewSession(str(folder / "session"), PERSON))

    look = QTimer(application, interval=5)
    look.timeout.connect(begin_when_usable)
    state["filter"] = Filter(application)
    application.installEventFilter(state["filter"])


def one_start(what: str) -> dict[str, tuple[float, float]]:
    """Seconds to each mark of one process, and the CPU seconds it had used there."""
    begun = time.monotonic()
    words = [sys.executable, "-m", "benchmarks.start_up", "--child", what]
    done = subprocess.run(words, capture_output=True, text=True, timeout=LIMIT_S, check=False)
    marks = dict(line.split(": ") for line in done.stdout.splitlines())
    if done.returncode or "painted" not in marks:
        raise RuntimeError(f"{what}: no window.\n{done.stdout}{done.stderr}")
    at = {name: tuple(map(float, values.split())) for name, values in marks.items()}
    session = at.get("usable", (begun, 0.0))
    zero = {name: session if name in MARKS[2:] else (begun, 0.0) for name in at}
    return {name: (wall - zero[name][0], cpu - zero[name][1]) for name, (wall, cpu) in at.items()}


def report(runs: int) -> int:
    """Print the table; 1 if the goal was missed."""
    times: dict[str, list[dict[str, tuple[float, float]]]] = {"bare": [], "program": []}
    for number in range(runs + 1):
        for what, found in times.items():
            marks = one_start(what)
            if number:
                found.append(marks)
    reference = statistics.median(marks["painted"][0] for marks in times["bare"])
    print(f"\n{os.cpu_count()} cores (load {os.getloadavg()[0]:.1f}), median of {runs} warm starts\n")
    print("| from | to | s | fastest to slowest | of a bare window | CPU s |\n|---|---|---|---|---|---|")
    missed = False
    for what, name in (("bare", "painted"), *(("program", name) for name in MARKS)):
        values = sorted(marks[name][0] for marks in times[what])
        middle = statistics.median(values)
        cpu = statistics.median(marks[name][1] for marks in times[what])
        since = "a new session" if name in MARKS[2:] else "start of a bare window" if what == "bare" else "start"
        span = f"{values[0]:.2f} to {values[-1]:.2f}"
        print(f"| {since} | {name} | {middle:.2f} | {span} | {middle / reference:.1f} | {cpu:.2f} |")
        missed = missed or (name == "usable" and middle >= GOAL_S)
    return int(missed)


def main() -> int:
    from benchmarks.gui_gaps import on_a_screen

    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--size", default="1280x800")
    arguments = parser.parse_args()
    width, height = (int(part) for part in arguments.size.split("x"))
    elsewhere = on_a_screen((width, height), "benchmarks.start_up")
    return report(arguments.runs) if elsewhere is None else elsewhere


if __name__ == "__main__":
    if sys.argv[1:2] == ["--child"]:
        {"bare": bare, "program": program}[sys.argv[2]]()
    else:
        sys.exit(main())
