"""The n axes of a plant as the optimiser needs them: limits side by side with the robot's kinematics."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace

import numpy as np

from trajopt_cli.geometry import Array, BoolArray, IndexArray, inverse_pose
from trajopt_cli.limits import Couplings
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import Leg
from trajopt_cli.robot.differential import Differential
from trajopt_cli.robot.layout import AxisLayout
from trajopt_cli.robot.model import RobotModel
from trajopt_cli.settings import Settings


@dataclass(frozen=True, eq=False)
class AxisLimits:
    """Limits in force at m places: of the axes' velocity and acceleration (m, n), of the tool's speed [m/s],
    acceleration [m/s2] and turning [rad/s] (m,), of its speeding up and slowing down along its path [m/s2] (m, 2)."""

    velocity: Array
    acceleration: Array
    v_tcp: Array
    a_tcp: Array
    v_ori: Array
    ramps: Array

    @property
    def along(self) -> bool:
        """Whether the acceleration along the path is limited by itself."""
        return bool(np.any(self.ramps < np.reshape(self.a_tcp, (-1, 1))))

    def at(self, places: IndexArray) -> AxisLimits:
        """Those of some of the places, in any order."""
        return AxisLimits(*(np.take(getattr(self, one.name), places, axis=0) for one in fields(self)))


@dataclass(frozen=True, eq=False)
class Axes:
    """Limits and names (n,) of all axes of a plant in the robot's order. X_WB0: the arm's base in the world with the
    rails at 0; rail_axis (3, r): the rails' directions in the arm's base frame. couplings: ranges of sums of axes. What
    of it motions must keep are `limits_of` the axes."""

    plant: Plant
    robot: RobotModel
    layout: AxisLayout
    names: tuple[str, ...]
    lower: Array
    upper: Array
    velocity: Array
    acceleration: Array
    X_WB0: Array
    rail_axis: Array
    couplings: Couplings

    @classmethod
    def of(cls, plant: Plant) -> Axes:
        """The axes of a plant."""
        limits = plant.limits
        robot = plant.robot
        X_WB0 = robot.X_WB0
        axis = X_WB0[:3, :3].T @ robot.rail_axes_W.T
        return cls(
            plant, robot, robot.layout, limits.names, limits.lower, limits.upper, limits.velocity, limits.acceleration,
            X_WB0, axis, limits.couplings,
        )  # fmt: skip

    @property
    def n(self) -> int:
        """How many axes."""
        return self.layout.n

    @property
    def settings(self) -> Settings:
        """Chosen numbers."""
        return self.plant.settings

    @property
    def usual_acceleration(self) -> Array:
        """What (n,) most postures allow: for estimates; `acceleration` is what every posture does."""
        return self.plant.limits.usual_acceleration

    @property
    def in_closed_form(self) -> bool:
        """Whether joint moves are: no limit of jerk, and none of acceleration that changes with the posture."""
        return self.jerk is None and self.plant.limits.table is None

    @property
    def jerk(self) -> Array | None:
        """Limits (n,), None where jerks are free."""
        return self.plant.limits.binding_jerk

    def within(self, q: Array, slack: float = 1e-9) -> BoolArray:
        """Whether axes (..., n) are in their ranges (...), those of sums too, but for a slack [rad, m]; NaN are not."""
        with np.errstate(invalid="ignore"):
            each = np.all((q >= self.lower - slack) & (q <= self.upper + slack), axis=-1)
        return np.asarray(each & self.couplings.within(q, slack))

    def narrowed(self, room: float) -> Axes:
        """The same axes with a share of the room that their ranges leave on either side of the middle."""
        middle, half = (self.upper + self.lower) / 2, (self.upper - self.lower) / 2
        c = self.couplings
        centre, width = (c.upper + c.lower) / 2, (c.upper - c.lower) / 2
        narrower = Couplings(c.rows, centre - room * width, centre + room * width)
        return replace(self, lower=middle - room * half, upper=middle + room * half, couplings=narrower)

    def velocity_on(self, leg: Leg) -> Array:
        """Velocity limits (n,) on a leg: the rail's is capped by the program as well."""
        V = self.velocity.copy()
        V[self.layout.rail] = np.minimum(V[self.layout.rail], leg.v_rail)
        return V

    def acceleration_on(self, leg: Leg) -> Array:
        """Acceleration limits (n,) on a leg: the program may ask for a share of them."""
        return self.acceleration * leg.acceleration

    def caps(self, legs: Sequence[Leg]) -> AxisLimits:
        """The limits on each leg."""
        velocity, acceleration = ([of(leg) for leg in legs] for of in (self.velocity_on, self.acceleration_on))
        v_tcp, a_tcp, v_ori = np.array([(leg.v_tcp, leg.a_tcp, leg.v_ori) for leg in legs]).T
        ramps = np.array([leg.ramps for leg in legs])
        return AxisLimits(np.array(velocity), np.array(acceleration), v_tcp, a_tcp, v_ori, ramps)

    def in_base(self, X_W: Array) -> Array:
        """A world pose seen from the arm's base with the rail at 0."""
        return inverse_pose(self.X_WB0) @ X_W

    def inverse(self, X_WF: Array, rail: Array) -> Array:
        """Joints (k, b, m) of all branches for flange poses (k, 4, 4) at rail positions (k, r), or (k,) of the sought
        one, the others at 0."""
        return self.robot.branches(X_WF, self._rails(rail))

    def branch(self, X_WF: Array, rail: Array, cfx: IndexArray | int) -> Array:
        """Joints (k, m) of one branch each, cfx (k,), or the same one."""
        return self.robot.branch(X_WF, self._rails(rail), cfx)

    def _rails(self, rail: Array) -> Array:
        r = self.layout.r
        return rail[:, None] * (np.arange(r) == self.layout.sought) if r > 1 and rail.ndim == 1 else rail

    def seeking(self, i: int) -> Axes:
        """The same where rail number i is sought while the others are held."""
        return replace(self, layout=self.layout.seeking(i))

    def forward(self, q: Array) -> Array:
        """Flange poses (..., 4, 4) of axes (..., n)."""
        return self.robot.forward(q)

    def tool_points(self, q: Array, X_FT: Array) -> Array:
        """The tool centre point (..., 3) of axes (..., n)."""
        return self.differential(q, X_FT).pose()[..., :3, 3]

    def jacobian(self, q: Array, X_FT: Array) -> Array:
        """Geometric Jacobian (..., 6, n) at the TCP, world axes."""
        return self.robot.jacobian(q, X_FT)

    def differential(self, q: Array, X_FT: Array) -> Differential:
        """That and how the TCP's velocity and acceleration follow from those of the axes."""
        return self.robot.differential(q, X_FT)

    def self_motion(self, q: Array) -> Array:
        """Arm rates (..., joints, r) per rail velocity with the flange at rest."""
        J = self.jacobian(q, np.eye(4))
        return np.asarray(-np.linalg.solve(J[..., self.layout.arm], J[..., self.layout.rail]))
