"""A primal-dual interior point for programs whose rows each touch a few neighbouring variables.

    min f(x)   s.t.   lower <= x <= upper,   g_lower <= g(x) <= g_upper

Every row that is no equation gets a slack within its bounds. Slacks and bounds are eliminated before anything is
factorised, so a row far from its limit costs a few products and nothing more: what is left is the symmetric system

    [ H + J_I' S J_I + D   J_E' ] [ dx ]
    [ J_E                  -eps ] [ dy ]

over variables and equations, whose pattern is that of the stages along the program. It is quasi-definite, or made so by
a multiple of the identity: the signs of D in its factors L D L' say when. A filter accepts steps; where none is
accepted, steps follow that only mend rows. Sources: Wächter and Biegler 2006 (barrier, filter, inertia), Vanderbei 1995
(quasi-definite systems), QDLDL (the order and, written anew, the factorization).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
import qdldl
from numpy.typing import NDArray

from trajopt_cli.geometry import Array, BoolArray, IndexArray
from trajopt_cli.native.loops import loops

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
_FAR = 1e10  # times the barrier's multipliers, or a part of them, that kept ones may be
_LOOPS = "trajopt_cli.nlp.interior_point_loops"


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
        self.J_E = _Rows(entries[mine], equation[rows[mine]], cols[mine], self.m)
        self.J_I = _Rows(entries[~mine], inequality[rows[~mine]], cols[~mine], int((~equal).sum()))
        self._places, of_products = self.J_I.products()
        self._of_hessian = np.flatnonzero((column[h_rows] >= 0) & (column[h_cols] >= 0))
        total = self.n + self.m
        diagonal = np.arange(total)
        at = [
            (column[h_rows[self._of_hessian]], column[h_cols[self._of_hessian]]),
            of_products,
            (cols[mine], self.n + equation[rows[mine]]),
            (diagonal, diagonal),
        ]
        a, b = (np.concatenate(one) for one in zip(*at, strict=True))
        places, bins = np.unique(np.maximum(a, b) * total + np.minimum(a, b), return_inverse=True)
        a, b = places % total, places // total
        L, self._order = self._ordered(a, b)
        self._found_at = np.argsort(self._order)
        a, b = self._found_at[a], self._found_at[b]
        places = np.maximum(a, b) * total + np.minimum(a, b)
        order = np.argsort(places)
        places, bins = places[order], np.argsort(order)[bins]
        self._begins, (self._rows,) = np.searchsorted(places, np.arange(total + 1) * total), _unsigned(places % total)
        ends = np.cumsum([len(one) for one, _ in at])
        self._at_hessian, self._at_products, self._at_equations, self._diagonal = _unsigned(*np.split(bins, ends[:-1]))
        L_rows = L.tocsr()
        L_at = [one for half in (L, L_rows) for one in (half.indptr.astype(np.int64), half.indices.astype(np.uint64))]
        self._D, self._eps = np.empty(total), np.where(self._order < self.n, 0.0, _EQUATION_EPS)
        self._values, self._filled = np.empty((2, len(places)))
        self._found, self._rest = np.empty((2, total))
        self._hessian, self._weights = np.empty(len(self._of_hessian)), np.empty(len(self.J_I.begins) - 1)
        # told once what they work on: that takes as long as the work itself where a program is short
        run, matrix = loops(_LOOPS), (self._values, self._begins, self._rows)
        factors = *L_at[:2], np.empty(L.nnz), self._D
        self._condense = run["condense"].on(
            self._hessian, self._at_hessian, self.J_I.data, self.J_I.begins, self._places, self._at_products,
            self._weights, self._filled,
        )  # fmt: skip
        self._factorise = run["factorise"].on(
            *matrix, *L_at, np.zeros(total, dtype=np.int64), np.zeros(total), *factors[2:]
        )
        self._substitute, self._substitute_rest = (run["substitute"].on(*factors, x) for x in (self._found, self._rest))
        self._subtract_product = run["subtract_product"].on(*matrix, self._found, self._rest)

    def _ordered(self, row: IndexArray, col: IndexArray) -> tuple[Any, IndexArray]:
        """The pattern of L of the system with these places in its upper triangle, the diagonal among them; and the
        order in which it takes rows so that L has few entries."""
        from scipy import sparse  # takes longer to load than a short program to search

        total = self.n + self.m
        data = np.where(row < col, 1.0, np.where(row < self.n, total, -total))
        L, _, order = qdldl.Solver(sparse.csc_matrix((data, (row, col)), shape=(total, total)), upper=True).factors()
        L.sort_indices()
        return L, order

    def take(self, jacobian: Array) -> None:
        """The Jacobian's nonzeros."""
        for rows in (self.J_E, self.J_I):
            np.take(jacobian, rows.entries, out=rows.data, mode="clip")

    def fill(self, hessian: Array, weights: Array, diagonal: Array) -> None:
        """The Hessian's nonzeros, weights of the rows that are no equations, what else stands on the diagonal (n,)."""
        self._filled[:] = 0.0
        self._filled[self._diagonal] = np.concatenate([diagonal, np.full(self.m, -_EQUATION_EPS)])
        self._filled[self._at_equations] = self.J_E.data
        np.take(hessian, self._of_hessian, out=self._hessian, mode="clip")
        self._weights[:] = weights
        self._condense()

    def factorise(self, shift: float) -> bool:
        """With a multiple of the identity added for the variables; False where that is not convex enough."""
        self._values[:] = self._filled
        self._values[self._diagonal[: self.n]] += shift
        self._factorise()
        return bool(np.all(np.isfinite(self._D)) and int((self._D > 0).sum()) == self.n)

    def solve(self, of_x: Array, of_y: Array) -> tuple[Array, Array]:
        """dx and dy, the equations met exactly up to rounding."""
        wanted = np.concatenate([of_x, of_y])[self._order]
        self._found[:] = wanted
        self._substitute()
        for _ in range(_REFINEMENTS):
            np.subtract(wanted, self._eps * self._found, out=self._rest)
            self._subtract_product()
            self._substitute_rest()
            self._found += self._rest
        found = self._found[self._found_at]
        return found[: self.n], found[self.n :]


