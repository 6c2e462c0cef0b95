"""Whether motions that were found touch anything on their way: what is not clear is not taken."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from trajopt_cli.collision.collision_scene import CollisionScene, Hit, collision_scene_of
from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.problem.problem import Problem
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.iterate import Iterate
from trajopt_cli.trajectories.leg_trajectories import sample_times, samples
from trajopt_cli.trajectories.unit_shares import unit_shares, units_of

# s between two places of a motion that is looked at, besides its breaks: at 40 rad/s2 and 0.5 m it leaves the straight
# way between them by 0.06 mm.
_CHECK_STEP = 5e-3


def touching(axes: Axes, problem: Problem, iterate: Iterate) -> tuple[int, ...]:
    """The numbers of the legs whose motion is not clear, in order; none where there is nothing to touch."""
    around = collision_scene_of(problem)
    if around is None:
        return ()
    numbers = [k for k, motion in enumerate(iterate.legs) if motion is not None]
    q, first, last, turns = _sampled(axes, problem, iterate, numbers)
    index = np.array([problem.legs[k].motion for k in numbers])
    free = around.ways_free(q, first, last, index, turns)
    return tuple(k for k, clear in zip(numbers, free, strict=True) if not clear)


def clear(axes: Axes, problem: Problem, iterate: Iterate) -> bool:
    """Whether an iterate touches nothing."""
    return not touching(axes, problem, iterate)


def hit_on(axes: Axes, problem: Problem, iterate: Iterate, k: int) -> Hit | None:
    """The worst that leg k of an iterate touches."""
    around, motion = collision_scene_of(problem), iterate.legs[k]
    if around is None or motion is None:
        return None
    q, _, _, turns = _sampled(axes, problem, iterate, [k])
    return worst(around, q, problem.legs[k].motion, turns)


def worst(around: CollisionScene, q: Array, index: int, turns: Array | None = None) -> Hit | None:
    """The worst that a way through axes q (m, n) touches, on it and between its places."""
    return next(iter(around.hits(_dense(q), index, None if turns is None else _dense(turns))), None)


def names_on(around: CollisionScene, q: Array, index: int) -> tuple[str, ...]:
    """The names of the bodies in a way through axes q (m, n), the deepest first."""
    return tuple(dict.fromkeys(hit.against for hit in around.hits(_dense(q), index)))


def _dense(q: Array) -> Array:
    """A way through axes q (m, n) with places between them."""
    parts = max(2, min(400, int(4000 / len(q))))
    steps = [np.linspace(0, 1, parts)[:-1, None] * (b - a) + a for a, b in pairwise(q)]
    return np.concatenate([*steps, q[-1:]])


def _sampled(
    axes: Axes, problem: Problem, iterate: Iterate, numbers: Sequence[int]
) -> tuple[Array, IndexArray, IndexArray, Array | None]:
    """Places (N, n) along an iterate's legs of these numbers, one after the other, the first and last row of each, and
    how far units have turned there (N, U), None where none turns."""
    settings, motions = axes.settings, [motion for k in numbers if (motion := iterate.legs[k]) is not None]
    # at their breaks, and often enough between them for straight ways in between
    looks = (sample_times(one, _CHECK_STEP, 1, settings.most_samples)[0] for one in motions)
    times = [np.clip(t, 0.0, one.T) for t, one in zip(looks, motions, strict=True)]
    ends = np.cumsum([len(t) for t in times])
    q = np.empty((ends[-1] if len(ends) else 0, axes.n))
    for at, sample in samples(axes, motions, times):
        q[at] = sample.q
    first = ends - [len(t) for t in times]
    many = max([len(units_of(problem, k)) for k in numbers], default=0)
    turns = np.zeros((len(q), many)) if many else None
    for k, motion, t, row in zip(numbers, motions, times, first.tolist(), strict=True):
        if turns is not None and (count := len(units_of(problem, k))):
            turns[row : row + len(t), :count] = unit_shares(problem, k, motion, t)[0]
    return q, first, ends - 1, turns
