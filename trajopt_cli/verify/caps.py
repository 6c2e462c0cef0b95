"""The TCP against its caps, and every move against its programmed speeds.

A point that is passed has the speeds of two moves: within its zone the higher of both holds, because one goes over into
the other somewhere in the corner; outside each move keeps to its own.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.motion import MoveExtJ
from trajopt_cli.verify.course import Point, obeys_programmed_speed
from trajopt_cli.verify.findings import Worst, finding, worse
from trajopt_cli.verify.frame import Frame, carried
from trajopt_cli.verify.machine import Machine
from trajopt_cli.verify.rows import INNER, LAGS, second_differences
from trajopt_cli.verify.timeline import Timeline, Visit, outside_zones
from trajopt_cli.verify.tolerances import JOINT, TCP


class Inner:
    """The TCP between rows where the Hermite is the motion: speed there, acceleration there and at both ends."""

    def __init__(self, frame: Frame, first: int, last: int):
        rows, n = frame.rows, len(INNER)
        times = rows.hermite_places[0][first * n : last * n]
        X, V_F, A_F = (values[first * n : last * n] for values in rows.hermite_motion)
        V, A = carried(V_F, A_F, X, frame.X_FT)
        assert rows.qd is not None
        h = np.diff(rows.t[first : last + 1])
        # at the ends of an interval only the axes' accelerations differ from its neighbours'
        part = slice(first, last + 1)
        turning = carried(frame.V[part], rows.turning[part], rows.X_WF[part], frame.X_FT)[1]
        v = rows.qd[part]
        mean, swing = np.diff(v, axis=0) / h[:, None], 6 * rows.mismatch[0][first:last] / h[:, None]
        J_rows = frame.J[part]
        begin = (J_rows[:-1] @ (mean + swing)[..., None])[..., 0] + turning[:-1]
        end = (J_rows[1:] @ (mean - swing)[..., None])[..., 0] + turning[1:]
        columns = np.linalg.norm(frame.J[first:last, :3], axis=1)
        turns = np.linalg.norm(frame.J[first:last, 3:], axis=1)
        # half of the tolerance stands for the truncation of rows at 1 kHz; only what is beyond is granted in addition
        truncation = np.einsum("ij,ij->i", columns, rows.truncation[first:last]) - TCP / 2 * rows.plant.tcp.acceleration
        rounding = np.einsum("ij,ij->i", columns, rows.hermite_rounding[first:last])
        doubt_a = rounding + np.maximum(truncation, 0.0)
        doubt_qd = rows.doubt_v / 2 + 1.5 * rows.mismatch[1][first:last]
        self.t, self.left = times, np.repeat(np.arange(last - first), n)
        self.speed = np.linalg.norm(V[:, :3], axis=1) - np.einsum("ij,ij->i", columns, doubt_qd)[self.left]
        self.turning = np.linalg.norm(V[:, 3:], axis=1) - np.einsum("ij,ij->i", turns, doubt_qd)[self.left]
        self.accelerations = (
            (times, np.linalg.norm(A[:, :3], axis=1) - doubt_a[self.left]),
            (rows.t[first:last], np.linalg.norm(begin[:, :3], axis=1) - doubt_a),
            (rows.t[first + 1 : last + 1], np.linalg.norm(end[:, :3], axis=1) - doubt_a),
        )


def check_caps(line: Timeline, frames: dict[bytes, Frame]) -> list[Finding]:
    """TCP speed and acceleration over the whole file (each stretch with its own tool), then programmed speeds."""
    rows, caps = line.rows, line.rows.plant.tcp
    speed: Worst | None = None
    acceleration: Worst | None = None
    programmed: list[Finding] = []
    for first, last, X_FT, moves in _stretches(line):
        frame = frames[X_FT.tobytes()]
        inner = Inner(frame, first, last) if rows.exact and last > first else None
        for times, values in _speeds(frame, first, last, inner):
            i = int(np.argmax(values))
            speed = worse(speed, Worst(float(values[i]), caps.speed, float(times[i])))
        for times, values in accelerations(frame, first, last, inner):
            i = int(np.argmax(values))
            acceleration = worse(acceleration, Worst(float(values[i]), caps.acceleration, float(times[i])))
        motion = _Motion(frame, first, inner)
        for before, visit in moves:
            programmed.extend(_programmed(motion, before, visit))
        for (before, visit), (same, after) in pairwise(moves):
            if same is visit and visit.point.fly_by is not None:
                programmed.extend(_in_the_corner(motion, before, visit, after))
    out = []
    for check, worst, unit in (("speed", speed, "m/s"), ("acceleration", acceleration, "m/s2")):
        if worst is not None:
            passed = worst.value <= worst.limit * (1 + TCP)
            out.append(
                finding(f"TCP {check}", "TCP", worst.value, worst.limit, unit, passed, time=worst.time,
                        source=line.source_at(worst.time), words=check)
            )  # fmt: skip
    return out + programmed


def _stretches(line: Timeline) -> Iterator[tuple[int, int, Array, list[tuple[Visit, Visit]]]]:
    """Rows [first, last] with one tool, and the moves in them, from where and to where."""
    last_row = len(line.rows.t) - 1
    first, X_FT = 0, np.asarray(line.visits[0].point.X_FT)
    moves: list[tuple[Visit, Visit]] = []
    for before, visit in zip(line.visits, line.visits[1:], strict=False):
        if np.asarray(visit.point.X_FT).tobytes() != X_FT.tobytes():
            yield first, before.depart, X_FT, moves
            first, X_FT, moves = before.depart, np.asarray(visit.point.X_FT), []
        missing = before.event is None and before.point.fly_by is not None  # its rows may be the move's before
        if visit.event is not None and not missing and not visit.stay and visit.arrive > before.depart:
            moves.append((before, visit))
    yield first, last_row, X_FT, moves


def _speeds(frame: Frame, first: int, last: int, inner: Inner | None) -> Iterator[tuple[Array, Array]]:
    """Least TCP speeds: chords over all lags, the rows' own, and between rows."""
    rows = frame.rows
    for m in LAGS:
        if first + m <= last:
            h = rows.t[first + m : last + 1] - rows.t[first : last + 1 - m]
            yield rows.t[first : last + 1 - m], frame.path_lengths(m)[first : last + 1 - m] / (h + rows.doubt_t)
    if rows.qd is not None:
        yield rows.t[first : last + 1], frame.least_speed[first : last + 1]
    if inner is not None:
        yield inner.t, inner.speed


