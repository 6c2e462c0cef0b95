"""Limits from simulated logs: the truth inside the interval, nothing said of what is not shown. The hundred runs are
benchmarks/bench_identify.py."""

from __future__ import annotations

import numpy as np
import pytest

from measured.campaign import CELL, Outcome, one_run, truth_of
from measured.simulated_log import NAMES, Move, Recorder, Robot, drive, identification_moves, random_robot, record
from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.measured.identify import Kind, Limit, identify
from trajopt_cli.measured.limits_file import limits_in_force, limits_section
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.trajectory import Trajectory

RECORDER = Recorder(0.024, 3e-4, True, np.radians(0.01), 1e-4, np.radians(0.002), 2e-5, 0.02)
SLOW = 3


def found_in(robot: Robot, start: np.ndarray, moves: list[Move], seed: int = 1) -> dict[tuple[str, str], Limit]:
    rng = np.random.default_rng(seed)
    t, q, _ = drive(robot, start, moves)
    log = Trajectory(NAMES, *record(robot, t, q, RECORDER, rng))
    found, _ = identify([log], limits_in_force("irb140_rail", None)[0])
    return {(one.axis, one.kind.value): one for one in found}


@pytest.fixture(scope="module")
def robot() -> Robot:
    return random_robot(np.random.default_rng(77), jerk=False)


@pytest.fixture(scope="module")
def shown(robot: Robot) -> dict[tuple[str, str], Limit]:
    return found_in(robot, *identification_moves(np.random.default_rng(77), [SLOW]))


@pytest.mark.long
def test_speeds_and_accelerations_hold_the_truth(robot: Robot, shown: dict[tuple[str, str], Limit]) -> None:
    stated = [one for one in shown.values() if one.value is not None and one.kind is not Kind.JERK]
    assert len(stated) >= 10
    for one in stated:
        assert one.low <= truth_of(robot, one) <= one.high, one
        assert (one.high - one.low) / one.value < {Kind.SPEED: 0.01, Kind.ACCELERATION: 0.1}[one.kind]
        assert one.motions >= 3


def test_an_axis_without_a_full_speed_motion_is_told_so(shown: dict[tuple[str, str], Limit]) -> None:
    slow = shown[NAMES[SLOW], "speed"]
    assert slow.value is None
    assert slow.why.startswith("no full-speed motion")


def test_accelerations_that_jump_show_no_jerk(shown: dict[tuple[str, str], Limit]) -> None:
    assert [axis for (axis, kind), one in shown.items() if kind == "jerk" and one.value is not None] == []


def test_what_is_written_loads_as_a_cell_file_and_holds_no_more(shown: dict[tuple[str, str], Limit]) -> None:
    text = limits_section(list(shown.values()), ["a log.csv"])
    cell = parse_cell(f"{CELL}start: {{joints: [0, 0, 0, 0, 0.5, 0], rail: 0}}\n{text}", "cell.yaml")
    limits = build_plant(cell).limits
    keys = {Kind.SPEED: "velocity", Kind.ACCELERATION: "acceleration", Kind.JERK: "jerk"}
    written = {(change.axis, change.kind) for change in cell.overrides}
    assert written == {(one.axis, keys[one.kind]) for one in shown.values() if one.value is not None}
    for one in shown.values():
        if one.value is not None:
            value = getattr(limits, keys[one.kind])[NAMES.index(one.axis)]
            assert one.low <= value <= one.high  # digits enough
            assert limits.sources[f"{one.axis}.{keys[one.kind]}"].startswith("identified from a log.csv")


def moves_of_joint_1(
    shares: list[float], cap: float = np.inf, with_joint_2: float = 0.0
) -> tuple[np.ndarray, list[Move]]:
    q, out = np.zeros(7), []
    for share in shares:
        q = q.copy()
        q[1] += share
        q[2] += with_joint_2 * share
        out.append(Move(q, cap / abs(share), 0.7))
    return np.zeros(7), out


def test_one_move_again_and_again_shows_no_limit(robot: Robot) -> None:
    found = found_in(robot, *moves_of_joint_1([2.0, -2.0, 2.0, -2.0]))
    assert found["joint_1", "speed"].value is None
    assert "one move again" in found["joint_1", "speed"].why


def test_a_programmed_speed_is_not_taken_for_a_limit(robot: Robot) -> None:
    found = found_in(robot, *moves_of_joint_1([2.0, -1.2, 1.0, -1.5], cap=0.5))
    assert found["joint_1", "speed"].value is None
    assert "as programmed speeds do" in found["joint_1", "speed"].why
    assert found["joint_1", "speed"].most == pytest.approx(0.5, rel=0.01)


def test_an_axis_that_rides_along_is_not_taken_for_the_one_that_limits(robot: Robot) -> None:
    found = found_in(robot, *moves_of_joint_1([2.0, -1.2, 1.0, -1.5], with_joint_2=0.3))
    for axis in ("joint_1", "joint_2"):
        assert found[axis, "speed"].value is None
        assert "another axis may be what limits it" in found[axis, "speed"].why


@pytest.fixture(scope="module")
def jerky(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    return one_run(9007, tmp_path_factory.mktemp("work"), guess=False)  # 24 ms


@pytest.mark.long
def test_jerk_limited_ramps_give_the_jerk(jerky: Outcome) -> None:
    stated = [limit for limit in jerky.limits if limit.inside is not None]
    assert {limit.kind for limit in stated} == {"speed", "acceleration", "jerk"}
    assert all(limit.inside for limit in stated)


def test_an_estimate_of_another_program_with_identified_limits_is_within_one_percent(jerky: Outcome) -> None:
    assert jerky.cycle is not None
    assert abs(jerky.cycle) < 0.01
