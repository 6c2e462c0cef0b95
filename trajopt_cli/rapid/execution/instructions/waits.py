"""Waits."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from trajopt_cli.motion import Wait, Written
from trajopt_cli.rapid.data.datatypes import BOOL, Value
from trajopt_cli.rapid.execution.arguments import Instruction, bind
from trajopt_cli.rapid.execution.evaluate import number
from trajopt_cli.rapid.language.syntax import Binary, Call, Expression, Name, ProcedureCall, Unary

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Run


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


INSTRUCTIONS: dict[str, Instruction] = {
    "WaitTime": _wait_time,
    "WaitDI": _wait_signal,
    "WaitDO": _wait_signal,
    "WaitUntil": _wait_until,
}
