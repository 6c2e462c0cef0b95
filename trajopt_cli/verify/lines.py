"""The shape of motions: lines against chord and slerp, the arm held by MoveExtJ, and what RAPID makes straight."""

from __future__ import annotations

import numpy as np

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.motion import MoveAbsJ, MoveExtJ, MoveJ, MoveL
from trajopt_cli.verify.findings import axis_unit, finding
from trajopt_cli.verify.frame import Frame, Places
from trajopt_cli.verify.geometry import Line, angle_between
from trajopt_cli.verify.rows import Rows
from trajopt_cli.verify.timeline import Timeline, Visit, rows_of_move
from trajopt_cli.verify.tolerances import BACKWARD, JOINT_TARGET, LINE_POSITION, LINE_ROTATION


def check_shapes(line: Timeline, frames: dict[bytes, Frame], rapid: bool) -> list[Finding]:
    """Findings about every move between its rests, in program order; a kind that no check knows is never legal."""
    out = []
    for before, visit in line.legs():
        match visit.stop.move:
            case MoveL():
                frame = frames[np.asarray(visit.stop.X_FT).tobytes()]
                out.extend(_line(line.rows, before, visit, frame, rapid))
            case MoveExtJ():
                out.append(_arm_holds(line.rows, before, visit))
            case MoveJ() | MoveAbsJ():
                if rapid:
                    out.append(_straight(line.rows, before, visit))
            case _:
                out.append(_unknown(line.rows, visit))
    return out


def _unknown(rows: Rows, visit: Visit) -> Finding:
    note = ": the judge has no check for the shape of such a motion"
    return finding("known shape", visit.stop.name, 1.0, 0.0, "unknown", False, time=float(rows.t[visit.arrive]),
                   source=visit.stop.source, note=note)  # fmt: skip


def _line(rows: Rows, before: Visit, visit: Visit, frame: Frame, rapid: bool) -> list[Finding]:
    """Distance from the chord, angle from the slerp at the same share of the way, way back; RAPID: the rail's share."""
    stop = visit.stop
    assert stop.X_WF is not None
    X_0, X_1 = before.X_WF @ stop.X_FT, stop.X_WF @ stop.X_FT
    first, last = rows_of_move(rows, before, visit)
    places = frame.places(first, last)
    line = Line.between(X_0, X_1, places.R)
    s = line.progress(places.p, places.R)
    wanted_p, wanted_R = line.at(np.clip(s, 0.0, 1.0))
    off = np.linalg.norm(places.p - wanted_p, axis=1)
    turned = angle_between(places.R, wanted_R)
    # a doubt about the place on the line is one about the wanted angle there
    doubt_R = places.doubt_angle + (0.0 if line.only_turns else line.angle / line.length) * places.doubt_p
    out = []
    for check, value, doubt, limit, unit in (
        ("line position", off, places.doubt_p, LINE_POSITION, "m"),
        ("line rotation", turned, doubt_R, LINE_ROTATION, "rad"),
        ("line progress", *_way_back(line, s, places)),
    ):
        least = np.maximum(value - doubt, 0.0)
        i = int(np.argmax(least))
        words = {"line position": "from the chord", "line rotation": "from the slerp", "line progress": "backwards"}
        out.append(
            finding(check, "TCP", float(least[i]), limit, unit, bool(least[i] <= limit), time=float(places.t[i]),
                    source=stop.source, note=f" {words[check]} to {stop.move.target}" if stop.move else "")
        )  # fmt: skip
    if rapid and rows.mechanism.has_rail:
        out.append(_rail_share(rows, before, visit, frame, (first, last)))
    return out


def _way_back(line: Line, s: Array, places: Places) -> tuple[Array, Array, float, str]:
    """How far every place lies behind the farthest one before it, the doubt about that, limit and unit."""
    way = s * line.way
    doubt, unit = (places.doubt_angle, "rad") if line.only_turns else (places.doubt_p, "m")
    return np.maximum.accumulate(way) - way, 2 * doubt, BACKWARD, unit


