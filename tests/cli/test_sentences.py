"""Every sentence that commands print for common mistakes, answers and helps, in one file to be read by a person.

After a sentence got better: pytest tests/cli/test_sentences.py --regenerate, and read the diff of tests/golden.
"""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest
from fake_planner import CELL, TEXT, Planner
from test_help import COMMANDS

from trajopt_cli.cli import run
from trajopt_cli.motion import Source
from trajopt_cli.problem.plan import Infeasible

GOLDEN = Path(__file__).parents[1] / "golden" / "sentences.txt"
POINT = "[[{0}],[0,0,1,0],[{1}],[9E9,9E9,9E9,9E9,9E9,9E9]]"
REACHED, FAR = POINT.format("500,100,400", "0,0,0,0"), POINT.format("5000,0,400", "0,0,0,0")

BODIES = {
    "spelling": "MovL p, v100, fine, tool0;",
    "few_arguments": "MoveL p, v100;",
    "no_target": "MoveL q, v100, fine, tool0;",
    "no_tool": "MoveL p, v100, fine, tGun;",
    "no_speed": "MoveL p, vFast, fine, tool0;",
    "no_end": "IF TRUE THEN",
    "signal": "IF di1 = 1 THEN MoveJ p, v100, fine, tool0; ENDIF",
    "routine": "Glue;",
    "division": "VAR num n; n := 1 / 0;",
    "out_of_reach": f"MoveJ {FAR}, v100, fine, tool0;",
    "confdata": f"MoveJ {POINT.format('500,100,400', '1,1,1,0')}, v100, fine, tool0;",
    "joint_limit": "MoveAbsJ [[200,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]], v100, fine, tool0;",
    "waits": "WaitTime 1;",
    "stands": "MoveAbsJ [[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]], v100, fine, tool0;",
    "axis_locked": "SingArea \\LockAxis4; MoveL p, v100, fine, tool0;",
    "stop_time": "MoveL p, v100, fine\\Inpos:=stoptime0_5, tool0;",
}
CELLS = {
    "no_robot": "start: {joints: [0, 0, 0, 0, 0.5, 0]}\n",
    "robot": CELL.replace("irb140", "irb141"),
    "key": CELL + "stat: 1\n",
    "unit": CELL.replace("deg", "degrees"),
    "few_joints": CELL.replace("30, 0]", "30]"),
    "outside": CELL.replace("30, 0]", "3000, 0]"),
    "profile": CELL + "profile: fast\n",
    "negative": CELL + "clearance: -1 mm\n",
    "shape": CELL + "obstacles: {post: {box: {size: [1, 1], position: [0, 0, 0]}}}\n",
    "mesh": CELL + "obstacles: {post: {mesh: {file: none.stl}}}\n",
    "rail": CELL + "rail: {eax: a, stroke: [0, 1]}\n",
    "source": CELL + "limits: {joint_1: {acceleration: 10}}\n",
    "yaml": "robot: [irb140\n",
    "procedure": CELL + "constant_speed: [weld]\n",
    "hits": CELL + "obstacles: {crate: {box: {size: [0.2, 0.2, 0.2], position: [0.45, 0, 0.6]}}}\n",
    "limit": CELL + "limits: {joint_1: {acceleration: 8, source: a test}}\n",
}
WRONG = """
nonsense
optimize
optimize none.mod
optimize tiny.mod --target egm
optimize tiny.mod --cell no.yaml
optimize tiny.mod --cycle-time 0
optimize tiny.mod --cycle-time nan
optimize tiny.mod --cycle-time 8 --gentle
optimize tiny.mod --time-limit -1
optimize tiny.mod --output mine
optimize tiny.mod --output tiny.mod
optimize tiny.mod --cell ""
parse ""
parse tiny.mod " "
parse tiny.mod --entry ""
parse tiny.mod --entry=
parse tiny.mod --entry other
analyse tiny.mod --assume-identity " "
analyse results/tiny
verify nothing
verify .
verify . --program tiny.mod
verify results/tiny --entry main
verify results/tiny --task t.yaml
verify results/tiny/stream.csv
verify one.csv --program tiny.mod
export rapid x
export rapid "" --output x
export rapid results/tiny --output results
export rapid results/tiny --output nowhere/new.mod
export rapid results/tiny --output results/tiny/stream.csv
export joint results/tiny --rate 0 --output b.csv
export joint results/tiny --output /dev/null
compare baseline tiny.mod --csv .
compare baseline tiny.mod --csv nowhere/x.csv
compare baseline tiny.mod --plots tiny.mod
compare baseline results/tiny --loops keep
compare baseline results/tiny --entry main
compare baseline results/tiny tiny.mod
compare runs results/tiny
compare runs results/tiny .
sensitivity nowhere.mod
sensitivity tiny.mod --output mine
place tiny.mod --what rail --range height=0..1
place tiny.mod --what base --range x=1..0
place tiny.mod --what base --range q=0..1
place tiny.mod --what station:w --range x=0..1
place tiny.mod --what base --range x=0..1 --apply tiny.mod
place tiny.mod --what base --range x=0..1 --apply tiny.yaml
place tiny.mod --what base --range x=0..1 --output tiny.mod
place tiny.mod --what base
order tiny.mod
order tiny.mod --cell groups.yaml
order tiny.mod --cell groups.yaml --group turn
order tiny.mod --cell one.yaml
estimate results/tiny
estimate tiny.mod --units deg
identify one.csv
identify one.csv --robot irb140
identify one.csv --robot irb140 --cell tiny.yaml
identify one.csv one.csv --robot irb140
identify one.csv --robot irb140 --output one.csv
robot show irb14
view .
"""
ANSWERS = """
optimize tiny.mod
optimize tiny.mod --quiet
optimize tiny.mod --target rapid --output other --quiet
optimize tiny.mod --output b --cell limit.yaml --quiet
verify results/tiny --quiet
export joint results/tiny --output a.csv
export rapid results/tiny --output new.mod
export rapid results/tiny --diff
export rapid results/tiny --in-place
export
compare runs results/tiny b --all
compare runs results/tiny b --quiet
compare runs results/tiny results/tiny
compare baseline tiny.mod --quiet
estimate tiny.mod
estimate tiny.mod --quiet
robot list
robot show irb140 --quiet
robot show irb140
robot show iiwa7
parse tiny.mod
parse tiny.mod --assume-identity tGum
new fresh
"""


