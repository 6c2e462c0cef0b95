"""The blocks of the timing problem: what one node of a line, a dwell, a joint move or a stop must fulfil.

Time is scaled within each leg: tau in [0, 1], real time t = T tau, so v' = T v and a' = T^2 a. Within an interval the
acceleration is constant and the integrator exact. Positions on lines come from the closed-form inverse kinematics on
a fixed branch, so the tool never leaves its line whatever the iterate. Rows that compare with a limit are ratios.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import casadi as ca
import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.optimize.blocks import Block, make_block
from trajopt_cli.problem.problem import Coupling
from trajopt_cli.robot.symbolic_inverse import inverse_arm

REACH = 0.999  # largest |sin q3|: the last 0.2 mm of reach, where every derivative used here grows without bound
WRIST = 1e-3  # least |sin q5| on lines and dwells, for the same reason
INF = float("inf")


class ToolRow(IntEnum):
    """The caps on the tool centre point, in the order of Margins.tool."""

    SPEED = 0
    ACCELERATION = 1
    REORIENTATION = 2


@dataclass(frozen=True, eq=False)
class PathConstants:
    """A line (or a resting pose: zero chord and angle) of the flange, in the arm's base frame at rail 0.

    p: flange-carried point that moves straight (the TCP) at s = 0; chord: its way; R: flange rotation at s = 0;
    axis, angle: rotation of the flange frame about a body axis; offset: TCP in the flange frame.
    """

    p: Array
    chord: Array
    R: Array
    axis: Array
    angle: float
    offset: Array

    def vector(self) -> Array:
        """(22,): p, chord, R (column-major), axis, angle, offset."""
        return np.concatenate([self.p, self.chord, self.R.T.ravel(), self.axis, [self.angle], self.offset])


def _flange(path: ca.SX, s: ca.SX, turning: bool) -> tuple[ca.SX, ca.SX]:
    p, chord, R0 = path[0:3], path[3:6], ca.reshape(path[6:15], 3, 3)
    axis, angle, offset = path[15:18], path[18], path[19:22]
    R = R0
    if turning:
        K = ca.skew(axis)
        phi = angle * s
        R = R0 @ (ca.SX.eye(3) + ca.sin(phi) * K + (1 - ca.cos(phi)) * (K @ K))
    return p + s * chord - R @ offset, R


class Stages:
    """The blocks for one robot; rail_axis is the rail's direction in the arm's base frame (zero without a rail).

    forward(q) gives TCP-independent flange position and rotation in the base frame at rail 0, rail included in q.
    """

    def __init__(self, arm: object, rail_axis: Array, lower: Array, upper: Array):
        self.arm, self.rail_axis = arm, ca.DM(np.asarray(rail_axis, dtype=float))
        self.lower, self.upper = np.asarray(lower), np.asarray(upper)
        self._cache: dict[tuple[object, ...], Block] = {}

    def _block(self, key: tuple[object, ...], *arguments: object) -> Block:
        if key not in self._cache:
            self._cache[key] = make_block(f"{key[0]}{len(self._cache)}", *arguments)  # type: ignore[arg-type]
        return self._cache[key]

    def inverse(
        self, path: ca.SX, signs: ca.SX, reference: ca.SX, s: ca.SX, d: ca.SX, turning: bool
    ) -> tuple[ca.SX, ca.SX]:
        """Arm joints (6,) at share s of a path with the rail at d, and sin q3."""
        p, R = _flange(path, s, turning)
        return inverse_arm(self.arm, p - d * self.rail_axis, R, signs, reference)  # type: ignore[arg-type]

    def _joint_rows(self, q, qd, qdds, s3, T, V, A, signs, room):  # type: ignore[no-untyped-def]
        middle, half = (self.upper + self.lower)[1:] / 2, (self.upper - self.lower)[1:] / 2
        rows = [((q - middle) / (half * room), -1.0, 1.0)]
        rows += [(s3, -REACH, REACH), (signs[2] * ca.sin(q[4]), WRIST, INF)]
        rows += [(qd / (V[1:] * T), -1.0, 1.0)]
        rows += [(qdd / (A[1:] * T * T), -1.0, 1.0) for qdd in qdds]
        return rows

    # parameters of path nodes: path 22, signs 3, reference 6, V 7, A 7, caps (length/v_cap, length/a_cap, angle/v_ori),
    # room 6: share of each arm joint's range that may be used
    N_PATH = 22 + 3 + 6 + 7 + 7 + 3 + 6

    def path_node(self, sides: str, turning: bool, coupling: Coupling) -> Block:
        """One node of a line. sides: which accelerations act there, "l", "r" or "lr".

        z: free: s, v, d, w, then a, b per side, T. Coordinated: s, v, a per side, d0, d1, T and d = d0 + s (d1 - d0).
        """

        def rows(z: ca.SX, p: ca.SX):  # type: ignore[no-untyped-def]
            path, signs, ref = p[0:22], p[22:25], p[25:31]
            V, A, caps, room = p[31:38], p[38:45], p[45:48], p[48:54]
            n = len(sides)
            if coupling is Coupling.COORDINATED:
                s, v, acc = z[0], z[1], [z[2 + i] for i in range(n)]
                d0, d1, T = z[2 + n], z[3 + n], z[4 + n]
                d, w = d0 + s * (d1 - d0), v * (d1 - d0)
                rail_acc = [a * (d1 - d0) for a in acc]
            else:
                s, v, d, w = z[0], z[1], z[2], z[3]
                acc, rail_acc = [z[4 + 2 * i] for i in range(n)], [z[5 + 2 * i] for i in range(n)]
                T = z[4 + 2 * n]
            S, D = ca.SX.sym("S"), ca.SX.sym("D")
            q, s3 = self.inverse(path, signs, ref, S, D, turning)
            x = ca.vertcat(S, D)
            J = ca.jacobian(q, x)
            dx = ca.SX.sym("dx", 2)
            curve = ca.jtimes(J @ dx, x, dx)
            rate = ca.vertcat(v, w)
            q, s3, J, curve = ca.substitute([q, s3, J, curve], [x, dx], [ca.vertcat(s, d), rate])
            qd = J @ rate
            qdds = [curve + J @ ca.vertcat(a, b) for a, b in zip(acc, rail_acc, strict=True)]
            out = self._joint_rows(q, qd, qdds, s3, T, V, A, signs, room)
            out += [(ca.vertcat(caps[0] * v / T, caps[2] * v / T), -1.0, 1.0)]
            out += [(w / (V[0] * T), -1.0, 1.0)]
            for a, b in zip(acc, rail_acc, strict=True):
                out += [(caps[1] * a / (T * T), -1.0, 1.0), (b / (A[0] * T * T), -1.0, 1.0)]
            return out

        n = len(sides)
        size = (5 + n) if coupling is Coupling.COORDINATED else (5 + 2 * n)
        return self._block(("path", sides, turning, coupling), size, self.N_PATH, rows)

    def dwell_node(self, sides: str) -> Block:
        """One node of a dwell with a free rail. z: d, w, b per side, T."""

        def rows(z: ca.SX, p: ca.SX):  # type: ignore[no-untyped-def]
            path, signs, ref, V, A, room = p[0:22], p[22:25], p[25:31], p[31:38], p[38:45], p[48:54]
            n = len(sides)
            d, w, acc, T = z[0], z[1], [z[2 + i] for i in range(n)], z[2 + n]
            D, dD = ca.SX.sym("D"), ca.SX.sym("dD")
            q, s3 = self.inverse(path, signs, ref, ca.SX(0), D, False)
            J = ca.jacobian(q, D)
            curve = ca.jacobian(J, D) * dD**2
            q, s3, J, curve = ca.substitute([q, s3, J, curve], [D, dD], [d, w])
            out = self._joint_rows(q, J * w, [curve + J * b for b in acc], s3, T, V, A, signs, room)
            out += [(w / (V[0] * T), -1.0, 1.0)] + [(b / (A[0] * T * T), -1.0, 1.0) for b in acc]
            return out

        return self._block(("dwell", sides), 3 + len(sides), self.N_PATH, rows)

    def stop(self) -> Block:
        """A pose held by the tool. z: d, w [m/s], Q (6), Qd (6); p: path 22, signs 3, reference 6."""

        def rows(z: ca.SX, p: ca.SX):  # type: ignore[no-untyped-def]
            q, s3 = self.inverse(p[0:22], p[22:25], p[25:31], ca.SX(0), z[0], False)
            rate = ca.jacobian(q, z[0])
            s5 = p[24] * ca.sin(q[4])
            return [(z[2:8] - q, 0.0, 0.0), (z[8:14] - rate * z[1], 0.0, 0.0), (s3, -REACH, REACH), (s5, WRIST, INF)]

        return self._block(("stop",), 14, 31, rows)

    def resting_stop(self) -> Block:
        """A pose held with every axis at rest. z: d, Q (6); p as for stop."""

        def rows(z: ca.SX, p: ca.SX):  # type: ignore[no-untyped-def]
            q, s3 = self.inverse(p[0:22], p[22:25], p[25:31], ca.SX(0), z[0], False)
            return [(z[1:7] - q, 0.0, 0.0), (s3, -REACH, REACH), (p[24] * ca.sin(q[4]), WRIST, INF)]

        return self._block(("resting",), 7, 31, rows)

    def equal(self) -> Block:
        """Two variables that agree."""
        return self._block(("equal",), 2, 0, lambda z, p: [(z[0] - z[1], 0.0, 0.0)])

    def chain(self) -> Block:
        """Exact integration over one interval. z: x0, v0, a, x1, v1 (scaled); p: interval length h in tau."""

        def rows(z: ca.SX, p: ca.SX):  # type: ignore[no-untyped-def]
            h = p[0]
            return [(z[3] - z[0] - h * z[1] - h * h / 2 * z[2], 0.0, 0.0), (z[4] - z[1] - h * z[2], 0.0, 0.0)]

        return self._block(("chain",), 5, 1, rows)

    def zone_chain(self) -> Block:
        """The same over an interval whose length is free. z: x0, v0, a, x1, v1, h."""

        def rows(z: ca.SX, p: ca.SX):  # type: ignore[no-untyped-def]
            h = z[5]
            return [(z[3] - z[0] - h * z[1] - h * h / 2 * z[2], 0.0, 0.0), (z[4] - z[1] - h * z[2], 0.0, 0.0)]

        return self._block(("zone",), 6, 0, rows)

    def zones(self) -> Block:
        """Three zones fill the leg. z: their interval lengths; p: intervals per zone."""
        return self._block(("zones",), 3, 1, lambda z, p: [(p[0] * (z[0] + z[1] + z[2]) - 1.0, 0.0, 0.0)])

    def speed_link(self) -> Block:
        """A stop's real speed is a leg's scaled end speed over its time. z: real speed, scaled speed, T."""
        return self._block(("link",), 3, 0, lambda z, p: [(z[0] * z[2] - z[1], 0.0, 0.0)])

    def axis_reach(self) -> Block:
        """A synchronised joint move of one axis. z: q_a, v_a, q_b, v_b (real), T; p: V, A."""

        def rows(z: ca.SX, p: ca.SX):  # type: ignore[no-untyped-def]
            qa, va, qb, vb, T = (z[i] for i in range(5))
            V, A = p[0], p[1]

            def most(v0: ca.SX, v1: ca.SX) -> ca.SX:
                peak = (v0 + v1 + A * T) / 2
                return (2 * peak**2 - v0**2 - v1**2) / (2 * A) - ca.fmax(peak - V, 0) ** 2 / A

            return [
                (most(va, vb) - (qb - qa), 0.0, INF),
                (most(-va, -vb) + (qb - qa), 0.0, INF),
                (A * T - (vb - va), 0.0, INF),
                (A * T + (vb - va), 0.0, INF),
            ]

        return self._block(("reach",), 5, 2, rows)

    def axis_node(self, sides: str) -> Block:
        """Speed and acceleration ratios of one axis at a node. z: v', a' per side, T; p: V, A."""

        def rows(z: ca.SX, p: ca.SX):  # type: ignore[no-untyped-def]
            n = len(sides)
            T = z[1 + n]
            return [(z[0] / (p[0] * T), -1.0, 1.0)] + [(z[1 + i] / (p[1] * T * T), -1.0, 1.0) for i in range(n)]

        return self._block(("axis", sides), 2 + len(sides), 2, rows)

    def tool_row(self, flange: ca.Function, offset: Array, kind: ToolRow) -> Block:
        """One TCP cap at a node of a free joint move, as a squared ratio so that it stays smooth where the tool rests.

        z: q 7, v' 7, then a' 7 for the acceleration, T; p: the cap. flange: q 7 -> p, R in the base frame.
        """

        def rows(z: ca.SX, p: ca.SX):  # type: ignore[no-untyped-def]
            a = z[14:21] if kind is ToolRow.ACCELERATION else None
            return [self._tool(flange, offset, kind, z[0:7], z[7:14], a, z[z.numel() - 1], p[0])]

        size = 22 if kind is ToolRow.ACCELERATION else 15
        return self._block(("tool", kind.name, *np.round(offset, 9)), size, 1, rows)

    def straight_tool_row(self, flange: ca.Function, offset: Array, kind: ToolRow) -> Block:
        """The same on a move straight in joint space. z: s, v', a' for the acceleration, q_a 7, q_b 7, T; p: cap."""

        def rows(z: ca.SX, p: ca.SX):  # type: ignore[no-untyped-def]
            n = 1 if kind is ToolRow.ACCELERATION else 0
            qa, qb, T = z[2 + n : 9 + n], z[9 + n : 16 + n], z[16 + n]
            way = qb - qa
            a = way * z[2] if n else None
            return [self._tool(flange, offset, kind, qa + z[0] * way, way * z[1], a, T, p[0])]

        size = 18 if kind is ToolRow.ACCELERATION else 17
        return self._block(("straight", kind.name, *np.round(offset, 9)), size, 1, rows)

    def _tool(self, flange, offset, kind, q, v, a, T, cap):  # type: ignore[no-untyped-def]
        Q, dQ = ca.SX.sym("Q", 7), ca.SX.sym("dQ", 7)
        pos, R = flange(Q)
        if kind is ToolRow.REORIENTATION:
            spin = R.T @ ca.reshape(ca.jtimes(ca.vec(R), Q, dQ), 3, 3)
            omega = ca.substitute(ca.vertcat(spin[2, 1], spin[0, 2], spin[1, 0]), ca.vertcat(Q, dQ), ca.vertcat(q, v))
            return ca.sumsqr(omega) / (cap * T) ** 2, -INF, 1.0
        tcp = pos + R @ ca.DM(offset)
        rate = ca.jtimes(tcp, Q, dQ)
        if kind is ToolRow.SPEED:
            rate = ca.substitute(rate, ca.vertcat(Q, dQ), ca.vertcat(q, v))
            return ca.sumsqr(rate) / (cap * T) ** 2, -INF, 1.0
        acc = ca.jtimes(rate, Q, dQ) + ca.jtimes(tcp, Q, a)
        acc = ca.substitute(acc, ca.vertcat(Q, dQ), ca.vertcat(q, v))
        return ca.sumsqr(acc) / (cap * T * T) ** 2, -INF, 1.0

    def share_node(self, sides: str) -> Block:
        """Common profile of a straight joint move at a node. z: v', a' per side, top speed, top acceleration, T."""

        def rows(z: ca.SX, p: ca.SX):  # type: ignore[no-untyped-def]
            n = len(sides)
            top_v, top_a, T = z[1 + n], z[2 + n], z[3 + n]
            out = [(top_v * T - z[0], 0.0, INF)]
            for i in range(n):
                out += [(top_a * T * T - z[1 + i], 0.0, INF), (top_a * T * T + z[1 + i], 0.0, INF)]
            return out

        return self._block(("share", sides), 4 + len(sides), 0, rows)

    def straight_axis(self) -> Block:
        """Top speed and acceleration of the common profile for one axis. z: q_a, q_b, top speed, top acc.; p: V, A."""

        def rows(z: ca.SX, p: ca.SX):  # type: ignore[no-untyped-def]
            way = z[1] - z[0]
            return [(way * z[2] / p[0], -1.0, 1.0), (way * z[3] / p[1], -1.0, 1.0)]

        return self._block(("way",), 4, 2, rows)

    def trapezoid(self) -> Block:
        """A common trapezoid without tool caps lasts long enough. z: top speed, top acceleration (of the share), T."""
        return self._block(("trapezoid",), 3, 0, lambda z, p: [(z[2] - 1 / z[0] - z[0] / z[1], 0.0, INF)])
