"""One commissioning from nothing to the exported programs, killed at random moments on the way."""

from __future__ import annotations

import random
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from beltgui.steps.graph import NEEDS
from benchmarks.kill_and_reopen import reader
from benchmarks.kill_and_reopen.pilot import Announced, Line, MissedError, Pilot

PERSON = "A. Person"
GRID = (33, 20)
# Samples of a step, to spread the kills over its time; nothing depends on the true numbers.
PLANNED = {"ball": 20, "base": 15, "rough": 2, "fine": 2, "tool": 26, "error_surface": 23}
# How long after a command the kill comes at the latest, s: about what the work takes.
WITHIN_S = {"begin": 1.0, "acquire": 0.8, "solve": 1.5, "edit": 0.4, "accept": 0.04, "export": 4.0, "reopen": 5.0}
OPEN = {"not started", "running", "failed"}


@dataclass(frozen=True)
class Stage:
    """Work to be done, and how often it is killed before it is let come to its end.

    Attributes:
        kind: `begin`, `acquire`, `solve`, `edit`, `accept` or `export`.
        step: Of the six.
        kills: How many.
        finish: Bring it to its end.
        reopen: How many of the kills are followed by another one while the session is opened again.
    """

    kind: str
    step: str = ""
    kills: int = 0
    finish: bool = True
    reopen: int = 0


@dataclass
class Kill:
    """One kill and what was found after it."""

    run: str
    moment: str
    parent: bool
    announced: int = 0
    found: int = 0
    rail_s: float = float("nan")
    solved_s: float = float("nan")
    problems: list[str] = field(default_factory=list)


