"""Tables that carry work objects: where targets stand when they turn, and the time that leaves the robot."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
from small_cells import plant_with_rail, rapid
from unrefined import coarse_search

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.errors import InputError, InputErrorGroup
from trajopt_cli.exporters.joint import resample
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import MoveJ, Program
from trajopt_cli.plan import check_feasible, optimize
from trajopt_cli.problem.editable import everything
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.plannable import check_plannable
from trajopt_cli.rapid.zones import stopped_fly_bys
from trajopt_cli.scenario import PositionerAxis, RailUnit, Scenario

pytestmark = pytest.mark.usefixtures("coarse")

V, A = np.radians(90.0), np.radians(180.0)


def axis(eax: int, p: tuple[float, float, float], rpy: tuple[float, float, float] = (0, 0, 0)) -> PositionerAxis:
    quaternion = pin.Quaternion(pin.rpy.rpyToMatrix(*rpy)).coeffs()  # x, y, z, w
    x, y, z, w = (float(value) for value in quaternion)
    return PositionerAxis(eax, p, (w, x, y, z), (-3.2, 3.2), V, A, 0.0, "a test")


TURNTABLE = Scenario(positioners={"stn1": (axis(1, (0.6, 0.5, 0.1)),)})
DATA = """PERS wobjdata wobj_t:=[FALSE,FALSE,"STN1",[[0,0,0],[1,0,0,0]],[[0,0,50],[1,0,0,0]]];
CONST robtarget p_off:=[[-160,-90,330],[0,0,1,0],[0,0,0,0],[9E9,0,9E9,9E9,9E9,9E9]];
CONST robtarget p_seam:=[[-120,-90,200],[0,0,1,0],[0,0,0,0],[9E9,0,9E9,9E9,9E9,9E9]];
CONST robtarget p_side:=[[-90,160,330],[0,0.7071068,0.7071068,0],[0,0,0,0],[9E9,90,9E9,9E9,9E9,9E9]];
CONST robtarget p_far:=[[-90,260,330],[0,0.7071068,0.7071068,0],[0,0,0,0],[9E9,90,9E9,9E9,9E9,9E9]];
CONST jointtarget j_back:=[[9E9,9E9,9E9,9E9,9E9,9E9],[9E9,0,9E9,9E9,9E9,9E9]];"""


def program(body: str, scenario: Scenario = TURNTABLE) -> Program:
    return rapid(r"ConfJ \Off; ConfL \Off; " + body, scenario, DATA)


@pytest.fixture(autouse=True)
def _coarse_search(monkeypatch: pytest.MonkeyPatch) -> None:
    coarse_search(monkeypatch)


def test_targets_stand_where_the_table_carries_them() -> None:
    found = program(r"MoveJ p_off, v1000, fine, tool0 \WObj:=wobj_t; MoveJ p_side, v1000, fine, tool0 \WObj:=wobj_t;")
    place = pin.SE3(np.eye(3), np.array([0.6, 0.5, 0.1]))
    lifted = pin.SE3(np.eye(3), np.array([0, 0, 0.05]))
    for motion, angle, at in zip(found.motions, (0.0, np.pi / 2), ([-160, -90, 330], [-90, 160, 330]), strict=True):
        turned = pin.SE3(pin.AngleAxis(angle, np.array([0.0, 0, 1])).matrix(), np.zeros(3))
        expected = place * turned * lifted * pin.SE3(np.eye(3), np.array(at) / 1e3)
        assert isinstance(motion, MoveJ)
        np.testing.assert_allclose(motion.X_WT[:3, 3], expected.translation, atol=1e-9)
        np.testing.assert_allclose(motion.X_WT[:3, 2], [0, 0, -1], atol=1e-7)


def test_a_second_axis_stands_on_the_first_one() -> None:
    tilt, turn = axis(1, (0.6, 0.5, 0.3), (np.pi / 2, 0, 0)), axis(2, (0, 0.1, 0), (-np.pi / 2, 0, 0))
    found = rapid(
        r"ConfJ \Off; MoveJ p, v1000, fine, tool0 \WObj:=w;",
        Scenario(positioners={"stn2": (tilt, turn)}),
        'PERS wobjdata w:=[FALSE,FALSE,"Stn2",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];'
        "CONST robtarget p:=[[100,0,0],[0,0,1,0],[0,0,0,0],[9E9,30,60,9E9,9E9,9E9]];",
    )
    X = pin.SE3(np.eye(3), np.array([0.6, 0.5, 0.3])) * pin.SE3(pin.rpy.rpyToMatrix(np.pi / 2, 0, 0), np.zeros(3))
    X = X * pin.SE3(pin.rpy.rpyToMatrix(0, 0, np.radians(30)), np.zeros(3))
    X = X * pin.SE3(pin.rpy.rpyToMatrix(-np.pi / 2, 0, 0), np.array([0, 0.1, 0]))
    X = X * pin.SE3(pin.rpy.rpyToMatrix(0, 0, np.radians(60)), np.array([0.0, 0, 0]))
    motion = found.motions[0]
    assert isinstance(motion, MoveJ)
    np.testing.assert_allclose(motion.X_WT[:3, 3], X.act(np.array([0.1, 0, 0])), atol=1e-9)


def test_a_move_knows_what_turns_meanwhile_and_how_long_that_takes() -> None:
    found = program(
        r"MoveJ p_off, v1000, fine, tool0 \WObj:=wobj_t; MoveJ p_side, v1000, z50, tool0 \WObj:=wobj_t;"
        r"MoveJ p_far, v1000, fine, tool0 \WObj:=wobj_t; MoveExtJ j_back, vrot10, fine;"
    )
    still, turns, _, back = found.motions
    assert still.units == ()
    (unit,) = turns.units
    assert (unit.unit, unit.eax, unit.carries) == ("stn1", 1, True)
    assert turns.least == pytest.approx(np.pi / 2 / V + V / A)  # a trapezoid: it reaches its speed
    assert back.least == pytest.approx(np.pi / 2 / np.radians(10) + np.radians(10) / A)  # as slow as programmed
    assert "positioner" in stopped_fly_bys(found)[1]


@pytest.mark.long
def test_plans_wait_for_the_table_and_the_judge_sees_it() -> None:
    found = program(
        r"MoveJ p_off, v1000, fine, tool0 \WObj:=wobj_t; MoveL p_seam, v100, fine, tool0 \WObj:=wobj_t;"
        r"MoveJ p_far, v1000, fine, tool0 \WObj:=wobj_t; MoveExtJ j_back, vrot100, fine;"
    )
    plant = plant_with_rail()
    for target in Target:
        plan = optimize(found, plant, target)
        assert isinstance(plan, Plan)
        turns, back = plan.motions[2], plan.motions[3]
        assert turns.t_1 - turns.t_0 == pytest.approx(found.motions[2].least, abs=1e-6)
        assert turns.binding == "positioner"
        assert back.t_1 - back.t_0 == pytest.approx(found.motions[3].least, abs=1e-6)
        assert plan.lower_bound is not None
        assert plan.lower_bound <= plan.duration
        report = verify(found, plant, plan.trajectory, target=target, advice=False)
        assert report.legal, [one.message for one in report.findings if not one.passed]
        slower = [unit._replace(least=unit.least + 0.2) for unit in found.motions[2].units]
        impatient = replace(found, motions=(*found.motions[:2], replace(found.motions[2], units=tuple(slower)),
                                            *found.motions[3:]))  # fmt: skip
        missed = [
            one
            for one in verify(impatient, plant, plan.trajectory, target=target, advice=False).findings
            if not one.passed
        ]
        assert [one.check for one in missed] == ["positioner"]
        assert "at least" in missed[0].message


def test_no_points_are_added_where_the_table_turns() -> None:
    found = program(r"MoveJ p_off, v1000, fine, tool0 \WObj:=wobj_t; MoveJ p_side, v1000, fine, tool0 \WObj:=wobj_t;")
    changes = everything(found, plant_with_rail())
    assert changes.detours == ((0,),)
    assert changes.straight == {1: "a positioner turns on the way"}


@pytest.mark.usefixtures("unrefined")
def test_where_the_tool_is_there_already_it_stands_while_the_table_turns() -> None:
    body = r"MoveJ p_off, v1000, fine, tool0 \WObj:=wobj_t; MoveJ p_side, v1000, fine, tool0 \WObj:=wobj_t;"
    found = program(body + r"MoveL p_far, v500, fine, tool0 \WObj:=wobj_t;")
    plant = plant_with_rail()
    for target in Target:
        plan = optimize(found, plant, target, bounded=False)
        assert isinstance(plan, Plan)
        assert plan.motions[1].t_1 - plan.motions[1].t_0 == pytest.approx(found.motions[1].least, abs=1e-6)
        assert verify(found, plant, plan.trajectory, target=target, advice=False).legal


def test_a_plan_in_which_the_table_alone_turns_has_no_grid() -> None:
    turn = program("MoveExtJ [[9E9,9E9,9E9,9E9,9E9,9E9],[9E9,90,9E9,9E9,9E9,9E9]], vrot100, fine;")
    plan = optimize(turn, plant_with_rail(), Target.STREAM, bounded=False)
    assert isinstance(plan, Plan)
    assert plan.grid == "none, as all is in closed form"


def test_a_table_keeps_its_velocity_between_rows_too() -> None:
    """80 deg take 0.5 s to speed, 7/18 s at it and 0.5 s to rest: the second switch lies beside the grid."""
    turn = program("MoveExtJ [[9E9,9E9,9E9,9E9,9E9,9E9],[9E9,80,9E9,9E9,9E9,9E9]], vrot100, fine;")
    plan = optimize(turn, plant_with_rail(), Target.STREAM, bounded=False)
    assert isinstance(plan, Plan)
    rows = resample(plan.trajectory, 7919.0).tables
    assert rows is not None
    assert rows.qd is not None
    wanted = V * np.clip(np.minimum(rows.t, rows.t[-1] - rows.t) / 0.5, 0.0, 1.0)
    assert rows.t[-1] == pytest.approx(25 / 18, abs=1e-9)
    assert np.abs(rows.qd[:, 0] - wanted).max() < 1e-9


def test_external_axes_that_are_there_already_take_no_time_whatever_their_speed() -> None:
    """vrot100 has no speed for a rail: it stays where it is told to be, and so may the table."""
    there = "MoveExtJ [[9E9,9E9,9E9,9E9,9E9,9E9],[0,%s,9E9,9E9,9E9,9E9]], vrot100, fine; "
    found = program(
        there % 50 + there % 50 + "MoveExtJ [[9E9,9E9,9E9,9E9,9E9,9E9],[9E9,50,9E9,9E9,9E9,9E9]], vrot100, fine;"
    )
    for target in Target:
        plan = optimize(found, plant_with_rail(), target)
        assert isinstance(plan, Plan)
        assert plan.duration == pytest.approx(found.motions[0].least, abs=1e-5)


@pytest.mark.parametrize(
    ("body", "said"),
    [
        (
            r"WorldAccLim \On:=3; MoveJ p_off, v1000, fine, tool0 \WObj:=wobj_t;"
            r" MoveL p_side, v100, fine, tool0 \WObj:=wobj_t;",
            r"MoveL p_side is drawn on a work object that turns meanwhile, under WorldAccLim; plans hold the tool's"
            r" acceleration against the work object there: set WorldAccLim \Off before it",
        ),
        (
            r"MoveJ p_off, v1000, fine, tool0 \WObj:=wobj_t; MoveJ p_side, v1000 \T:=0.5, fine, tool0 \WObj:=wobj_t;",
            "in 0.5 s; that takes 1.500 s",
        ),
    ],
)
def test_what_no_plan_keeps_is_said(body: str, said: str) -> None:
    with pytest.raises(InputErrorGroup, match=r"t\.mod:5") as raised:
        check_plannable(program(body), plant_with_rail())
    assert said in str(raised.value)


def test_a_position_beyond_the_tables_range_is_refused() -> None:
    far = DATA.replace("[9E9,90,9E9", "[9E9,200,9E9", 1)
    with pytest.raises(InputError, match=r"asks for stn1's eax_b = 200 deg, range -183\.\d+\.\.183\.\d+ deg"):
        rapid(r"MoveJ p_side, v1000, fine, tool0 \WObj:=wobj_t;", TURNTABLE, far)


CELL = """robot: irb140_rail
rail: {eax: a, stroke: [0, 1]}
start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}
positioners:
  T: {eax: EAX, range: RANGE, velocity: 90 deg/s, acceleration: 3, source: a test}
