"""The rows of every block against numbers from the numeric kinematics."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
from small_cells import MOUNTS, mounted, safe_arm

from trajopt_cli.geometry import Array, axis_angle, inverse_pose, line_pose, pose, rotation_about
from trajopt_cli.optimize.axes import Axes
from trajopt_cli.optimize.stages import PathConstants, Stages, ToolRow
from trajopt_cli.problem.problem import Coupling
from trajopt_cli.robot.kinematics import forward_acceleration, forward_velocity, inverse_acceleration, inverse_velocity
from trajopt_cli.robot.symbolic import forward
from trajopt_cli.robot.symbolic_inverse import BranchSigns

X_FT = pose(rotation_about([0.6, 0, 0.8], 0.7), [0.05, -0.03, 0.12])


@pytest.fixture(scope="module", params=MOUNTS[1:])
def axes(request: pytest.FixtureRequest) -> Axes:
    return mounted(request.param)


@pytest.fixture(scope="module")
def stages(axes: Axes) -> Stages:
    return Stages(axes.robot.arm, axes.rail_axis, axes.lower, axes.upper)


def lines(axes: Axes, rng: np.random.Generator, turning: bool, n: int = 12) -> list[tuple[Array, Array, float, int]]:
    """Lines of the tool (X_0, X_1 in the world), a rail position and a branch that serve their middle."""
    out = []
    for q in safe_arm(rng, axes, n, 0.35):
        d = rng.uniform(0.2, 0.8)
        middle = axes.forward(np.r_[d, q]) @ X_FT
        way, axis = rng.normal(size=3) * 0.04, rng.normal(size=3)
        half = rotation_about(axis / np.linalg.norm(axis), 0.25 if turning else 0.0)
        X_0, X_1 = pose(middle[:3, :3] @ half.T, middle[:3, 3] - way), pose(middle[:3, :3] @ half, middle[:3, 3] + way)
        numeric = axes.inverse(axes.forward(np.r_[d, q])[None], np.array([d]))[0]
        out.append((X_0, X_1, d, int(np.nanargmin(np.abs(np.sin((numeric - q) / 2)).sum(axis=1)))))
    return out


def poses(axes: Axes, rng: np.random.Generator, n: int) -> list[tuple[Array, float, int]]:
    """Poses of the tool in reach: the middles of lines."""
    return [(line_pose(a, b, np.array([0.5]))[0], d, cfx) for a, b, d, cfx in lines(axes, rng, True, n)]


def parameters(axes: Axes, X_0: Array, X_1: Array, cfx: int, arm: Array, V: Array, A: Array, caps: Array, room: Array):
    """Path constants put together from the two world poses, then all other parameters of a node."""
    T_0, T_1 = axes.in_base(X_0), axes.in_base(X_1)
    axis, angle = axis_angle(T_0[:3, :3].T @ T_1[:3, :3])
    R = (T_0 @ inverse_pose(X_FT))[:3, :3]
    path = PathConstants(T_0[:3, 3], T_1[:3, 3] - T_0[:3, 3], R, X_FT[:3, :3] @ axis, angle, X_FT[:3, 3])
    return np.r_[path.vector(), BranchSigns.from_cfx(cfx).vector(), arm, V, A, caps, room]


def motion_at(axes: Axes, X_0: Array, X_1: Array, cfx: int, s: float, d: float, v: float, w: float, a: float, b: float):
    """q, qd, qdd in scaled time from poses, Jacobian and its rate: no expression involved."""
    X_WT = line_pose(X_0, X_1, np.array([s]))
    arm = axes.inverse(X_WT @ inverse_pose(X_FT), np.array([d]))[0, cfx]
    q = np.r_[d, arm]
    axis, angle = axis_angle(X_0[:3, :3].T @ X_1[:3, :3])
    twist = np.r_[X_1[:3, 3] - X_0[:3, 3], X_0[:3, :3] @ axis * angle]
    qd = inverse_velocity(axes.robot, q, twist * v, w, X_FT)
    qdd = inverse_acceleration(axes.robot, q, qd, twist * a, b, X_FT)
    return q, qd, qdd


@pytest.mark.parametrize("sides", ["l", "lr"])
@pytest.mark.parametrize("coupling", Coupling)
@pytest.mark.parametrize("turning", [False, True], ids=["straight", "turning"])
def test_path_rows_are_the_motion_over_its_limits(
    axes: Axes, stages: Stages, sides: str, coupling: Coupling, turning: bool
) -> None:
    rng = np.random.default_rng(11)
    block = stages.path_node(sides, turning, coupling)
    n = len(sides)
    assert len(block.lower) == 6 + 2 + 6 + 6 * n + 2 + 1 + 2 * n
    for X_0, X_1, d, cfx in lines(axes, rng, turning):
        s, v, w, T = rng.uniform(0.2, 0.8), rng.normal(), rng.normal() * 0.5, rng.uniform(0.3, 2)
        acc, rail_acc = rng.normal(size=n) * 3, rng.normal(size=n)
        V, A, room = axes.velocity * 0.9, axes.acceleration * 0.8, rng.uniform(0.7, 1, 6)
        caps = rng.uniform(0.1, 1, 3)
        if coupling is Coupling.COORDINATED:
            d_0, d_1 = d - 0.1 * s, d + 0.1 * (1 - s)
            w, rail_acc = v * 0.1, acc * 0.1
            z = np.r_[s, v, acc, d_0, d_1, T]
        else:
            z = np.r_[s, v, d, w, np.column_stack([acc, rail_acc]).ravel(), T]
        q, qd, _ = motion_at(axes, X_0, X_1, cfx, s, d, v, w, 0.0, 0.0)
        qdds = [motion_at(axes, X_0, X_1, cfx, s, d, v, w, a, b)[2] for a, b in zip(acc, rail_acc, strict=True)]
        reference = q[1:] + rng.uniform(-1, 1, 6)
        got = np.ravel(block.g(z, parameters(axes, X_0, X_1, cfx, reference, V, A, caps, room)))
        middle, half = (axes.upper + axes.lower)[1:] / 2, (axes.upper - axes.lower)[1:] / 2
        wrist = -1.0 if cfx & 1 else 1.0
        wanted = [(q[1:] - middle) / (half * room), np.sin(q[3]), wrist * np.sin(q[5]), qd[1:] / (V[1:] * T)]
        wanted += [qdd[1:] / (A[1:] * T**2) for qdd in qdds]
        wanted += [caps[0] * v / T, caps[2] * v / T, w / (V[0] * T)]
        for a, b in zip(acc, rail_acc, strict=True):
            wanted += [caps[1] * a / T**2, b / (A[0] * T**2)]
        np.testing.assert_allclose(got, np.hstack(wanted), rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("sides", ["l", "lr"])
def test_dwell_rows_are_the_self_motion_over_its_limits(axes: Axes, stages: Stages, sides: str) -> None:
    rng = np.random.default_rng(12)
    block = stages.dwell_node(sides)
    for X_0, d, cfx in poses(axes, rng, 6):
        w, T, acc = rng.normal(), rng.uniform(0.3, 2), rng.normal(size=len(sides))
        q, qd, _ = motion_at(axes, X_0, X_0, cfx, 0.0, d, 0.0, w, 0.0, 0.0)
        qdds = [motion_at(axes, X_0, X_0, cfx, 0.0, d, 0.0, w, 0.0, b)[2] for b in acc]
        p = parameters(axes, X_0, X_0, cfx, q[1:], axes.velocity, axes.acceleration, np.ones(3), np.ones(6))
        got = np.ravel(block.g(np.r_[d, w, acc, T], p))
        wanted = [(q[1:] - (axes.upper + axes.lower)[1:] / 2) / ((axes.upper - axes.lower)[1:] / 2), np.sin(q[3])]
        wanted += [(-1.0 if cfx & 1 else 1.0) * np.sin(q[5]), qd[1:] / (axes.velocity[1:] * T)]
        wanted += [qdd[1:] / (axes.acceleration[1:] * T**2) for qdd in qdds]
        wanted += [w / (axes.velocity[0] * T)] + [b / (axes.acceleration[0] * T**2) for b in acc]
        np.testing.assert_allclose(got, np.hstack(wanted), rtol=1e-9, atol=1e-9)


def test_stop_rows_vanish_at_the_self_motion_and_nowhere_else(axes: Axes, stages: Stages) -> None:
    rng = np.random.default_rng(13)
    for X_0, d, cfx in poses(axes, rng, 6):
        w = rng.normal()
        q, qd, _ = motion_at(axes, X_0, X_0, cfx, 0.0, d, 0.0, w, 0.0, 0.0)
        X = axes.in_base(X_0 @ inverse_pose(X_FT))
        path = PathConstants(X[:3, 3], np.zeros(3), X[:3, :3], np.array([1.0, 0, 0]), 0.0, np.zeros(3))
        p = np.r_[path.vector(), BranchSigns.from_cfx(cfx).vector(), q[1:]]
        off = rng.normal(size=12) * 0.01
        got = np.ravel(stages.stop().g(np.r_[d, w, q[1:] + off[:6], qd[1:] + off[6:]], p))
        np.testing.assert_allclose(got[:12], off, rtol=0, atol=1e-9)
        np.testing.assert_allclose(got[12:], [np.sin(q[3]), abs(np.sin(q[5]))], atol=1e-9)
        got = np.ravel(stages.resting_stop().g(np.r_[d, q[1:] + off[:6]], p))
        np.testing.assert_allclose(got[:6], off[:6], rtol=0, atol=1e-9)


@pytest.mark.parametrize("kind", ToolRow)
@pytest.mark.parametrize("name", ["turned"])  # expressions follow the URDF, which knows no slanted rail
def test_tool_rows_are_squared_shares_of_the_caps(name: str, kind: ToolRow) -> None:
    axes = mounted(name)
    stages = Stages(axes.robot.arm, axes.rail_axis, axes.lower, axes.upper)
    rng = np.random.default_rng(14)
    symbol = ca.SX.sym("q", 7)
    flange = ca.Function("flange", [symbol], list(forward(axes.robot, symbol)))
    block = stages.tool_row(flange, X_FT[:3, 3], kind)
    straight = stages.straight_tool_row(flange, X_FT[:3, 3], kind)

    def share(q: Array, v: Array, a: Array, T: float, cap: float) -> float:
        V, A = forward_velocity(axes.robot, q, v / T, X_FT), forward_acceleration(axes.robot, q, v / T, a / T**2, X_FT)
        value = {ToolRow.SPEED: V[:3], ToolRow.ACCELERATION: A[:3], ToolRow.REORIENTATION: V[3:]}[kind]
        return float(np.sum((value / cap) ** 2))

    for arm in safe_arm(rng, axes, 10):
        q, v, a = np.r_[rng.uniform(0, 1), arm], rng.normal(size=7), rng.normal(size=7) * 5
        T, cap = rng.uniform(0.3, 2), rng.uniform(0.5, 5)
        acc = a if kind is ToolRow.ACCELERATION else []
        assert float(block.g(np.r_[q, v, acc, T], [cap])) == pytest.approx(share(q, v, a, T, cap), rel=1e-9)
        q_a, q_b, s, sv, sa = q, q + rng.normal(size=7), rng.uniform(), rng.normal(), rng.normal() * 4
        way = q_b - q_a
        acc = [sa] if kind is ToolRow.ACCELERATION else []
        wanted = share(q_a + s * way, sv * way, sa * way, T, cap)
        assert float(straight.g(np.r_[s, sv, acc, q_a, q_b, T], [cap])) == pytest.approx(wanted, rel=1e-9)
    assert block.upper.tolist() == [1.0]


def test_small_blocks_say_what_their_names_say(stages: Stages) -> None:
    rng = np.random.default_rng(15)
    x0, v0, a, h = rng.normal(size=4)
    exact = [x0 + h * v0 + a * h * h / 2, v0 + a * h]
    np.testing.assert_allclose(np.ravel(stages.chain().g([x0, v0, a, *exact], [h])), 0, atol=1e-15)
    np.testing.assert_allclose(np.ravel(stages.zone_chain().g([x0, v0, a, *exact, h], [])), 0, atol=1e-15)
    np.testing.assert_allclose(np.ravel(stages.chain().g([x0, v0, a, exact[0] + 1, exact[1] + 2], [h])), [1, 2])
    assert float(stages.zones().g([0.1, 0.05, 0.1], [4])) == pytest.approx(0.0, abs=1e-15)
    assert float(stages.speed_link().g([0.5, 0.75, 1.5], [])) == 0.0
    got = np.ravel(stages.axis_node("lr").g([1.2, 3.0, -4.0, 0.5], [2.0, 10.0]))
    np.testing.assert_allclose(got, [1.2 / 1.0, 3 / 2.5, -4 / 2.5])
    got = np.ravel(stages.straight_axis().g([0.2, 1.2, 3.0, 5.0], [2.0, 10.0]))
    np.testing.assert_allclose(got, [1.5, 0.5])
    # a share of the way in T = 2 at top speed 0.8 and acceleration 2: 1/0.8 + 0.8/2 = 1.65 s
    assert float(stages.trapezoid().g([0.8, 2.0, 2.0], [])) == pytest.approx(0.35)
    got = np.ravel(stages.share_node("l").g([0.5, 3.0, 0.8, 2.0, 2.0], []))
    np.testing.assert_allclose(got, [1.1, 5.0, 11.0])


def test_axis_reach_rows_are_distances_to_the_reachable_interval(stages: Stages) -> None:
    """From rest, T = 2, V = 1, A = 2: 1.5 m either way; and |v1 - v0| <= A T."""
    got = np.ravel(stages.axis_reach().g([0.0, 0.0, 1.4, 0.0, 2.0], [1.0, 2.0]))
    np.testing.assert_allclose(got, [0.1, 2.9, 4.0, 4.0])
    got = np.ravel(stages.axis_reach().g([1.0, -0.5, 0.2, 0.75, 2.0], [1.0, 2.0]))
    np.testing.assert_allclose(got[2:], [2.75, 5.25])
    # -0.5 up to 1 in 0.75 s (0.1875 m), 1.125 s at 1, down to 0.75 in 0.125 s (0.109375 m); 0.8 m less is wanted
    assert got[0] == pytest.approx(0.1875 + 1.125 + 0.109375 + 0.8)


def test_a_block_is_built_once_per_kind(stages: Stages) -> None:
    assert stages.path_node("lr", True, Coupling.FREE) is stages.path_node("lr", True, Coupling.FREE)
    assert stages.path_node("lr", True, Coupling.FREE) is not stages.path_node("lr", False, Coupling.FREE)
    assert len({id(stages.axis_node(sides)) for sides in ("l", "r", "lr")}) == 3
    symbol = ca.SX.sym("q", 7)
    flange = ca.Function("flange", [symbol], [symbol[:3], ca.SX.eye(3)])
    rows = [stages.tool_row(flange, np.array(o), ToolRow.SPEED) for o in ([0, 0, 0.1], [0, 0, 0.2])]
    assert rows[0] is not rows[1]
