"""A primal-dual interior point for programs whose rows each touch a few neighbouring variables.

    min f(x)   s.t.   lower <= x <= upper,   g_lower <= g(x) <= g_upper

Every row that is no equation gets a slack within its bounds. Slacks and bounds are eliminated before anything is
factorised, so a row far from its limit costs a few products and nothing more: what is left is the symmetric system

    [ H + J_I' S J_I + D   J_E' ] [ dx ]
    [ J_E                  -eps ] [ dy ]

over variables and equations, whose pattern is that of the stages along the program. It is quasi-definite, or made so by
a multiple of the identity: the signs of D in its factors L D L' say when. A filter accepts steps; where none is
accepted, steps follow that only mend rows. Sources: Wächter and Biegler 2006 (barrier, filter, inertia), Vanderbei 1995
(quasi-definite systems), QDLDL (the factorization).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np
import qdldl

from trajopt_cli.geometry import Array, BoolArray, IndexArray

_EQUATION_EPS = 1e-09  # regularisation of equations that depend on each other.
_REFINEMENTS = 1  # of each solution of a linear system. Measured on 25 moves of a pallet: 2 take 449 iterations, 1 447.
_WARM_PUSH = 1e-07  # how far a warm start is pushed off its bounds.
_FIRST_PUSH = 0.01  # the same of a start without multipliers.
_FEASIBLE_ROUGH = 1e-07  # the same on a grid that is refined afterwards.
_FEASIBLE = 1e-10  # by which a row may be off in the end.
_ALMOST = 1e-06  # error of a point that is the answer where the steps behind it fail.
_ALMOST_FEASIBLE = 1e-08  # by which a row may be off there.
_BARRIER_ERROR = 10.0  # times the barrier parameter that may be off before it falls.
_BARRIER_FACTOR = 0.2  # times that it falls at least.
_BARRIER_POWER = 1.2  # or to this power of itself, whichever falls less.
_LEAST_TAU = 0.99  # share of the way to a bound that a step may go.
_BACKTRACKS = 30  # halvings of a step.
_MENDINGS = 20  # steps in a row that only mend rows, at most.
_MENDED = 0.3  # share of what rows were off that may be left of it then.
_FIRST_SHIFT = 0.0001  # first multiple of the identity where the program is not convex.
_MOST_SHIFT = 1e40  # largest.

Places = tuple[IndexArray, IndexArray]

_ARMIJO = 1e-8  # share of the predicted decrease that a step must bring
_WORST = 10.0  # times what rows are off at the start, or one, that they may be off later
_FILTER = 1e-5  # share by which a step must be better than what the filter holds
_ROUNDING = 1e-12  # of a merit's value


class NonlinearProgram(Protocol):
    """What is asked: values and derivatives at a point. Nonzeros of the Jacobian and of the Hessian's upper triangle
    come in the order of the places that the solver was made with."""

    def cost(self, x: Array) -> float:
        """f."""

    def gradient(self, x: Array) -> Array:
        """df/dx."""

    def constraints(self, x: Array) -> Array:
        """g."""

    def jacobian(self, x: Array) -> Array:
        """Nonzeros of dg/dx."""

    def hessian(self, x: Array, lam: Array) -> Array:
        """Nonzeros of the second derivative of f + lam . g."""


@dataclass(frozen=True, eq=False)
class Bounds:
    """Of variables and of rows; equal ones fix a variable and make a row an equation."""

    lower: Array
    upper: Array
    g_lower: Array
    g_upper: Array


@dataclass(frozen=True, eq=False)
class NlpResult:
    """x and the multipliers at the end: lam_g of rows, lam_x of variables, positive at upper bounds. off: by how much a
    row is passed or missed at most. status: why it ended."""

    x: Array
    lam_g: Array
    lam_x: Array
    off: float
    converged: bool
    status: str
    iterations: int


class _System:
    """The condensed system of one pattern, made anew from numbers and factorised."""

    def __init__(self, jacobian_at: Places, hessian_at: Places, free: BoolArray, equal: BoolArray):
        self.n, self.m = int(free.sum()), int(equal.sum())
        column = np.where(free, np.cumsum(free) - 1, -1)
        (rows, cols), (h_rows, h_cols) = jacobian_at, hessian_at
        entries = np.lexsort((cols, rows))
        entries = entries[column[cols[entries]] >= 0]
        rows, cols = rows[entries], column[cols[entries]]
        mine = equal[rows]
        equation, inequality = np.cumsum(equal) - 1, np.cumsum(~equal) - 1
        self._in_equations, self._in_rows = entries[mine], entries[~mine]
        size_rows = int((~equal).sum())
        self.J_E = _Pattern(equation[rows[mine]], cols[mine], (self.m, self.n))
        self.J_I = _Pattern(inequality[rows[~mine]], cols[~mine], (size_rows, self.n))
        self._squares = _Squares(inequality[rows[~mine]], cols[~mine])
        both = (column[h_rows] >= 0) & (column[h_cols] >= 0)
        self._in_hessian = np.flatnonzero(both)
        diagonal = np.arange(self.n + self.m)
        at = [
            (column[h_rows[both]], column[h_cols[both]]),
            self._squares.at,
            (cols[mine], self.n + equation[rows[mine]]),
            (diagonal, diagonal),
        ]
        low = np.concatenate([np.minimum(a, b) for a, b in at])
        high = np.concatenate([np.maximum(a, b) for a, b in at])
        total = self.n + self.m
        unique, bins, often = np.unique(high * total + low, return_inverse=True, return_counts=True)
        counts = np.bincount(unique // total, minlength=total)
        from scipy import sparse  # takes longer to load than a short program to search

        self._K = sparse.csc_matrix(
            (np.ones(len(unique)), unique % total, np.concatenate([[0], np.cumsum(counts)])), shape=(total, total)
        )
        self._K_T = self._K.T
        self._diagonal = bins[len(bins) - total :]
        ends, order = np.concatenate([[0], np.cumsum(often)]), np.argsort(bins, kind="stable")
        self._sums = sparse.csr_array((np.ones(len(order)), order, ends), shape=(len(unique), len(order)))
        self._solver: qdldl.Solver | None = None

    def take(self, jacobian: Array) -> None:
        """The Jacobian's nonzeros."""
        self.J_E.data, self.J_I.data = jacobian[self._in_equations], jacobian[self._in_rows]

    def fill(self, hessian: Array, weights: Array, diagonal: Array) -> None:
        """The Hessian's nonzeros, weights of the rows that are no equations, what else stands on the diagonal (n,)."""
        products = self._squares.of(self.J_I.data, weights)
        values = [hessian[self._in_hessian], products, self.J_E.data, diagonal, np.full(self.m, -_EQUATION_EPS)]
        self._filled = self._sums @ np.concatenate(values)

    def factorise(self, shift: float) -> bool:
        """With a multiple of the identity added for the variables; False where that is not convex enough."""
        values = self._filled.copy()
        values[self._diagonal[: self.n]] += shift
        self._K.data = self._K_T.data = values
        try:
            if self._solver is None:
                self._solver = qdldl.Solver(self._K, upper=True)
            else:
                self._solver.update(self._K, upper=True)
        except (RuntimeError, ValueError):  # a pivot that is zero
            return False
        D = self._solver.factors()[1]
        return bool(np.all(np.isfinite(D)) and int((D > 0).sum()) == self.n)

    def solve(self, of_x: Array, of_y: Array) -> tuple[Array, Array]:
        """dx and dy, the equations met exactly up to rounding."""
        assert self._solver is not None
        wanted = np.concatenate([of_x, of_y])
        found = self._solver.solve(wanted)
        for _ in range(_REFINEMENTS):
            rest = wanted - self._K @ found - self._K_T @ found + self._K.data[self._diagonal] * found
            rest[self.n :] -= _EQUATION_EPS * found[self.n :]
            found = found + self._solver.solve(rest)
        return found[: self.n], found[self.n :]


