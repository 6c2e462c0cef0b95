"""URDFs of arms with a parallel linkage: what their levers (<mimic>) tell of axes 2 and 3, and what they do not."""

from __future__ import annotations

import json
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from loose_arm import written

from trajopt_cli.adopt.add import NewRobot, new_robot
from trajopt_cli.cli import run
from trajopt_cli.errors import InputError
from trajopt_cli.robot.model import RobotModel, load_robot


def levers(*mimics: str, axis: str = "0 1 0", kind: str = "revolute") -> dict[str, str]:
    """The edit of the loose arm that hangs a lever on its turret for each mimic; in it elbow and shoulder turn about
    opposite directions."""
    limit = '<limit lower="-3" upper="3" velocity="3"/>' if kind == "revolute" else ""
    parts = [
        f'<link name="bar_{i}"/><joint name="lever_{i}" type="{kind}"><parent link="turret"/><child link="bar_{i}"/>'
        f'<axis xyz="{axis}"/>{limit}<mimic {mimic}/></joint>'
        for i, mimic in enumerate(mimics)
    ]
    return {"</robot>": f"{''.join(parts)}</robot>"}


def put(folder: Path, made: NewRobot, name: str = "mine") -> RobotModel:
    for file, content in made.files.items():
        (folder / file).write_bytes(content)
    return load_robot(str(folder / f"{name}.yaml"))


ELBOW, SHOULDER = 'joint="elbow_pitch"', 'joint="shoulder_pitch"'


@pytest.mark.parametrize(
    "edits",
    [
        levers(f'{ELBOW} multiplier="1"'),
        levers(f"{ELBOW}"),
        levers(f'{ELBOW} multiplier="-1" offset="0.4"'),
        levers(f'{SHOULDER} multiplier="-1"'),
        levers(f"{SHOULDER}", f'{ELBOW} multiplier="-1"'),
        levers(f'{ELBOW} multiplier="-1.0"', 'joint="lever_0" multiplier="-1"'),
        levers(f"{ELBOW}", kind="continuous", axis="0 -1 0"),
    ],
)
def test_levers_make_axis_3_the_upper_arms_angle_against_the_base(tmp_path, edits) -> None:
    made = new_robot(written(tmp_path, edits), "mine", track=True)
    (note,) = [note for note in made.chain.notes if "lever_0" in note]
    assert "axis 3" in note
    for name in ("mine", "mine_rail"):
        robot = put(tmp_path, made, name)
        assert robot.linkage == -1
        q = np.array([0.0] * robot.has_rail + [0.3, 0.2, 0.5, 0.4, 0.3, 0.2])
        turned = q + 0.4 * (np.arange(len(q)) == robot.has_rail + 1)
        before, after = robot.forward(q), robot.forward(turned)
        np.testing.assert_allclose(after[:3, :3], before[:3, :3], atol=1e-12)
        assert np.linalg.norm(after[:3, 3] - before[:3, 3]) == pytest.approx(2 * 0.7 * np.sin(0.2))
        limits = robot.profile()
        np.testing.assert_array_equal([limits.lower[-4], limits.upper[-4], limits.velocity[-4]], [-1.2, 3.1, 3])


@pytest.mark.parametrize(
    ("edits", "said"),
    [
        ({}, None),  # the gripper's finger follows the other one
        (levers('joint="open" multiplier="0.3"'), None),
        (levers('joint="base_yaw" multiplier="0.3"'), None),
        (levers('joint="nobody"'), None),
        (levers(f"{ELBOW}", axis="0 0 1"), "lever_0"),
        (levers('joint="wrist_pitch" multiplier="0.5"'), "lever_0"),
        (levers('joint="hand_roll"'), "lever_0"),
    ],
)
def test_what_follows_other_joints_couples_nothing(tmp_path, edits, said) -> None:
    made = new_robot(written(tmp_path, edits), "mine")
    assert put(tmp_path, made).linkage == 0
    told = [note for note in made.chain.notes if "mimic" in note]
    assert len(told) == (said is not None)
    assert all(str(said) in note for note in told)


