"""The analysis in steps of speed: sums by Pythagoras and by hand, the shipped line against published figures."""

from __future__ import annotations

from dataclasses import replace
from math import cos, hypot, pi, sin, sqrt
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.cell.loader import load_cell, parse_cell
from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.motion import MoveJ, MoveL, Program, Wait
from trajopt_cli.path.line import Line
from trajopt_cli.problem.plant import Plant, build_plant
from trajopt_cli.problem.workspace import rail_ranges
from trajopt_cli.rapid.reader import read_program
from trajopt_cli.report.stepwise import Analysis, analyse
from trajopt_cli.robot.inverse import confdata_admits, inverse, solutions
from trajopt_cli.scenario import Scenario

PROGRAMS = Path(__file__).parents[2] / "programs"
RAIL = """
robot: irb140_rail
rail: {eax: a, stroke: [-0.2, 2.2]}
limits: {rail: {velocity: 1.0, acceleration: 2.0, source: the test's}}
tcp: {speed: 2.5, acceleration: 20, source: the test's}
start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}
"""
FIXED = "robot: irb140\nbase: {position: [0.1, -0.2, 0.3], rpy: [0, 0, 90 deg]}\nstart: {joints: [0, 0, 0, 0, 0, 0]}\n"
# Upper arm upright, forearm level, the flange tilted down by 30 degrees; lengths of the IRB 140.
HOME = (0.07 + 0.38 + 0.065 * cos(pi / 6), 0.0, 0.352 + 0.36 - 0.065 * sin(pi / 6))
DOWN = "[0,0,1,0]"
REST = "9E9,9E9,9E9,9E9,9E9]"


def target(name: str, x: float, y: float, z: float, eax: str = "9E9", rot: str = DOWN) -> str:
    return f"CONST robtarget {name}:=[[{x},{y},{z}],{rot},[0,0,0,0],[{eax},{REST}];\n"


def joints(name: str, eax: str) -> str:
    return f"CONST jointtarget {name}:=[[0,0,0,0,30,0],[{eax},{REST}];\n"


def analysed(folder: Path, cell: str, data: str, code: str) -> Analysis:
    path = folder / "part.mod"
    path.write_text(f"MODULE Part\n{data}PROC main()\n{code}\nENDPROC\nENDMODULE\n")
    return analyse(read_program(path, Scenario()), build_plant(parse_cell(cell, "part.yaml")))


def test_lengths_by_pythagoras_at_programmed_speed(tmp_path: Path) -> None:
    """From home, over a 30-40-120 box (130 mm), then 90-120 aside (150 mm); what stands between adds nothing."""
    data = target("p_1", 500, 200, 400) + target("p_2", 530, 240, 280) + target("p_3", 440, 120, 280)
    code = """MoveJ p_1, v1000, z10, tool0;
        MoveL p_2, v500, fine, tool0; ! trajopt: optional
        WaitTime 0.3; SetDO do_grip, 1; WaitTime 0.2;
        MoveL p_3, v100, fine, tool0;"""
    out = analysed(tmp_path, RAIL, data, code)
    first = sqrt((0.5 - HOME[0]) ** 2 + 0.2**2 + (0.4 - HOME[2]) ** 2)
    assert [move.length for move in out.moves] == pytest.approx([first, 0.13, 0.15], abs=1e-12)
    assert [move.t_arm for move in out.moves] == pytest.approx([first / 1.0, 0.26, 1.5], abs=1e-12)
    assert out.moves[0].angle == pytest.approx(pi / 3, abs=1e-7)  # from 30 degrees below level to straight down
    assert [move.index for move in out.moves] == [0, 1, 5]
    assert [(wait.index, wait.duration) for wait in out.waits] == [(2, 0.3), (4, 0.2)]
    assert (out.arm, out.rail, out.cycle, out.wait) == pytest.approx((first + 1.76, 0.0, first + 1.76, 0.5), abs=1e-12)
    np.testing.assert_allclose(out.begins, [0, first, first + 0.26, first + 1.76], atol=1e-12)
    np.testing.assert_allclose(out.moves[1].velocity, np.array([30, 40, -120]) / 130 * 0.5, atol=1e-12)
    assert out.moves[1].v_tcp == 0.5


