"""Answers of the scenario as values of the type that the program asks for."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.rapid.data import datatypes
from trajopt_cli.rapid.data.datatypes import BOOL, NUM, Array, Atomic, Data, Type, Value
from trajopt_cli.rapid.data.predefined import predefined
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.language.expressions import parse_expression
from trajopt_cli.rapid.language.syntax import Aggregate, Call, Expression, Name, base_of, walk
from trajopt_cli.scenario import NUM_LIMIT, Answer, yaml_answer

if TYPE_CHECKING:
    from trajopt_cli.rapid.language.syntax import Node


def root(run: Context, node: Expression) -> str:
    """The name of the variable that an expression is, or is a part of: `p` of `p{2}.trans.x`."""
    base = base_of(node)
    if not isinstance(base, Name):
        raise run.error(base, "needs the name of data here, found a value")
    return base.name


def fill(run: Context, target: Expression, reason: str, default: Answer | None = None) -> Value | None:
    """Let a variable have the scenario's answer under its name; returns the value.

    A type that nothing here computes with (rawbytes ...) stays as it is, and None is returned. reason: what asked, for
    messages. default: stands in for a missing answer; None for 0, "", FALSE. Raises InputError for an answer of another
    type than the variable's.
    """
    type_ = run.locate(target).type
    element = type_.element if isinstance(type_, Array) else type_
    if element.default is None:
        return None
    value = ask(run, target, root(run, target), type_, reason, default)
    run.assign(target, value)
    return value


def ask(
    run: Context,
    node: Node,
    name: str,
    type_: Type,
    reason: str,
    default: Answer | None = None,
    close: Callable[[], str | None] | None = None,
) -> Value:
    """The scenario's answer under name, as a value of a type. Records and arrays are answered as RAPID writes them.

    reason, close: see World.lack.
    """
    if default is None:
        atomic = isinstance(type_, Atomic)
        default = type_.default if atomic else _whole(run, node, name, Value(type_, stand_in(type_)))
    return typed(run, node, name, type_, run.answer(node, name, reason, default, close), "answer", "to")


@of_kind(ErrorKind.CELL)
def typed(run: Context, node: Node, name: str, type_: Type, answer: Answer, what: str, of: str) -> Value:
    """What the cell file gives under name as a value of a type. what, of: "answer", "to" and the like, for messages."""
    if isinstance(answer, int | float) and not isinstance(answer, bool) and datatypes.is_number(type_):
        if type_ is NUM and abs(answer) > NUM_LIMIT:
            raise run.error(node, f"the {what} {answer:g} {of} '{name}' in the cell file is too large for a num")
        return Value(type_, datatypes.single(float(answer)) if type_ is NUM else float(answer))
    if isinstance(answer, str) and type_ == datatypes.STRING:
        if len(answer) > datatypes.STRING_LIMIT:
            has = f"{len(answer)} characters, limit {datatypes.STRING_LIMIT}"
            raise run.error(node, f"the {what} {of} '{name}' in the cell file has {has}")
        return Value(type_, answer)
    if isinstance(answer, bool) and type_ == BOOL:
        return Value(type_, answer)
    if isinstance(answer, str) and not isinstance(type_, Atomic):
        return _parsed(run, node, f"the {what} {of} '{name}' in the cell file", type_, answer)
    wanted = _WANTED.get(type_.name, f"a {type_.name} as RAPID writes it, in quotes")
    raise run.error(node, f"the {what} {yaml_answer(answer)} {of} '{name}' in the cell file is not {wanted}")


_WANTED = {"num": "a number", "dnum": "a number", "bool": "true or false", "string": "a text; put it in quotes"}


def _parsed(run: Context, node: Node, subject: str, type_: Type, text: str) -> Value:
    try:
        literal = parse_expression(text, "")
        names = [*_names(literal)]
        if isinstance(literal, Aggregate) and not names:
            value = run.evaluate(literal, type_)
            return Value(value.type, value.data)
        problem = f"has the name {names[0]} in it" if names else "is not a value in brackets"
    except InputError as error:
        problem = f"is not: {error.message}"
    wanted = _literal(type_, stand_in(type_), _LONGEST)
    wanted = wanted if len(wanted) <= 100 else f"{wanted[:97]}..."
    raise run.error(node, f"{subject} must be a {type_.name} such as {wanted}; it {problem}")


def _names(literal: Expression) -> Iterator[str]:
    for node in walk(literal):
        if isinstance(node, Name | Call):
            yield node.name
        elif isinstance(node, Aggregate) and node.numbers is None:
            for one in node.items:
                yield from _names(one)


_LONGEST = 20_000  # characters of an answer; the whole cell file may have 1 MB


def _whole(run: Context, node: Node, name: str, value: Value) -> str:
    text = _literal(value.type, value.data, _LONGEST)
    if len(text) > _LONGEST:
        raise run.error(node, f"'{name}' is a {value.type.name} with more values than a cell file can hold")
    return text


def shown_value(run: Context, node: Node, name: str, value: Value) -> str:
    """The value of data as the cell file spells it."""
    plain = isinstance(value.type, Atomic)
    return yaml_answer(value.data if plain else _whole(run, node, name, value))


_NOWHERE = datatypes.single(9e9)  # of an external axis that has no position
_STAND_INS = {"speeddata": "v100", "zonedata": "fine", "tooldata": "tool0", "wobjdata": "wobj0"}


def stand_in(type_: Type) -> Data:
    """The value that a type begins with, but one that can be used: turned by nothing, no axis where none is known."""
    if type_ == datatypes.EXTJOINT:
        return (_NOWHERE,) * 6
    if type_ == datatypes.ORIENT:
        return (1.0, 0.0, 0.0, 0.0)
    known = _STAND_INS.get(type_.name)
    if known is not None and type_ == datatypes.TYPES[type_.name]:
        return predefined()[known].data
    if isinstance(type_, datatypes.Record):
        return tuple(stand_in(part) for _, part in type_.components)
    if isinstance(type_, Array):
        return (stand_in(type_.inside),) * (type_.sizes[0] if type_.sizes else 1)
    return type_.default


def _literal(type_: Type, data: Data, room: int) -> str:
    """data as RAPID writes it, or more than room characters of it."""
    if isinstance(data, tuple):
        parts = [part for _, part in type_.components] if isinstance(type_, datatypes.Record) else None
        inner = type_.inside if isinstance(type_, Array) else type_
        texts: list[str] = []
        for i, one in enumerate(data):
            texts.append(_literal(parts[i] if parts else inner, one, room))
            room -= len(texts[-1]) + 1
            if room < 0:
                break
        return f"[{','.join(texts)}]"
    if isinstance(data, bool):
        return "TRUE" if data else "FALSE"
    if isinstance(data, float):
        return "9E9" if data == _NOWHERE else f"{data:.15g}"
    return '"' + str(data).replace('"', '""') + '"'
