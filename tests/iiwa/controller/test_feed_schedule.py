"""Dosing: the bounds at every row, the path and its caps untouched, and how near to the optimum it comes.

On one line the least number of periods that a push allows is a linear program (SciPy).
"""

from __future__ import annotations

from time import process_time

import numpy as np
import pytest
from scipy.optimize import linprog
from scipy.spatial.transform import Rotation

from trajopt_cli.geometry import rotation_about
from trajopt_cli.iiwa.controller.feed_path import Allowed, CannotDose, DosePath, Lead, PathInterval, dose_path
from trajopt_cli.iiwa.controller.feed_schedule import FeedTask
from trajopt_cli.iiwa.controller.feed_schedule import dose as dosed_as
from trajopt_cli.iiwa.task.equilibrium import Equilibrium, Piece
from trajopt_cli.iiwa.task.model import AngleMeaning, Compliance, Integration, Profile, RotationLaw, Route, Waypoint
from trajopt_cli.iiwa.task.segments import interpolate

V = 0.4  # m/s


def compliance(k=1000.0, d=500.0, m=25.0):
    return Compliance(np.r_[np.full(3, k), [30.0] * 3], np.r_[np.full(3, d), [20.0] * 3], np.r_[[m] * 3, [3.0] * 3])


def dose(path, law, h, lag, *, turn_bound=None, **how):
    """A lag of at most lag [m] and turn_bound [rad], pushing no harder than a spring stretched by as much."""
    turn_lead = None if turn_bound is None else Lead(turn_bound, stretch=True)
    return dosed_as(FeedTask(path, law, h, **how), Allowed(lag, turn_bound, Lead(lag, stretch=True), turn_lead))


def refusal(*given, **how):
    """Why there is no such sequence; arguments as of dose."""
    with pytest.raises(CannotDose) as caught:
        dose(*given, **how)
    return str(caught.value)


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


def pushed(made, law, h, rest=1500):
    """Positions (n, 3) of the arm and K (u - x) (n, 3) for what is fed, from rest in the plan's first pose: forward
    Euler as eq. 4.13 has it, written again."""
    u = np.concatenate([made.pose, np.repeat(made.pose[-1:], rest, axis=0)])[:, :3]
    places, pushes = np.empty_like(u), np.empty_like(u)
    for i, (k, d, share) in enumerate(zip(*(one[:3].tolist() for one in (law.K, law.D, h / law.M)), strict=True)):
        x, v, rows = float(made.plan[0, i]), 0.0, []
        for place in u[:, i].tolist():
            push = k * (place - x)
            rows.append((x, push))
            x, v = x + h * v, v + share * (push - d * v)
        places[:, i], pushes[:, i] = np.array(rows).T
    return places, pushes


def check(made, path, law, h, lag, lead=None):
    """What every dosed sequence has to keep, by a simulation of its own; lead: the spring's stretch [m], lag for None.

    Returns the greatest push [N].
    """
    x, push = pushed(made, law, h)
    plan = np.concatenate([made.plan, np.repeat(made.plan[-1:], 1500, axis=0)])[:, :3]
    assert np.max(np.linalg.norm(x - plan, axis=1)) <= lag * (1 + 1e-6)
    stretched = np.linalg.norm(push / np.where(law.K[:3] > 0, law.K[:3], 1.0), axis=1)
    assert np.max(stretched) <= (lag if lead is None else lead) * (1 + 1e-6)
    # the plan is the path, from its beginning to its end, never back and never faster than its caps
    points = path.pose[:, :3]
    along = np.cumsum(np.r_[0, np.linalg.norm(np.diff(points, axis=0), axis=1)])
    s = np.interp(made.s, path.s, along)
    for i in range(3):
        if np.all(np.diff(along) > 0):
            np.testing.assert_allclose(made.plan[:, i], np.interp(s, along, points[:, i]), rtol=0, atol=1e-9)
    assert np.all(np.diff(made.s) >= -1e-12)
    assert np.max(np.diff(made.s)) <= np.max(path.cap) * h * (1 + 1e-9) + 1e-12
    np.testing.assert_allclose(x[-1], points[-1], rtol=0, atol=1e-5)
    for leg, piece in zip(path.legs, made.pieces, strict=True):
        np.testing.assert_allclose(made.plan[piece.last], path.pose[leg.last], rtol=0, atol=2e-3)
    assert made.least is None or made.least <= made.duration
    return float(np.max(np.linalg.norm(push, axis=1)))


