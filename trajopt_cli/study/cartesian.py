"""Row `bang-bang`: the thesis' generator as a plan (Krotký 2014, 3.1 and 5.1), whatever the joints make of it.

Every Cartesian axis of the TCP, seen from the carriage, runs on its own at the tool's caps, 20 m/s2 and 2.5 m/s each;
the orientation turns by slerp under the programmed reorientation speed, reached as soon as an axis reaches its own; the
rail is one more axis. All axes of a move start together and arrive together: in the least time that all of them can
take, the faster ones cruising more slowly, so the arm waits for the rail or the rail for the arm without standing.
Lines keep their path and their programmed speed, as the thesis does in its functional areas; for other moves it takes
the axes' limits. At a point without a wait an axis keeps speed v if it goes on the same way, v^2 <= a D for the ways D
of both moves: so each can still come to rest on its way, and no time a slower axis needs is out of reach. Into and out
of a line it keeps what runs along the line, if every axis of it goes on. Else, and where the program waits, it stops.

A run with corners, or an arc, is the generator's one axis along the path that the plan drives: from part to part of
it from speed to speed, each at a speed and an acceleration that keep the tool's caps and the rail's limits everywhere
on it. The thesis has no corners; these are the ones every other row drives.

Rail positions at the points and the arm's configuration are the fixed-rail plan's. The joints' motion is the inverse
kinematics of all that. Joint limits play no part in it: as a rule the result is not legal.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from itertools import groupby, pairwise

import numpy as np

from trajopt_cli.geometry import Array, inverse_pose, pose, rotation_about
from trajopt_cli.motion import SignalEvent, Wait
from trajopt_cli.path.line import Line
from trajopt_cli.problem.plan import Infeasible
from trajopt_cli.problem.plant import Plant
from trajopt_cli.study.along_path import SmoothPath, timed_by_parts
from trajopt_cli.study.case import Answer, Case, NotApplicable
from trajopt_cli.study.fixed_rail import BaselineLeg, StopToStop, caps_of, fixed_rail
from trajopt_cli.study.rows import LONGER, Piece, apart, attempt_of, hold
from trajopt_cli.timing.point_to_point import PointToPoint, bang_bang
from trajopt_cli.trajectories.axes import Axes, AxisLimits

_STEP = 1e-3  # s between places where the motion is sampled before it is accepted
_POINT = 1e-9  # m, rad: no way at all
_SAME = 1e-6  # rad: the arm arrives in the configuration of the plan
_ATTEMPTS = 250  # so that a move is lengthened by a millisecond at most


def bang_bang_row(case: Case) -> Answer:
    """The program by the thesis' generator. Infeasible where the Cartesian motion leaves the workspace or would have to
    change the configuration on its way, where a programmed time is too short, or where there is no fixed-rail plan."""
    if case.plant.layout.r > 1:
        return NotApplicable("the robot rides several rails")
    given = fixed_rail(case)
    if isinstance(given, Infeasible):
        return given
    pieces = list[Piece | Infeasible]()
    for by_parts, some in groupby(given.runs, key=lambda run: run.by_parts):
        group = [*some]
        if by_parts:
            pieces += [
                timed_by_parts(given.axes, run, _caps(case.plant, given.axes, run), None, _drive, "the generator")
                for run in group
            ]
            continue
        moves = [_move(case.plant, run) for run in group]
        speeds = _speeds(moves)
        pieces += [_piece(case.plant, *one) for one in zip(moves, speeds, speeds[1:], strict=False)]
    caps = case.plant.tcp
    notes = (
        f"each Cartesian axis by itself at {caps.acceleration:g} m/s² and {caps.speed:g} m/s; joint limits are ignored",
        "points without a wait are passed at speed where the way goes on",
        *(("corners and arcs: one profile along the path",) if any(run.by_parts for run in given.runs) else ()),
    )
    return attempt_of(case, given, pieces, notes)


@dataclass(frozen=True, eq=False)
class _Move:
    """A leg as the generator sees it. way (m,): displacement of its axes; v_max, a_max (m,): their limits.

    Joint moves: x, y, z of the TCP seen from the carriage [m], the turn [rad], the rail [m]. Lines: one axis, the
    length [m] (or turn [rad]) along the line. Holds: none. X_0 (4, 4): the TCP at the begin as if the rail stood at 0.
    along (3,): the line's direction, None for other moves and for lines that turn only or carry the rail along.
    """

    run: StopToStop
    X_0: Array
    turn_axis: Array
    way: Array
    v_max: Array
    a_max: Array
    along: Array | None = None

    @property
    def leg(self) -> BaselineLeg:
        """The leg."""
        return self.run.legs[0]


def _move(plant: Plant, run: StopToStop) -> _Move:
    leg = run.legs[0]
    seen = Line(*(_from_carriage(plant, q) @ leg.X_FT for q in (leg.q_0, leg.q_1)))
    caps, motion = plant.tcp, leg.motion
    if leg.holds or isinstance(motion, Wait | SignalEvent):
        return _Move(run, seen.X_0, seen.axis, np.zeros(0), np.zeros(0), np.zeros(0))
    turning = motion.speed.turning
    softly = turning * (caps.acceleration / caps.speed)
    layout, limits, rail = plant.layout, plant.limits, plant.layout.has_rail
    way_rail = float(layout.place(leg.q_1 - leg.q_0))
    v_rail, a_rail = (float(layout.place(top)) if rail else 1.0 for top in (limits.velocity, limits.acceleration))
    if not leg.on_line:
        way = np.r_[seen.chord, seen.angle, way_rail]
        way[np.abs(way) < _POINT] = 0.0
        v, a = np.r_[[caps.speed] * 3, turning, v_rail], np.r_[[caps.acceleration] * 3, softly, a_rail]
        return _Move(run, seen.X_0, seen.axis, way, v, a)
    line = Line(*(plant.robot.forward(q) @ leg.X_FT for q in (leg.q_0, leg.q_1)))
    length = line.length if line.length > _POINT else max(line.angle, abs(way_rail))
    steepest = float(np.abs(line.chord).max()) / length
    # the speed and acceleration of each that goes along, and how far it goes
    along = [(leg.leg.v_tcp, np.inf, line.length), (caps.speed, caps.acceleration, steepest * length),
             (turning, softly, line.angle), (v_rail, a_rail, abs(way_rail))]  # fmt: skip
    tops = [(v * length / way, a * length / way) for v, a, way in along if way > _POINT]
    v_max, a_max = np.min(tops, axis=0)
    plain = line.length > _POINT and abs(way_rail) <= _POINT
    direction = line.chord / length if plain else None
    return _Move(run, seen.X_0, seen.axis, np.array([length]), np.array([v_max]), np.array([a_max]), direction)


def _from_carriage(plant: Plant, q: Array) -> Array:
    """Flange pose (4, 4) as if the rail stood at 0."""
    layout = plant.robot.layout
    return plant.robot.forward(layout.join(0.0, q[layout.arm]))


def _speeds(moves: Sequence[_Move]) -> list[tuple[Array, Array]]:
    """At every point the speeds with which the move before it ends and the one after it begins, in each move's own
    axes; element k + 1 belongs to the point after move k."""
    none = np.zeros(0)
    out = [(none, np.zeros(len(moves[0].way)) if moves else none)]
    for before, after in pairwise(moves):
        out.append(_through(before, after))
    out.append((np.zeros(len(moves[-1].way)) if moves else none, none))
    return out


def _through(before: _Move, after: _Move) -> tuple[Array, Array]:
    """Speeds at the point between two moves, in the axes of the one and of the other."""
    rest = np.zeros(len(before.way)), np.zeros(len(after.way))
    timed = any(one.leg.duration is not None or getattr(one.leg.motion, "partner", None) for one in (before, after))
    if timed or not len(before.way) or not len(after.way) or not np.array_equal(before.leg.X_FT, after.leg.X_FT):
        return rest
    on_line = before.leg.on_line, after.leg.on_line
    if not any(on_line):
        goes_on = before.way * after.way > 0
        goes_on[3] = False  # the two turns have axes of their own
        kept = np.where(goes_on, np.sign(after.way) * np.minimum(_able(before), _able(after)), 0.0)
        return kept, kept
    if all(on_line):
        if before.along is None or after.along is None or before.along @ after.along < 1 - _POINT:
            return rest
        both = np.minimum(_able(before), _able(after))
        return both, both
    line, joint = (before, after) if on_line[0] else (after, before)
    if line.along is None:
        return rest
    used = np.abs(line.along) > _POINT
    if np.any(joint.way[:3][used] * line.along[used] <= 0):
        return rest
    v = float(min(_able(line)[0], np.min(_able(joint)[:3][used] / np.abs(line.along[used]))))
    at_joint = np.r_[v * np.where(used, line.along, 0.0), 0.0, 0.0]
    return (np.array([v]), at_joint) if line is before else (at_joint, np.array([v]))


def _able(move: _Move) -> Array:
    """The speeds (m,) a move's axes may have at its ends: half the way each to brake, (2 ends) v^2 / 2a <= D."""
    return np.minimum(move.v_max, np.sqrt(move.a_max * np.abs(move.way)))


