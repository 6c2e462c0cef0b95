"""How far the arm stays behind its equilibrium: the deviation d_k of eq. 6.8, its worst case, and when the arm arrives.

Equation numbers are those of Cihala, Poddajne rizeni prumysloveho robota, CVUT 2020.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.iiwa.task.angles import rotation
from trajopt_cli.iiwa.task.equilibrium import Piece


def deviation(x: ArrayLike, x_e: ArrayLike) -> Array:
    """d_k = ||p_k - p_e,k|| (n,) [m], eq. 6.8, of poses x and equilibrium x_e (n, 6); their positions alone."""
    return np.asarray(np.linalg.norm((np.asarray(x) - x_e)[:, :3], axis=1), dtype=np.float64)


def turn_deviation(x: ArrayLike, x_e: ArrayLike) -> Array:
    """Angles (n,) [rad] between the orientations of poses x and x_e (n, 6), whichever way their angles are written."""
    apart = np.linalg.norm(rotation(np.asarray(x)[:, 3:]) - rotation(np.asarray(x_e)[:, 3:]), axis=(1, 2))
    # ||R - R_e||_F = 2 sqrt(2) sin(angle / 2)
    return np.asarray(2 * np.arcsin(np.minimum(apart / np.sqrt(8.0), 1.0)), dtype=np.float64)


@dataclass(frozen=True)
class Lag:
    """The deviation's worst case: maximum [m] at time [s], on piece (None where the equilibrium names none).

    mean [m]: over all rows. turn_maximum [rad] at turn_time [s]:
    the same of the angle between both orientations.
    """

    maximum: float
    time: float
    piece: Piece | None
    mean: float
    turn_maximum: float
    turn_time: float


def worst_lag(x: Array, x_e: Array, h: float, pieces: Sequence[Piece]) -> Lag:
    """The lag of a response x (n, 6) behind poses x_e (n, 6) with a row every h [s], the last one held."""
    d, turn = deviation(x, x_e), turn_deviation(x, x_e)
    row, turn_row = int(np.argmax(d)), int(np.argmax(turn))
    # A shared row belongs to the piece that ends there; what is held after the end to the last one.
    piece = next((p for p in pieces if row <= p.last), pieces[-1] if pieces else None)
    return Lag(float(d[row]), row * h, piece, float(np.mean(d)), float(turn[turn_row]), turn_row * h)


def held(rows: ArrayLike, seconds: float, h: float) -> Array:
    """Rows (n, ...) with the last one held for at least seconds more, so that the arm arrives."""
    rows = np.asarray(rows, dtype=np.float64)
    return np.concatenate([rows, np.repeat(rows[-1:], held_rows(seconds, h), axis=0)])


def held_rows(seconds: float, h: float) -> int:
    """How many rows of h [s] hold a pose for at least seconds."""
    return ceil(seconds / h - 1e-9)


def nearest_rows(path: Array, p: Array) -> IndexArray:
    """Which row of a path (n, 3) each of points p (m, 3) is nearest to."""
    from scipy.spatial import cKDTree

    return np.asarray(cKDTree(path).query(p)[1], dtype=np.intp)


def settling(x: ArrayLike, goal: ArrayLike, bound: float, turn_bound: float, h: float) -> float | None:
    """Time [s] from which on x (n, 6), a row every h, stays within bound [m] and turn_bound [rad] of goal (6,).

    Both norms as in deviation and turn_deviation. None when the last row is still farther away.
    """
    x = np.asarray(x, dtype=np.float64)
    x_e = np.broadcast_to(np.asarray(goal, dtype=np.float64), x.shape)
    far = np.flatnonzero((deviation(x, x_e) > bound) | (turn_deviation(x, x_e) > turn_bound))
    if len(far) == 0:
        return 0.0
    arrived = int(far[-1]) + 1
    return arrived * h if arrived < len(x) else None
