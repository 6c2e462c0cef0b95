"""Where a running program keeps its data, its errors, and the exceptions by which a statement leaves its place.

Data: variables, parts of them, module scopes and call frames.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from trajopt_cli.errors import InputError
from trajopt_cli.motion import Source
from trajopt_cli.rapid.data.datatypes import Array, Atomic, Record, Type, Value
from trajopt_cli.rapid.language.syntax import AliasDeclaration, Argument, Expression, Goto, RecordDeclaration, Routine
from trajopt_cli.rapid.language.text import Places
from trajopt_cli.scenario import asked


class Fault(InputError):
    """A run-time error of the controller, such as a division by zero. Unhandled it is the user's InputError.

    number: what ERRNO is while it is handled. name: the ERR_ constant, or the number in words. passed: the CallFrame
    whose handler has let it pass. point: the CallFrame whose handler a long jump leads to.
    """

    def __init__(self, message: str, name: str, number: float, place: Source):
        super().__init__(message, file=place.file, line=place.line, column=place.column)
        self.name, self.number = name, number
        self.passed: object = None
        self.point: object = None


class _Placed(InputError):
    """An error at the place of another one."""

    def __init__(self, message: str, place: InputError):
        super().__init__(message, file=place.file, line=place.line, column=place.column, excerpt=place.excerpt)


class Undeclared(_Placed):
    """A name that stands for nothing in the files read: another file may declare it.

    reason: without the remedy. close: the known name that may be meant.
    """

    def __init__(self, place: InputError, close: str | None, remedy: str = "give the file that declares it"):
        """place: the reason, at its place."""
        super().__init__(f"{asked(place.message, close)} {remedy}", place)
        self.reason, self.close = place.message, close


class Mismatch(_Placed):
    """A value of another type than its place asks for. node: the expression. claim: "needs a num, found bool TRUE".

    Who knows what the place is called says so: the nearest one.
    """

    def __init__(self, node: Expression, claim: str, place: InputError):
        super().__init__(f"needs {claim}", place)
        self.node, self._claim, self._named = node, claim, False

    def about(self, node: Expression | None, subject: str) -> Mismatch:
        """Itself, with what needs the value where that is the place of node."""
        if node is self.node and not self._named:
            self.message, self._named = f"{subject} needs {self._claim}", True
            self.args = (self.message,)
        return self


# ----------------------------------------------------------------------------------------------------- control flow


class Exit(Exception):
    """The program says that it is over."""


class Return(Exception):
    """RETURN was run; value None in a PROC."""

    def __init__(self, value: Value | None):
        self.value = value


class Jump(Exception):
    """GOTO was run."""

    def __init__(self, node: Goto):
        self.node = node


class Retry(Exception):
    """RETRY was run."""


class TryNext(Exception):
    """TRYNEXT was run."""


class Datum:
    """One piece of data. Its initial value is computed when somebody first asks, so modules may refer to each other.

    storage: VAR, PERS or CONST. constant: why it may not be assigned to ("a CONST (line 7)"), None where it may; given
    as the declaration's place where that is enough to say it.
    """

    __slots__ = ("_constant", "_first", "storage", "type", "value")
    type: Type
    value: Value  # unset until asked for, then __getattr__ computes it

    def __init__(
        self,
        type_: Type,
        first: Value | Callable[[], Value],
        constant: str | tuple[Places, int] | None = None,
        storage: str = "VAR",
    ):
        self.type, self.storage, self._constant = type_, storage, constant
        if type(first) is Value:
            self.value = first
        else:
            self._first = first

    def __getattr__(self, name: str) -> Value:
        if name != "value":
            raise AttributeError(name)
        first = self._first
        assert not isinstance(first, Value)
        self.value = first()
        del self._first  # it knows the run, and so the run itself: a circle that would keep every tree
        return self.value

    def take(self, other: Datum) -> None:
        """Begin with another's initial value."""
        if hasattr(other, "_first"):
            self._first = other._first
            del self.value
        else:
            self.value = other.value

    @property
    def declared_constant(self) -> bool:
        """Whether a CONST declares it: the same all along, unlike a loop's variable."""
        return isinstance(self._constant, tuple)

    @property
    def constant(self) -> str | None:
        """Why it may not be assigned to, None where it may."""
        if isinstance(self._constant, tuple):
            places, start = self._constant
            return f"a CONST (line {places.line(start)})"
        return self._constant


UNTYPED = Atomic("data")  # of data that nothing declares, until a place that asks for it tells its type


class ExternalDatum(Datum):
    """Data that the cell file gives; see external_data.py.

    name: in lower case. tell: the cell file's value that the next reading gives. assigned: what counts instead, once
    the program or a wait gave it one.
    """

    __slots__ = ("assigned", "name", "tell")

    def __init__(self, name: str, tell: Callable[[ExternalDatum], Value], type_: Type = UNTYPED):
        self.name, self.tell, self.type, self.storage, self._constant = name, tell, type_, "PERS", None
        self.assigned: Value | None = None

    @property
    def typed(self) -> bool:
        """Whether its type is known."""
        return self.type is not UNTYPED

    @property
    def value(self) -> Value:
        """What a reading gives."""
        return self.tell(self) if self.assigned is None else self.assigned

    @value.setter
    def value(self, value: Value) -> None:
        self.assigned = value


