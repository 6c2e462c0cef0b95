"""Axes against their torque limits: what pin's inverse dynamics asks of them at the rows, and between.

The tool's own mass (tload) and what it holds (GripLoad) count from the move that names them on; a wait carries what the
move before it carried. Where the Hermite between rows is the motion it is judged at both ends of every interval and at
the INNER places, less what printing and the Hermite's truncation leave open. Elsewhere means are judged: over the rows
from i to k with mean acceleration a the torque is M(q) a + h(q, v) in the middle, up to how much M and h change from
there to both ends, M with every axis at its acceleration limit; a motion within its limits never has a greater mean.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.judge.findings import Series, finding
from trajopt_cli.judge.mechanism import Forces
from trajopt_cli.judge.samples import INNER, Rows, mean_of, second_differences, windows
from trajopt_cli.judge.timeline import Timeline
from trajopt_cli.judge.tolerances import TORQUE
from trajopt_cli.motion import FlyBy, Load, MoveExtJ, Program, SignalEvent, Wait
from trajopt_cli.units import slides

_MEANS = 4  # of the lags of rows, the shortest: over longer ones masses change too much to tell anything

Body = tuple[float, Array, Array]
Looks = Iterator[tuple[Array, Array]]


def check_torques(program: Program, line: Timeline) -> list[Finding]:
    """Worst case per axis whose torque has a limit; none where no limit binds."""
    rows = line.rows
    limit = rows.plant.limits.binding_torque
    if limit is None:
        return []
    carried = _Carried(program, line)
    found = [Series(float(top)) for top in limit]
    sample = _exact if rows.exact else _mean_torques
    for part in windows(0, len(rows.t) - 1):
        samples = [*sample(rows, carried, *part)]
        for j, series in enumerate(found):
            series.add((times, values[:, j]) for times, values in samples)
    out = []
    for name, series in zip(rows.plant.limits.names, found, strict=True):
        if np.isfinite(series.worst.limit):
            worst = series.worst
            out.append(
                finding(
                    "joint torque", name, worst.value, worst.limit, "N" if slides(name) else "Nm",
                    worst.value <= worst.limit * (1 + TORQUE),
                    time=worst.time, source=line.source_at(worst.time), words="torque",
                )
            )  # fmt: skip
    return out


class _Carried:
    """What the flange carries between rows, and the robot's forces with it."""

    def __init__(self, program: Program, line: Timeline):
        rows, loads = line.rows, _loads(program)
        names = [tuple(loads.get(visit.point.index, ())) for visit in line.visits]
        names[0] = names[1] if len(names) > 1 else ()
        self._rows, kinds = rows, dict.fromkeys(names)
        self.forces = [Forces(rows.mechanism, rows.plant.robot.rotor, [_body(*one) for one in kind]) for kind in kinds]
        # which of them an interval may have: the one of the move under way, beside a move's end that of the next, too
        self.may = np.zeros((len(kinds), len(rows.t) - 1), dtype=bool)
        begin = 0
        come = 0  # where the load may be taken over at the earliest
        for visit, name in zip(line.visits, names, strict=True):
            if visit.event is None:
                continue
            beside = 0 if rows.marked and visit.point.fly_by is None else 2
            end, left, next_come = max(visit.depart, begin), 0, len(rows.t)
            if isinstance(visit.point.fly_by, FlyBy) and visit.corner is not None:
                next_come, left = visit.corner
            self.may[[*kinds].index(name), max(min(begin - beside, come), 0) : max(end + beside, left)] = True
            begin, come = end, next_come
        self.may[[*kinds].index(names[-1]), begin:] = True

    def least(self, first: IndexArray, last: IndexArray, torque: Sequence[Array]) -> Array:
        """Of torques (n, k) with each load the least that rows first to last (n,) may have."""
        out = np.full(torque[0].shape, np.inf)
        for may, found in zip(self.may, torque, strict=True):
            count = np.concatenate([[0], np.cumsum(may)])
            some = count[np.maximum(last, first + 1)] > count[first]
            out = np.where(some[:, None], np.minimum(out, found), out)
        return np.where(np.isfinite(out), out, 0.0)


def _exact(rows: Rows, carried: _Carried, first: int, last: int) -> Looks:
    """Least torques between two rows with their times: at both ends of every interval, from inside, and between."""
    assert rows.qd is not None
    part, between = slice(first, last + 1), slice(first, last)
    t, q, v = rows.t[part], rows.q[part], rows.qd[part]
    h = np.diff(t)[:, None]
    mean, swing = np.diff(v, axis=0) / h, 6 * rows.mismatch[0][between] / h
    open_a = rows.hermite_rounding[between] + rows.truncation[between]
    n, number = len(INNER), np.arange(first, last)
    inner = slice(first * n, last * n)
    samples = [
        (t[:-1], q[:-1], v[:-1], mean + swing, number),
        (t[1:], q[1:], v[1:], mean - swing, number),
        (*(places[inner] for places in rows.hermite_places), np.repeat(number, n)),
    ]
    changes = [forces.changes(q[:-1], v[:-1], mean) for forces in carried.forces]
    off_q, off_v = (np.maximum(one[first:last], one[first + 1 : last + 1]) for one in (rows.doubt_q, rows.doubt_v))
    doubts = [_doubt(change, off_q, off_v, open_a) for change in changes]
    for times, at, rate, change, i in samples:
        torque = [
            np.abs(forces.torques(at, rate, change)) - doubt[i - first]
            for forces, doubt in zip(carried.forces, doubts, strict=True)
        ]
        yield times, carried.least(i, i + 1, torque)


