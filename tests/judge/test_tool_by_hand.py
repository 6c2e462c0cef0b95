"""What the judge makes of the tool in a file: places, speeds, accelerations and the doubt about them, against another
kinematics and formulas written out; and that caps and programmed speeds hold to a hair, at the right place."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from legal_motion import plant_with_rail
from scipy.interpolate import CubicHermiteSpline
from scipy.spatial.transform import Rotation
from tcp_motion import forward_acceleration

from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.judge import caps
from trajopt_cli.judge import tolerances as tol
from trajopt_cli.judge.samples import judged_rows
from trajopt_cli.judge.tool_kinematics import ToolKinematics, angular_acceleration
from trajopt_cli.trajectory import Trajectory

PLANT = plant_with_rail()
LAGS = (1, 2, 4, 8, 16, 32)
N = 70
INNER = np.array([0.2, 0.4, 0.6, 0.8])
TOOLS = {"tool0": np.eye(4), "grip": pose(rotation_about([0, 1, 0], 0.3), [0.02, 0.03, 0.1])}
Series = Iterable[tuple[Array, Array]]


@cache
def frame_of(tool: str, speeds: bool, marked: bool) -> ToolKinematics:
    """Rows of a smooth motion of all axes, off by a little, printed in steps that differ from row to row."""
    rng = np.random.default_rng(31)
    t = np.cumsum(np.r_[0.25, rng.uniform(0.004, 0.012, N - 1)])
    if marked:
        t = np.sort(np.r_[np.arange(N - 1) * 0.008, 0.1031])
    phase, rate = rng.uniform(0, 6, 7), rng.uniform(2, 5, 7)
    q = PLANT.start + 0.2 * np.sin(rate * t[:, None] + phase) + 1e-5 * rng.normal(size=(N, 7))
    qd = 0.2 * rate * np.cos(rate * t[:, None] + phase) + 1e-3 * rng.normal(size=(N, 7))
    steps = Resolution(
        rng.uniform(1e-6, 2e-5, N), rng.uniform(1e-6, 2e-5, (N, 7)), rng.uniform(1e-6, 1e-4, (N, 7)) * speeds
    )
    rows = judged_rows(PLANT, Trajectory(PLANT.limits.names, t, q, qd if speeds else None), steps)
    assert (rows.marked, rows.exact) == (marked, marked and speeds)
    return ToolKinematics(rows, TOOLS[tool])


def columns(frame: ToolKinematics) -> tuple[Array, Array]:
    """Lengths (n, 7) of the Jacobian's columns."""
    J = PLANT.robot.jacobian(frame.rows.q, frame.X_FT)
    return np.linalg.norm(J[:, :3], axis=1), np.linalg.norm(J[:, 3:], axis=1)


def angle(A: Array, B: Array) -> float:
    return float(np.linalg.norm(Rotation.from_matrix(A.T @ B).as_rotvec()))


def pairs(rows: int, reach: int = 1) -> list[tuple[int, range]]:
    return [(m, range(rows - reach * m)) for m in LAGS if reach * m < rows]


def same(found: Series, wanted: Series, rtol: float = 1e-7) -> None:
    found, wanted = list(found), list(wanted)
    assert len(found) == len(wanted)
    for (t, x), (t_wanted, x_wanted) in zip(found, wanted, strict=True):
        np.testing.assert_allclose(t, t_wanted, rtol=1e-13)
        np.testing.assert_allclose(x, x_wanted, rtol=rtol, atol=1e-8)


