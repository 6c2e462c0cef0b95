"""Bodies that positioners turn: where each stands in every row of a file, and how far its points move between rows.

The optimiser has its own answer to this: here an axis is where its column has it, whatever the program says, and one
without a column stands where it stands when the program begins.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.judge.geometry import inverse_pose, lengths, mounted, table_frame
from trajopt_cli.judge.machine import Machine
from trajopt_cli.motion import Program
from trajopt_cli.shapes import Rides, Shape, outline
from trajopt_cli.trajectory import Trajectory

Angles = Mapping[tuple[str, int], float]
"""Of units' external axes, 0 for eax_a, where they are not at their start [rad]."""


def since_start(plant: Machine, rides: Rides | None, at: Angles) -> Array:
    """How what rides on a unit has moved (4, 4) in the world since all axes were at their start."""
    if rides is None:
        return np.eye(4)
    axes = plant.units[rides.unit][: rides.axes]
    now = table_frame(axes, [at.get((rides.unit, axis.eax), axis.start) for axis in axes])
    return np.asarray(now @ inverse_pose(table_frame(axes, [axis.start for axis in axes])))


@dataclass(frozen=True, eq=False)
class _Axis:
    """mount (4, 4): on the axis before it. column: of a file's tables, None where it stands at angle [rad or m]."""

    mount: Array
    column: int | None
    angle: float
    slides: bool


class Turntables:
    """The frames of all that positioners carry in a file. number: of each frame, from 0. turning: those that move."""

    def __init__(self, program: Program, plant: Machine, trajectory: Trajectory, at: Angles):
        names = () if trajectory.tables is None else trajectory.tables.names
        moves = [unit for motion in program.motions for unit in getattr(motion, "units", ())]
        columns = {(unit.unit, unit.eax): names.index(unit.column) for unit in moves if unit.column in names}
        keys = [Rides(unit, count) for unit, axes in sorted(plant.units.items()) for count in range(1, len(axes) + 1)]
        self.number = {key: i for i, key in enumerate(keys)}
        self._axes, self._back = list[list[_Axis]](), list[Array]()
        for unit, count in keys:
            axes = plant.units[unit][:count]
            self._axes.append([
                _Axis(mounted(axis), columns.get((unit, axis.eax)), at.get((unit, axis.eax), axis.start), axis.slides)
                for axis in axes
            ])  # fmt: skip
            self._back.append(inverse_pose(table_frame(axes, [axis.start for axis in axes])))
        self.turning = {
            key for key, axes in zip(keys, self._axes, strict=True) if any(a.column is not None for a in axes)
        }

    def poses(self, theta: Array) -> Array:
        """How the frames have moved (m, F, 4, 4) since the start, with the file's tables at (m, T) [rad]."""
        each = [self._carried(i, theta)[-1] @ back for i, back in enumerate(self._back)]
        return np.stack(each, axis=1) if each else np.empty((len(theta), 0, 4, 4))

    def moved(self, shape: Shape, number: int, theta: Array, swing: Array) -> Array:
        """How far (m,) the points of a frame's shape move at most while tables at (m, T) swing by (m, T) [rad]."""
        local, radius = outline(shape)
        carried = self._carried(number, theta)
        X = carried[-1] @ self._back[number]
        points = local @ np.swapaxes(X[:, :3, :3], 1, 2) + X[:, None, :3, 3]
        out = np.zeros(len(theta))
        for axis, frame in zip(self._axes[number], carried, strict=True):
            if axis.column is not None and axis.slides:
                out += swing[:, axis.column]
            elif axis.column is not None:
                arm = points - frame[:, None, :3, 3]
                across = lengths(np.cross(arm, frame[:, None, :3, 2]).reshape(-1, 3)).reshape(arm.shape[:2])
                out += (across.max(axis=1) + radius) * swing[:, axis.column]
        return out

    def _carried(self, number: int, theta: Array) -> list[Array]:
        """What each axis of a frame carries (m, 4, 4)."""
        X, out = np.tile(np.eye(4), (len(theta), 1, 1)), []
        for axis in self._axes[number]:
            angle = np.full(len(theta), axis.angle) if axis.column is None else theta[:, axis.column]
            turn = np.tile(np.eye(4), (len(theta), 1, 1))
            if axis.slides:
                turn[:, 2, 3] = angle
            else:
                turn[:, 0, 0] = turn[:, 1, 1] = np.cos(angle)
                turn[:, 1, 0] = np.sin(angle)
                turn[:, 0, 1] = -turn[:, 1, 0]
            out.append(X := X @ axis.mount @ turn)
        return out
