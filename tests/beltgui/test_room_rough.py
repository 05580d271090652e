"""The rough step's room: automatic and by pairs, gone on with, and what its screen shows."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from beltgui.jobs import Cancelled, Job
from beltgui.steps.room import Bench
from beltgui.steps.rough.picks import delete_pair, include_pair, read_pairs, with_included, without
from beltgui.steps.views.drawing import count_points
from beltgui.viewmodel.scene import Lines, Mesh, Points
from beltgui.viewmodel.step import Use
from core.errors import FitError, InputError
from core.verdict import Code
from devices.interfaces import Mount
from tests.beltgui.blade_bench import PERSON, BladeBench, check_whole


@pytest.fixture(scope="module")
def scanned(tmp_path_factory: pytest.TempPathFactory) -> Iterator[BladeBench]:
    with BladeBench.start(tmp_path_factory.mktemp("rough") / "session") as cell:
        cell.acquire("rough")
        yield cell


@pytest.fixture
def cell(scanned: BladeBench) -> Iterator[BladeBench]:
    """The scanned blade; a test's edits are undone after it."""
    yield scanned
    scanned.undo_all()


@pytest.fixture
def fresh(tmp_path: Path) -> Iterator[BladeBench]:
    with BladeBench.start(tmp_path / "session") as cell:
        yield cell


@pytest.fixture(scope="module")
def automatic(scanned: BladeBench) -> Any:
    return scanned.solve("rough")


@pytest.fixture
def by_pairs(cell: BladeBench) -> Callable[[list[dict[str, Any]]], Any]:
    def solve(pairs: list[dict[str, Any]]) -> Any:
        cell.choose("rough", "method", "pairs")
        cell.choose("rough", "pairs", pairs)
        return cell.solve("rough")

    return solve


def shift(pair: dict[str, Any], by_mm: tuple[float, float, float]) -> None:
    """A slip of the hand on the scan."""
    pair["scan_mm"] = (np.array(pair["scan_mm"]) + np.array(by_mm)).tolist()


def said(outcome: Any) -> str:
    return "\n".join(reason.message for reason in outcome.verdict.reasons)


# ---- scans


def test_the_blade_is_asked_for_once_and_no_scan_is_taken_twice(fresh: BladeBench) -> None:
    fresh.acquire("rough")
    fresh.acquire("rough")
    samples = fresh.live.session.samples("rough", "scan")
    assert [sample.data["slot"] for sample in samples] == [0, 1]
    assert {sample.data["clamping"] for sample in samples} == {1}
    assert fresh.asked.items == ["blade"]


def test_a_cancelled_round_goes_on_with_the_missing_scan(fresh: BladeBench) -> None:
    job = Job(lambda fraction, text: job.cancel() if "scan 1 of" in text else None)
    with pytest.raises(Cancelled):
        fresh.acquire("rough", job)
    first = fresh.live.session.samples("rough", "scan")
    fresh.acquire("rough")
    samples = fresh.live.session.samples("rough", "scan")
    assert len(first) == 1 and samples[0].id == first[0].id and len(samples) == 2
    assert fresh.asked.items == ["blade"]


def test_a_deleted_scan_is_taken_again(fresh: BladeBench) -> None:
    fresh.acquire("rough")
    first, second = fresh.live.session.samples("rough", "scan")
    fresh.live.session.delete(first.id, PERSON)
    fresh.acquire("rough")
    assert [sample.data["slot"] for sample in fresh.live.session.samples("rough", "scan")] == [1, 0]
    assert second.id in {sample.id for sample in fresh.live.session.samples("rough", "scan")}


def test_a_new_round_begins_with_a_new_clamping(fresh: BladeBench) -> None:
    fresh.acquire("rough")
    fresh.live.session.start_over("rough", PERSON)
    fresh.acquire("rough")
    assert {sample.data["clamping"] for sample in fresh.live.session.samples("rough", "scan")} == {2}
    assert fresh.asked.items == ["blade", "blade"]


