"""Outputs set, and signals under another name."""

from __future__ import annotations

from trajopt_cli.motion import SignalEvent, Written
from trajopt_cli.rapid.data.datatypes import SIGNALS, STRING, TYPES, Value
from trajopt_cli.rapid.data.scope import Datum
from trajopt_cli.rapid.execution.arguments import Arguments, bind
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.instructions.effect import Effect, Topic
from trajopt_cli.rapid.language.syntax import Call, Expression, Name, ProcedureCall, String
from trajopt_cli.warnings import WarningKind


def _event(
    run: Context, node: ProcedureCall, signal: str, value: float, delay: float = 0.0, given: float | None = None
) -> None:
    written = Written(statement=run.places().span(node.start, node.end))
    run.settle_stop()
    drives = run.rail_places is not None and run.rail_places.set(signal, value if given is None else given)
    run.motions.append(
        SignalEvent(
            source=run.source(node), written=written, signal=signal, value=value, delay=delay, drives_rail=drives
        )
    )


def _change(
    run: Context, node: ProcedureCall, signal: str, value: float, delay: float = 0.0, given: float | None = None
) -> None:
    """given: the value as written, where the signal takes another."""
    run.external.set(signal, value)
    _event(run, node, signal, value, delay, given)


def _set(run: Context, node: ProcedureCall) -> None:
    (signal,) = bind(run, node, ("Signal",)).required
    _change(run, node, run.signal(signal), 1.0)


def _reset(run: Context, node: ProcedureCall) -> None:
    (signal,) = bind(run, node, ("Signal",)).required
    _change(run, node, run.signal(signal), 0.0)


def _set_digital(run: Context, node: ProcedureCall) -> None:
    """Everything but 0 is 1, as on a controller."""
    args = bind(run, node, ("Signal", "Value"), ("SDelay", "Sync"))
    signal, value = args.required
    run.check_digital(signal, run.signal(signal))
    given = run.number(value)
    _change(run, node, run.signal(signal), float(given != 0), _seconds(run, args, "SDelay"), given)


def _set_group(run: Context, node: ProcedureCall) -> None:
    args = bind(run, node, ("Signal", "Value"), ("SDelay",))
    signal, value = run.signal(args.required[0]), run.number(args.required[1])
    if value < 0 or value != int(value):
        message = f"{node.name} {signal} needs a whole number, 0 or more, found {value:.15g}"
        raise run.fault(args.required[1], "ERR_GO_LIM", message)
    _change(run, node, signal, value, _seconds(run, args, "SDelay"))


def _set_analog(run: Context, node: ProcedureCall) -> None:
    args = bind(run, node, ("Signal", "Value"))
    signal, value = args.required
    _change(run, node, run.signal(signal), run.number(value))


def _pulse(run: Context, node: ProcedureCall) -> None:
    r"""The event is the pulse's own level; afterwards the signal is what it was. \PLength holds up nothing."""
    args = bind(run, node, ("Signal",), ("High", "PLength"))
    signal = run.signal(args.required[0])
    _seconds(run, args, "PLength")
    _event(run, node, signal, 1.0 if "high" in args.optional else 1.0 - run.external.now(signal))


def _invert(run: Context, node: ProcedureCall) -> None:
    (argument,) = bind(run, node, ("Signal",)).required
    signal = run.signal(argument)
    _change(run, node, signal, 1.0 - run.external.now(signal))


def _seconds(run: Context, args: Arguments, name: str) -> float:
    node = args.value(name.lower())
    seconds = run.number(node) if node is not None else 0.0
    if node is not None and not seconds >= 0:
        raise run.error(node, f"\\{name} of {seconds:.6g} s must not be negative")
    return seconds


# ------------------------------------------------------------------------------------------------------ other names


def _alias(run: Context, node: ProcedureCall) -> None:
    """From here on the alias stands for the signal."""
    original, alias = bind(run, node, ("FromSignal", "ToSignal")).required
    _rename(run, alias, _signal_name(run, original))


def _alias_reset(run: Context, node: ProcedureCall) -> None:
    (alias,) = bind(run, node, ("Signal",)).required
    _rename(run, alias, None)


def _signal_name(run: Context, node: Expression) -> str:
    """A signal given as such or by a text that is its name."""
    if isinstance(node, Name):
        place = run.find(node.name)
        if place is None or getattr(place, "type", STRING) != STRING:
            return run.signal(node)
    if isinstance(node, (String, Call, Name)):
        return str(run.evaluate(node, STRING).data).strip().lower()
    return run.signal(node)


def _rename(run: Context, alias: Expression, signal: str | None) -> None:
    if isinstance(alias, Name) and run.find(alias.name) is None:
        run.warn(
            WarningKind.ASSUMED,
            f"alias '{alias.name}' is not declared in the files read; it is taken as a signal",
            run.source(alias),
        )
        run.shared.data[alias.name.lower()] = Datum(TYPES["signaldi"], Value(TYPES["signaldi"], signal))
    place = run.locate(alias)
    if place.type.name not in SIGNALS:
        raise run.error(alias, f"an alias is declared as a signal, 'VAR signaldi {run.text(alias)};'")
    place.value = Value(place.type, signal)


INSTRUCTIONS: Topic = {
    Effect.RUN: {
        "Set": _set,
        "Reset": _reset,
        "SetDO": _set_digital,
        "SetGO": _set_group,
        "SetAO": _set_analog,
        "PulseDO": _pulse,
        "InvertDO": _invert,
        "AliasIO": _alias,
        "AliasIOReset": _alias_reset,
    }
}
