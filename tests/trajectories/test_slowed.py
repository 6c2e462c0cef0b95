"""A motion made slower goes where it went; what a window holds and what the program times stays as it is."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from small_cells import plant_with_rail, problem_of, rapid

from trajopt_cli.graph_search.search import search
from trajopt_cli.nlp.mesh_refinement import slowed
from trajopt_cli.path_timing.path_parameterized_plan import timed
from trajopt_cli.problem.problem import Problem
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.iterate import Iterate
from trajopt_cli.trajectories.leg_trajectories import JointNodes, JointProfiles, PathLeg, Pieces

MOVES = "MoveAbsJ j_home,v1000,fine,tool0;MoveJ p_in,v1000,fine,tool0;MoveL p_low,v200,fine,tool0;WaitTime 0.4;"


@pytest.fixture(scope="module")
def legal() -> tuple[Axes, Problem, Iterate]:
    plant = plant_with_rail()
    axes, problem = Axes.of(plant), problem_of(rapid(MOVES), plant)
    route = search(axes, problem)
    assert route is not None
    return axes, problem, timed(axes, problem, route)


def test_the_same_places_at_times_as_many_times_later(legal: tuple[Axes, Problem, Iterate]) -> None:
    axes, problem, iterate = legal
    moving = [k for k, leg in enumerate(problem.legs) if leg.duration is None]
    for k in moving:
        motion, slow = iterate.legs[k], slowed(problem, iterate, 1.25).legs[k]
        assert motion is not None
        assert slow is not None
        t = np.linspace(0, motion.T, 17)[1:-1] + 1e-5  # beside the switches
        was, now = motion.sample(axes, t), slow.sample(axes, 1.25 * t)
        np.testing.assert_allclose(now.q, was.q, atol=1e-9)
        np.testing.assert_allclose(now.qd, was.qd / 1.25, atol=1e-9)
        np.testing.assert_allclose(now.qdd, was.qdd / 1.25**2, atol=1e-7)


def test_a_motion_of_several_pieces_is_slowed_with_them(legal: tuple[Axes, Problem, Iterate]) -> None:
    """As beside corners: all of a plan goes slower, or speeds would jump there."""
    _, problem, iterate = legal
    k = next(k for k, leg in enumerate(problem.legs) if leg.duration is None)
    motion = iterate.legs[k]
    assert isinstance(motion, PathLeg | JointNodes | JointProfiles)
    parts = Pieces((motion, motion))
    slow = slowed(problem, replace(iterate, legs=(*iterate.legs[:k], parts, *iterate.legs[k + 1 :])), 1.25).legs[k]
    assert slow is not None
    assert pytest.approx(2.5 * motion.T) == slow.T


def test_a_wait_keeps_its_time(legal: tuple[Axes, Problem, Iterate]) -> None:
    _, problem, iterate = legal
    wait = slowed(problem, iterate, 2.0).legs[-1]
    assert wait is not None
    assert wait.T == 0.4


def test_ends_that_a_window_holds_in_motion_keep_their_velocity(legal: tuple[Axes, Problem, Iterate]) -> None:
    _, problem, iterate = legal
    qd = np.full_like(iterate.qd, 0.01)
    points = [
        replace(one, q=iterate.q[k]) if k == 0 else replace(one, q=None) for k, one in enumerate(problem.waypoints)
    ]
    slow = slowed(replace(problem, waypoints=tuple(points)), replace(iterate, qd=qd), 2.0)
    np.testing.assert_array_equal(slow.qd[0], qd[0])
    np.testing.assert_array_equal(slow.qd[1:], qd[1:] / 2)
