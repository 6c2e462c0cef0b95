"""What is granted at stops, to a hair, and what is told of them: rests and rides of a rail, known in closed form."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from by_hand import H, Ride, at, one_of, seen, stops_of
from legal_motion import Case, home, move_ext, move_j, move_l, plant_with_rail, program, wait
from legal_runs import Z10

from trajopt_cli.geometry import pose
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.judge import tolerances as tol
from trajopt_cli.motion import Motion, UnitMove
from trajopt_cli.trajectory import Trajectory

PLANT = plant_with_rail()
A_TCP, A_RAIL = PLANT.tcp.acceleration, float(PLANT.limits.acceleration[0])
KINDS = {"marked": (True, 0.0, 0.0), "bare": (False, 0.0, 0.0), "printed": (False, 1e-6, 1e-5)}
# marked, steps of positions and speeds, steps of times


def steps_of(kind: str, speeds: bool = True) -> Resolution | None:
    _, r, r_t = KINDS[kind]
    return None if not r else Resolution(r_t, np.full(7, r), np.full(7, r * speeds))


def granted(kind: str) -> tuple[float, float, float]:
    """tau, and what digits leave open of the tool's position and speed: at the tool every axis counts by its column."""
    marked, r, r_t = KINDS[kind]
    J = PLANT.robot.jacobian(PLANT.start[None])[0][:3]
    columns = float(np.linalg.norm(J, axis=0).sum())
    step = max(r, 1e-12)
    return (0.0 if marked else (H + r_t) / 2), columns * step / 2, columns * step / 2


def there(line: int, d: float, **more: object) -> Motion:
    return move_j(line, f"p_{line}", at(d), **more)


BASE = ((0.0, 4), (0.5, 12), (0.2, 5))


def moved(trajectory: Trajectory, rows: slice, column: int, q: float = 0.0, qd: float = 0.0) -> Trajectory:
    new_q, new_qd = trajectory.q.copy(), None if trajectory.qd is None else trajectory.qd.copy()
    new_q[rows, column] += q
    if new_qd is not None:
        new_qd[rows, column] += qd
    return replace(trajectory, q=new_q, qd=new_qd)


@pytest.mark.parametrize("over", [0.99, 1.01])
@pytest.mark.parametrize("kind", KINDS)
def test_how_far_from_a_point_a_stop_may_be(kind: str, over: float) -> None:
    """A micron, what digits leave open, and a tau^2/2; beyond it the nearest row before the next stop is told."""
    tau, doubt_p, _ = granted(kind)
    ride = Ride(BASE)
    off = over * (tol.STOP_POSITION + A_TCP * tau**2 / 2 + doubt_p)
    for sign in (1, -1):
        found = stops_of([there(11, 0.5 + sign * off)], ride.rows(), KINDS[kind][0], steps_of(kind))
        if over < 1:
            rest = one_of(found, "stop rest", 11)
            assert rest.passed
            assert rest.time == pytest.approx(ride.t[ride.first[1]])
            continue
        missed = one_of(found, "stop reached", 11)
        assert not missed.passed
        assert (missed.value, missed.limit, missed.unit) == (pytest.approx(off, rel=1e-6), tol.STOP_POSITION, "m")
        # going away on the side where the point is it comes nearer, by a whole step of its way
        assert ride.first[1] <= round(missed.time / H) <= ride.last[1]
        assert "p_11 is not reached in program order, the TCP runs 0 m/s there" in missed.message


@pytest.mark.parametrize("over", [0.99, 1.01])
@pytest.mark.parametrize("kind", KINDS)
def test_how_far_a_stop_may_be_turned(kind: str, over: float) -> None:
    """All rotary axes at their limits for tau, and what digits leave open."""
    tau = granted(kind)[0]
    alpha = float(PLANT.limits.acceleration[1:].sum())
    J = PLANT.robot.jacobian(PLANT.start[None])[0][3:]
    doubt = float(np.linalg.norm(J, axis=0).sum()) * max(KINDS[kind][1], 1e-12) / 2
    off = over * (tol.STOP_ROTATION + alpha * tau**2 / 2 + doubt)
    X = at(0.5)
    turned = move_j(11, "p_11", pose(X[:3, :3] @ np.array(
        [[np.cos(off), -np.sin(off), 0], [np.sin(off), np.cos(off), 0], [0, 0, 1]]), X[:3, 3]))  # fmt: skip
    found = stops_of([turned], Ride(BASE).rows(), KINDS[kind][0], steps_of(kind))
    if over < 1:
        assert one_of(found, "stop rest", 11).passed
        return
    missed = one_of(found, "stop reached", 11)
    assert (missed.value, missed.limit, missed.unit) == (pytest.approx(off, rel=1e-5), tol.STOP_ROTATION, "rad")


