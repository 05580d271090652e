"""The ball step's room: taken, gone on with, edited, spoilt, and what its screen says each time."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from beltgui.steps.ball.advice import advise, worst_point_sigma
from beltgui.steps.ball.room import BallRoom
from beltgui.steps.ball.step import BallOutcome
from beltgui.steps.room import Bench
from beltgui.steps.views.common import euler_covariance
from beltgui.viewmodel.step import Use
from tests.beltgui.cell_bench import (
    PERSON,
    acquire,
    acquire_until,
    bench_of,
    check,
    copied,
    number,
    row,
    said,
    solved,
)
from tests.beltgui.live import Live

ROOM = BallRoom()
PLANNED = 19


@pytest.fixture(scope="module")
def live(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Live]:
    with Live.start(tmp_path_factory.mktemp("ball") / "session") as cell:
        yield cell


@pytest.fixture(scope="module")
def whole(live: Live) -> Bench:
    """All scans taken and looked at."""
    bench = bench_of(live)
    told = acquire(ROOM, live, bench)
    assert [sample.data["slot"] for sample in told] == [*range(PLANNED), PLANNED]
    assert [sample.kind for sample in told] == ["scan"] * PLANNED + ["closing_scan"]
    return bench


@pytest.fixture
def bench(whole: Bench, tmp_path: Path) -> Iterator[Bench]:
    """A copy to edit."""
    copy = copied(whole, tmp_path / "copy")
    yield copy
    copy.session.close()


def sample_id(bench: Bench, slot: int) -> int:
    (found,) = [s.id for s in bench.session.samples("ball", "scan") if s.data["slot"] == slot]
    return found


def closing_id(bench: Bench) -> int:
    return bench.session.samples("ball", "closing_scan")[-1].id


def test_the_whole_step_is_accepted_and_shown(whole: Bench, live: Live) -> None:
    _, content = solved(ROOM, whole)
    assert content.ok and content.reasons == ()
    assert content.complete and not content.provisional
    assert content.progress == "20 of 20 scans"
    assert [entry.use for entry in content.rows].count(Use.HELD_OUT) == 4
    assert content.rows[-1].use is Use.CHECK and content.rows[-1].name == "stage 1 again"
    assert all(check.ok and check.unit == "µm" for check in content.checks)
    assert content.scene is not None and content.scene.frame == "M"
    assert content.second_scene is not None and content.second_scene.frame == "S"
    assert {words for _, words in content.second_scene.legend} == {"points on the ball", "other points of the scan"}
    assert {plot.key for plot in content.plots} == {"residuals", "components", "predicted"}
    truth = live.sim.truth.stage_axes
    cosine = truth[:, 0] @ truth[:, 1] / np.linalg.norm(truth[:, 0]) / np.linalg.norm(truth[:, 1])
    shown = number(content, "Squareness of axes xy")
    assert shown.value == pytest.approx(np.degrees(np.arccos(cosine)) - 90.0, abs=1.5 * shown.plus_minus)
    assert acquire(ROOM, live, whole) == []


def test_plus_minus_is_twice_the_standard_deviation(whole: Bench) -> None:
    outcome, content = solved(ROOM, whole)
    assert outcome is not None
    fit = outcome.stage
    for pair, sigma in zip(("xy", "yz", "zx"), fit.squareness_sigma_rad, strict=True):
        assert number(content, f"Squareness of axes {pair}").plus_minus == pytest.approx(2.0 * np.degrees(sigma))
    ball = np.sqrt(np.diag(fit.ball_covariance_mm2()))
    turn = euler_covariance(fit.measure_from_scanner[:3, :3], fit.covariance.matrix[:3, :3])
    euler = np.degrees(np.sqrt(np.diag(turn)))
    for index, axis in enumerate("xyz"):
        assert number(content, f"Ball in {{M}} {axis}").plus_minus == pytest.approx(2.0 * ball[index])
    for index, axis in enumerate(("turn Z", "turn Y'", "turn X''")):
        label = f"Scanner {{S}} in {{M}} at stage zero, {axis}"
        assert number(content, label).plus_minus == pytest.approx(2.0 * euler[index])


def test_scale_and_rotary_axis_have_the_spread_they_claim(whole: Bench) -> None:
    """Against a random draw of the model's unknowns from their covariance."""
    outcome, content = solved(ROOM, whole)
    assert outcome is not None
    fit = outcome.stage
    rng = np.random.default_rng(1)
    models = [fit.model.moved(step) for step in rng.multivariate_normal(np.zeros(16), fit.model_covariance, 4000)]
    for index, axis in enumerate("xyz"):
        drawn = np.std([np.linalg.norm(model.axes[:, index]) for model in models])
        assert number(content, f"Scale of stage axis {axis}").plus_minus == pytest.approx(2.0 * drawn, rel=0.1)
    drawn = np.std([replace(fit, model=m).measure_from_scanner_at([0, 0, 0])[:3, :3] @ m.point for m in models], axis=0)
    for index, axis in enumerate("xyz"):
        label = f"Rotary axis in {{M}}, point nearest to the origin, {axis}"
        assert number(content, label).plus_minus == pytest.approx(2.0 * drawn[index], rel=0.1)


