"""ros2_controllers' admittance parameters as a task's controller: the law of its admittance rule, stepped anew here."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.cli import run
from trajopt_cli.errors import InputError
from trajopt_cli.iiwa.task.loader import parse_task

MASS, ZETA, STIFFNESS, JOINT_DAMPING = (
    [6.0, 8.0, 4.0, 1.0, 1.5, 2.0],
    [1.0, 0.8, 1.2, 1, 1, 1],
    [400.0, 500, 0, 40, 30, 20],
    3.0,
)
FILE = f"""\
controller_manager:
  ros__parameters:
    update_rate: 500
/**/admittance_controller:
  ros__parameters:
    joints: [A1, A2, A3, A4, A5, A6, A7]
    control: {{frame: {{id: lbr_link_ee}}}}
    admittance:
      selected_axes: [true, true, true, true, true, false]
      mass: {MASS}
      damping_ratio: {ZETA}
      stiffness: {STIFFNESS}
      joint_damping: {JOINT_DAMPING}
"""
TASK = """\
start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
controller: ros.yaml
h: 2 ms
rotation: slerp
v_max: 0.1
omega_max: 0.5
"""


def test_its_numbers_are_the_controllers(tmp_path: Path) -> None:
    (tmp_path / "ros.yaml").write_text(FILE)
    task = parse_task(TASK + "poses: [start, {by: [0, 0, 0.1, 0, 0, 0]}]\n", str(tmp_path / "t.yaml"))
    law = task.compliance
    np.testing.assert_array_equal(law.K, STIFFNESS)
    np.testing.assert_array_equal(law.M, MASS)
    ratio = (law.D - JOINT_DAMPING * law.M)[:2] / (2 * np.sqrt(law.M * law.K))[:2]
    np.testing.assert_allclose(ratio, ZETA[:2])  # zeta = D / (2 sqrt(M S)), its documentation
    assert law.D[2] == pytest.approx(JOINT_DAMPING * MASS[2])
    assert task.zeroing.zeroed == (False,) * 5 + (True,)


def test_a_push_moves_the_tool_as_its_rule_does(tmp_path: Path) -> None:
    """admittance_rule_impl.hpp's update: X'' = (F - D X' - K X) / M, less joint_damping of the joints' speeds."""
    (tmp_path / "ros.yaml").write_text(FILE)
    more = "poses: [start, {by: [0, 0, 0, 0, 0, 0], dwell: 1.0}]\n"
    more += "pushes: [{from: 0.1, to: 0.6, force: [8, -6, 2, 0, 0, 1]}]\n"
    (tmp_path / "t.yaml").write_text(TASK + more)
    assert run(["iiwa", "segments", str(tmp_path / "t.yaml"), "--output", str(tmp_path / "out"), "-q"]) == 0
    assert run(["iiwa", "simulate", str(tmp_path / "out"), "--settle", "0", "-q"]) == 0
    table = np.genfromtxt(tmp_path / "out/simulation.csv", delimiter=",", names=True)
    M, S, h = np.array(MASS[:3]), np.array(STIFFNESS[:3]), 0.002
    D = 2 * np.array(ZETA[:3]) * np.sqrt(M * S)
    x, v, own = np.zeros(3), np.zeros(3), []
    for t in table["t_s"]:
        own.append(x)
        F = np.array([8, -6, 2]) * (0.1 <= t + 1e-9 < 0.6)
        v = v + h * ((F - D * v - S * x) / M - JOINT_DAMPING * v)
        x = x + h * v
    moved = np.column_stack([table[f"{a}_m"] - table[f"{a}_m"][0] for a in "xyz"])
    assert np.abs(own).max() > 0.01
    np.testing.assert_allclose(moved, own, atol=4e-4)  # it takes the new speed, the forward Euler here the old one
    assert np.ptp(table["gamma_rad"]) < 1e-9  # not selected


def test_a_path_is_followed_at_once(tmp_path: Path) -> None:
    (tmp_path / "ros.yaml").write_text(FILE)
    ramps = "profile: s-curve\na_max: 0.5\nepsilon_max: 1\njerk: 5\nangular_jerk: 9\n"
    (tmp_path / "t.yaml").write_text(TASK + ramps + "poses: [start, {by: [0.1, 0, 0, 0, 0, 0]}]\n")
    assert run(["iiwa", "segments", str(tmp_path / "t.yaml"), "--output", str(tmp_path / "out"), "-q"]) == 0
    assert run(["iiwa", "simulate", str(tmp_path / "out"), "-q"]) == 0
    section = json.loads((tmp_path / "out/summary.json").read_text())["simulation"]
    assert section["feed"] == "velocity"
    assert section["lag"]["largest_m"] < 0.01  # fed positions alone it would be D v / K = 24 mm
    assert run(["verify", str(tmp_path / "out"), "-q"]) == 0


def test_what_would_crash_is_refused_before(tmp_path: Path) -> None:
    """Their issue 1169: another joint_damping made a large sudden motion; above 2/h it does."""
    (tmp_path / "ros.yaml").write_text(FILE.replace(f"joint_damping: {JOINT_DAMPING}", "joint_damping: 1200"))
    (tmp_path / "t.yaml").write_text(TASK + "poses: [start, {by: [0.1, 0, 0, 0, 0, 0]}]\n")
    assert run(["iiwa", "segments", str(tmp_path / "t.yaml"), "--output", str(tmp_path / "out"), "-q"]) == 0
    assert run(["iiwa", "simulate", str(tmp_path / "out"), "-q"]) == 1


@pytest.mark.parametrize(
    ("old", "new", "line"),
    [
        ("mass: [6.0", "mass: [0.0", 10),
        ("damping_ratio: [1.0, ", "damping_ratio: [", 11),
        ("false]", "0]", 9),
        ("    admittance:", "    admittances:", 1),
        ("/**/admittance_controller:", "other: {ros__parameters: {admittance: {}}}\n/**/admittance_controller:", 1),
    ],
)
def test_its_mistakes_have_their_line(tmp_path: Path, old: str, new: str, line: int) -> None:
    assert old in FILE
    (tmp_path / "ros.yaml").write_text(FILE.replace(old, new))
    with pytest.raises(InputError) as found:
        parse_task(TASK + "poses: [start, {by: [0, 0, 0.1, 0, 0, 0]}]\n", str(tmp_path / "t.yaml"))
    assert f"ros.yaml:{line}:" in str(found.value)


def test_one_of_several_is_named(tmp_path: Path) -> None:
    (tmp_path / "ros.yaml").write_text("other: {ros__parameters: {admittance: {}}}\n" + FILE)
    text = TASK.replace("ros.yaml", "ros.yaml:admittance_controller") + "poses: [start, {by: [0, 0, 0.1, 0, 0, 0]}]\n"
    assert parse_task(text, str(tmp_path / "t.yaml")).compliance.M[0] == MASS[0]
