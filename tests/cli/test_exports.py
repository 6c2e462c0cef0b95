"""`trajopt export joint|ros2|mcap|parquet|fri` of plans and of an iiwa's joints."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.cli import run
from trajopt_cli.joint_csv import read_csv_text

TASK = """\
start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
h: 2 ms
profile: trapezoid
poses: [start, {by: [0, 0.05, 0, 0, 0, 10 deg]}]
v_max: 0.2
omega_max: 1
a_max: 1
epsilon_max: 5
K: [1000, 1000, 1000, 30, 30, 30]
D: [500, 500, 500, 20, 20, 20]
M: [25, 25, 25, 3, 3, 3]
"""


@pytest.fixture
def arm(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Path:
    (tmp_path / "task.yaml").write_text(TASK)
    folder = tmp_path / "arm"
    assert run(["iiwa", "segments", str(tmp_path / "task.yaml"), "--output", str(folder)]) == 0
    assert run(["iiwa", "joints", str(folder)]) == 0
    capsys.readouterr()
    return folder


def test_an_arms_joints_leave_in_every_form_and_stay_legal(arm: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out, task = arm.parent, str(arm.parent / "task.yaml")
    own, _ = read_csv_text((arm / "joints.csv").read_text(), "joints.csv")
    for rate, said in ((250, ""), (500, ""), (1000, "; between the rows: within their limits")):
        assert run(["export", "joint", str(arm), "--rate", str(rate), "--output", str(out / "j.csv")]) == 0
        assert "j.csv: the arm's joints, " in (printed := capsys.readouterr().out)
        assert said in printed
        assert run(["verify", str(out / "j.csv"), "--task", task]) == 0
        capsys.readouterr()
    for kind, name in (("ros2", "j.yaml"), ("mcap", "j.mcap"), ("parquet", "j.parquet")):
        pytest.importorskip({"mcap": "mcap_ros2", "parquet": "pyarrow"}.get(kind, "json"))
        assert run(["export", kind, str(arm), "--output", str(out / name)]) == 0
        assert f"{name}: the arm's joints, " in capsys.readouterr().out
    assert (out / "j.yaml").read_text().count("positions:") == len(own.t) // 5 + 1 + ((len(own.t) - 1) % 5 > 0)
    assert run(["export", "fri", str(arm), "--output", str(out / "fri.csv")]) == 2
    assert "its rows stand 2 ms apart" in (error := capsys.readouterr().err)
    assert error.startswith(f"{arm}: ")
    assert not (out / "fri.csv").exists()
    assert run(["export", "fri", str(arm), "--resample", "--output", str(out / "fri.csv")]) == 0
    rows = np.loadtxt(out / "fri.csv", delimiter=",", skiprows=1)
    np.testing.assert_array_equal(rows[[0, -1]], own.q[[0, -1]])
    assert f"fri.csv: the arm's joints, {len(rows)} rows of 1 ms; between the rows" in capsys.readouterr().out


def test_a_plan_leaves_in_every_form_but_fri(results: Path, capsys: pytest.CaptureFixture[str]) -> None:
    names = "rail,a1,a2,a3,a4,a5,a6" if "rail" in Path("results/tiny/trajectory.csv").read_text()[:40] else None
    joints = ["--joints", names or "a1,a2,a3,a4,a5,a6"]
    assert run(["export", "ros2", "results/tiny", *joints, "--output", "j.yaml"]) == 0
    assert "j.yaml: the stream plan, " in capsys.readouterr().out
    assert "a1, a2, a3, a4, a5, a6]\n" in Path("j.yaml").read_text()
    pytest.importorskip("pyarrow")
    assert run(["export", "parquet", "results/tiny", "--output", "j.parquet"]) == 0
    rows = len(Path("results/tiny/trajectory.csv").read_text().splitlines()) - 1
    assert f"j.parquet: the stream plan, {rows} rows as recorded" in capsys.readouterr().out
    assert run(["export", "gltf", "results/tiny", "--output", "j.glb"]) == 0
    assert "j.glb: the stream plan, " in capsys.readouterr().out
    assert Path("j.glb").read_bytes()[:4] == b"glTF"
    assert run(["export", "fri", "results/tiny", "--output", "j.csv"]) == 2
    assert capsys.readouterr().err == (
        "results/tiny: is no motion of an LBR iiwa; FRI is KUKA's, give a folder of trajopt iiwa\n"
    )


def test_what_is_for_plans_only_refuses_an_arms_joints(arm: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for kind, said in (
        ("egm", "is no motion of a six-axis robot; EGM is ABB's, give a folder of trajopt optimize"),
        ("gltf", "holds no plan in a cell; give a folder of trajopt optimize"),
    ):
        assert run(["export", kind, str(arm), "--output", str(arm.parent / "x")]) == 2
        assert capsys.readouterr().err == f"{arm}: {said}\n"


@pytest.mark.parametrize("kind", ["joint", "ros2", "mcap", "parquet", "fri"])
def test_what_cannot_be_exported_is_one_line(kind: str, arm: Path, capsys: pytest.CaptureFixture[str]) -> None:
    bare, out = arm.parent / "bare", str(arm.parent / "x")
    assert run(["iiwa", "segments", str(arm.parent / "task.yaml"), "--output", str(bare)]) == 0
    capsys.readouterr()
    for folder, said in (
        (bare, "has no joints.csv; make it with trajopt iiwa joints"),
        (arm.parent / "nowhere", "does not exist; make it with trajopt optimize"),
        (arm.parent, "is not a results folder of trajopt (no run.json)"),
    ):
        assert run(["export", kind, str(folder), "--output", out]) == 2
        assert capsys.readouterr().err == f"{folder}: {said}\n"
    assert run(["export", kind, str(arm), "--output", str(arm / "joints.csv")]) == 2
    assert "is a file of a results folder" in capsys.readouterr().err
    (arm / "joints.csv").write_text("t [s]\n")
    assert run(["export", kind, str(arm), "--output", out]) == 2
    assert "joints.csv: was changed since the run; make the folder again" in capsys.readouterr().err
    assert not Path(out).exists()
