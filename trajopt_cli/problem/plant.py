"""The machine a program runs on: robot mounted in the cell, limits in force, and what the user lets change."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trajopt_cli.cell.model import Cell
from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.limits import JointLimits, TcpCaps
from trajopt_cli.motion import ExternalAxes
from trajopt_cli.robot.model import RobotModel, load_robot
from trajopt_cli.units import MM


@dataclass(frozen=True, eq=False)
class Plant:
    """robot: mounted, its rail (if any) placed in the world. limits: of all axes in robot.axis_names order.

    start (k,): where the cycle begins, at rest. rail_eax: which eax_x drives the rail (0 for eax_a), None without
    a rail. rail_fixed: robtargets keep their programmed rail value. free_speed: MoveJ and MoveAbsJ may ignore the
    programmed speed. droppable: target names (lower case) the cell file lets the plan leave out.
    """

    robot: RobotModel
    limits: JointLimits
    tcp: TcpCaps
    start: Array
    rail_eax: int | None
    rail_fixed: bool
    free_speed: bool
    droppable: frozenset[str]

    def rail_value(self, extax: ExternalAxes) -> float | None:
        """The rail position [m] that external axes in RAPID units ask for; None when they leave it open."""
        if self.rail_eax is None:
            return None
        value = extax[self.rail_eax]
        return None if value is None else value * MM


def build_plant(cell: Cell) -> Plant:
    """Mount the cell's robot and put its limits in force. Raises InputError for a missing limit or a bad start."""
    robot = load_robot(cell.robot, X_WR=cell.rail.X_WR if cell.rail else cell.X_WB)
    if robot.has_rail and cell.rail is None:
        raise InputError(f"robot {robot.name} rides a rail: add a 'rail:' section with stroke and eax", file=cell.file)
    if cell.rail is not None and not robot.has_rail:
        raise InputError(f"robot {robot.name} has no rail: remove the 'rail:' section", file=cell.file)
    limits = cell.apply_limits(robot.profile(cell.profile), robot.axis_names)
    start = np.asarray(([cell.start_rail] if robot.has_rail else []) + list(cell.start_joints))
    for name, value, low, high in zip(limits.names, start, limits.lower, limits.upper, strict=True):
        if not low <= value <= high:
            raise InputError(
                f"start: {name} = {value:.6g} lies outside its range {low:.6g}..{high:.6g}", file=cell.file
            )
    return Plant(
        robot=robot,
        limits=limits,
        tcp=cell.tcp,
        start=start,
        rail_eax=cell.rail.eax if cell.rail else None,
        rail_fixed=bool(cell.rail and cell.rail.fixed),
        free_speed=cell.free_speed,
        droppable=cell.droppable,
    )
