"""The law of the compliant controller, eqs 4.10-4.16: six decoupled masses on springs and dampers.

Per axis, with the deviation e = x - x_e and the rate w = v - v_e (v_e = 0 when only positions are fed, eq. 4.15):

    v' = v_e + a w + b e + c F        x' = x + h v_e + p w + q e + r F

Forward Euler is a = 1 - h d/m, b = -h k/m, c = h/m, p = h, q = r = 0 (eqs 4.13-4.14): the new position takes the old
speed. The exact law puts the solution of m w' + d w + k e = F over one period there, F held.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise, zip_longest
from operator import add, sub

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array, readonly
from trajopt_cli.iiwa.controller.parameters import Goal
from trajopt_cli.iiwa.controller.rotations import (
    Nine,
    Three,
    angle_rates,
    angles,
    exponential,
    logarithm,
    nine,
    rotation,
    spin,
    transpose,
)
from trajopt_cli.iiwa.task.model import Compliance, Feed, Integration, RotationLaw
from trajopt_cli.iiwa.task.world import Six
from trajopt_cli.robot.srs_step import product

Coefficients = tuple[float, float, float, float, float, float]

_STILL: Six = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@dataclass(frozen=True, eq=False)
class Response:
    """State over time: row k is x (n, 6) [m, rad] and v (n, 6) [m/s, rad/s] at time k h.

    R (n, 3, 3): the orientations where the law goes by them; v then ends with the angular velocity, and the angles of x
    count from the first. None where it goes by angles.
    """

    x: Array
    v: Array
    R: Array | None = None


class Regulator:
    """The law one period at a time, in plain floats, at rest at a pose R, p [m] that becomes the start.

    TAIT_BRYAN: each of three angles from R_start is an axis, R = Rz Ry Rx R_start. SLERP: there is no gimbal lock; the
    deviation of the rotation is phi = log(R R_e^T), a rotation vector in world axes, in place of the angles'
    differences: w' = w + h/m (tau - d w - k phi), R' = exp(h w) R, or the exact law on phi. Its angles are only
    written, and count on from row to row.

    x (6,): position [m] and angles [rad] from R_start; v (6,): their rates, or velocity and angular velocity (SLERP);
    R: the orientation in the world.
    """

    def __init__(
        self,
        compliance: Compliance,
        h: float,
        R: Nine,
        p: Three,
        rotation: RotationLaw = RotationLaw.TAIT_BRYAN,
        integration: Integration = Integration.EULER,
        feed: Feed = Feed.POSITION,
    ) -> None:
        self.x: Six = (*p, 0.0, 0.0, 0.0)
        self.v, self.R, self.R_start = _STILL, R, R
        self._h, self._integration, self._feeds_speed = h, integration, feed is Feed.VELOCITY
        self._slerp = rotation is RotationLaw.SLERP
        self.set(compliance)

    def set(self, compliance: Compliance) -> None:
        """Stiffness, damping and inertia from now on; the state stays."""
        self._axes = coefficients(compliance.K, compliance.D, compliance.M, self._h, self._integration)

    @property
    def twist(self) -> tuple[Three, Three]:
        """Velocity [m/s] and angular velocity [rad/s] of the TCP in world axes."""
        return self.v[:3], self.v[3:] if self._slerp else spin(self.x[3:], self.v[3:])

    def put(self, pose: tuple[Nine, Three], twist: tuple[Three, Three], R_start: Nine, near: Three) -> None:
        """The same state seen from other frames, its angles nearest to near."""
        (self.R, p), (v, w), self.R_start = pose, twist, R_start
        at = angles(product(self.R, transpose(R_start)), near)
        self.x, self.v = (*p, *at), (*v, *(w if self._slerp else angle_rates(at, w)))

    def step(self, goal: Goal, F: Six, following: Goal | None = None) -> None:
        """One period with this equilibrium and force; following: the next row, None at the end.

        Raises ValueError for a goal without its orientation where the law goes by them.
        """
        h, v_e, rates, moved = self._h, _STILL, [], []
        if self._feeds_speed and following is not None:
            a, b, c, d, e, f = self._off(following.x, following.R, goal)
            v_e = (a / h, b / h, c / h, d / h, e / h, f / h)
        off = self._off(self.x, self.R, goal)
        for (a, b, c, p, q, r), deviation, rate, force, pace in zip(self._axes, off, self.v, F, v_e, strict=True):
            w = rate - pace
            rates.append(pace + a * w + b * deviation + c * force)
            moved.append(h * pace + p * w + q * deviation + r * force)
        a, b, c, d, e, f = rates
        self.v = (a, b, c, d, e, f)
        a, b, c, d, e, f = map(add, self.x, moved)
        if self._slerp:
            self.R = product(exponential((moved[3], moved[4], moved[5])), self.R)
            d, e, f = angles(product(self.R, transpose(self.R_start)), self.x[3:])
        else:
            self.R = product(rotation(d, e, f), self.R_start)
        self.x = (a, b, c, d, e, f)

    def _off(self, x: Six, R: Nine | None, goal: Goal) -> Six:
        """How far a pose is from an equilibrium, by axis."""
        a, b, c, d, e, f = map(sub, x, goal.x)
        if self._slerp:
            if R is None or goal.R is None:
                raise ValueError("slerp: the equilibrium's row has no orientation R in the world")
            d, e, f = logarithm(product(R, transpose(goal.R)))
        return (a, b, c, d, e, f)


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
    R_e: ArrayLike | None = None,
    integration: Integration = Integration.EULER,
    feed: Feed = Feed.POSITION,
    force: ArrayLike | None = None,
    x_0: ArrayLike | None = None,
    v_0: ArrayLike | None = None,
    R_0: ArrayLike | None = None,
    changes: Sequence[tuple[int, Compliance]] = (),
) -> Response:
    """What the controller makes of an equilibrium x_e (n, 6) [m, rad], one row every h [s], angles as numbers.

    R_e (n, 3, 3): orientations that the law goes by in place of angles, the diagonals in their axes. force (n, 6)
    [N, Nm]: external force, none for None. Row k is the state at k h; equilibrium and force of row k act from k h to
    (k + 1) h. x_0, v_0 (6,), R_0 (3, 3): the state at 0, the first row at rest for None. feed VELOCITY: the
    equilibrium also moves on with v_e = (x_e,k+1 - x_e,k) / h, zero after its last row. changes: rows, in order, from
    which on another compliance holds.
    """
    x_e = np.asarray(x_e, dtype=np.float64)
    start = x_e[0] if x_0 is None else np.asarray(x_0, dtype=np.float64)
    rate = np.zeros(6) if v_0 is None else np.asarray(v_0, dtype=np.float64)
    pushes = np.zeros_like(x_e) if force is None else np.asarray(force, dtype=np.float64)
    if R_e is not None:
        R = np.asarray(R_e, dtype=np.float64).reshape(-1, 9)
        begin = nine((R[0] if R_0 is None else np.asarray(R_0, dtype=np.float64).ravel()).tolist())
        one = Regulator(compliance, h, begin, tuple(start[:3].tolist()), RotationLaw.SLERP, integration, feed)
        one.v, changed, states = tuple(rate.tolist()), dict(changes), []
        goals = [Goal(tuple(row), nine(turn)) for row, turn in zip(x_e.tolist(), R.tolist(), strict=True)]
        for k, (goal, F, following) in enumerate(zip_longest(goals, pushes.tolist(), goals[1:])):
            if k in changed:
                one.set(changed[k])
            states.append((*one.x, *one.v, *one.R))
            one.step(goal, F, following)
        x, v, R = np.split(readonly(np.array(states)), (6, 12), axis=1)
        return Response(x, v, R.reshape(-1, 3, 3))
    v_e = equilibrium_rates(x_e, h) if feed is Feed.VELOCITY else np.zeros_like(x_e)
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

    What all rows together have to be, v_0, x_0, v_1, x_1, ..., is a triangular band of equations.
    """
    from scipy.linalg.lapack import dtbtrs

    n, k = kick.shape
    v, x = np.empty((2, n, k))
    for i, (a, b, p, s) in enumerate(zip(*law, strict=True)):
        band, known = np.zeros((4, 2 * n)), np.empty(2 * n)  # band[d, j]: of column j, d below the diagonal
        band[2:, 0::2], band[1:3, 1::2] = [[-a], [-p]], [[-b], [-s]]
        known[:2], known[2::2], known[3::2] = (v_0[i], x_0[i]), kick[:-1, i], shift[:-1, i]
        v[:, i], x[:, i] = dtbtrs(band, known[:, None], uplo="L", diag="U")[0].reshape(n, 2).T
    return v, x
