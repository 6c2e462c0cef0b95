"""What a program cannot know about its world, as the user tells it, and what is still missing."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import radians
from typing import NamedTuple

from trajopt_cli.errors import ErrorKind, InputError, InputErrorGroup
from trajopt_cli.motion import FreeTurn, Source

Answer = float | bool | str


@dataclass(frozen=True)
class Given:
    """A value of data, or a sequence. type: RAPID's name for it, None where the program or the value itself tells."""

    value: Answer | tuple[Answer, ...]
    type: str | None = None


class Lines(NamedTuple):
    """Lines of a program, first to last. file: a path or the end of one, None for the only file."""

    file: str | None
    first: int
    last: int

    def __str__(self) -> str:
        lines = f"{self.first}" if self.first == self.last else f"{self.first}-{self.last}"
        return f"{self.file}:{lines}" if self.file else lines


@dataclass(frozen=True)
class ConstantSpeed:
    """Where lines and arcs should keep their programmed speed from end to end, because a process runs.

    procedures: while these run, with all that they call; names in lower case. lines: while the statements that begin
    there run.
    """

    procedures: frozenset[str] = frozenset()
    lines: frozenset[Lines] = frozenset()


@dataclass(frozen=True)
class HoldRail:
    """Where the rail must stand still, because a process runs or a gripper works.

    procedures: while these run, with all that they call; names in lower case. lines: while the statements that begin
    there run. waits: during every wait. gripper: during a wait that begins at most 0.1 s after an output was set. Of
    both, None: as free says. free: the waits in which it may move, all or, with its place in the cell file, by line, by
    procedure or by what is waited for; in others it stands still.
    """

    procedures: frozenset[str] = frozenset()
    lines: frozenset[Lines] = frozenset()
    waits: bool | None = None
    gripper: bool | None = None
    free: bool | Mapping[str | Lines, Source] = False


class FreeTool(NamedTuple):
    """Where the tool may be turned about an axis of its own. place: in the cell file. names: of procedures, with all
    that they call, of instructions and of tools, as spelled; lines: while the statements that begin there run. Without
    either everywhere."""

    turn: FreeTurn
    place: Source
    names: tuple[str, ...] = ()
    lines: tuple[Lines, ...] = ()


class RailPlace(NamedTuple):
    """Where the rail stands [m] for targets that leave it open; name: of a point, a routine or an output with its value
    ("doRail = 2"), as spelled; place: in the cell file."""

    name: str
    d: float
    place: Source


@dataclass(frozen=True)
class PositionerAxis:
    """One axis of a positioner: eax, 0 for eax_a. p [m], q (w, x, y, z): the frame about whose z it turns, or along
    whose z it slides, in the world or on the axis before it. range, start [rad or m], velocity [1/s], acceleration
    [1/s2]."""

    eax: int
    p: tuple[float, float, float]
    q: tuple[float, float, float, float]
    range: tuple[float, float]
    velocity: float
    acceleration: float
    start: float
    source: str
    slides: bool = False

    @property
    def unit(self) -> float:
        """What RAPID's unit of its values is in SI: mm or degrees."""
        return 1e-3 if self.slides else radians(1.0)


class RailUnit(NamedTuple):
    """The rail as a mechanical unit: its logical axis (0 for eax_a), and its name, None where nobody says it; more: the
    other axes that carry the base."""

    eax: int
    unit: str | None = None
    more: tuple[int, ...] = ()


class Follower(NamedTuple):
    """An external axis (0 for eax_a) that another one leads: it stands at ratio times that one's place and offset
    [m]."""

    eax: int
    leader: int
    ratio: float = 1.0
    offset: float = 0.0

    @property
    def column(self) -> str:
        """Its name in joint CSV: "rail_f"."""
        return f"rail_{'abcdef'[self.eax]}"


