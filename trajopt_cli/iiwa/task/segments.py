"""The equilibrium sequence of a route: every segment divided into periods, both parts ending together.

Profile thesis: eqs 4.23-4.33 of Cihala with the errata (N cruise steps, not N - 1; the floor kept off rounding).
Trapezoid: section 2.3. S-curve: the same with bounded jerk. The last two stand still at every pose, unless it is
passed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from math import ceil, floor, sqrt

import numpy as np

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.geometry import Array, rotation_about
from trajopt_cli.iiwa.task.angles import angles_of, continuous, rotation
from trajopt_cli.iiwa.task.equilibrium import Equilibrium, Piece
from trajopt_cli.iiwa.task.joint_checks import ArmOnPath
from trajopt_cli.iiwa.task.legs import MOST_ROWS, Path, name_of, path_of, whole_periods
from trajopt_cli.iiwa.task.model import CAPS, COORDINATES, Passing, Profile, RotationLaw, Route, Waypoint
from trajopt_cli.iiwa.task.passing import divided_differences, passage
from trajopt_cli.iiwa.task.rounded import Polyline
from trajopt_cli.timing.point_to_point import PointToPoint, point_to_point

_LONG = 10_000  # poses that are passed at once, from which on progress is told
_WHOLE = 5e-10  # a time this close to a whole number of periods, in periods, is one: 0.2 / 0.1 must not floor to 1
_ALLOWED = 0.9e-9  # of the 1e-9 by which a step may exceed v_max h or omega_max h; the rest is for whoever measures


@dataclass(frozen=True)
class FullSpeed:
    """The thesis' law: at once at full speed (eqs 4.26-4.33). periods: t_max / h; binds: the cap that decides it."""

    periods: float
    binds: str

    def shares(self, slower: bool) -> Array:
        """Shares (n,): N = floor(t_max / h) steps at full speed, what is left over halved between both ends.

        With nothing left over, N steps and no more. slower: equal steps, over up to a period more than t_max.
        """
        # twice the tolerance here, so that what counts as whole below is never floored to the number before
        whole = floor(self.periods + 2 * _WHOLE)
        if slower:
            # at least a hundredth of a period slower, where t_max is whole but for rounding
            count = ceil(self.periods + 0.01)
            return np.asarray(np.arange(count + 1) / count, dtype=np.float64)
        if whole and self.periods - whole <= _WHOLE:
            return np.asarray(np.arange(whole + 1) / whole, dtype=np.float64)
        begin = (1.0 - whole / self.periods) / 2
        return np.asarray(np.r_[0.0, begin + np.arange(whole + 1) / self.periods, 1.0], dtype=np.float64)


