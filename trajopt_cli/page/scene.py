"""The scene of a page's 3-D view as its script reads it: chain, bodies, points, and cycles to play.

The script works the poses out itself, by the rule of trajopt_cli.scene, with q linear between rows. Matrices stand row
by row.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array, IndexArray, inverse_pose
from trajopt_cli.page.encode import block
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.model import RobotModel
from trajopt_cli.robot.srs import SrsRobot
from trajopt_cli.scene import WORLD, Body, Cycle, Joint, Scene, ScenePoint, scene_of_plant, scene_of_robot
from trajopt_cli.shapes import TOOL, Box, Capsule, Mesh, Polytope, Shape
from trajopt_cli.table import short_target

SCRIPTS = ("view3d.css", "view3d_motion.js", "view3d_graphics.js", "view3d.js")
"""What a page with a scene takes besides; an element with the attribute data-scene then shows it."""
HOLDER = "<div data-scene></div>"
_FLAT, _CHORD = 5e-5, 0.02  # m: what a point of a drawn path may be off at each level, and how far they are apart
_LEVELS = 8
_SAME = 1e-9  # s
_MOST_TRIANGLES, _CELLS = 60_000, 400  # of all meshes of a scene: 1.5 MB; of a mesh' longest side, to begin with


def plant_scene(plant: Plant, points: Iterable[ScenePoint], cycles: Sequence[Cycle]) -> dict[str, Any]:
    """The scene of a cell, data["scene"] of a page."""
    moves = any(part.shape.name != TOOL for cycle in cycles for part in cycle.parts)
    return scene_data(scene_of_plant(plant, [solid.name for solid in plant.parts] if moves else ()), points, cycles)


def robot_scene(
    robot: RobotModel | SrsRobot,
    points: Iterable[ScenePoint],
    cycles: Sequence[Cycle],
    obstacles: Iterable[Shape] = (),
    carried: Iterable[Shape] = (),
) -> dict[str, Any]:
    """The same of any robot; the rest as in scene_of_robot."""
    return scene_data(scene_of_robot(robot, [*obstacles], [*carried]), points, cycles)


def scene_data(scene: Scene, points: Iterable[ScenePoint], cycles: Sequence[Cycle]) -> dict[str, Any]:
    """A scene with points and cycles as plain data."""
    fine = [body for body in scene.bodies if isinstance(body.shape, Mesh) and not isinstance(body.shape, Polytope)]
    most = _MOST_TRIANGLES // max(len(fine), 1)
    return {
        "chain": [_joint(joint) for joint in scene.chain],
        "bodies": [
            _shape(body, most) | {"link": body.frame, "role": body.role} for body in scene.bodies if body.frame != WORLD
        ],
        "static": [_shape(body, most) | {"role": body.role} for body in scene.bodies if body.frame == WORLD],
        "points": [
            {"name": short_target(one.name), "position": list(one.position), "place": one.place, "added": one.added}
            for one in points
        ],
        "tables": [
            {
                "parent": one.parent,
                "X": _flat(one.X),
                "back": _flat(inverse_pose(one.X)),
                "kind": "prismatic" if one.slides else "revolute",
            }
            for one in scene.tables
        ],
        "tool": _flat(cycles[0].tools[0][1]) if cycles else _flat(np.eye(4)),
        "base": _flat(scene.base),
        "axes": list(scene.axes),
        **({"colour": scene.colour} if scene.colour else {}),
        "cycles": [_cycle(scene, one, most) for one in cycles],
    }


def _joint(joint: Joint) -> dict[str, Any]:
    out = {"name": joint.name, "placement": _flat(joint.X), "kind": joint.kind, "axis": joint.axis.tolist()}
    return out | ({"less": joint.less} if joint.less else {})


def _coarse(shape: Shape, most: int) -> Shape:
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


def _shape(body: Body, most: int) -> dict[str, Any]:
    """A body's shape; most: triangles of a mesh."""
    match _coarse(body.shape, most):
        case Capsule(name=name, a=a, b=b, radius=radius):
            return {"kind": "capsule", "name": name, "a": a.tolist(), "b": b.tolist(), "radius": float(radius)}
        case Box(name=name, size=size, X=X):
            return {"kind": "box", "name": name, "size": size.tolist(), "X": _flat(X)}
        case Mesh(name=name, X=X) as mesh:
            surface = {"vertices": block(mesh.vertices), "triangles": block(mesh.triangles)}
            return {"kind": "mesh", "name": name, **surface, "X": _flat(X)}


def _cycle(scene: Scene, cycle: Cycle, most: int) -> dict[str, Any]:
    starts = [start for start, _ in cycle.tools]
    which = np.maximum(np.searchsorted(starts, cycle.t, side="right") - 1, 0)
    X_FT = np.array([tool for _, tool in cycle.tools])[which]
    path = (scene.poses(cycle.q)[:, -1] @ X_FT)[:, :3, 3]
    edges = [*starts, *(time for span in cycle.driven for time in span)]
    rows = _bends(path, np.searchsorted(cycle.t, np.array(edges) - _SAME))
    last = float(cycle.t[-1]) + 1
    parts = [
        _shape(part, most) | {"role": part.role, "link": part.frame, "from": part.since, "to": min(part.until, last)}
        for part in cycle.parts
    ]
    return {
        "name": cycle.name,
        "t": block(cycle.t),
        "q": block(cycle.q),
        "path": block(path[rows]),
        "path_t": block(cycle.t[rows]),
        "tools": [{"t": start, "X": _flat(tool)} for start, tool in cycle.tools],
        "driven": [list(span) for span in cycle.driven],
        **({"parts": parts} if parts else {}),
        **({} if cycle.turned is None else {"turned": block(cycle.turned)}),
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


def _flat(X: Array) -> list[float]:
    return [float(value) for value in np.asarray(X).ravel()]
