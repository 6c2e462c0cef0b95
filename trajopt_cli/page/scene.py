"""What the 3-D view of a page draws: the robot's chain, bodies on it and around it, points, and cycles to play.

The page's script works the poses out itself: X_WF = base · placement_1 · joint_1(q_1) · placement_2 · joint_2(q_2) ...,
with q linear between rows. Matrices stand row by row. Frame i of the chain is the one behind its i-th element, -1 the
base; a body names the frame it is fixed to.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array, IndexArray, readonly
from trajopt_cli.motion import MoveAbsJ, MoveC, MoveJ, MoveL, Program
from trajopt_cli.page.encode import block
from trajopt_cli.problem.collision_objects import bodies_on, tool_capsule
from trajopt_cli.problem.detours import unfolded, with_detours
from trajopt_cli.problem.plan import Plan
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.model import RobotModel
from trajopt_cli.robot.srs import SrsRobot
from trajopt_cli.shapes import TOOL, Box, Capsule, Mesh, MeshFile, Shape, Solid
from trajopt_cli.trajectory import Trajectory, hermite

SCRIPTS = ("view3d.css", "view3d_motion.js", "view3d_graphics.js", "view3d.js")
"""What a page with a scene takes besides; an element with the attribute data-scene then shows it."""
HOLDER = "<div data-scene></div>"
_STEP = 2e-3  # s between rows: at 20 m/s² a straight line between them is 0.01 mm off
_MOST_ROWS = 20_000
_FLAT, _CHORD = 5e-5, 0.02  # m: what a point of a drawn path may be off at each level, and how far they are apart
_LEVELS = 8
_SAME = 1e-9  # s
_MOST_TRIANGLES, _CELLS = 60_000, 400  # of all meshes of a scene: 1.5 MB; of a mesh' longest side, to begin with
_BEAM, _PLATE = (0.3, 0.1), (0.42, 0.03)  # m, width and height of the rail's beam and of the carriage's plate
_BONE = 0.035  # m, radius of a link of which no shape is known


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
    """A motion to play. t (n,) [s] from 0; q (n, k) as the robot's axes [rad, m].

    tools: X_FT (4, 4) from a time [s] on, the first from the start. driven: from when to when [s] the tool is on lines
    and arcs, drawn stronger; none for a motion that has no such parts. parts: what the flange takes and leaves, and the
    capsule that stands for the tool, each from when to when [s], and whether in the flange's frame or in the world's.
    """

    name: str
    t: Array
    q: Array
    tools: tuple[tuple[float, Array], ...] = field(default_factory=lambda: ((0.0, np.eye(4)),))
    driven: tuple[tuple[float, float], ...] = ()
    parts: tuple[tuple[float, float, bool, Shape], ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "t", readonly(self.t))
        object.__setattr__(self, "q", readonly(self.q))
        if self.t.ndim != 1 or self.q.ndim != 2 or len(self.t) != len(self.q) or not len(self.t):
            raise ValueError(f"cycle '{self.name}': t {self.t.shape} and q {self.q.shape}, wanted (n,) and (n, k)")


def plan_cycle(name: str, program: Program, plan: Plan, plant: Plant | None = None) -> Cycle:
    """A plan of a program as a cycle, with the tool in force at every time, and a plant's parts where they are then."""
    tools: list[tuple[float, Array]] = []
    capsules: list[tuple[float, Shape | None]] = []
    driven: list[tuple[float, float]] = []
    for planned in plan.motions:
        motion = program.motions[planned.index]
        if planned.dropped or not isinstance(motion, MoveJ | MoveL | MoveC | MoveAbsJ):
            continue
        if not tools or not np.array_equal(tools[-1][1], motion.tool.X_FT):
            tools.append((planned.t_0 if tools else 0.0, motion.tool.X_FT))
            solids = () if plant is None else tool_capsule(motion.tool, plant.tool_radius)
            capsules.append((tools[-1][0], _loaded(solids[0]) if solids else None))
        if isinstance(motion, MoveL | MoveC) and planned.t_1 > planned.t_0:
            if driven and driven[-1][1] == planned.t_0:
                driven[-1] = (driven[-1][0], planned.t_1)
            else:
                driven.append((planned.t_0, planned.t_1))
    t, q = _sampled(plan.trajectory)
    parts = () if plant is None else tuple(_parts(program, plan, plant))
    for (since, one), (until, _) in pairwise([*capsules, (math.inf, None)]):
        parts += ((since, until, True, one),) if one is not None else ()
    return Cycle(name, t, q, tuple(tools) or ((0.0, np.eye(4)),), tuple(driven), parts)


