"""A bench with the blade's scans on the simulated cell, and what rough and fine tests have in common."""

import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, fields, is_dataclass, replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np

from beltgui.jobs import Job
from beltgui.steps.fine.room import FineRoom
from beltgui.steps.room import Bench
from beltgui.steps.rough.room import RoughRoom
from beltgui.viewmodel.step import StepContent
from core.frames import Array, transform_points
from tests.beltgui.live import Live, blade_and_model

PERSON = "A. Tester"


class Asked:
    """Stands in for the operator and keeps what was asked for."""

    def __init__(self, operator: Any) -> None:
        self._operator = operator
        self.requests: list[Any] = []

    def perform(self, request: Any, **named: Any) -> None:
        self.requests.append(request)
        self._operator.perform(request, **named)

    @property
    def items(self) -> list[str]:
        return [request.item for request in self.requests]


@dataclass(eq=False)
class BladeBench:
    """The cell, a bench with ideal ball and base outcomes, and the two rooms."""

    live: Live
    bench: Bench
    asked: Asked
    rough = RoughRoom()
    fine = FineRoom()

    @classmethod
    @contextmanager
    def start(cls, folder: Path, seed: int = 0) -> Iterator["BladeBench"]:
        blade, model = blade_and_model()
        with Live.start(folder, seed=seed) as live:
            asked = Asked(live.context.cell.operator)
            live.context = replace(live.context, cell=replace(live.context.cell, operator=asked))
            bench = Bench(live.session, live.sim.plan, blade, model, "2026-01-01")
            bench.found["ball"] = SimpleNamespace(stage=live.stage_fit())
            bench.found["base"] = SimpleNamespace(fit=live.base_fit())
            yield cls(live, bench, asked)

    def acquire(self, step: str, job: Job | None = None) -> None:
        getattr(self, step).acquire(self.bench, self.live.with_job(job or Job()))

    def solve(self, step: str, job: Job | None = None) -> Any:
        return getattr(self, step).solve(self.bench, job or Job())

    def choose(self, step: str, key: str, value: Any) -> None:
        self.live.session.choose(step, key, value, PERSON)

    def undo_all(self) -> None:
        for step in ("rough", "fine"):
            while self.live.session.can_undo(step):
                self.live.session.undo(step, PERSON)

    def pairs(self, count: int, noise_mm: float = 0.4, seed: int = 1) -> list[dict[str, Any]]:
        """Pairs spread over edge plate, airfoil and shroud, as a hand picks them."""
        rng = np.random.default_rng(seed)
        corners = self.spread()[:count]
        scan = transform_points(self.live.sim.truth.measure_from_work, corners) + rng.normal(0.0, noise_mm, (count, 3))
        return [
            {"name": f"corner {k + 1}", "scan_mm": scan[k].tolist(), "cad_mm": corners[k].tolist(), "included": True}
            for k in range(count)
        ]

    def spread(self) -> Array:
        """Vertices of the CAD model, each far from those before."""
        vertices = self.bench.model.tessellate(0.3).vertices
        chosen = [vertices[int(np.argmax(vertices[:, 2]))]]
        while len(chosen) < 6:
            apart = np.min([np.linalg.norm(vertices - point, axis=1) for point in chosen], axis=0)
            chosen.append(vertices[int(np.argmax(apart))])
        return np.array(chosen)

    def error_mm(self, measure_from_work: Array) -> float:
        """Largest true error at the ends and in the middle of the blade."""
        low, high = self.bench.model.bounds_mm
        middle = 0.5 * (low + high)
        points = np.array([[middle[0], middle[1], z] for z in (low[2], middle[2], high[2])])
        truth = transform_points(self.live.sim.truth.measure_from_work, points)
        return float(np.linalg.norm(transform_points(measure_from_work, points) - truth, axis=1).max())


def check_whole(content: StepContent) -> None:
    """No number that is none, a unit at every measured number, and few enough points for a screen."""
    assert list(_not_finite(content)) == []
    for number in content.numbers:
        assert number.unit in ("mm", "µm", "deg", "%") or (number.unit == "" and number.decimals <= 1), number
    assert all(check.unit in ("mm", "µm") for check in content.checks)
    for row in content.rows:
        assert len(row.cells) == len(content.columns)
    for plot in content.plots:
        assert "mm" in plot.x_label + plot.y_label or "µm" in plot.x_label + plot.y_label


def _not_finite(value: Any, where: str = "content") -> Iterator[str]:
    if isinstance(value, float):
        if not math.isfinite(value):
            yield where
    elif isinstance(value, np.ndarray):
        if value.dtype.kind == "f" and not np.isfinite(value).all():
            yield where
    elif is_dataclass(value) and not isinstance(value, type):
        for field in fields(value):
            yield from _not_finite(getattr(value, field.name), f"{where}.{field.name}")
    elif isinstance(value, dict):
        for key, item in value.items():
            yield from _not_finite(item, f"{where}[{key}]")
    elif isinstance(value, list | tuple):
        for k, item in enumerate(value):
            yield from _not_finite(item, f"{where}[{k}]")
