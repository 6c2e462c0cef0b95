"""What cannot be reached, named before any optimising: the motion, the point, and the limit that is in the way."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from hashlib import blake2b
from weakref import WeakKeyDictionary

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, inverse_pose
from trajopt_cli.graph_search.ik_tables import IkTable, grid_in_reach, reach_intervals, station_table
from trajopt_cli.graph_search.singular_start import SingularStart, usable
from trajopt_cli.motion import MoveL, Wait, motion_name
from trajopt_cli.problem.configurations import Misfit, check_configurations, listed, reachable_confdata, shown
from trajopt_cli.problem.decision_scope import EVERYTHING
from trajopt_cli.problem.plan import Infeasible
from trajopt_cli.problem.plannable import with_exact_orientation
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import Coupling, Leg, LegKind, Problem, Waypoint
from trajopt_cli.problem.stop_condition import checkpoint
from trajopt_cli.robot.turns import ON_LIMIT, excess
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.route import IkBranch

_PLACES = 5  # in a message
_SERVED = WeakKeyDictionary[Plant, set[bytes]]()  # names of stations that can be: asked again by every question
_NO_SINGLE = "no single configuration serves the whole line without crossing a singularity or a joint limit"
_REACH_GRID = 193  # rail positions on a stroke at least; 12.5 mm apart on one of 2.4 m. Not measured.


def check_reach(axes: Axes, problem: Problem) -> Infeasible | None:
    """The first waypoint that no rail position and branch reaches, or line that none can serve, by name."""
    served = _SERVED.setdefault(problem.plant, set())
    alike = replace(problem, freedom=EVERYTHING, coupling=Coupling.FREE)
    for first, last in problem.stations:
        checkpoint()
        singular = SingularStart.of(axes, problem, first, last) is not None
        name = (problem if singular else alike).key(first, last)
        ranges = (axes.lower, axes.upper, axes.couplings.rows, axes.couplings.lower, axes.couplings.upper)
        key = blake2b(name + b"".join(x.tobytes() for x in ranges), digest_size=16).digest()
        if key in served:
            continue
        out = unserved(axes, problem, first, last)
        if out is not None:
            return out
        begin = problem.waypoints[first]
        if begin.motion >= 0 or begin.q is not None:  # else what is wrong where a cycle begins is told where it ends
            served.add(key)
    return dead_end(problem)


def dead_end(problem: Problem) -> Infeasible | None:
    """The first motion that cannot be done from the nearest configurations that lead to it, which nothing may change,
    as parse tells it."""
    if problem.dropped or not any(point.nearest for point in problem.waypoints):
        return None
    ends = {point.motion: k for k, point in enumerate(problem.waypoints)}
    found = check_configurations(problem.program, problem.plant)
    one = next((one for one in found if one.index in ends and _led_to(problem, ends[one.index])), None)
    return None if one is None else Infeasible(one.index, one.source, one.message)


def _led_to(problem: Problem, k: int) -> bool:
    """Whether the axes at waypoint k follow from given joints or confdata through nearest configurations."""
    chosen = False
    for point, leg in zip(problem.waypoints[k:0:-1], problem.legs[k - 1 :: -1], strict=False):
        if point.rail[0] < point.rail[1]:
            return False
        if point.q is not None or (leg.kind is LegKind.JOINT and point.conf is not None):
            return chosen
        if leg.kind is LegKind.JOINT and not point.nearest:
            return False
        chosen |= leg.kind is LegKind.JOINT
    return chosen


def unserved(axes: Axes, problem: Problem, first: int, last: int) -> Infeasible | None:
    """Why a station cannot be served; None where it can, first of all every line of it from one of few positions."""
    settings = axes.settings
    low, high = reach_intervals(axes, problem, first, last).T
    free = all(problem.waypoints[k].rail[0] < problem.waypoints[k].rail[1] for k in range(first, last + 1))
    if free or low.max() <= high.min() or not axes.layout.has_rail:
        d = grid_in_reach(axes, problem, first, last, settings.coarse_grid, settings.coarse_spacing)
        if (table := station_table(axes, problem, first, last, d)).labels and table.serves_lines:
            return None
    d = grid_in_reach(axes, problem, first, last, _REACH_GRID, settings.reach_spacing)
    table = station_table(axes, problem, first, last, d)
    if not table.labels:  # else one configuration reaches all of its waypoints
        return _first_failure(axes, problem, first, last, d)
    for i in range(last - first):
        if problem.legs[first + i].kind is LegKind.LINE and not _passable(problem, table, i):
            return _broken_line(axes, problem, first + i, d, table.labels) or _infeasible_on(
                problem,
                first + i,
                f": {_NO_SINGLE}{with_exact_orientation(problem.motion(problem.legs[first + i].motion))}",
            )
    return None


def broken_between(axes: Axes, problem: Problem, legs: Iterable[int]) -> Infeasible | None:
    """The first of these legs with a point that no configuration gets to, which check_reach may have looked past: its
    points stand closer together than the nodes there. None where every point is served."""
    settings = axes.settings
    for k in legs:
        if problem.legs[k].kind is not LegKind.LINE:
            continue
        first, last = next(station for station in problem.stations if station[0] <= k < station[1])
        d = grid_in_reach(axes, problem, first, last, _REACH_GRID, settings.reach_spacing)
        if (out := _broken_line(axes, problem, k, d, ())) is not None:
            return out
    return None


def _first_failure(axes: Axes, problem: Problem, first: int, last: int, d: Array) -> Infeasible | None:
    """What ends a station that no configuration serves: a waypoint out of reach, or the first line that none of those
    serves which served everything before it. Where a cycle begins is told where it ends."""
    start = problem.waypoints[first]
    begins = start.motion < 0 or isinstance(problem.motion(start.motion), Wait)  # which stands where it begins
    if begins and _out_of_reach(axes, problem, first, d):
        return unserved(axes, problem, first + 1, last) if first < last else None
    for k in range(first, last + 1):
        if _out_of_reach(axes, problem, k, d):
            return _unreachable(axes, problem, k, d)
    labels = station_table(axes, problem, first, first, d).labels
    for k in range(first + 1, last + 1):
        before, labels = labels, station_table(axes, problem, first, k, d).labels
        if labels:
            continue
        line = problem.legs[k - 1].kind is LegKind.LINE
        given = SingularStart.of(axes, problem, first, k)
        if given is not None and given.leg is problem.legs[k - 1]:
            if text := given.jump(axes, problem, d):
                return _infeasible_on(problem, k - 1, text)
            before = ()
        broken = _broken_line(axes, problem, k - 1, d, before) if line else None
        return broken or _no_common_branch(problem, first, k)
    raise AssertionError("a station without a label has a first stop where the labels end")


def _out_of_reach(axes: Axes, problem: Problem, k: int, d: Array) -> bool:
    """Whether no rail position and branch reach a waypoint, whatever stands around it."""
    stop = problem.waypoints[k]
    if stop.q is not None:
        return False
    return not station_table(axes, problem_at(problem, k), 0, 0, d).labels


def problem_at(problem: Problem, k: int) -> Problem:
    """The problem of one waypoint alone."""
    return replace(problem, waypoints=(problem.waypoints[k],), legs=(), stations=((0, 0),), ties=())


def _passable(problem: Problem, table: IkTable, i: int) -> bool:
    """Some label runs the whole line: with the rail moving if it may, else at one rail position."""
    leg = problem.legs[table.first + i]
    open_ = table.open_on(i)
    open_[:, 0] &= ~np.isnan(table.waypoints[i][..., 0])
    open_[:, -1] &= ~np.isnan(table.waypoints[i + 1][..., 0])
    return bool(open_.all(axis=1).any()) or (leg.rail_moves and any(_crosses(one) for one in open_))


def _crosses(open_: BoolArray) -> bool:
    """Whether a rail gets along a line: open_ (nodes, rail positions) says from where each node can be served.

    At a node it may go anywhere without a gap; to the next node by as much as takes it from end to end over the line.
    """
    nodes, n = open_.shape
    step = -(-(n - 1) // (nodes - 1))
    held = open_[0]
    for row in open_[1:]:
        near = np.convolve(held, np.ones(2 * step + 1), mode="full")[step : step + n] > 0.5
        runs = np.cumsum(np.diff(row, prepend=False) & row)  # the number of each run of open positions
        held = row & np.isin(runs, runs[near & row])
    return bool(held.any())


def _unreachable(axes: Axes, problem: Problem, k: int, d: Array) -> Infeasible:
    stop = problem.waypoints[k]
    motion = problem.motion(stop.motion)
    place = d[int(np.argmin(np.abs(d - _rail_abreast(axes, problem.seen(k)))))]
    if stop.rail[0] == stop.rail[1]:
        place = stop.rail[0]
    near = problem.axes_at(k, place, np.zeros(axes.layout.joints))[axes.layout.rail]
    reason = _why_unreachable(axes, problem, stop.X_WF, near)
    if not reason and (told := _configuration(problem, k)):
        text = told + _remedy(problem, k)
    else:
        reason = reason or _confdata_or_singular(problem, stop, near)
        text = f"{motion_name(motion)} cannot be reached{_at_rail(near)}: {reason}"
    return Infeasible(stop.motion, motion.source, text)


def _configuration(problem: Problem, k: int) -> str | None:
    """What is wrong with the configuration at waypoint k as parse tells it, which follows the line there; None where
    rail or confdata are not as written."""
    stop = problem.waypoints[k]
    if stop.conf is None or stop.rail[0] != stop.rail[1]:
        return None
    found = check_configurations(problem.program, problem.plant)
    return next((one.message for one in found if one.index == stop.motion), None)


def _at_rail(rail: Array) -> str:
    each = ", ".join(f"{one * 1e3:.1f}" for one in rail)
    return "" if not len(rail) else f" at rail {each} mm" if len(rail) == 1 else f" at rail [{each}] mm"


def _why_unreachable(axes: Axes, problem: Problem, X_WF: Array, rail: Array) -> str:
    """Why a pose is out of reach at rail positions (r,); empty when it is not."""
    if axes.robot.solutions(X_WF, rail, problem.plant.limits):
        return ""
    return axes.robot.why_unreachable(X_WF, rail, problem.plant.limits)


def _confdata_or_singular(problem: Problem, point: Waypoint, rail: Array) -> str:
    """Why a waypoint is not to be had though its pose is in reach."""
    if point.conf is None:
        return "too near a singularity"
    others = listed(reachable_confdata(problem.plant, point.X_WF, rail, point.conf))
    return f"not with confdata {shown(point.conf)}; {others}"


def _remedy(problem: Problem, k: int) -> str:
    """What to do about confdata that cannot be had at waypoint k, and the places behind it where it is the same."""
    motion = problem.motion(problem.waypoints[k].motion)
    text = f"; correct the confdata, or set {'ConfL' if isinstance(motion, MoveL) else 'ConfJ'} \\Off before it"
    kept = {point.motion for point in problem.waypoints[k + 1 :] if point.conf is not None}
    found = check_configurations(problem.program, problem.plant)
    places = dict.fromkeys(str(one.source) for one in found if one.misfit is Misfit.CONFDATA and one.index in kept)
    places.pop(str(motion.source), None)
    if not places:
        return text
    named = [*places][: _PLACES - 1]
    more = f" and {len(places) - len(named)} more" if len(places) > len(named) else ""
    return f"{text}; likewise {', '.join(named)}{more}"


def _rail_abreast(axes: Axes, X_WF: Array) -> float:
    """The sought rail's position at which the base stands nearest to a pose."""
    p = axes.in_base(X_WF)[:3, 3]
    return float(np.sum(p @ axes.rail_axis[:, axes.layout.sought :][:, :1]))


