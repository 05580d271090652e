"""Progress and cancellation."""

import pytest

from beltgui.jobs import Cancelled, Job


def test_a_part_reports_within_its_share() -> None:
    seen: list[tuple[float, str]] = []
    job = Job(lambda fraction, text: seen.append((fraction, text)))
    job.part(0.2, 0.6, "ball: ").part(0.5, 1.0).report(0.5, "scan 3")
    assert seen == [(pytest.approx(0.5), "ball: scan 3")]


def test_cancelling_the_whole_ends_every_part() -> None:
    job = Job()
    part = job.part(0.0, 1.0)
    part.report(0.1, "fine so far")
    job.cancel()
    with pytest.raises(Cancelled):
        part.report(0.2, "too late")


def test_cancelling_a_part_ends_the_whole() -> None:
    job = Job()
    job.part(0.0, 0.5).cancel()
    with pytest.raises(Cancelled):
        job.report(0.9, "too late")
