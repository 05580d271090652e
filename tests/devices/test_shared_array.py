from __future__ import annotations

import multiprocessing
from multiprocessing.connection import Connection

import numpy as np
import pytest

from devices.interfaces import Scan, SharedScan
from devices.shared_array import SharedArray


def _make_in_child(pipe: Connection) -> None:
    points = np.arange(12, dtype=np.float32).reshape(2, 2, 3)
    points[0, 0] = np.nan
    pipe.send(SharedScan.put(Scan(points, 1.5)))
    pipe.recv()  # go on living until the other side has looked


def _double_in_child(handle: SharedArray) -> None:
    with handle.attach() as view:
        view *= 2.0


def test_the_array_a_child_process_made_outlives_it() -> None:
    context = multiprocessing.get_context("spawn")
    here, there = context.Pipe()
    child = context.Process(target=_make_in_child, args=(there,))
    child.start()
    shared = here.recv()
    here.send("seen")
    child.join()
    assert child.exitcode == 0
    scan = shared.take()
    assert scan.time_s == 1.5
    assert scan.points_mm.shape == (2, 2, 3) and scan.points_mm.dtype == np.float32
    assert scan.valid_points_mm().tolist() == [[3, 4, 5], [6, 7, 8], [9, 10, 11]]
    with pytest.raises(FileNotFoundError), shared.points.attach():
        pass


def test_a_child_writes_into_the_same_memory() -> None:
    handle = SharedArray.put(np.array([1.0, 2.0, 3.0]))
    child = multiprocessing.get_context("spawn").Process(target=_double_in_child, args=(handle,))
    child.start()
    child.join()
    with handle.attach() as view:
        assert view.tolist() == [2.0, 4.0, 6.0]
    handle.unlink()


def test_an_empty_array_travels_too() -> None:
    handle = SharedArray.put(np.zeros((0, 3)))
    with handle.attach() as view:
        assert view.shape == (0, 3)
    handle.unlink()
