"""The machine a program runs on: robot mounted in the cell, limits in force, and what the user lets change."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from trajopt_cli import settings as defaults
from trajopt_cli.cell.model import CarrierAxis, Cell
from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, inverse_pose, pose, readonly, rotation_about, rotation_from_wxyz
from trajopt_cli.limits import JointLimits, TcpCaps
from trajopt_cli.motion import ExternalAxes
from trajopt_cli.robot.base_axes import BaseAxis, on_axes, turned
from trajopt_cli.robot.layout import AxisLayout
from trajopt_cli.robot.model import RobotModel, load_robot, robot_names
from trajopt_cli.robot.structure import NO_CONFDATA
from trajopt_cli.scenario import Follower, PositionerAxis
from trajopt_cli.settings import Settings
from trajopt_cli.shapes import ATTACHED, TOOL, Box, Grip, MeshFile, Solid, moved
from trajopt_cli.trajectory import Trajectory
from trajopt_cli.units import DEG, MM, slides
from trajopt_cli.validation import hint
from trajopt_cli.warnings import ProgramWarning, WarningKind

TRACK = "track"
"""The name of the rail's body."""

OVERHANG = 0.25
"""m: how far a rail reaches beyond its stroke at each end; half a carriage."""


def shown_rail(d: Array, form: str = ".6g") -> str:
    """Rail positions (r,) as mm: "400 mm", "[400, 200, 50] mm"."""
    each = ", ".join("open" if np.isnan(value) else f"{value / MM:{form}}" for value in np.ravel(d))
    return f"{each} mm" if np.size(d) == 1 else f"[{each}] mm"


