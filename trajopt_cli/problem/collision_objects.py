"""What stands in the cell and what the flange carries during each motion of a program."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import PurePath
from typing import NamedTuple

import numpy as np

from trajopt_cli.errors import ErrorKind, InputError
from trajopt_cli.geometry import Array, inverse_pose
from trajopt_cli.motion import Happens, Motion, Move, MoveAbsJ, MoveExtJ, Program, SignalEvent, Tool, UnitMove, Wait
from trajopt_cli.problem.plant import Plant
from trajopt_cli.shapes import TOOL, Capsule, Cue, Grip, Solid, moved

_Angles = dict[tuple[str, int], float]  # of axes of units, rad

RESTS = 1e-3
"""m: a part nearer than this to another body, or nearer than the clearance wanted, stands on it."""


@dataclass(frozen=True, eq=False)
class Turned:
    """A solid that positioners turn during a motion: in the world, as it stands at the start of that, and the numbers
    of the motion's units that turn it, from the floor on."""

    solid: Solid
    units: tuple[int, ...]


@dataclass(frozen=True, eq=False)
class Bodies:
    """carried: in the flange frame. standing: in the world. turned: by units during the motion. All meshes loaded.

    A solid's ignore names the links, and of a standing one also the carried bodies, that may touch it. Which links are
    held against a carried body: plant.self_pairs, by its name.
    """

    carried: tuple[Solid, ...]
    standing: tuple[Solid, ...]
    turned: tuple[Turned, ...] = ()
    units: tuple[UnitMove, ...] = ()


def bodies_on(plant: Plant, program: Program, index: int) -> Bodies:
    """The bodies during motion `index` of the program; -1: at the start, before the first one.

    A part is taken and released at the end of a move, or with a wait or an output. On the move that lifts it and the
    one that sets it down it may touch what it stands on; the gripper may touch it on the move to where it is taken and
    the one from where it is released. A part that is released on what a positioner carries turns with it from then on.
    Equal answers for one plant and program are the same object, equal shapes too.
    Raises InputError where a part is taken or released at a pose that the program leaves to the axes.
    """
    return _all(plant, program)[index + 1]


def never(plant: Plant, program: Program) -> tuple[tuple[int, Cue], ...]:
    """The cues that nothing in the program meets, with the index of their grip."""
    cues = [(i, cue) for i, grip in enumerate(plant.grips) for cue in (grip.at, grip.detach) if cue is not None]
    return tuple(
        (i, cue)
        for i, cue in cues
        if not any(fires(cue, motion) for motion in (*(program.before or ()), *program.motions))
    )


def fires(cue: Cue, motion: Motion) -> bool:
    """Whether a motion is what a cue names. A point that a plan adds stands on its move's line, and is none."""
    if isinstance(motion, Move) and motion.detour:
        return False
    if cue.signal is not None:
        return (cue.signal, cue.value) in _outputs(motion)
    name = PurePath((cue.file or "").lower()).parts
    return (
        cue.line == motion.source.line and PurePath(motion.source.file.lower()).parts[::-1][: len(name)] == name[::-1]
    )


def tools_of(program: Program) -> list[Tool | None]:
    """The tool in force on each motion: a move's own, else that of the move before (after, before the first)."""
    own = [None if isinstance(one, Wait | SignalEvent | MoveExtJ) else one.tool for one in program.motions]
    now = next((tool for tool in own if tool is not None), None)
    out = []
    for tool in own:
        now = now if tool is None else tool
        out.append(now)
    return out


def tool_capsule(tool: Tool | None, radius: float) -> tuple[Solid, ...]:
    """The capsule of this radius [m] from the flange to the TCP, its tip at the TCP; none where the TCP is no farther
    than the radius, or where the tool stands in the world."""
    if tool is None or tool.stationary or radius <= 0:
        return ()
    p_FT: Array = tool.X_FT[:3, 3]
    length = float(np.linalg.norm(p_FT))
    if length <= radius:
        return ()
    return (Solid(Capsule(TOOL, np.zeros(3), p_FT * (1 - radius / length), radius)),)


@dataclass(frozen=True)
class _Change:
    """A part is taken or released; touching: what it stands on there."""

    part: str
    taken: bool
    touching: frozenset[str]


class _State(NamedTuple):
    """During a motion, of a leg or of the rest behind it: what is held, what stands, where positioners stand at first
    and what turns then."""

    leg: int
    rests: bool
    held: tuple[Solid, ...]
    standing: tuple[Solid, ...]
    at: _Angles
    units: tuple[UnitMove, ...] = ()

    def rest(self, parts: _Parts) -> _State:
        """Of a wait or an output: behind what happens with it."""
        return self._replace(rests=True, held=parts.held, standing=parts.standing)


