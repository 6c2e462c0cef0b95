"""Which limit holds a motion back."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby

import numpy as np

from trajopt_cli.problem.problem import Leg
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.dense_check import motion_samples, share_rates
from trajopt_cli.trajectories.leg_trajectories import LegMotion, sampled
from trajopt_cli.trajectories.limits import limits_of

_STILL = 1e-09  # rad or m: no way to go.
_FEWEST_SAMPLES, _MOST_SAMPLES = 40, 400  # of a motion; between, one per `sample_step`. Not measured.


def binding_limits(axes: Axes, legs: Sequence[Leg], motions: Sequence[LegMotion]) -> list[str]:
    """Of each motion the limit it stands at for the largest fraction of its time, as "joint_1 acceleration" or
    "programmed ..."; "already there" where no axis has to move."""
    settings = axes.settings
    out = [leg.waits_for if leg.least else "programmed duration" for leg in legs]
    asked = [i for i, leg in enumerate(legs) if leg.duration is None]
    counts = [int(np.clip(motions[i].T / settings.sample_step, _FEWEST_SAMPLES, _MOST_SAMPLES)) for i in asked]
    behind = np.cumsum(counts)
    for _, group in groupby(range(len(asked)), key=lambda j: int(behind[j]) // (6 * settings.batch)):
        some = [*group]
        at = [asked[j] for j in some]
        found = _binding(axes, [legs[i] for i in at], [motions[i] for i in at], [counts[j] for j in some])
        for i, name in zip(at, found, strict=True):
            out[i] = legs[i].waits_for if legs[i].least and legs[i].least / settings.at_limit >= motions[i].T else name
    return out


def _binding(axes: Axes, legs: Sequence[Leg], motions: Sequence[LegMotion], counts: Sequence[int]) -> Iterator[str]:
    """The same of so many that the memory takes them at once, each sampled so often; none of a given duration."""
    times = [(np.arange(n) + 0.5) / n * motion.T for n, motion in zip(counts, motions, strict=True)]
    number, sample = np.repeat(np.arange(len(legs)), counts), sampled(axes, motions, times)
    first = (np.cumsum(counts) - counts).astype(np.intp)
    progress = share_rates(legs, motions, times)
    asked = motion_samples(axes, legs, number, sample, first, progress)
    ratios = np.hstack([limit.used(asked) for limit in limits_of(axes)])
    for leg, rows in zip(legs, np.split(np.arange(len(number)), first[1:]), strict=True):
        if np.all(np.ptp(sample.q[rows], axis=0) < _STILL) and (progress is None or not progress[:, rows].any()):
            yield "already there"
            continue
        names = [name for limit in limits_of(axes) for name in limit.labels(leg)]
        often = np.mean(ratios[rows] >= axes.settings.at_limit, axis=0)
        best = int(np.argmax(often)) if np.any(often > 0) else int(np.argmax(np.max(ratios[rows], axis=0)))
        yield names[best]
