"""Runs of the wizard that are killed at random moments: nothing is lost, nothing is half-written, they go on."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from beltgui.engine import messages as m
from beltgui.engine import opening
from beltgui.files import write_atomically
from beltgui.leftovers import prefix, sweep
from benchmarks.kill_and_reopen.lane import Lane, Stage
from benchmarks.kill_and_reopen.reader import half_exported, leftovers, read


def gone_process() -> int:
    """Number of a process that has ended."""
    with subprocess.Popen([sys.executable, "-c", ""]) as process:
        process.wait()
    return process.pid


def test_a_run_goes_on_after_each_kill(tmp_path: Path) -> None:
    stages = [
        Stage("begin", kills=1),
        Stage("acquire", "ball", kills=1, finish=False),
        Stage("acquire", "tool", kills=1),
        Stage("accept", "tool", kills=1),
    ]
    lane = Lane(tmp_path, stages, seed=38, parents=0.5)
    lane.run()
    assert lane.missed == ""
    assert [kill.problems for kill in lane.kills] == [[], [], [], []]
    assert {kill.parent for kill in lane.kills} == {True, False}
    found = read(tmp_path / "session 1")
    assert found.accepted == {"tool"} and found.flags["tool"]


def test_the_reader_sees_what_is_wrong(tmp_path: Path) -> None:
    with opening.begin(m.NewSession(str(tmp_path), "A. Person", resolution="test")).session:
        pass
    assert leftovers(tmp_path, read(tmp_path)) == []
    (tmp_path / "clouds" / "00001_ball.npy").write_bytes(b"half")
    (tmp_path / ".simulated_cell.json.1.part").write_bytes(b"half")
    assert len(leftovers(tmp_path, read(tmp_path))) == 2
    (tmp_path / "session.db").write_bytes(b"SQLite format 3\0" + bytes(4000))
    assert read(tmp_path).problems
    out = tmp_path / "out"
    out.mkdir()
    (out / "a.script").write_text("def a():\n  movel(p[0.1")
    (out / "a.json").write_text('{"a": 1')
    assert [text.split()[-1] for text in half_exported(out)] == ["a.json", "a.script"]


def test_a_session_whose_beginning_was_killed_can_begin_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    command = m.NewSession(str(tmp_path / "session"), "A. Person")

    def killed(*words: object) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr("shutil.copyfile", killed)
        with pytest.raises(KeyboardInterrupt):
            opening.begin(command)
    assert not (tmp_path / "session" / "session.db").exists()
    opened = opening.begin(command)
    assert opened.cell_file.is_file()
    opened.session.close()


def test_a_writer_removes_what_a_killed_one_left(tmp_path: Path) -> None:
    pid, path = gone_process(), tmp_path / "a.script"
    stale = tmp_path / f".a.script.{pid}.0123abcd.part"
    living = tmp_path / f".a.script.{os.getppid()}.0123abcd.part"
    other = tmp_path / f".b.script.{pid}.0123abcd.part"
    for file in (stale, living, other):
        file.write_bytes(b"half")
    write_atomically(path, b"whole")
    assert sorted(tmp_path.iterdir()) == sorted([path, living, other])


def test_a_start_removes_temporary_files_of_processes_that_are_gone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    stale, strange = tmp_path / f"beltcal_engine_{gone_process()}_x.txt", tmp_path / "beltcal_engine_x.txt"
    own = tmp_path / f"{prefix('engine')}x.txt"
    for file in (stale, strange, own):
        file.write_bytes(b"")
    sweep()
    assert sorted(tmp_path.iterdir()) == sorted([strange, own])
