"""Tools and parts that the flange carries for a while: what the judge makes of them, and the optimiser's own answer."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from legal_motion import A, B, Case, bench_case, home, plant_without_rail, program, rapid_case

from trajopt_cli.findings import Report, collisions
from trajopt_cli.geometry import Array, pose
from trajopt_cli.judge.clearance import check_clearance
from trajopt_cli.judge.continuous_collision import OVERLOOKED
from trajopt_cli.judge.scene import legs_of
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import Happens, MoveAbsJ, MoveJ, MoveL, PathEvent, Program, SignalEvent, Tool
from trajopt_cli.problem.collision_objects import bodies_on
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.shapes import Box, Capsule, Cue, Grip, Shape, Solid
from trajopt_cli.trajectory import Trajectory

TAKE, LEAVE = Cue(line=13), Cue(line=17)  # the waits at A and at B
CUBE = Solid(Box("cube", np.full(3, 0.06), pose(np.eye(3), [0.5, 0.1, 0.31])))  # its top 30 mm under the flange at A
TABLE = Solid(Box("table", np.array([0.2, 0.2, 0.04]), pose(np.eye(3), [0.5, 0.1, 0.26])))  # the cube stands on it
AT_B = B @ np.linalg.inv(A) @ CUBE.shape.X


def box(name: str, size: list[float], centre: list[float], *ignore: str) -> Solid:
    return Solid(Box(name, np.array(size), pose(np.eye(3), centre)), frozenset(ignore))


def judged(plant: Plant, case: Case, motions: Program | None = None) -> Report:
    return verify(motions or case.program, plant, case.rows(), target=Target.RAPID, advice=False)


def carrying(*obstacles: Solid, at: Cue = TAKE, detach: Cue | None = LEAVE, **more: object) -> Plant:
    return replace(rapid_case().plant, obstacles=(CUBE, *obstacles), grips=(Grip("cube", at, detach),), **more)


def failed(report: Report) -> list[str]:
    return [found.message for found in report.findings if not found.passed]


# ------------------------------------------------------------------------------------------------------------- tools


def test_a_tcp_inside_a_column_is_a_hit_of_the_tool() -> None:
    """bench_case brings a TCP 102 mm from the flange to B; a column's top is 26 mm over it, its axis through it."""
    case = bench_case()
    column = box("column", [0.04, 0.04, 0.3], [*B[:2, 3], B[2, 3] + 0.026 - 0.15])
    tall = replace(case.plant, obstacles=(column,), tool_radius=0.025)
    (found,) = (f for f in judged(tall, case).findings if not f.passed)
    assert found.source is not None
    assert found.source.line == 12
    assert "cell.mod:12:5: MoveL p_low hits 'column' with tool at " in found.message
    assert found.message.endswith(
        " (a capsule of 25 mm from flange to TCP stands for the tool: give its bodies under attached, or another "
        "tool_radius)"
    )
    assert judged(replace(tall, tool_radius=0.0), case).legal


def test_touching_with_the_tcp_is_no_hit() -> None:
    """The tool's tip is at the TCP, which comes down to the table's top at B."""
    case = bench_case()
    slab = box("slab", [0.3, 0.3, 0.1], [*B[:2, 3], B[2, 3] - 0.05])
    report = judged(replace(case.plant, obstacles=(slab,), tool_radius=0.025), case)
    (found,) = (f for f in report.findings if f.check == "clearance")
    assert found.value > -0.006  # the tool leans by the way from flange to TCP: its round tip is lower by r (1 - cos)
    X_FT = np.asarray(case.program.motions[0].tool.X_FT)
    lean = X_FT[2, 3] / np.linalg.norm(X_FT[:3, 3])
    assert found.value == pytest.approx(0.025 * lean - 0.025, abs=OVERLOOKED)


def test_each_motion_has_the_capsule_of_its_own_tool() -> None:
    """A wall stands where only the long tool would reach it, and the long tool is used somewhere else."""
    case = rapid_case()
    long = Tool("long", pose(np.eye(3), [0, 0, 0.2]))

    def with_tool(*lines: int) -> Program:
        """The same motions of the flange, on some lines by another tool."""
        moves = [replace(m, tool=long, X_WT=m.X_WT @ long.X_FT) if m.source.line in lines else m
                 for m in case.program.motions]  # fmt: skip
        return replace(case.program, motions=tuple(moves))

    plate = box("plate", [0.1, 0.1, 0.02], [0.5, 0.1, 0.37 - 0.15])  # under A
    plant = replace(case.plant, obstacles=(plate,), tool_radius=0.025)
    hits = [[f.message for f in collisions(judged(plant, case, with_tool(*lines)).findings)]
            for lines in ((11, 15), (12,), ())]  # fmt: skip
    assert (hits[0], hits[2]) == ([], [])  # at A_IN its tip is 20 mm over it
    (said,) = hits[1]
    assert "MoveL p_a hits 'plate' with tool" in said


