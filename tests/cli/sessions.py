"""Truth and simulated measurements for the command line's tests, made without any estimator."""

import json
from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation


def turn(axes, *angles_deg):
    return Rotation.from_euler(axes, angles_deg if len(angles_deg) > 1 else angles_deg[0], degrees=True).as_matrix()


def rigid(rotation, translation):
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, translation
    return matrix


def moved(matrix, points):
    return np.asarray(points) @ matrix[:3, :3].T + matrix[:3, 3]


def save(path, value):
    path.write_text(json.dumps(value))
    return path


def flange_poses(rng, n, tilt_deg=25.0):
    return [rigid(Rotation.from_rotvec(rng.uniform(-1, 1, 3) * np.radians(tilt_deg)).as_matrix(),
                  np.array([-1200, -1500, 950]) + rng.uniform(-150, 150, 3)) for _ in range(n)]


BASE_FROM_MEASURE = rigid(turn("ZYX", 1.0, -2.0, 1.5), [-1180.0, -1695.0, 980.0])
BALL_IN_FLANGE = np.array([86.0, -165.0, 35.0])


def base_observations(seed=0, n=9, sigma_mm=0.02):
    rng = np.random.default_rng(seed)
    measure_from_base = np.linalg.inv(BASE_FROM_MEASURE)
    return {"observations": [
        {"base_from_flange": pose.tolist(),
         "ball_in_measure_mm": (moved(measure_from_base, moved(pose, BALL_IN_FLANGE))
                                + rng.normal(0, sigma_mm, 3)).tolist()} for pose in flange_poses(rng, n)]}


MEASURE_FROM_WORK = rigid(turn("ZYX", 20.0, -8.0, 95.0), [40.0, -25.0, 320.0])


def rough_pairs(seed=0, sigma_mm=0.3):
    rng = np.random.default_rng(seed)
    corners = [[-37, -30, -60], [37, -30, -60], [37, 30, -50], [-20, 25, 100], [15, -5, 205]]
    return {"pairs": [{"name": f"corner {i}", "cad_mm": c,
                       "scan_mm": (moved(MEASURE_FROM_WORK, c) + rng.normal(0, sigma_mm, 3)).tolist()}
                      for i, c in enumerate(corners, 1)]}


TIP_IN_FLANGE = np.array([2.0, -3.0, 182.0])
PIVOT_IN_BASE = np.array([-900.0, 400.0, 610.0])


def stylus_observations(seed=0, n=12, sigma_mm=0.02):
    rng = np.random.default_rng(seed)
    rows = []
    for _ in range(n):
        rotation = Rotation.from_rotvec(rng.uniform(-1, 1, 3) * np.radians(30)).as_matrix()
        origin = PIVOT_IN_BASE - rotation @ TIP_IN_FLANGE + rng.normal(0, sigma_mm, 3)
        rows.append({"base_from_flange": rigid(rotation, origin).tolist()})
    return {"observations": rows}


BASE_FROM_TOOL = rigid(turn("ZYX", 30.0, 10.0, -85.0), [-820.0, 250.0, 1100.0])
WHEEL_RADIUS_ABOUT_HEAD = 160.0


def wheel_touches(angles_deg=(0, 4, 8, -4, -8, 12), sigma_mm=0.01, seed=0, shaft_offset_mm=0.0):
    rng = np.random.default_rng(seed)
    rows = []
    for angle in angles_deg:
        a = np.radians(angle)
        on_circle = [WHEEL_RADIUS_ABOUT_HEAD * (np.cos(a) - 1), WHEEL_RADIUS_ABOUT_HEAD * np.sin(a), -shaft_offset_mm]
        point = moved(BASE_FROM_TOOL, on_circle) + rng.normal(0, sigma_mm, 3)
        rows.append({"angle_deg": angle, "point_in_base_mm": point.tolist()})
    return {"touches": rows}


