"""Chapter 6 by our engines: the thesis' tables, closed forms of the law, and a record that is the same every time."""

from __future__ import annotations

import io
import itertools
import json
import math
from collections.abc import Iterator
from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.layout_engine import ConstrainedLayoutEngine
from rich.console import Console
from scipy.spatial.transform import Rotation

from trajopt_cli.cli.experiments_tables import tables
from trajopt_cli.iiwa.controller.admittance import Controller
from trajopt_cli.iiwa.controller.loop import run
from trajopt_cli.iiwa.controller.parameters import Settings
from trajopt_cli.iiwa.experiments import collision, feed_scheduling, following, guiding, loop_time, pictures, steps
from trajopt_cli.iiwa.experiments.catalogue import EXPERIMENTS, Experiments, bench_of
from trajopt_cli.iiwa.experiments.force_error import force_error
from trajopt_cli.iiwa.experiments.record import record
from trajopt_cli.iiwa.experiments.setup import START, Bench, Series, Tracking, compliance
from trajopt_cli.iiwa.experiments.stability import stability
from trajopt_cli.iiwa.task.model import Clamps, Push, Zeroing
from trajopt_cli.iiwa.world.mujoco_world import available
from trajopt_cli.iiwa.world.worlds import Engine, make_world
from trajopt_cli.robot.srs_inverse import ArmAngle

WALL = """
robot: iiwa7
start: {joints: "[0, 30, 0, -100, 0, 50, 0] deg"}
h: 2 ms
tool: {position: [0, 0, 0.1]}
profile: trapezoid
v_max: 0.2 m/s
omega_max: 1 rad/s
a_max: 2 m/s2
epsilon_max: 5 rad/s2
poses:
  - {name: start, at: start}
  - {name: side, by: [0, -0.1, -0.04, 0, 0, 0], dwell: 1 s}
  - {name: over, by: [0, 0.1, 0, 0, 0, 0], dwell: 1.2 s}
  - {name: back, by: [0, -0.1, 0, 0, 0, 0], dwell: 0.5 s}
  - {name: beyond, by: [0, 0.2, 0, 0, 0, 0]}
K: [1000, 1000, 1000, 30, 30, 30]
D: [500, 500, 400, 20, 20, 20]
M: [25, 25, 25, 3, 3, 3]
contact:
  tip: 0.03
  obstacles:
    block:
      box: {size: [0.3, 0.06, 0.1], position: [0.506, 0, HEIGHT]}
      stiffness: 20 N/mm
      damping: 100
      friction: 0.2
"""


def wall(folder: Path, height: float) -> Path:
    """A task whose tip crosses a block with its middle at this height [m]."""
    file = folder / "wall.yaml"
    file.write_text(WALL.replace("HEIGHT", f"{height}"))
    return file


@pytest.fixture(scope="module")
def bench() -> Bench:
    return bench_of("spring")


@pytest.fixture(scope="module")
def hit(bench: Bench, tmp_path_factory: pytest.TempPathFactory) -> collision.Collision:
    return collision.collision(bench, wall(tmp_path_factory.mktemp("wall"), 0.095))


@pytest.fixture(scope="module")
def whole(bench: Bench, hit: collision.Collision) -> Iterator[Experiments]:
    """Every experiment, what is slow in a shorter form."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(feed_scheduling, "BOUND", 0.1)  # fed in seconds, not in minutes
        patch.setattr(loop_time, "_PERIODS", 100)
        yield Experiments(
            engine=bench.engine,
            force_stiffness=steps.force_stiffness(bench),
            force_damping=steps.force_damping(bench),
            orientation=steps.orientation(bench),
            all_axes=steps.all_axes(bench),
            force_error=force_error(bench),
            guiding=guiding.guiding(bench),
            zeroing=guiding.zeroing(bench),
            stability=stability(bench),
            speed=following.speed(bench),
            stiffness=following.stiffness(bench),
            damping=following.damping(bench),
            collision=hit,
            loop_time=loop_time.loop_time(bench),
            dosing=feed_scheduling.dosing(bench),
        )


def test_the_speed_table_is_the_thesis_within_6_percent(whole: Experiments) -> None:
    """Table 6.10 on one space diagonal, and the digest's own simulation of the same."""
    assert whole.speed.worst < 0.06
    ours = [case.diagonal for case in whole.speed.cases]
    assert ours == pytest.approx([0.043, 0.085, 0.154, 0.232, 0.288, 0.305], abs=0.0012)
    assert [case.thesis for case in whole.speed.cases] == [0.043, 0.089, 0.163, 0.233, 0.275, 0.295]
    # at the lowest speed the lag has come to rest: D v / K with v along each axis
    assert ours[0] == pytest.approx(math.sqrt(3) * 500 * 0.05 / 1000, rel=2e-3)
    along = [case.edges for case in whole.speed.cases]
    assert (along[0], along[-1]) == pytest.approx((0.025, 0.212), abs=5e-4)


