"""Program text: what is written reads back as planned, also at half turns, and unsafe settings are refused."""

import re

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.errors import InputError
from core.path import (
    CellFrames,
    PathPlan,
    PatternSettings,
    ProgramSettings,
    Stroke,
    plan_path,
    read_urscript,
    verify_program,
    write_urscript,
)


class Plate:
    """A flat blade 40 x 100 mm whose normal is z."""

    def derivatives(self, u, v):
        point = np.stack([40.0 * u, 100.0 * v, 0 * u], axis=-1)
        return point, np.broadcast_to([40.0, 0, 0], point.shape), np.broadcast_to([0, 100.0, 0], point.shape)

    def normal(self, u, v):
        return np.broadcast_to([0.0, 0.0, 1.0], (*np.shape(u), 3))


def turned(rotvec, translation):
    matrix = np.eye(4)
    matrix[:3, :3] = Rotation.from_rotvec(rotvec).as_matrix()
    matrix[:3, 3] = translation
    return matrix


CELL = CellFrames(turned([0.2, 1.0, -0.4], [800, 100, 600]), turned([0.5, 0, 0.1], [0, 10, 100]), 60.0, -1)
PATTERN = PatternSettings("transverse", (0.0, 1.0), (0.1, 0.9), count=3, step_mm=4.0)


def plan():
    return plan_path(Plate(), CELL, PATTERN)


def test_round_trip():
    text = write_urscript(plan(), ProgramSettings(blade_type="DR95", date="2031-02-03"))
    proof = verify_program(plan(), text)
    assert proof.poses == plan().points + 2 * 3
    assert proof.max_position_mm < 2e-6 and proof.max_contact_mm < 1e-3 and proof.max_rotation_rad < 2e-9
    assert "DR95" in text and "2031-02-03" in text and "metres" in text
    assert text.count("movel(") == proof.poses
    assert "set_tcp(p[0, 0, 0, 0, 0, 0])" in text
    assert text.endswith("end\nbelt_path()\n")


def test_units_are_metres_and_radians():
    first = plan().robot_poses()[0]
    line = next(line for line in write_urscript(plan(), ProgramSettings()).splitlines() if "movel" in line)
    numbers = [float(value) for value in re.search(r"p\[(.*)\]", line).group(1).split(",")]
    np.testing.assert_allclose(numbers[:3], first[:3, 3] / 1000.0, atol=1e-9)
    np.testing.assert_allclose(Rotation.from_rotvec(numbers[3:]).as_matrix(), first[:3, :3], atol=1e-8)
    assert "v=0.20000" in line and "a=0.5000" in line and "r=0.000000" in line


@pytest.mark.parametrize("angle", [np.pi, np.pi - 1e-7, np.pi + 1e-7, 0.0, 1e-9])
@pytest.mark.parametrize("axis", [[1, 0, 0], [0, -1, 0], [0.6, 0.0, 0.8], [-0.6, 0.64, -0.48]])
def test_half_turns(angle, axis):
    pose = turned(np.array(axis) * angle, [500, -200, 300])
    frames = np.broadcast_to(np.eye(4), (2, 4, 4))
    stroke = Stroke(np.zeros(2), np.zeros(2), np.zeros(2), frames, frames, np.stack([pose] * 2), np.stack([pose] * 2),
                    pose, pose)  # fmt: skip
    text = write_urscript(PathPlan((stroke,), CELL, False, 0), ProgramSettings())
    back = read_urscript(text)
    np.testing.assert_allclose(back, np.stack([pose] * 4), atol=1e-6)


def test_a_changed_program_is_noticed():
    text = write_urscript(plan(), ProgramSettings())
    moves = [line for line in text.splitlines() if "movel" in line]
    numbers = re.search(r"p\[([-\d.]+)", moves[4]).group(1)
    with pytest.raises(InputError, match="not say what was planned"):
        verify_program(plan(), text.replace(numbers, f"{float(numbers) + 2e-6:.9f}"))
    with pytest.raises(InputError, match="moves, the plan"):
        verify_program(plan(), text.replace(moves[3] + "\n", ""))
    with pytest.raises(InputError, match="cannot be read"):
        read_urscript("movel(get_actual_tcp_pose())")
    with pytest.raises(InputError, match="no movel"):
        read_urscript("def a():\nend\n# movel(p[0,0,0,0,0,0])")


