"""The order of stations: against all permutations, and against the search's own times of the whole program."""

from __future__ import annotations

from itertools import pairwise, permutations
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.graph_search.sequence import (
    NotApart,
    Steps,
    best_order,
    improved_order,
    least_time,
    near_orders,
    nearest_order,
    steps_of,
)
from trajopt_cli.job import Job, read_job
from trajopt_cli.problem.build import build_problem
from trajopt_cli.problem.decision_scope import EVERYTHING
from trajopt_cli.problem.editable import everything
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.problem import Problem
from trajopt_cli.trajectories.axes import Axes

CELL = """robot: irb140_rail
settle: 0
rail: {eax: a, stroke: [0, 2]}
start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}
"""


def some_steps(n: int, seed: int, closed: float = 0.0) -> Steps:
    """Random times with a few states at every station; a share of the ways is closed."""
    random = np.random.default_rng(seed)
    sizes = random.integers(1, 5, n)

    def times(*shape: int) -> np.ndarray:
        return np.where(random.random(shape) < closed, np.inf, random.uniform(0.5, 3.0, shape))

    return Steps(
        tuple(times(m) for m in sizes),
        tuple(tuple(times(a, b) for b in sizes) for a in sizes),
        tuple(times(m) for m in sizes),
    )


def brute(steps: Steps, order: tuple[int, ...]) -> float:
    """The least over all routes of states, one by one."""
    costs = {s: t for s, t in enumerate(steps.enter[order[0]])}
    for i, j in pairwise(order):
        T = steps.between[i][j]
        costs = {b: min(costs[a] + T[a, b] for a in costs) for b in range(T.shape[1])}
    return min(cost + steps.leave[order[-1]][s] for s, cost in costs.items())


@pytest.mark.parametrize(("n", "seed", "closed"), [(1, 0, 0.0), (2, 1, 0.0), (5, 2, 0.0), (6, 3, 0.0), (6, 4, 0.4)])
def test_the_best_order_is_that_of_all_permutations(n: int, seed: int, closed: float) -> None:
    steps = some_steps(n, seed, closed)
    every = {order: brute(steps, order) for order in permutations(range(n))}
    cost, order = best_order(steps)
    assert cost == pytest.approx(min(every.values()))
    assert every[order] == pytest.approx(cost)
    assert least_time(steps) <= cost + 1e-12
    for one in (nearest_order(steps), tuple(range(n))):
        better = improved_order(steps, one)
        assert sorted(better) == list(range(n))
        assert cost - 1e-12 <= every[better] <= every[one]
        assert steps.cost(one) == pytest.approx(every[one])


def test_of_many_stations_the_order_found_is_no_worse_than_what_it_began_with_and_above_the_bound() -> None:
    steps = some_steps(16, 7)
    written = tuple(range(16))
    for start in (nearest_order(steps), written):
        found = improved_order(steps, start)
        assert sorted(found) == list(written)
        assert least_time(steps) <= steps.cost(found) <= steps.cost(start)
        assert steps.cost(near_orders(steps, found, 1)[0]) >= steps.cost(found) - 1e-9  # no step leads farther down
    assert steps.cost(improved_order(steps, written)) < 0.8 * steps.cost(written)


def test_orders_that_cannot_be_done_have_no_finite_time() -> None:
    steps = some_steps(3, 5)
    shut = Steps(steps.enter, steps.between, tuple(np.full_like(one, np.inf) for one in steps.leave))
    assert best_order(shut)[0] == np.inf
    assert shut.cost((0, 1, 2)) == np.inf
    assert near_orders(shut, (0, 1, 2), 5) == []


def test_neighbours_are_other_orders_of_the_same_stations_the_best_first() -> None:
    steps = some_steps(6, 6)
    found = near_orders(steps, (0, 1, 2, 3, 4, 5), 7)
    assert len(set(found)) == 7
    assert all(sorted(one) == [0, 1, 2, 3, 4, 5] for one in found)
    costs = [steps.cost(one) for one in found]
    assert costs == sorted(costs)


def module(order: tuple[int, ...], last: str = "MoveAbsJ j_home, v1000, fine, tool0;") -> str:
    places = {0: (500, 300), 1: (550, 1500), 2: (500, 900)}
    data = "".join(
        f" CONST robtarget p{i}:=[[{x},{y},400],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
        f" CONST robtarget q{i}:=[[{x},{y},480],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
        f" CONST robtarget r{i}:=[[{x - 50},{y + 90},440],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
        for i, (x, y) in places.items()
    )
    moves = "".join(
        f"  MoveJ q{i}, v1000, fine, tool0;\n  MoveL p{i}, v200, fine, tool0;\n  WaitTime 0.2;\n"
        f"  MoveL r{i}, v200, fine, tool0;\n"
        for i in order
    )
    home = " CONST jointtarget j_home:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];\n"
    return f"MODULE m\n{home}{data} PROC main()\n{moves}  {last}\n ENDPROC\nENDMODULE\n"


def problem_of(folder: Path, text: str) -> tuple[Job, Problem]:
    (folder / "m.mod").write_text(text)
    (folder / "m.yaml").write_text(CELL)
    job = read_job(folder / "m.mod")
    changes = everything(job.program, job.plant)
    problem = build_problem(job.program, job.plant, EVERYTHING, Target.RAPID, changes)
    assert isinstance(problem, Problem)
    return job, problem


def test_times_of_an_order_are_those_of_the_program_written_so(tmp_path: Path) -> None:
    """The same states and the same ways, whichever order the tables were made from."""
    motions = [(0, 4), (4, 8), (8, 12)]
    written = (0, 1, 2)
    job, problem = problem_of(tmp_path, module(written))
    steps = steps_of(Axes.of(job.plant), problem, motions)
    assert steps is not None
    for order in ((2, 0, 1), (0, 2, 1)):
        _, other = problem_of(tmp_path, module(order))
        again = steps_of(Axes.of(job.plant), other, motions)
        assert again is not None
        assert steps.cost(order) == pytest.approx(again.cost(written), rel=1e-12)
    # from 0 out to 1.5 m and back all orders are as long but those that turn back twice
    every = {order: steps.cost(order) for order in permutations(written)}
    assert max(every[order] for order in every if order not in ((1, 0, 2), (2, 0, 1))) < every[1, 0, 2] - 0.5
    assert best_order(steps)[0] == pytest.approx(min(every.values()))


def test_a_station_begins_with_a_joint_move(tmp_path: Path) -> None:
    job, problem = problem_of(tmp_path, module((0, 1, 2)))
    with pytest.raises(NotApart) as refused:
        steps_of(Axes.of(job.plant), problem, [(0, 4), (5, 8)])
    assert refused.value.station == 1
    job, problem = problem_of(tmp_path, module((0, 1, 2), "WaitTime 1;"))
    with pytest.raises(NotApart) as refused:
        steps_of(Axes.of(job.plant), problem, [(0, 4), (4, 8), (8, 12)])
    assert refused.value.station is None
