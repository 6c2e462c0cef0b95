"""The fixtures of fake_planner, for every test in this folder; and streams that nothing refines."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from fake_planner import planner, program

from trajopt_cli.optimize.joined import joined
from trajopt_cli.optimize.legal import Legal

__all__ = ["planner", "program"]


def as_it_comes(axes: Any, legal: Legal, *_: object) -> tuple[Any, ...]:
    """In place of trajopt_cli.optimize.solve.improved: the legal motion that the search ends with."""
    return *joined(axes, legal.problem, legal.draft, legal.detours), ()


@pytest.fixture(scope="module")
def unrefined() -> Iterator[None]:
    """Streams are the first legal ones: plans of a file whose tests ask nothing of how fast streams are."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("trajopt_cli.optimize.solve.improved", as_it_comes)
        yield
