"""Where a robot's base, its rail or a work object stands in a cell, and the same job with it standing elsewhere.

Places are offsets from the present one: metres along directions of the world, and a turn about the vertical through the
frame's own origin.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import cached_property
from pathlib import Path

import numpy as np

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.exporters.rapid_text import plain
from trajopt_cli.geometry import Array, inverse_pose, pose, rotation_about, rotation_from_wxyz, wxyz_from_rotation
from trajopt_cli.job import Job
from trajopt_cli.motion import PoseMove, Program
from trajopt_cli.problem.plannable import check_plannable
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.problem.programmed import PlantKinematics
from trajopt_cli.quantity import ANGLE, LENGTH, option_number
from trajopt_cli.rapid.language.parser import parse_module
from trajopt_cli.rapid.language.syntax import Aggregate, DataDeclaration
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.units import DEG, MM
from trajopt_cli.validation import hint
from trajopt_cli.yaml_file import read_text, with_value

Offset = tuple[float, ...]
"""By range: m, rad."""

YAW = "yaw"
MOST_RANGES = 4
_WORLD = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
_RANGE = re.compile(r"\s*(\w+)\s*=(.*?)\.\.(.*)", re.DOTALL)
_FARTHEST, _ODD = 20.0, 3.0  # m, with a unit and without one: beyond, somebody may have meant millimetres
_DECIMALS = {"m": 4, "deg": 2}  # of an offset: what is printed is what was tried
_SAME = 1e-5  # m and parts of a rotation; num has 32 bits


class What(StrEnum):
    """What may stand elsewhere."""

    BASE = "base"
    RAIL = "rail"
    STATION = "station"


@dataclass(frozen=True)
class Range:
    """How far something may be moved from where it stands: key, low and high [m, or rad of yaw]."""

    key: str
    low: float
    high: float

    @property
    def turns(self) -> bool:
        """Whether it is an angle."""
        return self.key == YAW

    @property
    def width(self) -> float:
        """From end to end [m, rad]."""
        return self.high - self.low

    def at(self, share: float) -> float:
        """A share 0..1 of the way from low to high, on the grid that is printed."""
        return self.rounded(self.low + share * self.width)

    def rounded(self, value: float) -> float:
        """A value inside, on the grid that is printed."""
        near = round(value / DEG, _DECIMALS["deg"]) * DEG if self.turns else round(value, _DECIMALS["m"])
        return min(max(near, self.low), self.high) + 0.0

    def shown(self, value: float) -> str:
        """A value with its unit, in mm or degrees."""
        return f"{value / DEG:+.4g} deg" if self.turns else f"{value / MM:+.5g} mm"


def parse_ranges(texts: Sequence[str]) -> tuple[Range, ...]:
    """Ranges as people type them: x=-0.3..0.3, z=-100mm..200mm, yaw=-30deg..30deg; numbers without a unit are SI.

    Raises InputError for what is none, runs backwards, is given twice or is too many.
    """
    if not 1 <= len(texts) <= MOST_RANGES:
        raise InputError(f"--range: needs 1 to {MOST_RANGES} ranges, not {len(texts)}; as in --range x=-0.3..0.3")
    out: list[Range] = []
    for text in texts:
        match = _RANGE.fullmatch(text)
        if match is None:
            raise InputError(f"--range {text}: is not KEY=LOW..HIGH, as in x=-0.3..0.3 or yaw=-30deg..30deg")
        key = match[1].lower()
        low, high = (_value(text, key, end) for end in (match[2], match[3]))
        if not low < high:
            raise InputError(f"--range {text}: does not go upward; give the lower end first")
        if any(one.key == key for one in out):
            raise InputError(f"--range {text}: {key} has a range already; keep one")
        out.append(Range(key, low, high))
    return tuple(out)


def _value(text: str, key: str, end: str) -> float:
    value = option_number(end, ANGLE if key == YAW else LENGTH, f"--range {text}")
    if key == YAW and abs(value) > math.pi + 1e-9:
        raise InputError(f"--range {text}: {value / DEG:.6g} deg is more than half a turn; write degrees as 30deg")
    if key != YAW and abs(value) > _FARTHEST:
        raise InputError(f"--range {text}: {value:g} m is more than {_FARTHEST:g} m; write millimetres as 300mm")
    if key != YAW and abs(value) > _ODD and not end.strip()[-1:].isalpha():
        raise InputError(f"--range {text}: {end} without a unit is {value:g} m; write {end}mm or {end}m")
    return value


@dataclass(frozen=True, eq=False)
class Site:
    """What of a job is moved, and how far. name: of the work object, as declared. X: where it is now (4, 4): the base,
    the rail's zero or the user frame, in the world. directions: of every key but yaw that is known for it."""

    job: Job
    what: What
    name: str
    ranges: tuple[Range, ...]
    X: Array
    directions: Mapping[str, Array]

    @property
    def present(self) -> Offset:
        """Where it stands now."""
        return (0.0,) * len(self.ranges)

    @property
    def in_words(self) -> str:
        """For titles: the robot's base, the rail, work object table."""
        return {What.BASE: "the robot's base", What.RAIL: "the rail"}.get(self.what, f"work object {self.name}")

    def shown(self, offset: Offset) -> str:
        """An offset in words: x +120 mm, yaw -5 deg."""
        return ", ".join(f"{one.key} {one.shown(value)}" for one, value in zip(self.ranges, offset, strict=True))

    def frame(self, offset: Offset) -> Array:
        """Its frame (4, 4) in the world at an offset."""
        R, p = self.X[:3, :3], self.X[:3, 3].copy()
        for one, value in zip(self.ranges, offset, strict=True):
            if one.turns:
                R = rotation_about([0, 0, 1], value) @ R
            else:
                p += value * self.directions[one.key]
        return pose(R, p)

    def at(self, offset: Offset) -> Job:
        """The job with it there. Raises InputError where the program cannot be read or planned so."""
        if not any(offset):
            return self.job
        X = self.frame(offset)
        if self.what is What.STATION:
            return self._read(self.job, self._texts(X))
        cell = self.job.cell
        rail = None if cell.rail is None else replace(cell.rail, X_WR=X)
        cell = replace(cell, rail=rail, X_WB=cell.X_WB if rail else X)
        job = replace(self.job, cell=cell, plant=build_plant(cell))
        return self._read(job, {})  # the program may ask where the robot is (CRobT, CalcJointT and others)

    def _read(self, job: Job, texts: Mapping[str, str]) -> Job:
        """A job with its program read again, some texts being others."""
        files = {path: replace(one, text=texts.get(path, one.text)) for path, one in job.program.files.items()}
        found = run_program([*files.values()], job.scenario, job.program.entry, PlantKinematics(job.plant.at_home))
        program = replace(job.program, motions=found.motions, before=found.before, files=files)
        with of_kind(ErrorKind.UNPLANNABLE):
            check_plannable(program, job.plant)
        return replace(job, program=program)

    @cached_property
    def _declared(self) -> tuple[str, DataDeclaration, Aggregate]:
        """Of a work object: file, declaration, the user frame in it."""
        return _declaration(self.job.program, self.name)

    def _texts(self, X: Array) -> dict[str, str]:
        path, _, uframe = self._declared
        text = self.job.program.files[path].text
        return {path: f"{text[: uframe.start]}{rapid_pose(X)}{text[uframe.end :]}"}

    # --------------------------------------------------------------------------------------------- what is written back

    def to_paste(self, offset: Offset) -> str:
        """What changes in the cell file, as YAML; of a work object its declaration in the program, as RAPID."""
        X = self.frame(offset)
        if self.what is What.STATION:
            path, declaration, uframe = self._declared
            text = self.job.program.files[path].text
            body = f"{text[declaration.start : uframe.start]}{rapid_pose(X)}{text[uframe.end : declaration.end]}"
            return f"{body.rstrip().rstrip(';')};\n"
        if self.what is What.RAIL:
            return f"rail:\n  frame: {yaml_frame(X)}\n"
        return f"base: {yaml_frame(X)}\n"

    def check_apply(self, path: Path) -> None:
        """Raise InputError where a cell file at path cannot carry the answer."""
        if self.what is What.STATION:
            raise InputError(f"--apply: work object {self.name} stands in the program, not in the cell file; paste it")
        own = self.job.cell_path
        if path.resolve() == own.resolve():
            raise InputError("--apply: is the cell file itself; name a copy", file=str(path))
        if path.suffix not in (".yaml", ".yml"):
            raise InputError("--apply: writes a cell file; give a name that ends in .yaml", file=str(path))
        if path.exists():
            raise InputError("--apply: is there already; give the name of a new file", file=str(path))
        if self.job.cell.mesh_files and path.resolve().parent != own.resolve().parent:
            message = f"--apply: the meshes lie beside {own}; write the copy there, too"
            raise InputError(message, file=str(path))

    def changed_cell(self, offset: Offset, file: str) -> str:
        """The cell file's text with the frame there; file: its name to be. Raises InputError where that would not be
        read so."""
        keys = ("rail", "frame") if self.what is What.RAIL else ("base",)
        X = self.frame(offset)
        text = with_value(read_text(self.job.cell_path, "cell file"), str(self.job.cell_path), keys, yaml_frame(X))
        cell = parse_cell(text, file)
        found = cell.rail.X_WR if cell.rail is not None else cell.X_WB
        if np.abs(found - X).max() > _SAME:
            raise InputError(f"--apply: {'.'.join(keys)} could not be written into {self.job.cell_path}; paste it")
        return text


