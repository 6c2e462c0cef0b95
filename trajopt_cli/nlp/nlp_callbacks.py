"""The functions of a nonlinear program made of copies of blocks, evaluated at a point as a solver asks for them.

All copies of a kind are evaluated in one call. They stand side by side in the lanes of arrays (groups, length, lanes).
Where a number of the point goes and where a result belongs is looked up in index arrays made once.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.nlp.block import Block, Copies


class Evaluation:
    """min cost . x + weights / 2 . x^2 with copies of blocks, at any x, parameters and multipliers.

    kinds: each block with its copies' variables (n, n_z). Rows follow each other kind by kind, copy by copy.
    """

    def __init__(self, kinds: Sequence[tuple[Block, IndexArray]], cost: Array, weights: Array):
        self._cost, self._weights = cost, weights
        self._copies = [Copies(len(Z), block.g.lanes) for block, Z in kinds]
        at_x, at_row, lengths = [], [], []
        g_from, j_from, h_from = [], [], []
        j_row, j_col, h_row, h_col = [], [], [], []
        row = 0
        ends = np.zeros(3, dtype=np.intp)  # of what is written down already: g, Jacobian, Hessian
        for (block, Z), copies in zip(kinds, self._copies, strict=True):
            n, (n_z, n_p, m) = len(Z), block.sizes
            rows = row + np.arange(n * m).reshape(n, m)
            row += n * m
            at_x.append(copies.packed(Z))
            at_row.append(copies.packed(rows))
            (jr, jc), (hr, hc) = block.shape.jacobian_at, block.shape.hessian_at
            g_from.append(ends[0] + copies.places(m).ravel())
            j_from.append(ends[1] + copies.places(len(jr)).ravel())
            h_from.append(ends[2] + copies.places(len(hr)).ravel())
            j_row.append(rows[:, jr].ravel())
            j_col.append(Z[:, jc].ravel())
            h_row.append(np.minimum(Z[:, hr], Z[:, hc]).ravel())
            h_col.append(np.maximum(Z[:, hr], Z[:, hc]).ravel())
            filled = copies.groups * copies.lanes
            lengths.append([filled * k for k in (n_z, n_p, m, len(jr), len(hr))])
            ends += lengths[-1][2:]
        self._x_index, self._row_index, self._g_from = (np.concatenate(one) for one in (at_x, at_row, g_from))
        totals = np.sum(lengths, axis=0)
        self._z, self._p, self._g, self._j, self._h = (np.empty(k) for k in totals)
        self._lam = np.empty(totals[2])
        self._bind(kinds, np.array(lengths))
        self._j_from, self._h_from = np.concatenate(j_from), np.concatenate(h_from)
        self.jacobian_at = np.concatenate(j_row), np.concatenate(j_col)
        diagonal = np.flatnonzero(weights)
        self._curved = weights[diagonal]
        self.hessian_at = np.concatenate([*h_row, diagonal]), np.concatenate([*h_col, diagonal])

    def _bind(self, kinds: Sequence[tuple[Block, IndexArray]], lengths: IndexArray) -> None:
        ends = np.cumsum(lengths, axis=0)
        self._calls: list[list[Callable[[], object]]] = [[], [], []]
        for i, ((block, _), copies) in enumerate(zip(kinds, self._copies, strict=True)):
            z, p, g, j, h = (
                x[end - length : end]
                for x, end, length in zip(
                    (self._z, self._p, self._g, self._j, self._h), ends[i], lengths[i], strict=True
                )
            )
            lam = self._lam[ends[i, 2] - lengths[i, 2] : ends[i, 2]]
            for calls, kernel, out in zip(
                self._calls, (block.g, block.jacobian, block.hessian), (g, j, h), strict=True
            ):
                if len(out):
                    calls.append(kernel.bound(copies.groups, z, p, lam, out))

    def put(self, parameters: Sequence[Array]) -> None:
        """The copies' parameters (n, n_p) of each kind, in force from now on."""
        packed = [copies.packed(P) for copies, P in zip(self._copies, parameters, strict=True)]
        self._p[:] = np.concatenate([*packed, np.zeros(0)])

    def cost(self, x: Array) -> float:
        """f."""
        return float(self._cost @ x + self._weights @ x**2 / 2)

    def gradient(self, x: Array) -> Array:
        """df/dx."""
        return np.asarray(self._cost + self._weights * x)

    def constraints(self, x: Array) -> Array:
        """g."""
        return self._called(0, x)[self._g_from]

    def jacobian(self, x: Array) -> Array:
        """What stands at jacobian_at in dg/dx."""
        return self._called(1, x)[self._j_from]

    def hessian(self, x: Array, lam: Array) -> Array:
        """What adds up at hessian_at to the upper triangle of the second derivative of f + lam . g."""
        np.take(lam, self._row_index, out=self._lam, mode="clip")
        return np.concatenate([self._called(2, x)[self._h_from], self._curved])

    def _called(self, which: int, x: Array) -> Array:
        np.take(x, self._x_index, out=self._z, mode="clip")
        for call in self._calls[which]:
            call()
        return (self._g, self._j, self._h)[which]