def _broken_line(axes: Axes, problem: Problem, k: int, d: Array, labels: tuple[IkBranch, ...]) -> Infeasible | None:
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
    seen = problem.seen_along(leg, shares)
    arm = [axes.inverse(np.broadcast_to(X, (len(rails), 4, 4)), rails) for X in seen]
    # a point out of everything's reach says most; else the one where the last configuration ends
    known = {label.cfx for label in labels if label.cfx >= 0} or set(range(arm[0].shape[1]))
    lost = _first_lost(axes, leg, arm, set(range(arm[0].shape[1])))
    if lost is None:
        serves_lines = problem.waypoints[k].q is not None  # joints are given there: no singularity is in the way
        pinned = len(fixed) == 2
        on_way = [arm[0] if serves_lines else usable(axes, arm[0], pinned), *(usable(axes, q, pinned) for q in arm[1:])]
        lost = _first_lost(axes, leg, on_way, known)
    if lost is None:
        return None
    at, before = lost
    X_WT, X_WF = X[at], X_WF[at]
    place = rails[int(np.argmin(np.abs(rails - _rail_abreast(axes, seen[at]))))]
    ends = [problem.axes_at(j, place, np.zeros(axes.layout.joints))[axes.layout.rail] for j in (k, k + 1)]
    near = ends[0] + shares[at] * (ends[1] - ends[0])
    reason = _why_unreachable(axes, problem, X_WF, near)
    where = _at_rail(near)
    if not reason:
        reason = f"{_NO_SINGLE}{_nearest_limit(axes, arm[at][before])}{with_exact_orientation(motion)}"
    p = X_WT[:3, 3] * 1e3
    way = leg.chord * 1e3
    text = (
        f"{motion_name(motion)} breaks at {shares[at] * way:.1f} mm of {way:.1f} mm,"
        f" point [{p[0]:.1f}, {p[1]:.1f}, {p[2]:.1f}] mm{where}: {reason}"
    )
    return Infeasible(leg.motion, motion.source, text)


