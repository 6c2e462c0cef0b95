"""The thesis' trajectory generator: one axis, |u| <= a and |v| <= v_max, from one speed to another.

Krotký 2014, section 3.1, eqs. (3.1) to (3.48), after Schlegel and Jágr: a double integrator s' = v, v' = u runs at full
acceleration, if need be at top speed, and at full acceleration the other way. In region A it accelerates first, in
region D it decelerates first; D is A with all signs swapped. Corrected here: (3.17) reads t_f = t_s (v_f - v_s) / a,
right is t_s + (v_s - v_f) / a; (3.36) lacks its t_T; the region called "B" before (3.37) is D; (3.40) speaks of
v_T = v_MAX where it is -v_MAX; (3.10) counts the border between the regions to A, which is right for speeds forward
only: on the border itself one ramp from v_0 to v_f does it, whatever the signs, and any second ramp is a detour.

Axes that must end together need a given time T. With speeds at both ends not every longer time is possible: an axis
too slow to stop before its goal would have to come back. `common_time` finds the least T that all axes reach,
`in_time` the motion that takes exactly so long. Everything broadcasts over cases; units are those of the axis and s.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, BoolArray, readonly

_EPS = float(np.finfo(np.float64).eps)


@dataclass(frozen=True, eq=False)
class AxisMotion:
    """Three phases of constant acceleration, for cases of any shape (...).

    s_0, v_0 (...): state at time 0. phases (..., 3): how long each lasts [s], zero where there is none. accelerations
    (..., 3): u in each.
    """

    s_0: Array
    v_0: Array
    phases: Array
    accelerations: Array

    def __post_init__(self) -> None:
        for name in ("s_0", "v_0", "phases", "accelerations"):
            object.__setattr__(self, name, readonly(getattr(self, name)))

    @property
    def duration(self) -> Array:
        """t_f (...) in s."""
        return np.asarray(self.phases.sum(axis=-1))

    @property
    def switches(self) -> Array:
        """Times (..., 4) the acceleration may change: 0, t_R, t_T, t_f; t_R = t_T = t_s where there is no cruise."""
        zero = np.zeros((*self.phases.shape[:-1], 1))
        return np.concatenate([zero, np.cumsum(self.phases, axis=-1)], axis=-1)

    def at(self, times: ArrayLike) -> tuple[Array, Array, Array]:
        """s, v and u, each (..., m), at times (m,); at a switch u is the one that begins, outside the ends hold.

        Eqs. (3.26), (3.27), (3.29), (3.30), (3.44), (3.45), (3.47) and (3.48) in one: phase after phase.
        """
        begins = self.switches
        t = np.clip(np.asarray(times, dtype=np.float64), 0.0, begins[..., -1:])
        s = np.broadcast_to(self.s_0[..., None], t.shape).copy()
        v = np.broadcast_to(self.v_0[..., None], t.shape).copy()
        u = np.zeros_like(s)
        for i in range(3):
            h = np.clip(t - begins[..., i, None], 0.0, self.phases[..., i, None])
            a = self.accelerations[..., i, None]
            s += h * (v + a * h / 2)
            v += a * h
            u = np.where((t >= begins[..., i, None]) & (self.phases[..., i, None] > 0), a, u)
        return s, v, u


def bang_bang(
    s_0: ArrayLike, v_0: ArrayLike, s_f: ArrayLike, v_f: ArrayLike, v_max: ArrayLike, a_max: ArrayLike
) -> AxisMotion:
    """The fastest motion from s_0 at speed v_0 to s_f at speed v_f, (3.25) and (3.28), with top speed (3.43), (3.46).

    All broadcast to the cases' shape. Raises InputError for limits that are not positive and finite, and for a speed
    at an end beyond v_max.
    """
    s_0, v_0, s_f, v_f, v_max, a_max = _cases(s_0, v_0, s_f, v_f, v_max, a_max)
    way = s_f - s_0
    border = on_border(s_0, v_0, s_f, v_f, a_max)
    # region D is region A seen the other way round: (3.18) to (3.24) are (3.11) to (3.17) with s and v negated
    sign = np.where(np.where(border, v_0 <= v_f, in_region_a(way, v_0, v_f, a_max)), 1.0, -1.0)
    way, v_0d, v_fd = sign * way, sign * v_0, sign * v_f
    faster = np.maximum(v_0d, v_fd)
    v_s = np.sqrt(np.maximum(a_max * way + (v_0**2 + v_f**2) / 2, 0.0))  # (3.14), (3.21)
    v_s = np.where(border, faster, np.maximum(v_s, faster))  # near the border rounding may say less
    peak = np.minimum(v_s, v_max)
    rising, falling = (peak - v_0d) / a_max, (peak - v_fd) / a_max  # (3.16), (3.32), (3.38)
    ramps = ((peak**2 - v_0**2) + (peak**2 - v_f**2)) / (2 * a_max)  # s_R - s_0 and s_f - s_T: (3.33), (3.34)
    cruise = np.where(v_s > v_max, np.maximum(way - ramps, 0.0) / v_max, 0.0)  # (3.35), (3.41)
    zero = np.zeros_like(peak)
    return AxisMotion(
        s_0, v_0, np.stack([rising, cruise, falling], axis=-1), np.stack([sign * a_max, zero, -sign * a_max], axis=-1)
    )


def in_region_a(way: Array, v_0: Array, v_f: Array, a_max: Array) -> BoolArray:
    """Whether the motion accelerates first, (3.10): the way s_f - s_0 is at least that of the ramp from v_0 to v_f."""
    ramp = (v_f**2 - v_0**2) / (2 * a_max)
    return np.asarray(way >= np.where(v_0 <= v_f, ramp, -ramp))


def on_border(s_0: Array, v_0: Array, s_f: Array, v_f: Array, a_max: Array) -> BoolArray:
    """Whether one ramp from v_0 to v_f covers the way, up to its rounding: t_f jumps there, from region to region."""
    ramp = np.where(v_0 <= v_f, 1.0, -1.0) * (v_f**2 - v_0**2) / (2 * a_max)
    size = np.abs(s_0) + np.abs(s_f) + (v_0**2 + v_f**2) / (2 * a_max)
    return np.asarray(np.abs(s_f - s_0 - ramp) <= 4 * _EPS * size)


def common_time(
    s_0: ArrayLike, v_0: ArrayLike, s_f: ArrayLike, v_f: ArrayLike, v_max: ArrayLike, a_max: ArrayLike
) -> float:
    """Least time [s] in which all axes (k,) go from their s_0, v_0 to their s_f, v_f and arrive together.

    The times an axis cannot take are open intervals, at most one for being too far and one for being too near, and
    everything under |v_f - v_0| / a. Raises InputError as bang_bang.
    """
    s_0, v_0, s_f, v_f, v_max, a_max = (np.atleast_1d(x) for x in _cases(s_0, v_0, s_f, v_f, v_max, a_max))
    ramp = np.abs(v_f - v_0) / a_max
    T = float(np.max(ramp))
    blocked = np.stack(
        [_too_far(s_f - s_0, v_0, v_f, v_max, a_max), _too_far(s_0 - s_f, -v_0, -v_f, v_max, a_max)], axis=1
    )
    # on the border between the regions the ramp alone is possible, though rounding may put it into the interval
    least = np.where(on_border(s_0, v_0, s_f, v_f, a_max), ramp, -np.inf)
    blocked[..., 0] = np.maximum(blocked[..., 0], least[:, None])
    blocked = blocked.reshape(-1, 2)
    for begin, end in blocked[np.argsort(blocked[:, 0], kind="stable")]:
        if begin + 8 * _EPS * max(abs(begin), T) < T < end:
            T = float(end)
    return T


def _too_far(way: Array, v_0: Array, v_f: Array, v_max: Array, a_max: Array) -> Array:
    """The open interval of times (k, 2) in which an axis cannot get as far as `way`; begin = end where there is none.

    At full acceleration the peak speed p in time T = (2p - v_0 - v_f) / a reaches (2p^2 - v_0^2 - v_f^2) / 2a: too
    little between both roots +-p of the way. Above v_max the rest is driven at v_max.
    """
    energy = a_max * way + (v_0**2 + v_f**2) / 2
    p = np.sqrt(np.maximum(energy, 0.0))
    begin, end = (-2 * p - v_0 - v_f) / a_max, (2 * p - v_0 - v_f) / a_max
    cruise = (way - (2 * v_max**2 - v_0**2 - v_f**2) / (2 * a_max)) / v_max
    end = np.where(p > v_max, (2 * v_max - v_0 - v_f) / a_max + cruise, end)
    end = np.where(energy > 0, end, begin)
    return np.stack([begin, end], axis=-1)


def in_time(
    s_0: ArrayLike, v_0: ArrayLike, s_f: ArrayLike, v_f: ArrayLike, v_max: ArrayLike, a_max: ArrayLike, T: ArrayLike
) -> AxisMotion:
    """The motion that takes exactly T: ramps at +-a to one cruise speed, the slowest peak of all such motions.

    Raises InputError as bang_bang, and where T is out of reach (see common_time).
    """
    s_0, v_0, s_f, v_f, v_max, a_max, T = _cases(s_0, v_0, s_f, v_f, v_max, a_max, T)
    low, high = np.minimum(v_0, v_f), np.maximum(v_0, v_f)
    way = s_f - s_0

    def travelled(c: Array) -> Array:
        return np.asarray(c * T + ((v_0 - c) * np.abs(v_0 - c) + (v_f - c) * np.abs(v_f - c)) / (2 * a_max))

    above, below = way > travelled(high), way < travelled(low)
    # between the end speeds both ramps go one way and the square terms cancel: way is linear in c; and at an end of
    # that range both formulas agree
    slope = T - (high - low) / a_max
    between = low + (way - travelled(low)) / np.where(slope > 0, slope, 1.0)
    between = np.where(slope > 0, np.clip(between, low, high), high)
    c = np.where(above, _peak(way, v_0, v_f, a_max, T), between)
    c = np.where(below, -_peak(-way, -v_0, -v_f, a_max, T), c)
    rising, falling = np.abs(c - v_0) / a_max, np.abs(c - v_f) / a_max
    slack = 1e-9 * (np.abs(v_0) + np.abs(v_f) + a_max * T + v_max)
    bad = (
        (rising + falling > T + slack / a_max)
        | (np.abs(c) > v_max + slack)
        | (np.abs(travelled(c) - way) > slack * (T + v_max / a_max))
    )
    if np.any(bad):
        i = tuple(int(n) for n in np.argwhere(bad)[0])
        raise InputError(
            f"a way of {way[i]:.9g} from speed {v_0[i]:.9g} to {v_f[i]:.9g} cannot take {T[i]:.9g} s at most"
            f" {v_max[i]:.9g} fast with {a_max[i]:.9g}; ask common_time for a time that can be"
        )
    # rounding: at the least time nothing is left for the cruise
    fit = np.minimum(1.0, T / np.maximum(rising + falling, 1e-300))
    rising, falling = rising * fit, falling * fit
    phases = np.stack([rising, np.maximum(T - rising - falling, 0.0), falling], axis=-1)
    zero = np.zeros_like(c)
    accelerations = np.stack([np.sign(c - v_0) * a_max, zero, np.sign(v_f - c) * a_max], axis=-1)
    # the root of a difference that is all rounding would leave the fastest motion a cruise of a nanosecond
    fastest = bang_bang(s_0, v_0, s_f, v_f, v_max, a_max)
    same = (np.abs(fastest.duration - T) <= 8 * _EPS * T)[..., None]
    return AxisMotion(
        s_0, v_0, np.where(same, fastest.phases, phases), np.where(same, fastest.accelerations, accelerations)
    )


def _peak(way: Array, v_0: Array, v_f: Array, a_max: Array, T: Array) -> Array:
    """Cruise speed c above both end speeds: c T - ((c - v_0)^2 + (c - v_f)^2) / 2a = way, the smaller root."""
    half = (a_max * T + v_0 + v_f) / 2
    rest = a_max * way + (v_0**2 + v_f**2) / 2
    root = np.sqrt(np.maximum(half * half - rest, 0.0))
    sum_ = np.where(half > 0, half + root, 1.0)
    return np.asarray(np.where(half > 0, rest / sum_, half - root))  # half - root, without cancellation


def _cases(s_0: ArrayLike, v_0: ArrayLike, s_f: ArrayLike, v_f: ArrayLike, *limits: ArrayLike) -> tuple[Array, ...]:
    """All as float arrays of one shape, checked. limits: v_max, a_max, and maybe more."""
    values = np.broadcast_arrays(*(np.asarray(x, dtype=np.float64) for x in (s_0, v_0, s_f, v_f, *limits)))
    v_max, a_max = values[4], values[5]
    for name, limit in (("v_max", v_max), ("a_max", a_max)):
        if not np.all((limit > 0) & np.isfinite(limit)):
            bad = limit[~((limit > 0) & np.isfinite(limit))].flat[0]
            raise InputError(f"{name} = {bad:.9g}; a limit must be positive and finite")
    for name, v in (("v_0", values[1]), ("v_f", values[3])):
        if np.any(np.abs(v) > v_max):
            i = tuple(int(n) for n in np.argwhere(np.abs(v) > v_max)[0])
            raise InputError(f"{name} = {v[i]:.9g} passes v_max = {v_max[i]:.9g}; lower the speed at that end")
    return tuple(values)
