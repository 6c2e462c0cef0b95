"""Feed schedules: the equilibrium's timing along its path, so that neither the arm's lag nor its push passes a bound.

The path stays what it was; its timing becomes the fastest that one of three feeds allows:

position: the equilibrium is the plan, as far ahead of the arm as lag and lead let it. On one line that is the optimum
of this feed, because the law's answer to a deviation never takes anything back (see greedy_feed for corners).
velocity: the same with the plan's speed fed, too, so that only the inertia lags.
inverse: the equilibrium is what moves the arm along its plan (see feed_inverse).

Whatever the feed, M x'' + D x' is the push: with one bound on it the three differ by what the lag adds to that.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import Enum
from math import isfinite

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.controller.feed_bound import least_duration
from trajopt_cli.iiwa.controller.feed_inverse import inverse
from trajopt_cli.iiwa.controller.feed_limits import LAGS, TURN_LAGS, Allowed, DoseFeed, Lead
from trajopt_cli.iiwa.controller.feed_path import DosePath, Schedule, coarser
from trajopt_cli.iiwa.controller.feed_plan import ROWS, plan
from trajopt_cli.iiwa.controller.greedy_feed import SpeedFed, Walk, moving_axes
from trajopt_cli.iiwa.controller.lag import Lag, held, settling, worst_lag
from trajopt_cli.iiwa.controller.regulator import coefficients, equilibrium_rates, response, response_rotation
from trajopt_cli.iiwa.controller.stability import AxisStability, StabilityVerdict, stability
from trajopt_cli.iiwa.task.angles import angles_near, rotation, rotation_vector
from trajopt_cli.iiwa.task.equilibrium import Equilibrium, Piece
from trajopt_cli.iiwa.task.model import BETA_LIMIT, Compliance, Feed, Integration

ARRIVED = 1e-3
"""Distance [m] from the last pose at which the arm counts as arrived, where its orientation is there too."""
ARRIVED_TURN = float(np.radians(0.1))
"""Angle [rad] from the last pose's orientation at which the arm counts as arrived."""
SLOWEST = 100_000
"""Periods that the slowest axis on the path may take to lose two thirds of a deviation; more is refused at once."""
SLOWEST_SWING = 20_000
"""The same of an axis that swings meanwhile, which takes far more looking ahead."""
_TOLERANCE = 1e-9  # relative excess over a bound that the final check forgives as rounding
_COARSE = 0.05  # period of the search for brakes, in 1/pulse of the axis that swings fastest
_REST = 10.0  # slowest time constants after which the arm counts as at rest
_CORRECTIONS = 8  # times that a plan is made again with what it passed its bounds by taken off them
_WORTH = 0.02  # share of a turn lag that has to be left before it is planned again with more
_SPARE = 1e-3  # share of a bound taken off in addition
_USEFUL = 2.0  # times a lower bound up to which it says something
_LARGEST_LEAD = float(np.radians(150.0))  # an equilibrium turned farther than that would pull the other way round


@dataclass(frozen=True)
class CannotDose:
    """There is no such sequence, or none worth having; message says why and what to change."""

    message: str