def _first_lost(axes: Axes, leg: Leg, arm: list[Array], branches: set[int]) -> tuple[int, BoolArray] | None:
    """The first of the points, with joints arm (rails, b, m) each, to which none of the branches gets; and which of
    those joints (rails, b) are had from the point before."""
    alive = np.tile([cfx in branches for cfx in range(arm[0].shape[1])], (len(arm[0]), 1))
    for at, q in enumerate(arm):
        before = np.broadcast_to(np.any(alive, axis=0), alive.shape) if leg.rail_moves else alive
        alive = _in_limits(axes, q) & before
        if not np.any(alive):
            return at, before
    return None


def _nearest_limit(axes: Axes, arm: Array) -> str:
    """What stops the configurations that come to a point last, with joints (k, m) there: the range that one of them
    leaves by the least."""
    names, lower, upper = (one[axes.layout.arm] for one in (axes.names, axes.lower, axes.upper))
    worst = [
        max((excess(*one), name) for *one, name in zip(q, lower, upper, names, strict=True))
        for q in arm[np.isfinite(arm).all(axis=-1)].tolist()
    ]
    (over, value, limit), name = min(worst, default=((0.0, 0.0, 0.0), ""))
    if over <= ON_LIMIT:
        return ""
    return f"; the last that comes so far ends with {name} = {np.degrees(value):.6g}°, limit {np.degrees(limit):.6g}°"


