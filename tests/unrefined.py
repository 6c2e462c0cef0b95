"""Streams in less time, for tests that ask something else of them: as they come, or solved like those of long ones."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from trajopt_cli.optimize.axes import Axes
from trajopt_cli.optimize.draft import Draft
from trajopt_cli.optimize.joined import joined
from trajopt_cli.optimize.legal import Legal
from trajopt_cli.problem.problem import Problem

IMPROVED = "trajopt_cli.optimize.solve.improved"


def as_it_comes(axes: Axes, legal: Legal, *_: object) -> tuple[Problem, Draft, tuple[str, ...]]:
    """In place of IMPROVED: the legal motion that the search ends with."""
    return *joined(axes, legal.problem, legal.draft, legal.detours), ()


@contextmanager
def coarse_grids() -> Iterator[None]:
    """Programs of any length are solved on the grids that long ones have: a quarter of the nodes."""
    with pytest.MonkeyPatch.context() as patch:
        for name in ("SHORT", "FEW_LEGS"):
            patch.setattr(f"trajopt_cli.optimize.driver.{name}", 0)
        yield


def coarse_search(patch: pytest.MonkeyPatch) -> None:
    """The rail's places are searched on coarse grids and refined once, for who does not ask how good they are."""
    for name, few in (
        ("search.SEARCH_COARSE", 17), ("search.SEARCH_APART", 0.15), ("search.SEARCH_FINE", 9), ("rail.POLISH", 0),
        ("rail.REFINE_ROUNDS", 1),
    ):  # fmt: skip
        patch.setattr(f"trajopt_cli.optimize.{name}", few)