@dataclass(frozen=True, eq=False)
class Dosed:
    """A retimed sequence: what is fed, pose (m, 6) and R (m, 3, 3) every h [s], at path parameter s (m,).

    plan, R_plan: where the arm should be, the same as what is fed but for the inverse feed. x (m, 6), R_x: where it is.
    pieces: the rows by leg. lag: the worst deviation from the plan, the coming to rest after the end included; its turn
    is the angle between orientations. push [N], turn_push [Nm]: the greatest K (x_e - x) + D v_e, with which the
    controller would begin to push if the arm were held; lead [m], turn_lead [rad]: the same as a stretch of the spring.
    arrived [s]: from when on the arm is within ARRIVED and ARRIVED_TURN of the end, None when it takes longer than the
    simulation. least [s]: what no sequence fed like this and within these bounds can go below; None where what is known
    is less than half of the duration, and tells nothing. braked: how many periods the equilibrium had to hold back for
    a later corner or end.
    """

    feed: DoseFeed
    h: float
    pose: Array
    R: Array
    plan: Array
    R_plan: Array
    s: Array
    x: Array
    R_x: Array
    pieces: tuple[Piece, ...]
    allowed: Allowed
    lag: Lag
    push: float
    turn_push: float
    lead: float
    turn_lead: float
    arrived: float | None
    least: float | None
    braked: int
    notes: tuple[str, ...]

    @property
    def duration(self) -> float:
        """Time of the last row [s]."""
        return (len(self.pose) - 1) * self.h

    @property
    def gap(self) -> float | None:
        """(duration - least) / least."""
        return None if self.least is None else (self.duration - self.least) / self.least


@dataclass(frozen=True, eq=False)
class _Case:
    """What is asked for, as of dose. rest [s]: until the arm counts as at rest after the end."""

    path: DosePath
    law: Compliance
    h: float
    allowed: Allowed
    feed: DoseFeed
    integration: Integration
    acceleration: tuple[float | None, float | None]
    rest: float


def dose(
    path: DosePath,
    compliance: Compliance,
    h: float,
    allowed: Allowed,
    *,
    feed: DoseFeed = DoseFeed.POSITION,
    integration: Integration = Integration.EULER,
    acceleration: tuple[float | None, float | None] = (None, None),
) -> Dosed | CannotDose:
    """The fastest sequence along path for this feed that keeps what is allowed, simulated and held against it.

    acceleration: greatest of the arm [m/s2] and [rad/s2] where the feed is the inverse one. Any bound can be kept,
    since the equilibrium may stand; what a small one costs is time, and more than three million rows are refused, as
    are lags beyond LAGS and TURN_LAGS and laws slower than SLOWEST or SLOWEST_SWING.
    """
    laws = stability(compliance, h, integration)
    refusal = _beyond(allowed) or _unfollowed(path, laws, h, integration)
    if refusal is not None:
        return refusal
    least = least_duration(path, h, compliance, allowed, integration, feed)
    if least / h > ROWS:
        return CannotDose(
            f"{_named(allowed)} would take at least {least:.0f} s, more than {ROWS} rows of {h:g} s; "
            "allow more, or give more stiffness or less damping"
        )
    rest = _resting_time(moving_axes(path), laws, h)
    case = _Case(path, compliance, h, allowed, feed, integration, acceleration, rest)
    tried, best = allowed, None
    for _ in range(_CORRECTIONS):
        schedule = _inverse(case, tried) if feed is DoseFeed.INVERSE else _greedy(case, tried)
        if isinstance(schedule, CannotDose):
            return best or schedule
        found = _simulated(case, schedule)
        tighter = _corrected(found, allowed, tried)
        if tighter is not None:
            if best is not None:
                break
            tried = tighter
            continue
        better = best is None or found.duration < best.duration
        best = found if better else best
        looser = _loosened(path, found, allowed, tried)
        if looser is None or not better:
            break
        tried = looser
    if best is None:
        return CannotDose(f"{_named(allowed)} is too small for the rounding of positions; allow more")
    return replace(best, least=least if best.duration <= _USEFUL * least else None)