class _Rows:
    """Some rows of the Jacobian. entries: where theirs stand among its nonzeros, row by row; data: those."""

    def __init__(self, entries: IndexArray, rows: IndexArray, cols: IndexArray, count: int):
        self.entries = entries
        self.begins, (self._cols,) = np.searchsorted(rows, np.arange(count + 1)), _unsigned(cols)
        self.data = np.zeros(len(cols))
        self._loops = loops(_LOOPS)

    def products(self) -> tuple[IndexArray, Places]:
        """Where those of each row begin among the products, and the columns of their two entries: of all rows behind
        each other that touch the same variables but once."""
        counts, every, cols = np.diff(self.begins), np.arange(len(self._cols)), self._cols.astype(np.intp)
        row = np.repeat(np.arange(len(counts)), counts)
        other = np.bincount(row, cols != cols[every - counts[row]], minlength=len(counts)) > 0
        other |= counts != np.concatenate([[0], counts[:-1]])
        other[:1] = True
        places = np.concatenate([[0], np.cumsum(np.where(other, counts * (counts + 1) // 2, 0))[:-1]])
        places = places[np.maximum.accumulate(np.where(other, np.arange(len(counts)), 0))]
        of = every[other[row]]
        later = self.begins[1:][row[of]] - of  # it and those behind it in its row
        first = np.repeat(of, later)
        second = first + np.arange(len(first)) - np.repeat(np.cumsum(later) - later, later)
        return places, (cols[first], cols[second])

    def times(self, x: Array) -> Array:
        """Matrix times x."""
        out = np.empty(len(self.begins) - 1)
        self._loops["times"](self.data, self.begins, self._cols, x, out)
        return out

    def add_transposed(self, y: Array, out: Array) -> None:
        """Add the transpose times y."""
        self._loops["add_transposed"](self.data, self.begins, self._cols, y, out)


def _unsigned(*indices: IndexArray) -> tuple[NDArray[np.uint64], ...]:
    return tuple(one.astype(np.uint64) for one in indices)


@dataclass(frozen=True, eq=False)
class _Point:
    """v = (x, slacks), with cost f and rows g there; missed, slack: how far equations and slacks are off; violation,
    off: their sum and greatest; logs: of v's gaps to its bounds, added up."""

    v: Array
    f: float
    g: Array
    missed: Array
    slack: Array
    violation: float
    off: float
    logs: float


@dataclass(frozen=True, eq=False)
class _State:
    """A point with its multipliers: y of equations, w of the other rows, below and above of v's bounds, zero where
    there is none."""

    at: _Point
    y: Array
    w: Array
    below: Array
    above: Array


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
        self.n, self.loops = system.n, loops(_LOOPS)
        self.whole = bounds.lower.copy()  # all variables, the fixed ones with their values
        self.equations, self.others = _unsigned(np.flatnonzero(equal), np.flatnonzero(~equal))
        self.target = bounds.g_lower[equal]
        self.low = np.concatenate([bounds.lower[free], bounds.g_lower[~equal]])
        self.high = np.concatenate([bounds.upper[free], bounds.g_upper[~equal]])
        self.bounded_below, self.bounded_above = np.isfinite(self.low), np.isfinite(self.high)
        self.held = int(self.bounded_below.sum() + self.bounded_above.sum())
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
        slacks = np.zeros(len(self.others))
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
        return _State(self._point(v, g), y, w, below, above)

    def _point(self, v: Array, g: Array) -> _Point:
        missed, slack, out = np.empty(len(self.equations)), np.empty(len(self.others)), np.empty(3)
        self.loops["measure"](v, self.low, self.high, g, self.equations, self.others, self.target, missed, slack, out)
        return _Point(v, self.program.cost(self._x(v)), g, missed, slack, *out.tolist())

    def _tried(self, v: Array) -> _Point | None:
        """v with the values there, None where there are none."""
        g = self.program.constraints(self._x(v))
        return self._point(v, g) if np.all(np.isfinite(g)) else None

    def _merit(self, at: _Point) -> float:
        return at.f - self.mu * at.logs

    def _error(self, now: _State, slope: Array) -> Callable[[float], float]:
        """How far the optimality conditions of the barrier problem are from being met, scaled, by its parameter."""
        out = np.empty(4)
        self.loops["conditions"](slope, now.at.v, self.low, self.high, now.below, now.above, out)
        off, pressed, low, high = out.tolist()
        scale = max(100.0, pressed / max(self.held, 1)) / 100
        spread = (pressed + np.abs(now.y).sum() + np.abs(now.w).sum()) / (self.held + len(now.y) + len(now.w) + 1)
        dual = off / (max(100.0, float(spread)) / 100)
        return lambda mu: max(dual, now.at.off, max(high - mu, mu - low, 0.0) / scale)

    # ------------------------------------------------------------------------------------------------------- steps

    def run(self, start: Array | NlpResult, most: int, stop: Callable[[], bool] | None) -> NlpResult:
        """See InteriorPoint.solve."""
        now = self._begin(start)
        if not np.all(np.isfinite(now.at.g)):
            return self._answer(now, False, "no number at the start", 0)
        first = now.at.violation
        self.worst, self.near = _WORST * max(1.0, first), 1e-4 * max(1.0, first)
        feasible = _FEASIBLE_ROUGH if self.tolerance > _FEASIBLE_ROUGH else _FEASIBLE
        system, program = self.system, self.program
        almost: _State | None = None
        for iteration in range(most + 1):
            x = self._x(now.at.v)
            system.take(program.jacobian(x))
            gradient = program.gradient(x)[self.free]
            slope = np.concatenate([gradient, -now.w])
            system.J_E.add_transposed(now.y, slope)
            system.J_I.add_transposed(now.w, slope)
            error, off = self._error(now, slope), now.at.off
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
        system, n, mu, at = self.system, self.n, self.mu, now.at
        lam = np.zeros(len(self.equal))
        lam[self.equations], lam[self.others] = now.y, now.w
        stiff, rest = np.empty(len(at.v)), np.empty(len(at.v))
        self.loops["stiffen"](at.v, self.low, self.high, now.below, now.above, slope, mu, stiff, rest)
        system.fill(self.program.hessian(x, lam), stiff[n:], stiff[:n])
        if not self._convex():
            return None

        def direction(missed: Array, slack: Array) -> tuple[Array, Array, Array]:
            """dv, dy and dw for rows that are off by these."""
            of_x = rest[:n].copy()
            system.J_I.add_transposed(stiff[n:] * slack + rest[n:], of_x)
            dx, dy = system.solve(-of_x, -missed)
            ds = system.J_I.times(dx) + slack
            return np.concatenate([dx, ds]), dy, stiff[n:] * ds + rest[n:]

        def steered(dv: Array) -> tuple[float, float, float]:
            """The greatest shares of gaps and of multipliers that a step uses, how the barrier grows along it."""
            out = np.empty(3)
            self.loops["steer"](at.v, self.low, self.high, now.below, now.above, dv, mu, out)
            return out[0], out[1], out[2]

        dv, dy, dw = direction(at.missed, at.slack)
        of_gap, of_multiplier, barrier = steered(dv)
        tau = max(_LEAST_TAU, 1 - mu)
        length, dual = _share(of_gap, tau), _share(of_multiplier, tau)
        downhill = float(gradient @ dv[:n]) + barrier
        taken = dv
        for k in range(_BACKTRACKS):
            found = self._tried(at.v + length * dv)
            if found is not None:
                if self._better(found, at, downhill, length):
                    break
                if k == 0 and found.violation >= at.violation:  # rows bend: once more with what is left
                    corrected = direction(length * at.missed + found.missed, length * at.slack + found.slack)
                    further = self._tried(at.v + _share(steered(corrected[0])[0], tau) * corrected[0])
                    if further is not None and self._better(further, at, downhill, length):
                        found, dy, dw = further, corrected[1], corrected[2]
                        break
            length /= 2
        else:
            return None
        below, above = now.below.copy(), now.above.copy()
        self.loops["follow"](at.v, self.low, self.high, taken, found.v, mu, dual, _FAR, below, above)
        return _State(found, now.y + length * dy, now.w + length * dw, below, above)

    def _mended(self, now: _State) -> _State | None:
        """A point nearer to where all rows are met, by steps that mind nothing but those and the bounds; None where
        there is none."""
        theta, phi, at = now.at.violation, self._merit(now.at), now.at
        self.filter.append(((1 - _FILTER) * theta, phi - _ARMIJO * theta))
        nothing = np.zeros(len(self.program.hessian(self._x(at.v), np.zeros(len(self.equal)))))
        for _ in range(_MENDINGS):
            self.system.take(self.program.jacobian(self._x(at.v)))
            scale = 1 / np.minimum(1.0, np.minimum(at.v - self.low, self.high - at.v)) ** 2
            self.system.fill(nothing, scale[self.n :], scale[: self.n])
            if not self.system.factorise(0.0):
                return None
            of_x = np.zeros(self.n)
            self.system.J_I.add_transposed(scale[self.n :] * at.slack, of_x)
            dx, _ = self.system.solve(-of_x, -at.missed)
            dv = np.concatenate([dx, self.system.J_I.times(dx) + at.slack])
            length = _share(float(np.maximum(-dv / (at.v - self.low), dv / (self.high - at.v)).max()), _LEAST_TAU)
            for _ in range(_BACKTRACKS):
                found = self._tried(at.v + length * dv)
                if found is not None and found.violation <= (1 - 1e-4 * length) * at.violation:
                    break
                length /= 2
            else:
                return None
            at = found
            if at.violation <= _MENDED * theta and self._passes_filter(at.violation, self._merit(at)):
                below, above = (
                    self._kept(one, gap) for one, gap in ((now.below, at.v - self.low), (now.above, self.high - at.v))
                )
                return _State(at, now.y, now.w, below, above)
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

    def _better(self, found: _Point, at: _Point, downhill: float, length: float) -> bool:
        """Whether the filter takes a point; it is remembered there unless the merit fell as predicted."""
        theta, phi, theta_1, phi_1 = at.violation, self._merit(at), found.violation, self._merit(found)
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
        return np.where(np.isfinite(gap), np.clip(multiplier, self.mu / (_FAR * gap), _FAR * self.mu / gap), 0.0)

    def _answer(self, now: _State, converged: bool, status: str, iterations: int) -> NlpResult:
        lam_g, lam_x = np.zeros(len(self.equal)), np.zeros(len(self.free))
        lam_g[self.equal], lam_g[~self.equal] = now.y, now.w
        lam_x[self.free] = (now.above - now.below)[: self.n]
        return NlpResult(self._x(now.at.v).copy(), lam_g, lam_x, now.at.off, converged, status, iterations)


def _share(used: float, tau: float) -> float:
    """The longest step, at most one, that uses a share tau of every gap, of which a whole one uses so much."""
    return min(1.0, tau / used) if used > 0 else 1.0
