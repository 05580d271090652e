"""What can go wrong with a device, as sentences that an operator can read; every error survives pickling."""

from __future__ import annotations

from devices.interfaces.limits import Limit


class DeviceError(Exception):
    """Something went wrong with a device.

    Attributes:
        device: The device's name, e.g. `scanner` or `grinder rough`.
        message: One sentence: what happened and what to do.
    """

    def __init__(self, device: str, message: str) -> None:
        super().__init__(device, message)
        self.device = device
        self.message = message

    def __str__(self) -> str:
        return f"{self.device}: {self.message}"


class Lost(DeviceError):  # noqa: N818  (a state, as people say it)
    """The connection is gone; nothing is known about the device's state until it is connected again."""


class Stale(DeviceError):  # noqa: N818  (a state, as people say it)
    """The device still answers, but with a reading that is too old to be used."""


class Stopped(DeviceError):  # noqa: N818  (a state, as people say it)
    """A motion ended before its target because somebody or something asked it to stop."""


class DeadlineExceeded(DeviceError):  # noqa: N818  (a state, as people say it)
    """No answer within the time that the caller allowed."""


class Refused(DeviceError):  # noqa: N818  (a state, as people say it)
    """The device understood and will not do it; nothing has moved.

    Attributes:
        limit: The limit that the request would break, where it is one.
        current: Value of the limited quantity now, in the limit's unit.
        target: Value asked for, in the limit's unit.
    """

    def __init__(
        self,
        device: str,
        message: str,
        limit: Limit | None = None,
        current: float | None = None,
        target: float | None = None,
    ) -> None:
        super().__init__(device, message)
        self.args = (device, message, limit, current, target)
        self.limit = limit
        self.current = current
        self.target = target

    @classmethod
    def beyond(cls, device: str, limit: Limit, current: float, target: float) -> Refused:
        """The error for a target outside a limit: states from, to, limits and unit."""
        message = (
            f"{limit.name} cannot go from {current:.4g} to {target:.4g} {limit.unit}: "
            f"the limits are {limit.low:.4g} to {limit.high:.4g} {limit.unit}. Choose a target inside them."
        )
        return cls(device, message, limit, current, target)