def test_of_a_wait_beside_a_move_what_is_longer_counts_as_a_wait(tmp_path: Path) -> None:
    """150 mm at 100 mm/s and a wait of 2 s, 130 mm at 500 mm/s and one of 0.1 s."""
    data = target("p_1", 530, 240, 280) + target("p_2", 440, 120, 280) + target("p_3", 410, 80, 400)
    code = """MoveJ p_1, v1000, fine, tool0;
        MoveL \\Conc, p_2, v100, fine, tool0; WaitTime 2;
        MoveL \\Conc, p_3, v500, fine, tool0; WaitTime 0.1;"""
    out = analysed(tmp_path, RAIL, data, code)
    assert [move.duration for move in out.moves][1:] == pytest.approx([1.5, 0.26], abs=1e-12)
    assert [wait.duration for wait in out.waits] == pytest.approx([0.5, 0.0], abs=1e-12)


def test_the_rail_alone_takes_its_rest_to_rest_time_while_the_arm_stands(tmp_path: Path) -> None:
    data = joints("j_far", "1500") + joints("j_near", "1200") + joints("j_open", "9E9")
    data += "CONST speeddata slow:=[1000,500,500,1000];\n"
    code = """MoveAbsJ j_far, v1000, fine, tool0;
        MoveExtJ j_near, v1000, fine;
        MoveAbsJ j_open, v1000, fine, tool0;
        MoveExtJ j_near, v1000, fine;
        MoveExtJ j_far, slow, fine;
        MoveExtJ j_near, slow\\T:=4, fine;"""
    out = analysed(tmp_path, RAIL, data, code)
    # 1.5/1 + 1/2; a triangle over 0.3 m; nothing to do, twice; a triangle again: 0.5 m/s needs 0.125 m, so a trapezoid;
    # and the programmed time
    wanted = [1.5 / 1.0 + 1.0 / 2.0, 2 * sqrt(0.3 / 2.0), 0.0, 0.0, 0.3 / 0.5 + 0.5 / 2.0, 4.0]
    assert [move.t_rail for move in out.moves] == pytest.approx(wanted, abs=1e-12)
    assert out.arm == 0.0
    assert out.cycle == out.rail == pytest.approx(sum(wanted), abs=1e-12)
    assert [(move.rail_0, move.rail_1) for move in out.moves[:3]] == [(0.0, 1.5), (1.5, 1.2), (1.2, 1.2)]
    for move in out.moves:
        np.testing.assert_allclose(move.X_BT_1[:3, 3], HOME, atol=1e-12)
        np.testing.assert_allclose(move.X_WT_1[:3, 3], np.add(HOME, [0, move.rail_1, 0]), atol=1e-12)
        assert move.v_tcp == 0.0
        assert not move.velocity.any()


def test_where_arm_and_rail_both_move_the_slower_decides(tmp_path: Path) -> None:
    """The pose stays in the world while the rail rides by 0.6 m: seen from the carriage it is the tool that travels."""
    data = target("p_1", 500, 200, 400, "0") + target("p_2", 500, 200, 400, "600") + target("p_3", 500, 200, 400, "0")
    code = "MoveJ p_1, v1000, fine, tool0;\nMoveL p_2, v200, fine, tool0;\nMoveL p_3, v2500, fine, tool0;"
    out = analysed(tmp_path, RAIL, data, code)
    slow, fast = out.moves[1:]
    rail = 0.6 / 1.0 + 1.0 / 2.0
    assert (slow.t_arm, slow.t_rail, slow.duration) == pytest.approx((3.0, rail, 3.0), abs=1e-12)
    assert (fast.t_arm, fast.t_rail, fast.duration) == pytest.approx((0.24, rail, rail), abs=1e-12)
    np.testing.assert_allclose(slow.velocity, [0, -0.2, 0], atol=1e-12)
    np.testing.assert_allclose(slow.X_WT_0, slow.X_WT_1, atol=1e-12)
    assert out.cycle == pytest.approx(out.moves[0].duration + 3.0 + rail, abs=1e-12)
    assert out.arm + out.rail > out.cycle + 1.0


