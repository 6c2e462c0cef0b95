"""Programs of an arm with a parallel linkage: read, planned within the limits of the controller's axes, judged."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from arms import abb_like, on_rail, urdf_joints
from small_cells import HOME

from trajopt_cli.collision.collision_scene import CollisionScene, links
from trajopt_cli.errors import InputError
from trajopt_cli.exporters.gltf import gltf
from trajopt_cli.geometry import Array, inverse_pose, pose
from trajopt_cli.judge.continuous_collision import Body, Near, Sweep
from trajopt_cli.judge.mechanism import Mechanism
from trajopt_cli.judge.verify import verify
from trajopt_cli.limits import CoupledRange, TcpCaps
from trajopt_cli.motion import MoveAbsJ, MoveL, Program, TextFile
from trajopt_cli.plan import optimize
from trajopt_cli.problem.configurations import check_configurations
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.programmed import PlantKinematics
from trajopt_cli.proximity.pair import Pair
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.shapes import Box, Capsule, Solid
from trajopt_cli.trajectory import Trajectory

pytestmark = pytest.mark.usefixtures("coarse")

A1, C1, C2, A2, C3, C4 = 0.1, 0.6, 0.7, -0.13, 0.75, 0.085
STAY = "MoveAbsJ [[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]], v500, fine, tool0;"
BARE = "[9E9,9E9,9E9,9E9,9E9,9E9]"


def linked(folder: Path, rail: bool = False) -> Plant:
    """An arm in ABB's directions, nothing asked of the tool."""
    route = replace(abb_like(A1, C1, C2, A2, C3, C4), linked=True)
    route.ranges[2] = (-1.1, 1.2)
    robot = (on_rail(route, "floor") if rail else route).load(folder)
    start = np.r_[[0.0] if rail else [], HOME]
    plant = Plant(robot, robot.profile(), TcpCaps(99.0, 999.0), start, (0,) if rail else (), False, True, frozenset())
    V, A = np.full(len(start), 2.5), np.full(len(start), 12.0)
    return replace(plant, limits=replace(plant.limits, velocity=V, acceleration=A, jerk=None))


def program(body: str, plant: Plant) -> Program:
    text = f"MODULE T\nPROC main()\nVAR robtarget p; VAR jointtarget j; VAR num x;\n{body}\nENDPROC\nENDMODULE"
    return run_program([TextFile("t.mod", text, "utf-8")], None, "main", PlantKinematics(plant))


def flat(*degrees: float) -> tuple[float, float]:
    """Where the flange is ahead and up [m], axes 1, 4 and 6 at 0: the upper arm points where axis 3 says."""
    a2, a3, a5 = np.radians(degrees)
    ahead = A1 + C2 * np.sin(a2) + C3 * np.cos(a3) - A2 * np.sin(a3) + C4 * np.cos(a3 + a5)
    return ahead, C1 + C2 * np.cos(a2) - C3 * np.sin(a3) - A2 * np.cos(a3) - C4 * np.sin(a3 + a5)


@pytest.mark.parametrize("rail", [False, True])
@pytest.mark.parametrize("axes", [(40, 0, 30), (40, 40, 20), (-20, 30, -50), (70, -5, 90)])
def test_functions_of_targets_take_and_give_the_controllers_axes(tmp_path, axes, rail) -> None:
    plant = linked(tmp_path, rail)
    eax = "[0,9E9,9E9,9E9,9E9,9E9]" if rail else BARE
    a2, a3, a5 = axes
    joints = f"[[0,{a2},{a3},0,{a5},0],{eax}]"
    found = program(
        f"MoveAbsJ {joints}, v500, fine, tool0;\np:=CRobT();\nMoveL p, v100, fine, tool0;\n"
        f"p:=CalcRobT({joints}, tool0);\nMoveL p, v100, fine, tool0;\nj:=CJointT();\nMoveAbsJ j, v100, fine, tool0;\n"
        "j:=CalcJointT(p, tool0);\nMoveAbsJ j, v100, fine, tool0;\n"
        "MoveL Offs(p,0,0,0), v100, fine, tool0;\nx:=CPos().x;\nMoveL Offs(p,x,0,0), v100, fine, tool0;",
        plant,
    ).motions
    ahead, up = flat(*axes)
    for motion in found[:5]:
        if isinstance(motion, MoveAbsJ):
            np.testing.assert_allclose(np.degrees(motion.q), [0, a2, a3, 0, a5, 0], rtol=0, atol=1e-3)
        else:
            assert isinstance(motion, MoveL)
            np.testing.assert_allclose(motion.X_WT[:3, 3], [ahead, 0, up], rtol=0, atol=1e-6)
            assert motion.conf.cfx == np.floor(a2 / 90)
    assert isinstance(found[6], MoveL)
    np.testing.assert_allclose(found[6].X_WT[0, 3], 2 * ahead, rtol=0, atol=1e-6)


