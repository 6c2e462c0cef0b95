"""Bodies that ride on a positioner: where they stand, what planner and judge make of them while it turns.

Truth: the closed form of a turned box' corner, and pin and coal asked place by place.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import coal
import numpy as np
import pinocchio as pin
import pytest
from clear_of import with_capsules
from link_poses import link_poses
from unrefined import coarse_search

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.collision.collision_scene import CollisionScene, turned_into
from trajopt_cli.errors import InputError
from trajopt_cli.findings import CLEARANCE, TABLE_CLEARANCE, Finding
from trajopt_cli.geometry import Array, pose
from trajopt_cli.judge.clearance import check_clearance
from trajopt_cli.judge.scene import legs_of
from trajopt_cli.judge.verify import verify
from trajopt_cli.motion import MoveJ, Program, TextFile
from trajopt_cli.plan import optimize
from trajopt_cli.problem.collision_objects import bodies_on
from trajopt_cli.problem.editable import everything
from trajopt_cli.problem.plan import Infeasible, Plan, Target
from trajopt_cli.problem.plant import Plant, build_plant
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.scene import WORLD, plan_cycle, scene_of_plant
from trajopt_cli.shapes import Box, Capsule, Mesh, Solid
from trajopt_cli.trajectory import Trajectory

pytestmark = pytest.mark.usefixtures("coarse", "unrefined")

TABLE = "position: [0.55, 0.3, 0.1]"
LIMITS = 'range: "[-185, 185] deg", velocity: 90 deg/s, acceleration: 180 deg/s2, source: a test'
CELL = f"""robot: irb140
start: {{joints: "[0, 0, 0, 0, 30, 0] deg"}}
tool_radius: 0
positioners:
  STN1: {{eax: b, frame: {{{TABLE}}}, {LIMITS}}}
