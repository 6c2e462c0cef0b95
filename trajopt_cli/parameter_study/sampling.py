"""Which points a study has: levels of its factors by grid, Latin hypercube, Sobol' sequence or at random, by a seed."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from scipy.special import ndtri
from scipy.stats import qmc

from trajopt_cli.geometry import Array

GRID = "grid"
METHODS = ("latin_hypercube", "sobol", "random")
_DIGITS = 9  # of a sampled number: as many as anyone reads, and the same text in every row


def normal(mean: float, sigma: float) -> Callable[[float], float]:
    """The quantile function of Gauss' distribution, by its mean and its standard deviation, SI."""
    return lambda share: mean + sigma * float(ndtri(share))


@dataclass(frozen=True)
class Factor:
    """What varies together: keys, and either the levels that they take, a value for each key, or the quantile function
    of the one key's number, SI. written: how the study file names it."""

    written: str
    keys: tuple[str, ...]
    levels: tuple[tuple[Any, ...], ...] = ()
    quantile: Callable[[float], float] | None = None

    def at(self, share: float) -> tuple[Any, ...]:
        """Values of the keys at a share of 0 to 1 of all that they take."""
        if self.quantile is None:
            return self.levels[min(int(share * len(self.levels)), len(self.levels) - 1)]
        return (float(f"{self.quantile(share):.{_DIGITS}g}"),)


@dataclass(frozen=True)
class Point:
    """One point. index: of all; program: which of the study's programs; values: of every key in the factors' order."""

    index: int
    program: int
    values: tuple[Any, ...]


@dataclass(frozen=True, eq=False)
class Design:
    """All points of a study, numbered: every program with the same samples, one program after the other.

    count, seed: of samples; a grid has all combinations, its last factor fastest.
    """

    factors: tuple[Factor, ...]
    programs: int
    method: str = GRID
    count: int = 0
    seed: int = 0

    def __len__(self) -> int:
        return self.programs * self.samples

    @property
    def samples(self) -> int:
        """Points of each program."""
        return math.prod(len(one.levels) for one in self.factors) if self.method == GRID else self.count

    def point(self, index: int) -> Point:
        """The point of a number."""
        program, sample = divmod(index, self.samples)
        return Point(index, program, self._values(sample))

    def extremes(self, factor: int) -> list[tuple[Any, ...]]:
        """The least and the greatest values of a factor that is sampled."""
        shares = self._shares[:, factor]
        return [self.factors[factor].at(float(share)) for share in (shares.min(), shares.max())]

    def _values(self, sample: int) -> tuple[Any, ...]:
        if self.method == GRID:
            at = np.unravel_index(sample, [len(one.levels) for one in self.factors])
            chosen: Sequence[tuple[Any, ...]] = [one.levels[i] for one, i in zip(self.factors, at, strict=True)]
        else:
            chosen = [one.at(float(u)) for one, u in zip(self.factors, self._shares[sample], strict=True)]
        return tuple(value for values in chosen for value in values)

    @cached_property
    def _shares(self) -> Array:
        """Samples (count, factors) between 0 and 1."""
        many, rng = len(self.factors), np.random.default_rng(self.seed)
        if self.method == "random":
            return rng.random((self.count, many))
        sampler = qmc.Sobol if self.method == "sobol" else qmc.LatinHypercube
        out: Array = sampler(many, rng=rng).random(self.count)
        return out
