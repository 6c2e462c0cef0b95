"""What trajopt says when a request is wrong. An infeasible program is not an error; see problem.Infeasible."""

from __future__ import annotations

from collections.abc import Sequence


class InputError(Exception):
    """Something the user gave is wrong: one line with place, value, bound and next step. Exit code 2.

    file, line and column (1-based) are None where they do not apply. str() is the line to print.
    """

    def __init__(self, message: str, *, file: str | None = None, line: int | None = None, column: int | None = None):
        super().__init__(message)
        self.message, self.file, self.line, self.column = message, file, line, column

    def __str__(self) -> str:
        place = ":".join(str(part) for part in (self.file, self.line, self.column) if part is not None)
        return f"{place}: {self.message}" if place else self.message


class InputErrorGroup(InputError):
    """Several input errors found in one run; str() gives them one per line, in the order found."""

    def __init__(self, errors: Sequence[InputError]):
        first = errors[0]
        super().__init__(first.message, file=first.file, line=first.line, column=first.column)
        self.errors = tuple(errors)

    def __str__(self) -> str:
        return "\n".join(str(error) for error in self.errors)
