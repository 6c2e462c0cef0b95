"""Room to run in: Python's own limits while a program is loaded and run."""

from __future__ import annotations

import gc
import sys
from collections.abc import Iterator
from contextlib import contextmanager

_FRAMES = 30_000  # Python's own frames; a nested call of RAPID takes about ten


@contextmanager
def uncollected() -> Iterator[None]:
    """No garbage collector: a program makes millions of objects, nearly all without cycles, and most of them stay."""
    collecting = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collecting:
            gc.enable()


@contextmanager
def room() -> Iterator[None]:
    """Deeper nesting, and no garbage collector."""
    limit = sys.getrecursionlimit()
    sys.setrecursionlimit(max(limit, _FRAMES))
    try:
        with uncollected():
            yield
    finally:
        sys.setrecursionlimit(limit)