"""


@pytest.mark.parametrize(
    ("eax", "range_", "said"),
    [
        ("a", "[-1, 1]", "cell.yaml:5: positioners.T: eax a drives the rail already"),
        ("b", "[-1, 1], velocity: 1e-9", "velocity 1e-09 is less than any drive has, at least 0.001"),
        ("b", "[1, -1]", "range goes from 1 to -1"),
        ("b", "[1, 2]", "start 0 rad is not in the range 1..2 rad"),
        ("g", "[-1, 1]", "positioners.T.eax"),
    ],
)
def test_a_positioner_with_a_mistake_is_refused_with_its_line(eax: str, range_: str, said: str) -> None:
    text = CELL.replace("EAX", eax).replace("RANGE", range_)
    with pytest.raises(InputError) as raised:
        parse_cell(text.replace(", velocity: 90 deg/s", "") if "velocity: 1e-9" in text else text, "cell.yaml")
    assert said in str(raised.value)


def test_the_shipped_program_is_read_with_its_cell() -> None:
    from trajopt_cli.job import read_job

    job = read_job(Path(__file__).parents[2] / "programs" / "positioner.mod")
    turning = [motion for motion in job.program.motions if getattr(motion, "units", ())]
    assert [round(np.degrees(motion.units[0].end)) for motion in turning] == [90, -90, 0]


def test_a_rail_that_moves_needs_a_speed_for_it() -> None:
    """vrot100 has none for linear axes."""
    moves = program(r"MoveExtJ [[9E9,9E9,9E9,9E9,9E9,9E9],[500,9E9,9E9,9E9,9E9,9E9]], vrot100, fine;")
    with pytest.raises(InputErrorGroup, match=r"t\.mod:5:25: MoveExtJ .* at vrot100, whose v_leax is 0;"):
        check_plannable(moves, plant_with_rail())


@pytest.mark.parametrize("v_reax", ["0", "1E-30"])
def test_a_table_that_turns_needs_a_speed(v_reax: str) -> None:
    with pytest.raises(InputError, match=r"eax_b at .* deg/s \(v_reax of .*\): give at least 0.0573 deg/s"):
        program(rf"MoveExtJ [[9E9,9E9,9E9,9E9,9E9,9E9],[9E9,90,9E9,9E9,9E9,9E9]], [1000,500,1000,{v_reax}], fine;")


def test_a_mistake_in_the_only_axis_of_a_positioner_is_one_line_with_its_key() -> None:
    text = """robot: irb140
