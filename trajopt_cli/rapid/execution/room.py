"""Room to run in: Python's own limits while a program is loaded and run."""

from __future__ import annotations

import gc
import sys
from collections.abc import Iterator
from contextlib import contextmanager

_FRAMES = 30_000  # Python's own frames; a nested call of RAPID takes about ten


@contextmanager
def room() -> Iterator[None]:
    """Deeper nesting, and no garbage collector: a run makes hundreds of thousands of objects that stay."""
    limit, collecting = sys.getrecursionlimit(), gc.isenabled()
    gc.disable()
    sys.setrecursionlimit(max(limit, _FRAMES))
    try:
        yield
    finally:
        sys.setrecursionlimit(limit)
        if collecting:
            gc.enable()
