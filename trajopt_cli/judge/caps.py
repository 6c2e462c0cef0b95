"""The TCP against its caps, and every move against its programmed speeds.

A point that is passed has the speeds of two moves: within its zone the higher of both holds, because one goes over into
the other somewhere in the corner; outside each move keeps to its own.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property, partial, reduce
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.judge.findings import Series, Worst, finding, worse
from trajopt_cli.judge.geometry import angle_between, lengths
from trajopt_cli.judge.machine import Machine
from trajopt_cli.judge.positioners import TurnedFrame
from trajopt_cli.judge.program_points import ProgramPoint, obeys_programmed_speed, path_to
from trajopt_cli.judge.samples import INNER, LAGS, Along, Rows, mean_of, second_differences, windows
from trajopt_cli.judge.timeline import Timeline, Visit, outside_zones, rows_of_move
from trajopt_cli.judge.tolerances import JOINT, REST_JOINT, TCP
from trajopt_cli.judge.tool_kinematics import ToolKinematics, carried
from trajopt_cli.motion import MoveExtJ


@dataclass(frozen=True, eq=False)
class Inner:
    """The TCP between two rows where the Hermite is the motion: speed there, acceleration there and at both ends."""

    frame: ToolKinematics
    first: int
    last: int

    @property
    def _places(self) -> slice:
        return slice(self.first * len(INNER), self.last * len(INNER))

    @property
    def t(self) -> Array:
        """Times (m,) of the places between rows."""
        return np.asarray(self.frame.rows.hermite_places[0][self._places])

    @cached_property
    def _left(self) -> NDArray[np.intp]:
        return np.repeat(np.arange(self.last - self.first), len(INNER))

    @cached_property
    def _motion(self) -> tuple[Array, Array]:
        V, A = (values[self._places] for values in self.frame.inner_motion)
        return V, A

    @cached_property
    def _columns(self) -> Array:
        return np.asarray(self.frame.columns[0][self.first : self.last])

    @cached_property
    def _doubt_qd(self) -> Array:
        rows = self.frame.rows
        steps = rows.doubt_v[self.first : self.last + 1]
        return np.asarray(np.maximum(steps[1:], steps[:-1]) / 2 + 1.5 * rows.mismatch[1][self.first : self.last])

    @property
    def speed(self) -> Array:
        """Least speeds (m,) there."""
        doubt = np.einsum("ij,ij->i", self._columns, self._doubt_qd)
        return np.asarray(lengths(self._motion[0][:, :3]) - doubt[self._left])

    @property
    def turning(self) -> Array:
        """Least angular speeds (m,) there."""
        doubt = np.einsum("ij,ij->i", self.frame.columns[1][self.first : self.last], self._doubt_qd)
        return np.asarray(lengths(self._motion[0][:, 3:]) - doubt[self._left])

    @property
    def accelerations(self) -> tuple[tuple[Array, Array], ...]:
        """Times and least accelerations: there, where intervals begin and where they end."""
        frame, rows, first, last = self.frame, self.frame.rows, self.first, self.last
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
        # half of the tolerance stands for the truncation of rows at 1 kHz; only what is beyond is granted in addition
        beyond = np.einsum("ij,ij->i", self._columns, rows.truncation[first:last])
        truncation = beyond - TCP / 2 * rows.plant.tcp.acceleration
        rounding = np.einsum("ij,ij->i", self._columns, rows.hermite_rounding[first:last])
        doubt_a = rounding + np.maximum(truncation, 0.0)
        return (
            (self.t, lengths(self._motion[1][:, :3]) - doubt_a[self._left]),
            (rows.t[first:last], lengths(begin[:, :3]) - doubt_a),
            (rows.t[first + 1 : last + 1], lengths(end[:, :3]) - doubt_a),
        )


def check_caps(
    line: Timeline, frames: dict[bytes, ToolKinematics], rapid: bool = False
) -> Iterator[tuple[int, list[Finding]]]:
    """TCP speed and acceleration over the whole file (each stretch with its own tool), then programmed speeds: findings
    as they come, each with the row that was looked at. rapid: no axis moves in a wait."""
    rows, caps = line.rows, line.rows.plant.tcp
    speed: list[Worst] = []
    acceleration: list[Worst] = []
    programmed: list[Finding] = []
    for first, last, frame, moves in _stretches(line, frames):
        speeds, accelerated = Series(caps.speed), Series(caps.acceleration)
        todo = deque(moves)
        for a, b in windows(first, last):
            inner = Inner(frame, a, b) if frame.exact and b > a else None
            speeds.add(_tcp_speeds(frame, a, b, inner))
            accelerated.add(tcp_accelerations(frame, a, b, inner))
            while todo and todo[0][1].arrive <= b:
                before, visit = todo.popleft()
                programmed.extend(_programmed(frame, before, visit))
            yield b, []
        for before, visit in todo:
            programmed.extend(_programmed(frame, before, visit))
        speed += speeds.found
        acceleration += accelerated.found
        for (before, visit), (same, after) in pairwise(moves):
            if same is visit and visit.point.fly_by is not None:
                programmed.extend(_in_the_corner(frame, first, before, visit, after))
    out = []
    for check, found, unit in (("speed", speed, "m/s"), ("acceleration", acceleration, "m/s2")):
        if found:
            worst = reduce(worse, found)
            passed = worst.value <= worst.limit * (1 + TCP)
            out.append(
                finding(f"TCP {check}", "TCP", worst.value, worst.limit, unit, passed, time=worst.time,
                        source=line.source_at(worst.time), words=check)
            )  # fmt: skip
    alone = _of_the_rail_alone(line, frames, rapid) if rows.mechanism.has_rail else ()
    yield len(rows.t), [*out, *programmed, *alone]


Stretch = tuple[int, int, ToolKinematics, list[tuple[Visit, Visit]]]


def _stretches(line: Timeline, frames: dict[bytes, ToolKinematics]) -> Iterator[Stretch]:
    """Rows [first, last] with one tool, and the moves in them, from where and to where. A move over a work object that
    turns is a stretch of its own; a corner in which the tool changes is none."""
    last_row = len(line.rows.t) - 1
    first, frame = 0, frames[np.asarray(line.visits[0].point.X_FT).tobytes()]
    moves: list[tuple[Visit, Visit]] = []
    for before, visit in pairwise(line.visits):
        missing = before.event is None and before.point.fly_by is not None  # its rows may be the move's before
        shown = visit.event is not None and not missing and not visit.stay
        if isinstance(turned := line.turned.get(visit.point.index), TurnedFrame):
            begin, end = turned.span(before, visit)
            yield first, begin, frame, moves
            yield begin, end, turned, [(before, visit)] if shown and visit.arrive > before.depart else []
            first, moves = end, []
            continue
        if (tool := frames[np.asarray(visit.point.X_FT).tobytes()]) is not frame:
            end, begin = before.corner or (before.depart, before.depart)
            yield first, max(end, first), frame, moves
            first, frame, moves = begin, tool, []
        if shown and visit.arrive > before.depart:
            moves.append((before, visit))
    yield first, last_row, frame, moves


def _tcp_speeds(frame: ToolKinematics, first: int, last: int, inner: Inner | None) -> Iterator[tuple[Array, Array]]:
    """Least TCP speeds: chords over all lags, the rows' own, and between rows."""
    rows = frame.rows
    yield from _mean_over_lags(frame, first, last, frame.mean_speeds)
    if rows.qd is not None:
        yield rows.t[first : last + 1], frame.least_speed[first : last + 1]
    if inner is not None:
        yield inner.t, inner.speed


