"""The program as the judge reads it: which points there are, what each fixes, and which rules a move obeys."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from legal_motion import (
    HOME,
    down,
    home,
    move_ext,
    move_j,
    move_l,
    plant_with_rail,
    plant_without_rail,
    program,
    rapid_case,
    wait,
)
from legal_runs import P0, P1, P2, VIA, Z10, move_c

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.judge.program_points import may_drop, obeys_programmed_speed, points_of, stays
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import Tool, UnitMove
from trajopt_cli.trajectory import Trajectory

PLANT = plant_with_rail()
GRIP = Tool("grip", pose(rotation_about([0, 1, 0], 0.3), [0.02, 0.0, 0.1]))


def test_what_may_be_left_out() -> None:
    """Moves that are marked or whose target the cell names, in any case; no wait, and nothing that is not there."""
    asked = program(move_j(11, "p_A", P0), wait(12, 0.1), move_j(13, "p_b", P1, optional=True), move_j(14, "p_c", P2))
    plant = replace(PLANT, droppable=frozenset({"p_a"}))
    assert [may_drop(asked, plant, i) for i in range(-1, 5)] == [False, True, False, True, False, False]
    assert [may_drop(asked, PLANT, i) for i in range(-1, 5)] == [False, False, False, True, False, False]
    points = points_of(asked, plant, optional=True)
    assert [one.optional for one in points] == [False, True, True, False]
    assert not any(one.optional for one in points_of(asked, plant))
    assert [one.index for one in points_of(asked, plant, dropped={0, 3})] == [-1, 2]
    assert [[i for i, _ in one.holds] for one in points_of(asked, plant)] == [[], [1], [], []]
    assert [[i for i, _ in one.holds] for one in points_of(asked, plant, dropped={0})] == [[1], [], []]


def test_what_points_fix() -> None:
    """Poses the flange's, by the tool; joints both arm and rail where that is told; external axes their rail alone,
    with the tool before them; robtargets their rail only where the cell says so."""
    motions = (move_j(11, "p_a", P0, 0.3, tool=GRIP), move_ext(12, 0.4), home(13, None), home(14, 0.2))
    start, at_pose, alone, free, ends = points_of(program(*motions), PLANT)
    np.testing.assert_allclose(at_pose.X_WF, P0 @ np.linalg.inv(GRIP.X_FT), atol=1e-12)
    np.testing.assert_allclose(at_pose.X_WT, P0, atol=1e-12)
    assert (at_pose.arm, at_pose.rail, at_pose.name, at_pose.index) == (None, None, "MoveJ p_a", 0)
    assert (alone.X_WF, alone.arm, alone.rail) == (None, None, (pytest.approx(0.4),))
    assert alone.X_FT is at_pose.X_FT
    assert (free.X_WF, free.rail) == (None, None)
    assert free.arm.tolist() == HOME.tolist()
    np.testing.assert_allclose(ends.X_WF, PLANT.robot.forward(np.r_[0.2, HOME][None])[0], atol=1e-12)
    assert ends.rail == pytest.approx((0.2,))
    np.testing.assert_allclose(start.X_FT, GRIP.X_FT)
    assert (start.rail, start.arm.tolist()) == ((0.0,), HOME.tolist())
    fixed = points_of(program(*motions), replace(PLANT, rail_fixed=True))
    assert fixed[1].rail == pytest.approx((0.3,))
    bench = points_of(program(home(11, None), move_j(12, "p", P0, 0.3)), plant_without_rail())
    assert (bench[0].rail, bench[1].rail, bench[2].rail) == (None, None, None)
    np.testing.assert_allclose(bench[1].X_WF, plant_without_rail().robot.forward(HOME[None])[0], atol=1e-12)
    only = points_of(program(move_ext(11, 0.4)), PLANT)
    np.testing.assert_array_equal(only[0].X_FT, np.eye(4))


def test_external_axes_that_this_robot_has_not() -> None:
    """Their move waits for the positioner, where it turns one; else it is nothing."""
    unit = UnitMove("stn", 1, 0.0, 1.0, 0.75, False, 9.0, 9.0, (0.0, 0.0, 0.0), (0.0, 0.0, 1.0))
    plant = plant_without_rail()
    for units, duration, wanted in (((), None, []), ((unit,), None, [0.75]), ((unit,), 0.9, [0.9])):
        alone = replace(move_ext(12, 0.4), units=units, duration=duration)
        points = points_of(program(move_j(11, "p", P0, zone=Z10), alone, move_l(13, "p_1", P1)), plant)
        assert [hold.duration for _, hold in points[1].holds] == wanted
        assert [i for i, _ in points[1].holds] == [1] * len(wanted)
        assert points[1].fly_by is None  # it stops for it
        assert len(points) == 3


@pytest.mark.parametrize("which", ["way", "angle"])
def test_a_line_to_where_it_starts(which: str) -> None:
    """A nanometre, a nanoradian."""
    for size, still in ((0.9e-9, True), (1.1e-9, False)):
        X = np.array(P0)
        if which == "way":
            X[:3, 3] += size * np.array([0.6, 0.0, 0.8])
        else:
            X[:3, :3] = X[:3, :3] @ rotation_about([0, 0, 1], size)
        stop = points_of(program(move_j(11, "p", P0), move_l(12, "p", X)), PLANT)[2]
        assert stays(stop, P0) == still
        assert not stays(points_of(program(move_j(11, "p", X)), PLANT)[1], P0)
        moved = replace(
            stop.move, units=(UnitMove("s", 1, 0.0, 1.0, 0.1, True, 9.0, 9.0, (0.0,) * 3, (0.0, 0.0, 1.0)),)
        )
        assert not stays(replace(stop, move=moved), P0)
    assert not stays(points_of(program(move_ext(11, 0.1)), PLANT)[1], P0)


def test_who_obeys_a_programmed_speed() -> None:
    """No move with a time of its own, no external axes alone, no start; joint moves unless the cell frees them."""
    free = replace(PLANT, free_speed=True)
    motions = (move_j(11, "p", P0), home(12), move_l(13, "p", P1), move_c(14, "p", VIA, P2), move_ext(15, 0.1))
    start, *points = points_of(program(*motions), PLANT)
    assert [obeys_programmed_speed(one, PLANT) for one in (start, *points)] == [False, True, True, True, True, False]
    assert [obeys_programmed_speed(one, free) for one in points] == [False, False, True, True, False]
    timed = [replace(one, move=replace(one.move, duration=1.0)) for one in points]
    assert not any(obeys_programmed_speed(one, PLANT) for one in timed)
    assert [one.duration for one in timed] == [1.0] * 5
    assert start.duration is None
    assert start.least == 0.0


def test_circles_need_their_start() -> None:
    """An arc behind joints with a free rail has none until it is drawn; behind a point that is passed it has."""
    motions = [move_l(11, "p_1", P1, zone=Z10), move_c(12, "p_2", VIA, P2)]
    arc = points_of(program(move_j(10, "p_0", P0), *motions), PLANT)[3]
    assert arc.curve is not None
    assert arc.curve.length == pytest.approx(0.03 * np.pi, rel=1e-6)
    assert points_of(program(home(10, None), motions[1]), PLANT)[2].curve is None
    passed = replace(home(10, None), zone=Z10, q=HOME + 0.2)
    after_home = points_of(program(passed, motions[1], move_l(13, "p", P0)), PLANT)
    assert after_home[1].fly_by is not None
    assert after_home[2].curve is not None


def test_zones_are_half_a_way_at_most() -> None:
    """The smaller of both halves of the ways to a point and on from it."""
    for middle, radius in ((0.006, 0.003), (0.015, 0.0075), (0.024, 0.01), (0.04, 0.005)):
        motions = (move_j(11, "p_0", P0), move_l(12, "p_1", down(0.45 + middle, 0.0, 0.4), zone=Z10),
                   move_l(13, "p_2", P1))  # fmt: skip
        point = points_of(program(*motions), PLANT)[2]
        assert point.fly_by is not None
        half = min(middle, 0.05 - middle) / 2
        assert point.fly_by.radius == pytest.approx(radius, abs=1e-12)
        assert point.fly_by.turning == pytest.approx(min(0.015, half), abs=1e-12)


@pytest.mark.parametrize(("spoil", "said"), [
    (lambda t, q, qd: t.__setitem__(7, t[6]), r"^row 7: time 0\.006 s follows 0\.006 s; times must increase"),
    (lambda t, q, qd: t.__setitem__(7, 0.001), r"^row 7: time 0\.001 s follows 0\.006 s"),
    (lambda t, q, qd: q.__setitem__((5, 0), np.nan), r"^row 5: rail is nan, wanted a finite number"),
    (lambda t, q, qd: qd.__setitem__((9, 6), np.inf), r"^row 9: joint_6 speed is inf, wanted a finite number"),
    (lambda t, q, qd: t.__setitem__(0, -np.inf), r"^row 0: t is -inf"),
])  # fmt: skip
def test_rows_that_are_no_motion_are_told_with_their_row(
    spoil: object, said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("trajopt_cli.judge.verify.PIECE", 4)
    t, q = np.arange(12) * 1e-3, np.tile(PLANT.start, (12, 1))
    qd: Array = np.zeros_like(q)
    spoil(t, q, qd)
    with pytest.raises(InputError, match=said):
        verify(rapid_case().program, PLANT, Trajectory(PLANT.limits.names, t, q, qd), advice=False)


def test_a_rest_of_two_rows_is_a_motion() -> None:
    t, q = np.arange(2) * 1e-3, np.tile(PLANT.start, (2, 1))
    assert verify(program(home(11)), PLANT, Trajectory(PLANT.limits.names, t, q, np.zeros_like(q)), advice=False).legal
    with pytest.raises(InputError, match=r"^the motion has 1 rows; at least 2 are needed"):
        verify(program(home(11)), PLANT, Trajectory(PLANT.limits.names, t[:1], q[:1]), advice=False)


def test_motions_that_are_left_out_are_told_one_by_one() -> None:
    """Each with its name and place; an index that is none of the program's by its number."""
    case = rapid_case()
    found = verify(case.program, case.plant, case.rows(step=0.004), dropped={3, 99, -2}, advice=False).findings
    told = [(f.subject, f.value, f.limit, f.passed, f.source) for f in found if f.check == "dropped motion"]
    assert told == [
        ("motion -2", 1.0, 0.0, False, None), ("MoveL p_a_out", 1.0, 0.0, False, case.program.motions[3].source),
        ("motion 99", 1.0, 0.0, False, None),
    ]  # fmt: skip
