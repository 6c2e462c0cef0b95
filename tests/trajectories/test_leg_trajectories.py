"""Leg motions as numbers: sampled and split without loss; profiles that can be written down; rows of a file."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from small_cells import MOUNTS, mounted, plant_without_rail

from trajopt_cli.geometry import Array, inverse_pose, pose, rotation_about
from trajopt_cli.path.arc import Arc
from trajopt_cli.path.line import Line
from trajopt_cli.plan.output_rows import output_rows
from trajopt_cli.settings import DEFAULT
from trajopt_cli.timing.double_integrator import reach, shortest_time
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.leg_trajectories import (
    JointNodes,
    JointProfiles,
    PathLeg,
    halved,
    integrate,
    parabola,
    split,
    unwind,
)
from trajopt_cli.trajectories.profiles import hold, profiles
from trajopt_cli.trajectory import hermite

X_FT = pose(rotation_about([0.6, 0, 0.8], 0.7), [0.05, -0.03, 0.12])
UNEVEN = np.array([0.0, 0.13, 0.3, 0.45, 0.7, 0.86, 1.0])
V = np.array([1.0, 3.5, 3.5, 4.5, 6.3, 6.3, 7.8])
A = np.array([3.0, 15, 12.5, 20, 40, 40, 60])


def exact(grid: Array, x0: float, x1: float, v0: float, v1: float, rng: np.random.Generator) -> tuple[Array, ...]:
    """Node values of a motion with constant acceleration per interval that meets four end conditions."""
    h = np.diff(grid)
    a = rng.normal(size=len(h))
    # speed and displacement are linear in a: correct two of them
    after = 1 - grid[:-1] - h / 2
    M = np.stack([h, h * after])
    wanted = np.array([v1 - v0, x1 - x0 - v0])
    a = a + M.T @ np.linalg.solve(M @ M.T, wanted - M @ a)
    v = v0 + np.concatenate([[0], np.cumsum(a * h)])
    x = x0 + np.concatenate([[0], np.cumsum(v[:-1] * h + a * h * h / 2)])
    return x, v, a


@pytest.fixture(scope="module", params=[*MOUNTS, "no rail"])
def axes(request: pytest.FixtureRequest) -> Axes:
    return Axes.of(plant_without_rail()) if request.param == "no rail" else mounted(request.param)


def path_leg(axes: Axes, cfx: int, rail: tuple[float, float], seed: int = 1, dwell: bool = False) -> PathLeg:
    """A turning line of a crooked tool in front of the arm on the given branch; the rail moves as it likes."""
    rng = np.random.default_rng(seed)
    X_BF = pose(rotation_about([0, 0, 1], 0.3) @ rotation_about([0, 1, 0], np.pi - 0.2), [0.45, 0.1, 0.4])
    X_0 = axes.robot.base(np.array(np.mean(rail))) @ X_BF @ X_FT
    X_1 = X_0 if dwell else pose(X_0[:3, :3] @ rotation_about([0, 0.6, 0.8], 0.4), X_0[:3, 3] + [0.02, -0.05, 0.06])
    s, v, a = exact(UNEVEN, 0, 0 if dwell else 1, 0, 0, rng)
    if dwell:
        s, v, a = 0 * s, 0 * v, 0 * a
    d, w, b = exact(UNEVEN, rail[0], rail[1], 0.1, -0.15, rng)
    first = axes.inverse((X_0 @ inverse_pose(X_FT))[None], d[:1])[0, cfx]
    assert not np.isnan(first).any()
    rail = (x[:, None][:, axes.layout.rail] for x in (d, w, b))
    return PathLeg(0.6, Line(X_0, X_1), X_FT, cfx, first, UNEVEN, s, v, a, *rail)


TURN_AXIS = np.array([0.48, 0.6, 0.64])


@pytest.mark.parametrize("way", ["line", "dwell", "arc", "turned line", "turned arc"])
@pytest.mark.parametrize("cfx", [0, 1])
def test_a_path_keeps_its_line_and_its_speeds_are_slopes(axes: Axes, cfx: int, way: str) -> None:
    leg = path_leg(axes, cfx, (0.45, 0.55), dwell=way == "dwell")
    if way.endswith("arc"):
        X_0, X_1 = leg.segment.pose(np.array([0.0, 1.0]))
        leg = replace(leg, segment=Arc.through(X_0, (X_0 + X_1)[:3, 3] / 2 + [0.02, 0.01, 0.0], X_1))
    if way.startswith("turned"):
        leg = leg.turning(TURN_AXIS)
        f = exact(UNEVEN, 0.2, 0.5, 0.3, -0.2, np.random.default_rng(7))
        leg = replace(leg, **{name: np.column_stack([getattr(leg, name)[:, :-1], x])
                              for name, x in zip("dwb", f, strict=True)})  # fmt: skip
    u = np.linspace(0.05, 0.95, 9)
    t = (leg.breaks()[:-1, None] + np.diff(leg.breaks())[:, None] * u).ravel()
    h = 1e-5
    at, before, after = (leg.sample(axes, t + x) for x in (0.0, -h, h))
    s, _, _ = integrate(leg.grid, leg.s, leg.v, t / leg.T)
    expected = leg.segment.pose(s)
    if leg.axis is not None:
        turn = integrate(leg.grid, leg.d[:, -1], leg.w[:, -1], t / leg.T)[0]
        expected[:, :3, :3] @= Rotation.from_rotvec(turn[:, None] * TURN_AXIS).as_matrix()
    np.testing.assert_allclose(axes.forward(at.q) @ X_FT, expected, rtol=0, atol=1e-12)
    if way == "turned line":
        assert at.tool is not None
        spin = (axes.jacobian(at.q, X_FT) @ at.qd[..., None])[..., 0]
        np.testing.assert_allclose(at.tool[:, 0], spin, rtol=0, atol=1e-10)
    scale = np.abs(at.qdd).max()
    np.testing.assert_allclose(at.qd, (after.q - before.q) / (2 * h), rtol=0, atol=1e-7 * scale)
    np.testing.assert_allclose(at.qdd, (after.qd - before.qd) / (2 * h), rtol=0, atol=1e-6 * scale)


def test_refining_keeps_a_path_to_the_last_digit(axes: Axes) -> None:
    leg = path_leg(axes, 0, (0.45, 0.55))
    fine = leg.refined().refined()
    assert fine.N == 4 * leg.N
    t = np.sort(np.random.default_rng(2).uniform(0, leg.T, 200))
    a, b = leg.sample(axes, t), fine.sample(axes, t)
    for x, y in ((a.q, b.q), (a.qd, b.qd), (a.qdd, b.qdd)):
        np.testing.assert_allclose(x, y, rtol=1e-10, atol=1e-11)
    np.testing.assert_allclose(a.q, b.q, rtol=0, atol=1e-12)


def test_nodes_of_a_path_are_its_samples(axes: Axes) -> None:
    leg = path_leg(axes, 0, (0.45, 0.55))
    for one in (leg, replace(leg.turning(TURN_AXIS), d=np.column_stack([leg.d, np.linspace(0, 0.4, leg.N + 1)]))):
        arm = one.sample(axes, one.breaks()).q[:, axes.layout.arm]
        np.testing.assert_allclose(one.node_arm(axes), arm, rtol=0, atol=1e-9)


def test_a_reference_a_turn_away_turns_the_whole_path(axes: Axes) -> None:
    leg = path_leg(axes, 0, (0.45, 0.55))
    turn = 2 * np.pi * np.array([1, 0, 0, -1, 0, 2])
    far = replace(leg, reference=leg.reference + turn)
    t = np.linspace(0, leg.T, 50)
    near, moved = (motion.sample(axes, t).q[:, axes.layout.arm] for motion in (leg, far))
    np.testing.assert_allclose(moved - near, [turn] * 50, atol=1e-9)


def test_either_side_of_a_switch(axes: Axes) -> None:
    leg = path_leg(axes, 0, (0.45, 0.55))
    at = leg.breaks()[1:-1]
    left, right = leg.sample(axes, at, right=False), leg.sample(axes, at)
    np.testing.assert_allclose(left.qd, right.qd, atol=1e-8)
    np.testing.assert_allclose(left.qdd[:, axes.layout.rail], leg.b[:-1] / leg.T**2, rtol=1e-9)
    np.testing.assert_allclose(right.qdd[:, axes.layout.rail], leg.b[1:] / leg.T**2, rtol=1e-9)


def test_unwind_follows_across_the_cut() -> None:
    smooth = np.outer(np.linspace(0, 4, 60), np.ones(6)) + 2.0
    cut = (smooth + np.pi) % (2 * np.pi) - np.pi
    np.testing.assert_allclose(unwind(cut, smooth[0]), smooth, atol=1e-12)
    np.testing.assert_allclose(unwind(cut, smooth[0] - 2 * np.pi + 0.5), smooth - 2 * np.pi, atol=1e-12)


def test_splitting_is_exact_in_position_and_speed() -> None:
    rng = np.random.default_rng(3)
    x, v, a = exact(UNEVEN, 0.2, 1.4, 0.7, -0.3, rng)
    finer = halved(UNEVEN)
    xs, vs, as_ = split(UNEVEN, x, v, a)
    h = np.diff(finer)
    np.testing.assert_allclose(xs[1:], xs[:-1] + h * vs[:-1] + as_ * h * h / 2, rtol=0, atol=1e-14)
    np.testing.assert_allclose(vs[1:], vs[:-1] + as_ * h, rtol=0, atol=1e-13)
    np.testing.assert_array_equal(xs[::2], x)


def test_a_parabola_rests_at_both_ends() -> None:
    grid = np.linspace(0, 1, 7)
    s, v, a = parabola(grid)
    h = np.diff(grid)
    np.testing.assert_allclose(s[1:], s[:-1] + h * v[:-1] + a * h * h / 2, atol=1e-15)
    np.testing.assert_allclose(v[1:], v[:-1] + a * h, atol=1e-15)
    assert (s[0], s[-1], v[0], v[-1]) == (0, 1, 0, 0)


def test_joint_nodes_are_refined_exactly(axes: Axes) -> None:
    rng = np.random.default_rng(4)
    s, v, a = exact(UNEVEN, 0, 1, 0, 0, rng)
    q_0, q_1 = rng.normal(size=(2, 7))
    way = q_1 - q_0
    leg = JointNodes(0.8, UNEVEN, q_0 + s[:, None] * way, v[:, None] * way, a[:, None] * way)
    fine = leg.refined()
    t = np.sort(rng.uniform(0, 0.8, 100))
    one, two = leg.sample(axes, t), fine.sample(axes, t)
    for x, y in ((one.q, two.q), (one.qd, two.qd), (one.qdd, two.qdd)):
        np.testing.assert_allclose(x, y, rtol=0, atol=1e-10)
    share, _, _ = integrate(UNEVEN, s, v, t / 0.8)
    np.testing.assert_allclose(one.q, q_0 + share[:, None] * (q_1 - q_0), atol=1e-12)
    np.testing.assert_allclose(one.qd[1:-1], np.gradient(one.q, t, axis=0)[1:-1], atol=0.3)


# ---- profiles of joint moves


def moves(rng: np.random.Generator, n: int, collide: float) -> list[tuple[Array, ...]]:
    """Random ends; some axes nearly repeat another's share of its limits, so that their switches almost coincide."""
    out = []
    for _ in range(n):
        way = rng.normal(size=7) * np.array([0.4, 1, 1, 1, 1, 1, 1]) * 10 ** rng.uniform(-2, 0)
        qd_0, qd_1 = (rng.choice([0.0, 0.4]) * V * rng.uniform(-1, 1, 7) for _ in range(2))
        if rng.uniform() < 0.5:
            qd_0, qd_1 = 0 * qd_0, 0 * qd_1
            way[1:] = way[0] * A[1:] / A[0] * (1 + collide * rng.normal(size=6)) * rng.choice([-1, 1], 6)
        q_0 = rng.normal(size=7)
        out.append((q_0, qd_0, q_0 + way, qd_1))
    return out


