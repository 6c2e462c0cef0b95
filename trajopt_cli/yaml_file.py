"""YAML files that people write by hand: every key remembers its line, every mistake becomes one line about it."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from copy import deepcopy
from functools import lru_cache, wraps
from pathlib import Path
from typing import Any, NoReturn, TypeVar, cast

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails
from ruamel.yaml import YAML
from ruamel.yaml.composer import Composer
from ruamel.yaml.error import MarkedYAMLError, YAMLError
from ruamel.yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode

from trajopt_cli.errors import InputError, InputErrorGroup
from trajopt_cli.file_kinds import refuse_other
from trajopt_cli.validation import in_words, short, spelled

Model = TypeVar("Model", bound=BaseModel)
Reading = TypeVar("Reading", bound=Callable[..., Any])

MAX_BYTES, MAX_NODES, MAX_DEPTH = 1_000_000, 200_000, 50
"""Bounds of a file: its text, its values and keys once aliases are expanded, and sections or lists in each other."""
_MAX_KEY, _MAX_PATH = 100, 500  # characters: a line about the key is to stay a line
_MAX_DIGITS = 1000  # of a whole number; Python itself refuses to read or print more than 4300
_KEPT = 50_000  # characters of a text that is remembered
_MAX_SAID = 20  # mistakes that are printed of one file
_SMALLER = "give the poses in a RAPID program or split the task"
_TAG = "tag:yaml.org,2002:"
_SCALARS = {_TAG + kind for kind in ("null", "bool", "int", "float")}
_TEXTS = {_TAG + kind for kind in ("str", "value", "merge")}  # a lone = or << as a value is text


def read_text(path: str | Path, what: str) -> str:
    """The file's UTF-8 text; what names it in messages. Raises InputError where it cannot be read or is too big."""
    try:
        with open(path, "rb") as file:
            content = file.read(MAX_BYTES + 1)  # no more of it: a device may have no end
            size = max(os.fstat(file.fileno()).st_size, len(content))
    except OSError as error:
        raise InputError(f"cannot read the {what}: {error.strerror}", file=str(path)) from error
    if what in ("cell file", "task file", "robot file", "study file"):
        refuse_other(path, what)
    _check_size(size, str(path), "take a coarser grid" if what == "table" else _SMALLER)
    try:
        return content.decode("utf-8").replace("\r\n", "\n").replace("\r", "\n")
    except UnicodeDecodeError as error:
        raise InputError(f"byte {error.start} is not UTF-8; save the {what} as UTF-8", file=str(path)) from error


def remembered(texts: int) -> Callable[[Reading], Reading]:
    """What a function of a text gives is kept for so many texts: a command asks for the same file several times, and
    YAML takes a millisecond per line. Not for long texts, whose trees would fill the memory."""

    def keeping(read: Reading) -> Reading:
        known = lru_cache(texts)(read)

        @wraps(read)
        def reading(text: str | bytes, *more: str) -> Any:
            return (known if len(text) <= _KEPT else read)(text, *more)

        return cast(Reading, reading)

    return keeping


def parse(text: str, file: str, needed: str) -> tuple[dict[str, Any], dict[str, int]]:
    """A YAML mapping as plain data, and the line of every key by its dotted path ("limits.joint_1", "poses.0").

    file is for messages; needed says what an empty file lacks. Raises InputError for text that is not such a mapping,
    is longer than MAX_BYTES, or holds more than MAX_NODES keys and values.
    """
    _check_size(len(text.encode("utf-8", "replace")), file)
    try:
        content, lines = _parsed(text, needed)
    except InputError as error:
        error.file = file
        raise
    return deepcopy(content), dict(lines)


@remembered(16)
def _parsed(text: str, needed: str) -> tuple[dict[str, Any], dict[str, int]]:
    """The same of any file: copies of one text are read once. Errors do not know the file yet."""
    if text.count(",") > MAX_NODES:  # seen at once; ruamel takes seconds to come this far
        raise _too_many("", 1)
    yaml = YAML(typ="safe", pure=True)
    yaml.Composer = _BoundedComposer
    reader = _Reader("", yaml)
    return reader.section(_tree(yaml, text, "", needed), "", 1), reader.lines


