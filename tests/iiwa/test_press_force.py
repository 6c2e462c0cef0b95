"""Pressing with a force: what the equilibrium is moved by, and what the tool presses with on plate and cylinder."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.cli import run
from trajopt_cli.errors import InputError
from trajopt_cli.iiwa.task.loader import parse_task

HEAD = """\
start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
tool: {position: [0, 0, 0.08], load: {mass: 0.9, com: [0, 0, 0.04], inertia: [1.6e-3, 1.6e-3, 8e-4]}}
profile: s-curve
rotation: slerp
v_max: 0.12
omega_max: 0.7
a_max: 0.8
epsilon_max: 3
jerk: 8
angular_jerk: 30
K: [1500, 1500, 800, 60, 60, 60]
D: [450, 450, 400, 20, 20, 20]
M: [25, 25, 25, 3, 3, 3]
"""
K_Z, GIVE = 800.0, 20e3
TOP, TIP = 0.16, 0.02  # m
PLATE = """\
contact:
  tip: 0.02
  obstacles:
    plate: {box: {size: [0.4, 0.4, 0.02], position: [0.5, 0, 0.15]}, stiffness: 20 N/mm, damping: 40, friction: 0.25}
"""
ROUND = "plate: {capsule: {from: [0, 0, 0], to: [1, 0, 0], radius: 1}, "
LANES = """\
poses:
  - {name: start, at: start}
  - {name: on it, at: [0.48, -0.08, 0.18, 0, 6 deg, 0], dwell: 0.5, force: 20 N}
  - {name: lane 1, by: [0.06, 0, 0, 0, 0, 0], force: 20 N}
  - {name: lane 2, by: [0, 0.04, 0, 0, 0, 0], force: 20 N}
  - {name: lifted, by: [0, 0, 0.05, 0, 0, 0]}
"""
AXIS, RADIUS = 0.05, 0.1  # m: the cylinder lies along x at this height
PIPE = """\
contact:
  tip: 0.02
  obstacles:
    pipe: {capsule: {from: [0.3, 0, 0.05], to: [0.7, 0, 0.05], radius: 0.1}, stiffness: 2e4, damping: 40, friction: 0.2}
"""


def arc() -> str:
    """A task's path around the cylinder, the tool upright on it, without a stop once the force is there."""
    rows = ["passing: {tolerance: 0.1 mm}", "force: {value: 20, along: normal, lead: true}", "poses:"]
    for degrees in range(-25, 26, 1):
        a = np.radians(degrees)
        y, z = (RADIUS + TIP) * np.sin(a), AXIS + (RADIUS + TIP) * np.cos(a)
        dwell = ", dwell: 0.5" if degrees == -25 else ""
        rows.append(f"  - {{at: [0.52, {y:.9f}, {z:.9f}, {-degrees} deg, 0, 0]{dwell}}}")
    return "\n".join(rows) + "\n"


def ran(folder: Path, task: str, *options: str) -> tuple[dict[str, np.ndarray], dict[str, object]]:
    """simulation.csv's columns and its section of summary.json."""
    (folder / "task.yaml").write_text(task)
    assert run(["iiwa", "segments", str(folder / "task.yaml"), "--output", str(folder / "out"), "-q"]) == 0
    assert run(["iiwa", "simulate", str(folder / "out"), "-q", *options]) == 0
    table = np.genfromtxt(folder / "out/simulation.csv", delimiter=",", names=True)
    section = json.loads((folder / "out/summary.json").read_text())["simulation"]
    return {name: table[name] for name in table.dtype.names}, section


def moving(section: dict[str, object]) -> list[dict[str, float]]:
    """The pressed segments but the one in which the force comes."""
    return [one for one in section["forces"] if one["from"] != one["to"]]  # type: ignore[attr-defined]


@pytest.mark.long
@pytest.mark.parametrize("by", ["offset", "wrench"])
def test_a_plate_is_pressed_as_asked(tmp_path: Path, by: str) -> None:
    task = f"{HEAD}{LANES}{PLATE}force: {{along: -z, lead: true, by: {by}}}\n"
    table, section = ran(tmp_path, task, "--engine", "spring")
    lanes = moving(section)
    assert [one["to"] for one in lanes] == ["lane 1", "lane 2"]
    for one in lanes:
        rows = (table["t_s"] >= one["start_s"]) & (table["t_s"] <= one["end_s"])
        own = GIVE * (TOP + TIP - table["z_m"][rows])  # the spring's law, by the height of the arm alone
        assert np.max(np.abs(own - 20)) <= 0.05 * 20
        assert one["largest_error"] <= 0.05
        assert (one["least_N"], one["most_N"]) == pytest.approx((own.min(), own.max()), rel=0.02)
    assert run(["verify", str(tmp_path / "out"), "-q"]) == 0


