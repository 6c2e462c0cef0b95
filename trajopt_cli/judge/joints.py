"""Axes against their own limits: position, speed, acceleration, and speed columns against positions."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.judge.findings import Columns, Series, SourceAt, Worst, axis_unit, finding
from trajopt_cli.judge.samples import INNER, LAGS, Rows, mean_of, second_differences, windows
from trajopt_cli.judge.tolerances import JOINT
from trajopt_cli.limits import CoupledRange

_RESTING = 32  # rows of rest that are looked at before a file and behind it
_ROW = 1e-3  # s between them
_FROM_REST = len(LAGS) - 0.5  # place among the accelerations: behind the second differences


def check_joints(rows: Rows, source_at: SourceAt) -> list[Finding]:
    """Worst case per axis of position, speed and acceleration, of jerk where its limits bind, and of the speed columns
    where there are any; of the position of coupled joints."""
    limits = rows.plant.limits
    tops = {"speed": limits.velocity, "acceleration": rows.accelerations.most}
    if limits.binding_jerk is not None:
        tops["jerk"] = limits.binding_jerk
    series = {"speed": _axis_speeds, "acceleration": axis_accelerations, "jerk": _jerks}
    axes = range(len(limits.names))
    found = {check: Columns(top) for check, top in tops.items()}
    highest, lowest, columns = (Columns(np.ones(len(axes))) for _ in range(3))
    last = len(rows.t) - 1
    for part in windows(0, last):
        for check in tops:
            found[check].add(series[check](rows, *part))
        places = [*_positions(rows, *part)]
        highest.add((times, up) for times, up, _ in places)
        lowest.add((times, -down) for times, _, down in places)
        if rows.qd is not None:
            columns.add([(rows.t[part[0] : part[1]], _off_columns(rows, *part)[0])])
    found["acceleration"].add([_from_rest(rows)], begin=_FROM_REST)
    out = [_coupled(rows, one, source_at) for one in limits.coupled]
    for j, name in enumerate(limits.names):
        out.append(_position(rows, j, highest.worst(j), lowest.worst(j), source_at))
        for check, rate in (("speed", "/s"), ("acceleration", "/s2"), ("jerk", "/s3")):
            if check in tops:
                worst = found[check].worst(j)
                worst = at_posture(rows, j, worst) if check == "acceleration" else worst
                passed = worst.value <= worst.limit * (1 + JOINT)
                out.append(
                    finding(
                        f"joint {check}", name, worst.value, worst.limit, axis_unit(name) + rate, passed,
                        time=worst.time, source=source_at(worst.time), words=check,
                    )
                )  # fmt: skip
        if rows.qd is not None:
            out.append(_speed_column(rows, j, columns.worst(j).time, source_at))
    return out


def _positions(rows: Rows, first: int, last: int) -> Iterator[tuple[Array, Array, Array]]:
    """Times (m,), highest and lowest positions (m, k) between two rows: rows, where speeds say that an axis turned
    back between two rows (it went on for at least v^2/(2A) after the one and before the other), and the Hermite."""
    part = slice(first, last + 1)
    q, t = rows.q[part], rows.t[part]
    yield t, q, q
    if rows.qd is not None:
        v = rows.qd[part]
        over, under = (v[:-1] > 0) & (v[1:] < 0), (v[:-1] < 0) & (v[1:] > 0)
        at = np.flatnonzero((over | under).any(axis=1))
        here, after = first + at, first + at + 1
        reaches = [
            np.maximum(np.abs(rows.qd[i]) - rows.doubt_v[i], 0) ** 2 / (2 * rows.accelerations.most)
            for i in (here, after)
        ]
        q_0, q_1 = rows.q[here], rows.q[after]
        peak = np.maximum(q_0 + reaches[0], q_1 + reaches[1])
        valley = np.minimum(q_0 - reaches[0], q_1 - reaches[1])
        yield t[at], np.where(over[at], peak, q_0), np.where(under[at], valley, q_0)
    if rows.exact:
        times, inner, _, _ = _between(rows, first, last)
        yield times, inner, inner


def _coupled(rows: Rows, one: CoupledRange, source_at: SourceAt) -> Finding:
    """The sum of coupled joints farthest beyond its range, or nearest to its end: in rows, where speeds say that it
    turned back between two rows, and on the Hermite."""
    limits = rows.plant.limits
    at, factors = [limits.names.index(axis) for axis in one.axes], np.array(one.factors)
    top = float(np.abs(factors) @ rows.accelerations.most[at])
    up, down = Series(), Series()
    last = len(rows.t) - 1
    for part in windows(0, last):
        t = rows.t[part[0] : part[1] + 1]
        x = rows.q[part[0] : part[1] + 1, at] @ factors
        places = [(t, x, x)]
        if rows.qd is not None:
            v = rows.qd[part[0] : part[1] + 1, at] @ factors
            doubt_v = rows.doubt_v[part[0] : part[1] + 1, at] @ np.abs(factors)
            reach = np.maximum(np.abs(v) - doubt_v, 0) ** 2 / (2 * top)
            over, under = (v[:-1] > 0) & (v[1:] < 0), (v[:-1] < 0) & (v[1:] > 0)
            peak = np.where(over, np.maximum(x[:-1] + reach[:-1], x[1:] + reach[1:]), x[:-1])
            valley = np.where(under, np.minimum(x[:-1] - reach[:-1], x[1:] - reach[1:]), x[:-1])
            places.append((t[:-1], peak, valley))
        if rows.exact:
            times, inner, _, _ = _between(rows, *part)
            places.append((times, inner[:, at] @ factors, inner[:, at] @ factors))
        up.add((times, high) for times, high, _ in places)
        down.add((times, -low) for times, _, low in places)
    upper_is_worse = up.worst.value - one.upper >= one.lower + down.worst.value
    worst, limit = (up.worst, one.upper) if upper_is_worse else (down.worst, one.lower)
    value = worst.value if upper_is_worse else -worst.value
    doubt_q = float(np.abs(factors) @ rows.doubt_q[row_at(rows, worst.time)][at])
    excess = (value - limit if upper_is_worse else limit - value) - doubt_q / 2
    return finding(
        "joint position", one.name, value, limit, "rad", excess <= JOINT * (one.upper - one.lower),
        time=worst.time, source=source_at(worst.time), words="position",
    )  # fmt: skip


def row_at(rows: Rows, time: float) -> int:
    """The coarser printed of the rows beside a time."""
    i = int(np.searchsorted(rows.t, time))
    return max((i, max(i - 1, 0)), key=lambda row: float(rows.doubt_q[row].sum()))


def _between(rows: Rows, first: int, last: int) -> tuple[Array, ...]:
    """The Hermite's places from row to row."""
    part = slice(first * len(INNER), last * len(INNER))
    return tuple(places[part] for places in rows.hermite_places)


