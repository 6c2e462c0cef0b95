"""When a file is where: arrivals, departures, waits and what is left over of a rest, row by row; and of any events the
choice that is worth most, by trying all of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import product
from types import SimpleNamespace

import numpy as np
import pytest
from by_hand import H, Ride, at, one_of, seen, stops_of
from legal_motion import Case, move_j, move_l, plant_with_rail, program, wait
from legal_runs import Z10

from trajopt_cli.judge import waypoint_matching
from trajopt_cli.judge.program_points import ProgramPoint
from trajopt_cli.judge.timeline import Timeline, Visit, outside_zones, rows_of_move, rows_of_run, tool_corner
from trajopt_cli.judge.waypoint_matching import Event
from trajopt_cli.motion import FlyBy, Motion
from trajopt_cli.trajectory import Trajectory

PLANT = plant_with_rail()
END = move_j(99, "p_99", at(0.2))


def timeline(motions: Sequence[Motion], ride: Ride | Trajectory, marked: bool = True, rapid: bool = False) -> Timeline:
    rows = ride.rows() if isinstance(ride, Ride) else ride
    return seen(Case(PLANT, program(*motions, END), ()), rows, None, rapid, marked)[0]


def when(visit: Visit) -> tuple[int, int, float, list[tuple[float, float]]]:
    """First and last row, when the next move may begin, and the waits, in gaps between rows."""
    holds = [(round(one.begin / H, 6), round(one.end / H, 6)) for one in visit.holds]
    return visit.arrive, visit.depart, round(visit.ready / H, 6), holds


@pytest.mark.parametrize("marked", [True, False])
def test_stops_that_share_a_rest(marked: bool) -> None:
    """A wait, a move that stays and takes its time, another wait: one after the other from the first row on; where
    boundaries have no rows the rest may have begun, and may end, two gaps beside its rows."""
    ride = Ride(((0.0, 4), (0.5, 16), (0.2, 5)))
    f, last = int(ride.first[1]), int(ride.last[1])
    for whole in (True, False):
        T = 4.0 if whole else 4.5  # gaps
        asked = [
            move_j(11, "p_11", at(0.5)), wait(12, 3 * H), move_l(13, "p_13", at(0.5), duration=T * H), wait(14, 2 * H),
            wait(15, H),
        ]  # fmt: skip
        line = timeline(asked, ride, marked)
        start, first, stays, end = line.visits
        assert when(start) == (0, 3, 0.0, [])
        # the rest goes on beyond what the first stop needs: it ends where the second one begins
        least = 3 + T
        arrive = f + int(np.ceil(least - (0 if marked else 2)))
        assert when(first) == (f, max(arrive, f), f + 3.0, [(f, f + 3)])
        assert when(stays) == (
            arrive,
            last,
            f + least + 3,
            [(f + least, f + least + 2), (f + least + 2, f + least + 3)],
        )
        assert (first.stay, stays.stay, end.stay) == (False, True, False)
        assert stays.at_once_after(first)
        assert not end.at_once_after(stays)
        assert not replace(stays, event=None).at_once_after(first)
        assert not stays.at_once_after(replace(first, event=None))
        assert [tuple(one.point.index for one in run) for run in line.runs()] == [(-1, 0), (2, 5)]
        np.testing.assert_allclose(stays.X_WF, at(0.5), atol=1e-12)


@pytest.mark.parametrize("marked", [True, False])
@pytest.mark.parametrize("more", [-1e-9, 1e-9])
def test_waits_before_the_first_move(marked: bool, more: float) -> None:
    ride = Ride(((0.0, 9), (0.5, 6), (0.2, 5)))
    slack = 1e-9 + (0 if marked else 2 * H)
    asked = [wait(10, 3 * H), wait(11, 5 * H + slack + 0.9 * more), move_j(12, "p_12", at(0.5))]
    start = timeline(asked, ride, marked).visits[0]
    assert when(start)[:2] == (0, 8)
    assert when(start)[3][0] == (0.0, 3.0)
    assert start.ready == pytest.approx(start.holds[1].end)
    found = one_of(stops_of([*asked, END], ride.rows(), marked), "dwell length", 11)
    assert (found.value, found.time) == (pytest.approx(5 * H), pytest.approx(3 * H))
    assert found.passed == (more < 0)


def test_a_start_that_does_not_rest_is_one_row() -> None:
    ride = Ride(((0.0, 4), (0.5, 6), (0.2, 5)))
    rows = ride.rows()
    qd = rows.qd.copy()
    qd[:4, 0] = 2e-5
    start = timeline([move_j(11, "p_11", at(0.5))], replace(rows, qd=qd)).visits[0]
    assert when(start) == (0, 0, 0.0, [])
    qd[2, 0] = 0.0  # what rests there is not the first row, but it is in the same event
    assert timeline([move_j(11, "p_11", at(0.5))], replace(rows, qd=qd)).visits[0].depart == 2


@pytest.mark.parametrize("back", [7, 8, 9, 12])
def test_a_stop_that_is_left_and_reached_again(back: int) -> None:
    """Within the time of its waits that is one stop, which ends with the later rest; later it is none."""
    ride = Ride(((0.0, 4), (0.5, 16), (0.2, 5)))
    f, last = int(ride.first[1]), int(ride.last[1])
    rows = ride.rows()
    q = rows.q.copy()
    q[f + 4 : f + back, 0] += 1e-3
    for wanted in (3, 8, 30):
        asked = [move_j(11, "p_11", at(0.5)), wait(12, wanted * H)]
        visit = timeline(asked, replace(rows, q=q)).visits[1]
        again = wanted > 3 and back <= wanted
        assert (visit.arrive, visit.depart) == (f, last if again else f + 3)
        if again:
            drift = one_of(stops_of(asked, replace(rows, q=q), True), "dwell drift", 12)
            assert (drift.value, drift.passed) == (pytest.approx(1e-3, rel=1e-6), False)


@pytest.mark.parametrize("marked", [True, False])
def test_points_that_are_passed(marked: bool) -> None:
    """Between the rows whose chord comes nearest; of two within one gap the second one a row on."""
    ride = Ride(((0.0, 4), (0.5, 6), (0.2, 5)), between=40)
    way = 0.5 / 41
    places = [0.1 + 0.3 * way, 0.1 + 0.6 * way, 0.31]
    asked = [move_j(11 + k, f"p_{11 + k}", at(d), zone=replace(Z10, radius=1e-3 if k < 2 else 0.02))
             for k, d in enumerate(places)]  # fmt: skip
    line = timeline([*asked, move_j(14, "p_14", at(0.5))], ride, marked)
    before = 0
    for visit, d in zip(line.visits[1:4], places, strict=True):
        row = max(3 + int(d / way), before)
        assert (visit.arrive, visit.depart) == (row, row + 1)
        assert visit.ready == pytest.approx(ride.t[row])
        assert visit.point.fly_by is not None
        assert not visit.stay
        before = visit.depart
    (run, end) = line.runs()
    assert [one.point.index for one in run] == [-1, 0, 1, 2, 3]
    assert len(end) == 2


def test_rows_of_runs_and_moves() -> None:
    """Where no row stands at a rest, its nearest row is not on the way yet, if there are others."""

    def visit(arrive: int, depart: int, fly_by: FlyBy | None = None) -> Visit:
        return SimpleNamespace(arrive=arrive, depart=depart, point=SimpleNamespace(fly_by=fly_by))  # type: ignore[return-value]

    zone = FlyBy(0.1, 0.1, 0.1)
    for marked in (True, False):
        rows = SimpleNamespace(marked=marked)
        for n, inner in ((2, False), (3, True), (9, True)):
            inner = inner and not marked
            a, b = visit(0, 5), visit(5 + n, 40)
            assert rows_of_run(rows, [a, visit(6, 7, zone), b]) == ((6, 4 + n) if inner else (5, 5 + n))
            assert rows_of_move(rows, a, b) == ((6, 4 + n) if inner else (5, 5 + n))
            passed = visit(0, 5, zone), visit(5 + n, 40, zone)
            assert rows_of_move(rows, passed[0], b) == ((5, 4 + n) if inner else (5, 5 + n))
            assert rows_of_move(rows, a, passed[1]) == ((6, 5 + n) if inner else (5, 5 + n))
            assert rows_of_move(rows, *passed) == (5, 5 + n)


def test_rows_outside_zones() -> None:
    """From the first row farther than the zone of the point before to the last one farther than that of the point
    behind; the last before the first where there is none."""
    p = np.zeros((40, 3))
    p[:, 0] = np.linspace(0, 0.39, 40)
    frame = SimpleNamespace(p=p, rows=SimpleNamespace(marked=True))

    def visit(row: int, zone: FlyBy | None) -> Visit:
        X = np.eye(4)
        X[:3, 3] = p[row] + [0.001, 0, 0]
        return SimpleNamespace(arrive=row, depart=row, point=SimpleNamespace(fly_by=zone, X_WT=X))  # type: ignore[return-value]

    zone = FlyBy(0.05, 0.08, 0.3)
    a, b = visit(2, zone), visit(35, zone)
    for kind, size in (("radius", 0.05), ("turning", 0.08)):
        first = next(i for i in range(2, 36) if p[i, 0] - p[2, 0] - 0.001 > size)
        last = next(i for i in range(35, 1, -1) if p[35, 0] + 0.001 - p[i, 0] > size)
        assert outside_zones(frame, a, b, kind) == (first, last)
        assert outside_zones(frame, a, b, kind, first=False) == (2, last)
        assert outside_zones(frame, a, b, kind, last=False) == (first, 35)
        assert outside_zones(frame, visit(2, None), b, kind) == (2, last)
        assert outside_zones(frame, a, visit(35, None), kind) == (first, 35)
    whole = zone._replace(external=0.5)
    begin, end = outside_zones(frame, visit(2, whole), visit(35, whole), "external")
    assert end < begin
    begin, end = outside_zones(frame, visit(2, whole), visit(35, None), "external")
    assert end < begin
    begin, end = outside_zones(frame, visit(2, None), visit(35, whole), "external")
    assert end < begin


@pytest.mark.parametrize(
    ("rows", "place", "wanted"),
    [
        ((), 0.0, (15, 25)),
        ((26, 27), 0.05, (15, 27)),  # it lags behind: two rows more in its zone
        ((21, 22), 0.14, (15, 25)),  # it comes from farther away than its zone reaches, but from where it was
        ((21, 22), 0.34, (15, 21)),  # it goes astray: nothing is granted
        (range(21, 41), 0.14, (15, 21)),  # it never comes
    ],
)
def test_a_corner_in_which_the_tool_changes(rows: Sequence[int], place: float, wanted: tuple[int, int]) -> None:
    """The flange moves by 10 mm from row to row through a point at row 20. The other tool's centre point, 100 mm beside
    the first one's, is elsewhere at some rows: so far beside its own point, and at the beginning, 150 mm."""
    X_FT, p = [np.eye(4), np.eye(4)], [np.zeros((41, 3)), np.zeros((41, 3))]
    X_FT[1][1, 3] = 0.1
    for one in p:
        one[:, 0] = np.linspace(0, 0.4, 41)
    p[1][:, 1] = 0.1
    p[1][14:16, 2] = 0.15
    p[1][[*rows]] = [0.2, 0.1, place]
    tools = [SimpleNamespace(p=one, X_FT=X, rows=SimpleNamespace(marked=True)) for one, X in zip(p, X_FT, strict=True)]
    X_WT = np.eye(4)
    X_WT[0, 3] = 0.2
    zone = FlyBy(0.0501, 0.0501, 0.0501, joint=True)
    points = [SimpleNamespace(fly_by=at, X_WT=X_WT, X_FT=X_FT[0]) for at in (None, zone, None)]
    visits = [SimpleNamespace(arrive=row, depart=row + (row == 20), point=point, event=SimpleNamespace(first=13))
              for row, point in zip((0, 20, 40), points, strict=True)]  # fmt: skip
    assert tool_corner(tools, visits) == wanted  # type: ignore[arg-type]


