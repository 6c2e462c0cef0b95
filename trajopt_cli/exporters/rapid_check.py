"""An exported program, read again, against the plan: the last check before anybody sees it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.rapid_text import refusal
from trajopt_cli.geometry import Array
from trajopt_cli.motion import (
    Motion,
    Move,
    MoveAbsJ,
    MoveC,
    MoveExtJ,
    MoveL,
    PoseMove,
    Program,
    SignalEvent,
    Wait,
    motion_name,
)
from trajopt_cli.problem.editable_text import confdata_counts
from trajopt_cli.problem.nearest import is_nearest
from trajopt_cli.problem.plan import Plan, PlannedMotion
from trajopt_cli.problem.plannable import STILL
from trajopt_cli.problem.plant import Plant, shown_rail
from trajopt_cli.problem.programmed import PlantKinematics
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.robot.inverse import confdata_admits
from trajopt_cli.scenario import Scenario
from trajopt_cli.units import MM

# What is written is rounded to 0.001 mm and 1e-6, and then to the 24 bits of a num. So rapid.csv is what the controller
# makes of the text within what the judge lets pass: 1 um and 1 urad of a target.
_PLACE = 1e-6  # m, of a computed target written out: at most 0.87e-6, half a um along three axes
_TURN = 1e-6  # rad and rotation entries; at most 5e-7 is written
_JOINTS = 2e-7  # rad
_RAIL = 5e-7  # m
_NUM = 2.0**-24  # share of a value by which rounding to a num may change it
_SPEED = 1e-8  # m/s, rad/s


def read_again(program: Program, plant: Plant, scenario: Scenario, texts: Mapping[str, str]) -> Program:
    """The program of edited texts, by path, read as the program was. Raises InputError as reading does."""
    files = [replace(file, text=texts[path]) for path, file in program.files.items()]
    world = scenario.without_lines  # those are of the text as it was
    return run_program(files, world, program.entry, PlantKinematics(plant.at_home))


def mismatches(
    program: Program, plan: Plan, plant: Plant, read_program: Program, faster: frozenset[int] = frozenset()
) -> Iterator[InputError]:
    """Why motions that were read are not as planned; the last one where reading has lost step with the program."""
    read = iter(read_program.motions)
    by_index = {planned.index: planned for planned in plan.motions}
    lines = {program.motions[one.index].written.statement for one in plan.motions if rail_moves(one, plant)}
    before: Move | None = None
    for index, motion in enumerate(program.motions):
        planned = by_index.get(index)
        if planned is not None and planned.dropped:
            continue
        match motion:
            case Wait() if planned is not None and motion.written.statement in lines:
                errors = _check_dwell(motion, before, planned, plant, next(read, None))
                if motion.condition is not None:
                    left = replace(motion, duration=0.0, beside=None)  # the line took its least time
                    errors = [*errors, *_check_same(left, next(read, None))]
            case Wait() | SignalEvent():
                errors = _check_same(motion, next(read, None))
            case _:
                if planned is None:
                    raise ValueError(f"the plan leaves out motion {index} ({motion.source}) without dropping it")
                found = next(read, None)
                errors = _check_move(motion, planned, plant, found, index in faster)
                if type(found) is not type(motion):
                    yield errors[0]
                    return
                before = motion
        yield from errors
    surplus = next(read, None)
    if surplus is not None:
        yield InputError(f"the edited program has one motion too many at {surplus.source}")


def first_difference(program: Program, read: Program) -> int | None:
    """The first motion that another reading of a program gives otherwise; None where all are the same."""
    for index, motion in enumerate(program.motions):
        if index >= len(read.motions) or not same_motion(motion, read.motions[index]):
            return index
    return len(program.motions) if len(read.motions) > len(program.motions) else None


def same_motion(motion: Motion, other: Motion) -> bool:
    """Whether two readings of a motion ask for the same, wherever they are written."""
    if not isinstance(motion, Move):
        return not _check_same(motion, other)
    if not isinstance(other, Move) or type(other) is not type(motion) or not _same_axes(motion, other):
        return False
    if isinstance(motion, PoseMove) and isinstance(other, PoseMove) and motion.conf != other.conf:
        return False
    return not any(_otherwise(motion, other)) and not any(_elsewhere(motion, other))


def rail_moves(planned: PlannedMotion, plant: Plant) -> bool:
    """Whether the rail is elsewhere at the end of a motion, as far as the text tells."""
    return bool(np.any(np.abs((planned.q_1 - planned.q_0)[plant.layout.rail]) > _RAIL))


def _same_rail(one: Array | float, other: Array | float) -> bool:
    """Whether two rail positions [m] are one as far as the text tells, and a num, which on a long rail is um."""
    return bool(np.all(np.abs(one - other) <= _RAIL + 2 * _NUM * np.abs(one)))


def _near(one: Array, other: Array) -> bool:
    """Whether two poses (4, 4) are one as far as the text tells."""
    turned = np.abs(one[:3, :3] - other[:3, :3]).max()
    return bool(np.linalg.norm(one[:3, 3] - other[:3, 3]) <= _PLACE and turned <= _TURN)


def _same_axes(motion: Move, read: Move) -> bool:
    return all(
        one is other or (one is not None and other is not None and _same_rail(one * MM, other * MM))
        for one, other in zip(motion.extax, read.extax, strict=True)
    )


def _elsewhere(motion: Move, read: Move) -> Iterator[str]:
    if isinstance(motion, PoseMove) and isinstance(read, PoseMove) and not _near(motion.X_WT, read.X_WT):
        yield "the tool in the programmed place, and the target is elsewhere"
    if isinstance(motion, MoveC) and isinstance(read, MoveC) and not _near(motion.X_WV, read.X_WV):
        yield "the programmed circle point, and the edited one is elsewhere"
    if isinstance(motion, MoveAbsJ) and isinstance(read, MoveAbsJ) and np.abs(motion.q - read.q).max() > _JOINTS:
        yield "the programmed joints, and the target has others"


def _otherwise(motion: Move, read: Move, fast: bool = False, monitored: bool = False) -> Iterator[str]:
    """What else than its target a move says otherwise. fast, monitored: speed and ConfJ, ConfL were changed."""
    # A stretch written flat spells a speed that only its routine knows in numbers of six decimals.
    before, now = ((speed.v_tcp, speed.v_ori, speed.v_leax, speed.v_reax) for speed in (motion.speed, read.speed))
    if not fast and not np.allclose(before, now, rtol=0.0, atol=_SPEED):
        yield "the programmed speed, and the edited program has another"
    for key, what in (("duration", "duration"), ("identity", "\\ID"), ("zone", "zone")):
        if getattr(motion, key) != getattr(read, key):
            yield f"the programmed {what}, and the edited program has another"
    tools = [one.tool.X_FT for one in (motion, read) if not isinstance(one, MoveExtJ)]
    if len(tools) == 2 and not _near(*tools):
        yield "the programmed tool, and the edited program has another"
    settings = read.settings
    if monitored:
        settings = replace(settings, conf_j=motion.settings.conf_j, conf_l=motion.settings.conf_l)
    if motion.settings != settings:
        yield "the programmed settings, and the edited program has others"
    if (motion.events, motion.process) != (read.events, read.process):
        yield "what the program does on the way, and the edited program does something else"


def _differences(motion: Move, planned: PlannedMotion, plant: Plant, read: Move) -> Iterator[str]:
    if plant.rail_eaxes:
        wanted, given = planned.q_1[plant.layout.rail], plant.rail_value(read.extax)
        stays = given is None and not rail_moves(planned, plant)  # an open axis stays where it is
        if not stays and (given is None or not _same_rail(wanted, given)):
            shown = "open" if given is None else shown_rail(given, ".6f")
            yield f"the rail at {shown_rail(wanted, '.6f')}, and the target says {shown}"
    yield from _led_apart(planned, plant, read)
    yield from _elsewhere(motion, read)
    if isinstance(motion, PoseMove) and isinstance(read, PoseMove):
        if confdata_counts(read):
            if not confdata_admits(plant.robot, read.conf, np.asarray(planned.q_1[plant.layout.arm])):
                conf = read.conf
                yield f"another configuration than the target's [{conf.cf1},{conf.cf4},{conf.cf6},{conf.cfx}]"
        elif read is not motion and not is_nearest(plant, planned, motion):
            yield "a configuration that is not the nearest, which the controller takes with confdata switched off"


def _led_apart(planned: PlannedMotion, plant: Plant, read: Move) -> Iterator[str]:
    """Axes that a target has elsewhere than where the plan's rails take them."""
    there = plant.with_rail(read.extax, planned.q_1[plant.layout.rail])
    for one in plant.followers:
        value, wanted = read.extax[one.eax], there[one.eax] or 0.0
        if value is not None and abs(value - wanted) > STILL:
            yield f"eax_{'abcdef'[one.eax]} at {wanted:.6f} mm, and the target says {value:.6f}"


