"""A run with corners under jerk limits: passed in one go, along corners whose second derivatives go on.

With x the squared rate of the path parameter at the nodes and u half its slope between them, limits on rates and
accelerations are rows in x. A jerk is sqrt(x) (q_s u_s + 3 q_ss u + q_sss x): a row whose right side J / sqrt(x) is
convex, so that its tangent at a law at hand leaves a linear program in which that law is feasible, and every other one
is a legal law. A few such programs, each with the tangents of the answer before, come to a local optimum (Debrouwere
et al., "Time-optimal path following for robots with convex-concave constraints", T-RO 2013; here the objective is a
tangent, too).

The law is then made a cubic B-spline over even times: it stays on the path, and begins and ends at rest without an
acceleration. What that passes of a limit between the nodes is taken back where it does, and the programs begin anew.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy import sparse
from scipy.interpolate import CubicSpline
from scipy.optimize import linprog

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.path.joint_corner import JointCorner
from trajopt_cli.path.segment import JointSegment
from trajopt_cli.path_timing.path_derivatives import PathPart
from trajopt_cli.path_timing.path_timing import PathMargins, in_force, rows_on, stacked, time_optimal_law
from trajopt_cli.path_timing.sampled_path import SampledPath, finer, sample_path
from trajopt_cli.problem.problem import Problem
from trajopt_cli.problem.stop_condition import checkpoint
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.dense_check import check_legs
from trajopt_cli.trajectories.leg_trajectories import JointNodes, LegMotion, PathLeg, Pieces

_NODES = 24  # intervals of a leg. Measured with _STEPS.
# of splines that are tried, of the longest time in which an axis gathers its full acceleration. Measured on three runs
# of two lines and a joint move, z50: 0.12 took 4.494 s, 0.07 4.444, with 40 nodes 4.440; on two lines and a joint move
# without a rail 0.07 took 3.6 % more than 0.12.
_STEPS = (0.07, 0.12)
_ROUNDS = 12  # of taking back what the spline passes
_PROGRAMS = 3  # linear programs in each
_BACK_OFF = 0.7  # power of a ratio by which its place is made slower. Measured: 1.0 the same to 0.3 %.
_PLACES = 8  # looked at in each step of a spline
_KEPT = 1 + 1e-3  # ratio to a limit that is left to slowing the whole run
_BENT = 2e-3  # s between nodes where axes are no cubics of time
_TRUST = (0.4, 3.0)  # times a squared rate that one program may lead to; the tangents end at the second
_PARTS = (1.0, 0.6, 0.3, 0.1)  # of the way to a program's answer that are tried


@dataclass(frozen=True, eq=False)
class SplineLaw:
    """A uniform cubic B-spline over time: step h [s], control points c (n + 3,) of n steps."""

    h: float
    c: Array

    @classmethod
    def smoothed(cls, s: Array, rates: Array, h: float) -> SplineLaw:
        """Of places s (m,) passed at rates (m,), from rest to rest, about the step h."""
        steps = 2 * np.diff(s) / (rates[1:] + rates[:-1])
        steps[[0, -1]] *= 1.5  # accelerations grow from nothing
        t = np.r_[0.0, np.cumsum(steps)]
        n = max(int(np.ceil(t[-1] / h)), 2)
        at = CubicSpline(t, s, bc_type="clamped")(np.linspace(0.0, t[-1], n + 1))
        at = np.maximum.accumulate(np.clip(at, s[0], s[-1]))
        return cls(t[-1] / n, np.r_[2 * [s[0]], at, 2 * [s[-1]]])

    @property
    def n(self) -> int:
        """Steps."""
        return len(self.c) - 3

    @property
    def T(self) -> float:
        """Duration [s]."""
        return self.n * self.h

    def at(self, t: Array) -> Array:
        """The place and its three derivatives (4, m) at times t (m,)."""
        j = np.clip((t / self.h).astype(int), 0, self.n - 1)
        a, b, c, d = (self.c[j + k] for k in range(4))
        u = t - j * self.h
        x, v = (a + 4 * b + c) / 6, (c - a) / (2 * self.h)
        bend, jerk = (a - 2 * b + c) / self.h**2, (d - 3 * c + 3 * b - a) / self.h**3
        x, v = x + u * (v + u * (bend / 2 + u * jerk / 6)), v + u * (bend + u * jerk / 2)
        return np.stack([x, v, bend + u * jerk, jerk])


def passed_smoothly(
    axes: Axes, problem: Problem, run: tuple[int, int], q: Array, cfx: Sequence[int]
) -> dict[int, LegMotion] | None:
    """The motions of a run's legs between axes q (M, n) on branches cfx at all waypoints, by leg, within every limit;
    None where the arm cannot follow or leaves its ranges. A least time of a leg slows the whole run."""
    path = sample_path(axes, problem, run, q, cfx, _NODES)
    law = None if path is None else _Run(axes, problem, path).law()
    if path is None or law is None:
        return None
    legs, pieces = range(*run), dict[int, list[PathLeg | JointNodes]]()
    for i, part in enumerate(path.parts):
        pieces.setdefault(part.leg, []).append(_piece(axes, problem, path, law, i))
    found = {k: Pieces(tuple(pieces[k])) for k in legs}
    ratios = check_legs(axes, [problem.legs[k] for k in legs], [*found.values()])
    if max(one.position.max() for one in ratios) > 1 + 1e-6:
        return None
    slower = max(*(one.times_slower() for one in ratios), *(problem.legs[k].least / found[k].T for k in legs))
    return {k: one.slowed(slower) for k, one in found.items()}


class _Run:
    """What limits ask for along a run's path."""

    def __init__(self, axes: Axes, problem: Problem, path: SampledPath):
        assert axes.jerk is not None
        self._axes, self._problem, self._path = axes, problem, path
        self._jerk = axes.jerk * axes.settings.start_jerk
        self._ramp = float(np.max(axes.acceleration / axes.jerk))
        self._programs()

    def law(self) -> SplineLaw | None:
        """The fastest that was found, as much slower as its worst ratio asks for; None where there is none."""
        path, fine = self._path, self._path
        found = time_optimal_law(self._axes, self._problem, path, PathMargins.full(self._axes, len(path.part)))
        for _ in range(2):
            closer = finer(self._axes, self._problem, fine, np.ones(len(fine.part), dtype=bool))
            if found is None or closer is None:
                return None
            fine = closer
        assert found is not None
        looks = _Looks(self._axes, self._problem, fine)
        # a start: the law without jerk, slow to change
        spline = SplineLaw.smoothed(path.sigma, found.rates, self._ramp / 2)
        start = np.maximum(self._at_nodes(spline)[1], 1e-4 * found.rates.max()) ** 2
        start = self._improved(start, np.ones(len(start)), 3 * _PROGRAMS)
        every = [self._splined(looks, start, share * self._ramp) for share in _STEPS]
        return min(every, key=lambda one: one.T)

    def _splined(self, looks: _Looks, x: Array, h: float) -> SplineLaw:
        """The law of squared rates x (n + 1,) as a spline of about the step h, what it passes taken back."""
        slow, laws = np.ones(len(x)), list[SplineLaw]()
        for turn in range(_ROUNDS):
            checkpoint()
            x = self._improved(x, slow, _PROGRAMS) if turn else x
            spline = SplineLaw.smoothed(self._path.sigma, np.sqrt(x), h)
            t, over = looks.along(spline)
            worst = float(over.max())
            laws.append(SplineLaw(spline.h * worst, spline.c))
            if worst < _KEPT:
                break
            slow *= np.maximum(np.interp(self._at_nodes(spline)[0], t, _dilated(over)), 1.0) ** _BACK_OFF
        return min(laws, key=lambda one: one.T)

    def _at_nodes(self, law: SplineLaw) -> tuple[Array, Array]:
        """When a law is at the nodes, and its rates there."""
        t = np.linspace(0.0, law.T, law.n * _PLACES + 1)
        at = np.interp(self._path.sigma, law.at(t)[0], t)
        return at, law.at(at)[1]

    def _programs(self) -> None:
        """The rows in x (n + 1,), each with its bound and the node it belongs to."""
        path, along = self._path, self._path.along
        D, n, first = np.diff(path.sigma), len(path.part), path.first
        top, *sides = in_force(self._axes, self._problem, path, PathMargins.full(self._axes, n))
        u = sparse.diags_array([-0.5 / D, 0.5 / D], offsets=[0, 1], shape=(n, n + 1)).tocsr()
        rows, bounds, nodes = list[sparse.sparray](), list[Array](), list[IndexArray]()
        for k, (slopes, bends, rests) in enumerate(sides):
            here = sparse.eye_array(n, n + 1, k=k)
            for slope, bend, rest in zip(slopes.T, bends.T, rests.T, strict=True):
                if slope.any() or bend.any():
                    row = sparse.diags_array(slope) @ u + sparse.diags_array(bend) @ here
                    rows += [row, -row]
                    bounds += [1 - rest, 1 + rest]
                    nodes += 2 * [np.arange(n) + k]
        self._pushes = sparse.vstack(rows).tocsr(), np.concatenate(bounds), np.concatenate(nodes)
        both = D[1:] + D[:-1]
        change = sparse.diags_array(2 / both) @ (u[1:] - u[:-1])
        mean = sparse.diags_array(D[:-1] / both) @ u[1:] + sparse.diags_array(D[1:] / both) @ u[:-1]
        here = sparse.eye_array(n - 1, n + 1, k=1)
        third = (along.ddq[first + 1] - along.ddq[first]) / D[:, None]
        jerks = list[sparse.sparray]()
        for row, of in ((first[:-1] + 1, slice(None, -1)), (first[1:], slice(1, None))):
            by_axis = ((x / self._jerk).T for x in (along.dq[row], along.ddq[row], third[of]))
            for dq, ddq, dddq in zip(*by_axis, strict=True):
                one = sparse.diags_array(dq) @ change + sparse.diags_array(3 * ddq) @ mean
                one = one + sparse.diags_array(dddq) @ here
                jerks += [one, -one]
        self._jerks, self._times = sparse.vstack(jerks).tocsr(), len(jerks)
        self._most = np.array(top) ** 2
        for i, d, node in ((1, D[0], first[0]), (n - 1, D[-1], first[-1] + 1)):  # from rest with a jerk alone
            j = float(np.min(self._jerk / np.maximum(np.abs(along.dq[node]), 1e-12)))
            self._most[i] = min(self._most[i], (j / 2) ** 2 * (6 * d / j) ** (4 / 3))

    def _improved(self, x: Array, slow: Array, programs: int) -> Array:
        """A law that takes less time than x (n + 1,), made legal, where limits ask to be slow (n + 1,) times slower."""
        pushes, bounds, nodes = self._pushes
        bounds, most = bounds / slow[nodes] ** 2, np.minimum(self._most / slow**2, 1e9)[1:-1]
        stiff = np.tile(slow[1:-1] ** 3, self._times)
        x = np.r_[0.0, x[1:-1], 0.0]
        jerks = stiff * (self._jerks @ x) * np.tile(np.sqrt(x[1:-1]), self._times)
        worst = max(np.max(pushes @ x / bounds), np.max(x[1:-1] / most), 1e-12) ** 0.5
        x = x / max(worst, float(np.max(jerks, initial=0.0)) ** (1 / 3)) ** 2
        for _ in range(programs):
            inner, rates = x[1:-1], np.sqrt(x)
            tangent = sparse.vstack([sparse.diags_array(0.5 * inner**-1.5)] * self._times)
            of_jerk = sparse.diags_array(stiff) @ self._jerks[:, 1:-1] + tangent
            weight = np.diff(self._path.sigma) / (rates[1:] + rates[:-1]) ** 2
            gain = (weight[1:] + weight[:-1]) / rates[1:-1]
            found = linprog(
                -gain * inner,
                A_ub=sparse.vstack([pushes[:, 1:-1], of_jerk]) @ sparse.diags_array(inner),
                b_ub=np.r_[bounds, np.tile(1.5 / rates[1:-1], self._times)],
                bounds=np.column_stack([np.full_like(inner, _TRUST[0]), np.clip(most / inner, *_TRUST)]),
            )
            if found.x is None:
                break
            way = np.r_[0.0, (found.x - 1) * inner, 0.0]
            answer = min((x + part * way for part in _PARTS), key=self._duration)
            before, after = self._duration(x), self._duration(answer)
            x = answer if after < before else x
            if after * _KEPT > before:
                break
        return x

    def _duration(self, x: Array) -> float:
        rates = np.sqrt(x)
        return float(np.sum(2 * np.diff(self._path.sigma) / (rates[1:] + rates[:-1])))


