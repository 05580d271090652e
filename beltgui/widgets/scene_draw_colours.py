"""Values to colours, once for the drawn surface and for the bar that explains it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from beltgui.viewmodel.scene import Scale

Bytes = NDArray[np.uint8]

# Lightness rises (sequential) or peaks in the middle (diverging), so that the order is seen without telling hues apart.
_ANCHORS = {
    "diverging": ("#1d4fa3", "#5b8fd1", "#b3cbe6", "#f2f2f0", "#efbf9f", "#d6744f", "#9c2417"),
    "sequential": ("#2b2a6b", "#2f5f9e", "#2e8f94", "#64b66d", "#c3d35a", "#fbe96a"),
}
STEPS = 256


def rgb_of(text: str) -> tuple[int, int, int]:
    """`#rrggbb` as three numbers 0 to 255."""
    return int(text[1:3], 16), int(text[3:5], 16), int(text[5:7], 16)


def _table(anchors: tuple[str, ...]) -> Bytes:
    colours = np.array([rgb_of(text) for text in anchors], dtype=float)
    at = np.linspace(0.0, len(anchors) - 1.0, STEPS)
    channels = [np.interp(at, np.arange(len(anchors)), colours[:, channel]) for channel in range(3)]
    return np.round(np.stack(channels, axis=1)).astype(np.uint8)


TABLES: dict[str, Bytes] = {kind: _table(anchors) for kind, anchors in _ANCHORS.items()}


def colours_of(values: NDArray[np.floating], scale: Scale, missing: str) -> Bytes:
    """(N, 3) colours of (N,) values in the scale's unit; NaN takes the colour `missing` (`#rrggbb`)."""
    values = np.asarray(values, dtype=float)
    there = np.isfinite(values)
    span = scale.high - scale.low
    place = np.where(there, (values - scale.low) / (span if span > 0.0 else 1.0), 0.0)
    colours = TABLES[scale.kind][np.round(np.clip(place, 0.0, 1.0) * (STEPS - 1)).astype(np.intp)]
    colours[~there] = rgb_of(missing)
    return colours
