"""What people get wrong first: another kind of file, a number without its unit, a name written as on the data sheet.

Each is one line that names the thing, and what to write instead.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from trajopt_cli.cell.loader import load_cell, parse_cell
from trajopt_cli.cell.model import minimal_cell
from trajopt_cli.cli import run
from trajopt_cli.errors import InputError
from trajopt_cli.job import cell_path_for
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.rapid.reader import read_program
from trajopt_cli.robot.catalogue import find_robot, robot_names
from trajopt_cli.scenario import MissingError, Scenario
from trajopt_cli.study.places import parse_ranges

PROGRAMS = Path(__file__).parents[2] / "programs"
HINGE, CUBE, PATH = PROGRAMS / "hinge_cell", PROGRAMS / "iiwa_cube.yaml", PROGRAMS / "iiwa_eight.csv"
MOD, CELL = HINGE.with_suffix(".mod"), HINGE.with_suffix(".yaml")
ROBOT = PROGRAMS.parent / "robots" / "irb140.yaml"
KINDS = {MOD: "RAPID program", CELL: "cell file", CUBE: "task file", PATH: "CSV file", ROBOT: "robot file"}


@pytest.mark.parametrize(
    ("arguments", "given", "command"),
    [
        (["optimize", CUBE], CUBE, "iiwa segments"),
        (["optimize", CELL], CELL, "--cell"),
        (["optimize", MOD, "--cell", CUBE], CUBE, "iiwa segments"),
        (["optimize", MOD, "--cell", MOD], MOD, "optimize"),
        (["estimate", ROBOT], ROBOT, "robot:"),
        (["parse", CUBE], CUBE, "iiwa segments"),
        (["compare", "baseline", PATH], PATH, "verify"),
        (["verify", MOD], MOD, "optimize"),
        (["verify", CELL, "--program", MOD], CELL, "--cell"),
        (["view", MOD], MOD, "optimize"),
        (["export", "joint", CELL], CELL, "--cell"),
        (["iiwa", "segments", CELL], CELL, "--cell"),
        (["iiwa", "simulate", MOD], MOD, "optimize"),
    ],
)
def test_a_file_of_another_kind_is_named_with_the_command_that_takes_it(
    arguments: list[object], given: Path, command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run([str(one) for one in arguments]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith(f"{given}: is a")
    assert KINDS[given] in line
    assert command in line


@pytest.mark.parametrize("name", ["IRB140", "IRB 140", "irb-140", "irb_140"])
def test_robots_are_found_as_people_write_them(name: str) -> None:
    assert find_robot(name) == find_robot("irb140")


def test_every_robot_has_a_name_of_its_own_however_it_is_written() -> None:
    assert len({find_robot(name.upper().replace("_", "-")) for name in robot_names()}) == len(robot_names())


def test_a_rail_section_for_an_arm_alone_offers_the_same_arm_on_a_rail() -> None:
    cell = parse_cell(CELL.read_text().replace("irb140_rail", "irb140"), "cell.yaml")
    with pytest.raises(InputError, match=r"cell\.yaml:5: rail: .*irb140_rail"):
        build_plant(cell)


def test_angles_without_a_unit_are_offered_in_degrees() -> None:
    with pytest.raises(InputError, match=r'start\.joints: .*write "\[0, 0, 0, 0, 30, 0\] deg"'):
        parse_cell(CELL.read_text().replace("] deg", "]"), "cell.yaml")


@pytest.mark.parametrize("text", ["height=-10..0", "x=0..300"])
def test_lengths_of_many_metres_are_asked_about(text: str) -> None:
    with pytest.raises(InputError, match=r"mm"):
        parse_ranges([text])
    assert len(parse_ranges([text.replace("..", "mm..") + "mm"])) == 1


@pytest.mark.parametrize(
    ("name", "value"), [("v55", "[55,500,5000,1000]"), ("z25", "[FALSE,25,37.5,37.5,3.75,37.5,3.75]")]
)
def test_a_speed_or_zone_that_is_not_predefined_gets_its_own_declaration(name: str, value: str, tmp_path: Path) -> None:
    """v50 and z20 are predefined, [50,500,5000,1000] and [FALSE,20,30,30,3,30,3]: the same rule."""
    speed, zone = (name, "fine") if name[0] == "v" else ("v50", name)
    path = tmp_path / "m.mod"
    point = "[[500,200,450],[0,0,1,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]]"
    path.write_text(f"MODULE m\nPROC main()\nMoveJ {point},{speed},{zone},tool0;\nENDPROC\nENDMODULE\n")
    with pytest.raises(MissingError) as caught:
        read_program([path], Scenario())
    kind = "speeddata" if name[0] == "v" else "zonedata"
    assert f"CONST {kind} {name}:={value};" in caught.value.message
    assert "did you mean" not in caught.value.message


def test_the_cell_file_that_is_offered_suits_the_program() -> None:
    targets = "[[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,-300,9E+09,9E9,9E9,9E9]] [[0,0,0,0,0,0],[9E9,3500,9E9,9E9,9E9,9E9]]"
    text = minimal_cell("m.mod", f"! IRB1600 on track\n{targets}", robot_names())
    cell = parse_cell(text, "m.yaml")
    assert cell.robot.startswith("irb1600")
    assert cell.rail is not None
    assert cell.rail.eax == 1
    assert cell.rail.stroke == pytest.approx((-0.5, 3.7))
    alone = parse_cell(minimal_cell("m.mod", targets.replace("-300", "9E9").replace("3500", "9E9"), robot_names()), "m")
    assert (alone.robot, alone.rail) == ("irb140", None)


def test_an_export_without_output_goes_into_the_folder_and_is_no_stranger_there(
    results: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for _ in range(2):  # it may be written over
        assert run(["export", "joint", "results/tiny"]) == 0
    written = Path("results/tiny/joint.csv")
    assert written.read_text().startswith("t [s],")
    assert run(["verify", "results/tiny", "-q"]) == 0
    there = tmp_path / "elsewhere"
    there.mkdir()
    monkeypatch.chdir(there)
    before = (tmp_path / "tiny.mod").read_bytes()
    assert run(["export", "rapid", "../results/tiny", "--in-place"]) == 0
    assert (tmp_path / "tiny.mod.bak").exists() == ((tmp_path / "tiny.mod").read_bytes() != before)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "tiny.mod").write_bytes(before)
    assert run(["optimize", "tiny.mod", "-q"]) == 0
    assert not written.exists()


@pytest.mark.parametrize(("words", "meant"), [(["export", "csv", "x"], "joint"), (["optimise", "x"], "optimize")])
def test_other_words_for_a_command_find_it(words: list[str], meant: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(words) == 2
    assert f"'{meant}'" in capsys.readouterr().err


def test_an_option_that_is_like_none_suggests_none(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["optimize", str(MOD), "--tool", "x"]) == 2
    assert "--loops" not in capsys.readouterr().err
    assert load_cell(CELL).rail is not None  # the file itself is fine


def test_an_export_never_writes_over_the_program(
    program: Path, request: pytest.FixtureRequest, capsys: pytest.CaptureFixture[str]
) -> None:
    before = program.read_bytes()
    assert run(["optimize", "tiny.mod", "--export", "./tiny.mod", "-q"]) == 2
    assert "--in-place" in capsys.readouterr().err
    assert not Path("results").exists()
    results = request.getfixturevalue("results")
    assert run(["export", "rapid", str(results), "--output", "tiny.mod"]) == 2
    assert program.read_bytes() == before


def test_the_only_cell_file_of_a_folder_is_its_cell(tmp_path: Path) -> None:
    shutil.copy(MOD, tmp_path)
    shutil.copy(CELL, tmp_path / "other_name.yaml")
    shutil.copy(CUBE, tmp_path)
    assert cell_path_for([tmp_path]) == tmp_path / "other_name.yaml"
    shutil.copy(CELL, tmp_path / "third.yaml")
    assert cell_path_for([tmp_path]).parent == tmp_path.parent  # which of them, nobody says


@pytest.mark.parametrize("name", ["irb4600", "irb6700"])
def test_the_beginning_of_a_robots_name_finds_it(name: str) -> None:
    with pytest.raises(InputError, match=f"did you mean '{name}_"):
        find_robot(name)


def test_speeds_that_are_estimates_are_told_like_accelerations() -> None:
    """The rail of hinge_cell has the cell's own speed; without that it is a guess of the robot's file."""
    text = CELL.read_text()
    own, guess = (build_plant(parse_cell(one, "c.yaml")) for one in (text, text.replace("velocity: 1.0, ", "")))
    assert not any("speeds of rail" in note for note in own.notes)
    assert any("speeds of rail" in note for note in guess.notes)
