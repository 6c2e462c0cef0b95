"""`trajopt place` as people type it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from trajopt_cli.cell.loader import load_cell
from trajopt_cli.cli import run
from trajopt_cli.runs.folder import PLACE, read_run
from trajopt_cli.study.answers import study_record
from trajopt_cli.yaml_file import with_value

TEXT = """MODULE Tiny
    CONST jointtarget j_home:=[[0,0,0,0,90,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_in:=[[560,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        MoveJ p_in, v1000, fine, tool0;
        MoveAbsJ j_home, v1000, fine, tool0;
    ENDPROC
ENDMODULE
"""
CELL = "# mine\nrobot: irb140\nstart: {joints: '[0, 0, 0, 0, 90, 0] deg'}  # home\n"


@pytest.fixture
def tiny(program: Path) -> Path:
    program.write_text(TEXT)
    Path("tiny.yaml").write_text(CELL)
    return program


def test_the_answer_stands_in_a_table_in_json_in_a_folder_and_in_a_cell_file(
    tiny: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("trajopt_cli.study.place.FEW", 1)  # of many places that may be good one is planned whole
    asked = ["place", str(tiny), "--what", "base", "--range", "x=0..60mm", "--target", "rapid", "--points", "4"]
    assert run([*asked, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    folder = read_run(Path("results/tiny_place"), study_record(PLACE))
    assert json.loads(folder.contents["place.json"]) == found
    assert folder.contents["input/tiny.mod"] == tiny.read_bytes()
    assert {"plots/place_rapid.svg", "plots/place_rapid.png", "changed.yaml"} < set(folder.contents)
    assert found["gained_s"] == found["present"]["cycle_time_s"] - found["best"]["cycle_time_s"] > 0
    assert found["best"]["cycle_time_s"] == min(
        one["cycle_time_s"] for one in found["places"] if one["cycle_time_s"] is not None
    )
    x = found["best"]["offset"]["x"]
    assert 0 < x <= 0.06
    # as people read it, and with a cell file to go on with
    assert run([*asked, "--apply", "there.yaml", "--jobs", "1"]) == 0
    out = capsys.readouterr().out
    lines = out.splitlines()
    assert lines[0].rstrip() == "tiny.mod, rapid: where the robot's base stands"
    best = next(line for line in lines if line.startswith("best")).split()
    assert [float(best[1]), float(best[2])] == pytest.approx([1e3 * x, found["best"]["cycle_time_s"]], abs=6e-4)
    assert f"base: {{position: [{x:g}, 0, 0]}}" in lines
    assert any(line.startswith(f"{found['tried']} places tried, {found['planned']} of them planned") for line in lines)
    assert ("the best place lies at the end of the range of x: a wider one may gain more" in lines) == (x == 0.06)
    assert load_cell("there.yaml").X_WB[:3, 3] == pytest.approx([x, 0, 0])
    assert Path("there.yaml").read_text().replace(f"base: {{position: [{x:g}, 0, 0]}}\n", "") == CELL


def test_ranges_in_which_nothing_can_be_done_are_one_line(tiny: Path, capsys: pytest.CaptureFixture[str]) -> None:
    asked = ["place", str(tiny), "--what", "base", "--range", "x=2..3", "--points", "4", "--jobs", "1"]
    assert run([*asked, "--quiet"]) == 1
    error = capsys.readouterr().err
    assert error.count("\n") == 1
    assert error.startswith(
        "the robot's base: none of 5 places can be done; the nearest, x +2000 mm: tiny.mod:6:9: MoveJ"
    )
    assert not Path("results").exists()


@pytest.mark.parametrize(
    ("text", "keys", "expected"),
    [
        ("a: 1 # one\nb: 2\n", ("a",), "a: {} # one\nb: 2\n"),
        ("r:\n  f:\n    p: [0,\n     1]  # c\n  # more\ns: 3\n", ("r", "f"), "r:\n  f:\n    {}  # c\n  # more\ns: 3\n"),
        ("r: {e: a, s: [0, 1]}  # c\n", ("r", "f"), "r: {e: a, s: [0, 1], f: {}}  # c\n"),
        ("# c\nr:\n    e: a\n", ("r", "f"), "# c\nr:\n    f: {}\n    e: a\n"),
    ],
)
def test_one_value_of_a_yaml_text_changes_and_nothing_else(text: str, keys: tuple[str, ...], expected: str) -> None:
    assert with_value(text, "a.yaml", keys, "{}") == expected
