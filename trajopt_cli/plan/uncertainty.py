"""What motions take where the numbers they were planned with are not quite the true ones: the programs stay as they
are, and each motion is timed anew on its own course."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from trajopt_cli.motion import Program
from trajopt_cli.path_timing.retiming import Course
from trajopt_cli.problem.decision_scope import EVERYTHING
from trajopt_cli.problem.detours import unfolded, with_detours
from trajopt_cli.problem.plan import Infeasible, Plan
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.problem import Leg, build_problem
from trajopt_cli.problem.uncertainty import Guess, Uncertainty, guesses_of
from trajopt_cli.trajectories.axes import Axes

_SLOWER = 0.98  # share of its time in which a motion's course may be driven, below which it is slow by intent


def uncertainty(program: Program, plant: Plant, plans: Mapping[str, Plan]) -> Uncertainty:
    """Of plans of one program on one plant, by name, each with all its rows."""
    guesses = [*guesses_of(plant)]
    again = {name: _Again(program, plant, plan) for name, plan in plans.items()} if guesses else {}
    steps = {
        guess: {name: (one.step(guess, 0), one.step(guess, 1)) for name, one in again.items()} for guess in guesses
    }
    return Uncertainty({name: plan.duration for name, plan in plans.items()}, steps)


class _Again:
    """A plan, to be timed again. One that is slower than it could be on its course (least effort, limits of jerk) keeps
    its pace where that can be kept."""

    def __init__(self, program: Program, plant: Plant, plan: Plan):
        self._program, self._plan, self._plant = with_detours(program, plant, plan.detours), unfolded(plan), plant
        self._driven = [one for one in self._plan.motions if one.t_1 > one.t_0]
        axes, legs, self._paced = Axes.of(plant), self._legs(plant), False
        self._course = Course(plan.trajectory, axes, legs, np.array([one.t_1 for one in self._driven]))
        self._T = self._course.duration(axes, legs)
        if self._T / plan.duration < _SLOWER:
            self._paced, self._T = True, self._course.duration(axes, legs, paced=True)

    def step(self, guess: Guess, end: int) -> float:
        """By how much it takes longer [s] with an end of a guess."""
        plant = guess.at(self._plant, end)
        legs = self._course.legs if guess.axes else self._legs(plant)  # the tool's caps are in the legs
        return self._course.duration(Axes.of(plant), legs, self._paced) - self._T

    def _legs(self, plant: Plant) -> list[Leg]:
        """The leg of each motion that takes a time."""
        dropped = frozenset(one.index for one in self._plan.motions if one.dropped)
        problem = build_problem(self._program, plant, EVERYTHING, self._plan.target, None, dropped)
        assert not isinstance(problem, Infeasible)  # it has a plan
        first = {leg.motion: leg for leg in reversed(problem.legs)}
        return [first[one.index] for one in self._driven]
