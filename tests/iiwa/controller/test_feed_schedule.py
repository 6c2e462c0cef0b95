"""Dosing: the bound at every row, the path and its caps untouched, and how near to the optimum it comes.

The optimum with fixed row numbers of the waypoints is a convex problem: the smallest bound that so many periods allow.
On one line it is a linear program (SciPy), at corners a cone program (CasADi, Ipopt).
"""

from __future__ import annotations

from time import process_time

import casadi as ca
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import linprog
from scipy.spatial.transform import Rotation

from trajopt_cli.geometry import rotation_about
from trajopt_cli.iiwa.controller import feed_plan
from trajopt_cli.iiwa.controller.feed_limits import Allowed, DoseFeed, Lead
from trajopt_cli.iiwa.controller.feed_path import DosePath, PathInterval, coarser, dose_path
from trajopt_cli.iiwa.controller.feed_plan import plan
from trajopt_cli.iiwa.controller.feed_schedule import CannotDose, Dosed, Feeding, compare
from trajopt_cli.iiwa.controller.feed_schedule import dose as dosed_as
from trajopt_cli.iiwa.controller.greedy_feed import Walk
from trajopt_cli.iiwa.controller.regulator import coefficients
from trajopt_cli.iiwa.task.equilibrium import Equilibrium, Piece
from trajopt_cli.iiwa.task.model import (
    AngleMeaning,
    Compliance,
    Integration,
    Profile,
    RotationLaw,
    Route,
    SegmentSpeeds,
    Waypoint,
)
from trajopt_cli.iiwa.task.segments import interpolate

V = 0.4  # m/s


def compliance(k=1000.0, d=500.0, m=25.0):
    return Compliance(np.r_[np.full(3, k), [30.0] * 3], np.r_[np.full(3, d), [20.0] * 3], np.r_[[m] * 3, [3.0] * 3])


def dose(path, law, h, lag, *, turn_bound=None, **how):
    """Fed positions with a lag of at most lag [m] and turn_bound [rad], unless how says otherwise."""
    return dosed_as(path, law, h, Allowed(lag, turn_bound), **how)


def polyline(points, speed=V, dwells=()):
    """A path through points (n, up to 6) at speed; dwells: seconds at each point."""
    points = np.asarray(points, dtype=float)
    pose = np.hstack([points, np.zeros((len(points), 6 - points.shape[1]))])
    legs = []
    for i in range(len(points)):
        if i:
            legs.append(PathInterval(i - 1, i, f"p{i - 1}", f"p{i}"))
        if i < len(dwells) and dwells[i]:
            legs.append(PathInterval(i, i, f"p{i}", f"p{i}", dwells[i]))
    s = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(pose, axis=0), axis=1) / speed)]
    return DosePath(s, pose, np.ones(len(points) - 1), tuple(legs))


def simulated(pose, law, h, rest=0):
    """Forward Euler as eq. 4.13 has it, written again; positions and angles (n + rest, 6)."""
    x_e = np.concatenate([pose, np.repeat(pose[-1:], rest, axis=0)])
    out = np.empty_like(x_e)
    for i, (k, d, share) in enumerate(zip(law.K.tolist(), law.D.tolist(), (h / law.M).tolist(), strict=True)):
        x, v, places = float(x_e[0, i]), 0.0, []
        for u in x_e[:, i].tolist():
            places.append(x)
            x, v = x + h * v, v + share * (-d * v - k * (x - u))
        out[:, i] = places
    return out, x_e


def check(made, path, law, h, bound, rest=6.0):
    """What every dosed sequence has to keep, by a simulation of its own that goes on for rest [s]."""
    assert isinstance(made, Dosed), made
    x, x_e = simulated(made.pose, law, h, round(rest / h))
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
    assert made.least is None or made.least <= made.duration + 1e-9
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
    made = dose(path, law, 4e-3, 0.005)
    check(made, path, law, 4e-3, 0.005)
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


