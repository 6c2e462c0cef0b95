"""The parts of the manual that are made from the code.

`python docs/generated.py` writes them anew between <!-- generated: NAME --> and <!-- end -->, so that a checkout has
them, too; <!-- generated: NAME at build --> stands where the manual's build puts one.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator
from importlib.resources import files
from pathlib import Path
from typing import Any

_PART = re.compile(r"(<!-- generated: ([a-z-]+) -->\n).*?(<!-- end -->)", re.DOTALL)


def filled(text: str) -> str:
    """A page with the parts that a build puts there. Raises KeyError for a part that nobody makes."""
    return re.sub(r"<!-- generated: ([a-z-]+) at build -->", lambda match: PARTS[match[1]](), text)


def rewritten(text: str) -> str:
    """A page with the parts that it holds made anew. Raises KeyError for a part that nobody makes."""
    return _PART.sub(lambda match: f"{match[1]}\n{PARTS[match[2]]()}\n{match[3]}", text)


def pages() -> dict[Path, str]:
    """Every page of the manual and what it ought to hold."""
    return {path: rewritten(path.read_text("utf-8")) for path in sorted(Path(__file__).parent.glob("*.md"))}


def with_subscripts(text: str) -> str:
    """Formulas with T_k and d_{k+1} set lower, outside of code."""
    parts = re.split(r"(`[^`]*`)", text)
    lower = re.compile(r"(?<!\w)([^\W\d_][\u0300-\u036f]?)_(\{[^}]+\}|[A-Za-z0-9]+)")
    parts[::2] = [lower.sub(lambda m: f"{m[1]}<sub>{m[2].strip('{}')}</sub>", part) for part in parts[::2]]
    return "".join(parts)


def commands() -> str:
    """Every command with its own help, in the order of `trajopt --help`."""
    from typer.main import get_command

    from trajopt_cli.cli import app

    os.environ["COLUMNS"] = "92"  # of the help's lines
    parts = []
    for words, command in _tree((), get_command(app)):
        name = " ".join(["trajopt", *words])
        with command.make_context(name, [], resilient_parsing=True) as context:
            parts.append(f"## {name}\n\n```text\n{command.get_help(context)}\n```\n")
    return "\n".join(parts)


def _tree(words: tuple[str, ...], command: Any) -> Iterator[tuple[tuple[str, ...], Any]]:
    inner = getattr(command, "commands", None)
    if inner is None or not words:
        yield words, command
    for name, one in (inner or {}).items():
        yield from _tree((*words, name), one)


# What a plan makes of the instructions of a topic and effect; `parse` counts those that are ignored.
_PLANNED = {
    ("MoveJ, MoveL, MoveC, MoveAbsJ and MoveExtJ", "planned"): "lines, arcs and joint moves",
    ("Moves on whose way something happens", "planned"): "the moves they make; what is triggered takes no time",
    ("SearchJ, SearchL and SearchC", "planned"): "moves to where the cell file says that they hit (`searches`)",
    ("Welding, spot welding, painting, dispensing", "planned"): "the plain moves they make",
    ("Program displacement (PDisp) and offsets of external axes (EOffs)", "run"): "worked into every target",
    ("Waits", "waits"): "the tool rests",
    ("Outputs set, and signals under another name", "run"): "an output takes no time",
    ("Settings that change how the robot moves", "run"): "in force for the moves behind them",
    ("Mechanical units", "waits"): "in force for the moves behind them",
    ("Mechanical units", "refused"): "something moves by itself",
    ("What the operator is asked on the pendant", "stops a corner"): "the cell file's `answers`",
    ("Sockets and cameras", "stops a corner"): "received: the cell file's `answers`",
    ("Files, serial channels, raw bytes and configuration", "run"): "read: the cell file's `answers`",
    ("Data and modules by name at run time", "run"): "data by its name; modules from the program's folder",
}


def instructions() -> str:
    """Every instruction that is read, by topic and effect."""
    from trajopt_cli.rapid.execution.arguments import Effect
    from trajopt_cli.rapid.execution.table import INSTRUCTIONS

    out = "| instructions | by name | effect | in a plan |\n|---|---|---|---|\n"
    for topic in sorted({one.topic for one in INSTRUCTIONS.values()}):
        for effect in Effect:
            names = [one.name for one in INSTRUCTIONS.values() if (one.topic, one.effect) == (topic, effect)]
            if names:
                planned = _PLANNED.get((topic, effect.value), "")
                out += f"| {topic} | {_names(sorted(names))} | {effect.value} | {planned} |\n"
    return out


def functions() -> str:
    """Every function that is read, by topic."""
    from trajopt_cli.rapid.execution.table import FUNCTIONS

    out = "| functions | by name |\n|---|---|\n"
    for topic in dict.fromkeys(one.topic for one in FUNCTIONS.values()):
        out += f"| {topic} | {_names(sorted(one.name for one in FUNCTIONS.values() if one.topic == topic))} |\n"
    return out


def _names(names: list[str]) -> str:
    return " ".join(f"`{name}`" for name in names)


def cell_key_table() -> str:
    """What the keys of a cell file mean, one by one."""
    return files("trajopt_cli.cell").joinpath("keys.md").read_text("utf-8")


def task_key_table() -> str:
    """What the keys of a task file mean, one by one."""
    return files("trajopt_cli.iiwa.task").joinpath("keys.md").read_text("utf-8")


def cell_keys() -> str:
    """Every key of a cell file with all that it may hold."""
    from trajopt_cli.cell.schema import cell_schema

    return _keys(cell_schema())


def task_keys() -> str:
    """Every key of a task file with all that it may hold."""
    from trajopt_cli.iiwa.task.document import task_schema

    return _keys(task_schema())


def robot_keys() -> str:
    """Every key of the file of a six-axis robot."""
    from trajopt_cli.robot.catalogue import robot_schema

    schema = robot_schema()
    return _keys(schema | schema["$defs"]["SixAxisFile"])


def _keys(schema: dict[str, Any]) -> str:
    rows = "".join(f"| `{path}` | {takes} | {default} |\n" for path, takes, default in _rows(schema, schema, ""))
    return f"| key | takes | default |\n|---|---|---|\n{rows}"


def _rows(schema: dict[str, Any], node: dict[str, Any], path: str) -> Iterator[tuple[str, str, str]]:
    inside = dict(node.get("properties", {}))
    if isinstance(others := node.get("additionalProperties"), dict):
        inside["NAME"] = others
    for name, one in inside.items():
        here = f"{path}.{name}" if path else name
        kinds, sections = _taken(schema, one)
        if kinds:
            default = "required" if name in node.get("required", []) else _default(one.get("default"))
            yield here, " or ".join(dict.fromkeys(kinds)), default
        for key, section in sections:
            yield from _rows(schema, section, f"{here}{key}")


def _default(value: object) -> str:
    """As YAML writes it; nothing for what is empty or has keys of its own."""
    match value:
        case bool():
            return f"`{str(value).lower()}`"
        case float():
            return f"`{value:g}`"
        case int() | str():
            return f"`{value}`"
    return ""


Taken = tuple[list[str], list[tuple[str, dict[str, Any]]]]


def _taken(schema: dict[str, Any], node: dict[str, Any]) -> Taken:
    """What a key may hold, in words, and the sections among it, each with what is put behind the key's name."""
    if "$ref" in node:
        node = schema["$defs"][node["$ref"].rsplit("/", 1)[1]]
    if choices := node.get("anyOf", node.get("oneOf")):
        found = [_taken(schema, one) for one in choices]
        return [word for words, _ in found for word in words], [part for _, parts in found for part in parts]
    if "enum" in node or "const" in node:
        return [f"`{value}`" for value in node.get("enum", [node.get("const")])], []
    match node["type"]:
        case "object" if "properties" in node:
            return ["section"], [("", node)]
        case "object":
            return ["section of names"], [("", {"additionalProperties": node["additionalProperties"]})]
        case "array":
            return _list(schema, node)
        case "string":
            return _text(node.get("pattern")), []
        case "null":
            return [], []
        case list() as kinds:
            return [_KINDS[kind] for kind in kinds], []
        case kind:
            return [_KINDS[kind]], []


