"""Entry point of `beltcal`."""

from __future__ import annotations

import importlib
import os
import sys
from collections.abc import Sequence
from typing import Any

from beltgui import __version__
from beltgui.cli.arguments import Parser
from core.errors import InputError

OK, REJECTED, UNUSABLE, INTERRUPTED = 0, 1, 2, 130

# In the order of the work; each module adds its own arguments and imports the heavy packages only when it runs.
COMMANDS = ("ball", "stage", "base", "rough", "faces", "fine", "stylus", "tool", "error_surface", "path", "demo",
            "replay", "gui")


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command.

    Returns:
        0: computed and within limits. 1: rejected, the JSON says why. 2: unusable input or usage, stderr says what.
        130: interrupted.
    """
    try:
        return _run(sys.argv[1:] if argv is None else list(argv))
    except InputError as error:
        print(f"beltcal: {_one_line(str(error))}", file=sys.stderr)
        return UNUSABLE
    except BrokenPipeError:
        # Whoever read our output has gone; nobody is left to tell.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return UNUSABLE
    except OSError as error:
        place = f"{error.filename}: " if error.filename else ""
        print(f"beltcal: {place}{error.strerror or error}.", file=sys.stderr)
        return UNUSABLE
    except KeyboardInterrupt:
        print("beltcal: interrupted.", file=sys.stderr)
        return INTERRUPTED


def _run(argv: list[str]) -> int:
    parser = build_parser()
    try:
        args = parser.parse_args(argv)
    except SystemExit as stop:  # --help and --version end here
        return int(stop.code or 0)
    if args.out is not None:
        _check_out(args)
    elif sys.stdout is None:
        raise InputError("stdout is closed and there is no --out FILE: the result would have nowhere to go.")
    from beltgui.cli.job import Job

    job = Job()
    record = args.run(args, job)
    if isinstance(record, int):
        return record
    return _deliver(record, args, job.inputs)


def _deliver(record: dict[str, Any], args: Any, inputs: list[dict[str, str]]) -> int:
    from beltgui.cli.output import as_json, as_table, print_whole
    from beltgui.files import write_atomically

    whole = {"command": args.command, "software": __version__, "inputs": inputs, **record}
    text = as_json(whole)
    if args.out is not None:
        write_atomically(args.out, text.encode())
    if sys.stdout is not None:
        wants_table = args.table or (sys.stdout.isatty() and not args.json)
        print_whole((args.as_table or as_table)(whole) if wants_table else text)
    return OK if record["verdict"]["ok"] else REJECTED


def _check_out(args: Any) -> None:
    from beltgui.files import check_writable

    if not args.out:
        raise InputError("argument --out: the name is empty, expected a file name.")
    check_writable(args.out)
    target = os.path.realpath(args.out)
    named = [value for name, value in vars(args).items() if name not in ("out", "command", "run", "as_table")]
    for value in named:
        for word in value if isinstance(value, list) else [value]:
            if isinstance(word, str) and word and os.path.realpath(word) == target:
                raise InputError(f"{args.out}: this is also an input. Choose another name for --out.")


def build_parser() -> Parser:
    """The parser of all commands."""
    parser = Parser(prog="beltcal", allow_abbrev=False,
                    description="Calibrates a robotic belt grinding cell from measured data. Lengths in mm, angles in "
                                "degrees at this boundary.",
                    epilog="Exit code 0: computed and within limits. 1: rejected, the JSON says why. 2: unusable input "
                           "or usage, stderr says what.")
    parser.add_argument("--version", action="version", version=f"beltcal {__version__}")
    commands = parser.add_subparsers(metavar="COMMAND", required=True, parser_class=Parser)
    for name in COMMANDS:
        importlib.import_module(f"beltgui.cli.commands.{name}").add(commands)
    return parser


def _one_line(text: str) -> str:
    return " ".join(text.split())


if __name__ == "__main__":
    sys.exit(main())
