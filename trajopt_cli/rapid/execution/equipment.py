r"""Tools, work objects and loads of a running program: from RAPID's data to frames.

A target P is written in W = U O D: user frame, object frame, program displacement. A held tool T sits on the flange,
X_WT = U O D P. A stationary tool stands in the world and the robot brings the work object to it: U O D P is then seen
from the flange. Frames are state: a program may write them between two moves, so what is shared between motions is
found again only as long as its data is the very same.
"""

from __future__ import annotations

from dataclasses import replace
from math import isfinite

from trajopt_cli.motion import NO_EXTERNAL_AXES, ExternalAxes, Load, Tool
from trajopt_cli.rapid.data import frames
from trajopt_cli.rapid.data.datatypes import LOADDATA, TOOLDATA, WOBJDATA, Data, Record, Value
from trajopt_cli.rapid.data.frames import IDENTITY, X_IDENTITY, matrix
from trajopt_cli.rapid.data.predefined import predefined
from trajopt_cli.rapid.data.scope import Datum
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.position import Setup
from trajopt_cli.rapid.execution.positioners import user_frame
from trajopt_cli.rapid.language.syntax import Component, Element, Expression, Name, Node
from trajopt_cli.units import MM
from trajopt_cli.warnings import WarningKind

# How far a quaternion's length may be off: beyond is an error, a warning. Four numbers rounded to four decimals are off
# by 1e-4 at most, and 0.707 for the root of a half, as people write it, by 1.5e-4: nobody can mend more than spell it.
NORM_ERROR, NORM_WARNING = 2e-2, 2e-4
_MOST = 20  # orientations off unit length that are reported one by one
NEVER = "it was never given a value"


def setup_of(run: Context, tool: Expression, wobj: Expression | None, displaced: bool = True) -> Setup:
    """The setup of a move with these arguments. displaced False: as if no program displacement were active.

    Raises InputError for frames without a valid orientation, and where neither or both are held by the robot.
    """
    tool_data = data_of(run, tool, TOOLDATA)
    wobj_data = _WOBJ0 if wobj is None else data_of(run, wobj, WOBJDATA)
    name = run.text(tool)
    wobj_name = "wobj0" if wobj is None else run.text(wobj)
    displacement = run.position.displacement if displaced else None
    known = run.position.setups.get((name, wobj_name))
    if (
        known is not None
        and known.tool_data is tool_data
        and known.wobj_data is wobj_data
        and known.displacement is displacement
    ):
        return turned(run, known, run.position.extax)
    setup = _setup(run, (name, tool_data, tool), (wobj_name, wobj_data, wobj or tool), displacement)
    run.position.setups[name, wobj_name] = setup
    return turned(run, setup, run.position.extax)


def turned(run: Context, setup: Setup, extax: ExternalAxes) -> Setup:
    """The setup with its work object where the positioner that carries it has it, external axes at extax."""
    if setup.unit is None:
        return setup
    axes = run.scenario.positioners[setup.unit]
    at = run.units.positions(setup.unit, extax)
    if at == setup.at:
        return setup
    key = setup, at
    if key not in run.position.turned:
        on_unit = frames.compose(frames.inverse(user_frame(axes, setup.at)), setup.base or IDENTITY)
        base = frames.compose(user_frame(axes, at), on_unit)
        run.position.turned[key] = replace(setup, base=base, X_WO=matrix(base), at=at)
    return run.position.turned[key]


def current_setup(run: Context, node: Node, last: Setup, tool: Expression | None, wobj: Expression | None) -> Setup:
    """The setup of a question about where the robot is: what is not given is that of the last move.

    node: the question, where messages point to.
    """
    if tool is None and wobj is None and last.displacement is run.position.displacement:
        return turned(run, last, run.position.extax)
    name, tool_data = last.name, last.tool_data
    if tool is not None:
        name, tool_data = run.text(tool), data_of(run, tool, TOOLDATA)
    wobj_name, wobj_data = last.wobj, last.wobj_data
    if wobj is not None:
        wobj_name, wobj_data = run.text(wobj), data_of(run, wobj, WOBJDATA)
    setup = _setup(
        run, (name, tool_data, tool or node), (wobj_name, wobj_data, wobj or node), run.position.displacement
    )
    return turned(run, setup, run.position.extax)