def ball_scan(seed=0, n=4000, center=(12.0, -8.0, 240.0), diameter=19.988, sigma=0.02):
    """A cap of 70 degrees seen from the scanner, and a flat fixture below it."""
    rng = np.random.default_rng(seed)
    cos_angle = rng.uniform(np.cos(np.radians(70)), 1, n)
    phi = rng.uniform(0, 2 * np.pi, n)
    sin_angle = np.sqrt(1 - cos_angle**2)
    directions = np.c_[sin_angle * np.cos(phi), sin_angle * np.sin(phi), -cos_angle]
    cap = np.asarray(center) + directions * (diameter / 2 + rng.normal(0, sigma, (n, 1)))
    plate = np.c_[rng.uniform(-40, 40, (n // 4, 2)), np.full(n // 4, center[2] + 25.0)]
    return np.vstack([cap, plate])


@dataclass
class StageTruth:
    measure_from_scanner: np.ndarray
    axes: np.ndarray
    rotary_direction: np.ndarray
    squareness_deg: np.ndarray


def _stage_in_scanner():
    """Directions of the three axes and the rotary axis, in the scanner's frame at zero."""
    axes = np.array([[1, 0.004, -0.006], [-0.002, 1, 0.005], [0.003, 0.002, 1]], dtype=float)
    rotary = np.array([0.003, 0.999, 0.004])
    return axes / np.linalg.norm(axes, axis=1)[:, None], rotary / np.linalg.norm(rotary)


def stage_truth():
    """M has its x along the stage's x and its y in the plane of x and y; its origin is the scanner's at zero."""
    axes, rotary = _stage_in_scanner()
    z = np.cross(axes[0], axes[1])
    z /= np.linalg.norm(z)
    measure_from_scanner = np.array([axes[0], np.cross(z, axes[0]), z])
    pairs = ((0, 1), (1, 2), (2, 0))
    squareness = [np.degrees(np.arccos(axes[i] @ axes[j])) - 90 for i, j in pairs]
    return StageTruth(rigid(measure_from_scanner, [0, 0, 0]), axes @ measure_from_scanner.T,
                      measure_from_scanner @ rotary, np.array(squareness))


def stage_observations(seed=0, n=24, sigma_mm=0.005):
    """Everything in the scanner's frame at zero: the scanner is moved by the axes, carried by the rotary table."""
    rng = np.random.default_rng(seed)
    axes, rotary = _stage_in_scanner()
    ball = np.array([10.0, 5.0, 250.0])
    table_point = np.array([30.0, 0.0, -80.0])
    rows = []
    for q in rng.uniform(-60, 60, (n, 3)):
        theta = rng.uniform(-20, 20)
        turned = Rotation.from_rotvec(rotary * np.radians(theta)).as_matrix()
        in_scanner = turned.T @ (ball - q @ axes - table_point) + table_point + rng.normal(0, sigma_mm, 3)
        rows.append({"stage_mm": q.tolist(), "stage_deg": theta, "ball_in_scanner_mm": in_scanner.tolist()})
    return {"observations": rows}


def error_at(u, v):
    return 0.5 * np.cos(4 * np.pi * v) + 0.3 * np.sin(3 * u)


def grid(nu=12, nv=14):
    u, v = np.meshgrid(np.linspace(0.1, 0.9, nu), np.linspace(0.05, 0.95, nv), indexing="ij")
    return u.ravel(), v.ravel()


def samples_csv(path, u, v, error):
    path.write_text("u,v,error_mm\n" + "".join(f"{a!r},{b!r},{c}\n" for a, b, c in
                                               zip(u.tolist(), v.tolist(), error, strict=True)))
    return path


def blade_points(step, n=40_000, sigma_mm=0.03, seed=0):
    """Points of a blade in M: drawn evenly from fine triangles of its surface, with noise, beside some of a fixture."""
    from core.cad import read_step

    rng = np.random.default_rng(seed)
    mesh = read_step(step).tessellate(0.003)
    corners = mesh.vertices[mesh.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(normals, axis=1)
    chosen = rng.choice(len(corners), n, p=area / area.sum())
    a, b = rng.uniform(size=(2, n, 1))
    a, b = np.where(a + b > 1, 1 - a, a), np.where(a + b > 1, 1 - b, b)
    one, two, three = (corners[chosen, i] for i in range(3))
    points = one + a * (two - one) + b * (three - one)
    points += normals[chosen] / area[chosen, None] * rng.normal(0, sigma_mm, (n, 1))
    fixture = rng.uniform([-60, -60, -110], [60, 60, -80], (n // 40, 3))
    return moved(MEASURE_FROM_WORK, np.vstack([points, fixture]))


def path_job(folder, step, v_range=(0.2, 0.8)):
    """A job with everything that it names, in one folder; the error surface is 0.5 mm of cosine along the span."""
    u, v = np.meshgrid(np.linspace(0.05, 0.95, 14), np.linspace(0.1, 0.9, 16), indexing="ij")
    samples_csv(folder / "samples.csv", u.ravel(), v.ravel(), (0.4 * np.cos(3 * v.ravel())).tolist())
    save(folder / "tool.json", {"base_from_tool": {"matrix": BASE_FROM_TOOL.tolist()}})
    job = folder / "job.toml"
    job.write_text(f"""
cad = "{step}"
airfoil = "AIRFOIL"
error_surface = "surface.json"
base_from_tool = "tool.json"
flange_from_work = {rigid(turn("ZYX", 10.0, 5.0, -3.0), [1.0, -2.0, 128.0]).tolist()}
wheel_radius_mm = 60.0
contact_side = 1
pattern = "transverse"
count = 3
u_range = [0.2, 0.8]
v_range = {list(v_range)}
step_mm = 3.0
program = "blade.script"
""")
    return job