@settings(max_examples=10, deadline=None, derandomize=True)
@given(
    k=st.floats(100, 3000),
    damping=st.floats(0.12, 3.0),
    mass=st.floats(3, 40),
    bound=st.floats(0.002, 0.02),
    points=st.lists(st.tuples(*[st.floats(-0.06, 0.06)] * 6), min_size=2, max_size=4),
)
def test_the_bound_holds_at_every_row_for_any_law_and_path(k, damping, mass, bound, points) -> None:
    h = 0.008
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
    free = dose(path, law, 5e-3, 0.01)
    check(free, path, law, 5e-3, 0.01, rest=16)
    tight = dose(path, law, 5e-3, 0.01, turn_bound=0.02)
    check(tight, path, law, 5e-3, 0.01, rest=16)
    assert free.lag.turn_maximum > 0.04
    assert 0.0199 < tight.lag.turn_maximum <= 0.02
    assert tight.duration > free.duration


def test_a_reversal_and_a_pure_turn_keep_the_bound() -> None:
    law = compliance(500.0, 50.0)
    path = polyline([[0, 0, 0, 0, 0, 0], [0.05, 0, 0, 0, 0, 0], [0.05, 0, 0, 0.4, 0, 0], [0, 0, 0, 0.4, 0, 0]])
    made = dose(path, law, 2e-3, 0.005)
    check(made, path, law, 2e-3, 0.005)
    assert made.braked > 0
    assert "holds back" in made.notes[0]


def test_an_arm_that_swings_is_braked_before_corner_and_end() -> None:
    h, law, bound = 4e-3, compliance(500.0, 50.0), 0.005
    path = polyline([[0.0, 0.0], [0.06, 0.0], [0.008, 0.03]])
    axes = coefficients(law.K, law.D, law.M, h, Integration.EULER)
    plain, _ = plan(Walk(path, h, axes, bound, None), None, 0.0)
    made = dose(path, law, h, bound)
    check(made, path, law, h, bound)
    assert made.duration < 0.95 * (len(plain) - 1) * h
    assert len({state.segment for state in plain}) == 3


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
    law, h = compliance(k, d), 4e-3
    made = dose(polyline([[0.0, 0.0], [0.06, 0.0], [0.06, 0.06]]), law, h, 0.005)
    acceleration = np.linalg.norm(np.diff(made.x[:, :3], 2, axis=0), axis=1) / h**2
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


def test_the_lower_bound_counts_turns_and_ways_by_what_binds_each_leg() -> None:
    law, path = compliance(), polyline([[0, 0, 0, 0, 0, 0], [0, 0, 0, 1.5, 0, 0], [0.2, 0, 0, 1.5, 0, 0]])
    made = dose(path, law, 5e-3, 0.005, turn_bound=0.02)
    check(made, path, law, 5e-3, 0.005)
    # 1.5 rad at turn_bound k/d = 0.02 30/20 rad/s from exactly the start, then 0.2 m at 0.005 1000/500 m/s
    assert made.least == pytest.approx((1.5 - 0.02) / 0.03 + (0.2 - 0.01) / 0.01, rel=1e-3)
    assert made.gap < 0.05
    free = dose(path, law, 5e-3, 0.005)
    check(free, path, law, 5e-3, 0.005)
    assert free.least < 30
    # one law for both makes both bounds the same
    alike = Compliance(np.full(6, 1000.0), np.full(6, 500.0), np.full(6, 25.0))
    ways = [polyline([np.roll([*corner, 0, 0, 0], shift) for corner in ([0, 0, 0], [0.1, 0, 0], [0.1, 0.1, 0])])
            for shift in (0, 3)]  # fmt: skip
    moved, turned = (dose(way, alike, 5e-3, 0.005, turn_bound=0.005) for way in ways)
    assert isinstance(moved, Dosed)
    assert isinstance(turned, Dosed)
    assert turned.duration == pytest.approx(moved.duration, rel=1e-3)
    assert turned.least is None  # two angles change: their sum is no turn, and the caps alone say nothing


