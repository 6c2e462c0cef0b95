"""Errors and notices have a kind, so that nobody reads it out of their words."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from pathlib import Path

import pytest

from trajopt_cli.cell.loader import load_cell
from trajopt_cli.errors import ErrorKind, InputError, InputErrorGroup, of_kind
from trajopt_cli.iiwa.job.folder import open_folder
from trajopt_cli.iiwa.task.equilibrium import read_angles_csv
from trajopt_cli.iiwa.task.loader import load_task, parse_task
from trajopt_cli.job import read_job
from trajopt_cli.joint_csv import read_csv_text
from trajopt_cli.motion import Source
from trajopt_cli.pipeline.folder import verify_results
from trajopt_cli.rapid.reader import read_program
from trajopt_cli.robot.model import load_robot
from trajopt_cli.warnings import ProgramWarning, WarningKind

P = "CONST robtarget p:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
CELL = "robot: irb140\nstart: {joints: [0, 0, 0, 0, 0.5, 0]}\n"


def test_an_error_is_nothing_that_a_terminal_obeys() -> None:
    error = InputError("key '\x1b]0;evil\x07\u202e' is odd\nsecond line", file="no\nfolder", line=2)
    assert str(error) == "no\\nfolder:2: key '\\x1b]0;evil\\x07\\u202e' is odd\\nsecond line"
    assert str(InputError("größer 0,5 µm – ≤", file="ü.mod")) == "ü.mod: größer 0,5 µm – ≤"


@pytest.fixture
def here(tmp_path: Path) -> Callable[[str, str], Path]:
    """Writes a program's body and its cell file; the program's path."""

    def write(body: str, cell: str) -> Path:
        (tmp_path / "m.mod").write_text(f"MODULE m\n{P}PROC main()\n{body}\nENDPROC\nENDMODULE\n")
        (tmp_path / "m.yaml").write_text(cell)
        return tmp_path / "m.mod"

    return write


@pytest.mark.parametrize(
    ("body", "cell", "kind"),
    [
        ("MoveL p v100;", CELL, ErrorKind.PROGRAM),
        ("MoveL Offs(p,0,0),v100,fine,tool0;", CELL, ErrorKind.PROGRAM),
        ("IF go MoveL p,v100,fine,tool0;", CELL, ErrorKind.CELL),  # what the cell file does not say
        ("IF go MoveL p,v100,fine,tool0;", f"{CELL}data: {{go: 1}}\n", ErrorKind.CELL),
        ("MoveL p,v100,fine,tool0;", f"{CELL}hold_rail: {{waits: true}}\n", ErrorKind.CELL),
        ("MoveL p,v100,fine,tool0;", f"{CELL}stat: 1\n", ErrorKind.CELL),
        ("MoveL p,v100,fine,tool0;", CELL.replace("irb140", "irb141"), ErrorKind.CELL),
        ("MoveL p,v100,fine,tool0;", CELL.replace("0.5, 0]", "0.5]"), ErrorKind.CELL),
        ("SingArea \\LockAxis4; MoveL p,v100,fine,tool0;", CELL, ErrorKind.UNPLANNABLE),
        ("WaitTime 1;", CELL, ErrorKind.UNPLANNABLE),
    ],
)
def test_a_job_that_cannot_be_read_says_what_is_wrong(
    here: Callable[[str, str], Path], body: str, cell: str, kind: ErrorKind
) -> None:
    with pytest.raises(InputError) as caught:
        read_job(here(body, cell))
    assert caught.value.kind is kind
    errors = caught.value.errors if isinstance(caught.value, InputErrorGroup) else [caught.value]
    assert {error.kind for error in errors} == {kind}


def test_every_room_s_door_says_what_is_wrong(tmp_path: Path) -> None:
    (tmp_path / "x.urdf").write_text("<robot/>")
    (tmp_path / "x.yaml").write_text("name: x\n")
    doors: list[tuple[Callable[[], object], ErrorKind]] = [
        (lambda: read_program(tmp_path / "none.mod"), ErrorKind.PROGRAM),
        (lambda: load_cell(tmp_path / "none.yaml"), ErrorKind.CELL),
        (lambda: load_robot(str(tmp_path / "x.yaml")), ErrorKind.ROBOT),
        (lambda: verify_results(tmp_path), ErrorKind.RESULTS),
        (lambda: load_task(tmp_path / "none.yaml"), ErrorKind.PROGRAM),
        (lambda: parse_task("robot: iiwa7\n", "t.yaml"), ErrorKind.PROGRAM),
        (lambda: open_folder(tmp_path), ErrorKind.RESULTS),
        (lambda: read_angles_csv("a,b\n", "e.csv"), ErrorKind.RESULTS),
        (lambda: read_csv_text("a,b\n", "j.csv"), ErrorKind.RESULTS),
        (lambda: read_job(tmp_path / "none.mod"), ErrorKind.OPTION),
    ]
    for door, kind in doors:
        with pytest.raises(InputError) as caught:
            door()
        assert caught.value.kind is kind, caught.value


def test_the_innermost_kind_holds_and_other_words_keep_it() -> None:
    with pytest.raises(InputError) as caught, of_kind(ErrorKind.RESULTS), of_kind(ErrorKind.CELL):
        raise InputError("wrong", file="f", line=2, column=3, excerpt="x")
    error = caught.value
    assert error.kind is ErrorKind.CELL
    other = error.saying("false")
    assert (str(other), other.excerpt, other.kind) == ("f:2:3: false", "x", ErrorKind.CELL)
    assert pickle.loads(pickle.dumps(error)).kind is ErrorKind.CELL  # our own, as two processes pass it
    group = InputErrorGroup([InputError("a"), InputError("b", kind=ErrorKind.ROBOT)])
    group.take(ErrorKind.PROGRAM)
    assert [one.kind for one in group.errors] == [ErrorKind.PROGRAM, ErrorKind.ROBOT]


def test_notices_of_a_program_have_a_kind_and_a_place(tmp_path: Path) -> None:
    path = tmp_path / "m.mod"
    path.write_text(
        f"MODULE m\n{P}PROC main()\nStop;\nWaitTime 1; ! trajopt: optional\nMoveL p,v100,fine,tool0\\TLoad:=load0;\n"
        "ENDPROC\nENDMODULE\n"
    )
    file = str(path)
    assert read_program(path).warnings == (
        ProgramWarning(
            WarningKind.ASSUMED, "Stop waits for the operator; the program goes on here", Source(file, 4, 1)
        ),
        ProgramWarning(WarningKind.NO_EFFECT, "\\TLoad changes nothing here; the cell's limits hold for any load",
               Source(file, 6, 32)),
        ProgramWarning(WarningKind.UNUSED, "marked as optional, but no move ran there", Source(file, 5, 1)),
    )  # fmt: skip
