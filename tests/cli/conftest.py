"""The fixtures of fake_planner, for every test in this folder."""

from fake_planner import planner, program, results

__all__ = ["planner", "program", "results"]
