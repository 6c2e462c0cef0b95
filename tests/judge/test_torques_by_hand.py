"""Least torques of a file, against the formulas written out row by row; and which load counts in which rows."""

from __future__ import annotations

from collections.abc import Iterable
from types import SimpleNamespace

import numpy as np
import pytest
from heavy_cells import heavy
from legal_motion import FINE, V2500, move_ext, program, wait
from scipy.interpolate import CubicHermiteSpline
from scipy.spatial.transform import Rotation

from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.judge import torques
from trajopt_cli.judge.mechanism import Forces, mechanism_of
from trajopt_cli.judge.samples import Rows, judged_rows
from trajopt_cli.judge.timeline import Timeline
from trajopt_cli.motion import NO_EXTERNAL_AXES, Load, MoveAbsJ, Program, Settings, Source, Span, Tool, Written
from trajopt_cli.trajectory import Trajectory

PLANT = heavy()
N = 40
TOOL_LOAD = Load("t", 4.0, (0.03, 0.01, 0.08), (0.8, 0.0, 0.6, 0.0), (0.02, 0.03, 0.04))
HELD_LOAD = Load("l", 3.0, (0.0, 0.02, 0.05), (1.0, 0.0, 0.0, 0.0), (0.01, 0.01, 0.02))
BARE = Tool("tool0", np.eye(4))
GRIP = Tool("grip", pose(rotation_about([0, 1, 0], 0.5), [0.05, 0.0, 0.1]), load=TOOL_LOAD)


def move(line: int, tool: Tool, held: Load | None = None) -> MoveAbsJ:
    return MoveAbsJ(
        source=Source("cell.mod", line, 5), written=Written(Span("t.mod", 0, 1)), target="j", speed=V2500, zone=FINE,
        extax=NO_EXTERNAL_AXES, q=PLANT.start, tool=tool, settings=Settings(load=held),
    )  # fmt: skip


def rows_of(speeds: bool, marked: bool) -> Rows:
    rng = np.random.default_rng(61)
    t = np.cumsum(np.r_[0.1, rng.uniform(0.006, 0.012, N - 1)])
    if marked:
        t = np.sort(np.r_[np.arange(N - 1) * 0.008, 0.1031])
    phase, rate = rng.uniform(0, 6, 6), rng.uniform(2, 5, 6)
    q = PLANT.start + 0.3 * np.sin(rate * t[:, None] + phase) + 1e-4 * rng.normal(size=(N, 6))
    qd = 0.3 * rate * np.cos(rate * t[:, None] + phase) + 1e-2 * rng.normal(size=(N, 6))
    steps = Resolution(
        rng.uniform(1e-6, 2e-5, N), rng.uniform(1e-6, 2e-5, (N, 6)), rng.uniform(1e-5, 1e-3, (N, 6)) * speeds
    )
    rows = judged_rows(PLANT, Trajectory(PLANT.limits.names, t, q, qd if speeds else None), steps)
    assert (rows.marked, rows.exact) == (marked, marked and speeds)
    return rows


def carried_by(asked: Program, rows: Rows, ends: list[tuple[int, int]], fly_by: int | None = None) -> torques._Carried:
    """What is carried where the points of a program are reached and left at these rows; the start first."""
    visits = [
        SimpleNamespace(point=SimpleNamespace(index=i - 1, fly_by="zone" if i == fly_by else None), event=True,
                        arrive=arrive, depart=depart)
        for i, (arrive, depart) in enumerate(ends)
    ]  # fmt: skip
    return torques._Carried(asked, Timeline(rows, tuple(visits)))  # type: ignore[arg-type]


def plain(rows: Rows) -> tuple[torques._Carried, Forces]:
    carried = carried_by(program(move(11, BARE)), rows, [(0, 0), (N - 1, N - 1)])
    return carried, Forces(mechanism_of(PLANT), PLANT.robot.rotor, [])


def doubt_of(forces: Forces, q: Array, v: Array, a: Array, off: tuple[Array, Array, Array]) -> Array:
    """How far the torques of one row may be off: every change by what it changes with."""
    changes = forces.changes(q[None], v[None], a[None])
    return np.asarray(sum(np.abs(change[0]) @ one for change, one in zip(changes, off, strict=True)))


