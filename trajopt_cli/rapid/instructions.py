r"""Every supported instruction: one handler and one line in INSTRUCTIONS.

An instruction is read over silently only if it has no effect on motion at all. One that changes how the robot moves
(ConfL \Off, AccSet 50, ...) is refused unless it asks for what holds anyway.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from trajopt_cli.motion import SignalEvent, Wait, Written
from trajopt_cli.rapid.arguments import bind
from trajopt_cli.rapid.datatypes import BOOL, NUM, Value
from trajopt_cli.rapid.evaluate import locate, number
from trajopt_cli.rapid.moves import move_abs_j, move_ext_j, move_j, move_l
from trajopt_cli.rapid.syntax import Binary, Call, Expression, Name, Node, ProcedureCall, Unary

if TYPE_CHECKING:
    from trajopt_cli.rapid.interpreter import Run

Handler = Callable[["Run", ProcedureCall], None]


# ----------------------------------------------------------------------------------------------------------- waits


def _least(waits: Mapping[str, float], keys: tuple[str, ...]) -> float:
    known = {"".join(key.split()).lower(): seconds for key, seconds in waits.items()}
    return next((known[key] for key in ("".join(key.split()).lower() for key in keys) if key in known), 0.0)


def _wait(run: Run, node: ProcedureCall, duration: float, condition: str | None) -> None:
    written = Written(statement=run.places().span(node.start, node.end))
    run.motions.append(Wait(source=run.source(node), written=written, duration=duration, condition=condition))


def _wait_time(run: Run, node: ProcedureCall) -> None:
    args = bind(run, node, ("Time",), ("InPos",))
    seconds = number(run, args.required[0])
    if not seconds >= 0:
        raise run.error(args.required[0], f"WaitTime {seconds:.6g} s must not be negative")
    _wait(run, node, seconds, None)


def _wait_signal(run: Run, node: ProcedureCall) -> None:
    args = bind(run, node, ("Signal", "Value"), ("MaxTime", "TimeFlag"))
    signal, wanted = run.signal(args.required[0]), number(run, args.required[1])
    _no_timeout(run, args.value("timeflag"))
    condition = f"{run.text(args.required[0])} = {wanted:.15g}"
    _wait(run, node, _least(run.scenario.waits, (condition, signal)), condition)


def _wait_until(run: Run, node: ProcedureCall) -> None:
    args = bind(run, node, ("Cond",), ("InPos", "MaxTime", "TimeFlag", "PollRate"))
    condition = run.text(args.required[0])
    _no_timeout(run, args.value("timeflag"))
    names = {name.lower() for name in _names(args.required[0])}
    keys = (condition, *(names if len(names) == 1 else ()))
    _wait(run, node, _least(run.scenario.waits, keys), condition)


def _names(node: Expression) -> list[str]:
    match node:
        case Name():
            return [node.name]
        case Binary():
            return _names(node.left) + _names(node.right)
        case Unary():
            return _names(node.operand)
        case Call():
            return [name for arg in node.args if arg.value is not None for name in _names(arg.value)]
    return []


def _no_timeout(run: Run, flag: Expression | None) -> None:
    if flag is not None:
        run.assign(flag, Value(BOOL, False))


# --------------------------------------------------------------------------------------------------------- signals


def _event(run: Run, node: ProcedureCall, signal: str, value: float) -> None:
    written = Written(statement=run.places().span(node.start, node.end))
    run.motions.append(SignalEvent(source=run.source(node), written=written, signal=signal, value=value))


def _set(run: Run, node: ProcedureCall) -> None:
    (signal,) = bind(run, node, ("Signal",)).required
    _change(run, node, run.signal(signal), 1.0)


def _reset(run: Run, node: ProcedureCall) -> None:
    (signal,) = bind(run, node, ("Signal",)).required
    _change(run, node, run.signal(signal), 0.0)


def _change(run: Run, node: ProcedureCall, signal: str, value: float) -> None:
    run.signals[signal] = value
    _event(run, node, signal, value)


def _set_output(run: Run, node: ProcedureCall) -> None:
    args = bind(run, node, ("Signal", "Value"), ("SDelay", "Sync"))
    if "sdelay" in args.optional:
        run.warn(f"{run.source(node)}: the delay \\SDelay of {node.name} is listed as no delay; it changes no motion")
    signal, value = args.required
    _change(run, node, run.signal(signal), number(run, value))


def _pulse(run: Run, node: ProcedureCall) -> None:
    r"""The event is the pulse's own level; afterwards the signal is what it was. \PLength holds up nothing."""
    args = bind(run, node, ("Signal",), ("High", "PLength"))
    signal = run.signal(args.required[0])
    before = run.signals.get(signal, 0.0)
    _event(run, node, signal, 1.0 if "high" in args.optional else 1.0 - before)


