r"""Moves on whose way something happens: TriggL and its triggers, MoveLDO, MoveLSync and their like."""

from __future__ import annotations

from trajopt_cli.motion import Happens, MoveC, MoveJ, MoveL, PathEvent, Process
from trajopt_cli.rapid.data.datatypes import STRING, Value
from trajopt_cli.rapid.execution.arguments import Arguments, bind
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.instructions.effect import Effect, Handler, Topic
from trajopt_cli.rapid.execution.instructions.moves import PoseKind, asked, to_pose
from trajopt_cli.rapid.language.syntax import Expression, ProcedureCall
from trajopt_cli.units import MM

_OUTPUTS = ("DOp", "GOp", "AOp")
_NUMBERED = tuple(f"T{i}" for i in range(2, 9))

# --------------------------------------------------------------------------------------------- setting up triggers


def _trigger(run: Context, node: ProcedureCall, argument: Expression, event: PathEvent) -> None:
    place = run.locate(argument)
    if place.type.name != "triggdata":
        raise run.error(argument, f"{run.text(argument)} is a {place.type.name}; {node.name} sets up triggdata")
    place.value = Value(place.type, (event,))


def _where(run: Context, distance: Expression, args: Arguments) -> tuple[float, float, bool]:
    r"""distance [m], time [s], from_start; \Time makes a time of the number."""
    value = run.number(distance)
    if value < 0:
        raise run.error(distance, f"a trigger lies {value:.6g} before the end of the move; it must not be negative")
    start = "start" in args.optional
    return (0.0, value, start) if "time" in args.optional else (value * MM, 0.0, start)


def _output(run: Context, node: ProcedureCall, args: Arguments) -> str:
    given = [(name, args.optional[name.lower()]) for name in _OUTPUTS if name.lower() in args.optional]
    if len(given) != 1 or given[0][1] is None:
        raise run.error(node, f"{node.name} needs one output: \\DOp, \\GOp or \\AOp")
    return run.signal(given[0][1])


def _io(run: Context, node: ProcedureCall) -> None:
    r"""TriggIO TriggData, Distance [\Start | \Time] \DOp | \GOp | \AOp, SetValue."""
    options = ("Start", "Time", *_OUTPUTS, "ProcID", "DODelay")
    args = bind(run, node, ("TriggData", "Distance", "SetValue"), options)
    trigger, distance, value = args.required
    if "procid" in args.optional:
        raise run.error(
            node, "TriggIO \\ProcID belongs to a process option and does not set a signal that is known here"
        )
    length, time, start = _where(run, distance, args)
    signal = _output(run, node, args)
    event = PathEvent(Happens.SIGNAL, signal, run.number(value), distance=length, time=time, from_start=start)
    _trigger(run, node, trigger, event)


def _equipment(run: Context, node: ProcedureCall) -> None:
    r"""TriggEquip TriggData, Distance [\Start], EquipLag \DOp | \GOp | \AOp, SetValue."""
    options = ("Start", *_OUTPUTS, "ProcID", "Inhib", "InhibDO", "Mode")
    args = bind(run, node, ("TriggData", "Distance", "EquipLag", "SetValue"), options)
    trigger, distance, lag, value = args.required
    length, _, start = _where(run, distance, args)
    signal, wanted = _output(run, node, args), run.number(value)
    event = PathEvent(Happens.SIGNAL, signal, wanted, distance=length, time=run.number(lag), from_start=start)
    _trigger(run, node, trigger, event)


def _interrupt(run: Context, node: ProcedureCall) -> None:
    r"""TriggInt TriggData, Distance [\Start | \Time], Interrupt."""
    args = bind(run, node, ("TriggData", "Distance", "Interrupt"), ("Start", "Time"))
    trigger, distance, interrupt = args.required
    length, time, start = _where(run, distance, args)
    event = PathEvent(Happens.INTERRUPT, run.text(interrupt), distance=length, time=time, from_start=start)
    _trigger(run, node, trigger, event)


def _check(run: Context, node: ProcedureCall) -> None:
    r"""TriggCheckIO TriggData, Distance [\Start | \Time], Signal, Relation, CheckValue [\StopMove], Interrupt."""
    required = ("TriggData", "Distance", "Signal", "Relation", "CheckValue", "Interrupt")
    args = bind(run, node, required, ("Start", "Time", "StopMove"))
    trigger, distance, *_, interrupt = args.required
    length, time, start = _where(run, distance, args)
    event = PathEvent(Happens.INTERRUPT, run.text(interrupt), distance=length, time=time, from_start=start)
    _trigger(run, node, trigger, event)


def _ramp(run: Context, node: ProcedureCall) -> None:
    r"""TriggRampAO TriggData, Distance [\Start], EquipLag, AOutput, SetValue, RampLength [\Time]."""
    required = ("TriggData", "Distance", "EquipLag", "AOutput", "SetValue", "RampLength")
    args = bind(run, node, required, ("Start", "Time"))
    trigger, distance, lag, output, value, _ = args.required
    signal, wanted = run.signal(output), run.number(value)
    event = PathEvent(
        Happens.SIGNAL,
        signal,
        wanted,
        distance=run.number(distance) * MM,
        time=run.number(lag),
        from_start="start" in args.optional,
    )
    _trigger(run, node, trigger, event)


