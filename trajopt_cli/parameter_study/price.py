"""`price:` of a study: arithmetic over keys of the cell file and offsets, read without ever being run as Python."""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable
from typing import Any

from trajopt_cli.errors import InputError

_BINARY: dict[type[ast.AST], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
}
_CALLS: dict[str, Callable[..., Any]] = {"abs": abs, "min": min, "max": max}


def price(text: str, value_of: Callable[[str], Any]) -> float:
    """The value of an expression. value_of: what a dotted key stands for, SI; None where it stands for nothing.

    `+ - * /`, comparisons, `A if B else C`, `abs`, `min`, `max`, and a table by a key's text, `{"a": 1}[robot]`.
    Raises InputError for anything else and for an answer that is no number.
    """
    try:
        found = _value(ast.parse(text.strip(), mode="eval").body, value_of)
    except SyntaxError as error:
        raise InputError(f"is no expression: {error.msg}") from error
    except (TypeError, ZeroDivisionError, OverflowError, KeyError) as error:
        raise InputError(f"cannot be worked out: {error}") from error
    if isinstance(found, bool) or not isinstance(found, int | float):
        raise InputError(f"is no number but {found!r}")
    return float(found)


def _value(node: ast.AST, value_of: Callable[[str], Any]) -> Any:
    def inner(one: ast.AST) -> Any:
        return _value(one, value_of)

    match node:
        case ast.Constant(value=int() | float() | str() as value):
            return value
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return -inner(operand)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _BINARY:
            return _BINARY[type(op)](inner(left), inner(right))
        case ast.Compare(left=left, ops=[op], comparators=[right]) if type(op) in _BINARY:
            return _BINARY[type(op)](inner(left), inner(right))
        case ast.IfExp(test=test, body=body, orelse=other):
            return inner(body) if inner(test) else inner(other)
        case ast.Subscript(value=ast.Dict(keys=keys, values=values), slice=chosen):
            table = {inner(key): value for key, value in zip(keys, values, strict=True) if key is not None}
            return inner(table[inner(chosen)])
        case ast.Call(func=ast.Name(id=name), args=args, keywords=[]) if name in _CALLS:
            return _CALLS[name](*map(inner, args))
        case ast.Name() | ast.Attribute():
            key = ast.unparse(node)
            value = value_of(key)
            if value is None:
                raise InputError(f"{key} is no key that varies, and none with a value in the cell file")
            return value
    raise InputError(f"does not take {ast.unparse(node)!r}")