@lru_cache(maxsize=8)
def _all(plant: Plant, program: Program) -> tuple[Bodies, ...]:
    parts, leg = _Parts(plant), 0
    X_WF: Array | None = plant.robot.forward(plant.at_home.start)
    for motion in program.before or ():
        X_WF = _ends(plant, motion, X_WF)
        parts.after(motion, X_WF)
    states = [_State(leg, False, parts.held, parts.standing, dict(parts.at))]
    changes: dict[int, list[_Change]] = {}  # at the end of each leg: a move with all that follows up to the next move
    for motion in program.motions:
        leg += isinstance(motion, Move)
        before = _State(leg, False, parts.held, parts.standing, dict(parts.at), getattr(motion, "units", ()))
        X_WF = _ends(plant, motion, X_WF)
        changes.setdefault(leg, []).extend(parts.after(motion, X_WF))
        states.append(before if isinstance(motion, Move) else before.rest(parts))
    known, tools = _Known(plant), tools_of(program)

    def allowed(leg: int, rests: bool) -> dict[str, frozenset[str]]:
        """At a stop, where parts change hands, what is allowed on the move to it and on the one away from it."""
        here = _may(plant, changes.get(leg - 1, []), changes.get(leg, []))
        then = _may(plant, changes.get(leg, []), changes.get(leg + 1, [])) if rests else {}
        return {name: here.get(name, frozenset()) | then.get(name, frozenset()) for name in (*here, *then)}

    may = {(leg, rests): allowed(leg, rests) for leg, rests in {(state.leg, state.rests) for state in states}}
    given = zip((*tools[:1], *tools) if tools else (None,), states, strict=True)
    return tuple(known.bodies(tool, state, may[state.leg, state.rests]) for tool, state in given)


def _may(plant: Plant, left: Sequence[_Change], reached: Sequence[_Change]) -> dict[str, frozenset[str]]:
    """The carried bodies that may touch a standing one, by its name, between two stops with their changes."""
    gripper = {*(solid.name for solid in plant.attached), TOOL}
    out: dict[str, set[str]] = {}
    for change, arriving in (*((one, False) for one in left), *((one, True) for one in reached)):
        if change.taken == arriving:  # the gripper comes to it, or goes from it
            out.setdefault(change.part, set()).update(gripper)
        else:
            for other in change.touching:
                out.setdefault(other, set()).add(change.part)
    return {name: frozenset(bodies) for name, bodies in out.items()}


class _Known:
    """Each answer once."""

    def __init__(self, plant: Plant):
        self._plant = plant
        self._tools: dict[bytes, tuple[Solid, ...]] = {}
        self._allowed: dict[tuple[Solid, frozenset[str]], Solid] = {}
        self._placed: dict[tuple[Solid, bytes], Solid] = {}
        self._bodies: dict[tuple[object, ...], Bodies] = {}

    def bodies(self, tool: Tool | None, state: _State, may: dict[str, frozenset[str]]) -> Bodies:
        """may: the carried bodies that may touch a standing one, by its name."""
        key = b"" if tool is None or tool.stationary else np.asarray(tool.X_FT[:3, 3]).tobytes()
        if key not in self._tools:
            self._tools[key] = tool_capsule(tool, self._plant.tool_radius)
        carried = (*self._plant.attached, *self._tools[key], *state.held)
        around = [self._allow(self._stands(one, state.at), may.get(one.name, frozenset())) for one in state.standing]
        under = [self._under(solid, state.units) for solid in around]
        still = tuple(solid for solid, units in zip(around, under, strict=True) if not units)
        turned = tuple((solid, units) for solid, units in zip(around, under, strict=True) if units)
        all_of = carried, still, turned, state.units if turned else ()
        if all_of not in self._bodies:
            self._bodies[all_of] = Bodies(carried, still, tuple(Turned(*one) for one in turned), all_of[-1])
        return self._bodies[all_of]

    def _stands(self, solid: Solid, at: _Angles) -> Solid:
        """Where it is with positioners at these angles."""
        if solid.rides is None:
            return solid
        X = self._plant.stands(solid, at)
        key = solid, X.tobytes()
        if key not in self._placed:
            self._placed[key] = replace(solid, shape=moved(solid.loaded, X))
        return self._placed[key]

    def _under(self, solid: Solid, units: tuple[UnitMove, ...]) -> tuple[int, ...]:
        if solid.rides is None:
            return ()
        axes = {axis.eax for axis in self._plant.units[solid.rides.unit][: solid.rides.axes]}
        return tuple(i for i, unit in enumerate(units) if unit.unit == solid.rides.unit and unit.eax in axes)

    def _allow(self, solid: Solid, may: frozenset[str]) -> Solid:
        if may <= solid.ignore:
            return solid
        return self._allowed.setdefault((solid, may), replace(solid, ignore=solid.ignore | may))


