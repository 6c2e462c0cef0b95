"""Room to run in: Python's own limit of nesting while a program is loaded and run."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from threading import Lock

FRAMES = 30_000  # Python's own frames; a nested call of RAPID takes about ten


class _Limit:
    """The limit is the whole process': raised by the first thread that comes in, and put back by the last to leave."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._inside, self._before = 0, 0

    def enter(self) -> None:
        with self._lock:
            if self._inside == 0:
                self._before = sys.getrecursionlimit()
                sys.setrecursionlimit(max(self._before, FRAMES))
            self._inside += 1

    def leave(self) -> None:
        with self._lock:
            self._inside -= 1
            if self._inside == 0:
                sys.setrecursionlimit(self._before)


_LIMIT = _Limit()


@contextmanager
def room() -> Iterator[None]:
    """Deeper nesting than Python allows unasked, for as long as anybody is inside."""
    _LIMIT.enter()
    try:
        yield
    finally:
        _LIMIT.leave()