@pytest.mark.parametrize(
    ("edits", "joint"),
    [
        (levers(f'{ELBOW} multiplier="0.5"'), "lever_0"),
        (levers(f'{SHOULDER} multiplier="-2"'), "lever_0"),
        (levers(f"{ELBOW}", f'{ELBOW} multiplier="0"'), "lever_1"),
        (levers(f'{ELBOW} multiplier="2"', 'joint="lever_0" multiplier="0.6"'), "lever_0"),
        ({'<axis xyz="0 -1 0"/>': f'<axis xyz="0 -1 0"/><mimic {SHOULDER} multiplier="-1"/>'}, "elbow_pitch"),
        (levers(f'{ELBOW} multiplier="one"'), "lever_0"),
    ],
)
def test_a_coupling_that_is_not_clear_is_refused(tmp_path, edits, joint) -> None:
    path = written(tmp_path, edits)
    with pytest.raises(InputError) as error:
        new_robot(path, "mine")
    assert error.value.file == str(path)
    assert f"'{joint}'" in str(error.value)
    assert run(["robot", "add", str(path), "--name", "mine", "--output", str(tmp_path)]) == 2


def raw(folder: Path, yaml: str = "") -> Path:
    """The robot's YAML beside a URDF with its lever left in, as somebody may write them by hand."""
    made = new_robot(written(folder, levers(f"{ELBOW}")), "mine")
    put(folder, made)
    lever = '<link name="bar"/><joint name="lever" type="revolute"><parent link="link_1"/><child link="bar"/>'
    lever += '<origin xyz="0 0 0" rpy="0 0 0"/><axis xyz="0 1 0"/><limit lower="-3" upper="3" velocity="3" effort="0"/>'
    lever += '<mimic joint="joint_3"/></joint></robot>'
    (folder / "mine.urdf").write_text((folder / "mine.urdf").read_text().replace("</robot>", lever))
    return folder / "mine.yaml"


def test_a_urdf_with_levers_and_a_file_that_says_nothing_of_them_is_refused(tmp_path) -> None:
    path = raw(tmp_path)
    robot, q = load_robot(str(path)), np.array([0.3, 0.2, 0.5, 0.4, 0.3, 0.2])
    assert robot.linkage == -1
    flange = np.ravel(ca.Function("flange", [symbol := ca.SX.sym("q", 6)], [robot.expressions.flange(symbol)[0]])(q))
    np.testing.assert_allclose(flange, robot.forward(q)[:3, 3], atol=1e-12)  # the lever is no joint of the chain
    text = path.read_text()
    path.write_text(text[: text.index("coupled:")] + text[text.index("# Accelerations and jerks") :])
    with pytest.raises(InputError, match="lever") as error:
        load_robot(str(path))
    assert text.splitlines()[error.value.line - 1].startswith("urdf:")


def test_an_axis_of_the_chain_that_follows_another_is_refused(tmp_path) -> None:
    put(tmp_path, new_robot(written(tmp_path), "mine"))
    urdf = tmp_path / "mine.urdf"
    head, _, rest = urdf.read_text().partition('<joint name="joint_3"')
    urdf.write_text(head + '<joint name="joint_3"' + rest.replace("</joint>", '<mimic joint="joint_2"/></joint>', 1))
    with pytest.raises(InputError, match="'joint_3' follows"):
        load_robot(str(tmp_path / "mine.yaml"))


def test_robot_show_says_which_axis_is_which(tmp_path, capsys) -> None:
    put(tmp_path, new_robot(written(tmp_path, levers(f"{ELBOW}")), "mine"))
    assert run(["robot", "show", str(tmp_path / "mine.yaml")]) == 0
    assert "joint_3 is joint_3 + joint_2" in capsys.readouterr().out
    assert run(["robot", "show", str(tmp_path / "mine.yaml"), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["linkage"] == -1
