"""What a cell's owner can change: each limit, speed, wait and place of a program on its cell, by a step.

A lever makes the changed program and plant; nothing is solved here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, fields, replace
from enum import StrEnum
from functools import partial

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.motion import (
    Motion,
    Move,
    MoveAbsJ,
    MoveC,
    MoveExtJ,
    MoveJ,
    PoseMove,
    Program,
    Source,
    Speed,
    Wait,
    instruction_name,
)
from trajopt_cli.problem.plant import Plant
from trajopt_cli.units import slides

SHARE = 0.1
"""By how much a limit is changed."""
STEP = 0.01
"""m by which a place is moved."""
EACH = 12
"""Waits, lines of the program and stations that are asked for one by one; more are asked for together."""
_PERCENT, _LESS = f"+{SHARE * 100:g} %", f"−{SHARE * 100:g} %"
_LONGEST = 24  # letters of a target in a name
_SAME_PLACE = 1e-6  # m between poses that are one
_AXES = ("x", "y", "z")
_POWERS = str.maketrans("23", "²³")


class LeverKind(StrEnum):
    """What kind of number is changed."""

    SPEED = "axis speed"
    ACCELERATION = "axis acceleration"
    STROKE = "rail stroke"
    TOOL = "tool cap"
    WAIT = "wait"
    PROGRAMMED = "programmed speed"
    TIME = "programmed time"
    PLACE = "place"


@dataclass(frozen=True, eq=False)
class Lever:
    """name: for people, the same in every run. now, then: the value without and with the step, in unit; of a place how
    far it is moved. step: "+10 %", "10 mm". loosens: every motion that is legal now is legal then. change: the program
    and its plant with a share of the step made. place: of a place, the name that its six directions share."""

    kind: LeverKind
    name: str
    unit: str
    now: float
    then: float
    step: str
    loosens: bool
    change: Callable[[float], tuple[Program, Plant]]
    place: str = ""


def levers(program: Program, plant: Plant) -> tuple[Lever, ...]:
    """All that can be asked of a program on its plant, in a fixed order."""
    return (
        *_axis_levers(program, plant),
        *_tool_levers(program, plant),
        *_wait_levers(program, plant),
        *_speed_levers(program, plant),
        *_place_levers(program, plant),
    )


def not_asked(program: Program, plant: Plant) -> tuple[str, ...]:
    """What is no lever here and why, one line each."""
    out = ["ranges of the arm's joints: built into the robot", "jerk limits: the cell file gives none"]
    if not plant.robot.has_rail:
        out.append("rail: there is none")
    elif plant.rail_fixed:
        out.append("rail stroke: the cell file fixes the rail where the program has it (rail.fixed)")
    moves = [motion for motion in program.motions if isinstance(motion, Move)]
    out.append("a cap of the cell on turning the tool: there is none but the programmed speeds' own")
    if plant.free_speed:
        out.append("programmed speeds of joint moves: the cell file lifts them (free_speed)")
    if any(not move.zone.stop for move in moves):
        out.append("zones: a larger one is another path, not another limit")
    if any(move.settings.acceleration < 1 for move in moves):
        out.append("AccSet: a share of the accelerations, which are asked for themselves")
    given = (
        one
        for m in moves
        for s in [m.settings]
        for one in (s.path_acceleration, s.path_deceleration, s.world_acceleration)
    )
    if any(one is not None for one in given):
        out.append("PathAccLim and WorldAccLim: kept as the program sets them")
    if any(isinstance(one, Wait) and one.condition is not None and one.duration == 0 for one in program.motions):
        out.append("waits for signals that count no time here (waits in the cell file gives them one)")
    if any(isinstance(move, MoveAbsJ | MoveExtJ) for move in moves):
        out.append("places given by joints (MoveAbsJ, MoveExtJ) and the start")
    if (more := len(places(program)) - EACH) > 0:
        out.append(f"{more} of {more + EACH} places: only the first {EACH} are")
    if any(isinstance(move, PoseMove) and move.tool.stationary for move in moves):
        out.append("places of work that the robot holds to a tool that stands in the cell")
    if plant.obstacles:
        out.append(
            "obstacles and clearance: what the nonlinear program solves again keeps clear of them; a path with one "
            "progress for all axes is timed again, rail and places shifted, without a look at them; --search plans "
            "clear of them"
        )
    return tuple(out)


# -------------------------------------------------------------------------------------------------------- the machine


def _raised(program: Program, plant: Plant, column: str, i: int, step: float, share: float) -> tuple[Program, Plant]:
    """A limit of one axis by share * step more."""
    values = getattr(plant.limits, column).copy()
    values[i] += share * step
    return program, replace(plant, limits=plant.limits.changed(column, values))


def _axis_levers(program: Program, plant: Plant) -> Iterator[Lever]:
    """Speeds and accelerations of all axes, and both ends of the rail."""
    limits = plant.limits

    def lever(kind: LeverKind, what: str, column: str, i: int, step: float, unit: str, text: str) -> Lever:
        now = float(getattr(limits, column)[i])
        change = partial(_raised, program, plant, column, i, step)
        return Lever(kind, f"{limits.names[i]} {what}", unit, now, now + step, text, True, change)

    for i, name in enumerate(limits.names):
        length = "m" if slides(name) else "rad"
        for kind, what, column, per in (
            (LeverKind.SPEED, "speed", "velocity", "s"),
            (LeverKind.ACCELERATION, "acceleration", "acceleration", "s²"),
        ):
            step = SHARE * float(getattr(limits, column)[i])
            yield lever(kind, what, column, i, step, f"{length}/{per}", _PERCENT)
    for i in range(0 if plant.rail_fixed else plant.layout.r):
        longer = SHARE * float(limits.upper[i] - limits.lower[i])
        by = f"{longer * 1e3:.4g} mm"
        yield lever(LeverKind.STROKE, "stroke, lower end", "lower", i, -longer, "m", by)
        yield lever(LeverKind.STROKE, "stroke, upper end", "upper", i, longer, "m", by)


def _capped(program: Program, plant: Plant, name: str, share: float) -> tuple[Program, Plant]:
    more = getattr(plant.tcp, name) * (1 + SHARE * share)
    return program, replace(plant, tcp=replace(plant.tcp, **{name: more}))


def _tool_levers(program: Program, plant: Plant) -> Iterator[Lever]:
    for cap in fields(plant.tcp):
        name, now, unit = cap.name, getattr(plant.tcp, cap.name), cap.metadata["unit"].translate(_POWERS)
        if np.isfinite(now):
            change = partial(_capped, program, plant, name)
            now_and_then = now, now * (1 + SHARE)
            yield Lever(LeverKind.TOOL, f"TCP {name} cap of the cell", unit, *now_and_then, _PERCENT, True, change)


# -------------------------------------------------------------------------------------------------------- the program


def _edited(
    program: Program, plant: Plant, at: frozenset[int], edit: Callable[[Motion, float], Motion], share: float
) -> tuple[Program, Plant]:
    """The program with some motions edited; the others are the very same."""
    motions = tuple(edit(motion, share) if i in at else motion for i, motion in enumerate(program.motions))
    return replace(program, motions=motions), plant


def _by_line(program: Program, of: Callable[[Motion], bool]) -> dict[Source, list[int]]:
    """Indices of the motions of a kind, by the line that makes them."""
    out: dict[Source, list[int]] = {}
    for i, motion in enumerate(program.motions):
        if of(motion):
            out.setdefault(motion.source, []).append(i)
    return out


def _place_of(source: Source) -> str:
    """file:line without folders."""
    return f"{str(source.file).rsplit('/', 1)[-1]}:{source.line}"


def _shorter(motion: Motion, share: float) -> Motion:
    assert isinstance(motion, Wait | Move)
    assert motion.duration is not None
    return replace(motion, duration=motion.duration * (1 - SHARE * share))


def _faster(motion: Motion, share: float) -> Motion:
    assert isinstance(motion, Move)
    by, v = 1 + SHARE * share, motion.speed
    return replace(motion, speed=Speed(v.name, v.v_tcp * by, v.v_ori * by, v.v_leax * by, v.v_reax * by))


def _short(target: str) -> str:
    """A target's text, of a computed one the beginning."""
    return target if len(target) <= _LONGEST else f"{target[: _LONGEST - 1]}…"