def planned(program: Program, plant: Plant, target: Target = Target.STREAM) -> Plan:
    plan = optimize(program, plant, target, bounded=False)
    assert isinstance(plan, Plan), plan
    return plan


def offences(program: Program, plant: Plant, rows: Trajectory, target: Target | None = None) -> list[str]:
    report = verify(program, plant, rows, target=target, advice=False)
    return [f"{f.check} {f.subject}" for f in report.findings if not f.passed]


@pytest.mark.parametrize("goal", [(40, 0), (40, 40), (30, -40), (0, -40)])
def test_speed_and_acceleration_are_those_of_the_controllers_axes(tmp_path, goal) -> None:
    """From rest to rest the axis that goes farthest takes least time at its own limits, whatever the URDF's joint does:
    it stands as both turn alike, and turns by 70 degrees where they turn apart."""
    plant = linked(tmp_path)
    moves = program(f"MoveAbsJ [[0,{goal[0]},{goal[1]},0,30,0],{BARE}], v500, fine, tool0;", plant)
    way = np.radians(max(map(abs, goal)))
    for target in (Target.STREAM, Target.RAPID):
        plan = planned(moves, plant, target)
        assert plan.duration == pytest.approx(way / 2.5 + 2.5 / 12, rel=2e-3)
        assert offences(moves, plant, plan.trajectory, target) == []
        np.testing.assert_allclose(np.degrees(plan.trajectory.q[-1]), [0, *goal, 0, 30, 0], atol=1e-6)


def test_lines_and_arcs_are_planned_and_the_judge_holds_them_by_its_own_route(tmp_path) -> None:
    plant = replace(linked(tmp_path), free_speed=False)
    moves = program(
        "MoveAbsJ [[10,20,10,0,40,0],[9E9,9E9,9E9,9E9,9E9,9E9]], v2500, fine, tool0;\np:=CRobT();\n"
        "MoveL Offs(p,0,150,-100), v500, z10, tool0;\n"
        "MoveC Offs(p,80,200,-100), Offs(p,0,250,-100), v500, fine, tool0;",
        plant,
    )
    plan = planned(moves, plant)
    assert offences(moves, plant, plan.trajectory) == []
    rows = plan.trajectory
    as_urdf = replace(rows, q=urdf_joints(plant.robot, rows.q), qd=urdf_joints(plant.robot, rows.qd))
    assert offences(moves, plant, as_urdf)  # the file's joint_3 is axis 3


def test_a_plan_that_may_choose_does_not_fold_the_upper_arm_past_the_lower_one(tmp_path) -> None:
    """From joints that are folded, as the file gives no range of the angle between the arms, to a pose beside them."""
    plant = linked(tmp_path)
    folded = np.radians([0, 100, -20, 0, 30, 0])
    X = plant.robot.forward(folded + np.radians([0, -2, 1, 0, 0, 0]))
    place = ",".join(f"{value * 1000:.4f}" for value in X[:3, 3])
    moves = program(f"ConfJ \\Off;\nMoveJ [[{place}],[0.5,0,0.8660254,0],[0,0,0,0],{BARE}], v500, fine, tool0;", plant)
    plan = planned(moves, replace(plant, start=folded))
    end = plan.trajectory.q[-1]
    np.testing.assert_allclose(plant.robot.forward(end)[:3, 3], X[:3, 3], atol=1e-6)
    assert np.cos(urdf_joints(plant.robot, end)[2]) > 0
    assert any("angle between the arms" in line for line in plant.unchecked)
    between = CoupledRange(("joint_3", "joint_2"), (1.0, -1.0), -1.4, 1.5)
    told = replace(plant, limits=replace(plant.limits, coupled=(between,))).unchecked
    assert not any("angle between the arms" in line for line in told)


