"""Streams as they come: for tests that plan streams and ask nothing of how fast they are."""

from __future__ import annotations

from trajopt_cli.optimize.axes import Axes
from trajopt_cli.optimize.draft import Draft
from trajopt_cli.optimize.joined import joined
from trajopt_cli.optimize.legal import Legal
from trajopt_cli.problem.problem import Problem

IMPROVED = "trajopt_cli.optimize.solve.improved"


def as_it_comes(axes: Axes, legal: Legal, *_: object) -> tuple[Problem, Draft, tuple[str, ...]]:
    """In place of IMPROVED: the legal motion that the search ends with."""
    return *joined(axes, legal.problem, legal.draft, legal.detours), ()