def test_turning_may_take_longer_than_the_chord(tmp_path: Path) -> None:
    """10 mm and a quarter turn about the vertical: at 500 deg/s the turn takes 0.18 s, the way 0.01 s."""
    half = sqrt(0.5)
    data = target("p_1", 500, 200, 400) + target("p_2", 500, 200, 410, rot=f"[0,{half:.9f},{half:.9f},0]")
    out = analysed(tmp_path, RAIL, data, "MoveJ p_1, v500, fine, tool0;\nMoveL p_2, v1000, fine, tool0;").moves[1]
    assert out.angle == pytest.approx(pi / 2, abs=1e-8)
    assert out.t_arm == pytest.approx(90 / 500, abs=1e-8)
    np.testing.assert_allclose(out.velocity, [0, 0, 0.01 / 0.18], atol=1e-8)
    assert out.v_tcp == 1.0


def test_the_tcp_cap_and_a_programmed_time_replace_the_programmed_speed(tmp_path: Path) -> None:
    data = target("p_1", 500, 200, 400) + target("p_2", 500, 200, 700)
    code = """MoveL p_1, v500, fine, tool0;
        MoveL p_2, vmax, fine, tool0; MoveL p_1, v500\\T:=2, fine, tool0;"""
    capped, timed = analysed(tmp_path, RAIL, data, code).moves[1:]
    assert (capped.v_tcp, capped.t_arm) == pytest.approx((2.5, 0.3 / 2.5), abs=1e-12)
    assert (timed.v_tcp, timed.t_arm) == pytest.approx((0.15, 2.0), abs=1e-12)


def test_the_tool_in_force_is_the_point_that_travels(tmp_path: Path) -> None:
    """A tool 100 mm long at the flange of the point before stands 100 mm lower: there it has nothing left to travel."""
    data = target("p_1", 500, 200, 400) + target("p_2", 500, 200, 300) + target("p_3", 500, 240, 330)
    data += "PERS tooldata long:=[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];\n" + joints("j_far", "900")
    code = """MoveJ p_1, v500, fine, tool0; MoveL p_2, v500, fine, long;
        MoveL p_3, v500, fine, long; MoveExtJ j_far, v500, fine;"""
    out = analysed(tmp_path, RAIL, data, code).moves
    assert (out[1].length, out[1].t_arm) == (0.0, 0.0)
    assert out[2].length == pytest.approx(0.05, abs=1e-12)
    np.testing.assert_allclose(out[3].X_WT_1[:3, 3], [0.5, 1.14, 0.33], atol=1e-12)


def test_a_robot_without_a_rail_is_seen_from_its_base(tmp_path: Path) -> None:
    """The base is turned by 90 degrees about z: the world's y is its x, the world's -x its y."""
    # upright and level: the flange 515 mm ahead and 712 mm up, looking ahead along the world's y
    data = target("p_1", 100, 115, 1012, rot="[0.5,-0.5,0.5,0.5]") + target("p_2", 60, 145, 1012)
    code = "MoveJ p_1, v500, fine, tool0;\nMoveL p_2, v100, fine, tool0;"
    out = analysed(tmp_path, FIXED, data, code)
    first, second = out.moves
    np.testing.assert_allclose(first.X_BT_0[:3, 3], [0.515, 0, 0.712], atol=1e-12)
    np.testing.assert_allclose(first.X_WT_0[:3, 3], [0.1, 0.315, 1.012], atol=1e-12)
    assert first.length == pytest.approx(0.2, abs=1e-12)
    np.testing.assert_allclose(first.velocity, [-0.5, 0, 0], atol=1e-12)
    np.testing.assert_allclose(second.velocity, [0.06, 0.08, 0], atol=1e-12)
    assert second.length == pytest.approx(hypot(0.03, 0.04), abs=1e-12)
    assert out.rail == 0.0
    assert out.cycle == out.arm


