"""The least excess that the judge is sure to see in a file, by its rows and its printed digits.

Every check takes off a value what printing and missing rows leave open, so that no legal motion fails; what is left of
an offence must still be beyond the limit and its tolerance. So an offence is sure to be seen where it is beyond both by
twice the doubt: once as it may have been printed, once as it is granted. Here r is a printed step of positions, r_t of
times, v of a limit on speed, a of one on acceleration, H the time of m row spacings, h the widest spacing.

- Mean speed over H: printed (|dq| - r) / (H + r_t), where |dq| is (v + x) (H - r_t) - r at least.
  Seen where x > (v (1 + tol) (H + r_t) + 2 r) / (H - r_t) - v.
- Mean acceleration from speeds printed in steps r_v: the same with a, r_v.
- Second differences over H and H: d = 2 (2 (r + v r_t) / (H - r_t)) / (2 H - r_t) is the doubt about both mean speeds,
  r_t / (2 H - r_t) of the value that about the time they are of: x > (a (1 + tol) + d) H / (H - r_t) + d - a.
- Third ones over j: each second one is off by u = (d (2 H - r_t) + a r_t) / (2 H - 2 r_t), the time they are of by r_t:
  x > (j (1 + tol) (3 H + r_t) + 12 u) / (3 H - r_t) - j.
- A chord of a path whose speed is v and whose acceleration is a is shorter than its arc by (a H / v)^2 / 24 at most.
- Between rows: what is worst at one moment has come and gone no faster than a h^2/8.

An excess that lasts is seen in the rows that lie within it wherever it begins: m spacings and the one that it begins
in. Of the lags that the judge looks at, the shortest is told that shows a hundredth of the limit, else the one that
shows most. docs/judge.md has the same for people.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import inf

import numpy as np

from trajopt_cli.findings import Promise
from trajopt_cli.geometry import Array
from trajopt_cli.judge.continuous_collision import OVERLOOKED
from trajopt_cli.judge.findings import axis_unit
from trajopt_cli.judge.geometry import Arc, Line, lengths
from trajopt_cli.judge.machine import Machine
from trajopt_cli.judge.mechanism import Mechanism
from trajopt_cli.judge.path_segments import runs_of
from trajopt_cli.judge.positioners import unseen_turn
from trajopt_cli.judge.samples import LAGS
from trajopt_cli.judge.tcp_motion import TcpMotion, angular_acceleration
from trajopt_cli.judge.timeline import Timeline
from trajopt_cli.judge.tolerances import (
    COARSEST_PRINT,
    COARSEST_RATE,
    COARSEST_TURN,
    DURATION,
    DWELL,
    HELD,
    JOINT,
    JOINT_TARGET,
    LINE_POSITION,
    LINE_ROTATION,
    REST_LINEAR,
    STOP_POSITION,
    STOP_ROTATION,
    TCP,
    TORQUE,
)
from trajopt_cli.motion import Program
from trajopt_cli.shapes import Shape, outline

_ENOUGH = 0.01  # of a limit: no longer lag is told where one shows this
_DECADES = 15
_SHORT = 1e-9  # s: of a file at rest throughout, whose gaps count for nothing


@dataclass(frozen=True)
class Steps:
    """How many times the printed steps of positions and speeds, and those of times, are what they are in the file."""

    q: float = 1.0
    t: float = 1.0


Least = Callable[[Steps], tuple[float, float | None]]
"""The least excess, and how long it lasts [s]; None for one that is seen whenever it is."""


@dataclass(frozen=True)
class Lags:
    """Times of a file's rows: over m spacings, the shortest H [s] there is, and how long an excess lasts that holds
    rows so far apart wherever it begins [s]."""

    spans: Mapping[int, tuple[float, float]]

    @classmethod
    def of(cls, gaps: Array, beside: float) -> Lags:
        """gaps (n-1,): times between rows, those of a standstill no longer than the others. beside [s]: at the ends of
        the file, where no row counts."""
        t = np.r_[0.0, np.cumsum(gaps)]
        spans = {}
        for rows in sorted({k * m for m in LAGS for k in (1, 2, 3)}):
            if rows + 1 < len(t):
                within = t[1 + rows :] - t[: -1 - rows]
                spans[rows] = float((t[rows:] - t[:-rows]).min()), float(within.max()) + beside
        return cls(spans)

    def best(self, differences: int, top: float, least: Callable[[float], float]) -> tuple[float, float | None]:
        """The least excess by the lag that shows most, or enough of top. differences: 1 for speeds of positions, 2 for
        accelerations. least: by H of each."""
        found: tuple[float, float | None] = (inf, None)
        for m in LAGS:
            if differences * m in self.spans:
                x = least(self.spans[differences * m][0] / differences)
                if x < found[0]:
                    found = x, self.spans[differences * m][1]
                if x <= _ENOUGH * top:
                    break
        return found


def mean_rate(top: float, tolerance: float, H: float, r: float, r_t: float) -> float:
    """The least excess of a mean rate over H between two values printed in steps r."""
    return (top * (1 + tolerance) * (H + r_t) + 2 * r) / (H - r_t) - top if r_t < H else inf


def _both(H: float, r: float, speed: float, r_t: float) -> float:
    """The doubt that both mean speeds bring into a second divided difference over H and H."""
    return 4 * (r + speed * r_t) / (H - r_t) / (2 * H - r_t)


def second(top: float, tolerance: float, H: float, r: float, speed: float, r_t: float) -> float:
    """The least excess of a second divided difference over H and H of values printed in steps r."""
    if r_t >= H:
        return inf
    d = _both(H, r, speed, r_t)
    return (top * (1 + tolerance) + d) * H / (H - r_t) + d - top


def third(top: float, tolerance: float, H: float, r: float, speed: float, acceleration: float, r_t: float) -> float:
    """The least excess of a third divided difference over H, H and H."""
    if r_t >= H:
        return inf
    u = (_both(H, r, speed, r_t) * (2 * H - r_t) + acceleration * r_t) / (2 * H - 2 * r_t)
    return (top * (1 + tolerance) * (3 * H + r_t) + 12 * u) / (3 * H - r_t) - top


def chord(top: float, acceleration: float, H: float) -> float:
    """How much less than a speed its mean over H may be, as the way bends."""
    return top * (acceleration * H / top) ** 2 / 24


class Promises:
    """What the judge promises of one file. swing: what torques are granted by axis; lever (k,): how far from every axis
    a point of the robot may be [m], 1 on a rail. told False: finer digits are named only where the file's are too
    coarse for a check."""

    def __init__(
        self,
        line: Timeline,
        frames: Mapping[bytes, TcpMotion],
        swing: Mapping[str, float],
        lever: Sequence[float],
        told: bool = True,
    ):
        rows = line.rows
        self._line, self._rows, self._plant, self._lever = line, rows, rows.plant, np.array(lever)
        self._frames, self._swing, self._all = frames, swing, told
        self._h, self._tau = max(float(rows.longest.max()), _SHORT), float(rows.open_time.max())
        self._r, self._r_v = rows.doubt_q.max(axis=0), rows.doubt_v.max(axis=0)
        # times of a grid are exact, but for the first and the last one: an excess is seen without those two as well
        ends = len(rows.t) > 4 and float(rows.step_t[1:-1].max()) < rows.doubt_t
        inner = slice(1, -1) if ends else slice(None)
        self._r_t = float(rows.step_t[inner].max())
        self._lags = Lags.of(rows.gaps[inner], 2 * self._h if ends else 0.0)
        self._p = max(float(frame.doubt_p.max()) for frame in frames.values())
        self._R = max(float(frame.doubt_R.max()) for frame in frames.values())
        self._V = self._W = 0.0
        if rows.qd is not None:
            self._V, self._W = (
                max(float(frame.doubt_V[i][:].max()) for frame in frames.values()) for i in (0, 1)
            )  # fmt: skip

    @property
    def rate(self) -> float | None:
        """Rows in a second, of a file whose boundaries lie between rows; else None."""
        every = float(np.median(self._rows.gaps))
        return None if self._rows.marked or every == 0.0 else 1 / every

    def told(self, program: Program) -> tuple[Promise, ...]:
        """All that the judge promises of this file. program: what turns the tables in it."""
        return (*self.measured, *self._of_time(), *self._tables(program), *self._clearance())

    @cached_property
    def measured(self) -> tuple[Promise, ...]:
        """What finer digits would show better."""
        return (*self._axes(), *self._tool(), *self._stops())

    def _promise(
        self, check: str, subject: str, unit: str, least: Least, most: float | None = None, rate: int = 0,
        axis: float | None = None,
    ) -> Promise:  # fmt: skip
        """most: the greatest excess to be seen of a file that is judged at all. rate: 1 for a speed, 2 for an
        acceleration, 3 for a jerk. axis: the printed step of the one axis that it depends on."""
        value, lasting = least(Steps())
        needs: list[tuple[str, float]] = []
        # else nobody asks, or no digits help: rows are too few
        if most is not None and (self._all or value >= most) and least(Steps(0.0, 0.0))[0] < most:
            digits = "positions" if rate == 0 or self._rows.qd is None else "speeds"
            step = float((self._r if digits == "positions" else self._r_v).max()) if axis is None else axis
            for name, one, finer in (
                (digits, step, lambda x: least(Steps(x, 0.0))[0]),
                ("times", self._r_t, lambda x: least(Steps(0.0, x))[0]),
            ):
                if (needed := _needed(one, finer, most)) is not None:
                    needs.append((name, needed))
        return Promise(check, subject, value, unit, lasting, most, tuple(needs))

    def _axes(self) -> Iterator[Promise]:
        rows, limits, lags = self._rows, self._plant.limits, self._lags
        for j, name in enumerate(limits.names):
            v, a, unit = float(limits.velocity[j]), float(limits.acceleration[j]), axis_unit(name)
            r, r_v, span = float(self._r[j]), float(self._r_v[j]), float(limits.upper[j] - limits.lower[j])

            def position(n: Steps, r: float = r, a: float = a, span: float = span) -> tuple[float, None]:
                return JOINT * span + n.q * r + a * self._h**2 / 8, None

            def speed(n: Steps, r: float = r, r_v: float = r_v, v: float = v) -> tuple[float, float | None]:
                found = lags.best(1, v, lambda H: mean_rate(v, JOINT, H, n.q * r, n.t * self._r_t))
                if rows.qd is None:
                    return found
                return min(found, (v * JOINT + 1.5 * n.q * r_v, self._h), key=lambda one: (one[0] > _ENOUGH * v, one))

            def acceleration(
                n: Steps, r: float = r, r_v: float = r_v, v: float = v, a: float = a
            ) -> tuple[float, float | None]:
                if rows.qd is not None:
                    return lags.best(1, a, lambda H: mean_rate(a, JOINT, H, n.q * r_v, n.t * self._r_t))
                return lags.best(2, a, lambda H: second(a, JOINT, H, n.q * r, v, n.t * self._r_t))

            digits = r if rows.qd is None else r_v
            yield self._promise("joint position", name, unit, position)
            yield self._promise("joint speed", name, f"{unit}/s", speed, COARSEST_RATE * v, 1, digits)
            yield self._promise(
                "joint acceleration", name, f"{unit}/s2", acceleration, 2 * COARSEST_RATE * a, 2, digits
            )
            if limits.binding_jerk is not None:
                top = float(limits.binding_jerk[j])

                def jerk(
                    n: Steps, r: float = r, r_v: float = r_v, v: float = v, a: float = a, top: float = top
                ) -> tuple[float, float | None]:
                    if rows.qd is not None:
                        return lags.best(2, top, lambda H: second(top, JOINT, H, n.q * r_v, a, n.t * self._r_t))
                    return lags.best(3, top, lambda H: third(top, JOINT, H, n.q * r, v, a, n.t * self._r_t))

                yield self._promise("joint jerk", name, f"{unit}/s3", jerk, 3 * COARSEST_RATE * top, 3, digits)
            if name in self._swing:
                torque = float(self._plant.limits.binding_torque[j])  # type: ignore[index]
                unseen = TORQUE * torque + 2 * self._swing[name], 3 * self._h
                yield self._promise("joint torque", name, "N" if name == "rail" else "Nm", _always(unseen))

    def _tool(self) -> Iterator[Promise]:
        rows, caps, lags = self._rows, self._plant.tcp, self._lags
        v, a = caps.speed, caps.acceleration

        def speed(n: Steps, v: float = v) -> tuple[float, float | None]:
            def seen(H: float) -> float:
                return mean_rate(v, TCP, H, 2 * n.q * self._p, n.t * self._r_t) + chord(v, a, H)

            found = lags.best(1, v, seen)
            if rows.qd is None:
                return found
            return min(found, (v * TCP + 2 * n.q * self._V, self._h), key=lambda one: (one[0] > _ENOUGH * v, one))

        def acceleration(n: Steps) -> tuple[float, float | None]:
            if rows.qd is not None:
                return lags.best(1, a, lambda H: mean_rate(a, TCP, H, 2 * n.q * self._V, n.t * self._r_t))
            return lags.best(2, a, lambda H: second(a, TCP, H, 2 * n.q * self._p, v, n.t * self._r_t))

        yield self._promise("TCP speed", "TCP", "m/s", speed, COARSEST_RATE * v, 1)
        yield self._promise("TCP acceleration", "TCP, one way", "m/s2", acceleration, 2 * COARSEST_RATE * a, 2)
        moves = [visit.point.move for visit in self._line.visits if visit.point.move is not None]
        if turns := [move.speed.v_ori for move in moves if move.speed.v_ori > 0]:
            top = float(max(turns))

            def turning(n: Steps) -> tuple[float, float | None]:
                found = lags.best(1, top, lambda H: mean_rate(top, TCP, H, 2 * n.q * self._R, n.t * self._r_t))
                if rows.qd is None:
                    return found
                return min(
                    found, (top * TCP + 2 * n.q * self._W, self._h), key=lambda one: (one[0] > _ENOUGH * top, one)
                )

            yield self._promise("programmed reorientation", "TCP", "rad/s", turning, COARSEST_RATE * top, 1)
        bend = 0.0
        ways = [way for run in runs_of(self._line, dict(self._frames)) for way in run.ways]
        for way in ways:
            if isinstance(way, Line | Arc) and not way.only_turns:
                bend = max(bend, way.angle / way.length)
        if any(way is not None for way in ways):
            lasting = 3 * self._h

            coarse = COARSEST_TURN + bend * COARSEST_PRINT

            def off(n: Steps) -> tuple[float, float]:
                return LINE_POSITION + 2 * n.q * self._p, lasting

            def turned(n: Steps) -> tuple[float, float]:
                return LINE_ROTATION + 2 * n.q * (self._R + bend * self._p), lasting

            yield self._promise("path deviation", "TCP", "m", off, 2 * COARSEST_PRINT + LINE_POSITION)
            yield self._promise("path rotation", "TCP", "rad", turned, 2 * coarse + LINE_ROTATION)

    def _stops(self) -> Iterator[Promise]:
        rows, a, tau = self._rows, self._plant.tcp.acceleration, self._tau
        alpha = angular_acceleration(rows)
        yield self._promise(
            "stop reached", "TCP", "m", lambda n: (STOP_POSITION + a * tau**2 / 2 + 2 * n.q * self._p, None),
            2 * COARSEST_PRINT + STOP_POSITION + a * tau**2 / 2,
        )  # fmt: skip
        yield self._promise(
            "stop reached", "tool", "rad", lambda n: (STOP_ROTATION + alpha * tau**2 / 2 + 2 * n.q * self._R, None),
            2 * COARSEST_TURN + STOP_ROTATION + alpha * tau**2 / 2,
        )  # fmt: skip

        def rest(n: Steps) -> tuple[float, float]:
            if rows.qd is not None:
                return REST_LINEAR + a * tau + 2 * n.q * self._V, 2 * self._h
            open_ = REST_LINEAR + a * (tau + self._h / 2) + 4 * n.q * self._p / self._h
            return open_ * 24 / 23 * (1 + 2 * n.t * self._r_t / self._h), 2 * self._h

        yield self._promise("stop rest", "TCP", "m/s", rest)
        if any(visit.point.fly_by is not None for visit in self._line.visits):
            yield self._promise(
                "fly-by passed", "TCP", "m", lambda n: (STOP_POSITION + a * self._h**2 / 4 + 2 * n.q * self._p, None)
            )
        if rows.mechanism.has_rail:
            rail, r = float(self._plant.limits.acceleration[0]), float(self._r[0])
            name = self._plant.limits.names[0]
            yield self._promise("rail target", name, "m", lambda n: (JOINT_TARGET + rail * tau**2 + n.q * r, 2 * tau))
            yield self._promise("way while held", name, "m", lambda n: (HELD + 2 * n.q * r, 3 * self._h))

    def _of_time(self) -> Iterator[Promise]:
        yield self._promise(
            "dwell length", "TCP", "s", lambda n: (DWELL + 2 * n.t * self._rows.doubt_t + 4 * self._tau, None)
        )
        yield self._promise(
            "duration",
            "move, positioner",
            "s",
            lambda n: (DURATION + 4 * n.t * self._rows.doubt_t + 6 * self._tau, None),
        )

    def _tables(self, program: Program) -> Iterator[Promise]:
        rows, tables = self._rows, self._rows.trajectory.tables
        if tables is None:
            return
        (step, step_v), r_t, h = rows.tables_step, rows.doubt_t, self._h
        H, unseen = float(np.diff(rows.t).min()), float(unseen_turn(rows, 0, len(rows.t)).max())
        moves = [unit for motion in program.motions for unit in getattr(motion, "units", ())]
        for name in tables.names:
            v = max(unit.velocity for unit in moves if unit.column == name)
            a = max(unit.acceleration for unit in moves if unit.column == name)
            yield Promise("positioner position", name, JOINT_TARGET + step + a * unseen**2 / 2, "rad")
            if tables.qd is not None:
                yield Promise("positioner speed", name, v * JOINT + 1.5 * step_v, "rad/s", h)
                pull, lasting = mean_rate(a, JOINT, H, step_v, r_t), 2 * h
            else:
                yield Promise("positioner speed", name, mean_rate(v, JOINT, H, step, r_t), "rad/s", 2 * h)
                doubt = 2 * (step + v * r_t) / (H - r_t) if r_t < H else inf
                pull, lasting = mean_rate(a, JOINT, H, doubt, r_t), 3 * h
            yield Promise("positioner acceleration", name, pull, "rad/s2", lasting)

    def _clearance(self) -> Iterator[Promise]:
        plant = self._plant
        if plant.obstacles or plant.self_pairs:
            least = OVERLOOKED + 2 * self.granted_clearance()
            yield self._promise("clearance", "robot", "m", lambda _: (least, None))

    def granted_clearance(self) -> float:
        """How much nearer than it is the robot may be seen, m: printed digits and rows move every axis by so much."""
        rows, limits = self._rows, self._plant.limits
        bend = 0.0 if rows.exact else self._h**2 / 8
        return float(self._lever @ (self._r / 2 + limits.acceleration * bend))


def _needed(step: float, least: Callable[[float], float], most: float) -> float | None:
    """The coarsest step, a power of ten, that leaves at most half of what may be open; None where any will do. least:
    by how many times the step there is."""
    base = least(0.0)
    for decades in range(_DECADES):
        if least(10.0**-decades / step) - base <= (most - base) / 2:
            return 10.0**-decades if decades else None
    return None


def _always(least: tuple[float, float | None]) -> Least:
    return lambda _: least


def levers(plant: Machine, mechanism: Mechanism, carried: Iterable[Shape]) -> list[float]:
    """How far from every axis (k,) a point of the robot or of the bodies that it carries may be, m: the links stretched
    out; 1 for a rail."""
    X_WL = mechanism.links(np.array(plant.start)[None])[0][0]
    links = lengths(np.diff(X_WL[1:, :3, 3], axis=0))  # from joint to joint, then to the flange
    stretched = np.cumsum(links[::-1])[::-1]
    beyond = 0.0
    for shape in (*plant.robot.capsules.values(), *carried):
        points, radius = outline(shape)
        beyond = max(beyond, float(lengths(points).max()) + radius)
    return [1.0] * mechanism.has_rail + [float(one) + beyond for one in stretched]
