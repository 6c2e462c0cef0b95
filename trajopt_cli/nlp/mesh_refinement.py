"""From a route through the waypoints to a clean plan: nested grids, then the exchange loop."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from copy import deepcopy
from dataclasses import dataclass, replace
from time import perf_counter
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.nlp.clearances import Clearances
from trajopt_cli.nlp.constraint_tightening import back_off
from trajopt_cli.nlp.extract_solution import read
from trajopt_cli.nlp.formulation import Formulation
from trajopt_cli.nlp.interior_point import NlpResult
from trajopt_cli.nlp.transcription import Transcription, coordinates
from trajopt_cli.problem.objective import LeastEffort
from trajopt_cli.problem.problem import Leg, LegKind, Problem
from trajopt_cli.problem.stop_condition import Patience, Stopped
from trajopt_cli.settings import DEFAULT
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.clearance_queries import ClearanceQueries
from trajopt_cli.trajectories.dense_check import Ratios, check_legs
from trajopt_cli.trajectories.iterate import Iterate, Margins
from trajopt_cli.trajectories.leg_trajectories import JointNodes, JointProfiles, LegMotion, PathLeg, integrate, parabola
from trajopt_cli.trajectories.profiles import hold

_EVEN = 1e-9  # share of a path by which intervals differ by rounding.
_LEAST_RATE = 1e-09  # of a share's rate by scaled time.
_RAMPS = 0.45  # share of a path's changes that its first zone and its last have each.
_RATE_LOOKS = 401  # at a motion for which a grid is made, besides its breaks.
_MOST_SLOWED = 3.0  # times; what passes limits by more is no motion to begin with.
_SLOWED = 1.002  # times as long as it must be a motion is made for another grid to begin with.
_ARRIVES = 1e-06  # rad or m by which a profile may miss its end: rounding.


@dataclass(frozen=True)
class Grids:
    """Intervals of a path and of a joint move on the last grid."""

    path: int
    joints: int

    @classmethod
    def of(cls, problem: Problem) -> Grids:
        """Fine for a short program, coarse for a long one, whose time grows with its length."""
        settings = problem.plant.settings
        if len(problem.legs) <= settings.short_program:
            return cls(settings.fine_path_grid, settings.fine_joint_grid)
        return LONG if len(problem.legs) <= settings.few_legs else LONGER

    def on(self, leg: Leg) -> int:
        """Of a path: a corner is short."""
        corner = leg.segment is not None and leg.segment.is_corner
        return max(DEFAULT.first_grid, self.path // 4) if corner else self.path

    @property
    def rough(self) -> Grids:
        """Fine enough to tell which of several starts leads farthest."""
        return Grids(min(self.path, DEFAULT.ranking_grid), min(self.joints, DEFAULT.joint_grid))


LONG = Grids(DEFAULT.last_grid, DEFAULT.joint_grid)
LONGER = LONG.rough


def first_iterate(
    axes: Axes, problem: Problem, q: Array, qd: Array, cfx: tuple[int, ...], times: Array, grids: Grids = LONG,
    capped: frozenset[int] = frozenset(),
) -> Iterate:  # fmt: skip
    """Rest-to-rest parabolas between axes q with velocities qd (M, n) at the waypoints, on their branches; times (M-1,)
    of the legs, zero where nothing is to be done. capped: joint moves known to meet a tool cap or a range."""
    settings = axes.settings
    legs: list[LegMotion | None] = []
    for k, leg in enumerate(problem.legs):
        T = leg.duration or max(float(times[k]), settings.least_start_time, leg.least)
        if leg.duration is None and times[k] == 0.0:
            legs.append(hold(0.0, q[k]))
        elif leg.kind is LegKind.JOINT and _on_grids(axes, problem):
            legs.append(_smooth(T, q[k : k + 2], qd[k : k + 2], grids.joints))
        elif leg.kind is LegKind.JOINT and k in capped:
            legs.append(_smooth(T, q[k : k + 2], qd[k : k + 2], settings.first_joint_grid))
        elif leg.kind is LegKind.JOINT:
            legs.append(JointProfiles(T, q[k], qd[k], np.zeros((axes.n, 4)), np.zeros((axes.n, 3))))  # T is a guess
        elif leg.kind is LegKind.DWELL and not leg.rail_moves:
            legs.append(hold(leg.duration or 0.0, q[k]))
        else:
            s, v, a = parabola(np.linspace(0, 1, settings.first_grid + 1))
            start, end = (coordinates(axes, leg, problem.waypoints[i], q[i], qd[i]) for i in (k, k + 1))
            d, w, b = (np.outer(x, end - start) for x in (s, v, a))
            d += start
            legs.append(_path(axes, problem, k, T, q[k], cfx[k] if cfx[k] >= 0 else cfx[k + 1], (s, v, a, d, w, b)))
    return Iterate(q, qd, cfx, tuple(legs))


def on_grid(axes: Axes, problem: Problem, iterate: Iterate, grids: Grids = LONG) -> Iterate:
    """The motion on these grids, as near as its nodes come."""
    legs: list[LegMotion | None] = []
    for k, (leg, motion) in enumerate(zip(problem.legs, iterate.legs, strict=True)):
        N = grids.on(leg)
        if isinstance(motion, PathLeg) and leg.turn is not None:
            motion = motion.turning(leg.turn.axis)
        q, at_hand = iterate.q[k], isinstance(motion, PathLeg) and N == motion.N and _in_zones(motion)
        if motion is None or motion.T == 0.0 or (leg.kind is LegKind.DWELL and not leg.rail_moves):
            legs.append(motion)
        elif leg.kind is LegKind.JOINT:
            if isinstance(motion, JointProfiles) and _on_grids(axes, problem):
                motion = _sampled(axes, motion, _with_switches(axes, leg, motion, grids.joints))
            keep = isinstance(motion, JointProfiles) or (isinstance(motion, JointNodes) and grids.joints == motion.N)
            legs.append(motion if keep else _on_grid(axes, motion, grids.joints))
        elif at_hand:
            legs.append(motion)
        else:
            grid = np.linspace(0, 1, N + 1)
            s, v, a = parabola(grid)
            d = np.tile(
                coordinates(axes, leg, problem.waypoints[k], q, iterate.qd[k]), (N + 1, 1)
            )  # where nothing moves
            nodes = s, v, a, d, np.zeros_like(d), np.zeros_like(d[1:])
            if isinstance(motion, PathLeg):
                grid = _zoned(axes, motion, N)
                at, rate, _ = motion.progress(motion.T * grid, right=True)
                x, v = at, rate * motion.T
                a = np.diff(v, axis=0) / np.diff(grid)[:, None]
                nodes = x[:, 0], v[:, 0], a[:, 0], x[:, 1:], v[:, 1:], a[:, 1:]
            found = _path(axes, problem, k, motion.T, q, max(iterate.cfx[k], iterate.cfx[k + 1]), nodes)
            legs.append(replace(found, grid=grid))
    return Iterate(iterate.q, iterate.qd, iterate.cfx, tuple(legs), iterate.qdd)


def _on_grids(axes: Axes, problem: Problem) -> bool:
    """Whether joint moves have no closed form: where it is not the time that counts, jerk is limited, or the posture
    decides what accelerations may be."""
    return not axes.in_closed_form or isinstance(problem.objective, LeastEffort)


def _smooth(T: float, q: Array, qd: Array, N: int) -> JointNodes:
    """A joint move of T seconds on N intervals between states (2, n) with the least effort there is without limits."""
    grid = np.linspace(0, 1, N + 1)
    nodes, v, _ = integrate(np.array([0.0, 1.0]), q, qd * T, grid)
    return JointNodes(T, grid, nodes, v, np.diff(v, axis=0) * N)


def _on_grid(axes: Axes, motion: LegMotion, N: int) -> JointNodes:
    """A joint move on N intervals, as near as its nodes come: half of them for the time, half for what changes."""
    times = _looks(motion)
    change = _behind(motion.sample(axes, times * motion.T).qd / axes.velocity)
    grid = np.interp(np.linspace(0, 1, N + 1), (times + change) / 2, times)
    return _sampled(axes, motion, grid)


def _in_zones(motion: PathLeg) -> bool:
    """Whether a path's grid has three zones of even intervals."""
    steps = np.diff(motion.grid).reshape(3, -1) if motion.N % 3 == 0 else np.arange(2.0)[None]
    return bool(np.ptp(steps, axis=1).max() < _EVEN)