def test_targets_fit_by_the_quadrants_of_axes_1_4_and_6(tmp_path) -> None:
    """Whatever cfx says; of those that do not fit, what is offered instead is had by unfolded joints."""
    plant, rng, offered = linked(tmp_path), np.random.default_rng(6), 0
    for a1, a2, a3, a4, a5, a6 in rng.uniform([-90, -60, -50, -170, 10, -200], [90, 50, 50, 170, 100, 200], (12, 6)):
        joints = f"[[{a1},{a2},{a3},{a4},{a5},{a6}],{BARE}]"
        start = f"MoveAbsJ {joints}, v500, fine, tool0;\np:=CRobT();\n"
        for change in ("", "p.robconf.cfx:=3;", "p.robconf.cfx:=-1;"):
            assert not check_configurations(program(f"{start}{change}MoveJ p, v500, fine, tool0;", plant), plant)
        (wrong,) = check_configurations(program(f"{start}p.robconf.cf1:=5;MoveJ p, v500, fine, tool0;", plant), plant)
        X = plant.robot.forward(np.radians([a1, a2, a3, a4, a5, a6]))
        every = [q for _, q in plant.robot.solutions(X, None, plant.limits)]
        unfolded = [q for q in every if np.cos(urdf_joints(plant.robot, q)[2]) > 0]
        assert {*wrong.reachable} == {plant.robot.confdata(q) for q in unfolded}
        offered += len(wrong.reachable)
    assert offered > 30


def test_torque_limits_are_refused_for_want_of_the_levers(tmp_path) -> None:
    from trajopt_cli.cell.loader import parse_cell
    from trajopt_cli.problem.plant import build_plant

    linked(tmp_path)
    text = 'robot: arm.yaml\nstart: {joints: "[0, 0, 0, 0, 30, 0] deg"}\ntorque_limits: true\n'
    (tmp_path / "cell.yaml").write_text(text)
    with pytest.raises(InputError, match="parallel linkage") as error:
        build_plant(parse_cell(text, str(tmp_path / "cell.yaml")))
    assert error.value.line == 3


# ------------------------------------------------------------------------------------------------------------- bodies

LOWER, UPPER = (
    Capsule("link_2", np.zeros(3), np.array([0, 0, 0.6]), 0.08),
    Capsule("link_4", np.zeros(3), np.array([0.7, 0, 0]), 0.05),
)


def with_bodies(folder: Path) -> Plant:
    plant = linked(folder)
    robot = replace(plant.robot, bodies={"link_2": (LOWER,), "link_4": (UPPER,)}, self_pairs=(("link_2", "link_4"),))
    post = Solid(Box("post", np.array([0.1, 0.1, 1.0]), pose(np.eye(3), [1.2, 0.5, 0.5])))
    return replace(plant, robot=robot, obstacles=(post,))


def postures(count: int) -> Array:
    rng = np.random.default_rng(4)
    return rng.uniform([-1, -0.6, -1, -1, -1, -1], [1, 1.4, 1, 1, 1, 1], (count, 6))


def test_links_of_planner_and_drawings_stand_where_pin_has_them(tmp_path) -> None:
    robot, q = linked(tmp_path).robot, postures(5)
    wanted, axes = Mechanism(robot.urdf, robot.X_WR).links(urdf_joints(robot, q))
    np.testing.assert_allclose(links(robot, q), wanted, rtol=0, atol=1e-12)
    found = Mechanism(robot.urdf, robot.X_WR, robot.linkage).links(q)
    np.testing.assert_allclose(found[0], wanted, rtol=0, atol=1e-15)
    np.testing.assert_allclose(found[1], axes, rtol=0, atol=1e-15)


