"""Positioners: what the tool does over a work object that they turn, by pin's rigid motions, and what a table may do,
by the formulas of evenly accelerated turns."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pinocchio as pin
import pytest
from legal_motion import (
    FINE,
    V2500,
    Case,
    Piece,
    arm_at,
    eax,
    hold,
    home,
    joint_move,
    move_j,
    move_l,
    plant_with_rail,
    program,
    trapezoid,
    wait,
)
from scipy.interpolate import CubicHermiteSpline
from scipy.spatial.transform import Rotation
from table_cell import AT, CELL, ON_TABLE, P_1, PLANT, WRITTEN, Cell, asked, brought, unit

from trajopt_cli.errors import InputError
from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.judge import tolerances as tol
from trajopt_cli.judge.positioners import TurnedFrame, check_columns
from trajopt_cli.judge.samples import judged_rows
from trajopt_cli.judge.tool_kinematics import ToolKinematics
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import MoveExtJ
from trajopt_cli.trajectory import Trajectory

X_FT = pose(rotation_about([0, 1, 0], 0.3), [0.02, 0.0, 0.1])


UNITS = (unit(2, 0.3, 0.8, [0.5, 0.1, 0.2], [1, 0, 0.2]), unit(1, -0.2, 0.4, [0.5, 0.2, 0.3], [0.1, 0.2, 1]))
ANGLE_STEP, SPEED_STEP = 3e-4, 5e-4


def random_rows(marked: bool = True, n: int = 40) -> tuple[Trajectory, Resolution]:
    """A robot and three axes of positioners that move at random; eax_d turns nothing."""
    rng = np.random.default_rng(12)
    t = np.sort(np.r_[np.arange(n - 1) * 8e-3, 0.1007]) if marked else np.arange(n) * 8e-3
    plant = plant_with_rail()
    q, qd = plant.start + rng.uniform(-0.3, 0.3, (n, 7)), rng.uniform(-1, 1, (n, 7))
    tables = Trajectory(("eax_b", "eax_d", "eax_c"), t, rng.uniform(-1, 1, (n, 3)), rng.uniform(-1, 1, (n, 3)))
    coarse = Resolution(0.0, np.array([1e-5, 2e-5, ANGLE_STEP]), np.array([1e-5, SPEED_STEP, 1e-5]))
    steps = Resolution(0.0, rng.uniform(1e-6, 1e-4, (n, 7)), rng.uniform(1e-6, 1e-4, (n, 7)), coarse)
    return Trajectory(plant.limits.names, t, q, qd, tables), steps


def turned_rows(marked: bool = True) -> tuple[TurnedFrame, ToolKinematics, Array, Array]:
    """The tool in the world and over the work; angles of the units (n, 2) since the move's start, and their speeds."""
    trajectory, steps = random_rows(marked)
    rows = judged_rows(plant_with_rail(), trajectory, steps)
    assert rows.exact == marked
    world = ToolKinematics(rows, X_FT)
    assert trajectory.tables is not None
    assert trajectory.tables.qd is not None
    theta, rates = trajectory.tables.q[:, [2, 0]] - [0.3, -0.2], trajectory.tables.qd[:, [2, 0]]
    return TurnedFrame.over(world, UNITS), world, theta, rates


def tool_at(q: Array) -> pin.SE3:
    X = plant_with_rail().robot.forward(q[None])[0] @ X_FT
    return pin.SE3(X)


