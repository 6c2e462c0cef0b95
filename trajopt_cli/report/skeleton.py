"""What the pictures of a plan need besides its series: angles, the arm's own plane, a skeleton."""

from __future__ import annotations

import numpy as np

from trajopt_cli.geometry import Array, xyz_from_rotation
from trajopt_cli.problem.plant import Plant
from trajopt_cli.robot import arm
from trajopt_cli.robot.parallel_arm import ParallelArm

_TURN = np.pi / 2  # rad between two samples: no angle moves so fast, it is the singularity of the three angles


def angles(X_WT: Array) -> Array:
    """Intrinsic x-y'-z'' angles (n, 3) [rad] without jumps by whole turns; nan where they pass their singularity."""
    out = np.unwrap(xyz_from_rotation(X_WT[:, :3, :3]), axis=0)
    out[1:][(np.abs(np.diff(out, axis=0)) > _TURN).any(axis=1)] = np.nan
    return out


def reach_section(plant: Plant, q: Array) -> Array:
    """The wrist centre in the arm's own plane (n, 2) [m]: ahead of axis 1 and up, of axis positions q (n, k). Of three
    parallel axes axis 4, which axes 2 and 3 alone carry."""
    return np.column_stack(arm.reach_section(plant.robot.arm, q[:, plant.layout.arm]))


def skeleton(plant: Plant, q: Array, X_FT: Array) -> Array:
    """Base, foot of joint 2, joints 2 and 3, wrist centre, flange, TCP: (7, 3) [m] in the world at q (k,); (8, 3) where
    axis 4 is carried apart from the wrist centre, before it."""
    robot = plant.robot
    X_WC = robot.canonical_base_at(q)
    points = robot.differential(q, X_FT).points()
    ends = points[3:5] if isinstance(robot.arm, ParallelArm) else points[4:5]
    foot = (X_WC @ [0.0, 0.0, robot.arm.c1, 1.0])[:3]
    return np.vstack([X_WC[:3, 3], foot, points[1], points[2], *ends, robot.forward(q)[:3, 3], points[6]])
