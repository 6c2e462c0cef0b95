"""The one chain of a URDF that is the robot: found, checked and brought into the form robot files have."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import pi

import numpy as np

from trajopt_cli.adopt.tree import FIXED, SLIDING, TURNING, CollisionShape, Inertial, Tree, TreeJoint
from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.robot.urdf import FLANGE, RAIL, UrdfJoint

CARRIAGE, BASE = "rail_base", "base_link"
_FLANGES = (FLANGE, "flange")
_DUST = 1e-12  # m or a matrix entry: what products of rotations leave where there is nothing
_FARTHEST = 50.0  # rad: eight turns; beyond, somebody wrote degrees
_ALIKE = 1e-6  # of multipliers and directions
_WHOLE_TURN = 2 * pi  # a continuous axis goes as far to either side: the format gives it no range


@dataclass(frozen=True, eq=False)
class Body:
    """A link of the normal form and what the URDF's links in it hold, in its frame: inertial None where none is given,
    shapes of its collision geometry. links: those of the URDF, the one whose frame it has first."""

    name: str
    links: tuple[str, ...]
    inertial: Inertial | None
    shapes: tuple[CollisionShape, ...]


@dataclass(frozen=True, eq=False)
class NormalChain:
    """A chain as robot files have it. joints: from the root to tool0; axes called rail, joint_1 to joint_6 or 7, a
    fixed joint before joint_1 where the base of six axes stands off the root or the rail, one behind the last. named:
    the URDF's name of each axis. bodies: from the root on, joint i between body i and i + 1. notes: what was taken
    otherwise than it stands there, and what was left out. levers: joints beside the chain that tell a parallel linkage;
    linkage: then 1 or -1, joint_3 is the controller's axis 3 - linkage * axis 2.
    """

    tree: Tree
    base: str
    tip: str
    joints: tuple[UrdfJoint, ...]
    named: dict[str, str]
    bodies: tuple[Body, ...]
    notes: tuple[str, ...]
    levers: tuple[str, ...] = ()
    linkage: float = 0.0

    @property
    def turning(self) -> int:
        """How many joints turn: six or seven."""
        return sum(joint.kind == TURNING for joint in self.joints)

    @property
    def arm(self) -> tuple[Body, ...]:
        """The arm's bodies: its base and the link behind each joint that turns."""
        return self.bodies[-2 - self.turning : -1]

    @property
    def axes(self) -> list[UrdfJoint]:
        """The joints that move."""
        return [joint for joint in self.joints if joint.kind != FIXED]


def normal_chain(tree: Tree, tip: str | None = None, base: str | None = None) -> NormalChain:
    """The chain to the flange in normal form. tip: the flange's link, base: the first link, both found where None.

    Raises InputError for names that are none, a chain that is not six turning joints with at most one sliding joint
    before them or seven turning ones, and an axis without a range or a speed.
    """
    file = str(tree.path)
    for option, link in (("--tip", tip), ("--base", base)):
        if link is not None and link not in tree.links:
            message = f"{option} {link}: there is no such link; links are {', '.join(tree.links)}"
            raise InputError(message, file=file)
    chosen = tip or _flange(tree)
    given = list(_up(tree, chosen, base))[::-1]
    moving = [joint for joint in given if joint.kind != FIXED]
    for joint in moving:
        _check(joint, file)
    turning = [joint for joint in moving if joint.kind != SLIDING]
    sliding = [joint for joint in moving if joint.kind == SLIDING]
    kinds = ", ".join(f"{joint.name} ({joint.kind})" for joint in moving) or "no axis"
    seven = len(turning) == 7 and not sliding
    if not seven and (len(turning) != 6 or len(sliding) > 1 or moving[:1] != (sliding or turning)[:1]):
        hint = "" if len(turning) == 6 else "; --tip names another link as the flange, --base another first link"
        message = (
            f"the chain to '{chosen}' is {kinds}: wanted six turning axes, at most one sliding one before them"
            f"{hint}; seven turning ones are an arm for 'trajopt iiwa'"
        )
        raise InputError(message, file=file)
    notes = [note for note in tree.notes if any(f"'{one.name}'" in note for one in given) or "link '" in note]
    endless = [one.name for one in moving if one.kind == "continuous"]
    notes += [f"joint '{name}' is continuous, without a range: -360 to 360 degrees are taken" for name in endless]
    names = [*([RAIL] if sliding else []), *(f"joint_{i}" for i in range(1, 1 + len(turning)))]
    joints, bodies = _normal(tree, given, names, base or tree.root)
    left = [name for name in tree.links if not any(name in body.links for body in bodies)]
    if left:
        notes.append(f"left out, not between '{base or tree.root}' and '{chosen}': {', '.join(left)}")
    named = dict(zip(names, (joint.name for joint in moving), strict=True))
    levers, beside = _levers(tree, turning)
    linkage = float(np.sign(_direction(tree, turning[1]) @ _direction(tree, turning[2]))) if levers else 0.0
    if levers:
        notes += [
            f"{', '.join(levers)}: <mimic> of '{turning[1].name}' or '{turning[2].name}', as of levers in a parallel"
            f" linkage; joint_3 is the controller's axis 3, the upper arm's angle against the base, with range and"
            f" speed of '{turning[2].name}': see coupled in the YAML file",
            "levers are not drawn and touch nothing; no URDF has the range of the angle between the arms: give it under"
            " coupled",
        ]
    notes += beside
    return NormalChain(tree, base or tree.root, chosen, joints, named, bodies, tuple(notes), levers, linkage)


