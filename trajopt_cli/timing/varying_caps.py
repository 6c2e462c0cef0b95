"""From rest to rest along one coordinate whose caps of speed and acceleration vary with the place, with bounded jerk.

A law whose acceleration alone is bounded is found in two sweeps; the mean over the time that the acceleration takes to
build up bounds the jerk. So that no two ramps of opposite sense meet at a peak within that time, shorter ones are cut,
and each cap holds a little before and after its place. Where caps change within the mean, it may pass them by a little:
who has to keep them looks, and asks again with lower ones.
"""

from __future__ import annotations

from math import ceil

import numpy as np

from trajopt_cli.geometry import Array, IndexArray

_AROUND = 1 / 16  # of the mean, by which a cap holds before and after its place; more is safe and slow at corners
_WHOLE = 1e-9  # of a period: a time this close to whole periods is whole


def least_time(s: Array, top: Array, push: Array) -> float:
    """How long [s] the fastest law of bounded acceleration takes, from rest to rest; arguments as of rest_to_rest."""
    return float(_times(s, _swept(s, top, push))[-1])


def rest_to_rest(s: Array, top: Array, push: Array, h: float, mean: int) -> Array | None:
    """Places every h [s], from s[0] to s[-1], both exact and at rest; as fast as caps allow. None where all of the way
    is shorter than the mean.

    s (n+1,): increasing; top, push (n,): the greatest ds/dt and |d2s/dt2| between neighbours, above zero. mean: how
    many periods the acceleration takes to build up; 1 for none. Where top and push are constant, divided differences of
    the result keep them, and third ones push / (mean h).
    """
    rate = _swept(s, top, push)
    if mean > 1:
        t = _times(s, rate)
        bins = _Bins(t, h)
        rate = _swept(s, *(bins.spread(cap, max(1, round(_AROUND * mean))) for cap in (top, push)))
        s, rate = _without_peaks(s, rate, h, mean)
        if not rate.any():
            return None
    places = _uniform(s, rate, h)
    if mean == 1:
        return places
    held = np.ones(mean - 1)
    out = np.convolve(np.concatenate([s[0] * held, places, s[-1] * held]), np.full(mean, 1 / mean), mode="valid")
    out[0], out[-1] = s[0], s[-1]
    return np.asarray(out)


def _swept(s: Array, top: Array, push: Array) -> Array:
    """The greatest ds/dt (n+1,) at places s from rest to rest; its square is linear in between."""
    cap = np.concatenate([[0.0], np.minimum(top[:-1], top[1:]) ** 2, [0.0]])
    gain = np.concatenate([[0.0], np.cumsum(2 * push * np.diff(s))])
    on = np.minimum(gain + np.minimum.accumulate(cap - gain), cap)
    back = np.minimum.accumulate((on + gain)[::-1])[::-1] - gain
    return np.asarray(np.sqrt(np.clip(np.minimum(back, on), 0.0, None)))


def _times(s: Array, rate: Array) -> Array:
    """When each place is passed (n+1,), the acceleration constant in between."""
    return np.concatenate([[0.0], np.cumsum(2 * np.diff(s) / (rate[1:] + rate[:-1]))])


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
        out = _least_within(least, reach)
        to = np.append(self._of[1:], self._count - 1)
        return np.asarray(np.minimum(out[self._of], out[to]))


def _least_within(values: Array, reach: int) -> Array:
    """The least of the values up to reach places away on either side."""
    n, width = len(values), 2 * reach + 1
    least, have = np.concatenate([np.full(reach, np.inf), values, np.full(reach, np.inf)]), 1
    while have < width:
        step = min(have, width - have)
        least = np.minimum(least[:-step], least[step:])
        have += step
    return least[:n]


def _without_peaks(s: Array, rate: Array, h: float, width: int) -> tuple[Array, Array]:
    """Places and ds/dt there of the law whose peaks last at least so many periods."""
    places = _uniform(s, rate, h)
    i = np.clip(np.searchsorted(s, places, side="right") - 1, 0, len(s) - 2)
    share = (places - s[i]) / (s[i + 1] - s[i])
    rates = np.sqrt(np.clip(rate[i] ** 2 + share * (rate[i + 1] ** 2 - rate[i] ** 2), 0.0, None))
    rates[[0, -1]] = 0.0
    reach = ceil(width / 2)
    edge = np.zeros(reach)
    low = _least_within(np.concatenate([edge, rates, edge]), reach)
    cut = -_least_within(-low, reach)[reach:-reach]
    return places, np.minimum(cut, rates)


def _uniform(s: Array, rate: Array, h: float) -> Array:
    """Places in equal steps of time of at most h [s] from the first to the last."""
    t = _times(s, rate)
    count = max(2, ceil(t[-1] / h - _WHOLE))
    step = t[-1] / count
    times = np.arange(count + 1) * step
    i: IndexArray = np.clip(np.searchsorted(t, times, side="right") - 1, 0, len(t) - 2)
    past, whole = times - t[i], t[i + 1] - t[i]
    places = s[i] + past * (rate[i] + (rate[i + 1] - rate[i]) * past / (2 * whole))
    places[0], places[-1] = s[0], s[-1]
    return np.maximum.accumulate(np.minimum(places, s[-1]))
