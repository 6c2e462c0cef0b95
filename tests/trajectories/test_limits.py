"""A limit is one class: what it says, the dense check sees, the nonlinear program keeps and the report names."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from typing import Any

import numpy as np
import pytest
from small_cells import plant_with_rail, problem_of, rapid

from trajopt_cli.geometry import Array
from trajopt_cli.graph_search.search import search
from trajopt_cli.nlp.formulation import Formulation
from trajopt_cli.nlp.mesh_refinement import MeshRefinement, first_iterate
from trajopt_cli.path_timing.path_parameterized_plan import timed
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.problem import Leg
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.trajectories import limits
from trajopt_cli.trajectories.active_limits import binding_limits
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.dense_check import check_leg
from trajopt_cli.trajectories.iterate import Iterate
from trajopt_cli.trajectories.leg_trajectories import sampled
from trajopt_cli.trajectories.limits.limit import Limit, MotionSamples, NodeMotion, Row

TOP = 0.4  # rad/s


class Calm(Limit):
    """A made-up limit: joint 1 turns slowly."""

    name = "calm"

    @property
    def orders(self) -> Array:
        return np.ones(1)

    def labels(self, leg: Leg) -> list[str]:
        return ["calm joint_1"]

    def numbers(self, leg: Leg) -> Array:
        return np.array([[TOP]])

    def ratios(self, motion: MotionSamples) -> Array:
        return np.abs(motion.sample.qd[:, 1:2]) / TOP

    def node_shapes(self, kind: Hashable, on_path: bool) -> Mapping[str, tuple[int, ...]]:
        return {"calm": ()}

    def node_values(self, leg: Leg, margin: Array, on_path: bool, q: Array) -> Mapping[str, Array]:
        return {"calm": TOP * margin[:, 0]}

    def node_rows(self, kind: Hashable, node: NodeMotion, p: Any) -> list[Row]:
        return [(node.qd[1] / (p.calm * node.T), -1.0, 1.0)]


def fastest(axes: Axes) -> tuple[Iterate, float, list[str], float]:
    """The answer, joint 1's top speed, the active limits and the worst ratio there."""
    plant = plant_with_rail()
    problem = problem_of(rapid("MoveJ p_in, v1000, fine, tool0; MoveL p_low, v200, fine, tool0;"), plant)
    route = search(axes, problem)
    assert route is not None
    cfx = tuple(label.cfx for label in route.labels)
    start = first_iterate(axes, problem, route.q, route.w, cfx, route.times, capped=frozenset({0}))
    found = MeshRefinement(axes, Formulation(axes), problem, Patience()).run(start)
    motions = [motion for motion in found.legs if motion is not None]
    speeds = sampled(axes, motions, [np.linspace(0, motion.T, 400) for motion in motions]).qd[:, 1]
    worst = max(check_leg(axes, *both).worst for both in zip(problem.legs, motions, strict=True))
    return found, float(np.abs(speeds).max()), binding_limits(axes, problem.legs, motions), worst


def test_a_limit_that_is_one_class_more_is_kept_and_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    _, fast, _, _ = fastest(Axes.of(plant_with_rail()))
    monkeypatch.setattr(limits, "KINDS", (*limits.KINDS, Calm))
    found, slow, names, worst = fastest(Axes.of(plant_with_rail()))
    assert fast > 1.2 * TOP
    assert slow <= TOP
    assert worst <= 1.0
    assert "calm joint_1" in names
    assert all(motion is not None and motion.T > 0 for motion in found.legs)


def test_path_timing_drives_more_slowly_by_a_limit_that_has_no_rows_on_a_path(monkeypatch: pytest.MonkeyPatch) -> None:
    """Joint 1 turns with the path's rate: twice as slowly it keeps half the limit."""
    plant = plant_with_rail()
    problem = problem_of(rapid("MoveJ p_in, v5000, fine, tool0; MoveL p_low, v500, fine, tool0;"), plant, Target.RAPID)
    free, calm = Axes.of(plant), Axes.of(plant)
    route = search(free, problem)
    assert route is not None
    fast = timed(free, problem, route)
    monkeypatch.setattr(limits, "KINDS", (*limits.KINDS, Calm))
    slow = timed(calm, problem, route)
    top = [
        max(float(np.abs(sampled(free, [m], [np.linspace(0, m.T, 400)]).qd[:, 1]).max()) for m in one.legs if m)
        for one in (fast, slow)
    ]
    assert top[0] > 1.1 * TOP
    assert 0.8 * TOP < top[1] <= TOP
