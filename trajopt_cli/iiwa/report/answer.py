"""What a command of the iiwa job answers, as plain data for any renderer: terminal, JSON, page."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from trajopt_cli.table import TextTable


@dataclass(frozen=True, eq=False)
class Answer:
    """What a command found.

    record: plain data in SI units. line: the result in one line. parts: for people, tables and lines of text. written:
    the file or folder that was written, None for none; where: the line about it. broken: one sentence each where limits
    are broken, for which the exit code is 1. draw: its pictures, file name -> contents.
    """

    record: Mapping[str, Any]
    line: str
    parts: Sequence[TextTable | Sequence[str]]
    written: Path | None
    where: str = ""
    broken: Sequence[str] = ()
    draw: Callable[[], Mapping[str, bytes]] = dict


@dataclass(frozen=True)
class Refused:
    """Why there is nothing to show: answer in a word or two, and one sentence each."""

    answer: str
    sentences: Sequence[str]
