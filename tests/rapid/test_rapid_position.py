"""Where the robot stands: CRobT and its like, against published postures and independent kinematics."""

from __future__ import annotations

import json
from functools import cache
from math import degrees
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.errors import InputError
from trajopt_cli.geometry import rotation_from_wxyz
from trajopt_cli.kinematics import Kinematics
from trajopt_cli.motion import ConfData, MoveAbsJ, MoveJ, MoveL, Program, TextFile
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.problem.programmed import PlantKinematics
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import Scenario
from trajopt_cli.warnings import WarningKind

TRUTH = Path(__file__).parents[1] / "data" / "truth"
N = "[9E9,9E9,9E9,9E9,9E9,9E9]"

# Joints, tool0, its orientation and confdata: eight of an offline simulator, four of one pose's branches.
POSTURES = [
    ("0,0,0,0,0,0", "515,0,712", "0.707107,0,0.707107,0", "0,0,0,0"),
    ("0,0,0,0,30,0", "506.292,0,679.5", "0.5,0,0.866025,0", "0,0,0,0"),
    ("0,0,0,0,90,0", "450,0,647", "0,0,1,0", "0,0,0,0"),
    ("90,0,0,0,0,0", "0,515,712", "0.5,-0.5,0.5,0.5", "1,0,0,0"),
    ("-90,0,0,0,30,0", "0,-506.292,679.5", "0.353553,0.612372,0.612372,-0.353553", "-1,0,0,0"),
    ("30,20,10,45,30,60", "473.030,299.640,452.241", "0.022260,-0.492348,-0.791955,-0.360423", "0,0,0,0"),
    ("-45,-30,20,-100,60,200", "169.069,-247.468,745.025", "0.784108,0.580900,-0.212351,0.051352", "-1,-2,2,0"),
    ("120,40,-60,190,-45,-270", "-365.491,617.086,730.930", "0.494994,-0.816436,-0.199234,0.220725", "1,2,-3,1"),
    ("23.9625,6.7721,-7.1508,90.852,-23.9653,-90.9324", "515,200,712", "0.7071,0,0.7071,0", "0,1,-2,1"),
    ("23.9625,92.3536,-172.849,-24.2578,81.3214,3.8899", "515,200,712", "0.7071,0,0.7071,0", "0,-1,0,2"),
    ("-156.038,-83.6501,-38.9353,152.189,60.5187,14.5523", "515,200,712", "0.7071,0,0.7071,0", "-2,1,0,4"),
    ("-156.038,-31.1061,-141.065,107.04,25.1372,71.296", "515,200,712", "0.7071,0,0.7071,0", "-2,1,0,6"),
]
SINGULAR = {0, 3}  # axis 5 at 0: axes 4 and 6 are one


@cache
def robot(rail: bool = False) -> Kinematics:
    cell: dict[str, Any] = {"robot": "irb140", "start": {"joints": "[0, 0, 0, 0, 30, 0] deg"}}
    if rail:
        cell = {
            "robot": "irb140_rail",
            "rail": {"eax": "a", "stroke": [-0.2, 2.2]},
            "limits": {"rail": {"velocity": 1.0, "acceleration": 3.0, "source": "a test"}},
            "start": {"joints": "[0, 0, 0, 0, 30, 0] deg", "rail": 0},
        }
    return PlantKinematics(build_plant(parse_cell(json.dumps(cell), "cell.yaml")))


def run_main(
    body: str, data: str = "", kinematics: Kinematics | None = None, scenario: Scenario | None = None
) -> Program:
    text = f"MODULE m\n{data}\nPROC main()\n{body}\nENDPROC\nENDMODULE\n"
    return run_program([TextFile("m.mod", text, "utf-8")], scenario, kinematics=kinematics)


def only(program: Program) -> MoveL | MoveJ:
    motion = program.motions[-1]
    assert isinstance(motion, MoveL | MoveJ)
    return motion


def conf_of(text: str) -> ConfData:
    return ConfData(*(int(part) for part in text.split(",")))


@pytest.mark.parametrize(("joints", "position", "orientation", "conf"), POSTURES)
def test_calc_rob_t_gives_the_published_target(joints: str, position: str, orientation: str, conf: str) -> None:
    motion = only(run_main(f"MoveJ CalcRobT([[{joints}],{N}],tool0),v100,fine,tool0;", kinematics=robot()))
    np.testing.assert_allclose(motion.X_WT[:3, 3] * 1e3, [float(v) for v in position.split(",")], atol=0.06)
    wanted = rotation_from_wxyz([float(v) for v in orientation.split(",")])
    np.testing.assert_allclose(motion.X_WT[:3, :3], wanted, atol=2e-4)
    assert motion.conf == conf_of(conf)