def refuse_empty(content: Mapping[str, Any], lines: Mapping[str, int], file: str) -> None:
    """Raise InputError for every key without a value (null) in what parse gave, at any depth."""
    empty = sorted(_empty(content, ""), key=lambda path: line_of(path, lines))
    if empty:
        text = "is empty; give it a value or remove it"
        raise _all([InputError(f"{path}: {text}", file=file, line=line_of(path, lines)) for path in empty], file)


def validated(
    model: type[Model], content: Any, lines: Mapping[str, int], file: str, wanted: Mapping[str, str]
) -> Model:
    """content as a model. wanted: what to do about a missing key, by its dotted path or by its own name alone.

    Raises InputError, one line per finding in the order of the file, each with file, line and key.
    """
    try:
        return model.model_validate(content)
    except ValidationError as error:
        details = error.errors(include_url=False)
        wrong = {detail["loc"][:n] for detail in details for n in range(len(detail["loc"]))}
        found = [
            _input_error(model, detail, lines, file, wanted)
            for detail in details
            if detail["type"] != "too_short" or detail["loc"] not in wrong  # of entries that are wrong none is counted
        ]
        found.sort(key=lambda one: one.line or 0)
        raise _all(found, file) from error


def line_of(key: str, lines: Mapping[str, int]) -> int:
    """The line of a key by its dotted path, or of its closest parent that has one; 1 for none."""
    parts = key.split(".")
    parents = (".".join(parts[:n]) for n in range(len(parts), 0, -1))
    return next((lines[parent] for parent in parents if parent in lines), 1)


def with_value(text: str, file: str, keys: Sequence[str], value: str) -> str:
    """A YAML text with another value at a key, given by the keys that lead to it, and every other character as it was.

    value: as text for one line. All sections but the last key are there; that key is added where it is missing. Raises
    InputError as parse does.
    """
    node: Node = _tree(YAML(typ="safe", pure=True), text, file, "")
    for i, key in enumerate(keys):
        assert isinstance(node, MappingNode)
        inner = next((value for name, value in node.value if name.value == key), None)
        if inner is None:
            assert i == len(keys) - 1
            return _with_key(text, node, key, value)
        node = inner
    return f"{text[: node.start_mark.index]}{value}{text[_end(node) :]}"


def _with_key(text: str, section: MappingNode, key: str, value: str) -> str:
    """A text with a key more in a section: behind all others of one in braces, else on a line before them."""
    if section.flow_style:
        at = _end(section.value[-1][1]) if section.value else section.end_mark.index - 1
        return f"{text[:at]}{', ' if section.value else ''}{key}: {value}{text[at:]}"
    first = section.value[0][0].start_mark
    return f"{text[: first.index]}{key}: {value}\n{' ' * first.column}{text[first.index :]}"


def _end(node: Node) -> int:
    """Where a node's own text ends; the mark of a section in lines is behind the comments and blanks below it."""
    if isinstance(node, MappingNode) and not node.flow_style and node.value:
        return _end(node.value[-1][1])
    if isinstance(node, SequenceNode) and not node.flow_style and node.value:
        return _end(node.value[-1])
    return int(node.end_mark.index)


def _check_size(size: int, file: str, advice: str = _SMALLER) -> None:
    if size > MAX_BYTES:
        bound = f"more than {MAX_BYTES / 1e6:g} MB"
        raise InputError(f"holds {size / 1e6:.3g} MB of text, {bound}; {advice}", file=file)


def _too_many(file: str, line: int) -> InputError:
    return InputError(
        f"holds more than {MAX_NODES} keys and values, aliases expanded; {_SMALLER}", file=file, line=line
    )


def _too_deep(file: str, line: int | None) -> InputError:
    return InputError(
        f"nests sections and lists deeper than {MAX_DEPTH} levels; no key needs that", file=file, line=line
    )


class _OutOfBounds(YAMLError):
    """The text has more nodes, or deeper ones, than this reader takes."""

    def __init__(self, deep: bool, line: int):
        super().__init__()
        self.deep, self.line = deep, line


