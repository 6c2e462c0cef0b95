"""Intervals of times: closed forms of single joint moves, and what two motions that err together save."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from small_cells import plant_with_rail, plant_without_rail, rapid

from trajopt_cli.limits import SPREADS, TcpCaps
from trajopt_cli.plan import optimize
from trajopt_cli.plan.uncertainty import saving, uncertainty
from trajopt_cli.problem.decision_scope import AS_WRITTEN
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.runs.uncertainty import WRITTEN, Guess, Uncertainty, between, changes
from trajopt_cli.scenario import ESTIMATED_SETTLING, NO_SETTLING, Scenario, Settling

V, A = np.radians(200), 15.0  # of joint_1 of the IRB 140
D_SPEED, D = (SPREADS[kind]["D"] for kind in ("velocity", "acceleration"))


def turning(*degrees: float, way: str = "") -> str:
    """Moves of joint_1 to these angles, and back home."""
    moves = [f"MoveAbsJ [[{one},0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v7000{way},fine,tool0;" for one in (*degrees, 0)]
    return "\n".join(moves)


def plant(**more: object) -> Plant:
    """Caps of the tool that nothing reaches."""
    return plant_without_rail(**{"free_speed": True, "tcp": TcpCaps(90.0, 900.0), **more})


def asked(body: str, machine: Plant, settle: Settling = NO_SETTLING) -> tuple[float, Uncertainty]:
    """A program's time as written, and its interval."""
    program = rapid(body, Scenario(settle=settle))
    plan = optimize(program, machine, Target.RAPID, AS_WRITTEN, bounded=False)
    assert isinstance(plan, Plan)
    return plan.duration, uncertainty(program, machine, settle, {WRITTEN: plan})


def ends(found: Uncertainty) -> tuple[float, float]:
    low, high = found.cycle_time_range_s[WRITTEN]
    assert low is not None
    assert high is not None
    return low, high


def takes(way: float, v: float = V, a: float = A) -> float:
    """From rest to rest [s]."""
    return way / v + v / a if way > v * v / a else 2 * np.sqrt(way / a)


@pytest.mark.parametrize("degrees", [20, 120], ids=["never at full speed", "at full speed"])
def test_one_joint_takes_between_the_times_of_both_ends(degrees):
    T, found = asked(turning(degrees), plant())
    low, high = ends(found)
    way = np.radians(degrees)
    assert low == pytest.approx(2 * takes(way, a=D[1] * A), abs=1e-3)
    assert high == pytest.approx(2 * takes(way, a=D[0] * A), abs=1e-3)
    assert low < T < high
    assert ends(asked(turning(degrees), plant())[1]) == (low, high)


def test_two_sources_err_each_by_itself_and_one_source_as_a_whole():
    limits = plant().limits
    machine = plant(limits=replace(limits, spread={**limits.spread, "joint_1.velocity": D_SPEED}))
    T, found = asked(turning(120), machine)
    way = np.radians(120)
    steps = [2 * takes(way, v=D_SPEED[0] * V) - T, 2 * takes(way, a=D[0] * A) - T]
    assert ends(found)[1] - T == pytest.approx(np.hypot(*steps), abs=4e-3)
    assert len(found.guesses) == 2  # of the six accelerations of one source, one


def test_what_is_saved_is_known_better_than_the_times_that_it_is_made_of():
    times, steps, ranges = [], [], []
    for degrees in (40, 18, 4.5):
        T, found = asked(turning(degrees), plant())
        times.append(T)
        steps.append(found.guesses[0].longer_s[WRITTEN])
        ranges.append(ends(found))
    assert ranges[1][0] / times[1] < 0.7
    assert saving(times[1], times[2], [(steps[1], steps[2])]) is None  # T is 2 sqrt(way / a): half of it with any a
    least, most = saving(times[0], times[2], [(steps[0], steps[2])])
    assert least <= 1 - times[2] / times[0] <= most
    (fast, slow), (low, high) = ranges[0], ranges[2]
    assert most - least < ((1 - low / slow) - (1 - high / fast)) / 5


def test_what_the_program_times_is_no_shorter_with_faster_axes():
    T, found = asked(f"WaitTime 2;\n{turning(20, way=chr(92) + 'T:=2')}", plant())
    np.testing.assert_allclose(T, 6.0, atol=1e-6)
    assert not found.guesses


def test_a_long_wait_of_a_stream_stays_as_long(unrefined):
    """Its rail moves at the beginning and at the end: three legs of the problem, one motion of the program."""
    machine = plant_with_rail()
    spread = {f"{axis}.acceleration": D for axis in machine.limits.names}
    sources = dict.fromkeys(spread, "a test (grade D)")
    machine = replace(machine, limits=replace(machine.limits, spread=spread, sources=sources))
    program = rapid("MoveJ p_in,v500,fine,tool0;\nWaitTime 20;\nMoveL p_low,v500,fine,tool0;")
    plan = optimize(program, machine, Target.STREAM, bounded=False)
    assert isinstance(plan, Plan)
    low, high = ends(uncertainty(program, machine, NO_SETTLING, {WRITTEN: plan}))
    assert 20 < low < plan.duration < high


