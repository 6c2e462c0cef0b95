"""Programs of several files through the commands, and results folders that are read back as they were asked for."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from fake_planner import CELL, TEXT, Planner

from trajopt_cli.cli import run

HEAD, BODY = TEXT.split("\n    PROC", 1)
DATA = f"{HEAD.replace('MODULE Tiny', 'MODULE Data')}ENDMODULE\n"
MAIN = f"MODULE Tiny\n    ! Türband\n    PROC{BODY}".replace("tool0", "tGun")
GO = ["--entry", "go", "--assume-identity", "tGun"]


@pytest.fixture
def line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """tiny.mod of the fake planner as a backup: its targets in a module of their own, its tool declared nowhere, its
    entry called go."""
    monkeypatch.chdir(tmp_path)
    folder = Path("line")
    for name, text in (("PROGMOD/Tiny.mod", MAIN.replace("main()", "Go()")), ("SYSMOD/Data.sys", DATA)):
        (folder / "RAPID/TASK1" / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / "RAPID/TASK1" / name).write_bytes(text.replace("\n", "\r\n").encode("cp1252"))
    Path("line.yaml").write_text(CELL)
    return folder


def said(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> str:
    assert run(arguments) == 2
    return capsys.readouterr().err


def test_a_folder_is_optimised_and_its_results_stand_alone(
    line: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["optimize", str(line), *GO]) == 0
    folder = Path("results/line")
    record = json.loads((folder / "run.json").read_text())
    assert record["options"] == {
        "program": ["line"],
        "cell": "line.yaml",
        "entry": "Go",
        "assume_identity": ["tgun"],
        "target": "stream",
        "loops": "keep",
        "cycle_time": None,
    }
    assert record["inputs"]["program"] == "input/Tiny.mod"
    assert [(one["path"], one["copy"], one["rapid"]) for one in record["inputs"]["files"]] == [
        ("line/RAPID/TASK1/PROGMOD/Tiny.mod", "input/Tiny.mod", "program/Tiny.mod"),
        ("line.yaml", "input/line.yaml", None),
        ("line/RAPID/TASK1/SYSMOD/Data.sys", "input/Data.sys", "program/Data.sys"),
    ]
    given = (line / "RAPID/TASK1/PROGMOD/Tiny.mod").read_bytes()
    assert (folder / "input/Tiny.mod").read_bytes() == given
    assert b"T\xfcrband\r\n" in (folder / "program/Tiny.mod").read_bytes()

    folder.rename("alone")
    for path in (line, Path("line.yaml")):
        path.rename(f"gone_{path.name}")
    capsys.readouterr()
    assert run(["verify", "alone"]) == 0
    assert run(["compare", "baseline", "alone", "--json"]) == 0
    assert run(["export", "rapid", "alone", "--output", "new"]) == 0
    for name in ("Tiny.mod", "Data.sys"):
        assert (Path("new") / name).read_bytes() == (Path("alone/program") / name).read_bytes()


def test_the_same_folder_gives_the_same_summary(line: Path, planner: Planner) -> None:
    for output in ("one", "two"):
        assert run(["optimize", str(line), *GO, "--output", output]) == 0
    assert Path("one/summary.json").read_bytes() == Path("two/summary.json").read_bytes()


def test_several_files_are_one_program_with_the_cell_and_the_results_of_the_first(line: Path, planner: Planner) -> None:
    task = line / "RAPID/TASK1"
    modules = [task / "PROGMOD/Tiny.mod", task / "SYSMOD/Data.sys"]
    Path("line.yaml").rename(modules[0].with_suffix(".yaml"))
    assert run(["optimize", *map(str, modules), *GO]) == 0
    record = json.loads(Path("results/Tiny/run.json").read_text())
    assert record["options"]["program"] == [str(path) for path in modules]
    assert run(["analyse", *map(str, modules), *GO]) == 0
    assert run(["verify", "results/Tiny/stream.csv", *(f"--program={path}" for path in modules), *GO]) == 0


def test_modules_of_one_name_do_not_take_each_others_place(
    line: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    task = line / "RAPID/TASK1"
    (task / "SYSMOD/Data.sys").rename(task / "SYSMOD/TINY.MOD")
    assert run(["optimize", str(line), *GO]) == 0
    results = Path("results/line")
    for place in ("PROGMOD/Tiny.mod", "SYSMOD/TINY.MOD"):
        assert (results / "input" / place).read_bytes() == (task / place).read_bytes()
        assert (results / "program" / place).is_file()
    assert run(["verify", "results/line"]) == 0
    Path("taken").write_text("")
    for place, said in (
        ("taken", "taken: is a file; the program has 2 modules, --output names a folder for them"),
        ("nowhere/new", "nowhere: is not a folder to write to; make it or correct --output"),
    ):
        capsys.readouterr()
        assert run(["export", "rapid", "results/line", "--output", place]) == 2
        assert capsys.readouterr().err == f"{said}\n"
    assert run(["export", "rapid", "results/line", "--output", "new"]) == 0
    assert {path.relative_to("new").as_posix() for path in Path("new").rglob("*.*")} == {
        "PROGMOD/Tiny.mod",
        "SYSMOD/TINY.MOD",
    }


def test_where_a_folder_has_its_cell_file(
    line: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert run(["analyse", "line", *GO]) == 0
    Path("line/cell.yaml").write_text(CELL)
    assert said(["analyse", "line", *GO], capsys) == (
        "line: has two cell files, line.yaml and line/cell.yaml; say which by --cell\n"
    )
    assert run(["analyse", "line", *GO, "--cell", "line.yaml"]) == 0
    Path("line.yaml").unlink()
    assert run(["analyse", "line/", *GO]) == 0
    monkeypatch.chdir("line")
    assert run(["analyse", ".", *GO]) == 0
    Path("cell.yaml").rename("../line.yaml")
    assert run(["analyse", ".", *GO]) == 0
    Path("../line.yaml").unlink()
    capsys.readouterr()
    first = said(["analyse", ".", *GO], capsys).splitlines()[0]
    assert first == "../line.yaml: . has no cell file; save these lines there and adapt them:"


def test_a_tool_that_nobody_declares_is_named_until_the_user_decides(
    line: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert "tGun" in said(["analyse", "line", "--entry", "go"], capsys)
    assert run(["analyse", "line", *GO]) == 0


def test_motions_that_no_plan_keeps_are_refused_before_any_work(
    line: Path, planner: Planner, capsys: pytest.CaptureFixture[str]
) -> None:
    module = line / "RAPID/TASK1/PROGMOD/Tiny.mod"
    module.write_bytes(module.read_bytes().replace(b"fine", b"fine\\Inpos:=stoptime0_5"))
    for arguments in (["optimize", "line"], ["analyse", "line"], ["compare", "baseline", "line"]):
        message = said([*arguments, *GO], capsys)
        assert f"{module}:4:9: " in message
        assert "stoptime0_5" in message
    assert planner.asked == []


def test_results_of_an_older_run_are_read_with_main(line: Path, planner: Planner) -> None:
    module = line / "RAPID/TASK1/PROGMOD/Tiny.mod"
    module.write_bytes(module.read_bytes().replace(b"Go()", b"main()").replace(b"tGun", b"tool0"))
    assert run(["optimize", "line", "--output", "out"]) == 0
    record = json.loads(Path("out/run.json").read_text())
    record["options"] = {"program": "line", "cell": "line.yaml", "target": "stream"}
    record.pop("added", None)
    Path("out/run.json").write_text(json.dumps(record))
    assert run(["verify", "out"]) == 0
