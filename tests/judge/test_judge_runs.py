"""Legal motions through corners and along arcs stay legal, however they are written down."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from legal_motion import Case, down, home, move_ext, move_j, move_l, plant_with_rail, program, trapezoid, wait
from legal_motion import judged as verify
from legal_runs import (
    P0,
    P1,
    P2,
    RUNS,
    V100,
    VIA,
    Z0,
    Z10,
    contour,
    joint_line,
    leaning,
    line_line,
    move_abs,
    move_c,
    run_case,
    time_at,
    turned,
    turns_in_place,
    with_rail,
)
from spoiled_runs import bumped, faster_between, with_swaying_rail
from test_judge_legal import printed

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, pose, rotation_about
from trajopt_cli.judge.geometry import Arc, off_triangles, rotation_vectors
from trajopt_cli.judge.geometry import Line as JudgesLine
from trajopt_cli.judge.program_points import points_of
from trajopt_cli.motion import CirPathMode, FlyBy, Hold, Motion, Tool, Zone
from trajopt_cli.path.line import Line as PathLine
from trajopt_cli.problem.plan import Target
from trajopt_cli.trajectory import Trajectory

ROWS: dict[str, dict[str, object]] = {
    "own": {"step": 0.002},
    "1kHz": {"grid_only": True, "step": 0.001},
    "250Hz": {"grid_only": True, "step": 0.004},
    "50Hz": {"grid_only": True, "step": 0.02},
}


@cache
def made_run(name: str) -> Case:
    return RUNS[name]()


@cache
def fine_rows(name: str, kind: str) -> Trajectory:
    return made_run(name).rows(**ROWS[kind])


@pytest.mark.parametrize("decimals", [None, 6])
@pytest.mark.parametrize("kind", ROWS)
@pytest.mark.parametrize("name", RUNS)
def test_a_legal_run_passes(name: str, kind: str, decimals: int | None) -> None:
    """With speeds and without, on either target: both targets meet every kind of rows, digits and speeds."""
    case, fine = made_run(name), fine_rows(name, kind)
    for speeds in (True, False):
        target = Target.RAPID if (kind in ("own", "250Hz")) ^ (decimals is None) ^ speeds else None
        trajectory, resolution = printed(fine, decimals, speeds)
        report = verify(case.program, case.plant, trajectory, resolution, target=target)
        assert report.legal, [f.message for f in report.findings if not f.passed]


@pytest.mark.parametrize("mode", [CirPathMode.PATH_FRAME, CirPathMode.OBJECT_FRAME, CirPathMode.CIR_POINT_ORI])
def test_an_arc_that_turns_as_another_mode_would_is_illegal(mode: CirPathMode) -> None:
    for other in {CirPathMode.PATH_FRAME, CirPathMode.CIR_POINT_ORI} - {mode}:
        case = leaning(mode, other)
        report = verify(case.program, case.plant, case.rows(step=0.008, grid_only=True), None, target=None)
        failed = {f.check for f in report.findings if not f.passed}
        assert "arc rotation" in failed, (mode, other)
        assert failed <= {"arc rotation", "corner rotation"}


def test_rows_close_together_at_the_edge_of_a_zone_do_not_divide_it() -> None:
    """A long interval behind them may come near the zone by what is granted for its length, a short one does not."""
    case = line_line(turn=0.3)
    way = 0.11  # m
    edge = case.starts[1] + time_at(0.05 - 10e-3, way)
    rows = case.rows(step=1e-3)
    extra = edge - np.array([20e-6, 12e-6, 4e-6])
    q, qd = case.pieces[1].at(extra - case.starts[1])
    kept = (rows.t < edge - 0.9e-3) | (rows.t > edge + 1e-4)
    t = np.r_[rows.t[kept], extra]
    order = np.argsort(t)
    dense = Trajectory(rows.names, t[order], np.r_[rows.q[kept], q][order], np.r_[rows.qd[kept], qd][order])
    report = verify(case.program, case.plant, dense)
    assert report.legal, [f.message for f in report.findings if not f.passed]


def test_rows_close_together_at_the_edge_of_a_zone_that_is_an_angle_do_not_divide_it() -> None:
    case = turns_in_place()
    at = trapezoid(0.5 / 0.7, 3.0 / 0.7)[1]
    edge = np.interp((0.4 - 0.12) / 0.7, at(np.linspace(0, 2, 200_001))[0], np.linspace(0, 2, 200_001))
    rows = case.rows(step=1e-3)
    extra = case.starts[1] + edge - np.array([2e-3, 1.5e-3, 0.9e-3])
    q, qd = case.pieces[1].at(extra - case.starts[1])
    kept = (rows.t < extra[0] - 6e-3) | (rows.t > extra[-1] + 5e-4)
    t = np.r_[rows.t[kept], extra]
    order = np.argsort(t)
    dense = Trajectory(rows.names, t[order], np.r_[rows.q[kept], q][order], np.r_[rows.qd[kept], qd][order])
    report = verify(case.program, case.plant, dense)
    assert report.legal, [f.message for f in report.findings if not f.passed]


def test_the_checks_of_a_run() -> None:
    case = RUNS["rail"]()
    made = [f.check for f in verify(case.program, case.plant, case.rows(), target=Target.RAPID).findings]
    assert {check: made.count(check) for check in made if check.split()[0] in ("line", "arc", "corner", "fly-by")} == {
        "fly-by passed": 2, "line position": 2, "line rotation": 2, "line progress": 2, "arc position": 1,
        "arc rotation": 1, "arc progress": 1, "corner rotation": 2,
    }  # fmt: skip
    assert made.count("rail along line") == 2
    assert made.count("rail along arc") == 1


def test_five_hundred_points_are_one_run_judged_in_seconds() -> None:
    case = contour(500, v=0.095)
    rows = case.rows(step=1e-3)
    assert len(rows.t) > 7_500
    begin = time.perf_counter()
    report = verify(case.program, case.plant, rows)
    assert time.perf_counter() - begin < 30
    assert report.legal, [f.message for f in report.findings if not f.passed][:5]
    assert sum(f.check == "fly-by passed" for f in report.findings) == 499


# ------------------------------------------------------------------------------------------- which points are passed

OTHER = Tool("other", pose(np.eye(3), [0, 0, 0.1]))
OTHER_P2 = pose(P1[:3, :3], (P1 @ OTHER.X_FT)[:3, 3] + [0, 0.04, 0])
FLAT = Zone("flat", False, 0.0, 10e-3, 10e-3)
REACHES: list[tuple[str, Sequence[Motion], list[FlyBy | None]]] = [
    ("fine", [move_l(12, "p_1", P1), move_l(13, "p_2", P2)], [None, None]),
    (
        "a right angle",
        [move_l(12, "p_1", P1, zone=Z10), move_l(13, "p_2", P2, zone=Z10)],
        [FlyBy(10e-3, 15e-3, 15e-3), None],
    ),
    (
        "half of the shorter way",
        [move_l(12, "p_1", down(0.462, 0, 0.4), zone=Z10), move_l(13, "p_2", P2)],
        [FlyBy(6e-3, 6e-3, 6e-3), None],
    ),
    (
        "half of the arc, which is longer than its chord",
        [
            move_l(12, "p_1", P1, zone=replace(Z10, radius=0.1)),
            move_c(13, "p_2", VIA, P2, zone=replace(Z10, radius=0.045)),
            move_l(14, "p_3", down(0.3, 0.06, 0.4)),
        ],
        [FlyBy(0.025, 0.025, 0.025), FlyBy(0.045, 0.045, 0.045), None],
    ),
    ("a wait", [move_l(12, "p_1", P1, zone=Z10), wait(13, 0.1), move_l(14, "p_2", P2)], [None, None]),
    ("on a signal", [move_l(12, "p_1", P1, zone=Z10), wait(13, 0.0, "di"), move_l(14, "p_2", P2)], [None, None]),
    (
        "no wait at all",
        [move_l(12, "p_1", P1, zone=Z0), wait(13, 0.0), move_l(14, "p_2", P2)],
        [FlyBy(0.3e-3, 0.3e-3, 0.3e-3), None],
    ),
    ("a turn in place", [move_l(12, "p_1", P1, zone=Z10), move_l(13, "p_2", turned(P1, 0.3))], [None, None]),
    (
        "hardly a way",
        [move_l(12, "p_1", P1, zone=Z10), move_l(13, "p_2", down(0.5, 0.5e-6, 0.4)), move_l(14, "p_3", P2)],
        [None, None, None],
    ),
    ("no radius", [move_l(12, "p_1", P1, zone=FLAT), move_l(13, "p_2", P2)], [None, None]),
    (
        "the tool changes: half of the way of the other one's centre point, 40 mm long",
        [move_l(12, "p_1", P1, zone=replace(Z10, radius=0.1)), move_l(13, "p_2", OTHER_P2, tool=OTHER)],
        [FlyBy(0.02, 0.02, 0.02, joint=True), None],
    ),
    (
        "the work object changes",
        [move_l(12, "p_1", P1, zone=Z10, X_WO=np.eye(4)), move_l(13, "p_2", P2, X_WO=P0)],
        [FlyBy(10e-3, 15e-3, 15e-3, joint=True), None],
    ),
    (
        "between turns in place, half of the smaller one",
        [
            move_l(12, "p_1", P1),
            move_l(13, "p_2", turned(P1, 0.3), zone=replace(Z10, ori=0.1)),
            move_l(14, "p_3", turned(P1, 0.46), zone=replace(Z10, ori=0.1)),
            move_l(15, "p_4", P2),
        ],
        [None, FlyBy(0.08, 0.08, 0.08, in_place=True), None, None],
    ),
    ("external axes alone", [move_l(12, "p_1", P1, zone=Z10), move_ext(13, 0.3), home(14)], [None, None, None]),
]


@pytest.mark.parametrize(("motions", "wanted"), [case[1:] for case in REACHES], ids=[case[0] for case in REACHES])
def test_points_are_passed_or_stops_as_a_controller_decides(
    motions: Sequence[Motion], wanted: list[FlyBy | None]
) -> None:
    points = points_of(program(move_j(11, "p_0", P0, 0.0), *motions), plant_with_rail())[2:]
    assert len(points) == len(wanted)
    for point, fly_by in zip(points, wanted, strict=True):
        if fly_by is None:
            assert point.fly_by is None, point.name
        else:
            assert point.fly_by is not None, point.name
            assert point.fly_by[:3] == pytest.approx(fly_by[:3], abs=1e-9)
            assert point.fly_by[3:] == fly_by[3:]


def test_joints_without_a_rail_position_are_passed_where_the_rail_was_programmed_last() -> None:
    plant = plant_with_rail()
    motions = [move_j(11, "p_0", P0, 0.3), move_abs(12, np.zeros(6), zone=Z10), move_l(13, "p_2", P2)]
    (passed,) = (point for point in points_of(program(*motions), plant) if point.fly_by is not None)
    wanted = plant.robot.forward(np.array([[0.3, 0, 0, 0, 0, 0, 0]]))[0]
    np.testing.assert_allclose(passed.X_WF, wanted, rtol=0, atol=1e-9)
    (stop,) = (p for p in points_of(program(*motions[:2]), plant) if p.arm is not None and p.move is not None)
    assert stop.X_WF is None


def test_points_on_one_line_make_no_circle() -> None:
    case = RUNS["arc"]()
    straight = move_c(13, "p_2", (P1[:3, 3] + P2[:3, 3]) / 2, P2)
    with pytest.raises(InputError, match=r"^cell\.mod:13:5: MoveC p_2: start, point on the way and end \[500\.000, "):
        verify(program(*case.program.motions[:2], straight), case.plant, case.rows())


@pytest.mark.parametrize("optional", [True, False])
def test_a_fly_by_that_may_be_left_out(optional: bool) -> None:
    """p_x stands aside; without it the zone of p_1 reaches its programmed radius."""
    case = line_line()
    aside = move_l(20, "p_x", down(0.505, -0.001, 0.412), zone=Z10, optional=optional)
    motions = list(case.program.motions)
    motions.insert(2, aside)
    rows = case.rows()
    assert verify(program(*motions), case.plant, rows).legal == optional
    report = verify(program(*motions), case.plant, rows, dropped={2})
    assert report.legal == optional
    assert optional or [f.check for f in report.findings if not f.passed] == ["dropped motion"]


def test_a_missing_point_is_one_finding() -> None:
    case = line_line()
    motions = list(case.program.motions)
    motions.insert(2, move_l(20, "p_x", down(0.55, 0.03, 0.4), zone=Z10))
    failed = [f for f in verify(program(*motions), case.plant, case.rows()).findings if not f.passed]
    assert [(f.check, f.source.line if f.source else 0) for f in failed] == [("fly-by passed", 20)]
    assert failed[0].message.endswith("at most 0.01: MoveL p_x is not passed in program order")


@pytest.mark.parametrize("slow_first", [True, False])
def test_a_speed_goes_over_into_the_next_within_the_zone(slow_first: bool) -> None:
    """0.09 m/s, and up to 0.14 m/s on one line and in its half of the corner; the other is programmed at v100."""
    slow, fast = line_line(v=0.09), (0.051, 0.08) if slow_first else (0.02, 0.049)
    case, rows, _ = faster_between(slow, *(time_at(sigma, 0.11, 0.09) for sigma in fast), 1.6)
    motions = list(case.program.motions)
    i = 1 if slow_first else 2
    motions[i] = replace(motions[i], speed=V100)
    report = verify(program(*motions), case.plant, rows)
    assert report.legal, [f.message for f in report.findings if not f.passed]
    motions[3 - i] = replace(motions[3 - i], speed=V100)
    failed = {f.check for f in verify(program(*motions), case.plant, rows).findings if not f.passed}
    assert failed == {"programmed speed"}


def test_a_rail_held_before_a_corner_may_move_in_its_zone() -> None:
    case = with_rail()
    held = [replace(motion, hold=Hold.PROGRAM if i == 1 else None) for i, motion in enumerate(case.program.motions)]
    failed = [f for f in verify(program(*held), case.plant, case.rows()).findings if not f.passed]
    assert [(f.check, f.source.line if f.source else 0) for f in failed] == [("way while held", 12)]
    way = np.linalg.norm((P1 - P0)[:3, 3])
    assert failed[0].value == pytest.approx((0.09 - 0.05) * (1 - 15e-3 / way), abs=2e-4)


# --------------------------------------------------------------------------------------------------------- geometry


@pytest.mark.parametrize("sweep", [0.1, 1.0, 3.0, 4.5])
def test_an_arc_is_a_circle_and_a_slerp(sweep: float) -> None:
    """Against angles on a known circle, tilted in space."""
    tilt, centre, radius = rotation_about([0.6, 0, 0.8], 0.7), np.array([0.4, -0.2, 0.9]), 0.13
    phi = np.linspace(0, sweep, 9)
    p = centre + radius * np.c_[np.cos(phi), np.sin(phi), 0 * phi] @ tilt.T
    R = tilt @ rotation_about([0, 1, 0], phi / sweep * 0.8)
    line = JudgesLine.between(pose(R[0], p[0]), pose(R[-1], p[-1]), R)
    arc = Arc.through(line, p[2])
    assert arc is not None
    assert (arc.sweep, arc.length) == (pytest.approx(sweep, abs=1e-9), pytest.approx(radius * sweep, abs=1e-9))
    np.testing.assert_allclose(arc.centre, centre, rtol=0, atol=1e-9)
    np.testing.assert_allclose(arc.progress(p), phi / sweep, rtol=0, atol=1e-9)
    for found, wanted in zip(arc.at(phi / sweep), (p, R), strict=True):
        np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-9)
    assert Arc.through(line, (p[0] + p[-1]) / 2) is None


def test_distances_from_triangles() -> None:
    a, b, c = np.array([1.0, 0, 0]), np.zeros(3), np.array([0.0, 1, 0])
    p = np.array([[0.2, 0.2, 0], [0.2, 0.2, 0.3], [1, 1, 0], [-0.5, 0.5, 0], [2, 0, 0], [-0.3, -0.4, 0]])
    wanted = [0, 0.3, np.sqrt(0.5), 0.5, 1, 0.5]
    full = [np.tile(x, (len(p), 1)) for x in (a, b, c)]
    np.testing.assert_allclose(off_triangles(p, *full), wanted, rtol=0, atol=1e-15)
    flat = [full[0], full[1], -full[0]]
    np.testing.assert_allclose(off_triangles(p, *flat), [0.2, np.hypot(0.2, 0.3), 1, 0.5, 1, 0.4], rtol=0, atol=1e-15)


def test_a_bezier_of_two_turns_stays_within_what_is_granted() -> None:
    """Up to 1.5 rad each: the rotation vector leaves the triangle by less than a sixteenth of |a x b|."""
    rng = np.random.default_rng(612)
    u = np.linspace(0, 1, 101)
    used = []
    for _ in range(200):
        a, b = (x / np.linalg.norm(x) * rng.uniform(0.01, 1.5) for x in rng.normal(size=(2, 3)))

        def turned_by(turn: Array, share: Array) -> Array:
            angle = float(np.linalg.norm(turn))
            return rotation_about(turn / angle, share * angle)

        found = rotation_vectors(turned_by(a, -((1 - u) ** 2)) @ turned_by(b, u**2))
        off = off_triangles(found, *(np.tile(x, (len(u), 1)) for x in (-a, np.zeros(3), b)))
        used.append(off.max() / (np.linalg.norm(np.cross(a, b)) / 16))
    assert 0.3 < max(used) < 1
    assert min(used) < 0.6


@pytest.mark.parametrize("step", np.linspace(0.018, 0.02, 12))
def test_a_small_hairpin_between_two_rows_is_legal(step: float) -> None:
    """The row nearest to the point may be before the zone or behind it."""
    X_2 = down(0.45, 0.01, 0.4)
    motions = [move_l(12, "p_1", P1, zone=Z0), move_l(13, "p_2", X_2)]
    case = run_case(motions, [PathLine(P0, P1), PathLine(P1, X_2)], [(Z0.radius, Z0.radius)], v=0.042)
    report = verify(case.program, case.plant, case.rows(grid_only=True, step=step))
    assert report.legal, [f.message for f in report.findings if not f.passed]


FREE = {
    "the rail sways on a line": lambda: with_swaying_rail(1e-3),
    "beside a joint move elsewhere in the sphere": lambda: in_the_corner(
        joint_line(), 0.16, [0, 0, 1.0, 0, 0, 0], 1e-3
    ),
    "another curve in the triangle": lambda: in_the_corner(line_line(), 0.11, [-1.0, 1.0, 0, 0, 0, 0], 1e-3),
}


def in_the_corner(case: Case, length: float, twist: list[float], high: float) -> Case:
    """The TCP aside by high * twist in the corner around its first point."""
    return bumped(case, *(time_at(0.05 + x, length) for x in (-0.9 * Z10.radius, 0.9 * Z10.radius)), twist, high)


@pytest.mark.parametrize("name", FREE)
def test_a_stream_is_free_within_its_corridor(name: str) -> None:
    """No form is asked for in a zone, nor a share of the path of the rail."""
    case = FREE[name]()
    assert verify(case.program, case.plant, case.rows(), target=Target.STREAM).legal
