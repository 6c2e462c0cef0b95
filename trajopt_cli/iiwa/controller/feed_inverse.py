"""A feed that moves the arm along its plan: u = x + (D/K) x' + (M/K) x'', the law solved for its equilibrium.

The arm's motion x comes first: the path with its corners rounded within the lag, as fast as the lead allows. As
M x'' + D x' is what the law pushes with, a bound on the lead is one on that.
"""

from __future__ import annotations

from dataclasses import replace
from math import ceil

import numpy as np

from trajopt_cli.geometry import Array, rotations_by
from trajopt_cli.iiwa.controller.feed_limits import Allowed
from trajopt_cli.iiwa.controller.feed_path import DosePath, Schedule
from trajopt_cli.iiwa.controller.feed_rounded import Pace, Push, Rounded, fastest, rounded
from trajopt_cli.iiwa.task.angles import angles_near
from trajopt_cli.iiwa.task.model import Compliance, Integration

TURNED = float(np.radians(1.0))
"""How far [rad] corners of the orientation are rounded where no turn lag is bounded."""
_AT_REST = 1e-6  # of the path's length: rows this near to a waypoint are at it
_PIECES = (2_000, 40_000)  # of the grid at least and at most; between them one per period


def inverse(
    path: DosePath,
    law: Compliance,
    h: float,
    allowed: Allowed,
    integration: Integration,
    acceleration: tuple[float | None, float | None] = (None, None),
) -> Schedule:
    """The fastest motion along path under allowed, and what to feed for it.

    acceleration: greatest of the arm's [m/s2] and [rad/s2], None for none.
    """
    moves = np.any(path.pose != path.pose[0], axis=0)
    radius = _radius(law, moves)
    turn_lag = TURNED if allowed.turn_lag is None else allowed.turn_lag
    pieces = int(np.clip(path.least_time / h, *_PIECES))
    pushes = _pushes(law, allowed, acceleration)
    # a path that stands at its corners anyway is not helped by rounding them, and is the same twice without any
    passing, stopping = (rounded(path, allowed.lag, turn_lag, radius, stops) for stops in (False, True))
    rounds = (passing,) if np.array_equal(passing.tau, stopping.tau) else (passing, stopping)
    ways = (_with_rows_at_waypoints(way, h) for way in rounds)
    paces = [(fastest(way, pushes, pieces, h), way) for way in ways]
    pace, way = min(paces, key=lambda found: found[0].t[-1])
    s, coordinates, effort = _motion(way, pace, law, h, integration)
    lead = np.divide(effort, law.K, out=np.zeros_like(effort), where=(law.K > 0) & moves)
    row = way.row[way.corner(s)]
    planned = _through_waypoints(way, s)
    plan = path.poses(way.plain(planned), way.row[way.corner(planned)])
    if path.R is None:
        feed = path.poses(coordinates + lead, row)
    else:
        arm = path.poses(coordinates, row)
        R = rotations_by(lead[:, 3:]) @ arm[1]
        feed = (np.hstack([arm[0][:, :3] + lead[:, :3], angles_near(R, arm[0][:, 3:])]), R)
    # one that only passes a waypoint ends with the first row at or past it
    arrivals = np.searchsorted(planned, way.along[[leg.last for leg in path.legs]]).tolist()
    *before, end = path.pieces(arrivals, h)
    rows = (*before, replace(end, last=len(planned) - 1))
    return Schedule(*feed, *plan, np.interp(planned, way.along, path.s), rows)


def _radius(law: Compliance, moves: Array) -> float:
    """Where a mass turns with the inertia of the rotation [m]; 1 where the path only turns."""
    if not np.any(moves[:3]):
        return 1.0
    return float(np.sqrt(np.max(law.M[3:]) / np.max(law.M[:3])))


