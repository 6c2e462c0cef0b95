"""Arms of every kind against pin: forward, Jacobian and its rate, all branches of the inverse, what branches are."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pinocchio as pin
import pytest
from arms import KNOWN, PARALLEL, pin_flange, random_pose, some_arm
from tcp_motion import singularity

from trajopt_cli.geometry import inverse_pose
from trajopt_cli.motion import ConfData
from trajopt_cli.robot.arm import wrist_section
from trajopt_cli.robot.inverse import branch_margins, confdata, confdata_admits, inverse, representatives, solutions
from trajopt_cli.robot.parallel_arm import ParallelArm

ARMS = [*KNOWN, *range(8), *PARALLEL, *(f"parallel {seed}" for seed in range(6))]
ALL = 5000  # configurations of one arm; the others have fewer


@pytest.fixture(scope="module", params=ARMS)
def arm(request, tmp_path_factory):
    """An arm of some kind, its base anywhere in the world."""
    return some_arm(request.param).load(tmp_path_factory.mktemp("arm"), random_pose(np.random.default_rng(1)))


def configurations(robot, n, seed=3):
    limits = robot.profile()
    return np.random.default_rng(seed).uniform(limits.lower, limits.upper, (n, 6))


def test_forward_is_pins(arm):
    q = configurations(arm, 200)
    np.testing.assert_allclose(arm.forward(q), pin_flange(arm, q), rtol=0, atol=1e-13)


def test_the_wrist_centre_in_the_arms_plane_is_where_pin_has_it(arm):
    """How far before axis 1 and how high: of the upper arm's end by the frames of pin, in the canonical base."""
    if isinstance(arm.arm, ParallelArm) or np.any(arm.arm.wrist):
        pytest.skip("its wrist has no centre")
    q = configurations(arm, 50)
    X_CK = inverse_pose(arm.X_WC0) @ pin_flange(arm, q) @ inverse_pose(arm.arm.X_KF)
    centre = X_CK[:, :3, 3] - arm.arm.c4 * X_CK[:, :3, 2]
    before, height = wrist_section(arm.arm, q)
    np.testing.assert_allclose(height, centre[:, 2], rtol=0, atol=1e-12)
    np.testing.assert_allclose(before**2 + arm.arm.b**2, (centre[:, :2] ** 2).sum(axis=1), rtol=0, atol=1e-12)


def test_jacobian_and_its_rate_are_pins(arm, X_FT):
    model, rng = arm.pin_model, np.random.default_rng(4)
    flange = model.frames[model.getFrameId("tool0", pin.FrameType.BODY)]
    q, (qd, qdd) = configurations(arm, 10), rng.normal(size=(2, 6))
    for tool in (None, X_FT):
        at = flange.placement if tool is None else flange.placement * pin.SE3(tool)
        frame = model.addFrame(pin.Frame(f"at {tool is None}", flange.parentJoint, at, pin.FrameType.OP_FRAME))
        data = model.createData()
        for row in q:
            pin.computeJointJacobiansTimeVariation(model, data, row, qd)
            pin.updateFramePlacements(model, data)
            J = pin.getFrameJacobian(model, data, frame, pin.LOCAL_WORLD_ALIGNED)
            rate = pin.getFrameJacobianTimeVariation(model, data, frame, pin.LOCAL_WORLD_ALIGNED)
            np.testing.assert_allclose(arm.jacobian(row, tool), J, rtol=0, atol=1e-12)
            moves = arm.differential(row, tool)
            np.testing.assert_allclose(moves.velocity(qd), J @ qd, rtol=0, atol=1e-11)
            np.testing.assert_allclose(moves.bias(qd), rate @ qd, rtol=0, atol=1e-10)
            np.testing.assert_allclose(moves.motion(qd, qdd), [J @ qd, J @ qdd + rate @ qd], rtol=0, atol=1e-10)


def test_every_branch_leads_back_and_the_configuration_is_among_them(arm):
    q = configurations(arm, ALL if arm.arm.b and arm.arm.a2 else 500)  # test_parallel_arm.py has ALL of its own
    X, limits = pin_flange(arm, q), arm.profile()
    found = inverse(arm, X)
    there = np.isfinite(found).all(axis=-1)
    assert np.isnan(found[~there]).all()
    assert there.any(axis=1).all()
    some = there & (np.cumsum(there, axis=0) < 200)  # pin is asked row by row: the first of every branch
    back = pin_flange(arm, found[some])
    assert np.abs(back - X[np.nonzero(some)[0]]).max() < 1e-9
    assert np.abs(arm.forward(np.where(there[..., None], found, 0.0)) - X[:, None])[there].max() < 1e-9
    assert np.abs(found[there] - arm.arm.middles).max() <= np.pi + 1e-9
    singular = singularity(arm, q).min(axis=1)
    for row, branches, distance in zip(q[:400], found, singular, strict=False):
        own = branches[confdata(arm, row).cfx]
        turned = representatives(own, limits.lower, limits.upper)
        assert np.abs(turned - row).max(axis=1).min() < 1e-12 / distance + 1e-9


