"""The equilibrium sequence: the thesis' steps by hand, bounds on every step, exact ends, and what is refused."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation, Slerp

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.angles import rotation
from trajopt_cli.iiwa.task.equilibrium import Equilibrium, Piece
from trajopt_cli.iiwa.task.model import AngleMeaning, Profile, RotationLaw, Route, Waypoint
from trajopt_cli.iiwa.task.segments import interpolate, planned

DEG = np.pi / 180
SPEEDS = {"v_max": 0.1, "omega_max": 0.5, "a_max": 1.0, "epsilon_max": 2.0, "jerk": 20.0, "angular_jerk": 40.0}
TB, SLERP = RotationLaw.TAIT_BRYAN, RotationLaw.SLERP
THESIS, TRAPEZOID, S_CURVE = Profile.THESIS, Profile.TRAPEZOID, Profile.S_CURVE


def pose(name: str, *values: float, dwell: float = 0.0) -> Waypoint:
    """Position in m, angles in degrees."""
    six = np.array([*values, *[0.0] * (6 - len(values))], dtype=np.float64)
    six[3:] *= DEG
    return Waypoint(name, six, f"cube.yaml:{ord(name[0]) - 90}", dwell)


def route(
    *waypoints: Waypoint,
    speeds: dict[str, float] | Array = SPEEDS,
    h: float = 0.001,
    profile: Profile = THESIS,
    law: RotationLaw = TB,
) -> Route:
    each = [*speeds.values()] if isinstance(speeds, dict) else speeds
    caps = np.broadcast_to(each, (len(waypoints) - 1, 6))
    return Route(waypoints, caps, h, profile, law, AngleMeaning.RELATIVE)


def steps(rows: Array) -> Array:
    return np.asarray(np.linalg.norm(np.diff(rows, axis=0), axis=1))


def turn_steps(found: Equilibrium) -> Array:
    if found.rotation is TB:
        return steps(found.pose[:, 3:])
    turned = Rotation.from_matrix(found.R)
    return (turned[:-1].inv() * turned[1:]).magnitude()


def test_the_thesis_steps_by_hand() -> None:
    """0.025 m at 0.1 m/s and h = 0.1 s: t = 2.5 h, so N = 2 steps of 0.01 m between two of 0.0025 m."""
    found = interpolate(route(pose("a"), pose("b", 0.025), h=0.1))
    assert found.pose[:, 0] == pytest.approx([0, 0.0025, 0.0125, 0.0225, 0.025], abs=1e-17)
    assert found.pieces == (Piece(0, 4, "a", "b"),)
    assert found.t[-1] == pytest.approx(0.4)


@pytest.mark.parametrize(
    ("way", "v", "h", "rows"), [(0.2, 1.0, 0.1, 3), (0.3, 1.0, 0.1, 4), (0.6, 0.2, 0.001, 3001), (0.7, 0.1, 0.01, 701)]
)
def test_whole_numbers_of_periods_have_no_empty_ends(way: float, v: float, h: float, rows: int) -> None:
    """0.3 / 0.1 and 0.7 / 0.1 / 0.01 floor to one too few in doubles."""
    found = interpolate(route(pose("a", 1), pose("b", 1, way), speeds=SPEEDS | {"v_max": v}, h=h))
    assert len(found.pose) == rows
    assert steps(found.pose) == pytest.approx(np.full(rows - 1, v * h), rel=1e-9)


def test_a_segment_shorter_than_a_period_goes_in_two_halves() -> None:
    found = interpolate(route(pose("a"), pose("b", 4e-5)))
    assert found.pose[:, 0] == pytest.approx([0, 2e-5, 4e-5], abs=1e-20)


def test_both_parts_end_together_and_shared_poses_stand_once() -> None:
    """The turn takes 40° / 0.5 rad/s = 1.396 s, longer than the way; then 1 s at the way's speed."""
    found = interpolate(route(pose("a"), pose("b", 0.1, 0, 0, 0, 0, 40), pose("c", 0.1, 0.1, 0, 0, 0, 40)))
    first, second = found.pieces
    assert first.last == second.first
    assert not np.any(steps(found.pose) == 0)
    N = int(40 * DEG / 0.5 / 0.001)
    assert (first.last, second.last - second.first) == (N + 2, 1000)
    share = found.pose[: first.last + 1, 0] / 0.1
    assert found.pose[: first.last + 1, 5] == pytest.approx(share * 40 * DEG, abs=1e-15)
    _, facts = planned(route(pose("a"), pose("b", 0.1, 0, 0, 0, 0, 40), pose("c", 0.1, 0.1, 0, 0, 0, 40)))
    assert [fact.binds for fact in facts] == ["omega_max", "v_max"]
    assert facts[0].omega_top == pytest.approx(0.5, rel=1e-9)
    assert facts[0].v_top == pytest.approx(0.1 * 0.5 / (40 * DEG), rel=1e-9)
    assert facts[0].duration == pytest.approx((N + 2) * 0.001)


