"""Instructions that change variables."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.rapid.data.datatypes import NUM, Value
from trajopt_cli.rapid.execution.arguments import Instruction, bind
from trajopt_cli.rapid.execution.evaluate import locate, number
from trajopt_cli.rapid.language.syntax import ProcedureCall

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Run


def _step(sign: float) -> Instruction:
    def handler(run: Run, node: ProcedureCall) -> None:
        (target,) = bind(run, node, ("Name",)).required
        run.assign(target, Value(NUM, number(run, target) + sign))

    return handler


def _add(run: Run, node: ProcedureCall) -> None:
    target, value = bind(run, node, ("Name", "AddValue")).required
    run.assign(target, Value(NUM, number(run, target) + number(run, value)))


def _clear(run: Run, node: ProcedureCall) -> None:
    (target,) = bind(run, node, ("Name",)).required
    run.assign(target, Value(locate(run, target).type, 0.0))


INSTRUCTIONS: dict[str, Instruction] = {
    "Incr": _step(1.0),
    "Decr": _step(-1.0),
    "Add": _add,
    "Clear": _clear,
}
