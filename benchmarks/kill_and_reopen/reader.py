"""Reads a session with plain sqlite3 and NumPy, without any code of the program, and says what is wrong with it."""

from __future__ import annotations

import hashlib
import json
import re
import shutil
import sqlite3
import tempfile
from collections import defaultdict
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

Flags = dict[int, tuple[bool, bool]]
DATABASE = "session.db"
BESIDE = {DATABASE, "session.db-wal", "session.db-shm", "session.lock", "simulated_cell.json"}
SCRIPT_END = re.compile(r"\nend\n\w+\(\)\s*$")


@dataclass
class Found:
    """A session as it lies on the disk.

    Attributes:
        rows: By sample: step, kind, data, name of the cloud, SHA-1 of the cloud.
        flags: By step and sample: included, deleted.
        accepted: Steps with an acceptance whose result is there.
        problems: What is not whole.
    """

    rows: dict[int, tuple[Any, ...]] = field(default_factory=dict)
    flags: dict[str, Flags] = field(default_factory=lambda: defaultdict(dict))
    accepted: set[str] = field(default_factory=set)
    problems: list[str] = field(default_factory=list)


def exists(folder: Path) -> bool:
    """There is a session under its name."""
    return (folder / DATABASE).exists()


def read(folder: Path) -> Found:
    """Everything in a session's folder.

    The database is copied with its log and read there: opening it in its place would repair what the program is to
    repair.
    """
    found = Found()
    with tempfile.TemporaryDirectory(prefix="kill_and_reopen_") as name:
        for suffix in ("", "-wal"):
            source = folder / (DATABASE + suffix)
            if source.exists():
                shutil.copyfile(source, Path(name) / source.name)
        connection = sqlite3.connect(Path(name) / DATABASE)
        try:
            said = [row[0] for row in connection.execute("PRAGMA integrity_check")]
            if said != ["ok"]:
                found.problems.append(f"integrity check: {said[0]}")
            _rows(connection, folder, found)
            known = {row[0] for row in connection.execute("SELECT id FROM result")}
            for step, result in connection.execute("SELECT step, result FROM decision WHERE what = 'accepted'"):
                if result in known:
                    found.accepted.add(step)
                else:
                    found.problems.append(f"{step}: accepted result {result} is not there")
            for table, column in (("result", "record"), ("edit", "changes"), ("setting", "value"), ("info", "value")):
                for (text,) in connection.execute(f"SELECT {column} FROM {table}"):
                    json.loads(text)
        except (sqlite3.DatabaseError, json.JSONDecodeError) as error:
            found.problems.append(f"the database cannot be read: {error}")
        finally:
            connection.close()
    return found


def _rows(connection: sqlite3.Connection, folder: Path, found: Found) -> None:
    shapes: set[tuple[int, ...]] = set()
    wanted = "SELECT id, step, kind, data, cloud, included, deleted FROM sample"
    for number, step, kind, data, cloud, included, deleted in connection.execute(wanted):
        found.flags[step][number] = (bool(included), bool(deleted))
        json.loads(data)
        digest = ""
        if cloud is not None:
            path = folder / cloud
            try:
                points = np.load(path, allow_pickle=False)
            except (OSError, ValueError, EOFError) as error:
                found.problems.append(f"sample {number}: cloud: {error}")
                continue
            shapes.add(points.shape)
            digest = hashlib.sha1(path.read_bytes()).hexdigest()
            if points.dtype != np.float32 or path.stat().st_size < points.nbytes or not np.isfinite(points).any():
                found.problems.append(f"sample {number}: its cloud is not whole")
        found.rows[number] = (step, kind, data, cloud, digest)
    if len(shapes) > 1:  # one scanner, one resolution
        found.problems.append(f"clouds of several shapes: {sorted(shapes)}")


def leftovers(folder: Path, found: Found) -> list[str]:
    """Files in a session that was opened to go on with it which do not belong there."""
    clouds = {row[3] for row in found.rows.values()}
    strange = []
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder).as_posix()
        hidden = path.name.startswith(".")
        if path.is_file() and name not in BESIDE | clouds and (hidden or not name.startswith("inputs/")):
            strange.append(f"left over: {name}")
    return strange


def half_exported(folder: Path) -> list[str]:
    """Exported files that are neither whole nor absent; temporary names do not count."""
    problems = []
    for path in sorted(folder.glob("[!.]*")) if folder.exists() else []:
        text = path.read_text(encoding="utf-8")
        match path.suffix:
            case ".script":
                whole = SCRIPT_END.search(text) is not None
            case ".json":
                try:
                    whole = bool(json.loads(text))
                except json.JSONDecodeError:
                    whole = False
            case _:
                whole = text.rstrip().endswith("</html>")
        if not whole:
            problems.append(f"half-written: {path.name}")
    return problems


def export_problems(folder: Path, names: list[str]) -> list[str]:
    """What is wrong with an export that was reported as done."""
    there = sorted(path.name for path in folder.iterdir())
    problems = [] if there == sorted(names) else [f"exported {there}, announced {sorted(names)}"]
    proof = json.loads((folder / "programs.proof.json").read_text(encoding="utf-8"))
    for program in proof["programs"]:
        if hashlib.sha256((folder / program["path"]).read_bytes()).hexdigest() != program["sha256"]:
            problems.append(f"{program['path']}: not what was proven")
    if len(proof["programs"]) != sum(name.endswith(".script") for name in names):
        problems.append("a program has no proof")
    return problems + half_exported(folder)
