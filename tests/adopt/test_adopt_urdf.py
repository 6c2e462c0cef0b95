"""Any legal URDF to a robot's two files: what they hold, held against pin's reading of the URDF as it was given."""

import re

import numpy as np
import pinocchio as pin
import pytest
from arms import PARALLEL
from loose_arm import LOOSE, written

from trajopt_cli.adopt.add import new_robot
from trajopt_cli.errors import InputError
from trajopt_cli.judge.mechanism import Mechanism
from trajopt_cli.robot.model import load_robot
from trajopt_cli.robot.urdf import chain_of

AXES = ["base_yaw", "shoulder_pitch", "elbow_pitch", "fore_roll", "wrist_pitch", "hand_roll"]


def put(folder, made):
    for name, content in made.files.items():
        (folder / name).write_bytes(content)
    return load_robot(str(folder / f"{made.name}.yaml"))


def pin_model(urdf):
    """pin's model of the URDF as it was given; pin asks for every effort, which changes no place."""
    limits = re.sub(r"<limit (?![^>]*effort)", '<limit effort="0" ', urdf.read_text().replace("<axis/>", ""))
    return pin.buildModelFromXML(limits)


def pin_flange(urdf, names, q, tip):
    """Flange poses by pin of the URDF as it was given."""
    model = pin_model(urdf)
    data, out = model.createData(), []
    for row in q:
        full = pin.neutral(model)
        for name, value in zip(names, row, strict=True):
            joint = model.joints[model.getJointId(name)]
            full[joint.idx_q : joint.idx_q + joint.nq] = [np.cos(value), np.sin(value)] if joint.nq == 2 else value
        pin.framesForwardKinematics(model, data, full)
        out.append(data.oMf[model.getFrameId(tip, pin.FrameType.BODY)].homogeneous)
    return np.array(out)


def postures(robot, count=20):
    limits = robot.profile()
    return limits.lower + np.random.default_rng(3).random((count, len(limits.names))) * (limits.upper - limits.lower)


def test_a_loose_urdf_gives_pins_flange_in_both_readers(tmp_path):
    given = written(tmp_path)
    made = new_robot(given, "mine")
    robot = put(tmp_path, made)
    q = postures(robot)
    exact = written(tmp_path, {"1.5708": "1.5707963267948966"})
    wanted = pin_flange(exact, AXES, q, "flange")
    np.testing.assert_allclose(robot.forward(q), wanted, rtol=0, atol=1e-12)
    np.testing.assert_allclose(Mechanism(tmp_path / "mine.urdf", np.eye(4)).flange(q)[0], wanted, rtol=0, atol=1e-12)
    assert robot.axis_names == tuple(f"joint_{i}" for i in range(1, 7))
    assert robot.link_names == ("base_link", *(f"link_{i}" for i in range(1, 7)))
    np.testing.assert_array_equal(robot.profile().velocity, [3, 3, 3, 4, 4, 6])
    np.testing.assert_array_equal(robot.profile().lower[1:], [-1.6, -1.2, -3.4, -2, -6])
    assert robot.profile().upper[0] == 2 * np.pi
    assert robot.X_RB[2, 3] == 0.5  # the stand stays under the base


def test_what_is_taken_otherwise_or_left_out_is_said(tmp_path):
    notes = "\n".join(new_robot(written(tmp_path), "mine").chain.notes)
    for words in (
        "joint 'shoulder_pitch': axis 0 2 0 has length 2 and is taken as a direction alone",
        "joint 'shoulder_pitch': the range is that of <limit>; <safety_controller> is not looked at",
        "joint 'base_yaw' is continuous, without a range: -360 to 360 degrees are taken",
        "joint 'face': rpy 0 1.5708 0 is taken as 0 90 0 degrees, which its digits round",
        "left out, not between 'world' and 'flange': gripper, finger_1, finger_2",
    ):
        assert words in notes


