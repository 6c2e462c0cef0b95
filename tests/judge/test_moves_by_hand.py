"""What moves may do between their points, of a rail in closed form: what their settings ask for, a rail that is held,
an arm that holds, joint moves that a controller runs straight, programmed speeds; each a hair inside and outside."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
from by_hand import H, Ride, at, one_of, seen
from legal_motion import Case, home, move_ext, move_j, move_l, plant_with_rail, program, wait

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.judge import tolerances as tol
from trajopt_cli.judge.caps import check_caps
from trajopt_cli.judge.demands import check_demands
from trajopt_cli.judge.lines import check_shapes
from trajopt_cli.judge.rail import still_from
from trajopt_cli.judge.rail_hold import check_held
from trajopt_cli.judge.samples import judged_rows
from trajopt_cli.motion import Hold, Motion, Settings, Speed
from trajopt_cli.trajectory import Trajectory

PLANT = plant_with_rail()
A_RAIL = float(PLANT.limits.acceleration[0])
UP, DOWN, STEP = 2.0, 1.0, 0.004  # m/s2, m/s2, s: what the rail does, and every so often
N_UP = 30  # rows


def push() -> tuple[Array, Array, Array]:
    """Times, positions and speeds of a rail that rests for 5 rows, speeds up, slows down, and rests for 5 rows."""
    n = 5 + N_UP + 2 * N_UP + 5
    t = np.arange(n) * STEP
    u = np.clip(t - 5 * STEP, 0, 3 * N_UP * STEP)
    early, late = np.minimum(u, N_UP * STEP), np.maximum(u - N_UP * STEP, 0.0)
    top = UP * N_UP * STEP
    return t, UP * early**2 / 2 + top * late - DOWN * late**2 / 2, UP * early - DOWN * late


def pushed(speeds: bool) -> Trajectory:
    t, d, v = push()
    q, qd = np.tile(PLANT.start, (len(t), 1)), np.zeros((len(t), 7))
    q[:, 0], qd[:, 0] = d, v
    return Trajectory(PLANT.limits.names, t, q, qd if speeds else None)


END = float(push()[1][-1])


def told(of: str, motions: Sequence[Motion], rows: Trajectory, marked: bool, steps: Resolution | None = None,
         rapid: bool = False) -> list[Finding]:  # fmt: skip
    line, frames = seen(Case(PLANT, program(*motions), ()), rows, steps, rapid, marked)
    if of == "held":
        return check_held(line, frames)
    made = {"demands": lambda: check_demands(line, frames), "caps": lambda: check_caps(line, frames),
            "shapes": lambda: check_shapes(line, frames, rapid)}[of]()  # fmt: skip
    return [finding for _, found in made for finding in found]


@pytest.mark.parametrize("over", [0.9, 1.1])
@pytest.mark.parametrize("speeds", [True, False])
@pytest.mark.parametrize("marked", [True, False])
@pytest.mark.parametrize("make", [move_j, move_l])
def test_what_a_move_asks_for(make: object, marked: bool, speeds: bool, over: float) -> None:
    """2 m/s2 up and 1 m/s2 down of the rail are those of the tool, on one line: of an axis to a millionth, of the tool
    to a ten thousandth. Without speeds the way of a line alone shows what is along it."""

    def asked(**settings: float) -> list[Finding]:
        move = replace(make(11, "p_11", at(END)), settings=Settings(**settings))
        return told("demands", [move], pushed(speeds), marked)

    assert asked() == []
    share = UP / A_RAIL / (1 + over * tol.JOINT)
    axis, tool = asked(acceleration=share)
    assert (axis.check, axis.subject, axis.unit) == ("AccSet", "rail", "m/s2")
    assert (axis.value, axis.limit) == (pytest.approx(UP, rel=1e-9), pytest.approx(share * A_RAIL))
    assert axis.passed == (over < 1)
    assert 5 * STEP <= axis.time <= (5 + N_UP) * STEP
    assert tool.passed
    assert tool.limit == pytest.approx(share * PLANT.tcp.acceleration)
    share = UP / PLANT.tcp.acceleration / (1 + over * tol.TCP)
    tool = asked(acceleration=share)[1]
    assert (tool.check, tool.subject) == ("AccSet", "TCP")
    assert (tool.value, tool.passed) == (pytest.approx(UP, rel=1e-7), over < 1)
    (world,) = asked(world_acceleration=UP / (1 + over * tol.TCP))
    assert (world.check, world.subject, world.unit) == ("WorldAccLim", "TCP", "m/s2")
    assert (world.value, world.passed) == (pytest.approx(UP, rel=1e-7), over < 1)
    assert "WorldAccLim allows" in world.message or world.passed
    for name, value in (("path_acceleration", UP), ("path_deceleration", DOWN)):
        found = asked(**{name: value / (1 + over * tol.TCP)})
        if not speeds and make is not move_l:
            assert found == []
            continue
        (one,) = found
        assert one.check == "PathAccLim"
        assert (one.value, one.passed) == (pytest.approx(value, rel=1e-7), over < 1)
        assert (one.time < (5 + N_UP) * STEP) == (name == "path_acceleration")


def test_printed_digits_count_along_the_path() -> None:
    """Of a difference of speeds both doubts, of the time between them both halves of their steps."""
    r, r_v, r_t = 1e-6, 1e-4, 2e-4
    steps = Resolution(r_t, np.full(7, r), np.full(7, r_v))
    move = replace(move_j(11, "p_11", at(END)), settings=Settings(path_acceleration=0.5))
    (found,) = told("demands", [move], pushed(True), False, steps)
    t, _, v = push()
    J = PLANT.robot.jacobian(PLANT.start[None])[0][:3]
    columns = float(np.linalg.norm(J, axis=0).sum())
    doubt = columns * r_v / 2 + np.abs(v) * columns * r / 2
    first, last = 4 + 1, len(t) - 5 - 1
    wanted = max(
        (v[i + m] - v[i] - doubt[i + m] - doubt[i]) / (t[i + m] - t[i] + r_t)
        for m in (1, 2, 4, 8, 16, 32) for i in range(first, last - m + 1)
    )  # fmt: skip
    assert found.value == pytest.approx(wanted, rel=1e-6)


def test_settings_that_both_allow() -> None:
    """In the zone between two moves the greater of each, and no limit where one of them has none."""
    from trajopt_cli.judge.demands import _looser

    one = Settings(acceleration=0.5, path_acceleration=1.0, path_deceleration=4.0, world_acceleration=2.0)
    other = Settings(acceleration=0.4, path_acceleration=3.0, path_deceleration=2.0, world_acceleration=5.0)
    for a, b in ((one, other), (other, one)):
        both = _looser(a, b)
        assert (both.acceleration, both.path_acceleration, both.path_deceleration) == (0.5, 3.0, 4.0)
        assert both.world_acceleration == 5.0
        none = _looser(a, Settings())
        assert (none.acceleration, none.path_acceleration, none.world_acceleration) == (1.0, None, None)


@pytest.mark.parametrize("over", [0.9, 1.1])
@pytest.mark.parametrize("speeds", [True, False])
@pytest.mark.parametrize("marked", [True, False])
def test_programmed_speeds_hold_to_a_hair(marked: bool, speeds: bool, over: float) -> None:
    """The rail at 0.24 m/s is the tool's speed as well: of the rail to a millionth, of the tool to a ten thousandth;
    the fastest row is the one at the top, or the interval beside it."""
    top = UP * N_UP * STEP
    seen_top = top if speeds else top - DOWN * STEP / 2
    for name, tolerance in (("v_tcp", tol.TCP), ("v_leax", tol.JOINT)):
        speed = replace(Speed("v", 5.0, 5.0, 5.0, 5.0), **{name: seen_top / (1 + over * tolerance)})
        asked = [move_j(11, "p_11", at(END), speed=speed)]
        found = [f for f in told("caps", asked, pushed(speeds), marked) if f.check == "programmed speed"]
        subject = "TCP" if name == "v_tcp" else "rail"
        (mine,) = (f for f in found if f.subject == subject)
        assert (mine.value, mine.passed) == (pytest.approx(seen_top, rel=1e-7), over < 1)
        assert mine.time == pytest.approx((5 + N_UP) * STEP, abs=1.01 * STEP)
        assert mine.unit == "m/s"
        if over > 1:
            assert "v allows" in mine.message
        free = [f for f in told("caps", [replace(asked[0], duration=0.5)], pushed(speeds), marked)]
        assert not [f for f in free if f.check == "programmed speed"]
    alone = [move_ext(11, END)]
    for v_leax, passed in ((top / (1 + 0.9e-6), True), (top / (1 + 1.1e-6), False)):
        asked = [replace(alone[0], speed=Speed("v", 1e-3, 1e-3, v_leax, 1e-3))]
        found = [f for f in told("caps", asked, pushed(True), marked) if f.check == "programmed speed"]
        assert [(f.subject, f.passed) for f in found] == [("rail", passed)]


@pytest.mark.parametrize("over", [0.99, 1.01])
@pytest.mark.parametrize("kind", ["marked", "bare", "printed"])
def test_an_arm_holds_while_the_rail_rides(kind: str, over: float) -> None:
    """A micron, the steps of both rows, and A tau^2/2 where boundaries have no rows; the joint that is off most."""
    r = 1e-6 if kind == "printed" else 1e-12
    tau = 0.0 if kind == "marked" else H / 2
    ride = Ride(((0.0, 4), (0.5, 6), (0.2, 5)))
    steps = Resolution(0.0, np.full(7, r), np.full(7, r))
    for joint in (1, 6):
        off = over * tol.JOINT_TARGET + r + float(PLANT.limits.acceleration[joint]) * tau**2 / 2
        rows = ride.rows()
        q = rows.q.copy()
        q[ride.first[2] - 3, joint] -= off
        asked = [move_j(11, "p_11", at(0.5)), move_ext(12, 0.2), home(13, 0.2)]
        found = one_of(told("shapes", asked, replace(rows, q=q), kind == "marked", steps), "arm holds")
        assert found.passed == (over < 1)
        assert (found.subject, found.unit, found.limit) == (f"joint_{joint}", "rad", tol.JOINT_TARGET)
        assert found.value == pytest.approx(over * tol.JOINT_TARGET, abs=1e-9)
        assert found.time == pytest.approx(ride.t[ride.first[2] - 3])


@pytest.mark.parametrize("over", [0.99, 1.01])
@pytest.mark.parametrize("kind", ["marked", "bare", "printed"])
def test_a_controller_runs_joint_moves_straight(kind: str, over: float) -> None:
    """The rail goes alone: any other axis in the middle of its way is off by a micron and what is open at both rests
    and at the row at most; the rail itself may go at any pace."""
    r = 1e-6 if kind == "printed" else 1e-12
    tau = 0.0 if kind == "marked" else H / 2
    ride = Ride(((0.0, 4), (0.5, 6), (0.2, 5)))
    steps = Resolution(0.0, np.full(7, r), np.full(7, r))
    for joint in (1, 6):
        off = over * tol.JOINT_TARGET + r / 2 + 2 * (r / 2 + float(PLANT.limits.acceleration[joint]) * tau**2 / 2)
        rows, row = ride.rows(), ride.first[1] - 3
        q = rows.q.copy()
        q[row, joint] += off
        q[row + 1, 0] += 0.01
        asked = [move_j(11, "p_11", at(0.5)), home(13, 0.2)]
        found = one_of(told("shapes", asked, replace(rows, q=q), kind == "marked", steps, True), "joint line", 11)
        assert found.passed == (over < 1), found
        assert (found.subject, found.unit, found.limit) == (f"joint_{joint}", "rad", tol.JOINT_TARGET)
        assert found.value == pytest.approx(over * tol.JOINT_TARGET, abs=1e-9)
        assert found.time == pytest.approx(ride.t[row])
        assert "a RAPID controller runs MoveJ p_11 straight in the joints" in found.message or over < 1
        assert not [f for f in told("shapes", asked, replace(rows, q=q), True, steps) if f.check == "joint line"]


@pytest.mark.parametrize("way", [0.5, 0.02, -0.02])
def test_a_joint_move_ends_where_it_ends(way: float) -> None:
    """However short it is its rows are on it, but none before its start or beyond its end."""
    ride = Ride(((0.0, 4), (way, 6), (0.2, 5)))
    asked = [move_j(11, "p_11", at(way)), home(13, 0.2)]
    for row, off in ((None, 0.0), (4, -way), (ride.first[1] - 1, way)):
        rows = ride.rows()
        q = rows.q.copy()
        if row is not None:
            q[row, 0] += off
        found = one_of(told("shapes", asked, replace(rows, q=q), True, None, True), "joint line", 11)
        beyond = 0.0 if row is None else abs(way) * 6 / 7
        assert (found.subject == "rail", found.passed) == (True, row is None)
        assert found.value == pytest.approx(beyond, abs=1e-9)


# --- a rail that is held -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", ["marked", "bare", "printed"])
def test_from_when_a_rail_stands_for_long_enough(kind: str) -> None:
    """The first row of the rest from which the rail moves no more than a micron for the time; else that from which it
    moves least; the time given where the rest is too short."""
    rng = np.random.default_rng(51)
    marked, r = kind == "marked", 4e-6 if kind == "printed" else 1e-12
    found_still = found_least = short = 0
    for _ in range(60):
        n = 40
        t = np.arange(n) * 0.008
        d = np.cumsum(rng.choice([0.0, 0.0, 0.0, 3.1e-7, -4.3e-7, 8e-6], n))
        q = np.tile(PLANT.start, (n, 1))
        q[:, 0] += d
        file = Trajectory(PLANT.limits.names, t, q, None)
        rows = replace(judged_rows(PLANT, file, Resolution(0.0, np.full(7, r), np.zeros(7))), marked=marked)
        time, duration, depart = 0.0401, float(rng.choice([0.02, 0.05, 0.1, 0.9])), 35
        tau = 0.0 if marked else 0.004
        slack = 1e-9 + 4 * tau
        first = next(i for i in range(n) if t[i] >= time - slack - 1e-13)
        paths = {}
        for i in range(first, depart + 1):
            if t[i] + duration <= t[depart] + slack + 1e-13:
                inside = [k for k in range(i, depart + 1) if t[k] <= t[i] + duration - 2 * tau + 1.1e-9] or [i]
                part = d[inside[0] : inside[-1] + 1]
                paths[i] = part.max() - part.min() - r
        found = still_from(rows, time, duration, depart)
        still = [i for i, way in paths.items() if way <= tol.HELD]
        if still or not paths:
            assert found == pytest.approx(t[still[0]] if still else time, abs=1e-12)
        else:
            assert paths[round(found / 0.008)] == pytest.approx(min(paths.values()), abs=1e-12)
        found_still, found_least, short = found_still + bool(still), found_least + (not still), short + (not paths)
    assert min(found_still, found_least, short) > 5


@pytest.mark.parametrize("over", [0.99, 1.01])
@pytest.mark.parametrize("kind", ["marked", "bare", "printed"])
def test_a_held_rail_stands_to_a_hair(kind: str, over: float) -> None:
    """In a wait, on a move, and on one that stays and has a time of its own: a micron and a printed step, from its
    least to its greatest position; rows that may lie beside it do not count."""
    marked, r = kind == "marked", 1e-6 if kind == "printed" else 1e-12
    steps = Resolution(0.0, np.full(7, r), np.full(7, r))
    way = over * (tol.HELD + r)
    ride = Ride(((0.0, 4), (0.5, 16), (0.2, 5)))
    arrive = ride.first[1]

    def swayed(row: int, other: int | None = None) -> Trajectory:
        rows = ride.rows()
        q = rows.q.copy()
        q[row, 0] += way / 2 if other is not None else way
        if other is not None:
            q[other, 0] -= way / 2
        return replace(rows, q=q)

    asked = [move_j(11, "p_11", at(0.5)), wait(12, 10 * H, hold=Hold.PROGRAM), home(13, 0.2)]
    if kind != "marked":  # the tool may not be so far off where there are rows at stops
        for row, other in ((arrive + 5, None), (arrive + 7, arrive + 3)):
            found = one_of(told("held", asked, swayed(row, other), marked, steps), "way while held", 12)
            # somewhere else in the rest the rail may stand for long enough
            assert found.value <= way
        long = [asked[0], wait(12, 15 * H, hold=Hold.PROGRAM), asked[2]]
        found = one_of(told("held", long, swayed(arrive + 7), marked, steps), "way while held", 12)
        assert found.passed == (over < 1)
        assert (found.value, found.limit, found.unit) == (pytest.approx(way - r, rel=1e-6), tol.HELD, "m")
        assert found.time == pytest.approx(ride.t[arrive + 7])
        stays = [asked[0], replace(move_l(12, "p_12", at(0.5)), duration=15 * H, hold=Hold.CELL), asked[2]]
        found = one_of(told("held", stays, swayed(arrive + 7), marked, steps), "way while held", 12)
        assert (found.value, found.passed) == (pytest.approx(way - r, rel=1e-6), over < 1)
    # on a move of the rail itself all of its way but that of the rows beside its rests counts
    held = [replace(asked[0], hold=Hold.GRIPPER), asked[2]]
    found = one_of(told("held", held, ride.rows(), marked, steps), "way while held", 11)
    whole = 0.5 if marked else 0.5 * 5 / 7
    assert (found.value, found.passed) == (pytest.approx(whole - r, abs=1e-9), False)
    assert "waits: {rail: free}" in found.message
