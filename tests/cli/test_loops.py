"""`optimize` on programs with loops and routines, as a person runs it."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from unrefined import coarse_search, rapid_alone

from trajopt_cli.cli import run
from trajopt_cli.job import read_job
from trajopt_cli.pipeline import planning
from trajopt_cli.pipeline.planning import changes_of, may_change
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.plan import Target

CELL = (Path(__file__).parents[2] / "programs" / "hinge_cell.yaml").read_text(encoding="utf-8")
DATA = """MODULE work
    CONST jointtarget j_home:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_pick:=[[500,700,380],[0,0,1,0],[0,0,0,0],[700,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_left:=[[500,0,400],[0,0,1,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_right:=[[500,1700,400],[0,0,1,0],[0,0,0,0],[1700,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_place{2}:=[
        [[500,0,400],[0,0,1,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]],
        [[500,1700,400],[0,0,1,0],[0,0,0,0],[1700,9E9,9E9,9E9,9E9,9E9]]];
"""
LOOP = """    PROC main()
        FOR i FROM 1 TO 2 DO
            MoveJ p_place{i}, v7000, fine, tool0;
            MoveJ p_pick, v7000, fine, tool0;
            MoveJ p_place{i}, v7000, fine, tool0;
        ENDFOR
        MoveAbsJ j_home, v7000, fine, tool0;
    ENDPROC
ENDMODULE
"""
ROUTINE = """    PROC main()
        serve p_left;
        serve p_right;
        MoveAbsJ j_home, v7000, fine, tool0;
    ENDPROC
    PROC serve(robtarget p)
        MoveJ p, v7000, fine, tool0;
        MoveJ p_pick, v7000, fine, tool0;
        MoveJ p, v7000, fine, tool0;
    ENDPROC
ENDMODULE
"""
# No cap of the tool binds, which takes less time to find.
FREE = re.sub("tcp: .*", "tcp: {speed: 9, acceleration: 90, source: none}", CELL)
NUMBER = re.compile(r"-?\d+(\.\d+)?")


@pytest.mark.parametrize("body", [LOOP, ROUTINE], ids=["loop", "routine"])
def test_loops_stay_unless_they_are_unrolled(
    body: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The pick is best served from the left when it comes from there and goes there, and from the right likewise: a
    FOR loop takes both from an array, a routine needs a copy."""
    monkeypatch.chdir(tmp_path)
    rapid_alone(monkeypatch)  # a stream has no loops
    monkeypatch.setattr(planning, "as_written", lambda *_: "not asked")
    coarse_search(monkeypatch)  # the saving is far larger than what that misses
    Path("work.mod").write_text(DATA + body, encoding="utf-8")
    Path("work.yaml").write_text(FREE, encoding="utf-8")
    times = {}
    for loops in ("unroll", "keep"):
        assert run(["optimize", "work.mod", "--loops", loops, "--output", loops, "--jobs", "1"]) == 0
        times[loops] = json.loads(Path(loops, "summary.json").read_text())["plans"]["rapid"]["cycle_time_s"]
        assert json.loads(Path(loops, "run.json").read_text())["options"]["loops"] == loops
    said = " ".join(capsys.readouterr().out.split())
    found = re.findall(r"--loops unroll would save about (\d\.\d\d) s \(.*?\) more, by an estimate", said)
    unroll, keep = (Path(name, "program.mod").read_text(encoding="utf-8") for name in ("unroll", "keep"))
    if body is LOOP:
        assert (times["unroll"], unroll, found) == (times["keep"], keep, [])
        assert keep.count("FOR i FROM 1 TO 2 DO") == 1
        assert "MoveJ RailAt(p_pick,rail_pick{i}" in keep
        return
    assert times["unroll"] < times["keep"] - 0.1
    assert float(found[0]) == pytest.approx(times["keep"] - times["unroll"], abs=0.1)
    assert "        serve p_left;\n        serve_2 p_right;\n" in unroll
    given, kept = (DATA + body).splitlines(), keep.splitlines()
    changed = [i for i, (one, other) in enumerate(zip(given, kept, strict=True)) if one != other]
    assert changed
    assert max(changed) < len(DATA.splitlines())
    assert [NUMBER.sub("#", line) for line in given] == [NUMBER.sub("#", line) for line in kept]


def test_routines_that_cannot_be_driven_as_they_are_get_copies_and_that_is_said(tmp_path: Path) -> None:
    """The routine serves two rail positions, so it leaves its confdata as programmed, and one is out of reach."""
    wrong = DATA.replace("[[500,0,400],[0,0,1,0],[0,0,0,0]", "[[500,0,400],[0,0,1,0],[1,0,1,0]")
    (tmp_path / "work.mod").write_text(wrong + ROUTINE, encoding="utf-8")
    (tmp_path / "work.yaml").write_text(CELL, encoding="utf-8")
    job = read_job(tmp_path / "work.mod")
    agreed = may_change(job, Loops.KEEP)
    assert agreed.infeasible is None
    assert agreed.loops is Loops.UNROLL
    assert agreed.changes[Target.RAPID] == changes_of(job, Target.RAPID, Loops.UNROLL)
    (notice,) = agreed.notices
    assert notice.startswith("routines have copies as with --loops unroll, as without them no plan could be driven: ")
    assert "work.mod:15:9: MoveJ p cannot be reached" in notice
    assert "confdata [1,0,1,0]" in notice

    (tmp_path / "work.mod").write_text(DATA + ROUTINE, encoding="utf-8")
    kept = may_change(read_job(tmp_path / "work.mod"), Loops.KEEP)
    assert (kept.loops, kept.notices, kept.infeasible) == (Loops.KEEP, (), None)
