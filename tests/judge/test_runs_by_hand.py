"""Motions from stop to stop with all that is passed between: on which way and in which zone every place is, and how far
it is off, against definitions written out one place after the other and the segments that plans are made of."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from by_hand import seen
from legal_motion import Case, program
from legal_runs import RAILS, RUNS, Z0, contour, joint_line
from scipy.spatial.transform import Rotation

from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.judge import tolerances as tol
from trajopt_cli.judge.caps import check_caps
from trajopt_cli.judge.geometry import Arc, off_triangles
from trajopt_cli.judge.lines import check_shapes
from trajopt_cli.judge.path_segments import StopInterval, runs_of
from trajopt_cli.motion import Motion, MoveC, MoveL, Speed
from trajopt_cli.path.arc import Arc as PlannedArc
from trajopt_cli.path.line import Line as PlannedLine
from trajopt_cli.trajectory import Trajectory

FILES = [
    (name, kind) for name in ("line-line", "two turns", "line-arc", "joint-line", "rail") for kind in ("own", "bare")
]


@cache
def run_of(name: str, kind: str) -> tuple[Case, StopInterval, list[Finding]]:
    """The run of a case whose axes are off by a little at random, as a RAPID controller's: with all that is said of its
    shape."""
    case, rng = RUNS[name](), np.random.default_rng(71)
    rows = case.rows(step=0.004) if kind == "own" else case.rows(step=0.008, grid_only=True)
    k, n = len(rows.names), len(rows.t)
    moving = np.abs(rows.qd).max(axis=1, keepdims=True) > 1e-3
    q = rows.q + 3e-6 * rng.normal(size=(n, k)) * moving
    steps = Resolution(0.0, rng.uniform(1e-9, 4e-7, (n, k)), rng.uniform(1e-9, 1e-7, (n, k)))
    file = Trajectory(rows.names, rows.t, q, rows.qd)
    line, frames = seen(case, file, steps, rapid=True)
    assert line.rows.exact == (kind == "own")
    run = max(runs_of(line, frames), key=lambda one: len(one.visits))
    found = [f for _, some in check_shapes(line, frames, True) for f in some]
    lines = [visit.point.source.line for visit in run.visits[1:]]
    return case, run, [f for f in found if f.source.line in lines]


def ways_of(run: StopInterval) -> list[PlannedLine | PlannedArc | None]:
    """The segments of the run."""
    X = [visit.X_WF @ run.frame.X_FT for visit in run.visits]
    out: list[PlannedLine | PlannedArc | None] = []
    for k, visit in enumerate(run.visits[1:]):
        move = visit.point.move
        if isinstance(move, MoveC):
            out.append(PlannedArc.through(X[k], move.X_WV[:3, 3], X[k + 1]))
        else:
            out.append(PlannedLine(X[k], X[k + 1]) if isinstance(move, MoveL) else None)
    return out


def passed(run: StopInterval) -> list[float]:
    """Where the points are passed: in places, and shares of the chord to the next one."""
    out, p = [], run.places.p
    for k, visit in enumerate(run.visits[1:-1], start=1):
        P = run.X_WT[k, :3, 3]
        first, last = ((row - run.part[0]) * run.step for row in (visit.event.first, visit.event.last))
        best = (np.inf, 0.0)
        for i in range(max(first, int(out[-1]) if out else 0), min(last, len(p) - 1)):
            way = p[i + 1] - p[i]
            share = float(np.clip((P - p[i]) @ way / (way @ way), 0, 1))
            best = min(best, (float(np.linalg.norm(p[i] + share * way - P)), i + share))
        out.append(best[1])
    return out


@pytest.mark.parametrize(("name", "kind"), FILES)
def test_which_way_and_which_zone(name: str, kind: str) -> None:
    """A place is on the way between the points that it lies between; in a zone within its radius, of the point behind
    on the first half of a way and of the one ahead on the second. One beside a point that is in no zone is open."""
    _, run, _ = run_of(name, kind)
    first, last = run.visits[0].depart, run.visits[-1].arrive
    assert run.part == ((first, last) if kind == "own" else (first + 1, last - 1))
    assert run.step == (5 if kind == "own" else 1)
    moments, p, paths = passed(run), run.places.p, ways_of(run)
    np.testing.assert_allclose(run._passing_places, moments, atol=1e-6)
    zones = [visit.point.fly_by for visit in run.visits]
    radius = [0.0 if zone is None else zone.radius for zone in zones]
    edges = [run.on(leg) for leg in range(len(paths))]
    assert edges[0].start == 0
    assert [one.stop for one in edges] == [*(one.start for one in edges[1:]), len(p)]
    in_zone = 0
    for i in range(len(p)):
        leg = sum(moment <= i for moment in moments)
        (found,) = (k for k, one in enumerate(edges) if one.start <= i < one.stop)
        way, place = paths[leg], None
        margin = tol.LINE_POSITION + run.places.doubt_p[i]
        s = run.paths[leg].progress(p[i : i + 1], run.places.R[i : i + 1])[0] if way is not None else None
        off = [float(np.linalg.norm(p[i] - run.X_WT[k, :3, 3])) for k in (leg, leg + 1)]
        inside = [k for k, one in zip((leg, leg + 1), off, strict=True) if radius[k] > 0 and one <= radius[k] + margin]
        if s is not None:
            inside = [k for k in inside if (k == leg) == (s < 0.5)]
        place = min(inside, key=lambda k: off[k - leg]) if inside else -1
        open_ = sum(m <= i - 1 for m in moments) < sum(m < i + 1 for m in moments) and place < 0
        assert run.sure[i] == (not open_)
        if open_:
            continue
        assert found == leg, i
        assert run.zone[i] == place, i
        in_zone += place >= 0
        if s is None:
            assert np.isnan(run.fractions[i])
        else:
            assert run.fractions[i] == pytest.approx(s, abs=1e-12)
    assert 3 < in_zone < len(p)


@pytest.mark.parametrize("name", ["contour", "joint-line"])
def test_places_beside_small_zones_between_two_rows(name: str) -> None:
    """A place that may be before a point or behind it: in the first zone whose sphere it is in, else on the first way
    that explains it, a joint move, or the nearest, not before the places before it."""
    case = contour(60, Z0) if name == "contour" else joint_line(Z0)
    line, frames = seen(case, case.rows(step=0.02, grid_only=True), None)
    run = max(runs_of(line, frames), key=lambda one: len(one.visits))
    moments, p, R, paths = run._passing_places, run.places.p, run.places.R, run.paths
    radius, before, open_ones = run.zones("radius"), 0, 0
    own = np.array([next(leg for leg in range(len(paths)) if run.on(leg).start <= i < run.on(leg).stop)
                    for i in range(len(p))])  # fmt: skip
    for i in np.flatnonzero(~run.sure):
        least, most = sum(m <= i - 1 for m in moments), sum(m < i + 1 for m in moments)
        least, margin = max(least, before), tol.LINE_POSITION + run.places.doubt_p[i]
        sphere = [k for k in range(least + 1, most + 1)
                  if radius[k] > 0 and np.linalg.norm(p[i] - run.X_WT[k, :3, 3]) <= radius[k] + margin]  # fmt: skip
        off = {}
        for leg in range(least, most + 1):
            if (way := paths[leg]) is not None:
                s = np.clip(way.progress(p[i : i + 1], R[i : i + 1]), 0, 1)
                off[leg] = float(np.linalg.norm(p[i] - way.at(s)[0][0]))
        explained = [leg for leg, one in off.items() if one <= margin]
        joint = [leg for leg in range(least, most + 1) if paths[leg] is None]
        wanted = sphere[0] if sphere else [*explained, *joint, *sorted(off, key=off.__getitem__)][0]
        assert own[i] == max(wanted, own[i - 1] if i else 0)
        assert run.zone[i] == (sphere[0] if sphere else -1)
        before, open_ones = wanted, open_ones + 1
    assert open_ones > (20 if name == "contour" else 0)


@pytest.mark.parametrize(("name", "kind"), FILES)
def test_zones_along_a_way(name: str, kind: str) -> None:
    """Of orientation and of external axes: so far along the way from either end; a line is never outside within the
    sphere. Their edges are places on the segment."""
    _, run, _ = run_of(name, kind)
    zones = [visit.point.fly_by for visit in run.visits]
    for leg, way in enumerate(ways_of(run)):
        if way is None:
            assert (run.turning_zone[run.on(leg)] == run.zone[run.on(leg)]).all()
            continue
        part = run.on(leg)
        for kind_of in ("radius", "turning", "external"):
            sizes = [-1.0 if zone is None else getattr(zone, kind_of) for zone in zones]
            assert run.zones(kind_of).tolist() == sizes
            wanted = []
            for i in range(part.start, part.stop):
                done = run.fractions[i] * way.length
                along = leg if done <= sizes[leg] else leg + 1 if way.length - done <= sizes[leg + 1] else -1
                wanted.append(run.zone[i] if isinstance(way, PlannedLine) and run.zone[i] >= 0 else along)
            np.testing.assert_array_equal(run.beyond(leg, kind_of), np.array(wanted) < 0)
            if kind_of == "turning":
                np.testing.assert_array_equal(run.turning_zone[part], wanted)
            for visit in (leg, leg + 1):
                if zones[visit] is not None:
                    share = sizes[visit] / way.length
                    X = way.pose(np.array([share if visit == leg else 1.0 - share]))[0]
                    p, R = run.edge(leg, visit, kind_of)
                    np.testing.assert_allclose(p, X[:3, 3], atol=1e-12)
                    np.testing.assert_allclose(R, X[:3, :3], atol=1e-9)


def told(found: Sequence[Finding], check: str, line: int) -> Finding | None:
    return next((f for f in found if f.check == check and f.source.line == line), None)


def agrees(found: Finding | None, values: Array, times: Array, limit: float) -> None:
    """A finding has the greatest of the values, and its time."""
    if not len(values):
        assert found is None
        return
    assert found is not None
    i = int(np.argmax(values))
    value = max(float(values[i]), 0.0)
    assert (found.value, found.limit) == (pytest.approx(value, rel=1e-5, abs=1e-11), limit)
    assert found.passed == (value <= limit)
    if value > 1e-9:
        assert found.time == pytest.approx(times[i])


@pytest.mark.parametrize(("name", "kind"), FILES)
def test_how_far_places_are_off_their_way(name: str, kind: str) -> None:
    """Outside zones: from chord or circle, from the slerp at the same share, and behind the farthest place before."""
    _, run, found = run_of(name, kind)
    places = run.places
    for leg, way in enumerate(ways_of(run)):
        if way is None:
            continue
        line, word = run.visits[leg + 1].point.source.line, "arc" if isinstance(way, PlannedArc) else "line"
        at = np.arange(len(places.t))[run.on(leg)]
        X = way.pose(np.clip(run.fractions[at], 0.0, 1.0))
        free, doubt = run.zone[at] < 0, places.doubt_p[at]
        off = np.linalg.norm(places.p[at] - X[:, :3, 3], axis=1) - doubt
        agrees(told(found, f"{word} position", line), np.where(free, off, 0.0), places.t[at], tol.LINE_POSITION)
        turned = Rotation.from_matrix(np.swapaxes(places.R[at], 1, 2) @ X[:, :3, :3]).magnitude()
        angle = Rotation.from_matrix(X[0, :3, :3].T @ X[0, :3, :3]).magnitude()
        angle = Rotation.from_matrix(way.pose(np.zeros(1))[0, :3, :3].T @ way.pose(np.ones(1))[0, :3, :3]).magnitude()
        turned = turned - places.doubt_angle[at] - angle / way.length * doubt
        agrees(told(found, f"{word} rotation", line), np.where(run.beyond(leg, "turning"), turned, 0.0), places.t[at],
               tol.LINE_ROTATION)  # fmt: skip
        done, farthest, back = run.fractions[at] * way.length, -np.inf, []
        for one, counts in zip(done, free, strict=True):
            farthest = max(farthest, one) if counts else farthest
            back.append(farthest - one if counts else 0.0)
        agrees(told(found, f"{word} progress", line), np.where(free, back - 2 * doubt, 0.0), places.t[at], tol.BACKWARD)


@pytest.mark.parametrize(("name", "kind"), FILES)
def test_how_far_places_are_outside_their_corner(name: str, kind: str) -> None:
    """Between two lines from the triangle of entry, point and exit; of any two ways their orientations, as rotation
    vectors seen from the point, but for a sixteenth of the turns' cross product and a hair at the edge."""
    _, run, found = run_of(name, kind)
    places, paths = run.places, ways_of(run)
    for k in range(1, len(run.visits) - 1):
        line, before, after = run.visits[k].point.source.line, paths[k - 1], paths[k]
        P, R = run.X_WT[k, :3, 3], run.X_WT[k, :3, :3]
        here = np.flatnonzero(run.zone == k)
        if isinstance(before, PlannedLine) and isinstance(after, PlannedLine):
            ends = [run.edge(leg, k, "radius")[0] for leg in (k - 1, k)]
            full = [np.tile(x, (len(here), 1)) for x in (ends[0], P, ends[1])]
            off = off_triangles(places.p[here], *full) - places.doubt_p[here]
            agrees(told(found, "corner position", line), off, places.t[here], tol.LINE_POSITION)
        else:
            assert told(found, "corner position", line) is None
        if before is None or after is None:
            assert told(found, "corner rotation", line) is None
            continue
        here = np.flatnonzero(run.turning_zone == k)
        a, b = (Rotation.from_matrix(R.T @ run.edge(leg, k, "turning")[1]).as_rotvec() for leg in (k - 1, k))
        seen_from = Rotation.from_matrix(R.T @ places.R[here]).as_rotvec()
        full = [np.tile(x, (len(here), 1)) for x in (a, np.zeros(3), b)]
        size = run.zones("turning")[k]
        granted = np.linalg.norm(np.cross(a, b)) / 16 + places.doubt_angle[here]
        granted += tol.LINE_POSITION / size * max(np.linalg.norm(a), np.linalg.norm(b))
        agrees(told(found, "corner rotation", line), off_triangles(seen_from, *full) - granted, places.t[here],
               tol.LINE_ROTATION)  # fmt: skip


