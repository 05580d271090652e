"""The robot program as URScript text, and the proof that the text says what was planned.

The controller's language wants metres and rotation vectors; this file is the only place where they occur.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from core.errors import InputError
from core.frames import Array, inverse, rigid, rotation_from_rotvec, rotvec_from_rotation
from core.path.contact import tool_from_contact
from core.path.plan import PathPlan
from core.verdict import Code

MOST_SPEED_MM_S = 250.0
LEAST_SPEED_MM_S = 0.1
METRES = 1e-3
# Neighbouring blends must not overlap: the controller stops the program where they do.
BLEND_SHARE = 0.45
PROOF_MM = 1e-3
PROOF_RAD = 1e-6

_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
_POSE = re.compile(r"movel\(\s*p\[\s*(" + r"\s*,\s*".join([_NUMBER] * 6) + r")\s*\]")
_PLAIN_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")


@dataclass(frozen=True)
class ProgramSettings:
    """How the program moves.

    Attributes:
        speed_mm_s: Feed of the contact along the blade; the flange's speed follows from it move by move, up to the two
            limits that matter where the blade turns about its edge: 250 mm/s and `max_turn_rad_s`.
        travel_mm_s: Speed of the flange to the approach of a stroke.
        acceleration_mm_s2: Acceleration of every move.
        blend_mm: Blend radius inside a stroke, shortened where points are close.
        max_turn_rad_s: Greatest turning speed of the flange.
        name: Name of the program's function.
        date: Text for the header, e.g. "2031-02-03"; nothing here reads a clock.
        blade_type: Text for the header.
    """

    speed_mm_s: float = 50.0
    travel_mm_s: float = 200.0
    acceleration_mm_s2: float = 500.0
    blend_mm: float = 0.5
    max_turn_rad_s: float = 1.0
    name: str = "belt_path"
    date: str = ""
    blade_type: str = ""


def write_urscript(plan: PathPlan, settings: ProgramSettings) -> str:
    """The program text for a plan.

    Raises:
        InputError: a speed beyond 250 mm/s, a setting that is not positive, or a name the controller cannot take.
    """
    _check(settings)
    feeds = [_flange_speeds(stroke.base_from_flange, stroke.work_from_contact, settings) for stroke in plan.strokes]
    held = sum(slowed for _, slowed in feeds)
    lines = [
        f"# Belt grinding path, blade type {_comment(settings.blade_type) or 'not stated'}",
        f"# Date: {_comment(settings.date) or 'not stated'}",
        "# Poses of the flange in the robot base: metres and rotation vectors in rad; speeds in m/s, a in m/s^2",
        f"# {len(plan.strokes)} strokes, {plan.points} contact points, "
        + ("normal errors compensated" if plan.compensated else "design path, not compensated"),
        f"# Feed {settings.speed_mm_s:g} mm/s on the blade; {held} moves are slower, so that the flange stays within "
        f"{MOST_SPEED_MM_S:g} mm/s and {settings.max_turn_rad_s:g} rad/s",
        "# The first move runs straight from where the robot stands to the first approach: clear that way beforehand",
        f"def {settings.name}():",
        "  set_tcp(p[0, 0, 0, 0, 0, 0])",
    ]
    for number, (stroke, (feed, _)) in enumerate(zip(plan.strokes, feeds, strict=True), start=1):
        blends = _blends(stroke.base_from_flange, settings.blend_mm)
        ends = f"u {stroke.u[0]:.6f} to {stroke.u[-1]:.6f}, v {stroke.v[0]:.6f} to {stroke.v[-1]:.6f}"
        lines.append(f"  # stroke {number}: {ends}")
        lines.append(_move(stroke.approach_base_from_flange, settings.travel_mm_s, 0.0, settings))
        for pose, speed, blend in zip(stroke.base_from_flange, feed, blends, strict=True):
            lines.append(_move(pose, float(speed), float(blend), settings))
        lines.append(_move(stroke.retract_base_from_flange, settings.speed_mm_s, 0.0, settings))
    return "\n".join([*lines, "end", f"{settings.name}()", ""])


def _check(settings: ProgramSettings) -> None:
    for field in ("speed_mm_s", "travel_mm_s"):
        value = getattr(settings, field)
        if not np.isfinite(value) or value <= 0.0:
            raise InputError(f"{field}: expected a positive speed in mm/s, found {value:g}.")
        if value > MOST_SPEED_MM_S:
            raise InputError(
                f"{field}: {value:g} mm/s is beyond the limit of {MOST_SPEED_MM_S:g} mm/s.", Code.OUTSIDE_LIMITS
            )
    if not np.isfinite(settings.acceleration_mm_s2) or not 0.0 < settings.acceleration_mm_s2 <= 5000.0:
        raise InputError(f"acceleration_mm_s2: expected above 0 and up to 5000, found {settings.acceleration_mm_s2:g}.")
    if not np.isfinite(settings.max_turn_rad_s) or not 0.0 < settings.max_turn_rad_s <= np.pi:
        found = np.degrees(settings.max_turn_rad_s)
        raise InputError(f"max_turn_deg_s: expected above 0 and up to 180 degrees per second, found {found:g}.")
    if not np.isfinite(settings.blend_mm) or settings.blend_mm < 0.0:
        raise InputError(f"blend_mm: expected a radius of 0 mm or more, found {settings.blend_mm:g}.")
    if not _PLAIN_NAME.fullmatch(settings.name):
        raise InputError(f"program name: expected letters, digits and underscores, found '{settings.name}'.")


def _comment(text: str) -> str:
    return " ".join(text.split())


def _flange_speeds(
    base_from_flange: Array, work_from_contact: Array, settings: ProgramSettings
) -> tuple[Array, int]:
    """Speed of the flange for each move to a contact so that the contact keeps the feed, and how many had to be slower.

    The first contact is approached along the normal at the feed itself.
    """
    flange = np.linalg.norm(np.diff(base_from_flange[:, :3, 3], axis=0), axis=1)
    contact = np.linalg.norm(np.diff(work_from_contact[:, :3, 3], axis=0), axis=1)
    rotation = base_from_flange[:, :3, :3]
    turn = np.linalg.norm(rotvec_from_rotation(np.swapaxes(rotation[:-1], 1, 2) @ rotation[1:]), axis=1)
    wanted = settings.speed_mm_s * flange / np.maximum(contact, 1e-9)
    limit = np.minimum(MOST_SPEED_MM_S, settings.max_turn_rad_s * flange / np.maximum(turn, 1e-12))
    # A move that only turns the flange still needs a speed that the controller accepts.
    speed = np.maximum(np.minimum(wanted, limit), LEAST_SPEED_MM_S)
    return np.concatenate([[settings.speed_mm_s], speed]), int(np.sum(wanted > limit))


def _blends(base_from_flange: Array, blend_mm: float) -> Array:
    steps = np.linalg.norm(np.diff(base_from_flange[:, :3, 3], axis=0), axis=1)
    blends = np.zeros(len(base_from_flange))
    blends[1:-1] = np.minimum(blend_mm, BLEND_SHARE * np.minimum(steps[:-1], steps[1:]))
    return blends


def _move(pose: Array, speed_mm_s: float, blend_mm: float, settings: ProgramSettings) -> str:
    numbers = np.concatenate([pose[:3, 3] * METRES, rotvec_from_rotation(pose[:3, :3])])
    text = ", ".join(f"{value + 0.0:.9f}" for value in np.round(numbers, 9))
    acceleration = settings.acceleration_mm_s2 * METRES
    return f"  movel(p[{text}], a={acceleration:.4f}, v={speed_mm_s * METRES:.5f}, r={blend_mm * METRES:.6f})"


def read_urscript(text: str) -> Array:
    """Flange poses (K, 4, 4) in mm of every `movel` in a program, in order.

    Raises:
        InputError: no move, or a move that cannot be read.
    """
    moves = [line for line in (raw.split("#", 1)[0].strip() for raw in text.splitlines()) if line.startswith("movel")]
    if not moves:
        raise InputError("The program contains no movel.")
    poses = np.empty((len(moves), 4, 4))
    for index, line in enumerate(moves):
        match = _POSE.match(line)
        if match is None:
            raise InputError(f"Move {index + 1} of the program cannot be read: {line[:80]}")
        numbers = np.array([float(value) for value in match.group(1).split(",")])
        poses[index] = rigid(rotation_from_rotvec(numbers[3:]), numbers[:3] / METRES)
    return poses


@dataclass(frozen=True)
class ProgramProof:
    """What came back when the written program was read.

    Attributes:
        poses: Number of poses compared.
        max_position_mm: Greatest deviation of the flange's origin.
        max_rotation_rad: Greatest deviation of the flange's rotation.
        max_contact_mm: Greatest distance between a planned contact on the blade and the contact point of the wheel
            when the program's pose is run.
    """

    poses: int
    max_position_mm: float
    max_rotation_rad: float
    max_contact_mm: float


def verify_program(plan: PathPlan, text: str) -> ProgramProof:
    """Read a program back and recompute where the blade touches.

    Raises:
        InputError: another number of poses than planned, or a deviation of 1 um or 1 urad and more.
    """
    poses, planned = read_urscript(text), plan.robot_poses()
    if len(poses) != len(planned):
        raise InputError(f"The program has {len(poses)} moves, the plan {len(planned)}. Write the program again.")
    difference = np.swapaxes(planned[:, :3, :3], 1, 2) @ poses[:, :3, :3]
    turned = float(np.linalg.norm(rotvec_from_rotation(difference), axis=1).max())
    moved = float(np.linalg.norm(poses[:, :3, 3] - planned[:, :3, 3], axis=1).max())
    contact = _contact_deviation(plan, poses)
    if not (max(moved, contact) < PROOF_MM and turned < PROOF_RAD):
        raise InputError(
            f"The program does not say what was planned: flange {moved:.3g} mm and {turned:.3g} rad off, contact "
            f"{contact:.3g} mm off. Write the program again.",
            Code.OUTSIDE_LIMITS,
        )
    return ProgramProof(len(poses), moved, turned, contact)


def _contact_deviation(plan: PathPlan, poses: Array) -> float:
    cell = plan.cell
    on_wheel = tool_from_contact(cell.wheel_radius_mm, cell.contact_side, cell.span_along_shaft)
    touch_in_base = (cell.base_from_tool @ on_wheel)[:, 3]
    first, greatest = 0, 0.0
    for stroke in plan.strokes:
        run = poses[first + 1 : first + 1 + stroke.u.size]
        touch_in_work = inverse(cell.flange_from_work) @ inverse(run) @ touch_in_base
        distance = np.linalg.norm(touch_in_work[:, :3] - stroke.work_from_contact[:, :3, 3], axis=1)
        greatest = max(greatest, float(distance.max()))
        first += stroke.u.size + 2
    return greatest
