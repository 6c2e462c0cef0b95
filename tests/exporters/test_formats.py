"""Motions as ROS 2 messages, Parquet and FRI rows, each read back by the reader of its own world."""

from __future__ import annotations

import builtins
from io import BytesIO
from typing import Any

import numpy as np
import pytest
from ruamel.yaml import YAML

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.parquet import parquet
from trajopt_cli.exporters.recorded import Recorded, fri_rows
from trajopt_cli.exporters.ros2 import trajectory_parts
from trajopt_cli.joint_csv import header
from trajopt_cli.trajectory import Trajectory

NAMES = tuple(f"joint_{i}" for i in range(1, 8))


def motion(h: float = 1e-3, n: int = 41) -> Trajectory:
    t = np.arange(n) * h
    s = np.linspace(0, 1, n)[:, None] * np.arange(1, 8)
    return Trajectory(NAMES, t, 1e-3 * np.sin(s) - 2e-5, 1e-3 * np.cos(s) * np.arange(1, 8) / t[-1])


def as_yaml_1_1(text: str) -> Any:
    """As PyYAML, which ROS 2 reads with: by YAML 1.1, where 1e-05 is text."""
    yaml = YAML(typ="safe", pure=True)
    yaml.version = (1, 1)
    return yaml.load(text)


def test_a_joint_trajectory_is_a_message_of_ros_2() -> None:
    """rosbags has the message's definition and packs it as ROS does: every field there, of its type and length."""
    typesys = pytest.importorskip("rosbags.typesys")
    store = typesys.get_typestore(typesys.Stores.ROS2_HUMBLE)
    given = motion(h=0.3)
    content = as_yaml_1_1("".join(trajectory_parts(given)))

    def message(name: str, value: dict[str, Any]) -> Any:
        return store.types[name](**value)

    stamp = message("builtin_interfaces/msg/Time", content["header"].pop("stamp"))
    header_ = message("std_msgs/msg/Header", {"stamp": stamp, **content["header"]})
    points = []
    for point in content["points"]:
        since = message("builtin_interfaces/msg/Duration", point.pop("time_from_start"))
        arrays = {key: np.array(value, dtype=np.float64) for key, value in point.items()}
        points.append(message("trajectory_msgs/msg/JointTrajectoryPoint", {**arrays, "time_from_start": since}))
    name = "trajectory_msgs/msg/JointTrajectory"
    whole = message(name, {"header": header_, "joint_names": content["joint_names"], "points": points})
    back = store.deserialize_cdr(store.serialize_cdr(whole, name), name)
    assert back.joint_names == list(NAMES)
    times = [point.time_from_start.sec + 1e-9 * point.time_from_start.nanosec for point in back.points]
    np.testing.assert_allclose(times, given.t, rtol=0, atol=1e-9)
    assert all(0 <= point.time_from_start.nanosec < 10**9 for point in back.points)
    np.testing.assert_allclose([point.positions for point in back.points], given.q, rtol=0, atol=5e-13)
    assert given.qd is not None
    np.testing.assert_allclose([point.velocities for point in back.points], given.qd, rtol=0, atol=5e-13)
    assert {len(point.effort) for point in back.points} == {0}


def test_accelerations_are_the_motions_own() -> None:
    t = np.array([0.0, 0.1, 0.3, 0.35, 0.6])  # rows of any gaps: a parabola's second differences are its acceleration
    q = np.stack([1.5 * t * t, -2 * t * t], axis=1)
    text = "".join(trajectory_parts(Trajectory(("a", "b"), t + 5, q, 2 * q), ["left/arm", "lbr_A2"]))
    content = as_yaml_1_1(text)
    assert content["joint_names"] == ["left/arm", "lbr_A2"]
    found = np.array([point["accelerations"] for point in content["points"]])
    np.testing.assert_allclose(found[1:-1], [[3, -4]] * 3, rtol=0, atol=1e-11)
    assert not found[[0, -1]].any()
    assert content["points"][0]["time_from_start"] == {"sec": 0, "nanosec": 0}
    assert "-0.000000000000" not in text


@pytest.mark.parametrize("names", [["a"], ["a"] * 7, ["a b", *NAMES[1:]], ["", *NAMES[1:]], ["1a", *NAMES[1:]]])
def test_names_that_are_none_are_refused(names: list[str]) -> None:
    with pytest.raises(InputError, match="are not 7 different names, one each for joint_1"):
        "".join(trajectory_parts(motion(), names))


def test_parquet_has_the_columns_of_the_csv_to_the_last_bit() -> None:
    reader = pytest.importorskip("pyarrow.parquet")
    given = motion()
    content = parquet(given)
    found = reader.read_table(BytesIO(content))
    assert found.column_names == header(NAMES, speeds=True)
    assert {str(kind) for kind in found.schema.types} == {"double"}
    assert given.qd is not None
    table = np.column_stack([column.to_numpy() for column in found.columns])
    np.testing.assert_array_equal(table, np.column_stack([given.t, given.q, given.qd]))
    assert parquet(given) == content
    without = reader.read_table(BytesIO(parquet(Trajectory(NAMES, given.t, given.q))))
    assert without.column_names == header(NAMES, speeds=False)


@pytest.mark.parametrize(
    ("missing", "said"),
    [
        ("pyarrow", "pyarrow is not installed: pip install 'trajopt-cli[parquet]'"),
        ("libarrow", "pyarrow cannot be imported: no libarrow; pip install --force-reinstall 'trajopt-cli[parquet]'"),
    ],
)
def test_without_pyarrow_the_extra_is_named(missing: str, said: str, monkeypatch: pytest.MonkeyPatch) -> None:
    real = builtins.__import__

    def fail(name: str, *rest: Any) -> Any:
        if name.startswith("pyarrow"):
            raise ImportError(f"no {missing}", name=missing)
        return real(name, *rest)

    monkeypatch.setattr(builtins, "__import__", fail)
    with pytest.raises(InputError) as caught:
        parquet(motion())
    assert str(caught.value) == said


def test_fri_rows_are_the_joints_of_every_millisecond() -> None:
    given = motion()
    text, count, note = fri_rows(Recorded("the arm's joints", given, period=1e-3))
    lines = text.splitlines()
    assert lines[0] == "A1 [rad],A2 [rad],A3 [rad],A4 [rad],A5 [rad],A6 [rad],A7 [rad]"
    np.testing.assert_array_equal([[float(field) for field in line.split(",")] for line in lines[1:]], given.q)
    assert (count, note) == (41, "")


def test_fri_takes_another_period_only_where_it_is_asked_to() -> None:
    slow = Recorded("the arm's joints", motion(h=4e-3), period=4e-3)
    with pytest.raises(InputError, match="its rows stand 4 ms apart, FRI's here 1 ms; give --resample"):
        fri_rows(slow)
    text, count, note = fri_rows(slow, between=True)
    assert count == 40 * 4 + 4 + 1
    assert len(text.splitlines()) == count + 1
    assert "4 ms longer" in note


def test_fri_is_for_seven_axes_of_a_sequence() -> None:
    six = Trajectory(NAMES[:6], motion().t, motion().q[:, :6])
    for one in (Recorded("the stream plan", motion()), Recorded("the arm's joints", six, period=1e-3)):
        with pytest.raises(InputError, match="FRI is KUKA's"):
            fri_rows(one)