coordinate = st.floats(-2, 2)
angle = st.floats(-200, 200)
waypoints = st.lists(
    st.tuples(coordinate, coordinate, coordinate, angle, st.floats(-85, 85), angle), min_size=2, max_size=4
)
rates = st.tuples(st.floats(0.05, 2), st.floats(0.1, 3), st.floats(0.2, 5), st.floats(0.5, 10), st.floats(5, 99))


@settings(max_examples=50, deadline=None)
@given(
    waypoints, rates, st.sampled_from([0.001, 0.01, 1 / 300]), st.sampled_from(Profile), st.sampled_from(RotationLaw)
)
def test_no_step_exceeds_its_cap_and_every_pose_is_met(
    values: list[tuple[float, ...]], caps: tuple[float, ...], h: float, profile: Profile, law: RotationLaw
) -> None:
    v, w, a, e, jerk = caps
    speeds = np.array([v, w, a, e, jerk, 2 * jerk])
    given_poses = [pose(f"p{i}", *row, dwell=0.5) for i, row in enumerate(values)]
    found = interpolate(route(*given_poses, speeds=speeds, h=h, profile=profile, law=law))
    assert steps(found.pose[:, :3]).max(initial=0) <= v * h * (1 + 1e-9)
    assert turn_steps(found).max(initial=0) <= w * h * (1 + 1e-9)
    assert np.abs(np.diff(found.pose, axis=0)).max() < np.pi or law is SLERP
    assert np.abs(rotation(found.pose[:, 3:]) - found.R).max() < 1e-9
    met = [0, *[piece.last for piece in found.pieces if piece.dwell][1:]]
    for row, waypoint in zip(met, given_poses, strict=True):
        assert np.array_equal(found.pose[row, :3], waypoint.pose[:3])
        assert np.abs(found.R[row] - rotation(waypoint.pose[3:])).max() < 1e-15 * (1 if law is SLERP else 9)
    if profile is THESIS:
        return
    second, third = np.diff(found.pose, 2, axis=0), np.diff(found.pose, 3, axis=0)
    assert np.linalg.norm(second[:, :3], axis=1).max(initial=0) <= a * h**2 * (1 + 1e-9) + 4e-15
    if law is TB:
        assert np.linalg.norm(second[:, 3:], axis=1).max(initial=0) <= e * h**2 * (1 + 1e-9) + 2e-14
    if profile is S_CURVE:
        assert np.linalg.norm(third[:, :3], axis=1).max(initial=0) <= jerk * h**3 * (1 + 1e-9) + 8e-15
        if law is TB:
            assert np.linalg.norm(third[:, 3:], axis=1).max(initial=0) <= 2 * jerk * h**3 * (1 + 1e-9) + 4e-14


@settings(max_examples=50, deadline=None)
@given(st.floats(1e-6, 0.5), st.floats(0.05, 3), st.sampled_from([0.001, 0.004]))
def test_the_thesis_law_takes_the_least_time_it_can(way: float, v: float, h: float) -> None:
    """Steps add up to the way; the cruise steps all equal v h, the two others are equal and shorter."""
    found = interpolate(route(pose("a"), pose("b", way), speeds=SPEEDS | {"v_max": v}, h=h))
    x = found.pose[:, 0]
    size = np.diff(x)
    assert x[-1] == way
    ratio = way / (v * h)
    assume(abs(ratio - round(ratio)) > 1e-8)
    assert len(size) == int(ratio) + 2
    np.testing.assert_allclose(size[1:-1], v * h, rtol=0, atol=1e-12)
    assert size[0] == pytest.approx(size[-1], abs=2e-15)
    assert 0 < size[0] < v * h


@pytest.mark.parametrize("x", [0.0, 1.0, 5.0, 50.0, 900.0])
@pytest.mark.parametrize("v", [0.001, 0.0101, 0.25])
@pytest.mark.parametrize("profile", list(Profile))
def test_large_coordinates_do_not_break_the_bound(x: float, v: float, profile: Profile) -> None:
    """1 mm/s is 1e-6 m per period; at 5 m a double is only good to 9e-16 m, 1e-9 of it."""
    speeds = SPEEDS | {"v_max": v}
    found = interpolate(route(pose("a", x, x), pose("b", x + 0.02, x), speeds=speeds, profile=profile))
    assert steps(found.pose[:, :3]).max() <= v * 0.001 * (1 + 1e-9)
    assert found.pose[-1, 0] == x + 0.02


