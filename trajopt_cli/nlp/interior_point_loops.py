"""What the interior point does with each row and each bound, in loops. See interior_point.py.

Rows of a sparse matrix: data, row by row, where rows begin, and columns. v: variables, then slacks; low and high: its
bounds, infinite where there are none; below and above: their multipliers.
"""
# mypy: disable-error-code="no-untyped-def, untyped-decorator"

from __future__ import annotations

from math import log

from numba import njit

_FLUSHED = 1e-100  # a product of gaps this small, or its inverse as great, is taken the logarithm of
_X, _I, _U = "float64[::1], ", "int64[::1], ", "uint64[::1], "  # unsigned: an index that is not counted from the end
_OPTIONS = {"error_model": "numpy", "no_cpython_wrapper": True, "no_cfunc_wrapper": True}


@njit([f"void({_X}{_U}{_X}{_I}{_I}{_U}{_X}float64[::1])"], **_OPTIONS)
def condense(hessian, at_hessian, data, begins, places, at_products, weights, filled):
    """Add to a symmetric matrix' nonzeros the Hessian's, and the products of each row with itself times its weight: its
    entries i <= j stand at at_products, from the row's place on."""
    for k in range(len(at_hessian)):
        filled[at_hessian[k]] += hessian[k]
    for row in range(len(weights)):
        p = places[row]
        for i in range(begins[row], begins[row + 1]):
            weighted = weights[row] * data[i]
            for j in range(i, begins[row + 1]):
                filled[at_products[p]] += weighted * data[j]
                p += 1


@njit([f"void({_X}{_I}{_U}{_I}{_U}{_I}{_U}{_I}{_X}{_X}float64[::1])"], **_OPTIONS)
def factorise(data, begins, rows, L_begins, L_rows, of_row, L_cols, full, y, L, D):
    """L D L' of a symmetric matrix, of which the upper triangle is given column by column: L column by column as well,
    without its diagonal. of_row, L_cols: which columns each row of L has; full, y: zeros, one for each row."""
    for k in range(len(D)):
        full[k] = L_begins[k]
    for k in range(len(D)):
        for p in range(begins[k], begins[k + 1]):
            y[rows[p]] = data[p]
        pivot, y[k] = y[k], 0.0
        for t in range(of_row[k], of_row[k + 1]):
            i = L_cols[t]
            part, y[i], end = y[i], 0.0, full[i]
            for q in range(L_begins[i], end):
                y[L_rows[q]] -= L[q] * part
            entry = part / D[i]
            L[end] = entry
            pivot -= entry * part
            full[i] = end + 1
        D[k] = pivot


@njit([f"void({_I}{_U}{_X}{_X}float64[::1])"], **_OPTIONS)
def substitute(L_begins, L_rows, L, D, x):
    """Solve by the factors, in place."""
    for i in range(len(x)):
        part = x[i]
        for q in range(L_begins[i], L_begins[i + 1]):
            x[L_rows[q]] -= L[q] * part
    for i in range(len(x) - 1, -1, -1):
        total = x[i] / D[i]
        for q in range(L_begins[i], L_begins[i + 1]):
            total -= L[q] * x[L_rows[q]]
        x[i] = total


@njit([f"void({_X}{_I}{_U}{_X}float64[::1])"], **_OPTIONS)
def subtract_product(data, begins, rows, x, out):
    """Take a symmetric matrix, of which the upper triangle is given column by column with a whole
    diagonal, times x from out."""
    for col in range(len(x)):
        part, last = x[col], begins[col + 1] - 1
        total = data[last] * part
        for k in range(begins[col], last):
            total += data[k] * x[rows[k]]
            out[rows[k]] -= data[k] * part
        out[col] -= total


@njit([f"void({_X}{_I}{_U}{_X}float64[::1])"], **_OPTIONS)
def add_transposed(data, begins, cols, y, out):
    """Add the transposed matrix times y."""
    for row in range(len(y)):
        part = y[row]
        for k in range(begins[row], begins[row + 1]):
            out[cols[k]] += data[k] * part


@njit([f"void({_X}{_I}{_U}{_X}float64[::1])"], **_OPTIONS)
def times(data, begins, cols, x, out):
    """The matrix times x."""
    for row in range(len(out)):
        total = 0.0
        for k in range(begins[row], begins[row + 1]):
            total += data[k] * x[cols[k]]
        out[row] = total


