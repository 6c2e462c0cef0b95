"""Joint moves by added points as one leg each: axes that go each for itself need no points to go around something.

The motion at hand stays what it is, node by node. From it the nonlinear program finds its own way around.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.problem.detours import Detour, Numbering
from trajopt_cli.problem.problem import Problem
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.iterate import Iterate
from trajopt_cli.trajectories.leg_trajectories import JointNodes, JointProfiles, LegMotion, Pieces, Sample

_APART = 1e-9  # share of a motion's time: breaks nearer than this are one up to rounding


def merge_via_points(
    axes: Axes, problem: Problem, iterate: Iterate, detours: Sequence[Detour]
) -> tuple[Problem, Iterate]:
    """The problem without the waypoints that detours added, and the same motion; those given where none is left out.
    Points stay where the joint move does not lead from stop to stop."""
    points = _points(problem, detours)
    ends = [k for k in range(len(problem.waypoints)) if k not in points]
    kept: list[int] = []
    for first, last in pairwise(ends):
        of_joints = all(isinstance(one, JointNodes | JointProfiles) for one in _parts(iterate.legs[first:last]))
        alone = of_joints and not (problem.passes(first) or problem.passes(last))
        kept += [first, *(() if alone else range(first + 1, last))]
    kept.append(ends[-1])
    new = {k: i for i, k in enumerate(kept)}
    if len(kept) == len(problem.waypoints):
        return problem, iterate
    own = replace(
        problem,
        waypoints=tuple(problem.waypoints[k] for k in kept),
        legs=tuple(replace(problem.legs[last - 1], start=i) for i, last in enumerate(kept[1:])),
        stations=tuple((new[first], new[last]) for first, last in problem.stations if first in new),
        ties=tuple(tuple(new[k] for k in group) for group in problem.ties),
    )
    legs = tuple(_concatenated(axes, iterate.legs[first:last]) for first, last in pairwise(kept))
    qdd = None if iterate.qdd is None else iterate.qdd[kept]
    return own, Iterate(iterate.q[kept], iterate.qd[kept], tuple(iterate.cfx[k] for k in kept), legs, qdd)


def detours_left(problem: Problem, detours: Sequence[Detour]) -> tuple[Detour, ...]:
    """Those detours by whose points the problem still leads."""
    numbering = _numbering(problem, detours)
    left = {numbering.own(problem.waypoints[k].motion) for k in _points(problem, detours)}
    return tuple(detour for detour in detours if detour.motion in left)


def _points(problem: Problem, detours: Sequence[Detour]) -> set[int]:
    """The waypoints that detours added. A program may have points of an earlier plan, which are its own."""
    numbering = _numbering(problem, detours)
    return {k for k, point in enumerate(problem.waypoints) if point.motion >= 0 and numbering.is_point(point.motion)}


def _numbering(problem: Problem, detours: Sequence[Detour]) -> Numbering:
    added = sum(len(detour.points) for detour in detours)
    return Numbering(len(problem.program.motions) - added, detours)


def _parts(motions: Sequence[LegMotion | None]) -> Iterator[LegMotion]:
    for motion in motions:
        if isinstance(motion, Pieces):
            yield from motion.pieces
        elif motion is not None:
            yield motion


def _concatenated(axes: Axes, motions: Sequence[LegMotion | None]) -> LegMotion | None:
    """Motions one after the other as one: exact, for between breaks an axis moves by cubics in all of them."""
    if len(motions) == 1:
        return motions[0]
    times, samples, now = list[Array](), list[Sample](), 0.0
    for part in _parts(motions):
        breaks = np.unique(part.breaks())
        apart = np.diff(breaks, append=part.T) > _APART * part.T  # the next one begins with the last
        times.append(now + breaks[apart])
        samples.append(part.sample(axes, breaks[apart]))
        now += part.T
        end = part.sample(axes, np.array([part.T]))
    grid = np.append(np.concatenate(times) / now, 1.0)
    q, qd = (np.concatenate([*(getattr(one, name) for one in (*samples, end))]) for name in ("q", "qd"))
    return JointNodes(now, grid, q, qd * now, np.diff(qd * now, axis=0) / np.diff(grid)[:, None])
