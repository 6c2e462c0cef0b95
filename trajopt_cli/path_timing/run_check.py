"""A course driven by a law, looked at between its nodes: the dense check of `exchange` for whole courses at once.

Between two nodes the motion is what `pace` makes of it: the share of a way by a constant second derivative, the rail or
the axes by the cubic with the rates at both nodes.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.path.corner import Corner
from trajopt_cli.path.hermite import hermite
from trajopt_cli.path.joint_corner import JointCorner
from trajopt_cli.path_timing.sampled_path import SampledPath
from trajopt_cli.problem.problem import Problem
from trajopt_cli.settings import ALONG_LOOKS, CHECKED, CORNER_LOOKS, COURSE_LOOKS
from trajopt_cli.timing.topp import TimeLaw
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.dense_check import Ratios, ratios_of
from trajopt_cli.trajectories.leg_trajectories import Sample, on_ways


def looked_at(axes: Axes, problem: Problem, course: SampledPath, law: TimeLaw, intervals: IndexArray) -> Ratios:
    """Worst ratio to each limit in some of the intervals of a course driven by a law, in order; not of jerk."""
    corner = np.array([isinstance(part.segment, Corner | JointCorner) for part in course.parts])[course.part[intervals]]
    along = np.array([problem.legs[k].along is not None for k in course.leg[intervals]])
    looks = COURSE_LOOKS * np.where(along, ALONG_LOOKS, np.where(corner, CORNER_LOOKS, 1))
    found, order = list[Ratios](), list[IndexArray]()
    for many in np.unique(looks):
        alike, at_once = np.flatnonzero(looks == many), max(1, CHECKED // (many + 2))
        groups = np.split(alike, range(at_once, len(alike), at_once))
        found += [_worst(axes, problem, course, law, intervals[some], many) for some in groups]
        order += groups
    back = np.argsort(np.concatenate(order))
    return Ratios.joined(found).at(back)


def _worst(
    axes: Axes, problem: Problem, course: SampledPath, law: TimeLaw, intervals: IndexArray, looks: int
) -> Ratios:
    """The same of so many that the memory takes them at once; both ends are looked at from inside."""
    inside = np.clip((np.arange(looks + 2) - 0.5) / looks, 1e-9, 1 - 1e-9)
    first = np.arange(0, len(intervals) * len(inside), len(inside))
    number, u = np.repeat(np.arange(len(intervals)), len(inside)), np.tile(inside, len(intervals))
    rate_0, rate_1 = law.rates[intervals], law.rates[intervals + 1]
    steps = 2 * np.diff(course.sigma)[intervals] / (rate_0 + rate_1)
    legs = course.leg[intervals]
    names, of = np.unique(legs, return_inverse=True)
    asked = [problem.legs[k] for k in names]
    q, qd, qdd = (np.empty((len(u), axes.n)) for _ in range(3))
    sample = Sample(u * steps[number], q, qd, qdd, np.full((len(u), 2, 6), np.nan))
    for at, found in _samples(axes, problem, course, law, intervals, steps, number, u):
        q[at], qd[at], qdd[at] = found.q, found.qd, found.qdd
        if sample.tool is not None and found.tool is not None:
            sample.tool[at] = found.tool
    return ratios_of(axes, asked, of[number], sample, first)


def _samples(
    axes: Axes, problem: Problem, course: SampledPath, law: TimeLaw, intervals: IndexArray, steps: Array,
    number: IndexArray, u: Array,
) -> Iterator[tuple[IndexArray, Sample]]:  # fmt: skip
    """Looks by their numbers, and what is there: axes that decide, then ways of each tool. number: of the interval that
    a look is in, u: its share of it."""
    a, part = course.first[intervals], course.part[intervals]
    rate_0, rate_1 = law.rates[intervals], law.rates[intervals + 1]

    def cubic(x: Array, slope: Array, at: IndexArray) -> Array:
        """What goes by x with slopes by sigma, both (rows, k), at some looks; both derivatives by time (3, m, k)."""
        i = number[at]
        h, row = steps[i, None], a[i]
        v_0, v_1 = slope[row] * rate_0[i, None] * h, slope[row + 1] * rate_1[i, None] * h
        found = hermite(x[row], v_0, x[row + 1], v_1, u[at, None])
        return np.stack([found[0], found[1] / h, found[2] / h**2])

    on_way = np.array([one.rail is not None for one in course.parts])[part][number]
    at = np.flatnonzero(~on_way)
    if len(at):
        yield at, Sample(u[at], *cubic(course.along.q, course.along.dq, at))
    tools = [problem.legs[one.leg].X_FT.tobytes() for one in course.parts]
    for tool in dict.fromkeys(tools):
        at = np.flatnonzero(on_way & np.array([one == tool for one in tools])[part][number])
        if not len(at):
            continue
        mine, counts = np.unique(part[number[at]], return_counts=True)
        ways = [course.parts[i] for i in mine]
        i = number[at]
        arm = axes.layout.arm
        low, high = course.along.q[a[i]][:, arm], course.along.q[a[i] + 1][:, arm]
        near = low + u[at, None] * (high - low)

        def turned(found: Array, near: Array = near) -> Array:
            return np.asarray(found + 2 * np.pi * np.round((near - found) / (2 * np.pi)))

        X_FT, cfx = problem.legs[ways[0].leg].X_FT, np.repeat([one.cfx for one in ways], counts)
        progress = cubic(*course.progress, at)
        yield at, on_ways(axes, X_FT, [one.segment for one in ways], counts.tolist(), cfx, u[at], progress, turned)