@njit([f"void({_X}{_X}{_X}{_X}{_U}{_U}{_X}{_X}{_X}float64[::1])"], **_OPTIONS)
def measure(v, low, high, g, equations, others, target, missed, slack, out):
    """How far equations and slacks are off, by row. out: their sum, their greatest, that of gaps' logarithms."""
    total, most, n = 0.0, 0.0, len(v) - len(others)
    for k in range(len(equations)):
        missed[k] = g[equations[k]] - target[k]
        total += abs(missed[k])
        most = max(most, abs(missed[k]))
    for k in range(len(others)):
        slack[k] = g[others[k]] - v[n + k]
        total += abs(slack[k])
        most = max(most, abs(slack[k]))
    logs, product = 0.0, 1.0
    for i in range(len(v)):
        if low[i] > -1e300:
            product *= v[i] - low[i]
        if product < _FLUSHED or product > 1 / _FLUSHED:
            logs += log(product)
            product = 1.0
        if high[i] < 1e300:
            product *= high[i] - v[i]
        if product < _FLUSHED or product > 1 / _FLUSHED:
            logs += log(product)
            product = 1.0
    out[0], out[1], out[2] = total, most, logs + log(product)


@njit([f"void({_X}{_X}{_X}{_X}{_X}{_X}float64[::1])"], **_OPTIONS)
def conditions(slope, v, low, high, below, above, out):
    """out: how far the slope is from the multipliers at most, their sum, the least and the greatest product of one with
    its gap."""
    off, total, held, least, most = 0.0, 0.0, 0.0, 1e300, -1e300
    for i in range(len(v)):
        rest = abs(slope[i] - below[i] + above[i])
        off = max(off, rest)
        total += rest
        held += below[i] + above[i]
        if low[i] > -1e300:
            product = (v[i] - low[i]) * below[i]
            least, most = min(least, product), max(most, product)
        if high[i] < 1e300:
            product = (high[i] - v[i]) * above[i]
            least, most = min(least, product), max(most, product)
    out[0] = off if total < 1e300 else total  # no number where one of them is none
    out[1], out[2], out[3] = held, least, most


@njit([f"void({_X}{_X}{_X}{_X}{_X}{_X}float64, {_X}float64[::1])"], **_OPTIONS)
def stiffen(v, low, high, below, above, slope, mu, stiff, rest):
    """What bounds add to the diagonal, and what the slope is of the barrier problem."""
    for i in range(len(v)):
        to_low, to_high = v[i] - low[i], high[i] - v[i]
        stiff[i] = below[i] / to_low + above[i] / to_high
        rest[i] = slope[i] - mu / to_low + mu / to_high


@njit([f"void({_X}{_X}{_X}{_X}{_X}{_X}float64, float64[::1])"], **_OPTIONS)
def steer(v, low, high, below, above, dv, mu, out):
    """out: the greatest share of a gap that a step dv uses, the same of multipliers, and how the barrier grows along
    it."""
    of_gap, of_multiplier, barrier = 0.0, 0.0, 0.0
    for i in range(len(v)):
        to_low, to_high = v[i] - low[i], high[i] - v[i]
        of_gap = max(of_gap, -dv[i] / to_low, dv[i] / to_high)
        barrier += (mu / to_high - mu / to_low) * dv[i]
        if below[i] > 0:
            of_multiplier = max(of_multiplier, 1 + (dv[i] - mu / below[i]) / to_low)
        if above[i] > 0:
            of_multiplier = max(of_multiplier, 1 - (dv[i] + mu / above[i]) / to_high)
    out[0], out[1], out[2] = of_gap, of_multiplier, barrier


@njit([f"void({_X}{_X}{_X}{_X}{_X}float64, float64, float64, {_X}float64[::1])"], **_OPTIONS)
def follow(v, low, high, dv, after, mu, length, far, below, above):
    """Multipliers behind a step dv: so far along their own, and no farther from the barrier's at the point after it
    than far times; in place."""
    for i in range(len(v)):
        to_low, to_high = v[i] - low[i], high[i] - v[i]
        if low[i] > -1e300:
            wanted, gap = mu / to_low - below[i] / to_low * dv[i], after[i] - low[i]
            wanted = below[i] + length * (wanted - below[i])
            below[i] = min(max(wanted, mu / (far * gap)), far * mu / gap)
        if high[i] < 1e300:
            wanted, gap = mu / to_high + above[i] / to_high * dv[i], high[i] - after[i]
            wanted = above[i] + length * (wanted - above[i])
            above[i] = min(max(wanted, mu / (far * gap)), far * mu / gap)
