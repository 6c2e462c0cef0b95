"""Where the rail may stand: arm joints over the rail's range for every waypoint and along every line, per IK branch.

A station's table is continued along its lines, so one branch and one set of whole turns means one continuous
configuration in the whole station. What cannot be reached is named here, before any optimising.
"""

from __future__ import annotations

from dataclasses import astuple, dataclass, replace
from itertools import product

import numpy as np
from scipy import ndimage

from trajopt_cli.geometry import Array, BoolArray, inverse_pose
from trajopt_cli.motion import MoveJ, MoveL, motion_name
from trajopt_cli.optimize.axes import Axes
from trajopt_cli.optimize.tuning import ELBOW, LINE_NODES, REACH_GRID, WRIST
from trajopt_cli.problem.plan import Infeasible
from trajopt_cli.problem.problem import Leg, LegKind, Problem, Waypoint

_LISTED = 4  # confdata in a message
_PLACES = 5  # in a message
_NO_SINGLE = "no single configuration serves the whole line without crossing a singularity or a joint limit"


@dataclass(frozen=True, eq=False)
class Label:
    """One continuous configuration of a station: branch number and whole turns (6,) added to the table."""

    cfx: int
    turns: Array


@dataclass(frozen=True, eq=False)
class StationTable:
    """Arm joints of one station on a rail grid.

    d: (n,); waypoints: for each (L, n, m) with NaN where the configuration is not to be had, L labels; lines: per leg
    (L, LINE_NODES, n, m), None for dwells. At a waypoint with fixed joints only its own rail value is open.
    """

    first: int
    d: Array
    labels: tuple[Label, ...]
    waypoints: tuple[Array, ...]
    lines: tuple[Array | None, ...]


def rail_grid(problem: Problem, first: int, last: int, n: int, window: tuple[float, float] | None = None) -> Array:
    """Grid of rail positions for the waypoints first..last, fixed values included exactly."""
    ranges = [problem.waypoints[k].rail for k in range(first, last + 1)]
    fixed = [low for low, high in ranges if low == high]
    free = [r for r in ranges if r[0] != r[1]]
    if not free:
        return np.unique(np.r_[fixed, np.linspace(min(fixed), max(fixed), n)])
    low, high = free[0]
    if window:
        low, high = max(low, window[0]), min(high, window[1])
    return np.unique(np.r_[np.linspace(low, high, n), fixed])


def _unwrap(arm: Array, axis: int) -> Array:
    """Whole turns removed between neighbours along an axis, gaps of NaN bridged."""
    filled = np.moveaxis(arm, axis, 0).copy()
    last = filled[0].copy()
    for i in range(1, len(filled)):
        jump = filled[i] - last
        filled[i] -= 2 * np.pi * np.round(np.where(np.isnan(jump), 0.0, jump) / (2 * np.pi))
        last = np.where(np.isnan(filled[i]), last, filled[i])
    return np.moveaxis(filled, 0, axis)


def _usable(axes: Axes, arm: Array) -> Array:
    """NaN where a configuration stands too near a singularity for a line, a dwell or a waypoint with a free rail."""
    elbow, wrist = axes.robot.walls(arm)
    bad = (elbow > ELBOW) | (wrist < WRIST)
    return np.where(bad[..., None], np.nan, arm)


