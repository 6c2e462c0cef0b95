"""The levers of a program on its cell: what each changes, and nothing else; what is no lever is told."""

from __future__ import annotations

from collections import Counter
from dataclasses import fields, replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from timed_rows import PROGRAMS, plant_with_rail, rapid

from trajopt_cli.job import Job, read_job
from trajopt_cli.motion import Program
from trajopt_cli.problem.plant import Plant
from trajopt_cli.study.levers import EACH, Lever, LeverKind, levers, not_asked, places

STATION = """MoveJ p_in, v2500, fine, tGrip;
MoveL p_low, v200, fine, tGrip;
WaitTime 0.4;
MoveL p_in, v200\\T:=0.6, fine, tGrip;
"""


@cache
def job(name: str) -> Job:
    return read_job(Path(PROGRAMS) / f"{name}.mod")


def lever(name: str, program: Program, plant: Plant) -> Lever:
    (found,) = [one for one in levers(program, plant) if one.name == name]
    return found


def changed(program: Program, plant: Plant, one: Lever, share: float = 1.0) -> tuple[dict[str, object], list[int]]:
    """The fields of the plant and the motions that a lever makes anew."""
    after, machine = one.change(share)
    own = {field.name: getattr(machine, field.name) for field in fields(machine)
           if getattr(machine, field.name) is not getattr(plant, field.name)}  # fmt: skip
    pairs = zip(program.motions, after.motions, strict=True)
    return own, [i for i, (a, b) in enumerate(pairs) if a is not b]


def test_the_hinge_cell_has_these_levers() -> None:
    one = job("hinge_cell")
    found = levers(one.program, one.plant)
    assert len({lever.name for lever in found}) == len(found)
    assert Counter(lever.kind for lever in found) == {
        LeverKind.SPEED: 7, LeverKind.ACCELERATION: 7, LeverKind.STROKE: 2, LeverKind.TOOL: 2, LeverKind.WAIT: 3,
        LeverKind.PROGRAMMED: 10, LeverKind.PLACE: 18,
    }  # fmt: skip
    tight = {LeverKind.WAIT, LeverKind.TIME, LeverKind.PLACE}
    assert all(lever.loosens == (lever.kind not in tight) for lever in found)


def test_a_limit_is_raised_by_a_tenth_and_nothing_else() -> None:
    one = job("hinge_cell")
    fast = lever("joint_2 speed", one.program, one.plant)
    own, motions = changed(one.program, one.plant, fast, 0.5)
    assert (list(own), motions) == (["limits"], [])
    ratio = own["limits"].velocity / one.plant.limits.velocity  # type: ignore[attr-defined]
    assert ratio == pytest.approx([1, 1, 1.05, 1, 1, 1, 1])
    assert (fast.now, fast.then) == pytest.approx((3.4907, 3.8397), abs=1e-4)


def test_either_end_of_the_rail_moves_outwards_by_a_tenth_of_the_stroke() -> None:
    one = job("hinge_cell")  # -0.2 to 2.2 m
    for end, column, value in (("lower", "lower", -0.44), ("upper", "upper", 2.44)):
        found = lever(f"rail stroke, {end} end", one.program, one.plant)
        own, _ = changed(one.program, one.plant, found)
        assert getattr(own["limits"], column)[0] == pytest.approx(value)
        assert found.then == pytest.approx(value)
    fixed = replace(one.plant, rail_fixed=True)
    assert not [found for found in levers(one.program, fixed) if found.kind is LeverKind.STROKE]
    assert "rail stroke: the cell file fixes the rail where the program has it (rail.fixed)" in not_asked(
        one.program, fixed
    )


def test_speeds_waits_and_times_are_those_of_their_line() -> None:
    program, plant = rapid(STATION), plant_with_rail()
    speed = lever("v200 of MoveL p_low at t.mod:5", program, plant)
    after, _ = speed.change(1.0)
    assert changed(program, plant, speed) == ({}, [1])
    assert (after.motions[1].speed.v_tcp, after.motions[1].speed.v_ori) == pytest.approx(  # type: ignore[union-attr]
        (0.22, 1.1 * program.motions[1].speed.v_ori)  # type: ignore[union-attr]
    )
    for name, index, wanted in (("wait at t.mod:6", 2, 0.36), ("\\T of MoveL p_in at t.mod:7", 3, 0.54)):
        shorter = lever(name, program, plant)
        assert changed(program, plant, shorter) == ({}, [index])
        assert shorter.change(1.0)[0].motions[index].duration == pytest.approx(wanted)  # type: ignore[union-attr]
    assert not [one for one in levers(program, plant) if "v200 of MoveL p_in" in one.name]  # its time stands for it
    settling = rapid(STATION, settle=0.1)  # which is nobody's line to shorten
    assert [one.name for one in levers(settling, plant)] == [one.name for one in levers(program, plant)]


