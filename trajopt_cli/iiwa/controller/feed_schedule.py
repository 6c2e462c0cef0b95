"""Feed schedules: the equilibrium's timing along its path, so that neither the arm's lag nor its push passes a bound.

The feed inverts the law: u = x + (D/K) x' + (M/K) x'' moves the arm along x. That motion comes first: the path with
its corners rounded within the lag, as fast as the lead allows. As M x'' + D x' is what the law pushes with, a bound on
the lead is one on that.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import cycle
from math import ceil, isfinite

import numpy as np

from trajopt_cli.geometry import Array, IndexArray, rotations_by
from trajopt_cli.iiwa.controller.feed_bound import least_duration
from trajopt_cli.iiwa.controller.feed_path import Allowed, CannotDose, DosePath, Lead
from trajopt_cli.iiwa.controller.feed_rounded import Pace, Push, Rounded, fastest, rounded
from trajopt_cli.iiwa.controller.lag import Lag, held, settling, worst_lag
from trajopt_cli.iiwa.controller.regulator import response
from trajopt_cli.iiwa.controller.stability import AxisStability, StabilityVerdict, stability
from trajopt_cli.iiwa.task.angles import angles_near, rotation, rotation_vector
from trajopt_cli.iiwa.task.equilibrium import Piece
from trajopt_cli.iiwa.task.model import BETA_LIMIT, Compliance, Integration

ROWS = 3_000_000
"""Rows a dosed sequence may have: 50 min at 1 ms."""
ARRIVED = 1e-3
"""Distance [m] from the last pose at which the arm counts as arrived, where its orientation is there too."""
ARRIVED_TURN = float(np.radians(0.1))
"""Angle [rad] from the last pose's orientation at which the arm counts as arrived."""
SLOWEST = 100_000
"""Periods that the slowest axis on the path may take to lose two thirds of a deviation; more is refused at once."""
TURNED = float(np.radians(1.0))
"""How far [rad] corners of the orientation are rounded where no turn lag is bounded."""
_TOLERANCE = 1e-9  # relative excess over a bound that the final check forgives as rounding
_REST = 10.0  # slowest time constants after which the arm counts as at rest
_CORRECTIONS = 8  # times that a plan is made again with what it passed its bounds by taken off them
_SPARE = 1e-3  # share of a bound taken off in addition
_USEFUL = 2.0  # times a lower bound up to which it says something
_LARGEST_LEAD = float(np.radians(150.0))  # an equilibrium turned farther than that would pull the other way round
_EASED_LEAD = 0.9  # share of it that is planned with where no bound on the turn's lead is given and it is passed
_AT_REST = 1e-6  # of the path's length: rows this near to a waypoint are at it
_PIECES = (2_000, 40_000)  # of the grid at least and at most; between them one per period


@dataclass(frozen=True, eq=False)
class FeedTask:
    """What is scheduled: a path, the law of the controller that follows it, and its period h [s].

    acceleration: greatest of the arm [m/s2] and [rad/s2], None for none. changes: numbers of legs, in order, from whose
    beginning on another law holds.
    """

    path: DosePath
    law: Compliance
    h: float
    integration: Integration = Integration.EULER
    acceleration: tuple[float | None, float | None] = (None, None)
    changes: Sequence[tuple[int, Compliance]] = ()

    @property
    def laws(self) -> tuple[Compliance, ...]:
        """The law and those after it."""
        return self.law, *(law for _, law in self.changes)

    def diagonals(self, which: IndexArray) -> tuple[Array, Array, Array]:
        """K, D and M (n, 6) of the laws in force, by number (n,)."""
        K, D, M = (np.array([getattr(law, name) for law in self.laws])[which] for name in "KDM")
        return K, D, M


@dataclass(frozen=True, eq=False)
class FedRows:
    """A feed before it is simulated: rows fed and, as plan and R_plan, where the arm should be, poses (m, 6) and
    R (m, 3, 3) each, at path parameters s (m,). pieces: the rows by leg. turned [rad]: how far what is fed is ahead of
    the arm at most."""

    pose: Array
    R: Array
    plan: Array
    R_plan: Array
    s: Array
    pieces: tuple[Piece, ...]
    turned: float


