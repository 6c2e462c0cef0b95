"""Times between the states of two waypoints, as tables: all pairs, or a band where few have any."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.geometry import Array, BoolArray, IndexArray


@dataclass(frozen=True, eq=False)
class Dense:
    """Times (n_a, n_b) between all states."""

    T: Array

    def into(self, cost: Array) -> tuple[IndexArray, Array]:
        """From which state each state behind is reached with the least cost, cost (n_a,) being spent before; that
        cost (n_b,)."""
        total = cost[:, None] + self.T
        return np.argmin(total, axis=0), np.min(total, axis=0)

    def out(self, cost: Array, most: Array | None = None) -> Array:
        """The least cost (n_a,) to the end, that from the states behind being cost (n_b,). What is more than most
        (n_a,) may be told as less, but as more than that."""
        return np.asarray(np.min(self.T + cost[None], axis=1))

    def at(self, i: IndexArray | int, j: IndexArray | int) -> Array:
        """Times (...) between states of these numbers (...), broadcast."""
        return self.T[i, j]

    def dense(self) -> Array:
        """Times between all states."""
        return self.T


@dataclass(frozen=True, eq=False)
class Lazy:
    """Times T (n_a, n_b) between all states that are no more than at least so much; doubt (n_a, n_b): by how many of
    the questions. Each tells more, given the numbers of states (k,), the last one all, and is asked only where that may
    matter."""

    T: Array
    doubt: NDArray[np.int8]
    questions: Sequence[Callable[[IndexArray, IndexArray], Array]]

    def into(self, cost: Array) -> tuple[IndexArray, Array]:
        """As of Dense."""
        total = self._settled(cost[:, None], 0)
        source = np.argmin(total, axis=0)
        return source, total[source, np.arange(total.shape[1])]

    def out(self, cost: Array, most: Array | None = None) -> Array:
        """As of Dense."""
        return np.asarray(np.min(self._settled(cost[None], 1, most), axis=1))

    def at(self, i: IndexArray | int, j: IndexArray | int) -> Array:
        """As of Dense."""
        i, j = np.broadcast_arrays(i, j)
        doubtful = self.doubt[i, j] > 0
        self._ask(i[doubtful], j[doubtful])
        return self.T[i, j]

    def dense(self) -> Array:
        """As of Dense."""
        a, b = np.nonzero(self.doubt)
        self._ask(a, b)
        return self.T

    def _settled(self, cost: Array, axis: int, most: Array | None = None) -> Array:
        """T and cost, (n_a, 1) or (1, n_b), with nothing in doubt that could be the least along an axis, but where that
        is more than most."""
        total = cost + self.T
        lines = np.arange(total.shape[1 - axis])
        if most is not None:
            lines = lines[np.min(total, axis=axis) <= most]
        for _ in range(3):
            first = np.argmin(total if len(lines) == total.shape[1 - axis] else total.take(lines, 1 - axis), axis=axis)
            a, b = (first, lines)[:: 1 if axis == 0 else -1]
            doubtful = self.doubt[a, b] > 0
            a, b, lines = a[doubtful], b[doubtful], lines[doubtful]
            if not len(lines):
                return total
            self._ask(a, b)
            total[a, b] = np.broadcast_to(cost, total.shape)[a, b] + self.T[a, b]
        part = (slice(None), lines)[:: 1 if axis == 0 else -1]
        doubt, some = self.doubt[part] > 0, total[part]
        known = np.min(np.where(doubt, np.inf, some), axis=axis, keepdims=True)
        a, b = np.nonzero(doubt & (some < known))
        known = np.broadcast_to(known, some.shape)[a, b]
        a, b = (a, lines[b]) if axis == 0 else (lines[a], b)
        for number in range(len(self.questions)):
            new = self.doubt[a, b] == len(self.questions) - number
            self._ask(a[new], b[new], number)
            total[a, b] = np.broadcast_to(cost, total.shape)[a, b] + self.T[a, b]
            left = (self.doubt[a, b] > 0) & (total[a, b] < known)
            a, b, known = a[left], b[left], known[left]
        return total

    def _ask(self, a: IndexArray, b: IndexArray, number: int = -1) -> None:
        """One of the questions, the last one by default, of states (k,) that are in doubt."""
        if len(a):
            left = 0 if number < 0 else len(self.questions) - 1 - number
            self.T[a, b], self.doubt[a, b] = self.questions[number](a, b), left


@dataclass(frozen=True, eq=False)
class Band:
    """Times between states of one label whose rail positions are a few steps apart. A state is a pair of label and
    rail number, in a and b (2, n_a), (2, n_b), sorted by label.

    shifts (s,): steps, descending. times (s, L, n): from rail number i to i + shift, infinite where there is none.
    """

    shifts: IndexArray
    times: Array
    a: IndexArray
    b: IndexArray

    @cached_property
    def _parts(self) -> list[tuple[slice, slice, Array]]:
        """Of each shift: rail numbers before and behind, and the times between them."""
        n, out = self.times.shape[2], []
        for shift, T in zip(self.shifts.tolist(), self.times, strict=True):
            before = slice(max(0, -shift), n - max(0, shift))
            out.append((before, slice(before.start + shift, before.stop + shift), T[:, before]))
        return out

    def back(self, a: IndexArray, b: IndexArray) -> Band:
        """The other way round, between states a and b."""
        times = np.full_like(self.times, np.inf)
        for (_, behind, T), there in zip(self._parts, times[::-1], strict=True):
            there[:, behind] = T
        return Band(self.shifts, times, a, b)

    def _on_grid(self, states: IndexArray, values: Array) -> Array:
        grid = np.full(self.times.shape[1:], np.inf)
        grid[states[0], states[1]] = values
        return grid

    def into(self, cost: Array) -> tuple[IndexArray, Array]:
        """As of Dense."""
        spent, number = self._on_grid(self.a, cost), np.zeros(self.times.shape[1:], dtype=np.intp)
        number[self.a[0], self.a[1]] = np.arange(len(cost))
        least, source = np.full(spent.shape, np.inf), np.zeros(spent.shape, dtype=np.intp)
        for before, behind, T in self._parts:  # of equal ones that with the lowest number, which comes first
            total = spent[:, before] + T
            better = total < least[:, behind]
            least[:, behind] = np.where(better, total, least[:, behind])
            source[:, behind] = np.where(better, number[:, before], source[:, behind])
        return source[self.b[0], self.b[1]], least[self.b[0], self.b[1]]

    def out(self, cost: Array, most: Array | None = None) -> Array:
        """As of Dense."""
        left = self._on_grid(self.b, cost)
        least = np.full(left.shape, np.inf)
        for before, behind, T in self._parts:
            least[:, before] = np.minimum(least[:, before], T + left[:, behind])
        return np.asarray(least[self.a[0], self.a[1]])

    def at(self, i: IndexArray | int, j: IndexArray | int) -> Array:
        """As of Dense."""
        (label, rail), (label_b, rail_b) = self.a[:, i], self.b[:, j]
        steps = rail_b - rail
        shift = np.minimum(np.searchsorted(-self.shifts, -steps), len(self.shifts) - 1)
        there = (self.shifts[shift] == steps) & (label == label_b)
        return np.where(there, self.times[shift, label, rail], np.inf)

    def dense(self) -> Array:
        """As of Dense."""
        labels, n = self.times.shape[1:]
        best = np.full((labels, n, n), np.inf)
        for before, behind, T in self._parts:
            best[:, np.arange(n)[before], np.arange(n)[behind]] = T
        T = np.full((self.a.shape[1], self.b.shape[1]), np.inf)
        for times, (a, b) in zip(best, self.blocks, strict=True):
            T[a, b] = times[self.a[1, a, None], self.b[1, b]]
        return T

    @property
    def blocks(self) -> list[tuple[slice, slice]]:
        """Of each label its states before and behind."""
        labels = np.arange(self.times.shape[1] + 1)
        ends = (pairwise(np.searchsorted(x[0], labels).tolist()) for x in (self.a, self.b))
        return [(slice(*a), slice(*b)) for a, b in zip(*ends, strict=True)]


@dataclass(frozen=True, eq=False)
class Checked:
    """A table whose pairs (n_a, n_b) are looked at by and by, known or not, and may turn out to take longer. extra: by
    how much, where the table below asks questions."""

    edge: Dense | Lazy | Band
    known: BoolArray
    extra: Array | None = None

    @classmethod
    def of(cls, edge: Dense | Lazy | Band, states: tuple[int, int]) -> Checked:
        """A table of its own."""
        known = np.zeros(states, dtype=bool)
        if isinstance(edge, Band):
            return cls(Band(edge.shifts, edge.times.copy(), edge.a, edge.b), known)
        if isinstance(edge, Dense):
            return cls(Dense(edge.T.copy()), known)
        extra = np.zeros(states)

        def later(question: Callable[[IndexArray, IndexArray], Array]) -> Callable[[IndexArray, IndexArray], Array]:
            return lambda i, j: question(i, j) + extra[i, j]

        return cls(Lazy(edge.T.copy(), edge.doubt.copy(), [later(one) for one in edge.questions]), known, extra)

    def add(self, i: IndexArray, j: IndexArray, time: Array) -> None:
        """More time (k,) [s] between pairs of states (k,); of a band infinite."""
        if isinstance(self.edge, Band):
            (label, rail), rail_b = self.edge.a[:, i], self.edge.b[1, j]
            number = {int(shift): at for at, shift in enumerate(self.edge.shifts)}
            for L, start, end, T in zip(label, rail, rail_b, time, strict=True):
                self.edge.times[number[int(end - start)], L, start] += T
            return
        self.edge.T[i, j] += time
        if self.extra is not None:
            self.extra[i, j] += time

    def into(self, cost: Array) -> tuple[IndexArray, Array]:
        """As of Dense."""
        return self.edge.into(cost)

    def out(self, cost: Array, most: Array | None = None) -> Array:
        """As of Dense."""
        return self.edge.out(cost, most)

    def at(self, i: IndexArray | int, j: IndexArray | int) -> Array:
        """As of Dense."""
        return self.edge.at(i, j)

    def dense(self) -> Array:
        """As of Dense."""
        return self.edge.dense()

    @property
    def least(self) -> Array:
        """No more than the times (n_a, n_b), as far as was asked."""
        return self.edge.dense() if isinstance(self.edge, Band) else self.edge.T


Edge = Dense | Lazy | Band | Checked