def test_a_line_that_runs_often_is_one_lever_and_many_lines_are_asked_together() -> None:
    program, plant = (
        rapid("FOR i FROM 1 TO 3 DO\nWaitTime 0.2;\nMoveJ p_in, v100, fine, tGrip;\nENDFOR"),
        plant_with_rail(),
    )
    wait = lever("wait at t.mod:5, 3 passes", program, plant)
    assert (wait.now, wait.then) == pytest.approx((0.6, 0.54))
    many = rapid("WaitTime 0.2;\nMoveJ p_in, v100, fine, tGrip;\n" * (EACH + 1))
    names = [one.name for one in levers(many, plant)]
    assert f"all {EACH + 1} waits" in names
    assert "v100 everywhere" in names


def test_a_place_is_a_work_object_or_what_lines_join_and_shares_a_point() -> None:
    corners = job("corners")
    found = places(corners.program)
    assert [len(at) for at in found.values()] == [10, 2, 6, 10]
    assert list(found) == [
        "place of p_chute and 2 more", "place of p_camera_in", "place of p_camera and 2 more", "work object wTray"
    ]  # fmt: skip
    # of hinge_cell each station's MoveJ and both lines
    assert [len(at) for at in places(job("hinge_cell").program).values()] == [3, 3, 3]
    again = rapid(STATION + "MoveAbsJ j_home, vmax, fine, tGrip;\nMoveJ p_in, v100, fine, tGrip;")
    assert list(places(again).values()) == [[0, 1, 3, 5]]
    # one text, two points
    twice = rapid("FOR i FROM 1 TO 2 DO\nMoveJ Offs(p_in,0,0,40*i), v100, fine, tGrip;\nENDFOR")
    assert list(places(twice).values()) == [[0], [1]]
    assert list(places(twice))[1] == f"{next(iter(places(twice)))} (2)"


def test_a_place_is_moved_as_a_whole_and_an_arc_with_the_point_it_goes_through() -> None:
    program = rapid("MoveJ p_in, v500, fine, tGrip;\nMoveC Offs(p_in,40,40,0), Offs(p_in,0,80,0), v300, fine, tGrip;")
    plant = plant_with_rail()
    ways = [one for one in levers(program, plant) if one.kind is LeverKind.PLACE]
    assert [one.name[-2:] for one in ways] == ["+x", "−x", "+y", "−y", "+z", "−z"]
    down, _ = ways[5].change(0.5)
    for before, after in zip(program.motions, down.motions, strict=True):
        for name in ("X_WT", "X_WV"):
            if hasattr(before, name):
                moved = getattr(after, name) - getattr(before, name)
                assert moved[:3, 3] == pytest.approx([0, 0, -0.005])
                assert not np.any(moved[:, :3])


def test_what_obstacles_are_to_it_is_told_where_there_are_any() -> None:
    fenced, free = job("hinge_cell_fenced"), job("hinge_cell")
    (line,) = [line for line in not_asked(fenced.program, fenced.plant) if line.startswith("obstacles and clearance: ")]
    assert "keeps clear" in line
    assert not any("obstacles" in line for line in not_asked(free.program, free.plant))


def test_what_is_no_lever_is_told() -> None:
    corners = job("corners")
    told = not_asked(corners.program, corners.plant)
    for wanted in ("rail: there is none", "zones: a larger", "places given by joints", "jerk limits"):
        assert any(line.startswith(wanted) for line in told), wanted
    free = replace(corners.plant, free_speed=True)
    assert any("free_speed" in line for line in not_asked(corners.program, free))
    names = [one.name for one in levers(corners.program, free)]
    assert not any("MoveJ" in name for name in names)
