"""Ways on a work object that turns meanwhile: where the tool is, how fast, and the same as an expression."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from path_checks import check_expression, check_slopes, random_pose, seeds

from trajopt_cli.geometry import Array
from trajopt_cli.path.arc import Arc, ArcSymbols
from trajopt_cli.path.line import Line, LineSymbols
from trajopt_cli.path.segment import over_work
from trajopt_cli.path.turning import Turn, Turning, TurningSymbols, turned_back

S = np.linspace(0, 1, 41)


def unit(rng: np.random.Generator) -> Array:
    u = rng.normal(size=3)
    return np.asarray(u / np.linalg.norm(u))


def some(rng: np.random.Generator, axes: int, round_: bool) -> Turning:
    turns = tuple(Turn(rng.uniform(-0.5, 0.5, 3), unit(rng), float(rng.uniform(-3, 3))) for _ in range(axes))
    X_0, X_1 = random_pose(rng), random_pose(rng)
    return Turning(Arc.through(X_0, rng.uniform(-0.5, 0.5, 3), X_1) if round_ else Line(X_0, X_1), turns)


@given(seeds, st.integers(1, 2), st.booleans())
@settings(max_examples=30)
def test_slopes_are_those_of_the_poses(seed: int, axes: int, round_: bool) -> None:
    rng = np.random.default_rng(seed)
    segment = some(rng, axes, round_)
    check_slopes(segment, rng, 2e3 * (1 + segment.length + segment.angle) ** 4)


@given(seeds, st.integers(1, 2), st.booleans())
@settings(max_examples=15)
def test_the_expression_says_what_the_numbers_say(seed: int, axes: int, round_: bool) -> None:
    rng = np.random.default_rng(seed)
    segment = some(rng, axes, round_)
    assert segment.symbols == TurningSymbols(ArcSymbols() if round_ else LineSymbols(), axes)
    check_expression(segment, rng)


def test_a_point_on_the_table_stays_on_a_circle() -> None:
    """The tool rests over the work: round the table's axis, counterclockwise, at the axis' own rate."""
    p, X = np.array([0.6, 0.5, 0.1]), np.eye(4)
    X[:3, 3] = p + np.array([0.2, 0.0, 0.3])
    quarter = Turning(Line(X, X), (Turn(p, np.array([0.0, 0.0, 1.0]), np.pi / 2),))
    found, twist = quarter.pose(S), quarter.twist(S)
    np.testing.assert_allclose(found[:, :3, 3], p + np.c_[0.2 * np.cos(S * np.pi / 2), 0.2 * np.sin(S * np.pi / 2),
                                                          np.full(len(S), 0.3)], atol=1e-15)  # fmt: skip
    np.testing.assert_allclose(np.linalg.norm(twist[:, :3], axis=1), 0.2 * np.pi / 2, atol=1e-15)
    np.testing.assert_allclose(twist[:, 3:], np.tile([0, 0, np.pi / 2], (len(S), 1)), atol=1e-15)
    np.testing.assert_allclose(found[-1, :3, :3], [[0, -1, 0], [1, 0, 0], [0, 0, 1]], atol=1e-15)
    assert (quarter.length, quarter.angle) == (0.0, 0.0)


def test_a_line_against_the_table_may_stand_still_in_the_world() -> None:
    """The work goes away under the tool: once round the rim of a disc the tool stays where it is."""
    p, u = np.array([0.1, -0.2, 0.3]), np.array([0.0, 0.0, 1.0])
    X_0, X_V, X_1 = (np.eye(4) for _ in range(3))
    for X, angle in ((X_0, 0.0), (X_V, -1.0), (X_1, -2.0)):
        X[:3, :3] = pin.exp3(angle * u)
        X[:3, 3] = p + X[:3, :3] @ [0.25, 0.0, 0.0]
    still = Turning(Arc.through(X_0, X_V[:3, 3], X_1), (Turn(p, u, 2.0),))
    np.testing.assert_allclose(still.pose(S), np.tile(X_0, (len(S), 1, 1)), atol=1e-14)
    np.testing.assert_allclose(still.twist(S), 0, atol=1e-14)
    np.testing.assert_allclose(still.twist_rate(S), 0, atol=1e-13)
    assert still.length == pytest.approx(0.5)  # what the tool does over the work


@given(seeds)
@settings(max_examples=30)
def test_two_axes_are_a_tilting_table(seed: int) -> None:
    """Against a chain of frames, the second axis on the first one, both turning evenly."""
    rng = np.random.default_rng(seed)
    base, link, on = (pin.SE3(random_pose(rng)) for _ in range(3))
    start, angle, way = rng.uniform(-2, 2, 2), rng.uniform(-2, 2, 2), rng.uniform(-0.3, 0.3, 3)

    def about(value: float) -> pin.SE3:
        return pin.SE3(pin.AngleAxis(value, np.array([0.0, 0, 1])).matrix(), np.zeros(3))

    def work(s: float) -> pin.SE3:
        return base * about(start[0] + s * angle[0]) * link * about(start[1] + s * angle[1]) * on

    axes = base, base * about(start[0]) * link
    turns = tuple(Turn(M.translation, M.rotation[:, 2], float(a)) for M, a in zip(axes, angle, strict=True))
    X_0, X_1 = work(0.0).homogeneous, (work(1.0) * pin.SE3(np.eye(3), way)).homogeneous
    segment = Turning(Line(X_0, turned_back(turns, X_1)), turns)
    for s, X in zip(S, segment.pose(S), strict=True):
        np.testing.assert_allclose(X, (work(s) * pin.SE3(np.eye(3), s * way)).homogeneous, atol=1e-12)
    assert segment.length == pytest.approx(np.linalg.norm(way))


def test_caps_hold_for_what_the_tool_does_over_the_work() -> None:
    rng = np.random.default_rng(3)
    over, line = some(rng, 1, False), Line(random_pose(rng), random_pose(rng))
    shares = [S[:3], S[:4]]
    twist, bend = (np.vstack([getattr(over, name)(shares[0]), getattr(line, name)(shares[1])])
                   for name in ("twist", "twist_rate"))  # fmt: skip
    seen = over_work([over, line], shares, twist, bend)
    np.testing.assert_array_equal(seen[0], np.vstack([over.path.twist(shares[0]), twist[3:]]))
    np.testing.assert_array_equal(seen[1], np.zeros((7, 6)))
    assert bend[:3].any()


def test_where_nothing_turns_caps_hold_for_what_there_is() -> None:
    rng = np.random.default_rng(4)
    line, s = Line(random_pose(rng), random_pose(rng)), np.linspace(0, 1, 4)
    twist, bend = rng.normal(size=(2, 4, 6))
    for found, wanted in zip(over_work([line], [s], twist, bend), (twist, bend), strict=True):
        np.testing.assert_array_equal(found, wanted)
