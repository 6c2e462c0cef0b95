"""The optimiser: rail, arm and timing solved together for the shortest cycle."""

from trajopt_cli.plan.initial_plan import Memory, NoCleanPlan
from trajopt_cli.plan.solve import bounded, check_feasible, lower_bound_of, optimize, search_estimate, slow_plan

__all__ = [
    "Memory",
    "NoCleanPlan",
    "bounded",
    "check_feasible",
    "lower_bound_of",
    "optimize",
    "search_estimate",
    "slow_plan",
]
