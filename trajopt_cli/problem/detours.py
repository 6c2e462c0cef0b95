"""Ways around obstacles: points that a plan adds before a joint move of the program, and the program with them.

An additional point is a joint move of its own, on the same line of the text as the motion it belongs to, with its tool,
work object, speed and settings. It says all axes: a MoveJ the pose, the confdata and the rail, so it must stand clear
of singularities; before a MoveAbsJ it is one, too. Plans, tables and pictures speak of the program's own motions; the
planner, the judge of a RAPID plan and the export work on the program with the points. Numbering tells one from the
other.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.motion import ExternalAxes, Motion, MoveAbsJ, MoveJ, Program, Written, Zone
from trajopt_cli.problem.editable import Changes, why_straight
from trajopt_cli.problem.plan import Detour as Detour
from trajopt_cli.problem.plan import Passing, Plan, PlannedMotion, Target
from trajopt_cli.problem.plan import Via as Via
from trajopt_cli.units import DEG, MM

if TYPE_CHECKING:
    from trajopt_cli.problem.plant import Plant

LEAST_STRETCH = 0.01  # of the arm's Jacobian: below, a printed pose leaves joints open by more than 1e-4 rad
_NAME, _JOINTS_NAME, _STEP = "pVia_", "jVia_", 10
_NAMED = re.compile(rf"\b(?:{_NAME}|{_JOINTS_NAME})(\d+)\b", re.IGNORECASE)
JointMove = MoveJ | MoveAbsJ


class Numbering:
    """Indices of motions in a program and in the one with the points; count: how many the program itself has."""

    def __init__(self, count: int, detours: Collection[Detour]):
        points = {detour.motion: len(detour.points) for detour in detours}
        self._own = [i for i in range(count) for _ in range(points.get(i, 0) + 1)]
        self._at = {i: k for k, i in enumerate(self._own)}  # the last of its parts

    @property
    def with_points(self) -> int:
        """How many motions there are with the points."""
        return len(self._own)

    def own(self, index: int) -> int:
        """The program's own motion to which one of the program with the points belongs."""
        return self._own[index]

    def at(self, own: int) -> int:
        """Where one of the program's own motions is in the program with the points."""
        return self._at[own]

    def is_point(self, index: int) -> bool:
        """Whether a motion of the program with the points is an additional one."""
        return self._at[self._own[index]] != index

    def changes(self, changes: Changes) -> Changes:
        """What a plan may change of the program with the points: these stay as they are, and so do the motions behind
        them, which would else be left out alone."""
        behind = {self.own(k) for k in range(self.with_points) if self.is_point(k)}
        return replace(
            changes,
            values=frozenset(self.at(i) for i in changes.values),
            ties=tuple(tuple(self.at(i) for i in group) for group in changes.ties),
            droppable=frozenset(self.at(i) for i in changes.droppable - behind),
            detours=tuple(tuple(self.at(i) for i in group) for group in changes.detours),
            straight={self.at(i): why for i, why in changes.straight.items()},
        )


def with_detours(program: Program, plant: Plant, detours: Collection[Detour]) -> Program:
    """The program with the additional motions before those that go around; the same one where there are none.

    Raises ValueError for a motion that can have none (why_straight), two detours of one motion, a point with the wrong
    number of axes, one that a target cannot say (why_unsaid), and a radius that no zone of the controller has.
    """
    if not detours:
        return program
    by_motion = {detour.motion: detour for detour in detours}
    if len(by_motion) < len(detours):
        raise ValueError("two detours of one motion")
    names, motions = _Names(program), list[Motion]()
    for index, motion in enumerate(program.motions):
        if (detour := by_motion.pop(index, None)) is not None:
            if (why := why_straight(motion)) is not None:
                raise ValueError(f"motion {index} can have no additional points: {why}")
            assert isinstance(motion, JointMove)
            motions += [_point(plant, motion, via, detour, names) for via in detour.points]
        motions.append(motion)
    if by_motion:
        raise ValueError(f"detours of motions {sorted(by_motion)}, and the program has {len(program.motions)}")
    return replace(program, motions=tuple(motions))


def held_against(
    program: Program, plant: Plant, target: Target, detours: Collection[Detour], dropped: Collection[int]
) -> tuple[Program, tuple[int, ...]]:
    """The program that a plan's rows are held against, and which of its motions are left out.

    A RAPID controller drives to every additional point; a stream may go any way between the program's own.
    """
    if target is Target.STREAM or not detours:
        return program, tuple(dropped)
    numbering = Numbering(len(program.motions), detours)
    return with_detours(program, plant, detours), tuple(numbering.at(i) for i in dropped)


def point_names(program: Program, plant: Plant, detours: Sequence[Detour]) -> list[tuple[str, ...]]:
    """What the points of each detour are called in the program with them."""
    numbering, there = Numbering(len(program.motions), detours), with_detours(program, plant, detours)
    out = []
    for detour in detours:
        end = numbering.at(detour.motion)
        points = there.motions[end - len(detour.points) : end]
        out.append(tuple(point.target for point in points if isinstance(point, JointMove)))
    return out


def way_told(points: int, around: Sequence[str]) -> str:
    """A detour in a table, behind the motion's name: "by 2 points around 'column'"."""
    return f"by {points} point{'s' if points > 1 else ''} around {quoted(around)}"


def quoted(around: Sequence[str]) -> str:
    """Names of bodies as they are told: "'column', 'fence'"."""
    return ", ".join(f"'{name}'" for name in around)


