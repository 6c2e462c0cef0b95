"""Data that the cell file gives (`data`): what the program does not declare, and what somebody outside writes.

A reading gives what the program assigned last, or a wait made sure of; else the cell file's value, of a sequence the
next one, the last one staying. A wait for a condition that does not hold lets the outside write: of a sequence it takes
the first value left that fits, which stays until the program assigns another or a later wait needs one.

A name that nothing declares stands for a signal where a number is asked for (external.py). Elsewhere it is missing
data: a value to begin with stands in, so that one run finds everything that is missing.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from math import prod

from trajopt_cli.errors import InputError
from trajopt_cli.rapid.data import datatypes
from trajopt_cli.rapid.data.datatypes import NUM, TYPES, Array, Data, Record, Type, Value, is_opaque
from trajopt_cli.rapid.data.scope import Datum, ExternalDatum, Place
from trajopt_cli.rapid.execution.answers import root, shown_value, stand_in, typed
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.types import find_type
from trajopt_cli.rapid.language.syntax import Component, Element, Expression, Name, Node
from trajopt_cli.scenario import Answer

_ELEMENTS = 1000  # of an array that stands in; each growth writes all of them anew


def _read(run: Context, node: Node, datum: ExternalDatum) -> None:
    """Read all that the cell file gives as values of its type. Raises InputError, placed at node."""
    run.external.asked("data", datum.name)
    for answer in run.external.left("data", datum.name):
        run.external.typed(datum, answer, typed(run, node, datum.name, datum.type, answer, "value", "of"))


def declared(run: Context, node: Node, name: str, datum: Datum) -> ExternalDatum:
    """What takes the place of declared data. Raises InputError for a constant, and for values of another type."""
    key = name.lower()
    if datum.constant:
        message = f"{name} is a CONST, and data.{name} in the cell file gives it another value; change it here"
        raise run.error(node, message)
    datum = ExternalDatum(key, run.external.reading, datum.type)
    datum.storage = datum.storage
    _read(run, node, datum)
    return datum


def settle(
    run: Context, datum: ExternalDatum, node: Node, wanted: Type | None = None, part: str = "", depth: int = 0
) -> None:
    """Let data that nothing declares have a type, from the place that asks first.

    wanted: the type asked for, of the element where depth indices are given. part: the component that is read.
    """
    if datum.typed:
        return
    name = datum.name
    sample = run.external.left("data", name)[0]
    types = _types(run, run.external.spelled[name], sample, wanted, part, depth)
    if len(types) == 1 and (not types[0].known or is_opaque(types[0])):
        message = f"data.{name} in the cell file is of type {types[0].name}, whose values mean nothing here"
        raise run.error(node, message)
    for type_ in types:
        try:
            datum.type = typed(run, node, name, type_, sample, "value", "of").type
            return _read(run, node, datum)
        except InputError:
            if len(types) == 1:
                raise
    example = f"data: {{{name}: {{type: {'num' if depth else 'robtarget'}, value: ...}}}}"
    raise run.error(node, f"the value of '{name}' in the cell file does not tell its type; say it, '{example}'")


def _types(run: Context, spelled: str | None, sample: Answer, wanted: Type | None, part: str, depth: int) -> list[Type]:
    """What data may be, the likeliest first."""
    if spelled is not None:
        type_ = find_type(run, spelled)
        return [Array(type_, None, depth) if depth and not isinstance(type_, Array) else type_]
    records = [type_ for type_ in TYPES.values() if isinstance(type_, Record)]
    if part:
        return _with(run, part)
    if depth:
        elements: list[Type] = [wanted] if wanted else [NUM, datatypes.BOOL, datatypes.STRING, *records]
        return [Array(type_, None, depth) for type_ in elements]
    if wanted is not None:
        return [wanted]
    if isinstance(sample, str):
        return [Array(NUM, None, 1)] if sample.lstrip().startswith("[") else [datatypes.STRING]
    return [datatypes.BOOL if isinstance(sample, bool) else NUM]


def _with(run: Context, part: str, wanted: Type | None = None) -> list[Type]:
    """The records that have a component of a name and of a type, robtargets first."""
    names = (*run.frame.scope.types, *run.shared.types)
    types = [TYPES["robtarget"], *TYPES.values(), *(find_type(run, name) for name in names)]
    return [
        type_
        for type_ in types
        if isinstance(type_, Record)
        and any(name == part and datatypes.convertible(wanted or of, of) for name, of in type_.components)
    ]


def unknown(run: Context, node: Name, wanted: Type) -> Value:
    """The stand-in for a name that nothing declares, where a type is asked for. Raises Undeclared for one without
    values."""
    if is_opaque(wanted):
        raise run.undeclared(node, f"{wanted.name} ")
    if isinstance(wanted, Array):
        return _array(run, node, wanted.element, (1,) * wanted.dimensions).value
    return _stand_in(run, node, wanted, f"{wanted.name} ").value


def assigned(run: Context, node: Name, type_: Type) -> Place:
    """The stand-in for a name that nothing declares and the program assigns to."""
    if is_opaque(type_):
        raise run.undeclared(node)
    return _stand_in(run, node, type_)


def whole(run: Context, base: Name, node: Component | Element, wanted: Type | None = None) -> Place:
    """What a component or an element is read from that nothing declares: a record that has it, or an array."""
    if isinstance(node, Component):
        types = _with(run, node.name.lower(), wanted)
        if not types:
            raise run.undeclared(base)
        return _stand_in(run, base, types[0], spelled=types[0].name)
    element = NUM if wanted is None or is_opaque(wanted) else wanted
    return _array(run, base, element, tuple(max(run.integer(one, "an index"), 1) for one in node.indices))


def size(run: Context, node: Name, array: str, count: int) -> None:
    """Let a name that nothing declares stand in for the size of an array. count: one that fits."""
    _stand_in(run, node, NUM, f"the size of array {array}, ", float(count))


def _array(run: Context, base: Name, element: Type, sizes: tuple[int, ...]) -> Place:
    before = run.external.data.get(base.name.lower())
    data: Data = ()
    if before is not None and isinstance(before.type, Array) and before.type.sizes:
        element, data = before.type.element, before.value.data
        sizes = tuple(max(pair) for pair in zip(before.type.sizes, sizes, strict=False))
        if sizes == before.type.sizes:
            return before
    if prod(sizes) > _ELEMENTS:
        raise run.undeclared(base, f"array of more than {_ELEMENTS} elements ")
    type_ = Array(element, sizes, len(sizes))
    place = _stand_in(run, base, type_, "array of unknown size ", _grown(data, type_))
    if not run.external.trying:
        run.external.grows.add(base.name.lower())
    return place


def _as_named(type_: Type, name: str) -> Data:
    """The speed or zone that a name like v55 or z25 tells, filled in as the predefined ones are; None for others."""
    if not (match := re.fullmatch(r"[vz](\d{1,5})", name)):
        return None
    size = float(match[1])
    if type_ == datatypes.SPEEDDATA and name[0] == "v":
        return (size, 500.0, 5000.0, 1000.0)
    if type_ == datatypes.ZONEDATA and name[0] == "z":
        turn = round(0.15 * size, 3)
        return (False, size, 1.5 * size, 1.5 * size, turn, 1.5 * size, turn)
    return None


def _stand_in(
    run: Context, node: Name, type_: Type, what: str = "", data: Data = None, spelled: str | None = None
) -> Place:
    """Note that data is missing, and let a value to begin with stand in. A trial (External.trying) leaves no trace.

    what: see Context.undeclared.
    """
    external, key = run.external, node.name.lower()
    if data is None:
        fitting = external.fitting.get(key)
        data = fitting if fitting is not None and _like(type_, fitting) else _as_named(type_, key) or stand_in(type_)
    value = Value(type_, data)
    if external.trying:
        return Datum(type_, value)
    shown = shown_value(run, node, node.name, value)
    shown = f"{{type: {spelled}, value: {shown}}}" if spelled else shown
    known = external.missing.get(("data", key))  # by now as another type, or smaller
    found = run.undeclared(node, what, known)
    run.missing("data", node.name, node, found.reason, shown, again=True, close=lambda: found.close)
    datum = run.external.data[key] = ExternalDatum(key, run.external.reading, type_)
    datum.value = value
    return datum


def awaited(run: Context, datum: Sequence[ExternalDatum], holds: Callable[[], bool]) -> bool:
    """Let the outside write data until a condition holds; the values that make it so stay. False: nothing does.

    datum: the data that the condition reads.
    """
    before = [one.assigned for one in datum]
    for tries in _together([_tries(run, one) for one in datum]):
        for one, (value, _) in zip(datum, tries, strict=True):
            one.assigned = value
        if holds():
            for one, (_, taken) in zip(datum, tries, strict=True):
                run.external.take("data", one.name, taken)
            return True
    for one, old in zip(datum, before, strict=True):
        one.assigned = old
    return False


def _tries(run: Context, datum: ExternalDatum) -> list[tuple[Value, int]]:
    """The values that data may have in a wait, as it stands first, and how many of its sequence each takes."""
    now = [] if datum.assigned is None else [(datum.assigned, 0)]
    left = run.external.left("data", datum.name) if run.external.gives(datum.name) else ()
    return [*now, *((run.external.value(datum, answer), i + 1) for i, answer in enumerate(left))]


def ask(
    run: Context,
    node: Node,
    parts: Sequence[Expression],
    unknown: Sequence[Name],
    values: Sequence[Data],
    shown: str,
    holds: Callable[[], bool],
) -> None:
    """Ask for the first of the data that a wait reads which alone can let it come true, and let it have the value.

    parts: that data. unknown: names that nothing declares; they are asked for when something else reads them, with
    the value that fits here. values: to try. Where none helps, the wait is taken to come true all the same.
    """
    for part in parts:
        place = run.locate(part)
        before = place.value
        for data in values:
            if not _like(place.type, data):
                continue
            place.value = Value(place.type, data)
            if holds():
                name = root(run, part)
                whole = run.locate(Name(part.start, part.end, name)).value
                reason = f"waits for {shown}, and nothing in the program makes it true"
                text = shown_value(run, node, name, whole)
                run.missing("data", name, node, reason, text, declared=True)
                return
        place.value = before
    for name_node in unknown:
        key = name_node.name.lower()
        for data in values:
            datum = run.external.data[key] = ExternalDatum(key, run.external.reading, _type_of(data))
            datum.value = Value(datum.type, data)
            true = _tried(holds)
            del run.external.data[key]
            if true:
                run.external.fitting[key] = data
                return


def _tried(holds: Callable[[], bool]) -> bool:
    """Whether a condition holds; a value of another type than it needs does not make it so."""
    try:
        return holds()
    except InputError:
        return False


def _type_of(data: Data) -> Type:
    return datatypes.STRING if isinstance(data, str) else datatypes.BOOL if isinstance(data, bool) else NUM


def _together(columns: list[list[tuple[Value, int]]]) -> Iterator[list[tuple[Value, int]]]:
    """The columns row by row, the last of a shorter one staying."""
    for i in range(max(map(len, columns), default=0)):
        yield [column[min(i, len(column) - 1)] for column in columns]


def _like(type_: Type, data: Data) -> bool:
    """Whether data may be a value of a plain type."""
    return datatypes.is_number(type_) if isinstance(data, float) else type_ is _type_of(data)


def _grown(data: Data, type_: Type) -> Data:
    """An array's data within that of a larger one of stand-ins."""
    if not isinstance(type_, Array) or not type_.sizes:
        return data
    rest = stand_in(type_.inside)
    inner = [_grown(one, type_.inside) for one in data]
    return (*inner, *(rest,) * (type_.sizes[0] - len(inner)))
