"""Contacts, patterns and poses on analytic blades: each contact ends up on the wheel, square and on the right side."""

from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from core.error_surface import fit_error_surface
from core.errors import InputError
from core.path import (
    CellFrames,
    PatternSettings,
    Workspace,
    check_workspace,
    pattern_lines,
    plan_path,
    tool_from_contact,
    work_from_contact,
)


@dataclass(frozen=True)
class Tube:
    """A half tube about z: u turns about the axis, v climbs; the outward normal is radial."""

    radius_mm: float = 20.0
    length_mm: float = 100.0
    turn: int = 1

    def derivatives(self, u, v):
        angle = self.turn * np.pi * np.asarray(u)
        point = np.stack([self.radius_mm * np.cos(angle), self.radius_mm * np.sin(angle), self.length_mm * v], axis=-1)
        along_u = self.turn * np.pi * self.radius_mm * np.stack([-np.sin(angle), np.cos(angle), 0 * angle], axis=-1)
        return point, along_u, np.broadcast_to([0.0, 0.0, self.length_mm], point.shape)

    def normal(self, u, v):
        angle = self.turn * np.pi * np.asarray(u)
        return np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=-1)


def pose(rotvec, translation):
    matrix = np.eye(4)
    matrix[:3, :3] = Rotation.from_rotvec(rotvec).as_matrix()
    matrix[:3, 3] = translation
    return matrix


CELL = CellFrames(pose([0.3, -2.0, 0.4], [900, -300, 700]), pose([0.1, 0.2, -1.0], [5, -8, 140]), 60.0, 1)
PATTERN = PatternSettings("transverse", (0.05, 0.95), (0.1, 0.9), count=4)


def on_wheel(plan, stroke):
    """Contact frames of a stroke seen in {H}, by plain matrix chains."""
    chain = np.linalg.inv(plan.cell.base_from_tool) @ stroke.base_from_flange @ plan.cell.flange_from_work
    return chain @ stroke.work_from_contact


@pytest.mark.parametrize("turn", [1, -1])
def test_contact_frame_on_the_blade(turn):
    u, v = np.array([0.2, 0.7]), np.array([0.3, 0.6])
    frames = work_from_contact(Tube(turn=turn), u, v)
    np.testing.assert_allclose(frames[:, :3, 2], Tube(turn=turn).normal(u, v))
    np.testing.assert_allclose(frames[:, :3, 1], [[0, 0, 1], [0, 0, 1]], atol=1e-12)
    np.testing.assert_allclose(np.cross(frames[:, :3, 0], frames[:, :3, 1]), frames[:, :3, 2], atol=1e-12)
    np.testing.assert_allclose(frames[:, :3, 3], Tube(turn=turn).derivatives(u, v)[0])


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("span", [1, -1])
def test_contact_frame_on_the_wheel(side, span):
    frame = tool_from_contact(60.0, side, span)
    assert np.linalg.det(frame[:3, :3]) == pytest.approx(1.0)
    np.testing.assert_allclose(frame[:3, 2], [0, side, 0])
    np.testing.assert_allclose(frame[:3, 1], [0, 0, span])
    np.testing.assert_allclose(frame[:3, 3], [0, -60.0 * side, 0])


@settings(derandomize=True, deadline=None, max_examples=15)
@given(
    st.lists(st.floats(-3, 3), min_size=6, max_size=6),
    st.sampled_from([1, -1]),
    st.sampled_from([1, -1]),
    st.sampled_from(["transverse", "longitudinal"]),
)
def test_every_contact_is_presented_to_the_wheel(numbers, side, span, kind):
    cell = CellFrames(pose(numbers[:3], [900, 0, 500]), pose(numbers[3:], [10, 20, 30]), 60.0, side, span)
    plan = plan_path(Tube(), cell, PatternSettings(kind, (0.1, 0.9), (0.2, 0.8), count=3, step_mm=10.0))
    expected = tool_from_contact(60.0, side, span)
    for stroke in plan.strokes:
        seen = on_wheel(plan, stroke)
        np.testing.assert_allclose(seen, np.broadcast_to(expected, seen.shape), atol=1e-9)
        np.testing.assert_array_equal(stroke.base_from_flange, stroke.nominal_base_from_flange)
    assert not plan.compensated


