"""Against plain peers: python benchmarks/bench_peers.py [--seeds 3000-3099] [--jobs N] [--json FILE] [--only ...]

Each seed is one program of one kind on a cell of its own: stations at random places along a rail (or around a robot
without one), served in random order; every second one from seed 3000 on is full of corners, of the kinds of
bench_corners.py. The peer is what an engineer writes in a day around toppra:
dynamic programming over rail positions on a uniform grid (and those written), branches and turns at every point; joint
moves straight in the joints, lines and waits along a rail that shares the way's progress; every edge of the best route
timed by toppra, the route searched anew until none of its edges is an estimate; then twice on finer grids around it.
Of a program with corners the route is that of its stops; then the rail's positions are shifted one by one as long as
toppra drives the blended path from stop to stop in less. For a stream it may stop at corners beside joint moves.
Caps on the TCP's acceleration slow a whole leg down until they hold. That answers the question of a RAPID controller;
for a stream, Ruckig drives the joint moves of the same route, every axis on its own, where that is faster. Drake, where
it is installed, says how long the route takes by its own Toppra. Beside them stand trajopt's plans for both targets.
All but Drake's are judged from the rows of a file; seconds are those of the processor, from program to rows.
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import os
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property, partial
from itertools import count, pairwise
from multiprocessing.connection import Connection
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np
from bench_corners import KINDS as CORNER_KINDS
from bench_corners import Writer

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))  # tcp_motion, timing.toppra_law
from tcp_motion import inverse_acceleration, inverse_velocity
from timing.toppra_law import fastest_law

from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.graph_search.ik_tables import IkTable, station_table
from trajopt_cli.job import Job, read_job
from trajopt_cli.joint_csv import write_csv_text
from trajopt_cli.path.hermite import hermite as cubic
from trajopt_cli.path_timing.sampled_path import SampledPath, finer, sample_path
from trajopt_cli.pipeline.planning import judge, may_change
from trajopt_cli.plan import optimize
from trajopt_cli.problem.build import build_problem
from trajopt_cli.problem.decision_scope import EVERYTHING
from trajopt_cli.problem.editable import Loops
from trajopt_cli.problem.plan import Infeasible, Target
from trajopt_cli.problem.problem import Leg, LegKind, Problem
from trajopt_cli.study.rows import Piece, hold, rows_of
from trajopt_cli.study.rows import apart as apart_enough
from trajopt_cli.timing.point_to_point import point_to_point
from trajopt_cli.timing.topp import TimeLaw
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectory import Trajectory, hermite

KINDS = ("literal", "offs", "loop", "call", "bench")  # bench: no rail
WITH_CORNERS = 3000  # the first seed that may have corners
PATIENCE = 400.0  # s of wall clock for one answer
HOME = "[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]]"

CELL = """robot: irb140_rail
profile: default
rail: {eax: a, stroke: [-0.2, 2.2]}
limits:
  rail: {velocity: 1.0, acceleration: 3.0, source: "benchmark"}
