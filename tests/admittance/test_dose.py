"""Dosing: the bound at every row, the path and its caps untouched, and how near to the optimum it comes.

The optimum with fixed row numbers of the waypoints is a convex problem: the smallest bound that so many periods allow.
On one line it is a linear program (SciPy), at corners a cone program (CasADi, Ipopt).
"""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import linprog

from trajopt_cli.admittance.dose import CannotDose, Dosed, Feeding, compare, dose
from trajopt_cli.admittance.dose_path import DosePath, Leg, dose_path
from trajopt_cli.admittance.dose_plan import plan
from trajopt_cli.admittance.dose_walk import Walk
from trajopt_cli.admittance.regulator import coefficients
from trajopt_cli.geometry import rotation_about
from trajopt_cli.iiwa.equilibrium import Equilibrium, Piece
from trajopt_cli.iiwa.task import AngleMeaning, Compliance, Integration, RotationLaw, SegmentSpeeds

V = 0.4  # m/s


def compliance(k=1000.0, d=500.0, m=25.0):
    return Compliance(np.r_[np.full(3, k), [30.0] * 3], np.r_[np.full(3, d), [20.0] * 3], np.r_[[m] * 3, [3.0] * 3])


def polyline(points, speed=V, dwells=()):
    """A path through points (n, up to 6) at speed; dwells: seconds at each point."""
    points = np.asarray(points, dtype=float)
    pose = np.hstack([points, np.zeros((len(points), 6 - points.shape[1]))])
    legs = []
    for i in range(len(points)):
        if i:
            legs.append(Leg(i - 1, i, f"p{i - 1}", f"p{i}"))
        if i < len(dwells) and dwells[i]:
            legs.append(Leg(i, i, f"p{i}", f"p{i}", dwells[i]))
    s = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(pose, axis=0), axis=1) / speed)]
    return DosePath(s, pose, np.ones(len(points) - 1), tuple(legs))


def simulated(pose, law, h, rest=0):
    """Forward Euler as eq. 4.13 has it, written again; positions and angles (n + rest, 6)."""
    x_e = np.concatenate([pose, np.repeat(pose[-1:], rest, axis=0)])
    x, v, out = x_e[0].copy(), np.zeros(6), []
    for row in x_e:
        out.append(x)
        x, v = x + h * v, v + h / law.M * (-law.D * v - law.K * (x - row))
    return np.array(out), x_e


def check(made, path, law, h, bound, rest=4000):
    """What every dosed sequence has to keep, by a simulation of its own."""
    assert isinstance(made, Dosed), made
    x, x_e = simulated(made.pose, law, h, rest)
    lag = np.linalg.norm((x - x_e)[:, :3], axis=1)
    assert np.max(lag) <= bound * (1 + 1e-9)
    assert made.lag.maximum == pytest.approx(np.max(lag), rel=1e-6)
    assert np.allclose(made.x, x[: len(made.x)], rtol=0, atol=1e-12)
    assert np.all(np.diff(made.s) >= 0)
    rate = np.interp((made.s[1:] + made.s[:-1]) / 2, path.s[1:], path.cap) if np.ptp(path.cap) else path.cap[0]
    assert np.all(np.diff(made.s) <= rate * h * (1 + 1e-9) + 1e-12)
    assert np.array_equal(made.pose[0], path.pose[0])
    assert np.array_equal(made.pose[-1], path.pose[-1])
    for leg, piece in zip(path.legs, made.pieces, strict=True):
        assert np.array_equal(made.pose[piece.first], path.pose[leg.first])
        assert np.array_equal(made.pose[piece.last], path.pose[leg.last])
    assert made.least <= made.duration + 1e-9
    return lag