def _called(motion: Motion) -> str:
    assert isinstance(motion, Move)
    return f"{instruction_name(motion)} {_short(motion.target)}"


def _times(indices: Sequence[int]) -> str:
    return f", {len(indices)} passes" if len(indices) > 1 else ""


def _wait_levers(program: Program, plant: Plant) -> Iterator[Lever]:
    """Waits of a known length, each line or all together."""
    lines = _by_line(program, lambda one: isinstance(one, Wait) and one.duration > 0 and not one.settles)
    groups = [(f"wait at {_place_of(source)}{_times(at)}", at) for source, at in lines.items()]
    if len(groups) > EACH:
        groups = [(f"all {len(lines)} waits", [i for at in lines.values() for i in at])]
    for name, at in groups:
        now = sum(getattr(program.motions[i], "duration", 0.0) for i in at)
        change = partial(_edited, program, plant, frozenset(at), _shorter)
        yield Lever(LeverKind.WAIT, name, "s", now, now * (1 - SHARE), _LESS, False, change)


def _speed_levers(program: Program, plant: Plant) -> Iterator[Lever]:
    """Programmed speeds, by line or, where they are many, by speeddata; and programmed times."""

    def capped(one: Motion) -> bool:
        free = plant.free_speed and isinstance(one, MoveJ | MoveAbsJ)
        return isinstance(one, Move) and one.duration is None and not free

    lines, named = _by_line(program, capped), dict[str, list[int]]()
    for source, at in lines.items():
        for i in at:
            name = _move(program, i).speed.name
            if len(lines) > EACH:
                name = f"{name} everywhere"
            else:
                name = f"{name} of {_called(program.motions[i])} at {_place_of(source)}{_times(at)}"
            named.setdefault(name, []).append(i)
    for name, at in named.items():
        move = _move(program, at[0])
        now = move.speed.v_leax if isinstance(move, MoveExtJ) else move.speed.v_tcp
        change = partial(_edited, program, plant, frozenset(at), _faster)
        yield Lever(LeverKind.PROGRAMMED, name, "m/s", now, now * (1 + SHARE), _PERCENT, True, change)
    for source, at in _by_line(program, lambda one: isinstance(one, Move) and one.duration is not None).items():
        move = _move(program, at[0])
        name = f"\\T of {_called(move)} at {_place_of(source)}{_times(at)}"
        now = move.duration or 0.0
        change = partial(_edited, program, plant, frozenset(at), _shorter)
        yield Lever(LeverKind.TIME, name, "s", now, now * (1 - SHARE), _LESS, False, change)


