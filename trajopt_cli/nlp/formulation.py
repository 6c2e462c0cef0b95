"""The timing problem as mathematics, top to bottom. docs/mathematics.md names the symbols and says what holds where.

    min   sum T  over all legs                            + damping / 2 * accelerations^2 where the time does not care
    s.t.  dynamics      x_1 = x_0 + h x_0' + h^2/2 x'',   x_1' = x_0' + h x''       exact, x'' constant per interval
          path          arm = IK(X(s), d) on a fixed branch, within reach, off singularities, within ranges
          limits        |qd| <= V,  |qdd| <= A,  tool within its caps               at both ends of every interval
          torques       |M(q) qdd + C(q, qd) qd + g(q)| <= limit, where asked for   at both ends of every interval
          boundary      waypoints hold their pose or joints, legs begin and end at their velocities
          ties          waypoints that share one rail position

Time is scaled within each leg: tau in [0, 1], real time t = T tau, so x' = T xd and x'' = T^2 xdd. Share and rail are
(s, v, a) and (d, w, b) with their derivatives by tau. Positions on paths come from the closed-form inverse kinematics,
so the tool never leaves its line whatever the iterate. A turn of the tool about its axis is one more d, after rails.
Rows that compare with a limit are ratios.
"""

from __future__ import annotations

from collections.abc import Hashable
from functools import cached_property
from types import SimpleNamespace

import casadi as ca

from trajopt_cli.native.store import exact
from trajopt_cli.nlp.block_cache import Library
from trajopt_cli.nlp.block_cache import library as users_library
from trajopt_cli.nlp.constraint import Relation, Rows, Shapes
from trajopt_cli.path.line import LineSymbols
from trajopt_cli.path.symbols import Flange, Symbols, rotated
from trajopt_cli.robot.symbolic import Reached
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.limits import limits_of
from trajopt_cli.trajectories.limits.joint_range import JointRange
from trajopt_cli.trajectories.limits.limit import INF, Limit, NodeMotion, Row, Share

DWELL, JOINTS = "dwell", "joints"
_REST = LineSymbols(turning=False)  # where the tool rests it is on a line of no length
_PASSED = LineSymbols()
OwnShapes = dict[str, tuple[int, ...]]
Place = Symbols | str
"""Where a node is: on a path of some kind, in a dwell, or in a joint move on a grid."""

LEFT, RIGHT = "l", "r"  # the intervals that end and begin at a node


def beside(**shapes: tuple[int, ...]) -> dict[str, dict[str, tuple[int, ...]]]:
    """Shapes of accelerations or jerks by the side on which they act: beside(a=())["lr"] is {"a_l": (), "a_r": ()}."""
    return {
        sides: {f"{name}_{side}": shape for side in sides for name, shape in shapes.items()}
        for sides in ("", LEFT, RIGHT, LEFT + RIGHT)
    }


