"""Positioners: mechanical units that carry a work object, where they stand and how long they take to get there.

Values of external axes are in degrees or, where they slide, mm here, as RAPID states them.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, radians, sin, sqrt

from trajopt_cli.motion import ExternalAxes, Speed, UnitMove
from trajopt_cli.rapid.data import frames
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.position import merged
from trajopt_cli.rapid.language.syntax import Expression
from trajopt_cli.scenario import PositionerAxis
from trajopt_cli.units import MM
from trajopt_cli.warnings import WarningKind

_SLOWEST = 1e-3  # rad/s or m/s, as in a cell file: less would take for ever
_STILL = 0.1  # mm or deg: backups hold measured values of axes that stand


def kept_axes(run: Context, extax: ExternalAxes) -> ExternalAxes:
    """extax with the last value of every axis that it leaves open, or that no active unit drives."""
    return merged(run.position.extax, run.units.driven(extax))


def user_frame(axes: Sequence[PositionerAxis], at: Sequence[float]) -> frames.Frame:
    """The user frame [mm] in the world that the last axis carries, the axes at [deg or mm]."""
    return _links(axes, at)[-1]


def _links(axes: Sequence[PositionerAxis], at: Sequence[float]) -> list[frames.Frame]:
    """What each axis carries, a frame [mm] in the world about whose z it turns, or along which it slides, the axes at
    [deg or mm]."""
    out: list[frames.Frame] = []
    for axis, value in zip(axes, at, strict=True):
        x, y, z = axis.p
        found: frames.Frame = ((x / MM, y / MM, z / MM), axis.q)
        if out:
            found = frames.compose(out[-1], found)
        half = 0.0 if axis.slides else radians(value) / 2
        step = 0.0, 0.0, value if axis.slides else 0.0
        out.append(frames.compose(found, (step, (cos(half), 0.0, 0.0, sin(half)))))
    return out


def moved(
    run: Context, point: Expression, extax: ExternalAxes, speed: Speed, rides_on: str | None, timed: bool
) -> tuple[UnitMove, ...]:
    """The positioners that turn on the way to extax, at the programmed speed of turning axes at most.

    rides_on: the one that carries the move's work object. timed: a programmed time replaces the speed.
    Raises InputError for a value out of an axis' range.
    """
    out = []
    for unit, axes in run.scenario.positioners.items():
        if unit in run.units.parked:
            continue
        before = run.units.positions(unit, run.position.extax)
        after = run.units.positions(unit, kept_axes(run, extax))
        for axis, start, end, (origin, q) in zip(axes, before, after, _links(axes, before), strict=True):
            low, high = (value / axis.unit for value in axis.range)
            sign, cap, word = ("mm", speed.v_leax, "leax") if axis.slides else ("deg", speed.v_reax, "reax")
            if not low - _STILL <= end <= high + _STILL:
                where = f"{run.text(point)} asks for {unit}'s eax_{'abcdef'[axis.eax]} = {end:.6g} {sign}"
                raise run.error(point, f"{where}, {'stroke' if axis.slides else 'range'} {low:.6g}..{high:.6g} {sign}")
            if abs(end - start) > _STILL:
                a, b, v = start * axis.unit, end * axis.unit, axis.velocity if timed else min(axis.velocity, cap)
                if v < _SLOWEST:
                    verb = "moves" if axis.slides else "turns"
                    of = f"{v / axis.unit:g} {sign}/s (v_{word} of {speed.name})"
                    where = f"{verb} {unit}'s eax_{'abcdef'[axis.eax]} at {of}"
                    raise run.error(point, f"{where}: give at least {_SLOWEST / axis.unit:.3g} {sign}/s")
                way, most = abs(b - a), axis.acceleration  # from rest to rest, a trapezoid of speed or a triangle
                least = way / v + v / most if way > v * v / most else 2 * sqrt(way / most)
                p = origin[0] * MM, origin[1] * MM, origin[2] * MM
                u = frames.rotate(q, (0.0, 0.0, 1.0))
                shared = axis.eax in run.units.shared
                more = p, u, shared, axis.slides
                out.append(UnitMove(unit, axis.eax, a, b, least, unit == rides_on, v, axis.acceleration, *more))
    return tuple(out)


def driven_axes(run: Context, point: Expression, extax: ExternalAxes) -> ExternalAxes:
    """The external axes of a move's target that active units drive; reports once per unit that a value is ignored, or
    missing. Where it leaves the rail open, the cell file may say where that stands."""
    units = run.units
    extax = run.rail_places.fill(point, extax)
    if not units.axes:  # nearly always
        return extax
    for eax, names in units.inactive.items():
        value = extax[eax]
        at = [
            run.position.extax[eax] if one == units.rail else units.parked[one][units.axes[one].index(eax)]
            for one in names
        ]
        if value is not None and any(one is None or abs(value - one) > _STILL for one in at):
            what = f"{run.text(point)} gives eax_{'abcdef'[eax]} = {value:.6g}, and {' and '.join(names)} "
            what += f"{'are' if len(names) > 1 else 'is'} not active: the axis stays, as on the controller"
            run.note(f"{names} ignored", WarningKind.NO_EFFECT, what, point)
    for eax, unit in units.wanted.items():
        if extax[eax] is None:
            what = f"{run.text(point)} gives no position for eax_{'abcdef'[eax]} (9E9), and {unit} is active: a "
            what += "controller stops here with a missing external axis value, a plan lets it stand. Give the value, "
            what += f"deactivate {unit} before, or leave it out of the active ones (start.units in the cell file)"
            run.note(f"{unit} open", WarningKind.DOUBTFUL, what, point)
    return units.driven(extax)
