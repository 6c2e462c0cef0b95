"""What the axes and the tool centre point may do."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from trajopt_cli.geometry import Array, readonly

_NEAREST_ROWS = 1e-5  # s: no rows of the files written here are nearer to each other


@dataclass(frozen=True, eq=False)
class JointLimits:
    """Limits of all axes in the robot's order (rail first), rad or m: position, speed [1/s], acceleration [1/s2].

    jerk [1/s3]: None where the robot's profile gives none; jerk_binds: every motion keeps it, not those alone that are
    made with it.
    sources maps "joint_3.acceleration" to where the number comes from and its grade in words; grades to the grade, A to
    D, of a number of the robot's own files.
    """

    names: tuple[str, ...]
    lower: Array
    upper: Array
    velocity: Array
    acceleration: Array
    sources: Mapping[str, str] = field(default_factory=dict)
    jerk: Array | None = None
    grades: Mapping[str, str] = field(default_factory=dict)
    jerk_binds: bool = False

    @property
    def binding_jerk(self) -> Array | None:
        """The jerk limits where every motion keeps them; None also for limits so high that no rows of a file could show
        whether they are kept: the acceleration may turn round from one row to the next."""
        if not self.jerk_binds or self.jerk is None:
            return None
        return None if np.all(self.jerk * _NEAREST_ROWS >= 2 * self.acceleration) else self.jerk

    def __post_init__(self) -> None:
        for name in ("lower", "upper", "velocity", "acceleration", "jerk"):
            if getattr(self, name) is None:
                continue
            values = readonly(getattr(self, name))
            if values.shape != (len(self.names),):
                raise ValueError(f"JointLimits.{name} has shape {values.shape}, wanted ({len(self.names)},)")
            object.__setattr__(self, name, values)
        if not np.all(self.lower < self.upper):
            raise ValueError("JointLimits: every lower limit must lie under its upper limit")
        if not (np.all(self.velocity > 0) and np.all(self.acceleration > 0)):
            raise ValueError("JointLimits: speeds and accelerations must be positive")
        if self.jerk is not None and not np.all(self.jerk > 0):
            raise ValueError("JointLimits: jerks must be positive")
        if self.jerk_binds and self.jerk is None:
            raise ValueError("JointLimits: jerks that bind must be given")


@dataclass(frozen=True)
class TcpCaps:
    """Caps on the tool centre point's speed [m/s] and acceleration [m/s2] in the world, on every motion."""

    speed: float
    acceleration: float
