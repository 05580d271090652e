"""Two sessions side by side."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from beltgui.engine.messages import ComparedRow
from beltgui.session import Session
from beltgui.session.compare import compare
from beltgui.session.quantities import movements
from beltgui.steps.blocks import pose_block
from core.frames import PoseCovariance, inverse, perturbed, rigid, rotation_from_rotvec

WHERE = np.array([900.0, 100.0, 400.0])


def moved_by(rotvec_deg: list[float], shift_mm: list[float], sigma_rad: float = 0.0, sigma_mm: float = 0.0) -> Any:
    """A pose block, about its own origin away from a common place."""
    start = rigid(rotation_from_rotvec([0.3, -0.2, 1.0]), WHERE)
    matrix = perturbed(start, [*np.radians(rotvec_deg), *shift_mm], WHERE)
    covariance = np.diag([sigma_rad**2] * 3 + [sigma_mm**2] * 3)
    return pose_block(matrix, PoseCovariance(covariance, matrix[:3, 3]) if sigma_mm else None)


def rows(tmp_path: Path, here: Mapping[str, Any], there: Mapping[str, Any]) -> dict[tuple[str, str, str], ComparedRow]:
    """Compared rows of two sessions with one result for each step, by step, what and unit."""
    sessions = []
    for name, records in (("here", here), ("there", there)):
        session = Session.create(tmp_path / name, {})
        for step, record in records.items():
            session.put_result(step, record, ok=True)
        sessions.append(session)
    found = compare(*sessions)
    for session in sessions:
        session.close()
    return {(row.step, row.what, row.unit): row for row in found}


def test_poses_are_compared_by_shift_and_turn_with_their_chance(tmp_path: Path) -> None:
    here = {"base": {"base_from_measure": moved_by([0.0, 0.3, 0.4], [0.03, 0.0, 0.04], 1e-4, 0.02)}}
    there = {"base": {"base_from_measure": moved_by([0.0, 0.0, 0.0], [0.0, 0.0, 0.0], 1e-4, 0.02)}}
    found = rows(tmp_path, here, there)
    shift, turn = found["base", "base_from_measure", "mm"], found["base", "base_from_measure", "deg"]
    assert shift.moved == pytest.approx(0.05) and turn.moved == pytest.approx(0.5)
    assert shift.chance == pytest.approx(2 * np.sqrt(6) * 0.02)
    assert turn.chance == pytest.approx(np.degrees(2 * np.sqrt(6) * 1e-4))
    assert (shift.here, shift.there) == (None, None)


def test_the_chance_holds_the_lever_to_the_origin() -> None:
    block = moved_by([0.0, 0.0, 0.0], [0.0, 0.0, 0.0], 1e-4, 0.02)
    far = {**block, "covariance_about_mm": [WHERE[0] + 300.0, *WHERE[1:]]}
    (near_moved,) = movements("base", {"base_from_measure": block}, {"base_from_measure": block})
    (far_moved,) = movements("base", {"base_from_measure": far}, {"base_from_measure": far})
    assert near_moved.mm == far_moved.mm == 0.0 and not near_moved.beyond_chance()
    assert near_moved.chance_mm == pytest.approx(2 * np.sqrt(6) * 0.02)
    lever_mm = 300.0 * 1e-4
    assert far_moved.chance_mm == pytest.approx(2 * np.sqrt(2 * (3 * 0.02**2 + 2 * lever_mm**2)))


def test_every_step_has_its_numbers(tmp_path: Path) -> None:
    block = moved_by([0.0, 0.0, 0.0], [0.0, 0.0, 0.0])
    wheel = {"base_from_tool": block, "radius_mm": 80.0, "radius_sigma_mm": 0.03}
    records = {
        "ball": {"stage": {"measure_from_scanner": block}, "held_out": {"rms_mm": 0.02}},
        "base": {
            "base_from_measure": block,
            "ball_in_flange_mm": [1.0, 2.0, 2.0],
            "ball_sigma_mm": [0.01] * 3,
            "held_out": {"rms_mm": 0.1},
        },
        "rough": {"measure_from_work": block},
        "fine": {"measure_from_work": block, "flange_from_work": block, "half_split_mm": [0.01, None, 0.03]},
        "tool": {
            "stylus": {"tip_in_flange_mm": [0.0, 0.0, 100.0]},
            "wheels": {"rough": wheel},
            "cone_held_out": {"rms_mm": 0.04},
            "shafts_held_out": {"rough": {"rms_mm": 0.05}},
        },
        "error_surface": {"held_out": {"rms_mm": None}, "leave_one_out_rms_mm": 0.006},
    }
    other = {**records, "tool": {**records["tool"], "stylus": {"tip_in_flange_mm": [0.0, 0.3, 100.4]}}}
    other["tool"]["wheels"] = {"rough": {**wheel, "radius_mm": 80.5, "radius_sigma_mm": 0.04}, "fine": wheel}
    found = rows(tmp_path, other, records)
    assert {key for key, row in found.items() if row.moved and row.moved > 1e-9} == {
        ("tool", "tip_in_flange", "mm"), ("tool", "head radius (rough)", "mm")}  # fmt: skip
    assert found["tool", "tip_in_flange", "mm"].moved == pytest.approx(0.5)
    radius = found["tool", "head radius (rough)", "mm"]
    assert (radius.here, radius.there, radius.moved) == (80.5, 80.0, 0.5)
    assert radius.chance == pytest.approx(0.1)
    for step, what, value in (
        ("ball", "held-out RMS", 0.02), ("base", "held-out RMS", 0.1), ("fine", "held-out, two halves", 0.03),
        ("tool", "held-out RMS (cone)", 0.04), ("tool", "held-out RMS (rough)", 0.05),
        ("error_surface", "leave-one-out RMS", 0.006),
    ):  # fmt: skip
        row = found[step, what, "mm"]
        assert (row.here, row.there, row.moved) == (value, value, 0.0)
    assert ("error_surface", "held-out RMS", "mm") not in found
    assert found["base", "ball_in_flange", "mm"].chance == pytest.approx(2 * np.sqrt(6) * 0.01)
    for unit in ("mm", "deg"):
        assert found["tool", "base_from_tool (fine)", unit].moved is None
        assert found["fine", "flange_from_work", unit].moved == pytest.approx(0.0, abs=1e-9)
        assert found["fine", "flange_from_work", unit].chance is None


def test_what_one_session_lacks_is_listed_without_a_difference(tmp_path: Path) -> None:
    block = moved_by([0.0, 0.0, 0.0], [0.0, 0.0, 0.0])
    found = rows(tmp_path, {}, {"ball": {"stage": {"measure_from_scanner": block}, "held_out": {"rms_mm": 0.02}}})
    assert set(found) == {("ball", "measure_from_scanner", "mm"), ("ball", "measure_from_scanner", "deg"),
                          ("ball", "held-out RMS", "mm")}  # fmt: skip
    assert all(row.moved is None for row in found.values())
    assert found["ball", "held-out RMS", "mm"].there == 0.02
    assert found["ball", "held-out RMS", "mm"].here is None


def test_two_sessions_without_results_have_nothing_to_compare(tmp_path: Path) -> None:
    assert rows(tmp_path, {}, {}) == {}


def test_a_turn_is_measured_where_the_arc_cosine_would_not_see_it() -> None:
    start = moved_by([0.0, 0.0, 0.0], [0.0, 0.0, 0.0])
    turned = moved_by([1e-7, 0.0, 0.0], [0.0, 0.0, 0.0])
    (movement,) = movements("base", {"base_from_measure": start}, {"base_from_measure": turned})
    assert movement.deg == pytest.approx(1e-7, rel=1e-3)
    assert np.allclose(inverse(np.array(start["matrix"])) @ np.array(turned["matrix"]), np.eye(4), atol=1e-8)
