"""Forward kinematics of a chain of six revolute joints, its Jacobian, and what moves it as a tool asks for; row by row.

chain (6, 7), a row per joint: the coordinate axis it turns about (0, 1, 2), its sign and offset, the way from the joint
before (3) [m], what it takes of the joint before (robot.arm.Arm.chain says more). X_WC (4, 4): where the first joint
stands with the rails at 0. ride (r, 3): the ways of the rails in the world. X_6T (4, 4): the tool behind the last
joint. q (n, k): the r rails first where there are some. room (4, 7, 7): for what is between.
"""
# mypy: disable-error-code="no-untyped-def, untyped-decorator"

from __future__ import annotations

from math import cos, sin

import numpy as np
from numba import njit

_PART = {"error_model": "numpy", "no_cpython_wrapper": True, "no_cfunc_wrapper": True}
_ARM = "float64[:,::1], float64[:,:], float64[:,:], float64[:,:], float64[:,:,::1], float64[:,:]"


@njit(**_PART)
def _frames(chain, X_WC, ride, X_6T, room, q):
    """Put the last link's axes, the joints' unit axes and a point on each, at last the tool's, into the first three."""
    e, a, o = room[0], room[1], room[2]
    rail = len(q) - 6
    for j in range(3):
        o[0, j] = X_WC[j, 3]
        for i in range(rail):
            o[0, j] += ride[i, j] * q[i]
        for k in range(3):
            e[k, j] = X_WC[j, k]
    before = 0.0
    for i in range(6):
        t = chain[i, 1] * q[rail + i] + chain[i, 2] - chain[i, 6] * before
        before = q[rail + i]
        c, s = cos(t), sin(t)
        k = int(chain[i, 0])
        u, v = (k + 1) % 3, (k + 2) % 3
        for j in range(3):
            o[i, j] = o[max(i - 1, 0), j] + e[0, j] * chain[i, 3] + e[1, j] * chain[i, 4] + e[2, j] * chain[i, 5]
            a[i, j] = e[k, j]
        for j in range(3):
            x, y = e[u, j], e[v, j]
            e[u, j], e[v, j] = c * x + s * y, c * y - s * x
    for j in range(3):
        o[6, j] = o[5, j] + e[0, j] * X_6T[0, 3] + e[1, j] * X_6T[1, 3] + e[2, j] * X_6T[2, 3]


@njit(**_PART)
def _jacobian(chain, room, J, rail):
    """Put the joints' columns of the geometric Jacobian at the tool behind the rail's."""
    a, o = room[1], room[2]
    for i in range(6):
        x, y, z = o[6, 0] - o[i, 0], o[6, 1] - o[i, 1], o[6, 2] - o[i, 2]
        v = a[i, 1] * z - a[i, 2] * y, a[i, 2] * x - a[i, 0] * z, a[i, 0] * y - a[i, 1] * x
        for j in range(3):
            J[j, rail + i], J[3 + j, rail + i] = chain[i, 1] * v[j], chain[i, 1] * a[i, j]
            if chain[i, 6] != 0:
                J[j, rail + i - 1] -= chain[i, 6] * v[j]
                J[3 + j, rail + i - 1] -= chain[i, 6] * a[i, j]


@njit(**_PART)
def _moved(chain, ride, room, qd, qdd, out):
    """Put the tool's twist and its rate (2, 6) at axis speeds and accelerations: joint by joint, from the base on."""
    a, o = room[1], room[2]
    rail = len(qd) - 6
    for j in range(3):
        out[0, j] = out[1, j] = out[0, 3 + j] = out[1, 3 + j] = 0.0
        for i in range(rail):
            out[0, j] += ride[i, j] * qd[i]
            out[1, j] += ride[i, j] * qdd[i]
    w, al = out[0, 3:], out[1, 3:]
    before, before_2 = 0.0, 0.0
    for i in range(6):
        r, rr = chain[i, 1] * qd[rail + i] - chain[i, 6] * before, chain[i, 1] * qdd[rail + i] - chain[i, 6] * before_2
        before, before_2 = qd[rail + i], qdd[rail + i]
        x, y, z = a[i, 0], a[i, 1], a[i, 2]
        al[0] += rr * x + r * (w[1] * z - w[2] * y)
        al[1] += rr * y + r * (w[2] * x - w[0] * z)
        al[2] += rr * z + r * (w[0] * y - w[1] * x)
        w[0] += r * x
        w[1] += r * y
        w[2] += r * z
        x, y, z = o[i + 1, 0] - o[i, 0], o[i + 1, 1] - o[i, 1], o[i + 1, 2] - o[i, 2]
        v = w[1] * z - w[2] * y, w[2] * x - w[0] * z, w[0] * y - w[1] * x
        out[1, 0] += al[1] * z - al[2] * y + w[1] * v[2] - w[2] * v[1]
        out[1, 1] += al[2] * x - al[0] * z + w[2] * v[0] - w[0] * v[2]
        out[1, 2] += al[0] * y - al[1] * x + w[0] * v[1] - w[1] * v[0]
        for j in range(3):
            out[0, j] += v[j]


