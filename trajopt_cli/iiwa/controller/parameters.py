"""What the controller is set to, what it answers with, and why its loop stops."""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from enum import Enum
from typing import NamedTuple

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.controller.rotations import Nine
from trajopt_cli.iiwa.task.model import (
    Change,
    Clamps,
    Compliance,
    Feed,
    Integration,
    Push,
    PushLog,
    RotationLaw,
    Sensor,
    Task,
    Zeroing,
)
from trajopt_cli.iiwa.task.world import Seven, Six
from trajopt_cli.robot.dynamics import ToolLoad
from trajopt_cli.robot.srs_inverse import ArmAngle


@dataclass(frozen=True, eq=False)
class Settings:
    """The controller of scheme 4.1, period h [s].

    definition, arm_angle [rad]: the elbow; None for the angle at the start. X_FT (4, 4): the TCP in the flange frame.
    load: what the torque model knows of the tool. sensor: errors of the measured torques, None for none. changes and
    pushes: what happens during the run, times counted from the start.
    """

    compliance: Compliance
    h: float
    definition: ArmAngle
    arm_angle: float | None = None
    X_FT: Array = field(default_factory=lambda: np.eye(4))
    load: ToolLoad | None = None
    zeroing: Zeroing = field(default_factory=Zeroing)
    clamps: Clamps = field(default_factory=Clamps)
    sensor: Sensor | None = None
    changes: tuple[Change, ...] = ()
    pushes: tuple[Push | PushLog, ...] = ()
    integration: Integration = Integration.EULER
    feed: Feed = Feed.POSITION
    rotation: RotationLaw = RotationLaw.TAIT_BRYAN

    @classmethod
    def of(cls, task: Task, feed: Feed = Feed.POSITION) -> Settings:
        """The controller a task asks for."""
        own = {one.name: getattr(task, one.name) for one in fields(cls) if hasattr(task, one.name)}
        return cls(**own, h=task.route.h, feed=feed, rotation=task.route.rotation)


class Goal(NamedTuple):
    """One row of the equilibrium: x (6,) [m, rad], angles from R_start; R in the world, which slerp goes by; wrench:
    what the tool is told to press with besides (6,) [N, Nm], world axes."""

    x: Six
    R: Nine | None = None
    wrench: Six = (0.0,) * 6


class Command(NamedTuple):
    """One period's answer: joints q [rad] of the regulator's new pose; torque [Nm] where the motors are told that, q
    then being the joints as they are."""

    q: Seven
    torque: Seven | None = None


class StopKind(Enum):
    """What ends the loop: a command beyond a joint's range or speed, a pose out of reach, the angles' lock, an arm
    whose torques say nothing of a force, torques that are no numbers."""

    POSITION = "position"
    SPEED = "speed"
    UNREACHABLE = "unreachable"
    BETA = "beta"
    SINGULAR = "singular"
    TORQUE = "torque"


@dataclass(frozen=True)
class Stop:
    """Why the loop stopped: the command for time [s] was not sent. subject: joint or axis; value and limit in unit."""

    time: float
    kind: StopKind
    subject: str
    value: float
    limit: float
    unit: str
    message: str
