"""Numbers as text: fixed decimals, the unit beside them, a dash for what is not known."""

from __future__ import annotations

import math

DASH = "–"
MOST_DECIMALS = 6


def number(value: float | None, decimals: int = 3) -> str:
    """A value with fixed decimals; a dash for None, NaN and infinity; never `-0.000`."""
    if value is None or not math.isfinite(value):
        return DASH
    text = f"{value:.{decimals}f}"
    return text.removeprefix("-") if float(text) == 0.0 else text


def decimals_for(plus_minus: float | None, decimals: int) -> int:
    """Decimals at which an uncertainty does not read as zero: at least one of its digits is shown."""
    if plus_minus is None or not math.isfinite(plus_minus) or plus_minus <= 0.0:
        return decimals
    return min(max(decimals, math.ceil(-math.log10(plus_minus))), MOST_DECIMALS)


def with_unit(value: float | None, unit: str, decimals: int = 3) -> str:
    """A value with its unit; the unit stands there too when the value is not known."""
    return f"{number(value, decimals)} {unit}".rstrip()


def plain_number(value: float | None) -> str:
    """A value of no stated decimals: four significant digits."""
    if value is None or not math.isfinite(value):
        return DASH
    return f"{value:.4g}"
