"""What stands between the controller's command and what it measures: an arm, and perhaps something it runs into."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Protocol

Seven = tuple[float, float, float, float, float, float, float]
Six = tuple[float, float, float, float, float, float]


def seven(values: Iterable[float]) -> Seven:
    """Seven numbers as plain ones."""
    a, b, c, d, e, f, g = map(float, values)
    return (a, b, c, d, e, f, g)


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


@dataclass(frozen=True)
class LinkContact:
    """A link of the arm in an obstacle between two times [s], first and last; depth [m] and force [N] at most.

    force is None where the world only looks and does not push the link back.
    """

    link: str
    obstacle: str
    first: float
    last: float
    depth: float
    force: float | None


@dataclass(frozen=True)
class Motor:
    """What a joint's motor gave at most [Nm], its limit [Nm], and when it first stood there [s], None for never."""

    joint: str
    torque: float
    limit: float
    saturated: float | None


class World(Protocol):
    """An arm that follows joint commands every period h, with its surroundings, of which it keeps account."""

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

    @property
    def link_contacts(self) -> tuple[LinkContact, ...]:
        """Which links were in which obstacles since the reset, in the order of their first touch."""
        ...

    @property
    def motors(self) -> tuple[Motor, ...]:
        """What the motors gave since the reset; empty for an arm without any."""
        ...
