"""The optimiser: rail, arm and timing solved together for the shortest cycle."""

from trajopt_cli.door import open_door
from trajopt_cli.optimize.legal import Memory, NoCleanPlan
from trajopt_cli.optimize.solve import check_feasible, optimize, search_estimate

__all__ = ["Memory", "NoCleanPlan", "check_feasible", "optimize", "search_estimate"]

open_door(__name__, "trajopt_cli.optimize:optimize")
