"""A curve that passes a chain of poses near, within a tolerance: a cubic B-spline whose control poses lie on the chain.

On a straight part of the chain the curve is that part; elsewhere the knots are as far apart as the tolerance allows, so
it is bent as little as it may be. Its first two derivatives are continuous, the third one is constant between knots.
Turns are rounded alike: as angles, or as products of turns about one axis each (slerp).

The parameter is a time: what each leg of the chain takes at its caps of speed.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray, rotations_by
from trajopt_cli.iiwa.task.angles import rotation_vector

_FEWEST = 4  # spans, so that ends can be mirrored
_HALVED = 40  # times: beyond it rounding is all that is left
_MOST = 10_000_000  # knots: 2,000,000 sharp corners have them
_SLACK = 0.98  # of the tolerance at the places that are looked at, the rest for what lies between them
_ROWS = 65536  # that are looked at at once


@dataclass(frozen=True, eq=False)
class Polyline:
    """Poses (n, 6) that are joined by straight legs; at (n,) [s]: when each is met at the caps of speed, from 0.

    R (n, 3, 3): the orientations where turns are about one axis each (slerp), None where the three angles are straight.
    """

    at: Array
    pose: Array
    R: Array | None = None

    @cached_property
    def turns(self) -> Array:
        """Of every leg (n-1, 3) [rad]: differences of angles, or rotation vectors in the tool's own frame."""
        return _turns(self.R) if self.R is not None else np.diff(self.pose[:, 3:], axis=0)

    def along(self, at: Array) -> tuple[Array, Array | None]:
        """Poses (m, 6) on the legs at times (m,), and orientations (m, 3, 3) where turns are about one axis."""
        leg = np.clip(np.searchsorted(self.at, at, side="right") - 1, 0, len(self.at) - 2)
        share = ((at - self.at[leg]) / (self.at[leg + 1] - self.at[leg]))[:, None]
        pose = self.pose[leg] + share * (self.pose[leg + 1] - self.pose[leg])
        if self.R is None:
            return pose, None
        return pose, self.R[leg] @ rotations_by(share * self.turns[leg])


@dataclass(frozen=True, eq=False)
class Rounded:
    """The curve of knots (k+1,) [s], four spans at least, over a chain; it begins and ends as the chain does, unbent.

    rates, bends (k+1, 6): first and second derivatives at the knots, jolts (k, 6): the third ones between them;
    position, then angles or, where turns are about one axis each, the turning in the tool's own frame, to first order
    of what a span turns.
    """

    knots: Array
    rates: Array
    bends: Array
    jolts: Array
    _base: Array
    _spans: Array
    _places: Array
    _steps: Array
    _R: Array | None

    @classmethod
    def over(cls, chain: Polyline, knots: Array) -> Rounded:
        """The curve with these knots."""
        # three more knots at either end, mirrored: so are the control poses, and the ends stay where they are
        t = np.concatenate([2 * knots[0] - knots[3:0:-1], knots, 2 * knots[-1] - knots[-2:-5:-1]])
        places = (t[1:-3] + t[2:-2] + t[3:-1]) / 3  # of the control poses whose middle knots are -1 to k
        inner = places[1:-1].copy()
        inner[0], inner[-1] = knots[0], knots[-1]
        pose, R = chain.along(inner)
        turns = np.diff(pose[:, 3:], axis=0) if R is None else _turns(R)
        steps = np.hstack([np.diff(pose[:, :3], axis=0), turns])
        steps = np.concatenate([steps[:1], steps, steps[-1:]])
        span = np.diff(t)
        before, after = span[2:-3, None], span[3:-2, None]  # of each knot
        slope = steps / np.diff(places)[:, None]
        rates = (slope[:-1] * after + slope[1:] * before) / (before + after)
        bends = 2 * (slope[1:] - slope[:-1]) / (before + after)
        back = after**2 / ((before + after) * (span[1:-4, None] + before + after))
        on = before**2 / ((before + after) * (before + after + span[4:-1, None]))
        base = pose + on * steps[1:] - back * steps[:-1]
        jolts = np.diff(bends, axis=0) / np.diff(knots)[:, None]
        return cls(knots, rates, bends, jolts, base, span, places, steps, R)

    def poses(self, at: Array) -> tuple[Array, Array | None]:
        """Poses (m, 6) at times (m,), and orientations (m, 3, 3) where turns are about one axis; their angles are then
        left to who reads the matrices."""
        i = np.clip(np.searchsorted(self.knots, at, side="right") - 1, 0, len(self.knots) - 2)
        u = (at - self.knots[i])[:, None]
        pose = self._base[i] + u * (self.rates[i] + u * (self.bends[i] / 2 + u * (self.jolts[i] / 6)))
        return pose, None if self._R is None else self._orientations(i, u)

    def _orientations(self, i: IndexArray, u: Array) -> Array:
        """Orientations (m, 3, 3) at times u (m, 1) after knot i (m,)."""
        assert self._R is not None
        h_0, h_1, h, h_3, h_4 = (self._spans[i + k, None] for k in range(1, 6))
        first = (h - u) ** 3 / (h * (h_1 + h) * (h_0 + h_1 + h))
        last = u**3 / (h * (h + h_3) * (h + h_3 + h_4))
        # the two weights between follow from their sum and from where they lead: to the time itself
        x_0, x_1, x_2, x_3 = (self._places[i + k, None] - self.knots[i, None] for k in range(4))
        third = (u - first * x_0 - last * x_3 - (1 - first - last) * x_1) / (x_2 - x_1)
        turns = (self._steps[i + k, 3:] for k in range(3))
        begin = self._R[i]  # of the second control pose
        one, two, three = turns
        # R_0 exp((1 - first) one) = R_1 exp(-first one)
        out = begin @ rotations_by(-first * one) @ rotations_by((third + last) * two)
        return np.asarray(out @ rotations_by(last * three))


