"""Bodies from files that hold many: a URDF of a cell, a folder of meshes, a list of meshes with their poses.

URDF: its format's specification (wiki.ros.org/urdf/XML). Angles rx, ry, rz of a list turn about the fixed x, then y,
then z, as URDF's rpy and RobotStudio's orientations do.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import unquote, urlparse
from xml.etree import ElementTree

import numpy as np

from trajopt_cli.cell.document import BodyList, FrameSection, ListedBody
from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, pose, rotation_about, rotation_from_wxyz
from trajopt_cli.shapes import Box, Capsule, Mesh, MeshFile, Shape
from trajopt_cli.units import DEG, MM, decimal
from trajopt_cli.urdf_text import read_bytes, robot_element
from trajopt_cli.yaml_file import parse, read_text, validated

MESHES = (".stl", ".obj", ".glb", ".gltf", ".step", ".stp")
_SIDES = 24  # of a cylinder's outline
_UNITS = {"length": {"mm": MM, "m": 1.0}, "angle": {"deg": DEG, "rad": 1.0}, "": {"": 1.0}}
_HEAD = re.compile(r"\s*(\w+?)\s*(?:[\[(]\s*(\w+)\s*[\])])?\s*")
_POSE = {"x": "length", "y": "length", "z": "length", "rx": "angle", "ry": "angle", "rz": "angle"}
_NUMBERS = {"position": "x y z", "rpy": "rx ry rz", "wxyz": "q1 q2 q3 q4", "scale": "scale"}
_COLUMNS = ("name", "file", *" ".join(_NUMBERS.values()).split(), "on", "ignore")


@dataclass(frozen=True, eq=False)
class Found:
    """Bodies in the world or on what carries them; which links may touch each, and what it rides on, as its own file
    says. files: all that were read besides meshes. notes: what is taken otherwise than it stands there."""

    shapes: list[tuple[Shape | MeshFile, Sequence[str], str | None]] = field(default_factory=list)
    files: list[Path] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)


def frame_pose(section: FrameSection) -> Array:
    """The pose (4, 4) that a frame section describes."""
    if section.wxyz is not None:
        return pose(rotation_from_wxyz(section.wxyz), section.position)
    return pose(_rotation(*(section.rpy or (0.0, 0.0, 0.0))), section.position)


def _rotation(roll: float, pitch: float, yaw: float) -> Array:
    """Rz Ry Rx (3, 3) of angles in rad."""
    return rotation_about([0, 0, 1], yaw) @ rotation_about([0, 1, 0], pitch) @ rotation_about([1, 0, 0], roll)


def from_folder(name: str, folder: Path, X: Array, scale: float) -> Found:
    """Every mesh file of a folder, all at X (4, 4), each body `name/stem`. Raises InputError for a folder without."""
    paths = sorted(path for path in folder.glob("*") if path.suffix.lower() in MESHES) if folder.is_dir() else []
    if not paths:
        raise InputError(f"no mesh files in the folder {folder}; wanted {', '.join(MESHES)}")
    stems = [path.stem for path in paths]
    names = [path.stem if stems.count(path.stem) == 1 else path.name for path in paths]
    return Found(
        [(MeshFile(f"{name}/{own}", path, X, scale), (), None) for own, path in zip(names, paths, strict=True)]
    )


def from_list(name: str, path: Path, X: Array) -> Found:
    """The bodies of a list, CSV or YAML, whose poses are seen from X (4, 4). Raises InputError with the list's line."""
    text, file = read_text(path, "list of bodies"), str(path)
    if path.suffix.lower() in (".yaml", ".yml"):
        content, lines = parse(text, file, "give bodies by name: {post: {file: post.stl, position: [1, 0, 0]}}")
    else:
        content, lines = _table(text, file)
    bodies = validated(BodyList, content, lines, file, {"file": "name the body's mesh file"}).root
    return Found([(_mesh(f"{name}/{own}", path.parent, body, X), body.ignore, body.on) for own, body in bodies.items()],
                 [path])  # fmt: skip


def _mesh(name: str, folder: Path, body: ListedBody, X: Array) -> MeshFile:
    return MeshFile(name, folder / body.file, X @ frame_pose(body), body.scale)


