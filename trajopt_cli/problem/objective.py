"""What a plan is asked for: the least time, or the least effort within a time.

The effort of a motion is the integral of the sum of squares of all axes' accelerations, each as a share of its limit
[s]: one axis at its whole acceleration for a second has an effort of 1 s.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

A_HAIR = 9e-5  # share of the least time that a plan of least effort may take longer where no more was given


@dataclass(frozen=True)
class LeastTime:
    """The fastest motion."""


@dataclass(frozen=True)
class LeastEffort:
    """The gentlest motion that takes a given time [s]. or_least: where that is too short, the least time and a hair."""

    seconds: float
    or_least: bool = False

    def time(self, least: float) -> float | None:
        """How long the motion shall take [s] where it takes `least` at least; None where it has less than that."""
        if self.or_least:
            return max(self.seconds, least * (1 + A_HAIR))
        return self.seconds if self.seconds >= least else None


Objective = LeastTime | LeastEffort


def for_the_other(asked: Objective) -> Objective:
    """What is asked of the target whose plan was not chosen: it may be slower than the one that was."""
    return replace(asked, or_least=True) if isinstance(asked, LeastEffort) else asked


LEAST_TIME = LeastTime()
GENTLE = LeastEffort(0.0, or_least=True)