def station_table(axes: Axes, problem: Problem, first: int, last: int, d: Array) -> StationTable:
    """Tables of one station."""
    n = len(d)
    stops_raw: list[Array] = []  # (branches, n, joints)
    lines_raw: list[Array | None] = []
    for k in range(first, last + 1):
        stop = problem.waypoints[k]
        if k == first:
            raw = _usable(axes, np.moveaxis(axes.inverse(np.broadcast_to(stop.X_WF, (n, 4, 4)), d), 1, 0))
            stops_raw.append(_unwrap(raw, 1))
            continue
        leg = problem.legs[k - 1]
        if leg.segment is None:
            stops_raw.append(stops_raw[-1])
            lines_raw.append(None)
            continue
        X = leg.segment.pose(np.linspace(0, 1, LINE_NODES)) @ inverse_pose(leg.X_FT)
        raw = axes.inverse(np.broadcast_to(X[:, None], (LINE_NODES, n, 4, 4)).reshape(-1, 4, 4), np.tile(d, LINE_NODES))
        raw = _usable(axes, np.moveaxis(raw.reshape(LINE_NODES, n, *raw.shape[1:]), 2, 0))
        start = stops_raw[-1]
        raw[:, 0] = start
        # along the line first; then along the rail, for columns whose start is out of reach and gave no reference
        line = _unwrap(_unwrap(raw, 1), 2)
        lines_raw.append(line)
        stops_raw.append(line[:, -1])
    limits_low, limits_high = axes.lower[axes.layout.arm] - 1e-9, axes.upper[axes.layout.arm] + 1e-9

    labels: list[Label] = []
    stops: list[list[Array]] = [[] for _ in stops_raw]
    lines: list[list[Array | None]] = [[] for _ in lines_raw]
    for cfx, turn in product(range(len(stops_raw[0])), axes.robot.turns):
        tables = []
        for i, raw in enumerate(stops_raw):
            q = raw[cfx] + turn
            ok = np.all((q >= limits_low) & (q <= limits_high), axis=-1)
            stop = problem.waypoints[first + i]
            if stop.rail[0] == stop.rail[1]:
                ok &= np.abs(d - stop.rail[0]) < 1e-12
            if stop.conf is not None:
                for j in np.flatnonzero(ok & (np.abs(d - stop.written) < 1e-12)):
                    ok[j] = axes.robot.admits(stop.conf, q[j])
            if stop.q is not None:
                ok &= np.all(np.abs(q - stop.q[axes.layout.arm]) < 1e-6, axis=-1)
            tables.append(np.where(ok[:, None], q, np.nan))
        if not all(np.any(~np.isnan(t[:, 0])) for t in tables):
            continue
        labels.append(Label(cfx, turn))
        for i, t in enumerate(tables):
            stops[i].append(t)
        for i, line_raw in enumerate(lines_raw):
            if line_raw is None:
                lines[i].append(None)
                continue
            q = line_raw[cfx] + turn
            ok = np.all((q >= limits_low) & (q <= limits_high), axis=-1)
            lines[i].append(np.where(ok[..., None], q, np.nan))
    alone = problem.waypoints[first].q if first == last else None
    if alone is not None:
        d, arm = axes.layout.place(alone[None]), alone[axes.layout.arm]
        return StationTable(first, d, (Label(-1, np.zeros_like(arm)),), (arm[None, None],), ())
    return StationTable(
        first,
        d,
        tuple(labels),
        tuple(np.array(s).reshape(-1, n, axes.layout.joints) for s in stops),
        tuple(None if not x or x[0] is None else np.array(x) for x in lines),
    )


def check_reach(axes: Axes, problem: Problem, n: int = REACH_GRID) -> Infeasible | None:
    """The first waypoint that no rail position and branch reaches, or line that none can serve, by name."""
    for first, last in problem.stations:
        d = rail_grid(problem, first, last, n)
        table = station_table(axes, problem, first, last, d)
        if not table.labels:  # else one configuration reaches all of its waypoints
            return _lost(axes, problem, first, last, d)
        for i in range(last - first):
            if problem.legs[first + i].kind is LegKind.LINE and not _passable(problem, table, i):
                return _broken_line(axes, problem, first + i, d, table.labels) or _no_single(problem, first + i)
    return None


def _lost(axes: Axes, problem: Problem, first: int, last: int, d: Array) -> Infeasible:
    """What ends a station that no configuration serves: a waypoint out of reach, or the first line that none of those
    serves which served everything before it."""
    for k in range(first, last + 1):
        if _out_of_reach(axes, problem, k, d):
            return _unreachable(axes, problem, k, d)
    labels = station_table(axes, problem, first, first, d).labels
    for k in range(first + 1, last + 1):
        before, labels = labels, station_table(axes, problem, first, k, d).labels
        if labels:
            continue
        line = problem.legs[k - 1].kind is LegKind.LINE
        broken = _broken_line(axes, problem, k - 1, d, before) if line else None
        return broken or _no_common(problem, first, k)
    raise AssertionError("a station without a label has a first stop where the labels end")


def _out_of_reach(axes: Axes, problem: Problem, k: int, d: Array) -> bool:
    """Whether no rail position and branch reach a waypoint, whatever stands around it."""
    stop = problem.waypoints[k]
    if stop.q is not None or stop.motion < 0:
        return False
    return not station_table(axes, problem_at(problem, k), 0, 0, d).labels


def problem_at(problem: Problem, k: int) -> Problem:
    """The problem of one waypoint alone."""
    return replace(problem, waypoints=(problem.waypoints[k],), legs=(), stations=((0, 0),), ties=())