@pytest.mark.parametrize(
    ("axis", "origin"), [("1 0 0", ""), ("0 0.6 0.8", '<origin xyz="0.1 0.2 0.3" rpy="0.3 0.2 -0.4"/>')]
)
def test_a_sliding_axis_below_in_any_direction_is_a_rail(tmp_path, axis, origin):
    slide = (
        f'<joint name="gantry" type="prismatic"><parent link="hall"/><child link="world"/>{origin}<axis xyz="{axis}"/>'
        '<limit lower="-1" upper="4" velocity="2"/></joint>'
    )
    given = written(tmp_path, {"</robot>": f'<link name="hall"/>{slide}</robot>', "1.5708": "1.5707963267948966"})
    robot = put(tmp_path, new_robot(given, "mine"))
    assert robot.axis_names[0] == "rail"
    q = postures(robot)
    np.testing.assert_allclose(robot.forward(q), pin_flange(given, ["gantry", *AXES], q, "flange"), rtol=0, atol=1e-12)
    np.testing.assert_allclose(Mechanism(tmp_path / "mine.urdf", np.eye(4)).flange(q)[0], robot.forward(q), atol=1e-12)


def test_a_fixed_joint_between_axes_becomes_part_of_the_next_ones_origin(tmp_path):
    plate = (
        '<link name="plate"/><joint name="screws" type="fixed"><parent link="elbow"/><child link="plate"/>'
        '<origin xyz="0.1 0.05 0.02" rpy="0.3 0 0"/></joint>'
    )
    edits = {"<!-- joints": f"{plate}<!--", '<parent link="elbow"/>': '<parent link="plate"/>'}
    given = written(tmp_path, edits | {"1.5708": "1.5707963267948966"})
    given.write_text(
        given.read_text().replace(
            '"screws" type="fixed"><parent link="plate"/>', '"screws" type="fixed"><parent link="elbow"/>'
        )
    )
    robot = put(tmp_path, new_robot(given, "mine"))
    q = postures(robot)
    np.testing.assert_allclose(robot.forward(q), pin_flange(given, AXES, q, "flange"), rtol=0, atol=1e-12)


def test_its_own_files_are_taken_again_and_come_out_the_same(tmp_path):
    made = new_robot(written(tmp_path), "mine")
    put(tmp_path, made)
    again = new_robot(tmp_path / "mine.urdf", "mine")
    bare = [re.sub(rb"<!--.*?-->", b"", one.files["mine.urdf"], flags=re.DOTALL) for one in (made, again)]
    assert bare[0] == bare[1]
    assert new_robot(written(tmp_path), "mine").files == made.files  # and the same every time


def test_bodies_that_a_fixed_joint_joins_are_weighed_together(tmp_path):
    def inertial(mass, xyz, rpy="0 0 0"):
        return (
            f'<inertial><origin xyz="{xyz}" rpy="{rpy}"/><mass value="{mass}"/>'
            '<inertia ixx="0.3" ixy="0.01" ixz="0.02" iyy="0.2" iyz="-0.01" izz="0.1"/></inertial>'
        )

    edits = {
        '<link name="hand"/>': f'<link name="hand">{inertial(2, "0.01 0 0.02", "0.1 0.2 0.3")}</link>',
        '<link name="flange"/>': f'<link name="flange">{inertial(1, "0.1 0.2 0.3")}</link>',
        "1.5708": "1.5707963267948966",
        '<link name="gripper"/>': '<link name="gripper"/>',
    }
    given = written(tmp_path, edits)
    put(tmp_path, new_robot(given, "mine"))
    models = [pin_model(path) for path in (given, tmp_path / "mine.urdf")]
    wanted, found = (
        model.inertias[model.getJointId(n)] for model, n in zip(models, ("hand_roll", "joint_6"), strict=True)
    )
    assert found.mass == wanted.mass == 3
    np.testing.assert_allclose(found.lever, wanted.lever, atol=1e-15)
    np.testing.assert_allclose(found.inertia, wanted.inertia, atol=1e-15)