def tcp_accelerations(
    frame: ToolKinematics, first: int, last: int, inner: Inner | None
) -> Iterator[tuple[Array, Array]]:
    """Least TCP accelerations: second divided differences of the position, speed differences, and between rows.

    All are means of the acceleration vector, never longer than its greatest length.
    """
    rows, part = frame.rows, slice(first, last + 1)
    t = rows.t[part]
    for m, value, doubt in second_differences(t, frame.p[part], frame.doubt_p[part, None], rows.step_t[part], True):
        yield t[m : len(t) - m], lengths(value) - doubt[:, 0]
    if rows.qd is None:
        return
    V, doubt_V = frame.V[part, :3], frame.doubt_V[0][part]
    for m in LAGS:
        if m < len(t):
            change = lengths(V[m:] - V[:-m]) - doubt_V[m:] - doubt_V[:-m]
            yield t[:-m], np.maximum(change, 0.0) / _times(rows, first, last, m)
    if inner is not None:
        yield from inner.accelerations


def _tcp(frame: ToolKinematics, a: int, b: int) -> Iterator[tuple[Array, Array]]:
    """TCP speeds at least, from row a to row b: times and values."""
    yield from _mean_over_lags(frame, a, b, frame.mean_speeds)
    if frame.rows.qd is not None:
        yield frame.rows.t[a : b + 1], frame.least_speed[a : b + 1]
    if frame.exact:
        inner = Inner(frame, a, b)
        yield inner.t, inner.speed


