"""The optimiser: rail, arm and timing solved together for the shortest cycle."""

from trajopt_cli.door import open_door
from trajopt_cli.optimize.legal import Memory, NoCleanPlan
from trajopt_cli.optimize.solve import (
    bounded,
    check_feasible,
    lower_bound_of,
    optimize,
    search_estimate,
    slow_plan,
)

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

open_door(__name__, "trajopt_cli.optimize:optimize")
