"""Functions that read signals. Inputs lack where the scenario says nothing, outputs begin at 0."""

from __future__ import annotations

from trajopt_cli.rapid.data.datatypes import BOOL, DNUM, NUM, Type, Value
from trajopt_cli.rapid.execution.arguments import Function, bind
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.language.syntax import Call


def _input(run: Context, node: Call) -> float:
    (argument,) = bind(run, node, ("Signal",)).required
    signal, written = run.signal(argument), run.text(argument)
    return run.read_signal(argument, written if written.lower() == signal else signal)


def _digital(run: Context, node: Call) -> float:
    (argument,) = bind(run, node, ("Signal",)).required
    run.check_digital(argument, run.signal(argument))
    return _input(run, node)


def _test_di(run: Context, node: Call) -> Value:
    return Value(BOOL, _digital(run, node) == 1.0)


def _reads(type_: Type) -> Function:
    return lambda run, node: Value(type_, _input(run, node))


def _tells(type_: Type) -> Function:
    """The state of an output."""

    def handler(run: Context, node: Call) -> Value:
        (argument,) = bind(run, node, ("Signal",)).required
        run.settle_stop()
        return Value(type_, run.external.output(run.signal(argument)))

    return handler


def _valid(run: Context, node: Call) -> Value:
    """Every signal works, inputs and outputs alike."""
    bind(run, node, ("Signal",))
    return Value(BOOL, True)


FUNCTIONS: dict[str, Function] = {
    "TestDI": _test_di,
    "DInput": lambda run, node: Value(NUM, _digital(run, node)),
    "GInput": _reads(NUM),
    "GInputDnum": _reads(DNUM),
    "AInput": _reads(NUM),
    "DOutput": _tells(NUM),
    "GOutput": _tells(NUM),
    "GOutputDnum": _tells(DNUM),
    "AOutput": _tells(NUM),
    "ValidIO": _valid,
}
