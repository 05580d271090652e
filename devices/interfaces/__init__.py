"""What the devices of a cell promise: protocols with deadlines, plain picklable data, errors as sentences."""

from devices.interfaces.cell import Cell
from devices.interfaces.errors import DeadlineExceeded, DeviceError, Lost, Refused, Stale, Stopped
from devices.interfaces.grinder import GrinderReading, GrinderSensors
from devices.interfaces.limits import Limit
from devices.interfaces.operator import Mount, Operator, Request, TouchCone, TouchShaft
from devices.interfaces.robot import MAX_SPEED_MM_S, RobotMover, RobotPath, RobotReading, RobotReporter
from devices.interfaces.scanner import Scan, Scanner, SharedScan
from devices.interfaces.stage import Stage, StagePosition

__all__ = [
    "MAX_SPEED_MM_S",
    "Cell",
    "DeadlineExceeded",
    "DeviceError",
    "GrinderReading",
    "GrinderSensors",
    "Limit",
    "Lost",
    "Mount",
    "Operator",
    "Refused",
    "Request",
    "RobotMover",
    "RobotPath",
    "RobotReading",
    "RobotReporter",
    "Scan",
    "Scanner",
    "SharedScan",
    "Stage",
    "StagePosition",
    "Stale",
    "Stopped",
    "TouchCone",
    "TouchShaft",
]