class Formulation:
    """The relations of one plant's problem. Each is compiled once, on first use, and holds at many nodes.

    turning: those of a tool that may be turned about its axis: d has one more element then, behind the rails.
    """

    def __init__(self, axes: Axes, library: Library | None = None, turning: bool = False):
        self.axes, layout = axes, axes.layout
        self._library = library or users_library()
        self.lower, self.upper = axes.lower[layout.arm], axes.upper[layout.arm]
        self.rail_axis = ca.DM(axes.rail_axis)
        self.rail, self.arm = layout.rail, layout.arm
        self._all, self._joints, self._rails = (axes.n,), (layout.joints,), (layout.r + turning,)
        # what every relation is made from, besides its own key
        self.couplings = axes.couplings
        ranges = self.lower, self.upper, *((axes.couplings,) if axes.couplings else ())
        self._identity = exact((axes.robot, layout.rail, layout.arm, axes.rail_axis, *ranges))
        self._shared = [limit for limit in limits_of(axes) if not limit.apart]
        self._identity += f" {[limit.name for limit in self._shared]}"
        self._cache: dict[tuple[object, ...], Relation] = {}
        self.smooth = axes.jerk is not None
        # parameters of a pose on a path: the path, the branch, joints within half a turn of the answer
        self._on_path: Shapes = {"path": (_REST.size,), "branch": (3,), "near": self._joints}
        if turning:  # its axis and its centre point, in the flange's frame
            self._on_path = {**self._on_path, "axis": (3,), "tcp": (3,)}
        self._turning = turning

    @cached_property
    def with_turns(self) -> Formulation:
        """The relations of a tool that may be turned about its axis."""
        return Formulation(self.axes, self._library, turning=True)

    def _relation(self, key: tuple[object, ...], z: Shapes, p: Shapes, rows: Rows) -> Relation:
        names = (*key, *z)
        if names not in self._cache:  # variables of other names in the same places make the same block
            whole = f"{self._identity} {self.smooth} {key!r} {[*z.values()]!r} {dict(p)!r}"
            self._cache[names] = Relation.of(self._library, str(key[0]), whole, z, p, rows)
        return self._cache[names]

    # ---- dynamics

    def integration(self) -> Relation:
        """x_1 = x_0 + h x_0' + h^2/2 x'' and x_1' = x_0' + h x'' over one interval of given length h. Where jerk is
        limited x''' = j is constant in it instead: all that with h^3/6 j and h^2/2 j more, and x_1'' = x_0'' + h j."""
        rows = _ramped if self.smooth else _integrated
        return self._relation(("chain",), self._states, {"h": ()}, lambda z, p: rows(z, p.h))

    def zoned_integration(self) -> Relation:
        """The same over an interval whose length h is a variable."""
        rows = _ramped if self.smooth else _integrated
        return self._relation(("zone",), {**self._states, "h": ()}, {}, lambda z, p: rows(z, z.h))

    @property
    def _states(self) -> Shapes:
        if self.smooth:
            return {"x_0": (), "v_0": (), "a_0": (), "j": (), "x_1": (), "v_1": (), "a_1": ()}
        return {"x_0": (), "v_0": (), "a": (), "x_1": (), "v_1": ()}

    def zones(self) -> Relation:
        """Run-up, middle and run-out fill the leg: n (h_1 + h_2 + h_3) = 1 with n intervals in each."""
        z: Shapes = {"h": (3,)}
        return self._relation(
            ("zones",), z, {"n": ()}, lambda z, p: [(p.n * (z.h[0] + z.h[1] + z.h[2]) - 1.0, 0.0, 0.0)]
        )

    def sector(self) -> Relation:
        """A turn f stays in its sector all through an interval of length h, as the parabola's inner control point does;
        two of the cubic where jerk is limited. room: half of the sector, its middle at the start, and by how much that
        goes with the share s of the way."""
        z: Shapes = {f"{name}_{end}": () for end in (0, 1) for name in ("f", "w", "s", "v")}

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            h = z.h / (3 if self.smooth else 2)
            before = z.f_0 + h * z.w_0, z.s_0 + h * z.v_0
            behind = z.f_1 - h * z.w_1, z.s_1 - h * z.v_1  # of a parabola the same
            inner = (before, behind) if self.smooth else (before,)
            return [((f - p.room[1] - p.room[2] * s) / p.room[0], -1.0, 1.0) for f, s in inner]

        return self._relation(("sector",), {**z, "h": ()}, {"room": (3,)}, rows)

    # ---- path: where the arm is, and what it may do there

    def _resting(self, p: SimpleNamespace, d: ca.SX) -> Reached:
        """Joints and singularity margins where the flange rests in the path's first pose, rail and turn at d."""
        return self._inverse(_REST.flange(p.path, 0.0), d, p)

    def _inverse(self, flange: Flange, d: ca.SX, p: SimpleNamespace) -> Reached:
        """Joints and singularity margins with the flange on its way, rail and turn at d."""
        position, rotation = flange
        if self._turning:
            rotation = flange.rotation @ rotated(p.axis, d[-1])
            position = position + (flange.rotation - rotation) @ p.tcp
        position = position - self.rail_axis @ self._of_rails(d)
        return self.axes.robot.expressions.inverse(position, rotation, p.branch, p.near)

    def _of_rails(self, d: ca.SX) -> ca.SX:
        """What of d (r,), or (r + 1,) with a turn, belongs to the rails."""
        return d[:-1, 0] if self._turning else d

    def _walls(self, at: Reached) -> list[tuple[ca.SX, float, float]]:
        """|sin q3| <= settings.elbow, |sin q5| >= settings.wrist on the branch's side."""
        settings = self.axes.settings
        return [(at.elbow, -settings.elbow, settings.elbow), (at.wrist, settings.wrist, INF)]

    def sums(self) -> Relation:
        """Sums of axes in their ranges at a waypoint, or at a node of a joint move. room: as for a path's node."""
        z: Shapes = {"q": self._all}
        return self._relation(
            ("sums",), z, {"room": self._all}, lambda z, p: JointRange(self.axes).sum_rows(z.q, p.room)
        )

    def node(self, place: Place, sides: str, weighed: bool = False, tied: bool = False) -> Relation:
        """A node within all limits that are not evaluated apart; on a path or in a dwell arm = IK(X(s), d), too.

        Args:
            place: where the node is.
            sides: the intervals it ends and begins, "l", "r" or "lr", each with an acceleration.
            weighed: with the node's effort, see _weight.
            tied: jerk is limited and the rail is in proportion to the path parameter, d = d_0 + s span.
        """
        z, p = self._at(place, sides, tied)
        for limit in self._shared:
            p |= limit.node_shapes(True, place != JOINTS)
        if weighed:
            z, p = {**z, "e": ()}, {**p, **self._weight(sides)}

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            node, margins = self._motion(place, sides, tied, z, p)
            out = [*margins, *(row for limit in self._shared for row in limit.node_rows(True, node, p))]
            return out + (self._effort(node, z, p) if weighed else [])

        return self._relation(("node", place, len(sides), weighed, tied), z, p, rows)

    def limit_node(self, limit: Limit, kind: Hashable, place: Place, sides: str, tied: bool = False) -> Relation:
        """A limit that is evaluated apart, at a node of such a place; kind: see Limit.node_kind."""
        z, p = self._at(place, sides, tied)
        p |= limit.node_shapes(kind, place != JOINTS)

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            return limit.node_rows(kind, self._motion(place, sides, tied, z, p)[0], p)

        return self._relation((limit.name, kind, place, len(sides), tied), z, p, rows)

    def _at(self, place: Place, sides: str, tied: bool) -> tuple[OwnShapes, OwnShapes]:
        """Variables and parameters of the motion at a node."""
        if place == JOINTS:
            return {"q": self._all, "v": self._all, **self._driving(sides, a=self._all), "T": ()}, {}
        p = dict(self._on_path)
        if place == DWELL:
            return {"d": self._rails, "w": self._rails, **self._driving(sides, b=self._rails), "T": ()}, p
        assert not isinstance(place, str)
        p["path"] = (place.size,)
        if tied:
            return {"s": (), "v": (), **self._driving(sides, a=()), "T": ()}, {
                **p,
                "d_0": self._rails,
                "span": self._rails,
            }
        accelerations = self._driving(sides, a=(), b=self._rails)
        return {"s": (), "v": (), "d": self._rails, "w": self._rails, **accelerations, "T": ()}, p

    def _motion(self, place, sides, tied, z, p):  # type: ignore[no-untyped-def]
        """What limits are asked with, and the singularity margins of the inverse kinematics."""
        ends = len(sides) == 1
        if place == JOINTS:
            acc, jerks = self._accelerations(z, sides, "a")
            return NodeMotion(z.q, z.v, acc, jerks, z.T, slice(0), ends=ends), []
        if place == DWELL:
            rail_acc, jerks = self._accelerations(z, sides, "b")
            at, qd, qdds, qddds = _carried(lambda d: self._resting(p, d), z.d, z.w, rail_acc, jerks)
            return self._joined(z, at, qd, rail_acc, qdds, jerks, qddds, None, ends), self._walls(at)
        if tied:
            z.d, z.w = p.d_0 + z.s * p.span, z.v * p.span
            for name in ("a", *(f"{name}_{side}" for side in sides for name in ("a", "ja"))):
                if hasattr(z, name):
                    setattr(z, name.replace("a", "b"), getattr(z, name) * p.span)

        def placed(x: ca.SX) -> Reached:
            return self._inverse(place.flange(p.path, x[0]), x[1:, 0], p)

        acc, rail_acc, jerks = self._accelerations(z, sides, "a", "b")
        ddxs = [ca.vertcat(a, b) for a, b in zip(acc, rail_acc, strict=True)]
        at, qd, qdds, qddds = _carried(placed, ca.vertcat(z.s, z.d), ca.vertcat(z.v, z.w), ddxs, jerks)
        turn = z.w[-1] if self._turning else None
        share = Share(z.v, acc, place.tangent_rate(p.path, z.s), place.curve(p.path, z.s), turn)
        node = self._joined(z, at, qd, rail_acc, qdds, [j[1:, 0] for j in jerks], qddds, share, ends)
        return node, self._walls(at)

    def _joined(self, z, at, qd, rail_acc, qdds, rail_jerks, qddds, share, ends):  # type: ignore[no-untyped-def]
        """A node's motion of rail and arm."""
        rail_acc, rail_jerks = ([self._of_rails(x) for x in each] for each in (rail_acc, rail_jerks))
        second = [self._in_order(*both) for both in zip(rail_acc, qdds, strict=True)]
        third = [self._in_order(*both) for both in zip(rail_jerks, qddds, strict=True)]
        q, qd = (self._in_order(self._of_rails(d), arm) for d, arm in ((z.d, at.q), (z.w, qd)))
        return NodeMotion(q, qd, second, third, z.T, self.arm, share, ends)

    def _in_order(self, rail: ca.SX, arm: ca.SX) -> ca.SX:
        """All axes (n,) of rail and arm, in the robot's order."""
        return ca.vertcat(arm, rail) if self.arm.start < self.rail.start else ca.vertcat(rail, arm)

    def _driving(self, sides: str, **shapes: tuple[int, ...]) -> dict[str, tuple[int, ...]]:
        """Shapes of what drives a node: accelerations on its sides; where jerk is limited its own accelerations, and
        their jerks, named with a j before, on its sides."""
        if not self.smooth:
            return beside(**shapes)[sides]
        return {**shapes, **beside(**{f"j{name}": shape for name, shape in shapes.items()})[sides]}

    def _accelerations(self, z, sides, *names):  # type: ignore[no-untyped-def]
        """The accelerations of each name, by side unless jerk is limited; and the jerks of all, by side, if it is."""
        if not self.smooth:
            return *([getattr(z, f"{name}_{side}") for side in sides] for name in names), []
        jerks = [ca.vertcat(*(getattr(z, f"j{name}_{side}") for name in names)) for side in sides]
        return *([getattr(z, name)] for name in names), jerks

    # ---- clearance: bodies stay apart

    def clear_axes(self) -> Relation:
        """Tangents of the distances of as many pairs of bodies as may be near: gradient q >= least [m]."""
        return self._relation(
            ("clear",), {"q": self._all}, self._tangents, lambda z, p: [(p.gradient @ z.q - p.least, 0.0, INF)]
        )

    def clear_path(self, place: Place) -> Relation:
        """The same at a node of a path or a dwell: q = (d, IK(X(s), d))."""
        on_path = isinstance(place, Symbols)
        path = place if isinstance(place, Symbols) else _REST

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            d = ca.vec(z.d)
            at = self._inverse(path.flange(p.path, z.s if on_path else 0.0), d, p)
            change = p.gradient[:, self.arm] @ at.q + p.gradient[:, self.rail] @ self._of_rails(d)
            return [(change - p.least, 0.0, INF)]

        p = {**self._on_path, "path": (path.size,), **self._tangents}
        z: Shapes = {"s": (), "d": self._rails} if on_path else {"d": self._rails}
        return self._relation(("clear path", place), z, p, rows)

    @property
    def _tangents(self) -> Shapes:
        settings = self.axes.settings
        return {"gradient": (settings.body_pairs, *self._all), "least": (settings.body_pairs,)}

    # ---- effort: what a motion of a given time is gentle by

    def _weight(self, sides: str) -> dict[str, tuple[int, ...]]:
        """Parameters of a node's effort: h_0, h_1, half of the interval on each side, and unit (n,), the acceleration
        limit of each axis."""
        return {"unit": self._all, **{f"h_{i}": () for i in range(1 if self.smooth else len(sides))}}

    def _effort(self, node: NodeMotion, z: SimpleNamespace, p: SimpleNamespace) -> list[Row]:
        """sum h |q'' / unit|^2 / T^3 <= e over the sides of a node."""
        halves = (getattr(p, f"h_{i}") for i in range(len(node.qdds)))
        total = sum(h * ca.sumsqr(qdd / p.unit) for h, qdd in zip(halves, node.qdds, strict=True))
        return [(total / z.T**3 - z.e, -INF, 0.0)]

    def axes_effort(self) -> Relation:
        """h |q'' / unit|^2 / T^3 <= e in an interval of length h of a joint move on a grid."""
        z: Shapes = {"a": self._all, "T": (), "e": ()}

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            return [(p.h * ca.sumsqr(z.a / p.unit) / z.T**3 - z.e, -INF, 0.0)]

        return self._relation(("effort",), z, {"h": (), "unit": self._all}, rows)

    def elapsed(self) -> Relation:
        """t_1 = t_0 + T over a leg."""
        z: Shapes = {"t_0": (), "T": (), "t_1": ()}
        return self._relation(("elapsed",), z, {}, lambda z, p: [(z.t_1 - z.t_0 - z.T, 0.0, 0.0)])

    def law_interval(self, columns: int) -> Relation:
        """An interval of a path driven with rates r_0, r_1 at its ends, u = (r_1^2 - r_0^2) / 2 step: |slope u +
        bend r^2| <= 1 of `columns` limits at both ends, the time it takes t_1 - t_0 = 2 step / (r_0 + r_1), and its
        effort: the time times the mean of a u^2 + 2 b u r^2 + c r^4 at both ends, squared is (a, b, c)."""
        z: Shapes = {"r_0": (), "r_1": (), "t_0": (), "t_1": (), "e": ()}
        ends = {f"{name}_{end}": (columns,) for end in (0, 1) for name in ("slope", "bend")}
        p = {"step": (), **ends, "squared_0": (3,), "squared_1": (3,)}

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            u, time = (z.r_1**2 - z.r_0**2) / (2 * p.step), 2 * p.step / (z.r_0 + z.r_1)
            x, (a, b) = (z.r_0**2, z.r_1**2), (p.squared_0, p.squared_1)
            squares = [s[0] * u**2 + 2 * s[1] * u * y + s[2] * y**2 for s, y in zip((a, b), x, strict=True)]
            return [
                (p.slope_0 * u + p.bend_0 * x[0], -1.0, 1.0),
                (p.slope_1 * u + p.bend_1 * x[1], -1.0, 1.0),
                (z.t_1 - z.t_0 - time, 0.0, 0.0),
                (time * sum(squares) / 2 - z.e, -INF, 0.0),
            ]

        return self._relation(("law", columns), z, p, rows)

    # ---- limits of joint moves

    def axis_reach(self) -> Relation:
        """One axis gets from q_0 at qd_0 to q_1 at qd_1 in exactly T with |qd| <= V, |qdd| <= A, in closed form:
        D_min <= q_1 - q_0 <= D_max with D_max = (2 u^2 - qd_0^2 - qd_1^2) / 2A - max(u - V, 0)^2 / A,
        u = (qd_0 + qd_1 + A T) / 2, and D_min of the mirrored velocities."""
        z: Shapes = {"q_0": (), "qd_0": (), "q_1": (), "qd_1": (), "T": ()}

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            def most(v0: ca.SX, v1: ca.SX) -> ca.SX:
                peak = (v0 + v1 + p.A * z.T) / 2
                return (2 * peak**2 - v0**2 - v1**2) / (2 * p.A) - ca.fmax(peak - p.V, 0) ** 2 / p.A

            return [
                (most(z.qd_0, z.qd_1) - (z.q_1 - z.q_0), 0.0, INF),
                (most(-z.qd_0, -z.qd_1) + (z.q_1 - z.q_0), 0.0, INF),
                (p.A * z.T - (z.qd_1 - z.qd_0), 0.0, INF),
                (p.A * z.T + (z.qd_1 - z.qd_0), 0.0, INF),
            ]

        return self._relation(("reach",), z, {"V": (), "A": ()}, rows)

    def tool_chord(self) -> Relation:
        """The tool's straight path between two nodes of a joint move <= cap h T, squared: with a limit at the nodes
        alone it might be fast between them. reach: cap h. tcp: the tool centre point in the flange's frame."""
        z: Shapes = {"q_0": self._all, "q_1": self._all, "T": ()}

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            p_0, p_1 = (self._tcp(p.tcp, q) for q in (z.q_0, z.q_1))
            return [(ca.sumsqr(p_1 - p_0) / (p.reach * z.T) ** 2, -INF, 1.0)]

        return self._relation(("chord",), z, {"tcp": (3,), "reach": ()}, rows)

    def _tcp(self, p_FT: ca.SX, q: ca.SX) -> ca.SX:
        pos, R = self.axes.robot.expressions.flange(q)
        return pos + R @ p_FT

    # ---- boundary: waypoints, and legs that begin and end there

    def waypoint(self) -> Relation:
        """The flange rests while the rail passes: q = IK(X, d) and qd = dIK/dd w, real velocities; where jerk is
        limited their derivatives, too."""
        z: Shapes = {"d": self._rails, "w": self._rails, "q": self._joints, "qd": self._joints}
        if self.smooth:
            z = {**z, "b": self._rails, "qdd": self._joints}

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            at, qd, qdds, _ = _carried(lambda d: self._resting(p, d), z.d, z.w, [z.b] if self.smooth else [], [])
            second = [(z.qdd - qdd, 0.0, 0.0) for qdd in qdds]
            return [(z.q - at.q, 0.0, 0.0), (z.qd - qd, 0.0, 0.0), *second, *self._walls(at)]

        return self._relation(("stop",), z, self._on_path, rows)

    def resting_waypoint(self) -> Relation:
        """The flange and all axes rest: q = IK(X, d)."""
        z: Shapes = {"d": self._rails, "q": self._joints}

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            at = self._resting(p, z.d)
            return [(z.q - at.q, 0.0, 0.0), *self._walls(at)]

        return self._relation(("resting",), z, self._on_path, rows)

    def passed_waypoint(self) -> Relation:
        """The tool goes along a path at its start with the rate u by its s, while the rail passes: q = IK(X(0), d) and
        qd = dIK/ds u + dIK/dd w, real velocities."""
        z: Shapes = {"u": (), "d": self._rails, "w": self._rails, "q": self._joints, "qd": self._joints}

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            def placed(x: ca.SX) -> Reached:
                return self._inverse(_PASSED.flange(p.path, x[0]), x[1:, 0], p)

            at, qd, _, _ = _carried(placed, ca.vertcat(0.0, z.d), ca.vertcat(z.u, z.w), [], [])
            return [(z.q - at.q, 0.0, 0.0), (z.qd - qd, 0.0, 0.0), *self._walls(at)]

        return self._relation(("passed",), z, self._on_path, rows)

    def rate_link(self) -> Relation:
        """A path begins or ends at its waypoint's rate: u T = m v, with m of the waypoint's s per s of the path."""
        z: Shapes = {"u": (), "v": (), "T": ()}
        return self._relation(("rate",), z, {"m": ()}, lambda z, p: [(z.u * z.T - p.m * z.v, 0.0, 0.0)])

    def near_point(self) -> Relation:
        """The tool centre point is within a radius of a place in the world. tcp: in the flange's frame."""
        p: Shapes = {"tcp": (3,), "place": (3,), "radius": ()}

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            return [(ca.sumsqr(self._tcp(p.tcp, z.q) - p.place) / p.radius**2, -INF, 1.0)]

        return self._relation(("near",), {"q": self._all}, p, rows)

    def velocity_link(self) -> Relation:
        """A leg begins and ends at its waypoint's real velocity: xd T = x'."""
        z: Shapes = {"xd": (), "v": (), "T": ()}
        return self._relation(("link",), z, {}, lambda z, p: [(z.xd * z.T - z.v, 0.0, 0.0)])

    def acceleration_link(self) -> Relation:
        """And, where jerk is limited, at its acceleration: xdd T^2 = x''."""
        z: Shapes = {"xdd": (), "a": (), "T": ()}
        return self._relation(("link2",), z, {}, lambda z, p: [(z.xdd * z.T**2 - z.a, 0.0, 0.0)])

    # ---- ties

    def equal(self) -> Relation:
        """x = y."""
        return self._relation(("equal",), {"x": (), "y": ()}, {}, lambda z, p: [(z.x - z.y, 0.0, 0.0)])


