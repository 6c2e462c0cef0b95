"""When a file without marks is at which point of the program.

Near rows: a row is near a stop when its pose is the wanted one within tolerance (for a MoveAbsJ its arm joints, for a
MoveExtJ its rail with the TCP at rest). A file that has no row at the boundary itself shows a stop in its nearest row,
half a gap tau away at most, where the TCP may still be a tau^2/2 off and have the speed a tau: that much is granted.

An event is an unbroken run of near rows, broken as well where the rail leaves its programmed position: where it moves
alone, the pose is the same all the while. Its good rows are those where the TCP rests as well (for RAPID: every axis)
and a programmed rail position is met. Events are then matched with the stops in program order so that most stops find
a good event (an event without good rows counts less, one without a row at the stop itself a hair less, a missed
optional point hardly; one with the rail where the program writes it a hair more, in the order of time, though a plan
may have it elsewhere: moves that the rail alone tells apart have one pose), the earliest where several do. So one wrong
stop stays one wrong stop: a point flown by, skipped or swapped does not shift the blame to the points after it.
Consecutive stops at one pose (waits and lines of the redundant axis) share an event; other moves have the next one
where the tool comes back before it goes on.

A point that is passed needs no row: between two rows the TCP is no farther from their chord than a h^2/8. Its events
are unbroken runs of intervals whose chords come so near to its zone (on an arc, to its second half), and its place in
time is where the polyline through the rows comes nearest. It is matched in order with the stops.

Within an event the time runs: the first good row is the arrival, each wait and each `\\T` takes its length from there,
the last good row is the latest departure. A rest may be longer than asked; a slow plan is legal.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.geometry import Array
from trajopt_cli.judge.free_turns import off_taught
from trajopt_cli.judge.geometry import angle_between, lengths
from trajopt_cli.judge.program_points import ProgramPoint, stays
from trajopt_cli.judge.rail import rail_beside
from trajopt_cli.judge.samples import ROUNDING, Rows
from trajopt_cli.judge.tolerances import JOINT_TARGET, REST_ANGULAR, REST_LINEAR, STOP_POSITION, STOP_ROTATION
from trajopt_cli.judge.tool_kinematics import ToolKinematics, angular_acceleration
from trajopt_cli.motion import MoveExtJ

_AS_WRITTEN = 1e-6  # worth of a rail as the program writes it, where it is free
_GRANTED = 0.99  # worth of a stop that only counts by what is granted for missing rows: one with a row of its own is it

WHOLE = 0.9  # fraction of a path that rows on it show at least: they are the corners of a polyline

Mask = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Closeness:
    """How near some rows are to a stop: at (m,), in order. distance (m,): the larger of position and rotation (or axes,
    the rail where it is not met) in tolerances.

    tight: within tolerance without anything granted for missing rows. rests: the TCP stands. rail_met: the rail is
    where the program wants it. stands: every axis rests (RAPID; else always true). rail (m, r) [m]: where it is; None
    without one.
    """

    at: NDArray[np.intp]
    distance: Array
    near: Mask
    tight: Mask
    rests: Mask
    rail_met: Mask
    stands: Mask
    rail: Array | None = None


ClosenessAt = Callable[[NDArray[np.intp]], Closeness]


@dataclass(frozen=True, eq=False)
class Event:
    """A run of near rows [first, last]; good: the rows in it that count as the stop itself, maybe none. granted: none
    of those is within tolerance but for what is granted for missing rows. rail: where it is in them [m]; None for
    none."""

    first: int
    last: int
    good: NDArray[np.intp]
    best: int
    granted: bool = False
    rail: Array | None = None

    @property
    def end(self) -> int:
        """The last row that counts."""
        return int(self.good[-1]) if len(self.good) else self.last

    def shares_rest(self, other: Event) -> bool:
        """Whether the rows that count are partly those of another event: two stops at poses a rounding apart."""
        return bool(len(self.good) and len(other.good)) and self.good[0] <= other.end and other.good[0] <= self.end


@dataclass(frozen=True, eq=False)
class Match:
    """What a point found in the file. event None: it was never near. events: all of it and of points alike. closeness:
    how near any rows are to it, None for a point that is passed."""

    point: ProgramPoint
    closeness: ClosenessAt | None
    event: Event | None
    events: tuple[Event, ...]


def closeness_at(rows: Rows, frame: ToolKinematics, point: ProgramPoint, rapid: bool) -> ClosenessAt:
    """How near rows are to one point. rapid: every axis must stand there."""
    return lambda at: _closeness(rows, frame, point, rapid, at)


def _closeness(rows: Rows, frame: ToolKinematics, point: ProgramPoint, rapid: bool, at: NDArray[np.intp]) -> Closeness:
    tau, q = rows.open_time[at], rows.q[at]
    a, alpha = rows.plant.tcp.acceleration, angular_acceleration(rows)
    rests = (frame.least_speed[at] <= REST_LINEAR + a * tau) & (frame.least_turning[at] <= REST_ANGULAR + alpha * tau)
    stands: Mask = rows.axes_rest[at] if rapid else np.ones(len(at), dtype=bool)
    rail_met, rail = np.ones(len(at), dtype=bool), q[:, : rows.mechanism.rails] if rows.mechanism.has_rail else None
    off_rail = np.zeros(len(at))
    if point.rail is not None:
        beside, most = rail_beside(rows, at, point)
        rail_met = np.all(~(np.abs(beside - point.rail) > most), axis=1)  # of one left open nothing is wanted
        off_rail = np.nan_to_num(np.abs(q[:, : len(point.rail)] - point.rail)).max(axis=1)
    near: Mask
    tight: Mask
    if isinstance(point.move, MoveExtJ):
        doubt = rows.doubt_q[at, : rows.mechanism.rails].max(axis=1)
        near, tight = rail_met & rests, off_rail <= JOINT_TARGET + doubt / 2
        return Closeness(at, off_rail / JOINT_TARGET, near, tight, rests, rail_met, stands, rail)
    if point.arm is not None:
        granted = JOINT_TARGET + rows.doubt_q[at] / 2 + rows.accelerations.most * tau[:, None] ** 2 / 2
        off = np.abs(q[:, -6:] - point.arm)
        near = np.asarray((off <= granted[:, -6:]).all(axis=1))
        if point.X_WF is None:  # the arm may keep its posture all through moves of the rail
            near &= rests
        tight = np.asarray((off <= JOINT_TARGET + rows.doubt_q[at, -6:] / 2).all(axis=1))
        distance = np.maximum(off.max(axis=1), np.where(rail_met, 0.0, off_rail)) / JOINT_TARGET
        return Closeness(at, distance, near, tight, rests, rail_met, stands, rail)
    assert point.X_WF is not None
    X_WT = point.X_WF @ point.X_FT
    d_p = np.maximum(lengths(frame.p[at] - X_WT[:3, 3]) - frame.doubt_p[at], 0.0)
    d_R = np.maximum(off_taught(frame.rotations(at), X_WT[:3, :3], point.free) - frame.doubt_R[at], 0.0)
    near = (d_p <= STOP_POSITION + a * tau**2 / 2) & (d_R <= STOP_ROTATION + alpha * tau**2 / 2)
    tight = (d_p <= STOP_POSITION) & (d_R <= STOP_ROTATION)
    if point.free is not None:  # any turn will do, but one: as in the row before or behind, or at rest by its speeds
        R = frame.rotations(at)
        near_by = [np.clip(at + step, 0, len(rows.t) - 1) for step in (-1, 1)]
        apart = [np.where(k == at, np.inf, angle_between(R, frame.rotations(k))) for k in near_by]
        stays_so = np.minimum(*apart) - 2 * frame.doubt_R[at] <= STOP_ROTATION
        tight &= stays_so if rows.qd is None else stays_so | (frame.least_turning[at] <= REST_ANGULAR)
    distance = np.maximum(d_p / STOP_POSITION, d_R / STOP_ROTATION)
    return Closeness(at, distance, near, tight, rests, rail_met, stands, rail)


def candidate_rows(rows: Rows, frame: ToolKinematics, point: ProgramPoint) -> NDArray[np.intp]:
    """The rows that may be near a point: no more is looked at in a long file."""
    if isinstance(point.move, MoveExtJ):
        return np.arange(len(rows.t))
    if point.arm is not None:
        return rows.blocks.rows(rows.arm_boxes.near(point.arm))
    P, a = point.X_WT[:3, 3], rows.plant.tcp.acceleration
    at = rows.blocks.rows(frame.stop_boxes.near(P))
    granted = STOP_POSITION + a * rows.open_time[at] ** 2 / 2 + frame.doubt_p[at]
    near: Mask = lengths(frame.p[at] - P) <= granted + ROUNDING
    return np.asarray(at[near])


def events_of(close: Closeness) -> tuple[Event, ...]:
    """All events of one stop, in time order."""
    near = np.flatnonzero(close.near)
    out = []
    gone = close.rail_met[near[:-1]] & ~close.rail_met[near[1:]]
    for run in np.split(near, np.flatnonzero((np.diff(close.at[near]) > 1) | gone) + 1) if len(near) else []:
        resting = run[close.rests[run]]
        good = resting[close.rail_met[resting] & close.stands[resting]]
        pool = resting if len(resting) else run
        best = int(close.at[pool[np.argmin(close.distance[pool])]])
        core = _core(close, good)
        granted = bool(len(core)) and not close.tight[core].any()
        rail = close.rail[core] if close.rail is not None and len(core) else None
        out.append(Event(int(close.at[run[0]]), int(close.at[run[-1]]), close.at[core], best, granted, rail))
    return tuple(out)


def _core(close: Closeness, good: NDArray[np.intp]) -> NDArray[np.intp]:
    """Of every unbroken run of good places among the rows the tight ones, or else the closest: where something is
    granted for missing rows, rows of the motion beside the stop are good as well. RAPID's axes rest at both ends of a
    dwell: two runs."""
    runs = np.split(good, np.flatnonzero(np.diff(good) > 1) + 1) if len(good) else []
    kept = []
    for run in runs:
        tight = run[close.tight[run]]
        kept.append(tight if len(tight) else run[[int(np.argmin(close.distance[run]))]])
    return np.concatenate(kept) if kept else good


def passages(rows: Rows, frame: ToolKinematics, point: ProgramPoint) -> tuple[Event, ...]:
    """All events of a point that is passed, in time order; best: the row before the nearest place, and the one that
    counts, for the chord to it may hold more points."""
    assert point.fly_by is not None
    if point.fly_by.in_place:
        return _turned_past(rows, frame, point)
    P = point.X_WT[:3, 3]
    size = point.fly_by.radius + STOP_POSITION
    at = rows.blocks.rows(frame.way_boxes.near(P, size))
    at = at[at < len(frame.reach)]
    reach = frame.reach[at] + lengths(frame.p[at + 1] - frame.p[at])
    close = at[_squares_off(frame, P, at) <= (size + reach) ** 2 + 1e-9]
    if not len(close):
        return ()
    distance, fraction = off_chords(frame.p, P, close)
    near = distance <= size + frame.reach[close]
    away = close[:0]
    if point.curve is not None:
        nearest = frame.p[close] + fraction[:, None] * (frame.p[close + 1] - frame.p[close])
        first_half = point.curve.progress(nearest) < 0.5
        away, near = close[first_half], near & ~first_half
    close, distance = close[near], distance[near]
    gaps = [
        int(k)
        for k in np.flatnonzero(np.diff(close) > 1) + 1
        if _leaves(frame, P, close[k - 1], close[k], size + float(frame.reach[close[[k - 1, k]]].max()), away)
    ]
    out = []
    for run in np.split(np.arange(len(close)), gaps) if len(close) else []:
        best = int(close[run[np.argmin(distance[run])]])
        out.append(Event(int(close[run[0]]), int(close[run[-1]]) + 1, np.array([max(best - 1, 0)]), best))
    return tuple(out)


def _turned_past(rows: Rows, frame: ToolKinematics, point: ProgramPoint) -> tuple[Event, ...]:
    """The same between two reorientations: intervals at its place that come near to its orientation."""
    assert point.fly_by is not None
    at = rows.blocks.rows(frame.way_boxes.near(point.X_WT[:3, 3], STOP_POSITION))
    at = at[at < len(frame.reach)]
    there = lengths(frame.p[at] - point.X_WT[:3, 3]) <= STOP_POSITION + frame.reach[at] + frame.doubt_p[at]
    at = at[there]
    off, between = off_turns(frame, point, at)
    beyond = off - point.fly_by.turning - STOP_ROTATION
    most = between.max(initial=0.0) / 2  # at a zone's edge a long interval may count as near and a short one not
    near = np.flatnonzero(beyond <= most)
    out = []
    for run in np.split(near, np.flatnonzero(np.diff(at[near]) > 1) + 1) if len(near) else []:
        if (beyond[run] <= between[run] / 2).any():
            best = int(at[run[np.argmin(off[run])]])
            out.append(Event(int(at[run[0]]), int(at[run[-1]]) + 1, np.array([max(best - 1, 0)]), best))
    return tuple(out)


def off_turns(frame: ToolKinematics, point: ProgramPoint, chords: NDArray[np.intp]) -> tuple[Array, Array]:
    """Angles (m,) between a point's orientation and the nearer end of intervals, and how far the tool turns in each."""
    R, after = frame.rotations(chords), frame.rotations(chords + 1)
    off = np.minimum(*(off_taught(one, point.X_WT[:3, :3], point.free) for one in (R, after)))
    return np.asarray(off), np.asarray(angle_between(R, after))