@pytest.mark.parametrize("row", [i for i in range(len(POSTURES)) if i not in SINGULAR])
def test_calc_joint_t_gives_the_joints_of_the_configuration_back(row: int) -> None:
    joints = POSTURES[row][0]
    body = f"r:=CalcRobT([[{joints}],{N}],tool0); MoveAbsJ CalcJointT(r,tool0),v100,fine,tool0;"
    (motion,) = run_main(body, "VAR robtarget r;", robot()).motions
    assert isinstance(motion, MoveAbsJ)
    np.testing.assert_allclose(np.degrees(motion.q), [float(v) for v in joints.split(",")], atol=1e-5)


def test_calc_rob_t_agrees_with_the_truth_file() -> None:
    cases = json.loads((TRUTH / "irb140_fk.json").read_text())["cases"][:40]
    body = "\n".join(
        f"MoveJ CalcRobT([[{','.join(f'{degrees(v):.15g}' for v in case['q'])}],{N}],tool0),v100,fine,tool0;"
        for case in cases
    )
    for motion, case in zip(run_main(body, kinematics=robot()).motions, cases, strict=True):
        assert isinstance(motion, MoveJ)
        np.testing.assert_allclose(motion.X_WT[:3, 3], case["p"], atol=1e-7)
        np.testing.assert_allclose(motion.X_WT[:3, :3], rotation_from_wxyz(case["quat_wxyz"]), atol=1e-6)
        conf = case["conf"]
        assert motion.conf == ConfData(conf["cf1"], conf["cf4"], conf["cf6"], conf["cfx"])


def test_every_solution_of_the_truth_file_is_told_apart_by_its_confdata() -> None:
    checked = 0
    for case in json.loads((TRUTH / "irb140_ik.json").read_text())["cases"][:6]:
        x, y, z = (v * 1e3 for v in case["p"])
        rot = ",".join(f"{v:.15g}" for v in case["quat_wxyz"])
        ways = [one for solution in case["solutions"] for one in solution["in_limits_representatives"]]
        for one in ways:
            conf = ",".join(str(one["conf"][key]) for key in ("cf1", "cf4", "cf6", "cfx"))
            target = f"[[{x:.12f},{y:.12f},{z:.12f}],[{rot}],[{conf}],{N}]"
            (motion,) = run_main(f"MoveAbsJ CalcJointT({target},tool0),v5,fine,tool0;", kinematics=robot()).motions
            assert isinstance(motion, MoveAbsJ)
            np.testing.assert_allclose(motion.q, one["q"], atol=1e-5)
            checked += 1
    assert checked > 20


def test_joints_after_a_pose_and_pose_after_joints() -> None:
    body = (
        f"MoveAbsJ [[30,20,10,45,30,60],{N}],v100,fine,t; r:=CRobT(); MoveL Offs(r,0,0,-20),v100,fine,t;"
        "MoveL r,v100,fine,t; j:=CJointT(); MoveAbsJ j,v100,fine,t; MoveL CRobT(\\Tool:=tool0),v100,fine,tool0;"
    )
    data = (
        "VAR robtarget r; VAR jointtarget j;\n"
        "PERS tooldata t:=[TRUE,[[10,0,100],[0.707106781,0,0.707106781,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];"
    )
    program = run_main(body, data, robot())
    back = program.motions[3]
    assert isinstance(back, MoveAbsJ)
    np.testing.assert_allclose(np.degrees(back.q), [30, 20, 10, 45, 30, 60], atol=1e-5)
    np.testing.assert_allclose(only(program).X_WT[:3, 3] * 1e3, [473.030, 299.640, 452.241], atol=0.06)


def test_a_target_does_not_move_with_the_rail_and_a_joint_target_does() -> None:
    body = (
        "MoveAbsJ [[0,0,0,0,30,0],[400,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0; r:=CRobT(); MoveL r,v100,fine,tool0;"
        "r.extax.eax_a:=900; MoveL r,v100,fine,tool0; j:=CJointT(); j.extax.eax_a:=1000; MoveAbsJ j,v100,fine,tool0;"
        "MoveL CRobT(),v100,fine,tool0;"
    )
    program = run_main(body, "VAR robtarget r; VAR jointtarget j;", robot(rail=True))
    _, first, second, joints, last = program.motions
    assert isinstance(first, MoveL)
    assert isinstance(second, MoveL)
    assert isinstance(joints, MoveAbsJ)
    assert isinstance(last, MoveL)
    np.testing.assert_array_equal(first.X_WT, second.X_WT)
    assert (first.extax[0], second.extax[0]) == (400, 900)
    travel = (last.X_WT - second.X_WT)[:3, 3]
    assert np.linalg.norm(travel) == pytest.approx(0.1, abs=1e-9)  # the rail alone: 900 to 1000
    q = robot(rail=True).inverse(second.X_WT, second.extax, None, joints.q)  # tool0 is the flange
    assert q is not None
    np.testing.assert_allclose(joints.q, q, atol=1e-9)


