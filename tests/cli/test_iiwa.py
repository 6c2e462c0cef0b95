"""`trajopt iiwa`: from a task file to folders, the answers it prints, and what it refuses."""

from __future__ import annotations

import json
import re
from io import BytesIO
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.figure import Figure
from scipy.spatial.transform import Rotation

from trajopt_cli.cli import run
from trajopt_cli.joint_csv import read_csv_text
from trajopt_cli.robot.srs import load_srs

TASK = """\
start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
profile: trapezoid
poses:
  - {name: start, at: start}
  - {name: side, by: [0, 0.1, 0, 0, 0, 20 deg]}
  - {name: up, by: [0.02, 0, 0.05, 0, 0, 0], dwell: 0.1 s}
v_max: 0.2
omega_max: 1
a_max: 1
epsilon_max: 5
K: [1000, 1000, 1000, 30, 30, 30]
D: [500, 500, 500, 20, 20, 20]
M: [25, 25, 25, 3, 3, 3]
h: 4 ms
"""
H = 4e-3  # s
WALL = """\
contact:
  tip: 0.02
  obstacles:
    wall: {box: {size: [0.4, 0.2, 0.3], position: [0.6, 0.18, 0.25]}, stiffness: 10 N/mm, damping: 50, friction: 0.2}
"""


@pytest.fixture
def task(tmp_path: Path) -> Path:
    path = tmp_path / "small.yaml"
    path.write_text(TASK)
    return path