def off_passed(frame: ToolKinematics, point: ProgramPoint, chords: NDArray[np.intp]) -> Array:
    """How far (m,) intervals are from a point that is passed, in what its zone counts: [m] of their chords or [rad]."""
    if point.fly_by is not None and point.fly_by.in_place:
        return off_turns(frame, point, chords)[0]
    return off_chords(frame.p, point.X_WT[:3, 3], chords)[0]


def _squares_off(frame: ToolKinematics, P: Array, at: NDArray[np.intp]) -> Array:
    """Squares (m,) of the distances of rows from a point, to rounding."""
    p = frame.p[at]
    return np.asarray((p * p).sum(axis=1) - 2 * p @ P + P @ P)


def _leaves(frame: ToolKinematics, P: Array, before: int, after: int, size: float, away: NDArray[np.intp]) -> bool:
    """Whether the TCP is farther away between two intervals that come near than they are granted, or on the first half
    of an arc. At a zone's edge a long interval may count as near and a short one behind it not."""
    between = slice(*np.searchsorted(away, (before, after)))
    inside = frame.rows.blocks.inside(before, after)
    if len(away[between]) > 0 or (frame.way_boxes.off(P, inside) > size + ROUNDING).any():
        return True
    return float(_squares_off(frame, P, np.arange(before + 1, after + 1)).max()) > size**2