obstacles:
"""
FIN = "fin: {on: STN1, box: {size: [0.1, 0.04, 0.36], position: [0.25, 0, 0.18]}}"
"""A post 250 mm from the table's axis: beside the arm's way while the table is at 0, in it at -90 degrees."""
PASSING = FIN.replace("[0.25, 0,", "[0, -0.25,")


@pytest.fixture(autouse=True)
def _coarse_search(monkeypatch: pytest.MonkeyPatch) -> None:
    coarse_search(monkeypatch)


def cell_of(obstacles: str, cell: str = CELL, folder: Path = Path()) -> tuple[Plant, object]:
    lines = "".join(f"  {line}\n" for line in obstacles.splitlines())
    cell_ = parse_cell(cell + lines, str(folder / "c.yaml"))
    plant = build_plant(cell_)
    return replace(plant, robot=with_capsules(plant.robot)), cell_.scenario


def job(body: str, obstacles: str = FIN, cell: str = CELL) -> tuple[Plant, Program]:
    """A program whose targets stand at x = 550, y, z = 400 mm, the table at so many degrees."""
    plant, scenario = cell_of(obstacles, cell)
    targets = "".join(
        f"CONST robtarget p{name}:=[[550,{y},400],[0,0,1,0],[0,0,0,0],[9E9,{turn},9E9,9E9,9E9,9E9]];\n"
        for name, y, turn in (
            ("A", -150, 0),
            ("B", 100, 0),
            ("T", -150, -90),
            ("H", 100, -90),
            ("R", -150, 0),
            ("S", 100, 90),
        )
    )
    text = "MODULE T\n" + targets + f"PROC main()\nConfJ \\Off; ConfL \\Off;\n{body}\nENDPROC\nENDMODULE"
    return plant, run_program([TextFile("t.mod", text, "utf-8")], scenario)


def table(angle: float) -> Array:
    X = pin.SE3(pin.rpy.rpyToMatrix(0, 0, angle), np.array([0.55, 0.3, 0.1]))
    return np.asarray(X.homogeneous)


def planned(plant: Plant, program: Program, target: Target = Target.RAPID) -> Plan | Infeasible:
    return optimize(program, plant, target, changes=everything(program, plant), bounded=False)


def nearest(plant: Plant, program: Program, plan: Plan, name: str) -> Finding:
    report = verify(program, plant, plan.trajectory, target=Target.RAPID, advice=False)
    return next(one for one in report.findings if one.check == CLEARANCE and name in one.message)


def truth(plant: Plant, q: Array, theta: Array, name: str = "fin", start: float = 0.0) -> Array:
    """Least distance (m,) of the links from a box on the table, which starts at an angle, by pin and coal."""
    box = next(solid.loaded for solid in plant.obstacles if solid.name == name)
    assert isinstance(box, Box)
    geometry, X_TB = coal.Box(*box.size), np.linalg.inv(table(start)) @ box.X
    out = np.full(len(q), np.inf)
    for i, (X, angle) in enumerate(zip(link_poses(plant.robot, q), theta, strict=True)):
        X_WB = table(angle) @ X_TB
        for link, (capsule,) in plant.robot.bodies.items():
            assert isinstance(capsule, Capsule)
            a, b = (X[plant.robot.link_names.index(link)] @ np.r_[end, 1] for end in (capsule.a, capsule.b))
            along = (b - a)[:3]
            R = pin.Quaternion.FromTwoVectors(np.array([0, 0, 1.0]), along / np.linalg.norm(along)).matrix()
            shape = coal.Capsule(capsule.radius, float(np.linalg.norm(along)))
            result, request = coal.DistanceResult(), coal.DistanceRequest(False, 0.0, 0.0)
            request.enable_signed_distance = True
            places = coal.Transform3s(R, (a + b)[:3] / 2), coal.Transform3s(X_WB[:3, :3].copy(), X_WB[:3, 3].copy())
            out[i] = min(out[i], coal.distance(shape, places[0], geometry, places[1], request, result))
    return out


# ---------------------------------------------------------------------------------------------------- where they stand


def test_a_body_on_a_table_stands_where_the_table_has_it() -> None:
    """The corner of the post in closed form: behind a move that turns by -90 degrees, (x, y) has become (y, -x)."""
    plant, program = job("MoveJ pA,v1000,fine,tool0; MoveJ pT,v1000,fine,tool0; MoveJ pT,v500,fine,tool0;")
    corner = np.array([0.05, 0.02, 0.18, 1.0])
    (before,), (behind,) = bodies_on(plant, program, 0).standing, bodies_on(plant, program, 2).standing
    np.testing.assert_allclose((before.loaded.X @ corner)[:3], [0.55 + 0.30, 0.3 + 0.02, 0.46], atol=1e-12)
    np.testing.assert_allclose((behind.loaded.X @ corner)[:3], [0.55 + 0.02, 0.3 - 0.30, 0.46], atol=1e-9)
    (turned,) = bodies_on(plant, program, 1).turned
    assert bodies_on(plant, program, 1).standing == ()
    assert turned.solid.loaded is before.loaded


def test_a_body_on_the_first_of_two_axes_is_turned_by_that_alone() -> None:
    cell = CELL.replace(
        f"  STN1: {{eax: b, frame: {{{TABLE}}}, {LIMITS}}}",
        f"  STN1:\n    - {{eax: b, frame: {{{TABLE}}}, {LIMITS}}}\n"
        f"    - {{eax: c, frame: {{position: [0.2, 0, 0.1]}}, {LIMITS}}}",
    )
    boxes = "\n".join(f"{name}: {{on: {on}, box: {{size: [0.1, 0.1, 0.1], position: [0.1, 0, 0]}}}}"
                      for name, on in (("arm", "STN1.1"), ("plate", "STN1")))  # fmt: skip
    plant, _ = cell_of(boxes, cell)
    at = {("stn1", 1): np.pi / 2, ("stn1", 2): np.pi / 2}
    arm, plate = ((plant.stands(solid, at) @ solid.loaded.X)[:3, 3] for solid in plant.obstacles)
    np.testing.assert_allclose(arm, [0.55, 0.4, 0.1], atol=1e-12)
    np.testing.assert_allclose(plate, [0.55 - 0.1, 0.3 + 0.2, 0.2], atol=1e-12)


def test_a_mesh_keeps_its_surface_when_it_is_turned(tmp_path: Path) -> None:
    (tmp_path / "part.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
    plant, _ = cell_of("part: {on: STN1, mesh: {file: part.obj, scale: 0.1}}", folder=tmp_path)
    (solid,) = plant.obstacles
    assert isinstance(solid.shape, Mesh)
    np.testing.assert_allclose(solid.shape.X, table(0), atol=1e-12)


# ------------------------------------------------------------------------------------------------- planned and judged


def test_a_body_that_a_table_turns_into_the_way_is_hit_there_and_not_before() -> None:
    """At 0 the line is clear; with the post turned in by 90 degrees the same line is refused, and names it."""
    plant, clear = job("MoveJ pA,v1000,fine,tool0; MoveL pB,v500,fine,tool0; MoveL pA,v500,fine,tool0;")
    plan = planned(plant, clear)
    assert isinstance(plan, Plan)
    theta = np.zeros(len(plan.trajectory.t))
    assert nearest(plant, clear, plan, "fin").value == pytest.approx(
        truth(plant, plan.trajectory.q, theta).min(), abs=2e-3
    )
    _, hit = job("MoveJ pA,v1000,fine,tool0; MoveJ pT,v1000,fine,tool0; MoveL pH,v500,fine,tool0;")
    answer = planned(plant, hit)
    assert isinstance(answer, Infeasible)
    assert "pH" in answer.message
    assert "fin" in answer.message


@pytest.mark.long
def test_the_judge_sees_what_the_planner_was_not_told() -> None:
    """A plan made without the post, judged with it: refused at the line, as deep as pin and coal say."""
    plant, program = job("MoveJ pA,v1000,fine,tool0; MoveJ pT,v1000,fine,tool0; MoveL pH,v500,fine,tool0;")
    plan = planned(replace(plant, obstacles=()), program)
    assert isinstance(plan, Plan)
    found = nearest(plant, program, plan, "fin")
    assert not found.passed
    assert found.source is not None
    assert (found.source.line, found.source.column) == (10, 55)
    tables = plan.trajectory.tables
    assert tables is not None
    assert found.value == pytest.approx(truth(plant, plan.trajectory.q, tables.q[:, 0]).min(), abs=2e-3)


@pytest.mark.parametrize("target", [Target.RAPID, Target.STREAM])
def test_plans_keep_clear_of_what_turns_meanwhile(target: Target) -> None:
    """The tool draws back while the post comes round to where it was; every row is held against pin and coal."""
    plant, program = job("MoveJ pB,v1000,fine,tool0; MoveJ pT,v1000,fine,tool0; MoveJ pA,v1000,fine,tool0;")
    plan = planned(plant, program, target)
    assert isinstance(plan, Plan)
    tables = plan.trajectory.tables
    assert tables is not None
    least = truth(plant, plan.trajectory.q, tables.q[:, 0]).min()
    assert least > 0
    assert nearest(plant, program, plan, "fin").value == pytest.approx(least, abs=2e-3)


def test_a_table_that_is_switched_off_keeps_its_angle() -> None:
    """Behind DeactUnit the targets' 0 is ignored, so the post stays in the way."""
    body = "MoveJ pA,v1000,fine,tool0; MoveJ pT,v1000,fine,tool0;{off}\n"
    body += "MoveJ pR,v1000,fine,tool0; MoveL pB,v500,fine,tool0;"
    plant, on = job(body.format(off=""))
    assert isinstance(planned(plant, on), Plan)
    _, off = job(body.format(off="DeactUnit STN1;"))
    answer = planned(plant, off)
    assert isinstance(answer, Infeasible)
    assert "pB" in answer.message
    assert "fin" in answer.message


