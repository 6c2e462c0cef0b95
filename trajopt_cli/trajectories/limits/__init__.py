"""What motions must keep, a limit per file: each answers the engines through one protocol, see `limit.py`."""

from __future__ import annotations

from functools import lru_cache

from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.limits.joint_acceleration import JointAcceleration
from trajopt_cli.trajectories.limits.joint_jerk import JointJerk
from trajopt_cli.trajectories.limits.joint_range import JointRange
from trajopt_cli.trajectories.limits.joint_torque import JointTorque
from trajopt_cli.trajectories.limits.joint_velocity import JointVelocity
from trajopt_cli.trajectories.limits.limit import Limit
from trajopt_cli.trajectories.limits.positioner_rate import PositionerRate
from trajopt_cli.trajectories.limits.tool_limit import ToolLimit

KINDS: tuple[type[Limit], ...] = (
    JointVelocity, JointAcceleration, ToolLimit, JointTorque, PositionerRate, JointJerk, JointRange,
)  # fmt: skip
"""All there are, in the order of reports and of rows."""


@lru_cache(maxsize=16)
def limits_of(axes: Axes) -> tuple[Limit, ...]:
    """The limits in force on a plant's axes."""
    return tuple(kind(axes) for kind in KINDS if kind.in_force(axes))
