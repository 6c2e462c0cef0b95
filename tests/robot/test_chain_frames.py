"""The arm that a chain is does not depend on where its links' frames stand on the axes, nor on which way axes point."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from arms import KNOWN, OFFSET_WRISTS, PARALLEL, Chain, random_pose

from trajopt_cli.geometry import pose, rotation_about
from trajopt_cli.robot.inverse import confdata

CHAINS = KNOWN | OFFSET_WRISTS | PARALLEL
TURN = 2 * np.pi


def reframed(chain: Chain, rng: np.random.Generator, signs: np.ndarray) -> Chain:
    """Every link's frame turned anyhow and moved along its axis; axes turned round where the sign is -1."""
    before, origins, axes = np.eye(4), [], []
    for origin, axis, sign in zip(chain.origins, chain.axes, signs, strict=True):
        placed = random_pose(rng, 0.0)
        placed[:3, 3] = axis * rng.uniform(-0.3, 0.3)
        origins.append(np.linalg.inv(before) @ origin @ placed)
        axes.append(sign * placed[:3, :3].T @ axis)
        before = placed
    return Chain(origins, axes, np.linalg.inv(before) @ chain.flange, [(-3.0, 3.0)] * 6)


@pytest.mark.parametrize("name", CHAINS)
def test_frames_and_directions_change_nothing_but_the_joints_signs(name, tmp_path, rng):
    chain = replace(CHAINS[name](), ranges=[(-3.0, 3.0)] * 6)
    plain = chain.load(tmp_path)
    for i in range(3):
        signs = rng.choice([-1.0, 1.0], 6) if i else -np.ones(6)
        arm = reframed(chain, rng, signs).load(tmp_path, name=f"arm{i}")
        ours, theirs = (
            {k: abs(v) if "axis" in k or "wrist" in k else v for k, v in one.arm.lengths.items()}
            for one in (arm, plain)
        )
        assert ours == pytest.approx(theirs, abs=1e-9)  # beside axis 5, lengths are counted along it
        q = rng.uniform(-3, 3, (30, 6))
        np.testing.assert_allclose(arm.forward(q * signs), plain.forward(q), rtol=0, atol=1e-9)
        np.testing.assert_allclose(arm.arm.X_BC, plain.arm.X_BC, rtol=0, atol=1e-9)
        # axis 5 has no direction of its own: turned round, t4, t5 and t6 are those of the other side
        ours, theirs = ([confdata(robot, row).cfx for row in rows] for robot, rows in ((arm, q * signs), (plain, q)))
        five = 1 if signs[4] < 0 else 0
        if name not in PARALLEL:
            assert ours == [cfx ^ five for cfx in theirs]


def test_up_and_forward_are_where_the_axes_lie(tmp_path):
    """Up: where axis 2 lies on axis 1, else where axis 1 points; forward: where axis 2 stands off axis 1, else where
    the wrist centre is; axis 6 out of the wrist."""
    arm = KNOWN["irb4600"]()
    down = Chain(
        [pose(rotation_about([1, 0, 0], np.pi), [0, 0, 0]) @ arm.origins[0], *arm.origins[1:]], arm.axes, arm.flange
    )
    found = down.load(tmp_path, name="down").arm
    np.testing.assert_allclose(found.X_BC[:3, 2], [0, 0, -1], rtol=0, atol=1e-12)
    np.testing.assert_allclose(found.X_BC[:3, 0], [1, 0, 0], rtol=0, atol=1e-12)
    behind = Chain(
        [pose(rotation_about([0, 0, 1], np.pi), [0, 0, 0]) @ arm.origins[0], *arm.origins[1:]], arm.axes, arm.flange
    )
    found = behind.load(tmp_path, name="behind").arm
    np.testing.assert_allclose(found.X_BC[:3, :3], np.diag([-1.0, -1, 1]), rtol=0, atol=1e-12)
    for shift, turn in ((0.8, 0.0), (-0.6, 0.0), (0.0, np.pi)):
        hung = KNOWN[
            "irb4600"
        ]()  # where joint 1 stands on its axis, and where the lower arm is at q = 0, do not matter
        hung.origins[0] = pose(np.eye(3), [0, 0, shift])
        hung.origins[1] = pose(rotation_about([0, 1, 0], turn), [0.175, 0, 0.495 - shift])
        found = hung.load(tmp_path, name="hung").arm
        np.testing.assert_allclose(found.X_BC, np.eye(4), rtol=0, atol=1e-12)
        assert found.lengths == pytest.approx(arm.load(tmp_path).arm.lengths, abs=1e-9)
    level = KNOWN["irb1200"]()  # axis 2 stands on axis 1: forward is where the wrist centre is
    level.origins[0] = pose(rotation_about([0, 0, 1], np.pi / 2), [0, 0, 0])
    np.testing.assert_allclose(level.load(tmp_path, name="level").arm.X_BC[:3, 0], [0, 1, 0], rtol=0, atol=1e-12)


@pytest.mark.parametrize(
    ("joint", "degrees", "middle"),
    [
        (0, (-170, 170), 0), (0, (10, 170), 0), (0, (-180, 180), 0), (0, (-90, 190), 50), (0, (-190, 90), -50),
        (0, (-250, 250), 0), (0, (-250, 260), 5), (3, (-200, 200), 0), (3, (-200, 190), -5), (3, (10, 170), 0),
        (5, (-400, 380), -10),
    ],
)  # fmt: skip
def test_joints_are_given_about_the_middle_of_their_range(joint, degrees, middle, tmp_path):
    """About what is natural where the range lies around that; else about the range's own middle. So too where a joint
    is counted the other way or from elsewhere."""
    chain = KNOWN["irb4600"]()
    chain.ranges[joint] = tuple(float(x) for x in np.radians(degrees))
    found = chain.load(tmp_path).arm.middles
    assert np.degrees(found[joint]) == pytest.approx(middle, abs=1e-9)
    turn = pose(rotation_about(chain.axes[joint], 0.5), [0, 0, 0])
    others = [(chain.origins[joint], -chain.axes[joint])]
    if joint == 3:  # where joints 1 and 6 are counted from is where base and flange are
        others.append((chain.origins[joint] @ turn, chain.axes[joint]))
    for origin, axis in others:
        other = Chain([*chain.origins], [*chain.axes], chain.flange, chain.ranges)
        other.origins[joint], other.axes[joint] = origin, axis
        found = other.load(tmp_path, name="other").arm.middles
        assert np.degrees(found[joint]) == pytest.approx(sum(degrees) / 2, abs=1e-9)


def test_the_elbow_is_given_about_its_own_middle(tmp_path):
    chain = KNOWN["irb4600"]()
    natural = float(-np.pi / 2 - np.arctan2(-0.175, 1.27))
    for low, high, middle in ((-3.0, 1.0, natural), (natural - np.pi, natural + np.pi, natural), (-3.0, 2.0, -0.5)):
        chain.ranges[2] = (low, high)
        assert chain.load(tmp_path).arm.middles[2] == pytest.approx(middle, abs=1e-12)


def test_nobody_changes_an_arm(tmp_path):
    arm = KNOWN["irb4600"]().load(tmp_path).arm
    for name in ("signs", "offsets", "middles", "X_BC", "X_KF", "wrist"):
        with pytest.raises(ValueError, match="read-only"):
            getattr(arm, name)[0] = 2.0
