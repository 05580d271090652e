"""`python -m benchmarks`: every benchmark, one after the other; exit code 1 if one misses its goal.

About an hour on two cores. Each also runs alone, e.g. `python -m benchmarks.efficiency --only ball`.
"""

from __future__ import annotations

import subprocess
import sys

BENCHMARKS = (
    ("Stated covariance and Cramér–Rao bound of every estimator", "benchmarks.efficiency"),
    ("Error surface: golden case", "benchmarks.error_surface_golden"),
    ("Fine registration of blades that are not in the project", "benchmarks.fine_unknown_blade"),
    ("Rough registration from any pose", "benchmarks.rough_auto"),
    ("Gaps of the window's event loop", "benchmarks.gui_gaps"),
    ("Start of the program", "benchmarks.start_up"),
    ("Runs that are killed at random moments", "benchmarks.kill_and_reopen"),
    ("Simulated cells commissioned from nothing", "benchmarks.demo_cell"),
)


def main() -> int:
    failed = []
    for title, module in BENCHMARKS:
        print(f"\n## {title}\n", flush=True)
        if subprocess.run([sys.executable, "-m", module], check=False).returncode != 0:
            failed.append(module)
    if failed:
        print(f"\nMissed: {', '.join(failed)}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
