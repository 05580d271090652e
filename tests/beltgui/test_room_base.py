"""The base step's room: taken, gone on with, edited, spoilt, and what its screen says each time."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from beltgui.jobs import Job
from beltgui.steps.base.room import BaseRoom
from beltgui.steps.base.step import BaseOutcome
from beltgui.steps.room import Bench
from beltgui.steps.views.common import euler_covariance
from beltgui.viewmodel.step import Use
from core.errors import InputError
from tests.beltgui.cell_bench import (
    PERSON,
    acquire,
    acquire_until,
    bench_of,
    copied,
    number,
    row,
    said,
    solved,
    with_stage,
)
from tests.beltgui.live import Live

ROOM = BaseRoom()
PLANNED = 14


@pytest.fixture(scope="module")
def live(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Live]:
    with Live.start(tmp_path_factory.mktemp("base") / "session") as cell:
        yield cell


@pytest.fixture(scope="module")
def whole(live: Live) -> Bench:
    bench = bench_of(live, ball=with_stage(live))
    acquire_until(ROOM, live, bench, "scan 4 of 15")
    assert [sample.data["slot"] for sample in bench.session.samples("base")] == [0, 1, 2, 3]
    told = acquire(ROOM, live, bench)
    assert [sample.data["slot"] for sample in told] == [*range(4, PLANNED), PLANNED]
    assert told[-1].kind == "closing_scan" and told[-1].data["name"] == "pose 1 again"
    return bench


@pytest.fixture
def bench(whole: Bench, tmp_path: Path) -> Iterator[Bench]:
    copy = copied(whole, tmp_path / "copy")
    yield copy
    copy.session.close()


def sample_id(bench: Bench, slot: int) -> int:
    (found,) = [s.id for s in bench.session.samples("base", "scan") if s.data["slot"] == slot]
    return found


def test_the_whole_step_is_accepted_and_shown(whole: Bench, live: Live) -> None:
    outcome, content = solved(ROOM, whole)
    assert outcome is not None and content.ok and content.reasons == ()
    assert content.complete and not content.provisional and content.progress == "15 of 15 scans"
    assert [entry.use for entry in content.rows].count(Use.HELD_OUT) == 3
    assert [check.ok for check in content.checks] == [True, True]
    assert content.scene is not None and content.scene.frame == "B"
    names = [item.name for item in content.scene.items]
    assert {"{B}", "{M}", "balls by the scanner", "residuals, fit", "suggested flange"} <= set(names)
    assert sum(words.endswith(" times as long") for _, words in content.scene.legend) == 1
    assert content.scene.look_from is not None
    assert all(any(name.startswith(begin) for name in names) for begin in content.scene.fit_to)
    assert acquire(ROOM, live, whole) == []


def test_plus_minus_is_twice_the_standard_deviation(whole: Bench) -> None:
    outcome, content = solved(ROOM, whole)
    assert outcome is not None
    fit = outcome.fit
    pose = fit.base_from_measure
    origin = np.sqrt(np.diag(fit.covariance.moved_to(pose[:3, 3]).matrix[3:, 3:]))
    ball = np.sqrt(np.diag(fit.ball_covariance_mm2))
    turn = np.degrees(np.sqrt(np.diag(euler_covariance(pose[:3, :3], fit.covariance.matrix[:3, :3]))))
    for index, axis in enumerate("xyz"):
        assert number(content, f"Origin of {{M}} in {{B}}, {axis}").plus_minus == pytest.approx(2.0 * origin[index])
        assert number(content, f"Ball in {{F}} {axis}").plus_minus == pytest.approx(2.0 * ball[index])
    for index, axis in enumerate(("Z", "Y'", "X''")):
        assert number(content, f"{{M}} in {{B}}, turn {axis}").plus_minus == pytest.approx(2.0 * turn[index])


def test_euler_angles_have_the_spread_they_claim(whole: Bench) -> None:
    """Against a random draw of small turns."""
    from core.frames import euler_zyx_from_rotation, rotation_from_rotvec

    outcome, _ = solved(ROOM, whole)
    assert outcome is not None
    rotation, covariance = outcome.fit.base_from_measure[:3, :3], outcome.fit.covariance.matrix[:3, :3]
    rng = np.random.default_rng(2)
    drawn = [
        euler_zyx_from_rotation(rotation_from_rotvec(turn) @ rotation)
        for turn in rng.multivariate_normal(np.zeros(3), covariance, 3000)
    ]
    np.testing.assert_allclose(
        np.std(drawn, axis=0), np.sqrt(np.diag(euler_covariance(rotation, covariance))), rtol=0.08
    )


def test_without_a_ball_step_it_says_so(whole: Bench) -> None:
    with pytest.raises(InputError, match="Finish the ball step first"):
        ROOM.solve(replace(whole, found={}), Job())


@pytest.mark.parametrize(
    ("count", "solvable", "sentence"),
    [
        (0, False, "No scan shows the ball yet"),
        (2, False, ""),
        (6, True, "8 of 14 planned scans are missing: 'pose 7', 'pose 8', 'pose 9' and others"),
        (14, True, "The closing scan is missing"),
    ],
)
def test_what_is_there_so_far_is_solved_and_what_is_missing_is_said(
    bench: Bench, count: int, solvable: bool, sentence: str
) -> None:
    for sample in bench.session.samples("base")[count:]:
        bench.session.delete(sample.id, PERSON)
    outcome, content = solved(ROOM, bench)
    assert (outcome is not None) is solvable
    assert sentence in said(content)
    assert not content.ok and content.provisional is solvable
    assert content.progress == f"{count} of 15 scans"
    if solvable and count < PLANNED:
        assert content.suggestion is not None
        assert content.suggestion.text.endswith(" next: of the missing poses it adds most.")


def test_an_excluded_pose_keeps_its_residual_and_has_no_say(bench: Bench) -> None:
    before, _ = solved(ROOM, bench)
    bench.session.include(sample_id(bench, 6), False, PERSON)
    after, content = solved(ROOM, bench)
    left_out = row(content, "pose 7")
    assert left_out.use is Use.EXCLUDED and left_out.cells[0] > 0.0
    assert content.ok
    assert before is not None and after is not None
    assert len(after.fitted) == len(before.fitted) - 1
    held = {entry.name for entry in content.rows if entry.use is Use.HELD_OUT}
    assert held == {"pose 4", "pose 8", "pose 12"}


def test_a_deleted_pose_is_taken_again_and_the_series_closed_anew(bench: Bench, live: Live) -> None:
    bench.session.delete(sample_id(bench, 5), PERSON)
    told = acquire(ROOM, live, bench)
    assert [(sample.kind, sample.data["slot"]) for sample in told] == [("scan", 5), ("closing_scan", 14)]
    _, content = solved(ROOM, bench)
    assert content.ok and content.complete


def test_without_its_closing_scan_the_step_is_rejected(bench: Bench, live: Live) -> None:
    closing = bench.session.samples("base", "closing_scan")[-1].id
    bench.session.include(closing, False, PERSON)
    _, content = solved(ROOM, bench)
    assert not content.ok and "The closing scan 'pose 1 again' is left out" in said(content)
    bench.session.delete(closing, PERSON)
    assert "The closing scan is missing" in said(solved(ROOM, bench)[1])


def test_nothing_held_out_is_no_proof(bench: Bench) -> None:
    for slot in (3, 7, 11):
        bench.session.include(sample_id(bench, slot), False, PERSON)
    _, content = solved(ROOM, bench)
    assert not content.ok and content.checks[0].ok is None
    assert content.headline.endswith("nothing held out")


def test_a_ball_that_moved_on_the_flange_is_named(bench: Bench, live: Live) -> None:
    """By a fifth of a millimetre, which hides among the robot's own errors."""
    for slot in range(9, PLANNED):
        bench.session.delete(sample_id(bench, slot), PERSON)
    live.sim.world.faults.move_ball((0.0, 0.2, 0.0))
    acquire(ROOM, live, bench)
    live.sim.world.faults.move_ball((0.0, -0.2, 0.0))
    outcome, content = solved(ROOM, bench)
    assert outcome is not None and outcome.returned_mm == pytest.approx(0.2, abs=0.1)
    assert not content.ok and "The ball, the stage or the robot has moved meanwhile" in said(content)
    assert content.checks[1].ok is False


