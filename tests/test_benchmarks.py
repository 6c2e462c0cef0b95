"""What benchmarks/ imports is still there; the smallest case of those that are quick."""

from __future__ import annotations

import os
import runpy
import sys
from pathlib import Path
from typing import Any

import pytest

BENCHMARKS = Path(__file__).parents[1] / "benchmarks"


@pytest.fixture
def benchmark(monkeypatch: pytest.MonkeyPatch, request: pytest.FixtureRequest) -> dict[str, Any]:
    """A benchmark's names; what it does to the process as a whole is undone."""
    monkeypatch.setattr(os, "environ", os.environ.copy())
    monkeypatch.setattr(sys, "path", [str(BENCHMARKS), *sys.path])
    return runpy.run_path(str(BENCHMARKS / f"{request.param}.py"), run_name="benchmark")


@pytest.mark.parametrize("benchmark", sorted(path.stem for path in BENCHMARKS.glob("bench_*.py")), indirect=True)
def test_a_benchmark_finds_what_it_imports(benchmark: dict[str, Any]) -> None:
    assert callable(benchmark["main"])


@pytest.mark.parametrize("benchmark", ["bench_admittance"], indirect=True)
def test_the_controllers_period_is_timed_by_parts(
    benchmark: dict[str, Any], capsys: pytest.CaptureFixture[str]
) -> None:
    benchmark["law_rows"](0.01)
    benchmark["period_rows"](3)
    lines = capsys.readouterr().out.splitlines()
    assert sum(line.startswith(("Euler", "exact", "rotation")) for line in lines) == 4
    assert sum(line.startswith("inverse kinematics") for line in lines) == 2


@pytest.mark.parametrize("benchmark", ["bench_dose"], indirect=True)
def test_a_cube_of_two_edges_is_dosed(benchmark: dict[str, Any], capsys: pytest.CaptureFixture[str]) -> None:
    benchmark["measure"].__globals__.update(CORNERS="000 100 110", SIDE=0.02)
    benchmark["measure"]("two edges", benchmark["dose_path"](benchmark["cube"](2.0)), 0.005)
    assert capsys.readouterr().out.count("  T = ") == 3
