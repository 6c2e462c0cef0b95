"""MuJoCo's arm against the truth and pin, its servo, and its contacts against the law they are to follow."""

import numpy as np
import pinocchio
import pytest

from trajopt_cli.geometry import pose
from trajopt_cli.iiwa.task.model import Contact, Obstacle
from trajopt_cli.iiwa.world.contact import FRICTION_RISE, BallOnBoxes
from trajopt_cli.iiwa.world.mujoco_world import SERVO_DELAY, SERVO_STIFFNESS, MujocoWorld
from trajopt_cli.iiwa.world.worlds import Engine, SpringWorld, make_world
from trajopt_cli.robot.dynamics import Dynamics, ToolLoad
from trajopt_cli.shapes import Box

mujoco = pytest.importorskip("mujoco")
H = 1e-3
START = (0.0, *np.radians([30.0, 0.0, -100.0, 0.0, 50.0, 0.0]).tolist())


def wait(world, q, periods):
    for _ in range(periods):
        measured = world.step(q)
    return measured


def lossless(model):
    model.dof_damping[:] = model.dof_frictionloss[:] = 0.0


def inverse(world, q, qd, qdd):
    lossless(world.model)
    data = mujoco.MjData(world.model)
    data.qpos[:], data.qvel[:], data.qacc[:] = q, qd, qdd
    mujoco.mj_inverse(world.model, data)
    return np.array(data.qfrc_inverse)


def test_torques_are_the_truths(iiwa7, X_FT, truth):
    world = MujocoWorld(iiwa7, X_FT, None, None, H)
    cases = truth("iiwa7_rnea.json")
    assert len(cases) == 25
    for case in cases:
        np.testing.assert_allclose(inverse(world, *(case[k] for k in ("q", "qd", "qdd"))), case["tau"], atol=1e-9)


def test_torques_with_a_load_on_an_arm_hung_askew_are_pins(crooked, X_FT, load):
    world, dynamics = MujocoWorld(crooked, X_FT, load, None, H), Dynamics(crooked, load)
    rng = np.random.default_rng(3)
    for _ in range(10):
        state = rng.uniform(-1.5, 1.5, (3, 7))  # within the joints' ranges, whose end stops would push
        np.testing.assert_allclose(inverse(world, *state), dynamics.torque(*state), rtol=0, atol=1e-9)


def test_the_tool_is_where_our_forward_kinematics_has_it(crooked, X_FT):
    world = MujocoWorld(crooked, X_FT, None, None, H)
    data = mujoco.MjData(world.model)
    for q in np.random.default_rng(5).uniform(-2, 2, (20, 7)):
        data.qpos[:] = q
        mujoco.mj_forward(world.model, data)
        X = pose(data.site("tcp").xmat.reshape(3, 3), data.site("tcp").xpos)
        np.testing.assert_allclose(X, crooked.forward(q) @ X_FT, rtol=0, atol=1e-9)


def test_it_stands_still_under_gravity(crooked, X_FT, load):
    world = MujocoWorld(crooked, X_FT, load, None, H)
    for measured in (world.reset(START), wait(world, START, 500)):
        np.testing.assert_allclose(measured.q, START, rtol=0, atol=1e-9)
        np.testing.assert_allclose(measured.qd, 0, rtol=0, atol=1e-8)
        np.testing.assert_allclose(
            measured.tau, Dynamics(crooked, load).gravity_torque(np.array(START)), rtol=0, atol=1e-6
        )
        assert measured.contact == (0.0,) * 6
        assert measured.depth == 0.0


