"""From a robot's YAML and URDF files to the parts of its model that every structure has."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import hypot
from pathlib import Path, PurePath
from typing import Any

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, readonly
from trajopt_cli.limits import AccelerationTable, CoupledRange, JointLimits
from trajopt_cli.robot import catalogue
from trajopt_cli.robot.acceleration_table import read_acceleration_table
from trajopt_cli.robot.arm_chain import arm_from_chain
from trajopt_cli.robot.catalogue import LinkPart, PostureTable, Profile, Rate, RobotFile, SixAxisFile, SrsFile
from trajopt_cli.robot.structure import Structure
from trajopt_cli.robot.urdf import UrdfJoint, chain_of
from trajopt_cli.scenario import Settling
from trajopt_cli.shapes import Capsule, LinkShape, polytope
from trajopt_cli.urdf_text import read_bytes
from trajopt_cli.yaml_file import remembered

Raw = Mapping[str, Any]


@dataclass(frozen=True)
class Shipped:
    """A robot that ships. reach [m]: of the wrist centre, from axis 1 or an iiwa's shoulder; payload [kg] None where no
    source tells."""

    name: str
    title: str
    reach: float
    payload: float | None


def shipped() -> list[Shipped]:
    """The robots that ship, by name."""
    out = []
    for name in catalogue.robot_names():
        path = catalogue.find_robot(name)
        head = catalogue.read_head(path)
        chain = _chain(path.parent / head.urdf)
        payload = None if head.payload is None else head.payload.value
        reach = _srs_reach(chain) if head.structure is Structure.SRS else _six_axis_reach(chain)
        out.append(Shipped(name, head.title, reach, payload))
    return out


def _six_axis_reach(chain: list[UrdfJoint]) -> float:
    arm = arm_from_chain(chain[-7:], "")
    beyond = hypot(*arm.wrist) if arm.closed_form else 0.0  # of three parallel axes: from axis 4 to the wrist centre
    return hypot(arm.b, abs(arm.a1) + arm.c2 + arm.upper + beyond)


def _srs_reach(chain: list[UrdfJoint]) -> float:
    """Upper arm and forearm: of the origins between shoulder and wrist, as far as they lie along the arm."""
    return float(sum(joint.X[2, 3] for joint in chain[2:6]))


def read_six_axis(name_or_path: str) -> tuple[SixAxisFile, Path, Raw]:
    """The file of a six-axis arm: validated, its path, the raw YAML. Raises InputError for another structure."""
    data, path, raw = read(name_or_path, Structure.SIX_AXIS)
    if not isinstance(data, SixAxisFile):
        raise InputError(f"{data.name} is a seven-axis arm, for 'trajopt iiwa'; programs run on arms of six axes")
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
    urdf = beside(data.urdf, ("urdf",), path, raw)
    return urdf, _chain(urdf)


def _chain(urdf: Path) -> list[UrdfJoint]:
    return [*_joints(read_bytes(urdf), str(urdf))]


@remembered(32)
def _joints(text: bytes, file: str) -> tuple[UrdfJoint, ...]:
    return tuple(chain_of(text, file))


def beside(given: str, key: tuple[str, ...], path: Path, raw: Raw) -> Path:
    """A file that a robot's file names: in its folder or below, which results can keep. Raises InputError."""
    said, line = f"{'.'.join(key)}: '{given}'", catalogue.line_of(raw, key)
    if PurePath(given).is_absolute() or ".." in PurePath(given).parts:
        message = f"{said} has to be in this file's folder or below it, which results can keep"
        raise InputError(message, file=str(path), line=line)
    if not (found := path.parent / given).is_file():
        raise InputError(f"{said} does not exist beside this file", file=str(path), line=line)
    return found


