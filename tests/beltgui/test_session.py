"""The session's folder: what was kept comes back; one writer, many readers; what is no session is refused in words."""

import json
import shutil
import sqlite3
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest

from beltgui import __version__
from beltgui.session import Basis, Session
from core.errors import InputError

HOLDER = """
import sys
from pathlib import Path
from beltgui.session import Session

session = Session.open(Path(sys.argv[1]), write=True)
session.add_sample("tool", "cone_touch", {"slot": 7})
print("holding", flush=True)
sys.stdin.read()
"""


def cloud(value: float, count: int = 10) -> np.ndarray:
    return np.full((count, 3), value, dtype=np.float32)


def test_what_was_kept_comes_back(tmp_path: Path) -> None:
    points = np.array([[1.0, 2.0, 3.0], [np.nan, np.nan, np.nan]], dtype=np.float32)
    with Session.create(tmp_path / "a" / "s", {"software": "1.2", "seed": 7}) as session:
        kept = session.add_sample("ball", "scan", {"stage_mm": [0.0, 1.0, 2.0]}, points)
        session.add_sample("tool", "cone_touch", {"index": 0})
        session.choose("ball", "method", {"name": "quick", "rounds": 3}, "Ada")
        session.put_result("ball", {"rms_mm": 0.5}, ok=False, headline="0.5 mm")
        stored = session.put_result(
            "ball", {"rms_mm": 0.01}, ok=True, headline="0.01 mm", stands_on={"base": 3}, person="Ada"
        )
        session.accept("ball", "Bob")
        session.decide("ball", "Bob", "exported")
    with Session.open(tmp_path / "a" / "s") as session:
        assert not session.writable
        assert (session.info()["seed"], session.info()["format"]) == (7, 2)
        (sample,) = session.samples("ball", "scan")
        assert sample == kept
        assert (sample.data, sample.included, sample.deleted) == ({"stage_mm": [0.0, 1.0, 2.0]}, True, False)
        np.testing.assert_array_equal(session.points(sample), [[1.0, 2.0, 3.0]])
        assert [s.kind for s in session.samples("tool")] == ["cone_touch"]
        assert session.setting("ball", "method") == {"name": "quick", "rounds": 3}
        assert session.setting("ball", "other", 5) == 5
        result = session.result("ball")
        assert result == stored == session.accepted_result("ball") == session.stored(stored.id)
        assert result is not None
        assert (result.ok, result.record, result.headline, result.person) == (
            True, {"rms_mm": 0.01}, "0.01 mm", "Ada")  # fmt: skip
        assert (result.samples, result.stands_on, result.software) == ((kept.id,), {"base": 3}, __version__)
        assert result.settings == {"method": {"name": "quick", "rounds": 3}}
        assert session.result("base") is None and session.accepted_result("base") is None
        assert list(session.steps_with_results()) == ["ball"]
        assert [(d.person, d.step, d.what, d.result_id) for d in session.decisions()] == [
            ("Bob", "ball", "accepted", stored.id), ("Bob", "ball", "exported", None)]  # fmt: skip


def test_a_session_is_never_overwritten(tmp_path: Path) -> None:
    Session.create(tmp_path, {}).close()
    with pytest.raises(InputError, match="already"):
        Session.create(tmp_path, {})