def _table(text: str, file: str) -> tuple[dict[str, object], dict[str, int]]:
    """The rows of a CSV list as a YAML list has them: name, file, x, y, z, then rx, ry, rz or q1 to q4, scale, on,
    ignore; each length and angle with its unit in the head, `x [mm]`."""
    rows = [(i, line) for i, line in enumerate(text.splitlines(), 1) if line.strip() and not line.startswith("#")]
    first, head = rows[0] if rows else (1, "")
    by = max(",;\t", key=head.count)
    worth: dict[str, float] = {}  # of each column's unit
    for given in head.split(by):
        match = _HEAD.fullmatch(given)
        name, unit = (match[1].lower(), match[2] or "") if match else ("", "")
        units = _UNITS[_POSE.get(name, "")]
        if name not in _COLUMNS or name in worth or unit not in units:
            asked = "" if unit in units else f", the unit one of {', '.join(f'[{one}]' for one in units)}"
            text = f"column '{given.strip()}': wanted {', '.join(_COLUMNS)}, each once{asked}"
            raise InputError(text, file=file, line=first)
        worth[name] = units[unit]
    content, lines = dict[str, object](), dict[str, int]()
    for line, row_text in rows[1:]:
        row = next(csv.reader([row_text], delimiter=by))
        if len(row) != len(worth):
            raise InputError(f"{len(row)} values, wanted {len(worth)}", file=file, line=line)
        body = {column: cell.strip() for column, cell in zip(worth, row, strict=True) if cell.strip()}
        own = body.pop("name", body.get("file", ""))
        if own in content:
            raise InputError(f"two bodies are called '{own}'; rename one", file=file, line=line)
        entry: dict[str, object] = {}
        for key, columns in _NUMBERS.items():
            texts = {column: body.pop(column, "") for column in columns.split()}
            if any(texts.values()):
                try:
                    found = [decimal(one.replace(",", ".")) * worth.get(column, 1) for column, one in texts.items()]
                except ValueError as error:
                    wanted = f"'{own}': {columns} are {' '.join(one or '?' for one in texts.values())}; wanted numbers"
                    raise InputError(wanted, file=file, line=line) from error
                entry[key] = found if len(found) > 1 else found[0]
        if "ignore" in body:
            entry["ignore"] = body.pop("ignore").split()
        content[own], lines[own] = entry | body, line
    return content, lines


def from_urdf(name: str, path: Path, X: Array, root: Path) -> Found:
    """The collision geometry of a URDF's links, its visual one of those that have no other; its root link at X (4, 4),
    joints at 0. Bodies are called `name/link`, behind the first one of a link `name/link 2`. root: the folder that all
    files must be in. Raises InputError for what is no URDF."""
    file, out = str(path), Found(files=[path])
    element = robot_element(read_bytes(path), file)
    above: dict[str, tuple[str, Array]] = {}
    for joint in element.findall("joint"):
        parent, child = (_attribute(joint, tag, "link", file) for tag in ("parent", "child"))
        if child in above:
            raise InputError(f"link '{child}' hangs on two joints; a URDF is a tree", file=file)
        above[child] = parent, _origin(joint, file)
        if joint.get("type") != "fixed":
            out.notes.append(f"{path.name}: joint '{joint.get('name', '')}' moves; its links stand as at 0")
    for link in element.findall("link"):
        own = link.get("name", "")
        X_link, at, seen = np.eye(4), own, {own}
        while at in above:
            at, step = above[at]
            X_link = step @ X_link
            if at in seen:
                raise InputError(f"link '{own}' hangs on itself; a URDF is a tree", file=file)
            seen.add(at)
        parts = link.findall("collision") or link.findall("visual")
        for i, part in enumerate(parts, 1):
            body = f"{name}/{own}" + (f" {i}" if i > 1 else "")
            out.shapes.append((_geometry(body, part, X @ X_link @ _origin(part, file), path, root), (), None))
    if not out.shapes:
        raise InputError("no link has a <collision> or a <visual>", file=file)
    return out


