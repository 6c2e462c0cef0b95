"""Findings about points: start and end, stops reached at rest, fly-bys passed, waits, programmed times."""

from __future__ import annotations

from collections.abc import Iterator
from math import isnan

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.judge.findings import axis_unit, finding
from trajopt_cli.judge.free_turns import off_taught, turn_of, turned_by
from trajopt_cli.judge.geometry import angle_between, lengths
from trajopt_cli.judge.program_points import ProgramPoint, stands_for
from trajopt_cli.judge.rail import rail_beside
from trajopt_cli.judge.samples import Rows, unseen
from trajopt_cli.judge.timeline import Timeline, Visit, outside_zones
from trajopt_cli.judge.tolerances import (
    DURATION,
    DWELL,
    JOINT_TARGET,
    REST_ANGULAR,
    REST_JOINT,
    REST_LINEAR,
    STOP_POSITION,
    STOP_ROTATION,
)
from trajopt_cli.judge.tool_kinematics import Places, ToolKinematics
from trajopt_cli.judge.waypoint_matching import off_passed
from trajopt_cli.motion import MoveExtJ, Source


def check_stops(
    line: Timeline, frames: dict[bytes, ToolKinematics], rapid: bool, start: Array | None = None
) -> Iterator[tuple[int, list[Finding]]]:
    """All findings about points in program order with their rows, the start's first and the end's last. start (k,):
    where the motion must begin if not where the plant does: of a loop's cycle where it ends."""
    rows = line.rows
    yield 0, _ends(rows, 0, "start", rows.plant.start if start is None else start, None)
    for i, visit in enumerate(line.visits):
        yield visit.depart, [*_findings_of_visit(line, frames[np.asarray(visit.point.X_FT).tobytes()], i, rapid)]
    last = line.visits[-1]
    out = _ends(rows, len(rows.t) - 1, "end", None, last.point.source)
    if last.event is not None:
        over = float(rows.t[-1] - rows.t[last.depart])
        message_note = f": nothing may follow {last.point.name}"
        passed = last.depart == len(rows.t) - 1
        out.append(
            finding("end", "motion after it", over, 0.0, "s", passed, time=float(rows.t[last.depart]),
                    source=last.point.source, note=message_note)
        )  # fmt: skip
    yield len(rows.t), out


def _findings_of_visit(line: Timeline, frame: ToolKinematics, i: int, rapid: bool) -> Iterator[Finding]:
    """All findings about visit i."""
    rows, visit, before = line.rows, line.visits[i], line.visits[max(i - 1, 0)]
    if i > 0 and visit.point.beside > 0 and None not in (visit.event, before.event):
        yield _beside(rows, before, visit)
    if visit.point.fly_by is not None:
        yield _fly_by_passed(rows, visit, frame, line, i)
        return
    if i > 0:
        yield _reached(rows, visit, frame, line, i)
    if visit.event is None:
        return
    yield from _rail_at_target(rows, visit)
    # in a run the moves beside a point share the time of its corner
    if i > 0 and visit.point.duration is not None and before.point.fly_by is None:
        yield _duration(rows, before, visit, _rest_over(line, i))
    elif i > 0:
        yield from _least(line, frame, i)
    yield from _dwells(rows, visit)
    if visit.holds or visit.stay:
        yield from _drift(rows, visit, before, frame)
    if rapid:
        yield from _axes_stand(rows, visit)


