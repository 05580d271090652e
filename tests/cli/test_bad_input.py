"""Unusable input: exit 2, one or two sentences that name the file, no traceback, nothing on stdout, no output file."""

import copy
import json
import os
from pathlib import Path

import numpy as np
import pytest

from beltgui.cli.main import main
from tests.cli import sessions
from tests.cloud_files import ply_bytes

ROOT = Path(__file__).parents[2]
STEP = ROOT / "resources/blades/dr95.step"


def good_files(folder):
    """One good input per command, to be spoilt by the cases."""
    u, v = sessions.grid()
    sessions.samples_csv(folder / "samples.csv", u, v, sessions.error_at(u, v).tolist())
    (folder / "points.csv").write_text("u,v\n0.5,0.5\n")
    (folder / "scan.ply").write_bytes(ply_bytes(sessions.ball_scan(n=800), "binary_little_endian"))


def refused(run, name, *patterns):
    assert run.code == 2, run
    assert run.out == ""
    assert "Traceback" not in run.err
    lines = run.err.strip().splitlines()
    # Remarks may come before; the refusal itself is the last line.
    message = lines[-1]
    assert message.startswith("beltcal: ")
    assert name in message
    assert len(message) < 500
    assert message.rstrip().endswith((".", "?", "}"))
    for pattern in patterns:
        assert pattern in message, message


def put(value, *path):
    """A change to a parsed JSON: the value at the path is replaced."""
    def change(data):
        for step in path[:-1]:
            data = data[step]
        data[path[-1]] = value
    return change


def drop(*path):
    def change(data):
        for step in path[:-1]:
            data = data[step]
        del data[path[-1]]
    return change


def scaled(data):
    for row in data["observations"]:
        matrix = np.array(row["base_from_flange"])
        matrix[:3, :3] *= 1.1
        row["base_from_flange"] = matrix.tolist()


def mirrored(data):
    matrix = np.array(data["observations"][2]["base_from_flange"])
    matrix[:3, 0] *= -1
    data["observations"][2]["base_from_flange"] = matrix.tolist()


def in_metres(*names):
    def change(data):
        for rows in data.values():
            for row in rows if isinstance(rows, list) else []:
                for name in names:
                    if name == "base_from_flange":
                        for r in row[name][:3]:
                            r[3] /= 1000.0
                    else:
                        row[name] = [x / 1000.0 for x in row[name]]
    return change


def keep(n):
    return lambda data: data.__setitem__(next(iter(data)), data[next(iter(data))][:n])


