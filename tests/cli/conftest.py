"""The fixtures of fake_planner, for every test in this folder."""

from fake_planner import compared_once, planner, program, results

__all__ = ["compared_once", "planner", "program", "results"]