def test_a_long_line_takes_the_length_over_the_steady_speed() -> None:
    path, law = polyline([[0.0], [0.4]]), compliance()
    made = dose(path, law, 4e-3, 0.005)
    check(made, path, law, 4e-3, 0.005)
    # v = b K/D = 0.01 m/s; m/d late from its start at rest, and braked at the end
    assert made.duration == pytest.approx(0.4 / 0.01 + 25 / 500, rel=3e-3)
    assert made.gap < 0.03  # the bound lets the arm stop b before the end


def test_a_bound_that_does_not_bind_leaves_the_programmed_time() -> None:
    path, law = polyline([[0.0, 0.0], [0.2, 0.0], [0.2, 0.2]]), compliance()
    made = dose(path, law, 1e-3, 0.4)
    assert made.duration == pytest.approx(path.least_time, abs=0.15)  # speeding up at two starts, braking at two ends
    assert made.least == pytest.approx(path.least_time)


def test_a_reversal_and_a_pure_turn_keep_the_bound() -> None:
    law = compliance(500.0, 50.0)
    path = polyline([[0, 0, 0, 0, 0, 0], [0.05, 0, 0, 0, 0, 0], [0.05, 0, 0, 0.4, 0, 0], [0, 0, 0, 0.4, 0, 0]])
    made = dose(path, law, 2e-3, 0.005)
    check(made, path, law, 2e-3, 0.005)


def test_dwells_keep_their_length() -> None:
    path, law = polyline([[0.0, 0.0], [0.02, 0.0], [0.02, 0.02]], dwells=(0.3, 0.5, 0.2)), compliance(1000.0, 100.0)
    made = dose(path, law, 2e-3, 0.005)
    check(made, path, law, 2e-3, 0.005)
    dwells = [piece for piece in made.pieces if piece.dwell]
    *others, end = (piece.last - piece.first for piece in dwells)
    assert (others, end) == ([150, 250], pytest.approx(100, abs=1))  # the last one ends with the sequence
    for piece in dwells:
        assert np.ptp(made.plan[piece.first : piece.last + 1], axis=0) == pytest.approx(np.zeros(6), abs=0)


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
    assert turned.duration == pytest.approx(moved.duration, rel=1e-3)
    assert turned.least is None  # two angles change: their sum is no turn, and the caps alone say nothing


def test_the_arm_has_arrived_when_its_angles_have_too() -> None:
    path = polyline([[0, 0, 0, 0, 0, 0], [0.02, 0, 0, 0.5, 0, 0]], speed=0.2)
    made = dosed_as(FeedTask(path, compliance(), 1e-3), Allowed(0.02, turn_lead=Lead(5.0)))
    turn, way = np.abs(made.x[:, 3] - 0.5), np.abs(made.x[:, 0] - 0.02)
    arrived = 1 + np.flatnonzero((turn > np.radians(0.1)) | (way > 1e-3))[-1]
    assert made.arrived == pytest.approx(arrived * 1e-3)
    assert turn[arrived - 1] > np.radians(0.1)  # the angles came last


def test_what_cannot_be_dosed_says_why() -> None:
    path = polyline([[0.0, 0.0], [0.02, 0.0], [0.02, 0.02]])
    guided = Compliance(np.array([1000.0, 0, 1000, 30, 30, 30]), compliance().D, compliance().M)
    assert "along y, where the stiffness is 0" in refusal(path, guided, 1e-3, 0.005)
    dose(polyline([[0.0], [0.02]]), guided, 1e-3, 0.005)
    unstable = refusal(path, compliance(1000.0, 0.9), 1e-3, 0.005)
    assert "x is unstable: d = 0.9 N s/m must be above h k = 1 N s/m" in unstable
    assert "3000000 rows" in refusal(path, compliance(), 1e-3, 1e-6)


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
        (1.0, 1e-3 * 1.1, "more than the 100 s that dosing allows; raise d, or lower m or h"),
        (1000.0, 1.0000001, "raise d, or lower m or h"),  # all but unstable, however fast the continuous law is
    ],
)
def test_a_law_that_hardly_comes_to_rest_is_refused_at_once(k: float, d: float, says: str) -> None:
    begin = process_time()
    refused = refusal(polyline([[0.0], [0.01]]), compliance(k, d), 1e-3, 0.005)
    assert process_time() - begin < 0.5
    assert says in refused


