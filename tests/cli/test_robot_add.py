"""`trajopt robot add`: what is printed, what is written, and what is left alone."""

import json

import numpy as np
import pytest
from loose_arm import written

from trajopt_cli.cli import run
from trajopt_cli.robot.model import load_robot


@pytest.fixture
def model(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    written(tmp_path, {"1.5708": "1.5707963267948966"})
    return tmp_path


def test_it_prints_what_was_read_and_what_comes_next(model, capsys):
    assert run(["robot", "add", "model.urdf", "--name", "mine"]) == 0
    said = capsys.readouterr().out
    assert "mine: from world to flange of model.urdf" in said
    assert "with all axes at 0 the flange is at 1050 0 1700 mm, its z along 1 0 0, its x along 0 0 -1" in said
    for words in (
        "elbow_pitch",
        "confdata: none",
        "marked REPLACE in mine.yaml",
        "robot show ./mine.yaml",
    ):
        assert words in said
    assert run(["robot", "show", "./mine.yaml"]) == 0
    assert "loose arm (from model.urdf)" in capsys.readouterr().out


def test_quiet_and_json(model, capsys):
    assert run(["robot", "add", "model.urdf", "--name", "mine", "--quiet", "--output", "new/folder"]) == 0
    assert capsys.readouterr().out == "written: new/folder/mine.urdf, new/folder/mine.yaml\n"
    assert run(["robot", "add", "model.urdf", "--name", "mine", "--json", "--confdata", "abb_six_axis"]) == 0
    record = json.loads(capsys.readouterr().out)
    robot = load_robot("mine.yaml")
    assert record["files"] == ["mine.urdf", "mine.yaml"]
    assert record["axes"][2] == {
        "name": "joint_3", "in_urdf": "elbow_pitch", "lower": -1.2, "upper": 3.1, "velocity": 3.0
    }  # fmt: skip
    assert record["confdata"] == "abb_six_axis" == robot.confdata_rule
    np.testing.assert_allclose(record["flange_at_zero_m"], robot.forward(np.zeros(6))[:3, 3])
    assert record["lengths_m"] == robot.arm.lengths


def test_nothing_is_overwritten_unasked_and_old_files_stay_beside(model, capsys):
    (model / "mine.yaml").write_text("dear")
    assert run(["robot", "add", "model.urdf", "--name", "mine"]) == 2
    assert "mine.yaml: exists; choose another --name or --output, or --force" in capsys.readouterr().err
    assert not (model / "mine.urdf").exists()
    assert run(["robot", "add", "model.urdf", "--name", "mine", "--force"]) == 0
    assert (model / "mine.yaml.bak").read_text() == "dear"
    assert load_robot("mine.yaml").name == "mine"


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["none.urdf", "--name", "mine"], "none.urdf: cannot read the URDF: No such file or directory"),
        (["model.urdf", "--name", "../mine"], "--name ../mine: wanted a letter first"),
        (["model.urdf", "--name", "model", "--force"], "model.urdf: is the URDF to read; choose another --name"),
        (["model.urdf", "--name", "mine", "--output", "model.urdf"], "model.urdf: is a file; --output names a folder"),
        (["model.urdf", "--name", "mine", "--tip", "x"], "model.urdf: --tip x: there is no such link"),
        (["model.urdf"], "--name"),
    ],
)
def test_a_wrong_request_is_one_line_and_writes_nothing(model, capsys, arguments, words):
    before = sorted(model.iterdir())
    assert run(["robot", "add", *arguments]) == 2
    said = capsys.readouterr().err
    assert words in said
    assert said.count("\n") == 1
    assert sorted(model.iterdir()) == before


def test_confdata_of_an_arm_without_a_rule_is_not_looked_at(model, capsys):
    assert run(["robot", "add", "model.urdf", "--name", "mine", "--quiet"]) == 0
    place, turn = "[[900,0,1500],[0.5,0,0.8660254,0],", ",[9E9,9E9,9E9,9E9,9E9,9E9]]"
    moves = f"MoveJ {place}[3,3,3,7]{turn}, v500, fine, tool0;"
    (model / "one.mod").write_text(f"MODULE one\nPROC main()\n{moves}\nENDPROC\nENDMODULE\n")
    (model / "one.yaml").write_text('robot: mine.yaml\nstart: {joints: "[0, 0, 0, 0, 30, 0] deg"}\n')
    assert run(["parse", "one.mod"]) == 0
    told = "every point and line fits the robot (confdata is not looked at: robot mine has no rule for it)\n"
    assert told in capsys.readouterr().out
    text = (model / "mine.yaml").read_text()
    (model / "mine.yaml").write_text(text.replace("rule: none", "rule: abb_six_axis"))
    run(["parse", "one.mod"])
    said = capsys.readouterr().out
    assert "1 motion does not fit the robot\n" in said
    assert "not looked at" not in said


def test_on_a_track_and_with_a_program_of_its_own(model, capsys):
    assert run(["robot", "add", "model.urdf", "--name", "mine", "--rail", "--output", "robots", "--quiet"]) == 0
    assert "robots/mine_rail.urdf" in capsys.readouterr().out
    plain, railed = load_robot("robots/mine.yaml"), load_robot("robots/mine_rail.yaml")
    X = railed.forward(np.array([0.7, *np.full(6, 0.2)]))
    np.testing.assert_allclose(X, plain.forward(np.full(6, 0.2)) + _shift(0.7), atol=1e-12)
    assert run(["robot", "add", "robots/mine_rail.urdf", "--name", "again", "--rail"]) == 2
    assert "--rail: the chain has one already, 'rail'" in capsys.readouterr().err
    assert run(["new", "work", "--robot", "robots/mine_rail.yaml", "--rail"]) == 0
    (model / "cells").mkdir()
    assert run(["new", "cells/work", "--robot", "robots/mine_rail.yaml"]) == 0
    for path, said in (("work", "robots/mine_rail.yaml"), ("cells/work", "../robots/mine_rail.yaml")):
        assert f"robot: {said} " in (model / f"{path}.yaml").read_text()
        assert run(["parse", f"{path}.mod", "--quiet"]) == 0


def _shift(distance):
    X = np.zeros((4, 4))
    X[1, 3] = distance
    return X
