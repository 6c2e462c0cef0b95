"""Expressions of a running program to values."""

from __future__ import annotations

from collections.abc import Callable
from math import isfinite

from trajopt_cli.rapid.data import datatypes
from trajopt_cli.rapid.data.datatypes import (
    BOOL,
    DNUM,
    NUM,
    POS,
    Array,
    Data,
    Type,
    Value,
    is_number,
    is_opaque,
    single,
)
from trajopt_cli.rapid.data.scope import Absent, Datum, ExternalDatum, Mismatch, Part, Place, item
from trajopt_cli.rapid.execution import external_data
from trajopt_cli.rapid.execution.construction import maker
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.operators import COMPARE, arithmetic, computed, string, vectors
from trajopt_cli.rapid.language import syntax
from trajopt_cli.rapid.language.syntax import (
    Aggregate,
    Binary,
    Call,
    Component,
    Element,
    Expression,
    Name,
    Node,
    Number,
    Unary,
)
from trajopt_cli.warnings import WarningKind

TRUE, FALSE = Value(BOOL, True), Value(BOOL, False)


def evaluate(run: Context, node: Expression, wanted: Type | None = None) -> Value:
    """The value of an expression. wanted: the type the place asks for, checked; an aggregate gets its type from it.

    Raises InputError, placed at the part that is wrong.
    """
    kind = type(node)
    if kind is Name:
        place = run.find(node.name)  # type: ignore[union-attr]
        if type(place) is Datum:
            value = place.value
            if value.type is wanted:  # nearly always
                return value
        value = _read(run, node, place, wanted)  # type: ignore[arg-type]
    else:
        value = _EVALUATE[kind](run, node, wanted)
    if wanted is None or value.type is wanted:
        return value
    return _converted(run, node, value, wanted)


def _converted(run: Context, node: Expression, value: Value, wanted: Type) -> Value:
    if is_number(wanted) and is_number(value.type):
        _mixed(run, node)
        return Value(DNUM, value.data) if wanted is DNUM else computed(run, node, NUM, value.data)
    if not datatypes.same_type(wanted, value.type):
        raise run.mismatch(node, wanted, value)
    return value


def _mixed(run: Context, node: Node) -> None:
    what = "num and dnum are mixed: a controller refuses this, here the value is converted"
    run.note("dnum", WarningKind.UNUSUAL, what, node)


# -------------------------------------------------------------------------------------------------------- literals


def _number(run: Context, node: Number, wanted: Type | None) -> Value:
    if wanted is DNUM and isfinite(node.value):
        return Value(DNUM, node.value)
    try:
        return Value(NUM, single(node.value))
    except OverflowError:
        raise run.fault(node, "ERR_NUM_LIMIT", f"number {run.text(node)} is too large for a num") from None


def _placeholder(run: Context, node: syntax.Placeholder, wanted: Type | None) -> Value:
    if node.name == "*":
        raise run.error(node, "a target '*' has no coordinates in the text; declare it as a robtarget")
    raise run.error(node, f"unfinished code {node.name} cannot be run")


# ------------------------------------------------------------------------------------------------------ data names


def _read(run: Context, node: Name, place: Place | Absent | None, wanted: Type | None) -> Value:
    if type(place) is ExternalDatum:
        external_data.settle(run, place, node, wanted)
    if place is None:
        if wanted is not None and not is_number(wanted):
            return external_data.unknown(run, node, wanted)
        return Value(NUM, single(run.read_signal(node, node.name)))
    if isinstance(place, Absent):
        raise _absent(run, node)
    return _readable(run, node, place.value, wanted)


def _readable(run: Context, node: Name | Component | Element, value: Value, wanted: Type | None) -> Value:
    type_ = value.type
    if type_.name in datatypes.SIGNALS and type_ is not wanted:
        name = value.data or (node.name if isinstance(node, Name) else run.text(node))
        return Value(NUM, single(run.read_signal(node, str(name))))
    if not type_.known:
        raise run.error(node, f"'{run.text(node)}' is of type {type_.name}, which is not declared anywhere")
    return value


def _absent(run: Context, node: Name) -> Exception:
    message = f"optional parameter '{node.name}' was not given; ask Present({node.name}) before"
    return run.fault(node, "ERR_NOTPRES", message)


