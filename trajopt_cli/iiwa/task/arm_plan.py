"""The best path of the arm angle along a path: far from limits, slow, or with little torque, over the whole path.

First dynamic programming over a grid of stages and arm angles: nothing on that grid is better. Then damped Gauss-Newton
steps over nodes in time, without the grid's steps, with what passes a limit as a penalty; a cubic spline through the
nodes has a continuous second derivative and rests at both ends. Of several smoothings that keep every limit in every
row the strongest is taken that costs hardly more than the cheapest.

Of each objective, as it is added up over time: limits, nearness to position limits and to joint_2 = 0 and joint_6 = 0,
where the least distance from a limit counts first; speed, the squares of joint speeds as shares of their limits;
torque, the squares of the torques that gravity asks for as shares of the sensors' ranges. In limits and torque speeds
count a little, so that the elbow moves only where that helps.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from enum import Enum
from math import pi, radians

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.linalg import solveh_banded

from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.iiwa.task.arm_map import FREE, ArmMap, ArmTask, NoPlan, arm_map, cheapest, margins, stages
from trajopt_cli.iiwa.task.joint_checks import ELBOW, accelerations, central_speeds, passes, speeds
from trajopt_cli.robot.dynamics import Dynamics, ToolLoad
from trajopt_cli.robot.srs_inverse import inverse_branch


class Goal(Enum):
    """What the arm angle is chosen for."""

    LIMITS = "limits"
    SPEED = "speed"
    TORQUE = "torque"


_MOVING = {Goal.LIMITS: 0.1, Goal.SPEED: 1.0, Goal.TORQUE: 0.01}
"""What the squares of speed shares count."""
_GRIDS = ((0.1, 720), (0.2, 360), (0.05, 1440))
"""Stage [s] and cells per turn; the second and the third where the one before fails."""
_STAGES = 40, 400  # at least, so that a short motion can turn; at most, so that a long one ends
_NODE, _NODES = 0.02, (40, 1200)  # s between nodes of the smooth path, how many
_SINGULAR = np.sin(radians(10.0))  # of joint_2 or joint_6 from zero: costs as much as 70 % of a joint's range
_FLOOR = radians(2.0)  # rad from a limit that is kept where the start and the motion let it
_GIVEN = 0.98  # of the best least distance from a limit: what the other stages may be better off for
_TOP_SPEED, _TOP_ACCELERATION = 0.97, 0.93  # shares of limits that the nodes keep, for the rows between them
_SLOWER = (_TOP_SPEED, 0.7, 0.5, 0.35)  # top speeds on the grid, lower where accelerations break their limits otherwise
_SMOOTHING = (10.0, 1.0, 1e-1, 1e-2, 1e-3, 1e-4)  # of the square of the arm angle's acceleration [rad/s2]
_WORTH, _OF_SAVING = 0.01, 0.1  # of the least cost, and of what it saves: what a smoother path may cost more
_WALL_POSITION, _WALL_SPEED, _LOW_WALL = 3000.0, 30.0, 0.1  # penalties' roots, per rad and per share
_STEP = 1e-5  # rad: for differences
_STILL = 0.1  # m/s2 or rad/s2: no step of a speed is less within a period
_ITERATIONS = 60
_TORQUE_ROWS = 4000  # rows that torques are taken from

Report = Callable[[str], None]


@dataclass(frozen=True)
class ArmAngleObjective:
    """What the arm angle is chosen for; load: what the flange carries. progress: told what is worked on."""

    goal: Goal
    load: ToolLoad | None = None
    progress: Report = lambda phase: None


@dataclass(frozen=True)
class ArmFigures:
    """What a path of the arm angle costs, over all its rows; joints by index, joint_4 left out but in torque.

    margin [rad]: least distance from a position limit, of joint near. speed, acceleration: greatest shares of limits,
    of joints fast and abrupt; steady: root of the mean square over time of all joints' speed shares. gravity: greatest
    share of a torque sensor's range that holds the arm, of joint loaded; effort: as steady, of these shares; torque:
    greatest share with the arm's inertia, of joint strained. elbow [m]: how far the elbow moves; turned
    [rad]: the arm angle. passes: every position and speed limit is kept, joint_4's, too.
    """

    margin: float
    near: int
    speed: float
    fast: int
    steady: float
    acceleration: float
    abrupt: int
    gravity: float
    loaded: int
    effort: float
    torque: float
    strained: int
    elbow: float
    turned: float
    passes: bool


@dataclass(frozen=True, eq=False)
class ArmPlan:
    """A path of the arm angle (n,) [rad] with its joints q (n, 7), and how it was found.

    map: the grid it was looked for on. held: why the fixed arm angle is kept after all, "" where it is not. grid_cost:
    of the best path on the grid; cost, fixed_cost: of this one and of the fixed arm angle, all at the grid's stages,
    inf where limits are broken. grid_margin [rad]: least distance from a limit on the grid's path. smoothing: weight
    that was needed. fixed, best: figures of the fixed arm angle and of this one.
    """

    goal: Goal
    arm_angle: Array
    q: Array
    map: ArmMap
    held: str
    grid_cost: float
    cost: float
    fixed_cost: float
    grid_margin: float
    smoothing: float
    fixed: ArmFigures
    best: ArmFigures


def plan_arm(task: ArmTask, fixed: float, objective: ArmAngleObjective, stops: bool = True) -> ArmPlan | NoPlan:
    """The best path of the arm angle along a motion whose poses are all in reach, from the start joints' arm angle on.

    fixed [rad]: the arm angle to compare with, kept where the path found is no better and it keeps the limits. Where it
    does not, the path is no worse for its goal than the one for Goal.LIMITS. stops: whether the arm has to be at rest
    in the last row.
    """
    found = _planned(task, fixed, objective, stops)
    if objective.goal is Goal.LIMITS or (isinstance(found, ArmPlan) and found.fixed.passes):
        return found
    other = _planned(task, fixed, replace(objective, goal=Goal.LIMITS), stops)
    if isinstance(other, NoPlan):
        return found
    cost = _Costs(task, objective, task.joints(fixed), stops).cost(other.q[other.map.rows], other.map.rows)
    other = replace(other, goal=objective.goal, grid_cost=cost, cost=cost)
    if isinstance(found, NoPlan):
        return other

    def rank(plan: ArmPlan) -> tuple[float, float]:
        return max(plan.best.acceleration, 1.0), plan.cost

    return min(found, other, key=rank)


def _planned(task: ArmTask, fixed: float, objective: ArmAngleObjective, stops: bool) -> ArmPlan | NoPlan:
    """As plan_arm, for its goal alone."""
    q_fixed = task.joints(fixed)
    costs = _Costs(task, objective, q_fixed, stops)
    fixed_figures = costs.figures(q_fixed, np.full(len(q_fixed), fixed), stops)
    failure = NoPlan(0, "")
    for stage, cells in _GRIDS:
        count = int(np.clip(np.ceil((len(task.X_WF) - 1) * task.h / stage), *_STAGES))
        rows = stages(len(task.X_WF), count)
        objective.progress(f"map of {len(rows)} x {cells} arm angles")
        chart = arm_map(task, rows, cells)
        fixed_cost = costs.cost(q_fixed[rows], rows) if fixed_figures.passes else np.inf
        found = costs.search(chart, fixed_figures, fixed_cost, stops)
        if isinstance(found, NoPlan) and not fixed_figures.passes:
            failure = found
            continue
        plan = ArmPlan(
            objective.goal, np.full(len(q_fixed), fixed), q_fixed, chart, "", fixed_cost, fixed_cost, fixed_cost,
            fixed_figures.margin, 0.0, fixed_figures, fixed_figures,
        )  # fmt: skip
        if isinstance(found, NoPlan):
            return replace(plan, held=found.message)
        path, grid_cost, grid_margin = found
        plan = replace(plan, grid_cost=grid_cost, grid_margin=grid_margin)
        best = costs.figures(path.q, path.angles, stops)
        if fixed_figures.passes and not costs.better(best, path.cost, fixed_figures, fixed_cost):
            return replace(plan, held="no smooth path is better")
        return replace(plan, arm_angle=path.angles, q=path.q, cost=path.cost, smoothing=path.weight, best=best)
    return failure


@dataclass(frozen=True, eq=False)
class _Smooth:
    """A smooth path that keeps positions and speeds: arm angles (n,), joints (n, 7), worst acceleration's share but for
    rows at which the sequence's own speed steps."""

    angles: Array
    q: Array
    weight: float
    acceleration: float
    cost: float


