"""An arm carried by linear axes of the cell: up to three of them, which together shift its base and do not turn it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from trajopt_cli.geometry import Array, readonly
from trajopt_cli.limits import SPREADS, JointLimits

if TYPE_CHECKING:
    from trajopt_cli.robot.model import RobotModel

SPEED, ACCELERATION, JERK = 1.0, 2.0, 20.0
"""Where nobody says: m/s, m/s2, m/s3, guesses of grade D as for a robot that `trajopt robot add` puts on a track."""
GUESS = "estimate for a custom track (public data sheets say 1 to 4 m/s)"


@dataclass(frozen=True, eq=False)
class BaseAxis:
    """A linear axis: name, unit direction (3,) in the world, range [m], and limits [m/s, m/s2, m/s3], None where nobody
    says. source: of those that are given."""

    name: str
    direction: Array
    lower: float
    upper: float
    velocity: float | None = None
    acceleration: float | None = None
    jerk: float | None = None
    source: str = ""


def on_axes(robot: RobotModel, axes: Sequence[BaseAxis], X_WB: Array) -> RobotModel:
    """The arm of a robot, its base at X_WB (4, 4) in the world where all the axes are at 0; a rail of its own is left
    out."""
    names = tuple(axis.name for axis in axes)
    R_BW = np.asarray(X_WB)[:3, :3].T
    return replace(
        robot,
        axis_names=(*names, *robot.axis_names[robot.layout.arm]),
        X_WR=readonly(X_WB),
        X_RB=readonly(np.eye(4)),
        X_UB=robot.X_RB,
        rail_axes=readonly([R_BW @ axis.direction for axis in axes]),
        profiles={name: _limits(limits, robot.layout.arm, axes) for name, limits in robot.profiles.items()},
        rotor=readonly([*np.zeros(len(axes)), *robot.rotor[robot.layout.arm]]),
    )


def turned(robot: RobotModel, direction: Array) -> RobotModel:
    """A robot whose one rail runs along a unit direction (3,) of its arm's base frame."""
    return replace(robot, rail_axes=readonly((robot.X_RB[:3, :3] @ direction)[None]), X_UB=robot.X_RB)


def _limits(limits: JointLimits, arm: slice, axes: Sequence[BaseAxis]) -> JointLimits:
    names = tuple(axis.name for axis in axes)

    def with_axes(kind: str, own: Sequence[float]) -> Array | None:
        given = getattr(limits, kind)
        return None if given is None else np.r_[own, given[arm]]

    guessed = {"velocity": SPEED, "acceleration": ACCELERATION, "jerk": JERK}
    values: dict[str, Any] = {kind: [getattr(axis, kind) or guess for axis in axes] for kind, guess in guessed.items()}
    values |= {"lower": [axis.lower for axis in axes], "upper": [axis.upper for axis in axes]}
    values["torque"] = [np.inf] * len(axes)
    values = {kind: with_axes(kind, own) for kind, own in values.items()}
    sources, grades, spread = dict(limits.sources), dict(limits.grades), dict(limits.spread)
    for key in [key for key in sources if key.startswith(("rail.", *(f"{name}." for name in names)))]:
        for known in (sources, grades, spread):
            known.pop(key, None)
    for axis in axes:
        for kind in guessed:
            key = f"{axis.name}.{kind}"
            if getattr(axis, kind) is not None:
                sources[key] = axis.source
            else:
                sources[key], grades[key] = GUESS, "D"
                if kind in SPREADS:
                    spread[key] = SPREADS[kind]["D"]
    return replace(
        limits, names=names + limits.names[arm], sources=sources, grades=grades, spread=spread,
        **values,
    )  # fmt: skip