class Settling(NamedTuple):
    r"""How long [s] the axes take from the end of a move until all are in position, where the controller waits for it:
    at a stop point (fine), and at one with a criterion of its own, \Inpos of a move or of the wait behind a fly-by.

    A stop point "means that the robot and external axes must reach the specified position (stand still) before program
    execution continues with the next instruction" (RAPID reference manual, zonedata). It counts where the program then
    waits, or reads or sets a signal, before it moves on. source: of the numbers, with the grade; spread: between which
    shares of them the true ones are.
    """

    fine: float = 0.0
    inpos: float = 0.0
    source: str = ""
    spread: tuple[float, float] = (1.0, 1.0)

    @property
    def counts(self) -> bool:
        """Whether any of them takes time."""
        return self.fine > 0 or self.inpos > 0


NO_SETTLING = Settling()
# benchmarks/bench_logs.py: 0.21 s of eleven cycles of an IRB 6640 are at two stops that are waited for
ESTIMATED_SETTLING = Settling(
    0.1,
    0.1,
    "an estimate from the logs of another robot, a real IRB 6640 (grade C)",
    (0.5, 1.75),  # limits.SPREADS
)


@dataclass(frozen=True)
class Scenario:
    r"""Everything by name; names are in lower case, blanks left out of conditions.

    signals: value per signal, or a sequence of which each reading takes the next; the last one stays. answers: the same
    for operator input, sockets, files and clocks, by the name of the variable that gets the answer, or of the function
    where it has none. data: the same for data that the program does not declare, or that somebody outside writes.
    waits: least duration [s] per signal or condition as written (see condition_key), or None for one that never comes
    true, so that its time-out strikes. searches: where a search hits, as a share 0..1 of its way, or None for never, by
    signal or by the name of its SearchPoint. endless_passes: of a loop that cannot end in its cycle, None for the
    fewest that end where they begin. pass_limit: how often any other loop may run, and statement_limit how many
    statements, passes, calls and changes of large data in all, before the reader gives up. assume_identity: tools, work
    objects and mechanical units that are taken as the identity where the program does not declare them. stubs:
    procedures that are taken as doing nothing where no file declares them. hold_rail: where the rail stands still.
    constant_speed: where the tool should keep its programmed speed. positioners: mechanical units that carry work
    objects, their axes from the floor on; the last one carries the user frame. free_speed, droppable: of the cell, as
    in its plant. rail: None where there is none. rail_at: where it stands for targets that leave it open, by
    RailPlace.name as condition_key has it. active_units: the mechanical units that are active when the program starts,
    names in lower case; None for all that share no axis. partner: what the other robots take [s] for the moves that
    they make together with this one (MultiMove), by \ID. settle: what stops take that are waited for. free: where the
    tool may be turned; of several that hold for a move the last one counts.
    """

    signals: Mapping[str, float | tuple[float, ...]] = field(default_factory=dict)
    answers: Mapping[str, Answer | tuple[Answer, ...]] = field(default_factory=dict)
    data: Mapping[str, Given] = field(default_factory=dict)
    waits: Mapping[str, float | None] = field(default_factory=dict)
    searches: Mapping[str, float | None] = field(default_factory=dict)
    endless_passes: int | None = None
    pass_limit: int = 100_000
    statement_limit: int = 1_000_000
    assume_identity: frozenset[str] = frozenset()
    stubs: frozenset[str] = frozenset()
    hold_rail: HoldRail = HoldRail()
    constant_speed: ConstantSpeed = ConstantSpeed()
    positioners: Mapping[str, tuple[PositionerAxis, ...]] = field(default_factory=dict)
    free_speed: bool = False
    droppable: frozenset[str] = frozenset()
    rail: RailUnit | None = None
    rail_at: Mapping[str, RailPlace] = field(default_factory=dict)
    active_units: frozenset[str] | None = None
    partner: Mapping[int, float] = field(default_factory=dict)
    settle: Settling = NO_SETTLING
    free: tuple[FreeTool, ...] = ()

    @property
    def without_lines(self) -> Scenario:
        """For the same program in another text, whose lines are others: without what is named by line."""
        return replace(self, hold_rail=HoldRail(), constant_speed=ConstantSpeed(), free=())


