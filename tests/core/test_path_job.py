"""The job file: every key is checked and named."""

import json
import tomllib
from pathlib import Path

import numpy as np
import pytest

from core.error_surface import fit_error_surface
from core.errors import InputError
from core.path import path_job_from_dict
from core.path.job import KEYS

JOB = """
cad = "blade.step"
airfoil = "AIRFOIL"
error_surface = "surface.json"
base_from_tool = "tool.json"
flange_from_work = [[1, 0, 0, 5], [0, 1, 0, 6], [0, 0, 1, 7], [0, 0, 0, 1]]
wheel_radius_mm = 60.0
contact_side = 1
pattern = "transverse"
spacing_mm = 10.0
u_range = [0.02, 0.98]
v_range = [0.03, 0.94]
step_mm = 2
speed_mm_s = 40
date = 2031-02-03
max_reach_mm = 1300
program = "path.script"
"""


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "blade.step").write_text("ISO-10303-21;")
    matrix = np.eye(4)
    matrix[:3, 3] = [100, 200, 300]
    (tmp_path / "tool.json").write_text(
        json.dumps({"base_from_tool": {"matrix": matrix.tolist()}, "verdict": {"ok": True, "reasons": []}})
    )
    u, v = (axis.ravel() for axis in np.meshgrid(np.linspace(0, 1, 6), np.linspace(0, 1, 6), indexing="ij"))
    (tmp_path / "surface.json").write_text(json.dumps(fit_error_surface(u, v, u * 0.1).to_json_dict()))
    return tmp_path


def test_complete_job(folder):
    job = path_job_from_dict(tomllib.loads(JOB), folder)
    assert job.cad == folder / "blade.step" and job.airfoil == "AIRFOIL"
    assert job.error_surface.evaluate(0.5, 0.5) == pytest.approx(0.05)
    np.testing.assert_array_equal(job.cell.base_from_tool[:3, 3], [100, 200, 300])
    np.testing.assert_array_equal(job.cell.flange_from_work[:3, 3], [5, 6, 7])
    assert job.pattern.spacing_mm == 10.0 and job.pattern.count is None and job.pattern.serpentine
    assert job.program == folder / "path.script" and job.program_settings.date == "2031-02-03"
    assert job.workspace.max_reach_mm == 1300.0
    assert {path.name for path in job.files} == {"blade.step", "surface.json", "tool.json"}


def test_the_documented_example_is_complete_and_right(folder):
    page = (Path(__file__).parents[2] / "docs" / "steps" / "path.md").read_text(encoding="utf-8")
    example = page.split("```toml")[1].split("```")[0]
    for old, new in (("dr95.step", "blade.step"), ("errors.json", "surface.json")):
        example = example.replace(old, new)
    job = path_job_from_dict(tomllib.loads(example), folder)
    assert all(key in example for key in KEYS)
    assert job.program_settings.max_turn_rad_s == pytest.approx(1.0, abs=0.01)


def test_blade_in_the_gripper_from_the_calibration_chain(folder):
    data = tomllib.loads(JOB)
    del data["flange_from_work"]
    rng = np.random.default_rng(0)
    poses = []
    for key in ("base_from_flange_at_scan", "base_from_measure", "measure_from_work"):
        q = np.linalg.qr(rng.normal(size=(3, 3)))[0]
        matrix = np.eye(4)
        matrix[:3, :3] = q * np.sign(np.linalg.det(q))
        matrix[:3, 3] = rng.normal(size=3) * 100
        data[key] = matrix.tolist()
        poses.append(matrix)
    job = path_job_from_dict(data, folder)
    np.testing.assert_allclose(job.cell.flange_from_work, np.linalg.inv(poses[0]) @ poses[1] @ poses[2], atol=1e-9)
    with pytest.raises(InputError, match="not both"):
        path_job_from_dict({**data, "flange_from_work": np.eye(4).tolist()}, folder)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"speed": 3}, r"speed: unknown key.*speed_mm_s"),
        ({"cad": "none.step"}, "cad: there is no file"),
        ({"cad": 3}, "cad: expected text"),
        ({"airfoil": 2.5}, "airfoil"),
        ({"wheel_radius_mm": "60"}, "wheel_radius_mm: expected a number"),
        ({"contact_side": 1.0}, "contact_side: expected a whole number"),
        ({"u_range": [0.1]}, "u_range: expected a list of 2 numbers"),
        ({"clip": "yes"}, "clip: expected true or false"),
        ({"positions": ["a"]}, "positions"),
        ({"base_from_tool": "blade.step"}, "base_from_tool: .* is not JSON"),
        ({"base_from_tool": "empty.json"}, "neither 'base_from_tool' nor 'matrix'"),
        ({"base_from_tool": "rejected.json"}, "rejected result"),
        ({"error_surface": "empty.json"}, "Error surface: the field"),
        ({"flange_from_work": [[1, 0], [0, 1]]}, "flange_from_work: expected a 4x4"),
        ({"workspace_least_mm": [0, 0]}, "workspace_least_mm"),
    ],
)
def test_wrong_keys_are_named(folder, change, message):
    (folder / "empty.json").write_text("{}")
    (folder / "rejected.json").write_text(json.dumps({"matrix": np.eye(4).tolist(), "verdict": {"ok": False}}))
    with pytest.raises(InputError, match=message):
        path_job_from_dict({**tomllib.loads(JOB), **change}, folder)


@pytest.mark.parametrize("key", ["cad", "airfoil", "base_from_tool", "flange_from_work", "wheel_radius_mm",
                                 "contact_side", "pattern", "u_range", "v_range"])  # fmt: skip
def test_missing_keys_are_named(folder, key):
    data = tomllib.loads(JOB)
    del data[key]
    with pytest.raises(InputError, match=f"{key}: missing"):
        path_job_from_dict(data, folder)
