"""The equilibrium sequence of a route: every segment shared out over periods, both parts ending together.

Profile thesis: eqs 4.23-4.33 of Cihala with the errata (N cruise steps, not N - 1; the floor kept off rounding).
Trapezoid: section 2.3. S-curve: the same with bounded jerk. The last two stand still at every pose.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.geometry import Array, rotation_about
from trajopt_cli.iiwa.task.angles import angles_of, continuous, rotation, rotation_vector
from trajopt_cli.iiwa.task.equilibrium import Equilibrium, Piece
from trajopt_cli.iiwa.task.laws import FullSpeed, Ramps, full_speed, ramps
from trajopt_cli.iiwa.task.legs import MOST_ROWS, StraightSegment, legs, whole_periods
from trajopt_cli.iiwa.task.many_legs import path_of
from trajopt_cli.iiwa.task.model import COORDINATES, Profile, RotationLaw, Route, Waypoint
from trajopt_cli.iiwa.task.passing import Caps, passage
from trajopt_cli.iiwa.task.rounded import Polyline

_LONG = 10_000  # poses that are passed at once, from which on progress is told
_ALLOWED = 0.9e-9  # of the 1e-9 by which a step may exceed v_max h or omega_max h; the rest is for whoever measures


@dataclass(frozen=True)
class SegmentFacts:
    """One segment as sampled: ways [m, rad], duration [s], top speeds [m/s, rad/s], then the dwell [s] at its goal.

    binds: the cap that decides the duration ("v_max", "omega_max", "a_max", ...), empty where a pose is repeated.
    passed: what is known besides where the segment passes poses without a stop.
    """

    origin: str
    goal: str
    L_p: float
    L_theta: float
    duration: float
    v_top: float
    omega_top: float
    binds: str
    dwell: float
    passed: Passed | None = None


@dataclass(frozen=True)
class Passed:
    """A segment of many legs: how many poses it passes, how far from them and from the straight ways between them it
    goes at most [m, rad], and its greatest accelerations [m/s2, rad/s2] and jerks [m/s3, rad/s3]."""

    poses: int
    away: float
    turned: float
    a_top: float
    epsilon_top: float
    jerk_top: float
    angular_jerk_top: float


@dataclass(frozen=True, eq=False)
class _Stage:
    """Rows after the one shared with the stage before: poses (m, 6) and matrices (m, 3, 3)."""

    origin: str
    goal: str
    pose: Array
    R: Array
    dwell: bool


@of_kind(ErrorKind.PROGRAM)
def planned(route: Route, told: Callable[[str], None] | None = None) -> tuple[Equilibrium, tuple[SegmentFacts, ...]]:
    """A route's sequence, and what became of each of its segments. told: is told of progress."""
    if route.passing is None:
        sequence = interpolate(route)
        return sequence, summary(sequence, route)
    return _passed(route, told or (lambda _: None))


@of_kind(ErrorKind.PROGRAM)
def interpolate(route: Route) -> Equilibrium:
    """Poses every h from the route's first pose to its last, by its profile and rotation law.

    Every pose of the route is a row, exactly. Raises InputError for what legs.legs refuses, for steps that drown in
    the rounding of the coordinates, and for more than MOST_ROWS rows. Where poses are passed, every stop is a row.
    """
    if route.passing is not None:
        return planned(route)[0]
    way = legs(route)
    _check_count(way, route)
    first = route.waypoints[0].pose
    pieces: list[Piece] = []
    poses, matrices, last = [first[None]], [rotation(first[None, 3:])], 0
    for stage in _stages(way, route):
        poses.append(stage.pose)
        matrices.append(stage.R)
        pieces.append(Piece(last, last + len(stage.pose), stage.origin, stage.goal, stage.dwell))
        last = pieces[-1].last
    pose, notes = np.concatenate(poses), [*(note for leg in way for note in leg.notes), *_rounded_dwells(route)]
    if route.rotation is RotationLaw.SLERP:
        pose[:, 3:] = continuous(pose[:, 3:])
        notes += _counted_on(way, pieces, pose)
    R = np.concatenate(matrices)
    return Equilibrium(route.h, pose, R, route.rotation, route.meaning, tuple(pieces), tuple(notes))


