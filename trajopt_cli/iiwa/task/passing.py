"""Poses that are passed without a stop: from one stop to the next on a rounded curve, under every cap of the profile.

The caps of acceleration and jerk are shared between going along the curve and being turned by it, by bounds that hold
wherever the mean of the speed law looks; the rows' own divided differences are what is checked in the end.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.angles import angles_of, rotation_vector
from trajopt_cli.iiwa.task.joint_checks import ArmOnPath, Untimed
from trajopt_cli.iiwa.task.legs import MOST_ROWS
from trajopt_cli.iiwa.task.model import CAPS, Passing
from trajopt_cli.iiwa.task.rounded import Polyline, Rounded, deviations, rounded
from trajopt_cli.timing.varying_caps import Rows, least_time, least_within, rest_to_rest

_BINDING = (*CAPS, "joint speed", "joint acceleration")
ALLOWED = 1e-6
"""Relative: divided differences of the rows may exceed a cap by this, besides what rounding of coordinates makes."""

_ROUNDING = 4.5e-16  # of the largest coordinate: what one row's may be off
_ACROSS, _TURNED = 0.8, 0.7  # shares of acceleration and of jerk that the curve itself may take at its speed
_SLOW = 1.3  # times the least time: a way that takes longer is driven with shorter means, too
_WORSE = 2  # of them in a row that are slower: enough
_TIMES = 30  # that caps are lowered where rows break one,
_LOCAL = 10  # so often of them only around there


@dataclass(frozen=True, eq=False)
class Passage:
    """Rows (m, 6) every h from one stop to the next, with R (m, 3, 3) where turns are about one axis each.

    tops (6,): the greatest divided differences of the rows, in the order of CAPS. away [m], turned [rad]: how far the
    rows are from the chain, and its poses from the curve, at most. binds: the cap that is nearest for most of the time.
    q (m, 7) [rad]: the joints, of an arm that is to follow.
    """

    pose: Array
    R: Array | None
    tops: Array
    away: float
    turned: float
    binds: str
    q: Array | None


def passage(
    chain: Polyline, caps: Array, passing: Passing, h: float, place: str, arm: ArmOnPath | None = None, name: str = ""
) -> Passage:
    """The way along a chain of poses, from rest to rest. caps (n, 6): of each leg in the order of CAPS, inf where the
    profile does not ask. place: of the chain, for messages. arm: whose joints keep their speeds and accelerations, too;
    name: of the chain, for what it cannot follow.

    Raises InputError for a tolerance that is lost in rounding, and for more than MOST_ROWS rows; Untimed for what the
    arm cannot follow at any speed.
    """
    used = _used(chain, caps)
    try:
        curve = rounded(chain, _spacing(used), passing.tolerance, passing.turn_tolerance)
    except ValueError as error:
        raise InputError(f"passing: {error}; give a larger one", file=place) from error
    grid = _grid(curve, h)
    limits = _limits(curve, chain, used, grid)
    if arm is not None:
        q = arm.joints(*curve.poses(grid), name)
        top, limits.rows = arm.on(q, grid)
        limits.top = np.minimum(limits.top, top)
    mean = max(1, ceil(limits.lasting / h - 1e-9))
    periods = least_time(grid, limits.top, limits.push(mean * h), limits.rows) / h
    if periods > MOST_ROWS:
        if arm is not None:
            raise Untimed(arm.fastest(q, name))
        message = f"passing takes {periods:.3g} periods of {h:g} s at the corners' speeds, at most {MOST_ROWS:.3g}"
        raise InputError(f"{message}; give a larger tolerance, higher caps or a longer period", file=place)
    drive = _Drive(curve, chain, caps, limits, grid, h, arm, name)
    found = drive.within(mean)
    if found is None or len(found.pose) > max(_SLOW * chain.at[-1] / h, chain.at[-1] / h + 2 * mean):
        # ramps too short for the acceleration to build up: less of it builds up sooner
        worse = 0
        for shorter in _shorter(mean):
            other = drive.within(shorter)
            if other is not None and (found is None or len(other.pose) < len(found.pose)):
                found, worse = other, 0
            elif found is not None:
                worse += 1
            if worse == _WORSE:
                break
    if found is None and arm is not None:
        raise Untimed(arm.fastest(q, name))
    if found is None:
        raise InputError("passing: the caps cannot be kept along these poses; give lower speeds", file=place)
    return found


@dataclass(frozen=True, eq=False)
class _Drive:
    """A curve along a chain, to be driven within its limits between places of a grid (n + 1,)."""

    curve: Rounded
    chain: Polyline
    caps: Array
    limits: _Limits
    grid: Array
    h: float
    arm: ArmOnPath | None
    name: str

    def within(self, mean: int) -> Passage | None:
        """The way whose acceleration takes so many periods to build up, lowered where its rows break a cap; None where
        no lowering helps, or the mean lasts longer than the way."""
        chain, grid, h, arm = self.chain, self.grid, self.h, self.arm
        top, push, rows = self.limits.top, self.limits.push(mean * h), self.limits.rows
        for k in range(_TIMES):
            at = rest_to_rest(grid, top, push, h, mean, rows)
            if at is None:
                return None
            pose, R = self.curve.poses(at)
            pose[0], pose[-1] = chain.pose[0], chain.pose[-1]
            if R is not None:
                assert chain.R is not None
                R[0], R[-1] = chain.R[0], chain.R[-1]
            differences = divided_differences(pose, R, h)
            shares = _shares(differences, at, chain, self.caps, h, np.abs(pose[:, :3]).max())
            q = None
            if arm is not None:
                if len(pose) < 4:
                    return None
                q = arm.joints(pose, R, self.name)
                shares += zip((1, 2), arm.shares(q, h), strict=True)
            worst = _worst(shares, len(at))
            if worst.max() <= 1 + ALLOWED:
                if R is not None:
                    pose[:, 3:] = angles_of(R)
                pairs = zip(*(deviations(self.curve, chain, t) for t in (at, chain.at)), strict=True)
                away, turned = (max(float(a.max()), float(b.max())) for a, b in pairs)
                tops = np.array([one.max(initial=0.0) for one in differences])
                return Passage(pose, R, tops, away, turned, _binding(shares, len(pose)), q)
            # what is left after a while wanders about with every change: all of the way a little slower ends it
            by = _slower(grid, at, worst, mean) if k < _LOCAL else np.full(len(top), worst.max() * (1 + 1e-4))
            top, push = top / by, push / by**2
            if rows is not None:
                slopes, bends = (part * by[:, None] ** 2 for part in rows)
                rows = slopes, bends
        return None


def _shorter(mean: int) -> list[int]:
    """Shorter means, each about the root of a half of the one before."""
    means = [max(1, round(mean * 2 ** (-k / 2))) for k in range(1, 2 * mean.bit_length() + 1)]
    return [one for one in dict.fromkeys(means) if one < mean]


def divided_differences(pose: Array, R: Array | None, h: float) -> list[Array]:
    """Sizes of the first three divided differences of rows (m, 6): of the position and of the turn by turns, so
    (m-1,), (m-1,), (m-2,), (m-2,), (m-3,), (m-3,). Turns are those of R (m, 3, 3) where it is given, else angles."""
    ways = np.diff(pose[:, :3], axis=0)
    turns = np.diff(pose[:, 3:], axis=0) if R is None else rotation_vector(np.swapaxes(R[:-1], -1, -2) @ R[1:])
    out = []
    for order in range(3):
        out += [np.linalg.norm(np.diff(part, order, axis=0), axis=1) / h ** (order + 1) for part in (ways, turns)]
    return out


def _used(chain: Polyline, caps: Array) -> Array:
    """The caps (n, 6), without those of a part that nowhere moves."""
    out = caps.copy()
    if not np.any(chain.pose[1:, :3] != chain.pose[:-1, :3]):
        out[:, 0::2] = np.inf
    if not np.any(chain.turns):
        out[:, 1::2] = np.inf
    return out


def _spacing(used: Array) -> float:
    """Between knots [s], beyond which even a turn back is taken at full speed."""
    out = 0.0
    for part in (used[:, 0::2], used[:, 1::2]):
        held = np.isfinite(part[:, 1])
        v, a, jerk = part[held].T
        out = max(out, float((2 * v / a).max(initial=0.0)), float(np.sqrt(2 * v / jerk).max(initial=0.0)))
    return out


def _grid(curve: Rounded, h: float) -> Array:
    """Places between which the caps are taken as constant: the knots, and a period apart."""
    size = np.diff(curve.knots)
    parts = np.maximum(1, np.ceil(size / h)).astype(np.intp)
    first = np.repeat(np.cumsum(parts) - parts, parts)
    share = (np.arange(parts.sum()) - first) / np.repeat(parts, parts)
    inner = np.repeat(curve.knots[:-1], parts) + share * np.repeat(size, parts)
    return np.append(inner, curve.knots[-1])


@dataclass(eq=False)
class _Limits:
    """What the curve leaves between places of the grid: top (n,), the greatest rate, and of both parts the sizes of the
    first three derivatives with their caps of acceleration and jerk. lasting [s]: what acceleration takes to build up.
    rows: of the joints' accelerations, where an arm is to follow.
    """

    top: Array
    parts: list[tuple[Array, Array, Array, Array, Array]]
    lasting: float
    rows: Rows | None = None

    def push(self, mean: float) -> Array:
        """The greatest change of rate (n,) where it takes so long [s] to build up."""
        out = np.full(len(self.top), np.inf)
        for first, second, third, a, jerk in self.parts:
            with np.errstate(divide="ignore", invalid="ignore"):
                out = np.fmin(out, np.sqrt(a**2 - (second * self.top**2) ** 2) / first)
                out = np.fmin(out, (jerk - third * self.top**3) / (first / mean + 3 * second * self.top))
        return out


def _limits(curve: Rounded, chain: Polyline, used: Array, grid: Array) -> _Limits:
    """What curve and caps leave."""
    span = np.clip(np.searchsorted(curve.knots, grid, side="right") - 1, 0, len(curve.knots) - 2)
    u = (grid - curve.knots[span])[:, None]
    rate = curve.rates[span] + u * (curve.bends[span] + u * curve.jolts[span] / 2)
    bend = curve.bends[span] + u * curve.jolts[span]
    leg = np.clip(np.searchsorted(chain.at, grid, side="right") - 1, 0, len(used) - 1)
    values = np.minimum(used[leg[:-1]], used[leg[1:]])
    # the acceleration of a ramp builds up to its cap, or until half of the speed is there
    parts_used = [part.T for part in (used[:, 0::2], used[:, 1::2]) if np.isfinite(part[0, 2])]
    lasting = [float(np.minimum(a / jerk, np.sqrt(v / jerk)).max()) for v, a, jerk in parts_used]
    top = np.full(len(grid) - 1, np.inf)
    parts = []
    for k, columns in enumerate((slice(0, 3), slice(3, 6))):
        sizes = (np.linalg.norm(x[:, columns], axis=1) for x in (rate, bend))
        first, second = (np.maximum(size[:-1], size[1:]) for size in sizes)
        third = np.linalg.norm(curve.jolts[span[:-1]][:, columns], axis=1)
        v, a, jerk = values[:, k::2].T
        parts.append((first, second, third, a, jerk))
        with np.errstate(divide="ignore", invalid="ignore"):
            for cap in (v / first, np.sqrt(_ACROSS * a / second), np.cbrt(_TURNED * jerk / third)):
                top = np.fmin(top, cap)
    return _Limits(top, parts, max(lasting, default=0.0))


_Shares = list[tuple[int, Array]]


def _shares(differences: list[Array], at: Array, chain: Polyline, caps: Array, h: float, size: float) -> _Shares:
    """Each difference with its order, as a share of its cap; rounding of coordinates of this size taken off."""
    out = []
    for k, found in enumerate(differences):
        order = k // 2 + 1
        # a difference looks at rows on both sides: the legs of its own middle
        middle = at[order // 2 : order // 2 + len(found)]
        leg = np.clip(np.searchsorted(chain.at, middle, side="right") - 1, 0, len(caps) - 1)
        noise = 2**order * _ROUNDING * max(1.0, size) / h**order
        out.append((order, np.maximum(found - noise, 0.0) / caps[leg, k]))
    return out


def _worst(rates: _Shares, count: int) -> Array:
    """The factor (count,) of time by which each row is too fast."""
    worst = np.zeros(count)
    for order, share in rates:
        slow = share ** (1 / order)
        for shift in range(order + 1):
            part = worst[shift : shift + len(slow)]
            np.maximum(part, slow, out=part)
    return worst


def _slower(grid: Array, at: Array, worst: Array, mean: int) -> Array:
    """By what (n,) rates are to be lowered where rows break a cap, as far around as the mean looks."""
    factor = np.maximum(worst, 1.0)
    factor = np.where(factor > 1, 1.002 * factor, 1.0)
    wide = -least_within(-factor, 2 * mean + 2)
    row = np.clip(np.searchsorted(at, grid[:-1], side="right") - 1, 0, len(at) - 1)
    return np.asarray(wide[row])


def _binding(rates: _Shares, count: int) -> str:
    """The cap that is nearest at most rows."""
    table = np.zeros((len(rates), count))
    for k, (_, share) in enumerate(rates):
        table[k, : len(share)] = share
    return _BINDING[int(np.bincount(np.argmax(table, axis=0)).argmax())]