class _Parts:
    """The parts that are taken on the way: held in the flange frame, standing (with all other obstacles) in the world.
    One that a grip takes again stands where it took the first; the one before is gone then. at: where positioners
    stand; what rides on one stands here as with all axes at start."""

    def __init__(self, plant: Plant):
        self._plant = plant
        self.held: tuple[Solid, ...] = ()
        self.standing: tuple[Solid, ...] = plant.obstacles
        self.at: _Angles = {}
        self._first: dict[Grip, Solid] = {}

    def after(self, motion: Motion, X_WF: Array | None) -> list[_Change]:
        """What changes at the end of a motion, the flange at X_WF."""
        out = []
        for unit in getattr(motion, "units", ()):
            self.at[unit.unit, unit.eax] = unit.end
        for grip in self._plant.grips:
            held = next((solid for solid in self.held if solid.name == grip.part), None)
            if held is not None and grip.detach is not None and fires(grip.detach, motion):
                here = replace(held, shape=moved(held.loaded, _known(X_WF, motion, grip)), rides=None)
                under = self._rests_on(here)
                rides = next((one.rides for one in self.standing if one.name in under and one.rides), None)
                here = replace(here, rides=rides)
                back = inverse_pose(self._plant.stands(here, self.at))
                self.held = tuple(solid for solid in self.held if solid is not held)
                self.standing = (*self.standing, replace(here, shape=moved(here.loaded, back)))
                out.append(_Change(grip.part, False, under))
            elif held is None and fires(grip.at, motion):
                stands = next(solid for solid in self.standing if solid.name == grip.part)
                here = self._first.setdefault(grip, stands)
                self.standing = tuple(solid for solid in self.standing if solid is not stands)
                out.append(_Change(grip.part, True, self._rests_on(self._now(here))))
                shape = moved(self._now(here).loaded, inverse_pose(_known(X_WF, motion, grip)))
                self.held = (*self.held, replace(here, shape=shape))
        return out

    def _now(self, solid: Solid) -> Solid:
        """Where it stands in the world."""
        return (
            solid
            if solid.rides is None
            else replace(solid, shape=moved(solid.loaded, self._plant.stands(solid, self.at)))
        )

    def _rests_on(self, part: Solid) -> frozenset[str]:
        from trajopt_cli.proximity.near import WORLD, NearPairs

        others = [self._now(solid) for solid in self.standing if solid.name != part.name]
        pairs = NearPairs([(part.loaded, 0, one.loaded, WORLD) for one in others])
        numbers = np.arange(len(others))
        distance = pairs.nearest(np.eye(4)[None, None], 0 * numbers, numbers).distance
        near = max(RESTS, self._plant.clearance)
        return frozenset(one.name for one, apart in zip(others, distance, strict=True) if apart <= near)


def _known(X_WF: Array | None, motion: Motion, grip: Grip) -> Array:
    if X_WF is not None:
        return X_WF
    file, line, column = motion.source
    raise InputError(
        f"part '{grip.part}' is taken or released where the rail is free, so nobody knows where: "
        "do it after a robtarget, or give the jointtarget its external axis",
        file=file, line=line, column=column, kind=ErrorKind.UNPLANNABLE,
    )  # fmt: skip


def _ends(plant: Plant, motion: Motion, X_WF: Array | None) -> Array | None:
    """The flange where a motion ends; None where the plan decides it. X_WF: where it starts."""
    if not isinstance(motion, Move):
        return X_WF
    if isinstance(motion, MoveExtJ):
        return None if plant.asks_rail(motion.extax) else X_WF
    if isinstance(motion, MoveAbsJ):
        rail = plant.rail_after(motion.extax, np.full(len(plant.rail_eaxes), np.nan))
        return None if np.isnan(rail).any() else plant.robot.forward(np.r_[rail, motion.q])
    return np.asarray(motion.X_WT @ inverse_pose(motion.tool.X_FT))


def _outputs(motion: Motion) -> list[tuple[str, float | None]]:
    if isinstance(motion, SignalEvent):
        return [(motion.signal.lower(), motion.value)]
    if isinstance(motion, Wait):
        return []
    return [(event.name.lower(), event.value) for event in motion.events if event.kind is Happens.SIGNAL]
