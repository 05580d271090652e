"""Errors whose text an operator can act on."""

from __future__ import annotations

from core.verdict import Code


class InputError(ValueError):
    """Input that cannot be used; the message says what, where, expected, found and what to do.

    Attributes:
        code: Machine-readable reason, the same vocabulary that verdicts use.
    """

    def __init__(self, message: str, code: Code = Code.BAD_INPUT) -> None:
        super().__init__(message)
        self.code = code


class FitError(InputError):
    """The data were readable but do not determine the answer; no transform exists."""