@njit(**_PART)
def _factored(A, order):
    """Put lower and upper factors of A (6, 6) in its place, and which row stands where; NaN where it is singular."""
    for i in range(6):
        order[i] = i
    for k in range(6):
        p = k
        for i in range(k + 1, 6):
            if abs(A[i, k]) > abs(A[p, k]):
                p = i
        if A[p, k] == 0:
            A[p, k] = np.nan
        if p != k:
            order[k], order[p] = order[p], order[k]
            for j in range(6):
                A[k, j], A[p, j] = A[p, j], A[k, j]
        for i in range(k + 1, 6):
            A[i, k] /= A[k, k]
            for j in range(k + 1, 6):
                A[i, j] -= A[i, k] * A[k, j]


@njit(**_PART)
def _solved(A, order, b, x):
    """Put the x of A x = b into x (6,), of what _factored has left."""
    for i in range(6):
        x[i] = b[int(order[i])]
        for j in range(i):
            x[i] -= A[i, j] * x[j]
    for i in range(5, -1, -1):
        for j in range(i + 1, 6):
            x[i] -= A[i, j] * x[j]
        x[i] /= A[i, i]


@njit([f"void({_ARM}, float64[:,:,::1])"], error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True)
def poses(chain, X_WC, ride, X_6T, room, q, X):
    """The tool's poses X_WT (n, 4, 4)."""
    for n in range(len(q)):
        _frames(chain, X_WC, ride, X_6T, room, q[n])
        e = room[0]
        for j in range(3):
            for k in range(3):
                X[n, j, k] = e[0, j] * X_6T[0, k] + e[1, j] * X_6T[1, k] + e[2, j] * X_6T[2, k]
            X[n, j, 3], X[n, 3, j] = room[2, 6, j], 0.0
        X[n, 3, 3] = 1.0


@njit([f"void({_ARM}, float64[:,:,::1])"], error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True)
def points(chain, X_WC, ride, X_6T, room, q, o):
    """A point on each joint's axis, and the tool's: (n, 7, 3)."""
    for n in range(len(q)):
        _frames(chain, X_WC, ride, X_6T, room, q[n])
        for i in range(7):
            for j in range(3):
                o[n, i, j] = room[2, i, j]


@njit([f"void({_ARM}, float64[:,:,::1])"], error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True)
def jacobians(chain, X_WC, ride, X_6T, room, q, J):
    """Geometric Jacobians (n, 6, k), linear rows first."""
    rail = q.shape[1] - 6
    for n in range(len(q)):
        _frames(chain, X_WC, ride, X_6T, room, q[n])
        _jacobian(chain, room, J[n], rail)
        for i in range(rail):
            for j in range(3):
                J[n, j, i], J[n, 3 + j, i] = ride[i, j], 0.0


@njit(
    [f"void({_ARM}, float64[:,:], float64[:,:], float64[:,:,::1])"],
    error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True,
)  # fmt: skip
def motions(chain, X_WC, ride, X_6T, room, q, qd, qdd, out):
    """The tool's twist and its rate (n, 2, 6) at axis speeds and accelerations (n, k)."""
    for n in range(len(q)):
        _frames(chain, X_WC, ride, X_6T, room, q[n])
        _moved(chain, ride, room, qd[n], qdd[n], out[n])


@njit(
    [f"void({_ARM}, {'float64[:,:], ' * 4} float64[:,::1], float64[:,::1])"],
    error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True,
)  # fmt: skip
def follow(chain, X_WC, ride, X_6T, room, q, twist, bend, rail_rate, rail_bend, qd, qdd):
    """Axis speeds and accelerations (n, k) that move the tool by a twist and its rate (n, 6), the rails by their
    own."""
    rail = q.shape[1] - 6
    A, order, moved, b = room[3, :6], room[3, 6], room[0, 3:5], room[0, 5]
    for n in range(len(q)):
        _frames(chain, X_WC, ride, X_6T, room, q[n])
        _jacobian(chain, room, A, 0)
        _factored(A, order)
        for j in range(rail):
            qd[n, j], qdd[n, j] = rail_rate[n, j], rail_bend[n, j]
        for j in range(6):
            b[j] = twist[n, j]
            for i in range(rail if j < 3 else 0):
                b[j] -= ride[i, j] * rail_rate[n, i]
        _solved(A, order, b, qd[n, rail:])
        for j in range(6):
            qdd[n, rail + j] = 0.0
        _moved(chain, ride, room, qd[n], qdd[n], moved)
        for j in range(6):
            b[j] = bend[n, j] - moved[1, j]
        _solved(A, order, b, qdd[n, rail:])
