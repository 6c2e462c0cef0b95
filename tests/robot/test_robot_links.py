"""The links of a robot file, bodies against the truth, and the pairs that are checked against what is measured."""

import json
from itertools import combinations, pairwise, product
from pathlib import Path

import numpy as np
import pytest
from clear_of import with_capsules
from link_poses import link_poses

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import inverse_pose
from trajopt_cli.proximity.pair import Pair
from trajopt_cli.robot.catalogue import read_head
from trajopt_cli.robot.model import load_robot, robot_names
from trajopt_cli.robot.srs import load_srs
from trajopt_cli.robot.structure import Structure
from trajopt_cli.shapes import Capsule

ROBOTS = Path(__file__).parents[2] / "robots"
DATA = Path(__file__).parents[1] / "data"
TRUTH = DATA / "truth" / "collision_primitives.json"
LINKS = ("base_link", *(f"link_{i}" for i in range(1, 7)))
LEFT_OUT = {
    ("link_1", "link_3"): "11 % of the postures",
    ("link_2", "link_4"): "0.3 % of the postures",
    ("link_4", "link_6"): "always",
}
NEVER = {
    ("base_link", "link_2"),
    ("link_2", "link_5"),
    ("link_2", "link_6"),
    ("link_3", "link_5"),
    ("link_3", "link_6"),
}


BASE = next(line for line in (ROBOTS / "irb140.yaml").read_text().splitlines() if line.startswith("    base_link: {"))
BALL = "    base_link: {a: [0, 0, 0], b: [0, 0, 0.1], radius: 0.2}"


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
def test_polytopes_are_as_long_wide_and_high_as_the_meshes(name):
    """To the millimetre that they are rounded up to."""
    truth = json.loads(TRUTH.read_text())["irb140"]
    robot = load_robot(name)
    assert set(robot.bodies) == set(truth) == set(LINKS)
    for link, wanted in truth.items():
        (body,) = robot.bodies[link]
        low, high = body.vertices.min(axis=0), body.vertices.max(axis=0)
        grown = np.array([*(np.array(wanted["bbox_min"]) - low), *(high - np.array(wanted["bbox_max"]))])
        assert grown.min() > -6e-5, (link, grown)  # of the truth's own digits
        assert grown.max() < 1.2e-3, (link, grown)
    assert robot.notes["collision"].endswith("(grade C)")


def overlaps(robot, q, bodies):
    """Whether each pair of links overlaps at axes q (n,)."""
    X = link_poses(robot, q)
    out = {}
    for i, j in combinations(range(7), 2):
        if j > i + 1:
            pair = Pair(bodies[LINKS[j]][0], bodies[LINKS[i]][0])
            out[LINKS[i], LINKS[j]] = pair.distances(inverse_pose(X[:, i]) @ X[:, j]) <= 0
    return out


def test_the_pairs_are_chosen_by_what_is_measured(irb140, rng):
    """The shares the robot files print, and that every other pair that ever touches is checked."""
    case = json.loads((DATA / "cases" / "hinge_cell.json").read_text())
    limits = irb140.profile()
    anywhere = overlaps(irb140, rng.uniform(limits.lower, limits.upper, (6000, 6)), irb140.bodies)
    at_home = overlaps(irb140, np.array([case["home_q"][1:]]), irb140.bodies)

    checked = {pair for pair in irb140.self_pairs if "attached" not in pair}
    assert checked == set(at_home) - LEFT_OUT.keys() - NEVER
    for pair in checked:
        assert not at_home[pair][0], pair
        assert anywhere[pair].any(), pair  # something to find
    for pair in NEVER:
        assert not anywhere[pair].any(), pair
    for name, (pair, share) in product(("irb140", "irb140_rail"), LEFT_OUT.items()):
        text = (ROBOTS / f"{name}.yaml").read_text()
        assert f"#   {pair[0]}, {pair[1]}: {share}" in text
        said = 100.0 if share == "always" else float(share.split()[0])
        assert said == pytest.approx(100 * anywhere[pair].mean(), abs=1.0)