@pytest.mark.long
def test_a_cylinder_is_pressed_as_asked(tmp_path: Path) -> None:
    task = f"{HEAD}{PIPE}{arc()}".replace("0.12", "0.05")
    table, section = ran(tmp_path, task, "--engine", "spring")
    (one,) = moving(section)
    rows = (table["t_s"] >= one["start_s"]) & (table["t_s"] <= one["end_s"])
    own = GIVE * (RADIUS + TIP - np.hypot(table["y_m"][rows], table["z_m"][rows] - AXIS))
    assert np.max(np.abs(own - 20)) <= 0.05 * 20
    assert one["largest_error"] <= 0.05


@pytest.mark.long
def test_mujoco_presses_as_hard(tmp_path: Path) -> None:
    pytest.importorskip("mujoco")
    task = f"{HEAD}{PIPE}{arc()}".replace("0.12", "0.05")
    _, section = ran(tmp_path, task, "--engine", "mujoco")
    (one,) = moving(section)
    assert one["mean_N"] == pytest.approx(20.0, rel=0.05)


def test_the_equilibrium_is_moved_by_force_over_stiffness(tmp_path: Path) -> None:
    (tmp_path / "task.yaml").write_text(f"{HEAD}{LANES}{PLATE}")
    assert run(["iiwa", "segments", str(tmp_path / "task.yaml"), "--output", str(tmp_path / "out"), "-q"]) == 0
    fed, plan = (
        np.genfromtxt(tmp_path / "out" / name, delimiter=",", skip_header=1) for name in ("equilibrium.csv", "plan.csv")
    )
    off = (fed - plan)[:, 1:4]
    (pressed, *_) = np.flatnonzero((plan[:, 1] > 0.5) & (np.abs(plan[:, 3] - 0.18) < 1e-9))  # on lane 1
    u = np.array([-np.sin(np.radians(6)), 0, -np.cos(np.radians(6))])  # the tool, tilted about y
    K = np.array([1500, 1500, K_Z])
    np.testing.assert_allclose(off[pressed], 20 * u / K + 20 * u / GIVE, atol=1e-12)
    np.testing.assert_allclose(off[[0, -1]], 0.0, atol=1e-12)
    assert np.linalg.norm(np.diff(off, axis=0), axis=1).max() < 1e-3


@pytest.mark.parametrize(
    ("task", "line"),
    [
        (HEAD + LANES.replace("at: start}", "at: start, force: 5}"), 15),
        (HEAD + LANES + "force: {along: up}\n", 20),
        (HEAD + LANES.replace("0.5, force: 20 N", "0.5, force: -3"), 16),
        (HEAD + LANES + PLATE.replace("plate: {", ROUND), 23),
        (HEAD + LANES + "pushes: nowhere.csv\n", 20),
        (HEAD + LANES.replace(", force: 20 N", "") + "force: {along: z}\n", 20),
    ],
)
def test_what_is_wrong_is_told_by_line(task: str, line: int) -> None:
    with pytest.raises(InputError) as found:
        parse_task(task, "t.yaml")
    assert f"t.yaml:{line}" in str(found.value)


@pytest.mark.parametrize(
    "task",
    [
        HEAD + LANES.replace("0], force: 20 N}", "0], force: 10 N}", 1) + "passing: {tolerance: 0.1 mm}\n",
        HEAD.replace("1500, 800", "1500, 0") + LANES,
        HEAD + LANES + "force: {along: normal}\n" + "changes: [{at: 1, K: [500, 500, 500, 60, 60, 60]}]\n",
        HEAD + LANES.replace("[0, 0.04, 0,", "[0, 0, -0.04,") + "force: {along: normal}\n",
        HEAD.replace("s-curve", "trapezoid") + LANES + "force: {lead: true}\n",
        HEAD + LANES.replace("dwell: 0.5, force: 20 N", "dwell: 0.005, force: 20 N"),
    ],
    ids=["passed", "no stiffness", "another stiffness", "no normal", "jumps ahead", "a blow"],
)
def test_what_cannot_be_pressed_is_refused(tmp_path: Path, task: str, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "task.yaml").write_text(task)
    assert run(["iiwa", "segments", str(tmp_path / "task.yaml"), "--output", str(tmp_path / "out")]) == 2
    assert "force" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


@pytest.mark.long
def test_a_recorded_force_is_replayed(tmp_path: Path) -> None:
    """A log that is constant for a while does what the same push does; its units and columns may be in any order."""
    still = "poses: [start, {by: [0, 0, 0, 0, 0, 0], dwell: 0.6}]\n"
    listed, _ = ran(tmp_path, HEAD + still + "pushes: [{from: 0.1, to: 0.3, force: [4, -2, 6, 0.1, 0, 0]}]\n")
    log = "t [ms];Fy;Fx [N];Fz;Mx [Nm];My;Mz\n" + "".join(f"{t};-2;4;6;0.1;0;0\n" for t in range(100, 300))
    (tmp_path / "log.csv").write_text(log)
    replayed, _ = ran(tmp_path, HEAD + still + "pushes: log.csv\n", "--plots", str(tmp_path / "plots"))
    assert (tmp_path / "plots/pushed.svg").is_file()
    assert np.abs(listed["x_m"] - listed["x_m"][0]).max() > 1e-3
    for name in ("x_m", "y_m", "z_m", "alpha_rad"):
        np.testing.assert_allclose(replayed[name], listed[name], atol=1e-9)


