"""Touches of the cone and the wheel shafts as samples: each is kept at once and read back for solving."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from beltgui.session import Sample, Session
from beltgui.steps import head_rest
from beltgui.steps.context import Context
from core.frames import rigid, rotation_from_euler_zyx
from devices.cell_plan import CellPlan
from devices.interfaces import Mount, TouchCone, TouchShaft

Array = NDArray[np.float64]
STEP = "tool"
CONE = "cone_touch"
SHAFT = "shaft_touch"


@dataclass(frozen=True, eq=False)
class ConeTouch:
    """The stylus tip in the cone.

    Attributes:
        id: Of the sample.
        slot: Which planned touch it is.
        included: False if a person left it out.
        base_from_flange: (4, 4) as the robot reported it.
    """

    id: int
    slot: int
    included: bool
    base_from_flange: Array

    @property
    def name(self) -> str:
        """As a person calls it."""
        return f"cone {self.slot + 1}"


@dataclass(frozen=True, eq=False)
class ShaftTouch:
    """One touch of a wheel shaft's centre mark.

    Attributes:
        id: Of the sample.
        slot: Which planned touch of its grinder it is.
        included: False if a person left it out.
        grinder: Its name.
        angle_rad: Head angle by the grinder's sensor.
        base_from_flange: (4, 4) as the robot reported it.
    """

    id: int
    slot: int
    included: bool
    grinder: str
    angle_rad: float
    base_from_flange: Array

    @property
    def name(self) -> str:
        """As a person calls it."""
        return f"shaft {self.grinder} {self.slot + 1}"


@dataclass(frozen=True, eq=False)
class Rest:
    """One reading of a head at its stop.

    Attributes:
        id: Of the sample.
        included: False if a person left it out.
        grinder: Its name.
        angle_rad: By the grinder's sensor.
    """

    id: int
    included: bool
    grinder: str
    angle_rad: float

    @property
    def name(self) -> str:
        """As a person calls it."""
        return f"stop {self.grinder}"


@dataclass(frozen=True, eq=False)
class Touches:
    """All samples of the step that were not deleted, each kind in order of time."""

    cone: tuple[ConeTouch, ...]
    shafts: tuple[ShaftTouch, ...]
    rests: tuple[Rest, ...]

    def rests_rad(self) -> Mapping[str, tuple[float, ...]]:
        """What each head's sensor reads at the stop; readings left out are not in it."""
        found: dict[str, tuple[float, ...]] = {}
        for rest in self.rests:
            if rest.included:
                found[rest.grinder] = (*found.get(rest.grinder, ()), rest.angle_rad)
        return found


@dataclass(frozen=True)
class Missing:
    """Planned touches that were not taken or were deleted.

    Attributes:
        cone: Slots of cone touches.
        shafts: Slots of shaft touches by grinder.
        rests: Grinders whose head was not read at its stop.
    """

    cone: tuple[int, ...]
    shafts: Mapping[str, tuple[int, ...]]
    rests: tuple[str, ...]

    @property
    def count(self) -> int:
        """Of touches and readings."""
        return len(self.cone) + len(self.rests) + sum(len(slots) for slots in self.shafts.values())

    @property
    def touches(self) -> int:
        """Of touches alone."""
        return self.count - len(self.rests)


@dataclass(frozen=True, eq=False)
class Wanted:
    """All touches that are wanted: the planned ones, then those asked for in addition.

    Attributes:
        cone: (4, 4) each, base_from_flange roughly.
        shafts: Head angles by grinder, rad.
    """

    cone: tuple[Array, ...]
    shafts: Mapping[str, tuple[float, ...]]

    @property
    def count(self) -> int:
        """Touches, and one reading at the stop for each grinder."""
        return len(self.cone) + len(self.shafts) + sum(len(angles) for angles in self.shafts.values())


