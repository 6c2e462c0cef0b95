"""Repair of a plan where it is broken, leg by leg: what is legal elsewhere stays as it is.

A leg that has less time than its way takes goes less far with the rail.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

import numpy as np

from trajopt_cli.path_timing.edge_times import Times
from trajopt_cli.path_timing.path_parameterized_plan import NotDriven, Runs
from trajopt_cli.plan.detour_planner import NoClearPath, timed_clear
from trajopt_cli.plan.rail_refinement import refine_rail
from trajopt_cli.problem.problem import Problem
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.iterate import Iterate
from trajopt_cli.trajectories.route import Route

_SHORTENINGS = 3  # times that the way in one leg is shortened
_HAIR = 1e-4  # share of its time that a shortened leg has to spare
_SAME = 1e-9  # m, rad


def timed_in_time(
    axes: Axes, problem: Problem, chain: Route, runs: Runs | None, room: Axes, known: Times
) -> tuple[Route, Iterate | NoClearPath]:
    """A chain as timed; where a leg has less time than it takes, one whose rail goes as far in that leg as can be
    driven, and elsewhere what suits that best.

    Args:
        axes, problem, chain, runs: as in timed_clear.
        room: axes in whose ranges rail positions are looked for.
        known: as in leg_times.

    Returns:
        The chain that was driven, and what timed_clear says of it.

    Raises:
        NotDriven: where no way is short enough, or none is what is wrong.
    """
    asked, tries = problem, Counter[int]()
    while True:
        try:
            return chain, timed_clear(axes, problem, chain, runs)
        except NotDriven as said:
            k = said.run[0]
            has = problem.legs[k].duration
            tries[k] += 1
            if said.least is None or has is None or tries[k] > _SHORTENINGS:
                raise
            if said.least > axes.settings.hopeless * has:  # the chain's rail was refined to be the least late
                raise
            shorter = refine_rail(room, asked, chain, known)
            if np.abs(shorter.q - chain.q).max() < _SAME:  # the few nodes it is timed on there say that it fits
                legs = list(asked.legs)
                legs[k] = replace(legs[k], duration=(legs[k].duration or has) * has / said.least * (1 - _HAIR))
                asked = replace(asked, legs=tuple(legs))
                shorter = refine_rail(room, asked, chain, known)
                if np.abs(shorter.q - chain.q).max() < _SAME:
                    raise
            chain = shorter
