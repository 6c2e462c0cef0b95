"""The seven-axis arm's files, forward kinematics, Jacobians and capsules."""

import json
import re
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from link_poses import link_poses
from places import TRUTH, crooked_pose

from trajopt_cli.cli import run
from trajopt_cli.errors import InputError
from trajopt_cli.geometry import inverse_pose, pose, rotation_from_wxyz
from trajopt_cli.proximity.pair import Pair
from trajopt_cli.robot.model import load_robot
from trajopt_cli.robot.srs import SrsLengths, load_srs

ROBOTS = Path(__file__).parents[2] / "robots"
LINKS = ("base_link", *(f"link_{i}" for i in range(1, 8)))
PAIRS = {("base_link", f"link_{i}") for i in range(4, 8)}


@pytest.fixture(scope="module")
def iiwa7():
    return load_srs("iiwa7")


@pytest.fixture(scope="module")
def hung():
    """The arm at a crooked pose in the world."""
    return load_srs("iiwa7", crooked_pose(9))


@pytest.fixture
def copy(tmp_path):
    """Writes iiwa7 with edits into a folder of its own: copy(yaml={old: new}, urdf={old: new}) -> path."""

    def write(yaml=None, urdf=None):
        for suffix, edits in (("yaml", yaml or {}), ("urdf", urdf or {})):
            text = (ROBOTS / f"iiwa7.{suffix}").read_text()
            for old, new in edits.items():
                assert old in text, old
                text = text.replace(old, new, 1)
            (tmp_path / f"iiwa7.{suffix}").write_text(text)
        return str(tmp_path / "iiwa7.yaml")

    return write


def test_the_files_hold_the_facts(iiwa7):
    limits = iiwa7.profile()
    assert iiwa7.axis_names == limits.names == tuple(f"joint_{i}" for i in range(1, 8))
    assert iiwa7.lengths == SrsLengths(0.34, 0.4, 0.4, 0.126)
    np.testing.assert_allclose(np.degrees(limits.upper), [170, 120, 170, 120, 170, 120, 175], rtol=1e-15)
    np.testing.assert_array_equal(limits.lower, -limits.upper)
    np.testing.assert_allclose(np.degrees(limits.velocity), [98, 98, 100, 130, 140, 180, 180], rtol=1e-15)
    np.testing.assert_array_equal(limits.acceleration, [8.65, 5.44, 5.69, 11.01, 11.78, 13.76, 13.17])
    np.testing.assert_allclose(limits.jerk, 10 * limits.acceleration, rtol=1e-15)
    np.testing.assert_array_equal(iiwa7.torque, [176, 176, 110, 110, 110, 40, 40])
    np.testing.assert_array_equal(iiwa7.damping, np.full(7, 0.5))
    np.testing.assert_allclose(iiwa7.friction, 0.005 * iiwa7.torque, rtol=0.03)
    kinds = ("position", "velocity", "acceleration", "jerk")
    assert set(limits.sources) == {f"{name}.{kind}" for name in limits.names for kind in kinds}
    grades = {name: text[-2] for name, text in (limits.sources | iiwa7.notes).items() if "(grade " in text}
    assert grades["joint_3.position"] == grades["joint_3.velocity"] == grades["geometry"] == "A"
    assert (grades["joint_6.torque"], grades["joint_3.acceleration"], grades["joint_3.jerk"]) == ("B", "C", "D")
    assert grades["inertia"] == grades["collision"] == "C"
    assert grades["joint_1.damping"] == grades["joint_7.friction"] == "D"


def test_forward_and_jacobian_reproduce_the_truth(iiwa7, truth):
    cases = truth("iiwa7_fk.json")
    q = np.array([c["q"] for c in cases])
    wanted = pose(rotation_from_wxyz([c["quat_wxyz"] for c in cases]), [c["p"] for c in cases])
    assert len(cases) == 250
    np.testing.assert_allclose(iiwa7.forward(q), wanted, rtol=0, atol=1e-12)
    _, _, points = iiwa7.axes_and_points(q)
    np.testing.assert_allclose(points[:, 3].T, [c["elbow"] for c in cases], rtol=0, atol=1e-12)
    np.testing.assert_allclose(points[:, 6].T, [c["wrist"] for c in cases], rtol=0, atol=1e-12)
    rows = [c["jacobian_base_v_then_w_rowmajor_6x7"] for c in cases if "jacobian_base_v_then_w_rowmajor_6x7" in c]
    assert len(rows) == 10
    np.testing.assert_allclose(iiwa7.jacobian(q[:10]), np.reshape(rows, (-1, 6, 7)), rtol=0, atol=1e-12)