class _Pattern:
    """A sparse matrix of one pattern, its places row by row; data: its nonzeros."""

    def __init__(self, rows: IndexArray, cols: IndexArray, shape: tuple[int, int]):
        from scipy import sparse

        begins = np.searchsorted(rows, np.arange(shape[0] + 1))
        self._matrix = sparse.csr_array((np.zeros(len(rows)), cols, begins), shape=shape)
        self._transposed = self._matrix.T

    @property
    def data(self) -> Array:
        """Its nonzeros."""
        return np.asarray(self._matrix.data)

    @data.setter
    def data(self, data: Array) -> None:
        self._matrix.data = self._transposed.data = data

    def times(self, x: Array) -> Array:
        """Matrix times x."""
        return np.asarray(self._matrix @ x)

    def transposed_times(self, y: Array) -> Array:
        """Transpose times y."""
        return np.asarray(self._transposed @ y)


class _Squares:
    """J' W J of a sparse J (entries at rows, cols) and weights W of its rows. Rows that touch the same variables are
    one dense product: a node has many of them.

    at: rows and columns of what `of` returns, upper triangles of those products, to be added up.
    """

    def __init__(self, rows: IndexArray, cols: IndexArray):
        order = np.lexsort((cols, rows))
        begins = np.flatnonzero(np.diff(rows[order], prepend=-1))
        counts = np.diff(begins, append=len(rows))
        self._stacks: list[tuple[IndexArray, IndexArray, IndexArray]] = []
        at: list[tuple[IndexArray, IndexArray]] = [(cols[:0], cols[:0])]
        for k in np.unique(counts).tolist():
            entries = order[begins[counts == k][:, None] + np.arange(k)]
            columns, group, sizes = np.unique(cols[entries], axis=0, return_inverse=True, return_counts=True)
            entries = entries[np.argsort(group.ravel(), kind="stable")]
            ends = np.cumsum(sizes)
            i, j = np.triu_indices(k)
            for size in np.unique(sizes).tolist():
                these = sizes == size
                stack = entries[(ends[these] - size)[:, None] + np.arange(size)]
                self._stacks.append((stack, rows[stack[:, :, 0]], i * k + j))
                at.append((columns[these][:, i].ravel(), columns[these][:, j].ravel()))
        self.at = np.concatenate([a for a, _ in at]), np.concatenate([b for _, b in at])

    def of(self, entries: Array, weights: Array) -> Array:
        """The products' upper triangles."""
        out = [entries[:0]]
        for at, row, upper in self._stacks:
            J = entries[at]
            weighted = (J * weights[row][:, :, None]).transpose(0, 2, 1)
            out.append((weighted @ J).reshape(len(J), -1)[:, upper].ravel())
        return np.concatenate(out)


