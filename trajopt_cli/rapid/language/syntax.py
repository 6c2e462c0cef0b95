"""The syntax tree of RAPID. Every node knows its stretch [start, end) of the text; comparing trees ignores it.

Names keep the spelling of the text. An instruction is no grammar: MoveL is a ProcedureCall like any other.
"""

from __future__ import annotations

import json
import re
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from trajopt_cli.rapid.language.lexer import NUMBER


@dataclass(frozen=True, slots=True)
class Node:
    """start, end: offsets into the file's text."""

    start: int = field(compare=False, repr=False)
    end: int = field(compare=False, repr=False)


# ---------------------------------------------------------------------------------------------------- expressions


@dataclass(frozen=True, slots=True)
class Number(Node):
    """A numeric literal with the sign in front of it."""

    value: float


@dataclass(frozen=True, slots=True)
class String(Node):
    """A string literal; value has its escapes resolved."""

    value: str


@dataclass(frozen=True, slots=True)
class Boolean(Node):
    """TRUE or FALSE."""

    value: bool


@dataclass(frozen=True, slots=True)
class Name(Node):
    """A name standing for data, a signal or a routine."""

    name: str


@dataclass(frozen=True, slots=True)
class Component(Node):
    """`base.name`."""

    base: Expression
    name: str


@dataclass(frozen=True, slots=True)
class Element(Node):
    """`base{index, ...}`."""

    base: Expression
    indices: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class Argument(Node):
    r"""One argument. name: of an optional one, without its backslash; value None for a bare switch.

    forward: `\name?value`, passed on only if the optional parameter that value names is present.
    """

    name: str | None
    value: Expression | None
    forward: bool = False


@dataclass(frozen=True, slots=True)
class Call(Node):
    """A function call, `name(args)`."""

    name: str
    args: tuple[Argument, ...]


@dataclass(frozen=True, slots=True)
class Unary(Node):
    """operator: "-", "+" or "NOT"."""

    operator: str
    operand: Expression


@dataclass(frozen=True, slots=True)
class Binary(Node):
    """operator: one of * / DIV MOD + - < > <= >= = <> AND XOR OR."""

    operator: str
    left: Expression
    right: Expression


@dataclass(frozen=True, slots=True)
class Placeholder(Node):
    """Unfinished code such as <EXP>; `*` for a target that the text does not hold. Legal to load, not to run."""

    name: str


@dataclass(frozen=True, eq=False)
class Aggregate(Node):
    """`[a, [b, c]]`. Made from its items, or from the text of a plain numeric one, opened only when looked into."""

    text: str | None = field(default=None, repr=False)
    given: tuple[Expression, ...] = field(default=(), repr=False)

    @cached_property
    def items(self) -> tuple[Expression, ...]:
        """The items as nodes of their own."""
        return self.given if self.text is None else _open(self.text, self.start)

    @cached_property
    def numbers(self) -> Numbers | None:
        """The values as nested tuples when every one is a number, else None."""
        if self.text is not None:
            try:
                return _tuples(json.loads(self.text))
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


Numbers = tuple["Numbers | float", ...]
Expression = Number | String | Boolean | Name | Component | Element | Call | Unary | Binary | Placeholder | Aggregate

_PART = re.compile(rf"[\[\],]|[+-]?{NUMBER.pattern}")


def _open(text: str, start: int) -> tuple[Expression, ...]:
    stack: list[tuple[int, list[Expression]]] = []
    for match in _PART.finditer(text):
        part, place = match[0], start + match.start()
        if part == "[":
            stack.append((place, []))
        elif part == "]":
            opened, items = stack.pop()
            if not stack:
                return tuple(items)
            stack[-1][1].append(Aggregate(opened, place + 1, given=tuple(items)))
        elif part != ",":
            stack[-1][1].append(Number(place, start + match.end(), float(part)))
    raise ValueError(f"not a plain numeric aggregate: {text!r}")


def _tuples(values: list[Any]) -> Numbers:
    return tuple(_tuples(v) if isinstance(v, list) else float(v) for v in values)


# ----------------------------------------------------------------------------------------------------- statements