def _position(rows: Rows, j: int, up: Worst, down: Worst, source_at: SourceAt) -> Finding:
    """The position farthest beyond its range, or nearest to its end. down: the lowest, negative."""
    limits = rows.plant.limits
    name, low, high = limits.names[j], limits.lower[j], limits.upper[j]
    upper_is_worse = up.value - high >= low + down.value
    value, limit, time = (up.value, high, up.time) if upper_is_worse else (-down.value, low, down.time)
    excess = (value - high if upper_is_worse else low - value) - rows.doubt_q[row_at(rows, time), j] / 2
    return finding(
        "joint position", name, value, float(limit), axis_unit(name), excess <= JOINT * (high - low),
        time=time, source=source_at(time), words="position",
    )  # fmt: skip


def _axis_speeds(rows: Rows, first: int, last: int) -> Iterator[tuple[Array, Array]]:
    """Times (m,) and of all axes (m, k) mean speeds over all lags; printed speeds; and the least peak speed of any
    motion between two rows.

    With |a| <= A a motion from v0 to v1 covers at most D = (v0 + v1) h/2 + A h^2/4 - (v1 - v0)^2/(4A) in h; if it
    covers less, it need not go faster than (v0 + v1 + A h)/2 - sqrt(A (D - d)).
    """
    part = slice(first, last + 1)
    t, q, off_q, off_t = rows.t[part], rows.q[part], rows.doubt_q[part] / 2, rows.step_t[part] / 2
    for m in LAGS:
        if m < len(t):
            path = np.maximum(np.abs(q[m:] - q[:-m]) - off_q[m:] - off_q[:-m], 0.0)
            yield t[:-m], path / (t[m:] - t[:-m] + off_t[m:] + off_t[:-m])[:, None]
    if rows.qd is None:
        return
    v, doubt_v = rows.qd[part], rows.doubt_v[part]
    yield t, np.abs(v) - doubt_v
    doubt_v = np.maximum(doubt_v[1:], doubt_v[:-1])
    e, doubt_e = (values[first:last] for values in rows.mismatch)
    if rows.exact:
        inner_t, _, inner_v, _ = _between(rows, first, last)
        # the Hermite's speed is that of its rows plus 6u(1-u) e at most
        yield inner_t, np.abs(inner_v) - np.repeat(doubt_v + 1.5 * doubt_e, len(INNER), axis=0)
    top = rows.accelerations.most * (1 + JOINT)
    h = np.diff(t)[:, None]
    e = np.sign(e) * np.maximum(np.abs(e) - doubt_e, 0.0)
    both, change = v[1:] + v[:-1], v[1:] - v[:-1]
    for sign in (1.0, -1.0):
        spare = top * h * h / 4 - change**2 / (4 * top) - sign * e * h
        yield t[:-1], (sign * both + top * h) / 2 - np.sqrt(top * np.maximum(spare, 0.0)) - doubt_v