@dataclass(frozen=True, eq=False)
class _State:
    """A point with its multipliers: v = (x, slacks), y of equations, w of the other rows, below and above of v's bounds
    (zero where there is none). f, g: cost and rows there."""

    v: Array
    y: Array
    w: Array
    below: Array
    above: Array
    f: float
    g: Array


class InteriorPoint:
    """The solver of programs of one pattern: rows and columns of the nonzeros of the Jacobian and of the upper triangle
    of the Lagrangian's Hessian, which variables are free and which rows are equations."""

    def __init__(self, jacobian_at: Places, hessian_at: Places, free: BoolArray, equations: BoolArray):
        self._free, self._equations = free, equations
        self._system = _System(jacobian_at, hessian_at, free, equations)

    def solve(
        self, program: NonlinearProgram, bounds: Bounds, start: Array | NlpResult, mu: float, tolerance: float,
        most: int,        stop: Callable[[], bool] | None = None,
    ) -> NlpResult:  # fmt: skip
        """From a point, or warm from a result with its multipliers. mu: the first barrier parameter; most: iterations;
        stop: asked in each whether to end there, without convergence. Raises ValueError for bounds that fix other
        variables or make other equations."""
        same = np.array_equal(bounds.lower < bounds.upper, self._free)
        if not same or not np.array_equal(bounds.g_lower == bounds.g_upper, self._equations):
            raise ValueError("interior point: the bounds fix other variables or make other equations")
        with np.errstate(all="ignore"):  # points without a value are left where they are met
            one = _Solve(self._system, program, bounds, self._free, self._equations, mu, tolerance)
            return one.run(start, most, stop)


