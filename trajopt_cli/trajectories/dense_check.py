"""The dense check of candidate motions against every limit, finer than any grid.

Converged is not feasible: between the nodes of a grid a limit may be passed by tenths of a percent. So each leg is
sampled densely, and its ratios to the limits are told by interval.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.problem.problem import Leg
from trajopt_cli.settings import Settings
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.iterate import Margins
from trajopt_cli.trajectories.leg_trajectories import LegMotion, Sample, sampled, shares
from trajopt_cli.trajectories.limits import limits_of
from trajopt_cli.trajectories.limits.limit import Limit, MotionSamples

_SHORT_STEP = 2e-4  # s between two looks in a short interval, which has fewer than `dense_samples` then. Not measured.


@dataclass(frozen=True, eq=False)
class Ratios:
    """The worst ratio to each limit in every interval of a leg: (N, w) by the limit's name, which is an attribute as
    well; zeros (N, 1) of limits that are not in force."""

    limits: tuple[Limit, ...]
    by_name: dict[str, Array]

    def __getattr__(self, name: str) -> Array:
        if name.startswith("_") or name in ("limits", "by_name"):
            raise AttributeError(name)
        found = self.by_name.get(name)
        return np.zeros((self.N, 1)) if found is None else found

    @classmethod
    def none(cls, axes: Axes, N: int) -> Ratios:
        """Of N intervals that nobody sampled."""
        return cls(limits_of(axes), {limit.name: np.zeros((N, len(limit.orders))) for limit in limits_of(axes)})

    @classmethod
    def joined(cls, parts: Sequence[Ratios]) -> Ratios:
        """Of all intervals of parts, in order."""
        names = parts[0].by_name
        return cls(parts[0].limits, {name: np.concatenate([one.by_name[name] for one in parts]) for name in names})

    @property
    def N(self) -> int:
        """Intervals."""
        return len(next(iter(self.by_name.values())))

    @property
    def worst(self) -> float:
        """The largest of all."""
        return float(max(np.max(one) for one in self.by_name.values()))

    def at(self, intervals: IndexArray | BoolArray) -> Ratios:
        """Those of some of the intervals."""
        return Ratios(self.limits, {name: one[intervals] for name, one in self.by_name.items()})

    def put(self, intervals: IndexArray, others: Ratios) -> None:
        """Others in some of the intervals, in place."""
        for name, one in self.by_name.items():
            one[intervals] = others.by_name[name]

    def split(self, edges: IndexArray) -> list[Ratios]:
        """Those of consecutive intervals up to each edge, and from the last one on."""
        parts = np.split(np.arange(self.N), edges)
        return [self.at(part) for part in parts]

    def times_slower(self, margins: Margins | None = None) -> float:
        """How many times as long the motion has to take to keep what is safe of every limit but the ranges, or these
        margins of it; below one where there is time to spare."""
        most = 0.0
        for limit in self.limits:
            timed = limit.orders > 0
            allowed = limit.safe if margins is None else margins.by_name[limit.name].min(axis=0)[timed]
            worst = self.by_name[limit.name].max(axis=0)[timed] / allowed
            most = max(most, float(np.max(worst ** (1 / limit.orders[timed]), initial=0.0)))
        return most


def check_leg(axes: Axes, leg: Leg, motion: LegMotion) -> Ratios:
    """Sample every interval of a leg, both ends included from inside, and compare with the true limits."""
    return check_legs(axes, [leg], [motion])[0]


def check_legs(axes: Axes, legs: Sequence[Leg], motions: Sequence[LegMotion]) -> list[Ratios]:
    """The same for many legs."""
    settings = axes.settings
    out: list[Ratios] = []
    samples = [
        _sample_times(motion, settings.along_path_samples if leg.along else 1, settings)
        for leg, motion in zip(legs, motions, strict=True)
    ]
    behind = np.cumsum([len(t) for t, _ in samples])
    for _, group in groupby(range(len(legs)), key=lambda i: int(behind[i]) // (6 * settings.batch)):
        at = [*group]
        out += _checked(axes, [legs[i] for i in at], [motions[i] for i in at], [samples[i] for i in at])
    return out


def _sample_times(motion: LegMotion, times: int, settings: Settings) -> tuple[Array, IndexArray]:
    """When a leg is looked at, so many times as often as others, and the number of its first look in each interval
    (N,)."""
    breaks = motion.breaks()
    steps = np.diff(breaks)
    most = int(np.clip(np.max(steps) / settings.sample_step, settings.dense_samples, settings.most_samples))
    samples = np.clip(np.ceil(steps / _SHORT_STEP).astype(int), settings.least_samples, most) * times
    starts = np.concatenate([[0], np.cumsum(samples + 2)])
    inside = np.arange(starts[-1]) - np.repeat(starts[:-1], samples + 2) - 0.5
    u = np.clip(inside / np.repeat(samples, samples + 2), 1e-9, 1 - 1e-9)
    return np.repeat(breaks[:-1], samples + 2) + np.repeat(steps, samples + 2) * u, starts[:-1]


def _checked(
    axes: Axes, legs: Sequence[Leg], motions: Sequence[LegMotion], samples: Sequence[tuple[Array, IndexArray]]
) -> list[Ratios]:
    counts = [len(t) for t, _ in samples]
    edges = np.concatenate([[0], np.cumsum(counts)])
    sample = sampled(axes, motions, [t for t, _ in samples])
    number = np.repeat(np.arange(len(legs)), counts)
    first = np.concatenate([edge + starts for edge, (_, starts) in zip(edges, samples, strict=False)])
    intervals = np.cumsum([len(starts) for _, starts in samples])[:-1]
    return ratios_of(axes, legs, number, sample, first, share_rates(legs, motions, [t for t, _ in samples])).split(
        intervals
    )


def share_rates(legs: Sequence[Leg], motions: Sequence[LegMotion], times: Sequence[Array]) -> Array | None:
    """First and second derivative (2, m) of the share of each way at times of its own; None where nothing turns in step
    with it."""
    if not any(leg.units for leg in legs):
        return None
    return np.hstack([shares(*of)[1:] for of in zip(motions, times, strict=True)])


def ratios_of(
    axes: Axes, legs: Sequence[Leg], number: IndexArray, sample: Sample, first: IndexArray, progress: Array | None
) -> Ratios:
    """Worst ratios in intervals of a sample of legs, to which numbers (m,) its places belong. first (N,): the place
    with which each interval begins. progress: see MotionSamples."""
    motion = motion_samples(axes, legs, number, sample, first, progress)

    def fold(x: Array) -> Array:
        return np.asarray(np.maximum.reduceat(np.where(np.isnan(x), Limit.unreached, x), first))

    return Ratios(limits_of(axes), {limit.name: fold(limit.ratios(motion)) for limit in limits_of(axes)})


def motion_samples(
    axes: Axes,
    legs: Sequence[Leg],
    number: IndexArray,
    sample: Sample,
    first: IndexArray,
    progress: Array | None = None,
) -> MotionSamples:
    """What limits are asked with, see MotionSamples."""
    tool = _tool(axes, [leg.X_FT for leg in legs], number, sample)
    return MotionSamples(legs, number, sample, axes.caps(legs).at(number), tool, first, progress)


def _tool(axes: Axes, X_FT: Sequence[Array], number: IndexArray, sample: Sample) -> Array:
    """The tool's twist and its rate (m, 2, 6) at every place of a sample, where tool X_FT[number] is meant."""
    tool = np.full((len(sample.t), 2, 6), np.nan) if sample.tool is None else sample.tool.copy()
    names = [X.tobytes() for X in X_FT]
    unknown = np.isnan(tool[:, 0, 0])
    for name in dict.fromkeys(names) if unknown.any() else ():
        at = np.flatnonzero(unknown & np.array([one == name for one in names])[number])
        moves = axes.differential(sample.q[at], X_FT[names.index(name)])
        tool[at] = moves.motion(sample.qd[at], sample.qdd[at])
    return tool
