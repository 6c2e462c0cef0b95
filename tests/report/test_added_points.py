"""Points that a plan adds on a way around obstacles, as pictures and pages show them."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from matplotlib.axes import Axes
from small_cells import plant_with_rail, rapid

from trajopt_cli.geometry import Array
from trajopt_cli.judge.mechanism import mechanism_of
from trajopt_cli.motion import Program
from trajopt_cli.page.cell import program_section
from trajopt_cli.page.cycles import Shown, cycle_data, reach_data
from trajopt_cli.plan import optimize
from trajopt_cli.problem.detours import Detour, Numbering, Via, folded, with_detours
from trajopt_cli.problem.editable import everything
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.report import in_space, over_time, style
from trajopt_cli.scene import program_points
from trajopt_cli.trajectories.plan_series import PlanSeries, follow

PLANT = plant_with_rail()
ONE = np.r_[0.25, 0.6, -0.4, -0.3, 0.4, 0.9, -0.5]
TWO = np.r_[0.4, 0.9, -0.2, -0.4, -0.3, 1.1, 0.2]
DETOURS = (Detour(0, (Via(ONE, 0.1), Via(TWO)), ("column",)), Detour(2, (Via(ONE),), ("column", "fence")))


@cache
def planned() -> tuple[Program, Plan]:
    program = rapid("MoveJ p_in,v1000,fine,tool0;\nMoveL p_low,v500,fine,tool0;\nMoveAbsJ j_home,v1000,fine,tool0;")
    there = with_detours(program, PLANT, DETOURS)
    changes = Numbering(3, DETOURS).changes(everything(program, PLANT))
    plan = optimize(there, PLANT, Target.RAPID, bounded=False, changes=changes)
    assert isinstance(plan, Plan), plan
    return program, folded(plan, program, DETOURS)


@cache
def series() -> PlanSeries:
    return follow(*planned()[:1], PLANT, planned()[1], "around")


def tool_at(q: Array) -> Array:
    return np.asarray(mechanism_of(PLANT).flange_pose(q)[:3, 3])  # the judge's own kinematics


def test_the_points_are_on_the_course() -> None:
    assert [leg.name for leg in series().legs] == ["pVia_10", "pVia_20", "p_in", "p_low", "jVia_30", "j_home"]
    assert series().added.tolist() == [True, True, False, False, True, False]
    assert series().passed.tolist() == [True, False, False, False, False, False]
    for k, q in ((0, ONE), (1, TWO), (4, ONE)):
        np.testing.assert_allclose(series().points[k], tool_at(q), atol=1e-7)
    assert len(series().corners) == 1


def test_a_point_that_the_program_has_is_its_own_whatever_its_comment_says() -> None:
    data = "CONST jointtarget jVia_10:=[[10,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];"
    body = "MoveAbsJ jVia_10,v1000,fine,tool0; ! trajopt: way around 'column'\nMoveAbsJ j_home,v1000,fine,tool0;"
    program = rapid(body, data=data)
    plan = optimize(program, PLANT, Target.RAPID, bounded=False)
    assert isinstance(plan, Plan)
    assert not follow(program, PLANT, plan, "its own").added.any()
    assert cycle_data(PLANT, Shown("rapid plan", program, plan), 0)["legs"]["index"] == [0, 1]


def test_pictures_mark_them_unlike_the_programs_own() -> None:
    with style.house_style():
        figure = in_space.path(series())
        over_time.tcp_speed(series())
    marked = {}
    for axes in figure.axes:
        assert isinstance(axes, Axes)
        for line in axes.lines:
            if line.get_marker() == "D":
                where = np.column_stack(line.get_data()) * 1e-3
                marked.setdefault(axes.get_title(loc="left"), []).append((line.get_markerfacecolor(), where))
    side = next(found for title, found in marked.items() if title.startswith("in the world, side"))
    stops = next(where for face, where in side if face != "white")
    passed = next(where for face, where in side if face == "white")
    (along,) = [i for i in (0, 1) if np.isclose(passed[0, 0], tool_at(ONE)[i])]
    np.testing.assert_allclose(passed, [tool_at(ONE)[[along, 2]]], atol=1e-7)
    np.testing.assert_allclose(stops, [tool_at(TWO)[[along, 2]], tool_at(ONE)[[along, 2]]], atol=1e-7)
    (legend,) = figure.legends
    assert "added on a way around obstacles" in [text.get_text() for text in legend.get_texts()]


def test_a_page_shows_them_as_part_of_their_motion() -> None:
    program, plan = planned()
    shown = Shown("rapid plan", program, plan)
    legs = cycle_data(PLANT, shown, 0)["legs"]
    assert legs["index"] == [0, 1, 2]
    assert legs["from"] == pytest.approx([0.0, plan.motions[0].t_1, plan.motions[1].t_1])
    assert legs["to"] == pytest.approx([one.t_1 for one in plan.motions])
    assert legs["way"] == ["by 2 points around 'column'", "", "by 1 point around 'column', 'fence'"]
    assert legs["points"] == [[pytest.approx(p.t) for p in one.via] for one in plan.motions]
    html = program_section(program, [shown], [0]).html
    assert 'p_in <span class="quiet">by 2 points around &#x27;column&#x27;</span>' in html.replace("&#39;", "&#x27;")
    points = program_points(program, plan, PLANT)
    assert [(one.name, one.added) for one in points] == [
        ("pVia_10", True),
        ("pVia_20", True),
        ("p_in", False),
        ("p_low", False),
        ("jVia_30", True),
        ("j_home", False),
    ]
    np.testing.assert_allclose(points[0].position, tool_at(ONE), atol=1e-6)
    reach = reach_data(PLANT, program, plan)
    assert reach is not None
    assert set(reach["ranges"]) == {0, 1}