def never_near(rows: Rows, frames: dict[bytes, ToolKinematics], points: Sequence[ProgramPoint]) -> set[int]:
    """The indices of optional moves to whose points, or zones as programmed, the TCP never comes."""
    out = set[int]()
    for point in points:
        if point.optional and point.X_WF is not None and point.move is not None:
            frame = frames[np.asarray(point.X_FT).tobytes()]
            reach = point.move.zone.radius + STOP_POSITION + frame.reach
            chords = np.arange(len(rows.t) - 1)
            if (off_chords(frame.p, point.X_WT[:3, 3], chords)[0] > reach).all():
                out.add(point.index)
    return out


def off_chords(p: Array, P: Array, chords: NDArray[np.intp]) -> tuple[Array, Array]:
    """Distances (m,) of a point P (3,) from the chords that begin at places p[chords], and the share of each where it
    is nearest."""
    a, path = p[chords], p[chords + 1] - p[chords]
    fraction = np.clip(((P - a) * path).sum(axis=1) / np.maximum((path * path).sum(axis=1), 1e-300), 0.0, 1.0)
    return lengths(a + fraction[:, None] * path - P), fraction


def match(rows: Rows, frames: dict[bytes, ToolKinematics], points: Sequence[ProgramPoint], rapid: bool) -> list[Match]:
    """Every point after the start with its event; see the module's docstring for the rule."""
    known: dict[tuple[object, ...], tuple[ClosenessAt | None, tuple[Event, ...]]] = {}
    found = []
    for point in points[1:]:
        key = tuple(
            None if part is None else np.asarray(part).tobytes() for part in (point.X_WF, point.X_FT, point.arm)
        )
        curve = None if point.curve is None or point.fly_by is None else id(point)
        full = (*key, point.rail, isinstance(point.move, MoveExtJ), point.fly_by, curve, point.free)
        if full not in known:
            frame = frames[np.asarray(point.X_FT).tobytes()]
            if point.fly_by is not None:
                known[full] = None, passages(rows, frame, point)
            else:
                closeness = closeness_at(rows, frame, point, rapid)
                known[full] = closeness, events_of(closeness(candidate_rows(rows, frame, point)))
        found.append(known[full])
    events = [own for _, own in found]
    chosen = _align(points[1:], events)
    if any(event is None or not len(event.good) for event in chosen):
        cut = _cut(frames, points[1:], events)
        other = _align(points[1:], cut)
        if _total(points[1:], other) > _total(points[1:], chosen):
            events, chosen = cut, other
    return [
        Match(point, closeness, event, own)
        for point, (closeness, _), own, event in zip(points[1:], found, events, chosen, strict=True)
    ]


