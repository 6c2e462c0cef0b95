"""Reads a task file: YAML with a place for every key, checked against the document's shape, turned into a Task."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from math import nan
from pathlib import Path
from typing import Any

import numpy as np

from trajopt_cli.cell.document import CapsuleSection, FrameSection
from trajopt_cli.cell.scene_files import frame_pose
from trajopt_cli.cell.suspected import TASK, suspected
from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task import model
from trajopt_cli.iiwa.task.approach import by_joints, by_line
from trajopt_cli.iiwa.task.document import (
    ClampSection,
    ContactDocument,
    ContactSection,
    LoadSection,
    PassingSection,
    TaskDocument,
    ZeroSection,
)
from trajopt_cli.iiwa.task.joint_checks import Arm
from trajopt_cli.iiwa.task.path_csv import guided_path, read_forces, read_path
from trajopt_cli.iiwa.task.path_csv import read_text as read_csv_text
from trajopt_cli.iiwa.task.poses import force_of, program_route, written_waypoints
from trajopt_cli.iiwa.task.ros2_admittance import read_admittance
from trajopt_cli.limits import JointLimits
from trajopt_cli.robot.dynamics import ToolLoad
from trajopt_cli.robot.srs import SrsRobot, load_srs
from trajopt_cli.robot.srs_inverse import ArmAngle, singularities
from trajopt_cli.shapes import Box, Capsule
from trajopt_cli.units import MM
from trajopt_cli.yaml_file import line_of, parse, read_text, refuse_empty, validated

_COMPONENTS = ("fx", "fy", "fz", "mx", "my", "mz")
_FARTHEST, _LONGEST_TOOL, _THICKEST_TIP, _THINNEST = 1e3, 10.0, 1.0, 1e-6  # m
_SINGULAR = 1e-6  # rad, m: a start this near has no configuration of its own
_NEEDED = "start, poses, v_max, omega_max, K, D and M are needed at least"
_WANTED = {
    "start": "say where the controller is switched on: 'start: {joints: \"[0, 30, 0, -100, 0, 50, 0] deg\"}'",
    "start.joints": "give the seven joints, '\"[0, 30, 0, -100, 0, 50, 0] deg\"'",
    "K": "give the stiffness of x, y, z [N/m] and alpha, beta, gamma [Nm/rad], 'K: [1000, 1000, 1000, 30, 30, 30]'",
    "D": "give the damping of x, y, z [N s/m] and alpha, beta, gamma, 'D: [500, 500, 500, 20, 20, 20]'",
    "M": "give the inertia of x, y, z [kg] and alpha, beta, gamma [kg m2], 'M: [25, 25, 25, 3, 3, 3]'",
    "contact": "say what the tool may run into: 'contact: {tip: 0.02, obstacles: {wall: {box: ..., stiffness: 2e4}}}'",
    "stiffness": "say how stiff the obstacle is, in N/m",
    "tip": "give the radius of the ball at the tool's end, in m",
}


@dataclass(frozen=True)
class _Lines:
    """Where the keys of a file stand."""

    file: str
    lines: Mapping[str, int]

    def wrong(self, key: str, message: str, said: str = "") -> InputError:
        """The error about a key. said: what messages call it, if otherwise."""
        return InputError(f"{said or key}: {message}", file=self.file, line=line_of(key, self.lines))

    @contextmanager
    def about(self, key: str, prefix: str = "") -> Iterator[None]:
        """What is refused inside is the fault of this key."""
        try:
            yield
        except (ValueError, InputError) as error:
            raise InputError(f"{prefix}{error}", file=self.file, line=line_of(key, self.lines)) from error

    def beside(self, key: str, name: str, said: str = "") -> Path:
        """The file of this name in the task file's folder or below it. said: what messages call the key."""
        folder = Path(self.file).parent
        found = folder / name
        if not found.is_file() or not found.resolve().is_relative_to(folder.resolve()):
            message = f"there is no file {found}; it must be in the task file's folder or below it"
            raise self.wrong(key, message, said)
        return found

    def frame(self, section: FrameSection, key: str, most: float = _FARTHEST) -> Array:
        """A frame (4, 4) that a cell can have. Raises InputError for one farther away than most [m]."""
        X = frame_pose(section)
        if np.abs(X[:3, 3]).max() > most:
            message = f"{np.abs(X[:3, 3]).max():g} m is farther than {most:g} m; check the unit"
            raise self.wrong(f"{key}.position", message)
        return X


