"""Arms whose axes 2, 3 and 4 are parallel: all branches against pin and eaik, where they meet, and what is refused.

test_every_arm.py asks them what it asks every arm.
"""

from __future__ import annotations

import numpy as np
import pytest
from arms import PARALLEL, Chain, pin_flange, random_parallel_chain, random_pose, universal_robot
from scipy.spatial.transform import Rotation
from tcp_motion import singularity

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import pose, rotation_about
from trajopt_cli.robot.inverse import inverse, solutions
from trajopt_cli.robot.parallel_arm import bent

MANY = 1000
TURN = 2 * np.pi


@pytest.fixture(scope="module", params=[*PARALLEL, *range(4)])
def arm(request, tmp_path_factory):
    chain = PARALLEL[request.param]() if request.param in PARALLEL else random_parallel_chain(request.param)
    return chain.load(tmp_path_factory.mktemp("arm"), random_pose(np.random.default_rng(1)))


def configurations(robot, n):
    limits = robot.profile()
    return np.random.default_rng(6).uniform(limits.lower, limits.upper, (n, 6))


def eaiks_model(robot):
    """The arm as eaik takes it: axes and the steps between them at q = 0, by pin's frames, parallel axes turned one way
    (else its answers have other poses); the flange's rotation then, and the directions (6,)."""
    hp = pytest.importorskip("eaik.IK_HP")
    import pinocchio as pin

    data = robot.pin_model.createData()
    H = pin.computeJointJacobians(robot.pin_model, data, np.zeros(6))[3:].T
    same = np.array([1.0, 1.0, *np.sign(H[2:4] @ H[1]), 1.0, 1.0])
    X = pin_flange(robot, np.zeros((1, 6)))[0]
    places = [*(data.oMi[i].translation for i in range(1, 7)), X[:3, 3]]
    return hp.HPRobot(H * same[:, None], np.diff([np.zeros(3), *places], axis=0)), X[:3, :3], same


def test_thousands_of_configurations_are_pins_and_eaiks(arm):
    q = configurations(arm, MANY)
    X = pin_flange(arm, q)
    assert np.abs(arm.forward(q) - X).max() < 1e-12
    found = inverse(arm, X)
    there = np.isfinite(found).all(axis=-1)
    assert np.isnan(found[~there]).all()
    assert np.abs(pin_flange(arm, found[there]) - np.repeat(X, there.sum(axis=1), axis=0)).max() < 1e-9
    theirs, R, same = eaiks_model(arm)
    given = X.copy()
    given[:, :3, :3] = X[:, :3, :3] @ R.T
    for row, branches, answer in zip(q, found, theirs.IK_batched(list(given), 1), strict=True):
        exact = same * np.array([one for one, least in zip(answer.Q, answer.is_LS, strict=True) if not least])
        mine = branches[np.isfinite(branches).all(axis=1)]
        near = singularity(arm, mine).min()
        assert np.abs((mine - row + np.pi) % TURN - np.pi).max(axis=1).min() < 1e-9 + 1e-12 / near
        if near < 1e-4:  # where branches all but meet eaik's own rounding decides which it has
            continue
        apart = np.abs((mine[:, None] - exact[None] + np.pi) % TURN - np.pi).max(axis=-1)
        assert apart.shape == (len(mine), len(mine))
        assert max(apart.min(axis=0).max(), apart.min(axis=1).max()) < 1e-9 + 1e-11 / near


def at_singularities(arm, rng, kind):
    """Joints (60, 6) with axis 5 straight or turned over, or the elbow stretched or folded, in canonical angles."""
    t = rng.uniform(-3, 3, (60, 6))
    if "wrist" in kind:
        t[:, 4] = np.where(rng.random(60) < 0.5, 0.0, np.pi)
    if "elbow" in kind:
        t[:, 2] = -np.pi / 2 if arm.arm.c2 != arm.arm.c3 else np.where(rng.random(60) < 0.5, -np.pi / 2, np.pi / 2)
    return arm.arm.signs * (t - arm.arm.offsets)