@pytest.mark.parametrize(
    ("edits", "words"),
    [
        ({"</robot>": ""}, "not a URDF: no element found"),
        ({LOOSE: "lengths: 1"}, "not a URDF: syntax error"),
        ({"<robot": "<sdf", "</robot>": "</sdf>"}, "not a URDF: its root is <sdf>, wanted <robot>"),
        ({LOOSE: "<robot/>"}, "has no <link>"),
        ({'xyz="0 2 0"': 'xyz="0 0 0"'}, "joint 'shoulder_pitch': <axis> xyz=\"0 0 0\" has no direction"),
        ({'xyz="0 2 0"': 'xyz="0 nan 0"'}, "<axis> xyz=\"0 nan 0\" is not 3 numbers"),
        ({'"0 0 0.7"': '"0 0 1e9"'}, "no robot has numbers beyond 1e+06"),
        ({'"0 0 0.7"': '"0 0 1_0"'}, "joint 'elbow_pitch': <origin> xyz=\"0 0 1_0\" is not 3 numbers"),
        ({'"0 0 0.7"': '"0 0"'}, "joint 'elbow_pitch': <origin> xyz=\"0 0\" is not 3 numbers"),
        ({'velocity="3"/>': 'velocity="0"/>'}, 'joint \'base_yaw\': velocity="0", wanted the top speed, above 0'),
        ({' <limit velocity="3"/>': ""}, "joint 'base_yaw' has no <limit lower"),
        ({'upper="2" velocity="4"': 'upper="2"'}, "joint 'wrist_pitch' has no velocity of <limit>"),
        ({'lower="-2" upper="2"': 'lower="-120" upper="120"'}, "a range to 120 rad is 19 turns; a URDF's angles"),
        ({'lower="-2" upper="2"': 'lower="2" upper="-2"'}, 'lower="2" upper="-2", wanted lower below upper'),
        ({'lower="-2" upper="2" ': ""}, 'joint \'wrist_pitch\': lower="0" upper="0", wanted lower below upper'),
        ({'name="wrist_pitch" type="revolute"': 'name="wrist_pitch" type="hinge"'}, "type 'hinge': the format"),
        ({'name="wrist_pitch" type="revolute"': 'name="wrist_pitch" type="floating"'}, "'wrist_pitch' is floating"),
        ({'name="wrist_pitch" type="revolute"': 'name="wrist_pitch" type="fixed"'}, "wanted six turning axes"),
        ({'name="wrist_pitch" type="revolute"': 'name="wrist_pitch" type="prismatic"'}, "wrist_pitch (prismatic)"),
        ({'<limit lower="-2" upper="2" velocity="4"/>': '<limit lower="-2" upper="2" velocity="4"/><mimic joint="x"/>'},
         "joint 'wrist_pitch' follows joint 'x' (<mimic>)"),
        ({'<child link="fore"/>': '<child link="four"/>'}, "joint 'fore_roll': child link 'four' is not in the file"),
        ({'<child link="finger_2"/>': '<child link="finger_1"/>'}, "hangs on two joints, 'open' and 'close'"),
        ({'<child link="finger_2"/>': '<child link="world"/>', '<link name="finger_2"/>': ""}, "every link hangs on"),
        ({'<child link="finger_2"/>': '<child link="world"/>'}, "hang on each other in a loop and not on 'finger_2'"),
        ({'<parent link="world"/>': '<parent link="gripper"/>'}, "hang on each other in a loop and not on 'world'"),
        ({'<link name="gripper"/>': '<link name="gripper"/><link name="table"/>'}, "has 2 roots, world, table"),
        ({'<link name="gripper"/>': '<link name="gripper"/><link name="gripper"/>'}, "two links are called 'gripper'"),
        ({'<joint name="open"': "<joint"}, "a <joint> has no name"),
        ({'"flange"': '"plate"'}, "several last ones: name the flange's by --tip, one of finger_1, finger_2"),
        ({'<parent link="world"/> ': ""}, "joint 'stand' has no <parent link=...>"),
        ({"<robot ": "<!DOCTYPE robot>\n<robot "}, "has a document type (<!DOCTYPE ...>)"),
        ({"-3.4": "${-limit}"}, "is xacro, not yet a URDF (${-limit}): expand it first with 'xacro model.urdf"),
        ({"</robot>": "<xacro:arm/></robot>"}, "is xacro, not yet a URDF (<xacro:arm>)"),
        ({"<robot ": '<robot xmlns:xacro="http://ros.org/wiki/xacro" ', "</robot>": "<xacro:arm/></robot>"},
         "is xacro, not yet a URDF (<xacro:arm>)"),
        ({'"0.5 0 0"': '"0.5 0 0.02"'}, "axis 5 passes axis 4 by 20 mm"),
    ],
)  # fmt: skip
def test_what_is_no_such_robot_is_told_in_one_line(tmp_path, edits, words):
    path = written(tmp_path, edits)
    with pytest.raises(InputError) as error:
        new_robot(path, "mine")
    assert str(error.value).startswith(str(path))
    assert words in str(error.value)
    assert "\n" not in str(error.value)


