"""A legal motion before any nonlinear program: every run of a route timed by TOPP.

The axes of a leg share one progress, as a RAPID controller drives them; so the motion serves both targets.
"""

from __future__ import annotations

from collections.abc import Sequence, Set
from contextlib import suppress
from dataclasses import replace
from hashlib import blake2b
from itertools import groupby

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.path_timing.edge_times import as_programmed, leg_name_at, short
from trajopt_cli.path_timing.path_timing import Unresolved, least_times, time_path
from trajopt_cli.path_timing.sampled_path import sample_paths
from trajopt_cli.path_timing.smooth import smooth
from trajopt_cli.problem.problem import Leg, LegKind, Problem
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.dense_check import check_legs
from trajopt_cli.trajectories.iterate import Iterate
from trajopt_cli.trajectories.leg_trajectories import JointNodes, JointProfiles, LegMotion, PathLeg
from trajopt_cli.trajectories.profiles import hold, profiles
from trajopt_cli.trajectories.route import Route

_SAME = 1e-9  # m between rail positions that are one

Run = tuple[int, int]  # its first waypoint and its last
Runs = dict[bytes, tuple[dict[int, LegMotion], Sequence[Leg]]]  # motions of runs, by leg in the run; its legs


class NotDriven(Exception):
    """A run of a route that no law drives: run, its first waypoint and last. least: the time [s] that a leg would take
    which the program gives less; singular: where the run passes a singularity; None where that is not why."""

    def __init__(self, run: tuple[int, int], least: float | None = None, singular: Unresolved | None = None):
        super().__init__(run)
        self.run, self.least, self.singular = run, least, singular


def timed(axes: Axes, problem: Problem, route: Route, known: Runs | None = None) -> Iterate:
    """Every run timed along its coordinated path, at the route's rail positions and configurations, as fast as all
    limits allow. known: runs of this plant that were timed before; those timed here are added. Raises NotDriven."""
    legs: list[LegMotion | None] = [None] * len(problem.legs)
    cfx = tuple(label.cfx for label in route.labels)
    known = {} if known is None else known
    names = [run_name(problem, run, route.q, cfx) for run in problem.runs]
    asked = {name: run for name, run in zip(names, problem.runs, strict=True) if name not in known}  # equal ones once
    failures = {}
    for (name, run), found in zip(asked.items(), _fastest(axes, problem, [*asked.values()], route.q, cfx), strict=True):
        if isinstance(found, NotDriven):
            failures[name] = found
        else:
            known[name] = {k - run[0]: motion for k, motion in found.items()}, problem.legs[slice(*run)]
    for name, (first, _) in zip(names, problem.runs, strict=True):
        if name in failures:
            raise failures[name]
        for k, motion in known[name][0].items():
            legs[first + k] = motion
    return Iterate(route.q, np.zeros_like(route.q), cfx, tuple(legs))


def run_name(problem: Problem, run: tuple[int, int], q: Array, cfx: Sequence[int]) -> bytes:
    """Equal for runs that are timed alike, between axes q (M, n) on branches cfx at all waypoints."""
    first, last = run
    points = [problem.waypoints[k].fly_by for k in range(first, last + 1)]
    joint = any(leg.kind is LegKind.JOINT for leg in problem.legs[first:last])  # no other leg knows the coupling
    name = repr((cfx[first : last + 1], points, problem.coupling.value if joint else ""))
    parts = [name.encode(), q[first : last + 1].tobytes(), *(leg_name_at(problem, k) for k in range(first, last))]
    return blake2b(b"|".join(parts), digest_size=16).digest()


def _fastest(
    axes: Axes, problem: Problem, runs: Sequence[Run], q: Array, cfx: Sequence[int]
) -> list[dict[int, LegMotion] | NotDriven]:
    """Each run's motions in one go or, where jerk is limited, from stop to stop if that is faster; or why it is not
    driven."""
    cuts = [[run] if axes.jerk is None else [(k, k + 1) for k in range(*run)] for run in runs]
    asked = [*dict.fromkeys(part for run, parts in zip(runs, cuts, strict=True) for part in (run, *parts))]
    timed_runs = dict(zip(asked, _timed_runs(axes, problem, asked, q, cfx), strict=True))
    out: list[dict[int, LegMotion] | NotDriven] = []
    for run, parts in zip(runs, cuts, strict=True):
        found_motions: list[dict[int, LegMotion]] = []
        failures: list[NotDriven] = []
        for tried in [parts, [run]] if parts != [run] else [parts]:
            found = [timed_runs[part] for part in tried]
            failed = [one for one in found if isinstance(one, NotDriven)]
            failures += failed
            if not failed:
                found_motions.append({k: motion for one in found if isinstance(one, dict) for k, motion in one.items()})
        least = min(found_motions, key=lambda one: sum(motion.T for motion in one.values()), default=None)
        out.append(failures[0] if least is None else least)
    return out


def stopped(problem: Problem) -> Problem:
    """The problem with a stop at every fly-by but those between short lines, which no stop at each would resemble;
    itself where there are no others."""
    passing = [short(problem, k) for k in range(len(problem.legs))]
    return _with_stops(problem, {k for k in range(1, len(passing)) if not (passing[k - 1] and passing[k])})


def stopped_at_joint_moves(problem: Problem) -> Problem:
    """The problem with a stop at every fly-by beside a joint move; itself where there is none."""
    joint = [leg.kind is LegKind.JOINT for leg in problem.legs]
    return _with_stops(problem, {k for k in range(1, len(joint)) if joint[k - 1] or joint[k]})


def _with_stops(problem: Problem, at: Set[int]) -> Problem:
    if not any(problem.passes(k) for k in at):
        return problem
    points = (replace(point, fly_by=None) if k in at else point for k, point in enumerate(problem.waypoints))
    return replace(problem, waypoints=tuple(points))


