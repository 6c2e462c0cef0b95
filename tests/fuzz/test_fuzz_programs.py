"""Small random programs through optimise, judge, export and reading back; a few of them, always the same."""

from __future__ import annotations

import gc
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from small_programs import Small, check_same_motions, program, round_trip

from trajopt_cli.geometry import inverse_pose
from trajopt_cli.job import read_job
from trajopt_cli.pipeline.folder import verify_file
from trajopt_cli.pipeline.optimize import OptimizedJob, optimize_job
from trajopt_cli.plan import optimize
from trajopt_cli.problem.build import build_problem
from trajopt_cli.problem.decision_scope import Freedom
from trajopt_cli.problem.editable import everything
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.problem.problem import Problem

ENDS_WITH_A_WAIT = Small(
    """MODULE Small
  PROC main()
    MoveJ [[465.343,33.836,715.307],[0.461408084,0.355697186,0.760587867,0.286510365],[0,0,0,0],"""
    """[9E9,9E9,9E9,9E9,9E9,9E9]], v200, fine, tool0;
    WaitTime 0.2;
  ENDPROC
ENDMODULE
""",
    "robot: irb1200_5_90\nstart: {joints: '[0, 0, 0, 0, 30, 0] deg'}\n",
    250.0,
)

WAITS_A_MILLISECOND = Small(
    "MODULE Small\n"
    "PERS tooldata tGrip:=[TRUE,[[0,0,0],[1,0,0,0]],[0.001,[0,0,0.001],[1,0,0,0],0,0,0]];\n"
    'PERS wobjdata wobjHere:=[FALSE,TRUE,"",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];\n'
    "PROC main()\n"
    "MoveL [[508.279,-0.916,678.903],[0.524865095,-0.193527888,0.817797651,-0.135168752],[0,-1,-1,0],[9E9"
    ",9E9,9E9,9E9,9E9,9E9]], v200, fine, tGrip\\WObj:=wobjHere;\n"
    "WaitTime 0;\n"
    "MoveJ [[336.399,571.441,610.236],[0.526893680,-0.317384404,0.695056979,0.372217659],[0,0,-1,0],[9E9,"
    "9E9,9E9,9E9,9E9,9E9]], v2500\\T:=1.46, fine, tGrip\\WObj:=wobjHere;\n"
    "ENDPROC\n"
    "ENDMODULE\n",
    "robot: irb140\nstart: {joints: '[0.0000,0.0000,0.0000,0.0000,30.0000,0.0000] deg'}\n",
    1000.0,
)


@pytest.fixture(scope="module", autouse=True)
def _no_garbage_of_others() -> None:
    """Every plan looks for garbage, here through what earlier files left: hundreds of thousands of objects."""
    gc.freeze()


@pytest.mark.parametrize("number", range(2))
def test_a_small_program_keeps_its_promises(number: int, tmp_path: Path) -> None:
    assert round_trip(program(0, number), tmp_path) in ("planned", "infeasible", "no RAPID text")


@pytest.mark.long
@pytest.mark.parametrize("number", [226, 973, 3253, 7484])
@pytest.mark.usefixtures("unrefined")  # all of it was wrong of first legal motions already
def test_what_a_long_run_found_is_planned(number: int, tmp_path: Path) -> None:
    """An arc wholly within the zone before it, at the end of the file; a rail that may go nowhere beside a corner; a
    stop at the end of an arc within the zone before it, and a motion from there that comes nearer to that point; a
    line beside axis 1, where an axis turns by more than half a turn from node to node."""
    assert round_trip(program(1, number), tmp_path) == "planned"


