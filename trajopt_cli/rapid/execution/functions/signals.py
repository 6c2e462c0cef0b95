"""Functions that read signals. Inputs lack where the scenario says nothing, outputs begin at 0."""

from __future__ import annotations

from trajopt_cli.rapid.data.datatypes import BOOL, DNUM, NUM, Type, Value
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.registry import Topic
from trajopt_cli.rapid.language.syntax import Call, Expression

_TOPIC = Topic(__doc__)


@_TOPIC.function("AInput Signal", "GInput Signal", "GInputDnum Signal")
def _input(run: Context, node: Call, argument: Expression) -> Value:
    signal, written = run.signal(argument), run.text(argument)
    value = run.read_signal(argument, written if written.lower() == signal else signal)
    return Value(_type_of(node), value)


@_TOPIC.function("TestDI Signal", "DInput Signal")
def _digital(run: Context, node: Call, argument: Expression) -> Value:
    run.check_digital(argument, run.signal(argument))
    value = _input(run, node, argument)
    return Value(BOOL, value.data == 1.0) if node.name.lower() == "testdi" else value


@_TOPIC.function("DOutput Signal:signal", "GOutput Signal:signal", "GOutputDnum Signal:signal", "AOutput Signal:signal")
def _output(run: Context, node: Call, signal: str) -> Value:
    """The state of an output."""
    run.settle_stop()
    return Value(_type_of(node), run.external.output(signal))


def _type_of(node: Call) -> Type:
    return DNUM if node.name.lower().endswith("dnum") else NUM


_TOPIC.values("ValidIO Signal", BOOL)(lambda _: True)  # every signal works, inputs and outputs alike
