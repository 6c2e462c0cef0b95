"""What a motion could still gain, told by libraries the optimiser does not use. Advice: it never decides.

Lines: TOPP-RA along the very joint path of the file, under the axis limits, the TCP caps on the line and the
programmed speeds, from the path speed the file has at both ends (not zero where the rail passes through a stop).
Joint moves from rest to rest that the TCP caps do not hold back: Ruckig.
"""

from __future__ import annotations

from math import isnan

import numpy as np

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.judge.findings import finding
from trajopt_cli.judge.geometry import Line, lengths
from trajopt_cli.judge.libraries import rest_to_rest, shortest_time, straight_rest_to_rest
from trajopt_cli.judge.program_points import obeys_programmed_speed
from trajopt_cli.judge.samples import Rows
from trajopt_cli.judge.timeline import Timeline, Visit
from trajopt_cli.judge.tolerances import REST_JOINT
from trajopt_cli.judge.tool_kinematics import ToolKinematics
from trajopt_cli.motion import MoveAbsJ, MoveJ, MoveL

TIGHT_LINE = 0.002
"""Share of a line's time that TOPP-RA may still shave off a line called tight: its own discretisation, seen as
differences of 0.1 % both ways."""

TIGHT_MOVE = 1e-6
"""Seconds a joint move called tight may differ from Ruckig's."""

INACTIVE = 0.999
"""A TCP cap used less than this does not hold a joint move back."""

_ROOM = (1e-6, 1e-4, 1e-3)
"""Shares of the limits given to TOPP-RA in addition, tried in turn: slopes between rows are cubics, and the speed at an
end may be only just within reach. The last can lengthen nothing and shorten a line by 0.1 %."""


def advise(line: Timeline, frames: dict[bytes, ToolKinematics], rapid: bool) -> list[Finding]:
    """One finding per line and per joint move from stop to stop that a library can time, in program order. Needs speed
    columns; none where torques are limited, or accelerations by posture, of which these libraries are told nothing."""
    rows = line.rows
    if rows.qd is None or rows.plant.limits.binding_torque is not None or rows.accelerations.by_posture:
        return []
    out = []
    for before, visit in (run for run in line.runs() if len(run) == 2):
        frame = frames[np.asarray(visit.point.X_FT).tobytes()]
        first, last = before.depart, visit.arrive
        if visit.point.duration is not None or last - first < 3 or visit.point.move is None:
            continue
        if visit.point.least:  # the libraries know nothing of a table that turns meanwhile, nor of another robot
            continue
        if isinstance(visit.point.move, MoveL):
            found = _line(rows, before, visit, frame)
            if rows.marked or not isnan(found.value):  # else it is the rows that miss the line's ends
                out.append(found)
        elif isinstance(visit.point.move, MoveJ | MoveAbsJ) and _caps_inactive(rows, visit, frame, first, last):
            rests = (np.abs(rows.qd[[first, last]]) <= REST_JOINT).all()
            if rests:
                out.append(_joint_move(rows, before, visit, rapid))
    return out


