"""Whether anything may move: a person's go, the held button, Stop, Cancel, a device that drops.

A stop must win against every order of events. Drivers may forget a stop that comes just before a motion begins, so
the guard keeps its own latch and repeats the stop until the motion has really ended.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import TypeVar

from beltgui.engine.messages import Answer
from beltgui.jobs import Cancelled
from devices.interfaces import DeviceError, RobotPath, Stopped
from devices.interfaces.robot import RobotMover
from devices.interfaces.stage import Stage

T = TypeVar("T")
Ask = Callable[[RobotPath, str], bool]
REPEAT_S = 0.02
# A screen that repeats `Hold(True)` shows that it is alive; it may miss some.
HOLD_ALIVE_S = 0.6


class Released(Exception):  # noqa: N818  (a state, not an error)
    """The robot may not go on: the button was let go, or nobody has said go."""


class MotionGuard:
    """The latch in front of robot and stage; call `close` at the end.

    Args:
        ask: Shows a path to a person and comes back with yes or no; it calls `answered` before it comes back.
    """

    def __init__(self, ask: Ask) -> None:
        self._ask = ask
        self._changed = threading.Condition()
        self._robot: RobotMover | None = None
        self._stage: Stage | None = None
        self._halt: Stopped | Cancelled | DeviceError | None = None
        self._go = self._series = self._by_hold = False
        self._repeats_hold, self._held_s = False, 0.0
        self._under_way: RobotMover | Stage | None = None
        self._stop_all = self._closed = False
        self._purpose = ""
        self._thread = threading.Thread(target=self._keep_stopping, name="engine stop", daemon=True)
        self._thread.start()

    def attach(self, robot: RobotMover | None, stage: Stage | None) -> None:
        """The devices that a stop is sent to, without any guard around them."""
        with self._changed:
            self._robot, self._stage = robot, stage

    # ---- from the thread that takes commands

    def begin_job(self) -> None:
        """New work: what ended the last one is over, and every motion has to be asked for anew."""
        with self._changed:
            self._halt = None
            self._go = self._series = False

    def stop(self) -> None:
        """Stop everything; the job under way moves nothing any more."""
        self._latch(Stopped("robot", "stopped by a person. Check that the way is free, then begin again."), all_=True)

    def cancel(self) -> None:
        """Stop the motion under way; the job under way moves nothing any more."""
        self._latch(Cancelled("The job was cancelled."))

    def device_failed(self, error: DeviceError) -> None:
        """A device has dropped: a motion under way is stopped and ends with this error."""
        with self._changed:
            if self._under_way is None:
                return
        self._latch(type(error)(error.device, f"{error.message} The motion was stopped."))

    def answered(self, answer: Answer) -> None:
        """What a person said to a path; must be called before later `hold` calls."""
        with self._changed:
            self._go, self._series, self._by_hold = answer.yes, answer.yes and answer.for_series, answer.hold
            self._repeats_hold, self._held_s = False, time.monotonic()

    def hold(self, down: bool) -> None:
        """The hold-to-run button is down (may be repeated) or has been let go."""
        with self._changed:
            self._repeats_hold = down and self._go and self._by_hold
            self._held_s = time.monotonic()
            if not down and self._by_hold:
                self._go = False
            self._changed.notify_all()

    # ---- from the thread that does the work

    def consent(self, path: RobotPath, purpose: str) -> bool:
        """Whether a person wants this motion; not asked again in a series.

        Raises:
            Stopped: a person stopped the work.
            Cancelled: a person ended it.
        """
        with self._changed:
            self._raise_halt()
            self._purpose = purpose
            if self._go and self._series:
                return True
            self._go = False
        return self._ask(path, purpose)

    def consent_to_go_on(self, path: RobotPath) -> bool:
        """The same for the rest of a motion that was interrupted, or one that nobody was asked about yet."""
        with self._changed:
            purpose = self._purpose
        return self.consent(path, purpose if purpose.startswith("to go on") else f"to go on {purpose}".strip())

    def may_move(self) -> bool:
        """A person has said go, and still holds the button where it was said with it."""
        with self._changed:
            return self._go

    def carry_out(self, device: RobotMover | Stage, motion: Callable[[], T]) -> T:
        """Do a motion that can be stopped at any moment.

        Args:
            device: What moves, without any guard.
            motion: Blocks until it is done; raises `Stopped` after `device.stop()`.

        Raises:
            Released: the robot may not move (any more).
            Stopped: a person stopped it.
            Cancelled: a person ended the work.
            DeviceError: of the device, or of another one that dropped meanwhile.
        """
        with self._changed:
            self._raise_halt()
            if device is self._robot and not self._go:
                raise Released
            self._under_way = device
            self._changed.notify_all()
        try:
            result = motion()
        except Stopped:
            with self._changed:
                self._raise_halt()
                if device is self._robot and not self._go:
                    raise Released from None
            raise
        finally:
            with self._changed:
                self._under_way = None
                self._changed.notify_all()
        with self._changed:
            self._raise_halt()
        return result

    @property
    def moving(self) -> bool:
        """A motion is under way."""
        with self._changed:
            return self._under_way is not None

    def close(self) -> None:
        """Stop what moves and end the thread (after the motion's end); does not wait."""
        self.stop()
        with self._changed:
            self._closed = True
            self._changed.notify_all()

    def join(self, timeout_s: float) -> bool:
        """Wait for the thread's end; whether it has ended."""
        self._thread.join(timeout_s)
        return not self._thread.is_alive()

    # ---- the stopping itself

    def _latch(self, why: Stopped | Cancelled | DeviceError, *, all_: bool = False) -> None:
        with self._changed:
            if self._halt is None or isinstance(why, Stopped):
                self._halt = why
            self._go = False
            self._stop_all = self._stop_all or all_
            self._changed.notify_all()

    def _raise_halt(self) -> None:
        if self._halt is not None:
            raise self._halt.with_traceback(None)

    def _must_stop(self) -> bool:
        if self._under_way is None:
            return False
        if self._repeats_hold and self._go and time.monotonic() - self._held_s > HOLD_ALIVE_S:
            self._go = False
        return self._halt is not None or (self._under_way is self._robot and not self._go)

    def _keep_stopping(self) -> None:
        while True:
            with self._changed:
                while not (self._stop_all or self._must_stop()):
                    if self._closed and self._under_way is None:
                        return
                    self._changed.wait(HOLD_ALIVE_S / 4 if self._repeats_hold else None)
                all_, self._stop_all = self._stop_all, False
                devices = [self._robot, self._stage] if all_ else [self._under_way]
            for device in devices:
                if device is not None:
                    _stop(device)
            with self._changed:
                self._changed.wait_for(lambda: self._under_way is None or self._stop_all, REPEAT_S)


def _stop(device: RobotMover | Stage) -> None:
    try:
        device.stop()
    except DeviceError:
        # It cannot be reached; the motion itself ends with that error, and the stop is repeated until then.
        return