class _Costs:
    """What a path of the arm angle costs."""

    def __init__(self, task: ArmTask, objective: ArmAngleObjective, q_fixed: Array, stops: bool) -> None:
        """q_fixed (n, 7): joints at the fixed arm angle, which say where the motion accelerates."""
        limits = task.arm.limits
        self.task, self.goal, self.limits, self.progress = task, objective.goal, limits, objective.progress
        self.moving = _MOVING[objective.goal]
        self._dynamics = Dynamics(task.arm.robot, objective.load)
        hard = (accelerations(q_fixed, task.h, stops) / limits.acceleration).max(axis=1)
        self.steps = _steps(task.X_WF, task.h, stops)
        self.hard = np.where(self.steps, 0.0, hard)
        self.middle, self.half = (limits.upper + limits.lower) / 2, (limits.upper - limits.lower) / 2

    def standing(self, q: Array) -> Array:
        """Cost per second (...) of standing at q (..., 7), position limits aside."""
        return np.asarray(np.square(self.points(q)).sum(axis=-1))

    def cost(self, q: Array, rows: IndexArray) -> float:
        """Of joints q (K + 1, 7) at rows, as the grid counts it: stages at their ends, steps by their mean speed."""
        dt = np.diff(rows) * self.task.h
        share = np.diff(q, axis=0) / (self.limits.velocity * dt[:, None])
        return float(dt @ (self.standing(q[1:]) + self.moving * np.square(share).sum(axis=1)))

    def better(self, best: ArmFigures, cost: float, fixed: ArmFigures, fixed_cost: float) -> bool:
        """Whether a path is better than the fixed arm angle: the goal's own measure first, over all rows."""
        if self.goal is Goal.LIMITS and abs(best.margin - fixed.margin) > (1 - _GIVEN) * abs(best.margin):
            return best.margin > fixed.margin
        return cost < fixed_cost

    def search(
        self, chart: ArmMap, fixed: ArmFigures, fixed_cost: float, stops: bool
    ) -> tuple[_Smooth, float, float] | NoPlan:
        """The best smooth path near the best one on a map; the latter's cost and distance from limits.

        Where accelerations break their limits, slower paths on the map are tried; then the one with the least.
        """
        paths: list[_Smooth] = []
        top_fixed = float(self.hard.max())
        grid: tuple[float, float] | None = None
        for top in _SLOWER:
            self.progress("best path on the map" + (f", at {100 * top:.0f} % of the speed limits" if grid else ""))
            found = self.on_grid(chart, top, fixed.margin if fixed.passes else -np.inf)
            if isinstance(found, NoPlan):
                if grid is None:
                    return NoPlan(int(chart.rows[found.row]), found.message)
                break
            cells, floor = found
            q = chart.q[np.arange(len(chart.rows)), cells % len(chart.delta)]
            grid = grid or (self.cost(q, chart.rows), float(margins(q, self.limits).min()))
            self.progress("smooth paths near it")
            paths += self.smooth(chart, cells, floor, top, stops)
            if not paths and not fixed.passes:  # accelerations stop no loop: those of a motion at speed may be hopeless
                paths += self.smooth(chart, cells, floor, top, stops, _LOW_WALL)
            quiet = [one for one in paths if one.acceleration <= 1]
            if quiet:
                least = min(one.cost for one in quiet)
                most = least + min(_WORTH * least, _OF_SAVING * max(fixed_cost - least, 0.0))
                return next(one for one in quiet if one.cost <= most), *grid
            if fixed.passes and any(one.acceleration <= top_fixed for one in paths):
                break
        calmest = min(paths, key=lambda one: one.acceleration, default=None)
        if grid is None or calmest is None or (fixed.passes and calmest.acceleration > top_fixed):
            return NoPlan(0, "no smooth path near the best on the grid keeps the limits")
        return calmest, *grid

    def on_grid(self, chart: ArmMap, top: float, least: float) -> tuple[IndexArray, float] | NoPlan:
        """Cells of the best path on a map, and the distance from limits [rad] that it keeps.

        top: share of speed limits, joint_4's left out, which no arm angle changes. least: distance from limits [rad]
        that is not given away again.
        """
        dt = np.diff(chart.rows) * self.task.h
        reserve = margins(chart.q, self.limits)
        floor = min(_FLOOR, max(float(reserve[0, 0]), 0.0))

        def inside(q: Array) -> Array:
            margin = margins(q, self.limits)
            return np.where(margin < 0, np.inf, -margin)

        def fast(share: Array) -> BoolArray:
            return np.asarray(np.maximum(share[:ELBOW].max(axis=0), share[ELBOW + 1 :].max(axis=0)) > top)

        def slow(share: Array) -> Array:
            return np.where(fast(share), np.inf, -np.inf)

        def drive(share: Array) -> Array:
            return np.where(fast(share), np.inf, self.moving * np.square(share).sum(axis=0))

        def best(floor: float) -> IndexArray | NoPlan:
            def hold(q: Array) -> Array:
                return np.where(margins(q, self.limits) < floor, np.inf, self.standing(q))

            return cheapest(iter(chart.q), dt, self.limits, chart.cell, hold, drive)

        if self.goal is not Goal.LIMITS:
            found = best(floor)
            if not isinstance(found, NoPlan):
                return found, floor  # else the distance that is kept may be what closes every path
        widest = cheapest(iter(chart.q), dt, self.limits, chart.cell, inside, slow, np.maximum)
        if isinstance(widest, NoPlan):
            return widest
        most = float(reserve[np.arange(len(widest)), widest % len(chart.delta)].min())
        floor = max(_GIVEN * most, min(most, least)) if self.goal is Goal.LIMITS else _GIVEN * most
        found = best(floor)
        return found if isinstance(found, NoPlan) else (found, floor)

    def smooth(
        self, chart: ArmMap, cells: IndexArray, floor: float, top: float, stops: bool, wall: float = 10.0
    ) -> Iterator[_Smooth]:
        """Smooth paths near cells that keep positions and speeds in every row, the smoothest first. wall: root of what
        accelerations beyond their limits cost, per share."""
        task, h, n = self.task, self.task.h, len(self.task.X_WF)
        nodes = stages(n, int(np.clip(np.ceil((n - 1) * h / _NODE), *_NODES)))
        t = np.asarray(nodes * h, dtype=np.float64)
        grid = np.asarray(np.interp(nodes, chart.rows, chart.delta[0] + chart.cell * cells), dtype=np.float64)
        delta = grid
        for weight in _SMOOTHING:
            fit = _Fit(self, nodes, floor, top, weight, wall)
            begins = [grid] if delta is grid else [grid, delta]
            _, delta = min((fit.solve(begin) for begin in begins), key=lambda one: one[0])
            angles = np.asarray(CubicSpline(t, delta, bc_type=((1, 0.0), (1, 0.0)))(np.arange(n) * h))
            q = task.joints(angles)
            if passes(q, h, self.limits):
                shares = (accelerations(q, h, stops) / self.limits.acceleration)[:, FREE].max(axis=1)
                worst = float(shares[~self.steps].max(initial=0.0))
                yield _Smooth(angles, q, weight, worst, self.cost(q[chart.rows], chart.rows))

    def figures(self, q: Array, angles: Array, stops: bool) -> ArmFigures:
        """Of joints (n, 7) at arm angles (n,)."""
        task, limits, h = self.task, self.limits, self.task.h
        margin = np.minimum(limits.upper - q, q - limits.lower).min(axis=0)[FREE]
        shares = speeds(q, h) / limits.velocity
        abrupt = (accelerations(q, h, stops) / limits.acceleration).max(axis=0)[FREE]
        rows = stages(len(q), _TORQUE_ROWS)
        held = self._dynamics.gravity_torque(q[rows])
        qdd = np.zeros_like(q)
        qdd[1:-1] = np.diff(q, n=2, axis=0) / (h * h)
        moved = self._dynamics.torque(q[rows], central_speeds(q, h)[rows], qdd[rows])
        gravity, torque = (np.abs(tau / task.arm.robot.torque).max(axis=0) for tau in (held, moved))
        elbow = task.arm.robot.axes_and_points(q)[2][:, 3]
        return ArmFigures(
            margin=float(margin.min()),
            near=FREE[int(np.argmin(margin))],
            speed=float(shares[:, FREE].max()),
            fast=FREE[int(np.argmax(shares[:, FREE].max(axis=0)))],
            steady=float(np.sqrt(np.square(shares).sum(axis=1).mean())),
            acceleration=float(abrupt.max()),
            abrupt=FREE[int(np.argmax(abrupt))],
            gravity=float(gravity.max()),
            loaded=int(np.argmax(gravity)),
            effort=float(np.sqrt(np.square(held / task.arm.robot.torque).sum(axis=1).mean())),
            torque=float(torque.max()),
            strained=int(np.argmax(torque)),
            elbow=float(np.linalg.norm(np.diff(elbow, axis=1), axis=0).sum()),
            turned=float(np.abs(np.diff(angles)).sum()),
            passes=passes(q, h, limits),
        )

    def points(self, q: Array) -> Array:
        """What is squared and added up where the arm stands: (..., m) of joints q (..., 7)."""
        if self.goal is Goal.SPEED:
            return np.zeros((*q.shape[:-1], 1))
        if self.goal is Goal.TORQUE:
            tau = self._dynamics.gravity_torque(q.reshape(-1, q.shape[-1])).reshape(q.shape)
            return np.asarray(tau / self.task.arm.robot.torque)
        used = np.clip(((q - self.middle) / self.half)[..., FREE], -0.999, 0.999)
        sines = np.sin(q[..., [1, 5]])
        sines = np.copysign(np.maximum(np.abs(sines), 1e-3), sines)
        return np.concatenate([used / np.sqrt(1 - used * used), _SINGULAR / sines], axis=-1)


