r"""Moves on whose way something happens: TriggL and its triggers, MoveLDO, MoveLSync and their like."""

from __future__ import annotations

from trajopt_cli.motion import Happens, MoveC, MoveJ, MoveL, PathEvent, Process
from trajopt_cli.rapid.data.datatypes import STRING, Value
from trajopt_cli.rapid.execution.arguments import Arguments, Effect, Form, Topic, bind
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.instructions.moves import PoseKind, asked, to_pose
from trajopt_cli.rapid.language.syntax import Expression, ProcedureCall
from trajopt_cli.units import MM

_OUTPUTS = ("DOp", "GOp", "AOp")
_ANY = r"\DOp \GOp \AOp"
_NUMBERED = tuple(f"T{i}" for i in range(2, 9))
_TRIGGERS = Topic("Moves on whose way something happens")

# --------------------------------------------------------------------------------------------- setting up triggers


def _set_up(name: str, takes: str, kind: Happens = Happens.SIGNAL, *, valued: bool = True) -> None:
    r"""An instruction that sets up triggdata, by the names of what it takes.

    Where: Distance before the end of the move, or after its start with \Start; \Time makes seconds of it, EquipLag and
    ScaleLag are seconds more. What: an interrupt, or the output of AOutput, AOp, \DOp, \GOp or \AOp, set to SetValue;
    valued False: its value depends on the speed, so the event has none.
    """
    required, optional = (form := Form(takes)).required, form.optional

    @_TRIGGERS.enter(Effect.PLANNED, name)
    def handler(run: Context, node: ProcedureCall) -> None:
        args = bind(run, node, required, optional)
        given = dict(zip(required, args.required, strict=True))
        if "procid" in args.optional and node.name.lower() == "triggio":
            what = "TriggIO \\ProcID belongs to a process option and does not set a signal that is known here"
            raise run.error(node, what)
        distance = given["Distance"]
        value, start = run.number(distance), "start" in args.optional
        if value < 0 and "RampLength" not in given:
            what = f"a trigger lies {value:.6g} before the end of the move; it must not be negative"
            raise run.error(distance, what)
        timed = "time" in args.optional and "RampLength" not in given
        length, time = (0.0, value) if timed else (value * MM, 0.0)
        if kind is Happens.INTERRUPT:
            event = PathEvent(kind, run.text(given["Interrupt"]), distance=length, time=time, from_start=start)
        else:
            output = given.get("AOutput") or given.get("AOp")
            signal = _output(run, node, args) if output is None else run.signal(output)
            wanted = run.number(given["SetValue"]) if valued else None
            lag = given.get("EquipLag") or given.get("ScaleLag")
            time = time if lag is None else run.number(lag)
            event = PathEvent(kind, signal, wanted, distance=length, time=time, from_start=start)
        place = run.locate(given["TriggData"])
        if place.type.name != "triggdata":
            text = f"{run.text(given['TriggData'])} is a {place.type.name}; {node.name} sets up triggdata"
            raise run.error(given["TriggData"], text)
        place.value = Value(place.type, (event,))


_set_up("TriggIO", rf"TriggData Distance SetValue \Start \Time {_ANY} \ProcID \DODelay")
_set_up("TriggEquip", rf"TriggData Distance EquipLag SetValue \Start {_ANY} \ProcID \Inhib \InhibDO \Mode")
_set_up("TriggInt", r"TriggData Distance Interrupt \Start \Time", Happens.INTERRUPT)
_set_up(
    "TriggCheckIO", r"TriggData Distance Signal Relation CheckValue Interrupt \Start \Time \StopMove", Happens.INTERRUPT
)
_set_up("TriggRampAO", r"TriggData Distance EquipLag AOutput SetValue RampLength \Start \Time")
_set_up(
    "TriggSpeed",
    r"TriggData Distance ScaleLag AOp ScaleValue \Start \DipLag \ErrDO \Inhib \InhibDO \Mode",
    valued=False,
)


def _output(run: Context, node: ProcedureCall, args: Arguments) -> str:
    given = [(name, args.optional[name.lower()]) for name in _OUTPUTS if name.lower() in args.optional]
    if len(given) != 1 or given[0][1] is None:
        raise run.error(node, f"{node.name} needs one output: \\DOp, \\GOp or \\AOp")
    return run.signal(given[0][1])


# -------------------------------------------------------------------------------------------------- moves with them


def _triggered(kind: PoseKind, name: str) -> None:
    via = kind.via
    options = ("Conc", "ID", "V", "T", *_NUMBERED, "Inpos", "WObj", "Corr", "TLoad")

    @_TRIGGERS.enter(Effect.PLANNED, name)
    def handler(run: Context, node: ProcedureCall) -> None:
        args = bind(run, node, (*via, "ToPoint", "Speed", "Trigg_1", "Zone", "Tool"), options)
        *points, speed, trigger, zone, tool = args.required
        given = [trigger, *(args.optional[key.lower()] for key in _NUMBERED if key.lower() in args.optional)]
        events = tuple(event for argument in given if argument is not None for event in _events(run, argument))
        plain = Arguments((*points, speed, zone, tool), args.optional)
        to_pose(run, node, kind, asked(plain, via=bool(via)), events=events, process=Process(name))
        for event in events:
            _happen(run, event)


def _events(run: Context, argument: Expression) -> tuple[PathEvent, ...]:
    data = run.locate(argument).value.data
    found = tuple(data) if isinstance(data, tuple) else ()
    flat = tuple(event for part in found for event in (part if isinstance(part, tuple) else (part,)))
    if not any(isinstance(event, PathEvent) for event in flat):
        message = f"trigger {run.text(argument)} was never set up; TriggIO, TriggInt ... must come first"
        raise run.error(argument, message)
    return tuple(event for event in flat if isinstance(event, PathEvent))


def _happen(run: Context, event: PathEvent) -> None:
    if event.kind is Happens.SIGNAL and event.value is not None:
        run.external.set(event.name, event.value)


def _with_output(kind: PoseKind, name: str) -> None:
    """MoveLDO and its like: the output is set in the middle of the corner."""
    via = kind.via
    group = name.endswith("GO")

    @_TRIGGERS.enter(Effect.PLANNED, name)
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


def _with_procedure(kind: PoseKind, name: str) -> None:
    """MoveLSync and its like: a procedure is run in the middle of the corner; here right after the move."""
    via = kind.via

    @_TRIGGERS.enter(Effect.PLANNED, name)
    def handler(run: Context, node: ProcedureCall) -> None:
        required = (*via, "ToPoint", "Speed", "Zone", "Tool", "ProcName")
        args = bind(run, node, required, ("ID", "T", "WObj", "TLoad"))
        argument = args.required[-1]
        procedure = str(run.evaluate(argument, STRING).data)
        event = PathEvent(Happens.PROCEDURE, procedure)
        to_pose(run, node, kind, asked(args, via=bool(via)), events=(event,), process=Process(name))
        run.settle()
        run.call_procedure(argument, procedure)


for letter, pose in (("J", MoveJ), ("L", MoveL), ("C", MoveC)):
    _triggered(pose, f"Trigg{letter}")
    for output in ("DO", "AO", "GO"):
        _with_output(pose, f"Move{letter}{output}")
    _with_procedure(pose, f"Move{letter}Sync")
