"""Seven axes inside the optimiser, whatever the cell: rail first, a rail that cannot move where there is none."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.inverse import inverse
from trajopt_cli.robot.model import RobotModel


@dataclass(frozen=True, eq=False)
class Axes:
    """Limits (7,) of rail and arm; names (7,); rail_axis (3,): the rail's direction in the arm's base frame.

    X_WB0: arm base in the world at rail 0.
    """

    robot: RobotModel
    names: tuple[str, ...]
    lower: Array
    upper: Array
    velocity: Array
    acceleration: Array
    X_WB0: Array
    rail_axis: Array

    @classmethod
    def of(cls, plant: Plant) -> Axes:
        """The axes of a plant."""
        limits, robot = plant.limits, plant.robot
        pad = [] if robot.has_rail else [0.0]
        X_WB0 = robot.base(np.array(0.0))
        rail_axis = np.zeros(3)
        if robot.has_rail:
            rail_axis = X_WB0[:3, :3].T @ (robot.base(np.array(1.0))[:3, 3] - X_WB0[:3, 3])
        return cls(
            robot,
            limits.names if robot.has_rail else ("rail", *limits.names),
            np.r_[pad, limits.lower],
            np.r_[pad, limits.upper],
            np.r_[[1.0] if pad else [], limits.velocity],
            np.r_[[1.0] if pad else [], limits.acceleration],
            X_WB0,
            rail_axis,
        )

    @property
    def has_rail(self) -> bool:
        """Whether axis 0 is a real one."""
        return self.robot.has_rail

    def plant_axes(self, q: Array) -> Array:
        """(..., k) of the plant from (..., 7)."""
        return q if self.has_rail else q[..., 1:]

    def seven(self, q: Array) -> Array:
        """(..., 7) from (..., k) of the plant."""
        return q if self.has_rail else np.concatenate([np.zeros((*q.shape[:-1], 1)), q], axis=-1)

    def in_base(self, X_W: Array) -> Array:
        """A world pose seen from the arm's base at rail 0."""
        return inverse_pose(self.X_WB0) @ X_W

    def inverse(self, X_WF: Array, rail: Array) -> Array:
        """All branches (n, 8, 6) of flange poses (n, 4, 4) at rail positions (n,)."""
        return inverse(self.robot, X_WF, rail if self.has_rail else None)

    def forward(self, q: Array) -> Array:
        """Flange poses (..., 4, 4) of axes (..., 7)."""
        return self.robot.forward(self.plant_axes(q))

    def jacobian(self, q: Array, X_FT: Array) -> Array:
        """Geometric Jacobian (..., 6, 7) at the TCP, world axes."""
        J = self.robot.jacobian(self.plant_axes(q), X_FT)
        return J if self.has_rail else np.concatenate([np.zeros((*J.shape[:-1], 1)), J], axis=-1)

    def jacobian_rate(self, q: Array, qd: Array, X_FT: Array) -> Array:
        """Its time derivative (..., 6, 7)."""
        J = self.robot.jacobian_rate(self.plant_axes(q), self.plant_axes(qd), X_FT)
        return J if self.has_rail else np.concatenate([np.zeros((*J.shape[:-1], 1)), J], axis=-1)
