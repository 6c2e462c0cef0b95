"""What arms of every structure share: their links along the chain of joints, pin's model, their profiles by name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, readonly
from trajopt_cli.limits import JointLimits
from trajopt_cli.robot.urdf import UrdfJoint


def link_poses(chain: Sequence[UrdfJoint], X_WB: Array, q: Array) -> Array:
    """Poses X_WL (n, m + 1, 4, 4) of the base, at X_WB (n, 4, 4) or (4, 4), and of the links behind m revolute joints.

    q (n, m) [rad]. The joints' origins must not be turned and their axes be +-x, +-y or +-z, as the closed forms need.
    """
    X = np.empty((len(q), len(chain) + 1, 4, 4))
    X[:, 0] = X_WB
    for i, joint in enumerate(chain):
        before, here = X[:, i], X[:, i + 1]
        here[:] = before
        here[:, :3, 3] += before[:, :3, :3] @ joint.X[:3, 3]
        # A turn about one of the frame's axes mixes the other two.
        axis = int(np.argmax(np.abs(joint.axis)))
        u, v = (axis + 1) % 3, (axis + 2) % 3
        c, s = np.cos(q[:, i, None]), joint.axis[axis] * np.sin(q[:, i, None])
        here[:, :3, u] = c * before[:, :3, u] + s * before[:, :3, v]
        here[:, :3, v] = c * before[:, :3, v] - s * before[:, :3, u]
    return X


def pin_model(urdf: Path, X_WR: Array) -> Any:
    """pin.Model of a URDF with its root mounted at X_WR (4, 4) in the world."""
    import pinocchio as pin

    model = pin.buildModelFromUrdf(str(urdf))
    mount = pin.SE3(np.array(X_WR))
    for i in range(1, model.njoints):
        if model.parents[i] == 0:
            model.jointPlacements[i] = mount * model.jointPlacements[i]
    for frame in model.frames:
        if frame.parentJoint == 0:
            frame.placement = mount * frame.placement
    return model


def named_profile(robot: str, profiles: Mapping[str, JointLimits], name: str | None) -> JointLimits:
    """The limits under a name, "default" for None. Raises InputError listing the profiles."""
    wanted = "default" if name is None else name
    if wanted not in profiles:
        raise InputError(f"robot {robot} has no limit profile '{wanted}': known are {', '.join(profiles)}")
    return profiles[wanted]


def checked_pose(X: Array | None, name: str) -> Array:
    """A read-only pose (4, 4), the identity for None. Raises ValueError for what is none."""
    X = readonly(np.eye(4) if X is None else X)
    if X.shape != (4, 4):
        raise ValueError(f"{name} has shape {X.shape}, wanted (4, 4)")
    off = float(np.abs(X[:3, :3] @ X[:3, :3].T - np.eye(3)).max())
    if not off <= 1e-9 or np.linalg.det(X[:3, :3]) < 0 or np.any(X[3] != [0, 0, 0, 1]):
        raise ValueError(f"{name} is not a pose: its rotation is off by {off:.3g}, or its last row is not 0 0 0 1")
    if not np.isfinite(X).all():
        raise ValueError(f"{name} is not a pose: its position is not finite")
    return X
