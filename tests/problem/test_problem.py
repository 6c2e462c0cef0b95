"""How motions become stops and legs, read from RAPID text."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from small_cells import HOME, plant_with_rail, plant_without_rail, problem_of, rapid

from trajopt_cli.errors import InputError
from trajopt_cli.judge.program_points import points_of, stands_for
from trajopt_cli.motion import ConfData, MoveJ, MoveL, SignalEvent, motion_name
from trajopt_cli.plan.subproblems import pieces
from trajopt_cli.problem.build import build_problem
from trajopt_cli.problem.decision_scope import AS_WRITTEN, EVERYTHING, FIXED_RAIL, Freedom
from trajopt_cli.problem.editable import Changes, droppable, everything
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.problem.problem import Coupling, LegKind
from trajopt_cli.scenario import Scenario

J, L, D = LegKind.JOINT, LegKind.LINE, LegKind.DWELL
INF = np.inf
EVERY = Changes(frozenset(range(20)))

STATION = """MoveJ p_in, v2500, fine, tool0;
MoveL p_low, v500, fine, tool0;
WaitTime 0.3;
Set do_grip;
MoveL p_in, v500, fine, tool0;
MoveAbsJ j_home, v1000, fine, tool0;"""


def test_a_station_becomes_stops_legs_and_one_configuration() -> None:
    program = rapid(STATION)
    problem = problem_of(program, plant_with_rail())
    assert isinstance(program.motions[3], SignalEvent)
    assert [leg.kind for leg in problem.legs] == [J, L, D, L, J]
    assert [leg.motion for leg in problem.legs] == [0, 1, 2, 4, 5]
    assert [leg.start for leg in problem.legs] == [0, 1, 2, 3, 4]
    assert [stop.motion for stop in problem.waypoints] == [-1, 0, 1, 2, 4, 5]
    assert problem.stations == ((0, 0), (1, 4), (5, 5))
    assert [stop.rest for stop in problem.waypoints] == [True, False, False, False, False, True]
    assert problem.waypoints[2].X_WF is problem.waypoints[3].X_WF
    np.testing.assert_allclose(problem.waypoints[1].X_WF[:3, 3], [0.5, 0.6, 0.45], atol=1e-15)
    np.testing.assert_array_equal(problem.waypoints[5].q, np.r_[0.0, HOME])
    assert {stop.rail for stop in problem.waypoints[1:5]} == {(-0.2, 2.2)}
    assert [stop.written for stop in problem.waypoints] == [0.0, 0.6, 0.6, 0.6, 0.6, 0.0]
    line = problem.legs[1]
    assert line.chord == pytest.approx(0.06, abs=1e-15)
    assert line.angle == pytest.approx(0.0, abs=1e-12)
    assert problem.legs[2].duration == 0.3
    assert all(leg.rail_moves for leg in problem.legs)


def test_programmed_speeds_cap_each_kind_of_motion() -> None:
    """v2500 over a cap of 2 m/s is held to it; v500 has 500 deg/s and 5 m/s; a wait has none."""
    plant = plant_with_rail()
    problem = problem_of(rapid(STATION), plant)
    turn = np.radians(500)
    caps = [(leg.v_tcp, leg.v_ori, leg.v_rail) for leg in problem.legs]
    wanted = [(2.5, turn, 5.0), (0.5, turn, 5.0), (INF, INF, INF), (0.5, turn, 5.0), (1.0, turn, 5.0)]
    np.testing.assert_allclose(caps, wanted)
    assert [leg.a_tcp for leg in problem.legs] == [20.0, 20.0, INF, 20.0, 20.0]


def test_free_speed_lifts_the_programmed_cap_of_joint_moves_only() -> None:
    problem = problem_of(rapid(STATION), plant_with_rail(free_speed=True))
    assert [(leg.v_tcp, leg.v_ori) for leg in problem.legs if leg.kind is J] == [(2.5, INF), (2.5, INF)]
    assert [leg.v_tcp for leg in problem.legs if leg.kind is L] == [0.5, 0.5]


def test_rail_fixed_keeps_every_programmed_value() -> None:
    problem = problem_of(rapid(STATION), plant_with_rail(rail_fixed=True))
    assert [stop.rail for stop in problem.waypoints] == [(w, w) for w in (0.0, 0.6, 0.6, 0.6, 0.6, 0.0)]
    # nothing to move: the dwell holds
    assert not problem.legs[2].rail_moves


def test_a_target_without_a_rail_value_stays_where_the_rail_was() -> None:
    body = "MoveJ p_in, v500, fine, tool0;\nMoveL p_open, v500, fine, tool0;\nMoveAbsJ j_home, v500, fine, tool0;"
    data = "CONST robtarget p_open:=[[500,600,400],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];"
    problem = problem_of(rapid(body, data=data), plant_with_rail(rail_fixed=True))
    assert problem.waypoints[2].rail == (0.6, 0.6)


def test_freedoms_reach_the_legs() -> None:
    program, plant = rapid(STATION), plant_with_rail()
    fixed = problem_of(program, plant, freedom=FIXED_RAIL)
    assert [leg.rail_moves for leg in fixed.legs] == [True, False, False, False, True]
    assert all(stop.rest for stop in fixed.waypoints)
    assert {stop.rail for stop in fixed.waypoints[1:5]} == {(-0.2, 2.2)}
    written = problem_of(program, plant, freedom=AS_WRITTEN)
    assert all(stop.rail[0] == stop.rail[1] for stop in written.waypoints)
    assert [stop.conf is not None for stop in written.waypoints] == [False, True, True, True, True, False]
    assert all(stop.conf is None for stop in problem_of(program, plant).waypoints)


def test_a_line_of_no_length_to_another_rail_value_is_a_dwell_that_takes_as_long_as_it_needs() -> None:
    data = "CONST robtarget p_b:=[[500,600,390],[0,0,1,0],[0,0,0,0],[900,9E9,9E9,9E9,9E9,9E9]];"
    body = """MoveJ p_in, v500, fine, tool0;