def test_two_tables_turn_their_own_bodies() -> None:
    """A second table on another axis, or on the same one: the post on the first table stays where that stands."""
    plain = "MoveJ pA,v1000,fine,tool0; MoveJ pT,v1000,fine,tool0; MoveL pH,v500,fine,tool0;"
    fins = FIN + "\n" + FIN.replace("fin:", "other:").replace("STN1", "STN2")
    for eax, switch, turned, answer in (
        ("c", "", "fin", Infeasible),
        ("b", "DeactUnit STN1; ActUnit STN2; ", "other", Plan),
    ):
        second = f"  STN2: {{eax: {eax}, frame: {{position: [-0.9, 0, 0.1]}}, {LIMITS}}}\nobstacles:\n"
        cell = CELL.replace("obstacles:\n", second).replace('deg"}', 'deg", units: [STN1]}' if switch else 'deg"}', 1)
        plant, program = job(switch + plain, fins, cell)
        during = bodies_on(plant, program, 1 + 2 * bool(switch))
        assert [one.solid.name for one in during.turned] == [turned]
        assert isinstance(planned(plant, program), answer)


TURNED_LATER = (
    "MoveJ pA,v1000,fine,tool0;\nWaitTime 0.2;\nMoveJ pB,v1000,fine,tool0;\nWaitTime 0.2;\n"
    "MoveJ pA,v1000,fine,tool0; MoveJ pT,v1000,fine,tool0; MoveJ pT,v500,fine,tool0;"
)


