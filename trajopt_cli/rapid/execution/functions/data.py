"""Functions about data: sizes, names, types, and parameters that are present."""

from __future__ import annotations

from trajopt_cli.rapid.data.datatypes import BOOL, NUM, Array, Data, Value
from trajopt_cli.rapid.data.scope import Absent
from trajopt_cli.rapid.execution.arguments import Function, bind
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.operators import string
from trajopt_cli.rapid.language.syntax import Call, Name


def _dim(run: Context, node: Call) -> Value:
    array, which = bind(run, node, ("ArrPar", "DimNo")).required
    value, index = run.evaluate(array), run.integer(which, "DimNo")
    if not isinstance(value.type, Array) or not 1 <= index <= value.type.dimensions:
        raise run.fault(node, "ERR_ILLDIM", f"{run.text(array)} has no dimension {index}")
    if value.type.sizes is not None:
        return Value(NUM, float(value.type.sizes[index - 1]))
    data: Data = value.data
    for _ in range(index - 1):
        data = data[0]
    return Value(NUM, float(len(data)))


def _present(run: Context, node: Call) -> Value:
    (argument,) = bind(run, node, ("OptPar",)).required
    if not isinstance(argument, Name):
        raise run.error(argument, "Present takes the name of an optional parameter")
    return Value(BOOL, not isinstance(run.find(argument.name), Absent))


def _stored_as(storage: str) -> Function:
    def handler(run: Context, node: Call) -> Value:
        (argument,) = bind(run, node, ("DatObj",)).required
        return Value(BOOL, run.locate(argument).storage == storage)

    return handler


def _arg_name(run: Context, node: Call) -> Value:
    """How the caller, or the caller's caller, wrote the argument that a parameter stands for."""
    (argument,) = bind(run, node, ("Parameter",)).required
    name = run.argument_name(argument.name) if isinstance(argument, Name) else None
    if name is None:
        raise run.fault(argument, "ERR_ARGNAME", f"{run.text(argument)} is not a parameter of the routine")
    return string(run, node, name)


def _type(run: Context, node: Call) -> Value:
    (argument,) = bind(run, node, ("Data",)).required
    type_ = run.locate(argument).type
    return string(run, node, type_.element.name if isinstance(type_, Array) else type_.name)


FUNCTIONS: dict[str, Function] = {
    "Dim": _dim,
    "Present": _present,
    "IsPers": _stored_as("PERS"),
    "IsVar": _stored_as("VAR"),
    "ArgName": _arg_name,
    "Type": _type,
}
