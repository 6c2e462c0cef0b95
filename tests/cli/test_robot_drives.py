"""What `robot show` says of drives and masses, where a robot's files have them."""

from pathlib import Path

import pytest
from typer.testing import CliRunner

from trajopt_cli.cli import app, run

PROGRAMS = Path(__file__).parents[2] / "programs"


def test_torques_rotors_and_masses_are_shown_with_their_grades() -> None:
    shown = [
        " ".join(line.split()) for line in CliRunner().invoke(app, ["robot", "show", "puma560"]).stdout.splitlines()
    ]
    assert any(line.startswith("joint_2 ±186.4 Nm B [") and " 4.71 kg m² B [" in line for line in shown)
    assert any(line.startswith("link_2 17.4 68 ") for line in shown)
    bare = CliRunner().invoke(app, ["robot", "show", "irb140"]).stdout
    assert "drives" not in bare
    assert "links" not in bare


def test_what_torque_limits_cost_is_no_lever_yet(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["sensitivity", str(PROGRAMS / "puma_torque.mod")]) == 2
    assert "torque_limits: sensitivity does not know what they cost" in capsys.readouterr().err
