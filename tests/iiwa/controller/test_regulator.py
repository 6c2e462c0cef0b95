"""The controller's law against closed forms, a second library, the thesis' numbers and invariants."""

from __future__ import annotations

from math import cos, exp, sin, sqrt
from typing import Any

import numpy as np
import pytest
from scipy import signal
from scipy.spatial.transform import Rotation

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.controller import rotations
from trajopt_cli.iiwa.controller.parameters import Goal
from trajopt_cli.iiwa.controller.regulator import Regulator, response
from trajopt_cli.iiwa.task.model import Compliance, Feed, Integration

H = 1e-3
K, D, M = [1000.0, 400, 100, 30, 10, 0], [500.0, 100, 120, 20, 5, 8], [25.0, 20, 10, 3, 2, 1]
BEFORE = Compliance(np.array(K), np.array(D), np.array(M))


def axis(k: float, d: float, m: float) -> Compliance:
    """The same three numbers on all axes."""
    return Compliance(np.full(6, k), np.full(6, d), np.full(6, m))


def regulator(compliance: Compliance, x: Array, **more: Any) -> Regulator:
    """At rest at x (6,), angles included."""
    law = Regulator(compliance, H, rotations.rotation(0, 0, 0), tuple(x[:3].tolist()), **more)
    law.x = tuple(x.tolist())
    return law


def line(v: float, length: float, rest: float) -> Array:
    """The thesis' interpolation (eqs 4.28-4.33) of one segment from 0 to length on every axis, then standing."""
    steps = int(length / v / H + 1e-9)
    share = v * H
    ends = (length - steps * share) / 2
    cruise = ends + share * np.arange(steps + 1)
    way = np.concatenate([[0.0], cruise, np.full(int(rest / H), length)])
    return np.tile(way[:, None], (1, 6))


def test_euler_is_equation_4_15_as_printed() -> None:
    """The matrices A and B of eq. 4.13, built once from the diagonals, on random equilibria and forces."""
    rng = np.random.default_rng(1)
    x_e, F = rng.normal(size=(300, 6)), rng.normal(size=(300, 6)) * 30
    x_0, v_0 = rng.normal(size=6), rng.normal(size=6)
    W = np.diag(1 / np.array(M))
    eye = np.eye(6)
    A = np.block([[eye - H * W @ np.diag(D), -H * W @ np.diag(K)], [H * eye, eye]])
    B = np.vstack([H * W, np.zeros((6, 6))])
    found = response(x_e, H, BEFORE, force=F, x_0=x_0, v_0=v_0)
    state = np.concatenate([v_0, x_0])
    for row in range(300):
        assert np.allclose(found.v[row], state[:6], rtol=0, atol=1e-12)
        assert np.allclose(found.x[row], state[6:], rtol=0, atol=1e-12)
        centre = np.concatenate([np.zeros(6), x_e[row]])
        state = A @ (state - centre) + B @ F[row] + centre


@pytest.mark.parametrize(("k", "d", "m"), [(1000.0, 100.0, 25.0), (1000.0, 2000.0, 25.0), (100.0, 100.0, 25.0)])
def test_exact_is_the_second_order_system_at_every_sample(k: float, d: float, m: float) -> None:
    """Let go 1 m away: under-, over- and critically damped (d^2 < 4 k m, >, =), closed forms."""
    x_e = np.zeros((2000, 6))
    found = response(x_e, H, axis(k, d, m), integration=Integration.EXACT, x_0=np.ones(6))
    s, w2 = d / (2 * m), k / m
    for row in (0, 1, 10, 700, 1999):
        t = row * H
        if s * s == w2:
            wanted = (1 + s * t) * exp(-s * t)
        elif s * s < w2:
            w = sqrt(w2 - s * s)
            wanted = exp(-s * t) * (cos(w * t) + s / w * sin(w * t))
        else:
            w = sqrt(s * s - w2)
            slow, fast = s - w, s + w
            wanted = (fast * exp(-slow * t) - slow * exp(-fast * t)) / (2 * w)
        assert found.x[row] == pytest.approx(np.full(6, wanted), abs=1e-12)


@pytest.mark.parametrize("integration", Integration)
def test_a_force_against_a_second_library(integration: Integration) -> None:
    """scipy.signal's own discretisations of the same axis, its simulation of a random force."""
    rng = np.random.default_rng(2)
    n, F = 500, rng.normal(size=(500, 6)) * 50
    method = "euler" if integration is Integration.EULER else "zoh"
    found = response(np.zeros((n, 6)), H, BEFORE, integration=integration, force=F)
    for i in range(6):
        k, d, m = K[i], D[i], M[i]
        plant = signal.StateSpace([[-d / m, -k / m], [1, 0]], [[1 / m], [0]], np.eye(2), np.zeros((2, 1)))
        _, y, _ = signal.dlsim(signal.cont2discrete((plant.A, plant.B, plant.C, plant.D), H, method), F[:, i])
        assert found.v[:, i] == pytest.approx(y[:, 0], abs=1e-12)
        assert found.x[:, i] == pytest.approx(y[:, 1], abs=1e-12)


