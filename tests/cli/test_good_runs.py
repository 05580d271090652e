"""Each command on good data: exit 0, the contract's fields, and numbers against the simulated truth."""

import hashlib
import json
import re
import stat
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from beltgui import __version__
from tests.cli import sessions
from tests.cloud_files import ply_bytes, text_bytes, write

ROOT = Path(__file__).parents[2]
STEP = ROOT / "resources/blades/dr95.step"


def angle_between(a, b):
    return np.linalg.norm(a[:3, :3] @ b[:3, :3].T - np.eye(3)) / np.sqrt(2)


def check_pose(block, truth, *, mm, rad):
    matrix = np.array(block["matrix"])
    assert np.linalg.norm(matrix[:3, 3] - truth[:3, 3]) < mm
    assert angle_between(matrix, truth) < rad
    assert block["translation_mm"] == [row[3] for row in block["matrix"][:3]]
    np.testing.assert_allclose(sessions.turn("ZYX", *block["euler_zyx_deg"]), matrix[:3, :3], atol=1e-9)
    covariance = np.array(block["covariance"])
    assert covariance.shape == (6, 6)
    assert np.linalg.eigvalsh(covariance)[0] > -1e-15
    assert len(block["covariance_about_mm"]) == 3


def test_common_fields_and_out(tmp_path, beltcal):
    path = sessions.save(tmp_path / "obs.json", sessions.base_observations())
    out = tmp_path / "base.json"
    run = beltcal("base", path, "--out", out)
    assert (run.code, run.err) == (0, "")
    record = run.record
    assert record["command"] == "base"
    assert record["software"] == __version__
    assert record["inputs"] == [{"path": str(path), "sha256": hashlib.sha256(path.read_bytes()).hexdigest()}]
    assert record["verdict"] == {"ok": True, "reasons": []}
    assert out.read_text() == run.out
    assert stat.S_IMODE(out.stat().st_mode) & 0o400
    assert {p.name for p in tmp_path.iterdir()} == {"obs.json", "base.json"}


def test_version_is_the_projects():
    assert f'version = "{__version__}"' in (ROOT / "pyproject.toml").read_text()


def test_base(tmp_path, beltcal):
    run = beltcal("base", sessions.save(tmp_path / "obs.json", sessions.base_observations()))
    record = run.record
    # 9 poses, 0.02 mm per axis, lever arms about 200 mm: 5 sigma of about 0.03 mm each.
    check_pose(record["base_from_measure"], sessions.BASE_FROM_MEASURE, mm=0.3, rad=5e-4)
    np.testing.assert_allclose(record["ball_in_flange_mm"], sessions.BALL_IN_FLANGE, atol=0.15)
    assert 0.005 < record["rms_mm"] < 0.06
    assert np.array(record["residuals_mm"]).shape == (9, 3)
    assert record["condition"] > 1
    assert isinstance(record["weakest_direction"], str)


def test_base_on_the_papers_table(beltcal):
    record = beltcal("base", ROOT / "docs/examples/table1.json").record
    truth = sessions.rigid(sessions.turn("ZYX", 1, 1, 1).T, [-1180.0, -1695.0, 980.0])
    check_pose(record["base_from_measure"], truth, mm=0.0085, rad=1e-5)
    np.testing.assert_allclose(record["ball_in_flange_mm"], [86, -165, 35], atol=0.006)
    assert np.abs(record["residuals_mm"]).max() < 6e-4


def test_ball(tmp_path, beltcal):
    points = sessions.ball_scan()
    points[:7] = 0.0
    path = write(tmp_path / "scan.ply", ply_bytes(points, "binary_little_endian"))
    run = beltcal("ball", path, "--diameter", "19.988", "--fix-diameter")
    record = run.record
    assert run.code == 0
    assert "7 of 5000 points" in run.err
    np.testing.assert_allclose(record["center_mm"], [12.0, -8.0, 240.0], atol=0.004)
    assert record["diameter_mm"] == 19.988
    assert 0.018 < record["sigma_mm"] < 0.022
    assert record["points"] == 4993
    assert abs(record["inliers"] - 3993) < 80
    assert np.array(record["covariance_mm2"]).shape == (3, 3)
    assert 0.2 < record["coverage"] < 0.5
    free = beltcal("ball", write(tmp_path / "scan.xyz", text_bytes(points))).record
    assert abs(free["diameter_mm"] - 19.988) < 0.02