def _cut(
    frames: dict[bytes, ToolKinematics], points: Sequence[ProgramPoint], events: Sequence[tuple[Event, ...]]
) -> list[tuple[Event, ...]]:
    """The events, those of a passage cut in two where the next point is a stop that is reached in them before the
    nearest place: the motion behind a short way that ends in the zone may come nearer to its point. The tool goes from
    the passage to the stop on as long a way as there is between them: nothing is left out."""
    out = list(events)
    for k, ((point, stop), own) in enumerate(zip(pairwise(points), events[:-1], strict=True)):
        if point.fly_by is None or point.fly_by.in_place or stop.fly_by is not None or stop.X_WF is None:
            continue
        frame, P, parts = frames[np.asarray(point.X_FT).tobytes()], point.X_WT[:3, 3], list[Event]()
        chord = float(np.linalg.norm(stop.X_WT[:3, 3] - P))
        path = (chord if stop.curve is None else stop.curve.length) - point.fly_by.radius
        for event in own:
            first = event.first
            for end in (one.end for one in events[k + 1] if len(one.good) and one.end <= event.best):
                if first >= end:
                    continue
                best = first + int(np.argmin(off_chords(frame.p, P, np.arange(first, end))[0]))
                gone = lengths(np.diff(frame.p[best : end + 1], axis=0)).sum()
                if gone > WHOLE * path:
                    parts.append(Event(first, end, np.array([max(best - 1, 0)]), best))
                    first = end
            parts.append(event if first == event.first else Event(first, event.last, event.good, event.best))
        out[k] = tuple(parts)
    return out