@dataclass(frozen=True, eq=False)
class Plant:
    """robot: mounted, its rail (if any) placed in the world. limits: of all axes in robot.axis_names order.

    start (k,): where the cycle begins, at rest; home (k,): where the program does, None for the same. rail_eaxes: which
    eax_x drive the rails (0 for eax_a). followers: external axes that these lead. rail_fixed: robtargets keep their
    programmed rail value. free_speed: MoveJ and MoveAbsJ may ignore the programmed speed. droppable: target names
    (lower case) the cell file lets the plan leave out. notes: how sure the limits are, one line each. obstacles: in the
    world, attached: in the flange frame, all meshes loaded. may_touch: pairs of links, or of a link and an attached
    body, that are not held against each other. clearance: the least distance wanted between the robot and an obstacle
    [m]. tool_radius [m]: of the capsule from flange to TCP that stands for the tool of each motion; 0 for none, as
    where something is attached. grips: which obstacles the flange takes and leaves, and when. See
    problem.collision_objects. units: positioners by name, in lower case. settings: the planner's chosen numbers.
    """

    robot: RobotModel
    limits: JointLimits
    tcp: TcpCaps
    start: Array
    rail_eaxes: tuple[int, ...]
    rail_fixed: bool
    free_speed: bool
    droppable: frozenset[str]
    notes: tuple[str, ...] = ()
    obstacles: tuple[Solid, ...] = ()
    attached: tuple[Solid, ...] = ()
    may_touch: frozenset[frozenset[str]] = frozenset()
    clearance: float = 0.0
    tool_radius: float = 0.0
    grips: tuple[Grip, ...] = ()
    units: Mapping[str, tuple[PositionerAxis, ...]] = field(default_factory=dict)
    settings: Settings = field(default_factory=lambda: defaults.DEFAULT)
    home: Array | None = None
    followers: tuple[Follower, ...] = ()

    @property
    def at_home(self) -> Plant:
        """The plant as the program finds it when it is started."""
        return self if self.home is None else replace(self, start=self.home, home=None)

    @property
    def layout(self) -> AxisLayout:
        """Where the rail and the arm's joints stand in vectors of all axes."""
        return self.robot.layout

    @property
    def self_pairs(self) -> tuple[tuple[str, str], ...]:
        """Links, and links with what the flange may carry, that are held against each other; the one nearer the base
        first. A pair counts while its body is carried."""
        pairs = []
        for first, second in self.robot.self_pairs:
            carried = [solid.name for solid in self.attached if first not in solid.ignore]
            carried += [TOOL] if self.tool_radius > 0 else []
            carried += [part.name for part in self.parts if first not in part.ignore]
            pairs += [(first, name) for name in (carried if second == ATTACHED else [second])]
        return tuple(pair for pair in pairs if frozenset(pair) not in self.may_touch)

    @property
    def parts(self) -> tuple[Solid, ...]:
        """The obstacles that the flange takes on the way."""
        taken = {grip.part for grip in self.grips}
        return tuple(solid for solid in self.obstacles if solid.name in taken)

    @property
    def turning(self) -> frozenset[int]:
        """External axes of positioners, 0 for eax_a."""
        return frozenset(axis.eax for axes in self.units.values() for axis in axes)

    def stands(self, solid: Solid, at: Mapping[tuple[str, int], float]) -> Array:
        """How a solid has moved (4, 4) in the world since the start, with axes of units, 0 for eax_a, at [rad]."""
        if solid.rides is None:
            return np.eye(4)
        unit, many = solid.rides
        axes = self.units[unit][:many]
        now = [at.get((unit, axis.eax), axis.start) for axis in axes]
        return carried_by(axes, now) @ inverse_pose(carried_by(axes, [axis.start for axis in axes]))

    @property
    def angle_unchecked(self) -> tuple[str, ...]:
        """A line where a parallel linkage comes without the range of the angle between lower and upper arm."""
        arms = {*self.robot.axis_names[self.layout.arm][1:3]}
        if not self.robot.linkage or arms in [{*one.axes} for one in self.limits.coupled]:
            return ()
        return (f"angle between the arms not checked: robot {self.robot.name} gives no range of it (coupled)",)

    @property
    def unchecked(self) -> tuple[str, ...]:
        """What no judge can look at here and why, one line each: "obstacles not checked: ..."."""
        out = []
        if self.robot.confdata_rule == NO_CONFDATA:
            out.append(f"confdata not checked: robot {self.robot.name} has no rule for it")
        out += self.angle_unchecked
        if not (self.robot.bodies or self.attached):
            return (*out, f"collisions not checked: robot {self.robot.name} has no bodies")
        if bare := [name for name in self.robot.link_names if name not in self.robot.bodies]:
            out.append(f"collisions of {', '.join(bare)} not checked: robot {self.robot.name} has no bodies for them")
        if not self.obstacles:
            out.append("obstacles not checked: the cell file gives none")
        if not self.robot.self_pairs:
            out.append(f"self-collision not checked: robot {self.robot.name} has no bodies")
        elif not self.self_pairs:
            out.append("self-collision not checked: the cell file lets every pair touch")
        return tuple(out)

    @property
    def driven_eaxes(self) -> tuple[int, ...]:
        """The external axes that rails and what follows them are driven by, 0 for eax_a."""
        return (*self.rail_eaxes, *(one.eax for one in self.followers))

    def asks_rail(self, extax: ExternalAxes) -> bool:
        """Whether external axes say where some rail is to be."""
        return any(extax[eax] is not None for eax in self.rail_eaxes)

    def rail_value(self, extax: ExternalAxes) -> Array | None:
        """The rails' positions (r,) [m] that external axes in RAPID units ask for, NaN where one is left open; None
        where all are, and without a rail."""
        if not self.asks_rail(extax):
            return None
        values = [extax[eax] for eax in self.rail_eaxes]
        return np.array([np.nan if value is None else value * MM for value in values])

    def rail_after(self, extax: ExternalAxes, before: Array) -> Array:
        """The rails' positions (r,) [m] behind a motion: those that its external axes ask for, else those before it."""
        given = self.rail_value(extax)
        return before if given is None else np.where(np.isnan(given), before, given)

    def with_rail(self, extax: ExternalAxes, d: Array) -> ExternalAxes:
        """External axes in RAPID units with the rails at d (r,) [m], and what follows them."""
        values = list(extax)
        for eax, value in zip(self.rail_eaxes, d.tolist(), strict=True):
            values[eax] = value / MM
        for one in self.followers:
            values[one.eax] = (values[one.leader] or 0.0) * one.ratio + one.offset / MM
        a, b, c, d_, e, f = values
        return a, b, c, d_, e, f

    def with_followers(self, rows: Trajectory) -> Trajectory:
        """Rows of the robot's axes with a column for each axis that another leads, behind that one's."""
        for one in self.followers:
            names, q, qd = rows.names, rows.q, rows.qd
            i = names.index(self.limits.names[self.rail_eaxes.index(one.leader)])
            q = np.insert(q, i + 1, one.ratio * q[:, i] + one.offset, axis=1)
            qd = None if qd is None else np.insert(qd, i + 1, one.ratio * qd[:, i], axis=1)
            rows = replace(rows, names=(*names[: i + 1], one.column, *names[i + 1 :]), q=q, qd=qd)
        return rows

    def at_rail(self, d: Array) -> str:
        """Where rails stand (r,), in words behind a sentence; empty without one."""
        return f" with the rail at {shown_rail(d)}" if self.rail_eaxes else ""


