"""Which rows are near a point, at it, or pass it: against definitions written out one row after the other."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from by_hand import Ride, at, seen, stops_of
from legal_motion import Case, home, move_ext, move_j, plant_with_rail, program
from legal_runs import P1, P2, VIA, Z10, move_c
from scipy.spatial.transform import Rotation

from trajopt_cli.geometry import Array, pose
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.judge import samples as rows_module
from trajopt_cli.judge import tolerances as tol
from trajopt_cli.judge import waypoint_matching
from trajopt_cli.judge.program_points import ProgramPoint, path_to
from trajopt_cli.judge.samples import Rows, judged_rows
from trajopt_cli.judge.tool_kinematics import ToolKinematics
from trajopt_cli.judge.waypoint_matching import Closeness, candidate_rows, closeness_at, events_of, passages
from trajopt_cli.motion import FlyBy, MoveExtJ
from trajopt_cli.trajectory import Trajectory

PLANT = plant_with_rail()
TOOL = pose(np.eye(3), [0.02, 0.0, 0.1])
A_TCP = PLANT.tcp.acceleration


def around(seed: int, marked: bool, n: int = 150) -> Rows:
    """Rows whose axes are near the start's by what may be granted, some more and some less, some at rest."""
    rng = np.random.default_rng(seed)
    gaps = rng.uniform(0.004, 0.012, n - 1)
    t = np.r_[0.0, np.cumsum(gaps)]
    if marked:
        t = np.sort(np.r_[np.arange(n - 1) * 0.008, 0.1031])
    small = 10.0 ** rng.uniform(-8, -3 if not marked else -5, (n, 1)) * rng.uniform(0.3, 1, (n, 7))
    slow = 10.0 ** rng.uniform(-8, 0 if not marked else -4, (n, 7)) * rng.integers(0, 2, (n, 1))
    q, qd = PLANT.start + small * rng.choice([-1, 1], (n, 7)), slow * rng.choice([-1, 1], (n, 7))
    steps = Resolution(0.0, 10.0 ** rng.uniform(-8, -5, (n, 7)), 10.0 ** rng.uniform(-8, -6, (n, 7)))
    rows = judged_rows(PLANT, Trajectory(PLANT.limits.names, t, q, qd), steps)
    assert rows.marked == marked
    return rows


def point(**more: object) -> ProgramPoint:
    X = PLANT.robot.forward(PLANT.start[None])[0]
    given = dict(index=0, move=move_j(11, "p", X), source=None, name="p", X_WF=X, X_FT=TOOL, arm=None, rail=None,
                 optional=False) | more  # fmt: skip
    return ProgramPoint(**given)  # type: ignore[arg-type]


STOPS = {
    "pose": point(),
    "pose and rail": point(rail=(float(PLANT.start[0]),)),
    "joints": point(arm=PLANT.start[1:], rail=(float(PLANT.start[0]) + 1e-5,)),
    "rail alone": point(move=move_ext(11, 0.0), X_WF=None, rail=(float(PLANT.start[0]),)),
}


