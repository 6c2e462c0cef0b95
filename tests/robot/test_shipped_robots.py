"""The robots that ship: dimensions held against second sources, and the ones on a track against those that ride it."""

import re
from dataclasses import astuple
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.adopt.urdf_text import on_track
from trajopt_cli.geometry import pose, rotation_about, rotation_from_wxyz, wxyz_from_rotation
from trajopt_cli.motion import ConfData
from trajopt_cli.robot.description import shipped
from trajopt_cli.robot.model import load_robot, robot_names
from trajopt_cli.robot.structure import Structure

ROBOTS = Path(__file__).parents[2] / "robots"
SIX = robot_names(Structure.SIX_AXIS)

# Distal Denavit-Hartenberg rows of 4rtur1t0/ARTE, robots/ABB/NAME/parameters.m: d and a by link in mm. Its angles are
# [q1, q2 - 90, q3, q4, q5, q6 + 180] deg, its alphas [-90, 0, -90, 90, -90, 0] deg for all of them.
ARTE = {
    "irb120": ([290, 0, 0, 302, 0, 72], [0, 270, 70, 0, 0, 0]),
    "irb1600_6_120": ([486.5, 0, 0, 600, 0, 65], [150, 475, 0, 0, 0, 0]),
    "irb2600_12_165": ([445, 0, 0, 795, 0, 85], [150, 700, 115, 0, 0, 0]),
    "irb4600_40_255": ([495, 0, 0, 1270, 0, 135], [175, 1095, 175, 0, 0, 0]),
    "irb6700_200_260": ([780, 0, 0, 1142.5, 0, 200], [320, 1125, 200, 0, 0, 0]),
}
# RobotComponents' preset of the IRB 1200-5/0.9: points on axes 2 to 6 and the mounting frame at q = 0, mm.
POINTS_1200 = [(0, 0, 399.1), (0, 0, 847.1), (288.5, 0, 889.1), (451, 0, 889.1), (533, 0, 889.1)]
# visose/Robots, Libraries/bartlett.xml, KR6-R900: a and d by joint in mm (KUKA's angles: axis 1 and the wrist turn
# against the right hand, axis 2 is at -90 deg when the lower arm stands up).
KR6 = ([25, 455, 35, 0, 0, 0], [400, 0, 0, 420, 0, 80])


def dh(theta, d, a, alpha):
    z, x = (pose(rotation_about([0, 0, 1], theta), [0, 0, d]), pose(rotation_about([1, 0, 0], alpha), [a, 0, 0]))
    return z @ x


@pytest.mark.parametrize("name", ARTE)
def test_flange_poses_are_those_of_artes_table(name, rng):
    robot, right = load_robot(name), np.pi / 2
    d, a = ARTE[name]
    for q in rng.uniform(-2, 2, (20, 6)):
        X = np.eye(4)
        theta = q + np.array([0, -right, 0, 0, 0, np.pi])
        for row in zip(theta, np.array(d) / 1e3, np.array(a) / 1e3, [-right, 0, -right, right, -right, 0], strict=True):
            X = X @ dh(*row)
        np.testing.assert_allclose(robot.forward(q), X, rtol=0, atol=1e-14)


def test_the_axes_of_the_irb_1200_pass_the_points_of_another_model():
    chain = load_robot("irb1200_5_90").chain
    origins = np.cumsum([joint.X[:3, 3] for joint in chain], axis=0) * 1e3
    axes = [chain[i].axis for i in range(1, 6)]
    for origin, axis, point in zip(origins[1:], axes, POINTS_1200, strict=False):
        assert np.linalg.norm(np.cross(axis, np.array(point) - origin)) < 1e-9
    np.testing.assert_allclose(origins[-1], POINTS_1200[-1], atol=1e-9)


def test_the_kuka_is_that_of_another_models_table(rng):
    robot, right = load_robot("kr6_r900"), np.pi / 2
    a, d = (np.array(row) / 1e3 for row in KR6)
    for q in rng.uniform(-2, 2, (20, 6)):
        theta = np.array([-q[0], q[1], q[2] - right, -q[3], q[4], np.pi - q[5]])
        X = np.eye(4)
        for row in zip(theta, d, a, [-right, 0, -right, right, -right, 0], strict=True):
            X = X @ dh(*row)
        np.testing.assert_allclose(robot.forward(q), X, rtol=0, atol=1e-14)


