"""What motions must keep, a limit per file: each answers the engines through one protocol, see `limit.py`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.trajectories.limits.joint_acceleration import JointAcceleration
from trajopt_cli.trajectories.limits.joint_jerk import JointJerk
from trajopt_cli.trajectories.limits.joint_range import JointRange
from trajopt_cli.trajectories.limits.joint_torque import JointTorque
from trajopt_cli.trajectories.limits.joint_velocity import JointVelocity
from trajopt_cli.trajectories.limits.limit import Limit
from trajopt_cli.trajectories.limits.positioner_rate import PositionerRate
from trajopt_cli.trajectories.limits.tcp_motion import TcpMotion

if TYPE_CHECKING:
    from trajopt_cli.trajectories.axes import Axes


def limits_of(axes: Axes) -> tuple[Limit, ...]:
    """The limits in force on a plant's axes."""
    kinds: list[type[Limit]] = [JointVelocity, JointAcceleration, TcpMotion]
    kinds += [JointTorque] if axes.torque is not None else []
    kinds += [PositionerRate]
    kinds += [JointJerk] if axes.jerk is not None else []
    kinds += [JointRange]
    return tuple(kind(axes) for kind in kinds)
