"""What optimize says of lines that should keep their programmed speed."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from trajopt_cli.cli import run
from trajopt_cli.cli.tables import speed_lines
from trajopt_cli.motion import Source
from trajopt_cli.problem.constant_speed import Dip, Stretch, Why

BEAD = """MODULE Bead
    CONST robtarget p:=[[450,-50,500],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        ConfJ \\Off;
        ConfL \\Off;
        MoveJ p, v1000, fine, tool0;
        weld;
    ENDPROC
    PROC weld()
        MoveL Offs(p,0,60,0), v200, fine, tool0;
        MoveL Offs(p,0,100,0), v100, fine, tool0;
    ENDPROC
ENDMODULE
"""
CELL = 'robot: irb140\nstart: {joints: "[0, 0, 0, 0, 60, 0] deg"}\n'


@pytest.fixture
def bead(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bead.mod").write_text(BEAD, encoding="utf-8")
    (tmp_path / "bead.yaml").write_text(CELL + "constant_speed: [weld]\n", encoding="utf-8")
    return tmp_path / "bead.mod"


@pytest.mark.usefixtures("unrefined")
def test_dips_are_told_with_place_depth_and_cause(bead: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["optimize", "bead.mod", "--target", "rapid"]) == 0
    lines = capsys.readouterr().out.splitlines()
    first = next(i for i, line in enumerate(lines) if line.startswith("constant speed (rapid): 100.0 mm in 1 stretch,"))
    assert "kept within 1 % but for 3 dips of " in lines[first]
    up, stop, down = lines[first + 1 : first + 4]
    assert up.startswith("  bead.mod:10 MoveL Offs(p,0,60,0) at 0.0 mm: 0 of 200 mm/s (−100 %), for 0.")
    assert ": run-up from rest, " in up
    assert stop.startswith("  bead.mod:10 MoveL Offs(p,0,60,0) at 60.0 mm: 0 of 200 mm/s (−100 %), for 0.")
    assert ": stop programmed there (fine), " in stop
    assert down.startswith("  bead.mod:11 MoveL Offs(p,0,100,0) at 40.0 mm: 0 of 100 mm/s (−100 %), for 0.")
    assert ": run-down to rest, " in down
    plans = json.loads(Path("results/bead/summary.json").read_text())["plans"]
    for plan in plans.values():
        (stretch,) = plan["constant_speed"]
        assert stretch["length_m"] == pytest.approx(0.1, abs=1e-5)
        assert [dip["why"] for dip in stretch["dips"]] == ["run_up", "stop", "run_down"]
        assert sum(dip["length_m"] for dip in stretch["dips"]) < 0.05
        times = [(dip["start_s"], dip["start_s"] + dip["time_s"]) for dip in stretch["dips"]]
        assert times == sorted(times)


def test_parse_shows_what_should_keep_its_speed(bead: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["parse", "bead.mod"]) == 0
    assert capsys.readouterr().out.count("constant speed") == 2
    assert run(["parse", "bead.mod", "--json"]) == 0
    motions = json.loads(capsys.readouterr().out)["motions"]
    assert [one["constant_speed"] for one in motions] == [False, True, True]


def dip(line: int, why: Why = Why.LIMIT, duration: float = 0.1) -> Dip:
    place = Source("x/m.mod", line, 1)
    return Dip(
        index=line, source=place, name="MoveL p", along=0.0123, programmed=0.1, lowest=0.061, highest=0.08, start=1.0,
        duration=duration, length=0.004, why=why, detail="", limit="joint_5 speed", used=1.0,
        beside="beside the wrist singularity",
    )  # fmt: skip


def test_one_line_for_each_place_and_no_more_than_ten() -> None:
    assert [*speed_lines("stream", ())] == []
    held = Stretch(0, 3, 0.0, 1.0, 0.25, ())
    assert [*speed_lines("stream", (held, held))] == [
        "constant speed (stream): 500.0 mm in 2 stretches, kept within 1 %"
    ]
    twice = replace(held, dips=(dip(7), dip(7, duration=0.2), dip(8, Why.SHORT)))
    head, first, second = speed_lines("stream", (twice,))
    assert head.endswith("kept within 1 % but for 3 dips of 12.0 mm and 0.400 s")
    assert first == (
        "  m.mod:7 MoveL p at 12.3 mm: 61 of 100 mm/s (−39 %), for 0.200 s and 4.0 mm: "
        "limited by joint_5 speed, beside the wrist singularity (once more)"
    )
    assert second.startswith("  m.mod:8 MoveL p at 12.3 mm: reaches 80 of 100 mm/s, for 0.100 s and 4.0 mm: too short")
    many = replace(held, dips=tuple(dip(line) for line in (*range(1, 12), 11, 12)))
    lines = [*speed_lines("rapid", (many,))]
    assert (len(lines), lines[-1]) == (12, "  and 3 more, all in summary.json")
