"""Faces that a person chose for a blade type, kept for the next session in a file of the user's own."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from beltgui.files import write_atomically
from core.cad import CadModel
from core.cad.blade_type import BladeType
from core.errors import InputError

HOME = "BELTCAL_HOME"
FILE = "faces.json"


def home() -> Path:
    """Folder of the user's own data: the environment's `BELTCAL_HOME`, or what the platform uses for it."""
    named = os.environ.get(HOME)
    if named:
        return Path(named)
    if sys.platform == "win32":
        return Path(os.environ.get("APPDATA") or Path.home() / "AppData" / "Roaming") / "beltcal"
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Application Support" / "beltcal"
    return Path(os.environ.get("XDG_DATA_HOME") or Path.home() / ".local" / "share") / "beltcal"


def remembered_faces(blade: BladeType, model: CadModel) -> tuple[int, ...] | None:
    """Ids of the faces chosen last for a type; None if none were, or for another version of its CAD model.

    Raises:
        InputError: the user's file cannot be read.
    """
    entry = _read().get(blade.name)
    if not isinstance(entry, dict) or entry.get("model_sha256") != model.sha256:
        return None
    usable = {face.id for face in model.faces if face.usable}
    faces = entry.get("faces")
    if not isinstance(faces, list) or not faces or not usable.issuperset(faces):
        return None
    return tuple(int(number) for number in faces)


def remember_faces(blade: BladeType, model: CadModel, face_ids: Sequence[int]) -> None:
    """Keep the choice for the next session; the blade type's own file is never changed.

    Raises:
        InputError: the user's file cannot be read or written.
    """
    everything = {**_read(), blade.name: {"model_sha256": model.sha256, "faces": sorted(face_ids)}}
    path = home() / FILE
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(path, (json.dumps(everything, indent=2) + "\n").encode())
    except OSError as error:
        raise InputError(f"{path}: the chosen faces cannot be kept ({error.strerror}).") from error


def _read() -> dict[str, Any]:
    path = home() / FILE
    if not path.exists():
        return {}
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, json.JSONDecodeError) as error:
        message = f"{path}: the chosen faces cannot be read ({error}). Remove the file to begin anew."
        raise InputError(message) from error
    if not isinstance(found, dict):
        raise InputError(f"{path}: this is no list of chosen faces. Remove the file to begin anew.")
    return found