@pytest.mark.parametrize("kind", ["wrist", "elbow", "wrist and elbow"])
def test_at_singularities_the_answer_is_finite_and_its_pose_right(arm, kind, rng):
    """A straight wrist leaves the turn of axis 6 free; axis 4 has then to be put where axes 2 and 3 reach it."""
    q = at_singularities(arm, rng, kind)
    X = pin_flange(arm, q)
    found = inverse(arm, X)
    there = np.isfinite(found).all(axis=-1)
    if kind == "wrist":
        assert there.any(axis=1).all()
        conventional = np.abs((arm.arm.angles(found)[there][:, 5] + np.pi / 2) % np.pi - np.pi / 2) < 1e-9
        assert 0.2 < conventional.mean() < 1.0  # the others are where t6 = 0 or half a turn is out of reach
    assert there.any(axis=1).mean() > 0.3  # a stretched elbow is on the edge of what is in reach
    back = pin_flange(arm, found[there])
    assert np.abs(back - np.repeat(X, there.sum(axis=1), axis=0)).max() < 1e-7


def test_a_straight_wrist_is_turned_no_farther_than_axes_2_and_3_need(arm, rng):
    """t6 is 0, on the other side half a turn, where they reach axis 4 so; else axis 4 stands on the edge of what they
    reach. The flange is Ry(t2 + t3 + t4) Rz(t5) Ry(t6) Rx(-90 deg), and Ry(t) turns the link to the wrist centre."""
    geometry, n = arm.arm, 400
    phi, over = rng.uniform(-3, 3, (2, n)), np.where(rng.random((2, n)) < 0.5, 0.0, np.pi)
    centre = geometry.c2 * rng.uniform(-1.6, 1.6, (2, 2, n))
    turned = [Rotation.from_euler(axis, x.reshape(-1, 1)) for axis, x in (("y", phi), ("z", over))]
    R = (turned[0] * turned[1] * Rotation.from_euler("x", -np.pi / 2)).as_matrix()
    R[np.abs(R) < 1e-12] = 0.0
    R = R.reshape(2, n, 3, 3).transpose(2, 3, 0, 1)
    inner, outer = abs(geometry.c2 - geometry.c3), geometry.c2 + geometry.c3
    along, length = geometry.wrist[[0, 2]], np.hypot(*geometry.wrist[[0, 2]])

    def link(t):
        return np.cos(t) * along[0] + np.sin(t) * along[1], np.cos(t) * along[1] - np.sin(t) * along[0]

    for side in (1, -1):
        first = phi + (np.pi if side < 0 else 0.0)
        default = np.hypot(*(c - x for c, x in zip(centre, link(first), strict=True)))
        nearest = np.clip(default, inner, outer)
        rows = np.ascontiguousarray(R.transpose(2, 3, 0, 1)).reshape(-1, 3, 3), centre.reshape(2, -1).T
        found = bent(geometry, *rows, np.full(2 * n, float(side)))
        ahead, up, t234, t5, t6 = found.T.reshape(5, 2, n)
        np.testing.assert_allclose(np.stack(link(t234)) + np.stack([ahead, up]), centre, rtol=0, atol=1e-12)
        np.testing.assert_allclose(np.abs(t5), over, rtol=0, atol=1e-12)
        own = default == nearest
        np.testing.assert_allclose(np.cos(t234 - first)[own], 1, rtol=0, atol=1e-12)
        np.testing.assert_allclose(np.sin(t6)[own], 0, rtol=0, atol=1e-12)
        far = np.hypot(*centre)
        others = ~own & (np.abs(far - length) < nearest - 1e-6) & (nearest + 1e-6 < far + length)
        np.testing.assert_allclose(np.hypot(ahead, up)[others], nearest[others], rtol=0, atol=1e-9)
        back = Rotation.from_euler("y", t234.reshape(-1, 1)) * Rotation.from_euler("z", t5.reshape(-1, 1))
        back = back * Rotation.from_euler("y", t6.reshape(-1, 1)) * Rotation.from_euler("x", -np.pi / 2)
        np.testing.assert_allclose(back.as_matrix(), R.transpose(2, 3, 0, 1).reshape(-1, 3, 3), rtol=0, atol=1e-9)
    assert own.sum() > 100
    assert others.sum() > 5


