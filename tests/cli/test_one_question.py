"""What a run was asked for is what a comparison with its results folder asks."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from fake_planner import Planner

from trajopt_cli.cli import run
from trajopt_cli.errors import InputError
from trajopt_cli.problem.editable import Loops
from trajopt_cli.runs.results import read_results
from trajopt_cli.study import comparison


@pytest.fixture
def asked(compared_once: None, monkeypatch: pytest.MonkeyPatch) -> list[Loops]:
    """What loops become in the comparisons that are made."""
    found: list[Loops] = []
    made = comparison.compare

    def compare(job: Any, listen: Any, rule: Any, loops: Loops, patience: Any) -> comparison.Comparison:
        found.append(loops)
        return made(job, listen, rule, loops, patience)

    monkeypatch.setattr(comparison, "compare", compare)
    return found


@pytest.mark.parametrize("loops", Loops)
@pytest.mark.usefixtures("planner")
def test_a_results_folder_brings_its_loops(
    loops: Loops, program: Path, asked: list[Loops], capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["optimize", str(program), "--loops", loops.value]) == 0
    assert run(["compare", "baseline", "results/tiny", "--json"]) == 0
    assert asked == [loops]
    capsys.readouterr()
    for given in Loops:
        assert run(["compare", "baseline", "results/tiny", "--loops", given.value]) == 2
        assert capsys.readouterr().err == (
            "results/tiny: a results folder brings its own answer to what loops become; leave --loops out\n"
        )
    assert asked == [loops]


def test_a_program_is_asked_with_loops_kept(program: Path, planner: Planner, asked: list[Loops]) -> None:
    assert run(["compare", "baseline", str(program)]) == 0
    assert run(["compare", "baseline", str(program), "--loops", "unroll"]) == 0
    assert asked == [Loops.KEEP, Loops.UNROLL]


@pytest.mark.usefixtures("planner")
def test_a_run_from_before_the_option_keeps_loops(program: Path) -> None:
    assert run(["optimize", str(program), "--loops", "unroll"]) == 0
    place = Path("results/tiny/run.json")
    record = json.loads(place.read_text())
    del record["options"]["loops"]
    place.write_text(json.dumps(record))
    assert read_results(place.parent).loops is Loops.KEEP
    record["options"]["loops"] = "roll"
    place.write_text(json.dumps(record))
    with pytest.raises(InputError, match=r"options\.loops"):
        read_results(place.parent)
