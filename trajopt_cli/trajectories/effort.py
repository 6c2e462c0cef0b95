"""How hard a motion drives its axes, and what makes one of two motions the better one."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.problem.objective import LeastEffort
from trajopt_cli.problem.problem import Problem
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.leg_trajectories import LegMotion, Sample, sampled

_GAUSS = 4  # places of the quadrature of an effort between two breaks; exact for polynomials of the seventh degree.

_PLACES, _WEIGHTS = (x / 2 for x in np.polynomial.legendre.leggauss(_GAUSS))


def efforts(axes: Axes, motions: Sequence[LegMotion | None]) -> Array:
    """The effort (L,) [s] of each motion: see problem.objective; exact where axes move by polynomials of time."""
    sample, weights, leg = _sampled(axes, motions)
    squares = np.sum((sample.qdd / axes.acceleration) ** 2, axis=1)
    return np.bincount(leg, weights * squares, len(motions)).astype(float)


def rail_way(axes: Axes, motions: Sequence[LegMotion | None]) -> float:
    """How far the rail goes in all [m], to and fro; 0 without one."""
    sample, weights, _ = _sampled(axes, motions)
    return float(np.sum(weights[:, None] * np.abs(sample.qd[:, axes.layout.rail])))


def cost(axes: Axes, problem: Problem, motions: Sequence[LegMotion | None]) -> float:
    """What the problem's objective wants little of [s]: the time of some of its legs, or their effort."""
    if isinstance(problem.objective, LeastEffort):
        return float(efforts(axes, motions).sum())
    return float(sum(motion.T for motion in motions if motion is not None))


def _sampled(axes: Axes, motions: Sequence[LegMotion | None]) -> tuple[Sample, Array, Array]:
    """All motions at the places of a quadrature between their breaks: weights (m,) [s], numbers of their legs (m,)."""
    moving = [(i, motion) for i, motion in enumerate(motions) if motion is not None and not motion.resting().all()]
    times, weights = [], []
    for _, motion in moving:
        breaks = motion.breaks()
        steps = np.diff(breaks)[:, None]
        times.append(((breaks[:-1] + breaks[1:])[:, None] / 2 + steps * _PLACES).ravel())
        weights.append((steps * _WEIGHTS).ravel())
    if not moving:
        return Sample(np.zeros(0), *np.zeros((3, 0, axes.n))), np.zeros(0), np.zeros(0, dtype=np.intp)
    leg = np.repeat([i for i, _ in moving], [len(t) for t in times])
    return sampled(axes, [motion for _, motion in moving], times), np.concatenate(weights), leg