def carried_by(axes: Sequence[PositionerAxis], at: Sequence[float]) -> Array:
    """The frame (4, 4) in the world that the last of a positioner's axes carries, the axes at [rad or m]."""
    X = np.eye(4)
    for axis, angle in zip(axes, at, strict=True):
        X = X @ pose(rotation_from_wxyz(np.array(axis.q)), axis.p)
        X = X @ (pose(np.eye(3), [0, 0, angle]) if axis.slides else pose(rotation_about([0, 0, 1], angle), np.zeros(3)))
    return X


def build_plant(cell: Cell) -> Plant:
    """Mount the cell's robot and put its limits in force.

    Raises InputError, placed in the cell file, for an unknown robot, profile or axis, a rail that is missing or too
    much, a limit nobody gave, a start that has the wrong length or lies outside the limits, a body named like a link,
    a link that may touch a body and does not exist, a pair that may touch and is none, and a mesh file that is missing
    or broken.
    """
    robot = _robot(cell)
    if robot.has_rail and cell.rail is None and not cell.axes:
        raise cell.error(
            "rail", f"robot {robot.name} rides a rail: add 'rail: {{eax: a, stroke: [0, 2]}}', stroke in m"
        )
    if cell.rail is not None and not robot.has_rail:
        railed = f"{robot.name}_rail"
        other = f"write 'robot: {railed}' for the one on a rail, or " if railed in robot_names() else ""
        raise cell.error("rail", f"robot {robot.name} has no rail: {other}remove the section")
    if robot.profile_name(cell.profile) not in robot.profiles:
        raise cell.error(
            "profile", f"robot {robot.name} has no '{cell.profile}'; {hint(cell.profile, [*robot.profiles])}"
        )
    limits = cell.apply_limits(robot.profile(cell.profile), robot.axis_names)
    if cell.torque_limits and robot.linkage:
        text = f"robot {robot.name} has a parallel linkage, whose levers' masses are not known"
        raise cell.error("torque_limits", f"{text}; leave torque_limits out")
    if cell.torque_limits and (lacks := robot.lacks_for_torques(limits.torque)):
        raise cell.error(
            "torque_limits",
            f"robot {robot.name} lacks {', '.join(lacks)}; give each link an <inertial> in its URDF, and each joint an"
            " effort there with its source in the robot's file or a torque under limits",
        )
    plant = Plant(
        robot=robot,
        limits=limits,
        tcp=cell.tcp or robot.tcp,
        start=_start(cell, limits),
        rail_eaxes=(cell.rail.eax,) if cell.rail else tuple(axis.eax for axis in cell.axes),
        followers=cell.followers,
        rail_fixed=bool(cell.rail and cell.rail.fixed),
        free_speed=cell.free_speed,
        droppable=cell.droppable,
        notes=_notes(cell, robot, limits),
        obstacles=(*_solids(cell, robot, "obstacles"), *_track(cell, robot)),
        attached=_solids(cell, robot, "attached"),
        clearance=cell.clearance,
        tool_radius=0.0 if cell.attached else cell.tool_radius,
        grips=cell.grips,
        units=cell.scenario.positioners,
    )
    return replace(plant, may_touch=_may_touch(cell, plant))


