"""Instructions that steer the program."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.rapid.data.datatypes import NUM, STRING, Value
from trajopt_cli.rapid.data.predefined import BOOKED
from trajopt_cli.rapid.data.scope import Place
from trajopt_cli.rapid.execution.arguments import Instruction, bind
from trajopt_cli.rapid.execution.control_flow import Exit, Retry
from trajopt_cli.rapid.execution.evaluate import evaluate, integer
from trajopt_cli.rapid.execution.faults import raise_error
from trajopt_cli.rapid.execution.instructions.effect import Effect
from trajopt_cli.rapid.language.syntax import ProcedureCall
from trajopt_cli.warnings import WarningKind

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Execution


def _exit_cycle(run: Execution, node: ProcedureCall) -> None:
    bind(run, node, ())
    raise Exit


def _stop(run: Execution, node: ProcedureCall) -> None:
    bind(run, node, (), ("NoRegain", "AllMoveTasks"))
    run.note("stop", WarningKind.ASSUMED, f"{node.name} waits for the operator; the program goes on here", node)


def _break(run: Execution, node: ProcedureCall) -> None:
    bind(run, node, ())
    what = "Break stops the robot at once, somewhere on its way; the plan stops at the point before it"
    run.warn(WarningKind.ASSUMED, what, run.source(node))


def _call_by_var(run: Execution, node: ProcedureCall) -> None:
    from trajopt_cli.rapid.execution.calls import call_by_name

    name, index = bind(run, node, ("Name", "Number")).required
    call_by_name(run, node, f"{evaluate(run, name, STRING).data}{integer(run, index, 'Number')}", ())


def _book_error(run: Execution, node: ProcedureCall) -> None:
    (target,) = bind(run, node, ("ErrorName",)).required
    run.booked += 1
    run.assign(target, Value(NUM, BOOKED + run.booked))


def _err_raise(run: Execution, node: ProcedureCall) -> None:
    """RAISE of the booked number in the variable that a string names, with a text for the log."""
    names = ("ErrorName", "ErrorId", *(f"Argument{i}" for i in range(1, 6)))
    spelled = bind(run, node, names).required[0]
    name = str(evaluate(run, spelled, STRING).data)
    place = run.find(name)
    if not (isinstance(place, Place) and place.type == NUM):
        raise run.error(spelled, f"{node.name} names '{name}', which is no errnum of the program; declare it there")
    raise_error(run, node, f'{node.name} "{name}"', name, float(place.value.data))


def _reset_retry(run: Execution, node: ProcedureCall) -> None:
    bind(run, node, ())
    run.frame.retried = (0, 0, 0)


def _start_move_retry(run: Execution, node: ProcedureCall) -> None:
    """StartMove and RETRY in one."""
    bind(run, node, ())
    if run.frame.handling is None:
        raise run.error(node, f"{node.name} belongs in an ERROR handler")
    raise Retry


def _skip_warn(run: Execution, node: ProcedureCall) -> None:
    """Keeps a warning out of the log."""
    bind(run, node, ())


def _refused(run: Execution, node: ProcedureCall) -> None:
    """ProcerrRecovery stops the robot wherever it is; RaiseToUser asks which modules a user may step into."""
    what = f"{node.name} raises an error whose place or handler is not modelled"
    raise run.error(node, f"{what}; leave it out, or write RAISE with the number of the error")


INSTRUCTIONS: dict[str, Instruction] = {
    "ExitCycle": _exit_cycle,
    "Stop": _stop,
    "Break": _break,
    "CallByVar": _call_by_var,
    "BookErrNo": _book_error,
    "ErrRaise": _err_raise,
    "ResetRetryCount": _reset_retry,
    "StartMoveRetry": _start_move_retry,
    "SkipWarn": _skip_warn,
    "ProcerrRecovery": _refused,
    "RaiseToUser": _refused,
}
EFFECTS = {
    **dict.fromkeys(("Stop", "Break"), Effect.STOPS),
    **dict.fromkeys(("ProcerrRecovery", "RaiseToUser"), Effect.REFUSED),
    "SkipWarn": Effect.IGNORED,
}
