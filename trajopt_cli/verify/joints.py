"""Axes against their own limits: position, speed, acceleration, and speed columns against positions."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.verify.findings import SourceAt, Worst, axis_unit, finding, worse
from trajopt_cli.verify.rows import LAGS, Rows, second_differences, shortest
from trajopt_cli.verify.tolerances import JOINT

_RESTING = 32  # rows of rest that are looked at before a file and behind it
_ROW = 1e-3  # s between them


def check_joints(rows: Rows, source_at: SourceAt) -> list[Finding]:
    """Worst case per axis of position, speed and acceleration, of jerk where its limits bind, and of the speed columns
    where there are any."""
    limits = rows.plant.limits
    out = []
    allowed = JOINT * (limits.upper - limits.lower)
    for j, name in enumerate(limits.names):
        unit = axis_unit(name)
        out.append(_position(rows, j, float(allowed[j]), source_at))
        checks = [
            ("speed", _speeds(rows, j), limits.velocity[j], "/s"),
            ("acceleration", accelerations(rows, j), limits.acceleration[j], "/s2"),
        ]
        if limits.binding_jerk is not None:
            checks.append(("jerk", _jerks(rows, j), limits.binding_jerk[j], "/s3"))
        for check, places, top, unit_rate in checks:
            worst = _worst(places, float(top))
            passed = worst.value <= top * (1 + JOINT)
            out.append(
                finding(
                    f"joint {check}", name, worst.value, float(top), unit + unit_rate, passed,
                    time=worst.time, source=source_at(worst.time), words=check,
                )
            )  # fmt: skip
        if rows.qd is not None:
            out.append(_speed_column(rows, j, source_at))
    return out


def _worst(places: Iterator[tuple[Array, Array]], limit: float) -> Worst:
    worst: Worst | None = None
    for times, values in places:
        if len(values):
            i = int(np.argmax(values))
            worst = worse(worst, Worst(float(values[i]), limit, float(times[i])))
    assert worst is not None  # two rows give one mean speed, and rest at both ends one acceleration
    return worst


def _position(rows: Rows, j: int, allowed: float, source_at: SourceAt) -> Finding:
    """Rows, the Hermite between them, and where speeds say that the axis turned back between two rows: it went on for
    at least v^2/(2A) after the one and before the other."""
    limits = rows.plant.limits
    name, low, high, top = limits.names[j], limits.lower[j], limits.upper[j], limits.acceleration[j]
    q, t = rows.q[:, j], rows.t
    times, highest, lowest = [t], [q], [q]
    if rows.qd is not None:
        v = rows.qd[:, j]
        reach = np.maximum(np.abs(v) - rows.doubt_v[j], 0) ** 2 / (2 * top)
        peak = np.maximum(q[:-1] + reach[:-1], q[1:] + reach[1:])
        valley = np.minimum(q[:-1] - reach[:-1], q[1:] - reach[1:])
        over, under = (v[:-1] > 0) & (v[1:] < 0), (v[:-1] < 0) & (v[1:] > 0)
        times += [t[:-1][over | under]]
        highest += [np.where(over, peak, q[:-1])[over | under]]
        lowest += [np.where(under, valley, q[:-1])[over | under]]
    if rows.exact:
        inner_t, inner_q, _, _ = rows.hermite_places
        times, highest, lowest = [*times, inner_t], [*highest, inner_q[:, j]], [*lowest, inner_q[:, j]]
    when, up, down = np.concatenate(times), np.concatenate(highest), np.concatenate(lowest)
    i_up, i_down = int(np.argmax(up)), int(np.argmin(down))
    upper_is_worse = up[i_up] - high >= low - down[i_down]
    value, limit = (up[i_up], high) if upper_is_worse else (down[i_down], low)
    time = float(when[i_up if upper_is_worse else i_down])
    excess = (value - high if upper_is_worse else low - value) - rows.doubt_q[j] / 2
    return finding(
        "joint position", name, float(value), float(limit), axis_unit(name), excess <= allowed,
        time=time, source=source_at(time), words="position",
    )  # fmt: skip


def _speeds(rows: Rows, j: int) -> Iterator[tuple[Array, Array]]:
    """Mean speeds over all lags; printed speeds; and the least peak speed of any motion between two rows.

    With |a| <= A a motion from v0 to v1 covers at most D = (v0 + v1) h/2 + A h^2/4 - (v1 - v0)^2/(4A) in h; if it
    covers less, it need not go faster than (v0 + v1 + A h)/2 - sqrt(A (D - d)).
    """
    t, q, doubt = rows.t, rows.q[:, j], rows.doubt_q[j]
    for m in LAGS:
        if m < len(t):
            yield t[:-m], np.maximum(np.abs(q[m:] - q[:-m]) - doubt, 0.0) / (t[m:] - t[:-m] + rows.doubt_t)
    if rows.qd is None:
        return
    v = rows.qd[:, j]
    yield t, np.abs(v) - rows.doubt_v[j]
    if rows.exact:
        inner_t, _, inner_v, _ = rows.hermite_places
        # the Hermite's speed is that of its rows plus 6u(1-u) e at most
        doubt_v = rows.doubt_v[j] + 1.5 * np.repeat(rows.mismatch[1][:, j], len(inner_t) // (len(t) - 1))
        yield inner_t, np.abs(inner_v[:, j]) - doubt_v
    top = rows.plant.limits.acceleration[j] * (1 + JOINT)
    h = np.diff(t)
    e, doubt_e = (part[:, j] for part in rows.mismatch)
    e = np.sign(e) * np.maximum(np.abs(e) - doubt_e, 0.0)
    for sign in (1.0, -1.0):
        total, change = sign * (v[1:] + v[:-1]), v[1:] - v[:-1]
        spare = top * h * h / 4 - change**2 / (4 * top) - sign * e * h
        yield t[:-1], (total + top * h) / 2 - np.sqrt(top * np.maximum(spare, 0.0)) - rows.doubt_v[j]


def accelerations(rows: Rows, j: int, first: int = 0, last: int | None = None) -> Iterator[tuple[Array, Array]]:
    """Least accelerations of axis j between two rows, with their times: second divided differences over all lags;
    speed differences; the Hermite's ends. Of the whole file also from rest at both ends."""
    part, between = slice(first, None if last is None else last + 1), slice(first, last)
    t, q, doubt = rows.t[part], rows.q[part, j : j + 1], rows.doubt_q[j]
    for m, value, uncertain in second_differences(t, q, np.array([[doubt / 2]]), rows.doubt_t):
        yield t[m : len(t) - m], (np.abs(value) - uncertain)[:, 0]
    h = np.diff(t)
    if last is None:
        ends = np.array([0, len(h) - 1])  # the file begins and ends at rest: q moves by A h^2/2 at most beside them
        step = np.maximum(np.abs(np.diff(q[:, 0]))[ends] - doubt, 0.0)
        yield t[ends + np.array([0, 1])], 2 * step / (h[ends] + rows.doubt_t) ** 2
    if rows.qd is None:
        return
    v = rows.qd[part, j]
    for m in LAGS:
        if m < len(t):
            yield t[:-m], np.maximum(np.abs(v[m:] - v[:-m]) - rows.doubt_v[j], 0) / (t[m:] - t[:-m] + rows.doubt_t)
    if rows.exact:
        mean = np.diff(v) / h
        swing = 6 * rows.mismatch[0][between, j] / h
        uncertain = (rows.hermite_rounding + rows.truncation)[between, j]
        yield t[:-1], np.abs(mean + swing) - uncertain
        yield t[1:], np.abs(mean - swing) - uncertain