def test_the_tool_is_seen_from_the_work_object() -> None:
    """Places and speeds at the rows; what rounding does to angles counts at the levers of all axes."""
    frame, world, theta, rates = turned_rows()
    rows, eps = frame.rows, 1e-6
    levers = sum(np.linalg.norm(world.p - np.array(one.p), axis=1) for one in UNITS)
    np.testing.assert_allclose(frame.doubt_p, world.doubt_p + levers * ANGLE_STEP / 2, rtol=1e-12)
    np.testing.assert_allclose(frame.doubt_R, world.doubt_R + 2 * ANGLE_STEP / 2, rtol=1e-12)
    np.testing.assert_allclose(frame.doubt_V[0][:], world.doubt_V[0][:] + levers * SPEED_STEP / 2, rtol=1e-12)
    np.testing.assert_allclose(frame.doubt_V[1][:], world.doubt_V[1][:] + 2 * SPEED_STEP / 2, rtol=1e-12)
    for i in range(len(rows.t)):
        seen = brought(UNITS, theta[i]).inverse() * tool_at(rows.q[i])
        np.testing.assert_allclose(frame.p[i], seen.translation, atol=1e-9)
        np.testing.assert_allclose(frame.R[i], seen.rotation, atol=1e-9)
        late, early = (
            brought(UNITS, theta[i] + x * rates[i]).inverse() * tool_at(rows.q[i] + x * rows.qd[i]) for x in (eps, -eps)
        )
        v = (late.translation - early.translation) / (2 * eps)
        w = seen.rotation @ pin.log3(early.rotation.T @ late.rotation) / (2 * eps)
        # in axes of the work object as it stood at the start
        np.testing.assert_allclose(frame.V[i], np.r_[v, w], atol=1e-7)
        for found, speed, doubt in ((frame.least_speed, v, 0), (frame.least_turning, w, 1)):
            least = max(np.linalg.norm(speed) - frame.doubt_V[doubt][i], 0.0)
            assert found[i] == pytest.approx(least, abs=1e-7)
    assert not frame.exact


@pytest.mark.parametrize("marked", [True, False])
def test_the_tool_is_seen_between_rows(marked: bool) -> None:
    frame, world, _, _ = turned_rows(marked)
    rows, tables = frame.rows, frame.rows.trajectory.tables
    assert tables is not None
    first, last = 5, len(rows.t) - 1
    found, of_world = frame.places(first, last), world.places(first, last)
    assert len(found.t) == (last - first) * (5 if marked else 1) + 1
    robot, table = (CubicHermiteSpline(rows.t, one.q, one.qd) for one in (rows, tables))
    for i, time in enumerate(found.t):
        theta = table(time)[[2, 0]] - [0.3, -0.2]
        seen = brought(UNITS, theta).inverse() * tool_at(robot(time))
        np.testing.assert_allclose(found.p[i], seen.translation, atol=1e-9)
        np.testing.assert_allclose(found.R[i], seen.rotation, atol=1e-9)
        levers = sum(np.linalg.norm(of_world.p[i] - np.array(one.p)) for one in UNITS)
        assert found.doubt_p[i] == pytest.approx(of_world.doubt_p[i] + levers * ANGLE_STEP / 2)
        assert found.doubt_angle[i] == pytest.approx(of_world.doubt_angle[i] + ANGLE_STEP)
    one_row = frame.places(7, 7)
    np.testing.assert_array_equal(one_row.p, frame.p[7:8])


def test_units_are_held_to_their_share_of_the_way() -> None:
    """Less what is not known of the share, and half a printed step."""
    frame, _, theta, _ = turned_rows()
    here, share, doubt = np.array([3, 8, 21]), np.array([0.1, 0.5, 0.9]), np.array([0.0, 0.01, 0.5])
    found = frame.off(here, share, doubt)
    angles = np.array([0.5, 0.6])
    for i, row in enumerate(here):
        for j in range(2):
            off = abs(theta[row, j] - share[i] * angles[j]) - doubt[i] * angles[j] - ANGLE_STEP / 2
            assert found[i, j] == pytest.approx(max(off, 0.0), abs=1e-12)
    assert (found > 0).sum() > 3


# --- a program ---------------------------------------------------------------------------------------------------

ROWS = CELL.rows(step=0.004)


def failed(found: Sequence[Finding]) -> list[tuple[str, str]]:
    return [(one.check, one.subject) for one in found if not one.passed]