def smallest_line_bound(length, periods, law, h, rest):
    """Least possible largest lag of x_e going 0 -> length in so many periods, monotone and at most V: an LP."""
    k, d, m = law.K[0], law.D[0], law.M[0]
    A = np.array([[1 - h * d / m, -h * k / m], [h, 1.0]])
    B = np.array([h * k / m, 0.0])
    n = periods + rest
    # x_j = sum over i < j of g_(j-i) x_e,i, g the position's impulse response
    g, state = [], B
    for _ in range(n):
        g.append(state[1])
        state = A @ state
    G = np.zeros((n + 1, n + 1))
    for j in range(1, n + 1):
        G[j, :j] = g[:j][::-1]
    steps = np.zeros((n + 1, periods))  # x_e = steps @ (increments)
    for i in range(periods):
        steps[i + 1 :, i] = 1.0
    e = (G - np.eye(n + 1)) @ steps
    one = np.ones((n + 1, 1))
    answer = linprog(
        np.r_[np.zeros(periods), 1.0],
        A_ub=np.vstack([np.hstack([e, -one]), np.hstack([-e, -one])]),
        b_ub=np.zeros(2 * (n + 1)),
        A_eq=np.r_[np.ones(periods), 0.0][None],
        b_eq=[length],
        bounds=[(0, V * h)] * periods + [(0, None)],
    )
    return answer.fun if answer.success else np.inf


@pytest.mark.parametrize(("k", "d"), [(1000.0, 500.0), (1000.0, 100.0)])
def test_on_one_line_no_sequence_is_a_period_shorter(k: float, d: float) -> None:
    h, bound, length, law = 0.02, 0.005, 0.03, compliance(k, d)
    path = polyline([[0.0], [length]])
    made = dose(path, law, h, bound)
    check(made, path, law, h, bound)
    periods = len(made.pose) - 1
    assert smallest_line_bound(length, periods, law, h, 150) <= bound * (1 + 1e-6)
    assert smallest_line_bound(length, periods - 1, law, h, 150) > bound


def smallest_corner_bound(points, counts, law, h, rest, start):
    """Least possible largest lag with so many periods on each leg, by Ipopt on a convex problem; start: a guess."""
    k, d, m = law.K[0], law.D[0], law.M[0]
    opti = ca.Opti()
    total = sum(counts) + rest
    dim = points.shape[1]
    x, v, square = opti.variable(dim, total + 1), opti.variable(dim, total + 1), opti.variable()
    columns = [ca.DM(points[0])]
    for origin, goal, count in zip(points, points[1:], counts, strict=False):
        length = np.linalg.norm(goal - origin)
        way = opti.variable(count - 1)
        opti.set_initial(way, length * np.arange(1, count) / count)
        ends = ca.vertcat(0, way, length)
        opti.subject_to(opti.bounded(0, ends[1:] - ends[:-1], V * h))
        columns += [ca.DM(origin) + ends[i] * ca.DM((goal - origin) / length) for i in range(1, count + 1)]
    x_e = ca.horzcat(*columns, *[ca.DM(points[-1])] * rest)
    opti.subject_to(x[:, 0] == points[0])
    opti.subject_to(v[:, 0] == 0)
    opti.subject_to(v[:, 1:] == v[:, :-1] * (1 - h * d / m) - h * k / m * (x - x_e)[:, :-1])
    opti.subject_to(x[:, 1:] == x[:, :-1] + h * v[:, :-1])
    opti.subject_to(ca.sum1((x - x_e) ** 2) / start**2 <= square)
    opti.minimize(square)
    opti.set_initial(square, 4.0)
    for axis in range(dim):
        opti.set_initial(x[axis, :], np.linspace(points[0, axis], points[-1, axis], total + 1))
    opti.solver("ipopt", {"print_time": False}, {"print_level": 0, "sb": "yes", "tol": 1e-9})
    return start * np.sqrt(float(opti.solve().value(square)))


@pytest.mark.parametrize("turn", [45.0, 90.0])
def test_at_a_corner_of_the_thesis_law_no_neighbouring_timing_is_shorter(turn: float) -> None:
    h, bound, law = 0.04, 0.005, compliance()
    a = np.radians(turn)
    points = np.array([[0.0, 0.0], [0.015, 0.0], [0.015 + 0.015 * np.cos(a), 0.015 * np.sin(a)]])
    path = polyline(points)
    made = dose(path, law, h, bound)
    check(made, path, law, h, bound)
    first, second = (piece.last - piece.first for piece in made.pieces)
    assert smallest_corner_bound(points, (first, second), law, h, 20, bound) <= bound * (1 + 1e-4)
    for fewer in ((first, second - 1), (first + 1, second - 2), (first + 2, second - 3)):
        assert smallest_corner_bound(points, fewer, law, h, 20, bound) > bound * (1 + 1e-4)


