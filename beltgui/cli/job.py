"""What a command gathers besides its result: which files it read, and what the user should know."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from beltgui.cli.fields import Field, read_json
from beltgui.files import check_input, sha256_of
from core.clouds import Cloud, read_cloud
from core.errors import InputError

if TYPE_CHECKING:
    from core.cad import CadModel

# Keys for people, allowed everywhere and never read.
_REMARKS = ("name", "comment")


@dataclass
class Job:
    """One run of a command.

    Attributes:
        inputs: Path and SHA-256 of each file read, for the record.
    """

    inputs: list[dict[str, str]] = field(default_factory=list)

    def reads(self, path: str) -> None:
        """Put a file into the record."""
        if all(entry["path"] != path for entry in self.inputs):
            self.inputs.append({"path": path, "sha256": sha256_of(path)})

    def json(self, path: str) -> Field:
        """Read a JSON file and put it into the record."""
        root = read_json(path)
        self.reads(path)
        return root

    def cloud(self, path: str) -> Cloud:
        """Read a point cloud and put it into the record; dropped points are reported."""
        cloud = read_cloud(path)
        self.reads(path)
        if cloud.dropped:
            self.say(f"{path}: {cloud.dropped} of {cloud.total} points are no measurement and were dropped.")
        return cloud

    def step(self, path: str) -> CadModel:
        """Read a STEP file and put it into the record."""
        from core.cad import read_step

        check_input(path)
        with self.about(path):
            model = read_step(path)
        self.reads(path)
        if model.lost_faces:
            self.say(f"{path}: {model.lost_faces} degenerate faces could not be made and are left out.")
        return model

    def rows(self, root: Field, name: str, known: tuple[str, ...], also: tuple[str, ...] = ()) -> list[Field]:
        """The objects of the list under a key.

        Keys that nobody reads are told, because a misspelt option must not be silent.

        Args:
            root: The whole file.
            name: Key of the list.
            known: Keys that its objects may have.
            also: Further keys that the file may have at its top.
        """
        items = list(root.key(name).items(name))
        unknown = root.unknown_keys(name, *also, *_REMARKS)
        unknown += [key for item in items for key in item.unknown_keys(*known, *_REMARKS)]
        if unknown:
            shown = ", ".join(key[:60] for key in unknown[:3]) + (" and more" if len(unknown) > 3 else "")
            self.say(f"{root.file}: not known and not used: {shown}.")
        return items

    def warn_if_rejected(self, root: Field) -> None:
        """Say that an earlier step's result was rejected, if the file is one and it was."""
        if _was_rejected(root):
            self.say(f"{root.file}: this result was rejected by its own step; what follows is no better.")

    def refuse_if_rejected(self, root: Field) -> None:
        """Refuse an earlier step's result that was rejected, where nothing later would notice.

        Raises:
            InputError: the file is a result whose verdict is reject.
        """
        if _was_rejected(root):
            raise InputError(f"{root.file}: this result was rejected by its own step, expected an accepted one. Repeat "
                             "that step.")

    def say(self, message: str) -> None:
        """A message or warning for the person; never on stdout, where the result goes."""
        print(f"beltcal: {message}", file=sys.stderr, flush=True)

    @contextmanager
    def about(self, path: str) -> Iterator[None]:
        """Errors from the mathematics inside this block get the file's name in front."""
        try:
            yield
        except InputError as error:
            if path in str(error):
                raise
            raise type(error)(f"{path}: {error}", error.code) from error


def _was_rejected(root: Field) -> bool:
    verdict = root.value.get("verdict")
    return isinstance(verdict, dict) and verdict.get("ok") is not True