def site_of(job: Job, what: str, ranges: tuple[Range, ...]) -> Site:
    """What is to be moved: base, rail or station:NAME.

    Raises InputError for what is none of these, what the robot or the program does not have, and for keys of ranges
    that are unknown or name one direction twice.
    """
    kind, _, name = what.partition(":")
    if kind not in set(What) or bool(name) != (kind == What.STATION):
        raise InputError(f"--what {what}: is not one of base, rail, station:NAME")
    cell, directions, plant = job.cell, {key: np.array(way) for key, way in _WORLD.items()}, job.plant
    if kind == What.BASE and cell.rail is not None:
        raise InputError(f"--what base: robot {cell.robot} rides a rail, which carries its base; give --what rail")
    if kind == What.RAIL and cell.rail is None:
        raise InputError(f"--what rail: robot {cell.robot} has no rail; give --what base")
    if kind == What.STATION:
        name, X = _work_object(job.program, name)
    elif cell.rail is None:
        X = cell.X_WB
    else:
        X = cell.rail.X_WR
        ends = [plant.robot.forward(plant.layout.join(d, plant.start[plant.layout.arm]))[:3, 3] for d in (0.0, 1.0)]
        along = ends[1] - ends[0]
        across = np.cross(_WORLD["z"], along)
        directions["along"] = along / np.linalg.norm(along)
        if np.linalg.norm(across) > _SAME:
            directions |= {"across": across / np.linalg.norm(across), "height": np.array(_WORLD["z"])}
    for one in ranges:
        if not one.turns and one.key not in directions:
            raise InputError(f"--range {one.key}: {hint(one.key, [*directions, YAW])}")
    ways = [directions[one.key] for one in ranges if not one.turns]
    if ways and np.linalg.matrix_rank(np.array(ways), tol=_SAME) < len(ways):
        raise InputError(f"--range: {', '.join(one.key for one in ranges)} name one direction twice; leave one out")
    site = Site(job, What(kind), name, ranges, np.array(X), directions)
    if site.what is What.STATION:
        _check_moves_along(site)
    return site


