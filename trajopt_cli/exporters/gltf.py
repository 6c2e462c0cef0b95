"""A plan as a glTF 2.0 animation in one binary file (GLB): the scene's bodies, moved by its chain.

Every frame of the chain is a node in the one before it, as the URDF has them; a joint's sampler turns its node, the
rail's shifts it. Metres and seconds; glTF's y points up, so all stands under one node that turns z there.
Source: Khronos, glTF 2.0 specification (ISO/IEC 12113).
"""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from struct import pack
from typing import Any

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, inverse_pose, rotation_about, wxyz_in_turn
from trajopt_cli.problem.plant import Plant
from trajopt_cli.scene import BASE, CARRIAGE, LINK, OBSTACLE, RAIL, TOOL_ROLE, WORLD, scene_of_plant, turned_since
from trajopt_cli.shapes import Box, Capsule, Mesh
from trajopt_cli.trajectory import Trajectory

_FLOAT, _UINT, _VERTICES, _INDICES = 5126, 5125, 34962, 34963  # as OpenGL numbers them
_AROUND, _UP = 16, 4  # edges of a capsule, and of a quarter of its ends
_COLOURS = {LINK: "#edb36c", TOOL_ROLE: "#6b747d", OBSTACLE: "#bcc4cb", RAIL: "#a2aab2", CARRIAGE: "#a2aab2"}
_BOX = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
                 [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])  # fmt: skip


@dataclass(eq=False)
class _File:
    """A glTF document and its bytes, as they grow."""

    nodes: list[dict[str, Any]] = field(default_factory=list)
    meshes: list[dict[str, Any]] = field(default_factory=list)
    accessors: list[dict[str, Any]] = field(default_factory=list)
    views: list[dict[str, Any]] = field(default_factory=list)
    data: bytearray = field(default_factory=bytearray)

    def numbers(self, values: NDArray[Any], kind: str, target: int | None = None) -> int:
        """An accessor of rows of float32, or of indices; with bounds, which places and times must have."""
        whole = values.dtype.kind in "iu"
        rows = np.ascontiguousarray(values, dtype=np.uint32 if whole else np.float32)
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": rows.nbytes}
        self.views.append(view if target is None else view | {"target": target})
        self.data += rows.tobytes()
        flat = rows.reshape(len(rows), -1)
        bounds = {"min": flat.min(axis=0).tolist(), "max": flat.max(axis=0).tolist()}
        made = {"bufferView": len(self.views) - 1, "componentType": _UINT if whole else _FLOAT, "count": len(rows)}
        self.accessors.append(made | {"type": kind} | bounds)
        return len(self.accessors) - 1

    def node(self, name: str, parent: int | None = None, X: Array | None = None, **more: Any) -> int:
        """A node at X in its parent's frame."""
        self.nodes.append({"name": name, **more})
        if X is not None:
            self.nodes[-1] |= {"translation": X[:3, 3].tolist(), "rotation": _xyzw(X[None, :3, :3])[0].tolist()}
        if parent is not None:
            self.nodes[parent].setdefault("children", []).append(len(self.nodes) - 1)
        return len(self.nodes) - 1

    def shape(self, shape: Box | Capsule | Mesh, parent: int, material: int) -> None:
        """A node with a shape's surface."""
        vertices, triangles = surface(shape)
        places = self.numbers(vertices, "VEC3", _VERTICES)
        indices = self.numbers(triangles.ravel(), "SCALAR", _INDICES)
        self.meshes.append(
            {"primitives": [{"attributes": {"POSITION": places}, "indices": indices, "material": material}]}
        )
        self.node(shape.name, parent, None if isinstance(shape, Capsule) else shape.X, mesh=len(self.meshes) - 1)