@pytest.mark.parametrize("speeds", [True, False])
@pytest.mark.parametrize("rows", [{}, {"grid_only": True, "step": 0.004}], ids=["own", "250Hz"])
def test_a_line_over_a_table_that_turns_is_legal(rows: dict[str, object], speeds: bool) -> None:
    found = CELL.judged(CELL.rows(speeds, **rows))
    assert failed(found) == [], [one.message for one in found if not one.passed]
    made = {(one.check, one.subject) for one in found}
    assert made >= {
        ("positioner position", "eax_b"), ("positioner speed", "eax_c"), ("positioner acceleration", "eax_b"),
        ("line position", "TCP"), ("positioner", "MoveJ p_1"),
    }  # fmt: skip


def test_a_table_has_the_speed_and_the_acceleration_of_its_hardest_turn() -> None:
    """eax_b: 0.4 rad in a triangle of the joint move's time; eax_c: 0.15 rad, 2 and 8 of it on the line, in 0.6 s
    after it 0.5 and 1.67. Limits a hair less than a millionth below are kept."""
    T = CELL.pieces[0].T
    values = {
        "eax_b": (max(2 * 0.4 / T, 2 * 0.3), max(4 * 0.4 / T**2, 8 * 0.3)),
        "eax_c": (max(2 * 0.15, 2 * 0.15 / 0.6), max(8 * 0.15, 4 * 0.15 / 0.36)),
    }
    for k, field in enumerate(("velocity", "acceleration")):
        check = "positioner speed" if k == 0 else "positioner acceleration"
        for column, value in ((name, one[k]) for name, one in values.items()):
            for over in (0.9, 1.1):
                limit = value / (1 + over * tol.JOINT)
                found = [one for one in CELL.judged(ROWS, asked(**{field: limit})) if one.check == check]
                (mine,) = (one for one in found if one.subject == column)
                assert (mine.value, mine.limit) == (pytest.approx(value, rel=1e-8), limit)
                assert mine.passed == (over < 1), (column, field, over, mine)
                assert mine.unit == ("rad/s" if k == 0 else "rad/s2")


def test_the_hardest_speed_and_acceleration_have_their_time() -> None:
    T = CELL.pieces[0].T
    found = {(one.check, one.subject): one for one in CELL.judged(ROWS)}
    fast = found["positioner speed", "eax_b"]
    assert fast.time == pytest.approx(T / 2, abs=4e-3)
    assert str(fast.source) == "cell.mod:11:5"
    on_line = found["positioner speed", "eax_c"]
    assert on_line.time == pytest.approx(CELL.case.starts[2] + 0.3, abs=4e-3)
    assert on_line.value == pytest.approx(0.5, rel=1e-6)


def positions(found: Sequence[Finding], name: str) -> Finding:
    (one,) = (one for one in found if (one.check, one.subject) == ("positioner position", name))
    return one


def shifted(rows: Trajectory, column: int, by: Array | float) -> Trajectory:
    assert rows.tables is not None
    q = rows.tables.q.copy()
    q[:, column] += by
    return replace(rows, tables=replace(rows.tables, q=q))


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("over", [0.9, 1.1])
def test_a_table_stands_and_ends_where_it_should(over: float, sign: int) -> None:
    """Off by a micron of an angle where it must stand, before, behind or after its turns: one finding that says so."""
    off, starts, t = sign * over * tol.JOINT_TARGET, CELL.case.starts, ROWS.t
    found = positions(CELL.judged(shifted(ROWS, 1, np.where(t < 0.1, off, 0.0))), "eax_c")
    assert found.passed == (over < 1)
    if over > 1:  # eax_c stands at 0.1 rad in the joint move
        assert (found.value, found.limit, found.unit) == (pytest.approx(0.1 + off, abs=1e-12), 0.1, "rad")
        assert found.time == 0.0
        assert "wanted 0.1" in found.message
    at_end = np.clip((t - starts[1]) / 0.75, 0, 1) * (t < starts[2] + 0.2)
    found = positions(CELL.judged(shifted(ROWS, 1, off * at_end)), "eax_c")
    assert found.passed == (over < 1)
    if over > 1:
        assert (found.value, found.limit) == (pytest.approx(0.25 + off, abs=1e-12), 0.25)
        assert found.time == pytest.approx(starts[2])
        assert "at MoveL p_2" in found.message
    last = positions(CELL.judged(shifted(ROWS, 0, np.where(t > starts[3] + 0.1, off, 0.0))), "eax_b")
    assert last.passed == (over < 1)
    if over > 1:
        assert (last.value, last.limit) == (pytest.approx(0.4 + off, abs=1e-12), 0.4)
        assert last.time > starts[3]