@pytest.mark.parametrize(
    ("count", "solvable", "sentence"),
    [
        (0, False, "No scan shows the ball yet"),
        (1, False, ""),
        (3, False, "axis y was not moved"),
        (6, True, "13 of 19 planned scans are missing: 'stage 7', 'stage 8', 'stage 9' and others"),
        (8, True, "11 of 19 planned scans are missing"),
        (19, True, "The closing scan is missing"),
    ],
)
def test_what_is_there_so_far_is_solved_and_what_is_missing_is_said(
    bench: Bench, count: int, solvable: bool, sentence: str
) -> None:
    for sample in bench.session.samples("ball")[count:]:
        bench.session.delete(sample.id, PERSON)
    outcome, content = solved(ROOM, bench)
    assert (outcome is not None) is solvable
    assert sentence in said(content)
    assert not content.ok and not content.complete
    assert content.provisional is solvable
    assert content.progress == f"{count} of 20 scans"
    assert len(content.rows) == count
    assert content.scene is not None and content.scene.frame == ("M" if solvable or not count else "S")


def test_the_held_out_scans_stay_the_same_while_scans_come_in(bench: Bench) -> None:
    whole_uses = {entry.name: entry.use for entry in solved(ROOM, bench)[1].rows}
    for slot in (2, 9, 18):
        bench.session.delete(sample_id(bench, slot), PERSON)
    uses = {entry.name: entry.use for entry in solved(ROOM, bench)[1].rows}
    assert uses == {name: whole_uses[name] for name in uses}


def test_cancelled_in_the_middle_it_goes_on_where_it_stood(live: Live, tmp_path: Path) -> None:
    with Live.start(tmp_path / "short", seed=3) as short:
        bench = replace(bench_of(short), plan=replace(short.sim.plan, stage_step=short.sim.plan.stage_step[:7]))
        acquire_until(ROOM, short, bench, "scan 4 of 8")
        assert [sample.data["slot"] for sample in bench.session.samples("ball")] == [0, 1, 2, 3]
        told = acquire(ROOM, short, bench)
        assert [sample.data["slot"] for sample in told] == [4, 5, 6, 7]
        outcome, content = solved(ROOM, bench)
    assert content.complete and content.progress == "8 of 8 scans"
    assert "The rotary axis has not moved: scans at another angle cannot be placed." in content.remarks
    assert outcome is not None and outcome.returned_mm < 0.03


