"""Verdicts: judging a result is separate from computing it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum


class Code(StrEnum):
    """Reason codes shared by errors, verdicts, JSON and screens."""

    BAD_INPUT = "BAD_INPUT"
    NOT_ENOUGH_POINTS = "NOT_ENOUGH_POINTS"
    NOT_ENOUGH_VARIATION = "NOT_ENOUGH_VARIATION"
    HIGH_RESIDUAL = "HIGH_RESIDUAL"
    HIGH_UNCERTAINTY = "HIGH_UNCERTAINTY"
    HELD_OUT_ERROR = "HELD_OUT_ERROR"
    ILL_CONDITIONED = "ILL_CONDITIONED"
    NOT_CONVERGED = "NOT_CONVERGED"
    LOW_COVERAGE = "LOW_COVERAGE"
    TOO_MANY_OUTLIERS = "TOO_MANY_OUTLIERS"
    OUTSIDE_LIMITS = "OUTSIDE_LIMITS"
    NO_REDUNDANCY = "NO_REDUNDANCY"
    WRONG_MODEL = "WRONG_MODEL"


@dataclass(frozen=True)
class Reason:
    """One reason: a code for programs and a sentence for people that says what to do."""

    code: Code
    message: str


@dataclass(frozen=True)
class Verdict:
    """Accept (no reasons) or reject (one or more reasons)."""

    reasons: tuple[Reason, ...] = ()

    @property
    def ok(self) -> bool:
        """True if nothing speaks against the result."""
        return not self.reasons

    @classmethod
    def of(cls, reasons: Iterable[Reason]) -> Verdict:
        """Collect reasons into a verdict."""
        return cls(tuple(reasons))


def above(code: Code, value: float, limit: float, what: str, advice: str, unit: str = "mm") -> list[Reason]:
    """One reason if `value` is above `limit` (or is not a number), none otherwise."""
    if value <= limit:
        return []
    return [Reason(code, f"{what} is {value:.4g} {unit}, the limit is {limit:.4g} {unit}. {advice}")]