def test_printed_digits_and_missing_rows_are_granted_to_a_table() -> None:
    """Half a step; and what it goes at its acceleration before the robot is seen to have moved."""
    start = CELL.program.motions[0].units[0]
    rows = CELL.rows(grid_only=True, step=0.004)
    r, step, k = 1e-5, 2e-4, 6
    steps = Resolution(0.0, np.full(k, r), np.full(k, 1e-9), Resolution(0.0, np.full(2, step), np.full(2, 1e-4)))
    hidden = np.sqrt(2 * k * r / PLANT.limits.acceleration.min())
    tau = 2e-3
    granted = step / 2 + start.acceleration * (2 * tau + hidden) ** 2 / 2
    for over in (0.99, 1.01):
        off = np.where(rows.t < 0.05, over * (granted + tol.JOINT_TARGET), 0.0)
        found = positions(CELL.judged(shifted(rows, 1, off), steps=steps), "eax_c")
        assert found.passed == (over < 1), found.message


@pytest.mark.parametrize("speeds", [True, False])
def test_printed_digits_are_granted_to_the_speed_of_a_table(speeds: bool) -> None:
    """A mean over an interval may be off by a step, a difference of two means by two; speeds by their own step."""
    step, step_v = 1e-5, 3e-4
    rows = CELL.rows(speeds, grid_only=True, step=0.004)
    T = CELL.pieces[0].T
    steps = Resolution(
        0.0, np.full(6, 1e-9), np.full(6, 1e-9 * speeds), Resolution(0.0, np.full(2, step), np.full(2, step_v))
    )
    found = {(f.check, f.subject): f for f in CELL.judged(rows, steps=steps)}
    fastest, pull = 2 * 0.4 / T, 4 * 0.4 / T**2
    table = rows.tables
    assert table is not None
    q, gaps = table.q[:, 0], np.diff(rows.t)
    way = np.abs(np.diff(q)) - step
    if speeds:
        v = table.qd[:, 0]
        fastest = max((way / gaps).max(), np.abs(v).max() - step_v)
        change = (np.abs(np.diff(v)) - step_v) / gaps
        bend = (np.abs(np.diff(q) / gaps - (v[1:] + v[:-1]) / 2) - step / gaps - step_v) / (gaps / 4)
        pull = np.maximum(change, bend).max()
    else:
        mean = np.diff(q) / gaps
        fastest = (way / gaps).max()
        doubt = step / gaps
        pull = ((np.abs(np.diff(mean)) - doubt[1:] - doubt[:-1]) / ((gaps[1:] + gaps[:-1]) / 2)).max()
    assert found["positioner speed", "eax_b"].value == pytest.approx(fastest, rel=1e-6)
    assert found["positioner acceleration", "eax_b"].value == pytest.approx(pull, rel=1e-3)


def test_speeds_of_a_table_belong_to_its_positions() -> None:
    """A mean speed that is off the mean of its rows' by e took an acceleration of 4 e / h."""
    rows, i = ROWS, int(np.searchsorted(ROWS.t, 0.05))
    h = rows.t[i + 1] - rows.t[i]
    for over in (0.9, 1.1):
        e = over * 10.0 * h / 4
        rates = rows.tables.qd.copy()
        rates[i : i + 2, 1] += e
        found = CELL.judged(replace(rows, tables=replace(rows.tables, qd=rates)))
        # eax_c stands there: only where it turns are speeds looked at
        assert ("positioner acceleration", "eax_c") not in failed(found)
        rates = rows.tables.qd.copy()
        rates[i : i + 2, 0] += e
        (mine,) = (f for f in CELL.judged(replace(rows, tables=replace(rows.tables, qd=rates)))
                   if (f.check, f.subject) == ("positioner acceleration", "eax_b"))  # fmt: skip
        limit = 4 * 0.4 / CELL.pieces[0].T ** 2
        assert mine.value == pytest.approx(max(e / (h / 4), e / h + limit, e / h - limit), rel=1e-3)


