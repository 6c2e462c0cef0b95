"""Arcs against circles drawn by rotation, SciPy's slerp and central differences; what is no circle is refused."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from path_checks import check_expression, check_part, check_same_way, check_slopes, random_pose, seeds
from scipy.spatial.transform import Rotation, Slerp

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, pose
from trajopt_cli.motion import CirPathMode
from trajopt_cli.path.arc import Arc, ArcSymbols
from trajopt_cli.path.circle import circle_through

S = np.linspace(0, 1, 21)


def drawn(rng: np.random.Generator, sweep: float, share: float = 0.4) -> tuple[Array, Array, Array, Array, float]:
    """X_0, via, X_1 of an arc of that sweep [rad] in any plane; its frame X (circle about z) and radius."""
    X, radius = random_pose(rng), float(rng.uniform(0.02, 0.6))

    def at(angle: float) -> Array:
        return X[:3, :3] @ [radius * np.cos(angle), radius * np.sin(angle), 0] + X[:3, 3]

    R_0 = random_pose(rng)[:3, :3]
    R_1 = R_0 @ Rotation.from_rotvec(rng.uniform(-1, 1, 3)).as_matrix()
    return pose(R_0, at(0)), at(share * sweep), pose(R_1, at(sweep)), X, radius


@given(seeds, st.floats(0.05, 2 * np.pi - 0.05), st.floats(0.1, 0.9))
@settings(max_examples=80)
def test_an_arc_runs_evenly_on_its_circle(seed: int, sweep: float, share: float) -> None:
    X_0, via, X_1, X, radius = drawn(np.random.default_rng(seed), sweep, share)
    arc = Arc.through(X_0, via, X_1)
    assert arc.sweep == pytest.approx(sweep, abs=1e-7)
    assert arc.radius == pytest.approx(radius, rel=1e-7)
    assert arc.length == pytest.approx(radius * sweep, rel=1e-7)
    np.testing.assert_allclose(arc.normal, X[:3, 2], rtol=0, atol=1e-7)
    got = arc.pose(S)
    local = np.column_stack([radius * np.cos(S * sweep), radius * np.sin(S * sweep), 0 * S])
    np.testing.assert_allclose(got[:, :3, 3], local @ X[:3, :3].T + X[:3, 3], rtol=0, atol=1e-7)
    slerp = Slerp([0, 1], Rotation.from_matrix([X_0[:3, :3], X_1[:3, :3]]))
    np.testing.assert_allclose(got[:, :3, :3], slerp(S).as_matrix(), rtol=0, atol=1e-12)
    assert arc.angle == pytest.approx((slerp(0.0).inv() * slerp(1.0)).magnitude(), abs=1e-12)
    np.testing.assert_allclose(got[[0, -1]], [X_0, X_1], rtol=0, atol=1e-12 / min(share, 1 - share) / sweep**2)


@given(seeds, st.floats(0.3, 6.0))
@settings(max_examples=20)
def test_slopes_of_an_arc(seed: int, sweep: float) -> None:
    rng = np.random.default_rng(seed)
    X_0, via, X_1, _, radius = drawn(rng, sweep)
    check_slopes(Arc.through(X_0, via, X_1), rng, bound=1.01 * radius * (sweep**3 / 24 + sweep**4 / 12))


@given(seeds, st.floats(0.3, 6.0), st.sampled_from([CirPathMode.OBJECT_FRAME, CirPathMode.PATH_FRAME]))
@settings(max_examples=10)
def test_part_of_an_arc(seed: int, sweep: float, mode: CirPathMode) -> None:
    rng = np.random.default_rng(seed)
    X_0, via, X_1, _, _ = drawn(rng, sweep)
    check_part(Arc.through(X_0, pose(X_0[:3, :3], via), X_1, mode), rng)


def test_an_arc_that_turns_through_its_circle_point_has_no_parts() -> None:
    X_0, _, X_1, _, _ = drawn(np.random.default_rng(2), 2.0)
    arc = Arc.through(X_0, random_pose(np.random.default_rng(5)), X_1, CirPathMode.CIR_POINT_ORI)
    assert not arc.evenly_turned
    with pytest.raises(NotImplementedError):
        arc.between(0.1, 0.9)


@given(seeds, st.floats(0.3, 6.0))
@settings(max_examples=50)
def test_an_arc_is_the_same_in_any_frame_and_backwards(seed: int, sweep: float) -> None:
    rng = np.random.default_rng(seed)
    X_0, via, X_1, _, _ = drawn(rng, sweep, 0.5)
    arc, X = Arc.through(X_0, via, X_1), random_pose(rng)
    seen = Arc.through(X @ X_0, X[:3, :3] @ via + X[:3, 3], X @ X_1)
    check_same_way(arc, seen, X, atol=1e-11)
    check_same_way(arc, Arc.through(X_1, via, X_0), np.eye(4), backwards=True, atol=1e-11)


@pytest.mark.parametrize("turning", [True, False])
def test_the_expression_of_an_arc_says_what_its_numbers_say(turning: bool) -> None:
    rng = np.random.default_rng(1)
    for sweep in (0.3, 2.0, 3.5, 6.0):
        X_0, via, X_1, _, _ = drawn(rng, sweep)
        arc = Arc.through(X_0, via, X_1 if turning else pose(X_0[:3, :3], X_1[:3, 3]))
        assert arc.symbols == ArcSymbols(turning)
        check_expression(arc, rng)


@given(seeds, st.floats(0.05, 2 * np.pi - 0.05), st.floats(0.1, 0.9))
@settings(max_examples=40)
def test_a_circle_in_plain_floats(seed: int, sweep: float, share: float) -> None:
    X_0, via, X_1, X, radius = drawn(np.random.default_rng(seed), sweep, share)
    start = tuple(X_0[:3, 3].tolist())
    found = circle_through(start, tuple(via.tolist()), tuple(X_1[:3, 3].tolist()))
    assert found is not None
    np.testing.assert_allclose(found.centre, X[:3, 3], rtol=0, atol=1e-7)
    np.testing.assert_allclose(found.axis, X[:3, 2], rtol=0, atol=1e-7)
    assert found.angle == pytest.approx(sweep, abs=1e-7)
    assert np.linalg.norm(np.subtract(start, found.centre)) == pytest.approx(radius, abs=1e-7)


@pytest.mark.parametrize("size", [1e-3, 1.0, 300.0])
def test_how_straight_three_points_may_be(size: float) -> None:
    """By the sine between the chords to the second and to the third point, in any unit."""
    for sine, there in ((1.01e-9, True), (0.99e-9, False)):
        points = (0.0, 0.0, 0.0), (size, 0.0, 0.0), (3 * size, 3 * size * sine, 0.0)
        assert (circle_through(*points) is not None) == there


@pytest.mark.parametrize(
    ("via", "end"),
    [
        ((0.1, 0.1, 0.1), (0.2, 0.2, 0.2)),
        ((0.2, 0.2, 0.2), (0.1, 0.1, 0.1)),
        ((0.0, 0.0, 0.0), (0.2, 0.0, 0.0)),
        ((0.2, 0.0, 0.0), (0.2, 0.0, 0.0)),
        ((0.2, 0.0, 0.0), (0.0, 0.0, 0.0)),
    ],
    ids=["on one line", "behind the end", "via at start", "via at end", "end at start"],
)
def test_what_is_no_circle_is_refused(via: tuple[float, ...], end: tuple[float, ...]) -> None:
    with pytest.raises(InputError, match="no circle leads through three points on one line") as error:
        Arc.through(np.eye(4), np.array(via), pose(np.eye(3), end))
    said = ", ".join(f"[{x * 1e3:.3f}, {y * 1e3:.3f}, {z * 1e3:.3f}]" for x, y, z in ((0, 0, 0), via, end))
    assert said in str(error.value)
    assert str(error.value).endswith("move the point on the way, or use MoveL")