def _zoned(axes: Axes, motion: PathLeg, N: int) -> Array:
    """A grid of N intervals for a path in three zones of even ones: run-up and run-out are where its rates change."""
    times = _looks(motion)
    rates = motion.progress(motion.T * times, right=True)[1]
    fastest = [max(motion.v.max(), _LEAST_RATE) / motion.T, *axes.velocity[axes.layout.rail]]
    change = _behind(rates / [*fastest, *([] if motion.axis is None else [axes.velocity[axes.layout.arm].max()])])
    begin, end = np.interp([_RAMPS, 1 - _RAMPS], change, times)
    least = axes.settings.least_zone
    edges = [0.0, np.clip(begin, least, 0.5 - least), np.clip(end, 0.5 + least, 1 - least), 1.0]
    return np.interp(np.linspace(0, 3, N + 1), [0, 1, 2, 3], edges)


def _looks(motion: LegMotion) -> Array:
    """Scaled times (m,) at which a motion is looked at: evenly, and at its breaks."""
    return np.unique(np.concatenate([np.linspace(0, 1, _RATE_LOOKS), motion.breaks() / motion.T]))


def _behind(x: Array) -> Array:
    """Share (m,) of all changes of x (m, n) that is behind each row."""
    change = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(x, axis=0), axis=1))])
    return change / change[-1] if change[-1] > 0 else np.linspace(0, 1, len(x))


