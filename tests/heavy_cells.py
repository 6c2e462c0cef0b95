"""A plant with masses, made up for tests, and the closed form of its first axis, which the tests of torques share."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.limits import TcpCaps
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot.model import load_robot
from trajopt_cli.trajectory import Trajectory

ROBOTS = Path(__file__).parent / "data" / "robots"
START = np.array([0.0, 0.3, -0.2, 0.0, 0.5, 0.0])


def heavy(binds: bool = True, times: float = 1.0, **more: object) -> Plant:
    """The arm that stands on the floor; binds: its torque limits, so many times those of its file, are kept."""
    robot = load_robot(str(ROBOTS / "heavy.yaml"))
    base = robot.profile()
    assert base.torque is not None
    limits = replace(base, torque=base.torque * times, torque_binds=binds)
    plant = Plant(robot, limits, TcpCaps(9.0, 200.0), START, (), False, False, frozenset())
    return replace(plant, **more)


def heavy_on_rail(X_WR: Array) -> Plant:
    """The same arm on a rail whose force is limited, too, mounted anyhow."""
    robot = load_robot(str(ROBOTS / "heavy_rail.yaml"), X_WR)
    limits = replace(robot.profile(), torque_binds=True)
    return Plant(robot, limits, TcpCaps(9.0, 200.0), np.r_[0.5, START], (0,), False, False, frozenset())


def first_axis_inertia(plant: Plant, q: Array, load: tuple[float, Array] | None = None) -> float:
    """Of all that turns about the vertical first axis at q, rotor included [kg m2]: the parallel axis theorem on the
    bodies' places by forward kinematics of the links. load: mass and centre in the flange's frame."""
    total, robot = float(plant.robot.rotor[0]), plant.robot
    X = np.eye(4)
    for i, joint in enumerate(robot.chain[:6]):
        x, y, z = joint.axis * q[i]
        c, s = np.cos([x, y, z]), np.sin([x, y, z])
        turn = [
            np.array([[1, 0, 0], [0, c[0], -s[0]], [0, s[0], c[0]]]),
            np.array([[c[1], 0, s[1]], [0, 1, 0], [-s[1], 0, c[1]]]),
            np.array([[c[2], -s[2], 0], [s[2], c[2], 0], [0, 0, 1]]),
        ]
        X = X @ joint.X
        X[:3, :3] = X[:3, :3] @ turn[0] @ turn[1] @ turn[2]
        body = robot.pin_model.inertias[i + 1]
        at = X[:3, :3] @ body.lever + X[:3, 3]
        total += body.mass * (at[0] ** 2 + at[1] ** 2) + (X[:3, :3] @ body.inertia @ X[:3, :3].T)[2, 2]
    if load is not None:
        at = (X @ robot.chain[6].X @ np.r_[load[1], 1.0])[:3]
        total += load[0] * (at[0] ** 2 + at[1] ** 2)
    return total


def swing(plant: Plant, way: float, acceleration: float, every: float = 1e-3, speeds: bool = True) -> Trajectory:
    """The first axis alone from the start by way [rad], half of it with this acceleration; a row at its switch."""
    T = 2 * np.sqrt(way / acceleration)
    t = np.unique(np.r_[np.arange(0, T, every), T / 2, T]) if speeds else np.arange(0, T + every, every)
    s = np.clip(t, 0, T)
    ahead = s < T / 2
    x = np.where(ahead, acceleration * s**2 / 2, way - acceleration * (T - s) ** 2 / 2)
    v = np.where(ahead, acceleration * s, acceleration * (T - s))
    q, qd = np.tile(plant.start, (len(t), 1)), np.zeros((len(t), 6))
    q[:, 0] += x
    qd[:, 0] = v
    return Trajectory(plant.robot.axis_names, t, q, qd if speeds else None)