def test_a_long_line_takes_the_length_over_the_steady_speed() -> None:
    path, law = polyline([[0.0], [0.4]]), compliance()
    made = dose(path, law, 1e-3, 0.005)
    check(made, path, law, 1e-3, 0.005)
    # the arm is b behind at the end, and m/d late from its start at rest; v = b K/D = 0.01 m/s
    assert made.duration == pytest.approx((0.4 - 0.005) / 0.01 + 25 / 500, rel=1e-3)
    assert made.gap < 0.002
    assert made.braked == 0


def test_a_bound_that_does_not_bind_leaves_the_programmed_time() -> None:
    path, law = polyline([[0.0, 0.0], [0.2, 0.0], [0.2, 0.2]]), compliance()
    made = dose(path, law, 1e-3, 0.4)
    assert made.duration == pytest.approx(path.least_time, abs=2e-3)
    assert made.least == pytest.approx(path.least_time)


numbers = st.floats(0, 1)


@settings(max_examples=25, deadline=None, derandomize=True)
@given(
    k=st.floats(100, 3000),
    damping=st.floats(0.12, 3.0),
    mass=st.floats(3, 40),
    bound=st.floats(0.002, 0.02),
    points=st.lists(st.tuples(*[st.floats(-0.06, 0.06)] * 6), min_size=2, max_size=4),
)
def test_the_bound_holds_at_every_row_for_any_law_and_path(k, damping, mass, bound, points) -> None:
    h = 0.004
    law = compliance(k, max(damping * 2 * np.sqrt(k * mass), 2 * h * k), mass)
    points = np.array(points)
    if np.min(np.linalg.norm(np.diff(points[:, :3], axis=0), axis=1)) < 0.01:
        points[:, 0] += 0.05 * np.arange(len(points)) ** 2
    path = polyline(points)
    check(dose(path, law, h, bound), path, law, h, bound)


def test_unequal_axes_and_a_bound_on_the_turn() -> None:
    law = Compliance(
        np.array([2000.0, 400.0, 1000.0, 30.0, 60.0, 30.0]), np.array([200.0, 300.0, 500.0, 20.0, 5.0, 20.0]),
        np.array([25.0, 10.0, 25.0, 3.0, 3.0, 3.0]),
    )  # fmt: skip
    path = polyline([[0, 0, 0, 0, 0, 0], [0.05, 0.02, 0, 0.3, 0, 0], [0.0, 0.05, 0.05, 0.3, 0.4, -0.2]])
    free = dose(path, law, 2e-3, 0.01)
    check(free, path, law, 2e-3, 0.01, rest=8000)
    tight = dose(path, law, 2e-3, 0.01, turn_bound=0.02)
    check(tight, path, law, 2e-3, 0.01, rest=8000)
    assert free.lag.turn_maximum > 0.04
    assert 0.0199 < tight.lag.turn_maximum <= 0.02
    assert tight.duration > free.duration


def test_a_reversal_and_a_pure_turn_keep_the_bound() -> None:
    law = compliance(500.0, 50.0)
    path = polyline([[0, 0, 0, 0, 0, 0], [0.05, 0, 0, 0, 0, 0], [0.05, 0, 0, 0.4, 0, 0], [0, 0, 0, 0.4, 0, 0]])
    made = dose(path, law, 1e-3, 0.005)
    check(made, path, law, 1e-3, 0.005)
    assert made.braked > 0
    assert "holds back" in made.notes[0]


