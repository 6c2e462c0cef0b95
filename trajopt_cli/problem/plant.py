"""The machine a program runs on: robot mounted in the cell, limits in force, and what the user lets change."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from trajopt_cli.cell.model import Cell
from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, readonly
from trajopt_cli.limits import JointLimits, TcpCaps
from trajopt_cli.motion import ExternalAxes
from trajopt_cli.robot.layout import AxisLayout
from trajopt_cli.robot.model import RobotModel, load_robot
from trajopt_cli.shapes import ATTACHED, MeshFile, Solid
from trajopt_cli.units import DEG, MM
from trajopt_cli.validation import hint


@dataclass(frozen=True, eq=False)
class Plant:
    """robot: mounted, its rail (if any) placed in the world. limits: of all axes in robot.axis_names order.

    start (k,): where the cycle begins, at rest. rail_eax: which eax_x drives the rail (0 for eax_a), None without
    a rail. rail_fixed: robtargets keep their programmed rail value. free_speed: MoveJ and MoveAbsJ may ignore the
    programmed speed. droppable: target names (lower case) the cell file lets the plan leave out. notes: how sure the
    limits are, one line each. obstacles: in the world, attached: in the flange frame, all meshes loaded. may_touch:
    pairs of links, or of a link and an attached body, that are not held against each other. clearance: the least
    distance wanted between the robot and an obstacle [m].
    """

    robot: RobotModel
    limits: JointLimits
    tcp: TcpCaps
    start: Array
    rail_eax: int | None
    rail_fixed: bool
    free_speed: bool
    droppable: frozenset[str]
    notes: tuple[str, ...] = ()
    obstacles: tuple[Solid, ...] = ()
    attached: tuple[Solid, ...] = ()
    may_touch: frozenset[frozenset[str]] = frozenset()
    clearance: float = 0.0

    @property
    def layout(self) -> AxisLayout:
        """Where the rail and the arm's joints stand in vectors of all axes."""
        return self.robot.layout

    @property
    def self_pairs(self) -> tuple[tuple[str, str], ...]:
        """Links, and links with attached bodies, that are held against each other; the one nearer the base first."""
        pairs = []
        for first, second in self.robot.self_pairs:
            carried = [solid.name for solid in self.attached if first not in solid.ignore]
            pairs += [(first, name) for name in (carried if second == ATTACHED else [second])]
        return tuple(pair for pair in pairs if frozenset(pair) not in self.may_touch)

    @property
    def unchecked(self) -> tuple[str, ...]:
        """What no judge can look at here and why, one line each: "obstacles not checked: ..."."""
        out = []
        bodies = bool(self.robot.capsules or self.attached)
        if not self.obstacles:
            out.append("obstacles not checked: the cell file gives none")
        elif not bodies:
            out.append(f"obstacles not checked: robot {self.robot.name} has no collision shapes")
        if not self.robot.self_pairs:
            out.append(f"self-collision not checked: robot {self.robot.name} has no collision shapes")
        elif not self.self_pairs:
            out.append("self-collision not checked: the cell file lets every pair touch")
        return tuple(out)

    def rail_value(self, extax: ExternalAxes) -> float | None:
        """The rail position [m] that external axes in RAPID units ask for; None when they leave it open."""
        if self.rail_eax is None:
            return None
        value = extax[self.rail_eax]
        return None if value is None else value * MM


def build_plant(cell: Cell) -> Plant:
    """Mount the cell's robot and put its limits in force.

    Raises InputError, placed in the cell file, for an unknown robot, profile or axis, a rail that is missing or too
    much, a limit nobody gave, a start that has the wrong length or lies outside the limits, a body named like a link,
    a link that may touch a body and does not exist, a pair that may touch and is none, and a mesh file that is missing
    or broken.
    """
    robot = _robot(cell)
    if robot.has_rail and cell.rail is None:
        raise cell.error(
            "rail", f"robot {robot.name} rides a rail: add 'rail: {{eax: a, stroke: [0, 2]}}', stroke in m"
        )
    if cell.rail is not None and not robot.has_rail:
        raise cell.error("rail", f"robot {robot.name} has no rail: remove the section")
    if cell.profile not in robot.profiles:
        raise cell.error(
            "profile", f"robot {robot.name} has no '{cell.profile}'; {hint(cell.profile, [*robot.profiles])}"
        )
    limits = cell.apply_limits(robot.profile(cell.profile), robot.axis_names)
    plant = Plant(
        robot=robot,
        limits=limits,
        tcp=cell.tcp or robot.tcp,
        start=_start(cell, limits),
        rail_eax=cell.rail.eax if cell.rail else None,
        rail_fixed=bool(cell.rail and cell.rail.fixed),
        free_speed=cell.free_speed,
        droppable=cell.droppable,
        notes=_notes(cell, robot, limits),
        obstacles=_solids(cell, robot, "obstacles"),
        attached=_solids(cell, robot, "attached"),
        clearance=cell.clearance,
    )
    return replace(plant, may_touch=_may_touch(cell, plant))


