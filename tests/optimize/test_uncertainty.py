"""Intervals of times: closed forms of single joint moves, and what two motions that err together save."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from small_cells import plant_without_rail, rapid

from trajopt_cli.limits import SPREADS, TcpCaps
from trajopt_cli.plan import optimize
from trajopt_cli.plan.uncertainty import uncertainty
from trajopt_cli.problem.decision_scope import AS_WRITTEN
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.uncertainty import Guess, Uncertainty, guesses_of
from trajopt_cli.table import between, changes

V, A = np.radians(200), 15.0  # of joint_1 of the IRB 140
D_SPEED, D = (SPREADS[kind]["D"] for kind in ("velocity", "acceleration"))


def turning(*degrees: float, way: str = "") -> str:
    """Moves of joint_1 to these angles, and back home."""
    moves = [f"MoveAbsJ [[{one},0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v7000{way},fine,tool0;" for one in (*degrees, 0)]
    return "\n".join(moves)


def plant(**more: object) -> Plant:
    """Caps of the tool that nothing reaches."""
    return plant_without_rail(**{"free_speed": True, "tcp": TcpCaps(90.0, 900.0), **more})


def asked(bodies: dict[str, str], machine: Plant) -> Uncertainty:
    """The interval of each program as written; all as one program's plans."""
    plans, programs = dict[str, Plan](), {name: rapid(body) for name, body in bodies.items()}
    for name, program in programs.items():
        found = optimize(program, machine, Target.RAPID, AS_WRITTEN, bounded=False)
        assert isinstance(found, Plan)
        plans[name] = found
    each = [uncertainty(programs[name], machine, {name: plan}) for name, plan in plans.items()]
    guesses = [*each[0].steps]
    steps = {one: {name: ends for found in each for name, ends in found.steps[one].items()} for one in guesses}
    return Uncertainty({name: plan.duration for name, plan in plans.items()}, steps)


def takes(way: float, v: float = V, a: float = A) -> float:
    """From rest to rest [s]."""
    return way / v + v / a if way > v * v / a else 2 * np.sqrt(way / a)


@pytest.mark.parametrize("degrees", [20, 120], ids=["never at full speed", "at full speed"])
def test_one_joint_takes_between_the_times_of_both_ends(degrees):
    found = asked({"there": turning(degrees)}, plant())
    low, high = found.range_of("there")
    way = np.radians(degrees)
    assert low == pytest.approx(2 * takes(way, a=D[1] * A), abs=4e-3)
    assert high == pytest.approx(2 * takes(way, a=D[0] * A), abs=4e-3)
    assert low < found.times["there"] < high
    again = asked({"there": turning(degrees)}, plant())
    assert again.range_of("there") == (low, high)


def test_two_sources_err_each_by_itself_and_one_source_as_a_whole():
    limits = plant().limits
    machine = plant(limits=replace(limits, spread={**limits.spread, "joint_1.velocity": D_SPEED}))
    found = asked({"there": turning(120)}, machine)
    way, T = np.radians(120), found.times["there"]
    steps = [2 * takes(way, v=D_SPEED[0] * V) - T, 2 * takes(way, a=D[0] * A) - T]
    assert found.range_of("there")[1] - T == pytest.approx(np.hypot(*steps), abs=4e-3)
    assert len(found.steps) == 2  # of the six accelerations of one source, one


def test_what_is_saved_is_known_better_than_the_times_that_it_is_made_of():
    found = asked({"far": turning(40), "near": turning(18), "nearer": turning(4.5)}, plant())
    assert found.range_of("near")[0] / found.times["near"] < 0.7
    assert found.saving("near", "nearer") is None  # T is 2 sqrt(way / a) of both: half of it is saved with any a
    least, most = found.saving("far", "nearer")
    assert least <= 1 - found.times["nearer"] / found.times["far"] <= most
    (fast, slow), (low, high) = found.range_of("far"), found.range_of("nearer")
    assert most - least < ((1 - low / slow) - (1 - high / fast)) / 5


def test_what_the_program_times_is_no_shorter_with_faster_axes():
    found = asked({"waits": f"WaitTime 2;\n{turning(20, way=chr(92) + 'T:=2')}"}, plant())
    low, high = found.range_of("waits") or (6.0, 6.0)
    assert (low, high) == pytest.approx((6.0, 6.0), abs=2e-3)


def test_nothing_is_unsure_where_the_cell_measured_everything():
    limits = plant().limits
    assert asked({"there": turning(20)}, plant(limits=replace(limits, spread={}))).range_of("there") is None


def test_the_tools_caps_are_a_guess_where_they_are_the_robots():
    machine = plant()
    kinds = [one.kind for one in guesses_of(replace(machine, tcp=machine.robot.tcp)) if not one.axes]
    assert kinds == ["speed", "acceleration"]
    assert not [one for one in guesses_of(plant()) if not one.axes]


def test_a_motion_that_some_end_leaves_no_way_to_drive_has_no_longest_time():
    guess = Guess("torque", ("joint_2",), "a test (grade D)", ((0.5, 2.0),))
    found = Uncertainty({"a": 2.0, "b": 1.0}, {guess: {"a": (np.inf, -0.1), "b": (0.1, 0.0)}})
    assert found.range_of("a")[1] == np.inf
    assert found.saving("a", "b") is None


@pytest.mark.parametrize(
    ("ends", "text"),
    [((6.61, 7.44), "6.6 to 7.5"), ((6.4999, 7.14), "6.5 to 7.2"), ((8.8401, 8.8726), "8.840 to 8.873"),
     ((93.2, 118.9), "93 to 119"), ((2.0, None), "2.0 or more")],
)  # fmt: skip
def test_an_interval_is_rounded_outward(ends, text):
    assert between(ends) == text


def test_a_saving_begins_with_its_lesser_end():
    assert changes((0.19, 0.234)) == "−19 to −24"
    assert changes((-0.013, 0.02)) == "+1.3 to −2.0"