def _geometry(name: str, part: ElementTree.Element, X: Array, path: Path, root: Path) -> Shape | MeshFile:
    file, geometry = str(path), part.find("geometry")
    shape = next(iter(geometry), None) if geometry is not None else None
    kind = "" if shape is None else str(shape.tag)
    if shape is None or kind not in ("box", "cylinder", "sphere", "capsule", "mesh"):
        raise InputError(
            f"'{name}' has the geometry <{kind}>; wanted box, cylinder, sphere, capsule or mesh", file=file
        )

    def sizes(key: str, count: int, default: str | None = None) -> list[float]:
        found = _numbers(shape.get(key, default or ""), count, f"'{name}' <{kind}> {key}", file)
        if min(found) <= 0:
            raise InputError(f"'{name}' <{kind}> {key}=\"{shape.get(key)}\"; wanted numbers above zero", file=file)
        return found

    if kind == "mesh":
        scale = sizes("scale", 3, "1 1 1")
        return MeshFile(name, _found(shape.get("filename", ""), path, root), X, (scale[0], scale[1], scale[2]))
    if kind == "box":
        return Box(name, np.array(sizes("size", 3)), X)
    (radius,), half = sizes("radius", 1), 0.0 if kind == "sphere" else sizes("length", 1)[0] / 2
    if kind != "cylinder":
        a, b = (X[:3, :3] @ np.array([0, 0, end]) + X[:3, 3] for end in (-half, half))
        return Capsule(name, a, b, radius)
    angles = 2 * np.pi * np.arange(_SIDES) / _SIDES
    ring = np.column_stack([np.cos(angles), np.sin(angles)]) * radius / np.cos(np.pi / _SIDES)  # around the circle
    vertices = np.vstack([np.column_stack([ring, np.full(_SIDES, z)]) for z in (-half, half)])
    i, k = np.arange(_SIDES), np.arange(1, _SIDES - 1)
    j, none = np.roll(i, -1), np.zeros_like(k)
    faces = [
        (i, j, _SIDES + j),
        (i, _SIDES + j, _SIDES + i),
        (none, k + 1, k),
        (_SIDES + none, _SIDES + k, _SIDES + k + 1),
    ]
    return Mesh(name, vertices, np.vstack([np.stack(face, axis=1) for face in faces]), X)


def _found(name: str, urdf: Path, root: Path) -> Path:
    """Where a mesh lies that a URDF names: beside it, or for package://PACKAGE/PATH in the nearest folder above it, not
    above root, that is the package or holds it."""
    url = urlparse(name)
    inner = unquote(url.path).lstrip("/")
    places = [urdf.parent / name]
    if url.scheme in ("package", "model"):
        above = [folder for folder in (urdf.parent, *urdf.parent.parents) if root == folder or root in folder.parents]
        resolved = [folder.resolve().name for folder in above]
        places = [folder / url.netloc / inner for folder in above]
        places += [folder / inner for folder, own in zip(above, resolved, strict=True) if own == url.netloc]
    found = next((place for place in places if place.is_file()), None)
    if found is None or ".." in found.parts or (not url.scheme and Path(name).is_absolute()):
        raise InputError(f"mesh {name} is not in the cell file's folder or below it, where results can keep it",
                         file=str(urdf))  # fmt: skip
    return found


def _origin(element: ElementTree.Element, file: str) -> Array:
    origin = element.find("origin")
    given: Mapping[str, str] = {} if origin is None else origin.attrib
    R = _rotation(*_numbers(given.get("rpy", "0 0 0"), 3, "<origin> rpy", file))
    return pose(R, _numbers(given.get("xyz", "0 0 0"), 3, "<origin> xyz", file))


def _attribute(element: ElementTree.Element, tag: str, key: str, file: str) -> str:
    found = element.find(tag)
    if found is None or not found.get(key):
        raise InputError(f"joint '{element.get('name', '')}' has no <{tag} {key}=...>", file=file)
    return str(found.get(key))


def _numbers(text: str, count: int, what: str, file: str) -> list[float]:
    try:
        found = [decimal(word) for word in text.split()]
    except ValueError:
        found = []
    if len(found) != count or not np.isfinite(found).all() or max(map(abs, found)) > 1e4:
        raise InputError(f'{what}="{text}" is not {count} number{"s" if count > 1 else ""} up to 10,000', file=file)
    return found