def test_polytopes_overlap_where_capsules_do_and_far_less_often(irb140, rng):
    """Both hold the meshes; of the overlaps of column and wrist as capsules three in five are none."""
    limits = irb140.profile()
    q = rng.uniform(limits.lower, limits.upper, (6000, 6))
    capsules, polytopes = (overlaps(irb140, q, bodies) for bodies in (with_capsules(irb140).bodies, irb140.bodies))
    for link in ("link_4", "link_5", "link_6"):
        before, after = (one["link_1", link] for one in (capsules, polytopes))
        assert 0.25 < after.sum() / before.sum() < 0.42, link
        assert (after & ~before).sum() < 0.02 * after.sum()  # corners of a polytope beyond the capsule


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("    link_3: {p", "    link_33: {p", "'collision.links.link_33' is no link of the arm: known"),
        ("[base_link, link_4]", "[base_link, link_44]", "'collision.self_pairs': link_44 has no body: known are"),
        ("[base_link, link_4]", "[link_4, base_link]", "'collision.self_pairs': link_4, base_link: wanted two links"),
        (BASE, BALL.replace("0.2}", "-0.2}"), "'collision.links.base_link.radius': input should be greater than 0"),
        (BASE, BALL.replace("0.2}", "0.2, r: 1}"), "unknown key 'collision.links.base_link.r'"),
        (BASE, BALL.replace(", radius: 0.2", ""), "'collision.links.base_link': gives a, b: give a, b and radius"),
        (BASE, BALL.replace("{a", "{polytope: [" + "1, " * 25 + "1], a"), "gives a, b, radius, polytope: give"),
        (BASE, "    base_link: {parts: []}", "'collision.links.base_link': gives no body: give"),
        (BASE, "    base_link: {}", "'collision.links.base_link': gives no body: give"),
        ("[0.241, 0.302,", "[0.302,", "'collision.links.base_link.polytope'"),
        ("[0.241, 0.302,", "[0.241, -2,", "'collision.links.base_link': polytope 'base_link': its planes leave no"),
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
    assert robot.bodies == {}
    assert robot.self_pairs == ()


@pytest.mark.parametrize("name", robot_names())
def test_every_shipped_robot_has_bodies_that_hang_together_and_pairs_to_watch(name, rng):
    """Neighbours meet at their joint wherever it turns: bodies in another frame than their link's would part."""
    path = ROBOTS / f"{name}.yaml"
    if read_head(path).structure is Structure.SRS:
        robot = load_srs(name)
        X = robot.links(rng.uniform(-2, 2, (40, 7)))
    else:
        robot = load_robot(name)
        limits = robot.profile()
        X = link_poses(robot, rng.uniform(limits.lower, limits.upper, (40, len(limits.lower))))
    assert tuple(robot.bodies) == robot.link_names
    for i, (first, second) in enumerate(pairwise(robot.link_names)):
        apart = Pair(robot.bodies[second][0], robot.bodies[first][0]).distances(inverse_pose(X[:, i]) @ X[:, i + 1])
        assert apart.max() < 0.004, (second, apart.max())
    assert len(robot.self_pairs) > 5
    assert (robot.link_names[0], "attached") in robot.self_pairs
    assert robot.colour is not None
    arm = ROBOTS / f"{name.removesuffix('_rail')}.yaml"
    assert path.read_text().partition("collision:")[2] == arm.read_text().partition("collision:")[2]


def test_a_link_may_have_several_bodies(tmp_path):
    text = (ROBOTS / "irb140.yaml").read_text()
    (tmp_path / "irb140.urdf").write_text((ROBOTS / "irb140.urdf").read_text())
    inner = BASE.partition(": ")[2]
    (tmp_path / "irb140.yaml").write_text(
        text.replace(BASE, f"    base_link: {{parts: [{BALL.partition(': ')[2]}, {inner}]}}")
    )
    capsule, body = load_robot(str(tmp_path / "irb140.yaml")).bodies["base_link"]
    assert isinstance(capsule, Capsule)
    np.testing.assert_array_equal(body.vertices, load_robot("irb140").bodies["base_link"][0].vertices)
