"""Poses for controllers: every preset's messages read back by rosbags, which has ROS 2's own definitions."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp

from trajopt_cli.cli import run
from trajopt_cli.errors import InputError
from trajopt_cli.exporters.poses import ToolPoses

TASK = """\
start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
base: {position: [0.1, 0.2, 0.3]}
profile: trapezoid
rotation: slerp
poses:
  - {name: start, at: start, dwell: 0.1}
  - {name: down, by: [0, 0, -0.02, 0, 0, 0], dwell: 0.3, force: 20 N}
  - {name: turned, by: [0.05, 0, 0, 20 deg, 0, 10 deg], force: 20 N}
force: {by: wrench}
v_max: 0.1
omega_max: 1
a_max: 1
epsilon_max: 5
K: [1500, 1500, 800, 60, 50, 40]
D: [300, 300, 300, 20, 20, 20]
M: [25, 25, 25, 3, 3, 3]
"""
K = [1500.0, 1500, 800, 60, 50, 40]
BASE = np.array([0.1, 0.2, 0.3])
FZI, MAYR = "/cartesian_compliance_controller", "/CartesianImpedance_trajectory_controller"
POSE, WRENCH = "geometry_msgs/msg/PoseStamped", "geometry_msgs/msg/WrenchStamped"
WANTED = {
    "ros": {"/target_pose": POSE, "/target_twist": POSE.replace("Pose", "Twist"), "/target_wrench": WRENCH,
            "/target_stiffness": WRENCH},
    "lbr": {"/lbr/command/pose": "geometry_msgs/msg/Pose",
            "/lbr/command/wrench": "lbr_fri_idl/msg/LBRWrenchCommand"},
    "cartesian": {f"{FZI}/target_frame": POSE, f"{FZI}/target_wrench": WRENCH},
    "crisp": {"/target_pose": POSE, "/target_wrench": WRENCH, "/target_joint": "sensor_msgs/msg/JointState",
              "/target_stiffness": "std_msgs/msg/Float64MultiArray"},
    "impedance": {f"{MAYR}/reference_pose": POSE, f"{MAYR}/set_cartesian_wrench": WRENCH,
                  f"{MAYR}/set_cartesian_stiffness": WRENCH},
}  # fmt: skip


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Results with joints."""
    place = tmp_path_factory.mktemp("poses")
    (place / "task.yaml").write_text(TASK)
    assert run(["iiwa", "segments", str(place / "task.yaml"), "--output", str(place / "out"), "-q"]) == 0
    assert run(["iiwa", "joints", str(place / "out"), "-q"]) in (0, 1)
    assert (place / "out/joints.csv").is_file()
    return place / "out"


def read(path: Path) -> dict[str, tuple[str, list[tuple[int, Any]]]]:
    """By topic the type, and the messages with their times [ns]."""
    rosbag2, typesys = pytest.importorskip("rosbags.rosbag2"), pytest.importorskip("rosbags.typesys")
    store = typesys.get_typestore(typesys.Stores.ROS2_HUMBLE)
    store.register(
        typesys.get_types_from_msg("float64[7] joint_position\nfloat64[6] wrench", WANTED["lbr"]["/lbr/command/wrench"])
    )
    found: dict[str, tuple[str, list[tuple[int, Any]]]] = {}
    with rosbag2.Reader(path) as reader:
        for connection in reader.connections:
            said = typesys.get_types_from_msg(connection.msgdef.data, connection.msgtype)
            assert {name: store.get_msgdef(name).fields for name in said} == {
                name: fields for name, (_, fields) in said.items()
            }
        for connection, time, raw in reader.messages():
            message = store.deserialize_cdr(raw, connection.msgtype)
            found.setdefault(connection.topic, (connection.msgtype, []))[1].append((time, message))
    return found


def vector(one: Any) -> list[float]:
    return [one.x, one.y, one.z]


def six(wrench: Any) -> list[float]:
    return [*vector(wrench.force), *vector(wrench.torque)]


