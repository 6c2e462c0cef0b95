"""Any legal URDF as a tree of links and joints: what may be left out has its default, what is wrong has its line."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from math import pi
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.robot.urdf import rotation_rpy
from trajopt_cli.urdf_text import read_robot_element

TURNING, SLIDING, FIXED = "revolute", "prismatic", "fixed"
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
_TURNS = 4 * pi  # rad of an origin's angle: beyond, somebody wrote degrees
_BODY = 1.01  # how far the greatest main moment of inertia may pass the sum of the others by rounded digits
_MOST = 1e6  # m, rad, kg, N: squares of such numbers still have a meaning
_KINDS = {TURNING, "continuous", SLIDING, FIXED, "floating", "planar"}


@dataclass(frozen=True, eq=False)
class Inertial:
    """A link's mass [kg], centre of mass (3,) [m] and inertia (3, 3) [kg m2] about it, in the link's frame and axes."""

    mass: float
    centre: Array
    inertia: Array


@dataclass(frozen=True, eq=False)
class CollisionShape:
    """One <collision> of a link: X (4, 4) in the link's frame; kind box, cylinder, sphere or mesh with its sizes [m],
    radius and length [m], radius [m], or scale (3,); file: of a mesh, as the URDF names it."""

    kind: str
    X: Array
    sizes: tuple[float, ...]
    file: str = ""


@dataclass(frozen=True, eq=False)
class Link:
    """A link: inertial None where the URDF gives none."""

    name: str
    inertial: Inertial | None
    shapes: tuple[CollisionShape, ...]


@dataclass(frozen=True, eq=False)
class TreeJoint:
    """A joint: X its frame in the parent link (4, 4), axis (3,) a unit vector; range [rad or m] and speed [1/s] None
    where the URDF gives none, effort 0. mimic: the joint it follows, "" for none; multiplier: how fast."""

    name: str
    kind: str
    parent: str
    child: str
    X: Array
    axis: Array
    lower: float | None
    upper: float | None
    velocity: float | None
    effort: float
    mimic: str
    multiplier: float = 1.0


@dataclass(frozen=True, eq=False)
class Tree:
    """A whole URDF. by_child: the joint that leads to a link; notes: what was taken otherwise than it stands there."""

    path: Path
    name: str
    links: Mapping[str, Link]
    joints: tuple[TreeJoint, ...]
    root: str
    notes: tuple[str, ...] = ()
    by_child: Mapping[str, TreeJoint] = field(default_factory=dict)

    def leaves(self) -> list[str]:
        """Links from which no joint goes on, in the file's order."""
        parents = {joint.parent for joint in self.joints}
        return [name for name in self.links if name not in parents]


def read_tree(path: Path) -> Tree:
    """Read any legal URDF. Raises InputError, one line, for what is not legal; what it says of joints that do not
    matter is refused all the same."""
    root = read_robot_element(path)
    reader = _Reader(str(path))
    links: dict[str, Link] = {}
    for element in root.findall("link"):
        name = reader.named(element, "link", links)
        links[name] = reader.link(element, name)
    joints: dict[str, TreeJoint] = {}
    for element in root.findall("joint"):
        name = reader.named(element, "joint", joints)
        joints[name] = reader.joint(element, name, links)
    if not links:
        raise InputError("has no <link>: a robot has some", file=str(path))
    by_child: dict[str, TreeJoint] = {}
    for joint in joints.values():
        if (other := by_child.setdefault(joint.child, joint)) is not joint:
            message = (
                f"link '{joint.child}' hangs on two joints, '{other.name}' and '{joint.name}': a URDF is a tree without"
                " loops; remove the joint that closes the loop"
            )
            raise InputError(message, file=str(path))
    roots = [name for name in links if name not in by_child]
    if len(roots) != 1:
        if not roots:
            message = f"every link hangs on a joint, in a loop with '{joints[min(joints)].name}': one link is the root"
        else:
            message = f"has {len(roots)} roots, {_some(roots)}: a URDF is one tree; join them or remove what is loose"
        raise InputError(message, file=str(path))
    tree = Tree(path, root.get("name", path.stem), links, tuple(joints.values()), roots[0], (), by_child)
    reached = {roots[0]}
    for _ in joints:
        more = {joint.child for joint in tree.joints if joint.parent in reached} - reached
        if not more:
            break
        reached |= more
    if loose := [name for name in links if name not in reached]:
        message = f"links {_some(loose)} hang on each other in a loop and not on '{roots[0]}': a URDF is one tree"
        raise InputError(message, file=str(path))
    return Tree(path, tree.name, links, tree.joints, roots[0], tuple(reader.notes), by_child)