def _rail_share(rows: Rows, before: Visit, visit: Visit, frame: Frame, part: tuple[int, int]) -> Finding:
    """The rail against its linear share of the path at every row."""
    stop = visit.stop
    assert stop.X_WF is not None
    first, last = part
    where = slice(first, last + 1)
    X_0, X_1 = before.X_WF @ stop.X_FT, stop.X_WF @ stop.X_FT
    line = Line.between(X_0, X_1, frame.R[where])
    s = line.progress(frame.p[where], frame.R[where])
    d_0, d_1 = (float(rows.q[row, 0]) for row in (before.depart, visit.arrive))
    doubt = (frame.doubt_R if line.only_turns else frame.doubt_p)[where] / line.way
    granted = _end_doubt(rows, before, visit)[0] + rows.doubt_q[0] / 2 + abs(d_1 - d_0) * doubt
    off = np.maximum(np.abs(rows.q[where, 0] - (d_0 + np.clip(s, 0, 1) * (d_1 - d_0))) - granted, 0.0)
    i = int(np.argmax(off))
    name = rows.plant.limits.names[0]
    return finding("rail along line", name, float(off[i]), JOINT_TARGET, "m", bool(off[i] <= JOINT_TARGET),
                   time=float(rows.t[first + i]), source=stop.source,
                   note=": a RAPID controller moves it in proportion to the path")  # fmt: skip


def _end_doubt(rows: Rows, before: Visit, visit: Visit) -> Array:
    """How far axes at the rows of both rests may be from where they really rested (k,)."""
    tau = max(float(rows.open_time[before.depart]), float(rows.open_time[visit.arrive]))
    return np.asarray(rows.doubt_q / 2 + rows.plant.limits.acceleration * tau**2 / 2)


def _arm_holds(rows: Rows, before: Visit, visit: Visit) -> Finding:
    """MoveExtJ: the arm's joints stay as they were."""
    first, last = before.depart, visit.arrive
    off = np.abs(rows.q[first : last + 1, -6:] - rows.q[first, -6:])
    least = np.maximum(off - rows.doubt_q[-6:] / 2 - _end_doubt(rows, before, visit)[-6:], 0.0)
    i, j = np.unravel_index(int(np.argmax(least)), least.shape)
    name = rows.plant.limits.names[len(rows.plant.limits.names) - 6 + int(j)]
    value = float(least[i, j])
    return finding("arm holds", name, value, JOINT_TARGET, "rad", value <= JOINT_TARGET,
                   time=float(rows.t[first + int(i)]), source=visit.stop.source,
                   note=f": {visit.stop.name} moves external axes only")  # fmt: skip


def _straight(rows: Rows, before: Visit, visit: Visit) -> Finding:
    """RAPID: every row on the straight line between the axis values at both ends."""
    first, last = rows_of_move(rows, before, visit)
    q_0, q_1 = rows.q[before.depart], rows.q[visit.arrive]
    weight = 1 / rows.plant.limits.velocity
    way = (q_1 - q_0) * weight
    q = rows.q[first : last + 1]
    share = ((q - q_0) * weight) @ way / max(float(way @ way), 1e-300)
    off = np.abs(q - (q_0 + np.clip(share, 0, 1)[:, None] * (q_1 - q_0)))
    # rounding of all axes enters the share
    doubt_share = float((rows.doubt_q / 2 * weight) @ np.abs(way)) / max(float(way @ way), 1e-300)
    granted = rows.doubt_q / 2 + 2 * _end_doubt(rows, before, visit) + doubt_share * np.abs(q_1 - q_0)
    least = np.maximum(off - granted, 0.0)
    i, j = np.unravel_index(int(np.argmax(least)), least.shape)
    name, value = rows.plant.limits.names[int(j)], float(least[i, j])
    return finding("joint line", name, value, JOINT_TARGET, axis_unit(name), value <= JOINT_TARGET,
                   time=float(rows.t[first + int(i)]), source=visit.stop.source,
                   note=f": a RAPID controller runs {visit.stop.name} straight in the joints")  # fmt: skip
