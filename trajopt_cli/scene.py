"""One scene for page, glTF and pictures: the robot's chain of frames, bodies fixed to them, and motions over time.

Frame i of a chain is the one behind its i-th element, BASE the one before the first: X_WF = base · placement_1 ·
joint_1(q_1) · placement_2 · joint_2(q_2) ... Whoever draws takes poses from here or works them out by this rule.
Behind the chain come the frames of positioners' axes: how what they carry has moved since the start, parent · X ·
turn about z or shift along it · X^-1.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np

from trajopt_cli.geometry import Array, inverse_pose, pose, readonly, rotation_about
from trajopt_cli.motion import SLIDE, MoveAbsJ, PathMove, PoseMove, Program
from trajopt_cli.problem.collision_objects import bodies_on, tool_capsule
from trajopt_cli.problem.detours import unfolded, with_detours
from trajopt_cli.problem.plan import Plan
from trajopt_cli.problem.plant import Plant, carried_by
from trajopt_cli.robot.model import RobotModel
from trajopt_cli.robot.srs import SrsRobot
from trajopt_cli.shapes import Box, Capsule, Rides, Shape, moved
from trajopt_cli.trajectory import TABLE, Trajectory, hermite

BASE, WORLD = -1, -2
"""Frames that no element of the chain moves."""
LINK, TOOL_ROLE, OBSTACLE, RAIL, CARRIAGE, PART = "link", "tool", "obstacle", "rail", "carriage", "part"
_STEP = 2e-3  # s between rows: at 20 m/s² a straight line between them is 0.01 mm off
_MOST_ROWS = 20_000
_BEAM, _PLATE = (0.3, 0.1), (0.42, 0.03)  # m, width and height of a rail's beam and of the carriage's plate
_BONE = 0.035  # m, radius of a link of which no shape is known


@dataclass(frozen=True, eq=False)
class Joint:
    """An element of the chain: its axis' name and the link behind it. X (4, 4): its frame in the one before, at 0.
    kind: "revolute", "prismatic" or "fixed"; axis (3,) of it. less: of a parallel linkage, how many times the position
    of the axis before it is taken off its own."""

    name: str
    link: str
    X: Array
    kind: str
    axis: Array
    less: float = 0.0

    def moved(self, position: Array) -> Array:
        """Its frame in the one before (n, 4, 4) at positions (n,) [rad, m]."""
        out = np.repeat(self.X[None], len(position), axis=0)
        if self.kind == "prismatic":
            out[:, :3, 3] += position[:, None] * (self.X[:3, :3] @ self.axis)
        elif self.kind == "revolute":
            out[:, :3, :3] = self.X[:3, :3] @ rotation_about(self.axis, position)
        return out


@dataclass(frozen=True, eq=False)
class TableAxis:
    """A positioner's axis: unit, number from 0, external axis. parent: the frame it stands on. X (4, 4): where it is in
    the world at start, at which angle [rad], or place [m] where it slides."""

    unit: str
    number: int
    eax: int
    parent: int
    X: Array
    start: float
    slides: bool = False


@dataclass(frozen=True, eq=False)
class Body:
    """A shape, meshes loaded, in a frame of the chain or in the world. role: LINK, TOOL_ROLE, OBSTACLE, RAIL, CARRIAGE
    or PART. since, until [s]: when it is there, of a motion's start."""

    shape: Shape
    frame: int
    role: str
    since: float = 0.0
    until: float = math.inf


@dataclass(frozen=True, eq=False)
class Scene:
    """A robot in its cell. base (4, 4): where the chain begins in the world. bodies: that are there all the time.
    tables: the positioners' axes that carry bodies. colour: of the robot's paint, "#rrggbb", None where nobody says."""

    base: Array
    chain: tuple[Joint, ...]
    bodies: tuple[Body, ...]
    axes: tuple[str, ...]
    tables: tuple[TableAxis, ...] = ()
    colour: str | None = None

    @property
    def flange(self) -> int:
        """The frame behind the last element."""
        return len(self.chain) - 1

    def moved(self, q: Array) -> list[Array]:
        """Each frame's pose (n, 4, 4) in the one before it, at the robot's axes q (n, k) [rad, m]."""
        columns, before, out = iter(q.T), np.zeros(len(q)), []
        for joint in self.chain:
            if joint.kind == "fixed":
                out.append(np.broadcast_to(joint.X, (len(q), 4, 4)))
            else:
                position = next(columns)
                out.append(joint.moved(position - joint.less * before))
                before = position
        return out

    def poses(self, q: Array) -> Array:
        """The same in the world (n, len(chain), 4, 4)."""
        X, out = self.base, []
        for step in self.moved(q):
            out.append(X := X @ step)
        return np.stack(out, axis=1)


