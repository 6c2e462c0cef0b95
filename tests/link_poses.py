"""Where a robot's links are, by pin alone."""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.robot.model import RobotModel
from trajopt_cli.robot.srs import SrsRobot


def link_poses(robot: RobotModel | SrsRobot, q: Array) -> Array:
    """Poses X_WL (n, m + 1, 4, 4) of the links in link_names order at axis positions q (n, k)."""
    import pinocchio as pin

    model = robot.pin_model
    data = model.createData()
    ids = [model.getFrameId(name) for name in robot.link_names]
    out = np.empty((len(q), len(ids), 4, 4))
    for row, X in zip(np.asarray(q, dtype=np.float64), out, strict=True):
        pin.framesForwardKinematics(model, data, row)
        X[:] = [data.oMf[i].homogeneous for i in ids]
    return out