def test_an_arm_that_swings_is_braked_before_corner_and_end() -> None:
    h, law, bound = 2e-3, compliance(500.0, 50.0), 0.005
    path = polyline([[0.0, 0.0], [0.06, 0.0], [0.008, 0.03]])
    axes = coefficients(law.K, law.D, law.M, h, Integration.EULER)
    plain, _ = plan(Walk(path, h, axes, bound, None), None, 0.0)
    made = dose(path, law, h, bound)
    check(made, path, law, h, bound)
    assert made.duration < 0.95 * (len(plain) - 1) * h
    assert len({state.stretch for state in plain}) == 3


def test_dwells_keep_their_length() -> None:
    path, law = polyline([[0.0, 0.0], [0.02, 0.0], [0.02, 0.02]], dwells=(0.3, 0.5, 0.2)), compliance(1000.0, 100.0)
    made = dose(path, law, 2e-3, 0.005)
    check(made, path, law, 2e-3, 0.005)
    dwells = [piece for piece in made.pieces if piece.dwell]
    assert [piece.last - piece.first for piece in dwells] == [150, 250, 100]
    for piece in dwells:
        assert np.ptp(made.pose[piece.first : piece.last + 1], axis=0) == pytest.approx(np.zeros(6), abs=0)


@pytest.mark.parametrize(("k", "d"), [(1000.0, 500.0), (1000.0, 100.0), (500.0, 50.0)])
def test_the_arm_is_not_shaken(k: float, d: float) -> None:
    law = compliance(k, d)
    made = dose(polyline([[0.0, 0.0], [0.06, 0.0], [0.06, 0.06]]), law, 1e-3, 0.005)
    acceleration = np.linalg.norm(np.diff(made.x[:, :3], 2, axis=0), axis=1) / 1e-6
    assert np.max(acceleration) <= 2 * k * 0.005 / 25  # spring and damper at their largest against one another
    # eager and lazy do not take turns: the equilibrium stops and goes a handful of times, not hundreds
    standing = np.diff(made.s) < 1e-9
    assert np.count_nonzero(np.diff(standing.astype(int))) < 20


def test_the_exact_law_is_dosed_too() -> None:
    path, law = polyline([[0.0, 0.0], [0.03, 0.0], [0.03, 0.03]]), compliance()
    made = dose(path, law, 5e-3, 0.005, integration=Integration.EXACT)
    assert isinstance(made, Dosed)
    assert 0.0049 < made.lag.maximum <= 0.005 * (1 + 1e-9)
    assert made.duration == pytest.approx(dose(path, law, 5e-3, 0.005).duration, rel=0.01)


def test_what_cannot_be_dosed_says_why() -> None:
    path = polyline([[0.0, 0.0], [0.02, 0.0], [0.02, 0.02]])
    guided = Compliance(np.array([1000.0, 0, 1000, 30, 30, 30]), compliance().D, compliance().M)
    refused = dose(path, guided, 1e-3, 0.005)
    assert isinstance(refused, CannotDose)
    assert "along y, where the stiffness is 0" in refused.message
    assert isinstance(dose(polyline([[0.0], [0.02]]), guided, 1e-3, 0.005), Dosed)
    unstable = dose(path, compliance(1000.0, 0.9), 1e-3, 0.005)
    assert isinstance(unstable, CannotDose)
    assert "h k < d" in unstable.message
    tiny = dose(path, compliance(), 1e-3, 1e-7)
    assert isinstance(tiny, CannotDose)
    assert "3000000 rows" in tiny.message


@pytest.mark.parametrize("bound", [0.0, -0.005, float("nan"), float("inf")])
def test_a_bound_that_is_none_is_refused(bound: float) -> None:
    with pytest.raises(ValueError, match=r"bound is .*above zero"):
        dose(polyline([[0.0], [0.02]]), compliance(), 1e-3, bound)
    with pytest.raises(ValueError, match=r"turn_bound is .*above zero"):
        dose(polyline([[0.0], [0.02]]), compliance(), 1e-3, 0.01, turn_bound=bound)