@dataclass(frozen=True)
class ScenePoint:
    """A point of the program: its name, position in the world [m], and place in the text ("line.mod:41"). added: the
    plan has added it on a way around obstacles."""

    name: str
    position: tuple[float, float, float]
    place: str = ""
    added: bool = False


@dataclass(frozen=True, eq=False)
class Cycle:
    """A motion of a scene. t (n,) [s] from 0; q (n, k) as the robot's axes [rad, m].

    tools: X_FT (4, 4) from a time [s] on, the first from the start. driven: from when to when [s] the tool is on lines
    and arcs; none for a motion that has no such parts. parts: bodies that are there for a time, WORLD or on the flange:
    what it takes and leaves, and the capsule that stands for the tool. turned (n, T) [rad or m]: the scene's tables,
    since the start; None for none.
    """

    name: str
    t: Array
    q: Array
    tools: tuple[tuple[float, Array], ...] = field(default_factory=lambda: ((0.0, np.eye(4)),))
    driven: tuple[tuple[float, float], ...] = ()
    parts: tuple[Body, ...] = ()
    turned: Array | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "t", readonly(self.t))
        object.__setattr__(self, "q", readonly(self.q))
        if self.t.ndim != 1 or self.q.ndim != 2 or len(self.t) != len(self.q) or not len(self.t):
            raise ValueError(f"cycle '{self.name}': t {self.t.shape} and q {self.q.shape}, wanted (n,) and (n, k)")


def scene_of_plant(plant: Plant, moving: Iterable[str] = ()) -> Scene:
    """A cell: robot, rails with carriages, obstacles, what the flange carries. moving: names of obstacles to leave out,
    because a cycle has them as parts."""
    left_out = set(moving)
    there = [solid for solid in plant.obstacles if solid.name not in left_out]
    obstacles = [solid.loaded for solid in there if solid.rides is None]
    scene = scene_of_robot(plant.robot, obstacles, [solid.loaded for solid in plant.attached], _strokes(plant))
    riding = [Body(one.loaded, table_frame(plant, one.rides), OBSTACLE) for one in there if one.rides is not None]
    return replace(scene, bodies=(*scene.bodies, *riding), tables=tables_of(plant))


def tables_of(plant: Plant) -> tuple[TableAxis, ...]:
    """The axes of the positioners that carry bodies; none where nothing rides."""
    riding = {solid.rides.unit for solid in plant.obstacles if solid.rides is not None}
    first, out = len(chain_of(plant.robot)), list[TableAxis]()
    for unit in sorted(riding):
        for i, axis in enumerate(plant.units[unit]):
            X = carried_by(plant.units[unit][: i + 1], [one.start for one in plant.units[unit][: i + 1]])
            parent = first + len(out) - 1 if i else WORLD
            out.append(TableAxis(unit, i, axis.eax, parent, X, axis.start, axis.slides))
    return tuple(out)


def table_frame(plant: Plant, rides: Rides) -> int:
    """The frame of what rides on a positioner."""
    found = [(one.unit, one.number + 1) for one in tables_of(plant)]
    return len(chain_of(plant.robot)) + found.index((rides.unit, rides.axes))


def turned_since(tables: Sequence[TableAxis], rows: Trajectory | None, n: int, program: Program | None = None) -> Array:
    """How far tables have turned (n, T) [rad] since the start, by the columns of rows; an axis without one stands where
    it does when a program begins."""
    before = [unit for motion in (program and program.before) or () for unit in getattr(motion, "units", ())]
    at = {(unit.unit, unit.eax): unit.end for unit in before}
    out = np.empty((n, len(tables)))
    for j, one in enumerate(tables):
        kind = SLIDE if one.slides else ""
        names = [f"{TABLE}{'abcdef'[one.eax]}{tail}{kind}" for tail in (f"_{one.unit}", "")]
        name = next((name for name in names if rows is not None and name in rows.names), None)
        angle = at.get((one.unit, one.eax), one.start)
        out[:, j] = (angle if name is None or rows is None else rows.q[:, rows.names.index(name)]) - one.start
    return out