@pytest.mark.parametrize("over", [0.99, 1.01])
@pytest.mark.parametrize("kind", KINDS)
def test_how_fast_a_stop_may_be(kind: str, over: float) -> None:
    """1e-5 m/s and a tau: what the tool does beyond what digits leave open; and the same of its turning."""
    tau, _, doubt_V = granted(kind)
    ride = Ride(BASE)
    limit = tol.REST_LINEAR + A_TCP * tau
    at_stop = slice(ride.first[1], ride.last[1] + 1)
    # a turned Jacobian counts at the speed of all axes, here the rail's
    fractions = doubt_V + over * limit * doubt_V if KINDS[kind][1] else doubt_V
    fast = moved(ride.rows(), at_stop, 0, qd=over * limit + fractions)
    rest = one_of(stops_of([there(11, 0.5)], fast, KINDS[kind][0], steps_of(kind)), "stop rest", 11)
    assert (rest.value, rest.limit, rest.unit) == (pytest.approx(over * limit, rel=1e-5), pytest.approx(limit), "m/s")
    assert rest.passed == (over < 1)
    if over > 1:
        told = "" if KINDS[kind][0] else f" (rows {2 * tau:.3g} s apart show rest to this)"
        assert rest.message.endswith(f" at MoveJ p_11{told}")
    alpha = float(PLANT.limits.acceleration[1:].sum())
    limit = tol.REST_ANGULAR + alpha * tau
    if kind != "printed":
        # joint 6 turns the tool about its own axis
        turning = moved(ride.rows(), at_stop, 6, qd=over * limit)
        rest = one_of(stops_of([there(11, 0.5)], turning, KINDS[kind][0], steps_of(kind)), "stop rest", 11)
        assert rest.passed == (over < 1)
        if over > 1:
            assert (rest.value, rest.unit) == (pytest.approx(over * limit, rel=1e-6), "rad/s")
            assert rest.limit == tol.REST_ANGULAR


@pytest.mark.parametrize("over", [0.99, 1.01])
@pytest.mark.parametrize("kind", KINDS)
def test_how_far_a_rail_may_be_off_its_target(kind: str, over: float) -> None:
    """A micron, half a printed step, and A tau^2/2 beside where the rail stands or, without rows at boundaries, may be
    half a gap away, where robtargets keep their rail; told are its place nearest to the target, and that."""
    tau = granted(kind)[0]
    off = over * (tol.JOINT_TARGET + max(KINDS[kind][1], 1e-12) / 2 + A_RAIL * tau**2 / 2)
    plant, ride = plant_with_rail(rail_fixed=True), Ride(BASE)
    d = ride.rows().q[:, 0]
    away = min(d[ride.first[1] - 1], d[ride.last[1] + 1])  # it comes from there or goes there: half a gap, half the way
    for sign in (1, -1):
        edge = 0.5 if sign > 0 or kind == "marked" else (0.5 + away) / 2
        asked = [move_j(11, "p_11", at(0.5), edge + sign * off)]
        found = one_of(stops_of(asked, ride.rows(), KINDS[kind][0], steps_of(kind), plant=plant), "rail target", 11)
        assert found.passed == (over < 1)
        assert found.limit == pytest.approx(edge + sign * off)
        assert found.value == pytest.approx(edge, rel=1e-9)
        alone = one_of(stops_of([move_ext(11, 0.5 + sign * off)], Ride(BASE).rows(), KINDS[kind][0], steps_of(kind)),
                       "stop rest" if over < 1 else "stop reached", 11)  # fmt: skip
        assert alone.passed == (over < 1)
        if over > 1:
            assert (alone.subject, alone.unit, alone.limit) == ("rail", "m", tol.JOINT_TARGET)
            assert alone.value == pytest.approx(off, rel=1e-6)


@pytest.mark.parametrize("over", [0.99, 1.01])
@pytest.mark.parametrize("kind", KINDS)
def test_how_far_an_arm_may_be_off_its_joints(kind: str, over: float) -> None:
    tau, ride = granted(kind)[0], Ride(BASE)
    for joint in (1, 6):
        off = over * (
            tol.JOINT_TARGET + max(KINDS[kind][1], 1e-12) / 2 + float(PLANT.limits.acceleration[joint]) * tau**2 / 2
        )
        q = PLANT.start[1:].copy()
        q[joint - 1] -= off
        asked = [there(11, 0.5), replace(home(99, 0.2), q=q)]
        end = one_of(
            stops_of(asked, ride.rows(), KINDS[kind][0], steps_of(kind)),
            "stop rest" if over < 1 else "stop reached",
            99,
        )
        assert end.passed == (over < 1)
        if over > 1:
            assert (end.subject, end.unit) == ("arm", "rad")
            assert (end.value, end.limit) == (pytest.approx(off, rel=1e-6), tol.JOINT_TARGET)


