"""Which fly-by points of a program a plan passes in a corner, and why it stops at the others."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise

import numpy as np

from trajopt_cli.motion import FlyBy, Move, MoveExtJ, Program, Zone
from trajopt_cli.problem.plan import Plan
from trajopt_cli.problem.plant import Plant
from trajopt_cli.problem.programmed import PlantKinematics
from trajopt_cli.rapid.zones import fly_bys, stopped_fly_bys, ways
from trajopt_cli.trajectory import hermite

_AT = 1e-7  # m, rad: the axes are there
_RESTS = 1e-6  # m/s, rad/s: the tool stands
PARABOLIC = "cycle times of programs with corners are for parabolic corners"


@dataclass(frozen=True)
class Corners:
    """The programmed fly-bys by index of their motion. passed: how large their corners are; stopped: why they are
    stops, in words."""

    passed: Mapping[int, FlyBy]
    stopped: Mapping[int, str]


def corners_of(program: Program, plant: Plant, dropped: Collection[int] = ()) -> Corners:
    """The fly-bys of a program, driven without the motions that are dropped.

    Where a rail begins or ends to be held, a fly-by is a stop: the rail would move in the corner.
    """
    return _corners(program, plant, frozenset(dropped))


@lru_cache(maxsize=4)  # every question about a program asks for them
def _corners(program: Program, plant: Plant, dropped: frozenset[int]) -> Corners:
    kept = [index for index in range(len(program.motions)) if index not in dropped]
    driven = replace(program, motions=tuple(program.motions[index] for index in kept))
    if all(motion.zone.stop for motion in driven.motions if isinstance(motion, Move)):
        return Corners({}, {})
    kinematics = PlantKinematics(plant)
    lengths = ways(driven, kinematics)
    passed = {kept[i]: zone for i, zone in fly_bys(driven, kinematics, lengths).items()}
    stopped = {kept[i]: why for i, why in stopped_fly_bys(driven, kinematics, lengths).items()}
    moves = [index for index in kept if isinstance(program.motions[index], Move)]
    held = {index: getattr(program.motions[index], "hold", None) is not None for index in moves}
    for index, after in pairwise(moves):
        if plant.robot.has_rail and index in passed and held[index] != held[after]:
            del passed[index]
            stopped[index] = f"a rail hold {'ends' if held[index] else 'begins'} there"
    return Corners(passed, dict(sorted(stopped.items())))


def with_stops(program: Program) -> Program:
    """The program with every fly-by a stop."""
    fine = Zone("fine", True)
    motions = (replace(motion, zone=fine) if isinstance(motion, Move) else motion for motion in program.motions)
    return replace(program, motions=tuple(motions))


def passed_in(program: Program, plant: Plant, plan: Plan) -> frozenset[int]:
    """The motions whose fly-by a plan passes; it may stop at one that could be passed, where that is faster."""
    dropped = {motion.index for motion in plan.motions if motion.dropped}
    could = corners_of(program, plant, dropped).passed
    ends = [motion for motion in plan.motions if motion.index in could]
    if not ends:
        return frozenset()
    q, qd, _ = hermite(plan.trajectory, np.array([motion.t_1 for motion in ends]))
    out = set()
    for motion, axes, rates in zip(ends, q, qd, strict=True):
        move = program.motions[motion.index]
        assert isinstance(move, Move)
        X_FT = np.eye(4) if isinstance(move, MoveExtJ) else move.tool.X_FT
        stands = np.abs(plant.robot.jacobian(axes, X_FT) @ rates).max() < _RESTS
        if not (stands and np.abs(axes - motion.q_1).max() < _AT):
            out.add(motion.index)
    return frozenset(out)