def test_a_guided_run_becomes_a_path(tmp_path: Path) -> None:
    """Thinned poses come within the tolerance of every row of the run, and are fewer."""
    still = "poses: [start, {by: [0, 0, 0, 0, 0, 0], dwell: 1.0}]\n"
    t = np.arange(0, 1, 0.01)
    force = np.column_stack([8 * np.sin(9 * t), 5 * np.cos(7 * t) - 5, 3 * t, 0.2 * t, 0 * t, 0 * t])
    rows = "\n".join(",".join(f"{value:.9g}" for value in row) for row in np.column_stack([t, force]))
    (tmp_path / "log.csv").write_text("t,Fx,Fy,Fz,Mx,My,Mz\n" + rows + "\n")
    led, _ = ran(tmp_path, HEAD + still + "pushes: log.csv\n")
    (tmp_path / "simulation.csv").write_bytes((tmp_path / "out/simulation.csv").read_bytes())
    (tmp_path / "again").mkdir()
    (tmp_path / "again/simulation.csv").write_bytes((tmp_path / "out/simulation.csv").read_bytes())
    task = parse_task(HEAD + "poses: simulation.csv\npassing: {tolerance: 0.2 mm}\n", str(tmp_path / "again/task.yaml"))
    chain = task.route.poses
    assert 5 < len(chain) < len(led["x_m"]) / 10
    points = np.column_stack([led["x_m"], led["y_m"], led["z_m"]])
    a, way = chain[:-1, :3], np.diff(chain[:, :3], axis=0)
    share = np.clip(np.einsum("nij,ij->ni", points[:, None] - a, way) / np.sum(way * way, axis=1), 0, 1)
    far = np.linalg.norm(points[:, None] - a - share[..., None] * way, axis=2).min(axis=1)
    assert far.max() <= 2e-4
    (tmp_path / "again/task.yaml").write_text(HEAD + "poses: simulation.csv\n")
    assert run(["iiwa", "segments", str(tmp_path / "again/task.yaml"), "--output", str(tmp_path / "path"), "-q"]) == 0
    assert run(["verify", str(tmp_path / "path"), "-q"]) == 0


@pytest.mark.long
def test_the_edge_that_ships_is_pressed_and_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The walk of the manual: each omission is told, and what mends it brings the force within 5 %."""
    programs = Path(__file__).parents[2] / "programs"
    text = (programs / "iiwa_edge.yaml").read_text()
    (tmp_path / "iiwa_edge.csv").write_bytes((programs / "iiwa_edge.csv").read_bytes())
    _, section = ran(tmp_path, text.replace(", settle: 0.5 s, lead: true", ""), "--engine", "spring")
    assert moving(section)[0]["most_N"] > 30
    assert run(["iiwa", "segments", str(tmp_path / "task.yaml"), "--output", str(tmp_path / "told")]) == 0
    assert "settle" in capsys.readouterr().out
    _, section = ran(tmp_path, text.split("# What the pad")[0])
    assert section.get("forces") is None
    _, section = ran(tmp_path, text, "--engine", "spring")
    assert moving(section)[0]["largest_error"] <= 0.05
    assert run(["verify", str(tmp_path / "out"), "-q"]) == 0
    assert run(["export", "poses", str(tmp_path / "out"), "--for", "lbr", "-q"]) == 0


@pytest.mark.parametrize("along", ["tool", "normal", "-z"])
def test_the_judge_sees_an_equilibrium_that_presses_otherwise(
    tmp_path: Path, along: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """Fed the plan, the tool would press with nothing; fed 2 mm deeper with 1.6 N more."""
    lanes = LANES.replace("[0, 0.04, 0,", "[0.04, 0, 0,")  # across the tilt the normal would change at once
    (tmp_path / "task.yaml").write_text(f"{HEAD}{lanes}{PLATE}force: {{along: {along}, lead: true}}\n")
    out = tmp_path / "out"
    assert run(["iiwa", "segments", str(tmp_path / "task.yaml"), "--output", str(out), "-q"]) == 0
    assert run(["verify", str(out), "-q"]) == 0
    names = ("equilibrium.csv", "equilibrium_quaternion.csv")
    kept = {name: (out / name).read_text() for name in names}
    for name in names:
        head, *rows = kept[name].splitlines()
        cells = [row.split(",") for row in rows]
        deeper = [",".join([*row[:3], repr(float(row[3]) - 2e-3), *row[4:]]) for row in cells]
        (out / name).write_text("\n".join([head, *deeper]) + "\n")
    capsys.readouterr()
    assert run(["verify", str(out)]) == 1
    assert "wished force" in capsys.readouterr().out
    for name in names:
        (out / name).write_text((out / name.replace("equilibrium", "plan")).read_text())
    assert run(["verify", str(out)]) == 1
    assert "wished force" in capsys.readouterr().out
