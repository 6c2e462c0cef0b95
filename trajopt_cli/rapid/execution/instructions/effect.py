"""What an instruction does to the motion, shown in the manual's table and acted on where instructions run."""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum

from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.language.syntax import ProcedureCall

Handler = Callable[[Context, ProcedureCall], None]


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


Topic = dict[Effect, dict[str, Handler]]  # the instructions of a file, by effect and name