@pytest.mark.parametrize("tool", TOOLS)
def test_the_tool_at_rows(tool: str) -> None:
    """Half a printed step of every axis counts by its column; of a speed, besides, a Jacobian that is turned by half
    the steps of all axes at the speed that they make together."""
    frame = frame_of(tool, True, False)
    rows, X = frame.rows, PLANT.robot.forward(frame.rows.q) @ frame.X_FT
    linear, angular = columns(frame)
    np.testing.assert_allclose(frame.p, X[:, :3, 3], atol=1e-9)
    np.testing.assert_allclose(frame.R[:], X[:, :3, :3], atol=1e-9)
    np.testing.assert_allclose(frame.rotations(np.array([4, 1])), X[[4, 1], :3, :3], atol=1e-9)
    V = (PLANT.robot.jacobian(rows.q, frame.X_FT) @ rows.qd[..., None])[..., 0]
    np.testing.assert_allclose(frame.V[:], V, atol=1e-8)
    total = np.abs(rows.qd).sum(axis=1)
    for lengths, part, doubt, doubt_V, least in (
        (linear, V[:, :3], frame.doubt_p, frame.doubt_V[0], frame.least_speed),
        (angular, V[:, 3:], frame.doubt_R, frame.doubt_V[1], frame.least_turning),
    ):
        off = (lengths * rows.doubt_q / 2).sum(axis=1)
        off_V = (lengths * rows.doubt_v / 2).sum(axis=1) + total * off
        np.testing.assert_allclose(doubt, off, rtol=1e-7)
        np.testing.assert_allclose(doubt_V[:], off_V, rtol=1e-7)
        np.testing.assert_allclose(least, np.maximum(np.linalg.norm(part, axis=1) - off_V, 0.0), atol=1e-8)


@pytest.mark.parametrize("tool", TOOLS)
def test_the_tool_without_speeds(tool: str) -> None:
    """The mean to the faster neighbour less a h/2, a the tool's or that of all turning axes together."""
    frame = frame_of(tool, False, False)
    rows, p, R = frame.rows, frame.p, frame.R[:]
    alpha = float(PLANT.limits.acceleration[1:].sum())
    assert angular_acceleration(rows) == pytest.approx(alpha)
    for top, least, paths in (
        (PLANT.tcp.acceleration, frame.least_speed, lambda i, k: np.linalg.norm(p[k] - p[i]) - off(i) - off(k)),
        (alpha, frame.least_turning, lambda i, k: angle(R[i], R[k]) - turned(i) - turned(k)),
    ):

        def off(i: int) -> float:
            return float(frame.doubt_p[i])

        def turned(i: int) -> float:
            return float(frame.doubt_R[i])

        mean = []
        for i in range(N - 1):
            h = rows.t[i + 1] - rows.t[i] + (rows.step_t[i] + rows.step_t[i + 1]) / 2
            mean.append(max(max(paths(i, i + 1), 0.0) / h - top * h / 2, 0.0))
        np.testing.assert_allclose(least, [max(mean[max(i - 1, 0) : i + 1]) for i in range(N)], atol=1e-7)
    long = rows.gaps + (rows.step_t[1:] + rows.step_t[:-1]) / 2
    reach = PLANT.tcp.acceleration * long**2 / 8 + np.maximum(frame.doubt_p[1:], frame.doubt_p[:-1])
    np.testing.assert_allclose(frame.reach, reach, rtol=1e-12)


@pytest.mark.parametrize("tool", TOOLS)
def test_boxes_hold_what_may_be_near(tool: str) -> None:
    """A point that far from a row, or from the chord behind it, is near its block's box and a hair more is not, where
    the box is that of one row."""
    frame = frame_of(tool, False, False)
    rows, tau = frame.rows, frame.rows.open_time
    chords = np.r_[frame.reach + np.linalg.norm(np.diff(frame.p, axis=0), axis=1), 0.0]
    blocks = [slice(0, 64), slice(64, N)]
    for b, part in enumerate(blocks):
        granted = tol.STOP_POSITION + PLANT.tcp.acceleration * tau[part].max() ** 2 / 2 + frame.doubt_p[part].max()
        for boxes, room in ((frame.stop_boxes, granted), (frame.way_boxes, chords[part].max())):
            np.testing.assert_allclose(boxes.low[b], frame.p[part].min(axis=0))
            np.testing.assert_allclose(boxes.high[b], frame.p[part].max(axis=0))
            assert boxes.room[b] == pytest.approx(room + 1e-9, rel=1e-9)
    arm = rows.arm_boxes
    granted = tol.JOINT_TARGET + rows.doubt_q / 2 + PLANT.limits.acceleration * tau[:, None] ** 2 / 2
    for b, rows_of in enumerate(blocks):
        most = (rows.doubt_q[rows_of].max(axis=0) / 2 + tol.JOINT_TARGET
                + PLANT.limits.acceleration * tau[rows_of].max() ** 2 / 2 + 1e-9)[1:]  # fmt: skip
        np.testing.assert_allclose(arm.low[b], rows.q[rows_of, 1:].min(axis=0) - most, rtol=1e-12)
        np.testing.assert_allclose(arm.high[b], rows.q[rows_of, 1:].max(axis=0) + most, rtol=1e-12)
        assert arm.room[b] == 0.0