def _total(points: Sequence[ProgramPoint], chosen: Sequence[Event | None]) -> float:
    return sum(_worth(point, event) for point, event in zip(points, chosen, strict=True) if event is not None)


def _align(points: Sequence[ProgramPoint], events: Sequence[tuple[Event, ...]]) -> list[Event | None]:
    """The events of most worth that follow each other, the earliest of several; a rail that is not as written leaves
    them as they are."""
    anyhow = [replace(point, written=None) for point in points]
    chosen = _at_once(points, events) or _at_once(anyhow, events) or _of_most_worth(points, events)
    return _spread(points, events, chosen)


def _spread(
    points: Sequence[ProgramPoint], events: Sequence[tuple[Event, ...]], chosen: Sequence[Event | None]
) -> list[Event | None]:
    """The choice, but where moves to one pose share an event and the tool comes back to it before it goes on to another
    point, moves that take it away have these events, one after the other."""
    out = list(chosen)
    ends: list[float] = [np.inf] * len(out)  # where the next other event begins
    for k in range(len(out) - 2, -1, -1):
        after = out[k + 1]
        ends[k] = ends[k + 1] if after is None or after is out[k] else after.first
    for k in range(1, len(out)):
        before, event, point = out[k - 1], out[k], points[k]
        if before is None or event is not chosen[k - 1] or point.fly_by is not None:
            continue
        X_WF = points[k - 1].X_WF
        more = () if X_WF is not None and stays(point, X_WF) else events[k]
        back = (one for one in more if len(one.good) and before.end < one.first and one.end < ends[k])
        out[k] = next(back, before)
    return out