class Part:
    """A component or an element of a datum, to be assigned to or passed as INOUT."""

    __slots__ = ("base", "index", "type")

    def __init__(self, base: Datum | Part, index: int, type_: Type):
        self.base, self.index, self.type = base, index, type_

    @property
    def storage(self) -> str:
        """As of the whole datum."""
        return self.base.storage

    @property
    def constant(self) -> str | None:
        """As of the whole datum."""
        return self.base.constant

    @property
    def value(self) -> Value:
        """The value now; it knows its literal as long as the whole one does."""
        return item(self.base.value, self.index, self.type)

    @value.setter
    def value(self, value: Value) -> None:
        whole = self.base.value
        data = whole.data
        assert isinstance(data, tuple)
        self.base.value = Value(whole.type, (*data[: self.index], value.data, *data[self.index + 1 :]))


Place = Datum | Part


def item(whole: Value, index: int, type_: Type) -> Value:
    """A component or an element of a value."""
    data = whole.data
    assert isinstance(data, tuple)
    # Only a record inside (a target in an array) has a literal that somebody may want to edit.
    origin = whole.origin.item(index) if whole.origin and isinstance(type_, (Record, Array)) else None
    return Value(type_, data[index], origin)


class Absent:
    """Stands in a frame for an optional parameter that the caller left out."""


ABSENT = Absent()


@dataclass(eq=False)
class Scope:
    """The names of one module, or those that all modules share; in lower case. Types resolve when first used."""

    data: dict[str, Datum] = field(default_factory=dict)
    routines: dict[str, tuple[Routine, ModuleScope]] = field(default_factory=dict)
    types: dict[str, tuple[RecordDeclaration | AliasDeclaration, ModuleScope]] = field(default_factory=dict)


@dataclass(eq=False)
class ModuleScope(Scope):
    """A module's own names and where its text stands.

    resolved: the types that it has named so far; outside: the data of other modules, and predefined data; both by the
    name as spelled there.
    """

    places: Places = field(default_factory=lambda: Places("", ""))
    name: str = ""
    resolved: dict[str, Type] = field(default_factory=dict)
    outside: dict[str, Datum] = field(default_factory=dict)


@dataclass(eq=False, slots=True)
class CallFrame:
    """One call of a routine: the module it stands in, its local names in lower case, and what it must return.

    routine: None while a module's data is computed. caller: the call that called this one. given: the arguments as the
    caller wrote them, with the frame they stand in. handling: the error that its ERROR handler is busy with. retried:
    the statement that was last tried again, how often it had run then, and how many times it was tried again in a row.
    motions: how many there were when the routine began. passes, turns: of its GOTO loops, by the GOTO's id: passes so
    far; motions before the present one and passes that counted. counters: the values of the FOR loops that run, the
    outermost first.
    """

    scope: ModuleScope
    local: dict[str, Place | Absent] = field(default_factory=dict)
    returns: Type | None = None
    routine: Routine | None = None
    caller: CallFrame | None = None
    given: dict[str, tuple[Argument, CallFrame]] = field(default_factory=dict)
    handling: Fault | None = None
    retried: tuple[int, int, int] = (0, 0, 0)
    motions: int = 0
    passes: dict[int, int] = field(default_factory=dict)
    turns: dict[int, tuple[int, int]] = field(default_factory=dict)
    counters: tuple[float, ...] = ()


@dataclass(frozen=True)
class Head:
    """What a routine takes and gives, worked out once. groups: mutually exclusive optional parameters, as spelled."""

    types: tuple[Type, ...]
    returns: Type | None
    required: tuple[str, ...]
    groups: tuple[tuple[str, ...], ...]


class State(NamedTuple):
    """How many motions, warnings, missing values and refusals there are at the end of a pass, how often each statement
    ran, and each instruction without effect."""

    motions: int
    warnings: int
    missing: int
    refusals: int
    counts: Mapping[int, int]
    ignored: Counter[str]


@dataclass
class Passes:
    """The passes of one loop that counted. marks: where they begin and end in the motions. leaves: the loop may take a
    way out, and nobody says after how many passes it is over; repeats: the first of these passes do. ends: of the
    first passes."""

    loop: str
    source: Source
    marks: list[int]
    leaves: bool
    ends: list[State] = field(default_factory=list)
    count: int = 0
    repeats: bool = False


class Cycle(NamedTuple):
    """Motions from first up to, not including, last, in so many passes. beyond: where those end that are other ones."""

    first: int
    last: int
    passes: int
    closed: bool = True
    beyond: int = 0
