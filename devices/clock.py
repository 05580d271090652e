"""Time as a device: simulated cells and tests run on a clock that they own, real cells on the machine's.

Example:
    >>> clock = InstantClock()
    >>> clock.wait(2.5)
    >>> clock.now_s()
    2.5
"""

from __future__ import annotations

import threading
import time
from typing import Protocol


class Clock(Protocol):
    """Seconds since an arbitrary start; never goes back."""

    def now_s(self) -> float:
        """The time now, in s."""
        ...

    def wait(self, duration_s: float) -> None:
        """Come back when `duration_s` seconds of this clock have passed."""
        ...


class InstantClock:
    """Simulated time: waiting costs no real time, the clock advances by what was waited for."""

    def __init__(self, start_s: float = 0.0) -> None:
        self._now_s = start_s
        self._lock = threading.Lock()

    def now_s(self) -> float:
        """The simulated time, in s."""
        with self._lock:
            return self._now_s

    def wait(self, duration_s: float) -> None:
        """Advance the simulated time by `duration_s` (>= 0) at once."""
        _check_duration(duration_s)
        with self._lock:
            self._now_s += duration_s


class RealClock:
    """The machine's monotonic time, optionally running `speed` times faster (a demo that need not take an hour)."""

    def __init__(self, speed: float = 1.0) -> None:
        if not speed > 0.0:
            raise ValueError(f"The speed of a clock must be positive, found {speed:g}.")
        self._speed = speed
        self._start = time.monotonic()

    def now_s(self) -> float:
        """Seconds since this clock was made, times its speed."""
        return (time.monotonic() - self._start) * self._speed

    def wait(self, duration_s: float) -> None:
        """Block the calling thread for `duration_s` seconds of this clock."""
        _check_duration(duration_s)
        time.sleep(duration_s / self._speed)


def _check_duration(duration_s: float) -> None:
    if not duration_s >= 0.0:
        raise ValueError(f"A waiting time must be zero or more seconds, found {duration_s:g}.")
