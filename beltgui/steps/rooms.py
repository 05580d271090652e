"""The six rooms by name, in the order of the work."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from beltgui.steps.ball.room import BallRoom
from beltgui.steps.base.room import BaseRoom
from beltgui.steps.error_surface.room import ErrorSurfaceRoom
from beltgui.steps.fine.room import FineRoom
from beltgui.steps.room import Room
from beltgui.steps.rough.room import RoughRoom
from beltgui.steps.state import STEPS
from beltgui.steps.tool.room import ToolRoom


def _by_name() -> Mapping[str, Room]:
    rooms: tuple[Room, ...] = (BallRoom(), BaseRoom(), RoughRoom(), FineRoom(), ToolRoom(), ErrorSurfaceRoom())
    found = {room.step: room for room in rooms}
    return MappingProxyType({step: found[step] for step in STEPS})


ROOMS = _by_name()