@pytest.mark.parametrize("rapid", [False, True])
@pytest.mark.parametrize("marked", [True, False])
@pytest.mark.parametrize("kind", STOPS)
def test_how_near_rows_are_to_a_stop(kind: str, marked: bool, rapid: bool) -> None:
    """Of a pose position and rotation, of joints each of them, of external axes the rail with the tool at rest: within
    tolerance, besides what digits leave open, and a tau^2/2 where the boundary may be tau away."""
    stop, rows = STOPS[kind], around(41, marked)
    frame = ToolKinematics(rows, stop.X_FT)
    which = np.arange(0, len(rows.t), 2)
    found = closeness_at(rows, frame, stop, rapid)(which)
    alpha = float(PLANT.limits.acceleration[1:].sum())
    sets: dict[str, list[bool]] = {name: [] for name in ("near", "tight", "rests", "rail_met", "stands")}
    for k, i in enumerate(which):
        tau, open_q = rows.open_time[i], rows.doubt_q[i] / 2
        granted = tol.JOINT_TARGET + open_q + PLANT.limits.acceleration * tau**2 / 2
        off = np.abs(rows.q[i] - PLANT.start)
        rests = frame.least_speed[i] <= 1e-5 + A_TCP * tau and frame.least_turning[i] <= 1e-5 + alpha * tau
        met = stop.rail is None or abs(rows.q[i, 0] - stop.rail) <= granted[0]
        if stop.rail is not None and not marked and stop.arm is None and not isinstance(stop.move, MoveExtJ):
            near_rows = range(max(i - 1, 0), min(i + 2, len(rows.t)))  # half a gap to either side it may be the stop
            beside = [(rows.q[i, 0] + rows.q[m, 0]) / 2 for m in near_rows]
            most = 1e-6 + rows.doubt_q[near_rows, 0].max() / 2 + PLANT.limits.acceleration[0] * tau**2 / 2
            met = min(beside) - most <= stop.rail <= max(beside) + most
        if isinstance(stop.move, MoveExtJ):
            near, tight, distance = met and rests, off[0] <= 1e-6 + open_q[0], off[0] / 1e-6
        elif stop.arm is not None:
            near, tight = (off[1:] <= granted[1:]).all(), (off[1:] <= 1e-6 + open_q[1:]).all()
            distance = off[1:].max() / 1e-6
        else:
            X = PLANT.robot.forward(rows.q[i : i + 1])[0] @ TOOL
            away = max(np.linalg.norm(X[:3, 3] - stop.X_WT[:3, 3]) - frame.doubt_p[i], 0.0)
            angle = Rotation.from_matrix(X[:3, :3].T @ stop.X_WT[:3, :3]).magnitude()
            turned = max(angle - frame.doubt_R[i], 0.0)
            near = away <= 1e-6 + A_TCP * tau**2 / 2 and turned <= 1e-6 + alpha * tau**2 / 2
            tight, distance = away <= 1e-6 and turned <= 1e-6, max(away, turned) / 1e-6
        if stop.arm is not None and not met:
            distance = max(distance, abs(rows.q[i, 0] - stop.rail) / 1e-6)
        assert found.distance[k] == pytest.approx(distance, rel=1e-3, abs=1e-3)
        stands = not rapid or bool(
            (np.abs(rows.qd[i]) - rows.doubt_v[i] <= 1e-5 + PLANT.limits.acceleration * tau).all()
        )
        for name, value in zip(sets, (near, tight, rests, met, stands), strict=True):
            sets[name].append(bool(value))
    for name, values in sets.items():
        np.testing.assert_array_equal(getattr(found, name), values, err_msg=name)
        if name != "stands" or rapid:
            assert stop.rail is None or 0 < sum(values) < len(values) or name == "rail_met", name
    kept = candidate_rows(rows, frame, stop)
    every = closeness_at(rows, frame, stop, rapid)(np.arange(len(rows.t)))
    assert set(np.flatnonzero(every.near)) <= set(kept)
    if kind.startswith("pose"):
        X_WT = PLANT.robot.forward(rows.q) @ TOOL
        away = np.linalg.norm(X_WT[:, :3, 3] - stop.X_WT[:3, 3], axis=1) - frame.doubt_p
        np.testing.assert_array_equal(kept, np.flatnonzero(away <= 1e-6 + A_TCP * rows.open_time**2 / 2 + 1e-9))


def test_events_are_runs_of_near_rows() -> None:
    """Of every run, which ends where the rail leaves a position: first and last row; the tight ones of each of its
    unbroken stretches of good rows, or the closest; the closest that rests, or the closest of all; and whether it
    counts only by what is granted."""
    rng = np.random.default_rng(43)
    for _ in range(200):
        n = 30
        at_rows = np.sort(rng.choice(60, n, replace=False))
        near, tight, rests, met, stands = (rng.random(n) < share for share in (0.8, 0.4, 0.8, 0.9, 0.9))
        distance = rng.uniform(0, 1, n)
        found = events_of(Closeness(at_rows, distance, near, tight, rests, met, stands))
        runs: list[list[int]] = []
        for k in np.flatnonzero(near):
            left = runs and met[runs[-1][-1]] and not met[k]
            if runs and at_rows[k] == at_rows[runs[-1][-1]] + 1 and not left:
                runs[-1].append(int(k))
            else:
                runs.append([int(k)])
        assert len(found) == len(runs)
        for event, run in zip(found, runs, strict=True):
            assert (event.first, event.last) == (at_rows[run[0]], at_rows[run[-1]])
            good = [k for k in run if rests[k] and met[k] and stands[k]]
            stretches: list[list[int]] = []
            for k in good:
                if stretches and k == stretches[-1][-1] + 1:
                    stretches[-1].append(k)
                else:
                    stretches.append([k])
            core = []
            for one in stretches:
                core += [k for k in one if tight[k]] or [min(one, key=lambda k: distance[k])]
            assert event.good.tolist() == at_rows[core].tolist()
            pool = [k for k in run if rests[k]] or run
            assert event.best == at_rows[min(pool, key=lambda k: distance[k])]
            assert event.granted == (bool(core) and not any(tight[k] for k in core))
            assert event.end == (at_rows[core[-1]] if core else event.last)