def _greedy(case: _Case, allowed: Allowed) -> Schedule | CannotDose:
    """The plan itself as feed, one period after another."""
    path, law, h = case.path, case.law, case.h
    axes = coefficients(law.K, law.D, law.M, h, case.integration)
    lag, turn_lag = allowed.lags(law.K)
    fed = _speed_fed(law, allowed) if case.feed is DoseFeed.VELOCITY else None
    walk = Walk(path, h, axes, lag, turn_lag, fed)
    swinging = _swinging(path, law, turn_lag is not None)
    if swinging is None:
        states, braked = plan(walk, None, 0.0)
    else:
        longest, pulse = swinging
        longer = max(h, _COARSE / pulse)
        rough = coefficients(law.K, law.D, law.M, longer, Integration.EXACT)
        states, braked = plan(walk, Walk(coarser(path, longer), longer, rough, lag, turn_lag, fed), longest)
    if not walk.done(states[-1]):
        more = "stiffness or less damping" if swinging is None else "damping, so that the arm swings less"
        return CannotDose(
            f"given up after {len(states)} rows and {walk.lookahead} periods of looking ahead, at "
            f"{walk.s(states[-1]) / path.s[-1]:.0%} of the path; allow more lag, or more {more}"
        )
    s = np.array([walk.s(state) for state in states])
    pose, R = path.poses(path.at(s), np.clip(np.searchsorted(path.s, s, side="right") - 1, 0, len(path.s) - 1))
    segment = np.array([state.segment for state in states])
    arrivals = np.searchsorted(segment, [leg.last for leg in path.legs]).tolist()
    return Schedule(pose, R, pose, R, s, path.pieces(arrivals, h), braked)


def _speed_fed(law: Compliance, allowed: Allowed) -> SpeedFed:
    leads = (allowed.lead, slice(0, 3)), (allowed.turn_lead, slice(3, 6))
    weight = np.concatenate([np.ones(3) if lead is None else lead.weight(law.K[part]) for lead, part in leads])
    most, turn_most = (None if lead is None else lead.most for lead, _ in leads)
    return SpeedFed(weight * law.K, weight * law.D, most, turn_most)


def _inverse(case: _Case, allowed: Allowed) -> Schedule | CannotDose:
    """What moves the arm along the plan, as long as the controller's angles can say it."""
    found = inverse(case.path, case.law, case.h, allowed, case.integration, case.acceleration)
    if len(found.s) > ROWS:
        return CannotDose(f"{_named(allowed)} would take {len(found.s)} rows, more than {ROWS}; allow more")
    turned = float(np.max(_angles(found.R, found.R_plan)))
    if turned > _LARGEST_LEAD:
        return CannotDose(
            f"the inverse feed would be turned ahead by {np.degrees(turned):.0f}°, too far for the law to know which "
            "way round; give a smaller --max-turn-lead, or lower omega_max"
        )
    beta = float(np.max(np.abs(found.pose[:, 4])))
    if case.path.R is None and beta > BETA_LIMIT:
        return CannotDose(
            f"the inverse feed would reach beta = {np.degrees(beta):.0f}°, beyond {np.degrees(BETA_LIMIT):.0f}°; "
            "give a smaller --max-turn-lead, lower omega_max, or take rotation: slerp"
        )
    return found


