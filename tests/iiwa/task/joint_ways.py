"""Ways for the joints to follow, made row by row, and the arm's forward kinematics by another route."""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.iiwa.task.equilibrium import Equilibrium, Piece
from trajopt_cli.iiwa.task.model import AngleMeaning, RotationLaw

H = 1e-3
HOME = np.radians([0, 30, 0, -100, 0, 50, 0])
"""The thesis' pose: the tool points down, the elbow up."""


def product_forward(q: Array, X_WB: Array | None = None) -> Array:
    """Flange poses (n, 4, 4) of q (n, 7) as the product of seven turns and four lengths along z (Faria et al. 2018)."""
    z, y = np.array([0.0, 0, 1]), np.array([0.0, 1, 0])
    X = np.broadcast_to(np.eye(4) if X_WB is None else X_WB, (len(q), 4, 4))
    for j, axis in enumerate((z, y, z, -y, z, y, z)):
        length = {0: 0.34, 2: 0.4, 4: 0.4, 6: 0.126}.get(j, 0.0)
        X = X @ pose(rotation_about(axis, q[:, j]), length * z)
    return X


def quintic(n: int) -> Array:
    """Shares (n,) of a way from rest to rest."""
    u = np.linspace(0.0, 1.0, n)
    return u**3 * (10 - u * (15 - 6 * u))


def line(X_start: Array, by: Array, turn: Array, seconds: float, h: float = H) -> Equilibrium:
    """From the tool's pose X_start (4, 4) by (3,) [m] and turned by angles (3,) [rad] relative to it, quintic."""
    share = quintic(round(seconds / h) + 1)[:, None]
    rows = np.concatenate([X_start[:3, 3] + share * by, share * turn], axis=1)
    alpha, beta, gamma = rows[:, 3:].T
    R = rotation_about([0, 0, 1], gamma) @ rotation_about([0, 1, 0], beta) @ rotation_about([1, 0, 0], alpha)
    return sequence(rows, R, AngleMeaning.RELATIVE, h)


def spin(X_start: Array, angles: Array, h: float = H) -> Equilibrium:
    """Standing at X_start (4, 4), the tool turned about its own z by angles (n,) [rad]: joint_7 alone does it."""
    rows = np.zeros((len(angles), 6))
    rows[:, :3], rows[:, 5] = X_start[:3, 3], angles
    return sequence(rows, X_start[:3, :3] @ rotation_about([0, 0, 1], angles), AngleMeaning.ABSOLUTE, h)


def sequence(rows: Array, R: Array, meaning: AngleMeaning, h: float) -> Equilibrium:
    """One piece from a to b."""
    return Equilibrium(h, rows, R, RotationLaw.TAIT_BRYAN, meaning, (Piece(0, len(rows) - 1, "a", "b"),))
