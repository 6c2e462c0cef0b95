"""Rows `ruckig` and `ruckig jerk`: what a good engineer does with a point-to-point library and an inverse kinematics.

Rail positions and configurations are the fixed-rail plan's. Joint moves: all axes from rest to rest, together, at full
limits; where the TCP would pass a cap, the move's limits are scaled down until it does not. Lines: one axis along the
line at one speed and one acceleration (and jerk), the best that all axes and the TCP allow everywhere on it. Runs with
corners, and arcs: one axis along the path, with a speed and an acceleration for each of its parts.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.motion import motion_name
from trajopt_cli.problem.plan import Infeasible
from trajopt_cli.study.along_path import SmoothPath, timed_by_parts
from trajopt_cli.study.case import Answer, Case, NotApplicable
from trajopt_cli.study.fixed_rail import BaselineLeg, StopToStop, Use, caps_of, fixed_rail, use_of
from trajopt_cli.study.rows import LONGER, SAFE, Piece, apart, attempt_of, each_once, hold
from trajopt_cli.timing.point_to_point import PointToPoint, point_to_point
from trajopt_cli.trajectories.axes import Axes, AxisLimits

STEP = 2e-3  # s between samples of a joint move; all its switches are sampled from both sides besides
_HALVINGS = 12  # of a bisection: scales good to 2e-4
_LINE_SAMPLES = 250  # of a profile
_PLACES = 401  # of a line's table
_SPEEDS = (1.0, 0.95, 0.9, 0.85, 0.8, 0.7, 0.6, 0.45, 0.3)  # shares of a line's top speed that are tried
_JERKS = (1.0, 0.8, 0.6, 0.4)  # shares of the jerk at a line's ends that are tried
_FLOOR = 1e-4  # the least scale that a search tries
_ATTEMPTS = 250  # so that a move is lengthened by a millisecond at most
_BESIDE = 1e-9  # s from a switch: its other side


def ruckig(case: Case) -> Answer:
    """The program timed with Ruckig, jerk free unless its limits bind. Infeasible where a programmed time is too short
    for it."""
    return _row(case, case.plant.limits.binding_jerk)


def ruckig_jerk(case: Case) -> Answer:
    """The program timed with Ruckig under the profile's jerk limits; NotApplicable where it gives none."""
    if case.plant.limits.binding_jerk is not None:
        return NotApplicable("the jerk limits bind every row")
    if case.plant.limits.jerk is None:
        return NotApplicable("the robot's profile gives no jerk limits")
    return _row(case, np.asarray(case.plant.limits.jerk))


def _row(case: Case, jerk: Array | None) -> Answer:
    given = fixed_rail(case)
    if isinstance(given, Infeasible):
        return given
    pieces = each_once(given.runs, partial(_piece, given.axes, jerk))
    notes = ["under the jerk limits that bind every row"] if case.plant.limits.jerk_binds else []
    notes.append("rail positions and configurations are the fixed-rail plan's; one speed and acceleration per line")
    if case.plant.limits.table is not None:
        notes.append("of accelerations by posture the least, which every posture allows")
    if any(run.by_parts for run in given.runs):
        notes.append("corners and arcs: one profile along the path, with a speed and an acceleration for each part")
        if jerk is not None:
            notes.append("jerk is free where a corner or an arc begins or ends: the path's curvature jumps there")
    return attempt_of(case, given, pieces, notes)


def _drive(v_0: float, v_1: float, way: float, v: float, a: float, j: float | None) -> Piece:
    speed, acceleration, begin, end = (np.array([x]) for x in (v, a, v_0, v_1))
    jerk = None if j is None else np.array([j])
    motion = point_to_point(np.zeros(1), np.array([way]), speed, acceleration, jerk, v_0=begin, v_1=end)
    return Piece(motion.duration, motion.switches, lambda t: (motion.at(t)[0][:, 0], motion.at(t)[1][:, 0]))