@pytest.mark.parametrize("kind", KINDS)
def test_how_much_of_a_wait_may_be_missing(kind: str) -> None:
    """Nearly two gaps at each end where boundaries have no rows, and the printed step of times."""
    marked, _, r_t = KINDS[kind]
    ride = Ride(BASE)
    shown = 11 * H
    slack = tol.DWELL + (r_t or 4 * 2.3e-16) + 4 * granted(kind)[0]
    for more in (-1e-9, 1e-9):
        asked = [there(11, 0.5), wait(12, shown + slack + more * 0.9)]
        found = one_of(stops_of(asked, ride.rows(), marked, steps_of(kind)), "dwell length", 12)
        assert found.passed == (more < 0)
        assert (found.value, found.limit) == (pytest.approx(shown, abs=1e-12), pytest.approx(shown + slack, abs=2e-9))
        assert found.time == pytest.approx(ride.t[ride.first[1]])
    # of two waits the first one takes its time whole
    both = stops_of([there(11, 0.5), wait(12, 0.06), wait(13, 0.06)], ride.rows(), marked, steps_of(kind))
    assert one_of(both, "dwell length", 12).value == pytest.approx(0.06)
    second = one_of(both, "dwell length", 13)
    assert (second.value, second.time) == (pytest.approx(shown - 0.06), pytest.approx(ride.t[ride.first[1]] + 0.06))


def timed(d: float, T: float, **more: object) -> Motion:
    return there(11, d, duration=T, **more)


@pytest.mark.parametrize("kind", KINDS)
def test_how_long_a_programmed_time_may_take(kind: str) -> None:
    """From the last row of the rest before it, or any earlier one that no wait needs, to the first row of the next, or
    any later one; more and less by a microsecond, two steps of times, and by three gaps without rows at boundaries."""
    marked, _, r_t = KINDS[kind]
    ride = Ride(((0.0, 4), (0.5, 12), (0.9, 7), (0.2, 5)))
    # the second move: 12 rows of rest before it, of which a wait of 5 gaps needs some; 7 behind it, and a wait of 3
    least, most = 7 * H, (7 + 6 + 3) * H
    unsure = tol.DURATION + 2 * (r_t or 4 * 2.3e-16 * 0.3) + 6 * granted(kind)[0]
    for T, taken, passed in (
        (least + 2.5 * H, least + 2.5 * H, True), (least - unsure + 1e-8, least, True),
        (least - unsure - 1e-8, least, False), (most + unsure - 1e-8, most, True),
        (most + unsure + 1e-8, most, False), (most, most, True),
    ):  # fmt: skip
        if T <= 0:
            continue
        asked = [there(11, 0.5), wait(12, 5 * H), there(13, 0.9, duration=T), wait(14, 3 * H)]
        found = one_of(stops_of(asked, ride.rows(), marked, steps_of(kind)), "duration", 13)
        assert (found.value, found.limit) == (pytest.approx(taken, abs=1e-9), pytest.approx(T))
        assert found.passed == passed, (T / H, found.message)
        assert found.time == pytest.approx(ride.t[ride.first[2]])
        unit = UnitMove("stn", 1, 0.0, 1.0, T, False, 9.0, 9.0, (0.0, 0.0, 0.0), (0.0, 0.0, 1.0))
        asked[2] = there(13, 0.9, units=(unit,))
        found = one_of(stops_of(asked, ride.rows(), marked, steps_of(kind)), "positioner", 13)
        assert found.passed == (most + unsure > T)
        assert (found.value, found.limit) == (pytest.approx(min(max(T, least), most), abs=1e-9), pytest.approx(T))


@pytest.mark.parametrize("kind", ["marked", "bare"])
def test_a_programmed_time_of_a_move_that_stays(kind: str) -> None:
    """It takes what the rest has beside its waits."""
    ride = Ride(BASE)
    unsure = tol.DURATION + 6 * granted(kind)[0]
    for T, passed in ((11 * H - 0.02 + unsure - 1e-8, True), (11 * H - 0.02 + unsure + 1e-8, False)):
        asked = [there(11, 0.5), move_l(12, "p_12", at(0.5), duration=T), wait(13, 0.02)]
        found = one_of(stops_of(asked, ride.rows(), KINDS[kind][0]), "duration", 12)
        assert found.passed == passed
        assert (found.value, found.limit) == (pytest.approx(11 * H - 0.02), pytest.approx(T))


