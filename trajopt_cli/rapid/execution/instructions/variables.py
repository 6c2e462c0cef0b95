"""Instructions that change variables."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.rapid.data.datatypes import DNUM, NUM, Value, is_number
from trajopt_cli.rapid.data.scope import Place
from trajopt_cli.rapid.execution.arguments import Instruction, bind
from trajopt_cli.rapid.execution.evaluate import evaluate, locate
from trajopt_cli.rapid.language.syntax import Expression, ProcedureCall

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Run


def _number(run: Run, target: Expression) -> Place:
    place = locate(run, target)
    if not is_number(place.type):
        raise run.error(target, f"needs a num or a dnum, found {place.type.name}")
    return place


def _step(sign: float) -> Instruction:
    def handler(run: Run, node: ProcedureCall) -> None:
        (target,) = bind(run, node, ("Name",)).required
        place = _number(run, target)
        run.store(place, target, Value(place.type, place.value.data + sign))

    return handler


def _add(run: Run, node: ProcedureCall) -> None:
    target, added = bind(run, node, ("Name", "AddValue")).required
    place = _number(run, target)
    value = evaluate(run, added, DNUM if place.type is DNUM else NUM)
    run.store(place, target, Value(place.type, place.value.data + value.data))


def _clear(run: Run, node: ProcedureCall) -> None:
    (target,) = bind(run, node, ("Name",)).required
    place = _number(run, target)
    run.store(place, target, Value(place.type, 0.0))


INSTRUCTIONS: dict[str, Instruction] = {
    "Incr": _step(1.0),
    "Decr": _step(-1.0),
    "Add": _add,
    "Clear": _clear,
}
