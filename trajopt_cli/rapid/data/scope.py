"""Where a running program keeps its data: variables, parts of them, module scopes and call frames."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from trajopt_cli.rapid.data.datatypes import Array, Data, Record, Type, Value
from trajopt_cli.rapid.language.syntax import AliasDeclaration, RecordDeclaration, Routine
from trajopt_cli.rapid.language.text import Places


class Datum:
    """One piece of data. Its initial value is computed when somebody first asks, so modules may refer to each other.

    constant: why it may not be assigned to ("a CONST"), None where it may.
    """

    __slots__ = ("_first", "_value", "constant", "type")

    def __init__(self, type_: Type, first: Value | Callable[[], Value], constant: str | None = None):
        self.type, self.constant = type_, constant
        self._value: Value | None = first if isinstance(first, Value) else None
        self._first = first

    @property
    def value(self) -> Value:
        """The value now."""
        if self._value is None:
            assert not isinstance(self._first, Value)
            self._value = self._first()
        return self._value

    @value.setter
    def value(self, value: Value) -> None:
        self._value = value


class Part:
    """A component or an element of a datum, to be assigned to or passed as INOUT."""

    __slots__ = ("base", "index", "type")

    def __init__(self, base: Datum | Part, index: int, type_: Type):
        self.base, self.index, self.type = base, index, type_

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
    """A module's own names and where its text stands."""

    places: Places = field(default_factory=lambda: Places("", ""))


@dataclass(eq=False)
class Frame:
    """One call of a routine: the module it stands in, its local names in lower case, and what it must return."""

    scope: ModuleScope
    local: dict[str, Place | Absent] = field(default_factory=dict)
    returns: Type | None = None


def fits(type_: Type, data: Data) -> bool:
    """Whether nested tuples of finite numbers have the shape of a type made of numbers only."""
    if isinstance(type_, Record):
        if not isinstance(data, tuple) or len(data) != len(type_.components):
            return False
        return all(fits(part, value) for (_, part), value in zip(type_.components, data, strict=True))
    if isinstance(type_, Array):
        if not isinstance(data, tuple) or (type_.sizes and len(data) != type_.sizes[0]):
            return False
        inner = type_.inner()
        return all(fits(inner, value) for value in data)
    return isinstance(type_.default, float) and isinstance(data, float) and data - data == 0
