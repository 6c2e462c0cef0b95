r"""Where the arguments of a motion's statement stand, whichever instruction it is."""

from __future__ import annotations

import re
from dataclasses import dataclass

from trajopt_cli.motion import Motion, Move, Span
from trajopt_cli.rapid.language.parser import parse_statement
from trajopt_cli.rapid.language.syntax import Argument, ProcedureCall

# Required arguments behind the tool: MoveLDO p, v, z, tool, signal, value; MoveLSync p, v, z, tool, "proc".
_BEHIND_TOOL = (
    (re.compile(r"Move[JLC](DO|AO|GO)", re.IGNORECASE), 2),
    (re.compile(r"Move[JLC]Sync", re.IGNORECASE), 1),
)
_NO_TOOL = re.compile(r"(Move|Search)ExtJ", re.IGNORECASE)
_CIRCLE = re.compile(r"(Move|Trigg|Search|Arc|Cap|Disp|Paint)C", re.IGNORECASE)


@dataclass(frozen=True)
class MoveCall:
    r"""A move as written: spans of its arguments. via: the circle point. tool None: it has none. wobj: `\WObj:=w`.

    override: a `\V:=x` with the comma or blanks before it, None where there is none. switches: names of all options, in
    lower case.
    """

    name: str
    target: Span
    via: Span | None
    speed: Span
    tool: Span | None
    wobj: Span | None
    override: Span | None
    switches: frozenset[str]


def read_move(move: Move, text: str) -> MoveCall:
    """The call that a move's statement is; text is the statement."""
    span = move.written.statement
    call = parsed(text, span)
    required = [arg for arg in call.args if arg.name is None]
    options = {arg.name.lower(): arg for arg in call.args if arg.name is not None}
    target = move.written.target
    at = 1 if _CIRCLE.match(call.name) else 0
    if target is not None:
        at = next((i for i, arg in enumerate(required) if span.start + arg.start == target.start), at)
    behind = next((count for name, count in _BEHIND_TOOL if name.fullmatch(call.name)), 0)
    tool = None if _NO_TOOL.match(call.name) else _inside(span, required[-1 - behind])
    wobj, override = options.get("wobj"), options.get("v")
    return MoveCall(
        name=call.name,
        target=_inside(span, required[at]),
        via=_inside(span, required[at - 1]) if _CIRCLE.match(call.name) else None,
        speed=_inside(span, required[at + 1]),
        tool=tool,
        wobj=_value(span, wobj) if wobj else None,
        override=_with_comma(span, override, text) if override else None,
        switches=frozenset(options),
    )


def last_argument(motion: Motion, text: str) -> str:
    """How the last argument of a motion's statement is written: a WaitTime's duration, an output's value."""
    last = parsed(text, motion.written.statement).args[-1]
    return text[last.start : last.end]


def parsed(text: str, span: Span) -> ProcedureCall:
    """The statement of a motion."""
    call = parse_statement(text, span.file)
    assert isinstance(call, ProcedureCall)  # every motion's statement is one
    return call


def _inside(span: Span, arg: Argument) -> Span:
    return span._replace(start=span.start + arg.start, end=span.start + arg.end)


def _value(span: Span, arg: Argument) -> Span | None:
    r"""The stretch `\WObj:=w` of an option, without a comma or blanks before it."""
    return _inside(span, arg) if arg.value is not None else None


def _with_comma(span: Span, arg: Argument, text: str) -> Span:
    start = len(text[: arg.start].rstrip().removesuffix(",").rstrip())
    return span._replace(start=span.start + start, end=span.start + arg.end)
