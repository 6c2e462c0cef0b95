"""Positioners: mechanical units that carry a work object, where they stand and how long they take to get there.

Values of external axes are in degrees here, as RAPID states them.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, degrees, radians, sin, sqrt
from typing import TYPE_CHECKING

from trajopt_cli.motion import ExternalAxes, Speed, UnitMove
from trajopt_cli.rapid.data import frames
from trajopt_cli.scenario import PositionerAxis
from trajopt_cli.units import MM

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Execution
    from trajopt_cli.rapid.language.syntax import Expression

_SLOWEST = 1e-3  # rad/s, as in a cell file: less would take for ever
_STILL = 0.1  # deg: backups hold measured values of axes that stand


def positions(run: Execution, unit: str, extax: ExternalAxes) -> tuple[float, ...]:
    """Where a unit's axes stand [deg], external axes at extax; at their start where that says nothing, and where they
    were left while the unit is not active."""
    if (parked := run.units.parked.get(unit)) is not None:
        return parked
    axes = run.scenario.positioners[unit]
    given = [extax[axis.eax] for axis in axes]
    return tuple(degrees(axis.start) if value is None else value for axis, value in zip(axes, given, strict=True))


def user_frame(axes: Sequence[PositionerAxis], at: Sequence[float]) -> frames.Frame:
    """The user frame [mm] in the world that the last axis carries, the axes at [deg]."""
    return _links(axes, at)[-1]


def _links(axes: Sequence[PositionerAxis], at: Sequence[float]) -> list[frames.Frame]:
    """What each axis carries, a frame [mm] in the world whose z it turns about, the axes at [deg]."""
    out: list[frames.Frame] = []
    for axis, value in zip(axes, at, strict=True):
        x, y, z = axis.p
        found: frames.Frame = ((x / MM, y / MM, z / MM), axis.q)
        if out:
            found = frames.compose(out[-1], found)
        half = radians(value) / 2
        out.append(frames.compose(found, ((0.0, 0.0, 0.0), (cos(half), 0.0, 0.0, sin(half)))))
    return out


def moved(
    run: Execution, point: Expression, extax: ExternalAxes, speed: Speed, rides_on: str | None, timed: bool
) -> tuple[UnitMove, ...]:
    """The positioners that turn on the way to extax, at the programmed speed of turning axes at most.

    rides_on: the one that carries the move's work object. timed: a programmed time replaces the speed.
    Raises InputError for a value out of an axis' range.
    """
    out = []
    for unit, axes in run.scenario.positioners.items():
        if unit in run.units.parked:
            continue
        before, after = positions(run, unit, run.position.extax), positions(run, unit, run.position.kept(extax))
        for axis, start, end, (origin, q) in zip(axes, before, after, _links(axes, before), strict=True):
            low, high = (degrees(value) for value in axis.range)
            if not low - _STILL <= end <= high + _STILL:
                where = f"{run.text(point)} asks for {unit}'s eax_{'abcdef'[axis.eax]} = {end:.6g} deg"
                raise run.error(point, f"{where}, range {low:.6g}..{high:.6g} deg")
            if abs(end - start) > _STILL:
                a, b, v = radians(start), radians(end), axis.velocity if timed else min(axis.velocity, speed.v_reax)
                if v < _SLOWEST:
                    where = f"turns {unit}'s eax_{'abcdef'[axis.eax]} at {degrees(v):g} deg/s (v_reax of {speed.name})"
                    raise run.error(point, f"{where}: give at least {degrees(_SLOWEST):.3g} deg/s")
                least = _trapezoid(abs(b - a), v, axis.acceleration)
                p = origin[0] * MM, origin[1] * MM, origin[2] * MM
                u = frames.rotate(q, (0.0, 0.0, 1.0))
                shared = axis.eax in run.units.shared
                out.append(UnitMove(unit, axis.eax, a, b, least, unit == rides_on, v, axis.acceleration, p, u, shared))
    return tuple(out)


def _trapezoid(way: float, v: float, a: float) -> float:
    """Least time from rest to rest over a way, at speed v and acceleration a at most."""
    return way / v + v / a if way > v * v / a else 2 * sqrt(way / a)
