"""Numbers as text: fixed decimals, the unit beside them, a dash for what is not known."""

from __future__ import annotations

import math

DASH = "–"


def number(value: float | None, decimals: int = 3) -> str:
    """A value with fixed decimals; a dash for None, NaN and infinity; never `-0.000`."""
    if value is None or not math.isfinite(value):
        return DASH
    text = f"{value:.{decimals}f}"
    return text.removeprefix("-") if float(text) == 0.0 else text


def with_unit(value: float | None, unit: str, decimals: int = 3) -> str:
    """A value with its unit; the unit stands there too when the value is not known."""
    return f"{number(value, decimals)} {unit}".rstrip()


def plain_number(value: float | None) -> str:
    """A value of no stated decimals: four significant digits."""
    if value is None or not math.isfinite(value):
        return DASH
    return f"{value:.4g}"