def test_a_folder_that_cannot_hold_a_session_is_named(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way")
    with pytest.raises(InputError, match="no session can be begun here"):
        Session.create(tmp_path / "file" / "s", {})


def test_a_sample_that_is_no_json_leaves_nothing_behind(tmp_path: Path) -> None:
    with Session.create(tmp_path, {}) as session:
        with pytest.raises(ValueError, match="Out of range float"):
            session.add_sample("ball", "scan", {"x": float("nan")}, cloud(1.0))
        with pytest.raises(ValueError, match="Out of range float"):
            session.put_result("ball", {"x": float("inf")}, ok=True)
        with pytest.raises(ValueError, match="Out of range float"):
            session.choose("ball", "x", float("nan"), "Ada")
        assert session.samples("ball") == [] and session.result("ball") is None and not session.can_undo("ball")
        assert list((tmp_path / "clouds").iterdir()) == []
        assert session.add_sample("ball", "scan", {"x": 1.0}).id == 1


@pytest.mark.parametrize("content", [None, b"", b"not a database at all, but long enough to look at" * 40])
@pytest.mark.parametrize("write", [False, True])
def test_what_is_no_session_is_refused_in_words(tmp_path: Path, content: bytes | None, write: bool) -> None:
    if content is not None:
        (tmp_path / "session.db").write_bytes(content)
    with pytest.raises(InputError, match=r"session\.db"):
        Session.open(tmp_path, write=write)


@pytest.mark.parametrize("write", [False, True])
def test_a_session_of_the_earlier_format_names_the_version_that_reads_it(tmp_path: Path, write: bool) -> None:
    connection = sqlite3.connect(tmp_path / "session.db")
    connection.execute("CREATE TABLE info (key TEXT PRIMARY KEY, value TEXT NOT NULL)")
    rows = {"format": 1, "software": "0.1.0"}
    connection.executemany("INSERT INTO info VALUES (?, ?)", [(key, json.dumps(value)) for key, value in rows.items()])
    connection.commit()
    connection.close()
    before = (tmp_path / "session.db").read_bytes()
    with pytest.raises(InputError, match=r"format 1, expected 2\. Use beltcal 0\.1\.0 to open it"):
        Session.open(tmp_path, write=write)
    assert (tmp_path / "session.db").read_bytes() == before


def test_a_damaged_cloud_is_named(tmp_path: Path) -> None:
    with Session.create(tmp_path, {}) as session:
        sample = session.add_sample("fine", "scan", {}, cloud(0.0, 100))
        path = tmp_path / str(sample.cloud)
        path.write_bytes(path.read_bytes()[:200])
        with pytest.raises(InputError, match=f"sample {sample.id}"):
            session.points(sample)


def test_kept_tells_missing_samples_from_those_left_out(tmp_path: Path) -> None:
    with Session.create(tmp_path, {}) as session:
        with pytest.raises(InputError, match="no sample 'scan' of the step 'ball'"):
            session.kept("ball", "scan")
        first, second = (session.add_sample("ball", "scan", {"slot": slot}) for slot in (0, 1))
        session.include(first.id, False, "Ada")
        assert [sample.id for sample in session.kept("ball", "scan")] == [second.id]
        session.include(second.id, False, "Ada")
        with pytest.raises(InputError, match="All samples 'scan' of the step 'ball' are left out"):
            session.kept("ball", "scan")


# ---- results


def test_only_a_good_result_of_the_present_samples_is_accepted(tmp_path: Path) -> None:
    with Session.create(tmp_path, {}) as session:
        with pytest.raises(InputError, match="no result yet"):
            session.accept("ball", "Ada")
        sample = session.add_sample("ball", "scan", {})
        session.put_result("ball", {}, ok=False, headline="0.2 mm, too much")
        with pytest.raises(InputError, match=r"not good enough to accept: 0\.2 mm, too much"):
            session.accept("ball", "Ada")
        good = session.put_result("ball", {}, ok=True)
        session.include(sample.id, False, "Ada")
        with pytest.raises(InputError, match="changed since it was solved"):
            session.accept("ball", "Ada")
        assert session.accepted_result("ball") is None
        session.undo("ball", "Ada")
        assert session.accept("ball", "Ada") == good == session.accepted_result("ball")


def test_a_result_belongs_to_what_it_was_solved_from(tmp_path: Path) -> None:
    with Session.create(tmp_path, {}) as session:
        sample = session.add_sample("ball", "scan", {})
        basis = session.basis("ball")
        session.add_sample("ball", "scan", {})  # while it is being solved
        assert session.put_result("ball", {}, ok=True, basis=basis).samples == (sample.id,)
        with pytest.raises(InputError, match="Solve it again"):
            session.accept("ball", "Ada")


def test_accepting_the_same_again_keeps_the_accepted_result(tmp_path: Path) -> None:
    with Session.create(tmp_path, {}) as session:
        first = session.put_result("ball", {"x": 1}, ok=True)
        assert session.accept("ball", "Ada") == session.accept("ball", "Ada") == first
        session.put_result("ball", {"x": 1}, ok=True)
        assert session.accept("ball", "Ada") == first
        other = session.put_result("ball", {"x": 2}, ok=True)
        assert session.accept("ball", "Ada") == other
        assert [decision.result_id for decision in session.decisions()] == [first.id, other.id]


def test_settings_of_a_picture_do_not_void_a_result(tmp_path: Path) -> None:
    with Session.create(tmp_path, {}) as session:
        result = session.put_result("error_surface", {}, ok=True)
        session.choose("error_surface", "show_exaggeration", 500, "Ada")
        assert session.basis("error_surface").fits(result)
        session.choose("error_surface", "grinder", "fine", "Ada")
        assert session.basis("error_surface").changed_settings(result) == ["grinder"]
        assert Basis().fits(result)


# ---- readers and writers


def test_a_second_writer_is_refused_and_a_reader_is_not(tmp_path: Path) -> None:
    with Session.create(tmp_path, {}) as first:
        with pytest.raises(InputError, match=r"being written by process \d+ on .*open it read-only"):
            Session.open(tmp_path, write=True)
        with Session.open(tmp_path) as reader:
            sample = first.add_sample("ball", "scan", {}, cloud(4.0))
            assert reader.samples("ball") == [sample]
            assert reader.points(sample).shape == (10, 3)
            with pytest.raises(InputError, match="opened read-only"):
                reader.add_sample("ball", "scan", {}, cloud(4.0))
            assert sorted(path.name for path in (tmp_path / "clouds").iterdir()) == ["00001_ball.npy"]
    with Session.open(tmp_path, write=True) as again:
        assert again.writable and again.add_sample("ball", "scan", {}).id == 2


def test_another_process_that_writes_is_refused_until_it_dies(tmp_path: Path) -> None:
    Session.create(tmp_path, {}).close()
    holder = subprocess.Popen(
        [sys.executable, "-c", HOLDER, str(tmp_path)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    with holder:
        assert holder.stdout is not None
        assert holder.stdout.readline() == "holding\n"
        with pytest.raises(InputError, match=f"being written by process {holder.pid} on "):
            Session.open(tmp_path, write=True)
        with Session.open(tmp_path) as reader:
            assert [sample.data for sample in reader.samples("tool")] == [{"slot": 7}]
        holder.kill()
        holder.wait()
        with Session.open(tmp_path, write=True) as session:
            assert [sample.data for sample in session.samples("tool")] == [{"slot": 7}]


def test_a_closed_session_says_so(tmp_path: Path) -> None:
    session = Session.create(tmp_path, {})
    session.close()
    session.close()
    for use in (lambda: session.samples("ball"), lambda: session.add_sample("ball", "scan", {}, cloud(0.0))):
        with pytest.raises(InputError, match="has been closed"):
            use()
    assert list((tmp_path / "clouds").iterdir()) == []


def test_two_threads_use_one_session(tmp_path: Path) -> None:
    faults: list[BaseException] = []

    def acquire(session: Session) -> None:
        try:
            for number in range(30):
                session.add_sample("ball", "scan", {"slot": number}, cloud(number))
        except BaseException as error:
            faults.append(error)

    with Session.create(tmp_path, {}) as session:
        worker = threading.Thread(target=acquire, args=(session,))
        worker.start()
        edits = 0
        while worker.is_alive() or edits == 0:
            for sample in session.samples("ball")[:3]:
                session.include(sample.id, not sample.included, "Ada")
                assert len(session.points(sample)) == 10
                edits += 1
        worker.join()
        assert faults == []
        assert [sample.data["slot"] for sample in session.samples("ball")] == list(range(30))
        assert len(session.edits("ball")) == edits


def test_a_read_only_folder_is_readable_with_all_that_its_log_holds(tmp_path: Path) -> None:
    copy = tmp_path / "copy"
    with Session.create(tmp_path / "s", {}) as session:
        sample = session.add_sample("ball", "scan", {"x": 1}, cloud(2.0))
        shutil.copytree(tmp_path / "s", copy)
    (copy / "session.db-shm").unlink()
    assert (copy / "session.db-wal").stat().st_size > 0
    # As in a folder without the right to write: the file that SQLite needs beside the log cannot be made.
    (copy / "session.db-shm").mkdir()
    for path in (*copy.rglob("*"), copy):
        path.chmod(0o555 if path.is_dir() else 0o444)
    names = sorted(path.name for path in copy.iterdir())
    try:
        with Session.open(copy) as reader:
            assert reader.samples("ball") == [sample]
            np.testing.assert_array_equal(reader.points(sample), cloud(2.0))
        assert sorted(path.name for path in copy.iterdir()) == names
    finally:
        copy.chmod(0o755)


def test_what_a_killed_writer_left_is_cleared_away(tmp_path: Path) -> None:
    with Session.create(tmp_path, {}) as session:
        session.add_sample("ball", "scan", {}, cloud(1.0))
    clouds = tmp_path / "clouds"
    (clouds / ".123-0.part").write_bytes(b"half")
    (clouds / "00002_ball.npy").write_bytes(b"whole, but its sample never came")
    (clouds / "notes.txt").write_text("of a person")
    Session.open(tmp_path).close()
    assert (clouds / ".123-0.part").exists()
    Session.open(tmp_path, write=True).close()
    assert sorted(path.name for path in clouds.iterdir()) == ["00001_ball.npy", "notes.txt"]


def test_the_module_is_light() -> None:
    check = "import sys, beltgui.session; print(*sorted({'sqlalchemy', 'numpy', 'scipy'} & set(sys.modules)))"
    out = subprocess.run([sys.executable, "-c", check], capture_output=True, text=True, check=True).stdout
    assert out.strip() == ""
