r"""What a program's modal settings make of the accelerations: AccSet, PathAccLim, WorldAccLim.

A controller reduces first by AccSet, then by PathAccLim (RAPID reference, PathAccLim). AccSet is a share of its normal
accelerations, of all axes and along the path alike; the cell's limits stand for those. The other two are in m/s2 and
AccSet changes nothing about them.
"""

from __future__ import annotations

from trajopt_cli.limits import TcpCaps
from trajopt_cli.motion import Move, MoveExtJ


def acceleration_share(motion: Move) -> float:
    """Share in (0, 1] of every axis' acceleration limit that a move may use, external axes included (AccSet)."""
    return motion.settings.acceleration


def tcp_acceleration(motion: Move, tcp: TcpCaps) -> float:
    """Cap [m/s2] on the acceleration of a move's tool centre point.

    PathAccLim limits speeding up and slowing down along the path alone; here it caps the whole acceleration, in bends
    too, and the smaller of its two values counts for both. MoveExtJ moves no tool: only the share.
    """
    settings, cap = motion.settings, acceleration_share(motion) * tcp.acceleration
    given = settings.path_acceleration, settings.path_deceleration, settings.world_acceleration
    if isinstance(motion, MoveExtJ):
        return cap
    return min([cap, *(value for value in given if value is not None)])