@pytest.mark.parametrize(("profile", "caps"), [(TRAPEZOID, 2), (S_CURVE, 3)])
@pytest.mark.parametrize("way", [0.0004, 0.03, 0.5])
def test_ramps_take_the_least_whole_number_of_periods(profile: Profile, caps: int, way: float) -> None:
    wanted = route(pose("a"), pose("b", 0, way), profile=profile)
    found = interpolate(wanted)
    v, a, jerk = 0.1, 1.0, 20.0
    if profile is TRAPEZOID:
        least = way / v + v / a if way > v * v / a else 2 * np.sqrt(way / a)
    elif a * a / jerk < v and way >= v * (v / a + a / jerk):
        least = way / v + v / a + a / jerk
    else:
        assert way < 2 * a**3 / jerk**2
        least = 4 * np.cbrt(way / (2 * jerk)) if way == 0.0004 else 0
    if least == 0:
        pytest.fail("the closed form does not cover this way")
    assert found.duration == pytest.approx(np.ceil(least / 0.001) * 0.001)
    assert found.pose[0, 1] == 0
    assert found.pose[-1, 1] == way
    middle = found.pose[::-1, 1]
    assert found.pose[:, 1] == pytest.approx(way - middle, abs=1e-13)  # the same forwards and backwards


def test_a_phase_without_length_is_no_obstacle() -> None:
    """2 a³ / j² = 5 mm: the acceleration just builds up to its cap in 50 ms, four times."""
    found = interpolate(route(pose("a"), pose("b", 0.005), profile=S_CURVE))
    assert found.duration == pytest.approx(0.2, abs=1e-9)


def test_ramps_are_common_to_both_parts_and_named() -> None:
    """The turn's acceleration holds both back: 90° at 2 rad/s2 and no more than 0.5 rad/s."""
    wanted = route(pose("a"), pose("b", 0.01, 0, 0, 0, 0, 90), pose("c", 0.011, 0, 0, 0, 0, 90), profile=TRAPEZOID)
    found = interpolate(wanted)
    rows = slice(0, found.pieces[0].last + 1)
    assert found.pose[rows, 0] / 0.01 == pytest.approx(found.pose[rows, 5] / (90 * DEG), abs=1e-14)
    assert [fact.binds for fact in planned(wanted)[1]] == ["omega_max", "a_max"]
    smooth = replace(wanted, profile=S_CURVE)
    assert [fact.binds for fact in planned(smooth)[1]] == ["omega_max", "jerk"]


def test_slerp_is_scipys() -> None:
    a, b = pose("a", 0, 0, 0, 30, 120, -50), pose("b", 0, 0, 0.01, -100, 20, 77)
    found = interpolate(route(a, b, law=SLERP))
    ends = Rotation.from_euler("xyz", [a.pose[3:], b.pose[3:]])
    share = found.pose[:, 2] / 0.01
    wanted = Slerp([0, 1], ends)(share).as_matrix()
    assert np.abs(found.R - wanted).max() < 1e-13
    assert np.abs(np.diff(found.pose[:, 3:], axis=0)).max() < 0.01
    assert found.pose[0, 3:] == pytest.approx(a.pose[3:], abs=0)
    _, (fact,) = planned(route(a, b, law=SLERP))
    assert fact.L_theta == pytest.approx((ends[0].inv() * ends[1]).magnitude(), rel=1e-12)
    assert fact.omega_top == pytest.approx(0.5, rel=1e-9)


def test_slerp_goes_through_the_lock_where_the_angles_may_not() -> None:
    wanted = route(pose("a", 0, 0, 0, 0, 60, 0), pose("b", 0, 0, 0, 0, 120, 0), law=SLERP)
    found = interpolate(wanted)
    assert found.pose[-1, 3:] == pytest.approx([0, 120 * DEG, 0], abs=1e-12)
    assert found.pose[:, 4] == pytest.approx(np.sort(found.pose[:, 4]), abs=0)
    assert found.notes == ()
    with pytest.raises(InputError, match=r"^cube\.yaml:8: pose b: beta is 120°, at most 85° in size: nearer to 90°"):
        interpolate(replace(wanted, rotation=TB))


