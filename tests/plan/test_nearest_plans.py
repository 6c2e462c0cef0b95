r"""Under ConfJ \Off what stays as programmed ends in the nearest configuration, however slow; what may change need not.

joint_5 is so slow here that a flipped wrist, which turns it least, is the fastest way, and the farthest.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from small_cells import plant_without_rail, rapid

from trajopt_cli.geometry import Array, wxyz_from_rotation
from trajopt_cli.graph_search.reach import check_reach
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import Program
from trajopt_cli.plan import optimize
from trajopt_cli.problem.build import build_problem
from trajopt_cli.problem.configurations import arms_as_written, check_configurations
from trajopt_cli.problem.decision_scope import AS_WRITTEN, EVERYTHING, Freedom
from trajopt_cli.problem.editable import Changes
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.trajectories.axes import Axes

BEGIN, NEAR = np.radians([20.0, 10, -10, 10, 40, 0]), np.radians([40.0, 20, -20, 5, -40, 10])
FLIPPED = NEAR + np.radians([0.0, 0, 0, 180, 80, -180])
BACK = np.radians([30.0, 10, -15, 190, 45, -180])  # near that; from NEAR the other wrist is nearer


@pytest.fixture(scope="module")
def plant() -> Plant:
    free = plant_without_rail()
    slow = free.limits.velocity * [1, 1, 1, 1, 0.05, 1]
    return replace(free, start=BEGIN, limits=replace(free.limits, velocity=slow))


def target(plant: Plant, q: Array, conf: str = "[3,3,3,3]", up: float = 0.0) -> str:
    X = plant.robot.forward(q)
    X[2, 3] += up
    place, turn = (",".join(f"{v:.9f}" for v in part) for part in (X[:3, 3] * 1e3, wxyz_from_rotation(X[:3, :3])))
    return f"[[{place}],[{turn}],{conf},[9E9,9E9,9E9,9E9,9E9,9E9]]"


def program_of(plant: Plant, switch: str = r"ConfJ \Off;", conf: str = "[3,3,3,3]") -> Program:
    return rapid(f"{switch}\nMoveJ {target(plant, NEAR, conf)}, v5000, fine, tool0;")


def end_of(plan: Plan | Infeasible) -> Array:
    assert isinstance(plan, Plan), plan
    return np.asarray(plan.motions[-1].q_1)


KEPT = Changes(frozenset())


@pytest.mark.parametrize(
    ("freedom", "changes", "wanted"),
    [(AS_WRITTEN, None, NEAR), (EVERYTHING, KEPT, NEAR), (EVERYTHING, None, FLIPPED)],
    ids=["as written", "kept", "free"],
)
def test_what_stays_as_programmed_takes_the_nearest(
    plant: Plant, freedom: Freedom, changes: Changes | None, wanted: Array
) -> None:
    plan = optimize(program_of(plant), plant, Target.RAPID, freedom, bounded=False, changes=changes)
    np.testing.assert_allclose(end_of(plan), wanted, rtol=0, atol=1e-6)


def test_each_nearest_is_counted_from_where_the_arm_stands(plant: Plant) -> None:
    r"""Confdata that counts flips the wrist; from there the same pose's nearest is the flipped one; a line keeps it."""
    flip = target(plant, FLIPPED, "[0,2,-2,0]")
    body = f"MoveJ {flip}, v5000, fine, tool0;\nConfJ \\Off;\nConfL \\Off;"
    body += f"\nMoveJ {target(plant, BACK)}, v5000, z10, tool0;"
    line = target(plant, BACK, up=0.02)
    program = rapid(f"{body}\nMoveL {line}, v5000, fine, tool0;\nMoveJ {target(plant, NEAR)}, v5000, fine, tool0;")
    plan = optimize(program, plant, Target.RAPID, AS_WRITTEN, bounded=False)
    ends = arms_as_written(program, plant)
    for index, wanted in ((0, FLIPPED), (1, BACK), (3, FLIPPED)):
        np.testing.assert_allclose(ends[index], wanted, rtol=0, atol=1e-6)
    np.testing.assert_allclose(end_of(plan), FLIPPED, rtol=0, atol=1e-6)
    assert isinstance(plan, Plan)
    report = verify(program, plant, plan.trajectory, target=Target.RAPID, advice=False, as_written=True)
    assert report.legal, report.worst


def test_the_judge_holds_what_is_as_written_to_the_nearest_and_no_more(plant: Plant) -> None:
    off = program_of(plant)
    flipped = optimize(program_of(plant, "", "[0,2,-2,0]"), plant, Target.RAPID, AS_WRITTEN, bounded=False)
    near = optimize(off, plant, Target.RAPID, AS_WRITTEN, bounded=False)
    assert isinstance(flipped, Plan)
    assert isinstance(near, Plan)
    bad = verify(off, plant, flipped.trajectory, target=Target.RAPID, advice=False, as_written=True)
    assert [one.check for one in bad.findings if not one.passed] == ["nearest posture"]
    assert bad.worst.source == off.motions[0].source
    assert verify(off, plant, flipped.trajectory, target=Target.RAPID, advice=False).legal
    assert verify(off, plant, near.trajectory, target=Target.RAPID, advice=False, as_written=True).legal


def test_a_line_that_the_nearest_configuration_cannot_run_is_told_alike_by_all(plant: Plant) -> None:
    """The nearest wrist is bent by 10 degrees one way, and the line straightens it on its way to the other."""
    bent, other = (np.radians([0.0, 10, -10, 0, angle, 0]) for angle in (10, -10))
    body = f"ConfJ \\Off;\nConfL \\Off;\nMoveJ {target(plant, bent)}, v500, fine, tool0;"
    program = rapid(f"{body}\nMoveL {target(plant, other)}, v100, fine, tool0;")
    (found,) = check_configurations(program, plant)
    assert found.index == 1
    plan = optimize(program, plant, Target.RAPID, AS_WRITTEN, bounded=False)
    assert isinstance(plan, Infeasible)
    assert (plan.index, plan.message) == (1, found.message)
    kept = build_problem(program, plant, EVERYTHING, Target.RAPID, KEPT)
    assert not isinstance(kept, Infeasible)
    assert check_reach(Axes.of(plant), kept) is not None
    assert (
        check_reach(Axes.of(plant), replace(kept, waypoints=tuple(replace(p, nearest=False) for p in kept.waypoints)))
        is None
    )
