"""Worlds that the controller runs in: an arm that follows every command exactly, against springs; MuJoCo's physics."""

from __future__ import annotations

from enum import Enum

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.model import Contact
from trajopt_cli.iiwa.task.world import LinkContact, Measured, Motor, Seven, World, seven
from trajopt_cli.iiwa.world.contact import APART, BallOnBoxes, Touch, depths
from trajopt_cli.iiwa.world.mujoco_world import MujocoWorld
from trajopt_cli.robot.dynamics import Dynamics, ToolLoad
from trajopt_cli.robot.srs import SrsRobot
from trajopt_cli.robot.srs_inverse import ArmAngle
from trajopt_cli.robot.srs_step import Jacobian, SrsStep

EVERY = 10
"""Of so many periods one is sampled for links: one at 1 m/s goes 10 mm in between with periods of 1 ms."""


class SpringWorld:
    """The ideal arm robot with a tool at X_FT (4, 4) and its load; contact is what the tip may run into, None nothing.

    At a period's end the joints are where the command put them; their speeds and accelerations are the differences of
    the last two and three positions over h [s]. The force on the tip is that of BallOnBoxes there, and the torques
    tau = (inverse dynamics of q, qd, qdd) - J^T F: a force on the tool is borne by the motors and moves nothing. What
    stays unseen beside MuJoCo are the servo's lag and the arm's own give, which limits how hard a hit is:
    a controller of stiffness K and damping D that steps by forward Euler rests on a wall without chattering only while
    h (K + stiffness) < D + damping. Links that are in an obstacle are reported, but not pushed back.
    """

    def __init__(self, robot: SrsRobot, X_FT: Array, load: ToolLoad | None, contact: Contact | None, h: float) -> None:
        self._h = h
        self._dynamics = Dynamics(robot, load)
        # The inverse is not asked, so that any configuration and arm angle will do.
        self._arm = SrsStep(robot, ArmAngle.FARIA, 0, 0.0, X_FT)
        self._boxes = BallOnBoxes(contact) if contact is not None else None
        self._robot, self._contact = robot, contact
        self._path: list[Seven] = []
        self._q: Seven = (0.0,) * 7
        self._qd: Seven = (0.0,) * 7

    @property
    def name(self) -> str:
        """The ideal arm."""
        return "spring wall" if self._boxes is not None else "ideal arm"

    @property
    def link_contacts(self) -> tuple[LinkContact, ...]:
        """Which links were in which obstacles since the reset: capsules of all links that move and the tool's body, not
        pushed back.

        Of EVERY periods one is sampled, and the last.
        """
        if self._contact is None or not self._path:
            return ()
        count, found = len(self._path), list[LinkContact]()
        rows = sorted({*range(0, count, EVERY), count - 1})
        for name, obstacle, depth in depths(self._robot, np.array(self._path)[rows], self._contact):
            inside = [i for i, deep in enumerate(depth.tolist()) if deep > 0]
            if inside:
                first, last = (rows[i] * self._h for i in (inside[0], inside[-1]))
                found.append(LinkContact(name, obstacle, first, last, float(depth.max()), None))
        return tuple(sorted(found, key=lambda one: one.first))

    @property
    def motors(self) -> tuple[Motor, ...]:
        """None: the arm is where it is told to be."""
        return ()

    def reset(self, q: Seven) -> Measured:
        """Stand still at q [rad] (7,)."""
        still: Seven = (0.0,) * 7
        self._path = []
        return self._measure(seven(q), still, still)

    def step(self, q: Seven) -> Measured:
        """Be at the command q [rad] (7,) one period later, after a reset."""
        q, h = seven(q), self._h
        qd = seven((new - old) / h for new, old in zip(q, self._q, strict=True))
        qdd = seven((new - old) / h for new, old in zip(qd, self._qd, strict=True))
        return self._measure(q, qd, qdd)

    def _measure(self, q: Seven, qd: Seven, qdd: Seven) -> Measured:
        self._q, self._qd = q, qd
        if self._contact is not None:
            self._path.append(q)
        tau = self._dynamics.torque(*np.array((q, qd, qdd))).tolist()
        touch = APART
        if self._boxes is not None:
            _, p = self._arm.forward(q)
            if self._boxes.overlap(p):
                J = self._arm.jacobian(q)
                vx, vy, vz, wx, wy, wz = (sum(a * b for a, b in zip(row, qd, strict=True)) for row in J)
                touch = self._boxes.touch(p, (vx, vy, vz), (wx, wy, wz))
                tau = _less(tau, J, touch)
        return Measured(q, qd, qdd, seven(tau), touch.force, touch.depth)


def _less(tau: list[float], J: Jacobian, touch: Touch) -> list[float]:
    """tau - J^T F."""
    columns = zip(*J, strict=True)
    return [
        motor - sum(a * f for a, f in zip(column, touch.force, strict=True))
        for motor, column in zip(tau, columns, strict=True)
    ]


class Engine(Enum):
    """What moves the arm and answers its tip: exact following against springs, or MuJoCo's physics."""

    SPRING = "spring"
    MUJOCO = "mujoco"


def make_world(
    engine: Engine, robot: SrsRobot, X_FT: Array, load: ToolLoad | None, contact: Contact | None, h: float
) -> World:
    """The world of an arm mounted in its place, with its TCP at X_FT (4, 4) in the flange frame and its tool's load.

    contact: what the tip may run into, None for free motion. h: the controller's period [s]. Raises InputError where
    MuJoCo is asked for and cannot be imported, ValueError for contacts too hard for its time steps.
    """
    made: type[SpringWorld] | type[MujocoWorld] = SpringWorld if engine is Engine.SPRING else MujocoWorld
    return made(robot, X_FT, load, contact, h)