@pytest.mark.parametrize("kind", ["own", "bare"])
def test_how_far_a_rail_is_out_of_proportion(kind: str) -> None:
    """At rows outside the zones of external axes: between where it is at a stop, or at the first or last of those rows,
    in proportion to the way."""
    _, run, found = run_of("rail", kind)
    rows, a_rail = run.rows, float(run.rows.plant.limits.acceleration[0])
    for leg, way in enumerate(run.paths):
        before, visit = run.visits[leg : leg + 2]
        at = [i for i in range(run.on(leg).start, run.on(leg).stop) if i % run.step == 0]
        outside = run.beyond(leg, "external")
        at = np.array([i for i in at if outside[i - run.on(leg).start]])
        where = run.part[0] + at // run.step
        s, d = run.fractions[at], rows.q[where, 0]
        (s_0, d_0), (s_1, d_1) = (s[0], d[0]), (s[-1], d[-1])
        if before.point.fly_by is None:
            s_0, d_0 = 0.0, rows.q[before.depart, 0]
        if visit.point.fly_by is None:
            s_1, d_1 = 1.0, rows.q[visit.arrive, 0]
        slope = (d_1 - d_0) / (s_1 - s_0)
        tau = max((rows.open_time[row] for one, row in ((before, before.depart), (visit, visit.arrive))
                   if one.point.fly_by is None), default=0.0)  # fmt: skip
        ends = max(rows.doubt_q[before.depart, 0], rows.doubt_q[visit.arrive, 0]) / 2 + a_rail * tau**2 / 2
        granted = ends + rows.doubt_q[where, 0] / 2 + 2 * abs(slope) * run.places.doubt_p[at] / way.extent
        off = np.abs(d - d_0 - (np.clip(s, 0.0, 1.0) - s_0) * slope) - granted
        word = "arc" if isinstance(way, Arc) else "line"
        agrees(told(found, f"rail along {word}", visit.point.source.line), off, rows.t[where], tol.JOINT_TARGET)
    assert len(RAILS) == len(run.visits)