def test_an_excluded_scan_keeps_its_residual_and_has_no_say(bench: Bench) -> None:
    before, _ = solved(ROOM, bench)
    bench.session.include(sample_id(bench, 4), False, PERSON)
    after, content = solved(ROOM, bench)
    left_out = row(content, "stage 5")
    assert left_out.use is Use.EXCLUDED and not left_out.included and left_out.flag == ""
    assert 0.0 < left_out.cells[0] < 30.0
    assert content.ok and content.complete
    assert "1 scans are left out." in content.remarks
    assert before is not None and after is not None
    assert len(after.fitted) == len(before.fitted) - 1
    assert not np.array_equal(after.stage.axes, before.stage.axes)


def test_a_deleted_scan_is_taken_again_and_the_series_closed_anew(bench: Bench, live: Live) -> None:
    bench.session.delete(sample_id(bench, 5), PERSON)
    _, content = solved(ROOM, bench)
    assert "1 of 19 planned scans are missing: 'stage 6'. Take the missing scans." in said(content)
    told = acquire(ROOM, live, bench)
    assert [(sample.kind, sample.data["slot"]) for sample in told] == [("scan", 5), ("closing_scan", 19)]
    _, content = solved(ROOM, bench)
    assert content.ok and content.complete and content.progress == "20 of 20 scans"
    earlier = next(entry for entry in content.rows if entry.name == "stage 1 again")
    assert "no longer closes the series" in earlier.note


def test_without_its_closing_scan_the_step_is_rejected(bench: Bench, live: Live) -> None:
    bench.session.include(closing_id(bench), False, PERSON)
    _, content = solved(ROOM, bench)
    assert not content.ok and content.complete
    assert "The closing scan 'stage 1 again' is left out" in said(content)
    assert [check.ok for check in content.checks] == [True, None]
    assert acquire(ROOM, live, bench) == []
    bench.session.delete(closing_id(bench), PERSON)
    _, content = solved(ROOM, bench)
    assert "The closing scan is missing" in said(content) and not content.complete
    assert [sample.kind for sample in acquire(ROOM, live, bench)] == ["closing_scan"]
    assert solved(ROOM, bench)[1].ok


def test_the_closing_scan_returns_to_the_first_scan_that_is_used(bench: Bench, live: Live) -> None:
    bench.session.include(sample_id(bench, 0), False, PERSON)
    _, content = solved(ROOM, bench)
    assert not content.ok and "The closing scan is missing" in said(content)
    (told,) = acquire(ROOM, live, bench)
    assert told.data["returns_to"] == 1 and told.data["name"] == "stage 2 again"
    assert solved(ROOM, bench)[1].ok


def test_nothing_held_out_is_no_proof(bench: Bench) -> None:
    for slot in (3, 7, 11, 15):
        bench.session.include(sample_id(bench, slot), False, PERSON)
    _, content = solved(ROOM, bench)
    assert not content.ok and "No observation was kept out of the fit" in said(content)
    assert content.checks[0].ok is None
    assert content.headline.endswith("nothing held out")


def test_a_ball_that_moved_is_named(bench: Bench, live: Live) -> None:
    for slot in range(12, PLANNED):
        bench.session.delete(sample_id(bench, slot), PERSON)
    live.sim.world.faults.move_ball((0.0, 0.3, 0.0))
    acquire(ROOM, live, bench)
    live.sim.world.faults.move_ball((0.0, -0.3, 0.0))
    outcome, content = solved(ROOM, bench)
    assert outcome is not None and outcome.returned_mm == pytest.approx(0.3, abs=0.03)
    assert not content.ok and "The ball, the stage or the robot has moved meanwhile" in said(content)
    assert "fasten both, scan again" in said(content)


def test_a_slip_of_one_scan_names_that_scan(bench: Bench, live: Live) -> None:
    bench.session.delete(sample_id(bench, 13), PERSON)
    faults = live.sim.world.faults
    live.hook("scanner", "capture", lambda call: faults.move_ball((0.0, (0.4, -0.4)[call], 0.0)) if call < 2 else None)
    acquire(ROOM, live, bench)
    _, content = solved(ROOM, bench)
    assert row(content, "stage 14").flag == "outlier"
    assert "The error of 'stage 14', which the others contradict," in said(content)


