"""A cell as the rest of the program sees it: robot by name, its mounting, limits in force, signals, start."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from math import ceil, floor
from pathlib import Path

import numpy as np

from trajopt_cli.errors import ErrorKind, InputError
from trajopt_cli.geometry import Array, readonly
from trajopt_cli.limits import AXIS_LIMITS, JointLimits, TcpCaps
from trajopt_cli.scenario import ESTIMATED_SETTLING, Follower, Lines, Scenario, Settling
from trajopt_cli.shapes import Grip, MeshFile, Solid
from trajopt_cli.units import MM
from trajopt_cli.validation import hint
from trajopt_cli.warnings import ProgramWarning
from trajopt_cli.yaml_file import line_of

TOOL_RADIUS = 0.025
"""m: of the capsule that stands for a tool nobody described. As thick as the IRB 140's last link."""
_NUMBER = r"\s*[-+]?[\d.]+(?:[eE][-+]?\d+)?\s*"
_EXTERNAL_AXES = re.compile(rf"\[({_NUMBER}(?:,{_NUMBER}){{5}})\]\s*\]")  # the end of a robtarget or jointtarget
_TOPICS = {"lower": "position", "upper": "position", "acceleration_factor": "acceleration"}
_UNUSED = 9e8  # 9E9 says that an axis is not used


@dataclass(frozen=True, eq=False)
class Rail:
    """eax: index of the external axis that drives it, 0 for eax_a. X_WR (4, 4): the rail's zero in the world.

    stroke: lowest and highest position [m]. fixed: robtargets keep the rail position their program gives. track: width
    and height [m] of the beam under the base, None where it is no body. direction (3,): in the arm's base frame, None
    for the robot file's.
    """

    eax: int
    stroke: tuple[float, float]
    X_WR: Array
    fixed: bool = False
    track: tuple[float, float] | None = None
    direction: tuple[float, float, float] | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "X_WR", readonly(self.X_WR))


@dataclass(frozen=True)
class CarrierAxis:
    """A linear axis under the base. name: in limits and files, "rail_a", or "rail" where it is the only one. eax: index
    of the external axis, 0 for eax_a. direction (3,): in the world. stroke [m]; velocity, acceleration, jerk: None
    where the cell file gives none; source of these."""

    name: str
    eax: int
    direction: tuple[float, float, float]
    stroke: tuple[float, float]
    velocity: float | None
    acceleration: float | None
    jerk: float | None
    source: str


@dataclass(frozen=True)
class LimitOverride:
    """A number of the cell file (SI) instead of the robot's: kind is lower, upper, velocity, acceleration, jerk or
    torque; or acceleration_factor, by which the robot's accelerations are multiplied."""

    axis: str
    kind: str
    value: float
    source: str