def _parts(program: Program, plan: Plan, plant: Plant) -> Iterator[tuple[float, float, bool, Shape]]:
    """Where the parts are, from change to change. A part that is taken at the end of a move moves with the next."""
    names = {solid.name for solid in plant.parts}
    under: dict[str, tuple[float, bool, Shape]] = {}
    moments = [(0.0, -1), *((one.t_0, one.index) for one in plan.motions if not one.dropped)] if names else []
    for time, index in moments:
        bodies = bodies_on(plant, program, index)
        for carried, solids in ((True, bodies.carried), (False, bodies.standing)):
            for shape in (_loaded(solid) for solid in solids if solid.name in names):
                before = under.get(shape.name)
                if before is None or before[2] is not shape:
                    if before is not None and time > before[0]:
                        yield before[0], time, *before[1:]
                    under[shape.name] = time, carried, shape
    for since, carried, shape in under.values():
        yield since, math.inf, carried, shape


def _loaded(solid: Solid) -> Shape:
    assert not isinstance(solid.shape, MeshFile)  # a plant has them loaded
    return solid.shape


def program_points(program: Program, plan: Plan, plant: Plant) -> list[ScenePoint]:
    """The targets that a plan's moves lead to, as programmed, and the points it adds; each name at each position
    once."""
    program, plan = with_detours(program, plant, plan.detours), unfolded(plan)
    out: dict[tuple[str, tuple[float, ...]], ScenePoint] = {}
    for planned in plan.motions:
        motion = program.motions[planned.index]
        if planned.dropped or not isinstance(motion, MoveJ | MoveL | MoveC | MoveAbsJ):
            continue
        X_WT = motion.X_WT if not isinstance(motion, MoveAbsJ) else plant.robot.forward(planned.q_1) @ motion.tool.X_FT
        x, y, z = (round(float(value), 6) for value in X_WT[:3, 3])
        out.setdefault(
            (motion.target, (x, y, z)),
            ScenePoint(motion.target, (x, y, z), str(motion.source), bool(motion.detour)),
        )
    return list(out.values())


def plant_scene(plant: Plant, points: Iterable[ScenePoint], cycles: Sequence[Cycle]) -> dict[str, Any]:
    """The scene of a cell, data["scene"] of a page: robot, rail with carriage, obstacles, what the flange carries."""
    rail = plant.layout.rail
    stroke = (float(plant.limits.lower[0]), float(plant.limits.upper[0])) if rail.stop > rail.start else None
    moves = any(shape.name != TOOL for cycle in cycles for *_, shape in cycle.parts)
    moving = {solid.name for solid in plant.parts} if moves else set[str]()
    obstacles = [solid.shape for solid in plant.obstacles if solid.name not in moving]
    carried = [solid.shape for solid in plant.attached]
    return robot_scene(plant.robot, points, cycles, obstacles, carried, stroke)


def robot_scene(
    robot: RobotModel | SrsRobot,
    points: Iterable[ScenePoint],
    cycles: Sequence[Cycle],
    obstacles: Iterable[Shape | MeshFile] = (),
    carried: Iterable[Shape | MeshFile] = (),
    stroke: tuple[float, float] | None = None,
) -> dict[str, Any]:
    """The scene of any robot. obstacles: shapes in the world, carried: in the flange frame, meshes loaded.

    stroke: lowest and highest rail position [m], None without a rail.
    """
    obstacles, carried = list(obstacles), list(carried)
    meshes = sum(isinstance(one, Mesh) for one in (*obstacles, *carried))
    most = _MOST_TRIANGLES // max(meshes, 1)
    obstacles, carried = ([_coarse(one, most) for one in shapes] for shapes in (obstacles, carried))
    chain, frames = _chain(robot)
    base = robot.X_WR if isinstance(robot, RobotModel) else robot.X_WB
    bodies = [_shape(capsule) | {"link": frames[link], "role": "link"} for link, capsule in robot.capsules.items()]
    bodies = bodies or _bones(chain)
    bodies += [_shape(shape) | {"link": len(chain) - 1, "role": "tool"} for shape in carried]
    static = [_shape(shape) | {"role": "obstacle"} for shape in obstacles]
    if stroke is not None and isinstance(robot, RobotModel):
        beam, plate = _rail(robot, stroke)
        if not any(one.name == "track" for one in obstacles):  # the cell says how large it is
            static.append(_shape(beam) | {"role": "rail"})
        bodies.append(_shape(plate) | {"link": frames[robot.link_names[0]], "role": "carriage"})
    return {
        "chain": chain,
        "bodies": bodies,
        "static": static,
        "points": [
            {"name": one.name, "position": list(one.position), "place": one.place, "added": one.added} for one in points
        ],
        "tool": _flat(cycles[0].tools[0][1]) if cycles else _flat(np.eye(4)),
        "base": _flat(base),
        "axes": list(robot.axis_names),
        "cycles": [_cycle(robot, one) | _placed(one, len(chain) - 1, most) for one in cycles],
    }