def test_the_tool_is_held_against_the_robots_own_links() -> None:
    plant = replace(plant_without_rail(), tool_radius=0.025)
    behind = Tool("bent", pose(np.eye(3), [-0.3, 0, -0.6]))
    motions = program(replace(home(11, None), tool=behind))
    q = np.tile(plant.start, (2, 1))
    (found,) = check_clearance(motions, plant, Trajectory(plant.limits.names, np.array([0, 1.0]), q), lambda _: None)
    assert not found.passed
    assert "tool" in found.subject


# ------------------------------------------------------------------------------------------------------------- parts


def test_a_part_moves_with_the_flange_and_stands_where_it_was_released() -> None:
    case, plant = rapid_case(), carrying(TABLE, clearance=0.01)
    assert failed(judged(plant, case)) == []  # lifted off its table, closer than 10 mm
    gate = box("gate", [0.02, 0.02, 0.02], [0.5, 0.2, 0.36])  # beneath the way from A_IN to B_IN, as the cube goes
    (said,) = failed(judged(carrying(gate), case))
    assert said.startswith("cell.mod:15:5: MoveJ p_b_in hits 'gate' with cube at ")
    assert judged(replace(plant, obstacles=(CUBE, gate), grips=()), case).legal
    shelf = box("shelf", [0.2, 0.2, 0.02], [*AT_B[:2, 3], AT_B[2, 3] - 0.04 + 0.005])  # 5 mm into the cube put down
    assert failed(judged(carrying(shelf), case)) == []  # what it stands on, it touches


def test_without_a_detach_it_is_kept_and_hits_what_is_on_the_way_home() -> None:
    case = rapid_case()
    start = case.plant.robot.forward(case.plant.start)
    place = (start @ np.linalg.inv(A) @ CUBE.shape.X)[:3, 3]  # where the cube is at home, if it is carried there
    hook = box("hook", [0.01, 0.01, 0.01], place.tolist(), "link_6", "link_5")
    assert judged(carrying(hook), case).legal
    (said,) = failed(judged(carrying(hook, detach=None), case))
    assert "cell.mod:18:5: MoveAbsJ j_home hits 'hook' with cube" in said


def test_the_gripper_may_touch_the_part_where_it_takes_it_and_not_before() -> None:
    case = rapid_case()
    fingers = Solid(Capsule("fingers", np.zeros(3), np.array([0, 0, 0.06]), 0.01))  # 40 mm into the cube at A
    assert failed(judged(carrying(attached=(fingers,)), case)) == []
    (said,) = failed(judged(carrying(attached=(fingers,), at=Cue(line=16)), case))
    assert said.startswith("cell.mod:12:5: MoveL p_a hits 'cube' with fingers at ")


def programs() -> dict[str, tuple[Program, Grip]]:
    """One course of the flange, and how a program may say when the cube is taken and put down."""
    plain = rapid_case().program
    event = SignalEvent(source=plain.motions[2].source, written=plain.motions[2].written, signal="doGrip", value=1.0)
    outputs = [*plain.motions[:3], event, *plain.motions[3:7], replace(event, value=0.0), plain.motions[7]]
    sync = PathEvent(Happens.SIGNAL, "dogrip", 1.0)
    on_path = [*plain.motions[:1], replace(plain.motions[1], events=(sync,)), *plain.motions[2:]]
    on = Cue(signal="dogrip", value=1.0)
    return {
        "lines": (plain, Grip("cube", Cue(line=13), Cue("cell.mod", 17))),
        "moves": (plain, Grip("cube", Cue(line=12), Cue(line=16))),
        "outputs": (replace(plain, motions=tuple(outputs)), Grip("cube", on, Cue(signal="dogrip", value=0.0))),
        "event": (replace(plain, motions=tuple(on_path)), Grip("cube", on, Cue(line=16))),
    }


def place(solids: tuple[Solid, ...]) -> dict[str, tuple[Array, frozenset[str]]]:
    def numbers(shape: Shape) -> Array:
        return np.r_[shape.a, shape.b] if isinstance(shape, Capsule) else np.asarray(shape.X).ravel()

    return {solid.name: (numbers(solid.shape), solid.ignore) for solid in solids}


