"""Meshes and coal: read from a file, whether they are convex, what lies inside them, and what coal makes of shapes."""

from __future__ import annotations

import re
from functools import lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import coal  # type: ignore[import-untyped]
import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, BoolArray
from trajopt_cli.shapes import Box, Capsule, Mesh, MeshFile, Polytope, Shape

MOST_BYTES = 200_000_000  # four million triangles
_REASON = 100  # characters of why a file cannot be read; an OBJ or STL may be quoted in it whole
_NO_DIRECTION = 1e-12  # m: a shorter segment has none
_ROUNDING = 1e-6  # of a mesh's size: what files with seven digits leave open


def load_mesh(given: MeshFile) -> Mesh:
    """The mesh in a file: STL (text or binary), OBJ, glTF (whose y points up, and becomes z), STEP where cascadio is
    installed, and what else coal's loader takes. Raises InputError, unplaced."""
    if not given.path.is_file():
        raise InputError(f"no such mesh file: {given.path}")
    if (size := given.path.stat().st_size) > MOST_BYTES:
        bound = f"at most {MOST_BYTES // 10**6} MB are read"
        raise InputError(f"the mesh {given.path} has {size / 1e6:.0f} MB, {bound}; give a coarser one")
    try:
        with TemporaryDirectory() as folder:
            file, kind = given.path, given.path.suffix.lower()
            if kind == ".obj":
                file = _with_noughts(given.path, Path(folder))
            elif kind in (".step", ".stp"):
                file = _tessellated(given.path, Path(folder))
            # boxes along the axes: fitting others to a vertex that is no number has the library complain by itself
            model = coal.MeshLoader(coal.NODE_TYPE.BV_AABB).load(str(file), np.ones(3))
    except ValueError as error:
        # Its text is a page: source file, line, "message: Could not load resource ...", the reason, a hint.
        said = str(error).partition("message:")[2].strip().splitlines()
        why = " ".join((said[1] if len(said) > 1 else str(error)).split())[:_REASON]
        raise InputError(f"cannot read the mesh {given.path}: {why}") from error
    vertices = np.array(model.vertices()).reshape(-1, 3)
    if kind in (".glb", ".gltf"):
        vertices = vertices @ np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]])
    vertices = vertices * np.array(given.scale)
    triangles = [[corners[k] for k in range(3)] for corners in map(model.tri_indices, range(model.num_tris))]
    if not triangles:
        raise InputError(f"the mesh {given.path} has no triangles")
    if not np.isfinite(vertices).all():
        raise InputError(f"the mesh {given.path} has a vertex that is not finite")
    return Mesh(given.name, vertices, np.array(triangles), given.X)


def _tessellated(path: Path, folder: Path) -> Path:
    """A STEP file's surfaces as a GLB file in a folder, in metres within 0.1 mm, z upwards. Raises InputError where the
    library that does it is not there."""
    try:
        import cascadio  # type: ignore[import-not-found]
    except ImportError as error:
        advice = "pip install 'trajopt-cli[step]', or save it as STL, OBJ or glTF"
        raise InputError(f"the mesh {path} is STEP, which cascadio reads: {advice}") from error
    out = folder / "step.glb"
    if cascadio.step_to_glb(str(path), str(out), 0.1, 0.2) != 0 or not out.is_file():
        raise InputError(f"cannot read the mesh {path}: no STEP file with surfaces")
    return out


def _with_noughts(path: Path, folder: Path) -> Path:
    """The file, or a copy in a folder where its numbers begin with a point: .5 is OBJ, but not to the loader."""
    content = path.read_bytes()
    changed = re.sub(rb"(?<=\s)\.(?=\d)", b"0.", content)
    if changed == content:
        return path
    copy = folder / path.name
    copy.write_bytes(changed)
    return copy


def convex(mesh: Mesh) -> Any:
    """coal's convex body, in the mesh's own axes, where a mesh is the whole surface of one; else None.

    A polytope is one. A mesh is where every edge lies between two triangles, nothing lies on one side of any triangle's
    plane (to a millionth of the mesh's size), and it has some volume.
    """
    return _convex(mesh.of or mesh)


