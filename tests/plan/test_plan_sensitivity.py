"""A plan solved again with a change: against closed forms, against planning anew, and what it must never do."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from small_cells import plant_with_rail, plant_without_rail, rapid

from trajopt_cli.limits import TcpCaps
from trajopt_cli.motion import MoveJ, MoveL, Program, Wait
from trajopt_cli.nlp.block import express
from trajopt_cli.nlp.mesh_refinement import LONG, MeshRefinement, NotConverged
from trajopt_cli.nlp.nlp_assembly import BlockNlp
from trajopt_cli.plan import optimize
from trajopt_cli.plan.plan_sensitivity import Effect, PlanSensitivity, _SolvedWindow, _TimedRuns
from trajopt_cli.problem.editable import everything
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.settings import DEFAULT

pytestmark = pytest.mark.usefixtures("coarse", "few_places")

Change = Callable[[float], tuple[Program, Plant]]
STATION = """MoveJ Offs(p_in,-80,0,0), v2500, fine, tool0;
MoveL Offs(p_low,-80,0,0), v500, fine, tool0;
WaitTime 0.3;
MoveAbsJ j_home, v2500, fine, tool0;"""
TURN = "MoveAbsJ [[{angle},0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]], vmax, fine, tool0;"


def limit(program: Program, plant: Plant, column: str, axis: int, by: float = 0.1) -> Change:
    """A limit of an axis raised by a share of itself."""

    def change(share: float) -> tuple[Program, Plant]:
        values = getattr(plant.limits, column).copy()
        values[axis] *= 1 + by * share
        return program, replace(plant, limits=replace(plant.limits, **{column: values}))

    return change


def edited(program: Program, plant: Plant, kind: type, **edit: Callable[[float, float], object]) -> Change:
    """Fields of all motions of a kind, made anew from what they are and a share."""

    def change(share: float) -> tuple[Program, Plant]:
        motions = tuple(
            replace(one, **{name: of(getattr(one, name), share) for name, of in edit.items()})
            if isinstance(one, kind)
            else one
            for one in program.motions
        )
        return replace(program, motions=motions), plant

    return change


def planned(program: Program, plant: Plant, target: Target) -> Plan:
    plan = optimize(program, plant, target, bounded=False)
    assert isinstance(plan, Plan)
    return plan


@cache
def station(target: Target) -> tuple[Program, Plant, Plan, PlanSensitivity]:
    """One station beside a rail."""
    # places and a rail for which the search ends in one optimum whatever the processor rounds
    program, plant = rapid(STATION), plant_with_rail((-0.19, 0.8))
    plan = planned(program, plant, target)
    return program, plant, plan, PlanSensitivity(program, plant, plan, everything(program, plant))


@pytest.mark.long
def test_a_plan_solved_again_is_no_worse_than_the_plan(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the coarse grid leads to an optimum 0.5 % later, it is solved once more from the plan's own grid."""
    program, plant, plan, _ = station(Target.STREAM)
    of, found = _SolvedWindow.of, []

    def later(*args: object) -> _SolvedWindow | None:
        found.append(of(*args))  # type: ignore[arg-type]
        return replace(found[0], duration=1.005 * found[0].duration) if len(found) == 1 else found[-1]

    monkeypatch.setattr(_SolvedWindow, "of", later)
    again = PlanSensitivity(program, plant, plan, everything(program, plant))
    assert len(found) == 2
    assert plan.duration <= again.duration + 1e-4
    assert again.duration <= plan.duration * 1.001


def known(answer: Effect) -> float:
    assert answer.gain is not None, answer.why
    return answer.gain


# --------------------------------------------------------------------------------------------------------- closed forms


@cache
def turn(angle: float) -> tuple[Program, Plant, PlanSensitivity]:
    """Joint 1 alone, from rest to rest, far under the tool's caps."""
    program = rapid(TURN.format(angle=angle))
    plant = plant_without_rail(free_speed=True, tcp=TcpCaps(9.0, 90.0))
    return (
        program,
        plant,
        PlanSensitivity(program, plant, planned(program, plant, Target.STREAM), everything(program, plant)),
    )


def law(angle: float, V: float, A: float) -> float:
    """The least time from rest to rest over an angle [deg]."""
    way = np.radians(angle)
    return float(2 * np.sqrt(way / A) if way <= V * V / A else way / V + V / A)