def wander(seed: int, n: int = 400) -> tuple[Rows, ToolKinematics]:
    """A rail that goes to and fro, in gaps of different lengths."""
    rng = np.random.default_rng(seed)
    t = np.r_[0.0, np.cumsum(rng.choice([0.002, 0.008, 0.02], n - 1))]
    q = np.tile(PLANT.start, (n, 1))
    q[:, 0] = 0.5 + 0.06 * np.sin(3 * t) + 0.02 * np.sin(11 * t)
    rows = judged_rows(PLANT, Trajectory(PLANT.limits.names, t, q), Resolution(0.0, np.full(7, 1e-6), np.zeros(7)))
    return rows, ToolKinematics(rows, TOOL)


@pytest.mark.parametrize("block", [4, 64])
@pytest.mark.parametrize(("radius", "aside"), [(0.01, 0.0), (0.01, 0.0099), (0.02, 0.0), (0.003, 0.0), (0.001, 0.01)])
def test_a_point_is_passed_where_chords_come_near_its_zone(
    radius: float, aside: float, block: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each run of intervals whose chords come as near as the zone and what the tool may be off its chord; two of them
    are one where the tool is not farther away in between."""
    monkeypatch.setattr(rows_module, "BLOCK", block)
    rows, frame = wander(44)
    X = at(0.52)
    X[:3, 3] += [0.0, 0.0, aside]
    passed = point(X_WF=X, fly_by=FlyBy(radius, radius, radius))
    P, size = passed.X_WT[:3, 3], radius + tol.STOP_POSITION
    p = (PLANT.robot.forward(rows.q) @ TOOL)[:, :3, 3]
    distance = []
    for a, b in pairwise(p):
        share = np.clip((P - a) @ (b - a) / max((b - a) @ (b - a), 1e-300), 0, 1)
        distance.append(np.linalg.norm(a + share * (b - a) - P))
    reach = A_TCP * (np.diff(rows.t) + rows.unsure(slice(None, -1), slice(1, None))) ** 2 / 8 + 0.0
    reach = reach + np.maximum(frame.doubt_p[1:], frame.doubt_p[:-1])
    near = np.flatnonzero(np.array(distance) <= size + reach)
    runs: list[list[int]] = []
    for i in near.tolist():
        if runs:
            k = runs[-1][-1]
            away = np.linalg.norm(p[k + 1 : i + 1] - P, axis=1).max() > size + max(reach[k], reach[i])
            if i == k + 1 or not away:
                runs[-1].append(i)
                continue
        runs.append([i])
    found = passages(rows, frame, passed)
    assert [(e.first, e.last) for e in found] == [(run[0], run[-1] + 1) for run in runs]
    best = [min(run, key=lambda i: distance[i]) for run in runs]
    assert [e.best for e in found] == best
    assert [e.good.tolist() for e in found] == [[max(i - 1, 0)] for i in best]
    assert (len(found) > 1) == (aside <= 0.0099)


@pytest.mark.parametrize(("short", "passed"), [(0.5e-6, True), (1.5e-6, False)])
def test_a_zone_is_passed_within_a_micrometre(short: float, passed: bool) -> None:
    """Where a zone ends so much short of the nearest chord and what the tool may be off it."""
    rows, frame = wander(44)
    X = at(0.52)
    X[:3, 3] += [0.0, 0.0, 0.02]
    P = (X @ point(X_WF=X).X_FT)[:3, 3]
    p = (PLANT.robot.forward(rows.q) @ TOOL)[:, :3, 3]
    t = np.linspace(0, 1, 20001)[:, None]
    distance = [float(np.linalg.norm(a + t * (b - a) - P, axis=1).min()) for a, b in pairwise(p)]
    reach = A_TCP * (np.diff(rows.t) + rows.unsure(slice(None, -1), slice(1, None))) ** 2 / 8
    least = float(np.min(distance - reach - np.maximum(frame.doubt_p[1:], frame.doubt_p[:-1])))
    radius = least - short
    assert bool(passages(rows, frame, point(X_WF=X, fly_by=FlyBy(radius, radius, radius)))) == passed


def test_an_arcs_end_is_passed_on_its_second_half() -> None:
    """Half a circle whose zone reaches round to its first half: only what is on the second half comes near its end."""
    X_0, X_2 = P1, P2
    motion = move_c(13, "p_2", VIA, X_2, zone=Z10)
    start = point(X_WF=X_0, X_FT=np.eye(4))
    end = point(X_WF=X_2, X_FT=np.eye(4), move=motion, fly_by=FlyBy(0.055, 0.055, 0.055))
    end = replace(end, curve=path_to(start.X_WF, end))
    circle = end.curve
    assert circle is not None
    phi = np.linspace(0, 1, 61)
    rows, _ = wander(45, 61)

    class Drawn(ToolKinematics):
        """A tool on the circle, whatever the axes do."""

        @property
        def p(self) -> Array:
            return circle.at(phi)[0]

    frame = Drawn(rows, np.eye(4))
    (event,) = passages(rows, frame, end)
    assert event.last == 60
    halves = circle.progress(frame.p)
    assert abs(halves[event.first] - 0.5) < 1.01 / 60
    assert len(passages(rows, frame, replace(end, curve=None))) == 1
    assert passages(rows, frame, replace(end, curve=None))[0].first < event.first


def test_optional_points_that_the_tool_never_comes_to() -> None:
    """No chord comes as near as the zone, a micron, and what the tool may be off it."""
    rows, frame = wander(46)
    highest = rows.q[:, 0].max()
    i = int(np.argmax(rows.q[:, 0]))
    reach = min(frame.reach[max(i - 1, 0)], frame.reach[i])
    most = max(frame.reach[max(i - 1, 0)], frame.reach[i])
    for zone in (0.0, 0.01):
        for off, missing in ((zone + 1e-6 + 0.99 * reach, False), (zone + 1e-6 + 1.01 * most, True)):
            move = replace(move_j(11, "p", at(highest + off)), zone=replace(Z10, radius=zone))
            one = point(index=7, move=move, X_WF=at(highest + off), optional=True)
            frames = {np.asarray(TOOL).tobytes(): frame}
            assert waypoint_matching.never_near(rows, frames, [one]) == ({7} if missing else set())
            assert waypoint_matching.never_near(rows, frames, [replace(one, optional=False)]) == set()


def test_squares_and_chords() -> None:
    p = np.array([[0.0, 0, 0], [1, 0, 0], [1, 0, 0], [1, 2, 0]])
    distance, share = waypoint_matching.off_chords(p, np.array([0.25, 1.0, 0]), np.arange(3))
    np.testing.assert_allclose(distance, [1.0, np.hypot(0.75, 1.0), 0.75])
    np.testing.assert_allclose(share, [0.25, 0.0, 0.5])
    np.testing.assert_allclose(waypoint_matching.off_chords(p, np.array([-3.0, 4, 0]), np.array([0]))[0], 5.0)


def test_points_alike_share_what_is_found_and_others_do_not() -> None:
    """One place with other rails, tools or zones is another point."""
    ride = Ride(((0.0, 4), (0.5, 6), (0.2, 5)))
    asked = [move_j(11, "p", at(0.5)), move_j(12, "p", at(0.5)), move_ext(13, 0.5), move_ext(14, 0.2), home(15, 0.2)]
    line, _ = seen(Case(PLANT, program(*asked), ()), ride.rows(), None)
    found = [visit.match for visit in line.visits[1:]]
    assert found[0].events is found[1].events
    assert found[2].events is not found[3].events
    assert [one.event.first for one in found] == [10, 10, 10, 22, 0]  # joints are those of home all the time
    assert all(f.passed for f in stops_of(asked, ride.rows()))