@pytest.mark.parametrize("off", [0.0, 2e-6, 4e-6, 2e-5])
def test_tables_turn_in_step_with_the_line(off: float) -> None:
    """The second axis is ahead of its share by a hair in the middle of the line: how far it is from the share that the
    tool shows over the work, less what a micron of that is."""
    starts, t, T = CELL.case.starts, ROWS.t, 0.75
    u = np.clip((t - starts[1]) / T, 0, 1)
    rows = shifted(ROWS, 1, off * np.sin(np.pi * u) ** 2)
    chord = ON_TABLE[:3, 3] - P_1[:3, 3]
    way, wanted = float(np.linalg.norm(chord)), []
    for i in np.flatnonzero((t > starts[1] - 1e-9) & (t < starts[2] + 1e-9)):
        theta = rows.tables.q[i, [1, 0]] - [0.1, 0.4]
        seen = (brought(CELL.units, theta).inverse() * pin.SE3(PLANT.robot.forward(rows.q[i : i + 1])[0])).translation
        share = (seen - P_1[:3, 3]) @ chord / way**2
        away = [
            abs(theta[j] - share * angle) - tol.LINE_POSITION / way * abs(angle) for j, angle in enumerate((0.15, -0.3))
        ]
        wanted.append((max(max(away), 0.0), ("eax_c", "eax_b")[int(np.argmax(away))], t[i]))
    value, column, when = max(wanted)
    (found,) = (one for one in CELL.judged(rows) if one.check == "positioner along line")
    assert (found.value, found.limit, found.unit) == (pytest.approx(value, abs=1e-9), tol.JOINT_TARGET, "rad")
    assert found.passed == (value <= tol.JOINT_TARGET)
    if off > 1e-5:
        assert (found.subject, found.time) == (column, pytest.approx(when))
        assert not found.passed


def test_a_line_that_only_the_table_draws_is_found_in_the_rest_it_is_in() -> None:
    """The tool rests where it is, and the work goes by under it: from when the table leaves until it stands."""
    arc = unit(1, 0.0, 0.4, [0.48, 0.05, 0.1], [0, 0, 1], least=0.5)  # about the tool itself
    q = arm_at(PLANT, P_1[None], None)[0]
    T, share, _ = trapezoid(1e9, 4 / 0.5**2)
    asked = program(move_j(11, "p_1", P_1), move_l(12, "p_2", P_1, units=(arc,)), home(15, None))
    pieces = (joint_move(PLANT, PLANT.start, q, 0.5), hold(q, 0.9), joint_move(PLANT, q, PLANT.start, 0.5))
    case = Case(PLANT, asked, pieces)
    rows, begin = case.rows(step=0.004), case.starts[1] + 0.2
    t = np.unique(np.r_[rows.t, begin + np.array([0.0, T / 2, T])])
    rows = Trajectory(rows.names, t, *(np.array([np.interp(t, rows.t, x) for x in y.T]).T for y in (rows.q, rows.qd)))
    s, rate = share(np.clip(t - begin, 0, T))
    for bump, place in ((0.0, 0.1), (1e-5, 0.1), (1e-5, 0.8)):  # of the table, before its turn or behind it
        off = bump * (np.abs(t - case.starts[1] - place) < 0.03)
        tables = Trajectory(("eax_b",), t, (0.4 * s + off)[:, None], 0.4 * rate[:, None])
        found = verify(asked, PLANT, replace(rows, tables=tables), advice=False).findings
        own = {one.check: one for one in found if one.source and one.source.line == 12}
        assert own["positioner speed"].value == pytest.approx(2 * 0.4 / T, rel=1e-9)
        off_there = [("positioner position", "eax_b")] if bump else []
        if bump and place < 0.5:  # the work is not where the tool draws on it
            assert failed(found) == [("line progress", "TCP"), *off_there]
            assert own["line progress"].value == pytest.approx(bump, rel=1e-5)
            assert own["line progress"].time == pytest.approx(begin - 0.07, abs=4e-3)
            continue
        assert failed(found) == off_there
        assert own["line rotation"].time == pytest.approx(begin)
        assert max(own[f"line {x}"].value for x in ("position", "rotation", "progress")) < 1e-9


