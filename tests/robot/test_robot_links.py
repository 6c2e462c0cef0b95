"""The links of a robot file, capsules against the truth, and the pairs that are checked against what is measured."""

import json
import re
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from link_poses import link_poses

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import inverse_pose, pose, rotation_from_wxyz
from trajopt_cli.proximity.pair import Pair
from trajopt_cli.robot.inverse import inverse
from trajopt_cli.robot.model import load_robot
from trajopt_cli.shapes import Box

ROBOTS = Path(__file__).parents[2] / "robots"
DATA = Path(__file__).parents[1] / "data"
TRUTH = DATA / "truth" / "collision_primitives.json"
LINKS = ("base_link", *(f"link_{i}" for i in range(1, 7)))
LEFT_OUT = {("base_link", "link_2"), ("link_1", "link_3"), ("link_2", "link_4"), ("link_4", "link_6")}
NEVER = {("link_2", "link_5"), ("link_2", "link_6"), ("link_3", "link_5"), ("link_3", "link_6")}


def test_link_poses_end_at_the_flange(mounted, rng):
    q = rng.uniform(-3, 3, (50, len(mounted.axis_names)))
    assert mounted.link_names == LINKS
    flange = mounted.chain[6].X
    np.testing.assert_allclose(link_poses(mounted, q)[:, 6] @ flange, mounted.forward(q), rtol=0, atol=1e-12)


def test_links_stand_at_zero_where_the_truth_says(irb140):
    """The frames in the meta of the capsules' file, all parallel to the base."""
    wanted = [[0, 0, 0], [0, 0, 0], [0.07, 0, 0.352], [0.07, 0, 0.712], [0.309, 0, 0.712], [0.45, 0, 0.712],
              [0.515, 0, 0.712]]  # fmt: skip
    X = link_poses(irb140, np.zeros((1, 6)))[0]
    np.testing.assert_allclose(X[:, :3, 3], wanted, rtol=0, atol=1e-15)
    np.testing.assert_allclose(X[:, :3, :3], np.tile(np.eye(3), (7, 1, 1)), rtol=0, atol=1e-15)


@pytest.mark.parametrize("name", ["irb140", "irb140_rail"])
def test_capsules_are_the_truths(name):
    truth = json.loads(TRUTH.read_text())["irb140"]
    robot = load_robot(name)
    assert set(robot.capsules) == set(truth) == set(LINKS)
    for link, wanted in truth.items():
        capsule = robot.capsules[link]
        np.testing.assert_array_equal(
            [*capsule.a, *capsule.b, capsule.radius], [*wanted["a"], *wanted["b"], wanted["r"]]
        )
    assert robot.notes["collision"].endswith("(grade C)")


def overlaps(robot, q):
    """Share of overlaps and least distance [m] of every pair of links that are no neighbours."""
    X = link_poses(robot, q)
    out = {}
    for i, j in combinations(range(7), 2):
        if j > i + 1:
            pair = Pair(robot.capsules[LINKS[j]], robot.capsules[LINKS[i]])
            d = pair.distances(inverse_pose(X[:, i]) @ X[:, j])
            out[LINKS[i], LINKS[j]] = float(np.mean(d < 0)), float(d.min())
    return out