def test_distances_change_with_the_axes_as_their_gradients_say(tmp_path) -> None:
    plant = with_bodies(tmp_path)
    around, q = (
        CollisionScene(plant, program(STAY, plant)),
        postures(20),
    )
    at = around.contacts(q, 0, 5.0)
    assert {at.names[number] for number in at.pair} == {"link_2|post", "link_4|post", "link_4|link_2"}
    step = 1e-6
    for axis in range(6):
        shift = step * np.eye(6)[axis]
        ahead, behind = (around.contacts(q + s * shift, 0, 5.0) for s in (1, -1))
        rate = (ahead.distance - behind.distance) / (2 * step)
        np.testing.assert_allclose(at.gradient[:, axis], rate, rtol=0, atol=2e-4)


def test_a_way_that_axis_2_alone_turns_into_a_touch_is_not_free(tmp_path) -> None:
    """The lower arm's foot meets the upper arm, which keeps its direction, as axis 2 passes -90 degrees."""
    plant = with_bodies(tmp_path)
    foot = Capsule("link_2", np.zeros(3), np.zeros(3), 0.1)
    robot = replace(plant.robot, bodies={"link_2": (foot,), "link_4": (UPPER,)})
    around = CollisionScene(replace(plant, robot=robot, obstacles=()), program(STAY, plant))
    ends = np.radians([[0, 0, 0, 0, 0, 0], [0, -175, 0, 0, 0, 0]])
    assert around.free(ends, 0).all()
    assert not around.free_between(ends[:1], ends[1:], 0)[0]


@pytest.mark.parametrize("against", ["foot", "lower arm", "post"])
def test_the_judge_sweeps_what_the_linkage_moves(tmp_path, against) -> None:
    """Against poses of pin's route close to one another; from one row to the next, of axis 2 alone past the foot."""
    plant = with_bodies(tmp_path)
    robot, post = plant.robot, plant.obstacles[0].shape
    other = {"foot": Capsule("link_2", np.zeros(3), np.zeros(3), 0.1), "lower arm": LOWER}.get(against)
    goal = np.radians([0, -175, 0, 0, 0, 0] if against == "foot" else [30, -120, 20, 10, 0, 0])
    upper = Body("link_4", UPPER, 4)
    near = Near(upper, post) if other is None else Near(upper, None, Body("link_2", other, 2))
    rows = Trajectory(robot.axis_names, np.array([0.0, 1.0]), np.outer([0.0, 1.0], goal))
    found = Sweep(Mechanism(robot.urdf, robot.X_WR, robot.linkage), rows).least([near])
    dense = np.outer(np.linspace(0, 1, 4001), goal)
    X = Mechanism(robot.urdf, robot.X_WR).links(urdf_joints(robot, dense))[0]
    base = np.eye(4) if other is None else inverse_pose(X[:, 2])
    wanted = Pair(UPPER, post if other is None else other).distances(base @ X[:, 4]).min()
    assert found.proven
    assert found.distance == pytest.approx(wanted, abs=2e-4 + 0.01 * abs(wanted))


def test_a_drawing_has_the_urdfs_joints(tmp_path) -> None:
    pygltflib = pytest.importorskip("pygltflib")
    plant, q = linked(tmp_path), postures(1)
    rows = Trajectory(plant.robot.axis_names, np.array([0.0, 1.0]), np.repeat(q, 2, axis=0))
    nodes = {node.name: node for node in pygltflib.GLTF2.load_from_bytes(gltf(rows, plant, "arm")).nodes}
    bend = np.array(nodes["link_3"].rotation)
    angle = urdf_joints(plant.robot, q)[0, 2]
    np.testing.assert_allclose(bend, [0, np.sin(angle / 2), 0, np.cos(angle / 2)], rtol=0, atol=1e-6)