def _levers(tree: Tree, turning: list[TreeJoint]) -> tuple[tuple[str, ...], list[str]]:
    """The joints beside the chain that turn as joint 2 or 3 does (<mimic>), about their direction: the levers of a
    parallel linkage; and what is to be said of others that follow the chain. turning: its six turning joints. Raises
    InputError for a lever that turns faster or slower than the joint: no parallelogram has one."""
    by_name = {joint.name: joint for joint in tree.joints}
    levers, notes = [], []
    for joint in tree.joints:
        followed, factor, left = joint, 1.0, len(by_name)
        while followed.mimic and (left := left - 1) >= 0:
            factor, followed = factor * followed.multiplier, by_name.get(followed.mimic, turning[0])
        if not joint.mimic or joint.kind not in (TURNING, "continuous") or followed not in turning[1:]:
            continue
        alike = abs(float(_direction(tree, joint) @ _direction(tree, turning[1]))) > 1 - _ALIKE
        if followed not in turning[1:3] or not alike:
            notes.append(
                f"joint '{joint.name}' follows '{followed.name}' (<mimic>) and is left out: only axes 2 and 3 can be"
                " coupled, by levers that turn about their direction"
            )
        elif abs(abs(factor) - 1) > _ALIKE:
            message = (
                f"joint '{joint.name}' follows '{followed.name}' {factor:g} times as fast (<mimic>), and the levers"
            )
            message += (
                " of a parallelogram turn as fast: take its <mimic> out, and say in the robot's file under coupled"
            )
            raise InputError(f"{message} whether axes 2 and 3 are", file=str(tree.path))
        else:
            levers.append(joint.name)
    return tuple(levers), notes


def _direction(tree: Tree, joint: TreeJoint) -> Array:
    """A joint's axis (3,) seen from the root with all joints at 0."""
    axis = joint.X[:3, :3] @ joint.axis
    for before in _up(tree, joint.parent, None):
        axis = before.X[:3, :3] @ axis
    return np.asarray(axis)


def _flange(tree: Tree) -> str:
    """The link to take for the flange: tool0, else flange, else the only leaf that six axes lead to, or leaf at all."""
    for name in _FLANGES:
        if name in tree.links:
            return name
    leaves = tree.leaves()
    deep = [name for name in leaves if sum(joint.kind != FIXED for joint in _up(tree, name, None)) >= 6] or leaves
    if len(deep) != 1:
        message = f"has no link '{FLANGE}' or 'flange' and several last ones: name the flange's by --tip, one of"
        raise InputError(f"{message} {', '.join(deep)}", file=str(tree.path))
    return deep[0]


def _up(tree: Tree, link: str, base: str | None) -> Iterator[TreeJoint]:
    """The joints from a link up to the root, or to base. Raises InputError where base is not on the way."""
    start = link
    while link != base and link in tree.by_child:
        yield tree.by_child[link]
        link = tree.by_child[link].parent
    if base is not None and link != base:
        raise InputError(f"--base {base}: link '{start}' does not hang on it", file=str(tree.path))


def _check(joint: TreeJoint, file: str) -> None:
    where = f"joint '{joint.name}'"
    if joint.kind in ("floating", "planar"):
        raise InputError(f"{where} is {joint.kind}: an axis turns or slides; --base names a link behind it", file=file)
    if joint.mimic:
        message = f"{where} follows joint '{joint.mimic}' (<mimic>): an axis of the chain has to move by itself; of a"
        message += (
            " parallel linkage take the <mimic> out, give joint 3 range and speed of axis 3, make fixed what only"
        )
        raise InputError(f"{message} turns back, and say it in the robot's file under coupled", file=file)
    if joint.velocity is None:
        what = '<limit lower="..." upper="..." velocity="..." effort="0"/>'
        wanted = "velocity of <limit>" if joint.lower is not None else what
        raise InputError(f"{where} has no {wanted}: add it, in rad and rad/s (m and m/s)", file=file)
    if not joint.velocity > 0:
        raise InputError(f'{where}: velocity="{joint.velocity:g}", wanted the top speed, above 0', file=file)
    if joint.kind != "continuous" and not (joint.lower or 0.0) < (joint.upper or 0.0):
        message = f'{where}: lower="{joint.lower:g}" upper="{joint.upper:g}", wanted lower below upper'
        raise InputError(message, file=file)
    farthest = max(abs(joint.lower or 0.0), abs(joint.upper or 0.0))
    if joint.kind == "revolute" and farthest > _FARTHEST:
        message = (
            f"{where}: a range to {farthest:g} rad is {farthest / (2 * pi):.0f} turns; a URDF's angles are in radians"
        )
        raise InputError(message, file=file)