def accelerations(frame: Frame, first: int, last: int, inner: Inner | None) -> Iterator[tuple[Array, Array]]:
    """Least TCP accelerations: second divided differences of the position, speed differences, and between rows.

    All are means of the acceleration vector, never longer than its greatest length.
    """
    rows, part = frame.rows, slice(first, last + 1)
    t = rows.t[part]
    for m, value, doubt in second_differences(t, frame.p[part], frame.doubt_p[part, None], rows.doubt_t):
        # the doubt about a position is a length, the same for the whole vector
        yield t[m : len(t) - m], np.linalg.norm(value, axis=1) - doubt.max(axis=1)
    if rows.qd is None:
        return
    V, doubt_V = frame.V[part, :3], frame.doubt_V[0][part]
    for m in LAGS:
        if m < len(t):
            change = np.linalg.norm(V[m:] - V[:-m], axis=1) - doubt_V[m:] - doubt_V[:-m]
            yield t[:-m], np.maximum(change, 0.0) / (t[m:] - t[:-m] + rows.doubt_t)
    if inner is not None:
        yield from inner.accelerations


@dataclass(frozen=True, eq=False)
class _Motion:
    """A stretch with one tool: from row first on, inner between rows where that is known."""

    frame: Frame
    first: int
    inner: Inner | None

    def tcp(self, a: int, b: int) -> Iterator[tuple[Array, Array]]:
        """TCP speeds at least, from row a to row b: times and values."""
        yield from self._means(a, b, self.frame.path_lengths)
        if self.frame.rows.qd is not None:
            yield self.frame.rows.t[a : b + 1], self.frame.least_speed[a : b + 1]
        if self.inner is not None:
            yield self.inner.t[self._between(a, b)], self.inner.speed[self._between(a, b)]

    def turning(self, a: int, b: int) -> Iterator[tuple[Array, Array]]:
        """Angular speeds of the tool."""
        yield from self._means(a, b, self.frame.angles)
        if self.frame.rows.qd is not None:
            yield self.frame.rows.t[a : b + 1], self.frame.least_turning[a : b + 1]
        if self.inner is not None:
            yield self.inner.t[self._between(a, b)], self.inner.turning[self._between(a, b)]

    def rail(self, a: int, b: int) -> Iterator[tuple[Array, Array]]:
        """Speeds of the rail."""
        rows = self.frame.rows
        for m in LAGS:
            if a + m <= b:
                way = np.abs(rows.q[a + m : b + 1, 0] - rows.q[a : b + 1 - m, 0]) - rows.doubt_q[0]
                yield rows.t[a : b + 1 - m], np.maximum(way, 0.0) / self._times(a, b, m)
        if rows.qd is not None:
            yield rows.t[a : b + 1], np.abs(rows.qd[a : b + 1, 0]) - rows.doubt_v[0]

    def _means(self, a: int, b: int, ways: Callable[[int], Array]) -> Iterator[tuple[Array, Array]]:
        for m in LAGS:
            if a + m <= b:
                yield self.frame.rows.t[a : b + 1 - m], ways(m)[a : b + 1 - m] / self._times(a, b, m)

    def _times(self, a: int, b: int, m: int) -> Array:
        t = self.frame.rows.t
        return np.asarray(t[a + m : b + 1] - t[a : b + 1 - m] + self.frame.rows.doubt_t)

    def _between(self, a: int, b: int) -> slice:
        return slice((a - self.first) * len(INNER), (b - self.first) * len(INNER))


