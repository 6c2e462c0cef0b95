"""The equilibrium sequence of a route: every segment divided into periods, both parts ending together.

Profile thesis: eqs 4.23-4.33 of Cihala with the errata (N cruise steps, not N - 1; the floor kept off rounding).
Trapezoid: section 2.3. S-curve: the same with bounded jerk. The last two stand still at every pose.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.geometry import Array, rotation_about
from trajopt_cli.iiwa.task.angles import angles_of, continuous, rotation, rotation_vector
from trajopt_cli.iiwa.task.equilibrium import Equilibrium, Piece
from trajopt_cli.iiwa.task.joint_timing import ArmOnPath
from trajopt_cli.iiwa.task.laws import FullSpeed, Ramps, full_speed, ramps
from trajopt_cli.iiwa.task.legs import MOST_ROWS, StraightSegment, legs, path_of, whole_periods
from trajopt_cli.iiwa.task.model import COORDINATES, Passing, Profile, RotationLaw, Route, Waypoint
from trajopt_cli.iiwa.task.passing import CAPS, Passage, passage
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


class _Rows:
    """The rows of a sequence as it grows, the route's first pose to begin with."""

    def __init__(self, route: Route, first: Array) -> None:
        self._route, self.last, self.pieces = route, 0, list[Piece]()
        self._poses, self._matrices = [first[None]], [rotation(first[None, 3:])]

    def add(self, pose: Array, R: Array, origin: str, goal: str, dwell: bool = False) -> float:
        """Rows behind the last one: poses (m, 6), matrices (m, 3, 3). What they take [s]."""
        self._poses.append(pose)
        self._matrices.append(R)
        self.pieces.append(Piece(self.last, self.last + len(pose), origin, goal, dwell))
        self.last += len(pose)
        return len(pose) * self._route.h

    def stand(self, waypoint: Waypoint, pose: Array) -> float:
        """The dwell at a waypoint [s], its angles counted as in pose (6,)."""
        if waypoint.dwell == 0:
            return 0.0
        count, _ = whole_periods(waypoint.dwell, self._route.h)
        R = np.tile(rotation(waypoint.pose[3:]), (count, 1, 1))
        return self.add(np.tile(pose, (count, 1)), R, waypoint.name, waypoint.name, dwell=True)

    def sequence(self, notes: Iterable[str]) -> Equilibrium:
        """All rows."""
        route, pose = self._route, np.concatenate(self._poses)
        if route.rotation is RotationLaw.SLERP:
            pose[:, 3:] = continuous(pose[:, 3:])
        R, notes = np.concatenate(self._matrices), (*notes, *_rounded_dwells(route))
        return Equilibrium(route.h, pose, R, route.rotation, route.meaning, tuple(self.pieces), notes)


@of_kind(ErrorKind.PROGRAM)
def planned(
    route: Route, progress: Callable[[str], None] = lambda _: None, arm: ArmOnPath | None = None
) -> tuple[Equilibrium, tuple[SegmentFacts, ...]]:
    """A route's sequence, poses every h from its first pose to its last, and what became of each of its segments.

    arm: whose joints keep their limits of speed and acceleration, too; None for the caps of the poses alone. Every stop
    is a row, exactly; where none is passed that is every pose. Raises InputError for what legs.legs or legs.path_of
    refuses, for steps that are lost in the rounding of the coordinates, for more than MOST_ROWS rows, and for an arm
    with profile thesis; joint_timing.Untimed for what the arm cannot follow at any speed.
    """
    if arm is not None and route.profile is Profile.THESIS:
        message = "timing: joints needs accelerations, and profile thesis knows none; give trapezoid or s-curve"
        raise InputError(message, file=route.waypoints[0].place)
    return _stopping(route, arm) if route.passing is None else _passed(route, progress, arm)


def interpolate(route: Route) -> Equilibrium:
    """The sequence of planned alone."""
    return planned(route)[0]


def _stopping(route: Route, arm: ArmOnPath | None) -> tuple[Equilibrium, tuple[SegmentFacts, ...]]:
    """As planned, for a route that stops at every pose."""
    segments = legs(route)
    _check_count(segments, route)
    first, facts = route.waypoints[0], list[SegmentFacts]()
    rows = _Rows(route, first.pose)
    rows.stand(first, first.pose)
    for leg in segments:
        duration, v_top, omega_top, binds = 0.0, 0.0, 0.0, ""
        if not leg.stands:
            if arm is None:
                law = _law(leg, route)
                pose, R = _travel(leg, law, route)
                binds = law.binds
            else:
                found_law = _by_joints(leg, route, arm)
                pose, binds, arm = found_law.pose, found_law.binds, replace(arm, near=_last(found_law))
                R = rotation(pose[:, 3:]) if found_law.R is None else found_law.R
            v_top, omega_top = (float(one.max()) / route.h for one in _steps(pose, R, route.rotation))
            duration = rows.add(pose[1:], R[1:], leg.origin.name, leg.goal.name)
        dwell = rows.stand(leg.goal, leg.end)
        names = leg.origin.name, leg.goal.name
        facts.append(SegmentFacts(*names, leg.L_p, leg.L_theta, duration, v_top, omega_top, binds, dwell))
    found = rows.sequence(note for leg in segments for note in leg.notes)
    if route.rotation is RotationLaw.SLERP:
        found = replace(found, notes=(*found.notes, *_counted_on(segments, found)))
    return found, tuple(facts)