def test_a_billion_laughs_are_refused_before_the_first(tmp_path):
    entities = "".join(f'<!ENTITY a{i} "{f"&a{i - 1};" * 10}">' for i in range(1, 12))
    path = tmp_path / "laughs.urdf"
    path.write_text(f'<?xml version="1.0"?><!DOCTYPE robot [<!ENTITY a0 "ha">{entities}]><robot name="&a11;"/>')
    with pytest.raises(InputError, match="has a document type"):
        new_robot(path, "mine")
    with pytest.raises(InputError, match="has a document type"):
        chain_of(path.read_bytes(), str(path))


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("<robot>" + "<link>" * 3_000_000, "has elements 51 deep"),
        ("<robot>" + "<link/>" * 2_500_000 + "</robot>", "has more than 200,000 elements"),
    ],
    ids=["deep", "many"],
)
def test_files_that_are_all_elements_are_given_up_early(tmp_path, text, words):
    path = tmp_path / "long.urdf"
    path.write_text(text)
    with pytest.raises(InputError, match=words):
        new_robot(path, "mine")


def test_a_file_without_end_is_not_read_to_its_end(tmp_path):
    path = tmp_path / "long.urdf"
    with open(path, "wb") as file:
        file.truncate(10**10)
    with pytest.raises(InputError, match="is larger than 20 MB"):
        new_robot(path, "mine")


def test_tip_and_base_choose_among_several(tmp_path):
    path = written(tmp_path, {'"flange"': '"plate"', "1.5708": "1.5707963267948966"})
    by_tip = put(tmp_path, new_robot(path, "mine", tip="plate", base="foot"))
    q = postures(by_tip)
    wanted = pin_flange(path, AXES, q, "plate")
    wanted[:, 2, 3] -= 0.5  # the stand is not in it
    np.testing.assert_allclose(by_tip.forward(q), wanted, rtol=0, atol=1e-12)
    for options, words in (
        ({"tip": "plat"}, "--tip plat: there is no such link; links are world"),
        ({"tip": "plate", "base": "finger_1"}, "--base finger_1: link 'plate' does not hang on it"),
        ({"tip": "wrist"}, "wanted six turning axes, at most one sliding one before them; --tip names another"),
    ):
        with pytest.raises(InputError, match=re.escape(words)):
            new_robot(path, "mine", **options)


@pytest.mark.parametrize(
    ("name", "rule"),
    [
        ("abb_irb120_3_58", "abb_six_axis"),
        ("IRB 1600", "abb_six_axis"),
        ("my_ABB", "abb_six_axis"),
        ("cabbage", "none"),
        ("airbus_1", "none"),
        ("kuka_kr6", "none"),
    ],
)
def test_the_rule_of_confdata_is_abbs_for_robots_that_are_called_so(tmp_path, name, rule):
    path = written(tmp_path, {"loose arm": name})
    assert new_robot(path, "mine").confdata == rule
    assert new_robot(path, "mine", confdata="abb_six_axis").confdata == "abb_six_axis"


def test_names_that_are_none_are_refused(tmp_path):
    for name in ("", "a b", "../up", "1st", "ä"):
        with pytest.raises(InputError, match="wanted a letter first"):
            new_robot(written(tmp_path), name)
    with pytest.raises(InputError, match="is a word of YAML's own"):
        new_robot(written(tmp_path), "Off")


def test_odd_names_in_the_urdf_stay_inside_their_quotes_and_comments(tmp_path):
    lost = '<collision><geometry><mesh filename="a\u2028b: [&#10;--&gt;"/></geometry></collision>'
    edits = {
        'name="loose arm"': 'name="# {&quot;: \u2028--&gt; \u202e&#10;name: evil"',
        "fore_roll": "-- &lt;!-- &#10; \u2028--",
        '<link name="fore"/>': f'<link name="fore">{lost}</link>',
    }
    robot = put(tmp_path, new_robot(written(tmp_path, edits, "odd --name\u2028.urdf"), "mine"))
    assert robot.name == "mine"
    assert "--> " in robot.title
    assert Mechanism(tmp_path / "mine.urdf", np.eye(4)).names == robot.axis_names


