"""A tool that may be turned about an axis of its own: programs with turned targets, and which turns go together.

A target X_WT that is turned by a is X_WT R(u, a), u the tool's axis: the tool centre point and the axis stay. Between
turned targets MoveL interpolates orientation by slerp (RAPID reference manual, MoveL). With R0 R(u, a) and R1 R(u, a)
that is slerp(R0, R1) R(u, a): equal turns leave the axis on its taught way, whatever that is. With other turns it stays
there only where R0 and R1 have one axis; then the tool turns evenly by b - a more, if that is less than half a turn in
all. An arc is the same for equal turns, but where the orientation at its circle point counts. A stream, which makes its
own way, may turn the tool by any angle beyond that, and the axis stays: R(s) R(u, f).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from trajopt_cli.geometry import Array, inverse_pose, rotation_about
from trajopt_cli.motion import CirPathMode, FreeTurn, Motion, MoveC, PathMove, PoseMove, Program, Wait
from trajopt_cli.path.of_motion import segment_of
from trajopt_cli.problem.editable import Changes
from trajopt_cli.problem.problem import Leg, LegKind, Problem, TurnRoom, Waypoint

_SAME_AXIS = 1e-8  # between unit vectors
_POINT = 1e-9  # m: a line shorter than this only turns the tool
_OFF_AXIS = 1e-7  # the axis on a turned way from as taught: a tenth of what the judge lets pass
MOST = np.radians(170.0)
"""Turn on a line at most [rad]: at half a turn slerp may go either way."""
STEP = np.radians(1e-3)
"""Turns are whole multiples of this [rad]: the text says them with three decimals of a degree."""


def turned(program: Program, turns: Mapping[int, float]) -> Program:
    """The program with targets turned by angles [rad], by number of motion; what runs outside of its cycle has the
    turns of the same statements. The program itself where there are none."""
    if not any(turns.values()):
        return program
    by_text = {program.motions[i].written: angle for i, angle in turns.items()}
    motions = tuple(turned_motion(one, turns.get(i, 0.0)) for i, one in enumerate(program.motions))
    before, beyond = (
        tuple(turned_motion(one, by_text.get(one.written, 0.0)) for one in part or ())
        for part in (program.before, program.beyond)
    )
    return replace(program, motions=motions, before=None if program.before is None else before, beyond=beyond)


def turned_motion(motion: Motion, angle: float) -> Motion:
    """A move with its target turned by an angle [rad] more than it is; others as they are."""
    if not isinstance(motion, PoseMove) or motion.free is None or angle == 0.0:
        return motion
    return replace(motion, X_WT=turned_pose(motion.X_WT, motion.free, angle), turn=motion.turn + angle)


def turned_pose(X_WT: Array, free: FreeTurn, angle: float) -> Array:
    """The tool's pose (4, 4), turned about its axis by an angle [rad]."""
    out = np.array(X_WT)
    out[:3, :3] = out[:3, :3] @ rotation_about(free.axis, angle)
    return out


@dataclass(frozen=True, eq=False)
class TurnGroup:
    """Waypoints that must have one turn, as taught but for it, with their tools X_FT. free: what all of them allow."""

    waypoints: tuple[int, ...]
    X_FT: tuple[Array, ...]
    free: FreeTurn


@dataclass(frozen=True, eq=False)
class TurnGroups:
    """What of a problem may be turned. of (waypoints,): the number of a waypoint's group, -1 for none; apart: lines
    whose ends may have turns of their own, by leg."""

    problem: Problem
    groups: tuple[TurnGroup, ...]
    of: tuple[int, ...]
    apart: frozenset[int]

    def turns(self, angles: Array) -> dict[int, float]:
        """Turns by number of motion, from those (groups,) of all groups."""
        ends = (
            (self.problem.waypoints[k].motion, float(angle))
            for group, angle in zip(self.groups, angles, strict=True)
            for k in group.waypoints
        )
        motions = self.problem.program.motions
        return {i: angle for i, angle in ends if angle and i >= 0 and isinstance(motions[i], PoseMove)}

    def waypoint(self, k: int, angle: float) -> Waypoint:
        """Waypoint k turned by an angle [rad]."""
        group = self.groups[self.of[k]] if self.of[k] >= 0 else None
        if group is None or angle == 0.0:
            return self.problem.waypoints[k]
        X_FT = group.X_FT[group.waypoints.index(k)]
        X_WT = turned_pose(self.problem.waypoints[k].X_WF @ X_FT, group.free, angle)
        return replace(self.problem.waypoints[k], X_WF=X_WT @ inverse_pose(X_FT))

    def leg(self, k: int, before: Waypoint, angle: float) -> Leg:
        """Leg k from a turned waypoint to one turned by an angle [rad]."""
        leg = self.problem.legs[k]
        motion = turned_motion(self.problem.motion(leg.motion), angle)
        if leg.kind is not LegKind.LINE or not isinstance(motion, PathMove):
            return leg
        return replace(leg, segment=segment_of(motion, before.X_WF @ leg.X_FT))