def gltf(trajectory: Trajectory, plant: Plant, title: str) -> bytes:
    """The GLB file of a trajectory's rows, as one animation. Raises InputError for another robot's trajectory."""
    robot, led = plant.robot, {one.column for one in plant.followers}
    trajectory = trajectory.of([name for name in trajectory.names if name not in led])
    if trajectory.names != robot.axis_names:
        raise InputError(f"moves {', '.join(trajectory.names)}, not the axes of {robot.title}")
    scene = scene_of_plant(plant)
    file, samplers, channels = _File(), list[dict[str, Any]](), list[dict[str, Any]]()
    times = file.numbers(trajectory.t - trajectory.t[0], "SCALAR")

    def animate(node: int, path: str, values: Array, kind: str) -> None:
        channels.append({"sampler": len(samplers), "target": {"node": node, "path": path}})
        samplers.append({"input": times, "output": file.numbers(values, kind)})

    upright = np.eye(4)
    upright[:3, :3] = rotation_about([1, 0, 0], -np.pi / 2)
    world = file.node(title, X=upright)
    nodes = {WORLD: world, BASE: file.node("base", world, scene.base)}
    for i, X in enumerate(scene.moved(trajectory.q)):
        joint = scene.chain[i]
        nodes[i] = file.node(joint.link, nodes[i - 1], X[0])
        if joint.kind == "prismatic":
            animate(nodes[i], "translation", X[:, :3, 3], "VEC3")
        elif joint.kind != "fixed":
            animate(nodes[i], "rotation", _xyzw(X[:, :3, :3]), "VEC4")
    turned = turned_since(scene.tables, trajectory.tables, len(trajectory.t))
    for i, table in enumerate(scene.tables):
        mount = file.node(f"{table.unit} {table.number + 1} mount", nodes[table.parent], table.X)
        turns = file.node(f"{table.unit} {table.number + 1}", mount, np.eye(4))
        if table.slides:
            animate(turns, "translation", turned[:, i, None] * np.array([0.0, 0.0, 1.0]), "VEC3")
        else:
            animate(turns, "rotation", _xyzw(rotation_about([0, 0, 1], turned[:, i])), "VEC4")
        nodes[len(scene.chain) + i] = file.node(
            f"{table.unit} {table.number + 1} carries", turns, inverse_pose(table.X)
        )
    for body in scene.bodies:
        file.shape(body.shape, nodes[body.frame], [*_COLOURS].index(body.role))
    return _glb(file, scene.colour or _COLOURS[LINK], {"name": title, "samplers": samplers, "channels": channels})


def _glb(file: _File, paint: str, animation: dict[str, Any]) -> bytes:
    materials = [
        {"name": role, "pbrMetallicRoughness": {"baseColorFactor": _linear(colour), "metallicFactor": 0.0}}
        for role, colour in (_COLOURS | {LINK: paint}).items()
    ]
    document = {
        "asset": {"version": "2.0", "generator": "trajopt"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": file.nodes,
        "meshes": file.meshes,
        "materials": materials,
        "accessors": file.accessors,
        "bufferViews": file.views,
        "buffers": [{"byteLength": len(file.data)}],
        "animations": [animation],
    }
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    chunks = pack("<I4s", len(text), b"JSON") + text + pack("<I4s", len(file.data), b"BIN\0") + file.data
    return pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def _linear(colour: str) -> list[float]:
    """A colour "#rrggbb" as glTF has it: sRGB without its curve (IEC 61966-2-1), and opaque."""
    shares = [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    return [round(v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4, 4) for v in shares] + [1.0]


def _xyzw(R: Array) -> Array:
    """Quaternions (n, 4) as glTF orders them, of rotations (n, 3, 3) in turn."""
    return np.roll(wxyz_in_turn(R), -1, axis=-1)


def surface(shape: Box | Capsule | Mesh) -> tuple[Array, NDArray[np.int64]]:
    """Vertices and triangles, counter-clockwise from outside, in the frame of the shape's X."""
    match shape:
        case Mesh():
            return shape.vertices, shape.triangles
        case Box():
            corners = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
            return corners * shape.size, _BOX
    z = shape.b - shape.a
    z = z / np.linalg.norm(z) if z.any() else np.array([0.0, 0.0, 1.0])
    x = np.cross(z, np.eye(3)[np.argmin(np.abs(z))])
    x /= np.linalg.norm(x)
    y = np.cross(z, x)
    around = 2 * np.pi * np.arange(_AROUND) / _AROUND
    circle = np.cos(around)[:, None] * x + np.sin(around)[:, None] * y
    up = np.pi / 2 * np.arange(_UP) / _UP
    halves = [(shape.a, -up[::-1]), (shape.b, up)]
    rings = [end + shape.radius * (np.cos(w) * circle + np.sin(w) * z) for end, half in halves for w in half]
    vertices = np.vstack([*rings, shape.a - shape.radius * z, shape.b + shape.radius * z])
    i, j = np.arange(_AROUND), np.roll(np.arange(_AROUND), -1)
    last = (len(rings) - 1) * _AROUND
    bottom, top = np.full_like(i, len(vertices) - 2), np.full_like(i, len(vertices) - 1)
    triangles = [(bottom, j, i), (top, last + i, last + j)]
    for a in range(0, last, _AROUND):
        b = a + _AROUND
        triangles += [(a + i, a + j, b + j), (a + i, b + j, b + i)]
    return vertices, np.vstack([np.stack(corners, axis=1) for corners in triangles])
