"""What stands in the cell and what the flange carries while a file's rows go by.

The optimiser has its own answer to this. Here a leg reaches from the row where one point is left to the row where the
next one is left; a part is taken and released at the pose of the point where that happens. Two things touch that must
not be held against each other: a part and what it stands on, on the leg that lifts it and the one that sets it down;
and the gripper and a part, on the leg to where it is taken and the one away from where it is released. What rides on a
positioner is told as it stands with all axes at start, see turntables; a part that is left on such a body rides, too.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import PurePath

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.judge.geometry import inverse_pose
from trajopt_cli.judge.machine import Machine
from trajopt_cli.judge.mechanism import mechanism_of
from trajopt_cli.judge.program_points import end_of_move
from trajopt_cli.judge.timeline import Visit
from trajopt_cli.judge.turntables import Turntables, since_start
from trajopt_cli.motion import Happens, Motion, Move, MoveExtJ, Program, SignalEvent, Tool, Wait
from trajopt_cli.proximity.pair import Pair
from trajopt_cli.shapes import TOOL, Capsule, Cue, Grip, MeshFile, Shape, Solid, moved
from trajopt_cli.trajectory import Trajectory

RESTS = 1e-3  # m: a part that is nearer to another body, or nearer than the clearance wanted, stands on it

_Pairs = Collection[tuple[str, str]]  # a carried body and one that stands


@dataclass(frozen=True, eq=False)
class BodyInterval:
    """Rows first to last with their bodies: carried in the flange frame, standing in the world. A standing one's ignore
    names the carried bodies that may touch it then, too."""

    first: int
    last: int
    carried: tuple[Solid, ...]
    standing: tuple[Solid, ...]


def legs_of(program: Program, plant: Machine, visits: Sequence[Visit], last: int) -> list[BodyInterval]:
    """The legs of a file with rows 0 to last, in order. visits: the start, and the points as they came out."""
    scene, tools = _Scene.of(program, plant), _tools(program)
    out: list[BodyInterval] = []
    first, leaving = 0, set[tuple[str, str]]()
    indices = [visit.point.index for visit in visits[1:]] + [len(program.motions)]
    for visit, end in zip(visits, indices, strict=True):
        own = visit.point.index
        carried, standing = scene.carried(tools[own + 1]), scene.standing()
        arriving, then = set[tuple[str, str]](), set[tuple[str, str]]()
        for motion in program.motions[max(own, 0) : end]:
            for part, taken in scene.happens(motion, np.asarray(visit.X_WF)):
                (then if taken else arriving).update(scene.rests_on(part))
                (arriving if taken else then).update((name, part) for name in scene.grippers)
        out.append(BodyInterval(first, visit.depart, carried, _allow(standing, leaving | arriving)))
        first, leaving = visit.depart, then
    out.append(BodyInterval(first, last, scene.carried(tools[-1]), _allow(scene.standing(), leaving)))
    return out


def tables_of(program: Program, plant: Machine, trajectory: Trajectory) -> Turntables:
    """What positioners turn during a file."""
    return Turntables(program, plant, trajectory, _Scene.of(program, plant).at if plant.units else {})


def standing_still(program: Program, plant: Machine, last: int) -> list[BodyInterval]:
    """One leg of rows 0 to last with the bodies as they are at the start."""
    scene = _Scene.of(program, plant)
    return [BodyInterval(0, last, scene.carried(_tools(program)[0]), scene.standing())]


def shape_of(solid: Solid) -> Shape:
    """A solid's shape. Raises ValueError for a mesh that still lies in its file."""
    if isinstance(solid.shape, MeshFile):
        raise ValueError(f"mesh '{solid.name}' is not loaded; build_plant does it")
    return solid.shape