def locate(run: Context, node: Expression) -> Place:
    """The data that an expression names, to be changed. Raises InputError when it is not data."""
    if isinstance(node, Name):
        place = run.find(node.name)
        if place is None:
            raise run.undeclared(node)
        if isinstance(place, Absent):
            raise _absent(run, node)
        if type(place) is ExternalDatum:
            external_data.settle(run, place, node)
        return place
    if isinstance(node, Component):
        base = _from_outside(run, node) or locate(run, node.base)
        return Part(base, *_component(run, node, base.type))
    if isinstance(node, Element):
        place = _from_outside(run, node) or locate(run, node.base)
        for index, type_ in _elements(run, node, place.value):
            place = Part(place, index, type_)
        return place
    raise run.error(node, "needs the name of data here, found a value")


def _from_outside(run: Context, node: Component | Element, wanted: Type | None = None) -> Place | None:
    """What a part is one of, where the cell file gives it or should; None for what the program declares.

    wanted: the type of the part.
    """
    base = node.base
    if type(base) is not Name:
        return None
    place = run.find(base.name)
    if type(place) is ExternalDatum:
        if isinstance(node, Component):
            external_data.settle(run, place, base, part=node.name.lower())
        else:
            external_data.settle(run, place, base, wanted, depth=len(node.indices))
    grows = isinstance(node, Element) and base.name.lower() in run.external.grows
    return external_data.whole(run, base, node, wanted) if place is None or grows else None


def inside_opaque(run: Context, node: Expression) -> bool:
    """Whether an expression names a part of data whose parts are not known here (`weld1.weld_speed`)."""
    while isinstance(node, (Component, Element)):
        component = isinstance(node, Component)
        node = node.base
        if component:
            base = node
            while isinstance(base, Element):
                base = base.base
            place = run.find(base.name) if isinstance(base, Name) else None
            if type(place) is ExternalDatum and not place.typed:
                return False
            if place is not None and not isinstance(place, Absent) and is_opaque(place.type) and place.type.known:
                return True
    return False


def _part_value(run: Context, node: Component | Element, wanted: Type | None) -> Value:
    whole = node.base
    place: Place | Absent | None = None
    if isinstance(whole, Name):
        outside = _from_outside(run, node, wanted)
        place = outside or run.find(whole.name)
    known = type(place) is Datum and (type(place.type) is Array or place is outside)
    base = place.value if known or type(place) is ExternalDatum else evaluate(run, whole)  # type: ignore[union-attr]
    if isinstance(node, Component):
        base = item(base, *_component(run, node, base.type))
    else:
        for index, type_ in _elements(run, node, base):
            base = item(base, index, type_)
    return _readable(run, node, base, wanted) if is_opaque(base.type) else base


def _component(run: Context, node: Component, type_: Type) -> tuple[int, Type]:
    if isinstance(type_, datatypes.Record):
        wanted = node.name.lower()
        for index, (name, part) in enumerate(type_.components):
            if name == wanted:
                if wanted in datatypes.UNFOLLOWED and type_ in datatypes.MODAL:
                    raise run.error(node, f"{wanted} of a {type_.name} is not followed here; write its value instead")
                return index, part
        known = ", ".join(name for name, _ in type_.components)
        raise run.error(node, f"{type_.name} has no component '{node.name}'; it has {known}")
    if is_opaque(type_) and not isinstance(type_, Array):
        raise run.error(node, f"the components of a {type_.name} are not known here, so '.{node.name}' cannot be read")
    raise run.error(node, f"a {type_.name} has no components, so it has no '.{node.name}'")


def _elements(run: Context, node: Element, base: Value) -> list[tuple[int, Type]]:
    type_, data = base.type, base.data
    if not isinstance(type_, Array):
        raise run.error(node, f"a {type_.name} is not an array, so it has no elements")
    if not isinstance(data, tuple):  # of a type that means nothing here
        message = f"'{run.text(node)}' is of type {type_.element.name}, which has no value that can be read"
        raise run.error(node, message)
    if len(node.indices) != type_.dimensions:
        array = f"{run.text(node.base)} is an array of {type_.dimensions} dimension(s)"
        raise run.error(node, f"{array}, found {len(node.indices)} index(es)")
    path: list[tuple[int, Type]] = []
    for expression in node.indices:
        assert isinstance(type_, Array)
        index = run.integer(expression, "an index")
        if not 1 <= index <= len(data):
            which = f"index {index}" if len(node.indices) == 1 else f"index {index} in dimension {len(path) + 1}"
            message = f"{which} of {run.text(node)} lies outside 1..{len(data)}"
            raise run.fault(expression, "ERR_OUTOFBND", message)
        type_, data = type_.inside, data[index - 1]
        path.append((index - 1, type_))
    return path


