"""Findings with one way of wording them: place, what, value, when, limit."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import reduce
from heapq import heappop, heappush
from itertools import islice

import numpy as np

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.motion import Source
from trajopt_cli.units import slides


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


class Series:
    """The worst of several series of values (times and values each, always the same ones in the same order) that are
    looked at window by window: what it would be had each been looked at as a whole, one after the other. limit:
    any where only values count."""

    def __init__(self, limit: float = 1.0):
        self._limit = limit
        self._worst: dict[float, Worst] = {}

    def add(self, series: Iterable[tuple[Array, Array]], begin: float = 0) -> None:
        """A window of every series. begin: the place of the first one among all."""
        for place, (times, values) in enumerate(series):
            if len(values):
                i = int(np.argmax(values))
                known = self._worst.get(begin + place)
                if known is None or values[i] > known.value:
                    self._worst[begin + place] = Worst(float(values[i]), self._limit, float(times[i]))

    @property
    def found(self) -> list[Worst]:
        """The worst of every series that has any value, in their order."""
        return [self._worst[place] for place in sorted(self._worst)]

    @property
    def worst(self) -> Worst:
        """The worst of all, the first of several; there must be one."""
        return reduce(worse, self.found)


class Columns:
    """The same of every column of several series of tables: times (m,) and values (m, k) each. limits: (k,)."""

    def __init__(self, limits: Array):
        self._limits = limits
        self._worst: dict[float, tuple[Array, Array]] = {}

    def add(self, series: Iterable[tuple[Array, Array]], begin: float = 0) -> None:
        """A window of every series. begin: the place of the first one among all."""
        for place, (times, values) in enumerate(series):
            if len(values):
                i = np.argmax(values, axis=0)
                worst, time = values[i, np.arange(len(i))], times[i]
                if (known := self._worst.get(begin + place)) is not None:
                    more = worst > known[0]
                    worst, time = np.where(more, worst, known[0]), np.where(more, time, known[1])
                self._worst[begin + place] = worst, time

    def worst(self, j: int) -> Worst:
        """The worst of column j of all series, the first of several; nothing at all where they have no values."""
        limit, found = float(self._limits[j]), (self._worst[place] for place in sorted(self._worst))
        each = [Worst(float(values[j]), limit, float(times[j])) for values, times in found]
        return reduce(worse, each) if each else Worst(0.0, limit, 0.0)


def axis_unit(name: str) -> str:
    """Unit of an axis' position."""
    return "m" if slides(name) else "rad"


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


def in_step(*checks: Iterator[tuple[int, list[Finding]]]) -> list[list[Finding]]:
    """The findings of checks that go through a file, each telling its row: the one farthest behind goes on next, so
    that what one of them works out is still at hand for the others."""
    found: list[list[Finding]] = [[] for _ in checks]
    behind = [(0, i) for i in range(len(checks))]
    while behind:
        _, i = heappop(behind)
        for row, findings in islice(checks[i], 1):
            found[i] += findings
            heappush(behind, (row, i))
    return found


SourceAt = Callable[[float], Source | None]
"""The motion under way at a time."""