def left_on_the_table(body: str = TURNED_LATER) -> tuple[Plant, Program]:
    """A cube is taken at pA and set down on the plate at pB, which then turns."""
    return job(
        body,
        "plate: {on: STN1, box: {size: [0.5, 0.5, 0.02], position: [0, 0, 0.01]}}\n"
        "cube: {box: {size: [0.04, 0.04, 0.26], position: [0.55, -0.15, 0.25]}}",
        CELL.replace("obstacles:", "attach: [{part: cube, at: 10, detach: 12}]\nobstacles:"),
    )


def test_a_part_that_is_left_on_a_table_turns_with_it() -> None:
    """A cube is set down on the plate, which then turns by -90 degrees: its centre (dx, dy) has become (dy, -dx)."""
    plant, program = left_on_the_table()
    left, turned, then = (bodies_on(plant, program, i) for i in (4, 5, 6))
    places = {one.name: one.loaded.X[:3, 3] for one in left.standing}
    np.testing.assert_allclose(places["cube"], [0.55, 0.1, 0.25], atol=1e-9)
    assert {one.solid.name for one in turned.turned} == {"plate", "cube"}
    places = {one.name: one.loaded.X[:3, 3] for one in then.standing}
    np.testing.assert_allclose(places["cube"], [0.55 - 0.2, 0.3, 0.25], atol=1e-9)
    plan = planned(plant, program)
    assert isinstance(plan, Plan)
    assert nearest(plant, program, plan, "cube").passed


def test_the_judge_finds_a_part_where_the_table_has_brought_it() -> None:
    """Left at (550, 100), turned by -90 degrees to (350, 300), 380 mm high there; the flange comes down to 370."""
    body = "MoveJ pA,v1000,fine,tool0;\nWaitTime 0.2;\nMoveJ pB,v1000,fine,tool0;\nWaitTime 0.2;\n"
    body += "MoveJ pA,v1000,fine,tool0; MoveJ pT,v1000,fine,tool0; MoveJ Offs(pT,-200,450,-30),v500,fine,tool0;"
    plant, program = left_on_the_table(body)
    plan = planned(replace(plant, obstacles=(), grips=()), program)
    assert isinstance(plan, Plan)
    found = nearest(plant, program, plan, "cube")
    assert not found.passed
    assert found.source is not None
    assert (found.source.line, found.source.column) == (14, 55)
    assert -0.06 < found.value < -0.01


# ----------------------------------------------------------------------------------------------------- the questions


