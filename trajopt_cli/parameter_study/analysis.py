"""What the rows of a study say together: the best points, what matters most, Pareto fronts, the spread."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations, islice, product, takewhile
from typing import Any

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.validation import hint

ANSWERS = ("rapid_s", "stream_s", "as_written_s", "fixed_rail_s", "saved_s", "price")
"""Columns of numbers that a point answers, the one that is asked for by default first; less is better."""
MORE_IS_BETTER = ("saved_s",)
_OTHERS = ("point", "rapid_bound_s", "stream_bound_s", "change_first", "change_first_saves_s", "status", "reason")
_LEVELS = 12  # of a factor of names or of a grid: as many contrasts less one tell its effect whole
_DEGREES = (1, 2, 3, 4, 5, 6, 8, 10, 12)  # of an expansion; Ishigami's function needs 8 for 1 % in a share
_NORMS = (1.0, 0.5)  # of a term's degrees: all of a total degree, or few of them mixed
_TERMS, _POINTS = 400, 20_000  # of an expansion at most: with 60 factors they take 5 s
_MIXED = 3  # factors in one term


@dataclass(frozen=True, eq=False)
class StudyRows:
    """The rows of a study by column. units: of each column."""

    columns: Mapping[str, Sequence[Any]]
    units: Mapping[str, str]

    @cached_property
    def ok(self) -> IndexArray:
        """Which rows have an answer."""
        return np.flatnonzero([status == "ok" for status in self.columns["status"]])

    @cached_property
    def factors(self) -> tuple[str, ...]:
        """The columns that vary, as the study file has them."""
        varied = (name for name in self.columns if name not in (*ANSWERS, *_OTHERS))
        return tuple(name for name in varied if len({*self.columns[name]}) > 1)

    @cached_property
    def answers(self) -> tuple[str, ...]:
        """The columns of answers that hold a number in a row with an answer."""
        there = (name for name in ANSWERS if name in self.columns)
        return tuple(name for name in there if any(self.columns[name][i] is not None for i in self.ok))

    def chosen(self, name: str | None) -> str:
        """A column of answers; by default the first there is. Raises InputError for one that is not there."""
        if name is not None and name not in self.answers:
            raise InputError(f"no column '{name}' of answers; {hint(name, self.answers)}")
        return name or self.answers[0]

    def numbers(self, name: str) -> Array:
        """A column (n,) of numbers, NaN where there is none."""
        return np.array([np.nan if one is None else one for one in self.columns[name]], dtype=float)

    def best(self, name: str) -> IndexArray:
        """Rows with an answer from the best to the worst, of equal ones the first point first."""
        values = self.numbers(name)[self.ok] * (-1 if name in MORE_IS_BETTER else 1)
        order = np.argsort(values, kind="stable")
        return self.ok[order[: np.isfinite(values).sum()]]

    def records(self, where: IndexArray) -> list[dict[str, Any]]:
        """Rows as plain data."""
        return [{name: column[i] for name, column in self.columns.items()} for i in map(int, where)]


def pareto(values: Array) -> IndexArray:
    """Rows of values (n, 2) that no other row is better than in one column and not worse in the other, by the first
    column; less is better. Of equal rows the first."""
    order = np.lexsort((np.arange(len(values)), values[:, 1], values[:, 0]))
    before = np.r_[np.inf, np.minimum.accumulate(values[order, 1])[:-1]] if len(order) else np.empty(0)
    front: IndexArray = order[values[order, 1] < before]
    return front


@dataclass(frozen=True)
class Share:
    """How much of the variance that is explained comes from a factor: alone (Sobol' index of first order), and with all
    that it does together with others (of total effect)."""

    columns: tuple[str, ...]
    alone: float
    total: float

    @property
    def factor(self) -> str:
        """Its name: of several columns what their names have in common, as limits.rail, or all of them."""
        parts = zip(*(one.split(".") for one in self.columns), strict=False)
        return ".".join(some[0] for some in takewhile(lambda some: len({*some}) == 1, parts)) or ", ".join(self.columns)


@dataclass(frozen=True)
class Shares:
    """Variance shares, the largest total first. explained: of the variance, in points that the expansion was not fitted
    to (leave-one-out). points, terms, degree: of the expansion."""

    shares: tuple[Share, ...]
    explained: float
    points: int
    terms: int
    degree: int

    @property
    def in_words(self) -> str:
        """How they were found."""
        return (
            f"Sobol' indices of a polynomial chaos expansion of degree {self.degree} ({self.terms} terms, "
            f"{self.points} points); it explains {100 * self.explained:.1f} % of the variance at points left out"
        )


def variance_shares(rows: StudyRows, name: str) -> Shares | None:
    """Which factors an answer depends on, over the points that have one; None where they are too few, or it never
    varies.

    Least squares on products of polynomials, orthonormal under each factor's own distribution; of names, contrasts.
    Of several expansions the one that foretells points that it was not fitted to best (leave-one-out).
    """
    where = rows.best(name)
    where = np.sort(where)[:: max(1, -(-len(where) // _POINTS))]
    y = rows.numbers(name)[where]
    if len(y) < 4 or np.ptp(y) <= 1e-12 * np.abs(y).max():
        return None
    columns = {factor: [rows.columns[factor][i] for i in where] for factor in rows.factors}
    owners = _owners(columns)
    bases = [_basis(columns[owner]) for owner in owners]
    most = min(len(y) // 2, _TERMS)
    found: tuple[float, list[tuple[int, ...]], Array, int] | None = None
    for degree, norm in product(_DEGREES, _NORMS):
        terms = [*islice(_terms([base.shape[1] for base in bases], degree, norm), most + 1)]
        if len(terms) > most or (found is not None and terms == found[1]):
            continue
        A = np.column_stack(
            [np.prod([base[:, k] for base, k in zip(bases, term, strict=True)], axis=0) for term in terms]
        )
        Q, R = np.linalg.qr(A)
        if np.abs(np.diag(R)).min() < 1e-8 * np.abs(np.diag(R)).max():
            continue
        residual = (y - Q @ (Q.T @ y)) / np.maximum(1.0 - (Q**2).sum(axis=1), 1e-12)
        if found is None or residual @ residual < found[0] * (1 - 1e-6):
            found = float(residual @ residual), terms, np.linalg.solve(R, Q.T @ y), degree
    if found is None or len(found[1]) < 2:
        return None
    error, terms, c, degree = found
    used, power = np.array(terms) > 0, c**2 / (c[1:] ** 2).sum()
    alone = used.sum(axis=1) == 1
    shares = (
        Share(tuple(names), float(power[used[:, i] & alone].sum()), float(power[used[:, i]].sum()))
        for i, names in enumerate(owners.values())
    )
    explained = max(0.0, 1 - error / float(((y - y.mean()) ** 2).sum()))
    return Shares(tuple(sorted(shares, key=lambda one: -one.total)), explained, len(y), len(terms), degree)


def _owners(columns: Mapping[str, Sequence[Any]]) -> dict[str, list[str]]:
    """Columns that follow from another one's level, as a drive's speed does from its name, are one factor with it: all
    of them, by the one that the others follow from."""
    sizes = {name: len({*values}) for name, values in columns.items()}
    owners = dict[str, list[str]]()
    for name in sorted(columns, key=lambda one: -sizes[one]):
        values = columns[name]
        above = (one for one in owners if sizes[one] < len(values))  # levels that are met once say nothing
        owner = next((one for one in above if len({*zip(columns[one], values, strict=True)}) == sizes[one]), name)
        owners.setdefault(owner, []).append(name)
    return owners


def _basis(values: Sequence[Any]) -> Array:
    """Functions (n, k) of a factor at its values, the first one 1, orthonormal over them: polynomials, of names the
    contrasts between them."""
    known = {value: i for i, value in enumerate(dict.fromkeys(values))}
    if not all(isinstance(value, int | float) for value in known):
        columns = np.eye(len(known))[[known[value] for value in values]]
        columns[:, 0] = 1.0
    else:
        x = np.array(values, dtype=float)
        x = (x - x.mean()) / np.abs(x - x.mean()).max() if len(known) > 1 else 0 * x
        columns = np.polynomial.legendre.legvander(x, min(len(known) - 1, _LEVELS))
    Q, R = np.linalg.qr(columns)
    return np.asarray(Q * np.sign(np.diag(R)) * np.sqrt(len(values)))


def _terms(sizes: Sequence[int], degree: int, norm: float) -> Iterator[tuple[int, ...]]:
    """The degrees of each factor in every term of an expansion."""
    for count in range(min(len(sizes), _MIXED, degree) + 1):
        for factors in combinations(range(len(sizes)), count):
            for powers in product(*(range(1, min(sizes[i] - 1, degree) + 1) for i in factors)):
                if sum(power**norm for power in powers) <= degree**norm + 1e-9:
                    at = dict(zip(factors, powers, strict=True))
                    yield tuple(at.get(i, 0) for i in range(len(sizes)))
