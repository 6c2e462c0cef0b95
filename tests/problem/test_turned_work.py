"""Lines and arcs on a work object that turns meanwhile: planned in step with the table, and held against it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
from small_cells import plant_with_rail, problem_of, rapid
from unrefined import coarse_search, set_defaults

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.egm import stream_of
from trajopt_cli.exporters.joint import resample
from trajopt_cli.exporters.recorded import Recorded
from trajopt_cli.findings import Report
from trajopt_cli.geometry import Array
from trajopt_cli.joint_csv import read_csv_text, write_csv_text
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import MoveC, MoveL, Program
from trajopt_cli.nlp.constraint_tightening import back_off
from trajopt_cli.path.of_motion import segment_of
from trajopt_cli.plan import optimize
from trajopt_cli.problem.decision_scope import AS_WRITTEN
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.scenario import PositionerAxis, Scenario
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.dense_check import check_leg
from trajopt_cli.trajectories.iterate import Margins
from trajopt_cli.trajectories.leg_trajectories import PathLeg, parabola
from trajopt_cli.trajectory import Trajectory

pytestmark = pytest.mark.usefixtures("coarse")

CENTRE = np.array([0.6, 0.5, 0.1])
V, A = float(np.radians(90)), float(np.radians(180))
PLANT = plant_with_rail((-0.1, 0.8))


def axis(eax: int, p: tuple[float, float, float], rpy: tuple[float, float, float] = (0, 0, 0)) -> PositionerAxis:
    x, y, z, w = (float(value) for value in pin.Quaternion(pin.rpy.rpyToMatrix(*rpy)).coeffs())
    return PositionerAxis(eax, p, (w, x, y, z), (-3.2, 3.2), V, A, 0.0, "a test")


TABLE = Scenario(positioners={"stn1": (axis(1, (0.6, 0.5, 0.1)),)})
DATA = """PERS wobjdata wobj_t:=[FALSE,FALSE,"STN1",[[0,0,0],[1,0,0,0]],[[0,0,50],[1,0,0,0]]];
CONST robtarget p_1:=[[-120,-90,200],[0,0,1,0],[0,0,0,0],[9E9,0,9E9,9E9,9E9,9E9]];
CONST robtarget p_2:=[[-120,90,200],[0,0,1,0],[0,0,0,0],[9E9,60,9E9,9E9,9E9,9E9]];
CONST robtarget p_v:=[[0,150,200],[0,0.3826834,0.9238795,0],[0,0,0,0],[9E9,0,9E9,9E9,9E9,9E9]];
CONST robtarget p_3:=[[120,90,200],[0,0.7071068,0.7071068,0],[0,0,0,0],[9E9,-30,9E9,9E9,9E9,9E9]];
CONST robtarget p_4:=[[120,90,200],[0,0.7071068,0.7071068,0],[0,0,0,0],[9E9,10,9E9,9E9,9E9,9E9]];
CONST jointtarget j_back:=[[9E9,9E9,9E9,9E9,9E9,9E9],[9E9,0,9E9,9E9,9E9,9E9]];"""
BODY = r"""MoveJ p_1, v1000, fine, tool0 \WObj:=wobj_t; MoveL p_2, v200, z50, tool0 \WObj:=wobj_t;
MoveC p_v, p_3, v200, fine, tool0 \WObj:=wobj_t; MoveL p_4, v500, fine, tool0 \WObj:=wobj_t;
MoveExtJ j_back, vrot100, fine;"""


def program(body: str = BODY, scenario: Scenario = TABLE, data: str = DATA) -> Program:
    return rapid(r"ConfJ \Off; ConfL \Off; " + body, scenario, data)


PROGRAM = program()


@cache
def plan(target: Target) -> Plan:
    with pytest.MonkeyPatch.context() as patch:  # what leads to its end takes at most 42, the rest leads nowhere
        set_defaults(patch, most_iterations=45)
        coarse_search(patch)
        found = optimize(PROGRAM, PLANT, target)
    assert isinstance(found, Plan)
    return found


def on_table(rows: Trajectory, first: float, last: float) -> tuple[Array, Array, Array]:
    """Times, tool poses (n, 4, 4) on the table and its angles, by turning them back about the table's axis."""
    assert rows.tables is not None
    at = (rows.t >= first - 1e-12) & (rows.t <= last + 1e-12)
    theta, poses = rows.tables.q[at, 0], []
    for X, angle in zip(PLANT.robot.forward(rows.q[at]), theta, strict=True):
        turn = pin.SE3(pin.AngleAxis(-float(angle), np.array([0.0, 0, 1])).matrix(), np.zeros(3))
        table = turn * pin.SE3(np.eye(3), -CENTRE) * pin.SE3(X)
        poses.append(table.homogeneous)
    return rows.t[at], np.array(poses), theta


