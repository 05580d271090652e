"""Commission several simulated cells and tabulate what is left on the airfoil.

`python -m benchmarks.demo_cell [--seeds 3] [--blades dr95 dr96]`
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
import time
from pathlib import Path

from beltgui.demo import run_demo


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--blades", nargs="+", default=["dr95", "dr96"])
    arguments = parser.parse_args()
    print(f"normal error in mm, true, along the paths between the probed points too; {os.cpu_count()} cores\n")
    print("| blade | seed | nominal RMS | compensated RMS | worst | accepted | s |")
    print("|---|---|---|---|---|---|---|")
    all_ok = True
    for blade in arguments.blades:
        for seed in range(arguments.seeds):
            start = time.perf_counter()
            with tempfile.TemporaryDirectory() as folder:
                result = run_demo(Path(folder), blade_type=blade, seed=seed)
            proof = result.proof
            figures = (
                f"{proof.nominal_rms_mm:.3f} | {proof.compensated_rms_mm:.4f} | {proof.compensated_worst_mm:.4f}"
                if proof is not None
                else "– | – | –"
            )
            all_ok &= result.accepted
            word = "yes" if result.accepted else f"NO: {result.headline}"
            print(f"| {blade} | {seed} | {figures} | {word} | {time.perf_counter() - start:.0f} |", flush=True)
    return 0 if all_ok else 1


if __name__ == "__main__":
    sys.exit(main())
