"""What the robot carries, from RAPID's data to one body in the flange's frame; and what plans refuse without masses."""

from math import sqrt

import numpy as np
import pytest
from heavy_cells import heavy
from small_cells import rapid

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.errors import InputError
from trajopt_cli.problem.loads import load_notes, loads_of
from trajopt_cli.problem.plant import build_plant

ACROSS = f"[{sqrt(0.5)!r},0,{sqrt(0.5)!r},0]"
DATA = f"""PERS tooldata t1:=[TRUE,[[0,0,100],{ACROSS}],[4,[30,0,80],[1,0,0,0],0.01,0.02,0.03]];
PERS tooldata t2:=[TRUE,[[0,0,100],[1,0,0,0]],[-1,[0,0,0],[1,0,0,0],0,0,0]];
PERS loaddata l1:=[2,[50,0,20],[1,0,0,0],0.001,0.002,0.003];
CONST jointtarget j_a:=[[0,0,0,0,20,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
"""
BODY = """MoveAbsJ j_a, v100, fine, t1;
GripLoad l1;
MoveAbsJ j_a, v100, fine, t1;
WaitTime 1;
GripLoad load0;
MoveAbsJ j_a, v100, fine, t2;
MoveAbsJ j_a, v100, fine, tool0;"""


def test_a_tool_and_what_it_holds_are_one_body():
    tool, both, waiting, *none = loads_of(rapid(BODY, data=DATA))
    assert none == [None, None]
    assert (tool.mass, tool.com.tolist()) == (4.0, [0.03, 0.0, 0.08])
    np.testing.assert_allclose(tool.inertia, np.diag([0.01, 0.02, 0.03]), atol=1e-15)
    assert waiting is both
    # the tool's frame lies 100 mm out, its x along the flange's -z, its z along the flange's x
    held = np.array([0.02, 0, 0.1 - 0.05])
    assert both.mass == 6.0
    np.testing.assert_allclose(both.com, (4 * tool.com + 2 * held) / 6, atol=1e-15)
    apart = tool.com - held  # two masses: 4 * 2 / 6 of the square of their distance
    square = 8 / 6 * (apart @ apart * np.eye(3) - np.outer(apart, apart))
    np.testing.assert_allclose(both.inertia, np.diag([0.01 + 0.003, 0.022, 0.03 + 0.001]) + square, atol=1e-15)


def test_what_counts_is_told_where_torques_are_limited():
    asked = rapid(BODY, data=DATA)
    assert load_notes(asked, heavy()) == (
        "counted in torques: t1 4 kg, load l1; not counted: the mass of t2, tool0, whose tload says none",
    )
    assert load_notes(asked, heavy(binds=False)) == ()


@pytest.mark.parametrize(
    ("was", "now", "told"),
    [
        ("0.001,0.002,0.003", "0.001,0.002,0.004", r"t.mod:7:?.*load of l1: .*no body's.*correct its inertia"),
        ("[30,0,80],[1,0,0,0]", "[30,0,80],[2,0,0,0]", "aom of t1 is no orientation: its length is 2, wanted 1"),
    ],
)
def test_loads_that_no_body_has_are_refused(was, now, told):
    with pytest.raises(InputError, match=told):
        loads_of(rapid(BODY, data=DATA.replace(was, now)))


def test_a_robot_without_masses_is_refused_with_what_it_lacks():
    cell = 'robot: irb140\nstart: {joints: "[0, 0, 0, 0, 30, 0] deg"}\ntorque_limits: true\n'
    with pytest.raises(InputError) as error:
        build_plant(parse_cell(cell, "cell.yaml"))
    assert str(error.value).startswith("cell.yaml:3: torque_limits: robot irb140 lacks effort of joint_1, ")
    assert "mass of link_6; give each link an <inertial> in its URDF" in str(error.value)
    limits = "limits:\n" + "".join(f"  joint_{i}: {{torque: {10 * i} Nm, source: s}}\n" for i in range(1, 7))
    with pytest.raises(InputError, match="lacks mass of link_1"):
        build_plant(parse_cell(cell + limits, "cell.yaml"))
    plant = build_plant(parse_cell((cell + limits).replace("torque_limits: true\n", ""), "cell.yaml"))
    assert plant.limits.binding_torque is None
    assert plant.limits.torque.tolist() == [10, 20, 30, 40, 50, 60]


def test_the_public_arm_has_all_it_takes():
    cell = 'robot: puma560\nprofile: loose\nstart: {joints: "[0, -60, 120, 0, 30, 0] deg"}\ntorque_limits: true\n'
    plant = build_plant(parse_cell(cell, "cell.yaml"))
    assert plant.limits.binding_torque.tolist() == [97.6, 186.4, 89.4, 24.2, 20.1, 21.3]
    assert plant.robot.rotor.tolist() == [1.14, 4.71, 0.83, 0.2, 0.179, 0.193]
    assert plant.limits.sources["joint_2.torque"].endswith("(grade B)")
