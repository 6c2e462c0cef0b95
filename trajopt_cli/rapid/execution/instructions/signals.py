"""Outputs set."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.motion import SignalEvent, Written
from trajopt_cli.rapid.execution.arguments import Instruction, bind
from trajopt_cli.rapid.execution.evaluate import number
from trajopt_cli.rapid.language.syntax import ProcedureCall

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Run


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
    run.world.set(signal, value)
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
    before = run.world.output(signal)
    _event(run, node, signal, 1.0 if "high" in args.optional else 1.0 - before)


def _invert(run: Run, node: ProcedureCall) -> None:
    (argument,) = bind(run, node, ("Signal",)).required
    signal = run.signal(argument)
    _change(run, node, signal, 1.0 - run.world.output(signal))


INSTRUCTIONS: dict[str, Instruction] = {
    "Set": _set,
    "Reset": _reset,
    "SetDO": _set_output,
    "SetGO": _set_output,
    "SetAO": _set_output,
    "PulseDO": _pulse,
    "InvertDO": _invert,
}