def _piece(axes: Axes, jerk: Array | None, run: StopToStop) -> Piece | Infeasible:
    leg = run.legs[0]
    if run.by_parts:
        return timed_by_parts(axes, run, caps_of(axes, run), jerk, _drive, "Ruckig")
    if leg.holds:
        return hold(leg.q_0, leg.lasts)
    motion = _joint_move(axes, run, jerk) if run.path is None else _on_line(axes, run, jerk)
    if leg.duration is not None:
        if (no := leg.too_short("Ruckig", motion.duration)) is not None:
            return no
        motion = motion.slowed(leg.duration / motion.duration)
    if run.path is None:
        return Piece(motion.duration, motion.switches, lambda t: motion.at(t)[:2])
    path = SmoothPath.of(run)

    def at(t: Array) -> tuple[Array, Array]:
        s, rate, _ = motion.at(t)
        return path.axes_at(s[:, 0] * path.sigma[-1], rate[:, 0] * path.sigma[-1])

    return Piece(motion.duration, motion.switches, at)


@dataclass(frozen=True, eq=False)
class _JointMove:
    """A joint move with its limits scaled; straight: along the straight line in the joints."""

    axes: Axes
    run: StopToStop
    jerk: Array | None
    straight: bool

    @property
    def leg(self) -> BaselineLeg:
        """The move."""
        return self.run.legs[0]

    @cached_property
    def caps(self) -> AxisLimits:
        """What is in force on it."""
        return caps_of(self.axes, self.run)

    def made(self, v: float, a: float) -> PointToPoint:
        """Ruckig's motion at shares v of the speeds and a of accelerations and jerks; a hair longer where switches of
        two axes would stand too near for rows of their own."""
        speed, acceleration = self.caps.velocity[0] * v, self.caps.acceleration[0] * a
        jerk = None if self.jerk is None else self.jerk * a
        ends = self.leg.q_0, self.leg.q_1
        move = point_to_point(*ends, speed, acceleration, jerk, straight=self.straight)
        fastest = move.duration
        for attempt in range(1, _ATTEMPTS):
            if apart(move.switches):
                break
            move = point_to_point(*ends, speed, acceleration, jerk, fastest + attempt * LONGER, self.straight)
        return move

    def use(self, move: PointToPoint) -> Use:
        """Use of the limits over the whole move, both sides of every switch included."""
        t = np.linspace(0.0, move.duration, int(np.ceil(move.duration / STEP)) + 2)
        t = np.concatenate([t, _beside(move)])
        return use_of(self.axes, self.run.legs, self.caps, np.zeros(len(t), dtype=np.intp), *move.at(t))

    def slow(self, v: float) -> bool:
        """Whether the TCP's speeds hold with the axes' speeds at share v."""
        return float(self.use(self.made(v, 1.0)).tcp_speed.max()) <= SAFE

    def soft(self, v: float, a: float) -> bool:
        """Whether all the TCP's caps hold at shares v and a."""
        use = self.use(self.made(v, a))
        return max(float(use.tcp_speed.max()), float(use.tcp_acceleration.max())) <= SAFE

    def candidates(self) -> list[PointToPoint]:
        """The move at full limits where the TCP's caps hold; else slowed down as a whole, and with speeds scaled until
        its speeds hold and then accelerations until its acceleration does."""
        full = self.made(1.0, 1.0)
        if self.soft(1.0, 1.0):
            return [full]
        out = [full.slowed(max(1.0, self.use(full).slowing / SAFE))]
        v = _largest(self.slow)
        a = None if v is None else _largest(partial(self.soft, v))
        if v is not None and a is not None:
            out.append(self.made(v, a))
        return out


def _joint_move(axes: Axes, run: StopToStop, jerk: Array | None) -> PointToPoint:
    """The shortest of the candidates, axes on their own or straight."""
    moves = [move for straight in (False, True) for move in _JointMove(axes, run, jerk, straight).candidates()]
    return min([move for move in moves if apart(move.switches)] or moves, key=lambda move: move.duration)


def _beside(motion: PointToPoint) -> Array:
    """Times just before and just after every switch."""
    return np.clip(motion.switches[:, None] + [-_BESIDE, _BESIDE], 0.0, motion.duration).ravel()