def test_forward_and_jacobian_equal_pin_on_a_crooked_mounting(hung, X_FT, rng):
    import pinocchio as pin

    model = pin.Model(hung.pin_model)  # a copy: the frame must not stay in the cached model
    flange = model.frames[model.getFrameId("tool0")]
    tcp = model.addFrame(
        pin.Frame("tcp", flange.parentJoint, 0, flange.placement * pin.SE3(X_FT), pin.FrameType.OP_FRAME)
    )
    data = model.createData()
    q = rng.uniform(-3, 3, (100, 7))
    X, J = hung.forward(q), hung.jacobian(q, X_FT)
    assert hung.link_names == LINKS
    for i, row in enumerate(q):
        found = pin.computeFrameJacobian(model, data, row, tcp, pin.LOCAL_WORLD_ALIGNED)
        np.testing.assert_allclose(J[i], found, rtol=0, atol=1e-12)
        np.testing.assert_allclose(X[i] @ X_FT, data.oMf[tcp].homogeneous, rtol=0, atol=1e-12)
    np.testing.assert_allclose(hung.jacobian(q)[:, 3:], J[:, 3:], rtol=0, atol=1e-12)


def test_links_stand_where_pin_has_them(hung, rng):
    model = hung.pin_model
    q, data = rng.uniform(-3, 3, (20, 7)), model.createData()
    X = hung.links(q)
    for row, poses in zip(q, X, strict=True):
        import pinocchio as pin

        pin.forwardKinematics(model, data, row)
        np.testing.assert_allclose(poses[1:], [data.oMi[i].homogeneous for i in range(1, 8)], rtol=0, atol=1e-13)
        np.testing.assert_array_equal(poses[0], hung.X_WB)
    with pytest.raises(ValueError, match=r"q has shape \(2, 6\)"):
        hung.links(np.zeros((2, 6)))


def test_any_leading_axes_give_the_same_numbers(hung, X_FT, rng):
    q = rng.uniform(-3, 3, (12, 7))
    for found, rows in (
        (hung.forward(q.reshape(3, 4, 7)), hung.forward(q)),
        (hung.jacobian(q.reshape(3, 4, 7), X_FT), hung.jacobian(q, X_FT)),
    ):
        assert found.shape[:2] == (3, 4)
        np.testing.assert_allclose(found.reshape(rows.shape), rows, rtol=0, atol=1e-15)
    np.testing.assert_allclose(hung.forward(q[0]), hung.forward(q)[0], rtol=0, atol=1e-15)
    with pytest.raises(ValueError, match=r"q has shape \(2, 6\), wanted \(\.\.\., 7\) for joint_1, .*joint_7"):
        hung.forward(np.zeros((2, 6)))


def test_mounted_moves_the_arm_and_nothing_else(iiwa7, rng):
    q, X_WB = rng.uniform(-2, 2, 7), crooked_pose(4)
    np.testing.assert_allclose(iiwa7.mounted(X_WB).forward(q), X_WB @ iiwa7.forward(q), rtol=0, atol=1e-15)
    assert iiwa7.mounted(X_WB).pin_model is not iiwa7.pin_model
    with pytest.raises(ValueError, match=r"X_WB is not a pose: its rotation is off by 3"):
        iiwa7.mounted(np.diag([2.0, 1, 1, 1]))
    with pytest.raises(ValueError, match=r"X_WB is not a pose"):
        iiwa7.mounted(np.full((4, 4), np.nan))


