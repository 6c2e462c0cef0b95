"""`trajopt new`: what it writes runs at once, on every robot that ships; nothing is overwritten."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from unrefined import coarse_search

from trajopt_cli.cli import run
from trajopt_cli.robot.model import robot_names
from trajopt_cli.robot.structure import Structure

SIX, SRS = robot_names(Structure.SIX_AXIS), robot_names(Structure.SRS)


@pytest.mark.parametrize("robot", ["irb140_rail", "puma560", "ur5e"])
def test_a_new_program_is_planned_at_once(
    robot: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    coarse_search(monkeypatch)
    assert run(["new", "first", "--robot", robot]) == 0
    assert capsys.readouterr().out.splitlines()[-1] == "next: trajopt optimize first.mod"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["first.mod", "first.yaml"]
    assert run(["parse", "first.mod"]) == 0
    parsed = capsys.readouterr().out
    assert "configurations: every point and line fits the robot" in parsed
    assert "warning" not in parsed
    assert run(["optimize", "first.mod", "--time-limit", "0", "--json", "--quiet", "--jobs", "1"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["as_written"]["cycle_time_s"] >= answer["plans"]["rapid"]["cycle_time_s"] > 1.0
    assert not [line for line in answer["warnings"] if "waits: {rail: free}" not in line]


@pytest.mark.parametrize("robot", ["irb1200_5_90", "irb6700_200_260"])
def test_a_new_program_fits_large_robots_and_small_ones(
    robot: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run(["new", "first", "--robot", robot]) == 0
    assert run(["parse", "first.mod"]) == 0
    assert "configurations: every point and line fits the robot" in capsys.readouterr().out


def test_the_robot_is_an_irb140_on_a_rail_where_that_is_asked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for name, options in (("a", []), ("b", ["--rail"]), ("c", ["--rail", "--robot", "irb140_rail"])):
        assert run(["new", name, *options]) == 0
    first, second, third = (Path(f"{name}.yaml").read_text().replace(f" {name}.mod", "") for name in "abc")
    assert "robot: irb140 " in first
    assert "\nrail:" not in first
    assert "robot: irb140_rail " in second
    assert second == third


@pytest.mark.parametrize("name", SRS)
def test_a_new_task_of_an_iiwa_runs(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert run(["new", "square", "--robot", name]) == 0
    assert run(["iiwa", "segments", "square.yaml"]) == 0
    assert run(["iiwa", "joints", "results/square"]) == 0


def test_a_comment_stands_beside_whatever_is_not_plain() -> None:
    from trajopt_cli.cli.new_files import program_and_cell
    from trajopt_cli.robot.model import load_robot

    for name in SIX:
        module, cell = program_and_cell("glue", load_robot(name))
        assert re.match(r"MODULE glue\n", module)
        assert module.count("!") >= 10
        assert cell.count("#") >= 10
        assert max(map(len, (module + cell).splitlines())) <= 120


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["3d"], "'3d' is no RAPID name: a letter first, then letters, digits and underscores"),
        (["my-part"], "'my-part' is no RAPID name"),
        (["a" * 33], f"'{'a' * 33}' has 33 characters; a RAPID name has at most 32"),
        (["while"], "'while' is a word of RAPID's own"),
        (["main"], "'main' is the name of something in the module"),
        (["part", "--robot", "irb14"], "unknown robot 'irb14'"),
        (["part", "--robot", "iiwa7", "--rail"], "--rail: iiwa7 has none"),
        (["nowhere/part"], "nowhere: is not a folder to write to"),
        (["old"], "old.yaml: exists and is not overwritten"),
    ],
)
def test_what_cannot_be_made_is_said_and_nothing_written(
    arguments: list[str],
    said: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("old.yaml").write_text("mine")
    assert run(["new", *arguments]) == 2
    assert capsys.readouterr().err.startswith(said)
    assert [path.name for path in tmp_path.iterdir()] == ["old.yaml"]
    assert Path("old.yaml").read_text() == "mine"


def test_a_path_leads_where_it_is_written(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["new", str(tmp_path / "part.mod"), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["next"] == f"trajopt optimize {tmp_path / 'part'}.mod"
    assert (tmp_path / "part.mod").read_text().startswith("MODULE part\n")
