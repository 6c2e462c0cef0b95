"""Errors that a RAPID program can handle itself, and the ERROR handlers that do.

The handler of the routine in which an instruction fails runs at once, with the routine's data, before anything is left:
so RETRY and TRYNEXT can go on inside its loops. What it does not handle goes to the instruction that called the
routine, and to that routine's handler. An error inside a handler stops the program (RAPID reference manual, error
recovery).

RAISE in a handler is a long jump: the routines that called are searched, the nearest first, for a handler that lists
the number (an error recovery point); those between are left, whatever handlers they have. Where none lists it, the
error goes to the caller as any other.
"""

from __future__ import annotations

from enum import Enum
from typing import TYPE_CHECKING, NoReturn

from trajopt_cli.errors import InputError
from trajopt_cli.rapid.data.datatypes import NUM, Value
from trajopt_cli.rapid.data.predefined import BOOKED, ERRORS
from trajopt_cli.rapid.data.scope import CallFrame, Fault, Jump, Retry, TryNext
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.warnings import WarningKind

if TYPE_CHECKING:
    from trajopt_cli.rapid.language.syntax import Handler, Node, Statement

USER_ERRORS = range(1, 91)  # the numbers that programs raise as they are
RETRY_LIMIT = 4  # how often an instruction is tried again; a controller's default


class Handled(Enum):
    """How a routine goes on after an error."""

    AGAIN = "the instruction is repeated"
    NEXT = "the next instruction follows"
    PASSED = "the error goes to the caller"


def handle(run: Context, fault: Fault, statement: Statement) -> Handled:
    """Let the running routine handle an error of one of its statements. What leaves the routine is raised on."""
    frame = run.frame
    if fault.passed is not frame and frame.handling is not None and fault.point is None:
        message = f"{fault.message}; this is inside an ERROR handler, where an error stops the program"
        raise InputError(message, file=fault.file, line=fault.line, column=fault.column)
    handler = None
    if fault.point in (None, frame) and fault.passed is not frame:
        handler = _handler(run, fault)
    if handler is None:
        fault.passed = frame
        if fault.point is not None:
            _leave(run, frame)
        return Handled.PASSED
    frame.handling = fault
    run.errno.value = Value(NUM, fault.number)
    try:
        run.block(handler.body)
    except Jump as jump:
        message = f"GOTO {jump.node.label} leads out of the ERROR handler; use TRYNEXT or RETRY"
        raise run.error(jump.node, message) from None
    except TryNext:
        return Handled.NEXT
    except Retry:
        _count_retry(run, statement, fault)
        return Handled.AGAIN
    finally:
        frame.handling = None
    fault.passed = frame
    return Handled.PASSED


def raise_error(run: Context, node: Node, what: str, name: str, number: float) -> NoReturn:
    """Raise an error by its number, as what raised and named it in the program; inside a handler it is a long jump."""
    known = next((known for known, its in ERRORS.items() if its == number), None)
    if not (number in USER_ERRORS or known or BOOKED < number <= BOOKED + run.booked):
        raise run.fault(node, "ERR_ILLRAISE", f"{what}: {number:.6g} is not an error number; get one with BookErrNo")
    message = f"{what} is not handled by any ERROR handler"
    raise passed_on(run, Fault(message, known or name, number, run.source(node)))


def passed_on(run: Context, fault: Fault) -> Fault:
    """The error as it is raised: in a handler, past the routines up to the one whose handler lists it."""
    if run.frame.handling is not None:
        fault.passed, fault.point = run.frame, long_jump(run, fault.number)
    return fault


def long_jump(run: Context, number: float) -> CallFrame | None:
    """The nearest call above the running one whose handler lists an error's number, or LONG_JMP_ALL_ERR."""
    frame = run.frame.caller
    while frame is not None:
        if frame.handling is None:
            with run.inside(frame):
                if any(_lists(run, handler, number) for handler in _handlers(frame)):
                    return frame
        frame = frame.caller
    return None


def _leave(run: Context, frame: CallFrame) -> None:
    """Say of a routine that a long jump leaves that its UNDO handler is not run."""
    if (routine := frame.routine) is None:
        return
    what = f"a long jump leaves {routine.kind} {routine.name}; a controller runs its UNDO handler, a plan does not"
    for handler in routine.handlers:
        if handler.kind == "UNDO":
            run.warn(WarningKind.ASSUMED, what, run.source(handler))


def _handlers(frame: CallFrame) -> list[Handler]:
    return [handler for handler in frame.routine.handlers if handler.kind == "ERROR"] if frame.routine else []


def _lists(run: Context, handler: Handler, number: float) -> bool:
    return any(run.evaluate(one, NUM).data in (number, ERRORS["LONG_JMP_ALL_ERR"]) for one in handler.numbers)


def _handler(run: Context, fault: Fault) -> Handler | None:
    """The handler that lists the error's number, else one without a list."""
    handlers = _handlers(run.frame)
    listed = (handler for handler in handlers if _lists(run, handler, fault.number))
    return next(listed, None) or next((handler for handler in handlers if not handler.numbers), None)


def _count_retry(run: Context, statement: Statement, fault: Fault) -> None:
    """Raises Fault, for the caller's handler, when the statement has failed too often in a row."""
    frame, key, ran = run.frame, id(statement), run.counts[id(statement)]
    before, then, times = frame.retried
    times = times + 1 if (before, then + 1) == (key, ran) else 1
    frame.retried = (key, ran, times)
    if times > RETRY_LIMIT:
        frame.retried = (0, 0, 0)
        message = f"fails every time: RETRY was tried {RETRY_LIMIT} times ({fault.name}: {fault.message})"
        error = run.fault(statement, "ERR_EXCRTYMAX", message)
        error.passed = frame
        raise error