def test_after_a_restart_the_blade_is_asked_for_but_stays_the_same_clamping(fresh: BladeBench) -> None:
    fresh.acquire("rough")
    fresh.live.session.delete(fresh.live.session.samples("rough", "scan")[1].id, PERSON)
    old = fresh.bench
    fresh.bench = Bench(old.session, old.plan, old.blade, old.model, old.date, old.found)
    fresh.acquire("rough")
    assert fresh.asked.items == ["blade", "blade"]
    assert {sample.data["clamping"] for sample in fresh.live.session.samples("rough", "scan")} == {1}


def test_scans_of_two_clampings_are_not_mixed(fresh: BladeBench) -> None:
    fresh.acquire("rough")
    fresh.live.session.delete(fresh.live.session.samples("rough", "scan")[1].id, PERSON)
    fresh.live.context.cell.operator.perform(Mount("stylus"))
    fresh.live.session.add_sample("tool", "cone_touch", {"slot": 0})
    with pytest.raises(InputError, match=r"has been off the flange .* Start this step over"):
        fresh.acquire("rough")
    assert fresh.asked.items == ["blade", "stylus"]


# ---- automatic


def test_the_blade_is_found_without_a_start(scanned: BladeBench, automatic: Any) -> None:
    assert automatic.verdict.reasons == ()
    assert scanned.error_mm(automatic.measure_from_work) < 0.1
    assert [share.name for share in automatic.scans] == ["edge plate", "shroud"]
    record = scanned.rough.record(automatic)
    assert record["method"] == "automatic" and record["verdict"]["ok"]
    assert scanned.rough.headline(automatic).startswith("found automatically, RMS on the faces ")


def test_the_search_tells_how_far_it_is_and_ends_when_asked(cell: BladeBench) -> None:
    told: list[tuple[float, str]] = []

    def listen(fraction: float, text: str) -> None:
        told.append((fraction, text))
        if text.startswith("rotation 9 "):
            job.cancel()

    job = Job(listen)
    with pytest.raises(Cancelled):
        cell.solve("rough", job)
    fractions = [fraction for fraction, _ in told]
    assert fractions == sorted(fractions) and len(told) > 10
    assert told[-1][1].startswith("rotation 9 ")


def test_an_excluded_scan_takes_no_part(cell: BladeBench) -> None:
    first = cell.live.session.samples("rough", "scan")[0]
    cell.live.session.include(first.id, False, PERSON)
    with pytest.raises(FitError) as refusal:
        cell.solve("rough")
    content = cell.rough.view(cell.bench, None, str(refusal.value))
    assert content.reasons[0].message == str(refusal.value)
    assert [(row.use, row.included) for row in content.rows] == [(Use.EXCLUDED, False), (Use.FIT, True)]
    names = [item.name for item in content.scene.items]
    assert "scan" in names and "scan left out" in names


def test_what_the_screen_shows_of_an_automatic_result(scanned: BladeBench, automatic: Any) -> None:
    content = scanned.rough.view(scanned.bench, automatic)
    check_whole(content)
    assert content.ok and content.complete and content.progress == "2 of 2 scans"
    assert [row.id for row in content.rows] == [s.id for s in scanned.live.session.samples("rough", "scan")]
    assert all(15.0 < row.cells[3] < 80.0 for row in content.rows)
    assert len(content.checks) >= 3 and all(check.ok for check in content.checks)
    assert content.scene.frame == "M" and content.second_scene.frame == "W"
    assert count_points(content.scene) <= 60_000 and count_points(content.second_scene) <= 60_000
    scan = next(item for item in content.scene.items if isinstance(item, Points))
    mesh = next(item for item in content.second_scene.items if isinstance(item, Mesh))
    assert scan.pickable and mesh.pickable and len(mesh.face_id) == len(mesh.triangles)
    assert content.extra["method"] == "automatic"


