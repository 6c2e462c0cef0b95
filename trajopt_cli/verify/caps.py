"""The TCP against its caps, and every move against its programmed speeds."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.motion import Move, MoveExtJ
from trajopt_cli.verify.course import Stop, obeys_programmed_speed
from trajopt_cli.verify.findings import Worst, finding, worse
from trajopt_cli.verify.frame import Frame, carried
from trajopt_cli.verify.machine import Machine
from trajopt_cli.verify.rows import INNER, LAGS, Rows, second_differences
from trajopt_cli.verify.timeline import Timeline
from trajopt_cli.verify.tolerances import JOINT, TCP


class _Inner:
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
        inner = _Inner(frame, first, last) if rows.exact and last > first else None
        for times, values in _speeds(frame, first, last, inner):
            i = int(np.argmax(values))
            speed = worse(speed, Worst(float(values[i]), caps.speed, float(times[i])))
        for times, values in _accelerations(frame, first, last, inner):
            i = int(np.argmax(values))
            acceleration = worse(acceleration, Worst(float(values[i]), caps.acceleration, float(times[i])))
        for stop, a, b in moves:
            programmed.extend(_programmed(frame, stop, a, b, first, inner, rows.plant))
    out = []
    for check, worst, unit in (("speed", speed, "m/s"), ("acceleration", acceleration, "m/s2")):
        if worst is not None:
            passed = worst.value <= worst.limit * (1 + TCP)
            out.append(
                finding(f"TCP {check}", "TCP", worst.value, worst.limit, unit, passed, time=worst.time,
                        source=line.source_at(worst.time), words=check)
            )  # fmt: skip
    return out + programmed


def _stretches(line: Timeline) -> Iterator[tuple[int, int, Array, list[tuple[Stop, int, int]]]]:
    """Rows [first, last] with one tool, and the moves in them with their rows."""
    last_row = len(line.rows.t) - 1
    first, X_FT = 0, np.asarray(line.visits[0].stop.X_FT)
    moves: list[tuple[Stop, int, int]] = []
    for before, visit in zip(line.visits, line.visits[1:], strict=False):
        if np.asarray(visit.stop.X_FT).tobytes() != X_FT.tobytes():
            yield first, before.depart, X_FT, moves
            first, X_FT, moves = before.depart, np.asarray(visit.stop.X_FT), []
        if visit.event is not None and not visit.stay and visit.arrive > before.depart:
            moves.append((visit.stop, before.depart, visit.arrive))
    yield first, last_row, X_FT, moves


def _speeds(frame: Frame, first: int, last: int, inner: _Inner | None) -> Iterator[tuple[Array, Array]]:
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


def _accelerations(frame: Frame, first: int, last: int, inner: _Inner | None) -> Iterator[tuple[Array, Array]]:
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


def _programmed(
    frame: Frame, stop: Stop, a: int, b: int, offset: int, inner: _Inner | None, plant: Machine
) -> list[Finding]:
    """TCP speed, reorientation and rail speed of one move against its speeddata; rows beside its ends left out where
    they may belong to another motion."""
    rows = frame.rows
    move = stop.move
    assert move is not None
    if not rows.marked:
        a, b = a + 1, b - 1
    if b <= a:
        return []
    checks: list[tuple[str, str, list[tuple[Array, Array]], float, str, float]] = []
    within = None if inner is None else slice((a - offset) * len(INNER), (b - offset) * len(INNER))
    if obeys_programmed_speed(stop, plant):
        speeds = [(rows.t[a : b + 1 - m], _mean(rows, frame.path_lengths(m), a, b, m)) for m in LAGS if a + m <= b]
        turns = [(rows.t[a : b + 1 - m], _mean(rows, frame.angles(m), a, b, m)) for m in LAGS if a + m <= b]
        if rows.qd is not None:
            speeds.append((rows.t[a : b + 1], frame.least_speed[a : b + 1]))
            turns.append((rows.t[a : b + 1], frame.least_turning[a : b + 1]))
        if inner is not None:
            speeds.append((inner.t[within], inner.speed[within]))
            turns.append((inner.t[within], inner.turning[within]))
        checks.append(("programmed speed", "TCP", speeds, move.speed.v_tcp, "m/s", TCP))
        checks.append(("programmed reorientation", "TCP", turns, move.speed.v_ori, "rad/s", TCP))
    if rows.mechanism.has_rail and stop.duration is None and _rail_obeys(move, stop, plant):
        rail = [(rows.t[a : b + 1 - m], _rail_speed(rows, a, b, m)) for m in LAGS if a + m <= b]
        if rows.qd is not None:
            rail.append((rows.t[a : b + 1], np.abs(rows.qd[a : b + 1, 0]) - rows.doubt_v[0]))
        checks.append(("programmed speed", plant.limits.names[0], rail, move.speed.v_leax, "m/s", JOINT))
    out = []
    for check, subject, places, limit, unit, tolerance in checks:
        worst: Worst | None = None
        for times, values in places:
            i = int(np.argmax(values))
            worst = worse(worst, Worst(float(values[i]), limit, float(times[i])))
        assert worst is not None
        passed = worst.value <= limit * (1 + tolerance)
        out.append(finding(check, subject, worst.value, limit, unit, passed, time=worst.time, source=stop.source,
                           bound=f"{move.speed.name} allows"))  # fmt: skip
    return out


def _rail_obeys(move: Move, stop: Stop, plant: Machine) -> bool:
    """External axes alone always know v_leax; other moves where they obey their speed at all."""
    return isinstance(move, MoveExtJ) or obeys_programmed_speed(stop, plant)


def _mean(rows: Rows, ways: Array, a: int, b: int, m: int) -> Array:
    h = rows.t[a + m : b + 1] - rows.t[a : b + 1 - m]
    return np.asarray(ways[a : b + 1 - m] / (h + rows.doubt_t))


def _rail_speed(rows: Rows, a: int, b: int, m: int) -> Array:
    way = np.maximum(np.abs(rows.q[a + m : b + 1, 0] - rows.q[a : b + 1 - m, 0]) - rows.doubt_q[0], 0.0)
    return np.asarray(way / (rows.t[a + m : b + 1] - rows.t[a : b + 1 - m] + rows.doubt_t))
