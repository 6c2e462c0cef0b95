"""The impedance controller on MuJoCo's arm, beside another simulation: Pinocchio's dynamics, the law written anew."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
from scipy.linalg import sqrtm

import trajopt_cli
from trajopt_cli.cli import run
from trajopt_cli.errors import InputError
from trajopt_cli.iiwa.task.loader import parse_task

ROBOTS = Path(trajopt_cli.__file__).parents[1] / "robots"
START = np.radians([0, 30, 0, -100, 0, 50, 0])
TASK = """\
start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
tool: {load: {mass: 1.0, com: [0, 0, 0.05], inertia: [0.004, 0.004, 0.003]}}
profile: trapezoid
rotation: slerp
poses:
  - {at: start}
  - {by: BY}
v_max: 0.25
omega_max: 1.0
a_max: 2
epsilon_max: 6
controller: impedance
K: STIFFNESS
"""


def drawn(seed: int) -> tuple[str, list[float], list[float] | None, list[float] | None]:
    """A task, its K, and either D or damping ratios."""
    rng = np.random.default_rng(seed)
    by = [*rng.uniform(-0.06, 0.06, 3), *rng.uniform(-0.15, 0.15, 3)]
    K = [*rng.uniform(500, 3000, 3), *rng.uniform(50, 200, 3)]
    D, ratios = None, None
    text = TASK.replace("BY", str([float(one) for one in by])).replace("STIFFNESS", str([float(one) for one in K]))
    if seed % 2:
        D = [*rng.uniform(60, 200, 3), *rng.uniform(0.3, 1.0, 3)]
        text += f"D: {[float(one) for one in D]}\n"
    else:
        ratios = rng.uniform(0.4, 1.0, 6).tolist()
        text += f"impedance: {{damping_ratio: {ratios}}}\n"
    return text, K, D, ratios


def own_lag(rows: np.ndarray, K: list[float], D: list[float] | None, ratios: list[float] | None, held: int) -> float:
    """The largest distance [m] of the flange from rows (t, x, y, z, qw, qx, qy, qz): the arm as a free body of links,
    its torques from J^T (K dx - D v), held for 1 ms each."""
    model = pin.buildModelFromUrdf(str(ROBOTS / "iiwa7.urdf"))
    frame = model.getFrameId("tool0")
    load = pin.Inertia(1.0, np.array([0, 0, 0.05]), np.diag([0.004, 0.004, 0.003]))
    model.appendBodyToJoint(model.frames[frame].parentJoint, load, model.frames[frame].placement)
    data = model.createData()
    q, v, far, dt = START.copy(), np.zeros(7), 0.0, 2.5e-4
    goals = [pin.SE3(pin.Quaternion(row[4], *row[5:8]).matrix(), row[1:4]) for row in rows]
    for goal in [*goals, *[goals[-1]] * held]:
        pin.forwardKinematics(model, data, q)
        J = pin.computeFrameJacobian(model, data, q, frame, pin.ReferenceFrame.LOCAL_WORLD_ALIGNED)
        here = pin.updateFramePlacement(model, data, frame)
        far = max(far, float(np.linalg.norm(goal.translation - here.translation)))
        e = np.r_[goal.translation - here.translation, pin.log3(goal.rotation @ here.rotation.T)]
        M = pin.crba(model, data, q)
        M = np.triu(M) + np.triu(M, 1).T
        L = np.linalg.inv(J @ np.linalg.inv(M) @ J.T)
        damping = np.diag(D) if D is not None else None
        if damping is None:
            A, K1, Z = np.real(sqrtm(L)), np.diag(np.sqrt(K)), np.diag(ratios)
            damping = A @ Z @ K1 + K1 @ Z @ A
        posture = 10 * (START - q) - 2 * 0.7 * np.sqrt(10 * np.diag(M)) * v
        N = np.eye(7) - J.T @ L @ J @ np.linalg.inv(M)
        tau = J.T @ (np.array(K) * e - damping @ J @ v) + N @ posture + pin.nle(model, data, q, v)
        for _ in range(4):
            v = v + dt * pin.aba(model, data, q, v, tau)
            q = q + dt * v
    return far


@pytest.mark.parametrize("seed", range(10))
def test_the_lag_is_that_of_another_simulation(tmp_path: Path, seed: int) -> None:
    pytest.importorskip("mujoco")
    text, K, D, ratios = drawn(seed)
    (tmp_path / "task.yaml").write_text(text)
    assert run(["iiwa", "segments", str(tmp_path / "task.yaml"), "--output", str(tmp_path / "out"), "-q"]) == 0
    assert run(["iiwa", "simulate", str(tmp_path / "out"), "--settle", "0.1", "-q"]) == 0
    section = json.loads((tmp_path / "out/summary.json").read_text())["simulation"]
    rows = np.genfromtxt(tmp_path / "out/equilibrium_quaternion.csv", delimiter=",", skip_header=1)
    own = own_lag(rows, K, D, ratios, 100)
    assert own > 1e-3
    assert section["lag"]["largest_m"] == pytest.approx(own, rel=0.05)


@pytest.mark.long
def test_a_push_is_answered_by_the_stiffness(tmp_path: Path) -> None:
    """10 N for long move the tool by F/K, and nothing else does."""
    pytest.importorskip("mujoco")
    task = TASK.replace("BY", "[0, 0, 0, 0, 0, 0], dwell: 0.01").replace(
        "STIFFNESS", "[800, 1000, 2000, 200, 200, 200]"
    )
    task += "impedance: {damping_ratio: 1}\npushes: [{from: 0, to: 9, force: [8, -10, 20, 0, 0, 0]}]\n"
    (tmp_path / "task.yaml").write_text(task)
    assert run(["iiwa", "segments", str(tmp_path / "task.yaml"), "--output", str(tmp_path / "out"), "-q"]) == 0
    assert run(["iiwa", "simulate", str(tmp_path / "out"), "--settle", "2", "-q"]) == 0
    table = np.genfromtxt(tmp_path / "out/simulation.csv", delimiter=",", names=True)
    moved = [float(table[f"{a}_m"][-1] - table[f"{a}_m"][0]) for a in "xyz"]
    np.testing.assert_allclose(moved, [0.01, -0.01, 0.01], atol=1e-4)


@pytest.mark.parametrize(
    ("more", "line"),
    [
        ("", 12),
        ("impedance: {damping_ratio: 3}\n", 14),
        ("D: [1, 1, 1, 1, 1, 1]\nzero: {components: [fx]}\n", 15),
        ("D: [1, 1, 1, 1, 1, 1]\nimpedance: {damping_ratio: 0.7}\n", 14),
    ],
)
def test_what_it_cannot_take_is_told_by_line(more: str, line: int) -> None:
    text = TASK.replace("BY", "[0, 0, 0.1, 0, 0, 0]").replace("STIFFNESS", "[800, 800, 800, 50, 50, 50]")
    with pytest.raises(InputError) as found:
        parse_task(text + more, "t.yaml")
    assert f"t.yaml:{line}" in str(found.value)


def test_a_damping_that_one_period_cannot_hold_is_refused(tmp_path: Path) -> None:
    pytest.importorskip("mujoco")
    text = TASK.replace("BY", "[0, 0, 0.1, 0, 0, 0]").replace("STIFFNESS", "[800, 800, 800, 50, 50, 50]")
    (tmp_path / "task.yaml").write_text(text + "D: [100, 100, 100, 12, 12, 12]\n")
    assert run(["iiwa", "segments", str(tmp_path / "task.yaml"), "--output", str(tmp_path / "out"), "-q"]) == 0
    assert run(["iiwa", "simulate", str(tmp_path / "out")]) == 1
    assert not (tmp_path / "out/simulation.csv").exists()


def test_it_needs_an_arm_with_masses(tmp_path: Path) -> None:
    (tmp_path / "task.yaml").write_text(drawn(1)[0])
    assert run(["iiwa", "segments", str(tmp_path / "task.yaml"), "--output", str(tmp_path / "out"), "-q"]) == 0
    assert run(["iiwa", "simulate", str(tmp_path / "out"), "--engine", "spring"]) == 2
