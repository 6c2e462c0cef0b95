"""Tables and lines fit the terminal: nothing wider, no figure lost, no spaces at the end; no colour in a pipe."""

from __future__ import annotations

import json
import os
import pty
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from fake_planner import Planner
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from trajopt_cli.cli import run
from trajopt_cli.cli.layout import Column, table_lines
from trajopt_cli.cli.remarks import remarks
from trajopt_cli.robot.model import robot_names
from trajopt_cli.table import by_name, short_target

REPOSITORY = Path(__file__).parents[2]
_WORD = st.text("abc_.1", min_size=1, max_size=9)
_FIGURE = st.floats(-1e4, 1e4).map(lambda value: f"{value:.3f}")


@st.composite
def tables(draw: st.DrawFn) -> tuple[list[Column], int]:
    n = draw(st.integers(1, 4))
    names = [Column(draw(_WORD), draw(st.lists(st.text("abc(),1", max_size=40), min_size=n, max_size=n)), least=12)]
    for _ in range(draw(st.integers(0, 9))):
        head = " ".join(draw(st.lists(_WORD, min_size=1, max_size=3)))
        names.append(Column(head, draw(st.lists(_FIGURE, min_size=n, max_size=n)), True))
    return names, n


@settings(deadline=None, suppress_health_check=[HealthCheck.too_slow])  # on a busy machine
@given(tables(), st.integers(32, 200))
def test_a_table_is_no_wider_than_the_terminal_and_loses_no_figure(given: tuple[list[Column], int], width: int) -> None:
    columns, n = given
    lines = [line for line, _ in table_lines("a title", columns, [False] * n, width)]
    for line in lines:
        assert len(line) <= width
        assert line == line.rstrip()
    text = "\n".join(lines)
    for column in columns[1:]:
        for cell in column.cells:
            assert cell in text
    wide = [line for line, _ in table_lines("a title", columns, [False] * n, 10_000)]
    assert len(wide) == 5 + n  # title, blank, heads, rule, rows, blank


def test_columns_move_together_heads_are_split_names_cut_and_the_rest_stands_below() -> None:
    columns = [
        Column("place", ["a_very_long_module_name.mod:12"], least=12),
        Column("written time [s]", ["0.516"], True),
        Column("what limits it", ["rail acceleration"]),
    ]

    def at(width: int) -> list[str]:
        lines = [line for line, _ in table_lines("t", columns, [False], width)][2:-1]
        return [line for line in lines if "─" not in line]

    assert at(80) == [
        "place                            written time [s]   what limits it",
        "a_very_long_module_name.mod:12              0.516   rail acceleration",
    ]
    assert at(66)[1] == "a_very_long_module_name.mod:12            0.516 rail acceleration"
    assert at(58)[0].split() == ["written"]
    assert at(58)[-1] == "a_very_long_module_name.mod:12    0.516  rail acceleration"
    assert at(40)[-1] == "a_very…mod:12    0.516 rail acceleration"
    assert at(30)[-3:] == ["a_very_lon…ame.mod:12    0.516", "    what limits it: rail", "    acceleration"]


def test_files_are_called_by_name_where_no_two_share_it() -> None:
    files = ["a/b/line.mod", "cell/line.yaml"]
    assert by_name("a/b/line.mod:3:9: MoveL p, see cell/line.yaml", files) == "line.mod:3:9: MoveL p, see line.yaml"
    assert by_name("other/a/b/line.mod:3", files) == "other/a/b/line.mod:3"
    two = ["a/line.mod", "b/line.mod"]
    assert by_name("a/line.mod:3: x", two) == "a/line.mod:3: x"


def test_of_many_remarks_alike_the_first_are_shown() -> None:
    lines = [f"x/m.mod:{i}:9: the rail moves while the tool waits, to p_{i}" for i in range(1, 10)]
    told = [*remarks("note", ["one of its kind", *lines], ["x/m.mod"], "all in summary.json")]
    assert told[0] == "note: one of its kind"
    assert told[1] == "note: m.mod:1:9: the rail moves while the tool waits, to p_1"
    assert told[-1] == "note: and 3 more of this kind, all in summary.json"
    assert len(told) == 8
    mixed = [*lines[:2], "x/m.mod:5:9: MoveJ home: confdata", lines[5]]
    assert [*remarks("", mixed, [], "")] == mixed, "in the order of the program"


