"""Names of legs and problems: equal where the same is asked, so that it is searched, timed and bounded once."""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.path.arc import Arc
from trajopt_cli.path.turning import Turning
from trajopt_cli.problem.problem import Leg, Problem, Waypoint


def leg_name(leg: Leg) -> bytes:
    """Of a leg with its way and its caps, wherever it stands in a program."""
    numbers = leg.v_tcp, leg.a_tcp, leg.v_ori, leg.v_rail, leg.duration, leg.rail_moves, leg.acceleration, leg.least
    parts = [leg.kind.value.encode(), repr((*numbers, leg.along)).encode(), _digits(leg.X_FT)]
    if leg.load is not None:
        parts.append(repr(leg.load.numbers).encode())
    way = leg.segment
    if isinstance(way, Turning):
        parts, way = [*parts, repr(leg.units).encode()], way.way
    if way is not None:
        parts += [_digits(way.pose(np.array([0.0, 1.0])))]
    if isinstance(way, Arc):
        parts.append(_digits(way.numbers))
    return b"|".join(parts)


def stretch_name(problem: Problem, first: int, last: int) -> bytes:
    """Of what is asked from one waypoint to another, and at them."""
    points = [_point_name(point) for point in problem.waypoints[first : last + 1]]
    legs = [leg_name(leg) for leg in problem.legs[first:last]]
    held = problem.freedom.rail.value, problem.freedom.through_stops, problem.coupling.value
    return b"|".join([*points, *legs, repr(held).encode()])


def _point_name(point: Waypoint) -> bytes:
    asked = point.rail, point.written, point.rest, point.conf, point.fly_by
    return b"|".join([_digits(point.X_WF), repr(asked).encode(), b"" if point.q is None else _digits(point.q)])


def _digits(values: Array) -> bytes:
    return (np.round(values, 12) + 0.0).tobytes()  # -0 is 0
