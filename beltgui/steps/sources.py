"""Where a step's samples come from: the devices of a live cell, or a session that recorded them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Protocol

from beltgui.jobs import Job
from beltgui.session import Session
from beltgui.steps.ball import step as ball
from beltgui.steps.base import step as base
from beltgui.steps.context import Context
from beltgui.steps.error_surface import probing
from beltgui.steps.error_surface.probing import Presenting, ProbeSamples
from beltgui.steps.fine import step as fine
from beltgui.steps.rough import step as rough
from beltgui.steps.scans import CLOSING, ScanSample, read_scans
from beltgui.steps.tool import step as tool
from beltgui.steps.tool.step import ToolSamples
from core.cad.blade_type import ProbingGrid


class Source(Protocol):
    """Gives the samples of each step."""

    def ball(self, job: Job) -> list[ScanSample]:
        """Scans of the standing ball from several stage positions."""
        ...

    def base(self, job: Job) -> list[ScanSample]:
        """Scans of the ball on the flange in several robot poses."""
        ...

    def rough(self, job: Job) -> list[ScanSample]:
        """Scans of the clamped blade."""
        ...

    def fine(self, job: Job) -> list[ScanSample]:
        """Scans of the clamped blade."""
        ...

    def tool(self, job: Job) -> ToolSamples:
        """Touches of the cone and of the wheel shafts."""
        ...

    def clamped_again(self, job: Job) -> list[ScanSample]:
        """Scans of the blade after it was clamped again for probing."""
        ...

    def error_surface(self, job: Job, presenting: Presenting, grid: ProbingGrid) -> ProbeSamples:
        """Head angles over the airfoil."""
        ...

    def after_probing(self, job: Job) -> list[ScanSample]:
        """Scans of the blade after probing."""
        ...


@dataclass(frozen=True, eq=False)
class LiveSource:
    """Takes the samples from the cell; each is kept in the session at once."""

    context: Context

    def _with(self, job: Job) -> Context:
        return replace(self.context, job=job)

    def ball(self, job: Job) -> list[ScanSample]:
        """Scan the ball from several stage positions."""
        return ball.acquire(self._with(job))

    def base(self, job: Job) -> list[ScanSample]:
        """Scan the ball in several robot poses."""
        return base.acquire(self._with(job))

    def rough(self, job: Job) -> list[ScanSample]:
        """Scan the clamped blade."""
        return rough.acquire(self._with(job))

    def fine(self, job: Job) -> list[ScanSample]:
        """Scan the clamped blade."""
        return fine.acquire(self._with(job))

    def tool(self, job: Job) -> ToolSamples:
        """Touch cone and wheel shafts."""
        return tool.acquire(self._with(job))

    def clamped_again(self, job: Job) -> list[ScanSample]:
        """Clamp the blade and scan it: every clamping is another one."""
        return probing.clamp_and_scan(self._with(job))

    def error_surface(self, job: Job, presenting: Presenting, grid: ProbingGrid) -> ProbeSamples:
        """Probe the airfoil with the wheel."""
        return probing.acquire(self._with(job), presenting, grid)

    def after_probing(self, job: Job) -> list[ScanSample]:
        """Scan the blade once more."""
        return probing.scan_at_the_end(self._with(job))


@dataclass(frozen=True, eq=False)
class RecordedSource:
    """Reads the samples of a session."""

    session: Session

    def ball(self, job: Job) -> list[ScanSample]:
        """The recorded scans."""
        return read_scans(self.session, "ball")

    def base(self, job: Job) -> list[ScanSample]:
        """The recorded scans."""
        return read_scans(self.session, "base")

    def rough(self, job: Job) -> list[ScanSample]:
        """The recorded scans."""
        return read_scans(self.session, "rough")

    def fine(self, job: Job) -> list[ScanSample]:
        """The recorded scans."""
        return read_scans(self.session, "fine")

    def tool(self, job: Job) -> ToolSamples:
        """The recorded touches."""
        return tool.read(self.session)

    def clamped_again(self, job: Job) -> list[ScanSample]:
        """The recorded scans."""
        return read_scans(self.session, "error_surface")

    def error_surface(self, job: Job, presenting: Presenting, grid: ProbingGrid) -> ProbeSamples:
        """The recorded probing."""
        return probing.read(self.session)

    def after_probing(self, job: Job) -> list[ScanSample]:
        """The recorded scans."""
        return read_scans(self.session, "error_surface", CLOSING)
