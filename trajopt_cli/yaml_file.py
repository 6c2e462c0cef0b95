"""YAML files that people write by hand: every key remembers its line, every mistake becomes one line about it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from difflib import get_close_matches
from pathlib import Path
from typing import Any, TypeVar, get_type_hints

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails
from ruamel.yaml import YAML
from ruamel.yaml.comments import CommentedMap, CommentedSeq
from ruamel.yaml.error import MarkedYAMLError, YAMLError

from trajopt_cli.errors import InputError, InputErrorGroup

Model = TypeVar("Model", bound=BaseModel)


def read_text(path: str | Path, what: str) -> str:
    """The file's UTF-8 text; what names it in messages. Raises InputError where it cannot be read."""
    try:
        return Path(path).read_text(encoding="utf-8")
    except OSError as error:
        raise InputError(f"cannot read the {what}: {error.strerror}", file=str(path)) from error
    except UnicodeDecodeError as error:
        raise InputError(f"byte {error.start} is not UTF-8; save the {what} as UTF-8", file=str(path)) from error


def parse(text: str, file: str, needed: str) -> tuple[dict[str, Any], dict[str, int]]:
    """A YAML mapping as plain data, and the line of every key by its dotted path ("limits.joint_1", "poses.0").

    file is for messages; needed says what an empty file lacks. Raises InputError for text that is not such a mapping.
    """
    lines: dict[str, int] = {}
    return _plain(_tree(text, file, needed), "", lines, file), lines


def validated(
    model: type[Model], content: Any, lines: Mapping[str, int], file: str, wanted: Mapping[str, str]
) -> Model:
    """content as a model. wanted: what to do about a missing key, by its dotted path or by its own name alone.

    Raises InputError, one line per finding in the order of the file, each with file, line and key.
    """
    try:
        return model.model_validate(content)
    except ValidationError as error:
        found = [_input_error(model, detail, lines, file, wanted) for detail in error.errors()]
        found.sort(key=lambda one: one.line or 0)
        raise found[0] if len(found) == 1 else InputErrorGroup(found) from error


def line_of(key: str, lines: Mapping[str, int]) -> int:
    """The line of a key by its dotted path, or of its closest parent that has one; 1 for none."""
    parts = key.split(".")
    parents = (".".join(parts[:n]) for n in range(len(parts), 0, -1))
    return next((lines[parent] for parent in parents if parent in lines), 1)


def hint(name: str, known: Sequence[str]) -> str:
    """What to do about an unknown name: the closest known one, else all of them."""
    close = get_close_matches(name, known, n=1)
    return f"did you mean '{close[0]}'?" if close else f"known: {', '.join(known)}"


def _tree(text: str, file: str, needed: str) -> CommentedMap:
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
        raise InputError(f"holds no 'key: value' lines; {needed}", file=file, line=1)
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
    for kind in (int, float, str):  # ruamel's own scalars remember how they were written; nobody here needs that
        if isinstance(node, kind):
            return kind(node)
    raise InputError(f"{path}: {node} is not a number, text, list or section", file=file, line=lines.get(path, 1))


def _keys(model: type[BaseModel], location: Sequence[str | int]) -> list[str]:
    """The keys of the section that holds location."""
    for part in location[:-1]:
        field = model.model_fields.get(str(part))
        # else a name of the user's own: a key that the section admits, or one of a field that maps names
        annotation = field.annotation if field is not None else get_type_hints(model).get("__pydantic_extra__")
        for choice in _models(annotation):
            model = choice
    return [field.alias or name for name, field in model.model_fields.items()]


def _models(annotation: Any) -> Iterator[type[BaseModel]]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation
    for inner in getattr(annotation, "__args__", ()):
        yield from _models(inner)


def _input_error(
    model: type[BaseModel], detail: ErrorDetails, lines: Mapping[str, int], file: str, wanted: Mapping[str, str]
) -> InputError:
    key = ".".join(str(part) for part in detail["loc"]) or "file"
    return InputError(f"{key}: {_message(model, detail, wanted)}", file=file, line=line_of(key, lines))


def _message(model: type[BaseModel], detail: ErrorDetails, wanted: Mapping[str, str]) -> str:
    given, location = detail["input"], detail["loc"]
    match detail["type"]:
        case "extra_forbidden":
            return f"unknown key; {hint(str(location[-1]), _keys(model, location))}"
        case "missing":
            path = ".".join(str(part) for part in location)
            return f"is missing; {wanted.get(path) or wanted.get(str(location[-1]), 'add it')}"
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
