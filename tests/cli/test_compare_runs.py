"""`trajopt compare runs`: every difference put between two folders is found, with its seconds in closed form."""

from __future__ import annotations

import json
import random
import re
import shutil
import xml.etree.ElementTree as ET
from math import radians, sqrt
from pathlib import Path
from typing import Any

import pytest
from fake_planner import ACCELERATION, CELL, TEXT, Planner

from trajopt_cli.cli import run
from trajopt_cli.problem.plan import Target
from trajopt_cli.runs.compared import _in_step
from trajopt_cli.runs.summary import MotionRow

_FAR = "    CONST jointtarget j_far:=[[15,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n\n"
OTHER = TEXT.replace("WaitTime 0.5;", "WaitTime 0.8;").replace("    PROC main()", f"{_FAR}    PROC main()")
OTHER = OTHER.replace("        MoveAbsJ j_home", "        MoveAbsJ j_far, v1000, fine, tool0;\n        MoveAbsJ j_home")
OTHER_CELL = CELL + "limits: {joint_1: {acceleration: 14, source: measured}}\nclearance: 0.01\n"


def seconds(degrees: float, target: Target = Target.STREAM) -> float:
    """Half accelerating, half braking."""
    return 2 * sqrt(radians(degrees) / ACCELERATION[target])


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("made") / "both"


@pytest.fixture
def folders(made: Path, planner: Planner, program: Path) -> list[str]:
    """a: as it is. b: another wait, a motion more, another limit and key, the other target."""
    if not made.exists():
        assert run(["optimize", str(program), "--output", "a"]) == 0
        program.write_text(OTHER)
        Path("tiny.yaml").write_text(OTHER_CELL)
        assert run(["optimize", str(program), "--output", "b", "--target", "rapid"]) == 0
        shutil.copytree(".", made)
    else:
        shutil.copytree(made, ".", dirs_exist_ok=True)
    return ["a", "b"]


def compared(folders: list[str], capsys: pytest.CaptureFixture[str], *more: str) -> Any:
    capsys.readouterr()
    assert run(["compare", "runs", *folders, "--json", *more]) == 0
    return json.loads(capsys.readouterr().out)


