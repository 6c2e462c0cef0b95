"""A ramped move seen through a servo's lag, in closed form.

A coordinated move goes along the line between two postures; its progress rises from 0 to 1. Driven under limits of
speed, acceleration and jerk, its rate is three boxes folded with one another, T1 >= T2 + T3 long and T2 >= T3: the way
over the top speed, that over the top acceleration, that over the jerk (T3 = 0: the acceleration jumps). Where the top
speed is not reached T1 = T2 + T3, where the top acceleration is not T2 = T3. The servo lags by 1/(1 + b1 s + b2 s^2):
first order for b2 = 0, of damping b1 / (2 sqrt(b2)).
"""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array

LEAST = 1e-4
"""s: a shorter jerk phase cannot be told from none, and would divide by nothing."""
_SIGNS = np.array([1.0, -1, -1, 1, -1, 1, 1, -1])
_TAKEN = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1], [1, 1, 1]], float)
GROWS = np.array([[2.0, 1, 1], [1, 1, 0], [1, 0, 0]])
"""T1, T2, T3 by a jerk phase, the constant acceleration and the cruise."""


def boxes(phases: Array) -> Array:
    """T1, T2, T3 [s] of the durations (..., 3) of a jerk phase, the constant acceleration and the cruise."""
    return np.asarray(phases @ GROWS.T)


def progress(t: Array, phases: Array, b1: float, beta: float) -> Array:
    """Progress (n,) of a move that begins at 0, at times t (n,) [s].

    phases (3,): as in boxes, the first at least LEAST. b1 [s]: the servo's mean delay; beta: b2 / b1^2, 0 for a lag of
    first order.
    """
    T = boxes(phases)
    (cube,) = _lagged(t[None] - (_TAKEN @ T)[:, None], b1, beta, (4,))
    return np.asarray(_SIGNS @ cube / np.prod(T))


def slopes(t: Array, phases: Array, b1: float, beta: float) -> tuple[Array, Array, Array]:
    """The same, its rate (n,) [1/s], and its derivatives (n, 3) by the phases."""
    T = boxes(phases)
    cube, square = _lagged(t[None] - (_TAKEN @ T)[:, None], b1, beta, (4, 3))
    whole = np.prod(T)
    s = _SIGNS @ cube / whole
    by_T = -(_TAKEN * _SIGNS[:, None]).T @ square / whole - s / T[:, None]
    return s, _SIGNS @ square / whole, (GROWS.T @ by_T).T


def _lagged(t: Array, b1: float, beta: float, powers: tuple[int, ...]) -> list[Array]:
    """t^3/6 and, for powers (4, 3) of the poles in place of (4,), t^2/2 from 0 on, behind the lag."""
    t = np.maximum(t, 0.0)
    b2 = beta * b1 * b1
    square = b1 * b1 - 4 * b2
    if square > -1e-8 * b1 * b1:
        root = np.sqrt(max(square, 1e-8 * b1 * b1))  # a double pole as two that nearly meet
        one, other = (b1 + root) / 2, max((b1 - root) / 2, 1e-9)
        first, second = np.exp(-t / one) / root, np.exp(-t / other) / root
        fading = [one**n * first - other**n * second for n in powers]
    else:
        pole = complex(b1, np.sqrt(-square)) / 2
        rate = 1 / pole
        fade, turn = np.exp(-rate.real * t) / pole.imag, -rate.imag * t
        sine, cosine = fade * np.sin(turn), fade * np.cos(turn)
        fading = [(pole**n).real * sine + (pole**n).imag * cosine for n in powers]
    out = [t * (t * (t / 6 - b1 / 2) + (b1 * b1 - b2)) - (b1**3 - 2 * b1 * b2) + fading[0]]
    if len(powers) > 1:
        out.append(t * (t / 2 - b1) + (b1 * b1 - b2) - fading[1])
    return out