def ends(leg: JointProfiles) -> tuple[Array, Array, Array]:
    """Position and speed at the end, and every axis' largest speed, summed up phase by phase."""
    x, v = leg.q_0.copy(), leg.qd_0.copy()
    top = np.abs(v)
    for k in range(3):
        h = leg.times[:, k + 1] - leg.times[:, k]
        x, v = x + v * h + leg.accelerations[:, k] * h * h / 2, v + leg.accelerations[:, k] * h
        top = np.maximum(top, np.abs(v))
    return x, v, top


def check(leg: JointProfiles, q_1: Array, qd_1: Array) -> None:
    x, v, top = ends(leg)
    np.testing.assert_allclose(x, q_1, rtol=0, atol=1e-11)
    np.testing.assert_allclose(v, qd_1, rtol=0, atol=1e-10)
    assert np.all(top <= V * (1 + 1e-9)), (top / V).max()
    assert np.all(np.abs(leg.accelerations) <= A[:, None] * (1 + 1e-9)), np.max(np.abs(leg.accelerations) / A[:, None])
    gaps = np.diff(leg.breaks())
    assert np.all((gaps >= 1e-5) | (gaps <= 1e-9)), gaps
    assert np.all(np.diff(leg.times, axis=1) >= -1e-12)
    assert leg.times[:, 0].tolist() == [0.0] * 7
    np.testing.assert_allclose(leg.times[:, 3], leg.T, rtol=0, atol=1e-15)