@dataclass(frozen=True, eq=False)
class Dosed(FedRows):
    """A retimed sequence: what is fed, every h [s].

    x (m, 6), R_x (m, 3, 3): where the arm is. lag: the worst deviation from the plan, the coming to rest after the end
    included; its turn is the angle between orientations. push [N], turn_push [Nm]: the greatest K (x_e - x), with which
    the controller would begin to push if the arm were held; lead [m], turn_lead [rad]: the same as a stretch of the
    spring.
    arrived [s]: from when on the arm is within ARRIVED and ARRIVED_TURN of the end, None when it takes longer than the
    simulation. least [s]: what no sequence within these bounds can go below; None where what is known is less than half
    of the duration, and tells nothing.
    """

    h: float
    x: Array
    R_x: Array
    allowed: Allowed
    lag: Lag
    push: float
    turn_push: float
    lead: float
    turn_lead: float
    arrived: float | None
    least: float | None
    notes: tuple[str, ...] = ()

    @property
    def duration(self) -> float:
        """Time of the last row [s]."""
        return (len(self.pose) - 1) * self.h

    @property
    def gap(self) -> float | None:
        """(duration - least) / least."""
        return None if self.least is None else (self.duration - self.least) / self.least


def dose(of: FeedTask, allowed: Allowed) -> Dosed:
    """The fastest sequence along a path that keeps what is allowed, simulated and held against it.

    Raises CannotDose where there is none, or none of three million rows, and for laws slower than SLOWEST.
    """
    path, h = of.path, of.h
    axes = [axis for law in of.laws for axis in stability(law, h, of.integration)]
    _check_followed(of, axes)
    # with several laws only the caps are sure
    least = path.least_time if of.changes else least_duration(path, h, of.law, allowed, of.integration)
    if least / h > ROWS:
        raise CannotDose(
            f"a {allowed} would take at least {least:.0f} s, more than {ROWS} rows of {h:g} s; "
            "allow more, or give more stiffness or less damping"
        )
    slowest = (axis.slowest for axis, there in zip(axes, cycle(path.moves), strict=False) if there)
    rest = _REST * min(max(filter(isfinite, slowest), default=h), SLOWEST * h)
    tried = allowed
    for _ in range(_CORRECTIONS):
        found = _simulated(of, allowed, _inverse(of, tried), rest)
        tighter = _corrected(found, allowed, tried)
        if tighter is None:
            return replace(found, least=least if found.duration <= _USEFUL * least else None)
        tried = tighter
    raise CannotDose(f"a {allowed} is too small for the rounding of positions; allow more")


def _inverse(of: FeedTask, allowed: Allowed) -> FedRows:
    """What moves the arm along the plan, as long as the controller's angles can say it."""
    found = _scheduled(of, allowed)
    if len(found.s) > ROWS:
        raise CannotDose(f"a {allowed} would take {len(found.s)} rows, more than {ROWS}; allow more")
    turned, beta = found.turned, float(np.max(np.abs(found.pose[:, 4])))
    if turned > _LARGEST_LEAD and allowed.turn_lead is None:
        return _inverse(of, replace(allowed, turn_lead=Lead(_EASED_LEAD * _LARGEST_LEAD, stretch=True)))
    if turned > _LARGEST_LEAD:
        raise CannotDose(
            f"the inverse feed would be turned ahead by {np.degrees(turned):.0f}°, too far for the law to know which "
            "way round; give a smaller --max-turn-lead, or lower omega_max"
        )
    if of.path.R is None and beta > BETA_LIMIT:
        raise CannotDose(
            f"the inverse feed would reach beta = {np.degrees(beta):.0f}°, beyond {np.degrees(BETA_LIMIT):.0f}°; "
            "give a smaller --max-turn-lead, lower omega_max, or take rotation: slerp"
        )
    return found


