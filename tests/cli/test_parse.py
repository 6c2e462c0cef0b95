"""trajopt parse as a person and as a program use it: table, sums and notes, JSON, template, errors."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from trajopt_cli.cli import listing, run

REPOSITORY = Path(__file__).parents[2]
CELL = "robot: irb140\nstart: {joints: '[0, 0, 0, 0, 30, 0] deg'}\n"
POINT = "[[{0}],[0,0,1,0],[0,{1},{2},{3}],[9E9,9E9,9E9,9E9,9E9,9E9]]"

# One of everything: settings, an arc, a process move, events, zones, waits, outputs.
EVERYTHING = """MODULE Everything
    CONST robtarget p_a:=[[450,0,647],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_b:=[[450,100,647],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_c:=[[400,50,647],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j_a:=[[10,20,0,0,30.1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST speeddata vMine:=[0.1,90,5000,1000];

    PROC main()
        MoveAbsJ j_a, v1000, fine, tool0;
        MoveJ p_a, vMine, z50, tool0;
        MoveL p_b, v100\\T:=2.5, z50, tool0;
        AccSet 50, 80;
        ConfL\\Off;
        MoveC p_c, p_a, v100, fine, tool0;
        MoveLDO p_b, v100, z10, tool0, doGlue, 1;
        WaitTime 0.25;
        WaitDI di_ready, 1;
        SetDO doGlue, 0;
        TPWrite "done";
    ENDPROC
ENDMODULE
"""


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def write(name: str, text: str) -> None:
    Path(name).write_text(text, encoding="utf-8")


def printed(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    assert run(["parse", *arguments]) == 0
    return capsys.readouterr().out


def record(capsys: pytest.CaptureFixture[str], *arguments: str) -> dict[str, Any]:
    def never(constant: str) -> None:
        raise AssertionError(f"{constant} is no JSON")

    found: dict[str, Any] = json.loads(printed(capsys, *arguments, "--json"), parse_constant=never)
    return found


# ----------------------------------------------------------------------------------------------------------- the table


def row(text: str, line: int) -> str:
    (found,) = [one for one in text.splitlines() if one.startswith(f"e.mod:{line} ")]
    return re.sub(r"  +", "  ", found)


def test_each_motion_is_a_row_with_what_it_has(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write("e.mod", EVERYTHING)
    text = printed(capsys, "e.mod")
    conf = "0,0,0,0  tool0  wobj0  0 0 1 0"
    assert row(text, 9) == "e.mod:9  MoveAbsJ  j_a  10 20 0 0 30.1 0  v1000  fine  tool0"
    assert row(text, 10) == f"e.mod:10  MoveJ  p_a  450 0 647  vMine [0.1,90,5000,1000]  z50  {conf}"
    assert row(text, 11) == f"e.mod:11  MoveL  p_b  450 100 647  v100 in 2.5 s  z50  {conf}  100"
    arc = f"e.mod:14  MoveC  p_a  450 0 647  v100  fine  {conf}  400 50 647  157.08  ConfL Off, AccSet 50 80"
    assert row(text, 14) == arc
    glue = f"e.mod:15  MoveLDO  p_b  450 100 647  v100  z10, stops here  {conf}  100  doGlue=1 at the end"
    assert row(text, 15) == f"{glue}  ConfL Off, AccSet 50 80"
    assert row(text, 16) == "e.mod:16  WaitTime  0.25 s"
    assert row(text, 17) == "e.mod:17  WaitDI  di_ready = 1  at least 0 s"
    assert row(text, 18) == "e.mod:18  SetDO  doGlue  = 0"
    below = text.split("\n\n")[-1].splitlines()
    assert below[0] == "8 motions, 200.0 mm of lines and 157.1 mm of arcs with a known start"
    assert "no effect on motion: TPWrite 1" in below
    assert "3 fly-by zones, planned as corners where the point is passed" in below
    assert below[-1] == "configurations not checked: no cell file"


def test_the_robot_adds_what_only_it_knows(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write("e.mod", EVERYTHING)
    write("e.yaml", CELL)
    below = printed(capsys, "e.mod").split("\n\n")[-1].splitlines()
    assert "confdata is ignored on lines (ConfL \\Off), as the program asks" in below
    assert "AccSet's ramp (2) does not affect the plan: it shapes jerk, which the cell file alone limits" in below
    assert not any("refuse" in line for line in below)
    assert below[-1] == "configurations: every point and line fits the robot"
    locked = EVERYTHING.replace("MoveC", "SingArea \\LockAxis4;\n        MoveC", 1)
    write("locked.mod", locked)
    write("locked.yaml", CELL)
    assert "optimize will refuse this program: SingArea" in printed(capsys, "locked.mod")
    write("line.mod", EVERYTHING.replace("MoveJ p_a", "MoveL p_a"))
    assert "with a known start, 1 without" in printed(capsys, "line.mod")
    write("line.yaml", CELL)
    assert "with a known start\n" in printed(capsys, "line.mod")


@pytest.mark.parametrize("width", [60, 80, 120, 200])
def test_nothing_is_lost_and_nothing_sticks_out_in_a_narrow_terminal(
    here: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, width: int
) -> None:
    write("e.mod", EVERYTHING)
    wide = printed(capsys, "e.mod")
    monkeypatch.setattr(listing, "terminal_width", lambda: width)
    text = printed(capsys, "e.mod")
    table = text.rpartition("\n\n")[0]
    assert max(map(len, table.splitlines())) <= width
    words, kept = (set(re.findall(r"[\w.=-]+", one)) for one in (wide.rpartition("\n\n")[0], table))
    assert words - kept <= {"w", "x", "y", "z", "orientation", "by", "way", "of", "ext", "axes"}  # of headings
    for line in range(9, 19):
        if line not in (12, 13):
            assert sum(one.startswith(f"e.mod:{line} ") for one in table.splitlines()) == 1


def test_what_is_the_same_for_every_move_is_said_once_where_room_is_short(
    here: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    write("e.mod", EVERYTHING)
    monkeypatch.setattr(listing, "terminal_width", lambda: 110)
    text = printed(capsys, "e.mod")
    assert "\nevery move: conf 0,0,0,0, tool tool0, wobj wobj0, orientation w x y z 0 0 1 0\n" in text
    assert text.count("wobj0") == 1


def test_where_the_rail_stands_meanwhile_is_in_brackets(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    points = [POINT.format("450,0,647", 0, 0, 0).replace("[9E9,9E9", f"[{eax}") for eax in ("9E9,7", "300,8", "9E9,9")]
    moves = "\n".join(f"MoveJ {point},v100,fine,tool0;" for point in points)
    write("r.mod", f"MODULE M\nPROC main()\n{moves}\nENDPROC\nENDMODULE\n")
    assert [one["extax_kept"] for one in record(capsys, "r.mod")["motions"]] == [None] * 3
    rail = "rail: {eax: a, stroke: [-0.2, 2.2]}\nlimits: {rail: {acceleration: 1, source: 'a test'}}\n"
    write("r.yaml", f"robot: irb140_rail\n{rail}start: {{joints: '[0, 0, 0, 0, 30, 0] deg', rail: 0.2}}\n")
    open_ = [None] * 5
    assert [one["extax_kept"] for one in record(capsys, "r.mod")["motions"]] == [[200, *open_], None, [300, *open_]]
    lines = printed(capsys, "r.mod").splitlines()
    rows = [re.split(r"  +", line) for line in lines if line.startswith("r.mod:") and "MoveJ" in line]
    assert [row[7] for row in rows] == ["(200) 7", "300 8", "(300) 9"]
    (warning,) = [line for line in lines if line.startswith("warning: ")]
    said = "r.mod:3:1: 2 targets give no position for the rail (9E9 on axis a): a controller stops, a plan stays"
    assert warning == f"warning: {said}"


def test_a_corner_that_is_cut_says_how_much_is_left(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Three lines of 23.12 mm, two whole zones of 20 mm between them: 11.56 mm each."""
    moves = [f"MoveL {POINT.format(f'{450 + 23.12 * i},0,647', 0, 0, 0)},v100,z20,tool0;" for i in range(4)]
    write("z.mod", "\n".join(["MODULE M", "PROC main()", *moves, "ENDPROC", "ENDMODULE"]))
    lines = [re.split(r"  +", line) for line in printed(capsys, "z.mod").splitlines() if "MoveL" in line]
    assert [line[5] for line in lines] == ["z20", "z20, 11.6 mm", "z20, 11.6 mm", "z20, stops here"]


def test_what_did_not_run_is_told(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    routines = "PROC Sub()\nWaitTime 1;\nENDPROC\nPROC Tot()\nSub;\nENDPROC\nFUNC num f()\nRETURN 1;\nENDFUNC\n"
    write("u.mod", f"MODULE M\nPROC main()\nSub;\nENDPROC\n{routines}ENDMODULE\n")
    assert "\nnot run: PROC Tot, FUNC f (names in them are not checked)\n" in printed(capsys, "u.mod")
    assert record(capsys, "u.mod")["uncalled"] == ["PROC Tot", "FUNC f"]
    write("all.mod", "MODULE M\nPROC main()\nWaitTime 1;\nENDPROC\nENDMODULE\n")
    assert "not run" not in printed(capsys, "all.mod")
    more = "".join(f"PROC p{i}()\nENDPROC\n" for i in range(12))
    write("all.mod", f"MODULE M\nPROC main()\nENDPROC\n{more}ENDMODULE\n")
    assert "PROC p9 and 2 more (names in them are not checked)" in printed(capsys, "all.mod")


def test_a_program_that_moves_nothing_names_what_would(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Moves of called procedures count; a procedure with arguments cannot be started."""
    moves = f"MoveJ {POINT.format('450,0,647', 0, 0, 0)},v100,fine,tool0;\n"
    paths = f"PROC Path_10()\n{moves * 3}ENDPROC\nPROC One()\n{moves}Idle;\nENDPROC\n"
    more = f"PROC All()\nPath_10;\nOne;\nEND_;\nENDPROC\nPROC END_()\nAll;\nENDPROC\nPROC At(num n)\n{moves}ENDPROC\n"
    text = f"MODULE M\nPROC main()\nIdle;\nENDPROC\nPROC Idle()\nENDPROC\n{paths}{more}ENDMODULE\n"
    write("n.mod", text)
    said = "main moves nothing when run; other procedures that can be started (--entry): "
    said += "Path_10 (3 moves), One (1 move), All (4 moves), END_ (4 moves)"
    title, empty, sums, told, *_ = printed(capsys, "n.mod").splitlines()  # no head of a table that is empty
    assert (title[:6], empty, sums) == ("n.mod:", "", "0 motions, 0.0 mm of lines with a known start")
    assert told == said
    write("n.yaml", CELL)
    assert run(["optimize", "n.mod"]) == 2
    assert f"n.mod: {said}; signal values" in capsys.readouterr().err


def test_signals_are_listed_as_the_program_spells_them(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    point = POINT.format("450,0,647", 0, 0, 0)
    code = f"TriggIO tg,0\\DOp:=doCut,1;\nTriggL {point},v100,tg,fine,tool0;\nSet dogreifer;\nReset doGreifer;\n"
    write("s.mod", f"MODULE M\nVAR triggdata tg;\nPROC main()\n{code}ENDPROC\nENDMODULE\n")
    cut, first, second = record(capsys, "s.mod")["motions"]
    assert [event["name"] for event in cut["events"]] == ["doCut"]
    assert (first["target"], second["target"]) == ("dogreifer", "dogreifer")  # one signal, one spelling


def test_below_the_table_places_are_as_short_as_in_it(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    point = POINT.format("450,0,647", 0, 2, 0)
    text = f"MODULE {{}}\nPROC {{}}()\nMoveJ {point},v100,fine,tool0;\nENDPROC\nENDMODULE\n"
    for name in ("a", "b"):
        Path(name).mkdir()
    write("a/one.mod", text.format("A", "main"))
    write("b/two.mod", text.format("B", "other"))
    write("cell.yaml", CELL)
    paths = [str(here / "a/one.mod"), str(here / "b/two.mod"), "--cell", "cell.yaml"]
    last = printed(capsys, *paths).splitlines()[-1]
    assert last.startswith("  one.mod:3:1: MoveJ ")
    (here / "b/two.mod").rename(here / "b/one.mod")  # the name alone does not tell which
    paths[1] = str(here / "b/one.mod")
    assert printed(capsys, *paths).splitlines()[-1].startswith(f"  {here / 'a/one.mod'}:3:1: MoveJ ")


def test_columns_that_nothing_fills_are_left_out(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write("w.mod", "MODULE W\nPROC main()\nWaitTime 1;\nENDPROC\nENDMODULE\n")
    lines = printed(capsys, "w.mod").splitlines()
    assert lines[2].split() == ["place", "instruction", "to"]
    assert lines[4] == "w.mod:3  WaitTime     1 s"
    assert "configurations" not in lines[-1]  # there are none


def test_a_long_expression_is_cut_in_the_table_and_whole_in_json(
    here: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    long = POINT.format("450.000000,0.000000,647.000000", 0, 0, 0)
    write("m.mod", f"MODULE M\nPROC main()\nMoveJ {long},v100,fine,tool0;\nENDPROC\nENDMODULE\n")
    assert re.search(r"m\.mod:3 +MoveJ +\[\[450\.000000,0\.000000…\S*9E9,9E9\]\] ", printed(capsys, "m.mod"))
    assert record(capsys, "m.mod")["motions"][0]["target"] == long


def test_findings_of_a_statement_in_a_loop_are_told_once(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    point = POINT.format("450,0,647", 0, 2, 0)
    text = "MODULE M\nPROC main()\nFOR i FROM 1 TO 3 DO\nMoveJ Offs({0},i,0,0),v100,fine,tool0;\nENDFOR\n"
    write("m.mod", f"{text.format(point)}ENDPROC\nENDMODULE\n")
    write("m.yaml", CELL)
    lines = printed(capsys, "m.mod").splitlines()
    assert lines[-2] == "configurations: 3 motions do not fit the robot"
    assert lines[-1].startswith("  m.mod:4:1: MoveJ Offs([[450,0,647]")
    assert lines[-1].endswith(" (and 2 more passes)")


def test_many_findings_are_counted_and_json_has_them_all(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    moves = "\n".join(f"MoveJ {POINT.format(f'{450 + i},0,647', 0, 2, 0)},v100,fine,tool0;" for i in range(30))
    write("m.mod", f"MODULE M\nPROC main()\n{moves}\nENDPROC\nENDMODULE\n")
    write("m.yaml", CELL)
    lines = printed(capsys, "m.mod").splitlines()
    assert sum("cannot be reached in confdata" in line for line in lines) == 20
    assert lines[-1] == "  and 10 more; --json lists them all"
    assert len(record(capsys, "m.mod")["configurations"]) == 30


# ------------------------------------------------------------------------------------------------------------ the JSON


def documented(heading: str) -> set[str]:
    """The keys in the first table under a heading of docs/parse-json.md."""
    text = (REPOSITORY / "docs/parse-json.md").read_text(encoding="utf-8").split(f"# {heading}\n", 1)[1]
    table = text.split("| key |", 1)[1].split("\n\n", 1)[0]
    rows = [line.split("|")[1] for line in table.splitlines()[2:]]
    return {key for row in rows for key in re.findall(r"`(\w+)`", row)}


def test_every_key_is_documented_and_none_besides(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write("e.mod", EVERYTHING.replace("MoveJ p_a,", "MoveJ " + POINT.format("450,0,647", 0, 2, 0) + ","))
    write("e.yaml", CELL)
    found = record(capsys, "e.mod")
    assert set(found) == documented("The object")
    assert {frozenset(motion) for motion in found["motions"]} == {frozenset(documented("A motion"))}
    (finding,) = found["configurations"]
    assert set(finding) == documented("A configuration finding")
    (event,) = [event for motion in found["motions"] for event in motion["events"]]
    assert set(event) == documented("`events`")
    assert {key for motion in found["motions"] for key in motion["settings"]} <= documented("`settings`")
    assert found["schema"] == 1


def test_numbers_show_no_noise_of_32_bits(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write("e.mod", EVERYTHING)
    motions = record(capsys, "e.mod")["motions"]
    assert motions[0]["joints"] == [10.0, 20.0, 0.0, 0.0, 30.1, 0.0]
    assert [motions[1][key] for key in ("v_tcp", "v_ori", "v_leax", "v_reax")] == [0.1, 90.0, 5000.0, 1000.0]
    assert motions[2]["duration"] == 2.5
    assert motions[3]["via"] == [400.0, 50.0, 647.0]
    assert motions[3]["settings"] == {"ConfL": "Off", "AccSet": [50.0, 80.0]}
    assert "-0.0" not in printed(capsys, "e.mod", "--json")


def test_without_a_cell_file_configurations_are_unknown_not_fine(
    here: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write("e.mod", EVERYTHING)
    assert record(capsys, "e.mod")["configurations"] is None
    write("e.yaml", CELL)
    assert record(capsys, "e.mod")["configurations"] == []


def test_each_motion_is_a_line_of_the_json(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write("e.mod", EVERYTHING)
    lines = printed(capsys, "e.mod", "--json").splitlines()
    assert [json.loads(line.strip().rstrip(","))["index"] for line in lines if line.startswith('    {"index"')] == [
        *range(8)
    ]


# -------------------------------------------------------------------------------------------- what the program lacks

ASKING = """MODULE Asking
    CONST robtarget p:=[[450,0,647],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        IF di_left = 1 MoveJ p, v100, fine, tool0;
        IF di_right = 1 OR di_left = 1 MoveJ p, v100, fine, tool0;
    ENDPROC
ENDMODULE
"""


def test_what_lacks_is_named_once_each_and_the_template_is_offered(
    here: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write("a.mod", ASKING)
    assert run(["parse", "a.mod"]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    *lines, last = captured.err.splitlines()
    assert re.findall(r"^a\.mod:\d+:\d+:", "\n".join(lines), re.MULTILINE) == ["a.mod:4:12:", "a.mod:5:12:"]
    assert last == "'trajopt parse a.mod --scenario-template' prints the lines missing from the cell file"


def test_the_template_makes_the_program_run(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write("a.mod", ASKING)
    text = printed(capsys, "a.mod", "--scenario-template")
    assert re.findall(r"^  (\w+): 0", text, re.MULTILINE) == ["di_left", "di_right"]
    write("a.yaml", CELL + text)
    assert "0 motions" in printed(capsys, "a.mod")
    assert run(["parse", "a.mod", "--scenario-template"]) == 0
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err == "nothing is missing: the program runs with this cell file\n"


def test_a_run_that_ends_in_an_error_still_tells_what_lacks(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = ASKING.replace("IF di_left = 1 MoveJ p, v100, fine, tool0;", "WHILE di_left = 0 DO WaitTime -1; ENDWHILE")
    write("a.mod", text)
    assert run(["parse", "a.mod"]) == 2
    lines = capsys.readouterr().err.splitlines()
    assert lines[0].startswith("a.mod:4:15: 'di_left' is not declared")
    assert any("WaitTime -1 s must not be negative" in line for line in lines)
    assert lines[-1].endswith("--scenario-template' prints the lines missing from the cell file")
    assert "di_left: 0" in printed(capsys, "a.mod", "--scenario-template")


def test_other_errors_offer_no_template(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write("a.mod", ASKING.replace("di_left = 1", "TRUE").replace("di_right = 1", "di_left ="))
    for arguments in (["parse", "a.mod"], ["parse", "a.mod", "--scenario-template"]):
        assert run(arguments) == 2
        captured = capsys.readouterr()
        assert captured.err.startswith("a.mod:5:")
        assert "--scenario-template" not in captured.err
        assert captured.out == ""


def test_several_files_an_entry_and_an_assumption(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write("a.mod", "MODULE A\nPROC other()\nMoveJ p,v100,fine,tGone;\nENDPROC\nENDMODULE\n")
    write("b.mod", f"MODULE B\nCONST robtarget p:={POINT.format('450,0,647', 0, 0, 0)};\nENDMODULE\n")
    assert run(["parse", "a.mod", "b.mod", "--entry", "other"]) == 2
    assert "tGone" in capsys.readouterr().err
    found = record(capsys, "a.mod", "b.mod", "--entry", "other", "--assume-identity", "tGone")
    assert found["entry"] == "other"
    assert [Path(file).name for file in found["files"]] == ["a.mod", "b.mod"]
    assert found["motions"][0]["tool"] == "tGone"


@pytest.mark.parametrize(
    ("cell", "heavy"),
    [
        ("", "rich ruamel trajopt_cli.problem.plant"),
        (CELL, "rich scipy pinocchio casadi coal matplotlib toppra ruckig"),
    ],
)
def test_a_listing_loads_no_more_than_it_needs(here: Path, cell: str, heavy: str) -> None:
    write("e.mod", EVERYTHING)
    if cell:
        write("e.yaml", cell)
    code = "import sys; from trajopt_cli.cli import run; run(['parse', 'e.mod']); print(*sys.modules)"
    environment = {"PYTHONPATH": str(REPOSITORY)}
    command = [sys.executable, "-c", code]
    done = subprocess.run(command, capture_output=True, text=True, check=True, env=environment)
    assert not set(heavy.split()) & set(done.stdout.splitlines()[-1].split())
