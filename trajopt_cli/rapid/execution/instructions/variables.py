"""Instructions that change variables."""

from __future__ import annotations

from trajopt_cli.rapid.data.datatypes import DNUM, NUM, Value, is_number
from trajopt_cli.rapid.data.scope import Place
from trajopt_cli.rapid.execution.arguments import bind
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.instructions.effect import Effect, Handler, Topic
from trajopt_cli.rapid.language.syntax import Expression, ProcedureCall


def _number(run: Context, target: Expression) -> Place:
    place = run.locate(target)
    if not is_number(place.type):
        raise run.error(target, f"needs a num or a dnum, found {place.type.name}")
    return place


def _step(sign: float) -> Handler:
    def handler(run: Context, node: ProcedureCall) -> None:
        (target,) = bind(run, node, ("Name",)).required
        place = _number(run, target)
        run.store(place, target, Value(place.type, place.value.data + sign))

    return handler


def _add(run: Context, node: ProcedureCall) -> None:
    target, added = bind(run, node, ("Name", "AddValue")).required
    place = _number(run, target)
    value = run.evaluate(added, DNUM if place.type is DNUM else NUM)
    run.store(place, target, Value(place.type, place.value.data + value.data))


def _clear(run: Context, node: ProcedureCall) -> None:
    (target,) = bind(run, node, ("Name",)).required
    place = _number(run, target)
    run.store(place, target, Value(place.type, 0.0))


def _bit(on: bool) -> Handler:
    """Set or clear a bit of a byte (of a dnum: of its 52 bits); the lowest is 1."""

    def handler(run: Context, node: ProcedureCall) -> None:
        target, where = bind(run, node, ("BitData", "BitPos")).required
        place = _number(run, target)
        bits = 52 if place.type is DNUM else 8
        value, position = run.integer(target, "BitData"), run.integer(where, "BitPos")
        if not 0 <= value < 2**bits:
            raise run.fault(target, "ERR_ARGVALERR", f"BitData is {value}, and must lie in 0..{2**bits - 1}")
        if not 1 <= position <= bits:
            raise run.fault(where, "ERR_ARGVALERR", f"BitPos {position} lies outside 1..{bits}")
        mask = 1 << (position - 1)
        run.store(place, target, Value(place.type, float(value | mask if on else value & ~mask)))

    return handler


INSTRUCTIONS: Topic = {
    Effect.RUN: {
        "Incr": _step(1.0),
        "Decr": _step(-1.0),
        "Add": _add,
        "Clear": _clear,
        "BitSet": _bit(True),
        "BitClear": _bit(False),
    }
}