@dataclass(frozen=True)
class _Programmed:
    """One part of speeddata: the check that holds a motion to it, where it is changed over, and its cap for a move,
    None where the move has none."""

    check: str
    subject: str
    unit: str
    tolerance: float
    zone: str
    values: Callable[[_Motion, int, int], Iterator[tuple[Array, Array]]]
    cap: Callable[[Point, Machine], float | None]

    def finding(self, motion: _Motion, part: tuple[int, int], limit: float, point: Point, words: str) -> list[Finding]:
        """The worst from row to row; none where no rows show it."""
        worst: Worst | None = None
        for times, values in self.values(motion, *part):
            if len(values):
                i = int(np.argmax(values))
                worst = worse(worst, Worst(float(values[i]), limit, float(times[i])))
        if worst is None:
            return []
        passed = worst.value <= limit * (1 + self.tolerance)
        return [finding(self.check, self.subject, worst.value, limit, self.unit, passed, time=worst.time,
                        source=point.source, bound=words)]  # fmt: skip


def _parts(plant: Machine, has_rail: bool) -> list[_Programmed]:
    parts = [
        _Programmed("programmed speed", "TCP", "m/s", TCP, "radius", _Motion.tcp, lambda p, m: _cap(p, m, "v_tcp")),
        _Programmed("programmed reorientation", "TCP", "rad/s", TCP, "turning", _Motion.turning,
                    lambda p, m: _cap(p, m, "v_ori")),
        _Programmed("programmed speed", plant.limits.names[0], "m/s", JOINT, "external", _Motion.rail, _rail_cap),
    ]  # fmt: skip
    return parts if has_rail else parts[:2]


def _cap(point: Point, plant: Machine, name: str) -> float | None:
    if point.move is None or not obeys_programmed_speed(point, plant):
        return None
    return float(getattr(point.move.speed, name))


def _rail_cap(point: Point, plant: Machine) -> float | None:
    """External axes alone always know v_leax; other moves where they obey their speed at all."""
    if isinstance(point.move, MoveExtJ) and point.duration is None:
        return point.move.speed.v_leax
    return _cap(point, plant, "v_leax")


def _programmed(motion: _Motion, before: Visit, visit: Visit) -> Iterator[Finding]:
    """TCP speed, reorientation and rail speed of one move against its speeddata, outside the zones at its ends; rows
    beside its rests left out where they may belong to another motion."""
    rows, point = motion.frame.rows, visit.point
    assert point.move is not None
    for part in _parts(rows.plant, rows.mechanism.has_rail):
        a, b = outside_zones(motion.frame, before, visit, part.zone)
        limit = part.cap(point, rows.plant)
        if limit is not None and b > a:
            yield from part.finding(motion, (a, b), limit, point, f"{point.move.speed.name} allows")


def _in_the_corner(motion: _Motion, before: Visit, visit: Visit, after: Visit) -> Iterator[Finding]:
    """The same within the zone of a point that is passed, against the higher of both moves' speeds."""
    rows = motion.frame.rows
    assert visit.point.move is not None
    assert after.point.move is not None
    for part in _parts(rows.plant, rows.mechanism.has_rail):
        a = max(outside_zones(motion.frame, before, visit, part.zone)[1], motion.first)
        b = outside_zones(motion.frame, visit, after, part.zone)[0]
        caps = [part.cap(one.point, rows.plant) for one in (visit, after)]
        if caps[0] is not None and caps[1] is not None and b > a:
            faster = visit if caps[0] >= caps[1] else after
            assert faster.point.move is not None
            words = f"at {visit.point.name} {faster.point.move.speed.name} allows"
            yield from part.finding(motion, (a, b), max(caps[0], caps[1]), visit.point, words)