class _BoundedComposer(Composer):
    """Stops at the bounds instead of after reading the whole text."""

    def __init__(self, loader: Any = None):
        super().__init__(loader)
        self.warn_double_anchors = False  # a repeated anchor is legal; the warning would go to stderr
        self._nodes = self._level = 0

    def compose_node(self, parent: Any, index: Any) -> Any:
        """Of the base class, counted."""
        self._nodes, self._level = self._nodes + 1, self._level + 1
        if self._nodes > MAX_NODES or self._level > MAX_DEPTH:
            raise _OutOfBounds(self._level > MAX_DEPTH, self.parser.peek_event().start_mark.line + 1)
        node = super().compose_node(parent, index)
        self._level -= 1
        return node


def _tree(yaml: YAML, text: str, file: str, needed: str) -> MappingNode:
    try:
        tree = yaml.compose(text)
    except _OutOfBounds as error:
        raise (_too_deep if error.deep else _too_many)(file, error.line) from error
    except MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        line = mark.line + 1 if mark else None
        parts = [str(error.problem or error.context)]
        if error.context and parts[0].startswith("but "):
            parts.insert(0, f"{error.context},")
        problem = short(" ".join(" ".join(parts).split()))
        raise InputError(f"broken YAML: {problem}{_unit_hint(text, line)}", file=file, line=line) from error
    except YAMLError as error:
        raise InputError(f"broken YAML: {str(error).splitlines()[0]}", file=file) from error
    except (ValueError, OverflowError) as error:  # "\UFFFFFFFF": ruamel hands the number to chr unseen
        raise InputError("broken YAML: an escape after \\ is not a character", file=file) from error
    if not isinstance(tree, MappingNode) or tree.tag != _TAG + "map":
        raise InputError(f"holds no 'key: value' lines; {needed}", file=file, line=1)
    return tree


def _unit_hint(text: str, line: int | None) -> str:
    # `[0, 30] deg` is not YAML: the list ends the value. It is the first thing people try.
    rows = text.splitlines()
    around = rows[line - 1] if line is not None and line <= len(rows) else ""
    return '; a list with a unit goes in quotes, "[0, 30] deg"' if "]" in around and '"' not in around else ""