def minimal_task(program: str) -> str:
    """The shortest useful task file for a RAPID program or a path as CSV, as text to save and adapt."""
    caps = (
        "v_max: 0.1 m/s",
        "omega_max: 30 deg/s",
        "a_max: 1 m/s2",
        "epsilon_max: 3 rad/s2",
        "jerk: 20 m/s3",
        "angular_jerk: 60 rad/s3",
    )
    lines = (
        f"# the compliant controller that {program} is for: SI units, or a text with a unit",
        'start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}  # where it is switched on',
        "K: [1000, 1000, 1000, 30, 30, 30]  # stiffness of x, y, z [N/m] and of the angles [Nm/rad]",
        "D: [500, 500, 500, 20, 20, 20]  # damping [N s/m, N m s/rad]",
        "M: [25, 25, 25, 3, 3, 3]  # inertia [kg, kg m2]",
        *(caps if program.lower().endswith(".csv") else ()),
    )
    return "\n".join(lines) + "\n"


@of_kind(ErrorKind.PROGRAM)
def load_task(path: str | Path, poses_from: str | Path | None = None) -> model.Task:
    """Read the task file at path (UTF-8 YAML), and the RAPID program it names.

    poses_from: a RAPID file to take the poses from instead of the ones the task file gives. Raises InputError, one line
    per finding, each with file, line and key.
    """
    file = str(path)
    return parse_task(read_text(path, "task file"), file, poses_from)


