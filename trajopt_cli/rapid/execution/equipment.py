r"""Tools, work objects and loads of a running program: from RAPID's data to frames.

A target P is written in W = U O D: user frame, object frame, program displacement. A held tool T sits on the flange,
X_WT = U O D P. A stationary tool stands in the world and the robot brings the work object to it: U O D P is then seen
from the flange. Frames are state: a program may write them between two moves, so what is shared between motions is
found again only as long as its data is the very same.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from itertools import chain
from math import isfinite
from struct import Struct
from typing import TYPE_CHECKING

import numpy as np

from trajopt_cli.geometry import Array, readonly, wxyz_from_rotation
from trajopt_cli.motion import NO_EXTERNAL_AXES, ExternalAxes, Load, Speed, Tool, Zone
from trajopt_cli.rapid.data import frames
from trajopt_cli.rapid.data.datatypes import LOADDATA, TOOLDATA, WOBJDATA, Data, Record, Value
from trajopt_cli.rapid.data.predefined import predefined
from trajopt_cli.rapid.data.scope import Datum
from trajopt_cli.rapid.execution.evaluate import evaluate
from trajopt_cli.rapid.execution.positioners import positions, user_frame
from trajopt_cli.rapid.language.syntax import Component, Element, Expression, Name, Node
from trajopt_cli.units import MM
from trajopt_cli.warnings import WarningKind

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.instructions.motion_settings import Known
    from trajopt_cli.rapid.execution.interpreter import Execution

# How far a quaternion's length may be off: beyond is an error, a warning. Four numbers rounded to four decimals are off
# by 1e-4 at most, and 0.707 for the root of a half, as people write it, by 1.5e-4: nobody can mend more than spell it.
NORM_ERROR, NORM_WARNING = 2e-2, 2e-4
_TOLD = 20  # orientations off unit length that are told one by one
NEVER = "it was never given a value"
_ORIGIN: frames.Vector = (0.0, 0.0, 0.0)
_UPRIGHT: frames.Quaternion = (1.0, 0.0, 0.0, 0.0)
IDENTITY: frames.Frame = (_ORIGIN, _UPRIGHT)
X_IDENTITY = readonly(np.eye(4))


@dataclass(frozen=True, slots=True, eq=False)
class Setup:
    """A tool and a work object together. Frames in mm.

    name, wobj: as written. tool_data, wobj_data: what they were made from. displacement: the D that was active. tcp:
    the tool's frame, seen from the flange, or from the world where it is stationary. base: U O D, seen from the world,
    or from the flange where the tool is stationary; None for the identity. tool: shared by all motions; None for a
    stationary one, which has another X_FT for each target. X_WO: base as a pose [m], None where it moves. unit: the
    positioner that carries the work object, whose axes stand at `at` [deg] in base.
    """

    name: str
    wobj: str
    tool_data: Data
    wobj_data: Data
    displacement: frames.Frame | None
    tcp: frames.Frame
    base: frames.Frame | None
    stationary: bool
    tool: Tool | None
    X_WO: Array | None
    unit: str | None = None
    at: tuple[float, ...] = ()

    def placed(self, target: frames.Frame) -> frames.Frame:
        """A target seen from the world, or from the flange where the tool is stationary."""
        return frames.compose(self.base, target) if self.base else target

    def flange(self, target: frames.Frame) -> frames.Frame:
        """X_WF at a target."""
        placed = self.placed(target)
        if self.stationary:
            return frames.compose(self.tcp, frames.inverse(placed))
        return frames.compose(placed, frames.inverse(self.tcp))

    def target(self, flange: frames.Frame) -> frames.Frame:
        """The target that X_WF is at."""
        if self.stationary:
            placed = frames.compose(frames.inverse(flange), self.tcp)
        else:
            placed = frames.compose(flange, self.tcp)
        return frames.compose(frames.inverse(self.base), placed) if self.base else placed


class Equipment:
    """What the moves of a run share: the program displacement D, setups, speeds and zones in use by name."""

    def __init__(self) -> None:
        self.displacement: frames.Frame | None = None
        self.speeds: dict[str, tuple[Data, Speed]] = {}
        self.zones: dict[str, tuple[Data, Zone]] = {}
        self.manners: dict[tuple[str, ...], Known] = {}  # by the names of speed, zone, tool and work object
        self._setups: dict[tuple[str, str], Setup] = {}
        self._turned: dict[tuple[Setup, tuple[float, ...]], Setup] = {}
        self._rough: set[frames.Quaternion] = set()  # the orientations off unit length that were told

    def setup(self, run: Execution, tool: Expression, wobj: Expression | None, displaced: bool = True) -> Setup:
        """The setup of a move with these arguments. displaced False: as if no program displacement were active.

        Raises InputError for frames without a valid orientation, and where neither or both are held by the robot.
        """
        tool_data = data_of(run, tool, TOOLDATA, "tool", "tool0")
        wobj_data = _WOBJ0 if wobj is None else data_of(run, wobj, WOBJDATA, "work object", "wobj0")
        name = said(run, tool)
        wobj_name = "wobj0" if wobj is None else said(run, wobj)
        displacement = self.displacement if displaced else None
        known = self._setups.get((name, wobj_name))
        if (
            known is not None
            and known.tool_data is tool_data
            and known.wobj_data is wobj_data
            and known.displacement is displacement
        ):
            return self.turned(run, known, run.position.extax)
        setup = _setup(run, (name, tool_data, tool), (wobj_name, wobj_data, wobj or tool), displacement)
        self._setups[name, wobj_name] = setup
        return self.turned(run, setup, run.position.extax)

    def turned(self, run: Execution, setup: Setup, extax: ExternalAxes) -> Setup:
        """The setup with its work object where the positioner that carries it has it, external axes at extax."""
        if setup.unit is None:
            return setup
        axes = run.scenario.positioners[setup.unit]
        at = positions(run, setup.unit, extax)
        if at == setup.at:
            return setup
        key = setup, at
        if key not in self._turned:
            on_unit = frames.compose(frames.inverse(user_frame(axes, setup.at)), setup.base or IDENTITY)
            base = frames.compose(user_frame(axes, at), on_unit)
            self._turned[key] = replace(setup, base=base, X_WO=matrix(base), at=at)
        return self._turned[key]

    def current(
        self, run: Execution, node: Node, last: Setup, tool: Expression | None, wobj: Expression | None
    ) -> Setup:
        """The setup of a question about where the robot is: what is not given is that of the last move.

        node: the question, where messages point to.
        """
        if tool is None and wobj is None and last.displacement is self.displacement:
            return self.turned(run, last, run.position.extax)
        name, tool_data = last.name, last.tool_data
        if tool is not None:
            name, tool_data = said(run, tool), data_of(run, tool, TOOLDATA, "tool", "tool0")
        wobj_name, wobj_data = last.wobj, last.wobj_data
        if wobj is not None:
            wobj_name, wobj_data = said(run, wobj), data_of(run, wobj, WOBJDATA, "work object", "wobj0")
        setup = _setup(run, (name, tool_data, tool or node), (wobj_name, wobj_data, wobj or node), self.displacement)
        return self.turned(run, setup, run.position.extax)

    def orientation(
        self, run: Execution, q: frames.Quaternion, name: str, node: Node, file: str, given: bool = False
    ) -> frames.Quaternion:
        """q at length 1, said when that changes it, once per orientation.

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
        if q not in self._rough:
            if len(self._rough) < _TOLD:
                self._rough.add(q)
                place = run.places(file).source(node.start)
                run.warn(WarningKind.ASSUMED, f"{name} has an orientation of length {n:.7g}; it is normalised", place)
            else:
                run.warn(
                    WarningKind.ASSUMED,
                    f"more than {_TOLD} orientations are not unit quaternions; the others are normalised "
                    "without a message",
                )
        return frames.normalised(q)