def _pose_moves(program: Program, name: str) -> list[tuple[int, PoseMove]]:
    moves = enumerate(program.motions)
    return [(i, m) for i, m in moves if isinstance(m, PoseMove) and m.wobj.lower() == name.lower()]


def _work_object(program: Program, name: str) -> tuple[str, Array]:
    """A work object's name as declared, and its user frame [m]."""
    used = dict.fromkeys(m.wobj for m in program.motions if isinstance(m, PoseMove))
    known = [one for one in used if one.lower() != "wobj0"]
    if name.lower() == "wobj0":
        raise InputError("--what station:wobj0: wobj0 is the world itself, which does not move; name a work object")
    if name.lower() not in {one.lower() for one in known}:
        advice = hint(name, known) if known else "all its targets stand in wobj0"
        raise InputError(f"--what station:{name}: the program moves in no such work object; {advice}")
    if any(move.tool.stationary for _, move in _pose_moves(program, name)):
        raise InputError(f"--what station:{name}: the robot holds this work object; it stands nowhere")
    _, declaration, uframe = _declaration(program, name)
    p, q = (np.array(part) for part in uframe.numbers or ())
    return declaration.name, pose(rotation_from_wxyz(q / np.linalg.norm(q)), p * MM)


def _declaration(program: Program, name: str) -> tuple[str, DataDeclaration, Aggregate]:
    """Where a work object's user frame is written. Raises InputError where that is not one literal of a module."""
    found = [
        (path, item)
        for path, file in program.files.items()
        for module in parse_module(file.text, path).modules
        for item in module.items
        if isinstance(item, DataDeclaration) and item.type.lower() == "wobjdata" and item.name.lower() == name.lower()
    ]
    said = f"--what station:{name}: "
    if len(found) != 1:
        where = "no module declares it" if not found else f"{len(found)} modules declare it"
        raise InputError(f"{said}{where}; it needs one declaration with a value")
    path, item = found[0]
    value = item.value
    uframe = value.items[3] if isinstance(value, Aggregate) and len(value.items) == 5 else None
    if not isinstance(uframe, Aggregate) or len(uframe.numbers or ()) != 2:
        raise InputError(f"{said}its declaration gives no user frame in numbers; write them there", file=path)
    return path, item, uframe