@pytest.mark.parametrize("speeds", [True, False])
@pytest.mark.parametrize("tool", TOOLS)
def test_least_speeds_and_accelerations_of_the_tool(tool: str, speeds: bool) -> None:
    """By the chords between rows, the angles between them, the rail's way, and by second differences."""
    frame = frame_of(tool, speeds, False)
    rows, p, R, t = frame.rows, frame.p, frame.R[:], frame.rows.t
    a, b = 3, 61
    n, off_t, d, off_d = b - a + 1, rows.step_t / 2, rows.q[:, 0], rows.doubt_q[:, 0] / 2
    chords, angles, rail, bends, pulls = [], [], [], [], []
    for m, every in pairs(n):
        at = range(a, a + len(every))
        h = np.array([t[i + m] - t[i] + off_t[i] + off_t[i + m] for i in at])
        way = [np.linalg.norm(p[i + m] - p[i]) - frame.doubt_p[i] - frame.doubt_p[i + m] for i in at]
        turn = [angle(R[i], R[i + m]) - frame.doubt_R[i] - frame.doubt_R[i + m] for i in at]
        ride = [abs(d[i + m] - d[i]) - off_d[i] - off_d[i + m] for i in at]
        for out, values in ((chords, way), (angles, turn), (rail, ride)):
            out.append((t[a : b + 1 - m], np.maximum(values, 0.0) / h))
        if speeds:
            v, doubt = frame.V[:][:, :3], frame.doubt_V[0][:]
            change = [np.linalg.norm(v[i + m] - v[i]) - doubt[i] - doubt[i + m] for i in at]
            pulls.append((t[a : b + 1 - m], np.maximum(change, 0.0) / h))
    for m, every in pairs(n, 2):
        values = []
        for i in range(a, a + len(every)):
            rates, open_ = [], 0.0
            for k, c in ((i, i + m), (i + m, i + 2 * m)):
                h, unsure = t[c] - t[k], off_t[k] + off_t[c]
                rates.append((p[c] - p[k]) / h)
                open_ += (frame.doubt_p[k] + frame.doubt_p[c] + np.linalg.norm(rates[-1]) * unsure) / (h - unsure)
            H, unsure = t[i + 2 * m] - t[i], off_t[i] + off_t[i + 2 * m]
            x = 2 * np.linalg.norm(rates[1] - rates[0]) / H
            values.append(x - (2 * open_ + x * unsure) / (H - unsure))
        bends.append((t[a + m : b + 1 - m], np.array(values)))
    at_rows, turning, ride = [], [], []
    if speeds:
        at_rows = [(t[a : b + 1], frame.least_speed[a : b + 1])]
        turning = [(t[a : b + 1], frame.least_turning[a : b + 1])]
        ride = [(t[a : b + 1], np.abs(rows.qd[a : b + 1, 0]) - rows.doubt_v[a : b + 1, 0])]
    same(caps._tcp_speeds(frame, a, b, None), chords + at_rows)
    same(caps._tcp(frame, a, b), chords + at_rows)
    same(caps._turning(frame, a, b), angles + turning)
    same(caps._rail_speeds(0, frame, a, b), rail + ride)
    same(caps.tcp_accelerations(frame, a, b, None), bends + pulls)


