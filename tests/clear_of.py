"""How far a robot is from everything, by pin and coal, one pair and one row at a time."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
from link_poses import link_poses

from trajopt_cli.geometry import Array
from trajopt_cli.problem.plant import Plant
from trajopt_cli.proximity.pair import Pair
from trajopt_cli.robot.model import RobotModel
from trajopt_cli.shapes import Capsule, MeshFile
from trajopt_cli.trajectory import Trajectory


def by_pin_and_coal(plant: Plant, q: Array) -> Array:
    """The least distance less what is wanted (n,), every pair of every row."""
    import pinocchio as pin

    model = plant.robot.pin_model
    data, flange = model.createData(), model.getFrameId("tool0", pin.FrameType.BODY)
    X_WF = []
    for row in q:
        pin.framesForwardKinematics(model, data, row)
        X_WF.append(data.oMf[flange].homogeneous)
    X = dict(zip(plant.robot.link_names, np.moveaxis(link_poses(plant.robot, q), 1, 0), strict=True))
    shapes = {name: parts[0] for name, parts in plant.robot.bodies.items()}
    for solid in plant.attached:
        assert not isinstance(solid.shape, MeshFile)
        X[solid.name], shapes[solid.name] = np.array(X_WF), solid.shape
    out = np.full(len(q), np.inf)
    for solid in plant.obstacles:
        assert not isinstance(solid.shape, MeshFile)
        for name, shape in shapes.items():
            if name not in solid.ignore and (name != plant.robot.link_names[0] or plant.robot.has_rail):
                out = np.minimum(out, Pair(shape, solid.shape).distances(X[name]) - plant.clearance)
    for first, second in plant.self_pairs:
        X_12 = np.linalg.inv(X[first]) @ X[second]
        out = np.minimum(out, Pair(shapes[second], shapes[first]).distances(X_12))
    return out


def with_capsules(robot: RobotModel) -> RobotModel:
    """An IRB 140 with the smallest capsules around its links, of which distances have closed forms."""
    truth = json.loads((Path(__file__).parent / "data" / "truth" / "collision_primitives.json").read_text())["irb140"]
    bodies = {name: (Capsule(name, np.array(c["a"]), np.array(c["b"]), c["r"]),) for name, c in truth.items()}
    return replace(robot, bodies=bodies)


def least_along(plant: Plant, trajectory: Trajectory, step: float = 0.01) -> float:
    """The same of a whole motion, at rows and places so near each other that no axis moves farther [rad or m]."""
    parts = []
    for a, b in zip(trajectory.q[:-1], trajectory.q[1:], strict=True):
        n = max(1, int(np.ceil(np.abs(b - a).max() / step)))
        parts.append(a + np.linspace(0, 1, n, endpoint=False)[:, None] * (b - a))
    q = np.concatenate([*parts, trajectory.q[-1:]])
    kept = [0]
    for i in range(len(q)):
        if np.abs(q[i] - q[kept[-1]]).max() > step or i == len(q) - 1:
            kept.append(i)
    return float(by_pin_and_coal(plant, q[kept]).min())
