"""Instructions that steer the program."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.notices import NoticeKind
from trajopt_cli.rapid.data.datatypes import NUM, STRING, Value
from trajopt_cli.rapid.execution.arguments import Instruction, bind
from trajopt_cli.rapid.execution.evaluate import evaluate, integer
from trajopt_cli.rapid.execution.instructions.effect import Effect
from trajopt_cli.rapid.execution.jumps import Exit
from trajopt_cli.rapid.language.syntax import ProcedureCall

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Run


def _exit_cycle(run: Run, node: ProcedureCall) -> None:
    bind(run, node, ())
    raise Exit


def _stop(run: Run, node: ProcedureCall) -> None:
    bind(run, node, (), ("NoRegain", "AllMoveTasks"))
    run.note("stop", NoticeKind.ASSUMED, f"{node.name} waits for the operator; the program goes on here", node)


def _break(run: Run, node: ProcedureCall) -> None:
    bind(run, node, ())
    what = "Break stops at once, on the way, and waits for the operator; the plan stops at the point before it instead"
    run.warn(NoticeKind.ASSUMED, what, run.source(node))


def _call_by_var(run: Run, node: ProcedureCall) -> None:
    from trajopt_cli.rapid.execution.calls import call_by_name

    name, index = bind(run, node, ("Name", "Number")).required
    call_by_name(run, node, f"{evaluate(run, name, STRING).data}{integer(run, index, 'Number')}", ())


def _book_error(run: Run, node: ProcedureCall) -> None:
    (target,) = bind(run, node, ("ErrorName",)).required
    run.booked += 1
    run.assign(target, Value(NUM, float(run.booked)))


def _reset_retry(run: Run, node: ProcedureCall) -> None:
    bind(run, node, ())
    run.frame.retried = (0, 0, 0)


INSTRUCTIONS: dict[str, Instruction] = {
    "ExitCycle": _exit_cycle,
    "Stop": _stop,
    "Break": _break,
    "CallByVar": _call_by_var,
    "BookErrNo": _book_error,
    "ResetRetryCount": _reset_retry,
}
EFFECTS = {"Stop": Effect.STOPS, "Break": Effect.STOPS}