# ------------------------------------------------------------------------------------------------------ aggregates


_value, _origin = maker(Value), maker(datatypes.Origin)


def _aggregate(run: Context, node: Aggregate, wanted: Type | None) -> Value:
    """An aggregate as a value of the wanted type. Raises InputError when parts are missing or too many."""
    if wanted is None:
        raise run.error(node, "an aggregate has no type here; declare it as data and use its name")
    if wanted.layout is not None:
        places = run.places()
        data = wanted.layout.read(places.text[node.start : node.end])
        if data is not None:
            return _value((wanted, data, _origin((places.file, node, None))))
    parts: list[Type]
    if isinstance(wanted, datatypes.Record):
        parts = [part for _, part in wanted.components]
        shape = f"[{','.join(name for name, _ in wanted.components)}]"
        if wanted is datatypes.CONFDATA and len(node.items) == len(parts) - 1:
            return Value(wanted, (*(run.number(value) for value in node.items), 0.0))  # S4 wrote no cfx: it is 0
        if len(node.items) != len(parts):
            text = f"{wanted.name} needs {len(parts)} parts {shape}, found {len(node.items)}"
            if parts[-1] == datatypes.EXTJOINT and len(node.items) == len(parts) - 1:
                text += "; the external axes are missing, write [9E9,9E9,9E9,9E9,9E9,9E9], "
                text += "with the rail's position in its place if the robot rides on one"
            raise run.error(node, text)
    elif isinstance(wanted, Array):
        size = wanted.sizes[0] if wanted.sizes else len(node.items)
        if len(node.items) != size:
            raise run.error(node, f"the array needs {size} elements, found {len(node.items)}")
        parts = [wanted.inside] * size
    elif is_opaque(wanted):
        return opaque(run, node, wanted)
    else:
        raise run.mismatch(node, wanted, None)
    try:
        values = [evaluate(run, inner, part) for part, inner in zip(parts, node.items, strict=True)]
    except Mismatch as error:
        which = next((i for i, inner in enumerate(node.items) if inner is error.node), None)
        if which is None:
            raise
        name = f"element {which + 1}" if isinstance(wanted, Array) else wanted.components[which][0]
        raise error.about(error.node, f"{name} of a {wanted.name}") from None
    if isinstance(wanted, Array) and not wanted.sizes and values:
        wanted = _closed(wanted, values[0].type, len(values))
    return Value(wanted, tuple([value.data for value in values]), datatypes.Origin(run.file, node, None))


def opaque(run: Context, node: Expression, type_: Type) -> Value:
    """A value of a type that means nothing here: its literals where it is written with nothing else, else its text."""
    if isinstance(node, Aggregate) and (data := _literals(node)) is not None:
        return Value(type_, data)
    if isinstance(node, Aggregate) and isinstance(type_, Array):
        return Value(type_, tuple([opaque(run, item, type_.inside).data for item in node.items]))
    if isinstance(node, Name):
        return _read(run, node, run.find(node.name), type_)
    return Value(type_, datatypes.Opaque(run.text(node)))


def _literals(node: Aggregate) -> Data:
    """An aggregate of literals as nested tuples, None for one that holds anything else."""
    if (numbers := node.numbers) is not None:
        return numbers
    parts = [_literals(one) if isinstance(one, Aggregate) else getattr(one, "value", None) for one in node.items]
    return None if None in parts else tuple(parts)


def _closed(open_: Array, inner: Type, size: int) -> Array:
    """An array type whose sizes were open, with those of a literal."""
    rest = inner.sizes if isinstance(inner, Array) else ()
    return Array(open_.element, None if rest is None else (size, *rest), open_.dimensions)


# ------------------------------------------------------------------------------------------------------- operators


def _unary(run: Context, node: Unary, wanted: Type | None) -> Value:
    if node.operator == "NOT":
        try:
            return FALSE if evaluate(run, node.operand, BOOL).data is True else TRUE
        except Mismatch as error:
            raise error.about(node.operand, "the right side of NOT") from None
    value = evaluate(run, node.operand) if wanted is not DNUM else _hinted(run, node.operand)
    if node.operator == "+" and (is_number(value.type) or value.type is POS):
        return Value(value.type, value.data)
    if is_number(value.type):
        return Value(value.type, -value.data)
    if value.type is POS:
        x, y, z = value.data
        return Value(POS, (-x, -y, -z))
    raise run.error(node, f"'{node.operator}' needs a number or a pos, found {value.type.name}")


