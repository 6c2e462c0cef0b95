"""Dosing where the controller does not stay as it is: on surfaces the push is kept, changes at poses move along."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.cli import run

HEAD = """\
start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
profile: trapezoid
v_max: 0.1
omega_max: 1
a_max: 1
epsilon_max: 5
K: [1000, 1000, 800, 30, 30, 30]
D: [300, 300, 400, 20, 20, 20]
M: [25, 25, 25, 3, 3, 3]
"""
PRESS = """\
tool: {position: [0, 0, 0.1]}
poses:
  - {name: start, at: start}
  - {name: on it, by: [0, 0, -0.03, 0, 0, 0], dwell: DWELL}
  - {name: along, by: [0.06, 0, 0, 0, 0, 0]}
  - {name: off, by: [0, 0, 0.03, 0, 0, 0]}
contact:
  tip: 0.02
  obstacles:
    plate: {box: {size: [0.3, 0.3, 0.02], position: [0.5, 0, Z]}, stiffness: 20 N/mm, damping: 40, friction: 0.2}
"""


def made(tmp_path: Path, text: str) -> Path:
    (tmp_path / "task.yaml").write_text(HEAD + text)
    assert run(["iiwa", "segments", str(tmp_path / "task.yaml"), "--output", str(tmp_path / "out")]) == 0
    return tmp_path / "out"


def section(folder: Path, name: str) -> dict[str, object]:
    found = json.loads((folder / "summary.json").read_text())[name]
    assert isinstance(found, dict)
    return found


def columns(path: Path, *names: str) -> np.ndarray:
    head, *rows = path.read_text().splitlines()
    heads, table = head.split(","), np.loadtxt(rows, delimiter=",")
    return table[:, [heads.index(name) for name in names]]


def touching(tmp_path: Path, text: str) -> Path:
    """PRESS or its like, the plate 20 mm under the tip of the tool at the start."""
    free = made(tmp_path, text.replace("Z", "-1"))
    z = columns(free / "equilibrium.csv", "z [m]")[0, 0]
    return made(tmp_path, text.replace("Z", f"{z - 0.02 - 0.02 - 0.01:.6f}"))


@pytest.mark.long
@pytest.mark.parametrize("engine", ["spring", "mujoco"])
def test_the_push_is_kept_where_the_tool_touches(tmp_path: Path, engine: str) -> None:
    if engine == "mujoco":
        pytest.importorskip("mujoco")
    folder, forces = touching(tmp_path, PRESS.replace("DWELL", "1 s")), []
    dosed = tmp_path / "dosed"
    assert run(["iiwa", "dose", str(folder), "--max-lag", "2mm", "--max-lead", "60N", "--output", str(dosed)]) == 0
    for one in (folder, dosed):
        assert run(["iiwa", "simulate", str(one), "--engine", engine]) == 0
        force = columns(one / "simulation.csv", "true fz [N]")[:, 0]
        name = "plan.csv" if one is dosed else "equilibrium.csv"
        x = columns(one / name, "x [m]")[:, 0]
        moving = np.flatnonzero(np.diff(x) > 0)
        forces.append((force.max(), force[moving].mean()))
    (most, mean), (most_after, mean_after) = forces
    assert most_after <= 1.2 * most
    assert mean_after == pytest.approx(mean, rel=0.2)
    # 10 mm of 800 N/m, the plate's own 20 N/mm in series
    assert mean_after == pytest.approx(0.01 / (1 / 800 + 1 / 20000), rel=0.02)
    told = section(dosed, "dosing")["contact"]
    assert told["largest_N"] <= 1.2 * told["programmed_N"]
    if engine == "spring":
        assert (told["programmed_N"], told["largest_N"]) == pytest.approx((most, most_after), rel=1e-6)


def test_a_push_that_cannot_be_kept_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    # down and up at once: as programmed the arm, which lags, never gets there
    folder = touching(
        tmp_path, "".join(line for line in PRESS.replace("DWELL", "0").splitlines(True) if "along" not in line)
    )
    assert run(["iiwa", "dose", str(folder), "--max-lag", "2mm", "--max-lead", "60N"]) == 1
    assert "programmed are" in capsys.readouterr().err
    assert not (tmp_path / "out-dosed").exists()


CORNERS = """\
poses:
  - {name: start, at: start}
  - {name: a, by: [0.1, 0, 0, 0, 0, 0]}
  - {name: b, by: [0, 0.1, 0, 0, 0, 0]}
  - {name: c, by: [-0.1, 0, 0, 0, 0, 0]}
changes:
  - {at: FIRST, K: [300, 300, 300, 30, 30, 30], D: [200, 200, 200, 20, 20, 20]}
  - {at: SECOND, K: [2000, 2000, 2000, 30, 30, 30]}
"""


def test_a_change_at_a_pose_moves_with_the_path(tmp_path: Path) -> None:
    folder, dosed = made(tmp_path, CORNERS.replace("FIRST", "b").replace("SECOND", "a")), tmp_path / "dosed"
    assert run(["iiwa", "dose", str(folder), "--max-lag", "2mm", "--max-lead", "50N", "--output", str(dosed)]) == 0
    place = ("x [m]", "y [m]", "z [m]")
    u, plan = (columns(dosed / f"{name}.csv", *place) for name in ("equilibrium", "plan"))
    poses = {one["to"]: one["last"] for one in section(dosed, "sequence")["pieces"]}
    h, x, v, lags, most = 1e-3, plan[0].copy(), np.zeros(3), [], []
    K, D = np.array([1000.0, 1000, 800]), np.array([300.0, 300, 400])
    for k, (goal, where) in enumerate(zip(u, plan, strict=True)):
        if k == poses["a"]:
            K = np.full(3, 2000.0)
        if k == poses["b"]:
            K, D = np.full(3, 300.0), np.full(3, 200.0)
        lags.append(np.linalg.norm(x - where))
        most.append(np.linalg.norm(K * (goal - x)))
        x, v = x + h * v, v + h / 25 * (K * (goal - x) - D * v)
    assert max(lags) <= 2e-3
    assert 45 < max(most) <= 50 * (1 + 1e-6)


@pytest.mark.parametrize(("first", "second", "code"), [("0.8 s", "0.4 s", 1), ("b", "0.4 s", 2), ("nowhere", "a", 2)])
def test_changes_that_do_not_move_with_the_path(tmp_path: Path, first: str, second: str, code: int) -> None:
    text = CORNERS.replace("FIRST", first).replace("SECOND", second)
    if code == 2:
        (tmp_path / "task.yaml").write_text(HEAD + text)
        assert run(["iiwa", "segments", str(tmp_path / "task.yaml"), "--output", str(tmp_path / "out")]) == 2
        return
    assert run(["iiwa", "dose", str(made(tmp_path, text)), "--max-lag", "2mm"]) == 1


def test_what_a_schedule_does_not_regard_is_told_in_one_line_too(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    pushes = "pushes: [{from: 0.1, to: 0.3, force: [5, 0, 0, 0, 0, 0]}]\n"
    folder = made(tmp_path, CORNERS[: CORNERS.index("changes:")] + pushes)
    capsys.readouterr()
    assert run(["iiwa", "dose", str(folder), "--max-lag", "2mm", "--max-lead", "50N", "-q"]) == 0
    (line,) = capsys.readouterr().out.splitlines()
    assert "pushes" in line