def test_a_slip_of_one_scan_names_that_pose(bench: Bench, live: Live) -> None:
    bench.session.delete(sample_id(bench, 9), PERSON)
    faults = live.sim.world.faults
    live.hook("scanner", "capture", lambda call: faults.move_ball((0.0, (1.5, -1.5)[call], 0.0)) if call < 2 else None)
    acquire(ROOM, live, bench)
    _, content = solved(ROOM, bench)
    assert row(content, "pose 10").flag == "outlier"
    assert "The held-out error of 'pose 10', which the others contradict," in said(content)


def test_the_suggested_pose_improves_as_it_says(bench: Bench, live: Live) -> None:
    for slot in (4, 6, 8, 10):
        bench.session.include(sample_id(bench, slot), False, PERSON)
    before, content = solved(ROOM, bench)
    assert isinstance(before, BaseOutcome) and content.suggestion is not None
    assert content.suggestion.text.startswith("One more scan adds most with the flange at x ")
    bench.session.choose("base", "extra", [content.extra["suggested"]], PERSON)
    told = acquire(ROOM, live, bench)
    assert [sample.data["name"] for sample in told] == ["extra 1", "pose 1 again"]
    after, content = solved(ROOM, bench)
    assert isinstance(after, BaseOutcome) and content.complete
    assert row(content, "extra 1").use is Use.FIT
    with_its_noise = after.fit.joint_covariance / max(after.fit.robot_sigma_mm, 1e-6) ** 2
    without = before.fit.joint_covariance / max(before.fit.robot_sigma_mm, 1e-6) ** 2
    assert np.trace(with_its_noise[:3, :3]) < np.trace(without[:3, :3])


def test_before_the_first_scan_the_planned_poses_are_shown(bench: Bench) -> None:
    bench.session.start_over("base", PERSON)
    content = ROOM.view(bench, None)
    assert content.scene is not None and content.scene.frame == "B" and content.rows == ()
    planned = next(item for item in content.scene.items if item.name == "planned poses")
    assert len(planned.xyz) == len(bench.plan.base_step)
