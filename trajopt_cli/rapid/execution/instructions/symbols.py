"""Data and modules by name at run time."""

from __future__ import annotations

from pathlib import PurePosixPath

from trajopt_cli.rapid.data.datatypes import Type, convertible
from trajopt_cli.rapid.data.scope import Place
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.registry import Effect, Refused, Topic
from trajopt_cli.rapid.language.syntax import Expression, Name, ProcedureCall

_TOPIC = Topic(__doc__)


@_TOPIC.instruction(Effect.RUN, r"GetDataVal Object:string Value \Block \TaskRef \TaskName")
def _get(run: Context, node: ProcedureCall, name: str, target: Expression, **_: bool) -> None:
    """Read the data that a text names."""
    run.assign(target, run.evaluate(_data(run, node, name, run.locate(target).type)))


@_TOPIC.instruction(Effect.RUN, r"SetDataVal Object:string Value \Block \TaskRef \TaskName")
def _set(run: Context, node: ProcedureCall, name: str, value: Expression, **_: bool) -> None:
    """Change the data that a text names."""
    given = run.evaluate(value)
    target = _data(run, node, name, given.type)
    if constant := run.locate(target).constant:
        raise _inaccessible(f"'{target.name}' is {constant} and cannot be changed")
    run.assign(target, given)


def _data(run: Context, node: ProcedureCall, name: str, type_: Type) -> Name:
    name = name.strip()
    place = run.find(name)
    if not isinstance(place, Place):
        raise _inaccessible(f"there is no data named '{name}' in the program")
    if not convertible(type_, place.type):
        raise _inaccessible(f"'{name}' is a {place.type.name}, and the value a {type_.name}")
    return Name(node.start, node.end, name)


def _inaccessible(message: str) -> Refused:
    return Refused(message, "Object", "ERR_SYM_ACCESS")


@_TOPIC.instruction(Effect.STOPS, r"Load FilePath:string \Dynamic \File:string \CheckRef")
@_TOPIC.instruction(Effect.IGNORED, r"StartLoad FilePath:string LoadNo \Dynamic \File:string \CheckRef")
def _load(run: Context, node: ProcedureCall, path: str, *_: Expression, file: str | None = None, **__: bool) -> None:
    """Every module is in memory from the start, so it only has to be among the program's files."""
    if _stem(path if file is None else file) not in {_stem(name) for name in run.files}:
        message = f"{node.name} wants the module file '{file or path}'; put it among the program's files"
        raise Refused(message, "FilePath" if file is None else "File", "ERR_FILNOTFND")


def _stem(path: str) -> str:
    """The file's own name without its ending, in lower case; a controller's path begins with HOME: or the like."""
    return PurePosixPath(path.replace("\\", "/").replace(":", "/")).stem.lower()
