"""The record as strict JSON for programs, or as an aligned table for people."""

from __future__ import annotations

import json
import sys
from typing import Any

from beltgui.steps.blocks import plain
from core.errors import InputError

_UNITS = {"_mm2": "mm²", "_mm": "mm", "_deg": "°", "_percent": "%", "_um": "µm", "_per_mm": "1/mm"}
_LONGEST_TABLE = 60


def as_json(record: dict[str, Any]) -> str:
    """One JSON object without NaN or infinity (they become null)."""
    # ASCII only: it survives any locale, and file names that are no UTF-8.
    return json.dumps(plain(record), indent=1, allow_nan=False) + "\n"


def print_whole(text: str) -> None:
    """Write to stdout at once, so that a full disk is noticed here; signs that a terminal lacks become `?`.

    Raises:
        InputError: stdout cannot take it.
        BrokenPipeError: whoever read it has gone.
    """
    encoding = sys.stdout.encoding or "utf-8"
    try:
        sys.stdout.write(text.encode(encoding, "replace").decode(encoding))
        sys.stdout.flush()
    except BrokenPipeError:
        raise
    except OSError as error:
        raise InputError(f"stdout: the result cannot be written: {error.strerror}.") from error


def as_table(record: dict[str, Any]) -> str:
    """A readable table; long lists are cut, the JSON has them in full."""
    verdict = record["verdict"]
    lines = _section(plain({key: value for key, value in record.items() if key not in ("verdict", "inputs")}), 0)
    lines += [f"input       {entry['path']}" for entry in record["inputs"]]
    lines.append("")
    lines.append("ACCEPTED" if verdict["ok"] else "REJECTED")
    lines += [f"  {reason['code']}: {reason['message']}" for reason in verdict["reasons"]]
    return "\n".join(lines) + "\n"


def _section(values: dict[str, Any], indent: int) -> list[str]:
    lines: list[str] = []
    width = max([len(_name(key)[0]) for key in values], default=0)
    for key, value in values.items():
        name, unit = _name(key)
        pad = " " * indent
        head = f"{pad}{name:<{width}}  "
        if isinstance(value, dict):
            lines += [f"{pad}{name}", *_section(value, indent + 2)]
        elif _is_rows(value):
            lines += [f"{pad}{name}" + (f" ({unit})" if unit else ""), *_rows(value, indent + 2)]
        else:
            lines.append(f"{head}{_cell(value)}{f' {unit}' if unit and value is not None else ''}")
    return lines


def _name(key: str) -> tuple[str, str]:
    for suffix, unit in _UNITS.items():
        if key.endswith(suffix):
            return key[:-len(suffix)].replace("_", " "), unit
    return key.replace("_", " "), ""


def _is_rows(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and (isinstance(value[0], list | dict) or len(value) > 12)


def _rows(value: list[Any], indent: int) -> list[str]:
    shown = value[:_LONGEST_TABLE]
    if isinstance(shown[0], dict):
        keys = list(dict.fromkeys(key for row in shown for key in row))
        titles = [" ".join(part for part in _name(key) if part) for key in keys]
        cells = [titles, *([_cell(row.get(key)) for key in keys] for row in shown)]
    elif isinstance(shown[0], list):
        cells = [[_cell(cell) for cell in row] for row in shown]
    else:
        cells = [[_cell(cell) for cell in shown[i:i + 6]] for i in range(0, len(shown), 6)]
    columns = max(len(row) for row in cells)
    widths = [max(len(row[i]) for row in cells if i < len(row)) for i in range(columns)]
    lines = [" " * indent + "  ".join(cell.rjust(widths[i]) for i, cell in enumerate(row)) for row in cells]
    if len(value) > len(shown):
        lines.append(" " * indent + f"... {len(value)} in all, see --json")
    return lines


def _cell(value: Any) -> str:
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        # A tenth of a micrometre is enough for people; what is smaller keeps three digits.
        return f"{value:.4f}" if 0.001 <= abs(value) < 1e7 else f"{value:.3g}"
    if isinstance(value, list):
        return "  ".join(_cell(item) for item in value) if len(value) <= 12 else f"({len(value)} values)"
    if isinstance(value, dict):
        return ", ".join(f"{_name(key)[0]} {_cell(item)}" for key, item in value.items())
    return str(value)
