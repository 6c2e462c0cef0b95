r"""Welding, spot welding, painting, dispensing: moves that carry data of a process along.

What the process does at the point is not modelled; the move is, and the data goes with it as written. The forms differ
between versions, so optional arguments that are not known are kept rather than refused.
"""

from __future__ import annotations

from trajopt_cli.motion import MoveC, MoveJ, MoveL, Process, Speed
from trajopt_cli.rapid.data.datatypes import Data, Record, Type, Value
from trajopt_cli.rapid.data.scope import Place
from trajopt_cli.rapid.execution.arguments import Arguments, Effect, Topic, named, present
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.instructions.motion_settings import speed_of
from trajopt_cli.rapid.execution.instructions.moves import POSE_OPTIONS, PoseKind, asked, to_pose
from trajopt_cli.rapid.language.syntax import Component, Expression, Name, ProcedureCall, base_of
from trajopt_cli.units import MM
from trajopt_cli.warnings import WarningKind

_PLAIN = frozenset(option.lower() for option in POSE_OPTIONS)
_PROCESSES = Topic("Welding, spot welding, painting, dispensing")


def _loose(
    run: Context, node: ProcedureCall, names: list[tuple[str, ...]]
) -> tuple[list[Expression], dict[str, Expression | None], Arguments]:
    """Arguments by place; optional ones of the process by name as written; those of every move.

    names: of the required arguments, as far as the instruction's forms go.
    """
    places: list[Expression] = []
    given = [arg for arg in node.args if arg.name is None]
    required = next((form for form in names if len(form) == len(given)), ())
    for place, arg in enumerate(given):
        if arg.parameter is not None and required:
            named(run, node.name, arg, place, required)
    own: dict[str, Expression | None] = {}
    plain: dict[str, Expression | None] = {}
    for arg in present(run, node.args):
        if arg.name is None:
            assert arg.value is not None
            places.append(arg.value)
        elif arg.name.lower() in _PLAIN:
            plain[arg.name.lower()] = arg.value
        else:
            own[arg.name] = arg.value
    return places, own, Arguments((), plain)


def _process(
    kind: PoseKind, name: str, data: tuple[str, ...], *, zone: bool = True, governing: int | None = None, more: str = ""
) -> None:
    """A move with process data between Speed and Zone; data names it, the last ones may be left out.

    zone False: the instruction has no zone and always stops. governing: which of data says the speed of the process.
    more: one that stands before the last of data in some versions.
    """
    points = (*kind.via, "ToPoint")
    behind = 2 if zone else 1

    ends = ("Zone", "Tool") if zone else ("Tool",)
    kinds = [data[:count] for count in range(len(data) + 1)] + ([(*data[:-1], more, data[-1])] if more else [])
    forms = [(*points, "Speed", *form, *ends) for form in kinds]

    @_PROCESSES.enter(Effect.PLANNED, name)
    def handler(run: Context, node: ProcedureCall) -> None:
        places, own, plain = _loose(run, node, forms)
        least = len(points) + 1 + behind
        if not least <= len(places) <= len(forms[-1]):
            names = ", ".join(forms[-1])
            message = f"{node.name} takes up to {len(forms[-1])} arguments ({names}), found {len(places)}"
            raise run.error(node, message)
        extra = places[len(points) + 1 : len(places) - behind]
        parts = tuple((label, run.text(value)) for label, value in zip(kinds[len(extra)], extra, strict=True))
        parts += tuple((label, "" if value is None else run.text(value)) for label, value in own.items())
        rest = places[-behind:] if zone else [places[len(points)], places[-1]]  # a zone that is not read
        if not zone:
            plain.optional.pop("inpos", None)
        request = asked(Arguments((*places[: len(points) + 1], *rest), plain.optional), via=bool(kind.via))
        if not zone:
            request = request._replace(zone=None)
        speed = None
        before = name.endswith("Start") or any(option.lower() == "on" for option in own)  # on the way to the process
        if governing is not None and len(extra) > governing and not before:
            speed = _process_speed(run, node, request.speed, extra[governing])
        to_pose(run, node, kind, request, process=Process(name, parts), speed=speed)


