"""The fastest motion between two points, every axis on its own: by Ruckig, or bang-bang in closed form."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array, readonly
from trajopt_cli.timing.double_integrator import cruise_profile, fastest_profile, shortest_time

_BESIDE = 1 - 1e-12
_SAME = 1e-13  # of a duration: two that differ by less are one


def rest_time(D: Array, V: Array, A: Array, J: Array) -> Array:
    """Least times from rest to rest over D >= 0 under speed, acceleration and jerk limits; all broadcast."""
    D, V, A, J = np.broadcast_arrays(D, V, A, J)
    ramp = np.where(V * J > A * A, V / A + A / J, 2 * np.sqrt(V / J))  # from rest to the top speed
    sharp = 4 * np.cbrt(D / (2 * J))
    speed = (np.sqrt((A / J) ** 2 + 4 * D / A) - A / J) * A / 2
    with np.errstate(divide="ignore", invalid="ignore"):
        full = np.where(D > 0, 2 * D / speed, 0.0)
    slower = np.where(D <= 2 * A**3 / J**2, sharp, full)
    return np.asarray(np.where(V * ramp <= D, D / V + ramp, slower))


@dataclass(frozen=True, eq=False)
class PointToPoint:
    """k axes from point to point, each in m phases of constant jerk (of constant acceleration where jerk is free).

    begins (k, m): when each phase begins [s]; q, qd, qdd (k, m) there; qddd (k, m) in it. duration [s]: of all axes.
    """

    duration: float
    begins: Array
    q: Array
    qd: Array
    qdd: Array
    qddd: Array

    def __post_init__(self) -> None:
        for name in ("begins", "q", "qd", "qdd", "qddd"):
            object.__setattr__(self, name, readonly(getattr(self, name)))

    @property
    def switches(self) -> Array:
        """Times (n,) where some axis changes its jerk or acceleration, both ends included, in order."""
        return np.unique(np.concatenate([[0.0], np.minimum(self.begins.ravel(), self.duration), [self.duration]]))

    def slowed(self, factor: float) -> PointToPoint:
        """The same motion in `factor` times the time: speeds, accelerations and jerks fall by its powers."""
        return PointToPoint(
            self.duration * factor, self.begins * factor, self.q, self.qd / factor, self.qdd / factor**2,
            self.qddd / factor**3,
        )  # fmt: skip

    def at(self, times: Array) -> tuple[Array, Array, Array]:
        """Positions, speeds, accelerations (n, k) at times (n,); at a switch those of the phase that begins."""
        t = np.clip(times, 0.0, self.duration)
        out = [np.empty((len(t), len(self.q))) for _ in range(3)]
        for j, begins in enumerate(self.begins):
            i = np.searchsorted(begins, t, side="right") - 1
            h = t - begins[i]
            q, v, a, jerk = (x[j, i] for x in (self.q, self.qd, self.qdd, self.qddd))
            out[0][:, j] = q + h * (v + h * (a / 2 + h * jerk / 6))
            out[1][:, j] = v + h * (a + h * jerk / 2)
            out[2][:, j] = a + h * jerk
        return out[0], out[1], out[2]

    def jerks(self, times: Array) -> Array:
        """Jerks (n, k) at times (n,); zero throughout where jerk was free."""
        phase = [np.searchsorted(begins, times, side="right") - 1 for begins in self.begins]
        return np.column_stack([row[i] for row, i in zip(self.qddd, phase, strict=True)])


def point_to_point(
    q_0: Array,
    q_1: Array,
    speed: Array,
    acceleration: Array,
    jerk: Array | None = None,
    least: float = 0.0,
    straight: bool = False,
    v_0: Array | None = None,
    v_1: Array | None = None,
) -> PointToPoint:
    """The fastest motion of k axes from q_0 (k,) to q_1, all arriving together; at speeds v_0, v_1 (k,), None for rest.

    Speeds, accelerations and, unless None, jerks stay within their limits, each (k,). least: least duration [s].
    straight: the axes keep to the straight line between the points, where their limits admit one profile.
    Raises ValueError for limits that are not positive and finite.
    """
    still = np.zeros(len(q_0))
    v_0, v_1 = (still if v is None else v for v in (v_0, v_1))
    found = _calculate(q_0, q_1, speed, acceleration, jerk, least, straight, v_0, v_1)
    profiles = found.profiles[0]
    k = len(q_0)
    begins = np.column_stack([np.zeros(k), np.cumsum([profile.t for profile in profiles], axis=1)])
    q, qd, qdd = (np.array([getattr(profile, name) for profile in profiles]) for name in ("p", "v", "a"))
    qddd = np.column_stack([[profile.j for profile in profiles], np.zeros(k)])
    # the last column is what comes after an axis' last phase
    q[:, -1], qd[:, -1], qdd[:, -1] = q_1, v_1, 0.0
    return PointToPoint(float(found.duration), begins, q, qd, qdd, qddd)


def _calculate(
    q_0: Array, q_1: Array, speed: Array, acceleration: Array, jerk: Array | None, least: float, straight: bool,
    v_0: Array, v_1: Array,
) -> Any:  # fmt: skip
    """Ruckig's own trajectory; it comes without types."""
    from ruckig import InputParameter, Result, Ruckig, RuckigError, Synchronization, Trajectory

    limits = [speed, acceleration] + ([] if jerk is None else [jerk])
    if not (np.all(np.isfinite(limits)) and np.min(limits) > 0):
        said = " and ".join(str(limit) for limit in limits)
        raise ValueError(f"point to point: limits must be positive and finite, got {said}")
    k = len(q_0)
    wish = InputParameter(k)
    wish.current_position, wish.target_position = list(map(float, q_0)), list(map(float, q_1))
    wish.current_velocity, wish.target_velocity = list(map(float, v_0)), list(map(float, v_1))
    wish.current_acceleration = wish.target_acceleration = [0.0] * k
    wish.max_velocity, wish.max_acceleration = list(map(float, speed)), list(map(float, acceleration))
    wish.max_jerk = [float("inf")] * k if jerk is None else list(map(float, jerk))
    wish.synchronization = Synchronization.Phase if straight else Synchronization.Time
    if least > 0:
        wish.minimum_duration = least
    out = Trajectory(k)
    try:
        result = Ruckig(k).calculate(wish, out)
    except RuckigError:
        # where one phase is exactly as long as nothing, rounding leaves it no profile: a hair beside there is one
        wish.max_jerk = [_BESIDE * value for value in wish.max_jerk]
        result = Ruckig(k).calculate(wish, out)
    if result not in (Result.Working, Result.Finished):
        raise ValueError(f"point to point: ruckig answers {result} for {q_0} to {q_1}")
    return out