def test_it_follows_a_moving_command_by_the_servos_delay_and_its_torques_move_rigid_bodies(iiwa7, X_FT, load):
    world, dynamics = MujocoWorld(iiwa7, X_FT, load, None, H), Dynamics(iiwa7, load)
    world.reset(START)
    rate = 3.0

    def wanted(t):
        return np.array(START) + 0.1 * (1 - np.cos(rate * t)) * np.array([1, 1, -1, 1, 1, -1, 1])

    worst = 0.0
    for k in range(1, 800):
        measured = world.step(tuple(wanted(k * H)))
        # a command holds for its period: half of one later than a course through the commands
        late = wanted(k * H + H - SERVO_DELAY - H / 2) if k > 50 else np.array(measured.q)
        worst = max(worst, float(np.abs(measured.q - late).max()))
        if k % 250 == 0:
            state = (np.array(row) for row in (measured.q, measured.qd, measured.qdd))
            np.testing.assert_allclose(measured.tau, dynamics.torque(*state), rtol=0, atol=1e-6)
    # 0.3 rad/s: 1.5 mrad behind, that within 2 %, and what friction and damping wind the servo's spring up by
    wound = (iiwa7.friction + 0.3 * iiwa7.damping) / (SERVO_STIFFNESS * iiwa7.torque)
    assert worst < 0.02 * 0.3 * SERVO_DELAY + wound.max()


@pytest.mark.parametrize("stiffness", [3e3, 3e4, 3e5])
def test_a_static_press_is_stiffness_times_depth_and_the_motors_bear_it(smooth, X_FT, load, floor, stiffness):
    world = MujocoWorld(smooth, X_FT, load, floor(0.002, stiffness, 200.0), H)
    world.reset(START)
    measured = wait(world, START, 1100)
    F = np.array(measured.contact)
    assert F[2] == pytest.approx(stiffness * measured.depth, rel=1e-6)
    q = np.array(measured.q)
    borne = Dynamics(smooth, load).gravity_torque(q) - measured.tau
    np.testing.assert_allclose(borne, smooth.jacobian(q, X_FT).T @ F, rtol=0, atol=1e-5)
    # the arm gives way like a spring behind the wall's: between 20 and 200 kN/m here
    give = 0.002 - measured.depth
    assert 2e4 < F[2] / give < 2e5


def test_a_soft_press_is_the_spring_worlds(iiwa7, X_FT, load, floor):
    """Soft against the arm's own give: 1 kN/m, 5 mm deep."""
    contact = floor(0.005, 1e3, 100.0)
    here = SpringWorld(iiwa7, X_FT, load, contact, H).reset(START)
    world = make_world(Engine.MUJOCO, iiwa7, X_FT, load, contact, H)
    world.reset(START)
    there = wait(world, START, 700)
    assert there.contact[2] == pytest.approx(here.contact[2], rel=0.04)
    np.testing.assert_allclose(there.tau, here.tau, rtol=0, atol=0.5)


def test_sliding_rubs_as_the_spring_world_does(iiwa7, X_FT, load, floor, ball_at):
    contact = floor(0.004, 5e3, 50.0, 0.3)
    worlds = [make_world(engine, iiwa7, X_FT, load, contact, H) for engine in Engine]
    p = (iiwa7.forward(np.array(START)) @ X_FT)[:3, 3]
    for world in worlds:
        world.reset(START)
        wait(world, START, 300)
    q = START
    for k in range(1, 301):
        q = ball_at(p + np.array([0.0, 0.1 * k * H, 0.0]), q, steps=2)  # 0.1 m/s along y
        spring, physics = (world.step(q) for world in worlds)
        for measured in (spring, physics):
            x, y, z = measured.contact[:3]
            assert z > 0
            assert np.hypot(x, y) <= 0.3 * z * (1 + 1e-6)
    assert spring.contact[1] == pytest.approx(-0.3 * spring.contact[2], rel=1e-6)
    for one, other in zip(spring.contact, physics.contact, strict=True):
        assert other == pytest.approx(one, rel=0.15, abs=0.05)  # the arm gives way
    # held against the law at MuJoCo's own state: what convex friction lifts is under 1 %
    q, qd = np.array(physics.q), np.array(physics.qd)
    twist = iiwa7.jacobian(q, X_FT) @ qd
    law = BallOnBoxes(contact).touch(tuple((iiwa7.forward(q) @ X_FT)[:3, 3]), tuple(twist[:3]), tuple(twist[3:]))
    np.testing.assert_allclose(physics.contact, law.force, rtol=0, atol=0.01 * law.force[2])
    assert physics.depth == pytest.approx(law.depth, abs=1e-12)


