"""Programs the rows `practice` and `thesis` make, against what they promise; the optimiser is not asked."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.job import Job, read_job
from trajopt_cli.motion import Move, MoveAbsJ, MoveExtJ, MoveL, Program
from trajopt_cli.problem.decision_scope import EVERYTHING, Freedom, RailFreedom
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.problem.workspace import reachable
from trajopt_cli.study.case import Case, NotApplicable, RailRule
from trajopt_cli.study.causes import CAUSES, TOOL_TURN, asked, causes
from trajopt_cli.study.practice import practice, with_detours
from trajopt_cli.study.thesis import WorkPoint, functional_areas, rail_positions, thesis, work_points

PROGRAMS = Path(__file__).parents[2] / "programs"


@pytest.fixture(scope="module", params=["hinge_cell", "hinge_line"])
def job(request: pytest.FixtureRequest) -> Job:
    return read_job(PROGRAMS / f"{request.param}.mod")


class Asked(Exception):
    """What a row asks of the optimiser."""

    def __init__(self, program: Program, target: Target, freedom: Freedom):
        super().__init__()
        self.program, self.target, self.freedom = program, target, freedom


def ask(program: Program, target: Target, freedom: Freedom):  # type: ignore[no-untyped-def]
    raise Asked(program, target, freedom)


def test_the_rail_moves_only_while_the_arm_is_folded(job: Job) -> None:
    home = job.plant.start[1:]
    rail, arm = float(job.plant.start[0]), home
    for motion in with_detours(job.program, job.plant).motions:
        if not isinstance(motion, Move):
            continue
        asked = job.plant.rail_value(motion.extax)
        given = None if asked is None else float(asked[0])
        after = motion.q if isinstance(motion, MoveAbsJ) else arm if isinstance(motion, MoveExtJ) else None
        if given is not None and abs(given - rail) > 1e-12:
            assert arm is not None, motion.source
            assert after is not None, motion.source
            np.testing.assert_allclose(arm, home)
            np.testing.assert_allclose(after, home)
        rail, arm = rail if given is None else given, after


def test_every_motion_of_the_program_is_still_there_in_order(job: Job) -> None:
    detoured = [id(motion) for motion in with_detours(job.program, job.plant).motions]
    own = [id(motion) for motion in job.program.motions]
    assert [one for one in detoured if one in set(own)] == own
    assert (len(detoured) == len(own)) == (job.program_path.name == "hinge_line.mod")  # it makes them itself


def test_practice_is_driven_as_written_by_the_controller(job: Job) -> None:
    with pytest.raises(Asked) as caught:
        practice(Case(job.program, job.plant, ask))
    assert caught.value.target is Target.RAPID
    assert caught.value.freedom.rail is RailFreedom.PROGRAMMED
    bench = read_job(PROGRAMS / "bench_irb140.mod")
    assert isinstance(practice(Case(bench.program, bench.plant, ask)), NotApplicable)
    assert isinstance(thesis(Case(bench.program, bench.plant, ask)), NotApplicable)


@pytest.mark.parametrize("phi", [0.0, 5.0, 20.0])
def test_every_work_point_is_reached_with_the_margin_and_the_rail_never_turns_back_needlessly(
    job: Job, phi: float
) -> None:
    rule = RailRule(phi_min=float(np.radians(phi)))
    points = work_points(job.program, job.plant, rule)
    assert not isinstance(points, Infeasible)
    areas = functional_areas(points)
    rail = rail_positions(points, areas, job.plant, rule)
    for point, position in zip(points, rail, strict=True):
        motion = job.program.motions[point.motion]
        if isinstance(motion, Move) and not isinstance(motion, MoveAbsJ | MoveExtJ):
            # half a micrometre inside: the range's end is found to a micrometre
            inward = position + np.array([-1e-6, 0.0, 1e-6])
            assert reachable(job.plant, motion.X_WT, inward, rule.phi_min).any(), motion.source
    for area in areas:
        way = np.diff([rail[k] for k in area])
        for k, (a, b) in zip(list(area)[2:], pairwise(way), strict=False):
            if a * b < 0:  # it turned back: from where it stood the point was out of reach
                before = rail[k - 1]
                assert not any(low <= before <= high for low, high in points[k].ranges)


def test_rail_steps_inside_an_area_fit_the_arms_time(job: Job) -> None:
    rule = RailRule(v_area=0.1)
    points = work_points(job.program, job.plant, rule)
    assert not isinstance(points, Infeasible)
    areas = functional_areas(points)
    rail = rail_positions(points, areas, job.plant, rule)
    free = 0
    for area in areas:
        for k in list(area)[1:]:
            step = abs(rail[k] - rail[k - 1])
            held = any(low <= rail[k - 1] <= high for low, high in points[k].ranges)
            if held:  # nothing forced it: at most V_Dfmax times the arm's time
                free += step > 0
                assert step <= 0.1 * points[k].time + 1e-9
    assert free > 0


def test_thesis_line_has_the_two_functional_areas_of_the_text() -> None:
    job = read_job(PROGRAMS / "hinge_line.mod")
    points = work_points(job.program, job.plant, RailRule())
    assert not isinstance(points, Infeasible)
    names = [
        {getattr(job.program.motions[points[k].motion], "target", "")[:4] for k in area}
        for area in functional_areas(points)
    ]
    assert names == [{"p_n1"}, {"p_n2", "p_n3"}, {"j_ho"}]


def test_the_thesis_program_carries_rail_and_speed_and_nothing_else(job: Job) -> None:
    with pytest.raises(Asked) as caught:
        thesis(Case(job.program, job.plant, ask, RailRule(v_transfer=0.7, v_area=0.3)))
    driven = caught.value.program
    assert caught.value.target is Target.RAPID
    assert not caught.value.freedom.dwells
    for was, now in zip(job.program.motions, driven.motions, strict=True):
        if not isinstance(was, Move):
            assert now is was
            continue
        assert isinstance(now, Move)
        assert now.speed.v_leax in (0.7, 0.3)
        assert type(now) is type(was)
        assert (now.target, now.zone, now.speed.v_tcp) == (was.target, was.zone, was.speed.v_tcp)
        if isinstance(was, MoveL):
            assert now.speed.v_leax == 0.3
        else:
            assert now.extax[1:] == was.extax[1:]


def test_an_unreachable_point_is_named() -> None:
    job = read_job(PROGRAMS / "hinge_cell.mod")
    motions = list(job.program.motions)
    far = np.array(motions[1].X_WT)  # type: ignore[union-attr]
    far[0, 3] = 1.5
    motions[1] = replace(motions[1], X_WT=far)  # type: ignore[type-var]
    answer = thesis(Case(replace(job.program, motions=tuple(motions)), job.plant, ask))
    assert isinstance(answer, Infeasible)
    assert "MoveL p_n1: no rail position keeps joint 3 10 deg from the stretched elbow there" in str(answer)


def test_areas_are_as_long_as_one_rail_position_serves_them() -> None:
    def point(station: int, *ranges: tuple[float, float]) -> WorkPoint:
        return WorkPoint(0, np.array(ranges), 0.1, station)

    points = [point(1, (0, 1)), point(1, (0.5, 2)), point(2, (0.9, 3)), point(3, (1.5, 3)), point(4, (-1, 0), (2, 4))]
    assert functional_areas(points) == [range(0, 3), range(3, 5)]


def test_each_cause_frees_something_and_takes_nothing_back() -> None:
    order = [RailFreedom.PROGRAMMED, RailFreedom.STATION, RailFreedom.STOP]
    for before, after in pairwise(CAUSES[1:]):
        fields = ("lines", "dwells", "through_stops", "configuration", "turn", "drop")
        less = [
            (order.index(one.freedom.rail), *(getattr(one.freedom, name) for name in fields)) for one in (before, after)
        ]
        assert all(a <= b for a, b in zip(*less, strict=True))
        assert less[0] != less[1]
    assert CAUSES[-1].freedom == EVERYTHING


def test_causes_that_can_make_no_difference_are_left_out() -> None:
    rail, bench = (read_job(PROGRAMS / f"{name}.mod").plant for name in ("hinge_cell", "bench_irb140"))
    assert causes(rail, True, free=True) == CAUSES
    assert [cause.name for cause in causes(rail, True)] == [c.name for c in CAUSES if c.name != TOOL_TURN]
    assert [cause.name for cause in causes(bench, False)] == [cause.name for cause in CAUSES[:3]]
    last = causes(bench, False)[-1]
    assert asked(last.freedom, bench, False) == asked(EVERYTHING, bench, False)
    assert asked(causes(rail, False)[-1].freedom, rail, False) == asked(EVERYTHING, rail, False)
