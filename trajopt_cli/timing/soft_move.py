"""ruckig: from rest to rest under limits of jerk, for the optimiser; the judge has a face of its own."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array, readonly


@dataclass(frozen=True, eq=False)
class SoftMove:
    """k axes in m phases of constant jerk each. begins (k, m): when each phase begins [s]; q, qd, qdd, qddd (k, m)."""

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
        """Times (n,) where some axis changes its jerk, both ends included, in order."""
        return np.unique(np.r_[0.0, np.minimum(self.begins.ravel(), self.duration), self.duration])

    def at(self, times: Array) -> tuple[Array, Array]:
        """Positions and speeds (n, k) at times (n,)."""
        q, qd = (np.empty((len(times), len(self.q))) for _ in range(2))
        for j, begins in enumerate(self.begins):
            i = np.clip(np.searchsorted(begins, times, side="right") - 1, 0, None)
            h, v, a, jerk = times - begins[i], self.qd[j, i], self.qdd[j, i], self.qddd[j, i]
            q[:, j] = self.q[j, i] + h * (v + h * (a / 2 + h * jerk / 6))
            qd[:, j] = v + h * (a + h * jerk / 2)
        return q, qd


def soft_move(q_0: Array, q_1: Array, speed: Array, acceleration: Array, jerk: Array) -> SoftMove:
    """The fastest motion of k axes from q_0 (k,) to q_1, at rest at both, all arriving together, under limits (k,).

    Raises ValueError where Ruckig gives no answer.
    """
    from ruckig import InputParameter, Result, Ruckig, Synchronization, Trajectory

    k = len(q_0)
    wish, out = InputParameter(k), Trajectory(k)
    wish.current_position, wish.target_position = q_0.tolist(), q_1.tolist()
    wish.max_velocity, wish.max_acceleration, wish.max_jerk = speed.tolist(), acceleration.tolist(), jerk.tolist()
    wish.synchronization = Synchronization.Time
    result = Ruckig(k).calculate(wish, out)
    if result not in (Result.Working, Result.Finished):
        raise ValueError(f"soft move: ruckig answers {result} for {q_0} to {q_1}")
    profiles = out.profiles[0]
    begins = np.array([np.r_[0.0, np.cumsum(profile.t)] for profile in profiles])
    q, qd, qdd = (np.array([getattr(profile, name) for profile in profiles]) for name in ("p", "v", "a"))
    q[:, -1], qd[:, -1], qdd[:, -1] = q_1, 0.0, 0.0  # after an axis' last phase
    qddd = np.column_stack([[profile.j for profile in profiles], np.zeros(k)])
    return SoftMove(float(out.duration), begins, q, qd, qdd, qddd)
