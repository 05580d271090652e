from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from devices.cell_plan import CellFileError, read_plan
from devices.sim import build_simulated_cell
from devices.sim.blade import BladeFileError
from devices.sim.build import DEFAULT_CELL


def test_the_cell_that_comes_with_the_program_covers_every_axis() -> None:
    plan = read_plan(DEFAULT_CELL)
    stage = np.array([[p.stage.x_mm, p.stage.y_mm, p.stage.z_mm, p.stage.theta_rad] for p in plan.stage_step])
    assert len(stage) >= 12
    assert np.all(np.ptp(stage, axis=0) > [100.0, 40.0, 60.0, np.deg2rad(40.0)])
    assert len(plan.base_step) >= 10
    turns = np.array([pose.base_from_flange[:3, :3] for pose in plan.base_step])
    cosines = (np.einsum("aij,bij->ab", turns, turns) - 1.0) / 2.0
    assert np.rad2deg(np.arccos(np.clip(cosines.min(), -1.0, 1.0))) > 60.0
    assert {pose.name for pose in plan.fine_step} == {"edge plate", "shroud"}
    assert np.array_equal(plan.fine_step[0].base_from_flange, plan.fine_step[1].base_from_flange)
    assert set(plan.grinders) == {"rough", "fine"}
    assert all(grinder.touch_angles_rad[0] == 0.0 for grinder in plan.grinders.values())
    assert len(plan.stylus.touches) >= 8


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("diameter_mm = 19.988", "", "diameter_mm"),
        ("contact_side = -1", "contact_side = 0", "contact_side"),
        ("x_mm = [-160.0, 160.0]", "x_mm = [160.0, -160.0]", "low end"),
        ("field_mm = [118.0, 78.0]", "field_mm = [118.0]", "2 numbers"),
        ("[ball]", "[ball", "cannot be read"),
        ("noise_mm = 0.035", "nois_mm = 0.035", "noise_mm"),
    ],
)
def test_an_unusable_cell_file_is_named_with_its_field(tmp_path: Path, old: str, new: str, message: str) -> None:
    file = tmp_path / "cell.toml"
    text = DEFAULT_CELL.read_text(encoding="utf-8")
    assert old in text
    file.write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(CellFileError, match=message) as caught:
        build_simulated_cell(file)
    assert "cell.toml" in str(caught.value)


def test_an_unknown_override_is_refused() -> None:
    with pytest.raises(CellFileError, match="no such truth setting"):
        build_simulated_cell(truth={"scanner.noize_mm": 0.0})


def test_a_missing_or_foreign_blade_file_is_refused(tmp_path: Path) -> None:
    with pytest.raises(BladeFileError, match="no such file"):
        build_simulated_cell(blade_step=tmp_path / "none.step")
    (tmp_path / "bad.step").write_text("not a blade", encoding="utf-8")
    simulated = build_simulated_cell(blade_step=tmp_path / "bad.step")
    with pytest.raises(BladeFileError, match="not a readable STEP file"):
        _ = simulated.world.blade