def test_euler_goes_to_the_exact_law_with_the_period() -> None:
    """First order: a tenth of the period, a tenth of the difference; at the same times."""
    off = []
    for h in (1e-3, 1e-4):
        n = int(1 / h) + 1
        euler, exact = (
            response(np.zeros((n, 6)), h, axis(1000, 100, 25), integration=law, x_0=np.ones(6)) for law in Integration
        )
        off.append(float(np.abs(euler.x - exact.x).max()))
    assert off[0] / off[1] == pytest.approx(10, rel=0.05)


def test_undamped_motion_keeps_its_energy_only_in_the_exact_law() -> None:
    undamped = axis(1000, 0, 25)
    exact, euler = (
        response(np.zeros((5000, 6)), H, undamped, integration=law, x_0=np.ones(6))
        for law in (Integration.EXACT, Integration.EULER)
    )
    energy = 0.5 * 25 * exact.v**2 + 0.5 * 1000 * exact.x**2
    np.testing.assert_allclose(energy, 500.0, rtol=1e-10, atol=0)
    # forward Euler multiplies it by 1 + h^2 k/m every period
    grown = 0.5 * 25 * euler.v[-1] ** 2 + 0.5 * 1000 * euler.x[-1] ** 2
    assert grown == pytest.approx(500.0 * (1 + H * H * 40) ** 4999, rel=1e-9)


@pytest.mark.parametrize("integration", Integration)
def test_steady_force_excursion_and_hand_guiding(integration: Integration) -> None:
    """F = K (x - x_e) in the end (eq. 4.20); with k = 0 a force moves it at F/d and it stays where it is let go."""
    n = 8000
    push = np.zeros((n, 6))
    push[:4000] = 40.0
    soft = Compliance(np.array([500.0, 0, 0, 40, 0, 40]), np.array([100.0, 50, 20, 30, 8, 20]), np.array(M))
    found = response(np.zeros((n, 6)), H, soft, integration=integration, force=push)
    assert found.x[3999, 0] == pytest.approx(40 / 500, abs=1e-4)
    assert found.x[3999, 3] == pytest.approx(1.0, abs=1e-2)
    assert found.v[3999, 1] == pytest.approx(40 / 50, abs=1e-3)
    assert found.x[-1, 0] == pytest.approx(0, abs=1e-4)
    assert found.v[-1, 1] == pytest.approx(0, abs=1e-3)
    assert found.x[-1, 1] == pytest.approx(40 * 4 / 50, abs=2e-3)  # d x = the momentum given


@pytest.mark.parametrize("integration", Integration)
def test_the_lag_on_a_long_line_is_d_v_over_k_and_feeding_the_speed_takes_it_away(integration: Integration) -> None:
    v = 0.1
    x_e = np.tile((v * H * np.arange(6000))[:, None], (1, 6))
    stiff = axis(1000, 500, 25)
    lag = x_e - response(x_e, H, stiff, integration=integration).x
    # the exact law holds x_e over the period: half a period of way more
    extra = v * H / 2 if integration is Integration.EXACT else 0.0
    assert lag[5990] == pytest.approx(np.full(6, 500 * v / 1000 + extra), abs=1e-6)
    fed = response(x_e, H, stiff, integration=integration, feed=Feed.VELOCITY)
    assert x_e[5990] - fed.x[5990] == pytest.approx(np.zeros(6), abs=1e-6)
    assert fed.v[5990] == pytest.approx(np.full(6, v), abs=1e-6)


def test_the_fed_speed_is_the_dampers_alone() -> None:
    """d (v - v_e) and no inertia of the equilibrium: one period by hand, and v_e is zero after the last row."""
    x_e = np.zeros((3, 6))
    x_e[1:] = 2e-3
    found = response(x_e, H, axis(1000, 500, 25), feed=Feed.VELOCITY)
    assert found.v[1] == pytest.approx(np.full(6, H / 25 * 500 * 2.0), rel=1e-12)
    assert found.x[1] == pytest.approx(np.zeros(6), abs=1e-18)
    v_1 = found.v[1, 0]
    assert found.v[2] == pytest.approx(np.full(6, v_1 + H / 25 * (-500 * v_1 + 1000 * 2e-3)), rel=1e-12)