@pytest.mark.parametrize("order", [1, -1])
def test_boxes_add_up_and_a_centre_inside_is_pushed_out_of_the_nearest_face(smooth, X_FT, load, order):
    x, y, z = (smooth.forward(np.array(START)) @ X_FT)[:3, 3]
    tip = 0.02
    floor = Box("floor", np.array([0.5, 0.5, 0.2]), pose(np.eye(3), [x, y, z - 0.1 - tip + 0.001]))
    # low enough for the last link to pass above it
    block = Box("block", np.array([0.3, 0.3, 0.1]), pose(np.eye(3), [x, y + 0.15 - 0.003, z + 0.03]))
    contact = Contact((Obstacle(floor, 5e3, 50.0, 0.0), Obstacle(block, 1e3, 50.0, 0.0))[::order], tip)
    world = MujocoWorld(smooth, X_FT, load, contact, H)
    world.reset(START)
    measured = wait(world, START, 700)
    q = np.array(measured.q)
    still = (0.0, 0.0, 0.0)
    law = BallOnBoxes(contact).touch(tuple((smooth.forward(q) @ X_FT)[:3, 3]), still, still)
    assert law.force[1] < -20
    assert law.force[2] > 4
    np.testing.assert_allclose(measured.contact, law.force, rtol=0, atol=1e-4)
    assert measured.depth == pytest.approx(law.depth, abs=1e-9)


@pytest.mark.parametrize("speed", [-0.3, 0.05, 0.2])
def test_an_approach_is_damped_and_leaving_does_not_pull(iiwa7, X_FT, load, floor, speed):
    """20 N of spring at 1 mm, 200 N s/m of damper, at one instant."""
    contact = floor(0.001, 2e4, 200.0)
    world = MujocoWorld(iiwa7, X_FT, load, contact, H)
    world.reset(START)
    qd = np.linalg.pinv(iiwa7.jacobian(np.array(START), X_FT)) @ [0.0, 0.0, speed, 0.0, 0.0, 0.0]
    world.model.actuator_biasprm[:] = 0.0  # motors off
    data = mujoco.MjData(world.model)
    data.qpos[:], data.qvel[:] = START, qd
    mujoco.mj_forward(world.model, data)
    force = np.zeros(6)
    mujoco.mj_contactForce(world.model, data, 0, force)
    # beside the contact's small inertia times what the free arm accelerates with
    assert force[0] == pytest.approx(max(0.0, 20.0 - 200.0 * speed), abs=0.02)


def test_a_fall_onto_the_floor_never_gains_energy(smooth, X_FT, load, floor):
    """A frictionless spring without damper, motors off: what leaves it is what went in."""
    world = MujocoWorld(smooth, X_FT, load, floor(-0.02, 2e4, 0.0, 0.0), H)
    world.reset(START)
    model, data = world.model, mujoco.MjData(world.model)
    model.actuator_biasprm[:], model.actuator_gainprm[:] = 0.0, 0.0
    data.qpos[:] = START
    dynamics = Dynamics(smooth, load)
    low, drop, start = 0.0, [], None
    for k in range(round(0.15 / model.opt.timestep)):
        mujoco.mj_step(model, data)
        if k % 5 == 0:
            mujoco.mj_forward(model, data)
            q, qd = np.array(data.qpos), np.array(data.qvel)
            depth = -data.contact[0].dist if data.ncon else 0.0
            low = max(low, depth)
            kinetic = qd @ (dynamics.torque(q, np.zeros(7), qd) - dynamics.gravity_torque(q)) / 2  # M qd, without M
            potential = -sum(model.body_mass[i] * model.opt.gravity @ data.xipos[i] for i in range(model.nbody))
            energy = kinetic + potential + 2e4 * depth**2 / 2
            start = energy if start is None else start
            drop.append(energy - start)
    assert low > 0.01
    assert depth == 0  # and off again
    assert np.abs(drop).max() < 5e-4


