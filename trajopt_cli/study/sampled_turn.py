"""Row `sampled turn`: turns of free tools by a ladder graph, as Descartes does it, and the path timed by TOPP-RA.

Every target has a turn for each 15 degrees that it may have, and each of these all configurations; of the chains
through them that one is taken in which the joints go least far, the rail where the fixed-rail plan has it.
"""

from __future__ import annotations

from dataclasses import replace

from trajopt_cli.graph_search.search import search
from trajopt_cli.plan.tool_turns import ladder
from trajopt_cli.problem.decision_scope import FIXED_RAIL
from trajopt_cli.problem.editable import everything
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.problem.problem import build_problem
from trajopt_cli.problem.tool_turns import turn_groups, turned
from trajopt_cli.study.case import Answer, Attempt, Case, NotApplicable
from trajopt_cli.study.toppra_row import toppra
from trajopt_cli.trajectories.axes import Axes


def sampled_turn(case: Case) -> Answer:
    """The program with sampled turns, its fixed-rail plan's path timed with TOPP-RA, every stop a stop."""
    program, plant = case.program, case.plant
    axes, problem = Axes.of(plant), build_problem(program, plant, FIXED_RAIL, Target.STREAM)
    if isinstance(problem, Infeasible) or (chain := search(axes, problem)) is None:
        return NotApplicable("as taught the targets are not all in reach")
    groups = turn_groups(problem, everything(program, plant))
    angles, route = ladder(axes, groups, chain, by_way=True)
    if route is None:
        return NotApplicable("no chain leads through sampled turns")
    answer = toppra(replace(case, program=turned(program, groups.turns(angles))))
    if not isinstance(answer, Attempt):
        return answer
    return replace(answer, program=program, notes=("turns by a ladder of 15 degrees, where joints go least far",))