@pytest.mark.parametrize("speeds", [True, False])
@pytest.mark.parametrize("step", [None, 1e-5])
@pytest.mark.parametrize("over", [0.9, 1.1])
def test_both_ends_of_a_file(over: float, step: float | None, speeds: bool) -> None:
    """Every axis where the cycle begins to a micron and half a step; all at rest to 1e-5, without speeds as fast as a
    rest allows in the row beside it."""
    r = step or 1e-12
    steps = None if step is None else Resolution(0.0, np.full(7, step), np.full(7, step * speeds))
    ride = Ride(BASE)
    n = len(ride.t)
    for column, name, unit in ((0, "rail", "m"), (5, "joint_5", "rad")):
        off = over * (tol.JOINT_TARGET + r / 2)
        for sign in (1, -1):
            rows = moved(ride.rows(speeds), slice(0, 4), column, q=sign * off)
            start = one_of(stops_of([there(11, 0.5)], rows, steps=steps), "start")
            assert start.passed == (over < 1)
            assert (start.subject, start.unit, start.time) == (name, unit, 0.0)
            wanted = float(PLANT.start[column])
            assert (start.value, start.limit) == (pytest.approx(wanted + sign * off), pytest.approx(wanted))
        for end, row in (("start rest", 0), ("end rest", n - 1)):
            A = float(PLANT.limits.acceleration[column])
            rows = ride.rows(speeds)
            if speeds:
                rows = moved(rows, slice(row, row + 1), column, qd=-(over * tol.REST_JOINT + r))
            else:
                way = (over * tol.REST_JOINT + A * H / 2) * H + r
                rows = moved(rows, slice(row, row + 1), column, q=way)
            found = one_of(stops_of([there(11, 0.5)], rows, steps=steps), end)
            assert found.passed == (over < 1), (end, found)
            assert (found.subject, found.unit) == (name, f"{unit}/s")
            assert (found.value, found.limit) == (pytest.approx(over * tol.REST_JOINT, rel=1e-3), tol.REST_JOINT)
            assert found.time == pytest.approx(ride.t[row])


@pytest.mark.parametrize("marked", [True, False])
def test_a_point_that_is_not_passed_is_told_by_how_much(marked: bool) -> None:
    """How near the chords come between the points beside it, less what the tool may be off them; and when."""
    ride = Ride(BASE)
    X = at(0.3)
    X[2, 3] += 0.05
    zone = replace(Z10, radius=0.01)
    found = one_of(stops_of([move_j(10, "p_10", X, zone=zone), there(11, 0.5)], ride.rows(), marked), "fly-by passed")
    J = PLANT.robot.jacobian(PLANT.start[None])[0][:3]
    reach = A_TCP * H**2 / 8 + float(np.linalg.norm(J, axis=0).sum()) * 1e-12 / 2
    assert (found.value, found.limit, found.unit) == (pytest.approx(0.05 - reach, abs=1e-9), 0.01, "m")
    assert (found.passed, found.time) == (False, pytest.approx(ride.t[3 + int(0.3 / 0.5 * 7)]))
    assert found.message.endswith("at most 0.01: MoveJ p_10 is not passed in program order")
    X[2, 3] -= 0.045
    passed = one_of(stops_of([move_j(10, "p_10", X, zone=zone), there(11, 0.5)], ride.rows(), marked), "fly-by passed")
    assert (passed.value, passed.passed) == (pytest.approx(0.005 - reach, abs=1e-9), True)
    assert passed.time == pytest.approx(ride.t[3 + int(0.3 / 0.5 * 7)])


def test_rows_behind_the_last_point() -> None:
    ride = Ride((*BASE, (0.25, 3)))
    found = one_of(stops_of([there(11, 0.5)], ride.rows()), "end")
    assert (found.value, found.limit, found.passed) == (pytest.approx(9 * H), 0.0, False)
    assert found.time == pytest.approx(ride.t[ride.last[2]])
    assert "nothing may follow MoveJ p_99" in found.message
    assert one_of(stops_of([there(11, 0.5)], Ride(BASE).rows()), "end").value == 0.0


