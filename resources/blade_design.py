"""Dimensions of the two blade types and the shape of their airfoils; mm and rad, frame W.

W: z along the span (radial in the turbine), x along the turbine's axis, y circumferential; z = 0 at the foot of the
airfoil. A profile is a camber line, its curvature largest in the middle, with a thickness laid off to both sides.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import make_interp_spline

Array = NDArray[np.float64]

PROFILE_POINTS = 81
CAMBER_STEPS = 2001
# Extra weight of turning against arc length when points are spread around the profile: the leading edge gets its share.
TURNING_LENGTH_MM = 6.0


@dataclass(frozen=True)
class Plate:
    """A sector of a ring about the turbine's axis: edge plate or shroud.

    Attributes:
        length_mm: Extent along x.
        width_mm: Extent along y.
        thickness_mm: Radial thickness.
        skew_rad: Turn of the two long sides about z; their normal is (sin, cos, 0) of it.
        offset_y_mm: Middle of the plate at x = 0.
    """

    length_mm: float
    width_mm: float
    thickness_mm: float
    skew_rad: float
    offset_y_mm: float


@dataclass(frozen=True)
class BladeDesign:
    """Everything that tells one blade type from another; pairs are (at the foot, at the tip).

    Attributes:
        name: Type name, also the product name in the STEP file.
        hub_radius_mm: Outer radius of the edge plate about the turbine's axis.
        span_mm: Radial length of the airfoil between edge plate and shroud.
        platform: Edge plate.
        shroud: Shroud.
        root_outline_mm: Right half of the root's cross-section as (y, z), top to bottom; extruded along x.
        root_length_mm: Extent of the root along x.
        chord_mm: Length of the camber line.
        thickness_mm: Largest thickness.
        stagger_rad: Angle of the chord against the turbine's axis.
        edge_radius_mm: Radius of the leading edge.
        trailing_edge_mm: Thickness at the trailing edge.
        curvature_ends: Camber curvature at both ends, 1/mm.
        curvature_middle: What is added to it in the middle, 1/mm.
        sections: Number of profiles along the span.
    """

    name: str
    hub_radius_mm: float
    span_mm: float
    platform: Plate
    shroud: Plate
    root_outline_mm: tuple[tuple[float, float], ...]
    root_length_mm: float
    chord_mm: tuple[float, float]
    thickness_mm: tuple[float, float]
    stagger_rad: tuple[float, float]
    edge_radius_mm: tuple[float, float]
    trailing_edge_mm: tuple[float, float]
    curvature_ends: tuple[float, float]
    curvature_middle: tuple[float, float]
    sections: int = 9


DR95 = BladeDesign(
    name="DR95", hub_radius_mm=688.0, span_mm=200.0,
    platform=Plate(74.0, 46.0, 12.0, np.radians(8.0), 0.0),
    shroud=Plate(62.0, 43.0, 12.0, np.radians(24.0), 0.0),
    root_outline_mm=((11.0, -6.0), (11.0, -19.0), (18.0, -25.0), (18.0, -31.0), (8.5, -40.0), (8.5, -45.0),
                     (13.5, -50.0), (13.5, -55.0), (6.0, -68.0)),
    root_length_mm=66.0,
    chord_mm=(62.0, 54.0), thickness_mm=(9.6, 6.4), stagger_rad=(np.radians(12.0), np.radians(37.0)),
    edge_radius_mm=(4.0, 2.9), trailing_edge_mm=(1.6, 1.2),
    curvature_ends=(1 / 260, 1 / 320), curvature_middle=(1 / 120, 1 / 165))

DR96 = BladeDesign(
    name="DR96", hub_radius_mm=702.0, span_mm=216.0,
    platform=Plate(78.0, 50.0, 13.0, np.radians(6.0), 0.0),
    shroud=Plate(66.0, 46.0, 12.0, np.radians(27.0), 0.0),
    root_outline_mm=((12.0, -6.0), (12.0, -20.0), (20.0, -27.0), (20.0, -34.0), (9.5, -44.0), (9.5, -49.0),
                     (15.0, -54.0), (15.0, -60.0), (7.0, -72.0)),
    root_length_mm=70.0,
    chord_mm=(66.0, 57.0), thickness_mm=(10.4, 6.8), stagger_rad=(np.radians(9.0), np.radians(39.0)),
    edge_radius_mm=(4.3, 3.1), trailing_edge_mm=(1.7, 1.3),
    curvature_ends=(1 / 270, 1 / 320), curvature_middle=(1 / 115, 1 / 155))

DESIGNS = (DR95, DR96)


def _thickness_coefficients(chord: float, thickness: float, edge_radius: float, trailing: float) -> Array:
    """Half thickness h(x) = a0 sqrt(x) + a1 x + .. + a4 x^4, x as share of the chord.

    a0 makes the leading edge's radius, the others the top (place and height) and the trailing edge (height and slope).
    """
    top, tail = 0.38, 1.6
    a0 = np.sqrt(2.0 * edge_radius * chord)
    slope = -tail * (thickness - trailing) / 2 / (1.0 - top)
    powers = np.arange(1, 5)
    rows = np.array([top**powers, powers * top ** (powers - 1), np.ones(4), powers])
    right = np.array([thickness / 2 - a0 * np.sqrt(top), -a0 / (2 * np.sqrt(top)), trailing / 2 - a0, slope - a0 / 2])
    return np.concatenate([[a0], np.linalg.solve(rows, right)])


def profile(design: BladeDesign, height: float, tau: Array) -> Array:
    """Points (N, 2) of the profile at `height` in [0, 1] of the span.

    Args:
        design: The blade type.
        height: 0 at the foot, 1 at the tip; slightly outside is allowed.
        tau: (N,) in [-1, 1]: -1 trailing edge on the pressure side, 0 leading edge, 1 trailing edge, suction side.
    """
    def at(pair: tuple[float, float]) -> float:
        return pair[0] + (pair[1] - pair[0]) * height

    chord = at(design.chord_mm)
    ends, middle = at(design.curvature_ends), at(design.curvature_middle)
    s = np.linspace(0.0, 1.0, CAMBER_STEPS)
    turning = -chord * (ends * s + middle * (1.0 - np.cos(np.pi * s)) / np.pi)
    heading = turning - np.interp(0.5, s, turning)
    direction = np.column_stack([np.cos(heading), np.sin(heading)])
    steps = (direction[1:] + direction[:-1]) / 2 * chord / (CAMBER_STEPS - 1)
    line = np.vstack([np.zeros(2), np.cumsum(steps, axis=0)])
    line -= line[CAMBER_STEPS // 2]
    x = tau**2
    a0, *rest = _thickness_coefficients(chord, at(design.thickness_mm), at(design.edge_radius_mm),
                                         at(design.trailing_edge_mm))
    half = a0 * tau + np.sign(tau) * sum(a * x**power for power, a in enumerate(rest, start=1))
    angle = make_interp_spline(s, heading, k=3)(x)
    points = make_interp_spline(s, line, k=3)(x) + half[:, None] * np.column_stack([-np.sin(angle), np.cos(angle)])
    stagger = at(design.stagger_rad)
    cos, sin = np.cos(stagger), np.sin(stagger)
    points = points @ np.array([[cos, -sin], [sin, cos]])
    return np.asarray(points - _centroid(points))


def _centroid(outline: Array) -> Array:
    """Centre of area (2,) of a closed outline (N, 2): the profiles are stacked on it."""
    following = np.roll(outline, -1, axis=0)
    cross = outline[:, 0] * following[:, 1] - following[:, 0] * outline[:, 1]
    return np.asarray(((outline + following) * cross[:, None]).sum(axis=0) / (3.0 * cross.sum()))


def airfoil_poles(design: BladeDesign, overlap_mm: float) -> tuple[Array, Array, Array]:
    """The airfoil as a bicubic C2 B-spline through its profiles.

    Args:
        design: The blade type.
        overlap_mm: How far the surface runs into edge plate and shroud.

    Returns:
        Poles (U, V, 3) mm, knots in u and knots in v (repeated at the ends as the degree 3 asks for), both on [0, 1].
        u runs from the trailing edge on the pressure side around the leading edge to the suction side, v up the span.
    """
    fine = np.linspace(-1.0, 1.0, 4001)
    middle = profile(design, 0.5, fine)
    step = np.diff(middle, axis=0)
    heading = np.unwrap(np.arctan2(step[:, 1], step[:, 0]))
    measure = np.linalg.norm(step, axis=1) + TURNING_LENGTH_MM * np.abs(np.gradient(heading))
    along = np.concatenate([[0.0], np.cumsum(measure)])
    u = np.linspace(0.0, 1.0, PROFILE_POINTS)
    tau = np.interp(u, along / along[-1], fine)
    heights = np.linspace(-overlap_mm, design.span_mm + overlap_mm, design.sections)
    points = np.stack([np.column_stack([profile(design, z / design.span_mm, tau), np.full(u.size, z)])
                       for z in heights], axis=1)
    v = np.linspace(0.0, 1.0, design.sections)
    around = make_interp_spline(u, points, k=3)
    upward = make_interp_spline(v, np.swapaxes(around.c, 0, 1), k=3)
    return np.swapaxes(upward.c, 0, 1), around.t, upward.t
