"""Large arrays between processes: the data stay in shared memory, a small picklable handle travels.

Example:
    >>> import numpy as np
    >>> handle = SharedArray.put(np.arange(3.0))
    >>> with handle.attach() as view:
    ...     float(view.sum())
    3.0
    >>> handle.unlink()
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from dataclasses import dataclass
from multiprocessing import resource_tracker, shared_memory
from typing import Any

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class SharedArray:
    """Where an array lies in shared memory.

    The one who receives it for good calls `unlink`; everybody else only attaches. The maker may end its process
    before: the memory lives until it is unlinked (POSIX shared memory; Windows frees it with the last open handle).

    Attributes:
        name: Name of the shared memory block.
        shape: Of the array.
        dtype: numpy's type string, e.g. `<f4`.
    """

    name: str
    shape: tuple[int, ...]
    dtype: str

    @classmethod
    def put(cls, array: NDArray[Any]) -> SharedArray:
        """Copy an array into a new block of shared memory."""
        block = shared_memory.SharedMemory(create=True, size=max(array.nbytes, 1))
        _forget(block)
        view: NDArray[Any] = np.ndarray(array.shape, dtype=array.dtype, buffer=block.buf)
        view[...] = array
        del view
        block.close()
        return cls(block.name, array.shape, array.dtype.str)

    @contextlib.contextmanager
    def attach(self) -> Iterator[NDArray[Any]]:
        """A view without a copy, valid inside the `with`; do not keep it or slices of it.

        Raises:
            FileNotFoundError: the block has been unlinked.
        """
        block = shared_memory.SharedMemory(name=self.name)
        _forget(block)
        view: NDArray[Any] = np.ndarray(self.shape, dtype=np.dtype(self.dtype), buffer=block.buf)
        try:
            yield view
        finally:
            del view
            block.close()

    def unlink(self) -> None:
        """Free the memory; views that are still open stay valid until they are closed."""
        block = shared_memory.SharedMemory(name=self.name)
        block.close()
        block.unlink()


def _forget(block: shared_memory.SharedMemory) -> None:
    # Python 3.11/3.12 track every attach as if it were ownership and would free the block when any process ends.
    resource_tracker.unregister(block._name, "shared_memory")  # type: ignore[attr-defined]