class _Scene:
    """Where everything is; `happens` changes it."""

    def __init__(self, plant: Machine):
        self._plant = plant
        self.grippers = (*(solid.name for solid in plant.attached), TOOL)
        self._stands: dict[str, Solid] = {solid.name: solid for solid in plant.obstacles}
        self._held: dict[str, Solid] = {}
        self._taken: dict[Grip, Solid] = {}  # where it was taken first: there the next one stands
        self._capsules: dict[bytes, tuple[Solid, ...]] = {}
        self.at: dict[tuple[str, int], float] = {}  # of positioners' axes, rad

    @classmethod
    def of(cls, program: Program, plant: Machine) -> _Scene:
        """When the program begins, or the cycle of its loop: then what ran before has taken and released parts."""
        scene, X_WF = cls(plant), mechanism_of(plant).flange_pose(plant.start)
        for motion in program.before or ():
            if not isinstance(motion, Wait | SignalEvent):
                end = end_of_move(plant, -1, motion, np.eye(4), optional=False).X_WF
                X_WF = X_WF if end is None else end
            for _ in scene.happens(motion, X_WF):
                pass
        return scene

    def carried(self, tool: Tool | None) -> tuple[Solid, ...]:
        """In the flange frame: what is attached, the tool's capsule, and the parts."""
        return (*self._plant.attached, *self._capsule(tool), *self._held.values())

    def standing(self) -> tuple[Solid, ...]:
        """In the world."""
        return tuple(self._stands.values())

    def happens(self, motion: Motion, X_WF: Array) -> Iterator[tuple[str, bool]]:
        """Take and release what a motion that ends with the flange at X_WF asks for: the part, and whether taken."""
        self.at.update({(unit.unit, unit.eax): unit.end for unit in getattr(motion, "units", ())})
        for grip in self._plant.grips:
            name = grip.part
            if name in self._held and grip.detach is not None and _fires(grip.detach, motion):
                held = self._held.pop(name)
                self._stands[name] = replace(held, shape=moved(shape_of(held), X_WF), rides=None)
                under = {other for _, other in self.rests_on(name)}
                rides = next((one.rides for one in self._stands.values() if one.name in under and one.rides), None)
                back = inverse_pose(since_start(self._plant, rides, self.at)) @ X_WF
                self._stands[name] = replace(held, shape=moved(shape_of(held), back), rides=rides)
                yield name, False
            elif name in self._stands and _fires(grip.at, motion):
                solid = self._taken.setdefault(grip, self._stands[name])
                self._stands[name] = solid
                yield name, True
                del self._stands[name]
                self._held[name] = replace(solid, shape=moved(self._now(solid), inverse_pose(X_WF)))

    def rests_on(self, part: str) -> set[tuple[str, str]]:
        """The part, which stands, with all that it stands on."""
        near = max(RESTS, self._plant.clearance)
        shape, here = self._now(self._stands[part]), np.eye(4)
        others = [solid for solid in self._stands.values() if solid.name != part]
        return {(part, one.name) for one in others if Pair(shape, self._now(one)).distance(here, here) <= near}

    def _now(self, solid: Solid) -> Shape:
        """The shape where it stands in the world."""
        return (
            moved(shape_of(solid), since_start(self._plant, solid.rides, self.at)) if solid.rides else shape_of(solid)
        )

    def _capsule(self, tool: Tool | None) -> tuple[Solid, ...]:
        """From the flange to one radius before the TCP."""
        radius = self._plant.tool_radius
        if tool is None or tool.stationary or not radius:
            return ()
        p_FT = np.asarray(tool.X_FT[:3, 3])
        key = p_FT.tobytes()
        if key not in self._capsules:
            reach = float(np.sqrt(p_FT @ p_FT))
            tip = p_FT - p_FT / max(reach, radius) * radius
            self._capsules[key] = () if reach <= radius else (Solid(Capsule(TOOL, np.zeros(3), tip, radius)),)
        return self._capsules[key]


def _allow(standing: Sequence[Solid], pairs: _Pairs) -> tuple[Solid, ...]:
    may = {solid.name: frozenset(body for body, other in pairs if other == solid.name) for solid in standing}
    return tuple(replace(one, ignore=one.ignore | may[one.name]) if may[one.name] else one for one in standing)


def _tools(program: Program) -> list[Tool | None]:
    """The tool in force at the start and on each motion; before the first move it is that move's."""
    given = [None if isinstance(m, Wait | SignalEvent | MoveExtJ) else m.tool for m in program.motions]
    out = [next((tool for tool in given if tool is not None), None)]
    for tool in given:
        out.append(tool or out[-1])
    return out


def _fires(cue: Cue, motion: Motion) -> bool:
    if isinstance(motion, Move) and motion.detour:
        return False  # a point added on the way, written on the line of its move
    if cue.line is not None:
        own, asked = (PurePath(name.lower()).parts for name in (motion.source.file, cue.file or ""))
        return motion.source.line == cue.line and own[len(own) - len(asked) :] == asked
    if isinstance(motion, SignalEvent):
        return motion.signal.lower() == cue.signal and motion.value == cue.value
    if isinstance(motion, Wait):
        return False
    return any(e.kind is Happens.SIGNAL and e.name == cue.signal and e.value == cue.value for e in motion.events)
