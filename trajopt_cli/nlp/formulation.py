"""The timing problem as mathematics, top to bottom. docs/mathematics.md names the symbols and says what holds where.

    min   sum T  over all legs                            + DAMPING / 2 * accelerations^2 where the time does not care
    s.t.  dynamics      x_1 = x_0 + h x_0' + h^2/2 x'',   x_1' = x_0' + h x''       exact, x'' constant per interval
          path          arm = IK(X(s), d) on a fixed branch, within reach, off singularities, within ranges
          limits        |qd| <= V,  |qdd| <= A,  tool within its caps               at both ends of every interval
          torques       |M(q) qdd + C(q, qd) qd + g(q)| <= limit, where asked for   at both ends of every interval
          boundary      waypoints hold their pose or joints, legs begin and end at their velocities
          ties          waypoints that share one rail position

Time is scaled within each leg: tau in [0, 1], real time t = T tau, so x' = T xd and x'' = T^2 xdd. Share and rail are
(s, v, a) and (d, w, b) with their derivatives by tau. Positions on paths come from the closed-form inverse kinematics,
so the tool never leaves its line whatever the iterate. Rows that compare with a limit are ratios.
"""

from __future__ import annotations

from enum import IntEnum
from types import SimpleNamespace

import casadi as ca
import numpy as np

from trajopt_cli.limits import Couplings
from trajopt_cli.native.store import exact
from trajopt_cli.nlp.block_cache import Library
from trajopt_cli.nlp.block_cache import library as users_library
from trajopt_cli.nlp.constraint import Relation, Rows, Shapes
from trajopt_cli.path.arc import ArcSymbols
from trajopt_cli.path.dwell import DwellSymbols
from trajopt_cli.path.line import LineSymbols
from trajopt_cli.path.turning import TurningSymbols
from trajopt_cli.robot.dynamics import GRAVITY
from trajopt_cli.robot.symbolic import Reached
from trajopt_cli.robot.symbolic_dynamics import LOAD, torques
from trajopt_cli.settings import ELBOW, PAIRS, STILL_NODE, WRIST
from trajopt_cli.trajectories.axes import Axes

Track = LineSymbols | ArcSymbols | TurningSymbols

INF = float("inf")
LEFT, RIGHT = "l", "r"  # the intervals that end and begin at a node


class ToolCap(IntEnum):
    """The caps on the tool centre point, in the order of Margins.tool."""

    SPEED = 0
    ACCELERATION = 1
    REORIENTATION = 2


def beside(**shapes: tuple[int, ...]) -> dict[str, dict[str, tuple[int, ...]]]:
    """Shapes of accelerations or jerks by the side on which they act: beside(a=())["lr"] is {"a_l": (), "a_r": ()}."""
    return {
        sides: {f"{name}_{side}": shape for side in sides for name, shape in shapes.items()}
        for sides in ("", LEFT, RIGHT, LEFT + RIGHT)
    }