def _by_joints(leg: StraightSegment, route: Route, arm: ArmOnPath) -> Passage:
    """A leg from rest to rest within the joints' limits, too."""
    R = None if leg.turn is None else rotation(np.array([leg.origin.pose[3:], leg.goal.pose[3:]]))
    chain = Polyline(np.array([0.0, 1.0 / leg.rates[0].value]), np.array([leg.start, leg.end]), R)
    caps = np.array([[np.inf if (cap := getattr(leg.speeds, name)) is None else cap for name in CAPS]])
    if route.profile is Profile.TRAPEZOID:
        caps[:, 4:] = np.inf
    return passage(chain, caps, Passing(np.inf, np.inf), route.h, leg.goal.place, arm, leg.name)


def _last(found: Passage) -> Array:
    assert found.q is not None
    return np.asarray(found.q[-1])


def _passed(
    route: Route, progress: Callable[[str], None], arm: ArmOnPath | None
) -> tuple[Equilibrium, tuple[SegmentFacts, ...]]:
    """As planned, for a route that passes poses without a stop."""
    path = path_of(route)
    waypoints, passing, facts = route.waypoints, route.passing, list[SegmentFacts]()
    assert passing is not None
    R_given = rotation(path.pose[:, 3:]) if route.rotation is RotationLaw.SLERP else None
    rows = _Rows(route, path.pose[0])
    rows.stand(waypoints[0], path.pose[0])
    for first, goal in pairwise(route.stops):
        part, poses = slice(first, goal), slice(first, goal + 1)
        here, there = waypoints[first], waypoints[goal]
        if goal - first > _LONG:
            progress(f"passing {goal - first - 1} poses from {here.name} to {there.name}")
        chain = Polyline(path.at[poses] - path.at[first], path.pose[poses], None if R_given is None else R_given[poses])
        found = passage(
            chain, path.caps[part], passing, route.h, here.place, arm, f"segment {here.name} -> {there.name}"
        )
        if arm is not None:
            arm = replace(arm, near=_last(found))
        R = rotation(found.pose[:, 3:]) if found.R is None else found.R
        time = rows.add(found.pose[1:], R[1:], here.name, there.name)
        dwell = rows.stand(there, path.pose[goal])
        v, omega, *tops = (float(top) for top in found.tops)
        more = Passed(goal - first - 1, found.away, found.turned, *tops)
        L_p, L_theta = (float(lengths[part].sum()) for lengths in (path.lengths, path.turns))
        facts.append(SegmentFacts(here.name, there.name, L_p, L_theta, time, v, omega, found.binds, dwell, more))
    return rows.sequence(path.notes), tuple(facts)


def _steps(pose: Array, R: Array, law: RotationLaw) -> tuple[Array, Array]:
    """Lengths of the steps (n - 1,) of position [m] and orientation [rad]."""
    steps = np.diff(pose, axis=0)
    turns = steps[:, 3:] if law is RotationLaw.TAIT_BRYAN else rotation_vector(np.swapaxes(R[:-1], -1, -2) @ R[1:])
    return _norms(steps[:, :3]), _norms(turns)


def _norms(rows: Array) -> Array:
    return np.asarray(np.linalg.norm(rows, axis=-1))


def _travel(leg: StraightSegment, law: FullSpeed | Ramps, route: Route) -> tuple[Array, Array]:
    """The rows of a segment; one period slower where rounding would break the caps, or repeat a pose, at full speed."""
    for slower in (False, True):
        s = law.shares(slower)
        pose, R = _rows(leg, s)
        if _legal(leg, pose, s, route):
            return pose, R
    step, turn = leg.L_p / law.periods, leg.L_theta / law.periods
    raise InputError(
        f"{leg.name}: {step:.3g} m and {turn:.3g} rad per period are lost in the rounding of coordinates this large; "
        "give higher speeds, or coordinates from a nearer origin",
        file=leg.goal.place,
    )


def _check_count(segments: tuple[StraightSegment, ...], route: Route) -> None:
    """Refuse, before anything is built, what no memory holds; naming what takes longest."""
    parts = [(w.dwell / route.h, f"the dwell at pose {w.name}", w.place) for w in route.waypoints]
    parts += [(_law(leg, route).periods, leg.name, leg.goal.place) for leg in segments if not leg.stands]
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


def _counted_on(segments: tuple[StraightSegment, ...], found: Equilibrium) -> Iterator[str]:
    """One sentence on the first pose whose angles the columns write another way than the task."""
    arrivals = (found.pose[piece.last] for piece in found.pieces if not piece.dwell)
    for leg, row in zip((leg for leg in segments if not leg.stands), arrivals, strict=True):
        if np.any(np.abs(row[3:] - leg.goal.pose[3:]) > 1e-9):
            pairs = zip(COORDINATES[3:], np.degrees(row[3:]), strict=True)
            angles = ", ".join(f"{name} {value:.6g}°" for name, value in pairs)
            yield f"pose {leg.goal.name}: angles never jump, they count on to {angles}; the orientation is the pose's"
            return