def test_equal_commands_give_equal_measurements_after_a_reset_too(iiwa7, X_FT, load, floor):
    contact = floor(0.001)
    rows = []
    worlds = [MujocoWorld(iiwa7, X_FT, load, contact, H) for _ in range(2)]
    for world in (*worlds, worlds[0]):
        first = world.reset(START)
        rows.append([first] + [world.step(tuple(np.array(START) + 1e-4 * k)) for k in range(30)])
    assert rows[0] == rows[1] == rows[2]
    assert rows[0][-1].contact[2] > 0


def test_names_and_starts(iiwa7, X_FT, floor):
    world = MujocoWorld(iiwa7, X_FT, None, floor(0.001), H)
    assert world.name == f"MuJoCo {mujoco.__version__}"


def test_friction_creeps_under_coulombs_bound_with_the_laws_rise(iiwa7, X_FT, load, floor):
    """A slow tip: MuJoCo's friction is the law's viscous rise, but for the small inertia it adds."""
    world = MujocoWorld(iiwa7, X_FT, load, floor(0.002, 1e4, 50.0, 0.5), H)
    world.reset(START)
    wait(world, START, 500)
    for k in range(1, 401):
        measured = world.step((1e-6 * k, *START[1:]))  # the base turns at 1 mrad/s
    q, qd = np.array(measured.q), np.array(measured.qd)
    twist = iiwa7.jacobian(q, X_FT) @ qd
    v = twist[1] + np.cross(twist[3:], [0.0, 0.0, -(0.02 - measured.depth / 2)])[1]
    assert 1e-4 < v < 1e-3
    assert measured.contact[1] == pytest.approx(-FRICTION_RISE * v, rel=0.02)


def test_a_free_fall_keeps_its_energy(iiwa7, X_FT, load):
    """Without motors, friction and damping: kinetic energy by pin, heights by MuJoCo's bodies."""
    world = MujocoWorld(iiwa7, X_FT, load, None, H)
    world.reset(START)
    model, data, dynamics = world.model, mujoco.MjData(world.model), Dynamics(iiwa7, load)
    lossless(model)
    model.actuator_biasprm[:], model.actuator_gainprm[:], model.jnt_limited[:] = 0.0, 0.0, False
    data.qpos[:] = START
    energies, fastest = [], 0.0
    for k in range(round(0.8 / model.opt.timestep)):
        mujoco.mj_step(model, data)
        if k % 100 == 0:
            mujoco.mj_forward(model, data)
            q, qd = np.array(data.qpos), np.array(data.qvel)
            kinetic = qd @ (dynamics.torque(q, np.zeros(7), qd) - dynamics.gravity_torque(q)) / 2
            energies.append(kinetic - sum(model.body_mass[i] * model.opt.gravity @ data.xipos[i] for i in range(9)))
            fastest = max(fastest, kinetic)
    assert fastest > 20
    assert np.ptp(energies) < 1e-5


def test_the_servo_holds_an_arm_that_straightens_out(iiwa7, X_FT):
    """Where joints 1, 3, 5 and 7 turn about one line, motors meet least inertia and swing fastest."""
    world = MujocoWorld(iiwa7, X_FT, None, None, H)
    bent = np.array([0.0, 0.4, 0.0, -0.8, 0.0, 0.4, 0.0])
    world.reset(tuple(bent))
    first = world.model.opt.timestep
    for k in range(1, 701):
        measured = world.step(tuple(bent * max(0.0, 1 - k / 500)))
    np.testing.assert_allclose(measured.q, 0, rtol=0, atol=2e-4)
    np.testing.assert_allclose(measured.qd, 0, rtol=0, atol=1e-3)
    assert world.model.opt.timestep < first / 1.5


