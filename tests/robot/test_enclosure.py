"""Enclosures over the rail: random configurations must lie inside, rates included."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
from arms import KNOWN, OFFSET_WRISTS, PARALLEL, RAILS, on_rail, pin_flange, random_pose, some_arm, urdf_joints
from small_cells import MOUNTS, mounted, plant_with_rail
from tcp_motion import singularity

from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.robot.arm import wrist_section
from trajopt_cli.robot.enclosure import Enclosure, Range
from trajopt_cli.robot.inverse import representatives
from trajopt_cli.robot.model import RobotModel
from trajopt_cli.robot.parallel_arm import ParallelArm
from trajopt_cli.trajectories.axes import Axes

TURN = 2 * np.pi


def enclosed(axes: Axes, X: Array, nodes: Array) -> Enclosure:
    limits = replace(axes.robot.profile(), lower=axes.lower, upper=axes.upper)
    return axes.robot.enclose(X, nodes, limits)


def wrist_rates(axes: Axes, q: Array) -> Array:
    """Rates (n, 3) of the first three joints per metre of rail while the wrist centre stands still in the world."""
    X_FT = pose(np.eye(3), [0.0, 0.0, -axes.robot.arm.c4])
    J = axes.jacobian(q, X_FT)[:, :3]
    return -np.linalg.solve(J[:, :, 1:4], J[:, :, :1])[..., 0]


def poses(axes: Axes, rng: np.random.Generator, n: int, d: float) -> list[Array]:
    """Flange poses around the arm as it stands at rail d, near and far, some straight above axis 1."""
    out = []
    for i in range(n):
        axis = rng.normal(size=3)
        R = rotation_about(axis / np.linalg.norm(axis), rng.uniform(0, np.pi))
        p = rng.uniform([-0.9, -0.9, -0.4], [0.9, 0.9, 1.2])
        if i % 6 == 0:  # wrist centre that passes close to axis 1
            p = axes.robot.arm.c4 * R[:, 2] + np.array([*rng.normal(size=2) * 1e-3, rng.uniform(0.5, 0.9)])
        out.append(axes.robot.base(np.array(d)) @ pose(R, p))
    return out


@pytest.mark.parametrize("width", [2.5e-3, 0.04, 0.3])
@pytest.mark.parametrize("mount", MOUNTS)
def test_random_configurations_lie_inside(mount: str, width: float) -> None:
    axes = mounted(mount, (-1.5, 1.5))
    rng = np.random.default_rng(int(width * 1e4))
    nodes = np.arange(-1.2, 1.2, width)
    checked, tight = 0, 0
    for X in poses(axes, rng, 18, 0.0):
        e = enclosed(axes, X, nodes)
        d = rng.uniform(nodes[0], nodes[-1], 400)
        arm = axes.inverse(np.broadcast_to(X, (400, 4, 4)), d)
        interval = np.searchsorted(nodes, d, side="right") - 1
        for cfx in range(8):
            row = 2 * bool(cfx & 4) + bool(cfx & 2)
            q = arm[:, cfx]
            low, high = axes.lower[1:4], axes.upper[1:4]
            turned = q[:, :3, None] + TURN * np.array([-1, 0, 1])
            inside = (turned >= low[:, None] + 1e-9) & (turned <= high[:, None] - 1e-9)
            ok = np.all(inside.any(axis=2), axis=1) & ~np.isnan(q[:, 0])
            if not ok.any():
                continue
            i, q = interval[ok], q[ok]
            assert np.all(e.alive[row, i]), f"{mount}: a reachable interval is given up, cfx {cfx}"
            # a joint may be met a turn away, if the enclosure holds that turn
            for j in range(3):
                values = np.where(inside[ok, j], turned[ok, j], np.nan)
                lo, hi = e.q.lo[j, row, i, None], e.q.hi[j, row, i, None]
                assert np.all(np.any((values >= lo - 1e-12) & (values <= hi + 1e-12), axis=1)), (
                    f"{mount}: joint_{j + 1}, cfx {cfx}, outside its enclosure at rail {d[ok]}"
                )
            far = (np.abs(np.cos(q[:, 2])) > 1e-5) & (axis_distance(axes, q) > 1e-5)
            rate = wrist_rates(axes, np.column_stack([d[ok], q])[far])
            for j in range(3):
                lo, hi = e.rate.lo[j, row, i[far]], e.rate.hi[j, row, i[far]]
                room = 1e-9 * (1 + np.abs(rate[:, j]))
                assert np.all((rate[:, j] >= lo - room) & (rate[:, j] <= hi + room)), (mount, j, cfx)
            checked += int(ok.sum())
            tight += int(np.sum(e.q.hi[:, row, i] - e.q.lo[:, row, i] < 0.1) // 3)
    assert checked > 5000
    if width < 0.01:
        assert tight > 0.95 * checked  # an enclosure that says nothing would pass all of the above


def axis_distance(axes: Axes, q: Array) -> Array:
    arm = axes.robot.arm
    return np.abs(arm.a1 + arm.c2 * np.sin(q[:, 1]) + arm.c3 * np.cos(q[:, 1] + q[:, 2]))


def test_out_of_reach_is_given_up() -> None:
    axes = Axes.of(plant_with_rail((-1.5, 1.5)))
    X = axes.robot.base(np.array(0.0)) @ pose(np.eye(3), [0.5, 0.0, 0.3])
    e = enclosed(axes, X, np.array([-1.4, -1.39, 1.39, 1.4]))
    assert not np.any(e.alive[:, [0, 2]])
    far = axes.robot.base(np.array(0.0)) @ pose(np.eye(3), [1.2, 0.0, 0.3])
    assert not np.any(enclosed(axes, far, np.linspace(-1.4, 1.4, 200)).alive)


def test_ranges_hold_every_combination_of_their_members() -> None:
    rng = np.random.default_rng(4)
    lo = rng.normal(size=(2, 500))
    a, b = (Range(x, x + rng.uniform(0, 2, 500)) for x in lo)
    positive = Range(np.abs(b.lo), np.abs(b.lo) + 1)
    for _ in range(20):
        x, y = (r.lo + rng.uniform(0, 1, 500) * (r.hi - r.lo) for r in (a, b))
        z = positive.lo + rng.uniform(0, 1, 500) * (positive.hi - positive.lo)
        for value, r in (
            (x + y, a + b),
            (x - y, a - b),
            (x * y, a * b),
            (-1.7 * x, a.scaled(-1.7)),
            (x * x, a.square()),
            (x / z, a.over(positive)),
        ):
            assert np.all((value >= r.lo - 1e-12) & (value <= r.hi + 1e-12))
        assert np.all(np.abs(x) <= a.magnitude())
    crossing = Range(np.array([-1.0]), np.array([2.0]))
    assert (crossing.square().lo[0], crossing.square().hi[0]) == (0.0, 4.0)


@pytest.mark.parametrize("mount", MOUNTS)
def test_rates_on_a_way_of_the_tool_lie_inside(mount: str) -> None:
    """The first three joints' rates as the flange follows a twist with the rail at rest, against the Jacobian's."""
    axes = mounted(mount, (-1.5, 1.5))
    rng = np.random.default_rng(7)
    nodes = np.arange(-1.2, 1.2, 0.02)
    limits = replace(axes.robot.profile(), lower=axes.lower, upper=axes.upper)
    checked, tight = 0, 0
    for X in poses(axes, rng, 20, 0.0):
        twist = rng.normal(size=6) * [0.3, 0.3, 0.3, 1, 1, 1]
        e = axes.robot.enclose(X, nodes, limits, twist)
        assert e.way is not None
        d = rng.uniform(nodes[0], nodes[-1], 200)
        arm = axes.inverse(np.broadcast_to(X, (200, 4, 4)), d)
        for cfx in range(8):
            row, q = 2 * bool(cfx & 4) + bool(cfx & 2), arm[:, cfx]
            whole = np.column_stack([d, q])
            with np.errstate(invalid="ignore"):
                ok = (np.abs(np.cos(q[:, 2])) > 1e-3) & (np.abs(np.sin(q[:, 4])) > 1e-2) & ~np.isnan(q[:, 0])
            ok[ok] &= axis_distance(axes, q[ok]) > 1e-3
            if not ok.any():
                continue
            i = np.searchsorted(nodes, d[ok], side="right") - 1
            rate = np.linalg.solve(axes.jacobian(whole[ok], np.eye(4))[:, :, 1:], twist)[:, :3]
            lo, hi = (x[:, row, i].T for x in (e.way.lo, e.way.hi))
            slack = 1e-7 * (1 + np.abs(rate))
            assert np.all((lo - slack <= rate) & (rate <= hi + slack)), f"{mount}, cfx {cfx}"
            checked += rate.size
            tight += int(np.sum(hi - lo < 0.2 + np.abs(rate)))
    assert checked > 3000
    assert tight > 0.5 * checked


NAMED = [("irb1200", rail) for rail in RAILS] + [("puma560", rail) for rail in RAILS]
NAMED += [("linked 3", "oblique"), ("linked 4", "floor"), ("linked 6", "vertical")]
NAMED += [("ur10e", "floor"), ("ur5e", "overhead"), ("parallel 0", "vertical"), ("parallel 1", "oblique")]


@pytest.fixture(params=[*NAMED, *((20 + i, rail) for i, rail in enumerate(RAILS * 2))])
def railed(request: pytest.FixtureRequest, tmp_path: Path) -> RobotModel:
    """An arm of any kind on a rail in any direction."""
    name, rail = request.param
    chain = some_arm(name)
    if name in PARALLEL:
        chain.ranges[0] = (-np.pi, np.pi)
    return on_rail(chain, rail).load(tmp_path)


def test_every_arm_on_every_rail_is_enclosed_in_all_its_turns(railed: RobotModel) -> None:
    """Joints in every turn that their ranges hold, by the inverse; rates by pin's Jacobian at the wrist centre. Of
    three parallel axes joint 1 alone has bounds, and its rate follows from the whole arm."""
    parallel = isinstance(railed.arm, ParallelArm)
    rng, limits = np.random.default_rng(2), railed.profile()
    nodes, p_FW = np.arange(-0.9, 0.9, 0.02), wrist_in_flange(railed)
    data, model = railed.pin_model.createData(), railed.pin_model
    checked, tight = 0, 0
    once = np.flatnonzero((limits.upper - limits.lower)[1:4] <= TURN)  # the others may have the hull of several turns
    once = once[once < 1] if parallel else once
    for axes in rng.uniform(limits.lower, limits.upper, (4, 7)):
        X, twist = railed.forward(np.r_[0.0, axes[1:]]), rng.normal(size=6) * 0.5
        e = railed.enclose(X, nodes, limits, twist)
        assert e.way is not None
        d = np.r_[rng.uniform(nodes[0], nodes[-1], 40), rng.uniform(-1e-3, 1e-3, 5)]
        for k, (rail, branches) in enumerate(
            zip(d, railed.branches(np.broadcast_to(X, (len(d), 4, 4)), d), strict=True)
        ):
            i = int(np.searchsorted(nodes, rail, side="right")) - 1
            for cfx in range(8) if parallel else (0, 2, 4, 6):
                row = 2 * bool(cfx & 4) + bool(cfx & 2)
                q = representatives(branches[cfx], limits.lower[1:] + 1e-7, limits.upper[1:] - 1e-7)[:, :3]
                low, high = e.q.lo[:, row, i], e.q.hi[:, row, i]
                assert e.alive[row, i] or not len(q)
                assert np.all((q >= low - 1e-11) & (q <= high + 1e-11))
                checked += len(q)
                tight += len(q) * bool(np.all((high - low)[once] < 0.3))
                whole = np.r_[rail, branches[cfx]]
                if k % 5 or np.isnan(branches[cfx]).any() or singularity(railed, whole).min() < 1e-3:
                    continue
                turned = urdf_joints(railed, whole)
                J = pin.computeFrameJacobian(model, data, turned, model.getFrameId("tool0"), pin.LOCAL_WORLD_ALIGNED)
                J[:, 2] -= railed.linkage * J[:, 3]
                R = pin.updateFramePlacement(model, data, model.getFrameId("tool0")).rotation
                carried = np.hstack([np.eye(3), -skew(R @ p_FW)])  # velocity of the wrist centre of the flange's
                if parallel:
                    carried = np.eye(6)
                first = slice(1, 1 + len(carried))  # three joints carry the wrist centre, all six the flange
                still = -np.linalg.solve((carried @ J)[:, first], (carried @ J)[:, 0])[:3]
                moved = np.linalg.solve((carried @ J)[:, first], carried @ twist)[:3]
                for rates, found in ((still, e.rate), (moved, e.way)):
                    room = 1e-8 * (1 + np.abs(rates))
                    assert np.all((rates >= found.lo[:, row, i] - room) & (rates <= found.hi[:, row, i] + room))
    assert checked > 150
    assert tight > 0.3 * checked


@pytest.mark.parametrize("name", [*KNOWN, *range(6), "linked 1", "linked 4", "ur5e", "parallel 1"])
def test_without_a_rail_an_enclosure_is_the_posture(name: str | int, tmp_path: Path) -> None:
    """All of an interval is one place: joints and rates are those of the branches, by inverse and Jacobian."""
    chain = some_arm(name)
    chain.ranges = [(-3.5, 3.5)] * 6
    chain.ranges[2] = (-6.0, 6.0)
    robot = chain.load(tmp_path, random_pose(np.random.default_rng(1)))
    limits, rng, nodes = robot.profile(), np.random.default_rng(8), np.array([0.0, 0.3, 1.0])
    joints, checked = 1 if isinstance(robot.arm, ParallelArm) else 3, 0
    for q in rng.uniform(limits.lower, limits.upper, (6, 6)):
        X, twist = robot.forward(q), rng.normal(size=6)
        e = robot.enclose(X, nodes, limits, twist)
        assert e.way is not None
        if joints == 3:
            np.testing.assert_array_less(np.abs(e.rate.hi), 1e-8)
            np.testing.assert_array_less(np.abs(e.rate.lo), 1e-8)
        for cfx, branch in enumerate(robot.branches(X[None], None)[0]):
            row = 2 * bool(cfx & 4) + bool(cfx & 2)
            if np.isnan(branch).any():
                assert joints == 1 or not e.alive[row].any()
                continue
            assert e.alive[row].all()
            if singularity(robot, branch).min() < 0.05:
                continue
            turned = branch[:joints] + TURN * np.array([[-1], [0], [1]])
            there = (turned >= limits.lower[:joints]) & (turned <= limits.upper[:joints])
            rates = np.linalg.solve(robot.jacobian(branch), twist)[:joints]
            for low, high in zip(e.q.lo[:joints, row].T, e.q.hi[:joints, row].T, strict=True):
                np.testing.assert_allclose(low, np.where(there, turned, np.inf).min(axis=0), rtol=0, atol=1e-8)
                np.testing.assert_allclose(high, np.where(there, turned, -np.inf).max(axis=0), rtol=0, atol=1e-8)
            if joints == 3:
                for found in (e.way.lo, e.way.hi):
                    np.testing.assert_allclose(found[:, row].T, np.tile(rates, (2, 1)), rtol=1e-6, atol=1e-6)
            checked += 1
    assert checked > 15


@pytest.mark.parametrize("rail", RAILS)
def test_the_rate_of_joint_1_is_greatest_where_the_wrist_centre_is_nearest(rail: str, tmp_path: Path) -> None:
    """In an interval with that place inside, by its distance r and the rail's share across axis 1: share / r; in one
    beside it, by what is nearest there."""
    robot = on_rail(KNOWN["irb1200"](), rail).load(tmp_path)
    e = robot.X_WC0[:3, :3].T @ robot.rail_axes_W[0]
    share, nearest = float(np.hypot(e[0], e[1])), 0.4
    assert share > 0.5
    across = np.array([-e[1], e[0], 0]) / share
    R = rotation_about([0.6, 0, 0.8], 1.0)
    w = nearest * across + [0, 0, 0.6]
    X = robot.X_WC0 @ pose(R, w + robot.arm.c4 * R[:, 2])
    nodes = np.array([-0.15, 0.12, 0.3])
    found = robot.enclose(X, nodes, robot.profile()).rate
    turn = -share / nearest * np.sign(across[0] * e[1] - across[1] * e[0])
    behind = turn / (1 + (0.12 * share / nearest) ** 2)
    ends = [turn / (1 + (x * share / nearest) ** 2) for x in (-0.15, 0.3)]
    for i, (most, least) in enumerate(((turn, ends[0]), (behind, ends[1]))):
        low, high = sorted((most, least))
        np.testing.assert_allclose([found.lo[0, 0, i], found.hi[0, 0, i]], [low, high], rtol=1e-6)


def test_of_an_arm_without_a_closed_form_its_ranges_are_all_that_is_known(tmp_path: Path) -> None:
    robot = on_rail(OFFSET_WRISTS["gofa"](), "floor").load(tmp_path)
    limits, nodes = robot.profile(), np.linspace(-0.3, 0.4, 6)
    for twist in (None, np.ones(6)):
        e = robot.enclose(np.eye(4), nodes, limits, twist)
        np.testing.assert_array_equal(e.q.lo, np.broadcast_to(limits.lower[1:4, None, None], (3, 4, 5)))
        np.testing.assert_array_equal(e.q.hi, np.broadcast_to(limits.upper[1:4, None, None], (3, 4, 5)))
        assert e.alive.shape == (4, 5)
        assert e.alive.all()
        assert (e.way is None) == (twist is None)
        for rate in (e.rate, e.way or e.rate):
            assert rate.lo.shape == (3, 4, 5)
            assert np.all((rate.lo <= -1e9) & (rate.hi >= 1e9))


def wrist_in_flange(robot: RobotModel) -> Array:
    """Where axes 4, 5 and 6 meet, seen from the flange: it stays there when they turn."""
    q = np.zeros((3, 7))
    q[1, 4:], q[2, 4:] = [0.3, 0.5, -0.2], [-0.4, 0.7, 1.1]
    X = pin_flange(robot, q)
    unknown = np.hstack([X[:, :3, :3].reshape(9, 3), -np.tile(np.eye(3), (3, 1))])
    return np.linalg.lstsq(unknown, -X[:, :3, 3].ravel(), rcond=None)[0][:3]


def skew(v: Array) -> Array:
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


@pytest.mark.parametrize("cfx", [0, 2])
def test_joint_2_is_enclosed_where_the_wrist_centre_passes_straight_below_it(cfx: int, tmp_path: Path) -> None:
    """There the angle that joint 2 is counted by passes its cut, from one node of the rail to the next; its range ends
    between the two, so that no other turn of it is in range."""
    robot = on_rail(KNOWN["irb4600"](), "floor").load(tmp_path)
    arm, limits, row = robot.arm, robot.profile(), cfx // 2
    X = pose(np.eye(3), [0.0, 0.3, arm.c1 - 1.0 + arm.c4])
    below = 0.3 - arm.a1
    (at,) = robot.branches(X[None], np.array([below]))[:, cfx, 1]
    lower, upper = limits.lower.copy(), limits.upper.copy()
    lower[1:4], upper[1:4] = [-3, at - 3, -6], [3, at + 0.004, 6]
    limits, nodes = replace(limits, lower=lower, upper=upper), below + np.arange(-9.5, 9.5) * 0.02
    d = below + np.linspace(-0.0099, 0.0099, 400)
    e, checked = robot.enclose(X, nodes, limits), 0
    for rail, branches in zip(d, robot.branches(np.broadcast_to(X, (400, 4, 4)), d), strict=True):
        i = int(np.searchsorted(nodes, rail, side="right")) - 1
        for q in representatives(branches[cfx, :3], lower[1:4], upper[1:4]):
            assert e.alive[row, i]
            assert np.all((q >= e.q.lo[:, row, i]) & (q <= e.q.hi[:, row, i]))
            checked += 1
    assert checked > 200


@pytest.mark.parametrize("rail", ["overhead", "oblique"])
@pytest.mark.parametrize("name", ["irb4600", "puma560", 23])
def test_enclosures_of_narrow_intervals_are_narrow(name: str | int, rail: str, tmp_path: Path) -> None:
    """Against the inverse at places in each interval: joints by no more than their own change and what a stretched
    elbow bends by, rates likewise; and no interval is kept that the arm does not reach, or only out of its ranges."""
    chain = some_arm(name)
    chain.ranges[:3] = [(-2.9, 2.9), (-2.2, 2.6), (-3.6, 2.0)]
    robot, h = on_rail(chain, rail).load(tmp_path), 1e-3
    limits, rng = robot.profile(), np.random.default_rng(5)
    shares, checked, edges, dead, kept = np.linspace(0, 1, 6)[:-1], 0, 0, 0, 0
    lower, upper = limits.lower[1:4], limits.upper[1:4]
    for axes in rng.uniform(limits.lower, limits.upper, (4, 7)):
        X, twist = robot.forward(np.r_[0.0, axes[1:]]), rng.normal(size=6) * 0.5
        ends = [reach_ends(robot, X, side) for side in robot.rail_within(X[None])[0]]
        for begin in (ends[0] - 7.3 * h, ends[1] - 15.8 * h, -11.5 * h, rng.uniform(*ends)):
            nodes = begin + np.arange(24) * h
            e = robot.enclose(X, nodes, limits, twist)
            assert e.way is not None
            d = (nodes[:-1, None] + shares * h).ravel()
            q = robot.branches(np.broadcast_to(X, (len(d), 4, 4)), d)[:, ::2, :3]
            q = q + TURN * np.round(((lower + upper) / 2 - q) / TURN)
            room = np.minimum(q - lower, upper - q).min(axis=-1)  # (m, 4), NaN out of reach
            q, room = (x.reshape(23, len(shares), *x.shape[1:]) for x in (q, room))
            for row in range(4):
                near = np.nan_to_num(room[:, :, row], nan=-9.0).max(axis=1)
                reached = np.array([near[max(0, i - 4) : i + 5].max() for i in range(23)])
                assert not np.any(e.alive[row, 4:-4] & (reached[4:-4] < -4))
                out = reached[4:-4] < -0.2
                dead += int(np.sum(~e.alive[row, 4:-4] & out))
                kept += int(np.sum(e.alive[row, 4:-4] & out))  # where joint 1's angle passes its cut
                for i in np.flatnonzero(near > 0.2):
                    mine, (low, high) = q[i, :, row], (x[:, row, i] for x in (e.q.lo, e.q.hi))
                    whole = np.column_stack([mine, np.zeros((len(mine), 3))])
                    ahead = np.abs(wrist_section(robot.arm, whole)[0])
                    if np.nanmin(ahead) < 0.15:
                        continue  # near what is singular
                    if np.isnan(mine).any():
                        edges += 1
                        assert np.all(
                            (high - low)[1:] < np.nanmax(mine, axis=0)[1:] - np.nanmin(mine, axis=0)[1:] + 0.3
                        )
                        continue
                    t = robot.arm.angles(whole)
                    bend = np.abs(np.cos(t[:, 2] + robot.arm.bend)).min()
                    if bend < 0.1 or np.ptp(mine[:, 0]) > 0.05 or np.cos(t[:, 0]).min() < -0.3:
                        continue  # near a stretched elbow, and near the cut of joint 1's angle
                    rate = np.diff(mine, axis=0) / (h * shares[1])
                    change = 40 * h * (1 + np.abs(rate).max()) ** 2 / bend**3
                    for rates in (e.rate, e.way):
                        spread = rates.hi[:, row, i] - rates.lo[:, row, i]
                        assert np.all(spread < change * (1 + np.abs(rates.hi[:, row, i])))
                    once = 1.3 * np.ptp(mine, axis=0) + change * h + 5e-9
                    assert np.all(high - low < once * [1, 1, 3] + [0, 0, 6 * h / bend])
                    checked += 1
    assert checked > 200
    assert edges >= 4
    assert dead > 200 + 50 * kept


def reach_ends(robot: RobotModel, X: Array, far: float) -> float:
    """How far the rail may go, from 0 towards a place out of reach, until no branch reaches a pose."""
    near = 0.0
    for _ in range(16):
        middle = (near + far) / 2
        out = np.isnan(robot.branches(X[None], np.array([middle]))).any(axis=-1).all()
        near, far = (near, middle) if out else (middle, far)
    return near
