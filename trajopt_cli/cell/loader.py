"""Reads a cell file: YAML with a place for every key, checked against the document's shape, turned into a Cell."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import pairwise
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from trajopt_cli.cell.document import (
    MOST_AXES,
    CellDocument,
    FenceSection,
    FreeRail,
    FreeSection,
    PositionerSection,
    SolidSection,
)
from trajopt_cli.cell.model import CarrierAxis, Cell, LimitOverride, Rail
from trajopt_cli.cell.scene_files import Found, frame_pose, from_folder, from_list, from_urdf
from trajopt_cli.cell.suspected import CELL, suspected
from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.geometry import pose, rotation_about, wxyz_from_rotation
from trajopt_cli.limits import TcpCaps
from trajopt_cli.motion import FreeTurn, Source
from trajopt_cli.scenario import (
    ConstantSpeed,
    Follower,
    FreeTool,
    Given,
    HoldRail,
    Lines,
    PositionerAxis,
    RailPlace,
    RailUnit,
    Scenario,
    condition_key,
)
from trajopt_cli.shapes import Box, Capsule, Grip, MeshFile, Rides, Solid
from trajopt_cli.validation import hint
from trajopt_cli.warnings import ProgramWarning, WarningKind
from trajopt_cli.yaml_file import line_of, parse, read_text, validated

_Value = TypeVar("_Value")
_EXTERNAL_AXES = "abcdef"
_RATES = ("velocity", "acceleration", "jerk")


@of_kind(ErrorKind.CELL)
def load_cell(path: str | Path) -> Cell:
    """Read the cell file at path (UTF-8 YAML).

    Raises InputError, one line per finding, each with file, line and key: unreadable file, broken YAML, unknown or
    missing key, wrong type or unit, a number that is not finite, an empty range, an override without its source.
    """
    file = str(path)
    return parse_cell(read_text(path, "cell file"), file)


@of_kind(ErrorKind.CELL)
def parse_cell(text: str, file: str) -> Cell:
    """The Cell in a cell file's text; file is its name in messages. Raises InputError as load_cell does."""
    return cell_of(*parse(text, file, "at least robot and start are needed"), file)


@of_kind(ErrorKind.CELL)
def cell_of(content: Mapping[str, Any], lines: Mapping[str, int], file: str) -> Cell:
    """The Cell in what yaml_file.parse gives of a cell file. Raises InputError as load_cell does."""
    document = validated(CellDocument, content, lines, file, _WANTED)
    cell = _cell(document, file, lines)
    return replace(cell, doubts=(*cell.doubts, *suspected(content, CELL, lines, file)))


_WANTED = {
    "robot": "name the robot, for example 'robot: irb140_rail' ('trajopt robot list' shows all)",
    "start": "say where the cycle begins: 'start: {joints: \"[0, 0, 0, 0, 30, 0] deg\"}'",
    "start.joints": "give the arm's joints at the start, '\"[0, 0, 0, 0, 30, 0] deg\"'",
    "source": "an override says where its number comes from",
    "axes.stroke": "give its travel in m, 'stroke: [-0.2, 2.2]'",
    "rail.eax": "say which external axis drives the rail, 'eax: a'",
    "rail.stroke": "give the rail's travel in m, 'stroke: [-0.2, 2.2]'",
}


@dataclass(eq=False)
class _Bodies:
    """The bodies of a section, in order; files that were read for them besides meshes; what is told about these."""

    solids: list[Solid]
    files: list[Path]
    notes: list[str]
    unknown: dict[str, str] = field(default_factory=dict)  # what bodies are said to ride on, and is none

    @classmethod
    def of(
        cls, sections: Mapping[str, SolidSection], folder: Path, units: Mapping[str, int], file: str,
        lines: Mapping[str, int],
    ) -> _Bodies:  # fmt: skip
        """units: how many axes each positioner has, by its name in lower case."""
        out = cls([], [], [])
        for name, section in sections.items():
            try:
                found = _found(name, section, folder)
            except InputError as error:
                if error.file is not None:
                    raise
                line = line_of(f"obstacles.{name}", lines)
                raise InputError(f"obstacles.{name}: {error.message}", file=file, line=line) from error
            for shape, ignore, on in found.shapes:
                rides = _rides(on or section.on, units)
                if (wanted := on or section.on) is not None and rides is None:
                    out.unknown.setdefault(name, wanted)
                out.solids.append(Solid(shape, frozenset((*section.ignore, *ignore)), rides))
            out.files += found.files
            out.notes += found.notes
        return out


