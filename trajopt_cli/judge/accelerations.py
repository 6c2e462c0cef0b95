"""What accelerations the axes may have: constants, or a table by posture, which the judge reads by itself."""

from __future__ import annotations

from functools import cached_property
from itertools import product

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.limits import JointLimits
from trajopt_cli.units import DEG

NEGATIVE, POSITIVE = 0, 1


class Accelerations:
    """Of all k axes. most (k,): the greatest that any posture allows, so what may have been between rows."""

    def __init__(self, limits: JointLimits):
        self._constant, self._names = limits.acceleration, limits.names
        self.by_posture, self.most = limits.table is not None, limits.acceleration
        if limits.table is None:
            return
        self._given, self._axes = limits.table, limits.table.axes
        values = self._table[1]
        self.most, self._times = self._constant.copy(), dict[str, float]()
        for axis in self._axes:
            j = self._names.index(axis)
            sides = [values[axis, sign] for sign in (NEGATIVE, POSITIVE)]
            own = self._given.file is not None  # then a cell may ask for more or less of what is read
            self._times[axis] = self._given.times.get(axis, 1.0) if own else 1.0
            self.most[j] = np.max(sides) * self._times[axis]

    @cached_property
    def _table(self) -> tuple[dict[str, Array], dict[tuple[str, int], Array]]:
        """The places of the grid by axis of the posture, and its values by limited axis and sign."""
        table, file = self._given, self._given.file
        if file is None:  # nothing to read
            sides = enumerate((table.lower, table.upper))
            found = {(axis, sign): side[..., j] for sign, side in sides for j, axis in enumerate(table.axes)}
            return dict(zip(table.over, table.places, strict=True)), found
        head, *lines = [line for line in file.read_text(encoding="utf-8").split("\n") if line.strip()]
        titles = [title.strip().replace("]", "").split(" ") for title in head.split(",")]
        rows = np.array([[float(x) for x in line.split(",")] for line in lines])
        rows = rows * [DEG if words[-1].startswith("[deg") else 1.0 for words in titles]
        over = [k for k, words in enumerate(titles) if not words[-1].endswith("/s2")]
        order = np.lexsort([rows[:, k] for k in reversed(over)])
        places = {titles[k][0]: np.unique(rows[:, k]) for k in over}
        shape = [len(one) for one in places.values()]
        values = {}
        for k, (axis, *words) in enumerate(titles):
            if k not in over:
                signs = [NEGATIVE] if "negative" in words else [POSITIVE] if "positive" in words else [0, 1]
                values.update({(axis, sign): rows[order, k].reshape(shape) for sign in signs})
        return places, values

    def at(self, q: Array) -> Array:
        """What each axis may have (2, m, k) of negative and of positive acceleration at axes q (m, k)."""
        out = np.broadcast_to(self._constant, (2, *q.shape)).copy()
        if not self.by_posture:
            return out
        places, values = self._table
        corners = []
        for axis, edges in places.items():
            x = np.clip(q[:, self._names.index(axis)], edges[0], edges[-1])
            i = np.clip(np.searchsorted(edges, x, side="right") - 1, 0, len(edges) - 2)
            share = (x - edges[i]) / (edges[i + 1] - edges[i])
            corners.append(((i, 1 - share), (i + 1, share)))
        for axis in self._axes:
            for sign in (NEGATIVE, POSITIVE):
                total = np.zeros(len(q))
                for corner in product(*corners):
                    weight = np.prod([share for _, share in corner], axis=0)
                    total += weight * values[axis, sign][tuple(i for i, _ in corner)]
                out[sign, :, self._names.index(axis)] = total * self._times[axis]
        return out

    def along(self, q: Array) -> Array:
        """The most that is allowed (2, m - 1, k) from each of axes q (m, k) to the next: there and half way."""
        at, half = self.at(q), self.at((q[1:] + q[:-1]) / 2)
        return np.asarray(np.maximum(np.maximum(at[:, :-1], at[:, 1:]), half))

    def shares(self, allowed: Array, values: Array, m: int = 1) -> Array | float:
        """By what accelerations (n, k) of either sign, each seen over m parts that allow so much (2, n + m - 1, k),
        grow to be held against `most` instead."""
        if not self.by_posture:
            return 1.0
        wide = allowed[:, : len(values)].copy()
        for step in range(1, m):
            np.maximum(wide, allowed[:, step : step + len(values)], out=wide)
        return np.asarray(self.most / np.where(values > 0, wide[POSITIVE], wide[NEGATIVE]))
