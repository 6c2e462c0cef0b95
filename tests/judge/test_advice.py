"""Advice: lines and joint moves made as fast as a closed form allows count as tight, slower ones by how much."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from legal_motion import (
    A_IN,
    B_IN,
    A,
    B,
    Case,
    faster,
    joint_move,
    line_move,
    plant_with_rail,
    rail_share,
    rapid_case,
    stream_case,
)

from trajopt_cli.findings import Finding
from trajopt_cli.judge.verify import verify
from trajopt_cli.limits import TcpCaps
from trajopt_cli.problem.plan import Target


def advice(case: Case, target: Target | None = None) -> dict[int, Finding]:
    report = verify(case.program, case.plant, case.rows(step=1e-3), target=target)
    assert report.legal, [f.message for f in report.findings if not f.passed]
    return {f.source.line: f for f in report.advice if f.source}


def capped_case() -> Case:
    """TCP caps so low that the trapezoid of 0.4 m/s and 2 m/s2 is the fastest on the line p_a_in to p_a."""
    case = rapid_case(replace(plant_with_rail(), tcp=TcpCaps(0.4, 2.0)))
    return case.swap(
        p1=line_move(case.plant, A_IN, A, rail_share(0.05, 0.08), 0.4 / 0.08, 2.0 / 0.08),
        p3=line_move(case.plant, A, A_IN, rail_share(0.08, 0.12), 0.4 / 0.08, 2.0 / 0.08),
        p5=line_move(case.plant, B_IN, B, rail_share(0.25, 0.28), 3.0, 25.0),
    )


def test_a_line_as_fast_as_its_caps_is_tight() -> None:
    found = advice(capped_case())
    assert found[12].check == "line tightness"
    assert abs(found[12].value) < 1e-3
    assert found[12].passed
    assert found[14].passed


def test_rows_that_miss_a_lines_ends_say_nothing_of_it() -> None:
    """The speeds at the rows beside its ends are not those of its ends: that TOPP-RA finds no timing from them is no
    fault of the line."""
    case = rapid_case()
    report = verify(case.program, case.plant, case.rows(step=0.0125, grid_only=True))
    assert report.legal
    lines = [one for one in report.advice if one.check == "line tightness"]
    assert [one.source.line for one in lines if one.source] == [12, 14]
    assert all(np.isfinite(one.value) for one in lines)


def test_a_slower_line_is_loose_by_its_share() -> None:
    case = capped_case()
    case = case.swap(p1=faster(case.pieces[1], 0.9))
    found = advice(case)
    assert found[12].value == pytest.approx(0.1, abs=1e-3)
    assert not found[12].passed
    assert found[12].message.startswith("cell.mod:12:5: ")


def test_a_line_with_the_rail_passing_through_its_ends_can_be_timed() -> None:
    """The path speed at both ends is the file's: rest would take longer than the file itself."""
    found = advice(stream_case())
    assert np.isfinite(found[12].value)
    assert 0.0 <= found[12].value < 0.6


def test_joint_moves_from_rest_to_rest_are_compared_with_ruckig() -> None:
    case = rapid_case()
    found = advice(case)
    assert found[15].check == "move tightness"
    assert found[15].passed  # the rail alone decides, and it runs its triangle
    assert abs(found[15].value) < 1e-9
    case = case.swap(p4=faster(case.pieces[4], 0.999))
    loose = advice(case, Target.RAPID)[15]
    assert loose.value == pytest.approx(case.pieces[4].T * 0.001, rel=1e-6)
    assert not loose.passed


def test_moves_at_a_tcp_cap_get_no_advice() -> None:
    plant = plant_with_rail()
    fast = rapid_case(plant)
    rows = fast.rows(step=1e-3)
    free = verify(fast.program, plant, rows)
    peak = max(f.value for f in free.findings if f.check == "TCP acceleration")
    capped = replace(plant, tcp=TcpCaps(2.5, peak))
    found = {f.source.line for f in verify(fast.program, capped, rows).advice if f.source}
    at_cap = {f.source.line for f in free.advice if f.source}
    assert len(at_cap - found) == 1


def test_joint_move_generator_is_the_straight_time() -> None:
    """The generator itself, against ruckig: without TCP caps its profile is the straight one."""
    from trajopt_cli.judge.libraries import straight_rest_to_rest

    plant = replace(plant_with_rail(), tcp=TcpCaps(1e3, 1e6))
    q_1 = plant.start + np.array([0.1, 0.05, 0.02, -0.01, 0, 0.03, 0])
    piece = joint_move(plant, plant.start, q_1)
    wanted = straight_rest_to_rest(plant.start, q_1, plant.limits.velocity, plant.limits.acceleration)
    assert pytest.approx(wanted, rel=1e-9) == piece.T
