"""What trajopt says when a request is wrong. An infeasible program is not an error; see problem.Infeasible."""

from __future__ import annotations

from collections.abc import Sequence


class InputError(Exception):
    """Something the user gave is wrong: one line with place, value, bound and next step. Exit code 2.

    file, line and column (1-based) are None where they do not apply. str() is the line to print. excerpt: the line of
    the file with a caret below the place, where there is one; shown() has both.
    """

    def __init__(
        self,
        message: str,
        *,
        file: str | None = None,
        line: int | None = None,
        column: int | None = None,
        excerpt: str | None = None,
    ):
        super().__init__(message)
        self.message, self.file, self.line, self.column, self.excerpt = message, file, line, column, excerpt

    def __str__(self) -> str:
        place = ":".join(str(part) for part in (self.file, self.line, self.column) if part is not None)
        return f"{place}: {self.message}" if place else self.message

    def shown(self) -> str:
        """The line to print, and below it the excerpt."""
        return f"{self}\n{self.excerpt}" if self.excerpt else str(self)


class InputErrorGroup(InputError):
    """Several input errors found in one run; str() gives them one per line, in the order found."""

    def __init__(self, errors: Sequence[InputError]):
        first = errors[0]
        super().__init__(first.message, file=first.file, line=first.line, column=first.column, excerpt=first.excerpt)
        self.errors = tuple(errors)

    def __str__(self) -> str:
        return "\n".join(str(error) for error in self.errors)

    def shown(self) -> str:
        """All of them, each with its excerpt."""
        return "\n".join(error.shown() for error in self.errors)