def _mean_torques(rows: Rows, carried: _Carried, first: int, last: int) -> Looks:
    """Least means of torques between two rows, with their times."""
    part = slice(first, last + 1)
    t, q = rows.t[part], rows.q[part]
    if rows.qd is not None:
        v, h = rows.qd[part], np.diff(t)[:, None]
        off_v = mean_of(rows.doubt_v, slice(first, last), slice(first + 1, last + 1))
        a, open_a = np.diff(v, axis=0) / h, off_v / np.maximum(h - rows.doubt_t, h / 2)
        states = [((q[1:] + q[:-1]) / 2, (v[1:] + v[:-1]) / 2), (q[:-1], v[:-1]), (q[1:], v[1:])]
        i = np.arange(first, last)
        yield (t[1:] + t[:-1]) / 2, _mean(rows, carried, states, a, open_a, i, i + 1)
        return
    for count, (m, a, open_a) in enumerate(second_differences(t, q, rows.doubt_q[part] / 2, rows.step_t[part])):
        if count == _MEANS:
            break
        begin, middle, end = slice(0, len(t) - 2 * m), slice(m, len(t) - m), slice(2 * m, len(t))
        before, after = (t[middle] - t[begin])[:, None], (t[end] - t[middle])[:, None]
        v = (q[end] - q[begin]) / (before + after)
        states = [(q[middle], v), (q[begin], v - a * before), (q[end], v + a * after)]
        i = np.arange(first, first + len(a))
        yield t[middle], _mean(rows, carried, states, a, open_a, i, i + 2 * m)


def _mean(
    rows: Rows,
    carried: _Carried,
    states: list[tuple[Array, Array]],
    a: Array,
    open_a: Array,
    first: IndexArray,
    last: IndexArray,
) -> Array:
    """Least means (n, k) of torques with mean accelerations a from states at the middle, the begin and the end."""
    top, torque = rows.accelerations.most, []
    off_q, off_v = (np.maximum(one[first], one[last]) for one in (rows.doubt_q, rows.doubt_v))
    for forces in carried.forces:
        (q, v), *ends = states
        middle, mass = forces.torques(q, v, a), forces.masses(q)
        swing = np.zeros_like(middle)
        for q_end, v_end in ends:
            heavier = np.abs(forces.masses(q_end) - mass) @ top
            swing = np.maximum(swing, np.abs(forces.torques(q_end, v_end, a) - middle) + heavier)
        doubt = _doubt(forces.changes(q, v, a), off_q, off_v, np.broadcast_to(open_a, a.shape))
        torque.append(np.abs(middle) - doubt - swing)
    return carried.least(first, last, torque)


def _doubt(changes: tuple[Array, Array, Array], q: Array, v: Array, a: Array) -> Array:
    """How far torques (n, k) may be off where positions, speeds and accelerations (n, k) may be by so much."""
    by_q, by_v, by_a = (np.abs(change) for change in changes)
    return np.asarray((by_q @ q[..., None])[..., 0] + (by_v @ v[..., None])[..., 0] + (by_a @ a[..., None])[..., 0])


Given = tuple[Load, bytes]  # a load and the pose of its frame on the flange


def _loads(program: Program) -> dict[int, tuple[Given, ...]]:
    """What each move carries, by its index."""
    out: dict[int, tuple[Given, ...]] = {}
    tool = None
    for i, motion in enumerate(program.motions):
        if isinstance(motion, Wait | SignalEvent):
            continue
        tool = tool if isinstance(motion, MoveExtJ) else motion.tool
        given: list[Given] = []
        if tool is not None and tool.load is not None:
            given.append((tool.load, np.eye(4).tobytes()))
        if motion.settings.load is not None and motion.settings.load.mass > 0:
            given.append((motion.settings.load, (np.eye(4) if tool is None else np.asarray(tool.X_FT)).tobytes()))
        out[i] = tuple(given)
    return out


def _body(load: Load, frame: bytes) -> Body:
    """Mass, centre and inertia about it in the flange's frame."""
    X = np.frombuffer(frame).reshape(4, 4)
    w, x, y, z = np.array(load.aom) / np.linalg.norm(load.aom)
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    axes = X[:3, :3] @ (np.eye(3) + 2 * w * K + 2 * K @ K)
    return load.mass, X[:3, :3] @ np.array(load.cog) + X[:3, 3], axes @ np.diag(load.inertia) @ axes.T