NAN, INF = float("nan"), float("inf")
POSE = ("observations", 3, "base_from_flange")
BALL = ("observations", 3, "ball_in_measure_mm")
JSON_CASES = {
    "base": (sessions.base_observations, [
        (drop("observations"), "observations"),
        (put([], "observations"), "empty"),
        (put({}, "observations"), "list"),
        (put("text", "observations"), "list"),
        (put(None, "observations"), "null"),
        (put(7, "observations", 3), "observations[3]"),
        (drop(*POSE), "observations[3] has no key \"base_from_flange\""),
        (drop(*BALL), "observations[3] has no key \"ball_in_measure_mm\""),
        (put([1, 2], *BALL), "observations[3].ball_in_measure_mm is a list of 2"),
        (put([1, 2, 3, 4], *BALL), "a list of 3 numbers"),
        (put(["1", 2, 3], *BALL), "observations[3].ball_in_measure_mm[0] is the text '1'"),
        (put([True, 2, 3], *BALL), "true"),
        (put([None, 2, 3], *BALL), "null"),
        (put([NAN, 2, 3], *BALL), "observations[3].ball_in_measure_mm[0] is NaN"),
        (put([INF, 2, 3], *BALL), "inf"),
        (put([1e7, 2, 3], *BALL), "within"),
        (put([10**400, 2, 3], *BALL), "too many digits"),
        (put([[1], 2, 3], *BALL), "a list of 1"),
        (put([[1, 0, 0]] * 3, *POSE), "4x4"),
        (put([[1, 0, 0]] * 4, *POSE), "observations[3].base_from_flange[0]"),
        (put(NAN, *POSE, 1, 2), "observations[3].base_from_flange[1][2] is NaN"),
        (put([0, 0, 0, 2], *POSE, 3), "last row"),
        (put(np.zeros((4, 4)).tolist(), *POSE), "last row"),
        (put(np.diag([0.0, 0, 0, 1]).tolist(), *POSE), "singular"),
        (scaled, "observations[0].base_from_flange", "scaled"),
        (mirrored, "observations[2].base_from_flange", "left-handed"),
        (in_metres("base_from_flange"), "m"),
        (in_metres("ball_in_measure_mm"), "m"),
    ]),
    "stage": (sessions.stage_observations, [
        (drop("observations", 2, "stage_mm"), "observations[2] has no key \"stage_mm\""),
        (drop("observations", 2, "stage_deg"), "observations[2] has no key \"stage_deg\""),
        (drop("observations", 2, "ball_in_scanner_mm"), "observations[2] has no key \"ball_in_scanner_mm\""),
        (put("5", "observations", 2, "stage_deg"), "observations[2].stage_deg is the text '5'"),
        (put(NAN, "observations", 2, "stage_deg"), "observations[2].stage_deg is NaN"),
        (put(9999, "observations", 2, "stage_deg"), "observations[2].stage_deg is 9999"),
        (put(0.1, "observations", 2, "sigma_mm"), "observations[0] has no sigma_mm"),
        (in_metres("stage_mm", "ball_in_scanner_mm"), "m"),
        (in_metres("ball_in_scanner_mm"), "m"),
    ]),
    "stylus": (sessions.stylus_observations, [
        (drop("observations"), "observations"),
        (drop(*POSE), "observations[3] has no key \"base_from_flange\""),
        (put(NAN, *POSE, 1, 2), "observations[3].base_from_flange[1][2] is NaN"),
        (mirrored, "observations[2].base_from_flange", "left-handed"),
        (scaled, "scaled"),
        (in_metres("base_from_flange"), "m"),
    ]),
    "tool": (sessions.wheel_touches, [
        (drop("touches"), "touches"),
        (drop("touches", 1, "angle_deg"), "touches[1] has no key \"angle_deg\""),
        (put([1, 2], "touches", 1, "point_in_base_mm"), "touches[1].point_in_base_mm"),
        (put(NAN, "touches", 1, "angle_deg"), "touches[1].angle_deg is NaN"),
        (put(-160, "radius_mm"), "radius_mm is -160"),
        (put(0, "radius_mm"), "radius_mm is 0"),
        (put("160", "radius_mm"), "radius_mm is the text"),
        (put(NAN, "shaft_offset_mm"), "shaft_offset_mm is NaN"),
        (put(0.16, "radius_mm"), "m"),
        (in_metres("point_in_base_mm"), "m"),
    ]),
    "rough": (sessions.rough_pairs, [
        (drop("pairs"), "pairs"),
        (put([], "pairs"), "empty"),
        (drop("pairs", 1, "scan_mm"), "pairs[1] has no key \"scan_mm\""),
        (put([1, 2], "pairs", 1, "cad_mm"), "pairs[1].cad_mm"),
        (put(NAN, "pairs", 1, "cad_mm", 2), "pairs[1].cad_mm[2] is NaN"),
        (put("corner 1", "pairs", 4, "name"), "pairs[4].name"),
        (put(5, "pairs", 4, "name"), "pairs[4].name is 5"),
        (put("a\nb", "pairs", 4, "name"), "pairs[4].name"),
        (in_metres("scan_mm"), "m"),
        (in_metres("cad_mm"), "m"),
    ]),
}


@pytest.mark.parametrize(("command", "number"),
                         [(name, i) for name, (_, cases) in JSON_CASES.items() for i in range(len(cases))])
