"""More freedom is never slower: by construction, on cells nobody tuned for, and where the search goes wrong."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from small_cells import plant_with_rail, rapid
from unrefined import coarse_search

from trajopt_cli.graph_search.search import search
from trajopt_cli.motion import Program
from trajopt_cli.plan import initial_plan, optimize
from trajopt_cli.plan.ladder import instead_of, out_of_order
from trajopt_cli.problem.decision_scope import AS_WRITTEN, EVERYTHING, FIXED_RAIL, Freedom, RailFreedom
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.problem import Problem
from trajopt_cli.problem.progress import Progress, never_worse
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.route import Route


def random_cell(seed: int) -> Program:
    """Two stations anywhere along the rail, the second with a wait."""
    rng = np.random.default_rng(seed)
    data, body = [], []
    for i in range(2):
        x, y, z, turn = rng.uniform(430, 560), rng.uniform(0, 1900), rng.uniform(200, 400), rng.uniform(-0.7, 0.7)
        quaternion = f"[0,{np.sin(turn / 2):.7f},{np.cos(turn / 2):.7f},0]"
        data.append(
            f"CONST robtarget s{i}:=[[{x:.1f},{y:.1f},{z:.1f}],{quaternion},[0,0,0,0],[{y:.1f},9E9,9E9,9E9,9E9,9E9]];"
        )
        body += [f"MoveJ Offs(s{i},0,0,80), v1000, fine, tool0;", f"MoveL s{i}, v500, fine, tool0;"]
        body += ["WaitTime 0.2;"] * i + [f"MoveL Offs(s{i},0,0,80), v500, fine, tool0;"]
    return rapid("\n".join([*body, "MoveAbsJ j_home, v1000, fine, tool0;"]), data="\n".join(data))


def rapid_plan(seed: int, freedom: Freedom) -> Plan | None:
    with pytest.MonkeyPatch.context() as patch:
        coarse_search(patch)
        plan = optimize(random_cell(seed), plant_with_rail(), Target.RAPID, freedom, bounded=False)
    return plan if isinstance(plan, Plan) else None


known = cache(rapid_plan)


def rapid_time(seed: int, freedom: Freedom) -> float | None:
    plan = known(seed, freedom)
    return plan and plan.duration


@pytest.mark.parametrize("seed", range(2))
def test_more_freedom_is_never_slower_on_random_cells(seed: int) -> None:
    times = [rapid_time(seed, one) for one in (EVERYTHING, FIXED_RAIL, AS_WRITTEN)]
    assert times[0] is not None
    assert times[1] is not None
    assert times[0] <= times[1]
    assert times[2] is None or times[1] <= times[2]


def test_where_the_search_finds_nothing_a_lesser_freedom_answers(monkeypatch: pytest.MonkeyPatch) -> None:
    def poor(axes: Axes, problem: Problem) -> Route | None:
        return None if problem.freedom.rail is RailFreedom.STOP else search(axes, problem)

    fixed = rapid_time(0, FIXED_RAIL)
    monkeypatch.setattr(initial_plan, "search", poor)
    found = rapid_plan(0, EVERYTHING)
    assert found is not None
    assert fixed is not None
    assert found.duration < fixed  # its rail is refined in the freedom that there is


def test_what_both_freedoms_allow() -> None:
    assert EVERYTHING.and_not_more_than(FIXED_RAIL) == FIXED_RAIL
    assert AS_WRITTEN.and_not_more_than(EVERYTHING) == AS_WRITTEN
    both = FIXED_RAIL.and_not_more_than(AS_WRITTEN)
    assert both.rail is RailFreedom.PROGRAMMED
    assert [both.lines, both.dwells, both.through_stops, both.configuration, both.drop] == [False] * 5


def test_the_best_that_is_told_never_gets_worse() -> None:
    heard: list[Progress] = []
    tell = never_worse(heard.append)
    for one in (Progress("a"), Progress("b", 3.0), Progress("c", 4.0, 1.0), Progress("d"), Progress("e", 2.0)):
        tell(one)
    assert [one.incumbent for one in heard] == [None, 3.0, 3.0, 3.0, 2.0]
    assert heard[2].bound == 1.0


def test_a_rapid_plan_that_is_faster_is_the_stream_plan() -> None:
    slow, fast = known(0, FIXED_RAIL), known(0, EVERYTHING)
    assert isinstance(slow, Plan)
    assert isinstance(fast, Plan)
    assert instead_of(fast, slow, Target.STREAM) is None
    stream = instead_of(replace(slow, lower_bound=1.0), fast, Target.STREAM)
    assert stream is not None
    assert (stream.target, stream.lower_bound, stream.duration) == (Target.STREAM, 1.0, fast.duration)
    assert stream.notes == ("the plan is the rapid plan: nothing faster was found",)
    assert out_of_order({"stream": fast, "rapid": fast, "as-written": slow}) is None
    wrong = out_of_order({"stream": slow, "rapid": fast})
    assert wrong == (
        f"an error in trajopt: the stream plan takes {slow.duration:.6f} s, the rapid plan, which may change less, "
        f"{fast.duration:.6f} s"
    )


@pytest.mark.parametrize(("saved", "kept"), [(0.0, True), (4e-4, True), (6e-4, False)])
def test_a_saving_that_is_shown_as_none_changes_no_program(saved: float, kept: bool) -> None:
    plan = known(0, EVERYTHING)
    assert isinstance(plan, Plan)
    t = plan.trajectory.t / (1 - saved)
    written = replace(plan, trajectory=replace(plan.trajectory, t=t))
    taken = instead_of(plan, written, Target.RAPID)
    assert (taken is not None) == kept
    if taken is not None:
        assert taken.duration == written.duration
        assert instead_of(plan, written, Target.STREAM) is None  # a stream changes no program