def _line(rows: Rows, before: Visit, visit: Visit, frame: ToolKinematics) -> Finding:
    """Share of the line's time that TOPP-RA shaves off."""
    stop, limits, caps = visit.point, rows.plant.limits, rows.plant.tcp
    assert rows.qd is not None
    assert stop.X_WF is not None
    assert stop.move is not None
    part = slice(before.depart, visit.arrive + 1)
    t, q, qd, V = rows.t[part], rows.q[part], rows.qd[part], frame.V[part]
    X_0, X_1 = before.X_WF @ stop.X_FT, stop.X_WF @ stop.X_FT
    line = Line.between(X_0, X_1, frame.R[part])
    s = line.progress(frame.p[part], frame.R[part])
    along = X_0[:3, :3] @ line.turn if line.only_turns else line.chord
    rate = (V[:, 3:] if line.only_turns else V[:, :3]) @ along / line.extent**2
    length, angle = line.length, line.angle
    obeys = obeys_programmed_speed(stop, rows.plant)
    v_tcp, v_ori = (stop.move.speed.v_tcp, stop.move.speed.v_ori or np.inf) if obeys else (np.inf, np.inf)
    speed_axes, r = np.array(limits.velocity), rows.mechanism.rails
    speed_axes[:r] = np.minimum(speed_axes[:r], (stop.move.speed.v_leax or np.inf) if obeys else np.inf)
    z, zd = np.c_[q, s * length, s * angle], np.c_[qd, rate * length, rate * angle]
    speed = np.r_[speed_axes, min(v_tcp, caps.speed), v_ori]
    acceleration = np.r_[limits.acceleration, caps.acceleration, np.inf]
    best = _retimed(t - t[0], z, zd, speed, acceleration)
    taken = float(t[-1] - t[0])
    if best is None:
        return Finding(
            "line tightness", "TCP", float("nan"), TIGHT_LINE, "of its time", False, float(t[0]), stop.source,
            f"{stop.source}: TOPP-RA finds no timing for {stop.name} from the speeds at its ends",
        )  # fmt: skip
    fraction = (taken - best) / taken
    note = f": {stop.name} takes {taken:.4f} s, TOPP-RA {best:.4f} s on the same path"
    return finding("line tightness", "TCP", fraction, TIGHT_LINE, "of its time", fraction <= TIGHT_LINE,
                   time=float(t[0]), source=stop.source, note=note)  # fmt: skip


def _retimed(t: Array, z: Array, zd: Array, speed: Array, acceleration: Array) -> float | None:
    """Least time along the path of z.

    The file's own time is the path's parameter: its slope is the file's speed, its own timing is rate 1 and within
    limits, and nothing is singular where all axes rest. The rates at both ends are 1, that is the file's own speeds; at
    rest that is no restriction, because the rate may grow at once where the slope is zero.
    """
    for room in _ROOM:
        best = shortest_time(t, z, zd, speed * (1 + room), acceleration * (1 + room), 1.0, 1.0)
        if best is not None:
            return best
    return None


def _caps_inactive(rows: Rows, visit: Visit, frame: ToolKinematics, first: int, last: int) -> bool:
    """Whether no TCP cap and no programmed speed comes near its limit at the rows of the move."""
    assert visit.point.move is not None
    assert rows.qd is not None
    caps, speed = rows.plant.tcp, visit.point.move.speed
    part = slice(first, last + 1)
    v = frame.least_speed[part].max()
    a = lengths(np.diff(frame.V[part, :3], axis=0)) / np.diff(rows.t[part])
    used = max(v / caps.speed, float(a.max()) / caps.acceleration)
    if obeys_programmed_speed(visit.point, rows.plant):
        used = max(used, v / speed.v_tcp, frame.least_turning[part].max() / (speed.v_ori or np.inf))
        if rows.mechanism.has_rail and speed.v_leax > 0:
            used = max(used, float(np.abs(rows.qd[part, : rows.mechanism.rails]).max()) / speed.v_leax)
    return bool(used < INACTIVE)


def _joint_move(rows: Rows, before: Visit, visit: Visit, rapid: bool) -> Finding:
    """The move's time less Ruckig's (RAPID: less that of one common profile)."""
    limits, stop = rows.plant.limits, visit.point
    library = straight_rest_to_rest if rapid else rest_to_rest
    best = library(rows.q[before.depart], rows.q[visit.arrive], limits.velocity, limits.acceleration)
    taken = float(rows.t[visit.arrive] - rows.t[before.depart])
    note = f": {stop.name} takes {taken:.6f} s, Ruckig {best:.6f} s"
    return finding("move tightness", "axes", taken - best, TIGHT_MOVE, "s", abs(taken - best) <= TIGHT_MOVE,
                   time=float(rows.t[before.depart]), source=stop.source, note=note)  # fmt: skip