def test_the_arm_has_arrived_when_its_angles_have_too() -> None:
    law = Compliance(compliance().K, np.r_[[500.0] * 3, [60.0] * 3], compliance().M)
    path = polyline([[0, 0, 0, 0, 0, 0], [0.02, 0, 0, 0.5, 0, 0]], speed=0.2)
    made = dose(path, law, 1e-3, 0.02)
    x, _ = simulated(made.pose, law, 1e-3, 12_000)
    turn, way = np.abs(x[:, 3] - 0.5), np.abs(x[:, 0] - 0.02)
    arrived = 1 + np.flatnonzero(turn > np.radians(0.1))[-1]
    assert made.arrived == pytest.approx(arrived * 1e-3)
    assert way[arrived] < 1e-4  # the position was there long before


def test_what_cannot_be_dosed_says_why() -> None:
    path = polyline([[0.0, 0.0], [0.02, 0.0], [0.02, 0.02]])
    guided = Compliance(np.array([1000.0, 0, 1000, 30, 30, 30]), compliance().D, compliance().M)
    refused = dose(path, guided, 1e-3, 0.005)
    assert isinstance(refused, CannotDose)
    assert "along y, where the stiffness is 0" in refused.message
    assert isinstance(dose(polyline([[0.0], [0.02]]), guided, 1e-3, 0.005), Dosed)
    unstable = dose(path, compliance(1000.0, 0.9), 1e-3, 0.005)
    assert isinstance(unstable, CannotDose)
    assert "x is unstable: d = 0.9 N s/m must be above h k = 1 N s/m" in unstable.message
    tiny = dose(path, compliance(), 1e-3, 1e-6)
    assert isinstance(tiny, CannotDose)
    assert "3000000 rows" in tiny.message


@pytest.mark.parametrize(
    ("k", "d", "says"),
    [
        (
            1e-3,
            500.0,
            "along x, where the controller takes 5e+05 s to lose two thirds of a deviation (k = 0.001, d = 500",
        ),
        (1e-300, 500.0, "practically never loses two thirds of a deviation (k = 1e-300"),
        (1.0, 500.0, "more than the 100 s that dosing allows; raise k or lower d"),
        (1.0, 1.0, "more than the 20 s that dosing allows; raise d, or lower m or h"),
        (1000.0, 1.0000001, "raise d, or lower m or h"),  # all but unstable, however fast the continuous law is
    ],
)
def test_a_law_that_hardly_comes_to_rest_is_refused_at_once(k: float, d: float, says: str) -> None:
    begin = process_time()
    refused = dose(polyline([[0.0], [0.01]]), compliance(k, d), 1e-3, 0.005)
    assert process_time() - begin < 0.5
    assert isinstance(refused, CannotDose)
    assert says in refused.message


def test_a_search_without_end_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    path, law = polyline([[0.0, 0.0], [0.06, 0.0], [0.008, 0.03]]), compliance(500.0, 50.0)
    monkeypatch.setattr(feed_plan, "MOST_LOOKAHEAD", 500)
    refused = dose(path, law, 2e-3, 0.005)
    assert isinstance(refused, CannotDose)
    assert refused.message.startswith("given up after ")
    assert refused.message.endswith("more damping, so that the arm swings less")
    assert dose(path, compliance(), 2e-3, 0.005).duration > 0  # an arm that does not swing needs no looking ahead


def test_standing_still_is_safe_up_to_the_peak_of_the_free_motion_and_not_beyond() -> None:
    h, law = 1e-3, compliance(500.0, 50.0)
    path, axes = polyline([[0.0, 0.0], [0.06, 0.0]]), coefficients(law.K, law.D, law.M, h, Integration.EULER)
    for e, v in ((0.002, 0.04), (-0.003, -0.01), (0.0, 0.03)):
        x, rate, peak = e, v, 0.0
        for _ in range(5000):
            peak = max(peak, abs(x))
            x, rate = x + h * rate, rate + h / law.M[0] * (-law.D[0] * rate - law.K[0] * x)
        for bound, safe in ((peak * (1 + 1e-6), True), (peak * (1 - 1e-6), False)):
            walk = Walk(path, h, axes, bound, None)
            end = walk.start()._replace(segment=1, p=(0.06 + e, 0.0, 0.0), v=(v, 0.0, 0.0))
            assert (walk.unsafe_after(end) == np.inf) is safe