def _check_moves_along(site: Site) -> None:
    """Raise InputError unless all targets in a work object move with its declaration."""
    offset = tuple(one.at(1.0) or one.at(0.0) for one in site.ranges)
    try:
        moved = site._read(replace(site.job), site._texts(site.frame(offset))).program
    except InputError:  # nothing is known here; every place says so for itself
        return
    D = site.frame(offset) @ inverse_pose(site.X)
    before, after = _pose_moves(site.job.program, site.name), _pose_moves(moved, site.name)
    for (_, one), (_, other) in zip(before, after, strict=False):
        if np.abs(D @ one.X_WT - other.X_WT).max() > _SAME * (1 + np.abs(one.X_WT).max()):
            message = f"{one.target} does not move with work object {site.name}: the program places it otherwise"
            raise InputError(f"--what station:{site.name}: {message}", file=one.source.file, line=one.source.line)
    if len(before) != len(after):
        raise InputError(f"--what station:{site.name}: the program moves otherwise where it stands elsewhere")


# ----------------------------------------------------------------------------------------------------------------- text


def rapid_pose(X: Array) -> str:
    """A pose [m] as RAPID's aggregate, mm and a quaternion w first."""
    q = wxyz_from_rotation(X[:3, :3])
    return f"[[{','.join(map(plain, X[:3, 3] / MM))}],[{','.join(plain(v, 9) for v in q)}]]"


def yaml_frame(X: Array) -> str:
    """A pose as the cell file's frame: position [m], and a rotation where it has one."""
    position = f"position: [{', '.join(plain(v) for v in X[:3, 3])}]"
    R = X[:3, :3]
    yaw = math.atan2(R[1, 0], R[0, 0])
    if np.abs(R - np.eye(3)).max() < 1e-12:
        return f"{{{position}}}"
    if np.abs(R - rotation_about([0, 0, 1], yaw)).max() < 1e-12:
        return f'{{{position}, rpy: "[0, 0, {plain(yaw / DEG)}] deg"}}'
    return f"{{{position}, wxyz: [{', '.join(plain(v, 9) for v in wxyz_from_rotation(R))}]}}"
