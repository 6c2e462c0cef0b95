"""The whole problem as one nonlinear program: which variables an iterate has, and where each relation holds.

Each axis of a joint move has its own profile (closed form while the tool caps sleep, a grid once they bind), the rail
moves freely along lines and dwells.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array, IndexArray, inverse_pose
from trajopt_cli.nlp.clearances import Tangents
from trajopt_cli.nlp.constraint import NOTHING, Parts, Relation
from trajopt_cli.nlp.formulation import DWELL, JOINTS, LEFT, RIGHT, Formulation, Place
from trajopt_cli.nlp.nlp_assembly import BlockNlp
from trajopt_cli.path.line import Line
from trajopt_cli.problem.decision_scope import RailFreedom
from trajopt_cli.problem.objective import LeastEffort
from trajopt_cli.problem.problem import Leg, LegKind, Passage, Problem, TurnRoom, Waypoint
from trajopt_cli.timing.double_integrator import mean_ramp, trapezoid_time
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.effort import efforts
from trajopt_cli.trajectories.iterate import Iterate, Margins
from trajopt_cli.trajectories.leg_trajectories import JointNodes, JointProfiles, LegMotion, PathLeg
from trajopt_cli.trajectories.limits import limits_of
from trajopt_cli.trajectories.limits.limit import INF

_MOST_ZONES = 0.6  # and at most.
# s of a joint move on a grid up to which it has settings.damping; a slower one has more in proportion. Measured on
# joint moves of 48 and 112 s: without no answer in 150 iterations, with it one in 26 to 125, 0.05 to 0.1 % slower.
_DAMPED_AS_MUCH = 1.25

_FASTEST = 50.0  # m/s or rad/s: no tool goes along a path so fast.
_LEAST_TIME = 1e-3  # s of a leg without a way, so that scaled time stays defined.
_GLIDE = 0.01  # s; in a shorter wait the rail goes on as it comes. Not measured.
_DAMPING_DWELL = 4e-6  # s per squared scaled acceleration of the rail while the tool rests.

# Bounds of variables, by the scaled time of a leg. Not measured.
_SHARE_RATE = 50.0  # of the first derivative of a share and of the rail.
_SHARE_CURVE = 500.0  # of the second one; of a share more where the tool's caps ask for it, up to
_SHARPEST = 1e6
_SHARE_JERK = 5e4  # of the third one, where jerk is limited.
_TYPICAL_JERK = 100.0  # of a share, or a turn: in its place in the damping of jerks.
_MOST_TURN = 3.0  # rad that a tool is turned from the motion it begins with at most: a pose then tells how far.
_WHOLE = 1e-6  # rad that a sector lacks to be none
_JOINT_RATE, _JOINT_CURVE, _JOINT_JERK = 100.0, 1000.0, 1e5  # of the three derivatives of a joint on a grid.

NONE: IndexArray = np.zeros(0, dtype=np.intp)
NOTHING_NEAR: Mapping[int, Tangents] = MappingProxyType({})


@dataclass
class LegVariables:
    """Indices of a leg's variables, NONE where the leg has no such: its time T, lengths h of a path's zones, share
    (s, v, a), rail (d, w, b) as (N+1, r), (N+1, r), (N, r), with one more column where the tool may be turned, and the
    axes of a joint move on a grid as (N+1, n). Where jerk is limited the accelerations are N+1, and jerks j, y, qj are
    the N."""

    T: int
    h: IndexArray = field(default_factory=NONE.copy)
    s: IndexArray = field(default_factory=NONE.copy)
    v: IndexArray = field(default_factory=NONE.copy)
    a: IndexArray = field(default_factory=NONE.copy)
    d: IndexArray = field(default_factory=NONE.copy)
    w: IndexArray = field(default_factory=NONE.copy)
    b: IndexArray = field(default_factory=NONE.copy)
    q: IndexArray = field(default_factory=NONE.copy)
    qv: IndexArray = field(default_factory=NONE.copy)
    qa: IndexArray = field(default_factory=NONE.copy)
    j: IndexArray = field(default_factory=NONE.copy)
    y: IndexArray = field(default_factory=NONE.copy)
    qj: IndexArray = field(default_factory=NONE.copy)


@dataclass(frozen=True, eq=False)
class Nodes:
    """The nodes (m,) of a leg that have intervals on the same sides, and the interval (m,) on each side."""

    sides: str
    at: IndexArray
    beside: Mapping[str, IndexArray]

    def around(self, **accelerations: IndexArray) -> dict[str, IndexArray]:
        """Accelerations by name and side at these nodes, of those (N, ...) in each interval: around(a=x) has a_l of
        the intervals on the left, a_r on the right."""
        return {f"{name}_{side}": x[i] for name, x in accelerations.items() for side, i in self.beside.items()}


def _nodes_by_sides(N: int) -> tuple[Nodes, Nodes, Nodes]:
    """The first, the inner and the last node of N intervals."""
    first, inner, last = np.arange(1), np.arange(1, N), np.array([N])
    return (
        Nodes(RIGHT, first, {RIGHT: first}),
        Nodes(LEFT + RIGHT, inner, {LEFT: inner - 1, RIGHT: inner}),
        Nodes(LEFT, last, {LEFT: last - 1}),
    )


def at_once(motion: LegMotion | None) -> bool:
    """Whether a motion at hand takes no time: a place that the program names once more."""
    return motion is not None and motion.T == 0.0


def glides(leg: Leg) -> bool:
    """Whether a leg is a wait so short that the rail goes on as it comes."""
    return leg.kind is LegKind.DWELL and leg.rail_moves and leg.duration is not None and leg.duration < _GLIDE


def path_rate(axes: Axes, passage: Passage, q: Array, qd: Array) -> float:
    """How fast the short line of a passage goes by at axes q (n,) with velocities qd, of its s [1/s]."""
    assert passage.way is not None
    way = passage.way.twist(np.zeros(1))[0]
    return max(float(way @ (axes.jacobian(q, passage.X_FT) @ qd) / (way @ way)), 0.0)


def waypoint_turn(axes: Axes, point: Waypoint, q: Array, qd: Array) -> tuple[float, float]:
    """By how much the tool is turned from a waypoint's pose at axes q (n,) with velocities qd [rad], and how fast."""
    if (room := point.turn) is None:
        return 0.0, 0.0
    X_WF, tool = axes.forward(q), axes.jacobian(q, room.X_FT) @ qd
    if (passage := point.passage) is not None and passage.way is not None:
        tool = tool - path_rate(axes, passage, q, qd) * passage.way.twist(np.zeros(1))[0]
    return room.angle(point.X_WF, X_WF), float(tool[3:] @ (X_WF[:3, :3] @ room.axis_F))


