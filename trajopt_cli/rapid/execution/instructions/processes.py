r"""Welding, spot welding, painting, dispensing: moves that carry data of a process along.

What the process does at the point is not modelled; the move is, and the data goes with it as written. The forms differ
between versions, so optional arguments that are not known are kept rather than refused.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.motion import MoveC, MoveJ, MoveL, Process, Speed
from trajopt_cli.notices import NoticeKind
from trajopt_cli.rapid.data.datatypes import Record
from trajopt_cli.rapid.execution.arguments import Arguments, Instruction, named, present
from trajopt_cli.rapid.execution.equipment import said
from trajopt_cli.rapid.execution.instructions import pace
from trajopt_cli.rapid.execution.instructions.moves import POSE_OPTIONS, PoseKind, asked, to_pose
from trajopt_cli.rapid.language.syntax import Expression, Name, Number, ProcedureCall
from trajopt_cli.units import MM

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Run

_PLAIN = frozenset(option.lower() for option in POSE_OPTIONS)


def _loose(
    run: Run, node: ProcedureCall, names: list[tuple[str, ...]]
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


def _process(kind: PoseKind, name: str, data: tuple[str, ...], *, zone: bool = True) -> Instruction:
    """A move with process data between Speed and Zone; data names it, the last ones may be left out.

    zone False: the instruction has no zone and always stops.
    """
    via = kind is MoveC
    points = ("CirPoint", "ToPoint") if via else ("ToPoint",)
    behind = 2 if zone else 1

    ends = ("Zone", "Tool") if zone else ("Tool",)
    forms = [(*points, "Speed", *data[:count], *ends) for count in range(len(data) + 1)]

    def handler(run: Run, node: ProcedureCall) -> None:
        places, own, plain = _loose(run, node, forms)
        least = len(points) + 1 + behind
        if not least <= len(places) <= least + len(data):
            names = ", ".join(forms[-1])
            message = f"{node.name} takes up to {least + len(data)} arguments ({names}), found {len(places)}"
            raise run.error(node, message)
        extra = places[len(points) + 1 : len(places) - behind]
        told = tuple((label, run.text(value)) for label, value in zip(data, extra, strict=False))
        told += tuple((label, "" if value is None else run.text(value)) for label, value in own.items())
        rest = places[-behind:] if zone else [places[len(points)], places[-1]]  # a zone that is not read
        request = asked(Arguments((*places[: len(points) + 1], *rest), plain.optional), via=via)
        if not zone:
            request = request._replace(zone=None, args=Arguments((), _without_stop(plain.optional)))
        speed = _weld_speed(run, node, name, request.speed, extra, own) if name.startswith("Arc") else None
        to_pose(run, node, kind, request, process=Process(name, told), speed=speed)

    return handler


def _without_stop(options: dict[str, Expression | None]) -> dict[str, Expression | None]:
    return {name: value for name, value in options.items() if name != "inpos"}


def _weld_speed(
    run: Run,
    node: ProcedureCall,
    name: str,
    speed: Expression,
    extra: list[Expression],
    own: dict[str, Expression | None],
) -> Speed | None:
    r"""The speed while welding, which is the welddata's weld_speed; None on the way to the weld (ArcLStart, \On)."""
    if name.endswith("Start") or any(option.lower() == "on" for option in own) or len(extra) < 2:
        return None
    value = _first_number(run, extra[1])
    if value is None or not value > 0:
        run.warn(
            NoticeKind.ASSUMED,
            f"the weld_speed of {run.text(extra[1])} is not known; the weld is taken at its Speed {said(run, speed)}",
            run.source(node),
        )
        return None
    outside = pace.speed(run, speed, Arguments((), {}))
    return Speed(said(run, extra[1]), value * MM, outside.v_ori, outside.v_leax, outside.v_reax)


def _first_number(run: Run, node: Expression) -> float | None:
    """weld_speed [mm/s]: the component of that name, else the first of welddata with parts of its own (IRC5); the flat
    welddata of S4 begins with a schedule, and its second number is the speed."""
    place = run.find(node.name) if isinstance(node, Name) else None
    if place is None or isinstance(place, Number) or not hasattr(place, "value"):
        return None
    value = place.value
    data, type_ = value.data, value.type
    if not isinstance(data, tuple) or len(data) < 2:
        return None
    if isinstance(type_, Record):
        names = [component for component, _ in type_.components]
        found = data[names.index("weld_speed")] if "weld_speed" in names else None
    else:
        found = data[0] if any(isinstance(part, tuple) for part in data) else data[1]
    return found if isinstance(found, float) else None


_WELD = ("Seam", "Weld", "Weave")
_SPOT = ("Gun", "Spot")

INSTRUCTIONS: dict[str, Instruction] = {
    **{
        name: _process(kind, name, _WELD)
        for letter, kind in (("L", MoveL), ("C", MoveC))
        for name in (f"Arc{letter}", f"Arc{letter}Start", f"Arc{letter}End", f"Arc{letter}1", f"Arc{letter}2")
    },
    "SpotL": _process(MoveL, "SpotL", _SPOT, zone=False),
    "SpotJ": _process(MoveJ, "SpotJ", _SPOT, zone=False),
    "SpotML": _process(MoveL, "SpotML", _SPOT, zone=False),
    "SpotMJ": _process(MoveJ, "SpotMJ", _SPOT, zone=False),
    "PaintL": _process(MoveL, "PaintL", ()),
    "PaintC": _process(MoveC, "PaintC", ()),
    "DispL": _process(MoveL, "DispL", ("Bead",)),
    "DispC": _process(MoveC, "DispC", ("Bead",)),
    "CapL": _process(MoveL, "CapL", ("Cdata", "Weave")),
    "CapC": _process(MoveC, "CapC", ("Cdata", "Weave")),
}