class _Reader:
    """Turns YAML's nodes into plain data; lines learns the line of every key on the way."""

    def __init__(self, file: str, yaml: YAML):
        self.file, self.lines = file, dict[str, int]()
        self._yaml, self._count = yaml, 0

    def section(self, node: MappingNode, path: str, depth: int) -> dict[str, Any]:
        """A mapping at a dotted path, inside depth - 1 others."""
        out = {}
        for name, (key, value) in self._pairs(node, path, depth).items():
            inner = f"{path}.{name}" if path else name
            if len(inner) > _MAX_PATH:
                self._refuse(key, path[:_MAX_KEY], f"the keys together have more than {_MAX_PATH} characters")
            self.lines[inner] = _line(key)
            out[name] = self._value(value, inner, depth + 1)
        return out

    def _value(self, node: Node, path: str, depth: int) -> Any:
        if isinstance(node, MappingNode) and node.tag == _TAG + "map":
            return self.section(node, path, depth)
        self._tally(node, depth)
        if isinstance(node, SequenceNode) and node.tag == _TAG + "seq":
            for i, item in enumerate(node.value):
                self.lines[f"{path}.{i}"] = _line(item)
            return [self._value(item, f"{path}.{i}", depth + 1) for i, item in enumerate(node.value)]
        if isinstance(node, ScalarNode) and node.tag in _TEXTS:
            return self._text(node, path)
        if isinstance(node, ScalarNode) and node.tag in _SCALARS:
            return self._scalar(node, path)
        if isinstance(node, ScalarNode) and node.tag == _TAG + "timestamp":
            self._refuse(node, path, f"{short(node.value)} is not a number, text, list or section")
        self._refuse(node, path, f"has the tag {short(str(node.tag).replace(_TAG, '!!'))}; remove it")

    def _scalar(self, node: ScalarNode, path: str) -> Any:
        kind = str(node.tag).removeprefix(_TAG)
        if kind == "int" and len(node.value) > _MAX_DIGITS:
            self._refuse(node, path, f"needs a finite number, not one of {len(node.value)} digits")
        if kind in ("int", "float") and "_" in node.value:
            self._refuse(node, path, f"{short(node.value)} has '_' in a number; leave it out, or write text in quotes")
        try:
            return self._yaml.constructor.construct_object(node)
        except (ValueError, KeyError, IndexError):  # a tag of the user's own, `!!int foo`
            self._refuse(node, path, f"{spelled(node.value)} is not of type !!{kind}; remove the tag")

    def _text(self, node: ScalarNode, path: str) -> str:
        text = str(node.value)
        if not text.isascii() and any("\ud800" <= sign <= "\udfff" for sign in text):
            self._refuse(node, path, f"{json.dumps(short(text))} holds half of a character (a surrogate)")
        return text

    def _pairs(self, node: MappingNode, path: str, depth: int) -> dict[str, tuple[Node, Node]]:
        """The nodes of every key and value by name, those that << takes over included."""
        self._tally(node, depth)
        own, taken = dict[str, tuple[Node, Node]](), dict[str, tuple[Node, Node]]()
        for key, value in node.value:
            if key.tag == _TAG + "merge":
                for other in value.value if isinstance(value, SequenceNode) else [value]:
                    if not isinstance(other, MappingNode):
                        self._refuse(key, path, "<< takes over a section or a list of sections")
                    for name, pair in self._pairs(other, path, depth + 1).items():
                        taken.setdefault(name, pair)
                continue
            name = self._name(key, path)
            if name in own:
                raise InputError(f'broken YAML: found duplicate key "{name}"', file=self.file, line=_line(key))
            own[name] = key, value
        return taken | own

    def _name(self, node: Node, path: str) -> str:
        self._tally(node, 1)
        if not isinstance(node, ScalarNode):
            self._refuse(node, path, "a key is a list or a section; keys are text")
        number = bool(path) and node.value[:9].isdecimal() and node.value == str(int(node.value[:9]))  # \ID of a move
        if node.tag not in _TEXTS and not number:
            said = spelled(node.value)
            inner = f"{path}.{said}" if path else said
            raise InputError(f"key {inner} is not text; put it in quotes", file=self.file, line=_line(node))
        name = self._text(node, path)
        if not name.isprintable() or not name.strip() or len(name) > _MAX_KEY:
            said = json.dumps(short(name), ensure_ascii=False)
            self._refuse(node, path, f"key {said} is empty, of more than {_MAX_KEY} characters, or not printable")
        return name

    def _tally(self, node: Node, depth: int) -> None:
        self._count += 1
        if self._count > MAX_NODES:
            raise _too_many(self.file, _line(node))
        if depth > MAX_DEPTH:
            raise _too_deep(self.file, _line(node))

    def _refuse(self, node: Node, path: str, message: str) -> NoReturn:
        raise InputError(f"{path}: {message}" if path else message, file=self.file, line=_line(node))


def _line(node: Node) -> int:
    return int(node.start_mark.line) + 1


def _empty(value: Any, path: str) -> Iterator[str]:
    """The paths of all that is null."""
    if value is None:
        yield path
    elif isinstance(value, Mapping | list):
        for name, inner in value.items() if isinstance(value, Mapping) else enumerate(value):
            yield from _empty(inner, f"{path}.{name}" if path else str(name))


def _input_error(
    model: type[BaseModel], detail: ErrorDetails, lines: Mapping[str, int], file: str, wanted: Mapping[str, str]
) -> InputError:
    key, message = ".".join(str(part) for part in detail["loc"]), in_words(model, detail, wanted)
    bare = ".".join(part for part in detail["loc"] if isinstance(part, str))
    key = bare if key not in lines and bare in lines else key  # one entry, given without a list around it
    return InputError(f"{key}: {message}" if key else message, file=file, line=line_of(key, lines))


def _all(found: list[InputError], file: str) -> InputError:
    """All mistakes as one error; of very many only the first."""
    if len(found) > _MAX_SAID:
        found = [*found[:_MAX_SAID], InputError(f"and {len(found) - _MAX_SAID} more mistakes", file=file)]
    return found[0] if len(found) == 1 else InputErrorGroup(found)
