"""Every command's help ends with an example, and the example works."""

from __future__ import annotations

import re
import shlex
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import typer
from loose_arm import written
from unrefined import IMPROVED, as_it_comes, set_defaults

from trajopt_cli.cli import app, run
from trajopt_cli.cli.new_files import task
from trajopt_cli.errors import InputError
from trajopt_cli.parameter_study.point import blank
from trajopt_cli.parameter_study.results import new_or_same
from trajopt_cli.parameter_study.study_file import read_study

REPOSITORY = Path(__file__).parents[2]
# As examples name it, with the cell's robot: the time of the real one is spent elsewhere.
SMALL = """MODULE HingeCell
    CONST jointtarget j_home:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j_side:=[[20,0,0,0,30,0],[100,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveAbsJ j_side, vmax, fine, tool0;
        WaitTime 0.3;
        MoveAbsJ j_home, vmax, fine, tool0;
    ENDPROC
ENDMODULE
"""


def commands(group: Any, path: tuple[str, ...] = ()) -> Iterator[tuple[str, str]]:
    """Every command's path and its help."""
    for name, one in group.commands.items():
        if hasattr(one, "commands"):
            yield from commands(one, (*path, name))
        else:
            yield " ".join((*path, name)), one.help or ""


LONG = ("study optimize", "study run")
COMMANDS = dict(commands(typer.main.get_command(app)))


def example(text: str) -> list[str]:
    """The lines of an example."""
    _, found, rest = text.partition("Example:\n")
    return [line.strip() for line in rest.splitlines() if line.strip()] if found else []


EXAMPLES = {name: example(text) for name, text in COMMANDS.items()}


def log() -> str:
    """A controller's log: joint 1 there and back over 40 to 120 degrees, at most 100 deg/s and 500 deg/s2."""
    v, a, begin, rows = 100.0, 500.0, 0.0, ["t [s]," + ",".join(f"joint_{i} [deg]" for i in range(1, 7))]
    ways = [way * sign for way in (40.0, 80.0, 120.0) for sign in (1, -1)]
    t = np.arange(0, sum(abs(way) / v + v / a + 0.3 for way in ways), 0.01)
    q = np.zeros_like(t)
    for way in ways:
        T = abs(way) / v + v / a
        at = np.clip(t - begin, 0, T)
        ramp, cruise, out = np.minimum(at, v / a), np.clip(at, v / a, T - v / a) - v / a, np.maximum(at - T + v / a, 0)
        q += np.sign(way) * (a * ramp**2 / 2 + v * cruise + v * out - a * out**2 / 2)
        begin += T + 0.3
    return "\n".join([*rows, *(f"{now:.3f},{x:.4f},0,0,0,30,0" for now, x in zip(t, q, strict=True))]) + "\n"


@pytest.fixture(scope="module")
def prepared(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with programs/, and results of those that examples ask about."""
    folder = tmp_path_factory.mktemp("examples")
    written(folder, name="welder_arm.urdf")
    shutil.copytree(REPOSITORY / "programs", folder / "programs")
    (folder / "programs" / "hinge_cell.mod").write_text(SMALL)
    cell = folder / "programs" / "hinge_cell.yaml"  # no cap of the tool binds
    cell.write_text(re.sub("tcp: .*", "tcp: {speed: 9, acceleration: 90, source: none}", cell.read_text()))
    few = re.compile(r"^ +Rivet[3-9];\n|(?<=Rivet2), Rivet3.*(?=\])", re.MULTILINE)
    for name in ("rivets.mod", "rivets.yaml"):
        text, count = few.subn("", (REPOSITORY / "programs" / name).read_text())
        assert count
        (folder / "programs" / name).write_text(text)
    (folder / "log.csv").write_text(log())
    backup = folder / "backups/line_1/RAPID/TASK1"
    backup.mkdir(parents=True)
    (backup / "hinge_cell.mod").write_text(SMALL)
    shutil.copy(cell, folder / "backups" / "line_1.yaml")
    text, count = re.subn(r" +- {name: c, .*\n(?: +- .*\n)*", "", task("iiwa_cube", "iiwa7"))  # one side of the square
    assert count == 1
    (folder / "programs" / "iiwa_cube.yaml").write_text(text)
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        patch.setattr(IMPROVED, as_it_comes)
        assert run(["optimize", "programs/hinge_cell.mod", "--quiet", "--jobs", "1"]) == 0
        assert run(["iiwa", "segments", "programs/iiwa_cube.yaml", "--quiet"]) == 0
        assert run(["iiwa", "joints", "results/iiwa_cube", "--quiet"]) == 0
    shutil.copytree(folder / "results" / "hinge_cell", folder / "results" / "gentle")
    asked = read_study(folder / "programs" / "studies" / "which_rail.yaml")
    points = [asked.design.point(i) for i in range(len(asked.design))]
    rows = [{**blank(asked.inputs, one, "ok", ""), "rapid_s": 6.0 + one.index, "saved_s": 1.0} for one in points]
    new_or_same(folder / "results" / "which_rail", asked).write_part(rows, [])
    return folder


@pytest.mark.usefixtures("unrefined")
@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=[pytest.mark.long] if name in LONG else []) for name in COMMANDS]
)
def test_the_example_of_a_help_works(
    name: str, prepared: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    lines = EXAMPLES[name]
    assert any(line.startswith(f"trajopt {name} ") or line == f"trajopt {name}" for line in lines), COMMANDS[name]
    shutil.copytree(prepared, tmp_path / "here")
    monkeypatch.chdir(tmp_path / "here")

    def stand_in(*_: object) -> None:
        raise InputError("a minute is saved")

    monkeypatch.setattr("trajopt_cli.iiwa.experiments.catalogue.run_experiments", stand_in)
    for place, few in (
        ("study.place.EACH", 3), ("study.place.FEW", 1), ("study.order.PLANNED", 0), ("study.order._NEAR", 0),
        ("plan.rail_refinement._REFINE_ROUNDS", 1),
    ):  # fmt: skip
        monkeypatch.setattr(f"trajopt_cli.{place}", few)
    set_defaults(monkeypatch, coarse_spacing=0.4, polished_legs=0)
    for line in lines:
        assert len(line) <= 76
        program, *words = shlex.split(line)
        assert program == "trajopt"
        if line.startswith(f"trajopt {name}"):
            assert run(words) == (2 if name == "iiwa experiments" else 0), line
        else:  # what comes before or after: an example of another command
            assert any(line.startswith(f"trajopt {other}") for other in COMMANDS), line
