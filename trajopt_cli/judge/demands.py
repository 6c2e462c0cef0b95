"""Accelerations that a move's own settings allow: AccSet for axes and TCP, PathAccLim along the path, WorldAccLim.

Every other acceleration of a file is held against the machine's limits; here only the rows of moves that ask for less.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import pairwise

import numpy as np

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.judge.caps import Inner, tcp_accelerations
from trajopt_cli.judge.findings import Columns, Worst, axis_unit, finding, worse
from trajopt_cli.judge.geometry import lengths
from trajopt_cli.judge.joints import at_posture, axis_accelerations
from trajopt_cli.judge.samples import LAGS, second_differences
from trajopt_cli.judge.timeline import Timeline, Visit, outside_zones
from trajopt_cli.judge.tolerances import JOINT, TCP
from trajopt_cli.judge.tool_kinematics import ToolKinematics
from trajopt_cli.motion import MoveExtJ, MoveL, Settings

Places = tuple[Array, Array]  # times (m,) and least values there


def check_demands(line: Timeline, frames: dict[bytes, ToolKinematics]) -> Iterator[tuple[int, list[Finding]]]:
    """One finding for each thing that a move asks for, in the order of the moves, with its last row. In the zone of a
    point that is passed the moves beside it go over into each other: what either of them allows is allowed there."""
    visits = line.visits
    for i, (before, visit) in enumerate(pairwise(visits), start=1):
        move = visit.point.move
        if visit.event is None or move is None:
            continue
        frame = line.turned.get(visit.point.index) or frames[np.asarray(visit.point.X_FT).tobytes()]
        first, last = outside_zones(frame, before, visit, "radius")
        if not line.rows.marked:  # rows beside the ends may belong to another motion
            first, last = first + 1, last - 1
        out = [*_demands(line, frame, visit, (first, last), move.settings)]
        after = visits[i + 1] if visit.point.fly_by is not None and i + 1 < len(visits) else None
        if after is not None and after.event is not None and after.point.move is not None:
            then = frames[np.asarray(after.point.X_FT).tobytes()]
            both = _looser(move.settings, after.point.move.settings)
            part = last, outside_zones(then, visit, after, "radius")[0]
            if then is frame:
                out.extend(_demands(line, frame, visit, part, both, corner=True))
            elif part[1] > part[0]:  # no tool is in force where it changes
                out.extend(_axes(line, visit, *part, both))
        yield visit.arrive, out


def _demands(
    line: Timeline, frame: ToolKinematics, visit: Visit, part: tuple[int, int], settings: Settings, corner: bool = False
) -> Iterator[Finding]:
    first, last = part
    if last > first:
        yield from _axes(line, visit, first, last, settings)
        yield from _tool(frame, visit, first, last, settings, corner)


def _looser(one: Settings, other: Settings) -> Settings:
    """What either of two settings allows."""

    def cap(a: float | None, b: float | None) -> float | None:
        return None if a is None or b is None else max(a, b)

    return replace(
        one,
        acceleration=max(one.acceleration, other.acceleration),
        path_acceleration=cap(one.path_acceleration, other.path_acceleration),
        path_deceleration=cap(one.path_deceleration, other.path_deceleration),
        world_acceleration=cap(one.world_acceleration, other.world_acceleration),
    )


def _axes(line: Timeline, visit: Visit, first: int, last: int, settings: Settings) -> Iterator[Finding]:
    """The axis that uses most of its share."""
    limits, fraction = line.rows.plant.limits, settings.acceleration
    if fraction >= 1.0:
        return
    found = Columns(fraction * line.rows.accelerations.most)
    found.add(axis_accelerations(line.rows, first, last))
    each = [found.worst(j) for j in range(len(limits.names))]
    j = int(np.argmax([worst.ratio for worst in each]))
    name, worst = limits.names[j], at_posture(line.rows, j, each[j])
    passed = worst.value <= worst.limit * (1 + JOINT)
    bound = f"AccSet {fraction * 100:g} allows"
    yield finding("AccSet", name, worst.value, worst.limit, f"{axis_unit(name)}/s2", passed, time=worst.time,
                  source=visit.point.source, bound=bound, words="acceleration")  # fmt: skip


def _tool(
    frame: ToolKinematics, visit: Visit, first: int, last: int, settings: Settings, corner: bool
) -> Iterator[Finding]:
    rows, move = frame.rows, visit.point.move
    assert move is not None
    if isinstance(move, MoveExtJ):
        return
    straight = isinstance(move, MoveL) and not corner
    checks: list[tuple[str, str, Iterable[Places], float]] = []
    inner = Inner(frame, first, last) if frame.exact else None
    if settings.acceleration < 1.0:
        cap = settings.acceleration * rows.plant.tcp.acceleration
        word = f"AccSet {settings.acceleration * 100:g}"
        checks.append(("AccSet", word, tcp_accelerations(frame, first, last, inner), cap))
    if settings.world_acceleration is not None:
        whole = tcp_accelerations(frame, first, last, inner)
        checks.append(("WorldAccLim", "WorldAccLim", whole, settings.world_acceleration))
    for sign, along in ((1, settings.path_acceleration), (-1, settings.path_deceleration)):
        if along is not None and (found := _along(frame, (first, last), sign, straight)) is not None:
            checks.append(("PathAccLim", "PathAccLim", found, along))
    for check, word, places, cap in checks:
        worst = _worst_place(places, cap)
        yield finding(check, "TCP", worst.value, cap, "m/s2", worst.value <= cap * (1 + TCP), time=worst.time,
                      source=visit.point.source, bound=f"{word} allows", words="acceleration")  # fmt: skip


def _along(frame: ToolKinematics, part: tuple[int, int], sign: int, line: bool) -> Iterable[Places] | None:
    """Least speeding up (sign 1) or slowing down (-1) along the path: means between rows of a file with speeds. Of one
    without, what second differences have along a line; None for other moves and in corners, whose bends hide it."""
    rows, (first, last) = frame.rows, part
    t, here = rows.t[first : last + 1], slice(first, last + 1)
    path = frame.p[last] - frame.p[first]
    if rows.qd is None:
        if not line or np.linalg.norm(path) == 0:
            return None
        ahead = sign * path / np.linalg.norm(path)
        found = second_differences(t, frame.p[here], frame.doubt_p[here, None], rows.step_t[here], True)
        return [(t[m : len(t) - m], value @ ahead - doubt[:, 0]) for m, value, doubt in found]
    off_t = rows.step_t[here]
    speed, doubt = lengths(frame.V[here, :3]), frame.doubt_V[0][here]
    return [
        (
            t[:-m],
            (sign * (speed[m:] - speed[:-m]) - doubt[m:] - doubt[:-m])
            / (t[m:] - t[:-m] + (off_t[m:] + off_t[:-m]) / 2),
        )
        for m in LAGS
        if m < len(t)
    ]


def _worst_place(places: Iterable[Places], limit: float) -> Worst:
    worst: Worst | None = None
    for times, values in places:
        if len(values):
            i = int(np.argmax(values))
            worst = worse(worst, Worst(float(values[i]), limit, float(times[i])))
    return worst or Worst(0.0, limit, 0.0)
