"""The whole program as one nonlinear program: stop states and leg motions in, better ones out.

Stream: each axis of a joint move has its own profile (closed form while the tool caps sleep, a grid once they bind),
the rail moves freely along lines and dwells. Rapid: joint moves run straight in joint space, the rail in proportion to
the path, every axis rests at every stop.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise

import casadi as ca
import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray, axis_angle, inverse_pose
from trajopt_cli.optimize.axes import Axes
from trajopt_cli.optimize.blocks import BlockNlp
from trajopt_cli.optimize.legs import JointNodes, JointProfiles, LegMotion, PathLeg, share_of, straight
from trajopt_cli.optimize.profiles import hold, profiles
from trajopt_cli.optimize.stages import PathConstants, Stages, ToolRow
from trajopt_cli.problem.freedom import RailFreedom
from trajopt_cli.problem.problem import Leg, LegKind, Problem
from trajopt_cli.robot.symbolic_inverse import BranchSigns

START = 1.0 - 5e-5  # share of every limit a grid starts with; rounding and Hermite rows need a hair of room
EXACT = 1.0 - 1e-8  # the same for joints that move by polynomials on the grid: exact between nodes
FREE_ZONES = 12  # intervals of a path with which its zones may shift
DAMPING = 4e-7  # s per squared scaled acceleration, where many motions take the same time
DAMPING_DWELL = 4e-6  # the same while the tool rests: with less, a long dwell's rail chatters between the nodes
LEAST_ZONE = 0.01  # share of a leg that its run-up, middle and run-out last at least
LEAST_TIME = 1e-3  # s; a leg of zero length still gets this long, so that scaled time stays defined


@dataclass(frozen=True, eq=False)
class Draft:
    """A candidate: axes q and speeds qd (M, 7) at the stops, IK branch per stop (-1 where joints are fixed)."""

    q: Array
    qd: Array
    cfx: tuple[int, ...]
    legs: tuple[LegMotion | None, ...]

    @property
    def duration(self) -> float:
        """Sum of all legs, s."""
        return sum(leg.T for leg in self.legs if leg is not None)


@dataclass
class Margins:
    """Limits in force per leg and node, as shares (N+1,) of the true ones; tightened where a dense check found excess.

    velocity, acceleration (N+1, 7); position (N+1, 7): of half the range, about its middle; tool (N+1, 3): speed,
    acceleration, reorientation. rows (N+1, 3): which tool caps a joint move's nodes must hold explicitly; far from a
    cap the dense check alone watches. push (N,): the rail's acceleration in each interval of a dwell.
    """

    velocity: Array
    acceleration: Array
    position: Array
    tool: Array
    rows: BoolArray
    push: Array

    @classmethod
    def full(cls, N: int, joints: float) -> Margins:
        """Nothing tightened but for rounding, no tool cap of a joint move in force. joints: share of their limits."""
        share = np.full((N + 1, 7), joints)
        return cls(
            share, share.copy(), np.ones((N + 1, 7)), np.full((N + 1, 3), START), np.zeros((N + 1, 3), dtype=bool),
            np.ones(N),
        )  # fmt: skip

    def refined(self) -> Margins:
        """The same shares on twice as many intervals; a new node takes the smaller neighbour's."""

        def double(x: Array) -> Array:
            out = np.empty((2 * len(x) - 1, x.shape[1]))
            out[::2] = x
            out[1::2] = np.minimum(x[:-1], x[1:])
            return out

        rows = np.repeat(self.rows, 2, axis=0)[:-1]
        rows[1::2] |= self.rows[1:]
        return Margins(
            double(self.velocity), double(self.acceleration), double(self.position), double(self.tool), rows,
            np.repeat(self.push, 2),
        )  # fmt: skip


@dataclass(frozen=True, eq=False)
class Grid:
    """Fixed nodes (N+1,) over 0..1."""

    nodes: Array


NONE: IndexArray = np.zeros(0, dtype=np.intp)


@dataclass
class _LegVariables:
    """Indices of a leg's variables; NONE where the leg has no such."""

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


def _sides(k: int, N: int) -> str:
    return ("l" if k > 0 else "") + ("r" if k < N else "")


