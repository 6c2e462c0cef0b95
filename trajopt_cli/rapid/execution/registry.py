r"""Instructions and functions by name: what each takes, its topic in the manual and its handler.

What one takes is written as in the manual, each argument with what it is read as: `SetGO Signal:signal Value:num
\SDelay:num`. A required one without that is the expression itself, an optional one a switch. Optional arguments are
keywords in lower case; one that is not there, or has no value where it needs one, is left out.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from enum import Enum
from functools import partial
from types import MappingProxyType
from typing import Any, NamedTuple

from trajopt_cli.rapid.data.datatypes import TYPES, Type, Value, is_number
from trajopt_cli.rapid.execution.arguments import bind
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.language.syntax import Call, Expression, ProcedureCall

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
