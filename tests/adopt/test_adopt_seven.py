"""Seven-axis arms from URDFs in anybody's frames: tool and torques as pinocchio has them of the original."""

from __future__ import annotations

from math import pi
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest

from trajopt_cli.adopt.add import new_robot
from trajopt_cli.errors import InputError
from trajopt_cli.robot.dynamics import Dynamics
from trajopt_cli.robot.srs import SrsRobot, load_srs

UP, OUT = f"{pi / 2} 0 {pi}", f"{pi / 2} 0 0"
BACK = f"{-pi / 2} {pi} 0"
# The iiwa 14 of iiwa_stack, another source than the shipped file's: every joint turns about its own z.
STACK = [
    ("0 0 0.1575", "0 0 0"), ("0 0 0.2025", UP), ("0 0.2045 0", UP), ("0 0 0.2155", OUT), ("0 0.1845 0", BACK),
    ("0 0 0.2155", OUT), ("0 0.081 0", BACK),
]  # fmt: skip
RANGES = np.radians([170, 120, 170, 120, 170, 120, 175])


def urdf(folder: Path, chain: list[tuple[str, str]] = STACK, effort: float = 300) -> Path:
    parts = ['<robot name="arm"><link name="l0"/>']
    for i, ((xyz, rpy), most) in enumerate(zip(chain, RANGES, strict=False), 1):
        body = f'<origin xyz="0.01 0.0{i} 0.02" rpy="0.3 0 0.{i}"/><mass value="{i}"/>'
        tensor = '<inertia ixx="0.02" iyy="0.03" izz="0.04" ixy="0.001" ixz="0" iyz="0.002"/>'
        shape = '<collision><geometry><cylinder radius="0.05" length="0.1"/></geometry></collision>'
        parts.append(f'<link name="l{i}"><inertial>{body}{tensor}</inertial>{shape}</link>')
        limit = f'<limit lower="{-most}" upper="{most}" velocity="1.5" effort="{effort}"/>'
        parts.append(
            f'<joint name="j{i}" type="revolute"><parent link="l{i - 1}"/><child link="l{i}"/>'
            f'<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="0 0 1"/>{limit}</joint>'
        )
    last = len(chain)
    parts.append(
        f'<link name="ee"/><joint name="e" type="fixed"><parent link="l{last}"/><child link="ee"/>'
        f'<origin xyz="0 0 0.045" rpy="0 {-pi / 2} 0"/></joint></robot>'
    )
    path = folder / "arm.urdf"
    path.write_text("".join(parts))
    return path


def added(folder: Path, path: Path) -> SrsRobot:
    for name, content in new_robot(path, "mine").files.items():
        (folder / name).write_bytes(content)
    return load_srs(str(folder / "mine.yaml"))


def test_tool_and_torques_are_those_of_the_urdf(tmp_path: Path) -> None:
    path = urdf(tmp_path)
    robot, model = added(tmp_path, path), pin.buildModelFromUrdf(str(path))
    data, dynamics, rng = model.createData(), Dynamics(robot), np.random.default_rng(3)
    ee = model.getFrameId("ee")
    for q in rng.uniform(-2, 2, (20, 7)):
        pin.framesForwardKinematics(model, data, q)
        X = data.oMf[ee].homogeneous
        np.testing.assert_allclose(robot.forward(q)[:3, 3], X[:3, 3], rtol=0, atol=1e-12)
        # the frame is the base's at 0, where the URDF's is turned
        np.testing.assert_allclose(robot.forward(q)[:3, 2], X[:3, 0], rtol=0, atol=1e-12)
        qd, qdd = rng.normal(size=(2, 7))
        np.testing.assert_allclose(dynamics.torque(q, qd, qdd), pin.rnea(model, data, q, qd, qdd), rtol=0, atol=1e-9)
    assert set(robot.capsules) == {f"link_{i}" for i in range(1, 8)}


def test_the_shipped_iiwa14_is_where_another_source_has_it(tmp_path: Path) -> None:
    robot, other = load_srs("iiwa14"), added(tmp_path, urdf(tmp_path))
    q = np.random.default_rng(4).uniform(-RANGES, RANGES, (50, 7))
    np.testing.assert_allclose(robot.forward(q), other.forward(q), rtol=0, atol=1e-12)
    limits = robot.profile()
    np.testing.assert_allclose(limits.upper, RANGES, rtol=0, atol=1e-12)
    assert robot.torque.tolist() == [320, 320, 176, 176, 110, 40, 40]
    assert np.degrees(limits.velocity).round(9).tolist() == [85, 85, 100, 75, 130, 135, 135]


@pytest.mark.parametrize(
    ("change", "joint"),
    [
        ({3: ("0.08 0 0.2155", OUT)}, "joint_4"),  # an elbow with an offset, as a Panda's
        ({3: ("0 0 0.2155", UP)}, "joint_4"),  # which turns the other way
        ({6: ("0.05 0.081 0", BACK)}, "joint_7"),  # a wrist whose axes do not meet
    ],
)
def test_an_arm_of_another_structure_is_refused_at_its_joint(
    tmp_path: Path, change: dict[int, tuple[str, str]], joint: str
) -> None:
    path = urdf(tmp_path, [change.get(i, one) for i, one in enumerate(STACK)])
    with pytest.raises(InputError, match=joint) as error:
        new_robot(path, "mine")
    assert error.value.file == str(path)


@pytest.mark.parametrize("given", [{"track": True}, {"confdata": "none"}])
def test_what_is_for_six_axes_is_refused(tmp_path: Path, given: dict[str, bool | str]) -> None:
    with pytest.raises(InputError, match="seven"):
        new_robot(urdf(tmp_path), "mine", **given)  # type: ignore[arg-type]


def test_an_arm_without_torque_ranges_and_one_of_five_axes_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="effort"):
        new_robot(urdf(tmp_path, effort=0), "mine")
    with pytest.raises(InputError, match="wanted six"):
        new_robot(urdf(tmp_path, STACK[:5]), "mine")
