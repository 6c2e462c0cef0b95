"""RAPID's data types and values.

A record's or array's data is a nested tuple; a component or an element is changed by building the tuple anew, so a
value can be passed on freely. A num is a 32-bit float as on the controller, held as the Python float that it rounds to:
every literal and every result is rounded (single, Layout). A dnum is a Python float.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import chain, pairwise
from math import isfinite
from struct import Struct
from typing import Any, NamedTuple

from trajopt_cli.motion import Span
from trajopt_cli.rapid.language.syntax import Aggregate
from trajopt_cli.scenario import NUM_LIMIT as NUM_LIMIT

STRING_LIMIT = 80  # characters
SIZE_LIMIT = 1_000_000  # elements of an array; plain values in one record
ARRAY_LIMIT = 10_000_000  # plain values in one array: elements that nobody has written yet are shared
DEPTH_LIMIT = 30  # records in records

_SINGLE = Struct("=f")


def single(value: float) -> float:
    """The num nearest to a number. Raises OverflowError beyond NUM_LIMIT."""
    rounded: float = _SINGLE.unpack(_SINGLE.pack(value))[0]
    if rounded - rounded:  # infinite
        raise OverflowError
    return rounded


@dataclass(frozen=True)
class Atomic:
    """num, dnum, bool, string, and the types whose values mean nothing here, such as signals, clocks and welddata.

    default: None for the latter. known: False for a type that is not declared anywhere.
    """

    name: str
    default: Any = None
    known: bool = True

    size = 1
    depth = 0
    layout = None  # only records and arrays have one


@dataclass(frozen=True)
class Record:
    """components: names (lower case) and types in order."""

    name: str
    components: tuple[tuple[str, Type], ...]
    known = True

    @cached_property
    def default(self) -> Data:
        """All components at theirs: an uninitialised robtarget has no valid orientation."""
        return tuple(type_.default for _, type_ in self.components)

    @cached_property
    def size(self) -> int:
        """How many plain values it holds."""
        return sum(type_.size for _, type_ in self.components)

    @cached_property
    def depth(self) -> int:
        """How many records deep it is."""
        return 1 + max((type_.depth for _, type_ in self.components), default=0)

    @cached_property
    def layout(self) -> Layout | None:
        """How its numbers lie, None where it holds anything else."""
        return Layout.of(self)


@dataclass(frozen=True)
class Array:
    """sizes: None where a parameter leaves them open."""

    element: Type
    sizes: tuple[int, ...] | None
    dimensions: int
    known = True

    @property
    def name(self) -> str:
        """As in messages."""
        return f"{self.element.name}{{{','.join('*' * self.dimensions)}}}"

    @cached_property
    def default(self) -> Data:
        """All elements at theirs."""
        data = self.element.default
        for size in reversed(self.sizes or ()):
            data = (data,) * size
        return data

    @cached_property
    def size(self) -> int:
        """How many plain values it holds."""
        count = self.element.size
        for size in self.sizes or ():
            count *= size
        return count

    @property
    def depth(self) -> int:
        """As its elements."""
        return self.element.depth

    @cached_property
    def layout(self) -> Layout | None:
        """How its numbers lie, None where it holds anything else or its size is open."""
        return Layout.of(self)

    @cached_property
    def inside(self) -> Type:
        """The type one dimension further in."""
        if self.dimensions == 1:
            return self.element
        return Array(self.element, self.sizes[1:] if self.sizes else None, self.dimensions - 1)


Type = Atomic | Record | Array
# Whatever the type says: a float, a bool, a str, a nested tuple of them, None for a type without values. Checked
# against the type when a value is made, so it is not checked again by Python's types.
Data = Any


class Opaque(str):
    """The value of a type that means nothing here (welddata ...), as written, where it is not made of numbers only."""

    __slots__ = ()


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


# --------------------------------------------------------------------------------------------------------- layouts

# For str.translate: what numbers are written with is left out. What else there is stays, and spoils the shape.
_SHAPE = dict.fromkeys(map(ord, "0123456789.eE+- \t\r\n"))
_RUN = re.compile(r"(.)\1*+")


class Layout:
    """How the numbers of a record or array lie one after the other: literals of numbers are read and rounded at once.

    A program of a hundred thousand targets is little else, so this must be quick.
    """

    __slots__ = ("_bounds", "_shape", "_struct", "_type")

    def __init__(self, type_: Record | Array, formats: str, shape: str):
        # "17f" for "fff...": a format of its own for each number of a large array takes more room than the numbers.
        counted = _RUN.sub(lambda run: f"{len(run[0])}{run[1]}", formats)
        self._type, self._shape, self._struct = type_, shape, Struct(f"={counted}")
        self._bounds: list[tuple[int, int]] | None = None  # of the parts, where every part is a plain record of numbers
        parts = _parts(type_)
        if all(
            isinstance(part, Record) and all(inner in (NUM, DNUM) for _, inner in part.components) for part in parts
        ):
            ends = [0]
            for part in parts:
                ends.append(ends[-1] + part.size)
            self._bounds = list(pairwise(ends))

    @staticmethod
    def of(type_: Record | Array) -> Layout | None:
        """The layout of a type, None where it holds anything but numbers, or too many."""
        if type_.size > ARRAY_LIMIT or (isinstance(type_, Array) and not type_.sizes):
            return None
        described = _described(type_)
        return None if described is None else Layout(type_, *described)

    def read(self, text: str) -> Data | None:
        """The value of an aggregate as written, None where it is anything but the type's numbers."""
        if text.translate(_SHAPE) != self._shape:
            return None
        flat = map(float, text.replace("[", "").replace("]", "").split(","))
        try:
            values = self._struct.unpack(self._struct.pack(*flat))
        except (OverflowError, ValueError):
            return None
        return self._nest(values) if isfinite(sum(values)) else None

    def rounded(self, data: Data) -> Data:
        """A value of the type with every num in it rounded. Raises OverflowError beyond NUM_LIMIT."""
        return self._nest(self._struct.unpack(self._struct.pack(*_flat(data))))

    def _nest(self, flat: tuple[float, ...]) -> Data:
        if self._bounds is not None:
            return tuple([flat[start:end] for start, end in self._bounds])
        type_ = self._type
        if isinstance(type_, Array) and type_.inside.layout is not None:
            nest, step = type_.inside.layout._nest, type_.inside.size
            return tuple([nest(flat[start : start + step]) for start in range(0, len(flat), step)])
        return _nested(type_, iter(flat))