@pytest.mark.parametrize("over", [0.99, 1.01])
@pytest.mark.parametrize("kind", ["marked", "bare"])
def test_every_axis_rests_where_a_controller_stops_it(kind: str, over: float) -> None:
    """RAPID: at arrival, departure and the end of a wait 1e-5 and A tau; the axis that uses most of it is told."""
    tau, ride = granted(kind)[0], Ride(BASE)
    part = slice(ride.first[1], ride.last[1] + 1)
    joint = 6
    limit = tol.REST_JOINT + float(PLANT.limits.acceleration[joint]) * tau
    rows = ride.rows()
    # joint 6 turns the tool less than joint 1 and 6 against each other; the tool may turn by more than one axis has
    rows = moved(rows, part, joint, qd=over * limit)
    rows = moved(rows, part, 1, qd=0.5 * tol.REST_JOINT)
    found = stops_of([there(11, 0.5), wait(12, 0.02)], rows, KINDS[kind][0], rapid=True)
    told = [f for f in found if f.check == "axes rest"]
    if kind == "marked" and over > 1:  # the tool turns too fast as well
        assert any(f.check == "stop rest" and not f.passed for f in found)
    mine = [f for f in told if f.source and f.source.line in (11, 12)]
    assert len(mine) == 3
    for one in mine:
        assert one.passed == (over < 1)
        assert (one.subject, one.unit) == ("joint_6", "rad/s")
        assert (one.value, one.limit) == (pytest.approx(over * limit), pytest.approx(limit))


def test_a_wait_on_a_condition_ends_when_every_axis_rests() -> None:
    """The axes come to rest some rows into the wait: what follows begins then; never, and it is told so."""
    ride = Ride(BASE)
    first, last = ride.first[1], ride.last[1]
    asked = [there(11, 0.5), wait(12, 0.0, "di_go"), wait(13, 5 * H)]
    still = tol.REST_JOINT + A_RAIL * H / 2
    for moving in (0, 4, 8, 9):
        for over in (0.99, 1.01):
            rows = moved(ride.rows(), slice(first, first + moving), 0, qd=-over * still)
            found = stops_of(asked, rows)
            late = moving if over > 1 else 0
            assert one_of(found, "dwell rest", 12).time == pytest.approx(ride.t[first + late])
            left = one_of(found, "dwell length", 13)
            assert left.time == pytest.approx(ride.t[first + late])
            assert left.value == pytest.approx(min(5, 11 - late) * H)
            assert left.passed == (late <= 8)  # but for two gaps
    rows = moved(ride.rows(), slice(first, last + 1), 0, qd=-1.01 * still)
    never = one_of(stops_of(asked, rows), "dwell rest", 12)
    assert (never.passed, never.subject, never.unit) == (False, "rail", "m/s")
    assert (never.value, never.limit) == (pytest.approx(1.01 * still), tol.REST_JOINT)
    assert never.time == pytest.approx(ride.t[last])


@pytest.mark.parametrize("over", [0.9, 1.1])
def test_a_drift_is_told_where_it_is_farthest(over: float) -> None:
    """Within the time of the waits alone; a row within a gap of a boundary may belong to the motion beside it."""
    ride = Ride(BASE)
    first = ride.first[1]
    for row, seen_at in ((3, True), (6, True), (9, False), (11, False)):
        for marked in (True, False):
            off = over * tol.STOP_POSITION
            rows = moved(ride.rows(), slice(first + row, first + row + 1), 0, q=off)
            found = stops_of([there(11, 0.5), wait(12, 8 * H)], rows, marked)
            drift = one_of(found, "dwell drift", 12)
            if seen_at:
                assert drift.passed == (over < 1)
                assert drift.value == pytest.approx(off, rel=1e-4)
                assert drift.time == pytest.approx(ride.t[first + row])
            else:
                assert drift.passed


def test_what_follows_a_point_takes_it_from_there() -> None:
    """The motion under way: that which ends next, or the wait that goes on."""
    ride = Ride(((0.0, 4), (0.5, 12), (0.9, 7), (0.2, 5)))
    asked = program(there(11, 0.5), wait(12, 5 * H), wait(13, 3 * H), there(14, 0.9), home(15, 0.2))
    line, _ = seen(Case(PLANT, asked, ()), ride.rows(), None)
    arrive = ride.t[ride.first]
    for time, wanted in (
        (0.0, None), (1e-4, 11), (arrive[1] - 1e-6, 11), (arrive[1] + 1e-6, 12), (arrive[1] + 5 * H - 1e-6, 12),
        (arrive[1] + 5 * H + 1e-6, 13), (arrive[1] + 8 * H + 1e-6, 14), (arrive[2] - 1e-6, 14),
        (arrive[2] + 1e-6, 15), (arrive[3], 15), (arrive[3] + 1.0, 15),
    ):  # fmt: skip
        source = line.source_at(time)
        assert (None if source is None else source.line) == wanted, time
