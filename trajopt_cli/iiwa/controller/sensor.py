"""What the joint torque sensors add to the truth: a constant error and the ripple of the robot's cabinet."""

from __future__ import annotations

from math import pi, sin

import numpy as np
from numpy.typing import ArrayLike

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.model import Sensor
from trajopt_cli.iiwa.task.world import Seven


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
        self.bias: tuple[float, ...] = tuple((sensor.bias * span * rng.uniform(-1, 1, 7)).tolist())
        phases = rng.uniform(0, 2 * pi, (len(sensor.ripple), 7)).tolist()
        self._waves = [
            (2 * pi * frequency * h, amplitude, tuple(row))
            for (frequency, amplitude), row in zip(sensor.ripple, phases, strict=True)
        ]

    def at(self, k: int) -> Seven:
        """The errors of period k."""
        a, b, c, d, e, f, g = self.bias
        for turn, amplitude, (p0, p1, p2, p3, p4, p5, p6) in self._waves:
            angle = turn * k
            a += amplitude * sin(angle + p0)
            b += amplitude * sin(angle + p1)
            c += amplitude * sin(angle + p2)
            d += amplitude * sin(angle + p3)
            e += amplitude * sin(angle + p4)
            f += amplitude * sin(angle + p5)
            g += amplitude * sin(angle + p6)
        return (a, b, c, d, e, f, g)

    def rows(self, n: int) -> Array:
        """The errors (n, 7) of the first n periods."""
        k = np.arange(n)[:, None]
        out = np.tile(np.array(self.bias), (n, 1))
        for turn, amplitude, phases in self._waves:
            out += amplitude * np.sin(turn * k + np.array(phases))
        return out
