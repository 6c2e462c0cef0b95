"""Poses that are passed: least time in closed form, caps by divided differences, distances by brute force."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import BSpline
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.angles import rotation
from trajopt_cli.iiwa.task.equilibrium import Equilibrium, Piece
from trajopt_cli.iiwa.task.model import AngleMeaning, Passing, PathPoints, Profile, RotationLaw, Route, Waypoint
from trajopt_cli.iiwa.task.rounded import Polyline, rounded
from trajopt_cli.iiwa.task.segments import interpolate, planned

CAPS = (0.1, 0.5, 1.0, 5.0, 20.0, 100.0)
TB, SLERP = RotationLaw.TAIT_BRYAN, RotationLaw.SLERP
FINE = Passing(1e-4, 0.01)


def path(
    points: Array,
    angles: Array | None = None,
    *,
    passing: Passing = FINE,
    profile: Profile = Profile.S_CURVE,
    law: RotationLaw = TB,
    caps: tuple[float, ...] = CAPS,
    h: float = 0.001,
    dwells: dict[int, float] | None = None,
) -> Route:
    poses = np.hstack([points, np.zeros_like(points) if angles is None else angles])
    v, w, a, e, jerk, turn_jerk = caps
    speeds = np.tile([v, w, a, e, jerk, turn_jerk], (len(poses) - 1, 1))
    way = PathPoints(poses, "path.csv", np.arange(2, len(poses) + 2), dwells=dwells or {})
    return Route(way, speeds, h, profile, law, AngleMeaning.RELATIVE, passing)


def apart(rows: Array, chain: Array) -> float:
    """The greatest distance of points (n, 3) from straight legs between (m, 3), of all pairs the nearest."""
    a, ab = chain[:-1], np.diff(chain, axis=0)
    worst = 0.0
    for part in np.array_split(rows, max(1, len(rows) * len(a) // 500_000)):
        ap = part[:, None] - a
        share = np.clip((ap * ab).sum(axis=2) / np.maximum((ab * ab).sum(axis=1), 1e-300), 0, 1)
        worst = max(worst, np.linalg.norm(ap - share[..., None] * ab, axis=2).min(axis=1).max())
    return worst


def turn_vectors(found: Equilibrium) -> Array:
    if found.rotation is TB:
        return np.diff(found.pose[:, 3:], axis=0)
    turned = Rotation.from_matrix(found.R)
    return np.asarray((turned[:-1].inv() * turned[1:]).as_rotvec())


def tops(found: Equilibrium) -> Array:
    """Greatest speed, turn rate, accelerations and jerks of the rows, less what rounding of coordinates makes."""
    h, out = found.h, []
    for order in range(3):
        for steps in (np.diff(found.pose[:, :3], axis=0), turn_vectors(found)):
            size = np.linalg.norm(np.diff(steps, order, axis=0), axis=1).max(initial=0) / h ** (order + 1)
            out.append(max(0.0, size - 2 ** (order + 1) * 4.5e-16 / h ** (order + 1)))
    return np.array(out)


def test_2000_points_take_the_time_of_the_line_they_lie_on() -> None:
    """0.8 m at 0.1 m/s: 8 s, and v / a + a / j for both ramps; of 50 rows' mean the ramp lasts 49."""
    x = np.linspace(0, 0.8, 2000)
    found, (fact,) = planned(path(np.column_stack([x, 0 * x, 0 * x])))
    assert found.duration == pytest.approx(8.0 + 0.1 + 0.05, abs=0.0015)
    assert found.pieces == (Piece(0, len(found.pose) - 1, "1", "2000"),)
    assert np.all(np.abs(found.pose[:, 1:]) < 1e-15)
    assert np.all(np.diff(found.pose[:, 0]) >= 0)
    assert tops(found)[::2] == pytest.approx(CAPS[::2], rel=1e-3)
    assert fact.passed is not None
    assert fact.passed.poses == 1998
    assert fact.passed.away < 1e-15
    assert fact.binds == "v_max"
    rough, _ = planned(path(np.column_stack([x, 0 * x, 0 * x]), profile=Profile.TRAPEZOID))
    assert rough.duration == pytest.approx(8.1, abs=0.0015)


def test_a_circle_of_short_chords_is_passed_at_full_speed() -> None:
    """Radius 50 mm, 0.4 mm chords: v² / r = 0.2 m/s², far from the cap; chords add nothing to it."""
    at = np.arange(0, 16, 0.008)
    found, (fact,) = planned(path(0.05 * np.column_stack([np.cos(at), np.sin(at), 0 * at])))
    cruise = slice(300, -300)
    speed = np.linalg.norm(np.diff(found.pose[cruise, :3], axis=0), axis=1) / 0.001
    assert speed == pytest.approx(np.full(len(speed), 0.1), rel=2e-3)
    across = np.linalg.norm(np.diff(found.pose[cruise, :3], 2, axis=0), axis=1) / 1e-6
    assert across.max() < 0.205
    assert fact.passed is not None
    assert np.linalg.norm(found.pose[:, :3], axis=1) == pytest.approx(np.full(len(found.pose), 0.05), abs=1e-4)