def _carried(place, x, dx, ddxs, dddxs):  # type: ignore[no-untyped-def]
    """Joints place(x) with their singularity margins, and their derivatives by tau where x has dx, and each of ddxs:
    q' = J x', q'' = J x'' + x'^T H x'; and that one's own derivative at the first of ddxs and each of dddxs."""
    X, dX, ddX = (ca.SX.sym(name, x.numel()) for name in ("X", "dX", "ddX"))
    at = place(X)
    J = ca.jacobian(at.q, X)
    curve = ca.jtimes(J @ dX, X, dX)
    change = ca.SX(0, 1)
    if dddxs:
        second = curve + J @ ddX
        change = ca.jtimes(second, X, dX) + ca.jtimes(second, dX, ddX)
    values = [x, dx, ddxs[0] if ddxs else ca.SX.zeros(x.numel())]
    *there, J, curve, change = ca.substitute([*at, J, curve, change], [X, dX, ddX], values)
    return Reached(*there), J @ dx, [curve + J @ ddx for ddx in ddxs], [change + J @ dddx for dddx in dddxs]


def _ramped(z: SimpleNamespace, h: ca.SX):  # type: ignore[no-untyped-def]
    return [
        (z.x_1 - z.x_0 - h * z.v_0 - h**2 / 2 * z.a_0 - h**3 / 6 * z.j, 0.0, 0.0),
        (z.v_1 - z.v_0 - h * z.a_0 - h**2 / 2 * z.j, 0.0, 0.0),
        (z.a_1 - z.a_0 - h * z.j, 0.0, 0.0),
    ]


def _integrated(z: SimpleNamespace, h: ca.SX):  # type: ignore[no-untyped-def]
    return [(z.x_1 - z.x_0 - h * z.v_0 - h * h / 2 * z.a, 0.0, 0.0), (z.v_1 - z.v_0 - h * z.a, 0.0, 0.0)]