@pytest.mark.parametrize("command", [["optimize"], ["analyse"], ["parse"]])
def test_eighty_columns_are_enough(
    program: Path,
    planner: Planner,
    command: list[str],
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert run([*command, str(program)]) == 0
    wide = capsys.readouterr().out
    monkeypatch.setenv("COLUMNS", "80")
    assert run([*command, str(program)]) == 0
    narrow = capsys.readouterr().out
    for line in narrow.splitlines():
        assert len(line) <= 80, line
        assert line == line.rstrip()
    assert set(re.findall(r"\d+\.\d+", wide)) == set(re.findall(r"\d+\.\d+", narrow))


@pytest.mark.usefixtures("compared_once")
def test_other_tables_fit_eighty_columns(
    program: Path, results: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    for command in (
        ["verify", "results/tiny", "--all"],
        ["compare", "baseline", str(program)],
        ["robot", "show", "iiwa7"],
        ["robot", "show", "irb140_rail"],
    ):
        capsys.readouterr()
        assert run(command) == 0
        assert max(map(len, capsys.readouterr().out.splitlines())) <= 80


# ------------------------------------------------------------------------------------------------------------- colour


def in_a_terminal(program: Path, **env: str) -> str:
    """What `analyse` writes to a terminal of 80 columns."""
    master, slave = pty.openpty()
    pid = os.fork()
    if not pid:
        code = 99
        try:
            os.close(master)
            for name in ("NO_COLOR", "FORCE_COLOR", "COLUMNS"):
                os.environ.pop(name, None)
            os.environ |= {"TERM": "xterm", **env}
            sys.stdout, sys.stderr = os.fdopen(slave, "w"), os.fdopen(slave, "w", closefd=False)
            code = run(["analyse", str(program)])
            sys.stdout.flush()
            sys.stderr.flush()
        finally:
            os._exit(code)
    os.close(slave)
    text = b"".join(_all_of(master))
    assert os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]) == 0
    return text.decode()


def _all_of(master: int) -> Iterator[bytes]:
    while True:
        try:
            part = os.read(master, 65536)
        except OSError:  # the other end is closed
            return
        if not part:
            return
        yield part


def test_colour_is_for_terminals_and_for_who_wants_it(program: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert "\x1b[1m" in in_a_terminal(program, COLUMNS="80")
    assert "\x1b" not in in_a_terminal(program, COLUMNS="80", NO_COLOR="1")
    command = [sys.executable, "-m", "trajopt_cli.cli", "analyse", str(program)]  # as it begins, too
    env = {**os.environ, "PYTHONPATH": str(REPOSITORY), "TERM": "xterm"}
    piped = subprocess.run(command, capture_output=True, text=True, check=True, env=env)
    assert "\x1b" not in piped.stdout + piped.stderr
    forced = subprocess.run(command, capture_output=True, text=True, check=True, env={**env, "FORCE_COLOR": "1"})
    assert "\x1b[1m" in forced.stdout
    assert "\r" not in forced.stderr


# -------------------------------------------------------------------------------------------------------- json, quiet


def test_json_is_one_document_and_quiet_is_a_line(
    program: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["optimize", str(program), "--quiet"]) == 0
    captured = capsys.readouterr()
    assert captured.out.startswith("as written ")
    assert (captured.out.count("\n"), captured.err) == (1, "")
    for command in (
        ["verify", "results/tiny"],
        ["parse", "tiny.mod"],
        ["analyse", "tiny.mod"],
        ["robot", "show", "irb140"],
        ["robot", "show", "iiwa7"],
    ):
        assert run([*command, "--json", "--quiet"]) == 0
        captured = capsys.readouterr()
        assert json.loads(captured.out)
        assert captured.err == ""
        assert run([*command, "--quiet"]) == 0
        captured = capsys.readouterr()
        assert 0 < captured.out.count("\n") <= 3, command
        assert captured.err == ""
    assert run(["robot", "list", "--quiet"]) == 0
    assert tuple(capsys.readouterr().out.split("\n")[:-1]) == robot_names()
    assert run(["robot", "list", "--json", "--quiet"]) == 0
    assert [one["name"] for one in json.loads(capsys.readouterr().out)] == [*robot_names()]
    assert run(["optimize", str(program), "--json", "--quiet"]) == 0
    captured = capsys.readouterr()
    answer, summary = json.loads(captured.out), json.loads(Path("results/tiny/summary.json").read_text())
    assert captured.err == ""
    for target, plan in answer["plans"].items():
        assert plan["cycle_time_s"] == summary["plans"][target]["cycle_time_s"]
    assert set(answer["files"]) == {
        path.relative_to("results/tiny").as_posix() for path in Path("results/tiny").rglob("*") if path.is_file()
    }


def test_json_of_a_no_says_which_motion_and_which_limit(program: Path, capsys: pytest.CaptureFixture[str]) -> None:
    program.write_text(program.read_text().replace("[[20,0,", "[[200,0,"))
    assert run(["optimize", str(program), "--json"]) == 1
    answer = json.loads(capsys.readouterr().out)
    assert answer["feasible"] is False
    assert answer["motion"] == {"index": 0, "source": "tiny.mod:6:9"}
    assert "joint_1" in answer["limit"]
    assert run(["sensitivity", str(program), "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["feasible"] is False
    assert run(["optimize", "nothing.mod", "--json"]) == 2
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize(
    ("written", "told"),
    [
        ("[[878.25,-436.56,-0.01],[1,0,0,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]]", "[878.2, -436.6, 0.0]"),
        (
            "[[1,2,3,4,5,6],[812.5, 9e+09,9E9,9E9,9E9,9E9]] (1 point)",
            "[1.0, 2.0, 3.0, 4.0, 5.0, 6.0] [812.5] (1 point)",
        ),
        ("[[9E9,9E9,9E9,9E9,9E9,9E9],[0,400,9E9,9E9,9E9,9E9]]", "[0.0, 400.0]"),
        ("[[x,0,0],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]", None),
        ("Offs([[1,2,3],[1,0,0,0]],0,0,1)", None),
        ("[[", None),
    ],
)
def test_targets_written_out_are_told_by_where_they_are(written: str, told: str | None) -> None:
    assert short_target(written) == (told or written)