@pytest.mark.parametrize("law", list(RotationLaw))
def test_sharp_corners_are_slower_and_no_stops(law: RotationLaw) -> None:
    square = 0.1 * np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 0.0]])
    turns = np.array([[0, 0, 0], [0.1, 0, 0], [0.1, 0.2, 0], [0, 0.2, 0.3], [0, 0, 0]])
    times = []
    for tolerance in (2e-3, 5e-4, 1e-4):
        passing = Passing(tolerance, 0.02)
        found, (fact,) = planned(path(square, turns, law=law, passing=passing))
        assert np.all(tops(found) <= np.array(CAPS) * (1 + 1e-6))
        steps = np.linalg.norm(np.diff(found.pose[:, :3], axis=0), axis=1)
        assert steps[100:-100].min() > 1e-6
        assert fact.passed is not None
        away = apart(found.pose[:, :3], square)
        met = cKDTree(found.pose[:, :3]).query(square)[0].max()
        assert max(away, met - 1e-4) <= fact.passed.away <= tolerance
        assert met > 0.9 * fact.passed.away
        times.append(found.duration)
    assert times == sorted(times)


leg = st.tuples(*[st.floats(-0.05, 0.05)] * 3, *[st.floats(-0.5, 0.5)] * 3)


@settings(max_examples=40, deadline=None)
@given(
    st.lists(leg, min_size=1, max_size=6),
    st.floats(1e-5, 3e-3),
    st.floats(1e-3, 0.1),
    st.sampled_from(RotationLaw),
    st.sampled_from([Profile.TRAPEZOID, Profile.S_CURVE]),
    st.tuples(st.floats(0.05, 0.5), st.floats(0.2, 2), st.floats(0.5, 5), st.floats(1, 20), st.floats(5, 100)),
)
def test_caps_and_tolerances_hold_on_the_rows(
    legs: list[tuple[float, ...]],
    tolerance: float,
    turn: float,
    law: RotationLaw,
    profile: Profile,
    caps: tuple[float, ...],
) -> None:
    steps = np.array(legs)
    steps[np.abs(steps) < 1e-4] = 0.0
    steps[~steps.any(axis=1), 0] = 0.03
    chain = np.vstack([np.zeros(6), np.cumsum(steps, axis=0)])
    chain[:, 4] = np.clip(chain[:, 4], -1.4, 1.4)
    chain = chain[np.r_[True, np.any(np.diff(chain, axis=0) != 0, axis=1)]]
    wanted = path(
        chain[:, :3], chain[:, 3:], passing=Passing(tolerance, turn), profile=profile, law=law,
        caps=(*caps, 4 * caps[-1]), h=0.004,
    )  # fmt: skip
    found, (fact,) = planned(wanted)
    limits = np.array([*caps, 4 * caps[-1]])
    held = slice(0, 4 if profile is Profile.TRAPEZOID else 6)
    assert np.all(tops(found)[held] <= limits[held] * (1 + 1e-6))
    assert fact.passed is not None
    assert apart(found.pose[:, :3], chain[:, :3]) <= fact.passed.away + 1e-15
    assert fact.passed.away <= tolerance
    assert fact.passed.turned <= turn
    assert np.array_equal(found.pose[[0, -1], :3], chain[[0, -1], :3])
    assert np.abs(found.R - rotation(found.pose[:, 3:])).max() < 1e-9
    assert found.R[-1] == pytest.approx(rotation(chain[-1, 3:]), abs=1e-14)


def test_the_curve_is_scipys_spline_and_straight_where_the_chain_is() -> None:
    chain = np.zeros((4, 6))
    chain[:, :3] = [[0, 0, 0], [0.2, 0, 0], [0.2, 0.1, 0], [0.3, 0.1, 0.1]]
    chain[:, 5] = [0, 0.1, 0.3, 0.1]
    at = np.array([0, 2, 3, 5.0])
    curve = rounded(Polyline(at, chain), 0.3, 1e-3, 0.01)
    k = curve.knots
    t = np.concatenate([-k[3:0:-1], k, 10 - k[-2:-5:-1]])
    places = (t[1:-3] + t[2:-2] + t[3:-1]) / 3
    control = np.column_stack([np.interp(places[1:-1], at, column) for column in chain.T])
    control = np.vstack([2 * control[0] - control[1], control, 2 * control[-1] - control[-2]])
    when = np.linspace(0, 5, 777)
    assert curve.poses(when)[0] == pytest.approx(BSpline(t, control, 3)(when), abs=1e-14)
    straight = curve.poses(np.linspace(0, 1, 50))[0]
    assert straight[:, 0] == pytest.approx(np.linspace(0, 0.1, 50), abs=1e-15)
    assert np.all(straight[:, 1:5] == 0)


