"""What arms of every structure share: their links along the chain of joints, pin's model, their profiles by name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, readonly
from trajopt_cli.limits import JointLimits
from trajopt_cli.robot.urdf import FLANGE


def pin_model(urdf: Path, X_WR: Array) -> Any:
    """pin.Model of a URDF's chain to the flange, its root mounted at X_WR (4, 4) in the world; other joints hold."""
    import pinocchio as pin

    model = pin.buildModelFromUrdf(str(urdf))
    chain = {*model.supports[model.frames[model.getFrameId(FLANGE, pin.FrameType.BODY)].parentJoint]}
    if others := [i for i in range(1, model.njoints) if i not in chain]:
        model = pin.buildReducedModel(model, others, pin.neutral(model))
    mount = pin.SE3(np.array(X_WR))
    for i in range(1, model.njoints):
        if model.parents[i] == 0:
            model.jointPlacements[i] = mount * model.jointPlacements[i]
    for frame in model.frames:
        if frame.parentJoint == 0:
            frame.placement = mount * frame.placement
    return model


def pin_model_on_axes(urdf: Path, X_WU: Array, names: Sequence[str], axes: Array) -> Any:
    """The same of its arm alone, its root at X_WU (4, 4) in the world where linear axes are at 0. axes (r, 3): their
    directions in the world; names: of all axes, theirs first. A rail of the URDF stands at 0."""
    import pinocchio as pin

    arm, out, parent = pin_model(urdf, X_WU), pin.Model(), 0
    if "rail" in arm.names:
        arm = pin.buildReducedModel(arm, [arm.getJointId("rail")], pin.neutral(arm))
    for name, axis in zip(names, axes, strict=False):
        parent = out.addJoint(parent, pin.JointModelPrismaticUnaligned(*axis), pin.SE3.Identity(), name)
        out.addJointFrame(parent)
    return pin.appendModel(out, arm, out.nframes - 1, pin.SE3.Identity())


def named_profile(
    robot: str, profiles: Mapping[str, JointLimits], name: str | None, default: str = "default"
) -> JointLimits:
    """The limits under a name, the default ones for None. Raises InputError listing the profiles."""
    wanted = default if name is None else name
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
