"""The dense check of candidate motions against every limit, finer than any grid.

Converged is not feasible: between the nodes of a grid a limit may be passed by tenths of a percent. So each leg is
sampled densely, and its ratios to the limits are told by interval.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from itertools import groupby

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.problem.problem import Leg
from trajopt_cli.settings import (
    ALONG_LOOKS,
    BRIEF,
    CHECKED,
    DENSE,
    LOOK,
    MOST_LOOKS,
    NEAR_LOOK,
    STILL_TOOL,
    UNREACHED,
)
from trajopt_cli.trajectories.axes import Axes, AxisLimits
from trajopt_cli.trajectories.leg_trajectories import LegMotion, Sample, sampled


@dataclass(frozen=True, eq=False)
class Ratios:
    """Worst ratio to each limit per interval (N,) of a leg: velocity, acceleration, position (N, n), tool (N, 3); jerk
    (N, n), zero where it is free; torque (N, n), too, of what gravity leaves (see torque.py)."""

    velocity: Array
    acceleration: Array
    position: Array
    tool: Array
    jerk: Array
    torque: Array

    @property
    def worst(self) -> float:
        """The largest of all."""
        return float(max(np.max(getattr(self, one.name)) for one in fields(self)))

    def at(self, intervals: IndexArray | BoolArray) -> Ratios:
        """Those of some of the intervals."""
        return Ratios(*(getattr(self, one.name)[intervals] for one in fields(self)))

    def put(self, intervals: IndexArray, others: Ratios) -> None:
        """Others in some of the intervals, in place."""
        for one in fields(self):
            getattr(self, one.name)[intervals] = getattr(others, one.name)


def check_leg(axes: Axes, leg: Leg, motion: LegMotion) -> Ratios:
    """Sample every interval of a leg, both ends included from inside, and compare with the true limits."""
    return check_legs(axes, [leg], [motion])[0]


def check_legs(axes: Axes, legs: Sequence[Leg], motions: Sequence[LegMotion]) -> list[Ratios]:
    """The same for many legs."""
    out: list[Ratios] = []
    looks = [_looks(motion, ALONG_LOOKS if leg.along else 1) for leg, motion in zip(legs, motions, strict=True)]
    behind = np.cumsum([len(t) for t, _ in looks])
    for _, group in groupby(range(len(legs)), key=lambda i: int(behind[i]) // CHECKED):
        at = [*group]
        out += _checked(axes, [legs[i] for i in at], [motions[i] for i in at], [looks[i] for i in at])
    return out


def _looks(motion: LegMotion, times: int) -> tuple[Array, IndexArray]:
    """When a leg is looked at, so many times as often as others, and the number of its first look in each interval
    (N,)."""
    breaks = motion.breaks()
    steps = np.diff(breaks)
    most = int(np.clip(np.max(steps) / LOOK, DENSE, MOST_LOOKS))
    looks = np.clip(np.ceil(steps / NEAR_LOOK).astype(int), BRIEF, most) * times
    starts = np.concatenate([[0], np.cumsum(looks + 2)])
    inside = np.arange(starts[-1]) - np.repeat(starts[:-1], looks + 2) - 0.5
    u = np.clip(inside / np.repeat(looks, looks + 2), 1e-9, 1 - 1e-9)
    return np.repeat(breaks[:-1], looks + 2) + np.repeat(steps, looks + 2) * u, starts[:-1]


def _checked(
    axes: Axes, legs: Sequence[Leg], motions: Sequence[LegMotion], looks: Sequence[tuple[Array, IndexArray]]
) -> list[Ratios]:
    counts = [len(t) for t, _ in looks]
    edges = np.concatenate([[0], np.cumsum(counts)])
    sample = sampled(axes, motions, [t for t, _ in looks])
    number = np.repeat(np.arange(len(legs)), counts)
    first = np.concatenate([edge + starts for edge, (_, starts) in zip(edges, looks, strict=False)])
    found = ratios_of(axes, legs, number, sample, first)
    intervals = np.cumsum([len(starts) for _, starts in looks])[:-1]
    every = [np.split(getattr(found, one.name), intervals) for one in fields(Ratios)]
    return [Ratios(*of_leg) for of_leg in zip(*every, strict=True)]


def ratios_of(axes: Axes, legs: Sequence[Leg], number: IndexArray, sample: Sample, first: IndexArray) -> Ratios:
    """Worst ratios in intervals of a sample of legs, to which numbers (m,) its places belong. first (N,): the place
    with which each interval begins."""
    caps = axes.caps(legs).at(number)
    middle, half = (axes.upper + axes.lower) / 2, np.maximum((axes.upper - axes.lower) / 2, 1e-9)

    def fold(x: Array) -> Array:
        return np.asarray(np.maximum.reduceat(np.where(np.isnan(x), UNREACHED, x), first))

    return Ratios(
        fold(np.abs(sample.qd) / caps.velocity),
        fold(np.abs(sample.qdd) / caps.acceleration),
        fold(_with_couplings(axes, sample.q, np.abs(sample.q - middle) / half)),
        fold(tool_ratios(caps, tool_of(axes, [leg.X_FT for leg in legs], number, sample))),
        np.zeros((len(first), axes.n)) if axes.jerk is None else fold(_jerk_ratios(axes.jerk, sample, first)),
        np.zeros((len(first), axes.n))
        if axes.torque is None
        else fold(axes.torque.ratios(legs, number, sample.q, sample.qd, sample.qdd)),
    )


def _with_couplings(axes: Axes, q: Array, ratios: Array) -> Array:
    """Ratios (m, n) of axes (m, n) to their ranges; where a sum of some is beyond its own, those have its ratio."""
    if axes.couplings:
        of_sums = axes.couplings.ratios(q)
        for row, ratio in zip(axes.couplings.rows, of_sums.T, strict=True):
            ratios = np.where((row != 0) & (ratio > 1.0)[:, None], np.maximum(ratios, ratio[:, None]), ratios)
    return ratios


def _jerk_ratios(limits: Array, sample: Sample, first: IndexArray) -> Array:
    """Mean jerks (m, n) from each place of a sample to the next in the same interval, as shares of limits (n,). first:
    the place with which each interval begins."""
    out = np.zeros_like(sample.qdd)
    inside = np.setdiff1d(np.arange(len(out) - 1), first - 1)
    steps = (sample.t[inside + 1] - sample.t[inside])[:, None]
    out[inside] = np.abs(sample.qdd[inside + 1] - sample.qdd[inside]) / steps / limits
    return out


def tool_of(axes: Axes, X_FT: Sequence[Array], number: IndexArray, sample: Sample) -> Array:
    """The tool's twist and its rate (m, 2, 6) at every place of a sample, where tool X_FT[number] is meant."""
    tool = np.full((len(sample.t), 2, 6), np.nan) if sample.tool is None else sample.tool.copy()
    names = [X.tobytes() for X in X_FT]
    unknown = np.isnan(tool[:, 0, 0])
    for name in dict.fromkeys(names) if unknown.any() else ():
        at = np.flatnonzero(unknown & np.array([one == name for one in names])[number])
        moves = axes.differential(sample.q[at], X_FT[names.index(name)])
        tool[at] = moves.motion(sample.qd[at], sample.qdd[at])
    return tool


def tool_ratios(caps: AxisLimits, tool: Array) -> Array:
    """TCP speed, acceleration (whole, or along the path where that is the larger share) and reorientation (m, 3) as
    shares of the caps, of the tool's twist and its rate (m, 2, 6)."""
    speed, acceleration, turning = (np.linalg.norm(x, axis=1) for x in (tool[:, 0, :3], tool[:, 1, :3], tool[:, 0, 3:]))
    used = acceleration / caps.a_tcp
    if caps.along:
        along = np.sum(tool[:, 0, :3] * tool[:, 1, :3], axis=1) / np.maximum(speed, STILL_TOOL)
        used = np.maximum(used, np.max(along[:, None] * [1, -1] / caps.ramps, axis=1))
    return np.column_stack([speed / caps.v_tcp, used, turning / caps.v_ori])
