"""Data and modules by name at run time."""

from __future__ import annotations

from pathlib import PurePosixPath
from typing import TYPE_CHECKING

from trajopt_cli.rapid.data.datatypes import STRING, Type
from trajopt_cli.rapid.data.scope import Place
from trajopt_cli.rapid.execution.arguments import Instruction, bind
from trajopt_cli.rapid.execution.evaluate import convertible, evaluate, locate
from trajopt_cli.rapid.execution.instructions.effect import Effect
from trajopt_cli.rapid.language.syntax import Expression, Name, ProcedureCall

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Execution

_WHERE = ("Block", "TaskRef", "TaskName")


def _get(run: Execution, node: ProcedureCall) -> None:
    """Read the data that a text names."""
    name, target = bind(run, node, ("Object", "Value"), _WHERE).required
    run.assign(target, evaluate(run, _data(run, name, locate(run, target).type)))


def _set(run: Execution, node: ProcedureCall) -> None:
    """Change the data that a text names."""
    name, value = bind(run, node, ("Object", "Value"), _WHERE).required
    given = evaluate(run, value)
    target = _data(run, name, given.type)
    place = locate(run, target)
    if place.constant:
        raise run.fault(name, "ERR_SYM_ACCESS", f"'{target.name}' is {place.constant} and cannot be changed")
    run.assign(target, given)


def _data(run: Execution, node: Expression, type_: Type) -> Name:
    text = str(evaluate(run, node, STRING).data).strip()
    place = run.find(text)
    if not isinstance(place, Place):
        raise run.fault(node, "ERR_SYM_ACCESS", f"there is no data named '{text}' in the program")
    if not convertible(type_, place.type):
        message = f"'{text}' is a {place.type.name}, and the value a {type_.name}"
        raise run.fault(node, "ERR_SYM_ACCESS", message)
    return Name(node.start, node.end, text)


def _load(run: Execution, node: ProcedureCall) -> None:
    """Every module is in memory from the start, so it only has to be among the program's files."""
    start = node.name.lower() == "startload"
    args = bind(run, node, ("FilePath", "LoadNo") if start else ("FilePath",), ("Dynamic", "File", "CheckRef"))
    file = args.value("file") or args.required[0]
    path = str(evaluate(run, file, STRING).data)
    if _stem(path) not in {_stem(name) for name in run.files}:
        message = f"{node.name} wants the module file '{path}'; put it among the program's files"
        raise run.fault(file, "ERR_FILNOTFND", message)


def _unload(run: Execution, node: ProcedureCall) -> None:
    """The module stays: a program that does not use it any more does not notice."""
    bind(run, node, ("FilePath",), ("ErrIfChanged", "Save", "File"))


def _wait_load(run: Execution, node: ProcedureCall) -> None:
    bind(run, node, ("LoadNo",), ("UnloadPath", "UnloadFile", "CheckRef"))


def _stem(path: str) -> str:
    """The file's own name without its ending, in lower case; a controller's path begins with HOME: or the like."""
    return PurePosixPath(path.replace("\\", "/").replace(":", "/")).stem.lower()


INSTRUCTIONS: dict[str, Instruction] = {
    "GetDataVal": _get,
    "SetDataVal": _set,
    "Load": _load,
    "StartLoad": _load,
    "WaitLoad": _wait_load,
    "UnLoad": _unload,
}
EFFECTS = {
    "Load": Effect.STOPS,
    "StartLoad": Effect.IGNORED,
    "WaitLoad": Effect.STOPS,
    "UnLoad": Effect.IGNORED,
}