LONGEST_WAIT = 1_000_000  # [s]; what is longer is a slip, and swamps every other time of the cycle
NUM_LIMIT = 3.4028235e38  # of a num, and of a signal: 32-bit floats
NAME_LISTS = ("assume_identity", "stubs")  # sections that only name things
_SHOWN = 200  # characters of a value in a message; a template has all of it


@dataclass(frozen=True)
class Missing:
    """Something the scenario must say, once per name.

    section: the key of the cell file it belongs under ("signals", "answers", "data", "searches", "assume_identity",
    "stubs"). name: as the program spells it. source: the place that asked first. reason: what asked,
    in words. value: a value to begin with, as YAML. excerpt: the line of the source with a caret, to be shown.
    declared: whether the program declares it, so that no other file can. close: the known name that may be meant.
    """

    section: str
    name: str
    source: Source
    reason: str
    value: str
    excerpt: str | None = field(default=None, compare=False)
    declared: bool = False
    close: str | None = None

    @property
    def line(self) -> str:
        """The line to add to the cell file; a long value is shown by its beginning."""
        if self.section in NAME_LISTS:
            return f"{self.section}: [{yaml_name(self.name)}]"
        value = self.value if len(self.value) <= _SHOWN else f"{self.value[:_SHOWN]}..."
        return f"{self.section}: {{{yaml_name(self.name)}: {value}}}"


def condition_key(text: str) -> str:
    """A signal or condition as Scenario.waits has it: lower case, blanks left out."""
    return "".join(text.split()).lower()


def yaml_name(name: str) -> str:
    """A name as YAML spells it: in quotes where it would be read as something else than a text."""
    plain = re.fullmatch(r"[^\W\d]\w*", name) and name.lower() not in ("null", "true", "false")
    return name if plain else json.dumps(name, ensure_ascii=False)


def yaml_answer(value: Answer) -> str:
    """An answer as YAML spells it."""
    return repr(value).removesuffix(".0") if isinstance(value, float) else json.dumps(value, ensure_ascii=False)


def _message(one: Missing) -> str:
    if one.section == "assume_identity":  # the reason ends with the option that does the same
        return f"{one.reason}, or the line '{one.line}' in the cell file"
    reason = asked(one.reason, one.close)
    if one.section == "stubs":
        line = f"the line '{one.line}' in the cell file"
        return f"{reason} give the file that declares it, or ignore it: {line}"
    if one.section == "data" and not one.declared:
        kind, own = reason.partition(" ")[0], ""
        if kind in ("speeddata", "zonedata") and re.fullmatch(r"[vVzZ]\d+", one.name):  # whose name tells its value
            own = f"declare it, 'CONST {kind} {one.name}:={json.loads(one.value)};', "
        return f"{reason} {own}give the file that declares it, or its value: the line '{one.line}' in the cell file"
    return f"{reason} add the line '{one.line}' to the cell file"


def asked(reason: str, close: str | None) -> str:
    """What is missing and the name that may be meant, up to where the remedy begins."""
    return f"{reason};" if close is None else f"{reason}; did you mean '{close}'? Else"


class MissingError(InputErrorGroup):
    """A run that the scenario says too little of. missing: what it does not say."""

    def __init__(self, errors: Sequence[InputError], missing: Sequence[Missing]):
        super().__init__(errors)
        self.missing = tuple(missing)


def missing_error(missing: Sequence[Missing], after: InputError | None = None) -> MissingError:
    """One error for each, each with the line to add. after: what the run with 0 in their place came to in the end."""
    errors = [
        InputError(
            _message(one),
            file=one.source.file,
            line=one.source.line,
            column=one.source.column,
            excerpt=one.excerpt,
            kind=ErrorKind.CELL,
        )
        for one in missing
    ]
    return MissingError(errors if after is None else [*errors, after], missing)
