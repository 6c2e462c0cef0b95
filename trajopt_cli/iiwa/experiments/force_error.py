"""The hand's part of sections 6.1.1 and 6.1.2: how wrong the forces are that the robot makes of its joint torques."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trajopt_cli.iiwa.controller.forces import force_of
from trajopt_cli.iiwa.controller.sensor import TorqueErrors
from trajopt_cli.iiwa.experiments import published
from trajopt_cli.iiwa.experiments.setup import START, Bench, H
from trajopt_cli.iiwa.task.model import COORDINATES, Sensor

_SENSORS = 500  # draws of the constant errors
_ROWS = 1000  # periods of each: one second holds both ripples many times


@dataclass(frozen=True)
class ForceError:
    """Along one axis [N]: the thesis' largest error in each of its four tables' columns and their median; of our
    sensors' largest errors the median and the greatest, and what no sensor within the data sheet exceeds."""

    axis: str
    thesis: tuple[float, ...]
    thesis_median: float
    median: float
    greatest: float
    bound: float


@dataclass(frozen=True, eq=False)
class ForceErrors:
    """columns: what the thesis' numbers stand for. sensors: how many were drawn."""

    section: str
    title: str
    columns: tuple[str, ...]
    sensors: int
    rows: tuple[ForceError, ...]
    sentences: tuple[str, ...]


def force_error(bench: Bench) -> ForceErrors:
    """Torque errors of the data sheet at START, through the force mapping, at rest."""
    J = bench.robot.jacobian(np.array(START))
    errors = np.array(
        [TorqueErrors(Sensor(seed=seed), bench.robot.torque, H).at(np.arange(_ROWS)) for seed in range(_SENSORS)]
    )
    largest = np.abs(force_of(J, errors)[..., :3]).max(axis=1)
    sensor = Sensor()
    extreme = sensor.bias * bench.robot.torque + sum(amplitude for _, amplitude in sensor.ripple)
    mapping = np.abs(force_of(J, np.eye(7)).T[:3])  # force along each axis per torque of each joint
    theirs = np.array(list(published.FORCE_ERROR.values())).T
    rows = tuple(
        ForceError(
            COORDINATES[i],
            tuple(theirs[i].tolist()),
            float(np.median(theirs[i])),
            float(np.median(largest[:, i])),
            float(largest[:, i].max()),
            float(mapping[i] @ extreme),
        )
        for i in range(3)
    )
    return ForceErrors(
        section="6.1.1, 6.1.2",
        title="error of the measured force, led by hand",
        columns=tuple(published.FORCE_ERROR),
        sensors=_SENSORS,
        rows=rows,
        sentences=(
            f"ours: constant errors within {100 * sensor.bias:g} % of each sensor's range and the ripple of section"
            " 3.1.2, at rest; nobody led this arm by hand, so that what moves it or its model adds is missing",
        ),
    )