@dataclass
class Lane:
    """Runs the stages one after the other.

    Attributes:
        folder: For session and export.
        stages: What to do.
        seed: Of the moments and of the simulated cell.
        name: Of the run.
        parents: Share of the kills that hit the screen and its whole process group too.
        kills: What came of each.
        missed: Why it did not come to its end; empty if it did.
    """

    folder: Path
    stages: list[Stage]
    seed: int
    parents: float = 0.4
    name: str = ""
    kills: list[Kill] = field(default_factory=list)
    missed: str = ""

    def __post_init__(self) -> None:
        self._chance = random.Random(self.seed)
        self._session = self.folder / "session"
        self._out = self.folder / "export"
        self._seen: dict[int, tuple[Any, ...]] = {}
        self._temporary = self.folder / "tmp"
        self._temporary.mkdir(parents=True)
        self._pilot = Pilot(Announced(), self._temporary)

    def run(self) -> None:
        """All stages; `missed` says if the run did not come to its end."""
        try:
            self._pilot.start()
            for stage in self.stages:
                self._stage(stage)
        except MissedError as missed:
            self.missed = str(missed)
        finally:
            self._pilot.close()
        left = [path.name for path in self._temporary.iterdir()]
        if left and not self.missed:
            self.missed = f"left in the folder of temporary files: {left}"

    def _stage(self, stage: Stage) -> None:
        work = getattr(self, f"_{stage.kind}")
        for number in range(stage.kills):
            before = self._pilot.announced.states()
            self._pilot.forget()
            allowed = work(stage, stage.kills - number)
            kill = self._kill(f"{TITLE[stage.kind]} {stage.step}".strip())
            self._after(kill, stage, allowed)
            if number < stage.reopen:
                kill = self._kill_reopening(stage)
            self._reopen(kill, stage, before)
        if stage.finish:
            getattr(self, f"_finish_{stage.kind}")(stage)

    # ---- kill, look, open again

    def _within(self, kind: str) -> None:
        """Let a random time pass: it is the moment of the kill."""
        time.sleep(self._chance.uniform(0.0, WITHIN_S[kind]))

    def _kill(self, moment: str) -> Kill:
        kill = Kill(self.name, moment, self._chance.random() < self.parents)
        self._pilot.kill(parent=kill.parent)
        self.kills.append(kill)
        print(f"run {self.name}, kill {len(self.kills)}: {moment}", file=sys.stderr, flush=True)
        return kill

    def _after(self, kill: Kill, stage: Stage, allowed: list[reader.Flags] | None) -> None:
        """What lies on the disk, before anything opens it."""
        announced = self._pilot.announced
        kill.announced = len(announced.samples)
        if not reader.exists(self._session):
            if announced.steps:
                kill.problems.append("the session is gone")
            return
        found = reader.read(self._session)
        kill.found = len(found.rows)
        kill.problems += found.problems
        self._compare(found, kill)
        for step, flags in found.flags.items():
            expected = allowed if step == stage.step and allowed is not None else [dict.fromkeys(flags, (True, False))]
            if flags not in expected:
                kill.problems.append(f"{step}: other samples are left out or deleted than were")
        kill.problems += reader.half_exported(self._out)

    def _compare(self, found: reader.Found, kill: Kill) -> None:
        """With what was announced, and with what was there at the last kill."""
        announced = self._pilot.announced
        lost = [number for number in announced.samples if number not in found.rows]
        if lost:
            kill.problems.append(f"samples lost: {lost}")
        changed = [number for number, row in self._seen.items() if found.rows.get(number) != row]
        if changed:
            kill.problems.append(f"samples changed: {changed}")
        self._seen.update(found.rows)
        if announced.accepted - found.accepted:
            kill.problems.append(f"acceptances lost: {sorted(announced.accepted - found.accepted)}")

    def _kill_reopening(self, stage: Stage) -> Kill:
        flags = reader.read(self._session).flags[stage.step] if reader.exists(self._session) else {}
        self._pilot.start()
        self._pilot.forget()
        self._open()
        self._within("reopen")
        kill = self._kill(f"opening again, after {TITLE[stage.kind]} {stage.step}".strip())
        self._after(kill, stage, [flags])
        return kill

    def _open(self) -> None:
        if reader.exists(self._session):
            self._pilot.send("OpenSession", folder=str(self._session), person=PERSON)
        else:
            self._new()

    def _new(self) -> None:
        self._pilot.send(
            "NewSession", folder=str(self._session), person=PERSON, seed=self.seed, resolution="test", speed=0.0,
            grid=GRID,
        )  # fmt: skip

    def _reopen(self, kill: Kill, stage: Stage, before: dict[str, str]) -> None:
        """Go on with the session: the rail is as it was, nothing is left over."""
        begun = time.monotonic()
        self._pilot.start()
        self._pilot.forget()
        self._open()
        rail: dict[str, str] = {}
        for step in NEEDS:
            line = self._pilot.wait(lambda line, step=step: line["what"] == "step" and line["step"] == step)
            rail[step] = line["state"]
        kill.rail_s = time.monotonic() - begun
        self._pilot.done()
        kill.solved_s = time.monotonic() - begun
        found = reader.read(self._session)
        for shown in (rail, self._pilot.announced.states()):
            kill.problems += _other_states(before, shown, stage, found)
        kill.problems += [*found.problems, *reader.leftovers(self._session, found)]
        self._compare(found, kill)
        self._put_back(stage)

    def _put_back(self, stage: Stage) -> None:
        """Take back what was under way when an edit was killed."""
        while stage.kind == "edit" and self._edited(stage.step):
            self._pilot.work("Undo", step=stage.step)

    def _edited(self, step: str) -> bool:
        return any(flags != (True, False) for flags in reader.read(self._session).flags[step].values())

    # ---- begin

    def _begin(self, stage: Stage, left: int) -> None:
        """Each kill in a folder of its own: a session that has begun cannot begin again."""
        self._session = self.folder / f"session {left}"
        self._pilot.announced = Announced()
        self._seen.clear()
        self._new()
        if self._chance.random() < 0.5:  # while its files are made
            _until(lambda: self._session.exists())
            time.sleep(self._chance.uniform(0.0, 0.1))
        else:
            self._within("begin")

    def _finish_begin(self, stage: Stage) -> None:
        if not stage.kills:
            self._pilot.forget()
            self._new()
            self._pilot.done()

    # ---- acquire, solve, accept

    def _acquire(self, stage: Stage, left: int) -> None:
        there = len(self._pilot.announced.rows(stage.step))
        share = max(0, PLANNED[stage.step] - there) / left
        wanted = there + self._chance.randint(0, max(0, round(1.5 * share)))
        self._pilot.send("Acquire", step=stage.step)
        self._pilot.wait(lambda line: line["what"] == "begun" or _over(line))
        self._pilot.wait(lambda line: _over(line) or (line["what"] == "step" and line["step"] == stage.step
                                                      and len(line["rows"]) >= wanted))  # fmt: skip
        self._within("acquire")

    def _finish_acquire(self, stage: Stage) -> None:
        announced = self._pilot.announced
        # After a step was accepted, the steps that stand on it are shown one after the other.
        self._pilot.until(lambda: announced.can(stage.step, "acquire") or announced.steps[stage.step]["complete"])
        if not announced.steps[stage.step]["complete"]:
            self._pilot.work("Acquire", step=stage.step)
        shown = announced.steps[stage.step]
        if not shown["complete"]:
            raise MissedError(f"{stage.step} is not complete: {shown['reasons']}")

    def _solve(self, stage: Stage, left: int) -> None:
        self._pilot.send("Solve", step=stage.step)
        self._within("solve")

    def _finish_solve(self, stage: Stage) -> None:
        self._pilot.work("Solve", step=stage.step)

    def _accept(self, stage: Stage, left: int) -> None:
        self._ready(stage.step)
        self._pilot.send("Accept", step=stage.step)
        self._within("accept")

    def _finish_accept(self, stage: Stage) -> None:
        if self._pilot.announced.states()[stage.step] != "accepted":
            self._ready(stage.step)
            self._pilot.forget()
            self._pilot.send("Accept", step=stage.step)
            self._pilot.wait(lambda line: line["what"] == "step" and line["step"] == stage.step
                             and line["state"] == "accepted")  # fmt: skip

    def _ready(self, step: str) -> None:
        announced = self._pilot.announced
        if announced.states()[step] != "accepted" and not announced.can(step, "accept"):
            raise MissedError(f"{step} cannot be accepted: {announced.steps[step]['reasons']}")

    # ---- edits

    def _edit(self, stage: Stage, left: int) -> list[reader.Flags]:
        """Some of a row of edits; gives what may lie on the disk: as after each of those that may have been done."""
        rows = self._pilot.announced.rows(stage.step)
        kept = dict(reader.read(self._session).flags[stage.step])
        one, other = self._chance.sample(rows, 2)
        row: list[tuple[Line, reader.Flags]] = [
            ({"do": "Include", "sample_id": one, "on": False}, {**kept, one: (False, False)}),
            ({"do": "Undo"}, kept),
            ({"do": "Redo"}, {**kept, one: (False, False)}),
            ({"do": "Undo"}, kept),
            ({"do": "Delete", "sample_id": other}, {**kept, other: (True, True)}),
            ({"do": "Undo"}, kept),
            ({"do": "StartOver"}, dict.fromkeys(kept, (True, True))),
            ({"do": "Undo"}, kept),
        ]
        allowed, sent = [kept], self._chance.randint(1, len(row))
        for number, (command, after) in enumerate(row[:sent], start=1):
            words = {key: value for key, value in command.items() if key != "do"}
            self._pilot.send(command["do"], step=stage.step, **words)
            allowed.append(after)
            if number < sent:
                ended = self._pilot.ended_jobs()
                self._pilot.wait(lambda line, ended=ended: self._pilot.ended_jobs() > ended, 0.3, late=True)
        self._within("edit")
        return allowed[self._pilot.ended_jobs():]

    def _finish_edit(self, stage: Stage) -> None:
        """Everything was taken back, so everything that was accepted still is."""
        self._put_back(stage)

    # ---- export

    def _export_ready(self) -> None:
        """Where samples were missing when it was opened again, the steps after them wait for being solved."""
        for step in NEEDS:
            if not self._pilot.announced.can("error_surface", "export"):
                self._pilot.work("Solve", step=step)
        if not self._pilot.announced.can("error_surface", "export"):
            raise MissedError(f"export is locked: {self._pilot.announced.states()}")

    def _send_export(self) -> None:
        self._export_ready()
        self._pilot.forget()
        self._pilot.send("Export", folder=str(self._out))

    def _export(self, stage: Stage, left: int) -> None:
        self._send_export()
        self._within("export")

    def _finish_export(self, stage: Stage) -> None:
        self._send_export()
        files = self._pilot.wait(lambda line: line["what"] == "exported")["files"]
        self._pilot.done()
        problems = reader.export_problems(self._out, [Path(name).name for name in files])
        found = reader.read(self._session)
        if problems or found.accepted != set(NEEDS):
            raise MissedError(f"accepted: {sorted(found.accepted)}; {problems}")