def _at_once(points: Sequence[ProgramPoint], events: Sequence[tuple[Event, ...]]) -> list[Event | None] | None:
    """For every point the first event of its greatest worth that is not over; None where one has none left. What can be
    had so no other choice is worth more than, nor earlier: a file as it should be is aligned in one go."""
    known: dict[tuple[int, tuple[float, ...] | None], tuple[list[int], list[float], float]] = {}
    chosen: list[Event | None] = []
    now = moment = 0
    for point, own in zip(points, events, strict=True):
        if not own:
            chosen.append(None)
            continue
        if (id(own), point.written) not in known:
            worth = [_worth(point, event) for event in own]
            ends = [event.end if point.fly_by is None else event.last for event in own]
            known[id(own), point.written] = ends, worth, max(worth)
        ends, worth, most = known[id(own), point.written]
        for pick in range(bisect_left(ends, now), len(own)):
            row = _as_written_from(point, own[pick], moment) if worth[pick] == most else None
            if row is not None:
                break
        else:
            return None
        moment = max(moment, row)
        chosen.append(own[pick])
        now = max(now, own[pick].end)
    return chosen


def _as_written_from(point: ProgramPoint, event: Event, moment: int) -> int | None:
    """The first row of an event, not before a moment, where the rail is as the program writes it, or has come past
    that. None for none; the moment itself where the rail is not so in any row."""
    if point.written is None or event.rail is None:
        return moment
    off = event.rail - point.written
    each = np.abs(off) <= JOINT_TARGET
    each[1:] |= off[1:] * off[:-1] < 0
    met = each.all(axis=1)
    rows = event.good[met]
    later = rows[rows >= moment]
    return moment if not len(rows) else int(later[0]) if len(later) else None


def _of_most_worth(points: Sequence[ProgramPoint], events: Sequence[tuple[Event, ...]]) -> list[Event | None]:
    """Dynamic programme from the last point back: value[r] is what the points from here on are worth from rank r on.

    Of the passages of one point all are worth the same, so the first that is not over yet is the best."""
    ends = np.array(sorted({event.end for own in events for event in own}), dtype=np.intp)
    rank = {int(end): r for r, end in enumerate(ends)}
    values = [np.zeros(len(ends) + 1)]
    for point, own in zip(reversed(points), reversed(events), strict=True):
        after = values[-1]
        if point.fly_by is not None:
            values.append(_passing(point, own, ends, after))
            continue
        gain = np.full(len(ends) + 1, -np.inf)
        for event in own:
            r = rank[event.end]
            gain[r] = max(gain[r], _worth(point, event) + after[r])
        values.append(np.maximum(after, np.maximum.accumulate(gain[::-1])[::-1]))
    values.reverse()
    chosen: list[Event | None] = []
    now = 0
    for k, (point, own) in enumerate(zip(points, events, strict=True)):
        pick = None
        for event in own:
            over = now < len(ends) and event.last < ends[now] if point.fly_by is not None else rank[event.end] < now
            r = max(rank[event.end], now)
            if not over and _worth(point, event) + values[k + 1][r] >= values[k][now] - 1e-9:
                pick, now = event, r
                break
        chosen.append(pick)
    return chosen


def _passing(point: ProgramPoint, own: tuple[Event, ...], ends: NDArray[np.intp], after: Array) -> Array:
    """The values before a point that is passed, from those after it."""
    if not own:
        return after
    first = np.searchsorted([event.last for event in own], ends)
    ranks = np.searchsorted(ends, [event.end for event in own])
    there = np.flatnonzero(first < len(own))
    out = np.array(after)
    then = np.maximum(ranks[first[there]], there)
    out[there] = np.maximum(out[there], _worth(point, own[0]) + after[then])
    return out


def _worth(point: ProgramPoint, event: Event) -> float:
    # rows of unequal distances: one a hair before the stop may be granted more than it is off, and the next one not
    worth = 0.6 if not len(event.good) else _GRANTED if event.granted else 1.0
    if point.written is not None and event.rail is not None:
        low, high = event.rail.min(axis=0) - JOINT_TARGET, event.rail.max(axis=0) + JOINT_TARGET
        worth += _AS_WRITTEN * bool(np.all((low <= point.written) & (point.written <= high)))
    return (0.25 if point.optional else 1.0) * worth
