"""Positioners that turn work objects: where a file has them, what the tool does over a work object that turns, and
whether they keep their limits and the program's positions."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.findings import Finding
from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.judge.findings import axis_unit, finding
from trajopt_cli.judge.geometry import lengths, turned
from trajopt_cli.judge.machine import Machine
from trajopt_cli.judge.samples import Along, Pieces, Rows, shortest
from trajopt_cli.judge.timeline import Timeline, Visit
from trajopt_cli.judge.tolerances import DWELL, JOINT, JOINT_TARGET
from trajopt_cli.judge.tool_kinematics import Places, ToolKinematics
from trajopt_cli.motion import Program, UnitMove, motion_name, turned_under
from trajopt_cli.trajectory import Trajectory

_POSITION = "positioner position"


def check_columns(
    program: Program, trajectory: Trajectory, dropped: Collection[int] = (), plant: Machine | None = None
) -> None:
    """Raise InputError for columns of positioners that the program does not turn, and where the path over a work object
    that turns, or the place of a body that rides on a positioner, cannot be told for want of one."""
    there = () if trajectory.tables is None else trajectory.tables.names
    moved = {unit.column for motion in program.motions for unit in getattr(motion, "units", ())}
    if strange := [name for name in there if name not in moved]:
        text = f"the file has a column {strange[0]}, by which no positioner of the program turns: leave it out"
        raise InputError(text)
    carries = {
        (one.rides.unit, axis.eax): one.name
        for one in (() if plant is None else plant.obstacles)
        if plant is not None and one.rides is not None
        for axis in plant.units[one.rides.unit][: one.rides.axes]
    }
    for motion in program.motions:
        for unit in getattr(motion, "units", ()):
            if unit.column not in there and (name := carries.get((unit.unit, unit.eax))):
                raise InputError(
                    f"the file has no column {unit.column} [{axis_unit(unit.column)}], by which {unit.unit} moves"
                    f" '{name}' during {motion_name(motion)} ({motion.source}): add where it stands in every row"
                )
    for i, motion in enumerate(program.motions):
        for unit in turned_under(motion) if i not in dropped else ():
            if unit.column not in there:
                raise InputError(
                    f"the file has no column {unit.column} [{axis_unit(unit.column)}], by which {unit.unit} turns the"
                    f" work object under {motion_name(motion)} ({motion.source}): add where it stands in every row"
                )


@dataclass(frozen=True, eq=False)
class TurnedFrame(ToolKinematics):
    """The tool over a work object that units turn: seen from the table, as if that stood where it does when their move
    begins. Speeds are those over the work object. world: the same tool in the world."""

    world: ToolKinematics
    units: tuple[UnitMove, ...]

    @classmethod
    def over(cls, world: ToolKinematics, units: tuple[UnitMove, ...]) -> TurnedFrame:
        """Of a tool in the world."""
        return cls(world.rows, world.X_FT, world, units)

    @property
    def exact(self) -> bool:
        """No: what happens between rows is told by means over them."""
        return False

    @cached_property
    def R(self) -> Along:
        """Rotations (n, 3, 3) seen from the table."""

        def make(a: int, b: int) -> tuple[Array]:
            return (np.swapaxes(turned(self.units, self._theta[a:b])[0], 1, 2) @ self.world.R[a:b],)

        return Along(Pieces(len(self.rows.t), make))

    @property
    def _tables(self) -> Trajectory:
        assert self.rows.trajectory.tables is not None
        return self.rows.trajectory.tables

    @cached_property
    def _its(self) -> list[int]:
        return [self._tables.names.index(unit.column) for unit in self.units]

    @cached_property
    def _theta(self) -> Array:
        """How far the units have turned (n, m) at the rows, rad."""
        return self._since(self._tables.q)

    def _since(self, q: Array) -> Array:
        return np.asarray(q[:, self._its] - np.array([unit.start for unit in self.units]))

    def _printed(self, p: Array) -> tuple[Array, Array]:
        """How far printed angles may put positions p (n, 3) off, and turn rotations."""
        angle, _ = self.rows.tables_step
        return self._lever(p) * angle / 2, np.full(len(p), len(self.units) * angle / 2)

    def _lever(self, p: Array) -> Array:
        """How far from all units' axes positions (n, 3) are, in all and at most [m]."""
        return np.asarray(sum(1.0 + 0 * p[:, 0] if u.slides else lengths(p - np.array(u.p)) for u in self.units))

    @cached_property
    def _small(self) -> tuple[Array, ...]:
        p = self.world.p
        R, x = turned(self.units, self._theta)
        linear, angular = self._printed(p)
        out = [_seen(R, p - x), self.world.doubt_p + linear, self.world.doubt_R + angular]
        if self.rows.qd is not None:
            V, *doubts = self._velocities.whole()
            parts = lengths(V[:, :3]), lengths(V[:, 3:])
            out += [np.maximum(v - doubt, 0.0) for v, doubt in zip(parts, doubts, strict=True)]
        return tuple(out)

    @cached_property
    def _velocities(self) -> Pieces:
        rates, doubt = self._tables.qd, self.rows.tables_step[1] / 2
        assert rates is not None
        rates = rates[:, self._its]

        def make(a: int, b: int) -> tuple[Array, ...]:
            V, p = self.world.V[a:b], self.world.p[a:b]
            v, w = V[:, :3], V[:, 3:]
            for i, unit in enumerate(self.units):  # an axis lies where those below it have brought it
                R, x = turned(self.units[:i], self._theta[a:b, :i])
                spin = rates[a:b, i, None] * (R @ np.array(unit.u))
                if unit.slides:
                    v = v - spin
                    continue
                v, w = v - np.cross(spin, p - (R @ np.array(unit.p) + x)), w - spin
            R = turned(self.units, self._theta[a:b])[0]
            linear, angular = (of[a:b] for of in self.world.doubt_V)
            open_ = self._lever(p) * doubt, len(self.units) * doubt
            return np.hstack([_seen(R, v), _seen(R, w)]), linear + open_[0], angular + open_[1]

        return Pieces(len(self.rows.t), make)

    def places(self, first: int, last: int) -> Places:
        """All there is to see from row first to row last, seen from the table."""
        seen = self.world.places(first, last)
        between = self.rows.exact and last > first
        q = _cubic(self._tables, seen.t, first) if between else self._tables.q[first : last + 1]
        R, x = turned(self.units, self._since(q))
        linear, angular = self._printed(seen.p)
        R_seen = np.swapaxes(R, 1, 2) @ seen.R
        return Places(seen.t, _seen(R, seen.p - x), R_seen, seen.doubt_p + linear, seen.doubt_angle + angular)

    def span(self, before: Visit, visit: Visit) -> tuple[int, int]:
        """First and last row of the move from one visit to the next; of a rest that has both, where units turn."""
        if visit.arrive > before.depart:
            return before.depart, visit.arrive
        theta, angle = self._theta[before.arrive : visit.depart + 1, 0], self.units[0].angle
        stands = JOINT_TARGET + _granted(self.rows, self.units[0].acceleration, before.arrive, visit.depart)
        begun = np.maximum.accumulate(np.abs(theta) <= stands)  # rows before may end the turn before
        under_way = np.flatnonzero(begun & (np.minimum(np.abs(theta), np.abs(theta - angle)) > stands))
        if not len(under_way):
            return visit.arrive, visit.arrive
        last = under_way[np.argmax(np.diff(under_way, append=len(theta) + 2) > 1)]  # before it rests again
        first = before.arrive + max(int(under_way[0]) - 1, 0)
        return first, min(before.arrive + int(last) + 1, visit.depart)

    def off(self, here: IndexArray, fraction: Array, doubt: Array) -> Array:
        """How far the units (n, m) are at least, at rows here (n,), from where they should be at shares (n,) of the
        way. doubt (n,): about the shares."""
        angles = np.array([unit.angle for unit in self.units])
        away = np.abs(self._theta[here] - fraction[:, None] * angles)
        return np.asarray(np.maximum(away - doubt[:, None] * np.abs(angles) - self.rows.tables_step[0] / 2, 0.0))


