"""What a search over rail positions and configurations finds: axes at the waypoints, before any timing."""

from __future__ import annotations

from dataclasses import dataclass

from trajopt_cli.geometry import Array


@dataclass(frozen=True, eq=False)
class IkBranch:
    """One continuous configuration of a station: branch number and whole turns (6,) added to the table."""

    cfx: int
    turns: Array


@dataclass(frozen=True, eq=False)
class OtherPart:
    """What a route may have instead from waypoint first on: axes q (m, n) and labels at whole stations. more [s]: by
    how much longer it is estimated to take."""

    first: int
    q: Array
    labels: tuple[IkBranch, ...]
    more: float

    @property
    def last(self) -> int:
        """The last of its waypoints."""
        return self.first + len(self.q) - 1


@dataclass(frozen=True, eq=False)
class Route:
    """The best route: axes q and velocities w (M, n) at the waypoints, labels there, estimated times of the legs.
    others: what may turn out to be faster, the most promising first."""

    q: Array
    w: Array
    labels: tuple[IkBranch, ...]
    times: Array
    cost: float
    others: tuple[OtherPart, ...] = ()