def test_spoilt_json(tmp_path, beltcal, command, number):
    make, cases = JSON_CASES[command]
    change, *patterns = cases[number]
    data = copy.deepcopy(make())
    change(data)
    path = sessions.save(tmp_path / "spoilt.json", data)
    run = beltcal(command, path, "--out", tmp_path / "out.json")
    refused(run, "spoilt.json", *patterns)
    assert [p.name for p in tmp_path.iterdir()] == ["spoilt.json"]


RAW_JSON = {
    "empty": (b"", "empty"),
    "blank": (b"  \n", "line 2 column 1"),
    "syntax": (b'{"observations": [\n{"a": 1},,]}', "line 2 column 10"),
    "cut": (b'{"observations": [{"base_from_flange"', "line 1"),
    "list": (b"[1, 2]", "a list of 2"),
    "number": (b"7", "expected a JSON object"),
    "twice": (b'{"observations": [], "observations": []}', "twice"),
    "utf16": ('{"observations": []}'.encode("utf-16"), "UTF-16"),
    "latin": (b'{"n": "\xe4"}', "UTF-8"),
    "binary": (bytes(range(256)), "UTF-8"),
    "nested": (b'{"observations": ' + b"[" * 100_000, "nested"),
    "digits": (b'{"observations": [' + b"9" * 10_000 + b"]}", "digits"),
    "many": (b'{"observations": [' + b"1," * 100_001 + b"1]}", "at most 100000"),
    "null": (b"null", "null"),
}


@pytest.mark.parametrize("name", RAW_JSON)
def test_files_that_are_no_json(tmp_path, beltcal, name):
    content, pattern = RAW_JSON[name]
    path = tmp_path / "raw.json"
    path.write_bytes(content)
    refused(beltcal("base", path, "--out", tmp_path / "out.json"), "raw.json", pattern)
    assert not (tmp_path / "out.json").exists()


def test_a_byte_order_mark_is_no_error(tmp_path, beltcal):
    path = tmp_path / "obs.json"
    path.write_bytes(b"\xef\xbb\xbf" + json.dumps(sessions.base_observations()).encode())
    assert beltcal("base", path).code == 0


CSV_CASES = [
    (b"", "empty"),
    (b"# only a comment\n", "no lines"),
    (b"u,v\n0.1,0.2\n", "u,v,error_mm"),
    (b"u,v,error_mm\n", "no rows"),
    (b"u,v,error_mm\n0.1,0.2\n", "line 2 has 2 columns"),
    (b"u,v,error_mm\n0.1,0.2,0.3,0.4\n", "line 2 has 4 columns"),
    (b"u,v,error_mm\n0.1,0.2,0.3\n\n0.1,x,0.3\n", "line 4, column v is 'x'"),
    (b"u,v,error_mm\n0.1,nan,0.3\n", "line 2, column v is nan"),
    (b"u,v,error_mm\n0.1,0.2,nan\n", "column error_mm is nan"),
    (b"u,v,error_mm\n0.1,0.2,inf\n", "column error_mm is inf"),
    (b"u,v,error_mm\n0.1,,0.1\n", "column v is ''"),
    (b"u,u,v,error_mm\n1,1,1,1\n", "more than once"),
    (b"u,v,error_mm\n0.1,0.2,\xff\n", "line 2 is not UTF-8"),
    (b"u,v,error_mm\n0.1,0.2,0.3\n", ""),
    (b"u,v,angle_deg,nx,ny,nz\n0.1,0.2,0.3,0,1,0\n", "--tool"),
    (b'u,v,error_mm\n0.1,0.2,"0.3\n', '\"0.3'),
    (b"u,v,error_mm\n" + b'"' * 140_000 + b",1,1\n", "line 2"),
]


@pytest.mark.parametrize("number", range(len(CSV_CASES)))
def test_spoilt_csv(tmp_path, beltcal, number):
    content, pattern = CSV_CASES[number]
    path = tmp_path / "spoilt.csv"
    path.write_bytes(content)
    refused(beltcal("error-surface", path, "--out", tmp_path / "out.json"), "spoilt.csv", pattern)
    assert not (tmp_path / "out.json").exists()