def test_lengths_come_from_the_urdf_and_shifts_along_an_axis_change_nothing(copy, rng):
    longer = load_srs(
        copy(
            urdf={
                '"0 -0.0105 0.1925"': '"0 -0.03 0.1925"',
                '"0 0.0105 0.2075"': '"0 0.03 0.2575"',
                '"0 0 0.035"': '"0 0 0.061"',
            }
        )
    )
    assert longer.lengths == SrsLengths(0.34, 0.45, 0.4, 0.152)
    q = rng.uniform(-3, 3, 7)
    import pinocchio as pin

    model = longer.pin_model
    data = model.createData()
    pin.framesForwardKinematics(model, data, q)
    wanted = data.oMf[model.getFrameId("tool0")].homogeneous
    np.testing.assert_allclose(longer.forward(q), wanted, rtol=0, atol=1e-14)


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        ({'<axis xyz="0 -1 0"/>': '<axis xyz="0 1 0"/>'}, "joint 'joint_4' has axis 0 1 0, wanted 0 -1 0: the closed"),
        ({'"0 0.0105 0.2075"': '"0 0.02 0.2075"'}, "joint 'joint_3' stands at 0 0.0095 0.5475 m at q = 0, beside"),
        ({'"0 0.0105 0.2075"': '"0.01 0.0105 0.2075"'}, "joint 'joint_3' stands at 0.01 0 0.5475 m at q = 0"),
        ({'"0 0.0105 0.1925"': '"0.01 0.0105 0.1925"'}, "joint 'joint_4' stands at 0.01 0.0105 0.74 m at q = 0"),
        ({'"0 0 0.1475" rpy="0 0 0"': '"0 0 0.1475" rpy="0 0 0.1"'}, "joint 'joint_1' has a turned origin, wanted rpy"),
        ({'"0 0 0.035" rpy="0 0 0"': '"0 0 0.035" rpy="0 1 0"'}, "joint 'flange' has a turned origin"),
        ({'effort="176"': 'effort="0"'}, "joint 'joint_1' has effort 0, wanted its torque range [Nm] above zero"),
        ({'lower="-2.9': 'lower="2.97'}, "joint 'joint_1': wanted lower < upper and velocity > 0"),
        ({'type="revolute"': 'type="prismatic"'}, "wanted seven revolute joints and a fixed flange"),
        ({"0 -0.0105 0.2075": "0 -0.0105 -0.2075"}, "arm lengths se = 0.4 m and ew = -0.015 m must be positive"),
    ],
)
def test_a_urdf_the_closed_form_does_not_fit_is_refused(copy, edit, words):
    path = copy(urdf=edit)
    with pytest.raises(InputError) as error:
        load_srs(path)
    assert words in str(error.value)
    assert str(error.value).startswith(path.replace(".yaml", ".urdf"))
    assert "\n" not in str(error.value)


def test_each_loader_names_the_arms_of_the_other():
    with pytest.raises(InputError) as error:
        load_robot("iiwa7")
    assert str(error.value) == "iiwa7 is a seven-axis arm, for 'trajopt iiwa'; programs run on arms of six axes"
    with pytest.raises(InputError) as error:
        load_srs("irb140")
    assert str(error.value) == "irb140 is a six-axis arm, for programs; 'trajopt iiwa' is for iiwa14, iiwa7"
    with pytest.raises(InputError, match=r"unknown robot 'iiwa'; did you mean 'iiwa14'\? 'trajopt robot list' shows"):
        load_srs("iiwa")


def test_a_mistake_in_the_yaml_is_named_with_its_line(copy):
    whole = "  joint_5: {position: *range, velocity: *speed, torque: *torque, damping: *damping, friction: *arm}"
    path = copy(yaml={whole: "  joint_5: {position: *range}"})
    with pytest.raises(InputError) as error:
        load_srs(path)
    line = 1 + (ROBOTS / "iiwa7.yaml").read_text().splitlines().index(whole)
    assert f"{path}:{line}: 'axes.joint_5.velocity' is missing: give it a value" in str(error.value)
    assert f"{path}:{line}: 'axes.joint_5.torque' is missing: give it a value" in str(error.value)


def test_names_are_held_against_the_urdf(copy):
    path = copy(yaml={"      joint_3: {value: 5.69": "      joint_8: {value: 5.69"})
    with pytest.raises(InputError, match=r"'profiles\.default\.acceleration\.joint_8' is no axis of the URDF: wanted"):
        load_srs(path)


