"""The functions of a nonlinear program made of copies of blocks, evaluated at a point, as IPOPT asks for them.

All copies of a kind are evaluated in one call. They stand side by side in the lanes of arrays (groups, length, lanes).
Where a number of the point goes and where a result belongs is looked up in index arrays made once.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

import casadi as ca
import numpy as np

from trajopt_cli.geometry import Array, IndexArray

if TYPE_CHECKING:
    from trajopt_cli.optimize.blocks import Block

Numbers = TypeVar("Numbers", Array, IndexArray)


class Kernel(Protocol):
    """One function of variables z, parameters p and multipliers lam at many copies, lanes of them side by side."""

    @property
    def lanes(self) -> int:
        """Copies in a group."""

    def bound(self, groups: int, z: Array, p: Array, lam: Array, out: Array) -> Callable[[], object]:
        """The call that evaluates groups of copies from these arrays, each (groups, length, lanes), into out."""


class MapKernel:
    """A CasADi function evaluated by CasADi: slower than native code, and always there."""

    lanes = 1

    def __init__(self, function: ca.Function):
        self.function = function

    def bound(self, groups: int, z: Array, p: Array, lam: Array, out: Array) -> Callable[[], object]:
        """See Kernel."""
        buffer: Any
        buffer, call = self.function.map(groups).buffer()
        for i, x in enumerate((z, p, lam)[: self.function.n_in()]):
            if x.size:
                buffer.set_arg(i, x.reshape(-1).data)
        buffer.set_res(0, out.reshape(-1).data)

        def evaluate(_: tuple[object, ...] = (buffer, z, p, lam, out)) -> None:
            call()

        return evaluate


class Copies:
    """How n copies stand in groups of lanes."""

    def __init__(self, n: int, lanes: int):
        self.n, self.lanes, self.groups = n, lanes, -(-n // lanes)
        self._filled = np.minimum(np.arange(self.groups * lanes), n - 1)  # the last copy again where none is left

    def packed(self, x: Numbers) -> Numbers:
        """Rows (n, k) of the copies as (groups * k * lanes,)."""
        k = x.shape[1]
        return x[self._filled].reshape(self.groups, self.lanes, k).transpose(0, 2, 1).ravel()

    def places(self, k: int) -> IndexArray:
        """Where k numbers of each copy are in an array packed like that: (n, k)."""
        copy = np.arange(self.n)
        first = copy // self.lanes * (k * self.lanes) + copy % self.lanes
        return first[:, None] + self.lanes * np.arange(k)


class Evaluation:
    """min cost . x + weights / 2 . x^2 with copies of blocks, at any x, parameters and multipliers.

    kinds: each block with its copies' variables (n, n_z). Rows follow each other kind by kind, copy by copy.
    """

    def __init__(self, kinds: Sequence[tuple[Block, IndexArray]], cost: Array, weights: Array):
        self.cost, self.weights = cost, weights
        n_x, n_g = len(cost), sum(len(Z) * block.sizes[2] for block, Z in kinds)
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
        order, self._jacobian = _pattern(np.concatenate(j_row), np.concatenate(j_col), n_g, n_x)
        self._j_from = np.concatenate(j_from)[order]
        diagonal = np.flatnonzero(weights)
        rows, cols = (np.concatenate([*one, diagonal]) for one in (h_row, h_col))
        unique, bins = np.unique(cols * n_x + rows, return_inverse=True)
        _, self._hessian = _pattern(unique % n_x, unique // n_x, n_x, n_x)
        self._h_bins = np.full(len(self._h), len(unique))  # what a lane without a copy gives goes nowhere
        self._h_bins[np.concatenate(h_from)] = bins[: len(bins) - len(diagonal)]
        self._on_diagonal, self._curved = bins[len(bins) - len(diagonal) :], weights[diagonal]

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

    def parameters(self, of_kinds: Sequence[Array]) -> Array:
        """The copies' parameters (n, n_p) of each kind as the one vector that is asked for with x."""
        packed = [copies.packed(P) for copies, P in zip(self._copies, of_kinds, strict=True)]
        return np.concatenate([*packed, np.zeros(0)])

    def _at(self, x: Array, p: Array) -> None:
        np.take(x, self._x_index, out=self._z, mode="clip")
        self._p[:] = p

    def constraints(self, x: Array, p: Array, out: Array) -> None:
        """g at x."""
        self._at(x, p)
        for call in self._calls[0]:
            call()
        np.take(self._g, self._g_from, out=out, mode="clip")

    def jacobian(self, x: Array, p: Array, out: Array) -> None:
        """The nonzeros of dg/dx column by column."""
        self._at(x, p)
        for call in self._calls[1]:
            call()
        np.take(self._j, self._j_from, out=out, mode="clip")

    def hessian(self, x: Array, p: Array, scale: float, lam: Array, out: Array) -> None:
        """The nonzeros of the upper triangle of the second derivative of scale * f + lam . g, column by column."""
        self._at(x, p)
        np.take(lam, self._row_index, out=self._lam, mode="clip")
        for call in self._calls[2]:
            call()
        out[:] = np.bincount(self._h_bins, weights=self._h, minlength=len(out) + 1)[:-1]
        out[self._on_diagonal] += scale * self._curved

    def functions(self) -> dict[str, ca.Function]:
        """grad_f, jac_g and hess_lag as ca.nlpsol takes them."""
        x, p = ("x", ca.Sparsity.dense(len(self.cost))), ("p", ca.Sparsity.dense(len(self._p)))
        g = ca.Sparsity.dense(self._jacobian.size1())
        one = ca.Sparsity.dense(1)

        def gradient(x: Array, _: Array, f: Array | None, out: Array | None) -> None:
            if f is not None:
                f[0] = self.cost @ x + self.weights @ x**2 / 2
            if out is not None:
                out[:] = self.cost + self.weights * x

        def rows(x: Array, p: Array, g: Array | None, jacobian: Array | None) -> None:
            if g is not None:
                self.constraints(x, p, g)
            if jacobian is not None:
                self.jacobian(x, p, jacobian)

        def hessian(x: Array, p: Array, scale: Array, lam: Array, out: Array | None) -> None:
            if out is not None:
                self.hessian(x, p, scale[0], lam, out)

        return {
            "grad_f": _Callback("nlp_grad_f", [x, p], [("f", one), ("grad_f_x", x[1])], gradient),
            "jac_g": _Callback("nlp_jac_g", [x, p], [("g", g), ("jac_g_x", self._jacobian)], rows),
            "hess_lag": _Callback(
                "nlp_hess_l", [x, p, ("lam_f", one), ("lam_g", g)], [("triu_hess_gamma_x_x", self._hessian)], hessian
            ),
        }