def test_reads_other_number_styles():
    pose = read_urscript("  movel( p[ .1, -2e-1, +0.3, 0, 0.0, 3.14159265358979 ], a=1, v=0.1)")[0]
    np.testing.assert_allclose(pose[:3, 3], [100, -200, 300])
    np.testing.assert_allclose(pose[:3, 0], [-1, 0, 0], atol=1e-9)


def test_flange_speed_follows_the_feed_and_is_held():
    far = CellFrames(CELL.base_from_tool, CELL.flange_from_work, 60.0, 1)

    class Nose:
        def derivatives(self, u, v):
            point = np.stack([0.5 * np.cos(np.pi * u), 0.5 * np.sin(np.pi * u), 100 * v], axis=-1)
            along = 0.5 * np.pi * np.stack([-np.sin(np.pi * u), np.cos(np.pi * u), 0 * u], axis=-1)
            return point, along, np.broadcast_to([0, 0, 100.0], point.shape)

        def normal(self, u, v):
            return np.stack([np.cos(np.pi * u), np.sin(np.pi * u), 0 * u], axis=-1)

    def speeds(text):
        return np.array([float(value) for value in re.findall(r"v=([\d.]+)", text)])

    flat = speeds(write_urscript(plan(), ProgramSettings(speed_mm_s=30.0)))
    np.testing.assert_allclose(flat[1:11], 0.03, atol=1e-5)
    sharp = speeds(write_urscript(plan_path(Nose(), far, PATTERN), ProgramSettings(speed_mm_s=30.0)))
    assert sharp.max() <= 0.25
    unhurried = speeds(write_urscript(plan_path(Nose(), far, PATTERN), ProgramSettings(max_turn_rad_s=np.pi)))
    stroke = plan_path(Nose(), far, PATTERN).strokes[0]
    moves, relative = stroke.base_from_flange, Rotation.from_matrix(stroke.base_from_flange[:, :3, :3])
    seconds = np.linalg.norm(np.diff(moves[:, :3, 3], axis=0), axis=1) / 1000.0 / sharp[2 : len(moves) + 1]
    assert np.all((relative[:-1].inv() * relative[1:]).magnitude() / seconds < 1.01)
    assert np.all(unhurried >= sharp) and unhurried.max() <= 0.25
    slow = write_urscript(plan_path(Nose(), far, PATTERN), ProgramSettings(speed_mm_s=30.0))
    assert "moves are slower" in slow and " 0 moves are slower" not in slow


def test_blends_never_overlap():
    text = write_urscript(plan(), ProgramSettings(blend_mm=100.0))
    blends = np.array([float(value) for value in re.findall(r"r=([\d.]+)\)", text)]) * 1000.0
    positions = read_urscript(text)[:, :3, 3]
    steps = np.linalg.norm(np.diff(positions, axis=0), axis=1)
    assert np.all(blends[:-1] + blends[1:] < steps)
    assert blends.max() > 1.0 and blends[0] == blends[1] == blends[-1] == 0.0


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"speed_mm_s": 251.0}, "beyond the limit of 250"),
        ({"travel_mm_s": 400.0}, "travel_mm_s"),
        ({"speed_mm_s": 0.0}, "speed_mm_s"),
        ({"acceleration_mm_s2": -1.0}, "acceleration"),
        ({"blend_mm": -1.0}, "blend_mm"),
        ({"max_turn_rad_s": 30.0}, "max_turn"),
        ({"name": "a b"}, "name"),
    ],
)
def test_unsafe_settings(change, message):
    with pytest.raises(InputError, match=message):
        write_urscript(plan(), ProgramSettings(**change))


def test_header_cannot_smuggle_code():
    text = write_urscript(plan(), ProgramSettings(blade_type="DR95\nset_digital_out(0, True)"))
    assert all(not line.startswith("set_digital_out") for line in text.splitlines())