@of_kind(ErrorKind.PROGRAM)
def parse_task(text: str, file: str, poses_from: str | Path | None = None) -> model.Task:
    """The Task in a task file's text; file is its name in messages, programs are looked up beside it."""
    content, lines = parse(text, file, _NEEDED)
    refuse_empty(content, lines, file)
    # a path as CSV stands in the place of poses as a program does
    given = "poses" if str(content.get("poses")).lower().endswith(".csv") else "program"
    if poses_from is not None:
        content = {key: value for key, value in content.items() if key not in ("poses", "program")}
        content["program"] = str(Path(poses_from).name)
    elif given == "poses":
        if "program" in content:
            raise _Lines(file, lines).wrong("poses", "give one of 'poses' and 'program'")
        content = {("program" if key == "poses" else key): value for key, value in content.items()}
        lines = {**lines, "program": line_of("poses", lines)}
    log = content.get("pushes")
    if isinstance(log, str):
        content = {key: value for key, value in content.items() if key != "pushes"}
    content, lines, texts, told = _controller(content, lines, file)
    document = validated(TaskDocument, content, lines, file, _WANTED)
    doubts = map(str, suspected(content, TASK, lines, file))
    at = _Lines(file, lines)
    X_WB, X_FT = at.frame(document.base, "base"), at.frame(document.tool, "tool", _LONGEST_TOOL)
    with at.about("robot", "robot: "):
        robot = load_srs(document.robot, X_WB)
    with at.about("limits", "limits: "):
        limits = robot.profile(document.limits)
    start = np.array(document.start.joints)
    _check_start(robot, start, limits, at)
    X_WF = robot.forward(start)
    meaning, texts = model.AngleMeaning(document.angles), {file: text, **texts}
    pushes: tuple[model.Push | model.PushLog, ...] = tuple(
        model.Push(push.start, push.end, np.array(push.force)) for push in document.pushes
    )
    if isinstance(log, str):
        recorded = str(at.beside("pushes", log.strip()))
        texts[recorded] = read_csv_text(recorded)
        pushes = (read_forces(texts[recorded], recorded),)
    waypoints: Sequence[model.Waypoint]
    notes, given_speeds, force = tuple[str, ...](), None, document.force
    from_csv = document.program is not None and document.program.lower().endswith(".csv")
    passing = _passing(document, from_csv)
    if document.program is not None:
        program = Path(poses_from) if poses_from is not None else at.beside("program", document.program, given)
    if from_csv:
        texts[str(program)] = read_csv_text(str(program))
        path_of = texts[str(program)], str(program), meaning, X_WF[:3, :3] @ X_FT[:3, :3]
        near = passing or model.Passing(PassingSection().tolerance, PassingSection().turn_tolerance)
        guided = guided_path(*path_of, near)
        waypoints = guided or read_path(*path_of)
        if guided:
            notes = (
                f"{program.name}: the run's poses are thinned to {len(guided)}, within {near.tolerance / MM:.3g} mm and"
                f" {np.degrees(near.turn_tolerance):.3g}°",
            )
    elif document.program is not None:
        placed = document.tool.model_fields_set & {"position", "wxyz", "rpy"}
        tolerance = passing.tolerance if passing else None
        found = program_route(program, meaning, X_WF[:3, :3], X_FT if placed else None, tolerance)
        waypoints, X_FT, texts[str(program)], notes = found.waypoints, found.X_FT, found.text, found.notes
        given_speeds = found.speeds
        if (reach := np.abs(X_FT[:3, 3]).max()) > _LONGEST_TOOL:
            message = f"the moves' tool reaches {reach:g} m from the flange, at most {_LONGEST_TOOL:g} m"
            raise InputError(message, file=str(program))
        if not placed and document.tool.load is None:
            notes += ("the tool is the program's; its load is not taken over, give it as tool.load where it matters",)
    else:
        assert document.poses is not None
        waypoints = written_waypoints(document.poses, force, meaning, X_WF @ X_FT, lines, file)
    caps = _caps(document, waypoints, at, given_speeds)
    said = (force, *(one.force for one in document.poses or ()))
    if force is not None and all(one is None or one.value is None for one in said):
        raise at.wrong("force", "nobody says how hard; give 'value: 20 N' here, or a pose a 'force'")
    if force is not None and document.poses is None:
        pressed = force_of(None, force, f"{file}:{line_of('force', lines)}")
        if isinstance(waypoints, model.PathPoints):
            dwells = {0: force.settle} if force.settle else {}
            waypoints = replace(waypoints, force=pressed, dwells=dwells | dict(waypoints.dwells))
        else:
            waypoints = tuple(replace(one, force=pressed) for one in waypoints)
    elif force is not None and force.settle:
        raise at.wrong("force.settle", "is a path's in a file; give the first pressed pose a 'dwell'")
    definition = ArmAngle(document.arm_angle.definition if document.arm_angle else "faria")
    angle = document.arm_angle.value if document.arm_angle else None
    profile = model.Profile(document.profile or ("thesis" if passing is None else "s-curve"))
    law = model.RotationLaw(document.rotation)
    route, came = model.Route(waypoints, caps, document.h, profile, law, meaning, passing), tuple[str, ...]()
    if document.approach == "line":
        route, came = by_line(route, X_WF @ X_FT, f"{file}:{line_of('start.joints', lines)}")
    elif document.approach == "joint":
        route, start, came = by_joints(route, Arm(robot, X_FT, start, limits, definition, angle))
        _check_start(robot, start, limits, at, "approach")
    if document.poses and document.poses[0].force and route.waypoints[0].force:
        raise at.wrong("poses.0.force", "would begin with a jump; begin in the air, without a force")
    return model.Task(
        file=file,
        robot=document.robot,
        limits=document.limits,
        route=route,
        compliance=_compliance(document.K, document.D, document.M, "K", at),
        start_joints=start,
        X_WB=X_WB,
        X_FT=X_FT,
        load=_load(document.tool.load, at),
        definition=definition,
        arm_angle=angle,
        integration=model.Integration(document.integration),
        zeroing=_zeroing(document.zero),
        clamps=_clamps(document.clamps, "clamps", at),
        changes=_changes(document, at, route),
        pushes=pushes,
        sensor=None
        if (one := document.sensor) is None
        else model.Sensor(
            one.bias, tuple((wave.frequency, wave.amplitude) for wave in one.ripple), one.rigid, one.seed
        ),
        contact=None if document.contact is None else _contact(document.contact, at),
        tool=None
        if document.tool.capsule is None
        else _capsule(document.tool.capsule, "tool", "tool.capsule", _LONGEST_TOOL, at),
        by_joints=document.timing == "joints",
        impedance=None
        if document.controller == "admittance"
        else model.Impedance(
            None if (ratios := document.impedance.damping_ratio) is None else np.array(ratios),
            document.impedance.null_stiffness,
            document.impedance.null_damping,
        ),
        wrench=force is not None and force.by == "wrench",
        lead=force is not None and force.lead,
        follows=bool(told),
        notes=(*doubts, *told, *notes, *came),
        sources=texts,
    )