@pytest.mark.parametrize("step", [None, 0.001, 0.004])
@pytest.mark.parametrize(("waits", "short"), [(0.0, 0.0), (0.3, 0.0), (0.3, 0.03)])
def test_a_stop_is_where_the_table_leaves_and_comes_though_the_tool_hardly_moves(
    step: float | None, waits: float, short: float
) -> None:
    """A table that turns about the tool, which draws 0.2 mm on it: for 25 ms it is less than 1 um from both stops. The
    wait at the second one begins when the table stands there."""
    arc, T = unit(1, 0.0, 0.4, [0.48, 0.05, 0.1], [0, 0, 1], least=0.5), 0.5
    share = trapezoid(1e9, 4 / T**2)[1]
    back = Rotation.from_rotvec([0.0, 0.0, -0.4])  # of the tool, seen from the table

    def poses(s: Array) -> Array:
        turns = [brought([arc], [0.4 * x]).homogeneous for x in s]
        seen = [Rotation.from_rotvec(x * back.as_rotvec()).as_matrix() @ P_1[:3, :3] for x in s]
        return np.array([X @ pose(R, P_1[:3, 3] + [2e-4 * x, 0, 0]) for X, R, x in zip(turns, seen, s, strict=True)])

    def at(t: Array) -> tuple[Array, Array]:
        s, rate = share(t)
        q = arm_at(PLANT, poses(s), None)
        ahead, behind = (arm_at(PLANT, poses(np.clip(s + x, 0, 1)), None) for x in (1e-5, -1e-5))
        width = np.clip(s + 1e-5, 0, 1) - np.clip(s - 1e-5, 0, 1)
        return q, (ahead - behind) / width[:, None] * rate[:, None]

    q_0, q_1 = arm_at(PLANT, poses(np.array([0.0, 1.0])), None)
    line = move_l(12, "p_2", poses(np.array([1.0]))[0], units=(arc,))
    asked = program(move_j(11, "p_1", P_1), line, *[wait(13, waits)] * (waits > 0), home(15, None))
    pieces = (
        joint_move(PLANT, PLANT.start, q_0, 0.5),
        Piece(T, at, (T / 2,)),
        *[hold(q_1, waits - short)] * (waits > 0),
        joint_move(PLANT, q_1, PLANT.start, 0.5),
    )
    case = Case(PLANT, asked, pieces)
    rows = case.rows() if step is None else case.rows(grid_only=True, step=step)
    s, rate = share(np.clip(rows.t - case.starts[1], 0, T))
    tables = Trajectory(("eax_b",), rows.t, 0.4 * s[:, None], 0.4 * rate[:, None])
    found = verify(asked, PLANT, replace(rows, tables=tables), advice=False).findings
    assert bool(failed(found)) == (("dwell length", "TCP") in failed(found)) == (short > 0)