def wanted(session: Session, plan: CellPlan) -> Wanted:
    """The plan, and the settings `extra_cone` and `extra_shafts`.

    `extra_cone`: each {`translation_mm`, `euler_zyx_deg`} of base_from_flange; `extra_shafts`: head angles in deg by
    grinder.
    """
    cone = [
        rigid(rotation_from_euler_zyx(*np.radians(entry["euler_zyx_deg"])), entry["translation_mm"])
        for entry in session.setting(STEP, "extra_cone", [])
    ]
    extra = session.setting(STEP, "extra_shafts", {})
    return Wanted(
        cone=(*plan.stylus.touches, *cone),
        shafts={
            name: (*grinder.touch_angles_rad, *(float(np.radians(angle_deg)) for angle_deg in extra.get(name, [])))
            for name, grinder in plan.grinders.items()
        },
    )


def read(session: Session) -> Touches:
    """The touches as they were kept."""
    cone, shafts, rests = [], [], []
    for sample in session.samples(STEP):
        if sample.kind == CONE:
            cone.append(ConeTouch(sample.id, _slot(sample), sample.included, _flange(sample)))
        elif sample.kind == SHAFT:
            data = sample.data
            shafts.append(ShaftTouch(
                sample.id, _slot(sample), sample.included, data["grinder"], data["angle_rad"], _flange(sample)
            ))  # fmt: skip
        elif sample.kind == head_rest.KIND:
            rests.append(Rest(sample.id, sample.included, sample.data["grinder"], sample.data["angle_rad"]))
    return Touches(tuple(cone), tuple(shafts), tuple(rests))


def _slot(sample: Sample) -> int:
    return int(sample.data["slot"])


def _flange(sample: Sample) -> Array:
    return np.array(sample.data["base_from_flange"])


def missing(touches: Touches, want: Wanted) -> Missing:
    """What is still to be taken."""
    cone = {touch.slot for touch in touches.cone}
    shafts = {(touch.grinder, touch.slot) for touch in touches.shafts}
    rests = {rest.grinder for rest in touches.rests}
    return Missing(
        cone=tuple(slot for slot in range(len(want.cone)) if slot not in cone),
        shafts={
            name: tuple(slot for slot in range(len(angles)) if (name, slot) not in shafts)
            for name, angles in want.shafts.items()
        },
        rests=tuple(name for name in want.shafts if name not in rests),
    )


def acquire(session: Session, context: Context) -> None:
    """Ask for the stylus, then for the touches that are missing; each head is read at its stop before its touches.

    Raises:
        DeviceError: a device failed, or the person declined; what was taken before stays.
        Cancelled: the job was cancelled.
    """
    plan, operator = context.plan, context.cell.operator
    want = wanted(session, plan)
    absent = missing(read(session), want)
    if not absent.count:
        return
    if absent.touches:
        operator.perform(Mount("stylus"))
    total = want.count
    done = total - absent.count
    for slot in absent.cone:
        context.job.report(done / total, f"cone touch {slot + 1} of {len(want.cone)}")
        operator.perform(TouchCone(slot, len(want.cone), want.cone[slot]))
        _keep_cone(context, slot)
        done += 1
    for name, slots in absent.shafts.items():
        if name in absent.rests:
            context.job.report(done / total, f"grinder {name}: head at its stop")
            head_rest.acquire(context, STEP, name, {"slot": 0})
            done += 1
        for slot in slots:
            angle_rad = want.shafts[name][slot]
            context.job.report(done / total, f"grinder {name}: shaft at {np.degrees(angle_rad):+.0f} degrees")
            operator.perform(TouchShaft(name, angle_rad, plan.grinders[name].touch_from_flange))
            _keep_shaft(context, name, slot)
            done += 1


def _keep_cone(context: Context, slot: int) -> None:
    reading = context.cell.robot.read()
    data = {"slot": slot, "base_from_flange": reading.base_from_flange.tolist(), "time_s": reading.time_s}
    context.on_sample(context.session.add_sample(STEP, CONE, data))


def _keep_shaft(context: Context, grinder: str, slot: int) -> None:
    reading = context.cell.robot.read()
    head = context.cell.grinders[grinder].read()
    data = {
        "slot": slot,
        "grinder": grinder,
        "angle_rad": head.angle_rad,
        "base_from_flange": reading.base_from_flange.tolist(),
        "time_s": reading.time_s,
    }
    context.on_sample(context.session.add_sample(STEP, SHAFT, data))
