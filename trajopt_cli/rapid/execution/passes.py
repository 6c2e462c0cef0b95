"""The passes of a loop that has no condition, and the motions that are its steady cycle, as plain data."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from trajopt_cli.motion import Source


class State(NamedTuple):
    """How many motions, warnings, missing values and refusals there are at the end of a pass, how often each statement
    ran, and each instruction without effect."""

    motions: int
    warnings: int
    missing: int
    refusals: int
    counts: Mapping[int, int]
    ignored: Counter[str]


@dataclass
class Passes:
    """The passes of one loop that counted. marks: where they begin and end in the motions. leaves: the loop may take a
    way out, and nobody says after how many passes it is over; repeats: the first of these passes do. ends: of the
    first passes."""

    loop: str
    source: Source
    marks: list[int]
    leaves: bool
    ends: list[State] = field(default_factory=list)
    count: int = 0
    repeats: bool = False


class Cycle(NamedTuple):
    """Motions from first up to, not including, last, in so many passes. beyond: where those end that are other ones."""

    first: int
    last: int
    passes: int
    closed: bool = True
    beyond: int = 0