def test_stage(tmp_path, beltcal):
    record = beltcal("stage", sessions.save(tmp_path / "obs.json", sessions.stage_observations())).record
    truth = sessions.stage_truth()
    check_pose(record["measure_from_scanner"], truth.measure_from_scanner, mm=0.02, rad=3e-4)
    np.testing.assert_allclose(record["axes"], truth.axes, atol=3e-4)
    np.testing.assert_allclose(record["rotary_axis"]["direction"], truth.rotary_direction, atol=5e-4)
    np.testing.assert_allclose(record["squareness_deg"], truth.squareness_deg, atol=0.02)
    assert np.array(record["residuals_mm"]).shape == (24, 3)
    assert record["rms_mm"] < 0.02


def test_stylus(tmp_path, beltcal):
    run = beltcal("stylus", sessions.save(tmp_path / "obs.json", sessions.stylus_observations()))
    assert run.code == 0
    np.testing.assert_allclose(run.record["tip_in_flange_mm"], sessions.TIP_IN_FLANGE, atol=0.1)
    np.testing.assert_allclose(run.record["pivot_in_base_mm"], sessions.PIVOT_IN_BASE, atol=0.1)
    assert 0.005 < run.record["rms_mm"] < 0.06
    assert run.record["condition"] > 1


@pytest.mark.parametrize("known", [True, False])
def test_tool(tmp_path, beltcal, known):
    data = sessions.wheel_touches(angles_deg=(0, 15, 30, -15, -30, 45, -45), shaft_offset_mm=12.5)
    data["shaft_offset_mm"] = 12.5
    if known:
        data["radius_mm"] = sessions.WHEEL_RADIUS_ABOUT_HEAD
    run = beltcal("tool", sessions.save(tmp_path / "obs.json", data))
    record = run.record
    assert run.code == 0, record["verdict"]
    check_pose(record["base_from_tool"], sessions.BASE_FROM_TOOL, mm=0.08, rad=1e-3)
    assert abs(record["radius_mm"] - sessions.WHEEL_RADIUS_ABOUT_HEAD) < (1e-12 if known else 0.1)
    np.testing.assert_allclose(record["head_axis"]["direction"], sessions.BASE_FROM_TOOL[:3, 2], atol=1e-3)
    assert record["rms_mm"] < 0.05


def test_rough_from_pairs(tmp_path, beltcal):
    run = beltcal("rough", sessions.save(tmp_path / "pairs.json", sessions.rough_pairs()))
    assert run.code == 0
    check_pose(run.record["measure_from_work"], sessions.MEASURE_FROM_WORK, mm=1.5, rad=0.02)
    assert np.array(run.record["residuals_mm"]).shape == (5, 3)


@pytest.fixture(scope="module")
def blade_scan(tmp_path_factory):
    return write(tmp_path_factory.mktemp("scan") / "blade.ply",
                 ply_bytes(sessions.blade_points(STEP, 12_000), "binary_little_endian"))


def test_rough_automatic(blade_scan, beltcal):
    run = beltcal("rough", "--auto", "--cad", STEP, "--scan", blade_scan)
    assert run.code == 0
    check_pose(run.record["measure_from_work"], sessions.MEASURE_FROM_WORK, mm=0.05, rad=5e-4)
    assert run.record["residuals_mm"]


def test_fine_with_faces_by_name_and_id(blade_scan, tmp_path, beltcal):
    start = sessions.MEASURE_FROM_WORK.copy()
    start[:3, :3] = start[:3, :3] @ sessions.turn("XYZ", 1.0, -0.8, 0.6)
    start[:3, 3] += [1.2, -0.8, 0.9]
    pose = sessions.save(tmp_path / "start.json", {"measure_from_work": {"matrix": start.tolist()},
                                                   "verdict": {"ok": False, "reasons": []}})
    run = beltcal("fine", "--cad", STEP, "--scan", blade_scan, "--start", pose, "--faces", "S2,21,S4,S5,S6")
    record = run.record
    assert run.code == 0
    assert "rejected" in run.err
    # 0.03 mm over some thousand points: micrometres at the centre, 20 µrad about it, times 320 mm to the origin.
    check_pose(record["measure_from_work"], sessions.MEASURE_FROM_WORK, mm=0.05, rad=2e-4)
    assert {face["name"] for face in record["faces"]} == {"S2", "S3", "S4", "S5", "S6"}
    assert all(face["points"] > 50 and face["type"] in ("plane", "cylinder") for face in record["faces"])
    assert 0.027 < record["rms_mm"] < 0.034
    assert record["iterations"] >= 1