def _some(names: list[str]) -> str:
    return ", ".join(names[:6]) + (f" and {len(names) - 6} more" if len(names) > 6 else "")


class _Reader:
    """Elements of one file to data; notes collects what is taken otherwise than it stands there."""

    def __init__(self, file: str):
        self.file = file
        self.notes: list[str] = []

    def error(self, message: str) -> InputError:
        return InputError(message, file=self.file)

    def named(self, element: ElementTree.Element, what: str, known: Mapping[str, object]) -> str:
        name = element.get("name", "").strip()
        if not name:
            raise self.error(f"a <{what}> has no name: give it one")
        if name in known:
            raise self.error(f"two {what}s are called '{name}': rename one")
        if not name.isprintable():
            self.notes.append(f"{what} '{name}': a tab, a line break or the like in its name; better rename it")
        return name

    def numbers(self, text: str, count: int, what: str) -> list[float]:
        words = text.split()
        if len(words) != count or not all(map(_NUMBER.fullmatch, words)):
            raise self.error(f'{what}="{text}" is not {"a number" if count == 1 else f"{count} numbers"}')
        values = [float(word) for word in words]
        if max(map(abs, values)) > _MOST:
            raise self.error(f'{what}="{text}": no robot has numbers beyond {_MOST:g}; correct it')
        return values

    def pose(self, element: ElementTree.Element | None, what: str) -> Array:
        """The <origin> inside an element; the identity where it, its xyz or its rpy is left out."""
        X = np.eye(4)
        origin = None if element is None else element.find("origin")
        if origin is not None:
            X[:3, 3] = self.numbers(origin.get("xyz", "0 0 0"), 3, f"{what}: <origin> xyz")
            text = origin.get("rpy", "0 0 0")
            angles = self.numbers(text, 3, f"{what}: <origin> rpy")
            if (most := max(map(abs, angles))) > _TURNS:
                message = f'{what}: <origin> rpy="{text}" turns by {most:g} rad; a URDF\'s angles are in radians'
                raise self.error(f"{message}: 90 degrees are 1.5707963267948966")
            exact = [_right_angle(word, angle) for word, angle in zip(text.split(), angles, strict=True)]
            if exact != angles and any(abs(a - b) > 1e-9 for a, b in zip(exact, angles, strict=True)):
                degrees = " ".join(f"{angle * 180 / pi:g}" for angle in exact)
                self.notes.append(f"{what}: rpy {text} is taken as {degrees} degrees, which its digits round")
            X[:3, :3] = rotation_rpy(exact[0], exact[1], exact[2])
        X[:3, 3] = np.where(np.abs(X[:3, 3]) < 1e-12, 0.0, X[:3, 3])
        return X

    def link(self, element: ElementTree.Element, name: str) -> Link:
        where = f"link '{name}'"
        inertial = None
        if (part := element.find("inertial")) is not None:
            mass = self.value(part.find("mass"), "value", f"{where}: <mass> value")
            if mass is None:
                raise self.error(f"{where}: <inertial> has no <mass value=...>: give it or remove <inertial>")
            if mass < 0:
                raise self.error(f"{where}: mass {mass:g} kg is negative")
            X = self.pose(part, f"{where}: <inertial>")
            given = part.find("inertia")
            keys = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
            xx, xy, xz, yy, yz, zz = (self.value(given, key, f"{where}: <inertia> {key}") or 0.0 for key in keys)
            tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
            self.check_inertia(mass, tensor, where)
            inertial = Inertial(mass, X[:3, 3], X[:3, :3] @ tensor @ X[:3, :3].T)
        shapes = [shape for part in element.findall("collision") if (shape := self.shape(part, where)) is not None]
        return Link(name, inertial, tuple(shapes))

    def check_inertia(self, mass: float, tensor: Array, where: str) -> None:
        """Raise InputError for an inertia (3, 3) [kg m2] with a negative main moment; note one that no body has."""
        main = np.linalg.eigvalsh(tensor)
        said = " ".join(f"{value:.4g}" for value in main.tolist())
        if main[0] < -1e-6 * max(main[2], 1e-9):
            message = f"{where}: <inertia> has the main moments {said} kg m2, and no body has a negative one"
            raise self.error(f"{message}; correct it or remove <inertial>")
        if main[2] > _BODY * (main[0] + main[1]) + 1e-9:
            note = f"{where}: <inertia> has the main moments {said} kg m2, but of a body the greatest is at most the"
            self.notes.append(f"{note} sum of the others; torques computed from it are wrong: correct it")
        if mass == 0 and main[2] > 0:
            self.notes.append(f"{where}: an <inertia> without mass; torques computed from it are wrong: give its mass")

    def value(self, element: ElementTree.Element | None, key: str, what: str) -> float | None:
        """A number that may be left out."""
        text = None if element is None else element.get(key)
        return None if text is None else self.numbers(text, 1, what)[0]

    def shape(self, element: ElementTree.Element, where: str) -> CollisionShape | None:
        geometry = element.find("geometry")
        given = None if geometry is None else next(iter(geometry), None)
        if given is None:
            return None
        X, kind, what = self.pose(element, f"{where}: <collision>"), str(given.tag), f"{where}: collision <{given.tag}>"
        wanted = {"box": (("size", 3),), "cylinder": (("radius", 1), ("length", 1)), "sphere": (("radius", 1),)}
        if kind == "mesh":
            text = given.get("scale", "1 1 1")
            sizes = self.numbers(text, 3, f"{what} scale")
            if 0 in sizes:
                raise self.error(f'{what} scale="{text}" makes it flat: wanted numbers other than 0, 0.001 for mm')
            if sizes != [1.0] * 3 and not any(" is scaled by " in note for note in self.notes):
                scaled = f"{where}: its collision mesh is scaled by {text}, as its scale says"
                self.notes.append(f"{scaled}; other meshes by theirs")
            return CollisionShape(kind, X, tuple(sizes), given.get("filename", ""))
        if kind == "capsule":  # not in the format's first version, but written by many tools
            kind = "cylinder"
        if kind not in wanted:
            self.notes.append(f"{where}: collision <{given.tag}> is no shape of the format and left out")
            return None
        found: list[float] = []
        for key, count in wanted[kind]:
            found += self.numbers(given.get(key, ""), count, f"{what} {key}")
        if min(found) <= 0:
            raise self.error(f"{what}: sizes {' '.join(f'{size:g}' for size in found)} m, wanted lengths above zero")
        return CollisionShape(kind, X, tuple(found))

    def joint(self, element: ElementTree.Element, name: str, links: Mapping[str, Link]) -> TreeJoint:
        where, kind = f"joint '{name}'", element.get("type", "")
        if kind not in _KINDS:
            raise self.error(f"{where} has type '{kind}': the format knows {', '.join(sorted(_KINDS))}")
        ends = []
        for tag in ("parent", "child"):
            part = element.find(tag)
            link = "" if part is None else part.get("link", "").strip()
            if not link:
                raise self.error(f"{where} has no <{tag} link=...>")
            if link not in links:
                raise self.error(f"{where}: {tag} link '{link}' is not in the file: add its <link> or correct the name")
            ends.append(link)
        X = self.pose(element, where)
        axis = np.array([1.0, 0.0, 0.0])
        given = element.find("axis")
        if kind not in (FIXED, "floating") and given is not None:  # without one it is x: the format's default
            text = given.get("xyz", "1 0 0")
            axis = np.array(self.numbers(text, 3, f"{where}: <axis> xyz"))
            length = float(np.linalg.norm(axis))
            if length < 1e-9:
                raise self.error(f'{where}: <axis> xyz="{text}" has no direction; give a unit vector')
            if abs(length - 1) > 1e-9:
                self.notes.append(f"{where}: axis {text} has length {length:.6g} and is taken as a direction alone")
                axis = axis / length
        limit = element.find("limit")
        lower, upper, velocity, effort = (
            self.value(limit, key, f"{where}: <limit> {key}") for key in ("lower", "upper", "velocity", "effort")
        )
        if limit is not None and kind in (TURNING, SLIDING):
            lower, upper = lower or 0.0, upper or 0.0  # the format's defaults
        if element.find("safety_controller") is not None and kind in (TURNING, SLIDING):
            self.notes.append(f"{where}: the range is that of <limit>; <safety_controller> is not looked at")
        mimic = element.find("mimic")
        follows = "" if mimic is None else mimic.get("joint", "?")
        factor = self.value(mimic, "multiplier", f"{where}: <mimic> multiplier")
        ends_and_range = ends[0], ends[1], X, axis, lower, upper, velocity, effort or 0.0
        return TreeJoint(name, kind, *ends_and_range, follows, 1.0 if factor is None else factor)


def _right_angle(word: str, angle: float) -> float:
    """The multiple of a right angle that a number in decimals stands for: 1.57, 1.5708 and 3.14159 have as many digits
    as somebody cared to write."""
    turns = round(angle / (pi / 2))
    decimals = len(word.partition(".")[2])
    if turns and decimals >= 2 and "e" not in word.lower() and abs(angle - turns * pi / 2) < 10.0**-decimals:
        return turns * pi / 2
    return angle