def _piece(plant: Plant, move: _Move, begin: tuple[Array, Array], end: tuple[Array, Array]) -> Piece | Infeasible:
    leg = move.leg
    if leg.holds:
        return hold(leg.q_0, leg.lasts)
    task = move.way, begin[1], end[0], move.v_max, move.a_max
    motion = bang_bang(*task)
    if leg.duration is not None:
        if (no := leg.too_short("the generator", motion.duration)) is not None:
            return no
        motion = bang_bang(*task, max(motion.duration, leg.duration))
    fastest = motion.duration
    for attempt in range(1, _ATTEMPTS):
        if leg.duration is not None or apart(motion.switches):
            break
        with suppress(ValueError):  # a time that an axis cannot take
            motion = bang_bang(*task, fastest + attempt * LONGER)
    if leg.on_line:
        path = SmoothPath.of(move.run)
        measure = path.sigma[-1] / float(move.way[0])

        def at(t: Array) -> tuple[Array, Array]:
            s, v, _ = motion.at(t)
            return path.axes_at(np.clip(s[:, 0], 0.0, move.way[0]) * measure, v[:, 0] * measure)

        return Piece(motion.duration, motion.switches, at)
    space = _Space(plant, move, motion)
    return space.refusal() or Piece(motion.duration, motion.switches, space.at)


