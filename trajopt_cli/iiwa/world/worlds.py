"""Which world the controller runs in."""

from __future__ import annotations

from enum import Enum

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.model import Contact
from trajopt_cli.iiwa.task.world import TrackedWorld
from trajopt_cli.iiwa.world.mujoco_world import MujocoWorld, Pushes, TorqueWorld
from trajopt_cli.iiwa.world.spring_wall import SpringWorld
from trajopt_cli.robot.dynamics import ToolLoad
from trajopt_cli.robot.srs import SrsRobot


class Engine(Enum):
    """What moves the arm and answers its tip: exact following against springs, or MuJoCo's physics."""

    SPRING = "spring"
    MUJOCO = "mujoco"


def make_world(
    engine: Engine, robot: SrsRobot, X_FT: Array, load: ToolLoad | None, contact: Contact | None, h: float
) -> TrackedWorld:
    """The world of an arm mounted in its place, with its TCP at X_FT (4, 4) in the flange frame and its tool's load.

    contact: what the tip may run into, None for free motion. h: the controller's period [s]. Raises InputError where
    MuJoCo is asked for and cannot be imported, ValueError for contacts too hard for its time steps.
    """
    match engine:
        case Engine.SPRING:
            return SpringWorld(robot, X_FT, load, contact, h)
        case Engine.MUJOCO:
            return MujocoWorld(robot, X_FT, load, contact, h)


def torque_world(
    robot: SrsRobot, X_FT: Array, load: ToolLoad | None, contact: Contact | None, h: float, pushes: Pushes
) -> TrackedWorld:
    """As make_world, of an arm whose motors take torques and whose tool is pushed; MuJoCo's."""
    return TorqueWorld(robot, X_FT, load, contact, h, pushes)