def _normal(
    tree: Tree, given: list[TreeJoint], names: list[str], root: str
) -> tuple[tuple[UrdfJoint, ...], tuple[Body, ...]]:
    """Fixed joints become part of the next axis' origin, or of the flange's; only those in front of joint_1 stay, as
    one, where they are not the identity: the arm's base is the link that joint_1 turns on."""
    rail = RAIL in names
    joints: list[UrdfJoint] = []
    bodies: list[Body] = []
    body: list[tuple[str, Array]] = [(root, np.eye(4))]  # the links of the present one, each seen from its frame
    here, X = (CARRIAGE, np.eye(4)) if rail else ("root", np.eye(4))

    def step(name: str, child: str, X: Array, joint: TreeJoint | None = None) -> None:
        bodies.append(_body(tree, here, body))
        if joint is None:
            joints.append(UrdfJoint(name, FIXED, here, child, exact(X), np.zeros(3), 0.0, 0.0, 0.0))
            return
        low, high = (-_WHOLE_TURN, _WHOLE_TURN) if joint.kind == "continuous" else (joint.lower, joint.upper)
        kind = SLIDING if joint.kind == SLIDING else TURNING
        numbers = (low or 0.0, high or 0.0, joint.velocity or 0.0, joint.effort)
        joints.append(UrdfJoint(name, kind, here, child, exact(X), exact(joint.axis), *numbers))

    todo = list(names)
    for joint in given:
        if joint.kind == FIXED:
            X = X @ joint.X
            body.append((joint.child, X))
            continue
        name = todo.pop(0)
        if name == "joint_1":
            before, base = body[:-1], body[-1][0]
            if np.abs(X - np.eye(4)).max() > _DUST and "joint_7" not in names:
                body = before
                step("mount", BASE, X)
                body = [(base, np.eye(4))]
            here, X = BASE, np.eye(4)
        child = f"link_{name[-1]}"
        if name == RAIL:
            child = BASE if _stands_on(given, joint) else "carriage"
        step(name, child, X @ joint.X, joint)
        here, X, body = child, np.eye(4), [(joint.child, np.eye(4))]
    step("flange", FLANGE, X)
    return tuple(joints), (*bodies, Body(FLANGE, (), None, ()))


def _stands_on(given: list[TreeJoint], rail: TreeJoint) -> bool:
    """Whether the arm's base stands where the rail's carriage has its frame."""
    X = np.eye(4)
    for joint in given[given.index(rail) + 1 :]:
        if joint.kind != FIXED:
            break
        X = X @ joint.X
    return bool(np.abs(X - np.eye(4)).max() <= _DUST)


def _body(tree: Tree, name: str, links: list[tuple[str, Array]]) -> Body:
    """Some of the URDF's links as one: inertias added, shapes in one frame."""
    shapes, parts = [], []
    for link, X in links:
        shapes += [CollisionShape(one.kind, X @ one.X, one.sizes, one.file) for one in tree.links[link].shapes]
        if (one := tree.links[link].inertial) is not None:
            R = X[:3, :3]
            parts.append(Inertial(one.mass, R @ one.centre + X[:3, 3], R @ one.inertia @ R.T))
    return Body(name, tuple(link for link, _ in links), _sum(parts), tuple(shapes))


def _sum(parts: list[Inertial]) -> Inertial | None:
    """Of bodies that move as one; by Steiner's rule about their common centre."""
    if len(parts) < 2:
        return parts[0] if parts else None
    mass = sum(part.mass for part in parts)
    centre = sum((part.mass * part.centre for part in parts), np.zeros(3)) / mass if mass > 0 else np.zeros(3)
    inertia = np.zeros((3, 3))
    for part in parts:
        away = part.centre - centre
        inertia += part.inertia + part.mass * (away @ away * np.eye(3) - np.outer(away, away))
    return Inertial(mass, centre, inertia)


def exact(values: Array) -> Array:
    """Without the dust that products of rotations leave at 0 and 1."""
    out = np.where(np.abs(values) < _DUST, 0.0, values)
    return np.where(np.abs(np.abs(out) - 1) < _DUST, np.sign(out), out)


def rpy(R: Array) -> tuple[float, float, float]:
    """Roll, pitch and yaw [rad] of a rotation (3, 3), as URDF has them: Rz(yaw) Ry(pitch) Rx(roll)."""
    sine = float(-R[2, 0])
    if abs(sine) > 1 - 1e-12:  # pitch is a right angle: roll and yaw turn about one line, so all of it is roll
        return float(np.arctan2(-R[1, 2], R[1, 1])), float(np.copysign(pi / 2, sine)), 0.0
    pitch = float(np.arctan2(sine, np.hypot(R[0, 0], R[1, 0])))
    return float(np.arctan2(R[2, 1], R[2, 2])), pitch, float(np.arctan2(R[1, 0], R[0, 0]))
