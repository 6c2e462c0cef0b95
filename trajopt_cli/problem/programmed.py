"""The robot behind a program: what CalcRobT, CalcJointT, CRobT and CJointT ask, answered by the cell's own machine."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.motion import NO_EXTERNAL_AXES, ConfData, ExternalAxes
from trajopt_cli.path.line import Line
from trajopt_cli.problem.nearest import nearest
from trajopt_cli.problem.path_ik import ArmPath, follow
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.inverse import confdata


class PlantKinematics:
    """trajopt_cli.kinematics.Kinematics on a plant: joint limits in force, turns included, the rail where extax says.

    An external axis that does not drive the rail changes nothing.
    """

    def __init__(self, plant: Plant):
        self.plant = plant

    @cached_property
    def start(self) -> tuple[Array, ExternalAxes]:
        """Arm joints (6,) [rad] and external axes [mm] where the cycle begins."""
        plant = self.plant
        return plant.start[plant.layout.arm], plant.with_rail(NO_EXTERNAL_AXES, plant.start[plant.layout.rail])

    def forward(self, q: Array, extax: ExternalAxes) -> Array:
        """X_WF (4, 4) at arm joints q (6,) [rad]; the rail at its start where extax leaves it open."""
        return self.plant.robot.forward(self.plant.layout.merge(self._rail(extax), np.asarray(q)))

    def inverse(self, X_WF: Array, extax: ExternalAxes, conf: ConfData | None, near: Array | None) -> Array | None:
        """Arm joints (6,) [rad] that bring the flange to X_WF in configuration conf, of several the nearest to near."""
        centre = self.plant.start[self.plant.layout.arm] if near is None else near
        return next(iter(nearest(self.plant, X_WF, self._rail(extax), centre[None], conf)), None)

    def along(self, q: Array, before: ExternalAxes, X_WF: Array, extax: ExternalAxes, X_FT: Array) -> Array | None:
        """Arm joints (6,) [rad] to which a line of tool X_FT leads; None where it cannot be run."""
        rails = self._rail(before), self._rail(extax)
        line = Line(self.forward(q, before) @ X_FT, X_WF @ X_FT)
        (found,) = follow(self.plant, [ArmPath(line, X_FT, rails, q)])
        return found.end if found is not None and found.whole else None

    def confdata(self, q: Array) -> ConfData:
        """Configuration of arm joints q (6,) [rad]."""
        return confdata(self.plant.robot, q)

    def _rail(self, extax: ExternalAxes) -> Array:
        """The rails (r,) [m]."""
        return self.plant.rail_after(extax, self.plant.start[self.plant.layout.rail])
