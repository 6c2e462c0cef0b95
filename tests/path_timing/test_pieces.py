"""Pieces that ask for different motions are never taken for one another."""

from __future__ import annotations

from dataclasses import replace

import pytest
from small_cells import plant_without_rail, problem_of, rapid

from trajopt_cli.graph_search.search import search
from trajopt_cli.path_timing.path_parameterized_plan import timed
from trajopt_cli.plan.subproblems import Window
from trajopt_cli.problem.problem import Problem
from trajopt_cli.trajectories.axes import Axes

TO = "MoveJ p_near, v500, fine, tool0;\n"
ARC = TO + "MoveC Offs(p_near,{aside},0,20), Offs(p_near,0,0,40), v500, fine, tool0;"
FLY = TO + "MoveL Offs(p_near,0,0,-40), v500, {zone}, tool0;\nMoveL Offs(p_near,0,40,-40), v500, fine, tool0;"
ACC = "AccSet {share}, 100;\n" + TO
DATA = "CONST robtarget p_near:=[[500,100,450],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];"


def problem(text: str) -> Problem:
    return problem_of(
        rapid(text.replace("p_near", "p_there"), data=DATA.replace("p_near", "p_there")), plant_without_rail()
    )


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (ARC.format(aside=10), ARC.format(aside=15)),
        (FLY.format(zone="z5"), FLY.format(zone="z10")),
        (ACC.format(share=100), ACC.format(share=50)),
    ],
    ids=["arcs about other centres", "zones", "accelerations"],
)
def test_what_makes_another_motion_makes_another_key(one: str, other: str) -> None:
    a, b = problem(one), problem(other)
    route = search(Axes.of(a.plant), a)
    assert route is not None
    iterate, whole = timed(Axes.of(a.plant), a, route), (0, len(a.legs))
    key = Window.of(a, iterate, whole).key()
    assert key == Window.of(replace(problem(one), plant=a.plant), iterate, whole).key()
    assert key != Window.of(b, iterate, whole).key()
