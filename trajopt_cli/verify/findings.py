"""Findings with one way of wording them: place, what, value, when, limit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from trajopt_cli.findings import Finding
from trajopt_cli.motion import Source


@dataclass(frozen=True)
class Worst:
    """The worst place of a check so far: value and limit there, the row's time."""

    value: float
    limit: float
    time: float

    @property
    def ratio(self) -> float:
        """How much of the limit is used."""
        return self.value / self.limit if self.limit > 0 else (float("inf") if self.value > 0 else 0.0)


def worse(a: Worst | None, b: Worst) -> Worst:
    """The one that uses more of its limit."""
    return b if a is None or b.ratio > a.ratio else a


def axis_unit(name: str) -> str:
    """Unit of an axis' position."""
    return "m" if name == "rail" else "rad"


def digits(value: float, limit: float) -> tuple[str, str]:
    """Both numbers with so many digits that they differ in print when they differ."""
    for n in range(4, 17):
        texts = f"{value:.{n}g}", f"{limit:.{n}g}"
        if texts[0] != texts[1]:
            return texts
    return texts


def finding(
    check: str,
    subject: str,
    value: float,
    limit: float,
    unit: str,
    passed: bool,
    *,
    time: float | None = None,
    source: Source | None = None,
    bound: str = "limit",
    note: str = "",
    words: str = "",
) -> Finding:
    """A finding; where it fails, its one-line message. bound: what the limit is ("limit", "at least", "wanted").
    words: the check as the message says it behind the subject, where that is not the check's name."""
    message = ""
    if not passed:
        printed, limit_printed = digits(value, limit)
        when = "" if time is None else f" at t = {time:.3f} s"
        place = "" if source is None else f"{source}: "
        message = f"{place}{subject} {words or check} {printed} {unit}{when}, {bound} {limit_printed}{note}"
    return Finding(check, subject, float(value), float(limit), unit, bool(passed), time, source, message)


SourceAt = Callable[[float], Source | None]
"""The motion under way at a time."""