def _list(schema: dict[str, Any], node: dict[str, Any]) -> Taken:
    length = node.get("minItems")
    words = f"list of {length}" if length and node.get("maxItems", length) == length else "list"
    kinds, sections = _taken(schema, {"anyOf": node.get("prefixItems") or [node["items"]]})
    items_in_words = "" if sections else f": {' or '.join(dict.fromkeys(kinds))}"
    return [words + items_in_words], [(f"[]{key}", section) for key, section in sections]


def _text(pattern: str | None) -> list[str]:
    """A number with its unit as text. Of a list as text and of a word with capitals nothing: told elsewhere."""
    if pattern is None:
        return ["text"]
    units = re.search(r"\(([^()]*)\)\\s\*\$$", pattern)
    if units is None:
        return [] if pattern.startswith("^") else ["text"]
    names = [f"`{unit}`" for unit in units[1].split("|") if unit and not re.search(r"\^|[²³]", unit)]
    return [f"text with {', '.join(names)}"] if names and not pattern.startswith(r"^\s*\[") else []


_KINDS = {"number": "number", "integer": "whole number", "boolean": "true or false", "string": "text"}

PARTS: dict[str, Callable[[], str]] = {
    "commands": commands,
    "instructions": instructions,
    "functions": functions,
    "cell-key-table": cell_key_table,
    "task-key-table": task_key_table,
    "cell-keys": cell_keys,
    "task-keys": task_keys,
    "robot-keys": robot_keys,
}

if __name__ == "__main__":
    for _path, _text in pages().items():
        _path.write_text(_text, "utf-8")