def orientation(
    run: Context, q: frames.Quaternion, name: str, node: Node, file: str, given: bool = False
) -> frames.Quaternion:
    """q at length 1, reported when that changes it, once per orientation.

    name, node, file: whose orientation, and where it is written. given: whether data that it belongs to was given
    a value, so that zeros are not what nobody wrote.
    """
    n = frames.norm(q)
    off = abs(n - 1.0)
    if off <= NORM_WARNING:
        return (q[0] / n, q[1] / n, q[2] / n, q[3] / n)
    if not off <= NORM_ERROR:
        shown = ",".join(f"{value:.7g}" for value in q)
        never = n == 0 and not given and isinstance(node, (Name, Element, Component))
        hint = NEVER if never else "give a quaternion of length 1"
        message = f"{name} has orientation [{shown}] of length {n:.6g}, limit 1 +- {NORM_ERROR:g}; {hint}"
        raise run.places(file).error(node.start, message)
    if q not in run.position.rough:
        if len(run.position.rough) < _MOST:
            run.position.rough.add(q)
            place = run.places(file).source(node.start)
            run.warn(WarningKind.ASSUMED, f"{name} has an orientation of length {n:.7g}; it is normalised", place)
        else:
            run.warn(
                WarningKind.ASSUMED,
                f"more than {_MOST} orientations are not unit quaternions; the others are normalised without a message",
            )
    return frames.normalised(q)


def unoriented(run: Context, node: Expression, value: Value) -> str:
    """What to say of a target or a pose without an orientation: [0,0,0,0] that was written, or that nobody wrote."""
    hint = NEVER if value.data == value.type.default else "give a quaternion of length 1"
    return f"{run.text(node)} has orientation [0,0,0,0], which is not a rotation; {hint}"


_EQUIPMENT = {"tooldata": ("tool", "tool0"), "wobjdata": ("work object", "wobj0"), "loaddata": ("load", "load0")}


def data_of(run: Context, node: Expression, type_: Record) -> Data:
    """The data of a tool, work object or load; of one that no file declares, which is noted as lacking, ABB's own."""
    if type(node) is Name:
        place = run.find(node.name)
        if place is None:
            what, stand_in = _EQUIPMENT[type_.name]
            why = f"{what} '{node.name}' is not declared in the files read"
            _ask_identity(run, node, (node.name,), why, "it", "give the file that declares it, or take it")
            return predefined()[stand_in].data
        if type(place) is Datum and place.type is type_:
            return place.value.data
    return run.evaluate(node, type_).data


def value_of(run: Context, node: Expression, type_: Record) -> Value:
    """As evaluate; names of data of just that type, which is nearly every argument of a move, go a shorter way."""
    if type(node) is Name:
        place = run.find(node.name)
        if type(place) is Datum and place.type is type_:
            return place.value
    return run.evaluate(node, type_)


def _ask_identity(run: Context, node: Node, names: tuple[str, ...], why: str, taken: str, remedy: str) -> None:
    """Take the frame of what the program does not tell as the identity, where the user wants that; else it lacks.

    names: any of them says so. why: the program does not tell it.
    """
    if any([assumed(run, name) for name in names]):  # all are asked for
        run.warn(WarningKind.ASSUMED, f"{why}; {taken} is taken as the identity, as asked")
        return
    name = names[0] or names[-1]
    run.missing("assume_identity", name, node, f"{why}; {remedy} as the identity: --assume-identity {name}", name)


def assumed(run: Context, name: str) -> bool:
    """Whether the user takes a tool, work object or unit as the identity."""
    run.external.asked("assume_identity", name.lower())
    return name.lower() in {known.lower() for known in run.scenario.assume_identity}