@pytest.mark.parametrize("collide", [1e-2, 1e-4, 1e-5])
@pytest.mark.parametrize("slack", [0.0, 0.02, 1.0])
def test_profiles_arrive_within_limits_with_their_switches_apart(collide: float, slack: float) -> None:
    rng = np.random.default_rng(int(1 / collide))
    for q_0, qd_0, q_1, qd_1 in moves(rng, 60, collide):
        least = float(shortest_time(q_1 - q_0, qd_0, qd_1, V, A))
        wanted = least * (1 + slack)
        D = q_1 - q_0
        later = wanted + np.array([0.0, 1e-4, 9e-4])[:, None]
        if np.any(reach(later, qd_0, qd_1, V, A) < D) or np.any(reach(later, -qd_0, -qd_1, V, A) < -D):
            continue  # a blocked time lies between, or begins at once: the move cannot be lengthened by a hair
        leg = profiles(q_0, qd_0, q_1, qd_1, V, A, wanted, common=False, settings=DEFAULT)
        assert wanted - 1e-12 <= leg.T <= wanted + 1e-3
        check(leg, q_1, qd_1)


def test_axes_at_their_top_speed_stay_under_it_when_their_switches_are_moved_apart() -> None:
    """Two axes cruise at full speed and would switch 10 us from each other; ramping more gently means cruising faster,
    so the move has to last longer."""
    T = 1.0
    top_a = A.copy()
    top_a[1] = V[1] / (V[0] / A[0] + 1e-5)
    way = V * (T - V / top_a) * np.array([1, 1, 0.3, 0.3, 0.3, 0.3, 0.3])
    zero = np.zeros(7)
    leg = profiles(zero, zero, way, zero, V, top_a, T, common=False, settings=DEFAULT)
    x, v, top = ends(leg)
    np.testing.assert_allclose(x, way, atol=1e-11)
    np.testing.assert_allclose(v, zero, atol=1e-11)
    assert np.all(top <= V * (1 + 1e-9)), (top / V).tolist()
    assert np.all(np.abs(leg.accelerations) <= top_a[:, None] * (1 + 1e-9))


