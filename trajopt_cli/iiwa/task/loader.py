"""Reads a task file: YAML with a place for every key, checked against the document's shape, turned into a Task."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from trajopt_cli.cell.loader import frame_pose
from trajopt_cli.cell.suspected import TASK, suspected
from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.approach import Approached, by_joints, by_line
from trajopt_cli.iiwa.task.document import (
    ChangeSection,
    ClampSection,
    ContactDocument,
    ContactSection,
    LoadSection,
    PassingSection,
    TaskDocument,
    ZeroSection,
)
from trajopt_cli.iiwa.task.model import (
    AngleMeaning,
    Change,
    Clamps,
    Compliance,
    Contact,
    Integration,
    Obstacle,
    Passing,
    Profile,
    Push,
    RotationLaw,
    Route,
    SegmentSpeeds,
    Sensor,
    Task,
    Waypoint,
    Zeroing,
)
from trajopt_cli.iiwa.task.path_csv import read_path
from trajopt_cli.iiwa.task.path_csv import read_text as read_csv_text
from trajopt_cli.iiwa.task.poses import program_route, written_waypoints
from trajopt_cli.limits import JointLimits
from trajopt_cli.robot.dynamics import ToolLoad
from trajopt_cli.robot.srs import SrsRobot, load_srs
from trajopt_cli.robot.srs_inverse import ArmAngle, singularities
from trajopt_cli.shapes import Box
from trajopt_cli.yaml_file import line_of, parse, read_text, refuse_empty, validated

_COMPONENTS = ("fx", "fy", "fz", "mx", "my", "mz")
_CAPS = ("v_max", "omega_max", "a_max", "epsilon_max", "jerk", "angular_jerk")
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
def load_task(path: str | Path, poses_from: str | Path | None = None) -> Task:
    """Read the task file at path (UTF-8 YAML), and the RAPID program it names.

    poses_from: a RAPID file to take the poses from instead of the ones the task file gives. Raises InputError, one line
    per finding, each with file, line and key.
    """
    file = str(path)
    return parse_task(read_text(path, "task file"), file, poses_from)


@of_kind(ErrorKind.PROGRAM)
def parse_task(text: str, file: str, poses_from: str | Path | None = None) -> Task:
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
            raise InputError("poses: give one of 'poses' and 'program'", file=file, line=line_of("poses", lines))
        content = {("program" if key == "poses" else key): value for key, value in content.items()}
        lines = {**lines, "program": line_of("poses", lines)}
    document = validated(TaskDocument, content, lines, file, _WANTED)
    doubts = map(str, suspected(content, TASK, lines, file))
    X_WB = _near(frame_pose(document.base), "base", _FARTHEST, lines, file)
    X_FT = _near(frame_pose(document.tool), "tool", _LONGEST_TOOL, lines, file)
    try:
        robot = load_srs(document.robot, X_WB)
    except InputError as error:
        raise InputError(f"robot: {error}", file=file, line=line_of("robot", lines)) from error
    try:
        robot.profile(document.limits)
    except InputError as error:
        raise InputError(f"limits: {error}", file=file, line=line_of("limits", lines)) from error
    start = np.array(document.start.joints)
    _check_start(robot, start, robot.profile(document.limits), lines, file)
    X_WF = robot.forward(start)
    meaning, texts = AngleMeaning(document.angles), {file: text}
    waypoints: Sequence[Waypoint]
    notes: tuple[str, ...] = ()
    from_csv = document.program is not None and document.program.lower().endswith(".csv")
    passing = _passing(document, from_csv)
    if document.program is not None:
        program = Path(poses_from) if poses_from is not None else Path(file).parent / document.program
        if not program.is_file():
            message = f"{given}: there is no file {program}; it must be in the task file's folder or below it"
            raise InputError(message, file=file, line=line_of("program", lines))
    if from_csv:
        texts[str(program)] = read_csv_text(str(program))
        waypoints = read_path(texts[str(program)], str(program), meaning, X_WF[:3, :3] @ X_FT[:3, :3])
        speeds = _speeds(document, waypoints, lines, file, None)
    elif document.program is not None:
        placed = document.tool.model_fields_set & {"position", "wxyz", "rpy"}
        found = program_route(
            program, meaning, X_WF[:3, :3], X_FT if placed else None, passing.tolerance if passing else None
        )
        waypoints, X_FT, texts[str(program)], notes = found.waypoints, found.X_FT, found.text, found.notes
        if np.abs(X_FT[:3, 3]).max() > _LONGEST_TOOL:
            message = (
                f"the moves' tool reaches {np.abs(X_FT[:3, 3]).max():g} m from the flange, at most {_LONGEST_TOOL:g} m"
            )
            raise InputError(message, file=str(program))
        if not placed and document.tool.load is None:
            notes += ("the tool is the program's; its load is not taken over, give it as tool.load where it matters",)
        speeds = _speeds(document, waypoints, lines, file, found.speeds)
    else:
        assert document.poses is not None
        waypoints = written_waypoints(document.poses, meaning, X_WF @ X_FT, lines, file)
        speeds = _speeds(document, waypoints, lines, file, None)
    definition = ArmAngle(document.arm_angle.definition if document.arm_angle else "faria")
    angle = document.arm_angle.value if document.arm_angle else None
    if document.approach == "line":
        place = f"{file}:{line_of('start.joints', lines)}"
        path = by_line(start, X_WF @ X_FT, waypoints, speeds, meaning, place)
    elif document.approach == "joint":
        path = by_joints(robot, start, X_FT, waypoints, speeds, meaning, definition, angle)
        _check_start(robot, path.start_joints, robot.profile(document.limits), lines, file, "approach")
    else:
        path = Approached(start, waypoints, speeds)
    return Task(
        file=file,
        robot=document.robot,
        limits=document.limits,
        route=Route(
            path.waypoints,
            path.speeds,
            document.h,
            Profile(document.profile or ("thesis" if passing is None else "s-curve")),
            RotationLaw(document.rotation),
            meaning,
            passing,
        ),
        compliance=_compliance(document.K, document.D, document.M, "K", lines, file),
        start_joints=path.start_joints,
        X_WB=X_WB,
        X_FT=X_FT,
        load=_load(document.tool.load, lines, file) if document.tool.load is not None else None,
        definition=definition,
        arm_angle=angle,
        integration=Integration(document.integration),
        zeroing=_zeroing(document.zero),
        clamps=_clamps(document.clamps, "clamps", lines, file),
        changes=_changes(document, lines, file),
        pushes=tuple(Push(push.start, push.end, np.array(push.force)) for push in document.pushes),
        sensor=Sensor(
            document.sensor.bias,
            tuple((one.frequency, one.amplitude) for one in document.sensor.ripple),
            document.sensor.rigid,
            document.sensor.seed,
        )
        if document.sensor is not None
        else None,
        contact=_contact(document.contact, lines, file) if document.contact is not None else None,
        notes=(*doubts, *notes, *path.notes),
        sources=texts,
    )


@of_kind(ErrorKind.PROGRAM)
def load_contact(path: str | Path) -> tuple[Contact, str]:
    """The contact section of a task file, or of a file that holds nothing else, and the file's text.

    Raises InputError as load_task does.
    """
    file, text = str(path), read_text(path, "contact file")
    content, lines = parse(text, file, "a contact section is needed")
    if "contact" in content:
        refuse_empty({"contact": content["contact"]}, lines, file)
    return _contact(validated(ContactDocument, content, lines, file, _WANTED).contact, lines, file), text


def _passing(document: TaskDocument, from_csv: bool) -> Passing | None:
    """How poses are passed; those of a CSV file are unless the file says otherwise."""
    section = document.passing
    if section is None and from_csv and "passing" not in document.model_fields_set:
        section = PassingSection()
    return None if section is None else Passing(section.tolerance, section.turn_tolerance)


def _near(X: Array, key: str, most: float, lines: Mapping[str, int], file: str) -> Array:
    """A frame that a cell can have. Raises InputError for one too far away."""
    if np.abs(X[:3, 3]).max() > most:
        message = f"{key}.position: {np.abs(X[:3, 3]).max():g} m is farther than {most:g} m; check the unit"
        raise InputError(message, file=file, line=line_of(f"{key}.position", lines))
    return X


def _check_start(
    robot: SrsRobot,
    start: Array,
    limits: JointLimits,
    lines: Mapping[str, int],
    file: str,
    key: str = "start.joints",
) -> None:
    """Refuse a start outside a joint's range, and one from which the arm's configuration cannot be told."""
    line = line_of(key, lines)
    for name, value, low, high in zip(limits.names, start, limits.lower, limits.upper, strict=True):
        if not low <= value <= high:
            message = f"{key}: {name} = {np.degrees(value):.6g}°, outside its range"
            raise InputError(f"{message} {np.degrees(low):g}°..{np.degrees(high):g}°", file=file, line=line)
    for singular in singularities(robot, start[None], _SINGULAR):
        message = f"{key}: singular, {singular.name}: arm angle and configuration are not defined there"
        raise InputError(f"{message}; start a degree away from it", file=file, line=line)


def _speeds(
    document: TaskDocument,
    waypoints: Sequence[Waypoint],
    lines: Mapping[str, int],
    file: str,
    given: tuple[tuple[float, float], ...] | None,
) -> tuple[SegmentSpeeds, ...]:
    """Caps per segment; given: v_max and omega_max of a program, which the file's own replace."""
    count = len(waypoints) - 1
    same = given is None and not any(isinstance(getattr(document, key), tuple) for key in _CAPS)
    columns: dict[str, list[float] | list[None]] = {}
    for key in _CAPS:
        value = getattr(document, key)
        if isinstance(value, tuple) and len(value) != count:
            message = f"{key}: {len(value)} values for {count} segments; give one for all, or one each"
            raise InputError(message, file=file, line=line_of(key, lines))
        if value is None and given is not None and key in ("v_max", "omega_max"):
            columns[key] = [pair[key == "omega_max"] for pair in given]
        elif value is None and key in ("v_max", "omega_max"):
            raise InputError(f"{key}: is missing; give a cap for all segments, or one each", file=file, line=1)
        elif isinstance(value, tuple):
            columns[key] = list(value)
        else:
            columns[key] = [value] * count
    each = (
        SegmentSpeeds(**{key: columns[key][i] for key in _CAPS})  # type: ignore[arg-type]
        for i in range(1 if same else count)
    )
    return tuple(each) * (count if same else 1)