def test_stops_that_are_waited_for_settle_as_long_as_the_robot_does():
    machine = plant(limits=replace(plant().limits, spread={}))
    body = f"WaitTime 1;\n{turning(20).splitlines()[0]}\nWaitTime 1;\n{turning(0).splitlines()[0]}\nWaitTime 1;"
    T, found = asked(body, machine, Settling(0.1, 0.1, "a test (grade C)", (0.5, 1.75)))
    np.testing.assert_allclose(T, 3 + 2 * 0.1 + 2 * takes(np.radians(20)), atol=2e-3)
    assert ends(found) == pytest.approx([T - 2 * 0.05, T + 2 * 0.075])
    assert [one.name for one in found.guesses] == ["settling, grade C"]
    assert ESTIMATED_SETTLING.spread == SPREADS["settling"]["C"]


@pytest.mark.filterwarnings("error")
def test_a_limit_along_the_path_stands_beside_moves_that_the_tool_does_not_limit():
    limits = plant_with_rail().limits
    unsure = {"spread": {"rail.acceleration": D}, "sources": {"rail.acceleration": "a guess (grade D)"}}
    limited = plant_with_rail(limits=replace(limits, **unsure))
    data = "CONST jointtarget jE:=[[0,0,0,0,30,0],[300,9E9,9E9,9E9,9E9,9E9]];"
    data += "CONST robtarget p:=[[500,100,500],[0,0,1,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]];"
    body = "MoveJ p,v1000,fine,tool0;WaitTime 0.1;PathAccLim TRUE\\AccMax:=1,TRUE\\DecelMax:=2;"
    body += "MoveL Offs(p,0,0,100),v1000,fine,tool0;PathAccLim FALSE,FALSE;MoveExtJ jE,vlin500,fine;"
    program = rapid(body, data=data)
    plan = optimize(program, limited, Target.RAPID, AS_WRITTEN, bounded=False)
    assert isinstance(plan, Plan), plan
    found = uncertainty(program, limited, NO_SETTLING, {WRITTEN: plan})
    low, high = ends(found)
    assert low < plan.duration < high


def test_nothing_is_unsure_where_the_cell_measured_everything():
    limits = plant().limits
    assert asked(turning(20), plant(limits=replace(limits, spread={})))[1] == Uncertainty()


def test_the_tools_caps_are_a_guess_where_they_are_the_robots():
    """A cap of 1 m/s that only the robot's file says: 0.5 to 2 m/s, of a tool that stands 0.5 m from joint_1's axis."""
    machine = plant()
    robot = replace(
        machine.robot, tcp=TcpCaps(0.5, 900.0), tcp_spread={"speed": (0.5, 2.0), "acceleration": (1.0, 1.0)}
    )
    machine = replace(machine, robot=robot, limits=replace(machine.limits, spread={}))
    assert not asked(turning(120), replace(machine, tcp=TcpCaps(0.5, 900.0)))[1].guesses
    T, found = asked(turning(120), replace(machine, tcp=robot.tcp))
    (guess,) = found.guesses
    assert guess.shares == {"tcp": (0.5, 2.0)}
    reach = float(np.linalg.norm(robot.forward(machine.start)[:2, 3]))
    way = np.radians(120)
    np.testing.assert_allclose(T, 2 * takes(way, v=0.5 / reach), atol=4e-3)
    assert ends(found) == pytest.approx([2 * takes(way, v=v / reach) for v in (1.0, 0.25)], abs=8e-3)


def test_a_motion_that_some_end_leaves_no_way_to_drive_has_no_longest_time():
    steps = {WRITTEN: (np.inf, -0.1), "rapid": (0.1, 0.0)}
    guess = Guess(
        name="joint_2 torque, grade D", source="a test (grade D)", shares={"joint_2": (0.5, 2)}, longer_s=steps
    )
    found = Uncertainty(cycle_time_range_s={WRITTEN: (1.9, np.inf)}, guesses=[guess])
    assert Uncertainty.model_validate_json(found.model_dump_json()) == found
    assert found.around(WRITTEN) == ", 1.9 or more with these guesses (joint_2 torque, grade D)"
    assert saving(2.0, 1.0, [(steps[WRITTEN], steps["rapid"])]) is None


@pytest.mark.parametrize(
    ("times", "text"),
    [((6.61, 7.44), "6.6 to 7.5"), ((6.4999, 7.14), "6.5 to 7.2"), ((8.8401, 8.8726), "8.840 to 8.873"),
     ((93.2, 118.9), "93 to 119"), ((2.0, None), "2.0 or more")],
)  # fmt: skip
def test_an_interval_is_rounded_outward(times, text):
    assert between(times) == text


def test_a_saving_begins_with_its_lesser_end():
    assert changes((0.19, 0.234)) == "−19 to −24"
    assert changes((-0.013, 0.02)) == "+1.3 to −2.0"