def _found(name: str, section: SolidSection, folder: Path) -> Found:
    if section.fence is not None:
        return Found([(wall, (), None) for wall in _walls(name, section.fence)])
    if section.urdf is not None:
        return from_urdf(name, folder / section.urdf.file, frame_pose(section.urdf), folder)
    if section.folder is not None:
        many = section.folder
        return from_folder(name, folder / many.path, frame_pose(many), many.scale)
    if section.list is not None:
        return from_list(name, folder / section.list.file, frame_pose(section.list))
    shape: Box | Capsule | MeshFile
    if section.box is not None:
        shape = Box(name, np.array(section.box.size), frame_pose(section.box))
    elif section.capsule is not None:
        capsule = section.capsule
        shape = Capsule(name, np.array(capsule.start), np.array(capsule.end), capsule.radius)
    else:
        assert section.mesh is not None
        shape = MeshFile(name, folder / section.mesh.file, frame_pose(section.mesh), section.mesh.scale)
    return Found([(shape, (), None)])


def _rides(on: str | None, units: Mapping[str, int]) -> Rides | None:
    """The positioner that carries a body, `STN1`, or its first axes, `STN1.1`; None without one that is known."""
    unit, _, axis = (on or "").lower().partition(".")
    many = units.get(unit, 0)
    axes = many if not axis else int(axis) if axis.isdecimal() else 0
    return Rides(unit, axes) if 0 < axes <= many else None


def _robot(given: str, folder: Path) -> str:
    """A robot's name, or the path of its file, which is looked for beside the cell file."""
    return str(folder / given) if given.endswith((".yaml", ".yml")) else given


def _walls(name: str, fence: FenceSection) -> Iterator[Box]:
    """A fence's walls, each as long as the way between its posts and once its thickness, so that corners are closed."""
    for i, (a, b) in enumerate(pairwise(np.array(fence.points)), 1):
        along = b - a
        X = pose(
            rotation_about([0, 0, 1], np.arctan2(along[1], along[0])), [*(a + b) / 2, fence.floor + fence.height / 2]
        )
        size = np.array([np.linalg.norm(along) + fence.thickness, fence.thickness, fence.height])
        yield Box(name if len(fence.points) == 2 else f"{name} {i}", size, X)


def _scenario(document: CellDocument, file: str, lines: Mapping[str, int]) -> Scenario:
    def by(section: str, given: Mapping[str, _Value], key: Callable[[str], str] = str.lower) -> dict[str, _Value]:
        spelled: dict[str, str] = {}
        for name in given:
            if (first := spelled.setdefault(key(name), name)) != name:
                message = f"{section}.{name}: is the same to RAPID as {section}.{first}; keep one"
                raise InputError(message, file=file, line=line_of(f"{section}.{name}", lines))
        return {key(name): value for name, value in given.items()}

    waits = by("waits", document.waits, condition_key)
    for name, least in document.waits.items():
        if isinstance(least, FreeRail) and (name.lower() != "rail" or not (document.rail or document.axes)):
            message = "there is no rail; remove it or add a rail section"
            if document.rail or document.axes:
                message = f"says nothing of the rail here; 'waits: {{rail: {{free: [{name}]}}}}' lets it move"
            raise InputError(f"waits.{name}: {message}", file=file, line=line_of(f"waits.{name}", lines))
    freed = waits.get("rail")
    by("rail_at", document.rail_at, condition_key)
    return Scenario(
        signals=by("signals", document.signals),
        answers=by("answers", document.answers),
        data=by("data", {name: Given(one.value, one.type) for name, one in document.data.items()}),
        waits={key: least for key, least in waits.items() if not isinstance(least, FreeRail)},
        searches=by("searches", document.searches),
        endless_passes=document.endless_passes,
        pass_limit=document.pass_limit,
        statement_limit=document.statement_limit,
        assume_identity=frozenset(by("assume_identity", dict.fromkeys(document.assume_identity))),
        stubs=frozenset(by("stubs", dict.fromkeys(document.stubs))),
        hold_rail=HoldRail(
            frozenset(name.lower() for name in document.hold_rail.procedures),
            frozenset(document.hold_rail.lines),
            document.hold_rail.waits,
            document.hold_rail.gripper,
            _freed(freed.waits, file, lines) if isinstance(freed, FreeRail) else False,
        ),
        constant_speed=ConstantSpeed(
            frozenset(part.lower() for part in document.constant_speed if isinstance(part, str)),
            frozenset(part for part in document.constant_speed if not isinstance(part, str)),
        ),
        positioners=by("positioners", {name: _axes(axes) for name, axes in document.positioners.items()}),
        free_speed=document.free_speed,
        droppable=frozenset(name.lower() for name in document.optional),
        rail=_rail_unit(document),
        rail_at={
            condition_key(name): RailPlace(name, d, Source(file, line_of(f"rail_at.{name}", lines), 1))
            for name, d in document.rail_at.items()
        },
        active_units=None if document.start.units is None else frozenset(map(str.lower, document.start.units)),
        partner=dict(document.partner),
        free=tuple(_free(one, Source(file, line_of(f"free.{i}", lines), 1)) for i, one in enumerate(document.free)),
    )


