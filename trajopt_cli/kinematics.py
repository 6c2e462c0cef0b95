"""What a program may ask of the robot it runs on: CalcRobT, CalcJointT, CRobT and CJointT after moves of another kind.

A protocol on floor 1, so that programs are read without knowing any robot; who has a robot fills it in.
"""

from __future__ import annotations

from typing import Protocol

from trajopt_cli.geometry import Array
from trajopt_cli.motion import ConfData, ExternalAxes


class Kinematics(Protocol):
    """The robot in its cell. q: arm joints (6,) in rad. X_WF: flange in the world (4, 4), m."""

    @property
    def start(self) -> tuple[Array, ExternalAxes]:
        """Where the cycle begins: arm joints, and external axes as RAPID states them (mm, deg)."""

    def forward(self, q: Array, extax: ExternalAxes) -> Array:
        """X_WF at joints q with the external axes at extax; None in extax stands for their start position."""

    def inverse(self, X_WF: Array, extax: ExternalAxes, conf: ConfData | None, near: Array | None) -> Array | None:
        """Joints that bring the flange to X_WF in configuration conf; None where there are none within the limits.

        conf None, or several solutions of one configuration: the one nearest to near (to the start where None).
        """

    def along(self, q: Array, before: ExternalAxes, X_WF: Array, extax: ExternalAxes, X_FT: Array) -> Array | None:
        """Joints to which a straight way of the tool X_FT leads from joints q, external axes going from before to
        extax; None where it does not get to X_WF."""

    def confdata(self, q: Array) -> ConfData:
        """Configuration of joints q."""