def test_columns_are_those_that_the_program_turns() -> None:
    check_columns(CELL.program, ROWS)
    tables = ROWS.tables
    with pytest.raises(InputError, match=r"^the file has a column eax_d, by which no positioner of the program turns"):
        check_columns(CELL.program, replace(ROWS, tables=replace(tables, names=("eax_b", "eax_d"))))
    one = Trajectory(("eax_b",), ROWS.t, tables.q[:, :1], tables.qd[:, :1])
    told = (
        r"^the file has no column eax_c \[rad\], by which stn turns the work object under MoveL p_2 \(cell\.mod:12:5\)"
    )
    for rows in (replace(ROWS, tables=one), replace(ROWS, tables=None)):
        with pytest.raises(InputError, match=told if rows.tables else "no column eax_c"):
            check_columns(CELL.program, rows)
        check_columns(CELL.program, rows, dropped={1})
    check_columns(Cell(carries=False).program, replace(ROWS, tables=one))


def test_without_its_columns_nothing_is_said_of_a_table() -> None:
    plain = replace(CELL.program, motions=tuple(replace(CELL.program.motions[k], units=()) for k in (0, 3)))
    pieces = CELL.pieces[0], joint_move(PLANT, CELL.pieces[0].at(np.array([CELL.pieces[0].T]))[0][0], PLANT.start, 0.5)
    found = verify(plain, PLANT, Case(PLANT, plain, pieces).rows(step=0.004), advice=False).findings
    assert failed(found) == []
    assert not any(one.check.startswith("positioner") for one in found)


@pytest.mark.parametrize(("bump", "legal"), [(0.004, True), (0.03, False), (-0.03, False)])
def test_a_table_neither_goes_back_nor_beyond_on_its_way(bump: float, legal: bool) -> None:
    """Both turn back in the rest of 0.6 s, eax_c by -0.15 rad in a triangle of speed; three waves lie over that."""
    rows = CELL.rows()
    u = (rows.t - CELL.case.starts[2]) / 0.6
    waves, inside = 6 * np.pi, (u >= 0) & (u <= 1)
    more = np.where(inside, bump * np.sin(waves * u) * np.sin(np.pi * u) ** 2, 0.0)
    rate = (
        bump
        / 0.6
        * (waves * np.cos(waves * u) * np.sin(np.pi * u) ** 2 + np.sin(waves * u) * np.pi * np.sin(2 * np.pi * u))
    )
    assert rows.tables is not None
    assert rows.tables.qd is not None
    q, qd = rows.tables.q.copy(), rows.tables.qd.copy()
    q[:, 1] += more
    qd[:, 1] += np.where(inside, rate, 0.0)
    found = CELL.judged(
        replace(rows, tables=replace(rows.tables, q=q, qd=qd)), asked(velocity=30.0, acceleration=300.0)
    )
    failed = [one for one in found if not one.passed]
    assert bool(np.diff(q[inside, 1]).max() > 1e-4) != legal
    assert [(one.check, one.subject) for one in failed] == ([] if legal else [("positioner position", "eax_c")])
    for one in failed:
        lowest = np.minimum.accumulate(q[inside, 1])
        assert abs(one.value - one.limit) == pytest.approx((q[inside, 1] - lowest).max(), abs=1e-9)


def test_a_table_stands_behind_its_last_position() -> None:
    """It swings once more in the same rest, by 0.02 rad and back, behind its way of 0.3 s."""
    rows, start = CELL.rows(), CELL.case.starts[2]
    u = (rows.t - start) / 0.6
    assert rows.tables is not None
    assert rows.tables.qd is not None
    q, qd = rows.tables.q.copy(), rows.tables.qd.copy()
    share = trapezoid(1e9, 4 / 0.3**2)[1](np.clip(0.6 * u, 0, 0.3))
    inside = (u >= 0) & (u <= 1)
    q[inside, 1], qd[inside, 1] = (0.25 - 0.15 * share[0])[inside], (-0.15 * share[1] * (u < 0.5))[inside]
    wanted = asked(velocity=30.0, acceleration=300.0)
    still = replace(rows, tables=replace(rows.tables, q=q, qd=qd))
    assert [one.message for one in CELL.judged(still, wanted) if not one.passed] == []
    later = inside & (u > 0.55)
    w = np.clip((u - 0.55) / 0.4, 0, 1)
    q[later, 1] += 0.02 * np.sin(np.pi * w[later]) ** 2
    qd[later, 1] += 0.02 * np.pi / (0.4 * 0.6) * np.sin(2 * np.pi * w[later]) * (w[later] < 1)
    found = CELL.judged(replace(rows, tables=replace(rows.tables, q=q, qd=qd)), wanted)
    (failed,) = [one for one in found if not one.passed]
    assert (failed.check, failed.subject, failed.limit) == ("positioner position", "eax_c", pytest.approx(0.1))
    assert failed.value == pytest.approx(0.12, abs=2e-4)


