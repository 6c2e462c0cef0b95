"""Three-phase profiles for a synchronised joint move whose end states and duration are given.

The axes' switches are kept apart: rows of the written file stand at every switch, and two rows must not be nearer than
a file can carry. An axis with time to spare ramps more gently; if the tight ones collide the move lasts a hair longer.
"""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.settings import Settings
from trajopt_cli.timing.double_integrator import cruise_profile, gentlest_profile, shortest_time, trapezoid_time
from trajopt_cli.trajectories.leg_trajectories import JointProfiles

_LONGER = 4e-6  # s that a joint move is lengthened at a time, until its switches stand apart.
_ATTEMPTS = 245  # of these: less than a millisecond in all.
_SAME_SWITCH = 1e-10  # s; switches nearer than this are one.
# shares of its top acceleration that an axis with time to spare tries in turn.
_GENTLER = (
    1.0,
    0.9998,
    0.9995,
    0.999,
    0.998,
    0.995,
    0.99,
    0.97,
    0.9,
    0.8,
    0.65,
    0.5,
    0.3,
    0.1,
    0.03,
    0.01,
    0.001,
    0.0001,
)


def profiles(
    q_0: Array, qd_0: Array, q_1: Array, qd_1: Array, V: Array, A: Array, T: float, common: bool, settings: Settings
) -> JointProfiles:
    """Profiles (n axes) of a joint move of at least duration T; common: all axes share one trapezoid from rest to rest.

    Raises ValueError where T is out of reach.
    """
    if not common:
        T = max(T, float(shortest_time(q_1 - q_0, qd_0, qd_1, V, A)))
    else:
        way = np.maximum(np.abs(q_1 - q_0), 1e-12)
        T = max(T, float(trapezoid_time(1.0, np.min(V / way), np.min(A / way))))
    for attempt in range(_ATTEMPTS):
        longer = T + attempt * _LONGER
        found = (
            _common(q_0, q_1, V, A, longer, settings.switches_apart)
            if common
            else _own(q_0, qd_0, q_1, qd_1, V, A, longer, settings.switches_apart)
        )
        if found is not None:
            return JointProfiles(longer, q_0, qd_0, *found)
    raise ValueError(
        f"profiles: the switches of a joint move of {T:.6f} s cannot be kept {settings.switches_apart:g} s apart"
    )


def hold(T: float, q: Array) -> JointProfiles:
    """All axes (n,) at rest for T seconds."""
    n = len(q)
    return JointProfiles(T, q, np.zeros(n), np.tile([0.0, 0.0, T, T], (n, 1)), np.zeros((n, 3)))


def _clear(breaks: Array, placed: Array, least: float) -> bool:
    """No break within a profile, or between it and the placed ones, nearly but not quite coincides."""
    gaps = np.abs(breaks[:, None] - np.concatenate([placed, breaks])[None])
    return not np.any((gaps > _SAME_SWITCH) & (gaps < least))


def _keeps(V: float, v_0: float, breaks: Array, acceleration: Array) -> bool:
    """Whether the cruise between the ramps stays under the top speed; gentler ramps mean a faster cruise."""
    return bool(abs(v_0 + acceleration[0] * breaks[1]) <= V * (1 + 1e-12))


def _own(
    q_0: Array, qd_0: Array, q_1: Array, qd_1: Array, V: Array, A: Array, T: float, least: float
) -> tuple[Array, Array] | None:
    n = len(q_0)
    times, accelerations = np.empty((n, 4)), np.empty((n, 3))
    placed = np.array([0.0, T])
    way = q_1 - q_0
    # axes near their top acceleration or, cruising, near their top speed have least choice: place them first
    need = np.empty(n)
    for j in range(n):
        move = float(way[j]), float(qd_0[j]), float(qd_1[j]), T
        try:
            breaks, acc = cruise_profile(*move, float(A[j]))
        except ValueError:
            return None
        cruise = abs(qd_0[j] + acc[0] * breaks[1]) / V[j]
        need[j] = max(abs(gentlest_profile(*move)[1][0]) / A[j], cruise)
    for j in np.argsort(-need, kind="stable"):
        for factor in _GENTLER:
            try:
                breaks, acc = cruise_profile(float(way[j]), float(qd_0[j]), float(qd_1[j]), T, float(A[j]) * factor)
            except ValueError:
                breaks, acc = gentlest_profile(float(way[j]), float(qd_0[j]), float(qd_1[j]), T)
                slow = np.all(np.abs(acc) <= A[j] * (1 + 1e-12)) and _keeps(V[j], qd_0[j], breaks, acc)
                if not (slow and _clear(breaks, placed, least)):
                    return None
                break
            if _clear(breaks, placed, least) and _keeps(V[j], qd_0[j], breaks, acc):
                break
        else:
            return None
        times[j], accelerations[j] = breaks, acc
        placed = np.concatenate([placed, breaks])
    return times, accelerations


def _common(q_0: Array, q_1: Array, V: Array, A: Array, T: float, least: float) -> tuple[Array, Array] | None:
    way = q_1 - q_0
    if not np.any(way):
        return np.tile([0.0, 0.0, T, T], (len(way), 1)), np.zeros((len(way), 3))
    a = float(np.min(A / np.maximum(np.abs(way), 1e-12)))
    breaks, share = cruise_profile(1.0, 0.0, 0.0, T, a)
    if not _clear(breaks, np.array([0.0, T]), least):
        # a cruise too short to write down: one switch in the middle, a hair gentler
        breaks, share = np.array([0.0, T / 2, T / 2, T]), np.array([1.0, 0.0, -1.0]) * 4.0 / T**2
        if np.any(np.abs(way) * 2 / T > V * (1 + 1e-12)):
            return None
    return np.tile(breaks, (len(way), 1)), way[:, None] * share