def _setup(
    run: Context, tool: tuple[str, Data, Node], wobj: tuple[str, Data, Node], displacement: frames.Frame | None
) -> Setup:
    name, tool_data, node = tool
    wobj_name, wobj_data, wobj_node = wobj
    held, (p, q), _ = tool_data
    if tool_data == TOOLDATA.default:
        raise run.error(node, f"tool {name} was never given a value: robhold FALSE, tframe all zero")
    _, fixed, unit, (up, uq), (op, oq) = wobj_data
    if held == wobj_data[0]:
        both = "are both held by the robot" if held else "both stand still: the robot holds neither"
        value = "TRUE" if held else "FALSE"
        raise run.error(node, f"tool {name} and work object {wobj_name} {both} (robhold {value}); change one")
    tcp = (p, orientation(run, q, f"tframe of {name}", node, run.file, True))
    written = wobj_data != WOBJDATA.default
    object_frame = (op, orientation(run, oq, f"oframe of {wobj_name}", wobj_node, run.file, written))
    carrier: str | None = None
    at: tuple[float, ...] = ()
    if fixed:
        frame_of_user = (up, orientation(run, uq, f"uframe of {wobj_name}", wobj_node, run.file, written))
    elif (known := run.scenario.positioners.get(str(unit).lower())) is not None:
        carrier = str(unit).lower()
        at = run.units.positions(carrier, NO_EXTERNAL_AXES)
        frame_of_user = user_frame(known, at)
    else:
        if run.units.moves_by_itself(str(unit)):
            assumed(run, str(unit))  # which helps nothing: every move on it is refused
        else:
            why = (
                f"work object {wobj_name} rides on the unit '{unit}' (ufprog FALSE), whose frame is not in the program"
            )
            remedy = "describe it under positioners in the cell file, or take the unit's frame"
            _ask_identity(run, wobj_node, (str(unit), wobj_name), why, "its user frame", remedy)
        frame_of_user = IDENTITY
    base: frames.Frame | None = frames.compose(frame_of_user, object_frame)
    if displacement is not None:
        assert base is not None
        base = frames.compose(base, displacement)
    if base == IDENTITY:
        base = None
    return Setup(
        name=name,
        wobj=wobj_name,
        tool_data=tool_data,
        wobj_data=wobj_data,
        displacement=displacement,
        tcp=tcp,
        base=base,
        stationary=not held,
        tool=Tool(name, matrix(tcp), load=_tool_load(name, tool_data)) if held else None,
        X_WO=None if not held else matrix(base) if base else X_IDENTITY,
        unit=carrier,
        at=at,
    )


def _tool_load(name: str, data: Data) -> Load | None:
    """What a tool weighs; None for no mass, for -1, as ABB marks one that is not known, and for tool0's gram."""
    mass, (x, y, z), aom, ix, iy, iz = data[2]
    return Load(name, mass, (x * MM, y * MM, z * MM), tuple(aom), (ix, iy, iz)) if mass > _NO_MASS else None


def load(run: Context, node: Expression) -> Load | None:
    """A load in SI units, None for no load (load0)."""
    data = data_of(run, node, LOADDATA)
    if data == predefined()["load0"].data:
        return None
    mass, (x, y, z), aom, *inertia = data
    name = run.text(node)
    if not (isfinite(mass) and mass >= 0):
        raise run.error(node, f"load {name} has a mass of {mass:.6g} kg; it must not be negative")
    ix, iy, iz = inertia
    axes = orientation(run, aom, f"aom of {name}", node, run.file, data != LOADDATA.default)
    return Load(name, mass, (x * MM, y * MM, z * MM), axes, (ix, iy, iz))


_NO_MASS = 1e-3  # kg: predefined tool0 has as much, for controllers want a mass above zero
_WOBJ0: Data = predefined()["wobj0"].data
