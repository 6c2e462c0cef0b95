"""Functions about data: sizes, names, types, and parameters that are present."""

from __future__ import annotations

from trajopt_cli.rapid.data.datatypes import BOOL, NUM, STRING, Array, Value
from trajopt_cli.rapid.data.scope import Absent, Place
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.operators import string
from trajopt_cli.rapid.execution.registry import Refused, Topic
from trajopt_cli.rapid.language.syntax import Call, Expression, Name

_TOPIC = Topic(__doc__)


@_TOPIC.function("Dim ArrPar DimNo:int")
def _dim(run: Context, node: Call, array: Expression, index: int) -> Value:
    value = run.evaluate(array)
    if not isinstance(value.type, Array) or not 1 <= index <= value.type.dimensions:
        raise Refused(f"{run.text(array)} has no dimension {index}", error="ERR_ILLDIM")
    data = value.data
    for _ in range(index - 1):
        data = data[0]
    return Value(NUM, float(len(data) if value.type.sizes is None else value.type.sizes[index - 1]))


@_TOPIC.function("Present OptPar")
def _present(run: Context, node: Call, argument: Expression) -> Value:
    if not isinstance(argument, Name):
        raise Refused("Present takes the name of an optional parameter", "OptPar")
    return Value(BOOL, not isinstance(run.find(argument.name), Absent))


_TOPIC.values("IsPers DatObj:place", BOOL)(lambda place: place.storage == "PERS")
_TOPIC.values("IsVar DatObj:place", BOOL)(lambda place: place.storage == "VAR")


@_TOPIC.function("ArgName Parameter")
def _arg_name(run: Context, node: Call, argument: Expression) -> Value:
    """How the caller, or the caller's caller, wrote the argument that a parameter stands for."""
    name = run.argument_name(argument.name) if isinstance(argument, Name) else None
    if name is None:
        raise Refused(f"{run.text(argument)} is not a parameter of the routine", "Parameter", "ERR_ARGNAME")
    return string(run, node, name)


@_TOPIC.values("Type Data:place", STRING)
def _type(place: Place) -> str:
    return place.type.element.name if isinstance(place.type, Array) else place.type.name
