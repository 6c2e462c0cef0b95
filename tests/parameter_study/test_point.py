"""One point: against the same cell planned by hand, and ended where it takes more than it may."""

from __future__ import annotations

import time
from dataclasses import replace
from pathlib import Path
from typing import NoReturn

import numpy as np
import pytest
from tiny import CELL, written

from trajopt_cli.job import read_job
from trajopt_cli.parameter_study import point as points
from trajopt_cli.parameter_study.guard import Guard, OutOfMemory, OutOfTime
from trajopt_cli.parameter_study.point import PointInputs, evaluate
from trajopt_cli.parameter_study.study_file import Study, read_study
from trajopt_cli.problem.plan import Target
from trajopt_cli.study.place import tried
from trajopt_cli.study.places import parse_ranges, site_of

ALL = "programs: [tiny.mod]\nvary: {limits.joint_1.velocity: [0.2]}\nanswers: [%s]\n"
EVERY = "rapid, stream, as_written, fixed_rail, bound, sensitivity"


def study_of(folder: Path, answers: str, more: str = "") -> Study:
    return read_study(written(folder, ALL % answers + more))


def test_first_legal_is_the_motion_that_place_begins_with(tmp_path: Path) -> None:
    study = study_of(tmp_path, "rapid, stream")
    row = evaluate(study.inputs, study.design.point(0))
    (tmp_path / "tiny.yaml").write_text(CELL + "limits: {joint_1: {velocity: 0.2, source: x}}\n")
    site = site_of(read_job(tmp_path / "tiny.mod"), "base", parse_ranges(["x=-1mm..1mm"]))
    firsts = {target: tried(site, site.present, target, None).first for target in Target}
    assert row["rapid_s"] == firsts[Target.RAPID]
    assert row["stream_s"] == min(firsts.values())
    assert (row["status"], row["reason"]) == ("ok", "")


def test_answers_are_in_order_and_nothing_else_is_told(tmp_path: Path) -> None:
    study = study_of(tmp_path, EVERY, "effort: full\nprice: 10 * limits.joint_1.velocity\n")
    row = evaluate(study.inputs, study.design.point(0))
    assert [*row] == [column.name for column in study.inputs.columns]
    assert row["rapid_bound_s"] <= row["rapid_s"] <= row["as_written_s"]
    assert row["stream_bound_s"] <= row["stream_s"] <= min(row["rapid_s"], row["fixed_rail_s"] + 1e-9)
    assert row["saved_s"] == row["as_written_s"] - row["rapid_s"]
    assert row["price"] == 2.0
    assert row["change_first"] is not None
    assert evaluate(study.inputs, study.design.point(0)) == row


def test_a_point_that_cannot_be_done_says_why(tmp_path: Path) -> None:
    vary = "vary: {target.p_in.z: [0, 2]}\nprograms: [tiny.mod]\nanswers: [rapid]\n"
    study = read_study(written(tmp_path, vary))
    rows = [evaluate(study.inputs, study.design.point(i)) for i in range(2)]
    assert [row["status"] for row in rows] == ["ok", "infeasible"]
    assert rows[1]["rapid_s"] is None
    assert rows[1]["reason"].startswith("tiny.mod:7")


def test_a_point_that_takes_too_long_or_too_much_memory_is_ended(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    study = study_of(tmp_path, "rapid")

    def endless(*_: object) -> NoReturn:
        while True:
            np.linalg.eigvals(np.ones((30, 30)))

    monkeypatch.setattr(points, "_answered", endless)
    slow: PointInputs = replace(study.inputs, seconds=0.2)
    start = time.thread_time()
    row = evaluate(slow, study.design.point(0))
    assert 0.2 <= time.thread_time() - start < 2.0
    assert (row["status"], row["reason"]) == ("time", "took more than 0.2 s of processor time")
    row = evaluate(replace(study.inputs, memory=1e6), study.design.point(0))
    assert (row["status"], row["reason"]) == ("memory", "took more than 1 MB of memory")


def busy(seconds: float) -> None:
    start = time.thread_time()
    while time.thread_time() - start < seconds:
        sum(range(100))


def test_a_guard_that_has_ended_raises_nothing_any_more() -> None:
    for what in (OutOfTime, OutOfMemory):
        bounds = (1e-6, None) if what is OutOfTime else (None, 1.0)
        with pytest.raises(what), Guard(*bounds):
            busy(10.0)
    guard = Guard(0.05, None)
    with guard:
        pass
    busy(0.3)