def test_whole_turns_reach_every_configuration_in_range(arm):
    q = configurations(arm, 60)
    found, turns, limits = inverse(arm, pin_flange(arm, q)), arm.turns, arm.profile()
    np.testing.assert_array_equal(turns[0], np.zeros(6))
    for row, branches in zip(q, found, strict=True):
        tried = (branches[confdata(arm, row).cfx] + turns)[:, None]
        assert np.abs(tried - row).max(axis=-1).min() < 1e-5
    inside = [s for _, s in solutions(arm, arm.forward(q[0]), None, limits)]
    assert all(np.all((s >= limits.lower) & (s <= limits.upper)) for s in inside)
    assert min(np.abs(np.array(inside) - q[0]).max(axis=1)) < 1e-6


def seen(robot, q):
    """By pin's joint frames alone: unit axes (n, 6, 3), a point (n, 6, 3) on each, wrist centre and flange (n, 3), at q
    (n, 6). The wrist centre is where axes 4 to 6 meet, or 5 and 6 where axis 4 is parallel to axis 3."""
    model, rows = robot.pin_model, []
    data, flange = model.createData(), model.getFrameId("tool0", pin.FrameType.BODY)
    for row in q:
        u = pin.computeJointJacobians(model, data, row)[3:].T.copy()
        p = [data.oMi[i].translation.copy() for i in range(1, 7)]
        rows.append((u, p, pin.updateFramePlacement(model, data, flange).translation.copy()))
    u, p, tool = (np.array(x) for x in zip(*rows, strict=True))
    some = slice(4 if parallel(u[0]) else 3, 6)
    across = np.eye(3) - u[:, some, :, None] * u[:, some, None]
    wrist = np.linalg.solve(across.sum(axis=1), (across @ p[:, some, :, None]).sum(axis=1))[..., 0]
    return u, p, wrist, tool


def parallel(u):
    return abs(u[2] @ u[3]) > 0.5


def geometric_margins(robot, q):
    """What cfx is about, (n, 3): wrist centre before axis 1 and before the lower arm, sine of axis 5."""
    u, p, wrist, tool = (x[0] for x in seen(robot, np.zeros((1, 6))))
    base = robot.X_WR[:3, 3]
    high = u[0] @ (p[1] - base)
    up = np.sign(high if abs(high) > 1e-9 else u[0] @ robot.X_WR[:3, 2])
    front = np.cross(u[1], u[0]) @ (p[1] - p[0])
    front = np.sign(front if abs(front) > 1e-9 else np.cross(u[1], u[0]) @ (wrist - p[0]))
    onward, out = np.sign(u[3] @ (wrist - p[2])), np.sign(u[5] @ (tool - wrist))
    one_way = parallel(u)
    u, p, wrist, _ = seen(robot, q)
    u, p = np.moveaxis(u, 1, 0), np.moveaxis(p, 1, 0)  # (6, n, 3)
    forward = front * np.cross(u[1], u[0])
    left = np.cross(up * u[0], forward)
    end, before_5 = (p[3], left) if one_way else (wrist, onward * u[3])
    triples = (
        (forward, wrist - p[0]),
        (np.cross(p[2] - p[1], end - p[2]), left),
        (np.cross(before_5, out * u[5]), u[4]),
    )
    return np.stack([(a * b).sum(axis=1) for a, b in triples], axis=1)


def test_cfx_is_what_pins_frames_show(arm):
    q = configurations(arm, 60)
    wanted, (before, elbow, axis_5) = geometric_margins(arm, q), branch_margins(arm.arm, q)
    found = np.column_stack([before, arm.arm.c2 * arm.arm.upper * elbow, np.sin(axis_5)])
    np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-12)
    for row, margins in zip(q, wanted, strict=True):
        conf = confdata(arm, row)
        assert conf.cfx == 4 * (margins[0] < 0) + 2 * (margins[1] < 0) + (margins[2] < 0)
        assert (conf.cf1, conf.cf4, conf.cf6) == tuple(np.floor(row[[0, 3, 5]] / (np.pi / 2)))
        assert confdata_admits(arm, conf, row)
        assert not confdata_admits(arm, ConfData(conf.cf1, conf.cf4, conf.cf6, conf.cfx ^ 2), row)