def test_every_difference_is_found_and_nothing_else(folders: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    told = compared(folders, capsys)
    differences = {(one["kind"], one["name"]): one["values"] for one in told["inputs"]}
    assert differences == {
        ("cell", "limits.joint_1.acceleration"): [None, "14"],
        ("cell", "limits.joint_1.source"): [None, "measured"],
        ("cell", "clearance"): [None, "0.01"],
        ("option", "target"): ["stream", "rapid"],
    }
    assert told["limits"] == [{"kind": "limit", "name": "joint_1 acceleration", "values": ["15 rad/s2", "14 rad/s2"]}]
    ((module,),) = told["program"].values()
    assert (module["module"], module["lines_added"], module["lines_removed"]) == ("tiny.mod", 4, 1)
    assert "+        WaitTime 0.8;" in module["diff"]


def test_motions_stand_beside_each_other_with_their_seconds(
    folders: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    told = compared(folders, capsys)
    assert told["target"] == "stream"  # the first run's choice
    names = [(one["instruction"], one["target"]) for one in told["motions"]]
    assert names == [("MoveAbsJ", "j_side"), ("WaitTime", "0.5 s"), ("MoveAbsJ", "j_far"), ("MoveAbsJ", "j_home")]
    times = [one["times_s"] for one in told["motions"]]
    assert times[0] == pytest.approx([seconds(20)] * 2)
    assert times[1] == pytest.approx([0.5, 0.8])
    assert times[2] == [None, pytest.approx(seconds(5))]
    assert times[3] == pytest.approx([seconds(20), seconds(15)])
    for target in Target:
        first, second = (one["plans"][target.value] for one in told["runs"])
        wanted = 0.3 + seconds(5, target) + seconds(15, target) - seconds(20, target)
        assert second["against_first_s"] == pytest.approx(wanted)
        assert second["cycle_time_s"] - first["cycle_time_s"] == pytest.approx(wanted)
        assert first["gap"] == pytest.approx(1 / 9)
    rapid = compared(folders, capsys, "--target", "rapid")["motions"]
    assert rapid[0]["times_s"] == pytest.approx([seconds(20, Target.RAPID)] * 2)


def test_the_terminal_says_it_within_80_columns(folders: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    assert run(["compare", "runs", *folders, "--diff"]) == 0
    out = capsys.readouterr().out
    assert max(len(line.rstrip()) for line in out.splitlines()) <= 80
    assert "limit joint_1 acceleration: A 15 rad/s2; B 14 rad/s2" in out
    assert "program tiny.mod: B has +4 −1 lines against A" in out
    assert "    -        WaitTime 0.5;\n" in out
    order = re.findall(r"^ ?tiny.mod:\d+ +(\w+ j?[\w.]+)", out, re.M)
    assert order == ["WaitTime 0.5", "MoveAbsJ j_far", "MoveAbsJ j_home"]  # the largest difference first
    assert "1 of 4 motions take the same time" in out


def test_three_runs_and_one_folder_twice(folders: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    told = compared([*folders, str(Path("a").resolve())], capsys)
    assert told["notes"] == ["A and C are the same folder, so nothing differs between them"]
    assert [one["times_s"][0] == one["times_s"][2] for one in told["motions"]] == [True] * 4
    capsys.readouterr()
    assert run(["compare", "runs", "a", "a"]) == 0
    assert "the inputs are the same: program, cell file, options and versions" in capsys.readouterr().out


def test_other_programs_are_said_to_be_others(folders: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    moves = "".join(f"        MoveAbsJ j_{k}, v1000, fine, tool0;\n" for k in range(6))
    data = "".join(
        f"    CONST jointtarget j_{k}:=[[{5 + 5 * k},0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n" for k in range(6)
    )
    Path("another.mod").write_text(f"MODULE Another\n{data}    PROC main()\n{moves}    ENDPROC\nENDMODULE\n")
    Path("another.yaml").write_text(CELL)
    assert run(["optimize", "another.mod", "--output", "c"]) == 0
    (note,) = compared(["a", "c"], capsys)["notes"]
    assert note.startswith("A and B are of different programs (tiny.mod and another.mod): 0 of 6 motions are in both")


def test_wrong_folders_are_one_line(folders: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    record = json.loads(Path("b/run.json").read_text())
    for kind, told in (
        ("iiwa", "b: was made by trajopt iiwa;"),
        ("sensitivity", "b: is a folder of kind sensitivity;"),
    ):
        Path("b/run.json").write_text(json.dumps(record | {"kind": kind}))
        capsys.readouterr()
        assert run(["compare", "runs", "a", "b"]) == 2
        assert told in capsys.readouterr().err
    Path("b/run.json").write_text(json.dumps(record))
    Path("b/summary.json").write_text("{}")
    capsys.readouterr()
    assert run(["compare", "runs", "a", "b"]) == 2
    assert capsys.readouterr().err == "b/summary.json: was changed since the run; run trajopt optimize again\n"


def test_the_page_draws_every_motion_where_it_is(folders: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["compare", "runs", *folders, "--report", "p.html"]) == 0
    page = Path("p.html").read_text(encoding="utf-8")
    drawings = [ET.fromstring(one) for one in re.findall(r"<svg.*?</svg>", page, re.S)]
    cycles, gantt = drawings
    wide = [float(bar.get("width", "")) for bar in cycles.iter("rect")]
    told = compared(folders, capsys)
    times = [one["plans"][target]["cycle_time_s"] for target in ("rapid", "stream") for one in told["runs"]]
    assert [one / wide[0] for one in wide] == pytest.approx([one / times[0] for one in times], rel=1e-4)
    bars = list(gantt.iter("rect"))
    assert [bar.get("class") for bar in bars] == ["joint", "wait", "joint", "joint", "wait", "joint", "joint"]
    scale = float(bars[0].get("width", "")) / seconds(20)
    assert float(bars[4].get("width", "")) == pytest.approx(0.8 * scale, rel=1e-3)
    assert float(bars[6].get("x", "")) - float(bars[5].get("x", "")) == pytest.approx(seconds(5) * scale, rel=1e-3)
    assert "j_far, tiny.mod:10" in page
    assert "limits.joint_1.acceleration" in page
    assert page == Path("p.html").read_text(encoding="utf-8")


def motion(name: str, k: int) -> MotionRow:
    said = {"instruction": name[:4], "target": name[4:], "start_s": k, "time_s": 1, "dropped": False}
    return MotionRow(index=k, source=f"p.mod:{k}:1", axes_at_end=[], **said)


def test_rows_keep_every_motion_of_every_run_once_and_in_order() -> None:
    some = random.Random(4)
    for _ in range(60):
        columns = [
            [motion(some.choice(("Moveone", "Movetwo", "Linetwo", "Wait1 s", "Linesix")), k) for k in range(count)]
            for count in some.choices(range(12), k=some.choice((2, 3, 4)))
        ]
        rows = _in_step(columns)
        for n, column in enumerate(columns):
            assert [row.motions[n] for row in rows if row.motions[n] is not None] == column
        assert all(len(row.motions) == len(columns) and any(row.motions) for row in rows)


def test_a_move_of_another_kind_to_the_same_target_stands_beside_the_old_one() -> None:
    first = [motion(name, k) for k, name in enumerate(("Moveone", "Movetwo", "Movesix"))]
    second = [motion(name, k) for k, name in enumerate(("Moveone", "Linenew", "Linetwo", "Movesix"))]
    rows = _in_step([first, second])
    assert [tuple(one and one.target for one in row.motions) for row in rows] == [
        ("one", "one"),
        (None, "new"),
        ("two", "two"),
        ("six", "six"),
    ]
