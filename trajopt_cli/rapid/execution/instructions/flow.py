"""Instructions that steer the program."""

from __future__ import annotations

from trajopt_cli.rapid.data.datatypes import NUM, STRING, Value
from trajopt_cli.rapid.data.errors import Exit, Retry
from trajopt_cli.rapid.data.predefined import BOOKED
from trajopt_cli.rapid.data.scope import Place
from trajopt_cli.rapid.execution.arguments import bind
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.faults import raise_error
from trajopt_cli.rapid.execution.instructions.effect import Effect, Topic
from trajopt_cli.rapid.language.syntax import ProcedureCall
from trajopt_cli.warnings import WarningKind


def _exit_cycle(run: Context, node: ProcedureCall) -> None:
    bind(run, node, ())
    raise Exit


def _stop(run: Context, node: ProcedureCall) -> None:
    bind(run, node, (), ("NoRegain", "AllMoveTasks"))
    run.note("stop", WarningKind.ASSUMED, f"{node.name} waits for the operator; the program goes on here", node)


def _break(run: Context, node: ProcedureCall) -> None:
    bind(run, node, ())
    what = "Break stops the robot at once, somewhere on its way; the plan stops at the point before it"
    run.warn(WarningKind.ASSUMED, what, run.source(node))


def _call_by_var(run: Context, node: ProcedureCall) -> None:
    name, index = bind(run, node, ("Name", "Number")).required
    run.call_procedure(node, f"{run.evaluate(name, STRING).data}{run.integer(index, 'Number')}")


def _book_error(run: Context, node: ProcedureCall) -> None:
    (target,) = bind(run, node, ("ErrorName",)).required
    run.booked += 1
    run.assign(target, Value(NUM, BOOKED + run.booked))


def _err_raise(run: Context, node: ProcedureCall) -> None:
    """RAISE of the booked number in the variable that a string names, with a text for the log."""
    names = ("ErrorName", "ErrorId", *(f"Argument{i}" for i in range(1, 6)))
    spelled = bind(run, node, names).required[0]
    name = str(run.evaluate(spelled, STRING).data)
    place = run.find(name)
    if not (isinstance(place, Place) and place.type == NUM):
        raise run.error(spelled, f"{node.name} names '{name}', which is no errnum of the program; declare it there")
    raise_error(run, node, f'{node.name} "{name}"', name, float(place.value.data))


def _reset_retry(run: Context, node: ProcedureCall) -> None:
    bind(run, node, ())
    run.frame.retried = (0, 0, 0)


def _start_move_retry(run: Context, node: ProcedureCall) -> None:
    """StartMove and RETRY in one."""
    bind(run, node, ())
    if run.frame.handling is None:
        raise run.error(node, f"{node.name} belongs in an ERROR handler")
    raise Retry


def _refused(run: Context, node: ProcedureCall) -> None:
    """ProcerrRecovery stops the robot wherever it is; RaiseToUser asks which modules a user may step into."""
    what = f"{node.name} raises an error whose place or handler is not modelled"
    raise run.error(node, f"{what}; leave it out, or write RAISE with the number of the error")


INSTRUCTIONS: Topic = {
    Effect.RUN: {
        "ExitCycle": _exit_cycle,
        "CallByVar": _call_by_var,
        "BookErrNo": _book_error,
        "ErrRaise": _err_raise,
        "ResetRetryCount": _reset_retry,
        "StartMoveRetry": _start_move_retry,
    },
    Effect.STOPS: {"Stop": _stop, "Break": _break},
    Effect.REFUSED: {"ProcerrRecovery": _refused, "RaiseToUser": _refused},
}
