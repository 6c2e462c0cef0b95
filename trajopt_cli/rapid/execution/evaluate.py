"""Expressions of a running program to values."""

from __future__ import annotations

from math import fmod, trunc
from typing import TYPE_CHECKING

from trajopt_cli.rapid.data import frames
from trajopt_cli.rapid.data.datatypes import (
    BOOL,
    NUM,
    ORIENT,
    POS,
    SIGNALS,
    STRING,
    Array,
    Data,
    Origin,
    Record,
    Type,
    Value,
    is_number,
    same_type,
)
from trajopt_cli.rapid.data.scope import Absent, Part, Place, fits, item
from trajopt_cli.rapid.language.syntax import (
    Aggregate,
    Binary,
    Boolean,
    Call,
    Component,
    Element,
    Expression,
    Name,
    Number,
    Placeholder,
    String,
    Unary,
)

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Run


def evaluate(run: Run, node: Expression, wanted: Type | None = None) -> Value:
    """The value of an expression. wanted: the type the place asks for, checked; an aggregate gets its type from it.

    Raises InputError, placed at the part that is wrong.
    """
    value = _evaluate(run, node, wanted)
    if wanted is not None and value.type is not wanted and not convertible(wanted, value.type):
        raise run.error(node, f"needs a value of type {wanted.name}, found {value.type.name}")
    return value


def convertible(wanted: Type, given: Type) -> bool:
    """Whether a value may be used where another type is asked for: num and dnum mix, all else is strict."""
    return (is_number(wanted) and is_number(given)) or same_type(wanted, given)


def number(run: Run, node: Expression) -> float:
    """The value of a num or dnum expression."""
    data = evaluate(run, node, NUM).data
    assert isinstance(data, (int, float))
    return float(data)


def integer(run: Run, node: Expression, what: str) -> int:
    """The value of an expression that must be a whole number; what names it in the message."""
    value = number(run, node)
    if value != trunc(value):
        raise run.error(node, f"{what} must be a whole number, found {value:.6g}")
    return int(value)


def condition(run: Run, node: Expression) -> bool:
    """The value of a bool expression."""
    return evaluate(run, node, BOOL).data is True


def _evaluate(run: Run, node: Expression, wanted: Type | None) -> Value:
    match node:
        case Name():
            return _read(run, node, wanted)
        case Number():
            return Value(NUM if wanted is None or not is_number(wanted) else wanted, node.value)
        case Aggregate():
            if wanted is None:
                raise run.error(node, "an aggregate has no type here; declare it as data and use its name")
            return aggregate(run, node, wanted)
        case String():
            return Value(STRING, node.value)
        case Boolean():
            return Value(BOOL, node.value)
        case Component() | Element():
            return _part_value(run, node)
        case Call():
            return run.call_function(node)
        case Unary():
            return _unary(run, node)
        case Binary():
            return _binary(run, node)
        case Placeholder(name="*"):
            raise run.error(node, "a target '*' has no coordinates in the text; declare it as a robtarget")
        case Placeholder():
            raise run.error(node, f"unfinished code {node.name} cannot be run")


# ------------------------------------------------------------------------------------------------------ data names


def _read(run: Run, node: Name, wanted: Type | None) -> Value:
    place = run.find(node.name)
    if isinstance(place, Absent):
        raise run.error(node, f"optional parameter '{node.name}' was not given; ask Present({node.name}) before")
    if place is not None:
        value = place.value
        if value.type.name in SIGNALS:
            return Value(NUM, run.world.signal(run, node, str(value.data or node.name)))
        if value.data is None:
            raise run.error(node, f"'{node.name}' is of type {value.type.name}, which has no value that can be read")
        return value
    if wanted is not None and not is_number(wanted):
        raise run.error(node, f"{wanted.name} '{node.name}' is not declared in the program")
    return Value(NUM, run.world.signal(run, node, node.name))


def locate(run: Run, node: Expression) -> Place:
    """The data that an expression names, to be changed. Raises InputError when it is not data."""
    if isinstance(node, Name):
        place = run.find(node.name)
        if place is None:
            raise run.error(node, f"'{node.name}' is not declared in the program")
        if isinstance(place, Absent):
            raise run.error(node, f"optional parameter '{node.name}' was not given; ask Present({node.name}) before")
        return place
    if isinstance(node, Component):
        base = locate(run, node.base)
        return Part(base, *_component(run, node, base.type))
    if isinstance(node, Element):
        place = locate(run, node.base)
        for index, type_ in _elements(run, node, place.value):
            place = Part(place, index, type_)
        return place
    raise run.error(node, "needs the name of data here, found a value")


def _part_value(run: Run, node: Component | Element) -> Value:
    base = evaluate(run, node.base)
    if isinstance(node, Component):
        return item(base, *_component(run, node, base.type))
    for index, type_ in _elements(run, node, base):
        base = item(base, index, type_)
    return base


def _component(run: Run, node: Component, type_: Type) -> tuple[int, Type]:
    if isinstance(type_, Record):
        wanted = node.name.lower()
        for index, (name, part) in enumerate(type_.components):
            if name == wanted:
                return index, part
        known = ", ".join(name for name, _ in type_.components)
        raise run.error(node, f"{type_.name} has no component '{node.name}'; it has {known}")
    raise run.error(node, f"a {type_.name} has no components, so '.{node.name}' means nothing")