MoveL p_low, v500, fine, tool0;
MoveL p_b, v500, fine, tool0;
MoveL p_low, v500, \\T:=0.7, fine, tool0;
MoveAbsJ j_home, v500, fine, tool0;"""
    body = body.replace("v500, \\T:=0.7,", "v500\\T:=0.7,")
    problem = problem_of(rapid(body, data=data), plant_with_rail())
    assert [leg.kind for leg in problem.legs] == [J, L, D, D, J]
    assert [leg.duration for leg in problem.legs] == [None, None, None, 0.7, None]
    assert problem.legs[2].rail_moves
    assert problem.waypoints[3].written == 0.9
    held = problem_of(rapid(body, data=data), plant_with_rail(rail_fixed=True))
    assert held.waypoints[3].rail == (0.9, 0.9)
    assert held.legs[2].rail_moves


def test_a_programmed_duration_stays_with_its_line() -> None:
    body = "MoveJ p_in, v500\\T:=2.5, fine, tool0;\nMoveL p_low, v500\\T:=1.5, fine, tool0;"
    problem = problem_of(rapid(body), plant_with_rail())
    assert [(leg.kind, leg.duration) for leg in problem.legs] == [(J, 2.5), (L, 1.5)]
    assert problem.waypoints[-1].rest


def test_joints_given_in_the_middle_are_kept_and_divide_the_stations() -> None:
    data = "CONST jointtarget j_mid:=[[10,0,0,0,30,0],[300,9E9,9E9,9E9,9E9,9E9]];"
    body = """MoveJ p_in, v500, fine, tool0;
