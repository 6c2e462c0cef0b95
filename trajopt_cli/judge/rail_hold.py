"""Whether the rail stands still in the waits and moves that hold it."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby, pairwise

import numpy as np

from trajopt_cli.findings import Finding
from trajopt_cli.judge.findings import finding
from trajopt_cli.judge.rail import rail_positions, still_from
from trajopt_cli.judge.samples import Rows
from trajopt_cli.judge.timeline import Timeline, Visit, outside_zones, rows_of_run
from trajopt_cli.judge.tolerances import DWELL, HELD
from trajopt_cli.judge.tool_kinematics import ToolKinematics
from trajopt_cli.motion import Hold, Source

_WHY = {
    Hold.PROGRAM: "a comment in the program holds the rail still",
    Hold.CELL: "hold_rail in the cell file holds the rail still",
    Hold.UNIT: "its mechanical unit is not active",
    Hold.GRIPPER: "it holds still after an output; 'waits: {rail: free}' in the cell file lets it move",
    Hold.WAIT: "it holds still in every wait; 'waits: {rail: free}' in the cell file lets it move",
    Hold.SETTLING: "every axis settles at a stop that is waited for",
    Hold.SYNCHRONISED: "no move has room in a wait behind SyncMoveOn",
}


def check_held(line: Timeline, frames: dict[bytes, ToolKinematics]) -> list[Finding]:
    """The way of the rail in every wait and every move that holds it; none on a robot without a rail."""
    return [*_waits(line), *_moves(line, frames), *_unit(line)] if line.rows.mechanism.has_rail else []


def _waits(line: Timeline) -> Iterator[Finding]:
    for visit in line.visits:
        for hold in visit.holds if visit.event is not None else ():
            wait = hold.wait
            if wait.hold is not None and wait.duration > 0:
                part = _within(line.rows, hold.begin, wait.duration, visit.depart)
                yield _still(line.rows, part, f"the wait at {visit.point.name}", wait.hold, wait.source)


def _moves(line: Timeline, frames: dict[bytes, ToolKinematics]) -> Iterator[Finding]:
    """A move to the point where the TCP is already has a stretch of its own only where it has a programmed time. In the
    zone between a move that holds the rail and one that does not it may move."""
    rows, moves = line.rows, [visit.point.move for visit in line.visits]
    for i, (before, visit) in enumerate(pairwise(line.visits)):
        stop = visit.point
        if stop.move is None or stop.move.hold is None or before.event is None or visit.event is None:
            continue
        if not visit.stay:
            free = [move is None or move.hold is None for move in (moves[i], *moves[i + 2 : i + 3])]
            frame = frames[np.asarray(stop.X_FT).tobytes()]
            part = outside_zones(frame, before, visit, "external", free[0], free[-1])
            if part[1] >= part[0]:
                yield _still(rows, part, stop.name, stop.move.hold, stop.source)
        elif stop.duration:
            begin = still_from(rows, before.ready, stop.duration, visit.depart)
            part = _within(rows, begin, stop.duration, visit.depart)
            yield _still(rows, part, stop.name, stop.move.hold, stop.source)


def _unit(line: Timeline) -> Iterator[Finding]:
    """The rail over all moves from DeactUnit to ActUnit of its unit, the stops between them included."""
    visits = line.visits
    for idle, group in groupby(range(1, len(visits)), key=lambda i: _idle(visits[i])):
        if idle:
            first, *_, last = (*group,) * 2
            part = rows_of_run(line.rows, (visits[first - 1], visits[last]))
            if part[1] >= part[0]:
                yield _still(line.rows, part, visits[last].point.name, Hold.UNIT, visits[last].point.source)


def _idle(visit: Visit) -> bool:
    move = visit.point.move
    return move is not None and move.hold is Hold.UNIT and visit.event is not None


def _within(rows: Rows, begin: float, duration: float, depart: int) -> tuple[int, int]:
    """First and last row of a wait, without those that may lie beside it."""
    slack = DWELL + rows.doubt_t
    first = min(int(np.searchsorted(rows.t, begin - slack)), depart)
    end = begin + duration - 2 * rows.open_time[first]
    return first, max(min(int(np.searchsorted(rows.t, end + slack, side="right")) - 1, depart), first)


def _still(rows: Rows, part: tuple[int, int], name: str, why: Hold, source: Source | None) -> Finding:
    """The way of the rail from its least to its greatest position; its time is where it is farthest from the first."""
    t, d, doubt = rail_positions(rows, *part)
    paths = (d - doubt).max(axis=0) - (d + doubt).min(axis=0)
    i = int(np.argmax(paths))
    path = max(float(paths[i]), 0.0)
    far = int(np.argmax(np.abs(d[:, i] - d[0, i])))
    return finding("way while held", rows.plant.limits.names[i], path, HELD, "m", path <= HELD, time=float(t[far]),
                   source=source, note=f" in {name}: {_WHY[why]}")  # fmt: skip
