"""A nonlinear program put together from many copies of a few small blocks, with exact sparse derivatives.

CasADi differentiates each block once; the copies are evaluated by a map and their nonzeros are gathered into the
Jacobian and the Hessian of the Lagrangian. Construction stays a fraction of the solve however long the program is.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.optimize.tuning import IPOPT, WARM_PUSH


@dataclass(frozen=True, eq=False)
class Block:
    """One kind of constraint: lower <= g(z, p) <= upper, with its derivatives' nonzeros as functions."""

    name: str
    lower: Array
    upper: Array
    g: ca.Function
    jacobian: ca.Function
    jacobian_pattern: ca.Sparsity
    hessian: ca.Function
    hessian_pattern: ca.Sparsity

    @property
    def sizes(self) -> tuple[int, int, int]:
        """Numbers of variables, parameters and rows."""
        return self.g.size1_in(0), self.g.size1_in(1), self.g.size1_out(0)


def make_block(
    name: str,
    n_variables: int,
    n_parameters: int,
    rows: Callable[[ca.SX, ca.SX], Sequence[tuple[ca.SX, float, float]]],
) -> Block:
    """Build a block from rows(z, p) -> [(expression, lower, upper), ...]; vector expressions share their bounds."""
    z, p = ca.SX.sym("z", n_variables), ca.SX.sym("p", n_parameters)
    entries = [(ca.vec(ca.densify(e)), low, high) for e, low, high in rows(z, p)]
    g = ca.vertcat(*(e for e, _, _ in entries))
    lower = np.concatenate([np.full(e.numel(), low) for e, low, _ in entries])
    upper = np.concatenate([np.full(e.numel(), high) for e, _, high in entries])
    jac = ca.jacobian(g, z)
    lam = ca.SX.sym("lam", g.numel())
    hess = ca.triu(ca.hessian(ca.dot(lam, g), z)[0])
    return Block(
        name,
        lower,
        upper,
        ca.Function(f"{name}_g", [z, p], [g], {"cse": True}),
        ca.Function(f"{name}_j", [z, p], [ca.densify(jac.nz[:])], {"cse": True}),
        jac.sparsity(),
        ca.Function(f"{name}_h", [z, p, lam], [ca.densify(hess.nz[:])], {"cse": True}),
        hess.sparsity(),
    )


@dataclass
class _Copies:
    block: Block
    z: list[IndexArray] = field(default_factory=list)
    p: list[Array] = field(default_factory=list)


@dataclass(frozen=True, eq=False)
class NlpResult:
    """x at the end, the multipliers, the solver's own word and whether it converged."""

    x: Array
    lam_g: Array
    lam_x: Array
    converged: bool
    status: str
    iterations: int