@pytest.mark.parametrize("tool", TOOLS)
def test_the_tool_between_rows(tool: str) -> None:
    """On SciPy's Hermite, with the robot's own kinematics; the doubt is that of an interval's first row."""
    frame = frame_of(tool, True, True)
    rows, robot, X_FT = frame.rows, PLANT.robot, frame.X_FT
    first, last = 9, 33
    t, every = rows.t, np.arange(first, last)
    times = (t[every, None] + INNER * np.diff(t)[every, None]).ravel()
    spline = CubicHermiteSpline(t, rows.q, rows.qd)
    q, qd, qdd = (spline(times, k) for k in range(3))
    linear, angular = columns(frame)
    places = frame.places(first, last)
    order = np.argsort(np.r_[t[first : last + 1], times])
    X = robot.forward(np.vstack([rows.q[first : last + 1], q])[order]) @ X_FT
    np.testing.assert_allclose(places.t, np.r_[t[first : last + 1], times][order], rtol=1e-14)
    np.testing.assert_allclose(places.p, X[:, :3, 3], atol=1e-9)
    np.testing.assert_allclose(places.R, X[:, :3, :3], atol=1e-9)
    for found, lengths, at in ((places.doubt_p, linear, frame.doubt_p), (places.doubt_angle, angular, frame.doubt_R)):
        inner = (lengths[every] * rows.inner_doubt[first:last]).sum(axis=1)
        wanted = np.r_[at[first : last + 1], np.repeat(inner, 4)][order]
        np.testing.assert_allclose(found, wanted, rtol=1e-7)
    off_v = np.maximum(rows.doubt_v[every], rows.doubt_v[every + 1]) / 2 + 1.5 * rows.mismatch[1][first:last]
    V = (robot.jacobian(q, X_FT) @ qd[..., None])[..., 0]
    inner = caps.Inner(frame, first, last)
    np.testing.assert_allclose(inner.t, times, rtol=1e-14)
    for found, lengths, part in ((inner.speed, linear, V[:, :3]), (inner.turning, angular, V[:, 3:])):
        doubt = np.repeat((lengths[every] * off_v).sum(axis=1), 4)
        np.testing.assert_allclose(found, np.linalg.norm(part, axis=1) - doubt, atol=1e-8)
    for one, name in ((caps._tcp, "speed"), (caps._turning, "turning")):
        same(list(one(frame, first, last))[-1:], [(times, getattr(inner, name))])
    same(list(caps._tcp_speeds(frame, first, last, inner))[-1:], [(times, inner.speed)])
    open_a = (linear[every] * rows.hermite_rounding[first:last]).sum(axis=1)
    beyond = (linear[every] * rows.truncation[first:last]).sum(axis=1) - tol.TCP / 2 * PLANT.tcp.acceleration
    open_a = open_a + np.maximum(beyond, 0.0)
    h = np.diff(t)[every, None]
    c = spline.c[:, every]
    ends = [(t[every], every, 2 * c[1]), (t[every + 1], every + 1, 6 * c[0] * h + 2 * c[1])]
    a = np.linalg.norm(forward_acceleration(robot, q, qd, qdd, X_FT)[:, :3], axis=1)
    wanted = [(times, a - np.repeat(open_a, 4))]
    for when, at, bend in ends:
        a = np.linalg.norm(forward_acceleration(robot, rows.q[at], rows.qd[at], bend, X_FT)[:, :3], axis=1)
        wanted.append((when, a - open_a))
    same(inner.accelerations, wanted)
    same(list(caps.tcp_accelerations(frame, first, last, inner))[-3:], wanted)


def test_a_place_alone_is_its_row() -> None:
    frame = frame_of("grip", True, True)
    places = frame.places(5, 5)
    np.testing.assert_array_equal(places.p, frame.p[5:6])
    assert (len(places.t), len(places.doubt_p), len(places.doubt_angle)) == (1, 1, 1)


def test_what_a_tool_does_that_no_lever_moves_is_what_the_flange_does() -> None:
    frame = frame_of("tool0", True, True)
    rows = replace(frame.rows)
    np.testing.assert_array_equal(frame.J[3:9], rows.J[3:9])