def unoriented(run: Execution, node: Expression, value: Value) -> str:
    """What to say of a target or a pose without an orientation: [0,0,0,0] that was written, or that nobody wrote."""
    hint = NEVER if value.data == value.type.default else "give a quaternion of length 1"
    return f"{run.text(node)} has orientation [0,0,0,0], which is not a rotation; {hint}"


def said(run: Execution, node: Expression) -> str:
    """An argument as written."""
    return node.name if type(node) is Name else run.text(node)


def data_of(run: Execution, node: Expression, type_: Record, what: str, stand_in: str) -> Data:
    """The data of a tool, work object or load. One that no file declares is noted as lacking; stand_in is taken."""
    if type(node) is Name:
        place = run.find(node.name)
        if place is None:
            _undeclared(run, node, what)
            return predefined()[stand_in].data
        if type(place) is Datum and place.type is type_:
            return place.value.data
    return evaluate(run, node, type_).data


def value_of(run: Execution, node: Expression, type_: Record) -> Value:
    """As evaluate; names of data of just that type, which is nearly every argument of a move, go a shorter way."""
    if type(node) is Name:
        place = run.find(node.name)
        if type(place) is Datum and place.type is type_:
            return place.value
    return evaluate(run, node, type_)


def _undeclared(run: Execution, node: Name, what: str) -> None:
    name = node.name
    if assumed(run, name):
        run.warn(
            WarningKind.ASSUMED,
            f"{what} '{name}' is not declared in the files read; it is taken as the identity, as asked",
        )
        return
    reason = (
        f"{what} '{name}' is not declared in the files read; give the file that declares it, or take it as the "
        f"identity: --assume-identity {name}"
    )
    run.world.lack(run, "assume_identity", name, node, reason, name)


def assumed(run: Execution, name: str) -> bool:
    """Whether the user takes a tool, work object or unit as the identity."""
    run.world.asked("assume_identity", name.lower())
    return name.lower() in {known.lower() for known in run.scenario.assume_identity}


