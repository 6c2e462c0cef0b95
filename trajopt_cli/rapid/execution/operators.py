"""Results of operators on values that are known: numbers, vectors, orientations, strings."""

from __future__ import annotations

import operator as op
from collections.abc import Callable
from math import copysign, fmod, trunc

from trajopt_cli.path.circle import cross, minus
from trajopt_cli.rapid.data import datatypes, frames
from trajopt_cli.rapid.data.datatypes import NUM, POS, Data, Type, Value, is_number, single
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.language.syntax import Binary, Node

COMPARE: dict[str, Callable[[float, float], bool]] = {
    "<": op.lt,
    ">": op.gt,
    "<=": op.le,
    ">=": op.ge,
    "=": op.eq,
    "<>": op.ne,
}


def computed(run: Context, node: Node, type_: Type, data: Data) -> Value:
    """A result as the controller keeps it: every num in it rounded to 32 bits. Raises Fault for what is too large."""
    try:
        if type_ is NUM:
            data = single(data)
        elif not isinstance(type_, datatypes.Atomic) and type_.layout is not None:
            data = type_.layout.rounded(data)
    except OverflowError:
        raise run.fault(node, "ERR_NUM_LIMIT", f"{run.text(node)} is too large for a num") from None
    if isinstance(data, float) and data - data != 0:
        raise run.fault(node, "ERR_NUM_LIMIT", f"{run.text(node)} is too large for a {type_.name}")
    return Value(type_, data)


def string(run: Context, node: Node, text: str) -> Value:
    """A string that is not too long. Raises Fault."""
    if len(text) > datatypes.STRING_LIMIT:
        message = f"string of {len(text)} characters, limit {datatypes.STRING_LIMIT}: '{text[:20]}...'"
        raise run.fault(node, "ERR_STRTOOLNG", message)
    return Value(datatypes.STRING, text)


def arithmetic(run: Context, node: Binary, left: Value, right: Value) -> Value:
    """+ - * / DIV MOD of two numbers; a dnum if one of them is. Raises Fault."""
    a, b, operator = left.data, right.data, node.operator
    if operator == "+":
        result = a + b
    elif operator == "-":
        result = a - b
    elif operator == "*":
        result = a * b
    else:
        if b == 0:
            raise run.fault(node, "ERR_DIVZERO", f"division by zero in '{operator}'")
        if operator == "/":
            result = a / b
        else:
            if a != trunc(a) or b != trunc(b):
                raise run.error(node, f"{operator} takes whole numbers, found {a:.6g} and {b:.6g}")
            result = copysign(abs(int(a)) // abs(int(b)), a * b) if operator == "DIV" else fmod(a, b)
    if left.type is NUM and right.type is NUM:
        try:
            return Value(NUM, single(result))
        except OverflowError:
            result = float("inf")
    if result - result != 0:
        raise run.fault(node, "ERR_NUM_LIMIT", f"the result of '{operator}' is too large for a {left.type.name}")
    return Value(datatypes.DNUM, result)


_OF_VECTORS: dict[str, Callable[[frames.Vector, frames.Vector], frames.Vector]] = {
    "+": lambda p, q: (p[0] + q[0], p[1] + q[1], p[2] + q[2]),
    "-": minus,
    "*": cross,
}


def vectors(run: Context, node: Binary, left: Value, right: Value) -> Value | None:
    """Every other operator but comparisons; None where there is none for these types. Raises Fault."""
    a, b, operator = left.data, right.data, node.operator
    if left.type is datatypes.STRING and right.type is datatypes.STRING and operator == "+":
        return string(run, node, f"{a}{b}")
    if left.type is datatypes.ORIENT and right.type is datatypes.ORIENT and operator == "*":
        return computed(run, node, datatypes.ORIENT, frames.product(a, b))
    if left.type is POS and right.type is POS:
        if (combined := _OF_VECTORS.get(operator)) is not None:
            return computed(run, node, POS, combined(a, b))
    elif (left.type is POS and is_number(right.type)) or (is_number(left.type) and right.type is POS):
        factor, p = (b, a) if left.type is POS else (a, b)
        if operator == "*":
            return computed(run, node, POS, (factor * p[0], factor * p[1], factor * p[2]))
        if operator == "/" and left.type is POS:
            if factor == 0:
                raise run.fault(node, "ERR_DIVZERO", "division by zero in '/'")
            return computed(run, node, POS, (p[0] / factor, p[1] / factor, p[2] / factor))
    return None
