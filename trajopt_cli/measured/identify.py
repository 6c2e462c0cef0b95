"""The limits that logs show: levels at which different motions of an axis agree, and that none goes beyond.

An axis rides along with others in most motions, so its own speed says little: it is at its limit where several motions
of different shape have the same top, and no other axis in them is at its own. A speed far below the one in force is
taken for a programmed one. Jerks are taken from motions of one axis alone.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from trajopt_cli.geometry import Array, BoolArray
from trajopt_cli.limits import JointLimits
from trajopt_cli.measured.fit import Fitted, clock_jitter, fit, guesses, logs, without_jerk
from trajopt_cli.measured.motions import Recorded, motions_of
from trajopt_cli.measured.profile import GROWS, boxes
from trajopt_cli.trajectory import Trajectory

_ROUGH = 3e-3  # of the way: what is left of a motion that is one ramp up and one down is less
_MOVES = 30.0  # times the noise: a shorter way is none
_COORDINATED = 0.01  # of the way: how far axes may part from one common progress
_FIRST_JITTER = 3e-4  # s
_ENOUGH = 40  # motions of one leading axis that are looked at
_THIN = 120  # rows of a motion that is looked at alone, before all of them are
_MOST = 20  # motions of one leading axis that are fitted at once
_ROWS = 8  # of a motion, the rests around it included
_QUICK = (0.015, 0.1)  # a lag to begin from, mean delay [s] and shape
_FEWEST = 3  # motions that make a level
_DIFFERENT = 0.1  # of the larger way: motions of another shape
_PLATEAU = 0.03  # of the time to go the way at top speed: a shorter cruise is none
_CERTAIN = 50.0  # of a likelihood ratio for jerk phases, in units of chi square
_SEEN = 0.25  # of the log's period: a shorter jerk phase passes between two rows
_PROGRAMMED = 0.5  # of the speed in force: a lower level may be a programmed one
_SURE = {"speed": 0.01, "acceleration": 0.06, "jerk": 0.5}  # standard deviation of one motion that counts
_FLOOR = {"speed": 2e-4, "acceleration": 3e-3, "jerk": 1e-2}  # what no interval is narrower than, half: accelerations
# of rows every millisecond without noise came out 0.33 % high
_WIDE = {"speed": 0.03, "acceleration": 0.15, "jerk": 0.6}  # half a 90 % interval: a wider one says too little
# Standard deviations for 90 %: 1.645 for a model that is right; these are what runs with other seeds than those of
# bench_identify asked for.
_QUANTILE = {"speed": 2.7, "acceleration": 2.8, "jerk": 3.3}


class Kind(StrEnum):
    """What is limited."""

    SPEED = "speed"
    ACCELERATION = "acceleration"
    JERK = "jerk"


_UNSEEN = {
    Kind.SPEED: "no motion in which its speed stays at its top",
    Kind.ACCELERATION: "no motion in which its acceleration stays at its top long enough to be seen",
    Kind.JERK: "its acceleration changes faster than this log can show, or not evenly",
}
_RIDES = "where it is fastest another axis may be what limits it"


@dataclass(frozen=True)
class Limit:
    """One limit of one axis [SI]. value, low, high: None where the logs do not show it, and why. motions: how many show
    it. most: the highest that was seen, None where nothing was."""

    axis: str
    kind: Kind
    value: float | None = None
    low: float | None = None
    high: float | None = None
    motions: int = 0
    why: str = ""
    most: float | None = None


@dataclass(frozen=True, eq=False)
class _Motion:
    """A fitted motion: way (k,), 0 for axes that rest, and how far it is off, as a share of it; value (3,), logarithms
    of speed, acceleration and jerk of its progress, and its place in the covariances of its group. cruise, constant,
    changing: whether speed and acceleration stay at their top, and a change of acceleration takes rows enough."""

    way: Array
    off: Array
    value: Array
    group: int
    place: int
    cruise: bool
    constant: bool
    changing: bool


@dataclass(frozen=True)
class Seen:
    """What became of a log's motions. period [s]: median; jitter [s]: of the clock; lags [s]: by axis name."""

    rows: int
    seconds: float
    period: float
    motions: int
    fitted: int
    not_straight: int
    not_ramps: int
    not_looked_at: int
    jitter: float
    lags: dict[str, float]


