"""Cycles of loops that never end: they begin where they end, wherever that is best."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from small_cells import DATA, plant_with_rail

from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import Program, TextFile
from trajopt_cli.plan import check_feasible, optimize, slow_plan
from trajopt_cli.problem.configurations import at_cycle
from trajopt_cli.problem.decision_scope import AS_WRITTEN, EVERYTHING, FIXED_RAIL, Freedom
from trajopt_cli.problem.editable import everything
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scenario import Scenario
from trajopt_cli.timing.double_integrator import trapezoid_time

EAX = ",9E9,9E9,9E9,9E9,9E9]];"
HOME = "MoveAbsJ j_home, v1000, fine, tool0;"


def loop(body: str, data: str = DATA, passes: int | None = None) -> tuple[Program, Plant]:
    """A loop behind a move home, on the plant with a rail, which begins where the cycle does as written."""
    lines = ["MODULE T", data.replace("\n", " "), "PROC main()", "ConfL\\Off; ConfJ\\Off;", HOME, "WHILE TRUE DO", body]
    program = run_program(
        [TextFile("t.mod", "\n".join([*lines, "ENDWHILE", "ENDPROC", "ENDMODULE"]), "utf-8")],
        Scenario(endless_passes=passes),
    )
    return program, at_cycle(program, plant_with_rail())


def planned(program: Program, plant: Plant, target: Target, freedom=EVERYTHING) -> Plan:  # type: ignore[no-untyped-def]
    plan = optimize(program, plant, target, freedom)
    assert isinstance(plan, Plan)
    q = plan.trajectory.q
    assert np.abs(q[-1] - q[0]).max() <= 1e-9
    report = verify(program, plant, plan.trajectory, target=target, advice=False)
    assert report.legal, report.worst
    assert plan.lower_bound is not None
    assert plan.lower_bound <= plan.duration * (1 + 1e-9)
    return plan


@pytest.mark.parametrize("target", Target)
def test_between_joint_targets_the_rail_alone_takes_the_cycle(target: Target) -> None:
    """There and back at 1 m/s and 3 m/s2; where the cell begins does not matter."""
    data = "".join(f"CONST jointtarget j_{n}:=[[0,0,0,0,30,0],[{n}00{EAX}\n" for n in (2, 17)) + DATA
    program, plant = loop("MoveAbsJ j_2, v5000, fine, tool0;\nMoveAbsJ j_17, v5000, fine, tool0;", data)
    assert plant.start[0] == 1.7
    plan = planned(program, plant, target)
    assert plan.duration == pytest.approx(2 * float(trapezoid_time(1.5, 1.0, 3.0)), rel=1e-6)


@pytest.mark.long
@pytest.mark.parametrize(("target", "most"), [(Target.STREAM, 1.003), (Target.RAPID, 1.02)])
def test_the_rail_of_the_last_point_is_that_of_the_first(target: Target, most: float) -> None:
    """Down and up a line of 60 mm at 100 mm/s: as written the rail comes along 0.1 m each time. In steady state it
    stands where the arm is not in the way, so the tool's speed alone decides; one pass from home would begin with the
    way there."""
    data = DATA.replace(
        f"p_in:=[[500,600,450],[0,0,1,0],[0,0,0,0],[600{EAX}", f"p_in:=[[500,600,450],[0,0,1,0],[0,0,0,0],[700{EAX}"
    )
    program, plant = loop("MoveL p_low, v100, fine, tool0;\nMoveL p_in, v100, fine, tool0;", data)
    least = 2 * float(trapezoid_time(0.06, 0.1, 20.0))
    plan = planned(program, plant, target)
    assert least <= plan.duration * (1 + 1e-9) <= most * least * (1 + 1e-9)
    assert plan.lower_bound == pytest.approx(least, rel=1e-6)
    assert np.ptp(plan.trajectory.q[:, 0]) < 0.1
    written = planned(program, plant, target, AS_WRITTEN)
    assert written.trajectory.q[0] == pytest.approx(plant.start)
    assert plant.start[0] == pytest.approx(0.7)
    assert written.duration > plan.duration
    station = planned(program, plant, target, FIXED_RAIL)
    assert np.ptp(station.trajectory.q[:, 0]) < 1e-9


@pytest.mark.long
def test_a_long_cycle_is_closed_in_windows_as_well() -> None:
    """Four points along the rail; searched and solved in windows of two legs it hardly takes longer."""
    points = [(500, y, 450 - 40 * (k % 2)) for k, y in enumerate((300, 800, 1200, 600))]
    data = DATA + "".join(
        f"CONST robtarget p_{k}:=[[{x},{y},{z}],[0,0,1,0],[0,0,0,0],[{y}{EAX}\n" for k, (x, y, z) in enumerate(points)
    )
    program, plant = loop("\n".join(f"MoveJ p_{k}, v2000, fine, tool0;" for k in range(4)), data)
    whole = planned(program, plant, Target.STREAM)
    few = replace(plant.settings, searched_legs=2, overlapping_legs=1, window_legs=2, window_overlap=2, few_legs=2)
    parts = planned(program, replace(plant, settings=few), Target.STREAM)
    assert parts.duration <= 1.03 * whole.duration
    assert whole.duration <= 1.03 * parts.duration


def test_a_cycle_that_ends_elsewhere_than_it_begins_is_illegal() -> None:
    program, plant = loop("MoveL p_low, v100, fine, tool0;\nMoveL p_in, v100, fine, tool0;")
    once = replace(program, before=None, passes=0)
    plan = optimize(once, replace(plant, start=np.r_[0.9, plant.start[1:]]), Target.STREAM, bounded=False)
    assert isinstance(plan, Plan)
    q = plan.trajectory.q
    off = {one.check for one in verify(program, plant, plan.trajectory, advice=False).findings if not one.passed}
    assert np.abs(q[-1] - q[0]).max() > 1e-3
    assert "start" in off


def test_the_plain_plan_of_a_cycle_ends_where_it_begins() -> None:
    program, plant = loop("MoveJ p_low, v1000, fine, tool0;\nWaitTime 0.2;\nMoveL p_in, v100, fine, tool0;")
    plan = slow_plan(program, plant, Target.RAPID, everything(program, plant), "a test")
    assert plan is not None
    assert np.abs(plan.trajectory.q[-1] - plan.trajectory.q[0]).max() <= 1e-9
    assert verify(program, plant, plan.trajectory, target=Target.RAPID, advice=False).legal


@pytest.mark.parametrize("freedom", [AS_WRITTEN, EVERYTHING], ids=["as written", "free"])
@pytest.mark.parametrize(
    ("last", "rail"),
    [
        ("MoveJ p_far, v1000, fine, tool0;", 600),
        ("MoveL p_far, v1000, fine, tool0;", 600),
        ("MoveC Offs(p_low,90,0,0), p_far, v1000, fine, tool0;", 600),
        ("MoveJ p_far, v1000, z10, tool0;", 600),
        ("MoveL p_far, v1000, fine, tool0; WaitTime 1;", 600),
        ("n:=1-n; IF n=0 MoveL p_far, v1000, fine, tool0;", 600),
        ("MoveAbsJ j_out, v1000, fine, tool0;", 600),
        ("MoveAbsJ j_off, v1000, fine, tool0;", 600),
        ("MoveJ p_in, v1000, fine, tool0;", 6000),
        ("MoveL p_in, v1000, z10, tool0;", 6000),
        ("n:=1-n; IF n=0 MoveJ p_in, v1000, fine, tool0;", 6000),
    ],
)
def test_a_last_place_that_cannot_be_is_told_as_without_the_loop(last: str, rail: int, freedom: Freedom) -> None:
    """The same motion, the same reason: once through the loop's text tells which. Where rails may move a place off the
    stroke is none."""
    data = f"""{DATA.replace("[600,", f"[{rail},", 1)}
    CONST robtarget p_far:=[[500,6600,450],[0,0,1,0],[0,0,0,0],[600{EAX}
    CONST jointtarget j_out:=[[400,0,0,0,30,0],[0{EAX} CONST jointtarget j_off:=[[0,0,0,0,30,0],[-9000{EAX}
    VAR num n;"""
    first = "MoveJ p_low, v1000, fine, tool0;"
    passes = 2 if "n=0" in last else 1
    program, plant = loop(f"{first}\n{last}", data, passes)
    body = "\n".join([first, last])
    lines = ["MODULE T", data.replace("\n", " "), "PROC main()", "ConfL\\Off; ConfJ\\Off;", HOME,
             f"FOR i FROM 1 TO {passes} DO", body, "ENDFOR", "ENDPROC", "ENDMODULE"]  # fmt: skip
    once = run_program([TextFile("t.mod", "\n".join(lines), "utf-8")])
    wanted, found = (
        check_feasible(one, where, Target.RAPID, freedom)
        for one, where in ((once, plant_with_rail()), (program, plant))
    )
    if freedom is EVERYTHING and rail > 600:
        assert found is wanted is None
        return
    assert isinstance(wanted, Infeasible)
    assert isinstance(found, Infeasible)
    assert (str(found), found.source.line) == (str(wanted), 8)
    assert optimize(program, plant, Target.RAPID, freedom) == found
