"""Errors of a running program, and the exceptions by which a running statement leaves its place."""

from __future__ import annotations

from trajopt_cli.errors import InputError
from trajopt_cli.rapid.data.datatypes import Value
from trajopt_cli.rapid.language.syntax import Expression, Goto
from trajopt_cli.scenario import asked


class Fault(InputError):
    """A run-time error of the controller, such as a division by zero. Unhandled it is the user's InputError.

    number: what ERRNO is while it is handled. name: the ERR_ constant, or the number in words. passed: the CallFrame
    whose handler has let it pass. point: the CallFrame whose handler a long jump leads to.
    """

    def __init__(self, message: str, name: str, number: float, *, file: str, line: int, column: int):
        super().__init__(message, file=file, line=line, column=column)
        self.name, self.number = name, number
        self.passed: object = None
        self.point: object = None


class Undeclared(InputError):
    """A name that stands for nothing in the files read: another file may declare it.

    reason: without the remedy. close: the known name that may be meant.
    """

    def __init__(
        self,
        reason: str,
        close: str | None,
        remedy: str = "give the file that declares it",
        *,
        file: str | None,
        line: int | None,
        column: int | None,
        excerpt: str | None,
    ):
        message = f"{asked(reason, close)} {remedy}"
        super().__init__(message, file=file, line=line, column=column, excerpt=excerpt)
        self.reason, self.close = reason, close


class Mismatch(InputError):
    """A value of another type than its place asks for. node: the expression. claim: "needs a num, found bool TRUE".

    Who knows what the place is called says so: the nearest one.
    """

    def __init__(self, node: Expression, claim: str, place: InputError):
        super().__init__(f"needs {claim}", file=place.file, line=place.line, column=place.column, excerpt=place.excerpt)
        self.node, self._claim, self._named = node, claim, False

    def about(self, node: Expression | None, subject: str) -> Mismatch:
        """Itself, with what needs the value where that is the place of node."""
        if node is self.node and not self._named:
            self.message, self._named = f"{subject} needs {self._claim}", True
            self.args = (self.message,)
        return self


# ----------------------------------------------------------------------------------------------------- control flow


class Exit(Exception):
    """The program says that it is over."""


class Return(Exception):
    """RETURN was run; value None in a PROC."""

    def __init__(self, value: Value | None):
        self.value = value


class Jump(Exception):
    """GOTO was run."""

    def __init__(self, node: Goto):
        self.node = node


class Retry(Exception):
    """RETRY was run."""


class TryNext(Exception):
    """TRYNEXT was run."""