def summary(equilibrium: Equilibrium, route: Route) -> tuple[SegmentFacts, ...]:
    """What became of each segment of a route that stops at every pose, in order.

    Turn rates are those of the rotation law: of the angles' norm (tait-bryan), of the true turn (slerp).
    """
    way = legs(route)
    pieces = iter(equilibrium.pieces)
    if route.waypoints[0].dwell > 0:
        next(pieces)
    out = []
    for leg in way:
        moves = None if leg.stands else next(pieces)
        stands = next(pieces) if leg.goal.dwell > 0 else None
        rows = slice(0, 0) if moves is None else slice(moves.first, moves.last + 1)
        v_top, omega_top = (
            float(steps.max(initial=0.0)) / equilibrium.h
            for steps in _steps(equilibrium.pose[rows], equilibrium.R[rows], route.rotation)
        )
        out.append(
            SegmentFacts(
                leg.origin.name, leg.goal.name, leg.L_p, leg.L_theta, _duration(moves, route.h), v_top, omega_top,
                "" if leg.stands else _law(leg, route).binds, _duration(stands, route.h),
            )
        )  # fmt: skip
    return tuple(out)


def _passed(route: Route, told: Callable[[str], None]) -> tuple[Equilibrium, tuple[SegmentFacts, ...]]:
    """As planned, for a route that passes poses without a stop."""
    path = path_of(route)
    way, law, passing = route.waypoints, route.rotation, route.passing
    assert passing is not None
    R_given = rotation(path.pose[:, 3:]) if law is RotationLaw.SLERP else None
    poses, matrices, last = [path.pose[:1]], [rotation(path.pose[:1, 3:])], 0
    pieces: list[Piece] = []
    facts: list[SegmentFacts] = []

    def add(pose: Array, R: Array, origin: str, goal: str, dwell: bool) -> None:
        nonlocal last
        poses.append(pose)
        matrices.append(R)
        pieces.append(Piece(last, last + len(pose), origin, goal, dwell))
        last += len(pose)

    def stand(index: int) -> float:
        for stage in _standing(way[index], path.pose[index], route.h):
            add(stage.pose, stage.R, stage.origin, stage.goal, True)
            return len(stage.pose) * route.h
        return 0.0

    stand(0)
    for first, goal in zip(route.stops, route.stops[1:], strict=False):
        legs_of, rows = slice(first, goal), slice(first, goal + 1)
        here, there = way[first], way[goal]
        if goal - first > _LONG:
            told(f"passing {goal - first - 1} poses from {here.name} to {there.name}")
        chain = Polyline(path.at[rows] - path.at[first], path.pose[rows], None if R_given is None else R_given[rows])
        found = passage(chain, Caps(path.caps[legs_of]), passing, route.h, here.place)
        R = rotation(found.pose[:, 3:]) if found.R is None else found.R
        add(found.pose[1:], R[1:], here.name, there.name, False)
        v, omega, a, epsilon, jerk, angular_jerk = (float(top) for top in found.tops)
        more = Passed(goal - first - 1, found.away, found.turned, a, epsilon, jerk, angular_jerk)
        L_p, L_theta = (float(ways[legs_of].sum()) for ways in (path.lengths, path.turns))
        time = (len(found.pose) - 1) * route.h
        facts.append(SegmentFacts(here.name, there.name, L_p, L_theta, time, v, omega, found.binds, stand(goal), more))
    pose, R = np.concatenate(poses), np.concatenate(matrices)
    if law is RotationLaw.SLERP:
        pose[:, 3:] = continuous(pose[:, 3:])
    notes = (*path.notes, *_rounded_dwells(route))
    return Equilibrium(route.h, pose, R, law, route.meaning, tuple(pieces), notes), tuple(facts)


def _duration(piece: Piece | None, h: float) -> float:
    return 0.0 if piece is None else (piece.last - piece.first) * h


def _steps(pose: Array, R: Array, law: RotationLaw) -> tuple[Array, Array]:
    """Lengths of the steps (n - 1,) of position [m] and orientation [rad]."""
    steps = np.diff(pose, axis=0)
    if law is RotationLaw.SLERP:
        return _norms(steps[:, :3]), _norms(rotation_vector(np.swapaxes(R[:-1], -1, -2) @ R[1:]))
    return _norms(steps[:, :3]), _norms(steps[:, 3:])


def _norms(rows: Array) -> Array:
    return np.asarray(np.linalg.norm(rows, axis=-1))


def _stages(way: tuple[StraightSegment, ...], route: Route) -> Iterator[_Stage]:
    first = route.waypoints[0]
    yield from _standing(first, first.pose, route.h)
    for leg in way:
        if not leg.stands:
            yield _travel(leg, route)
        yield from _standing(leg.goal, leg.end, route.h)


def _standing(waypoint: Waypoint, pose: Array, h: float) -> Iterator[_Stage]:
    """The dwell at a waypoint, if it has one."""
    if waypoint.dwell > 0:
        count, _ = whole_periods(waypoint.dwell, h)
        R = np.tile(rotation(waypoint.pose[3:]), (count, 1, 1))
        yield _Stage(waypoint.name, waypoint.name, np.tile(pose, (count, 1)), R, dwell=True)