def _cubic(tables: Trajectory, t: Array, first: int) -> Array:
    """Angles (n, m) at times (n,) from row first on: of the cubic with the angles and the speeds at both rows."""
    assert tables.qd is not None
    i = np.clip(np.searchsorted(tables.t, t, side="right") - 1, first, len(tables.t) - 2)
    h = np.diff(tables.t)[i, None]
    u, path, v_0, v_1 = (t - tables.t[i])[:, None] / h, np.diff(tables.q, axis=0)[i], tables.qd[i], tables.qd[i + 1]
    bent = u * u * (3 - 2 * u) * path + h * u * (1 - u) * ((1 - u) * v_0 - u * v_1)
    return np.asarray(tables.q[i] + bent)


def _seen(R: Array, values: Array) -> Array:
    """Vectors (n, 3) seen from the frames R (n, 3, 3)."""
    return np.asarray(np.einsum("nji,nj->ni", R, values))


@dataclass(frozen=True)
class _Step:
    """What a rest is made of: waits and moves of tables alone, one after the other. begin: the earliest time [s] at
    which it may begin; lasts [s]: at least."""

    units: tuple[UnitMove, ...]
    begin: float
    lasts: float


@dataclass(frozen=True)
class _Phase:
    """Rows first to last in which units turn, every other positioner standing. visit: at its end. steps: of a rest."""

    first: int
    last: int
    units: tuple[UnitMove, ...]
    visit: Visit
    steps: tuple[_Step, ...] = ()

    @classmethod
    def rest(cls, first: int, last: int, steps: tuple[_Step, ...], visit: Visit) -> _Phase:
        """Rows of a rest."""
        return cls(first, last, tuple(unit for step in steps for unit in step.units), visit, steps)

    def window(self, column: str) -> tuple[float, float]:
        """The earliest time [s] at which an axis may begin to turn, and how long [s] it stands behind its last turn."""
        mine = [i for i, step in enumerate(self.steps) if any(unit.column == column for unit in step.units)]
        if not mine:
            return -np.inf, 0.0
        return self.steps[mine[0]].begin, sum(step.lasts for step in self.steps[mine[-1] + 1 :])


