"""The regulator of the loop, one period at a time in plain floats: by three angles from R_start, or by orientations."""

from __future__ import annotations

from abc import ABC, abstractmethod

from trajopt_cli.iiwa.controller.parameters import Goal, Settings
from trajopt_cli.iiwa.controller.regulator import STILL, advance, coefficients, turn_rate
from trajopt_cli.iiwa.controller.rotations import (
    Nine,
    Three,
    angle_rates,
    angles,
    exponential,
    logarithm,
    rotation,
    spin,
    transpose,
)
from trajopt_cli.iiwa.task.model import Compliance, Feed, RotationLaw
from trajopt_cli.iiwa.task.world import Six
from trajopt_cli.robot.srs_step import product


class PoseRegulator(ABC):
    """The law of regulator.py in the world's frame, at rest at a pose R, p [m] that becomes the start.

    R_start: the orientation that angles count from. v (6,): the rates of x, or velocity and angular velocity (slerp).
    """

    x: Six
    """Position [m] and angles [rad] from R_start."""

    def __init__(self, settings: Settings, R: Nine, p: Three) -> None:
        self.R_start, self.x, self.v = R, (*p, 0.0, 0.0, 0.0), STILL
        self._h, self._integration = settings.h, settings.integration
        self._feeds_speed = settings.feed is Feed.VELOCITY
        self.set(settings.compliance)

    def set(self, compliance: Compliance) -> None:
        """Stiffness, damping and inertia from now on; the state stays."""
        self._axes = coefficients(compliance.K, compliance.D, compliance.M, self._h, self._integration)

    @property
    @abstractmethod
    def pose(self) -> tuple[Nine, Three]:
        """Orientation and position [m] of the TCP in the world."""

    @property
    @abstractmethod
    def twist(self) -> tuple[Three, Three]:
        """Velocity [m/s] and angular velocity [rad/s] of the TCP in world axes."""

    @abstractmethod
    def put(self, pose: tuple[Nine, Three], twist: tuple[Three, Three], R_start: Nine, near: Three) -> None:
        """The same state seen from other frames, its angles nearest to near."""

    @abstractmethod
    def step(self, goal: Goal, F: Six, following: Goal | None = None) -> None:
        """One period with this equilibrium and force; following: the next row, None at the end."""

    def _advanced(self, e: Six, F: Six, v_e: Six) -> list[float]:
        """Set the rates after one period with deviation e from the equilibrium; the distance moved in it (6,)."""
        (a, b, c, d, f, g), moved = advance(self._axes, self._h, e, self.v, F, v_e)
        self.v = (a, b, c, d, f, g)
        return moved


class AnglesRegulator(PoseRegulator):
    """Three angles from R_start: R = Rz Ry Rx R_start."""

    @property
    def pose(self) -> tuple[Nine, Three]:  # noqa: D102
        return product(rotation(*self.x[3:]), self.R_start), self.x[:3]

    @property
    def twist(self) -> tuple[Three, Three]:  # noqa: D102
        return self.v[:3], spin(self.x[3:], self.v[3:])

    def put(self, pose: tuple[Nine, Three], twist: tuple[Three, Three], R_start: Nine, near: Three) -> None:  # noqa: D102
        self.R_start = R_start
        at = angles(product(pose[0], transpose(R_start)), near)
        self.x, self.v = (*pose[1], *at), (*twist[0], *angle_rates(at, twist[1]))

    def step(self, goal: Goal, F: Six, following: Goal | None = None) -> None:  # noqa: D102
        v_e = STILL
        if self._feeds_speed and following is not None:
            a, b, c, d, e, f = ((there - here) / self._h for here, there in zip(goal.x, following.x, strict=True))
            v_e = (a, b, c, d, e, f)
        a, b, c, d, e, f = (now - there for now, there in zip(self.x, goal.x, strict=True))
        moved = self._advanced((a, b, c, d, e, f), F, v_e)
        a, b, c, d, e, f = (now + by for now, by in zip(self.x, moved, strict=True))
        self.x = (a, b, c, d, e, f)


class SlerpRegulator(PoseRegulator):
    """An orientation in the world, without gimbal lock; its angles are only written, and count on from row to row.

    The deviation of the rotation is phi = log(R R_e^T), a rotation vector in world axes, in place of the angles'
    differences: w' = w + h/m (tau - d w - k phi), R' = exp(h w) R, or the exact law on phi.
    """

    def __init__(self, settings: Settings, R: Nine, p: Three) -> None:
        super().__init__(settings, R, p)
        self.R = R

    @property
    def pose(self) -> tuple[Nine, Three]:  # noqa: D102
        return self.R, self.x[:3]

    @property
    def twist(self) -> tuple[Three, Three]:  # noqa: D102
        return self.v[:3], self.v[3:]

    def put(self, pose: tuple[Nine, Three], twist: tuple[Three, Three], R_start: Nine, near: Three) -> None:  # noqa: D102
        self.R, self.R_start = pose[0], R_start
        self.x = (*pose[1], *angles(product(self.R, transpose(R_start)), near))
        self.v = (*twist[0], *twist[1])

    def step(self, goal: Goal, F: Six, following: Goal | None = None) -> None:
        """As of every law. Raises ValueError for a goal without its orientation."""
        (x, y, z, *near), (x_e, y_e, z_e), R_e = self.x, goal.x[:3], goal.R
        if R_e is None:
            raise ValueError("slerp: the equilibrium's row has no orientation R in the world")
        v_e = STILL
        if self._feeds_speed and following is not None and following.R is not None:
            (a, b, c), h = following.x[:3], self._h
            v_e = ((a - x_e) / h, (b - y_e) / h, (c - z_e) / h, *turn_rate(R_e, following.R, h))
        turned = logarithm(product(self.R, transpose(R_e)))
        a, b, c, d, e, f = self._advanced((x - x_e, y - y_e, z - z_e, *turned), F, v_e)
        self.R = product(exponential((d, e, f)), self.R)
        self.x = (x + a, y + b, z + c, *angles(product(self.R, transpose(self.R_start)), (near[0], near[1], near[2])))


def pose_regulator(settings: Settings, R: Nine, p: Three) -> PoseRegulator:
    """The regulator of a rotation law."""
    return (AnglesRegulator if settings.rotation is RotationLaw.TAIT_BRYAN else SlerpRegulator)(settings, R, p)
