"""Confdata held against the robot: by hand, against the truth files, and against joints followed step by step."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from some_motions import BENCH, RAIL, move_abs_j, move_c, move_ext_j, move_j, move_l, plant, program, wait

from trajopt_cli.geometry import Array, pose, rotation_about, wxyz_from_rotation
from trajopt_cli.motion import NO_EXTERNAL_AXES, ConfData, ExternalAxes, Motion, MoveL, Settings, Singularity
from trajopt_cli.path.line import Line
from trajopt_cli.problem.configurations import ConfigurationFinding, Misfit, check_configurations
from trajopt_cli.problem.path_ik import ArmPath, follow
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.programmed import PlantKinematics
from trajopt_cli.robot.inverse import confdata

TRUTH = Path(__file__).parents[1] / "data" / "truth"
DOWN = rotation_about([0, 1, 0], np.pi)
AHEAD = rotation_about([0, 1, 0], np.pi / 2)
BENCH_PLANT, RAIL_PLANT = plant(BENCH), plant(RAIL)
ROBOT = PlantKinematics(BENCH_PLANT)


def findings(*motions: Motion, on: Plant = BENCH_PLANT) -> list[ConfigurationFinding]:
    return list(check_configurations(program(*motions), on))


def to(degrees: list[float], kind: type[MoveL] | None = None, **more: object) -> Motion:
    """A move to the pose of these joints, in their own configuration unless told otherwise."""
    q = np.radians(degrees)
    fields = {"conf": ROBOT.confdata(q), **more}
    make = move_l if kind is MoveL else move_j
    return make(ROBOT.forward(q, NO_EXTERNAL_AXES), **fields)


def on_rail(mm: float | None) -> ExternalAxes:
    return (None, mm, None, None, None, None)


# ------------------------------------------------------------------------------------------------------ the points


def test_every_configuration_of_the_truth_is_reachable_and_all_are_listed() -> None:
    path = TRUTH / "irb140_ik.json"
    for case in json.loads(path.read_text())["cases"]:
        X_WF = np.array(case["T_rowmajor_4x4"]).reshape(4, 4)
        every = {
            ConfData(**one["conf"]) for solution in case["solutions"] for one in solution["in_limits_representatives"]
        }
        assert findings(*[move_j(X_WF, conf=conf) for conf in every]) == []
        strange = ConfData(0, 0, 5, 0)
        (found,) = findings(move_j(X_WF, conf=strange))
        assert found.misfit is Misfit.CONFDATA
        assert set(found.reachable) == every
        assert found.programmed == strange


def test_an_unreachable_pose_says_why() -> None:
    (found,) = findings(wait(), move_j(pose(DOWN, [0.9, 0, 0.4]), target="p_far"))
    assert (found.index, found.source.line, found.misfit, found.reachable) == (1, 2, Misfit.POSE, ())
    assert found.message.startswith("MoveJ p_far cannot be reached: wrist centre outside the outer workspace: ")
    assert found.rail is None


def test_configurations_to_be_had_are_listed_the_least_turned_first() -> None:
    (found,) = findings(to([0, 0, 0, 0, 90, 0], conf=ConfData(0, 0, 1, 0)))
    assert found.message.startswith("MoveJ p cannot be reached in confdata [0,0,1,0]; reachable with [0,0,0,0], [")
    assert found.message.endswith(" more")
    assert found.reachable[0] == ConfData(0, 0, 0, 0)


@pytest.mark.parametrize("noise", [-1e-8, 0.0, 1e-8])
def test_a_quadrant_off_by_rounding_is_no_finding(noise: float) -> None:
    """Joint 1 at 90 deg belongs to quadrant 1; printed targets fall on either side."""
    X_WF = ROBOT.forward(np.radians([90, 0, 0, 30, 40, 20]), NO_EXTERNAL_AXES)
    turned = pose(rotation_about([0, 0, 1], noise), [0, 0, 0]) @ X_WF
    for cf1 in (0, 1):
        assert findings(move_j(turned, conf=ConfData(cf1, 0, 0, 0))) == []
    assert [f.misfit for f in findings(move_j(turned, conf=ConfData(2, 0, 0, 0)))] == [Misfit.CONFDATA]


def test_the_rail_stands_where_the_target_says_or_where_it_stood() -> None:
    X_WF = pose(DOWN, [0.5, 1.4, 0.4])
    conf = ConfData(0, 0, 0, 0)
    assert findings(move_j(X_WF, conf=conf, extax=on_rail(1400)), on=RAIL_PLANT) == []
    first = move_abs_j(np.radians([0, 0, 0, 0, 30, 0]), extax=on_rail(1400))
    assert findings(first, move_j(X_WF, conf=conf), on=RAIL_PLANT) == []
    assert findings(move_ext_j(extax=on_rail(1400)), move_j(X_WF, conf=conf), on=RAIL_PLANT) == []
    (found,) = findings(move_j(X_WF, conf=conf), on=RAIL_PLANT)
    assert found.misfit is Misfit.POSE
    assert found.message.startswith("MoveJ p cannot be reached with the rail at 0 mm: wrist centre outside")
    (found,) = findings(move_j(X_WF, conf=conf, extax=on_rail(2300)), on=RAIL_PLANT)
    assert found.message.endswith("rail = 2.3 m, outside its stroke -0.2..2.2 m")
    assert found.rail == pytest.approx(2.3)


def test_where_confdata_is_off_only_poses_are_told() -> None:
    off = Settings(conf_j=False, conf_l=False)
    bad, far = ConfData(3, 3, 3, 7), pose(DOWN, [0.9, 0, 0.4])
    assert findings(to(START, conf=bad, settings=off), to(END, MoveL, conf=bad, settings=off)) == []
    assert [f.misfit for f in findings(move_j(far, settings=off), move_l(far, settings=off))] == [Misfit.POSE] * 2
    lines_off = Settings(conf_l=False)
    found = findings(to(START, conf=bad, settings=lines_off), to(END, MoveL, conf=bad, settings=lines_off))
    assert [f.index for f in found] == [0]


# ------------------------------------------------------------------------------------------------------- the lines

START, END = [10.0, 20.0, 10.0, 30.0, 40.0, 50.0], [15.0, 25.0, 5.0, 35.0, 45.0, 60.0]


def test_a_line_to_its_own_configuration_is_fine() -> None:
    assert findings(to(START), to(END, MoveL), to(START, MoveL)) == []


def test_a_flipped_wrist_is_told_with_what_it_would_do() -> None:
    flipped = ROBOT.inverse(ROBOT.forward(np.radians(END), NO_EXTERNAL_AXES), NO_EXTERNAL_AXES, None, np.radians(END))
    assert flipped is not None
    (found,) = findings(to(START), to(END, MoveL, conf=ConfData(0, -2, -2, 1), target="p_end"))
    assert found.misfit is Misfit.FLIP
    assert found.reachable == (ConfData(0, 0, 0, 0),)
    assert found.message == (
        "MoveL p_end leads from its start to confdata [0,0,0,0], and [0,-2,-2,1] is programmed: the wrist would have to"
        " flip on top of the line's own motion (joint_4 by -180°, joint_5 by -90°, joint_6 by -180°);"
        " write [0,0,0,0] there, or use MoveJ"
    )


WRIST = Settings(singularity=Singularity.WRIST)


@pytest.mark.parametrize("wrist", [True, False])
def test_an_arc_is_followed_as_a_line_is(wrist: bool) -> None:
    """Round by a point aside of the chord, to the end's own configuration or to that with the wrist flipped; under
    SingArea Wrist a controller drives the latter, and that is said."""
    start, end = (ROBOT.forward(np.radians(q), NO_EXTERNAL_AXES) for q in (START, END))
    via = (start + end) / 2 + np.array([[0, 0, 0, 0.03], *np.zeros((3, 4))])
    settings = WRIST if wrist else Settings()
    own = replace(move_c(end, conf=ConfData(0, 0, 0, 0), settings=settings), X_WV=via)
    assert findings(to(START), own) == []
    (found,) = findings(to(START), replace(own, conf=ConfData(0, -2, -2, 1)))
    assert (found.misfit, found.reachable) == (Misfit.FLIP, (ConfData(0, 0, 0, 0),))
    assert ("SingArea" in found.message) == wrist
    assert findings(to(START), replace(own, X_WV=start)) == []  # no circle: refused as such


@pytest.mark.parametrize("conf", [ConfData(0, -2, -2, 1), ConfData(0, 0, -4, 0)])
def test_a_wrist_that_a_controller_would_turn_by_itself_is_told_by_that_name(conf: ConfData) -> None:
    (found,) = findings(to(START), to(END, MoveL, conf=conf, settings=WRIST))
    assert found.misfit is Misfit.FLIP
    assert "SingArea" in found.message


def test_a_whole_turn_of_the_wrist_is_a_flip_too() -> None:
    (found,) = findings(to(START), to(END, MoveL, conf=ConfData(0, 0, -4, 0)))
    assert found.misfit is Misfit.FLIP
    assert "the wrist would have to wind on top of the line's own motion (joint_6 by -360°)" in found.message
    assert findings(to([*START[:5], START[5] - 360]), to(END, MoveL, conf=ConfData(0, 0, -4, 0))) == []


def test_a_joint_may_pass_180_degrees_on_the_way() -> None:
    """Joint 6 goes from 170 to 190 deg, and the inverse gives -170 for that."""
    assert findings(to([*START[:5], 170]), to([*START[:5], 190], MoveL)) == []
    short = [*START[:4], 40.5, 181.0]  # few samples
    assert findings(to([*START[:5], 179]), to(short, MoveL)) == []


def test_the_start_of_a_line_may_be_given_by_joints() -> None:
    start = move_abs_j(np.radians(START))
    assert findings(start, to(END, MoveL)) == []
    assert [f.misfit for f in findings(start, to(END, MoveL, conf=ConfData(0, 0, -4, 0)))] == [Misfit.FLIP]
    # the cell's own start, [0, 0, 0, 0, 30, 0] deg, is where the first line begins
    down = [0, 0, 0, 0, 60, 0]
    assert findings(to(down, MoveL)) == []
    assert [f.misfit for f in findings(to(down, MoveL, conf=ConfData(0, 0, 4, 0)))] == [Misfit.FLIP]


def test_a_confdata_that_is_not_to_be_had_tells_where_the_line_leads() -> None:
    (found,) = findings(to(START), to(END, MoveL, conf=ConfData(0, 0, 4, 0)))
    assert found.misfit is Misfit.CONFDATA
    assert found.reachable[0] == ConfData(0, 0, 0, 0)
    assert found.message.endswith("; the line leads to [0,0,0,0]")


def test_a_line_through_a_straight_wrist() -> None:
    """At the height of the wrist at zero, the tool straight ahead: joint 5 is 0 where the line crosses y = 0."""
    left, right = pose(AHEAD, [0.5, 0.1, 0.712]), pose(AHEAD, [0.5, -0.1, 0.712])
    start = next(conf for conf in findings(move_j(left, conf=ConfData(0, 0, 5, 0)))[0].reachable if conf.cfx == 0)
    end = next(conf for conf in findings(move_j(right, conf=ConfData(0, 0, 5, 0)))[0].reachable if conf.cfx == 0)
    (found,) = findings(move_j(left, conf=start), move_l(right, conf=end))
    assert found.misfit is Misfit.SINGULAR
    assert found.message == (
        "MoveL p passes a singularity at 100.0 mm of 200.0 mm: joint_5 is 0° and joint_4 and joint_6 turn about one"
        " axis; tilt the tool or use MoveJ"
    )
    assert findings(move_j(left, conf=start), move_l(pose(AHEAD, [0.5, 0.05, 0.712]), conf=start)) == []


def test_a_joint_that_would_pass_its_limit_on_the_way() -> None:
    """Joint 6 stands at 390 deg and the line turns the tool by 30 deg about its own axis: 400 is a third of that."""
    start = [*START[:5], 390.0]
    (found,) = findings(to(start), to([*START[:5], 420.0 - 360.0], MoveL))
    assert found.misfit is Misfit.LIMIT
    assert found.message == (
        "MoveL p drives joint_6 past its limit 400° at 35 % of its turn; start the line with that axis turned back"
        " (confdata of the point before)"
    )


def test_a_line_whose_middle_is_out_of_reach() -> None:
    """Facing backwards the arm reaches both ends and nothing between."""
    ends = [pose(rotation_about([0, 0, 1], np.radians(-60)) @ AHEAD, p) for p in ([0.2, 0.4, 0.7], [0.7, 0.2, 0.7])]
    start = ConfData(-2, 0, 0, 4)
    end = next(conf for conf in findings(move_j(ends[1], conf=ConfData(0, 0, 5, 0)))[0].reachable if conf.cfx in (0, 1))
    (found,) = findings(move_j(ends[0], conf=start), move_l(ends[1], conf=end))
    assert found.misfit is Misfit.REACH
    assert found.message.startswith("MoveL p cannot run as a line: at 3")
    assert found.message.endswith(" mm of 538.5 mm it is out of reach")


def test_the_rail_moves_while_a_line_runs() -> None:
    """Base and TCP go 1.5 m together: the joints stay. From either end's rail the other end is out of reach."""
    left, right = pose(DOWN, [0.5, 0.3, 0.4]), pose(DOWN, [0.5, 1.8, 0.4])
    conf = ConfData(0, 0, 0, 0)
    start = move_j(left, conf=conf, extax=on_rail(300))
    assert findings(start, move_l(right, conf=conf, extax=on_rail(1800)), on=RAIL_PLANT) == []
    turned = ConfData(0, 0, -4, 0)
    found = findings(start, move_l(right, conf=turned, extax=on_rail(1800)), on=RAIL_PLANT)
    assert [f.misfit for f in found] == [Misfit.FLIP]