def _phases(program: Program, line: Timeline) -> Iterator[_Phase]:
    """Moves and rests in turn, all rows of the file. A rest may have moves in it that move the tables alone."""
    first = line.visits[0]
    begin, end, visit, steps = first.arrive, first.depart, first, _steps(program, first)
    for after in line.visits[1:]:
        if after.event is None:
            continue
        units = () if after.point.move is None else after.point.move.units
        if after.arrive <= end:
            steps += (_Step(units, visit.ready, after.point.duration or after.point.least),)
        else:
            left, come = _under_way(line, visit, end, after, _latest(program, line.rows, after))
            yield _Phase.rest(begin, left, steps, visit)
            yield _Phase(left, come, units, after)
            begin, steps = come, ()
        end, visit, steps = max(after.depart, end), after, steps + _steps(program, after)
    yield _Phase.rest(begin, len(line.rows.t) - 1, steps, visit)


def _stands(line: Timeline, units: Sequence[UnitMove], first: int, last: int, end: bool) -> IndexArray:
    """The rows of first to last at which tables stand where their move begins or ends."""
    rows, tables = line.rows, line.rows.trajectory.tables
    if tables is None or last < first:
        return np.array([], dtype=np.intp)
    at = np.ones(last - first + 1, dtype=bool)
    for unit in units:
        off = np.abs(tables.q[first : last + 1, tables.names.index(unit.column)] - (unit.end if end else unit.start))
        at &= off <= JOINT_TARGET + _granted(rows, unit.acceleration, first, last)
    return np.asarray(first + np.flatnonzero(at))


def _granted(rows: Rows, acceleration: float, a: int, b: int) -> Array:
    """What a table that stands at rows a to b may be off [rad]: by its printed digits, and as it turned unseen."""
    return np.asarray(rows.tables_step[0] / 2 + acceleration * unseen_turn(rows, a, b) ** 2 / 2)


def _under_way(line: Timeline, visit: Visit, end: int, after: Visit, latest: int) -> tuple[int, int]:
    """First and last row of the move to a visit. A tool that draws on tables may hardly move in the world where it
    leaves a stop, of which end is the last row, and where it comes to one, by row latest: then the tables tell, and the
    line's checks whether they go in step with it."""
    move = after.point.move
    if move is None or not (units := turned_under(move)):
        return end, after.arrive
    leave = _stands(line, units, max(visit.arrive, int(np.searchsorted(line.rows.t, visit.ready))), end, False)
    come = _stands(line, units, after.arrive, latest, True)
    return int(leave[-1]) if len(leave) else end, int(come[0]) if len(come) else after.arrive


