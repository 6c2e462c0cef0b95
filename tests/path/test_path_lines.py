"""Lines and dwells against chord, SciPy's slerp and central differences, in any frame and in both directions."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
from hypothesis import given, settings
from path_checks import check_expression, check_part, check_same_way, check_slopes, random_pose, seeds
from scipy.spatial.transform import Rotation, Slerp

from trajopt_cli.geometry import Array, pose
from trajopt_cli.path.line import Line, LineSymbols
from trajopt_cli.path.segment import along_all, check_fractions
from trajopt_cli.path.symbols import Layout

S = np.linspace(0, 1, 21)


def some_line(rng: np.random.Generator) -> Line:
    """Any line that does not turn by half a turn, where two ways are the shorter one."""
    X_0, X_1 = random_pose(rng), random_pose(rng)
    turn = Rotation.from_matrix(X_0[:3, :3].T @ X_1[:3, :3]).as_rotvec() * rng.uniform(0, 0.95)
    return Line(X_0, pose(X_0[:3, :3] @ Rotation.from_rotvec(turn).as_matrix(), X_1[:3, 3]))


@given(seeds)
@settings(max_examples=50)
def test_a_line_is_chord_and_slerp(seed: int) -> None:
    line = some_line(np.random.default_rng(seed))
    X = line.pose(S)
    slerp = Slerp([0, 1], Rotation.from_matrix([line.X_0[:3, :3], line.X_1[:3, :3]]))
    np.testing.assert_allclose(X[:, :3, :3], slerp(S).as_matrix(), rtol=0, atol=1e-12)
    for share, p in zip(S, X[:, :3, 3], strict=True):
        np.testing.assert_allclose(p, (1 - share) * line.X_0[:3, 3] + share * line.X_1[:3, 3], rtol=0, atol=1e-15)
    assert np.all(X[:, 3] == [0, 0, 0, 1])
    assert line.length == pytest.approx(np.linalg.norm(line.X_1[:3, 3] - line.X_0[:3, 3]), rel=1e-14)
    turn = Rotation.from_matrix(line.X_1[:3, :3] @ line.X_0[:3, :3].T)
    assert line.angle == pytest.approx(turn.magnitude(), abs=1e-12)
    np.testing.assert_allclose(line.turn, turn.as_rotvec(), rtol=0, atol=1e-11)
    assert line.breaks.shape == (0,)


@given(seeds)
@settings(max_examples=20)
def test_slopes_of_a_line(seed: int) -> None:
    rng = np.random.default_rng(seed)
    line = some_line(rng)
    check_slopes(line, rng, bound=0.0)  # twists are constant


@given(seeds)
@settings(max_examples=10)
def test_part_of_a_line(seed: int) -> None:
    rng = np.random.default_rng(seed)
    check_part(some_line(rng), rng)


@given(seeds)
@settings(max_examples=50)
def test_a_line_is_the_same_in_any_frame_and_backwards(seed: int) -> None:
    rng = np.random.default_rng(seed)
    line, X = some_line(rng), random_pose(rng)
    check_same_way(line, Line(X @ line.X_0, X @ line.X_1), X)
    check_same_way(line, Line(line.X_1, line.X_0), np.eye(4), backwards=True)


@pytest.mark.parametrize("turning", [True, False])
def test_the_expression_of_a_line_says_what_its_numbers_say(turning: bool) -> None:
    rng = np.random.default_rng(1)
    for _ in range(8):
        line = some_line(rng)
        if not turning:
            line = Line(line.X_0, pose(line.X_0[:3, :3], line.X_1[:3, 3]))
        assert (line.symbols, line.symbols.size) == (LineSymbols(turning), 22)
        check_expression(line, rng)


def test_many_lines_at_once_are_lines() -> None:
    rng = np.random.default_rng(2)
    X = random_pose(rng)
    lines = [some_line(rng) for _ in range(20)]
    lines += [Line(X, X), Line(X, pose(X[:3, :3], [1, 2, 3])), Line(X, pose(random_pose(rng)[:3, :3], X[:3, 3]))]
    together = along_all(lines, [S] * len(lines))[0].reshape(len(lines), len(S), 4, 4)
    for line, poses in zip(lines, together, strict=True):
        np.testing.assert_allclose(poses, line.pose(S), rtol=0, atol=1e-14)


def test_on_a_line_of_no_length_the_tool_rests() -> None:
    rng = np.random.default_rng(3)
    X = random_pose(rng)
    dwell = Line(X, X)
    assert (dwell.length, dwell.angle) == (0, pytest.approx(0, abs=1e-15))
    np.testing.assert_allclose(dwell.pose(S), np.broadcast_to(X, (21, 4, 4)), rtol=0, atol=1e-15)
    check_slopes(dwell, rng, bound=0.0)
    check_expression(dwell, rng)
    P, S0 = ca.SX.sym("p", 22), ca.SX.sym("s")
    assert not ca.depends_on(ca.veccat(*LineSymbols(False).flange(P, 0.0)), S0)


def test_what_is_no_part_of_a_segment() -> None:
    check_fractions(1.0, 1e-12)
    for fraction in (0.0, -0.1, 1 + 1e-12, np.nan):
        with pytest.raises(ValueError, match="is no fraction of a segment; give one above 0 and up to 1"):
            check_fractions(0.5, fraction)


def test_a_layout_refuses_what_it_does_not_know() -> None:
    layout = Layout({"a": (), "M": (2, 2), "v": (3,)})
    M: Array = np.array([[1.0, 2], [3, 4]])
    p = layout.vector({"a": 9.0, "M": M, "v": [5, 6, 7]})
    np.testing.assert_array_equal(p, [9, 1, 3, 2, 4, 5, 6, 7])
    P = ca.SX.sym("p", layout.size)
    back = ca.Function("back", [P], [layout.split(P)["a"], layout.split(P)["M"], layout.split(P)["v"]])(p)
    for found, wanted in zip(back, (9.0, M, [5, 6, 7]), strict=True):
        np.testing.assert_array_equal(np.squeeze(found.full()), wanted)
    with pytest.raises(ValueError, match="the parts are a, M, v; found a, M"):
        layout.vector({"a": 9.0, "M": M})
    with pytest.raises(ValueError, match=r"v has shape \(2,\), wanted \(3,\)"):
        layout.vector({"a": 9.0, "M": M, "v": [5, 6]})
    with pytest.raises(ValueError, match="7 parameters, wanted 8: a, M, v"):
        layout.split(ca.SX.sym("p", 7))
