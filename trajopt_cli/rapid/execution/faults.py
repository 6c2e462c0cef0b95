"""Errors that a RAPID program can handle itself, and the ERROR handlers that do.

The handler of the routine in which an instruction fails runs at once, with the routine's data, before anything is left:
so RETRY and TRYNEXT can go on inside its loops. What it does not handle goes to the instruction that called the
routine, and to that routine's handler.
"""

from __future__ import annotations

from enum import Enum
from typing import TYPE_CHECKING

from trajopt_cli.errors import InputError
from trajopt_cli.rapid.data.datatypes import NUM, Value
from trajopt_cli.rapid.data.scope import Frame
from trajopt_cli.rapid.execution.evaluate import evaluate
from trajopt_cli.rapid.execution.jumps import Jump, Retry, TryNext
from trajopt_cli.scenario import asked

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Run
    from trajopt_cli.rapid.language.syntax import Handler, Statement

RETRY_LIMIT = 4  # how often an instruction is tried again; a controller's default


class Fault(InputError):
    """A run-time error of the controller, such as a division by zero. Unhandled it is the user's InputError.

    number: what ERRNO is while it is handled. name: the ERR_ constant, or the number in words. passed: the call whose
    handler has let it pass.
    """

    def __init__(self, message: str, name: str, number: float, *, file: str, line: int, column: int):
        super().__init__(message, file=file, line=line, column=column)
        self.name, self.number = name, number
        self.passed: Frame | None = None


class Handled(Enum):
    """How a routine goes on after an error."""

    AGAIN = "the instruction is repeated"
    NEXT = "the next instruction follows"
    PASSED = "the error goes to the caller"


def handle(run: Run, fault: Fault, statement: Statement) -> Handled:
    """Let the running routine handle an error of one of its statements. What leaves the routine is raised on."""
    frame = run.frame
    if fault.passed is frame:
        return Handled.PASSED
    handler = None if frame.handling else _handler(run, fault)
    if handler is None:
        fault.passed = frame
        return Handled.PASSED
    frame.handling = fault
    run.errno.value = Value(NUM, fault.number)
    try:
        run.block(handler.body)
    except Jump as jump:
        raise run.error(
            jump.node, f"GOTO {jump.node.label} leads out of the ERROR handler; use TRYNEXT or RETRY"
        ) from None
    except TryNext:
        return Handled.NEXT
    except Retry:
        _count_retry(run, statement, fault)
        return Handled.AGAIN
    finally:
        frame.handling = None
    fault.passed = frame
    return Handled.PASSED


def _handler(run: Run, fault: Fault) -> Handler | None:
    routine = run.frame.routine
    for handler in routine.handlers if routine else ():
        if handler.kind == "ERROR":
            if not handler.numbers:
                return handler
            if any(evaluate(run, number, NUM).data == fault.number for number in handler.numbers):
                return handler
    return None


def _count_retry(run: Run, statement: Statement, fault: Fault) -> None:
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


class Undeclared(InputError):
    """A name that stands for nothing in the files read: another file may declare it.

    reason: without the remedy. close: the known name that may be meant.
    """

    def __init__(
        self,
        reason: str,
        close: str | None,
        *,
        file: str | None,
        line: int | None,
        column: int | None,
        excerpt: str | None,
    ):
        message = f"{asked(reason, close)} give the file that declares it"
        super().__init__(message, file=file, line=line, column=column, excerpt=excerpt)
        self.reason, self.close = reason, close