def test_offsets_and_displacement_are_taken_out_of_where_the_robot_is() -> None:
    body = (
        "PDispSet [[10,20,30],[0.707106781,0,0,0.707106781]]; EOffsSet [25,0,0,0,0,0];"
        "MoveL [[500,0,600],[0,0,1,0],[0,0,0,0],[100,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;"
        "r:=CRobT(\\Tool:=tool0\\WObj:=wobj0); MoveL r,v100,fine,tool0; j:=CJointT();"
        "r:=CalcRobT(j,tool0); MoveL r,v100,fine,tool0; MoveAbsJ CalcJointT(r,tool0)\\NoEOffs,v100,fine,tool0;"
    )
    program = run_main(body, "VAR robtarget r; VAR jointtarget j;", robot(rail=True))
    first, second, third, joints = program.motions
    for motion in (second, third):
        assert isinstance(motion, MoveL)
        assert isinstance(first, MoveL)
        np.testing.assert_allclose(motion.X_WT, first.X_WT, atol=1e-6)
        assert motion.extax[0] == pytest.approx(125)
    assert isinstance(joints, MoveAbsJ)
    assert joints.extax[0] == pytest.approx(125)


def test_a_configuration_that_cannot_be_had_gives_the_nearest_and_says_so() -> None:
    body = f"j:=CalcJointT([[515,200,712],[0.7071,0,0.7071,0],[3,3,3,3],{N}],tool0); MoveAbsJ j,v100,fine,tool0;"
    program = run_main(body, "VAR jointtarget j;", robot())
    assert any(
        "has no posture with confdata [3,3,3,3]; the nearest one is taken" in text
        for text in tuple(map(str, program.warnings))
    )


@pytest.mark.parametrize(("switch", "warnings"), [("ConfL\\On;", 1), ("ConfL\\Off;", 0), ("ConfJ\\Off;", 1)])
def test_the_configuration_counts_where_the_move_holds_to_it(switch: str, warnings: int) -> None:
    move = f"MoveL [[515,200,712],[0.7071,0,0.7071,0],[3,3,3,3],{N}],v100,fine,tool0;"
    program = run_main(f"{switch} {move} j:=CJointT();", "VAR jointtarget j;", robot())
    assert sum("has no posture with confdata" in text for text in tuple(map(str, program.warnings))) == warnings


def test_where_confdata_is_off_the_joints_are_the_nearest_to_those_before() -> None:
    """Axis 6 goes on by a turn of 300 degrees in steps of 100, each nearest to the one before, on a joint move and on a
    line; CRobT tells the configuration that is there, not the programmed one."""
    to = f"p:=CalcRobT([[10,10,-10,0,40,{{0}}],{N}],tool0);"
    body = (
        f"MoveAbsJ [[10,10,-10,0,40,80],{N}],v100,fine,tool0; ConfJ\\Off; ConfL\\Off;"
        f"{to.format(180)} MoveJ p,v100,fine,tool0; {to.format(-80)} MoveL p,v100,fine,tool0;"
        f"{to.format(20)} MoveJ p,v100,fine,tool0; j:=CJointT(); MoveAbsJ j,v100,fine,tool0;"
        f"{to.format(-40)} MoveJ p,v100,fine,tool0; ConfJ\\On; MoveJ CRobT(),v100,fine,tool0;"
    )
    program = run_main(body, "VAR robtarget p; VAR jointtarget j;", robot())
    joints, last = program.motions[-3], program.motions[-1]
    assert isinstance(joints, MoveAbsJ)
    assert isinstance(last, MoveJ)
    np.testing.assert_allclose(np.degrees(joints.q), [10, 10, -10, 0, 40, 380], atol=1e-4)
    assert last.conf == ConfData(0, 0, 3, 0)


def test_an_axis_without_a_position_stays_where_it_was() -> None:
    body = (
        "MoveL [[500,0,600],[0,0,1,0],[0,0,0,0],[100,9E9,9E9,9E9,9E9,-5]],v100,fine,tool0;"
        "MoveL [[500,0,700],[0,0,1,0],[0,0,0,0],[9E9,20,9E9,9E9,9E9,9E9]],v100,fine,tool0;"
        "MoveL CRobT(),v100,fine,tool0;"
    )
    _, second, third = run_main(body).motions
    assert isinstance(second, MoveL)
    assert isinstance(third, MoveL)
    assert second.extax == (None, 20, None, None, None, None)
    assert third.extax == (100, 20, None, None, None, -5)