@dataclass(frozen=True, slots=True)
class Assign(Node):
    """`target := value;`."""

    target: Expression
    value: Expression


@dataclass(frozen=True, slots=True)
class ProcedureCall(Node):
    """`name args;`: an instruction or a procedure of the program."""

    name: str
    args: tuple[Argument, ...]


@dataclass(frozen=True, slots=True)
class LateCall(Node):
    """`%name% args;`: the procedure whose name is the value of an expression."""

    name: Expression
    args: tuple[Argument, ...]


@dataclass(frozen=True, slots=True)
class If(Node):
    """branches: conditions with their blocks. compact: `IF condition statement`, without THEN."""

    branches: tuple[tuple[Expression, Block], ...]
    otherwise: Block
    compact: bool = False


@dataclass(frozen=True, slots=True)
class For(Node):
    """`FOR name FROM first TO last [STEP step] DO`."""

    name: str
    first: Expression
    last: Expression
    step: Expression | None
    body: Block


@dataclass(frozen=True, slots=True)
class While(Node):
    """`WHILE condition DO`."""

    condition: Expression
    body: Block


@dataclass(frozen=True, slots=True)
class Test(Node):
    """`TEST subject CASE a,b: ... DEFAULT: ...`; default None where there is none."""

    subject: Expression
    cases: tuple[tuple[tuple[Expression, ...], Block], ...]
    default: Block | None


@dataclass(frozen=True, slots=True)
class Goto(Node):
    """`GOTO label;`."""

    label: str


@dataclass(frozen=True, slots=True)
class Label(Node):
    """`name:`."""

    name: str


@dataclass(frozen=True, slots=True)
class Return(Node):
    """`RETURN [value];`."""

    value: Expression | None


@dataclass(frozen=True, slots=True)
class Raise(Node):
    """`RAISE [number];`."""

    value: Expression | None


@dataclass(frozen=True, slots=True)
class Simple(Node):
    """A statement that is one word: EXIT, RETRY, TRYNEXT."""

    word: str


@dataclass(frozen=True, slots=True)
class Connect(Node):
    """`CONNECT interrupt WITH trap;`."""

    interrupt: Expression
    trap: str


# --------------------------------------------------------------------------------------------------- declarations


@dataclass(frozen=True, slots=True)
class DataDeclaration(Node):
    """scope: LOCAL, TASK or None. storage: VAR, PERS or CONST. sizes: up to three, constant expressions."""

    scope: str | None
    storage: str
    type: str
    name: str
    sizes: tuple[Expression, ...]
    value: Expression | None


@dataclass(frozen=True, slots=True)
class RecordDeclaration(Node):
    """components: (type, name) in order."""

    scope: str | None
    name: str
    components: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True)
class AliasDeclaration(Node):
    """`ALIAS type name;`."""

    scope: str | None
    type: str
    name: str


@dataclass(frozen=True, slots=True)
class Parameter(Node):
    """mode: None (a copy), INOUT, VAR or PERS. dimensions: 0 for a plain value. alternative: after a `|`."""

    mode: str | None
    type: str
    name: str
    dimensions: int = 0
    optional: bool = False
    alternative: bool = False


@dataclass(frozen=True, slots=True)
class Handler(Node):
    """kind: ERROR, UNDO or BACKWARD. numbers: the error numbers an ERROR handler is for, empty for all."""

    kind: str
    numbers: tuple[Expression, ...]
    body: Block


@dataclass(frozen=True, slots=True)
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


@dataclass(frozen=True, slots=True)
class Module(Node):
    """One MODULE; name is empty for declarations that stand in a file without one."""

    name: str
    attributes: tuple[str, ...]
    items: tuple[Item, ...]


@dataclass(frozen=True, slots=True)
class ModuleFile(Node):
    """A file's modules. leftovers: stretches of text outside modules, which never run. comments: their stretches.

    warnings: (offset, sentence) for what is read although it is odd; each leftover has its own there.
    """

    modules: tuple[Module, ...]
    leftovers: tuple[tuple[int, int], ...] = field(compare=False)
    comments: tuple[tuple[int, int], ...] = field(compare=False, repr=False)
    warnings: tuple[tuple[int, str], ...] = field(default=(), compare=False)
