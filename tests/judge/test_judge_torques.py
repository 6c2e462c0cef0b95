"""The judge on torques: motions of the first axis alone, whose torque is inertia times acceleration in closed form."""

from dataclasses import replace
from math import degrees

import numpy as np
import pytest
from heavy_cells import START, first_axis_inertia, heavy, swing
from small_cells import rapid

from trajopt_cli.joint_csv import read_csv_text, write_csv_text
from trajopt_cli.judge.verify import verify
from trajopt_cli.trajectory import Trajectory

WAY = 0.3
END = START + np.eye(6)[0] * WAY


def program(q=END, tool="tool0", before="", data=""):
    text = ",".join(f"{degrees(v):.15g}" for v in q)
    return rapid(
        f"{before}\nMoveAbsJ j_end, v7000, fine, {tool};",
        data=f"{data}CONST jointtarget j_end:=[[{text}],[9E9,9E9,9E9,9E9,9E9,9E9]];",
    )


def torques(report):
    return {f.subject: f for f in report.findings if f.check == "joint torque"}


@pytest.mark.parametrize("grid", ["our rows", "with speeds", "bare"])
def test_one_per_cent_too_much_is_seen_and_a_hair_less_is_legal(grid):
    plant = heavy()
    top = plant.limits.torque[0] / first_axis_inertia(plant, START)
    assert top < plant.limits.acceleration[0]
    for share, legal in ((1 - 1e-4, True), (1.01, False)):
        rows = swing(plant, WAY, share * top, speeds=grid == "our rows")
        if grid == "with speeds":
            rows = replace(swing(plant, WAY, share * top, speeds=False), qd=None)
            rows = Trajectory(rows.names, rows.t, rows.q, np.gradient(rows.q, rows.t, axis=0))
        report = verify(program(), plant, rows, advice=False)
        found = torques(report)
        assert [*found] == list(plant.robot.axis_names)
        assert found["joint_1"].passed is legal
        assert all(found[name].passed for name in found if name != "joint_1")
        assert found["joint_1"].value == pytest.approx(share * 220, rel=1e-6 if grid == "our rows" else 5e-3)
        if grid == "our rows":
            assert report.legal is legal
            if not legal:
                assert "t.mod:6:1: joint_1 torque 222.2 Nm at t = " in found["joint_1"].message
                assert found["joint_1"].message.endswith(", limit 220")


def test_a_written_file_with_few_digits_is_not_called_illegal_for_them():
    plant = heavy()
    top = plant.limits.torque[0] / first_axis_inertia(plant, START)
    rows = swing(plant, WAY, top * (1 - 1e-4))
    text = write_csv_text(rows)
    short = "\n".join(
        line if i == 0 else ",".join(f"{float(x):.6f}" for x in line.split(","))
        for i, line in enumerate(text.split("\n")[:-1])
    )
    trajectory, resolution = read_csv_text(short + "\n", "x.csv")
    assert torques(verify(program(), plant, trajectory, resolution, advice=False))["joint_1"].passed


TOOL = (
    "PERS tooldata t1:=[TRUE,[[0,0,100],[0.707106781186548,0,0.707106781186548,0]],[4,[30,0,80],[1,0,0,0],0,0,0]];"
    "PERS loaddata l1:=[3,[50,0,20],[1,0,0,0],0,0,0];"
)


def test_the_tools_mass_and_what_it_holds_count():
    """tload in the flange's frame, GripLoad in the tool's, which lies across: its x points to the flange's -z."""
    plant = heavy()
    tool, held = (4.0, np.array([0.03, 0, 0.08])), (3.0, np.array([0.02, 0, 0.05]))
    bare = first_axis_inertia(plant, START)
    with_tool = first_axis_inertia(plant, START, tool)
    both = with_tool + first_axis_inertia(plant, START, held) - bare
    rows = swing(plant, WAY, 10.0)
    cases = ((program(), bare), (program(tool="t1", data=TOOL), with_tool),
             (program(tool="t1", data=TOOL, before="GripLoad l1;"), both))  # fmt: skip
    for asked, inertia in cases:
        assert torques(verify(asked, plant, rows, advice=False))["joint_1"].value == pytest.approx(
            inertia * 10, rel=1e-6
        )


def test_nothing_is_said_of_torques_that_nobody_limits():
    plant = heavy(binds=False)
    assert not torques(verify(program(), plant, swing(plant, WAY, 30.0), advice=False))


def test_a_wait_is_held_against_gravity():
    """At rest joint 2 holds what is before it: too weak a drive shows although nothing moves."""
    plant = heavy()
    still = Trajectory(plant.robot.axis_names, np.array([0.0, 0.5]), np.tile(START, (2, 1)), np.zeros((2, 6)))
    asked = program(q=START, before="WaitTime 0.5;")
    need = torques(verify(asked, plant, still, advice=False))["joint_2"].value
    assert need > 10
    weak = replace(plant.limits, torque=np.where(np.arange(6) == 1, need * 0.99, plant.limits.torque))
    found = torques(verify(asked, replace(plant, limits=weak), still, advice=False))
    assert [name for name in found if not found[name].passed] == ["joint_2"]