def test_slerp_by_half_a_turn_is_the_same_every_time_and_said() -> None:
    for sign in (1, -1):
        found = interpolate(route(pose("a", 0, 0, 0, 0, 0, 20), pose("b", 0, 0, 0, 0, 0, 20 + sign * 180), law=SLERP))
        assert found.pose[-1, 5] == pytest.approx(200 * DEG, abs=1e-12)
        assert (
            "segment a -> b: the tool turns half a revolution, about (0, 0, 1); the other way is as short"
            in found.notes
        )
        assert turn_steps(found).max() <= 0.0005 * (1 + 1e-9)


@pytest.mark.parametrize(
    ("start", "goal", "end", "note"),
    [
        (
            170,
            -170,
            190,
            "segment a -> b: gamma turns +20° through 180°, not -340°; the sequence goes on counting to 190°",
        ),
        (-170, 170, -190, "gamma turns -20° through -180°, not +340°; the sequence goes on counting to -190°"),
        (0, 350, -10, "gamma turns -10°, not +350°; the sequence goes on counting to -10°"),
        (0, 180, 180, None),
        (0, -180, -180, None),
        (190, 10, 10, None),
        (100, -80, -80, None),
        (-170, 730, 10, "gamma turns +180°, not +900°; the sequence goes on counting to 10°"),
    ],
)
def test_the_shorter_way_is_taken_and_said(start: float, goal: float, end: float, note: str | None) -> None:
    found = interpolate(route(pose("a", 0, 0, 0, 0, 0, start), pose("b", 0, 0, 0, 0, 0, goal)))
    assert found.pose[-1, 5] == pytest.approx(end * DEG, abs=1e-12)
    assert np.all(np.diff(found.pose[:, 5]) * (end - start) > 0)
    assert [message.endswith(note or "") for message in found.notes] == ([] if note is None else [True])


def test_later_segments_count_on_and_alpha_wraps_too() -> None:
    values = [(170, 170), (-170, -160), (-100, -100), (160, 100)]
    rows = [pose(name, 0, 0, 0, alpha, 10, gamma) for name, (alpha, gamma) in zip("abcd", values, strict=True)]
    found = interpolate(route(*rows))
    ends = np.array([found.pose[piece.last, 3:] for piece in found.pieces]) / DEG
    assert ends == pytest.approx(np.array([[190, 10, 200], [260, 10, 260], [160, 10, 100]]), abs=1e-12)
    assert found.R[-1] == pytest.approx(rotation(rows[-1].pose[3:]), abs=1e-15)
    assert np.array_equal(found.pose[-1], rows[-1].pose)
    assert [note.split(":")[0] for note in found.notes] == ["segment a -> b"] * 2 + ["segment c -> d"] * 2


def test_dwells_stand_and_are_rounded_up_with_a_note() -> None:
    wanted = route(pose("a", dwell=0.003), pose("b", 0.001, dwell=0.0025), pose("c", 0.001, dwell=0.001), h=0.001)
    found = interpolate(wanted)
    assert found.pieces == (
        Piece(0, 3, "a", "a", True),
        Piece(3, 13, "a", "b"),
        Piece(13, 16, "b", "b", True),
        Piece(16, 17, "c", "c", True),
    )
    assert np.all(found.pose[13:] == found.pose[13])
    assert found.notes == ("pose b: the dwell of 0.0025 s is rounded up to 0.003 s, 3 periods of 0.001 s",)
    facts = planned(wanted)[1]
    assert [(fact.duration, fact.dwell, fact.binds) for fact in facts] == [(0.01, 0.003, "v_max"), (0.0, 0.001, "")]


@pytest.mark.parametrize("law", list(RotationLaw))
def test_pure_translation_and_pure_rotation_need_no_cap_of_the_other_part(law: RotationLaw) -> None:
    each = np.array([[0.1, 0.0, 1.0, np.nan, 9.0, np.nan], [0.0, 0.5, np.nan, 1.0, np.nan, 9.0]])
    for profile in Profile:
        wanted = route(pose("a"), pose("b", 0.1), pose("c", 0.1, 0, 0, 30), speeds=each, profile=profile, law=law)
        found = interpolate(wanted)
        middle = found.pieces[0].last
        assert np.all(found.pose[:middle, 3:] == 0)
        assert np.all(found.pose[middle:, :3] == [0.1, 0, 0])
        assert found.pose[-1, 3:] == pytest.approx([30 * DEG, 0, 0], abs=1e-15)