@dataclass(frozen=True, eq=False)
class Cell:
    """A cell file's content in SI.

    file: as the user gave it. robot: a name, or the path of its file. X_WB (4, 4): base in the world of a robot
    without a rail. tcp: None where the robot's documented caps apply. start_joints [rad], start_rail [m], one of each
    axis. axes: linear ones under the base, instead of a rail; followers: external axes led by these. droppable:
    target names in lower case. lines: the line of each key by its dotted path, for messages. obstacles: in the world;
    attached: in the flange frame; meshes still in their files. may_touch: pairs of links or attached bodies that are
    not held against each other. clearance: the least distance wanted from obstacles [m]. tool_radius [m]: of the
    capsule from flange to TCP that stands for the tool where nothing is attached; 0 for none. grips: which obstacles
    the flange takes on the way. body_files: that say which bodies there are, besides meshes. doubts: numbers that look
    like another unit. order: groups of procedures and lines, by name, that may be done in any order. settle: what takes
    the place of the robot's Settling [s], fine and inpos.
    """

    file: str
    robot: str
    profile: str
    rail: Rail | None
    X_WB: Array
    overrides: tuple[LimitOverride, ...]
    tcp: TcpCaps | None
    tcp_source: str | None
    start_joints: tuple[float, ...]
    start_rail: tuple[float, ...]
    scenario: Scenario
    free_speed: bool
    jerk_limits: bool
    droppable: frozenset[str]
    lines: Mapping[str, int] = field(default_factory=dict)
    obstacles: tuple[Solid, ...] = ()
    attached: tuple[Solid, ...] = ()
    may_touch: tuple[tuple[str, str], ...] = ()
    clearance: float = 0.0
    tool_radius: float = TOOL_RADIUS
    grips: tuple[Grip, ...] = ()
    body_files: tuple[Path, ...] = ()
    doubts: tuple[ProgramWarning, ...] = ()
    torque_limits: bool = False
    settle: tuple[float | None, float | None] = (None, None)
    order: Mapping[str, tuple[Lines | str, ...]] = field(default_factory=dict)
    axes: tuple[CarrierAxis, ...] = ()
    followers: tuple[Follower, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "X_WB", readonly(self.X_WB))

    def error(self, key: str, message: str) -> InputError:
        """The error message about key, placed at its line in the cell file (or at its closest parent's)."""
        return InputError(f"{key}: {message}", file=self.file, line=line_of(key, self.lines), kind=ErrorKind.CELL)

    @property
    def mesh_files(self) -> tuple[Path, ...]:
        """The files that obstacles are read from, each once, as paths that begin where `file` does."""
        shapes = [solid.shape for solid in (*self.obstacles, *self.attached)]
        meshes = [path for shape in shapes if isinstance(shape, MeshFile) for path in shape.files]
        return tuple(dict.fromkeys([*self.body_files, *meshes]))

    def robot_files(self, files: Sequence[Path] = ()) -> tuple[Path, ...]:
        """The robot's own YAML file and those it names; none for a robot that ships."""
        return (Path(self.robot), *files) if self.robot.endswith((".yaml", ".yml")) else ()

    def settling(self, robot: Settling | None) -> Settling:
        """What is in force: the cell's times, else the robot's, else an estimate; inpos is fine where only that is
        given."""
        fine, inpos = self.settle
        known = robot or ESTIMATED_SETTLING
        if fine is None and inpos is None:
            return known
        inpos = fine if inpos is None else inpos
        assert inpos is not None
        if fine is None:  # as unsure as it was
            return known._replace(inpos=inpos, source=f"settle.inpos of {self.file}; fine: {known.source}")
        return Settling(fine, inpos, f"settle of {self.file}")

    def apply_limits(self, limits: JointLimits, axis_names: tuple[str, ...]) -> JointLimits:
        """limits with the cell's overrides and the rail's stroke in force, sources included.

        Raises InputError for an axis the robot has not, for a limit nobody gave, and for an empty range.
        """
        values = {}
        for kind in ("lower", "upper", *AXIS_LIMITS):
            given = getattr(limits, kind)
            if given is not None or any(change.kind == kind for change in self.overrides):
                nobody = np.inf if kind == "torque" else np.nan
                values[kind] = np.full(len(axis_names), nobody) if given is None else np.array(given)
        sources, grades, spread = dict(limits.sources), dict(limits.grades), dict(limits.spread)
        table = limits.table
        changes = list(self.overrides)
        if self.rail is not None:
            place = f"rail.stroke of {self.file}"
            low, high = self.rail.stroke
            changes += [LimitOverride("rail", "lower", low, place), LimitOverride("rail", "upper", high, place)]
        for carrier in self.axes:
            ends = zip(("lower", "upper"), carrier.stroke, strict=True)
            place = f"axes.eax_{'abcdef'[carrier.eax]}.stroke of {self.file}"
            changes += [LimitOverride(carrier.name, end, value, place) for end, value in ends]
        for change in changes:
            if change.axis not in axis_names:
                message = f"robot {self.robot} has no such axis; {hint(change.axis, axis_names)}"
                raise self.error(f"limits.{change.axis}", message)
            i, topic = axis_names.index(change.axis), _TOPICS.get(change.kind, change.kind)
            source = change.source
            if change.kind == "acceleration_factor":
                values[topic][i] *= change.value
                table = table and table.scaled({change.axis: change.value})
                source = f"{change.value:g} times {sources[f'{change.axis}.{topic}']}: {source}"
            else:
                values[change.kind][i] = change.value
                if topic == "acceleration":
                    table = table and table.without(change.axis)
            sources[f"{change.axis}.{topic}"] = source
            for known in (grades, spread):
                known.pop(f"{change.axis}.{topic}", None)
        for i, axis in enumerate(axis_names):
            for kind, column in values.items():
                if not np.isfinite(column[i]) and kind != "torque":
                    raise self.error(f"limits.{axis}", f"robot {self.robot} gives no {kind}; add it with its source")
            if not values["lower"][i] < values["upper"][i]:
                low, high = values["lower"][i], values["upper"][i]
                raise self.error(f"limits.{axis}", f"lower {low:.6g} is not below upper {high:.6g}")
        if self.jerk_limits and "jerk" not in values:
            raise self.error(
                "jerk_limits", f"robot {self.robot} gives no jerk; give each axis its own under limits, with its source"
            )
        return JointLimits(
            names=limits.names, **values, sources=sources, grades=grades, spread=spread, jerk_binds=self.jerk_limits,
            torque_binds=self.torque_limits and "torque" in values, coupled=limits.coupled,
            table=table,
        )  # fmt: skip


def minimal_cell(program: str, text: str = "", robots: Collection[str] = ()) -> str:
    """The shortest useful cell file for a program, as text to save and adapt.

    text: of its files. It tells the axis of the rail and how far its targets reach, by the literals of robtargets and
    jointtargets, and the robot where a name as IRB 1600 begins one of robots.
    """
    places = [[float(value) for value in group.split(",")] for group in _EXTERNAL_AXES.findall(text)]
    axis = next((i for i in range(6) if any(abs(place[i]) < _UNUSED for place in places)), None if text else 0)
    reach = [place[axis] * MM for place in places if axis is not None and abs(place[axis]) < _UNUSED] or [0.0, 2.0]
    stroke = f"[{floor(min(0.0, *reach) * 10 - 2) / 10:g}, {ceil(max(reach) * 10 + 2) / 10:g}]"
    on_rail = "" if axis is None else "_rail"
    numbers = re.findall(r"\bIRB[ _-]?(\d{3,5})", text, re.IGNORECASE)
    named = [one for number in numbers for one in sorted(robots) if re.match(rf"irb{number}(_\d|{on_rail}$)", one)]
    robot = next((one for one in named if one.endswith("_rail") == bool(on_rail)), f"irb140{on_rail}")
    lines = [
        f"# the cell of {program}: SI units, or a text with a unit",
        f"robot: {robot}  # 'trajopt robot list' shows the others",
        "profile: default  # acceleration limits: default or optimistic",
    ]
    if axis is not None:
        about = (
            "travel in m: the targets' and 0.2 m; no rail: remove it" if places else "travel in m; no rail: remove it"
        )
        lines.append(f"rail: {{eax: {'abcdef'[axis]}, stroke: {stroke}}}  # external axis, {about}")
    start = ", rail: 0" if axis is not None else ""
    lines.append(f'start: {{joints: "[0, 0, 0, 0, 30, 0] deg"{start}}}  # where the cycle begins, at rest')
    return "\n".join(lines) + "\n"
