"""Instructions that steer the program."""

from __future__ import annotations

from trajopt_cli.rapid.data.datatypes import NUM, Value
from trajopt_cli.rapid.data.errors import Exit, Retry
from trajopt_cli.rapid.data.predefined import BOOKED
from trajopt_cli.rapid.data.scope import Place
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.faults import raise_error
from trajopt_cli.rapid.execution.registry import Effect, Refused, Topic
from trajopt_cli.rapid.language.syntax import Expression, ProcedureCall
from trajopt_cli.warnings import WarningKind

_TOPIC = Topic(__doc__)


@_TOPIC.instruction(Effect.RUN, "ExitCycle")
def _exit_cycle(run: Context, node: ProcedureCall) -> None:
    raise Exit


@_TOPIC.instruction(Effect.STOPS, r"Stop \NoRegain \AllMoveTasks")
def _stop(run: Context, node: ProcedureCall, **_: bool) -> None:
    run.note("stop", WarningKind.ASSUMED, f"{node.name} waits for the operator; the program goes on here", node)


@_TOPIC.instruction(Effect.STOPS, "Break")
def _break(run: Context, node: ProcedureCall) -> None:
    what = "Break stops the robot at once, somewhere on its way; the plan stops at the point before it"
    run.warn(WarningKind.ASSUMED, what, run.source(node))


@_TOPIC.instruction(Effect.RUN, "CallByVar Name:string Number:int")
def _call_by_var(run: Context, node: ProcedureCall, name: str, number: int) -> None:
    run.call_procedure(node, f"{name}{number}")


@_TOPIC.instruction(Effect.RUN, "BookErrNo ErrorName")
def _book_error(run: Context, node: ProcedureCall, target: Expression) -> None:
    run.booked += 1
    run.assign(target, Value(NUM, BOOKED + run.booked))


@_TOPIC.instruction(Effect.RUN, "ErrRaise ErrorName:string ErrorId Argument1 Argument2 Argument3 Argument4 Argument5")
def _err_raise(run: Context, node: ProcedureCall, name: str, *_: Expression) -> None:
    """RAISE of the booked number in the variable that a string names, with a text for the log."""
    place = run.find(name)
    if not (isinstance(place, Place) and place.type == NUM):
        message = f"{node.name} names '{name}', which is no errnum of the program; declare it there"
        raise Refused(message, "ErrorName")
    raise_error(run, node, f'{node.name} "{name}"', name, float(place.value.data))


@_TOPIC.instruction(Effect.RUN, "ResetRetryCount")
def _reset_retry(run: Context, node: ProcedureCall) -> None:
    run.frame.retried = (0, 0, 0)


@_TOPIC.instruction(Effect.RUN, "StartMoveRetry")
def _start_move_retry(run: Context, node: ProcedureCall) -> None:
    """StartMove and RETRY in one."""
    if run.frame.handling is None:
        raise Refused(f"{node.name} belongs in an ERROR handler")
    raise Retry


@_TOPIC.enter(Effect.REFUSED, "ProcerrRecovery", "RaiseToUser")
def _refused(run: Context, node: ProcedureCall) -> None:
    """ProcerrRecovery stops the robot wherever it is; RaiseToUser asks which modules a user may step into."""
    what = f"{node.name} raises an error whose place or handler is not modelled"
    raise run.error(node, f"{what}; leave it out, or write RAISE with the number of the error")