def test_a_common_profile_is_straight_and_no_faster_than_the_slowest_axis() -> None:
    rng = np.random.default_rng(5)
    zero = np.zeros(7)
    for _ in range(100):
        q_0 = rng.normal(size=7)
        way = rng.normal(size=7) * 10 ** rng.uniform(-3, 0)
        leg = profiles(q_0, zero, q_0 + way, zero, V, A, 0.0, common=True, settings=DEFAULT)
        check(leg, q_0 + way, zero)
        v, a = np.min(V / np.abs(way)), np.min(A / np.abs(way))
        T = 1 / v + v / a if v * v < a else 2 / np.sqrt(a)
        assert T - 1e-12 <= leg.T <= T + 2e-4
        shares = leg.accelerations / way[:, None]
        np.testing.assert_allclose(shares, np.broadcast_to(shares[0], shares.shape), rtol=1e-9)
        assert np.all(leg.times == leg.times[0])


def test_a_common_cruise_too_short_to_write_becomes_one_switch() -> None:
    zero = np.zeros(7)
    way = np.zeros(7)
    for cruise in (1e-6, 1.9e-5, 4e-5):
        way[0] = V[0] ** 2 / A[0] + V[0] * cruise
        leg = profiles(zero, zero, way, zero, V, A, 0.0, common=True, settings=DEFAULT)
        check(leg, way, zero)
    still = profiles(zero, zero, zero, zero, V, A, 0.0, common=True, settings=DEFAULT)
    assert not np.any(still.accelerations)


