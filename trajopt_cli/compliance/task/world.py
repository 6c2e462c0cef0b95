"""What stands between the controller's command and what it measures: an arm, and perhaps something it runs into."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

Seven = tuple[float, float, float, float, float, float, float]
Six = tuple[float, float, float, float, float, float]


@dataclass(frozen=True)
class Measured:
    """One period's end: joints q [rad], their speeds [rad/s] and accelerations [rad/s2], motor torques tau [Nm].

    contact [N, Nm]: the true force and moment of the surroundings on the tool, at the TCP in world axes, which only a
    simulation knows. depth [m]: how deep the tool is in something, 0 where it touches nothing.
    """

    q: Seven
    qd: Seven
    qdd: Seven
    tau: Seven
    contact: Six
    depth: float


class World(Protocol):
    """An arm that follows joint commands every period h, with its surroundings."""

    @property
    def name(self) -> str:
        """What simulates it, for people."""
        ...

    def reset(self, q: Seven) -> Measured:
        """Stand still at q."""
        ...

    def step(self, q: Seven) -> Measured:
        """Follow the command q for one period."""
        ...
