"""`beltcal gui`: the application."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from beltgui.cli.arguments import Commands, add_command

if TYPE_CHECKING:
    from beltgui.cli.job import Job


def add(commands: Commands) -> None:
    """Declare the command."""
    parser = add_command(commands, "gui", "the application", "Opens the application.", run, writes_file=False)
    parser.add_argument("--sim", action="store_true", help="work on the simulated cell")
    parser.add_argument("--config", metavar="CELL.toml", help="the cell")
    parser.add_argument("--session", metavar="FOLDER", help="open this session at once")
    parser.add_argument("--person", metavar="NAME", help="who works; kept with every decision")
    parser.add_argument("--theme", choices=("system", "light", "dark"), help="colours; remembered")
    parser.add_argument("--language", choices=("en", "zh_CN"), help="language of the screen; remembered")


def run(args: argparse.Namespace, job: Job) -> int:
    """Open the window and stay until it is closed."""
    from beltgui.files import check_input

    if args.config is not None:
        check_input(args.config)
    if args.session is not None:
        check_input(str(Path(args.session) / "session.db"))
    from beltgui.app.main import run as run_application

    return run_application(
        sim=args.sim,
        config=Path(args.config) if args.config else None,
        session=Path(args.session) if args.session else None,
        person=(args.person or "").strip(),
        theme=args.theme or "",
        language=args.language or "",
    )