def test_lines_behind_a_move_whose_configuration_is_unknown_are_not_judged() -> None:
    bad = to(START, conf=ConfData(0, 0, 5, 0))
    found = findings(bad, to(END, MoveL, conf=ConfData(0, -2, -2, 1)))
    assert [f.index for f in found] == [0]


def test_after_a_free_move_the_nearest_configuration_is_where_it_goes_on() -> None:
    free = to(START, conf=ConfData(3, 3, 3, 3), settings=Settings(conf_j=False))
    assert findings(free, to(END, MoveL)) == []
    assert [f.misfit for f in findings(free, to(END, MoveL, conf=ConfData(0, -2, -2, 1)))] == [Misfit.FLIP]


def newton(line: Line, X_FT: Array, q: Array, samples: int = 60) -> Array:
    """Joints at the end of a line, by Newton's method from sample to sample: no closed form, no branches."""
    robot, q = BENCH_PLANT.robot, q.copy()
    for X_WT in line.pose(np.linspace(0, 1, samples)):
        for _ in range(4):
            now = robot.forward(q) @ X_FT
            v = wxyz_from_rotation(X_WT[:3, :3] @ now[:3, :3].T)
            error = np.r_[X_WT[:3, 3] - now[:3, 3], 2 * v[1:]]
            q = q + np.linalg.solve(robot.jacobian(q, X_FT), error)
    return q


