"""The axes of a log and the limits in force, from a robot's name or a cell file."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.limits import JointLimits
from trajopt_cli.units import slides

_ANYWHERE = 200.0  # m: what a rail's stroke is only the cell file knows


def limits_in_force(robot: str | None, cell: Path | None) -> tuple[JointLimits, str]:
    """Limits of all axes in the robot's order, and where they come from, in words.

    Raises InputError where neither or both are named, and as loading them does.
    """
    if (robot is None) == (cell is None):
        raise InputError(
            "say whose axes these are: by --robot NAME ('trajopt robot list') or by --cell FILE.yaml, one of them"
        )
    if cell is not None:
        from trajopt_cli.cell.loader import load_cell
        from trajopt_cli.problem.plant import build_plant

        return build_plant(load_cell(cell)).limits, str(cell)
    from trajopt_cli.robot.description import read
    from trajopt_cli.robot.model import Structure, load_robot
    from trajopt_cli.robot.srs import load_srs

    assert robot is not None
    data, _, _ = read(robot)
    model = load_srs(robot) if data.structure is Structure.SRS else load_robot(robot)
    limits, name = model.profile(), getattr(model, "default_profile", "default")
    rail = np.array([slides(one) for one in limits.names])
    lower, upper = np.where(rail, -_ANYWHERE, limits.lower), np.where(rail, _ANYWHERE, limits.upper)
    return replace(limits, lower=lower, upper=upper), f"{data.name}, profile {name}"
