"""Signals: outputs set, values read, other names. Inputs lack where the scenario says nothing, outputs begin at 0."""

from __future__ import annotations

from trajopt_cli.motion import SignalEvent, Written
from trajopt_cli.rapid.data.datatypes import BOOL, DNUM, NUM, SIGNALS, STRING, TYPES, Type, Value
from trajopt_cli.rapid.data.scope import Datum
from trajopt_cli.rapid.execution.arguments import Effect, Refused, Topic
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.language.syntax import Call, Expression, Name, ProcedureCall, String
from trajopt_cli.warnings import WarningKind

_OUTPUTS = Topic("Outputs set, and signals under another name")


def _event(run: Context, node: ProcedureCall, signal: str, value: float, delay: float, given: float) -> None:
    written = Written(statement=run.places().span(node.start, node.end))
    run.settle_stop()
    drives = run.rail_places.set(signal, given)
    run.motions.append(
        SignalEvent(
            source=run.source(node), written=written, signal=signal, value=value, delay=delay, drives_rail=drives
        )
    )


def _change(
    run: Context, node: ProcedureCall, signal: str, value: float, delay: float = 0.0, given: float | None = None
) -> None:
    """given: the value as written, where the signal takes another."""
    _check_seconds("SDelay", delay)
    run.external.set(signal, value)
    _event(run, node, signal, value, delay, value if given is None else given)


def _check_seconds(name: str, seconds: float) -> None:
    if not seconds >= 0:
        raise Refused(f"\\{name} of {seconds:.6g} s must not be negative", name)


@_OUTPUTS.instruction(
    Effect.RUN, "SetAO Signal:signal Value:num", *(f"{name} Signal:signal" for name in ("Set", "Reset", "InvertDO"))
)
def _set(run: Context, node: ProcedureCall, signal: str, value: float | None = None) -> None:
    if value is None:
        known = {"set": 1.0, "reset": 0.0}
        value = known.get(node.name.lower(), 1.0 - run.external.now(signal))
    _change(run, node, signal, value)


@_OUTPUTS.instruction(Effect.RUN, r"SetDO Signal Value:num \SDelay:num \Sync")
def _set_digital(
    run: Context, node: ProcedureCall, argument: Expression, given: float, sdelay: float = 0.0, sync: bool = False
) -> None:
    """Everything but 0 is 1, as on a controller."""
    signal = run.signal(argument)
    run.check_digital(argument, signal)
    _change(run, node, signal, float(given != 0), sdelay, given)


@_OUTPUTS.instruction(Effect.RUN, r"SetGO Signal:signal Value:num \SDelay:num")
def _set_group(run: Context, node: ProcedureCall, signal: str, value: float, sdelay: float = 0.0) -> None:
    if value < 0 or value != int(value):
        message = f"{node.name} {signal} needs a whole number, 0 or more, found {value:.15g}"
        raise Refused(message, "Value", "ERR_GO_LIM")
    _change(run, node, signal, value, sdelay)


@_OUTPUTS.instruction(Effect.RUN, r"PulseDO Signal:signal \High \PLength:num")
def _pulse(run: Context, node: ProcedureCall, signal: str, high: bool = False, plength: float = 0.0) -> None:
    r"""The event is the pulse's own level; afterwards the signal is what it was. \PLength holds up nothing."""
    _check_seconds("PLength", plength)
    level = 1.0 if high else 1.0 - run.external.now(signal)
    _event(run, node, signal, level, 0.0, level)


# ------------------------------------------------------------------------------------------------------ other names


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
        what = f"alias '{alias.name}' is not declared in the files read; it is taken as a signal"
        run.warn(WarningKind.ASSUMED, what, run.source(alias))
        run.shared.data[alias.name.lower()] = Datum(TYPES["signaldi"], Value(TYPES["signaldi"], signal))
    place = run.locate(alias)
    if place.type.name not in SIGNALS:
        raise run.error(alias, f"an alias is declared as a signal, 'VAR signaldi {run.text(alias)};'")
    place.value = Value(place.type, signal)


# From here on an alias stands for the signal, or for none.
_OUTPUTS.instruction(Effect.RUN, "AliasIO FromSignal ToSignal")(
    lambda run, node, original, alias: _rename(run, alias, _signal_name(run, original))
)
_OUTPUTS.instruction(Effect.RUN, "AliasIOReset Signal")(lambda run, node, alias: _rename(run, alias, None))


_READINGS = Topic("Functions that read signals. Inputs lack where the scenario says nothing, outputs begin at 0")


@_READINGS.function("AInput Signal", "GInput Signal", "GInputDnum Signal")
def _input(run: Context, node: Call, argument: Expression) -> Value:
    signal, written = run.signal(argument), run.text(argument)
    value = run.read_signal(argument, written if written.lower() == signal else signal)
    return Value(_type_of(node), value)


@_READINGS.function("TestDI Signal", "DInput Signal")
def _digital(run: Context, node: Call, argument: Expression) -> Value:
    run.check_digital(argument, run.signal(argument))
    value = _input(run, node, argument)
    return Value(BOOL, value.data == 1.0) if node.name.lower() == "testdi" else value


@_READINGS.function(
    "DOutput Signal:signal", "GOutput Signal:signal", "GOutputDnum Signal:signal", "AOutput Signal:signal"
)
def _output(run: Context, node: Call, signal: str) -> Value:
    """The state of an output."""
    run.settle_stop()
    return Value(_type_of(node), run.external.output(signal))


def _type_of(node: Call) -> Type:
    return DNUM if node.name.lower().endswith("dnum") else NUM


_READINGS.values("ValidIO Signal", BOOL)(lambda _: True)  # every signal works, inputs and outputs alike
