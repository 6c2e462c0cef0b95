"""How far the rail goes in a wait: by the closed form of the rail alone, by path timing where the arm holds it back."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from small_cells import down, plant_with_rail, problem_of, rapid

from trajopt_cli.graph_search.rail_in_waits import farthest
from trajopt_cli.path_timing.edge_times import Pairs, Times, leg_times
from trajopt_cli.problem.problem import LegKind
from trajopt_cli.trajectories.axes import Axes

WAIT = "MoveJ p_low, v2500, fine, tool0;\nWaitTime %s;\nMoveAbsJ j_home, v2500, fine, tool0;"
D = np.linspace(-0.2, 1.4, 161)


def at(wait: float, arm: np.ndarray) -> tuple:  # the problem, its axes, the number of its wait, joints along the rail
    plant = plant_with_rail()
    scale = np.r_[1.0, arm]
    limits = plant.limits
    plant = replace(
        plant, limits=replace(limits, velocity=limits.velocity * scale, acceleration=limits.acceleration * scale)
    )
    axes, problem = Axes.of(plant), problem_of(rapid(WAIT % wait), plant)
    (k,) = [k for k, leg in enumerate(problem.legs) if leg.kind is LegKind.DWELL]
    X_WF = np.tile(down(0.5, 0.6, 0.39), (len(D), 1, 1))
    solutions = axes.inverse(X_WF, D)
    cfx = int(np.argmax(np.isfinite(solutions).all(axis=-1).sum(axis=0)))
    here = np.isfinite(solutions[:, cfx]).all(axis=1)
    solutions[here, cfx] = np.unwrap(solutions[here, cfx], axis=0)
    return problem, axes, k, solutions[:, cfx], cfx


@pytest.mark.parametrize("wait", [0.205, 0.505, 1.203])
def test_a_fast_arm_leaves_it_to_the_rail(wait: float) -> None:
    """From rest to rest a rail of 1 m/s and 3 m/s2 goes 3 T^2 / 4, or T - 1/3 from 2/3 s on."""
    problem, axes, k, arm, _ = at(wait, np.full(6, 1e3))
    most = 3 * wait**2 / 4 if wait < 2 / 3 else wait - 1 / 3
    here = np.flatnonzero(np.isfinite(arm).all(axis=1))
    found = farthest(axes, problem.legs[k], D, arm[None])[0]
    np.testing.assert_array_equal(found[here], np.minimum(here + int(most / 0.01), here[-1]))


@pytest.mark.parametrize("slow", range(5))
def test_a_slow_joint_holds_the_rail_back_as_path_timing_says(slow: int) -> None:
    """Joints that go there and back, too. Red where only what lies between both ends counts."""
    problem, axes, k, arm, cfx = at(1.0, np.where(np.arange(6) == slow, 0.1, 1.0))
    here = np.flatnonzero(np.isfinite(arm).all(axis=1))[5:-5]
    far = farthest(axes, problem.legs[k], D, arm[None])[0]
    q = np.column_stack([D, arm])
    some = here[::7]
    for more, least, most in ((0, 0.0, 1.02), (1, 0.95, np.inf)):
        pick = some[(far[some] + more <= here[-1]) & (far[some] > some)]
        free = replace(problem.legs[k], duration=None)
        asked = replace(problem, legs=(*problem.legs[:k], free, *problem.legs[k + 1 :]))
        (times,) = leg_times(axes, asked, [Pairs(k, q[pick], q[far[pick] + more], cfx)], Times())
        assert len(pick)
        assert (times >= least).all(), times
        assert (times <= most).all(), times
