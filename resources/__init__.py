"""Files that come with the program: blade types with their CAD models, cells."""

from __future__ import annotations

from importlib.resources import files
from pathlib import Path


def resource_path(*parts: str) -> Path:
    """Path of a file of this package, e.g. `resource_path("cells", "simulated.toml")`.

    Raises:
        FileNotFoundError: the package has no such file.
    """
    path = Path(str(files(__name__))).joinpath(*parts)
    if not path.exists():
        raise FileNotFoundError(f"{'/'.join(parts)} is not part of this installation (looked in {path.parent}).")
    return path


def blade_type_path(name: str) -> Path:
    """Path of the type file of a blade type that comes with the program, e.g. `blade_type_path("DR95")`.

    Raises:
        FileNotFoundError: there is no such type; the message lists those that there are.
    """
    path = Path(str(files(__name__))) / "blades" / f"{name.lower()}.toml"
    if not path.exists():
        raise FileNotFoundError(f"no blade type {name!r} comes with this installation; there are: "
                                f"{', '.join(blade_type_names())}.")
    return path


def blade_type_names() -> tuple[str, ...]:
    """Names of the blade types that come with the program, in alphabetical order."""
    folder = Path(str(files(__name__))) / "blades"
    return tuple(sorted(path.stem.upper() for path in folder.glob("*.toml")))