def test_faces(beltcal):
    run = beltcal("faces", STEP)
    assert run.code == 0
    faces = run.record["faces"]
    assert [face["id"] for face in faces] == list(range(1, len(faces) + 1))
    assert {"plane", "cylinder", "bspline"} <= {face["type"] for face in faces}
    for face in faces:
        assert face["area_mm2"] > 0
        assert face["usable"] == (face["why_not"] is None)


def test_error_surface_and_evaluation(tmp_path, beltcal):
    u, v = sessions.grid()
    samples = sessions.samples_csv(tmp_path / "s.csv", u, v, sessions.error_at(u, v).tolist())
    points = tmp_path / "p.csv"
    points.write_text("u,v\n0.5,0.5\n0.33,0.71\n0.5,1.5\n")
    run = beltcal("error-surface", samples, "--evaluate", points)
    record = run.record
    assert record["degrees"] == [3, 3]
    assert np.array(record["control_points_mm"]).shape == (12, 14)
    assert record["rejected"] == []
    assert len(record["leave_one_out_mm"]) == 12 * 14
    np.testing.assert_allclose(record["error_mm"][:2], sessions.error_at(np.array([0.5, 0.33]), np.array([0.5, 0.71])),
                               atol=0.02)
    assert record["error_mm"][2] is None
    assert len(record["inputs"]) == 2


def test_error_surface_smooth_rejects_a_bounce(tmp_path, beltcal):
    u, v = sessions.grid(14, 14)
    rng = np.random.default_rng(3)
    error = (sessions.error_at(u, v) + rng.normal(0, 0.01, u.size)).tolist()
    error[137] += 0.9
    error[180] = ""
    run = beltcal("error-surface", sessions.samples_csv(tmp_path / "s.csv", u, v, error), "--smooth")
    assert [entry["index"] for entry in run.record["rejected"]] == [137]
    assert run.record["rejected"][0]["line"] == 139
    assert run.record["missing"] == 1


def test_error_surface_from_head_angles(tmp_path, beltcal):
    u, v = sessions.grid()
    radius, normal = 160.0, np.array([0.2, 0.95, 0.1]) / np.linalg.norm([0.2, 0.95, 0.1])
    angle = np.linspace(-0.3, 0.4, u.size)
    rows = "".join(f"{a},{b},{c},{normal[0]},{normal[1]},{normal[2]}\n" for a, b, c in zip(u, v, angle, strict=True))
    samples = tmp_path / "s.csv"
    samples.write_text("u,v,angle_deg,nx,ny,nz\n" + rows)
    tool = sessions.save(tmp_path / "tool.json", {"radius_mm": radius, "verdict": {"ok": True, "reasons": []}})
    record = beltcal("error-surface", samples, "--tool", tool).record
    a = np.radians(angle)
    expected = radius * (normal[0] * (np.cos(a) - 1) + normal[1] * np.sin(a))
    np.testing.assert_allclose(record["samples"]["error_mm"], expected, atol=1e-9)


def test_path(tmp_path, beltcal):
    job = sessions.path_job(tmp_path, STEP)
    surface = tmp_path / "surface.json"
    assert beltcal("error-surface", tmp_path / "samples.csv", "--out", surface).code == 0
    run = beltcal("path", "--job", job, "--out", tmp_path / "path.json")
    record = run.record
    assert run.code == 0
    assert len(record["strokes"]) == 3
    wheel_contact = []
    flange_from_work = sessions.rigid(sessions.turn("ZYX", 10.0, 5.0, -3.0), [1.0, -2.0, 128.0])
    for stroke in record["strokes"]:
        nominal, compensated = np.array(stroke["nominal_work_from_contact"]), np.array(stroke["work_from_contact"])
        expected = 0.4 * np.cos(3 * np.array(stroke["v"]))
        np.testing.assert_allclose(stroke["error_mm"], expected, atol=2e-3)
        shift = np.einsum("ni,ni->n", compensated[:, :3, 3] - nominal[:, :3, 3], nominal[:, :3, 2])
        np.testing.assert_allclose(shift, expected, atol=2e-3)
        flange = np.array(stroke["base_from_flange"])
        in_tool = np.linalg.inv(sessions.BASE_FROM_TOOL) @ flange @ flange_from_work @ compensated
        wheel_contact.append(in_tool[:, :3, 3])
    # Every contact of the blade comes to one point of the wheel, at its radius from the shaft.
    wheel_contact = np.concatenate(wheel_contact)
    np.testing.assert_allclose(wheel_contact, np.broadcast_to(wheel_contact[0], wheel_contact.shape), atol=1e-9)
    assert abs(np.hypot(*wheel_contact[0, :2]) - 60.0) < 1e-9
    program = tmp_path / "blade.script"
    assert record["program"]["path"] == str(program)
    assert record["program"]["sha256"] == hashlib.sha256(program.read_bytes()).hexdigest()
    moves = re.findall(r"movel\(p\[([^]]+)\]", program.read_text())
    first = np.array([float(word) for word in moves[1].split(",")])
    planned = np.array(record["strokes"][0]["base_from_flange"])[0]
    np.testing.assert_allclose(first[:3] * 1000, planned[:3, 3], atol=1e-3)
    assert {Path(entry["path"]).name for entry in record["inputs"]} == {"job.toml", "surface.json", "tool.json",
                                                                        "dr95.step"}


