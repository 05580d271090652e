"""How faces hold a blade, by their geometry alone: known before anything is scanned; mm, rad, frame W."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from core.cad import CadModel, merge_patches
from core.conditioning import Conditioning, analyse_pose
from core.errors import InputError
from core.fine.boxes import make_target
from core.fine.settings import FineSettings

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Hold:
    """What faces determine of a pose.

    Attributes:
        conditioning: Of the pose in W about `centre_mm`, all faces weighing the same.
        centre_mm: (3,) middle of the faces in W.
        lever_mm: RMS distance of the faces from it.
        max_condition: Above it the faces do not hold the blade.
    """

    conditioning: Conditioning
    centre_mm: Array
    lever_mm: float
    max_condition: float

    @property
    def free(self) -> bool:
        """True where the weakest direction is not held."""
        return not self.conditioning.condition < self.max_condition

    @property
    def turns(self) -> bool:
        """True where the weakest motion is a turn, False where it is a shift."""
        weakest = self.conditioning.weakest_direction
        return bool(np.linalg.norm(weakest[:3]) > np.linalg.norm(weakest[3:]))

    @property
    def axis(self) -> tuple[Array, Array]:
        """Point (3,) mm and unit direction (3,) in W of the weakest motion: its axis, or the way of the shift."""
        weakest = self.conditioning.weakest_direction
        shift = weakest[3:]
        if not self.turns:
            return self.centre_mm, shift / np.linalg.norm(shift)
        turn = weakest[:3] / self.lever_mm
        beside = np.cross(turn, shift) / float(turn @ turn)
        return self.centre_mm + beside, turn / np.linalg.norm(turn)


def analyse_faces(model: CadModel, face_ids: Sequence[int | str],
                  max_condition: float = FineSettings.max_condition) -> Hold:
    """Which motion of the blade some faces hold least, if all of each is seen.

    Each point p with normal n has the row [(p - c) x n, n]; each face counts as one, as in the fit's own conditioning.

    Args:
        model: The blade.
        face_ids: Ids or names of planes and cylinders.
        max_condition: Ratio of best to worst held direction above which one is free.

    Raises:
        InputError: no face, an unknown one, or one that cannot be measured on.
    """
    faces = model.select(face_ids)
    unusable = [face for face in faces if not face.usable]
    if unusable or not faces:
        said = unusable[0].why_not if unusable else "The list of faces is empty."
        raise InputError(f"{said} Choose planes and cylinders.")
    places = [(target.anchors, target.patch.surface.normal_at(target.anchors))
              for target in map(make_target, merge_patches(faces))]
    centre = np.concatenate([points for points, _ in places]).mean(axis=0)
    information, squares = np.zeros((6, 6)), []
    for points, normals in places:
        arm = points - centre
        rows = np.hstack([np.cross(arm, normals), normals])
        information += rows.T @ rows / len(rows)
        squares.append(np.mean(np.sum(arm**2, axis=1)))
    lever = max(float(np.sqrt(np.mean(squares))), 1.0)
    return Hold(analyse_pose(information, lever), centre, lever, max_condition)