def _placed(cycle: Cycle, flange: int, most: int) -> dict[str, Any]:
    """A cycle's parts: link -2 is the world. most: triangles of a mesh."""
    parts = [
        _shape(_coarse(shape, most))
        | {
            "role": "tool" if shape.name == TOOL else "part",
            "link": flange if carried else -2,
            "from": since,
            "to": min(until, float(cycle.t[-1]) + 1),
        }
        for since, until, carried, shape in cycle.parts
    ]
    return {"parts": parts} if parts else {}


def _chain(robot: RobotModel | SrsRobot) -> tuple[list[dict[str, Any]], dict[str, int]]:
    """The chain from the base to the flange, and the frame of every link by name."""
    chain, frames = [], {}
    if isinstance(robot, RobotModel):
        if robot.rail_axis is not None:
            axis = robot.rail_axis.tolist()
            chain.append(
                {"name": robot.axis_names[0], "placement": _flat(np.eye(4)), "kind": "prismatic", "axis": axis}
            )
        chain.append({"name": robot.link_names[0], "placement": _flat(robot.X_RB), "kind": "fixed", "axis": [0, 0, 0]})
    frames[robot.link_names[0]] = len(chain) - 1
    for joint in robot.chain:
        chain.append(
            {
                "name": joint.name,
                "placement": _flat(joint.X),
                "kind": joint.kind,
                "axis": np.asarray(joint.axis).tolist(),
            }
        )
        if isinstance(robot, RobotModel) and robot.linkage and joint is robot.chain[2]:
            chain[-1]["less"] = robot.linkage  # times the axis before it
        frames[joint.child] = len(chain) - 1
    return chain, frames


