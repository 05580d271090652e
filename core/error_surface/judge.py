"""Verdicts on error surfaces: is it good enough to move the blade by, and does an old one still fit."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.error_surface.several import SurfaceMismatch
from core.error_surface.surface import ErrorSurface
from core.verdict import Code, Reason, Verdict, above


@dataclass(frozen=True)
class ErrorSurfaceLimits:
    """Limits of acceptance.

    Attributes:
        max_leave_one_out_rms_mm: RMS of the leave-one-out errors: what the surface is wrong by between samples.
        max_sigma_mm: Noise of one sample.
        max_error_mm: Largest error on the measured patch; beyond it the calibration before is to blame.
        max_rejected_share: Share of samples found wrong.
        max_missing_share: Share of samples without a number.
        max_mismatch_mm: Robust RMS difference at which an old surface still counts as fitting.
    """

    max_leave_one_out_rms_mm: float = 0.05
    max_sigma_mm: float = 0.05
    max_error_mm: float = 5.0
    max_rejected_share: float = 0.10
    max_missing_share: float = 0.20
    max_mismatch_mm: float = 0.05


def judge_error_surface(surface: ErrorSurface, limits: ErrorSurfaceLimits | None = None) -> Verdict:
    """Accept or reject a fitted surface."""
    limits = limits or ErrorSurfaceLimits()
    n = surface.sample_u.size
    largest = float(np.abs((surface.sample_error_mm - surface.residuals_mm)[surface.used]).max())
    reasons = above(
        Code.HELD_OUT_ERROR,
        surface.leave_one_out_rms_mm,
        limits.max_leave_one_out_rms_mm,
        "The leave-one-out error (RMS)",
        "Measure a denser grid, or look for what makes the head's angle noisy.",
    )
    if surface.sigma_mm is not None and surface.mode != "interpolate":
        reasons += above(
            Code.HIGH_RESIDUAL,
            surface.sigma_mm,
            limits.max_sigma_mm,
            "The noise of one sample",
            "Measure slower and check the head's angle sensor.",
        )
    reasons += above(
        Code.OUTSIDE_LIMITS,
        largest,
        limits.max_error_mm,
        "The largest error",
        "This is more than a blade differs from its design: check base, fine and tool before compensating.",
    )
    reasons += above(
        Code.TOO_MANY_OUTLIERS,
        100.0 * surface.rejected.size / n,
        100.0 * limits.max_rejected_share,
        "The share of rejected samples",
        "Does the head bounce? Measure slower or press harder.",
        "%",
    )
    reasons += above(
        Code.LOW_COVERAGE,
        100.0 * float(surface.missing.mean()),
        100.0 * limits.max_missing_share,
        "The share of missing samples",
        "Check the link to the angle sensor and measure again.",
        "%",
    )
    return Verdict.of(reasons)


def judge_mismatch(mismatch: SurfaceMismatch, limits: ErrorSurfaceLimits | None = None) -> Verdict:
    """Accept an old surface if new samples agree with it, as far as their noise lets one see."""
    limits = limits or ErrorSurfaceLimits()
    noise = 0.0 if mismatch.expected_mm is None else 2.0 * mismatch.expected_mm
    reasons: list[Reason] = above(
        Code.WRONG_MODEL,
        mismatch.robust_rms_mm,
        max(limits.max_mismatch_mm, noise),
        "The difference between new samples and the stored error surface",
        "The blade, the tool or the calibration has changed: measure a new error surface.",
    )
    return Verdict.of(reasons)
