"""Additional points of joint moves: the program with them, its numbering, and plans told without them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from small_cells import HOME, plant_with_rail, problem_of, rapid

from trajopt_cli.geometry import inverse_pose
from trajopt_cli.judge.mechanism import mechanism_of
from trajopt_cli.motion import Move, MoveAbsJ, MoveJ, Program
from trajopt_cli.plan import optimize
from trajopt_cli.plan.plan_sensitivity import PlanSensitivity
from trajopt_cli.problem.detours import Detour, Numbering, Via, folded, radii, unfolded, why_unsaid, with_detours
from trajopt_cli.problem.editable import Changes, everything
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.robot.inverse import confdata_admits, solutions

PLANT = plant_with_rail()
DATA = "CONST robtarget pVia_30:=[[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];"
ONE = np.r_[0.25, 0.6, -0.4, -0.3, 0.4, 0.9, -0.5]
TWO = np.r_[0.4, 0.9, -0.2, -0.4, -0.3, 1.1, 0.2]
BODY = r"""MoveJ p_in,v1000,z20,tool0;
WaitTime 0.1;
MoveL p_low,v500,fine,tool0;
MoveAbsJ j_home,v1000,fine,tool0;"""


def program() -> Program:
    return rapid(BODY, data=DATA)


def detours() -> tuple[Detour, ...]:
    return (
        Detour(0, (Via(ONE, 0.02), Via(TWO)), ("column",)),
        Detour(3, (Via(TWO, 0.05),), ("fence", "column")),
    )


@pytest.fixture(scope="module")
def plan() -> Plan:
    """A RAPID plan of the program with the points, in its numbering."""
    there = with_detours(program(), PLANT, detours())
    changes = Numbering(4, detours()).changes(everything(program(), PLANT))
    found = optimize(there, PLANT, Target.RAPID, bounded=False, changes=changes)
    assert isinstance(found, Plan)
    return found


def test_the_points_are_joint_moves_that_say_every_axis() -> None:
    there = with_detours(program(), PLANT, detours())
    names = [motion.target if isinstance(motion, Move) else "-" for motion in there.motions]
    assert names == ["pVia_40", "pVia_50", "p_in", "-", "p_low", "jVia_60", "j_home"]
    first, second = there.motions[:2]
    for motion, q in ((first, ONE), (second, TWO)):
        assert isinstance(motion, MoveJ)
        assert motion.extax[0] == pytest.approx(q[0] * 1e3)
        X_WF = mechanism_of(PLANT).flange_pose(q)  # the judge's own kinematics
        np.testing.assert_allclose(motion.X_WT @ inverse_pose(motion.tool.X_FT), X_WF, atol=1e-9)
        admitted = [arm for _, arm in solutions(PLANT.robot, X_WF, q[0], PLANT.limits)]
        admitted = [arm for arm in admitted if confdata_admits(PLANT.robot, motion.conf, arm)]
        assert len(admitted) == 1
        np.testing.assert_allclose(admitted[0], q[1:], atol=1e-9)
    assert isinstance(first, MoveJ)
    assert isinstance(second, MoveJ)
    assert (first.zone.name, second.zone.name) == ("z20", "fine")
    assert first.zone == program().motions[0].zone  # as the reader makes a z20
    joints = there.motions[5]
    assert isinstance(joints, MoveAbsJ)
    np.testing.assert_array_equal(joints.q, TWO[1:])
    for index, own in ((0, 0), (1, 0), (5, 3)):
        one, belongs = there.motions[index], program().motions[own]
        assert isinstance(one, Move)
        assert isinstance(belongs, Move)
        assert (one.source, one.speed, one.written.statement) == (
            belongs.source,
            belongs.speed,
            belongs.written.statement,
        )
        assert one.detour == detours()[0 if own == 0 else 1].around
    assert [one.detour for one in there.motions if isinstance(one, Move)].count(()) == 3


def test_no_detours_leave_the_program_alone() -> None:
    one = program()
    assert with_detours(one, PLANT, ()) is one


def test_passes_of_one_statement_through_one_point_have_one_name() -> None:
    looped = rapid("FOR i FROM 1 TO 2 DO\nMoveJ p_in,v1000,fine,tool0;\nMoveAbsJ j_home,v1000,fine,tool0;\nENDFOR")
    both = with_detours(looped, PLANT, (Detour(0, (Via(ONE),), ("a",)), Detour(2, (Via(ONE),), ("a",))))
    assert [m.target for m in both.motions if isinstance(m, MoveJ)] == ["pVia_10", "p_in", "pVia_10", "p_in"]
    other = with_detours(looped, PLANT, (Detour(0, (Via(ONE),), ("a",)), Detour(2, (Via(TWO),), ("a",))))
    assert [m.target for m in other.motions if isinstance(m, MoveJ)] == ["pVia_10", "p_in", "pVia_20", "p_in"]


def test_numbers_of_motions_are_found_both_ways() -> None:
    numbering = Numbering(4, detours())
    assert [numbering.own(k) for k in range(numbering.with_points)] == [0, 0, 0, 1, 2, 3, 3]
    assert [numbering.at(i) for i in range(4)] == [2, 3, 4, 6]
    assert [k for k in range(7) if numbering.is_point(k)] == [0, 1, 5]
    changes = Changes(frozenset({0, 2}), ((0, 2),), frozenset({0, 1}), ("kept",), ((0,), (3,)), {3: "why"})
    assert numbering.changes(changes) == Changes(
        frozenset({2, 4}), ((2, 4),), frozenset({3}), ("kept",), ((2,), (6,)), {6: "why"}
    )


@pytest.mark.parametrize(
    ("body", "why"),
    [
        (r"MoveL p_in,v1000,fine,tool0;", "no joint move"),
        (r"MoveJ p_in,v1000 \T:=2,fine,tool0;", "programmed"),
    ],
)
def test_motions_that_can_have_no_points(body: str, why: str) -> None:
    with pytest.raises(ValueError, match=why):
        with_detours(rapid(body), PLANT, (Detour(0, (Via(ONE),), ("column",)),))
    changes = everything(rapid(body), PLANT)
    assert changes.detours == ()


def test_a_point_at_a_singularity_cannot_be_a_robtarget_but_a_jointtarget() -> None:
    straight = np.r_[0.0, HOME]
    straight[5] = 1e-4
    with pytest.raises(ValueError, match="singularity"):
        with_detours(program(), PLANT, (Detour(0, (Via(straight),), ("column",)),))
    with_detours(program(), PLANT, (Detour(3, (Via(straight),), ("column",)),))
    move = program().motions[0]
    assert isinstance(move, MoveJ)
    assert why_unsaid(PLANT, move, np.r_[0.0, HOME]) is None


def test_zones_are_the_controllers() -> None:
    assert [round(r * 1e3, 1) for r in radii()] == [0.3, 1, 5, 10, 15, 20, 30, 40, 50, 60, 80, 100, 150, 200]
    with pytest.raises(ValueError, match=r"no zone has the radius 0.025 m"):
        with_detours(program(), PLANT, (Detour(0, (Via(ONE, 0.025),), ("a",)),))


@pytest.mark.parametrize(
    "wrong",
    [
        (Detour(0, (Via(ONE),), ("a",)), Detour(0, (Via(TWO),), ("a",))),
        (Detour(9, (Via(ONE),), ("a",)),),
        (Detour(0, (Via(ONE[1:]),), ("a",)),),
    ],
)
def test_detours_that_do_not_fit_are_refused(wrong: tuple[Detour, ...]) -> None:
    with pytest.raises(ValueError, match=r"two detours|detours of motions \[9\]|wanted \(7,\)"):
        with_detours(program(), PLANT, wrong)


def test_the_planner_finds_the_points_pinned(plan: Plan) -> None:
    there = with_detours(program(), PLANT, detours())
    numbering = Numbering(4, detours())
    problem = problem_of(there, PLANT, Target.RAPID, changes=numbering.changes(everything(program(), PLANT)))
    assert problem.waypoints[1].rail == pytest.approx((ONE[0], ONE[0]))
    assert problem.waypoints[1].conf is not None
    assert problem.waypoints[1].fly_by is not None
    assert problem.waypoints[3].rail[0] < problem.waypoints[3].rail[1]  # the program's own point is free
    np.testing.assert_allclose(plan.motions[0].q_1, ONE, atol=1e-7)
    np.testing.assert_allclose(plan.motions[1].q_1, TWO, atol=1e-7)
    np.testing.assert_allclose(plan.motions[5].q_1, TWO, atol=1e-7)


def test_a_plan_with_points_can_be_solved_again(plan: Plan) -> None:
    own = folded(plan, program(), detours())
    there, numbering = with_detours(program(), PLANT, own.detours), Numbering(4, own.detours)
    again = PlanSensitivity(there, PLANT, unfolded(own), numbering.changes(everything(program(), PLANT)))
    assert again.duration == pytest.approx(plan.duration, rel=1e-6)


def test_confdata_of_a_point_counts_where_that_of_its_motion_does_not() -> None:
    off = rapid("ConfJ \\Off;\nMoveJ p_in,v1000,fine,tool0;")
    there = with_detours(off, PLANT, (Detour(0, (Via(ONE),), ("column",)),))
    assert [m.settings.conf_j for m in there.motions if isinstance(m, MoveJ)] == [True, False]


def test_a_plan_is_told_in_the_programs_own_motions_and_back(plan: Plan) -> None:
    own = folded(plan, program(), detours())
    assert [one.index for one in own.motions] == [0, 1, 2, 3]
    assert [len(one.via) for one in own.motions] == [2, 0, 0, 1]
    first = own.motions[0]
    assert (first.t_0, first.t_1) == (plan.motions[0].t_0, plan.motions[2].t_1)
    assert [point.t for point in first.via] == [plan.motions[0].t_1, plan.motions[1].t_1]
    assert own.detours == detours() or len(own.detours) == 2
    back = unfolded(own)
    assert back.detours == ()
    for one, other in zip(back.motions, plan.motions, strict=True):
        assert (one.index, one.t_0, one.t_1) == (other.index, other.t_0, other.t_1)
        np.testing.assert_array_equal(one.q_0, other.q_0)
        np.testing.assert_array_equal(one.q_1, other.q_1)
    alone = replace(plan, detours=())
    assert folded(alone, program(), ()) is alone
    assert unfolded(alone) is alone