def test_approach_is_clear_of_the_wheel_along_the_normal():
    plan = plan_path(Tube(), CELL, PATTERN, approach_mm=25.0)
    stroke = plan.strokes[0]
    back = np.linalg.inv(CELL.base_from_tool) @ stroke.approach_base_from_flange @ CELL.flange_from_work
    touch = (back @ stroke.work_from_contact[0])[:3, 3]
    # The blade stands 25 mm farther from the wheel's centre than its circumference.
    np.testing.assert_allclose(touch, [0, -85.0, 0], atol=1e-9)


def test_compensation_moves_contacts_outwards_by_the_error():
    u, v = (axis.ravel() for axis in np.meshgrid(np.linspace(0, 1, 20), np.linspace(0, 1, 15), indexing="ij"))
    surface = fit_error_surface(u, v, 0.3 + 0.2 * v)
    plan = plan_path(Tube(), CELL, PATTERN, error_surface=surface)
    for stroke in plan.strokes:
        np.testing.assert_allclose(stroke.error_mm, 0.3 + 0.2 * stroke.v, atol=1e-9)
        radius = np.hypot(stroke.work_from_contact[:, 0, 3], stroke.work_from_contact[:, 1, 3])
        np.testing.assert_allclose(radius, 20.3 + 0.2 * stroke.v, atol=1e-9)
        np.testing.assert_array_equal(stroke.work_from_contact[:, :3, :3], stroke.nominal_work_from_contact[:, :3, :3])
        # A proud blade is held farther away: presented with the design pose, it would push the head outwards.
        design = np.linalg.inv(CELL.base_from_tool) @ stroke.nominal_base_from_flange @ CELL.flange_from_work
        real = design @ stroke.work_from_contact
        np.testing.assert_allclose(real[:, 1, 3] + 60.0, stroke.error_mm, atol=1e-9)


def test_path_outside_the_measured_patch_is_refused_or_trimmed():
    u, v = (axis.ravel() for axis in np.meshgrid(np.linspace(0.2, 0.8, 20), np.linspace(0.3, 1, 15), indexing="ij"))
    surface = fit_error_surface(u, v, 0.1 * u)
    with pytest.raises(InputError, match=r"spans u 0.2 to 0.8, v 0.3 to 1 .*clip = true"):
        plan_path(Tube(), CELL, PATTERN, error_surface=surface)
    plan = plan_path(Tube(), CELL, PATTERN, error_surface=surface, clip=True)
    assert len(plan.strokes) == 3 and plan.trimmed_points > 0
    assert all(np.all((s.u >= 0.2) & (s.u <= 0.8) & (s.v >= 0.3)) for s in plan.strokes)
    below = PatternSettings("transverse", (0.05, 0.95), (0.0, 0.2), count=2)
    with pytest.raises(InputError, match="measured nowhere"):
        plan_path(Tube(), CELL, below, error_surface=surface, clip=True)


def test_serpentine_and_order():
    lines = pattern_lines(Tube(), PATTERN)
    assert [float(line[1][0]) for line in lines] == pytest.approx([0.1, 0.9 / 3 + 0.2 / 3, 0.9 * 2 / 3 + 0.1 / 3, 0.9])
    assert [line[0][0] < line[0][-1] for line in lines] == [True, False, True, False]
    one_way = pattern_lines(Tube(), PatternSettings("longitudinal", (0.1, 0.9), (0, 1), count=2, serpentine=False))
    assert all(line[1][0] == 0.0 and line[1][-1] == pytest.approx(1.0) for line in one_way)
    golden = (0.02817023, 0.21657314, 0.94663445)
    chosen = pattern_lines(Tube(), PatternSettings("transverse", (0, 1), (0.02, 0.95), positions=golden))
    assert [line[1][0] for line in chosen] == list(golden)