@dataclass(frozen=True, eq=False)
class Ramps:
    """From rest to rest with ramps. periods: the least time in periods; motion: 0 to 1 in its own unit of time."""

    periods: float
    binds: str
    motion: PointToPoint

    def shares(self, slower: bool) -> Array:
        """Shares (n,) of the fastest motion, stretched evenly to whole periods; slower: to one period more."""
        # never faster than the caps by more than rounding: 3e-12 in jerk
        count = max(1, ceil(self.periods * (1 - 1e-12))) + slower
        times = np.asarray(np.arange(count + 1) * (self.motion.duration / count), dtype=np.float64)
        s = self.motion.at(times)[0][:, 0]
        s[0], s[-1] = 0.0, 1.0
        return s


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
    is a row, exactly; where none is passed that is every pose. Raises InputError for what legs.path_of refuses, for
    steps that are lost in the rounding of the coordinates, for more than MOST_ROWS rows, and for an arm with profile
    thesis; joint_checks.Untimed for what the arm cannot follow at any speed.
    """
    way, h, stopping = route.waypoints, route.h, route.passing is None
    if arm is not None and route.profile is Profile.THESIS:
        message = "timing: joints needs accelerations, and profile thesis knows none; give trapezoid or s-curve"
        raise InputError(message, file=way[0].place)
    path = path_of(route)
    laws = [_law(path, leg, route) for leg in range(len(way) - 1)] if stopping else []
    _check_count(path, route, laws)
    R_given = rotation(path.pose[:, 3:]) if route.rotation is RotationLaw.SLERP else None
    facts, rows = list[SegmentFacts](), _Rows(route, path.pose[0])
    rows.stand(way[0], path.pose[0])
    for first, goal in pairwise(route.stops):
        here, there, part, poses = way[first], way[goal], slice(first, goal), slice(first, goal + 1)
        v, omega, binds, time, passed = 0.0, 0.0, "", 0.0, None
        if not stopping or (arm is not None and laws[first] is not None):
            if goal - first > _LONG:
                progress(f"passing {goal - first - 1} poses from {here.name} to {there.name}")
            R_part = None if R_given is None else R_given[poses]
            chain = Polyline(path.at[poses] - path.at[first], path.pose[poses], R_part)
            name, place = f"segment {here.name} -> {there.name}", (there if stopping else here).place
            found = passage(chain, path.caps[part], route.passing or Passing(np.inf, np.inf), h, place, arm, name)
            if arm is not None:
                assert found.q is not None
                arm = replace(arm, near=found.q[-1])
            R = rotation(found.pose[:, 3:]) if found.R is None else found.R
            time = rows.add(found.pose[1:], R[1:], here.name, there.name)
            v, omega, *tops = (float(top) for top in found.tops)
            binds = found.binds
            passed = None if stopping else Passed(goal - first - 1, found.away, found.turned, *tops)
        elif (law := laws[first]) is not None:
            pose, R = _travel(path, first, law, route)
            v, omega = (float(x.max()) for x in divided_differences(pose, None if R_given is None else R, h)[:2])
            binds, time = law.binds, rows.add(pose[1:], R[1:], here.name, there.name)
        ways = float(path.lengths[part].sum()), float(path.turns[part].sum())
        dwell = rows.stand(there, path.pose[goal])
        facts.append(SegmentFacts(here.name, there.name, *ways, time, v, omega, binds, dwell, passed))
    sequence = rows.sequence(path.notes)
    if stopping and route.rotation is RotationLaw.SLERP:
        sequence = replace(sequence, notes=(*sequence.notes, *_counted_on(route, path, sequence)))
    return sequence, tuple(facts)


def interpolate(route: Route) -> Equilibrium:
    """The sequence of planned alone."""
    return planned(route)[0]


def _law(path: Path, leg: int, route: Route) -> FullSpeed | Ramps | None:
    """The fastest way along a leg from rest to rest; None where its pose is only repeated."""
    ways = path.lengths[leg], path.turns[leg]
    moving = [part for part in (0, 1) if ways[part]]
    if not moving:
        return None
    # caps per length of the way [1/s], [1/s2], [1/s3]: of both parts the one that allows less
    rates = [min((path.caps[leg, i + part] / ways[part], i + part) for part in moving) for i in (0, 2, 4)]
    caps = [(float(rate), CAPS[k]) for rate, k in rates if rate < np.inf]
    speed, *others = (rate for rate, _ in caps)
    if not others:
        return FullSpeed(1.0 / (speed * route.h), caps[0][1])
    # in a unit of time in which the motion takes between 1 and about 10, whatever the way's length and the caps
    unit = max(1 / speed, 1 / sqrt(others[0]), *(jerk ** (-1 / 3) for jerk in others[1:]))
    limits = [np.array([rate * unit**order]) for order, (rate, _) in enumerate(caps, start=1)]
    motion = point_to_point(np.zeros(1), np.ones(1), limits[0], limits[1], limits[2] if len(limits) > 2 else None)
    tops = (float(np.max(np.abs(x))) for x in (motion.qd, motion.qdd, motion.qddd))
    # the first cap reached decides most: a motion that cruises is as long as its speed makes it
    reached = (top >= limit[0] * (1 - 1e-9) for limit, top in zip(limits, tops, strict=False))
    binds = next((name for (_, name), at in zip(caps, reached, strict=True) if at), caps[-1][1])
    return Ramps(motion.duration * unit / route.h, binds, motion)


def _travel(path: Path, leg: int, law: FullSpeed | Ramps, route: Route) -> tuple[Array, Array]:
    """The rows of a segment; one period slower where rounding would break the caps, or repeat a pose, at full speed."""
    for slower in (False, True):
        s = law.shares(slower)
        pose, R = _rows(path, leg, s)
        if _legal(path, leg, pose, s, route):
            return pose, R
    step, turn = path.lengths[leg] / law.periods, path.turns[leg] / law.periods
    raise InputError(
        f"{name_of(route, leg)}: {step:.3g} m and {turn:.3g} rad per period are lost in the rounding of coordinates "
        "this large; give higher speeds, or coordinates from a nearer origin",
        file=route.waypoints[leg + 1].place,
    )


def _check_count(path: Path, route: Route, laws: list[FullSpeed | Ramps | None]) -> None:
    """Refuse, before anything is built, what no memory holds; naming what takes longest."""
    periods = np.diff(path.at) / route.h
    if laws:
        periods = np.array([0.0 if law is None else law.periods for law in laws])
    stops = [route.waypoints[i] for i in route.stops]
    dwells = np.array([one.dwell for one in stops]) / route.h
    rows, leg, longest = float(periods.sum() + dwells.sum()), int(np.argmax(periods)), stops[int(np.argmax(dwells))]
    if rows > MOST_ROWS:
        what, place, most = name_of(route, leg), route.waypoints[leg + 1].place, float(periods[leg])
        if dwells.max() > most:
            what, place, most = f"the dwell at pose {longest.name}", longest.place, float(dwells.max())
        message = f"{what} takes {most:.3g} periods of {route.h:g} s, the sequence {rows:.3g}, at most {MOST_ROWS:.3g}"
        raise InputError(f"{message}; give a higher speed, a shorter dwell or a longer period", file=place)


def _rows(path: Path, leg: int, s: Array) -> tuple[Array, Array]:
    """Poses (n, 6) and matrices (n, 3, 3) at shares s (n,) of the way: products from the start, never sums."""
    start, end = path.pose[leg], path.pose[leg + 1]
    pose = start + s[:, None] * (end - start)
    pose[-1] = end
    if path.vectors is None:
        return pose, rotation(pose[:, 3:])
    turn = path.vectors[leg]
    angle = float(np.linalg.norm(turn))
    axis = turn / angle if angle else np.array([1.0, 0.0, 0.0])
    R = rotation(start[3:]) @ rotation_about(axis, s * angle)
    R[-1] = rotation(end[3:])
    pose[1:-1, 3:] = angles_of(R[1:-1])
    return pose, R


def _legal(path: Path, leg: int, pose: Array, s: Array, route: Route) -> bool:
    """Whether no step exceeds its cap by more than the allowance, and at full speed none is lost in rounding."""
    steps, turns = np.diff(pose, axis=0), path.turns[leg]
    if route.profile is Profile.THESIS and not np.all(np.any(steps != 0, axis=1)):
        return False
    moved, turned = (np.linalg.norm(part, axis=1).max() for part in (steps[:, :3], steps[:, 3:]))
    # matrices of size 1 are rounded to 1e-15 whatever the angle, and measuring the turns would see no more
    turned = turned if path.vectors is None else np.diff(s).max() * turns + 1e-15
    v_max, omega_max = path.caps[leg, :2] * route.h * (1 + _ALLOWED)
    return bool((path.lengths[leg] == 0 or moved <= v_max) and (turns == 0 or turned <= omega_max))


def _rounded_dwells(route: Route) -> Iterator[str]:
    for waypoint in (route.waypoints[i] for i in route.stops):
        if waypoint.dwell > 0:
            count, rounded = whole_periods(waypoint.dwell, route.h)
            if rounded:
                taken = f"{count * route.h:.6g} s, {count} periods of {route.h:g} s"
                yield f"pose {waypoint.name}: the dwell of {waypoint.dwell:g} s is rounded up to {taken}"


def _counted_on(route: Route, path: Path, found: Equilibrium) -> Iterator[str]:
    """One sentence on the first pose whose angles the columns write another way than the task."""
    goals = [one for one, way, turn in zip(route.waypoints[1:], path.lengths, path.turns, strict=True) if way or turn]
    arrivals = (found.pose[piece.last, 3:] for piece in found.pieces if not piece.dwell)
    for goal, angles in zip(goals, arrivals, strict=True):
        if np.any(np.abs(angles - goal.pose[3:]) > 1e-9):
            pairs = zip(COORDINATES[3:], np.degrees(angles), strict=True)
            written = ", ".join(f"{name} {value:.6g}°" for name, value in pairs)
            yield f"pose {goal.name}: angles never jump, they count on to {written}; the orientation is the pose's"
            return
