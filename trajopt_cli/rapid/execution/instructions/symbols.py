"""Data and modules by name at run time."""

from __future__ import annotations

from pathlib import PurePosixPath

from trajopt_cli.rapid.data.datatypes import STRING, Type, convertible
from trajopt_cli.rapid.data.scope import Place
from trajopt_cli.rapid.execution.arguments import bind
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.instructions.effect import Effect, Topic
from trajopt_cli.rapid.language.syntax import Expression, Name, ProcedureCall

_WHERE = ("Block", "TaskRef", "TaskName")


def _get(run: Context, node: ProcedureCall) -> None:
    """Read the data that a text names."""
    name, target = bind(run, node, ("Object", "Value"), _WHERE).required
    run.assign(target, run.evaluate(_data(run, name, run.locate(target).type)))


def _set(run: Context, node: ProcedureCall) -> None:
    """Change the data that a text names."""
    name, value = bind(run, node, ("Object", "Value"), _WHERE).required
    given = run.evaluate(value)
    target = _data(run, name, given.type)
    place = run.locate(target)
    if place.constant:
        raise run.fault(name, "ERR_SYM_ACCESS", f"'{target.name}' is {place.constant} and cannot be changed")
    run.assign(target, given)


def _data(run: Context, node: Expression, type_: Type) -> Name:
    text = str(run.evaluate(node, STRING).data).strip()
    place = run.find(text)
    if not isinstance(place, Place):
        raise run.fault(node, "ERR_SYM_ACCESS", f"there is no data named '{text}' in the program")
    if not convertible(type_, place.type):
        message = f"'{text}' is a {place.type.name}, and the value a {type_.name}"
        raise run.fault(node, "ERR_SYM_ACCESS", message)
    return Name(node.start, node.end, text)


def _load(run: Context, node: ProcedureCall) -> None:
    """Every module is in memory from the start, so it only has to be among the program's files."""
    start = node.name.lower() == "startload"
    args = bind(run, node, ("FilePath", "LoadNo") if start else ("FilePath",), ("Dynamic", "File", "CheckRef"))
    file = args.value("file") or args.required[0]
    path = str(run.evaluate(file, STRING).data)
    if _stem(path) not in {_stem(name) for name in run.files}:
        message = f"{node.name} wants the module file '{path}'; put it among the program's files"
        raise run.fault(file, "ERR_FILNOTFND", message)


def _stem(path: str) -> str:
    """The file's own name without its ending, in lower case; a controller's path begins with HOME: or the like."""
    return PurePosixPath(path.replace("\\", "/").replace(":", "/")).stem.lower()


INSTRUCTIONS: Topic = {
    Effect.RUN: {"GetDataVal": _get, "SetDataVal": _set},
    Effect.STOPS: {"Load": _load},
    Effect.IGNORED: {"StartLoad": _load},
}
