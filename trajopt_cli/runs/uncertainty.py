"""Between which times motions are, and what one saves against another, for the numbers that nobody is sure of."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Annotated

from pydantic import BeforeValidator, Field

from trajopt_cli.runs.record import Section

WRITTEN = "as_written"
"""What the program as it stands is called; plans are called as their targets."""
_Seconds = Annotated[float | None, BeforeValidator(lambda one: None if one is None or math.isinf(one) else one)]
Ends = Annotated[tuple[_Seconds, _Seconds], Field(strict=False)]


def between(ends: Sequence[float | None], passes: int = 1) -> str:
    """An interval of times by pass, rounded outward to the digits that a quarter of it is worth: "6.6 to 7.5"."""
    low, high = (math.inf if end is None else end / passes for end in ends)
    if math.isinf(high):
        return f"{low:.1f} or more"
    first, last, digits = _outward(low, high)
    return f"{first:.{digits}f} to {last:.{digits}f}"


def within(value: str, ends: Sequence[float | None] | None, scale: float = 1.0) -> str:
    """A value with its interval behind it, if it has one: "6.972 (6.6 to 7.5)"."""
    return value if ends is None else f"{value} ({between([end and end * scale for end in ends])})".replace("-", "−")


def changes(saved: Sequence[float | None]) -> str:
    """What becomes of a time of which between these shares are saved, in per cent: "−19 to −23"."""
    low, high = (100 * (share or 0.0) for share in saved)
    *ends, digits = _outward(low, high, 1)
    return " to ".join(f"{0.0 - end:+.{digits}f}".replace("-", "−") for end in ends)


def _outward(low: float, high: float, most: int = 3) -> tuple[float, float, int]:
    digits = min(most, max(0, math.ceil(-math.log10((high - low) / 4))))
    scale, hair = 10**digits, 0.05  # of the last digit: 6.4999 begins at 6.5
    return math.floor(low * scale + hair) / scale, math.ceil(high * scale - hair) / scale, digits


class Guess(Section):
    """Numbers of one kind and one source. shares: by axis, "tcp" or "stops", between which shares of its number the
    true one is; longer_s: by motion, how much longer it takes with the lower ends and with the upper ones, None: for
    ever."""

    name: str
    source: str
    shares: dict[str, Annotated[tuple[float, float], Field(strict=False)]]
    longer_s: Mapping[str, Ends]


class Uncertainty(Section):
    """Of motions by name, without those to which nothing unsure matters: between which times they are, None for no end,
    and between which shares of the time as written is what they save. guesses: those that matter to any."""

    cycle_time_range_s: Mapping[str, Ends] = Field(default_factory=dict)
    saving_range: Mapping[str, Ends] = Field(default_factory=dict)
    guesses: list[Guess] = Field(default_factory=list)

    def why(self, name: str) -> str:
        """What makes the interval of a motion: "with these guesses (6 joint accelerations, grade D)"."""
        most = max(self.guesses, key=lambda one: max(math.inf if x is None else abs(x) for x in one.longer_s[name]))
        word = "guesses" if most.name[-1] in "CD" else "numbers"
        return f"with these {word} ({'most: ' * (len(self.guesses) > 1)}{most.name})"

    def times(self, name: str) -> tuple[str, ...]:
        """Between which times a motion is: "6.6 to 7.5 s"; nothing where it is sure."""
        return (f"{between(self.cycle_time_range_s[name])} s",) if name in self.cycle_time_range_s else ()

    def around(self, name: str) -> str:
        """Behind a motion's time: ", 6.6 to 7.5 with these guesses (...)"; nothing where it is sure."""
        ends = self.cycle_time_range_s.get(name)
        return "" if ends is None else f", {between(ends)} {self.why(name)}"

    def saved(self, name: str) -> str:
        """Behind what becomes of the time as written, in per cent: ", −19 to −23"."""
        ends = self.saving_range.get(name)
        return "" if ends is None else f", {changes(ends)}"

    def intervals(self, names: tuple[str, ...], passes: int = 1) -> tuple[str, ...]:
        """Between which times a pass is by these motions, the first leads; a line where anything is unsure."""
        known = {name: self.cycle_time_range_s[name] for name in (WRITTEN, *names) if name in self.cycle_time_range_s}
        told = ", ".join(f"{name.replace('_', ' ')} {between(ends, passes)} s" for name, ends in known.items())
        return (f"{self.why(names[0])}: {told}",) if told else ()
