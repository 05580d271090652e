"""Lines over the airfoil: where they lie and at which points they are sampled."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.errors import InputError
from core.path.contact import AirfoilSurface

Array = NDArray[np.float64]
DENSE = 801
MOST_POINTS = 20000


@dataclass(frozen=True)
class PatternSettings:
    """A family of parallel lines.

    Attributes:
        kind: "transverse" (each line runs along u at a fixed v) or "longitudinal" (along v at a fixed u).
        u_range: First and last u.
        v_range: First and last v.
        count: Number of lines, equally spaced in the parameter; or
        spacing_mm: greatest distance between lines, measured on the middle of the range; or
        positions: the fixed parameters themselves.
        step_mm: Greatest distance between points of a line.
        chord_tolerance_mm: Points are closer where the chord would leave the line by more than this; None: never.
        serpentine: Every second line runs backwards.
    """

    kind: str
    u_range: tuple[float, float]
    v_range: tuple[float, float]
    count: int | None = None
    spacing_mm: float | None = None
    positions: tuple[float, ...] | None = None
    step_mm: float = 2.0
    chord_tolerance_mm: float | None = 0.01
    serpentine: bool = True


def pattern_lines(airfoil: AirfoilSurface, settings: PatternSettings) -> list[tuple[Array, Array]]:
    """The lines in working order, each as (u (n,), v (n,)).

    Raises:
        InputError: contradictory or unusable settings, or a pattern of more than 20000 points.
    """
    _check(settings)
    lines = []
    for number, position in enumerate(_positions(airfoil, settings)):
        u, v = _sampled(airfoil, settings, position)
        backwards = settings.serpentine and number % 2 == 1
        lines.append((u[::-1], v[::-1]) if backwards else (u, v))
        if sum(line[0].size for line in lines) > MOST_POINTS:
            raise InputError(f"The pattern has more than {MOST_POINTS} points. Choose a larger step_mm or spacing_mm.")
    return lines


def _check(settings: PatternSettings) -> None:
    if settings.kind not in ("transverse", "longitudinal"):
        raise InputError(f"pattern: expected 'transverse' or 'longitudinal', found '{settings.kind}'.")
    for name, limits in (("u_range", settings.u_range), ("v_range", settings.v_range)):
        if not np.all(np.isfinite(limits)) or limits[1] < limits[0]:
            raise InputError(f"{name}: expected [first, last] with first below last, found {list(limits)}.")
    running = settings.u_range if settings.kind == "transverse" else settings.v_range
    if running[0] == running[1]:
        raise InputError("The range along which the lines run has no length.")
    given = [name for name in ("count", "spacing_mm", "positions") if getattr(settings, name) is not None]
    if len(given) != 1:
        raise InputError(f"Give exactly one of count, spacing_mm and positions, found {given or 'none'}.")
    for name in ("spacing_mm", "step_mm", "chord_tolerance_mm"):
        value = getattr(settings, name)
        if value is not None and not (np.isfinite(value) and value >= 1e-3):
            raise InputError(f"{name}: expected a length of at least 0.001 mm, found {value:g}.")
    if settings.count is not None and settings.count < 1:
        raise InputError(f"count: expected at least 1 line, found {settings.count}.")
    if settings.count is not None and settings.count > MOST_POINTS:
        raise InputError(f"count: expected at most {MOST_POINTS} lines, found {settings.count}.")
    across = "v_range" if settings.kind == "transverse" else "u_range"
    first, last = getattr(settings, across)
    if first == last and settings.count is not None and settings.count > 1:
        raise InputError(
            f"count: {settings.count} lines need a {across} with a length, found {[first, last]}. Give count = 1."
        )
    if settings.positions is not None and len(settings.positions) == 0:
        raise InputError("positions: expected at least one parameter.")


def _positions(airfoil: AirfoilSurface, settings: PatternSettings) -> Array:
    """The fixed parameter of each line."""
    transverse = settings.kind == "transverse"
    across, along = (settings.v_range, settings.u_range) if transverse else (settings.u_range, settings.v_range)
    if settings.positions is not None:
        fixed = np.asarray(settings.positions, dtype=float)
        if np.any(~np.isfinite(fixed)) or fixed.min() < across[0] - 1e-9 or fixed.max() > across[1] + 1e-9:
            raise InputError(
                f"positions: {fixed.min():g} to {fixed.max():g} do not lie within {across[0]:g} to {across[1]:g}."
            )
        return fixed
    if settings.count is not None:
        return np.linspace(*across, settings.count) if settings.count > 1 else np.array([0.5 * sum(across)])
    assert settings.spacing_mm is not None
    parameter = np.linspace(*across, DENSE)
    middle = np.full(DENSE, 0.5 * sum(along))
    points = airfoil.derivatives(middle, parameter)[0] if transverse else airfoil.derivatives(parameter, middle)[0]
    length = _arc_length(points)
    number = int(np.ceil(length[-1] / settings.spacing_mm)) + 1
    return np.interp(np.linspace(0.0, length[-1], number), length, parameter)


def _sampled(airfoil: AirfoilSurface, settings: PatternSettings, position: float) -> tuple[Array, Array]:
    """Points along one line, as dense as step and chord ask for at each place."""
    transverse = settings.kind == "transverse"
    parameter = np.linspace(*(settings.u_range if transverse else settings.v_range), DENSE)
    fixed = np.full(DENSE, position)
    u, v = (parameter, fixed) if transverse else (fixed, parameter)
    points = airfoil.derivatives(u, v)[0]
    length = _arc_length(points)
    density = np.full(DENSE, 1.0 / settings.step_mm)
    if settings.chord_tolerance_mm is not None:
        # A chord of length h on curvature k leaves the curve by k h^2 / 8.
        density = np.maximum(density, np.sqrt(_curvature(points, length) / (8.0 * settings.chord_tolerance_mm)))
    steps = np.concatenate([[0.0], np.cumsum(0.5 * (density[1:] + density[:-1]) * np.diff(length))])
    number = max(int(np.ceil(steps[-1])), 1) + 1
    chosen = np.interp(np.linspace(0.0, steps[-1], number), steps, parameter)
    same = np.full(number, position)
    return (chosen, same) if transverse else (same, chosen)


def _arc_length(points: Array) -> Array:
    return np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])


def _curvature(points: Array, length: Array) -> Array:
    if length[-1] <= 0.0 or np.any(np.diff(length) <= 0.0):
        raise InputError("The airfoil's surface does not move along a line of the pattern.")
    tangent = np.gradient(points, length, axis=0)
    return np.asarray(np.linalg.norm(np.gradient(tangent, length, axis=0), axis=1))
