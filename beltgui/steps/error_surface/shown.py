"""What is drawn and listed of the step, put together once: its lines with their errors, its settings, its maps."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beltgui.session import Sample
from beltgui.steps.error_surface import probing
from beltgui.steps.error_surface.clamped import chosen_grinder
from beltgui.steps.error_surface.probing import Line, Probe
from beltgui.steps.error_surface.series import CHECK, STEP, Series, current_clamping
from beltgui.steps.error_surface.step import ErrorSurfaceOutcome, errors_of
from beltgui.steps.room import Bench
from beltgui.steps.views import drawing
from beltgui.viewmodel.step import Use
from core.error_surface import ErrorSurface
from core.path import AirfoilSurface

Array = NDArray[np.float64]
EXAGGERATION, LARGEST_EXAGGERATION = 50.0, 1000.0
# The largest compensation is drawn about so long.
COMPENSATION_MM = 15.0
# Net of the airfoil in the picture and of the map: fine enough to show what a grid of 129 x 40 points can say.
ACROSS, ALONG = 141, 81


@dataclass(frozen=True, eq=False)
class ShownLine:
    """A line that was probed.

    Attributes:
        sample: In the session.
        use: What it is used for.
        void: It belongs to an earlier clamping or to other frames and does not count any more.
        u: (N,).
        v: (N,).
        error_mm: (N,) normal error; NaN where no reading came.
        deviation_mm: (N,) leave-one-out error of a line of the grid, distance from the surface of any other; NaN while
            there is no surface.
        rejected: (N,) found to be wrong by the fit.
    """

    sample: Sample
    use: Use
    void: bool
    u: Array
    v: Array
    error_mm: Array
    deviation_mm: Array
    rejected: NDArray[np.bool_]

    @property
    def is_check(self) -> bool:
        """A line between the grid's nodes."""
        return self.sample.kind == CHECK

    @property
    def name(self) -> str:
        """As a person calls it."""
        number = int(self.sample.data["slot"]) + 1
        return f"check line {number}" if self.is_check else f"line {number}"

    @property
    def missing(self) -> int:
        """Points without a reading."""
        return int((~np.isfinite(self.error_mm)).sum())

    @property
    def rms_mm(self) -> float:
        """RMS of the deviations; NaN while there are none."""
        known = self.deviation_mm[np.isfinite(self.deviation_mm) & ~self.rejected]
        return float(np.sqrt(np.mean(known**2))) if len(known) else float("nan")


@dataclass(frozen=True, eq=False)
class Settings:
    """How it is shown; these never change a result.

    Attributes:
        grinder: Whose error surface it is (this one does).
        exaggeration: How many times the compensation is drawn.
        section_v: Height of the cross-section.
        path: Name of the program that is drawn.
    """

    grinder: str
    exaggeration: float
    section_v: float
    path: str


@dataclass(frozen=True, eq=False)
class Net:
    """The whole airfoil as a net, {W}.

    Attributes:
        u: (ACROSS,).
        v: (ALONG,).
        points: (ALONG * ACROSS, 3) mm, u running faster.
        normals: (ALONG * ACROSS, 3) outward.
        triangles: (M, 3).
    """

    u: Array
    v: Array
    points: Array
    normals: Array
    triangles: NDArray[np.int32]


@dataclass(frozen=True, eq=False)
class Shown:
    """Everything that the table, the picture and the plots are made of.

    Attributes:
        bench: Of the step.
        outcome: None before there is one.
        series: The probing that counts; None before it began.
        lines: In order of slots, those that count first.
        todo: Planned lines that are not there.
        planned: How many lines are planned.
        settings: How it is shown.
    """

    bench: Bench
    outcome: ErrorSurfaceOutcome | None
    series: Series | None
    lines: tuple[ShownLine, ...]
    todo: tuple[Line, ...]
    planned: int
    settings: Settings

    @property
    def counted(self) -> tuple[ShownLine, ...]:
        """Lines that are not void."""
        return tuple(line for line in self.lines if not line.void)


def shown_of(bench: Bench, outcome: ErrorSurfaceOutcome | None) -> Shown:
    """Put together what is shown.

    Raises:
        InputError: the grinder that was chosen is not one of the cell's.
    """
    settings = settings_of(bench, None if outcome is None else outcome.surface)
    grid = bench.blade.probing
    clamping = current_clamping(bench.session)
    series = None if clamping is None else clamping.series.get(settings.grinder)
    # Lines of another grinder wait until it is chosen again.
    void = [] if clamping is None else [s for s in clamping.void if s.data["grinder"] == settings.grinder]
    counted = [] if series is None else _lines(bench, series.samples, outcome)
    planned = probing.planned_lines(grid)
    return Shown(
        bench, outcome, series, (*counted, *(_void(bench, sample) for sample in void)),
        tuple(probing.missing_lines(series, grid)), len(planned), settings,
    )  # fmt: skip


