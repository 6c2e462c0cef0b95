"""A tool that may be turned about its axis: what the judge lets pass, and its swings and turns against pinocchio."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
import pytest
from legal_motion import judged as verify
from spoiled_turns import SECTOR, bent, turned_case

from trajopt_cli.judge.free_turns import beyond_sector, off_taught, swing_of, turn_of, turned_by
from trajopt_cli.motion import FreeTurn
from trajopt_cli.problem.plan import Target


@pytest.mark.parametrize("target", [None, *Target])
@pytest.mark.parametrize("turns", [(0.0, 0.0), (0.3, 0.3), (-0.4, 0.45)])
def test_turned_stops_and_lines_are_legal(turns: tuple[float, float], target: Target | None) -> None:
    case = turned_case(*turns)
    report = verify(case.program, case.plant, case.rows(), target=target)
    assert report.legal, report.worst.message


def test_a_stream_may_turn_as_it_likes_on_a_line() -> None:
    case = turned_case(0.1, 0.1, bent(turned_case(0.1, 0.1).pieces[1], 0.2))
    assert verify(case.program, case.plant, case.rows()).legal
    assert not verify(case.program, case.plant, case.rows(), target=Target.RAPID).legal


def test_a_swing_and_a_turn_make_the_rotation() -> None:
    rng = np.random.default_rng(3)
    for _ in range(50):
        u = rng.normal(size=3)
        u /= np.linalg.norm(u)
        free, angle = FreeTurn(tuple(u), -1.0, 1.0), rng.uniform(-np.pi, np.pi)
        square = np.cross(u, rng.normal(size=3))
        S = pin.exp3(square / np.linalg.norm(square) * rng.uniform(0, 3.0))
        R = S @ pin.exp3(u * angle)
        assert turn_of(R, free) == pytest.approx(angle, abs=1e-9)
        assert swing_of(R[None], free)[0] == pytest.approx(S, abs=1e-9)


def test_the_sector_is_measured_either_way_around() -> None:
    assert beyond_sector(np.array([0.0, 0.6, -0.7, np.pi]), SECTOR) == pytest.approx([0, 0.1, 0.2, np.pi - 0.5])
    behind = FreeTurn((0.0, 0.0, 1.0), -np.pi, 0.0)
    assert beyond_sector(np.array([np.pi, 0.1, 3.0]), behind) == pytest.approx([0, 0.1, np.pi - 3.0])


def test_tilt_and_turn_count_whichever_is_farther() -> None:
    R = pin.exp3(np.array([0.3, -0.2, 0.1]))
    tilted = turned_by(R @ pin.exp3(np.array([1e-3, 0.0, 0.0])), SECTOR, np.array(0.2))
    assert off_taught(tilted[None], R, SECTOR)[0] == pytest.approx(1e-3, rel=1e-6)
    assert off_taught(turned_by(R, SECTOR, np.array(0.7))[None], R, SECTOR)[0] == pytest.approx(0.2)
    assert off_taught(tilted[None], R, None)[0] == pytest.approx(0.2, rel=1e-4)


def test_a_turn_made_in_a_corner_bends_the_way_of_the_axis_by_no_more_than_is_granted() -> None:
    """Two lines about one corner: on the first the tool turns by a, on the second it tilts by b; rounded as whole
    orientations, exp(-x A) exp(y B) with 4 x y <= 1, against the taught corner, in which nothing turns."""
    a, b = 0.05, 0.02
    A, B = np.array([0.0, 0.0, a]), np.array([b, 0.0, 0.0])
    shares = np.linspace(0.0, 1.0, 21)
    R = np.array([pin.exp3(-((1 - u) ** 2) / 2 * A) @ pin.exp3(u**2 / 2 * B) for u in shares])
    swings = np.array([pin.log3(one) for one in swing_of(R, SECTOR)])
    off = np.abs(swings[:, 1]).max()  # the taught axis tilts about x alone
    made = np.ptp(turn_of(R, SECTOR))
    assert 1e-5 < off <= 2 * made * b / 2


@pytest.mark.parametrize(
    ("first", "last", "bend", "most"), [(0.1, 0.1, 0.2, 0.3), (-0.3, -0.1, 0.0, 0.3), (0.0, 0.4, 0.0, 0.4)]
)
def test_it_tells_how_far_the_tool_turns_and_what_the_sector_allows(
    first: float, last: float, bend: float, most: float
) -> None:
    """Joint 6 turns the tool about the axis that is free: by what it is given at the ends and between."""
    case = turned_case(first, last)
    case = case.swap(p1=bent(case.pieces[1], bend)) if bend else case
    report = verify(case.program, case.plant, case.rows())
    assert report.legal, report.worst.message
    told = [one for one in report.findings if one.check == "tool turn"]
    assert [one.source.line for one in told if one.source is not None] == [11, 12]
    assert told[0].value == pytest.approx(abs(first), abs=1e-6)
    assert told[1].value == pytest.approx(most, abs=1e-4)
    assert [one.limit for one in told] == [SECTOR.high, SECTOR.high]


def test_a_turn_beyond_the_sector_is_told_and_refused() -> None:
    case = turned_case(0.5, 0.5, bent(turned_case(0.5, 0.5).pieces[1], 0.01))
    (told,) = [
        one
        for one in verify(case.program, case.plant, case.rows()).findings
        if one.check == "tool turn" and not one.passed
    ]
    assert told.source is not None
    assert (told.source.line, told.limit) == (12, SECTOR.high)
    assert told.value == pytest.approx(0.51, abs=1e-4)
