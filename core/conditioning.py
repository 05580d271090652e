"""Which combination of unknowns the data determine least."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Conditioning:
    """Spectrum of a scaled information matrix.

    Attributes:
        condition: Ratio of largest to smallest singular value of the scaled Jacobian; inf if singular.
        weakest_direction: (n,) unit vector in the scaled unknowns, largest component positive.
        description: The same in words, e.g. `rotation about (0.00, 0.01, 1.00)`.
    """

    condition: float
    weakest_direction: Array
    description: str


def analyse(information: ArrayLike, scales: ArrayLike, names: Sequence[str]) -> Conditioning:
    """Condition and weakest direction of an information matrix (n, n).

    Args:
        information: J^T W J, any units.
        scales: (n,) typical size of each unknown, which makes the unknowns comparable (e.g. 1 mm for a translation and
            1 mm / lever arm for a rotation).
        names: n names, used in the description.
    """
    s = np.asarray(scales, dtype=float)
    scaled = np.asarray(information, dtype=float) * np.outer(s, s)
    values, vectors = np.linalg.eigh(0.5 * (scaled + scaled.T))
    largest = float(values[-1])
    smallest = float(values[0])
    condition = float("inf") if smallest <= 0.0 or largest <= 0.0 else float(np.sqrt(largest / smallest))
    weakest = vectors[:, 0] * np.sign(vectors[np.argmax(np.abs(vectors[:, 0])), 0])
    return Conditioning(condition, weakest, _in_words(weakest, names))


def _in_words(direction: Array, names: Sequence[str]) -> str:
    order = np.argsort(-np.abs(direction))
    parts = [f"{direction[i]:+.2f} {names[i]}" for i in order if abs(direction[i]) >= 0.2]
    return ", ".join(parts)


def analyse_pose(information: ArrayLike, lever_arm_mm: float) -> Conditioning:
    """`analyse` for a pose error (rx ry rz tx ty tz) with the weak direction named as an axis.

    Args:
        information: (6, 6) about the data's centroid, rad and mm.
        lever_arm_mm: RMS distance of the data from that centroid.
    """
    lever = max(float(lever_arm_mm), 1e-9)
    names = ("rotation x", "rotation y", "rotation z", "translation x", "translation y", "translation z")
    result = analyse(information, [1.0 / lever] * 3 + [1.0] * 3, names)
    rotation, translation = result.weakest_direction[:3], result.weakest_direction[3:]
    parts = []
    if np.linalg.norm(rotation) >= 0.2:
        parts.append(f"rotation about {direction_text(rotation)}")
    if np.linalg.norm(translation) >= 0.2:
        parts.append(f"translation along {direction_text(translation)}")
    return Conditioning(result.condition, result.weakest_direction, " with ".join(parts))


def direction_text(vector: Array) -> str:
    """A direction (3,) of any length as `(x, y, z)` of its unit vector, for messages."""
    unit = vector / np.linalg.norm(vector) + 0.0
    return "(" + ", ".join(f"{value:.2f}" for value in unit) + ")"
