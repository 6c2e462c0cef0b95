"""Ties in the search, against trying all states."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise, product

import numpy as np
import pytest
from small_cells import plant_with_rail, rapid
from unrefined import coarse_search

from trajopt_cli.geometry import Array
from trajopt_cli.graph_search.shared_states import Ties, best_tied
from trajopt_cli.plan import optimize
from trajopt_cli.problem.editable import Changes
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.settings import DEFAULT

# A loop of three passes; a loop with a way in and out; two routines called in turns; one target twice in a row;
# targets met in changing orders, which leave nodes with three neighbours.
LOOPS: list[tuple[int, Ties]] = [
    (7, ((0, 2, 4), (1, 3, 5))),
    (8, ((1, 3, 5), (2, 4, 6))),
    (8, ((0, 4), (1, 5), (2, 6), (3, 7))),
    (6, ((1, 2, 4),)),
    (9, ((0, 5), (1, 4, 7), (2, 6, 8))),
    (8, ((0, 4), (1, 6), (2, 5), (3, 7))),
]


def route(rng: np.random.Generator, count: int, ties: Ties) -> tuple[list[Array], list[Array], list[Array]]:
    """States, leg times (some infinite), and the least cost through each state. Tied waypoints have states in
    common, in different orders, and others besides."""
    states = [rng.uniform(-1, 1, (3, 7)) for _ in range(count)]
    for first, *others in ties:
        for k in others:
            states[k] = rng.permutation(np.concatenate([states[first], rng.uniform(-1, 1, (1, 7))]))
    edges = [rng.uniform(0, 1, (len(a), len(b))) for a, b in pairwise(states)]
    for T in edges:
        T[rng.random(T.shape) < 0.1] = np.inf
    forward, backward = [np.zeros(len(states[0]))], [np.zeros(len(states[-1]))]
    for T in edges:
        forward.append(np.min(forward[-1][:, None] + T, axis=0))
    for T in reversed(edges):
        backward.insert(0, np.min(T + backward[0], axis=1))
    return states, edges, [a + b for a, b in zip(forward, backward, strict=True)]


def cost_of(edges: list[Array], path: tuple[int, ...]) -> float:
    return float(sum(T[i, j] for T, i, j in zip(edges, path, path[1:], strict=False)))


def kept(states: list[Array], path: tuple[int, ...], ties: Ties) -> bool:
    return all(np.allclose(states[k][path[k]], states[group[0]][path[group[0]]]) for group in ties for k in group)


def every_path(states: list[Array], ties: Ties) -> Iterator[tuple[int, ...]]:
    """All that keep the ties: a state of the first waypoint of a group says those of the others."""
    first = {k: group[0] for group in ties for k in group}
    free = [k for k in range(len(states)) if first.get(k, k) == k]
    for chosen in product(*(range(len(states[k])) for k in free)):
        known = dict(zip(free, chosen, strict=True))
        path = []
        for k, q in enumerate(states):
            wanted = states[first.get(k, k)][known[first.get(k, k)]]
            same = np.flatnonzero(np.abs(q - wanted).max(axis=1) < 1e-9)
            if not len(same):
                break
            path.append(int(same[0]))
        else:
            yield tuple(path)


@pytest.mark.parametrize(("count", "ties"), LOOPS)
def test_the_best_route_that_keeps_the_ties_is_found(count: int, ties: Ties) -> None:
    rng = np.random.default_rng(count)
    for _ in range(5):
        states, edges, through = route(rng, count, ties)
        best = min(cost_of(edges, path) for path in every_path(states, ties))
        cost, path = best_tied(states, edges, through, ties, DEFAULT.tie_candidates)
        assert cost == pytest.approx(best, abs=1e-12)
        if np.isfinite(best):
            assert kept(states, tuple(path), ties)
            assert cost_of(edges, tuple(path)) == pytest.approx(best, abs=1e-12)


def test_ties_without_a_state_in_common_have_no_route() -> None:
    states = [np.full((2, 7), float(k)) for k in range(3)]
    edges, through = [np.zeros((2, 2))] * 2, [np.zeros(2)] * 3
    assert best_tied(states, edges, through, ((0, 2),), DEFAULT.tie_candidates) == (np.inf, [])


NEAR = """CONST robtarget p_up:=[[500,600,450],[0,0,1,0],[0,0,0,0],[460,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget p_down:=[[500,600,390],[0,0,1,0],[0,0,0,0],[460,9E9,9E9,9E9,9E9,9E9]];"""
TWICE = """FOR i FROM 1 TO 2 DO
MoveJ p_up, v2500, fine, tool0;
MoveL p_down, v500, fine, tool0;
MoveJ Offs(p_up,0,700*(2-i),0), v2500, fine, tool0;
ENDFOR
MoveAbsJ j_home, v1000, fine, tool0;"""


@pytest.mark.long
def test_tied_waypoints_get_one_rail_position_and_one_configuration() -> None:
    """To the last bit, as they are written with one number; untied they are elsewhere in either pass, and the tied
    plan is slower, but no slower than with both held at 460 mm, and no faster than the bound of the untied."""
    program, plant = rapid(TWICE, data=NEAR), plant_with_rail()
    every = frozenset(range(len(program.motions)))
    one = optimize(program, plant, Target.RAPID, changes=Changes(every, ((0, 3), (1, 4))))
    other = optimize(program, plant, Target.RAPID, changes=Changes(every))
    held = optimize(program, plant, Target.RAPID, changes=Changes(every - {0, 1, 3, 4}), bounded=False)
    assert isinstance(one, Plan)
    assert isinstance(other, Plan)
    assert isinstance(held, Plan)
    for first, second in ((0, 3), (1, 4)):
        np.testing.assert_array_equal(one.motions[first].q_1, one.motions[second].q_1)
        assert abs(other.motions[first].q_1[0] - other.motions[second].q_1[0]) > 0.05
    assert other.duration < one.duration <= held.duration
    assert other.lower_bound is not None
    assert other.lower_bound == one.lower_bound <= other.duration


def test_a_tie_that_cannot_be_kept_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    coarse_search(monkeypatch)
    monkeypatch.setattr("trajopt_cli.graph_search.search.best_tied", lambda *_: (np.inf, []))
    program = rapid(TWICE, data=NEAR)
    answer = optimize(program, plant_with_rail(), Target.RAPID, changes=Changes(frozenset(range(7)), ((0, 3), (1, 4))))
    assert isinstance(answer, Infeasible)
    assert str(answer).endswith("in one configuration for all passes; --loops unroll asks for less")


def test_beyond_three_neighbours_candidates_are_tried_one_by_one() -> None:
    """With none to try but the first guess the answer is no better, and sometimes worse."""
    count, ties = LOOPS[5]
    worse = 0
    for seed in range(10):
        given = route(np.random.default_rng(seed), count, ties)
        cost = best_tied(*given, ties, DEFAULT.tie_candidates)[0]
        guess = best_tied(*given, ties, 0)[0]
        assert cost <= guess
        worse += cost < guess
    assert worse
