"""The path of a sequence, free of its old timing: poses over a path parameter, with the greatest rate.

The parameter s [s] is the time at the programmed speed: one second of s takes at least one second. All six coordinates
are functions of the one s, so that translation and rotation stay together as the segments had them. Where orientations
turn as slerp has them, the last three coordinates are the turns made so far, summed up as vectors in world axes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array, IndexArray, rotations_by
from trajopt_cli.iiwa.task.angles import angles_of, continuous, rotation, rotation_vector
from trajopt_cli.iiwa.task.equilibrium import Equilibrium, Piece
from trajopt_cli.iiwa.task.model import RotationLaw
from trajopt_cli.units import MM

LAGS = (1e-6, 10.0)
"""Least and greatest lag [m] that is looked at."""
TURN_LAGS = (1e-6, float(np.pi))
"""The same of the turn [rad]."""


class CannotDose(ValueError):
    """There is no such sequence, or none worth having; the message says why and what to change."""


@dataclass(frozen=True)
class Lead:
    """A bound on what the controller would push with if the arm were held now: K (x_e - x).

    most: force [N] or moment [Nm]; stretch: a distance [m] or angle [rad] of the spring that pushes as much.
    """

    most: float
    stretch: bool = False

    def __str__(self) -> str:
        """Of a force."""
        return f"lead of at most {self.most / MM:g} mm" if self.stretch else f"push of at most {self.most:g} N"

    def weight(self, K: Array) -> Array:
        """What the push is multiplied with, by axis (..., 3), before its norm is held against most."""
        return np.divide(1.0, K, out=np.zeros(K.shape), where=K > 0) if self.stretch else np.ones(K.shape)


@dataclass(frozen=True)
class Allowed:
    """lag [m]: greatest distance between arm and plan, at every row. turn_lag [rad]: greatest angle between their
    orientations. lead, turn_lead: of force and moment. All above zero; None: no bound."""

    lag: float
    turn_lag: float | None = None
    lead: Lead | None = None
    turn_lead: Lead | None = None

    def __str__(self) -> str:
        out = f"lag of at most {self.lag / MM:g} mm"
        if self.turn_lag is not None:
            out += f" and {np.degrees(self.turn_lag):g}°"
        if self.lead is not None:
            out += f", {self.lead}"
        if (turn := self.turn_lead) is not None:
            out += ", push of at most" if self.lead is None else " and"
            out += f" {np.degrees(turn.most):g}°" if turn.stretch else f" {turn.most:g} Nm"
        return out


_STRAIGHT = 1e-9  # relative change of dX/ds below which rows are one straight segment; rounding of rows is 1e-12


@dataclass(frozen=True)
class PathInterval:
    """Path rows first..last from one waypoint to the next; or, first == last, standing there for dwell [s]."""

    first: int
    last: int
    origin: str
    goal: str
    dwell: float = 0.0


@dataclass(frozen=True, eq=False)
class DosePath:
    """Poses (n, 6) [m, rad] over s (n,), straight in between. cap (n - 1,): greatest ds/dt on each segment, > 0.

    legs: what lies between the waypoints, in order; every waypoint becomes a row of the dosed sequence. R (n, 3, 3):
    the orientations of the rows where the last three coordinates are turns, None where they are Tait-Bryan angles.
    """

    s: Array
    pose: Array
    cap: Array
    legs: tuple[PathInterval, ...]
    R: Array | None = None

    @property
    def moves(self) -> tuple[bool, ...]:
        """Along which of the six coordinates the path moves at all."""
        return tuple(bool(np.any(column != column[0])) for column in self.pose.T)

    @property
    def least_time(self) -> float:
        """Time [s] of the path at its caps, dwells included: what no lag bound can go below."""
        return float(np.sum(np.diff(self.s) / self.cap)) + sum(leg.dwell for leg in self.legs)

    def pieces(self, arrivals: Sequence[int], h: float) -> tuple[Piece, ...]:
        """The rows of every leg; arrivals: the first row at or past the end of each leg that is no dwell."""
        out: list[Piece] = []
        row = 0
        for leg, arrival in zip(self.legs, arrivals, strict=True):
            last = row + round(leg.dwell / h) if leg.dwell else arrival
            out.append(Piece(row, last, leg.origin, leg.goal, dwell=leg.dwell > 0))
            row = last
        return tuple(out)

    def poses(self, coordinates: Array, row: IndexArray) -> tuple[Array, Array]:
        """Poses (m, 6) with Tait-Bryan angles, and their matrices (m, 3, 3), of six coordinates (m, 6).

        row (m,): a row of the path near each, from whose orientation turns count.
        """
        if self.R is None:
            return coordinates, rotation(coordinates[:, 3:])
        R = rotations_by(coordinates[:, 3:] - self.pose[row, 3:]) @ self.R[row]
        return np.hstack([coordinates[:, :3], continuous(angles_of(R))]), R


def dose_path(
    equilibrium: Equilibrium,
    joints: ArrayLike | None = None,
    joint_speed: ArrayLike | None = None,
    slower: Array | None = None,
) -> DosePath:
    """The path of an equilibrium sequence, nowhere faster than the sequence.

    joints (n, k) [rad] with joint_speed (k,) [rad/s]: the robot's joints at the rows and their limits, which slow down
    a segment where the programmed speed would break them. slower (n - 1,): the greatest share of each step's programmed
    speed, None for all of it. Raises CannotDose where nothing moves.
    """
    most = np.ones(len(equilibrium.pose) - 1) if slower is None else slower
    if joints is not None:
        used = np.max(np.abs(np.diff(joints, axis=0)) / joint_speed, axis=1) / equilibrium.h
        most = most / np.maximum(used, 1.0)
    moved = np.any(np.diff(equilibrium.pose, axis=0) != 0, axis=1)
    coordinates = _coordinates(equilibrium)
    s, kept, cap = [0.0], [0], list[float]()
    legs: list[PathInterval] = []
    for piece in equilibrium.pieces:
        row = len(s) - 1
        if piece.dwell:
            legs.append(PathInterval(row, row, piece.origin, piece.goal, (piece.last - piece.first) * equilibrium.h))
            continue
        steps, rows = slice(piece.first, piece.last), slice(piece.first, piece.last + 1)
        ds = np.where(moved[steps], equilibrium.h, 0.0)
        for length, last, greatest in _straightened(ds, coordinates[rows], most[steps]):
            s.append(s[-1] + length)
            kept.append(piece.first + last)
            cap.append(greatest)
        legs.append(PathInterval(row, len(s) - 1, piece.origin, piece.goal))
    if len(s) < 2:
        raise CannotDose("nothing moves in this sequence: there is nothing to dose")
    R = equilibrium.R[kept] if equilibrium.rotation is RotationLaw.SLERP else None
    return DosePath(np.array(s), coordinates[kept], np.array(cap), tuple(legs), R)


def _coordinates(equilibrium: Equilibrium) -> Array:
    """The six coordinates (n, 6) of a sequence's rows."""
    if equilibrium.rotation is not RotationLaw.SLERP:
        return equilibrium.pose
    turns = rotation_vector(equilibrium.R[1:] @ np.swapaxes(equilibrium.R[:-1], 1, 2))
    return np.hstack([equilibrium.pose[:, :3], np.concatenate([np.zeros((1, 3)), np.cumsum(turns, axis=0)])])


def _straightened(ds: Array, pose: Array, cap: Array) -> list[tuple[float, int, float]]:
    """Length, last row and cap of the straight segments that rows (n, 6) with steps ds (n - 1,) are made of."""
    kept = ds > 0
    if not np.any(kept):
        return []
    numbers = (np.flatnonzero(kept) + 1).tolist()
    ends, ds, cap = pose[1:][kept], ds[kept], cap[kept]
    slope = np.diff(np.concatenate([pose[:1], ends]), axis=0) / ds[:, None]
    near = _STRAIGHT * max(1.0, float(np.max(np.abs(slope)))) + 1e-13 / ds  # rounding of a pose over a short row
    out: list[tuple[float, int, float]] = []
    first = 0
    for k in range(1, len(ds) + 1):
        if k < len(ds) and cap[k] == cap[first] and np.max(np.abs(slope[k] - slope[first])) <= near[k] + near[first]:
            continue
        out.append((float(np.sum(ds[first:k])), numbers[k - 1], float(cap[first])))
        first = k
    return out
