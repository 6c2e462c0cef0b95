"""Numbers are written in digits 0 to 9: what Python alone takes for one, 1_0 and digits of other scripts, is none."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from pydantic_core import PydanticCustomError

from trajopt_cli.cli import run
from trajopt_cli.errors import InputError
from trajopt_cli.iiwa.judge.samples import read_table
from trajopt_cli.iiwa.task.equilibrium import read_numbers
from trajopt_cli.joint_csv import read_csv_text
from trajopt_cli.moc import read_moc
from trajopt_cli.motion import TextFile
from trajopt_cli.quantity import LENGTH, number, numbers
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.robot.urdf import chain_of
from trajopt_cli.yaml_file import parse


def rapid(number: str) -> object:
    target = f"[[{number},0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]]"
    text = f"MODULE m\nPROC main()\nMoveAbsJ {target},v100,fine,tool0;\nENDPROC\nENDMODULE\n"
    return run_program([TextFile("m.mod", text, "utf-8")])


def urdf(number: str) -> object:
    joint = f'<joint name="j" type="revolute"><origin xyz="{number} 0 0" rpy="0 0 0"/><parent link="a"/>'
    limit = '<child link="tool0"/><axis xyz="0 0 1"/><limit lower="0" upper="1" velocity="1" effort="1"/></joint>'
    return chain_of(f'<robot name="r"><link name="a"/><link name="tool0"/>{joint}{limit}</robot>'.encode(), "r.urdf")


def moc(number: str) -> object:
    text = f'MOC:CFG_1.0:6:0::\n#\nROBOT:\n\n      -name "R" -base_frame_pos_x {number}\n'
    if notices := [one for one in read_moc(text, "MOC.cfg").notices if "base_frame_pos_x" in one.text]:
        raise InputError("", line=int(str(notices[0].place).split(":")[1]))
    return None


READERS: dict[str, tuple[Callable[[str], object], int | None]] = {  # and the line that is told
    "RAPID": (rapid, 3),
    "joint CSV": (lambda x: read_csv_text(f"t [s],joint_1 [rad]\n0,1\n1,{x}\n2,1\n", "a.csv"), 3),
    "iiwa CSV": (lambda x: read_table(f"t [s],a\n0,1\n1,{x}\n2,1\n", "a.csv", ("t [s]",)), 3),
    "equilibrium CSV": (lambda x: read_numbers(["0,1", f"1,{x}"], 2, "a.csv"), 3),
    "YAML": (lambda x: number(LENGTH)(parse(f"a: 1\nb: {x}\n", "c.yaml", "")[0]["b"]), 2),
    "with a unit": (lambda x: number(LENGTH)(f"{x} mm"), None),
    "in a list": (lambda x: numbers(LENGTH)(f"[1, {x}] mm"), None),
    "URDF": (urdf, None),
    "MOC.cfg": (moc, 5),
}


@pytest.mark.parametrize("reader", READERS)
def test_every_reader_takes_ascii_digits_alone(reader: str) -> None:
    read, line = READERS[reader]
    read("10")
    for odd in ("1_0", "1_0.5", "٣", "1\N{FULLWIDTH DIGIT ZERO}"):
        with pytest.raises((InputError, PydanticCustomError)) as caught:
            read(odd)
        if isinstance(caught.value, InputError):
            assert caught.value.line == line


@pytest.mark.parametrize("option", ["--time-limit 1_0", "--time-limit=1_0", "--jobs 1_0", "--jobs ٢"])
def test_options_that_are_numbers_take_ascii_digits_alone(option: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["optimize", "programs/hinge_cell.mod", *option.split()]) == 2
    assert option[:6] in capsys.readouterr().err


def test_names_may_have_what_numbers_may_not(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["parse", "1_0", "--entry", "2_0"]) == 2
    assert "1_0: cannot be read" in capsys.readouterr().err
    assert parse("a: '1_0'\n", "c.yaml", "")[0] == {"a": "1_0"}
