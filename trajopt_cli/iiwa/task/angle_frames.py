"""The same sequence with its angles counted from the start's orientation, or from the world's axes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.angles import angles_of, continuous
from trajopt_cli.iiwa.task.equilibrium import Equilibrium
from trajopt_cli.iiwa.task.model import BETA_LIMIT, AngleMeaning, RotationLaw


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
