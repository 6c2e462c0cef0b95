"""How long a search for something better may go on once there is an answer."""

from __future__ import annotations

import mmap
import os
import struct
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from copy import copy
from time import monotonic, process_time
from typing import Any

_ANSWERED, _INTERRUPTED, _LEGAL = 0, 1, 2  # bytes that all processes of a run share
_RESERVED, _FIRST = 8, 16  # places of numbers [s] that they share
_HEARD = 0.25  # s between two looks at what other processes tell


class Stopped(Exception):
    """The time for this work is over, and there is an answer without it."""


class Patience:
    """A time limit [s], None for none, and the user's word to stop; seen by every process forked after this was made.

    Both end only the search for something better. Before there is an answer neither does anything by itself. clock: of
    the seconds [s].
    """

    def __init__(self, limit: float | None = None, clock: Callable[[], float] = monotonic):
        self.limit, self._clock = limit, clock
        self._start, self._worked = clock(), process_time()
        self._shared = mmap.mmap(-1, 24)
        self._hear: tuple[int, Callable[[], None]] | None = None
        self._heard = self._start

    def __getstate__(self) -> dict[str, object]:
        """For another computer, whose clock shows another time: what is left of the limit, and what was said so far.
        What is said from then on is not heard there."""
        left = None if self.limit is None else self.limit - self.spent
        return {"limit": left, "said": self._shared[:]}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__init__(state["limit"])  # type: ignore[misc]
        self._shared[:] = state["said"]

    @property
    def spent(self) -> float:
        """Seconds since this was made."""
        return self._clock() - self._start

    @property
    def load(self) -> float:
        """Seconds gone by for each that this process worked, from 1 to 10: what others take of the machine."""
        return min(max(1.0, self.spent / max(process_time() - self._worked, 1e-3)), 10.0)

    def answer(self) -> None:
        """Say that there is an answer now."""
        self._shared[_ANSWERED] = 1

    @property
    def answered(self) -> bool:
        """Whether there is an answer that an end of the search would leave."""
        return bool(self._shared[_ANSWERED])

    def settle(self) -> None:
        """Say that there is a legal motion that every plan can fall back on: from now on checkpoints end work."""
        if not self.settled:
            struct.pack_into("d", self._shared, _FIRST, self.spent)
            self._shared[_LEGAL] = 1

    @property
    def settled(self) -> bool:
        """Whether there is a legal motion that every plan can fall back on."""
        return bool(self._shared[_LEGAL])

    @property
    def late(self) -> float | None:
        """When the first legal motion was there [s], None within the limit, or where no more was asked for."""
        (first,) = struct.unpack_from("d", self._shared, _FIRST)
        return first if self.limit and self.settled and first > self.limit else None

    def reserve(self, seconds: float) -> None:
        """Keep time [s] of the limit for what has to be done behind the search."""
        struct.pack_into("d", self._shared, _RESERVED, seconds)

    def part(self, share: float) -> Patience:
        """The same with a share of the time that is left, for one piece of work among several."""
        if self.limit is None:
            return self
        out, (reserved,) = copy(self), struct.unpack_from("d", self._shared, _RESERVED)
        left = max(self.limit - reserved - self.spent, 0.0)
        out.limit = self.limit - left * (1 - min(share, 1.0))
        return out

    def interrupt(self) -> None:
        """End the search in all processes."""
        self._shared[_INTERRUPTED] = 1

    @property
    def interrupted(self) -> bool:
        """Whether the user said to stop."""
        return bool(self._shared[_INTERRUPTED])

    @property
    def over(self) -> bool:
        """Whether the search should end."""
        (reserved,) = struct.unpack_from("d", self._shared, _RESERVED)
        return self.interrupted or (self.limit is not None and self.spent >= self.limit - reserved)

    def why(self) -> str:
        """What ended the search."""
        return "stopped by Ctrl-C" if self.interrupted else f"stopped by the time limit after {self.limit:g} s"

    def hear(self, hear: Callable[[], None] | None) -> None:
        """Have checkpoints of this process listen to others now and then; None: no longer."""
        self._hear = None if hear is None else (os.getpid(), hear)

    @contextmanager
    def cutting(self) -> Iterator[None]:
        """Checkpoints inside raise Stopped once the search should end and there is something to fall back on."""
        before = _CUTTING.set(self)
        try:
            yield
        finally:
            _CUTTING.reset(before)

    def check(self) -> None:
        """A checkpoint. Raises Stopped."""
        if self._hear is not None and (now := self._clock()) - self._heard >= _HEARD and self._hear[0] == os.getpid():
            self._heard = now
            self._hear[1]()
        if self.settled and self.over:
            raise Stopped


_CUTTING: ContextVar[Patience | None] = ContextVar("cutting", default=None)


def in_force() -> Patience:
    """The patience that checkpoints ask now; endless patience for none."""
    return _CUTTING.get() or Patience()


def checkpoint() -> None:
    """Asked in every loop that may take long. Raises Stopped where the time for what is under way is over."""
    patience = _CUTTING.get()
    if patience is not None:
        patience.check()