class Transcription:
    """Builds the program for one draft's structure (branches, grids, which joint moves are on a grid) and solves it."""

    def __init__(
        self, axes: Axes, stages: Stages, flange: ca.Function, problem: Problem, draft: Draft,
        margins: Sequence[Margins | None], tied: bool,
    ):  # fmt: skip
        self.axes, self.stages, self.flange, self.problem = axes, stages, flange, problem
        self.draft, self.margins, self.tied = draft, margins, tied
        self.nlp = BlockNlp()
        self._stops()
        self._legs = [self._leg(leg, draft.legs[k], margins[k]) for k, leg in enumerate(problem.legs)]
        self._stations()

    # ---- stops
    def _stops(self) -> None:
        nlp, axes = self.nlp, self.axes
        self.stop_q: list[IndexArray] = []
        self.stop_v: list[IndexArray] = []
        V = axes.velocity
        for k, stop in enumerate(self.problem.waypoints):
            q, qd = self.draft.q[k], self.draft.qd[k]
            if stop.q is not None:
                fixed = axes.seven(stop.q)
                self.stop_q.append(nlp.variables(fixed, fixed, fixed))
                self.stop_v.append(nlp.variables(np.zeros(7), 0.0, 0.0))
                continue
            rest = stop.rest or self.tied or not self.problem.rail_may_pass(k)
            low, high = self._stop_range(k, stop.rail)
            d = nlp.variables(np.clip(q[:1], low, high), low, high)
            arm = nlp.variables(q[1:], axes.lower[1:], axes.upper[1:])
            if rest:
                w = nlp.variables(np.zeros(1), 0.0, 0.0)
                arm_v = nlp.variables(np.zeros(6), 0.0, 0.0)
            else:
                w = nlp.variables(qd[:1], -V[0], V[0])
                arm_v = nlp.variables(qd[1:], -V[1:], V[1:])
            self.stop_q.append(np.r_[d, arm])
            self.stop_v.append(np.r_[w, arm_v])
            path = self._rest_path(stop.X_WF)
            p = np.r_[path.vector(), BranchSigns.from_cfx(self.draft.cfx[k]).vector(), q[1:]]
            if rest:
                nlp.add(self.stages.resting_stop(), np.r_[d, arm], p)
            else:
                nlp.add(self.stages.stop(), np.r_[d, w, arm, arm_v], p)

    def _rail_range(self, share: Array) -> tuple[Array, Array]:
        """The rail's range (n,), (n,) at nodes that may use a share (n,) of its half, about its middle: a rail that is
        at its end with speed would pass it before the next node."""
        low, high = self.axes.lower[0], self.axes.upper[0]
        room = share * (high - low) / 2
        return (low + high) / 2 - room, (low + high) / 2 + room

    def _stop_range(self, k: int, allowed: tuple[float, float]) -> tuple[float, float]:
        """The rail's range at stop k: what the program allows and what the legs beside it leave."""
        before, after = self.margins[k - 1] if k else None, self.margins[k] if k < len(self.margins) else None
        shares = [m.position[node, 0] for m, node in ((before, -1), (after, 0)) if m is not None]
        if allowed[0] == allowed[1] or not shares:
            return allowed
        low, high = self._rail_range(np.array(min(shares)))
        return max(allowed[0], float(low)), min(allowed[1], float(high))

    def _stations(self) -> None:
        """Stops of a station share one rail position where the freedom says so, and so do tied ones."""
        pairs = [pair for group in self.problem.ties for pair in pairwise(group)]
        for k, leg in enumerate(self.problem.legs):
            hold = not leg.rail_moves
            if self.problem.freedom.rail is RailFreedom.STATION and leg.kind is not LegKind.JOINT:
                hold = True
            if hold:
                pairs.append((k, k + 1))
        held = list(range(len(self.problem.waypoints)))  # what is held equal already: no row says it twice
        for i, k in pairs:
            a, b = self.problem.waypoints[i], self.problem.waypoints[k]
            if held[i] != held[k] and not (a.rail[0] == a.rail[1] and b.rail[0] == b.rail[1]):
                self.nlp.add(self.stages.equal(), [self.stop_q[i][0], self.stop_q[k][0]])
                held = [held[i] if one == held[k] else one for one in held]

    def _rest_path(self, X_WF: Array) -> PathConstants:
        X = self.axes.in_base(X_WF)
        return PathConstants(X[:3, 3], np.zeros(3), X[:3, :3], np.array([1.0, 0, 0]), 0.0, np.zeros(3))

    # ---- legs
    def _leg(self, leg: Leg, motion: LegMotion | None, margins: Margins | None) -> _LegVariables | None:
        if motion is None or (isinstance(motion, JointProfiles) and leg.kind is LegKind.DWELL):
            return None
        low, high = (leg.duration, leg.duration) if leg.duration is not None else (LEAST_TIME, 60.0)
        if leg.duration is not None and leg.kind is not LegKind.DWELL:
            high = 60.0
        if self.tied and leg.kind is LegKind.DWELL and leg.duration is not None:
            low = LEAST_TIME  # the profile's own least time; played slower so that it lasts the dwell
        T = int(self.nlp.variables([motion.T], low, high)[0])
        weight = 1e-4 if self.tied and leg.kind is LegKind.DWELL and leg.duration is not None else 1.0
        self.nlp.minimise(T, weight)
        variables = _LegVariables(T)
        if isinstance(motion, PathLeg):
            assert margins is not None
            (self._tied_path if self.tied or not leg.rail_moves else self._free_path)(leg, motion, margins, variables)
        elif isinstance(motion, JointProfiles):
            self._joint_closed(leg, variables, motion)
        else:
            assert margins is not None
            (self._straight if self.tied else self._joint_nodes)(leg, motion, margins, variables)
        return variables

    def _path_parameters(self, leg: Leg, motion: PathLeg, margins: Margins, k: int) -> Array:
        X = self.axes.in_base(motion.X_0 @ inverse_pose(motion.X_FT))
        X_T = self.axes.in_base(motion.X_0)
        X_1 = self.axes.in_base(motion.X_1)
        axis, angle = axis_angle(X_T[:3, :3].T @ X_1[:3, :3])
        path = PathConstants(
            X_T[:3, 3], X_1[:3, 3] - X_T[:3, 3], X[:3, :3], motion.X_FT[:3, :3] @ axis, angle, motion.X_FT[:3, 3]
        )
        arm = motion.node_arm(self.axes)[k]
        m = margins
        caps = np.array([leg.chord / leg.v_tcp, leg.chord / leg.a_tcp, leg.angle / leg.v_ori]) / m.tool[k]
        V = self.axes.velocity * m.velocity[k]
        V[0] = min(V[0], leg.v_rail)
        return np.r_[
            path.vector(), BranchSigns.from_cfx(motion.cfx).vector(), arm, V,
            self.axes.acceleration * m.acceleration[k], caps, m.position[k, 1:],
        ]  # fmt: skip

    def _chain(self, grid: Array, x: IndexArray, v: IndexArray, a: IndexArray) -> None:
        for k, h in enumerate(np.diff(grid)):
            self.nlp.add(self.stages.chain(), [x[k], v[k], a[k], x[k + 1], v[k + 1]], [h])

    def _zones(self, motion: PathLeg) -> IndexArray:
        """Interval lengths of a path's three zones (run-up, middle, run-out).

        Free on one grid only, so that switches fall on nodes; kept on the finer ones, which saves iterations.
        """
        per_zone = motion.N // 3
        lengths = np.diff(motion.grid)[[0, per_zone, 2 * per_zone]]
        if self.tied or motion.N != FREE_ZONES:
            return self.nlp.variables(lengths, lengths, lengths)
        h = self.nlp.variables(lengths, LEAST_ZONE / per_zone, 0.9 / per_zone)
        self.nlp.add(self.stages.zones(), h, [per_zone])
        return h

    def _zone_chain(self, h: IndexArray, x: IndexArray, v: IndexArray, a: IndexArray) -> None:
        for k in range(len(a)):
            z = [x[k], v[k], a[k], x[k + 1], v[k + 1], h[3 * k // len(a)]]
            self.nlp.add(self.stages.zone_chain(), z)

    def _share(
        self, h: IndexArray | Grid, motion_s: Array, motion_v: Array, motion_a: Array
    ) -> tuple[IndexArray, IndexArray, IndexArray]:
        """Variables of a share going from 0 to 1, at rest at both ends, never backwards."""
        N = len(motion_a)
        low_s, high_s = np.zeros(N + 1), np.ones(N + 1)
        low_s[-1], high_s[0] = 1.0, 0.0
        high_v = np.full(N + 1, 50.0)
        high_v[[0, -1]] = 0.0
        s = self.nlp.variables(motion_s, low_s, high_s)
        v = self.nlp.variables(motion_v, 0.0, high_v)
        a = self.nlp.variables(motion_a, -500.0, 500.0)
        if isinstance(h, Grid):
            self._chain(h.nodes, s, v, a)
        else:
            self._zone_chain(h, s, v, a)
        return s, v, a

    def _free_path(self, leg: Leg, motion: PathLeg, margins: Margins, out: _LegVariables) -> None:
        nlp, N, k0 = self.nlp, motion.N, leg.start
        line = leg.kind is LegKind.LINE
        out.h = self._zones(motion)
        if line:
            out.s, out.v, out.a = self._share(out.h, motion.s, motion.v, motion.a)
        low, high = self._rail_range(margins.position[1:-1, 0])
        inner = nlp.variables(np.clip(motion.d[1:-1], low, high), low, high)
        out.d = np.r_[self.stop_q[k0][0], inner, self.stop_q[k0 + 1][0]]
        out.w = nlp.variables(motion.w, -50.0, 50.0)
        most = np.full(N, 500.0)
        if leg.kind is LegKind.DWELL and leg.duration is not None:
            most = margins.push * self.axes.acceleration[0] * leg.duration**2
        out.b = nlp.variables(np.clip(motion.b, -most, most), -most, most)
        self._zone_chain(out.h, out.d, out.w, out.b)
        nlp.damp(out.b, DAMPING if line else DAMPING_DWELL)
        for node, k in ((0, k0), (N, k0 + 1)):
            nlp.add(self.stages.speed_link(), [self.stop_v[k][0], out.w[node], out.T])
        turning = leg.angle > 1e-9
        for k in range(N + 1):
            sides = _sides(k, N)
            around = [i for i, side in ((k - 1, "l"), (k, "r")) if side in sides]
            p = self._path_parameters(leg, motion, margins, k)
            if line:
                z = [out.s[k], out.v[k], out.d[k], out.w[k], *(x[i] for i in around for x in (out.a, out.b)), out.T]
                nlp.add(self.stages.path_node(sides, turning, False), z, p)
            else:
                z = [out.d[k], out.w[k], *(out.b[i] for i in around), out.T]
                nlp.add(self.stages.dwell_node(sides), z, p)

    def _tied_path(self, leg: Leg, motion: PathLeg, margins: Margins, out: _LegVariables) -> None:
        nlp, N, k0 = self.nlp, motion.N, leg.start
        out.h = self._zones(motion)
        out.s, out.v, out.a = self._share(out.h, motion.s, motion.v, motion.a)
        ends = [self.stop_q[k0][0], self.stop_q[k0 + 1][0]]
        turning = leg.angle > 1e-9
        for k in range(N + 1):
            sides = _sides(k, N)
            around = [i for i, side in ((k - 1, "l"), (k, "r")) if side in sides]
            z = [out.s[k], out.v[k], *(out.a[i] for i in around), *ends, out.T]
            p = self._path_parameters(leg, motion, margins, k)
            nlp.add(self.stages.path_node(sides, turning, True), z, p)

    def _rail_speed(self, leg: Leg) -> Array:
        V = self.axes.velocity.copy()
        V[0] = min(V[0], leg.v_rail)
        return V

    def _joint_closed(self, leg: Leg, out: _LegVariables, motion: JointProfiles) -> None:
        k, V, A = leg.start, self._rail_speed(leg), self.axes.acceleration
        qa, va, qb, vb = self.stop_q[k], self.stop_v[k], self.stop_q[k + 1], self.stop_v[k + 1]
        if self.tied:
            top = self._top(leg, 1.0)
            self.nlp.add(self.stages.trapezoid(), np.r_[top, out.T])
            return
        for j in range(0 if self.axes.has_rail else 1, 7):
            self.nlp.add(self.stages.axis_reach(), [qa[j], va[j], qb[j], vb[j], out.T], [V[j], A[j]])

    def _top(self, leg: Leg, share: float) -> IndexArray:
        """Top speed and acceleration of a straight joint move's common profile; share: how much of each limit."""
        k, V, A = leg.start, self._rail_speed(leg), self.axes.acceleration
        way = np.maximum(np.abs(self.draft.q[k + 1] - self.draft.q[k]), 1e-9)
        v = min(1e3, float(np.min(V / way)))
        a = min(1e4, float(np.min(A / way)))
        top = self.nlp.variables([min(v, np.sqrt(a)), a], [1e-3, 1e-3], [1e4, 1e6])
        for j in range(0 if self.axes.has_rail else 1, 7):
            z = [self.stop_q[k][j], self.stop_q[k + 1][j], *top]
            self.nlp.add(self.stages.straight_axis(), z, [V[j] * share, A[j] * share])
        return top

    def _tool_rows(self, leg: Leg, margins: Margins, k: int) -> list[tuple[ToolRow, float]]:
        caps = (leg.v_tcp, leg.a_tcp, leg.v_ori)
        return [(row, caps[row] * margins.tool[k, row]) for row in ToolRow if margins.rows[k, row]]

    def _joint_nodes(self, leg: Leg, motion: JointNodes, margins: Margins, out: _LegVariables) -> None:
        nlp, N, k0 = self.nlp, motion.N, leg.start
        middle, half = (self.axes.upper + self.axes.lower) / 2, (self.axes.upper - self.axes.lower) / 2
        room = half * margins.position[1:-1]
        inner = nlp.variables(motion.q[1:-1], (middle - room).ravel(), (middle + room).ravel())
        out.q = np.vstack([self.stop_q[k0], inner.reshape(N - 1, 7), self.stop_q[k0 + 1]])
        out.qv = nlp.variables(motion.v, -100.0, 100.0).reshape(N + 1, 7)
        out.qa = nlp.variables(motion.a, -1000.0, 1000.0).reshape(N, 7)
        nlp.damp(out.qa.ravel(), DAMPING)
        V = self._rail_speed(leg)
        for node in out.q[1:-2, 0] if not leg.rail_moves else ():  # the last one follows from the chain
            nlp.add(self.stages.equal(), [self.stop_q[k0][0], node])
        for j in range(7):
            self._chain(motion.grid, out.q[:, j], out.qv[:, j], out.qa[:, j])
            for node, k in ((0, k0), (N, k0 + 1)):
                nlp.add(self.stages.speed_link(), [self.stop_v[k][j], out.qv[node, j], out.T])
        for k in range(N + 1):
            sides = _sides(k, N)
            around = [i for i, side in ((k - 1, "l"), (k, "r")) if side in sides]
            for j in range(7):
                p = [V[j] * margins.velocity[k, j], self.axes.acceleration[j] * margins.acceleration[k, j]]
                nlp.add(self.stages.axis_node(sides), [out.qv[k, j], *(out.qa[i, j] for i in around), out.T], p)
            for row, cap in self._tool_rows(leg, margins, k):
                block = self.stages.tool_row(self.flange, leg.X_FT[:3, 3], row)
                for i in around if row is ToolRow.ACCELERATION else (None,):
                    acc = [] if i is None else out.qa[i]
                    nlp.add(block, np.r_[out.q[k], out.qv[k], acc, out.T].astype(int), [cap])

    def _straight(self, leg: Leg, motion: JointNodes, margins: Margins, out: _LegVariables) -> None:
        nlp, N, k0 = self.nlp, motion.N, leg.start
        s, v, a = share_of(motion)
        out.s, out.v, out.a = self._share(Grid(motion.grid), s, v, a)
        top = self._top(leg, EXACT)
        for k in range(N + 1):
            sides = _sides(k, N)
            around = [i for i, side in ((k - 1, "l"), (k, "r")) if side in sides]
            nlp.add(self.stages.share_node(sides), [out.v[k], *(out.a[i] for i in around), *top, out.T])
            for row, cap in self._tool_rows(leg, margins, k):
                block = self.stages.straight_tool_row(self.flange, leg.X_FT[:3, 3], row)
                for i in around if row is ToolRow.ACCELERATION else (None,):
                    acc = [] if i is None else [out.a[i]]
                    z = np.r_[out.s[k], out.v[k], acc, self.stop_q[k0], self.stop_q[k0 + 1], out.T]
                    nlp.add(block, z.astype(int), [cap])

    # ---- reading back
    def read(self, x: Array) -> Draft:
        """The draft that variables x describe."""
        q, qd = self._polished(np.array([x[i] for i in self.stop_q]), np.array([x[i] for i in self.stop_v]))
        legs: list[LegMotion | None] = []
        for leg, motion, var in zip(self.problem.legs, self.draft.legs, self._legs, strict=True):
            if motion is None:
                legs.append(None)
                continue
            if var is None:  # a dwell in which nothing moves
                legs.append(hold(motion.T, q[leg.start]))
                continue
            T, k = float(x[var.T]), leg.start
            if isinstance(motion, JointProfiles):
                legs.append(self._profiles(leg, q[k], qd[k], q[k + 1], qd[k + 1], T))
            elif isinstance(motion, JointNodes):
                if self.tied:
                    legs.append(straight(T, motion.grid, q[k], q[k + 1], x[var.s], x[var.v], x[var.a]))
                else:
                    nodes, speeds = x[var.q], x[var.qv]
                    nodes[0], nodes[-1], speeds[0], speeds[-1] = q[k], q[k + 1], qd[k] * T, qd[k + 1] * T
                    legs.append(JointNodes(T, motion.grid, nodes, speeds, x[var.qa]))
            else:
                legs.append(self._read_path(leg, motion, var, x, T, q[k], q[k + 1]))
        return Draft(q, qd, self.draft.cfx, tuple(legs))

    def _polished(self, q: Array, qd: Array) -> tuple[Array, Array]:
        """Waypoint states with the arm exactly where the rail puts it; the solver leaves a residual."""
        q, qd = q.copy(), qd.copy()
        for first, *others in self.problem.ties:
            q[others, 0] = q[first, 0]
        for k, stop in enumerate(self.problem.waypoints):
            if stop.q is not None:
                continue
            arm = self.axes.inverse(stop.X_WF[None], q[k, :1])[0, self.draft.cfx[k]]
            q[k, 1:] = arm + 2 * np.pi * np.round((q[k, 1:] - arm) / (2 * np.pi))
            J = self.axes.jacobian(q[k], np.eye(4))
            qd[k, 1:] = -np.linalg.solve(J[:, 1:], J[:, 0]) * qd[k, 0]
        return q, qd

    def _read_path(
        self, leg: Leg, motion: PathLeg, var: _LegVariables, x: Array, T: float, q_0: Array, q_1: Array
    ) -> PathLeg:
        lengths = np.repeat(x[var.h], motion.N // 3)
        motion = replace(motion, grid=np.concatenate([[0.0], np.cumsum(lengths[:-1]), [1.0]]))
        if not len(var.d):
            s, v, a = x[var.s], x[var.v], x[var.a]
            way = q_1[0] - q_0[0]
            return replace(motion, T=T, s=s, v=v, a=a, d=q_0[0] + way * s, w=way * v, b=way * a, reference=q_0[1:])
        s, v, a = (x[var.s], x[var.v], x[var.a]) if len(var.s) else (motion.s, motion.v, motion.a)
        return replace(motion, T=T, s=s, v=v, a=a, d=x[var.d], w=x[var.w], b=x[var.b], reference=q_0[1:])

    def _profiles(self, leg: Leg, q_0: Array, qd_0: Array, q_1: Array, qd_1: Array, T: float) -> JointProfiles:
        V = self._rail_speed(leg)
        # between given states the least time is known in closed form; the solver's T only comes near it
        least = T if leg.duration is not None else 0.0
        return profiles(q_0, qd_0, q_1, qd_1, V, self.axes.acceleration, least, self.tied)