class BlockNlp:
    """Collects variables and block copies, then solves min cost . x by IPOPT."""

    def __init__(self) -> None:
        self._lower: list[Array] = []
        self._upper: list[Array] = []
        self._guess: list[Array] = []
        self._count = 0
        self._cost: list[tuple[int, float]] = []
        self._damped: list[tuple[IndexArray, float]] = []
        self._copies: dict[str, _Copies] = {}

    def variables(self, guess: ArrayLike, lower: ArrayLike, upper: ArrayLike) -> IndexArray:
        """Add len(guess) variables; returns their indices."""
        guess = np.atleast_1d(np.asarray(guess, dtype=float)).ravel()
        n = len(guess)
        self._guess.append(guess)
        self._lower.append(np.broadcast_to(np.asarray(lower, dtype=float), (n,)).copy())
        self._upper.append(np.broadcast_to(np.asarray(upper, dtype=float), (n,)).copy())
        out = np.arange(self._count, self._count + n)
        self._count += n
        return out

    def minimise(self, index: int, weight: float = 1.0) -> None:
        """Add weight * x[index] to the cost."""
        self._cost.append((index, weight))

    def damp(self, indices: IndexArray, weight: float) -> None:
        """Add weight / 2 * x^2 to the cost: a hair of curvature where the cycle time does not care."""
        self._damped.append((indices, weight))

    def add(self, block: Block, z: Sequence[int] | IndexArray, p: Sequence[float] | Array = ()) -> None:
        """Add one copy on variables z with parameters p."""
        copies = self._copies.setdefault(block.name, _Copies(block))
        z, p = np.asarray(z, dtype=int), np.asarray(p, dtype=float)
        n_z, n_p, _ = block.sizes
        if z.shape != (n_z,) or p.shape != (n_p,):
            raise ValueError(f"block {block.name}: z {z.shape}, p {p.shape}; wanted ({n_z},), ({n_p},)")
        if len(np.unique(z)) != n_z:
            raise ValueError(f"block {block.name}: a variable stands twice in z = {z.tolist()}")
        copies.z.append(z)
        copies.p.append(p)

    def build(self) -> None:
        """Assemble the functions and the solver."""
        x, f_lam = ca.MX.sym("x", self._count), ca.MX.sym("lam_f")
        cost = np.zeros(self._count)
        for index, weight in self._cost:
            cost[index] += weight
        total_p = sum(c.block.sizes[1] * len(c.z) for c in self._copies.values())
        total_g = sum(c.block.sizes[2] * len(c.z) for c in self._copies.values())
        p, lam = ca.MX.sym("p", total_p), ca.MX.sym("lam_g", total_g)
        gs, js, hs = [], [], []
        j_rows, j_cols, h_rows, h_cols = [], [], [], []
        at_p = at_g = 0
        for copies in self._copies.values():
            block, n = copies.block, len(copies.z)
            n_z, n_p, n_g = block.sizes
            Zi = np.array(copies.z)  # (n, n_z)
            Z = ca.reshape(x[Zi.ravel().tolist()], n_z, n)
            P = ca.reshape(p[at_p : at_p + n_p * n], n_p, n)
            L = ca.reshape(lam[at_g : at_g + n_g * n], n_g, n)
            gs.append(ca.vec(block.g.map(n)(Z, P)))
            rows, cols = (np.array(a, dtype=int) for a in block.jacobian_pattern.get_triplet())
            js.append(ca.vec(block.jacobian.map(n)(Z, P)))
            j_rows.append((at_g + n_g * np.arange(n)[:, None] + rows).ravel())
            j_cols.append(Zi[:, cols].ravel())
            rows, cols = (np.array(a, dtype=int) for a in block.hessian_pattern.get_triplet())
            if len(rows):
                hs.append(ca.vec(block.hessian.map(n)(Z, P, L)))
                a, b = Zi[:, rows].ravel(), Zi[:, cols].ravel()
                h_rows.append(np.minimum(a, b))
                h_cols.append(np.maximum(a, b))
            at_p += n_p * n
            at_g += n_g * n
        g = ca.vertcat(*gs)
        jac = _scatter(ca.vertcat(*js), np.concatenate(j_rows), np.concatenate(j_cols), total_g, self._count)
        hess = ca.MX(self._count, self._count)
        if hs:
            hess = _scatter(ca.vertcat(*hs), np.concatenate(h_rows), np.concatenate(h_cols), self._count, self._count)
        weights = np.zeros(self._count)
        for indices, weight in self._damped:
            weights[indices] += weight
        f = ca.dot(ca.DM(cost), x) + ca.dot(ca.DM(weights), x**2) / 2
        gradient = ca.DM(cost) + ca.DM(weights) * x
        hess = hess + f_lam * ca.diag(ca.sparsify(ca.DM(weights)))
        functions = {
            "grad_f": ca.Function("nlp_grad_f", [x, p], [f, gradient], ["x", "p"], ["f", "grad_f_x"]),
            "jac_g": ca.Function("nlp_jac_g", [x, p], [g, jac], ["x", "p"], ["g", "jac_g_x"]),
            "hess_lag": ca.Function(
                "nlp_hess_l", [x, p, f_lam, lam], [hess], ["x", "p", "lam_f", "lam_g"], ["triu_hess_gamma_x_x"]
            ),
        }
        self._functions = functions
        self._problem = {"x": x, "p": p, "f": f, "g": g}
        self._g_lower = np.concatenate([np.tile(c.block.lower, len(c.z)) for c in self._copies.values()])
        self._g_upper = np.concatenate([np.tile(c.block.upper, len(c.z)) for c in self._copies.values()])

    @property
    def guess(self) -> Array:
        """The variables' guesses."""
        return np.concatenate(self._guess)

    @property
    def empty(self) -> bool:
        """True when nothing constrains anything: there is no question to solve."""
        return not self._copies

    def adopt(self, other: BlockNlp) -> None:
        """Take over the built functions of a program with the same blocks on the same variables."""
        mine, theirs = self._copies, other._copies
        if list(mine) != list(theirs) or any(
            not np.array_equal(mine[k].z, theirs[k].z) or mine[k].block is not theirs[k].block for k in mine
        ):
            raise ValueError("adopt: the two programs differ in structure")
        self._functions, self._problem = other._functions, other._problem
        self._g_lower, self._g_upper = other._g_lower, other._g_upper

    def solve(
        self, guess: NlpResult | None = None, *, mu: float = 1e-1, tolerance: float = 1e-8, most: int = 200
    ) -> NlpResult:
        """Solve from the variables' guesses, or warm from an earlier result of the same program."""
        if not hasattr(self, "_functions"):
            self.build()
        options: dict[str, Any] = {
            "print_time": False,
            "ipopt.print_level": 0,
            "ipopt.sb": "yes",
            "ipopt.tol": tolerance,
            "ipopt.max_iter": most,
            "ipopt.mu_init": mu,
            **IPOPT,
            **self._functions,
        }
        if guess is not None:
            options |= {
                "ipopt.warm_start_init_point": "yes",
                "ipopt.warm_start_bound_push": WARM_PUSH,
                "ipopt.warm_start_slack_bound_push": WARM_PUSH,
                "ipopt.warm_start_mult_bound_push": WARM_PUSH,
                "ipopt.warm_start_bound_frac": WARM_PUSH,
                "ipopt.warm_start_slack_bound_frac": WARM_PUSH,
            }
        solver = ca.nlpsol("solver", "ipopt", self._problem, options)
        arguments = {
            "x0": guess.x if guess else self.guess,
            "p": np.concatenate([np.concatenate(c.p) for c in self._copies.values()]),
            "lbx": np.concatenate(self._lower),
            "ubx": np.concatenate(self._upper),
            "lbg": self._g_lower,
            "ubg": self._g_upper,
        }
        if guess is not None:
            arguments |= {"lam_g0": guess.lam_g, "lam_x0": guess.lam_x}
        out = solver(**arguments)
        stats = solver.stats()
        return NlpResult(
            np.asarray(out["x"]).ravel(),
            np.asarray(out["lam_g"]).ravel(),
            np.asarray(out["lam_x"]).ravel(),
            bool(stats["success"]),
            str(stats["return_status"]),
            int(stats["iter_count"]),
        )


def _scatter(values: ca.MX, rows: Array, cols: Array, n_rows: int, n_cols: int) -> ca.MX:
    """The sparse matrix (n_rows, n_cols) with values summed at (rows, cols)."""
    key = cols.astype(np.int64) * n_rows + rows
    unique, inverse = np.unique(key, return_inverse=True)
    pattern = ca.Sparsity.triplet(n_rows, n_cols, (unique % n_rows).tolist(), (unique // n_rows).tolist())
    if len(unique) == len(key):
        order = np.argsort(key, kind="stable")
        return ca.MX(pattern, values[order.tolist()])
    gather = ca.DM(ca.Sparsity.triplet(len(unique), len(key), inverse.tolist(), list(range(len(key)))), 1.0)
    return ca.MX(pattern, ca.mtimes(gather, values))