@pytest.mark.parametrize("angle", [5.0, 60.0])  # under the top speed, and with it
@pytest.mark.parametrize("column", ["velocity", "acceleration"])
def test_a_turn_of_one_joint_gains_what_its_closed_form_says(angle: float, column: str) -> None:
    program, plant, again = turn(angle)
    V, A = plant.limits.velocity[0], plant.limits.acceleration[0]
    more = {"velocity": (V * 1.1, A), "acceleration": (V, A * 1.1)}[column]
    wanted = law(angle, V, A) - law(angle, *more)
    answer = again.answer(limit(program, plant, column, 0), True)
    assert answer.gain == pytest.approx(wanted, abs=2e-5)
    h = 1e-6
    slope = {"velocity": law(angle, V * (1 + h), A), "acceleration": law(angle, V, A * (1 + h))}[column]
    assert answer.first_order == pytest.approx((law(angle, V, A) - slope) / h * 0.1, rel=0.06, abs=2e-5)
    assert answer.active == (wanted > 0)


@pytest.mark.parametrize(("angle", "speed"), [(5.0, False), (60.0, True)])
def test_multipliers_are_the_closed_forms_derivatives(angle: float, speed: bool) -> None:
    """T ~ A^-1/2 where the acceleration binds: -T/2 per whole of it; D/V + V/A where the speed does, too."""
    program, plant, again = turn(angle)
    window, _ = again.motion.part((0, 1))
    one = _SolvedWindow.of(again.motion.axes, again._formulation, LONG, window)
    assert one is not None
    V, A, way = plant.limits.velocity[0], plant.limits.acceleration[0], np.radians(angle)
    T = law(angle, V, A)
    assert one.duration == pytest.approx(T, rel=1e-6)
    by_A, by_V = (-V / A, V / A - way / V) if speed else (-T / 2, 0.0)
    small = 1e-3
    for column, wanted in (("acceleration", by_A), ("velocity", by_V)):
        after = again._changed(*limit(program, plant, column, 0, small)(1.0))
        # a window of nothing but joint moves is solved to a rough tolerance: its time is known in closed form
        assert one.first_order(again.motion, after) / small == pytest.approx(wanted, rel=1e-2, abs=1e-6)


def test_the_lagrangian_tells_of_rows_bounds_and_fixed_variables() -> None:
    """min x + 2 y - 3 w with x + z >= p, y >= b, w <= c and z fixed: p - z + 2 b - 3 c."""
    rows = express(2, 1, lambda z, p: [(z[0] + z[1] - p[0], 0.0, np.inf)]).block("row")

    def program(p: float, b: float, c: float, z: float) -> BlockNlp:
        nlp = BlockNlp()
        x, y, w = nlp.variables([3.0, 3.0, 1.0], [-9.0, b, -np.inf], [9.0, np.inf, c])
        (fixed,) = nlp.variables([z], z, z)
        nlp.minimise(int(x))
        nlp.minimise(int(y), 2.0)
        nlp.minimise(int(w), -3.0)
        nlp.add(rows, [x, fixed], [p])
        return nlp

    start = np.array([1.0, 0.5, 2.0, 0.25])
    nlp = program(*start)
    answer = nlp.solve()
    for change, wanted in zip(
        np.vstack([0.1 * np.eye(4), [0.1, 0.2, 0.3, 0.4]]), (0.1, 0.2, -0.3, -0.1, -0.8), strict=True
    ):
        other = program(*(start + change))
        assert nlp.lagrangian_change(other, answer) == pytest.approx(wanted, abs=1e-6)


# ----------------------------------------------------------------------------------------------------------- a station


@pytest.mark.parametrize("target", Target)
def test_nothing_changed_is_the_plan_again(target: Target) -> None:
    program, plant, plan, again = station(target)
    assert again.duration == pytest.approx(plan.duration, rel=1e-3)
    answer = again.answer(lambda _: (program, plant), True)
    assert (answer.gain, answer.first_order, answer.active) == (0.0, 0.0, False)


@pytest.mark.parametrize(("target", "column", "axis"), [
    (Target.STREAM, "acceleration", 0), (Target.RAPID, "acceleration", 2)
])  # fmt: skip
def test_a_limit_gains_what_planning_anew_gains(target: Target, column: str, axis: int) -> None:
    program, plant, plan, again = station(target)
    change = limit(program, plant, column, axis)
    anew = planned(*change(1.0), target).duration
    answer = again.answer(change, True)
    assert plan.duration - known(answer) == pytest.approx(anew, rel=1e-3)
    if target is Target.STREAM:  # a first order that knows of the rail
        assert answer.first_order == pytest.approx(known(answer), rel=0.3, abs=2e-4)