@pytest.mark.long
@pytest.mark.parametrize("target", Target)
def test_the_tool_draws_on_the_table_as_that_turns(target: Target) -> None:
    found = plan(target)
    assert found.lower_bound is not None
    assert found.lower_bound <= found.duration
    for motion, (p_0, p_1), (a, b) in (
        (1, ([-120, -90, 250], [-120, 90, 250]), (0, 60)),
        (3, ([120, 90, 250], [120, 90, 250]), (-30, 10)),
    ):
        t, X, theta = on_table(found.trajectory, found.motions[motion].t_0, found.motions[motion].t_1)
        share = (np.degrees(theta) - a) / (b - a)  # in step with it, from end to end
        assert share[[0, -1]] == pytest.approx([0, 1], abs=1e-9)
        wanted = np.array(p_0) + share[:, None] * (np.array(p_1) - np.array(p_0))
        np.testing.assert_allclose(X[:, :3, 3] * 1e3, wanted, atol=1e-6)
        speed = np.linalg.norm(np.diff(X[:, :3, 3], axis=0), axis=1) / np.diff(t)
        assert speed.max() < 0.2 * (1 + 1e-6)  # v200 over the work
    _, X, theta = on_table(found.trajectory, found.motions[2].t_0, found.motions[2].t_1)
    # the circle through (-120, 90), (0, 150), (120, 90)
    centre, radius = np.array([0.0, 0.0]), 150.0
    np.testing.assert_allclose(np.linalg.norm(X[:, :2, 3] * 1e3 - centre, axis=1), radius, atol=1e-6)
    phi = np.arctan2(X[:, 1, 3], X[:, 0, 3])
    share = (theta - theta[0]) / (theta[-1] - theta[0])
    np.testing.assert_allclose(phi, phi[0] + share * (phi[-1] - phi[0]), atol=1e-8)


@pytest.mark.long
@pytest.mark.parametrize("target", Target)
def test_the_table_keeps_its_limits_and_is_named_where_it_is_slowest(target: Target) -> None:
    found, tables = plan(target), plan(target).trajectory.tables
    assert tables is not None
    assert tables.qd is not None
    pull = np.abs(np.diff(tables.qd, axis=0)) / np.diff(found.trajectory.t)[:, None]
    assert 0.99 * A < pull.max() < A * (1 + 1e-9)
    assert np.abs(tables.qd).max() < V * (1 + 1e-9)
    turns = found.motions[3]  # p_3 to p_4 are one place on the work: the table is all that holds it up
    assert turns.binding == "positioner"
    assert turns.t_1 - turns.t_0 == pytest.approx(2 * np.sqrt(np.radians(40) / A), rel=1e-3)
    assert found.motions[1].t_1 - found.motions[1].t_0 < 1.5  # no slower than table and v200 ask for


def test_the_dense_check_sees_a_table_that_is_driven_too_fast_and_its_margins_are_tightened() -> None:
    """The last line is one place on the work, so the table alone times it: A to the middle and back. In half the time
    its speed is twice as high and its acceleration four times."""
    axes, problem, grid = Axes.of(PLANT), problem_of(PROGRAM, PLANT, Target.RAPID), np.linspace(0, 1, 9)
    leg = next(leg for leg in problem.legs if leg.motion == 3)
    assert leg.segment is not None
    rail = np.full((9, 1), 0.3), np.zeros((9, 1)), np.zeros((8, 1))
    way = np.radians(40)
    motion = PathLeg(2 * np.sqrt(way / A), leg.segment, leg.X_FT, 0, np.zeros(6), grid, *parabola(grid), *rail)
    for times, wanted in ((1.0, [np.sqrt(way * A) / V, 1.0]), (0.5, [2 * np.sqrt(way * A) / V, 4.0])):
        ratios = check_leg(axes, leg, motion.slowed(times))
        assert ratios.positioner.max(axis=0) == pytest.approx(wanted, rel=1e-3)
    margins = Margins.full(axes, motion.N, on_path=True)
    assert back_off(margins, ratios, motion, PLANT.settings)
    assert margins.positioner[0, 1] < 0.6 < 0.9 < margins.positioner[0, 0]  # at the end the table is hardly in motion