@of_kind(ErrorKind.PROGRAM)
def load_contact(path: str | Path) -> tuple[model.Contact, str]:
    """The contact section of a task file, or of a file that holds nothing else, and the file's text.

    Raises InputError as load_task does.
    """
    file, text = str(path), read_text(path, "contact file")
    content, lines = parse(text, file, "a contact section is needed")
    if "contact" in content:
        refuse_empty({"contact": content["contact"]}, lines, file)
    return _contact(validated(ContactDocument, content, lines, file, _WANTED).contact, _Lines(file, lines)), text


_PARAMETERS = re.compile(r"(?P<file>.+\.ya?ml)(?::(?P<name>\w+))?")
_ADMITTANCE = ("zero", "clamps", "changes", "sensor")  # what the impedance controller does not have


def _controller(
    content: dict[str, Any], lines: dict[str, int], file: str
) -> tuple[dict[str, Any], dict[str, int], dict[str, str], tuple[str, ...]]:
    """The file's content with the K, D and M that its controller has itself; texts of its files, notes."""
    named = str(content.get("controller", "admittance"))
    if match := _PARAMETERS.fullmatch(named):
        at = _Lines(file, lines)
        for key in ("K", "D", "M", "zero", "integration"):
            if key in content:
                raise at.wrong(key, "is the controller file's; take it out")
        place = at.beside("controller", match["file"])
        text = read_text(place, "controller file")
        own, note = read_admittance(text, str(place), match["name"])
        rest = {key: value for key, value in content.items() if key != "controller"}
        lines = {**dict.fromkeys(own, line_of("controller", lines)), **lines}
        return {**own, **rest}, lines, {str(place): text}, (note,)
    if content.get("controller", "admittance") != "impedance":
        if "impedance" in content:
            raise _Lines(file, lines).wrong("impedance", "goes with 'controller: impedance'")
        return content, lines, {}, ()
    if given := [key for key in _ADMITTANCE if key in content]:
        message = "the impedance controller measures no force and stays as it is; take it out"
        raise _Lines(file, lines).wrong(given[0], message)
    section = content.get("impedance")
    by_ratio = isinstance(section, Mapping) and section.get("damping_ratio") is not None
    if by_ratio == ("D" in content):
        message = "give one of 'D' and 'impedance: {damping_ratio: 0.7}'"
        raise _Lines(file, lines).wrong("D" if by_ratio else "controller", message)
    return {"M": [1.0] * 6, "D": [1.0] * 6, **content}, lines, {}, ()


def _passing(document: TaskDocument, from_csv: bool) -> model.Passing | None:
    """How poses are passed; those of a CSV file are unless the file says otherwise."""
    section = document.passing
    if section is None and from_csv and "passing" not in document.model_fields_set:
        section = PassingSection()
    return None if section is None else model.Passing(section.tolerance, section.turn_tolerance)


def _check_start(robot: SrsRobot, start: Array, limits: JointLimits, at: _Lines, key: str = "start.joints") -> None:
    """Refuse a start outside a joint's range, and one from which the arm's configuration cannot be told."""
    for name, value, low, high in zip(limits.names, start, limits.lower, limits.upper, strict=True):
        if not low <= value <= high:
            told = f"{name} = {np.degrees(value):.6g}°, outside its range {np.degrees(low):g}°..{np.degrees(high):g}°"
            raise at.wrong(key, told)
    for singular in singularities(robot, start[None], _SINGULAR):
        undefined = "arm angle and configuration are not defined there; start a degree away from it"
        raise at.wrong(key, f"singular, {singular.name}: {undefined}")


def _caps(
    document: TaskDocument,
    waypoints: Sequence[model.Waypoint],
    at: _Lines,
    given: tuple[tuple[float, float], ...] | None,
) -> Array:
    """Caps (n, 6) of the segments; given: v_max and omega_max of a program, which the file's own replace."""
    count, columns = len(waypoints) - 1, list[Array]()
    for k, key in enumerate(model.CAPS):
        value = getattr(document, key)
        if isinstance(value, tuple) and len(value) != count:
            raise at.wrong(key, f"{len(value)} values for {count} segments; give one for all, or one each")
        if value is None and k < 2:
            if given is None:
                message = f"{key}: is missing; give a cap for all segments, or one each"
                raise InputError(message, file=at.file, line=1)
            value = tuple(pair[k] for pair in given)
        columns.append(np.broadcast_to(np.nan if value is None else np.array(value), count))
    return np.column_stack(columns)