def test_stiffness_and_damping_go_the_thesis_way(whole: Experiments) -> None:
    for table, rises in ((whole.stiffness, True), (whole.damping, True)):
        ours = np.array([case.diagonal for case in table.cases])
        theirs = np.array([case.thesis for case in table.cases])
        assert np.all(np.diff(ours) > 0) == rises == np.all(np.diff(theirs) > 0)
    assert [case.value for case in whole.stiffness.cases] == [2000, 1000, 500, 200, 100]
    assert whole.stiffness.worst < 0.345
    assert whole.damping.worst < 0.215


def test_the_path_that_fits_better_is_drawn(whole: Experiments) -> None:
    for table in (whole.speed, whole.stiffness, whole.damping):
        misses = {
            name: max(abs(getattr(case, name) / case.thesis - 1) for case in table.cases)
            for name in ("diagonal", "edges")
        }
        assert table.drawn == min(misses, key=misses.__getitem__)
        for case, series in zip(table.cases, table.runs, strict=True):
            deviation = np.linalg.norm((series.x - series.x_e)[:, :3], axis=1)
            assert deviation.max() == pytest.approx(getattr(case, table.drawn), rel=1e-9)
    assert (whole.speed.drawn, whole.stiffness.drawn, whole.damping.drawn) == ("diagonal", "edges", "diagonal")


def test_no_other_speed_fits_better(whole: Experiments) -> None:
    """The search against its neighbours on the grid of 0.01 m/s, computed anew."""
    table = whole.damping
    assert table.speed is not None
    for v in (table.speed - 0.01, table.speed + 0.01):
        path = following.diagonal(v)
        others = [
            following._most(path, compliance(1000.0, 30.0, case.value, 20.0)) / case.thesis - 1 for case in table.cases
        ]
        assert max(map(abs, others)) > table.worst


def test_forces_end_at_f_over_k_and_overshoot_as_the_damping_ratio_says(whole: Experiments) -> None:
    parts = (whole.force_stiffness, whole.force_damping, whole.all_axes, whole.orientation)
    answers = [one for part in parts for run in part.runs for one in run.answers]
    assert len(answers) == 6 + 6 + 6 + 3
    for one in answers:
        assert one.steady == pytest.approx(one.expected, rel=1e-3)
        assert one.overshoot == pytest.approx(one.overshoot_expected, abs=4e-3)
        assert 0 < one.settling < 4
    swinging, damped = (run.answers[0] for run in whole.force_damping.runs)
    assert swinging.overshoot > 0.4 > 0.01 > damped.overshoot
    # the envelope e^(-d t / 2m) of k = 500, d = 50, m = 25 reaches 2 % at 3.9 s
    assert swinging.settling == pytest.approx(math.log(50), rel=0.05)


def test_the_controllers_own_loop_gives_the_same(bench: Bench) -> None:
    """Period by period with inverse kinematics, measured forces clamped away: moments, forces and zeroing together."""
    law = compliance(500.0, 40.0, 100.0, 30.0)
    blind = Zeroing((True, False, False, False, False, True), np.array(guiding.FRAME))
    pushes = (Push(0.05, 0.2, np.array([10.0, -5, 3, 1, 2, -1])), Push(0.1, 0.3, np.array([0, 0, 4.0, 0, 0, 1])))
    tiny = Clamps(force=np.full(6, 1e-12))
    settings = Settings(law, 1e-3, ArmAngle.FARIA, zeroing=blind, clamps=tiny, pushes=pushes)
    world = make_world(Engine.SPRING, bench.robot, np.eye(4), None, None, 1e-3)
    looped = run(Controller(bench.robot, settings, START), np.tile(bench.start, (401, 1)), world, bench.robot.profile())
    done = bench.pushed(law, pushes, 0.4, blind)
    assert looped.stop is None
    assert np.abs(done.x - looped.x).max() < 1e-12
    assert np.abs(done.v - looped.v).max() < 1e-11
    assert np.abs(done.force - looped.force_believed).max() < 1e-10
    assert np.abs(done.x - done.x_e).max() > 1e-3


def test_a_force_beyond_the_arms_reach_is_refused(bench: Bench) -> None:
    with pytest.raises(RuntimeError, match="would be stopped"):
        bench.pushed(compliance(100.0, 30.0, 100.0, 20.0), [Push(0, 4.0, np.array([60.0, 0, 0, 0, 0, 0]))], 4.0)