def _passable(problem: Problem, table: StationTable, i: int) -> bool:
    """Some label runs the whole line: with the rail moving if it may, else at one rail position."""
    line = table.lines[i]
    leg = problem.legs[table.first + i]
    assert line is not None
    open_ = ~np.isnan(line[..., 0])
    open_[:, 0] &= ~np.isnan(table.waypoints[i][..., 0])
    open_[:, -1] &= ~np.isnan(table.waypoints[i + 1][..., 0])
    for grid in open_:
        if not leg.rail_moves:
            if np.any(np.all(grid, axis=0)):
                return True
            continue
        if _crosses(grid):
            return True
    return False


def _crosses(open_: BoolArray) -> bool:
    """Whether a rail gets along a line: open_ (nodes, rail positions) says from where each node can be served.

    At a node it may go anywhere without a gap; to the next node by as much as takes it from end to end over the line.
    """
    nodes, n = open_.shape
    step = -(-(n - 1) // (nodes - 1))
    held = open_[0]
    for row in open_[1:]:
        near = ndimage.binary_dilation(held, iterations=step)
        runs, _ = ndimage.label(row)
        held = row & np.isin(runs, runs[near & row])
    return bool(held.any())


def _unreachable(axes: Axes, problem: Problem, k: int, d: Array) -> Infeasible:
    stop = problem.waypoints[k]
    motion = problem.motion(stop.motion)
    near = d[int(np.argmin(np.abs(d - _abreast(axes, stop.X_WF))))]
    if stop.rail[0] == stop.rail[1]:
        near = stop.rail[0]
    reason = _why(axes, problem, stop.X_WF, float(near))
    where = _at(axes, float(near))
    if not reason:
        reason = _other_configurations(axes, problem, stop, float(near))
        if stop.conf is not None:
            reason += _remedy(axes, problem, k)
    text = f"{motion_name(motion)} cannot be reached{where}: {reason}"
    return Infeasible(stop.motion, motion.source, text)


def _at(axes: Axes, rail: float) -> str:
    return f" at rail {rail * 1e3:.1f} mm" if axes.layout.has_rail else ""


def _why(axes: Axes, problem: Problem, X_WF: Array, rail: float) -> str:
    """Why a pose is out of reach at a rail position; empty when it is not."""
    if axes.robot.solutions(X_WF, rail, problem.plant.limits):
        return ""
    return axes.robot.why_unreachable(X_WF, rail, problem.plant.limits)


def _other_configurations(axes: Axes, problem: Problem, stop: Waypoint, rail: float) -> str:
    """The pose is in reach, but not with the confdata asked for; those that are to be had, the nearest to it first."""
    found = axes.robot.solutions(stop.X_WF, rail, problem.plant.limits)
    confs = {astuple(axes.robot.confdata(q)) for _, q in found}
    if not confs:
        return "too near a singularity"
    asked = None if stop.conf is None else astuple(stop.conf)

    def away(conf: tuple[int, ...]) -> tuple[int, int, tuple[int, ...]]:
        apart = [abs(a - b) for a, b in zip(conf, asked or conf, strict=True)]
        return sum(map(bool, apart)), sum(apart), conf

    nearest = sorted(confs, key=away)
    text = ", ".join(_written(conf) for conf in nearest[:_LISTED])
    more = f" and {len(nearest) - _LISTED} more" if len(nearest) > _LISTED else ""
    return f"not{'' if asked is None else f' with confdata {_written(asked)}'}; there would be {text}{more}"


def _written(conf: tuple[int, ...]) -> str:
    """confdata as RAPID writes it."""
    return f"[{','.join(map(str, conf))}]"


def _remedy(axes: Axes, problem: Problem, k: int) -> str:
    """What to do about confdata that cannot be had at waypoint k, and the places behind it where it is the same."""
    motion = problem.motion(problem.waypoints[k].motion)
    word = "ConfL" if isinstance(motion, MoveL) else "ConfJ"
    text = f"; correct the confdata, or set {word} \\Off before it"
    places = dict.fromkeys(
        str(problem.motion(stop.motion).source)
        for stop in problem.waypoints[k + 1 :]
        if _wrong_confdata(axes, problem, stop)
    )
    places.pop(str(motion.source), None)
    if not places:
        return text
    named = [*places][: _PLACES - 1]
    more = f" and {len(places) - len(named)} more" if len(places) > len(named) else ""
    return f"{text}; likewise {', '.join(named)}{more}"


def _wrong_confdata(axes: Axes, problem: Problem, stop: Waypoint) -> bool:
    """Whether a move ends where the pose can be had, but not as its confdata says, which counts; the rail is given."""
    if stop.conf is None or stop.q is not None or stop.rail[0] != stop.rail[1]:
        return False
    if not isinstance(problem.motion(stop.motion), MoveJ | MoveL):
        return False
    found = axes.robot.solutions(stop.X_WF, stop.written, problem.plant.limits)
    return bool(found) and not any(axes.robot.admits(stop.conf, q) for _, q in found)


def _abreast(axes: Axes, X_WF: Array) -> float:
    """The rail position at which the base stands nearest to a pose."""
    p = axes.in_base(X_WF)[:3, 3]
    return float(np.sum(p @ axes.rail_axis))


def _broken_line(axes: Axes, problem: Problem, k: int, d: Array, labels: tuple[Label, ...]) -> Infeasible | None:
    """Name the point on line k that serves no rail position and branch which served everything before it; labels: the
    configurations that did. None where every point has such."""
    leg = problem.legs[k]
    motion = problem.motion(leg.motion)
    assert leg.segment is not None
    shares = np.linspace(0, 1, 101)
    X = leg.segment.pose(shares)
    rails = d
    fixed = [
        problem.waypoints[j].rail[0] for j in (k, k + 1) if problem.waypoints[j].rail[0] == problem.waypoints[j].rail[1]
    ]
    if fixed and not leg.rail_moves:
        rails = np.array(fixed[:1])
    X_WF = X @ inverse_pose(leg.X_FT)
    arm = [axes.inverse(np.broadcast_to(X, (len(rails), 4, 4)), rails) for X in X_WF]
    # a point out of everything's reach says most; else the one where the last configuration ends
    known = {label.cfx for label in labels} if all(label.cfx >= 0 for label in labels) else set(range(arm[0].shape[1]))
    at = _first_lost(axes, leg, arm, set(range(arm[0].shape[1])))
    if at is None:
        at = _first_lost(axes, leg, [_usable(axes, q) for q in arm], known)
    if at is None:
        return None
    X_WT, X_WF = X[at], X_WF[at]
    near = rails[int(np.argmin(np.abs(rails - _abreast(axes, X_WF))))]
    reason = _why(axes, problem, X_WF, float(near))
    where = _at(axes, float(near))
    if not reason:
        reason = _NO_SINGLE
    p = X_WT[:3, 3] * 1e3
    way = leg.chord * 1e3
    text = (
        f"{motion_name(motion)} breaks at {shares[at] * way:.1f} mm of {way:.1f} mm,"
        f" point [{p[0]:.1f}, {p[1]:.1f}, {p[2]:.1f}] mm{where}: {reason}"
    )
    return Infeasible(leg.motion, motion.source, text)


def _first_lost(axes: Axes, leg: Leg, arm: list[Array], branches: set[int]) -> int | None:
    """The first of the points, with joints arm (rails, b, m) each, to which none of the branches gets."""
    alive = np.tile([cfx in branches for cfx in range(arm[0].shape[1])], (len(arm[0]), 1))
    for at, q in enumerate(arm):
        alive = _in_limits(axes, q) & (np.any(alive, axis=0) if leg.rail_moves else alive)
        if not np.any(alive):
            return at
    return None


def _in_limits(axes: Axes, arm: Array) -> BoolArray:
    low, high = axes.lower[axes.layout.arm] - 1e-9, axes.upper[axes.layout.arm] + 1e-9
    ok = np.zeros(arm.shape[:-1], dtype=bool)
    for turn in axes.robot.turns:
        ok |= np.all((arm + turn >= low) & (arm + turn <= high), axis=-1)
    return ok


def _no_single(problem: Problem, k: int) -> Infeasible:
    motion = problem.motion(problem.legs[k].motion)
    return Infeasible(problem.legs[k].motion, motion.source, f"{motion_name(motion)}: {_NO_SINGLE}")


def _no_common(problem: Problem, first: int, last: int) -> Infeasible:
    index = problem.waypoints[last].motion
    motion = problem.motion(index)
    start = problem.motion(problem.waypoints[first].motion) if problem.waypoints[first].motion >= 0 else None
    begin = f"{start.source}" if start else "the start"
    text = (
        f"{motion_name(motion)}: no configuration serves all points from {begin} to here; the lines"
        " between them keep the branch and the turns of the joints"
    )
    return Infeasible(index, motion.source, text)