def _in_limits(axes: Axes, arm: Array) -> BoolArray:
    low, high = axes.lower[axes.layout.arm] - 1e-9, axes.upper[axes.layout.arm] + 1e-9
    ok, couplings = np.zeros(arm.shape[:-1], dtype=bool), axes.couplings.arm(axes.layout.arm)
    for turn in axes.robot.turns:
        ok |= np.all((arm + turn >= low) & (arm + turn <= high), axis=-1) & couplings.within(arm + turn)
    return ok


def _infeasible_on(problem: Problem, k: int, text: str) -> Infeasible:
    motion = problem.motion(problem.legs[k].motion)
    return Infeasible(problem.legs[k].motion, motion.source, f"{motion_name(motion)}{text}")


def _no_common_branch(problem: Problem, first: int, last: int) -> Infeasible:
    index = problem.waypoints[last].motion
    motion = problem.motion(index)
    if told := _configuration(problem, last):
        return Infeasible(index, motion.source, told)
    start = problem.motion(problem.waypoints[first].motion) if problem.waypoints[first].motion >= 0 else None
    begin = f"{start.source}" if start else "the start"
    text = (
        f"{motion_name(motion)}: no configuration serves all points from {begin} to here; the lines"
        f" between them keep the branch and the turns of the joints"
    )
    if note := with_exact_orientation(motion):
        text += f"{note}: program the configuration that the line leads to (trajopt parse names it), or use MoveJ"
    return Infeasible(index, motion.source, text)
