"""Streams in less time, for tests that ask something else of them: as they come, or solved like those of long ones."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import pytest

from trajopt_cli.collision.merge_via_points import merge_via_points
from trajopt_cli.job import Job
from trajopt_cli.pipeline import planning
from trajopt_cli.plan.initial_plan import InitialPlan
from trajopt_cli.problem.plan import Infeasible, NoPlan, Target
from trajopt_cli.problem.problem import Problem
from trajopt_cli.runs.summary import Judged
from trajopt_cli.settings import DEFAULT
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.iterate import Iterate

IMPROVED = "trajopt_cli.plan.solve.refine"


def as_it_comes(axes: Axes, legal: InitialPlan, *_: object) -> tuple[Problem, Iterate, tuple[str, ...]]:
    """In place of IMPROVED: the legal motion that the search ends with."""
    return *merge_via_points(axes, legal.problem, legal.iterate, legal.detours), ()


@contextmanager
def coarse_grids() -> Iterator[None]:
    """Programs of any length are solved on the grids that long ones have: a quarter of the nodes."""
    with pytest.MonkeyPatch.context() as patch:
        set_defaults(patch, short_program=0, few_legs=0)
        yield


def coarse_search(patch: pytest.MonkeyPatch) -> None:
    """The rail's places are searched on coarse grids and refined once, for who does not ask how good they are."""
    set_defaults(patch, coarse_grid=17, coarse_spacing=0.15, fine_grid=9, polished_legs=0)
    patch.setattr("trajopt_cli.plan.rail_refinement._REFINE_ROUNDS", 1)


def rapid_alone(patch: pytest.MonkeyPatch) -> None:
    """Only the RAPID plan is made, and no bound, for who asks nothing of streams and gaps."""
    solve = planning.solve

    def solved(job: Job, target: Target, *more: Any, **options: Any) -> Judged | Infeasible | NoPlan:
        return NoPlan(target.value, "not asked") if target is Target.STREAM else solve(job, target, *more, **options)

    patch.setattr(planning, "solve", solved)
    patch.setattr("trajopt_cli.plan.lower_bound_of", lambda program, plant, plan, **more: 0.9 * plan.duration)


def set_defaults(patch: pytest.MonkeyPatch, **numbers: float) -> None:
    """Other numbers for all plants that were given no settings of their own, also those that are there already."""
    for name, number in numbers.items():
        assert hasattr(DEFAULT, name), name
        patch.setitem(vars(DEFAULT), name, number)