def folded(plan: Plan, program: Program, detours: Sequence[Detour]) -> Plan:
    """A plan of the program with the points as one of the program itself, whose motions have the points on their ways.

    A motion's binding limit is that of its part that takes longest.
    """
    if not detours:
        return plan
    numbering = Numbering(len(program.motions), detours)
    parts: dict[int, list[PlannedMotion]] = {}
    for one in plan.motions:
        parts.setdefault(numbering.own(one.index), []).append(one)
    motions = []
    for own, (*points, last) in parts.items():
        longest = max((*points, last), key=lambda part: part.t_1 - part.t_0)
        first = points[0] if points else last
        via = tuple(Passing(part.t_1, part.q_1, part.binding) for part in points)
        motions.append(replace(last, index=own, t_0=first.t_0, q_0=first.q_0, binding=longest.binding, via=via))
    return replace(plan, motions=tuple(motions), detours=tuple(detours))


def unfolded(plan: Plan) -> Plan:
    """A plan of the program itself as one of the program with its points: a motion for each point."""
    if not plan.detours:
        return plan
    motions: list[PlannedMotion] = []
    for one in plan.motions:
        t, q = one.t_0, one.q_0
        for point in one.via:
            motions.append(PlannedMotion(len(motions), one.source, t, point.t, q, point.q, point.binding))
            t, q = point.t, point.q
        motions.append(replace(one, index=len(motions), t_0=t, q_0=q, via=()))
    return replace(plan, motions=tuple(motions), detours=())


def why_unsaid(plant: Plant, motion: JointMove, q: Array) -> str | None:
    """Why the target of a point before a motion cannot say these axes q (k,); None where it can."""
    if isinstance(motion, MoveAbsJ):
        return None
    J = plant.robot.jacobian(q, motion.tool.X_FT)[:, plant.layout.arm]
    least = float(np.linalg.svd(J, compute_uv=False)[-1])
    if least >= LEAST_STRETCH:
        return None
    return f"the arm is at a singularity there (least singular value {least:.2g}, wanted {LEAST_STRETCH:g})"


@cache
def _zones() -> Mapping[float, Zone]:
    """The controller's own fly-by zones by radius [m], the smallest first."""
    from trajopt_cli.rapid.data.predefined import predefined

    found = {}
    for name, value in predefined().items():
        if value.type.name == "zonedata" and not value.data[0]:
            radius, path_ori, path_eax, ori, leax, reax = value.data[1:]
            found[radius * MM] = Zone(
                name, False, radius * MM, path_ori * MM, path_eax * MM, ori * DEG, leax * MM, reax * DEG
            )
    return dict(sorted(found.items()))


def radii() -> tuple[float, ...]:
    """The radii [m] that the fly-by of an additional point can have: those of z0 to z200."""
    return tuple(_zones())


def zone_of(radius: float | None) -> Zone:
    """The zone of a radius [m], `fine` for None. Raises ValueError for one that no zone of the controller has."""
    if radius is None:
        return Zone("fine", stop=True)
    for known, zone in _zones().items():
        if abs(known - radius) <= 1e-9:
            return zone
    raise ValueError(f"no zone has the radius {radius} m; the radii are {', '.join(f'{r:g}' for r in radii())}")


class _Names:
    """Names for points that no file uses. One text that runs several times has one name for one point."""

    def __init__(self, program: Program):
        taken = [int(n) for file in program.files.values() for n in _NAMED.findall(file.text)]
        self._last = max(taken, default=0) // _STEP
        self._names: dict[tuple[object, ...], str] = {}

    def of(self, motion: JointMove, via: Via) -> str:
        """The name of a point before a motion."""
        key = (motion.written.statement, motion.tool.X_FT.tobytes(), via.q.tobytes())
        if key not in self._names:
            self._last += 1
            beginning = _JOINTS_NAME if isinstance(motion, MoveAbsJ) else _NAME
            self._names[key] = f"{beginning}{self._last * _STEP}"
        return self._names[key]


def _point(plant: Plant, motion: JointMove, via: Via, detour: Detour, names: _Names) -> JointMove:
    from trajopt_cli.robot.inverse import confdata

    if via.q.shape != plant.start.shape:
        raise ValueError(f"a point before motion {detour.motion} has axes {via.q.shape}, wanted {plant.start.shape}")
    if (why := why_unsaid(plant, motion, via.q)) is not None:
        raise ValueError(f"a point before motion {detour.motion} cannot be said: {why}")
    arm = np.asarray(via.q[plant.layout.arm])
    point = replace(
        motion,
        written=Written(motion.written.statement, counters=motion.written.counters),
        target=names.of(motion, via),
        zone=zone_of(via.radius),
        extax=_external(plant, motion, via.q),
        optional=False,
        settings=motion.settings if isinstance(motion, MoveAbsJ) else replace(motion.settings, conf_j=True),
        events=(),
        process=None,
        detour=detour.around,
        marked=detour.around,
    )
    if isinstance(point, MoveAbsJ):
        return replace(point, q=arm)
    X_WT = plant.robot.forward(via.q) @ point.tool.X_FT
    return replace(point, X_WT=X_WT, conf=confdata(plant.robot, arm))


def _external(plant: Plant, motion: JointMove, q: Array) -> ExternalAxes:
    """A motion's external axes with the rail where q (k,) has it."""
    return plant.with_rail(motion.extax, q[plant.layout.rail])