@lru_cache(maxsize=64)
def _convex(mesh: Mesh) -> Any:
    if isinstance(mesh, Polytope):
        return _hull(mesh.vertices)
    near = _ROUNDING * float(np.ptp(mesh.vertices, axis=0).max())
    _, first, same = np.unique(
        np.round(mesh.vertices / max(near, 1e-12)), axis=0, return_index=True, return_inverse=True
    )
    vertices, triangles = mesh.vertices[first], same.reshape(-1)[mesh.triangles]
    triangles = triangles[(triangles != np.roll(triangles, 1, axis=1)).all(axis=1)]
    edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    if not len(edges) or (np.unique(edges, axis=0, return_counts=True)[1] != 2).any():
        return None
    deep = 0.0
    for a, b, c in vertices[triangles]:
        normal = np.cross(b - a, c - a)
        length = float(np.linalg.norm(normal))
        if length > near * near:
            off = (vertices - a) @ normal / length
            if min(off.max(), -off.min()) > near:
                return None
            deep = max(deep, float(np.abs(off).max()))
    if deep <= near:
        return None
    return _hull(vertices)


def _hull(vertices: Array) -> Any:
    points = coal.StdVec_Vec3s()
    points.extend(list(vertices))
    return coal.Convex.convexHull(points, True, "Qt")  # without vertices that lie within faces


def inside(mesh: Mesh, points: Array) -> BoolArray:
    """Which points (n, 3), in the frame the mesh is given in, lie inside its surface: (n,).

    By the solid angle of all triangles (Van Oosterom and Strackee 1983): a whole turn inside a closed surface, none
    outside; an open surface counts as closed where it goes more than half around.
    """
    local = (points - mesh.X[:3, 3]) @ mesh.X[:3, :3]
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    within = ((local >= low) & (local <= high)).all(axis=1)
    corners = mesh.vertices[mesh.triangles]
    for i in np.flatnonzero(within):
        a, b, c = np.moveaxis(corners - local[i], 1, 0)
        lengths = [np.linalg.norm(side, axis=1) for side in (a, b, c)]
        volume = np.einsum("ij,ij->i", a, np.cross(b, c))
        dots = [np.einsum("ij,ij->i", x, y) for x, y in ((a, b), (b, c), (c, a))]
        spread = lengths[0] * lengths[1] * lengths[2]
        spread = spread + dots[0] * lengths[2] + dots[1] * lengths[0] + dots[2] * lengths[1]
        turn = 2 * float(np.arctan2(volume, spread).sum()) / (4 * np.pi)
        within[i] = abs(turn) > 0.5
    return np.asarray(within)


@lru_cache(maxsize=64)
def coal_geometry(shape: Shape) -> tuple[Any, Array]:
    """coal's geometry and its pose in the frame the shape is given in; a mesh's tree is worth building once."""
    match shape:
        case Box():
            return coal.Box(*(float(length) for length in shape.size)), np.asarray(shape.X)
        case Capsule():
            along = shape.b - shape.a
            length = float(np.linalg.norm(along))
            X = np.eye(4)
            X[:3, 3] = (shape.a + shape.b) / 2
            if length < _NO_DIRECTION:
                return coal.Sphere(shape.radius), X
            X[:3, :3] = with_z(along / length)
            return coal.Capsule(shape.radius, length), X  # its length is the segment's, without the caps
        case Mesh() if (body := convex(shape)) is not None:
            return body, np.asarray(shape.X)
        case Mesh():
            return _surface(shape.of or shape), np.asarray(shape.X)


@lru_cache(maxsize=64)
def _surface(mesh: Mesh) -> Any:
    model = coal.BVHModelOBBRSS()
    model.beginModel(len(mesh.triangles), len(mesh.vertices))
    model.addVertices(np.array(mesh.vertices))
    model.addTriangles(np.array(mesh.triangles))
    model.endModel()
    return model


def with_z(z: Array) -> Array:
    """A rotation (3, 3) whose third column is the unit vector z."""
    x = np.cross(np.eye(3)[int(np.argmin(np.abs(z)))], z)
    x /= np.linalg.norm(x)
    return np.column_stack([x, np.cross(z, x), z])
