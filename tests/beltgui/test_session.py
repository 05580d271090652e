"""The session's folder: whole or absent, whatever happens to the process."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from beltgui.session import Session
from core.errors import InputError

WRITER = """
import sys
from pathlib import Path
import numpy as np
from beltgui.session import Session

session = Session.create(Path(sys.argv[1]), {"software": "test"})
for number in range(10_000):
    session.add_sample("ball", "scan", {"number": number}, np.full((2000, 3), number, dtype=np.float32))
    print(number, flush=True)
"""


def test_what_was_kept_comes_back(tmp_path: Path) -> None:
    points = np.array([[1.0, 2.0, 3.0], [np.nan, np.nan, np.nan]], dtype=np.float32)
    with Session.create(tmp_path / "s", {"software": "1.2", "seed": 7}) as session:
        session.add_sample("ball", "scan", {"stage_mm": [0.0, 1.0, 2.0]}, points)
        session.add_sample("tool", "cone_touch", {"index": 0})
        session.put_result("ball", {"rms_mm": 0.5}, ok=False)
        session.put_result("ball", {"rms_mm": 0.01}, ok=True)
    with Session.open(tmp_path / "s") as session:
        assert session.info()["seed"] == 7
        (sample,) = session.samples("ball", "scan")
        assert sample.data == {"stage_mm": [0.0, 1.0, 2.0]}
        np.testing.assert_array_equal(session.points(sample), [[1.0, 2.0, 3.0]])
        assert [s.kind for s in session.samples("tool")] == ["cone_touch"]
        result = session.result("ball")
        assert result is not None
        assert (result.ok, result.record) == (True, {"rms_mm": 0.01})
        assert session.result("base") is None
        assert list(session.steps_with_results()) == ["ball"]


def test_a_session_is_never_overwritten(tmp_path: Path) -> None:
    Session.create(tmp_path, {}).close()
    with pytest.raises(InputError, match="already"):
        Session.create(tmp_path, {})


def test_a_sample_that_is_no_json_leaves_nothing_behind(tmp_path: Path) -> None:
    with Session.create(tmp_path, {}) as session:
        with pytest.raises(ValueError, match="Out of range float"):
            session.add_sample("ball", "scan", {"x": float("nan")})
        assert session.samples("ball") == []
        session.add_sample("ball", "scan", {"x": 1.0})
        assert len(session.samples("ball")) == 1


@pytest.mark.parametrize("content", [None, b"", b"not a database at all, but long enough to look at" * 40])
def test_what_is_no_session_is_refused_in_words(tmp_path: Path, content: bytes | None) -> None:
    if content is not None:
        (tmp_path / "session.db").write_bytes(content)
    with pytest.raises(InputError, match=r"session\.db"):
        Session.open(tmp_path)


def test_a_damaged_cloud_is_named(tmp_path: Path) -> None:
    with Session.create(tmp_path, {}) as session:
        sample = session.add_sample("fine", "scan", {}, np.zeros((100, 3), dtype=np.float32))
        path = tmp_path / str(sample.cloud)
        path.write_bytes(path.read_bytes()[:200])
        with pytest.raises(InputError, match=f"sample {sample.id}"):
            session.points(sample)


def test_a_killed_process_leaves_whole_samples_only(tmp_path: Path) -> None:
    process = subprocess.Popen([sys.executable, "-c", WRITER, str(tmp_path)], stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None
    seen = [int(process.stdout.readline()) for _ in range(20)]
    os.kill(process.pid, signal.SIGKILL)
    seen += [int(line) for line in process.stdout.read().split()]
    process.stdout.close()
    process.wait()
    with Session.open(tmp_path) as session:
        samples = session.samples("ball")
        assert len(samples) >= len(seen)
        for number, sample in enumerate(samples):
            assert sample.data == {"number": number}
            np.testing.assert_array_equal(session.points(sample), np.full((2000, 3), number))
