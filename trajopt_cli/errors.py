"""What trajopt says when a request is wrong. An infeasible program is not an error; see problem.Infeasible."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from enum import Enum
from itertools import accumulate


def printable(text: str, keep: str = "\t") -> str:
    """text with what a terminal would obey or hide (control characters, marks of direction) written as escapes."""
    if text.isprintable():
        return text
    return "".join(c if c.isprintable() or c in keep else c.encode("unicode_escape").decode() for c in text)


_LINE, _HEAD, _TAIL = 1000, 600, 300  # characters of a line that is printed; of a longer one, at its ends
_PAGE = 3500  # characters of several errors


def terminal_text(text: str) -> str:
    """text for a terminal: printable, and of a line that is longer than 1000 characters only what is at its ends."""
    lines = printable(text, keep="\n\t").split("\n")
    return "\n".join(one if len(one) <= _LINE else f"{one[:_HEAD]} ... {one[-_TAIL:]}" for one in lines)


class ErrorKind(Enum):
    """What is wrong, so that nobody has to read it out of the words."""

    PROGRAM = "program"  # its text, or what it does when run; an iiwa task, too
    CELL = "cell"  # the cell file, or what it does not say
    ROBOT = "robot"  # a robot's own files
    RESULTS = "results"  # a results folder, or a trajectory file
    UNPLANNABLE = "unplannable"  # a program that can be read, with motions that no plan keeps
    OPTION = "option"  # what was asked for: an argument, an option, a place to write to


class InputError(Exception):
    """Something the user gave is wrong: one line with place, value, bound and next step. Exit code 2.

    file, line and column (1-based) are None where they do not apply. str() is the line to print, a newline in it as
    \\n. excerpt: what is printed below it, mostly the line of the file with a caret below the place; shown() has both.
    kind: where it is raised, or of the innermost of_kind around that place; OPTION where neither says.
    """

    def __init__(
        self,
        message: str,
        *,
        file: str | None = None,
        line: int | None = None,
        column: int | None = None,
        excerpt: str | None = None,
        kind: ErrorKind | None = None,
    ):
        super().__init__(message)
        self.message, self.file, self.line, self.column, self.excerpt = message, file, line, column, excerpt
        self._kind = kind

    @property
    def kind(self) -> ErrorKind:
        """What is wrong."""
        return self._kind or ErrorKind.OPTION

    def take(self, kind: ErrorKind) -> None:
        """Be of a kind, unless it is of one already."""
        self._kind = self._kind or kind

    def saying(self, message: str) -> InputError:
        """The same error in other words."""
        place = {"file": self.file, "line": self.line, "column": self.column}
        return InputError(message, **place, excerpt=self.excerpt, kind=self._kind)  # type: ignore[arg-type]

    def __str__(self) -> str:
        place = ":".join(str(part) for part in (self.file, self.line, self.column) if part is not None)
        return terminal_text(printable(f"{place}: {self.message}" if place else self.message))

    def shown(self) -> str:
        """The line to print, and below it the excerpt."""
        return f"{self}\n{self.excerpt}" if self.excerpt else str(self)


class InputErrorGroup(InputError):
    """Several input errors found in one run; str() gives them one per line, in the order found."""

    def __init__(self, errors: Sequence[InputError]):
        first = errors[0]
        super().__init__(first.message, file=first.file, line=first.line, column=first.column, excerpt=first.excerpt)
        self.errors = tuple(errors)

    @property
    def kind(self) -> ErrorKind:
        """Of the first of them."""
        return self.errors[0].kind

    def take(self, kind: ErrorKind) -> None:
        """Let those of them that are of no kind yet be of this one."""
        for error in self.errors:
            error.take(kind)

    def __str__(self) -> str:
        return "\n".join(str(error) for error in self.errors)

    def shown(self) -> str:
        """Each with its excerpt, as many as a page holds, and how many more there are."""
        texts = [error.shown() for error in self.errors]
        fit = max(1, sum(length <= _PAGE for length in accumulate(len(text) + 1 for text in texts)))
        more = [f"{len(texts) - fit} more are not shown; correct these first"] if fit < len(texts) else []
        return "\n".join([*texts[:fit], *more])


@contextmanager
def of_kind(kind: ErrorKind) -> Iterator[None]:
    """InputErrors that leave the block, or the function that this decorates, are of a kind unless they are of one."""
    try:
        yield
    except InputError as error:
        error.take(kind)
        raise


@contextmanager
def placed(file: str) -> Iterator[None]:
    """InputErrors that leave the block without a place are about a file."""
    try:
        yield
    except InputError as error:
        error.file = error.file or file
        raise
