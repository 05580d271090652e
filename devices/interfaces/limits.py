"""Limits that a device publishes, with units; a screen builds its input fields from them."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Limit:
    """A closed interval that a quantity must stay in.

    Attributes:
        name: The quantity as a person calls it, e.g. `stage x`.
        low: Smallest allowed value.
        high: Largest allowed value.
        unit: `mm`, `rad`, `mm/s`, `N` ...
    """

    name: str
    low: float
    high: float
    unit: str

    def contains(self, value: float) -> bool:
        """True when the value is a number inside the interval."""
        return self.low <= value <= self.high