tcp: {speed: 2.5, acceleration: 20, source: "benchmark"}
start: {joints: "[0, 0, 0, 0, 30, 0] deg", rail: 0}
"""
BENCH = 'robot: irb140\nprofile: default\nstart: {joints: "[0, 0, 0, 0, 30, 0] deg"}\n'
REPOSITORY = Path(__file__).parents[1]
Row = dict[str, Any]  # of the table: seed, kind, and the answers by name
POSITIONS = 25  # of the rail on the first grid
FINER = ((4, 4), (4, 16))  # positions to either side of the route's, and into how many parts they split the first grid
COARSE, FINE = 25, 401  # points of toppra on an edge of the search, and of the answer
LATE = 5e-4  # relative, from which one answer is later than another
AGAIN = 25  # routes between two times that states out of the question are left out
NEARLY = 0.97  # of an estimated time stand for a least one
BUDGET = 8.0  # s of processor for the peer's search on each grid
SETTLED = 2e-4  # relative: the route is that near the least that any could take
SAFE = 1 + 2e-6  # slowing besides: rows of a file are not quite the path
SHIFTS = (0.06, 0.02, 0.006, 0.002)  # m by which the rail is shifted at points beside corners
HARDLY, DISTANCE = 1 + 3e-5, 1e-4  # by which a passage is slower besides; s between its nodes that are rows
SHIFTING = 20.0  # s of processor for that
AROUND = (
    np.array([one for one in np.ndindex(3, 3, 3) if one > (1, 1, 1)]) - 1.0
)  # directions that hold the tool's acceleration
AROUND /= np.linalg.norm(AROUND, axis=1)[:, None]


def program(seed: int) -> tuple[str, str, str]:
    """Kind, RAPID text and cell file of one seed."""
    if seed >= WITH_CORNERS and seed % 2:
        writer = Writer(seed // 2)
        return writer.kind, writer.text(), writer.cell
    rng = np.random.default_rng(seed)
    seed = seed // 2 if seed >= WITH_CORNERS else seed
    kind = KINDS[(seed - 1) % len(KINDS)]
    n, rail = int(rng.integers(2, 6)), kind != "bench"
    lift = int(rng.integers(60, 141))
    fast, slow = rng.choice(["v1000", "v2500"]), rng.choice(["v200", "v500", "v800"])
    targets, waits = [], [f"{rng.choice([0.15, 0.3, 0.5, 0.8]):g}" for _ in range(n)]
    for _ in range(n):
        x = rng.uniform(430, 560)
        y = rng.uniform(0, 1900) if rail else rng.uniform(-280, 280)
        z, turn = rng.uniform(200, 400), rng.uniform(-np.pi / 4, np.pi / 4)
        eax = f"{y:.1f}" if rail else "9E9"
        quaternion = f"[0,{np.sin(turn / 2):.7f},{np.cos(turn / 2):.7f},0]"
        targets.append(f"[[{x:.1f},{y:.1f},%s],{quaternion},[0,0,0,0],[{eax},9E9,9E9,9E9,9E9,9E9]]|{z:.1f}")
    at = [t.split("|")[0] % t.split("|")[1] for t in targets]
    above = [t.split("|")[0] % f"{float(t.split('|')[1]) + lift:.1f}" for t in targets]
    head = ["MODULE Cell", f"CONST jointtarget home:={HOME if rail else HOME.replace('[0,9E9', '[9E9,9E9')};"]
    serve = f"MoveJ Offs(p,0,0,{lift}), {fast}, fine, tool0;\nMoveL p, {slow}, fine, tool0;\nWaitTime %s;\n"
    serve += f"MoveL Offs(p,0,0,{lift}), {slow}, fine, tool0;\n"
    body = ""
    for i in range(n):
        head.append(f"CONST robtarget p{i}:={at[i]};")
        if kind in ("literal", "bench"):
            head.append(f"CONST robtarget a{i}:={above[i]};")
            move = f"a{i}, %s, fine, tool0;\n"
            body += f"MoveJ {move % fast}MoveL p{i}, {slow}, fine, tool0;\nWaitTime {waits[i]};\nMoveL {move % slow}"
        elif kind == "offs":
            body += (serve % waits[i]).replace("Offs(p,", f"Offs(p{i},").replace("MoveL p,", f"MoveL p{i},")
        elif kind == "call":
            body += f"serve p{i};\n"
    tail = ""
    if kind == "loop":
        head.append(f"CONST robtarget p{{{n}}}:=[{','.join(at)}];")
        body = f"FOR i FROM 1 TO {n} DO\n{(serve % waits[0]).replace('(p,', '(p{i},').replace(' p,', ' p{i},')}ENDFOR\n"
    elif kind == "call":
        tail = f"PROC serve(robtarget p)\n{serve % waits[0]}ENDPROC\n"
    text = "\n".join(head) + f"\nPROC main()\n{body}MoveAbsJ home, {fast}, fine, tool0;\nENDPROC\n{tail}ENDMODULE\n"
    return kind, text, CELL if rail else BENCH


@dataclass(frozen=True, eq=False)
class Way:
    """One leg from axes q_0 to q_1 (k,): at shares s (m,) of it q, dq/ds, d2q/ds2 (m, k)."""

    axes: Axes
    leg: Leg
    q_0: Array
    q_1: Array
    X_WF: Array  # (4, 4) where the tool rests
    cfx: int

    def at(self, s: Array) -> tuple[Array, Array, Array] | None:
        """None where the configuration ends on the way."""
        D = self.q_1 - self.q_0
        if self.leg.kind is LegKind.JOINT:
            return self.q_0 + s[:, None] * D, np.tile(D, (len(s), 1)), np.zeros((len(s), len(D)))
        layout, robot, segment = self.axes.layout, self.axes.robot, self.leg.segment
        way = float(layout.place(D))
        # turns are followed from the begin, so the points between are dense whatever s is
        every = np.union1d(s, np.linspace(0, 1, COARSE))
        X_WF = self.X_WF if segment is None else segment.pose(every) @ inverse_pose(self.leg.X_FT)
        rail = float(layout.place(self.q_0)) + every * way
        arm = self.axes.inverse(np.broadcast_to(X_WF, (len(every), 4, 4)), rail)[:, self.cfx]
        arm = np.unwrap(arm, axis=0)
        arm += 2 * np.pi * np.round((self.q_0[layout.arm] - arm[0]) / (2 * np.pi))
        q = layout.join(rail, arm)
        inside = (q >= self.axes.lower - 1e-9) & (q <= self.axes.upper + 1e-9)
        if not inside.all() or np.abs(q[[0, -1]] - [self.q_0, self.q_1]).max() > 1e-6:
            return None
        q[0], q[-1] = self.q_0, self.q_1
        q = q[np.searchsorted(every, s)]
        twist = np.zeros((len(s), 6)) if segment is None else segment.twist(s)
        try:
            dq = inverse_velocity(robot, q, twist, way if layout.has_rail else None, self.leg.X_FT)
            ddq = inverse_acceleration(robot, q, dq, 0 * twist, 0.0 if layout.has_rail else None, self.leg.X_FT)
        except ValueError:  # singular on the way
            return None
        return q, dq, ddq

    def tool(self, q: Array, qd: Array, qdd: Array) -> tuple[Array, Array]:
        """The TCP's velocity (m, 6) and acceleration (m, 3)."""
        motion = self.axes.differential(q, self.leg.X_FT).motion(qd, qdd)
        return motion[:, 0], motion[:, 1, :3]

    def used(self, qd: Array, V: Array) -> Array:
        """The greatest share (m,) of a speed's limit that axes at qd (m, k) and the tool at V (m, 6) use."""
        tool = np.linalg.norm(V[:, :3], axis=1) / self.leg.v_tcp, np.linalg.norm(V[:, 3:], axis=1) / self.leg.v_ori
        return np.max([(np.abs(qd) / self.axes.velocity_on(self.leg)).max(axis=1), *tool], axis=0)

    def slowing(self, q: Array, qd: Array, qdd: Array) -> float:
        """By what factor a motion on this leg must take longer to keep its limits."""
        V, A = self.tool(q, qd, qdd)
        hard = (np.abs(qdd) / self.axes.acceleration).max(), np.linalg.norm(A, axis=1).max() / self.leg.a_tcp
        return float(max(1.0, self.used(qd, V).max(), np.sqrt(max(hard))))

    def law(self, n: int) -> TimeLaw | None:
        """By toppra on n points; longer where the TCP's acceleration wants it, and where the program says how long."""
        s = np.linspace(0, 1, n)
        path = self.at(s)
        if path is None:
            return None
        q, dq, ddq = path
        V, bent = self.tool(q, dq, ddq)
        used = self.used(dq, V)
        rows = dq / self.axes.acceleration, ddq / self.axes.acceleration
        law = by_toppra(s, 1 / np.maximum(used, 1e-6), [x[:-1] for x in rows], [x[1:] for x in rows])
        if law is None:
            return None
        u = np.gradient(law.rates**2, s) / 2
        A = V[:, :3] * u[:, None] + bent * (law.rates**2)[:, None]
        law = law.slowed(max(1.0, float(np.sqrt(np.linalg.norm(A, axis=1).max() / self.leg.a_tcp))))
        if self.leg.duration is None:
            return law
        return law.slowed(self.leg.duration / law.duration) if law.duration <= self.leg.duration else None

    def piece(self) -> Piece | None:
        """The motion as it is written, slowed down until the cubics between rows keep all limits."""
        still = not np.any(self.q_1 != self.q_0)
        if still:
            return hold(self.q_0, self.leg.duration or 0.0)
        law = self.law(FINE)
        for _ in range(3):
            if law is None:
                return None
            piece = Piece(law.duration, law.times, partial(self._run, law))
            rows = rows_of(self.axes.names, [piece], self.q_1)
            factor = self.slowing(*hermite(rows, np.r_[rows.t[:-1] + 1e-9, rows.t[1:] - 1e-9]))
            if factor == 1.0 or self.leg.duration is not None:
                break
            law = law.slowed(factor * SAFE)
        return piece

    def by_ruckig(self) -> tuple[Piece, ...]:
        """A joint move with every axis on its own, slowed down until the tool's caps hold; none for other legs."""
        if self.leg.kind is not LegKind.JOINT or not np.any(self.q_1 != self.q_0):
            return ()
        V, A = self.axes.velocity_on(self.leg), self.axes.acceleration
        found = point_to_point(self.q_0, self.q_1, V, A, least=self.leg.duration or 0.0)
        factor = self.slowing(*found.at(np.linspace(0, found.duration, FINE)))
        if factor > 1.0 and self.leg.duration is not None:
            return ()
        if factor > 1.0:
            found = found.slowed(factor * SAFE)
        piece = Piece(found.duration, found.switches, lambda t: found.at(t)[:2])
        return (piece,) if apart_enough(found.switches) else ()

    def _run(self, law: TimeLaw, t: Array) -> tuple[Array, Array]:
        s, rate, _ = law.at(t)
        unique, where = np.unique(s, return_inverse=True)
        path = self.at(unique)
        assert path is not None, "the way was driven at its points"
        return path[0][where], path[1][where] * rate[:, None]