def judged(target: Target, spoil: Callable[[Trajectory], Trajectory] | None = None, of: Program = PROGRAM) -> Report:
    rows = plan(target).trajectory
    return verify(of, PLANT, rows if spoil is None else spoil(rows), target=target, advice=False)


def missed(report: Report) -> set[str]:
    return {one.check for one in report.findings if not one.passed}


@pytest.mark.parametrize("target", Target)
def test_the_judge_finds_it_legal_as_a_file_too(target: Target) -> None:
    assert missed(judged(target)) == set()
    rows, resolution = read_csv_text(write_csv_text(plan(target).trajectory), "a.csv")
    assert verify(PROGRAM, PLANT, rows, resolution, target=target, advice=False).legal
    coarse = resample(rows, 250.0)
    assert coarse.tables is not None
    assert verify(PROGRAM, PLANT, coarse, target=target, advice=False).legal


def with_table(spoil: Callable[[Array, Array], tuple[Array, Array]]) -> Callable[[Trajectory], Trajectory]:
    def spoiled(rows: Trajectory) -> Trajectory:
        assert rows.tables is not None
        assert rows.tables.qd is not None
        q, qd = spoil(rows.tables.q, rows.tables.qd)
        return replace(rows, tables=replace(rows.tables, q=q, qd=qd))

    return spoiled


def late(rows: Trajectory) -> Trajectory:
    """The table a millisecond behind the robot."""
    assert rows.tables is not None
    assert rows.tables.qd is not None
    t = rows.t - 1e-3
    q, qd = (np.interp(t, rows.t, x[:, 0])[:, None] for x in (rows.tables.q, rows.tables.qd))
    return replace(rows, tables=replace(rows.tables, q=q, qd=qd))


def ahead(rows: Trajectory) -> Trajectory:
    """During the last line, one place on the work, the table goes by another law than its share: the tool is off it."""
    assert rows.tables is not None
    t_0, t_1 = plan(Target.STREAM).motions[3].t_0, plan(Target.STREAM).motions[3].t_1
    u = np.clip((rows.t - t_0) / (t_1 - t_0), 0, 1)[:, None]
    return replace(rows, tables=replace(rows.tables, q=rows.tables.q + 1e-5 * np.sin(np.pi * u) ** 2))


@pytest.mark.parametrize(
    ("spoil", "check"),
    [
        (with_table(lambda q, qd: (-q, -qd)), "line position"),
        (late, "positioner along line"),
        (late, "line position"),
        (ahead, "line rotation"),
        (with_table(lambda q, qd: (q + 2e-6, qd)), "positioner position"),
        (with_table(lambda q, qd: (q * 1.00001, qd)), "positioner position"),
        (with_table(lambda q, qd: (q, qd * 1.01)), "positioner acceleration"),
    ],
    ids=["sign", "late", "late on its line", "ahead", "offset", "too far", "other speeds"],
)
def test_a_table_that_turns_otherwise_is_found(spoil: Callable[[Trajectory], Trajectory], check: str) -> None:
    assert check in missed(judged(Target.STREAM, spoil))


@pytest.mark.parametrize("limit", ["velocity", "acceleration"])
def test_a_table_beyond_its_limits_is_found(limit: str) -> None:
    weak = replace(PROGRAM, motions=tuple(
        replace(motion, units=tuple(unit._replace(**{limit: 0.9 * getattr(unit, limit)}) for unit in motion.units))
        if getattr(motion, "units", ()) else motion for motion in PROGRAM.motions))  # fmt: skip
    found = [one for one in judged(Target.STREAM, of=weak).findings if not one.passed]
    assert [one.check for one in found] == [f"positioner {'speed' if limit == 'velocity' else limit}"]
    assert "eax_b" in found[0].message