def _invert(run: Run, node: ProcedureCall) -> None:
    (argument,) = bind(run, node, ("Signal",)).required
    signal = run.signal(argument)
    _change(run, node, signal, 1.0 - run.signals.get(signal, 0.0))


# ------------------------------------------------------------------------------------------------------- variables


def _step(sign: float) -> Handler:
    def handler(run: Run, node: ProcedureCall) -> None:
        (target,) = bind(run, node, ("Name",)).required
        run.assign(target, Value(NUM, number(run, target) + sign))

    return handler


def _add(run: Run, node: ProcedureCall) -> None:
    target, value = bind(run, node, ("Name", "AddValue")).required
    run.assign(target, Value(NUM, number(run, target) + number(run, value)))


def _clear(run: Run, node: ProcedureCall) -> None:
    (target,) = bind(run, node, ("Name",)).required
    run.assign(target, Value(locate(run, target).type, 0.0))


# -------------------------------------------------------------------------------------------------------- settings


def _nothing(run: Run, node: ProcedureCall) -> None:
    """No effect on motion; the arguments are not even looked at."""


def _refuse(run: Run, node: Node, what: str, holds: str) -> None:
    raise run.error(node, f"{what} is not supported; plans hold to {holds}, so remove it or ask for that")


def _configuration_on(run: Run, node: ProcedureCall) -> None:
    args = bind(run, node, (), ("On", "Off"))
    if "off" in args.optional:
        _refuse(run, node, f"{node.name} \\Off", f"the programmed configuration ({node.name} \\On)")


def _acceleration(run: Run, node: ProcedureCall) -> None:
    args = bind(run, node, ("Acc", "Ramp"), ("FinePointRamp",))
    if [number(run, value) for value in args.required] != [100.0, 100.0] or args.optional:
        _refuse(run, node, run.text(node).rstrip(";"), "the cell's full acceleration (AccSet 100, 100)")


def _velocity(run: Run, node: ProcedureCall) -> None:
    args = bind(run, node, ("Override", "Max"))
    percent, highest = (number(run, value) for value in args.required)
    if percent != 100.0 or highest < 5000.0:
        _refuse(run, node, run.text(node).rstrip(";"), "the programmed speeds (VelSet 100, 5000)")


def _singularity(run: Run, node: ProcedureCall) -> None:
    args = bind(run, node, (), ("Off", "Wrist", "LockAxis4"))
    if "off" not in args.optional:
        _refuse(run, node, run.text(node).rstrip(";"), "exact orientation (SingArea \\Off)")


def _grip_load(run: Run, node: ProcedureCall) -> None:
    bind(run, node, ("Load",))
    run.warn(f"{run.source(node)}: GripLoad changes nothing here; the cell's acceleration limits hold for any load")


def _exit_cycle(run: Run, node: ProcedureCall) -> None:
    from trajopt_cli.rapid.interpreter import Exit

    bind(run, node, ())
    raise Exit


INSTRUCTIONS: dict[str, Handler] = {
    "MoveJ": move_j,
    "MoveL": move_l,
    "MoveAbsJ": move_abs_j,
    "MoveExtJ": move_ext_j,
    "WaitTime": _wait_time,
    "WaitDI": _wait_signal,
    "WaitDO": _wait_signal,
    "WaitUntil": _wait_until,
    "WaitRob": _nothing,  # every stop is a full stop already
    "Set": _set,
    "Reset": _reset,
    "SetDO": _set_output,
    "SetGO": _set_output,
    "SetAO": _set_output,
    "PulseDO": _pulse,
    "InvertDO": _invert,
    "Incr": _step(1.0),
    "Decr": _step(-1.0),
    "Add": _add,
    "Clear": _clear,
    "ConfJ": _configuration_on,
    "ConfL": _configuration_on,
    "AccSet": _acceleration,
    "VelSet": _velocity,
    "SingArea": _singularity,
    "GripLoad": _grip_load,
    "ExitCycle": _exit_cycle,
    "TPWrite": _nothing,
    "TPErase": _nothing,
    "TPShow": _nothing,
    "ErrWrite": _nothing,
    "ClkReset": _nothing,
    "ClkStart": _nothing,
    "ClkStop": _nothing,
}
