"""What a person does in the cell, as requests with an instruction: mounting things, touching by hand."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray

Item = Literal["ball", "blade", "stylus", "nothing"]


@dataclass(frozen=True)
class Mount:
    """Mount something on the flange (the blade: clamp it).

    Attributes:
        item: What to mount; `nothing` empties the flange.
        serial: Which one, e.g. the blade's serial number.
    """

    item: Item
    serial: str = ""

    @property
    def instruction(self) -> str:
        """The sentence that the operator reads."""
        if self.item == "nothing":
            return "Take everything off the flange."
        return f"Mount the {self.item}{f' {self.serial}' if self.serial else ''} on the flange, then confirm."


@dataclass(frozen=True, eq=False)
class TouchCone:
    """Put the stylus tip into the fixed cone with a new orientation of the flange, by hand.

    Attributes:
        index: Which touch, from 0.
        count: How many are planned.
        near: (4, 4) base_from_flange that was taught for this touch; None: the person chooses.
    """

    index: int
    count: int
    near: NDArray[np.float64] | None = None

    @property
    def instruction(self) -> str:
        """The sentence that the operator reads."""
        return (
            f"Touch {self.index + 1} of {self.count}: guide the stylus tip into the cone, tilted in another "
            "direction than before by 20 degrees or more, let go, then confirm."
        )


@dataclass(frozen=True, eq=False)
class TouchShaft:
    """Turn a grinder's head to an angle and touch the centre of the wheel shaft's side with the stylus, by hand.

    Attributes:
        grinder: Its name, `rough` or `fine`.
        head_angle_rad: Where to hold the head.
        near: (4, 4) base_from_flange that was taught for this touch; None: the person chooses.
    """

    grinder: str
    head_angle_rad: float
    near: NDArray[np.float64] | None = None

    @property
    def instruction(self) -> str:
        """The sentence that the operator reads."""
        return (
            f"Turn the head of grinder {self.grinder} to {math.degrees(self.head_angle_rad):+.1f} degrees, hold it, "
            "touch the centre mark of the wheel shaft with the stylus tip, then confirm."
        )


Request = Mount | TouchCone | TouchShaft


class Operator(Protocol):
    """A person in the cell, or what stands for one."""

    def perform(self, request: Request, *, deadline_s: float = 600.0) -> None:
        """Ask for something and come back when it is done.

        After a touch the robot stands at the touching pose and the grinder's head at the asked angle: read both.

        Raises:
            Refused: the person declined, or it cannot be done.
            DeadlineExceeded: nobody confirmed within `deadline_s`.
        """
        ...