def _turning(frame: ToolKinematics, a: int, b: int) -> Iterator[tuple[Array, Array]]:
    """Angular speeds of the tool."""
    yield from _mean_over_lags(frame, a, b, frame.mean_turnings)
    if frame.rows.qd is not None:
        yield frame.rows.t[a : b + 1], frame.least_turning[a : b + 1]
    if frame.exact:
        inner = Inner(frame, a, b)
        yield inner.t, inner.turning


def _rail_speeds(i: int, frame: ToolKinematics, a: int, b: int) -> Iterator[tuple[Array, Array]]:
    """Speeds of rail number i."""
    rows = frame.rows
    for m in LAGS:
        if a + m <= b:
            here, after = slice(a, b + 1 - m), slice(a + m, b + 1)
            path = np.abs(rows.q[after, i] - rows.q[here, i]) - mean_of(rows.doubt_q, here, after)[:, i]
            yield rows.t[a : b + 1 - m], np.maximum(path, 0.0) / _times(rows, a, b, m)
    if rows.qd is not None:
        yield rows.t[a : b + 1], np.abs(rows.qd[a : b + 1, i]) - rows.doubt_v[a : b + 1, i]


def _mean_over_lags(
    frame: ToolKinematics, a: int, b: int, means: Callable[[int], Along]
) -> Iterator[tuple[Array, Array]]:
    for m in LAGS:
        if a + m <= b:
            yield frame.rows.t[a : b + 1 - m], means(m)[a : b + 1 - m]


def _times(rows: Rows, a: int, b: int, m: int) -> Array:
    here, after = slice(a, b + 1 - m), slice(a + m, b + 1)
    return np.asarray(rows.t[after] - rows.t[here] + rows.unsure(here, after))


@dataclass(frozen=True)
class _Programmed:
    """One part of speeddata: the check that holds a motion to it, where it is changed over, and its cap for a move from
    visit to visit, None where it has none: a reorientation of 0 is for a tool that keeps its orientation."""

    check: str
    subject: str
    unit: str
    tolerance: float
    zone: str
    values: Callable[[ToolKinematics, int, int], Iterator[tuple[Array, Array]]]
    cap: Callable[[Visit, Visit, Machine], float | None]

    def finding(
        self, frame: ToolKinematics, part: tuple[int, int], limit: float, point: ProgramPoint, words: str
    ) -> list[Finding]:
        """The worst from row to row; none where no rows show it."""
        worst: Worst | None = None
        for times, values in self.values(frame, *part):
            if len(values):
                i = int(np.argmax(values))
                worst = worse(worst, Worst(float(values[i]), limit, float(times[i])))
        if worst is None:
            return []
        passed = worst.value <= limit * (1 + self.tolerance)
        return [finding(self.check, self.subject, worst.value, limit, self.unit, passed, time=worst.time,
                        source=point.source, bound=words)]  # fmt: skip


def _programmed_caps(plant: Machine, rails: int) -> list[_Programmed]:
    return [
        _Programmed("programmed speed", "TCP", "m/s", TCP, "radius", _tcp, partial(_cap, "v_tcp")),
        _Programmed("programmed reorientation", "TCP", "rad/s", TCP, "turning", _turning, partial(_cap, "v_ori")),
        *(_Programmed("programmed speed", name, "m/s", JOINT, "external", partial(_rail_speeds, i), _rail_cap)
          for i, name in enumerate(plant.limits.names[:rails])),
    ]  # fmt: skip


def _cap(name: str, before: Visit, visit: Visit, plant: Machine) -> float | None:
    point = visit.point
    if point.move is not None and point.duration is not None:
        return _of_its_time(name, before, visit, point.duration)
    if point.move is None or not obeys_programmed_speed(point, plant):
        return None
    return float(getattr(point.move.speed, name)) or None


