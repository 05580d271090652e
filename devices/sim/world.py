"""The one world that all simulated devices share: what is really where, with known truth."""

from __future__ import annotations

import threading
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import numpy as np

from devices.cell_plan import CellPlan, GrinderPlan
from devices.clock import Clock
from devices.interfaces.errors import Refused
from devices.interfaces.operator import Item
from devices.interfaces.stage import StagePosition
from devices.sim.blade import Blade, BladeFileError, load_blade
from devices.sim.contact import Contact, Head
from devices.sim.faults import Faults
from devices.sim.fixture import ball_fixture, bare_fixture, blade_fixture
from devices.sim.geometry import Array, apply, inverse, random_unit, rigid, small_pose, turn, unit
from devices.sim.kinematics import Arm, imperfect_arm, nominal_arm, reach_joints
from devices.sim.rays import RayScene
from devices.sim.settings import TruthSettings


@dataclass(frozen=True, eq=False)
class TrueStage:
    """The stage as it was built; frame {M}: x along the true x axis, y in the plane of the true x and y axes.

    Attributes:
        axes: (3, 3) columns: way of the carriage in {M} per mm on the scale (direction times scale).
        rotary_axis: (3,) direction.
        rotary_point_mm: (3,) a point of the rotary axis in {M} with all linear axes at zero.
        mounting: (3, 3) measure_from_scanner rotation with all axes at zero.
    """

    axes: Array
    rotary_axis: Array
    rotary_point_mm: Array
    mounting: Array

    def measure_from_scanner(self, position: StagePosition) -> Array:
        """p_M = A q + c + Rot(axis, theta) (R0 p_S - c)."""
        rotation = turn(self.rotary_axis * position.theta_rad)
        carried = self.axes @ np.array([position.x_mm, position.y_mm, position.z_mm])
        return rigid(rotation @ self.mounting, carried + self.rotary_point_mm - rotation @ self.rotary_point_mm)


@dataclass(frozen=True, eq=False)
class Motion:
    """Where the arm is as a function of time: a smooth joint motion, then rest.

    Attributes:
        start_rad: (6,) joints at the beginning.
        end_rad: (6,) joints at the end.
        begin_s: When it starts.
        duration_s: How long it moves.
        noise: (4, 4) repeatability: the flange comes to rest at true pose times this.
    """

    start_rad: Array
    end_rad: Array
    begin_s: float
    duration_s: float
    noise: Array

    def joints_at(self, time_s: float) -> Array:
        """(6,) joint angles at a time."""
        if time_s >= self.begin_s + self.duration_s:
            return self.end_rad
        share = max(0.0, (time_s - self.begin_s) / self.duration_s)
        return np.asarray(self.start_rad + (3.0 * share**2 - 2.0 * share**3) * (self.end_rad - self.start_rad))


@dataclass(frozen=True, eq=False)
class Mounted:
    """What is on the flange."""

    item: Item
    serial: str
    flange_from_work: Array
    scene: RayScene


