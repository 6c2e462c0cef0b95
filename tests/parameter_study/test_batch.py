"""`trajopt batch`: which programs a folder holds, a process for each, what a stopped batch goes on with."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest
from distributed import Client
from problem.test_controller import MOC

from trajopt_cli.cell.loader import load_cell
from trajopt_cli.cli import run
from trajopt_cli.errors import InputError
from trajopt_cli.parameter_study import backups
from trajopt_cli.parameter_study.backups import batch, outcome, programs_below

MODULE = """MODULE m
    CONST jointtarget j:=[[{0},0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveAbsJ j, v100, fine, tool0;
    ENDPROC
ENDMODULE
"""
TOOLS = "MODULE tools\n    PROC helper()\n    ENDPROC\nENDMODULE\n"
CELL = 'robot: irb140\nstart: {joints: "[0, 0, 0, 0, 30, 0] deg"}\n'
ANSWER = {
    "as_written": {"cycle_time_s": 8.0, "why_not": None},
    "plans": {"rapid": {"cycle_time_s": 6.0}, "stream": {"cycle_time_s": 5.5}},
    "no_rapid": None,
}
OUT = Path("out")


@pytest.fixture
def tree(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Backups and programs of every kind."""
    monkeypatch.chdir(tmp_path)
    files = {
        "two/a.mod": MODULE.format(20),
        "two/a.yaml": CELL,
        "two/b.mod": MODULE.format(40),
        "two/lib.mod": TOOLS,
        "one/main.mod": MODULE.format(20),
        "one/tools.mod": TOOLS,
        "one/cell.yaml": CELL,
        "rob/backup/RAPID/TASK1/PROGMOD/m.mod": MODULE.format(20),
        "rob/backup/SYSPAR/MOC.cfg": MOC,
        "pair/RAPID/T_ROB1/PROGMOD/m.mod": MODULE.format(20),
        "pair/RAPID/T_ROB2/PROGMOD/m.mod": MODULE.format(30),
        "pair/RAPID/T_IO/PROGMOD/m.mod": TOOLS,
        "listed/p.pgf": '<?xml version="1.0"?><Program><Module>m.mod</Module></Program>',
        "listed/m.mod": MODULE.format(20),
        "listed/p.yaml": CELL,
        ".hidden/m.mod": MODULE.format(20),
        "old/run.json": "{}",
        "old/m.mod": MODULE.format(20),
    }
    for name, text in files.items():
        (Path("all") / name).parent.mkdir(parents=True, exist_ok=True)
        (Path("all") / name).write_text(text)
    return Path("all")


def test_every_program_is_found_once(tree: Path) -> None:
    found, left = programs_below(tree, OUT)
    assert {one.name: [path.relative_to(tree).as_posix() for path in one.paths] for one in found} == {
        "listed_p": ["listed/p.pgf"],
        "one_main": ["one/main.mod", "one/tools.mod"],
        "pair_RAPID_T_ROB1": ["pair/RAPID/T_ROB1"],
        "pair_RAPID_T_ROB2": ["pair/RAPID/T_ROB2"],
        "rob_backup": ["rob/backup"],
        "two_a": ["two/a.mod"],
        "two_b": ["two/b.mod"],
    }
    cells = {one.name: one.cell for one in found if not one.why_not}
    assert cells == {
        "listed_p": tree / "listed/p.yaml",
        "one_main": tree / "one/cell.yaml",
        "rob_backup": OUT / "cells/rob_backup.yaml",
        "two_a": tree / "two/a.yaml",
    }
    assert [line.split(":")[0] for line in left] == [str(tree / "two/lib.mod")]


def test_names_stay_apart(tmp_path: Path) -> None:
    for name in ("a_b.mod", "a/b.mod", "cells.mod"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(MODULE.format(20))
    assert sorted(one.name for one in programs_below(tmp_path, OUT)[0]) == ["a_b", "a_b_2", "cells_2"]


def stand_in(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Instead of a process: an answer whose folder is there; the second list holds whose turn it was."""
    asked: list[str] = []

    def answer(words: Sequence[str], folder: str) -> tuple[int, str, str]:
        place = Path(words[words.index("--output") + 1])
        asked.append(place.name)
        if place.name == "one_main":
            return 1, json.dumps({"feasible": False, "why": ["m.mod:4: out of reach"]}), "m.mod:4: out of reach\n"
        place.mkdir(parents=True, exist_ok=True)
        (place / "run.json").write_text("{}")
        return 0, json.dumps(ANSWER), ""

    monkeypatch.setattr(backups, "run_command", answer)
    return asked


def rows_of(tree: Path, *options: str) -> dict[str, Any]:
    with ThreadPoolExecutor(2) as executor:
        return {row["program"]: row for row in batch(programs_below(tree, OUT)[0], OUT, executor, options)}


def test_a_batch_goes_on_where_it_was_and_plans_anew_what_has_changed(
    tree: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked = stand_in(monkeypatch)
    rows = rows_of(tree)
    assert {name: row["status"] for name, row in rows.items()} == {
        **dict.fromkeys(("listed_p", "rob_backup", "two_a"), "ok"),
        **dict.fromkeys(("one_main", "pair_RAPID_T_ROB1", "pair_RAPID_T_ROB2", "two_b"), "failed"),
    }
    assert (rows["two_a"]["saved_s"], rows["two_a"]["saved"]) == (2.0, 0.25)
    assert rows["one_main"]["reason"] == "m.mod:4: out of reach"
    assert load_cell(OUT / "cells/rob_backup.yaml").robot == "irb140_rail"
    assert not [path for path in (tree / "rob").rglob("*.yaml")]
    page = (OUT / "index.html").read_text()
    assert 'href="two_a/report.html"' in page
    assert 'href="one_main/report.html"' not in page
    # again: what failed is tried again, the rest stands
    assert sorted(asked) == ["listed_p", "one_main", "rob_backup", "two_a"]
    asked.clear()
    assert rows_of(tree) == rows
    assert asked == ["one_main"]
    for change in (
        lambda: (tree / "two/a.yaml").write_text(f"{CELL}profile: default\n"),
        lambda: (tree / "two/a.mod").write_text(MODULE.format(21)),
        lambda: shutil.rmtree(OUT / "two_a"),
    ):
        asked.clear()
        change()
        rows_of(tree)
        assert sorted(asked) == ["one_main", "two_a"]
    asked.clear()
    (OUT / "cells/rob_backup.yaml").write_text("# mine\n" + (OUT / "cells/rob_backup.yaml").read_text())
    rows_of(tree)
    assert sorted(asked) == ["one_main", "rob_backup"]
    assert (OUT / "cells/rob_backup.yaml").read_text().startswith("# mine\n")
    asked.clear()
    rows_of(tree, "--time-limit", "3")
    assert sorted(asked) == ["listed_p", "one_main", "rob_backup", "two_a"]


def test_nobodys_folder_is_written_over(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    asked = stand_in(monkeypatch)
    OUT.mkdir()
    (OUT / "mine.txt").write_text("mine")
    with pytest.raises(InputError) as error:
        rows_of(tree)
    assert (error.value.file, asked) == (str(OUT), [])


@pytest.mark.parametrize(
    ("code", "err", "reason"),
    [(2, "a.mod:3: no such word\nb.mod:1: nor this\n", "a.mod:3: no such word"), (-9, "", "ended by signal 9")],
)
def test_a_process_that_ends_otherwise_is_a_row_with_its_reason(code: int, err: str, reason: str) -> None:
    row = outcome(code, "", err)
    assert (row["status"], row["reason"], row["rapid_s"]) == ("failed", reason, None)


@pytest.mark.long
def test_programs_are_planned_in_processes_and_one_that_fails_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("all").mkdir()
    for name, text in (("good.mod", MODULE.format(20)), ("bad.mod", MODULE.format(2000))):
        (Path("all") / name).write_text(text)
        (Path("all") / name).with_suffix(".yaml").write_text(CELL)
    assert run(["batch", "all", "--time-limit", "0", "--json"]) == 1
    bad, good = json.loads(capsys.readouterr().out)["programs"]
    assert (bad["program"], bad["status"], good["status"]) == ("bad", "failed", "ok")
    assert "bad.mod:2" in bad["reason"] or "bad.mod:4" in bad["reason"]
    assert good["as_written_s"] >= good["rapid_s"] >= good["stream_s"] - 1e-6 > 0
    assert run(["verify", "results/all_batch/good", "--quiet"]) == 0


@pytest.mark.long
def test_a_cluster_plans_what_this_computer_would(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, client: Client
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("all").mkdir()
    Path("all/a.mod").write_text(MODULE.format(20))
    Path("all/a.yaml").write_text(CELL)
    words = ["batch", "all", "--time-limit", "0", "--quiet"]
    assert run([*words, "--scheduler", client.scheduler.address]) == 0
    assert run([*words, "--output", "here"]) == 0
    there, here = (
        json.loads((Path(one) / "batch.json").read_text())["programs"] for one in ("results/all_batch", "here")
    )
    assert [row["rapid_s"] for row in there] == [row["rapid_s"] for row in here]
    assert run(["verify", "results/all_batch/a", "--quiet"]) == 0


@pytest.mark.long
def test_ctrl_c_ends_the_processes_and_leaves_whole_folders(tmp_path: Path) -> None:
    names = "abcdefgh"
    for name in names:
        (tmp_path / "all").mkdir(exist_ok=True)
        (tmp_path / f"all/{name}.mod").write_text(MODULE.format(20))
        (tmp_path / f"all/{name}.yaml").write_text(CELL)
    command = [sys.executable, "-m", "trajopt_cli.cli", "batch", "all", "--jobs", "1", "--time-limit", "0"]
    with subprocess.Popen(command, cwd=tmp_path, stderr=subprocess.PIPE, text=True, env=dict(os.environ)) as process:
        assert process.stderr is not None
        process.stderr.readline()  # the first is done
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        assert process.wait(20) == 130
    out = tmp_path / "results/all_batch"
    rows = json.loads((out / "batch.json").read_text())["programs"]
    assert {row["status"] for row in rows} == {"ok"}
    assert len(rows) < len(names)
    assert run(["verify", str(out / rows[0]["program"]), "--quiet"]) == 0
    whole = {path.name for path in out.iterdir() if path.is_dir() and not path.name.startswith(".")}
    assert whole == {row["program"] for row in rows}
