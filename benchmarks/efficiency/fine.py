"""Fine registration: blade DR95 with strangers among the points; bound from all true points of the faces."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np

import resources
from benchmarks.efficiency.common import Case, Trial
from benchmarks.unknown_blade import SIGMA_MM, Sampler, read_sampler, simulate
from core.cad import CadModel, read_step
from core.fine import FineSettings, solve_fine
from core.frames import PoseCovariance, pose_error

POINTS = 20_000
FACES = ("S2", "S3", "S4", "S5", "S6")


def cases() -> list[Case]:
    """Starts 0.1 degrees and 0.2 mm off, without the search, so that 300 runs take a minute or two."""
    unknown = FineSettings(search=False, coarse_points=1000)
    known = replace(unknown, sigma_mm=SIGMA_MM)
    return [
        Case("fine, all faces, 30 % strangers, known noise", 6, lambda rng: _trial(rng, known, 0.3, ())),
        Case("fine, S2 to S6, 30 % strangers, noise estimated", 6, lambda rng: _trial(rng, unknown, 0.3, FACES)),
    ]


@cache
def _blade() -> tuple[CadModel, Sampler]:
    path = Path(resources.__file__).parent / "blades" / "dr95.step"
    return read_step(path), read_sampler(path)


def _trial(rng: np.random.Generator, settings: FineSettings, outliers: float, names: tuple[str, ...]) -> Trial:
    model, sampler = _blade()
    ids = tuple(model.face(name).id for name in names)
    scene = simulate(sampler, rng, POINTS, outliers=outliers, views=6 if names else 4, faces=ids or None,
                     all_round=bool(names), turn_deg=0.1, shift_mm=0.2)
    fit = solve_fine(model, [scene.points], scene.start, face_ids=ids or None,
                     settings=replace(settings, seed=int(rng.integers(1 << 30))))
    covariance = fit.covariance.moved_to(scene.about)
    bound = PoseCovariance(scene.crb, scene.about)
    error = pose_error(fit.measure_from_work, scene.measure_from_work, scene.about)
    return Trial(error, covariance.matrix, bound.matrix)