@pytest.mark.long
def test_ways_beside_a_turning_body_are_free_where_no_place_on_them_is_not() -> None:
    plant, program = job("MoveJ pA,v1000,fine,tool0; MoveJ pT,v1000,fine,tool0;")
    around, rng = CollisionScene(plant, program), np.random.default_rng(4)
    assert around.turning(1) == 1
    assert around.turning(0) == 0
    low, high = plant.limits.lower, plant.limits.upper
    q = rng.uniform(low, high, (8000, 6)) * [0.6, 1, 1, 1, 1, 1]
    q = q[around.free(q, 1)][:120]
    a, b = q[:60], q[:60] + rng.choice([0.1, 0.3, 0.6], (60, 1)) * (q[60:] - q[:60])
    share, seen = np.linspace(0, 1, 150), 0
    for start, end in zip(a, b, strict=True):
        way = start + share[:, None] * (end - start)
        found = around.ways_free(way[[0, -1]], np.array([0]), np.array([1]), 1, np.array([[0.0], [1.0]]))[0]
        alone = around.ways_free(way[[0, -1]], np.array([0]), np.array([1]), 1)[0]
        least = truth(plant, way, -np.pi / 2 * share).min() - 1e-4
        assert not found or (alone and least >= 0)
        assert found or not alone or least < 2e-3
        seen += alone and not found
    assert seen > 3


def test_a_body_that_passes_through_a_standing_arm_is_seen_by_planner_and_judge() -> None:
    """Half a turn between two rows, the arm at rest: only how far the table moves its body can tell. The post comes
    from (800, 300) to (300, 300) by (550, 50), where the arm is."""
    cell = CELL.replace("source: a test", "start: 90 deg, source: a test")
    plant, program = job("MoveJ pT,v1000,fine,tool0;", PASSING, cell)
    around, theta = CollisionScene(plant, program), np.pi * np.linspace(0.5, -0.5, 81)
    q = np.random.default_rng(7).uniform([-0.1, 0.4, -0.7, -0.1, 0.0, 0], [0.1, 1.0, 0.4, 0.1, 0.8, 0], (20, 6))
    near = np.array([truth(plant, np.tile(one, (81, 1)), theta, start=np.pi / 2) for one in q])
    some = (near[:, [0, -1]].min(axis=1) > 0.01) & (near.min(axis=1) < -0.01)
    q, least = q[some], near[some].min(axis=1)
    assert len(q) > 3
    ways, first = np.repeat(q, 2, axis=0), 2 * np.arange(len(q))
    assert around.ways_free(ways, first, first + 1, 0).all()  # it is left out
    assert not around.ways_free(ways, first, first + 1, 0, np.tile([[0.0], [1.0]], (len(q), 1))).any()
    rows, begin = np.repeat(q, 17, axis=0), 17 * np.arange(len(q))
    assert not around.free_beside(rows, begin, begin + 16, 0).any()
    for one, wanted in zip(q, least, strict=True):
        t, angle = np.array([0.0, 0.2, 1.0]), np.pi / 2 * np.array([[1.0], [0.8], [-1.0]])
        file = Trajectory(plant.limits.names, t, np.tile(one, (3, 1)), tables=Trajectory(("eax_b",), t, angle))
        found = next(f for f in check_clearance(program, plant, file, lambda _: None) if f.check == CLEARANCE)
        assert found.value == pytest.approx(wanted, abs=2e-3)