def test_a_slow_law_on_a_path_that_never_uses_it_is_none_of_dosings_business() -> None:
    law = compliance()
    slow = Compliance(np.r_[1000.0, 1e-3, 1000.0, [30.0] * 3], law.D, law.M)
    made = dose(polyline([[0.0], [0.02]]), slow, 1e-3, 0.005)
    assert made.duration == dose(polyline([[0.0], [0.02]]), law, 1e-3, 0.005).duration


def test_the_exact_law_is_refused_by_its_own_conditions() -> None:
    path = polyline([[0.0], [0.02]])
    assert "must be above h k" in refusal(path, compliance(1000.0, 0.9), 1e-3, 0.005)
    swings = refusal(path, compliance(1000.0, 0.0), 1e-3, 0.005, integration=Integration.EXACT)
    assert "x has d = 0 with k = 1000 N/m: it oscillates forever; give it some damping" in swings
    nearly = refusal(path, compliance(1000.0, 0.1), 1e-3, 0.005, integration=Integration.EXACT)
    assert nearly.endswith("raise d or lower m")
    for message in (swings, nearly):
        assert "above h k" not in message
        assert "below 2 m/h" not in message
    # where Euler is unstable the exact law may well be dosed
    stiff = compliance(300_000.0, 250.0)
    assert "is unstable" in refusal(path, stiff, 1e-3, 0.005)
    dose(path, stiff, 1e-3, 0.005, integration=Integration.EXACT)


def test_the_largest_bound_leaves_the_programmed_time() -> None:
    made = dose(polyline([[0.0], [0.02]]), compliance(), 1e-3, 10.0, turn_bound=np.pi)
    assert made.duration == pytest.approx(0.05, abs=5e-3)


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


def test_the_path_of_a_sequence_is_its_places_at_its_own_pace() -> None:
    equilibrium = ramped()
    path = dose_path(equilibrium)
    assert [(leg.origin, leg.goal, leg.dwell) for leg in path.legs] == [
        ("a", "b", 0),
        ("b", "b", pytest.approx(0.05)),
        ("b", "c", 0),
    ]
    assert path.least_time == pytest.approx(equilibrium.duration)
    slerp = Equilibrium(
        equilibrium.h, equilibrium.pose, equilibrium.R, RotationLaw.SLERP, equilibrium.meaning, equilibrium.pieces
    )
    assert dose_path(slerp).least_time == pytest.approx(equilibrium.duration)
    slower = np.r_[np.full(45, 1.0), np.full(20, 0.25)]
    assert dose_path(equilibrium, slower=slower).least_time == pytest.approx(0.4 + 0.05 + 0.2 / 0.25)


CORNERS = 0.1 * np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 1, 1], [0, 1, 1]], dtype=float)


def test_a_joint_at_its_limit_slows_its_stretch() -> None:
    equilibrium = ramped()
    joints = np.zeros((66, 2))
    joints[45:, 1] = np.linspace(0, 0.3, 21)
    path = dose_path(equilibrium, joints, [1.0, 0.4])
    assert path.least_time == pytest.approx(0.4 + 0.05 + 0.3 / 0.4)
    made = dose(path, compliance(), 0.01, 0.5)
    assert np.max(np.abs(np.diff(np.interp(made.x[:, 1], [0, 0.1], [0, 0.3])))) <= 0.4 * 0.01 * (1 + 1e-9)


