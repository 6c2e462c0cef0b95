"""The equilibrium sequence: one pose every period, what the compliant controller is fed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.angles import angles_of, continuous
from trajopt_cli.iiwa.task.model import BETA_LIMIT, AngleMeaning, Change, RotationLaw


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

    def timed(self, changes: Sequence[Change]) -> tuple[Change, ...]:
        """Changes with the times at which the sequence arrives at their poses; others as they are."""
        arrived = {piece.goal: piece.last * self.h for piece in self.pieces if not piece.dwell}
        arrived[self.pieces[0].origin] = 0.0
        return tuple(one if one.pose is None else replace(one, t=arrived[one.pose]) for one in changes)

    def rotations(self, R_start: Array) -> Array:
        """Orientations R_WT (n, 3, 3) of the tool in the world, of a controller switched on at R_start (3, 3)."""
        return self.R @ R_start if self.meaning is AngleMeaning.RELATIVE else self.R


@of_kind(ErrorKind.PROGRAM)
def counted(equilibrium: Equilibrium, meaning: AngleMeaning, R_start: Array) -> Equilibrium:
    """equilibrium with its angles in this meaning; R_start (3, 3): the tool's orientation where it is switched on.

    Raises InputError where an angle beta then passes its limit (but for slerp, which has none).
    """
    if meaning is equilibrium.meaning:
        return equilibrium
    R = equilibrium.rotations(R_start)
    if meaning is AngleMeaning.RELATIVE:
        R = R @ R_start.T
    angles = continuous(angles_of(R))
    if equilibrium.rotation is RotationLaw.TAIT_BRYAN:
        worst = int(np.argmax(np.abs(angles[:, 1])))
        if abs(angles[worst, 1]) > BETA_LIMIT:
            piece = next(piece for piece in equilibrium.pieces if piece.first <= worst <= piece.last)
            raise InputError(
                f"angles: counted {meaning.value}, beta is {np.degrees(angles[worst, 1]):.4g}° at"
                f" {worst * equilibrium.h:.3f} s between {piece.origin} and {piece.goal}, limit"
                f" {np.degrees(BETA_LIMIT):g}°; turn the start or use 'rotation: slerp'"
            )
    return replace(equilibrium, pose=np.column_stack([equilibrium.pose[:, :3], angles]), R=R, meaning=meaning)