def _caps(plant: Plant, axes: Axes, run: StopToStop) -> AxisLimits:
    """The tool's caps, those of the rail, and none of the joints; a joint move knows no programmed speed."""
    caps, joint = caps_of(axes, run), np.array([not leg.on_line for leg in run.legs])
    rail = plant.layout.rail
    speed, acceleration = (np.full_like(caps.velocity, np.inf) for _ in range(2))
    speed[:, rail], acceleration[:, rail] = plant.limits.velocity[rail], plant.limits.acceleration[rail]
    motions = [leg.motion for leg in run.legs]
    turning = np.array([getattr(motion, "speed").turning for motion in motions])  # noqa: B009 - none of them waits
    a_tcp = np.full(len(joint), plant.tcp.acceleration)
    v_tcp = np.where(joint, plant.tcp.speed, caps.v_tcp)
    return AxisLimits(speed, acceleration, v_tcp, a_tcp, turning, np.column_stack([a_tcp, a_tcp]))


def _drive(v_0: float, v_1: float, way: float, v: float, a: float, _: float | None) -> Piece:
    D, begin, end, V, A = (np.array([x]) for x in (way, v_0, v_1, v, a))
    motion = bang_bang(D, begin, end, V, A)
    return Piece(motion.duration, motion.switches, lambda t: (motion.at(t)[0][:, 0], motion.at(t)[1][:, 0]))