def turn_groups(problem: Problem, changes: Changes, evenly: bool = True) -> TurnGroups:
    """Which waypoints of a problem as taught may be turned, those together that must be turned alike. evenly: on lines
    the tool turns as MoveL does."""
    count, motions = len(problem.waypoints), problem.program.motions
    parent, fixed, apart = list(range(count)), [True] * count, set[int]()

    def root(k: int) -> int:
        while parent[k] != k:
            parent[k] = k = parent[parent[k]]
        return k

    def tie(a: int, b: int) -> None:
        parent[root(b)] = root(a)

    moves = _moves(problem)
    frees = [None if move is None else move.free for move in moves]
    for k, point in enumerate(problem.waypoints):
        motion = motions[point.motion] if point.motion >= 0 else None
        may = motion is None or isinstance(motion, Wait) or point.motion in changes.values
        fixed[k] = point.q is not None or frees[k] is None or not may
    alike = {index: k for k, point in enumerate(problem.waypoints) if (index := point.motion) >= 0}
    for group in (*problem.ties, *(tuple(alike[i] for i in tied if i in alike) for tied in changes.ties)):
        for k in group[1:]:
            tie(group[0], k)
    for k, leg in enumerate(problem.legs):
        motion = motions[leg.motion]
        if leg.kind is LegKind.DWELL:
            tie(k, k + 1)
        elif leg.kind is LegKind.LINE and isinstance(motion, PathMove):
            arc = isinstance(motion, MoveC) and motion.settings.circle is CirPathMode.CIR_POINT_ORI
            if motion.free is None or leg.chord < _POINT or arc or motion.searches or motion.identity is not None:
                fixed[k] = fixed[k + 1] = True
                continue
            if not evenly:
                before, free = moves[k], frees[k]
                other = free is None or free.axis != motion.free.axis
                other = other or before is None or not np.array_equal(before.tool.X_FT, leg.X_FT)
                fixed[k] |= other
                if motion.units or leg.motion not in changes.values or (other and before is not None and before.turn):
                    fixed[k] = fixed[k + 1] = True
                else:
                    apart.add(k)
                continue
            R = [(problem.waypoints[i].X_WF @ leg.X_FT)[:3, :3] for i in (k, k + 1)]
            one_axis = np.abs((R[0] - R[1]) @ motion.free.axis).max() <= _SAME_AXIS
            if one_axis and not isinstance(motion, MoveC) and not motion.units and motion.speed.v_ori > 0:
                apart.add(k)
            else:
                tie(k, k + 1)
    members: dict[int, list[int]] = {}
    for k in range(count):
        members.setdefault(root(k), []).append(k)
    groups, of = list[TurnGroup](), [-1] * count
    for alike_ones in members.values():
        own = [free for k in alike_ones if (free := frees[k]) is not None]
        if any(fixed[k] for k in alike_ones) or any(one.axis != own[0].axis for one in own[1:]):
            continue
        free = FreeTurn(own[0].axis, max(one.low for one in own), min(one.high for one in own))
        for k in alike_ones:
            of[k] = len(groups)
        groups.append(
            TurnGroup(
                tuple(alike_ones), tuple(move.tool.X_FT for k in alike_ones if (move := moves[k]) is not None), free
            )
        )
    return TurnGroups(problem, tuple(groups), tuple(of), frozenset(apart))


def with_room_to_turn(problem: Problem, changes: Changes) -> Problem:
    """The problem whose stops, lines and arcs may turn their tools, inside the sectors, beyond how the program has
    them: what a stream may do. Stops that are tied to others, but a cycle's ends, stay as the program has them."""
    groups = turn_groups(problem, changes, evenly=False)
    points, legs = list(problem.waypoints), list(problem.legs)
    now = [0.0 if move is None else move.turn for move in _moves(problem)]

    def room(free: FreeTurn, X_FT: Array, k: int, slope: float = 0.0) -> TurnRoom:
        return TurnRoom(np.array(free.axis), X_FT, free.low - now[k], free.high - now[k], slope)

    for group in groups.groups:
        in_a_row = group.waypoints[problem.steady and group.waypoints[0] == 0 :]
        if all(b == a + 1 and legs[a].kind is LegKind.DWELL for a, b in pairwise(in_a_row)):
            for k, X_FT in zip(group.waypoints, group.X_FT, strict=True):
                points[k] = replace(points[k], turn=room(group.free, X_FT, k))
    for k, leg in enumerate(legs):
        motion = problem.motion(leg.motion)
        if leg.kind is LegKind.DWELL:
            legs[k] = replace(leg, turn=points[k].turn)
        elif k in groups.apart and isinstance(motion, PoseMove) and motion.free is not None:
            legs[k] = replace(leg, turn=room(motion.free, leg.X_FT, k, motion.turn - now[k]))
    return replace(problem, waypoints=tuple(points), legs=tuple(legs))


def _moves(problem: Problem) -> list[PoseMove | None]:
    """The move to a pose that leads to every waypoint, in a wait the one before it; None for others."""
    out, entrance = list[PoseMove | None](), problem.program.entrance if problem.steady else None
    for point in problem.waypoints:
        motion = problem.program.motions[point.motion] if point.motion >= 0 else entrance
        out.append(motion if isinstance(motion, PoseMove) else out[-1] if isinstance(motion, Wait) else None)
    return out


def keeps_axis(taught: Leg, other: Leg, free: FreeTurn) -> bool:
    """Whether the tool's axis points on a turned way as on the taught one, and the tool turns by less than half a turn
    on it."""
    if taught.segment is None or other.segment is None:
        return True
    s = np.linspace(0.0, 1.0, 9)
    axes = [segment.pose(s)[:, :3, :3] @ free.axis for segment in (taught.segment, other.segment)]
    return bool(np.abs(axes[0] - axes[1]).max() <= _OFF_AXIS and other.angle <= max(MOST, taught.angle))