def _check_move(
    motion: Move, planned: PlannedMotion, plant: Plant, read: Motion | None, fast: bool
) -> list[InputError]:
    if not isinstance(read, Move) or type(read) is not type(motion):
        return [_mismatch(motion, f"{motion_name(motion)} there")]
    monitored = isinstance(motion, PoseMove) and not confdata_counts(motion)
    said = [*_differences(motion, planned, plant, read), *_otherwise(motion, read, fast, monitored)]
    return [_mismatch(motion, difference) for difference in said]


def _check_dwell(
    wait: Wait, before: Move | None, planned: PlannedMotion, plant: Plant, read: Motion | None
) -> list[InputError]:
    if not isinstance(read, MoveL) or before is None:
        return [_mismatch(wait, "a MoveL there that takes the rail along")]
    wanted, given = planned.q_1[plant.layout.rail], plant.rail_value(read.extax)
    there = given is not None and _same_rail(wanted, given) and not any(_led_apart(planned, plant, read))
    arm = np.asarray(planned.q_1[plant.layout.arm])
    if not there or (confdata_counts(read) and not confdata_admits(plant.robot, read.conf, arm)):
        return [_mismatch(wait, difference) for difference in _differences(read, planned, plant, read)]
    X_WT = before.X_WT if isinstance(before, PoseMove) else plant.robot.forward(planned.q_1) @ read.tool.X_FT
    if not _near(X_WT, read.X_WT) or read.duration is None or abs(read.duration - wait.duration) > 1e-6:
        return [_mismatch(wait, "the tool to rest for the time of the wait")]
    return []


def _check_same(motion: Wait | SignalEvent, read: Motion | None) -> list[InputError]:
    same = type(read) is type(motion)
    if isinstance(motion, Wait) and isinstance(read, Wait):
        same = abs(motion.programmed - read.programmed) <= 1e-6 and motion.condition == read.condition
    if isinstance(motion, SignalEvent) and isinstance(read, SignalEvent):
        same = motion.signal == read.signal and abs(motion.value - read.value) <= 1e-6
    return [] if same else [_mismatch(motion, "what the program says there")]


def _mismatch(motion: Motion, difference: str) -> InputError:
    return refusal(motion.source, f"the plan wants {difference}; this statement cannot carry the plan")