def test_errors_of_torques_become_forces_within_the_worst_corner(bench: Bench, whole: Experiments) -> None:
    """The bound from the corners of the errors' box, through numpy's own pseudo-inverse of J^T."""
    inverse = np.linalg.pinv(bench.robot.jacobian(np.array(START)).T)
    box = 0.02 * np.array([176, 176, 110, 110, 110, 40, 40]) + 0.5
    corners = np.array(list(itertools.product((-1, 1), repeat=7))) * box
    worst = np.abs(corners @ inverse.T).max(axis=0)
    for i, one in enumerate(whole.force_error.rows):
        assert one.bound == pytest.approx(worst[i])
        assert 1.0 < one.median < one.greatest < one.bound
        # the thesis' force gauge and our data sheet speak of the same size
        assert min(one.thesis) / 3 < one.median < 3 * max(one.thesis)
    assert [one.thesis_median for one in whole.force_error.rows] == [6.5, 4.0, 5.0]


def test_the_worst_of_the_flange_is_taken_from_all_parts() -> None:
    def part(*rows: Tracking) -> steps.Steps:
        series = Series("", np.arange(2.0), np.zeros((2, 6)), np.zeros((2, 6)))
        return steps.Steps("", "", "", (steps.StepRun("", 1.0, 1.0, (), rows, series),), ())

    small, large = Tracking("y", 1e-3, 5e-4, 0.1, 0.1), Tracking("y", 2e-3, 1e-4, 0.1, 0.1)
    turn = Tracking("gamma", 3e-3, 2e-3, 0.1, 0.1)
    found = steps.worst_tracking([part(small), part(turn, large), part()])
    assert found == (Tracking("y", 2e-3, 5e-4, 0.0016, 0.0003), Tracking("gamma", 3e-3, 2e-3, 0.0092, 0.0004))
    assert steps.worst_sentences([part(small, turn)]) == ()
    turned = replace(part(turn), section="6.1.3")
    first, second, _ = steps.worst_sentences([part(small, large), turned])
    assert "thesis' distance over 50.0 to 100.0 in position, over 33 to 33 in orientation: doubt the latter" in first
    assert "in 6.1.3 67 to 67 Nm would give its distances" in second


def test_a_hand_leads_by_its_impulse_over_the_damping_and_leaves_the_arm_there(whole: Experiments) -> None:
    for lead in whole.guiding.leads:
        assert lead.way == pytest.approx(10 * 1.0 / 100, rel=1e-3)
        assert lead.speed == pytest.approx(lead.speed_expected, rel=1e-3)
        assert lead.aside < 5e-5
    assert whole.guiding.left < 1e-4


def test_zeroed_forces_leave_motion_along_the_frames_z_axis(whole: Experiments) -> None:
    axis = Rotation.from_euler("xyz", [-45, -30, 0], degrees=True).as_matrix()[:, 2]
    assert whole.zeroing.direction == pytest.approx(axis, abs=1e-9)
    assert np.round(whole.zeroing.direction, 3).tolist() == [-0.354, 0.707, 0.612]
    assert whole.zeroing.angle < 1e-9
    assert whole.zeroing.aside < 1e-9
    assert whole.zeroing.length > 0.1
    series = whole.zeroing.series
    assert series.felt is not None
    assert series.force is not None
    # what passes of a force is its part along the axis
    assert series.force[:, :3] == pytest.approx(np.outer(series.felt[:, :3] @ axis, axis), abs=1e-12)
    assert np.abs(series.felt).max() == 10


def test_the_stability_map_is_that_of_the_poles(whole: Experiments) -> None:
    found = whole.stability
    rng = np.random.default_rng(3)
    for i, j in rng.integers(1, 97, (200, 2)).tolist():
        k, d, h, m = found.k[i], found.d[j], 1e-3, 25.0
        size = np.abs(np.roots([1, -(2 - h * d / m), 1 - h * d / m + h * h * k / m])).max()
        if abs(size - 1) > 1e-9:
            assert (found.verdicts[i, j] == 2) == (size < 1), (k, d)
    assert {one.verdict.name for one in found.settings if one.k > 0} == {"STABLE"}
    assert {one.verdict.name for one in found.settings if one.k == 0} == {"MARGINAL"}
    assert 0.1 < found.denied < 0.9


def test_a_collision_pushes_the_controller_out_until_spring_and_wall_agree(hit: collision.Collision) -> None:
    """Eq. 4.20: standing on the block, F = K (x - x_e)."""
    (run,) = hit.runs
    assert run.stop == ""
    assert run.crossings == 2
    assert run.first is not None
    assert run.first > 1.0
    series = run.series
    assert series.force is not None
    standing = round(3.25 / 2e-3)
    away = series.x[standing, 2] - series.x_e[standing, 2]
    assert run.depth[standing] > 0
    assert series.force[standing, 2] == pytest.approx(1000 * away, rel=0.03)
    assert series.force[standing, 2] == pytest.approx(20_000 * run.depth[standing], rel=0.03)
    assert 0.005 < away <= run.excursion < 0.03
    assert run.normal >= series.force[standing, 2]
    assert run.friction <= 0.2 * run.normal + 1e-9
    assert run.across > run.friction  # the edge pushed


