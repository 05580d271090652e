"""A process that is killed at any moment leaves a whole session."""

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

print("begin", flush=True)
session = Session.create(Path(sys.argv[1]), {"software": "test"})
print("created", flush=True)
for number in range(1, 10_000):
    session.add_sample("ball", "scan", {"number": number}, np.full((20_000, 3), number, dtype=np.float32))
    print("sample", number, flush=True)
    session.include(number, False, "Ada")
    print("left out", number, flush=True)
    if number % 2:
        session.undo("ball", "Ada")
        print("used", number, flush=True)
    session.put_result("ball", {"number": number}, ok=True, headline=str(number))
    print("result", number, flush=True)
    session.accept("ball", "Ada")
    print("accepted", number, flush=True)
"""


@pytest.mark.parametrize("lines", [1, 2, 3, 4, 9, 15, 22, 31])
def test_nothing_that_was_reported_is_lost_and_nothing_is_half(tmp_path: Path, lines: int) -> None:
    process = subprocess.Popen([sys.executable, "-c", WRITER, str(tmp_path)], stdout=subprocess.PIPE, text=True)
    with process:
        assert process.stdout is not None
        seen = [process.stdout.readline() for _ in range(lines)]
        process.kill()
        seen += process.stdout.readlines()
    said = [tuple(line.split()) for line in seen if line.endswith("\n")]
    last = {line[0]: int(line[-1]) for line in said if len(line) > 1}

    for write in (False, True):
        try:
            session = Session.open(tmp_path, write=write)
        except InputError as error:
            assert "no session here" in str(error) and ("created",) not in said
            continue
        with session:
            check(session, last)
            if write:
                in_folder = {f"clouds/{path.name}" for path in (tmp_path / "clouds").iterdir()}
                assert in_folder == {sample.cloud for sample in session.samples("ball")}
                session.add_sample("ball", "scan", {"number": 0})
                session.put_result("ball", {}, ok=True)
                session.accept("ball", "Bob")
    if ("created",) not in said and not (tmp_path / "session.db").exists():
        Session.create(tmp_path, {}).close()
        Session.open(tmp_path, write=True).close()


def check(session: Session, last: dict[str, int]) -> None:
    """Each step of the writer is there or not at all, in its order."""
    samples = session.samples("ball")
    assert len(samples) - last.get("sample", 0) in (0, 1)
    for number, sample in enumerate(samples, start=1):
        assert sample.data == {"number": number}
        np.testing.assert_array_equal(session.points(sample), np.full((20_000, 3), number))
    edits = session.edits("ball")
    assert len(edits) - last.get("left", 0) in (0, 1)
    for edit in edits:
        (sample,) = (sample for sample in samples if sample.id == edit.changes[0]["sample"])
        assert sample.included == (edit.state != "done")
    for result, said in ((session.result("ball"), "result"), (session.accepted_result("ball"), "accepted")):
        number = 0 if result is None else result.record["number"]
        assert number - last.get(said, 0) in (0, 1)
        if result is not None:
            assert result.samples == tuple(n for n in range(1, number + 1) if n % 2)