def _move(program: Program, index: int) -> Move:
    move = program.motions[index]
    assert isinstance(move, Move)
    return move


def _moved(axis: int, way: float, motion: Motion, share: float) -> Motion:
    """A motion's target, and the point an arc goes through, moved along an axis of the world."""
    assert isinstance(motion, PoseMove)

    def shifted(X: Array) -> Array:
        out = X.copy()
        out[axis, 3] += way * share
        return out

    if isinstance(motion, MoveC):
        return replace(motion, X_WT=shifted(motion.X_WT), X_WV=shifted(motion.X_WV))
    return replace(motion, X_WT=shifted(motion.X_WT))


def _place_levers(program: Program, plant: Plant) -> Iterator[Lever]:
    """Each place, the first ones where they are many, by a step both ways along the axes of the world."""
    for name, at in list(places(program).items())[:EACH]:
        for axis, sign in ((axis, sign) for axis in range(3) for sign in (1, -1)):
            change = partial(_edited, program, plant, frozenset(at), partial(_moved, axis, sign * STEP))
            way = f"{'+' if sign > 0 else '−'}{_AXES[axis]}"
            step = f"{STEP * 1e3:g} mm"
            yield Lever(
                LeverKind.PLACE, f"{name} towards {way}", "m", 0.0, STEP, step, False, change, f"{name} {_AXES[axis]}"
            )


def places(program: Program) -> dict[str, list[int]]:
    """The motions of each place, by its name: a work object, or points joined by lines, arcs and waits.

    Stations that share a point are one place, and so are those of one work object; the point that a lone joint move
    goes to is one, too.
    """
    groups: list[list[int]] = []
    joined = False
    for i, motion in enumerate(program.motions):
        if isinstance(motion, PoseMove):
            if isinstance(motion, MoveJ) or not joined:
                groups.append([])
            groups[-1].append(i)
            joined = True
        elif isinstance(motion, Move):
            joined = False
    merged: dict[object, list[int]] = {}
    known: dict[object, object] = {}
    for group in groups:
        marks: list[object] = []
        for i in group:
            move = program.motions[i]
            assert isinstance(move, PoseMove)
            if move.tool.stationary:
                break
            own = move.wobj.lower() != "wobj0"
            marks += [move.wobj.lower()] if own else [tuple(np.round(move.X_WT[:3, 3] / _SAME_PLACE).astype(int))]
        else:
            names = {known.get(mark) for mark in marks} - {None}
            first = min(names, key=list(merged).index, default=marks[0])
            for other in names - {first}:
                merged[first] = merged[first] + merged.pop(other)
                known = {mark: first if name == other else name for mark, name in known.items()}
            merged.setdefault(first, []).extend(group)
            known |= dict.fromkeys(marks, first)
    out: dict[str, list[int]] = {}
    for at in merged.values():
        name, count = _name(program, at), 2
        while name in out:  # the same text in another pass, of another point
            name, count = f"{_name(program, at)} ({count})", count + 1
        out[name] = sorted(at)
    return out


def _name(program: Program, at: Sequence[int]) -> str:
    """What a place is called: its work object where that is one, else the target with the shortest text."""
    moves = [move for i in at if isinstance(move := program.motions[i], PoseMove)]
    objects = {move.wobj for move in moves}
    if len(objects) == 1 and (name := objects.pop()).lower() != "wobj0":
        return f"work object {name}"
    targets = sorted({move.target for move in moves}, key=lambda text: (len(text), text))
    more = f" and {len(targets) - 1} more" if len(targets) > 1 else ""
    return f"place of {_short(targets[0])}{more}"
