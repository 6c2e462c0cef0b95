"""Times between the states of two waypoints, as tables: all pairs, or a band where few have any."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

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

    def out(self, cost: Array) -> Array:
        """The least cost (n_a,) to the end, that from the states behind being cost (n_b,)."""
        return np.asarray(np.min(self.T + cost[None], axis=1))

    def at(self, i: int, j: int) -> float:
        """Time between two states."""
        return float(self.T[i, j])

    def dense(self) -> Array:
        """Times between all states."""
        return self.T


@dataclass(frozen=True, eq=False)
class Lazy:
    """Times T (n_a, n_b) between all states, of which those in doubt (n_a, n_b) are no more than at least so much; sure
    tells what such take, given the numbers of their states (k,), and is asked only where that may matter."""

    T: Array
    doubt: BoolArray
    sure: Callable[[IndexArray, IndexArray], Array]

    def into(self, cost: Array) -> tuple[IndexArray, Array]:
        """As of Dense."""
        self._settle(cost[:, None])
        total = cost[:, None] + self.T
        source = np.argmin(total, axis=0)
        return source, total[source, np.arange(total.shape[1])]

    def out(self, cost: Array) -> Array:
        """As of Dense."""
        self._settle(cost[None])
        return np.asarray(np.min(self.T + cost[None], axis=1))

    def at(self, i: int, j: int) -> float:
        """As of Dense."""
        self._ask(np.array([i]), np.array([j]))
        return float(self.T[i, j])

    def dense(self) -> Array:
        """As of Dense."""
        self._ask(*np.nonzero(self.doubt))
        return self.T

    def _settle(self, cost: Array) -> None:
        """Nothing in doubt that could be the least of its row or column, cost (n_a, 1) or (1, n_b) being added."""
        axis = 0 if cost.shape[1] == 1 else 1
        total = cost + self.T
        for _ in range(3):
            first = np.argmin(total, axis=axis)
            states = (first, np.arange(len(first)))[:: 1 if axis == 0 else -1]
            states = tuple(x[self.doubt[states]] for x in states)
            if not len(states[0]):
                return
            self._ask(*states)
            total[states] = np.broadcast_to(cost, total.shape)[states] + self.T[states]
        known = np.min(np.where(self.doubt, np.inf, total), axis=axis, keepdims=True)
        self._ask(*np.nonzero(self.doubt & (total < known)))

    def _ask(self, a: IndexArray, b: IndexArray) -> None:
        doubtful = self.doubt[a, b]
        a, b = a[doubtful], b[doubtful]
        if len(a):
            self.T[a, b], self.doubt[a, b] = self.sure(a, b), False


@dataclass(frozen=True, eq=False)
class Band:
    """Times between states of one label whose rail positions are a few steps apart. A state is a pair of label and
    rail number, in a and b (2, n_a), (2, n_b).

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

    def out(self, cost: Array) -> Array:
        """As of Dense."""
        left = self._on_grid(self.b, cost)
        least = np.full(left.shape, np.inf)
        for before, behind, T in self._parts:
            least[:, before] = np.minimum(least[:, before], T + left[:, behind])
        return np.asarray(least[self.a[0], self.a[1]])

    def at(self, i: int, j: int) -> float:
        """As of Dense."""
        (label, rail), (label_b, rail_b) = self.a[:, i], self.b[:, j]
        shift = np.flatnonzero(self.shifts == rail_b - rail)
        return float(self.times[shift[0], label, rail]) if len(shift) and label == label_b else np.inf

    def dense(self) -> Array:
        """As of Dense."""
        labels, n = self.times.shape[1:]
        best = np.full((labels, n, n), np.inf)
        for before, behind, T in self._parts:
            best[:, np.arange(n)[before], np.arange(n)[behind]] = T
        T = best[self.a[0][:, None], self.a[1][:, None], self.b[1][None]]
        return np.where(self.a[0][:, None] == self.b[0][None], T, np.inf)


Edge = Dense | Lazy | Band
