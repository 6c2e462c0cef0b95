"""Row `toppra`: the fixed-rail plan's path, timed anew from stop to stop with TOPP-RA.

The path is the plan's own, with the plan's time as its parameter: there the plan's timing is rate 1, and nothing is
singular where all axes rest. Axes' limits are columns, the caps on the TCP too: its speed and turning bound the rate,
its acceleration is held in twelve directions of the plane it can lie in. Between its points TOPP-RA does not look, so
every run is laid out in rows a millisecond apart, and what these use too much is taken away by slowing the run down as
a whole. (Tightening limits around each excess instead gains 0.01 %, for three times the time.)
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, partial
from itertools import pairwise

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.problem.plan import Infeasible
from trajopt_cli.problem.plant import Plant
from trajopt_cli.study.case import Answer, Attempt, Case
from trajopt_cli.study.legs import BaselineLegKind, LegLimits, StopToStop, caps_in, fixed_rail, tool_rates, use_of
from trajopt_cli.study.rows import Piece, apart, hold, lasting, rows_of
from trajopt_cli.timing.topp import TimeLaw, fastest_laws
from trajopt_cli.trajectory import Trajectory, hermite

STEP = 1e-3  # s of the plan between the points of TOPP-RA; every switch of the plan is one besides
SAFE = 1 - 1e-4  # share of limits used: rows at 1 kHz are not quite the path between them
_DIRECTIONS = 12
_RATES = (1.0, 0.999, 0.997, 0.99, 0.98, 0.95, 0.9)  # shares of the greatest rate at the ends that are tried
_FASTEST = 10.0  # rate that stands for no bound
_JUMP = 1e-3  # share of an axis' acceleration whose change in a row makes it a switch
_SLIVER = 2e-5  # s; where corners touch, rounding leaves ways of less between them
_BESIDE = 1e-8  # s from a row: its other side


def toppra(case: Case) -> Answer:
    """The fixed-rail plan's path timed with TOPP-RA, every stop a stop. Infeasible where a programmed time is too short
    for it, or where there is no fixed-rail plan."""
    given = fixed_rail(case)
    if isinstance(given, Infeasible):
        return given
    known: dict[bytes, tuple[Piece, bool] | Infeasible] = {}
    pieces, kept = list[Piece](), 0
    for run in given.runs:
        key = run.key
        if key not in known:
            known[key] = _piece(case.plant, run, given.plan.trajectory)
        found = known[key]
        if isinstance(found, Infeasible):
            return found
        pieces.append(lasting(found[0], run.least))
        kept += not found[1]
    end = case.plant.start if given.end is None else given.end
    trajectory = rows_of(case.plant.robot.axis_names, pieces or [hold(end, 1e-3)], end)
    notes = ["the fixed-rail plan's path; only its timing is TOPP-RA's", *given.notes]
    if kept:
        notes.append(f"TOPP-RA finds no timing for {kept} of {len(given.runs)} runs: they keep the plan's")
    return Attempt(given.program, trajectory, notes=tuple(notes))


def _piece(plant: Plant, run: StopToStop, trajectory: Trajectory) -> tuple[Piece, bool] | Infeasible:
    """The run timed, and whether TOPP-RA did it; or why its programmed time cannot be kept."""
    leg = run.legs[0]
    if leg.kind is BaselineLegKind.HOLD:
        return hold(leg.q_0, leg.lasts), True
    path = _Path.of(plant, run, trajectory)
    found = _timed(path)
    plans = TimeLaw(path.s, np.ones_like(path.s))
    law = found or plans
    if leg.duration is not None and len(run.legs) == 1:
        fits = leg.duration * (1 + 1e-9)
        if law.duration > fits:  # by a hair, where the plan itself takes no longer than it may
            law = plans
        if law.duration > fits:
            return leg.refusal(f"cannot be made in {leg.duration:g} s: TOPP-RA needs {(found or plans).duration:.4f} s")
        law = law.slowed(leg.duration / law.duration)
    return Piece(law.duration, law.times, partial(_run, path, law)), law is not plans


@dataclass(frozen=True, eq=False)
class _Path:
    """A run of the plan: s is the plan's time from the run's begin; its points (n,) are those of TOPP-RA."""

    plant: Plant
    run: StopToStop
    trajectory: Trajectory
    s: Array

    @classmethod
    def of(cls, plant: Plant, run: StopToStop, trajectory: Trajectory) -> _Path:
        t_0, t_1 = run.span
        inside = (trajectory.t > t_0 + 1e-9) & (trajectory.t < t_1 - 1e-9)
        t = np.r_[t_0, trajectory.t[inside], t_1]
        if run.course is not None:
            t = np.r_[t[:-1][np.diff(t) > _SLIVER], t_1]
            t[0] = t_0
        jumps = np.zeros(len(t), dtype=bool)
        left, right = (hermite(trajectory, t[1:-1] + side)[2] for side in (-_BESIDE, _BESIDE))
        jumps[1:-1] = (np.abs(right - left) > _JUMP * plant.limits.acceleration).any(axis=1)
        jumps[[0, -1]] = True
        ends = np.array([leg.span[1] for leg in run.legs])
        jumps[np.abs(t[:, None] - ends).argmin(axis=0)] = True  # rows, but for rounding
        marks = t[jumps]
        wanted = np.concatenate(
            [np.linspace(a, b, max(int((b - a) / (STEP)), 1) + 1)[1:-1] for a, b in pairwise(marks)]
        )
        return cls(plant, run, trajectory, np.unique(np.r_[marks, wanted]) - t_0)

    def at(self, s: Array) -> tuple[Array, Array, Array]:
        """Axes, their first and second derivatives (m, k) at s (m,)."""
        t_0, t_1 = self.run.span
        return hermite(self.trajectory, np.clip(t_0 + s, t_0, t_1))

    def caps(self, s: Array) -> LegLimits:
        """Limits in force at s (m,)."""
        return caps_in(self.plant, self.run, self.run.span[0] + s)

    @cached_property
    def begins(self) -> tuple[Array, Array, Array]:
        """Axes and derivatives (n-1, k) where every interval begins."""
        return self.at(self.s[:-1] + _BESIDE)

    @cached_property
    def ends(self) -> tuple[Array, Array, Array]:
        """Axes and derivatives (n-1, k) where every interval ends."""
        return self.at(self.s[1:] - _BESIDE)

    def columns(self, side: tuple[Array, Array, Array], caps: LegLimits) -> tuple[Array, Array]:
        """Slopes and bends (n-1, m) in shares of their limits: all axes, then the TCP in several directions."""
        q, first, second = side
        V, bend = tool_rates(self.plant, caps.X_FT, q, first, second)
        slope = V[:, :3]
        ahead = _unit(np.where(np.linalg.norm(slope, axis=1, keepdims=True) > 1e-9, slope, bend))
        aside = _unit(bend - np.sum(bend * ahead, axis=1, keepdims=True) * ahead)
        turns = np.pi * np.arange(_DIRECTIONS) / _DIRECTIONS
        rows = np.cos(turns)[:, None, None] * ahead + np.sin(turns)[:, None, None] * aside
        tool = [np.einsum("dij,ij->id", rows, x) / np.reshape(caps.a_tcp, (-1, 1)) for x in (slope, bend)]
        return np.hstack([first / caps.acceleration, tool[0]]), np.hstack([second / caps.acceleration, tool[1]])

    @cached_property
    def top(self) -> Array:
        """Greatest rate (n,) that axis speeds, TCP speed and turning allow at the points; where two legs meet, of
        both."""
        q, first, _ = self.at(self.s)
        used = np.full(len(self.s), 1 / _FASTEST)
        for side in (-_BESIDE, _BESIDE):
            caps = self.caps(self.s + side)
            V = tool_rates(self.plant, caps.X_FT, q, first, first)[0]
            used = np.maximum(used, np.max(np.abs(first) / caps.speed, axis=1))
            used = np.maximum(used, np.linalg.norm(V[:, :3], axis=1) / caps.v_tcp)
            used = np.maximum(used, np.linalg.norm(V[:, 3:], axis=1) / caps.v_ori)
        return np.asarray(1 / used)


def _unit(v: Array) -> Array:
    length = np.linalg.norm(v, axis=1, keepdims=True)
    return np.asarray(np.where(length > 1e-12, v / np.maximum(length, 1e-12), 0.0))


def _run(path: _Path, law: TimeLaw, t: Array) -> tuple[Array, Array]:
    s, rate, _ = law.at(t)
    q, first, _ = path.at(s)
    return q, first * rate[:, None]


def _timed(path: _Path) -> TimeLaw | None:
    """The fastest law by TOPP-RA, None where it finds none; slowed down until the cubics between the rows of a file
    keep all limits."""
    law = _fastest(path)
    if law is None:
        return None
    piece = Piece(law.duration, law.times, partial(_run, path, law))
    rows = rows_of(path.trajectory.names, [piece], path.run.legs[-1].q_1)
    t = np.r_[rows.t[:-1] + 1e-9, (rows.t[:-1] + rows.t[1:]) / 2, rows.t[1:] - 1e-9]
    use = use_of(path.plant, path.caps(law.at(t)[0]), *hermite(rows, t))
    return law.slowed(max(1.0, use.slowing / SAFE))


def _fastest(path: _Path) -> TimeLaw | None:
    """TOPP-RA's law. All axes rest at the ends, whatever the rate there: the greatest that leads anywhere is taken."""
    middles = path.caps((path.s[:-1] + path.s[1:]) / 2)
    begins, ends = path.columns(path.begins, middles), path.columns(path.ends, middles)
    first, last = (
        min(float(path.top[i]), float(np.sqrt(1 / max(np.abs(bend[i]).max(), 1 / _FASTEST**2))))
        for i, (_, bend) in zip((0, -1), (begins, ends), strict=True)
    )
    for share in _RATES:
        rows = [(slope[None], bend[None]) for slope, bend in (begins, ends)]
        law = fastest_laws(path.s, path.top[None], rows[0], rows[1], first * share, last * share).law(0)
        if law is not None and apart(law.times):
            return law
    return None