def _free(section: FreeSection, place: Source) -> FreeTool:
    parts, (low, high) = section.parts or (), section.within
    axis = (float(section.axis == "x"), float(section.axis == "y"), float(section.axis == "z"))
    names = tuple(part for part in parts if isinstance(part, str))
    lines = tuple(part for part in parts if not isinstance(part, str))
    return FreeTool(FreeTurn(axis, max(low, -np.pi), min(high, np.pi)), place, names, lines)


def _freed(
    waits: bool | tuple[str | Lines, ...], file: str, lines: Mapping[str, int]
) -> bool | dict[str | Lines, Source]:
    if isinstance(waits, bool):
        return waits
    return {one: Source(file, line_of(f"waits.rail.free.{i}", lines), 1) for i, one in enumerate(waits)}


def _axes(sections: Iterable[PositionerSection]) -> tuple[PositionerAxis, ...]:
    out = []
    for section in sections:
        X = frame_pose(section.frame)
        x, y, z = X[:3, 3].tolist()
        w, i, j, k = wxyz_from_rotation(X[:3, :3]).tolist()
        out.append(
            PositionerAxis(
                _EXTERNAL_AXES.index(section.eax),
                (x, y, z),
                (w, i, j, k),
                section.reach,
                section.velocity,
                section.acceleration,
                section.start,
                section.source,
                section.stroke is not None,
            )
        )
    return tuple(out)


def _rail_unit(document: CellDocument) -> RailUnit | None:
    if document.rail is not None:
        return RailUnit(_EXTERNAL_AXES.index(document.rail.eax), document.rail.unit)
    letters = [_EXTERNAL_AXES.find(name[-1:]) for name, axis in sorted(document.axes.items()) if axis.axis]
    return RailUnit(letters[0], None, tuple(letters[1:])) if letters else None


def _carriers(document: CellDocument, cell: Cell) -> tuple[tuple[CarrierAxis, ...], tuple[Follower, ...]]:
    """The linear axes under the base by their letters, within what those that follow them may do, and these."""
    for name in document.axes:
        if name not in [f"eax_{letter}" for letter in _EXTERNAL_AXES]:
            raise cell.error(f"axes.{name}", "is no external axis; name it by its letter, eax_a to eax_f")
    own = {name: one for name, one in sorted(document.axes.items()) if one.axis is not None}
    if document.axes and not 0 < len(own) <= MOST_AXES:
        raise cell.error("axes", f"{len(own)} of them have a direction (axis), wanted 1 to {MOST_AXES}")
    ends = {name: one.stroke or (0.0, 0.0) for name, one in own.items()}
    rates = {name: {kind: getattr(one, kind) for kind in _RATES} for name, one in own.items()}
    followers = []
    for name, one in document.axes.items():
        if one.follows is None:
            continue
        if one.follows not in own:
            raise cell.error(
                f"axes.{name}.follows", f"'{one.follows}' has no axis of its own; {hint(one.follows, [*own])}"
            )
        followers.append(Follower(_letter(name), _letter(one.follows), one.ratio, one.offset))
        if one.stroke is not None:
            low, high = sorted((end - one.offset) / one.ratio for end in one.stroke)
            low, high = max(low, ends[one.follows][0]), min(high, ends[one.follows][1])
            if not low < high:
                raise cell.error(f"axes.{name}.stroke", f"leaves {one.follows}, which it follows, no travel")
            ends[one.follows] = low, high
        for kind, least in rates[one.follows].items():
            if (rate := getattr(one, kind)) is not None:
                rates[one.follows][kind] = min(rate / abs(one.ratio), np.inf if least is None else least)
    return tuple(
        CarrierAxis(
            "rail" if len(own) == 1 else f"rail_{name[-1]}",
            _letter(name),
            one.axis or (0.0, 0.0, 0.0),
            ends[name],
            **rates[name],
            source=one.source or cell.file,
        )
        for name, one in own.items()
    ), tuple(followers)


