"""The syntax tree of RAPID. Every node knows its stretch [start, end) of the text; comparing trees ignores it.

Names keep the spelling of the text. An instruction is no grammar: MoveL is a ProcedureCall like any other.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from dataclasses import dataclass, field, fields, is_dataclass
from typing import Any, TypeVar, dataclass_transform

_Class = TypeVar("_Class")


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def _node(cls: type[_Class]) -> type[_Class]:
    """A dataclass that the type checker holds to be frozen.

    Python does not: a frozen one sets each field by a call of its own, which doubles the time a large program takes.
    """
    return dataclass(slots=True, unsafe_hash=True)(cls)


@_node
class Node:
    """start, end: offsets into the file's text."""

    start: int = field(compare=False, repr=False)
    end: int = field(compare=False, repr=False)


# ---------------------------------------------------------------------------------------------------- expressions


@_node
class Number(Node):
    """A numeric literal with the sign in front of it."""

    value: float


@_node
class String(Node):
    """A string literal; value has its escapes resolved."""

    value: str


@_node
class Boolean(Node):
    """TRUE or FALSE."""

    value: bool


@_node
class Name(Node):
    """A name standing for data, a signal or a routine."""

    name: str


@_node
class Component(Node):
    """`base.name`."""

    base: Expression
    name: str


@_node
class Element(Node):
    """`base{index, ...}`."""

    base: Expression
    indices: tuple[Expression, ...]


@_node
class Argument(Node):
    r"""One argument. name: of an optional one, without its backslash; value None for a bare switch.

    forward: `\name?value`, passed on only if the optional parameter that value names is present. parameter: of a
    required one, as in `Speed:=v100`, where it is written; start and end are those of the value all the same.
    """

    name: str | None
    value: Expression | None
    forward: bool = False
    parameter: str | None = None


@_node
class Call(Node):
    """A function call, `name(args)`."""

    name: str
    args: tuple[Argument, ...]


@_node
class Unary(Node):
    """operator: "-", "+" or "NOT"."""

    operator: str
    operand: Expression


@_node
class Binary(Node):
    """operator: one of * / DIV MOD + - < > <= >= = <> AND XOR OR."""

    operator: str
    left: Expression
    right: Expression


@_node
class Placeholder(Node):
    """Unfinished code such as <EXP>; `*` for a target that the text does not hold. Legal to load, not to run."""

    name: str


class Aggregate(Node):
    """`[a, [b, c]]`, made from its items. A plain numeric one keeps the file's text, opened when looked into."""

    __slots__ = ("_file", "_items")

    def __init__(self, start: int, end: int, file: str | None = None, given: tuple[Expression, ...] = ()):
        """file: the whole text that start and end are offsets of."""
        self.start, self.end = start, end  # type: ignore[misc]  # frozen for all others
        self._file = file
        self._items = None if file is not None else given

    @property
    def items(self) -> tuple[Expression, ...]:
        """The items as nodes of their own."""
        if self._items is None:
            self._items = _open(self._file or "", self.start, self.end)
        return self._items

    @property
    def numbers(self) -> Numbers | None:
        """The values as nested tuples when every one is a number, else None. Computed anew each time."""
        if self._file is not None:
            try:
                return _tuples(_decode(self._file[self.start : self.end]))
            except json.JSONDecodeError:
                pass  # `1.`, `.5` and `+5` are RAPID but not JSON
        values: list[Numbers | float] = []
        for item in self.items:
            value = item.value if isinstance(item, Number) else None
            nested = item.numbers if isinstance(item, Aggregate) else value
            if nested is None:
                return None
            values.append(nested)
        return tuple(values)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Aggregate) and self.items == other.items

    def __hash__(self) -> int:
        return hash(self.items)

    def __repr__(self) -> str:
        return f"Aggregate({self.items!r})"


Numbers = tuple["Numbers | float", ...]
Expression = Number | String | Boolean | Name | Component | Element | Call | Unary | Binary | Placeholder | Aggregate

_decode = json.JSONDecoder(parse_int=float).decode
_ROW = r"\[[^\[\]]*+\]"
# A number without a sign, as in a program's text.
NUMBER = r"(?:[0-9]++(?:\.[0-9]*+)?+|\.[0-9]++)(?:[eE][+-]?[0-9]++)?+"
_NEST = rf"\[(?:[^\[\]]++|{_ROW})*+\]"
_PART = re.compile(rf"(?P<nested>\[(?:[^\[\]]++|{_NEST})*+\])|(?P<number>[+-]?{NUMBER})")


def _open(file: str, start: int, end: int) -> tuple[Expression, ...]:
    """The items of a plain numeric aggregate; the aggregates among them stay closed."""
    items: list[Expression] = []
    for match in _PART.finditer(file, start + 1, end - 1):
        first, last = match.span()
        number = match.lastgroup == "number"
        items.append(Number(first, last, float(match[0])) if number else Aggregate(first, last, file))
    return tuple(items)


def _tuples(values: list[Any]) -> Numbers:
    return tuple([_tuples(v) if type(v) is list else v for v in values])


# ----------------------------------------------------------------------------------------------------- statements


@_node
class Assign(Node):
    """`target := value;`."""

    target: Expression
    value: Expression


