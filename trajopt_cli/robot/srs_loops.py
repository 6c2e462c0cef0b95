"""The force on the tool of a seven-axis arm from its joint torques, one sample: what a control loop at 1 ms calls.

arm (15,): lengths base to shoulder, shoulder to elbow, elbow to wrist centre; the TCP from the wrist centre in the
flange's axes (3,) [m]; the base's rotation in the world, row by row. No BLAS: its threads wait for one another longer
than a 6 x 6 matrix takes.
"""
# mypy: disable-error-code="no-untyped-def, untyped-decorator"

from __future__ import annotations

from math import cos, inf, sin, sqrt

from numba import njit

_PART = {"error_model": "numpy", "no_cpython_wrapper": True, "no_cfunc_wrapper": True}


@njit(**_PART)
def _fill_jacobian(arm, q, frame, J):
    """The geometric Jacobian (6, 7) at the TCP in base axes, linear rows first. frame (4, 3): x, y, z, a point."""
    for i in range(4):
        for k in range(3):
            frame[i, k] = 1.0 if i == k else 0.0
    frame[3, 2] = arm[0]
    for i in range(7):
        if i == 3 or i == 5:
            for k in range(3):
                frame[3, k] += arm[1 if i == 3 else 2] * J[3 + k, i - 1]
        c, s = cos(q[i]), sin(q[i])
        turned, last = (0, 1) if i % 2 == 0 else (2, 0)  # of z, y, z, -y, z, y, z: x and y turn, or z and x
        axis, sign = 3 - turned - last, -1.0 if i == 3 else 1.0
        for k in range(3):
            J[3 + k, i], J[k, i] = sign * frame[axis, k], frame[3, k]
        for k in range(3):
            a, b = frame[turned, k], frame[last, k]
            frame[turned, k], frame[last, k] = c * a + sign * s * b, c * b - sign * s * a
    for k in range(3):
        frame[3, k] += arm[3] * frame[0, k] + arm[4] * frame[1, k] + arm[5] * frame[2, k]
    for i in range(7):
        x, y, z = frame[3, 0] - J[0, i], frame[3, 1] - J[1, i], frame[3, 2] - J[2, i]
        a, b, c = J[3, i], J[4, i], J[5, i]
        J[0, i], J[1, i], J[2, i] = b * z - c * y, c * x - a * z, a * y - b * x


@njit(
    "void(float64[::1], float64[::1], float64[::1], float64[:,::1], float64[:,::1], float64[:,::1], float64[::1])",
    error_model="numpy",
    no_cpython_wrapper=True,
    no_cfunc_wrapper=True,
)
def fill_force(arm, q, tau, frame, J, L, out):
    """out (7,): F = (J J^T)^-1 J tau (6,) in world axes, and the trace of (J J^T)^-1, inf where J has no rank.

    q, tau (7,); room for what is between: frame (4, 3), J (6, 7), L (6, 6).
    """
    _fill_jacobian(arm, q, frame, J)
    out[6] = 0.0
    for i in range(6):  # Cholesky's factor, row by row, and L^-1 J tau
        out[i] = 0.0
        for k in range(7):
            out[i] += J[i, k] * tau[k]
        for j in range(i + 1):
            value = 0.0
            for k in range(7):
                value += J[i, k] * J[j, k]
            for k in range(j):
                value -= L[i, k] * L[j, k]
            if j < i:
                L[i, j] = value / L[j, j]
            elif not value > 0.0:
                out[6] = inf
                return
            else:
                L[i, i] = sqrt(value)
        for k in range(i):
            out[i] -= L[i, k] * out[k]
        out[i] /= L[i, i]
    for j in range(6):  # L^-1, column by column, above the factor's diagonal
        for i in range(j, 6):
            value = 1.0 if i == j else 0.0
            for k in range(j, i):
                value -= L[i, k] * (1 / L[j, j] if k == j else L[j, k])
            value /= L[i, i]
            out[6] += value * value
            if i > j:
                L[j, i] = value
    for i in range(5, -1, -1):
        for k in range(i + 1, 6):
            out[i] -= L[k, i] * out[k]
        out[i] /= L[i, i]
    for part in (0, 3):
        a, b, c = out[part], out[part + 1], out[part + 2]
        for i in range(3):
            out[part + i] = arm[6 + 3 * i] * a + arm[7 + 3 * i] * b + arm[8 + 3 * i] * c
