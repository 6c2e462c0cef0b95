"""One run of a campaign: a hidden robot, its log, what identify says of it, and what estimate makes of that."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from measured.simulated_log import (
    NAMES,
    Move,
    Robot,
    drive,
    identification_moves,
    random_recorder,
    random_robot,
    record,
    working_moves,
)
from measured.simulated_log import PERIODS as PERIODS
from trajopt_cli.job import read_job
from trajopt_cli.measured.identify import Kind, Limit, identify
from trajopt_cli.measured.limits_file import limits_in_force, limits_section
from trajopt_cli.robot.model import load_robot
from trajopt_cli.study.estimate import Estimate, estimate
from trajopt_cli.trajectory import Trajectory

CELL = """robot: irb140_rail
rail: {eax: a, stroke: [-0.1, 2.1]}
tcp: {speed: 1000, acceleration: 100000, source: the simulated robot has none}
free_speed: true
settle: 0
"""
TOUCH = [list(pair) for pair in load_robot("irb140_rail").self_pairs if "attached" not in pair]


@dataclass(frozen=True)
class Answered:
    """One limit of one axis: whether the truth is inside, None where nothing is stated; half the interval and the
    error, as shares. slow: the log holds no full-speed motion of the axis."""

    axis: str
    kind: str
    inside: bool | None
    half: float
    error: float
    slow: bool


@dataclass(frozen=True)
class Outcome:
    """cycle: how far the estimate is off, as a share, of a program that drives the axes all of whose limits the log
    shows; guessed: of one that drives those, too, whose jerk it does not show. None where there are no such axes."""

    period: float
    jerk: bool
    limits: tuple[Answered, ...]
    cycle: float | None
    guessed: float | None = None


def one_run(seed: int, folder: Path | None, guess: bool = True) -> Outcome:
    """Run number `seed`. folder: where program and cell file of the estimate go, None for no estimate; guess: also
    estimate a program of axes whose jerk the log does not show."""
    rng = np.random.default_rng(seed)
    period, jerk = PERIODS[seed % 5], bool(seed // 5 % 2)
    robot, recorder = random_robot(rng, jerk), random_recorder(rng, period)
    slow = rng.choice(7, 1) if rng.random() < 0.5 else np.zeros(0, int)
    start, moves = identification_moves(rng, slow)
    t, q, _ = drive(robot, start, moves)
    log = Trajectory(NAMES, *record(robot, t, q, recorder, rng))
    found, _ = identify([log], limits_in_force("irb140_rail", None)[0])
    answered = tuple(_answered(one, robot, slow) for one in found)
    if folder is None:
        return Outcome(period, jerk, answered, None)
    shown = {kind: {i for i, one in enumerate(NAMES) if _has(found, one, kind)} for kind in Kind}
    moved = shown[Kind.SPEED] & shown[Kind.ACCELERATION]
    whole = moved & shown[Kind.JERK] if jerk else moved
    cycle = _off(folder, robot, start, sorted(whole), found, rng) if len(whole) > 1 else None
    unsure = guess and whole < moved and len(moved) > 1
    guessed = _off(folder, robot, start, sorted(moved), found, rng) if unsure else None
    return Outcome(period, jerk, answered, cycle, guessed)


def _has(found: list[Limit], axis: str, kind: Kind) -> bool:
    return any(one.axis == axis and one.kind is kind and one.value is not None for one in found)


def _off(
    folder: Path, robot: Robot, start: np.ndarray, axes: list[int], found: list[Limit], rng: np.random.Generator
) -> float:
    """How far the estimated cycle of another program is off, as a share of the simulated one."""
    work = working_moves(rng, start, axes)
    marks = drive(robot, start, work)[2]
    truth = marks[-1] - marks[0] + work[-1].wait
    return estimated(folder, start, work, found).plan.duration / truth - 1


def truth_of(robot: Robot, limit: Limit) -> float:
    values = {Kind.SPEED: robot.velocity, Kind.ACCELERATION: robot.acceleration, Kind.JERK: robot.jerk}[limit.kind]
    return np.inf if values is None else float(values[NAMES.index(limit.axis)])


def _answered(limit: Limit, robot: Robot, slow: np.ndarray) -> Answered:
    hidden = NAMES.index(limit.axis) in slow
    if limit.value is None:
        return Answered(limit.axis, limit.kind.value, None, np.nan, np.nan, hidden)
    truth = truth_of(robot, limit)
    half = (limit.high - limit.low) / 2 / limit.value
    return Answered(
        limit.axis, limit.kind.value, limit.low <= truth <= limit.high, half, limit.value / truth - 1, hidden
    )


def program_text(start: np.ndarray, moves: list[Move]) -> str:
    """The moves as RAPID; start is given in the cell file."""
    lines = ["MODULE Work", "PROC main()"]
    for move in moves:
        joints = ",".join(f"{value:.12g}" for value in np.degrees(move.q[1:]))
        lines.append(f"MoveAbsJ [[{joints}],[{1e3 * move.q[0]:.12g},9E9,9E9,9E9,9E9,9E9]], vmax, fine, tool0;")
        if move.wait:
            lines.append(f"WaitTime {move.wait:.12g};")
    return "\n".join([*lines, "ENDPROC", "ENDMODULE", ""])


def cell_text(start: np.ndarray, found: list[Limit]) -> str:
    section = limits_section(found, ["simulated.csv"])
    jerk = "jerk_limits: true\n" if any(one.kind is Kind.JERK and one.value for one in found) else ""
    joints = [float(value) for value in start[1:]]
    return f"{CELL}{jerk}may_touch: {TOUCH}\nstart: {{joints: {joints}, rail: {float(start[0])}}}\n{section}"


def estimated(folder: Path, start: np.ndarray, moves: list[Move], found: list[Limit]) -> Estimate:
    """The estimate of a program with identified limits, read from the files that a user would have."""
    program = folder / "work.mod"
    program.write_text(program_text(start, moves))
    program.with_suffix(".yaml").write_text(cell_text(start, found))
    answer = estimate(read_job(program))
    assert isinstance(answer, Estimate), answer
    return answer