@pytest.mark.parametrize(
    ("speed", "line"),
    [
        (
            "[500,0,5000,1000]",
            "MoveJ p_1: odd gives reorientation speed 0; a speed above 0 is needed",
        ),
        ("[500,500,0,1000]", "MoveJ p_1: odd gives speed of linear external axes 0; a speed above 0 is needed"),
    ],
)
def test_moving_at_no_speed_is_refused_in_one_line(tmp_path: Path, speed: str, line: str) -> None:
    data = target("p_1", 500, 200, 400, "100") + f"CONST speeddata odd:={speed};\n"
    with pytest.raises(InputError) as error:
        analysed(tmp_path, RAIL, data, "MoveJ p_1, odd, fine, tool0;")
    assert str(error.value) == f"{tmp_path / 'part.mod'}:5:1: {line}"


# The shipped line.


@pytest.fixture(scope="module")
def plant() -> Plant:
    return build_plant(load_cell(PROGRAMS / "hinge_line.yaml"))


@pytest.fixture(scope="module")
def line() -> Program:
    return read_program(PROGRAMS / "hinge_line.mod", Scenario())


# Every point as the carriage sees it [mm] and the speed on the way there [mm/s], copied from the program by hand.
_H = tuple(1000 * value for value in HOME)
N1 = [(460, -180, 440, 600), (540, -240, 400, 500), (540, -240, 340, 200), (540, -240, 400, 200), (460, -180, 440, 500)]
CLEAR = (460, -120, 480, 600)
N2 = [
    (460, -140, 440, 2500),
    (540, -200, 400, 500),
    (540, -200, 340, 200),
    (540, -200, 400, 200),
    (460, -140, 440, 500),
]
N3 = [(460, 260, 520, 800), (540, 320, 470, 500), (540, 320, 410, 200), (540, 320, 470, 200), (460, 260, 520, 500)]
FOLD = (*_H, 600)


def test_the_line_meets_the_published_sums(line: Program, plant: Plant) -> None:
    out = analyse(line, plant)
    assert out.arm == pytest.approx(5.557, abs=1e-3)
    assert out.rail == pytest.approx(2 * (1.5 / 1.0 + 1.0 / 2.0), abs=1e-12)
    assert out.cycle == pytest.approx(9.557, abs=1e-3)
    assert out.wait == pytest.approx(19.5 - 14.7, abs=1e-12)
    way = np.array([(*_H, 1), *N1, FOLD, CLEAR, *N2, *N3, FOLD])
    times = np.linalg.norm(np.diff(way[:, :3], axis=0), axis=1) / way[1:, 3]
    assert [move.t_arm for move in out.moves if move.t_rail == 0] == pytest.approx(times.tolist(), abs=1e-9)
    detours = times[[0, 5, 6, 7, 17]].sum() / times.sum()
    assert detours == pytest.approx((19.5 - 15.79) / 10.7, abs=0.01)


def test_every_point_of_the_line_is_reached_as_programmed(line: Program, plant: Plant) -> None:
    """At the programmed rail with the programmed confdata, by forward kinematics; lines keep branch and wrist bend."""
    robot, previous = plant.robot, None
    poses = 0
    for motion in line.motions:
        if not isinstance(motion, MoveJ | MoveL):
            previous = previous if isinstance(motion, Wait) else None
            continue
        rail = plant.rail_value(motion.extax)
        assert rail is not None
        X_WT: Array = motion.X_WT
        found = [q for _, q in solutions(robot, X_WT, rail, plant.limits) if confdata_admits(robot, motion.conf, q)]
        assert found, motion.target
        for q in found:
            np.testing.assert_allclose(robot.forward(np.r_[rail, q]), X_WT, atol=1e-9)
        wrong = replace(motion.conf, cf1=motion.conf.cf1 + 1)
        assert not any(confdata_admits(robot, wrong, q) for _, q in solutions(robot, X_WT, rail, plant.limits))
        if isinstance(motion, MoveL):
            assert previous is not None, "a line has no start"
            way = Line(previous, X_WT).pose(np.linspace(0, 1, 51))
            q = inverse(robot, way, np.tile(rail, (51, 1)))[:, motion.conf.cfx]
            assert np.degrees(q[:, 4]).min() > 45.0  # far from the wrist's singularity
            assert (np.abs(np.cos(q[:, 2])) > np.sin(np.radians(45))).all()  # and from the stretched elbow
            assert ((q > plant.limits.lower[1:]) & (q < plant.limits.upper[1:])).all()
        previous, poses = X_WT, poses + 1
    assert poses == 16