def unwatched(cell: Cell, robot: RobotModel) -> tuple[ProgramWarning, ...]:
    """What is told first: obstacles that a robot, or some of its links, are not held against for want of shapes."""
    bare = [name for name in robot.link_names if name not in robot.bodies]
    if not cell.obstacles or not bare:
        return ()
    many = len(cell.obstacles)
    if robot.bodies:
        text = (
            f"{', '.join(bare)} of {robot.name} {'have' if len(bare) > 1 else 'has'} no collision shape and may touch "
            "anything unseen; give bodies in the robot's file (collision.links)"
        )
        return (ProgramWarning(WarningKind.NOT_CHECKED, text, cell.file),)
    text = (
        f"collisions of the robot are not checked: {robot.name} has no collision shapes, and the cell gives {many} "
        f"obstacle{'s' if many > 1 else ''}; give the robot's links bodies in its file (collision.links)"
    )
    return (ProgramWarning(WarningKind.NOT_CHECKED, text, cell.file),)


def _robot(cell: Cell) -> RobotModel:
    try:
        robot = load_robot(cell.robot, X_WR=cell.rail.X_WR if cell.rail else cell.X_WB)
        if cell.rail is not None and cell.rail.direction is not None and robot.has_rail:
            return turned(robot, np.array(cell.rail.direction))
        return on_axes(robot, [_base_axis(axis) for axis in cell.axes], cell.X_WB) if cell.axes else robot
    except InputError as error:
        if error.file is not None:  # a mistake in the robot's own file has its place there
            raise
        raise cell.error("robot", error.message) from error


def _base_axis(axis: CarrierAxis) -> BaseAxis:
    rates = axis.velocity, axis.acceleration, axis.jerk
    return BaseAxis(axis.name, np.array(axis.direction), *axis.stroke, *rates, axis.source)


def _start(cell: Cell, limits: JointLimits) -> Array:
    rail = cell.start_rail
    wanted = len(limits.names) - len(rail)
    if len(cell.start_joints) != wanted:
        raise cell.error("start.joints", f"robot {cell.robot} has {wanted} joints, not {len(cell.start_joints)}")
    start = np.array([*rail, *cell.start_joints])
    for name, value, low, high in zip(limits.names, start, limits.lower, limits.upper, strict=True):
        if not low <= value <= high:
            key = "start.rail" if slides(name) else "start.joints"
            metres = slides(name) and low <= value / 1e3 <= high
            hint = f"; if this is in millimetres, write {value / 1e3:g} or {value:g} mm" if metres else ""
            if not slides(name) and abs(value) > 2 * np.pi and low <= value * DEG <= high:
                hint = f'; if this is in degrees, write "{value:g} deg"'
            raise cell.error(key, f"{name} = {value:.6g} lies outside its range {low:.6g}..{high:.6g}{hint}")
    for one, value in zip(limits.coupled, limits.couplings.rows @ start, strict=True):
        if not one.lower <= value <= one.upper:
            text = f"{one.name} = {value:.6g} lies outside its range {one.lower:.6g}..{one.upper:.6g}"
            raise cell.error("start.joints", text)
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


