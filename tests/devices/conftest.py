from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from devices.sim import SimulatedCell, build_simulated_cell
from devices.sim.settings import perfect


@pytest.fixture
def quiet() -> Callable[..., SimulatedCell]:
    """A cell without any random disturbance; keyword `truth` changes more."""

    def build(truth: dict[str, Any] | None = None, **options: Any) -> SimulatedCell:
        return build_simulated_cell(truth=perfect() | (truth or {}), **options)

    return build