def same(found: Iterable[tuple[Array, Array]], wanted: list[tuple[Array, Array]]) -> None:
    found = list(found)
    assert len(found) == len(wanted)
    for (t, x), (t_wanted, x_wanted) in zip(found, wanted, strict=True):
        np.testing.assert_allclose(t, t_wanted, rtol=1e-12)
        np.testing.assert_allclose(x, x_wanted, rtol=1e-8, atol=1e-8)


def test_torques_where_the_hermite_is_the_motion() -> None:
    """Where every interval begins and ends, and between; the doubt is that of its first row with its mean
    acceleration."""
    rows = rows_of(True, True)
    carried, forces = plain(rows)
    first, last = 3, 31
    t, q, v = rows.t, rows.q, rows.qd
    spline, h = CubicHermiteSpline(t, q, v), np.diff(t)[:, None]
    at = (t[first:last, None] + np.array([0.2, 0.4, 0.6, 0.8]) * h[first:last]).ravel()
    doubts = []
    for i in range(first, last):
        off = (np.maximum(rows.doubt_q[i], rows.doubt_q[i + 1]), np.maximum(rows.doubt_v[i], rows.doubt_v[i + 1]),
               rows.hermite_rounding[i] + rows.truncation[i])  # fmt: skip
        doubts.append(doubt_of(forces, q[i], v[i], (v[i + 1] - v[i]) / h[i], off))
    part, behind, doubt = slice(first, last), slice(first + 1, last + 1), np.array(doubts)
    begin, end = 2 * spline.c[1], 6 * spline.c[0] * h + 2 * spline.c[1]
    wanted = [
        (t[part], np.abs(forces.torques(q[part], v[part], begin[part])) - doubt),
        (t[behind], np.abs(forces.torques(q[behind], v[behind], end[part])) - doubt),
        (at, np.abs(forces.torques(spline(at), spline(at, 1), spline(at, 2))) - np.repeat(doubt, 4, axis=0)),
    ]
    same(torques._exact(rows, carried, first, last), wanted)


@pytest.mark.parametrize("speeds", [True, False])
def test_mean_torques(speeds: bool) -> None:
    """In the middle, less what digits leave open, and less by how much they differ at both ends, where the masses may
    be others at full acceleration. With speeds between two rows; without over the four shortest lags."""
    rows = rows_of(speeds, False)
    carried, forces = plain(rows)
    first, last = 2, 37
    t, q, top = rows.t, rows.q, PLANT.limits.acceleration
    wanted = []

    def mean(states: list[tuple[Array, Array]], a: Array, open_a: Array, i: int, k: int) -> tuple[Array, Array]:
        (q_0, v_0), *ends = states
        middle = forces.torques(q_0[None], v_0[None], a[None])[0]
        mass = forces.masses(q_0[None])[0]
        swing = np.zeros(6)
        for q_1, v_1 in ends:
            heavier = np.abs(forces.masses(q_1[None])[0] - mass) @ top
            swing = np.maximum(swing, np.abs(forces.torques(q_1[None], v_1[None], a[None])[0] - middle) + heavier)
        off = (np.maximum(rows.doubt_q[i], rows.doubt_q[k]), np.maximum(rows.doubt_v[i], rows.doubt_v[k]), open_a)
        doubt = doubt_of(forces, q_0, v_0, a, off) + swing
        return np.abs(middle) - doubt

    if speeds:
        v, values = rows.qd, []
        for i in range(first, last):
            h = t[i + 1] - t[i]
            open_a = (rows.doubt_v[i] + rows.doubt_v[i + 1]) / 2 / max(h - rows.step_t.max(), h / 2)
            states = [((q[i] + q[i + 1]) / 2, (v[i] + v[i + 1]) / 2), (q[i], v[i]), (q[i + 1], v[i + 1])]
            value = mean(states, (v[i + 1] - v[i]) / h, open_a, i, i + 1)
            values.append(value)
        wanted.append(((t[first:last] + t[first + 1 : last + 1]) / 2, np.array(values)))
    else:
        off_t, half = rows.step_t / 2, rows.doubt_q / 2
        for m in (1, 2, 4, 8):
            values = []
            for i in range(first, last + 1 - 2 * m):
                b, c = i + m, i + 2 * m
                rates, open_a = [], np.zeros(6)
                for k, n in ((i, b), (b, c)):
                    rate, unsure = (q[n] - q[k]) / (t[n] - t[k]), off_t[k] + off_t[n]
                    open_a = open_a + (half[k] + half[n] + np.abs(rate) * unsure) / (t[n] - t[k] - unsure)
                    rates.append(rate)
                a = 2 * (rates[1] - rates[0]) / (t[c] - t[i])
                unsure = off_t[i] + off_t[c]
                open_a = (2 * open_a + np.abs(a) * unsure) / (t[c] - t[i] - unsure)
                speed = (q[c] - q[i]) / (t[c] - t[i])
                states = [(q[b], speed), (q[i], speed - a * (t[b] - t[i])), (q[c], speed + a * (t[c] - t[b]))]
                value = mean(states, a, open_a, i, c)
                values.append(value)
            wanted.append((t[first + m : last + 1 - m], np.array(values)))
    same(torques._mean_torques(rows, carried, first, last), wanted)


