"""Feeding the equilibrium gradually, so that the arm does not lag behind it by more than a bound.

The thesis' open wish. The path stays what it was; its timing becomes the fastest that keeps ||p_e - p|| <= bound at
every row: the equilibrium is as far ahead of the arm as the bound lets it. On one line that is the optimum, because
the law's answer to a deviation never takes anything back (see dose_walk for what makes it feasible at every corner).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from math import inf, isfinite

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.compliance.controller.dose_bound import least_duration
from trajopt_cli.compliance.controller.dose_path import DosePath, coarser
from trajopt_cli.compliance.controller.dose_plan import ROWS, plan
from trajopt_cli.compliance.controller.dose_walk import State, Walk, moving_axes
from trajopt_cli.compliance.controller.lag import Lag, held, lag_of, settling, worst_lag
from trajopt_cli.compliance.controller.regulator import coefficients, response
from trajopt_cli.compliance.controller.stability import AxisStability, Verdict, stability
from trajopt_cli.compliance.task.equilibrium import Equilibrium, Piece
from trajopt_cli.compliance.task.model import Compliance, Feed, Integration
from trajopt_cli.geometry import Array, readonly

ARRIVED = 1e-3
"""Distance [m] from the last pose at which the arm counts as arrived, where its angles are there too."""
ARRIVED_TURN = float(np.radians(0.1))
"""Norm [rad] of the angles' differences from the last pose at which the arm counts as arrived."""
SLOWEST = 100_000
"""Periods that the slowest axis on the path may take to lose two thirds of a deviation; more is refused at once."""
SLOWEST_SWING = 20_000
"""The same of an axis that swings meanwhile, which takes far more looking ahead."""
BOUNDS = (1e-6, 10.0)
"""Least and greatest bound [m] on the lag that is looked at."""
TURN_BOUNDS = (1e-6, 100.0)
"""The same of the angles [rad]."""
_TOLERANCE = 1e-9  # relative excess over the bound that the final check forgives as rounding
_COARSE = 0.05  # period of the search for brakes, in 1/pulse of the axis that swings fastest
_REST = 10.0  # slowest time constants after which the arm counts as at rest


@dataclass(frozen=True)
class CannotDose:
    """There is no such sequence, or none worth having; message says why and what to change."""

    message: str


@dataclass(frozen=True, eq=False)
class Dosed:
    """A retimed sequence: pose (m, 6) every h [s] at path parameter s (m,), and the arm's predicted x (m, 6).

    pieces: its rows by leg. lag: the worst deviation, the coming to rest after the end included. arrived [s]: from when
    on the arm is within ARRIVED and ARRIVED_TURN of the end, None when it takes longer than the simulation. least [s]:
    what no sequence with these bounds can go below. braked: how many periods the equilibrium had to hold back for a
    later corner or end.
    """

    h: float
    pose: Array
    s: Array
    x: Array
    pieces: tuple[Piece, ...]
    bound: float
    lag: Lag
    arrived: float | None
    least: float
    braked: int
    notes: tuple[str, ...]

    @property
    def duration(self) -> float:
        """Time of the last row [s]."""
        return (len(self.pose) - 1) * self.h

    @property
    def gap(self) -> float:
        """(duration - least) / least."""
        return (self.duration - self.least) / self.least


