"""Runs `beltcal` inside the test's process, as a script would run it: stdout is no terminal."""

import json
from dataclasses import dataclass
from typing import Any

import pytest

from beltgui.cli.main import main


@dataclass
class Run:
    code: int
    out: str
    err: str

    @property
    def record(self) -> dict[str, Any]:
        return json.loads(self.out, parse_constant=lambda word: pytest.fail(f"{word} in JSON"))


@pytest.fixture
def beltcal(capsys):
    def run(*words) -> Run:
        code = main([str(word) for word in words])
        captured = capsys.readouterr()
        return Run(code, captured.out, captured.err)

    return run