def _simulated(case: _Case, fed: Schedule) -> Dosed:
    """The controller's answer to a feed, and the greatest lag and push."""
    path, law, h, integration = case.path, case.law, case.h, case.integration
    x_e, plan_x = held(fed.pose, case.rest, h), held(fed.plan, case.rest, h)
    more = len(x_e) - len(fed.pose)
    R_e, R_plan = (np.concatenate([R, np.repeat(R[-1:], more, axis=0)]) for R in (fed.R, fed.R_plan))
    feed = Feed.VELOCITY if case.feed is DoseFeed.VELOCITY else Feed.POSITION
    x = response(x_e, h, law, integration=integration, feed=feed, x_0=fed.plan[0]).x
    behind = x_e - x
    v_e = equilibrium_rates(x_e, h) if feed is Feed.VELOCITY else np.zeros_like(x_e)
    R_x = rotation(x[:, 3:])
    if path.R is not None:
        R_x = R_plan
        if np.any(moving_axes(path)[3:]):
            diagonals = law.K[3:], law.D[3:], law.M[3:]
            R_x = response_rotation(R_e, h, *diagonals, integration=integration, feed=feed, R_0=fed.R_plan[0]).R
        x = np.column_stack([x[:, :3], angles_near(R_x, plan_x[:, 3:])])
        behind[:, 3:] = rotation_vector(R_e @ np.swapaxes(R_x, 1, 2))
        if feed is Feed.VELOCITY:
            v_e[:-1, 3:] = rotation_vector(R_e[1:] @ np.swapaxes(R_e[:-1], 1, 2)) / h
    push = law.K * behind + law.D * v_e
    lead = np.divide(push, law.K, out=np.zeros_like(push), where=law.K > 0)
    parts = (slice(0, 3), slice(3, 6))
    norms = [float(np.max(np.linalg.norm(rows[:, part], axis=1))) for part in parts for rows in (push, lead)]
    held_back = f"the equilibrium holds back for {fed.braked * h:.3f} s, so that the arm does not overshoot by more"
    n = len(fed.pose)
    return Dosed(
        feed=case.feed,
        h=h,
        pose=fed.pose,
        R=fed.R,
        plan=fed.plan,
        R_plan=fed.R_plan,
        s=fed.s,
        x=x[:n],
        R_x=R_x[:n],
        pieces=fed.pieces,
        allowed=case.allowed,
        lag=worst_lag(x, fed.plan, h, fed.pieces),
        push=norms[0],
        lead=norms[1],
        turn_push=norms[2],
        turn_lead=norms[3],
        arrived=settling(x, fed.plan[-1], ARRIVED, ARRIVED_TURN, h),
        least=None,
        braked=fed.braked,
        notes=(held_back,) if fed.braked else (),
    )