USAGE = [
    ([], "COMMAND"),
    (["grind"], "grind"),
    (["base"], "OBS.json"),
    (["base", "obs.json", "more.json"], "more.json"),
    (["base", "obs.json", "--fast"], "--fast"),
    (["base", "obs.json", "--out"], "--out"),
    (["ball", "a.ply", "--diameter", "big"], "--diameter"),
    (["ball", "a.ply", "--diameter", "nan"], "--diameter"),
    (["ball", "a.ply", "--diameter", "-20"], "--diameter"),
    (["ball", "a.ply", "--diameter", "inf"], "--diameter"),
    (["ball", "a.ply", "--fix-diameter"], "--diameter"),
    (["rough"], "PAIRS.json"),
    (["rough", "--auto"], "--cad"),
    (["rough", "pairs.json", "--auto", "--cad", "a", "--scan", "b"], "pairs"),
    (["rough", "pairs.json", "--cad", "a"], "--auto"),
    (["rough", "pairs.json", "--seed", "-3"], "--seed"),
    (["path"], "--job"),
    (["error-surface"], "SAMPLES.csv"),
]


@pytest.mark.parametrize(("words", "pattern"), USAGE)
def test_usage(beltcal, words, pattern):
    refused(beltcal(*words), pattern, "beltcal")


FILE_COMMANDS = {
    "ball": ["ball", "FILE"], "stage": ["stage", "FILE"], "stylus": ["stylus", "FILE"], "tool": ["tool", "FILE"],
    "base": ["base", "FILE"], "rough": ["rough", "FILE"], "faces": ["faces", "FILE"],
    "error-surface": ["error-surface", "FILE"], "path": ["path", "--job", "FILE"],
    "evaluate": ["error-surface", "samples.csv", "--evaluate", "FILE"],
    "limits": ["base", "table1.json", "--limits", "FILE"],
}


@pytest.mark.parametrize("kind", ["missing", "folder", "device", "empty", "long", "binary", "unreadable"])
@pytest.mark.parametrize("command", FILE_COMMANDS)
def test_files_that_are_none(tmp_path, beltcal, monkeypatch, command, kind):
    good_files(tmp_path)
    (tmp_path / "table1.json").write_bytes((ROOT / "docs/examples/table1.json").read_bytes())
    monkeypatch.chdir(tmp_path)
    name = {"long": "x" * 300, "device": "/dev/null"}.get(kind, "some.file")
    if kind == "folder":
        os.mkdir(name)
    elif kind in ("empty", "binary"):
        Path(name).write_bytes(b"" if kind == "empty" else np.random.default_rng(0).bytes(3000))
    elif kind == "unreadable":
        os.symlink("some.file", name)
    words = [name if word == "FILE" else word for word in FILE_COMMANDS[command]]
    before = sorted(os.listdir())
    refused(beltcal(*words, "--out", "out.json"), name)
    assert sorted(os.listdir()) == before


START = {"matrix": sessions.MEASURE_FROM_WORK.tolist()}
FINE = [
    ({"matrix": START["matrix"][:3]}, [], "start.json", "4x4"),
    ({"pose": START["matrix"]}, [], "start.json", "matrix"),
    ({"measure_from_work": 5}, [], "start.json", "measure_from_work"),
    ({"matrix": np.diag([1.0, 1, -1, 1]).tolist()}, [], "start.json", "left-handed"),
    (START, ["--faces", "99"], "dr95.step", "99"),
    (START, ["--faces", "S2,,S3"], "--faces", "S2,,S3"),
    (START, ["--faces", "S2,S2"], "dr95.step", "twice"),
    (START, ["--faces", ""], "--faces", "''"),
    (START, ["--scan", "scan.ply"], "scan.ply", "twice"),
    (START, ["--scan", "none.ply"], "none.ply", "No such file"),
    (START, ["--limits", "start.json"], "start.json", "TOML"),
]


