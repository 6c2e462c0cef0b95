"""What a task file orders, read anew for the judge: stops, caps, tool, base, robot and limits, start, arm angle.

Poses come from the task's own list or from a CSV file. A RAPID program, and keys that the judge does not know, are
reported as unchecked, never passed over.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path, PurePath
from typing import Any

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.judge import quaternions as turns
from trajopt_cli.iiwa.judge.tolerances import START
from trajopt_cli.iiwa.judge.written import METRE, PLAIN, RADIAN, SECOND, Written, rate
from trajopt_cli.judge.mechanism import Mechanism
from trajopt_cli.motion import Source
from trajopt_cli.robot.catalogue import find_robot
from trajopt_cli.runs.folder import read_bytes

MOST = 100_000
"""Poses that the judge holds a sequence against."""
_KINDS = {
    **dict.fromkeys("xyz", METRE),
    **dict.fromkeys(("alpha", "beta", "gamma"), RADIAN),
    **dict.fromkeys(("qw", "qx", "qy", "qz"), PLAIN | {"1": 1.0}),
}


def lines_of(path: str) -> list[str]:
    """The lines of a file, its header the first. Raises InputError where it cannot be read."""
    text = read_bytes(Path(path)).decode("utf-8-sig", "replace")
    return [line for line in text.splitlines() if line.strip()]


def read_poses(lines: list[str], path: str, zero: Array) -> Array:
    """Positions and angles (n, 6) in SI, as the task counts them; zero (4,): the rotation that angles count from. path
    is for messages.

    Raises InputError with the file for what it cannot use.
    """
    if len(lines) < 3:
        raise InputError("a path needs a header and at least two poses", file=path)
    mark = next((sign for sign in ";\t" if sign in lines[0]), ",")
    columns: dict[str, tuple[int, float]] = {}
    for i, head in enumerate(lines[0].split(mark)):
        name, _, unit = head.strip().strip('"').partition("[")
        name, unit = name.strip().lower(), unit.strip().rstrip("]").strip()
        if name not in _KINDS or unit not in _KINDS[name]:
            raise InputError(f"the judge does not know the column '{head.strip()}'", file=path, line=1)
        columns[name] = i, _KINDS[name][unit]
    try:
        table = np.array([[float(field) for field in line.split(mark)] for line in lines[1:]])
        if not np.isfinite(table).all():
            raise ValueError("not all are finite")
    except ValueError as error:
        raise InputError(f"a row is no row of numbers: {error}", file=path) from error
    found = {name: table[:, i] * factor for name, (i, factor) in columns.items()}
    if missing := {"x", "y", "z"} - found.keys():
        raise InputError(f"has no column {', '.join(sorted(missing))}", file=path, line=1)
    if "qw" in found:
        q = np.column_stack([found[name] for name in ("qw", "qx", "qy", "qz")])
        q = turns.product(q / np.linalg.norm(q, axis=1, keepdims=True), turns.conjugate(zero))
        angles = turns.to_angles(q)
    else:
        angles = np.column_stack([found[name] for name in ("alpha", "beta", "gamma")])
    return np.column_stack([found["x"], found["y"], found["z"], angles])


_CAPS = {
    "v_max": rate(METRE, 1),
    "omega_max": rate(RADIAN, 1),
    "a_max": rate(METRE, 2),
    "epsilon_max": rate(RADIAN, 2),
    "jerk": rate(METRE, 3),
    "angular_jerk": rate(RADIAN, 3),
}
_KEYS = (
    *_CAPS, "h", "profile", "rotation", "angles", "poses", "program", "approach", "passing", "timing", "start", "tool",
    "base", "robot", "limits", "arm_angle", "K", "D", "M", "integration", "zero", "clamps", "changes", "pushes",
    "sensor", "contact", "force", "controller", "impedance",
)  # fmt: skip
"""What the judge knows: the way and the arm, and the controller, which law.py reads."""
_PROFILES = ("thesis", "trapezoid", "s-curve")

_Caps = dict[str, list[float] | None]


@dataclass(frozen=True, eq=False)
class FramePose:
    """A frame in another: position (3,) [m] and rotation (4,)."""

    p: Array
    q: Array

    def inside(self, outer: FramePose) -> FramePose:
        """This frame, given in outer, seen from where outer is given."""
        return FramePose(outer.p + turns.turned(outer.q, self.p), turns.product(outer.q, self.q))


@dataclass(frozen=True, eq=False)
class Stop:
    """A pose of the task: position and angles (6,) as the task counts them, dwell [s], where it is written. rests: it
    is a stop, although poses are passed."""

    name: str
    pose: Array
    dwell: float
    place: Source
    rests: bool = False


@dataclass(frozen=True, eq=False)
class JudgedArm:
    """The robot: its URDF by pin on its base, and the limits of its k joints."""

    mechanism: Mechanism
    lower: Array
    upper: Array
    velocity: Array
    acceleration: Array


@dataclass(frozen=True, eq=False)
class Order:
    """A task as far as it is judged. X_FT: the tool in the flange; None where only a RAPID program says it.

    start: the tool in the world where the controller is switched on, the zero of relative angles; driven: it is driven
    there before, from start_joints. passing: how near poses are passed without a stop [m], [rad]; None for a stop at
    every pose. reframed: poses count from other frames in the course of the
    controller's run. stops: None where the judge cannot tell them. caps: by name one
    number per segment, or None. unchecked: what of the task is not judged, one line each.
    """

    file: str
    arm: JudgedArm
    X_FT: FramePose | None
    start_joints: Array
    start: FramePose | None
    driven: bool
    h: float
    profile: str
    slerp: bool
    relative: bool
    stops: tuple[Stop, ...] | None
    passing: tuple[float, float] | None
    caps: dict[str, list[float] | None]
    swivel: bool
    arm_angle: float | None
    arm_angle_free: bool
    reframed: bool
    unchecked: tuple[str, ...]


def read_order(
    path: str, program: str | None = None, first: Callable[[FramePose, JudgedArm], FramePose] | None = None
) -> Order:
    """The order in a task file. program: a RAPID program, or a path as CSV, takes the place of its poses. first: where
    the sequence begins, of the tool and the arm, which decides whether it has a path from the start to the first pose
    where the task does not say.

    Raises InputError with file, line and key for what the judge cannot use.
    """
    task = Written(path, "task file")
    arm = read_arm(str(task.at("robot", "iiwa7")), task.at("limits", "default"), frame(task, "base"))
    start_joints = np.array(task.numbers("start.joints", task.at("start.joints"), RADIAN, len(arm.lower)))
    given = program or task.at("program") or task.at("poses")
    source = str(given) if isinstance(given, str) else ""
    if source and program is None:
        source = str(PurePath(path).parent / source)
    from_csv, placed = source.lower().endswith(".csv"), {"position", "wxyz", "rpy"} & set(task.section("tool"))
    X_FT = None if source and not from_csv and not placed else frame(task, "tool")
    start = None if X_FT is None else X_FT.inside(arm_frame(arm.mechanism, start_joints))
    unchecked = list(_foreign(task))
    stops: list[Stop] | None = None
    pressed = isinstance(task.at("force"), dict)
    relative, driven = task.choice("angles", "relative", "absolute") == "relative", False
    if source and not from_csv:
        unchecked.append(
            f"{path}:{task.line('program')}: path and speeds, because they come from a RAPID program, which this judge"
            " does not read"
        )
    elif from_csv and len(lines := lines_of(source)) - 1 > MOST:
        unchecked.append(f"{source}: path and speeds, because {len(lines) - 1} poses are more than {MOST}")
    elif from_csv and lines[0].startswith("t [s],x_e [m],"):
        unchecked.append(f"{source}: path and speeds, because they are a run's poses, which are thinned")
    elif not unchecked:
        assert start is not None
        if from_csv:
            rows = read_poses(lines, source, start.q if relative else np.array([1.0, 0.0, 0.0, 0.0]))
            settle = task.number("force.settle", task.at("force.settle", 0.0), SECOND) if pressed else 0.0
            stops = [Stop(str(i + 1), p, 0.0 if i else settle, Source(source, i + 2, 1)) for i, p in enumerate(rows)]
        else:
            stops = _stops(task, start, relative)
    caps = {key: _cap(task, key, stops) for key in _CAPS}
    if stops is not None:
        assert start is not None
        assert X_FT is not None
        begin = None if first is None else first(X_FT, arm)
        start, stops, driven, caps = _approach(task, start, relative, stops, caps, begin)
    passing = _passing(task, from_csv)
    h = task.number("h", task.at("h", 1e-3), SECOND)
    if h <= 0:
        raise task.refused("h", f"needs a period above zero, not {h:g}")
    angle = task.at("arm_angle")
    value = angle.get("value") if isinstance(angle, dict) else None
    return Order(
        file=path,
        arm=arm,
        X_FT=X_FT,
        start_joints=start_joints,
        start=start,
        driven=driven,
        h=h,
        profile=task.choice("profile", *(_PROFILES if passing is None else reversed(_PROFILES))),
        slerp=task.choice("rotation", "tait-bryan", "slerp") == "slerp",
        relative=relative,
        stops=None if stops is None else tuple(stops),
        passing=passing,
        caps=caps,
        swivel=isinstance(angle, dict) and task.choice("arm_angle.definition", "faria", "swivel") == "swivel",
        arm_angle=None if value is None else task.number("arm_angle.value", value, RADIAN),
        arm_angle_free=angle == "free",
        reframed=_reframed(task),
        unchecked=tuple(unchecked),
    )


def _reframed(task: Written) -> bool:
    """Whether a change gives other frames to count from."""
    changes = task.at("changes", [])
    if not isinstance(changes, list):
        raise task.refused("changes", f"needs a list, not {changes!r}")
    return any({"tool", "base", "restart"} & set(task.section(f"changes.{i}")) for i in range(len(changes)))


def _approach(
    task: Written, start: FramePose, relative: bool, stops: list[Stop], caps: _Caps, begin: FramePose | None
) -> tuple[FramePose, list[Stop], bool, _Caps]:
    """The same with the path from the start to the first pose, where they differ: a line before it, or the arm driven
    there before the controller is switched on, whose relative angles count from that pose then."""
    q = turns.from_angles(stops[0].pose[3:])
    first = FramePose(stops[0].pose[:3], turns.product(q, start.q) if relative else q)
    how = task.choice("approach", "line", "joint", "none")
    if task.at("approach") is None and not (begin is not None and _near(begin, start)):
        how = "none"  # not asked for, and not what the rows do
    if _near(first, start) or how == "none":
        return start, stops, False, caps
    if how == "line":
        angles = np.zeros(3) if relative else turns.to_angles(start.q)
        stop = Stop("start", np.concatenate([start.p, angles]), 0.0, task.place("start.joints"))
        stops = [stop, replace(stops[0], rests=True), *stops[1:]]
        return start, stops, False, {key: None if one is None else one[:1] + one for key, one in caps.items()}
    if relative:
        turn = turns.product(start.q, turns.conjugate(first.q))
        anew = [turns.to_angles(turns.product(turns.from_angles(one.pose[3:]), turn)) for one in stops]
        stops = [replace(one, pose=np.concatenate([one.pose[:3], new])) for one, new in zip(stops, anew, strict=True)]
    return first, stops, True, caps


def _near(a: FramePose, b: FramePose) -> bool:
    return bool(np.linalg.norm(a.p - b.p) < START and turns.angle_between(a.q, b.q) < START)


def _passing(task: Written, from_csv: bool) -> tuple[float, float] | None:
    given = task.at("passing", {} if from_csv else "stop")
    if given == "stop":
        return None
    if not isinstance(given, dict):
        raise task.refused("passing", f"needs 'stop' or a section, not {given!r}")
    return (
        task.number("passing.tolerance", given.get("tolerance", 1e-4), METRE),
        task.number("passing.turn_tolerance", given.get("turn_tolerance", "0.5 deg"), RADIAN),
    )


def read_arm(robot: str, limits: str, base: FramePose | None = None) -> JudgedArm:
    """A robot by name or by the path of its YAML file: ranges and speeds by pin from the URDF, accelerations of the
    profile. Raises InputError."""
    path = find_robot(robot)
    file = Written(str(path), "robot file")
    X_WB = np.eye(4)
    if base is not None:
        X_WB[:3, 3] = base.p
        X_WB[:3, :3] = turns.to_matrix(base.q)
    urdf = path.parent / str(file.at("urdf"))
    if not urdf.is_file():
        raise file.refused("urdf", f"{urdf} does not exist")
    mechanism = Mechanism(urdf, X_WB)
    profile = file.at(f"profiles.{limits}.acceleration")
    if profile is None:
        known = ", ".join(file.at("profiles", {}))
        raise file.refused("profiles", f"there is no profile {limits}; known are {known}")
    keys = [f"profiles.{limits}.acceleration.{name}.value" for name in mechanism.names]
    return JudgedArm(mechanism, *mechanism.ranges, np.array([file.number(key, file.at(key), PLAIN) for key in keys]))


def arm_frame(mechanism: Mechanism, q: Array) -> FramePose:
    """The flange in the world at joints q (k,)."""
    X = mechanism.flange_pose(q)
    return FramePose(X[:3, 3], turns.from_matrix(X[:3, :3]))


def periods(dwell: float, h: float) -> int:
    """Whole periods of a dwell: it is never shorter than asked for, and at least one where there is any."""
    return max(1, math.ceil(dwell / h * (1 - 1e-9))) if dwell > 0 else 0


def _foreign(task: Written) -> list[str]:
    """A line for every key that the judge does not know: what it changes is not judged, and so neither is the path."""
    return [
        f"{task.file}:{task.line(key)}: path and speeds, because the judge does not know the key '{key}'"
        for key in task.content
        if key not in _KEYS
    ]


def frame(task: Written, key: str, given: Mapping[str, Any] | None = None) -> FramePose:
    """The frame in a section, given unless it is the one at the key."""
    section = task.section(key) if given is None else given
    p = np.array(task.numbers(f"{key}.position", section.get("position", [0, 0, 0]), METRE, 3))
    if "wxyz" in section:
        q = np.array(task.numbers(f"{key}.wxyz", section["wxyz"], PLAIN, 4))
        if not q.any():
            raise task.refused(f"{key}.wxyz", "is zero, which is no rotation")
        return FramePose(p, q / np.linalg.norm(q))
    rpy = task.numbers(f"{key}.rpy", section.get("rpy", [0, 0, 0]), RADIAN, 3)
    return FramePose(p, turns.from_angles(np.array(rpy)))  # URDF's roll, pitch and yaw are these very angles


def _stops(task: Written, start: FramePose, relative: bool) -> list[Stop]:
    angles = np.zeros(3) if relative else turns.to_angles(start.q)
    if not isinstance(task.at("poses"), list):
        raise task.refused("poses", "needs a list of poses")
    first, out = np.concatenate([start.p, angles]), list[Stop]()
    for i, given in enumerate(task.at("poses")):
        key = f"poses.{i}"
        section = {"at": given} if isinstance(given, list | str) else given
        if not isinstance(section, dict) or ("at" in section) == ("by" in section):
            raise task.refused(key, "needs one of 'at' and 'by'")
        if section.get("at") == "start":
            pose = first
        else:
            values = section["at"] if "at" in section else section["by"]
            if not isinstance(values, list) or len(values) != 6:
                raise task.refused(key, f"needs 6 values, not {values!r}")
            pose = np.array([task.number(key, v, METRE if j < 3 else RADIAN) for j, v in enumerate(values)])
            if "by" in section:
                if not out:
                    raise task.refused(key, "'by' adds to the pose before, and there is none")
                pose = out[-1].pose + pose
        dwell = task.number(f"{key}.dwell", section.get("dwell", 0.0), SECOND)
        out.append(Stop(str(section.get("name", i + 1)), pose, dwell, task.place(key)))
    if len(out) < 2:
        raise task.refused("poses", f"{len(out)} given; a path needs at least two")
    return out


def _cap(task: Written, key: str, stops: list[Stop] | None) -> list[float] | None:
    value = task.at(key)
    if value is None:
        return None
    count = 1 if stops is None else len(stops) - 1
    given = value if isinstance(value, list) else [value] * count
    if stops is not None and len(given) != count:
        raise task.refused(key, f"{len(given)} values for {count} segments")
    out = [task.number(key, one, _CAPS[key]) for one in given]
    for cap in out:
        if cap < 0:
            raise task.refused(key, f"is {cap:g}; a cap is 0 or more")
    return out
