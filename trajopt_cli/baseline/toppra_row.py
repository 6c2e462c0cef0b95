"""Row `toppra`: the fixed-rail plan's path, timed anew leg by leg with TOPP-RA.

The path is the plan's own, with the plan's time as its parameter: there the plan's timing is rate 1, and nothing is
singular where all axes rest. Axes' limits are columns, the caps on the TCP too: its speed and turning bound the rate,
its acceleration is held in twelve directions of the plane it can lie in. Between its points TOPP-RA does not look: each
leg is sampled between them, the limits around an excess are tightened by it and the leg is timed again; what is left
after that, and what the rows of a file add, is taken away by slowing the leg down as a whole.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, partial
from itertools import pairwise

import numpy as np

from trajopt_cli.baseline.case import Answer, Attempt, Case
from trajopt_cli.baseline.legs import Leg, LegKind, fixed_rail, speed_limits, use_of
from trajopt_cli.baseline.rows import Piece, apart, hold, rows_of
from trajopt_cli.geometry import Array
from trajopt_cli.problem.plan import Infeasible
from trajopt_cli.problem.plant import Plant
from trajopt_cli.timing.topp import TimeLaw, fastest_law
from trajopt_cli.trajectory import Trajectory, hermite

STEP = 5e-3  # s of the plan between the points of TOPP-RA; every switch of the plan is one besides
SAFE = 1 - 1e-4  # share of limits used: rows at 1 kHz are not quite the path between them
_DIRECTIONS = 12
_INNER = (0.25, 0.5, 0.75)
_ROUNDS = 4
_RATES = (1.0, 0.999, 0.997, 0.99, 0.98, 0.95, 0.9)  # shares of the greatest rate at the ends that are tried
_FASTEST = 10.0  # rate that stands for no bound
_JUMP = 1e-3  # share of an axis' acceleration whose change in a row makes it a switch
_BESIDE = 1e-8  # s from a row: its other side
_LEAST = 2e-3  # s between points that are no switches


def toppra(case: Case) -> Answer:
    """The fixed-rail plan's path timed with TOPP-RA, every stop a stop. Infeasible where a programmed time is too short
    for it, or where there is no fixed-rail plan."""
    given = fixed_rail(case)
    if isinstance(given, Infeasible):
        return given
    known: dict[bytes, tuple[Piece, bool] | Infeasible] = {}
    pieces, kept = [], 0
    for leg in given.legs:
        if leg.key not in known:
            known[leg.key] = _piece(case.plant, leg, given.plan.trajectory)
        found = known[leg.key]
        if isinstance(found, Infeasible):
            return found
        pieces.append(found[0])
        kept += not found[1]
    end = given.legs[-1].q_1 if given.legs else case.plant.start
    trajectory = rows_of(case.plant.robot.axis_names, pieces or [hold(end, 1e-3)], end)
    notes = ["the fixed-rail plan's path; only its timing is TOPP-RA's", *given.notes]
    if kept:
        notes.append(f"TOPP-RA finds no timing for {kept} of {len(pieces)} legs: they keep the plan's")
    return Attempt(given.program, trajectory, notes=tuple(notes))


def _piece(plant: Plant, leg: Leg, trajectory: Trajectory) -> tuple[Piece, bool] | Infeasible:
    """The leg timed, and whether TOPP-RA did it; or why its programmed time cannot be kept."""
    if leg.kind is LegKind.HOLD:
        return hold(leg.q_0, leg.lasts), True
    path = _Path.of(plant, leg, trajectory)
    found = _timed(path)
    law = TimeLaw(path.s, np.ones_like(path.s)) if found is None else _as_rows(path, found)
    if leg.duration is not None:
        if law.duration > leg.duration * (1 + 1e-3):
            return leg.refusal(f"cannot be made in {leg.duration:g} s: TOPP-RA needs {law.duration:.4f} s")
        law = law.slowed(leg.duration / law.duration)
    return Piece(law.duration, law.times, partial(_run, path, law)), found is not None


@dataclass(frozen=True, eq=False)
class _Path:
    """A leg of the plan: s is the plan's time from the leg's begin; its points (n,) are those of TOPP-RA."""

    plant: Plant
    leg: Leg
    trajectory: Trajectory
    s: Array

    @classmethod
    def of(cls, plant: Plant, leg: Leg, trajectory: Trajectory) -> _Path:
        t_0, t_1 = leg.span
        inside = (trajectory.t > t_0 + 1e-9) & (trajectory.t < t_1 - 1e-9)
        t = np.r_[t_0, trajectory.t[inside], t_1]
        jumps = np.zeros(len(t), dtype=bool)
        left, right = (hermite(trajectory, t[1:-1] + side)[2] for side in (-_BESIDE, _BESIDE))
        jumps[1:-1] = (np.abs(right - left) > _JUMP * plant.limits.acceleration).any(axis=1)
        jumps[[0, -1]] = True
        marks = t[jumps]
        wanted = np.concatenate([np.linspace(a, b, max(int((b - a) / STEP), 1) + 1)[1:-1] for a, b in pairwise(marks)])
        return cls(plant, leg, trajectory, np.unique(np.r_[marks, wanted]) - t_0)

    def at(self, s: Array) -> tuple[Array, Array, Array]:
        """Axes, their first and second derivatives (m, k) at s (m,)."""
        return hermite(self.trajectory, np.clip(self.leg.span[0] + s, *self.leg.span))

    @cached_property
    def begins(self) -> tuple[Array, Array, Array]:
        """Axes and derivatives (n-1, k) where every interval begins."""
        return self.at(self.s[:-1] + _BESIDE)

    @cached_property
    def ends(self) -> tuple[Array, Array, Array]:
        """Axes and derivatives (n-1, k) where every interval ends."""
        return self.at(self.s[1:] - _BESIDE)

    def columns(self, side: tuple[Array, Array, Array]) -> tuple[Array, Array]:
        """Slopes and bends (n-1, m) in shares of their limits: all axes, then the TCP in several directions."""
        q, first, second = side
        leg, limits, robot = self.leg, self.plant.limits.acceleration, self.plant.robot
        J = robot.jacobian(q, leg.X_FT)[:, :3]
        slope = (J @ first[..., None])[..., 0]
        bend = (J @ second[..., None])[..., 0]
        bend += (robot.jacobian_rate(q, first, leg.X_FT)[:, :3] @ first[..., None])[..., 0]
        ahead = _unit(np.where(np.linalg.norm(slope, axis=1, keepdims=True) > 1e-9, slope, bend))
        aside = _unit(bend - np.sum(bend * ahead, axis=1, keepdims=True) * ahead)
        turns = np.pi * np.arange(_DIRECTIONS) / _DIRECTIONS
        rows = np.cos(turns)[:, None, None] * ahead + np.sin(turns)[:, None, None] * aside
        tool = [np.einsum("dij,ij->id", rows, x) / leg.a_tcp for x in (slope, bend)]
        return np.hstack([first / limits, tool[0]]), np.hstack([second / limits, tool[1]])

    @cached_property
    def top(self) -> Array:
        """Greatest rate (n,) that axis speeds, TCP speed and turning allow at the points."""
        q, first, _ = self.at(self.s)
        leg = self.leg
        V = (self.plant.robot.jacobian(q, leg.X_FT) @ first[..., None])[..., 0]
        used = np.max(np.abs(first) / speed_limits(self.plant, leg), axis=1)
        used = np.maximum(used, np.linalg.norm(V[:, :3], axis=1) / leg.v_tcp)
        used = np.maximum(used, np.linalg.norm(V[:, 3:], axis=1) / leg.v_ori)
        return np.asarray(1 / np.maximum(used, 1 / _FASTEST))


def _unit(v: Array) -> Array:
    length = np.linalg.norm(v, axis=1, keepdims=True)
    return np.asarray(np.where(length > 1e-12, v / np.maximum(length, 1e-12), 0.0))


def _run(path: _Path, law: TimeLaw, t: Array) -> tuple[Array, Array]:
    s, rate, _ = law.at(t)
    q, first, _ = path.at(s)
    return q, first * rate[:, None]


def _as_rows(path: _Path, law: TimeLaw) -> TimeLaw:
    """The law slowed down until the cubics between the rows of a file keep all limits as well: where the plan's own
    rows bend by less than a switch, the new rows around them bend a little more."""
    piece = Piece(law.duration, law.times, partial(_run, path, law))
    rows = rows_of(path.trajectory.names, [piece], path.leg.q_1)
    t = np.r_[rows.t[:-1] + 1e-9, rows.t[1:] - 1e-9]
    return law.slowed(max(1.0, use_of(path.plant, path.leg, *hermite(rows, t)).slowing / SAFE))


def _timed(path: _Path) -> TimeLaw | None:
    """The fastest law that keeps all limits between TOPP-RA's points too; None where it finds none."""
    begins, ends = path.columns(path.begins), path.columns(path.ends)
    n = len(path.s) - 1
    slower, softer = np.full(n, 1 / SAFE), np.full(n, 1 / SAFE)
    best: TimeLaw | None = None
    for _ in range(_ROUNDS):
        law = _fastest(path, begins, ends, slower, softer)
        if law is None:
            break
        speed, acceleration = _excess(path, law)
        worst = max(float(speed.max()), float(np.sqrt(acceleration.max())))
        clean = law.slowed(max(1.0, worst / SAFE))
        if best is None or clean.duration < best.duration:
            best = clean
        if worst <= SAFE * (1 + 1e-6):
            break
        slower *= np.maximum(1.0, speed / SAFE)
        softer *= np.maximum(1.0, acceleration / SAFE * (1 + 1e-5))
    return best


