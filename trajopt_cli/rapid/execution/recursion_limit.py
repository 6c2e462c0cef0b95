"""Room to run in: Python's own limit of nesting while a program is loaded and run."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from threading import Lock

FRAMES = 30_000  # Python's own frames; a nested call of RAPID takes about ten


_lock = Lock()
_found: list[int] = []  # Python's limit as each found it who is inside now


@contextmanager
def room() -> Iterator[None]:
    """Deeper nesting than Python allows unasked, for as long as anybody is inside.

    The limit is the whole process': raised by the first thread that comes in, and put back by the last to leave.
    """
    with _lock:
        _found.append(sys.getrecursionlimit())
        sys.setrecursionlimit(max(_found[0], FRAMES))
    try:
        yield
    finally:
        with _lock:
            first = _found[0]
            _found.pop()
            if not _found:
                sys.setrecursionlimit(first)
