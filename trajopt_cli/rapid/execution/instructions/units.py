"""Mechanical units: which are active, what turns on its own, and work objects that a conveyor or another robot moves.

ActUnit and DeactUnit take effect when every axis stands, so the point before them is a stop (RAPID reference manual).
"""

from __future__ import annotations

from typing import Any

from trajopt_cli.rapid.data.datatypes import WOBJDATA
from trajopt_cli.rapid.execution.arguments import Effect, Topic
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.equipment import data_of, load
from trajopt_cli.rapid.execution.instructions.waits import TIMEOUT, record, wait_for
from trajopt_cli.rapid.language.syntax import Expression, Name, ProcedureCall
from trajopt_cli.warnings import WarningKind

_MOVING = "moving work objects"
_APART = "plan the motions between such moves on their own (--entry)"
_UNITS = Topic("Mechanical units", load=load)


@_UNITS.instruction(Effect.WAITS, "ActUnit MechUnit:unit", "DeactUnit MechUnit:unit")
def _switch(run: Context, node: ProcedureCall, unit: str) -> None:
    on = node.name.lower() == "actunit"
    record(run, node, 0.0, in_position=True)
    if unit.lower() in run.units.axes:
        _activate(run, node, unit.lower(), on)
    elif on and run.units.moves_by_itself(unit):
        run.refuse(_MOVING, node, f"{node.name} {unit} is for work objects that move by themselves; {_APART}")
    elif not on and run.units.rail_unnamed:
        what = f"is {unit} the rail? The cell file gives the rail's unit no name: write 'rail: {{unit: {unit}}}', "
        run.refuse("mechanical units", node, f"{what}or the rail's own name there if {unit} is another unit")
    else:
        run.ignored[node.name] += 1
        message = f"{node.name} {unit} changes nothing here: no cell file has such a unit"
        run.note(f"unit {unit}", WarningKind.NO_EFFECT, run.meant(unit, message, run.units.axes), node)


def _activate(run: Context, node: ProcedureCall, unit: str, on: bool) -> None:
    """Activate a unit of the cell, or deactivate it. Raises InputError for two on one axis."""
    units = run.units
    if run.scenario.active_units is None:
        parts = {"active": sorted(units.active), "not active": sorted(units.axes.keys() - units.active)}
        assumed = "; ".join(f"{what}: {', '.join(names)}" for what, names in parts.items() if names)
        text = f"mechanical units taken at the start as {assumed}; 'start: {{units: [...]}}' in the cell"
        run.note("units at the start", WarningKind.ASSUMED, f"{text} file lists the active ones", node)
    if on == (unit in units.active):
        return
    if on and (found := units.conflict(unit)) is not None:
        other, eax = found
        text = f"{unit} and {other} share eax_{'abcdef'[eax]}, and {other} is active; write DeactUnit {other} before it"
        raise run.error(node, text)
    run.position.extax = units.switch(unit, on, run.position.extax, len(run.motions))


# ------------------------------------------------------------------------------------------------- independent axes


_WAYS = r"\ToAbsPos \ToAbsNum \ToRelPos \ToRelNum \Short \Fwd \Bwd \Ramp"


@_UNITS.instruction(
    Effect.REFUSED,
    f"IndAMove MecUnit:unit Axis:num Speed {_WAYS}",
    f"IndCMove MecUnit:unit Axis:num Speed {_WAYS}",
    f"IndDMove MecUnit:unit Axis:num Delta Speed {_WAYS}",
    f"IndRMove MecUnit:unit Axis:num Speed {_WAYS}",
)
def _alone(run: Context, node: ProcedureCall, name: str, axis: float, *_: Expression, **__: bool) -> None:
    """An axis turns on its own, beside the program."""
    what = f"{node.name} makes axis {axis:g} of {name} an independent axis"
    run.units.moving.add(name.lower())
    if name.lower() in run.units.axes or run.units.rail_unnamed:
        advice = "no plan knows where it is; use MoveExtJ, or leave it out"
        if name.lower() not in run.units.axes:
            advice = f"{name} may be the rail: name the rail's unit in the cell file ('rail: {{unit: ...}}')"
        run.refuse("independent axes", node, f"{what}, beside the program; {advice}")
    else:
        run.ignored[node.name] += 1
        text = f"{what}; the cell file has no such axis, so it is not planned"
        run.note(f"alone {name}", WarningKind.NO_EFFECT, text, node)


# The load of a positioner's axis changes nothing: the axis keeps the limits of the cell file with any load.
@_UNITS.instruction(
    Effect.IGNORED,
    r"IndReset MecUnit:unit Axis:num \RefPos \RefNum \Short \Fwd \Bwd \Old",
    "MechUnitLoad MechUnit:unit AxisNo:num Load:load",
)
def _without_effect(run: Context, node: ProcedureCall, *_: object, **__: bool) -> None:
    """The arguments are held against their types, and that is all."""


@_UNITS.enter(Effect.IGNORED, "LoadId")
def _identify(run: Context, node: ProcedureCall) -> None:
    text = f"{node.name} moves the arm by itself to identify a load; that motion is not planned"
    run.note(node.name, WarningKind.NOT_CHECKED, text, node)


# ------------------------------------------------------------------------------- work objects that move by themselves


@_UNITS.instruction(
    Effect.REFUSED,
    rf"WaitWObj WObj \RelDist \PosStop {TIMEOUT}",
    rf"DropWObj WObj {TIMEOUT}",
    rf"WaitSensor MechUnit \RelDist \PredTime {TIMEOUT}",
    rf"DropSensor MechUnit {TIMEOUT}",
    rf"SyncToSensor MechUnit \MaxSync \On \Off {TIMEOUT}",
)
def _belt(run: Context, node: ProcedureCall, what: Expression, **options: Any) -> None:
    """An instruction about a work object that follows a conveyor or a sensor: no plan knows where that is, or when."""
    if not node.name.lower().endswith("wobj"):
        moved = run.unit(what)
    elif isinstance(what, Name) and run.find(what.name) is None:
        moved = ""
    else:
        moved = str(data_of(run, what, WOBJDATA)[2])
    if moved:
        run.units.moving.add(moved.lower())
        run.external.missing.pop(("assume_identity", moved.lower()), None)
    shown = run.text(what)
    text = f"{node.name} {shown} is for work that {moved or 'a unit'} moves, and the program does not say how fast"
    run.refuse(_MOVING, node, f"{text}; {_APART}")
    if node.name.lower().startswith("wait"):
        wait_for(run, node, f"{node.name} {shown}", shown, **options)
