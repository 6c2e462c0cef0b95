"""From a robot's YAML and URDF files to the parts of its model that every structure has."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import readonly
from trajopt_cli.limits import JointLimits
from trajopt_cli.robot import catalogue
from trajopt_cli.robot.catalogue import RobotFile, SixAxisFile, SrsFile
from trajopt_cli.robot.structure import Structure
from trajopt_cli.robot.urdf import UrdfJoint, read_chain
from trajopt_cli.shapes import Capsule

Raw = Mapping[str, Any]


def read_six_axis(name_or_path: str) -> tuple[SixAxisFile, Path, Raw]:
    """The file of a six-axis arm: validated, its path, the raw YAML. Raises InputError for another structure."""
    data, path, raw = read(name_or_path, Structure.SIX_AXIS)
    if not isinstance(data, SixAxisFile):
        known = ", ".join(catalogue.robot_names(Structure.SIX_AXIS))
        raise InputError(f"{data.name} is a seven-axis arm, for 'trajopt iiwa'; programs run on {known}")
    return data, path, raw


def read_srs(name_or_path: str) -> tuple[SrsFile, Path, Raw]:
    """The file of a seven-axis arm: validated, its path, the raw YAML. Raises InputError for another structure."""
    data, path, raw = read(name_or_path, Structure.SRS)
    if not isinstance(data, SrsFile):
        known = ", ".join(catalogue.robot_names(Structure.SRS))
        raise InputError(f"{data.name} is a six-axis arm, for programs; 'trajopt iiwa' is for {known}")
    return data, path, raw


def read(name_or_path: str, structure: Structure | None = None) -> tuple[RobotFile, Path, Raw]:
    """A shipped robot's file by its name, or any by its path: validated, its path, the raw YAML. Raises InputError.

    structure: the robots to list where the name is unknown, all for None.
    """
    path = catalogue.find_robot(name_or_path, structure)
    data, raw = catalogue.read_robot_file(path)
    return data, path, raw


def urdf_chain(data: RobotFile, path: Path, raw: Raw) -> tuple[Path, list[UrdfJoint]]:
    """The URDF beside the file, and its joints from the root to the flange. Raises InputError where there is none."""
    urdf = path.parent / data.urdf
    if not urdf.is_file():
        line = catalogue.line_of(raw, ("urdf",))
        raise InputError(f"urdf: '{data.urdf}' does not exist beside this file", file=str(path), line=line)
    return urdf, read_chain(urdf)


def check(data: RobotFile, path: Path, raw: Raw, axes: list[UrdfJoint], arm: list[UrdfJoint]) -> None:
    """Hold the names in the file against the URDF's axes and the arm's links. Raises InputError with the line."""
    catalogue.check_axes(data, raw, tuple(joint.name for joint in axes), str(path))
    if data.collision is not None:
        links = (arm[0].parent, *(joint.child for joint in arm[:-1]))
        catalogue.check_links(data.collision, raw, links, str(path))


def profiles(data: RobotFile, axes: list[UrdfJoint]) -> dict[str, JointLimits]:
    """Limits of the axes by profile name, each number with its source."""
    names = tuple(joint.name for joint in axes)
    origins = {f"{n}.{k}": str(getattr(o, k)) for n, o in data.axes.items() for k in ("position", "velocity")}
    return {
        name: JointLimits(
            names,
            np.array([joint.lower for joint in axes]),
            np.array([joint.upper for joint in axes]),
            np.array([joint.velocity for joint in axes]),
            np.array([profile.acceleration[n].value for n in names]),
            origins
            | {f"{n}.acceleration": str(profile.acceleration[n]) for n in names}
            | {f"{n}.jerk": str(number) for n, number in (profile.jerk or {}).items()},
            np.array([profile.jerk[n].value for n in names]) if profile.jerk else None,
            grades={f"{n}.acceleration": profile.acceleration[n].grade for n in names},
        )
        for name, profile in data.profiles.items()
    }


def notes(data: RobotFile) -> dict[str, str]:
    """Sources of what is not a limit, and what the profiles are about."""
    collision = {"collision": str(data.collision)} if data.collision else {}
    about = {f"profiles.{name}": profile.about for name, profile in data.profiles.items()}
    return {"geometry": str(data.geometry)} | collision | about


def capsules(data: RobotFile) -> dict[str, Capsule]:
    """Capsules by link name, in the links' frames."""
    links = data.collision.links if data.collision else {}
    return {name: Capsule(name, readonly(c.a), readonly(c.b), c.radius) for name, c in links.items()}
