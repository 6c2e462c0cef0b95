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

from trajopt_cli.admittance.dose_bound import least_duration
from trajopt_cli.admittance.dose_path import DosePath
from trajopt_cli.admittance.dose_walk import State, Walk, moving_axes, stable
from trajopt_cli.admittance.lag import Lag, held, lag_of, settling, time_constants, worst_lag
from trajopt_cli.admittance.regulator import Coefficients, coefficients, response
from trajopt_cli.geometry import Array, readonly
from trajopt_cli.iiwa.equilibrium import Equilibrium, Piece
from trajopt_cli.iiwa.task import COORDINATES, UNITS, Compliance, Feed, Integration

ARRIVED = 1e-3
"""Distance [m] from the last pose at which the arm counts as arrived."""
_ROWS = 3_000_000  # rows at most: 50 min at 1 ms
_TOLERANCE = 1e-9  # relative excess over the bound that the final check forgives as rounding
_BLOCK, _LARGEST = 8, 256  # periods walked between two looks at safety
_HALVINGS = 12  # of the last eager step before an unsafe state
_REST = 10.0  # slowest time constants after which the arm counts as at rest


@dataclass(frozen=True)
class CannotDose:
    """There is no such sequence, or none worth having; message says why and what to change."""

    message: str


@dataclass(frozen=True, eq=False)
class Dosed:
    """A retimed sequence: pose (m, 6) every h [s] at path parameter s (m,), and the arm's predicted x (m, 6).

    pieces: its rows by leg. lag: the worst deviation, the coming to rest after the end included. arrived [s]: from when
    on the arm is within ARRIVED of the end, None when it takes longer than the simulation. least [s]: what no sequence
    with this bound can go below. braked: how many periods the equilibrium had to hold back for a later corner or end.
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

    A bound of any size above zero can be kept, since the equilibrium may stand; what a small one costs is time, and
    more than three million rows are refused. Raises ValueError for bounds or periods that are not above zero.
    """
    for name, value in (("h", h), ("bound", bound), ("turn_bound", 1.0 if turn_bound is None else turn_bound)):
        if not (isfinite(value) and value > 0):
            raise ValueError(f"{name} is {value:g}: wanted a finite number above zero")
    axes = coefficients(compliance.K, compliance.D, compliance.M, h, integration)
    refusal = _unfollowed(path, compliance, h, axes)
    if refusal is not None:
        return refusal
    least = least_duration(path, h, axes, bound)
    if least / h > _ROWS:
        return CannotDose(
            f"a lag of at most {bound:g} m would take at least {least:.0f} s, more than {_ROWS} rows of {h:g} s; "
            "allow more lag, or more stiffness or less damping"
        )
    walk = Walk(path, h, axes, bound, turn_bound)
    walked = _walk(walk)
    if isinstance(walked, CannotDose):
        return walked
    states, braked = walked
    s = np.array([walk.s(state) for state in states])
    pose = np.stack([np.interp(s, path.s, column) for column in path.pose.T], axis=1)
    rest = held(pose, _resting_time(path, compliance), h)
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
        arrived=settling(x, pose[-1], ARRIVED, h),
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
    """One way of feeding: duration of the sequence [s], when the arm arrived [s] (ARRIVED; None: not yet), its lag."""

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
    constants = time_constants(compliance)
    moves = np.any(equilibrium.pose != equilibrium.pose[0], axis=0) & np.isfinite(constants)
    x_e = held(equilibrium.pose, _REST * float(np.max(constants[moves], initial=h)), h)
    rows = []
    for feeding, feed in ((Feeding.UNDOSED, Feed.POSITION), (Feeding.VELOCITY, Feed.VELOCITY)):
        x = response(x_e, h, compliance, integration=integration, feed=feed).x
        arrived = settling(x, x_e[-1], ARRIVED, h)
        rows.append(FeedRow(feeding, equilibrium.duration, arrived, lag_of(x, equilibrium)))
    if dosed is not None:
        rows.append(FeedRow(Feeding.DOSED, dosed.duration, dosed.arrived, dosed.lag))
    return tuple(rows)


def _unfollowed(path: DosePath, compliance: Compliance, h: float, axes: Sequence[Coefficients]) -> CannotDose | None:
    """Why the arm would not follow along an axis that the path uses, or None."""
    for i, moves in enumerate(moving_axes(path)):
        if not moves:
            continue
        k, d, m = compliance.K[i], compliance.D[i], compliance.M[i]
        if k == 0:
            return CannotDose(
                f"the path moves along {COORDINATES[i]}, where the stiffness is 0: nothing pulls the arm after the "
                f"equilibrium (hand guiding); give {COORDINATES[i]} a stiffness or a path without it"
            )
        if not stable(axes[i]):
            return CannotDose(
                f"the controller does not come to rest along {COORDINATES[i]} with k = {k:g}, d = {d:g}, m = {m:g} and "
                f"h = {h:g} s ({UNITS[i]}); it needs h k < d and h d/m < 2 + h^2 k/(2 m)"
            )
    return None


def _walk(walk: Walk) -> tuple[list[State], int] | CannotDose:
    """All states from the first to the last row, and how many of them had to hold back.

    Blocks of eager steps are kept when they end safely. Otherwise the last safe one is looked up, its step halved down
    to the largest safe one, and lazy steps follow for as long as the first unsafe step would have lasted: that is how
    long the coming corner binds.
    """
    state = walk.start()
    states = [state]
    braked = 0
    block = _BLOCK
    while not walk.done(state):
        ahead = walk.run(state, block, 1.0)
        through = bool(ahead) and (len(ahead) == block or walk.done(ahead[-1]))
        if through and walk.unsafe_after(ahead[-1]) == inf:
            states += ahead
            block = min(2 * block, _LARGEST)
        else:
            ahead = ahead[: _last_safe(walk, ahead, known_bad=through)]
            states += ahead
            slow = _hold_back(walk, states[-1])
            states += slow
            braked += len(slow)
            block = _BLOCK
        state = states[-1]
        if len(states) > _ROWS:
            s = walk.path.s
            return CannotDose(
                f"after {_ROWS} rows the sequence is at {walk.s(state) / s[-1]:.0%} of its path; allow more lag, or "
                "more stiffness or less damping"
            )
    return states, braked


def _last_safe(walk: Walk, ahead: list[State], *, known_bad: bool) -> int:
    """How many of the states ahead of a safe one may be kept, so that the last of them is safe."""
    low, high = 0, len(ahead) + (0 if known_bad else 1)
    while high - low > 1:
        middle = (low + high) // 2
        if walk.unsafe_after(ahead[middle - 1]) == inf:
            low = middle
        else:
            high = middle
    return low


def _hold_back(walk: Walk, state: State) -> list[State]:
    """The largest safe step from a safe state whose eager step is not, and the lazy ones that have to follow."""
    low, high, binds = 0.0, 1.0, 1.0
    best = walk.run(state, 1, 0.0)
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        tried = walk.run(state, 1, middle)
        lasts = walk.unsafe_after(tried[0]) if tried else 0.0
        if lasts == inf:
            low, best = middle, tried
        else:
            high, binds = middle, lasts
    return best + walk.run(best[-1], int(binds), 0.0)


def _resting_time(path: DosePath, compliance: Compliance) -> float:
    constants = time_constants(compliance)[list(moving_axes(path))]
    return _REST * float(np.max(constants))


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
