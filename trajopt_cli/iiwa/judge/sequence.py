"""A sequence of poses against the path, the caps and the dwells of its task."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.judge import quaternions as turns
from trajopt_cli.iiwa.judge.chain import Followed, check_chain, follow
from trajopt_cli.iiwa.judge.path import StraightPiece, legs, rotation_of
from trajopt_cli.iiwa.judge.samples import Poses, worst
from trajopt_cli.iiwa.judge.task_order import Order, Stop, periods
from trajopt_cli.iiwa.judge.tolerances import ARM_CAP, BACKWARD, CAP, EXACT, PATH, RAMP, ROUNDING, SLACK
from trajopt_cli.judge.findings import finding

_WINDOW = 2048  # rows that are looked at first


@dataclass(frozen=True, eq=False)
class Visit:
    """When a stop is reached: rows arrived..left, distance [m, rad] at the row arrived, what of it is allowed, periods
    it should stand. legs: the way there, without repeated poses; passed: how the rows followed it where it passes poses
    without a stop."""

    stop: Stop
    arrived: int
    left: int
    off: float
    allowed: float
    dwell: int
    legs: list[StraightPiece]
    passed: Followed | None = None

    @property
    def reached(self) -> bool:
        """Whether the rows come there at all."""
        return self.off <= self.allowed and (self.passed is None or self.passed.lost is None)


def visits(order: Order, way: list[StraightPiece], rows: Poses) -> Iterator[Visit]:
    """The stops in order, as far as the rows reach them; of repeated poses the last one, with the dwells of all.

    Ends with the first one that is not reached.
    """
    assert order.stops is not None
    row, dwell, before, last = 0, 0, 0, len(order.stops) - 1
    for i, stop in enumerate(order.stops):
        dwell += periods(stop.dwell, order.h)
        if order.passing is None and i < last and way[i].L_p == way[i].L_q == 0:
            continue
        if order.passing is not None and 0 < i < last and not (stop.rests or stop.dwell > 0):
            continue
        legs = [leg for leg in way[before:i] if leg.L_p > 0 or leg.L_q > 0]
        q = rotation_of(order, stop)
        passed = None
        if order.passing is not None and legs:
            off, allowed = _off(stop, q, rows, row, len(rows.t))
            passed = follow(legs, rows, row, *order.passing, off - allowed)
            found = passed.last - row
        else:
            off, allowed, found = _first_there(stop, q, rows, row, wait=bool(legs))
        left = row + found
        while left + 1 < len(rows.t) and _off(stop, q, rows, left + 1, left + 2)[0][0] <= off[found] + EXACT:
            left += 1
        one = Visit(stop, row + found, left, float(off[found]), float(allowed[found]), dwell, legs, passed)
        yield one
        if not one.reached:
            return
        row, dwell, before = left, 0, i


def _off(stop: Stop, q: Array, rows: Poses, first: int, end: int) -> tuple[Array, Array]:
    """How far rows first to end - 1 are from a stop with orientation q, m plus rad, and what is allowed."""
    part = slice(first, end)
    off = np.linalg.norm(rows.p[part] - stop.pose[:3], axis=1) + turns.angle_between(rows.q[part], q)
    return off, PATH + (rows.off_p + rows.off_q + rows.open)[part]


def _first_there(stop: Stop, q: Array, rows: Poses, row: int, wait: bool) -> tuple[Array, Array, int]:
    """As _off from a row on, and which of these rows is the first that is there, nearest of its neighbours; row itself
    without wait. Windows grow until there is one: a sequence may have thousands of stops."""
    size = _WINDOW
    while True:
        end = min(row + size, len(rows.t))
        off, allowed = _off(stop, q, rows, row, end)
        near = np.flatnonzero(off <= allowed)
        found = 0 if not wait else int(near[0]) if near.size else int(np.argmin(off - allowed))
        while wait and near.size and found + 1 < len(off) and off[found + 1] < off[found]:
            found += 1
        if end == len(rows.t) or not wait or (near.size and found + 1 < len(off)):
            return off, allowed, found
        size *= 4


def check_sequence(order: Order, rows: Poses, exact: bool = True, retimed: bool = False) -> Iterator[Finding]:
    """The way, the caps and the dwells of every segment; nothing for an order whose stops the judge cannot tell.

    exact: the rows are the sequence itself, whose first and last pose are the task's to the last digit. retimed: by
    another law than the task's profile, so that neither its accelerations nor the length of its dwells are promised.
    """
    if order.stops is None:
        return
    found = list(visits(order, legs(order), rows))
    ramps = order.profile != "thesis" and not retimed
    yield from _reached(order, found, rows, exact)
    yield from _dwells(order, found, rows, retimed)
    for begin, end in pairwise(found):
        part = slice(begin.left, end.arrived + 1)
        if end.passed is not None:
            assert order.passing is not None
            name = f"{begin.stop.name} -> {end.stop.name}"
            yield from check_chain(name, end.legs, rows, end.passed, order.passing)
            if end.reached:
                yield from _caps(order, name, end.legs, end.passed, rows, part, ramps, exact)
        elif end.reached:
            (leg,) = end.legs
            yield from _on_leg(leg.as_gone(rows.q[part]), rows, part)
            yield from _caps(order, leg.name, end.legs, None, rows, part, ramps, exact)


def _reached(order: Order, found: list[Visit], rows: Poses, exact: bool) -> Iterator[Finding]:
    """Every pose, in order; the first in the first row, and the last in the last one."""
    assert order.stops is not None
    words = "comes no nearer than"
    for visit in found:
        at: dict[str, Any] = {"time": _t(rows, visit.arrived), "source": visit.stop.place}
        yield finding(
            "pose reached", visit.stop.name, visit.off, visit.allowed, "m, rad", visit.reached, **at, words=words
        )
    last = found[-1]
    complete = last.stop is order.stops[-1] and last.reached
    missing = 0 if complete else len(order.stops) - order.stops.index(last.stop)
    yield finding("poses missing", "sequence", missing, 0, "poses", missing == 0, words="goes without")
    if exact:
        yield _end("first pose", found[0], rows, 0, "begins beside the pose by")
    if complete:
        after = len(rows.t) - 1 - last.left
        yield finding("rows behind the end", last.stop.name, after, 0, "rows", after == 0, words="is followed by")
        if exact:
            yield _end("last pose", last, rows, -1, "ends beside by")


def _end(check: str, visit: Visit, rows: Poses, row: int, words: str) -> Finding:
    doubt = float((rows.off_p + rows.off_q)[row])
    most = EXACT + (doubt if doubt > 2 * ROUNDING else 0.0)
    more: dict[str, Any] = {"time": _t(rows, row), "source": visit.stop.place, "words": words}
    return finding(check, visit.stop.name, visit.off, most, "m, rad", visit.off <= most, **more)


def _dwells(order: Order, found: list[Visit], rows: Poses, retimed: bool) -> Iterator[Finding]:
    for visit in found:
        if not visit.reached:
            continue
        name, dwell = visit.stop.name, visit.dwell * order.h
        stood = _t(rows, visit.left) - _t(rows, visit.arrived)
        gap = 0.0 if rows.gridded else 2 * float(rows.gaps.max())
        at: dict[str, Any] = {"time": _t(rows, visit.arrived), "source": visit.stop.place}
        if dwell:
            enough = stood >= dwell - gap - order.h / 2
            yield finding("dwell", name, stood, dwell, "s", enough, **at, bound="at least", words="stands for")
        if not retimed:
            most, words = dwell + (SLACK + 0.5) * order.h + gap, "stands longer than its dwell:"
            yield finding("standing", name, stood, most, "s", stood <= most, **at, words=words)


def _on_leg(leg: StraightPiece, rows: Poses, part: slice) -> Iterator[Finding]:
    """How far rows lie off the path between two poses, and back along it. Rows at its ends that are not on it, because
    no row stands at the pose itself, belong to the neighbours as much."""
    if np.any(rows.open):
        part = slice(part.start + 1, part.stop - 1)
    p, q, t = rows.p[part], rows.q[part], rows.t[part]
    if not len(t):
        return
    s = leg.share(p, q)
    p_wanted, q_wanted = leg.at(s)
    source = leg.place
    off, doubt = np.linalg.norm(p - p_wanted, axis=1), rows.off_p[part]
    yield worst("path", leg.name, off, PATH, "m", t, doubt, source=source, words="is off the straight path by")
    off, doubt = turns.angle_between(q, q_wanted), rows.off_q[part]
    yield worst("orientation", leg.name, off, PATH, "rad", t, doubt, source=source, words="is turned off the path by")
    back = np.maximum((np.maximum.accumulate(np.r_[0.0, s[:-1]]) - s) * max(leg.L_p, leg.L_q), 0.0)
    limit = BACKWARD + 2 * float((rows.off_p + rows.off_q)[part].max())
    unit = "m" if leg.L_p >= leg.L_q else "rad"
    yield worst("backward", leg.name, back, limit, unit, t, source=source, words="goes back by")


def _caps(
    order: Order,
    name: str,
    way: list[StraightPiece],
    on: Followed | None,
    rows: Poses,
    part: slice,
    ramps: bool,
    exact: bool,
) -> Iterator[Finding]:
    """Steps against v_max h and omega_max h; with ramps what the steps change by, and what that changes by, too.

    on: which legs of way each row is on, None where there is one and the rows rest at both of its ends.
    """
    rests = on is None and not np.any(rows.open)  # else no row stands at the pose, and those beside it are of two ways
    if on is None and not rests:
        part = slice(part.start + 1, part.stop - 1)
    t = rows.t[part]
    if len(t) < 4:
        return
    gaps = np.diff(t)[:, None]
    parts = []
    if any(leg.L_p for leg in way):
        rough = float(rows.off_p[part].max())
        parts.append((np.diff(rows.p[part], axis=0), rough, ("v_max", "a_max", "jerk"), "m"))
    if any(leg.L_q for leg in way):
        rough = float(rows.off_q[part].max()) + way[0].rounding(rows.q[part])
        parts.append((way[0].steps(rows.q[part]), rough, ("omega_max", "epsilon_max", "angular_jerk"), "rad"))
    for steps, rough, names, unit in parts:
        rates: list[tuple[Array, float, float]] = [(steps / gaps, 2 * rough / float(gaps.min()), CAP)]
        if ramps:
            rates.append((_accelerations(steps, gaps, rests), 4 * rough / float(gaps.min()) ** 2, RAMP))
        if ramps and order.profile == "s-curve" and rows.gridded:
            rates.append((_jerks(steps, order.h, rests), 8 * rough / order.h**3, RAMP))
        for power, ((values, doubt, relative), key) in enumerate(zip(rates, names, strict=False)):
            if key not in way[0].caps:
                continue
            size = np.linalg.norm(values, axis=1)
            caps = _caps_there(way, on, key, len(size))
            relative = max(relative, RAMP if on is not None else 0.0, 0.0 if exact else ARM_CAP)
            row = int(np.argmax((size - doubt) / np.maximum(caps, 1e-300)))
            passed = size[row] <= caps[row] * (1 + relative) + doubt
            yield finding(
                key, name, size[row], caps[row], f"{unit}/s{('', '2', '3')[power]}", passed,
                time=float(t[min(row, len(t) - 1)]), source=way[0].place,
            )  # fmt: skip


def _caps_there(way: list[StraightPiece], on: Followed | None, key: str, count: int) -> Array:
    """The caps (count,) of differences of rows: the greatest of the legs that any of their rows may be on."""
    caps = np.array([leg.caps[key] for leg in way])
    if on is None or np.ptp(caps) == 0:
        return np.full(count, caps[0])
    there = caps[on.leg]
    for further in range(1, int(np.max(on.ahead - on.leg)) + 1):
        there = np.maximum(there, caps[np.minimum(on.leg + further, on.ahead)])
    out = there[:count]
    for shift in range(1, len(there) - count + 1):
        out = np.maximum(out, there[shift : shift + count])
    return np.asarray(out)


def _accelerations(steps: Array, gaps: Array, rests: bool) -> Array:
    """Second divided differences; of a path from rest to rest also at its ends: who is at a step's end after a gap has
    needed twice the step over the gap's square at least."""
    inner = 2 * np.diff(steps / gaps, axis=0) / (gaps[1:] + gaps[:-1])
    if not rests:
        return np.asarray(inner)
    return np.concatenate([2 * steps[:1] / gaps[:1] ** 2, inner, 2 * steps[-1:] / gaps[-1:] ** 2])


def _jerks(steps: Array, h: float, rests: bool) -> Array:
    """Third differences over the cube of the period; rests: of a path that stands still before and behind it."""
    rest = np.zeros((2 if rests else 0, steps.shape[1]))
    return np.asarray(np.diff(np.concatenate([rest, steps, rest]), n=2, axis=0) / h**3)


def _t(rows: Poses, row: int) -> float:
    return float(rows.t[row])