def _track(cell: Cell, robot: RobotModel) -> tuple[Solid, ...]:
    """The rail's beam, its top where the base stands; only the base may touch it."""
    if cell.rail is None or cell.rail.track is None:
        return ()
    if TRACK in {solid.name for solid in (*cell.obstacles, *cell.attached)}:
        raise cell.error("rail.track", f"an obstacle is named '{TRACK}', which is the name of this body; rename it")
    along, (width, height), (low, high) = robot.rail_axes_W[0], cell.rail.track, cell.rail.stroke
    up = robot.X_WB0[:3, 2] - (robot.X_WB0[:3, 2] @ along) * along
    if np.linalg.norm(up) < 0.1:
        raise cell.error("rail.track", "the base does not stand on the rail; give the rail's body under obstacles")
    up = up / np.linalg.norm(up)
    R = np.column_stack([along, np.cross(up, along), up])
    middle = robot.X_WB0[:3, 3] + along * (low + high) / 2 - up * height / 2
    size = np.array([high - low + 2 * OVERHANG, width, height])
    return (Solid(Box(TRACK, size, pose(R, middle)), frozenset({robot.link_names[0]})),)


def _solid(cell: Cell, robot: RobotModel, section: str, solid: Solid) -> Solid:
    key = f"{section}.{solid.name}"
    if solid.name in (*robot.link_names, ATTACHED):
        raise cell.error(key, f"robot {robot.name} has a link of this name; give the body another name")
    if solid.name == TOOL and not (section == "attached" or cell.attached):
        raise cell.error(key, "this is the name of the capsule around the tool; give the body another name")
    carried = () if section == "attached" else tuple(other.name for other in cell.attached) or (TOOL,)
    taken = () if section == "attached" else tuple(grip.part for grip in cell.grips)
    beside = [one.name for one in cell.obstacles if one.name != solid.name and (one.rides or solid.rides)]
    known = (*robot.bodies, *carried, *dict.fromkeys((*taken, *beside)))
    for name in sorted(solid.ignore):
        if name not in known:
            raise cell.error(f"{key}.ignore", f"'{name}' cannot touch it; {hint(name, known)}")
    shape = solid.shape
    if isinstance(shape, MeshFile):
        from trajopt_cli.proximity.meshes import load_mesh

        try:
            shape = load_mesh(shape)
        except InputError as error:
            own, many, _ = solid.name.partition("/")
            raise cell.error(f"{section}.{own}{'' if many else '.mesh.file'}", error.message) from error
    if solid.rides is not None:
        axes = cell.scenario.positioners[solid.rides.unit][: solid.rides.axes]
        shape = moved(shape, carried_by(axes, [axis.start for axis in axes]))
    return replace(solid, shape=shape)


def _notes(cell: Cell, robot: RobotModel, limits: JointLimits) -> tuple[str, ...]:
    """How sure the limits are: estimated speeds and accelerations with their grade, TCP caps with their source."""
    notes = []
    for key, what in (("velocity", "speeds"), ("acceleration", "accelerations")):
        graded = {axis: limits.grades.get(f"{axis}.{key}", "") for axis in limits.names}
        estimated = {axis: grade for axis, grade in graded.items() if grade in ("C", "D")}
        if estimated:
            name = robot.profile_name(cell.profile)
            of_profile = what != "speeds" and not all(map(slides, estimated))
            about = f" (profile {name}: {robot.notes[f'profiles.{name}']})" if of_profile else ""
            notes.append(
                f"{what} of {', '.join(estimated)} are estimates of grade {max(estimated.values())}{about}; "
                f"a measured value belongs in {cell.file}"
            )
    caps = cell.tcp or robot.tcp
    source = cell.tcp_source or f"{robot.notes['tcp.speed']}, as the robot's file has it"
    notes.append(f"TCP caps {caps.speed:g} m/s and {caps.acceleration:g} m/s²: {source}")
    return tuple(notes)