def _ends(rows: Rows, row: int, name: str, wanted: Array | None, source: Source | None) -> list[Finding]:
    """Axis positions (where wanted) and rest of every axis at the first or last row.

    Without speed columns an axis that rests there moves A h/2 at most per second to the neighbour.
    """
    limits, time = rows.plant.limits, float(rows.t[row])
    out = []
    if wanted is not None:
        off = np.abs(rows.q[row] - wanted) - rows.doubt_q[row] / 2
        j = int(np.argmax(off))
        passed = bool(off[j] <= JOINT_TARGET)
        out.append(
            finding(name, limits.names[j], rows.q[row, j], float(wanted[j]), axis_unit(limits.names[j]), passed,
                    time=time, source=source, bound="wanted")
        )  # fmt: skip
    if rows.qd is not None:
        # the first and the last row are the boundary itself, however sparse the others
        speed = np.abs(rows.qd[row]) - rows.doubt_v[row]
    else:
        a, b = (0, 1) if row == 0 else (row - 1, row)
        h = float(rows.t[b] - rows.t[a]) + rows.doubt_t
        c = np.maximum(np.abs(rows.q[b] - rows.q[a]) - (rows.doubt_q[a] + rows.doubt_q[b]) / 2, 0) / h
        speed = c - rows.accelerations.most * h / 2
    j = int(np.argmax(speed))
    passed = bool(speed[j] <= REST_JOINT)
    note = f": every axis must rest at the {name}"
    axis, unit = limits.names[j], axis_unit(limits.names[j]) + "/s"
    least = max(float(speed[j]), 0.0)
    out.append(finding(f"{name} rest", axis, least, REST_JOINT, unit, passed, time=time, source=source, note=note))
    return out


def _fly_by_passed(rows: Rows, visit: Visit, frame: ToolKinematics, line: Timeline, i: int) -> Finding:
    """Whether a point was passed in program order, no farther away than its zone reaches."""
    point = visit.point
    assert point.fly_by is not None
    chords = _meanwhile(rows, line, i) if visit.event is None else np.arange(visit.event.first, visit.event.last)
    distance, unit = off_passed(frame, point, chords), "rad" if point.fly_by.in_place else "m"
    at = int(np.argmin(distance))
    least = max(float(distance[at] - (0.0 if point.fly_by.in_place else frame.reach[chords[at]])), 0.0)
    return finding("fly-by passed", "TCP", least, point.fly_by.radius, unit, visit.event is not None,
                   time=float(rows.t[chords[at]]), source=point.source, bound="at most",
                   note=f": {point.name} is not passed in program order")  # fmt: skip


def _meanwhile(rows: Rows, line: Timeline, i: int) -> NDArray[np.intp]:
    """The intervals between rows from the point before a visit that is missing to the next one found, at least one."""
    following = next((v for v in line.visits[i + 1 :] if v.event is not None), None)
    last = len(rows.t) - 1 if following is None else following.arrive
    first = min(line.visits[i].depart, last, len(rows.t) - 2)
    return np.arange(first, max(last, first + 1))


def _reached(rows: Rows, visit: Visit, frame: ToolKinematics, line: Timeline, i: int) -> Finding:
    """Whether the stop was reached, and at rest; else the closest the file comes to it before the next stop."""
    stop, closeness = visit.point, visit.match.closeness
    assert closeness is not None
    unit, subject = ("m", "TCP") if stop.X_WF is not None and stop.arm is None else ("rad", "arm")
    if isinstance(stop.move, MoveExtJ):
        unit, subject = "m", rows.plant.limits.names[0]
    if visit.event is None:
        between = _meanwhile(rows, line, i)
        close = closeness(np.arange(between[0], min(between[-1] + 2, len(rows.t))))
        nearest = int(np.argmin(close.distance))
        row = int(close.at[nearest])
        axes = stop.arm is not None or isinstance(stop.move, MoveExtJ)
        value, limit, unit = (
            _off(visit, frame, row) if not axes else (close.distance[nearest] * JOINT_TARGET, JOINT_TARGET, unit)
        )
        for name, d, wanted in zip(rows.plant.limits.names, rows.q[row].tolist(), stop.rail or (), strict=False):
            if (off := abs(d - wanted)) / JOINT_TARGET >= value / limit:
                subject, value, limit, unit = name, off, JOINT_TARGET, "m"
        note = f": {stop.name} is not reached in program order, the TCP runs {frame.least_speed[row]:.3g} m/s there"
        return finding("stop reached", subject, value, limit, unit, False, time=float(rows.t[row]), source=stop.source,
                       note=note)  # fmt: skip
    granted = REST_LINEAR + rows.plant.tcp.acceleration * rows.open_time[visit.arrive]
    value = float(frame.least_speed[visit.arrive])
    turning = float(frame.least_turning[visit.arrive])
    seen = "" if rows.marked else f" (rows {2 * rows.open_time[visit.arrive]:.3g} s apart show rest to this)"
    rests = bool(closeness(np.array([visit.arrive])).rests[0])
    if not rests and value <= granted:
        return finding("stop rest", "TCP", turning, REST_ANGULAR, "rad/s", False, time=float(rows.t[visit.arrive]),
                       source=stop.source, note=f" at {stop.name}{seen}")  # fmt: skip
    return finding("stop rest", "TCP", value, float(granted), "m/s", rests, time=float(rows.t[visit.arrive]),
                   source=stop.source, note=f" at {stop.name}{seen}")  # fmt: skip