class _Looks:
    """What a law passes of the limits along a path with nodes closer together."""

    def __init__(self, axes: Axes, problem: Problem, path: SampledPath):
        assert axes.jerk is not None
        self._path, self._jerk, self._rows = path, axes.jerk, stacked(rows_on(axes, problem, path))
        along, first = path.along, path.first
        self._third = (along.ddq[first + 1] - along.ddq[first]) / np.diff(path.sigma)[:, None]

    def along(self, law: SplineLaw) -> tuple[Array, Array]:
        """Times (m,), even ones, and how many times slower the law has to be there; on both sides where parts meet."""
        t = np.linspace(0.0, law.T, law.n * _PLACES + 1)
        x = law.at(t)
        over, joints = self.times_slower(x), self._path.sigma[np.cumsum(self._path.counts)[:-1]]
        at = np.interp(joints, x[0], t)
        near, place = np.rint(at / t[1]).astype(int), law.at(at)
        for side in (-1e-9, 1e-9):
            place[0] = joints + side * self._path.sigma[-1]
            np.maximum.at(over, near, self.times_slower(place))
        return t, over

    def times_slower(self, x: Array) -> Array:
        """How many times slower a law has to be at places with derivatives x (4, m) to keep every limit (m,)."""
        path, s = self._path, x[0]
        i = np.clip(np.searchsorted(path.sigma, s, side="right") - 1, 0, len(path.part) - 1)
        row, u = path.first[i], ((s - path.sigma[i]) / np.diff(path.sigma)[i])[:, None]

        def between(values: Array) -> Array:
            return np.asarray(values[row] * (1 - u) + values[row + 1] * u)

        rows, along, (v, a, j) = self._rows, path.along, x[1:, :, None]
        pushes = between(rows.slopes) * a + between(rows.bends) * v**2 + between(rows.rests)
        jerks = between(along.dq) * j + 3 * between(along.ddq) * v * a + self._third[i] * v**3
        every = (v * between(1 / rows.top), 1), (pushes, 2), (jerks / self._jerk, 3)
        return np.max([np.max(np.abs(one), axis=1, initial=0.0) ** (1 / order) for one, order in every], axis=0)