def test_an_arc_that_leaves_a_range_between_the_nodes_of_the_search_is_refused_with_its_place(tmp_path: Path) -> None:
    """joint_3 is beyond its range for a few degrees of 317, in every posture the arc may begin in.

    The tool turns as on a line.
    """
    text = program(1, 7091).text.replace("PROC main()", "PROC main()\nCirPathMode\\ObjectFrame;")
    (tmp_path / "small.mod").write_text(text)
    (tmp_path / "small.yaml").write_text(program(1, 7091).cell)
    job = read_job(tmp_path / "small.mod")
    answer = optimize(job.program, job.plant, Target.STREAM, bounded=False)
    assert isinstance(answer, Infeasible)
    said = re.search(
        r"^MoveC .* breaks at ([0-9.]+) mm of ([0-9.]+) mm, .* ends with joint_3 = ([0-9.]+)°, limit 50°$",
        answer.message,
    )
    assert said is not None, answer.message
    problem = build_problem(job.program, job.plant, Freedom(), Target.STREAM, everything(job.program, job.plant))
    assert isinstance(problem, Problem)
    (leg,) = [one for one in problem.legs if one.segment is not None]
    limits, robot = job.plant.limits, job.plant.robot
    ways = leg.segment.pose(np.linspace(0, 1, 2001)) @ inverse_pose(leg.X_FT)
    left = []
    for _, arm in robot.solutions(ways[0], None, limits):
        for at, near in enumerate(robot.branches(ways, None)):
            arm = min(near + 2 * np.pi * np.round((arm - near) / (2 * np.pi)), key=lambda q: np.abs(q - arm).max())
            if np.any((arm < limits.lower) | (arm > limits.upper)):
                left.append(at / 2000)
                break
    assert len(left) == len(robot.solutions(ways[0], None, limits))
    share = float(said[1]) / float(said[2])
    assert max(left) == pytest.approx(share, abs=0.01)
    assert np.degrees(limits.upper[2]) == pytest.approx(50)
    there = robot.branches(leg.segment.pose(np.array([share])) @ inverse_pose(leg.X_FT), None)[0]
    assert np.abs(np.degrees(there[:, 2]) - float(said[3])).min() < 0.01


@pytest.mark.usefixtures("unrefined")
def test_a_wait_at_the_end_is_as_long_as_coarse_rows_show(tmp_path: Path) -> None:
    """The row at its end is closer than a row's distance; what rows leave open is at its begin."""
    assert round_trip(ENDS_WITH_A_WAIT, tmp_path) == "planned"
    shorter = replace(ENDS_WITH_A_WAIT, text=ENDS_WITH_A_WAIT.text.replace("0.2", "0.21"))
    (tmp_path / "small.mod").write_text(shorter.text)
    assert not verify_file(tmp_path / "joint.csv", read_job(tmp_path / "small.mod")).legal


def test_of_a_wait_shorter_than_rows_show_none_is_held_against_the_stop(tmp_path: Path) -> None:
    assert round_trip(WAITS_A_MILLISECOND, tmp_path) == "planned"


def test_programs_are_the_same_for_the_same_number_and_of_every_kind() -> None:
    texts = [program(0, k).text for k in range(60)]
    assert texts == [program(0, k).text for k in range(60)]
    assert len(set(texts)) == 60
    together = "".join(texts)
    for kind in ("MoveAbsJ", "MoveJ", "MoveL", "MoveC", "WaitTime", r"\\T:=", "z10", "vmax"):
        assert re.search(kind, together), kind


@pytest.mark.usefixtures("unrefined")
def test_another_program_is_seen_when_it_is_read_back(tmp_path: Path) -> None:
    (tmp_path / "small.mod").write_text(ENDS_WITH_A_WAIT.text)
    (tmp_path / "small.yaml").write_text(ENDS_WITH_A_WAIT.cell)
    job = read_job(tmp_path / "small.mod")
    answer = optimize_job(job, Target.STREAM, tmp_path / "results", lambda *_: None, jobs=1)
    assert isinstance(answer, OptimizedJob)
    plan = answer.judged[Target.RAPID].plan
    assert [motion.binding for motion in plan.motions[-2:]] == ["settling", "programmed duration"]
    check_same_motions(job, plan, job.program)
    for old, new, said in (
        ("33.836", "33.840", "another place"),
        ("0.286510365", "0.286610365", "another orientation"),
        ("MoveJ", "MoveL", "MoveJ became MoveL"),
        ("WaitTime 0.2;", "", "3 motions became 1"),
        ("WaitTime 0.2", "WaitTime 0.3", "wait"),
    ):
        (tmp_path / "other.mod").write_text(ENDS_WITH_A_WAIT.text.replace(old, new))
        (tmp_path / "other.yaml").write_text(ENDS_WITH_A_WAIT.cell)
        other = read_job(tmp_path / "other.mod").program
        with pytest.raises(AssertionError, match=said):
            check_same_motions(job, plan, other)
