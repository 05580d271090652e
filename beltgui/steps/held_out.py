"""Observations kept out of the fit: a residual is not accuracy, a prediction is."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.verdict import Code, Reason

EVERY = 4


def is_held_out(slot: int, planned: int) -> bool:
    """True if the sample of that number is kept out of the fit, whatever else is there.

    Each fourth of the planned ones is, never the first; those that were asked for beyond the plan are all fitted.
    """
    return slot < planned and slot % EVERY == EVERY - 1


@dataclass(frozen=True, eq=False)
class HeldOut:
    """How well a result predicts what it has not seen.

    Attributes:
        what: What is predicted, e.g. `ball centre`.
        errors_mm: (N,) distance between prediction and observation.
        limit_mm: What their RMS may be.
    """

    what: str
    errors_mm: NDArray[np.float64]
    limit_mm: float

    @property
    def rms_mm(self) -> float:
        """RMS of the errors; NaN if nothing was kept out."""
        return float(np.sqrt(np.mean(self.errors_mm**2))) if len(self.errors_mm) else float("nan")

    def reasons(self, advice: str) -> list[Reason]:
        """Why the check fails, if it does."""
        if not len(self.errors_mm):
            message = f"No observation was kept out of the fit, so nothing shows how well it predicts. {advice}"
            return [Reason(Code.HELD_OUT_ERROR, message)]
        if self.rms_mm <= self.limit_mm:
            return []
        return [Reason(
            Code.HELD_OUT_ERROR,
            f"The {self.what} is predicted with an RMS error of {self.rms_mm:.3f} mm at {len(self.errors_mm)} "
            f"observations kept out of the fit, the limit is {self.limit_mm:.3f} mm. {advice}",
        )]

    def block(self) -> dict[str, object]:
        """For the record."""
        return {
            "what": self.what,
            "errors_mm": self.errors_mm.tolist(),
            "rms_mm": self.rms_mm if len(self.errors_mm) else None,
            "limit_mm": self.limit_mm,
        }
