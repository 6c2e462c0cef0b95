"""Where a plan falls below the programmed speed on lines and arcs that should keep it (constant_speed), and why."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from itertools import pairwise
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.motion import FlyBy, Move, PathMove, Program, SignalEvent, Source, Wait, motion_name, turned_under
from trajopt_cli.problem.acceleration_settings import acceleration_share, tcp_acceleration
from trajopt_cli.problem.plan import Plan, PlannedMotion
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.programmed import PlantKinematics
from trajopt_cli.rapid.zones import fly_bys, stopped_fly_bys
from trajopt_cli.trajectory import Trajectory, hermite

DIP = 0.01  # share of the programmed speed that the tool may lack
_REST = 1e-3  # share of it that is no motion
_AT_LIMIT = 0.99  # share of a limit from which it is what limits
_STEP = 1e-3  # s between samples; where a dip begins and ends is interpolated
_INSIDE = 1e-9  # s from a motion's end: accelerations jump there
_WRIST = 0.1  # |sin| of the bent wrist axis: within 6 degrees of the singularity
_REACH = 0.99  # share of the arm's reach


class Why(Enum):
    """What makes a tool slow down."""

    RUN_UP = "run-up from rest"
    RUN_DOWN = "run-down to rest"
    SHORT = "too short: run-up and run-down meet"
    STOP = "stop"
    CORNER = "corner"
    SPEED_CHANGE = "the programmed speed changes"
    LIMIT = "limit"


@dataclass(frozen=True)
class Dip:
    """An interval in which the tool is slower than programmed by more than DIP.

    index, source, name: the motion where it is slowest. along: how far on its way that is [m]. programmed, lowest,
    highest: speeds there and in the interval [m/s]. start, duration [s], length [m]: of the interval. detail: of a stop
    or corner its zone, of a change both speeds, else empty. limit: "joint_5 acceleration", the one that is used most,
    and used: to which share. beside: the singularity nearby, or empty.
    """

    index: int
    source: Source
    name: str
    along: float
    programmed: float
    lowest: float
    highest: float
    start: float
    duration: float
    length: float
    why: Why
    detail: str
    limit: str
    used: float
    beside: str

    @property
    def depth(self) -> float:
        """The share of the programmed speed that is missing where the tool is slowest."""
        return 1 - self.lowest / self.programmed

    @property
    def cause(self) -> str:
        """All of it in words: "corner z10 (line 35), limited by joint_5 acceleration"."""
        limited = f"limited by {self.limit}"
        if self.used < _AT_LIMIT:
            limited = f"the nearest limit is {self.limit}, used to {100 * self.used:.0f} %"
        parts = [self.detail or (self.why.value if self.why is not Why.LIMIT else ""), limited, self.beside]
        return ", ".join(part for part in parts if part)


@dataclass(frozen=True)
class Stretch:
    """Lines and arcs one after another that should keep their speed. first, last: their places in Program.motions.

    start, duration [s], length [m] of the tool's way; dips in order of time.
    """

    first: int
    last: int
    start: float
    duration: float
    length: float
    dips: tuple[Dip, ...]


def constant_speed(program: Program, plan: Plan, plant: Plant) -> tuple[Stretch, ...]:
    """The stretches of a plan that should keep their programmed speed, with their dips.

    A wait, a joint move or a line that need not keep it ends a stretch; a stop between two of its lines is a dip.
    """
    stretches = [*_stretches(program, plan.motions)]
    if not stretches:
        return ()
    kinematics = PlantKinematics(plant)
    points = _Points(fly_bys(program, kinematics), stopped_fly_bys(program, kinematics))
    return tuple(_Course(program, plant, plan.trajectory, motions, points).stretch for motions in stretches)


def stretch_record(program: Program, stretch: Stretch) -> dict[str, Any]:
    """A stretch as plain data for JSON, SI."""
    return {
        "from": str(program.motions[stretch.first].source),
        "to": str(program.motions[stretch.last].source),
        "start_s": stretch.start,
        "time_s": stretch.duration,
        "length_m": stretch.length,
        "dips": [
            {
                "index": dip.index,
                "source": str(dip.source),
                "along_m": dip.along,
                "programmed_m_s": dip.programmed,
                "lowest_m_s": dip.lowest,
                "depth": dip.depth,
                "start_s": dip.start,
                "time_s": dip.duration,
                "length_m": dip.length,
                "why": dip.why.name.lower(),
                "limit": dip.limit,
                "limit_used": dip.used,
                "cause": dip.cause,
            }
            for dip in stretch.dips
        ],
    }


def _stretches(program: Program, planned: Sequence[PlannedMotion]) -> Iterator[list[PlannedMotion]]:
    found: list[PlannedMotion] = []
    for one in planned:
        motion = program.motions[one.index]
        if isinstance(motion, SignalEvent) or one.dropped:
            continue
        if isinstance(motion, Wait) and (motion.settles or not motion.stops):
            continue
        if isinstance(motion, PathMove) and motion.constant_speed and not turned_under(motion):
            found += [one] if one.t_1 > one.t_0 else []  # a line to where it starts takes no time
        elif found:
            yield found
            found = []
    if found:
        yield found


@dataclass(frozen=True)
class _Points:
    """Fly-by points by the index of their motion: the corners of those that are passed, why the others are stops."""

    passed: Mapping[int, FlyBy]
    stopped: Mapping[int, str]


class _Course:
    """One stretch, sampled. Samples are numbered through; both ends of every motion are among them."""

    def __init__(
        self, program: Program, plant: Plant, trajectory: Trajectory, motions: Sequence[PlannedMotion], points: _Points
    ):
        self._program, self._plant, self._trajectory = program, plant, trajectory
        self._motions, self._points = motions, points
        self._moves = [move for one in motions if isinstance(move := program.motions[one.index], PathMove)]
        times, speeds, ways, wanted = [], [], [], []
        for one, move in zip(motions, self._moves, strict=True):
            t = np.linspace(one.t_0 + _INSIDE, one.t_1 - _INSIDE, max(round((one.t_1 - one.t_0) / _STEP), 2) + 1)
            q, qd, _ = hermite(trajectory, t)
            v = np.linalg.norm(plant.robot.differential(q, move.tool.X_FT).velocity(qd)[:, :3], axis=1)
            way = np.r_[0.0, np.cumsum(np.diff(t) * (v[1:] + v[:-1]) / 2)]
            times.append(t)
            speeds.append(v)
            ways.append(way)
            wanted.append(np.full(len(t), move.speed.v_tcp if move.duration is None else way[-1] / move.duration))
        self._lengths = [float(way[-1]) for way in ways]
        self._motion = np.repeat(np.arange(len(motions)), [len(t) for t in times])
        self._t, self._v, self._way, self._wanted = (np.concatenate(one) for one in (times, speeds, ways, wanted))
        self._share = self._v / np.maximum(self._wanted, _INSIDE)

    @property
    def stretch(self) -> Stretch:
        """With its dips."""
        first, last = self._motions[0], self._motions[-1]
        low = np.concatenate([[False], self._share < 1 - DIP, [False]])
        edges = np.flatnonzero(low[1:] != low[:-1])
        dips = tuple(self._dip(int(i), int(j) - 1) for i, j in zip(edges[::2], edges[1::2], strict=True))
        return Stretch(first.index, last.index, first.t_0, last.t_1 - first.t_0, sum(self._lengths), dips)

    def _dip(self, i: int, j: int) -> Dip:
        """The dip of samples i..j."""
        part = slice(i, j + 1)
        t, v = (np.r_[self._edge(i, i - 1, one), one[part], self._edge(j, j + 1, one)] for one in (self._t, self._v))
        k, why, detail = self._reason(i, j)
        move, limits = self._moves[self._motion[k]], self._limits(i, j)
        at_once = why not in (Why.RUN_UP, Why.RUN_DOWN, Why.SHORT, Why.STOP)
        limit, used = limits.at(k - i)
        if not at_once or used < _AT_LIMIT:
            limit, used = limits.longest
        return Dip(
            index=self._motions[self._motion[k]].index,
            source=move.source,
            name=motion_name(move),
            along=float(self._way[k]),
            programmed=float(self._wanted[k]),
            lowest=float(self._v[k]) if self._share[k] > _REST else 0.0,
            highest=float(self._v[part].max()),
            start=float(t[0]),
            duration=float(t[-1] - t[0]),
            length=float(np.diff(t) @ (v[1:] + v[:-1]) / 2),
            why=why,
            detail=detail,
            limit=limit,
            used=used,
            beside=self._beside(k) if at_once and not limit.startswith("TCP") else "",
        )

    def _edge(self, inside: int, outside: int, values: Array) -> float:
        """A value where the share passes 1 - DIP, between two samples; at the end of the stretch the sample's own."""
        if not 0 <= outside < len(self._t):
            return float(values[inside])
        a, b = self._share[inside], self._share[outside]
        return float(values[inside] + (1 - DIP - a) / (b - a) * (values[outside] - values[inside]))

    # --------------------------------------------------------------------------------------------------------- why

    def _reason(self, i: int, j: int) -> tuple[int, Why, str]:
        """The slowest sample, what makes it slow, and the words for that."""
        stops = [k for k in self._ends(i, j) if self._share[k] < _REST]
        if stops:
            more = f" and {len(stops) - 1} more" if len(stops) > 1 else ""
            return stops[0], Why.STOP, self._stop(stops[0]) + more
        up, down = i == 0 and self._share[0] < _REST, j == len(self._t) - 1 and self._share[-1] < _REST
        if up or down:
            return (i if up else j), (Why.RUN_UP if not down else Why.SHORT if up else Why.RUN_DOWN), ""
        k = i + int(np.argmin(self._share[i : j + 1]))
        if (zone := self._corner(k)) is not None:
            return k, Why.CORNER, f"corner {zone}"
        if (change := self._change(k)) is not None:
            return k, Why.SPEED_CHANGE, change
        return k, Why.LIMIT, ""

    def _ends(self, i: int, j: int) -> Iterator[int]:
        """The last samples of motions between i and j, but for the stretch's own end."""
        for k, after in pairwise(range(i, j + 1)):
            if self._motion[k] != self._motion[after]:
                yield k

    def _stop(self, k: int) -> str:
        index, zone = self._motions[self._motion[k]].index, self._moves[self._motion[k]].zone
        if zone.stop:
            return f"stop programmed there ({zone.criterion or zone.name})"
        reason = self._points.stopped.get(index)
        return f"{zone.name} driven as a stop{f': {reason}' if reason else ''}"

    def _corner(self, k: int) -> str | None:
        """The fly-by point in whose corner a sample lies."""
        n = int(self._motion[k])
        ends = [(self._before(self._motions[n].index), self._way[k])]
        ends.append((self._motions[n].index, self._lengths[n] - self._way[k]))
        for index, apart in ends:
            corner = None if index is None else self._points.passed.get(index)
            if corner is not None and index is not None and apart <= max(corner.radius, corner.turning):
                move = self._program.motions[index]
                assert isinstance(move, Move)
                return f"{move.zone.name} (line {move.source.line})"
        return None

    def _before(self, index: int) -> int | None:
        """The move before a motion."""
        earlier = range(index - 1, -1, -1)
        return next((one for one in earlier if isinstance(self._program.motions[one], Move)), None)

    def _change(self, k: int) -> str | None:
        """Both speeds where a sample stands at the end of a motion and is as fast as its neighbour should be."""
        for other in (k - 1, k + 1):
            if 0 <= other < len(self._t) and self._motion[other] != self._motion[k]:
                a, b = sorted((k, other))
                if self._wanted[a] != self._wanted[b] and self._v[k] >= (1 - DIP) * self._wanted[other]:
                    return (
                        f"the programmed speed changes from {self._wanted[a] * 1e3:g} to {self._wanted[b] * 1e3:g} mm/s"
                    )
        return None

    # ------------------------------------------------------------------------------------------------------ limits

    def _limits(self, i: int, j: int) -> _Limits:
        """How near to every limit samples i..j are."""
        plant, robot = self._plant, self._plant.robot
        parts = []
        for n in range(int(self._motion[i]), int(self._motion[j]) + 1):
            t = self._t[i : j + 1][self._motion[i : j + 1] == n]
            move = self._moves[n]
            q, qd, qdd = hermite(self._trajectory, t)
            V, A = np.moveaxis(robot.differential(q, move.tool.X_FT).motion(qd, qdd), 1, 0)
            velocity = plant.limits.velocity.copy()
            velocity[plant.layout.rail] = np.minimum(velocity[plant.layout.rail], move.speed.v_leax or np.inf)
            v, a = (np.linalg.norm(one[:, :3], axis=1) for one in (V, A))
            lower, upper = plant.limits.acceleration_at(q)
            parts.append(
                np.c_[
                    np.abs(qd) / velocity,
                    np.maximum(qdd / upper, -qdd / lower) / acceleration_share(move),
                    v / plant.tcp.speed,
                    a / tcp_acceleration(move, plant.tcp),
                    np.linalg.norm(V[:, 3:], axis=1) / move.speed.turning,
                ]
            )
        names = [f"{name} {kind}" for kind in ("speed", "acceleration") for name in plant.limits.names]
        return _Limits((*names, "TCP speed", "TCP acceleration", "TCP turning"), np.vstack(parts))

    def _beside(self, k: int) -> str:
        q, _, _ = hermite(self._trajectory, self._t[k : k + 1])
        reach, wrist = self._plant.robot.singularity_margins(q[:, self._plant.layout.arm])
        if wrist[0] < _WRIST:
            return "beside the wrist singularity"
        return "near the end of its reach" if reach[0] > _REACH else ""


@dataclass(frozen=True, eq=False)
class _Limits:
    """Ratios (n, m) of samples to the limits of those names (m,)."""

    names: tuple[str, ...]
    ratios: Array

    def at(self, k: int) -> tuple[str, float]:
        """The limit that one sample is nearest to, and the share of it that is used."""
        best = int(np.argmax(self.ratios[k]))
        return self.names[best], float(self.ratios[k, best])

    @property
    def longest(self) -> tuple[str, float]:
        """The limit that the most samples are at; where none is at any, the nearest one."""
        count, most = np.sum(self.ratios >= _AT_LIMIT, axis=0), np.max(self.ratios, axis=0)
        best = int(np.argmax(count if count.any() else most))
        return self.names[best], float(most[best])