def _parts(type_: Record | Array) -> Iterable[Type]:
    if isinstance(type_, Record):
        return [part for _, part in type_.components]
    assert type_.sizes
    return [type_.inside] * type_.sizes[0]


def _described(type_: Type) -> tuple[str, str] | None:
    """The struct formats of a type's numbers and the brackets and commas of its literal; None for other values."""
    if isinstance(type_, Atomic):
        return ("f" if type_ is NUM else "d", "") if is_number(type_) else None
    if isinstance(type_, Array):
        inner, count = _described(type_.inside), (type_.sizes or (1,))[0]
        return None if inner is None else (inner[0] * count, f"[{','.join([inner[1]] * count)}]")
    found = [one for _, part in type_.components if (one := _described(part)) is not None]
    if len(found) < len(type_.components):
        return None
    return "".join(formats for formats, _ in found), f"[{','.join(shape for _, shape in found)}]"


def _flat(data: Data) -> Iterator[float]:
    if data and isinstance(data[0], float) and all(isinstance(part, float) for part in data):
        return iter(data)
    return chain.from_iterable(_flat(part) if isinstance(part, tuple) else (part,) for part in data)


def _nested(type_: Type, flat: Iterator[float]) -> Data:
    if isinstance(type_, Atomic):
        return next(flat)
    return tuple([_nested(part, flat) for part in _parts(type_)])


# ------------------------------------------------------------------------------------------------- predefined types