def _latest(program: Program, rows: Rows, visit: Visit) -> int:
    """The last row of a stop at which what turns on the way there may come to stand: all waits are still to come, and
    no table has turned there by itself."""
    if not visit.point.holds:
        return visit.depart
    steps = _steps(program, visit)
    if any(step.units for step in steps):
        return visit.arrive
    left = sum(step.lasts for step in steps)
    last = rows.t[visit.depart] - left + _slack(rows, visit.arrive, visit.depart)
    return max(int(np.searchsorted(rows.t, last, side="right")) - 1, visit.arrive)


def _slack(rows: Rows, a: int, b: int) -> float:
    """What is granted to waits between rows a and b [s]."""
    return float(DWELL + rows.doubt_t + 2 * (rows.open_time[a] + rows.open_time[b]))


def _steps(program: Program, visit: Visit) -> tuple[_Step, ...]:
    """What the tool waits for at a point."""
    return tuple(
        _Step(getattr(program.motions[i], "units", ()), hold.begin, hold.wait.duration)
        for (i, _), hold in zip(visit.point.holds, visit.holds, strict=False)
    )


def check_tables(program: Program, line: Timeline) -> list[Finding]:
    """Of every positioner's axis in the file: that it goes from position to position as the program wants, stands where
    the program turns another or none, and keeps its velocity and acceleration. The worst of each kind, of each axis."""
    rows, tables = line.rows, line.rows.trajectory.tables
    if tables is None:
        return []
    found: dict[tuple[str, str], Finding] = {}
    moves = [unit for motion in reversed(program.motions) for unit in getattr(motion, "units", ())]
    at, hardest = {unit.column: unit.start for unit in moves}, {unit.column: unit.acceleration for unit in moves}
    for phase in _phases(program, line):
        for j, name in enumerate(tables.names):
            units = [unit for unit in phase.units if unit.column == name]
            for one in _axis(rows, tables, j, phase, units, at[name], hardest[name]):
                known = found.get((one.check, name))
                worse = known is not None and one.value * known.limit > known.value * one.limit
                if known is None or (known.passed and (not one.passed or (worse and one.check != _POSITION))):
                    found[one.check, name] = one
            at[name] = units[-1].end if units else at[name]
    return [*found.values()]


