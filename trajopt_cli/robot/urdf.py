"""A URDF's one chain from its root link to tool0: names, origins, axes and limits. The rest of URDF is not read."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import cos, sin
from xml.etree import ElementTree

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, readonly
from trajopt_cli.units import decimal
from trajopt_cli.urdf_text import robot_element

FLANGE, RAIL = "tool0", "rail"


@dataclass(frozen=True, eq=False)
class UrdfJoint:
    """One joint: X is its frame in the parent link (4, 4), axis (3,) a unit vector; limits in rad or m, and 1/s.

    effort: N or Nm, 0 where a URDF gives none. levers: joints beside the chain that turn as it does (<mimic>).
    """

    name: str
    kind: str
    parent: str
    child: str
    X: Array
    axis: Array
    lower: float
    upper: float
    velocity: float
    effort: float = 0.0
    levers: tuple[str, ...] = ()


def chain_of(text: bytes, file: str) -> list[UrdfJoint]:
    """The joints from the root link to tool0, root first. Raises InputError for a URDF's text that has no such chain;
    file is for messages."""
    by_child, follow = {}, dict[str, list[UrdfJoint]]()
    for element in robot_element(text, file).findall("joint"):
        joint = _joint(element, file)
        by_child[joint.child] = joint
        if joint.kind == "revolute" and (mimic := element.find("mimic")) is not None:
            follow.setdefault(mimic.get("joint", ""), []).append(joint)
    chain: list[UrdfJoint] = []
    link = FLANGE
    while link in by_child:
        chain.append(by_child.pop(link))
        link = chain[-1].parent
    if not chain:
        message = f"no joint leads to link '{FLANGE}': name the flange frame so, or see 'trajopt robot add'"
        raise InputError(message, file=file)
    for joint in chain:
        if any(joint in joints for joints in follow.values()):
            message = f"joint '{joint.name}' follows another (<mimic>): an axis of the chain has to move by itself"
            raise InputError(f"{message}; of a parallel linkage say in the robot's file under coupled", file=file)
    return [replace(joint, levers=tuple(one.name for one in follow.get(joint.name, []))) for joint in chain[::-1]]


def split_chain(chain: list[UrdfJoint], file: str) -> tuple[list[UrdfJoint], list[UrdfJoint]]:
    """What stands before the arm (fixed joints, at most one rail), and the arm: six revolute joints and the flange.

    Raises InputError for any other chain, and for an axis without a range or a speed.
    """
    axes = [joint for joint in chain if joint.kind != "fixed"]
    kinds = [joint.kind for joint in axes]
    mount, arm = chain[:-7], chain[-7:]
    if [joint.kind for joint in arm] != ["revolute"] * 6 + ["fixed"] or kinds[:-6] not in ([], ["prismatic"]):
        raise InputError(
            f"the chain to {FLANGE} is {', '.join(joint.kind for joint in chain)}: wanted six revolute joints in a row,"
            " a fixed one behind them, at most one prismatic before them; 'trajopt robot add' makes such a file",
            file=file,
        )
    if len(axes) > 6 and axes[0].name != RAIL:
        raise InputError(f"joint '{axes[0].name}' is the sliding axis: call it '{RAIL}', as cell files do", file=file)
    check_ranges(axes, file)
    return mount, arm


def check_ranges(axes: list[UrdfJoint], file: str) -> None:
    """Raise InputError for an axis without a range or a speed."""
    for joint in axes:
        if not (joint.lower < joint.upper and joint.velocity > 0):
            raise InputError(
                f"joint '{joint.name}': wanted lower < upper and velocity > 0, got lower {joint.lower:g},"
                f" upper {joint.upper:g}, velocity {joint.velocity:g}",
                file=file,
            )


def _joint(element: ElementTree.Element, file: str) -> UrdfJoint:
    name, kind = element.get("name", ""), element.get("type", "")
    if kind not in ("revolute", "prismatic", "fixed"):
        message = (
            f"joint '{name}' has type '{kind}': wanted revolute, prismatic or fixed; 'trajopt robot add' reads others"
        )
        raise InputError(message, file=file)

    def part(tag: str) -> ElementTree.Element:
        found = element.find(tag)
        if found is None:
            raise InputError(f"joint '{name}' has no <{tag}>", file=file)
        return found

    def numbers(tag: str, key: str, count: int) -> list[float]:
        text = part(tag).get(key)
        if text is None:
            raise InputError(f"joint '{name}': <{tag}> has no {key}", file=file)
        try:
            values = [decimal(word) for word in text.split()]
        except ValueError as error:
            raise InputError(f"joint '{name}': <{tag}> {key}=\"{text}\" is not {count} number(s)", file=file) from error
        if len(values) != count or not np.all(np.isfinite(values)):
            raise InputError(f"joint '{name}': <{tag}> {key}=\"{text}\" is not {count} finite number(s)", file=file)
        return values

    X = np.eye(4)
    X[:3, :3] = rotation_rpy(*numbers("origin", "rpy", 3))
    X[:3, 3] = numbers("origin", "xyz", 3)
    axis, lower, upper, velocity, effort = np.zeros(3), 0.0, 0.0, 0.0, 0.0
    if kind != "fixed":
        axis = np.array(numbers("axis", "xyz", 3))
        if abs(np.linalg.norm(axis) - 1) > 1e-9:
            raise InputError(f"joint '{name}' has an axis of length {np.linalg.norm(axis):.6g}, wanted 1", file=file)
        keys = ("lower", "upper", "velocity", "effort")
        (lower,), (upper,), (velocity,), (effort,) = (numbers("limit", key, 1) for key in keys)
    parent, child = part("parent").get("link", ""), part("child").get("link", "")
    return UrdfJoint(name, kind, parent, child, readonly(X), readonly(axis), lower, upper, velocity, effort)


def rotation_rpy(roll: float, pitch: float, yaw: float) -> Array:
    """Rz(yaw) Ry(pitch) Rx(roll), with cos(pi/2) and its like exactly zero."""
    (cr, sr), (cp, sp), (cy, sy) = ((cos(t), sin(t)) for t in (roll, pitch, yaw))
    R = np.array(
        [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
            [-sp, cp * sr, cp * cr],
        ]
    )
    return np.where(np.abs(R) < 1e-15, 0.0, R)