@pytest.mark.parametrize(
    ("v", "deviation"), [(0.05, 0.043), (0.1, 0.085), (0.2, 0.154), (0.4, 0.232), (0.75, 0.288), (1.0, 0.305)]
)
def test_the_speed_table_on_the_space_diagonal(v: float, deviation: float) -> None:
    """0.2 m on each axis at v on each axis, K = 1000, D = 500, M = 25, against the thesis' digest and the closed form.

    The ramp's lag e'' + 20 e' + 40 e = 20 v from e = 0, e' = v grows until the line ends, at 0.2 / v seconds.
    """
    x_e = line(v, 0.2, 1.0)
    lag = x_e - response(x_e, H, axis(1000, 500, 25)).x
    largest = float(np.linalg.norm(lag[:, :3], axis=1).max())
    slow, fast = 10 - sqrt(60), 10 + sqrt(60)
    A = (v - 0.5 * v * fast) / (fast - slow)
    t = 0.2 / v
    closed = 0.5 * v + A * exp(-slow * t) - (A + 0.5 * v) * exp(-fast * t)
    assert largest == pytest.approx(sqrt(3) * closed, rel=1.5e-3)
    assert largest == pytest.approx(deviation, abs=1e-3)


@pytest.mark.parametrize("integration", Integration)
@pytest.mark.parametrize("feed", Feed)
def test_one_period_at_a_time_is_the_same_law(integration: Integration, feed: Feed) -> None:
    """And new numbers keep the state: the second half with another compliance, as a response begun there."""
    rng = np.random.default_rng(3)
    x_e, F = np.cumsum(rng.normal(size=(400, 6)), axis=0) * 1e-3, rng.normal(size=(400, 6)) * 20
    after = Compliance(np.array(K) / 2, np.array(D) * 2, np.array(M) * 3)
    first = response(x_e[:201], H, BEFORE, integration=integration, feed=feed, force=F[:201])
    law = regulator(BEFORE, x_e[0], integration=integration, feed=feed)
    goals = [Goal(tuple(row)) for row in x_e]
    for k in range(200):
        assert law.x == pytest.approx(first.x[k], abs=1e-14)
        law.step(goals[k], tuple(F[k]), goals[k + 1])
    law.set(after)
    assert law.x == pytest.approx(first.x[200], abs=1e-14)
    second = response(
        x_e[200:], H, after, integration=integration, feed=feed, force=F[200:], x_0=first.x[200], v_0=first.v[200]
    )
    for k in range(200, 399):
        law.step(goals[k], tuple(F[k]), goals[k + 1])
        assert law.v == pytest.approx(second.v[k - 199], abs=1e-13)


@pytest.mark.parametrize("n", [1, 2, 3, 10, 17, 901])
def test_any_number_of_rows(n: int) -> None:
    """Rows are run in blocks side by side; each is still the one before and one period more, a growing law's too."""
    rng = np.random.default_rng(n)
    growing = Compliance(np.full(6, 1000.0), np.array([0, 0.5, 500, 49e3, 5.2e4, 6e4]), np.full(6, 25.0))
    x_e, F = rng.normal(size=(n, 6)), rng.normal(size=(n, 6)) * 30
    found = response(x_e, H, growing, force=F, v_0=np.ones(6))
    law = regulator(growing, x_e[0])
    law.v = (1.0,) * 6
    for k in range(n):
        scale = 1 + np.abs(found.x[: k + 1]).max(axis=0)
        assert np.all(np.abs(np.array(law.x) - found.x[k]) < 1e-12 * scale)
        law.step(Goal(tuple(x_e[k].tolist())), tuple(F[k].tolist()))


@pytest.mark.parametrize("integration", Integration)
@pytest.mark.parametrize("feed", Feed)
@pytest.mark.parametrize("about", range(3))
def test_the_turn_about_one_axis_is_the_law_of_its_angle(integration: Integration, feed: Feed, about: int) -> None:
    """A moment and a moving equilibrium about x, y or z: the angle's own response, to rounding."""
    rng = np.random.default_rng(4)
    n = 600
    angle, torque = np.cumsum(rng.normal(size=n)) * 2e-3, rng.normal(size=n) * 4
    x_e, F = np.zeros((n, 6)), np.zeros((n, 6))
    x_e[:, 3 + about], F[:, 3 + about] = angle, torque
    compliance = Compliance(
        np.array([*K[:3], 30, 30, 30]), np.array([*D[:3], 20, 20, 20]), np.array([1, 1, 1, 3, 3, 3])
    )
    scalar = response(x_e, H, compliance, integration=integration, feed=feed, force=F)
    unit = np.eye(3)[about]
    R_e = Rotation.from_rotvec(angle[:, None] * unit).as_matrix()
    found = response(x_e, H, compliance, R_e=R_e, force=F, integration=integration, feed=feed)
    R = Rotation.from_rotvec(scalar.x[:, 3 + about, None] * unit).as_matrix()
    assert np.allclose(found.R, R, rtol=0, atol=1e-12)
    assert np.allclose(found.v, scalar.v, rtol=0, atol=1e-10)