def identify(logs_read: Sequence[Trajectory], limits: JointLimits) -> tuple[list[Limit], list[Seen]]:
    """Speed, acceleration and jerk of every axis as the logs show them, with 90 % intervals.

    logs_read: positions over time, axes in the order of limits. limits: those in force, to tell a programmed speed.
    """
    found: list[_Motion] = []
    covs: list[Array] = []
    seen: list[Seen] = []
    for one in logs_read:
        seen.append(_of_log(one, found, covs))
    out = []
    for k, axis in enumerate(limits.names):
        for n, kind in enumerate(Kind):
            nominal = float(limits.velocity[k]) if kind is Kind.SPEED else None
            out.append(_level(axis, kind, n, k, found, covs, nominal))
    return out, seen


@dataclass(eq=False)
class _Batch:
    """Motions that one axis leads, with the local parameters and the lag that are known of them so far."""

    axis: int
    motions: list[Recorded]
    local: list[Array]
    lag: tuple[float, float]

    def fitted(self, noise: Array, jitter: float) -> Fitted:
        """A better fit, from which the next one begins."""
        found = fit(self.motions, self.axis, float(noise[self.axis]), jitter, self.local, self.lag)
        self.local, self.lag = list(found.local), found.lag
        return found

    def weighed(self, noise: Array, jitter: float) -> tuple[Fitted, bool]:
        """The better of a fit and one that begins without jerk phases, and whether jumping accelerations, with another
        lag, could not have been it."""
        own, first = float(noise[self.axis]), self.fitted(noise, jitter)  # the same weights for all that are compared
        without = list(without_jerk(first.local))
        tried = [fit(self.motions, self.axis, own, jitter, without, lag, jumps=True) for lag in (first.lag, _QUICK)]
        jumping = min(tried, key=lambda one: one.cost)
        best = first
        if jumping.cost < first.cost:
            again = fit(self.motions, self.axis, own, jitter, list(jumping.local), jumping.lag)
            best = min(again, jumping, key=lambda one: one.cost)
        return best, jumping.cost - best.cost > _CERTAIN * best.wider


def _of_log(log: Trajectory, found: list[_Motion], covs: list[Array]) -> Seen:
    t, q, period = log.t, log.q, float(np.median(np.diff(log.t)))
    motions, noise, _ = motions_of(t, q)
    batches, bent, wild = _batches(motions, noise)
    jitter = _FIRST_JITTER
    for _ in range(2):
        fits = [batch.fitted(noise, jitter) for batch in batches]
        jitter = clock_jitter(fits, [noise[batch.axis] for batch in batches]) if fits else 0.0
    for batch in batches:
        result, jerks = batch.weighed(noise, jitter)
        value, cov = logs(result.phases, result.cov)
        for i, one in enumerate(batch.motions):
            way = np.where(np.abs(one.way) > _MOVES * noise, np.abs(one.way), 0.0)
            way[batch.axis] = abs(result.local[i, 5])
            off = np.where(way > 0, noise / np.where(way > 0, way, 1.0), 0.0)
            off[batch.axis] = 0.0
            x, y, z = result.phases[i]
            # a jerk phase too short to be seen trades with y and z, not with T1 and T2
            here = result.cov[3 * i : 3 * i + 3, 3 * i : 3 * i + 3]
            apart, longer = (float(np.sqrt(max(c @ here @ c, 0.0))) for c in (GROWS[0] - GROWS[1], GROWS[1]))
            T1, T2, _ = boxes(result.phases[i])
            sure = z > max(3 * apart, _PLATEAU * T1), y > max(3 * longer, 3 * _PLATEAU * T2)
            found.append(_Motion(way, off, value[:, i], len(covs), i, *sure, jerks and bool(x > _SEEN * period)))
        covs.append(cov)
    return Seen(
        rows=len(t), seconds=log.duration, period=period, motions=len(motions),
        fitted=sum(len(batch.motions) for batch in batches), not_straight=bent, not_ramps=wild,
        not_looked_at=len(motions) - sum(len(batch.motions) for batch in batches) - bent - wild, jitter=jitter,
        lags={log.names[batch.axis]: batch.lag[0] for batch in batches},
    )  # fmt: skip