def inertial(mass, tensor):
    xx, yy, zz, xy = tensor
    return (
        f'<link name="fore"><inertial><mass value="{mass}"/><inertia ixx="{xx}" iyy="{yy}" izz="{zz}" ixy="{xy}"'
        ' ixz="0" iyz="0"/></inertial></link>'
    )


@pytest.mark.parametrize(
    ("edits", "words"),
    [
        ({'<link name="fore"/>': inertial(2, (-0.1, 0.1, 0.1, 0))},
         "link 'fore': <inertia> has the main moments -0.1 0.1 0.1 kg m2, and no body has a negative one; correct it"),
        ({'<link name="fore"/>': inertial(2, (0.1, 0.1, 0.1, 0.2))}, "the main moments -0.1 0.1 0.3 kg m2"),
        ({'rpy="0 1.5708 0"': 'rpy="0 90 0"'},
         "joint 'face': <origin> rpy=\"0 90 0\" turns by 90 rad; a URDF's angles are in radians: 90 degrees are"),
        ({'<link name="fore"/>': '<link name="fore"><collision><geometry><mesh filename="a.stl" scale="0 1 1"/>'
          "</geometry></collision></link>"}, "link 'fore': collision <mesh> scale=\"0 1 1\" makes it flat"),
    ],
)  # fmt: skip
def test_numbers_that_no_robot_has_are_refused(tmp_path, edits, words):
    with pytest.raises(InputError) as error:
        new_robot(written(tmp_path, edits), "mine")
    assert words in str(error.value)


@pytest.mark.parametrize(
    ("edits", "words"),
    [
        ({'<link name="fore"/>': inertial(2, (0.1, 0.1, 0.3, 0))},
         "link 'fore': <inertia> has the main moments 0.1 0.1 0.3 kg m2, but of a body the greatest is at"),
        ({'<link name="fore"/>': inertial(0, (0.1, 0.1, 0.1, 0))}, "link 'fore': an <inertia> without mass"),
        ({'<link name="fore"/>': '<link name="fore"><collision><geometry>'
          '<mesh filename="a.stl" scale="0.001 0.001 0.001"/></geometry></collision></link>'},
         "link 'fore': its collision mesh is scaled by 0.001 0.001 0.001, as its scale says"),
        ({"fore_roll": "fore&#9;roll"}, "joint 'fore\troll': a tab, a line break or the like in its name"),
        ({'"lower"': '"lower&#9;arm"'}, "link 'lower\tarm': a tab, a line break or the like in its name"),
    ],
)  # fmt: skip
def test_what_is_doubtful_is_noted_in_one_line(tmp_path, edits, words):
    notes = new_robot(written(tmp_path, edits), "mine").chain.notes
    assert [note for note in notes if words in note]
    assert new_robot(written(tmp_path), "mine").chain.notes != notes  # and not of the arm as it was


def test_a_body_as_thin_as_a_plate_is_not_doubted(tmp_path):
    path = written(tmp_path, {'<link name="fore"/>': inertial(2, (0.1, 0.2, 0.3001, 0))})
    assert not [note for note in new_robot(path, "mine").chain.notes if "main moments" in note]


def test_blanks_around_a_name_do_not_part_it_from_those_who_name_it(tmp_path):
    path = written(tmp_path, {'name="lower"': 'name="lower&#9;"', 'link="lower"': 'link=" lower"'})
    assert "lower" in new_robot(path, "mine").chain.tree.links


def test_an_arm_with_three_parallel_axes_becomes_a_robot(tmp_path):
    path = tmp_path / "given.urdf"
    path.write_text(PARALLEL["ur10e"]().urdf())
    robot = put(tmp_path, new_robot(path, "mine", track=True))
    q = postures(robot)
    wanted = pin_flange(path, [f"joint_{i}" for i in range(1, 7)], q, "tool0")
    np.testing.assert_allclose(robot.forward(q), wanted, rtol=0, atol=1e-12)
    on_rail = load_robot(str(tmp_path / "mine_rail.yaml"))
    assert on_rail.arm.lengths == robot.arm.lengths == pytest.approx(load_robot("ur10e").arm.lengths, abs=1e-15)
