"""Bodies around the links from a URDF's collision geometry, and which pairs of links are worth watching."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import unquote, urlparse

import numpy as np
from scipy.spatial import ConvexHull

from trajopt_cli.adopt.capsule import capsule_volume, smallest_capsule
from trajopt_cli.adopt.chain import NormalChain
from trajopt_cli.adopt.polytopes import polytopes_around, volume
from trajopt_cli.adopt.tree import FIXED, CollisionShape
from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, rotation_about
from trajopt_cli.proximity.pair import Pair
from trajopt_cli.robot.urdf import UrdfJoint
from trajopt_cli.shapes import ATTACHED, LinkShape, MeshFile

POSTURES = 4000
_SEED = 140
_OFTEN, _EVER = 0.1, 0.9  # of all postures: see self_pairs
_LONGEST = 20.0  # m of a link: beyond, a mesh is in other units
_ROUND = 24  # sides of a cylinder's or sphere's outline


@dataclass(frozen=True, eq=False)
class LinkBodies:
    """bodies: by link name; missing: meshes that are not there or cannot be read, one line each."""

    bodies: Mapping[str, tuple[LinkShape, ...]]
    missing: tuple[str, ...]


def link_bodies(chain: NormalChain, capsules: bool = False) -> LinkBodies:
    """Bodies around every link of the arm whose collision geometry is given and readable: one capsule or polytopes,
    whichever have less volume; capsules True: one capsule."""
    bodies, missing = {}, []
    for body in chain.arm:
        surface: list[Array] = []
        complete = True
        for shape in body.shapes:
            try:
                surface.append(_triangles(shape, chain.tree.path))
            except InputError as error:
                missing.append(f"{body.name}: {error.message}")
                complete = False
        if complete and surface:  # part of a link's shapes would be a body around part of it
            bodies[body.name] = _around(body.name, np.concatenate(surface), capsules)
    return LinkBodies(bodies, tuple(missing))


def _around(name: str, triangles: Array, capsules: bool) -> tuple[LinkShape, ...]:
    capsule = smallest_capsule(name, triangles.reshape(-1, 3))
    if capsules:
        return (capsule,)
    try:
        parts = polytopes_around(name, triangles)
    except ValueError:  # a plate
        return (capsule,)
    return (capsule,) if capsule_volume(capsule) < sum(map(volume, parts)) else tuple(parts)


def find_mesh(name: str, urdf: Path) -> Path:
    """Where a mesh lies that a URDF names: beside it, or for package://PACKAGE/PATH in the nearest folder above it that
    is the package or holds it. Raises InputError, unplaced, where it is nowhere."""
    url = urlparse(name)
    if url.scheme in ("package", "model"):
        inner = unquote(url.path).lstrip("/")
        for folder in urdf.resolve().parents:
            for candidate in (folder / url.netloc / inner, folder / inner if folder.name == url.netloc else None):
                if candidate is not None and candidate.is_file():
                    return candidate
        raise InputError(
            f"mesh {name} is in no folder above the URDF: put the folder '{url.netloc}' beside it, or the link has no"
            " body"
        )
    path = Path(unquote(url.path)) if url.scheme == "file" else urdf.parent / name
    if not path.is_file():
        raise InputError(f"mesh {name} is not there: put it beside the URDF, or the link has no body")
    return path


def _triangles(shape: CollisionShape, urdf: Path) -> Array:
    """The shape's surface (m, 3, 3), of round ones a little larger, in the link's frame."""
    if shape.kind == "mesh":
        from trajopt_cli.proximity.meshes import load_mesh

        mesh = load_mesh(MeshFile("mesh", find_mesh(shape.file, urdf)))
        points, corners = mesh.vertices * np.array(shape.sizes), mesh.triangles
        if (long := float(np.ptp(points, axis=0).max())) > _LONGEST:
            message = f"mesh {shape.file} is {long:.4g} m long, so the link has no body"
            raise InputError(f'{message}: if it is drawn in mm, say <mesh scale="0.001 0.001 0.001">')
    elif shape.kind == "box":
        corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
        points = corners * np.array(shape.sizes) / 2
    else:
        angles = 2 * np.pi * np.arange(_ROUND) / _ROUND
        sides = 1 if shape.kind == "cylinder" else 2
        radius = shape.sizes[0] / np.cos(np.pi / _ROUND) ** sides  # the polygons lie around the circles
        ring = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(_ROUND)]) * radius
        if shape.kind == "cylinder":
            half = np.array([0, 0, shape.sizes[1] / 2])
            points = np.vstack([ring - half, ring + half])
        else:
            points = np.vstack([ring @ rotation_about([1, 0, 0], turn).T for turn in angles[: _ROUND // 2]])
    if shape.kind != "mesh":
        corners = np.asarray(ConvexHull(points).simplices, dtype=np.int64)
    return np.asarray((points @ shape.X[:3, :3].T + shape.X[:3, 3])[corners])


def self_pairs(
    joints: Sequence[UrdfJoint], bodies: Mapping[str, Sequence[LinkShape]], linkage: float = 0.0
) -> tuple[tuple[str, str], ...]:
    """Pairs of links worth holding against each other, the one nearer the base first; "attached" stands for what the
    flange carries. joints: the arm's and the flange's. linkage: joint 3 is axis 3 - linkage * axis 2.

    Left out are neighbours, pairs that touch in none of POSTURES within the ranges, and pairs whose bodies overlap
    because they are larger than the links: with all axes at 0 or in more than _EVER of the postures, of links with one
    between them, whose way the two axes' ranges bound, in more than _OFTEN. The same postures every time.
    """
    names = [joints[0].parent, *(joint.child for joint in joints[:-1])]
    q = np.vstack([np.zeros((1, len(joints) - 1)), sampled(joints, POSTURES)])
    q[:, 2] -= linkage * q[:, 1]
    poses = link_poses(joints, q)
    pairs: list[tuple[str, str]] = []
    known = [i for i, name in enumerate(names) if name in bodies]
    for i in known:
        for j in known:
            if j > i + 1:
                X = np.linalg.inv(poses[:, i]) @ poses[:, j]
                each = [Pair(b, a).distances(X) <= 0 for a in bodies[names[i]] for b in bodies[names[j]]]
                touch = np.any(each, axis=0)
                if not touch[0] and 0 < float(np.mean(touch)) <= (_OFTEN if j == i + 2 else _EVER):
                    pairs.append((names[i], names[j]))
        if i < len(joints) - 3:  # what is carried touches the wrist by where it stands
            pairs.append((names[i], ATTACHED))
    return tuple(pairs)


def sampled(joints: Sequence[UrdfJoint], count: int) -> Array:
    """Postures (count, k) within the ranges [rad] of all but the flange's joint, evenly spread and always the same."""
    lower, upper = (np.array([getattr(joint, end) for joint in joints[:-1]]) for end in ("lower", "upper"))
    return np.asarray(lower + np.random.default_rng(_SEED).random((count, len(lower))) * (upper - lower))


def link_poses(joints: Iterable[UrdfJoint], q: Array) -> Array:
    """Poses (n, k + 1, 4, 4) of the first link and the one behind each joint, seen from the first, at q (n, m) of the m
    joints that move."""
    X = np.broadcast_to(np.eye(4), (len(q), 4, 4))
    found, column = [X], 0
    for joint in joints:
        X = X @ joint.X
        if joint.kind != FIXED:
            step = np.broadcast_to(np.eye(4), (len(q), 4, 4)).copy()
            if joint.kind == "prismatic":
                step[:, :3, 3] = q[:, column, None] * joint.axis
            else:
                step[:, :3, :3] = rotation_about(joint.axis, q[:, column])
            X, column = X @ step, column + 1
        found.append(X)
    return np.stack(found, axis=1)
