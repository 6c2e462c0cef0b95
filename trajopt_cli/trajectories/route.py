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
class Route:
    """The best chain: axes q and velocities w (M, n) at the waypoints, labels there, estimated times of the legs."""

    q: Array
    w: Array
    labels: tuple[IkBranch, ...]
    times: Array
    cost: float
