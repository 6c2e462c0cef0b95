"""The law of the compliant controller, eqs 4.10-4.16: six decoupled masses on springs and dampers.

Per axis, with the deviation e = x - x_e and the rate w = v - v_e (v_e = 0 when only positions are fed, eq. 4.15):

    v' = v_e + a w + b e + c F        x' = x + h v_e + p w + q e + r F

Forward Euler is a = 1 - h d/m, b = -h k/m, c = h/m, p = h, q = r = 0 (eqs 4.13-4.14): the new position takes the old
speed. The exact law puts the solution of m w' + d w + k e = F over one period there, F held.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import isqrt

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array, readonly
from trajopt_cli.iiwa.controller.rotations import Nine, Three, exponential, logarithm, nine, transpose
from trajopt_cli.iiwa.task.model import Compliance, Feed, Integration
from trajopt_cli.iiwa.task.world import Six
from trajopt_cli.robot.srs_step import product

Coefficients = tuple[float, float, float, float, float, float]

STILL: Six = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@dataclass(frozen=True, eq=False)
class Response:
    """State over time: row k is x (n, 6) [m, rad] and v (n, 6) [m/s, rad/s] at time k h."""

    x: Array
    v: Array


@dataclass(frozen=True, eq=False)
class TurnResponse:
    """Orientation over time: row k is R (n, 3, 3) in the world and the angular velocity w (n, 3) [rad/s] there."""

    R: Array
    w: Array


def coefficients(K: Array, D: Array, M: Array, h: float, integration: Integration) -> list[Coefficients]:
    """a, b, c, p, q, r of every axis; K, D, M are diagonals (k,), h [s] the period."""
    if integration is Integration.EULER:
        return [
            (float(1 - h * d / m), float(-h * k / m), float(h / m), h, 0.0, 0.0)
            for k, d, m in zip(K, D, M, strict=True)
        ]
    from scipy.linalg import expm

    out = []
    for k, d, m in zip(K, D, M, strict=True):
        # w, e and the held force as a third state that never changes
        Phi = expm(h * np.array([[-d / m, -k / m, 1 / m], [1, 0, 0], [0, 0, 0]]))
        (a, b, c), (p, q, r) = Phi[0].tolist(), Phi[1].tolist()
        out.append((a, b, c, p, q - 1, r))
    return out


def response(
    x_e: ArrayLike,
    h: float,
    compliance: Compliance,
    *,
    integration: Integration = Integration.EULER,
    feed: Feed = Feed.POSITION,
    force: ArrayLike | None = None,
    x_0: ArrayLike | None = None,
    v_0: ArrayLike | None = None,
    changes: Sequence[tuple[int, Compliance]] = (),
) -> Response:
    """What the controller makes of an equilibrium x_e (n, 6) [m, rad], one row every h [s], angles as numbers.

    force (n, 6) [N, Nm]: external force, none for None. Row k is the state at k h; x_e and force of row k act from
    k h to (k + 1) h. x_0, v_0 (6,): the state at 0, x_e's first row at rest for None. feed VELOCITY: the equilibrium
    also moves on with v_e = (x_e,k+1 - x_e,k) / h, zero after its last row. changes: rows, in order, from which on
    another compliance holds.
    """
    x_e = np.asarray(x_e, dtype=np.float64)
    start = x_e[0] if x_0 is None else np.asarray(x_0, dtype=np.float64)
    rate = np.zeros(6) if v_0 is None else np.asarray(v_0, dtype=np.float64)
    v_e = equilibrium_rates(x_e, h) if feed is Feed.VELOCITY else np.zeros_like(x_e)
    pushes = np.zeros_like(x_e) if force is None else np.asarray(force, dtype=np.float64)
    v, x = np.empty((2, *x_e.shape))
    for (first, law), (end, _) in pairwise([(0, compliance), *changes, (len(x_e), compliance)]):
        rows = slice(first, min(end + 1, len(x_e)))  # the state at the end is where the next one begins
        a, b, c, p, q, r = np.array(coefficients(law.K, law.D, law.M, h, integration)).T
        # what does not depend on the state, for all periods at once
        kick = (1 - a) * v_e[rows] - b * x_e[rows] + c * pushes[rows]
        shift = (h - p) * v_e[rows] - q * x_e[rows] + r * pushes[rows]
        v[rows], x[rows] = _scan((a, b, p, 1 + q), kick, shift, rate, start)
        rate, start = v[rows][-1], x[rows][-1]
    return Response(readonly(x), readonly(v))


def equilibrium_rates(x_e: Array, h: float) -> Array:
    """v_e (n, k): the forward difference of x_e (n, k) over h [s], zero in the last row."""
    v_e = np.zeros_like(x_e)
    v_e[:-1] = np.diff(x_e, axis=0) / h
    return v_e


def _scan(
    law: tuple[Array, Array, Array, Array], kick: Array, shift: Array, v_0: Array, x_0: Array
) -> tuple[Array, Array]:
    """v and x (n, k) of v' = a v + b x + kick, x' = p v + s x + shift, rows at the start of every period.

    The law is linear: about sqrt(n) blocks of rows are run side by side, each from zero; then each gets what its first
    row's true state becomes by itself.
    """
    a, b, p, s = law
    n, k = kick.shape
    size = isqrt(n - 1) + 1
    blocks = -(-n // size)
    filled = np.zeros((2, blocks * size, k))
    filled[0, :n], filled[1, :n] = kick, shift
    kicks, shifts = filled.reshape(2, blocks, size, k)
    v, x = np.empty((blocks, size, k)), np.empty((blocks, size, k))
    powers = np.empty((size, 4, k))
    vs = xs = np.zeros((blocks, k))
    vv, vx, xv, xx = np.ones(k), np.zeros(k), np.zeros(k), np.ones(k)
    with np.errstate(over="ignore", invalid="ignore"):  # an unstable law leaves every number
        for j in range(size):
            v[:, j], x[:, j], powers[j] = vs, xs, (vv, vx, xv, xx)
            vs, xs = a * vs + b * xs + kicks[:, j], p * vs + s * xs + shifts[:, j]
            vv, vx, xv, xx = a * vv + b * xv, a * vx + b * xx, p * vv + s * xv, p * vx + s * xx
        begin_v, begin_x = np.empty((blocks, 1, k)), np.empty((blocks, 1, k))
        for i in range(blocks):
            begin_v[i], begin_x[i] = v_0, x_0
            v_0, x_0 = vv * v_0 + vx * x_0 + vs[i], xv * v_0 + xx * x_0 + xs[i]
        by_vv, by_vx, by_xv, by_xx = powers.transpose(1, 0, 2)
        v += by_vv * begin_v + by_vx * begin_x
        x += by_xv * begin_v + by_xx * begin_x
    return v.reshape(-1, k)[:n], x.reshape(-1, k)[:n]


def advance(
    axes: Sequence[Coefficients],
    h: float,
    e: Sequence[float],
    v: Sequence[float],
    F: Sequence[float],
    v_e: Sequence[float],
) -> tuple[list[float], list[float]]:
    """The rates after one period, and the distance moved in it, of all axes from their deviations e."""
    rates, moved = [], []
    for (a, b, c, p, q, r), deviation, rate, force, pace in zip(axes, e, v, F, v_e, strict=True):
        w = rate - pace
        rates.append(pace + a * w + b * deviation + c * force)
        moved.append(h * pace + p * w + q * deviation + r * force)
    return rates, moved


def response_rotation(
    R_e: ArrayLike,
    h: float,
    compliance: Compliance,
    torque: ArrayLike | None = None,
    *,
    integration: Integration = Integration.EULER,
    feed: Feed = Feed.POSITION,
    R_0: ArrayLike | None = None,
    w_0: ArrayLike = (0.0, 0.0, 0.0),
    changes: Sequence[tuple[int, Compliance]] = (),
) -> TurnResponse:
    """What the controller makes of orientations R_e (n, 3, 3), one every h [s]: pose_regulator.SlerpRegulator's law.

    The diagonals are in world axes; changes as of response. torque (n, 3) [Nm], none for None. R_0 (3, 3), w_0 (3,):
    the state at 0, the first orientation at rest by default. feed VELOCITY: w_e = log(R_e,k+1 R_e,k^T) / h, zero after
    the last row.
    """
    R_e = np.asarray(R_e, dtype=np.float64)
    n = len(R_e)
    torques = np.zeros((n, 3)) if torque is None else np.asarray(torque, dtype=np.float64)
    laws = {row: coefficients(law.K[3:], law.D[3:], law.M[3:], h, integration) for row, law in changes}
    axes = coefficients(compliance.K[3:], compliance.D[3:], compliance.M[3:], h, integration)
    goals = [nine(row) for row in R_e.reshape(n, 9).tolist()]
    R = goals[0] if R_0 is None else nine(np.asarray(R_0, dtype=np.float64).reshape(9).tolist())
    w = np.asarray(w_0, dtype=np.float64).tolist()
    rates = [(0.0, 0.0, 0.0)] * n
    if feed is Feed.VELOCITY:
        rates[:-1] = [turn_rate(here, there, h) for here, there in pairwise(goals)]
    Rs, ws = [], []
    for row, (goal, tau, pace) in enumerate(zip(goals, torques.tolist(), rates, strict=True)):
        Rs.append(R)
        ws.append(w)
        axes = laws.get(row, axes)
        w, (x, y, z) = advance(axes, h, logarithm(product(R, transpose(goal))), w, tau, pace)
        R = product(exponential((x, y, z)), R)
    return TurnResponse(readonly(np.array(Rs).reshape(n, 3, 3)), readonly(np.array(ws)))


def turn_rate(here: Nine, there: Nine, h: float) -> Three:
    """The constant angular velocity [rad/s], world axes, that turns here into there in h [s]."""
    x, y, z = logarithm(product(there, transpose(here)))
    return (x / h, y / h, z / h)