class World:
    """Truth and state of the cell; devices read it, faults and the operator change it.

    Every source of chance has its own generator, so that what one device does never changes what another one sees.
    """

    def __init__(
        self,
        plan: CellPlan,
        settings: TruthSettings,
        blade_step: Path,
        flange_from_work: Array,
        clock: Clock,
        seed: int,
    ) -> None:
        names = ("build", "stage", "robot", "scanner", "operator", *(f"grinder {name}" for name in plan.grinders))
        streams = np.random.SeedSequence(seed).spawn(len(names))
        self._rng = {name: np.random.default_rng(stream) for name, stream in zip(names, streams, strict=True)}
        self.plan, self.settings, self.clock, self.faults = plan, settings, clock, Faults()
        self.nominal_flange_from_work = flange_from_work
        self.lock = threading.RLock()
        build = self._rng["build"]
        measure = settings.measure
        self.base_from_measure = plan.base_from_measure @ small_pose(
            build, measure.shift_mm, np.deg2rad(measure.tilt_deg)
        )
        self.stage = _true_stage(build, settings)
        self.nominal_arm: Arm = nominal_arm()
        self.true_arm: Arm = imperfect_arm(build, settings.robot.absolute_rms_mm)
        mount = settings.mount
        self._ball_in_flange = plan.ball.nominal_in_flange_mm + mount.ball_shift_mm * random_unit(build)
        self.tip_in_flange = plan.stylus.nominal_tip_in_flange_mm + mount.stylus_shift_mm * random_unit(build)
        self.cone_in_base = plan.stylus.cone_in_base_mm + mount.cone_shift_mm * random_unit(build)
        grinder = settings.grinder
        self._base_from_tool = {
            name: entry.base_from_tool @ small_pose(build, grinder.shift_mm, np.deg2rad(grinder.tilt_deg))
            for name, entry in plan.grinders.items()
        }
        if not blade_step.is_file():
            raise BladeFileError(f"{blade_step}: there is no such file.")
        self._blade_step = blade_step
        self._clampings: dict[str, int] = {}
        self._seed = seed
        self.stage_position = StagePosition(0.0, 0.0, 0.0, 0.0)
        self.motion = Motion(plan.robot.home_rad, plan.robot.home_rad, 0.0, 0.0, np.eye(4))
        self.held_angle_rad: dict[str, float] = {}
        self.mounted = self._mounted("nothing", "")

    def rng(self, device: str) -> np.random.Generator:
        """The generator of one device."""
        return self._rng[device]

    @cached_property
    def blade(self) -> Blade:
        """The true blade; read at first use."""
        error = self.settings.blade
        return load_blade(self._blade_step, error.shape_error_mm, error.airfoil_shift_mm)

    # ---- robot

    def joints(self) -> Array:
        """(6,) joint angles now, as the encoders see them."""
        return self.motion.joints_at(self.clock.now_s())

    def true_flange(self) -> Array:
        """base_from_flange as it is."""
        return np.asarray(self.true_arm.forward(self.joints()) @ self.motion.noise)

    def true_flange_of(self, base_from_flange: Array) -> Array:
        """Where the flange would really be if the robot reported this pose; without repeatability."""
        joints = reach_joints(self.nominal_arm, base_from_flange, self.joints())
        if joints is None:
            raise Refused("robot", "the pose is out of reach. Choose another one.")
        return self.true_arm.forward(joints)

    def arrive(self, joints_rad: Array, duration_s: float) -> Motion:
        """Start a motion from where the arm is; a new repeatability error belongs to it."""
        robot, rng = self.settings.robot, self._rng["robot"]
        shift = rng.normal(0.0, 1.0, 3) * robot.repeatability_mm
        tilt = rng.normal(0.0, 1.0, 3) * np.deg2rad(robot.repeatability_deg)
        with self.lock:
            self.held_angle_rad.clear()
            self.motion = Motion(self.joints(), joints_rad, self.clock.now_s(), duration_s, rigid(turn(tilt), shift))
            return self.motion

    def freeze(self) -> None:
        """Stop the arm where it is."""
        with self.lock:
            joints = self.joints()
            self.motion = replace(self.motion, start_rad=joints, end_rad=joints, duration_s=0.0)

    # ---- stage and scanner

    def base_from_scanner(self) -> Array:
        """Where the scanner really is."""
        return np.asarray(self.base_from_measure @ self.stage.measure_from_scanner(self.stage_position))

    # ---- what is on the flange

    def mount(self, item: Item, serial: str) -> None:
        """Put something on the flange; each clamping of a blade has its own error."""
        self.mounted = self._mounted(item, serial)
        self.faults.blade_slip = np.eye(4)

    def _mounted(self, item: Item, serial: str) -> Mounted:
        if item == "blade":
            count = self._clampings.get(serial, 0)
            self._clampings[serial] = count + 1
            rng = np.random.default_rng([self._seed, count, *serial.encode()])
            clamp = small_pose(rng, self.settings.blade.clamp_shift_mm, np.deg2rad(self.settings.blade.clamp_tilt_deg))
            fixture = RayScene(blade_fixture(self.nominal_flange_from_work))
            return Mounted(item, serial, self.nominal_flange_from_work @ clamp, fixture)
        solid = ball_fixture(self.ball_in_flange) if item == "ball" else bare_fixture()
        return Mounted(item, serial, self.nominal_flange_from_work, RayScene(solid))

    @property
    def ball_in_flange(self) -> Array:
        """(3,) where the ball's centre is now."""
        return np.asarray(self._ball_in_flange + self.faults.ball_moved_mm)

    @property
    def flange_from_work(self) -> Array:
        """How the mounted blade really is clamped now."""
        return np.asarray(self.mounted.flange_from_work @ self.faults.blade_slip)

    # ---- grinders

    def base_from_tool(self, grinder: str) -> Array:
        """True {H} of a grinder at true head angle 0."""
        return self._base_from_tool[grinder]

    def head(self, grinder: str) -> Head:
        """The true head in {B}, with its wheel as worn as it is now."""
        plan, tool = self._grinder(grinder), self._base_from_tool[grinder]
        return Head(
            axis_point=tool[:3, 3] - plan.head_radius_mm * tool[:3, 0],
            axis=tool[:3, 2],
            wheel_centre=tool[:3, 3],
            wheel_radius_mm=plan.wheel_radius_mm - self.faults.wheel_wear_mm.get(grinder, 0.0),
            crown_radius_mm=plan.crown_radius_mm,
            side=plan.contact_side,
        )

    def shaft_mark(self, grinder: str, angle_rad: float) -> Array:
        """(3,) in {B}: the touched mark on the side of the wheel's shaft at a head angle."""
        head = self.head(grinder)
        return head.centre_at(angle_rad) + self._grinder(grinder).shaft_side_offset_mm * head.axis

    def contact(self, grinder: str, true_base_from_flange: Array) -> Contact | None:
        """Where the wheel touches the mounted blade; None without contact inside the head's travel."""
        plan = self._grinder(grinder)
        work_from_base = inverse(true_base_from_flange @ self.flange_from_work)
        head = self.head(grinder)
        in_work = replace(
            head,
            axis_point=apply(work_from_base, head.axis_point),
            axis=work_from_base[:3, :3] @ head.axis,
            wheel_centre=apply(work_from_base, head.wheel_centre),
        )
        return self.blade.contacts.solve(in_work, *plan.travel_rad)

    def true_normal_error(self, grinder: str, base_from_flange: Array) -> float:
        """How far the wheel centre is from K0 along the contact normal when the robot goes to a pose.

        Args:
            grinder: Its name.
            base_from_flange: (4, 4) the pose that is commanded; the robot's true absolute error is applied to it,
                repeatability and sensors are not.

        Returns:
            mm; zero is perfectly placed, positive is the wheel pushed outward. NaN without contact.
        """
        contact = self.contact(grinder, self.true_flange_of(base_from_flange))
        if contact is None:
            return float("nan")
        head = self.head(grinder)
        normal = self._grinder(grinder).contact_side * self._base_from_tool[grinder][:3, 1]
        return float(normal @ (head.centre_at(contact.angle_rad) - head.wheel_centre))

    def rest_angle(self, grinder: str) -> float:
        """Where the head's spring holds it without contact."""
        plan = self._grinder(grinder)
        return plan.travel_rad[0] if plan.contact_side > 0 else plan.travel_rad[1]

    def _grinder(self, grinder: str) -> GrinderPlan:
        if grinder not in self.plan.grinders:
            raise KeyError(f"no grinder {grinder!r}; there are {', '.join(self.plan.grinders)}")
        return self.plan.grinders[grinder]


def _true_stage(rng: np.random.Generator, settings: TruthSettings) -> TrueStage:
    stage = settings.stage
    xy, xz, yz = np.deg2rad(stage.squareness_deg) * rng.choice([-1.0, 1.0], 3) * rng.uniform(0.6, 1.0, 3)
    directions = np.column_stack(
        [[1.0, 0.0, 0.0], [np.sin(xy), np.cos(xy), 0.0], unit([np.tan(xz), np.tan(yz), 1.0])]
    )
    tilt = turn(random_unit(rng) * np.deg2rad(stage.rotary_tilt_deg))
    return TrueStage(
        axes=directions * (1.0 + stage.scale * rng.uniform(-1.0, 1.0, 3)),
        rotary_axis=tilt @ np.array([0.0, 1.0, 0.0]),
        rotary_point_mm=np.array(stage.rotary_point_mm) + rng.uniform(-1.0, 1.0, 3),
        mounting=turn(random_unit(rng) * np.deg2rad(stage.scanner_tilt_deg)),
    )