def test_what_nobody_says_a_joint_loses_is_nothing(copy):
    whole = "  joint_5: {position: *range, velocity: *speed, torque: *torque, damping: *damping, friction: *arm}"
    arm = load_srs(copy(yaml={whole: "  joint_5: {position: *range, velocity: *speed, torque: *torque}"}))
    np.testing.assert_array_equal(arm.damping, [0.5, 0.5, 0.5, 0.5, 0, 0.5, 0.5])
    assert arm.friction[4] == 0
    assert np.all(np.delete(arm.friction, 4) > 0)
    assert {"joint_5.torque", "joint_4.damping"} <= set(arm.notes)
    assert not {"joint_5.damping", "joint_5.friction"} & set(arm.notes)


def test_capsules_are_the_truths(iiwa7):
    path = TRUTH / "collision_primitives.json"
    wanted = json.loads(path.read_text())["iiwa7"]
    assert tuple(iiwa7.capsules) == LINKS
    for i, link in enumerate(LINKS):
        capsule, true = iiwa7.capsules[link], wanted[f"link_{i}"]
        np.testing.assert_array_equal([*capsule.a, *capsule.b, capsule.radius], [*true["a"], *true["b"], true["r"]])


def test_the_pairs_are_chosen_by_what_is_measured(iiwa7):
    """The shares and distances the file prints, and that every other pair stays apart or always touches."""
    limits, rng = iiwa7.profile(), np.random.default_rng(1)
    X = link_poses(iiwa7, rng.uniform(limits.lower, limits.upper, (20_000, 7)))
    text = (ROBOTS / "iiwa7.yaml").read_text()
    checked = {pair for pair in iiwa7.self_pairs if "attached" not in pair}
    assert checked == PAIRS
    for i, j in combinations(range(8), 2):
        pair = LINKS[i], LINKS[j]
        if j == i + 1:
            assert pair not in checked
            continue
        d = Pair(iiwa7.capsules[pair[1]], iiwa7.capsules[pair[0]]).distances(inverse_pose(X[:, i]) @ X[:, j])
        if pair in checked:
            found = re.search(rf"{pair[0]}, {pair[1]}\s+([\d.]+) %, (-\d+) mm", text)
            assert found, pair
            assert float(found[1]) == pytest.approx(100 * float(np.mean(d < 0)), abs=0.06), pair
            assert float(found[2]) == pytest.approx(1e3 * float(d.min()), abs=1), pair
        elif pair == ("link_5", "link_7"):
            assert np.all(d < 0)
        else:
            assert d.min() > 0.02, pair


def test_robot_list_and_show_name_the_arm_its_torques_and_its_sources(capsys):
    assert run(["robot", "list"]) == 0
    shown = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert ["iiwa7", *["KUKA", "LBR", "iiwa", "7", "R800"], "0.80", "m", "7", "kg"] in shown
    assert run(["robot", "show", "iiwa7"]) == 0
    out = capsys.readouterr().out
    assert re.search(r"ew +400 +A \[1\]", out)
    assert re.search(r"joint_7 +-175 +175 +deg +A \[\d+\] +180 +deg/s +A \[\d+\]", out)
    assert re.search(r"joint_2 +rad/s² +5\.44 +C \[\d+\]", out)
    assert re.search(r"joint_3 +±110 +B \[\d+\] +0\.5 +D \[\d+\] +0\.55 +D \[\d+\]", out)
    source = re.search(r"link_6 +2\.404 +0 +71\.02 +4\.95 +C \[(\d+)\]", out)
    assert source
    assert f"[{source[1]}] CAD model of lbr_fri_ros2_stack" in out


def test_manipulability_is_the_product_of_singular_values_at_any_tool():
    robot, rng = load_srs("iiwa7"), np.random.default_rng(6)
    q = rng.uniform(-2, 2, (30, 7))
    X_FT = np.eye(4)
    X_FT[:3, 3] = [0.1, -0.2, 0.3]
    for tool in (None, X_FT):
        sigma = np.linalg.svd(robot.jacobian(q, tool), compute_uv=False)
        np.testing.assert_allclose(robot.manipulability(q), sigma.prod(axis=1), rtol=1e-9)
    assert robot.manipulability(np.zeros(7)) < 1e-9