def _bones(chain: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    """Rods from each joint to the next, for a robot of whose links nothing else is known."""
    out = []
    for i, joint in enumerate(chain):
        end = np.reshape(joint["placement"], (4, 4))[:3, 3]
        if joint["kind"] != "prismatic" and np.any(end):
            rod = Capsule(f"to {joint['name']}", np.zeros(3), end, _BONE)
            out.append(_shape(rod) | {"link": i - 1, "role": "link"})
    return out


def _rail(robot: RobotModel, stroke: tuple[float, float]) -> tuple[Box, Box]:
    """The rail's beam in the world, and the carriage's plate in the frame of the arm's base.

    No robot file says how large they are: the beam is as long as the stroke and the plate, and stands under the base.
    """
    assert robot.rail_axis_W is not None
    along = robot.rail_axis_W
    up = robot.X_WB0[:3, 2] - (robot.X_WB0[:3, 2] @ along) * along
    if np.linalg.norm(up) < 0.1:  # the arm's base looks along the rail
        up = robot.X_WB0[:3, 0] - (robot.X_WB0[:3, 0] @ along) * along
    up = up / np.linalg.norm(up)
    R = np.column_stack([along, np.cross(up, along), up])
    (width, height), (plate, thick) = _BEAM, _PLATE
    beam, carriage = np.eye(4), np.eye(4)
    beam[:3, :3] = R
    middle = robot.X_WB0[:3, 3] + along * (stroke[0] + stroke[1]) / 2
    beam[:3, 3] = middle - up * (thick + height / 2)
    R_BW = robot.X_WB0[:3, :3].T
    carriage[:3, :3] = R_BW @ R
    carriage[:3, 3] = -R_BW @ up * thick / 2
    length = stroke[1] - stroke[0] + plate
    return Box("rail", np.array([length, width, height]), beam), Box(
        "carriage", np.array([plate, plate, thick]), carriage
    )


def _coarse(shape: Shape | MeshFile, most: int) -> Shape | MeshFile:
    """A mesh of at most so many triangles, its vertices drawn together within cells of a grid; all else as it is."""
    if not isinstance(shape, Mesh) or len(shape.triangles) <= most:
        return shape
    low = shape.vertices.min(axis=0)
    cell = float(np.ptp(shape.vertices, axis=0).max()) / _CELLS
    while True:
        _, first, cluster = np.unique(
            np.round((shape.vertices - low) / cell), axis=0, return_index=True, return_inverse=True
        )
        triangles = cluster.reshape(-1)[shape.triangles]
        a, b, c = triangles.T
        triangles = triangles[(a != b) & (b != c) & (c != a)]
        if len(triangles) <= most:
            return Mesh(shape.name, shape.vertices[first], triangles, shape.X)
        cell *= 1.25


def _shape(shape: Shape | MeshFile) -> dict[str, Any]:
    match shape:
        case Capsule():
            return {
                "kind": "capsule",
                "name": shape.name,
                "a": shape.a.tolist(),
                "b": shape.b.tolist(),
                "radius": float(shape.radius),
            }
        case Box():
            return {"kind": "box", "name": shape.name, "size": shape.size.tolist(), "X": _flat(shape.X)}
        case Mesh():
            return {
                "kind": "mesh",
                "name": shape.name,
                "vertices": block(shape.vertices),
                "triangles": block(shape.triangles),
                "X": _flat(shape.X),
            }
    raise TypeError(f"{type(shape).__name__} is no shape that is loaded")


def _cycle(robot: RobotModel | SrsRobot, cycle: Cycle) -> dict[str, Any]:
    starts = [start for start, _ in cycle.tools]
    which = np.maximum(np.searchsorted(starts, cycle.t, side="right") - 1, 0)
    X_FT = np.array([tool for _, tool in cycle.tools])[which]
    path = (robot.forward(cycle.q) @ X_FT)[:, :3, 3]
    edges = [*starts, *(time for span in cycle.driven for time in span)]
    rows = _bends(path, np.searchsorted(cycle.t, np.array(edges) - _SAME))
    return {
        "name": cycle.name,
        "t": block(cycle.t),
        "q": block(cycle.q),
        "path": block(path[rows]),
        "path_t": block(cycle.t[rows]),
        "tools": [{"t": start, "X": _flat(tool)} for start, tool in cycle.tools],
        "driven": [list(span) for span in cycle.driven],
    }


def _bends(path: Array, kept: IndexArray) -> IndexArray:
    """Rows of a path (n, 3) [m] that are enough to draw it, those in kept among them."""
    rows, fixed = np.arange(len(path)), np.zeros(len(path), dtype=bool)
    fixed[np.minimum(kept, len(path) - 1)] = True
    for _ in range(_LEVELS):
        inner = np.arange(1, len(rows) - 1, 2)
        a, b, c = (path[rows[inner + k]] for k in (-1, 0, 1))
        chord = c - a
        length = np.linalg.norm(chord, axis=1)
        aside = np.linalg.norm(np.cross(b - a, chord), axis=1) / np.maximum(length, _FLAT)
        away = np.where(length > _FLAT, aside, np.linalg.norm(b - a, axis=1))
        rows = np.delete(rows, inner[(away <= _FLAT) & (length <= _CHORD) & ~fixed[rows[inner]]])
    return rows


def _sampled(trajectory: Trajectory) -> tuple[Array, Array]:
    """Times from 0 (n,) and positions (n, k), close enough for straight lines in between: rows and steps."""
    t, last = trajectory.t, float(trajectory.t[-1])
    step = max(_STEP, trajectory.duration / _MOST_ROWS)
    if trajectory.qd is None or len(t) < 2:
        return t - t[0], np.asarray(trajectory.q)
    count = max(int(np.ceil(trajectory.duration / step)), 1)
    times = np.linspace(float(t[0]), last, count + 1)
    return times - t[0], hermite(trajectory, times)[0]


def _flat(X: Array) -> list[float]:
    return [float(value) for value in np.asarray(X).ravel()]