def test_branches_are_named_by_their_bits(arm):
    X = pin_flange(arm, configurations(arm, 50))
    found = inverse(arm, X)
    for cfx in range(8):
        there = np.isfinite(found[:, cfx, 0])
        margins = geometric_margins(arm, found[there, cfx])
        signs = np.where([cfx & 4, cfx & 2, cfx & 1], -1.0, 1.0)
        assert there.sum() > 15
        assert np.all((margins * signs > 0) | (np.abs(margins) < 1e-9))


def test_expressions_are_the_numbers_on_every_branch(arm):
    """Flange and inverse as expressions, from another base than the canonical one, on turns of any number."""
    rng, symbol = np.random.default_rng(5), ca.SX.sym("q", 6)
    flange = ca.Function("flange", [symbol], [*arm.expressions.flange(symbol)])
    p, R, branch = ca.SX.sym("p", 3), ca.SX.sym("R", 3, 3), ca.SX.sym("branch", 3)
    inverse_of = ca.Function("inverse", [p, R, branch, symbol], [*arm.expressions.inverse(p, R, branch, symbol)])
    q = configurations(arm, 12)
    q = q[singularity(arm, q).min(axis=1) > 0.03]
    X = pin_flange(arm, q)
    for X_WF, row, branches in zip(X, q, inverse(arm, X), strict=True):
        position, rotation = flange(row)
        np.testing.assert_allclose(np.ravel(position), X_WF[:3, 3], rtol=0, atol=1e-12)
        np.testing.assert_allclose(rotation, X_WF[:3, :3], rtol=0, atol=1e-12)
        X_BF = inverse_pose(arm.X_WB0) @ X_WF
        for cfx, wanted in enumerate(branches):
            if np.isnan(wanted).any():
                continue
            wanted = wanted + 2 * np.pi * rng.integers(-1, 2, 6)
            near = wanted + rng.uniform(-0.98, 0.98, 6) * np.pi
            found, elbow, wrist = inverse_of(X_BF[:3, 3], X_BF[:3, :3], arm.expressions.branch(cfx), near)
            np.testing.assert_allclose(np.ravel(found), wanted, rtol=0, atol=1e-9)
            walls = arm.singularity_margins(wanted)
            assert np.abs(elbow).max() == pytest.approx(walls[0], abs=1e-9)
            assert float(wrist) == pytest.approx(walls[1], abs=1e-9)


def test_singularity_measures_make_the_determinant(arm):
    q = configurations(arm, 200)
    product = singularity(arm, q).prod(axis=1) * arm.arm.c2 * arm.arm.upper
    np.testing.assert_allclose(product, np.abs(np.linalg.det(arm.jacobian(q))), rtol=0, atol=1e-12)
    elbow, wrist = arm.singularity_margins(q)
    square = arm.arm.b**2 / (arm.arm.b**2 + singularity(arm, q)[:, 2] ** 2)
    np.testing.assert_allclose(elbow**2, np.maximum(1 - singularity(arm, q)[:, 1] ** 2, square**2), rtol=0, atol=1e-12)
    np.testing.assert_allclose(wrist, singularity(arm, q)[:, 0], rtol=0, atol=1e-13)


def test_what_is_out_of_reach_is_said_in_the_arms_own_lengths(arm):
    """Of a flange pose whose wrist centre is put somewhere in the canonical base."""
    canonical, limits = arm.arm, arm.profile()
    if isinstance(canonical, ParallelArm):
        pytest.skip("test_parallel_arm.py has its words")
    X = arm.forward(np.zeros(6))
    wrist = seen(arm, np.zeros((1, 6)))[2][0]

    def at(*place):
        moved = X.copy()
        moved[:3, 3] += arm.X_WC0[:3, 3] + arm.X_WC0[:3, :3] @ place - wrist
        return arm.why_unreachable(moved, None, limits)

    reach = canonical.c2 + canonical.upper
    r = np.hypot(np.sqrt(5.0**2 - canonical.b**2) - canonical.a1, 1.0)
    assert at(5.0, 0.0, canonical.c1 + 1.0) == (
        f"wrist centre outside the outer workspace: {r:.6g} m from axis 2, at most {reach:.6g} m"
    )
    if canonical.b:
        near = 0.9 * abs(canonical.b)
        wanted = f"wrist centre {near:.6g} m from axis 1, at least the arm's offset of {abs(canonical.b):.6g} m"
        assert at(0.0, near, canonical.c1 + 0.3) == wanted
