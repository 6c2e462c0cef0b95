"""What every kind of segment must fulfil: slopes that are slopes, expressions that say what the numbers say."""

from __future__ import annotations

import casadi as ca
import numpy as np
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from trajopt_cli.geometry import Array, inverse_pose, pose
from trajopt_cli.path.segment import Segment
from trajopt_cli.path.symbols import Symbols

STEPS = (1e-3, 3e-4, 1e-4)  # of s, for central differences


def random_pose(rng: np.random.Generator, size: float = 0.5) -> Array:
    return pose(Rotation.random(rng=rng).as_matrix(), rng.uniform(-size, size, 3))


seeds = st.integers(0, 2**32 - 1)


def inside(segment: Segment, rng: np.random.Generator, n: int = 25) -> Array:
    """Shares away from breaks and ends by more than the largest step."""
    s = rng.uniform(0.01, 0.99, n)
    near = np.abs(s[:, None] - segment.breaks[None]).min(axis=1, initial=1.0)
    return s[near > 5e-3]


def differences(segment: Segment, s: Array, h: float) -> tuple[Array, Array]:
    """Twist and twist rate (n, 6) by central differences of poses and of the twist they give."""

    def slope(at: Array) -> Array:
        before, after = segment.pose(at - h / 2), segment.pose(at + h / 2)
        turned = Rotation.from_matrix(after[:, :3, :3] @ np.swapaxes(before[:, :3, :3], 1, 2)).as_rotvec()
        return np.hstack([after[:, :3, 3] - before[:, :3, 3], turned]) / h

    return slope(s), (slope(s + h / 2) - slope(s - h / 2)) / h


def check_slopes(segment: Segment, rng: np.random.Generator, bound: float) -> None:
    """Differences come nearer with the square of the step, up to rounding; bound: on the third and fourth slopes."""
    s = inside(segment, rng)
    twist, rate = segment.twist(s), segment.twist_rate(s)
    assert twist.shape == rate.shape == (len(s), 6)
    for h in STEPS:
        first, second = differences(segment, s, h)
        np.testing.assert_allclose(first, twist, rtol=0, atol=bound * h**2 + 4e-15 / h)
        np.testing.assert_allclose(second, rate, rtol=0, atol=bound * h**2 + 16e-15 / h**2)


def check_expression(segment: Segment, rng: np.random.Generator, symbols: Symbols | None = None) -> None:
    """The flange as an expression, and CasADi's slopes of it, against the segment's numbers. symbols: those of a kind
    that serves it, too."""
    X_BA, X_FT, symbols = random_pose(rng), random_pose(rng, 0.2), symbols or segment.symbols
    p = segment.parameters(X_BA, X_FT)
    P, S = ca.SX.sym("p", symbols.size), ca.SX.sym("s")
    position, rotation = symbols.flange(P, S)
    tool = position + rotation @ ca.DM(X_FT[:3, 3])
    way, spin = ca.jacobian(tool, S), rotation @ ca.DM(X_FT[:3, :3])
    W = ca.reshape(ca.jacobian(ca.vec(spin), S), 3, 3) @ spin.T
    omega = ca.vertcat(W[2, 1], W[0, 2], W[1, 0])
    flange = ca.Function("flange", [P, S], [position, rotation])
    slopes = ca.Function("slopes", [P, S], [ca.vertcat(way, omega), ca.jacobian(ca.vertcat(way, omega), S)])
    s = np.concatenate([[0.0, 1.0], inside(segment, rng)])
    wanted = X_BA @ segment.pose(s) @ inverse_pose(X_FT)
    turn = np.kron(np.eye(2), X_BA[:3, :3])
    for share, X, twist, rate in zip(s, wanted, segment.twist(s), segment.twist_rate(s), strict=True):
        at, R = flange(p, share)
        np.testing.assert_allclose(at.full().ravel(), X[:3, 3], rtol=0, atol=1e-13)
        np.testing.assert_allclose(R.full(), X[:3, :3], rtol=0, atol=1e-13)
        first, second = slopes(p, share)
        np.testing.assert_allclose(first.full().ravel(), turn @ twist, rtol=0, atol=1e-11)
        np.testing.assert_allclose(second.full().ravel(), turn @ rate, rtol=0, atol=1e-10)
    check_curve(segment, X_BA, X_FT, symbols, s)


def check_curve(segment: Segment, X_BA: Array, X_FT: Array, symbols: Symbols, s: Array) -> None:
    """What limits of the tool are held against in a corner: its slopes in the base's frame, its turning in its own."""
    P, S = ca.SX.sym("p", symbols.size), ca.SX.sym("s")
    curve = symbols.curve(P, S)
    if curve is None:
        return
    of, R_BA, p = ca.Function("curve", [P, S], [*curve]), X_BA[:3, :3], segment.parameters(X_BA, X_FT)
    for share, X, twist, rate in zip(s, segment.pose(s), segment.twist(s), segment.twist_rate(s), strict=True):
        tangent, bend, turn = (one.full().ravel() for one in of(p, share))
        np.testing.assert_allclose(tangent, R_BA @ twist[:3], rtol=0, atol=1e-12)
        np.testing.assert_allclose(bend, R_BA @ rate[:3], rtol=0, atol=1e-11)
        np.testing.assert_allclose(turn, X_FT[:3, :3] @ X[:3, :3].T @ twist[3:], rtol=0, atol=1e-12)


def check_part(segment: Segment, rng: np.random.Generator) -> None:
    """A part goes where the whole does, with rates of its own s."""
    a, b = np.sort(rng.uniform(0, 1, 2))
    part, s = segment.between(a, b), np.linspace(0, 1, 13)
    at = a + (b - a) * s
    np.testing.assert_allclose(part.pose(s), segment.pose(at), rtol=0, atol=1e-12)
    np.testing.assert_allclose(part.twist(s), (b - a) * segment.twist(at), rtol=0, atol=1e-9)


def check_same_way(one: Segment, other: Segment, X: Array, backwards: bool = False, atol: float = 1e-12) -> None:
    """other is the segment one seen from another frame (X: A in it), or run backwards."""
    s = np.linspace(0, 1, 21)
    t, sign = (1 - s, -1.0) if backwards else (s, 1.0)
    turn = np.kron(np.eye(2), X[:3, :3])
    np.testing.assert_allclose(other.pose(s), X @ one.pose(t), rtol=0, atol=atol)
    np.testing.assert_allclose(other.twist(s), sign * one.twist(t) @ turn.T, rtol=0, atol=10 * atol)
    inner = [i for i, share in enumerate(s) if np.abs(one.breaks - t[i]).min(initial=1.0) > 1e-6]
    np.testing.assert_allclose(other.twist_rate(s)[inner], (one.twist_rate(t) @ turn.T)[inner], rtol=0, atol=100 * atol)
    assert abs(other.length - one.length) < 10 * atol
    assert abs(other.angle - one.angle) < 10 * atol
    assert len(other.breaks) == len(one.breaks)