PATHS = {
    "corners": CORNERS,
    "there and back": [[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [0.0, 0.0, 0.0]],
    "small steps": [[0.004 * i, 0.004 * (i % 2), 0.0] for i in range(8)],
    "bent": [[0.05 * np.sin(a), 0.05 * (1 - np.cos(a)), 0.02 * a] for a in np.linspace(0, 4, 60)],
}


@pytest.mark.parametrize("name", PATHS)
@pytest.mark.parametrize("lead", [Lead(12.0), Lead(0.06, stretch=True)])
def test_lag_and_push_are_kept_by_a_simulation_of_its_own(name: str, lead: Lead) -> None:
    h, law, path = 4e-3, compliance(), polyline(np.asarray(PATHS[name]))
    made = dosed_as(FeedTask(path, law, h), Allowed(0.003, lead=lead))
    most = lead.most * 1000 if lead.stretch else lead.most
    assert 0.9 * most < check(made, path, law, h, 0.003, most / 1000)


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
def test_on_one_line_no_feed_that_pushes_as_much_is_faster(push: float, length: float) -> None:
    h, law = 5e-3, compliance()
    made = dosed_as(FeedTask(polyline([[0.0], [length]]), law, h), Allowed(0.005, lead=Lead(push)))
    least = least_periods_with_a_push(length, push, law, h, len(made.pose) + 5)
    assert least <= len(made.pose) - 1 <= least + 2  # the arm stands for the first period, and ends on a whole one
    assert made.least <= least * h


def test_the_exact_law_is_dosed_too() -> None:
    path, law = polyline([[0.0, 0.0], [0.1, 0.0], [0.1, 0.1]]), compliance()
    made = dosed_as(FeedTask(path, law, 1e-3, Integration.EXACT), Allowed(0.002, lead=Lead(80.0)))
    assert made.lag.maximum <= 0.002 * (1 + 1e-9)
    assert made.push <= 80 * (1 + 1e-9)
    rough = dosed_as(FeedTask(path, law, 1e-3), Allowed(0.002, lead=Lead(80.0)))
    assert made.duration == pytest.approx(rough.duration, rel=0.02)


def skew(rotation):
    """A tool that turns about a skew axis and back, while it moves."""
    turned = Rotation.from_rotvec(np.radians(25) * np.array([1.0, 2.0, -1.0]) / np.sqrt(6)) * Rotation.from_euler(
        "xyz", [0.3, 1.0, -0.5]
    )
    first, second = (one.as_euler("xyz") for one in (Rotation.from_euler("xyz", [0.3, 1.0, -0.5]), turned))
    points = [np.r_[0, 0, 0, first], np.r_[0.02, 0, 0, second], np.r_[0.02, 0.02, 0, first]]
    waypoints = tuple(Waypoint(f"p{i}", point, f"poses[{i}]") for i, point in enumerate(points))
    speeds = np.tile([V, 1.0, 1.5, 5.0, np.nan, np.nan], (2, 1))
    return Route(waypoints, speeds, 8e-3, Profile.TRAPEZOID, rotation, AngleMeaning.ABSOLUTE)


@pytest.mark.parametrize("rotation", list(RotationLaw))
def test_the_turn_lag_is_the_angle_between_the_orientations(rotation: RotationLaw) -> None:
    h, law, bound = 8e-3, compliance(), np.radians(1.0)
    path = dose_path(interpolate(skew(rotation)))
    made = dosed_as(FeedTask(path, law, h), Allowed(0.002, float(bound), turn_lead=Lead(2.0)))
    # the controller again: angles by eq. 4.13, or log(R R_e^T) in world axes, by SciPy
    u = np.concatenate([made.pose, np.repeat(made.pose[-1:], 250, axis=0)])
    plan = Rotation.from_matrix(np.concatenate([made.R_plan, np.repeat(made.R_plan[-1:], 250, axis=0)]))
    K, D, M = law.K[3:], law.D[3:], law.M[3:]
    if rotation is RotationLaw.TAIT_BRYAN:
        x, v, rows = made.plan[0, 3:].copy(), np.zeros(3), []
        for k in range(len(u)):
            rows.append(x)
            x, v = x + h * v, v + h / M * (K * (u[k, 3:] - x) - D * v)
        answer = Rotation.from_euler("xyz", rows)
    else:
        fed = Rotation.from_matrix(np.concatenate([made.R, np.repeat(made.R[-1:], 250, axis=0)]))
        x, v, turns, back = plan[0], np.zeros(3), [], fed.inv()
        for k in range(len(u)):
            turns.append(x)
            x, v = (
                Rotation.from_rotvec(h * v) * x,
                v + h / M * (-D * v - K * (x * back[k]).as_rotvec()),
            )
        answer = Rotation.concatenate(turns)
    lag = (answer * plan.inv()).magnitude()
    assert np.max(lag) <= bound * (1 + 1e-6)
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


def test_a_feed_that_would_turn_too_far_ahead_is_slowed_down_unless_its_bound_says_so() -> None:
    path = polyline([[0, 0, 0, 0, 0, 0], [0, 0, 0, 1.2, 0, 0]], speed=6.0)  # D/K times 6 rad/s is 4 rad
    made = dosed_as(FeedTask(path, compliance(), 2e-3), Allowed(0.01))
    assert np.max(np.linalg.norm(made.pose[:, 3:] - made.plan[:, 3:], axis=1)) < np.radians(150)
    with pytest.raises(CannotDose, match="turned ahead"):
        dosed_as(FeedTask(path, compliance(), 2e-3), Allowed(0.01, turn_lead=Lead(1000.0)))
