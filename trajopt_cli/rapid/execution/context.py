"""What the handlers of instructions and functions take: the running program as they may ask and change it.

Context is the whole interface between the interpreter and what it runs: data by name, messages, what the scenario says,
the state that moves change, and (abstract, given by interpreter.py) values of expressions and calls of routines.
"""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from difflib import get_close_matches
from math import trunc
from typing import Optional

from trajopt_cli.errors import InputError
from trajopt_cli.kinematics import Kinematics
from trajopt_cli.motion import DEFAULT_SETTINGS, ExternalAxes, Hold, Motion, Move, Refusal, Source, Span, Wait, Written
from trajopt_cli.rapid.data.datatypes import BOOL, MOTSETDATA, NUM, PROGDISP, SIGNALS, Type, Value, is_number
from trajopt_cli.rapid.data.predefined import ERRORS, VARIABLES, predefined
from trajopt_cli.rapid.data.scope import (
    Absent,
    CallFrame,
    Cycle,
    Datum,
    Fault,
    Head,
    Mismatch,
    ModuleScope,
    Part,
    Passes,
    Place,
    Scope,
    Undeclared,
)
from trajopt_cli.rapid.execution.external import External
from trajopt_cli.rapid.execution.position import Position
from trajopt_cli.rapid.execution.units import Units
from trajopt_cli.rapid.language import syntax
from trajopt_cli.rapid.language.syntax import Argument, Call, Expression, Name, Node, Routine, Statement
from trajopt_cli.rapid.language.text import Places
from trajopt_cli.scenario import NUM_LIMIT, Answer, Missing, Scenario, yaml_answer
from trajopt_cli.warnings import ProgramWarning, WarningKind

MOTION_LIMIT = 300_000
# A statement that runs, those around it up to the entry procedure (None there), and the file it stands in.
Link = tuple[Statement, Optional["Link"], str]
_PERS = ("tool0", "wobj0", "load0")  # predefined, and PERS on a controller: they may be given to PERS parameters
_OUTPUTS = frozenset({"signaldo", "signalgo", "signalao"})
_SHOWN = 40  # characters of an expression in a message


def _system(type_: Type) -> Datum:
    return Datum(type_, Value(type_, type_.default), "set by the system", "VAR")


def _renumbered(known: str, number: str, stem: str) -> bool:
    """Whether a name is stem with another number behind it."""
    return known.startswith(stem) and known[len(stem) :].isdigit() and known[len(stem) :] != number


class RailPlaces:
    """What a run asks of a cell file's rail_at; this is one that says nothing."""

    def set(self, signal: str, value: float) -> bool:
        """An output is set; whether that drives the rail."""
        return False

    def fill(self, point: Expression, extax: ExternalAxes) -> ExternalAxes:
        """The external axes [mm or deg] of a target with the rail where the cell file has it."""
        return extax

    def warn_unused(self) -> None:
        """Tell of the entries that no target took."""