def _off(visit: Visit, frame: ToolKinematics, row: int) -> tuple[float, float, str]:
    """Distance or angle from the stop's pose at a row, whichever is farther in tolerances; its limit and unit."""
    X_WT = visit.X_WF @ visit.point.X_FT
    d_p = float(np.linalg.norm(frame.p[row] - X_WT[:3, 3]))
    d_R = float(off_taught(frame.rotations(np.array([row]))[0], X_WT[:3, :3], visit.point.free))
    if d_p / STOP_POSITION >= d_R / STOP_ROTATION:
        return d_p, STOP_POSITION, "m"
    return d_R, STOP_ROTATION, "rad"


def _rail_at_target(rows: Rows, visit: Visit) -> list[Finding]:
    """The rail at its programmed value, where the program fixes it."""
    stop = visit.point
    if stop.rail is None or isinstance(stop.move, MoveExtJ) or stop.move is None:
        return []
    at = np.array([visit.arrive])
    (beside,), (most,) = rail_beside(rows, at, stop)
    each = zip(rows.plant.limits.names, beside.tolist(), stop.rail, most.tolist(), strict=False)
    return [
        finding("rail target", name, value, wanted, "m", abs(value - wanted) <= granted,
                time=float(rows.t[visit.arrive]), source=stop.source, bound="wanted", note=f" at {stop.name}")
        for name, value, wanted, granted in each if not isnan(wanted)
    ]  # fmt: skip


def _rest_over(line: Timeline, i: int) -> float:
    """By how much the rest that visit i begins is longer than its waits and all moves behind it that take no time of
    their own [s]: a slow end comes within a stop's tolerance long before it is over."""
    visits, first = line.visits, line.visits[i]
    last = i + 1
    while last < len(visits) and (visits[last].stay or visits[last].at_once_after(visits[last - 1])):
        last += 1
    needed = sum(hold.end - hold.begin for visit in visits[i:last] for hold in visit.holds)
    needed += sum(visit.point.duration or visit.point.least for visit in visits[i + 1 : last])
    return max(float(line.rows.t[visits[last - 1].depart] - line.rows.t[first.arrive]) - needed, 0.0)


def _duration(rows: Rows, before: Visit, visit: Visit, rest_after: float) -> Finding:
    """The programmed time of a move against the times it can have taken: between the rests beside it.

    A rest longer than its waits may belong to the move or not; of a move that stays only the least can be seen.
    rest_after [s]: how much of that there is behind it.
    """
    wanted = visit.point.duration or 0.0
    taken = _taken(rows, before, visit, rest_after, wanted)
    passed = abs(taken - wanted) <= _unsure(rows, before, visit)
    return finding("duration", visit.point.name, taken, wanted, "s", passed, time=float(rows.t[visit.arrive]),
                   source=visit.point.source, bound="programmed")  # fmt: skip


