"""Bodies in space as plain data: boxes, capsules, meshes, who may touch them, when they are carried. SI, poses X_AB."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from itertools import combinations, pairwise
from pathlib import Path
from typing import NamedTuple
from urllib.parse import unquote

import numpy as np
from numpy.typing import ArrayLike, NDArray

from trajopt_cli.geometry import Array, readonly

ATTACHED = "attached"
"""Stands in a pair of links for all that the flange carries."""

TOOL = "tool"
"""The name of the capsule that stands for a tool nobody described, and in a pair of links for it."""

TriangleArray = NDArray[np.int64]
_CORNERS = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=np.float64)
_SKEW = 1e-6  # how far a rotation may be from orthogonal: a quaternion written with seven digits
_GRID = np.array([[x, y, z] for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1) if (x, y, z) != (0, 0, 0)])
DIRECTIONS = readonly(_GRID / np.linalg.norm(_GRID, axis=1, keepdims=True))
"""(26, 3): unit vectors to faces, edges and corners of a cube, x slowest and z fastest: (-1,-1,-1), (-1,-1,0) ..."""
_U = np.cross(DIRECTIONS, np.eye(3)[np.argmin(np.abs(DIRECTIONS), axis=1)])
_U = _U / np.linalg.norm(_U, axis=1, keepdims=True)
_SIDES = np.stack([_U, np.cross(DIRECTIONS, _U)], axis=1)  # (26, 2, 3): with each direction a right-handed frame
_ON = 1e-7  # of a polytope's size: a corner nearer to a plane lies in it
_THIN = 1e-4  # m


@dataclass(frozen=True, eq=False)
class Box:
    """A box: size (3,) [m] along its own axes, X (4, 4) its centre in the frame it is given in."""

    name: str
    size: Array
    X: Array = field(default_factory=lambda: np.eye(4))

    def __post_init__(self) -> None:
        object.__setattr__(self, "size", _vector(self.size, f"box '{self.name}': size"))
        object.__setattr__(self, "X", _pose(self.X, f"box '{self.name}'"))
        if not np.all(self.size > 0):
            raise ValueError(f"box '{self.name}': size {self.size} m, wanted three lengths above zero")


@dataclass(frozen=True, eq=False)
class Capsule:
    """All points within radius [m] of the segment from a to b (3,) [m]; a sphere where a and b are one point."""

    name: str
    a: Array
    b: Array
    radius: float

    def __post_init__(self) -> None:
        for end in ("a", "b"):
            object.__setattr__(self, end, _vector(getattr(self, end), f"capsule '{self.name}': {end}"))
        if not (np.isfinite(self.radius) and self.radius > 0):
            raise ValueError(f"capsule '{self.name}': radius {self.radius} m, wanted a length above zero")


@dataclass(frozen=True, eq=False)
class Mesh:
    """A triangle mesh: vertices (n, 3) [m], triangles (m, 3) of their indices, X (4, 4) in the frame it is given in.

    Closed surfaces are solid: a body inside them overlaps. of: the mesh with the same surface that this one is moved
    from, so that what is found out about a surface need not be found out again.
    """

    name: str
    vertices: Array
    triangles: TriangleArray
    X: Array = field(default_factory=lambda: np.eye(4))
    of: Mesh | None = field(default=None, repr=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "X", _pose(self.X, f"mesh '{self.name}'"))
        if self.of is not None:
            return
        object.__setattr__(self, "vertices", readonly(self.vertices))
        triangles = np.array(self.triangles, dtype=np.int64)
        triangles.setflags(write=False)
        object.__setattr__(self, "triangles", triangles)
        for what, values in (("vertices", self.vertices), ("triangles", triangles)):
            if values.ndim != 2 or values.shape[1] != 3 or not len(values):
                raise ValueError(f"mesh '{self.name}': {what} have shape {values.shape}, wanted (n, 3)")
        if not np.isfinite(self.vertices).all():
            raise ValueError(f"mesh '{self.name}': a vertex is not finite")
        if triangles.min() < 0 or triangles.max() >= len(self.vertices):
            raise ValueError(f"mesh '{self.name}': a triangle names a vertex outside 0..{len(self.vertices) - 1}")


@dataclass(frozen=True, eq=False)
class Polytope(Mesh):
    """A mesh that is the whole surface of a convex body; outer: a capsule around it in its own axes."""

    outer: Capsule = field(init=False)

    def __post_init__(self) -> None:
        super().__post_init__()
        object.__setattr__(self, "outer", _capsule_around(self.name, self.vertices))


def polytope(name: str, reach: Sequence[float]) -> Polytope:
    """The body that reaches as far as reach (26,) [m] in DIRECTIONS at most: all x with DIRECTIONS @ x <= reach.

    Raises ValueError where nothing thick is left between the planes.
    """
    return _between(name, tuple(reach))


@lru_cache(maxsize=512)
def _between(name: str, reach: tuple[float, ...]) -> Polytope:
    h = np.array(reach)
    planes, inverses = _crossings()
    near = _ON * float(np.abs(h).max())
    corners = np.einsum("kij,kj->ki", inverses, h[planes])
    corners = corners[(corners @ DIRECTIONS.T <= h + near).all(axis=1)]
    same = np.linalg.norm(corners[:, None] - corners, axis=2) < 20 * near  # of a flat edge off by more than the planes
    corners = corners[~np.tril(same, -1).any(axis=1)]
    if len(corners) < 4 or np.linalg.svd(corners - corners.mean(axis=0), compute_uv=False)[-1] < _THIN:
        raise ValueError(f"polytope '{name}': its planes leave no body between them")
    triangles: list[tuple[int, int, int]] = []
    for n, (u, v), far in zip(DIRECTIONS, _SIDES, h, strict=True):
        face = np.flatnonzero(corners @ n > far - 20 * near)
        arms = corners[face] - corners[face].mean(axis=0) if len(face) else corners[face]
        first, *others = face[np.argsort(np.arctan2(arms @ v, arms @ u))].tolist() or [0]
        triangles += [(first, b, c) for b, c in pairwise(others)]
    return Polytope(name, corners, np.array(triangles))


@lru_cache(maxsize=1)
def _crossings() -> tuple[TriangleArray, Array]:
    """Three planes each (k, 3) that cross in one point, and the inverses (k, 3, 3) that give it from their reach."""
    planes = np.array([*combinations(range(len(DIRECTIONS)), 3)])
    planes = planes[np.abs(np.linalg.det(DIRECTIONS[planes])) > 1e-6]
    return planes, np.linalg.inv(DIRECTIONS[planes])


def _capsule_around(name: str, points: Array) -> Capsule:
    """A capsule that holds points (n, 3): of those along DIRECTIONS, about the middle of what they span, the least."""
    found = []
    for n, sides in zip(DIRECTIONS[13:], _SIDES[13:], strict=True):
        flat, t = points @ sides.T, points @ n
        centre = (flat.min(axis=0) + flat.max(axis=0)) / 2
        aside = np.linalg.norm(flat - centre, axis=1)
        radius = max(float(aside.max()), _THIN)
        cap = np.sqrt(np.maximum(radius**2 - aside**2, 0.0))  # rounding may leave less than none
        low, high = float((t + cap).min()), float((t - cap).max())
        low, high = min(low, (low + high) / 2), max(high, (low + high) / 2)
        found.append((radius**2 * (high - low + 4 / 3 * radius), radius, centre @ sides + np.outer([low, high], n)))
    _, radius, (a, b) = min(found, key=lambda one: one[0])
    return Capsule(name, a, b, radius)


@dataclass(frozen=True, eq=False)
class MeshFile:
    """A mesh that still lies in a file: its coordinates times scale, one for all or each, are metres, X (4, 4) places
    them."""

    name: str
    path: Path
    X: Array = field(default_factory=lambda: np.eye(4))
    scale: float | tuple[float, float, float] = 1.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "X", _pose(self.X, f"mesh '{self.name}'"))
        if not (np.isfinite(self.scale).all() and np.min(self.scale) > 0):
            raise ValueError(f"mesh '{self.name}': scale {self.scale}, wanted a number above zero")

    @property
    def files(self) -> tuple[Path, ...]:
        """The file and, of a .gltf, the buffers that it names beside itself."""
        if self.path.suffix.lower() != ".gltf" or not self.path.is_file():
            return (self.path,)
        names = re.findall(r'"uri"\s*:\s*"((?!data:)[^"]+\.bin)"', self.path.read_text("utf-8", "replace"))
        return (self.path, *(self.path.parent / unquote(name) for name in names))


Shape = Box | Capsule | Mesh
LinkShape = Capsule | Polytope


class Rides(NamedTuple):
    """What a solid stands on: a positioner (in lower case), and the number of its axes, from the floor on, that turn
    it."""

    unit: str
    axes: int


@dataclass(frozen=True, eq=False)
class Solid:
    """A shape that must not be touched, but by the links in ignore. rides: it turns with a positioner. A cell gives
    it in the frame that the positioner's axis carries, a plant in the world, as it stands with all axes at start."""

    shape: Shape | MeshFile
    ignore: frozenset[str] = frozenset()
    rides: Rides | None = None

    @property
    def name(self) -> str:
        """The shape's name."""
        return self.shape.name

    @property
    def loaded(self) -> Shape:
        """The shape of a plant's solid: build_plant loads meshes."""
        assert not isinstance(self.shape, MeshFile)
        return self.shape


