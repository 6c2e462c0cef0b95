"""Motions as a page plays and draws them: thinned rows, who moves when, and what the program asks for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from trajopt_cli.findings import Report
from trajopt_cli.geometry import BoolArray
from trajopt_cli.motion import MoveExtJ, MoveL, PathMove, Program, SignalEvent, Wait
from trajopt_cli.page.encode import block
from trajopt_cli.page.samples import sample_times
from trajopt_cli.problem.constant_speed import Stretch
from trajopt_cli.problem.detours import way_told
from trajopt_cli.problem.plan import Plan
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.workspace import rail_ranges
from trajopt_cli.runs.summary import motion_label
from trajopt_cli.table import place, short_target
from trajopt_cli.trajectories.plan_series import PlanSeries, follow, programmed_speed, target_flange
from trajopt_cli.trajectory import Trajectory
from trajopt_cli.units import DEG, MM, slides

MOST_REACHES = 150
"""Poses whose reach is worked out; a millisecond or two each."""
_RESTS = 1e-9  # rad, m and per second: rounding


@dataclass(frozen=True, eq=False)
class Shown:
    """A motion on a page. name: for people. program: what it carries out. plan: without motions where only its rows are
    known. report: the judge's word, None where it was not asked. stretches: that should keep their programmed speed."""

    name: str
    program: Program
    plan: Plan
    report: Report | None = None
    stretches: Sequence[Stretch] = ()


def programs_of(user: Program, shown: Sequence[Shown]) -> tuple[list[Program], list[int]]:
    """Each program once, the user's first, and which of them a motion carries out."""
    programs = [user]
    which = []
    for one in shown:
        if not any(one.program is known for known in programs):
            programs.append(one.program)
        which.append(next(i for i, known in enumerate(programs) if known is one.program))
    return programs, which


def cycle_data(plant: Plant, one: Shown, program: int, coarse: float = 1.0) -> dict[str, Any]:
    """A motion as the page's scripts read it; program: index of its own; coarse: as in sample_times. SI."""
    plan = one.plan
    ends = np.array([time for motion in plan.motions for time in (motion.t_0, motion.t_1)])
    times = sample_times(plan.trajectory, plant.limits, ends, coarse)
    series = follow(one.program, plant, plan, one.name, times)
    legs = _legs(series) if series.legs else _rests(plan.trajectory)
    return {
        "name": one.name,
        "target": plan.target.value,
        "duration": plan.duration,
        "bound": plan.lower_bound,
        "program": program,
        "t": block(times - plan.trajectory.t[0]),
        "q": block(series.q),
        "qd": block(series.qd),
        "qdd": block(series.qdd),
        "speed": block(np.linalg.norm(series.V_WT[:, :3], axis=1)),
        "legs": legs,
        "programmed": _programmed(series),
        "dips": [
            [dip.start - plan.trajectory.t[0], dip.start + dip.duration - plan.trajectory.t[0]]
            for stretch in one.stretches
            for dip in stretch.dips
        ],
    }


def axes_data(plant: Plant) -> list[dict[str, Any]]:
    """Every axis with its limits, and the unit it is shown in: 1 unit is `scale` SI."""
    limits, rows = plant.limits, []
    for k, name in enumerate(limits.names):
        scale, unit = (MM, "mm") if slides(name) else (DEG, "deg")
        rows.append(
            {
                "name": name.replace("_", " "),
                "unit": unit,
                "scale": scale,
                "lower": float(limits.lower[k]),
                "upper": float(limits.upper[k]),
                "velocity": float(limits.velocity[k]),
                "acceleration": float(limits.most_acceleration[k]),
                "least_acceleration": float(limits.acceleration[k]),
            }
        )
    return rows