@pytest.mark.parametrize("stack", WANTED)
def test_every_stack_gets_its_messages(folder: Path, tmp_path: Path, stack: str) -> None:
    pytest.importorskip("mcap_ros2")
    output = tmp_path / "poses.mcap"
    assert run(["export", "poses", str(folder), "--for", stack, "--rate", "1000", "--output", str(output), "-q"]) == 0
    found = read(output)
    assert {topic: kind for topic, (kind, _) in found.items()} == WANTED[stack]
    rows = np.genfromtxt(folder / "equilibrium_quaternion.csv", delimiter=",", skip_header=1)
    joints = np.genfromtxt(folder / "joints.csv", delimiter=",", skip_header=1)[:, 1:8]
    based = stack in ("lbr", "cartesian", "crisp")
    (poses,) = (messages for kind, messages in found.values() if kind == POSE or kind.endswith("/Pose"))
    np.testing.assert_allclose([1e-9 * time for time, _ in poses], rows[:, 0], atol=1e-9)
    plain = [one.pose if hasattr(one, "pose") else one for _, one in poses]
    np.testing.assert_allclose([vector(one.position) for one in plain], rows[:, 1:4] - based * BASE, atol=1e-12)
    given = Rotation.from_quat([[*vector(one.orientation), one.orientation.w] for one in plain])
    own = Rotation.from_quat(rows[:, [5, 6, 7, 4]])
    assert (given.inv() * own).magnitude().max() < 1e-9
    if stack != "lbr":
        frame = {"cartesian": "base_link", "crisp": "iiwa_base"}.get(stack, "world")
        assert {one.header.frame_id for _, one in poses} == {frame}
    # 20 N along the tool's axis on the way to the last pose
    press = 20 * own.as_matrix()[-1, :, 2]
    for topic, (kind, messages) in found.items():
        if kind.endswith("LBRWrenchCommand"):
            np.testing.assert_allclose([one.joint_position for _, one in messages], joints, atol=1e-12)
            np.testing.assert_allclose(messages[-1][1].wrench, [*press, 0, 0, 0], atol=1e-9)
        elif kind == WRENCH and "wrench" in topic:
            last = messages[-1][1]
            wanted = [0, 0, 20] if stack == "cartesian" else press
            np.testing.assert_allclose(six(last.wrench), [*wanted, 0, 0, 0], atol=1e-9)
            assert last.header.frame_id == ("tool0" if stack == "cartesian" else poses[0][1].header.frame_id)
        elif "stiffness" in topic:
            ((time, one),) = messages
            assert (time, six(one.wrench) if kind == WRENCH else list(one.data)) == (0, K)
        elif kind.endswith("JointState"):
            assert messages[0][1].name == [f"joint_a{i}" for i in range(1, 8)]
            np.testing.assert_allclose([one.position for _, one in messages], joints, atol=1e-12)


def test_between_the_rows_the_csv_is_straight(folder: Path, tmp_path: Path) -> None:
    output = tmp_path / "poses.csv"
    assert run(["export", "poses", str(folder), "--rate", "333", "--output", str(output), "-q"]) == 0
    table = np.genfromtxt(output, delimiter=",", names=True)
    rows = np.genfromtxt(folder / "equilibrium_quaternion.csv", delimiter=",", skip_header=1)
    t = table["t_s"]
    np.testing.assert_allclose(np.diff(t)[:-1], 1 / 333, atol=1e-9)
    assert t[-1] == pytest.approx(rows[-1, 0], abs=1e-9)
    for i, name in enumerate("xyz"):
        np.testing.assert_allclose(table[f"{name}_m"], np.interp(t, rows[:, 0], rows[:, 1 + i]), atol=1e-10)
    own = Slerp(rows[:, 0], Rotation.from_quat(rows[:, [5, 6, 7, 4]]))(np.minimum(t, rows[-1, 0]))
    given = Rotation.from_quat(np.column_stack([table[f"q{a}_1"] for a in "xyzw"]))
    assert (own.inv() * given).magnitude().max() < 1e-9
    back = np.cumsum(table["vx_ms"][:-1] * np.diff(t))  # the twist leads from row to row
    np.testing.assert_allclose(back, table["x_m"][1:] - table["x_m"][0], atol=1e-9)
    spun = Rotation.from_rotvec(np.column_stack([table[f"w{a}_rads"] for a in "xyz"])[:-1] * np.diff(t)[:, None])
    assert ((spun * given[:-1]).inv() * given[1:]).magnitude().max() < 1e-9
    assert table["kz_Nm"][0] == 800


def test_what_cannot_be_exported_is_told(folder: Path, tmp_path: Path) -> None:
    for options in (["--rate", "0"], ["--output", str(tmp_path / "poses.txt")]):
        assert run(["export", "poses", str(folder), *options]) == 2
    turned = np.eye(4)
    turned[:2, :2] = [[0, -1], [1, 0]]
    still = ToolPoses(np.arange(2.0), np.zeros((2, 3)), np.tile(np.eye(3), (2, 1, 1)), np.zeros((2, 6)), np.array(K))
    with pytest.raises(InputError):
        still.seen_from(turned)