def _setup(
    run: Execution,
    tool: tuple[str, Data, Node],
    wobj: tuple[str, Data, Node],
    displacement: frames.Frame | None,
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
    orientation = run.position.equipment.orientation
    tcp = (p, orientation(run, q, f"tframe of {name}", node, run.file, True))
    written = wobj_data != WOBJDATA.default
    object_frame = (op, orientation(run, oq, f"oframe of {wobj_name}", wobj_node, run.file, written))
    carrier: str | None = None
    at: tuple[float, ...] = ()
    if fixed:
        frame_of_user = (up, orientation(run, uq, f"uframe of {wobj_name}", wobj_node, run.file, written))
    elif (known := run.scenario.positioners.get(str(unit).lower())) is not None:
        carrier = str(unit).lower()
        at = positions(run, carrier, NO_EXTERNAL_AXES)
        frame_of_user = user_frame(known, at)
    else:
        if run.units.moves_by_itself(str(unit)):
            assumed(run, str(unit))  # which helps nothing: every move on it is refused
        else:
            _unit(run, wobj_name, str(unit), wobj_node)
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


def _unit(run: Execution, wobj: str, unit: str, node: Node) -> None:
    """A user frame that a mechanical unit carries: only the user can say where it is."""
    name = unit or wobj
    if any([assumed(run, unit), assumed(run, wobj)]):  # both are asked for
        run.warn(
            WarningKind.ASSUMED,
            f"work object {wobj} rides on the unit '{unit}' (ufprog FALSE), whose frame is not in the program; its "
            "user frame is taken as the identity, as asked",
        )
        return
    reason = (
        f"work object {wobj} rides on the unit '{unit}' (ufprog FALSE), whose frame is not in the program; describe it "
        f"under positioners in the cell file, or take the unit's frame as the identity: --assume-identity {name}"
    )
    run.world.lack(run, "assume_identity", name, node, reason, name)


def matrix(frame: frames.Frame) -> Array:
    """A frame [mm] as a pose [m], read-only."""
    (x, y, z), (w, i, j, k) = frame
    # One packing of sixteen numbers: half the time of an array from rows, and nobody can write to it.
    return np.frombuffer(
        _pack(
            *(1 - 2 * (j * j + k * k), 2 * (i * j - w * k), 2 * (i * k + w * j), x * MM),
            *(2 * (i * j + w * k), 1 - 2 * (i * i + k * k), 2 * (j * k - w * i), y * MM),
            *(2 * (i * k - w * j), 2 * (j * k + w * i), 1 - 2 * (i * i + j * j), z * MM),
            *(0.0, 0.0, 0.0, 1.0),
        )
    ).reshape(4, 4)


_pack = Struct("16d").pack


def matrices(given: Iterable[frames.Frame], count: int) -> Array:
    """So many frames [mm] as poses [m] (count, 4, 4), read-only: as matrix, in a tenth of its time."""
    numbers = chain.from_iterable(chain.from_iterable(given))
    x, y, z, w, i, j, k = np.fromiter(numbers, float, 7 * count).reshape(count, 7).T
    X = np.zeros((count, 4, 4))
    X[:, 0] = np.stack((1 - 2 * (j * j + k * k), 2 * (i * j - w * k), 2 * (i * k + w * j), x * MM), axis=1)
    X[:, 1] = np.stack((2 * (i * j + w * k), 1 - 2 * (i * i + k * k), 2 * (j * k - w * i), y * MM), axis=1)
    X[:, 2] = np.stack((2 * (i * k - w * j), 2 * (j * k + w * i), 1 - 2 * (i * i + j * j), z * MM), axis=1)
    X[:, 3, 3] = 1.0
    X.flags.writeable = False
    return X


def frame(X: Array) -> frames.Frame:
    """A pose [m] as a frame [mm]."""
    x, y, z = (float(value) / MM for value in X[:3, 3])
    w, i, j, k = (float(value) for value in wxyz_from_rotation(X[:3, :3]))
    return (x, y, z), (w, i, j, k)


def load(run: Execution, node: Expression) -> Load | None:
    """A load in SI units, None for no load (load0)."""
    data = data_of(run, node, LOADDATA, "load", "load0")
    if data == predefined()["load0"].data:
        return None
    mass, (x, y, z), aom, *inertia = data
    name = said(run, node)
    if not (isfinite(mass) and mass >= 0):
        raise run.error(node, f"load {name} has a mass of {mass:.6g} kg; it must not be negative")
    ix, iy, iz = inertia
    axes = run.position.equipment.orientation(run, aom, f"aom of {name}", node, run.file, data != LOADDATA.default)
    return Load(name, mass, (x * MM, y * MM, z * MM), axes, (ix, iy, iz))


_NO_MASS = 1e-3  # kg: predefined tool0 has as much, for controllers want a mass above zero
_WOBJ0: Data = predefined()["wobj0"].data