def _axis(
    rows: Rows, tables: Trajectory, j: int, phase: _Phase, units: Sequence[UnitMove], start: float, hardest: float
) -> Iterator[Finding]:
    """Findings about one axis in a phase that begins with it at start [rad]. hardest: its acceleration limit."""
    a, b, name, source = phase.first, phase.last, tables.names[j], phase.visit.point.source
    unit = axis_unit(name)
    q, t = tables.q[a : b + 1, j], rows.t[a : b + 1]
    step, step_v = rows.tables_step
    granted = _granted(rows, hardest, a, b)
    soonest, behind = phase.window(name)
    slack = _slack(rows, a, b)
    before = max(int(np.searchsorted(t, soonest - slack, side="right")), 1)  # rows that come before the turn
    off = (np.abs(q - start) - granted)[: len(q) if not units else before]
    i = int(np.argmax(off))
    yield finding(_POSITION, name, float(q[i]), start, unit, bool(off[i] <= JOINT_TARGET),
                  time=float(t[i]), source=source, bound="wanted")  # fmt: skip
    if not units:
        return
    after = min(int(np.searchsorted(t, t[-1] - behind + slack)), len(t) - 1)  # the first row that comes behind it
    off = (np.abs(q - units[-1].end) - granted)[after:]
    i = after + int(np.argmax(off))
    yield finding(_POSITION, name, float(q[i]), units[-1].end, unit, bool(off.max() <= JOINT_TARGET),
                  time=float(t[i]), source=source, bound="wanted", note=f" at {phase.visit.point.name}")  # fmt: skip
    most = float(granted.max()) + step / 2  # two printed places are compared
    i, wanted = _astray(q, start, units, most)
    if abs(float(q[i]) - wanted) - most > JOINT_TARGET:
        yield finding(_POSITION, name, float(q[i]), wanted, unit, False,
                      time=float(t[i]), source=source, bound="wanted")  # fmt: skip
    if b <= a:
        return
    h = np.diff(t)
    velocity, acceleration = max(one.velocity for one in units), max(one.acceleration for one in units)
    off_t = rows.unsure(slice(a, b), slice(a + 1, b + 1))
    mean, rate = np.maximum(np.abs(np.diff(q)) - step, 0.0) / (h + rows.doubt_t), np.diff(q) / h
    doubt = (step + np.abs(rate) * off_t) / shortest(h, off_t)  # about the mean speed
    if tables.qd is None:
        speed, change = mean, np.maximum(np.abs(np.diff(rate)) - doubt[1:] - doubt[:-1], 0.0)
        pull, when = change / ((h[1:] + h[:-1]) / 2 + rows.doubt_t), t[1:-1]
    else:
        v = tables.qd[a : b + 1, j]
        speed = np.maximum(mean, np.maximum(np.abs(v[1:]), np.abs(v[:-1])) - step_v)
        # the cubic between two rows: the mean of their speeds is the mean speed where the acceleration is steady
        bend = np.abs(rate - (v[1:] + v[:-1]) / 2) - doubt - step_v
        pull = (np.maximum(np.abs(np.diff(v)) - step_v, 0.0)) / (h + rows.doubt_t)
        pull, when = np.maximum(pull, np.maximum(bend, 0.0) / ((h + off_t) / 4)), t[:-1]
    for check, values, times, limit, sign in (
        ("speed", speed, t[:-1], velocity, f"{unit}/s"),
        ("acceleration", pull, when, acceleration, f"{unit}/s2"),
    ):
        if len(values):
            i = int(np.argmax(values))
            passed = bool(values[i] <= limit * (1 + JOINT))
            yield finding(f"positioner {check}", name, float(values[i]), limit, sign, passed, time=float(times[i]),
                          source=source, words=check)  # fmt: skip


def _astray(q: Array, start: float, units: Sequence[UnitMove], granted: float) -> tuple[int, float]:
    """The row of q (n,) that is farthest from where an axis may be on its way from position to position, and the
    nearest place [rad] where it might be: it comes to each, neither goes back nor beyond, and stands at the last."""
    first, begin, worst, off = 0, start, (0, float(q[0])), 0.0
    for unit in units:
        sign, span = (1.0 if unit.end > begin else -1.0), abs(unit.end - begin)
        path = sign * (q[first:] - begin)
        there = np.flatnonzero(path >= span - granted - JOINT_TARGET)
        path = path[: there[0] + 1] if len(there) else path
        may = np.minimum(np.maximum.accumulate(np.maximum(path, 0.0)), span)
        i = int(np.argmax(np.abs(path - may)))
        if abs(path[i] - may[i]) > off:
            worst, off = (first + i, begin + sign * float(may[i])), abs(float(path[i] - may[i]))
        if not len(there) and span - path.max() > off:
            worst, off = (first + int(np.argmax(path)), unit.end), span - float(path.max())
        first, begin = first + (len(path) - 1 if len(there) else int(np.argmax(path))), unit.end
    i = first + int(np.argmax(np.abs(q[first:] - begin)))
    return (i, begin) if first < len(q) - 1 and abs(q[i] - begin) > off else worst


def unseen_turn(rows: Rows, a: int, b: int) -> Array:
    """For how long a table may have turned unseen at rows a to b, s: a row at rest is near by, and the robot seems to
    stand until it has gone as far as printing hides of all axes."""
    k, part = len(rows.trajectory.names), slice(a, b + 1)
    hidden = np.sqrt(2 * k * rows.doubt_q[part] / rows.accelerations.most).max(axis=1)
    return np.asarray(2 * rows.open_time[part] + hidden)


def turned_frames(frames: dict[bytes, ToolKinematics], line: Timeline) -> dict[int, TurnedFrame]:
    """The frames over work objects that turn, by the number of the motion that is drawn there."""
    out: dict[int, TurnedFrame] = {}
    for _, visit in pairwise(line.visits):
        units = turned_under(visit.point.move) if visit.point.move is not None else ()
        if units and visit.event is not None:
            out[visit.point.index] = TurnedFrame.over(frames[np.asarray(visit.point.X_FT).tobytes()], units)
    return out
