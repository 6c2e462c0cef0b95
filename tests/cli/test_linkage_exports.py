"""A plan of an arm with a parallel linkage in files: whose joint 3 each of them has."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from arms import abb_like
from ruamel.yaml import YAML

from trajopt_cli.cli import run
from trajopt_cli.joint_csv import read_csv_text

HOME = "[9E9,9E9,9E9,9E9,9E9,9E9]"
PROGRAM = f"""MODULE t
  PROC main()
    MoveAbsJ [[0,40,10,0,30,0],{HOME}], v500, fine, tool0;
    MoveL Offs(CRobT(),0,50,0), v200, fine, tool0;
  ENDPROC
ENDMODULE
"""


def test_files_of_a_plan_have_the_controllers_axes_and_those_of_ros_the_urdfs_joints(
    tmp_path, monkeypatch, capsys
) -> None:
    monkeypatch.chdir(tmp_path)
    replace(abb_like(0.1, 0.6, 0.7, -0.13, 0.75, 0.085), linked=True).load(tmp_path)
    (tmp_path / "t.mod").write_text(PROGRAM)
    (tmp_path / "t.yaml").write_text('robot: arm.yaml\nstart: {joints: "[0, 40, 0, 0, 30, 0] deg"}\n')
    assert run(["optimize", "t.mod", "--output", "out", "--time-limit", "0", "--quiet"]) == 0
    assert run(["verify", "out", "--quiet"]) == 0
    capsys.readouterr()
    assert run(["export", "joint", "out", "--output", "j.csv", "--rate", "100"]) == 0
    rows = read_csv_text((tmp_path / "j.csv").read_text(), "j.csv")[0]
    np.testing.assert_allclose(np.degrees(rows.q[0]), [0, 40, 0, 0, 30, 0], atol=1e-9)  # the upper arm level
    assert run(["verify", "j.csv", "--program", "t.mod", "--cell", "t.yaml", "--quiet"]) == 0
    capsys.readouterr()
    assert run(["export", "ros2", "out", "--output", "r.yaml", "--rate", "100"]) == 0
    assert "joint_3" in capsys.readouterr().out
    points = YAML(typ="safe").load((tmp_path / "r.yaml").read_text())["points"]
    for key, table in (("positions", rows.q), ("velocities", rows.qd)):
        found = np.array([point[key] for point in points])
        assert table is not None
        np.testing.assert_allclose(found[0, 2], table[0, 2] - table[0, 1], atol=1e-9)
        np.testing.assert_allclose(found[-1, 2], table[-1, 2] - table[-1, 1], atol=1e-9)
        np.testing.assert_allclose(found[-1, [0, 1, 3, 4, 5]], table[-1, [0, 1, 3, 4, 5]], atol=1e-9)
    assert run(["export", "rapid", "out", "--output", "new.mod"]) == 0
    assert "[0,40,10,0,30,0]" in (tmp_path / "new.mod").read_text()


def test_a_place_beyond_axis_3_is_told_as_one_of_axis_3(tmp_path, monkeypatch, capsys) -> None:
    """The URDF's joint 3 would be in its range there, and as the upper arm points 70 degrees down axis 3 is not."""
    monkeypatch.chdir(tmp_path)
    chain = replace(abb_like(0.1, 0.6, 0.7, -0.13, 0.75, 0.085), linked=True)
    chain.ranges[2] = (-1.1, 1.2)
    chain.load(tmp_path)
    (tmp_path / "t.mod").write_text(PROGRAM.replace("0,40,10,", "0,40,70,"))
    for joints, code in (("0, 40, 0, 0, 30, 0", 1), ("0, 40, 70, 0, 30, 0", 2)):
        (tmp_path / "t.yaml").write_text(f'robot: arm.yaml\nstart: {{joints: "[{joints}] deg"}}\n')
        assert run(["optimize", "t.mod", "--output", "out", "--time-limit", "0"]) == code
        assert "joint_3" in capsys.readouterr().err
