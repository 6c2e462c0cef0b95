"""The judge's kinematics against the independent truth, and its speeds and accelerations against differences."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
from scipy.spatial.transform import Rotation

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, inverse_pose, pose, rotation_about, rotation_from_wxyz
from trajopt_cli.judge.mechanism import _FEW, Mechanism
from trajopt_cli.judge.tool_kinematics import carried, shifted
from trajopt_cli.robot.model import Structure, robot_names

ROBOTS = Path(__file__).parents[2] / "robots"
TRUTH = Path(__file__).parents[1] / "data" / "truth" / "irb140_fk.json"
MOUNTS = {
    "world": np.eye(4),
    "mounted": pose(rotation_about(np.array([2, -1, 2]) / 3, 1.1), [0.4, -0.3, 0.2]),
}
LINKS = ("base_link", *(f"link_{i}" for i in range(1, 7)))


@pytest.fixture(params=MOUNTS)
def X_WR(request: pytest.FixtureRequest) -> Array:
    return MOUNTS[request.param]


@pytest.fixture(params=robot_names(Structure.SIX_AXIS))
def mechanism(request: pytest.FixtureRequest, X_WR: Array) -> Mechanism:
    """Every six-axis robot that ships."""
    return Mechanism(ROBOTS / f"{request.param}.urdf", X_WR)


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(211)


def test_of_rows_at_rest_the_first_is_looked_at(monkeypatch: pytest.MonkeyPatch, rng: np.random.Generator) -> None:
    mechanism = Mechanism(ROBOTS / "irb140.urdf", np.eye(4))
    q = states(mechanism, rng, 3)[0][[0, 0, 1, 1, 1, 0, 2]]
    alone = [mechanism.flange(row[None]) for row in q]
    looked: list[Array] = []
    compute = pin.computeFrameJacobian
    monkeypatch.setattr(pin, "computeFrameJacobian", lambda *given: (looked.append(given[2]), compute(*given))[1])
    X, J = mechanism.flange(q)
    assert len(looked) == 4
    np.testing.assert_array_equal(X, [one[0] for one, _ in alone])
    np.testing.assert_array_equal(J, [one[0] for _, one in alone])
    assert mechanism.flange(q[:0])[0].shape == (0, 4, 4)


def oblique(path: Path, rail: bool) -> Path:
    """A robot whose joints stand and turn askew; the first slides where there is a rail, the last, which stands right
    in the one before it, in any case."""
    rng = np.random.default_rng(5)
    kinds = ["prismatic"] * rail + ["revolute"] * 5 + ["prismatic"]
    text, before = '<link name="base"/>', "base"
    for i, kind in enumerate(kinds):
        axis, name = rng.normal(size=3), f"link_{i}"
        numbers = [" ".join(map(str, x)) for x in (rng.uniform(-1, 1, 3), rng.uniform(-3, 3, 3), axis)]
        numbers[0] = "0 0 0" if i and kind == "prismatic" else numbers[0]
        text += f"""<link name="{name}"/><joint name="joint_{i}" type="{kind}"><parent link="{before}"/>
        <child link="{name}"/><origin xyz="{numbers[0]}" rpy="{numbers[1]}"/><axis xyz="{numbers[2]}"/>
        <limit lower="-9" upper="9" velocity="1" effort="0"/></joint>"""
        before = name
    text += f"""<link name="tool0"/><joint name="flange" type="fixed"><parent link="{before}"/><child link="tool0"/>
    <origin xyz="0.1 -0.2 0.05" rpy="0.3 0.4 0.5"/></joint>"""
    path.write_text(f'<robot name="askew">{text}</robot>')
    return path


@pytest.mark.parametrize("name", [*robot_names(Structure.SIX_AXIS), *robot_names(Structure.SRS), "askew", "askew_rail"])
def test_all_rows_at_once_are_as_pin_has_them(name: str, X_WR: Array, rng: np.random.Generator, tmp_path: Path) -> None:
    """Poses, Jacobians, velocities and accelerations, joints that slide behind ones that turn among them."""
    path = ROBOTS / f"{name}.urdf"
    mechanism = Mechanism(oblique(tmp_path / path.name, "rail" in name) if "askew" in name else path, X_WR)
    q, qd, qdd = states(mechanism, rng, n := 2100)
    X, V, A = mechanism.flange_motion(q, qd, qdd)
    X_alone, J = mechanism._chain.flange(q)
    np.testing.assert_array_equal(X, X_alone)
    model, data, frame = mechanism._model, mechanism._model.createData(), mechanism._flange
    world = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
    for i in [*range(0, n, n // 7), n - 1]:
        wanted = pin.computeFrameJacobian(model, data, q[i], frame, world)
        np.testing.assert_allclose(J[i], wanted, rtol=0, atol=2e-14)
        pin.forwardKinematics(model, data, q[i], qd[i], qdd[i])
        wanted = pin.updateFramePlacement(model, data, frame).homogeneous
        np.testing.assert_allclose(X[i], wanted, rtol=0, atol=1e-14)
        wanted = pin.getFrameVelocity(model, data, frame, world).vector
        np.testing.assert_allclose(V[i], wanted, rtol=0, atol=1e-12)
        wanted = pin.getFrameClassicalAcceleration(model, data, frame, world).vector
        np.testing.assert_allclose(A[i], wanted, rtol=1e-13, atol=1e-12)
    for few in (slice(n // 2, n // 2 + 1), slice(n // 2, n)):
        for whole, part in zip((X, V, A), mechanism.flange_motion(q[few], qd[few], qdd[few]), strict=True):
            np.testing.assert_array_equal(whole[few], part)
        for whole, part in zip((X, J), mechanism._chain.flange(q[few]), strict=True):
            np.testing.assert_array_equal(whole[few], part)


def test_many_rows_are_what_few_are(mechanism: Mechanism, rng: np.random.Generator) -> None:
    """pin is asked about a few; of many rows it is not, those at rest among them."""
    q = states(mechanism, rng, 200)[0].repeat(2, axis=0)
    many, few = mechanism.flange(q), [mechanism.flange(q[i : i + 20]) for i in range(0, 400, 20)]
    for i in range(2):
        np.testing.assert_allclose(many[i], np.concatenate([one[i] for one in few]), rtol=0, atol=1e-14)


def states(mechanism: Mechanism, rng: np.random.Generator, n: int = 60) -> tuple[Array, Array, Array]:
    k = len(mechanism.names)
    return rng.uniform(-3, 3, (n, k)), rng.uniform(-4, 4, (n, k)), rng.uniform(-20, 20, (n, k))


@pytest.mark.parametrize("rail", [None, 0.0, -0.7, 1.9])
def test_poses_and_jacobians_are_the_truths(X_WR: Array, rail: float | None) -> None:
    """The truth's base rides the rail along y of the URDF's root, which stands at X_WR."""
    cases = json.loads(TRUTH.read_text())["cases"]
    mechanism = Mechanism(ROBOTS / ("irb140.urdf" if rail is None else "irb140_rail.urdf"), X_WR)
    assert len(cases) > _FEW
    arm = np.array([c["q"] for c in cases])
    q = arm if rail is None else np.c_[np.full(len(arm), rail), arm]
    X_WB = X_WR @ pose(np.eye(3), [0, rail or 0.0, 0])
    X_BF = pose(rotation_from_wxyz([c["quat_wxyz"] for c in cases]), [c["p"] for c in cases])
    X, J = mechanism.flange(q)
    np.testing.assert_allclose(X, X_WB @ X_BF, rtol=0, atol=2e-15)
    np.testing.assert_allclose(mechanism.flange_motion(q, q, q)[0], X_WB @ X_BF, rtol=0, atol=2e-15)
    np.testing.assert_allclose(mechanism.flange_pose(q[7]), X_WB @ X_BF[7], rtol=0, atol=2e-15)
    np.testing.assert_allclose(mechanism.links(q)[0][:, 0], np.tile(X_WB, (len(q), 1, 1)), rtol=0, atol=1e-15)
    known = [c["jacobian_base_v_then_w_rowmajor_6x6"] for c in cases if "jacobian_base_v_then_w_rowmajor_6x6" in c]
    true = np.array(known).reshape(-1, 6, 6)
    wanted = np.concatenate([X_WB[:3, :3] @ true[:, :3], X_WB[:3, :3] @ true[:, 3:]], axis=1)
    assert len(wanted) == 10
    np.testing.assert_allclose(J[:10, :, -6:], wanted, rtol=0, atol=2e-15)
    np.testing.assert_allclose(mechanism.flange(q[:10])[1][..., -6:], wanted, rtol=0, atol=2e-15)
    assert mechanism.has_rail is (rail is not None)
    if rail is not None:
        along = np.tile(np.r_[X_WR[:3, 1], 0, 0, 0], (len(q), 1))
        np.testing.assert_allclose(J[:, :, 0], along, rtol=0, atol=1e-15)


def test_speeds_and_accelerations_are_differences_of_the_pose(mechanism: Mechanism, rng: np.random.Generator) -> None:
    """At a crooked tool as well; five points 2 ms apart along q + qd t + qdd t^2 / 2."""
    X_FT = pose(rotation_about(np.array([0, 0.6, 0.8]), 2.0), [0.05, -0.1, 0.2])
    q, qd, qdd = states(mechanism, rng)
    h = 2e-3
    times = [-2 * h, -h, 0.0, h, 2 * h]
    X = np.array([mechanism.flange(q + t * qd + t * t / 2 * qdd)[0] @ X_FT for t in times])
    first, second = (np.array(w) for w in ([1, -8, 0, 8, -1], [-1, 16, -30, 16, -1]))
    p_1, p_2 = (np.tensordot(w, X[..., :3, 3], axes=1) / 12 for w in (first, second))
    R_1 = np.tensordot(first, X[..., :3, :3], axes=1) / (12 * h)
    spin = R_1 @ np.swapaxes(X[2, :, :3, :3], 1, 2)
    X_WF, V_F, A_F = mechanism.flange_motion(q, qd, qdd)
    np.testing.assert_allclose(X_WF @ X_FT, X[2], rtol=0, atol=1e-14)
    V, A = carried(V_F, A_F, X_WF, X_FT)
    omega = np.stack([spin[:, 2, 1], spin[:, 0, 2], spin[:, 1, 0]], axis=1)
    np.testing.assert_allclose(V, np.hstack([p_1 / h, omega]), rtol=0, atol=1e-6)
    np.testing.assert_allclose(A[:, :3], p_2 / h**2, rtol=0, atol=2e-4)
    J = shifted(mechanism.flange(q)[1], X_WF, X_FT)
    np.testing.assert_allclose((J @ qd[..., None])[..., 0], V, rtol=0, atol=1e-12)


def test_the_jacobians_rate_is_its_difference(mechanism: Mechanism, rng: np.random.Generator) -> None:
    """J' qd, linear and angular: what the flange accelerates while no axis does; and J qdd on top of it."""
    q, qd, qdd = states(mechanism, rng)
    h = 1e-3
    weights = {-2: 1, -1: -8, 1: 8, 2: -1}
    rate = sum(w * mechanism.flange(q + i * h * qd)[1] for i, w in weights.items()) / (12 * h)
    wanted = (rate @ qd[..., None])[..., 0]
    alone = mechanism.flange_motion(q, qd, np.zeros_like(qd))[2]
    np.testing.assert_allclose(alone, wanted, rtol=0, atol=1e-6)
    both = mechanism.flange_motion(q, qd, qdd)[2]
    np.testing.assert_allclose(both - alone, (mechanism.flange(q)[1] @ qdd[..., None])[..., 0], rtol=0, atol=1e-11)