def test_the_line_has_two_functional_areas(line: Program, plant: Plant) -> None:
    """N1 from one rail position, N2 and N3 from another, and none serves a point of N1 and one of N2 or N3."""
    first: list[Array] = []
    second: list[Array] = []
    for motion in line.motions:
        if isinstance(motion, MoveJ | MoveL):
            (first if motion.target.startswith("p_n1") else second).append(rail_ranges(plant, motion.X_WT))
    assert (len(first), len(second)) == (5, 11)
    for ranges, rail in ((first, 0.0), (second, 1.5)):
        assert all(((one[:, 0] < rail - 0.1) & (rail + 0.1 < one[:, 1])).any() for one in ranges)
    assert max(one.max() for one in first) < min(one.min() for one in second)


def test_an_arc_counts_along_the_arc(tmp_path: Path) -> None:
    """Half a circle of 100 mm: 314.16 mm at v100, zones or not; the mean velocity goes straight across."""
    data = target("p_1", 500, -100, 400) + target("p_2", 600, 0, 400) + target("p_3", 500, 100, 400)
    code = "MoveJ p_1, v1000, z10, tool0;\nMoveC p_2, p_3, v100, z50, tool0;\nMoveL p_1, v100, fine, tool0;"
    arc, back = analysed(tmp_path, FIXED.replace("rpy: [0, 0, 90 deg]", "rpy: [0, 0, 0]"), data, code).moves[1:]
    assert arc.length == pytest.approx(0.1 * pi, rel=1e-12)
    assert (arc.t_arm, back.t_arm) == pytest.approx((pi, 2.0))
    np.testing.assert_allclose(arc.velocity, [0, 0.2 / pi, 0], atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(arc.real - [0.5, 0, 0.4], axis=1), 0.1, atol=1e-12)
    shares, velocities = arc.velocities
    assert shares[[0, -1]].tolist() == [0, 1]
    np.testing.assert_allclose(np.linalg.norm(velocities, axis=1), 0.1, rtol=1e-3)  # chords of a 96th of the arc
    np.testing.assert_allclose(velocities[0], [0.1, 0, 0], atol=2e-3)


def test_an_arc_on_a_moving_carriage_is_what_the_carriage_sees(tmp_path: Path) -> None:
    """Its length against the sum of 100000 chords of the same way, circle minus rail."""
    data = (
        target("p_1", 500, 200, 400, "200") + target("p_2", 600, 300, 400, "9E9") + target("p_3", 500, 400, 400, "300")
    )
    arc = analysed(tmp_path, RAIL, data, "MoveJ p_1, v1000, fine, tool0;\nMoveC p_2, p_3, v100, fine, tool0;").moves[1]
    share = np.linspace(0, 1, 100_001)
    phi = pi * share
    seen = np.column_stack([0.1 * np.sin(phi), -0.1 * np.cos(phi) - 0.1 * share])
    assert arc.length == pytest.approx(np.linalg.norm(np.diff(seen, axis=0), axis=1).sum(), rel=1e-8)
    assert arc.length < 0.1 * pi
    ends = arc.X_BT_1[:3, 3] - arc.X_BT_0[:3, 3]
    np.testing.assert_allclose(arc.seen[-1] - arc.seen[0], ends, atol=1e-12)