MoveAbsJ j_mid, v500, fine, tool0;
WaitTime 0.2;
MoveJ p_in, v500, fine, tool0;"""
    problem = problem_of(rapid(body, data=data), plant_with_rail())
    q = np.r_[0.3, HOME]
    q[1] = np.radians(10)
    np.testing.assert_allclose(problem.waypoints[2].q, q, atol=1e-15)
    np.testing.assert_allclose(problem.waypoints[3].q, q, atol=1e-15)
    assert problem.waypoints[2].rail == (0.3, 0.3)
    assert problem.waypoints[2].rest
    assert problem.waypoints[3].rest
    assert not problem.legs[2].rail_moves
    assert problem.stations == ((0, 0), (1, 1), (2, 3), (4, 4))
    np.testing.assert_allclose(problem.plant.robot.forward(q), problem.waypoints[2].X_WF, atol=1e-15)


def test_external_axes_alone_hold_the_arm_that_the_point_before_has() -> None:
    data = "CONST jointtarget j_rail:=[[9E9,9E9,9E9,9E9,9E9,9E9],[900,9E9,9E9,9E9,9E9,9E9]];"
    body = "MoveJ p_in, v500, fine, tool0;\nMoveExtJ j_rail, vrot10, fine;\nMoveAbsJ j_home, v500, fine, tool0;"
    body = body.replace("vrot10", "v500")
    plant = plant_with_rail()
    problem = problem_of(rapid(body, data=data), plant)
    before, after = problem.waypoints[1], problem.waypoints[2]
    assert (before.q[0], after.q[0]) == pytest.approx((0.6, 0.9), abs=1e-15)
    np.testing.assert_array_equal(before.q[1:], after.q[1:])
    np.testing.assert_allclose(plant.robot.forward(before.q), before.X_WF, atol=1e-12)
    assert before.rail == (0.6, 0.6)
    leg = problem.legs[1]
    assert leg.kind is J
    # only the external axes' cap counts; the tool is carried along under the robot's own
    assert (leg.v_ori, leg.v_rail) == (INF, 5.0)


def test_external_axes_alone_need_a_point_before_that_can_be_had() -> None:
    data = """CONST jointtarget j_rail:=[[9E9,9E9,9E9,9E9,9E9,9E9],[900,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_off:=[[500,600,450],[0,0,1,0],[0,0,0,0],[2000,9E9,9E9,9E9,9E9,9E9]];"""
    body = "MoveJ p_off, v500, fine, tool0;\nMoveExtJ j_rail, v500, fine;"
    with pytest.raises(InputError, match="MoveExtJ holds the arm's joints, but the point before it cannot be reached"):
        build_problem(rapid(body, data=data), plant_with_rail(), EVERYTHING, Target.STREAM, EVERY)


@pytest.mark.parametrize(("waits", "kinds"), [({}, [J, L, L]), ({"di_ok": 0.4}, [J, L, D, L])])
def test_a_wait_for_a_signal_ends_at_rest(waits: dict[str, float], kinds: list[LegKind]) -> None:
    """Without a least duration there is no leg, but the point before must be at rest; with one the dwell's end is."""
    body = "MoveJ p_in, v500, fine, tool0;\nMoveL p_low, v500, fine, tool0;\nWaitDI di_ok, 1;"
    body += "\nMoveL p_in, v500, fine, tool0;"
    problem = problem_of(rapid(body, Scenario(signals={"di_ok": 1}, waits=waits)), plant_with_rail())
    assert [leg.kind for leg in problem.legs] == kinds
    rests = [stop.rest for stop in problem.waypoints]
    assert rests == ([True, False, True, True] if not waits else [True, False, False, True, True])
    if waits:
        assert problem.legs[2].duration == 0.4
        assert problem.legs[2].rail_moves


def test_a_wait_of_no_time_leaves_no_trace() -> None:
    body = "MoveJ p_in, v500, fine, tool0;\nWaitTime 0;\nMoveL p_low, v500, fine, tool0;"
    problem = problem_of(rapid(body), plant_with_rail())
    assert [leg.kind for leg in problem.legs] == [J, L]
    assert not problem.waypoints[1].rest


def test_only_what_precedes_a_joint_move_may_go() -> None:
    """Leaving out a point before a line would move the line."""
    body = """MoveJ p_in, v500, fine, tool0; ! trajopt: optional
MoveL p_low, v500, fine, tool0; ! trajopt: optional
MoveJ p_in, v500, fine, tool0; ! trajopt: optional
MoveAbsJ j_home, v500, fine, tool0; ! trajopt: optional"""
    program = rapid(body)
    assert droppable(program, plant_with_rail()) == {1, 2}
    marked = droppable(rapid(body.replace("! trajopt: optional", "")), plant_with_rail(droppable=frozenset({"p_in"})))
    assert marked == {2}
    problem = problem_of(program, plant_with_rail(), dropped={2})
    assert [leg.motion for leg in problem.legs] == [0, 1, 3]
    assert problem.dropped == {2}


def test_joints_out_of_range_are_named_with_motion_value_and_range() -> None:
    data = "CONST jointtarget j_bad:=[[0,0,0,0,130,0],[0,9E9,9E9,9E9,9E9,9E9]];"
    program = rapid("MoveAbsJ j_bad, v500, fine, tool0;", data=data)
    answer = build_problem(program, plant_with_rail(), EVERYTHING, Target.STREAM, EVERY)
    assert isinstance(answer, Infeasible)
    assert answer.index == 0
    assert str(answer) == "t.mod:5:1: MoveAbsJ j_bad asks for joint_5 = 130 deg, range -115..115 deg"


@pytest.mark.parametrize("move", ["MoveAbsJ j_far, v500, fine, tool0;", "MoveExtJ j_far, v500, fine;"])
def test_a_rail_out_of_its_stroke_is_named(move: str) -> None:
    data = "CONST jointtarget j_far:=[[0,0,0,0,30,0],[2500,9E9,9E9,9E9,9E9,9E9]];"
    answer = build_problem(rapid(move, data=data), plant_with_rail(), EVERYTHING, Target.STREAM, EVERY)
    assert isinstance(answer, Infeasible)
    assert str(answer) == f"t.mod:5:1: {move.split()[0]} j_far asks for rail = 2500 mm, range -200..2200 mm"


def test_a_free_rail_may_be_written_out_of_its_stroke_and_a_fixed_one_may_not() -> None:
    data = "CONST robtarget p_off:=[[500,600,450],[0,0,1,0],[0,0,0,0],[2500,9E9,9E9,9E9,9E9,9E9]];"
    program = rapid("MoveJ p_off, v500, fine, tool0;", data=data)
    assert problem_of(program, plant_with_rail()).waypoints[1].rail == (-0.2, 2.2)
    for plant, freedom in ((plant_with_rail(rail_fixed=True), EVERYTHING), (plant_with_rail(), AS_WRITTEN)):
        answer = build_problem(program, plant, freedom, Target.STREAM, EVERY)
        assert isinstance(answer, Infeasible)
        assert str(answer) == "t.mod:5:1: MoveJ p_off asks for rail = 2500 mm, range -200..2200 mm"


def test_the_tool_is_taken_off_the_target() -> None:
    data = "PERS tooldata t_grip:=[TRUE,[[10,20,120],[0.8,0,0.6,0]],[1,[0,0,60],[1,0,0,0],0,0,0]];"
    body = "MoveJ p_in, v500, fine, t_grip;\nMoveL p_low, v500, fine, t_grip;"
    problem = problem_of(rapid(body, data=data), plant_with_rail())
    X_FT = problem.legs[0].X_FT
    np.testing.assert_allclose(X_FT[:3, 3], [0.01, 0.02, 0.12], atol=1e-15)
    np.testing.assert_allclose((problem.waypoints[1].X_WF @ X_FT)[:3, 3], [0.5, 0.6, 0.45], atol=1e-15)
    assert problem.legs[1].chord == pytest.approx(0.06, abs=1e-12)


def test_without_a_rail_nothing_of_it_is_left() -> None:
    data = "CONST robtarget p_here:=[[500,100,450],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];"
    body = "MoveJ p_here, v500, fine, tool0;\nWaitTime 0.1;\nMoveAbsJ j_home\\NoEOffs, v500, fine, tool0;"
    problem = problem_of(rapid(body, data=data), plant_without_rail())
    assert {stop.rail for stop in problem.waypoints} == {(0.0, 0.0)}
    assert problem.waypoints[3].q.shape == (6,)
    assert not problem.legs[1].rail_moves


def test_a_course_is_cut_only_where_nothing_is_left_to_choose() -> None:
    data = "CONST jointtarget j_mid:=[[10,0,0,0,30,0],[300,9E9,9E9,9E9,9E9,9E9]];"
    body = """MoveJ p_in, v500, fine, tool0;
MoveAbsJ j_mid, v500, fine, tool0;
MoveJ p_in, v500, fine, tool0;
MoveL p_low, v500, fine, tool0;
MoveAbsJ j_home, v500, fine, tool0;"""

    FREE, COORDINATED = Coupling

    def lengths(freedom: Freedom, coupling: Coupling, **plant: object) -> list[int]:
        problem = problem_of(rapid(body, data=data), plant_with_rail(**plant), freedom=freedom)
        problem = replace(problem, coupling=coupling)
        return [last - first for first, last in pieces(problem)]

    assert lengths(EVERYTHING, FREE) == [2, 3]
    assert lengths(EVERYTHING, COORDINATED) == [2, 3]
    assert lengths(EVERYTHING, COORDINATED, rail_fixed=True) == [1, 1, 1, 1, 1]
    # a stream may run the rail through a stop with speed even where its place is fixed
    assert lengths(EVERYTHING, FREE, rail_fixed=True) == [2, 3]
    assert lengths(AS_WRITTEN, FREE) == [1, 1, 1, 1, 1]


def test_confdata_is_demanded_only_where_the_program_holds_to_it() -> None:
    program = rapid(STATION)
    for conf_j, conf_l in ((True, True), (True, False), (False, True), (False, False)):
        motions = []
        for m in program.motions:
            if isinstance(m, MoveJ | MoveL):
                m = replace(m, settings=replace(m.settings, conf_j=conf_j, conf_l=conf_l))
            motions.append(m)
        problem = problem_of(replace(program, motions=tuple(motions)), plant_with_rail(), freedom=AS_WRITTEN)
        asked = [stop.conf for stop in problem.waypoints]
        j, line = (ConfData(0, 0, 0, 0) if on else None for on in (conf_j, conf_l))
        # start, MoveJ, MoveL, the wait there, MoveL, MoveAbsJ
        assert asked == [None, j, line, line, line, None]


def test_the_target_says_how_axes_are_coupled_and_coordinated_axes_rest_everywhere() -> None:
    program, plant = rapid(STATION), plant_with_rail()
    stream, written = (problem_of(program, plant, target) for target in (Target.STREAM, Target.RAPID))
    assert (stream.coupling, written.coupling) == (Coupling.FREE, Coupling.COORDINATED)
    inner = range(1, len(stream.waypoints) - 1)
    assert not any(stream.rests(k) for k in inner)
    straight = replace(stream, coupling=Coupling.COORDINATED)
    assert all(problem.rests(k) for problem in (straight, written) for k in inner)
    assert straight.target is Target.STREAM


def test_motions_that_may_not_change_keep_rail_and_configuration() -> None:
    """Whatever the target; a wait among them keeps the rail still."""
    changes = Changes(frozenset({0, 5}))
    for target in Target:
        problem = problem_of(rapid(STATION), plant_with_rail(), target, changes=changes)
        assert [stop.rail[0] < stop.rail[1] for stop in problem.waypoints] == [False, True, False, False, False, False]
        assert [stop.conf for stop in problem.waypoints] == [None, None, *[ConfData(0, 0, 0, 0)] * 3, None]
        assert [leg.motion for leg in problem.legs if not leg.rail_moves] == [2]


def test_a_problem_says_how_its_target_binds_the_axes() -> None:
    couplings = {target: problem_of(rapid(STATION), plant_with_rail(), target).coupling for target in Target}
    assert couplings == {Target.STREAM: Coupling.FREE, Target.RAPID: Coupling.COORDINATED}


def test_what_may_change_and_what_may_go_are_one_noun() -> None:
    program = rapid("MoveJ p_in, v500, fine, tool0; ! trajopt: optional\nMoveAbsJ j_home, v500, fine, tool0;")
    assert everything(program, plant_with_rail()) == Changes(
        frozenset({0, 1}), droppable=frozenset({0}), detours=((0,), (1,))
    )


def test_messages_name_a_motion_as_the_program_spells_it() -> None:
    program = rapid("ArcL p_in, v500, seam1, weld1, fine, tool0;\nMoveJ p_in, v500, fine, tool0;\nWaitTime 1;\nSet d;")
    assert [motion_name(motion) for motion in program.motions] == ["ArcL p_in", "MoveJ p_in", "Wait", "SignalEvent"]


def test_a_rail_left_open_by_a_motion_that_must_stay_is_where_the_program_had_it() -> None:
    """Nobody can write a value there, so the motion before, and all that is tied to it, must leave it there."""
    data = "CONST robtarget p_open:=[[500,600,400],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];"
    body = """MoveJ p_low, v500, fine, tool0;
MoveJ p_in, v500, fine, tool0;
MoveL p_open, v500, fine, tool0;
MoveJ p_in, v500, fine, tool0;"""
    program, plant = rapid(body, data=data), plant_with_rail()
    problem = problem_of(program, plant, Target.RAPID, changes=Changes(frozenset({0, 1, 3}), ((1, 3),)))
    assert [stop.rail for stop in problem.waypoints[1:]] == [(-0.2, 2.2), (0.6, 0.6), (0.6, 0.6), (0.6, 0.6)]
    free = problem_of(program, plant, Target.RAPID, changes=Changes(frozenset(range(4)), ((1, 3),)))
    assert {stop.rail for stop in free.waypoints[1:]} == {(-0.2, 2.2)}
    assert free.ties == ((2, 4),)


HELD = """MoveJ p_in, v2500, fine, tool0;
MoveJ p_low, v2500, fine, tool0; ! trajopt: hold rail
MoveL p_in, v500, fine, tool0; ! trajopt: hold rail
WaitTime 0.3; ! trajopt: hold rail
MoveAbsJ j_home, v1000, fine, tool0;"""


def test_where_the_rail_is_held_no_leg_moves_it() -> None:
    for target in Target:
        problem = problem_of(rapid(HELD), plant_with_rail(), target)
        assert [leg.rail_moves for leg in problem.legs] == [True, False, False, False, True]
        assert {stop.rail for stop in problem.waypoints[1:5]} == {(-0.2, 2.2)}
        assert not any(problem.rail_may_pass(k) for k in range(1, 5))


def test_a_held_rail_is_where_it_is_fixed_at_either_end() -> None:
    from_joints = "MoveAbsJ j_home, v500, fine, tool0;\nMoveJ p_here, v500, fine, tool0; ! trajopt: hold rail"
    data = "CONST robtarget p_here:=[[500,100,450],[0,0,1,0],[0,0,0,0],[600,9E9,9E9,9E9,9E9,9E9]];"
    assert problem_of(rapid(from_joints, data=data), plant_with_rail()).waypoints[2].rail == (0.0, 0.0)
    to_joints = "MoveJ p_here, v500, fine, tool0;\nMoveAbsJ j_home, v500, fine, tool0; ! trajopt: hold rail"
    assert problem_of(rapid(to_joints, data=data), plant_with_rail()).waypoints[1].rail == (0.0, 0.0)
    assert problem_of(rapid(HELD), plant_without_rail(), Target.RAPID).legs[1].rail_moves


def test_a_program_that_moves_a_held_rail_itself_is_answered_with_both() -> None:
    body = "MoveJ p_in, v500, fine, tool0;\nMoveAbsJ j_home, v500, fine, tool0; ! trajopt: hold rail"
    answer = build_problem(rapid(body), plant_with_rail(), AS_WRITTEN, Target.STREAM, EVERY)
    assert isinstance(answer, Infeasible)
    assert str(answer) == (
        "t.mod:6:1: MoveAbsJ j_home takes the rail from 600 mm to 0 mm, and a comment in the program says that it"
        " stands still there; give both ends the same position, or take the hold back"
    )


@pytest.mark.parametrize(("ends", "moves"), [("p_low", False), ("[[500,600,390],[0,0,1,0],[0,0,0,0],[650{}]]", True)])
def test_the_rail_stands_still_in_a_search_unless_the_program_drives_it(ends: str, moves: bool) -> None:
    """Where it would be at the hit, nobody knows before."""
    search = f"SearchL\\Stop,di1,p_hit,{ends.format(',9E9' * 5)},v50,tool0;"
    program = rapid(
        f"MoveJ p_in, v500, fine, tool0;\n{search}", Scenario(searches={"di1": 0.5}), "VAR robtarget p_hit;"
    )
    for target in Target:
        assert [leg.rail_moves for leg in problem_of(program, plant_with_rail(), target).legs] == [True, moves]


TURNS = ((30, "z50"), (54, "fine"))


def test_a_programmed_time_of_a_turn_in_place_beside_a_fly_by_is_a_speed_of_turning() -> None:
    turns = [f"MoveL RelTool(p_in,0,0,0\\Rz:={angle}), v100\\T:=0.5, {zone}, tool0;" for angle, zone in TURNS]
    problem = problem_of(rapid("\n".join(["MoveJ p_in, v500, fine, tool0;", *turns])), plant_with_rail())
    assert [leg.duration for leg in problem.legs] == [None, None, None]
    assert [leg.v_ori for leg in problem.legs[1:]] == pytest.approx(np.radians([30, 24]) / 0.5)
    assert all(leg.v_tcp > 0 for leg in problem.legs)


@pytest.mark.parametrize("conf_l", ["On", "Off"])
def test_the_arm_that_external_axes_carry_is_where_the_point_before_leaves_it(conf_l: str) -> None:
    """A line in place to the joints' own pose, which leaves joint_6 open to whole turns, and the rail goes on alone."""
    target = "[[506.291651,0,679.5],[0.5,0,0.866025404,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]]"
    program = rapid(
        f"ConfL \\{conf_l};\nMoveAbsJ j_home, v1000, fine, tool0;\nMoveL {target}, v1000, fine, tool0;\n"
        "MoveExtJ [[9E9,9E9,9E9,9E9,9E9,9E9],[400,9E9,9E9,9E9,9E9,9E9]], v1000, fine;",
    )
    problem = problem_of(program, plant_with_rail())
    arms = np.array([point.q[-6:] for point in problem.waypoints if point.q is not None])
    assert len(arms) == 4
    np.testing.assert_allclose(arms, np.tile(HOME, (4, 1)), atol=1e-6)


def test_every_axis_stands_where_a_spot_weld_is_set() -> None:
    ends = "[0,0,1,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]]"
    data = f"CONST robtarget a:=[[500,0,450],{ends}; CONST robtarget b:=[[500,100,450],{ends};"
    data += " PERS gundata g:=[0,0]; PERS spotdata s:=[0,0];"
    body = "MoveL a,v500,fine,tool0; SpotL b,v500,g,s,tool0; MoveL a,v500,fine,tool0; MoveL b,v500,fine,tool0;"
    program = rapid(body, data=data)
    problem = problem_of(program, plant_with_rail())
    assert [point.rest for point in problem.waypoints] == [True, False, True, False, True]
    stood = [any(stands_for(wait) for _, wait in one.holds) for one in points_of(program, plant_with_rail())]
    assert stood == [False, False, True, False, False]  # as the judge has it