def _jerks(rows: Rows, j: int) -> Iterator[tuple[Array, Array]]:
    """Least jerks of axis j with their times, from rest at both ends of the file: second divided differences of the
    speeds over all lags, without speeds third ones of the positions. Both are means of the jerk with a positive kernel,
    so an acceleration that jumps by more than the limit allows between the nearest rows shows."""
    before = np.arange(-_RESTING, 0) * _ROW + rows.t[0]
    after = np.arange(1, _RESTING + 1) * _ROW + rows.t[-1]
    t = np.concatenate([before, rows.t, after])
    x, doubt = (rows.q, rows.doubt_q) if rows.qd is None else (rows.qd, rows.doubt_v)
    ends = (0.0, 0.0) if rows.qd is not None else (x[0, j], x[-1, j])
    column = np.pad(x[:, j], _RESTING, constant_values=ends)[:, None]
    for m, value, uncertain in second_differences(t, column, np.array([[doubt[j] / 2]]), rows.doubt_t):
        if rows.qd is not None:
            yield t[m : len(t) - m], (np.abs(value) - uncertain)[:, 0]
        elif len(value) > m:
            span = shortest(t[3 * m :] - t[: -3 * m], rows.doubt_t)
            third = np.abs(value[m:] - value[:-m])[:, 0] - (uncertain[m:] + uncertain[:-m])[:, 0]
            yield t[m : len(t) - 2 * m], 3 * third / span


def _speed_column(rows: Rows, j: int, source_at: SourceAt) -> Finding:
    """Mean speed from positions against the mean of the speeds printed at both rows.

    With |a| <= A they differ by A h/4 (1 - ((v1 - v0)/(A h))^2) at most: full acceleration one way, then the other.
    """
    assert rows.qd is not None
    name, top = rows.plant.limits.names[j], rows.plant.limits.acceleration[j] * (1 + JOINT)
    h, (e, doubt) = np.diff(rows.t), (part[:, j] for part in rows.mismatch)
    used = np.maximum(np.abs(np.diff(rows.qd[:, j])) - rows.doubt_v[j], 0.0) / (top * h)
    room = top * h / 4 * (1 - np.minimum(used, 1.0) ** 2)
    excess = np.abs(e) - doubt - room
    i = int(np.argmax(excess))
    time = float(rows.t[i])
    # Where the speeds alone break the acceleration limit, that is the finding, not the mismatch.
    broken = bool(excess[i] > 0)
    return finding(
        "speed columns", name, float(abs(e[i])), float(room[i] + doubt[i]), axis_unit(name) + "/s", not broken,
        time=time, source=source_at(time), note=" between mean speed of the positions and the printed speeds",
    )  # fmt: skip