def test_a_joint_move_that_the_tool_holds_back_is_the_nonlinear_programs_again() -> None:
    """Its axes each go for themselves in the plan, which one progress for all of them would not."""
    program, plant = (
        rapid("MoveAbsJ [[40,25,-35,0,70,90],[9E9,9E9,9E9,9E9,9E9,9E9]], v500, fine, tool0;"),
        plant_without_rail(),
    )
    plan = planned(program, plant, Target.STREAM)
    again = PlanSensitivity(program, plant, plan, everything(program, plant))
    together = planned(program, plant, Target.RAPID).duration
    assert plan.duration < 0.99 * together
    assert again.duration == pytest.approx(plan.duration, rel=3e-3)


def test_the_stream_has_multipliers_and_the_controllers_runs_have_laws() -> None:
    kinds = {one: {type(part) for part in station(one)[3]._parts} for one in Target}
    assert kinds == {Target.STREAM: {_SolvedWindow}, Target.RAPID: {_TimedRuns}}


@pytest.mark.parametrize("target", Target)
@pytest.mark.parametrize(("column", "axis"), [("velocity", 4), ("velocity", 6), ("upper", 0)])
def test_a_limit_that_nothing_meets_gains_exactly_nothing_and_nothing_is_solved(
    target: Target, column: str, axis: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    program, plant, _, again = station(target)

    def solve(*_: object) -> None:
        raise AssertionError("solved")

    monkeypatch.setattr(MeshRefinement, "again", solve)
    monkeypatch.setattr(_TimedRuns, "again", solve)
    answer = again.answer(limit(program, plant, column, axis), True)
    assert (answer.gain, answer.active, answer.why) == (0.0, False, "")
    assert answer.first_order == pytest.approx(0.0, abs=1e-6)


def test_a_shorter_wait_is_worth_what_the_rail_did_not_do_in_it() -> None:
    program, plant, _, again = station(Target.STREAM)
    answer = again.answer(edited(program, plant, Wait, duration=lambda now, share: now * (1 - 0.1 * share)), False)
    assert 0.02 < known(answer) <= 0.03 + 1e-5  # the plan itself is solved to some 1e-6
    assert answer.first_order == pytest.approx(known(answer), rel=0.1)


@pytest.mark.long
@pytest.mark.parametrize("target", Target)
def test_a_place_that_is_moved_is_solved_where_it_is_now(target: Target) -> None:
    """All of the station by 20 mm towards home along the rail; and there and back is nothing."""
    program, plant, plan, again = station(target)

    def moved(X: np.ndarray, share: float) -> np.ndarray:
        out = X.copy()
        out[1, 3] -= 0.02 * share
        return out

    change = edited(program, plant, MoveJ | MoveL, X_WT=moved)
    answer = again.answer(change, False)
    back = again.answer(lambda share: change(-share), False)
    assert known(answer) > 0 > known(back)
    if target is Target.STREAM:
        anew = planned(*change(1.0), target).duration
        assert known(answer) == pytest.approx(plan.duration - anew, rel=0.05)
        assert answer.first_order == pytest.approx(known(answer), rel=0.2)


def test_a_place_out_of_reach_is_told() -> None:
    program, plant, _, again = station(Target.STREAM)

    def moved(X: np.ndarray, share: float) -> np.ndarray:
        out = X.copy()
        out[0, 3] += 2.0 * share
        return out

    answer = again.answer(edited(program, plant, MoveJ | MoveL, X_WT=moved), False)
    assert answer.gain is None
    assert "does not reach" in answer.why


def test_a_solve_that_fails_is_told_and_a_worse_one_loses_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    program, plant, _, again = station(Target.STREAM)
    change = limit(program, plant, "acceleration", 2)

    def fails(*_: object) -> None:
        raise NotConverged("as it happens")

    monkeypatch.setattr(MeshRefinement, "again", fails)
    monkeypatch.setattr(MeshRefinement, "run", fails)
    answer = again.answer(change, True)
    assert answer.gain is None
    assert answer.first_order is not None
    assert answer.why == "the nonlinear program did not converge: as it happens"

    monkeypatch.setattr(_SolvedWindow, "again", lambda self, *_: self.duration + 0.1)
    assert again.answer(change, True).gain == 0.0
    assert known(again.answer(change, False)) == pytest.approx(-0.1)


def test_first_order_is_told_of_the_whole_step() -> None:
    """Halving the step halves it."""
    program, plant, _, again = station(Target.STREAM)
    whole, half = (again.answer(limit(program, plant, "acceleration", 2, by), True).first_order for by in (0.1, 0.05))
    assert whole is not None
    assert half == pytest.approx(whole / 2, rel=DEFAULT.small_change * 0.1)
