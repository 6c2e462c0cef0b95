"""The judge's geometry at random and at its edges, against SciPy and closed forms; TCP caps with two tools; and advice
at both sides of what is called tight."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from by_hand import seen
from legal_motion import Case, bench_case, faster, joint_move, plant_with_rail, program, rapid_case
from scipy.optimize import minimize
from scipy.spatial.transform import Rotation, Slerp
from tcp_motion import forward_acceleration

from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.judge import tolerances as tol
from trajopt_cli.judge.advice import TIGHT_MOVE, advise
from trajopt_cli.judge.caps import check_caps
from trajopt_cli.judge.geometry import Arc, Line, angle_between, off_segments, off_triangles, rotation_vectors
from trajopt_cli.limits import TcpCaps


def turns(rng: np.random.Generator, n: int) -> tuple[Array, Array]:
    """Random rotations of random sizes, the smallest a millionth of a radian, and their vectors."""
    u = rng.normal(size=(n, 3))
    v = u / np.linalg.norm(u, axis=1, keepdims=True) * (10.0 ** rng.uniform(-6, 0.49, n))[:, None]
    return Rotation.from_rotvec(v).as_matrix(), v


def test_angles_and_rotation_vectors() -> None:
    rng = np.random.default_rng(95)
    R, v = turns(rng, 60)
    S = Rotation.random(60, random_state=3).as_matrix()
    np.testing.assert_allclose(rotation_vectors(R), v, rtol=1e-9, atol=1e-15)
    np.testing.assert_allclose(angle_between(S, S @ R), np.linalg.norm(v, axis=1), rtol=1e-8)
    assert (rotation_vectors(np.eye(3)[None]) == 0).all()
    assert angle_between(np.eye(3), np.diag([1.0, -1, -1])) == pytest.approx(np.pi)


def test_distances_from_segments_and_triangles() -> None:
    """Against the nearest of all their points, found by a solver; flat and needle-like ones as well."""
    rng = np.random.default_rng(96)
    n = 40
    p, a, b, c = rng.normal(size=(4, n, 3))
    c[:4] = a[:4] + (b[:4] - a[:4]) * np.array([0.3, 1.7, -0.5, 1.0])[:, None]  # flat
    b[4] = a[4]  # no segment at all
    found, wanted = off_segments(p, a, b), []
    for i in range(n):
        share = np.linspace(0, 1, 20001)[:, None]
        wanted.append(np.linalg.norm(a[i] + share * (b[i] - a[i]) - p[i], axis=1).min())
    np.testing.assert_allclose(found, wanted, atol=1e-6)
    found = off_triangles(p, a, b, c)
    for i in range(n):
        u, w = a[i] - b[i], c[i] - b[i]
        best = min(
            minimize(lambda x: float(np.sum((b[i] + x[0] * u + x[1] * w - p[i]) ** 2)), start, method="SLSQP",  # noqa: B023
                     bounds=[(0, 1), (0, 1)], options={"ftol": 1e-14},
                     constraints={"type": "ineq", "fun": lambda x: 1 - x[0] - x[1]}).fun
            for start in ([0.3, 0.3], [0.9, 0.0], [0.0, 0.9])
        )  # fmt: skip
        assert found[i] == pytest.approx(np.sqrt(best), abs=1e-5)


@pytest.mark.parametrize("angle", [0.0, 0.7, 2.5])
@pytest.mark.parametrize("length", [0.0, 2e-7, 5e-6, 0.3])
def test_a_line_may_be_a_reorientation(length: float, angle: float) -> None:
    """One shorter than a micron that turns more than that counts its angle; the share about its own axis alone."""
    rng = np.random.default_rng(97)
    axis = np.array([2.0, -1, 2]) / 3
    R_0 = Rotation.random(random_state=1).as_matrix() if angle else np.eye(3)
    X_0 = pose(R_0, [0.1, 0.2, 0.3])
    X_1 = pose(R_0 @ rotation_about(axis, angle), X_0[:3, 3] + length * np.array([0.6, 0.0, 0.8]))
    line = Line.between(X_0, X_1, X_0[None, :3, :3])
    only = length < 1e-6 and length < angle
    assert line.only_turns == only
    assert line.length == pytest.approx(length, abs=1e-15)
    assert line.angle == pytest.approx(angle, abs=1e-12)
    assert line.extent == pytest.approx(angle if only else length, abs=1e-12)
    s = rng.uniform(-0.1, 1.1, 20)
    p, R = line.at(s)
    np.testing.assert_allclose(p, X_0[:3, 3] + s[:, None] * (X_1 - X_0)[:3, 3], atol=1e-15)
    if angle:
        wanted = Slerp([0, 1], Rotation.from_matrix([R_0, X_1[:3, :3]]))(np.clip(s, 0, 1)).as_matrix()
        inside = (s >= 0) & (s <= 1)
        np.testing.assert_allclose(R[inside], wanted[inside], atol=1e-9)
    found = line.progress(p, R)
    np.testing.assert_allclose(found, 0.0 if length == 0.0 == angle else s, atol=1e-6)
    if only:  # turned aside by a little: its share is that of the turn about its axis
        aside = R @ rotation_about(np.cross(axis, [0, 0, 1.0]) / np.linalg.norm(np.cross(axis, [0, 0, 1.0])), 1e-4)
        np.testing.assert_allclose(line.progress(p, aside), s, atol=1e-4)


@pytest.mark.parametrize("sweep", [0.4, 2.0, 3.5, 6.0])
def test_places_beside_an_arc(sweep: float) -> None:
    """What the circle leaves over belongs half to its start and half to its end; the radius does not matter."""
    radius, centre = 0.2, np.array([0.3, -0.1, 0.5])
    tilt = rotation_about([0.0, 0.6, 0.8], 1.0)

    def on(phi: Array, r: float = radius) -> Array:
        phi = np.asarray(phi)
        return centre + r * np.c_[np.cos(phi), np.sin(phi), 0 * phi] @ tilt.T

    ends, via = on(np.array([0.0, sweep])), on(np.array([0.4 * sweep]))[0]
    line = Line.between(pose(tilt, ends[0]), pose(tilt @ rotation_about([0, 0, 1], 0.3), ends[1]), tilt[None])
    arc = Arc.through(line, via)
    assert arc is not None
    assert (arc.extent, arc.angle, arc.only_turns) == (arc.length, line.angle, False)
    left = 2 * np.pi - sweep
    phi = np.r_[np.linspace(0, sweep, 7), -0.49 * left, sweep + 0.49 * left, -0.01, sweep + 0.01]
    for r in (radius, 0.5 * radius, 1.7 * radius):
        np.testing.assert_allclose(arc.progress(on(phi, r)), phi / sweep, atol=1e-9)
    p, R = arc.at(np.array([0.25]))
    np.testing.assert_allclose(p, on(np.array([0.25 * sweep])), atol=1e-12)
    np.testing.assert_allclose(R, line.at(np.array([0.25]))[1], atol=1e-15)
    assert Arc.through(line, ends[0]) is None


# --- caps and advice ---------------------------------------------------------------------------------------------


def test_caps_hold_each_stretch_with_its_own_tool() -> None:
    """The greatest speed and acceleration of all stretches, each with the tool in force; a hair beyond a cap fails."""
    case = bench_case()
    other = replace(case.program.motions[0].tool, name="long", X_FT=pose(np.eye(3), [0.0, 0.0, 0.5]))
    motions = list(case.program.motions)
    X_FT = motions[2].tool.X_FT
    motions[4] = replace(motions[4], tool=other)
    rows, robot = case.rows(step=0.004), case.plant.robot
    change = int(np.searchsorted(rows.t, case.starts[4] - 1e-9))
    parts = [(slice(0, change + 1), X_FT), (slice(change, len(rows.t)), other.X_FT)]
    top = []
    for part, tool in parts:
        V = (robot.jacobian(rows.q[part], tool) @ rows.qd[part, :, None])[:, :3, 0]
        top.append((np.linalg.norm(V, axis=1).max(), rows.t[part][np.linalg.norm(V, axis=1).argmax()]))
    assert top[1][0] > top[0][0]
    wanted, when = max(top)

    def told(plant_tcp: TcpCaps, asked: list[object]) -> dict[str, object]:
        plant = replace(case.plant, tcp=plant_tcp)
        line, frames = seen(Case(plant, program(*asked), case.pieces), rows, None)
        found = [f for _, some in check_caps(line, frames) for f in some]
        return {f.check: f for f in found if f.check.startswith("TCP")}

    wide = told(TcpCaps(50.0, 500.0), motions)
    assert wide["TCP speed"].value == pytest.approx(wanted, rel=1e-3)
    assert wide["TCP speed"].time == pytest.approx(when, abs=4e-3)
    # without the long tool the same rows are slower
    assert told(TcpCaps(50.0, 500.0), list(case.program.motions))["TCP speed"].value < 0.99 * wanted
    qdd = np.gradient(rows.qd, rows.t, axis=0)
    A = np.linalg.norm(forward_acceleration(robot, rows.q, rows.qd, qdd, other.X_FT)[change + 2 : -2, :3], axis=1)
    assert wide["TCP acceleration"].value == pytest.approx(A.max(), rel=0.1)
    for over in (0.9, 1.1):
        speed = wide["TCP speed"].value / (1 + over * tol.TCP)
        pull = wide["TCP acceleration"].value / (1 + over * tol.TCP)
        found = told(TcpCaps(speed, 500.0), motions)
        assert (found["TCP speed"].passed, found["TCP speed"].limit) == (over < 1, speed)
        assert found["TCP speed"].value == pytest.approx(wide["TCP speed"].value, rel=1e-12)
        assert (found["TCP speed"].unit, found["TCP acceleration"].unit) == ("m/s", "m/s2")
        assert str(found["TCP speed"].source) == "cell.mod:15:5"
        found = told(TcpCaps(50.0, pull), motions)
        assert abs(found["TCP acceleration"].value / pull - 1) < 2 * tol.TCP


def advice_of(case: Case, rapid: bool, speeds: bool = True) -> dict[int, object]:
    rows = case.rows(step=0.004)
    line, frames = seen(case, rows if speeds else replace(rows, qd=None), None, rapid)
    return {f.source.line: f for f in advise(line, frames, rapid)}


@pytest.mark.parametrize("rapid", [False, True])
def test_a_joint_move_is_as_fast_as_its_slowest_axis(rapid: bool) -> None:
    """The rail rides 0.6 m with all its acceleration and speed, a joint goes along with a fifth of what it may: Ruckig
    needs as long. Slower by some microseconds it is told by how much."""
    plant = plant_with_rail()
    way = np.array([0.6, 0.05, 0.02, 0, 0, 0, 0])
    case = rapid_case()
    T = 1.0 / 3.0 + 0.6 / 1.0  # v/a + d/v
    for slower, tight in ((0.0, True), (0.9 * TIGHT_MOVE, True), (1.2 * TIGHT_MOVE, False), (1e-3, False)):
        piece = faster(joint_move(plant, plant.start, plant.start + way), T / (T + slower))
        assert pytest.approx(T + slower, rel=1e-9) == piece.T
        end = replace(case.program.motions[-1], q=(plant.start + way)[1:], extax=(600.0, *[None] * 5))
        one = advice_of(Case(plant, program(end), (piece,)), rapid)[18]
        assert (one.check, one.subject, one.unit) == ("move tightness", "axes", "s")
        assert (one.value, one.limit) == (pytest.approx(slower, abs=2e-8), TIGHT_MOVE)
        assert one.passed == tight
        assert one.time == 0.0
        if not tight:
            assert f"takes {T + slower:.6f} s, Ruckig {T:.6f} s" in one.message


@pytest.mark.parametrize("rapid", [False, True])
def test_a_stream_moves_every_axis_at_its_own_pace(rapid: bool) -> None:
    """The rail is short of speed and the first joint of acceleration: one common profile takes d/v + v/a of the slower
    each, 0.6 + 0.5 s; else the joint alone needs 2 sqrt(0.6/2) s."""
    plant, case = plant_with_rail(), rapid_case()
    limits = replace(plant.limits, acceleration=np.r_[3.0, 2.0, plant.limits.acceleration[2:]])
    plant, way = replace(plant, limits=limits), np.array([0.6, 0.6, 0.0, 0, 0, 0, 0])
    piece = joint_move(plant, plant.start, plant.start + way)
    assert pytest.approx(1.1, rel=1e-9) == piece.T
    end = replace(case.program.motions[-1], q=(plant.start + way)[1:], extax=(600.0, *[None] * 5))
    one = advice_of(Case(plant, program(end), (piece,)), rapid)[18]
    assert one.value == pytest.approx(0.0 if rapid else 1.1 - 2 * np.sqrt(0.3), abs=2e-8)
    assert one.passed == rapid


def slowed(case: Case, i: int, times: float) -> Case:
    """With one piece so many times as long."""
    pieces = list(case.pieces)
    pieces[i] = faster(pieces[i], 1 / times)
    return replace(case, pieces=tuple(pieces))


@pytest.mark.parametrize(("make", "i"), [(rapid_case, 1), (bench_case, 1), (bench_case, 2)])
def test_a_line_twice_as_slow_has_the_same_least_time(make: Callable[[], Case], i: int) -> None:
    """A line with a rail, one with a tool, a pure reorientation."""
    case = make()
    line = case.program.motions[i].source.line
    T = case.pieces[i].T
    at_once, late = (advice_of(one, False)[line] for one in (case, slowed(case, i, 2.0)))
    assert 0.02 < at_once.value < 0.9
    assert 2 * T * (1 - late.value) == pytest.approx(T * (1 - at_once.value), rel=1e-2)
    assert late.time == pytest.approx(case.starts[i])
    assert (late.check, late.limit, late.unit, late.passed) == ("line tightness", 0.002, "of its time", False)
    assert f"takes {2 * T:.4f} s, TOPP-RA {2 * T * (1 - late.value):.4f} s on the same path" in late.message


def test_a_lines_least_time_is_that_of_its_slowest_limit() -> None:
    """80 mm at 0.1 m/s, programmed or by the cap, or 30 mm of the rail at 0.02 m/s, and a ramp at 2 m/s2 of the
    tool; 0.3 rad at 0.1 rad/s, and hardly a ramp."""
    case = rapid_case(replace(plant_with_rail(), tcp=TcpCaps(2.5, 2.0)))
    capped = rapid_case(replace(plant_with_rail(), tcp=TcpCaps(0.1, 2.0)))
    speed = case.program.motions[1].speed
    for one, i, given, wanted, off in (
        (case, 1, replace(speed, v_tcp=0.1), 0.8 + 0.05, 2e-3), (capped, 1, speed, 0.8 + 0.05, 2e-3),
        (case, 1, replace(speed, v_leax=0.02), 1.5 + 0.02 / 0.03 * 0.08 / 2.0, 2e-3),
        (bench_case(), 2, replace(speed, v_ori=0.1), 3.0, 0.02),
    ):  # fmt: skip
        motions = list(one.program.motions)
        motions[i] = replace(motions[i], speed=given)
        slow = slowed(replace(one, program=program(*motions)), i, 12.0)
        found = advice_of(slow, False)[motions[i].source.line]
        assert slow.pieces[i].T * (1 - found.value) == pytest.approx(wanted, rel=off), given


def test_where_no_advice_is_given() -> None:
    """Without speeds; where torques bind; of moves with a time of their own, near a cap, or that positioners share."""
    case = rapid_case()
    whole = advice_of(case, True)
    assert {12, 14, 15, 16} <= set(whole)
    assert advice_of(case, True, speeds=False) == {}
    limits = replace(case.plant.limits, torque=np.full(7, 1e6), torque_binds=True)
    assert advice_of(replace(case, plant=replace(case.plant, limits=limits)), True) == {}
    for i in (1, 4):
        motions = list(case.program.motions)
        motions[i] = replace(motions[i], duration=case.pieces[i].T)
        assert set(whole) - set(advice_of(replace(case, program=program(*motions)), True)) == {motions[i].source.line}
    rows = case.rows(step=0.004)
    peaks = {}
    for i in (0, 4):
        a, b = np.searchsorted(rows.t, [case.starts[i] + 1e-9, case.starts[i + 1] - 1e-9])
        V = (case.plant.robot.jacobian(rows.q[a:b]) @ rows.qd[a:b, :, None])[..., 0]
        peaks[i] = [np.linalg.norm(part, axis=1).max() for part in (V[:, :3], V[:, 3:], rows.qd[a:b, :1])]
    fast = peaks[4][0]
    for i, name, value in ((4, "v_tcp", fast), (0, "v_ori", peaks[0][1]), (4, "v_leax", peaks[4][2])):
        for used, there in ((0.9985, True), (0.9995, False)):
            motions = list(case.program.motions)
            motions[i] = replace(motions[i], speed=replace(motions[i].speed, **{name: value / used}))
            found = advice_of(replace(case, program=program(*motions)), True)
            assert (motions[i].source.line in found) == there, (name, used)
    plant = replace(case.plant, tcp=TcpCaps(fast / 0.9995, 20.0))
    assert 15 not in advice_of(replace(case, plant=plant), True)
