"""What an engine says while it works."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace


@dataclass(frozen=True)
class Progress:
    """Where a solve stands: its phase, the best cycle time so far and the proven lower bound [s], None until known."""

    phase: str
    incumbent: float | None = None
    bound: float | None = None

    @property
    def gap(self) -> float | None:
        """(incumbent - bound) / bound, None until both are known; 0 where nothing takes any time."""
        if self.incumbent is None or self.bound is None:
            return None
        return (self.incumbent - self.bound) / self.bound if self.incumbent > self.bound else 0.0


Report = Callable[[Progress], None]


def never_worse(report: Report) -> Report:
    """A report that passes on what it is told, with the best cycle time told so far."""
    best: float | None = None

    def tell(progress: Progress) -> None:
        nonlocal best
        known = [time for time in (best, progress.incumbent) if time is not None]
        best = min(known, default=None)
        report(replace(progress, incumbent=best))

    return tell