def test_sampling_keeps_step_and_chord():
    step = PatternSettings("transverse", (0, 1), (0, 1), count=1, step_mm=3.0, chord_tolerance_mm=None)
    u = pattern_lines(Tube(), step)[0][0]
    spacing = np.diff(u) * np.pi * 20.0
    assert spacing.max() <= 3.0 + 1e-3 and u.size == int(np.ceil(np.pi * 20.0 / 3.0)) + 1
    chord = PatternSettings("transverse", (0, 1), (0, 1), count=1, step_mm=50.0, chord_tolerance_mm=0.01)
    angles = np.diff(pattern_lines(Tube(), chord)[0][0]) * np.pi
    sagitta = 20.0 * (1.0 - np.cos(angles / 2.0))
    assert 0.005 < sagitta.max() <= 0.0105
    straight = PatternSettings("longitudinal", (0, 1), (0, 1), count=1, step_mm=50.0, chord_tolerance_mm=0.01)
    assert pattern_lines(Tube(), straight)[0][1].size == 3
    spaced = PatternSettings("transverse", (0, 1), (0, 1), spacing_mm=30.0)
    assert len(pattern_lines(Tube(), spaced)) == 5


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"kind": "diagonal"}, "pattern"),
        ({"count": None}, "exactly one"),
        ({"spacing_mm": 3.0}, "exactly one"),
        ({"count": 0}, "count"),
        ({"step_mm": 0.0}, "step_mm"),
        ({"u_range": (0.9, 0.1)}, "u_range"),
        ({"u_range": (0.5, 0.5)}, "no length"),
        ({"count": None, "positions": (1.5,)}, "positions"),
        ({"step_mm": 0.001, "chord_tolerance_mm": None}, "more than 20000"),
    ],
)
def test_unusable_patterns(change, message):
    with pytest.raises(InputError, match=message):
        pattern_lines(Tube(), PatternSettings(**{**PATTERN.__dict__, **change}))


def test_unusable_cells_and_degenerate_blades():
    for field, value, message in (
        ("wheel_radius_mm", 0.06, "wheel_radius_mm"),
        ("contact_side", 0, "contact_side"),
        ("base_from_tool", np.diag([2.0, 2.0, 2.0, 1.0]), "base_from_tool"),
        ("flange_from_work", np.full((4, 4), np.nan), "flange_from_work"),
    ):
        with pytest.raises(InputError, match=message):
            plan_path(Tube(), CellFrames(**{**CELL.__dict__, field: value}), PATTERN)
    with pytest.raises(InputError, match="approach_mm"):
        plan_path(Tube(), CELL, PATTERN, approach_mm=0.0)
    with pytest.raises(InputError, match=r"does not move|tangent plane"):
        plan_path(Tube(radius_mm=0.0), CELL, PATTERN)


def test_workspace():
    plan = plan_path(Tube(), CELL, PATTERN)
    poses = plan.robot_poses()
    low, high = poses[:, :3, 3].min(axis=0) - 1.0, poses[:, :3, 3].max(axis=0) + 1.0
    check_workspace(poses, Workspace(tuple(low), tuple(high), float(np.linalg.norm(poses[:, :3, 3], axis=1).max()) + 1))
    with pytest.raises(InputError, match=r"flange z = .* above"):
        check_workspace(poses, Workspace(greatest_mm=(high[0], high[1], high[2] - 5.0)))
    with pytest.raises(InputError, match=r"flange x = .* below"):
        plan_path(Tube(), CELL, PATTERN, workspace=Workspace(least_mm=(low[0] + 5.0, low[1], low[2])))
    with pytest.raises(InputError, match="reach"):
        plan_path(Tube(), CELL, PATTERN, workspace=Workspace(max_reach_mm=500.0))
