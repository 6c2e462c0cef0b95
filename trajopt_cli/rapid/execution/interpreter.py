"""One run of a program: its data, names and messages as they stand now, and the motions so far.

What the statements do is in statements.py and its neighbours. What no program text tells, such as signal values, comes
from the scenario; what it lacks is noted (world.py).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from difflib import get_close_matches

from trajopt_cli.errors import InputError
from trajopt_cli.kinematics import Kinematics
from trajopt_cli.motion import DEFAULT_SETTINGS, Motion, Refusal, Source, Span
from trajopt_cli.rapid.data.datatypes import MOTSETDATA, NUM, PROGDISP, SIGNALS, Array, Type, Value, is_opaque
from trajopt_cli.rapid.data.predefined import ERRORS, VARIABLES, predefined
from trajopt_cli.rapid.data.scope import Absent, CallFrame, Datum, ModuleScope, Part, Place, Scope
from trajopt_cli.rapid.execution.calls import Head, enter, function, knows
from trajopt_cli.rapid.execution.control_flow import Exit
from trajopt_cli.rapid.execution.evaluate import convertible, locate
from trajopt_cli.rapid.execution.external_data import Outside
from trajopt_cli.rapid.execution.external_signals import ExternalSignals
from trajopt_cli.rapid.execution.faults import Fault, Undeclared
from trajopt_cli.rapid.execution.loops import named_in, unchanged
from trajopt_cli.rapid.execution.operators import computed
from trajopt_cli.rapid.execution.position import Position
from trajopt_cli.rapid.execution.recursion_limit import room
from trajopt_cli.rapid.execution.single_runs import Link, fill_once
from trajopt_cli.rapid.execution.statements import run_block
from trajopt_cli.rapid.execution.system_data import tell
from trajopt_cli.rapid.execution.units import Units
from trajopt_cli.rapid.language.syntax import (
    Block,
    Call,
    Component,
    Element,
    Expression,
    Label,
    Name,
    Node,
    Routine,
    While,
)
from trajopt_cli.rapid.language.text import Places
from trajopt_cli.scenario import Lack, Scenario
from trajopt_cli.warnings import ProgramWarning, WarningKind

__all__ = ["Execution", "Exit"]

MOTION_LIMIT = 300_000
_PERS = ("tool0", "wobj0", "load0")  # predefined, and PERS on a controller: they may be given to PERS parameters


def _system(type_: Type) -> Datum:
    return Datum(type_, Value(type_, type_.default), "set by the system", "VAR")


class Execution:
    """One execution of a program: its data as it stands now, and the motions so far."""

    def __init__(self, scenario: Scenario, kinematics: Kinematics | None = None):
        self.scenario = scenario
        self.units = Units(scenario)
        self.position = Position(kinematics, self.units)
        self.settings = DEFAULT_SETTINGS
        self.ignored: Counter[str] = Counter()  # instructions without effect on motion
        self.world = ExternalSignals(scenario)
        self.outside = Outside(scenario, self.world)
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
        tell(self)
        self.depth = 0  # of routines
        self.interrupts = 0  # how many were connected
        self.booked = 0  # error numbers given away
        self.stored = False  # whether a path is, between StorePath and RestoPath
        self.concurrent = 0  # how many moves with \Conc came last, with no other between them
        self.heads: dict[int, Head] = {}  # by the routine's id
        self.budget = scenario.statement_limit
        self.counts: dict[int, int] = {}  # how often a statement ran, by its id
        self.link: Link | None = None  # the statement that runs now, and those around it
        self.links: list[Link | None] = []  # of each motion
        self.takes: dict[str, tuple[str, ...]] = {}  # the required arguments of instructions and functions that ran
        self._labels: dict[int, dict[str, int]] = {}  # by the block's id
        self._kept: dict[int, frozenset[str]] = {}  # by the loop's id
        self._used: dict[int, tuple[frozenset[str], Counter[str]]] = {}  # by the routine's id
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
        place = self.source(node)
        return Fault(message, name, ERRORS[name], file=place.file, line=place.line, column=place.column)

    def undeclared(self, node: Name, what: str = "", known: Lack | None = None) -> Undeclared:
        """The error for a name that stands for nothing; what: "robtarget " and the like. known: as it lacked before."""
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
        error = self.error(node, "")
        return Undeclared(message, close, file=error.file, line=error.line, column=error.column, excerpt=error.excerpt)

    def unknown(self, node: Node, name: str, message: str, names: Iterable[str]) -> InputError:
        """An InputError for a name that is not one of names."""
        return self.error(node, self.meant(name, message, names))

    def meant(self, name: str, message: str, names: Iterable[str]) -> str:
        """The message, with the one of names that is spelled nearly like name."""
        close = self.close(name, names)
        return message if close is None else f"{message}; did you mean '{close}'?"

    def close(self, name: str, names: Iterable[str]) -> str | None:
        """The one of names that is spelled nearly like name; None for none, and for several."""
        spellings = {known.lower(): known for known in names}
        close = get_close_matches(name.lower(), spellings, n=2, cutoff=0.8)
        return spellings[close[0]] if len(close) == 1 else None

    def routines(self, kind: str) -> list[str]:
        """The names, as spelled, of the routines that the code that runs now can see."""
        known = {**self.shared.routines, **self.frame.scope.routines}
        return [routine.name for routine, _ in known.values() if routine.kind == kind]

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
            return self.outside.data.get(key)
        if known is not None:
            scope.outside[name] = known
        return known

    def routine(self, name: str) -> tuple[Routine, ModuleScope] | None:
        """A routine of the program by name, with its module: the own module's, or a global one."""
        key = name.lower()
        return self.frame.scope.routines.get(key) or self.shared.routines.get(key)

    def signal(self, node: Expression) -> str:
        """The name, in lower case, of the signal that an argument stands for. Signals are not declared in RAPID."""
        if isinstance(node, (Component, Element)):
            place: Place | Absent | None = locate(self, node)
        elif isinstance(node, Name):
            place = self.find(node.name)
        else:
            raise self.error(node, f"needs the name of a signal, found {self.text(node)}")
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

    # ------------------------------------------------------------------------------------------------ statements

    def start(self, routine: Routine, scope: ModuleScope) -> None:
        """Run the entry procedure, which stands in scope, once. Raises InputError for what cannot be run."""
        if any(not parameter.optional for parameter in routine.parameters):
            message = f"PROC {routine.name} needs arguments, so the program cannot start with it"
            raise scope.places.error(routine.start, message)
        with self.inside(CallFrame(scope)), room(), suppress(Exit):
            enter(self, routine, scope, (), routine)
        if not self.world.lacks:
            for sentence in self.world.unused():
                self.warn(WarningKind.UNUSED, sentence)
        fill_once(self.motions, self.links, self.counts)
        self.position.place()

    def block(self, block: Block) -> None:
        """Run statements in order."""
        run_block(self, block)

    def call_function(self, node: Call, wanted: Type | None = None) -> Value:
        """The value of a function, where a type is wanted."""
        return function(self, node, wanted)

    def knows(self, name: str) -> bool:
        """Whether a function is one of the program's or of RAPID's."""
        return knows(self, name)

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

    def labels(self, block: Block) -> dict[str, int]:
        """The labels of a block, with where they stand in it."""
        found = self._labels.get(id(block))
        if found is None:
            found = {node.name.lower(): i for i, node in enumerate(block) if isinstance(node, Label)}
            self._labels[id(block)] = found
        return found

    def kept(self, loop: While) -> frozenset[str]:
        """The variables of the routine that runs, in lower case, that it names nowhere but in a loop's condition."""
        found = self._kept.get(id(loop))
        if found is None:
            routine = self.frame.routine
            if routine is None:
                return frozenset()
            if id(routine) not in self._used:
                self._used[id(routine)] = named_in(routine)
            found = self._kept[id(loop)] = unchanged(*self._used[id(routine)], loop)
        return found

    def spend(self, node: Node, size: int) -> None:
        """Charge work on a large piece of data to the budget of statements. Raises InputError when that is used up."""
        self.budget -= size // 256
        if self.budget < 0:
            raise self.exhausted(node)

    def exhausted(self, node: Node) -> InputError:
        """The error for a program that runs on and on."""
        return self.error(
            node,
            f"the program has not ended after {self.scenario.statement_limit} statements (statement_limit); "
            "give values that end it (signals, data, answers), or raise statement_limit in the cell file",
        )

    def assign(self, target: Expression, value: Value) -> None:
        """Give data a new value. Raises InputError for constants and for a value of another type."""
        self.store(locate(self, target), target, value)

    def store(self, place: Place, target: Expression, value: Value) -> None:
        """As assign, for data that is located already; target is where errors are placed."""
        type_ = place.type
        if place.constant:
            raise self.error(target, f"{self.text(target)} is {place.constant} and cannot be changed")
        if value.type is not type_:
            if not convertible(type_, value.type):
                raise self.error(target, f"{self.text(target)} is a {type_.name}, and the value a {value.type.name}")
            value = Value(type_, value.data, value.origin)
        if value.origin is None and type(type_) is not Array and not is_opaque(type_):  # arrays are only copied
            value = computed(self, target, type_, value.data)
        if type(place) is Part:
            whole: Place = place
            while type(whole) is Part:
                whole = whole.base
                self.spend(target, len(whole.value.data))
        place.value = value