def test_what_each_move_carries() -> None:
    """The tool's own load from the move on that names it, what it holds in the tool's frame; external axes alone keep
    the tool; a wait carries what the move before it carried."""
    asked = program(move(11, BARE), wait(12, 0.1), move(13, GRIP), move_ext(14, 0.1), move(15, GRIP, HELD_LOAD),
                    move(16, BARE, HELD_LOAD), move(17, BARE))  # fmt: skip
    flange, tool = np.eye(4).tobytes(), np.asarray(GRIP.X_FT).tobytes()
    assert torques._loads(asked) == {
        0: (), 2: ((TOOL_LOAD, flange),), 3: ((TOOL_LOAD, flange),),
        4: ((TOOL_LOAD, flange), (HELD_LOAD, tool)), 5: ((HELD_LOAD, flange),), 6: (),
    }  # fmt: skip
    assert torques._loads(program(move_ext(11, 0.1))) == {0: ()}


def test_a_load_is_a_body_at_the_flange() -> None:
    """Its centre in the frame it is given in; its axes of moment turned with that, by SciPy's rotations."""
    mass, centre, inertia = torques._body(TOOL_LOAD, np.asarray(GRIP.X_FT).tobytes())
    X = GRIP.X_FT
    w, x, y, z = TOOL_LOAD.aom
    axes = X[:3, :3] @ Rotation.from_quat([x, y, z, w]).as_matrix()
    assert mass == 4.0
    np.testing.assert_allclose(centre, X[:3, :3] @ np.array(TOOL_LOAD.cog) + X[:3, 3], atol=1e-15)
    np.testing.assert_allclose(inertia, axes @ np.diag(TOOL_LOAD.inertia) @ axes.T, atol=1e-15)


@pytest.mark.parametrize("marked", [True, False])
def test_loads_change_where_their_moves_end(marked: bool) -> None:
    """Of intervals that may have two loads the less torque counts; beside a boundary that has no row, and in a corner,
    either may be there for two rows."""
    rows = rows_of(True, marked)
    asked = program(move(11, GRIP), move(12, BARE), move(13, GRIP))
    for fly_by in (None, 2):
        carried = carried_by(asked, rows, [(0, 2), (10, 12), (20, 24), (N - 1, N - 1)], fly_by)
        assert len(carried.forces) == 2  # with and without it
        may = np.zeros((2, N - 1), dtype=bool)
        near = [0 if marked and fly_by != i else 2 for i in range(4)]
        # the start's load is that of the first move
        for kind, begin, end, beside in (
            (0, 0, 2, near[0]),
            (0, 2, 12, near[1]),
            (1, 12, 24, near[2]),
            (0, 24, N - 1, near[3]),
        ):
            may[kind, max(begin - beside, 0) : end + beside] = True
        np.testing.assert_array_equal(carried.may, may)
        of = [np.full((N - 1, 6), 5.0), np.full((N - 1, 6), 3.0)]
        i = np.arange(N - 1)
        np.testing.assert_array_equal(carried.least(i, i + 1, of)[:, 0], np.where(may[1], 3.0, 5.0))
        long = np.arange(N - 3)
        reaches = np.array([may[1, k : k + 3].any() for k in long])
        np.testing.assert_array_equal(
            carried.least(long, long + 3, [one[:-2] for one in of])[:, 0], np.where(reaches, 3.0, 5.0)
        )
        assert carried.least(i[5:6], i[5:6], [one[:1] for one in of])[0, 0] == 5.0
