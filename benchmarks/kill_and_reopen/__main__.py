"""`kill -9` at random moments of commissioning runs: is anything lost or half-written, and does each run go on?

`python -m benchmarks.kill_and_reopen [--seed 0] [--lanes 2] [--keep FOLDER]`

Two runs side by side, each from nothing to the exported programs, by the engine in a process of its own. The seeded
moments are spread over beginning, taking samples, solving, editing with undo and redo, accepting, exporting and opening
again. About a third of the kills hits not only the engine but also the program that drives it, with its whole process
group. After each one a reader that shares no code with the program looks at the files as they lie; then the session is
opened again, the rail is compared with what was announced before, and the run goes on. Goals: nothing is lost, changed,
half-written or left over, and both runs come to their end.
"""

from __future__ import annotations

import argparse
import math
import os
import statistics
import sys
import tempfile
import threading
import time
from pathlib import Path

from beltgui.steps.graph import NEEDS
from benchmarks.kill_and_reopen.lane import Kill, Lane, Stage

# Kills by step: while samples are taken, solving, editing, accepting; another one while opening again after the first.
BEGIN, EXPORT, LATE = 4, 4, 2
KILLS = {
    "ball": (4, 0, 2, 1, 1), "base": (4, 1, 1, 1, 0), "rough": (2, 0, 0, 1, 1), "fine": (2, 1, 0, 1, 0),
    "tool": (4, 0, 2, 1, 1), "error_surface": (5, 1, 0, 1, 1),
}  # fmt: skip


def stages(lane: int, lanes: int) -> list[Stage]:
    """A commissioning with its share of the kills."""
    dealt = 0

    def share(kills: int) -> int:
        """So many of `kills`; those that do not divide go to one lane after the other."""
        nonlocal dealt
        mine = sum((dealt + number) % lanes == lane for number in range(kills))
        dealt += kills
        return mine

    plan = [Stage("begin", kills=share(BEGIN))]
    for step, (acquire, solve, edit, accept, reopen) in KILLS.items():
        taking = share(acquire)
        plan += [
            Stage("acquire", step, taking, reopen=min(taking, share(reopen))),
            Stage("solve", step, share(solve)),
            Stage("edit", step, share(edit)),
            Stage("accept", step, share(accept)),
        ]
    late = [Stage("edit", "ball", share(LATE), reopen=share(1))]
    return [stage for stage in plan + late if stage.kills or stage.kind in ("begin", "acquire", "accept")] + [
        Stage("export", kills=share(EXPORT))
    ]


def seconds(value: float) -> str:
    return "–" if math.isnan(value) else f"{value:.1f}"


def table(kills: list[Kill]) -> None:
    print("| kill | run | while | killed | samples announced / found | rail back after s | solved again after s | ok |")
    print("|---|---|---|---|---|---|---|---|")
    for number, kill in enumerate(kills, start=1):
        whom = "engine and its parent" if kill.parent else "engine"
        times = f"{seconds(kill.rail_s)} | {seconds(kill.solved_s)}"
        verdict = "yes" if not kill.problems else f"NO: {'; '.join(kill.problems)}"
        samples = f"{kill.announced} / {kill.found}"
        print(f"| {number} | {kill.run} | {kill.moment} | {whom} | {samples} | {times} | {verdict} |")


def report(lanes: list[Lane], seconds_in_all: float) -> int:
    """Print what came of it; 1 if a goal was missed."""
    kills = [kill for lane in lanes for kill in lane.kills]
    table(kills)
    planned = sum(stage.kills + stage.reopen for lane in lanes for stage in lane.stages)
    bad = sum(bool(kill.problems) for kill in kills)
    finished = sum(not lane.missed for lane in lanes)
    back = [kill.rail_s for kill in kills if not math.isnan(kill.rail_s)] or [math.nan]
    print(f"\n{len(kills)} kills, {sum(kill.parent for kill in kills)} of them with the parent; {bad} with something "
          f"lost, changed, half-written or left over. Rail back after {statistics.median(back):.1f} s (median), "
          f"{max(back):.1f} s (longest). {finished} of {len(lanes)} runs finished, all steps accepted and exported. "
          f"{seconds_in_all / 60:.1f} min on {os.cpu_count()} cores (load {os.getloadavg()[0]:.1f}).")  # fmt: skip
    for number, lane in enumerate(lanes, start=1):
        if lane.missed:
            print(f"run {number} did not finish: {lane.missed}")
    return 0 if not bad and finished == len(lanes) and len(kills) == planned else 1


def run(folder: Path, seed: int, count: int) -> int:
    begun = time.monotonic()
    lanes = [Lane(folder / f"run {n + 1}", stages(n, count), seed + n, name=str(n + 1)) for n in range(count)]
    threads = [threading.Thread(target=lane.run) for lane in lanes]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return report(lanes, time.monotonic() - begun)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--lanes", type=int, default=2)
    parser.add_argument("--keep", type=Path, help="keep the sessions in this folder")
    arguments = parser.parse_args()
    assert tuple(KILLS) == tuple(NEEDS)
    if arguments.keep is not None:
        return run(arguments.keep, arguments.seed, arguments.lanes)
    with tempfile.TemporaryDirectory(prefix="kill_and_reopen_") as folder:
        return run(Path(folder), arguments.seed, arguments.lanes)


if __name__ == "__main__":
    sys.exit(main())
