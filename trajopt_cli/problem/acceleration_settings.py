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
    """Cap [m/s2] on the whole acceleration of a move's tool centre point; MoveExtJ moves no tool: only the share."""
    cap, world = acceleration_share(motion) * tcp.acceleration, motion.settings.world_acceleration
    return cap if world is None or isinstance(motion, MoveExtJ) else min(cap, world)


def path_acceleration(motion: Move, tcp: TcpCaps) -> tuple[float, float] | None:
    """Caps [m/s2] on speeding up and slowing down along the path of a move's tool centre point, each at most that on
    the whole acceleration; None where nothing asks for less. Bends are free of them (RAPID reference, PathAccLim)."""
    whole, settings = tcp_acceleration(motion, tcp), motion.settings
    given = settings.path_acceleration, settings.path_deceleration
    up, down = (whole if one is None else min(one, whole) for one in given)
    return None if isinstance(motion, MoveExtJ) or min(up, down) == whole else (up, down)