# --- which events ------------------------------------------------------------------------------------------------


def worth(point: ProgramPoint, event: Event) -> float:
    """A stop with rows of its own 1, one that only counts by what is granted 0.99, one never at rest 0.6; a quarter of
    that where the point may be left out."""
    own = 0.6 if not len(event.good) else 0.99 if event.granted else 1.0
    return own * (0.25 if point.optional else 1.0)


def best_of(points: Sequence[ProgramPoint], events: Sequence[tuple[Event, ...]]) -> float:
    """Of all choices that follow each other in time the most that one is worth."""
    most = 0.0
    for choice in product(*([None, *own] for own in events)):
        now, total = -1, 0.0
        for point, event in zip(points, choice, strict=True):
            if event is None:
                continue
            over = event.last < now if point.fly_by is not None else event.end < now
            if over:
                break
            now, total = max(now, event.end), total + worth(point, event)
        else:
            most = max(most, total)
    return most


def test_no_choice_of_events_is_worth_more() -> None:
    """Of up to five points with up to four events each, stops and fly-bys, optional or not."""
    rng = np.random.default_rng(81)
    move = move_j(11, "p", at(0.0))
    left_out = 0
    for _ in range(150):
        points, events = [], []
        for _ in range(rng.integers(1, 6)):
            cuts = np.sort(rng.choice(30, 8, replace=False)).reshape(4, 2)
            passed = bool(rng.random() < 0.3)
            own = []
            for first, last in cuts[rng.random(4) < 0.6].tolist():
                if passed:
                    best = int(rng.integers(first, last + 1))
                    own.append(Event(first, last, np.array([max(best - 1, 0)]), best))
                else:
                    good = np.arange((first + last) // 2, last + 1) if rng.random() < 0.7 else np.arange(0)
                    own.append(Event(first, last, good, last, bool(len(good)) and bool(rng.random() < 0.3)))
            fly_by = FlyBy(0.01, 0.01, 0.01) if passed else None
            points.append(
                ProgramPoint(0, move, None, "p", None, np.eye(4), None, None, bool(rng.random() < 0.3), (), fly_by)
            )
            events.append(tuple(own))
        for chosen in (waypoint_matching._align(points, events), waypoint_matching._of_most_worth(points, events)):
            now, total = -1, 0.0
            for point, event, own in zip(points, chosen, events, strict=True):
                if event is None:
                    left_out += bool(own)
                    continue
                assert event in own
                assert (event.last if point.fly_by is not None else event.end) >= now
                now, total = max(now, event.end), total + worth(point, event)
            assert total == pytest.approx(best_of(points, events))
    assert left_out > 30