@dataclass(frozen=True)
class Cue:
    """When a program grips or releases: at the line of a motion, a wait or an output, or when a signal gets a value.

    line: counted from 1, of the file of this name (None: of any). signal: in lower case. One of line and signal is
    None.
    """

    file: str | None = None
    line: int | None = None
    signal: str | None = None
    value: float = 0.0

    def __str__(self) -> str:
        if self.line is None:
            return f"{self.signal} = {self.value:g}"
        return f"line {self.line}" if self.file is None else f"{self.file}:{self.line}"


@dataclass(frozen=True)
class Grip:
    """An obstacle that the flange takes at a cue and leaves at another one; detach None: it keeps it."""

    part: str
    at: Cue
    detach: Cue | None = None


def moved(shape: Shape, X: ArrayLike) -> Shape:
    """The shape after a rigid motion X (4, 4) of the frame it is given in."""
    X = np.asarray(X, dtype=np.float64)
    if isinstance(shape, Capsule):
        return replace(shape, a=X[:3, :3] @ shape.a + X[:3, 3], b=X[:3, :3] @ shape.b + X[:3, 3])
    if isinstance(shape, Mesh):
        return replace(shape, X=X @ shape.X, of=shape.of or shape)
    return replace(shape, X=X @ shape.X)


def outline(shape: Shape) -> tuple[Array, float]:
    """Points (n, 3) and a radius [m]: their convex hull grown by the radius holds the shape, in the frame of its X.

    A polytope gives its outer capsule, a mesh the eight corners of the box around its vertices.
    """
    match shape:
        case Capsule():
            return np.array([shape.a, shape.b]), shape.radius
        case Box():
            corners = (_CORNERS - 0.5) * shape.size
        case Polytope(outer=outer):
            ends = np.array([outer.a, outer.b])
            return ends @ shape.X[:3, :3].T + shape.X[:3, 3], outer.radius
        case Mesh():
            low, high = shape.vertices.min(axis=0), shape.vertices.max(axis=0)
            corners = low + _CORNERS * (high - low)
    return corners @ shape.X[:3, :3].T + shape.X[:3, 3], 0.0


def _vector(values: ArrayLike, what: str) -> Array:
    out = readonly(values)
    if out.shape != (3,) or not np.isfinite(out).all():
        raise ValueError(f"{what} is {out.tolist()}, wanted three finite numbers")
    return out


def _pose(X: ArrayLike, what: str) -> Array:
    out = readonly(X)
    if out.shape != (4, 4) or not np.isfinite(out).all():
        raise ValueError(f"{what}: X has shape {out.shape}, wanted a finite (4, 4)")
    if np.abs(out[:3, :3] @ out[:3, :3].T - np.eye(3)).max() > _SKEW or np.linalg.det(out[:3, :3]) < 0:
        raise ValueError(f"{what}: X has no rotation in its first three rows and columns")
    return out
