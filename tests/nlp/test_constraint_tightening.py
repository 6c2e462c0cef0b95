"""The dense check sees what stands between the nodes, wherever it stands."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest
from small_cells import HOME, plant_with_rail, problem_of, rapid

from trajopt_cli.geometry import Array
from trajopt_cli.nlp.constraint_tightening import back_off
from trajopt_cli.path.line import Line
from trajopt_cli.settings import DEFAULT
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.dense_check import Ratios, check_leg
from trajopt_cli.trajectories.iterate import Margins
from trajopt_cli.trajectories.leg_trajectories import PathLeg, Sample, parabola

PROGRAM = "MoveJ p_in, v2500, fine, tool0; WaitTime 0.8; MoveAbsJ j_home, v2500, fine, tool0;"


@dataclass
class Spike:
    """Stands still but for joint 3's acceleration around one share of its only interval; unreached there if asked."""

    at: float
    width: float
    value: float
    T: float = 1.0

    def breaks(self) -> Array:
        return np.array([0.0, self.T])

    def sample(self, axes: Axes, t: Array, right: bool = True) -> Sample:
        q = np.tile(np.r_[0.0, HOME], (len(t), 1))
        qdd = np.zeros_like(q)
        qdd[np.abs(t - self.at) < self.width / 2, 3] = self.value
        return Sample(t, q, np.zeros_like(q), qdd)


@pytest.mark.parametrize("at", np.linspace(0.0, 1.0, 23))
def test_an_excess_as_wide_as_a_fortieth_of_an_interval_is_seen_anywhere(at: float) -> None:
    axes = Axes.of(plant_with_rail())
    leg = problem_of(rapid(PROGRAM), plant_with_rail()).legs[1]
    ratios = check_leg(axes, leg, Spike(at, 0.0251, 2 * axes.acceleration[3]))  # type: ignore[arg-type]
    assert ratios.worst == pytest.approx(2.0)


def test_joints_that_do_not_exist_are_an_excess_too() -> None:
    axes = Axes.of(plant_with_rail())
    leg = problem_of(rapid(PROGRAM), plant_with_rail()).legs[1]
    assert check_leg(axes, leg, Spike(0.5, 0.1, np.nan)).worst > 1.5  # type: ignore[arg-type]


def test_in_a_dwell_the_push_of_the_passing_interval_alone_is_scaled() -> None:
    axes = Axes.of(plant_with_rail())
    problem = problem_of(rapid(PROGRAM), plant_with_rail())
    X = problem.waypoints[1].X_WF
    grid = np.linspace(0, 1, 7)
    s, v, a = parabola(grid)
    leg = PathLeg(
        0.8, Line(X, X), np.eye(4), 0, HOME, grid, s, v, a, *(x[:, None] for x in (0.5 + 0.4 * s, 0.4 * v, 0.4 * a))
    )
    ratios = check_leg(axes, problem.legs[1], leg)
    ratios.acceleration[:] = 0.5
    ratios.acceleration[2, 4] = 1.25
    margins = Margins.full(axes, 6, on_path=True)
    assert back_off(margins, ratios, leg, DEFAULT, rail=np.array([3.0]))
    own = abs(leg.b[2, 0]) / (3.0 * 0.8**2)
    assert margins.push[2] == pytest.approx(own * (1 - 1.5 * (1 - 1 / 1.25)), rel=3e-4)
    assert np.all(np.delete(margins.push, 2) == 1.0)
    assert np.all(margins.acceleration == DEFAULT.start)
    assert back_off(Margins.full(axes, 6, on_path=True), ratios, leg, DEFAULT)  # elsewhere the nodes are


def test_one_round_leaves_half_of_a_limit_however_much_it_is_passed() -> None:
    axes = Axes.of(plant_with_rail())
    spike = Spike(0.5, 0.2, 1e6)
    problem = problem_of(rapid(PROGRAM), plant_with_rail())
    margins = Margins.full(axes, 1, on_path=True)
    s, v, a = parabola(np.linspace(0, 1, 2))
    d = np.zeros((2, 1))
    X = np.eye(4)
    path = PathLeg(1.0, Line(X, X), X, 0, HOME, np.linspace(0, 1, 2), s, v, a, d, d, d[1:])
    assert back_off(margins, check_leg(axes, problem.legs[0], spike), path, DEFAULT)
    assert margins.acceleration[:, 3].tolist() == [0.5 * DEFAULT.start, 0.5 * DEFAULT.start]


def test_a_range_is_not_passed_by_rounding() -> None:
    axes = Axes.of(plant_with_rail())
    d = np.zeros((2, 1))
    X, rest = np.eye(4), np.zeros(2)
    path = PathLeg(1.0, Line(X, X), X, 0, HOME, np.linspace(0, 1, 2), rest, rest, d[0], d, d, d[1:])
    margins, ratios = Margins.full(axes, 1, on_path=True), Ratios.none(axes, 1)
    ratios.position[:] = 1.0 + 2.3e-16
    assert not back_off(margins, ratios, path, DEFAULT)
    ratios.position[:] = 1.0 + 1e-6
    assert back_off(margins, ratios, path, DEFAULT)
