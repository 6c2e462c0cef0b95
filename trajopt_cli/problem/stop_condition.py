"""How long a search for something better may go on once there is an answer."""

from __future__ import annotations

import mmap
from time import monotonic

_ANSWERED, _INTERRUPTED = 0, 1  # bytes that all processes of a run share


class Patience:
    """A time limit [s], None for none, and the user's word to stop; seen by every process forked after this was made.

    Both end only the search for something better. Before there is an answer neither does anything by itself.
    """

    def __init__(self, limit: float | None = None):
        self.limit = limit
        self._start = monotonic()
        self._shared = mmap.mmap(-1, 2)

    def answer(self) -> None:
        """Say that there is an answer now."""
        self._shared[_ANSWERED] = 1

    @property
    def answered(self) -> bool:
        """Whether there is an answer that an end of the search would leave."""
        return bool(self._shared[_ANSWERED])

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
        return self.interrupted or (self.limit is not None and monotonic() - self._start >= self.limit)

    def why(self) -> str:
        """What ended the search."""
        return "stopped by Ctrl-C" if self.interrupted else f"stopped by the time limit after {self.limit:g} s"