def _compliance(
    K: tuple[float, ...], D: tuple[float, ...], M: tuple[float, ...], key: str, lines: Mapping[str, int], file: str
) -> Compliance:
    try:
        return Compliance(np.array(K), np.array(D), np.array(M))
    except ValueError as error:
        raise InputError(str(error), file=file, line=line_of(key, lines)) from error


def _load(section: LoadSection, lines: Mapping[str, int], file: str) -> ToolLoad:
    try:
        return ToolLoad(section.mass, np.array(section.com), np.diag(section.inertia))
    except ValueError as error:
        raise InputError(f"tool.load: {error}", file=file, line=line_of("tool.load", lines)) from error


def _zeroing(section: ZeroSection) -> Zeroing:
    return Zeroing(tuple(name in section.components for name in _COMPONENTS), np.array(section.frame))


def _clamps(section: ClampSection, key: str, lines: Mapping[str, int], file: str) -> Clamps:
    try:
        return Clamps(
            np.array(section.torque) if section.torque is not None else np.full(7, np.inf),
            np.array(section.force) if section.force is not None else np.full(6, np.inf),
        )
    except ValueError as error:
        raise InputError(str(error), file=file, line=line_of(key, lines)) from error


def _changes(document: TaskDocument, lines: Mapping[str, int], file: str) -> tuple[Change, ...]:
    """In the order of time; what a change leaves out of K, D and M is that of the change before."""
    out = []
    K, D, M = document.K, document.D, document.M
    order = sorted(range(len(document.changes)), key=lambda i: document.changes[i].at)
    for i in order:
        section: ChangeSection = document.changes[i]
        compliance = None
        if (section.K, section.D, section.M) != (None, None, None):
            K, D, M = section.K or K, section.D or D, section.M or M
            compliance = _compliance(K, D, M, f"changes.{i}", lines, file)
        out.append(
            Change(
                t=section.at,
                compliance=compliance,
                zeroing=_zeroing(section.zero) if section.zero is not None else None,
                clamps=_clamps(section.clamps, f"changes.{i}", lines, file) if section.clamps is not None else None,
                X_FT=_near(frame_pose(section.tool), f"changes.{i}.tool", _LONGEST_TOOL, lines, file)
                if section.tool is not None
                else None,
                X_WB=_near(frame_pose(section.base), f"changes.{i}.base", _FARTHEST, lines, file)
                if section.base is not None
                else None,
                restart=section.restart,
            )
        )
    return tuple(out)


def _contact(section: ContactSection, lines: Mapping[str, int], file: str) -> Contact:
    if section.tip > _THICKEST_TIP:
        message = f"contact.tip: {section.tip:g} m is thicker than {_THICKEST_TIP:g} m; check the unit"
        raise InputError(message, file=file, line=line_of("contact.tip", lines))
    obstacles = []
    for name, one in section.obstacles.items():
        key = f"contact.obstacles.{name}.box"
        X = _near(frame_pose(one.box), key, _FARTHEST, lines, file)
        if not all(_THINNEST <= size <= _FARTHEST for size in one.box.size):
            sizes = ", ".join(f"{size:g}" for size in one.box.size)
            message = f"{key}.size: {sizes} m; wanted three lengths of {_THINNEST:g} to {_FARTHEST:g} m"
            raise InputError(message, file=file, line=line_of(f"{key}.size", lines))
        obstacles.append(Obstacle(Box(name, _array(one.box.size), X), one.stiffness, one.damping, one.friction))
    return Contact(tuple(obstacles), section.tip)


def _array(values: tuple[float, ...]) -> Array:
    return np.array(values)