class Formulation:
    """The relations of one plant's problem. Each is compiled once, on first use, and holds at many nodes."""

    def __init__(self, axes: Axes, library: Library | None = None):
        self.axes, layout = axes, axes.layout
        self._library = library or users_library()
        self.lower, self.upper = axes.lower[layout.arm], axes.upper[layout.arm]
        self.rail_axis = ca.DM(axes.rail_axis)
        self.rail, self.arm = layout.rail, layout.arm
        self._all, self._joints, self._rails = (axes.n,), (layout.joints,), (layout.r,)
        # what every relation is made from, besides its own key
        self.couplings = axes.couplings
        ranges = self.lower, self.upper, *((axes.couplings,) if axes.couplings else ())
        self._identity = exact((axes.robot, layout.rail, layout.arm, axes.rail_axis, *ranges))
        self._cache: dict[tuple[object, ...], Relation] = {}
        self.smooth = axes.jerk is not None
        self._limited = () if axes.torque is None else axes.torque.limited
        # parameters of a pose on a path: the path, the branch, joints within half a turn of the answer
        self._on_path: Shapes = {"path": (DwellSymbols().size,), "branch": (3,), "near": self._joints}
        # and of a node: limits; s the tool would take at its caps for the whole way, s^2 for the acceleration; the
        # share of each joint's range that may be used
        self._limit_of_jerk: dict[str, tuple[int, ...]] = {"jerk": self._all} if self.smooth else {}
        self._at_node: Shapes = {
            **self._on_path, "V": self._all, "A": self._all, "at_speed": (), "at_acceleration": (), "at_turning": (),
            "room": self._joints, **self._limit_of_jerk,
        }  # fmt: skip

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
        return self._relation(("chain",), self._chain, {"h": ()}, lambda z, p: rows(z, p.h))

    def zoned_integration(self) -> Relation:
        """The same over an interval whose length h is a variable."""
        rows = _ramped if self.smooth else _integrated
        return self._relation(("zone",), {**self._chain, "h": ()}, {}, lambda z, p: rows(z, z.h))

    @property
    def _chain(self) -> Shapes:
        if self.smooth:
            return {"x_0": (), "v_0": (), "a_0": (), "j": (), "x_1": (), "v_1": (), "a_1": ()}
        return {"x_0": (), "v_0": (), "a": (), "x_1": (), "v_1": ()}

    def zones(self) -> Relation:
        """Run-up, middle and run-out fill the leg: n (h_1 + h_2 + h_3) = 1 with n intervals in each."""
        z: Shapes = {"h": (3,)}
        return self._relation(
            ("zones",), z, {"n": ()}, lambda z, p: [(p.n * (z.h[0] + z.h[1] + z.h[2]) - 1.0, 0.0, 0.0)]
        )

    # ---- path: where the arm is, and what it may do there

    def _resting(self, p: SimpleNamespace, d: ca.SX) -> Reached:
        """Joints and walls where the flange rests in the path's first pose and the rail stands at d."""
        flange = DwellSymbols().flange(p.path)
        return self._inverse(flange.position - self.rail_axis @ d, flange.rotation, p)

    def _inverse(self, position: ca.SX, rotation: ca.SX, p: SimpleNamespace) -> Reached:
        return self.axes.robot.expressions.inverse(position, rotation, p.branch, p.near)

    def _walls(self, at: Reached) -> list[tuple[ca.SX, float, float]]:
        """|sin q3| <= ELBOW, |sin q5| >= WRIST on the branch's side."""
        return [(at.elbow, -ELBOW, ELBOW), (at.wrist, WRIST, INF)]

    def _joint_limits(self, at, qd, qdds, T, p):  # type: ignore[no-untyped-def]
        """Ranges, walls, velocities and accelerations of the arm; qd and qdds by tau."""
        middle, half = (self.upper + self.lower) / 2, (self.upper - self.lower) / 2
        return [
            ((at.q - middle) / (half * p.room), -1.0, 1.0),
            *(self._sums(self.couplings.arm(self.arm), at.q, p.room)),
            *self._walls(at),
            (qd / (p.V[self.arm] * T), -1.0, 1.0),
            *((qdd / (p.A[self.arm] * T * T), -1.0, 1.0) for qdd in qdds),
        ]

    def _sums(self, couplings: Couplings, q: ca.SX, room: ca.SX) -> list[tuple[ca.SX, float, float]]:
        """Sums of axes q in their ranges, of which the least share is in force that any of the axes has."""
        out = []
        for row, low, high in zip(couplings.rows, couplings.lower, couplings.upper, strict=True):
            at = np.flatnonzero(row).tolist()
            total = sum(float(row[i]) * q[i] for i in at) - (low + high) / 2
            out.append((total / ((high - low) / 2 * ca.mmin(ca.vertcat(*(room[i] for i in at)))), -1.0, 1.0))
        return out

    def sums(self) -> Relation:
        """Sums of axes in their ranges at a waypoint, or at a node of a joint move. room: as for a path's node."""
        z: Shapes = {"q": self._all}
        return self._relation(("sums",), z, {"room": self._all}, lambda z, p: self._sums(self.couplings, z.q, p.room))

    def _rail_velocity(self, w: ca.SX, z: SimpleNamespace, p: SimpleNamespace) -> tuple[ca.SX, float, float]:
        return w / (p.V[self.rail] * z.T), -1.0, 1.0

    def _rail_acceleration(self, b: ca.SX, z: SimpleNamespace, p: SimpleNamespace) -> tuple[ca.SX, float, float]:
        return b / (p.A[self.rail] * z.T * z.T), -1.0, 1.0

    def path_node(
        self, track: Track, sides: str, weighed: bool = False, tied: bool = False, along: bool = False
    ) -> Relation:
        """A node of a path: arm = IK(X(s), d) within all limits, the tool within its caps along the way.

        track: the kind of path. sides: the intervals it ends and begins, "l", "r" or "lr", each with an acceleration.
        weighed: with the node's effort, see _weight. tied: jerk is limited and the rail is in proportion to the share,
        d = d_0 + s way. along: speeding up and slowing down of the tool are limited by themselves, from -1 to 1 what is
        left of a / T^2 times p.along[0] less p.along[1].
        """
        weight = self._weight(sides) if weighed else {}
        z: Shapes = {"s": (), "v": (), **self._driving(sides, a=()), "T": ()}
        if tied:
            weight = {**weight, "d_0": self._rails, "way": self._rails}
        else:
            accelerations = self._driving(sides, a=(), b=self._rails)
            z = {"s": (), "v": (), "d": self._rails, "w": self._rails, **accelerations, "T": ()}

        def place(p: SimpleNamespace, x: ca.SX) -> Reached:
            flange = track.flange(p.path, x[0])
            return self._inverse(flange.position - self.rail_axis @ x[1:, 0], flange.rotation, p)

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            if tied:
                z.d, z.w, z.b = p.d_0 + z.s * p.way, z.v * p.way, z.a * p.way
                for side in sides:
                    setattr(z, f"jb_{side}", getattr(z, f"ja_{side}") * p.way)
            acc, rail_acc, jerks = self._accelerations(z, sides, "a", "b")
            ddxs = [ca.vertcat(a, b) for a, b in zip(acc, rail_acc, strict=True)]
            x, dx = ca.vertcat(z.s, z.d), ca.vertcat(z.v, z.w)
            at, qd, qdds, qddds = _carried(lambda x: place(p, x), x, dx, ddxs, jerks)
            out = self._joint_limits(at, qd, qdds, z.T, p) + self._jerk_limits(qddds, jerks, z.T, p)
            out += [(ca.vertcat(p.at_speed * z.v / z.T, p.at_turning * z.v / z.T), -1.0, 1.0)]
            out += [self._rail_velocity(z.w, z, p)]
            for a, b in zip(acc, rail_acc, strict=True):
                out += [self._tool_acceleration(track, a, z, p), self._rail_acceleration(b, z, p)]
                out += [(p.along[0] * a / (z.T * z.T) - p.along[1], -1.0, 1.0)] if along else []
            if isinstance(track, TurningSymbols):  # positioners keep step with the share
                rates = ca.vertcat(p.table[0] * z.v / z.T, *(p.table[1] * a / (z.T * z.T) for a in acc))
                out += [(rates, -1.0, 1.0)]
            return out + (self._effort(qdds, rail_acc, z, p) if weighed else [])

        p = {**self._at_node, "path": (track.size,), **weight}
        if isinstance(track, TurningSymbols):
            p["table"] = (2,)
        if along:
            p["along"] = (2,)
        z = {**z, "e": ()} if weighed else z
        key = "path", track, len(sides), weighed, tied, *(("along",) if along else ())
        return self._relation(key, z, p, rows)

    def _tool_acceleration(self, track, a, z, p):  # type: ignore[no-untyped-def]
        """|L a| <= a_tcp T^2 on a line; on an arc with the part towards the centre, squared."""
        path = p.path
        if isinstance(track, TurningSymbols):  # against the work object
            track, path = track.way, track.layout.split(path)["way"]
        if isinstance(track, LineSymbols):
            return p.at_acceleration * a / (z.T * z.T), -1.0, 1.0
        inward = track.layout.split(path)["sweep"] * z.v**2
        return (p.at_acceleration / z.T**2) ** 2 * (a**2 + inward**2), -INF, 1.0

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

    def _jerk_limits(self, qddds, jerks, T, p):  # type: ignore[no-untyped-def]
        """|jerk| of arm and rail <= p.jerk T^3; the rail's are the last of what drives."""
        rails = self._rails[0]
        out = [(arm / (p.jerk[self.arm] * T**3), -1.0, 1.0) for arm in qddds]
        return out + [(j[j.numel() - rails :, 0] / (p.jerk[self.rail] * T**3), -1.0, 1.0) for j in jerks]

    def dwell_node(self, sides: str, weighed: bool = False) -> Relation:
        """A node of a dwell: the tool rests while the rail moves and the arm makes up for it. weighed: as path_node."""
        z: Shapes = {"d": self._rails, "w": self._rails, **self._driving(sides, b=self._rails), "T": ()}
        weight = self._weight(sides) if weighed else {}

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            acc, jerks = self._accelerations(z, sides, "b")
            at, qd, qdds, qddds = _carried(lambda d: self._resting(p, d), z.d, z.w, acc, jerks)
            out = self._joint_limits(at, qd, qdds, z.T, p) + self._jerk_limits(qddds, jerks, z.T, p)
            out += [self._rail_velocity(z.w, z, p), *(self._rail_acceleration(b, z, p) for b in acc)]
            return out + (self._effort(qdds, acc, z, p) if weighed else [])

        z = {**z, "e": ()} if weighed else z
        return self._relation(("dwell", len(sides), weighed), z, {**self._at_node, **weight}, rows)

    # ---- clearance: bodies stay apart

    def clear_axes(self) -> Relation:
        """Tangents of the distances of as many pairs of bodies as may be near: gradient q >= least [m]."""
        return self._relation(
            ("clear",), {"q": self._all}, self._tangents, lambda z, p: [(p.gradient @ z.q - p.least, 0.0, INF)]
        )

    def clear_path(self, track: Track | None) -> Relation:
        """The same at a node of a path, of a dwell where there is no track: q = (d, IK(X(s), d))."""
        share: Shapes = {} if track is None else {"s": ()}

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            flange = DwellSymbols().flange(p.path) if track is None else track.flange(p.path, z.s)
            d = ca.vec(z.d)
            at = self._inverse(flange.position - self.rail_axis @ d, flange.rotation, p)
            return [(p.gradient[:, self.arm] @ at.q + p.gradient[:, self.rail] @ d - p.least, 0.0, INF)]

        path = (DwellSymbols().size if track is None else track.size,)
        p = {**self._on_path, "path": path, **self._tangents}
        return self._relation(("clear path", track), {**share, "d": self._rails}, p, rows)

    @property
    def _tangents(self) -> Shapes:
        return {"gradient": (PAIRS, *self._all), "least": (PAIRS,)}

    # ---- torques: rows of their own at the same nodes, where they are limited

    def path_torque(self, track: Track, sides: str, tied: bool = False) -> Relation:
        """Torques at a node of a path, see path_node and _torque."""
        p: dict[str, tuple[int, ...]] = {**self._on_path, "path": (track.size,), **self._torque_limits}
        z: Shapes = {"s": (), "v": (), **self._driving(sides, a=()), "T": ()}
        if tied:
            p = {**p, "d_0": self._rails, "way": self._rails}
        else:
            z = {"s": (), "v": (), "d": self._rails, "w": self._rails,
                 **self._driving(sides, a=(), b=self._rails), "T": ()}  # fmt: skip

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            if tied:
                z.d, z.w = p.d_0 + z.s * p.way, z.v * p.way
                for side in [""] if self.smooth else [f"_{side}" for side in sides]:
                    setattr(z, f"b{side}", getattr(z, f"a{side}") * p.way)

            def place(x: ca.SX) -> Reached:
                flange = track.flange(p.path, x[0])
                return self._inverse(flange.position - self.rail_axis @ x[1:, 0], flange.rotation, p)

            acc, rail_acc = (self._by_side(z, sides, name) for name in ("a", "b"))
            ddxs = [ca.vertcat(a, b) for a, b in zip(acc, rail_acc, strict=True)]
            at, qd, qdds, _ = _carried(place, ca.vertcat(z.s, z.d), ca.vertcat(z.v, z.w), ddxs, [])
            moved = [ca.vertcat(b, qdd) for b, qdd in zip(rail_acc, qdds, strict=True)]
            return self._torque(ca.vertcat(z.d, at.q), ca.vertcat(z.w, qd), moved, z.T, p)

        return self._relation(("path torque", track, len(sides), tied, self._limited), z, p, rows)

    def dwell_torque(self, sides: str) -> Relation:
        """Torques at a node of a dwell, see dwell_node and _torque."""
        z: Shapes = {"d": self._rails, "w": self._rails, **self._driving(sides, b=self._rails), "T": ()}

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            acc = self._by_side(z, sides, "b")
            at, qd, qdds, _ = _carried(lambda d: self._resting(p, d), z.d, z.w, acc, [])
            moved = [ca.vertcat(b, qdd) for b, qdd in zip(acc, qdds, strict=True)]
            return self._torque(ca.vertcat(z.d, at.q), ca.vertcat(z.w, qd), moved, z.T, p)

        p = {**self._on_path, **self._torque_limits}
        return self._relation(("dwell torque", len(sides), self._limited), z, p, rows)

    def axes_torque(self, sides: str) -> Relation:
        """Torques at a node of a joint move on a grid, see _torque."""
        z: Shapes = {"q": self._all, "v": self._all, **self._driving(sides, a=self._all), "T": ()}

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            return self._torque(z.q, z.v, self._by_side(z, sides, "a"), z.T, p)

        return self._relation(("axes torque", len(sides), self._limited), z, self._torque_limits, rows)

    def _torque(self, q, qd, qdds, T, p):  # type: ignore[no-untyped-def]
        """|moving / (room T^2) + g| <= limit for the torques beyond gravity of the axes that have a limit, by tau, and
        gravity's g: what gravity leaves is used up to the share room. One by one for each of qdds."""
        assert self.axes.torque is not None
        robot, still = self.axes.torque.plant.robot, ca.SX.zeros(*self._all)
        own = (robot.pin_model, q)
        rest = torques(*own, still, still, GRAVITY, p.load, robot.rotor)
        out = []
        for qdd in qdds:
            moving = torques(*own, qd, qdd, 0.0, p.load, robot.rotor) / (T * T)
            for i in self._limited:
                out.append((moving[i] / (p.limit[i] * p.share[i]) + rest[i] / p.limit[i], -1.0, 1.0))
        return out

    @property
    def _torque_limits(self) -> dict[str, tuple[int, ...]]:
        """Parameters of torques: what the flange carries, limits, and the share of what gravity leaves of them."""
        return {"load": (LOAD,), "limit": self._all, "share": self._all}

    def _by_side(self, z: SimpleNamespace, sides: str, name: str) -> list[ca.SX]:
        """The accelerations of a name, by side unless jerk is limited."""
        return [getattr(z, name)] if self.smooth else [getattr(z, f"{name}_{side}") for side in sides]

    # ---- effort: what a motion of a given time is gentle by

    def _weight(self, sides: str) -> dict[str, tuple[int, ...]]:
        """Parameters of a node's effort: h_0, h_1, half of the interval on each side, and unit (n,), the acceleration
        limit of each axis."""
        return {"unit": self._all, **{f"h_{i}": () for i in range(1 if self.smooth else len(sides))}}

    def _effort(self, qdds, rail_acc, z, p):  # type: ignore[no-untyped-def]
        """sum h |q'' / unit|^2 / T^3 <= e over the sides of a node."""
        shares = ((qdd / p.unit[self.arm], b / p.unit[self.rail]) for qdd, b in zip(qdds, rail_acc, strict=True))
        halves = (getattr(p, f"h_{i}") for i in range(len(qdds)))
        total = sum(h * (ca.sumsqr(arm) + ca.sumsqr(rail)) for h, (arm, rail) in zip(halves, shares, strict=True))
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
        """An interval of a course driven with rates r_0, r_1 at its ends, u = (r_1^2 - r_0^2) / 2 step: |slope u +
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

    def axis_node(self, sides: str) -> Relation:
        """|q'| <= V T and |q''| <= A T^2 of one axis at a node of a joint move on a grid; where jerk is limited, it is
        <= p.jerk T^3."""
        z: Shapes = {"v": (), **self._driving(sides, a=()), "T": ()}
        p: Shapes = {"V": (), "A": (), **({"jerk": ()} if self.smooth else {})}

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            acc, jerks = self._accelerations(z, sides, "a")
            out = [(z.v / (p.V * z.T), -1.0, 1.0), *((a / (p.A * z.T * z.T), -1.0, 1.0) for a in acc)]
            return out + [(j / (p.jerk * z.T**3), -1.0, 1.0) for j in jerks]

        return self._relation(("axis", len(sides)), z, p, rows)

    def tool_cap(self, cap: ToolCap) -> Relation:
        """|tool| <= cap at a node of a joint move, squared so that it stays smooth where the tool rests.

        tcp: the tool centre point in the flange's frame."""
        acceleration: Shapes = {"a": self._all} if cap is ToolCap.ACCELERATION else {}
        z: Shapes = {"q": self._all, "v": self._all, **acceleration, "T": ()}

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            return [self._tool(p.tcp, cap, z.q, z.v, getattr(z, "a", None), z.T, p.cap)]

        return self._relation(("tool", cap.name), z, {"tcp": (3,), "cap": ()}, rows)

    def tool_along(self) -> Relation:
        """-p.ramps[1] <= v a / |v| <= p.ramps[0] of the tool at a node of a joint move: its speeding up and slowing
        down along its path. Below STILL_NODE [m/s] it fades, so that it is smooth where the tool comes to rest."""
        z: Shapes = {"q": self._all, "v": self._all, "a": self._all, "T": ()}

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            rate, acc = self._tool_motion(p.tcp, z.q, z.v, z.a)
            squared = ca.sumsqr(rate) / z.T**2
            size = squared + STILL_NODE**2
            along, share = ca.dot(rate, acc) / z.T**3 / ca.sqrt(size), squared / size
            return [(along / p.ramps[0] - share, -INF, 0.0), (-along / p.ramps[1] - share, -INF, 0.0)]

        return self._relation(("ramps",), z, {"tcp": (3,), "ramps": (2,)}, rows)

    def tool_chord(self) -> Relation:
        """The tool's straight way between two nodes of a joint move <= cap h T, squared: with a limit at the nodes
        alone it might be fast between them. way: cap h. tcp: the tool centre point in the flange's frame."""
        z: Shapes = {"q_0": self._all, "q_1": self._all, "T": ()}

        def rows(z: SimpleNamespace, p: SimpleNamespace):  # type: ignore[no-untyped-def]
            p_0, p_1 = (self._tcp(p.tcp, q) for q in (z.q_0, z.q_1))
            return [(ca.sumsqr(p_1 - p_0) / (p.way * z.T) ** 2, -INF, 1.0)]

        return self._relation(("chord",), z, {"tcp": (3,), "way": ()}, rows)

    def _tcp(self, p_FT: ca.SX, q: ca.SX) -> ca.SX:
        pos, R = self.axes.robot.expressions.flange(q)
        return pos + R @ p_FT

    def _tool(self, p_FT, cap, q, v, a, T, limit):  # type: ignore[no-untyped-def]
        if cap is ToolCap.REORIENTATION:
            Q, dQ = ca.SX.sym("Q", *self._all), ca.SX.sym("dQ", *self._all)
            _, R = self.axes.robot.expressions.flange(Q)
            spin = R.T @ ca.reshape(ca.jtimes(ca.vec(R), Q, dQ), 3, 3)
            omega = ca.substitute(ca.vertcat(spin[2, 1], spin[0, 2], spin[1, 0]), ca.vertcat(Q, dQ), ca.vertcat(q, v))
            return ca.sumsqr(omega) / (limit * T) ** 2, -INF, 1.0
        rate, acc = self._tool_motion(p_FT, q, v, a)
        if cap is ToolCap.SPEED:
            return ca.sumsqr(rate) / (limit * T) ** 2, -INF, 1.0
        return ca.sumsqr(acc) / (limit * T * T) ** 2, -INF, 1.0

    def _tool_motion(self, p_FT, q, v, a):  # type: ignore[no-untyped-def]
        """The tool centre point's first derivative by tau and, where a is given, its second."""
        Q, dQ = ca.SX.sym("Q", *self._all), ca.SX.sym("dQ", *self._all)
        at, here = ca.vertcat(Q, dQ), ca.vertcat(q, v)
        tcp = self._tcp(p_FT, Q)
        rate = ca.jtimes(tcp, Q, dQ)
        if a is None:
            return ca.substitute(rate, at, here), None
        acc = ca.jtimes(rate, Q, dQ) + ca.jtimes(tcp, Q, a)
        return ca.substitute(rate, at, here), ca.substitute(acc, at, here)

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
    """Joints place(x) with their walls, and their derivatives by tau where x has dx, and each of ddxs: q' = J x',
    q'' = J x'' + x'^T H x'; and that one's own derivative at the first of ddxs and each of dddxs."""
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