@pytest.mark.parametrize("number", range(len(FINE)))
def test_spoilt_fine(tmp_path, beltcal, monkeypatch, number):
    start, words, name, pattern = FINE[number]
    good_files(tmp_path)
    sessions.save(tmp_path / "start.json", start)
    monkeypatch.chdir(tmp_path)
    before = sorted(os.listdir())
    refused(beltcal("fine", "--cad", STEP, "--scan", "scan.ply", "--start", "start.json", "--out", "out.json", *words),
            name, pattern)
    assert sorted(os.listdir()) == before


CLOUDS = {
    "metres": lambda p: ply_bytes(p / 1000, "ascii"),
    "cut": lambda p: ply_bytes(p, "binary_little_endian")[:-10],
    "nothing": lambda p: ply_bytes(0 * p, "ascii"),
    "no_z": lambda p: ply_bytes(p, "ascii").replace(b"float z", b"float w"),
    "nan": lambda p: ply_bytes(p * np.nan, "ascii"),
    "garbage": lambda p: np.random.default_rng(0).bytes(4000),
}


@pytest.mark.parametrize("kind", CLOUDS)
@pytest.mark.parametrize("command", ["ball", "rough", "fine"])
def test_spoilt_clouds(tmp_path, beltcal, monkeypatch, command, kind):
    (tmp_path / "bad.ply").write_bytes(CLOUDS[kind](sessions.ball_scan(n=800)))
    sessions.save(tmp_path / "start.json", START)
    monkeypatch.chdir(tmp_path)
    words = {"ball": ["bad.ply"], "rough": ["--auto", "--cad", STEP, "--scan", "bad.ply"],
             "fine": ["--cad", STEP, "--scan", "bad.ply", "--start", "start.json"]}[command]
    refused(beltcal(command, *words, "--out", "out.json"), "bad.ply")
    assert sorted(os.listdir()) == ["bad.ply", "start.json"]


PATH = [
    ('cad = "none.step"', "none.step"),
    ('airfoil = "S2"', "S2"),
    ("airfoil = 999", "999"),
    ("wheel_radius_mm = -5", "wheel_radius_mm"),
    ("contact_side = 3", "contact_side"),
    ("v_range = [0.0, 1.0]", "measured"),
    ("u_range = [0.8, 0.2]", "u_range"),
    ("count = 0", "count"),
    ("count = 1000000000", "at most"),
    ("v_range = [0.5, 0.5]", "v_range"),
    ("base_from_tool = [[1, 0, 0, 0.9], [0, 1, 0, 0.3], [0, 0, 1, 0.7], [0, 0, 0, 1]]", "metres"),
    ("flange_from_work = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0.128], [0, 0, 0, 1]]", "metres"),
    ('error_surface = "info.json"', "info"),
    ('error_surface = "degrees.json"', "degrees"),
    ('error_surface = "control.json"', "own sample"),
    ("step_mm = nan", "step_mm"),
    ('error_surface = "tool.json"', "Error surface"),
    ('base_from_tool = "nested.json"', "nested.json"),
    ('base_from_tool = "digits.json"', "digits.json"),
    ('program = "no/folder.script"', "no"),
    ('program = "job.toml"', "program"),
    ('program = "surface.json"', "program"),
    ('program = "out.json"', "program"),
    ("speed_mm_s = 900", "speed_mm_s"),
    ("spead_mm_s = 10", "speed_mm_s"),
]


@pytest.fixture(scope="module")
def path_folder(tmp_path_factory):
    """A good path job, with a surface made by the command itself."""
    folder = tmp_path_factory.mktemp("path")
    sessions.path_job(folder, STEP)
    assert main(["error-surface", str(folder / "samples.csv"), "--out", str(folder / "surface.json")]) == 0
    surface = json.loads((folder / "surface.json").read_text())
    points = copy.deepcopy(surface["control_points_mm"])
    points[5][5] = 1e9
    for name, changed in (("info", {"info": [1]}), ("degrees", {"degrees": 3}),
                          ("control", {"control_points_mm": points})):
        sessions.save(folder / f"{name}.json", {**surface, **changed})
    (folder / "nested.json").write_text("[" * 100_000)
    (folder / "digits.json").write_text('{"a": ' + "9" * 5000 + "}")
    return folder