def visits_of(plant: Plant, motions: Program) -> list[SimpleNamespace]:
    """Start and points as if a file had a row for each."""
    moves = [m for m in motions.motions if isinstance(m, MoveAbsJ | MoveJ | MoveL)]
    out = [SimpleNamespace(point=SimpleNamespace(index=-1), depart=0, X_WF=plant.robot.forward(plant.start))]
    for row, move in enumerate(moves, 1):
        X = plant.robot.forward(plant.start) if isinstance(move, MoveAbsJ) else move.X_WT
        out.append(SimpleNamespace(point=SimpleNamespace(index=motions.motions.index(move)), depart=row, X_WF=X))
    return out


@pytest.mark.parametrize("how", programs())
def test_judge_and_optimiser_have_the_same_bodies_on_every_motion(how: str) -> None:
    """Written twice, held against each other, and against the closed form of where the cube is put down."""
    motions, grip = programs()[how]
    shelf = box("shelf", [0.2, 0.2, 0.02], [*AT_B[:2, 3], AT_B[2, 3] - 0.04])
    grippers = (Solid(Capsule("fingers", np.zeros(3), np.array([0, 0, 0.06]), 0.01)),)
    plant = carrying(TABLE, shelf, attached=grippers, clearance=0.002)
    plant = replace(plant, grips=(grip,))
    visits = visits_of(plant, motions)
    legs = legs_of(motions, plant, visits, len(visits))
    for visit, leg in zip(visits, legs, strict=False):
        ours = bodies_on(plant, motions, visit.point.index)
        for mine, theirs in ((ours.carried, leg.carried), (ours.standing, leg.standing)):
            wanted, found = place(theirs), place(mine)
            assert wanted.keys() == found.keys()
            for name, (numbers, ignore) in wanted.items():
                np.testing.assert_allclose(found[name][0], numbers, atol=1e-12)
                assert found[name][1] == ignore, (name, visit.point.index)
    where = [("cube" in place(leg.carried), "cube" in place(leg.standing)) for leg in legs[:7]]
    assert where == [(False, True)] * 3 + [(True, False)] * 3 + [(False, True)]
    lift, drive, down_, away = (place(legs[i].standing) for i in (3, 4, 5, 6))
    assert "cube" in lift["table"][1]
    assert "cube" not in drive["table"][1] | drive["shelf"][1]
    assert "cube" in down_["shelf"][1]
    assert away["cube"][1] >= {"fingers"}
    np.testing.assert_allclose(away["cube"][0].reshape(4, 4), AT_B, atol=1e-12)


def test_a_point_that_is_added_before_a_move_takes_nothing() -> None:
    """It has the line of its move; the part is taken where the move itself ends."""
    plain = rapid_case().program
    first, line, *rest = plain.motions
    point = replace(first, source=line.source, X_WT=B, detour=("column",))
    motions = replace(plain, motions=(first, point, line, *rest))
    plant = carrying(at=Cue(line=12))
    held = place(bodies_on(plant, motions, 3).carried)["cube"][0].reshape(4, 4)
    np.testing.assert_allclose(held, np.linalg.inv(A) @ CUBE.shape.X, atol=1e-12)
    assert "cube" not in place(bodies_on(plant, motions, 2).carried)
    legs = legs_of(motions, plant, visits_of(plant, motions), 9)
    where = ["cube" in place(leg.carried) for leg in legs[:5]]
    assert where == [False, False, False, False, True]
    np.testing.assert_allclose(place(legs[4].carried)["cube"][0].reshape(4, 4), held, atol=1e-12)


def test_a_line_that_runs_again_takes_the_next_part_from_the_same_place() -> None:
    twice = program(*(replace(m, target=f"{m.target}{k}") if hasattr(m, "target") else m
                      for k in (1, 2) for m in rapid_case().program.motions[:7]))  # fmt: skip
    plant = carrying()
    first, second = (place(bodies_on(plant, twice, i).carried)["cube"][0] for i in (3, 10))
    np.testing.assert_allclose(first, second, atol=1e-12)
    between = place(bodies_on(plant, twice, 8).standing)["cube"][0]
    np.testing.assert_allclose(between.reshape(4, 4), AT_B, atol=1e-12)
    legs = legs_of(twice, plant, visits_of(plant, twice), 9)
    first, second = (place(legs[k].carried)["cube"][0] for k in (3, 8))
    np.testing.assert_allclose(first, second, atol=1e-12)
    np.testing.assert_allclose(place(legs[6].standing)["cube"][0].reshape(4, 4), AT_B, atol=1e-12)
    assert bodies_on(plant, twice, 3) is bodies_on(plant, twice, 3)
