"""Blocks: one kind of constraint that holds at many places, with the functions that evaluate all its copies at once.

CasADi writes and differentiates each block once. Copies stand side by side in the lanes of arrays (groups, length,
lanes).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Protocol, TypeVar

import casadi as ca
import numpy as np

from trajopt_cli.geometry import Array, IndexArray

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


@dataclass(frozen=True, eq=False)
class Shape:
    """What a block asks for, without its functions: numbers of variables and parameters, bounds (m,), and rows and
    columns of the nonzeros of its Jacobian and of the upper triangle of its Hessian."""

    n_variables: int
    n_parameters: int
    lower: Array
    upper: Array
    jacobian_at: tuple[IndexArray, IndexArray]
    hessian_at: tuple[IndexArray, IndexArray]


@dataclass(frozen=True, eq=False)
class Block:
    """One kind of constraint: lower <= g(z, p) <= upper, with its derivatives' nonzeros as functions."""

    name: str
    shape: Shape
    g: Kernel
    jacobian: Kernel
    hessian: Kernel

    @property
    def sizes(self) -> tuple[int, int, int]:
        """Numbers of variables, parameters and rows."""
        return self.shape.n_variables, self.shape.n_parameters, len(self.shape.lower)

    def values(self, z: Array, p: Array) -> tuple[Array, Array]:
        """g (n, m) and the Jacobian's nonzeros of n copies at variables (n, n_z) and parameters (n, n_p)."""
        m, nonzeros = len(self.shape.lower), len(self.shape.jacobian_at[0])
        return _called(self.g, m, z, p), _called(self.jacobian, nonzeros, z, p)

    def curvature(self, z: Array, p: Array, lam: Array) -> Array:
        """The Hessian's nonzeros of n copies at variables, parameters and multipliers (n, m)."""
        return _called(self.hessian, len(self.shape.hessian_at[0]), z, p, lam)


def _called(kernel: Kernel, k: int, z: Array, p: Array, lam: Array | None = None) -> Array:
    copies = Copies(len(z), kernel.lanes)
    none = np.zeros((len(z), 0))
    packed_z, packed_p, packed_lam = (copies.packed(x) for x in (z, p, none if lam is None else lam))
    out = np.zeros(copies.groups * copies.lanes * k)
    kernel.bound(copies.groups, packed_z, packed_p, packed_lam, out)()
    return out[copies.places(k)]


@dataclass(frozen=True, eq=False)
class Expressed:
    """A block as CasADi expressions: by function, of what it is made and what it gives."""

    shape: Shape
    parts: dict[str, tuple[list[ca.SX], ca.SX]]

    def functions(self) -> dict[str, ca.Function]:
        """g, jacobian and hessian."""
        return {name: ca.Function(name, of, [gives]) for name, (of, gives) in self.parts.items()}

    def block(self, name: str) -> Block:
        """The block that CasADi evaluates."""
        return Block(name, self.shape, *map(MapKernel, self.functions().values()))


Rows = Callable[[ca.SX, ca.SX], Sequence[tuple[ca.SX, float, float]]]


def express(n_variables: int, n_parameters: int, rows: Rows) -> Expressed:
    """A block from rows(z, p) -> [(expression, lower, upper), ...]; vector expressions share their bounds."""
    z, p = ca.SX.sym("z", n_variables), ca.SX.sym("p", n_parameters)
    entries = [(ca.vec(ca.densify(e)), low, high) for e, low, high in rows(z, p)]
    g = ca.vertcat(*(e for e, _, _ in entries))
    lower = np.concatenate([np.full(e.numel(), low) for e, low, _ in entries])
    upper = np.concatenate([np.full(e.numel(), high) for e, _, high in entries])
    jac = ca.jacobian(g, z)
    lam = ca.SX.sym("lam", g.numel())
    hess = ca.triu(ca.hessian(ca.dot(lam, g), z)[0])
    shape = Shape(n_variables, n_parameters, lower, upper, _places(jac), _places(hess))
    parts = {
        "g": ([z, p], g),
        "jacobian": ([z, p], ca.densify(jac.nz[:])),
        "hessian": ([z, p, lam], ca.densify(hess.nz[:])),
    }
    return Expressed(shape, parts)


def _places(of: ca.SX) -> tuple[IndexArray, IndexArray]:
    rows, cols = of.sparsity().get_triplet()
    return np.array(rows, dtype=np.intp), np.array(cols, dtype=np.intp)
