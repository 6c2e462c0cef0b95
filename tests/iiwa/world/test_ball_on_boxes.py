"""The contact law in closed form: faces, edges, corners, inside, damping, friction, moments."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from trajopt_cli.geometry import pose, rotation_about
from trajopt_cli.iiwa.task.model import Contact, Obstacle
from trajopt_cli.iiwa.world.contact import APART, FRICTION_RISE, BallOnBoxes
from trajopt_cli.shapes import Box

STILL = (0.0, 0.0, 0.0)
K, C, MU, TIP = 1e4, 50.0, 0.25, 0.03
SIZE = np.array([0.4, 0.2, 0.1])


def boxes(X=None, stiffness=K, damping=C, friction=MU, more=()):
    box = Box("block", SIZE, np.eye(4) if X is None else X)
    return BallOnBoxes(Contact((Obstacle(box, stiffness, damping, friction), *more), TIP))


@pytest.mark.parametrize(
    ("p", "distance", "normal"),
    [
        ((0.1, 0.05, 0.06), 0.01, (0, 0, 1)),
        ((0.1, -0.12, 0.01), 0.02, (0, -1, 0)),
        ((0.203, 0.02, 0.054), 0.005, (0.6, 0, 0.8)),
        ((-0.202, -0.103, -0.056), 0.007, (-2 / 7, -3 / 7, -6 / 7)),
        ((0.1, 0.05, 0.04), -0.01, (0, 0, 1)),
        ((-0.19, 0.05, 0.0), -0.01, (-1, 0, 0)),
        ((0.0, 0.0, 0.05), 0.0, (0, 0, 1)),
    ],
)
def test_a_still_ball_is_pushed_along_the_nearest_normal_by_stiffness_times_depth(p, distance, normal):
    touch = boxes().touch(p, STILL, STILL)
    assert touch.depth == pytest.approx(TIP - distance, abs=1e-15)
    np.testing.assert_allclose(touch.force[:3], K * (TIP - distance) * np.array(normal), rtol=0, atol=1e-9)
    # the push goes through the ball's centre
    np.testing.assert_allclose(touch.force[3:], 0.0, rtol=0, atol=1e-12)


def test_no_force_when_apart_or_just_touching():
    assert boxes().touch((0.0, 0.0, 0.0801), STILL, STILL) == APART
    assert boxes().touch((0.0, 0.0, 0.0801), (0.0, 0.0, -5.0), STILL) == APART
    # beside an edge: within the tip of both faces' planes, but not of the edge
    assert boxes().touch((0.222, 0.0, 0.072), STILL, STILL) == APART


def test_damping_adds_on_approach_and_never_pulls_on_leaving():
    world = boxes(friction=0.0)
    assert world.touch((0.0, 0.0, 0.07), (0.0, 0.0, -0.2), STILL).force[2] == pytest.approx(K * 0.01 + C * 0.2)
    assert world.touch((0.0, 0.0, 0.07), (0.0, 0.0, 1.0), STILL).force[2] == pytest.approx(K * 0.01 - C)
    assert world.touch((0.0, 0.0, 0.07), (0.0, 0.0, 2.5), STILL).force == (0.0,) * 6


@pytest.mark.parametrize("speed", [1e-4, 5e-3, 0.0124, 0.0126, 0.3])
def test_friction_opposes_sliding_rises_with_speed_and_stops_at_coulombs_bound(speed):
    touch = boxes().touch((0.0, 0.0, 0.07), (0.6 * speed, -0.8 * speed, 0.0), STILL)
    rub = min(FRICTION_RISE * speed, MU * K * 0.01)
    np.testing.assert_allclose(touch.force[:3], [-0.6 * rub, 0.8 * rub, K * 0.01], rtol=1e-12)
    # half-way between the ball's deepest point and the surface, 25 mm below the centre
    np.testing.assert_allclose(touch.force[3:], np.cross([0, 0, -0.025], touch.force[:3]), rtol=0, atol=1e-12)


def test_a_rolling_ball_does_not_rub():
    lever = 0.025
    touch = boxes().touch((0.0, 0.0, 0.07), (0.1, 0.0, 0.0), (0.0, 0.1 / lever, 0.0))
    np.testing.assert_allclose(touch.force, [0, 0, K * 0.01, 0, 0, 0], rtol=0, atol=1e-9)


def test_boxes_add_up():
    wall = Obstacle(Box("wall", np.array([0.1, 1.0, 1.0]), pose(np.eye(3), [-0.06, 0.0, 0.0])), 2 * K, 0.0, 0.0)
    touch = boxes(more=(wall,)).touch((0.01, 0.0, 0.055), STILL, STILL)
    np.testing.assert_allclose(touch.force[:3], [2 * K * 0.01, 0.0, K * 0.025], rtol=1e-12)
    assert touch.depth == pytest.approx(0.025)


@settings(max_examples=200, deadline=None)
@given(
    st.tuples(*[st.floats(-0.3, 0.3)] * 3),
    st.tuples(*[st.floats(-1.0, 1.0)] * 3),
    st.tuples(*[st.floats(-1.0, 1.0)] * 3),
    st.floats(-3.0, 3.0),
)
def test_turned_boxes_give_turned_forces_within_the_cone_that_never_feed_sliding(p, v, w, angle):
    faces = sorted(d for u, s in zip(p, SIZE / 2, strict=True) for d in (abs(s - u), abs(s + u)))
    assume(faces[1] - faces[0] > 1e-9)  # inside, half-way between two faces, rounding chooses
    R, shift = rotation_about([0.36, 0.48, 0.8], angle), np.array([0.5, -0.1, 0.2])
    plain = boxes().touch(p, v, w)
    turned = boxes(pose(R, shift)).touch(*(tuple(row) for row in (R @ p + shift, R @ v, R @ w)))
    np.testing.assert_allclose(turned.depth, plain.depth, rtol=0, atol=1e-12)
    np.testing.assert_allclose(turned.force[:3], R @ plain.force[:3], rtol=0, atol=1e-7)
    np.testing.assert_allclose(turned.force[3:], R @ plain.force[3:], rtol=0, atol=1e-7)
    n = np.array(boxes(damping=0.0).touch(p, STILL, STILL).force[:3])
    if n.any():
        n /= np.linalg.norm(n)
        force = np.array(plain.force[:3])
        push = force @ n
        rub = force - push * n
        point = np.cross(w, n * (plain.depth / 2 - TIP)) + v
        assert push >= -1e-12
        assert np.linalg.norm(rub) <= MU * push + 1e-9
        assert rub @ point <= 1e-9