def test_no_gimbal_lock() -> None:
    """Through |beta| = 90 deg and beyond: the steady lag is still D w / K, about the axis of the turn."""
    n, rate = 4000, 1.0
    unit = np.array([1.0, 2.0, -1.0]) / sqrt(6)
    angle = rate * H * np.arange(n)
    start = Rotation.from_euler("xyz", [20, 60, 10], degrees=True)
    R_e = (Rotation.from_rotvec(angle[:, None] * unit) * start).as_matrix()
    law = Compliance(np.r_[K[:3], [30] * 3], np.r_[D[:3], [6] * 3], np.r_[M[:3], [0.5] * 3])
    found = response(np.zeros((n, 6)), H, law, R_e=R_e)
    lag = (Rotation.from_matrix(R_e[-1]) * Rotation.from_matrix(found.R[-1]).inv()).as_rotvec()
    assert lag == pytest.approx(6 * rate / 30 * unit, abs=1e-6)
    assert np.abs(found.R @ found.R.swapaxes(1, 2) - np.eye(3)).max() < 1e-12


def test_slerp_is_its_law_by_hand() -> None:
    rng = np.random.default_rng(5)
    n = 200
    R_e = Rotation.from_rotvec(np.cumsum(rng.normal(size=(n, 3)), axis=0) * 0.02).as_matrix()
    p_e, F = np.cumsum(rng.normal(size=(n, 3)), axis=0) * 1e-3, rng.normal(size=(n, 6)) * 5
    x_e = np.hstack([p_e, np.zeros((n, 3))])
    slide, turn = response(x_e, H, BEFORE, force=F), response(x_e, H, BEFORE, R_e=R_e, force=F)
    assert turn.x[:, :3] == pytest.approx(slide.x[:, :3], abs=1e-13)
    # scipy's rotations, forward Euler by hand
    R, w = Rotation.from_matrix(R_e[0]), np.zeros(3)
    for k in range(n):
        assert np.allclose(turn.R[k], R.as_matrix(), rtol=0, atol=1e-12)
        phi = (R * Rotation.from_matrix(R_e[k]).inv()).as_rotvec()
        R = Rotation.from_rotvec(H * w) * R
        w = w + H / np.array(M[3:]) * (F[k, 3:] - np.array(D[3:]) * w - np.array(K[3:]) * phi)


def test_rotations_of_one_sample_against_scipy() -> None:
    rng = np.random.default_rng(6)
    for size in (1e-12, 1e-6, 0.1, 3.0, np.pi - 1e-9, np.pi - 1e-4):
        for _ in range(40):
            phi = rng.normal(size=3)
            phi *= size / np.linalg.norm(phi)
            R = rotations.exponential(tuple(phi))
            assert np.allclose(np.reshape(R, (3, 3)), Rotation.from_rotvec(phi).as_matrix(), rtol=0, atol=4e-16 * 4)
            assert np.allclose(rotations.logarithm(R), phi, rtol=0, atol=1e-15 + 1e-14 * size)
    assert rotations.logarithm(rotations.rotation(0, 0, 0)) == (0, 0, 0)
    for _ in range(200):
        abc = rng.uniform([-7, -1.5, -7], [7, 1.5, 7])
        R = rotations.rotation(*abc)
        assert np.allclose(np.reshape(R, (3, 3)), Rotation.from_euler("xyz", abc).as_matrix(), rtol=0, atol=1e-15)
        assert rotations.angles(R, tuple(abc + 0.01)) == pytest.approx(abc, abs=1e-12)
        rates, step = rng.normal(size=3), 1e-6
        ahead = Rotation.from_euler("xyz", abc + step * rates) * Rotation.from_euler("xyz", abc - step * rates).inv()
        omega = rotations.spin(tuple(abc), tuple(rates))
        assert omega == pytest.approx(ahead.as_rotvec() / (2 * step), abs=1e-8)
        assert rotations.angle_rates(tuple(abc), omega) == pytest.approx(rates, abs=1e-12)


@pytest.mark.parametrize("sign", [1, -1])
def test_angles_where_they_lock(sign: int) -> None:
    """At beta = +-90 deg alpha is the one asked for; there and in the noise around it the orientation is right."""
    for off in (0.0, 1e-13, 1e-9, 1e-5):
        R = Rotation.from_euler("xyz", [0.7, sign * (np.pi / 2 - off), -1.1]).as_matrix()
        alpha, beta, gamma = rotations.angles(tuple(R.ravel()), (0.4, 0, 0))
        assert alpha == pytest.approx(0.4) or off > 1e-12
        assert np.allclose(np.reshape(rotations.rotation(alpha, beta, gamma), (3, 3)), R, rtol=0, atol=1e-12)
