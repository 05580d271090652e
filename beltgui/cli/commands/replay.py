"""`beltcal replay`: a recorded session computed again."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from beltgui.cli.arguments import Commands, add_command
from core.errors import InputError

if TYPE_CHECKING:
    from beltgui.cli.job import Job

DESCRIPTION = "Computes every step of a session again from its samples and says where the results differ."


def add(commands: Commands) -> None:
    """Declare the command."""
    parser = add_command(commands, "replay", "a recorded session computed again", DESCRIPTION, run)
    parser.add_argument("session", metavar="SESSION", help="folder of the session")


def run(args: argparse.Namespace, job: Job) -> dict[str, Any]:
    """Replay and compare."""
    import sqlite3

    from beltgui.cli.progress import told_on_stderr
    from beltgui.replay import replay_session
    from beltgui.steps.blocks import plain

    if not Path(args.session).is_dir():
        raise InputError(f"{args.session}: there is no such folder, expected the folder of a session.")
    try:
        with job.about(args.session):
            replay = replay_session(Path(args.session), told_on_stderr(job))
    except sqlite3.Error as error:
        raise InputError(f"{args.session}: the session's database is damaged or in use: {error}.") from error
    for path in replay.inputs:
        job.reads(str(path))
    reasons = [{"code": "OUTSIDE_LIMITS", "message": f"Step {step.step}: {step.differing_fields} fields differ from "
                                                     "what the session kept."}
               for step in replay.steps if not step.same]
    return {
        "verdict": {"ok": replay.same, "reasons": reasons},
        "session": plain(dict(replay.info)),
        "steps": [{"step": step.step, "accepted": step.accepted, "same": step.same,
                   "differing_fields": step.differing_fields} for step in replay.steps],
        "differences": [{"step": step.step, "field": one.field, "recorded": plain(one.recorded), "now": plain(one.now)}
                        for step in replay.steps for one in step.differences],
    }
