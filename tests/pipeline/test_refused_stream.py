"""A stream that the judge refuses is repaired where it is refused; only what no repair helps falls back as a whole."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from unrefined import IMPROVED, as_it_comes, coarse_grids, coarse_search

from trajopt_cli.findings import Report
from trajopt_cli.job import read_job
from trajopt_cli.judge.findings import finding
from trajopt_cli.pipeline import planning
from trajopt_cli.pipeline.planning import Clock, may_change, plan_all
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.objective import LEAST_TIME
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.stop_condition import Patience
from trajopt_cli.runs.rows import RowsFile
from trajopt_cli.runs.summary import Judged

TEXT = """MODULE Refused
    CONST jointtarget j_home:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_in:=[[500,100,450],[0,0,1,0],[0,0,0,0],[100,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_low:=[[500,100,390],[0,0,1,0],[0,0,0,0],[100,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveJ p_in, v1000, fine, tool0;
        MoveL p_low, v500, fine, tool0;
        WaitTime 0.3;
        MoveL p_in, v500, fine, tool0;
        MoveAbsJ j_home, v2500, fine, tool0;
    ENDPROC
ENDMODULE
"""
FIXED = 'robot: irb140\nsettle: 0\nstart: {joints: "[0, 0, 0, 0, 30, 0] deg"}\n'
RAILED = """robot: irb140_rail
settle: 0
rail: {eax: a, stroke: [-0.2, 0.6]}
waits: {rail: free}
limits: {rail: {velocity: 1, acceleration: 3, source: a}}
start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}
"""
LINE, WAIT, LAST = 1, 2, 4  # motions


class Judge:
    """The judge, that refuses so many stream files as one finding says, but for rows that a RAPID plan has as well."""

    def __init__(self, times: int, when: float, value: float, limit: float):
        self.times, self.texts, self.others = times, list[str](), set[str]()
        self._finding = finding("acceleration", "joint_1", value, limit, "rad/s2", False, time=when)
        self._right = planning.judge

    def __call__(self, plant: Any, program: Any, text: Any, file: str, *more: Any, **others: Any) -> Report:
        report = self._right(plant, program, text, file, *more, **others)
        text.seek(0)
        known = text.read()
        if not file.startswith("stream"):
            self.others.add(known)
        if known in self.others or len(self.texts) >= self.times:
            return report
        self.texts.append(known)
        return Report((*report.findings, self._finding), report.advice)


@pytest.fixture(autouse=True)
def _quick(monkeypatch: pytest.MonkeyPatch) -> Any:
    coarse_search(monkeypatch)
    monkeypatch.setattr("trajopt_cli.plan.lower_bound_of", lambda program, plant, plan, **_: 0.9 * plan.duration)
    with coarse_grids():
        yield


def planned(folder: Path, cell: str, judge: Judge | None = None) -> tuple[Judged, Judged]:
    """The stream and the RAPID plan."""
    text = TEXT if cell is RAILED else TEXT.replace("[100,", "[9E9,").replace("[0,9E9", "[9E9,9E9")
    (folder / "t.mod").write_text(text)
    (folder / "t.yaml").write_text(cell)
    job, kept = read_job([folder / "t.mod"]), {target: RowsFile() for target in Target}
    with pytest.MonkeyPatch.context() as patch:
        if judge is not None:
            patch.setattr(planning, "judge", judge)
        changes, asked = may_change(job, Loops.KEEP).changes, dict.fromkeys(Target, LEAST_TIME)
        answers, _, _ = plan_all(job, lambda *_: None, Clock(), changes, Patience(), 1, asked, kept)
    stream, rapid = answers[Target.STREAM], answers[Target.RAPID]
    assert isinstance(stream, Judged)
    assert isinstance(rapid, Judged)
    return stream, rapid


def lengths(judged: Judged) -> np.ndarray:
    return np.array([motion.t_1 - motion.t_0 for motion in judged.plan.motions])


def middle(judged: Judged, motion: int) -> float:
    one = judged.plan.motions[motion]
    return (one.t_0 + one.t_1) / 2


def test_the_leg_that_is_refused_is_driven_slower_by_what_is_over_its_limit(tmp_path: Path) -> None:
    """Without a rail every stop is a rest. Red where the whole plan falls back or is slowed, and where nothing is."""
    found, _ = planned(tmp_path, FIXED)
    judge = Judge(1, middle(found, LINE), 3.03, 3.0)
    stream, rapid = planned(tmp_path, FIXED, judge)
    assert len(judge.texts) == 1
    times = np.ones(len(stream.plan.motions))
    times[LINE] = 1.01
    np.testing.assert_allclose(lengths(stream), times * lengths(found), rtol=1e-9)
    assert stream.report.legal
    assert stream.plan.duration < rapid.plan.duration
    note = next(one for one in stream.plan.notes if "slower there" in one)
    assert "t.mod:7:" in note
    assert f"{100 * (stream.plan.duration / found.plan.duration - 1):.2g} % of the cycle" in note
    assert "joint_1 acceleration" in note
    assert stream.plan.lower_bound == pytest.approx(0.9 * found.plan.duration)


def test_a_leg_that_is_refused_again_is_driven_slower_again(tmp_path: Path) -> None:
    """By 1 %, 2 % and 4 %: the judge tells no excess that shrinks."""
    found, _ = planned(tmp_path, FIXED)
    stream, _ = planned(tmp_path, FIXED, Judge(3, middle(found, LINE), 3.03, 3.0))
    assert lengths(stream)[LINE] == pytest.approx(1.01 * 1.02 * 1.04 * lengths(found)[LINE], rel=1e-9)


def test_a_rest_that_is_refused_is_not_judged_again_as_it_is(tmp_path: Path) -> None:
    found, _ = planned(tmp_path, FIXED)
    judge = Judge(99, middle(found, WAIT), 3.03, 3.0)
    stream, rapid = planned(tmp_path, FIXED, judge)
    assert len(judge.texts) == len(set(judge.texts)) < 3
    assert stream.plan.duration == pytest.approx(rapid.plan.duration)


@pytest.mark.long
def test_legs_that_are_entered_in_motion_are_solved_again_with_less_of_every_limit(tmp_path: Path) -> None:
    """Twice 1 % less: up to 1 / 0.98 times as long. Red where the first legal motion or the RAPID plan comes."""
    found, _ = planned(tmp_path, RAILED)
    stream, rapid = planned(tmp_path, RAILED, Judge(1, middle(found, LAST), 3.03, 3.0))
    assert 1 + 1e-4 < lengths(stream)[LAST] / lengths(found)[LAST] < 1 / 0.98
    np.testing.assert_allclose(lengths(stream)[:LINE], lengths(found)[:LINE], rtol=1e-6)
    assert found.plan.duration < stream.plan.duration < rapid.plan.duration
    assert stream.report.legal


@pytest.mark.long
def test_what_driving_slower_is_no_cure_for_has_the_first_legal_motion(tmp_path: Path) -> None:
    """Too short a wait, say. Red where the RAPID plan comes without the stream's own first motion being judged."""
    found, _ = planned(tmp_path, RAILED)
    judge = Judge(1, middle(found, LINE), 0.29, 0.3)
    stream, _ = planned(tmp_path, RAILED, judge)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(IMPROVED, as_it_comes)
        first, _ = planned(tmp_path, RAILED)
    np.testing.assert_allclose(lengths(stream), lengths(first), rtol=1e-9)
    assert stream.plan.duration > found.plan.duration
    said = f"the plan is the first legal one: the faster one, of {found.plan.duration:.3f} s, is not legal"
    assert any(note.startswith(said) for note in stream.plan.notes)


@pytest.mark.long
@pytest.mark.parametrize(("value", "least", "most"), [(3.03, 3, 8), (2.9, 2, 2)])
def test_what_is_refused_whatever_is_tried_falls_back_and_says_what_is_lost(
    tmp_path: Path, value: float, least: int, most: int
) -> None:
    """In a wait up to six times with less of every limit, then the first legal motion; each has rows of its own."""
    found, _ = planned(tmp_path, RAILED)
    judge = Judge(99, middle(found, WAIT), value, 3.0)
    stream, rapid = planned(tmp_path, RAILED, judge)
    assert least <= len(judge.texts) == len(set(judge.texts)) <= most
    assert stream.plan.duration == pytest.approx(rapid.plan.duration)
    assert stream.report.legal
    assert stream.plan.notes[0].startswith("the plan is the rapid plan: the stream plan that was found is not legal")
    assert f"this one takes {rapid.plan.duration:.3f} s" in stream.plan.notes[0]
    assert any(f"the faster one, of {found.plan.duration:.3f} s" in note for note in stream.plan.notes)
