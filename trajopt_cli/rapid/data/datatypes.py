"""RAPID's data types and values.

A record's or array's data is a nested tuple; a component or an element is changed by building the tuple anew, so a
value can be passed on freely. num is kept as float64 although the controller rounds it to float32: a rounding of 6e-8
of the value moves no target by a micrometre, and numbers that nobody changes shall come out as they were written.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

from trajopt_cli.motion import Span
from trajopt_cli.rapid.language.syntax import Aggregate


@dataclass(frozen=True, slots=True)
class Atomic:
    """num, dnum, bool, string, and the types without a value of their own such as signals and clocks."""

    name: str
    default: Any = None


@dataclass(frozen=True, slots=True)
class Record:
    """components: names (lower case) and types in order."""

    name: str
    components: tuple[tuple[str, Type], ...]

    @property
    def default(self) -> Data:
        """All components at theirs: an uninitialised robtarget has no valid orientation."""
        return tuple(type_.default for _, type_ in self.components)


@dataclass(frozen=True, slots=True)
class Array:
    """sizes: None where a parameter leaves them open."""

    element: Type
    sizes: tuple[int, ...] | None
    dimensions: int

    @property
    def name(self) -> str:
        """As in messages."""
        return f"{self.element.name}{{{','.join('*' * self.dimensions)}}}"

    @property
    def default(self) -> Data:
        """All elements at theirs."""
        data = self.element.default
        for size in reversed(self.sizes or ()):
            data = (data,) * size
        return data

    def inner(self) -> Type:
        """The type one dimension further in."""
        if self.dimensions == 1:
            return self.element
        return Array(self.element, self.sizes[1:] if self.sizes else None, self.dimensions - 1)


Type = Atomic | Record | Array
# Whatever the type says: a float, a bool, a str, a nested tuple of them, None for a type without values. Checked
# against the type when a value is made, so it is not checked again by Python's types.
Data = Any


class Origin(NamedTuple):
    """The literal that a value was copied from, unchanged: where an export can edit it. declaration: around it."""

    file: str
    literal: Aggregate
    declaration: Span | None

    def item(self, index: int) -> Origin | None:
        """The literal of one component or element, where that is an aggregate itself."""
        items = self.literal.items
        inner = items[index] if index < len(items) else None
        return Origin(self.file, inner, self.declaration) if isinstance(inner, Aggregate) else None


class Value(NamedTuple):
    """A value with its type, and the literal it came from (None when it was computed)."""

    type: Type
    data: Data
    origin: Origin | None = None


NUM, DNUM = Atomic("num", 0.0), Atomic("dnum", 0.0)
BOOL, STRING = Atomic("bool", False), Atomic("string", "")
SWITCH = Atomic("switch", True)


def _record(name: str, **components: Type) -> Record:
    return Record(name, tuple(components.items()))


def _nums(name: str, components: str) -> Record:
    return Record(name, tuple((component, NUM) for component in components.split()))


POS = _nums("pos", "x y z")
ORIENT = _nums("orient", "q1 q2 q3 q4")
POSE = _record("pose", trans=POS, rot=ORIENT)
CONFDATA = _nums("confdata", "cf1 cf4 cf6 cfx")
EXTJOINT = _nums("extjoint", "eax_a eax_b eax_c eax_d eax_e eax_f")
ROBJOINT = _nums("robjoint", "rax_1 rax_2 rax_3 rax_4 rax_5 rax_6")
ROBTARGET = _record("robtarget", trans=POS, rot=ORIENT, robconf=CONFDATA, extax=EXTJOINT)
JOINTTARGET = _record("jointtarget", robax=ROBJOINT, extax=EXTJOINT)
LOADDATA = _record("loaddata", mass=NUM, cog=POS, aom=ORIENT, ix=NUM, iy=NUM, iz=NUM)
TOOLDATA = _record("tooldata", robhold=BOOL, tframe=POSE, tload=LOADDATA)
WOBJDATA = _record("wobjdata", robhold=BOOL, ufprog=BOOL, ufmec=STRING, uframe=POSE, oframe=POSE)
SPEEDDATA = _nums("speeddata", "v_tcp v_ori v_leax v_reax")
ZONEDATA = Record(
    "zonedata",
    (
        ("finep", BOOL),
        *((name, NUM) for name in ("pzone_tcp", "pzone_ori", "pzone_eax", "zone_ori", "zone_leax", "zone_reax")),
    ),
)

SIGNALS = frozenset({"signaldi", "signaldo", "signalgi", "signalgo", "signalai", "signalao"})
_RECORDS = (
    POS, ORIENT, POSE, CONFDATA, EXTJOINT, ROBJOINT, ROBTARGET, JOINTTARGET,
    LOADDATA, TOOLDATA, WOBJDATA, SPEEDDATA, ZONEDATA,
)  # fmt: skip
# Types the program can name; those without a default value exist, but nothing here can compute with them.
TYPES: dict[str, Type] = {
    **{type_.name: type_ for type_ in (NUM, DNUM, BOOL, STRING, SWITCH, *_RECORDS)},
    **{name: Atomic(name) for name in (*sorted(SIGNALS), "clock", "triggdata", "iodev", "socketdev", "shapedata")},
    **{name: NUM for name in ("intnum", "errnum", "tpnum")},
}


def same_type(a: Type, b: Type) -> bool:
    """Whether a value of one type may stand for the other; open array sizes fit any."""
    if isinstance(a, Array) and isinstance(b, Array):
        fits = a.sizes is None or b.sizes is None or a.sizes == b.sizes
        return fits and a.dimensions == b.dimensions and same_type(a.element, b.element)
    return a == b


def is_number(type_: Type) -> bool:
    """Whether it is num or dnum."""
    return type_ is NUM or type_ is DNUM or type_ in (NUM, DNUM)