def _pattern(rows: IndexArray, cols: IndexArray, n_rows: int, n_cols: int) -> tuple[IndexArray, ca.Sparsity]:
    """The order that sorts places by columns, and the pattern (n_rows, n_cols) they make. No place comes twice."""
    order = np.argsort(cols * n_rows + rows)
    begins = np.concatenate([[0], np.cumsum(np.bincount(cols, minlength=n_cols))])
    return order, ca.Sparsity(n_rows, n_cols, begins.tolist(), rows[order].tolist())


Named = tuple[str, ca.Sparsity]


class _Callback(ca.Callback):
    """A function of Python's among CasADi's, without copies: inputs and outputs are arrays of nonzeros, an output that
    nobody asks for is None. The methods are CasADi's questions."""

    def __init__(self, name: str, inputs: Sequence[Named], outputs: Sequence[Named], evaluate: Callable[..., None]):
        ca.Callback.__init__(self)
        self._inputs, self._outputs, self._evaluate = inputs, outputs, evaluate
        self.construct(name, {})

    def get_n_in(self) -> int:
        return len(self._inputs)

    def get_n_out(self) -> int:
        return len(self._outputs)

    def get_name_in(self, i: int) -> str:
        return self._inputs[i][0]

    def get_name_out(self, i: int) -> str:
        return self._outputs[i][0]

    def get_sparsity_in(self, i: int) -> ca.Sparsity:
        return self._inputs[i][1]

    def get_sparsity_out(self, i: int) -> ca.Sparsity:
        return self._outputs[i][1]

    def has_eval_buffer(self) -> bool:
        return True

    def eval_buffer(self, arg: Sequence[Any], res: Sequence[Any]) -> int:
        inputs = [
            np.zeros(of.nnz()) if one is None else np.frombuffer(one)  # None is CasADi's word for zeros
            for one, (_, of) in zip(arg, self._inputs, strict=True)
        ]
        self._evaluate(*inputs, *(None if one is None else np.frombuffer(one) for one in res))
        return 0