def acceleration_tables(data: RobotFile, path: Path, raw: Raw, axes: list[UrdfJoint]) -> dict[str, AccelerationTable]:
    """Accelerations by posture, by the profile's name. Raises InputError."""
    rails = {joint.name: joint.kind == "prismatic" for joint in axes}
    return {
        name: read_acceleration_table(beside(table.file, ("profiles", name, "by_posture", "file"), path, raw), rails)
        for name, table in _tables(data).items()
    }


def _tables(data: RobotFile) -> dict[str, PostureTable]:
    found = {name: getattr(profile, "by_posture", None) for name, profile in data.profiles.items()}
    return {name: table for name, table in found.items() if table is not None}


def check(
    data: RobotFile, path: Path, raw: Raw, axes: list[UrdfJoint], arm: list[UrdfJoint],
    tables: Mapping[str, AccelerationTable],
) -> None:  # fmt: skip
    """Hold the names in the file against the URDF's axes and the arm's links. Raises InputError with the line."""
    own = {name: frozenset(table.axes) for name, table in tables.items()}
    catalogue.check_axes(data, raw, tuple(joint.name for joint in axes), str(path), own)
    if isinstance(data, SixAxisFile):
        ranges = {joint.name: (joint.lower, joint.upper) for joint in axes if joint.kind == "revolute"}
        alike = float(np.sign(arm[1].axis @ arm[2].X[:3, :3] @ arm[2].axis))
        catalogue.check_coupled(data.coupled, raw, ranges, alike, str(path))
        levers = ", ".join(arm[1].levers + arm[2].levers)
        if levers and not linkage(data):
            message = (
                f"urdf: {levers} of {data.urdf} follow joint 2 or 3 (<mimic>), as levers of a parallel linkage do: say"
            )
            message += f" under coupled that axis {arm[2].name} is axes [{arm[1].name}, {arm[2].name}] with factors"
            message += f" [{alike:g}, 1], or take their <mimic> out"
            raise InputError(message, file=str(path), line=catalogue.line_of(raw, ("urdf",)))
    if data.collision is not None:
        links = (arm[0].parent, *(joint.child for joint in arm[:-1]))
        catalogue.check_links(data.collision, raw, links, str(path))


def linkage(data: SixAxisFile) -> float:
    """1 or -1 where a parallel linkage makes axis 3 of joints 2 and 3: joint_3 = axis 3 - linkage * axis 2; else 0."""
    sums = (dict(zip(one.axes, one.factors, strict=True)) | {one.axis: 0.0} for one in data.coupled if one.axis)
    return sum(next(sums, {"": 0.0}).values())


def profiles(
    data: RobotFile, axes: list[UrdfJoint], tables: Mapping[str, AccelerationTable] | None = None
) -> dict[str, JointLimits]:
    """Limits of the axes by profile name, each number with its source. tables: see acceleration_tables."""
    tables = tables or {}
    names = tuple(joint.name for joint in axes)
    given = isinstance(data, SixAxisFile)  # of a seven-axis arm they are no limits of profiles
    kinds = ("position", "velocity", *(["torque"] if given else []))
    origins = {f"{n}.{k}": str(said) for n, o in data.axes.items() for k in kinds if (said := getattr(o, k))}
    known = [given and joint.effort > 0 and data.axes[joint.name].torque is not None for joint in axes]
    torque = np.array([joint.effort if says else np.inf for joint, says in zip(axes, known, strict=True)])
    sums = data.coupled if isinstance(data, SixAxisFile) else ()
    coupled = tuple(CoupledRange(one.axes, one.factors, *one.range, str(one)) for one in sums if one.range)
    return {
        name: JointLimits(
            names,
            np.array([joint.lower for joint in axes]),
            np.array([joint.upper for joint in axes]),
            np.array([joint.velocity for joint in axes]),
            np.array([one.value if isinstance(one, Rate) else tables[name].range[n][0] for n, one in of.items()]),
            origins
            | {f"{n}.acceleration": str(origin) for n, origin in of.items()}
            | {f"{n}.jerk": str(number) for n, number in (profile.jerk or {}).items()},
            np.array([profile.jerk[n].value for n in names]) if profile.jerk else None,
            grades={f"{n}.acceleration": origin.grade for n, origin in of.items()}
            | {f"{n}.velocity": data.axes[n].velocity.grade for n in names},
            spread={f"{n}.acceleration": origin.spread("acceleration") for n, origin in of.items()}
            | {f"{n}.velocity": data.axes[n].velocity.spread("velocity") for n in names}
            | {f"{n}.torque": said.spread("acceleration") for n in names if given and (said := data.axes[n].torque)},
            torque=torque if any(known) else None,
            coupled=coupled,
            table=tables.get(name),
        )
        for name, profile in data.profiles.items()
        for of in [_acceleration_origins(profile, _tables(data).get(name), names)]
    }


