"""Arrivals and departures: each point of the program with its rows, its waits and the time left over."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.judge.free_turns import off_taught
from trajopt_cli.judge.geometry import inverse_pose, lengths
from trajopt_cli.judge.program_points import ProgramPoint, stands_for, stays
from trajopt_cli.judge.rail import Indices, still_from
from trajopt_cli.judge.samples import Rows, unseen
from trajopt_cli.judge.tolerances import DWELL, LINE_POSITION
from trajopt_cli.judge.tool_kinematics import ToolKinematics
from trajopt_cli.judge.waypoint_matching import Event, Match, candidate_rows, closeness_at, events_of, off_passed
from trajopt_cli.motion import Source, Wait


@dataclass(frozen=True, eq=False)
class Hold:
    """A wait as it came out: it begins at `begin` [s] and must keep the stop until `end`. rests: the row where every
    axis stands at its end, None where that is wanted and never so."""

    wait: Wait
    begin: float
    end: float
    rests: int | None


@dataclass(frozen=True, eq=False)
class Visit:
    """A point as it came out; one that is passed arrives with the row before it and departs with the row after it.

    event: None where the file never shows it; the rows are then those of the stop before. arrive, depart: first and
    last row. ready: the earliest time [s] at which the next move may begin. X_WF: the wanted pose, or the one at
    arrival where the program leaves it to the axes. stay: reached without leaving the stop before. corner: first and
    last row of the one in which the tool changes here; None where it does not.
    """

    match: Match
    event: Event | None
    stay: bool
    arrive: int
    depart: int
    ready: float
    X_WF: Array
    holds: tuple[Hold, ...] = ()
    corner: tuple[int, int] | None = None

    @property
    def point(self) -> ProgramPoint:
        """What was asked for."""
        return self.match.point

    def at_once_after(self, before: Visit) -> bool:
        """Whether this stop is reached in the rest of the one before it, as the file shows both."""
        both = self.event is not None and before.event is not None
        return both and self.point.fly_by is None and self.arrive <= before.depart


@dataclass(frozen=True, eq=False)
class Timeline:
    """All points with their rows; the start first. turned: the tool over work objects that turn meanwhile, by the
    number of the motion that is drawn there."""

    rows: Rows
    visits: tuple[Visit, ...]
    turned: Mapping[int, ToolKinematics] = field(default_factory=dict)

    def source_at(self, time: float) -> Source | None:
        """The motion under way at a time: the move that ends next, or the wait."""
        for visit in self.visits:
            if visit.event is None:
                continue
            if time <= self.rows.t[visit.arrive] + self.rows.doubt_t:
                return visit.point.source
            for hold in visit.holds:
                if time < hold.end - self.rows.doubt_t:
                    return hold.wait.source
        return self.visits[-1].point.source

    def runs(self) -> list[tuple[Visit, ...]]:
        """From stop to stop with all that is passed between them, where the file shows every point and leaves the
        first."""
        found, chain = [], [self.visits[0]]
        for visit in self.visits[1:]:
            chain.append(visit)
            if visit.point.fly_by is None:
                if not visit.stay and all(one.event is not None for one in chain):
                    found.append(tuple(chain))
                chain = [visit]
        return found


def rows_of_run(rows: Rows, visits: Sequence[Visit]) -> tuple[int, int]:
    """Rows of a run alone: between rests. Where no row stands at a rest, its nearest row is not on the way yet."""
    first, last = visits[0].depart, visits[-1].arrive
    if not rows.marked and last - first > 2:
        return first + 1, last - 1
    return first, last


def rows_of_move(rows: Rows, before: Visit, visit: Visit) -> tuple[int, int]:
    """Rows of a move from stop to stop, or of its part of a run; the nearest row of a rest without a row of its own
    left out."""
    first, last = before.depart, visit.arrive
    if not rows.marked and last - first > 2:
        return first + (before.point.fly_by is None), last - (visit.point.fly_by is None)
    return first, last


def outside_zones(
    frame: ToolKinematics, before: Visit, visit: Visit, zone: str, first: bool = True, last: bool = True
) -> tuple[int, int]:
    """First and last row of a move outside the zones (radius, turning or external) at its ends; the last before the
    first where there is none. first, last: which zones to leave out."""
    a, b = rows_of_move(frame.rows, before, visit)
    if first and before.point.fly_by is not None and before.point.fly_by.joint and before.corner is not None:
        a = before.corner[1] + 1
    elif first and before.point.fly_by is not None:
        out = _far(frame, a, b, before.point, zone)
        a = int(out[0]) if len(out) else b + 1
    if last and visit.point.fly_by is not None and visit.point.fly_by.joint and visit.corner is not None:
        b = visit.corner[0] - 1
    elif last and visit.point.fly_by is not None:
        out = _far(frame, a, b, visit.point, zone)
        b = int(out[-1]) if len(out) else a - 1
    return a, b


def tool_corner(tools: Sequence[ToolKinematics], visits: Sequence[Visit]) -> tuple[int, int]:
    """First and last row of the corner at the second of three visits, in which one of two tools goes over into the
    other: from where the first one's centre point enters the zone to where the other's leaves it. None is in force
    between, and the other one comes no farther from its point than it is at the beginning."""
    before, visit, after = visits
    assert visit.event is not None
    assert visit.point.fly_by is not None
    size, begin = visit.point.fly_by.radius, max(min(visit.event.first, visit.arrive), before.depart)
    near = np.flatnonzero(_away(tools[0], begin, visit.arrive, visit.point) <= size)
    first = begin + int(near[0]) if len(near) else visit.arrive
    most = max(float(_away(tools[1], max(first - 1, begin), first, visit.point).max()), size)
    away = _away(tools[1], visit.depart, max(after.arrive, visit.depart), visit.point)
    inside = np.flatnonzero(away <= size)
    if not len(inside) or away[: inside[0] + 1].max() > most + LINE_POSITION:
        return first, visit.depart
    out = np.flatnonzero(away[inside[0] :] > size)
    return first, visit.depart + int(inside[0] + (out[0] if len(out) else len(away) - inside[0])) - 1


def _far(frame: ToolKinematics, a: int, b: int, point: ProgramPoint, zone: str) -> Indices:
    """The rows a to b farther from a point than its zone reaches."""
    return a + np.flatnonzero(_away(frame, a, b, point) > getattr(point.fly_by, zone))


def _away(frame: ToolKinematics, a: int, b: int, point: ProgramPoint) -> Array:
    """How far a tool is from a point that is passed at rows a to b, in what its zone counts: [m] or [rad]."""
    assert point.fly_by is not None
    X_WT = point.X_WT
    if point.fly_by.joint:
        X_WT = X_WT @ inverse_pose(point.X_FT) @ frame.X_FT
    if point.fly_by.in_place:
        return off_taught(frame.rotations(np.arange(a, b + 1)), X_WT[:3, :3], point.free)
    return lengths(frame.p[a : b + 1] - X_WT[:3, 3])


def build_timeline(
    rows: Rows, frames: dict[bytes, ToolKinematics], start: ProgramPoint, matches: Sequence[Match], rapid: bool
) -> Timeline:
    """Walk through the stops in order. rapid: every axis must stand at the end of every wait."""
    visits = [_first_stop(rows, frames[np.asarray(start.X_FT).tobytes()], start, rapid)]
    for k, m in enumerate(matches):
        behind = (matches[i].event for i in range(k + 1, len(matches)))
        after = next((event for event in behind if event is not None and event is not m.event), None)
        before = visits[-1]
        if m.event is None:
            if not m.point.optional:
                X_WF = before.X_WF if m.point.X_WF is None else m.point.X_WF
                visits.append(Visit(m, None, False, before.arrive, before.depart, before.ready, X_WF))
            continue
        if m.point.fly_by is not None:
            visits.append(_pass(rows, frames[np.asarray(m.point.X_FT).tobytes()], m, m.event, before))
            continue
        visit = _visit(rows, m, m.event, before, len(rows.t) if after is None else after.first, rapid)
        if visit.arrive < before.depart:  # both in one rest: the stop before ends where this one begins
            visits[-1] = replace(before, depart=visit.arrive)
        visits.append(visit)
    for k in range(1, len(visits) - 1):
        near = visits[k - 1 : k + 2]
        tools = [frames[np.asarray(one.point.X_FT).tobytes()] for one in near[1:]]
        if near[1].event is not None and near[1].point.fly_by is not None and tools[0] is not tools[1]:
            visits[k] = replace(near[1], corner=tool_corner(tools, near))
    return Timeline(rows, tuple(visits))


def _first_stop(rows: Rows, frame: ToolKinematics, start: ProgramPoint, rapid: bool) -> Visit:
    """The stop at the first row, whatever its axes are; it lasts as long as the TCP rests there."""
    assert start.X_WF is not None
    here = replace(start, index=-1, move=None, source=None, arm=None, rail=None, optional=False)
    closeness = closeness_at(rows, frame, here, rapid)
    events = events_of(closeness(candidate_rows(rows, frame, here)))
    event = events[0] if events and events[0].first == 0 else Event(0, 0, np.array([], dtype=np.intp), 0)
    depart = event.end if len(event.good) else 0
    holds = _holds(rows, here, float(rows.t[0]), depart, rapid)
    ready = holds[-1].end if holds else float(rows.t[0])
    m = Match(here, closeness, event, ())
    return Visit(m, event, False, 0, depart, ready, start.X_WF, holds)


def _pass(rows: Rows, frame: ToolKinematics, m: Match, event: Event, before: Visit) -> Visit:
    """A point that is passed, where the chords between rows come nearest to it, not before the point before it."""
    assert m.point.X_WF is not None
    first = min(before.depart, len(rows.t) - 2)
    chords = np.arange(max(event.first, first), max(event.last, first + 1))
    arrive = max(int(chords[np.argmin(off_passed(frame, m.point, chords))]), before.depart)
    depart = min(arrive + 1, len(rows.t) - 1)
    return Visit(m, event, False, arrive, depart, float(rows.t[arrive]), m.point.X_WF)


def _visit(rows: Rows, m: Match, event: Event, before: Visit, limit: int, rapid: bool) -> Visit:
    stop, good = m.point, event.good
    stay = stays(stop, before.X_WF)
    one_rest = event is before.event or (before.event is not None and before.event.shares_rest(event))
    least = before.ready + ((stop.duration or stop.least) if stay or one_rest else 0.0)
    arrive, depart = event.best, event.best
    if len(good):
        since = good[rows.t[good] >= least - DWELL - rows.doubt_t - unseen(rows, event.best)]
        arrive, depart = int(since[0] if len(since) else good[-1]), int(good[-1])
    depart = _across_drift(rows, m, arrive, depart, limit)
    begin = float(rows.t[arrive])
    if arrive - 1 in good and arrive in good:
        begin = max(least, float(rows.t[arrive - 1]))  # the rest goes on: nothing happens at the row itself
    holds = _holds(rows, stop, begin, depart, rapid)
    ready = holds[-1].end if holds else begin
    X_WF = rows.X_WF[arrive] if stop.X_WF is None else stop.X_WF
    return Visit(m, event, stay, arrive, depart, ready, X_WF, holds)


def _holds(rows: Rows, point: ProgramPoint, time: float, depart: int, rapid: bool) -> tuple[Hold, ...]:
    """Let every wait take its time from `time` on, and go on until every axis stands where that is wanted. One that
    holds the rail begins when the rail has come to rest: a point may last longer than its waits."""
    out = []
    for _, wait in point.holds:
        if wait.hold is not None and rows.mechanism.has_rail:
            time = still_from(rows, time, wait.duration, depart)
        end, rests = time + wait.duration, None
        if stands_for(wait) or rapid:
            slack = DWELL + rows.doubt_t + unseen(rows, depart)
            first = min(int(np.searchsorted(rows.t, end - slack)), depart)
            # the nearest place need not be in the nearest row in time: that may be the one behind it
            last = depart + (rows.open_time[depart] > 0)
            still = first + np.flatnonzero(rows.axes_rest[first : last + 1])
            if len(still):
                rests = int(still[0])
                if rests > first or not rows.axes_rest[max(first - 1, 0)]:  # else the axes stand at `end` already
                    end = max(end, float(rows.t[min(rests, depart)]))
        out.append(Hold(wait, time, end, rests))
        time = end
    return tuple(out)


def _across_drift(rows: Rows, m: Match, arrive: int, depart: int, limit: int) -> int:
    """The departure after a drift: within the waits the TCP left the stop and came back before the next stop.

    The drift itself is found where the dwell is looked at; here it must not pass for a dwell cut short.
    """
    wanted = float(rows.t[arrive]) + sum(wait.duration for _, wait in m.point.holds)
    if rows.t[depart] >= wanted - DWELL - unseen(rows, depart):
        return depart
    assert m.event is not None
    later = (e for e in m.events if m.event.last < e.first < limit)
    back = [e for e in later if rows.t[e.first] <= wanted + rows.doubt_t and len(e.good)]
    return back[-1].end if back else depart