start: {joints: "[0, 0, 0, 0, 30, 0] deg"}
positioners:
  STN1:
    eax: b
    frame: {position: [0.65, 0.5, 0.1]}
    range: "[-185, 185] deg"
    velocity: -3
    acceleration: 300 deg/s2
    source: "a test"
"""
    with pytest.raises(InputError) as caught:
        parse_cell(text, "c.yaml")
    assert str(caught.value) == "c.yaml:8: positioners.STN1.velocity: needs a number above zero, not -3"


@pytest.mark.usefixtures("unrefined")
def test_a_rail_stands_from_deact_unit_to_act_unit_and_the_judge_looks() -> None:
    """Free it would go along: what is planned without DeactUnit is illegal with it."""
    body = r"ConfJ \Off; ConfL \Off; MoveJ p_in, v1000, z20, tool0; %s"
    body += "MoveL Offs(p_in,0,-150,0), v1000, fine, tool0; MoveJ Offs(p_in,0,-450,0), v1000, fine, tool0; %s"
    body += "MoveL Offs(p_in,0,-500,0), v1000, fine, tool0;"
    scenario = Scenario(rail=RailUnit(0, "TRACK1"))
    held, free = (
        rapid(body % switches, scenario)
        for switches in (("DeactUnit TRACK1;", "ActUnit TRACK1;"), ("WaitRob\\InPos;",) * 2)
    )
    plant = plant_with_rail()
    for target in Target:
        plan = optimize(held, plant, target, bounded=False)
        assert isinstance(plan, Plan)
        during = plan.trajectory.q[
            (plan.trajectory.t >= plan.motions[2].t_0) & (plan.trajectory.t <= plan.motions[3].t_1)
        ]
        assert np.ptp(during[:, 0]) == 0
        assert verify(held, plant, plan.trajectory, target=target, advice=False).legal
        other = optimize(free, plant, target, bounded=False)
        assert isinstance(other, Plan)
        found = verify(held, plant, other.trajectory, target=target, advice=False).findings
        assert {one.check for one in found if not one.passed} == {"way while held"}


def test_what_a_parked_rail_cannot_reach_is_an_answer_that_names_the_unit() -> None:
    far = rapid(
        "ConfJ \\Off; DeactUnit TRACK1; MoveJ Offs(p_in,0,900,0), v1000, fine, tool0;",
        Scenario(rail=RailUnit(0, "TRACK1")),
    )
    found = check_feasible(far, plant_with_rail())
    assert isinstance(found, Infeasible)
    assert (found.index, found.source.line) == (1, 5)
    assert "unit" in found.message


@pytest.mark.usefixtures("unrefined")
def test_the_judge_wants_a_stop_before_deact_unit() -> None:
    body = (
        "MoveJ p_in, v1000, fine, tool0; MoveL p_low, v1000, z20, tool0; %s MoveL Offs(p_in,0,99,0), v500, fine, tool0;"
    )
    passed, stopped = (rapid(r"ConfJ \Off; ConfL \Off; " + body % one) for one in ("", "DeactUnit STN9;"))
    plan = optimize(passed, plant_with_rail(), Target.STREAM, bounded=False)
    assert isinstance(plan, Plan)
    assert verify(passed, plant_with_rail(), plan.trajectory, target=Target.STREAM, advice=False).legal
    assert not verify(stopped, plant_with_rail(), plan.trajectory, target=Target.STREAM, advice=False).legal


@pytest.mark.usefixtures("unrefined")
def test_tables_on_one_axis_turn_one_after_the_other_each_in_its_own_column() -> None:
    stations = {"stn1": (axis(1, (0.6, 0.5, 0.1)),), "stn2": (axis(1, (0.6, -0.5, 0.1)),)}
    found = program(
        r"ActUnit STN1; MoveJ p_off, v1000, fine, tool0 \WObj:=wobj_t; MoveL p_far, v1000, fine, tool0 \WObj:=wobj_t;"
        r"DeactUnit STN1; ActUnit STN2; MoveExtJ [[0,0,0,0,0,0],[9E9,-40,9E9,9E9,9E9,9E9]], vrot100, fine;"
        r"MoveL Offs(p_far,0,0,50), v1000, fine, tool0 \WObj:=wobj_t;",
        Scenario(positioners=stations),
    )
    plant = plant_with_rail()
    plan = optimize(found, plant, Target.STREAM, bounded=False)
    assert isinstance(plan, Plan)
    tables = plan.trajectory.tables
    assert tables is not None
    assert tables.names == ("eax_b_stn1", "eax_b_stn2")
    np.testing.assert_allclose(np.degrees(tables.q[[0, -1]]), [[0, 0], [90, 90]], atol=1e-9)
    np.testing.assert_allclose(np.degrees(tables.q[:, 1].min()), -40, atol=1e-9)
    assert verify(found, plant, plan.trajectory, target=Target.STREAM, advice=False).legal
    q = tables.q.copy()
    q[-4:-1, 0] += 0.01  # STN1, where it should stand
    moved = replace(plan.trajectory, tables=replace(tables, q=q))
    report = verify(found, plant, moved, target=Target.STREAM, advice=False)
    assert "positioner position" in {one.check for one in report.findings if not one.passed}


def test_a_programmed_time_replaces_the_speed_of_a_table() -> None:
    """v_reax 0 is not asked then; how long the turn takes at the table's own limits is."""
    text = r"MoveExtJ [[9E9,9E9,9E9,9E9,9E9,9E9],[9E9,90,9E9,9E9,9E9,9E9]], [1000,500,1000,0]\T:=3, fine;"
    moves = program(text)
    assert moves.motions[0].duration == 3.0
    plan = optimize(moves, plant_with_rail(), Target.RAPID, bounded=False)
    assert isinstance(plan, Plan)
    assert plan.duration == pytest.approx(3.0)
    assert verify(moves, plant_with_rail(), plan.trajectory, target=Target.RAPID, advice=False).legal