@dataclass(frozen=True, eq=False)
class _Space:
    """A joint move through space: axes' motion of x, y, z, turn and rail, on one branch of the arm."""

    plant: Plant
    move: _Move
    motion: PointToPoint

    def tool(self, s: Array) -> Array:
        """TCP poses (n, 4, 4) as if the rail stood at 0, at places s (n, 5) of the axes."""
        X_0 = self.move.X_0
        return pose(X_0[:3, :3] @ rotation_about(self.move.turn_axis, s[:, 3]), X_0[:3, 3] + s[:, :3])

    def arm(self, t: Array) -> Array:
        """Arm joints (n, m) at times (n,) in order, NaN out of reach; turns as near as can be from each to the next."""
        robot, leg = self.plant.robot, self.move.leg
        X_BF = self.tool(self.motion.at(t)[0]) @ inverse_pose(leg.X_FT)
        found = robot.branch(X_BF, np.zeros(len(t)), leg.cfx)
        return np.unwrap(np.vstack([leg.q_0[robot.layout.arm], found]), axis=0)[1:]

    def at(self, t: Array) -> tuple[Array, Array]:
        """Axes and their speeds (n, k) at times (n,)."""
        dense = np.union1d(t, np.arange(0.0, self.motion.duration, _STEP))  # for the turns, should rows be few
        arm = self.arm(dense)[np.searchsorted(dense, t)]
        s, v, _ = self.motion.at(t)
        robot, leg = self.plant.robot, self.move.leg
        q = robot.layout.join(robot.layout.place(leg.q_0) + s[:, 4], arm)
        V = np.hstack([v[:, :3], v[:, 3:4] * (self.move.X_0[:3, :3] @ self.move.turn_axis)])  # seen from the carriage
        # the pseudo-inverse has an answer at a singularity too
        qd = (np.linalg.pinv(robot.jacobian(q, leg.X_FT)[..., robot.layout.arm], rcond=1e-12) @ V[..., None])[..., 0]
        return q, robot.layout.join(v[:, 4], qd)

    def refusal(self) -> Infeasible | None:
        """Why the arm cannot follow, if so: the first place out of reach, or another configuration at the end."""
        leg, robot, T = self.move.leg, self.plant.robot, self.motion.duration
        t = np.r_[np.arange(0.0, T, _STEP), T]
        arm = self.arm(t)
        lost = np.flatnonzero(np.isnan(arm).any(axis=1))
        if lost.size:
            i = int(lost[0])
            s = self.motion.at(t[i : i + 1])[0]
            rail = float(robot.layout.place(leg.q_0) + s[0, 4]) if robot.has_rail else None
            X_WT = self.tool(s)[0]
            X_WT[:3, 3] += robot.way(rail)
            X_WF = X_WT @ inverse_pose(leg.X_FT)
            others = robot.solutions(X_WF, rail, self.plant.limits)
            missing = robot.why_unreachable(X_WF, rail, self.plant.limits)
            why = f"configuration {leg.cfx} ends there" if others else missing
            x, y, z = X_WT[:3, 3] * 1e3
            where = "" if rail is None else f" at rail {rail * 1e3:.1f} mm"
            return leg.refusal(
                f"leaves the workspace after {t[i]:.3f} of {T:.3f} s, point [{x:.1f}, {y:.1f}, {z:.1f}] mm"
                f"{where}: {why}"
            )
        if np.abs(arm[-1] - leg.q_1[robot.layout.arm]).max() > _SAME:
            return leg.refusal(
                "ends in another configuration than it begins in; an arm that follows the TCP through space keeps one"
            )
        return None