def _scheduled(of: FeedTask, allowed: Allowed) -> FedRows:
    """The fastest motion along the path under allowed, and what to feed for it."""
    path, h = of.path, of.h
    moves = np.array(path.moves)
    radius = _radius(of.law, moves)
    turn_lag = TURNED if allowed.turn_lag is None else allowed.turn_lag
    pieces = int(np.clip(path.least_time / h, *_PIECES))
    # a path that stands at its corners anyway is not helped by rounding them, and is the same twice without any
    passing, stopping = (rounded(path, allowed.lag, turn_lag, radius, stops) for stops in (False, True))
    rounds = (passing,) if np.array_equal(passing.tau, stopping.tau) else (passing, stopping)
    ways = (_with_rows_at_waypoints(way, h) for way in rounds)
    paces = [(fastest(way, partial(_pushes, of, allowed, way), pieces, h), way) for way in ways]
    pace, way = min(paces, key=lambda found: found[0].t[-1])
    s, coordinates, rates, pull, held = _motion(way, pace, h, of.integration)
    planned = _through_waypoints(way, s)
    # one that only passes a waypoint ends with the first row at or past it
    arrivals = np.searchsorted(planned, way.along[[leg.last for leg in path.legs]]).tolist()
    *before, end = path.pieces(arrivals, h)
    pieces_of = (*before, replace(end, last=len(planned) - 1))
    changed = [pieces_of[leg].first for leg, _ in of.changes]
    K, D, M = of.diagonals(np.searchsorted(changed, np.arange(len(planned)), side="right"))
    effort = M * pull + D * rates + K * held
    lead = np.divide(effort, K, out=np.zeros_like(effort), where=(K > 0) & moves)
    row = way.row[way.corner(s)]
    plan = path.poses(way.plain(planned), way.row[way.corner(planned)])
    if path.R is None:
        feed = path.poses(coordinates + lead, row)
    else:
        arm = path.poses(coordinates, row)
        R = rotations_by(lead[:, 3:]) @ arm[1]
        feed = (np.hstack([arm[0][:, :3] + lead[:, :3], angles_near(R, arm[0][:, 3:])]), R)
    turned = float(np.max(np.linalg.norm(lead[:, 3:], axis=1)))
    return FedRows(*feed, *plan, np.interp(planned, way.along, path.s), pieces_of, turned)


def _radius(law: Compliance, moves: Array) -> float:
    """Where a mass turns with the inertia of the rotation [m]; 1 where the path only turns."""
    if not np.any(moves[:3]):
        return 1.0
    return float(np.sqrt(np.max(law.M[3:]) / np.max(law.M[:3])))


def _pushes(of: FeedTask, allowed: Allowed, way: Rounded, s: Array) -> list[Push]:
    """The bounds on the push at places s (n,)."""
    K, D, M = of.diagonals(np.searchsorted([way.along[of.path.legs[leg].first] for leg, _ in of.changes], s))
    leads = (allowed.lead, allowed.turn_lead)
    out = []
    for part, lead, most in zip((slice(0, 3), slice(3, 6)), leads, of.acceleration, strict=True):
        if lead is not None:
            weight = lead.weight(K[:, part])
            out.append(Push(part, weight * M[:, part], weight * D[:, part], lead.most))
        if most is not None:
            out.append(Push(part, np.ones(3), np.zeros(3), most))
    return out