def _process_speed(run: Context, node: ProcedureCall, speed: Expression, data: Expression) -> Speed | None:
    """The speed while the process runs, which its data says; None: as Speed says."""
    place = _place(run, data)
    at = None if place is None else _speed_at(place.type, place.value.data)
    value = None if place is None or at is None else _at(place.value.data, at)
    if not (isinstance(value, float) and value > 0):
        what = "speed_data.main" if node.name.lower().startswith("cap") else "weld_speed"
        what = f"the {what} of {run.text(data)} is not known; the move goes at its Speed {run.text(speed)}"
        run.warn(WarningKind.ASSUMED, what, run.source(node))
        return None
    if place is not None and at is not None and len(at) == 2 and any(_at(place.value.data, at[:1])[2:4]):
        what = f"startspeed_time and startmove_delay of {run.text(data)} are not planned: the move starts at full speed"
        run.note(f"start {run.text(data)}", WarningKind.ASSUMED, what, node)
    if run.settings.override != 1:
        what = f"{run.text(data)} sets the speed of the process; VelSet and SpeedRefresh are taken not to change it"
        run.note(f"override {run.text(data)}", WarningKind.ASSUMED, what, node)
    outside = speed_of(run, speed, Arguments((), {}))
    return Speed(run.text(data), value * MM, outside.v_ori, outside.v_leax, outside.v_reax)


def set_speed(run: Context, target: Expression, value: Expression) -> bool:
    """`weld1.weld_speed:=12`, `cap1.speed_data.main:=15`: let data hold another speed; False for other parts."""
    if not isinstance(target, Component) or target.name.lower() not in ("weld_speed", "main"):
        return False
    base = target.base
    if target.name.lower() == "main":
        if not isinstance(base, Component) or base.name.lower() != "speed_data":
            return False
        base = base.base
    place = run.locate(base)
    data = _BLANK.get(place.type.name) if place.value.data is None else place.value.data
    at = _speed_at(place.type, data)
    if at is not None:
        run.store(place, base, Value(place.type, _with(data, at, run.number(value))))
    return True


def _place(run: Context, node: Expression) -> Place | None:
    base = base_of(node)
    known = isinstance(base, Name) and isinstance(run.find(base.name), Place)
    return run.locate(node) if known else None


def _speed_at(type_: Type, data: Data) -> tuple[int, ...] | None:
    """Where data holds the speed of its process [mm/s]: welddata's weld_speed, capdata's speed_data.main.

    Of a record of the program's by those names. Else it is the first number of welddata with parts of its own (IRC5),
    and the second of S4's flat one, which begins with a schedule; capdata has main fifth in its only part of six.
    """
    if isinstance(type_, Record):
        names = [component for component, _ in type_.components]
        if "weld_speed" in names:
            return (names.index("weld_speed"),)
        inner = dict(type_.components).get("speed_data")
        parts = [component for component, _ in inner.components] if isinstance(inner, Record) else []
        return (names.index("speed_data"), parts.index("main")) if "main" in parts else None
    if not isinstance(data, tuple) or len(data) < 2:
        return None
    if type_.name == "capdata":
        found = [i for i, part in enumerate(data) if isinstance(part, tuple) and len(part) == _CAP_SPEEDS]
        return (found[0], 4) if found else None
    return (0,) if any(isinstance(part, tuple) for part in data) else (1,)


_CAP_SPEEDS = 6  # capspeeddata: fly_start, start, startspeed_time, startmove_delay, main, fly_end
_BLANK: dict[str, Data] = {"welddata": (0.0, ()), "capdata": ((0.0,) * _CAP_SPEEDS, ())}  # as far as speeds go


def _at(data: Data, at: tuple[int, ...]) -> Data:
    return data if not at else _at(data[at[0]], at[1:])


def _with(data: Data, at: tuple[int, ...], value: float) -> Data:
    return value if not at else (*data[: at[0]], _with(data[at[0]], at[1:], value), *data[at[0] + 1 :])


_WELD = ("Seam", "Weld", "Weave")
_SPOT = ("Gun", "Spot")
kind: PoseKind
for name, kind in (("ArcL", MoveL), ("ArcC", MoveC)):
    for part in ("", "Start", "End", "1", "2"):
        _process(kind, f"{name}{part}", _WELD, governing=1)
for name, kind in (("SpotL", MoveL), ("SpotJ", MoveJ), ("SpotML", MoveL), ("SpotMJ", MoveJ)):
    _process(kind, name, _SPOT, zone=False)
for letter, kind in (("L", MoveL), ("C", MoveC)):
    _process(kind, f"Paint{letter}", ())
    _process(kind, f"Disp{letter}", ("Bead",))
    _process(kind, f"Cap{letter}", ("Cdata", "Weave"), governing=0, more="Weavestart")