def settings_of(bench: Bench, surface: ErrorSurface | None = None) -> Settings:
    """The settings, within what can be shown.

    Unless the person has said so, a surface's compensation is drawn so large that it is seen and stays near the blade.
    """
    grid, session = bench.blade.probing, bench.session
    usual = EXAGGERATION
    if surface is not None:
        usual = drawing.exaggeration(np.outer(surface.sample_error_mm[surface.used], [1.0, 0.0, 0.0]), COMPENSATION_MM)
    times = _number(session.setting(STEP, "show_exaggeration"), usual)
    section = _number(session.setting(STEP, "show_section"), 0.5 * (grid.v_min + grid.v_max))
    return Settings(
        chosen_grinder(bench),
        float(np.clip(times, 1.0, LARGEST_EXAGGERATION)),
        float(np.clip(section, grid.v_min, grid.v_max)),
        str(session.setting(STEP, "show_path", "transverse")),
    )


def _number(value: Any, default: float) -> float:
    usable = isinstance(value, int | float) and not isinstance(value, bool) and np.isfinite(value)
    return float(value) if usable else default


def _lines(bench: Bench, samples: Sequence[Sample], outcome: ErrorSurfaceOutcome | None) -> list[ShownLine]:
    """Lines that count; the surface's samples are those of the included lines, one after the other."""
    surface = None if outcome is None else outcome.surface
    rejected_rows = np.zeros(0, dtype=bool)
    if surface is not None:
        rejected_rows = np.isin(np.arange(len(surface.used)), surface.rejected)
    first = 0
    found = []
    for sample in samples:
        probe = _probe(sample)
        error = _errors(bench, sample, probe)
        use = Use.EXCLUDED if not sample.included else Use.HELD_OUT if sample.kind == CHECK else Use.FIT
        deviation, rejected = np.full(len(error), np.nan), np.zeros(len(error), dtype=bool)
        if surface is not None:
            rows = slice(first, first + len(error))
            fitted = use is Use.FIT and np.array_equal(surface.sample_u[rows], probe.u)
            if fitted:
                deviation, rejected = surface.leave_one_out_mm[rows], rejected_rows[rows]
                first += len(error)
            else:
                deviation = error - surface.evaluate(probe.u, probe.v)
        found.append(ShownLine(sample, use, False, probe.u, probe.v, error, deviation, rejected))
    return found


def _void(bench: Bench, sample: Sample) -> ShownLine:
    probe = _probe(sample)
    error = _errors(bench, sample, probe)
    return ShownLine(sample, Use.EXCLUDED, True, probe.u, probe.v, error, np.full(len(error), np.nan),
                     np.zeros(len(error), dtype=bool))  # fmt: skip


def _probe(sample: Sample) -> Probe:
    return Probe(*(np.array(sample.data[key], dtype=float) for key in ("u", "v", "angle_rad")))


def _errors(bench: Bench, sample: Sample, probe: Probe) -> Array:
    """Normal errors by the tool step's Rg; NaN while that step has no result."""
    name = sample.data["grinder"]
    if "tool" not in bench.found or name not in bench.found["tool"].wheels:
        return np.full(len(probe.u), np.nan)
    normal = np.array([0.0, float(bench.plan.grinders[name].contact_side), 0.0])
    return errors_of(probe, bench.found["tool"].wheels[name].radius_mm, normal)


def airfoil_of(bench: Bench) -> AirfoilSurface:
    """The airfoil's surface, {W}."""
    key = (STEP, "airfoil")
    if key not in bench.cache:
        bench.cache[key] = bench.model.spline_surface(bench.blade.airfoil)
    surface: AirfoilSurface = bench.cache[key]
    return surface


def net_of(bench: Bench) -> Net:
    """The airfoil's net; computed once."""
    key = (STEP, "net")
    if key not in bench.cache:
        surface = bench.model.spline_surface(bench.blade.airfoil)
        (low_u, high_u), (low_v, high_v) = surface.face_domain
        u, v = np.linspace(low_u, high_u, ACROSS), np.linspace(low_v, high_v, ALONG)
        all_u, all_v = (axis.ravel() for axis in np.meshgrid(u, v))
        corner = (np.arange(ALONG - 1)[:, None] * ACROSS + np.arange(ACROSS - 1)[None, :]).ravel()
        triangles = np.concatenate([
            np.column_stack([corner, corner + 1, corner + ACROSS + 1]),
            np.column_stack([corner, corner + ACROSS + 1, corner + ACROSS]),
        ])
        bench.cache[key] = Net(
            u, v, surface.point(all_u, all_v), surface.normal(all_u, all_v), triangles.astype(np.int32)
        )
    net: Net = bench.cache[key]
    return net


def maps_of(bench: Bench, surface: ErrorSurface) -> tuple[Array, Array]:
    """Error and its standard deviation over the net, (ALONG, ACROSS) mm, NaN outside the patch; once per surface."""
    key = (STEP, "maps")
    kept = bench.cache.get(key)
    if kept is None or kept[0] is not surface:
        net = net_of(bench)
        u, v = np.meshgrid(net.u, net.v)
        kept = bench.cache[key] = (surface, surface.evaluate(u, v), surface.sigma_at(u, v))
    return kept[1], kept[2]
