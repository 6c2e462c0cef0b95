"""A feed that moves the arm along its plan: u = x + (D/K) x' + (M/K) x'', the law solved for its equilibrium.

The arm's motion x comes first: the path with its corners rounded within the lag, as fast as the lead allows. As
M x'' + D x' is what the law pushes with, a bound on the lead is one on that.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil

import numpy as np

from trajopt_cli.compliance.controller.dose_allowed import Allowed
from trajopt_cli.compliance.controller.dose_path import DosePath
from trajopt_cli.compliance.controller.dose_rounded import Pace, Push, Rounded, fastest, rounded
from trajopt_cli.compliance.task.angles import angles_near
from trajopt_cli.compliance.task.equilibrium import Piece
from trajopt_cli.compliance.task.model import Compliance, Integration
from trajopt_cli.geometry import Array, rotations_by

TURNED = float(np.radians(1.0))
"""How far [rad] corners of the orientation are rounded where no turn lag is bounded."""
_PIECES = (2_000, 40_000)  # of the grid at least and at most; between them one per period


@dataclass(frozen=True, eq=False)
class Inverse:
    """Rows of a feed: its poses and those of plan and arm, (m, 6) and (m, 3, 3) each, and the path parameter s (m,)."""

    feed: tuple[Array, Array]
    plan: tuple[Array, Array]
    s: Array
    pieces: tuple[Piece, ...]


def inverse(
    path: DosePath,
    law: Compliance,
    h: float,
    allowed: Allowed,
    integration: Integration,
    acceleration: tuple[float | None, float | None] = (None, None),
) -> Inverse:
    """The fastest motion along path under allowed, and what to feed for it.

    acceleration: greatest of the arm's [m/s2] and [rad/s2], None for none.
    """
    moves = np.any(path.pose != path.pose[0], axis=0)
    radius = _radius(law, moves)
    turn_lag = TURNED if allowed.turn_lag is None else allowed.turn_lag
    pieces = int(np.clip(path.least_time / h, *_PIECES))
    pushes = _pushes(law, allowed, acceleration)
    # a path that stands at its corners anyway is not helped by rounding them
    ways = (rounded(path, allowed.lag, turn_lag, radius, stops) for stops in (False, True))
    paces = [(fastest(way, pushes, pieces, h), way) for way in ways]
    pace, way = min(paces, key=lambda found: found[0].t[-1])
    s, coordinates, effort = _motion(way, pace, law, h, integration)
    lead = np.divide(effort, law.K, out=np.zeros_like(effort), where=(law.K > 0) & moves)
    row = way.row[way.corner(s)]
    plan = path.poses(way.plain(s), row)
    if path.R is None:
        feed = path.poses(coordinates + lead, row)
    else:
        arm = path.poses(coordinates, row)
        R = rotations_by(lead[:, 3:]) @ arm[1]
        feed = (np.hstack([arm[0][:, :3] + lead[:, :3], angles_near(R, arm[0][:, 3:])]), R)
    return Inverse(feed, plan, np.interp(s, way.along, path.s), _pieces(way, s, h))


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


def _pieces(way: Rounded, s: Array, h: float) -> tuple[Piece, ...]:
    """The rows of every leg; one that only passes a waypoint ends with the first row at or past it."""
    out: list[Piece] = []
    row = 0
    for leg in way.path.legs:
        last = row + round(leg.dwell / h) if leg.dwell else int(np.searchsorted(s, way.along[leg.last]))
        out.append(Piece(row, last, leg.origin, leg.goal, dwell=leg.dwell > 0))
        row = last
    return tuple(out)