def _motion(way: Rounded, pace: Pace, h: float, integration: Integration) -> tuple[Array, Array, Array, Array, Array]:
    """Parameter (m,), the arm's coordinates (m, 6), x' and x'' (m, 6) that the law drives it with, and by how far the
    arm leaves a held equilibrium within a period, in the mean; a row every h.

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
        return s, x, v, np.diff(v, axis=0, append=np.zeros((1, 6))) / h, np.zeros_like(x)
    s, pace_s, _ = pace.at(t)
    x, dx, _ = way.at(s)
    v = dx * pace_s[:, None]
    mean = np.diff(x, axis=0, append=x[-1:]) / h
    pull = np.diff(v, axis=0, append=np.zeros((1, 6))) / h
    return s, x, mean, pull, mean * h / 2


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


def _simulated(of: FeedTask, allowed: Allowed, fed: FedRows, rest: float) -> Dosed:
    """The controller's answer to a feed, and the greatest lag and push. rest [s]: after the end."""
    path, law, h, integration = of.path, of.law, of.h, of.integration
    x_e, plan_x, R_e, R_plan = (held(rows, rest, h) for rows in (fed.pose, fed.plan, fed.R, fed.R_plan))
    changes = [(fed.pieces[leg].first, one) for leg, one in of.changes]
    turns = R_e if path.R is not None and any(path.moves[3:]) else None
    answer = response(
        *(x_e, h, law), R_e=turns, integration=integration, x_0=fed.plan[0], R_0=R_plan[0], changes=changes
    )
    x, R_x = answer.x, answer.R
    which = np.searchsorted([row for row, _ in changes], np.arange(len(x)), side="right")
    K = of.diagonals(which)[0]
    behind = x_e - x
    if R_x is None:
        R_x = rotation(x[:, 3:]) if path.R is None else R_plan
    if path.R is not None:
        x = np.column_stack([x[:, :3], angles_near(R_x, plan_x[:, 3:])])
        behind[:, 3:] = rotation_vector(R_e @ np.swapaxes(R_x, 1, 2))
    lead = np.where(K > 0, behind, 0.0)
    parts = (slice(0, 3), slice(3, 6))
    norms = [float(np.max(np.linalg.norm(rows[:, part], axis=1))) for part in parts for rows in (K * behind, lead)]
    n = len(fed.pose)
    return Dosed(
        **vars(fed),
        h=h,
        x=x[:n],
        R_x=R_x[:n],
        allowed=allowed,
        lag=worst_lag(x, plan_x, h, fed.pieces),
        push=norms[0],
        lead=norms[1],
        turn_push=norms[2],
        turn_lead=norms[3],
        arrived=settling(x, fed.plan[-1], ARRIVED, ARRIVED_TURN, h),
        least=None,
    )


def _corrected(made: Dosed, allowed: Allowed, tried: Allowed) -> Allowed | None:
    """What to plan with instead of tried, so that less of what passed allowed is used; None where nothing passed it.

    The rounded path knows the push at its places, and the lag of angles: nearly what they stand for.
    """
    scaled: dict[str, float | Lead] = {}
    for name, measured in (("lag", made.lag.maximum), ("turn_lag", made.lag.turn_maximum)):
        most = getattr(allowed, name)
        if most is not None and measured > most * (1 + _TOLERANCE):
            scaled[name] = getattr(tried, name) * most / measured * (1 - _SPARE)
    for name, push, stretch in (("lead", made.push, made.lead), ("turn_lead", made.turn_push, made.turn_lead)):
        lead = getattr(allowed, name)
        measured = 0.0 if lead is None else stretch if lead.stretch else push
        if lead is not None and measured > lead.most * (1 + _TOLERANCE):
            scaled[name] = replace(lead, most=getattr(tried, name).most * lead.most / measured * (1 - _SPARE))
    return replace(tried, **scaled) if scaled else None  # type: ignore[arg-type]


def _check_followed(of: FeedTask, axes: Sequence[AxisStability]) -> None:
    """Raises CannotDose where the arm would not follow along an axis that the path uses, or not while anyone waits."""
    for axis, moves in zip(axes, cycle(of.path.moves), strict=False):
        if not moves:
            continue
        if axis.k == 0:
            raise CannotDose(
                f"the path moves along {axis.axis}, where the stiffness is 0: nothing pulls the arm after the "
                f"equilibrium (hand guiding); give {axis.axis} a stiffness or a path without it"
            )
        if axis.verdict is not StabilityVerdict.STABLE:
            raise CannotDose(f"the path moves along {axis.axis}, but {axis.sentence}")
        most = of.h * SLOWEST
        if axis.slowest > most:
            takes = f"takes {axis.slowest:.3g} s to lose" if isfinite(axis.slowest) else "practically never loses"
            change = "raise k or lower d"
            if axis.damping_ratio < 1:
                change = "raise d or lower m" if of.integration is Integration.EXACT else "raise d, or lower m or h"
            raise CannotDose(
                f"the path moves along {axis.axis}, where the controller {takes} two thirds of a deviation "
                f"(k = {axis.k:g}, d = {axis.d:g}, m = {axis.m:g}), more than the {most:g} s that dosing allows; "
                f"{change}"
            )