def reach_data(plant: Plant, program: Program, plan: Plan) -> dict[str, Any] | None:
    """From where on the rail each pose is in reach, by motion, and what the program asks of the rail; None but of one
    rail. Of a long program the first MOST_REACHES poses."""
    if plant.layout.r != 1:
        return None
    series = follow(program, plant, plan, "", plan.trajectory.t[[0, -1]])
    indices = {id(program.motions[m.index]): m.index for m in plan.motions}
    known: dict[bytes, list[list[float]]] = {}
    ranges: dict[int, list[list[float]]] = {}
    asked: dict[int, float] = {}
    left_out = 0
    for leg in series.moves:
        if leg.added:
            continue
        index = indices[id(leg.motion)]
        assert not isinstance(leg.motion, Wait)
        value = plant.rail_value(leg.motion.extax)
        if value is not None:
            asked[index] = float(value[0])
        X_WF = target_flange(leg)
        if X_WF is None:
            continue
        key = np.round(X_WF, 9).tobytes()
        if key not in known:
            if len(known) == MOST_REACHES:
                left_out += 1
                continue
            known[key] = rail_ranges(plant, X_WF).tolist()
        ranges[index] = known[key]
    return {"ranges": ranges, "asked": asked, "left_out": left_out}


def motions_data(program: Program, files: Sequence[str]) -> dict[str, list[Any]]:
    """A program's motions in columns; files: the paths that it names by index."""
    known = {path: i for i, path in enumerate(files)}
    labels = [motion_label(program, i) for i in range(len(program.motions))]
    return {
        "instruction": [one for one, _ in labels],
        "target": [short_target(target) for _, target in labels],
        "file": [known.get(motion.source.file, -1) for motion in program.motions],
        "line": [motion.source.line for motion in program.motions],
        "place": [place(motion.source) for motion in program.motions],
    }


def kind_of(motion: object) -> str:
    """Which colour a motion has: "line", "arc", "joint", "rail" or "wait"."""
    match motion:
        case Wait() | SignalEvent():
            return "wait"
        case MoveL():
            return "line"
        case PathMove():
            return "arc"
        case MoveExtJ():
            return "rail"
    return "joint"


def _legs(series: PlanSeries) -> dict[str, list[Any]]:
    ends = {motion.t_1: motion for motion in series.plan.motions if motion.t_1 > motion.t_0}
    legs = [leg for leg in series.legs if not leg.added]  # points that are added are part of the way to their motion's
    planned = [ends[leg.t_1] for leg in legs]
    told = {detour.motion: way_told(len(detour.points), detour.around) for detour in series.plan.detours}
    start = float(series.plan.trajectory.t[0])
    return {
        "index": [motion.index for motion in planned],
        "from": [motion.t_0 - start for motion in planned],
        "to": [motion.t_1 - start for motion in planned],
        "kind": [kind_of(leg.motion) for leg in legs],
        "binding": [
            "" if isinstance(leg.motion, Wait) and leg.motion.settles else motion.binding
            for leg, motion in zip(legs, planned, strict=True)
        ],
        "passed": [int(leg.passed) for leg in legs],
        "way": [told.get(motion.index, "") for motion in planned],
        "points": [[point.t - start for point in motion.via] for motion in planned],
    }


def _rests(rows: Trajectory) -> dict[str, list[Any]]:
    """Of a motion known by its rows alone: when any axis moves, and when all rest."""
    assert rows.qd is not None
    calm: BoolArray = np.asarray((np.abs(rows.qd) < _RESTS).all(axis=1))
    still: BoolArray = np.asarray(calm[:-1] & calm[1:] & (np.abs(np.diff(rows.q, axis=0)) < _RESTS).all(axis=1))
    cuts = np.r_[0, np.flatnonzero(np.diff(still.astype(int))) + 1, len(still)]
    spans = [(int(a), int(b)) for a, b in pairwise(cuts) if b > a]
    return {
        "index": [-1] * len(spans),
        "from": [float(rows.t[a] - rows.t[0]) for a, _ in spans],
        "to": [float(rows.t[b] - rows.t[0]) for _, b in spans],
        "kind": ["wait" if still[a] else "joint" for a, _ in spans],
        "binding": [""] * len(spans),
        "passed": [0] * len(spans),
        "way": [""] * len(spans),
        "points": [[] for _ in spans],
    }


def _programmed(series: PlanSeries) -> list[list[float]]:
    """From, to [s] and the TCP speed [m/s] that the program gives, at most the cap."""
    start, cap = float(series.plan.trajectory.t[0]), series.plant.tcp.speed
    out = []
    for leg in series.legs:
        speed = programmed_speed(series.plant, leg.motion)
        if speed is not None:
            out.append([leg.t_0 - start, leg.t_1 - start, min(speed, cap)])
    return out