def test_out_of_reach_is_an_error_with_a_number_of_its_own() -> None:
    far = f"[[5000,0,600],[0,0,1,0],[0,0,0,0],{N}]"
    with pytest.raises(InputError, match="cannot be reached: the flange would stand at"):
        run_main(f"j:=CalcJointT({far},tool0);", "VAR jointtarget j;", robot())
    body = f"j:=CalcJointT({far},tool0\\ErrorNumber:=e); IF e<>0 WaitTime 1;"
    assert len(run_main(body, "VAR jointtarget j; VAR errnum e;", robot()).motions) == 1


def test_a_search_in_joints_stops_between_its_ends() -> None:
    body = (
        f"MoveAbsJ [[0,0,0,0,30,0],{N}],v100,fine,tool0; p:=CalcRobT([[40,10,0,0,30,0],{N}],tool0);"
        "SearchJ\\Stop,di1,r,p,v50,tool0; MoveAbsJ CJointT(),v100,fine,tool0;"
    )
    program = run_main(body, "VAR robtarget r; VAR robtarget p;", robot(), Scenario(searches={"di1": 0.25}))
    last = program.motions[-1]
    assert isinstance(last, MoveAbsJ)
    np.testing.assert_allclose(np.degrees(last.q), [10, 2.5, 0, 0, 30, 0], atol=1e-5)


# ----------------------------------------------------------------------------------------- reading on the way

_TO = f"[[500,0,500],[0,0,1,0],[0,0,0,0],{N}],v100,"
_ON = f"[[500,100,500],[0,0,1,0],[0,0,0,0],{N}]"


def told(body: str) -> list[tuple[WarningKind, int]]:
    """Kinds and lines of what is said of a program whose main begins at line 4."""
    data = "VAR robtarget p; VAR pos q; VAR jointtarget j; VAR num n;"
    program = run_main(body, data, robot(), Scenario(searches={"p": 0.5}, answers={"n": 1}))
    return [(one.kind, one.place[1]) for one in program.warnings if isinstance(one.place, tuple)]


@pytest.mark.parametrize(
    "read",
    [
        "p:=CRobT();",
        "q:=CPos();",
        "j:=CJointT();",
        f"PDispOn {_ON},tool0;",
        f"EOffsOn {_ON};",
        "MoveL Offs(CRobT(),0,9,0),v100,fine,tool0;",
    ],
)
def test_a_position_that_is_read_right_behind_a_fly_by_is_told_by_line(read: str) -> None:
    for move, stop in (("MoveL ", "z10"), ("MoveL \\Conc,", "fine")):
        assert told(f"{move}{_TO}{stop},tool0;\nSetDO do1,1;\n{read}") == [(WarningKind.ASSUMED, 6)]
    for behind in ("WaitRob \\InPos;", "WaitTime 0.1;", "TPReadNum n,p0;"):
        assert not told(f"VAR string p0;\nMoveL {_TO}z10,tool0;\n{behind}\n{read}")
    assert not told(f"MoveL {_TO}fine,tool0;\n{read}")
    assert not told(read)  # at the start the robot stands


def test_a_point_that_is_given_is_none_that_is_read() -> None:
    assert not told(f"MoveL {_TO}z10,tool0;\nPDispOn \\ExeP:={_ON},{_ON},tool0;\nEOffsOn \\ExeP:={_ON},{_ON};")


def test_a_search_begins_at_a_stop_and_stiffly_ends_only_below_100_mm_a_second() -> None:
    start, slow, fast = f"MoveL {_TO}fine,tool0;\n", f"di1,p,{_ON},v80,tool0;", f"di1,p,{_ON},v200,tool0;"
    usual = [(WarningKind.ASSUMED, 5)]  # how far behind the hit it stops, or that it does not
    for switch in ("\\Stop,", "\\PStop,", "\\SStop,", "", "\\Sup,"):
        assert told(f"{start}SearchL{switch or ' '}{slow}") == usual
        flying = start.replace("fine", "z10")
        assert told(f"{flying}SearchL{switch or ' '}{slow}") == usual * 2
    assert told(f"{start}SearchL\\Stop,{fast}") == [(WarningKind.UNUSUAL, 5), *usual]
    assert told(f"{start}SearchL\\PStop,{fast}") == usual
    via = _ON.replace("500,100", "520,50")
    assert told(f"{start}SearchC\\Stop,di1,p,{via},{_ON},v200,tool0;") == [(WarningKind.UNUSUAL, 5), *usual]
