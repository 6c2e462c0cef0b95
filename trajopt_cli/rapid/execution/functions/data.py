"""Functions about data: sizes, parameters that are present."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.rapid.data.datatypes import BOOL, NUM, Array, Data, Value
from trajopt_cli.rapid.data.scope import Absent
from trajopt_cli.rapid.execution.arguments import Function, bind
from trajopt_cli.rapid.execution.evaluate import evaluate, integer
from trajopt_cli.rapid.language.syntax import Call, Name

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Run


def _dim(run: Run, node: Call) -> Value:
    array, which = bind(run, node, ("ArrPar", "DimNo")).required
    value, index = evaluate(run, array), integer(run, which, "DimNo")
    if not isinstance(value.type, Array) or not 1 <= index <= value.type.dimensions:
        raise run.error(node, f"{run.text(array)} has no dimension {index}")
    data: Data = value.data
    for _ in range(index - 1):
        assert isinstance(data, tuple)
        data = data[0]
    assert isinstance(data, tuple)
    return Value(NUM, float(len(data)))


def _present(run: Run, node: Call) -> Value:
    (argument,) = bind(run, node, ("OptPar",)).required
    if not isinstance(argument, Name):
        raise run.error(argument, "Present takes the name of an optional parameter")
    return Value(BOOL, not isinstance(run.find(argument.name), Absent))


FUNCTIONS: dict[str, Function] = {
    "Dim": _dim,
    "Present": _present,
}
