"""How the tool centre point of a six-axis arm moves with its axes: Jacobian, velocity and acceleration.

Built in the arm's canonical base frame (see robot.arm), where components lead, and turned into the world at the end.
With joint rates u_i along the axes, w_i their sum as far as joint i and d_i the way from its axis to the next (from the
last to the TCP), the TCP's velocity is the sum of w_i x d_i; its acceleration follows by differentiating that sum
(Featherstone, "Rigid Body Dynamics Algorithms", 2008, 2.11). No matrix of derivatives is needed for it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.robot import arm as arm_products
from trajopt_cli.robot.arm import Arm


@dataclass(frozen=True, eq=False)
class Differential:
    """Differential kinematics at axes (..., k); TCP motions are (..., 6) in world axes, linear first.

    axes (3, 6, ...): unit axes of the canonical joints. steps (3, 6, ...) [m]: d_i above. shape: of the axes.
    signs (6,): of joints in canonical angles, None where all are 1. R_WO: the canonical base's directions in the world,
    None where they are the world's own. rail (3,): direction of the rail's travel in the world, None without one.
    coupled: joint 3 is the upper arm's angle against the base, see robot.arm.
    """

    axes: Array
    steps: Array
    shape: tuple[int, ...]
    signs: Array | None
    R_WO: Array | None
    rail: Array | None
    coupled: bool = False

    @classmethod
    def of(cls, arm: Arm, q: Array, X_FT: Array | None, R_WO: Array, rail: Array | None) -> Differential:
        """Of an arm at q (..., k), the rail's position first where there is a rail. X_FT (4, 4), None: the flange."""
        p_FT = np.zeros(3) if X_FT is None else np.asarray(X_FT, dtype=np.float64)[:3, 3]
        p_FT = p_FT + arm.X_KF[:3, :3].T @ arm.X_KF[:3, 3]  # from where axis 6 meets the canonical flange
        beyond = X_FT is not None or bool(np.any(p_FT))
        if beyond:
            a, o, R_OF = arm_products.axes_points_and_turn(arm, q[..., -6:])
        else:
            a, o = arm_products.axes_and_points(arm, q[..., -6:])
        steps = np.empty_like(o)
        np.subtract(o[:, 1:], o[:, :-1], out=steps[:, :-1])
        np.multiply(arm.c4, a[:, 5], out=steps[:, 5])  # from the wrist centre to the TCP
        if beyond:
            steps[:, 5] += np.moveaxis(R_OF @ p_FT, -1, 0)
        signs = None if arm.canonical_joints else arm.signs
        return cls(a, steps, q.shape, signs, None if np.array_equal(R_WO, np.eye(3)) else R_WO, rail, arm.coupled)

    def jacobian(self) -> Array:
        """Geometric Jacobian (..., 6, k): [v; omega] = J qd."""
        J = self._matrix(_cross(self.axes, self._levers()), self.axes)
        if self.rail is not None:
            J[..., :3, 0] = self.rail
        return J

    def velocity(self, qd: Array) -> Array:
        """The TCP's twist (..., 6) at axis speeds (..., k)."""
        omega, p_dot = self._turning(self._rates(qd))
        return self._motion(p_dot, omega[:, -1], qd)

    def bias(self, qd: Array) -> Array:
        """The rate (..., 6) of that twist where no axis accelerates: J' qd."""
        return self._motion(*self._accelerations(self._rates(qd), None), None)

    def motion(self, qd: Array, qdd: Array) -> Array:
        """The TCP's twist J qd and its rate J qdd + J' qd (..., 2, 6) at axis speeds and accelerations (..., k)."""
        rates = self.velocity(qd), self._motion(*self._accelerations(self._rates(qd), self._rates(qdd)), qdd)
        return np.stack(rates, axis=-2)

    def _rates(self, qd: Array) -> Array:
        """Rates along the canonical axes (3, 6, ...) of axis rates (..., k)."""
        if qd.shape != self.shape:
            raise ValueError(f"qd has shape {qd.shape}, wanted {self.shape} like q")
        rates = qd[..., -6:] if self.signs is None else self.signs * qd[..., -6:]
        if self.coupled:
            rates[..., 2] -= rates[..., 1]
        return self.axes * np.ascontiguousarray(np.moveaxis(rates, -1, 0))

    def _turning(self, along: Array) -> tuple[Array, Array]:
        """Of the link behind each joint: how fast it turns and its way d_i moves, both (3, 6, ...)."""
        omega = _summed(along)
        return omega, _cross(omega, self.steps)

    def _accelerations(self, along: Array, more: Array | None) -> tuple[Array, Array]:
        """Parts of the TCP's acceleration (3, 6, ...), to be summed, and its angular acceleration (3, ...)."""
        omega, p_dot = self._turning(along)
        alpha = np.zeros_like(along) if more is None else more
        alpha[:, 1:] += _cross(omega[:, :-1], along[:, 1:])
        alpha = _summed(alpha)
        return _cross(alpha, self.steps) + _cross(omega, p_dot), alpha[:, -1]

    def _levers(self) -> Array:
        """From each axis to the TCP (3, 6, ...) [m]."""
        return _summed(self.steps[:, ::-1])[:, ::-1]

    def _motion(self, linear: Array, angular: Array, rates: Array | None) -> Array:
        """A TCP motion (..., 6) of the linear parts (3, 6, ...), to be summed, and the angular (3, ...); rates (..., k)
        of the axes: the rail's own moves the TCP, too."""
        out = np.empty((*self.shape[:-1], 6))
        for rows, part in ((slice(0, 3), linear.sum(axis=1)), (slice(3, 6), angular)):
            out[..., rows] = np.moveaxis(self._in_world(part), 0, -1)
        if rates is not None and self.rail is not None:
            out[..., :3] += rates[..., :1] * self.rail
        return out

    def _matrix(self, linear: Array, angular: Array) -> Array:
        """A matrix (..., 6, k) from the columns (3, 6, ...) of canonical joints, 0 for the rail."""
        J = np.zeros((*self.shape[:-1], 6, self.shape[-1]))
        for rows, block in ((slice(0, 3), linear), (slice(3, 6), angular)):
            if self.coupled:
                block = block.copy()
                block[:, 1] -= block[:, 2]
            if self.signs is not None:
                block = block * self.signs.reshape(6, *[1] * (len(self.shape) - 1))
            J[..., rows, -6:] = np.moveaxis(self._in_world(block), (0, 1), (-2, -1))
        return J

    def _in_world(self, x: Array) -> Array:
        return x if self.R_WO is None else np.tensordot(self.R_WO, x, axes=1)


def _summed(x: Array) -> Array:
    """Sums (3, 6, ...) as far as each joint."""
    out = x.copy()
    for i in range(1, 6):
        out[:, i] += out[:, i - 1]
    return out


def _cross(a: Array, b: Array) -> Array:
    """Cross product of (3, ...) with (3, ...), components first."""
    out, other = np.empty(a.shape), np.empty(a.shape[1:])
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        np.multiply(a[j], b[k], out=out[i])
        np.multiply(a[k], b[j], out=other)
        out[i] -= other
    return out