def ramped(h=0.01):
    """A sequence with a ramp: 0.1 m along x and 0.2 rad, a dwell of 0.05 s, 0.1 m along y."""
    share = np.linspace(0, 1, 41) ** 2
    pose = np.zeros((41 + 5 + 20, 6))
    pose[:41, 0], pose[:41, 3] = 0.1 * share, 0.2 * share
    pose[41:, 0], pose[41:, 3] = 0.1, 0.2
    pose[46:, 1] = np.linspace(0, 0.1, 21)[1:]
    R = rotation_about([1, 0, 0], pose[:, 3])
    pieces = (Piece(0, 40, "a", "b"), Piece(40, 45, "b", "b", dwell=True), Piece(45, 65, "b", "c"))
    return Equilibrium(h, pose, R, RotationLaw.TAIT_BRYAN, AngleMeaning.RELATIVE, pieces)


def test_the_path_of_a_sequence_forgets_its_ramps_and_keeps_its_caps() -> None:
    equilibrium = ramped()
    path = dose_path(equilibrium, [SegmentSpeeds(0.5, 0.8), SegmentSpeeds(0.2, 1.0)])
    assert path.s == pytest.approx([0.0, 0.25, 0.75])  # 0.2 rad at 0.8 rad/s, 0.1 m at 0.2 m/s
    assert [(leg.first, leg.last, leg.dwell) for leg in path.legs] == [
        (0, 1, 0),
        (1, 1, pytest.approx(0.05)),
        (1, 2, 0),
    ]
    assert path.least_time == pytest.approx(0.8)
    slerp = Equilibrium(
        equilibrium.h, equilibrium.pose, equilibrium.R, RotationLaw.SLERP, equilibrium.meaning, equilibrium.pieces
    )
    assert dose_path(slerp, [SegmentSpeeds(0.5, 0.8), SegmentSpeeds(0.2, 1.0)]).s[-1] == pytest.approx(0.75)
    old = dose_path(equilibrium)
    assert old.least_time == pytest.approx(equilibrium.duration)
    with pytest.raises(ValueError, match="1 pairs of speed caps for 2 segments"):
        dose_path(equilibrium, [SegmentSpeeds(0.5, 0.8)])


def test_a_joint_at_its_limit_slows_its_stretch() -> None:
    equilibrium = ramped()
    joints = np.zeros((66, 2))
    joints[45:, 1] = np.linspace(0, 0.3, 21)
    speeds = [SegmentSpeeds(0.5, 0.8), SegmentSpeeds(0.2, 1.0)]
    path = dose_path(equilibrium, speeds, joints=joints, joint_speed=[1.0, 0.4])
    assert path.least_time == pytest.approx(0.25 + 0.05 + 0.3 / 0.4)
    made = dose(path, compliance(), 0.01, 0.5)
    assert isinstance(made, Dosed)
    assert np.max(np.abs(np.diff(np.interp(made.pose[:, 1], [0, 0.1], [0, 0.3])))) <= 0.4 * 0.01 * (1 + 1e-9)


def test_compare_shows_what_dosing_and_the_speed_term_bring() -> None:
    h = 1e-3
    pose = np.zeros((501, 6))
    pose[:, 0] = np.linspace(0, 0.2, 501)
    R = np.tile(np.eye(3), (501, 1, 1))
    line = Equilibrium(h, pose, R, RotationLaw.TAIT_BRYAN, AngleMeaning.RELATIVE, (Piece(0, 500, "a", "b"),))
    made = dose(dose_path(line, [SegmentSpeeds(0.4, 1.0)]), compliance(), h, 0.005)
    assert isinstance(made, Dosed)
    undosed, velocity, dosed = compare(line, compliance(), made)
    assert [row.feeding for row in (undosed, velocity, dosed)] == list(Feeding)
    assert undosed.duration == pytest.approx(0.5)
    assert undosed.lag.maximum > 0.1
    assert velocity.lag.maximum < 0.5 * undosed.lag.maximum
    assert dosed.lag.maximum <= 0.005 * (1 + 1e-9)
    assert dosed.arrived is not None
    assert undosed.arrived is not None
    assert undosed.arrived > undosed.duration
    # the arm arrives when the last 5 mm have decayed to 1 mm, a time constant of 0.44 s after the end
    assert dosed.arrived - dosed.duration == pytest.approx(0.72, abs=0.05)