def _with_switches(axes: Axes, leg: Leg, motion: JointProfiles, N: int) -> Array:
    """A grid of N intervals with nodes where axes switch that use all of their acceleration, so that the motion can be
    on it what it is."""
    settings = axes.settings
    grid = np.linspace(0, 1, N + 1)
    tight = np.abs(motion.accelerations).max(axis=1) > settings.at_limit * axes.acceleration_on(leg)
    moved = np.isin(np.arange(N + 1), (0, N))
    for switch in np.unique(motion.times[tight, 1:3] / motion.T):
        k = int(np.argmin(np.abs(grid - switch)))
        if not moved[k] and np.abs(grid[moved] - switch).min() > 0.5 / N:
            grid[k], moved[k] = switch, True
    return grid


def _sampled(axes: Axes, motion: LegMotion, grid: Array) -> JointNodes:
    sample = motion.sample(axes, grid * motion.T)
    v = sample.qd * motion.T
    return JointNodes(motion.T, grid, sample.q, v, np.diff(v, axis=0) / np.diff(grid)[:, None])


def _path(axes: Axes, problem: Problem, k: int, T: float, q_0: Array, cfx: int, nodes: Sequence[Array]) -> PathLeg:
    """A line, an arc or a wait of T seconds on an even grid. nodes: s, v, a, d, w, b."""
    leg = problem.legs[k]
    grid = np.linspace(0, 1, len(nodes[0]))
    out = PathLeg(T, problem.segment(k), leg.X_FT, cfx, q_0[axes.layout.arm], grid, *nodes)
    return out if leg.turn is None else replace(out, axis=leg.turn.axis)


def slowed(problem: Problem, iterate: Iterate, times: float) -> Iterate:
    """The same motion, so many times as long; waits keep their time, and held ends of a window their velocities."""

    def leg(leg: Leg, motion: LegMotion | None) -> LegMotion | None:
        if motion is None or leg.duration is not None:
            return motion
        return motion.slowed(times)

    held = np.array([point.q is not None for point in problem.waypoints])
    qd = np.where(held[:, None], iterate.qd, iterate.qd / times)
    qdd = None if iterate.qdd is None else np.where(held[:, None], iterate.qdd, iterate.qdd / times**2)
    return replace(
        iterate, qd=qd, qdd=qdd, legs=tuple(leg(*one) for one in zip(problem.legs, iterate.legs, strict=True))
    )


def _halved(motion: LegMotion | None, grows: bool) -> LegMotion | None:
    return motion.refined() if isinstance(motion, PathLeg | JointNodes) and grows else motion


class NotConverged(Exception):
    """The nonlinear program found no clean answer from this start; the message is the solver's word."""


@dataclass(frozen=True, eq=False)
class Stage:
    """An answer on one grid: its iterate, the limits in force, its program and the solver's answer; whether no grid is
    left."""

    iterate: Iterate
    margins: list[Margins | None]
    warm: Sequence[Any]
    ended: bool = False


