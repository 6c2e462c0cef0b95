"""The equilibrium sequence: one pose every period, what the compliant controller is fed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.model import AngleMeaning, RotationLaw


@dataclass(frozen=True)
class Piece:
    """Rows first..last (both included) from one waypoint to the next, or standing at one (dwell)."""

    first: int
    last: int
    origin: str
    goal: str
    dwell: bool = False


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """Poses (n, 6) at times 0, h, 2 h, ...: position [m] in W and Tait-Bryan angles [rad] that never jump.

    meaning: whether the angles count from R_start. R (n, 3, 3): the same orientations as matrices, R_WT = R R_start or
    R_WT = R after meaning; the angles follow from them where rotation is slerp, they from the angles elsewhere.
    pieces: which rows belong to which segment; neighbours share a row. notes: what the user should know.
    """

    h: float
    pose: Array
    R: Array
    rotation: RotationLaw
    meaning: AngleMeaning
    pieces: tuple[Piece, ...]
    notes: tuple[str, ...] = ()

    @property
    def t(self) -> Array:
        """Times (n,) [s]."""
        return np.asarray(np.arange(len(self.pose)) * self.h, dtype=np.float64)

    @property
    def duration(self) -> float:
        """Time of the last row [s]."""
        return (len(self.pose) - 1) * self.h

    def rotations(self, R_start: Array) -> Array:
        """Orientations R_WT (n, 3, 3) of the tool in the world, of a controller switched on at R_start (3, 3)."""
        return self.R @ R_start if self.meaning is AngleMeaning.RELATIVE else self.R