def _scaled(run: Context, node: ProcedureCall) -> None:
    r"""TriggSpeed TriggData, Distance [\Start], ScaleLag, AOp, ScaleValue: an output that follows the TCP speed.

    Its value depends on the speed, so the event has none.
    """
    required = ("TriggData", "Distance", "ScaleLag", "AOp", "ScaleValue")
    args = bind(run, node, required, ("Start", "DipLag", "ErrDO", "Inhib", "InhibDO", "Mode"))
    trigger, distance, lag, output, _ = args.required
    length, _, start = _where(run, distance, args)
    event = PathEvent(Happens.SIGNAL, run.signal(output), distance=length, time=run.number(lag), from_start=start)
    _trigger(run, node, trigger, event)


# -------------------------------------------------------------------------------------------------- moves with them


def _triggered(kind: PoseKind, name: str) -> Handler:
    via = ("CirPoint",) if kind is MoveC else ()
    options = ("Conc", "ID", "V", "T", *_NUMBERED, "Inpos", "WObj", "Corr", "TLoad")

    def handler(run: Context, node: ProcedureCall) -> None:
        args = bind(run, node, (*via, "ToPoint", "Speed", "Trigg_1", "Zone", "Tool"), options)
        *points, speed, trigger, zone, tool = args.required
        given = [trigger, *(args.optional[key.lower()] for key in _NUMBERED if key.lower() in args.optional)]
        events = tuple(event for argument in given if argument is not None for event in _events(run, argument))
        plain = Arguments((*points, speed, zone, tool), args.optional)
        to_pose(run, node, kind, asked(plain, via=bool(via)), events=events, process=Process(name))
        for event in events:
            _happen(run, event)

    return handler


def _events(run: Context, argument: Expression) -> tuple[PathEvent, ...]:
    data = run.locate(argument).value.data
    found = tuple(data) if isinstance(data, tuple) else ()
    flat = tuple(event for part in found for event in (part if isinstance(part, tuple) else (part,)))
    if not any(isinstance(event, PathEvent) for event in flat):
        raise run.error(
            argument, f"trigger {run.text(argument)} was never set up; TriggIO, TriggInt ... must come first"
        )
    return tuple(event for event in flat if isinstance(event, PathEvent))


def _happen(run: Context, event: PathEvent) -> None:
    if event.kind is Happens.SIGNAL and event.value is not None:
        run.external.set(event.name, event.value)


def _with_output(kind: PoseKind, name: str) -> Handler:
    """MoveLDO and its like: the output is set in the middle of the corner."""
    via = ("CirPoint",) if kind is MoveC else ()
    group = name.endswith("GO")

    def handler(run: Context, node: ProcedureCall) -> None:
        required = (*via, "ToPoint", "Speed", "Zone", "Tool", "Signal", *(() if group else ("Value",)))
        args = bind(run, node, required, ("ID", "T", "WObj", "TLoad", *(("Value", "DValue") if group else ())))
        value = args.value("value") or args.value("dvalue") if group else args.required[-1]
        if value is None:
            raise run.error(node, f"{name} needs \\Value or \\DValue")
        signal = args.required[4 + len(via)]
        event = PathEvent(Happens.SIGNAL, run.signal(signal), run.number(value))
        to_pose(run, node, kind, asked(args, via=bool(via)), events=(event,), process=Process(name))
        _happen(run, event)

    return handler


def _with_procedure(kind: PoseKind, name: str) -> Handler:
    """MoveLSync and its like: a procedure is run in the middle of the corner; here right after the move."""
    via = ("CirPoint",) if kind is MoveC else ()

    def handler(run: Context, node: ProcedureCall) -> None:
        required = (*via, "ToPoint", "Speed", "Zone", "Tool", "ProcName")
        args = bind(run, node, required, ("ID", "T", "WObj", "TLoad"))
        argument = args.required[-1]
        procedure = str(run.evaluate(argument, STRING).data)
        event = PathEvent(Happens.PROCEDURE, procedure)
        to_pose(run, node, kind, asked(args, via=bool(via)), events=(event,), process=Process(name))
        run.settle()
        run.call_procedure(argument, procedure)

    return handler


_KINDS: tuple[tuple[str, PoseKind], ...] = (("J", MoveJ), ("L", MoveL), ("C", MoveC))

INSTRUCTIONS: Topic = {
    Effect.PLANNED: {
        "TriggIO": _io,
        "TriggEquip": _equipment,
        "TriggInt": _interrupt,
        "TriggCheckIO": _check,
        "TriggRampAO": _ramp,
        "TriggSpeed": _scaled,
        **{name: _triggered(kind, name) for letter, kind in _KINDS for name in (f"Trigg{letter}",)},
        **{
            name: _with_output(kind, name)
            for letter, kind in _KINDS
            for name in (f"Move{letter}DO", f"Move{letter}AO", f"Move{letter}GO")
        },
        **{name: _with_procedure(kind, name) for letter, kind in _KINDS for name in (f"Move{letter}Sync",)},
    }
}