def test_what_commands_say_is_in_the_golden_file(
    program: Path,
    planner: Planner,
    request: pytest.FixtureRequest,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setenv("COLUMNS", "100")
    told = _answers(capfd)
    planner.answer = Infeasible(0, Source("tiny.mod", 6, 9), "nothing is wrong before the planner is asked")
    told += _mistakes(capfd)
    planner.asked.clear()
    told += _wrong(capfd)
    assert planner.asked == []
    told += _helps(capfd)
    text = "\n".join(told)
    if request.config.getoption("--regenerate"):
        GOLDEN.write_text(text, encoding="utf-8")
    assert text == GOLDEN.read_text(encoding="utf-8")


def _said(command: str, capfd: pytest.CaptureFixture[str], code: int | None = None) -> str:
    """A command with its exit code and all it prints but progress. code: as wanted; a wrong request is one line."""
    capfd.readouterr()
    ended = run(shlex.split(command))
    out, err = capfd.readouterr()
    errors = [line for line in err.splitlines() if not re.match(r"\d+ s: ", line)]
    assert "Traceback" not in err
    assert code in (None, ended), command
    assert ended != 2 or out == "", command
    assert code != 2 or len(errors) == 1, command
    text = "".join(f"{line.rstrip()}\n" for line in (*out.splitlines(), *errors))
    return f"$ trajopt {command}  → {ended}\n{text}".replace(f"{Path.cwd()}/", "")


def _answers(capfd: pytest.CaptureFixture[str]) -> list[str]:
    Path("limit.yaml").write_text(CELLS["limit"])
    return [_said(command, capfd, 0) for command in ANSWERS.strip().splitlines()]


def _mistakes(capfd: pytest.CaptureFixture[str]) -> list[str]:
    """One in the program, or one in the cell file."""
    told = []
    for name, body in BODIES.items():
        data = f"    CONST robtarget p:={REACHED};\n"
        Path(f"{name}.mod").write_text(f"MODULE M\n{data}    PROC main()\n        {body}\n    ENDPROC\nENDMODULE\n")
        told.append(f"# {body}\n{_said(f'optimize {name}.mod --cell tiny.yaml', capfd)}")
    for name, cell in CELLS.items():
        Path(f"{name}.yaml").write_text(cell)
        if name != "limit":
            told.append(f"# {cell.splitlines()[-1]}\n{_said(f'optimize tiny.mod --cell {name}.yaml', capfd)}")
    return told


def _wrong(capfd: pytest.CaptureFixture[str]) -> list[str]:
    """Requests that are refused before any work."""
    Path("mine").mkdir()
    Path("mine/notes.txt").write_text("precious")
    Path("one.csv").write_text("t [s],joint_1 [rad]\n0,0\n1,0\n")
    Path("groups.yaml").write_text(CELL + "order: {turns: [T1, T2], more: [T1, T2]}\n")
    Path("one.yaml").write_text(CELL + "order: {turns: [T1]}\n")
    assert Path("tiny.mod").read_text() == TEXT
    before = {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()}
    told = [_said(command, capfd, 2) for command in WRONG.strip().splitlines()]
    assert {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()} == before
    return told


def _helps(capfd: pytest.CaptureFixture[str]) -> list[str]:
    return [_said(f"{command} --help".strip(), capfd, 0) for command in ("", *COMMANDS)]