def _elements(run: Run, node: Element, base: Value) -> list[tuple[int, Type]]:
    type_, data = base.type, base.data
    if not isinstance(type_, Array):
        raise run.error(node, f"a {type_.name} is no array, so it has no elements")
    if len(node.indices) != type_.dimensions:
        raise run.error(node, f"the array has {type_.dimensions} dimension(s), found {len(node.indices)} index(es)")
    path: list[tuple[int, Type]] = []
    for expression in node.indices:
        assert isinstance(type_, Array)
        index = integer(run, expression, "an index")
        if not 1 <= index <= len(data):
            raise run.error(expression, f"index {index} lies outside the array's 1..{len(data)}")
        type_, data = type_.inner(), data[index - 1]
        path.append((index - 1, type_))
    return path


# ------------------------------------------------------------------------------------------------------ aggregates


def aggregate(run: Run, node: Aggregate, wanted: Type) -> Value:
    """An aggregate as a value of the wanted type. Raises InputError when parts are missing or too many."""
    numbers = node.numbers
    if numbers is not None and fits(wanted, numbers):
        return Value(wanted, numbers, Origin(run.file, node, None))
    parts: list[Type]
    if isinstance(wanted, Record):
        parts = [part for _, part in wanted.components]
        shape = f"[{','.join(name for name, _ in wanted.components)}]"
        if len(node.items) != len(parts):
            raise run.error(node, f"{wanted.name} needs {len(parts)} parts {shape}, found {len(node.items)}")
    elif isinstance(wanted, Array):
        size = wanted.sizes[0] if wanted.sizes else len(node.items)
        if len(node.items) != size:
            raise run.error(node, f"the array needs {size} elements, found {len(node.items)}")
        parts = [wanted.inner()] * size
    else:
        raise run.error(node, f"needs a value of type {wanted.name}, found an aggregate")
    data: list[Data] = []
    for part, inner in zip(parts, node.items, strict=True):
        value = evaluate(run, inner, part)
        if isinstance(value.data, float) and value.data - value.data != 0:
            raise run.error(inner, "number is too large")
        data.append(value.data)
    return Value(wanted, tuple(data), Origin(run.file, node, None))


# ------------------------------------------------------------------------------------------------------- operators


def _unary(run: Run, node: Unary) -> Value:
    if node.operator == "NOT":
        return Value(BOOL, not condition(run, node.operand))
    value = evaluate(run, node.operand)
    if node.operator == "+" and (is_number(value.type) or value.type == POS):
        return Value(value.type, value.data)
    if is_number(value.type):
        return Value(value.type, -value.data)
    if value.type == POS:
        x, y, z = value.data
        return Value(POS, (-x, -y, -z))
    raise run.error(node, f"'{node.operator}' needs a number or a pos, found {value.type.name}")


def _binary(run: Run, node: Binary) -> Value:
    operator = node.operator
    if operator in ("AND", "OR", "XOR"):
        left = condition(run, node.left)
        if operator == "XOR":
            return Value(BOOL, left != condition(run, node.right))
        # The right side is only looked at where it matters, so a guarded index stays inside its array.
        decided = left == (operator == "OR")
        return Value(BOOL, left if decided else condition(run, node.right))
    if isinstance(node.left, Aggregate):
        b = evaluate(run, node.right)
        a = evaluate(run, node.left, b.type)
    else:
        a = evaluate(run, node.left)
        b = evaluate(run, node.right, a.type if isinstance(node.right, Aggregate) else None)
    if operator in ("=", "<>"):
        if not convertible(a.type, b.type):
            raise run.error(node, f"cannot compare {a.type.name} with {b.type.name}")
        return Value(BOOL, (a.data == b.data) == (operator == "="))
    if is_number(a.type) and is_number(b.type):
        return _arithmetic(run, node, a, b)
    value = _vectors(operator, a, b)
    if value is None:
        raise run.error(node, f"'{operator}' is not defined for {a.type.name} and {b.type.name}")
    return value


def _arithmetic(run: Run, node: Binary, left: Value, right: Value) -> Value:
    a, b = left.data, right.data
    match node.operator:
        case "<":
            return Value(BOOL, a < b)
        case ">":
            return Value(BOOL, a > b)
        case "<=":
            return Value(BOOL, a <= b)
        case ">=":
            return Value(BOOL, a >= b)
        case "+":
            result = a + b
        case "-":
            result = a - b
        case "*":
            result = a * b
        case operator:
            if b == 0:
                raise run.error(node, f"division by zero in '{operator}'")
            if operator == "/":
                result = a / b
            else:
                if a != trunc(a) or b != trunc(b):
                    raise run.error(node, f"{operator} takes whole numbers, found {a:.6g} and {b:.6g}")
                result = float(trunc(a / b)) if operator == "DIV" else fmod(a, b)
    if result - result != 0:
        raise run.error(node, f"the result of '{node.operator}' is too large")
    return Value(left.type, result)


def _vectors(operator: str, left: Value, right: Value) -> Value | None:
    a, b = left.data, right.data
    types = (left.type, right.type)
    if types == (STRING, STRING) and operator == "+":
        return Value(STRING, f"{a}{b}")
    if types == (ORIENT, ORIENT) and operator == "*":
        return Value(ORIENT, frames.product(a, b))
    if types == (POS, POS):
        p: frames.Vector = a
        q: frames.Vector = b
        if operator == "+":
            return Value(POS, (p[0] + q[0], p[1] + q[1], p[2] + q[2]))
        if operator == "-":
            return Value(POS, (p[0] - q[0], p[1] - q[1], p[2] - q[2]))
        if operator == "*":
            return Value(POS, frames.cross(p, q))
    factor, vector = (a, b) if is_number(left.type) else (b, a)
    if POS in types and (is_number(left.type) or is_number(right.type)) and isinstance(factor, float):
        p = vector
        if operator == "*":
            return Value(POS, (factor * p[0], factor * p[1], factor * p[2]))
        if operator == "/" and left.type == POS and factor != 0:
            return Value(POS, (p[0] / factor, p[1] / factor, p[2] / factor))
    return None
