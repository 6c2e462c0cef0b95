"""A nonlinear program put together from many copies of a few small blocks, with exact sparse derivatives.

CasADi writes and differentiates each block once. A block's functions are evaluated for all its copies in one call, and
their numbers gathered into the Jacobian and the Hessian of the Lagrangian. Construction stays a fraction of the solve
however long the program is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.nlp.block import Block
from trajopt_cli.nlp.interior_point import Bounds, InteriorPoint, NlpResult
from trajopt_cli.nlp.nlp_callbacks import Evaluation


@dataclass
class _Held:
    """Where a block holds: variables (n, n_z) and parameters (n, n_p) of n copies, added bit by bit."""

    z: list[IndexArray] = field(default_factory=list)
    p: list[Array] = field(default_factory=list)

    @property
    def all_z(self) -> IndexArray:
        return np.concatenate(self.z)

    @property
    def all_p(self) -> Array:
        return np.concatenate(self.p)


class BlockNlp:
    """Collects variables and block copies, then solves min cost . x."""

    def __init__(self) -> None:
        self._lower: list[Array] = []
        self._upper: list[Array] = []
        self._guess: list[Array] = []
        self._count = 0
        self._cost: list[tuple[int, float]] = []
        self._damped: list[tuple[IndexArray, float]] = []
        self._held: dict[Block, _Held] = {}

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
        """Add one copy on variables z (n_z,) with parameters p (n_p,), or n of them: z (n, n_z), p (n, n_p)."""
        Z, P = np.atleast_2d(np.asarray(z, dtype=np.intp)), np.atleast_2d(np.asarray(p, dtype=float))
        n_z, n_p, _ = block.sizes
        if Z.shape[1:] != (n_z,) or P.shape != (len(Z), n_p):
            raise ValueError(f"block {block.name}: z {Z.shape}, p {P.shape}; wanted (n, {n_z}), (n, {n_p})")
        ordered = np.sort(Z, axis=1)
        twice = np.flatnonzero(np.any(ordered[:, 1:] == ordered[:, :-1], axis=1))
        if len(twice):
            raise ValueError(f"block {block.name}: a variable stands twice in z = {Z[twice[0]].tolist()}")
        if len(Z):
            held = self._held.setdefault(block, _Held())
            held.z.append(Z)
            held.p.append(P)

    def build(self) -> None:
        """Assemble what evaluates it, and what solves it."""
        self._evaluation = Evaluation([(block, z) for block, z, _ in self.copies()], *self.cost())
        bounds = self.bounds()
        free, equations = bounds.lower < bounds.upper, bounds.g_lower == bounds.g_upper
        self._interior = InteriorPoint(self._evaluation.jacobian_at, self._evaluation.hessian_at, free, equations)

    def cost(self) -> tuple[Array, Array]:
        """cost and weights (n,) of cost . x + weights / 2 . x^2, which is kept small."""
        cost, weights = np.zeros(self._count), np.zeros(self._count)
        for index, weight in self._cost:
            cost[index] += weight
        for indices, weight in self._damped:
            weights[indices] += weight
        return cost, weights

    def copies(self) -> Iterator[tuple[Block, IndexArray, Array]]:
        """Each block, with the variables (n, n_z) and parameters (n, n_p) of its n copies."""
        for block, held in self._held.items():
            yield block, held.all_z, held.all_p

    @property
    def guess(self) -> Array:
        """The variables' guesses."""
        return np.concatenate(self._guess)

    @property
    def empty(self) -> bool:
        """True when nothing constrains anything, or nothing is left to choose: there is no question to solve."""
        return not self._held or not np.any(np.concatenate(self._lower) < np.concatenate(self._upper))

    def adopt(self, other: BlockNlp) -> None:
        """Take over the built functions of a program with the same blocks on the same variables."""
        mine, theirs = self._held, other._held
        if list(mine) != list(theirs) or any(not np.array_equal(mine[k].all_z, theirs[k].all_z) for k in mine):
            raise ValueError("adopt: the two programs differ in structure")
        self._evaluation, self._interior = other._evaluation, other._interior

    def bounds(self) -> Bounds:
        """Of variables, and of rows block by block and copy by copy."""
        held = self._held.items()
        return Bounds(
            np.concatenate(self._lower),
            np.concatenate(self._upper),
            np.concatenate([np.tile(block.shape.lower, len(one.all_z)) for block, one in held]),
            np.concatenate([np.tile(block.shape.upper, len(one.all_z)) for block, one in held]),
        )

    def solve(
        self, guess: NlpResult | None = None, *, mu: float = 1e-1, tolerance: float = 1e-8, most: int = 200,
        stop: Callable[[], bool] | None = None,
    ) -> NlpResult:  # fmt: skip
        """Solve from the variables' guesses, or warm from an earlier result of the same program. stop: asked in every
        iteration whether to end there, without convergence."""
        if not hasattr(self, "_evaluation"):
            self.build()
        self._evaluation.put([one.all_p for one in self._held.values()])
        start = self.guess if guess is None else guess
        return self._interior.solve(self._evaluation, self.bounds(), start, mu, tolerance, most, stop)

    def lagrangian_change(self, other: BlockNlp, answer: NlpResult) -> float:
        """By how much the least cost of another program with the same structure differs from this one's, to first
        order: by the multipliers of this one's answer. Raises ValueError where structures differ."""
        other.adopt(self)
        mine, theirs = self.bounds(), other.bounds()
        fixed = mine.lower == mine.upper
        if not np.array_equal(fixed, theirs.lower == theirs.upper):
            raise ValueError("first order: the two programs fix other variables")
        moved = np.where(fixed, theirs.lower, answer.x)
        now, then = self._value(answer.x, answer.lam_g), other._value(moved, answer.lam_g)
        with np.errstate(invalid="ignore"):  # bounds that are none
            up, down = (np.nan_to_num(x) for x in (theirs.upper - mine.upper, theirs.lower - mine.lower))
        pressed = np.maximum(-answer.lam_x, 0.0) * down - np.maximum(answer.lam_x, 0.0) * up
        return then - now + float(pressed[~fixed].sum())

    def _value(self, x: Array, lam_g: Array) -> float:
        """Cost and weighed rows at x."""
        self._evaluation.put([one.all_p for one in self._held.values()])
        return self._evaluation.cost(x) + float(lam_g @ self._evaluation.constraints(x))