def _travel(leg: StraightSegment, route: Route) -> _Stage:
    """The rows of a segment; one period slower where rounding would break the caps, or repeat a pose, at full speed."""
    law = _law(leg, route)
    for slower in (False, True):
        s = law.shares(slower)
        pose, R = _rows(leg, s)
        if _legal(leg, pose, s, route):
            return _Stage(leg.origin.name, leg.goal.name, pose[1:], R[1:], dwell=False)
    step, turn = leg.L_p / law.periods, leg.L_theta / law.periods
    raise InputError(
        f"{leg.name}: {step:.3g} m and {turn:.3g} rad per period are lost in the rounding of coordinates this large; "
        "give higher speeds, or coordinates from a nearer origin",
        file=leg.goal.place,
    )


def _check_count(way: tuple[StraightSegment, ...], route: Route) -> None:
    """Refuse, before anything is built, what no memory holds; naming what takes longest."""
    parts = [(w.dwell / route.h, f"the dwell at pose {w.name}", w.place) for w in route.waypoints]
    parts += [(_law(leg, route).periods, leg.name, leg.goal.place) for leg in way if not leg.stands]
    rows = sum(part[0] for part in parts)
    if rows > MOST_ROWS:
        longest, what, place = max(parts)
        message = (
            f"{what} takes {longest:.3g} periods of {route.h:g} s, the sequence {rows:.3g}, at most {MOST_ROWS:.3g}"
        )
        raise InputError(f"{message}; give a higher speed, a shorter dwell or a longer period", file=place)


def _law(leg: StraightSegment, route: Route) -> FullSpeed | Ramps:
    speed, acceleration, jerk = leg.rates
    if route.profile is Profile.THESIS:
        return full_speed(speed, route.h)
    return ramps(speed, acceleration, jerk, route.h)


def _rows(leg: StraightSegment, s: Array) -> tuple[Array, Array]:
    """Poses (n, 6) and matrices (n, 3, 3) at shares s (n,) of the way: products from the start, never sums."""
    pose = leg.start + s[:, None] * (leg.end - leg.start)
    pose[-1] = leg.end
    if leg.turn is None:
        return pose, rotation(pose[:, 3:])
    angle = float(np.linalg.norm(leg.turn))
    axis = leg.turn / angle if angle else np.array([1.0, 0.0, 0.0])
    R = rotation(leg.origin.pose[3:]) @ rotation_about(axis, s * angle)
    R[-1] = rotation(leg.goal.pose[3:])
    pose[1:-1, 3:] = angles_of(R[1:-1])
    return pose, R


def _legal(leg: StraightSegment, pose: Array, s: Array, route: Route) -> bool:
    """Whether no step exceeds its cap by more than the allowance, and at full speed none is lost in rounding."""
    steps = np.diff(pose, axis=0)
    if route.profile is Profile.THESIS and not np.all(np.any(steps != 0, axis=1)):
        return False
    # matrices of size 1 are rounded to 1e-15 whatever the angle, and measuring the turns would see no more
    turned = _norms(steps[:, 3:]).max() if leg.turn is None else np.diff(s).max() * leg.L_theta + 1e-15
    checks = ((leg.L_p, _norms(steps[:, :3]).max(), leg.speeds.v_max), (leg.L_theta, turned, leg.speeds.omega_max))
    return all(length == 0 or step <= cap * route.h * (1 + _ALLOWED) for length, step, cap in checks)


def _rounded_dwells(route: Route) -> Iterator[str]:
    for waypoint in (route.waypoints[i] for i in route.stops):
        if waypoint.dwell > 0:
            count, rounded = whole_periods(waypoint.dwell, route.h)
            if rounded:
                taken = f"{count * route.h:.6g} s, {count} periods of {route.h:g} s"
                yield f"pose {waypoint.name}: the dwell of {waypoint.dwell:g} s is rounded up to {taken}"


def _counted_on(way: tuple[StraightSegment, ...], pieces: list[Piece], pose: Array) -> Iterator[str]:
    """One sentence on the first pose whose angles the columns write another way than the task."""
    arrivals = (pose[piece.last] for piece in pieces if not piece.dwell)
    for leg, row in zip((leg for leg in way if not leg.stands), arrivals, strict=True):
        if np.any(np.abs(row[3:] - leg.goal.pose[3:]) > 1e-9):
            pairs = zip(COORDINATES[3:], np.degrees(row[3:]), strict=True)
            angles = ", ".join(f"{name} {value:.6g}°" for name, value in pairs)
            yield f"pose {leg.goal.name}: angles never jump, they count on to {angles}; the orientation is the pose's"
            return