class _Fit:
    """Least squares over the arm angles of nodes: each term's residuals touch one node or up to three in a row."""

    def __init__(self, costs: _Costs, nodes: IndexArray, floor: float, top: float, weight: float, wall: float) -> None:
        self._costs, self._task, self._floor, self._weight, self._top = costs, costs.task, floor, weight, top
        self._wall = wall
        X_WF, t = costs.task.X_WF, np.asarray(nodes * costs.task.h, dtype=np.float64)
        # around each inner node the row at which the motion accelerates most, with its neighbours
        borders = (nodes[1:] + nodes[:-1] + 1) // 2
        pairs = zip(borders[:-1].tolist(), borders[1:].tolist(), strict=True)
        rows = np.array([first + int(np.argmax(costs.hard[first:end])) for first, end in pairs], dtype=np.intp)
        rows = np.clip(rows, 1, len(X_WF) - 2)
        self._X = np.concatenate([X_WF[nodes], *(X_WF[rows + k] for k in (-1, 0, 1))])
        self._dt = np.diff(t)
        ends = np.concatenate([self._dt[:1], self._dt, self._dt[-1:]])  # as if mirrored: the path rests there
        self._w = (ends[:-1] + ends[1:]) / 2
        self._before, self._after = 1 / (ends[:-1] * self._w), 1 / (ends[1:] * self._w)

    def solve(self, delta: Array) -> tuple[float, Array]:
        """Sum of squares and arm angles (K + 1,) after damped Gauss-Newton from delta, whose first value stays."""
        damping, (merit, bands, gradient) = 1e-3, self._at(delta)
        for _ in range(_ITERATIONS):
            system = bands.copy()
            system[2] *= 1 + damping
            system[2] += 1e-9
            step = np.concatenate([[0.0], -solveh_banded(system[:, 1:], gradient[1:])])
            step *= min(1.0, radians(10.0) / max(float(np.abs(step).max()), 1e-12))
            tried = self._at(delta + step)
            if tried[0] < merit:
                gained = merit - tried[0]
                delta, (merit, bands, gradient) = delta + step, tried
                damping = max(damping / 5, 1e-9)
                if gained < 1e-7 * merit:
                    break
            else:
                damping *= 8
                if damping > 1e8:
                    break
        return merit, delta

    def _at(self, delta: Array) -> tuple[float, Array, Array]:
        """Sum of squares, the normal matrix' upper bands (3, K + 1), half the gradient (K + 1,)."""
        task, limits, costs = self._task, self._task.arm.limits, self._costs
        b, a = self._before[1:-1], self._after[1:-1]
        rate = (delta[2:] - delta[:-2]) / (self._dt[1:] + self._dt[:-1])
        bend = b * delta[:-2] - (a + b) * delta[1:-1] + a * delta[2:]
        # around the hardest rows the arm angle goes as it does at the node
        around = (delta[1:-1] + k * task.h * rate + k * k * task.h**2 / 2 * bend for k in (-1, 0, 1))
        # at each place the arm angle there, a little more and a little less, all in one inverse
        angles = np.concatenate([delta, *around]) + np.array([[0.0], [_STEP], [-_STEP]])
        every = inverse_branch(task.arm.robot, self._X, angles, task.arm.definition, task.arm.configuration)
        q, up, down = every[:, : len(delta)]
        q, q_d = np.unwrap(q, axis=0), _turn(up - down) / (2 * _STEP)
        normal = _Normal(len(delta))
        root = np.sqrt(self._w)[:, None]
        if costs.goal is not Goal.SPEED:
            slope = (costs.points(q + _STEP * q_d) - costs.points(q - _STEP * q_d)) / (2 * _STEP)
            normal.add(root * costs.points(q), root * slope)
        off = (q - costs.middle)[:, FREE]
        excess = np.maximum(np.abs(off) - (costs.half[FREE] - self._floor), 0.0)
        inward = np.where(excess > 0, np.sign(off), 0.0) * q_d[:, FREE]
        normal.add(_WALL_POSITION * root * excess, _WALL_POSITION * root * inward)

        share = np.diff(q, axis=0) / (limits.velocity * self._dt[:, None])
        per = q_d[:-1] / (limits.velocity * self._dt[:, None]), q_d[1:] / (limits.velocity * self._dt[:, None])
        root_dt = np.sqrt(self._dt)[:, None]
        scale = np.sqrt(costs.moving) * root_dt
        normal.add(scale * share, -scale * per[0], scale * per[1])
        fast = np.where(np.abs(share) > self._top, np.sign(share), 0.0)
        scale = _WALL_SPEED * root_dt
        normal.add(scale * np.maximum(np.abs(share) - self._top, 0.0), -scale * fast * per[0], scale * fast * per[1])

        self._bends(normal, delta, q, q_d, every[:, len(delta) :].reshape(3, 3, -1, every.shape[2]))
        return normal.merit, normal.bands, normal.gradient

    def _bends(self, normal: _Normal, delta: Array, q: Array, q_d: Array, around: Array) -> None:
        """Add what accelerations cost: the joints' beyond their limits, the arm angle's everywhere.

        around (3, 3, K - 1, 7): joints as they are, more and less, each of three rows near the hardest at each node.
        """
        h, top = self._task.h, self._task.arm.limits.acceleration
        root, calm = np.sqrt(self._w)[:, None], np.sqrt(self._weight * self._w)[:, None]
        b, a = self._before[1:-1, None], self._after[1:-1, None]
        inner, second = slice(1, -1), (b, -(a + b), a)
        span = (self._dt[1:] + self._dt[:-1])[:, None]
        first = (-1 / span, 0 / span, 1 / span)
        bend = b * delta[:-2, None] - (a + b) * delta[inner, None] + a * delta[2:, None]
        normal.add(calm[inner] * bend, *(calm[inner] * w for w in second))
        q_3, slope = around[0], _turn(around[1] - around[2]) / (2 * _STEP)
        hard = (_turn(q_3[2] - q_3[1]) - _turn(q_3[1] - q_3[0])) / (h * h * top)
        over = np.maximum(np.abs(hard) - _TOP_ACCELERATION, 0.0)
        wall = self._wall * root[inner] * np.where(over > 0, np.sign(hard), 0.0) / top
        by_rate, by_bend = (slope[2] - slope[0]) / h, slope[1]
        by_angle = (slope[2] - 2 * slope[1] + slope[0]) / (h * h)
        slopes = [wall * (by_rate * v + by_bend * w) for v, w in zip(first, second, strict=True)]
        slopes[1] = slopes[1] + wall * by_angle
        normal.add(self._wall * root[inner] * over, *slopes)
        for k in (0, len(delta) - 2):  # from rest and to rest: as if the motion were mirrored there
            end = slice(0, 1) if k == 0 else slice(-1, None)
            lead = (self._before + self._after)[end, None] * (1.0 if k == 0 else -1.0)
            normal.add(calm[end] * lead * (delta[k + 1] - delta[k]), -calm[end] * lead, calm[end] * lead, first=k)
            bent = lead * (q[k + 1] - q[k]) / top
            if self._costs.steps[0 if k == 0 else -1]:  # the motion is at speed there: what the arm angle adds
                bent = lead * q_d[k] * (delta[k + 1] - delta[k]) / top
            over = np.maximum(np.abs(bent) - _TOP_ACCELERATION, 0.0)
            wall = self._wall * root[end] * np.where(over > 0, np.sign(bent), 0.0) * lead / top
            normal.add(self._wall * root[end] * over, -wall * q_d[k], wall * q_d[k + 1], first=k)


