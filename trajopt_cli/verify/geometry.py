"""The judge's own geometry: angles between rotations, and the line that a MoveL asks for."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from trajopt_cli.geometry import Array

_POINT = 1e-6  # m: a line shorter than this is a reorientation, its progress is an angle
_HALF_TURN = 1e-6  # rad: a reorientation this close to half a turn may go either way


def angle_between(A: Array, B: Array) -> Array:
    """Angle (...) in rad between rotations (..., 3, 3); exact to rounding near zero."""
    chord = np.linalg.norm(np.asarray(B) - np.asarray(A), axis=(-2, -1)) / (2 * np.sqrt(2.0))
    return np.asarray(2 * np.arcsin(np.minimum(chord, 1.0)))


def inverse_pose(X: Array) -> Array:
    """X_BA (..., 4, 4) of poses X_AB."""
    out = np.zeros_like(X)
    out[..., :3, :3] = np.swapaxes(X[..., :3, :3], -1, -2)
    out[..., :3, 3] = -np.einsum("...ji,...j->...i", X[..., :3, :3], X[..., :3, 3])
    out[..., 3, 3] = 1.0
    return out


@dataclass(frozen=True, eq=False)
class Line:
    """From X_0 (4, 4) straight along chord (3,) [m] in the world, turning evenly by the rotation vector turn (3,) [rad]
    in the frame of X_0."""

    X_0: Array
    chord: Array
    turn: Array

    @classmethod
    def between(cls, X_0: Array, X_1: Array, R: Array) -> Line:
        """The line from X_0 to X_1 (4, 4), turning the shorter way; of half a turn the way that rotations R (m, 3, 3)
        on it went."""
        turn = np.asarray(pin.log3(X_0[:3, :3].T @ X_1[:3, :3]))
        angle = float(np.linalg.norm(turn))
        if angle > np.pi - _HALF_TURN and turn @ pin.log3(X_0[:3, :3].T @ R[len(R) // 2]) < 0:
            turn = turn * (1 - 2 * np.pi / angle)
        return cls(X_0, X_1[:3, 3] - X_0[:3, 3], turn)

    @property
    def length(self) -> float:
        """Way of the TCP, m."""
        return float(np.linalg.norm(self.chord))

    @property
    def angle(self) -> float:
        """How far the tool turns, rad."""
        return float(np.linalg.norm(self.turn))

    @property
    def only_turns(self) -> bool:
        """Whether the line is a reorientation, whose progress is an angle."""
        return self.length < _POINT and self.length < self.angle

    @property
    def way(self) -> float:
        """What progress is counted in: the length [m], or of a reorientation the angle [rad]."""
        return self.angle if self.only_turns else self.length

    def progress(self, p: Array, R: Array) -> Array:
        """Share of the way (m,) at positions p (m, 3) and rotations R (m, 3, 3), not clipped."""
        if not self.only_turns:
            return np.asarray((p - self.X_0[:3, 3]) @ self.chord / self.length**2)
        # the angle about the line's own axis: what is not about it shows in the deviation
        turned = self.X_0[:3, :3].T @ R
        skew = np.stack([turned[:, i, j] - turned[:, j, i] for i, j in ((2, 1), (0, 2), (1, 0))], axis=1)
        cosine = (np.trace(turned, axis1=1, axis2=2) - 1) / 2
        return np.asarray(np.arctan2(skew @ self.turn / (2 * self.angle), cosine) / self.angle)

    def at(self, s: Array) -> tuple[Array, Array]:
        """Positions (m, 3) and rotations (m, 3, 3) at shares s (m,)."""
        K = pin.skew(self.turn / self.angle) if self.angle > 0 else np.zeros((3, 3))
        sine, cosine = (f(s * self.angle)[:, None, None] for f in (np.sin, np.cos))
        R = self.X_0[:3, :3] @ (np.eye(3) + sine * K + (1 - cosine) * (K @ K))
        return self.X_0[:3, 3] + s[:, None] * self.chord, R
