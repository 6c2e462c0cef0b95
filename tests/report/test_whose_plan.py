"""`--target` decides whose plan is drawn."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from drawn_plans import drawn

from trajopt_cli.cli.compare import _drawn
from trajopt_cli.findings import Report
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.study.case import Attempt
from trajopt_cli.study.comparison import Comparison, Row, Tried, comparison_pictures
from trajopt_cli.study.table import BASELINES

STREAM = "optimum stream"


@pytest.mark.parametrize("target", Target)
def test_compare_draws_the_fastest_legal_plan_of_the_target(target: Target, monkeypatch: pytest.MonkeyPatch) -> None:
    case = drawn(rail=False)
    plans = {one: replace(case.plan, target=one) for one in Target}
    asked: list[Plan] = []

    def pictures(job: object, plan: Plan) -> dict[str, bytes]:
        asked.append(plan)
        return {"plots/path.svg": b""}

    monkeypatch.setattr("trajopt_cli.pipeline.optimize.plan_pictures", pictures)
    rows = [
        Row(
            name,
            BASELINES[name],
            Tried(Attempt(case.program, plans[one].trajectory, plans[one]), Report((), ())),
        )
        for name, one in (
            ("as-written", Target.RAPID),
            ("optimum rapid", Target.RAPID),
            ("optimum stream", Target.STREAM),
        )
    ]
    job: Any = SimpleNamespace(title="cell", program=case.program)
    files = comparison_pictures(Comparison(job, tuple(rows), "no plan to start from", 0.0), target)
    assert [plan.target for plan in asked] == [target]
    assert set(files) == {"comparison.svg", "comparison.png", "path.svg"}


def test_without_a_word_it_is_the_streams_or_that_of_the_folder(monkeypatch: pytest.MonkeyPatch) -> None:
    program = Path("p.mod")
    assert _drawn(None, program) is Target.STREAM
    assert _drawn("rapid", program) is Target.RAPID
    monkeypatch.setattr("trajopt_cli.job.is_results", lambda path: True)
    monkeypatch.setattr("trajopt_cli.runs.results.read_results", lambda path: SimpleNamespace(target=Target.RAPID))
    assert _drawn(None, program) is Target.RAPID
    assert _drawn("stream", program) is Target.STREAM