def test_an_arm_in_canonical_angles_gives_them_as_they_are(tmp_path):
    """Nothing is converted: every angle is found within half a turn of what is natural by itself."""
    places = [(0, 0, 0.2), (0.05, 0, 0), (0, 0, 0.5), (0.4, 0, 0), (0, 0, 0), (0, 0, -0.1)]
    axes = [np.eye(3)[i] for i in (2, 1, 1, 1, 2, 1)]
    ranges = [(-np.pi, np.pi)] * 6
    ranges[2] = (-1.5 * np.pi, 0.5 * np.pi)
    chain = Chain([pose(np.eye(3), p) for p in places], axes, pose(rotation_about(axes[0], 0.0), [0, 0.1, 0]), ranges)
    robot = chain.load(tmp_path)
    assert robot.arm.converted == ()
    q = np.random.default_rng(7).uniform(-3, 3, (300, 6))
    X = pin_flange(robot, q)
    found = inverse(robot, X)
    there = np.isfinite(found).all(axis=-1)
    assert np.abs(found[there] - robot.arm.middles).max() <= np.pi + 1e-12
    assert np.abs(robot.forward(found[there]) - np.repeat(X, there.sum(axis=1), axis=0)).max() < 1e-9
    for row, branches in zip(q, found, strict=True):
        assert np.nanmin(np.abs((branches - row + np.pi) % TURN - np.pi).max(axis=1)) < 1e-7


def test_just_beside_the_straight_wrist_poses_are_as_exact(arm, rng):
    q = at_singularities(arm, rng, "wrist")
    for beside in (1e-11, 1e-8, 1e-5):
        moved = q + beside * np.array([0, 0, 0, 0, 1, 0])
        X = pin_flange(arm, moved)
        found = inverse(arm, X)
        there = np.isfinite(found).all(axis=-1)
        assert np.abs(pin_flange(arm, found[there]) - np.repeat(X, there.sum(axis=1), axis=0)).max() < 1e-11


def test_solutions_are_met_in_every_turn_that_the_ranges_hold(tmp_path):
    arm = PARALLEL["ur5e"]().load(tmp_path)
    q = np.array([0.4, -1.2, 1.5, -1.9, -1.4, 0.7])
    found = np.array([one for _, one in solutions(arm, arm.forward(q), None, arm.profile())])
    assert len(found) == 8 * 2**6  # all six axes go a whole turn to either side
    assert all(np.abs(found - q - TURN * np.eye(6)[i] * -np.sign(q[i])).max(axis=1).min() < 1e-9 for i in range(6))
    assert np.abs(pin_flange(arm, found) - arm.forward(q)).max() < 1e-12


def test_what_is_out_of_reach_is_told_by_axis_4(tmp_path):
    arm, straight = PARALLEL["ur5e"]().load(tmp_path), rotation_about([1, 0, 0], np.pi)
    limits = arm.profile()
    # the tool points down, so axis 5 lies and axis 4 is 99.7 mm nearer at best: 0.83956 m ahead, 0.0371 m up
    assert arm.why_unreachable(pose(straight, [0.9, 0.3, 0.1]), None, limits) == (
        "axis 4 outside the workspace: 0.840391 m from axis 2 at best, in reach are 0.0328 to 0.8172 m"
    )
    assert arm.why_unreachable(pose(straight, [0.1, 0.05, 0.4]), None, limits) == (
        "wrist centre 0.111803 m from axis 1, at least the arm's offset of 0.1333 m"
    )


@pytest.mark.parametrize(
    ("joint", "X", "words"),
    [
        (5, pose(np.eye(3), [0.01, 0, 0]), "the wrist: axis 6 passes axis 5 by 10 mm, at most 1e-06: six axes are"),
        (3, pose(rotation_about([1, 0, 0], 1e-3), [0, 0, 0]), "axes 3 and 4 ('joint_3' and 'joint_4') are 0.0572958°"),
        (2, pose(np.eye(3), [0.425, 0, 0]), "axes 2 and 3 are 0 mm apart"),
        (3, pose(np.eye(3), [0.3922, 0, 0]), "axes 4 and 3 are 0 mm apart"),
    ],
)
def test_what_is_not_of_this_kind_is_refused_by_its_axes(joint, X, words, tmp_path):
    chain = PARALLEL["ur5e"]()
    chain.origins[joint] = chain.origins[joint] @ X
    with pytest.raises(InputError) as error:
        chain.load(tmp_path)
    assert words in str(error.value)


def test_lengths_are_read_off_the_makers_table(tmp_path):
    lengths = universal_robot(0.16, -0.43, -0.39, 0.13, 0.1, 0.09).load(tmp_path).arm.lengths
    wanted = {"a1": 0, "b": 0.13, "c1": 0.16, "c2": 0.43, "c3": 0.39, "c4": 0.09}
    assert lengths == pytest.approx(wanted | {"axis 5 off axis 4": 0, "wrist along axis 5": 0.1}, abs=1e-15)