@_node
class ProcedureCall(Node):
    """`name args;`: an instruction or a procedure of the program."""

    name: str
    args: tuple[Argument, ...]


@_node
class LateCall(Node):
    """`%name% args;`: the procedure whose name is the value of an expression."""

    name: Expression
    args: tuple[Argument, ...]


@_node
class If(Node):
    """branches: conditions with their blocks. compact: `IF condition statement`, without THEN."""

    branches: tuple[tuple[Expression, Block], ...]
    otherwise: Block
    compact: bool = False


@_node
class For(Node):
    """`FOR name FROM first TO last [STEP step] DO`."""

    name: str
    first: Expression
    last: Expression
    step: Expression | None
    body: Block


@_node
class While(Node):
    """`WHILE condition DO`."""

    condition: Expression
    body: Block


@_node
class Test(Node):
    """`TEST subject CASE a,b: ... DEFAULT: ...`; default None where there is none."""

    subject: Expression
    cases: tuple[tuple[tuple[Expression, ...], Block], ...]
    default: Block | None


@_node
class Goto(Node):
    """`GOTO label;`."""

    label: str


@_node
class Label(Node):
    """`name:`."""

    name: str


@_node
class Return(Node):
    """`RETURN [value];`."""

    value: Expression | None


@_node
class Raise(Node):
    """`RAISE [number];`."""

    value: Expression | None


@_node
class Simple(Node):
    """A statement that is one word: EXIT, RETRY, TRYNEXT."""

    word: str


@_node
class Connect(Node):
    """`CONNECT interrupt WITH trap;`."""

    interrupt: Expression
    trap: str


# --------------------------------------------------------------------------------------------------- declarations


@_node
class DataDeclaration(Node):
    """scope: LOCAL, TASK or None. storage: VAR, PERS or CONST. sizes: up to three, constant expressions."""

    scope: str | None
    storage: str
    type: str
    name: str
    sizes: tuple[Expression, ...]
    value: Expression | None


@_node
class RecordDeclaration(Node):
    """components: (type, name) in order."""

    scope: str | None
    name: str
    components: tuple[tuple[str, str], ...]


@_node
class AliasDeclaration(Node):
    """`ALIAS type name;`."""

    scope: str | None
    type: str
    name: str


@_node
class Parameter(Node):
    """mode: None (a copy), INOUT, VAR or PERS. dimensions: 0 for a plain value. alternative: after a `|`."""

    mode: str | None
    type: str
    name: str
    dimensions: int = 0
    optional: bool = False
    alternative: bool = False


@_node
class Handler(Node):
    """kind: ERROR, UNDO or BACKWARD. numbers: the error numbers an ERROR handler is for, empty for all."""

    kind: str
    numbers: tuple[Expression, ...]
    body: Block


@_node
class Routine(Node):
    """kind: PROC, FUNC or TRAP. type: what a FUNC returns. body holds data declarations and statements in order."""

    scope: str | None
    kind: str
    type: str | None
    name: str
    parameters: tuple[Parameter, ...]
    body: Block
    handlers: tuple[Handler, ...]


Statement = (
    Assign
    | ProcedureCall
    | LateCall
    | If
    | For
    | While
    | Test
    | Goto
    | Label
    | Return
    | Raise
    | Simple
    | Connect
    | Placeholder
    | DataDeclaration
)
Block = tuple[Statement, ...]
Item = DataDeclaration | RecordDeclaration | AliasDeclaration | Routine | Placeholder


@_node
class Module(Node):
    """One MODULE; name is empty for declarations that stand in a file without one."""

    name: str
    attributes: tuple[str, ...]
    items: tuple[Item, ...]


@_node
class ModuleFile(Node):
    """A file's modules. leftovers: stretches of text outside modules, which never run. comments: their stretches.

    warnings: (offset, sentence) for what is read although it is odd; each leftover has its own there.
    """

    modules: tuple[Module, ...]
    leftovers: tuple[tuple[int, int], ...] = field(compare=False)
    comments: tuple[tuple[int, int], ...] = field(compare=False, repr=False)
    warnings: tuple[tuple[int, str], ...] = field(default=(), compare=False)


def walk(node: object) -> list[Node]:
    """A node of a syntax tree and all nodes under it, in no particular order."""
    stack, found = [node], []
    while stack:
        thing = stack.pop()
        if isinstance(thing, tuple):
            stack += thing
        elif isinstance(thing, Node):
            found.append(thing)
            if is_dataclass(thing):
                stack += [getattr(thing, part.name) for part in fields(thing)]
    return found


def base_of(node: Expression) -> Expression:
    """What an expression is a part of, `p` of `p{2}.trans.x`; itself where it is no part."""
    while isinstance(node, (Component, Element)):
        node = node.base
    return node


def steady(node: Expression, holds: Callable[[Name], bool]) -> bool:
    """Whether an expression has one value all along: no call in it, and only names that hold."""
    match node:
        case Number() | Boolean() | String():
            return True
        case Name():
            return holds(node)
        case Unary():
            return steady(node.operand, holds)
        case Binary():
            return steady(node.left, holds) and steady(node.right, holds)
        case Component():
            return steady(node.base, holds)
        case Element():
            return all(steady(part, holds) for part in (node.base, *node.indices))
    return False