def bang_bang(D: Array, v_0: Array, v_1: Array, V: Array, A: Array, T: float | None = None) -> PointToPoint:
    """Displacements D (k,) from velocities v_0 to v_1 (k,), each axis at full acceleration A to one cruise speed <= V.

    T: duration [s]; None for the least in which all axes arrive together. An axis that T leaves time for cruises more
    slowly. Raises ValueError for a T that an axis cannot take: with speeds at both ends not every longer time is one.
    """
    least = float(shortest_time(D, v_0, v_1, V, A)) if T is None else T
    begins, rates = np.empty((len(D), 4)), np.zeros((len(D), 4))
    for j, one in enumerate(zip(D.tolist(), v_0.tolist(), v_1.tolist(), V.tolist(), A.tolist(), strict=True)):
        way, first, last, top, most = one
        begins[j], rates[j, :3] = fastest_profile(way, first, last, top, most)
        if abs(begins[j, -1] - least) > _SAME * least:
            begins[j], rates[j, :3] = cruise_profile(way, first, last, least, most)
    steps = np.diff(begins)
    qd = np.column_stack([v_0, v_0[:, None] + np.cumsum(rates[:, :3] * steps, axis=1)])
    q = np.column_stack([np.zeros(len(D)), np.cumsum((qd[:, 1:] + qd[:, :-1]) / 2 * steps, axis=1)])
    q[:, -1], qd[:, -1] = D, v_1
    return PointToPoint(least, begins, q, qd, rates, np.zeros_like(rates))