def _pushes(law: Compliance, allowed: Allowed, acceleration: tuple[float | None, float | None]) -> list[Push]:
    out = []
    for part, lead, most in zip(
        (slice(0, 3), slice(3, 6)), (allowed.lead, allowed.turn_lead), acceleration, strict=True
    ):
        if lead is not None:
            weight = lead.weight(law.K[part])
            out.append(Push(part, weight * law.M[part], weight * law.D[part], lead.most))
        if most is not None:
            out.append(Push(part, np.ones(3), np.zeros(3), most))
    return out


def _motion(
    way: Rounded, pace: Pace, law: Compliance, h: float, integration: Integration
) -> tuple[Array, Array, Array]:
    """Parameter (m,), the arm's coordinates (m, 6) and the effort M x'' + D x' (m, 6) that drives it, a row every h.

    Euler's law moves with the speed it had, so its arm stands for the first period, and its rows give their rates by
    differences; the exact law's effort is the mean over a period.
    """
    count = ceil(pace.t[-1] / h - 1e-9)
    t = np.arange(count + 1) * h
    if integration is Integration.EULER:
        t = np.concatenate([[0.0], t])
        s = pace.at(t)[0]
        x = way.at(s)[0]
        v = np.diff(x, axis=0, append=x[-1:]) / h
        rate, pull = v, np.diff(v, axis=0, append=np.zeros((1, 6))) / h
        return s, x, law.M * pull + law.D * rate
    s, pace_s, _ = pace.at(t)
    x, dx, _ = way.at(s)
    v = dx * pace_s[:, None]
    mean = np.diff(x, axis=0, append=x[-1:]) / h
    pull = np.diff(v, axis=0, append=np.zeros((1, 6))) / h
    # the equilibrium is held for a period while the arm moves on, by half of it in the mean
    return s, x, law.M * pull + law.D * mean + law.K * mean * h / 2


def _with_rows_at_waypoints(way: Rounded, h: float) -> Rounded:
    """The same with caps that leave a plan room to be up to half a period's way ahead of the arm or behind at both
    ends."""
    cap = way.cap.copy()
    passed = way.tau[np.searchsorted(way.row, [(leg.first, leg.last) for leg in way.path.legs])] > 0
    for leg, ends in zip(way.path.legs, np.any(passed, axis=1).tolist(), strict=True):
        if ends and leg.last > leg.first:
            rows = slice(leg.first, leg.last)
            cap[rows] /= 1 + 2 * np.max(cap[rows]) * h / (way.along[leg.last] - way.along[leg.first])
    return replace(way, cap=cap)


def _through_waypoints(way: Rounded, s: Array) -> Array:
    """The plan's parameter (m,) beside the arm's: the row nearest to a waypoint is at it, as the sequence's own had it.

    What that moves the row by is spread over the rows of both legs, unless the arm all but stands there.
    """
    marks = np.unique(way.along[[0, *(leg.last for leg in way.path.legs)]])
    near = _AT_REST * way.length[-1]
    first, last = np.searchsorted(s, marks - near), np.searchsorted(s, marks + near, side="right") - 1
    passed = last < first  # no row is there
    before = np.maximum(first - 1, 0)
    first = np.where(passed & (marks - s[before] < s[np.minimum(first, len(s) - 1)] - marks), before, first)
    last = np.where(passed, first, last)
    own = np.insert(np.diff(first) > 0, 0, True)  # of waypoints nearer than a period's way to one another the first
    anchors = np.unique(np.concatenate([first[own], last[own]]))
    ends = np.searchsorted(first[own], anchors, side="right") - 1
    off = np.interp(np.arange(len(s)), anchors, np.where(passed[own], marks[own] - s[first[own]], 0.0)[ends])
    out = np.clip(s + off, 0.0, way.length[-1])
    for mark, a, b in zip(marks[own].tolist(), first[own].tolist(), last[own].tolist(), strict=True):
        out[a : b + 1] = mark
    return np.maximum.accumulate(out)