def _of_its_time(name: str, before: Visit, visit: Visit, duration: float) -> float | None:
    """The speed that a programmed time beside a fly-by stands for, [m/s] or between turns in place [rad/s]: that which
    takes so long over the whole way. From stop to stop the time itself is looked at."""
    point, zones = visit.point, [one.point.fly_by for one in (before, visit) if one.point.fly_by is not None]
    turns = any(zone.in_place for zone in zones)
    if not zones or turns != (name == "v_ori"):
        return None
    X_0, X_1 = before.X_WF @ point.X_FT, point.X_WT
    if turns:
        return float(angle_between(X_0[:3, :3], X_1[:3, :3])) / duration
    if point.curved:
        return (point.curve or path_to(before.X_WF, point)).length / duration
    return float(lengths(X_1[:3, 3] - X_0[:3, 3])) / duration


def _allows(point: ProgramPoint) -> str:
    assert point.move is not None
    what = point.move.speed.name if point.duration is None else rf"\T:={point.duration:g}"
    return f"{what} allows"


def _rail_cap(_: Visit, visit: Visit, plant: Machine) -> float | None:
    """External axes alone always know v_leax; other moves where they obey their speed at all. A speed of 0 lets the
    rail stand."""
    point = visit.point
    alone = isinstance(point.move, MoveExtJ) and point.duration is None
    if point.move is None or not (alone or obeys_programmed_speed(point, plant)):
        return None
    return point.move.speed.v_leax or REST_JOINT


def _of_the_rail_alone(line: Timeline, frames: dict[bytes, ToolKinematics], rapid: bool) -> Iterator[Finding]:
    """The rail against the programmed speed of lines to where the tool is already. Several in one rest, which the file
    does not tell apart, have the highest of theirs; in a wait of a stream the rail may go as it likes."""
    rests: list[list[Visit]] = []
    for before, visit in pairwise(line.visits):
        if not visit.stay or visit.event is None or before.event is None:
            continue
        at_once = visit.at_once_after(before)
        if at_once and rests and rests[-1][-1] is before and before.at_once_after(rests[-1][-2]):
            rests[-1].append(visit)
        else:
            rests.append([before, visit])
    rows = line.rows
    parts = _programmed_caps(rows.plant, rows.mechanism.rails)[2:]
    for before, *visits in rests:
        caps = [(_rail_cap(before, visit, rows.plant) or np.inf, visit.point) for visit in visits]
        waits = not rapid and any(hold.wait.duration > 0 for visit in (before, *visits) for hold in visit.holds)
        limit, point = max(caps, key=lambda cap: cap[0])
        if waits or limit == np.inf:
            continue
        shared = visits[0].at_once_after(before)
        a, b = (before.arrive, visits[-1].depart) if shared else (before.depart, visits[0].arrive)
        if not rows.marked:  # rows beside the ends may belong to another motion
            a, b = a + 1, b - 1
        assert point.move is not None
        frame = frames[np.asarray(point.X_FT).tobytes()]
        if b > a:  # in a rest of one row the rail goes nowhere, however fast it runs past
            for part in parts:
                yield from part.finding(frame, (a, b), limit, point, f"{point.move.speed.name} allows")


def _programmed(frame: ToolKinematics, before: Visit, visit: Visit) -> Iterator[Finding]:
    """TCP speed, reorientation and rail speed of one move against its speeddata, outside the zones at its ends; rows
    beside its rests left out where they may belong to another motion."""
    rows, point = frame.rows, visit.point
    assert point.move is not None
    for part in _programmed_caps(rows.plant, rows.mechanism.rails):
        a, b = outside_zones(frame, before, visit, part.zone)
        limit = part.cap(before, visit, rows.plant)
        if limit is not None and b > a:
            yield from part.finding(frame, (a, b), limit, point, _allows(point))


def _in_the_corner(frame: ToolKinematics, first: int, before: Visit, visit: Visit, after: Visit) -> Iterator[Finding]:
    """The same within the zone of a point that is passed, against the higher of both moves' speeds. first: the first
    row with this tool."""
    rows = frame.rows
    assert visit.point.move is not None
    assert after.point.move is not None
    for part in _programmed_caps(rows.plant, rows.mechanism.rails):
        a = max(outside_zones(frame, before, visit, part.zone)[1], first)
        b = min(outside_zones(frame, visit, after, part.zone)[0], rows_of_move(rows, visit, after)[1])
        caps = [part.cap(*ends, rows.plant) for ends in ((before, visit), (visit, after))]
        if caps[0] is not None and caps[1] is not None and b > a:
            faster = visit if caps[0] >= caps[1] else after
            words = f"at {visit.point.name} {_allows(faster.point)}"
            yield from part.finding(frame, (a, b), max(caps[0], caps[1]), visit.point, words)