def _from_rest(rows: Rows) -> tuple[Array, Array]:
    """Least accelerations (2, k) of the axes beside both ends of the file, where they are at rest: they move by A h^2/2
    at most."""
    ends = np.array([0, len(rows.t) - 2])
    way = (rows.q[ends + 1] - rows.q[ends]) * np.array([[1], [-1]])  # of an axis that comes to rest, against the brakes
    step = np.maximum(np.abs(way) - mean_of(rows.doubt_q, ends, ends + 1), 0.0)
    h = rows.t[ends + 1] - rows.t[ends] + rows.unsure(ends, ends + 1)
    allowed = np.concatenate([rows.accelerations.along(rows.q[i : i + 2]) for i in ends], axis=1)
    share = rows.accelerations.shares(allowed, way)
    return rows.t[ends + np.array([0, 1])], 2 * step / (h**2)[:, None] * share


def axis_accelerations(rows: Rows, first: int, last: int) -> Iterator[tuple[Array, Array]]:
    """Least accelerations (m, k) of the axes between two rows, with their times (m,): second divided differences over
    all lags; speed differences; the Hermite's ends. Where the posture allows less than the most, as many times larger
    as it is less."""
    may = rows.accelerations
    allowed = may.along(rows.q[first : last + 1]) if may.by_posture else np.zeros(0)
    part, between = slice(first, last + 1), slice(first, last)
    t, off_t = rows.t[part], rows.step_t[part]
    for m, value, uncertain in second_differences(t, rows.q[part], rows.doubt_q[part] / 2, off_t):
        yield t[m : len(t) - m], (np.abs(value) - uncertain) * may.shares(allowed, value, 2 * m)
    h = np.diff(t)[:, None]
    if rows.qd is None:
        return
    v, off_v = rows.qd[part], rows.doubt_v[part] / 2
    for m in LAGS:
        if m < len(t):
            change = v[m:] - v[:-m]
            least = np.maximum(np.abs(change) - off_v[m:] - off_v[:-m], 0) * may.shares(allowed, change, m)
            yield t[:-m], least / (t[m:] - t[:-m] + (off_t[m:] + off_t[:-m]) / 2)[:, None]
    if rows.exact:
        here = may.at(rows.q[part]) if may.by_posture else np.zeros((2, 0))
        mean = np.diff(v, axis=0) / h
        swing = 6 * rows.mismatch[0][between] / h
        uncertain = rows.hermite_rounding[between] + rows.truncation[between]
        yield t[:-1], (np.abs(mean + swing) - uncertain) * may.shares(here[:, :-1], mean + swing)
        yield t[1:], (np.abs(mean - swing) - uncertain) * may.shares(here[:, 1:], mean - swing)