def by_toppra(s: Array, top: Array, begins: Sequence[Array], ends: Sequence[Array]) -> TimeLaw | None:
    """The fastest from rest to rest; slopes and bends (n - 1, m) at both ends of every interval."""
    moves = np.max([np.abs(x).max(axis=0) for x in (begins[0], ends[0])], axis=0) > 1e-9
    if not moves.any():  # toppra's solver dislikes columns of nothing
        return None
    for scale in (1.0, 10.0, 0.1):  # it also gives up on some numbers that it finds too large or too small
        first, last = (tuple(x[:, moves] / scale**k for k, x in enumerate(one, 1)) for one in (begins, ends))
        law = fastest_law(s * scale, top * scale, first, last, 0.0, 0.0)
        if law is not None:
            return TimeLaw(s, law.rates / scale)
    return None


@dataclass(frozen=True, eq=False)
class Passage:
    """From stop to stop through corners: the blended path of a RAPID controller at its nodes, cubic between them."""

    axes: Axes
    problem: Problem
    path: SampledPath
    ends: tuple[Array, Array]  # axes (k,) at both stops, of which the path's own are off by rounding

    @classmethod
    def of(
        cls, axes: Axes, problem: Problem, run: tuple[int, int], q: Array, cfx: Sequence[int], fine: bool
    ) -> Passage | None:
        """Between axes q (M, k) on branches cfx; None where the arm cannot follow."""
        path = sample_path(axes, problem, run, q, cfx, 4 * COARSE if fine else COARSE, ramps=not fine)
        for _ in range(2 if fine else 0):
            path = None if path is None else finer(axes, problem, path, np.ones(len(path.part), dtype=bool))
        return None if path is None else cls(axes, problem, path, (q[run[0]], q[run[1]]))

    @cached_property
    def caps(self) -> tuple[Array, Array, Array, Array]:
        """Of every interval (n - 1,): speed of the axes (n - 1, k), of the tool, of its turning, its acceleration."""
        legs = [self.problem.legs[k] for k in self.path.leg]
        tool = np.array([(leg.v_tcp, leg.v_ori, leg.a_tcp) for leg in legs])
        return np.array([self.axes.velocity_on(leg) for leg in legs]), *tool.T

    def law(self) -> TimeLaw | None:
        """By toppra, the tool's acceleration held in a few directions."""
        along, first = self.path.along, self.path.first
        inside = (along.q >= self.axes.lower - 1e-9) & (along.q <= self.axes.upper + 1e-9)
        if not inside.all():
            return None
        V, v_tcp, v_ori, a_tcp = self.caps
        top, sides = np.full(len(self.path.sigma), np.inf), list[list[Array]]()
        for row, at in ((first, slice(None, -1)), (first + 1, slice(1, None))):
            speeds = [np.linalg.norm(x[row], axis=1) / cap for x, cap in ((along.v, v_tcp), (along.w, v_ori))]
            used = np.max([(np.abs(along.dq[row]) / V).max(axis=1), *speeds], axis=0)
            top[at] = np.minimum(top[at], 1 / np.maximum(used, 1e-6))
            sides.append([np.hstack([x[row] / self.axes.acceleration, tool[row] @ AROUND.T / a_tcp[:, None]])
                          for x, tool in ((along.dq, along.v), (along.ddq, along.bend))])  # fmt: skip
        return by_toppra(self.path.sigma, top, *sides)

    def piece(self) -> Piece | None:
        """The motion as it is written, slowed down until the cubics between rows keep all limits."""
        law = self.law()
        for _ in range(4):
            if law is None:
                return None
            piece = Piece(law.duration, self._rows(law), partial(self._run, law))
            rows = rows_of(self.axes.names, [piece], self.ends[1])
            t = np.r_[rows.t[:-1] + 1e-9, rows.t[1:] - 1e-9]
            factor = self.slowing(law, t, *hermite(rows, t))
            if factor == 1.0:
                return piece.slowed(HARDLY)
            law = law.slowed(factor * SAFE)
        return piece

    def _rows(self, law: TimeLaw) -> Array:
        """Times of the nodes that are rows: where parts meet, and the others that keep their distance."""
        t, edges = law.times, np.r_[0, np.cumsum(self.path.counts)]
        keep = [*t[edges]]
        for one in t[1:-1]:
            i = int(np.searchsorted(keep, one))
            if min(one - keep[i - 1], keep[i] - one) >= DISTANCE:
                keep.insert(i, one)
        return np.array(keep)

    def slowing(self, law: TimeLaw, t: Array, q: Array, qd: Array, qdd: Array) -> float:
        """By what factor the motion must take longer to keep its limits at times t (m,)."""
        at = np.clip(np.searchsorted(law.times, t, side="right") - 1, 0, len(self.path.leg) - 1)
        factor = 1.0
        for k in np.unique(self.path.leg):
            of = np.flatnonzero(self.path.leg[at] == k)
            if len(of):
                way = Way(self.axes, self.problem.legs[k], q[0], q[0], np.eye(4), 0)
                factor = max(factor, way.slowing(q[of], qd[of], qdd[of]))
        return factor

    def _run(self, law: TimeLaw, t: Array) -> tuple[Array, Array]:
        s, rate, _ = law.at(t)
        i = np.clip(np.searchsorted(law.s, s, side="right") - 1, 0, len(law.s) - 2)
        along, row, h = self.path.along, self.path.first[i], np.diff(law.s)[i, None]
        p, slope, _ = cubic(along.q[row], h * along.dq[row], along.q[row + 1], h * along.dq[row + 1],
                            (s - law.s[i])[:, None] / h)  # fmt: skip
        share = (s / law.s[-1])[:, None]
        p += (1 - share) * (self.ends[0] - along.q[0]) + share * (self.ends[1] - along.q[-1])
        return p, slope / h * rate[:, None]