def test_before_a_scan_the_plan_is_shown(fresh: BladeBench) -> None:
    content = fresh.rough.view(fresh.bench, None, "")
    check_whole(content)
    assert content.ok is None and content.rows == () and content.progress == "0 of 2 scans" and not content.complete
    assert sum(isinstance(item, Lines) for item in content.scene.items) == 2
    fresh.bench.found.clear()
    check_whole(fresh.rough.view(fresh.bench, None, "The ball step has no result."))


# ---- pairs


@pytest.mark.parametrize("count", [3, 5])
def test_good_pairs_are_confirmed_by_the_faces(cell: BladeBench, by_pairs: Any, count: int) -> None:
    outcome = by_pairs(cell.pairs(count))
    assert outcome.verdict.reasons == ()
    assert cell.error_mm(outcome.measure_from_work) < 0.1
    assert outcome.pairs_apart_mm.max() < 1.5
    record = cell.rough.record(outcome)
    assert record["method"] == "pairs" and len(record["pairs"]) == count
    np.testing.assert_allclose(record["measure_from_work"]["matrix"], outcome.measure_from_work)
    content = cell.rough.view(cell.bench, outcome)
    check_whole(content)
    assert [row.id for row in content.rows] == [-1 - k for k in range(count)]
    assert all(row.flag == "" for row in content.rows)
    assert content.extra["more_needed"] == 0 and content.extra["worst"] == ""
    assert (content.suggestion is not None) == (count == 3)
    assert content.plots[0].key == "pairs"


@pytest.mark.parametrize("count", [4, 6])
def test_a_wrong_pair_among_four_or_more_is_named_by_the_others(cell: BladeBench, by_pairs: Any, count: int) -> None:
    pairs = cell.pairs(count)
    shift(pairs[2], (9.0, -8.0, 6.0))
    outcome = by_pairs(pairs)
    assert not outcome.verdict.ok
    assert "Pair 'corner 3'" in said(outcome) and "pick it again" in said(outcome).lower()
    content = cell.rough.view(cell.bench, outcome)
    check_whole(content)
    assert [row.flag for row in content.rows] == ["", "", "worst", *[""] * (count - 3)]
    assert content.extra["worst"] == "corner 3" and content.extra["pairs"][2]["worst"]


@pytest.mark.parametrize("by_mm", [(9.0, -8.0, 6.0), (-60.0, 40.0, 20.0)])
def test_a_wrong_pair_among_three_is_named_by_the_faces(
    cell: BladeBench, by_pairs: Any, by_mm: tuple[float, float, float]
) -> None:
    pairs = cell.pairs(3)
    shift(pairs[1], by_mm)
    outcome = by_pairs(pairs)
    assert not outcome.verdict.ok
    assert "'corner 2'" in said(outcome) and "ick it again" in said(outcome)
    assert cell.rough.view(cell.bench, outcome).extra["worst"] == "corner 2"


def test_two_exchanged_picks_are_rejected(cell: BladeBench, by_pairs: Any) -> None:
    pairs = cell.pairs(3)
    pairs[0]["scan_mm"], pairs[1]["scan_mm"] = pairs[1]["scan_mm"], pairs[0]["scan_mm"]
    outcome = by_pairs(pairs)
    assert not outcome.verdict.ok
    assert "'corner 1'" in said(outcome) or "'corner 2'" in said(outcome)


def test_a_wrong_pair_that_is_unticked_does_no_harm(cell: BladeBench, by_pairs: Any) -> None:
    pairs = cell.pairs(5)
    shift(pairs[2], (9.0, -8.0, 6.0))
    outcome = by_pairs(with_included(read_pairs(pairs), -3, False))
    assert outcome.verdict.ok and cell.error_mm(outcome.measure_from_work) < 0.1
    content = cell.rough.view(cell.bench, outcome)
    check_whole(content)
    assert content.rows[2].use is Use.EXCLUDED and not content.rows[2].included
    assert len(without(read_pairs(pairs), -3)) == 4