def _dilated(x: Array) -> Array:
    """The greatest of each value (m,) and those up to a step before and behind it."""
    wide = np.pad(x, _PLACES, mode="edge")
    return np.asarray(np.lib.stride_tricks.sliding_window_view(wide, 2 * _PLACES + 1).max(axis=1))


def _piece(axes: Axes, problem: Problem, path: SampledPath, law: SplineLaw, i: int) -> PathLeg | JointNodes:
    """Part i of a path under a law, in scaled time."""
    part, row = path.parts[i], path.begins[i]
    edges = path.sigma[[row - i, row - i + part.N]]
    t_0, t_1 = (_when(law, x, x == path.sigma[-1]) for x in edges)
    T = t_1 - t_0
    grid = _times(law, t_0, t_1, axes.settings.switches_apart, _curved(part))
    s, v = law.at(grid)[:2]
    u, rate = np.clip((s - edges[0]) / part.size, 0.0, 1.0), v * T / part.size
    u[0], u[-1] = 0.0, 1.0
    tau = (grid - t_0) / T
    tau[0], tau[-1] = 0.0, 1.0
    steps = np.diff(tau)[:, None]
    if isinstance(part.segment, JointSegment):
        own = part.own(u)
        w = part.segment.rate(own) * ((part.s_1 - part.s_0) * rate)[:, None]
        return JointNodes(T, tau, part.segment.axes(own), w, np.diff(w, axis=0) / steps)
    assert part.rail is not None
    d, dd, _ = part.rail.at(u)
    w, own_rate = dd * rate[:, None], (part.s_1 - part.s_0) * rate
    return PathLeg(
        T, part.segment, problem.legs[part.leg].X_FT, part.cfx, path.along.q[row, axes.layout.arm], tau, part.own(u),
        own_rate, np.diff(own_rate) / steps[:, 0], d, w, np.diff(w, axis=0) / steps,
    )  # fmt: skip


