"""The step's plots: map, cross-section, leave-one-out errors, error left along the paths, head at its stop."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from beltgui.steps.error_surface.picture import SCALE_TITLE, scale_of_um
from beltgui.steps.error_surface.shown import Shown, ShownLine, maps_of, net_of
from beltgui.steps.error_surface.step import ErrorSurfaceOutcome
from beltgui.steps.head_rest import LIMIT_MM
from beltgui.steps.views.common import UM_PER_MM, K
from beltgui.viewmodel.plot import Band, Curve, LimitLine, Map, Marks, Plot, Series
from beltgui.viewmodel.scene import Role
from beltgui.viewmodel.step import Use

Array = NDArray[np.float64]
Pick = Callable[[ShownLine], NDArray[np.bool_]]
CURVE_POINTS = 400
U_LABEL, V_LABEL = "u, around the profile", "v, along the span"


def plots_of(shown: Shown) -> tuple[Plot, ...]:
    """The plots for what there is so far."""
    if not shown.counted:
        return ()
    plots: list[Plot | None] = [_map(shown), _section(shown)]
    if shown.outcome is not None:
        plots.append(_leave_one_out(shown, shown.outcome))
        plots.append(_left(shown, shown.outcome))
        plots.append(_head(shown.outcome))
    return tuple(plot for plot in plots if plot is not None)


def _map(shown: Shown) -> Plot:
    """Error over (u, v), with the points that did not go into it."""
    series: list[Series] = []
    if shown.outcome is not None:
        net, values = net_of(shown.bench), maps_of(shown.bench, shown.outcome.surface)[0]
        # A map's cells lie around its values.
        half_u, half_v = 0.5 * (net.u[1] - net.u[0]), 0.5 * (net.v[1] - net.v[0])
        series.append(Map(
            UM_PER_MM * values, (net.u[0] - half_u, net.u[-1] + half_u), (net.v[0] - half_v, net.v[-1] + half_v),
            scale_of_um(values),
        ))  # fmt: skip
    picks: tuple[tuple[str, Role, Pick], ...] = (
        ("probed", Role.INLIER, lambda line: _read(line, Use.FIT)),
        ("held out", Role.HELD_OUT, lambda line: _read(line, Use.HELD_OUT)),
        ("left out", Role.EXCLUDED, lambda line: _read(line, Use.EXCLUDED)),
        ("rejected", Role.OUTLIER, lambda line: line.rejected),
        ("missing", Role.ATTENTION, lambda line: ~np.isfinite(line.error_mm)),
    )
    for name, role, pick in picks:
        # Under the map's points the map itself could not be seen.
        if not (name == "probed" and shown.outcome is not None):
            series += _marks(shown.counted, pick, name, role)
    return Plot("map", "Error map", U_LABEL, V_LABEL, tuple(series))


def _marks(lines: tuple[ShownLine, ...], pick: Pick, name: str, role: Role) -> list[Series]:
    chosen = [pick(line) for line in lines]
    ids = tuple(line.sample.id for line, mask in zip(lines, chosen, strict=True) for _ in range(int(mask.sum())))
    if not ids:
        return []
    u = np.concatenate([line.u[mask] for line, mask in zip(lines, chosen, strict=True)])
    v = np.concatenate([line.v[mask] for line, mask in zip(lines, chosen, strict=True)])
    return [Marks(u, v, role, name, ids)]


def _read(line: ShownLine, use: Use) -> NDArray[np.bool_]:
    return np.isfinite(line.error_mm) if line.use is use else np.zeros(len(line.u), dtype=bool)


def _section(shown: Shown) -> Plot:
    """Measured points of the nearest line, the spline and its band."""
    grid_lines = [line for line in shown.counted if not line.is_check] or list(shown.counted)
    nearest = min(grid_lines, key=lambda line: abs(float(line.v[0]) - shown.settings.section_v))
    at = float(nearest.v[0])
    series: list[Series] = []
    if shown.outcome is not None:
        surface = shown.outcome.surface
        u = np.linspace(float(nearest.u.min()), float(nearest.u.max()), CURVE_POINTS)
        value, sigma = (UM_PER_MM * part(u, np.full(len(u), at)) for part in (surface.evaluate, surface.sigma_at))
        series += [
            Band(u, value - K * sigma, value + K * sigma, Role.FIT, "± of the surface (k = 2)"),
            Curve(u, value, Role.FIT, "error surface"),
        ]
    good = np.isfinite(nearest.error_mm) & ~nearest.rejected
    role = Role.EXCLUDED if nearest.use is Use.EXCLUDED else Role.INLIER
    for name, mask, of in (("measured", good, role), ("rejected", nearest.rejected, Role.OUTLIER)):
        if mask.any():
            ids = (nearest.sample.id,) * int(mask.sum())
            series.append(Marks(nearest.u[mask], UM_PER_MM * nearest.error_mm[mask], of, name, ids))
    return Plot("section", f"Section at v = {at:.3f} ({nearest.name})", U_LABEL, SCALE_TITLE, tuple(series))


def _leave_one_out(shown: Shown, outcome: ErrorSurfaceOutcome) -> Plot:
    """What each sample misses when it is predicted from all others; lines side by side."""
    series: list[Series] = []
    lines = [line for line in shown.counted if np.isfinite(line.deviation_mm).any()]
    for name, role, use, rejected in (
        ("used", Role.INLIER, Use.FIT, False),
        ("rejected", Role.OUTLIER, Use.FIT, True),
        ("held out", Role.HELD_OUT, Use.HELD_OUT, False),
        ("left out", Role.EXCLUDED, Use.EXCLUDED, False),
    ):
        x, y, ids = [], [], []
        for line in (line for line in lines if line.use is use):
            mask = np.isfinite(line.deviation_mm) & (line.rejected == rejected)
            x.append(line.v[mask])
            y.append(UM_PER_MM * line.deviation_mm[mask])
            ids += [line.sample.id] * int(mask.sum())
        if ids:
            series.append(Marks(np.concatenate(x), np.concatenate(y), role, name, tuple(ids)))
    sigma = outcome.surface.sigma_mm
    limits = () if sigma is None else tuple(
        LimitLine(sign * K * UM_PER_MM * sigma, "noise of a sample (k = 2)") for sign in (-1.0, 1.0)
    )  # fmt: skip
    return Plot("leave_one_out", "Leave-one-out", V_LABEL, "error of the prediction, µm", tuple(series), limits)


def _left(shown: Shown, outcome: ErrorSurfaceOutcome) -> Plot | None:
    """Dry-grind prediction: what is left on the nominal and on the compensated path, stroke after stroke."""
    program = outcome.programs.get(shown.settings.path)
    if program is None:
        return None
    begin, xs, errors, sigmas = 0.0, [], [], []
    for stroke in program.plan.strokes:
        steps = np.linalg.norm(np.diff(stroke.work_from_contact[:, :3, 3], axis=0), axis=1)
        x = begin + np.concatenate([[0.0], np.cumsum(steps)])
        gap = np.array([np.nan])
        xs += [x, x[-1:]]
        errors += [stroke.error_mm, gap]
        sigmas += [outcome.surface.sigma_at(stroke.u, stroke.v), gap]
        begin = float(x[-1])
    x, error, sigma = np.concatenate(xs), UM_PER_MM * np.concatenate(errors), UM_PER_MM * np.concatenate(sigmas)
    series: tuple[Series, ...] = (
        Band(x, -K * sigma, K * sigma, Role.PATH_COMPENSATED, "compensated, ± (k = 2)"),
        Curve(x, error, Role.PATH, "nominal path"),
        Curve(x, np.where(np.isfinite(error), 0.0, np.nan), Role.PATH_COMPENSATED, "compensated path"),
    )
    title = f"Error left, {program.name}"
    return Plot("error_left", title, "way of the contact over all strokes, mm", "predicted normal error, µm", series)


def _head(outcome: ErrorSurfaceOutcome) -> Plot:
    """The head's readings at its stop, as way of the wheel from the tool step's first reading."""
    rest = outcome.head_rest
    zero = rest.in_tool_step_rad[0] if rest.in_tool_step_rad else (rest.now_rad[0] if rest.now_rad else 0.0)
    series: list[Series] = []
    first = 1
    for name, role, angles in (
        ("tool step", Role.HELD_OUT, rest.in_tool_step_rad), ("around the probing", Role.FIT, rest.now_rad)
    ):  # fmt: skip
        if angles:
            x = np.arange(first, first + len(angles), dtype=float)
            series.append(Marks(x, UM_PER_MM * rest.radius_mm * (np.array(angles) - zero), role, name))
            first += len(angles)
    limit = UM_PER_MM * LIMIT_MM
    limits = (LimitLine(-limit, "limit"), LimitLine(limit, "limit"))
    return Plot("head", "Head at its stop", "reading", "way of the wheel, µm", tuple(series), limits)
