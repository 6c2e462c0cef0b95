"""An arm on three linear axes, against pin on a URDF that has them as joints."""

from __future__ import annotations

from pathlib import Path

import casadi as ca
import numpy as np
import pinocchio as pin
import pytest

from trajopt_cli.geometry import Array, inverse_pose, pose, rotation_about
from trajopt_cli.judge.mechanism import Mechanism
from trajopt_cli.robot.base_axes import BaseAxis, on_axes, turned
from trajopt_cli.robot.model import RobotModel, load_robot

WAYS = np.array([[1.0, 0.0, 0.0], [0.0, 0.6, 0.8], [0.0, 0.0, -1.0]])
NAMES = ("rail_a", "rail_b", "rail_d")
X_WB = pose(rotation_about([1, 0, 0], 0.4) @ rotation_about([0, 0, 1], 1.1), [1.0, -2.0, 0.5])


def carried(name: str = "irb140", axes: int = 3) -> RobotModel:
    ways = zip(NAMES[:axes], WAYS, strict=False)
    return on_axes(load_robot(name), [BaseAxis(one, way, -1.0, 2.0) for one, way in ways], X_WB)


def urdf_with_axes(folder: Path) -> pin.Model:
    """The IRB 140's URDF with three prismatic joints before its base, which at 0 stands in the root."""
    text = load_robot("irb140").urdf.read_text()
    head, body = text.split("<link", 1)
    first = body.split('"')[1]
    joints = ""
    R_BW = X_WB[:3, :3].T
    for i, way in enumerate(WAYS):
        child = f"l{i + 1}" if i < 2 else first
        axis = " ".join(repr(float(x)) for x in R_BW @ way)
        joints += (
            f'<link name="l{i}"/><joint name="{NAMES[i]}" type="prismatic"><parent link="l{i}"/><child link="{child}"/>'
        )
        joints += f'<axis xyz="{axis}"/><limit lower="-1" upper="2" velocity="1" effort="0"/></joint>'
    file = folder / "carried.urdf"
    file.write_text(f"{head}{joints}<link{body}")
    return pin.buildModelFromUrdf(str(file))


def random_axes(n: int) -> Array:
    rng = np.random.default_rng(5)
    return np.hstack([rng.uniform(-1, 2, (n, 3)), rng.uniform(-1.2, 1.2, (n, 6))])


def test_kinematics_are_pins_of_a_urdf_with_the_axes(tmp_path: Path) -> None:
    model, robot = urdf_with_axes(tmp_path), carried()
    data, flange = model.createData(), model.getFrameId("tool0")
    for q in random_axes(10):
        J = pin.computeFrameJacobian(model, data, q, flange, pin.LOCAL_WORLD_ALIGNED)
        X = X_WB @ pin.updateFramePlacement(model, data, flange).homogeneous
        turn = np.kron(np.eye(2), X_WB[:3, :3])
        np.testing.assert_allclose(robot.forward(q), X, atol=1e-12)
        np.testing.assert_allclose(robot.jacobian(q), turn @ J, atol=1e-12)
        found = [arm for _, arm in robot.solutions(X, q[:3], robot.profile())]
        assert min(np.abs(arm - q[3:]).max() for arm in found) < 1e-9


def test_the_pose_follows_when_an_axis_goes(tmp_path: Path) -> None:
    robot = carried()
    q = random_axes(4)
    for i, way in enumerate(WAYS):
        further = q.copy()
        further[:, i] += 0.3
        np.testing.assert_allclose(
            (robot.forward(further) - robot.forward(q))[:, :3, 3], np.tile(0.3 * way, (4, 1)), atol=1e-12
        )
        np.testing.assert_allclose(
            (robot.base_at(further) - robot.base_at(q))[:, :3, 3], np.tile(0.3 * way, (4, 1)), atol=1e-12
        )


@pytest.mark.parametrize("axes", [1, 2, 3])
def test_motions_are_differences_of_poses(axes: int) -> None:
    robot, h = carried(axes=axes), 1e-6
    q = random_axes(6)[:, 3 - axes :]
    rng = np.random.default_rng(1)
    qd, qdd = rng.normal(size=q.shape), rng.normal(size=q.shape)
    at = robot.differential(q)
    motion = at.motion(qd, qdd)
    ahead, behind = (robot.forward(q + k * h * qd + h * h / 2 * qdd)[:, :3, 3] for k in (1, -1))
    np.testing.assert_allclose(motion[:, 0, :3], (ahead - behind) / (2 * h), atol=1e-7)
    later, sooner = (robot.differential(q + k * h * qd).velocity(qd + k * h * qdd) for k in (1, -1))
    np.testing.assert_allclose(motion[:, 1], (later - sooner) / (2 * h), atol=1e-6)
    back = at.follow(motion[:, 0], motion[:, 1], qd[:, :axes], qdd[:, :axes])
    np.testing.assert_allclose(back[0], qd, atol=1e-8)
    np.testing.assert_allclose(back[1], qdd, atol=1e-7)


def test_expressions_and_the_judge_have_the_same_flange() -> None:
    robot = carried("irb140_rail")  # its own rail is left out
    symbol = ca.SX.sym("q", 9)
    place = ca.Function("place", [symbol], [robot.expressions.flange(symbol)[0]])
    assert robot.X_UB is not None
    ways = dict(zip(NAMES, WAYS.tolist(), strict=True))
    judge = Mechanism(robot.urdf, X_WB @ inverse_pose(robot.X_UB), carriers=ways)
    assert judge.names[:3] == NAMES
    for q in random_axes(5):
        np.testing.assert_allclose(np.asarray(place(q)).ravel(), robot.forward(q)[:3, 3], atol=1e-12)
        np.testing.assert_allclose(judge.flange_pose(q), robot.forward(q), atol=1e-12)


def test_a_rail_turned_against_the_arm_runs_there() -> None:
    mounted = load_robot("irb140_rail", X_WB)
    robot = turned(mounted, np.array([0.0, -1.0, 0.0]))
    q = random_axes(1)[0, 2:]
    behind = q.copy()
    behind[0] = -q[0]
    np.testing.assert_allclose(robot.forward(q), mounted.forward(behind), atol=1e-12)


def test_guessed_limits_say_that_they_are() -> None:
    known = BaseAxis("rail_b", WAYS[1], 0.0, 1.0, 0.7, 1.5, None, "drive's data sheet")
    limits = on_axes(load_robot("irb140"), [BaseAxis("rail_a", WAYS[0], -1.0, 2.0), known], X_WB).profile()
    assert limits.names[:3] == ("rail_a", "rail_b", "joint_1")
    assert (limits.velocity[1], limits.acceleration[1]) == (0.7, 1.5)
    assert limits.grades["rail_a.velocity"] == "D"
    assert "rail_b.velocity" not in limits.grades
    assert limits.sources["rail_b.velocity"] == "drive's data sheet"