@pytest.mark.parametrize("number", range(len(PATH)))
def test_spoilt_path_job(path_folder, beltcal, monkeypatch, number):
    line, pattern = PATH[number]
    monkeypatch.chdir(path_folder)
    key = line.split("=")[0]
    good = (path_folder / "job.toml").read_text()
    kept = [row for row in good.splitlines() if not row.startswith(key)]
    before = sorted(os.listdir())
    (path_folder / "job.toml").write_text("\n".join([*kept, line]))
    try:
        refused(beltcal("path", "--job", "job.toml", "--out", "out.json"), "", pattern)
    finally:
        (path_folder / "job.toml").write_text(good)
    assert sorted(os.listdir()) == before


def test_replay_of_no_session(tmp_path, beltcal):
    refused(beltcal("replay", tmp_path / "none"), "none", "no such folder")
    refused(beltcal("replay", tmp_path), str(tmp_path))
    (tmp_path / "session.db").write_bytes(b"no database at all" * 100)
    refused(beltcal("replay", tmp_path), str(tmp_path), "database")


def test_demo_into_a_file(tmp_path, beltcal):
    (tmp_path / "taken").write_text("")
    refused(beltcal("demo", "--out", tmp_path / "taken"), "taken", "expected a folder")
    refused(beltcal("demo", "--out", ""), "", "--out")


def test_gui_without_its_cell_file(tmp_path, beltcal):
    refused(beltcal("gui", "--sim", "--config", tmp_path / "none.toml"), "none.toml")


def test_out_is_checked_before_the_work(tmp_path, beltcal):
    path = sessions.save(tmp_path / "obs.json", sessions.base_observations())
    refused(beltcal("base", path, "--out", tmp_path / "no" / "out.json"), "out.json", "does not exist")
    refused(beltcal("base", path, "--out", tmp_path), str(tmp_path), "folder")
    refused(beltcal("base", path, "--out", path), "obs.json", "also an input")
    refused(beltcal("base", path, "--out", "/dev/null"), "/dev/null", "ordinary")
    refused(beltcal("base", "/nowhere.json", "--out", tmp_path / "no" / "out.json"), "out.json", "does not exist")
    refused(beltcal("base", path, "--out", tmp_path / ("x" * 300)), "xxx")


def test_an_earlier_result_survives_a_failure(tmp_path, beltcal):
    out = tmp_path / "out.json"
    out.write_text("earlier")
    refused(beltcal("base", tmp_path / "none.json", "--out", out), "none.json")
    assert out.read_text() == "earlier"
    assert beltcal("base", ROOT / "docs/examples/table1.json", "--out", out).code == 0
    assert json.loads(out.read_text())["verdict"]["ok"]


LIMITS = [
    ("rms_mm = ", "TOML"),
    ("rms_mm = -1.0", "at least 0"),
    ("rms_mm = nan", "NaN"),
    ("rms_mm = 'a'", "the text 'a'"),
    ("rms = 1.0", "rms is not a limit of base"),
    ("[base]\nrms_mm = true", "base.rms_mm is true"),
    ("different_poses = 2.5", "whole"),
    ("rms_mm = 1\nrms_mm = 2", "TOML"),
]


@pytest.mark.parametrize(("text", "pattern"), LIMITS)
def test_spoilt_limits(tmp_path, beltcal, text, pattern):
    limits = tmp_path / "limits.toml"
    limits.write_text(text)
    refused(beltcal("base", ROOT / "docs/examples/table1.json", "--limits", limits), "limits.toml", pattern)