def at_posture(rows: Rows, j: int, worst: Worst) -> Worst:
    """The worst acceleration of axis j as it is, and what the posture there allows."""
    if not rows.accelerations.by_posture:
        return worst
    i = int(np.clip(np.searchsorted(rows.t, worst.time), 1, len(rows.t) - 2))
    before, after = ((rows.q[k + 1, j] - rows.q[k, j]) / (rows.t[k + 1] - rows.t[k]) for k in (i - 1, i))
    allowed = float(rows.accelerations.at(rows.q[i : i + 1])[int(after > before), 0, j])
    factor = allowed / float(rows.accelerations.most[j])
    return Worst(worst.value * factor, worst.limit * factor, worst.time)


def _jerks(rows: Rows, first: int, last: int) -> Iterator[tuple[Array, Array]]:
    """Least jerks (m, k) of the axes with their times (m,), from rest at both ends of the file: second divided
    differences of the speeds over all lags, without speeds third ones of the positions. Both are means of the jerk with
    a positive kernel, so an acceleration that jumps by more than the limit allows between the nearest rows shows."""
    before = np.arange(-_RESTING, 0) * _ROW + rows.t[0] if first == 0 else rows.t[:0]
    after = np.arange(1, _RESTING + 1) * _ROW + rows.t[-1] if last == len(rows.t) - 1 else rows.t[:0]
    beside = len(before), len(after)
    # a lag of third differences reaches farther than windows overlap
    part = slice(first, min(last + LAGS[-1], len(rows.t) - 1) + 1)
    t = np.concatenate([before, rows.t[part], after])
    x, steps = (rows.q, rows.doubt_q) if rows.qd is None else (rows.qd, rows.doubt_v)
    ends = (x[:1], x[-1:]) if rows.qd is None else (np.zeros_like(x[:1]), np.zeros_like(x[:1]))
    table = np.concatenate([np.repeat(ends[0], beside[0], axis=0), x[part], np.repeat(ends[1], beside[1], axis=0)])
    half = np.pad(steps[part] / 2, (beside, (0, 0)), mode="edge")
    off_t = np.pad(rows.step_t[part], beside, mode="edge")
    for m, value, uncertain in second_differences(t, table, half, off_t):
        if rows.qd is not None:
            yield t[m : len(t) - m], np.abs(value) - uncertain
        elif len(value) > m:
            span = t[3 * m :] - t[: -3 * m] + (off_t[3 * m :] + off_t[: -3 * m]) / 2
            third = np.abs(value[m:] - value[:-m]) - (uncertain[m:] + uncertain[:-m])
            yield t[m : len(t) - 2 * m], 3 * third / span[:, None]


def _off_columns(rows: Rows, first: int, last: int) -> tuple[Array, Array, Array]:
    """Mean speeds from positions against the mean of the speeds printed at both rows, of the intervals between two
    rows (m, k): by how much more they differ than they may, how much they do, and how much they may.

    With |a| <= A they differ by A h/4 (1 - ((v1 - v0)/(A h))^2) at most: full acceleration one way, then the other.
    """
    assert rows.qd is not None
    top, part = rows.accelerations.most * (1 + JOINT), slice(first, last + 1)
    h, (e, doubt) = np.diff(rows.t[part])[:, None], (values[first:last] for values in rows.mismatch)
    off_v = mean_of(rows.doubt_v, slice(first, last), slice(first + 1, last + 1))
    used = np.maximum(np.abs(np.diff(rows.qd[part], axis=0)) - off_v, 0.0) / (top * h)
    room = top * h / 4 * (1 - np.minimum(used, 1.0) ** 2)
    return np.abs(e) - doubt - room, np.abs(e), room + doubt


def _speed_column(rows: Rows, j: int, time: float, source_at: SourceAt) -> Finding:
    """The worst of the speed columns: of the interval that begins at a time."""
    name, i = rows.plant.limits.names[j], int(np.searchsorted(rows.t, time))
    excess, off, room = (float(values[0, j]) for values in _off_columns(rows, i, i + 1))
    # Where the speeds alone break the acceleration limit, that is the finding, not the mismatch.
    return finding(
        "speed columns", name, off, room, axis_unit(name) + "/s", excess <= 0,
        time=time, source=source_at(time), note=" between mean speed of the positions and the printed speeds",
    )  # fmt: skip