def test_a_slow_law_on_a_path_that_never_uses_it_is_none_of_dosings_business() -> None:
    law = compliance()
    slow = Compliance(np.r_[1000.0, 1e-3, 1000.0, [30.0] * 3], law.D, law.M)
    made = dose(polyline([[0.0], [0.02]]), slow, 1e-3, 0.005)
    assert isinstance(made, Dosed)
    assert made.duration == dose(polyline([[0.0], [0.02]]), law, 1e-3, 0.005).duration


def test_the_exact_law_is_refused_by_its_own_conditions() -> None:
    path = polyline([[0.0], [0.02]])
    assert isinstance(dose(path, compliance(1000.0, 0.9), 1e-3, 0.005), CannotDose)  # h k > d
    swings = dose(path, compliance(1000.0, 0.0), 1e-3, 0.005, integration=Integration.EXACT)
    assert isinstance(swings, CannotDose)
    assert "x has d = 0 with k = 1000 N/m: it oscillates forever; give it some damping" in swings.message
    nearly = dose(path, compliance(1000.0, 0.1), 1e-3, 0.005, integration=Integration.EXACT)
    assert isinstance(nearly, CannotDose)
    assert nearly.message.endswith("raise d or lower m")
    for message in (swings.message, nearly.message):
        assert "above h k" not in message
        assert "below 2 m/h" not in message
    # where Euler is unstable the exact law may well be dosed
    stiff = compliance(300_000.0, 250.0)
    assert isinstance(dose(path, stiff, 1e-3, 0.005), CannotDose)
    assert isinstance(dose(path, stiff, 1e-3, 0.005, integration=Integration.EXACT), Dosed)


@pytest.mark.parametrize("bound", [1e-300, 9e-7, 10.1, 1e155, 1e300])
def test_a_bound_out_of_all_proportion_is_refused_at_once(bound: float) -> None:
    refused = dose(polyline([[0.0], [0.02]]), compliance(), 1e-3, bound)
    assert isinstance(refused, CannotDose)
    word = "small" if bound < 1 else "large"
    assert refused.message.startswith(f"a lag of at most {bound:g} m is too {word} a bound; give one between 1e-06 m")
    turn = dose(polyline([[0.0], [0.02]]), compliance(), 1e-3, 0.005, turn_bound=1e155)
    assert isinstance(turn, CannotDose)
    assert "a turn lag of at most 1e+155 rad" in turn.message


def test_the_largest_bound_leaves_the_programmed_time() -> None:
    made = dose(polyline([[0.0], [0.02]]), compliance(), 1e-3, 10.0, turn_bound=np.pi)
    assert isinstance(made, Dosed)
    assert made.duration == pytest.approx(0.05)


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


def route(profile, points, h=1e-3):
    """Poses through points (n, 3) at up to 0.4 m/s with ramps."""
    waypoints = [Waypoint(f"p{i}", np.r_[point, 0.0, 0.0, 0.0], f"poses[{i}]") for i, point in enumerate(points)]
    speeds = (SegmentSpeeds(V, 1.0, 1.5, 5.0, 10.0, 50.0),) * (len(points) - 1)
    return Route(tuple(waypoints), speeds, h, profile, RotationLaw.TAIT_BRYAN, AngleMeaning.RELATIVE)


CORNERS = 0.1 * np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 1, 1], [0, 1, 1]], dtype=float)


@pytest.mark.parametrize("profile", list(Profile))
def test_a_bound_that_does_not_bind_gives_back_the_programmed_sequence_ramps_and_all(profile: Profile) -> None:
    equilibrium = interpolate(route(profile, CORNERS))
    made = dose(dose_path(equilibrium), compliance(), equilibrium.h, 1.0)
    assert isinstance(made, Dosed)
    assert len(made.pose) == len(equilibrium.pose)  # not a period is lost at the ends of rows
    assert np.max(np.abs(made.pose - equilibrium.pose)) < 1e-9
    assert made.pieces == equilibrium.pieces


