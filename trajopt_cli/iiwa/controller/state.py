"""The regulator's pose as the loop sees it: by three angles from R_start (eq. 4.18), or as an orientation (slerp)."""

from __future__ import annotations

from typing import Protocol

from trajopt_cli.iiwa.controller.parameters import Goal, Settings
from trajopt_cli.iiwa.controller.regulator import Regulator, SlerpRegulator, turn_rate
from trajopt_cli.iiwa.controller.rotations import Nine, Three, angle_rates, angles, product, rotation, spin, transpose
from trajopt_cli.iiwa.task.model import Compliance, Feed, RotationLaw
from trajopt_cli.iiwa.task.world import Six


class PoseState(Protocol):
    """A regulator in the world's frame, started at some R_start."""

    R_start: Nine

    @property
    def x(self) -> Six:
        """Position [m] and angles [rad] from R_start."""
        ...

    @property
    def v(self) -> Six:
        """Rates [m/s, rad/s]: of the angles, or the angular velocity where the law is slerp."""
        ...

    @property
    def pose(self) -> tuple[Nine, Three]:
        """Orientation and position [m] of the TCP in the world."""
        ...

    @property
    def twist(self) -> tuple[Three, Three]:
        """Velocity [m/s] and angular velocity [rad/s] of the TCP in world axes."""
        ...

    def set(self, compliance: Compliance) -> None:
        """Other numbers from now on; the state stays."""
        ...

    def put(self, pose: tuple[Nine, Three], twist: tuple[Three, Three], R_start: Nine, near: Three) -> None:
        """The same state seen from other frames, its angles nearest to near."""
        ...

    def step(self, goal: Goal, F: Six, following: Goal | None) -> None:
        """One period with this equilibrium and force; following: the next row, None at the end."""
        ...


def pose_state(settings: Settings, R: Nine, p: Three) -> PoseState:
    """At rest at a pose, which becomes the start."""
    return (AnglesState if settings.rotation is RotationLaw.TAIT_BRYAN else SlerpState)(settings, R, p)


class AnglesState:
    """Three angles from R_start: R = Rz Ry Rx R_start."""

    def __init__(self, settings: Settings, R: Nine, p: Three) -> None:
        self.R_start = R
        self._feeds_speed = settings.feed is Feed.VELOCITY
        self._law = Regulator(settings.compliance, settings.h, (*p, 0.0, 0.0, 0.0), integration=settings.integration)
        self.set = self._law.set

    @property
    def x(self) -> Six:
        """Position [m] and angles [rad] from R_start."""
        return self._law.x

    @property
    def v(self) -> Six:
        """Their rates."""
        return self._law.v

    @property
    def pose(self) -> tuple[Nine, Three]:
        """Orientation and position of the TCP in the world."""
        x, y, z, alpha, beta, gamma = self._law.x
        return product(rotation(alpha, beta, gamma), self.R_start), (x, y, z)

    @property
    def twist(self) -> tuple[Three, Three]:
        """Velocity and angular velocity of the TCP in world axes."""
        v = self._law.v
        return v[:3], spin(self._law.x[3:], v[3:])

    def put(self, pose: tuple[Nine, Three], twist: tuple[Three, Three], R_start: Nine, near: Three) -> None:
        """The same state seen from other frames, its angles nearest to near."""
        R, p = pose
        self.R_start = R_start
        at = angles(product(R, transpose(R_start)), near)
        self._law.x, self._law.v = (*p, *at), (*twist[0], *angle_rates(at, twist[1]))

    def step(self, goal: Goal, F: Six, following: Goal | None) -> None:
        """One period with this equilibrium and force."""
        v_e = None
        if self._feeds_speed and following is not None:
            h = self._law.h
            a, b, c, d, e, f = ((there - here) / h for here, there in zip(goal.x, following.x, strict=True))
            v_e = (a, b, c, d, e, f)
        self._law.step(goal.x, F, v_e)


class SlerpState:
    """An orientation in the world; its angles are only written, and count on from row to row."""

    def __init__(self, settings: Settings, R: Nine, p: Three) -> None:
        self.R_start = R
        self._feeds_speed = settings.feed is Feed.VELOCITY
        self._law = SlerpRegulator(settings.compliance, settings.h, p, R, integration=settings.integration)
        self._angles: Three = (0.0, 0.0, 0.0)
        self.set = self._law.set

    @property
    def x(self) -> Six:
        """Position [m] and angles [rad] from R_start."""
        return (*self._law.p, *self._angles)

    @property
    def v(self) -> Six:
        """Velocity and angular velocity."""
        return self._law.v

    @property
    def pose(self) -> tuple[Nine, Three]:
        """Orientation and position of the TCP in the world."""
        return self._law.R, self._law.p

    @property
    def twist(self) -> tuple[Three, Three]:
        """Velocity and angular velocity of the TCP in world axes."""
        v = self._law.v
        return v[:3], v[3:]

    def put(self, pose: tuple[Nine, Three], twist: tuple[Three, Three], R_start: Nine, near: Three) -> None:
        """The same state seen from other frames, its angles nearest to near."""
        self._law.R, self._law.p = pose
        self._law.v = (*twist[0], *twist[1])
        self.R_start = R_start
        self._angles = angles(product(self._law.R, transpose(R_start)), near)

    def step(self, goal: Goal, F: Six, following: Goal | None) -> None:
        """One period with this equilibrium and force. Raises ValueError for a goal without its orientation."""
        x, y, z = goal.x[:3]
        R = goal.R
        if R is None:
            raise ValueError("slerp: the equilibrium's row has no orientation R in the world")
        v_e = None
        if self._feeds_speed and following is not None and following.R is not None:
            h = self._law.h
            u, v, w = following.x[:3]
            v_e = ((u - x) / h, (v - y) / h, (w - z) / h, *turn_rate(R, following.R, h))
        self._law.step((x, y, z), R, F, v_e)
        self._angles = angles(product(self._law.R, transpose(self.R_start)), self._angles)