@pytest.mark.parametrize("kind", ["own", "bare"])
def test_how_far_a_joint_move_is_off_its_line(kind: str) -> None:
    """Outside zones, at rows that are on it beyond doubt: from the line between the axes where it begins and ends, each
    axis by its speed; rounding of all of them enters the share of the way."""
    _, run, found = run_of("joint-line", kind)
    rows, weight = run.rows, 1 / run.rows.plant.limits.velocity
    for leg in (0, 2):
        before, visit = run.visits[leg : leg + 2]
        at = np.array([i for i in range(run.on(leg).start, run.on(leg).stop)
                       if i % run.step == 0 and run.zone[i] < 0 and run.sure[i]])  # fmt: skip
        where = run.part[0] + at // run.step
        q_0 = rows.q[before.depart if before.point.fly_by is None else where[0]]
        q_1 = rows.q[visit.arrive if visit.point.fly_by is None else where[-1]]
        tau = max((rows.open_time[row] for one, row in ((before, before.depart), (visit, visit.arrive))
                   if one.point.fly_by is None), default=0.0)  # fmt: skip
        ends = np.maximum(rows.doubt_q[before.depart], rows.doubt_q[visit.arrive]) / 2
        ends = ends + rows.plant.limits.acceleration * tau**2 / 2
        way, off = (q_1 - q_0) * weight, []
        for i in where:
            share = ((rows.q[i] - q_0) * weight) @ way / (way @ way)
            open_share = (rows.doubt_q[i] / 2 * weight) @ np.abs(way) / (way @ way)
            granted = rows.doubt_q[i] / 2 + 2 * ends + open_share * np.abs(q_1 - q_0)
            off.append(np.abs(rows.q[i] - q_0 - np.clip(share, 0, 1) * (q_1 - q_0)) - granted)
        worst = np.max(off, axis=1)
        one = told(found, "joint line", visit.point.source.line)
        agrees(one, worst, rows.t[where], tol.JOINT_TARGET)
        if worst.max() > 1e-9:
            assert one.subject == rows.plant.limits.names[int(np.argmax(np.array(off)[int(np.argmax(worst))]))]