@pytest.mark.parametrize(
    ("asked", "message"),
    [
        (route(pose("a")), "cube.yaml:7: 1 pose; a path needs at least 2"),
        (
            route(pose("a"), pose("b", 0.2), speeds=SPEEDS | {"v_max": 0.0}),
            "cube.yaml:8: segment a -> b: v_max is 0 m/s with 0.2 m to go; give a finite cap above zero",
        ),
        (
            route(pose("a"), pose("b", 0.2, 0, 0, 90), speeds=SPEEDS | {"omega_max": np.inf}),
            "cube.yaml:8: segment a -> b: omega_max is inf rad/s with 1.5708 rad to go; give a finite cap above zero",
        ),
        (
            route(pose("a"), pose("b", 0.2), speeds=SPEEDS | {"v_max": np.nan}),
            "cube.yaml:8: segment a -> b: v_max [m/s] is missing; profile thesis needs it with 0.2 m to go",
        ),
        (
            route(pose("a"), pose("b", 0.2), speeds=SPEEDS | {"omega_max": -1.0}),
            "cube.yaml:8: segment a -> b: omega_max is -1 rad/s with 0 rad to go; give a finite cap above zero",
        ),
        (
            route(pose("a"), pose("b", 0.2), speeds=SPEEDS | {"a_max": np.nan}, profile=TRAPEZOID),
            "cube.yaml:8: segment a -> b: a_max [m/s2] is missing; profile trapezoid needs it with 0.2 m to go",
        ),
        (
            route(pose("a"), pose("b", 0, 0, 0, 9), speeds=SPEEDS | {"angular_jerk": np.nan}, profile=S_CURVE),
            "cube.yaml:8: segment a -> b: angular_jerk [rad/s3] is missing; profile s-curve needs it with "
            "0.15708 rad to go",
        ),
        (
            route(pose("a", 1), pose("b", 1, 0, 0, 0, 0, 360)),
            "cube.yaml:8: pose b repeats pose a: give it a dwell, or remove it",
        ),
        (
            route(pose("a"), pose("b", 0, 0, 0, 0, -85.5)),
            "cube.yaml:8: pose b: beta is -85.5°, at most 85° in size: nearer to 90° the angles lock; turn the pose, "
            "or take rotation: slerp, which has no such limit",
        ),
        (
            route(pose("a"), pose("b", 0.2, dwell=-1.0)),
            "cube.yaml:8: pose b: the dwell is -1 s; give a time of 0 s or more",
        ),
        (route(pose("a"), pose("b", 0.2), h=0.0), "h is 0 s; give a period above zero, for example 0.001 s"),
        (route(pose("a"), pose("b", 0.2), h=np.nan), "h is nan s; give a period above zero, for example 0.001 s"),
        (
            route(pose("a"), pose("b", 0.2), speeds=SPEEDS | {"v_max": 1e-9}),
            "cube.yaml:8: segment a -> b takes 2e+11 periods of 0.001 s, the sequence 2e+11, at most 5e+06; give a "
            "higher speed, a shorter dwell or a longer period",
        ),
        (
            route(pose("a"), pose("b", 0.2, dwell=1e4)),
            "cube.yaml:8: the dwell at pose b takes 1e+07 periods of 0.001 s, the sequence 1e+07, at most 5e+06; give "
            "a higher speed, a shorter dwell or a longer period",
        ),
        (
            route(pose("a", 1e9), pose("b", 1e9 + 0.01), speeds=SPEEDS | {"v_max": 0.001}),
            "cube.yaml:8: segment a -> b: 1e-06 m and 0 rad per period are lost in the rounding of coordinates this "
            "large; give higher speeds, or coordinates from a nearer origin",
        ),
    ],
)
def test_what_cannot_be_travelled_is_one_line(asked: Route, message: str) -> None:
    with pytest.raises(InputError) as caught:
        interpolate(asked)
    assert str(caught.value) == message


def test_85_degrees_are_allowed_and_repeats_with_a_dwell_are_legal() -> None:
    found = interpolate(route(pose("a", 0, 0, 0, 0, 85), pose("b", 0, 0, 0, 0, -85)))
    assert np.abs(found.pose[:, 4]).max() == 85 * DEG
    wanted = route(pose("a"), pose("b", 0, 0, 0, 360, dwell=0.002))
    found = interpolate(wanted)
    assert np.array_equal(found.pose, np.zeros((3, 6)))
    assert found.notes == ("segment a -> b: alpha stays, +360° is a whole turn; the sequence counts 0°",)
    assert planned(wanted)[1][0].dwell == 0.002