TITLE = {
    "begin": "beginning the session", "acquire": "taking samples of", "solve": "solving", "edit": "editing",
    "accept": "accepting", "export": "exporting",
}  # fmt: skip


def _over(line: Line) -> bool:
    return line["what"] in ("ended", "Refused")


def _until(there: Any, timeout_s: float = 60.0) -> None:
    end = time.monotonic() + timeout_s
    while not there():
        if time.monotonic() > end:
            raise MissedError("the session's folder did not come")
        time.sleep(0.001)


def _other_states(before: dict[str, str], now: dict[str, str], stage: Stage, found: reader.Found) -> Iterator[str]:
    """Steps whose state on the rail is not the one announced before the work that was killed, nor one it leads to."""
    for step, last in before.items():
        may = {last}
        if step == stage.step and last in OPEN:
            may |= OPEN
            if stage.kind == "edit":
                may |= {"stale"}
            if stage.kind == "accept" and step in found.accepted:
                may = {"accepted"}
        elif stage.kind == "edit" and (step == stage.step or stage.step in _ancestors(step)):
            as_before = all(flags == (True, False) for flags in found.flags[stage.step].values())
            may = {last} if as_before and step != stage.step else OPEN | {"stale", last}
        if now.get(step) not in may:
            yield f"{step}: {now.get(step)} on the rail, was {last}"


def _ancestors(step: str) -> set[str]:
    return {name for need in NEEDS[step] for name in {need, *_ancestors(need)}}