def test_a_scan_without_the_ball_is_refused_alone(bench: Bench, live: Live) -> None:
    bench.session.delete(sample_id(bench, 8), PERSON)
    mount = live.sim.world.mount
    live.hook("scanner", "capture", lambda call: mount("ball" if call else "nothing", "") if call < 2 else None)
    acquire(ROOM, live, bench)
    outcome, content = solved(ROOM, bench)
    refused = row(content, "stage 9")
    assert refused.flag == "refused" and refused.included and refused.cells[0] is None
    assert "Leave it out, or delete it and scan again." in refused.note
    assert outcome is not None and not content.ok
    assert said(content).startswith("Scan 'stage 9': ")
    bench.session.include(refused.id, False, PERSON)
    assert solved(ROOM, bench)[1].ok


# ---- advice


def test_a_missing_planned_scan_is_suggested_before_others(bench: Bench) -> None:
    for sample in bench.session.samples("ball")[5:]:
        bench.session.delete(sample.id, PERSON)
    _, content = solved(ROOM, bench)
    assert content.suggestion is not None
    assert content.suggestion.text == "Scan 'stage 6' next: stage axis z has not moved yet."
    assert "suggested" not in content.extra


def test_the_suggested_position_improves_as_it_says(bench: Bench, live: Live) -> None:
    for slot in range(12, PLANNED - 2):
        bench.session.include(sample_id(bench, slot), False, PERSON)
    before, content = solved(ROOM, bench)
    assert isinstance(before, BallOutcome) and content.suggestion is not None
    assert content.suggestion.text.startswith("One more scan adds most with the stage at x ")
    bench.session.choose("ball", "extra", [content.extra["suggested"]], PERSON)
    assert not solved(ROOM, bench)[1].complete
    told = acquire(ROOM, live, bench)
    assert [sample.data["name"] for sample in told] == ["extra 1", "stage 1 again"]
    after, content = solved(ROOM, bench)
    assert isinstance(after, BallOutcome) and content.complete
    assert row(content, "extra 1").use is Use.FIT
    promised = advise(before.stage, bench.plan, [], before.sigma_mm)
    assert promised is not None
    assert promised.after_mm < 0.95 * promised.before_mm
    assert worst_point_sigma(after.stage, bench.plan) == pytest.approx(promised.after_mm, rel=0.1)


def test_no_other_position_beats_the_suggested_one(whole: Bench) -> None:
    """By adding the observation to the information matrix instead of updating the covariance."""
    outcome, _ = solved(ROOM, whole)
    assert outcome is not None
    fit, plan = outcome.stage, whole.plan
    sigma_mm = 0.005
    poses = list(plan.stage_step[10:16])
    found = advise(fit, plan, poses, sigma_mm)
    assert found is not None
    traces = []
    for pose in poses:
        position = pose.stage
        jacobian = fit.model.jacobian(
            np.array([[position.x_mm, position.y_mm, position.z_mm]]), np.array([position.theta_rad])
        )[0]
        information = np.linalg.inv(fit.model_covariance) + jacobian.T @ jacobian / sigma_mm**2
        more = replace(fit, model_covariance=np.linalg.inv(information))
        points = [(s.stage, [0.0, 0.0, plan.scanner.working_distance_mm]) for s in (*plan.fine_step, *plan.base_step)]
        traces.append(sum(
            np.trace(more.point_covariance_at([s.x_mm, s.y_mm, s.z_mm], s.theta_rad, point)) for s, point in points
        ))  # fmt: skip
    assert poses[int(np.argmin(traces))].name == found.pose.name


def test_the_content_check_finds_what_it_looks_for(whole: Bench) -> None:
    _, content = solved(ROOM, whole)
    spoilt = replace(content.numbers[0], value=float("nan"))
    with pytest.raises(AssertionError, match=r"numbers\[0\]\.value"):
        check(replace(content, numbers=(spoilt, *content.numbers[1:])))