def dose(
    path: DosePath,
    compliance: Compliance,
    h: float,
    bound: float,
    *,
    turn_bound: float | None = None,
    integration: Integration = Integration.EULER,
) -> Dosed | CannotDose:
    """The fastest sequence along path whose lag stays within bound [m], and turn_bound [rad] where one is given.

    Any bound can be kept, since the equilibrium may stand; what a small one costs is time, and more than three million
    rows are refused, as are bounds beyond BOUNDS and TURN_BOUNDS and laws slower than SLOWEST or SLOWEST_SWING. Raises
    ValueError for bounds or periods that are not finite and above zero.
    """
    for name, value in (("h", h), ("bound", bound), ("turn_bound", 1.0 if turn_bound is None else turn_bound)):
        if not (isfinite(value) and value > 0):
            raise ValueError(f"{name} is {value:g}: wanted a finite number above zero")
    laws = stability(compliance, h, integration)
    refusal = _beyond(bound, turn_bound) or _unfollowed(path, laws, h, integration)
    if refusal is not None:
        return refusal
    axes = coefficients(compliance.K, compliance.D, compliance.M, h, integration)
    least = least_duration(path, h, axes, bound, turn_bound)
    if least / h > ROWS:
        allowed = f"{bound:g} m" if turn_bound is None else f"{bound:g} m and {turn_bound:g} rad"
        return CannotDose(
            f"a lag of at most {allowed} would take at least {least:.0f} s, more than {ROWS} rows of {h:g} s; "
            "allow more lag, or more stiffness or less damping"
        )
    walk = Walk(path, h, axes, bound, turn_bound)
    swinging = _swinging(path, compliance, turn_bound is not None)
    if swinging is None:
        states, braked = plan(walk, None, 0.0)
    else:
        longest, pulse = swinging
        longer = max(h, _COARSE / pulse)
        rough = coefficients(compliance.K, compliance.D, compliance.M, longer, Integration.EXACT)
        states, braked = plan(walk, Walk(coarser(path, longer), longer, rough, bound, turn_bound), longest)
    if not walk.done(states[-1]):
        share = walk.s(states[-1]) / path.s[-1]
        change = "allow more lag, or more stiffness or less damping"
        if swinging is not None:
            change = "allow more lag, or more damping, so that the arm swings less"
        return CannotDose(
            f"given up after {len(states)} rows and {walk.looked} periods of looking ahead, at {share:.0%} of the "
            f"path; {change}"
        )
    s = np.array([walk.s(state) for state in states])
    pose = np.stack([np.interp(s, path.s, column) for column in path.pose.T], axis=1)
    rest = held(pose, _resting_time(moving_axes(path), laws, h), h)
    x = response(rest, h, compliance, integration=integration).x
    pieces = _pieces(path, states, h)
    lag = worst_lag(x, pose, h, pieces)
    if lag.maximum > bound * (1 + _TOLERANCE) or lag.turn_maximum > (turn_bound or inf) * (1 + _TOLERANCE):
        return CannotDose(f"a lag of {bound:g} m is too small for the rounding of positions; allow more")
    notes = []
    if braked:
        notes.append(f"the equilibrium holds back for {braked * h:.3f} s, so that the arm does not overshoot by more")
    return Dosed(
        h=h,
        pose=readonly(pose),
        s=readonly(s),
        x=readonly(x[: len(pose)]),
        pieces=pieces,
        bound=bound,
        lag=lag,
        arrived=settling(x, pose[-1], ARRIVED, ARRIVED_TURN, h),
        least=least,
        braked=braked,
        notes=tuple(notes),
    )


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
        rows.append(FeedRow(feeding, equilibrium.duration, arrived, lag_of(x, equilibrium)))
    if dosed is not None:
        rows.append(FeedRow(Feeding.DOSED, dosed.duration, dosed.arrived, dosed.lag))
    return tuple(rows)


def _beyond(bound: float, turn_bound: float | None) -> CannotDose | None:
    """Why no such bound is looked at, or None."""
    for what, unit, value, (least, most) in (("", "m", bound, BOUNDS), ("turn ", "rad", turn_bound, TURN_BOUNDS)):
        if value is not None and not least <= value <= most:
            return CannotDose(
                f"a {what}lag of at most {value:g} {unit} is {'too small' if value < least else 'too large'} a bound; "
                f"give one between {least:g} {unit} and {most:g} {unit}"
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
        if law.verdict is not Verdict.STABLE:
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


def _pieces(path: DosePath, states: Sequence[State], h: float) -> tuple[Piece, ...]:
    """The rows of every leg."""
    stretch = np.array([state.stretch for state in states])
    arrivals = np.searchsorted(stretch, np.arange(len(path.s)))  # first row at or past each path row
    out: list[Piece] = []
    row = 0
    for leg in path.legs:
        last = row + round(leg.dwell / h) if leg.dwell else int(arrivals[leg.last])
        out.append(Piece(row, last, leg.origin, leg.goal, dwell=leg.dwell > 0))
        row = last
    return tuple(out)
