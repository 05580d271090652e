"""Begins a session, or finds again everything that an existing one was made with."""

from __future__ import annotations

import shutil
from collections.abc import Mapping
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from beltgui import __version__
from beltgui.engine.messages import NewSession, OpenSession
from beltgui.session import INPUTS, Session
from core.cad.blade_type import BladeType, read_blade_type
from core.errors import InputError
from devices.cell_plan import CellFileError, read_cell_file, read_plan
from resources import blade_type_path, resource_path

GRINDER = "fine"


@dataclass(frozen=True, eq=False)
class Opened:
    """A session and what it was begun with.

    Attributes:
        session: Open.
        info: What it says of itself.
        cell_file: Its own copy.
        blade: The type, from its own copy, with the grid of the session.
        date: When it was begun.
    """

    session: Session
    info: Mapping[str, Any]
    cell_file: Path
    blade: BladeType
    date: str


def begin(command: NewSession) -> Opened:
    """Begin a session; the inputs are copied into it, so that it can be gone on with when they have changed.

    Raises:
        InputError: there is a session already, an input cannot be used, or the folder cannot be written.
    """
    folder = Path(command.folder)
    try:
        blade = read_blade_type(blade_type_path(command.blade_type))
        cell_file = Path(command.cell_file) if command.cell_file else resource_path("cells", "simulated.toml")
    except FileNotFoundError as error:
        raise InputError(str(error)) from error
    _check_cell(cell_file)
    _check_person(command.person)
    serial = command.serial.strip() or f"{blade.name}-0001"
    if not blade.accepts_serial(serial):
        raise InputError(
            f"'{serial}' is no serial number of the blade type {blade.name}; expected the pattern "
            f"{blade.serial_pattern}. Scan it again."
        )
    grid = command.grid or (blade.probing.u_count, blade.probing.v_count)
    info = {
        "software": __version__, "blade": blade.path.name, "blade_type": blade.name, "cell": cell_file.name,
        "serial": serial, "grinder": GRINDER, "date": datetime.now(UTC).date().isoformat(), "person": command.person,
        "simulated": True, "seed": command.seed, "resolution": command.resolution, "speed": command.speed,
        "probing_grid": list(grid),
    }  # fmt: skip
    return _with_inputs(Session.create(folder, info, fill=lambda: _keep_inputs(folder / INPUTS, cell_file, blade)))


def go_on(command: OpenSession) -> Opened:
    """Open an existing session.

    Raises:
        InputError: there is none, somebody else writes it, or an input is missing.
    """
    _check_person(command.person)
    return _with_inputs(Session.open(Path(command.folder), write=not command.read_only))


def _check_person(person: str) -> None:
    if not person.strip():
        raise InputError("Nobody is named who works. Enter a name: it is kept with every decision.")


def _check_cell(cell_file: Path) -> None:
    """Before anything is written: a session that cannot be gone on with must not begin."""
    from devices.sim.settings import truth_settings

    try:
        read_plan(cell_file)
        truth_settings(read_cell_file(cell_file), str(cell_file), {})
    except CellFileError as error:
        raise InputError(str(error)) from error


def _with_inputs(session: Session) -> Opened:
    try:
        info, inputs = session.info(), session.folder / INPUTS
        blade = read_blade_type(inputs / _text(info, "blade", session))
        if "probing_grid" in info:
            u_count, v_count = info["probing_grid"]
            blade = replace(blade, probing=replace(blade.probing, u_count=u_count, v_count=v_count))
        cell_file = inputs / _text(info, "cell", session)
        if not cell_file.is_file():
            raise InputError(f"{cell_file}: the session's cell file is missing. Copy the whole folder again.")
        return Opened(session, info, cell_file, blade, _text(info, "date", session))
    except BaseException:
        session.close()
        raise


def _text(info: Mapping[str, Any], key: str, session: Session) -> str:
    value = info.get(key)
    if not isinstance(value, str):
        raise InputError(f"{session.folder}: the session does not say its {key}. It is not one of a commissioning.")
    return value


def _keep_inputs(folder: Path, cell_file: Path, blade: BladeType) -> None:
    try:
        folder.mkdir(exist_ok=True)
        for source in (cell_file, blade.path, blade.step_path):
            shutil.copyfile(source, folder / source.name)
    except OSError as error:
        raise InputError(f"{folder}: the session's inputs cannot be written ({error.strerror}).") from error
