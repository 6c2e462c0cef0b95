"""Windows change a motion only for the better: how they lie, what they hold, and what becomes of the whole."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from small_cells import plant_with_rail, problem_of, rapid
from unrefined import coarse_search, set_defaults

from trajopt_cli.motion import Program
from trajopt_cli.nlp.formulation import Formulation
from trajopt_cli.nlp.mesh_refinement import LONG, MeshRefinement, NotConverged, Stage, on_grid
from trajopt_cli.path_timing.path_parameterized_plan import duration
from trajopt_cli.plan import local_refinement
from trajopt_cli.plan.initial_plan import InitialPlan, initial_plan_of
from trajopt_cli.plan.local_refinement import SweepReport, WindowSweeps, refine
from trajopt_cli.plan.subproblems import Span, Window, pieces, red_black
from trajopt_cli.problem.problem import Problem
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.iterate import Iterate

pytestmark = pytest.mark.usefixtures("coarse")

STATION = """MoveJ Offs(p_in,0,{y},0), v2500, fine, tool0;
MoveL Offs(p_low,0,{y},0), v500, fine, tool0;
MoveL Offs(p_in,0,{y},0), v500, fine, tool0;
"""


def program(*places: float, home: str = "") -> Program:
    """Stations at places [mm] beyond the first along the rail, home between them if it is given, and at the end."""
    return rapid(home.join(STATION.format(y=y) for y in places) + "MoveAbsJ j_home, v2500, fine, tool0;")


AXES = Axes.of(plant_with_rail((-0.16, 0.8)))


@cache
def base(*places: float, home: str = "") -> InitialPlan:
    problem = problem_of(program(*places, home=home), plant_with_rail((-0.16, 0.8)))
    with pytest.MonkeyPatch.context() as patch:
        coarse_search(patch)
        found = initial_plan_of(AXES, [problem], Patience(), lambda _: None, {})
    assert isinstance(found, InitialPlan)
    return found


@cache
def whole() -> Iterate:
    """One window over two stations."""
    _, iterate, notes = refine(AXES, base(0, 300), Patience(), lambda _: None, {})
    assert notes == ()
    return iterate


def stand_in(monkeypatch: pytest.MonkeyPatch, solve: Callable[[Problem, Iterate], Iterate]) -> list[int]:
    """Mesh refinements that do as solve says; how many legs each was asked for."""
    asked: list[int] = []

    def finished(self: MeshRefinement, stage: Stage) -> Iterate:
        asked.append(len(self.problem.legs))
        return solve(self.problem, stage.iterate)

    monkeypatch.setattr(MeshRefinement, "begun", lambda _, iterate: Stage(iterate, [], []))
    monkeypatch.setattr(MeshRefinement, "rough", lambda _, stage: stage)
    monkeypatch.setattr(MeshRefinement, "finished", finished)
    return asked


def quicker(problem: Problem, iterate: Iterate) -> Iterate:
    """No motion at all: the legs a little shorter than what the start takes, down to 0.1 s each."""
    legs = [replace(motion, T=max(0.1, 0.9 * motion.T)) for motion in iterate.legs if motion is not None]
    return replace(iterate, legs=tuple(legs))


def swept(legal: InitialPlan, tally: SweepReport | None = None) -> Iterate:
    return WindowSweeps(AXES, LONG, Patience(), {}).run(
        legal.problem, legal.iterate, tally or SweepReport(), lambda _: None
    )


@pytest.mark.parametrize("most", [4, 5, 14])
def test_windows_cover_the_whole_and_one_anothers_borders(most: int, monkeypatch: pytest.MonkeyPatch) -> None:
    set_defaults(monkeypatch, window_legs=most)
    problem = problem_of(program(0, 300, 600, 0), plant_with_rail())
    even, odd = red_black(problem)
    assert [first for first, _ in even] + [13] == [0] + [last for _, last in even]
    assert max(last - first for first, last in even) <= most
    if most == 14:
        assert (even, odd) == ([(0, 13)], [])
        return
    for border in (last for _, last in even[:-1]):
        (over,) = [(first, last) for first, last in odd if first < border < last]
        assert over[1] - over[0] <= most + 2
    assert all(a[1] <= b[0] for a, b in pairwise(odd))


def test_no_window_leaves_its_piece(monkeypatch: pytest.MonkeyPatch) -> None:
    set_defaults(monkeypatch, window_legs=2)
    problem = problem_of(program(0, 300, home="MoveAbsJ j_home, v2500, fine, tool0;\n"), plant_with_rail())
    assert pieces(problem) == [(0, 4), (4, 8)]
    assert all(last <= 4 or first >= 4 for spans in red_black(problem) for first, last in spans)


def test_a_window_is_held_where_and_as_fast_as_the_motion_passes_its_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    """Solved for real: a window in the middle of a motion in which the rail runs through the stops."""
    legal, iterate = base(0, 300), whole()
    window = Window.of(legal.problem, iterate, (2, 5))
    assert np.abs(iterate.qd[[2, 5], 0]).min() > 0.05
    start = on_grid(AXES, window.problem, window.iterate)
    found = MeshRefinement(AXES, Formulation(AXES), window.problem, Patience()).run(start)
    np.testing.assert_array_equal(found.q[[0, -1]], iterate.q[[2, 5]])
    np.testing.assert_array_equal(found.qd[[0, -1]], iterate.qd[[2, 5]])
    assert duration(found) == pytest.approx(duration(window.iterate), rel=1e-3)  # nothing is to be gained there
    for motion, q, qd in zip(found.legs, pairwise(found.q), pairwise(found.qd), strict=True):
        assert motion is not None
        ends = motion.sample(AXES, np.array([1e-9, motion.T - 1e-9]))
        np.testing.assert_allclose(ends.q, q, rtol=0, atol=1e-6)
        np.testing.assert_allclose(ends.qd, qd, rtol=0, atol=1e-5)


def test_a_window_that_fails_changes_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    def solve(problem: Problem, iterate: Iterate) -> Iterate:
        if problem.legs[0].motion >= 3:
            raise NotConverged("no")
        return quicker(problem, iterate)

    set_defaults(monkeypatch, window_legs=4)
    stand_in(monkeypatch, solve)
    legal = base(0, 300, 600)
    even, _ = red_black(legal.problem)
    assert even == [(0, 3), (3, 6), (6, 10)]
    tally = SweepReport()
    found = swept(legal, tally)
    assert duration(found) < legal.duration
    assert all(a is b for a, b in zip(found.legs[6:], legal.iterate.legs[6:], strict=True))
    np.testing.assert_array_equal(found.q, legal.iterate.q)
    assert (0, 3) in tally.tried
    failed = sum(first >= 3 for first, _ in tally.tried)
    assert list(tally.notes(True, Patience())) == [
        f"{failed} of {len(tally.tried)} windows failed to converge: their parts stay as found without them"
    ]


def test_a_window_that_is_slower_changes_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    def slower(_: Problem, iterate: Iterate) -> Iterate:
        return replace(iterate, legs=tuple(replace(motion, T=3.0) for motion in iterate.legs if motion is not None))

    stand_in(monkeypatch, slower)
    legal = base(0, 300)
    tally = SweepReport()
    assert swept(legal, tally) is legal.iterate
    assert list(tally.notes(False, Patience())) == [
        "each leg has one progress for all axes, as a RAPID controller drives it: nothing faster was found"
    ]


@pytest.mark.parametrize(("few", "ratios"), [(48, [0.8, 0.9]), (48, [0.9, 0.8]), (3, [0.9, 0.8])])
def test_the_start_that_leads_farthest_goes_on_and_the_first_that_gains_where_legs_are_many(
    few: int, ratios: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    legal = base(0)
    left = iter([*ratios, 1.0])

    def begun(_: MeshRefinement, iterate: Iterate) -> Stage:
        by = next(left) / 10
        legs = tuple(replace(motion, T=by) for motion in iterate.legs if motion is not None)
        return Stage(replace(iterate, legs=legs), [], [])

    set_defaults(monkeypatch, few_legs=few)
    stand_in(monkeypatch, lambda _, iterate: iterate)
    monkeypatch.setattr(MeshRefinement, "begun", begun)
    found = [motion.T for motion in swept(legal).legs if motion]
    assert set(found) == {(min(ratios) if few > len(found) else ratios[0]) / 10}


@pytest.mark.parametrize(("ratios", "looked_at"), [([0.8, 0.9], 2), ([0.9, 0.8, 0.8, 0.9], 2), ([0.9, 0.9], 1)])
def test_a_start_that_leads_where_another_did_is_left(
    ratios: list[float], looked_at: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    legal, left, looks = base(0), iter(ratios), list[Stage]()
    window = Window.of(legal.problem, legal.iterate, (0, len(legal.problem.legs)))

    def begun(_: MeshRefinement, iterate: Iterate) -> Stage:
        by = next(left)
        legs = tuple(replace(motion, T=by) for motion in iterate.legs if motion is not None)
        return Stage(replace(iterate, legs=legs), [], [])

    stand_in(monkeypatch, quicker)
    monkeypatch.setattr(MeshRefinement, "begun", begun)
    monkeypatch.setattr(MeshRefinement, "rough", lambda _, stage: looks.append(stage) or stage)
    sweeps = WindowSweeps(AXES, LONG, Patience(), {})
    found = sweeps._first_answers(window.problem, [window.iterate] * len(ratios), few=True, seconds={})
    assert len(found) == len(looks) == looked_at


@pytest.mark.parametrize("few", [48, 3])
def test_a_rail_in_motion_at_stops_is_searched_where_legs_are_few(few: int, monkeypatch: pytest.MonkeyPatch) -> None:
    set_defaults(monkeypatch, few_legs=few)
    asked: list[Problem] = []
    stand_in(monkeypatch, quicker)
    monkeypatch.setattr(local_refinement, "search", lambda _, problem: asked.append(problem))
    legal = base(0)
    axes = replace(AXES, plant=replace(AXES.plant, settings=replace(AXES.plant.settings, few_legs=few)))
    refine(axes, legal, Patience(), lambda _: None, {})
    assert len(asked) == (few > len(legal.problem.legs))


def test_equal_windows_are_solved_once(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = stand_in(monkeypatch, quicker)
    legal = base(0, 0, home="MoveAbsJ j_home, v2500, fine, tool0;\n")
    assert len(pieces(legal.problem)) == 2
    found = swept(legal)
    assert asked == [4]
    assert [motion.T for motion in found.legs[:4] if motion] == [motion.T for motion in found.legs[4:] if motion]


def test_the_order_of_windows_side_by_side_does_not_matter(monkeypatch: pytest.MonkeyPatch) -> None:
    set_defaults(monkeypatch, window_legs=4)
    stand_in(monkeypatch, quicker)
    legal = base(0, 300, 600)
    forth = swept(legal)

    def backwards(problem: Problem) -> tuple[list[Span], list[Span]]:
        even, odd = red_black(problem)
        return even[::-1], odd[::-1]

    monkeypatch.setattr(local_refinement, "red_black", backwards)
    back = swept(legal)
    assert [motion.T for motion in forth.legs if motion] == [motion.T for motion in back.legs if motion]


def test_sweeps_end(monkeypatch: pytest.MonkeyPatch) -> None:
    """A window is solved again only where one over its borders gained something since."""
    set_defaults(monkeypatch, window_legs=4)
    gains = iter([0.9, 0.9, 0.9, 0.9, 0.9] + [1.0] * 50)

    def solve(problem: Problem, iterate: Iterate) -> Iterate:
        share = next(gains)
        return replace(iterate, legs=tuple(replace(motion, T=share * motion.T) for motion in iterate.legs if motion))

    asked = stand_in(monkeypatch, solve)
    legal = base(0, 300, 600)
    swept(legal)
    even, odd = red_black(legal.problem)
    assert len(even) + len(odd) == 5
    assert 5 < len(asked) <= 10  # the even ones again, which gain nothing, and so the odd ones are not


@pytest.mark.long
def test_any_number_of_processes_finds_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    set_defaults(monkeypatch, window_legs=4)
    stand_in(monkeypatch, quicker)
    legal, found = base(0, 300, 600), []
    for max_workers in (1, 3):
        told: list[float] = []
        sweeps = WindowSweeps(AXES, LONG, Patience(), {}, lambda max_workers=max_workers: max_workers)
        found.append(sweeps.run(legal.problem, legal.iterate, SweepReport(), told.append))
        assert told[-1] == pytest.approx(duration(found[-1]))
    assert [motion.T for motion in found[0].legs if motion] == [motion.T for motion in found[1].legs if motion]