def test_the_puma_is_that_of_the_papers_table(rng):
    """Armstrong, Khatib, Burdick 1986: modified Denavit-Hartenberg rows; flange 56.25 mm out, base 671.83 mm up."""
    robot, right = load_robot("puma560"), np.pi / 2
    rows = [
        (0, 0, 0),
        (-right, 0, 0.2435),
        (0, 0.4318, -0.0934),
        (right, -0.0203, 0.4331),
        (-right, 0, 0),
        (right, 0, 0),
    ]
    for q in rng.uniform(-2, 2, (20, 6)):
        X = pose(np.eye(3), [0, 0, 0.67183])
        for theta, (alpha, a, d) in zip(q, rows, strict=True):
            X = X @ dh(0, 0, a, alpha) @ dh(theta, d, 0, 0)
        np.testing.assert_allclose(robot.forward(q), X @ pose(np.eye(3), [0, 0, 0.05625]), rtol=0, atol=1e-14)


def test_the_pumas_gravity_torques_are_those_of_the_paper():
    """G2 = g1 C2 + g2 S23 + g3 S2 + g4 C23 and G3 = g2 S23 + g4 C23, g1 -37.2, g2 -8.44, g4 0.249 Nm, but for the
    wrist's g5 of -0.028 Nm."""
    import pinocchio as pin

    model = load_robot("puma560").pin_model
    data = model.createData()
    lying = pin.computeGeneralizedGravity(model, data, np.zeros(6))
    stretched = pin.computeGeneralizedGravity(model, data, np.array([0, 0, np.pi / 2, 0, 0, 0]))
    assert lying[1] == pytest.approx(-37.2 + 0.249, abs=0.06)
    assert stretched[2] == pytest.approx(-8.44, abs=0.06)


# d1, a2, a3, d4, d5, d6 [m] by universal-robots.com, and speeds [deg/s].
UR = {
    "ur5e": ((0.1625, -0.425, -0.3922, 0.1333, 0.0997, 0.0996), [180] * 6),
    "ur10e": ((0.1807, -0.6127, -0.57155, 0.17415, 0.11985, 0.11655), [120, 120, 180, 180, 180, 180]),
}


@pytest.mark.parametrize("name", UR)
def test_the_universal_robots_are_those_of_the_makers_table(name, rng):
    """Denavit-Hartenberg parameters as universal-robots.com has them."""
    robot, right, ((d1, a2, a3, d4, d5, d6), speeds) = load_robot(name), np.pi / 2, UR[name]
    rows = [(d1, 0, right), (0, a2, 0), (0, a3, 0), (d4, 0, right), (d5, 0, -right), (d6, 0, 0)]
    for q in rng.uniform(-6, 6, (20, 6)):
        X = np.eye(4)
        for theta, (d, a, alpha) in zip(q, rows, strict=True):
            X = X @ dh(theta, d, a, alpha)
        np.testing.assert_allclose(robot.forward(q), X, rtol=0, atol=1e-14)
    np.testing.assert_allclose(np.degrees(robot.profile().velocity), speeds, rtol=1e-15)
    np.testing.assert_allclose(np.degrees(robot.profile().upper), [360, 360, 180, 360, 360, 360], rtol=1e-15)
    np.testing.assert_array_equal(robot.profile().lower, -robot.profile().upper)


@pytest.mark.parametrize("name", [name for name in SIX if not name.endswith("_rail")])
def test_a_robot_on_a_track_is_the_robot_on_a_track(name):
    made = on_track(name, {path: (ROBOTS / path).read_bytes() for path in (f"{name}.urdf", f"{name}.yaml")})
    assert made == {path: (ROBOTS / path).read_bytes() for path in (f"{name}_rail.urdf", f"{name}_rail.yaml")}