def test_joints_lose_friction_and_damping_between_motor_and_sensor(iiwa7, X_FT, load):
    world, dynamics = MujocoWorld(iiwa7, X_FT, load, None, H), Dynamics(iiwa7, load)
    world.reset(START)
    data = mujoco.MjData(world.model)
    world.model.actuator_biasprm[:] = 0.0  # motors off
    qd = np.array([0.5, -0.4, 0.3, 0.6, -0.5, 0.7, -0.3])
    data.qpos[:], data.qvel[:] = START, qd
    mujoco.mj_forward(world.model, data)
    lost = dynamics.torque(np.array(START), qd, np.array(data.qacc))
    np.testing.assert_allclose(lost, -iiwa7.friction * np.sign(qd) - iiwa7.damping * qd, rtol=0, atol=1e-6)
    assert iiwa7.friction.min() > 0


def test_motors_give_their_torque_at_most_and_tell_when(iiwa7, X_FT):
    heavy = ToolLoad(40.0, np.array([0.0, 0.0, 0.1]), np.diag([0.1, 0.1, 0.1]))
    reached = {}
    for load in (None, heavy):
        world = MujocoWorld(iiwa7, X_FT, load, None, H)
        world.reset(START)
        measured = wait(world, START, 150)
        reached[load] = {motor.joint: motor for motor in world.motors}
        weight = Dynamics(iiwa7, load).gravity_torque(np.array(START))
        if load is None:
            np.testing.assert_allclose([m.torque for m in world.motors], np.abs(weight), rtol=0, atol=1e-3)
            assert all(motor.saturated is None for motor in world.motors)
    assert abs(weight[1]) > 176
    assert reached[heavy]["joint_2"].torque == reached[heavy]["joint_2"].limit == 176
    assert reached[heavy]["joint_2"].saturated == pytest.approx(H)
    assert measured.q[1] > START[1] + 0.01  # it sinks
    world.reset(START)
    assert all((motor.torque, motor.saturated) == (0.0, None) for motor in world.motors)


def top(robot, link, q):
    """The highest point of a link's capsule, by pin."""
    model, capsule = robot.pin_model, robot.capsules[link]
    data = model.createData()
    pinocchio.framesForwardKinematics(model, data, np.array(q))
    X = data.oMf[model.getFrameId(link)]
    return max(float(X.act(np.array(end))[2]) for end in (capsule.a, capsule.b)) + capsule.radius


@pytest.mark.parametrize("engine", list(Engine))
def test_links_meet_an_obstacle_that_the_tool_does_not(iiwa7, X_FT, load, engine):
    """A board above the elbow, which rises into it as the arm leans back."""
    back = (START[0], START[1] - np.radians(8), *START[2:])
    elbow = ("link_3", "link_4")
    under = min(top(iiwa7, link, back) for link in elbow) - 0.01
    assert max(top(iiwa7, link, START) for link in iiwa7.link_names[1:]) < under
    board = Box("board", np.array([0.6, 0.6, 0.1]), pose(np.eye(3), [0.2, 0.0, under + 0.05]))
    contact = Contact((Obstacle(board, 2e4, 200.0, 0.2),), 0.02)
    world = make_world(engine, iiwa7, X_FT, load, contact, H)
    world.reset(START)
    assert world.link_contacts == ()
    for k in range(1, 301):
        measured = world.step(tuple((np.array(START) + (np.array(back) - START) * min(1.0, k / 200)).tolist()))
    found = {one.link: one for one in world.link_contacts}
    assert set(found) == set(elbow)
    assert (measured.depth, measured.contact) == (0.0, (0.0,) * 6)
    for link, touch in found.items():
        assert touch.obstacle == "board"
        assert 0.05 < touch.first < 0.2
        assert touch.last == pytest.approx(0.3)
        if engine is Engine.SPRING:
            assert touch.force is None
            assert touch.depth == pytest.approx(top(iiwa7, link, back) - under, abs=1e-6)
        else:
            # the board pushes back and the arm gives way
            assert 0.001 < touch.depth < top(iiwa7, link, back) - under
            assert touch.force == pytest.approx(2e4 * touch.depth, rel=0.3)
    if engine is Engine.MUJOCO:
        felt = Dynamics(iiwa7, load).gravity_torque(np.array(measured.q)) - measured.tau
        assert np.abs(felt).max() > 5  # and the motors' sensors feel it