def _fastest(
    path: _Path, begins: tuple[Array, Array], ends: tuple[Array, Array], slower: Array, softer: Array
) -> TimeLaw | None:
    """TOPP-RA with the limits of every interval (n-1,) tightened. All axes rest at the ends, whatever the rate there:
    the greatest that leads anywhere is taken."""
    top = path.top / np.maximum(np.r_[slower[:1], slower], np.r_[slower, slower[-1:]])
    scaled = [(slope * softer[:, None], bend * softer[:, None]) for slope, bend in (begins, ends)]
    first, last = (
        min(float(top[i]), float(np.sqrt(1 / max(np.abs(bend[i]).max(), 1 / _FASTEST**2))))
        for i, (_, bend) in zip((0, -1), scaled, strict=True)
    )
    for share in _RATES:
        law = fastest_law(path.s, top, scaled[0], scaled[1], first * share, last * share)
        if law is not None and apart(law.times):
            return law
    return None


def _excess(path: _Path, law: TimeLaw) -> tuple[Array, Array]:
    """The largest shares of speeds and of accelerations used in every interval (n-1,) of the law, ends included."""
    width = np.diff(law.times)
    inner = np.r_[1e-6, _INNER, 1 - 1e-6]
    t = (law.times[:-1, None] + width[:, None] * inner).ravel()
    s, rate, bend = law.at(t)
    q, first, second = path.at(s)
    qd = first * rate[:, None]
    qdd = second * rate[:, None] ** 2 + first * bend[:, None]
    uses = use_of(path.plant, path.leg, q, qd, qdd)
    shape = (len(width), len(inner))
    return uses.any_speed.reshape(shape).max(axis=1), uses.any_acceleration.reshape(shape).max(axis=1)