def _acceleration_origins(
    profile: Profile, table: PostureTable | None, names: tuple[str, ...]
) -> dict[str, Rate | PostureTable]:
    """Where the acceleration of each axis comes from."""
    found = {name: profile.acceleration.get(name, table) for name in names}
    return {name: one for name, one in found.items() if one is not None}  # all: see catalogue.check_axes


def settling(data: SixAxisFile) -> Settling | None:
    """How long the axes settle at stops; None where nobody says."""
    if data.settle is None:
        return None
    fine, inpos = data.settle.fine, data.settle.inpos or data.settle.fine
    return Settling(fine.value, inpos.value, "; ".join(dict.fromkeys(map(str, (fine, inpos)))), fine.spread("settling"))


def rotors(data: RobotFile, axes: list[UrdfJoint]) -> Array:
    """Inertias of the drives as the axes feel them (n,) [kg m2, kg]; 0 where nobody says."""
    said = [data.axes[joint.name].rotor_inertia for joint in axes]
    return readonly([0.0 if one is None else one.value for one in said])


def notes(data: RobotFile) -> dict[str, str]:
    """Sources of what is not a limit, and what the profiles are about."""
    collision = {"collision": str(data.collision)} if data.collision else {}
    about = {f"profiles.{name}": profile.about for name, profile in data.profiles.items()}
    about |= {f"profiles.{name}.load": table.load for name, table in _tables(data).items()}
    sums = data.coupled if isinstance(data, SixAxisFile) else ()
    linked = {f"{one.axis}.linkage": str(one) for one in sums if one.axis}
    return {"geometry": str(data.geometry)} | collision | about | linked


def bodies(data: RobotFile, path: Path, raw: Raw) -> dict[str, tuple[LinkShape, ...]]:
    """Bodies by link name, in the links' frames. Raises InputError for a polytope that is empty."""
    links = data.collision.links if data.collision else {}
    out = {}
    for name, link in links.items():
        try:
            out[name] = tuple(_body(name, part) for part in link.parts or (link,))
        except ValueError as error:
            keys = ("collision", "links", name)
            message = f"'{'.'.join(keys)}': {error}; measure it again, or give a capsule (a, b, radius)"
            raise InputError(message, file=str(path), line=catalogue.line_of(raw, keys)) from error
    return out


def capsules(data: RobotFile, path: Path, raw: Raw) -> dict[str, Capsule]:
    """One around each link that has some, as simulated worlds take them. Raises InputError for other bodies."""
    out = {}
    for name, shapes in bodies(data, path, raw).items():
        if len(shapes) > 1 or not isinstance(shapes[0], Capsule):
            keys = ("collision", "links", name)
            message = f"'{'.'.join(keys)}': a seven-axis arm takes one capsule (a, b, radius) around a link"
            raise InputError(message, file=str(path), line=catalogue.line_of(raw, keys))
        out[name] = shapes[0]
    return out


def _body(name: str, part: LinkPart) -> LinkShape:
    if part.polytope is not None:
        return polytope(name, part.polytope)
    assert part.a is not None
    assert part.b is not None
    assert part.radius is not None
    return Capsule(name, readonly(part.a), readonly(part.b), part.radius)