def test_holding_rests() -> None:
    q = np.arange(7.0)
    leg = hold(0.3, q)
    sample = leg.sample(mounted("as it is"), np.linspace(0, 0.3, 7))
    np.testing.assert_array_equal(sample.q, np.tile(q, (7, 1)))
    assert not np.any(sample.qd)
    assert not np.any(sample.qdd)


def test_profiles_are_continuous_where_they_switch() -> None:
    rng = np.random.default_rng(6)
    axes = mounted("as it is")
    for q_0, qd_0, q_1, qd_1 in moves(rng, 20, 1e-2):
        leg = profiles(q_0, qd_0, q_1, qd_1, V, A, 0.0, common=False, settings=DEFAULT)
        t = leg.breaks()
        left, right = leg.sample(axes, t, right=False), leg.sample(axes, t)
        np.testing.assert_allclose(left.q, right.q, rtol=0, atol=1e-12)
        np.testing.assert_allclose(left.qd, right.qd, rtol=0, atol=1e-11)
        np.testing.assert_allclose(right.q[0], q_0, rtol=0, atol=1e-15)
        np.testing.assert_allclose(left.q[-1], q_1, rtol=0, atol=1e-11)
        inside = np.concatenate([np.linspace(a, b, 9)[1:-1] for a, b in pairwise(t) if b - a > 1e-4])
        h = 1e-6
        near = [leg.sample(axes, inside + x) for x in (-h, 0.0, h)]
        np.testing.assert_allclose(near[1].qd, (near[2].q - near[0].q) / (2 * h), rtol=0, atol=1e-7)
        np.testing.assert_allclose(near[1].qdd, (near[2].qd - near[0].qd) / (2 * h), rtol=0, atol=1e-6)


# ---- rows of a file


@pytest.fixture(scope="module")
def written() -> tuple[Axes, list[object], Array]:
    """Joint move, line, dwell and a rest: stops fit together in position and speed."""
    axes = mounted("as it is")
    line = path_leg(axes, 0, (0.45, 0.55))
    begin = line.sample(axes, np.zeros(1))
    end = line.sample(axes, np.array([line.T]), right=False)
    dwell = path_leg(axes, 0, (0.45, 0.55), dwell=True)
    zero = np.zeros(7)
    home = np.r_[0.0, 0, 0, 0, 0, np.pi / 6, 0]
    a = profiles(home, zero, begin.q[0], begin.qd[0], V, A, 0.0, common=False, settings=DEFAULT)
    b = profiles(end.q[0], end.qd[0], home, zero, V, A, 0.0, common=False, settings=DEFAULT)
    c = hold(0.123456, home)
    assert dwell.N == line.N
    return axes, [a, line, b, c], home


