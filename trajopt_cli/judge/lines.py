"""The shape of motions: lines and arcs and the corners between them, the arm held by MoveExtJ, and what RAPID makes
straight.

Outside its zones a line is held to chord and slerp, an arc to its circle and to the turn that CirPathMode makes. Inside
one the TCP is within the zone's sphere, anything else shows as a place off its way; between two lines it is in the
triangle of entry, point and exit as well, where the controller's parabola lies and a stop at the point. Between two
lines or arcs the same holds of the tool's rotation vectors in the zone of orientation. Beside a joint move, and
where the coordinate system changes, the sphere is all that is known; between two reorientations the zone is an angle.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.judge.findings import axis_unit, finding
from trajopt_cli.judge.free_turns import beyond_sector, off_taught, swing_of, turn_of, turned_by
from trajopt_cli.judge.geometry import Line, Path, angle_between, lengths, off_triangles, rotation_vectors
from trajopt_cli.judge.path_segments import Indices, StopInterval, off_path, runs_of
from trajopt_cli.judge.positioners import TurnedFrame
from trajopt_cli.judge.samples import Rows
from trajopt_cli.judge.timeline import Timeline, Visit
from trajopt_cli.judge.tolerances import BACKWARD, JOINT_TARGET, LINE_POSITION, LINE_ROTATION
from trajopt_cli.judge.tool_kinematics import ToolKinematics
from trajopt_cli.judge.waypoint_matching import WHOLE
from trajopt_cli.motion import MoveAbsJ, MoveExtJ, MoveJ, PathMove


def check_shapes(
    timeline: Timeline, frames: dict[bytes, ToolKinematics], rapid: bool
) -> Iterator[tuple[int, list[Finding]]]:
    """Findings about every move between its rests, in program order, each run's with its last row; a kind that no check
    knows is never legal. Of a run without one of its points nothing is said: that the point is missing is."""
    for run in runs_of(timeline, frames):
        out: list[Finding] = []
        for leg, visit in enumerate(run.visits[1:]):
            out.extend(_turn(run, leg))
            match visit.point.move:
                case PathMove() if run.paths[leg] is not None:
                    out.extend(_path_findings(run, leg))
                    out.extend(_left_out(run, leg))
                    out.extend(_in_step(run, leg))
                    out.extend(_even_turn(run, leg) if rapid else ())
                    if rapid and timeline.rows.mechanism.has_rail:
                        out.extend(_rail_share(run, leg))
                case MoveExtJ():
                    out.append(_arm_holds(timeline.rows, run.visits[leg], visit))
                case MoveJ() | MoveAbsJ():
                    if rapid:
                        out.extend(_straight(run, leg))
                case _:
                    out.append(_unknown(timeline.rows, visit))
        out.extend(_corners(run))
        yield run.part[1], out


def _unknown(rows: Rows, visit: Visit) -> Finding:
    note = ": the judge has no check for the shape of such a motion"
    return finding("known shape", visit.point.name, 1.0, 0.0, "unknown", False, time=float(rows.t[visit.arrive]),
                   source=visit.point.source, note=note)  # fmt: skip


def _path_findings(run: StopInterval, leg: int) -> Iterator[Finding]:
    """Outside zones: distance from chord or circle, angle from the orientation that is wanted at the same share of the
    way, way back."""
    path, part, places, point = run.paths[leg], run.on(leg), run.places, run.visits[leg + 1].point
    assert path is not None
    assert point.move is not None
    t, s, free = places.t[part], run.fractions[part], run.zone[part] < 0
    off = off_path(path, places.p[part], s)
    turned = off_taught(places.R[part], path.at(np.clip(s, 0.0, 1.0))[1], run.free(leg))
    # a doubt about the place on the way is one about the wanted angle there
    doubt_p, doubt_angle = places.doubt_p[part], places.doubt_angle[part]
    doubt_R = doubt_angle + (0.0 if path.only_turns else path.angle / path.length) * doubt_p
    doubt, unit = (doubt_angle, "rad") if path.only_turns else (doubt_p, "m")
    for check, value, doubts, where, limit, its_unit, words in (
        ("position", off, doubt_p, free, LINE_POSITION, "m", f"from the {path.shape}"),
        (
            "rotation",
            turned,
            doubt_R,
            run.beyond(leg, "turning"),
            LINE_ROTATION,
            "rad",
            "from the programmed orientation",
        ),
        ("progress", _back_along_path(path, s, free), 2 * doubt, free, BACKWARD, unit, "backwards"),
    ):
        least = np.where(where, np.maximum(value - doubts, 0.0), 0.0)
        if len(least):
            i = int(np.argmax(least))
            yield finding(f"{path.kind} {check}", "TCP", float(least[i]), limit, its_unit, bool(least[i] <= limit),
                          time=float(t[i]), source=point.source, note=f" {words} to {point.move.target}")  # fmt: skip


def _turn(run: StopInterval, leg: int) -> Iterator[Finding]:
    """How far a free tool is turned from as taught, where that is nearest to the end of its sector: on a line or an arc
    outside the zones of orientation, at the end of a joint move that stops there."""
    path, places, visit = run.paths[leg], run.places, run.visits[leg + 1]
    free = visit.point.free if path is None and visit.point.fly_by is None else run.free(leg)
    here = np.arange(len(places.t))[run.on(leg)]
    here = here[run.beyond(leg, "turning")] if path is not None else here[-1:]
    if free is None or not len(here):
        return
    taught = run.X_WT[[leg + 1], :3, :3] if path is None else path.at(np.clip(run.fractions[here], 0.0, 1.0))[1]
    turn = turn_of(np.swapaxes(taught, 1, 2) @ places.R[here], free)
    room, beyond = np.minimum(turn - free.low, free.high - turn), beyond_sector(turn, free) - places.doubt_angle[here]
    i = int(np.argmax(np.where(beyond > 0, beyond, -np.abs(room))))
    limit = free.high if turn[i] >= 0 else -free.low
    yield finding("tool turn", "TCP", abs(float(turn[i])), limit, "rad", bool(beyond[i] <= LINE_ROTATION),
                  time=float(places.t[here[i]]), source=visit.point.source,
                  note=f" about its axis from as taught, on the way to {visit.point.name}")  # fmt: skip


def _left_out(run: StopInterval, leg: int) -> Iterator[Finding]:
    """A curve from which the tool stays away inside the zones at its ends, or between rows: as long as it is outside of
    them, so long is the tool's path from the one to the other."""
    path, places, point = run.paths[leg], run.places, run.visits[leg + 1].point
    if path is None or isinstance(path, Line):
        return
    a, b = run.between(leg)
    rows = slice(run.part[0] + a // run.step, run.part[0] - (-b // run.step))
    gone = float(lengths(np.diff(places.p[a : b + 1], axis=0)).sum())
    gone += 2 * np.pi * float(run.frame.reach[rows].sum())  # around a circle between two rows
    around = 2 * float(np.linalg.norm(path.first))  # in the sphere of a zone lies more of a circle than its radius
    inside = around * np.arcsin(np.clip(run.zones("radius")[leg : leg + 2] / around, 0.0, 1.0))
    missing = WHOLE * (path.length - inside.sum()) - gone
    if missing > LINE_POSITION:
        note = f" of the {path.kind} to {point.name} missing: the tool does not go around on it"
        yield finding(f"{path.kind} position", "TCP", missing, LINE_POSITION, "m", False, time=float(places.t[a]),
                      source=point.source, note=note)  # fmt: skip


def _in_step(run: StopInterval, leg: int) -> Iterator[Finding]:
    """Positioners that turn the work object against the fraction of the path that is done over it, at every row."""
    path, frame, visit = run.paths[leg], run.frame, run.visits[leg + 1]
    assert path is not None
    if not isinstance(frame, TurnedFrame) or path.extent < LINE_POSITION:  # no path, no fraction of it
        return
    here = np.arange(0, len(run.places.t), run.step)
    doubt = LINE_POSITION + (run.places.doubt_angle if path.only_turns else run.places.doubt_p)[here]
    off = frame.off(run.part[0] + here // run.step, run.fractions[here], doubt / path.extent)
    i, j = np.unravel_index(int(np.argmax(off)), off.shape)
    value = float(off[i, j])
    yield finding(f"positioner along {path.kind}", frame.units[int(j)].column, value, JOINT_TARGET,
                  axis_unit(frame.units[int(j)].column),
                  value <= JOINT_TARGET, time=float(run.places.t[here[i]]), source=visit.point.source,
                  note=f" from its share of the way to {visit.point.name}, as it turns the work under it")  # fmt: skip


def _back_along_path(path: Path, s: Array, free: NDArray[np.bool_]) -> Array:
    """How far every place (m,) lies behind the farthest one before it; those in zones do not count."""
    done = s * path.extent
    return np.maximum.accumulate(np.where(free, done, -np.inf)) - done


def _corners(run: StopInterval) -> Iterator[Finding]:
    """Findings about every point that is passed between two lines or arcs."""
    paths = [None, *run.paths, None]  # before and behind every visit
    joint = np.array([visit.point.fly_by is not None and visit.point.fly_by.joint for visit in run.visits])
    flat = ~joint & [a is not None and b is not None and a.straight and b.straight for a, b in pairwise(paths)]
    known = ~joint & [a is not None and b is not None for a, b in pairwise(paths)]
    yield from _worst_deviation(run, run.zone, flat, _off_triangles, ("corner position", LINE_POSITION, "m"),
                      "outside the triangle of its zone")  # fmt: skip
    yield from _worst_deviation(run, run.turning_zone, known, _off_turns, ("corner rotation", LINE_ROTATION, "rad"),
                      "outside the turns of its ways")  # fmt: skip


def _worst_deviation(
    run: StopInterval,
    zone: Indices,
    looked_at: NDArray[np.bool_],
    value: Callable[[StopInterval, Indices, Indices], Array],
    check: tuple[str, float, str],
    words: str,
) -> Iterator[Finding]:
    """The greatest value in the zone (m,) of every visit that is looked at (n + 1,). value: of places and visits (i,),
    the doubt about it taken off. check: name, limit and unit."""
    here = np.flatnonzero((zone >= 0) & looked_at[zone])
    if not len(here):
        return
    here = here[np.argsort(zone[here], kind="stable")]
    values, visits = value(run, here, zone[here]), zone[here]
    for part in np.split(np.arange(len(here)), np.flatnonzero(np.diff(visits)) + 1):
        i = part[np.argmax(values[part])]
        point, worst = run.visits[visits[i]].point, max(float(values[i]), 0.0)
        name, limit, unit = check
        yield finding(name, "TCP", worst, limit, unit, worst <= limit, time=float(run.places.t[here[i]]),
                      source=point.source, note=f" {words} at {point.name}")  # fmt: skip


def _off_triangles(run: StopInterval, here: Indices, visits: Indices) -> Array:
    """How far places (i,) are from the triangle of entry, point and exit of the visits whose zones they are in."""
    edges = {k: (run.edge(k - 1, k, "radius")[0], run.edge(k, k, "radius")[0]) for k in np.unique(visits).tolist()}
    entry, leave = (np.array([edges[k][side] for k in visits.tolist()]) for side in (0, 1))
    off = off_triangles(run.places.p[here], entry, run.X_WT[visits, :3, 3], leave)
    return np.asarray(off - run.places.doubt_p[here])


def _off_turns(run: StopInterval, here: Indices, visits: Indices) -> Array:
    """How far the orientations of places (i,) are from the triangle of entry, point and exit, as rotation vectors seen
    from the point.

    Where a turn a goes over into a turn b, exp(-x a) exp(y b) has the rotation vector y b - x a but for x y |a x b| / 2
    and smaller terms; x y is 1/16 at most in a quadratic Bezier, so |a x b| / 16 covers them all.
    """
    R_P = run.X_WT[:, :3, :3]
    edges = {
        k: [rotation_vectors(R_P[k].T @ run.edge(leg, k, "turning")[1]) for leg in (k - 1, k)]
        for k in np.unique(visits).tolist()
    }
    entry, leave = (np.array([edges[k][side] for k in visits.tolist()]) for side in (0, 1))
    found = np.swapaxes(R_P[visits], 1, 2) @ run.places.R[here]
    twisted = np.zeros(len(visits))
    for k in edges:
        if (free := run.free(k - 1) or run.free(k)) is None:
            continue
        # A turn z about the tool's axis before a swing s bends the swing's vector by |z| |s| / 2 at most; one that is
        # made in the zone bends the way of the axis itself as much, as the controller rounds the whole orientation.
        at, both = visits == k, np.stack([R_P[k].T @ run.edge(leg, k, "turning")[1] for leg in (k - 1, k)])
        swings, turns = rotation_vectors(swing_of(both, free)), np.abs(turn_of(both, free))
        made = turn_of(found[at], free)
        made = np.abs(np.angle(np.exp(1j * (made - made[:1]))))
        found[at], entry[at], leave[at] = swing_of(found[at], free), swings[0], swings[1]
        twisted[at] = (turns.max() / 2 + 2 * made.max()) * lengths(swings).max()
    found = rotation_vectors(found)
    granted = twisted + lengths(np.cross(entry, leave)) / 16 + run.places.doubt_angle[here]
    granted += np.array([_sag(run, k) for k in edges])[np.searchsorted(list(edges), visits)]
    # a place at a zone's edge may be a hair outside
    sizes = run.zones("turning")[visits]
    granted += LINE_POSITION / sizes * np.maximum(lengths(entry), lengths(leave))
    return np.asarray(off_triangles(found, entry, np.zeros_like(entry), leave) - granted)


def _sag(run: StopInterval, k: int) -> float:
    """How far turns on arcs beside visit k are from straight rotation vectors in its zone; 0 on lines. A third is added
    for where the middle is not the farthest."""
    sag, R_P = 0.0, run.X_WT[k, :3, :3]
    for leg in (k - 1, k):
        path = run.paths[leg]
        if path is not None and not path.straight:
            fraction = run.zones("turning")[k] / path.length
            s = fraction * np.array([0.5, 1.0]) if leg == k else 1.0 - fraction * np.array([0.5, 1.0])
            half, whole = rotation_vectors(R_P.T @ path.at(s)[1])
            sag += 4 / 3 * float(np.linalg.norm(half - whole / 2))
    return sag


def _rail_share(run: StopInterval, leg: int) -> Iterator[Finding]:
    """The rail against its linear fraction of the path at every row outside the zones of external axes, between where
    it is at the stops or at the first and last of those rows."""
    rows, path, before, visit = run.rows, run.paths[leg], run.visits[leg], run.visits[leg + 1]
    assert path is not None
    here = np.arange(len(run.places.t))[run.on(leg)]
    here = here[run.beyond(leg, "external") & (here % run.step == 0)]
    where = run.part[0] + here // run.step
    if not len(here):
        return
    r = rows.mechanism.rails
    s, d = run.fractions[here], rows.q[where, :r]
    first, last = (before.depart, visit.arrive) if visit.arrive > before.depart else run.part
    s_0, d_0 = (0.0, rows.q[first, :r]) if before.point.fly_by is None else (s[0], d[0])
    s_1, d_1 = (1.0, rows.q[last, :r]) if visit.point.fly_by is None else (s[-1], d[-1])
    slope = (d_1 - d_0) / max(s_1 - s_0, 1e-9)
    doubt = (run.places.doubt_angle if path.only_turns else run.places.doubt_p)[here] / path.extent
    granted = _end_doubt(rows, before, visit)[:r] + rows.doubt_q[where, :r] / 2 + 2 * np.abs(slope) * doubt[:, None]
    each = np.maximum(np.abs(d - (d_0 + (np.clip(s, 0.0, 1.0) - s_0)[:, None] * slope)) - granted, 0.0)
    j = int(np.argmax(each.max(axis=0)))
    off = each[:, j]
    i = int(np.argmax(off))
    yield finding(f"rail along {path.kind}", rows.plant.limits.names[j], float(off[i]), JOINT_TARGET, "m",
                  bool(off[i] <= JOINT_TARGET), time=float(rows.t[where[i]]), source=visit.point.source,
                  note=": a RAPID controller moves it in proportion to the path")  # fmt: skip


def _even_turn(run: StopInterval, leg: int) -> Iterator[Finding]:
    """A free tool against how a RAPID controller turns it at every place outside the zones of orientation: on a line
    evenly the shorter way between its orientations at the first and last of them (slerp), on an arc with the path."""
    path, free, point = run.paths[leg], run.free(leg), run.visits[leg + 1].point
    here = np.arange(len(run.places.t))[run.on(leg)][run.beyond(leg, "turning")]
    if path is None or free is None or len(here) < 3:
        return
    s, R = np.clip(run.fractions[here], 0.0, 1.0), run.places.R[here]
    R_taught = path.at(s)[1]
    ends = turned_by(R_taught[[0, -1]], free, turn_of(np.swapaxes(R_taught[[0, -1]], 1, 2) @ R[[0, -1]], free))
    X_0, X_1 = np.eye(4), np.eye(4)
    X_0[:3, :3], X_1[:3, :3] = ends
    if isinstance(path, Line):
        wanted = Line.between(X_0, X_1, R).at((s - s[0]) / max(s[-1] - s[0], 1e-9))[1]
    else:
        wanted = turned_by(R_taught, free, np.full(len(s), turn_of(R_taught[0].T @ R[0], free)))
    rate = float(angle_between(*ends)) / (max(s[-1] - s[0], 1e-9) * path.length)
    doubt = run.places.doubt_angle[here] + rate * run.places.doubt_p[here]
    off = np.maximum(angle_between(R, wanted) - doubt - doubt[[0, -1]].max(), 0.0)
    i = int(np.argmax(off))
    yield finding(f"turn along {path.kind}", "TCP", float(off[i]), LINE_ROTATION, "rad", bool(off[i] <= LINE_ROTATION),
                  time=float(run.places.t[here[i]]), source=point.source,
                  note=f": a RAPID controller turns the tool evenly on the way to {point.name}")  # fmt: skip


def _end_doubt(rows: Rows, before: Visit, visit: Visit) -> Array:
    """How far axes at the rows of both rests may be from where they really rested (k,)."""
    stops = [(before, before.depart), (visit, visit.arrive)]
    tau = max((float(rows.open_time[row]) for one, row in stops if one.point.fly_by is None), default=0.0)
    doubt_q = np.maximum(rows.doubt_q[before.depart], rows.doubt_q[visit.arrive])
    return np.asarray(doubt_q / 2 + rows.accelerations.most * tau**2 / 2)


def _arm_holds(rows: Rows, before: Visit, visit: Visit) -> Finding:
    """MoveExtJ: the arm's joints stay as they were."""
    first, last = before.depart, visit.arrive
    off = np.abs(rows.q[first : last + 1, -6:] - rows.q[first, -6:])
    least = np.maximum(off - rows.doubt_q[first : last + 1, -6:] / 2 - _end_doubt(rows, before, visit)[-6:], 0.0)
    i, j = np.unravel_index(int(np.argmax(least)), least.shape)
    name = rows.plant.limits.names[len(rows.plant.limits.names) - 6 + int(j)]
    value = float(least[i, j])
    return finding("arm holds", name, value, JOINT_TARGET, "rad", value <= JOINT_TARGET,
                   time=float(rows.t[first + int(i)]), source=visit.point.source,
                   note=f": {visit.point.name} moves external axes only")  # fmt: skip


def _straight(run: StopInterval, leg: int) -> Iterator[Finding]:
    """RAPID: every row outside zones on the straight line between the axis values at the stops, or at the first and
    last of those rows."""
    rows, before, visit = run.rows, run.visits[leg], run.visits[leg + 1]
    here = np.arange(len(run.places.t))[run.on(leg)]
    here = here[(run.zone[here] < 0) & run.sure[here] & (here % run.step == 0)]
    where = run.part[0] + here // run.step
    if not len(here):
        return
    q_0 = rows.q[before.depart if before.point.fly_by is None else where[0]]
    q_1 = rows.q[visit.arrive if visit.point.fly_by is None else where[-1]]
    weight = 1 / rows.plant.limits.velocity
    path = (q_1 - q_0) * weight
    q = rows.q[where]
    fraction = ((q - q_0) * weight) @ path / max(float(path @ path), 1e-300)
    off = np.abs(q - (q_0 + np.clip(fraction, 0, 1)[:, None] * (q_1 - q_0)))
    # rounding of all axes enters the share
    doubt_share = (rows.doubt_q[where] / 2 * weight) @ np.abs(path) / max(float(path @ path), 1e-300)
    granted = rows.doubt_q[where] / 2 + 2 * _end_doubt(rows, before, visit) + doubt_share[:, None] * np.abs(q_1 - q_0)
    least = np.maximum(off - granted, 0.0)
    i, j = np.unravel_index(int(np.argmax(least)), least.shape)
    name, value = rows.plant.limits.names[int(j)], float(least[i, j])
    yield finding("joint line", name, value, JOINT_TARGET, axis_unit(name), value <= JOINT_TARGET,
                  time=float(rows.t[where[i]]), source=visit.point.source,
                  note=f": a RAPID controller runs {visit.point.name} straight in the joints")  # fmt: skip
