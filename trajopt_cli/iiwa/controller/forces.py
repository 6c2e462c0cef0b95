"""From joint torques to the force on the tool (section 4.1.1), and what of it the controller believes (4.1.6)."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.controller.rotations import rotation
from trajopt_cli.iiwa.task.model import Sensor, Zeroing

SMALLEST = 1e-5
"""Singular value of J under which no force is given: a torque error of 1 Nm would pass for about 1e5 N."""


class SingularArm(ArithmeticError):
    """The arm gives no leverage in some direction; smallest: the Jacobian's smallest singular value there."""

    def __init__(self, smallest: float, row: tuple[int, ...] = ()) -> None:
        self.smallest = smallest
        place = f" in row {', '.join(map(str, row))}" if row else ""
        super().__init__(
            f"the Jacobian's smallest singular value is {smallest:.3g}{place}, under {SMALLEST:g}: the arm is singular "
            "and its joint torques say nothing of a force in one direction; keep the path away from it"
        )


def force_of(J: ArrayLike, tau: ArrayLike) -> Array:
    """F (..., 6) [N, Nm] that the torques tau (..., 7) [Nm] stand for: F = (J J^T)^-1 J tau, J (..., 6, 7).

    Eq. 4.1 with the pseudo-inverse corrected (the thesis prints J^T at its end, whose shape does not fit): the least
    squares solution of J^T F = tau. Not damped: near a singularity errors grow by one over the smallest singular value,
    which clamps bound. Raises SingularArm where that value is under SMALLEST.
    """
    J, tau = np.asarray(J, dtype=np.float64), np.asarray(tau, dtype=np.float64)
    U, sizes, V = np.linalg.svd(J, full_matrices=False)
    smallest = sizes[..., -1]
    if np.any(smallest < SMALLEST):
        row = np.unravel_index(int(np.argmin(smallest)), smallest.shape)
        raise SingularArm(float(np.min(smallest)), tuple(int(i) for i in row))
    return np.asarray((U @ ((V @ tau[..., None]) / sizes[..., None]))[..., 0])


def passing(zeroing: Zeroing) -> Array:
    """The matrix (6, 6) that zeroes: F -> R* S R*^T F for force and moment, S dropping the zeroed components.

    Eqs 4.21-4.22 with the erratum: the frame's axes are the columns of R*, so its components are R*^T F.
    """
    R = np.reshape(rotation(*zeroing.frame.tolist()), (3, 3))
    kept = np.where(zeroing.zeroed, 0.0, 1.0)
    out = np.zeros((6, 6))
    out[:3, :3] = R * kept[:3] @ R.T
    out[3:, 3:] = R * kept[3:] @ R.T
    return out


def zero(F: ArrayLike, zeroing: Zeroing) -> Array:
    """F (..., 6) [N, Nm] without its zeroed components in the zeroing's frame, in world axes again."""
    F = np.asarray(F, dtype=np.float64)
    if not any(zeroing.zeroed):
        return F.copy()
    return np.asarray(F @ passing(zeroing).T)


def clamped(values: Sequence[float], bounds: Sequence[float]) -> list[float]:
    """Values within +-bounds, in plain floats; NaN stays NaN."""
    return [min(max(value, -bound), bound) for value, bound in zip(values, bounds, strict=True)]


class TorqueErrors:
    """Errors [Nm] of seven measured torques at times k h: the same sensor and seed give the same numbers.

    ranges (7,) [Nm]: each sensor's range; its constant error is drawn evenly from +-sensor.bias of it. The ripple has
    the amplitude of the sensor's list on every joint, each with a phase of its own.
    """

    def __init__(self, sensor: Sensor, ranges: ArrayLike, h: float) -> None:
        span = np.asarray(ranges, dtype=np.float64)
        if span.shape != (7,):
            raise ValueError(f"ranges has shape {span.shape}, wanted (7,)")
        rng = np.random.default_rng(sensor.seed)
        self._bias = sensor.bias * span * rng.uniform(-1, 1, 7)
        phases = rng.uniform(0, 2 * pi, (len(sensor.ripple), 7))
        self._waves = [
            (2 * pi * f * h, amplitude, row) for (f, amplitude), row in zip(sensor.ripple, phases, strict=True)
        ]

    def at(self, k: ArrayLike) -> Array:
        """The errors (..., 7) of periods k (...)."""
        out = self._bias
        for turn, amplitude, phases in self._waves:
            out = out + amplitude * np.sin(turn * np.asarray(k)[..., None] + phases)
        return np.broadcast_to(out, (*np.shape(k), 7))