def scene_of_robot(
    robot: RobotModel | SrsRobot,
    obstacles: Sequence[Shape] = (),
    carried: Sequence[Shape] = (),
    strokes: Array | Sequence[tuple[float, float]] = (),
) -> Scene:
    """Any robot. obstacles: shapes in the world, carried: in the flange frame. strokes (r, 2): lowest and highest
    positions of its rails [m], each of which is drawn on the carriage of the one before."""
    chain = chain_of(robot)
    frames = {robot.link_names[0]: BASE} | {joint.link: i for i, joint in enumerate(chain)}
    links = [Body(shape, frames[link], LINK) for link, shapes in robot.bodies.items() for shape in shapes]
    bodies = links or [*_bones(chain)]
    bodies += [Body(shape, len(chain) - 1, TOOL_ROLE) for shape in carried]
    bodies += [Body(shape, WORLD, OBSTACLE) for shape in obstacles]
    if isinstance(robot, RobotModel):
        for i, (beam, plate) in enumerate(_rails(robot, np.asarray(strokes))):
            if not any(one.name == "track" for one in obstacles):  # the cell says how large it is
                bodies.append(Body(beam, i - 1 if i else WORLD, RAIL))
            bodies.append(Body(plate, i, CARRIAGE))
    base = robot.X_WR if isinstance(robot, RobotModel) else robot.X_WB
    return Scene(base, chain, tuple(bodies), tuple(robot.axis_names), colour=robot.colour)


def chain_of(robot: RobotModel | SrsRobot) -> tuple[Joint, ...]:
    """The chain from the base to the flange."""
    out = []
    if isinstance(robot, RobotModel):
        for name, axis in zip(robot.axis_names, robot.rail_axes, strict=False):
            out.append(Joint(name, name, np.eye(4), "prismatic", axis))
        out.append(Joint(robot.link_names[0], robot.link_names[0], robot.X_RB, "fixed", np.zeros(3)))
    for joint in robot.chain:
        less = robot.linkage if isinstance(robot, RobotModel) and joint is robot.chain[2] else 0.0
        out.append(Joint(joint.name, joint.child, joint.X, joint.kind, np.asarray(joint.axis), less or 0.0))
    return tuple(out)


def plan_cycle(name: str, program: Program, plan: Plan, plant: Plant | None = None) -> Cycle:
    """A plan of a program as a cycle, with the tool in force at every time, and a plant's parts where they are then."""
    tools: list[tuple[float, Array]] = []
    capsules: list[tuple[float, Shape | None]] = []
    driven: list[tuple[float, float]] = []
    for planned in plan.motions:
        motion = program.motions[planned.index]
        if planned.dropped or not isinstance(motion, PoseMove | MoveAbsJ):
            continue
        if not tools or not np.array_equal(tools[-1][1], motion.tool.X_FT):
            tools.append((planned.t_0 if tools else 0.0, motion.tool.X_FT))
            solids = () if plant is None else tool_capsule(motion.tool, plant.tool_radius)
            capsules.append((tools[-1][0], solids[0].loaded if solids else None))
        if isinstance(motion, PathMove) and planned.t_1 > planned.t_0:
            if driven and driven[-1][1] == planned.t_0:
                driven[-1] = (driven[-1][0], planned.t_1)
            else:
                driven.append((planned.t_0, planned.t_1))
    k = len(plan.trajectory.names)
    t, q = _sampled(plan.trajectory.whole)
    q, rows = q[:, :k], q[:, k:]
    turned = None
    if plant is not None and (tables := tables_of(plant)):
        its = plan.trajectory.tables
        turned = turned_since(tables, None if its is None else Trajectory(its.names, t, rows), len(t), program)
    parts: tuple[Body, ...] = ()
    if plant is not None:
        flange = len(chain_of(plant.robot)) - 1
        parts = tuple(_parts(program, plan, plant, flange))
        for (since, shape), (until, _) in pairwise([*capsules, (math.inf, None)]):
            parts += () if shape is None else (Body(shape, flange, TOOL_ROLE, since, until),)
    return Cycle(name, t, q, tuple(tools) or ((0.0, np.eye(4)),), tuple(driven), parts, turned)


def program_points(program: Program, plan: Plan, plant: Plant) -> list[ScenePoint]:
    """The targets that a plan's moves lead to, as programmed, and the points it adds; each name at each position
    once."""
    program, plan = with_detours(program, plant, plan.detours), unfolded(plan)
    out: dict[tuple[str, tuple[float, ...]], ScenePoint] = {}
    for planned in plan.motions:
        motion = program.motions[planned.index]
        if planned.dropped or not isinstance(motion, PoseMove | MoveAbsJ):
            continue
        X_WT = motion.X_WT if not isinstance(motion, MoveAbsJ) else plant.robot.forward(planned.q_1) @ motion.tool.X_FT
        x, y, z = (round(float(value), 6) for value in X_WT[:3, 3])
        point = ScenePoint(motion.target, (x, y, z), str(motion.source), bool(motion.detour))
        out.setdefault((motion.target, (x, y, z)), point)
    return list(out.values())


def rail_ends(plant: Plant) -> Array:
    """Where the arm's base is with one rail after the other at both of its ends (2 r, 3) [m] in the world, the others
    where they start."""
    strokes = _strokes(plant)
    ends = np.tile(plant.start[plant.layout.rail], (len(strokes), 2, 1))
    for i, stroke in enumerate(strokes):
        ends[i, :, i] = stroke
    return np.asarray(plant.robot.X_WB0[:3, 3] + plant.robot.way_at(ends.reshape(2 * len(strokes), len(strokes))))


