"""How finely the numbers of a table are printed, told from their digits alone, value by value.

A value is off by half its last digit at most. But a format may leave out zeros at the end ("0.5" among "0.4987"), so a
value's own last digit is only the coarsest that its step can be. What the format is shows in the values of the same
magnitude (power of ten): the step there is what at least _SHARE of them show, for of numbers without their last zeros
nine in ten show the last digit, and a few that somebody else wrote to all digits show nothing about the others. Values
of another magnitude tell, too: every format prints small numbers at least as finely as large ones (fixed decimals: the
same; significant digits: one decimal more for each power of ten), and none gains more than that. A value that stays
as it is from row to row counts once; a column that hardly ever changes is taken to be printed like the finest of the
others.
"""

from __future__ import annotations

import re
from collections import Counter
from decimal import Decimal, InvalidOperation
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.geometry import Array

_FINEST = 15  # digits beyond the fifteenth decimal are under the rounding of any double near 1
_COARSEST = 30  # zeros before the point
_ALL = 17  # characters of a number that has all its digits
_SHARE = 0.2  # of the values of a magnitude
_FEW = 8  # changes of a column that say little about its format
_ZERO = -99  # the magnitude of 0, which has none
_PLAIN = re.compile(r"[+-]?[0-9]+\.([0-9]*)").fullmatch


class Digits:
    """The decimals of every value of a table (rows, columns) that is read part by part."""

    def __init__(self, rows: int, columns: int):
        self._decimals = np.zeros((columns, rows), dtype=np.int8)
        self._sizes = np.zeros((columns, rows), dtype=np.int8)
        self._counts = [Counter[tuple[int, int]]() for _ in range(columns)]
        self._last = [""] * columns

    def add(self, fields: list[list[str]], table: Array, first: int) -> None:
        """Rows from the row first on, as text and as numbers (n, columns)."""
        part = slice(first, first + len(fields))
        with np.errstate(divide="ignore"):
            sizes = np.floor(np.log10(np.abs(table)) + 1e-12)
        sizes = np.where(np.isfinite(sizes), np.clip(sizes, _ZERO + 1, -_ZERO), _ZERO).astype(np.int8)
        for column, (counts, last) in enumerate(zip(self._counts, self._last, strict=True)):
            texts = [row[column] for row in fields]
            if texts.count(last) == len(texts):  # a column at rest
                decimals = self._decimals[column, first - 1]
                self._decimals[column, part], self._sizes[column, part] = decimals, sizes[:, column]
                continue
            decimals = [_FINEST if len(text) > _ALL else decimals_of(text) for text in texts]
            new = [text != before for text, before in zip(texts, [last, *texts[:-1]], strict=True)]
            counts.update(
                key for key, one in zip(zip(sizes[:, column].tolist(), decimals, strict=True), new, strict=True) if one
            )
            self._last[column] = texts[-1]
            self._decimals[column, part], self._sizes[column, part] = decimals, sizes[:, column]

    def last(self) -> list[NDArray[np.int8]]:
        """The decimals (rows,) of the last digit that is told of every value, by column: it is known to half a unit of
        that."""
        known = [self._format(counts) for counts in self._counts]
        out = []
        for column, counts in enumerate(self._counts):
            sizes, decimals = self._sizes[column], self._decimals[column]
            borrow = column > 0 and _changes(counts) < _FEW
            formats = [one for i, one in enumerate(known) if i and _changes(self._counts[i]) >= _FEW]
            formats = formats or [one for one in known[1:] if max(one.values()) == _FINEST]  # rows of one rest
            told = np.empty(len(sizes), dtype=np.int8)
            for size in np.unique(sizes).tolist():
                here = sizes == size
                least = max(_at(one, size) for one in ([known[column], *formats] if borrow else [known[column]]))
                told[here] = np.maximum(decimals[here], least)
            out.append(told)
        return out

    @staticmethod
    def _format(counts: Counter[tuple[int, int]]) -> dict[int, int]:
        """The decimals that a column shows at each magnitude of its values."""
        by_size: dict[int, Counter[int]] = {}
        for (size, decimals), count in counts.items():
            by_size.setdefault(size, Counter())[decimals] += count
        out = {}
        for size, found in by_size.items():
            needed, seen = _SHARE * found.total(), 0
            for decimals in sorted(found, reverse=True):
                seen += found[decimals]
                if seen >= needed:
                    out[size] = decimals
                    break
        return out


def _changes(counts: Counter[tuple[int, int]]) -> int:
    """How many values of a column say anything about its format: 0 and -0 do not."""
    return sum(count for (size, _), count in counts.items() if size != _ZERO)


def _at(known: dict[int, int], size: int) -> int:
    """The least decimals of a magnitude, by those that are known: of larger ones no fewer, of smaller ones one fewer
    for each power of ten at most."""
    return max(-_COARSEST, *(decimals - max(size - other, 0) for other, decimals in known.items()))


def decimals_of(text: str) -> int:
    """Decimals that a number is printed with, at most 15; less than none for "1e3"."""
    plain = _PLAIN(text)
    return min(len(plain[1]), _FINEST) if plain else _decimals_of_any(text)


@lru_cache(maxsize=64)  # what rests is the same from row to row
def _decimals_of_any(text: str) -> int:
    try:
        exponent = Decimal(text.strip()).as_tuple().exponent
    except InvalidOperation:
        return _FINEST  # a spelling float() knows and Decimal does not: nothing can be said against its digits
    return max(min(-exponent, _FINEST), -_COARSEST) if isinstance(exponent, int) else _FINEST
