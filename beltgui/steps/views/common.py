"""Numbers, checks, reasons, rows and marks that all rooms show alike; here rad becomes degrees for the screen."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from beltgui.steps.held_out import HeldOut
from beltgui.viewmodel.plot import Marks
from beltgui.viewmodel.scene import Role
from beltgui.viewmodel.step import Check, Number, ReasonView, SampleRow, Use
from core.frames import euler_zyx_from_rotation, rotation_from_rotvec
from core.verdict import Verdict

Array = NDArray[np.float64]

UM_PER_MM = 1000.0
# Everywhere: plus_minus is twice the standard deviation.
K = 2.0
ROLE_OF_USE = {
    Use.FIT: Role.FIT,
    Use.HELD_OUT: Role.HELD_OUT,
    Use.CHECK: Role.ATTENTION,
    Use.EXCLUDED: Role.EXCLUDED,
}


# ---- single values


def finite(value: float | None) -> float | None:
    """The number, or None where there is none: NaN and infinity are shown as a dash."""
    return None if value is None or not math.isfinite(value) else float(value)


def in_um(value_mm: float | None) -> float | None:
    """Mm as µm; None where there is no number."""
    number = finite(value_mm)
    return None if number is None else UM_PER_MM * number


def in_deg(value_rad: float | None) -> float | None:
    """Rad as degrees; None where there is no number."""
    number = finite(value_rad)
    return None if number is None else math.degrees(number)


def twice(sigma: float | None) -> float | None:
    """The ± (k = 2) of a standard deviation, in its unit; None where there is none."""
    number = finite(sigma)
    return None if number is None else K * number


def largest_sigma(covariance: Array) -> float:
    """Standard deviation along the least certain direction of a covariance (n, n)."""
    return float(np.sqrt(max(np.linalg.eigvalsh(covariance)[-1], 0.0)))


# ---- numbers


def number_of(
    label: str,
    value: float | None,
    unit: str,
    *,
    sigma: float | None = None,
    decimals: int = 3,
    limit: float | None = None,
    main: bool = False,
) -> Number:
    """A number with ± = 2 `sigma`, all in `unit`."""
    return Number(label, finite(value), unit, twice(sigma), decimals, limit, main)


def position_numbers(
    label: str, xyz_mm: ArrayLike, covariance_mm2: Array | None, *, decimals: int = 3, main: bool = False
) -> tuple[Number, ...]:
    """x, y, z of a point (3,) in mm, each with ± from its covariance (3, 3); `label` names point and frame."""
    sigmas = [None] * 3 if covariance_mm2 is None else np.sqrt(np.maximum(np.diag(covariance_mm2), 0.0)).tolist()
    return tuple(
        number_of(f"{label} {axis}", float(value), "mm", sigma=sigma, decimals=decimals, main=main)
        for axis, value, sigma in zip("xyz", np.asarray(xyz_mm, dtype=float), sigmas, strict=True)
    )


def euler_numbers(
    label: str, rotation: Array, covariance_rad2: Array | None, *, decimals: int = 4, main: bool = False
) -> tuple[Number, ...]:
    """Euler angles Z, Y', X'' in degrees; the covariance (3, 3) is of a rotation vector in the target frame."""
    angles = np.degrees(euler_zyx_from_rotation(rotation))
    sigmas: list[float | None] = [None] * 3
    if covariance_rad2 is not None:
        sigmas = np.degrees(np.sqrt(np.diag(euler_covariance(rotation, covariance_rad2)))).tolist()
    return tuple(
        number_of(f"{label} {axis}", float(value), "deg", sigma=sigma, decimals=decimals, main=main)
        for axis, value, sigma in zip(("Z", "Y'", "X''"), angles, sigmas, strict=True)
    )


def euler_covariance(rotation: Array, covariance_rad2: Array) -> Array:
    """(3, 3) covariance of the ZYX angles, rad^2; `covariance_rad2` is of a rotation vector in the target frame."""
    step = 1e-6
    columns = []
    for axis in np.eye(3):
        ahead, behind = (
            euler_zyx_from_rotation(rotation_from_rotvec(sign * step * axis) @ rotation) for sign in (1.0, -1.0)
        )
        columns.append(((ahead - behind + np.pi) % (2.0 * np.pi) - np.pi) / (2.0 * step))
    jacobian = np.column_stack(columns)
    return np.asarray(jacobian @ covariance_rad2 @ jacobian.T)


# ---- verdict and checks


def reasons_of(verdict: Verdict) -> tuple[ReasonView, ...]:
    """Why a verdict is what it is, each reason once."""
    found = {(str(reason.code), reason.message): None for reason in verdict.reasons}
    return tuple(ReasonView(code, message) for code, message in found)


def missing(message: str, code: str = "NOT_ENOUGH_POINTS") -> tuple[ReasonView, ...]:
    """What is still missing for a result; empty without a message."""
    return (ReasonView(code, message),) if message else ()


def check_of(held_out: HeldOut, unit: str = "mm") -> Check:
    """A check on data the fit has not seen, in mm or µm; `ok` is None while nothing was kept out."""
    factor = UM_PER_MM if unit == "µm" else 1.0
    count = len(held_out.errors_mm)
    value = finite(held_out.rms_mm)
    return Check(
        what=f"RMS error of the predicted {held_out.what}",
        value=None if value is None else factor * value,
        unit=unit,
        limit=factor * held_out.limit_mm,
        count=count,
        ok=None if value is None else value <= held_out.limit_mm,
    )


def limit_check(what: str, value: float | None, limit: float, unit: str, count: int = 1) -> Check:
    """A check of one value against its limit, both in `unit`; `ok` is None while there is no value."""
    number = finite(value)
    return Check(what, number, unit, limit, count, None if number is None else number <= limit)


# ---- rows


def with_worst_flagged(rows: Sequence[SampleRow], column: int) -> tuple[SampleRow, ...]:
    """Flags the included row with the largest number in a column as `worst`, unless it stands out already."""
    sizes = [_size(row, column) for row in rows]
    if not sizes or max(sizes) < 0.0:
        return tuple(rows)
    worst = int(np.argmax(sizes))
    return tuple(
        replace(row, flag="worst") if index == worst and not row.flag else row for index, row in enumerate(rows)
    )


def _size(row: SampleRow, column: int) -> float:
    cell = row.cells[column]
    if not row.included or row.use is Use.EXCLUDED or not isinstance(cell, float):
        return -1.0
    return abs(cell)


def progress_text(done: int, planned: int, things: str) -> str:
    """`12 of 20 scans`."""
    return f"{done} of {planned} {things}"


# ---- plots


def marks_by_use(
    rows: Iterable[tuple[Use, int, float, float | None]], names: Callable[[Use], str] = lambda use: use.value
) -> tuple[Marks, ...]:
    """Marks of samples, one series for each use; rows are (use, sample id, x, y), y None is left out."""
    found: dict[Use, list[tuple[int, float, float]]] = {}
    for use, sample_id, x, y in rows:
        number = finite(y)
        if number is not None:
            found.setdefault(use, []).append((sample_id, x, number))
    return tuple(
        Marks(
            np.array([x for _, x, _ in found[use]]),
            np.array([y for _, _, y in found[use]]),
            ROLE_OF_USE[use],
            names(use),
            tuple(sample_id for sample_id, _, _ in found[use]),
        )
        for use in Use
        if use in found
    )