def test_the_list_says_how_far_they_reach_and_what_they_carry():
    robots = {robot.name: robot for robot in shipped()}
    assert tuple(robots) == robot_names()
    for name in SIX:  # ABB's names say both: payload in kg, reach in m
        if match := re.match(r"ABB IRB \d+-(\d+)/([\d.]+)", robots[name].title):
            assert robots[name].payload == float(match[1])
            assert robots[name].reach == pytest.approx(float(match[2]), abs=0.03)
    assert robots["kr6_r900"].reach == pytest.approx(0.9, abs=0.003)
    assert robots["ur10e"].reach == pytest.approx(1.3, abs=0.02)  # as the maker says
    assert robots["iiwa7"].reach == pytest.approx(0.8, abs=1e-12)


# Targets of public RobotStudio programs, with tools whose frame is the flange's and in wobj0: place mm, confdata.
# RobotStudio's first target is where the flange stands at [0, 0, 0, 0, 30, 0].
HOME = {
    "irb120": [364.353829072, 0, 594],  # "Pick and Place de dos diferentes latas", Module1.mod
    "irb1200_5_90": [522.01408311, 0, 848.1],  # a tower of blocks, Module1
}
# Of the first program: places over two conveyors and on them; the controller's configurations are RobotStudio's.
LATAS = [
    ([360.022653153, 0, 473.726196092], (0, 0, 0, 0)),
    ([388.755601806, 0, 338.420809037], (0, 0, 0, 0)),
    ([359.130975003, 0, 443.778021736], (0, 0, 0, 0)),
    ([361.332509941, 0, 254.842738956], (0, 0, 0, 0)),
    ([-55.454860484, -460.39542717, 433.082453731], (-2, 0, -2, 0)),
    ([-55.454860484, -460.39542717, 248.927934739], (-2, 0, -2, 0)),
]


@pytest.mark.parametrize("name", HOME)
def test_robotstudios_first_target_is_where_the_flange_is(name):
    q = np.radians([0, 0, 0, 0, 30, 0])
    X = load_robot(name).forward(q)
    np.testing.assert_allclose(X[:3, 3] * 1e3, HOME[name], rtol=0, atol=1e-8)
    np.testing.assert_allclose(wxyz_from_rotation(X[:3, :3]), [0.5, 0, 0.866025404, 0], rtol=0, atol=1e-9)
    assert astuple(load_robot(name).confdata(q)) == (0, 0, 0, 0)


@pytest.mark.parametrize(("place", "conf"), LATAS)
def test_targets_of_an_irb_120_are_reached_in_their_confdata_by_one_configuration(place, conf):
    robot = load_robot("irb120")
    X = pose(rotation_from_wxyz([0, 0, 1, 0]), np.array(place) / 1e3)
    found = [q for _, q in robot.solutions(X, None, robot.profile()) if robot.admits(ConfData(*conf), q)]
    assert len(found) == 1
    np.testing.assert_allclose(robot.forward(found[0]), X, rtol=0, atol=1e-12)


@pytest.mark.parametrize("name", ["irb120", "irb140_rail", "irb1600_6_120", "irb6700_200_260"])
def test_the_rule_has_the_wrist_where_both_tables_agree_and_the_rest_between_the_arms(name):
    limits = load_robot(name).profile("rule")
    slow, fast = ([1.0 for _ in limits.names] for _ in (0, 1))
    for i, axis in enumerate(limits.names):
        slow[i], fast[i] = limits.spread.get(f"{axis}.acceleration", (1.0, 1.0))
    times = limits.velocity / limits.acceleration
    np.testing.assert_allclose(times[-3:] / np.array(slow)[-3:], 0.081, rtol=0.06)  # two digits are written
    np.testing.assert_allclose(times[-3:] / np.array(fast)[-3:], 0.056, rtol=0.06)
    for j, (least, most) in enumerate([(0.064, 0.56), (0.094, 0.39), (0.073, 0.171)]):  # of both tables, all postures
        k = len(times) - 6 + j
        assert least * 0.94 < times[k] / fast[k] < times[k] < times[k] / slow[k] < most * 1.06