def _compliance(
    K: tuple[float, ...], D: tuple[float, ...], M: tuple[float, ...], key: str, at: _Lines
) -> model.Compliance:
    with at.about(key):
        return model.Compliance(np.array(K), np.array(D), np.array(M))


def _load(section: LoadSection | None, at: _Lines) -> ToolLoad | None:
    if section is None:
        return None
    with at.about("tool.load", "tool.load: "):
        return ToolLoad(section.mass, np.array(section.com), np.diag(section.inertia))


def _zeroing(section: ZeroSection) -> model.Zeroing:
    return model.Zeroing(tuple(name in section.components for name in _COMPONENTS), np.array(section.frame))


def _clamps(section: ClampSection, key: str, at: _Lines) -> model.Clamps:
    bounds = ((section.torque, 7), (section.force, 6))
    with at.about(key):
        return model.Clamps(*(np.full(count, np.inf) if given is None else np.array(given) for given, count in bounds))


def _changes(document: TaskDocument, at: _Lines, route: model.Route) -> tuple[model.Change, ...]:
    """In the order of time, or of the stops they are at; what a change leaves out of K, D and M is that of the change
    before."""
    out = []
    K, D, M = document.K, document.D, document.M
    named = [isinstance(section.at, str) for section in document.changes]
    if any(named) and not all(named):
        raise at.wrong(f"changes.{named.index(False)}.at", "all at poses or all at seconds; these are mixed", "changes")
    stops = [route.waypoints[i].name for i in route.stops] if any(named) else []
    for i, section in enumerate(document.changes):
        if isinstance(section.at, str) and stops.count(section.at) != 1:
            found = "no stop" if section.at not in stops else f"{stops.count(section.at)} stops"
            message = f"{found} of the name '{section.at}'; name one stop, or give seconds"
            raise at.wrong(f"changes.{i}.at", message)
    order = {name: i for i, name in enumerate(stops)}
    for i, section in sorted(enumerate(document.changes), key=lambda pair: order.get(str(pair[1].at), pair[1].at)):
        key, compliance = f"changes.{i}", None
        if (section.K, section.D, section.M) != (None, None, None):
            K, D, M = section.K or K, section.D or D, section.M or M
            compliance = _compliance(K, D, M, key, at)
        out.append(
            model.Change(
                t=nan if isinstance(section.at, str) else section.at,
                pose=section.at if isinstance(section.at, str) else None,
                compliance=compliance,
                zeroing=None if section.zero is None else _zeroing(section.zero),
                clamps=None if section.clamps is None else _clamps(section.clamps, key, at),
                X_FT=None if section.tool is None else at.frame(section.tool, f"{key}.tool", _LONGEST_TOOL),
                X_WB=None if section.base is None else at.frame(section.base, f"{key}.base"),
                restart=section.restart,
            )
        )
    return tuple(out)


def _capsule(section: CapsuleSection, name: str, key: str, most: float, at: _Lines) -> Capsule:
    a, b = np.array(section.start), np.array(section.end)
    if not (_THINNEST <= section.radius <= most and np.abs([a, b]).max() <= most):
        raise at.wrong(key, f"wanted lengths of {_THINNEST:g} to {most:g} m; check the unit")
    return Capsule(name, a, b, section.radius)


def _contact(section: ContactSection, at: _Lines) -> model.Contact:
    if section.tip > _THICKEST_TIP:
        message = f"{section.tip:g} m is thicker than {_THICKEST_TIP:g} m; check the unit"
        raise at.wrong("contact.tip", message)
    obstacles = []
    for name, one in section.obstacles.items():
        law = one.stiffness, one.damping, one.friction
        if one.capsule is not None:
            capsule = _capsule(one.capsule, name, f"contact.obstacles.{name}.capsule", _FARTHEST, at)
            obstacles.append(model.Obstacle(capsule, *law))
            continue
        assert one.box is not None
        key, size = f"contact.obstacles.{name}.box", one.box.size
        X = at.frame(one.box, key)
        if not all(_THINNEST <= side <= _FARTHEST for side in size):
            sizes = ", ".join(f"{side:g}" for side in size)
            message = f"{sizes} m; wanted three lengths of {_THINNEST:g} to {_FARTHEST:g} m"
            raise at.wrong(f"{key}.size", message)
        obstacles.append(model.Obstacle(Box(name, np.array(size), X), *law))
    return model.Contact(tuple(obstacles), section.tip)
