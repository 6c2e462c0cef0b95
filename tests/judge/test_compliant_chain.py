"""Rows along a chain of poses, by closed forms: which leg each is on, how far off, and where they leave the chain."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.judge.chain import Followed, _turn_tolerance, check_chain, follow
from trajopt_cli.iiwa.judge.follow_loops import _within
from trajopt_cli.iiwa.judge.path import StraightPiece
from trajopt_cli.iiwa.judge.samples import Poses
from trajopt_cli.motion import Source

IDENTITY = np.array([1.0, 0, 0, 0])
LENGTHS = np.array([0.1, 0.05, 0.2, 0.02, 0.02, 0.1])
BEGINS = np.r_[0, np.cumsum(LENGTHS)]
END = BEGINS[-1]
TOLERANCE = 0.01
AXIS = np.array([0.48, 0.6, 0.64])


def chain_of(kind: str) -> list[StraightPiece]:
    """A straight chain in x, or a turn about one axis that goes on: by angles about z, or as turn vectors."""
    legs = []
    for begin, length in zip(BEGINS, LENGTHS, strict=False):
        moves = float(kind == "way")
        turn = length * (1 - moves) * (AXIS if kind == "slerp" else np.array([0, 0, 1]))
        angles = np.array([0, 0, begin * (1 - moves)])
        q = Rotation.from_rotvec(begin * AXIS).as_quat(scalar_first=True) if kind == "slerp" else IDENTITY
        p, way = np.array([begin, 0, 0]) * moves, np.array([length, 0, 0]) * moves
        legs.append(
            StraightPiece("leg", Source("task.yaml", 1, 1), p, way, q, turn, kind == "slerp", angles, IDENTITY, {})
        )
    return legs


def rows_at(kind: str, places: Array, aside: Array | float) -> Poses:
    """Rows at places along the chain, and so far aside of it: across it in space, or turned about an axis across."""
    n, aside = len(places), np.broadcast_to(aside, places.shape)
    p = np.column_stack([places, 0.6 * aside, 0.8 * aside]) * (kind == "way")
    if kind == "slerp":
        across = np.cross(AXIS, [0, 0, 1])
        across /= np.linalg.norm(across)
        q = Rotation.from_rotvec(places[:, None] * AXIS + aside[:, None] * across)
    else:
        q = Rotation.from_euler("xyz", np.column_stack([aside, 0 * aside, places]) * (kind != "way"))
    return Poses(np.arange(n) * 1e-3, p, q.as_quat(scalar_first=True), np.zeros(n), np.zeros(n), 1e-3)


def followed(kind: str, places: Array, aside: Array | float = 0.0, first: int = 0, more: float = 1.0) -> Followed:
    rows = rows_at(kind, np.r_[np.zeros(first), places], np.r_[np.zeros(first), np.broadcast_to(aside, places.shape)])
    end = np.abs(places - END) - 1e-6
    tolerances = (TOLERANCE, more) if kind == "way" else (more, TOLERANCE)
    return follow(chain_of(kind), rows, first, *tolerances, end)


@pytest.mark.parametrize("kind", ["way", "angles", "slerp"])
def test_each_row_is_on_the_earliest_leg_that_it_may_be_on(kind: str) -> None:
    """A row aside by d may be sqrt(T^2 - d^2) ahead of the place that it is beside, or behind it, and no farther back
    than the row before; the legs that begin within three tolerances ahead of its place may be its own too."""
    places = np.linspace(0, END, 401)
    aside = 0.007 * np.sin(np.linspace(0, 9 * np.pi, 401)) ** 2
    found = followed(kind, places, aside, first=3)
    at = np.maximum.accumulate(np.maximum(0.0, places - np.sqrt(TOLERANCE**2 - aside**2)))
    assert found.lost is None
    assert (found.first, found.last, len(found.leg)) == (3, 403, 401)
    room = 1e-4 if kind == "slerp" else 1e-9  # turn vectors add up like angles, but not quite
    sure = np.abs(at[:, None] - BEGINS).min(axis=1) > room
    np.testing.assert_array_equal(found.leg[sure], (np.searchsorted(BEGINS, at, side="right") - 1)[sure])
    ahead = np.searchsorted(BEGINS[:-1], at + 3 * TOLERANCE, side="right") - 1
    sure &= np.abs(at[:, None] + 3 * TOLERANCE - BEGINS).min(axis=1) > room
    np.testing.assert_array_equal(found.ahead[sure], ahead[sure])
    assert len(set(found.ahead - found.leg)) == 3
    off, none = (found.off_p, found.off_q) if kind == "way" else (found.off_q, found.off_p)
    np.testing.assert_allclose(off, aside, rtol=0, atol=1e-4 if kind == "slerp" else 1e-12)
    np.testing.assert_allclose(none, 0, rtol=0, atol=1e-15)


@pytest.mark.parametrize("kind", ["way", "angles", "slerp"])
@pytest.mark.parametrize(("share", "lost"), [(0.999, False), (1.001, True)])
def test_where_rows_leave_the_chain(kind: str, share: float, lost: bool) -> None:
    """Aside by more than the tolerance; back by more than two of them; ended before the end."""
    share += 0.004 * (kind == "slerp" and lost)  # that is granted where turn vectors do not add up
    places = np.linspace(0, END, 201)
    aside = np.where(np.arange(201) == 120, share * TOLERANCE, 0.0)
    assert followed(kind, places, aside, first=2).lost == (122 if lost else None)
    back = np.r_[places[:121], places[120] - 2 * share * TOLERANCE, places[120:]]
    assert followed(kind, back).lost == (121 if lost else None)
    short = followed(kind, places[:-1] if lost else places)
    assert short.lost == (199 if lost else None)
    assert len(short.leg) == (200 if lost else 201)


@pytest.mark.parametrize("kind", ["way", "angles", "slerp"])
def test_the_end_of_a_chain_is_the_row_nearest_to_it(kind: str) -> None:
    """Rows may stand about the end pose: the nearest one is the last, if the way is done but for four tolerances."""
    near = END + np.array([-2e-3, -1e-3, 2e-4, -1e-4, 5e-4, 0])
    places = np.r_[np.linspace(0, END - 0.003, 60), near]
    rows = rows_at(kind, places, 0.0)
    tolerances = (TOLERANCE, 1.0) if kind == "way" else (1.0, TOLERANCE)
    found = follow(chain_of(kind), rows, 0, *tolerances, np.abs(places - END) - 1.5e-3)
    assert found.lost is None
    assert found.last == 63
    assert len(found.leg) == len(found.ahead) == len(found.off_p) == len(found.off_q) == 64
    assert found.leg[-1] == found.leg[-2]
    early = np.abs(places - places[0]) - 1.5e-3  # where it begins is no end of it
    assert follow(chain_of(kind), rows, 0, *tolerances, early).lost == len(places) - 1


def test_both_tolerances_hold_together() -> None:
    """A leg that moves and turns: rows that move ahead of their turn are on it as far as both allow."""
    way, turn = np.array([0.3, 0, 0]), np.array([0, 0, 0.6])
    leg = StraightPiece("leg", Source("task.yaml", 1, 1), 0 * way, way, IDENTITY, turn, False, 0 * turn, IDENTITY, {})
    legs = [leg, replace(leg, p=way, way=way, angles=turn)]
    share = np.linspace(0, 2, 101)
    for lead, lost in ((0.0999, False), (0.1001, True)):
        # places within 0.01 m of s x 0.3 m, and within 0.04 rad of (s - lead) x 0.6 rad: 1/30 and 1/15 of a leg
        turned = np.clip(share - np.where(np.abs(share - 1) < 0.5, lead, 0.0), 0, 2)
        q = Rotation.from_rotvec(np.outer(turned, turn)).as_quat(scalar_first=True)
        rows = Poses(share, np.outer(share, way), q, 0 * share, 0 * share, 1e-3)
        end = np.abs(share - 2)
        found = follow(legs, rows, 0, 0.01, 0.04, end)
        assert (found.lost is not None) == lost
        if not lost:
            middle = np.abs(share - 1) < 0.49
            np.testing.assert_allclose(found.off_p[middle], 0.3 * (lead - 1 / 15), rtol=0, atol=1e-12)
            np.testing.assert_allclose(found.off_q[middle], 0.04, rtol=0, atol=1e-12)


def test_the_part_of_a_line_within_a_ball() -> None:
    rng = np.random.default_rng(3)
    for _ in range(200):
        begin, way, p = rng.uniform(-1, 1, (3, 3))
        radius = rng.uniform(0, 2)
        a, b, nearest = _within.py_func(*(begin - p).tolist(), *way.tolist(), radius)
        # the nearest place is square to the line; the ends are on the ball
        foot = begin + nearest * way
        assert abs((foot - p) @ way) < 1e-12
        distance = np.linalg.norm(foot - p)
        assert (a <= b) == (distance <= radius)
        if a <= b:
            ends = begin + np.array([[a], [b]]) * way - p
            np.testing.assert_allclose(np.linalg.norm(ends, axis=1), radius, rtol=1e-12)
    zero = [0.0, 0.0, 0.0]
    for p, inside in (([0.0, 0.6, 0.8], True), ([0.0, 0.6, 0.8001], False)):
        a, b, nearest = _within.py_func(*(-x for x in p), *zero, 1.0)
        assert (a, b, nearest) == ((-math.inf, math.inf, 0.0) if inside else (math.inf, -math.inf, 0.0))


def test_the_tolerance_of_a_large_turn() -> None:
    """Turn vectors of rotations that are a small angle apart lie up to (angle/2) / sin(angle/2) times that apart."""
    turn = np.array([0, 0.6, 0.8])
    one = replace(chain_of("slerp")[0], q=IDENTITY)
    sizes = {0.099: 1.0, 0.101: 0.0505 / math.sin(0.0505), 2.0: 1 / math.sin(1.0), math.pi: math.pi / 2, 5.0: 2.5}
    for size, factor in sizes.items():
        assert _turn_tolerance(replace(one, turn=size * turn), 0.01) == pytest.approx(0.01 * factor, rel=1e-14)
        assert _turn_tolerance(replace(one, turn=size * turn, slerp=False), 0.01) == 0.01
    rng = np.random.default_rng(5)
    for a, b in rng.normal(scale=1.0, size=(300, 2, 3)):
        a *= min(1.0, 3.1 / np.linalg.norm(a))
        other = (Rotation.from_rotvec(a) * Rotation.from_rotvec(1e-4 * b)).as_rotvec()
        apart, angle = np.linalg.norm(other - a), 1e-4 * np.linalg.norm(b)
        most = _turn_tolerance(replace(one, turn=a), 1.0) if np.linalg.norm(a) > 0.1 else 1.001
        if np.linalg.norm(other) <= math.pi and apart < 1:
            assert apart <= angle * most * 1.001


@pytest.mark.parametrize(("kind", "factor"), [("way", 1.0), ("slerp", 0.1 / math.sin(0.1))])
def test_what_is_told_of_rows_on_a_chain(kind: str, factor: float) -> None:
    """The row farthest off, with its time; where rows are lost, the first that is; nothing of no rows."""
    places = np.linspace(0, END, 201)
    aside = np.where(np.arange(201) == 120, 0.008, np.where(np.arange(201) == 50, 0.004, 0))
    rows, chain = rows_at(kind, places, aside), chain_of(kind)
    tolerances = (TOLERANCE, 1.0) if kind == "way" else (1.0, TOLERANCE)
    found = follow(chain, rows, 20, *tolerances, np.abs(places - END)[20:] - 1e-6)
    told = {one.check: one for one in check_chain("A -> B", chain, rows, found, tolerances)}
    order, off = told["order of poses"], told["path" if kind == "way" else "orientation"]
    assert (order.value, order.passed, order.time) == (0, True, None)
    assert (off.value, off.time) == (pytest.approx(0.008, rel=4e-3), 0.12)
    assert off.limit == pytest.approx(TOLERANCE * factor)
    passed = told["poses passed"]
    assert passed.value == pytest.approx(0, abs=1e-12)
    sag = 2 * 0.008 / 8 if kind == "way" else 0.0  # the row aside changes the step by twice its distance
    assert passed.limit == pytest.approx(tolerances[0] + sag, abs=1e-12)
    assert all(one.passed and one.source == chain[0].place for one in told.values())
    lost = rows_at(kind, places, np.where(np.arange(201) >= 90, 0.012, aside))
    for first, count in ((20, 5), (90, 1)):
        found = follow(chain, lost, first, *tolerances, np.abs(places - END)[first:] - 1e-6)
        said = [*check_chain("A -> B", chain, lost, found, tolerances)]
        assert (said[0].value, said[0].passed, said[0].time) == (1, False, 0.09)
        assert len(said) == (4 if count > 1 else 1)