@pytest.mark.parametrize("searched", [True, False])
def test_a_post_that_passes_while_the_arm_moves_is_in_its_way(searched: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Both ends are clear. What a search overlooks is seen in the motion it has found, at its true times."""
    if not searched:
        monkeypatch.setattr(CollisionScene, "free_beside", lambda self, q, first, *_: np.ones(len(first), bool))
    cell = CELL.replace("source: a test", "start: 90 deg, source: a test")
    plant, program = job("MoveJ pS,v1000,fine,tool0; MoveJ pH,v1000,fine,tool0;", PASSING, cell)
    assert isinstance(planned(replace(plant, obstacles=()), program), Plan)
    answer = planned(plant, program)
    assert isinstance(answer, Infeasible)
    assert "pH" in answer.message
    assert searched or "fin" in answer.message


def test_gradients_beside_a_turning_body_are_those_of_differences() -> None:
    plant, program = job("MoveJ pA,v1000,fine,tool0; MoveJ pT,v1000,fine,tool0;")
    around, rng, h = CollisionScene(plant, program), np.random.default_rng(4), 1e-6
    q, turns = rng.uniform(plant.limits.lower, plant.limits.upper, (300, 6)), rng.uniform(0, 1, (300, 1))
    found = around.contacts(q, 1, 0.15, turns)
    off = []
    for row, pair, gradient in zip(found.row, found.pair, found.gradient, strict=True):
        if "fin" in (name := found.names[pair]):
            moved = q[row] + h * np.concatenate([np.eye(6), -np.eye(6)])
            beside = around.contacts(moved, 1, 0.2, np.tile(turns[row], (12, 1)))
            near = {(r, beside.names[p]): d for r, p, d in zip(beside.row, beside.pair, beside.distance, strict=True)}
            off.append(np.abs([(near[j, name] - near[6 + j, name]) / (2 * h) - gradient[j] for j in range(6)]).max())
    assert len(off) > 10
    assert np.quantile(off, 0.9) < 1e-4


# ------------------------------------------------------------------------------------------------------------ refused


@pytest.mark.parametrize(
    ("obstacles", "key"),
    [
        ("a: {on: STN9, box: {size: [1, 1, 1]}}", "obstacles.a.on"),
        ("a: {on: STN1.2, box: {size: [1, 1, 1]}}", "obstacles.a.on"),
        ("a: {on: STN1, fence: {points: [[0, 0], [1, 0]], height: 1}}", "obstacles.a.on"),
    ],
)
def test_what_carries_nothing_is_refused(obstacles: str, key: str) -> None:
    with pytest.raises(InputError) as error:
        cell_of(obstacles)
    assert key in str(error.value)
    assert error.value.line == 7


def test_a_file_without_the_table_s_column_is_refused() -> None:
    plant, program = job("MoveJ pA,v1000,fine,tool0; MoveJ pT,v1000,fine,tool0;")
    plan = planned(plant, program)
    assert isinstance(plan, Plan)
    with pytest.raises(InputError, match="eax_b"):
        verify(program, plant, replace(plan.trajectory, tables=None))


def test_the_page_has_a_part_on_the_table_from_when_it_is_left_there() -> None:
    """The rule of the page's script, followed here: where the cube ends is the closed form of the test above."""
    plant, program = left_on_the_table()
    plan = planned(plant, program)
    assert isinstance(plan, Plan)
    scene, cycle = scene_of_plant(plant, ["cube"]), plan_cycle("a", program, plan, plant)
    (table_,) = scene.tables
    (plate,) = (one for one in scene.bodies if one.shape.name == "plate")
    frame = len(scene.chain)
    assert plate.frame == frame
    stands, held, rides = (one for one in cycle.parts if one.shape.name == "cube")
    assert (stands.frame, held.frame, rides.frame) == (WORLD, scene.flange, frame)
    assert cycle.turned is not None
    np.testing.assert_allclose(cycle.turned[[0, -1], 0], [0, -np.pi / 2], atol=1e-9)
    assert isinstance(rides.shape, Box)
    X = table(-np.pi / 2) @ np.linalg.inv(table(0)) @ rides.shape.X
    np.testing.assert_allclose(X[:3, 3], [0.55 - 0.2, 0.3, 0.25], atol=1e-9)
    np.testing.assert_allclose(table_.X, table(0), atol=1e-12)


# ------------------------------------------------------------------------------------------- parts on turned tables

CUBE = "box: {size: [0.04, 0.04, 0.26], position: "
SET_DOWN_TURNED = "MoveJ pA,v1000,fine,tool0;\nWaitTime 0.2;\nMoveJ pH,v1000,fine,tool0;\nWaitTime 0.2;\n"


def carried_to(cube: str, at: int, detach: int, body: str) -> tuple[Plant, Program]:
    """A cube that the flange takes and leaves at the ends of the moves on two lines, beside a plate on the table."""
    plate = "plate: {on: STN1, box: {size: [0.5, 0.5, 0.024], position: [0, 0, 0.01]}}\n"
    attach = f"attach: [{{part: cube, at: {at}, detach: {detach}}}]\nobstacles:"
    return job(body, plate + cube, CELL.replace("obstacles:", attach))


def places_at_end(plant: Plant, program: Program) -> list[Array]:
    """Where planner and judge have the cube's middle in the world behind the last move, the table at 0 there."""
    planned_ = {one.name: one for one in bodies_on(plant, program, len(program.motions) - 1).standing}
    ends = [(i, move) for i, move in enumerate(program.motions) if isinstance(move, MoveJ)]
    visits = [SimpleNamespace(point=SimpleNamespace(index=-1), X_WF=plant.robot.forward(plant.start), depart=0)]
    visits += [SimpleNamespace(point=SimpleNamespace(index=i), X_WF=move.X_WT, depart=i + 1) for i, move in ends]
    n = len(program.motions) + 2
    legs = legs_of(program, plant, visits, n - 1)
    judged = {one.name: one for one in legs[-1].standing}
    # a part that stands 2 mm deep in its plate rides along: turning both is no hit
    t, theta = np.arange(n) * 1.0, np.zeros((n, 1))
    theta[-1] = 0.5
    rows = Trajectory(plant.limits.names, t, np.tile(plant.start, (n, 1)), tables=Trajectory(("eax_b",), t, theta))
    found = check_clearance(program, plant, rows, lambda _: None, legs)
    assert all(one.passed for one in found if one.check == TABLE_CLEARANCE)
    assert turned_into(plant, program) is None
    return [np.asarray(one["cube"].loaded.X[:3, 3]) for one in (planned_, judged)]


def test_a_part_that_is_left_on_a_turned_table_goes_with_it() -> None:
    """Left at (550, 100) with the table at -90 degrees, 200 mm before its axis; back at 0 that is 200 mm beside it."""
    back = "MoveJ pA,v1000,fine,tool0;\nMoveJ pB,v1000,fine,tool0;"
    plant, program = carried_to(f"cube: {{{CUBE}[0.55, -0.15, 0.25]}}}}", 10, 12, SET_DOWN_TURNED + back)
    for place in places_at_end(plant, program):
        np.testing.assert_allclose(place, [0.75, 0.3, 0.25], atol=1e-9)


def test_a_part_is_taken_from_where_a_turned_table_has_it() -> None:
    """At (200, 0) on the table, which has turned by -90 degrees: 100 mm in y in the world, 250 mm behind pA's."""
    body = "MoveJ pA,v1000,fine,tool0;\nMoveJ pH,v1000,fine,tool0;\nMoveJ pT,v1000,fine,tool0;\nWaitTime 0.2;\n"
    cube = f"cube: {{on: STN1, {CUBE}[0.2, 0, 0.15]}}}}"
    plant, program = carried_to(cube, 11, 12, body + "MoveJ pA,v1000,fine,tool0;\nMoveJ pB,v1000,fine,tool0;")
    for place in places_at_end(plant, program):
        np.testing.assert_allclose(place, [0.55, -0.15, 0.25], atol=1e-9)


# ----------------------------------------------------------------------------------- bodies on tables and all others

TURN = "MoveJ pA,v1000,fine,tool0; MoveJ pT,v1000,fine,tool0;"
POST = "post: {box: {size: [0.06, 0.06, 0.3], position: [0.727, 0.123, 0.25]}}"
"""In the middle of the fin's way from 0 to -90 degrees, 250 mm from the axis; where it begins and ends nothing is."""


def beside(plant: Plant, program: Program, angle: float = -np.pi / 2) -> list[Finding]:
    """What the judge says of the bodies alone, the arm at rest while the table turns."""
    t, theta = np.array([0.0, 1.0]), np.array([[0.0], [angle]])
    rows = Trajectory(plant.limits.names, t, np.tile(plant.start, (2, 1)), tables=Trajectory(("eax_b",), t, theta))
    source = program.motions[1].source
    return [
        f
        for f in check_clearance(program, plant, rows, lambda _: source)
        if f.check == TABLE_CLEARANCE and not f.passed
    ]


def test_a_table_that_turns_its_body_into_what_stands_is_refused() -> None:
    plant, program = job(TURN, f"{FIN}\n{POST}")
    answer = planned(plant, program)
    assert isinstance(answer, Infeasible)
    assert (answer.index, answer.source) == (1, program.motions[1].source)
    assert "fin" in answer.message
    assert "'post'" in answer.message
    (found,) = beside(plant, program)
    assert found.source == program.motions[1].source
    assert found.time == pytest.approx(0.36, abs=0.03)
    assert "fin" in found.message
    assert "'post'" in found.message
    X_TB, post = np.linalg.inv(table(0)) @ plant.obstacles[0].loaded.X, plant.obstacles[1].loaded
    least = np.inf
    for angle in np.linspace(0, -np.pi / 2, 2001):
        X = table(angle) @ X_TB
        request, result = coal.DistanceRequest(False, 0.0, 0.0), coal.DistanceResult()
        request.enable_signed_distance = True
        places = (coal.Transform3s(one[:3, :3].copy(), one[:3, 3].copy()) for one in (X, post.X))
        both = (coal.Box(0.1, 0.04, 0.36), next(places), coal.Box(0.06, 0.06, 0.3), next(places))
        least = min(least, coal.distance(*both, request, result))
    assert found.value == pytest.approx(least, abs=2e-4)
    assert f"{-least * 1e3:.1f} mm inside" in answer.message


@pytest.mark.parametrize(
    "others",
    [
        f"{FIN}\n{POST.replace('0.123', '0.477')}",  # at +45 degrees, where the fin does not come
        f"{FIN}\n{POST.replace('0.25]', '0.65]')}",  # above the fin
        f"{FIN}\n{POST.replace('box:', 'ignore: [fin], box:')}",
        f"{FIN}\npost: {{on: STN1, box: {{size: [0.06, 0.06, 0.3], position: [0.2, -0.1, 0.15]}}}}",
        f"{FIN}\nfoot: {{box: {{size: [0.5, 0.5, 0.1], position: [0.55, 0.3, 0.05]}}}}",  # the fin stands on it
    ],
)
def test_bodies_that_do_not_meet_ride_together_or_may_touch_are_no_hit(others: str) -> None:
    plant, program = job(TURN, others)
    assert turned_into(plant, program) is None
    assert beside(plant, program) == []


def test_bodies_on_two_tables_are_held_against_each_other() -> None:
    """The other table, 500 mm to the side, has a fin of its own that comes to the middle between both at 0."""
    second = f"  STN2: {{eax: c, frame: {{position: [0.55, -0.2, 0.1]}}, {LIMITS}}}\nobstacles:\n"
    fins = f"{FIN}\n{FIN.replace('fin:', 'other:').replace('STN1', 'STN2').replace('[0.25, 0,', '[0, 0.25,')}"
    plant, program = job(TURN, fins, CELL.replace("obstacles:\n", second))
    answer = turned_into(plant, program)
    assert answer is not None
    assert answer.index == 1
    assert "fin" in answer.message
    assert "'other'" in answer.message
    (found,) = beside(plant, program)
    assert {"fin", "other"} <= {*found.message.replace("'", "").split()}
    apart, program = job(TURN, fins.replace("[0, 0.25,", "[0, -0.25,"), CELL.replace("obstacles:\n", second))
    assert turned_into(apart, program) is None
    assert beside(apart, program) == []


def test_a_part_that_was_left_on_a_table_is_held_against_what_stands() -> None:
    """The cube goes from (550, 100) to (350, 300), 200 mm from the axis; the post is on that way."""
    plant, program = left_on_the_table()
    post = Box("post", np.array([0.05, 0.05, 0.3]), pose(np.eye(3), [0.41, 0.16, 0.25]))
    plant = replace(plant, obstacles=(*plant.obstacles, Solid(post)))
    answer = turned_into(plant, program)
    assert answer is not None
    assert answer.index == 5
    assert "cube" in answer.message
    assert "'post'" in answer.message


def test_only_bodies_of_the_cell_may_be_ignored() -> None:
    with pytest.raises(InputError, match="pots") as error:
        cell_of(f"{FIN.replace('{on', '{ignore: [pots], on')}\n{POST}")
    assert error.value.line == 7
