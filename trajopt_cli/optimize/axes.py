"""The n axes of a plant as the optimiser needs them: limits side by side with the robot's kinematics."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import Leg
from trajopt_cli.robot.layout import AxisLayout
from trajopt_cli.robot.protocol import Robot


@dataclass(frozen=True, eq=False)
class Axes:
    """Limits and names (n,) of all axes in the robot's order. X_WB0: the arm's base in the world with the rail at 0;
    rail_axis (3, r): the rail's direction in the arm's base frame."""

    robot: Robot
    layout: AxisLayout
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
        limits = plant.limits
        robot: Robot = plant.robot
        X_WB0 = robot.X_WB0
        axis = np.zeros((3, 0)) if robot.rail_axis_W is None else X_WB0[:3, :3].T @ robot.rail_axis_W[:, None]
        return cls(
            robot, robot.layout, limits.names, limits.lower, limits.upper, limits.velocity, limits.acceleration, X_WB0,
            axis,
        )  # fmt: skip

    @property
    def n(self) -> int:
        """How many axes."""
        return self.layout.n

    def velocity_on(self, leg: Leg) -> Array:
        """Velocity limits (n,) on a leg: the rail's is capped by the program as well."""
        V = self.velocity.copy()
        V[self.layout.rail] = np.minimum(V[self.layout.rail], leg.v_rail)
        return V

    def in_base(self, X_W: Array) -> Array:
        """A world pose seen from the arm's base with the rail at 0."""
        return inverse_pose(self.X_WB0) @ X_W

    def inverse(self, X_WF: Array, rail: Array) -> Array:
        """Joints (k, b, m) of all branches for flange poses (k, 4, 4) at rail positions (k,)."""
        return self.robot.branches(X_WF, rail)

    def forward(self, q: Array) -> Array:
        """Flange poses (..., 4, 4) of axes (..., n)."""
        return self.robot.forward(q)

    def jacobian(self, q: Array, X_FT: Array) -> Array:
        """Geometric Jacobian (..., 6, n) at the TCP, world axes."""
        return self.robot.jacobian(q, X_FT)

    def jacobian_rate(self, q: Array, qd: Array, X_FT: Array) -> Array:
        """Its time derivative (..., 6, n)."""
        return self.robot.jacobian_rate(q, qd, X_FT)

    def self_motion(self, q: Array) -> Array:
        """Arm rates (..., joints, r) per rail velocity with the flange at rest."""
        J = self.jacobian(q, np.eye(4))
        return np.asarray(-np.linalg.solve(J[..., self.layout.arm], J[..., self.layout.rail]))
