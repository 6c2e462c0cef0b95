"""`coupled` in a robot's YAML file: ranges of sums of axes, read, checked, and kept by what asks for joints."""

import json
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.cli import run
from trajopt_cli.errors import InputError
from trajopt_cli.limits import CoupledRange
from trajopt_cli.robot.model import load_robot

ROBOTS = Path(__file__).parents[2] / "robots"
SECTION = """
coupled:
  - axes: [joint_2, joint_3]
    factors: [1, 1]
    lower: -2.5
    upper: 0.6
    source: "working range, made up"
    grade: D
"""


@pytest.fixture
def write(tmp_path):
    """An IRB 140 with the section, after edits; gives its path."""

    def made(old="", new=""):
        assert old in SECTION
        (tmp_path / "irb140.urdf").write_text((ROBOTS / "irb140.urdf").read_text())
        (tmp_path / "mine.yaml").write_text((ROBOTS / "irb140.yaml").read_text() + SECTION.replace(old, new, 1))
        return str(tmp_path / "mine.yaml")

    return made


def test_it_is_in_every_profile_with_its_source(write):
    robot = load_robot(write())
    for profile in robot.profiles.values():
        (one,) = profile.coupled
        assert one == CoupledRange(("joint_2", "joint_3"), (1, 1), -2.5, 0.6, "working range, made up (grade D)")
        np.testing.assert_array_equal(profile.couplings.rows, [[0, 1, 1, 0, 0, 0]])
    assert load_robot("irb140").profile().coupled == ()


def test_solutions_stay_within_it(write):
    robot, free = load_robot(write()), load_robot("irb140")
    rng, left_out = np.random.default_rng(2), 0
    for _ in range(40):
        X = free.forward(rng.uniform([-1, -1, -2, -1, -1, -1], [1, 1, 0.5, 1, 1, 1]))
        every = free.solutions(X, None, free.profile())
        kept = robot.solutions(X, None, robot.profile())
        wanted = [q for _, q in every if -2.5 - 1e-9 <= q[1] + q[2] <= 0.6 + 1e-9]
        np.testing.assert_array_equal([q for _, q in kept], wanted)
        left_out += len(every) - len(wanted)
    assert left_out > 20


@pytest.mark.parametrize(("lower", "upper"), [(-7, -5.58), (2.79, 5)])
def test_it_may_touch_what_its_axes_reach(write, lower, upper):
    """joint_2 and joint_3 reach -90 - 230 to 110 + 50 degrees together."""
    robot = load_robot(write("lower: -2.5\n    upper: 0.6", f"lower: {lower}\n    upper: {upper}"))
    assert (robot.profile().coupled[0].lower, robot.profile().coupled[0].upper) == (lower, upper)


def test_why_a_pose_is_out_of_it(write):
    """Of the branches and turns that each joint's own range holds, the one that is least outside."""
    robot, free = load_robot(write()), load_robot("irb140")
    for q, lower, upper in (([0.2, 0.9, 0.1, 0.3, 0.4, 0.5], -2.5, 0.6), ([0.2, -0.9, -2.2, 0.3, 0.4, 0.5], -2.5, 0.6)):
        X = free.forward(np.array(q))
        every = free.solutions(X, None, free.profile())
        limits = robot.profile()
        assert robot.solutions(X, None, limits) == [] or len(robot.solutions(X, None, limits)) < len(every)
        kept = [(cfx, one) for cfx, one in every if not -2.5 <= one[1] + one[2] <= 0.6]
        only = replace(limits, lower=kept[0][1] - 0.01, upper=kept[0][1] + 0.01)
        cfx, total = kept[0][0], kept[0][1][1] + kept[0][1][2]
        said = robot.why_unreachable(X, None, only)
        assert said == (
            f"every branch breaks a limit: nearest joint_2 + joint_3 = {np.degrees(total):.6g}° (cfx {cfx}),"
            f" range {np.degrees(lower):.6g}..{np.degrees(upper):.6g}°"
        )


def test_robot_show_tells_it(write, capsys):
    assert run(["robot", "show", write()]) == 0
    assert re.search(r"joint_2 \+ joint_3 +-143\.239 +34\.3775 +deg +D \[\d+\]", capsys.readouterr().out)
    assert run(["robot", "show", write(), "--json"]) == 0
    (one,) = json.loads(capsys.readouterr().out)["coupled"]
    assert one == {"axes": ["joint_2", "joint_3"], "factors": [1, 1], "lower": -2.5, "upper": 0.6,
                   "source": "working range, made up (grade D)"}  # fmt: skip


@pytest.mark.parametrize(
    ("old", "new", "place", "words"),
    [
        ("joint_2, joint_3", "joint_2, joint_7", "axes: [joint_2, joint_7", "joint_7 is no joint of the arm"),
        ("joint_2, joint_3", "joint_2, joint_2", "axes: [joint_2, joint_2", "wanted two joints or more, each once"),
        ("[joint_2, joint_3]", "[joint_2]", "axes: [joint_2]", "wanted two joints or more, each once"),
        ("factors: [1, 1]", "factors: [1]", "factors: [1]", "1 for 2 axes: give one for each"),
        ("factors: [1, 1]", "factors: [1, 0]", "factors: [1, 0]", "0 leaves its axis out"),
        ("factors: [1, 1]", "factors: [1, .inf]", "factors: [1, .inf]", "input should be a finite number"),
        ("lower: -2.5", "lower: 0.6", "lower: 0.6", "0.6 is not below upper 0.6"),
        ("lower: -2.5\n    upper: 0.6", "lower: 4\n    upper: 5", "lower: 4", "4..5 rad is out of reach: "),
        ("lower: -2.5\n    upper: 0.6", "lower: -7\n    upper: -5.6", "lower: -7", "-7..-5.6 rad is out of reach"),
        ("grade: D", "grade: E", "grade: E", "'coupled.0.grade': input should be"),
        ("    lower: -2.5\n", "", "axes: [joint_2, joint_3]", "'coupled.0.lower' is missing"),
    ],
)  # fmt: skip
def test_a_mistake_is_named_with_its_line(write, old, new, place, words):
    path = write(old, new)
    with pytest.raises(InputError, match=re.escape(words)) as error:
        load_robot(path)
    lines = Path(path).read_text().splitlines()
    assert place in lines[error.value.line - 1]