class MeshRefinement:
    """Solves one problem from an iterate, as long as there is patience. scene: what its motions stay clear of."""

    def __init__(self, axes: Axes, formulation: Formulation, problem: Problem, patience: Patience, grids: Grids = LONG,
        scene: ClearanceQueries | None = None,
    ):  # fmt: skip
        self.axes, self.formulation, self.problem, self.patience = axes, formulation, problem, patience
        self.grids, self.clearances = grids, Clearances(axes, problem, scene)
        self.seconds = {"build": 0.0, "solve": 0.0, "check": 0.0}
        self._known: dict[LegMotion, Ratios] = {}  # of the motions looked at last
        self.solved: tuple[Transcription, NlpResult | None] | None = None
        """The program of the clean iterate and its answer."""

    def _ratios(self, iterate: Iterate, kind: Any = LegMotion) -> list[Ratios | None]:
        """What every leg of an iterate with a motion of some kind uses of its limits at most; None for the others."""
        start = perf_counter()
        legs = [(leg, one) for leg, one in zip(self.problem.legs, iterate.legs, strict=True) if isinstance(one, kind)]
        new = [(leg, motion) for leg, motion in legs if motion not in self._known]
        found = check_legs(self.axes, [leg for leg, _ in new], [motion for _, motion in new])
        known = self._known | {motion: ratios for (_, motion), ratios in zip(new, found, strict=True)}
        self._known = {motion: known[motion] for motion in iterate.legs if motion is not None and motion in known}
        self.seconds["check"] += perf_counter() - start
        return [self._known[motion] if isinstance(motion, kind) else None for motion in iterate.legs]

    def _solve(
        self, iterate: Iterate, margins: list[Margins | None], mu: float, tolerance: float | None = None,
        warm: Sequence[Any] | None = None,
    ) -> tuple[Iterate, Transcription, NlpResult | None]:  # fmt: skip
        """The answer from an iterate; where that goes deep into something that the iterate goes around, with rows about
        the iterate that keep it out."""
        while True:
            found = self._answer(iterate, margins, mu, tolerance or self.axes.settings.tolerance, warm)
            through = self.clearances.through(iterate, found[0])
            if not through:
                return found
            for k in through:
                if isinstance(iterate.legs[k], JointProfiles):
                    margins[k] = Margins.full(self.axes, self.grids.rough.joints, on_path=False)
            iterate, warm = self._with_grids(iterate, margins), None

    def _answer(
        self, iterate: Iterate, margins: list[Margins | None], mu: float, tolerance: float,
        warm: Sequence[Any] | None = None,
    ) -> tuple[Iterate, Transcription, NlpResult | None]:  # fmt: skip
        settings = self.axes.settings
        if self.patience.over:
            raise Stopped
        start = perf_counter()
        tangents = self.clearances.tangents(iterate, margins)
        if warm is not None and tangents.keys() != warm[0].tangents.keys():  # another program
            warm, mu = None, settings.barrier_refined
        t = Transcription(self.axes, self.formulation, self.problem, iterate, margins, tangents)
        if t.nlp.empty:
            return read(t, t.nlp.guess), t, None
        if warm is None:
            t.nlp.build()
        else:
            t.nlp.adopt(warm[0].nlp)
        middle = perf_counter()
        guess = warm[1] if warm else None
        stop = lambda: self.patience.over  # noqa: E731
        result = t.nlp.solve(guess, mu=mu, tolerance=tolerance, most=settings.most_iterations, stop=stop)
        self.seconds["build"] += middle - start
        self.seconds["solve"] += perf_counter() - middle
        try:
            out = read(t, result.x) if result.converged else iterate
        except ValueError as odd:  # a joint move whose switches cannot be told apart in a file
            raise NotConverged(str(odd)) from odd
        if not result.converged and self.patience.over:
            raise Stopped
        if not result.converged:
            raise NotConverged(result.status)
        return out, t, result

    def run(self, iterate: Iterate) -> Iterate:
        """From an iterate on its grid to the clean one of the least time found. Raises NotConverged and Stopped."""
        return self.finished(self.begun(iterate))

    def margins(self, iterate: Iterate) -> list[Margins | None]:
        """Of the legs on grids, nothing tightened."""
        return [
            Margins.full(self.axes, m.N, isinstance(m, PathLeg)) if isinstance(m, PathLeg | JointNodes) else None
            for m in iterate.legs
        ]

    def transcription(self, iterate: Iterate, margins: list[Margins | None]) -> Transcription:
        """The nonlinear program about an iterate."""
        tangents = self.clearances.tangents(iterate, margins)
        return Transcription(self.axes, self.formulation, self.problem, iterate, margins, tangents)

    def begun(self, iterate: Iterate) -> Stage:
        """From an iterate to the answer on its grid. Raises NotConverged and Stopped."""
        margins = self.margins(iterate)
        iterate, warm = self._first(iterate, margins)
        return Stage(iterate, margins, warm)

    def rough(self, stage: Stage) -> Stage:
        """From an answer to one on a grid that tells how far it leads. Raises NotConverged and Stopped."""
        while not stage.ended and self._intervals(stage.iterate, 0) < self.grids.rough.path:
            stage = self._finer(stage)
        return stage

    def finished(self, stage: Stage) -> Iterate:
        """From an answer to the clean iterate with the shortest time found. Raises NotConverged and Stopped."""
        while not stage.ended:
            stage = self._finer(stage)
        return self._exchange(stage.iterate, stage.margins, stage.warm)

    def _grows(self, leg: Leg, motion: LegMotion | None, n: int) -> bool:
        """Whether a motion's grid is halved for the next solve; n: intervals of the paths now."""
        if isinstance(motion, JointNodes):
            return 2 * n >= self.axes.settings.ranking_grid and self.grids.joints > motion.N
        return isinstance(motion, PathLeg) and self.grids.on(leg) > motion.N

    def _intervals(self, iterate: Iterate, default: int) -> int:
        """On the paths of an iterate."""
        return max((m.N for m in iterate.legs if isinstance(m, PathLeg)), default=default)

    def _finer(self, stage: Stage) -> Stage:
        """On the next grid, where there is one, with joint moves on grids that turned out to need one."""
        settings = self.axes.settings
        iterate, margins, last = stage.iterate, [*stage.margins], self.grids.path
        n = self._intervals(iterate, last)
        finer = [self._grows(leg, motion, n) for leg, motion in zip(self.problem.legs, iterate.legs, strict=True)]
        opened = self._open_grids(iterate, margins, self.grids if n >= settings.ranking_grid else self.grids.rough)
        if not (opened or any(finer)):
            return replace(stage, ended=True)
        iterate = self._with_grids(iterate, margins)
        margins = [m.refined() if m and grows else m for m, grows in zip(margins, finer, strict=True)]
        iterate = replace(iterate, legs=tuple(_halved(*one) for one in zip(iterate.legs, finer, strict=True)))
        mu = settings.barrier_rough if n == settings.first_grid else settings.barrier_refined
        tolerance = settings.tolerance if 2 * n >= last else settings.rough_tolerance
        # A motion slowed until it keeps every limit on the finer grid is far from the answer. Measured on nine:
        # from the motion itself 5,868 iterations, from the slowed one 6,970, cycles within 0.008 % of each other.
        for barrier, slow in ((mu, False), (settings.barrier_cold, True)):
            with suppress(NotConverged):
                start = self._slowed(iterate, margins) if slow else iterate
                iterate, *warm = self._solve(start, margins, barrier, tolerance)
                return Stage(iterate, margins, warm)
        # the coarser grid's answer is a motion too; cleaned, it is only a little slower
        return replace(stage, ended=True)

    def again(self, iterate: Iterate, before: Transcription, answer: NlpResult) -> Iterate:
        """From the clean iterate of a program that differs in numbers only, with that program and its answer, to the
        clean iterate with the shortest time found. Raises NotConverged and Stopped."""
        settings = self.axes.settings
        margins = deepcopy([*before.margins])
        try:
            found, *warm = self._solve(iterate, margins, settings.barrier_again, warm=(before, answer))
        except NotConverged:
            found, *warm = self._solve(self._slowed(iterate, margins), margins, settings.barrier_refined)
        return self._exchange(found, margins, warm)

    def tightened(self, iterate: Iterate, legs: Sequence[int], share: float) -> Iterate:
        """From a clean iterate to one that uses at most this share of every limit on some legs.
        Raises NotConverged and Stopped."""
        iterate = on_grid(self.axes, self.problem, iterate, self.grids)
        margins = self.margins(iterate)
        for k in legs:
            motion = iterate.legs[k]
            if isinstance(motion, JointProfiles):
                margins[k] = Margins.full(self.axes, self.grids.joints, on_path=False)
            own = margins[k]
            for margin in own.by_name.values() if own is not None else ():
                margin *= share
        iterate = self._with_grids(iterate, margins)
        found, *warm = self._solve(self._slowed(iterate, margins), margins, self.axes.settings.barrier_refined)
        return self._exchange(found, margins, warm)

    def _first(self, iterate: Iterate, margins: list[Margins | None]) -> tuple[Iterate, list[Any]]:
        """The first solve: a rough one from estimates, a sharp one from an iterate already on the last grid."""
        settings = self.axes.settings
        gridded = any(isinstance(m, JointNodes) for m in iterate.legs)
        n = self._intervals(iterate, self.grids.path if gridded else settings.first_grid)
        mu = settings.barrier_refined if n >= self.grids.rough.path else settings.barrier_first
        tolerance = settings.tolerance if n >= self.grids.path else settings.rough_tolerance
        try:
            out, *warm = self._solve(iterate, margins, mu, tolerance)
        except NotConverged:
            out, *warm = self._solve(iterate, margins, settings.barrier_doubt, tolerance)
        return out, warm

    def _exchange(self, iterate: Iterate, margins: list[Margins | None], warm: Sequence[Any]) -> Iterate:
        """Check densely, back_off where a limit is passed, solve again, until nothing is passed."""
        settings = self.axes.settings
        passed = any(point.passage is not None for point in self.problem.waypoints)
        nearly = settings.barrier_again if passed else settings.barrier_warm
        for _ in range(settings.rounds):
            worst, changed, opened = 0.0, False, self._open_grids(iterate, margins, self.grids)
            iterate = self._with_grids(iterate, margins)
            every = self._ratios(iterate)
            for leg, motion, m, ratios in zip(self.problem.legs, iterate.legs, margins, every, strict=True):
                if motion is None or ratios is None:
                    continue
                worst = max(worst, ratios.worst)
                if m is not None:
                    resting = leg.kind is LegKind.DWELL and leg.duration is not None and self.axes.jerk is None
                    rail = self.axes.acceleration_on(leg)[self.axes.layout.rail] if resting else None
                    changed |= back_off(m, ratios, motion, self.axes.settings, rail)
            changed |= self.clearances.make_room(iterate, margins)
            if not (changed or opened):
                self.solved = warm[0], warm[1]
                return iterate
            if opened:
                iterate, *warm = self._solve(self._slowed(iterate, margins), margins, settings.barrier_refined)
            else:
                try:
                    iterate, *warm = self._solve(iterate, margins, nearly, warm=warm)
                except NotConverged:  # a warm start keeps to the limits it knows; a cold one finds its way round
                    iterate, *warm = self._solve(self._slowed(iterate, margins), margins, settings.barrier_cold)
        raise NotConverged(f"a limit is still passed by {worst - 1:.2e} after {settings.rounds} rounds of tightening")

    def _slowed(self, iterate: Iterate, margins: list[Margins | None]) -> Iterate:
        """The same motion so slow that no limit in force is reached: the solver keeps to them from where it begins."""
        most = 1.0
        for r, m in zip(self._ratios(iterate), margins, strict=True):
            if r is not None and m is not None:
                most = max(most, r.times_slower(m))
        if most > _MOST_SLOWED or most == 1.0:
            return iterate
        return slowed(self.problem, iterate, most * _SLOWED)

    def _open_grids(self, iterate: Iterate, margins: list[Margins | None], grids: Grids) -> bool:
        """Joint moves whose closed-form profiles break a cap, a range or a torque limit, or touch something, go on a
        grid."""
        opened = False
        closed = self._ratios(iterate, JointProfiles)
        for k, (leg, motion, ratios) in enumerate(zip(self.problem.legs, iterate.legs, closed, strict=True)):
            if leg.kind is not LegKind.JOINT or motion is None or ratios is None:
                continue
            if ratios.worst > 1 + self.axes.settings.closed_form_excess or self.clearances.touches(k, motion):
                margins[k] = Margins.full(self.axes, grids.joints, on_path=False)
                opened = True
        return opened

    def _with_grids(self, iterate: Iterate, margins: list[Margins | None]) -> Iterate:
        legs = list(iterate.legs)
        for k, motion in enumerate(legs):
            m = margins[k]
            if isinstance(motion, JointProfiles) and m is not None:
                T, N = motion.T, len(m.tool) - 1
                end = motion.sample(self.axes, np.array([T])).q[0]
                if np.abs(end - iterate.q[k + 1]).max() < _ARRIVES:
                    legs[k] = _on_grid(self.axes, motion, N)
                else:  # the time alone was guessed
                    legs[k] = _smooth(T, iterate.q[k : k + 2], iterate.qd[k : k + 2], N)
        return replace(iterate, legs=tuple(legs))
