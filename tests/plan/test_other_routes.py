"""Routes that take little longer by the search's estimates: all of them are told, and the best one is kept."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise, product
from pathlib import Path

import numpy as np
import pytest
from unrefined import set_defaults

from trajopt_cli.graph_search.edges import Dense
from trajopt_cli.graph_search.near_paths import near_paths
from trajopt_cli.graph_search.search import search
from trajopt_cli.job import read_job
from trajopt_cli.pipeline.planning import may_change
from trajopt_cli.plan.initial_plan import InitialPlan, PlanCache, PlanRequest, find_initial_plan, initial_plan_of
from trajopt_cli.problem.decision_scope import EVERYTHING, FIXED_RAIL
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.problem import Coupling, Problem
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.settings import Settings
from trajopt_cli.trajectories.axes import Axes

PLACES = ((454.0, 334.2, 362.4, "[0,0.3264018,0.9452311,0]"), (466.0, 1557.5, 378.0, "[0,0.0101868,0.9999481,0]"))
CELL = """robot: irb140_rail
profile: default
rail: {eax: a, stroke: [-0.2, 2.2]}
limits: {rail: {velocity: 1.0, acceleration: 3.0, source: "test"}}
tcp: {speed: 2.5, acceleration: 20, source: "test"}
start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}
"""


def two_places(folder: Path) -> PlanRequest:
    """Down and up again at each of two places, with a wait in which the rail stands, and home."""
    lines = ["MODULE Cell", "CONST jointtarget home:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];", "PROC main()"]
    for x, y, z, turned in PLACES:
        up, p = (f"[[{x},{y},{z + h}],{turned},[0,0,0,0],[{y},9E9,9E9,9E9,9E9,9E9]]" for h in (115, 0))
        lines += [f"MoveJ {up}, v2500, fine, tool0;", f"MoveL {p}, v200, fine, tool0;", "WaitTime 0.8;"]
        lines += [f"MoveL {up}, v200, fine, tool0;"]
    (folder / "cell.mod").write_text("\n".join([*lines, "MoveAbsJ home, v2500, fine, tool0;", "ENDPROC", "ENDMODULE"]))
    (folder / "cell.yaml").write_text(CELL)
    job = read_job(folder / "cell.mod")
    return PlanRequest(
        job.program, job.plant, Target.RAPID, EVERYTHING, may_change(job, Loops.KEEP).changes[Target.RAPID]
    )


@pytest.mark.parametrize("seed", range(4))
def test_near_paths_are_the_best_through_every_label(seed: int) -> None:
    """Against all paths of a small graph, one by one: what is told is a path and costs what it says; through every
    label of every waypoint leads one that costs as little as any, if that is within the limit."""
    rng = np.random.default_rng(seed)
    places = [np.array([[0], [0]]), *(np.stack(np.divmod(np.arange(12), 4)) for _ in range(3)), np.array([[0], [0]])]
    tables = [rng.uniform(1, 9, (a.shape[1], b.shape[1])) for a, b in pairwise(places)]

    def cost(path: tuple[int, ...]) -> float:
        return float(sum(T[i, j] for T, (i, j) in zip(tables, pairwise(path), strict=True)))

    every = {path: cost(path) for path in product(*(range(place.shape[1]) for place in places))}
    best = min(every, key=lambda path: every[path])
    forward, behind = [np.zeros(1)], [np.zeros(1)]
    for T, back in zip(tables, tables[::-1], strict=True):
        forward.append((forward[-1][:, None] + T).min(axis=0))
        behind.append((back + behind[-1]).min(axis=1))
    through = [a + b for a, b in zip(forward, behind[::-1], strict=True)]
    limit = 1.8 * every[best]
    found = near_paths(places, [Dense(T) for T in tables], forward, through, best, limit)
    assert found == sorted(found)
    assert len({tuple(path) for _, path in found} - {best}) == len(found) > 2
    for T, path in found:
        np.testing.assert_allclose(T, every[tuple(path)], rtol=1e-12)
        assert limit >= T >= every[best]
    for k, place in enumerate(places):
        for label in set(place[0]):
            least = min(T for path, T in every.items() if place[0, path[k]] == label)
            told = [T for T, path in [(every[best], list(best)), *found] if place[0, path[k]] == label]
            assert least > limit or min(told) == pytest.approx(least, rel=1e-12)


def test_of_several_routes_the_one_that_is_driven_fastest_is_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The search's second best route, another branch at a place, takes 7 ms less once it is timed."""
    asked = two_places(tmp_path)
    problems = [one for one in asked.unchecked() if isinstance(one, Problem)]

    def legal() -> InitialPlan:
        found = initial_plan_of(Axes.of(asked.plant), problems, Patience(), lambda _: None, {})
        assert isinstance(found, InitialPlan)
        return found

    several = legal()
    monkeypatch.setattr("trajopt_cli.graph_search.search._OTHER_PARTS", 0)
    alone = legal()
    assert several.duration < alone.duration - 5e-3
    assert [one.cfx for one in several.route.labels] != [one.cfx for one in alone.route.labels]


def test_other_parts_stand_where_the_program_has_them(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Searched in windows, each part is at its own waypoints: the flange is where these have it."""
    asked = two_places(tmp_path)
    problem, axes = asked.unchecked()[0], Axes.of(asked.plant)
    assert isinstance(problem, Problem)
    set_defaults(monkeypatch, searched_legs=5, overlapping_legs=4, near_best=1.2)
    route = search(axes, replace(problem, coupling=Coupling.COORDINATED))
    assert route is not None
    assert max(part.first for part in route.others) == problem.stations[2][0]  # not in the first window
    for part in route.others:
        for k, q in enumerate(part.q, part.first):
            np.testing.assert_allclose(axes.forward(q), problem.waypoints[k].X_WF, atol=1e-9)


def test_a_rail_that_may_move_less_is_driven_only_where_that_may_be_faster(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Standing through every station takes 4 % longer by the search: left out, and slower where it is driven."""
    asked, station = two_places(tmp_path), (Target.RAPID, FIXED_RAIL)

    def found(memory: PlanCache) -> InitialPlan:
        best = find_initial_plan(Axes.of(asked.plant), asked, memory, Patience(), lambda _: None, {})
        assert isinstance(best, InitialPlan)
        return best

    short, every = PlanCache(), PlanCache()
    best = found(short)
    assert short.estimates[station] > 1.03 * short.estimates[Target.RAPID, EVERYTHING]
    assert station not in short.answers
    monkeypatch.setattr(Settings, "worth", 0.05)
    assert found(every).duration == best.duration
    driven = every.answers[station]
    assert isinstance(driven, InitialPlan)
    assert driven.duration > best.duration
