"""An exported program, read again, against the plan: the last look before anybody sees it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.motion import Motion, Move, MoveAbsJ, MoveJ, MoveL, Program, SignalEvent, Wait
from trajopt_cli.problem.plan import Plan, PlannedMotion
from trajopt_cli.problem.plant import Plant
from trajopt_cli.rapid.reader import run_program
from trajopt_cli.robot.inverse import confdata_admits
from trajopt_cli.scenario import Scenario
from trajopt_cli.units import MM

_POSE = 1e-9  # m and rotation entries: a target's own numbers are not touched
_RAIL = 1e-9  # m: eax is written to the nanometre
_NEW_POSE = 1e-8  # a target that was a jointtarget is written with 9 decimals of a millimetre and 15 of a quaternion


def check_export(
    program: Program, plan: Plan, plant: Plant, texts: Mapping[str, str], scenario: Scenario | None, entry: str
) -> None:
    """Raises InputError, placed in the given program, for the first motion that the texts do not give as planned."""
    files = [replace(file, text=texts[path]) for path, file in program.files.items()]
    try:
        read = iter(run_program(files, scenario, entry).motions)
    except InputError as error:
        raise InputError(f"the plan cannot be written into this program; edited, it reads: {error}") from error
    by_index = {planned.index: planned for planned in plan.motions}
    before: Move | None = None
    for index, motion in enumerate(program.motions):
        planned = by_index.get(index)
        if planned is not None and planned.dropped:
            continue
        match motion:
            case Wait() if planned is not None and _rail_moves(planned, plant):
                _check_dwell(motion, before, planned, plant, next(read, None))
                if motion.condition is not None:
                    _check_same(motion, next(read, None))
            case Wait() | SignalEvent():
                _check_same(motion, next(read, None))
            case _:
                if planned is None:
                    raise ValueError(f"the plan leaves out motion {index} ({motion.source}) without dropping it")
                _check_move(motion, planned, plant, next(read, None))
                before = motion
    surplus = next(read, None)
    if surplus is not None:
        raise InputError(f"the edited program has a motion too many at {surplus.source}")


def _rail_moves(planned: PlannedMotion, plant: Plant) -> bool:
    return plant.rail_eax is not None and abs(float(planned.q_1[0] - planned.q_0[0])) > _RAIL


def _differences(motion: Move, planned: PlannedMotion, plant: Plant, read: Move) -> Iterator[str]:
    if plant.rail_eax is not None:
        wanted, given = float(planned.q_1[0]), plant.rail_value(read.extax)
        if given is None or not abs(wanted - given) <= _RAIL:
            shown = "open" if given is None else f"{given / MM:.6f} mm"
            yield f"the rail at {wanted / MM:.6f} mm, and the target says {shown}"
    if isinstance(motion, (MoveJ, MoveL)) and isinstance(read, (MoveJ, MoveL)):
        if not np.allclose(motion.X_WT, read.X_WT, rtol=0.0, atol=_POSE):
            yield "the tool in the programmed place, and the target is elsewhere"
        if not confdata_admits(plant.robot, read.conf, np.asarray(planned.q_1[-6:])):
            conf = read.conf
            yield f"another configuration than the target's [{conf.cf1},{conf.cf4},{conf.cf6},{conf.cfx}]"
    if isinstance(motion, MoveAbsJ) and isinstance(read, MoveAbsJ) and not np.array_equal(motion.q, read.q):
        yield "the programmed joints, and the target has others"


def _check_move(motion: Move, planned: PlannedMotion, plant: Plant, read: Motion | None) -> None:
    if not isinstance(read, Move) or type(read) is not type(motion):
        raise _mismatch(motion, f"{type(motion).__name__} {motion.target} there")
    for difference in _differences(motion, planned, plant, read):
        raise _mismatch(motion, difference)


def _check_dwell(wait: Wait, before: Move | None, planned: PlannedMotion, plant: Plant, read: Motion | None) -> None:
    if not isinstance(read, MoveL) or before is None:
        raise _mismatch(wait, "a MoveL there that takes the rail along")
    for difference in _differences(read, planned, plant, read):
        raise _mismatch(wait, difference)
    if isinstance(before, (MoveJ, MoveL)):
        same = np.allclose(before.X_WT, read.X_WT, rtol=0.0, atol=_POSE)
    else:
        X_WF = plant.robot.forward(planned.q_1)
        same = np.allclose(X_WF @ read.tool.X_FT, read.X_WT, rtol=0.0, atol=_NEW_POSE)
    if not same or read.duration is None or abs(read.duration - wait.duration) > 1e-6:
        raise _mismatch(wait, "the tool to rest for the time of the wait")


def _check_same(motion: Wait | SignalEvent, read: Motion | None) -> None:
    same = type(read) is type(motion)
    if isinstance(motion, Wait) and isinstance(read, Wait):
        same = (motion.duration, motion.condition) == (read.duration, read.condition)
    if isinstance(motion, SignalEvent) and isinstance(read, SignalEvent):
        same = (motion.signal, motion.value) == (read.signal, read.value)
    if not same:
        raise _mismatch(motion, "what the program says there")


def _mismatch(motion: Motion, difference: str) -> InputError:
    place = motion.source
    hint = "this statement cannot carry the plan"
    if isinstance(motion, Move) and motion.written.aggregate is None:
        hint = f"{motion.target} is computed, so it cannot be edited: declare it as a {_kind(motion)} of its own"
    message = f"the plan wants {difference}; {hint}"
    return InputError(message, file=place.file, line=place.line, column=place.column)


def _kind(motion: Move) -> str:
    return "robtarget" if isinstance(motion, (MoveJ, MoveL)) else "jointtarget"
