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
from typing import Any

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.geometry import Array, IndexArray

_FINEST = 15  # digits beyond the fifteenth decimal are under the rounding of any double near 1
_COARSEST = 30  # zeros before the point
_ALL = 17  # characters of a number that has all its digits
_SHARE = 0.2  # of the values of a magnitude
_FEW = 8  # changes of a column that say little about its format
_ZERO = -99  # the magnitude of 0, which has none
_BASE = 64  # more than the decimals of any two numbers lie apart
_PLAIN = re.compile(r"[+-]?[0-9]+\.([0-9]*)").fullmatch


class Digits:
    """The decimals of every value of a table (rows, columns) that is read part by part."""

    def __init__(self, rows: int, columns: int):
        self._decimals = np.zeros((columns, rows), dtype=np.int8)
        self._sizes = np.zeros((columns, rows), dtype=np.int8)
        self._counts = [Counter[tuple[int, int]]() for _ in range(columns)]
        self._last = [""] * columns

    def add(self, rows: list[str], table: Array, first: int) -> None:
        """Rows from the row first on, as text with commas and as numbers (n, columns)."""
        part = slice(first, first + len(rows))
        with np.errstate(divide="ignore"):
            sizes = np.floor(np.log10(np.abs(table)) + 1e-12)
        sizes = np.where(np.isfinite(sizes), np.clip(sizes, _ZERO + 1, -_ZERO), _ZERO).astype(np.int8)
        fields = _Fields(rows, len(self._counts))
        for column, (counts, last) in enumerate(zip(self._counts, self._last, strict=True)):
            new = fields.changes(column, table[:, column], last)
            self._sizes[column, part] = sizes[:, column]
            decimals = self._decimals[column, part]
            before = self._decimals[column, first - 1]
            if not new.size:  # a column at rest
                decimals[:] = before
                continue
            found = fields.decimals(new, column)
            decimals[:] = np.repeat(np.append(before, found), np.diff(np.concatenate([[0], new, [len(rows)]])))
            pairs = np.bincount((sizes[new, column].astype(np.intp) - _ZERO) * _BASE + found + _COARSEST)
            for pair in np.flatnonzero(pairs).tolist():
                counts[pair // _BASE + _ZERO, pair % _BASE - _COARSEST] += int(pairs[pair])
            self._last[column] = fields.text(-1, column)

    def last(self) -> list[NDArray[np.int8]]:
        """The decimals (rows,) of the last digit that is told of every value, by column: it is known to half a unit of
        that."""
        known = [self._format(counts) for counts in self._counts]
        many = [_changes(counts) >= _FEW for counts in self._counts]
        formats = [one for one, often in zip(known[1:], many[1:], strict=True) if often]
        formats = formats or [one for one in known[1:] if max(one.values()) == _FINEST]  # rows of one rest
        out = []
        for column, often in enumerate(many):
            sizes, decimals = self._sizes[column], self._decimals[column]
            borrow = column > 0 and not often
            least = np.zeros(1 - 2 * _ZERO, dtype=np.int8)  # by magnitude, negative ones from the end
            for size in np.unique(sizes).tolist():
                least[size] = max(_at(one, size) for one in ([known[column], *formats] if borrow else [known[column]]))
            out.append(np.maximum(decimals, least[sizes]))
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


class _Fields:
    """The fields of rows of text with commas between them, so many in a row."""

    def __init__(self, rows: list[str], columns: int):
        self._all = text = ",".join([*rows, ""])
        encoding, kind = ("ascii", "<u1") if text.isascii() else ("utf-32-le", "<u4")
        self._text: NDArray[Any] = np.frombuffer(text.encode(encoding), dtype=kind)
        # where points are, and what stands in no plain number
        self._points = np.flatnonzero(self._text == ord("."))
        self._odd = np.flatnonzero((self._text < ord("+")) | (self._text > ord("9")) | (self._text == ord("/")))
        ends = np.flatnonzero(self._text == ord(","))
        starts = np.append(0, ends[:-1] + 1)
        self._starts, self._sizes = (x.reshape(len(rows), columns) for x in (starts, ends - starts))

    def changes(self, column: int, values: Array, last: str) -> IndexArray:
        """The rows where a column's text is another than in the row before, in the first one than last. values (n,):
        its numbers."""
        size = self._sizes[:, column]
        new = np.append(self.text(0, column) != last, (values[1:] != values[:-1]) | (size[1:] != size[:-1]))
        same = np.flatnonzero(~new[1:]) + 1  # the same number, but it may be written in another way: 0.50 and +0.5
        if same.size:
            at = np.arange(size[same].max())[:, None]
            one, other = (self._letters(at, row, column) for row in (same, same - 1))
            new[same] = ((one != other) & (at < size[same])).any(axis=0)
        return np.flatnonzero(new)

    def _letters(self, at: IndexArray, rows: IndexArray, column: int) -> NDArray[Any]:
        """Letters (len(at), len(rows)) of fields; at (n, 1): which."""
        letters: NDArray[Any] = self._text[np.minimum(self._starts[rows, column] + at, len(self._text) - 1)]
        return letters

    def decimals(self, rows: IndexArray, column: int) -> NDArray[np.int8]:
        """The decimals that a column shows in some rows, _FINEST where it has all its digits."""
        out = np.full(len(rows), _FINEST, dtype=np.int8)
        short = np.flatnonzero(self._sizes[rows, column] <= _ALL)
        begin = self._starts[rows[short], column]
        end = begin + self._sizes[rows[short], column]
        (point, next_point), (odd, next_odd) = (
            np.searchsorted(places, (begin, end)) for places in (self._points, self._odd)
        )
        known = (next_point - point <= 1) & (next_odd == odd)  # digits, and a point or none
        plain = known & (next_point > point)
        out[short[known]] = 0
        out[short[plain]] = np.minimum(end[plain] - self._points[point[plain]] - 1, _FINEST)
        for k in short[~known].tolist():
            out[k] = decimals_of(self.text(int(rows[k]), column))
        return out

    def text(self, row: int, column: int) -> str:
        """One field."""
        start = int(self._starts[row, column])
        return self._all[start : start + int(self._sizes[row, column])]


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