class Context(ABC):
    """A program as it runs: its data as it stands now, and the motions so far."""

    def __init__(self, scenario: Scenario, kinematics: Kinematics | None = None):
        self.scenario = scenario
        self.units = Units(scenario)
        self.position = Position(kinematics)
        self.rail_places = RailPlaces()
        self.settings = DEFAULT_SETTINGS
        self.ignored: Counter[str] = Counter()  # instructions without effect on motion
        self.external = External(scenario)
        self.motions: list[Motion] = []
        self.refusals: dict[tuple[Source, str], Refusal] = {}
        self.warnings: dict[ProgramWarning, None] = {}  # a set that keeps its order
        self.optional: set[tuple[str, int]] = set()  # file and start of the moves that are marked
        self.ways: dict[tuple[str, int], tuple[str, ...]] = {}  # likewise, of points on a way around something
        self.held: list[Span] = []  # what is marked so that the rail stands still in it
        self.files: dict[str, Places] = {}
        self.shared = Scope()
        self.modules: dict[str, ModuleScope] = {}  # by name in lower case
        self.computing: set[int] = set()  # ids of the declarations whose initial value is being computed
        self.valued: set[str] = set()  # the shared PERS that were given a value
        self.frame = CallFrame(ModuleScope())
        self.errno = _system(NUM)
        self._predefined: dict[str, Datum] = {
            name.lower(): Datum(NUM, Value(NUM, number), "predefined", "CONST") for name, number in ERRORS.items()
        }
        for name, value in predefined().items():
            self._predefined[name] = Datum(value.type, value, "predefined", "PERS" if name in _PERS else "CONST")
        self._predefined |= {name: Datum(type_, Value(type_, type_.default)) for name, type_ in VARIABLES.items()}
        self._predefined["errno"] = self.errno
        self.velset: tuple[float, float | None] = (1.0, None)  # share and highest TCP speed [m/s], as VelSet says
        self.refresh = 1.0  # share, as SpeedRefresh says
        self.progdisp = self._predefined["c_progdisp"] = _system(PROGDISP)
        self.motset = self._predefined["c_motset"] = _system(MOTSETDATA)
        self.depth = 0  # of routines
        self.interrupts = 0  # how many were connected
        self.booked = 0  # error numbers given away
        self.stored = False  # whether a path is, between StorePath and RestoPath
        self.concurrent = 0  # how many moves with \Conc came last, with no other between them
        self.unsettled: Move | None = None  # the last of the motions before looked_at that moves; None: it has settled
        self.looked_at = 0
        self.heads: dict[int, Head] = {}  # by the routine's id
        self.labels: dict[int, dict[str, int]] = {}  # with where they stand, by the block's id
        self.unchanged: dict[int, frozenset[str]] = {}  # see loops.unchanged, by the loop's id
        self.named: dict[int, tuple[frozenset[str], Counter[str]]] = {}  # see loops.named_in, by the routine's id
        self.budget = scenario.statement_limit
        self.counts: dict[int, int] = {}  # how often a statement ran, by its id
        self.endless: dict[int, Passes] = {}  # of loops without a condition, by the node's id
        self.cycle: Cycle | None = None  # of the loop that never ends, once the run is over
        self.link: Link | None = None  # the statement that runs now, and those around it
        self.links: list[Link | None] = []  # of each motion
        self.waited: dict[int, frozenset[str]] = {}  # what the cell file calls a wait, by its index; see condition_key
        self.takes: dict[str, tuple[str, ...]] = {}  # the required arguments of instructions and functions that ran
        self._noted: set[str] = set()

    # ---------------------------------------------------------------------------------------- places and messages

    @property
    def file(self) -> str:
        """The file of the code that runs now."""
        return self.frame.scope.places.file

    def places(self, file: str | None = None) -> Places:
        """Offsets to places in a file of the program, by default the one whose code runs now."""
        return self.frame.scope.places if file is None else self.files[file]

    def source(self, node: Node) -> Source:
        """The place of a node of the code that runs now."""
        return self.frame.scope.places.source(node.start)

    def error(self, node: Node, message: str) -> InputError:
        """An InputError placed at a node of the code that runs now."""
        return self.places().error(node.start, message)

    def fault(self, node: Node, name: str, message: str) -> Fault:
        """An error that the program may handle, placed at a node; name is one of predefined.ERRORS."""
        return Fault(message, name, ERRORS[name], self.source(node))

    def undeclared(self, node: Name, what: str = "", known: Missing | None = None) -> Undeclared:
        """The error for a name that stands for nothing; what: "robtarget " and the like. known: as noted before."""
        scope, routine = self.frame.scope, self.frame.routine
        where = [f"{routine.kind} {routine.name}"] if routine else []
        where += [f"MODULE {scope.name}"] if scope.name else []
        message = f"{what}'{node.name}' is not declared in the program (looked for in {', '.join(where)}, "
        message += "the other modules' globals and the predefined data)"
        if known is None:
            data = (self.frame.local, scope.data, self.shared.data, self._predefined)
            close = self.close(node.name, [name for names in data for name in names])
        else:
            close = known.close
        return Undeclared(self.error(node, message), close)

    def meant(self, name: str, message: str, names: Iterable[str]) -> str:
        """The message, with the one of names that is spelled nearly like name."""
        close = self.close(name, names)
        return message if close is None else f"{message}; did you mean '{close}'?"

    def close(self, name: str, names: Iterable[str]) -> str | None:
        """The one of names that is spelled nearly like name; None for none, and for several."""
        number = re.search(r"\d+$", name)  # v55 is another speed than v5, not v5 misspelled
        others = () if number is None else (number[0], name[: number.start()].lower())
        spellings = {known.lower(): known for known in names if not (others and _renumbered(known.lower(), *others))}
        close = get_close_matches(name.lower(), spellings, n=2, cutoff=0.8)
        return spellings[close[0]] if len(close) == 1 else None

    def routines(self, kind: str) -> list[str]:
        """The names, as spelled, of the routines that the code that runs now can see."""
        known = {**self.shared.routines, **self.frame.scope.routines}
        return [routine.name for routine, _ in known.values() if routine.kind == kind]

    def mismatch(self, node: Expression, wanted: Type, found: Value | None) -> Mismatch:
        """The error for an expression that is not of the type its place asks for. found: None for an aggregate."""
        text = self.text(node)
        shown = text if len(text) <= _SHOWN else f"{text[:_SHOWN]}..."
        what = f"{found.type.name} {shown}" if found else "an aggregate"
        article = "an" if wanted.name[0] in "aeio" else "a"
        return Mismatch(node, f"{article} {wanted.name}, found {what}", self.error(node, ""))

    def warn(self, kind: WarningKind, text: str, place: Source | None = None) -> None:
        """Tell the user, once."""
        self.warnings[ProgramWarning(kind, text, place)] = None

    def refuse(self, kind: str, node: Node, message: str) -> None:
        """Tell of something that no plan keeps, once per kind and place; see motion.Refusal."""
        place = self.source(node)
        self.refusals.setdefault((place, kind), Refusal(kind, place, message))

    def note(self, topic: str, kind: WarningKind, text: str, node: Node) -> None:
        """Tell the user, once per topic: the first place that met it speaks for all."""
        if topic not in self._noted:
            self._noted.add(topic)
            self.warn(kind, text, self.source(node))

    def text(self, node: Node) -> str:
        """A node as written, on one line."""
        if type(node) is Name:
            return node.name
        return " ".join(self.frame.scope.places.text[node.start : node.end].split())

    @contextmanager
    def inside(self, frame: CallFrame) -> Iterator[None]:
        """Let names and places mean what they mean in frame."""
        before, self.frame = self.frame, frame
        try:
            yield
        finally:
            self.frame = before

    # ----------------------------------------------------------------------------------------------------- names

    def find(self, name: str) -> Place | Absent | None:
        """The data of a name: routine, module, other modules, predefined."""
        frame = self.frame
        scope, local = frame.scope, frame.local
        if local and (place := local.get(name.lower())) is not None:
            return place
        known = scope.outside.get(name)
        if known is not None:
            return known
        key = name.lower()
        if (own := scope.data.get(key)) is not None:
            return own
        known = self.shared.data.get(key) or self._predefined.get(key)
        if known is None:
            return self.external.data.get(key)
        if known is not None:
            scope.outside[name] = known
        return known

    def routine(self, name: str) -> tuple[Routine, ModuleScope] | None:
        """A routine of the program by name, with its module: the own module's, or a global one."""
        key = name.lower()
        return self.frame.scope.routines.get(key) or self.shared.routines.get(key)

    def signal(self, node: Expression) -> str:
        """The name, in lower case, of the signal that an argument stands for. Signals are not declared in RAPID."""
        place = self.find(node.name) if isinstance(node, Name) else None
        if isinstance(node, (syntax.Component, syntax.Element)):
            place = self.locate(node)
        if isinstance(place, (Datum, Part)) and place.type.name in SIGNALS:
            return str(place.value.data or self.text(node)).lower()
        if not isinstance(node, Name):
            raise self.error(node, f"needs the name of a signal, found {self.text(node)}")
        return node.name.lower()

    def argument_name(self, name: str) -> str | None:
        """How the caller, or its caller, wrote the argument that a parameter stands for; None for other names."""
        frame, key = self.frame, name.lower()
        found: str | None = None
        while key in frame.given:
            arg, frame = frame.given[key]
            if arg.value is None:
                return arg.name
            with self.inside(frame):
                found = self.text(arg.value)
            key = arg.value.name.lower() if isinstance(arg.value, Name) else ""
        return found

    def unit(self, node: Expression) -> str:
        """The name of the mechanical unit that an argument stands for, as spelled. Units are not declared in RAPID."""
        if not isinstance(node, Name):
            raise self.error(node, f"needs the name of a mechanical unit, found {self.text(node)}")
        place = self.find(node.name)
        known = place.value.data if isinstance(place, Datum) and place.type.name == "mecunit" else None
        return node.name if known is None else str(known)

    # ------------------------------------------------------------------------------------------------- the scenario

    def missing(
        self,
        section: str,
        name: str,
        node: Node,
        reason: str,
        value: str,
        declared: bool = False,
        again: bool = False,
        close: Callable[[], str | None] | None = None,
    ) -> None:
        """Note that the scenario does not say something, once per name; see Missing for what the parts mean.

        close: finds the name that may be meant; asked once, for a loop may miss it on every pass. again: put it in the
        place of what was noted under the name before.
        """
        key, known = (section, name.lower()), self.external.missing
        if (again or key not in known) and not self.external.trying:
            meant = close() if close else None
            excerpt = self.places().excerpt(node.start)
            known[key] = Missing(section, name, self.source(node), reason, value, excerpt, declared, meant)

    def answer(
        self, node: Node, name: str, reason: str, default: Answer, close: Callable[[], str | None] | None = None
    ) -> Answer:
        """The scenario's answer under name; default stands in where it has none. reason, close: see missing."""
        given = self.external.answer(name.lower())
        if given is None:
            self.missing("answers", name, node, reason, yaml_answer(default), close=close)
            return default
        return given

    def read_signal(self, node: Node, name: str) -> float:
        """The value that a reading of a signal gives; name as the program spells it. Outputs begin at 0."""
        self.settle_stop()
        value = self.external.signal(name.lower())
        if value is None:
            place = self.find(node.name) if isinstance(node, Name) else None
            if isinstance(place, Datum) and place.type.name in _OUTPUTS:
                return 0.0
            fitting = self.external.fitting.get(name.lower(), 0.0)
            value = fitting if isinstance(fitting, float) else 0.0
            reason = f"'{name}' is not declared in the program and has no value as a signal"
            self.missing("signals", name, node, reason, f"{value:.15g}")
        if abs(value) > NUM_LIMIT:
            raise self.fault(node, "ERR_NUM_LIMIT", f"the value {value:g} of signal '{name}' is too large for a num")
        return value

    def check_digital(self, node: Node, signal: str) -> None:
        """A digital signal is used, name in lower case: warn where the scenario's values are not 0 or 1."""
        value = self.external.not_digital.get(signal)
        if value is not None:
            message = f"{signal} is {value:.15g} in the cell file, and a digital signal is 0 or 1"
            self.note(f"digital {signal}", WarningKind.UNUSUAL, message, node)

    # ------------------------------------------------------------------------------------- values, data and routines

    @abstractmethod
    def evaluate(self, node: Expression, wanted: Type | None = None) -> Value:
        """The value of an expression, of the type the place asks for. Raises InputError, placed at the wrong part."""

    def number(self, node: Expression) -> float:
        """The value of a num or dnum expression. A literal keeps all its digits: whoever asks may take it as a dnum."""
        if type(node) is syntax.Number and abs(node.value) <= NUM_LIMIT:
            return node.value
        value = self.evaluate(node)
        if not is_number(value.type):
            raise self.mismatch(node, NUM, value)
        return float(value.data)

    def integer(self, node: Expression, what: str) -> int:
        """The value of an expression that must be a whole number; what names it in the message."""
        try:
            value = self.number(node)
        except Mismatch as error:
            raise error.about(node, what) from None
        if value != trunc(value):
            raise self.error(node, f"{what} must be a whole number, found {value:.6g}")
        return int(value)

    def condition(self, node: Expression) -> bool:
        """The value of a bool expression."""
        try:
            return self.evaluate(node, BOOL).data is True
        except Mismatch as error:
            raise error.about(node, "a condition") from None

    @abstractmethod
    def locate(self, node: Expression) -> Place:
        """The data that an expression names, to be changed. Raises InputError when it is not data."""

    @abstractmethod
    def store(self, place: Place, target: Expression, value: Value) -> None:
        """As assign, for data that is located already; target is where errors are placed."""

    def assign(self, target: Expression, value: Value) -> None:
        """Give data a new value. Raises InputError for constants and for a value of another type."""
        self.store(self.locate(target), target, value)

    @abstractmethod
    def block(self, block: syntax.Block) -> None:
        """Run statements in order."""

    @abstractmethod
    def call_function(self, node: Call, wanted: Type | None) -> Value:
        """The value of a function, where a type is wanted."""

    @abstractmethod
    def knows(self, name: str) -> bool:
        """Whether a function is one of the program's or of RAPID's."""

    @abstractmethod
    def call_procedure(self, node: Node, text: str, args: Sequence[Argument] = ()) -> None:
        """Call the procedure whose name a program has put together: `name`, or `module:name`, LOCAL or not, of that
        module. Raises Fault where there is none."""

    def spend(self, node: Node, size: int) -> None:
        """Charge work on a large piece of data to the budget of statements. Raises InputError when that is used up."""
        self.budget -= size // 256
        if self.budget < 0:
            raise self.exhausted(node)

    def exhausted(self, node: Node) -> InputError:
        """The error for a program that runs on and on."""
        message = f"the program has not ended after {self.scenario.statement_limit} statements (statement_limit); "
        message += "give values that end it (signals, data, answers), or raise statement_limit in the cell file"
        return self.error(node, message)

    def settle_stop(self, in_position: bool = False, behind: int = 0) -> None:
        r"""The program waits, or reads or sets a signal: at a stop it comes to that when every axis is in position, see
        Settling. in_position: it asks for that itself (\InPos). behind: how many of the motions come only then."""
        times, here = self.scenario.settle, len(self.motions) - behind
        if not times.counts:
            return
        moves = (one for one in reversed(self.motions[self.looked_at : here]) if isinstance(one, Move))
        self.unsettled, self.looked_at = next(moves, self.unsettled), here
        move = self.unsettled
        if move is None or not (in_position or (move.zone.stop and not self.concurrent)):
            return
        self.unsettled = None
        if duration := times.fine if move.zone.stop and move.zone.criterion is None else times.inpos:
            file, _, end = move.written.statement
            written = Written(Span(file, end, end))
            wait = Wait(source=move.source, written=written, duration=duration, in_position=True, hold=Hold.SETTLING)
            self.motions.insert(here, wait)
            self.looked_at += 1

    def settle(self) -> None:
        """Remember which statements the motions so far come from."""
        missing = len(self.motions) - len(self.links)
        if missing == 1:
            self.links.append(self.link)
        elif missing > 0:
            self.links += [self.link] * missing
        if len(self.motions) > MOTION_LIMIT:
            message = (
                f"the program makes more than {MOTION_LIMIT} motions; if a loop around this one goes on and on, "
                "give values that end it in the cell file (signals, answers, data)"
            )
            raise self.error(self.link[0], message) if self.link else InputError(message, file=self.file)
