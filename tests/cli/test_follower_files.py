"""Files of a plan on two base axes of which a third one follows the first: all of them have that one's column."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from arms import abb_like
from ruamel.yaml import YAML

from trajopt_cli.cli import run
from trajopt_cli.exporters.recorded import recorded
from trajopt_cli.job import read_results_job
from trajopt_cli.joint_csv import read_csv_text
from trajopt_cli.pipeline.folder import plans_of_results, verify_results
from trajopt_cli.problem.plan import Target

PROGRAM = """MODULE t
  PROC main()
    MoveAbsJ [[0,40,10,0,30,0],[200,50,9E9,9E9,9E9,-380]], v500, fine, tool0;
  ENDPROC
ENDMODULE
"""
CELL = """robot: arm.yaml
axes:
  eax_a: {axis: [1, 0, 0], stroke: [0, 1]}
  eax_b: {axis: [0, 1, 0], stroke: [0, 1]}
  eax_f: {follows: eax_a, ratio: -2, offset: 20 mm}
start: {joints: "[0, 40, 0, 0, 30, 0] deg", rail: [0, 0]}
"""
NAMES = ("rail_a", "rail_f", "rail_b", *(f"joint_{i + 1}" for i in range(6)))


@pytest.fixture
def results(tmp_path, monkeypatch, capsys):
    """A folder of an arm with a parallel linkage, whose joint 3 ROS has otherwise."""
    monkeypatch.chdir(tmp_path)
    replace(abb_like(0.1, 0.6, 0.7, -0.13, 0.75, 0.085), linked=True).load(tmp_path)
    (tmp_path / "t.mod").write_text(PROGRAM)
    (tmp_path / "t.yaml").write_text(CELL)
    assert run(["optimize", "t.mod", "--output", "out", "--time-limit", "0", "--quiet"]) == 0
    return tmp_path / "out"


def test_a_column_of_what_follows_is_in_every_file_and_judged(results, capsys) -> None:
    for name in ("trajectory.csv", "stream.csv", "rapid.csv"):
        rows, _ = read_csv_text((results / name).read_text(), name)
        assert rows.names == NAMES
        np.testing.assert_allclose(rows.q[:, 1], 0.02 - 2 * rows.q[:, 0], atol=1e-12)
        assert rows.q[-1, 1] == pytest.approx(-0.38)
    for report in verify_results(results)[1].values():
        assert report.legal
        assert "rail_f" in {one.subject for one in report.findings if one.check == "follower"}
    rows = recorded(results).trajectory
    for kind in ("ros2", "mcap", "gltf", "egm"):
        assert run(["export", kind, str(results), "--output", f"of.{kind}", "--rate", "100"]) == 0
    message = YAML(typ="safe").load((results.parent / "of.ros2").read_text())
    assert tuple(message["joint_names"]) == NAMES
    first = np.array(message["points"][0]["positions"])
    np.testing.assert_allclose(first - rows.q[0], np.where(np.array(NAMES) == "joint_3", -rows.q[0, 4], 0), atol=1e-9)
    reader = pytest.importorskip("mcap_ros2.reader")
    states = [one.ros_msg for one in reader.read_ros2_messages(str(results.parent / "of.mcap"), ["/joint_states"])]
    assert tuple(states[-1].name) == NAMES
    assert states[-1].position[1] == pytest.approx(-0.38, abs=1e-9)
    for plan in plans_of_results(results, read_results_job(results)).values():
        assert plan.trajectory.names == tuple(name for name in NAMES if name != "rail_f")
        assert plan.target in Target