class _Solve:
    """One solve: the barrier problem's parameter and what belongs to it."""

    def __init__(
        self, system: _System, program: NonlinearProgram, bounds: Bounds, free: BoolArray, equal: BoolArray, mu: float,
        tolerance: float,
    ):  # fmt: skip
        self.system, self.program, self.free, self.equal = system, program, free, equal
        self.mu, self.tolerance = mu, tolerance
        self.n = system.n
        self.whole = bounds.lower.copy()  # all variables, the fixed ones with their values
        self.target = bounds.g_lower[equal]
        self.low = np.concatenate([bounds.lower[free], bounds.g_lower[~equal]])
        self.high = np.concatenate([bounds.upper[free], bounds.g_upper[~equal]])
        self.bounded_below, self.bounded_above = np.isfinite(self.low), np.isfinite(self.high)
        self.filter: list[tuple[float, float]] = []
        self.shift = 0.0

    # ------------------------------------------------------------------------------------------------- where it is

    def _x(self, v: Array) -> Array:
        self.whole[self.free] = v[: self.n]
        return self.whole

    def _inside(self, v: Array, push: float) -> Array:
        """v moved so far inside its bounds."""
        with np.errstate(invalid="ignore"):
            least = push * np.minimum(np.maximum(1.0, np.abs(self.low)), self.high - self.low)
            most = push * np.minimum(np.maximum(1.0, np.abs(self.high)), self.high - self.low)
            v = np.where(self.bounded_below, np.maximum(v, self.low + least), v)
            return np.where(self.bounded_above, np.minimum(v, self.high - most), v)

    def _begin(self, start: Array | NlpResult) -> _State:
        warm = isinstance(start, NlpResult)
        push = _WARM_PUSH if warm else _FIRST_PUSH
        x = (start.x if isinstance(start, NlpResult) else start)[self.free]
        slacks = np.zeros(int((~self.equal).sum()))
        x = self._inside(np.concatenate([x, slacks]), push)[: self.n]
        g = self.program.constraints(self._x(x))
        v = self._inside(np.concatenate([x, g[~self.equal]]), push)
        below, above = self.mu / (v - self.low), self.mu / (self.high - v)
        y, w = np.zeros(self.system.m), np.zeros(len(slacks))
        if isinstance(start, NlpResult):
            known = np.concatenate([start.lam_x[self.free], start.lam_g[~self.equal]])
            below = np.where(self.bounded_below, np.maximum(-known, below), 0.0)
            above = np.where(self.bounded_above, np.maximum(known, above), 0.0)
            y, w = start.lam_g[self.equal], start.lam_g[~self.equal]
        else:
            w = (above - below)[self.n :]
        return _State(v, y, w, below, above, self.program.cost(self._x(v)), g)

    def _misses(self, g: Array, v: Array) -> tuple[Array, Array]:
        """How far equations and slacks are off."""
        return g[self.equal] - self.target, g[~self.equal] - v[self.n :]

    def _violation(self, g: Array, v: Array) -> float:
        return float(sum(np.abs(one).sum() for one in self._misses(g, v)))

    def _merit(self, f: float, v: Array) -> float:
        gaps = np.concatenate([(v - self.low)[self.bounded_below], (self.high - v)[self.bounded_above]])
        return f - self.mu * float(np.log(gaps).sum())

    def _error(self, now: _State, slope: Array) -> tuple[Callable[[float], float], float]:
        """How far the optimality conditions of the barrier problem are from being met, scaled, by its parameter; and
        how far the rows are off."""
        off = max(float(np.abs(one).max(initial=0.0)) for one in self._misses(now.g, now.v))
        with np.errstate(invalid="ignore"):
            gaps = np.concatenate([(now.v - self.low)[self.bounded_below], (self.high - now.v)[self.bounded_above]])
        held = np.concatenate([now.below[self.bounded_below], now.above[self.bounded_above]])
        pressed = float(held.sum())
        scale = max(100.0, pressed / max(len(held), 1)) / 100
        spread = (pressed + np.abs(now.y).sum() + np.abs(now.w).sum()) / (len(held) + len(now.y) + len(now.w) + 1)
        dual = float(np.abs(slope - now.below + now.above).max() / (max(100.0, spread) / 100))
        products = gaps * held
        low, high = float(products.min(initial=np.inf)), float(products.max(initial=-np.inf))
        return lambda mu: max(dual, off, max(high - mu, mu - low, 0.0) / scale), off

    # ------------------------------------------------------------------------------------------------------- steps

    def run(self, start: Array | NlpResult, most: int, stop: Callable[[], bool] | None) -> NlpResult:
        """See InteriorPoint.solve."""
        now = self._begin(start)
        if not np.all(np.isfinite(now.g)):
            return self._answer(now, False, "no number at the start", 0)
        first = self._violation(now.g, now.v)
        self.worst, self.near = _WORST * max(1.0, first), 1e-4 * max(1.0, first)
        feasible = _FEASIBLE_ROUGH if self.tolerance > _FEASIBLE_ROUGH else _FEASIBLE
        system, program = self.system, self.program
        almost: _State | None = None
        for iteration in range(most + 1):
            x = self._x(now.v)
            system.take(program.jacobian(x))
            gradient = program.gradient(x)[self.free]
            slope = np.concatenate(
                [gradient + system.J_E.transposed_times(now.y) + system.J_I.transposed_times(now.w), -now.w]
            )
            error, off = self._error(now, slope)
            if error(0.0) <= self.tolerance and off <= feasible:
                return self._answer(now, True, "solved", iteration)
            if error(0.0) <= _ALMOST and off <= _ALMOST_FEASIBLE:
                almost = now
            if stop is not None and stop():
                return self._answer(now, False, "stopped", iteration)
            if iteration == most:
                break
            while self.mu > self.tolerance / 11 and error(self.mu) <= _BARRIER_ERROR * self.mu:
                self.mu = max(self.tolerance / 11, min(_BARRIER_FACTOR * self.mu, self.mu**_BARRIER_POWER))
                self.filter = []
            after = self._step(now, x, gradient, slope) or self._mended(now)
            if after is None:
                break
            now = after
        if almost is not None:
            return self._answer(almost, True, "nearly solved", iteration)
        return self._answer(now, False, "too many iterations" if iteration == most else "no step is better", iteration)

    def _step(self, now: _State, x: Array, gradient: Array, slope: Array) -> _State | None:
        system, n = self.system, self.n
        lam = np.zeros(len(self.equal))
        lam[self.equal], lam[~self.equal] = now.y, now.w
        to_low, to_high = now.v - self.low, self.high - now.v
        stiff = now.below / to_low + now.above / to_high
        rest = slope - self.mu / to_low + self.mu / to_high
        system.fill(self.program.hessian(x, lam), stiff[n:], stiff[:n])
        if not self._convex():
            return None

        def direction(missed: Array, slack: Array) -> tuple[Array, Array, Array]:
            """dv, dy and dw for rows that are off by these."""
            dx, dy = system.solve(-(rest[:n] + system.J_I.transposed_times(stiff[n:] * slack + rest[n:])), -missed)
            ds = system.J_I.times(dx) + slack
            return np.concatenate([dx, ds]), dy, stiff[n:] * ds + rest[n:]

        missed, slack = self._misses(now.g, now.v)
        dv, dy, dw = direction(missed, slack)
        d_below = self.mu / to_low - now.below - now.below / to_low * dv
        d_above = self.mu / to_high - now.above + now.above / to_high * dv
        tau = max(_LEAST_TAU, 1 - self.mu)
        dual = min(_most(now.below, d_below, tau), _most(now.above, d_above, tau))
        downhill = float(gradient @ dv[:n] + (self.mu / to_high - self.mu / to_low) @ dv)
        theta, phi = self._violation(now.g, now.v), self._merit(now.f, now.v)

        def tried(dv: Array, length: float) -> tuple[Array, Array, float] | None:
            """The point and its values there, None where there are none."""
            v = now.v + length * dv
            g = self.program.constraints(self._x(v))
            return (v, g, self.program.cost(self._x(v))) if np.all(np.isfinite(g)) else None

        length = self._longest(now.v, dv, tau)
        for k in range(_BACKTRACKS):
            found = tried(dv, length)
            if found is not None:
                if self._better(found, theta, phi, downhill, length):
                    break
                if k == 0 and self._violation(found[1], found[0]) >= theta:  # rows bend: once more with what is left
                    again, equations = self._misses(found[1], found[0]), length * missed
                    corrected = direction(equations + again[0], length * slack + again[1])
                    further = tried(corrected[0], self._longest(now.v, corrected[0], tau))
                    if further is not None and self._better(further, theta, phi, downhill, length):
                        found, dy, dw = further, corrected[1], corrected[2]
                        break
            length /= 2
        else:
            return None
        v, g, f = found
        below = self._kept(now.below + dual * d_below, v - self.low)
        above = self._kept(now.above + dual * d_above, self.high - v)
        return _State(v, now.y + length * dy, now.w + length * dw, below, above, f, g)

    def _mended(self, now: _State) -> _State | None:
        """A point nearer to where all rows are met, by steps that mind nothing but those and the bounds; None where
        there is none."""
        theta, phi = self._violation(now.g, now.v), self._merit(now.f, now.v)
        self.filter.append(((1 - _FILTER) * theta, phi - _ARMIJO * theta))
        nothing = np.zeros(len(self.program.hessian(self._x(now.v), np.zeros(len(self.equal)))))
        v, g, left = now.v, now.g, theta
        for _ in range(_MENDINGS):
            self.system.take(self.program.jacobian(self._x(v)))
            scale = 1 / np.minimum(1.0, np.minimum(v - self.low, self.high - v)) ** 2
            self.system.fill(nothing, scale[self.n :], scale[: self.n])
            if not self.system.factorise(0.0):
                return None
            missed, slack = self._misses(g, v)
            dx, _ = self.system.solve(-self.system.J_I.transposed_times(scale[self.n :] * slack), -missed)
            dv = np.concatenate([dx, self.system.J_I.times(dx) + slack])
            length = self._longest(v, dv, _LEAST_TAU)
            for _ in range(_BACKTRACKS):
                g_1 = self.program.constraints(self._x(v + length * dv))
                if np.all(np.isfinite(g_1)) and self._violation(g_1, v + length * dv) <= (1 - 1e-4 * length) * left:
                    break
                length /= 2
            else:
                return None
            v, g = v + length * dv, g_1
            left, f = self._violation(g, v), self.program.cost(self._x(v))
            if left <= _MENDED * theta and self._passes_filter(left, self._merit(f, v)):
                below, above = (
                    self._kept(one, gap) for one, gap in ((now.below, v - self.low), (now.above, self.high - v))
                )
                return _State(v, now.y, now.w, below, above, f, g)
        return None

    def _convex(self) -> bool:
        """Factorise, with as much of the identity as it takes."""
        if self.system.factorise(0.0):
            return True
        shift = _FIRST_SHIFT if self.shift == 0 else self.shift / 3
        factor = 100.0 if self.shift == 0 else 8.0
        while shift < _MOST_SHIFT:
            if self.system.factorise(shift):
                self.shift = shift
                return True
            shift *= factor
        return False

    def _longest(self, v: Array, dv: Array, tau: float) -> float:
        return min(_most(v - self.low, dv, tau), _most(self.high - v, -dv, tau))

    def _better(
        self, found: tuple[Array, Array, float], theta: float, phi: float, downhill: float, length: float
    ) -> bool:
        """Whether the filter takes a point; it is remembered there unless the merit fell as predicted."""
        v, g, f = found
        theta_1, phi_1 = self._violation(g, v), self._merit(f, v)
        if not self._passes_filter(theta_1, phi_1):
            return False
        if downhill < 0 and length * (-downhill) ** 2.3 > theta**1.1 and theta <= self.near:
            return phi_1 - phi - _ROUNDING * abs(phi) <= _ARMIJO * length * downhill
        if theta_1 <= (1 - _FILTER) * theta or phi_1 - _ROUNDING * abs(phi) <= phi - _ARMIJO * theta:
            self.filter.append(((1 - _FILTER) * theta, phi - _ARMIJO * theta))
            return True
        return False

    def _passes_filter(self, theta: float, phi: float) -> bool:
        dominated = (theta > (1 - _FILTER) * a and phi > b - _FILTER * a for a, b in self.filter)
        return theta < self.worst and not any(dominated)

    def _kept(self, multiplier: Array, gap: Array) -> Array:
        """Multipliers no farther from the barrier's than a factor of 1e10."""
        return np.where(np.isfinite(gap), np.clip(multiplier, self.mu / (1e10 * gap), 1e10 * self.mu / gap), 0.0)

    def _answer(self, now: _State, converged: bool, status: str, iterations: int) -> NlpResult:
        lam_g, lam_x = np.zeros(len(self.equal)), np.zeros(len(self.free))
        lam_g[self.equal], lam_g[~self.equal] = now.y, now.w
        lam_x[self.free] = (now.above - now.below)[: self.n]
        off = max(float(np.abs(one).max(initial=0.0)) for one in self._misses(now.g, now.v))
        return NlpResult(self._x(now.v).copy(), lam_g, lam_x, off, converged, status, iterations)


def _most(gap: Array, change: Array, tau: float) -> float:
    """The longest step, at most one, that uses a share tau of every gap."""
    steepest = float(np.fmax.reduce(-change / gap, initial=0.0))  # no number where there is no gap
    return min(1.0, tau / steepest) if steepest > 0 else 1.0
