"""Runs a syntax tree from its entry procedure and collects the motions.

Handlers (ERROR, UNDO, BACKWARD) never run: nothing fails offline. What no program text tells, such as signal values,
comes from the scenario; what it lacks is an InputError with the line to add.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from math import floor

from trajopt_cli.errors import InputError
from trajopt_cli.kinematics import Kinematics
from trajopt_cli.motion import DEFAULT_SETTINGS, Motion, Source
from trajopt_cli.rapid.data.datatypes import NUM, SIGNALS, SWITCH, Array, Type, Value
from trajopt_cli.rapid.data.predefined import ERRORS, VARIABLES, predefined
from trajopt_cli.rapid.data.scope import ABSENT, Absent, Datum, Frame, ModuleScope, Place, Scope
from trajopt_cli.rapid.execution.arguments import present
from trajopt_cli.rapid.execution.evaluate import condition, convertible, evaluate, locate, number
from trajopt_cli.rapid.execution.faults import Fault
from trajopt_cli.rapid.execution.functions.table import FUNCTIONS
from trajopt_cli.rapid.execution.instructions.table import INSTRUCTIONS
from trajopt_cli.rapid.execution.loading import declare, find_type
from trajopt_cli.rapid.execution.position import Position
from trajopt_cli.rapid.execution.world import World
from trajopt_cli.rapid.language.syntax import (
    Argument,
    Assign,
    Block,
    Call,
    Connect,
    DataDeclaration,
    Expression,
    For,
    Goto,
    If,
    Label,
    LateCall,
    Name,
    Node,
    Parameter,
    Placeholder,
    ProcedureCall,
    Raise,
    Return,
    Routine,
    Simple,
    Statement,
    Test,
    While,
)
from trajopt_cli.rapid.language.text import Places
from trajopt_cli.scenario import Scenario

CALL_LIMIT = 40  # routines inside routines; a controller's stack ends at a few dozen too


class _Return(Exception):
    def __init__(self, value: Value | None):
        self.value = value


class Exit(Exception):
    """The program says that it is over."""


class Run:
    """One execution of a program: its data as it stands now, and the motions so far."""

    def __init__(self, scenario: Scenario, kinematics: Kinematics | None = None):
        self.scenario = scenario
        self.position = Position(kinematics)
        self.settings = DEFAULT_SETTINGS
        self.ignored: Counter[str] = Counter()  # instructions without effect on motion
        self.world = World(scenario)
        self.motions: list[Motion] = []
        self.warnings: dict[str, None] = {}  # a set that keeps its order
        self.optional: set[tuple[str, int]] = set()  # file and start of the moves that are marked
        self.files: dict[str, Places] = {}
        self.shared = Scope()
        self.computing: list[Node] = []  # the declarations whose initial value is being computed
        self.frame = Frame(ModuleScope())
        self._predefined = {name: Datum(value.type, value, "predefined") for name, value in predefined().items()}
        self._predefined |= {name: Datum(type_, Value(type_, type_.default)) for name, type_ in VARIABLES.items()}
        self._passes: Counter[tuple[str, int]] = Counter()
        self._depth = 0

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
        return self.places().source(node.start)

    def error(self, node: Node, message: str) -> InputError:
        """An InputError placed at a node of the code that runs now."""
        return self.places().error(node.start, message)

    def fault(self, node: Node, name: str, message: str) -> Fault:
        """An error that the program may handle, placed at a node; name is one of predefined.ERRORS."""
        place = self.source(node)
        return Fault(message, name, ERRORS[name], file=place.file, line=place.line, column=place.column)

    def warn(self, message: str) -> None:
        """Tell the user, once."""
        self.warnings[message] = None

    def text(self, node: Node) -> str:
        """A node as written, on one line."""
        return " ".join(self.places().text[node.start : node.end].split())

    @contextmanager
    def inside(self, frame: Frame) -> Iterator[None]:
        """Let names and places mean what they mean in frame."""
        before, self.frame = self.frame, frame
        try:
            yield
        finally:
            self.frame = before

    # ----------------------------------------------------------------------------------------------------- names

    def find(self, name: str) -> Place | Absent | None:
        """The data of a name: routine, module, other modules, predefined."""
        key, frame = name.lower(), self.frame
        for known in (frame.local, frame.scope.data, self.shared.data, self._predefined):
            if key in known:
                return known[key]
        return None

    def signal(self, node: Expression) -> str:
        """The name, in lower case, of the signal that an argument stands for. Signals are not declared in RAPID."""
        if not isinstance(node, Name):
            raise self.error(node, f"needs the name of a signal, found {self.text(node)}")
        place = self.find(node.name)
        if isinstance(place, Datum) and place.type.name in SIGNALS:
            return str(place.value.data or node.name.lower())
        return node.name.lower()

    # ------------------------------------------------------------------------------------------------ statements

    def start(self, routine: Routine, scope: ModuleScope) -> None:
        """Run the entry procedure, which stands in scope, once. Raises InputError for what cannot be run."""
        if any(not parameter.optional for parameter in routine.parameters):
            message = f"PROC {routine.name} needs arguments, so it cannot be started with"
            raise scope.places.error(routine.start, message)
        try:
            with self.inside(Frame(scope)):
                self._enter(routine, scope, (), routine)
        except Exit:
            return

    def block(self, block: Block) -> None:
        """Run statements in order."""
        for statement in block:
            self._statement(statement)

    def _statement(self, node: Statement) -> None:
        match node:
            case ProcedureCall():
                self._procedure(node)
            case Assign():
                self.assign(node.target, evaluate(self, node.value, locate(self, node.target).type))
            case If():
                for test, block in node.branches:
                    if condition(self, test):
                        return self.block(block)
                self.block(node.otherwise)
            case For():
                self._for(node)
            case While():
                while condition(self, node.condition):
                    self._count(node)
                    self.block(node.body)
            case Test():
                self._test(node)
            case DataDeclaration():
                datum = declare(self, node, self.frame)
                _ = datum.value
                self.frame.local[node.name.lower()] = datum
            case Return():
                wanted = self.frame.returns
                if (wanted is None) != (node.value is None):
                    message = "RETURN needs a value in a FUNC" if wanted else "RETURN with a value outside a FUNC"
                    raise self.error(node, message)
                raise _Return(evaluate(self, node.value, wanted) if node.value is not None else None)
            case Simple(word="EXIT"):
                raise Exit
            case Label():
                pass
            case Placeholder():
                raise self.error(node, f"unfinished code {node.name} cannot be run")
            case _:
                raise self.error(node, f"{_NAMES[type(node)]} is not supported; supported statements: {_SUPPORTED}")

    def assign(self, target: Expression, value: Value) -> None:
        """Give data a new value. Raises InputError for constants and for a value of another type."""
        place = locate(self, target)
        if place.constant:
            raise self.error(target, f"{self.text(target)} is {place.constant} and cannot be changed")
        if not convertible(place.type, value.type):
            raise self.error(target, f"{self.text(target)} is a {place.type.name}, and the value a {value.type.name}")
        place.value = Value(place.type, value.data, value.origin)

    def _count(self, node: For | While) -> None:
        key = (self.file, node.start)
        self._passes[key] += 1
        if self._passes[key] > self.scenario.pass_limit:
            raise self.error(
                node,
                f"the loop has not ended after {self.scenario.pass_limit} passes (pass_limit); "
                "give signal values that end it, or raise pass_limit in the cell file",
            )

    def _for(self, node: For) -> None:
        first, last = number(self, node.first), number(self, node.last)
        step = number(self, node.step) if node.step else (1.0 if first <= last else -1.0)
        if step == 0:
            raise self.error(node, "FOR with STEP 0 never ends")
        key = node.name.lower()
        shadowed = self.frame.local.get(key)
        for i in range(floor((last - first) / step + 1e-9) + 1):
            self._count(node)
            self.frame.local[key] = Datum(NUM, Value(NUM, first + i * step), "a loop variable")
            self.block(node.body)
        if shadowed is None:
            self.frame.local.pop(key, None)
        else:
            self.frame.local[key] = shadowed

    def _test(self, node: Test) -> None:
        subject = evaluate(self, node.subject)
        for values, block in node.cases:
            if any(evaluate(self, value, subject.type).data == subject.data for value in values):
                return self.block(block)
        if node.default is not None:
            self.block(node.default)

    # -------------------------------------------------------------------------------------------------- routines

    def _routine(self, name: str) -> tuple[Routine, ModuleScope] | None:
        key = name.lower()
        return self.frame.scope.routines.get(key) or self.shared.routines.get(key)

    def _procedure(self, node: ProcedureCall) -> None:
        found = self._routine(node.name)
        if found is None:
            instruction = _INSTRUCTIONS.get(node.name.lower())
            if instruction is None:
                raise self.error(
                    node,
                    f"{node.name} is neither a procedure of the program nor a supported instruction; "
                    f"supported: {', '.join(INSTRUCTIONS)}",
                )
            return instruction(self, node)
        if found[0].kind != "PROC":
            raise self.error(node, f"{node.name} is a {found[0].kind}; only a PROC is called as a statement")
        self._enter(*found, node.args, node)

    def call_function(self, node: Call) -> Value:
        """The value of a function of the program, or of a predefined one."""
        found = self._routine(node.name)
        if found is None:
            function = _FUNCTIONS.get(node.name.lower())
            if function is None:
                raise self.error(
                    node,
                    f"{node.name} is neither a function of the program nor a supported one; "
                    f"supported: {', '.join(FUNCTIONS)}",
                )
            return function(self, node)
        if found[0].kind != "FUNC":
            raise self.error(node, f"{node.name} is a {found[0].kind}; only a FUNC has a value")
        value = self._enter(*found, node.args, node)
        if value is None:
            raise self.error(node, f"FUNC {node.name} ended without RETURN")
        return value

    def _enter(self, routine: Routine, scope: ModuleScope, args: Sequence[Argument], node: Node) -> Value | None:
        if self._depth >= CALL_LIMIT:
            raise self.error(node, f"calls are nested deeper than {CALL_LIMIT} routines at {routine.name}")
        frame = Frame(scope)
        with self.inside(Frame(scope)):
            types = [self._parameter_type(parameter) for parameter in routine.parameters]
            frame.returns = find_type(self, routine.type) if routine.type else None
        self._pass(routine, types, present(self, args), frame, node)
        self._depth += 1
        try:
            with self.inside(frame):
                self.block(routine.body)
        except _Return as result:
            return result.value
        finally:
            self._depth -= 1
        return None

    def _parameter_type(self, parameter: Parameter) -> Type:
        element = find_type(self, parameter.type)
        return Array(element, None, parameter.dimensions) if parameter.dimensions else element

    def _pass(self, routine: Routine, types: list[Type], args: list[Argument], frame: Frame, node: Node) -> None:
        """Fill a frame's parameters. args are evaluated where the call stands."""
        required = [arg for arg in args if arg.name is None]
        optional = {arg.name.lower(): arg for arg in args if arg.name is not None}
        wanted = [parameter.name for parameter in routine.parameters if not parameter.optional]
        if len(required) != len(wanted):
            names = ", ".join(wanted) or "none"
            raise self.error(node, f"{routine.name} takes {len(wanted)} argument(s) ({names}), found {len(required)}")
        for parameter, type_ in zip(routine.parameters, types, strict=True):
            key = parameter.name.lower()
            if not parameter.optional:
                frame.local[key] = self._argument(parameter, type_, required.pop(0))
            elif key in optional:
                frame.local[key] = self._argument(parameter, type_, optional.pop(key))
            else:
                frame.local[key] = ABSENT
        for arg in optional.values():
            raise self.error(arg, f"{routine.name} has no optional parameter \\{arg.name}")

    def _argument(self, parameter: Parameter, type_: Type, arg: Argument) -> Place:
        if arg.value is None:
            if type_ != SWITCH:
                raise self.error(arg, f"\\{parameter.name} needs a value of type {type_.name}")
            return Datum(SWITCH, Value(SWITCH, True), "a switch")
        if type_.name in SIGNALS:
            return Datum(type_, Value(type_, self.signal(arg.value)), "a signal")
        if parameter.mode is None:
            value = evaluate(self, arg.value, type_)
            return Datum(type_ if not isinstance(type_, Array) else value.type, value)
        place = locate(self, arg.value)
        if not convertible(type_, place.type):
            raise self.error(arg, f"{parameter.name} is a {type_.name}, and {self.text(arg)} a {place.type.name}")
        if place.constant:
            text = f"{self.text(arg)} is {place.constant} and cannot be given to {parameter.mode} {parameter.name}"
            raise self.error(arg, text)
        return place


_NAMES: dict[type, str] = {
    Goto: "GOTO",
    Raise: "RAISE",
    Simple: "RETRY or TRYNEXT",
    Connect: "CONNECT",
    LateCall: "late binding",
}
_INSTRUCTIONS = {name.lower(): handler for name, handler in INSTRUCTIONS.items()}
_FUNCTIONS = {name.lower(): handler for name, handler in FUNCTIONS.items()}
_SUPPORTED = "assignments, calls, IF, FOR, WHILE, TEST, RETURN, EXIT"