@dataclass(frozen=True, eq=False)
class Layer:
    """What the axes may be at one waypoint: q (m, k), the number of the station's label and its branch (m,)."""

    q: Array
    label: Array
    cfx: Array


@dataclass(frozen=True, eq=False)
class Route:
    """Axes q and branch at every waypoint, and the time that all legs take by toppra."""

    time: float
    q: list[Array]
    cfx: list[int]


def trapezoid(way: Array, v: Array | float, a: Array | float) -> Array:
    """Time of a way from rest to rest."""
    return np.where(way > v * v / a, way / v + v / a, 2 * np.sqrt(way / a))


class Peer:
    """The search of one program."""

    def __init__(self, axes: Axes, problem: Problem):
        if problem.ties:
            raise NotImplementedError("targets that serve several passes: the peer knows no such thing")
        self.axes, self.problem = axes, problem
        self.times: dict[tuple[int, bytes], float] = {}  # of edges that toppra timed

    # ---------------------------------------------------------------------------------------------- states and edges

    def layers(self, route: list[Array] | None, beside: int, parts: int) -> list[Layer]:
        """States at all waypoints: on the first grid, or beside a route (M, k) on a finer one."""
        place, out = self.axes.layout.place, list[Layer]()
        for first, last in self.problem.stations:
            stops = self.problem.waypoints[first : last + 1]
            fixed = [stop.rail[0] for stop in stops if stop.rail[0] == stop.rail[1]]
            low, high = max((stop.rail for stop in stops), key=lambda rail: rail[1] - rail[0])
            grid = np.linspace(low, high, POSITIONS)
            if route is not None:
                step = (grid[1] - grid[0]) / parts
                near = np.array([float(place(q)) for q in route[first : last + 1]])
                grid = (near[:, None] + step * np.arange(-beside, beside + 1)).ravel()
            written = [stop.written for stop in stops]
            grid = np.round(np.clip(np.r_[grid, written], low, high), 9)
            table = station_table(self.axes, self.problem, first, last, np.unique(np.r_[grid, fixed]))
            out += [self._layer(table, i) for i in range(last - first + 1)]
        return out

    def _layer(self, table: IkTable, i: int) -> Layer:
        arm = table.waypoints[i]
        label, rail = np.nonzero(~np.isnan(arm[..., 0]))
        cfx = np.array([one.cfx for one in table.labels], dtype=int)
        return Layer(self.axes.layout.join(table.d[rail], arm[label, rail]), label, cfx[label])

    def least(self, k: int, a: Layer, b: Layer) -> Array:
        """No edge (m_a, m_b) of leg k takes less: every axis by itself (in joint moves all in proportion), and the
        tool along the chord."""
        leg, axes = self.problem.legs[k], self.axes
        D = np.abs(b.q[None] - a.q[:, None])
        V, A = axes.velocity_on(leg), axes.acceleration
        rail = axes.layout.place(D) > 0 if axes.layout.has_rail else np.zeros(D.shape[:2], dtype=bool)
        if leg.kind is LegKind.JOINT:
            share = np.maximum(D, 1e-12)
            T = trapezoid(np.ones(D.shape[:2]), (V / share).min(axis=-1), (A / share).min(axis=-1))
            p_a, p_b = ((axes.forward(x.q) @ leg.X_FT)[:, :3, 3] for x in (a, b))
            chord = np.linalg.norm(p_b[None] - p_a[:, None], axis=-1)
            T = np.maximum(T, trapezoid(chord, leg.v_tcp, leg.a_tcp))
        else:
            T = trapezoid(D, V, A).max(axis=-1)
            if leg.segment is not None:
                T = np.maximum(T, trapezoid(np.array(leg.chord), leg.v_tcp, leg.a_tcp))
                T = np.maximum(T, leg.angle / leg.v_ori)
            T = np.where(a.label[:, None] == b.label, T, np.inf)
        if leg.duration is not None:
            T = np.where(leg.duration * (1 + 1e-9) >= T, leg.duration, np.inf)
        return np.where(rail & (not leg.rail_moves), np.inf, T)

    def bent(self, k: int, a: Layer, b: Layer, rows: Array, columns: Array) -> Array:
        """Somewhat less than the time of the given edges of a joint move: a trapezoid whose top follows the tool's way
        through nine places."""
        leg, axes = self.problem.legs[k], self.axes
        s = np.linspace(0, 1, 9)[:, None]
        T = np.empty(len(rows))
        for part in np.array_split(np.arange(len(rows)), len(rows) // 2000 + 1):
            q_0, q_1 = a.q[rows[part]], b.q[columns[part]]
            p = (axes.forward(q_0[:, None] + s * (q_1 - q_0)[:, None]) @ leg.X_FT)[..., :3, 3]
            slope = np.linalg.norm(np.diff(p, axis=1), axis=-1) * (len(s) - 1)
            D = np.maximum(np.abs(q_1 - q_0), 1e-12)
            hard, axis_top = ((limit / D).min(axis=1) for limit in (axes.acceleration, axes.velocity_on(leg)))
            top = np.minimum(leg.v_tcp / np.maximum(slope, 1e-9), np.minimum(axis_top, np.sqrt(hard))[:, None])
            T[part] = NEARLY * ((1 / top).mean(axis=1) + (top[:, 0] + top[:, -1]) / (2 * hard))
        return T

    def way(self, k: int, q_0: Array, q_1: Array, cfx: int) -> Way:
        """Leg k between two states."""
        return Way(self.axes, self.problem.legs[k], q_0, q_1, np.asarray(self.problem.waypoints[k].X_WF), cfx)

    def timed(self, k: int, q_0: Array, q_1: Array, cfx: int) -> float:
        """Time of an edge by toppra, infinite where there is none."""
        key = k, q_0.tobytes() + q_1.tobytes()
        if key not in self.times:
            leg = self.problem.legs[k]
            law = self.way(k, q_0, q_1, cfx).law(COARSE) if np.any(q_0 != q_1) else None
            still = np.inf if np.any(q_0 != q_1) else leg.duration or 0.0
            self.times[key] = still if law is None else law.duration
        return self.times[key]

    def passed(self, run: tuple[int, int], q: Array, cfx: Sequence[int]) -> float:
        """Time from stop to stop through corners by toppra, infinite where there is none."""
        first, last = run
        if last == first + 1:
            return self.timed(first, q[first], q[last], max(cfx[first], cfx[last]))
        key = first, q[first : last + 1].tobytes()
        if key not in self.times:
            passage = Passage.of(self.axes, self.problem, run, q, cfx, fine=False)
            law = None if passage is None else passage.law()
            self.times[key] = np.inf if law is None else law.duration
        return self.times[key]

    def shifted(self, found: Route) -> Route:
        """A route whose rail positions are better for driving through its corners."""
        until, layout = process_time() + SHIFTING, self.axes.layout
        q = np.array(found.q)
        times = {run: self.passed(run, q, found.cfx) for run in self.problem.runs}
        for step in SHIFTS if layout.has_rail else ():
            better = True
            while better and process_time() < until:
                better = False
                for k, point in enumerate(self.problem.waypoints):
                    low, high = point.rail
                    beside = [run for run in self.problem.runs if run[0] <= k <= run[1]]
                    if low == high or not any(last > first + 1 for first, last in beside):
                        continue
                    for way in (-step, step):
                        rail = np.clip(float(layout.place(q[k])) + way, low, high)
                        arm = self.axes.inverse(np.asarray(point.X_WF)[None], np.array([rail]))[0, found.cfx[k]]
                        if np.isnan(arm).any() or process_time() > until:
                            continue
                        here = q[k, layout.arm]
                        other = q.copy()
                        other[k] = layout.join(rail, arm + 2 * np.pi * np.round((here - arm) / (2 * np.pi)))
                        new = {run: self.passed(run, other, found.cfx) for run in beside}
                        if sum(new.values()) < sum(times[run] for run in beside) - 1e-6:
                            q, better = other, True
                            times |= new
        return Route(sum(times.values()), list(q), found.cfx)

    # -------------------------------------------------------------------------------------------------------- search

    def best(self, layers: list[Layer], found: Route | None = None) -> Route | None:
        """The route of least time: estimates say too little, and are replaced along each best route in turn. found: a
        route known already, which the answer does not fall behind."""
        if not all(len(layer.q) for layer in layers):
            return found
        edges = [self.least(k, a, b) for k, (a, b) in enumerate(pairwise(layers))]
        until = process_time() + BUDGET
        for turn in count():
            if found is not None and turn % AGAIN == 0:
                self._bend(layers, edges, found.time)
                layers, edges = _cut(layers, edges, found.time)
            least, path = _shortest(edges)
            if not np.isfinite(least) or process_time() > until:
                break
            if found is not None and least >= found.time * (1 - SETTLED):
                break
            for k, (i, j) in enumerate(pairwise(path)):
                a, b = layers[k], layers[k + 1]
                edges[k][i, j] = self.timed(k, a.q[i], b.q[j], int(max(a.cfx[i], b.cfx[j])))
            time = float(sum(T[i, j] for T, (i, j) in zip(edges, pairwise(path), strict=True)))
            if np.isfinite(time) and (found is None or time < found.time):
                states = list(zip(layers, path, strict=True))
                found = Route(time, [x.q[i] for x, i in states], [int(x.cfx[i]) for x, i in states])
        return found

    def _bend(self, layers: list[Layer], edges: list[Array], most: float) -> None:
        """The sharper estimate for all joint moves that may be part of a route that takes less than `most`."""
        before, after = _from_ends(edges)
        for k, T in enumerate(edges):
            if self.problem.legs[k].kind is LegKind.JOINT and np.isfinite(self.problem.legs[k].v_tcp):
                rows, columns = np.nonzero(before[k][:, None] + T + after[k + 1] < most)
                T[rows, columns] = np.maximum(T[rows, columns], self.bent(k, layers[k], layers[k + 1], rows, columns))


def _shortest(edges: list[Array]) -> tuple[float, list[int]]:
    """The least time from the first layer to the last, and the states on the way."""
    before, back = np.zeros(len(edges[0])), []
    for T in edges:
        total = before[:, None] + T
        back.append(np.argmin(total, axis=0))
        before = total.min(axis=0)
    path = [int(np.argmin(before))]
    for step in reversed(back):
        path.append(int(step[path[-1]]))
    return float(before.min()), path[::-1]


def _from_ends(edges: list[Array]) -> tuple[list[Array], list[Array]]:
    """The least time to every state from the first layer, and from it to the last."""
    before, after = [np.zeros(len(edges[0]))], [np.zeros(edges[-1].shape[1])]
    for T in edges:
        before.append((before[-1][:, None] + T).min(axis=0))
    for T in reversed(edges):
        after.append((T + after[-1]).min(axis=1))
    return before, after[::-1]


def _cut(layers: list[Layer], edges: list[Array], most: float) -> tuple[list[Layer], list[Array]]:
    """Without the states that no route goes through in less than `most`; those of one such route remain."""
    before, after = _from_ends(edges)
    keep = [a + b <= most * (1 + 1e-9) for a, b in zip(before, after, strict=True)]
    kept = [Layer(x.q[some], x.label[some], x.cfx[some]) for x, some in zip(layers, keep, strict=True)]
    return kept, [T[np.ix_(a, b)] for T, (a, b) in zip(edges, pairwise(keep), strict=True)]


Answers = dict[str, tuple[Trajectory | str | float, Target]]


def peer(job: Job) -> Answers:
    """The peer's motion, which is one for the RAPID controller, with Ruckig one for a stream, and Drake's time; or why
    there is none."""
    agreed = may_change(job, Loops.KEEP)
    problem = build_problem(job.program, job.plant, EVERYTHING, Target.RAPID, agreed.changes[Target.RAPID])
    if isinstance(problem, Infeasible):
        return {"toppra": (str(problem), Target.RAPID)}
    axes = Axes.of(job.plant)
    search = Peer(axes, problem)
    found = search.best(search.layers(None, 0, 1))
    for beside, parts in FINER if axes.layout.has_rail else ():
        if found is not None:
            found = search.best(search.layers(found.q, beside, parts), found)
    if found is None:
        return {"toppra": ("no route", Target.RAPID)}
    runs, corners = problem.runs, any(point.fly_by is not None for point in problem.waypoints)
    if corners:
        found = search.shifted(found)
    q, cfx = found.q, found.cfx
    ways = [search.way(k, q[k], q[k + 1], max(cfx[k], cfx[k + 1])) for k in range(len(problem.legs))]
    passages = {run: Passage.of(axes, problem, run, np.array(q), cfx, fine=True) for run in runs if run[1] > run[0] + 1}
    straight, own = list[Piece](), list[Piece]()
    for first, last in runs:
        passage = passages.get((first, last))
        whole = ways[first].piece() if last == first + 1 else None if passage is None else passage.piece()
        if whole is None:
            return {"toppra": (f"leg {first} is not timed on the fine grid", Target.RAPID)}
        straight.append(whole)
        stops = [[way.piece(), *way.by_ruckig()] for way in ways[first:last]]
        each = [
            min((one for one in some if one is not None), key=lambda one: one.duration, default=None) for some in stops
        ]
        stopping = [one for one in each if one is not None]
        shorter = len(stopping) == len(each) and sum(one.duration for one in stopping) < whole.duration
        own += stopping if shorter else [whole]
    out: Answers = {}
    for name, chosen, target in (("toppra", straight, Target.RAPID), ("ruckig", own, Target.STREAM)):
        out[name] = rows_of(axes.names, [piece for piece in chosen if piece.duration > 0], q[-1]), target
    return out | {"drake": (by_drake(job, problem, ways, passages), Target.RAPID)}


def by_drake(
    job: Job, problem: Problem, ways: list[Way], passages: Mapping[tuple[int, int], Passage | None]
) -> float | str:
    """The time [s] from stop to stop by Drake's Toppra under the limits of the axes and of the tool's speed; caps on
    turning and on the tool's acceleration are left out, so it may be too short."""
    try:
        from pydrake.multibody.optimization import Toppra
        from pydrake.multibody.parsing import Parser
        from pydrake.multibody.plant import MultibodyPlant
        from pydrake.trajectories import PiecewisePolynomial
    except ImportError:
        return "not installed"
    plant, total, s = MultibodyPlant(0.0), 0.0, np.linspace(0, 1, FINE)
    model = Parser(plant).AddModels(str(REPOSITORY / "robots" / f"{job.plant.robot.name}.urdf"))[0]
    root = plant.get_body(plant.GetBodyIndices(model)[0])
    plant.WeldFrames(plant.world_frame(), root.body_frame())
    plant.Finalize()
    for run in problem.runs:
        way, passage = ways[run[0]], passages.get(run)
        V, A = way.axes.velocity_on(way.leg), way.axes.acceleration
        if passage is not None:
            path, row = passage.path, np.r_[passage.path.first, passage.path.first[-1] + 1]
            places, (q, dq) = path.sigma, (x[row] for x in (path.along.q, path.along.dq))
            caps, speed = np.minimum(passage.caps[1], 1e3), passage.caps[0].max(axis=0)
            limit: object = PiecewisePolynomial.ZeroOrderHold(places, np.r_[caps, caps[-1]][None])
        elif (found := way.at(s) if np.any(way.q_0 != way.q_1) else None) is not None:
            places, (q, dq, _), speed, limit = s, found, V, min(way.leg.v_tcp, 1e3)
        else:
            total += way.leg.duration or 0.0
            continue
        curve = PiecewisePolynomial.CubicHermite(places, q.T, dq.T)  # Toppra does not keep it alive
        solver = Toppra(curve, plant, places)
        solver.AddJointVelocityLimit(-speed, speed)
        solver.AddJointAccelerationLimit(-A, A)
        solver.AddFrameTranslationalSpeedLimit(plant.GetFrameByName("tool0"), limit)
        law = solver.SolvePathParameterization()
        if law is None:
            return "no timing"
        total += max(float(law.end_time()), way.leg.duration or 0.0)
    return total


def planned(job: Job, target: Target) -> Answers:
    """trajopt's plan for a target, without its lower bound."""
    changes = may_change(job, Loops.KEEP).changes[target]
    found = optimize(job.program, job.plant, target, bounded=False, changes=changes)
    return {target.value: (str(found) if isinstance(found, Infeasible) else found.trajectory, target)}


MAKERS: dict[str, Callable[[Job], Answers]] = {
    "peer": peer,
    "rapid": partial(planned, target=Target.RAPID),
    "stream": partial(planned, target=Target.STREAM),
}
NAMES = ("toppra", "ruckig", "drake", "rapid", "stream")
AGAINST = {"rapid": "toppra", "stream": "ruckig"}  # who answers the same question


def answer(job: Job, name: str) -> dict[str, dict[str, object]]:
    """One maker's answers as numbers: time, the processor's seconds, the judge's word; or why there is none."""
    found = MAKERS[name](job)
    seconds, out = round(sum(os.times()[:4]), 1), dict[str, dict[str, object]]()
    for one, (motion, target) in found.items():
        if isinstance(motion, str):
            out[one] = {"seconds": seconds, "says": motion}
        elif isinstance(motion, float):
            out[one] = {"seconds": seconds, "says": "", "time": motion}
        else:
            report = judge(job.plant, job.program, write_csv_text(motion), "rows", (), target, advice=False)
            says = "legal" if report.legal else f"ILLEGAL: {report.worst.message}"
            out[one] = {"seconds": seconds, "says": says, "time": motion.duration}
    return out


def apart(job: Job, name: str) -> dict[str, dict[str, object]]:
    """The answers of a process of its own, so that no failure and no patience ends the table."""

    def work(end: Connection) -> None:
        end.send(answer(job, name))

    ours, theirs = multiprocessing.Pipe(duplex=False)
    process = multiprocessing.get_context("fork").Process(target=work, args=(theirs,))
    process.start()
    theirs.close()
    first = "toppra" if name == "peer" else name
    try:
        if ours.poll(PATIENCE):
            return dict(ours.recv())
        return {first: {"seconds": PATIENCE, "says": f"nothing after {PATIENCE:g} s"}}
    except EOFError:
        return {first: {"says": "failed; its traceback stands above"}}
    finally:
        process.terminate()
        process.join()


def run(seed: int, folder: Path, makers: Sequence[str]) -> Row:
    """All answers to one program."""
    kind, text, cell = program(seed)
    module = folder / f"cell{seed}.mod"
    module.write_text(text)
    module.with_suffix(".yaml").write_text(cell)
    job, row = read_job(module), {"seed": seed, "kind": kind}
    for name in makers:
        row |= apart(job, name)
    return row


def line(row: Row) -> str:
    """A row of the table: times, ours as a difference to the peer's, seconds of processor, and what is wrong."""
    text, says = f"{row['seed']:4} {row['kind']:8}", list[str]()
    for name in NAMES:
        one = row.get(name, {})
        text += f" {one['time']:8.3f}" if "time" in one else f" {'-':>8}"
        if name in AGAINST:
            lead = ahead(row, name)
            text += f" {'-':>8}" if lead is None else f" {100 * lead:+6.2f} %"
        if name not in ("ruckig", "drake"):
            text += f" {one.get('seconds', 0):6.1f} s"
        if one.get("says", "legal") not in ("legal", "", "not installed"):
            says.append(f"{name}: {one['says']}")
    return text + "  " + "; ".join(says)


def ahead(row: Row, name: str, other: str | None = None) -> float | None:
    """How one of ours stands against a peer, by default that which answers the same question; None where one of the
    two is missing."""
    ours, theirs = row.get(name, {}), row.get(other or AGAINST[name], {})
    if ours.get("says") != "legal" or theirs.get("says") not in ("legal", "") or "time" not in theirs:
        return None
    return float(ours["time"] / theirs["time"] - 1)


def main() -> None:
    """Run every seed and print the table, worst first at the end."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", default="3000-3099")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--json", type=Path)
    parser.add_argument("--only", choices=tuple(MAKERS), action="append", help="leave the others out")
    options = parser.parse_args()
    first, _, last = options.seeds.partition("-")
    rows: list[Row] = []
    ours = "".join(f" {name:>8} {'':8} {'':8}" for name in AGAINST)
    head = f"seed kind     {'toppra':>8} {'':8} {'ruckig':>8} {'drake':>8}{ours}"
    print(head)
    with tempfile.TemporaryDirectory() as place, ThreadPoolExecutor(options.jobs) as pool:
        work = partial(run, folder=Path(place), makers=options.only or [*MAKERS])
        for row in pool.map(work, range(int(first), int(last or first) + 1)):
            rows.append(row)
            print(line(row), flush=True)
            if options.json:
                options.json.write_text(json.dumps(rows, indent=1))
    print("\nworst first\n" + head)
    for row in sorted(rows, key=lambda row: -max(ahead(row, name) or -1.0 for name in AGAINST)):
        print(line(row))
    print("\n".join(summary(rows)))


def summary(rows: list[Row]) -> Iterator[str]:
    """How ours stand against the peers over all programs on which both are legal, by kind; and Drake's time, which
    need not be a legal one."""
    for word, kinds in (("stops", KINDS), ("corners", CORNER_KINDS), *((kind, (kind,)) for kind in CORNER_KINDS)):
        some = [row for row in rows if row["kind"] in kinds]
        for name, other in (*AGAINST.items(), ("rapid", "drake")) if some else ():
            shares = [lead for row in some if (lead := ahead(row, name, other)) is not None]
            legal = sum(row.get(name, {}).get("says") == "legal" for row in some)
            text = f"{word:8} {name}: legal on {legal} of {len(some)}"
            if shares:
                late = sum(x > LATE for x in shares)
                text += f"; against {other} {100 * float(np.median(shares)):+.2f} % in the middle,"
                text += f" {100 * max(shares):+.2f} % at most, later on {late} of {len(shares)}"
            yield text


if __name__ == "__main__":
    main()
