"""The rail's place among the axes is one decision: a robot whose rail is its last axis gets the same plan."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import casadi as ca
import numpy as np
import pytest
from small_cells import HOME, plant_with_rail, problem_of, rapid

from trajopt_cli.bound.lower_bound import lower_bound
from trajopt_cli.geometry import Array
from trajopt_cli.limits import JointLimits
from trajopt_cli.nlp.block_cache import Maps, library
from trajopt_cli.plan.initial_plan import InitialPlan, initial_plan_of
from trajopt_cli.plan.local_refinement import refine
from trajopt_cli.plan.output_rows import rows_of
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.problem import Problem
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.robot.layout import AxisLayout
from trajopt_cli.robot.model import RobotModel
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectory import Trajectory

pytestmark = pytest.mark.usefixtures("coarse", "few_places")

FIRST = np.array([6, 0, 1, 2, 3, 4, 5])  # the rail-first vector is q[..., FIRST] of the rail-last one
LAST = np.array([1, 2, 3, 4, 5, 6, 0])


@dataclass(frozen=True)
class RailLast:
    """A shipped robot with its axes in another order. What does not speak of axes is the robot's own."""

    robot: RobotModel

    def __getattr__(self, name: str) -> object:
        return getattr(self.robot, name)

    @property
    def axis_names(self) -> tuple[str, ...]:
        return tuple(self.robot.axis_names[i] for i in LAST)

    @property
    def layout(self) -> AxisLayout:
        return AxisLayout(rail=slice(6, 7), arm=slice(0, 6))

    def forward(self, q: Array) -> Array:
        return self.robot.forward(q[..., FIRST])

    def jacobian(self, q: Array, X_FT: Array | None = None) -> Array:
        return self.robot.jacobian(q[..., FIRST], X_FT)[..., LAST]

    def differential(self, q: Array, X_FT: Array | None = None) -> object:
        inner = self.robot.differential(q[..., FIRST], X_FT)

        class Differential:
            def pose(self) -> Array:
                return inner.pose()

            def jacobian(self) -> Array:
                return inner.jacobian()[..., LAST]

            def velocity(self, qd: Array) -> Array:
                return inner.velocity(qd[..., FIRST])

            def bias(self, qd: Array) -> Array:
                return inner.bias(qd[..., FIRST])

            def motion(self, qd: Array, qdd: Array) -> Array:
                return inner.motion(qd[..., FIRST], qdd[..., FIRST])

            def follow(self, *motion: Array) -> tuple[Array, Array]:
                qd, qdd = inner.follow(*motion)
                return qd[..., LAST], qdd[..., LAST]

        return Differential()

    def enclose(self, X_WF: Array, rail: Array, limits: JointLimits, twist: Array | None = None) -> object:
        return self.robot.enclose(X_WF, rail, in_order(limits, FIRST), twist)

    @cached_property
    def expressions(self) -> object:
        inner = self.robot.expressions

        class Expressions:
            branch, inverse = inner.branch, inner.inverse

            def flange(self, q: ca.SX) -> tuple[ca.SX, ca.SX]:
                return inner.flange(q[FIRST.tolist()])

        return Expressions()


def in_order(limits: JointLimits, order: Array) -> JointLimits:
    names = tuple(limits.names[i] for i in order)
    return JointLimits(names, *(x[order] for x in (limits.lower, limits.upper, limits.velocity, limits.acceleration)))


def rail_last(problem: Problem) -> Problem:
    plant = problem.plant
    plant = replace(plant, robot=RailLast(plant.robot), limits=in_order(plant.limits, LAST))
    waypoints = tuple(w if w.q is None else replace(w, q=w.q[LAST]) for w in problem.waypoints)
    return replace(problem, plant=plant, waypoints=waypoints)


def planned(axes: Axes, problem: Problem) -> Trajectory:
    """What optimize makes of a problem."""
    seconds: dict[str, float] = {}
    found = initial_plan_of(axes, [problem], Patience(), lambda _: None, seconds)
    assert isinstance(found, InitialPlan)
    iterate = found.iterate
    if not problem.coordinated:
        _, iterate, _ = refine(axes, found, Patience(), lambda _: None, seconds)
    trajectory, _, over = rows_of(axes, problem, iterate)
    assert not len(over)
    return trajectory


@pytest.mark.parametrize("target", Target)
def test_a_rail_that_is_the_last_axis_changes_nothing_but_the_order(
    target: Target, monkeypatch: pytest.MonkeyPatch
) -> None:
    body = "MoveJ p_in, v2500, fine, tool0;\nMoveL p_low, v500, fine, tool0;\nWaitTime 0.1;\n"
    plant = plant_with_rail((-0.16, 0.8))
    problem = problem_of(rapid(body + "MoveAbsJ j_home, v2500, fine, tool0;"), plant, target)
    plans, bounds = [], []
    for one, evaluated in ((problem, library), (rail_last(problem), Maps)):  # to compile it would take longer
        monkeypatch.setattr("trajopt_cli.nlp.formulation.users_library", evaluated)
        axes = Axes.of(one.plant)
        plans.append(planned(axes, one))
        trajectory = plans[-1]
        bounds.append(lower_bound(axes, one, trajectory.duration))
    first, last = plans
    assert last.names == (*(f"joint_{i}" for i in range(1, 7)), "rail")
    assert last.duration == pytest.approx(first.duration, abs=1e-6)
    assert bounds[1] == pytest.approx(bounds[0], abs=1e-9)
    np.testing.assert_allclose(last.q[-1, FIRST], np.r_[0.0, HOME], atol=1e-12)
    middle = first.duration / 2
    at = [np.array([np.interp(middle, p.t, column) for column in p.q.T]) for p in plans]
    np.testing.assert_allclose(at[1][FIRST], at[0], rtol=0, atol=1e-3)