def test_beside_the_obstacle_nothing_is_touched(bench: Bench, tmp_path: Path) -> None:
    (run,) = collision.collision(bench, wall(tmp_path, 0.02)).runs
    assert (run.first, run.crossings, run.normal, run.excursion) == (None, 0, 0.0, 0.0)


def test_dosing_keeps_its_bound_where_the_rest_does_not(whole: Experiments) -> None:
    undosed, fed, dosed = whole.dosing.rows
    assert dosed.lag.maximum <= 0.1 * (1 + 1e-9)
    assert undosed.lag.maximum > 0.1
    assert fed.lag.maximum < undosed.lag.maximum
    assert dosed.duration >= whole.dosing.least
    assert whole.dosing.steady == pytest.approx(500 * 0.4 / 1000)
    for series, row in zip(whole.dosing.series, whole.dosing.rows, strict=True):
        worst = np.linalg.norm(series.x[:, :3] - series.x_e[:, :3], axis=1).max()
        assert worst == pytest.approx(row.lag.maximum, rel=1e-9)


def test_the_record_is_plain_and_the_same_again(bench: Bench, whole: Experiments, tmp_path: Path) -> None:
    first = record(whole)
    again = record(
        replace(
            whole,
            all_axes=steps.all_axes(bench),
            force_stiffness=steps.force_stiffness(bench),
            zeroing=guiding.zeroing(bench),
            stability=stability(bench),
            speed=following.speed(bench),
            collision=collision.collision(bench, wall(tmp_path, 0.095)),
            loop_time=loop_time.loop_time(bench),
        )
    )
    said = {"flange_worst", "flange_worst_notes", "flange_worst_of_the_earlier_work_m"}
    assert set(first) == set(EXPERIMENTS) | {"engine", "measured"} | said
    measured = first.pop("measured"), again.pop("measured")
    assert json.dumps(first, allow_nan=False) == json.dumps(again, allow_nan=False)
    parts = [{part["part"] for part in one["loop_time"]["parts"]} for one in measured]
    assert parts[0] == parts[1]
    for part in measured[0]["loop_time"]["parts"]:
        assert 0 < part["least_s"] <= part["mean_s"] <= part["longest_s"]


def test_every_experiment_has_a_field_and_a_table(whole: Experiments) -> None:
    assert {field.name for field in fields(Experiments)} == set(EXPERIMENTS) | {"engine"}
    out = io.StringIO()
    console = Console(width=200, markup=False, file=out)
    for one in tables(whole):
        console.print(one)
    text = out.getvalue()
    for section in ("6.1.1", "6.1.2", "6.1.3", "6.1.4", "6.1.6", "6.1.7", "6.1.8", "6.2.1", "6.2.2", "6.2.3", "6.2.4"):
        assert section in text
    for figure in ("thesis [mm]", "295.0", "148", "erratum", "needs the extra sim", "(-0.354, 0.707, 0.612)"):
        assert figure in text


def test_every_section_has_its_picture(whole: Experiments, monkeypatch: pytest.MonkeyPatch) -> None:
    from trajopt_cli.iiwa.report import pictures as compliance

    monkeypatch.setattr(compliance, "files", lambda name, figure, title: {f"{name}.svg": title.encode()})
    monkeypatch.setattr(ConstrainedLayoutEngine, "execute", lambda *_: None)  # only names are asked of them
    physics = replace(whole.collision.runs[0], world="physics")
    two = replace(whole, collision=replace(whole.collision, runs=(*whole.collision.runs, physics)))
    names = {name.removesuffix(".svg") for name in pictures.pictures(two)}
    assert names == {
        "force_stiffness", "force_damping", "orientation", "all_axes", "force_error", "guiding", "zeroing", "stability",
        "speed_deviation", "speed_path", "speed_table", "stiffness_deviation", "stiffness_path", "stiffness_table",
        "damping_deviation", "damping_path", "damping_table", "collision", "collision_physics", "loop_time", "dosing",
        "dosing_path",
    }  # fmt: skip


@pytest.mark.skipif(available() is None, reason="MuJoCo, the extra sim, is not installed")
def test_in_mujoco_the_flange_follows_within_the_thesis_millimetres() -> None:
    bench = bench_of("mujoco")
    push = Push(0.1, 2.0, np.array([10.0, 0, 0, 0, 0, 0]))
    done = bench.pushed(compliance(500.0, 30.0, 100.0, 20.0), [push], 0.8)
    assert done.flange is not None
    away = np.abs(done.flange - done.x)
    assert 1e-5 < away[:, 0].max() < 2e-3
    assert away[:100].max() < 1e-6  # at rest before the push
    assert done.x[-1, 0] - done.x[0, 0] > 0.015
