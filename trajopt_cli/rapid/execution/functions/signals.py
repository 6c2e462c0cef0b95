"""Functions that read signals."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.rapid.data.datatypes import BOOL, NUM, Value
from trajopt_cli.rapid.execution.arguments import Function, bind
from trajopt_cli.rapid.execution.evaluate import number
from trajopt_cli.rapid.language.syntax import Call

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Run


def _signal_value(run: Run, node: Call) -> float:
    (argument,) = bind(run, node, ("Signal",)).required
    run.signal(argument)
    return number(run, argument)


def _test_di(run: Run, node: Call) -> Value:
    return Value(BOOL, _signal_value(run, node) == 1.0)


def _signal(run: Run, node: Call) -> Value:
    return Value(NUM, _signal_value(run, node))


FUNCTIONS: dict[str, Function] = {
    "TestDI": _test_di,
    "DInput": _signal,
    "DOutput": _signal,
    "GInput": _signal,
    "GOutput": _signal,
    "AInput": _signal,
    "AOutput": _signal,
}