def test_rows_stand_at_every_boundary_and_switch_and_each_millisecond(written: tuple) -> None:
    axes, legs, home = written
    trajectory, bounds = output_rows(axes, legs, home)
    t = trajectory.t
    np.testing.assert_allclose(bounds, np.concatenate([[0], np.cumsum([leg.T for leg in legs])]), rtol=0, atol=1e-15)
    assert np.all(np.isin(bounds, t))
    assert np.min(np.diff(t)) >= 1e-5
    switches = np.concatenate([bound + leg.breaks() for bound, leg in zip(bounds, legs, strict=False)])
    nearest = np.min(np.abs(switches[:, None] - t), axis=1)
    assert nearest.max() < 1e-9
    grid = np.arange(int(t[-1] / DEFAULT.row_step) + 1) * DEFAULT.row_step
    free = np.min(np.abs(grid[:, None] - switches), axis=1) >= DEFAULT.least_row_step * 1.000001
    at_rest = [k for k, leg in enumerate(legs) if leg.resting().all()]
    assert len(at_rest) == 1
    (rest,) = at_rest
    inside = (grid > bounds[rest]) & (grid < bounds[rest + 1])
    assert inside.sum() > 10
    assert np.min(np.abs(grid[free][:, None] - t), axis=1).max() < 1e-12
    assert np.sum(free) > 500
    assert np.all(np.diff(t) <= DEFAULT.row_step + DEFAULT.least_row_step)  # in the rest as well
    np.testing.assert_array_equal(trajectory.q[-1], home)
    assert not np.any(trajectory.qd[-1])


def test_hermite_between_the_rows_is_the_motion(written: tuple) -> None:
    axes, legs, home = written
    trajectory, bounds = output_rows(axes, legs, home)
    for leg, begin in zip(legs, bounds, strict=False):
        u = (np.arange(3000) + 0.5) / 3000 * leg.T
        q, qd, qdd = hermite(trajectory, begin + u)
        sample = leg.sample(axes, u)
        np.testing.assert_allclose(q, sample.q, rtol=0, atol=1e-9)
        np.testing.assert_allclose(qd, sample.qd, rtol=0, atol=1e-6)
        if isinstance(leg, JointProfiles):
            away = np.min(np.abs(u[:, None] - leg.breaks()), axis=1) > 1e-6
            np.testing.assert_allclose(qdd[away], sample.qdd[away], rtol=0, atol=1e-4)


def test_switches_all_but_one_are_written_once() -> None:
    """Two axes whose switches lie 1e-12 s apart give one row."""
    axes = mounted("as it is")
    times = np.tile([0.0, 0.01, 0.02, 0.03], (7, 1))
    times[3, 1] += 1e-12
    times[4, 2] = 0.03 - 1e-12
    leg = JointProfiles(0.03, np.zeros(7), np.ones(7), times, np.zeros((7, 3)))
    trajectory, bounds = output_rows(axes, [leg, leg], np.zeros(7))
    assert np.min(np.diff(trajectory.t)) >= 1e-5
    assert np.all(np.isin(bounds, trajectory.t))
    assert len(trajectory.t) == 61


def test_without_a_rail_six_axes_are_written() -> None:
    axes = Axes.of(plant_without_rail())
    zero = np.zeros(6)
    q = np.full(6, 0.3)
    leg = profiles(zero, zero, q, zero, axes.velocity, axes.acceleration, 0.0, common=False, settings=DEFAULT)
    trajectory, _ = output_rows(axes, [leg], q)
    assert trajectory.names == tuple(f"joint_{i}" for i in range(1, 7))
    np.testing.assert_allclose(trajectory.q[-1], q)