def _letter(name: str) -> int:
    return _EXTERNAL_AXES.index(name[-1])


def _cell(document: CellDocument, file: str, lines: Mapping[str, int]) -> Cell:
    rail = document.rail
    units = {name.lower(): len(axes) for name, axes in document.positioners.items()}
    overrides = tuple(
        LimitOverride(axis, kind, value, section.source)
        for axis, section in document.limits.by_axis().items()
        for kind, value in section
        if kind != "source" and value is not None
    )
    folder = Path(file).parent
    bodies = _Bodies.of(document.obstacles, folder, units, file, lines)
    attached = _Bodies.of(
        {name: one for name, one in document.attached.items() if not one.many}, folder, {}, file, lines
    )
    tool: dict[str, Any] = dict(document.tcp or ())
    tool_source = tool.pop("source", None)
    cell = Cell(
        file=file,
        robot=_robot(document.robot, Path(file).parent),
        profile=document.profile,
        rail=Rail(
            _EXTERNAL_AXES.index(rail.eax),
            rail.stroke,
            frame_pose(rail.frame),
            rail.fixed,
            (rail.track.width, rail.track.height) if rail.track else None,
            rail.direction,
        )
        if rail
        else None,
        X_WB=frame_pose(document.base) if document.base else np.eye(4),
        overrides=overrides,
        tcp=TcpCaps(**{name: value for name, value in tool.items() if value is not None}) if tool else None,
        tcp_source=tool_source,
        start_joints=document.start.joints,
        start_rail=document.start.rail or (),
        scenario=_scenario(document, file, lines),
        free_speed=document.free_speed,
        jerk_limits=document.jerk_limits,
        torque_limits=document.torque_limits,
        settle=(document.settle.fine, document.settle.inpos),
        droppable=frozenset(name.lower() for name in document.optional),
        obstacles=tuple(bodies.solids),
        attached=tuple(attached.solids),
        body_files=tuple(bodies.files),
        doubts=tuple(ProgramWarning(WarningKind.ASSUMED, text, file) for text in bodies.notes),
        may_touch=document.may_touch,
        clearance=document.clearance,
        tool_radius=document.tool_radius,
        grips=tuple(Grip(one.part, one.at, one.detach) for one in document.attach),
        order=document.order,
        lines=lines,
    )
    if document.axes and rail is not None:
        raise cell.error("rail", "axes has all linear axes; make the rail one of them")
    if document.axes:
        axes, followers = _carriers(document, cell)
        cell = replace(cell, axes=axes, followers=followers, start_rail=document.start.rail or (0.0,) * len(axes))
    _check_units(document, cell)
    slides = cell.rail is not None or bool(cell.axes)
    if cell.rail is not None and document.base is not None:
        raise cell.error("base", "a robot on a rail is placed by rail.frame; remove one of the two")
    if cell.rail is not None and len(cell.start_rail) != 1:
        raise cell.error("start.rail", "is missing; give the rail's position at the start, in m")
    if cell.axes and len(cell.start_rail) != len(cell.axes):
        names = ", ".join(f"eax_{_EXTERNAL_AXES[axis.eax]}" for axis in cell.axes)
        raise cell.error("start.rail", f"gives {len(cell.start_rail)} positions; give one [m] for each of {names}")
    for key in ("hold_rail", "rail_at"):
        if not slides and key in document.model_fields_set:
            raise cell.error(key, "there is no rail; remove it or add a rail section")
    if len(cell.axes) > 1 and document.rail_at:
        raise cell.error("rail_at", "says where one rail stands; with several axes give their positions in the targets")
    for name, d in document.rail_at.items():
        if cell.rail is not None and not cell.rail.stroke[0] <= d <= cell.rail.stroke[1]:
            low, high = cell.rail.stroke
            raise cell.error(f"rail_at.{name}", f"{d:g} m is not on the rail, whose stroke is {low:g}..{high:g} m")
    if not slides and cell.start_rail:
        raise cell.error("start.rail", "there is no rail; remove it or add a rail section")
    if document.attached and "tool_radius" in document.model_fields_set and document.tool_radius > 0:
        raise cell.error("tool_radius", "the attached bodies stand for the tool; remove one of the two")
    seen: dict[str, str] = {}
    for section, solids in (("obstacles", cell.obstacles), ("attached", cell.attached)):
        for solid in solids:
            if solid.name in seen:
                where = f"{section}.{solid.name}"
                raise cell.error(where, f"a body under {seen[solid.name]} has this name; give it another one")
            seen[solid.name] = section
    for name, on in bodies.unknown.items():
        known = [*document.positioners, *(f"{one}.1" for one, axes in document.positioners.items() if axes[1:])]
        text = f"'{on}' is no positioner of this file, nor an axis of one"
        raise cell.error(f"obstacles.{name}.on", f"{text}; {hint(on, known)}" if known else text)
    for name, body in document.obstacles.items():
        if body.on is not None and body.fence is not None:
            raise cell.error(f"obstacles.{name}.on", "a fence stands on the floor; give the positioner a box")
    there = [solid.name for solid in cell.obstacles]
    for i, one in enumerate(document.attach):
        if (named := document.obstacles.get(one.part)) is not None and named.fence is not None:
            raise cell.error(f"attach.{i}.part", f"'{one.part}' is a fence; no robot carries it")
        if one.part not in there:
            text = f"'{one.part}' is no obstacle; say under obstacles where it stands"
            raise cell.error(f"attach.{i}.part", f"{text}; {hint(one.part, there)}")
    for name, body in document.attached.items():
        if body.many:
            shape = next(key for key in ("fence", "urdf", "folder", "list") if getattr(body, key) is not None)
            what = "a fence stands on the floor" if body.fence else "it may be many bodies"
            raise cell.error(f"attached.{name}.{shape}", f"{what}; give the flange a box, a capsule or a mesh")
        if body.on is not None:
            raise cell.error(f"attached.{name}.on", "the flange carries it; a positioner carries obstacles")
    return cell


