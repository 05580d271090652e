"""Which calls of devices are under way, and what the sensors said last.

The monitor looks here instead of asking scanner and sensors itself: asking would disturb the work, and in the
simulated cell it would use up chance that the work's own readings are drawn from.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

from devices.interfaces import GrinderReading, GrinderSensors, Limit, Scan, Scanner


@dataclass(frozen=True)
class Doing:
    """A call of a device that is under way.

    Attributes:
        what: What it is for; empty without one.
        since_s: When it began, on `time.monotonic`.
        moving: It is a motion, which may take its time.
    """

    what: str = ""
    since_s: float = 0.0
    moving: bool = False


class Watch:
    """Written by whoever calls a device, read by the monitor."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._doing: dict[str, Doing] = {}
        self._readings: dict[str, GrinderReading] = {}

    @contextmanager
    def call(self, device: str, what: str, *, moving: bool = False) -> Iterator[None]:
        """Note that a call is under way, until it ends."""
        with self._lock:
            self._doing[device] = Doing(what, time.monotonic(), moving)
        try:
            yield
        finally:
            with self._lock:
                self._doing[device] = Doing()

    def doing(self, device: str) -> Doing:
        """The call under way."""
        with self._lock:
            return self._doing.get(device, Doing())

    def note_reading(self, grinder: str, reading: GrinderReading) -> None:
        """A head's sensors as the work read them."""
        with self._lock:
            self._readings[grinder] = reading

    def readings(self) -> dict[str, GrinderReading]:
        """The last reading of each grinder's head."""
        with self._lock:
            return dict(self._readings)


class WatchedScanner:
    """A `Scanner` whose calls are noted."""

    def __init__(self, scanner: Scanner, watch: Watch) -> None:
        self._scanner, self._watch = scanner, watch

    @property
    def limits(self) -> tuple[Limit, ...]:
        """The measuring volume."""
        return self._scanner.limits

    def capture(self, *, deadline_s: float = 10.0) -> Scan:
        """Take one scan, see `Scanner.capture`."""
        with self._watch.call("scanner", "taking a scan"):
            return self._scanner.capture(deadline_s=deadline_s)


class WatchedGrinder:
    """`GrinderSensors` whose calls and readings are noted."""

    def __init__(self, sensors: GrinderSensors, name: str, watch: Watch) -> None:
        self._sensors, self._name, self._watch = sensors, name, watch

    @property
    def limits(self) -> tuple[Limit, ...]:
        """Travel of the head and range of the force sensor."""
        return self._sensors.limits

    def read(self, *, deadline_s: float = 0.1) -> GrinderReading:
        """Read the newest sample, see `GrinderSensors.read`."""
        with self._watch.call(f"grinder {self._name}", "reading the head"):
            reading = self._sensors.read(deadline_s=deadline_s)
        self._watch.note_reading(self._name, reading)
        return reading
