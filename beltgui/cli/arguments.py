"""Types of command-line arguments and the options that all commands share."""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable
from typing import Any, NoReturn

from core.errors import InputError

# The subparsers object of argparse has no public type.
Commands = Any


class Parser(argparse.ArgumentParser):
    """argparse, whose complaints are one sentence instead of a page."""

    def error(self, message: str) -> NoReturn:
        """Raise instead of printing the whole usage."""
        raise InputError(f"{message.rstrip('.')}. See {self.prog} --help.")


def add_command(commands: Commands, name: str, summary: str, description: str,
                run: Callable[..., dict[str, Any] | int], *, writes_file: bool = True) -> argparse.ArgumentParser:
    """A subcommand with the common options; `run(args, job)` returns its record, or an exit code if it has none."""
    parser: argparse.ArgumentParser = commands.add_parser(
        name, help=summary, description=description, allow_abbrev=False,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.set_defaults(run=run, command=name, out=None, as_table=None)
    common = parser.add_argument_group("output")
    form = common.add_mutually_exclusive_group()
    form.add_argument("--json", action="store_true",
                      help="print one JSON object (the default when stdout is not a terminal)")
    form.add_argument("--table", action="store_true", help="print a table (the default on a terminal)")
    if writes_file:
        common.add_argument("--out", metavar="FILE", help="write the JSON to this file, whole or not at all")
    return parser


def add_limits(parser: argparse.ArgumentParser) -> None:
    """The option that replaces the default limits of the verdict."""
    parser.add_argument("--limits", metavar="FILE.toml", help="limits of the verdict instead of the defaults")


def positive_mm(text: str) -> float:
    """A length above 0 and below one metre."""
    value = _number(text)
    if not 0.0 < value <= 1000.0:
        raise argparse.ArgumentTypeError(f"expected a length in mm above 0 and up to 1000, found {text[:30]!r}")
    return value


def whole_number(text: str) -> int:
    """A whole number from 0 up to 2^31."""
    if not (text.isascii() and text.isdigit() and len(text) <= 10 and int(text) < 2**31):
        raise argparse.ArgumentTypeError(f"expected a whole number from 0, found {text[:30]!r}")
    return int(text)


def length_mm(text: str) -> float:
    """A length from 0 up to 1000 mm."""
    value = _number(text)
    if not 0.0 <= value <= 1000.0:
        raise argparse.ArgumentTypeError(f"expected a length from 0 to 1000 mm, found {text[:30]!r}")
    return value


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return math.nan
