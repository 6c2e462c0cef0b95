"""`trajopt order` as people type it."""

from __future__ import annotations

import json
from itertools import pairwise, permutations
from pathlib import Path

import pytest

from trajopt_cli.cli import run
from trajopt_cli.job import read_job
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.progress import Progress
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.runs.folder import ORDER, read_run
from trajopt_cli.study.answers import study_record
from trajopt_cli.study.order import Ordered, order_of, order_record
from trajopt_cli.study.order_text import group_of

PLACES = {1: -0.5, 2: 0.5, 3: -0.4, 4: 0.4}  # rad of joint 1: the written order goes to and fro
CELL = """robot: irb140
start: {joints: '[0, 0, 0, 0, 30, 0] deg'}
order: {turns: [T1, T2, T3, T4]}
settle: 0
"""


def text(places: dict[int, float] = PLACES) -> str:
    data = "".join(
        f" CONST jointtarget j{i}:=[[{57.29578 * q:.4f},0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
        for i, q in places.items()
    )
    calls = "".join(f"  T{i};\n" for i in places)
    routines = "".join(
        f" PROC T{i}()\n  MoveAbsJ j{i}, vmax, fine, tool0;\n  WaitTime 0.1;\n ENDPROC\n" for i in places
    )
    home = " CONST jointtarget j0:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
    last = "  MoveAbsJ j0, vmax, fine, tool0;\n"
    return f"MODULE Tiny\n{home}{data} PROC main()\n{calls}{last} ENDPROC\n{routines}ENDMODULE\n"


@pytest.fixture
def tiny(program: Path) -> Path:
    program.write_text(text())
    Path("tiny.yaml").write_text(CELL)
    return program


@pytest.fixture
def few(monkeypatch: pytest.MonkeyPatch) -> None:
    """Besides the written, the nearest and the best order of the model one is planned."""
    for name, count in (("PLANNED", 1), ("_NEAR", 2)):
        monkeypatch.setattr(f"trajopt_cli.study.order.{name}", count)


@pytest.mark.usefixtures("few")
def test_the_best_order_is_planned_compared_and_written(tiny: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["order", str(tiny), "--json", "--jobs", "1"]) == 0
    found = json.loads(capsys.readouterr().out)
    # all 24 orders, each move a ramp up, a cruise if it is long, a ramp down
    limits = read_job(tiny).plant.limits
    v, a = float(limits.velocity[0]), float(limits.acceleration[0])
    every = {}
    for order in permutations(PLACES):
        stops = [0.0, *(PLACES[i] for i in order), 0.0]
        ways = [abs(after - before) for before, after in pairwise(stops)]
        every[order] = 0.4 + sum(way / v + v / a if way > v * v / a else 2 * (way / a) ** 0.5 for way in ways)
    assert found["best"]["cycle_time_s"] == pytest.approx(min(every.values()), abs=2e-3)
    assert found["written"]["cycle_time_s"] == pytest.approx(every[1, 2, 3, 4], abs=2e-3)
    assert found["best"]["cycle_time_s"] < found["written"]["cycle_time_s"] - 0.2
    assert found["model_is_exact"]
    assert found["model_bound_s"] == pytest.approx(found["best_of_model"]["model_s"])
    # joint moves between points alone: the model is the plan
    for one in found["orders"]:
        if one["cycle_time_s"] is not None:
            assert one["model_s"] == pytest.approx(one["cycle_time_s"], rel=1e-3)
    folder = read_run(Path("results/tiny_order"), study_record(ORDER))
    assert json.loads(folder.contents["order.json"]) == found
    assert folder.contents["input/tiny.mod"] == tiny.read_bytes()
    calls = "".join(f"  {name};\n" for name in found["best"]["order"])
    assert calls in folder.contents["program/tiny.mod"].decode()
    # into the program itself, which then has nothing to gain
    before = tiny.read_bytes()
    assert run(["order", str(tiny), "--apply", "--jobs", "2"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].rstrip() == "tiny.mod, rapid: in which order turns"
    assert "model: " in "".join(lines)
    assert lines[-1] == "written to tiny.mod: the best order; as it was: tiny.mod.bak"
    assert tiny.read_bytes() == folder.contents["program/tiny.mod"]
    assert Path("tiny.mod.bak").read_bytes() == before
    assert run(["order", str(tiny), "--quiet", "--jobs", "1"]) == 0
    assert capsys.readouterr().out.startswith("turns: no order that was planned is faster than the written one, ")


@pytest.mark.usefixtures("few")
def test_what_cannot_be_written_is_listed(tiny: Path, capsys: pytest.CaptureFixture[str]) -> None:
    changed = (
        text()
        .replace(" PROC T1()\n", " VAR num n:=0;\n PROC T1()\n  n:=1;\n")
        .replace(" PROC T2()\n", ' PROC T2()\n  TPWrite ""\\Num:=n;\n')
    )
    tiny.write_text(changed)
    assert run(["order", str(tiny), "--apply", "--jobs", "1"]) == 1
    out, error = capsys.readouterr()
    assert "not written into the program: n is changed in T1 and used in T2" in out
    assert "in the order T" in out
    assert error.splitlines()[-1] == "tiny.mod: stays as it is: n is changed in T1 and used in T2"
    assert tiny.read_text() == changed
    assert not any("program" in name for name in read_run(Path("results/tiny_order"), study_record(ORDER)).contents)


def test_a_part_out_of_reach_is_named(tiny: Path, capsys: pytest.CaptureFixture[str]) -> None:
    tiny.write_text(text({**PLACES, 3: 9.0}))
    assert run(["order", str(tiny)]) == 1
    assert "MoveAbsJ j3 asks for joint_1" in capsys.readouterr().err


def test_a_search_that_is_stopped_tells_what_it_would_have_planned(tiny: Path) -> None:
    patience = Patience()
    group = group_of(read_job(tiny))

    def listen(_: str, progress: Progress) -> None:
        if progress.phase.endswith("searched") and progress.phase.startswith(("10 ", "11 ", "12 ")):
            patience.interrupt()

    found = order_of(group, Target.RAPID, listen, patience, 1)
    assert isinstance(found, Ordered)
    assert found.stopped == "stopped by Ctrl-C"
    assert [one.order for one in found.found.values() if one.planned is not None] == [(0, 1, 2, 3)]
    assert found.best is found.written
    told = [line for line in found.remarks if line.startswith("not planned: T")]
    assert len(told) == 1
    assert float(told[0].split()[-2]) < found.written.planned  # type: ignore[operator]
    assert found.new_text is None


@pytest.mark.parametrize("limit", [0, 100])
def test_a_time_limit_leaves_the_written_order_planned(tiny: Path, limit: float) -> None:
    clock = iter(range(1 << 30))
    patience = Patience(limit, lambda: float(next(clock)))
    found = order_of(group_of(read_job(tiny)), Target.RAPID, lambda *_: None, patience, 1)
    assert isinstance(found, Ordered)
    assert found.stopped == f"stopped by the time limit after {limit} s"
    assert found.written.planned is not None
    assert found.best is not None
    assert any("times between stations were not found" in line for line in found.remarks) == (limit == 0)
    json.dumps(order_record(found), allow_nan=False)