def _steps(X_WF: Array, h: float, stops: bool) -> BoolArray:
    """Rows (n,) at which the speed of flange poses X_WF (n, 4, 4) steps, and those beside them.

    No arm angle keeps accelerations there: profile thesis begins and ends its segments at full speed.
    """
    a = np.linalg.norm(accelerations(X_WF[:, :3].reshape(len(X_WF), 12), h, stops), axis=1)
    aside = np.pad(a, 3)
    spikes = a > 4 * np.maximum(aside[:-6], aside[6:]) + _STILL
    return np.convolve(spikes, np.ones(5), mode="full")[2:-2] > 0


def _turn(angles: Array) -> Array:
    """Angles [rad] without whole turns."""
    return np.asarray(np.remainder(angles + pi, 2 * pi) - pi)


class _Normal:
    """A sum of squares of residuals that touch neighbours, as banded normal equations."""

    def __init__(self, count: int) -> None:
        self.merit, self.bands, self.gradient = 0.0, np.zeros((3, count)), np.zeros(count)

    def add(self, residual: Array, *slopes: Array, first: int = 0) -> None:
        """Residuals (n, m) with derivatives (n, m) by each node they touch; row 0 touches first and the next."""
        n = len(residual)
        self.merit += float(np.square(residual).sum())
        for i, one in enumerate(slopes, start=first):
            self.gradient[i : i + n] += (one * residual).sum(axis=1)
            for j, other in enumerate(slopes[i - first :]):
                self.bands[2 - j, i + j : i + j + n] += (one * other).sum(axis=1)