@pytest.mark.parametrize("turns", [True, False])
def test_a_table_goes_there_and_back_in_one_rest(turns: bool) -> None:
    """Three moves to one pose: what turns between them, turns as it should, or not at all."""
    q, limits = arm_at(PLANT, P_1[None], None)[0], {"carries": False, "least": 0.3}
    units = [unit(1, *ends, [0.6, 0.3, 0.1], [0, 0, 1], **limits) for ends in ((0.0, 0.4), (0.4, 0.0))]
    asked = program(
        move_j(11, "p_1", P_1),
        *(move_l(12 + k, "p_1", P_1, units=(one,)) for k, one in enumerate(units)),
        home(19, None),
    )
    pieces = (joint_move(PLANT, PLANT.start, q, 0.5), hold(q, 1.2), joint_move(PLANT, q, PLANT.start, 0.5))
    case = Case(PLANT, asked, pieces)
    share = trapezoid(1e9, 4 / 0.45**2)[1]
    for step in (0.001, 0.0037):
        rows = case.rows(grid_only=True, step=step)
        there, back = (share(np.clip(rows.t - case.starts[1] - begin, 0, 0.45)) for begin in (0.1, 0.65))
        theta, rate = (0.4 * (a - b)[:, None] * turns for a, b in zip(there, back, strict=True))
        tables = Trajectory(("eax_b",), rows.t, theta, rate)
        found = verify(asked, PLANT, replace(rows, tables=tables), advice=False).findings
        assert failed(found) == ([] if turns else [("positioner position", "eax_b")])


@pytest.mark.parametrize("by", ["itself", "a move that stays"])
@pytest.mark.parametrize("shift", [0.0, -0.2, 0.2])
def test_a_table_turns_between_the_waits_that_it_turns_between(by: str, shift: float) -> None:
    """A wait of a second, a turn of 0.45 s, a wait of half a second: in another order they take as long."""
    q = arm_at(PLANT, P_1[None], None)[0]
    one = unit(1, 0.0, 0.4, [0.6, 0.3, 0.1], [0, 0, 1], carries=False, least=0.45, acceleration=20.0)
    turn = move_l(14, "p_1", P_1, units=(one,))
    if by == "itself":
        turn = MoveExtJ(source=AT, written=WRITTEN, target="j", speed=V2500, zone=FINE, extax=eax(None), units=(one,))
    asked = program(move_j(11, "p_1", P_1), wait(12, 1.0), turn, wait(15, 0.5), home(19, None))
    pieces = (joint_move(PLANT, PLANT.start, q, 0.5), hold(q, 1.95), joint_move(PLANT, q, PLANT.start, 0.5))
    case, share = Case(PLANT, asked, pieces), trapezoid(1e9, 4 / 0.45**2)[1]
    for step in (0.001, 0.0037):
        rows = case.rows(grid_only=True, step=step)
        s, rate = share(np.clip(rows.t - case.starts[1] - 1.0 - shift, 0, 0.45))
        tables = Trajectory(("eax_b",), rows.t, 0.4 * s[:, None], 0.4 * rate[:, None])
        found = verify(asked, PLANT, replace(rows, tables=tables), advice=False).findings
        assert failed(found) == ([("positioner position", "eax_b")] if shift else [])
        for finding in found if shift else ():
            if not finding.passed:
                assert finding.limit == pytest.approx(0.0 if shift < 0 else 0.4)
