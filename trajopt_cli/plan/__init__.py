"""The optimiser: rail, arm and timing solved together for the shortest cycle."""

from trajopt_cli.plan.initial_plan import NoCleanPlan, PlanCache
from trajopt_cli.plan.ladder import first_legal, instead_of, out_of_order
from trajopt_cli.plan.solve import bounded, check_feasible, lower_bound_of, optimize, search_estimate, slow_plan

__all__ = [
    "NoCleanPlan",
    "PlanCache",
    "bounded",
    "check_feasible",
    "first_legal",
    "instead_of",
    "lower_bound_of",
    "optimize",
    "out_of_order",
    "search_estimate",
    "slow_plan",
]