def about(axes: Axes, problem: Problem, runs: Sequence[Run], q: Sequence[Array], cfx: Sequence[int]) -> Array:
    """How long runs (m,) take between stops, each between axes of its own, on a few nodes; a leg with a programmed time
    that, and more where it is late; infinite where they cannot be driven."""
    settings = axes.settings
    names = [(run, own[run[0] : run[1] + 1].tobytes()) for run, own in zip(runs, q, strict=True)]
    distinct = dict(zip(names, zip(runs, q, strict=True), strict=True))
    simple = _simple(axes, problem, [run for run, _ in distinct.values()], [own for _, own in distinct.values()])
    times = {name: np.inf if one is None else one.T for name, one in zip(distinct, simple, strict=True)}
    left = {name: one for name, one in distinct.items() if times[name] == np.inf}
    some, every = [run for run, _ in left.values()], [own for _, own in left.values()]
    paths = dict(
        zip(left, sample_paths(axes, problem, some, every, cfx, [settings.pair_nodes] * len(left)), strict=True)
    )
    can = {name: path for name, path in paths.items() if path is not None}
    times.update(zip(can, least_times(axes, problem, [*can.values()]).tolist(), strict=True))

    alone = {run: problem.legs[run[0]] for run, _ in names if run[1] == run[0] + 1}
    return np.array([as_programmed(alone[run], times[run, q]) if run in alone else times[run, q] for run, q in names])


def _timed_runs(
    axes: Axes, problem: Problem, runs: Sequence[Run], q: Array, cfx: Sequence[int]
) -> list[dict[int, LegMotion] | NotDriven]:
    """The motions of each run in one go, or why there are none."""
    settings = axes.settings
    out: dict[Run, dict[int, LegMotion] | NotDriven] = {}
    motions: dict[Run, PathLeg | JointNodes | JointProfiles | None] = {}  # of legs between two stops
    left = []
    for run, simple in zip(runs, _simple(axes, problem, runs, [q] * len(runs)), strict=True):
        if simple is not None:
            motions[run] = simple
        elif axes.jerk is not None and run[1] == run[0] + 1:
            motions[run] = smooth(axes, problem, run[0], q, cfx)
        elif axes.jerk is not None:
            from trajopt_cli.path_timing.smooth_runs import passed_smoothly  # its linear programs load slowly

            out[run] = passed_smoothly(axes, problem, run, q, cfx) or NotDriven(run)
        else:
            left.append(run)
    nodes = [3 * settings.run_nodes if last == first + 1 else settings.run_nodes for first, last in left]
    size = np.cumsum([N * (last - first) for N, (first, last) in zip(nodes, left, strict=True)])
    for _, group in groupby(range(len(left)), key=lambda i: int(size[i]) // settings.batch):  # their paths are large
        some = [*group]
        asked = [left[i] for i in some]
        paths = sample_paths(axes, problem, asked, [q] * len(some), cfx, [nodes[i] for i in some])
        for i, run in enumerate(asked):
            path, paths[i] = paths[i], None
            try:
                pieces = None if path is None else time_path(axes, problem, path)
            except Unresolved as singular:
                out[run] = NotDriven(run, singular=singular)
                continue
            if pieces is None:
                out[run] = NotDriven(run)
            elif run[1] > run[0] + 1:
                out[run] = dict(pieces)
            else:
                (motions[run],) = pieces[run[0]].pieces  # one leg between stops is one piece
    for run, motion in motions.items():
        T, least = problem.legs[run[0]].duration, problem.legs[run[0]].least
        if motion is None or (T is not None and T * (1 + 1e-9) < motion.T):
            out[run] = NotDriven(run, None if motion is None else motion.T)
        elif T is None and least > motion.T:
            out[run] = {run[0]: motion.slowed(least / motion.T)}
        elif T is None or isinstance(motion, JointProfiles):
            out[run] = {run[0]: motion}
        else:
            out[run] = {run[0]: replace(motion, T=T)}
    return [out[run] for run in runs]


def _simple(axes: Axes, problem: Problem, runs: Sequence[Run], q: Sequence[Array]) -> list[JointProfiles | None]:
    """The motions of runs that need no TOPP: one leg between stops, resting, or with joint profiles that pass no cap of
    the tool; None of others."""
    out: list[JointProfiles | None] = [None] * len(runs)
    tried: dict[int, JointProfiles] = {}
    for i, ((first, last), own) in enumerate(zip(runs, q, strict=True)):
        leg, q_0, q_1 = problem.legs[first], own[first], own[first + 1]
        stays = leg.kind is LegKind.DWELL or (leg.kind is LegKind.JOINT and not axes.in_closed_form)
        if last == first + 1 and stays and np.abs(q_1 - q_0).max() < _SAME:
            out[i] = hold(leg.duration or leg.least, q_0)
        if last > first + 1 or leg.kind is not LegKind.JOINT or not axes.in_closed_form:
            continue
        still, limits = np.zeros_like(q_0), (axes.velocity_on(leg), axes.acceleration_on(leg))
        with suppress(ValueError):  # an axis whose switches a file could not tell apart
            tried[i] = profiles(
                q_0, still, q_1, still, *limits, leg.duration or leg.least, problem.coordinated, axes.settings
            )
    checked = check_legs(axes, [problem.legs[runs[i][0]] for i in tried], [*tried.values()])
    for (i, motion), ratios in zip(tried.items(), checked, strict=True):
        if ratios.worst <= 1 + axes.settings.closed_form_excess:
            out[i] = motion
    return out


def duration(iterate: Iterate) -> float:
    """Cycle time [s] of an iterate."""
    return float(sum(motion.T for motion in iterate.legs if motion is not None))