def _curved(part: PathPart) -> bool:
    """Whether its axes are no cubics where its share is one."""
    return isinstance(part.segment, JointCorner) or (part.rail is not None and part.rail.bends)


def _times(law: SplineLaw, t_0: float, t_1: float, apart: float, curved: bool) -> Array:
    """When a law has its nodes from t_0 to t_1, and more between them where curved."""
    knots = law.h * np.arange(law.n + 1)
    marks = np.r_[t_0, knots[(knots > t_0 + apart) & (knots < t_1 - apart)], t_1]
    if not curved:
        return marks
    parts = np.maximum(np.ceil(np.diff(marks) / _BENT).astype(int), 1)
    inner = [np.linspace(a, b, n + 1)[:-1] for a, b, n in zip(marks[:-1], marks[1:], parts, strict=True)]
    return np.r_[np.concatenate(inner), t_1]


def _when(law: SplineLaw, place: float, last: bool) -> float:
    """When a law is at a place: at its start and end exactly, else by halving."""
    low, high = 0.0, law.T
    if last or place <= law.c[0]:
        return high if last else low
    while high - low > 1e-14 * law.T:
        middle = (low + high) / 2
        if middle in (low, high):
            break
        low, high = (middle, high) if law.at(np.array([middle]))[0, 0] < place else (low, middle)
    return (low + high) / 2
