"""What a simulated world tells: links in obstacles, motors at their limit, where the tool itself was."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.cli import run
from trajopt_cli.robot.srs import load_srs

TASK = """\
start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
profile: trapezoid
poses:
  - {name: start, at: start}
  - {name: goal, by: GOAL}
v_max: 0.3
omega_max: 1
a_max: 2
epsilon_max: 5
K: [1000, 1000, 1000, 30, 30, 30]
D: [300, 300, 300, 20, 20, 20]
M: [25, 25, 25, 3, 3, 3]
"""
BEAM = """\
tool: {position: [0, 0, 0.1]}
contact:
  tip: 0.02
  obstacles:
    beam: {box: {size: [0.5, 0.5, 0.1], position: [0.2, 0, 0.83]}, stiffness: 20 N/mm, damping: 100, friction: 0.2}
"""
HEAVY = "tool: {position: [0, 0, 0.1], load: {mass: 40, com: [0, 0, 0.1], inertia: [0.1, 0.1, 0.1]}}\n"
PLATE = """\
tool: {position: [0, 0, 0.1], load: {mass: 0.5, com: [0, 0, 0.05], inertia: [1e-3, 1e-3, 1e-3]}}
contact:
  tip: 0.03
  obstacles:
    plate: {box: {size: [0.3, 0.3, 0.02], position: [0.5064, 0, 0.1]}, stiffness: 20 N/mm, damping: 100, friction: 0}
"""


def simulated(tmp_path: Path, goal: str, rest: str, *options: str) -> dict[str, object]:
    """The section of summary.json after a run of TASK."""
    task = tmp_path / "task.yaml"
    task.write_text(TASK.replace("GOAL", goal) + rest)
    folder = tmp_path / "out"
    assert run(["iiwa", "segments", str(task), "--output", str(folder)]) == 0
    assert run(["iiwa", "simulate", str(folder), *options]) == 0
    section = json.loads((folder / "summary.json").read_text())["simulation"]
    assert isinstance(section, dict)
    return section


@pytest.mark.parametrize("engine", ["spring", "mujoco"])
def test_links_in_an_obstacle_are_told(tmp_path: Path, engine: str, capsys: pytest.CaptureFixture[str]) -> None:
    if engine == "mujoco":
        pytest.importorskip("mujoco")
    found = simulated(tmp_path, "[0, 0, 0.15, 0, 0, 0]", BEAM, "--engine", engine, "--settle", "0.2")
    out = capsys.readouterr().out
    assert "the tool touches nothing" in out
    links = found["links_in_obstacles"]
    assert isinstance(links, list)
    assert {(one["link"], one["obstacle"]) for one in links} == {("link_3", "beam"), ("link_4", "beam")}
    for one in links:
        line = next(line for line in out.splitlines() if line.startswith(f"{one['link']} is in beam from "))
        if engine == "spring":
            assert one["largest_force_N"] is None
            assert "not pushed back: only MuJoCo does" in line
        else:
            assert one["largest_force_N"] > 1
            assert f"with up to {one['largest_force_N']:.1f} N" in line
    assert bool(found["motors"]) == (engine == "mujoco")


def test_motors_at_their_limit_are_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("mujoco")
    options = ("--engine", "mujoco", "--settle", "0")
    found = simulated(tmp_path, "[0, 0.02, 0, 0, 0, 0]", HEAVY, *options)
    out = capsys.readouterr().out
    assert "motors reach their torque limit, so that the arm leaves its command: first joint_2 at 0.001 s" in out
    motors = {one["joint"]: one for one in found["motors"]}  # type: ignore[attr-defined]
    assert motors["joint_2"]["largest_torque_Nm"] == motors["joint_2"]["limit_Nm"] == 176
    assert motors["joint_1"]["saturated_at_s"] is None
    light = simulated(tmp_path, "[0, 0.02, 0, 0, 0, 0]", "", *options)
    assert all(one["saturated_at_s"] is None for one in light["motors"])  # type: ignore[attr-defined]
    assert "motors: joint_2 gives up to " in capsys.readouterr().out


def test_the_tools_distance_is_where_the_arm_stands_and_the_controllers_beside_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """From the joints in simulation.csv by forward kinematics, while the depth is above zero."""
    pytest.importorskip("mujoco")
    found = simulated(tmp_path, "[0, 0, -0.08, 0, 0, 0]", PLATE, "--engine", "mujoco", "--settle", "0.4")
    heads, *rows = (tmp_path / "out" / "simulation.csv").read_text().splitlines()
    table = dict(zip(heads.split(","), np.array([row.split(",") for row in rows], dtype=float).T, strict=True))
    q = np.column_stack([table[f"joint_{i} [rad]"] for i in range(1, 8)])
    X = load_srs("iiwa7").forward(q)
    p = X[:, :3, 3] + 0.1 * X[:, :3, 2]
    planned, own = (np.column_stack([table[f"{axis}{tail} [m]"] for axis in "xyz"]) for tail in ("_e", ""))
    on = table["depth [m]"] > 0
    assert on.sum() > 100
    contact = found["contact"]
    assert isinstance(contact, dict)
    tool, controller = (np.abs(pose - planned)[on].max(axis=0) for pose in (p, own))
    np.testing.assert_allclose(contact["largest_excursion_per_axis_m"], tool, rtol=0, atol=1e-8)
    np.testing.assert_allclose(contact["controllers_excursion_per_axis_m"], controller, rtol=0, atol=1e-8)
    assert abs(tool[2] - controller[2]) > 1e-4
    assert f"z {1e3 * tool[2]:.2f} mm (the controller's own pose: " in capsys.readouterr().out