def test_every_joint_turns_its_link_about_its_axis(mechanism: Mechanism, rng: np.random.Generator) -> None:
    q, _, _ = states(mechanism, rng, 5)
    X, axes = mechanism.links(q)
    assert mechanism.link_names == LINKS
    np.testing.assert_array_equal(X[:, 7], mechanism.flange(q)[0])
    for i in range(6):
        turned = q.copy()
        turned[:, i - 6] += 0.3
        Y = mechanism.links(turned)[0]
        np.testing.assert_array_equal(Y[:, : i + 1], X[:, : i + 1])
        moved = Y[:, i + 1] @ inverse_pose(X[:, i + 1])
        np.testing.assert_allclose(
            Rotation.from_matrix(moved[:, :3, :3]).as_rotvec(), 0.3 * axes[:, i], rtol=0, atol=1e-14
        )
        np.testing.assert_allclose(Y[:, i + 1, :3, 3], X[:, i + 1, :3, 3], rtol=0, atol=1e-14)


def test_what_hangs_beside_the_chain_does_not_count(tmp_path: Path, rng: np.random.Generator) -> None:
    """A hose on link_3 with a joint of its own, which sorts before the arm's; a joint and a link of one name."""
    plain = Mechanism(ROBOTS / "irb140_rail.urdf", MOUNTS["mounted"])
    hose = """<link name="a_hose"/><joint name="a_hose" type="revolute"><parent link="link_3"/>
    <child link="a_hose"/><origin xyz="0 0 0.1" rpy="0 0 0"/><axis xyz="1 0 0"/>
    <limit lower="-1" upper="1" velocity="1" effort="0"/></joint>"""
    path = tmp_path / "hose.urdf"
    text = (ROBOTS / "irb140_rail.urdf").read_text().replace("</robot>", f"{hose}</robot>")
    path.write_text(text.replace('joint name="flange"', 'joint name="tool0"'))
    more = Mechanism(path, MOUNTS["mounted"])
    assert (more.names, more.link_names) == (plain.names, plain.link_names)
    q, _, _ = states(plain, rng, 5)
    for one, other in ((plain.flange(q), more.flange(q)), (plain.links(q), more.links(q))):
        for a, b in zip(one, other, strict=True):
            np.testing.assert_array_equal(a, b)


def test_a_urdf_that_pin_does_not_read_is_told_in_one_line(tmp_path: Path) -> None:
    path = tmp_path / "hole.urdf"
    path.write_text((ROBOTS / "irb140.urdf").read_text().replace('<link name="link_3"/>', ""))
    with pytest.raises(InputError, match=r"^\S*hole.urdf: pin cannot read it as a URDF; .* need their <link>$"):
        Mechanism(path, np.eye(4))
