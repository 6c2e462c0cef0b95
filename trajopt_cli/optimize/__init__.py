"""The optimiser: rail, arm and timing solved together for the shortest cycle."""

from trajopt_cli.optimize.solve import NoCleanPlan, check_feasible, optimize

__all__ = ["NoCleanPlan", "check_feasible", "optimize"]