def _strokes(plant: Plant) -> Array:
    """Lowest and highest positions (r, 2) of the rails [m]."""
    return np.column_stack([plant.limits.lower, plant.limits.upper])[plant.layout.rail]


def _parts(program: Program, plan: Plan, plant: Plant, flange: int) -> Iterator[Body]:
    """Where the parts are, from change to change. A part that is taken at the end of a move moves with the next."""
    names = {solid.name for solid in plant.parts}
    under: dict[str, tuple[float, int, Shape]] = {}
    moments = [(0.0, -1), *((one.t_0, one.index) for one in plan.motions if not one.dropped)] if names else []
    first = [unit for motion in program.before or () for unit in getattr(motion, "units", ())]
    at, done = {(unit.unit, unit.eax): unit.end for unit in first}, 0
    for time, index in moments:
        for motion in program.motions[done : max(index, 0)]:
            at.update({(unit.unit, unit.eax): unit.end for unit in getattr(motion, "units", ())})
        done = max(index, done)
        bodies = bodies_on(plant, program, index)
        for own, solids in ((flange, bodies.carried), (WORLD, (*bodies.standing, *(t.solid for t in bodies.turned)))):
            for solid in (solid for solid in solids if solid.name in names):
                frame, shape, before = own, solid.loaded, under.get(solid.name)
                if own == WORLD and solid.rides is not None:
                    frame = table_frame(plant, solid.rides)
                    if before is not None and before[1] == frame:
                        continue  # it turns with the table
                    shape = moved(shape, inverse_pose(plant.stands(solid, at)))
                if before is None or before[1:] != (frame, shape):
                    if before is not None and time > before[0]:
                        yield Body(before[2], before[1], PART, before[0], time)
                    under[shape.name] = time, frame, shape
    for since, frame, shape in under.values():
        yield Body(shape, frame, PART, since)


def _bones(chain: Sequence[Joint]) -> Iterator[Body]:
    """Rods from each joint to the next, for a robot of whose links nothing else is known."""
    for i, joint in enumerate(chain):
        end = joint.X[:3, 3]
        if joint.kind != "prismatic" and np.any(end):
            yield Body(Capsule(f"to {joint.name}", np.zeros(3), end, _BONE), i - 1, LINK)


def _rails(robot: RobotModel, strokes: Array) -> Iterator[tuple[Box, Box]]:
    """Each rail's beam in the frame of the carriage before it, the world for the first, and its own carriage's plate.

    No robot file says how large they are: a beam is as long as the stroke and the plate, and stands under the plate;
    the last plate is under the arm's base, any other one under the middle of the beam behind it.
    """
    (width, height), (plate, thick) = _BEAM, _PLATE
    p, out = robot.X_WB0[:3, 3], list[tuple[Box, Box]]()
    for i in reversed(range(len(strokes))):
        along, (low, high), name = robot.rail_axes_W[i], strokes[i], robot.axis_names[i]
        up = robot.X_WB0[:3, 2] - (robot.X_WB0[:3, 2] @ along) * along
        if np.linalg.norm(up) < 0.1:  # the arm's base looks along the rail
            up = robot.X_WB0[:3, 0] - (robot.X_WB0[:3, 0] @ along) * along
        up = up / np.linalg.norm(up)
        R, middle = np.column_stack([along, np.cross(up, along), up]), p + along * (low + high) / 2
        beam, carriage = pose(R, middle - up * (thick + height / 2)), pose(R, p - up * thick / 2)
        size = np.array([high - low + plate, width, height])
        seen = inverse_pose(robot.X_WR)  # as rails do not turn what they carry
        out.append((
            Box(name, size, seen @ beam if i else beam),
            Box(name.replace("rail", "carriage"), np.array([plate, plate, thick]), seen @ carriage),
        ))  # fmt: skip
        p = middle - up * (thick + height)
    yield from reversed(out)


def _sampled(trajectory: Trajectory) -> tuple[Array, Array]:
    """Times from 0 (n,) and positions (n, k), close enough for straight lines in between: rows and steps."""
    t, last = trajectory.t, float(trajectory.t[-1])
    step = max(_STEP, trajectory.duration / _MOST_ROWS)
    if trajectory.qd is None or len(t) < 2:
        return t - t[0], np.asarray(trajectory.q)
    count = max(int(np.ceil(trajectory.duration / step)), 1)
    times = np.linspace(float(t[0]), last, count + 1)
    return times - t[0], hermite(trajectory, times)[0]