def _hinted(run: Context, node: Expression) -> Value:
    """An operand where a dnum is asked for: its literals are dnums, and its type is not checked yet."""
    return _EVALUATE[type(node)](run, node, DNUM) if isinstance(node, (Number, Unary, Binary)) else evaluate(run, node)


def _literal(node: Expression) -> bool:
    """Whether an expression is made of numbers only, so that it takes its type from the place it stands in."""
    if isinstance(node, Binary):
        return _literal(node.left) and _literal(node.right)
    return isinstance(node, Number) or (isinstance(node, Unary) and _literal(node.operand))


def _binary(run: Context, node: Binary, wanted: Type | None) -> Value:
    operator = node.operator
    if operator in ("AND", "OR", "XOR"):
        try:
            left = evaluate(run, node.left, BOOL).data is True
            if operator == "XOR":
                return TRUE if left != (evaluate(run, node.right, BOOL).data is True) else FALSE
            # The right side is only looked at where it matters, so a guarded index stays inside its array.
            decided = left == (operator == "OR")
            return TRUE if (left if decided else evaluate(run, node.right, BOOL).data is True) else FALSE
        except Mismatch as error:
            side = "left" if error.node is node.left else "right"
            raise error.about(node.left if side == "left" else node.right, f"the {side} side of {operator}") from None
    a, b = _operands(run, node, wanted)
    compare = COMPARE.get(operator)
    if is_number(a.type) and is_number(b.type):
        if compare is not None:
            return TRUE if compare(a.data, b.data) else FALSE
        return arithmetic(run, node, a, b)
    if operator in ("=", "<>"):
        if not datatypes.same_type(a.type, b.type):
            raise run.error(node, f"cannot compare {a.type.name} with {b.type.name}")
        if isinstance(a.data, tuple):
            run.spend(node, len(a.data))
        return TRUE if (a.data == b.data) == (operator == "=") else FALSE
    value = vectors(run, node, a, b)
    if value is None:
        raise run.error(node, f"'{operator}' is not defined for {a.type.name} and {b.type.name}")
    return value


def _unknown(run: Context, node: Expression) -> bool:
    """Whether a side takes its type from the other one: a name that nothing declares, a function that nobody knows."""
    if type(node) is Call:
        return not run.knows(node.name)
    return type(node) is Name and run.find(node.name) is None


def _operands(run: Context, node: Binary, wanted: Type | None) -> tuple[Value, Value]:
    """Both sides. An aggregate takes its type from the other one, and so do numbers beside a dnum."""
    if isinstance(node.left, Aggregate):
        b = evaluate(run, node.right)
        return evaluate(run, node.left, b.type), b
    if wanted is DNUM and node.operator not in COMPARE:
        a, b = _hinted(run, node.left), _hinted(run, node.right)
    elif node.operator in ("=", "<>") and _unknown(run, node.left):
        b = evaluate(run, node.right)
        a = evaluate(run, node.left, None if is_number(b.type) else b.type)
    else:
        a = evaluate(run, node.left)
        typed = isinstance(node.right, Aggregate) or (not is_number(a.type) and _unknown(run, node.right))
        b = evaluate(run, node.right, a.type if typed else None)
    if a.type is not b.type and is_number(a.type) and is_number(b.type):
        if a.type is NUM and _literal(node.left):
            a = _hinted(run, node.left)
        elif b.type is NUM and _literal(node.right):
            b = _hinted(run, node.right)
        else:
            _mixed(run, node)
    return a, b


_EVALUATE: dict[type, Callable[..., Value]] = {
    Name: lambda run, node, wanted: _read(run, node, run.find(node.name), wanted),
    Number: _number,
    Aggregate: _aggregate,
    syntax.String: lambda run, node, wanted: string(run, node, node.value),
    syntax.Boolean: lambda run, node, wanted: TRUE if node.value else FALSE,
    Component: _part_value,
    Element: _part_value,
    Call: lambda run, node, wanted: run.call_function(node, wanted),
    Unary: _unary,
    Binary: _binary,
    syntax.Placeholder: _placeholder,
}