def test_a_dwell_is_a_stop_and_both_sides_of_it_are_passed_apart() -> None:
    points = np.column_stack([np.linspace(0, 0.1, 11), np.zeros(11), np.zeros(11)])
    found, facts = planned(path(points, dwells={5: 0.01}))
    assert [(piece.origin, piece.goal, piece.dwell) for piece in found.pieces] == [
        ("1", "6", False),
        ("6", "6", True),
        ("6", "11", False),
    ]
    assert np.array_equal(found.pose[found.pieces[0].last, :3], points[5])
    assert [fact.dwell for fact in facts] == [pytest.approx(0.01), 0.0]
    assert facts[0].duration == pytest.approx(0.5 + 0.15, abs=0.0015)


def test_listed_poses_are_passed_like_those_of_a_file() -> None:
    points = np.array([[0, 0, 0], [0.1, 0, 0], [0.1, 0.1, 0]])
    many = path(points)
    listed = tuple(Waypoint(str(i + 1), pose, "t.yaml:1") for i, pose in enumerate(many.poses))
    assert np.array_equal(interpolate(many).pose, interpolate(replace(many, waypoints=listed)).pose)


def test_angles_go_the_shorter_way_and_say_so_once() -> None:
    angles = np.zeros((40, 3))
    angles[:, 2] = (np.linspace(3, 4, 40) + np.pi) % (2 * np.pi) - np.pi
    points = np.column_stack([np.linspace(0, 0.1, 40), np.zeros(40), np.zeros(40)])
    found = interpolate(path(points, angles))
    assert found.pose[:, 5].min() >= 3 - 1e-12
    assert found.pose[-1, 5] == pytest.approx(4)
    (note,) = found.notes
    assert note == "gamma goes the shorter way round to pose 7; the sequence goes on counting"


@pytest.mark.parametrize("seed", [21, 31])
def test_caps_that_break_here_when_lowered_there_are_kept_in_the_end(seed: int) -> None:
    """Jagged ways with little acceleration: lowered around each break alone, the breaks only wander."""
    points = np.round(np.cumsum(np.random.default_rng(seed).normal(size=(12, 3)) * 0.04, axis=0), 3)
    caps = (0.7, 1.0, 0.235, 4.0, 1.0, 1.0)
    found, (fact,) = planned(path(points, profile=Profile.TRAPEZOID, caps=caps, passing=Passing(5e-3, 0.01)))
    assert tops(found)[0] <= 0.7
    assert tops(found)[2] == pytest.approx(0.235, rel=5e-3)
    assert tops(found)[2] <= 0.235 * (1 + 1e-6)
    assert fact.binds == "a_max"


def test_a_jerk_far_below_the_acceleration_and_short_ways_cost_what_a_stop_costs() -> None:
    """Rest to rest on one leg: v / a + a / j where both are reached, the fourth root forms where they are not."""
    for way, least in ((0.2, 2.15), (0.013, 0.2838), (0.0004, 4 * np.cbrt(0.0004 / 40))):
        found, _ = planned(path(np.array([[0, 0, 0], [way, 0, 0]])))
        assert found.duration == pytest.approx(least, rel=0.025)
    slow, _ = planned(path(np.array([[0, 0, 0], [0.2, 0, 0]]), caps=(0.1, 1, 100.0, 1, 1.0, 1)))
    assert slow.duration == pytest.approx(2 + 2 * np.sqrt(0.1), rel=0.01)


POINTS = np.array([[0, 0, 0], [0.1, 0, 0], [0.1, 0.1, 0]])


@pytest.mark.parametrize(
    ("asked", "message"),
    [
        (path(POINTS, profile=Profile.THESIS), "path.csv:2: passing: profile thesis knows no acceleration"),
        (path(POINTS[[0, 0, 1]]), "path.csv:3: pose 2 repeats pose 1: remove it"),
        (path(POINTS, np.array([[0, 0, 0], [0, 1.5, 0], [0, 0, 0]])), "path.csv:3: pose 2: beta is 85.9"),
        (path(POINTS, caps=(0.1, 0, 0, 0, 20, 0)), "path.csv:3: segment 1 -> 2: a_max is 0 m/s2 with 0.1 m to go"),
        (path(POINTS, caps=(1e-6, 1, 1, 1, 1, 1)), "path.csv:3: segment 1 -> 2 takes 1e+08 periods of 0.001 s"),
    ],
)
def test_what_cannot_be_passed_is_one_line(asked: Route, message: str) -> None:
    with pytest.raises(InputError) as caught:
        interpolate(asked)
    assert str(caught.value).startswith(message)