@pytest.mark.parametrize("profile", [Profile.TRAPEZOID, Profile.S_CURVE])
def test_ramps_are_nowhere_overtaken_and_cost_little_at_corners(profile: Profile) -> None:
    equilibrium, law, bound = interpolate(route(profile, CORNERS, 2e-3)), compliance(), 0.005
    path = dose_path(equilibrium)
    assert len(path.s) > 500
    begin = process_time()
    made = dose(path, law, equilibrium.h, bound)
    assert process_time() - begin < 5
    check(made, path, law, equilibrium.h, bound)
    # never on by more in a period than the programmed sequence was there: the faster of the rows it is in
    old = np.linalg.norm(np.diff(path.pose[:, :3], axis=0), axis=1) / np.diff(path.s)
    steps = np.linalg.norm(np.diff(made.pose[:, :3], axis=0), axis=1)
    rows = np.searchsorted(path.s, made.s[:-1], "right") - 1, np.searchsorted(path.s, made.s[1:], "left") - 1
    for step, first, last in zip(steps, *rows, strict=True):
        assert step <= np.max(old[first : max(first, last) + 1]) * equilibrium.h * (1 + 1e-9) + 1e-12
    # against the caps alone, without ramps: at each of the four starts an s-curve takes 0.1 s to its 0.05 m/s
    free = dose(dose_path(equilibrium, [SegmentSpeeds(V, 1.0)] * 4), law, equilibrium.h, bound)
    assert isinstance(free, Dosed)
    assert free.duration <= made.duration <= free.duration + 4 * 0.12


def test_brakes_are_searched_for_on_a_path_of_longer_rows() -> None:
    path = dose_path(ramped(), joints=np.linspace(0, 1, 66)[:, None] ** 2, joint_speed=[2.0])
    fewer = coarser(path, 0.05)
    assert len(fewer.s) < 0.4 * len(path.s)
    assert fewer.least_time == pytest.approx(path.least_time)
    assert [(leg.origin, leg.goal, leg.dwell) for leg in fewer.legs] == [
        (leg.origin, leg.goal, leg.dwell) for leg in path.legs
    ]
    for old, new in zip(path.legs, fewer.legs, strict=True):
        assert path.s[old.last] == fewer.s[new.last]
        assert np.array_equal(path.pose[old.last], fewer.pose[new.last])


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


# feeds that push: the law and the push written again


def pushed(made, law, h, rest=1500):
    """Positions (n, 3) of the arm and K (u - x) + D u' (n, 3) for what is fed, from rest in the plan's first pose."""
    u = np.concatenate([made.pose, np.repeat(made.pose[-1:], rest, axis=0)])[:, :3]
    rate = np.zeros_like(u)
    if made.feed is DoseFeed.VELOCITY:
        rate[:-1] = np.diff(u, axis=0) / h
    places, pushes = np.empty_like(u), np.empty_like(u)
    for i, (k, d, share) in enumerate(zip(*(one[:3].tolist() for one in (law.K, law.D, h / law.M)), strict=True)):
        x, v, rows = float(made.plan[0, i]), 0.0, []
        for place, v_e in zip(u[:, i].tolist(), rate[:, i].tolist(), strict=True):
            push = k * (place - x) + d * v_e
            rows.append((x, push))
            x, v = x + h * v, v + share * (push - d * v)
        places[:, i], pushes[:, i] = np.array(rows).T
    return places, pushes