@pytest.mark.parametrize("words", [
    ["base", "table1.json"], ["rough", "pairs.json"], ["stylus", "stylus.json"], ["tool", "wheel.json"],
    ["stage", "stage.json"], ["error-surface", "samples.csv", "--evaluate", "points.csv"],
])
def test_examples_of_the_documentation(beltcal, monkeypatch, words):
    monkeypatch.chdir(ROOT / "docs/examples")
    run = beltcal(*words)
    assert (run.code, run.err) == (0, "")


def test_a_rejected_result_is_exit_1_and_still_written(tmp_path, beltcal):
    path = sessions.save(tmp_path / "obs.json", sessions.base_observations(sigma_mm=3.0))
    out = tmp_path / "out.json"
    run = beltcal("base", path, "--out", out)
    assert run.code == 1
    assert run.record["verdict"]["reasons"][0]["code"]
    assert json.loads(out.read_text())["verdict"]["ok"] is False


def test_limits_file_replaces_the_defaults(tmp_path, beltcal):
    path = sessions.save(tmp_path / "obs.json", sessions.base_observations())
    limits = tmp_path / "limits.toml"
    limits.write_text("[base]\nrms_mm = 0.001\n[ball]\nsigma_mm = 1.0\n")
    run = beltcal("base", path, "--limits", limits)
    assert run.code == 1
    assert "0.001 mm" in run.record["verdict"]["reasons"][0]["message"]


def test_a_failed_fit_has_no_pose(tmp_path, beltcal):
    observations = sessions.base_observations()
    for row in observations["observations"]:
        row["base_from_flange"] = [[*r[:3], r[3] + 1e-4 * i] for i, r in
                                   enumerate(observations["observations"][0]["base_from_flange"][:3])] + [[0, 0, 0, 1]]
    run = beltcal("base", sessions.save(tmp_path / "obs.json", observations), "--out", tmp_path / "out.json")
    assert (run.code, run.out) == (2, "")
    assert "obs.json" in run.err
    assert not (tmp_path / "out.json").exists()


def test_a_terminal_gets_a_table(tmp_path, beltcal, monkeypatch):
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True, raising=False)
    path = sessions.save(tmp_path / "obs.json", sessions.base_observations())
    table = beltcal("base", path).out
    assert "ACCEPTED" in table
    assert "mm" in table
    assert beltcal("base", path, "--json").record["verdict"]["ok"]


def test_help_needs_no_heavy_package():
    code = ("import sys; from beltgui.cli.main import main; main(['--help']);"
            "heavy = {'numpy', 'scipy', 'OCP', 'open3d', 'PySide6', 'matplotlib', 'shapely', 'vtk'} & set(sys.modules);"
            "sys.exit(f'imported {heavy}' if heavy else 0)")
    run = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    assert "error-surface" in run.stdout


@pytest.mark.parametrize(("words", "code"), [(["--version"], 0), (["base", "--help"], 0), ([], 2), (["bse"], 2)])
def test_program_as_a_process(words, code):
    run = subprocess.run([sys.executable, "-m", "beltgui.cli.main", *words], cwd=ROOT, capture_output=True, text=True,
                         check=False)
    assert run.returncode == code
    assert "Traceback" not in run.stderr
    assert bool(run.stderr) == (code == 2)


def test_process_with_a_good_and_a_bad_file(tmp_path):
    good = sessions.save(tmp_path / "good.json", sessions.base_observations())
    bad = write(tmp_path / "bad.json", b"{")
    for path, code in ((good, 0), (bad, 2)):
        run = subprocess.run([sys.executable, "-m", "beltgui.cli.main", "base", path], cwd=ROOT, capture_output=True,
                             text=True, check=False)
        assert run.returncode == code
        assert bool(run.stdout) == (code == 0)
        assert "Traceback" not in run.stderr