def test_the_pairs_are_chosen_by_what_is_measured(irb140, rng):
    """The shares the robot files print, and that every other pair is checked."""
    case_file = DATA / "cases" / "hinge_cell.json"
    case = json.loads(case_file.read_text())
    limits = irb140.profile()
    X = [pose(rotation_from_wxyz(p["quat"]), p["xyz"]) for p in case["poses"].values()]
    stations = np.repeat(np.array(X), 41, axis=0)
    stations[:, 1, 3] = np.tile(np.linspace(-0.5, 0.5, 41), len(X))
    q = inverse(irb140, stations).reshape(-1, 6)
    q = q[np.isfinite(q).all(axis=1)]
    q = q[((q >= limits.lower) & (q <= limits.upper)).all(axis=1)]
    at_stations = overlaps(irb140, q)
    anywhere = overlaps(irb140, rng.uniform(limits.lower, limits.upper, (4000, 6)))
    at_home = overlaps(irb140, np.array([case["home_q"][1:]]))

    checked = {pair for pair in irb140.self_pairs if "attached" not in pair}
    assert checked == set(at_home) - LEFT_OUT - NEVER
    for pair in checked:
        assert at_home[pair][0] == at_stations[pair][0] == 0, pair
        assert anywhere[pair][0] > 0, pair  # something to find
    for pair in NEVER:
        assert anywhere[pair][1] > 0.013, pair
    for name in ("irb140", "irb140_rail"):
        text = (ROBOTS / f"{name}.yaml").read_text()
        for pair in LEFT_OUT - {("link_4", "link_6")}:
            found = re.search(rf"{pair[0]}, {pair[1]}\s+(\d+) %,\s+(\d+) %", text)
            assert found, pair
            assert float(found[1]) == pytest.approx(100 * at_stations[pair][0], abs=0.6)
            assert float(found[2]) == pytest.approx(100 * anywhere[pair][0], abs=2.5)
    assert anywhere["link_4", "link_6"][0] == 1.0


def test_two_in_five_overlaps_of_the_column_with_the_wrist_are_none(irb140, rng):
    """Boxes around the links are apart: the file says so beside the pairs."""
    truth = json.loads(TRUTH.read_text())["irb140"]
    limits = irb140.profile()
    X = link_poses(irb140, rng.uniform(limits.lower, limits.upper, (6000, 6)))

    def box(link):
        low, high = np.array(truth[link]["bbox_min"]), np.array(truth[link]["bbox_max"])
        return Box(link, high - low, pose(np.eye(3), (low + high) / 2))

    for link in ("link_4", "link_5", "link_6"):
        placed = inverse_pose(X[:, 1]) @ X[:, LINKS.index(link)]
        overlap = Pair(irb140.capsules[link], irb140.capsules["link_1"]).distances(placed) < 0
        boxes = Pair(box(link), box("link_1")).distances(placed[overlap])
        assert np.mean(boxes > 0) == pytest.approx(0.43, abs=0.1), link


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("    link_3: {a:", "    link_33: {a:", "'collision.links.link_33' is no link of the arm: known"),
        ("[base_link, link_4]", "[base_link, link_44]", "'collision.self_pairs': link_44 has no capsule: known are"),
        ("[base_link, link_4]", "[link_4, base_link]", "'collision.self_pairs': link_4, base_link: wanted two links"),
        ("radius: 0.2019", "radius: -0.2", "'collision.links.base_link.radius': input should be greater than 0"),
        ("radius: 0.2019", "radius: 0.2, r: 1", "unknown key 'collision.links.base_link.r'"),
    ],
)  # fmt: skip
def test_mistakes_in_the_collision_section_have_their_line(old, new, said, tmp_path):
    text = (ROBOTS / "irb140.yaml").read_text()
    assert old in text
    (tmp_path / "irb140.yaml").write_text(text.replace(old, new))
    (tmp_path / "irb140.urdf").write_text((ROBOTS / "irb140.urdf").read_text())
    with pytest.raises(InputError) as caught:
        load_robot(str(tmp_path / "irb140.yaml"))
    assert said in str(caught.value)
    assert str(caught.value).startswith(f"{tmp_path / 'irb140.yaml'}:")
    assert caught.value.line > 60


def test_an_arm_without_the_section_has_no_shapes(tmp_path):
    text = (ROBOTS / "irb140.yaml").read_text().split("collision:\n")[0]
    (tmp_path / "irb140.yaml").write_text(text)
    (tmp_path / "irb140.urdf").write_text((ROBOTS / "irb140.urdf").read_text())
    robot = load_robot(str(tmp_path / "irb140.yaml"))
    assert robot.capsules == {}
    assert robot.self_pairs == ()
