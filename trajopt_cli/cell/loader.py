"""Reads a cell file: YAML with a place for every key, checked against the document's shape, turned into a Cell."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails
from ruamel.yaml import YAML
from ruamel.yaml.comments import CommentedMap, CommentedSeq
from ruamel.yaml.error import MarkedYAMLError, YAMLError

from trajopt_cli.cell.document import CellDocument, FrameSection, LimitSection, LimitsSection, SolidSection
from trajopt_cli.cell.model import Cell, LimitOverride, Rail, hint
from trajopt_cli.errors import InputError, InputErrorGroup
from trajopt_cli.geometry import Array, pose, rotation_about, rotation_from_wxyz
from trajopt_cli.limits import TcpCaps
from trajopt_cli.scenario import Scenario
from trajopt_cli.shapes import Box, Capsule, MeshFile, Solid

_EXTERNAL_AXES = "abcdef"


def load_cell(path: str | Path) -> Cell:
    """Read the cell file at path (UTF-8 YAML).

    Raises InputError, one line per finding, each with file, line and key: unreadable file, broken YAML, unknown or
    missing key, wrong type or unit, a number that is not finite, an empty range, an override without its source.
    """
    file = str(path)
    try:
        text = Path(path).read_text(encoding="utf-8")
    except OSError as error:
        raise InputError(f"cannot read the cell file: {error.strerror}", file=file) from error
    except UnicodeDecodeError as error:
        raise InputError(f"byte {error.start} is not UTF-8; save the cell file as UTF-8", file=file) from error
    return parse_cell(text, file)


def parse_cell(text: str, file: str) -> Cell:
    """The Cell in a cell file's text; file is its name in messages. Raises InputError as load_cell does."""
    tree = _yaml(text, file)
    lines: dict[str, int] = {}
    content = _plain(tree, "", lines, file)
    try:
        document = CellDocument.model_validate(content)
    except ValidationError as error:
        found = sorted((_input_error(detail, lines, file) for detail in error.errors()), key=lambda e: e.line or 0)
        raise found[0] if len(found) == 1 else InputErrorGroup(found) from error
    return _cell(document, file, lines)


def _yaml(text: str, file: str) -> CommentedMap:
    try:
        tree = YAML().load(text)
    except MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        line = mark.line + 1 if mark else None
        problem = str(error.problem or error.context).split(' with value "')[0]
        said = "" if problem.startswith("found duplicate") else _unit_hint(text, line)
        raise InputError(f"broken YAML: {problem}{said}", file=file, line=line) from error
    except YAMLError as error:
        raise InputError(f"broken YAML: {str(error).splitlines()[0]}", file=file) from error
    if not isinstance(tree, CommentedMap):
        raise InputError("holds no 'key: value' lines; robot and start are needed at least", file=file, line=1)
    return tree


def _unit_hint(text: str, line: int | None) -> str:
    # `[0, 30] deg` is not YAML: the list ends the value. It is the first thing people try.
    rows = text.splitlines()
    around = rows[line - 1] if line is not None and line <= len(rows) else ""
    return '; a list with a unit goes in quotes, "[0, 30] deg"' if "]" in around and '"' not in around else ""


def _plain(node: Any, path: str, lines: dict[str, int], file: str) -> Any:
    """node as plain dicts, lists and scalars; lines learns the line of every key on the way."""
    if isinstance(node, CommentedMap):
        out = {}
        for key, value in node.items():
            line = node.lc.data[key][0] + 1 if key in (node.lc.data or {}) else lines.get(path, 1)
            inner = f"{path}.{key}" if path else str(key)
            if not isinstance(key, str):
                raise InputError(f"key {inner} is not text; put it in quotes", file=file, line=line)
            lines[inner] = line
            out[key] = _plain(value, inner, lines, file)
        return out
    if isinstance(node, CommentedSeq):
        for i in range(len(node)):
            lines[f"{path}.{i}"] = node.lc.data[i][0] + 1
        return [_plain(value, f"{path}.{i}", lines, file) for i, value in enumerate(node)]
    if isinstance(node, bool) or node is None:
        return node
    for kind in (int, float, str):  # ruamel's own scalars remember how they were written; the document needs none of it
        if isinstance(node, kind):
            return kind(node)
    raise InputError(f"{path}: {node} is not a number, text, list or section", file=file, line=lines.get(path, 1))


def _keys(model: type[BaseModel], location: Sequence[str | int]) -> list[str]:
    """The keys of the section that holds location."""
    for part in location[:-1]:
        field = model.model_fields.get(str(part))
        if field is not None:
            for choice in _models(field.annotation):
                model = choice
        elif model is LimitsSection:  # an axis' name; the names of solids lead to nothing else than their section
            model = LimitSection
    return [field.alias or name for name, field in model.model_fields.items()]


def _models(annotation: Any) -> Iterator[type[BaseModel]]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation
    for inner in getattr(annotation, "__args__", ()):
        yield from _models(inner)


