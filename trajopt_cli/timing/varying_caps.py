"""From rest to rest along one coordinate whose caps of speed and acceleration vary with the place, with bounded jerk.

A law whose acceleration alone is bounded is TOPP-RA's; the mean over the time that the acceleration takes to
build up bounds the jerk. So that no two ramps of opposite sense meet at a peak within that time, shorter ones are cut,
and each cap holds a little before and after its place. Where caps change within the mean, it may pass them by a little:
callers check, and ask again with lower ones.
"""

from __future__ import annotations

from math import ceil

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.timing.topp import TimeLaw, fastest_laws

_AROUND = 1 / 16  # of the mean, by which a cap holds before and after its place; more is safe and slow at corners
_WHOLE = 1e-9  # of a period: a time this close to whole periods is whole


Rows = tuple[Array, Array]
"""Slopes and bends, each (2, n, m): where each interval begins and where it ends |slope d2s/dt2 + bend (ds/dt)^2| <= 1
holds for every column."""


def least_time(s: Array, top: Array, push: Array, rows: Rows | None = None) -> float:
    """How long [s] the fastest law of bounded acceleration takes, from rest to rest; arguments as of rest_to_rest."""
    return _fastest(s, top, push, rows).duration


def rest_to_rest(s: Array, top: Array, push: Array, h: float, mean: int, rows: Rows | None = None) -> Array | None:
    """Places every h [s], from s[0] to s[-1], both exact and at rest; as fast as caps allow. None where the whole
    is shorter than the mean.

    s (n+1,): increasing; top, push (n,): the greatest ds/dt and |d2s/dt2| between neighbours, above zero. mean: how
    many periods the acceleration takes to build up; 1 for none. Where top and push are constant, divided differences of
    the result keep them, and third ones push / (mean h). rows: further limits; the mean may pass them by a little.
    """
    law = _fastest(s, top, push, rows)
    if mean > 1:
        bins = _Bins(law.times, h)
        held_top, held_push = (bins.spread(cap, max(1, round(_AROUND * mean))) for cap in (top, push))
        law = _fastest(s, held_top, held_push, rows)
        law = _without_peaks(law, h, mean)
        if not law.rates.any():
            return None
    places = law.at(_even_times(law, h))[0]
    places[0], places[-1] = s[0], s[-1]
    places = np.maximum.accumulate(np.minimum(places, s[-1]))
    if mean == 1:
        return places
    held = np.ones(mean - 1)
    out = np.convolve(np.concatenate([s[0] * held, places, s[-1] * held]), np.full(mean, 1 / mean), mode="valid")
    out[0], out[-1] = s[0], s[-1]
    return np.asarray(out)


def _fastest(s: Array, top: Array, push: Array, rows: Rows | None) -> TimeLaw:
    """The law of bounded acceleration, from rest to rest."""
    node_top = np.concatenate([[0.0], np.minimum(top[:-1], top[1:]), [0.0]])
    own = (1 / push)[:, None], np.zeros((len(push), 1))
    sides = [own, own]
    if rows is not None:
        sides = [(np.hstack([own[0], rows[0][k]]), np.hstack([own[1], rows[1][k]])) for k in (0, 1)]
    begins, ends = ((slopes[None], bends[None]) for slopes, bends in sides)
    return TimeLaw(s, fastest_laws(s, node_top[None], begins, ends, 0.0, 0.0).rates[0])


class _Bins:
    """Periods that the intervals between places fall into."""

    def __init__(self, t: Array, h: float):
        self._count = max(1, ceil(t[-1] / h))
        edges = np.arange(self._count + 1) * h
        self._first = np.clip(np.searchsorted(t, edges[:-1], side="right") - 1, 0, len(t) - 2)
        self._last = np.clip(np.searchsorted(t, edges[1:], side="left"), self._first + 1, len(t) - 1)
        self._of = np.clip((t[:-1] / h).astype(np.intp), 0, self._count - 1)

    def spread(self, cap: Array, reach: int) -> Array:
        """The least cap (n,) within reach periods before and after each interval begins."""
        padded = np.append(cap, np.inf)
        ends = np.column_stack([self._first, self._last]).ravel()
        least = np.minimum.reduceat(padded, ends)[::2]
        # an interval may last longer than a period: what comes within reach of its end is found in its last one
        out = least_within(least, reach)
        to = np.append(self._of[1:], self._count - 1)
        return np.asarray(np.minimum(out[self._of], out[to]))


def least_within(values: Array, reach: int) -> Array:
    """The least of the values up to reach places away on either side."""
    n, width = len(values), 2 * reach + 1
    least, have = np.concatenate([np.full(reach, np.inf), values, np.full(reach, np.inf)]), 1
    while have < width:
        step = min(have, width - have)
        least = np.minimum(least[:-step], least[step:])
        have += step
    return least[:n]


def _without_peaks(law: TimeLaw, h: float, width: int) -> TimeLaw:
    """The law whose peaks last at least so many periods, at its places a period apart."""
    places, rates, _ = law.at(_even_times(law, h))
    rates[[0, -1]] = 0.0
    reach = ceil(width / 2)
    edge = np.zeros(reach)
    low = least_within(np.concatenate([edge, rates, edge]), reach)
    cut = -least_within(-low, reach)[reach:-reach]
    return TimeLaw(places, np.minimum(cut, rates))


def _even_times(law: TimeLaw, h: float) -> Array:
    """Times in equal steps of at most h [s] from the first place to the last."""
    return np.linspace(0.0, law.duration, max(2, ceil(law.duration / h - _WHOLE)) + 1)
