"""The tool step's room: taken, gone on with, edited, spoilt, and what its screen says each time."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from beltgui.steps.room import Bench
from beltgui.steps.tool.advice import advise_cone, advise_shaft
from beltgui.steps.tool.room import ToolRoom
from beltgui.viewmodel.step import Use
from core.frames import transform_points
from core.tool import WheelTouches, solve_stylus, solve_wheel
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
)
from tests.beltgui.live import Live

ROOM = ToolRoom()
CONE, ROUGH, FINE = 12, 5, 7
ALL = CONE + 1 + ROUGH + 1 + FINE


@pytest.fixture(scope="module")
def live(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Live]:
    with Live.start(tmp_path_factory.mktemp("tool") / "session") as cell:
        yield cell


@pytest.fixture(scope="module")
def whole(live: Live) -> Bench:
    bench = bench_of(live)
    told = acquire(ROOM, live, bench)
    kinds = [sample.kind for sample in told]
    shafts = [["head_rest"], ["shaft_touch"] * ROUGH, ["head_rest"], ["shaft_touch"] * FINE]
    assert kinds == ["cone_touch"] * CONE + [kind for part in shafts for kind in part]
    return bench


@pytest.fixture
def bench(whole: Bench, tmp_path: Path) -> Iterator[Bench]:
    copy = copied(whole, tmp_path / "copy")
    yield copy
    copy.session.close()


def sample_id(bench: Bench, kind: str, slot: int, grinder: str | None = None) -> int:
    (found,) = [
        s.id for s in bench.session.samples("tool", kind) if s.data["slot"] == slot and s.data.get("grinder") == grinder
    ]
    return found


def test_the_whole_step_is_accepted_and_shown(whole: Bench, live: Live) -> None:
    outcome, content = solved(ROOM, whole)
    assert outcome is not None and content.ok and content.reasons == ()
    assert content.complete and not content.provisional
    assert content.progress == f"{ALL} of {ALL} touches and readings"
    assert [check.ok for check in content.checks] == [True] * 3
    assert [entry.use for entry in content.rows].count(Use.HELD_OUT) == 5
    assert [entry.name for entry in content.rows if entry.use is Use.CHECK] == ["stop rough", "stop fine"]
    assert content.scene is not None
    cone, rough, fine = (content.scene, *content.scene.beside)
    names = [{item.name for item in scene.items} for scene in (cone, rough, fine)]
    assert {"cone", "stylus, fit", "directions"} <= names[0]
    for grinder, found in (("rough", names[1]), ("fine", names[2])):
        shown = {f"wheel {grinder}", f"wheel circle {grinder}", f"head axis {grinder}", f"{{H {grinder}}}"}
        assert shown <= found and not any(name.startswith("planned") for name in found)
    assert all(scene.look_from is not None for scene in (cone, rough, fine))
    assert {plot.key for plot in content.plots} == {"cone", "shaft rough", "shaft fine", "orientations"}
    assert acquire(ROOM, live, whole) == []


def test_plus_minus_is_twice_the_standard_deviation(whole: Bench) -> None:
    outcome, content = solved(ROOM, whole)
    assert outcome is not None
    tip = np.sqrt(np.diag(outcome.stylus.tip_covariance_mm2))
    for index, axis in enumerate("xyz"):
        assert number(content, f"Stylus tip in {{F}} {axis}").plus_minus == pytest.approx(2.0 * tip[index])
    for name, fit in outcome.wheels.items():
        origin = np.sqrt(np.diag(fit.covariance.of_point(fit.base_from_tool[:3, 3])))
        turn = np.degrees(np.sqrt(np.diag(fit.covariance.matrix[:3, :3])))
        for index, axis in enumerate("xyz"):
            label = f"Grinder {name}: origin of {{H}} in {{B}}, {axis}"
            assert number(content, label).plus_minus == pytest.approx(2.0 * origin[index])
            label = f"Grinder {name}: {{H}} turned against the drawing about {axis}"
            assert number(content, label).plus_minus == pytest.approx(2.0 * turn[index])
        radius = number(content, f"Grinder {name}: Rg by the touches alone")
        assert radius.plus_minus == pytest.approx(2.0 * fit.free_radius_sigma_mm)


def test_the_head_axis_spreads_as_claimed(whole: Bench) -> None:
    """Against a random draw of small turns of {H}."""
    outcome, content = solved(ROOM, whole)
    assert outcome is not None
    fit = outcome.wheels["rough"]
    rng = np.random.default_rng(3)
    turns = rng.multivariate_normal(np.zeros(3), fit.covariance.matrix[:3, :3], 4000)
    spread = np.std(fit.head_axis_direction + np.cross(turns, fit.head_axis_direction), axis=0)
    for index, axis in enumerate("xyz"):
        shown = number(content, f"Grinder rough: head axis in {{B}}, direction {axis}").plus_minus
        assert shown == pytest.approx(2.0 * spread[index], rel=0.1)


def test_cancelled_in_the_middle_it_goes_on_where_it_stood(tmp_path: Path) -> None:
    with Live.start(tmp_path / "session", seed=2) as live:
        bench = bench_of(live)
        acquire_until(ROOM, live, bench, "cone touch 6 of 12")
        assert [sample.data["slot"] for sample in bench.session.samples("tool")] == [0, 1, 2, 3, 4, 5]
        _, content = solved(ROOM, bench)
        assert content.provisional and content.progress == f"6 of {ALL} touches and readings"
        acquire_until(ROOM, live, bench, "grinder fine: shaft at +8 degrees")
        assert len(bench.session.samples("tool", "cone_touch")) == CONE
        assert len(acquire(ROOM, live, bench)) == FINE - 2
        _, content = solved(ROOM, bench)
        assert content.ok and content.complete


@pytest.mark.parametrize(
    ("count", "solvable", "sentence"),
    [
        (0, False, ""),
        (2, False, "Found 2 different flange poses, at least 3 are needed"),
        (6, True, "Grinder rough: Found 0 touches at different places"),
        (12, True, f"{ALL - 12} of {ALL} planned touches and readings are missing"),
        (15, True, "Grinder rough: Found 2 touches at different places"),
        (18, True, "Grinder fine: Found 0 touches"),
        (23, True, "3 of 26 planned touches"),
    ],
)
def test_what_is_there_so_far_is_solved_and_what_is_missing_is_said(
    bench: Bench, count: int, solvable: bool, sentence: str
) -> None:
    for sample in bench.session.samples("tool")[count:]:
        bench.session.delete(sample.id, PERSON)
    outcome, content = solved(ROOM, bench)
    assert (outcome is not None) is solvable
    assert sentence in said(content)
    assert not content.ok and content.provisional is solvable
    assert len(content.rows) == count
    if count >= 2:
        assert content.scene is not None
        focus = "cone" if count < 12 else "rough" if count < 18 else "fine"
        assert content.scene.view == f"tool {focus}"


def test_excluded_touches_keep_their_residual_and_have_no_say(bench: Bench) -> None:
    before, _ = solved(ROOM, bench)
    bench.session.include(sample_id(bench, "cone_touch", 4), False, PERSON)
    bench.session.include(sample_id(bench, "shaft_touch", 2, "fine"), False, PERSON)
    after, content = solved(ROOM, bench)
    for name in ("cone 5", "shaft fine 3"):
        assert row(content, name).use is Use.EXCLUDED and row(content, name).cells[0] > 0.0
    assert content.ok and "2 touches are left out." in content.remarks
    assert before is not None and after is not None
    assert len(after.fitted_cone) == len(before.fitted_cone) - 1
    assert len(after.fitted_shafts["fine"]) == len(before.fitted_shafts["fine"]) - 1
    assert len(after.fitted_shafts["rough"]) == len(before.fitted_shafts["rough"])


def test_a_deleted_touch_is_taken_again_alone(bench: Bench, live: Live) -> None:
    bench.session.delete(sample_id(bench, "shaft_touch", 1, "rough"), PERSON)
    assert "1 of 26 planned touches and readings are missing" in said(solved(ROOM, bench)[1])
    (told,) = acquire(ROOM, live, bench)
    assert (told.kind, told.data["grinder"], told.data["slot"]) == ("shaft_touch", "rough", 1)
    assert solved(ROOM, bench)[1].ok


def test_a_reading_at_the_stop_that_is_left_out_is_asked_for(bench: Bench, live: Live) -> None:
    rest = sample_id(bench, "head_rest", 0, "fine")
    bench.session.include(rest, False, PERSON)
    outcome, content = solved(ROOM, bench)
    assert outcome is not None and set(outcome.rests_rad) == {"rough"}
    assert not content.ok and "Grinder fine: the reading of its head at the stop is left out" in said(content)
    bench.session.delete(rest, PERSON)
    (told,) = acquire(ROOM, live, bench)
    assert told.kind == "head_rest" and told.data["grinder"] == "fine"
    assert solved(ROOM, bench)[1].ok


def test_nothing_held_out_is_no_proof(bench: Bench) -> None:
    bench.session.include(sample_id(bench, "shaft_touch", 3, "rough"), False, PERSON)
    _, content = solved(ROOM, bench)
    assert not content.ok and "Grinder rough: No observation was kept out of the fit" in said(content)
    assert [check.ok for check in content.checks] == [True, None, True]


def test_a_head_whose_zero_moved_between_the_touches_is_named(bench: Bench, live: Live) -> None:
    for slot in range(3, FINE):
        bench.session.delete(sample_id(bench, "shaft_touch", slot, "fine"), PERSON)
    live.sim.world.faults.shift_angle_zero("fine", np.radians(1.5))
    acquire(ROOM, live, bench)
    live.sim.world.faults.shift_angle_zero("fine", np.radians(-1.5))
    _, content = solved(ROOM, bench)
    assert not content.ok
    assert "Grinder fine: " in said(content) and "the head was held still" in said(content)
    assert "Grinder rough" not in said(content)


def test_a_bad_touch_of_the_cone_is_named(bench: Bench, live: Live) -> None:
    """The stylus slipped in the cone by a millimetre."""
    number_ = sample_id(bench, "cone_touch", 8)
    (sample,) = [s for s in bench.session.samples("tool") if s.id == number_]
    bench.session.delete(number_, PERSON)
    pose = np.array(sample.data["base_from_flange"])
    pose[:3, 3] += [0.0, 1.0, 0.0]
    bench.session.add_sample("tool", "cone_touch", {**sample.data, "base_from_flange": pose.tolist()})
    _, content = solved(ROOM, bench)
    assert row(content, "cone 9").flag == "outlier"
    assert "The held-out error of 'cone 9', which the others contradict," in said(content)


# ---- advice


def test_the_suggested_shaft_touch_improves_as_it_says(bench: Bench, live: Live) -> None:
    before, content = solved(ROOM, bench)
    assert before is not None and content.suggestion is not None
    assert content.suggestion.text.startswith("One more touch of the shaft of grinder rough adds most at a head angle")
    suggested = content.extra["suggested"]
    bench.session.choose("tool", "extra_shafts", {suggested["grinder"]: [suggested["angle_deg"]]}, PERSON)
    (told,) = acquire(ROOM, live, bench)
    assert np.degrees(told.data["angle_rad"]) == pytest.approx(suggested["angle_deg"], abs=1.5)
    after, content = solved(ROOM, bench)
    assert after is not None and content.complete
    assert row(content, "shaft rough 6").use is Use.FIT
    # Both in units of the noise, which is estimated anew from one touch more.
    shrunk = (after.wheels["rough"].axis_tilt_sigma_rad / after.wheels["rough"].sigma_mm) / (
        before.wheels["rough"].axis_tilt_sigma_rad / before.wheels["rough"].sigma_mm
    )
    promised = advise_shaft(before.wheels["rough"], bench.plan.grinders["rough"], {0: told.data["angle_rad"]})
    assert shrunk == pytest.approx(promised.after_mm / promised.before_mm, rel=0.2)


def test_an_extra_touch_of_the_cone_is_asked_for_there(bench: Bench, live: Live) -> None:
    outcome, _ = solved(ROOM, bench)
    assert outcome is not None
    used = np.array([touch.base_from_flange for touch in outcome.fitted_cone])
    advice = advise_cone(outcome.stylus, used, bench.plan.stylus.touches, None)
    tip = transform_points(advice.base_from_flange, outcome.stylus.tip_in_flange_mm)
    np.testing.assert_allclose(tip, outcome.stylus.pivot_in_base_mm, atol=1e-9)
    more = solve_stylus(np.concatenate([used, advice.base_from_flange[None]]), sigma_mm=outcome.stylus.sigma_mm)
    assert np.sqrt(np.linalg.eigvalsh(more.tip_covariance_mm2)[-1]) == pytest.approx(advice.after_mm, rel=1e-6)
    assert advice.after_mm < advice.before_mm
    from core.frames import euler_zyx_from_rotation

    entry = {
        "translation_mm": advice.base_from_flange[:3, 3].tolist(),
        "euler_zyx_deg": np.degrees(euler_zyx_from_rotation(advice.base_from_flange[:3, :3])).tolist(),
    }
    bench.session.choose("tool", "extra_cone", [entry], PERSON)
    (told,) = acquire(ROOM, live, bench)
    assert told.data["slot"] == CONE
    flange = np.array(told.data["base_from_flange"])
    assert np.arccos(flange[:3, 2] @ advice.base_from_flange[:3, 2]) < np.radians(15.0)
    assert solved(ROOM, bench)[1].complete


def test_more_touches_than_planned_are_suggested_for_short_arcs(whole: Bench) -> None:
    """The farther end of the travel beats the middle, where touches are already."""
    outcome, _ = solved(ROOM, whole)
    assert outcome is not None
    plan = whole.plan.grinders["rough"]
    fit = outcome.wheels["rough"]
    best = advise_shaft(fit, plan, None)
    middle = advise_shaft(fit, plan, {0: 0.0})
    assert abs(best.angle_rad) > np.radians(20.0)
    assert best.after_mm < middle.after_mm < middle.before_mm
    touches = WheelTouches(
        np.array([touch.angle_rad for touch in outcome.fitted_shafts["rough"]]),
        np.array([
            transform_points(touch.base_from_flange, outcome.stylus.tip_in_flange_mm)
            for touch in outcome.fitted_shafts["rough"]
        ]),
    )
    again = solve_wheel(touches, radius_mm=plan.head_radius_mm, shaft_offset_mm=-plan.shaft_side_offset_mm)
    assert again.rms_mm == fit.rms_mm


def test_planned_touches_that_are_missing_come_first(bench: Bench) -> None:
    bench.session.delete(sample_id(bench, "cone_touch", 2), PERSON)
    _, content = solved(ROOM, bench)
    assert content.suggestion is not None and "suggested" not in content.extra
    assert content.suggestion.text == "Take cone touch 3 next: of the missing ones it adds most."


def test_a_plan_without_grinders_is_a_stylus_alone(bench: Bench) -> None:
    alone = replace(bench, plan=replace(bench.plan, grinders={}))
    for sample in bench.session.samples("tool"):
        if sample.kind != "cone_touch":
            bench.session.delete(sample.id, PERSON)
    _, content = solved(ROOM, alone)
    assert content.ok and content.headline.startswith("fitted stylus ")