def rounded(chain: Polyline, spacing: float, tolerance: float, turn_tolerance: float) -> Rounded:
    """The curve with knots at most spacing [s] apart that stays within tolerance [m] and turn_tolerance [rad] of the
    chain, and the chain's poses within both of it. Raises ValueError for tolerances that need more than _MOST knots."""
    end = chain.at[-1]
    knots = np.linspace(0.0, end, max(_FEWEST, int(np.ceil(end / spacing))) + 1)
    stale = np.ones(len(knots) - 1, dtype=bool)
    for _ in range(_HALVED):
        curve = Rounded.over(chain, knots)
        looked = _looked_at(chain.at, knots, stale)
        away, turned = deviations(curve, chain, looked)
        beyond = looked[(away > _SLACK * tolerance) | (turned > _SLACK * turn_tolerance)]
        split = np.zeros(len(stale), dtype=bool)
        split[np.clip(np.searchsorted(knots, beyond, side="right") - 1, 0, len(stale) - 1)] = True
        if not split.any():
            return curve
        # neighbours differ by a factor of two at most, so that no span is bent by a far longer one beside it
        size = np.diff(knots)
        while True:
            halves = np.where(split, size / 2, size)
            wide = ~split & (
                halves > 2.01 * np.minimum(np.append(halves[1:], np.inf), np.insert(halves[:-1], 0, np.inf))
            )
            if not wide.any():
                break
            split |= wide
        at = np.flatnonzero(split)
        fresh = split.copy()
        for k in (1, 2, 3):  # as far as a control pose is felt
            fresh[k:] |= split[:-k]
            fresh[:-k] |= split[k:]
        stale = np.repeat(fresh, np.where(split, 2, 1))
        knots = np.insert(knots, at + 1, (knots[at] + knots[at + 1]) / 2)
        if len(knots) > _MOST:
            break
    raise ValueError(f"a tolerance of {tolerance:g} m and {turn_tolerance:g} rad needs more than {_MOST:.0e} knots")


def deviations(curve: Rounded, chain: Polyline, at: Array) -> tuple[Array, Array]:
    """How far curve and chain are apart at the same times (m,): at most [m] (m,) and turned by [rad] (m,)."""
    away, turned = np.empty(len(at)), np.empty(len(at))
    for first in range(0, len(at), _ROWS):
        part = slice(first, first + _ROWS)
        (pose, R), (wanted, R_wanted) = curve.poses(at[part]), chain.along(at[part])
        away[part] = np.linalg.norm(pose[:, :3] - wanted[:, :3], axis=1)
        if R is None or R_wanted is None:
            turned[part] = np.linalg.norm(pose[:, 3:] - wanted[:, 3:], axis=1)
        else:
            # |R_1 - R_2| is twice the root of two times the sine of half the angle between
            apart = np.linalg.norm(R - R_wanted, axis=(1, 2)) / np.sqrt(8)
            turned[part] = 2 * np.arcsin(np.minimum(apart, 1.0))
    return away, turned


def _looked_at(vertices: Array, knots: Array, stale: BoolArray) -> Array:
    """The chain's vertices in stale spans, the spans' own ends and their middles."""
    span = np.clip(np.searchsorted(knots, vertices, side="right") - 1, 0, len(stale) - 1)
    return np.concatenate([vertices[stale[span]], knots[:-1][stale], (knots[:-1] + knots[1:])[stale] / 2])


def _turns(R: Array) -> Array:
    return rotation_vector(np.swapaxes(R[:-1], -1, -2) @ R[1:])