# Records with their components; one without a type is a num.
_RECORDS = """
    pos x y z
    orient q1 q2 q3 q4
    pose trans:pos rot:orient
    confdata cf1 cf4 cf6 cfx
    extjoint eax_a eax_b eax_c eax_d eax_e eax_f
    robjoint rax_1 rax_2 rax_3 rax_4 rax_5 rax_6
    robtarget trans:pos rot:orient robconf:confdata extax:extjoint
    jointtarget robax:robjoint extax:extjoint
    loaddata mass cog:pos aom:orient ix iy iz
    tooldata robhold:bool tframe:pose tload:loaddata
    wobjdata robhold:bool ufprog:bool ufmec:string uframe:pose oframe:pose
    speeddata v_tcp v_ori v_leax v_reax
    zonedata finep:bool pzone_tcp pzone_ori pzone_eax zone_ori zone_leax zone_reax
    progdisp pdisp:pose eoffs:extjoint
    veldata oride max
    accdata acc ramp finepramp
    singdata wrist:bool lockaxis4:bool arm:bool base:bool
    confsupdata jsup:bool lsup:bool ax1 ax4 ax6
    motsetdata vel:veldata acc:accdata sing:singdata conf:confsupdata pathresol motionsup:bool tunevalue acclim:bool \
        accmax decellim:bool decelmax cirpathreori worldacclim:bool worldaccmax evtbufferact:bool \
        corner_path_warn_suppress:bool
    inposdata position speed mintime maxtime
    stoppointdata type progsynch:bool inpos:inposdata stoptime followtime signal:string relation checkvalue
    listitem image:string text:string
    tasks taskname:string
"""
SIGNALS = frozenset({"signaldi", "signaldo", "signalgi", "signalgo", "signalai", "signalao"})
# Other names of num.
_NUMBERS = """
    aiotrigg btnres busstate buttondata byte camerastatus capstopmode dionum egmframetype egmstate egmstopmode
    errdomain errnum errtype event_type exec_level fcframe handler_type icondata identno intnum iounit_state
    loadidnum opcalc opernum paridnum paridvalidnum signalorigin socketstatus stoppoint symnum taskid tpnum triggflag
    triggmode tunetype uishownum
"""
# Types that exist, and that nothing here can compute with: their values are carried along as written.
_OPAQUE = """
    arcdata beaddata cameradev cameraextdata camerasortdata cameratarget capdata caplatrackdata capspeeddata
    captrackdata capweavedata clock cnvcmd corrdescr cssframe datapos dir dispdata egm_minmax egmident equipdata
    fcboxvol fccondstatus fccylindervol fcdamping fcforcevector fclindir fcprocessdata fcrotdir fcspeedvector
    fcspherevol forcedata gundata iodev itmsrc itmtgt mecunit percdata procdata rawbytes restartblkdata restartdata
    rmqheader rmqmessage rmqslot seamdata selectiondata sensor shapedata simdata smeqdata socketdev sortdata
    spotdata supervdata syncident trackdata trapdata triggdata triggios triggiosdnum triggstrgo weavedata
    weavestartdata welddata wzstationary wztemporary
"""
# Types the program can name.
TYPES: dict[str, Type] = {type_.name: type_ for type_ in (NUM, DNUM, BOOL, STRING, SWITCH)}


def _record(name: str) -> Record:
    found = TYPES[name]
    assert isinstance(found, Record)
    return found


for _name, *_components in (_line.split() for _line in _RECORDS.strip().splitlines()):
    _typed = (_component.partition(":") for _component in _components)
    TYPES[_name] = Record(_name, tuple((_one, TYPES[_type or "num"]) for _one, _, _type in _typed))
TYPES |= {
    **{name: Atomic(name) for name in (*sorted(SIGNALS), *_OPAQUE.split())},
    **dict.fromkeys(_NUMBERS.split(), NUM),
    **dict.fromkeys(("errstr",), STRING),
}
POS, ORIENT, POSE, CONFDATA, EXTJOINT = map(_record, ("pos", "orient", "pose", "confdata", "extjoint"))
ROBTARGET, JOINTTARGET = map(_record, ("robtarget", "jointtarget"))
LOADDATA, TOOLDATA, WOBJDATA = map(_record, ("loaddata", "tooldata", "wobjdata"))
SPEEDDATA, ZONEDATA, PROGDISP = map(_record, ("speeddata", "zonedata", "progdisp"))
MOTSETDATA = _record("motsetdata")
MODAL = (MOTSETDATA, *map(_record, ("accdata", "singdata", "confsupdata")))
# Components of a motsetdata, and of the records in it, whose values nothing here keeps up to date.
_UNFOLLOWED = """
    finepramp arm ax1 ax4 ax6 pathresol motionsup tunevalue cirpathreori evtbufferact corner_path_warn_suppress
"""
UNFOLLOWED = frozenset(_UNFOLLOWED.split())


def convertible(wanted: Type, given: Type) -> bool:
    """Whether a value may be used where another type is asked for: num and dnum mix, all else is strict."""
    return (is_number(wanted) and is_number(given)) or same_type(wanted, given)


def same_type(a: Type, b: Type) -> bool:
    """Whether a value of one type may stand for the other; open array sizes fit any."""
    if a is b:
        return True
    if isinstance(a, Array) and isinstance(b, Array):
        fits = a.sizes is None or b.sizes is None or a.sizes == b.sizes
        return fits and a.dimensions == b.dimensions and same_type(a.element, b.element)
    return a == b


def is_number(type_: Type) -> bool:
    """Whether it is num or dnum."""
    return type_ is NUM or type_ is DNUM


def is_opaque(type_: Type) -> bool:
    """Whether its values (or its elements') mean nothing here and are carried along as written."""
    while isinstance(type_, Array):
        type_ = type_.element
    return isinstance(type_, Atomic) and type_.default is None
