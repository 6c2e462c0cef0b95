"""Arcs that no circle makes are named before any work, also where only the robot knows their start."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from some_motions import RAIL, move_abs_j, move_c, move_ext_j, move_j, move_l, plant, program, wait

from trajopt_cli.geometry import Array, pose
from trajopt_cli.motion import Motion, Tool
from trajopt_cli.problem.plannable import refusals

DOWN = np.diag([-1.0, 1, -1])


def X(*p: float) -> Array:
    return pose(DOWN, np.array(p) / 1e3)


def arc(via: tuple[float, ...], end: tuple[float, ...], **more: object) -> Motion:
    return replace(move_c(X(*end), target="p2", **more), X_WV=X(*via))


def said(*motions: Motion, cell: str | None = None) -> list[str]:
    found = refusals(program(*motions), plant(cell) if cell else plant())
    return [f"{one.source.line}: {one.message.split('; ')[0]}" for one in found if one.kind == "no circle"]


START = move_l(X(500, 0, 500))


@pytest.mark.parametrize(
    ("via", "end", "wrong"),
    [
        (
            (500, 50, 500),
            (500, 90, 500),
            "[500.000, 0.000, 500.000], [500.000, 50.000, 500.000], [500.000, 90.000, 500.000]",
        ),
        (
            (500, 90, 500),
            (500, 50, 500),
            "[500.000, 0.000, 500.000], [500.000, 90.000, 500.000], [500.000, 50.000, 500.000]",
        ),
    ],
)
def test_three_points_on_a_line(via: tuple[float, ...], end: tuple[float, ...], wrong: str) -> None:
    assert said(START, arc(via, end)) == [
        f"2: MoveC p2 has no circle: start, point on the way and end {wrong} mm lie on one line"
    ]


@pytest.mark.parametrize(
    ("via", "end", "pair"),
    [
        ((500, 0, 500.05), (500, 90, 500), "start and point on the way"),
        ((500, 50, 550), (500, 0.05, 500), "start and end"),
        ((500, 90, 500.05), (500, 90, 500), "point on the way and end"),
    ],
)
def test_two_points_in_one_place(via: tuple[float, ...], end: tuple[float, ...], pair: str) -> None:
    assert said(START, arc(via, end)) == [f"2: MoveC p2 has no circle: {pair} are 0.05 mm apart, least 0.1 mm"]


def test_a_full_circle_of_two_arcs_is_none_of_them() -> None:
    """And neither are three quarters of one in one arc, nor one just large enough."""
    around = arc((500, 50, 550), (500, 100, 500)), arc((500, 50, 450), (500, 0, 500))
    assert said(START, *around) == []
    assert said(START, arc((500, 100, 500), (500, 50, 450))) == []
    assert said(START, arc((500, 0.11, 500.11), (500, 0, 500.22))) == []


def test_a_start_that_only_the_robot_knows_counts_too() -> None:
    """Behind joints, behind the cycle's start, and behind external axes that carry the arm along, waits between."""
    q = np.radians([0, 0, 0, 0, 90, 0])  # the flange at [450, 0, 647]
    assert said(move_abs_j(q), wait(), arc((450, 50, 647), (450, 90, 647)))
    assert said(move_abs_j(q), arc((450, 50, 650), (450, 90, 647))) == []
    at_start = plant().robot.forward(plant().start)[:3, 3] * 1e3
    assert said(arc(tuple(at_start + np.array([0, 0.05, 0])), (450, 90, 647)))
    rail = {"extax": (None, 300.0, None, None, None, None)}
    home = move_abs_j(q, extax=(None, 0.0, None, None, None, None))
    carried = (home, move_ext_j(**rail), arc((500, 350, 647), (540, 390, 647), **rail))
    assert said(*carried, cell=RAIL)
    assert said(carried[0], arc((450, 350, 647), (450, 390, 647.5)), cell=RAIL) == []


def test_points_on_work_that_is_carried_to_the_tool_count_there() -> None:
    """The work turns on the way, so that the points are on a line over the work and on none in the world."""
    X_WS, ends = X(700, 0, 600), []
    for p in ((0, 0, 0), (50, 0, 0), (90, 0, 0)):
        turned = pose(np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1.0]]) if p[0] else np.eye(3), np.array(p) / 1e3)
        ends.append(turned)
    first, via, end = ends
    tools = [Tool("tGlue", one, stationary=True) for one in (first, end)]
    X_WV = X_WS @ np.linalg.inv(via) @ end
    motions = (
        move_j(X_WS, tool=tools[0]),
        replace(move_c(X_WS, target="p2", tool=tools[1]), X_WV=X_WV),
    )
    assert said(*motions)
    bent = via.copy()
    bent[1, 3] += 0.01
    motions = (motions[0], replace(motions[1], X_WV=X_WS @ np.linalg.inv(bent) @ end))
    assert said(*motions) == []


def test_planning_refuses_them_with_their_place() -> None:
    found = refusals(program(START, arc((500, 50, 500), (500, 90, 500))), plant())
    (one,) = [refusal for refusal in found if refusal.kind == "no circle"]
    assert str(one.source) == "m.mod:2:5"
    assert one.message == (
        "MoveC p2 has no circle: start, point on the way and end [500.000, 0.000, 500.000], [500.000, 50.000, 500.000],"
        " [500.000, 90.000, 500.000] mm lie on one line; move the point on the way, or use MoveL"
    )