def _input_error(detail: ErrorDetails, lines: Mapping[str, int], file: str) -> InputError:
    location = detail["loc"]
    key = ".".join(str(part) for part in location) or "cell"
    parents = (".".join(str(part) for part in location[:n]) for n in range(len(location), 0, -1))
    line = next((lines[parent] for parent in parents if parent in lines), 1)
    return InputError(f"{key}: {_message(detail, location)}", file=file, line=line)


def _message(detail: ErrorDetails, location: Sequence[str | int]) -> str:
    given = detail["input"]
    match detail["type"]:
        case "extra_forbidden":
            return f"unknown key; {hint(str(location[-1]), _keys(CellDocument, location))}"
        case "missing" if location[-1] == "source":
            return "is missing; an override says where its number comes from"
        case "missing":
            return f"is missing; {_WANTED.get('.'.join(str(part) for part in location), 'add it')}"
        case "model_type" | "dict_type":
            return f"needs a section of 'key: value' lines, not {given}"
        case "tuple_type":
            return f"needs a list, not {given}"
        case "string_type":
            return f"needs text, not {given}"
        case "bool_type":
            return f"needs true or false, not {given}"
        case "int_type" | "int_parsing" | "int_from_float" | "greater_than":
            return f"needs a whole number above zero, not {given}"
        case "literal_error":
            return f"{given} is not one of {detail['ctx']['expected']}"
    return detail["msg"]


_WANTED = {
    "robot": "name the robot, for example 'robot: irb140_rail' ('trajopt robot list' shows all)",
    "start": "say where the cycle begins: 'start: {joints: \"[0, 0, 0, 0, 30, 0] deg\"}'",
    "start.joints": "give the arm's joints at the start, '\"[0, 0, 0, 0, 30, 0] deg\"'",
    "rail.eax": "say which external axis drives the rail, 'eax: a'",
    "rail.stroke": "give the rail's travel in m, 'stroke: [-0.2, 2.2]'",
}


def _frame(section: FrameSection) -> Array:
    if section.wxyz is not None:
        return pose(rotation_from_wxyz(section.wxyz), section.position)
    roll, pitch, yaw = section.rpy or (0.0, 0.0, 0.0)
    R = rotation_about([0, 0, 1], yaw) @ rotation_about([0, 1, 0], pitch) @ rotation_about([1, 0, 0], roll)
    return pose(R, section.position)


def _solids(sections: Mapping[str, SolidSection], folder: Path) -> tuple[Solid, ...]:
    out = []
    for name, section in sections.items():
        shape: Box | Capsule | MeshFile
        if section.box is not None:
            shape = Box(name, np.array(section.box.size), _frame(section.box))
        elif section.capsule is not None:
            capsule = section.capsule
            shape = Capsule(name, np.array(capsule.start), np.array(capsule.end), capsule.radius)
        else:
            assert section.mesh is not None
            shape = MeshFile(name, folder / section.mesh.file, _frame(section.mesh), section.mesh.scale)
        out.append(Solid(shape, frozenset(section.ignore)))
    return tuple(out)


def _cell(document: CellDocument, file: str, lines: Mapping[str, int]) -> Cell:
    rail = document.rail
    overrides = tuple(
        LimitOverride(axis, kind, value, section.source)
        for axis, section in document.limits.by_axis().items()
        for kind in ("lower", "upper", "velocity", "acceleration", "jerk")
        if (value := getattr(section, kind)) is not None
    )
    cell = Cell(
        file=file,
        robot=document.robot,
        profile=document.profile,
        rail=Rail(_EXTERNAL_AXES.index(rail.eax), rail.stroke, _frame(rail.frame), rail.fixed) if rail else None,
        X_WB=_frame(document.base) if document.base else np.eye(4),
        overrides=overrides,
        tcp=TcpCaps(document.tcp.speed, document.tcp.acceleration) if document.tcp else None,
        tcp_source=document.tcp.source if document.tcp else None,
        start_joints=document.start.joints,
        start_rail=document.start.rail,
        scenario=Scenario(
            signals={name.lower(): value for name, value in document.signals.items()},
            waits=document.waits,
            pass_limit=document.pass_limit,
        ),
        free_speed=document.free_speed,
        droppable=frozenset(name.lower() for name in document.optional),
        obstacles=_solids(document.obstacles, Path(file).parent),
        attached=_solids(document.attached, Path(file).parent),
        may_touch=document.may_touch,
        clearance=document.clearance,
        lines=lines,
    )
    if cell.rail is not None and document.base is not None:
        raise cell.error("base", "a robot on a rail is placed by rail.frame; remove one of the two")
    if cell.rail is not None and cell.start_rail is None:
        raise cell.error("start.rail", "is missing; give the rail's position at the start, in m")
    if cell.rail is None and cell.start_rail is not None:
        raise cell.error("start.rail", "there is no rail; remove it or add a rail section")
    for name in document.attached:
        if name in document.obstacles:
            raise cell.error(f"attached.{name}", "an obstacle has this name too; give each body its own")
    return cell
