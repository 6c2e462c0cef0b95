"""Instructions that change variables."""

from __future__ import annotations

from trajopt_cli.rapid.data.datatypes import DNUM, NUM, Value, is_number
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.registry import Effect, Refused, Topic
from trajopt_cli.rapid.language.syntax import Expression, ProcedureCall

_TOPIC = Topic(__doc__)


@_TOPIC.instruction(Effect.RUN, "Incr Name", "Decr Name", "Add Name AddValue", "Clear Name")
def _change(run: Context, node: ProcedureCall, target: Expression, added: Expression | None = None) -> None:
    place, name = run.locate(target), node.name.lower()
    if not is_number(place.type):
        raise Refused(f"needs a num or a dnum, found {place.type.name}", "Name")
    step = {"incr": 1.0, "decr": -1.0, "clear": -place.value.data}.get(name, 0.0)
    if added is not None:
        step = run.evaluate(added, DNUM if place.type is DNUM else NUM).data
    run.store(place, target, Value(place.type, place.value.data + step))


@_TOPIC.instruction(Effect.RUN, "BitSet BitData BitPos:int", "BitClear BitData BitPos:int")
def _bit(run: Context, node: ProcedureCall, target: Expression, position: int) -> None:
    """Set or clear a bit of a byte (of a dnum: of its 52 bits); the lowest is 1."""
    place = run.locate(target)
    if not is_number(place.type):
        raise Refused(f"needs a num or a dnum, found {place.type.name}", "BitData")
    bits, value = 52 if place.type is DNUM else 8, run.integer(target, "BitData")
    if not 0 <= value < 2**bits:
        raise Refused(f"BitData is {value}, and must lie in 0..{2**bits - 1}", "BitData", "ERR_ARGVALERR")
    if not 1 <= position <= bits:
        raise Refused(f"BitPos {position} lies outside 1..{bits}", "BitPos", "ERR_ARGVALERR")
    mask = 1 << (position - 1)
    run.store(place, target, Value(place.type, float(value | mask if node.name.lower() == "bitset" else value & ~mask)))