def test_random_lines_end_where_newtons_method_ends() -> None:
    rng, robot = np.random.default_rng(4), BENCH_PLANT.robot
    X_FT = pose(rotation_about([0, 1, 0], 0.4), [0.02, -0.01, 0.15])
    lines = []
    while len(lines) < 10:
        q_0 = np.radians(rng.uniform([-150, -60, -150, -180, -110, -380], [150, 90, 40, 180, 110, 380]))
        step = np.r_[rng.normal(0, 0.08, 3), rng.normal(0, 0.4, 3)] * rng.choice([0.1, 1.0])
        turn = rotation_about(step[3:] / np.linalg.norm(step[3:]), float(np.linalg.norm(step[3:])))
        X_0 = robot.forward(q_0)
        X_1 = pose(turn @ X_0[:3, :3], X_0[:3, 3] + step[:3])
        lines.append((line := Line(X_0 @ X_FT, X_1 @ X_FT), ArmPath(line, X_FT, (np.zeros(0), np.zeros(0)), q_0)))
    compared = 0
    for (line, path), followed in zip(lines, follow(BENCH_PLANT, [path for _, path in lines]), strict=True):
        assert followed is not None
        if followed.lost is None and followed.singular is None:
            np.testing.assert_allclose(followed.end, newton(line, X_FT, path.q), rtol=0, atol=1e-6)
            compared += 1
            low, high = BENCH_PLANT.limits.lower, BENCH_PLANT.limits.upper
            if followed.whole:
                assert np.all((followed.end >= low - 1e-6) & (followed.end <= high + 1e-6))
    assert compared > 6  # the others meet a singularity or the end of the reach


def test_findings_are_told_in_program_order_and_once_per_motion() -> None:
    bad = ConfData(0, 0, 5, 0)
    motions = [replace(to(START), conf=bad), to(START), to(END, MoveL, conf=bad), move_l(pose(DOWN, [2, 0, 0]))]
    assert [f.index for f in findings(*motions)] == [0, 2, 3]
    assert confdata(BENCH_PLANT.robot, np.radians(START)) == ConfData(0, 0, 0, 0)
