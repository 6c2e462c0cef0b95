"""Where positioners bring a work object: a product of turns about axes anywhere, by pin's rigid motions."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pinocchio as pin

from trajopt_cli.geometry import Array
from trajopt_cli.judge.geometry import turned


def about(u: Array, p: Array, angle: float) -> pin.SE3:
    R = pin.exp3(u * angle)
    return pin.SE3(R, p - R @ p)


def test_two_axes_turn_a_point_one_after_the_other() -> None:
    rng = np.random.default_rng(4)
    axes = [(u / np.linalg.norm(u), p) for u, p in rng.normal(size=(2, 2, 3))]
    theta = rng.uniform(-3, 3, (30, 2))
    R, x = turned([SimpleNamespace(slides=False, u=tuple(u), p=tuple(p)) for u, p in axes], theta)  # type: ignore[misc]
    for k, angles in enumerate(theta):
        wanted = about(*axes[0], angles[0]) * about(*axes[1], angles[1])
        np.testing.assert_allclose(R[k], wanted.rotation, atol=1e-14)
        np.testing.assert_allclose(x[k], wanted.translation, atol=1e-13)