def _check_units(document: CellDocument, cell: Cell) -> None:
    """Raise where an axis drives two things at once: positioners may share one, and then one at a time is active."""
    rail = document.rail
    named = {name.lower(): [axis.eax for axis in axes] for name, axes in document.positioners.items()}
    for name, axes in document.positioners.items():
        driven = {name[-1]: f"axes.{name}" for name in document.axes} | ({} if rail is None else {rail.eax: "the rail"})
        for axis in axes:
            if axis.eax in driven:
                message = f"eax {axis.eax} drives {driven[axis.eax]} already; give each axis its own"
                raise cell.error(f"positioners.{name}", message)
            driven[axis.eax] = f"positioner {name}"
    if rail is not None and rail.unit is not None:
        if rail.unit.lower() in named:
            raise cell.error("rail.unit", f"positioner {rail.unit} has this name; give each unit its own")
        named[rail.unit.lower()] = [rail.eax]
    active: dict[str, str] = {}
    for i, name in enumerate(document.start.units or ()):
        if name.lower() not in named:
            known = [*document.positioners, *([rail.unit] if rail is not None and rail.unit else [])]
            raise cell.error(f"start.units.{i}", f"'{name}' is no mechanical unit of this file; {hint(name, known)}")
        for eax in named[name.lower()]:
            if (other := active.setdefault(eax, name)).lower() != name.lower():
                raise cell.error(f"start.units.{i}", f"{other} has eax {eax}, too; one of them at a time is active")
