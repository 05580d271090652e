"""`python -m benchmarks.efficiency [--runs 300] [--only STEP]`: the table of all steps; exit code 1 if one fails."""

from __future__ import annotations

import argparse
import importlib
import os
import pkgutil
import sys
import time

import benchmarks.efficiency as package
from benchmarks.efficiency.common import measure


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", help="name of one step's module, e.g. ball")
    arguments = parser.parse_args()
    steps = [name for _, name, _ in pkgutil.iter_modules(package.__path__) if name not in ("common", "__main__")]
    if arguments.only:
        steps = [name for name in steps if name == arguments.only]
    print(f"{arguments.runs} runs per case, seed {arguments.seed}, {os.cpu_count()} cores\n")
    print("| case | d | mean NEES / d | 95 % band | spread / CRB | ok | s |")
    print("|---|---|---|---|---|---|---|")
    all_ok = bool(steps)
    for step in steps:
        for case in importlib.import_module(f"benchmarks.efficiency.{step}").cases():
            start = time.perf_counter()
            row = measure(case, arguments.runs, arguments.seed)
            all_ok &= row.ok
            band = f"{row.nees_band[0]:.3f} to {row.nees_band[1]:.3f}"
            print(
                f"| {row.name} | {row.dimension} | {row.nees:.3f} | {band} | {row.spread_over_crb:.3f} "
                f"| {'yes' if row.ok else 'NO'} | {time.perf_counter() - start:.0f} |",
                flush=True,
            )
    return 0 if all_ok else 1


if __name__ == "__main__":
    sys.exit(main())