def _corrected(made: Dosed, allowed: Allowed, tried: Allowed) -> Allowed | None:
    """What to plan with instead of tried, so that less of what passed allowed is used; None where nothing passed it.

    The walk knows the lag of angles, the rounded path the push between its places: both are nearly what they stand for.
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


def _loosened(path: DosePath, made: Dosed, allowed: Allowed, tried: Allowed) -> Allowed | None:
    """What to plan with where three Tait-Bryan angles are farther apart than the orientations; None where they are
    not."""
    turned = made.lag.turn_maximum
    if path.R is not None or made.feed is DoseFeed.INVERSE or allowed.turn_lag is None or tried.turn_lag is None:
        return None
    if not 0 < turned < (1 - _WORTH) * allowed.turn_lag:
        return None
    return replace(tried, turn_lag=tried.turn_lag * allowed.turn_lag / turned * (1 - _SPARE))


def _angles(R: Array, other: Array) -> Array:
    """Angles (n,) [rad] between orientations (n, 3, 3)."""
    return np.asarray(np.linalg.norm(rotation_vector(R @ np.swapaxes(other, 1, 2)), axis=1))


def _named(allowed: Allowed) -> str:
    """What is allowed, in words."""
    out = f"a lag of at most {allowed.lag:g} m"
    if allowed.turn_lag is not None:
        out += f" and {allowed.turn_lag:g} rad"
    for lead, unit, stretched in ((allowed.lead, "N", "m"), (allowed.turn_lead, "Nm", "rad")):
        if lead is not None:
            out += f", a lead of at most {lead.most:g} {stretched if lead.stretch else unit}"
    return out


class Feeding(Enum):
    """The ways to feed one path that compare holds against each other."""

    UNDOSED = "as programmed"
    VELOCITY = "with the equilibrium's speed"
    DOSED = "dosed"


@dataclass(frozen=True)
class FeedRow:
    """One way of feeding: duration of the sequence [s], arrived [s] as in Dosed (None: not yet), and the lag."""

    feeding: Feeding
    duration: float
    arrived: float | None
    lag: Lag


def compare(
    equilibrium: Equilibrium,
    compliance: Compliance,
    dosed: Dosed | None,
    *,
    integration: Integration = Integration.EULER,
) -> tuple[FeedRow, ...]:
    """The sequence as it is, the same with its speed fed too (eq. 4.2), and the dosed one where there is one."""
    h = equilibrium.h
    moves = np.any(equilibrium.pose != equilibrium.pose[0], axis=0)
    x_e = held(equilibrium.pose, _resting_time(moves, stability(compliance, h, integration), h), h)
    rows = []
    for feeding, feed in ((Feeding.UNDOSED, Feed.POSITION), (Feeding.VELOCITY, Feed.VELOCITY)):
        x = response(x_e, h, compliance, integration=integration, feed=feed).x
        arrived = settling(x, x_e[-1], ARRIVED, ARRIVED_TURN, h)
        rows.append(
            FeedRow(feeding, equilibrium.duration, arrived, worst_lag(x, equilibrium.pose, h, equilibrium.pieces))
        )
    if dosed is not None:
        rows.append(FeedRow(Feeding.DOSED, dosed.duration, dosed.arrived, dosed.lag))
    return tuple(rows)


def _beyond(allowed: Allowed) -> CannotDose | None:
    """Why no such lag is looked at, or None."""
    for what, unit, value, (least, most) in (
        ("", "m", allowed.lag, LAGS), ("turn ", "rad", allowed.turn_lag, TURN_LAGS)
    ):  # fmt: skip
        if value is not None and not least <= value <= most:
            return CannotDose(
                f"a {what}lag of at most {value:g} {unit} is too {'small' if value < least else 'large'} a bound; "
                f"give one between {least:g} {unit} and {most:.4g} {unit}"
            )
    return None


def _unfollowed(path: DosePath, laws: Sequence[AxisStability], h: float, integration: Integration) -> CannotDose | None:
    """Why the arm would not follow along an axis that the path uses, or not while anyone waits; or None."""
    for law, moves in zip(laws, moving_axes(path), strict=True):
        if not moves:
            continue
        if law.k == 0:
            return CannotDose(
                f"the path moves along {law.axis}, where the stiffness is 0: nothing pulls the arm after the "
                f"equilibrium (hand guiding); give {law.axis} a stiffness or a path without it"
            )
        if law.verdict is not StabilityVerdict.STABLE:
            return CannotDose(f"the path moves along {law.axis}, but {law.sentence}")
        most = h * (SLOWEST_SWING if law.damping_ratio < 1 else SLOWEST)
        if law.slowest > most:
            takes = f"takes {law.slowest:.3g} s to lose" if isfinite(law.slowest) else "practically never loses"
            change = "raise k or lower d"
            if law.damping_ratio < 1:
                change = "raise d or lower m" if integration is Integration.EXACT else "raise d, or lower m or h"
            return CannotDose(
                f"the path moves along {law.axis}, where the controller {takes} two thirds of a deviation "
                f"(k = {law.k:g}, d = {law.d:g}, m = {law.m:g}), more than the {most:g} s that dosing allows; "
                f"{change}"
            )
    return None


def _swinging(path: DosePath, compliance: Compliance, turns: bool) -> tuple[float, float] | None:
    """Of the bounded axes along the path that swing (d^2 < 4 k m): longest time constant [s], highest pulse [rad/s]."""
    K, D, M = compliance.K, compliance.D, compliance.M
    bounded = np.array(moving_axes(path)) & (np.arange(6) < (6 if turns else 3))
    swings = bounded & (D * D < 4 * K * M)
    if not np.any(swings):
        return None
    return float(np.max(2 * M[swings] / D[swings])), float(np.max(np.sqrt(K[swings] / M[swings])))


def _resting_time(moves: Sequence[bool] | NDArray[np.bool_], laws: Sequence[AxisStability], h: float) -> float:
    """Time [s] until the arm counts as at rest along the axes that move and come to rest at all."""
    slowest = (law.slowest for law, there in zip(laws, moves, strict=True) if there and isfinite(law.slowest))
    return _REST * min(max(slowest, default=h), SLOWEST * h)