def test_unknown_keys_are_told(tmp_path, beltcal):
    data = sessions.base_observations()
    data["observations"][1]["sigma"] = 0.1
    run = beltcal("base", sessions.save(tmp_path / "obs.json", data))
    assert run.code == 0
    assert "observations[1].sigma" in run.err




def test_a_direction_among_the_limits(tmp_path, beltcal):
    touches = sessions.save(tmp_path / "touches.json", sessions.wheel_touches())
    direction = np.array(beltcal("tool", touches).record["head_axis"]["direction"])
    limits = tmp_path / "limits.toml"
    limits.write_text(f"[tool]\nexpected_axis_in_base = {(-direction).tolist()}")
    run = beltcal("tool", touches, "--limits", limits)
    assert run.code == 1
    assert [reason["code"] for reason in run.record["verdict"]["reasons"]] == ["WRONG_MODEL"]
    for text in ("1.0", "[0.0, 1.0]", "[0.0, 5.0, 0.0]"):
        limits.write_text(f"expected_axis_in_base = {text}")
        refused(beltcal("tool", touches, "--limits", limits), "limits.toml", "expected_axis_in_base")


def test_error_surface_refuses_a_rejected_tool_and_names_the_line_of_a_normal(tmp_path, beltcal):
    samples = tmp_path / "samples.csv"
    rows = [f"{u / 4},{v / 4},0.01,0,1,0" for u in range(5) for v in range(5)]
    samples.write_text("\n".join(["# probed", "u,v,angle_deg,nx,ny,nz", *rows]))
    tool = sessions.save(tmp_path / "tool.json", {"radius_mm": 160.0, "verdict": {"ok": False, "reasons": []}})
    refused(beltcal("error-surface", samples, "--tool", tool), "tool.json", "rejected")
    sessions.save(tool, {"radius_mm": 160.0})
    rows[7] = rows[7].replace("0,1,0", "0,2,0")
    samples.write_text("\n".join(["# probed", "u,v,angle_deg,nx,ny,nz", *rows]))
    refused(beltcal("error-surface", samples, "--tool", tool), "samples.csv", "line 10", "unit vector")


def test_a_slip_in_one_of_many_observations_is_named(tmp_path, beltcal):
    """Small enough for the limits, which leave room for a robot's own error, but not for the other observations."""
    base = sessions.base_observations(n=9)
    base["observations"][4]["ball_in_measure_mm"][1] += 0.6
    stylus = sessions.stylus_observations(n=12)
    stylus["observations"][4]["base_from_flange"][1][3] += 0.5
    for command, data in (("base", base), ("stylus", stylus)):
        run = beltcal(command, sessions.save(tmp_path / "obs.json", data))
        assert run.code == 1
        reasons = run.record["verdict"]["reasons"]
        assert [reason["code"] for reason in reasons] == ["HELD_OUT_ERROR"]
        assert " 4 (counted from 0)" in reasons[0]["message"]
        assert reasons[0]["message"].endswith("leave it out.")


def test_what_leaves_nothing_to_check_is_rejected(tmp_path, beltcal):
    obs = [{"stage_mm": q, "stage_deg": 0, "ball_in_scanner_mm": [20.0 - q[0], 5.0 - q[1], 230.0 - q[2]]}
           for q in ([0, 0, 0], [50, 0, 0], [0, 50, 0], [0, 0, 50])]
    stage = sessions.save(tmp_path / "stage.json", {"observations": obs})
    tool = sessions.save(tmp_path / "tool.json", sessions.wheel_touches((0, 12, -12)))
    for command, path in (("stage", stage), ("tool", tool)):
        run = beltcal(command, path)
        assert run.code == 1
        assert "NO_REDUNDANCY" in [reason["code"] for reason in run.record["verdict"]["reasons"]]


def test_gui_without_a_screen(monkeypatch, beltcal):
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"):
        monkeypatch.delenv(name, raising=False)
    refused(beltcal("gui", "--sim"), "no screen")


def test_gui_on_real_devices_which_have_no_drivers_yet(beltcal):
    refused(beltcal("gui"), "--sim")