@pytest.fixture
def only_png(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pictures' SVG files stay empty: they come from the same figures."""
    save = Figure.savefig

    def saved(figure: Figure, file: BytesIO, **how: Any) -> None:
        if how["format"] == "png":
            save(figure, file, **how)

    monkeypatch.setattr(Figure, "savefig", saved)


def segments(task: Path, *options: str) -> Path:
    folder = task.parent / "out"
    assert run(["iiwa", "segments", str(task), "--output", str(folder), *options]) == 0
    return folder


def table(path: Path) -> tuple[list[str], np.ndarray]:
    with path.open() as file:
        return next(file).rstrip().split(","), np.loadtxt(file, delimiter=",", ndmin=2)


def contents(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


def test_segments_give_both_sequences_and_end_at_the_pose(task: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = segments(task)
    shown = capsys.readouterr().out
    assert "start   side" in shown
    assert "angles count from the orientation at the start" in shown
    heads, rows = table(folder / "equilibrium.csv")
    assert heads == ["t [s]", "x [m]", "y [m]", "z [m]", "alpha [rad]", "beta [rad]", "gamma [rad]"]
    assert np.all(np.linalg.norm(np.diff(rows[:, 1:4], axis=0), axis=1) <= 0.2 * H * (1 + 1e-9))
    np.testing.assert_allclose(rows[-1, 1:4] - rows[0, 1:4], [0.02, 0.1, 0.05], rtol=0, atol=1e-15)
    assert rows[-1, 6] == np.radians(20)
    np.testing.assert_array_equal(rows[-25:, 1:], np.tile(rows[-1, 1:], (25, 1)))  # the dwell
    heads, quaternions = table(folder / "equilibrium_quaternion.csv")
    assert heads == ["t [s]", "x [m]", "y [m]", "z [m]", "qw [1]", "qx [1]", "qy [1]", "qz [1]"]
    # half a turn about y, then 20 deg about the world's z: the vector part's direction turns by half of that
    np.testing.assert_allclose(
        np.abs(quaternions[-1, 4:]), [0, np.sin(np.radians(10)), np.cos(np.radians(10)), 0], atol=1e-12
    )


def test_absolute_angles_name_the_same_orientations(task: Path) -> None:
    folder = segments(task, "--angles", "absolute")
    absolute = contents(folder)
    summary = json.loads(absolute["summary.json"])
    assert summary["sequence"]["angles"] == "absolute"
    relative = contents(segments(task))
    assert absolute["equilibrium.csv"] != relative["equilibrium.csv"]
    first, second = (
        np.array([row.split(",") for row in one["equilibrium_quaternion.csv"].decode().splitlines()[1:]], dtype=float)
        for one in (absolute, relative)
    )
    np.testing.assert_allclose(first, second, rtol=0, atol=1e-14)


def test_joints_put_the_tool_on_every_pose(task: Path) -> None:
    folder = segments(task)
    assert run(["iiwa", "joints", str(folder)]) == 0
    joints, _ = read_csv_text((folder / "joints.csv").read_text(), "joints.csv")
    assert joints.names == tuple(f"joint_{i}" for i in range(1, 8))
    _, rows = table(folder / "equilibrium.csv")
    np.testing.assert_allclose(joints.t, rows[:, 0], rtol=0, atol=1e-12)
    X = load_srs("iiwa7").forward(joints.q)
    np.testing.assert_allclose(X[:, :3, 3], rows[:, 1:4], rtol=0, atol=1e-12)
    np.testing.assert_allclose(joints.q[0], np.radians([0, 30, 0, -100, 0, 50, 0]), rtol=0, atol=1e-9)


@pytest.mark.long
@pytest.mark.usefixtures("only_png")
def test_an_arm_angle_is_chosen_told_and_drawn(
    task: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("trajopt_cli.cli.progress.log_pause", lambda spent: 0.0)
    folder, plots = segments(task), task.parent / "plots"
    capsys.readouterr()
    options = ["--arm-angle", "optimal", "--for", "speed"]
    assert run(["iiwa", "joints", str(folder), *options, "--plots", str(plots)]) == 0
    shown = capsys.readouterr()
    assert "arm angle chosen for speed" in shown.out
    assert "joints: best path on the map" in shown.err
    assert {path.name for path in plots.iterdir()} == {"arm_angle.png", "arm_angle.svg"}
    joints, _ = read_csv_text((folder / "joints.csv").read_text(), "joints.csv")
    _, rows = table(folder / "equilibrium.csv")
    X = load_srs("iiwa7").forward(joints.q)
    np.testing.assert_allclose(X[:, :3, 3], rows[:, 1:4], rtol=0, atol=1e-12)
    said = json.loads((folder / "summary.json").read_text())["joints"]["chosen"]
    assert said["for"] == "speed"
    assert said["kept_fixed"] is None
    limits = load_srs("iiwa7").profile()
    steady = np.sqrt(np.square(np.diff(joints.q, axis=0) / H / limits.velocity).sum(axis=1).mean())
    assert said["optimal"]["speed_share_rms"] == pytest.approx(steady, rel=1e-9)
    assert f"{100 * steady:.2f}" in shown.out
    assert said["optimal"]["speed_share_rms"] < said["fixed"]["speed_share_rms"]
    before = (folder / "joints.csv").read_bytes(), (plots / "arm_angle.png").read_bytes()
    assert run(["iiwa", "joints", str(folder), *options, "--plots", str(plots)]) == 0
    assert before == ((folder / "joints.csv").read_bytes(), (plots / "arm_angle.png").read_bytes())
    assert run(["iiwa", "joints", str(folder)]) == 0
    assert "chosen" not in json.loads((folder / "summary.json").read_text())["joints"]


def test_long_sequences_tell_what_is_worked_on(
    task: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = segments(task)
    capsys.readouterr()
    assert run(["iiwa", "joints", str(folder)]) == 0
    assert capsys.readouterr().err == ""
    rows = len(table(folder / "equilibrium.csv")[1])
    monkeypatch.setattr("trajopt_cli.iiwa.job.joints.LONG", rows)
    monkeypatch.setattr("trajopt_cli.cli.progress.log_pause", lambda spent: 0.0)
    assert run(["iiwa", "joints", str(folder)]) == 0
    assert [line.split(" s: ")[1] for line in capsys.readouterr().err.splitlines()] == [
        f"joints: inverse kinematics and checks of {rows} poses",
        "joints: writing joints.csv",
    ]


def test_what_an_arm_angle_is_best_for_needs_one_that_is_chosen(task: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = segments(task)
    before = contents(folder)
    assert run(["iiwa", "joints", str(folder), "--arm-angle", "free", "--for", "speed"]) == 2
    assert (
        "--for speed: says what --arm-angle optimal is best for; the arm angle is free here" in capsys.readouterr().err
    )
    assert contents(folder) == before


def test_a_run_lags_as_the_law_says_and_is_fed_from_the_files(task: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = segments(task)
    assert run(["iiwa", "simulate", str(folder)]) == 0
    shown = capsys.readouterr().out
    heads, rows = table(folder / "simulation.csv")
    x_e, x = rows[:, 1:7], rows[:, 7:13]
    # the law itself, one period at a time
    K, D, M = np.array([1000.0] * 3 + [30.0] * 3), np.array([500.0] * 3 + [20.0] * 3), np.array([25.0] * 3 + [3.0] * 3)
    state, rate = x_e[0].copy(), np.zeros(6)
    for k in range(len(x)):
        np.testing.assert_allclose(x[k], state, rtol=0, atol=1e-9)
        rate, state = rate - H / M * (D * rate + K * (state - x_e[k])), state + H * rate
    deviation = rows[:, heads.index("deviation [m]")]
    assert f"lag at most {deviation.max() * 1e3:.2f} mm" in shown
    assert f"force if blocked: up to {1000 * deviation.max():.1f} N" in shown
    assert run(["iiwa", "simulate", str(folder), "--feed", "velocity"]) == 0
    _, fed = table(folder / "simulation.csv")
    assert fed[:, heads.index("deviation [m]")].max() < deviation.max() / 3


def test_a_spring_wall_holds_the_tool_back(task: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = segments(task)
    wall = task.parent / "wall.yaml"
    wall.write_text(WALL)
    assert run(["iiwa", "simulate", str(folder), "--contact", str(wall), "--engine", "spring", "--json"]) == 0
    printed = capsys.readouterr().out
    summary = json.loads(printed[printed.index("{") :])
    heads, rows = table(folder / "simulation.csv")
    # the tip's ball may go on to y = 0.06 m; the wall and the controller's spring share what the equilibrium goes on
    y_end, force = rows[-1, heads.index("y [m]")], -rows[-1, heads.index("true fy [N]")]
    into = 0.1 - 0.06
    assert force == pytest.approx(1 / (1 / 1000 + 1 / 10e3) * into, rel=0.02)
    assert y_end == pytest.approx(0.06 + force / 10e3, abs=2e-4)
    assert summary["contact"]["largest_force_N"] >= force
    assert summary["stopped"] is None


@pytest.mark.parametrize(
    ("engine", "installed", "said"), [([], False, True), ([], True, False), (["--engine", "spring"], False, False)]
)
def test_springs_in_place_of_mujoco_are_told(
    engine: list[str],
    installed: bool,
    said: bool,
    task: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr("trajopt_cli.iiwa.world.mujoco_world.available", lambda: installed)
    stiff = TASK.replace("500, 500, 500, 20, 20, 20", "1000, 1000, 1000, 40, 40, 40")  # so the end is soon reached
    stiff = stiff.replace("1000, 1000, 1000, 30, 30, 30", "9000, 9000, 9000, 120, 120, 120")
    task.write_text(stiff.replace("h: 4", "h: 8").replace("0.1, 0, 0, 0, 20 deg]", "0.01, 0, 0, 0, 0]"))
    folder = segments(task)
    (task.parent / "wall.yaml").write_text(WALL)
    assert run(["iiwa", "simulate", str(folder), "--contact", str(task.parent / "wall.yaml"), *engine]) == 0
    assert (" (MuJoCo is not installed), the whole loop because of contact" in capsys.readouterr().out) is said


def test_dosing_keeps_the_bound_and_leaves_the_source_alone(task: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = segments(task)
    before = contents(folder)
    assert run(["iiwa", "dose", str(folder), "--max-lag", "20mm"]) == 0
    assert contents(folder) == before
    dosed = task.parent / "out-dosed"
    shown = capsys.readouterr().out
    assert "lower bound" in shown
    assert "40 mm/s on a long line" in shown  # 20 mm times 1000 N/m over 500 N s/m
    assert run(["iiwa", "simulate", str(dosed)]) == 0
    heads, rows = table(dosed / "simulation.csv")
    assert rows[:, heads.index("deviation [m]")].max() <= 0.02 * (1 + 1e-9)
    assert 0.0199 < np.linalg.norm(rows[:, 1:4] - rows[:, 7:10], axis=1).max() <= 0.02 * (1 + 1e-6)  # nor pushes more
    end = rows[-1, 1:7]
    there = (np.linalg.norm(rows[:, 7:10] - end[:3], axis=1) <= 1e-3) & (
        np.linalg.norm(rows[:, 10:13] - end[3:], axis=1) <= np.radians(0.1)
    )
    dosing = json.loads((dosed / "summary.json").read_text())["dosing"]
    assert [way["feed"] for way in dosing["undosed"]] == ["as programmed"]
    assert list(dosing["feeds"]) == [dosing["feed"]] == ["inverse"]
    assert dosing["feeds"]["inverse"]["arrived_s"] == pytest.approx(rows[np.flatnonzero(~there)[-1] + 1, 0], abs=1e-9)
    assert dosing["undosed"][0]["lag"]["largest_m"] > 2 * dosing["feeds"]["inverse"]["lag"]["largest_m"]
    _, sequence = table(dosed / "equilibrium.csv")
    _, given = table(folder / "equilibrium.csv")
    np.testing.assert_array_equal(sequence[-1, 1:], given[-1, 1:])


def test_a_lead_is_kept_in_the_loop_as_it_is_told(task: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = segments(task)
    options = ["--max-lag", "3mm", "--max-lead", "20N"]
    assert run(["iiwa", "dose", str(folder), *options]) == 0
    dosed = task.parent / "out-dosed"
    shown = capsys.readouterr().out
    assert "lag of at most 3 mm, push of at most 20 N" in shown
    told = re.search(r"force if blocked: up to ([0-9.]+) N and ([0-9.]+) Nm", shown)
    assert told is not None
    # the whole loop on an arm that follows, fed as the folder says
    assert run(["iiwa", "simulate", str(dosed), "--engine", "spring"]) == 0
    simulated = capsys.readouterr().out
    assert f"force if blocked: up to {told[1]} N" in simulated  # the same number from both commands
    assert ", counted from plan.csv" in simulated
    heads, rows = table(dosed / "simulation.csv")
    assert rows[:, heads.index("deviation [m]")].max() <= 3e-3 * (1 + 1e-6)
    x_e, x = rows[:, 1:4], rows[:, 7:10]
    push = 1000 * (x_e - x)
    assert 19 < np.linalg.norm(push, axis=1).max() <= 20 * (1 + 1e-4)  # of differences of printed rows
    turned = 30 * (rows[:, 4:7] - rows[:, 10:13])
    assert float(told[2]) == pytest.approx(np.linalg.norm(turned, axis=1).max(), abs=0.006)
    assert (dosed / "plan.csv").is_file()
    assert run(["iiwa", "dose", str(dosed), "--max-lag", "3mm"]) == 2
    assert "is dosed already" in capsys.readouterr().err
    assert run(["iiwa", "joints", str(dosed)]) == 1  # its equilibrium jumps
    told_of_joints = capsys.readouterr().err
    assert "these are no joints of the arm" in told_of_joints
    assert "mm from plan.csv" in told_of_joints
    assert "a_max" not in told_of_joints


def test_feeds_by_their_old_names_are_fed_by_the_inverse_law_with_a_warning(
    task: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    task.write_text(TASK.replace("h: 4", "h: 8"))
    folder, dosed, lengths = segments(task), task.parent / "out-dosed", {}
    for feed in ("position", "velocity", "inverse"):
        assert run(["iiwa", "dose", str(folder), "--max-lag", "3mm", "--feed", feed, "--output", str(dosed)]) == 0
        assert capsys.readouterr().err.startswith(f"warning: --feed {feed}") == (feed != "inverse")
        lengths[feed] = len((dosed / "equilibrium.csv").read_text().splitlines())
    assert lengths["position"] > 2 * lengths["velocity"] == 2 * lengths["inverse"]  # which no spring's push bounds


@pytest.mark.parametrize("rotation", ["tait-bryan", "slerp\nangles: absolute"])
def test_joints_that_could_not_accelerate_so_slow_the_inverse_feed_down(
    rotation: str, task: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    task.write_text(
        TASK.replace("trapezoid", f"thesis\nrotation: {rotation}")
        .replace("M: [25, 25, 25,", "M: [5, 5, 5,")
        .replace("h: 4", "h: 2")
    )
    folder = segments(task)
    capsys.readouterr()
    options = ["--max-lag", "3mm", "--max-lead", "100N", "--max-turn-lead", "20Nm"]
    assert run(["iiwa", "dose", str(folder), *options, "--json"]) == 0
    printed = capsys.readouterr().out
    dosing = json.loads(printed[printed.index("{") :])
    assert dosing["feed"] == "inverse"
    assert any(note.startswith("slowed down for joint_") for note in dosing["notes"])
    worst = [one["value"] / one["limit"] for one in dosing["joints"]["findings"] if one["check"] == "acceleration"]
    assert 0.8 < max(worst) <= 1  # no slower than it has to be
    assert run(["iiwa", "simulate", f"{folder}-dosed"]) == 0


@pytest.mark.usefixtures("only_png")
def test_the_front_shows_what_other_leads_would_allow(task: Path, capsys: pytest.CaptureFixture[str]) -> None:
    task.write_text(TASK.replace("h: 4", "h: 8"))
    folder = segments(task)
    plots = task.parent / "plots"
    options = ["--max-lag", "3mm", "--max-lead", "15mm", "--front", "--plots", str(plots), "--json"]
    assert run(["iiwa", "dose", str(folder), *options]) == 0
    printed = capsys.readouterr().out
    dosing = json.loads(printed[printed.index("{") :])
    leads = [point["lead"]["most"] for point in dosing["front"]]
    assert leads == sorted(leads, reverse=True)
    assert 0.015 in leads
    times = [
        point["inverse_s"] for point in dosing["front"]
    ]  # what is allowed more never takes longer, but for a period
    assert all(longer >= shorter - 0.02 for shorter, longer in pairwise(times))
    assert (plots / "dosing.png").is_file()
    assert run(["iiwa", "dose", str(folder), "--max-lag", "3mm", "--front"]) == 2
    assert "--front: needs a bound on the lead; give --max-lead" in capsys.readouterr().err


def test_a_path_that_only_turns_has_a_front_of_one_lead(task: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = TASK.replace("[0, 0.1, 0, 0, 0, 20 deg]", "[0, 0, 0, 0, 0, 20 deg]").replace("[0.02, 0, 0.05,", "[0, 0, 0,")
    task.write_text(
        text.replace("0, 0, 0], dwell: 0.1 s", "9 deg, 0, 0]").replace("K: [1000, 1000, 1000", "K: [0, 0, 0")
    )
    folder = segments(task)
    capsys.readouterr()
    options = ["--max-lag", "3mm", "--max-turn-lag", "1deg", "--max-turn-lead", "9Nm"]
    assert run(["iiwa", "dose", str(folder), *options, "--max-lead", "5N", "--front", "--json"]) == 0
    printed = capsys.readouterr().out
    front = json.loads(printed[printed.index("{") :])["front"]
    assert [point["lead"]["most"] for point in front] == [5.0]
    assert run(["iiwa", "dose", str(folder), *options]) == 0
    shown = capsys.readouterr().out
    assert "lag of at most 3 mm and 1°, push of at most 9 Nm" in shown
    assert "mm/s" not in shown  # of a lag along axes that nothing pulls


def test_the_same_input_gives_the_same_bytes(task: Path) -> None:
    runs = []
    for _ in range(2):
        folder = segments(task)
        for command in ("joints", "simulate"):
            assert run(["iiwa", command, str(folder)]) == 0
        runs.append({name: content for name, content in contents(folder).items() if name != "run.json"})
    assert runs[0] == runs[1]


def test_a_slerp_turn_past_the_lock(task: Path) -> None:
    task.write_text(TASK.replace("[0, 0.1, 0, 0, 0, 20 deg]", "[0, 0, 0, 0, 88 deg, 0]").replace("50, 0]", "5, 0]"))
    with task.open("a") as more:
        more.write("rotation: slerp\n")
    folder = segments(task)
    assert run(["iiwa", "joints", str(folder)]) == 0
    assert run(["iiwa", "simulate", str(folder)]) == 0
    joints, _ = read_csv_text((folder / "joints.csv").read_text(), "joints.csv")
    R = load_srs("iiwa7").forward(joints.q)[:, :3, :3]
    turned = np.arccos(np.clip((np.trace(R[-1] @ R[0].T) - 1) / 2, -1, 1))
    assert np.degrees(turned) == pytest.approx(88, abs=1e-9)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("0, 20 deg]", "86 deg, 0]", "small.yaml:5: pose side: beta is 86°, at most 85°"),
        ("v_max: 0.2", "v_max: 0", "v_max is 0 m/s with 0.1 m to go"),
        ("\na_max: 1\n", "\n", "a_max [m/s2] is missing; profile trapezoid needs it"),
        ("M: [25,", "M: [-1,", "small.yaml:13: M: needs a number above zero, not -1"),
        ("by: [0, 0.1, 0, 0, 0, 20 deg]", "by: [0, 0, 0, 0, 0, 0]", "pose side repeats pose start: give it a dwell"),
        ("by: [0, 0.1,", "by: [0, .nan,", "needs a finite number, not nan"),
    ],
)
def test_mistakes_are_one_line_and_nothing_is_written(
    task: Path, old: str, new: str, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert old in TASK
    task.write_text(TASK.replace(old, new))
    assert run(["iiwa", "segments", str(task), "--output", str(task.parent / "out")]) == 2
    shown = capsys.readouterr()
    assert said in shown.err
    assert (shown.out, shown.err.count("\n")) == ("", 1)
    assert not (task.parent / "out").exists()


def test_a_pose_out_of_reach_is_a_no_that_names_it(task: Path, capsys: pytest.CaptureFixture[str]) -> None:
    task.write_text(TASK.replace("by: [0, 0.1,", "by: [0.5, 0.1,"))
    folder = segments(task)
    before = contents(folder)
    capsys.readouterr()
    assert run(["iiwa", "joints", str(folder)]) == 1
    shown = capsys.readouterr().err
    assert "start -> side" in shown
    assert "0.8 m" in shown
    assert contents(folder) == before


def test_an_unstable_law_is_a_no_that_names_the_axis(task: Path, capsys: pytest.CaptureFixture[str]) -> None:
    task.write_text(TASK.replace("D: [500,", "D: [0.5,"))
    folder = segments(task)
    capsys.readouterr()
    assert run(["iiwa", "simulate", str(folder)]) == 1
    assert "x is unstable: d = 0.5 N s/m must be above h k = 4 N s/m" in capsys.readouterr().err
    assert run(["iiwa", "simulate", str(folder), "--integration", "exact"]) == 0


def test_a_program_without_a_task_file_is_offered_one_that_works(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    program = tmp_path / "seam.mod"
    program.write_text(
        "MODULE seam\n"
        "  CONST robtarget a := [[500,0,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
        "  CONST robtarget b := [[500,150,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
        "  PROC main()\n    MoveJ a, v100, fine, tool0;\n    MoveL b, v100, fine, tool0;\n  ENDPROC\nENDMODULE\n"
    )
    out = tmp_path / "out"
    assert run(["iiwa", "segments", str(program), "--output", str(out)]) == 2
    place, *lines = capsys.readouterr().err.splitlines()
    assert place.startswith(f"{tmp_path / 'seam.yaml'}: ")
    (tmp_path / "seam.yaml").write_text("\n".join(lines) + "\n")
    assert run(["iiwa", "segments", str(program), "--output", str(out)]) == 0
    assert "bound by" in capsys.readouterr().out
    assert run(["iiwa", "simulate", str(out)]) == 0
    _, rows = table(out / "equilibrium.csv")
    np.testing.assert_allclose(rows[-1, 1:4], [0.5, 0.15, 0.3], rtol=1e-15)
    assert rows[-1, 0] == pytest.approx(1.574)  # 7.218 mm from the start at v100, in whole periods, then 150 mm


def test_folders_of_other_commands_are_told_apart(task: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = segments(task)
    capsys.readouterr()
    assert run(["export", "rapid", str(folder), "--diff"]) == 2
    assert "was made by trajopt iiwa segments; this needs a folder of optimize" in capsys.readouterr().err
    assert run(["iiwa", "joints", str(task.parent)]) == 2
    assert "is not a results folder of trajopt" in capsys.readouterr().err
    (folder / "equilibrium.csv").write_text("changed")
    assert run(["iiwa", "joints", str(folder)]) == 2
    assert "equilibrium.csv: was changed since the run; make the folder again" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("bound", "said"),
    [
        ("5", '"5" lacks a unit'),
        ("-5mm", "needs a number above zero"),
        ("5 s", "unit 's'"),
        ("nan mm", "needs a number"),
    ],
)
def test_a_bound_needs_a_unit_and_a_size(task: Path, bound: str, said: str, capsys: pytest.CaptureFixture[str]) -> None:
    folder = segments(task)
    capsys.readouterr()
    assert run(["iiwa", "dose", str(folder), f"--max-lag={bound}"]) == 2
    shown = capsys.readouterr().err
    assert shown.startswith("--max-lag: ")
    assert said in shown


def test_turn_lag_through_the_lock_is_that_of_the_orientations(task: Path, capsys: pytest.CaptureFixture[str]) -> None:
    # a quarter turn past beta = 90 deg: angle columns swing by half turns there, the tool does not
    task.write_text(TASK.replace("[0, 0.1, 0, 0, 0, 20 deg]", "[0, 0, 0, 0, 110 deg, 0]").replace("50, 0]", "5, 0]"))
    with task.open("a") as more:
        more.write("rotation: slerp\n")
    folder = segments(task)
    capsys.readouterr()
    run(["iiwa", "simulate", str(folder), "--json"])  # joint_6 passes its range; what the law does is told all the same
    summary = json.loads(capsys.readouterr().out)
    # the law of one axis that turns, a period at a time
    goal = np.r_[turn_law(), np.full(5000, np.radians(110))]
    x, v, worst = 0.0, 0.0, 0.0
    for e in goal:
        worst = max(worst, abs(x - e))
        v, x = v - H / 3 * (20 * v + 30 * (x - e)), x + H * v
    assert summary["lag"]["largest_turn_rad"] == pytest.approx(worst, rel=1e-3)
    heads, rows = table(folder / "simulation.csv")
    off = rows[:, heads.index("beta [rad]")] - rows[:, heads.index("beta_e [rad]")]
    assert np.abs(off).max() < worst * 1.01


def turn_law() -> np.ndarray:
    """110 deg at 1 rad/s with 5 rad/s2, at rest at both ends, every period."""
    way, top, ramp = np.radians(110), 1.0, 5.0
    t = np.arange(0, way / top + top / ramp, H)
    up, down = np.minimum(t, top / ramp), np.maximum(0, t - way / top)
    return ramp * up**2 / 2 + top * (t - up) - ramp * down**2 / 2


def test_a_change_that_does_not_settle_is_named(task: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with task.open("a") as more:
        more.write("changes: [{at: 0.2 s, D: [0.5, 500, 500, 20, 20, 20]}]\n")
    folder = segments(task)
    capsys.readouterr()
    assert run(["iiwa", "simulate", str(folder)]) == 1
    assert capsys.readouterr().err.startswith("with the change at 0.2 s x is unstable: ")


def test_dosing_refuses_what_would_be_lost_or_not_be_followed(
    task: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = segments(task)
    before = contents(folder)
    capsys.readouterr()
    for place, said in (
        (folder, "is RESULTS itself"),
        (folder / "inner", "lies in the results folder"),
        (task / "inner", "is a file"),
    ):
        assert run(["iiwa", "dose", str(folder), "--max-lag", "20mm", "--output", str(place)]) == 2
        assert said in capsys.readouterr().err
    for plots in (folder, folder / "plots"):
        assert run(["iiwa", "simulate", str(folder), "--plots", str(plots)]) == 2
        assert "--plots: lies in the results folder" in capsys.readouterr().err
    for plots in (f"{folder}-dosed", f"{folder}-dosed/plots"):
        assert run(["iiwa", "dose", str(folder), "--max-lag", "20mm", "--plots", plots]) == 2
        assert "is the folder of the results or lies in it" in capsys.readouterr().err
    assert run(["iiwa", "dose", str(folder), "--max-lag", "1e-9m"]) == 2
    assert capsys.readouterr().err == "--max-lag: 1e-09 m is not within 1e-06 and 10 m\n"
    assert run(["iiwa", "dose", str(folder), "--max-lag", "20mm", "--max-turn-lag", "4rad"]) == 2
    assert capsys.readouterr().err.startswith("--max-turn-lag: 4 rad is not within ")
    assert contents(folder) == before
    assert not Path(f"{folder}-dosed").exists()
    monkeypatch.chdir(folder)
    assert run(["iiwa", "dose", ".", "--max-lag", "20mm"]) == 0
    assert Path(f"{folder}-dosed").is_dir()


def test_a_path_the_arm_cannot_follow_is_not_dosed(task: Path, capsys: pytest.CaptureFixture[str]) -> None:
    task.write_text(TASK.replace("0, 0, 20 deg]", "0, 65 deg, 0]"))  # joint_6 ends at 115 deg and is carried further
    task.write_text(task.read_text().replace("by: [0.02, 0, 0.05, 0, 0, 0]", "by: [0, 0, 0.1, 0, 10 deg, 0]"))
    folder = segments(task)
    capsys.readouterr()
    assert run(["iiwa", "joints", str(folder)]) == 1
    assert "joint_6 position" in capsys.readouterr().err
    assert run(["iiwa", "dose", str(folder), "--max-lag", "20mm"]) == 1
    shown = capsys.readouterr().err
    assert "joint_6 position" in shown
    assert "NOTHING WRITTEN" in shown
    assert not Path(f"{folder}-dosed").exists()


def test_accelerations_that_break_are_one_line_and_the_file_stands(
    task: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    task.write_text(TASK.replace("profile: trapezoid", "profile: thesis"))
    folder = segments(task)
    capsys.readouterr()
    assert run(["iiwa", "joints", str(folder)]) == 1
    shown = capsys.readouterr()
    assert shown.err.count("\n") == 1
    assert shown.err.startswith("acceleration limits of joint_1, ")
    assert "profile trapezoid or s-curve" in shown.err
    assert (folder / "joints.csv").is_file()


def test_a_first_pose_off_the_start_is_told(task: Path, capsys: pytest.CaptureFixture[str]) -> None:
    segments(task)
    assert "note:" not in capsys.readouterr().out
    task.write_text(TASK.replace("{name: start, at: start}", "[0.52, 0, 0.3032951178, 0, 0, 0]"))
    segments(task)
    # the flange at the start stands at x = 0.5064177772 m
    out = capsys.readouterr().out
    assert "approach: a line from the tool at the start joints to pose 1, 13.58 mm and 0°, goes before the path" in out
    task.write_text(task.read_text() + "approach: none\n")
    segments(task)
    assert "the first pose is 13.58 mm and 0° from the tool at the start joints" in capsys.readouterr().out


def test_absolute_angles_are_counted_from_the_start_on_request(task: Path) -> None:
    # pointing down and tilted: half a turn about x (or y and z), written so that beta stays small
    task.write_text(
        TASK.replace("{name: start, at: start}", "[0.5, 0, 0.3, 180 deg, 0, 180 deg]")
        .replace("by: [0, 0.1, 0, 0, 0, 20 deg]", "by: [0, 0.1, 0, 10 deg, 15 deg, 20 deg]")
        .replace("poses:", "angles: absolute\nposes:")
    )
    given = contents(segments(task))
    counted = contents(segments(task, "--angles", "relative"))
    rows, quaternions = (
        np.array([row.split(",") for row in counted[name].decode().splitlines()[1:]], dtype=float)
        for name in ("equilibrium.csv", "equilibrium_quaternion.csv")
    )
    np.testing.assert_allclose(rows[0, 4:], 0, atol=1e-12)  # the start itself has these angles
    a, b, g = rows[-1, 4:]
    turned = Rotation.from_euler("xyz", [a, b, g]) * Rotation.from_euler("y", 180, degrees=True)
    stored = Rotation.from_quat(np.roll(quaternions[-1, 4:], -1))
    assert (turned * stored.inv()).magnitude() < 1e-9
    wanted = Rotation.from_euler("xyz", [190, 15, 200], degrees=True)
    assert (wanted * stored.inv()).magnitude() < 1e-9
    assert given["equilibrium.csv"] != counted["equilibrium.csv"]


def test_a_push_moves_the_tool_by_force_over_stiffness_while_it_lasts(task: Path) -> None:
    task.write_text(
        "".join(
            line + "\n" for line in TASK.splitlines() if "name: side" not in line and "name: up" not in line
        ).replace("{name: start, at: start}", "start\n  - {at: start, dwell: 12 s}")
        + "pushes: [{from: 1 s, to: 8 s, force: [0, 0, 20, 0, 0, 0]}]\n"
        + "zero: {components: [fx], frame: [0, 0, 0]}\n"
    )
    folder = segments(task)
    assert run(["iiwa", "simulate", str(folder)]) == 0
    heads, rows = table(folder / "simulation.csv")
    force, away = (
        rows[:, heads.index("believed fz [N]")],
        rows[:, heads.index("z [m]")] - rows[:, heads.index("z_e [m]")],
    )
    t = rows[:, 0]
    np.testing.assert_array_equal(force, np.where((t >= 1) & (t < 8), 20.0, 0.0))
    assert away[t < 1].max() == 0
    assert away[np.searchsorted(t, 7.995)] == pytest.approx(20 / 1000, rel=1e-4)
    # the last pose is held until the controller has come to rest: 8 * 0.443 s, up to the next tenth
    assert t[-1] == pytest.approx(12 + 3.6)


HEAD = "x [m],y [m],z [m],alpha [rad],beta [rad],gamma [rad]"
CAPS = "a_max: 1\nepsilon_max: 5\njerk: 20\nangular_jerk: 100\n"


def long_path(folder: Path, extra: str = "") -> Path:
    """300 poses on a quarter circle of 100 mm about the tool's height, with a task file beside."""
    turn = np.linspace(0, np.pi / 2, 300)
    rows = np.column_stack(
        [0.45 + 0.1 * np.cos(turn), 0.1 * np.sin(turn), 0 * turn + 0.3, 0.1 * turn, 0 * turn, turn / 5]
    )
    path = folder / "arc.csv"
    path.write_text("\n".join([HEAD, *(",".join(f"{value:.6f}" for value in row) for row in rows)]))
    kept = [line for line in TASK.splitlines() if not line.startswith(("  -", "poses", "profile", "a_max", "eps"))]
    (folder / "arc.yaml").write_text("\n".join([*kept, CAPS, extra]))
    return path


def test_a_csv_path_goes_all_the_way(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = long_path(tmp_path)
    out = segments(path)
    said = capsys.readouterr().out
    assert "298 poses are passed without a stop, at most " in said
    assert "approach: a line from the tool at the start joints to pose 1" in said
    facts = json.loads((out / "summary.json").read_text())["sequence"]["segments"]
    assert [(fact["from"], fact["to"]) for fact in facts] == [("start", "1"), ("1", "300")]
    assert facts[1]["poses_passed"] == 298
    assert 0 < facts[1]["deviation_m"] <= 1e-4
    assert facts[1]["top_jerk_m_s3"] <= 20 * (1 + 1e-6)
    assert (out / "input" / "arc.csv").read_bytes() == path.read_bytes()
    before = contents(out)
    assert run(["iiwa", "joints", str(out)]) == 0
    assert run(["iiwa", "simulate", str(out)]) == 0
    assert "lag at most" in capsys.readouterr().out
    again = tmp_path / "again"
    assert run(["iiwa", "segments", str(tmp_path / "arc.csv"), "--output", str(again)]) == 0
    for name in ("equilibrium.csv", "equilibrium_quaternion.csv", "summary.json"):
        assert contents(again)[name] == before[name]


def test_more_than_forty_segments_are_summed_up(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    segments(long_path(tmp_path, "passing: stop\nprofile: trapezoid\n"))
    said = capsys.readouterr().out
    assert "arc.csv: 300 segments" in said
    assert len(said.splitlines()) < 20
    # 299 chords of the quarter circle and the line there
    (line,) = (line for line in said.splitlines() if line.strip().startswith("length [mm]"))
    assert float(line.split()[2]) == pytest.approx(100 * np.pi / 2 / 299, abs=0.01)
    assert "bound by a_max" in said


def test_a_csv_path_without_a_task_file_is_offered_one_that_works(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = long_path(tmp_path)
    (tmp_path / "arc.yaml").unlink()
    assert run(["iiwa", "segments", str(path), "--output", str(tmp_path / "out")]) == 2
    place, *lines = capsys.readouterr().err.splitlines()
    assert place.startswith(f"{tmp_path / 'arc.yaml'}: ")
    (tmp_path / "arc.yaml").write_text("\n".join(lines) + "\n")
    segments(path)
    assert "298 poses are passed" in capsys.readouterr().out