def _largest(fits: Callable[[float], bool]) -> float | None:
    """The largest scale up to 1 that fits, by bisection from the first halving that does; None where none does."""
    if fits(1.0):
        return 1.0
    low, high = 0.5, 1.0
    while not fits(low):
        low, high = low / 2, low
        if low < _FLOOR:
            return None
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if fits(middle) else (low, middle)
    return low


def _on_line(axes: Axes, run: StopToStop, jerk: Array | None) -> PointToPoint:
    """The shortest profile of the share s: for every speed of a short list (and jerk), the largest acceleration."""
    path, leg, caps = SmoothPath.of(run), run.legs[0], caps_of(axes, run)
    L, at = path.sigma[-1], path.places(np.linspace(0.0, path.sigma[-1], _PLACES))
    slopes, bends, twists = (path.at(*at, order) * L**order for order in (1, 2, 3))
    speed, acceleration = caps.velocity[0], caps.acceleration[0]
    way, turn = max(leg.leg.chord, 1e-12), max(leg.leg.angle, 1e-12)
    steepest = np.maximum(np.abs(slopes), 1e-12)
    top_v = min(float(np.min(speed / steepest)), leg.leg.v_tcp / way, leg.leg.v_ori / turn) * SAFE
    a_tcp = min(leg.leg.a_tcp, *leg.leg.ramps)
    top_a = min(float(np.min(acceleration / steepest[[0, -1]])), a_tcp / way) * SAFE
    top_j = None if jerk is None else float(np.min(jerk / steepest[[0, -1]])) * SAFE
    table = np.concatenate([slopes, bends, twists], axis=1)
    k = slopes.shape[1]

    def made(v: float, a: float, j: float | None) -> PointToPoint:
        return point_to_point(
            np.zeros(1), np.ones(1), np.array([v]), np.array([a]), None if j is None else np.array([j])
        )

    def fits(v: float, a: float, j: float | None) -> bool:
        motion = made(v, a, j)
        t = np.concatenate([np.linspace(0.0, motion.duration, _LINE_SAMPLES), _beside(motion)])
        s, s_1, s_2 = motion.at(t)
        place = np.clip(s[:, 0], 0.0, 1.0) * (_PLACES - 1)
        i = np.minimum(place.astype(np.intp), _PLACES - 2)
        share = (place - i)[:, None]
        first, second, third = np.split(table[i] * (1 - share) + table[i + 1] * share, [k, 2 * k], axis=1)
        good = bool(np.all(np.abs(first * s_2 + second * s_1**2) <= acceleration * SAFE))
        if jerk is not None and j is not None:
            jerks = third * s_1**3 + 3 * second * s_1 * s_2 + first * motion.jerks(t)
            good = good and bool(np.all(np.abs(jerks) <= jerk * SAFE))
        return good

    best: tuple[float, float, float | None] | None = None
    shortest = np.inf
    for share_j in _JERKS if top_j is not None else (1.0,):
        j = None if top_j is None else top_j * share_j
        for share_v in _SPEEDS:
            v = top_v * share_v
            if 1 / v >= shortest:
                break
            if made(v, top_a, j).duration >= shortest:  # less acceleration takes no less
                continue
            a = _largest(lambda share, v=v, j=j: fits(v, top_a * share, j))  # type: ignore[misc]
            if a is None:
                continue
            duration = made(v, top_a * a, j).duration
            if duration < shortest:
                best, shortest = (v, top_a * a, j), duration
    if best is None:
        name = f"{leg.motion.source}: {motion_name(leg.motion)}"
        raise ValueError(f"ruckig: {name} finds no speed under all limits, although the fixed-rail plan has one")
    v, a, j = best
    for attempt in range(_ATTEMPTS):
        # a hair slower and, more so, softer: no phase of the profile gets shorter by that
        motion = made(v * (1 - 1e-3 * attempt), a * (1 - 1.7e-3 * attempt), j)
        if apart(motion.switches):
            break
    return motion