def coordinates(axes: Axes, leg: Leg, point: Waypoint, q: Array, qd: Array) -> Array:
    """Where at an end of a leg the rail is, and the tool's turn if it has one."""
    rail = q[axes.layout.rail]
    return rail if leg.turn is None else np.append(rail, waypoint_turn(axes, point, q, qd)[0])


def _axis_parameters(room: TurnRoom | None) -> dict[str, Array]:
    """Parameters of a tool that may be turned."""
    return {} if room is None else {"axis": room.axis_F, "tcp": room.X_FT[:3, 3]}


class Transcription:
    """The program for one iterate's structure: its branches, grids, which joint moves are on a grid, and which legs
    have bodies near them."""

    def __init__(
        self, axes: Axes, formulation: Formulation, problem: Problem, iterate: Iterate,
        margins: Sequence[Margins | None], tangents: Mapping[int, Tangents] = NOTHING_NEAR,
    ):  # fmt: skip
        self.axes, self.formulation, self.problem = axes, formulation, problem
        self.iterate, self.margins, self.tangents = iterate, margins, tangents
        self.nlp = BlockNlp()
        self.waypoint_q: list[IndexArray] = []
        self.waypoint_qd: list[IndexArray] = []
        self.waypoint_qdd: list[IndexArray] = []
        self.waypoint_rate: dict[int, int] = {}  # of those that are passed along a path
        # of those beside a tool that may be turned: the turn, its rate and its acceleration
        self.waypoint_turn: dict[int, IndexArray] = {}
        self._smooth = formulation.smooth
        for k in range(len(problem.waypoints)):
            self._waypoint(k)
        asked = problem.objective
        self._weighed = isinstance(asked, LeastEffort)
        if isinstance(asked, LeastEffort):
            whole = float(np.nansum(efforts(axes, iterate.legs))) or 1.0
            self._unit = axes.acceleration * np.sqrt(whole)  # so that the efforts add up to one or less
        self.legs = [self._leg(leg, iterate.legs[k], margins[k]) for k, leg in enumerate(problem.legs)]
        if isinstance(asked, LeastEffort):
            self._elapse(asked.seconds)
        self._ties()

    def _relations(self, turn: TurnRoom | None) -> Formulation:
        return self.formulation if turn is None else self.formulation.with_turns

    def _hold(self, relation: Relation, z: Parts, p: Parts | None = None) -> None:
        relation.holds(self.nlp, z, p or {})

    # ---- boundary
    def _turn(self, k: int) -> IndexArray:
        """Variables of the tool's turn beyond waypoint k's pose, its rate and its acceleration: as it likes within its
        room, as it is where axes are given; none where nothing beside it turns the tool."""
        stop, beside = self.problem.waypoints[k], self.problem.legs[max(k - 1, 0) : k + 1]
        if stop.turn is None and all(leg.turn is None for leg in beside):
            return NONE
        low = high = guess = np.append(waypoint_turn(self.axes, stop, self.iterate.q[k], self.iterate.qd[k]), 0.0)
        if stop.turn is not None and stop.q is None:
            fast = 0.0 if stop.passage is None else _FASTEST
            low = np.array([max(stop.turn.low, -_MOST_TURN), -fast, 0.0])
            high = np.array([min(stop.turn.high, _MOST_TURN), fast, 0.0])
        self.waypoint_turn[k] = self.nlp.variables(np.clip(guess, low, high), low, high)
        return self.waypoint_turn[k]

    def _waypoint(self, k: int) -> None:
        nlp, axes, stop = self.nlp, self.axes, self.problem.waypoints[k]
        turn = self._turn(k)
        rail, arm = axes.layout.rail, axes.layout.arm
        q, qd = self.iterate.q[k], self.iterate.qd[k]
        qdd = np.zeros(axes.n) if self.iterate.qdd is None else self.iterate.qdd[k]
        if stop.q is not None and self._smooth:
            self.waypoint_qdd.append(nlp.variables(qdd, qdd, qdd))
        passage = stop.passage
        if passage is not None and passage.way is not None:
            rate = path_rate(axes, passage, q, qd)
            low_u, high_u = (rate, rate) if stop.q is not None else (0.0, _FASTEST / passage.measure)
            self.waypoint_rate[k] = int(nlp.variables([rate], low_u, high_u)[0])
        if stop.q is not None:
            self.waypoint_q.append(nlp.variables(stop.q, stop.q, stop.q))
            self.waypoint_qd.append(nlp.variables(qd, qd, qd))  # at rest but where a window is held in motion
            return
        share = self._share_left(k)
        low, high = self._waypoint_range(share, stop.ranges(self.problem.layout))
        if passage is not None and passage.way is None:
            self.waypoint_q.append(nlp.variables(q, low, high))
            self.waypoint_qd.append(nlp.variables(qd, -axes.velocity, axes.velocity))
            where: Parts = {
                "tcp": passage.X_FT[:3, 3],
                "place": (stop.X_WF @ passage.X_FT)[:3, 3],
                "radius": passage.radius,
            }
            self._hold(self.formulation.near_point(), {"q": self.waypoint_q[k]}, where)
            if axes.couplings:
                self._hold(self.formulation.sums(), {"q": self.waypoint_q[k]}, {"room": share})
            return
        d = nlp.variables(np.clip(q[rail], low[rail], high[rail]), low[rail], high[rail])
        joints = nlp.variables(q[arm], low[arm], high[arm])
        rest = self.problem.rests(k)
        V = np.zeros(axes.n) if rest else axes.velocity
        guess = np.zeros(axes.n) if rest else qd
        w = nlp.variables(guess[rail], -V[rail], V[rail])
        joints_v = nlp.variables(guess[arm], -V[arm], V[arm])
        self.waypoint_q.append(axes.layout.merge(d, joints))
        self.waypoint_qd.append(axes.layout.merge(w, joints_v))
        if self._smooth:
            A = np.zeros(axes.n) if rest else axes.acceleration
            self.waypoint_qdd.append(nlp.variables(np.zeros(axes.n) if rest else np.clip(qdd, -A, A), -A, A))
        way, X_FT = Line(stop.X_WF, stop.X_WF), np.eye(4)
        if passage is not None and passage.way is not None:
            way, X_FT = passage.way, passage.X_FT
        formulation = self._relations(stop.turn)
        p = {
            "path": way.parameters(inverse_pose(axes.X_WB0), X_FT),
            "branch": axes.robot.expressions.branch(self.iterate.cfx[k]),
            "near": q[arm],
            **_axis_parameters(stop.turn),
        }
        if stop.turn is not None:
            d, w = np.append(d, turn[0]), np.append(w, turn[1])
        if rest:
            self._hold(formulation.resting_waypoint(), {"d": d, "q": joints}, p)
        elif passage is not None:
            z: dict[str, ArrayLike] = {"u": self.waypoint_rate[k], "d": d, "w": w, "q": joints, "qd": joints_v}
            self._hold(formulation.passed_waypoint(), z, p)
        else:
            z = {"d": d, "w": w, "q": joints, "qd": joints_v}
            if self._smooth:
                b = self.waypoint_qdd[k][rail]
                z |= {"b": b if stop.turn is None else np.append(b, turn[2]), "qdd": self.waypoint_qdd[k][arm]}
            self._hold(formulation.waypoint(), z, p)
        if axes.couplings:
            self._hold(self.formulation.sums(), {"q": self.waypoint_q[k]}, {"room": share})

    def _rail_range(self, fraction: Array) -> tuple[Array, Array]:
        """The rail's range (..., r) at nodes that may use a fraction (..., r) of its half, about its middle: a rail
        that is at its end with velocity would pass it before the next node."""
        low, high = self.axes.lower[self.axes.layout.rail], self.axes.upper[self.axes.layout.rail]
        room = fraction * (high - low) / 2
        return (low + high) / 2 - room, (low + high) / 2 + room

    def _share_left(self, k: int) -> Array:
        """The share (n,) of half its range that the legs beside waypoint k leave each axis there: one that is at its
        end with velocity has passed it before, or will. At rest an arm has not."""
        before, after = self.margins[k - 1] if k else None, self.margins[k] if k < len(self.margins) else None
        share = np.ones(self.axes.n)
        for margins, node in ((before, -1), (after, 0)):
            share = share if margins is None else np.minimum(share, margins.position[node])
        if self.problem.rests(k):
            share[self.axes.layout.arm] = 1.0
        return share

    def _waypoint_range(self, share: Array, allowed: tuple[Array, Array]) -> tuple[Array, Array]:
        """The axes' ranges (n,) where a share of their halves is left, and the program allows the rails so much."""
        axes, rail = self.axes, self.axes.layout.rail
        middle, room = (axes.lower + axes.upper) / 2, share * (axes.upper - axes.lower) / 2
        low, high = np.where(share < 1, middle - room, axes.lower), np.where(share < 1, middle + room, axes.upper)
        held = allowed[0] == allowed[1]
        low[rail] = np.where(held, allowed[0], np.maximum(allowed[0], low[rail]))
        high[rail] = np.where(held, allowed[1], np.minimum(allowed[1], high[rail]))
        return low, high

    # ---- ties
    def _ties(self) -> None:
        """Waypoints of a station share one rail position where the freedom says so. Those that a program ties are held:
        only the ends of a cycle are, while the legs around them are solved."""
        rail = self.axes.layout.rail
        pairs = []
        for k, leg in enumerate(self.problem.legs):
            hold = not leg.rail_moves
            if self.problem.freedom.rail is RailFreedom.STATION and leg.kind is not LegKind.JOINT:
                hold = True
            if hold or at_once(self.iterate.legs[k]):
                pairs.append((k, k + 1))
        held = list(range(len(self.problem.waypoints)))  # what is held equal already: no row says it twice
        for i, k in pairs:
            a, b = self.problem.waypoints[i], self.problem.waypoints[k]
            if held[i] != held[k] and (a.free or b.free):
                for x, y in zip(self.waypoint_q[i][rail], self.waypoint_q[k][rail], strict=True):
                    self._hold(self.formulation.equal(), {"x": x, "y": y})
                held = [held[i] if one == held[k] else one for one in held]
        for k, leg in enumerate(self.problem.legs):
            ends = [self.problem.waypoints[i] for i in (k, k + 1)]
            if leg.kind is LegKind.DWELL and leg.turn is not None and any(one.q is None for one in ends):
                self._hold(self.formulation.equal(), {"x": self.waypoint_turn[k][0], "y": self.waypoint_turn[k + 1][0]})
        for k, motion in enumerate(self.iterate.legs):
            moved = [i for i in (k, k + 1) if self.problem.waypoints[i].q is None and not self.problem.rests(i)]
            if at_once(motion) and moved:
                for x, y in zip(self.waypoint_qd[k][rail], self.waypoint_qd[k + 1][rail], strict=True):
                    self._hold(self.formulation.equal(), {"x": x, "y": y})

    # ---- legs
    def _leg(self, leg: Leg, motion: LegMotion | None, margins: Margins | None) -> LegVariables | None:
        if motion is None or at_once(motion) or (isinstance(motion, JointProfiles) and leg.kind is LegKind.DWELL):
            return None
        if glides(leg) and not self._smooth:
            self._glide(leg)
            return None
        low, high = (leg.duration, leg.duration) if leg.duration is not None else (self.least(leg), INF)
        T = int(self.nlp.variables([motion.T], low, high)[0])
        if not self._weighed:
            self.nlp.minimise(T)
        out = LegVariables(T)
        if isinstance(motion, PathLeg):
            assert margins is not None
            self._path(leg, motion, margins, out)
        elif isinstance(motion, JointProfiles):
            self._joint_closed(leg, out)
        else:
            assert margins is not None
            assert isinstance(motion, JointNodes)
            self._joints(leg, motion, margins, out)
        return out

    def _glide(self, leg: Leg) -> None:
        """A wait so short that the rail goes on as it comes."""
        assert leg.duration is not None
        rail, k = self.axes.layout.rail, leg.start
        still = self.nlp.variables(np.zeros(self.axes.layout.r), 0.0, 0.0)
        ends = [(self.waypoint_q[i][rail], self.waypoint_qd[i][rail]) for i in (k, k + 1)]
        z = {"x_0": ends[0][0], "v_0": ends[0][1], "a": still, "x_1": ends[1][0], "v_1": ends[1][1]}
        self._hold(self.formulation.integration(), z, {"h": leg.duration})

    def _most(self, leg: Leg, motion: LegMotion, rate: float, curve: float) -> tuple[Array, Array]:
        """Bounds (n,) of the axes' derivatives by scaled time that no answer comes near: more in a long time."""
        V, A = self.axes.velocity_on(leg), self.axes.acceleration_on(leg)
        return np.maximum(rate, 2 * V * motion.T), np.maximum(curve, 2 * A * motion.T**2)

    def least(self, leg: Leg) -> float:
        """What a leg takes at least [s]; a joint move what the tool takes straight from stop to stop."""
        shortest = max(_LEAST_TIME, leg.least)
        if leg.kind is not LegKind.JOINT:
            return shortest
        points = self.problem.waypoints[leg.start : leg.start + 2]
        p_0, p_1 = (((x.X_WF if x.q is None else self.axes.forward(x.q)) @ leg.X_FT)[:3, 3] for x in points)
        way = float(np.linalg.norm(p_1 - p_0))
        if passages := [x.passage for x in points if x.passage is not None]:
            return max(shortest, (way - sum(one.radius for one in passages)) / leg.v_tcp)
        return max(shortest, float(trapezoid_time(way, leg.v_tcp, mean_ramp(*leg.ramps))))

    def _elapse(self, seconds: float) -> None:
        """The legs take so long in all."""
        pairs = zip(self.legs, self.iterate.legs, strict=True)
        left = seconds - sum(motion.T for var, motion in pairs if var is None and motion is not None)
        times = [var.T for var in self.legs if var is not None]
        passed = np.cumsum([0.0, *self.nlp.guess[times]])
        passed *= left / passed[-1]
        low, high = np.zeros(len(passed)), np.full(len(passed), left)
        low[-1], high[0] = left, 0.0
        t = self.nlp.variables(passed, low, high)
        self._hold(self.formulation.elapsed(), {"t_0": t[:-1], "T": times, "t_1": t[1:]})

    def _damp(self, accelerations: IndexArray, weight: float) -> None:
        """A hair of curvature, but where effort is what counts."""
        if not self._weighed:
            self.nlp.damp(accelerations.ravel(), weight)

    def _damp_jerk(self, jerks: IndexArray, scale: Array, T: float) -> None:
        """The same for jerks (N, k), which are of the order of scale (k,)."""
        for of_axis, one in zip(jerks.T, scale, strict=True):
            self._damp(of_axis, self.axes.settings.damping_jerk * T / one**2)

    def _effort(self, guess: Array) -> IndexArray:
        """Variables of the effort at nodes or in intervals, to be kept small. guess: what it may be."""
        e = self.nlp.variables(guess, 0.0, np.inf)
        for one in e:
            self.nlp.minimise(int(one))
        return e

    def _path_parameters(self, leg: Leg, motion: PathLeg) -> dict[str, Array]:
        """Parameters of the pose at all nodes of a path."""
        count = motion.N + 1
        return {
            "path": np.tile(motion.segment.parameters(inverse_pose(self.axes.X_WB0), motion.X_FT), (count, 1)),
            "branch": np.tile(self.axes.robot.expressions.branch(motion.cfx), (count, 1)),
            "near": motion.node_arm(self.axes),
            **{name: np.tile(x, (count, 1)) for name, x in _axis_parameters(leg.turn).items()},
        }

    def _states(self, x: IndexArray, v: IndexArray, a: IndexArray, j: IndexArray) -> dict[str, IndexArray]:
        """What one axis' integration is made of; j: jerks where they are limited."""
        z = {"x_0": x[:-1], "v_0": v[:-1], "x_1": x[1:], "v_1": v[1:]}
        return z | ({"a_0": a[:-1], "j": j, "a_1": a[1:]} if self._smooth else {"a": a})

    def _integrate_zones(self, h: IndexArray, x: IndexArray, v: IndexArray, a: IndexArray, j: IndexArray) -> None:
        z = self._states(x, v, a, j) | {"h": np.repeat(h, (len(x) - 1) // 3)}
        self._hold(self.formulation.zoned_integration(), z)

    def _ends(self, leg: Leg, axes: slice, turning: bool = False) -> list[list[IndexArray]]:
        """Positions, velocities and, where jerk is limited, accelerations of some axes at both ends of a leg; turning:
        behind them those of a tool's turn."""
        out = []
        for k in (leg.start, leg.start + 1):
            every = [self.waypoint_q[k], self.waypoint_qd[k], *([self.waypoint_qdd[k]] if self._smooth else [])]
            turn = self.waypoint_turn[k] if turning else np.zeros((3, 0), dtype=np.intp)
            out.append([np.append(x[axes], i) for x, i in zip(every, turn, strict=False)])
        return out

    def _linked(self, ends: Sequence[Sequence[IndexArray]], v: IndexArray, a: IndexArray, T: int) -> None:
        """Velocities v (N+1, m) begin and end as the waypoints' do; accelerations (N+1, m), too, where jerk is
        limited."""
        for node, (_, xd, *xdd) in zip((0, -1), ends, strict=True):
            self._hold(self.formulation.velocity_link(), {"xd": xd, "v": v[node], "T": T})
            for one in xdd:
                self._hold(self.formulation.acceleration_link(), {"xdd": one, "a": a[node], "T": T})

    def _zones(self, motion: PathLeg) -> IndexArray:
        """Interval lengths of a path's three zones (run-up, middle, run-out).

        Free on one grid only, so that switches fall on nodes; kept on the finer ones, which saves iterations.
        """
        per_zone = motion.N // 3
        lengths = np.diff(motion.grid)[[0, per_zone, 2 * per_zone]]
        if self.axes.settings.free_zones != motion.N or self._weighed:
            return self.nlp.variables(lengths, lengths, lengths)
        h = self.nlp.variables(lengths, self.axes.settings.least_zone / per_zone, _MOST_ZONES / per_zone)
        self._hold(self.formulation.zones(), {"h": h}, {"n": per_zone})
        return h

    def _path_parameter(self, leg: Leg, motion: PathLeg, curve: float, out: LegVariables) -> None:
        """Variables of the path parameter going from 0 to 1, at rest at both ends but where these are passed, never
        backwards; curve: bound of its second derivative."""
        N = motion.N
        low_s, high_s = np.zeros(N + 1), np.ones(N + 1)
        low_s[-1], high_s[0] = 1.0, 0.0
        high_v = np.full(N + 1, _SHARE_RATE)
        passed = {node: k for node, k in ((0, leg.start), (-1, leg.start + 1)) if k in self.waypoint_rate}
        high_v[[node for node in (0, -1) if node not in passed]] = 0.0
        out.s = self.nlp.variables(motion.s, low_s, high_s)
        out.v = self.nlp.variables(np.minimum(motion.v, high_v), 0.0, high_v)
        for node, k in passed.items():
            z = {"u": self.waypoint_rate[k], "v": out.v[node], "T": out.T}
            self._hold(self.formulation.rate_link(), z, {"m": self.rate_share(leg, node, k)})
        if not self._smooth:
            out.a = self.nlp.variables(motion.a, -curve, curve)
            return
        most = np.full(N + 1, curve)
        most[[0, -1]] = 0.0
        between = np.r_[0.0, (motion.a[1:] + motion.a[:-1]) / 2, 0.0]
        out.a = self.nlp.variables(between, -most, most)
        out.j = self.nlp.variables(np.diff(between) / np.diff(motion.grid), -_SHARE_JERK, _SHARE_JERK)

    def rate_share(self, leg: Leg, node: int, k: int) -> float:
        """How much of the short line of waypoint k one s of a leg is, at its node 0 or -1."""
        passage = self.problem.waypoints[k].passage
        assert passage is not None
        assert passage.way is not None
        assert leg.segment is not None
        size = [np.linalg.norm(one.twist(np.array([at]))[0].reshape(2, 3), axis=1)
                for one, at in ((leg.segment, float(-node)), (passage.way, 0.0))]  # fmt: skip
        part = int(size[1][0] == 0.0)
        return float(size[0][part] / size[1][part])

    def _rail_on_path(self, leg: Leg, motion: PathLeg, margins: Margins, out: LegVariables) -> None:
        """Variables of a rail that moves as it likes, from waypoint to waypoint, or is held where it is; and of a
        tool's turn, within its room on a line or an arc, held in a rest."""
        settings, layout, line, turning = self.axes.settings, self.axes.layout, leg.kind is LegKind.LINE, bool(leg.turn)
        nlp, N, r = self.nlp, motion.N, layout.r
        M = N + 1 if self._smooth else N
        ends = self._ends(leg, layout.rail, turning)
        own = np.array([leg.rail_moves] * r + [line] * turning, dtype=bool)
        m = int(own.sum())
        out.d = np.tile(ends[0][0], (N + 1, 1))
        out.w, out.b, out.y = (np.empty((rows, len(own)), dtype=np.intp) for rows in (N + 1, M, N * self._smooth))
        for x in (out.w, out.b, out.y):
            x[:, ~own] = nlp.variables(np.zeros(x[:, ~own].size), 0.0, 0.0).reshape(len(x), len(own) - m)
        if not m:
            return
        bounds = self._most(leg, motion, _SHARE_RATE, _SHARE_CURVE)
        fast, sharp = (np.append(x[layout.rail], [x[layout.arm].max()] * turning)[own] for x in bounds)
        ranges = zip(self._rail_range(margins.position[1:-1, layout.rail]), (-_MOST_TURN, _MOST_TURN), strict=True)
        low, high = (np.hstack([x, np.full((N - 1, int(turning)), most)])[:, own] for x, most in ranges)
        inner = nlp.variables(np.clip(motion.d[1:-1, own], low, high), low.ravel(), high.ravel())
        out.d[1:-1, own] = inner.reshape(N - 1, m)
        out.d[-1] = ends[1][0]
        out.w[:, own] = nlp.variables(motion.w[:, own], -np.tile(fast, N + 1), np.tile(fast, N + 1)).reshape(N + 1, m)
        most, guess = np.tile(sharp, (M, 1)), motion.b[:, own]
        if self._smooth:
            guess = np.vstack([guess[:1], (guess[1:] + guess[:-1]) / 2, guess[-1:]])
            steps = np.diff(motion.grid)[:, None]
            out.y[:, own] = nlp.variables(np.diff(guess, axis=0) / steps, -_SHARE_JERK, _SHARE_JERK).reshape(N, m)
        elif leg.kind is LegKind.DWELL and leg.duration is not None:
            most = margins.push[:, None] * self.axes.acceleration_on(leg)[layout.rail] * leg.duration**2
        out.b[:, own] = nlp.variables(np.clip(guess, -most, most), -most.ravel(), most.ravel()).reshape(M, m)
        for k in np.flatnonzero(own):
            self._integrate_zones(out.h, out.d[:, k], out.w[:, k], out.b[:, k], out.y[:, k] if self._smooth else NONE)
        self._damp(out.b[:, own], settings.damping if line else _DAMPING_DWELL)
        if self.axes.jerk is not None:
            scale = np.append(self.axes.jerk[layout.rail] * motion.T**3, [_TYPICAL_JERK] * turning)
            self._damp_jerk(out.y[:, own], scale[own], motion.T)
        self._linked([[x[own] for x in end] for end in ends], out.w[:, own], out.b[:, own], out.T)
        if line and leg.turn is not None and leg.turn.high - leg.turn.low < 2 * np.pi - _WHOLE:
            columns = {"f": out.d[:, -1], "w": out.w[:, -1], "s": out.s, "v": out.v}
            z = {f"{name}_{i}": x[i : N + i] for i in (0, 1) for name, x in columns.items()}
            room = np.array([leg.turn.high - leg.turn.low, leg.turn.high + leg.turn.low, -2 * leg.turn.slope]) / 2
            self._hold(self.formulation.sector(), {**z, "h": np.repeat(out.h, N // 3)}, {"room": room})

    def _path(self, leg: Leg, motion: PathLeg, margins: Margins, out: LegVariables) -> None:
        out.h = self._zones(motion)
        line = leg.kind is LegKind.LINE
        if line:
            sharp = 2 * leg.a_tcp * motion.T**2 / leg.chord if leg.chord else 0.0  # a slow path has short ramps
            self._path_parameter(leg, motion, max(_SHARE_CURVE, min(sharp, _SHARPEST)), out)
            self._integrate_zones(out.h, out.s, out.v, out.a, out.j)
            if self._smooth:
                self._damp_jerk(out.j[:, None], np.array([_TYPICAL_JERK]), motion.T)
        fixed = line and self.problem.coordinated
        tied = fixed and self.axes.layout.r > 0  # without a rail it is the same node
        if not tied:
            self._rail_on_path(leg, motion, margins, out)
        place: Place = motion.segment.symbols if line else DWELL
        p = self._path_parameters(leg, motion)
        q = self.axes.layout.merge(motion.rail, p["near"])
        half = np.diff(motion.grid) / 2
        e = self._effort(self._effort_of(motion, half)) if self._weighed else NONE
        for nodes in _nodes_by_sides(motion.N):
            at = nodes.at
            z: dict[str, ArrayLike] = {"T": out.T}
            if line:
                z |= {"s": out.s[at], "v": out.v[at], **self._driving(nodes, a=out.a, ja=out.j)}
            if not tied:
                z |= {"d": out.d[at], "w": out.w[at], **self._driving(nodes, b=out.b, jb=out.y)}
            here = {name: x[at] for name, x in p.items()}
            if tied:
                ends = self.iterate.q[leg.start : leg.start + 2, self.axes.layout.rail]
                here |= {"d_0": np.tile(ends[0], (len(at), 1)), "span": np.tile(ends[1] - ends[0], (len(at), 1))}
            more: dict[str, Array] = {}
            if self._weighed:
                z["e"] = e[at]
                more["unit"] = np.tile(self._unit, (len(at), 1))
                widths = [half[i] for i in nodes.beside.values()]
                more |= {f"h_{i}": h for i, h in enumerate([np.sum(widths, axis=0)] if self._smooth else widths)}
            self._limits(leg, margins, nodes, place, q, z, here, more, tied)
        if not fixed and (tangents := self.tangents.get(leg.start)) is not None:
            z = {"d": out.d, "s": out.s} if line else {"d": out.d}
            here = {**p, "gradient": tangents.gradient, "least": tangents.least}
            self._hold(self._relations(leg.turn).clear_path(place), z, here)

    def _limits(
        self, leg: Leg, margins: Margins, nodes: Nodes, place: Place, q: Array, z: dict[str, ArrayLike],
        p: Parts, more: Parts = NOTHING, tied: bool = False,
    ) -> None:  # fmt: skip
        """All limits at some nodes of a leg, whose axes at hand are q (N+1, n), with variables z and parameters p of
        their pose; more: of the effort."""
        shared, weighed, formulation = {**p, **more}, "e" in z, self._relations(leg.turn)
        plain = {name: x for name, x in z.items() if name != "e"}
        for limit in limits_of(self.axes):
            values = limit.node_values(leg, margins.by_name[limit.name][nodes.at], place != JOINTS, q[nodes.at])
            if not limit.apart:
                shared |= values
            elif (kind := limit.node_kind(leg)) is not None:
                self._hold(formulation.limit_node(limit, kind, place, nodes.sides, tied), plain, {**p, **values})
        self._hold(formulation.node(place, nodes.sides, weighed, tied), z, shared)

    def _driving(self, nodes: Nodes, **variables: IndexArray) -> dict[str, IndexArray]:
        """What drives at some nodes: accelerations on their sides; where jerk is limited their own, and jerks on their
        sides. variables: an acceleration and, named with a j before it, its jerk."""
        (name, acceleration), (jerk_name, jerk) = variables.items()
        if not self._smooth:
            return nodes.around(**{name: acceleration})
        return {name: acceleration[nodes.at], **nodes.around(**{jerk_name: jerk})}

    def _effort_of(self, motion: PathLeg, half: Array) -> Array:
        """About the effort (N+1,) at the nodes of a path."""
        sample = motion.sample(self.axes, motion.T * motion.grid)
        squares = np.sum((sample.qdd / self._unit) ** 2, axis=1)
        return np.nan_to_num(motion.T * squares * (np.r_[half, 0.0] + np.r_[0.0, half]))

    def _joint_closed(self, leg: Leg, out: LegVariables) -> None:
        k, V, A = leg.start, self.axes.velocity_on(leg), self.axes.acceleration_on(leg)
        z: Parts = {
            "q_0": self.waypoint_q[k], "qd_0": self.waypoint_qd[k],
            "q_1": self.waypoint_q[k + 1], "qd_1": self.waypoint_qd[k + 1], "T": out.T,
        }  # fmt: skip
        self._hold(self.formulation.axis_reach(), z, {"V": V, "A": A})

    def _joints(self, leg: Leg, motion: JointNodes, margins: Margins, out: LegVariables) -> None:
        settings = self.axes.settings
        nlp, N, n, k0 = self.nlp, motion.N, self.axes.n, leg.start
        middle, half = (self.axes.upper + self.axes.lower) / 2, (self.axes.upper - self.axes.lower) / 2
        room = half * margins.position[1:-1]
        inner = nlp.variables(motion.q[1:-1], (middle - room).ravel(), (middle + room).ravel())
        out.q = np.vstack([self.waypoint_q[k0], inner.reshape(N - 1, n), self.waypoint_q[k0 + 1]])
        if self.axes.couplings:
            self._hold(self.formulation.sums(), {"q": out.q[1:-1]}, {"room": margins.position[1:-1]})
        fast, sharp = self._most(leg, motion, _JOINT_RATE, _JOINT_CURVE)
        out.qv = nlp.variables(motion.v, -np.tile(fast, N + 1), np.tile(fast, N + 1)).reshape(N + 1, n)
        if self._smooth:
            steps = np.diff(motion.grid)[:, None]
            guess = np.vstack([motion.a[:1], (motion.a[1:] + motion.a[:-1]) / 2, motion.a[-1:]])
            out.qa = nlp.variables(guess, -np.tile(sharp, N + 1), np.tile(sharp, N + 1)).reshape(N + 1, n)
            out.qj = nlp.variables(np.diff(guess, axis=0) / steps, -_JOINT_JERK, _JOINT_JERK).reshape(N, n)
        else:
            out.qa = nlp.variables(motion.a, -np.tile(sharp, N), np.tile(sharp, N)).reshape(N, n)
        for indices, step in zip(out.qa, np.diff(motion.grid), strict=False):
            self._damp(indices, settings.damping * N * step * max(1.0, motion.T / _DAMPED_AS_MUCH))
        if self.axes.jerk is not None:
            self._damp_jerk(out.qj, self.axes.jerk * motion.T**3, motion.T)
        rail = self.axes.layout.rail
        if not leg.rail_moves:
            held = out.q[1:-2, rail]  # the last one follows from the integration
            x = np.broadcast_to(self.waypoint_q[k0][rail], held.shape)
            self._hold(self.formulation.equal(), {"x": x.ravel(), "y": held.ravel()})
        self._integrate(motion.grid, self._states(out.q, out.qv, out.qa, out.qj))
        self._linked(self._ends(leg, slice(None)), out.qv, out.qa, out.T)
        if self._weighed:
            h, unit, a = np.diff(motion.grid), self._unit, motion.a
            if self._smooth:
                h, a = (np.r_[h, 0.0] + np.r_[0.0, h]) / 2, np.vstack([a, a[-1:]])
            e = self._effort(h * np.sum((a / unit) ** 2, axis=1) / motion.T**3)
            z_effort: Parts = {"a": out.qa, "T": out.T, "e": e}
            self._hold(self.formulation.axes_effort(), z_effort, {"h": h, "unit": unit})
        for nodes in _nodes_by_sides(N):
            at, driving = nodes.at, self._driving(nodes, a=out.qa, ja=out.qj)
            z: dict[str, ArrayLike] = {"q": out.q[at], "v": out.qv[at], **driving, "T": out.T}
            self._limits(leg, margins, nodes, JOINTS, motion.q, z, {})
        if (tangents := self.tangents.get(k0)) is not None:
            p = {"gradient": tangents.gradient, "least": tangents.least}
            self._hold(self.formulation.clear_axes(), {"q": out.q}, p)
        if np.isfinite(leg.v_tcp):  # with a limit at the nodes alone the tool might be fast between them
            speed = margins.tool[:, 0]
            p = {"tcp": leg.X_FT[:3, 3], "reach": leg.v_tcp * np.minimum(speed[:-1], speed[1:]) * np.diff(motion.grid)}
            self._hold(self.formulation.tool_chord(), {"q_0": out.q[:-1], "q_1": out.q[1:], "T": out.T}, p)

    def _integrate(self, grid: Array, z: dict[str, IndexArray]) -> None:
        """All axes (N+1, n) on one grid."""
        h = np.repeat(np.diff(grid), z["x_0"].shape[1])
        self._hold(self.formulation.integration(), {name: i.ravel() for name, i in z.items()}, {"h": h})
