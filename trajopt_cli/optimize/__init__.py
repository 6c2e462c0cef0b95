"""The optimiser: rail, arm and timing solved together for the shortest cycle."""

from trajopt_cli.door import open_door
from trajopt_cli.optimize.solve import NoCleanPlan, check_feasible, optimize

__all__ = ["NoCleanPlan", "check_feasible", "optimize"]

open_door(__name__, "trajopt_cli.optimize:optimize")
