"""`trajopt sensitivity` as people type it."""

from __future__ import annotations

import json
from pathlib import Path
from shutil import copytree
from typing import Any

import numpy as np
import pytest
from fake_planner import CELL

from trajopt_cli.cli import run
from trajopt_cli.runs.folder import SENSITIVITY, read_run
from trajopt_cli.study.answers import study_record

# joint 1 by 5 degrees and back, under every cap of the tool; a wait between
TEXT = """MODULE Tiny
    CONST jointtarget j_home:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j_side:=[[5,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        MoveAbsJ j_side, vmax, fine, tool0;
        WaitTime 0.5;
        MoveAbsJ j_home, vmax, fine, tool0;
    ENDPROC
ENDMODULE
"""
TURN = 2 * np.sqrt(np.radians(5) / 15)  # s of each move


def _written() -> Path:
    program = Path("tiny.mod")
    program.write_text(TEXT)
    Path("tiny.yaml").write_text(CELL + "tcp: {speed: 9, acceleration: 90, source: a test}\n")
    return program


@pytest.fixture
def tiny(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return _written()


@pytest.fixture(scope="module")
def plans(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Of the tiny program, made once."""
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(tmp_path_factory.mktemp("planned"))
        assert run(["optimize", str(_written())]) == 0
        return Path("results").resolve()


@pytest.fixture
def planned(tiny: Path, plans: Path) -> Path:
    """The tiny program with its results beside it."""
    copytree(plans, "results")
    return tiny


def answer(capsys: pytest.CaptureFixture[str], *arguments: str) -> dict[str, Any]:
    capsys.readouterr()
    assert run(["sensitivity", *arguments, "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def test_a_program_and_its_results_get_the_same_answer_in_order(
    planned: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    alone = answer(capsys, str(planned), "--jobs", "1")
    of_results = answer(capsys, "results/tiny", "--jobs", "2", "--output", "out")
    for one in alone, of_results:
        del one["program"]
    assert of_results == alone
    assert list(alone["targets"]) == ["rapid", "stream"]
    for target in alone["targets"].values():
        gains = {one["name"]: one["gain_s"] for one in target["levers"]}
        assert list(gains.values()) == sorted(gains.values(), reverse=True)
        # one wait, two moves under the top acceleration; nothing else binds
        assert gains.pop("wait at tiny.mod:7") == pytest.approx(0.05, abs=1e-6)
        assert gains.pop("joint_1 acceleration") == pytest.approx(2 * TURN * (1 - 1 / np.sqrt(1.1)), rel=2e-3)
        assert set(gains.values()) == {0.0}
        assert not any(one["binds"] for one in target["levers"][2:])
        assert target["change_first"].split(": ", 1)[1] == (
            "change first: wait at tiny.mod:7, −10 % saves 0.050 s (6.2 %); then joint_1 acceleration, +10 % saves "
            "0.014 s (1.8 %)"
        )
    # the folder is whole, and brings its inputs
    folder = read_run(Path("out"), study_record(SENSITIVITY))
    own = json.loads(folder.contents["sensitivity.json"])
    del own["program"]
    assert own == alone
    assert folder.contents[str(folder.record.inputs.program)] == planned.read_bytes()
    assert {"plots/sensitivity_stream.svg", "plots/sensitivity_rapid.png"} < set(folder.contents)


@pytest.mark.usefixtures("planned")
def test_the_table_says_what_saves_what_binds_nowhere_and_what_was_not_asked(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert run(["sensitivity", "results/tiny", "--target", "rapid"]) == 0
    out = capsys.readouterr().out
    lines = out.splitlines()
    assert lines[0].rstrip() == "tiny, rapid: what one change saves of 0.805 s"
    first = next(line for line in lines if line.strip().startswith("wait at"))
    assert first.split() == [
        "wait",
        "at",
        "tiny.mod:7",
        "−10",
        "%",
        "0.5",
        "0.45",
        "s",
        "0.0500",
        "6.21",
        "%",
        "0.0500",
    ]
    assert sum("not limiting, raising these saves nothing: joint_1 speed" in line for line in lines) == 1
    assert "not asked: rail: there is none" in lines
    assert lines[-1].startswith("rapid: change first: wait at tiny.mod:7")
    assert "stream" not in out
    assert run(["sensitivity", "results/tiny", "--target", "rapid", "--all"]) == 0
    every = [line for line in capsys.readouterr().out.splitlines() if line.rstrip().endswith("not limiting")]
    assert len(every) == 15  # 12 limits of axes but one, two caps of the tool, two programmed speeds


@pytest.mark.usefixtures("planned")
def test_planning_anew_is_a_column_more(capsys: pytest.CaptureFixture[str]) -> None:
    found = answer(capsys, "results/tiny", "--target", "stream", "--search", "--jobs", "1")
    levers = found["targets"]["stream"]["levers"]
    assert [one["searched_s"] for one in levers[2:]] == [None] * len(levers[2:])
    for one in levers[:2]:
        assert one["searched_s"] == pytest.approx(one["gain_s"], abs=1e-5)


def test_a_program_that_cannot_be_done_names_the_motion(tiny: Path, capsys: pytest.CaptureFixture[str]) -> None:
    tiny.write_text(TEXT.replace("[5,0,0", "[500,0,0"))
    assert run(["sensitivity", str(tiny)]) == 1
    assert "MoveAbsJ j_side asks for joint_1 = 500 deg" in capsys.readouterr().err


def test_plans_of_another_question_are_refused(tiny: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["optimize", str(tiny), "--gentle", "--time-limit", "0"]) == 0
    capsys.readouterr()
    assert run(["sensitivity", "results/tiny"]) == 2
    assert capsys.readouterr().err.startswith(
        "results/tiny: its plans are the gentlest in a given time, and sensitivity"
    )
    cell = Path("tiny.yaml")
    cell.write_text(cell.read_text() + "jerk_limits: true\n")
    assert run(["sensitivity", str(tiny)]) == 2
    assert "jerk_limits: sensitivity does not know what they cost" in capsys.readouterr().err
    cell.write_text(cell.read_text().replace("jerk_limits: true\n", "free: {axis: z}\n"))
    assert run(["sensitivity", str(tiny)]) == 2
    line = len(cell.read_text().splitlines())
    assert capsys.readouterr().err.startswith(f"tiny.yaml:{line}: free: ")
