"""What the joint torque sensors add to the truth: a constant error and the ripple of the robot's cabinet."""

from __future__ import annotations

from math import pi

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.model import Sensor


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