@pytest.mark.parametrize(
    ("count", "sentence", "needed"), [(0, "pick 3 more", 3), (2, "2 of at least 3 pairs are picked: pick 1 more", 1)]
)
def test_too_few_pairs_say_how_many_are_missing(
    cell: BladeBench, by_pairs: Any, count: int, sentence: str, needed: int
) -> None:
    with pytest.raises(FitError, match=sentence) as refusal:
        by_pairs(cell.pairs(count))
    assert refusal.value.code is Code.NOT_ENOUGH_POINTS
    content = cell.rough.view(cell.bench, None, str(refusal.value))
    check_whole(content)
    assert content.reasons[0].message == str(refusal.value)
    assert content.extra["more_needed"] == needed and content.extra["next_name"] == "pair 1"


def test_a_half_picked_pair_waits_for_its_other_side(cell: BladeBench, by_pairs: Any) -> None:
    outcome = by_pairs(cell.pairs(3))
    cell.choose("rough", "pairs", [*cell.pairs(3), {"name": "tip", "scan_mm": None, "cad_mm": [0.0, 0.0, 200.0]}])
    assert cell.solve("rough") is outcome  # nobody is kept waiting for what changes nothing
    content = cell.rough.view(cell.bench, outcome)
    check_whole(content)
    assert content.extra["message"] == "Pick 'tip' on the scan too."
    assert content.rows[3].use is Use.EXCLUDED and "on the scan" in content.rows[3].note


@pytest.mark.parametrize(
    ("setting", "sentence"),
    [
        ("no list", "no list"),
        ([3], "Pair 1 has no name"),
        ([{"name": "a", "scan_mm": [0.0, 1.0], "cad_mm": None}], "'a' is not three numbers"),
        ([{"name": "a", "scan_mm": ["x", 0, 0], "cad_mm": None}], "'a' is not three numbers"),
        ([{"name": "a"}, {"name": "a"}], "Two pairs are called 'a'"),
    ],
)
def test_what_is_no_pair_is_refused_and_the_screen_still_shows_why(
    cell: BladeBench, setting: Any, sentence: str
) -> None:
    cell.choose("rough", "method", "pairs")
    cell.choose("rough", "pairs", setting)
    with pytest.raises(InputError, match=sentence):
        cell.solve("rough")
    assert sentence in cell.rough.view(cell.bench, None, "").reasons[0].message


def test_rows_of_pairs_are_ticked_and_deleted_through_the_setting(cell: BladeBench) -> None:
    session = cell.live.session
    cell.choose("rough", "pairs", cell.pairs(4))
    include_pair(session, -2, False, PERSON)
    assert [pair.included for pair in read_pairs(session.setting("rough", "pairs"))] == [True, False, True, True]
    delete_pair(session, -1, PERSON)
    assert [pair.name for pair in read_pairs(session.setting("rough", "pairs"))] == ["corner 2", "corner 3", "corner 4"]
    session.undo("rough", PERSON)
    assert len(session.setting("rough", "pairs")) == 4


def test_a_row_that_is_gone_cannot_be_edited(cell: BladeBench) -> None:
    pairs = read_pairs(cell.pairs(3))
    for row in (-4, 0, 7):
        with pytest.raises(InputError, match="no such pair"):
            with_included(pairs, row, False)
        with pytest.raises(InputError, match="no such pair"):
            without(pairs, row)


def test_an_unknown_method_is_refused(cell: BladeBench) -> None:
    cell.choose("rough", "method", "guessing")
    with pytest.raises(InputError, match="'automatic' and 'pairs', found 'guessing'"):
        cell.solve("rough")
    assert cell.rough.view(cell.bench, None, "so").reasons[0].message == "so"
