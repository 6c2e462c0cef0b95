"""MCAP, read back by rosbags, which shares no code with the writer's library and has ROS 2's own definitions."""

from __future__ import annotations

import builtins
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from test_formats import NAMES, motion

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.ros2 import mcap
from trajopt_cli.trajectory import Trajectory


@pytest.fixture
def read(tmp_path: Path) -> Any:
    """What rosbags finds in a file: by topic the type, and the messages with their times [ns]."""
    pytest.importorskip("mcap_ros2")
    rosbag2, typesys = pytest.importorskip("rosbags.rosbag2"), pytest.importorskip("rosbags.typesys")
    store = typesys.get_typestore(typesys.Stores.ROS2_HUMBLE)

    def read(content: bytes) -> dict[str, tuple[str, list[tuple[int, Any]]]]:
        (path := tmp_path / "motion.mcap").write_bytes(content)
        found: dict[str, tuple[str, list[tuple[int, Any]]]] = {}
        with rosbag2.Reader(path) as reader:
            for connection in reader.connections:
                said = typesys.get_types_from_msg(connection.msgdef.data, connection.msgtype)
                assert {name: (None, store.get_msgdef(name).fields) for name in said} == {
                    name: (None, fields) for name, (_, fields) in said.items()
                }, "the definitions in the file are ROS 2's"
            for connection, time, raw in reader.messages():
                message = store.deserialize_cdr(raw, connection.msgtype)
                found.setdefault(connection.topic, (connection.msgtype, []))[1].append((time, message))
        return found

    return read


def seconds(stamp: Any) -> float:
    assert 0 <= stamp.nanosec < 10**9
    return float(stamp.sec + 1e-9 * stamp.nanosec)


def test_bag_tools_find_the_plan_once_and_every_state_at_its_time(read: Any) -> None:
    given = motion(h=0.3, n=11)
    assert given.qd is not None
    found = read(mcap(Trajectory(NAMES, given.t + 7, given.q, given.qd)))
    assert set(found) == {"/joint_states", "/joint_trajectory"}
    type_, states = found["/joint_states"]
    assert type_ == "sensor_msgs/msg/JointState"
    np.testing.assert_allclose([1e-9 * time for time, _ in states], given.t, rtol=0, atol=1e-9)
    np.testing.assert_allclose([seconds(one.header.stamp) for _, one in states], given.t, rtol=0, atol=1e-9)
    np.testing.assert_array_equal([one.position for _, one in states], given.q)
    np.testing.assert_array_equal([one.velocity for _, one in states], given.qd)
    assert {tuple(one.name) for _, one in states} == {NAMES}
    type_, ((time, plan),) = found["/joint_trajectory"]
    assert (type_, time) == ("trajectory_msgs/msg/JointTrajectory", 0)
    assert plan.joint_names == list(NAMES)
    np.testing.assert_allclose([seconds(one.time_from_start) for one in plan.points], given.t, rtol=0, atol=1e-9)
    np.testing.assert_array_equal([one.positions for one in plan.points], given.q)
    np.testing.assert_array_equal([one.velocities for one in plan.points], given.qd)
    assert {len(one.accelerations) for one in plan.points} == {7}


def test_names_of_ros_and_the_same_bytes_for_the_same_motion(read: Any) -> None:
    names = [f"arm/{name}" for name in NAMES]
    content = mcap(motion(), names)
    assert read(content)["/joint_states"][1][0][1].name == names
    assert mcap(motion(), names) == content
    with pytest.raises(InputError, match="are not 7 different names"):
        mcap(motion(), ["a"])


def test_without_its_library_the_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    real = builtins.__import__

    def fail(name: str, *rest: Any) -> Any:
        if name.startswith("mcap_ros2"):
            raise ImportError("no mcap_ros2", name="mcap_ros2")
        return real(name, *rest)

    monkeypatch.setattr(builtins, "__import__", fail)
    with pytest.raises(InputError) as caught:
        mcap(motion())
    assert str(caught.value) == "mcap-ros2-support is not installed: pip install 'trajopt-cli[mcap]'"
