r"""Instructions and functions by name: what each takes, its topic in the manual and its handler.

What one takes is written as in the manual, each argument with what it is read as: `SetGO Signal:signal Value:num
\SDelay:num`. A required one without that is the expression itself, an optional one a switch. Optional arguments are
keywords in lower case; one that is not there, or has no value where it needs one, is left out.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from enum import Enum
from functools import partial
from types import MappingProxyType
from typing import Any, NamedTuple

from trajopt_cli.rapid.data.datatypes import TYPES, Type, Value, is_number
from trajopt_cli.rapid.data.scope import Absent
from trajopt_cli.rapid.execution.construction import maker
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.language.syntax import Argument, Call, Expression, Name, ProcedureCall


class Arguments(NamedTuple):
    """required: in order. optional: by name in lower case; None for a bare switch."""

    required: tuple[Expression, ...]
    optional: dict[str, Expression | None]

    def value(self, name: str) -> Expression | None:
        """The value of an optional argument, None where it is absent."""
        return self.optional.get(name)


def present(run: Context, args: Sequence[Argument]) -> list[Argument]:
    r"""The arguments that are really there: `\name?parameter` is only if the parameter is."""
    return [arg for arg in args if not _left_out(run, arg)]


def _left_out(run: Context, arg: Argument) -> bool:
    if not arg.forward:
        return False
    routine, node = run.frame.routine, arg.value
    assert isinstance(node, Name)
    if routine is None or node.name.lower() not in {parameter.name.lower() for parameter in routine.parameters}:
        where = f"{routine.kind} {routine.name}" if routine else "a routine"
        raise run.error(arg, f"\\{arg.name}?{node.name} passes on a parameter, and {node.name} is not one of {where}")
    return isinstance(run.find(node.name), Absent)


def named(
    run: Context, call: str, arg: Argument, place: int, required: Sequence[str], optional: Sequence[str] = ()
) -> None:
    """Hold the name before a required argument against the parameter's at its place: a name changes no order.

    place: how many required arguments stand before it. Raises InputError.
    """
    name = arg.parameter or ""
    wanted = required[place] if place < len(required) else None
    if wanted is not None and name.lower() == wanted.lower():
        return
    at = f"argument {place + 1} of {call}"
    if name.lower() in {option.lower() for option in optional}:
        message = f"{name} is an optional argument of {call}; write \\{name}:={run.text(arg)}"
    elif wanted is None:
        message = f"{call} takes {len(required)} argument(s), so it has none called {name} in place {place + 1}"
    elif name.lower() in {one.lower() for one in required}:
        message = f"{at} is {wanted}, found {name}; names do not change the order, so put the arguments in theirs"
    else:
        message = f"{at} is {wanted}, found {name}; write {wanted}:= or no name"
    places = run.places()
    raise places.error(places.text.rfind(name, 0, arg.start), message)


def bind(
    run: Context, call: ProcedureCall | Call, required: tuple[str, ...], optional: tuple[str, ...] = ()
) -> Arguments:
    """Arguments by place and name. required, optional: as in the manual, for messages.

    Raises InputError for a missing or surplus argument and for an optional one that is not supported.
    """
    run.takes[call.name] = required
    places: list[Expression] = []
    options: dict[str, Expression | None] = {}
    for arg in call.args:
        name = arg.name
        if name is None:  # nearly always
            assert arg.value is not None
            if arg.parameter is not None:
                named(run, call.name, arg, len(places), required, optional)
            places.append(arg.value)
            continue
        if _left_out(run, arg):
            continue
        known = _KNOWN.get(optional)
        if known is None:
            known = _KNOWN[optional] = frozenset(name.lower() for name in optional)
        if (key := name.lower()) in known:
            options[key] = arg.value
        else:
            supported = ", ".join(f"\\{name}" for name in optional) or "none"
            raise run.error(arg, f"{call.name} \\{arg.name} is not supported; supported here: {supported}")
    if len(places) != len(required):
        names = ", ".join(required) or "none"
        raise run.error(call, f"{call.name} takes {len(required)} argument(s) ({names}), found {len(places)}")
    if len(options) > 1:
        for group in _EXCLUSIVE:
            both = [arg for arg in call.args if arg.name is not None and arg.name.lower() in group & options.keys()]
            if len(both) > 1:
                raise run.error(call, f"{call.name} takes only one of \\{both[0].name} and \\{both[1].name}")
    return _arguments((tuple(places), options))


_arguments = maker(Arguments)


def subject(run: Context, call: ProcedureCall | Call, node: Expression) -> str | None:
    """What an argument is called in messages: "Speed of MoveL". None where node is no argument of the call."""
    count = 0
    for arg in call.args:
        if arg.value is node:
            names = run.takes.get(call.name, ())
            if arg.name is not None:
                return f"\\{arg.name} of {call.name}"
            return f"{names[count]} of {call.name}" if count < len(names) else f"argument {count + 1} of {call.name}"
        count += arg.name is None
    return None


# `[\V] | [\T]` of the manual: optional arguments that exclude each other wherever they are known.
_EXCLUSIVE = (
    frozenset({"v", "t"}),
    frozenset({"stop", "pstop", "sstop", "sup"}),
    frozenset({"start", "time"}),
    frozenset({"on", "off"}),
    frozenset({"noteq", "lt", "gt"}),
    frozenset({"flanks", "posflank", "negflank", "highlevel", "lowlevel"}),
)
_KNOWN: dict[tuple[str, ...], frozenset[str]] = {}  # names of optional arguments in lower case


Handler = Callable[[Context, ProcedureCall], None]
FunctionHandler = Callable[[Context, Call], Value]
Reader = Callable[[Context, Expression], Any]


class Effect(Enum):
    """The effect of an instruction; value: as the manual names it.

    PLANNED: a motion, or part of one. RUN: data, settings and signals; no time passes. WAITS: the tool rests for a
    time. STOPS: the program waits there for somebody or something outside of it, so nothing is planned ahead and the
    fly-by point before it is a stop (ABB event 50024, corner path failure). REFUSED: an error. IGNORED: nothing of it
    is in a plan, which the output says.
    """

    PLANNED = "planned"
    RUN = "run"
    WAITS = "waits"
    STOPS = "stops a corner"
    REFUSED = "refused"
    IGNORED = "ignored"


class Instruction(NamedTuple):
    """An instruction; name as the manual spells it."""

    name: str
    topic: str
    effect: Effect
    handler: Handler


class Function(NamedTuple):
    """A function. stops: it waits as an instruction with Effect.STOPS does."""

    name: str
    topic: str
    stops: bool
    handler: FunctionHandler


INSTRUCTIONS: dict[str, Instruction] = {}
FUNCTIONS: dict[str, Function] = {}


class Refused(Exception):
    """A value that a handler does not take. at: the argument, None for the call as a whole. error: the name of the
    error that the program may handle (see predefined.ERRORS), None where it may not."""

    def __init__(self, message: str, at: str | None = None, error: str | None = None):
        super().__init__(message)
        self.message, self.at, self.error = message, at, error


class Form:
    """The arguments of an instruction or a function as it is written down, to be read from a call."""

    def __init__(self, takes: str, readers: Mapping[str, Reader] = MappingProxyType({})):
        self._reads: dict[str, Callable[[Context, Expression], Any]] = {}  # by name in lower case; none: as it is
        names: list[str] = []
        for word in takes.split():
            name, _, kind = word.partition(":")
            names.append(name)
            if kind:
                self._reads[name.strip("\\").lower()] = readers.get(kind) or _reader(kind, name)
        self.required = tuple(name for name in names if name[0] != "\\")
        self.optional = tuple(name[1:] for name in names if name[0] == "\\")

    def call(self, handler: Callable[..., Any], of_values: bool, run: Context, node: ProcedureCall | Call) -> Any:
        """What handler gives for the arguments of a call. of_values: it does not take the run and the call before."""
        args = bind(run, node, self.required, self.optional)
        nodes = dict(zip((name.lower() for name in self.required), args.required, strict=True))
        values = [self._reads[name](run, one) if name in self._reads else one for name, one in nodes.items()]
        options: dict[str, Any] = {name: True for name in args.optional if name not in self._reads}
        for name, one in args.optional.items():
            if name in self._reads and one is not None:
                options[name] = self._reads[name](run, one)
        try:
            return handler(*values, **options) if of_values else handler(run, node, *values, **options)
        except Refused as error:
            at = None if error.at is None else {**nodes, **args.optional}.get(error.at.lower())
            place = at or node
            if error.error is not None:
                raise run.fault(place, error.error, error.message) from None
            raise run.error(place, error.message) from None


def _reader(kind: str, name: str) -> Reader:
    if kind == "int":
        return lambda run, node: run.integer(node, name)
    known: dict[str, Reader] = {
        "expr": lambda run, node: node,
        "num": lambda run, node: run.number(node),
        "bool": lambda run, node: run.condition(node),
        "signal": lambda run, node: run.signal(node),
        "unit": lambda run, node: run.unit(node),
        "place": lambda run, node: run.locate(node),
    }
    return known.get(kind) or (lambda run, node: run.evaluate(node, TYPES[kind]).data)


class Topic:
    """Enters the instructions and functions of one topic.

    text: its first line is the topic in the manual, as in the docstring of a file. readers: what some arguments are
    read as besides the words and types that every topic has.
    """

    def __init__(self, text: str | None, **readers: Reader):
        self.name = (text or "").split("\n")[0].split(":")[0].rstrip(".")
        self._readers = readers

    def enter(self, effect: Effect, *names: str) -> Callable[[Handler], Handler]:
        """Of instructions whose handler reads the arguments itself."""

        def entered(handler: Handler) -> Handler:
            for name in names:
                assert name not in INSTRUCTIONS
                INSTRUCTIONS[name] = Instruction(name, self.name, effect, handler)
            return handler

        return entered

    def instruction(self, effect: Effect, *forms: str) -> Callable[[Callable[..., None]], Callable[..., None]]:
        """Of instructions with what each takes; the handler gets the run, the call and the arguments."""

        def entered(handler: Callable[..., None]) -> Callable[..., None]:
            for name, form in map(self._form, forms):
                self.enter(effect, name)(partial(form.call, handler, False))
            return handler

        return entered

    def function(self, *forms: str) -> Callable[[Callable[..., Value]], Callable[..., Value]]:
        """Of functions with what each takes; the handler gets the run, the call and the arguments."""

        def entered(handler: Callable[..., Value]) -> Callable[..., Value]:
            for name, form in map(self._form, forms):
                self.enter_function(name, partial(form.call, handler, False))
            return handler

        return entered

    def values(self, form: str, result: Type) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
        """Of a function of its arguments' values alone, to data of the type result."""
        name, takes = self._form(form)

        def entered(compute: Callable[..., Any]) -> Callable[..., Any]:
            def handler(*values: Any, **options: Any) -> Value:
                try:
                    data = compute(*values, **options)
                except (ValueError, OverflowError, ZeroDivisionError) as error:
                    shown = ", ".join(f"{value:.6g}" for value in values)
                    raise Refused(f"{name}({shown}) is not defined: {error}") from error
                return Value(result, float(data) if is_number(result) else data)

            self.enter_function(name, partial(takes.call, handler, True))
            return compute

        return entered

    def _form(self, form: str) -> tuple[str, Form]:
        name, _, takes = form.partition(" ")
        return name, Form(takes, self._readers)

    def enter_function(self, name: str, handler: FunctionHandler, stops: bool = False) -> None:
        """A function whose handler reads the arguments itself."""
        assert name not in FUNCTIONS
        FUNCTIONS[name] = Function(name, self.name, stops, handler)