def _least(line: Timeline, frame: ToolKinematics, i: int) -> Iterator[Finding]:
    """The moves that end at stop i and at the points passed before it, against what positioners or other robots take
    for them: all together, and each where corners share its time with the moves beside it."""
    visits, first = line.visits, i - 1
    while visits[first].point.fly_by is not None:
        first -= 1
    if (wanted := sum(visit.point.least for visit in visits[first + 1 : i + 1])) > 0:
        yield _lasting(line.rows, visits[first], visits[i], _rest_over(line, i), wanted)
    for k in range(first + 1, i + 1) if wanted > 0 and i > first + 1 else ():
        begin, end, point = visits[k - 1].depart, visits[k].arrive, visits[k].point
        if k > first + 1:  # from where the move before it has not reached the corner
            out = outside_zones(frame, visits[k - 2], visits[k - 1], "radius", first=False)[1]
            begin = max(out, visits[k - 2].depart)
        if k < i:
            end = min(outside_zones(frame, visits[k], visits[k + 1], "radius", last=False)[0], visits[k + 1].arrive)
        lasts = float(line.rows.t[end] - line.rows.t[begin])
        if point.least > 0:
            yield finding(_whose(point), f"{point.name} with its corners", lasts, point.least, "s",
                          lasts >= point.least - _unsure(line.rows, visits[first], visits[i]),
                          time=float(line.rows.t[begin]), source=point.source, bound="at least",
                          words="lasts")  # fmt: skip


def _whose(point: ProgramPoint) -> str:
    """Who takes a move's least time."""
    return "positioner" if point.move is None or point.move.identity is None else "partner"


def _lasting(rows: Rows, before: Visit, visit: Visit, rest_after: float, wanted: float) -> Finding:
    """The time of a move, the longest it can have taken, against what positioners or other robots take meanwhile."""
    taken = _taken(rows, before, visit, rest_after, wanted)
    passed = taken >= wanted - _unsure(rows, before, visit)
    return finding(_whose(visit.point), visit.point.name, taken, wanted, "s", passed,
                   time=float(rows.t[visit.arrive]), source=visit.point.source, bound="at least",
                   words="lasts")  # fmt: skip


def _beside(rows: Rows, before: Visit, visit: Visit) -> Finding:
    """The time from the point before to where the next move begins, against what runs beside the move (\\Conc)."""
    wanted, taken = visit.point.beside, float(rows.t[visit.depart] - rows.t[before.depart])
    if before.point.fly_by is not None:
        taken = float(rows.t[visit.depart] - rows.t[before.arrive])
    return finding("duration", visit.point.name, taken, wanted, "s", taken >= wanted - _unsure(rows, before, visit),
                   time=float(rows.t[visit.depart]), source=visit.holds[0].wait.source if visit.holds else None,
                   bound="at least", words="lasts")  # fmt: skip


def _taken(rows: Rows, before: Visit, visit: Visit, rest_after: float, wanted: float) -> float:
    """The time of a move that is nearest to the wanted one, of those it can have taken."""
    if visit.stay:
        return min(wanted, float(rows.t[visit.depart]) - sum(h.end - h.begin for h in visit.holds) - before.ready)
    shortest = float(rows.t[visit.arrive] - rows.t[before.depart])
    longest = shortest + rest_after + max(float(rows.t[before.depart]) - before.ready, 0.0)
    return min(max(wanted, shortest), longest)


def _unsure(rows: Rows, before: Visit, visit: Visit) -> float:
    """What is granted to the time of a move."""
    return DURATION + 2 * rows.doubt_t + unseen(rows, before.depart) / 2 + unseen(rows, visit.arrive)


def _dwells(rows: Rows, visit: Visit) -> list[Finding]:
    """Every wait as long as programmed, and every axis at rest where one ends on a condition."""
    out = []
    leaves = float(rows.t[visit.depart])
    slack = DWELL + rows.doubt_t + 2 * float(rows.open_time[visit.arrive] + rows.open_time[visit.depart])
    for hold in visit.holds:
        wait = hold.wait
        note = f"{': the axes settle' if wait.settles else ''} at {visit.point.name}"
        if wait.duration > 0:
            lasts = min(max(leaves - hold.begin, 0.0), wait.duration)
            out.append(
                finding("dwell length", "TCP", lasts, wait.duration, "s", lasts >= wait.duration - slack,
                        time=hold.begin, source=wait.source, bound="at least", note=note)
            )  # fmt: skip
        if stands_for(wait):
            row = visit.depart if hold.rests is None else hold.rests
            j = int(np.argmax(rows.least_axis_speed[row]))
            name = rows.plant.limits.names[j]
            out.append(
                finding("dwell rest", name, float(rows.least_axis_speed[row, j]), REST_JOINT, axis_unit(name) + "/s",
                        hold.rests is not None, time=float(rows.t[row]), source=wait.source,
                        note=f": every axis must rest when this wait ends,{note}")
            )  # fmt: skip
    return out


