"""What stands in the cell and what the flange carries during each motion."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from some_motions import BENCH, RAIL, move_abs_j, move_j, plant, program, wait

from trajopt_cli.errors import InputError
from trajopt_cli.findings import collisions
from trajopt_cli.job import read_job
from trajopt_cli.judge.clearance import check_start
from trajopt_cli.motion import SignalEvent, Tool
from trajopt_cli.problem.collision_objects import bodies_on
from trajopt_cli.proximity.pair import Pair
from trajopt_cli.shapes import Box, Capsule


def tool(*p_FT: float, stationary: bool = False) -> Tool:
    X_FT = np.eye(4)
    X_FT[:3, 3] = p_FT
    return Tool("t", X_FT, stationary)


def test_the_tool_is_a_capsule_that_ends_at_the_tcp_of_each_motion() -> None:
    robot = plant()
    long, bent = tool(0, 0, 0.2), tool(0.03, 0, 0.04)
    asked = program(
        wait(1.0), move_j(tool=long), wait(1.0), move_j(tool=bent), move_j(tool=tool(0, 0, 0)), move_j(tool=long)
    )
    bodies = [bodies_on(robot, asked, i) for i in range(-1, 6)]
    for one in bodies[:4]:
        assert one is bodies[0]
    (solid,) = bodies[0].carried
    assert isinstance(solid.shape, Capsule)
    assert (solid.name, solid.shape.radius) == ("tool", 0.025)
    np.testing.assert_allclose([solid.shape.a, solid.shape.b], [[0, 0, 0], [0, 0, 0.175]])
    (solid,) = bodies[4].carried
    tip = solid.shape.b + 0.025 * np.array([0.6, 0, 0.8])
    np.testing.assert_allclose(tip, [0.03, 0, 0.04])
    assert bodies[5].carried == ()
    assert bodies[6] is bodies[0]


@pytest.mark.parametrize("tcp", [tool(0, 0.02, 0), tool(0, 0, 0.2, stationary=True)])
def test_no_capsule_for_a_tool_shorter_than_its_radius_nor_for_one_that_stands(tcp: Tool) -> None:
    assert bodies_on(plant(), program(move_j(tool=tcp)), 0).carried == ()


def test_attached_bodies_stand_for_the_tool() -> None:
    robot = plant(BENCH + "attached: {grip: {box: {size: [0.1, 0.1, 0.1]}}}\n")
    assert bodies_on(robot, program(move_j(tool=tool(0, 0, 0.2))), 0).carried == robot.attached
    assert not [pair for pair in robot.self_pairs if "tool" in pair]
    assert ("link_1", "tool") in plant().self_pairs


def test_another_radius_and_none() -> None:
    asked = program(move_j(tool=tool(0, 0, 0.2)))
    (solid,) = bodies_on(plant(BENCH + "tool_radius: 50 mm\n"), asked, 0).carried
    assert solid.shape.radius == 0.05
    assert bodies_on(plant(BENCH + "tool_radius: 0\n"), asked, 0).carried == ()
    assert bodies_on(plant(), program(), -1).carried == ()


PROGRAMS = Path(__file__).parents[2] / "programs"


def test_the_blank_of_the_tended_machine_ends_in_its_chuck() -> None:
    job = read_job(PROGRAMS / "machine_tending.mod")
    motions = job.program.motions
    names = [[solid.name for solid in bodies_on(job.plant, job.program, i).carried] for i in range(len(motions))]
    held = [i for i, carried in enumerate(names) if "blank" in carried]
    first = next(i for i, m in enumerate(motions) if isinstance(m, SignalEvent) and m.value == 1)
    last = next(i for i, m in enumerate(motions) if isinstance(m, SignalEvent) and m.value == 0)
    assert held == list(range(first, last))
    assert all("tool" in carried for carried in names)
    end = {solid.name: solid for solid in bodies_on(job.plant, job.program, len(motions) - 1).standing}
    assert isinstance(end["blank"].shape, Box)
    np.testing.assert_allclose(end["blank"].shape.X[:3, 3], [0.75, 0, 0.48], atol=1e-6)
    here = np.eye(4)
    gap = Pair(end["blank"].shape, end["chuck"].shape).distance(here, here)
    assert gap == pytest.approx(0, abs=1e-6)  # as long as from the jaws to the chuck: it touches, as it may
    setting_down = bodies_on(job.plant, job.program, last - 2).standing
    assert "blank" in next(solid for solid in setting_down if solid.name == "chuck").ignore


@pytest.mark.parametrize("name", ["machine_tending", "hinge_cell_fenced"])
def test_shipped_cells_with_obstacles_let_the_robot_stand_at_its_start(name: str) -> None:
    job = read_job(PROGRAMS / f"{name}.mod")
    assert check_start(job.program, job.plant, "start") != []
    assert collisions(check_start(job.program, job.plant, "start")) == ()


def test_a_cue_that_never_comes_is_refused_with_its_line(tmp_path: Path) -> None:
    for name in ("machine_tending.mod", "machine_tending.yaml"):
        text = (PROGRAMS / name).read_text().replace("doGripper = 0}", "machine_tending.mod:2}")
        (tmp_path / name).write_text(text)
    with pytest.raises(InputError) as caught:
        read_job(tmp_path / "machine_tending.mod")
    assert str(caught.value) == (
        f"{tmp_path}/machine_tending.yaml:18: attach.0.detach: nothing happens at machine_tending.mod:2; give the line "
        "of a move, a wait or an output, or an output's value"
    )


def test_a_part_is_not_taken_where_nobody_knows() -> None:
    rail = RAIL + "obstacles: {cube: {box: {size: [0.1, 0.1, 0.1], position: [0.6, 0, 0.3]}}}\n"
    robot = plant(rail + "attach: [{part: cube, at: 2}]\n")
    asked = program(move_j(tool=tool(0, 0, 0.2)), move_abs_j(), wait(1.0))
    with pytest.raises(InputError, match=r"^m\.mod:2:5: part 'cube' is taken or released where the rail is free"):
        bodies_on(robot, asked, -1)
    assert bodies_on(plant(rail), asked, 2).standing[0].name == "cube"
