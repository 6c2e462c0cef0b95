"""Cases for a judge: motions whose excess over a limit is known, with a share of what is granted there."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import pytest

from trajopt_cli.findings import Finding


@dataclass(frozen=True)
class Told:
    """One finding among others as it has to be."""

    found: Iterable[Finding]
    check: str
    subject: str
    value: float
    limit: float
    time: float


class Cases(dict[str, Callable[[float], Told]]):
    """By name what makes a case with a share of what is granted."""

    def one(self, make: Callable[[float], Told]) -> Callable[[float], Told]:
        """Register a case."""
        self[make.__name__] = make
        return make

    def with_each(self, values: Iterable[object]) -> Callable[..., Callable[..., Told]]:
        """Register a case once for each value of its second argument."""

        def add(make: Callable[..., Told]) -> Callable[..., Told]:
            for value in values:
                self[f"{make.__name__} {value}"] = lambda share, value=value: make(share, value)
            return make

        return add

    def check(self, name: str) -> None:
        """With 0.999 of what is granted it has to pass, with 1.001 not; both are told at the same place, each with its
        own number."""
        for share, passes in ((0.999, True), (1.001, False)):
            told = self[name](share)
            ones = [one for one in told.found if (one.check, one.subject) == (told.check, told.subject)]
            one = min(ones, key=lambda one: abs(one.value - told.value))
            assert abs(one.value - told.value) <= max(1e-14, 0.03 * abs(told.value - told.limit)), (one, told)
            assert one.limit == pytest.approx(told.limit, rel=1e-12)
            assert one.time == pytest.approx(told.time, rel=1e-12)
            assert one.passed == passes, one
            assert passes or (told.subject in one.message and f"t = {told.time:.3f} s" in one.message)
            assert not passes or one.message == ""