@pytest.mark.parametrize("faster", [1, 2])
def test_in_a_corner_the_higher_of_both_speeds_holds(faster: int) -> None:
    """From the last row outside the zone before the point to the first one behind it, each part of the speed by its own
    zone; nothing where one of both moves has a time of its own."""
    case = RUNS["rail"]()
    rows = case.rows(step=0.004)
    names = {1: "slow", 2: "slow"} | {faster: "fast"}
    speeds = {"slow": Speed("slow", 0.05, 0.2, 0.03, 1.0), "fast": Speed("fast", 0.1, 0.3, 0.05, 1.0)}
    motions = list(case.program.motions)
    for i, name in names.items():
        motions[i] = replace(motions[i], speed=speeds[name])

    def told(asked: Sequence[Motion]) -> dict[tuple[str, str], Finding]:
        line, frames = seen(replace(case, program=program(*asked)), rows, None)
        found = [f for _, some in check_caps(line, frames) for f in some]
        return {(f.check, f.subject): f for f in found if " at MoveL p_1 " in f.message}

    found = told(motions)
    P = motions[1].X_WT[:3, 3]
    p = case.plant.robot.forward(rows.q)[:, :3, 3]
    middle = int(np.argmin(np.linalg.norm(p - P, axis=1)))
    V = (case.plant.robot.jacobian(rows.q) @ rows.qd[..., None])[..., 0]
    for key, size, value in (
        (("programmed speed", "TCP"), 0.01, np.linalg.norm(V[:, :3], axis=1)),
        (("programmed reorientation", "TCP"), 0.015, np.linalg.norm(V[:, 3:], axis=1)),
        (("programmed speed", "rail"), 0.015, np.abs(rows.qd[:, 0])),
    ):
        far = np.linalg.norm(p - P, axis=1) > size
        a = next(i for i in range(middle, 0, -1) if far[i])
        b = next(i for i in range(middle, len(far)) if far[i])
        top = value[a : b + 1].max()
        limit = {"TCP": 0.1, "rail": 0.05}[key[1]] if key[0] == "programmed speed" else 0.3
        assert (key in found) == (top > limit)
        if key in found:
            one = found[key]
            assert (one.value, one.limit) == (pytest.approx(top, rel=2e-3), limit)
            assert rows.t[a] - 1e-9 <= one.time <= rows.t[b] + 1e-9
            assert "at MoveL p_1 fast allows" in one.message
            assert one.source == motions[1].source
    assert ("programmed speed", "TCP") in found
    paths = [float(np.linalg.norm(b.X_WT[:3, 3] - a.X_WT[:3, 3])) for a, b in pairwise(motions[:3])]
    paths[1] *= np.pi / 2  # half a circle
    top = found["programmed speed", "TCP"].value
    for i, way in enumerate(paths, 1):  # a time is the speed that takes so long over the whole way
        for allowed in (0.08, 1.1 * top):
            timed = list(motions)
            timed[i] = replace(timed[i], duration=way / allowed)
            one = told(timed).get(("programmed speed", "TCP"))
            limit = max(allowed, 0.1 if i != faster else 0.05)
            assert (one is not None) == (top > limit)
            assert one is None or (one.value, one.limit) == (top, pytest.approx(limit))
