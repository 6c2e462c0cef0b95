"""The inverse as an expression against the numeric one: every branch, every turn, and its slopes."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
from small_cells import MOUNTS, mounted, plant_without_rail, safe_arm

from trajopt_cli.geometry import pose, rotation_about
from trajopt_cli.robot.differential import Differential
from trajopt_cli.robot.symbolic_inverse import branch_signs, inverse_arm
from trajopt_cli.trajectories.axes import Axes

TURN = 2 * np.pi


@pytest.fixture(scope="module")
def axes() -> Axes:
    return Axes.of(plant_without_rail())


@pytest.fixture(scope="module")
def symbolic(axes: Axes) -> ca.Function:
    p, R, signs, ref = ca.SX.sym("p", 3), ca.SX.sym("R", 3, 3), ca.SX.sym("signs", 3), ca.SX.sym("ref", 6)
    return ca.Function("inverse", [p, R, signs, ref], list(inverse_arm(axes.robot.arm, p, R, signs, ref)))


def test_all_branches_and_turns_equal_the_numeric_inverse(axes: Axes, symbolic: ca.Function) -> None:
    rng = np.random.default_rng(1)
    X = Differential.of(axes.robot.arm, safe_arm(rng, axes, 150)).pose()
    numeric = axes.inverse(X, np.zeros(len(X)))
    seen = np.zeros(8, dtype=int)
    for i in range(len(X)):
        for cfx in range(8):
            q = numeric[i, cfx]
            if np.isnan(q).any():
                continue
            seen[cfx] += 1
            wanted = q + TURN * rng.integers(-1, 2, 6)
            reference = wanted + rng.uniform(-0.98, 0.98, 6) * np.pi
            got, s3 = symbolic(X[i, :3, 3], X[i, :3, :3], branch_signs(cfx), reference)
            np.testing.assert_allclose(np.ravel(got), wanted, rtol=0, atol=1e-10, err_msg=f"pose {i} cfx {cfx}")
            assert float(s3) == pytest.approx(np.sin(q[2]), abs=1e-12)
    assert seen.min() > 30


def test_the_answer_reaches_the_pose(axes: Axes, symbolic: ca.Function) -> None:
    rng = np.random.default_rng(2)
    arms = safe_arm(rng, axes, 50)
    for X, q in zip(Differential.of(axes.robot.arm, arms).pose(), arms, strict=True):
        cfx = int(np.nanargmin(np.abs(np.sin((axes.inverse(X[None], np.zeros(1))[0] - q) / 2)).sum(axis=1)))
        got = np.ravel(symbolic(X[:3, 3], X[:3, :3], branch_signs(cfx), q)[0])
        np.testing.assert_allclose(got, q, rtol=0, atol=1e-10)


def test_sine_of_the_elbow_says_how_far_out_of_reach_a_pose_is(axes: Axes, symbolic: ca.Function) -> None:
    """sin q3 = (L2^2 + L4^2 - r^2) / (2 L2 L4) with r from axis 2 to the wrist centre, not clamped."""
    arm = axes.robot.arm
    signs = branch_signs(0)
    for far in (0.5, arm.c2 + arm.c3, 1.2, 2.0):
        wrist = np.array([arm.a1 + 0.6 * far, 0.0, arm.c1 + 0.8 * far])
        R = rotation_about([0.0, 1.0, 0.0], 2.0)
        s3 = float(symbolic(wrist + arm.c4 * R[:, 2], R, signs, np.zeros(6))[1])
        assert s3 == pytest.approx((arm.c2**2 + arm.c3**2 - far**2) / (2 * arm.c2 * arm.c3), abs=1e-12)
    assert s3 < -1


@pytest.mark.parametrize("name", MOUNTS)
def test_slopes_equal_those_through_the_jacobian(name: str) -> None:
    """Along a moving pose and a moving rail: first J^-1 times the twist, then its difference."""
    axes = mounted(name)
    rng = np.random.default_rng(3)
    R_BW = axes.X_WB0[:3, :3].T
    s = ca.SX.sym("s")
    for q in safe_arm(rng, axes, 12, 0.3):
        rail, rail_rate = rng.uniform(0, 1), rng.uniform(-1, 1)
        X = axes.forward(np.r_[rail, q])
        numeric = axes.inverse(X[None], np.array([rail]))[0]
        cfx = int(np.nanargmin(np.abs(np.sin((numeric - q) / 2)).sum(axis=1)))
        v, axis = rng.normal(size=3) * 0.3, rng.normal(size=3)
        axis /= np.linalg.norm(axis)
        K = ca.skew(R_BW @ axis)
        B = axes.in_base(X)
        R = (ca.SX.eye(3) + ca.sin(s) * K + (1 - ca.cos(s)) * (K @ K)) @ B[:3, :3]
        p = B[:3, 3] + s * (R_BW @ v) - (rail + s * rail_rate) * axes.rail_axis[:, 0]
        out, _ = inverse_arm(axes.robot.arm, p, R, ca.DM(branch_signs(cfx)), ca.DM(q))
        d1 = ca.jacobian(out, s)
        f = ca.Function("f", [s], [out, d1, ca.jacobian(d1, s)])
        value, slope, curve = (np.ravel(x) for x in f(0.0))
        np.testing.assert_allclose(value, q, rtol=0, atol=1e-10)

        def rates(at: float, q=q, X=X, v=v, axis=axis, rail=rail, rail_rate=rail_rate, cfx=cfx) -> np.ndarray:
            moved = pose(rotation_about(axis, at) @ X[:3, :3], X[:3, 3] + at * v)
            d = rail + at * rail_rate
            arm = axes.inverse(moved[None], np.array([d]))[0, cfx]
            J = axes.jacobian(np.r_[d, arm], np.eye(4))
            return np.linalg.solve(J[:, 1:], np.r_[v, axis] - J[:, 0] * rail_rate)

        np.testing.assert_allclose(slope, rates(0.0), rtol=1e-9, atol=1e-9)
        h = 1e-5
        np.testing.assert_allclose(curve, (rates(h) - rates(-h)) / (2 * h), rtol=1e-5, atol=1e-5 * np.abs(curve).max())


def test_signs_follow_the_bits_of_cfx() -> None:
    table = {cfx: tuple(branch_signs(cfx)) for cfx in range(8)}
    assert table[0] == (1, 1, 1)
    assert table[1] == (1, 1, -1)
    assert table[2] == (1, -1, 1)
    assert table[4] == (-1, 1, 1)
    assert len(set(table.values())) == 8