def test_a_tool_too_fast_over_the_work_is_found_whatever_it_does_in_the_world() -> None:
    slow = list(PROGRAM.motions)
    assert isinstance(slow[1], MoveL)
    slow[1] = replace(slow[1], speed=replace(slow[1].speed, v_tcp=0.19))
    found = [one for one in judged(Target.STREAM, of=replace(PROGRAM, motions=tuple(slow))).findings if not one.passed]
    assert [(one.check, one.subject) for one in found] == [("programmed speed", "TCP")]
    assert found[0].value == pytest.approx(0.2, rel=1e-3)


def test_files_say_where_the_table_is_or_are_refused() -> None:
    rows = plan(Target.STREAM).trajectory
    with pytest.raises(InputError, match=r"no column eax_b \[rad\], by which stn1 turns .* under MoveL p_2 \(t\.mod:5"):
        verify(PROGRAM, PLANT, replace(rows, tables=None))
    assert rows.tables is not None
    with pytest.raises(InputError, match="a column eax_c, by which no positioner of the program turns"):
        verify(PROGRAM, PLANT, replace(rows, tables=replace(rows.tables, names=("eax_c",))))
    text = write_csv_text(rows)
    heads = text.split("\n", 1)[0].split(",")
    assert heads[8] == "eax_b [rad]"
    assert heads[-1] == "eax_b speed [rad/s]"
    again, resolution = read_csv_text(text, "a.csv")
    assert again.names == rows.names
    assert again.tables is not None
    np.testing.assert_array_equal(again.tables.q, rows.tables.q)
    assert resolution.tables is not None
    assert resolution.q.shape[1] == len(rows.names)


def test_egm_has_the_table_in_degrees_in_its_place() -> None:
    rows = plan(Target.STREAM).trajectory
    assert rows.tables is not None
    stream = stream_of(Recorded("a plan", rows, ()), 250.0, 0)
    assert stream.units == ("deg",) * 6 + ("mm", "deg")
    assert stream.driven == ("eax_b", "eax_a")
    i = int(np.searchsorted(rows.t, 2.0))
    k = round(rows.t[i] * 250)
    np.testing.assert_allclose(stream.q[k, 7], np.degrees(np.interp(k / 250, rows.t, rows.tables.q[:, 0])), atol=1e-3)
    np.testing.assert_allclose(stream.q[k, 6], 1e3 * np.interp(k / 250, rows.t, rows.q[:, 0]), atol=1e-3)


@pytest.mark.long
def test_a_tool_that_stands_while_the_work_goes_by_is_planned_and_judged(monkeypatch: pytest.MonkeyPatch) -> None:
    """Round the table's axis as far as it turns: p_1 and p_2 are one place in the world, but not on the work."""
    data = DATA.replace("[[-120,90,200],[0,0,1,0]", "[[17.942286,-148.923048,200],[0,-0.5,0.8660254,0]")
    data = data.replace("[[0,150,200]", "[[-58.923048,-137.942286,200]").replace("[9E9,60,", "[9E9,-60,")
    found = program(r"MoveJ p_1, v1000, fine, tool0 \WObj:=wobj_t; MoveC p_v, p_2, v100, fine, tool0 \WObj:=wobj_t;"
                    r"MoveJ p_3, v1000, fine, tool0 \WObj:=wobj_t;", data=data)  # fmt: skip
    arc = found.motions[1]
    assert isinstance(arc, MoveC)
    np.testing.assert_allclose(arc.X_WT[:3, 3], found.motions[0].X_WT[:3, 3], atol=1e-6)  # type: ignore[union-attr]
    way = segment_of(arc, found.motions[0].X_WT)  # type: ignore[union-attr]
    assert way.length == pytest.approx(0.15 * np.pi / 3, rel=1e-5)
    coarse_search(monkeypatch)
    for target in Target:
        planned = optimize(found, PLANT, target, bounded=False)
        assert isinstance(planned, Plan)
        assert planned.motions[1].t_1 - planned.motions[1].t_0 > way.length / 0.1  # v100 over the work
        assert verify(found, PLANT, planned.trajectory, target=target, advice=False).legal
        spoiled = with_table(lambda q, qd: (1.001 * q, 1.001 * qd))(planned.trajectory)
        report = verify(found, PLANT, spoiled, target=target, advice=False)
        assert "arc position" in missed(report) or "arc rotation" in missed(report)