def _robot(cell: Cell) -> RobotModel:
    try:
        return load_robot(cell.robot, X_WR=cell.rail.X_WR if cell.rail else cell.X_WB)
    except InputError as error:
        if error.file is not None:  # a mistake in the robot's own file has its place there
            raise
        raise cell.error("robot", error.message) from error


def _start(cell: Cell, limits: JointLimits) -> Array:
    rail = [] if cell.start_rail is None else [cell.start_rail]
    wanted = len(limits.names) - len(rail)
    if len(cell.start_joints) != wanted:
        raise cell.error("start.joints", f"robot {cell.robot} has {wanted} joints, not {len(cell.start_joints)}")
    start = np.array([*rail, *cell.start_joints])
    for name, value, low, high in zip(limits.names, start, limits.lower, limits.upper, strict=True):
        if not low <= value <= high:
            key = "start.rail" if name == "rail" else "start.joints"
            metres = name == "rail" and low <= value / 1e3 <= high
            hint = f"; if this is in millimetres, write {value / 1e3:g} or {value:g} mm" if metres else ""
            if name != "rail" and abs(value) > 2 * np.pi and low <= value * DEG <= high:
                hint = f'; if this is in degrees, write "{value:g} deg"'
            raise cell.error(key, f"{name} = {value:.6g} lies outside its range {low:.6g}..{high:.6g}{hint}")
    return readonly(start)


def _may_touch(cell: Cell, plant: Plant) -> frozenset[frozenset[str]]:
    """The cell's pairs, each held against those that are checked without it."""
    for i, given in enumerate(cell.may_touch):
        if set(given) not in [set(pair) for pair in plant.self_pairs]:
            known = ", ".join(f"[{', '.join(pair)}]" for pair in plant.self_pairs)
            raise cell.error(f"may_touch.{i}", f"[{', '.join(given)}] is not a pair that is checked; known: {known}")
    return frozenset(frozenset(given) for given in cell.may_touch)


def _solids(cell: Cell, robot: RobotModel, section: str) -> tuple[Solid, ...]:
    """The section's solids with their meshes loaded."""
    given: tuple[Solid, ...] = getattr(cell, section)
    return tuple(_solid(cell, robot, section, solid) for solid in given)


def _solid(cell: Cell, robot: RobotModel, section: str, solid: Solid) -> Solid:
    key = f"{section}.{solid.name}"
    if solid.name in (*robot.link_names, ATTACHED):
        raise cell.error(key, f"robot {robot.name} has a link of this name; give the body another name")
    carried = () if section == "attached" else tuple(other.name for other in cell.attached)
    known = (*robot.capsules, *carried)
    for name in sorted(solid.ignore):
        if name not in known:
            raise cell.error(f"{key}.ignore", f"'{name}' cannot touch it; {hint(name, known)}")
    if not isinstance(solid.shape, MeshFile):
        return solid
    from trajopt_cli.collision.meshes import load_mesh

    try:
        return Solid(load_mesh(solid.shape), solid.ignore)
    except InputError as error:
        raise cell.error(f"{key}.mesh.file", error.message) from error


def _notes(cell: Cell, robot: RobotModel, limits: JointLimits) -> tuple[str, ...]:
    """How sure the limits are: estimated accelerations with their grade, TCP caps with their source."""
    graded = {axis: limits.grades.get(f"{axis}.acceleration", "") for axis in limits.names}
    estimated = {axis: grade for axis, grade in graded.items() if grade in ("C", "D")}
    notes = []
    if estimated:
        about = robot.notes[f"profiles.{cell.profile}"]
        notes.append(
            f"accelerations of {', '.join(estimated)} are estimates of grade {max(estimated.values())} "
            f"(profile {cell.profile}: {about}); a measured value belongs in {cell.file}"
        )
    caps = cell.tcp or robot.tcp
    source = cell.tcp_source or f"{robot.notes['tcp.speed']}, the robot's documented cap"
    notes.append(f"TCP caps {caps.speed:g} m/s and {caps.acceleration:g} m/s²: {source}")
    return tuple(notes)
