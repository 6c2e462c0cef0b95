"""What a user should know besides an answer, with a kind, so that nothing has to be read out of its words."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import NamedTuple


class Source(NamedTuple):
    """A place in a program: file as the user gave it, line and column counted from 1."""

    file: str
    line: int
    column: int

    def __str__(self) -> str:
        return f"{self.file}:{self.line}:{self.column}"


class WarningKind(Enum):
    """What a notice is about."""

    UNUSUAL = "unusual"  # the program is odd, and read all the same
    ASSUMED = "assumed"  # the program leaves it open, and something is taken
    NO_EFFECT = "no effect"  # on motion
    UNUSED = "unused"  # a name or a mark that nothing asks for
    ENDLESS = "endless loop"  # of which some passes in steady state are planned
    NOT_READ = "not read"  # a file beside those that were
    NOT_CHECKED = "not checked"  # what the user would expect to be; told before all else
    DOUBTFUL = "doubtful"  # the cell does not suit the program
    CHANGED = "changed"  # by an export


@dataclass(frozen=True)
class ProgramWarning:
    """kind, the sentence without its place, and the place: a source, a file, or None for the whole program."""

    kind: WarningKind
    text: str
    place: Source | str | None = None

    def __str__(self) -> str:
        return self.text if self.place is None else f"{self.place}: {self.text}"