def _drift(rows: Rows, visit: Visit, before: Visit, frame: ToolKinematics) -> Iterator[Finding]:
    """The farthest the TCP gets from the stop while it must rest there; none where no row is sure to be inside."""
    first, last = (before.arrive if visit.stay else visit.arrive), visit.depart
    end = max([hold.end for hold in visit.holds], default=visit.ready)
    last = min(last, int(np.searchsorted(rows.t, end + rows.doubt_t, side="right")) - 1)
    # a row within a gap of the boundary may belong to the motion beside it
    while not rows.marked and first < last and rows.t[first] < rows.t[visit.arrive] + 2 * rows.open_time[visit.arrive]:
        first += 1
    while not rows.marked and first < last and rows.t[last] > end - 2 * rows.open_time[visit.depart]:
        last -= 1
    soon = visit.arrive > 0 and rows.t[first] < rows.t[visit.arrive] + 2 * rows.open_time[visit.arrive]
    if soon and not rows.marked:
        return
    source = visit.holds[0].wait.source if visit.holds else visit.point.source
    X_WT, free = visit.X_WF @ visit.point.X_FT, visit.point.free
    if free is not None:  # as it was turned when it came
        X_WT[:3, :3] = turned_by(X_WT[:3, :3], free, turn_of(X_WT[:3, :3].T @ frame.R[visit.arrive], free))
    yield deviation("dwell drift", frame.places(first, max(first, last)), X_WT, source, f" at {visit.point.name}")


def deviation(check: str, places: Places, X_WT: Array, source: Source | None, note: str) -> Finding:
    """The farthest of all places from a pose, position or rotation, whichever uses more of its tolerance."""
    d_p = np.maximum(lengths(places.p - X_WT[:3, 3]) - places.doubt_p, 0.0)
    d_R = np.maximum(angle_between(places.R, X_WT[:3, :3]) - places.doubt_angle, 0.0)
    i, k = int(np.argmax(d_p)), int(np.argmax(d_R))
    if d_p[i] / STOP_POSITION >= d_R[k] / STOP_ROTATION:
        value, limit, unit, time = float(d_p[i]), STOP_POSITION, "m", float(places.t[i])
    else:
        value, limit, unit, time = float(d_R[k]), STOP_ROTATION, "rad", float(places.t[k])
    return finding(check, "TCP", value, limit, unit, value <= limit, time=time, source=source, note=note)


def _axes_stand(rows: Rows, visit: Visit) -> list[Finding]:
    """RAPID: every axis at rest when the TCP arrives, when a wait ends and when it leaves. Where an event has rows with
    every axis at rest, arrival and departure are the first and the last of them."""
    out = []
    moments = [(visit.arrive, visit.point.source), (visit.depart, visit.point.source)]
    moments += [(h.rests if h.rests is not None else visit.depart, h.wait.source) for h in visit.holds]
    for row, source in moments:
        granted = REST_JOINT + rows.accelerations.most * rows.open_time[row]
        j = int(np.argmax(rows.least_axis_speed[row] / granted))
        name = rows.plant.limits.names[j]
        value = float(rows.least_axis_speed[row, j])
        note = f": a RAPID controller stops every axis at {visit.point.name}"
        out.append(
            finding("axes rest", name, value, float(granted[j]), axis_unit(name) + "/s", value <= granted[j],
                    time=float(rows.t[row]), source=source, note=note)
        )  # fmt: skip
    return out
