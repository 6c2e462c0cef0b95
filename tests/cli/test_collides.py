"""A plan that touches something, is not legal or is not found gives way to one that does not, or is."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path

import pytest
from fake_planner import Planner

import trajopt_cli.pipeline.folder  # noqa: F401  before the judge is replaced, which it takes by name
from trajopt_cli.cli import run
from trajopt_cli.findings import Report
from trajopt_cli.judge.findings import finding
from trajopt_cli.pipeline import planning
from trajopt_cli.plan import NoCleanPlan
from trajopt_cli.problem.decision_scope import AS_WRITTEN
from trajopt_cli.problem.plan import Target

HIT = "link_1 self clearance -0.1 m at t = 0.200 s, limit 0"
OF_STREAM = f"stream: the plan is the rapid plan: the stream plan that was found collides: {HIT}"
OF_RAPID = f"rapid: the plan is the program as written: the rapid plan that was found collides: {HIT}"


@pytest.fixture
def colliding(planner: Planner, monkeypatch: pytest.MonkeyPatch, request: pytest.FixtureRequest) -> str:
    """Plans as written are slower, RAPID plans slower than streams; the judge finds a hit in some, by their text."""
    planner.speed, planner.freest = 0.9, 1.0 / 0.9
    right, texts = planning.judge, dict[str, str]()

    def judge(plant, program, text, file, *more, **others):  # type: ignore[no-untyped-def]
        report = right(plant, program, text, file, *more, **others)
        text.seek(0)
        name = texts.setdefault(text.read(), "as written" if file == "as written" else Path(file).stem)
        if not any(one in name for one in request.param.split(" and ")):
            return report
        hit = finding("self clearance", "link_1", -0.1, 0.0, "m", False, time=0.2)
        return Report((*report.findings, hit), report.advice)

    monkeypatch.setattr(planning, "judge", judge)
    return str(request.param)


@pytest.mark.parametrize(
    ("colliding", "notes", "order"),
    [
        ("nothing", [], "stream < rapid < written"),
        ("stream", [OF_STREAM], "stream = rapid < written"),
        ("rapid", [OF_RAPID], "stream < rapid = written"),
        ("stream and rapid", [OF_RAPID, OF_STREAM], "stream = rapid = written"),
    ],
    indirect=["colliding"],
)
def test_the_best_plan_that_touches_nothing_is_the_answer(
    program: Path, colliding: str, notes: list[str], order: str
) -> None:
    assert run(["optimize", str(program), "--jobs", "1"]) == 0
    summary = json.loads(Path("results/tiny/summary.json").read_text())
    stream, rapid = (summary["plans"][one]["cycle_time_s"] for one in (Target.STREAM, Target.RAPID))
    written = summary["as_written"]["cycle_time_s"]
    signs = ["=" if a == b else "<" if a < b else ">" for a, b in ((stream, rapid), (rapid, written))]
    assert f"stream {signs[0]} rapid {signs[1]} written" == order
    said = [one.removesuffix(")").split(" (") for one in summary["notes"] if HIT in one]
    assert [one for one, _ in said] == notes
    for _, lost in said:  # what was refused, and what comes instead
        was, now = (float(number) for number in re.findall(r"\d+\.\d+", lost))
        assert was < now
        assert now in (round(stream, 3), round(rapid, 3))
    for one in Target:
        assert float(Path(f"results/tiny/{one.value}.csv").read_text().splitlines()[-1].split(",")[0]) == pytest.approx(
            summary["plans"][one]["cycle_time_s"]
        )


@pytest.mark.parametrize(
    ("colliding", "label"), [("stream and rapid and written", "stream"), ("rapid and written", "rapid")],
    indirect=["colliding"],
)  # fmt: skip
def test_where_every_plan_touches_something_nothing_is_written(
    program: Path, colliding: str, label: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["optimize", str(program), "--jobs", "1"]) == 1
    first, last = capsys.readouterr().err.splitlines()[-2:]
    assert first == HIT
    assert last.startswith(f"NOTHING WRITTEN: the {label} plan collides.")
    assert not Path("results").exists()


class Spoiling(Planner):
    """Plans of some targets, or as written, with one row a tenth of a radian aside."""

    def __init__(self, *spoiled: str):
        super().__init__()
        self.spoiled = spoiled

    def __call__(self, program, plant, target, *arguments, **more):  # type: ignore[no-untyped-def]
        plan = super().__call__(program, plant, target, *arguments, **more)
        name = "written" if AS_WRITTEN in arguments else target.value
        if name not in self.spoiled:
            return plan
        q = plan.trajectory.q.copy()
        q[len(q) // 2] += 0.1
        return replace(plan, trajectory=replace(plan.trajectory, q=q))


@pytest.mark.parametrize(
    ("spoiled", "notes"),
    [
        (["stream"], [("stream", "the plan is the rapid plan: the stream plan that was found is not legal")]),
        (["rapid"], [("rapid", "the plan is the program as written: the rapid plan that was found is not legal")]),
        (["stream", "rapid"], [("rapid", "the plan is the program as"), ("stream", "the plan is the rapid plan")]),
    ],
)
def test_a_plan_that_the_judge_rejects_gives_way_to_a_legal_one(
    program: Path,
    planner: Planner,
    spoiled: list[str],
    notes: list[tuple[str, str]],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("trajopt_cli.plan.optimize", Spoiling(*spoiled))
    assert run(["optimize", str(program), "--jobs", "1"]) == 0
    assert run(["verify", "results/tiny"]) == 0
    told = [one for one in json.loads(Path("results/tiny/summary.json").read_text())["notes"] if "not legal" in one]
    assert len(told) == len(notes)
    for note, (label, words) in zip(told, notes, strict=True):
        assert note.startswith(f"{label}: {words}")
        assert ": an error in trajopt; please report it (" in note


def test_where_the_judge_rejects_every_plan_nothing_is_written(
    program: Path, planner: Planner, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("trajopt_cli.plan.optimize", Spoiling("stream", "rapid", "written"))
    assert run(["optimize", str(program), "--jobs", "1"]) == 1
    assert "NOTHING WRITTEN: the judge rejects the stream plan:" in capsys.readouterr().err
    assert not Path("results").exists()


def test_a_stream_plan_that_is_not_found_is_told_as_a_failure(
    program: Path, planner: Planner, monkeypatch: pytest.MonkeyPatch
) -> None:
    right = planner.__call__

    class Failing(Planner):
        def __call__(self, program, plant, target, *arguments, **more):  # type: ignore[no-untyped-def]
            if target is Target.STREAM:
                raise NoCleanPlan("rows would pass a limit")
            return right(program, plant, target, *arguments, **more)

    monkeypatch.setattr("trajopt_cli.plan.optimize", Failing())
    assert run(["optimize", str(program), "--jobs", "1"]) == 0
    summary = json.loads(Path("results/tiny/summary.json").read_text())
    assert summary["plans"]["stream"]["cycle_time_s"] == summary["plans"]["rapid"]["cycle_time_s"]
    told = "no other one was found (rows would pass a limit): an error in trajopt; please report it"
    assert [one for one in summary["notes"] if one.startswith("stream:")] == [
        f"stream: the plan is the rapid plan: {told}"
    ]