def _batches(motions: Sequence[Recorded], noise: Array) -> tuple[list[_Batch], int, int]:
    """The motions that can be fitted, by the axis that leads; how many are not straight, and how many no ramps."""
    leads: dict[int, list[Recorded]] = {}
    for one in motions:
        leads.setdefault(int(np.argmax(np.abs(one.way) / noise)), []).append(one)
    groups: dict[int, list[tuple[Recorded, Fitted]]] = {}
    bent = wild = 0
    for axis, one in [(k, one) for k, led in leads.items() for one in _some(led, k)]:
        few = one.thinned(_THIN)
        tried = []
        if abs(one.way[axis]) > _MOVES * noise[axis] and len(one.t) >= _ROWS:
            tried = [fit([few], axis, noise[axis], _FIRST_JITTER, [guess]) for guess in guesses(few, axis)]
        best = min(tried, key=lambda single: single.cost, default=None)
        if best is None or best.rough[0] > _ROUGH:
            wild += 1
        elif not _straight(few, axis, best, noise):
            bent += 1
        else:
            groups.setdefault(axis, []).append((one, best))
    out = []
    for axis, some in groups.items():
        parts = -(-len(some) // _MOST)
        for part in (some[i::parts] for i in range(parts)):
            b1, beta = np.median([best.lag for _, best in part], axis=0)
            lag = (float(b1), float(beta))
            out.append(_Batch(axis, [one for one, _ in part], [best.local[0] for _, best in part], lag))
    return out, bent, wild


def _some(motions: list[Recorded], axis: int) -> list[Recorded]:
    """All of the motions, or enough of a long log: of all lengths."""
    if len(motions) <= _ENOUGH:
        return motions
    by_length = sorted(motions, key=lambda one: abs(float(one.way[axis])))
    return [by_length[i] for i in np.linspace(0, len(motions) - 1, _ENOUGH).astype(int)]


def _straight(one: Recorded, axis: int, single: Fitted, noise: Array) -> bool:
    """Whether all axes share the progress of the leading one, each behind its own lag."""
    d = single.local[0, 5]
    s = (one.q[:, axis] - single.local[0, 4]) / d
    rate = single.rate[0] / d
    basis = np.column_stack([np.ones(len(s)), s, rate])
    for k, column in enumerate(one.q.T):
        if k == axis:
            continue
        part = np.linalg.lstsq(basis, column, rcond=None)[0]
        off = float(np.sqrt(np.mean((column - basis @ part) ** 2)))
        if off > max(4 * noise[k], _COORDINATED * abs(part[1])) + 0.3 * abs(part[1]) * 1e-3:
            return False
    return True


def _level(
    axis: str, kind: Kind, n: int, k: int, found: Sequence[_Motion], covs: Sequence[Array], nominal: float | None
) -> Limit:
    """The level of one axis, or why there is none."""
    slow = "no full-speed motion: " if kind is Kind.SPEED else ""
    every = [one for one in found if one.way[k] > 0]
    if not every:
        return Limit(axis, kind, why="it does not move in a motion that could be fitted")
    spread = {id(one): float(np.sqrt(max(covs[one.group][n][one.place, one.place], 0.0))) for one in found}
    if kind is Kind.JERK:
        every = [one for one in every if np.all(np.delete(one.way, k) <= 0)]
        if len(every) < _FEWEST:
            return Limit(axis, kind, why=f"{_count(len(every))} of this axis alone; at least {_FEWEST} are needed")
    can = [one for one in every if _reached(one, kind) and spread[id(one)] < _SURE[kind]]
    if not can:
        return Limit(axis, kind, why=_UNSEEN[kind])
    r = np.array([np.log(one.way[k]) + one.value[n] for one in can])
    s = np.array([np.hypot(spread[id(one)], one.off[k]) for one in can])
    most = float(np.exp(r.max()))
    members = _cluster(r, s, kind)
    count = 1 if members is None else int(members.sum())
    if members is None or count < _FEWEST:
        why = f"{_count(count)} at the highest of those that can tell; {_FEWEST} that agree are needed"
        return Limit(axis, kind, why=slow + why, most=most)
    inside = [one for one, member in zip(can, members, strict=True) if member]
    own = inside if kind is Kind.JERK else [one for one in inside if _alone_at_top(one, k, n, kind, found, spread)]
    if not _differ([one.way for one in own]):
        why = "all that agree are one move again; moves of other lengths are needed"
        return Limit(axis, kind, why=slow + (why if own else _RIDES), most=most)
    mean, sigma = _combined(inside, r[members], n, k, covs)
    half = _QUANTILE[kind] * sigma + _FLOOR[kind]
    value, why = float(np.exp(mean)), ""
    if half > _WIDE[kind]:
        why = f"the interval would be ±{100 * half:.0f} %"
    elif nominal is not None and value < _PROGRAMMED * nominal:
        share = f"{100 * value / nominal:.0f} % of the speed in force"
        why = f"{slow}its motions agree at {share}, as programmed speeds do"
    if why:
        return Limit(axis, kind, why=why, most=most, motions=len(inside))
    # a jerk's is even in its inverse, the time the acceleration takes to change
    low, high = (1 / (1 + half), 1 / (1 - half)) if kind is Kind.JERK else (float(np.exp(-half)), float(np.exp(half)))
    return Limit(axis, kind, value, value * low, value * high, len(inside), most=most)


def _count(n: int) -> str:
    return f"{n or 'no'} motion{'' if n == 1 else 's'}"


def _reached(one: _Motion, kind: Kind) -> bool:
    return {Kind.SPEED: one.cruise, Kind.ACCELERATION: one.constant, Kind.JERK: one.changing}[kind]


def _cluster(r: Array, s: Array, kind: Kind) -> BoolArray | None:
    """The motions that agree at the top; None where one is beyond all that agree."""
    own = 2 * _FLOOR[kind]
    for top in np.argsort(-r):
        near = np.abs(r - r[top]) <= 3 * np.hypot(s, s[top]) + own
        weight = 1 / (s[near] ** 2 + own**2)
        mean = float(weight @ r[near] / weight.sum())
        members = np.abs(r - mean) <= 3 * s + 2 * own
        beyond = r - mean > 3 * s + 2 * own
        if beyond.any():
            return None
        if members.sum() >= _FEWEST:
            return np.asarray(members)
    return None


def _alone_at_top(one: _Motion, k: int, n: int, kind: Kind, found: Sequence[_Motion], spread: dict[int, float]) -> bool:
    """Whether no other axis is at the highest that it was ever seen at in this motion."""
    for j in np.flatnonzero(one.way):
        if j == k:
            continue
        others = [m for m in found if m.way[j] > 0 and _reached(m, kind) and spread[id(m)] < _SURE[kind]]
        top = max((np.log(m.way[j]) + m.value[n] for m in others), default=-np.inf)
        if np.log(one.way[j]) + one.value[n] > top - 3 * spread[id(one)] - 0.02:
            return False
    return True


def _differ(ways: Sequence[Array]) -> bool:
    """Whether two of them are of another shape or length."""
    return any(
        bool(np.any(np.abs(one - other) > _DIFFERENT * np.maximum(one, other).max()))
        for i, one in enumerate(ways)
        for other in ways[:i]
    )


def _combined(inside: Sequence[_Motion], r: Array, n: int, k: int, covs: Sequence[Array]) -> tuple[float, float]:
    """Mean of the motions and its standard deviation: that of a common lag does not fall with their number."""
    m = len(inside)
    C = np.zeros((m, m))
    for i, one in enumerate(inside):
        for j, other in enumerate(inside):
            if one.group == other.group:
                C[i, j] = covs[one.group][n][one.place, other.place]
    C += np.diag([one.off[k] ** 2 for one in inside])
    own: Array = np.diag(C)
    weight: Array = 1 / np.maximum(own, 1e-14)
    weight /= weight.sum()
    mean = float(weight @ r)
    chi = float(np.sum((r - mean) ** 2 / np.maximum(own, 1e-14))) / (m - 1)
    own_variance = float(weight @ C @ weight)
    return mean, float(np.sqrt(max(own_variance, 0.0) * max(chi, 1.0)))