def test_a_tilting_table_turns_both_axes_in_step() -> None:
    both = (axis(1, (0.6, 0.5, 0.1), (np.pi / 2, 0, 0)), axis(2, (0, 0.05, 0), (-np.pi / 2, 0, 0)))
    data = """PERS wobjdata w:=[FALSE,FALSE,"Stn2",[[0,0,0],[1,0,0,0]],[[0,0,50],[1,0,0,0]]];
    CONST robtarget p_1:=[[-100,-60,150],[0,0,1,0],[0,0,0,0],[9E9,0,0,9E9,9E9,9E9]];
    CONST robtarget p_2:=[[-100,60,150],[0,0.1305262,0.9914449,0],[0,0,0,0],[9E9,15,-40,9E9,9E9,9E9]];"""
    found = program(r"MoveJ p_1, v1000, fine, tool0 \WObj:=w; MoveL p_2, v200, fine, tool0 \WObj:=w;",
                    Scenario(positioners={"stn2": both}), data)  # fmt: skip
    planned = optimize(found, PLANT, Target.RAPID, bounded=False)
    assert isinstance(planned, Plan)
    rows = planned.trajectory
    assert rows.tables is not None
    assert rows.tables.names == ("eax_b", "eax_c")
    assert verify(found, PLANT, rows, target=Target.RAPID, advice=False).legal
    one_late = rows.tables.q.copy()
    one_late[:, 1] = np.interp(rows.t - 1e-3, rows.t, one_late[:, 1])
    spoiled = replace(rows, tables=replace(rows.tables, q=one_late))
    assert "line position" in missed(verify(found, PLANT, spoiled, target=Target.RAPID, advice=False))


def test_the_shipped_seam_is_measured_on_the_work() -> None:
    from trajopt_cli.job import read_job
    from trajopt_cli.rapid.listing import describe

    job = read_job(Path(__file__).parents[2] / "programs" / "round_seam.mod")
    assert not [one for one in job.program.warnings if "arc" in one.text]
    rows = [row for row in describe(job.program).rows if row.kind == "MoveC"]
    assert [row.length for row in rows] == pytest.approx([120 * np.radians(160)] * 2, rel=1e-4)


def test_the_work_goes_round_under_a_tool_that_stands() -> None:
    """A line about the tool itself, there and back and there: one rest in the world, and each turn its own line. The
    targets are a rounding apart."""
    data = DATA + "CONST robtarget p_c:=[[0,0,200],[0,0,1,0],[0,0,0,0],[9E9,0,9E9,9E9,9E9,9E9]];"
    data += "CONST robtarget p_d:=[[0,0,200],[0,0.5,0.8660254,0],[0,0,0,0],[9E9,60,9E9,9E9,9E9,9E9]];"
    turn = r"MoveL p_d, v1000, fine, tool0 \WObj:=wobj_t; MoveL p_c, v1000, fine, tool0 \WObj:=wobj_t;"
    asked = program(rf"MoveJ p_c, v1000, fine, tool0 \WObj:=wobj_t; {turn} {turn}", data=data)
    plan = optimize(asked, PLANT, Target.RAPID, AS_WRITTEN, bounded=False)
    assert isinstance(plan, Plan)
    least = np.radians(60) / V + V / A
    assert [motion.t_1 - motion.t_0 for motion in plan.motions[1:]] == pytest.approx([least] * 4, rel=1e-3)
    for rows in (plan.trajectory, resample(plan.trajectory, 250.0), resample(plan.trajectory, 60.0)):
        report = verify(asked, PLANT, rows, target=Target.RAPID, advice=False)
        assert report.legal, [f.message for f in report.findings if not f.passed]
