"""The cell file's word on jerk: whether its limits bind, and the line where there are none."""

from __future__ import annotations

import numpy as np
import pytest

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.errors import InputError
from trajopt_cli.limits import JointLimits
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.robot.model import RobotModel

CELL = "robot: irb140\nstart: {joints: '[0, 0, 0, 0, 30, 0] deg'}\n"


def test_the_profiles_jerks_bind_where_the_cell_says_so() -> None:
    assert build_plant(parse_cell(CELL, "c.yaml")).limits.binding_jerk is None
    own = "limits: {joint_2: {jerk: '9000 deg/s3', source: measured}}\n"
    jerk = build_plant(parse_cell(CELL + own + "jerk_limits: true\n", "c.yaml")).limits.binding_jerk
    assert jerk is not None
    assert jerk[:3] == pytest.approx([150.0, 50 * np.pi, 200.0])


def test_a_robot_without_jerks_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    profile = RobotModel.profile

    def without(self: RobotModel, name: str = "default") -> JointLimits:
        known = profile(self, name)
        return JointLimits(known.names, known.lower, known.upper, known.velocity, known.acceleration)

    monkeypatch.setattr(RobotModel, "profile", without)
    with pytest.raises(InputError) as told:
        build_plant(parse_cell(CELL + "jerk_limits: true\n", "c.yaml"))
    assert str(told.value) == (
        "c.yaml:3: jerk_limits: robot irb140 gives no jerk; give each axis its own under limits, with its source"
    )


def test_jerk_limits_is_true_or_false() -> None:
    with pytest.raises(InputError) as told:
        parse_cell(CELL + "jerk_limits: 100\n", "c.yaml")
    assert str(told.value) == "c.yaml:3: jerk_limits: needs true or false, not 100"