PATHS = {
    "corners": CORNERS,
    "there and back": [[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [0.0, 0.0, 0.0]],
    "small steps": [[0.004 * i, 0.004 * (i % 2), 0.0] for i in range(8)],
    "bent": [[0.05 * np.sin(a), 0.05 * (1 - np.cos(a)), 0.02 * a] for a in np.linspace(0, 4, 60)],
}


@pytest.mark.parametrize("name", PATHS)
@pytest.mark.parametrize("feed", [DoseFeed.VELOCITY, DoseFeed.INVERSE])
@pytest.mark.parametrize("lead", [Lead(12.0), Lead(0.06, stretch=True)])
def test_lag_and_push_are_kept_by_a_simulation_of_its_own(name: str, feed: DoseFeed, lead: Lead) -> None:
    h, law, points = 4e-3, compliance(), np.asarray(PATHS[name])
    path = polyline(points)
    made = dosed_as(path, law, h, Allowed(0.003, lead=lead), feed=feed)
    assert isinstance(made, Dosed), made
    x, push = pushed(made, law, h)
    plan = np.concatenate([made.plan, np.repeat(made.plan[-1:], 1500, axis=0)])[:, :3]
    assert np.max(np.linalg.norm(x - plan, axis=1)) <= 0.003 * (1 + 1e-6)
    most = lead.most * 1000 if lead.stretch else lead.most
    assert 0.9 * most < np.max(np.linalg.norm(push, axis=1)) <= most * (1 + 1e-6)
    # the plan is the path, from its beginning to its end, never back
    along = np.cumsum(np.r_[0, np.linalg.norm(np.diff(points, axis=0), axis=1)])
    s = np.interp(made.s, path.s, along)
    for i in range(3):
        np.testing.assert_allclose(made.plan[:, i], np.interp(s, along, points[:, i]), rtol=0, atol=1e-9)
    assert np.all(np.diff(made.s) >= -1e-12)
    np.testing.assert_allclose(x[-1], points[-1], rtol=0, atol=1e-5)
    assert made.least is None or made.least <= made.duration


def least_periods_with_a_push(length, push, law, h, most):
    """Fewest periods from rest to rest over length by pushes of at most push [N], never back, at most V: an LP each."""
    d, m = law.D[0], law.M[0]

    def possible(periods):
        # unknowns: the push of every period; x' = x + h v, v' = v + h / m (push - d v); numbers near 1 for the solver
        rows = np.zeros((periods + 2, periods))
        v = np.zeros(periods)
        for j in range(periods):
            rows[j + 1] = rows[j] + h * v
            v = (1 - h * d / m) * v
            v[j] += h / m
        rows[periods + 1] = rows[periods] + h * v
        rows, v = rows / (h * h / m), v / (h / m)
        steps = np.diff(rows, axis=0)
        answer = linprog(
            np.zeros(periods),
            A_ub=np.vstack([steps, -steps]),
            b_ub=np.r_[np.full(len(steps), V * m / h), np.zeros(len(steps))],
            A_eq=np.vstack([rows[periods], v]),
            b_eq=[length * m / (h * h), 0.0],
            bounds=[(-push, push)] * periods,
        )
        return answer.success

    low, high = 1, most
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if possible(middle) else (middle, high)
    return high


@pytest.mark.parametrize(("push", "length"), [(20.0, 0.02), (60.0, 0.05)])
def test_on_one_line_no_feed_that_pushes_as_much_is_faster_than_the_inverse_one(push: float, length: float) -> None:
    h, law = 5e-3, compliance()
    made = dosed_as(polyline([[0.0], [length]]), law, h, Allowed(0.005, lead=Lead(push)), feed=DoseFeed.INVERSE)
    assert isinstance(made, Dosed)
    least = least_periods_with_a_push(length, push, law, h, len(made.pose) + 5)
    assert least <= len(made.pose) - 1 <= least + 2  # the arm stands for the first period, and ends on a whole one
    fed = dosed_as(polyline([[0.0], [length]]), law, h, Allowed(0.005, lead=Lead(push)), feed=DoseFeed.VELOCITY)
    assert isinstance(fed, Dosed)
    assert made.least <= fed.duration  # one bound for both


def test_the_exact_law_takes_the_inverse_feed_too() -> None:
    path, law = polyline([[0.0, 0.0], [0.1, 0.0], [0.1, 0.1]]), compliance()
    made = dosed_as(
        path, law, 1e-3, Allowed(0.002, lead=Lead(80.0)), feed=DoseFeed.INVERSE, integration=Integration.EXACT
    )
    assert isinstance(made, Dosed)
    assert made.lag.maximum <= 0.002 * (1 + 1e-9)
    assert made.push <= 80 * (1 + 1e-9)
    rough = dosed_as(path, law, 1e-3, Allowed(0.002, lead=Lead(80.0)), feed=DoseFeed.INVERSE)
    assert made.duration == pytest.approx(rough.duration, rel=0.02)


def skew(rotation):
    """A tool that turns about a skew axis and back, while it moves."""
    turned = Rotation.from_rotvec(np.radians(25) * np.array([1.0, 2.0, -1.0]) / np.sqrt(6)) * Rotation.from_euler(
        "xyz", [0.3, 1.0, -0.5]
    )
    first, second = (one.as_euler("xyz") for one in (Rotation.from_euler("xyz", [0.3, 1.0, -0.5]), turned))
    points = [np.r_[0, 0, 0, first], np.r_[0.02, 0, 0, second], np.r_[0.02, 0.02, 0, first]]
    waypoints = tuple(Waypoint(f"p{i}", point, f"poses[{i}]") for i, point in enumerate(points))
    speeds = (SegmentSpeeds(V, 1.0, 1.5, 5.0),) * 2
    return Route(waypoints, speeds, 8e-3, Profile.TRAPEZOID, rotation, AngleMeaning.ABSOLUTE)


@pytest.mark.parametrize("rotation", list(RotationLaw))
@pytest.mark.parametrize("feed", list(DoseFeed))
def test_the_turn_lag_is_the_angle_between_the_orientations(rotation: RotationLaw, feed: DoseFeed) -> None:
    h, law, bound = 8e-3, compliance(), np.radians(1.0)
    path = dose_path(interpolate(skew(rotation)))
    made = dosed_as(path, law, h, Allowed(0.002, float(bound), turn_lead=Lead(2.0)), feed=feed)
    assert isinstance(made, Dosed), made
    # the controller again: angles by eq. 4.13, or log(R R_e^T) in world axes, by SciPy
    u = np.concatenate([made.pose, np.repeat(made.pose[-1:], 250, axis=0)])
    plan = Rotation.from_matrix(np.concatenate([made.R_plan, np.repeat(made.R_plan[-1:], 250, axis=0)]))
    K, D, M = law.K[3:], law.D[3:], law.M[3:]
    if rotation is RotationLaw.TAIT_BRYAN:
        rate = np.zeros_like(u)
        if feed is DoseFeed.VELOCITY:
            rate[:-1] = np.diff(u, axis=0) / h
        x, v, rows = made.plan[0, 3:].copy(), np.zeros(3), []
        for k in range(len(u)):
            rows.append(x)
            x, v = x + h * v, v + h / M * (D * (rate[k, 3:] - v) + K * (u[k, 3:] - x))
        answer = Rotation.from_euler("xyz", rows)
    else:
        fed = Rotation.from_matrix(np.concatenate([made.R, np.repeat(made.R[-1:], 250, axis=0)]))
        x, v, turns, back = plan[0], np.zeros(3), [], fed.inv()
        rate = np.zeros((len(u), 3))
        if feed is DoseFeed.VELOCITY:
            rate[:-1] = (fed[1:] * back[:-1]).as_rotvec() / h
        for k in range(len(u)):
            turns.append(x)
            x, v = (
                Rotation.from_rotvec(h * v) * x,
                v + h / M * (D * (rate[k] - v) - K * (x * back[k]).as_rotvec()),
            )
        answer = Rotation.concatenate(turns)
    lag = (answer * plan.inv()).magnitude()
    assert np.max(lag) <= bound * (1 + 1e-6)
    if feed is DoseFeed.POSITION:
        assert np.max(lag) > 0.9 * bound
    assert made.lag.turn_maximum == pytest.approx(np.max(lag), abs=1e-6)


def test_short_legs_have_a_bound_that_means_something_or_none() -> None:
    law, bound = compliance(), 0.005
    steps = polyline([[0.002 * i, 0.0] if i % 2 else [0.002 * i, 1e-4] for i in range(60)])  # 0.12 m in 2 mm
    made = dose(steps, law, 4e-3, bound)
    check(made, steps, law, 4e-3, bound)
    assert made.least > 0.9 * made.duration
    # the arm need not follow a zigzag smaller than the bound, and nobody knows what it has to do
    zigzag = polyline([[0.004 * (i % 2), 0.0] for i in range(60)])
    made = dose(zigzag, law, 4e-3, 0.001)
    assert made.least is None or made.gap < 1
