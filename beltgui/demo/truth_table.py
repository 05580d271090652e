"""Truth against estimate, step by step; only a simulated cell can tell."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from beltgui.commissioning import Commissioning
from beltgui.report.page import vector_text
from beltgui.steps.state import STEPS, TITLES
from core.cad import CadModel
from core.frames import pose_error, transform_points
from devices.cell_plan import CellPlan
from devices.sim import Truth

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Row:
    """One line of the table.

    Attributes:
        step: Which step.
        quantity: What is compared, with frame.
        truth: True value as text with unit.
        estimate: Estimated value as text with unit.
        error: Difference as text with unit.
    """

    step: str
    quantity: str
    truth: str
    estimate: str
    error: str


def root_mid_tip(model: CadModel) -> Array:
    """(3, 3) points on the blade's middle line at its lower end, half-way and its upper end, {W}."""
    low, high = model.bounds_mm
    middle = 0.5 * (low + high)
    return np.array([[middle[0], middle[1], z] for z in (low[2], middle[2], high[2])])


class TruthTable:
    """Collects rows while the steps run: some truths last only until the next thing is mounted or moved."""

    def __init__(self, truth: Truth, plan: CellPlan, model: CadModel, grinder: str) -> None:
        self._truth = truth
        self._plan = plan
        self._grinder = grinder
        self._points = root_mid_tip(model)
        self.rows: list[Row] = []

    def step_done(self, step: str, found: Commissioning) -> None:
        """Compare what a step has just found."""
        compare: dict[str, Callable[[Commissioning], None]] = {
            "ball": self._ball,
            "base": self._base,
            "rough": self._rough,
            "fine": self._fine,
            "tool": self._tool,
            "error_surface": self._error_surface,
        }
        compare[step](found)

    def add(self, step: str, quantity: str, truth: str, estimate: str, error: str) -> None:
        """One more row."""
        self.rows.append(Row(step, quantity, truth, estimate, error))

    def _ball(self, found: Commissioning) -> None:
        assert found.ball is not None
        stage = found.ball.stage
        directions = self._truth.stage_axes / np.linalg.norm(self._truth.stage_axes, axis=0)
        for index, (name, i, j) in enumerate((("xy", 0, 1), ("yz", 1, 2), ("zx", 2, 0))):
            true_deg = np.degrees(np.arccos(directions[:, i] @ directions[:, j])) - 90.0
            found_deg = np.degrees(stage.squareness_rad[index])
            self._number("ball", f"stage squareness {name}", true_deg, found_deg, "°", 4)
        in_front = np.array([0.0, 0.0, self._plan.scanner.working_distance_mm])
        misses = [
            transform_points(self._truth.measure_from_scanner_at(pose.stage), in_front)
            - transform_points(
                stage.measure_from_scanner_at(
                    np.array([pose.stage.x_mm, pose.stage.y_mm, pose.stage.z_mm]), pose.stage.theta_rad
                ),
                in_front,
            )
            for pose in self._plan.stage_step
        ]
        rms = float(np.sqrt(np.mean(np.sum(np.square(misses), axis=1))))
        self.add("ball", "scanned point in {M}, over all stage positions", "0 mm", "–", f"{rms:.4f} mm RMS")

    def _base(self, found: Commissioning) -> None:
        assert found.base is not None
        fit = found.base.fit
        self._pose("base", "measure in base", self._truth.base_from_measure, fit.base_from_measure,
                   fit.covariance.about_mm)
        self._point("base", "ball in flange", self._truth.ball_in_flange_mm, fit.ball_in_flange_mm)

    def _rough(self, found: Commissioning) -> None:
        assert found.rough is not None
        self._blade("rough", "blade in measure", self._truth.measure_from_work, found.rough.measure_from_work)

    def _fine(self, found: Commissioning) -> None:
        assert found.fine is not None
        self._blade("fine", "blade in measure", self._truth.measure_from_work, found.fine.fit.measure_from_work)
        self._blade("fine", "blade in flange", self._truth.flange_from_work, found.fine.flange_from_work)

    def _tool(self, found: Commissioning) -> None:
        assert found.tool is not None
        self._point("tool", "stylus tip in flange", self._truth.tip_in_flange_mm, found.tool.stylus.tip_in_flange_mm)
        for name, wheel in found.tool.wheels.items():
            truth = self._truth.base_from_tool(name)
            self._pose("tool", f"wheel of grinder {name} in base", truth, wheel.base_from_tool, truth[:3, 3])

    def _error_surface(self, found: Commissioning) -> None:
        assert found.error_surface is not None
        self._blade("error_surface", "blade in flange, clamped again", self._truth.flange_from_work,
                    found.error_surface.clamped_again.flange_from_work)

    def _blade(self, step: str, what: str, truth: Array, estimate: Array) -> None:
        """Errors at root, mid and tip."""
        at_truth, at_estimate = (transform_points(pose, self._points) for pose in (truth, estimate))
        errors = np.linalg.norm(at_estimate - at_truth, axis=1)
        for place, true, found, error in zip(("root", "mid", "tip"), at_truth, at_estimate, errors, strict=True):
            self.add(step, f"{what}, {place}", vector_text(true), vector_text(found), _length(error))

    def _point(self, step: str, what: str, truth: Array, estimate: Array) -> None:
        error = float(np.linalg.norm(estimate - truth))
        self.add(step, what, vector_text(truth), vector_text(estimate), _length(error))

    def _pose(self, step: str, what: str, truth: Array, estimate: Array, about: Array) -> None:
        error = pose_error(estimate, truth, about)
        angle = np.degrees(np.linalg.norm(error[:3]))
        self.add(step, f"{what}, position", vector_text(truth[:3, 3]), vector_text(estimate[:3, 3]),
                 _length(float(np.linalg.norm(error[3:]))))
        self.add(step, f"{what}, orientation", "–", "–", f"{angle:.4f} °")

    def _number(self, step: str, what: str, truth: float, estimate: float, unit: str, digits: int) -> None:
        self.add(step, what, f"{truth:.{digits}f} {unit}", f"{estimate:.{digits}f} {unit}",
                 f"{abs(estimate - truth):.{digits}f} {unit}")


def as_text(rows: list[Row], verdicts: dict[str, str]) -> str:
    """The table for a terminal, with each step's verdict on its first line."""
    header = ("step", "quantity", "truth", "estimate", "error", "verdict")
    lines: list[tuple[str, ...]] = [header]
    for step in STEPS:
        of_step = [row for row in rows if row.step == step]
        for number, row in enumerate(of_step):
            first = number == 0
            lines.append((
                f"{STEPS.index(step) + 1} {TITLES[step]}" if first else "",
                row.quantity,
                row.truth,
                row.estimate,
                row.error,
                verdicts.get(step, "") if first else "",
            ))
    widths = [max(len(line[column]) for line in lines) for column in range(len(header))]
    text = ["  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)).rstrip() for line in lines]
    return "\n".join([text[0], "-" * len(text[0]), *text[1:]])


def _length(value: float) -> str:
    return f"{1000.0 * value:.1f} µm" if value < 0.1 else f"{value:.3f} mm"
