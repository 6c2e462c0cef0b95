"""A lower bound on the cycle time."""

from __future__ import annotations

from trajopt_cli.optimize.axes import Axes
from trajopt_cli.optimize.course import Course, LegKind
from trajopt_cli.optimize.double_integrator import trapezoid_time


def lower_bound(axes: Axes, course: Course, tied: bool, incumbent: float) -> float:
    """No legal motion of this course is faster [s]."""
    total = 0.0
    for leg in course.legs:
        if leg.kind is LegKind.LINE:
            total += max(float(trapezoid_time(leg.chord, leg.v_tcp, leg.a_tcp)), leg.duration or 0.0)
        elif leg.duration is not None:
            total += leg.duration
    return total
