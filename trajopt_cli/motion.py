"""What a robot program asks for, as flat data: moves, waits and signals in program order, each with its place.

SI units. Frames: W world, F flange (tool0), T tool centre point, O work object; X_AB is frame B seen from A, (4, 4).
Floor 1: no project imports but geometry and warnings.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import Enum
from math import inf
from typing import ClassVar, NamedTuple

from trajopt_cli.geometry import Array, readonly
from trajopt_cli.warnings import ProgramWarning
from trajopt_cli.warnings import Source as Source


class Span(NamedTuple):
    """A stretch of one file's decoded text, [start, end) in characters."""

    file: str
    start: int
    end: int


class Written(NamedTuple):
    """Where an instruction's parts stand in the text, so that an export can edit them in place.

    statement reaches from the instruction's name to its semicolon. target: the argument in the statement; of a wait in
    a function both are the call. counters: the values of the FOR loops around the statement in its routine, the
    outermost first.
    """

    statement: Span
    target: Span | None = None
    counters: tuple[float, ...] = ()


@dataclass(frozen=True)
class Speed:
    """Programmed caps: TCP speed [m/s], reorientation [rad/s], linear [m/s] and rotary [rad/s] external axes; 0 for
    what stands still during the move."""

    name: str
    v_tcp: float
    v_ori: float
    v_leax: float
    v_reax: float

    @property
    def turning(self) -> float:
        """The cap on the reorientation [rad/s], infinite where the tool has the same orientation at both ends."""
        return self.v_ori or inf


@dataclass(frozen=True)
class Zone:
    r"""Programmed accuracy: a stop point, or a fly-by of radius [m] around the target.

    The extended zone, for reorientation and external axes: path_ori, path_eax, leax [m], ori, reax [rad]; the smallest
    share counts. criterion: the stoppointdata of \Inpos, None for an ordinary stop.
    """

    name: str
    stop: bool
    radius: float = 0.0
    path_ori: float = 0.0
    path_eax: float = 0.0
    ori: float = 0.0
    leax: float = 0.0
    reax: float = 0.0
    criterion: str | None = None


class FlyBy(NamedTuple):
    """The corner that is driven at a fly-by point: how far from the point [m], along the ways before and after it, the
    position, the orientation and the external axes are rounded; radius is the least of them.

    in_place: both ways turn the tool about its centre point, and all three are angles [rad]. joint: the axes go over
    from one way to the other in joint interpolation, as the coordinate system changes.
    """

    radius: float
    turning: float
    external: float
    in_place: bool = False
    joint: bool = False


class FreeTurn(NamedTuple):
    """The tool may be turned about an axis of its own, axis (3,), a unit vector: by low to high [rad] from as it was
    taught, low <= 0 <= high."""

    axis: tuple[float, float, float]
    low: float
    high: float


@dataclass(frozen=True)
class Load:
    """mass [kg], cog: centre of gravity [m], aom: its axes of moment (w, x, y, z) as written, inertia about them
    [kg m2]; in the flange's frame where it is a tool's own (tload), in the tool's where the gripper holds it."""

    name: str
    mass: float
    cog: tuple[float, float, float]
    aom: tuple[float, float, float, float]
    inertia: tuple[float, float, float]


@dataclass(frozen=True, eq=False)
class Tool:
    """A tool by name; X_FT is its centre point in the flange frame.

    stationary: it stands in the world and the robot holds the work object; X_FT is then where the target, which is
    brought to the tool, sits on the flange, so X_WF = X_WT inv(X_FT) holds for both.
    load: what the robot carries of it (tload), None where the data say no mass.
    """

    name: str
    X_FT: Array
    stationary: bool = False
    load: Load | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "X_FT", readonly(self.X_FT))


@dataclass(frozen=True)
class ConfData:
    """RAPID confdata: quadrants of axes 1, 4 and 6 and the branch number cfx (0..7), of an arm with a parallel linkage
    the quadrant of axis 2."""

    cf1: int
    cf4: int
    cf6: int
    cfx: int

    @property
    def numbers(self) -> tuple[int, int, int, int]:
        """All four, as RAPID writes them."""
        return self.cf1, self.cf4, self.cf6, self.cfx


# External axes eax_a..eax_f as RAPID states them, in mm or degrees (only the cell knows which); None for 9E9.
ExternalAxes = tuple[float | None, ...]
NO_EXTERNAL_AXES: ExternalAxes = (None, None, None, None, None, None)


class Singularity(Enum):
    """What a line does near a singularity (SingArea)."""

    OFF = "Off"
    WRIST = "Wrist"
    LOCK_AXIS_4 = "LockAxis4"


class CirPathMode(Enum):
    r"""How a MoveC turns the tool (CirPathMode).

    PATH_FRAME: evenly against the frame of the circle (tangent, normal), so that a tool that leans inwards at both ends
    does so all the way; of the two ways to turn the one on which the circle point's orientation lies. OBJECT_FRAME:
    evenly against the work object, as on a line. CIR_POINT_ORI: through the orientation of the circle point. WRIST_xy:
    with two wrist axes alone, for cutting.
    """

    PATH_FRAME = "PathFrame"
    OBJECT_FRAME = "ObjectFrame"
    CIR_POINT_ORI = "CirPointOri"
    WRIST_45 = "Wrist45"
    WRIST_46 = "Wrist46"
    WRIST_56 = "Wrist56"

    @property
    def wrist_alone(self) -> bool:
        """Whether two wrist axes turn the tool, which no plan does."""
        return self.value.startswith("Wrist")


@dataclass(frozen=True)
class Settings:
    r"""Modal state of a program, as it stands when a move is programmed.

    conf_j, conf_l: joint moves and lines must end in the programmed configuration (ConfJ, ConfL \On). acceleration,
    ramp: shares of what is possible (AccSet). path_acceleration, path_deceleration: caps [m/s2] on the TCP's speeding
    up and slowing down along its path, world_acceleration on its whole acceleration, None for none. override, v_max
    [m/s]: VelSet, already in every Speed. load: what the gripper holds (GripLoad), None for nothing. eax_offset: what
    EOffs adds to the external axes, already in every extax; mm or deg. displaced: whether a program displacement
    (PDisp) is active; it is already in every X_WT. circle: how arcs turn the tool (CirPathMode). synchronised: whether
    moves go together with other robots' (SyncMoveOn).
    """

    conf_j: bool = True
    conf_l: bool = True
    singularity: Singularity = Singularity.OFF
    acceleration: float = 1.0
    ramp: float = 1.0
    path_acceleration: float | None = None
    path_deceleration: float | None = None
    world_acceleration: float | None = None
    override: float = 1.0
    v_max: float | None = None
    load: Load | None = None
    eax_offset: tuple[float, float, float, float, float, float] = (0.0,) * 6
    displaced: bool = False
    circle: CirPathMode = CirPathMode.PATH_FRAME
    synchronised: bool = False


DEFAULT_SETTINGS = Settings()


class Hold(Enum):
    """Who says that the rail stands still during a motion: a comment, the cell file, an output set just before, nobody,
    as it does in every wait that the cell file does not free, the program, whose instructions have deactivated its
    unit, SyncMoveOn, behind which no wait has room for a move, or the controller, as it waits for all axes to settle at
    a stop."""

    PROGRAM = "program"
    CELL = "cell"
    GRIPPER = "gripper"
    WAIT = "wait"
    UNIT = "unit"
    SYNCHRONISED = "synchronised"
    SETTLING = "settling"


class Happens(Enum):
    """What a path event is."""

    SIGNAL = "signal"
    INTERRUPT = "interrupt"
    PROCEDURE = "procedure"


@dataclass(frozen=True)
class PathEvent:
    """Something that happens on the way (TriggL, MoveLDO, MoveLSync), without a stop.

    name: of the signal (lower case), interrupt or procedure; value: what the signal is set to. distance [m] along the
    path: before the end, or behind the start if from_start; time [s] before the end (or behind the start) where the
    trigger is given in time, or the lag that is compensated.
    """

    kind: Happens
    name: str
    value: float | None = None
    distance: float = 0.0
    time: float = 0.0
    from_start: bool = False


@dataclass(frozen=True)
class Process:
    """A move that is written as another instruction: its name as in the manual, and its own data as written.

    ArcL p1, v100, seam1, weld1, z1, tool: Process("ArcL", (("Seam", "seam1"), ("Weld", "weld1"))).
    """

    instruction: str
    data: tuple[tuple[str, str], ...] = ()


SLIDE = "_slide"
"""Ends the names of positioners' axes that slide, in m; of all others but the rail they are in rad."""


class UnitMove(NamedTuple):
    """A positioner's axis that turns while a move goes on: mechanical unit and external axis (0 for eax_a), from and to
    where [rad], the least time it takes [s] from rest to rest. carries: whether the move's work object rides on it.

    velocity [rad/s], acceleration [rad/s2]: what it may do, the programmed speed counted. p [m], u (a unit vector): the
    line in the world about which it turns, or along which it slides, where that lies when the move begins. shared:
    another unit has the same external axis. slides: lengths are in m where they are in rad of others.
    """

    unit: str
    eax: int
    start: float
    end: float
    least: float
    carries: bool
    velocity: float
    acceleration: float
    p: tuple[float, float, float]
    u: tuple[float, float, float]
    shared: bool = False
    slides: bool = False

    @property
    def angle(self) -> float:
        """How far it turns [rad]."""
        return self.end - self.start

    @property
    def column(self) -> str:
        """Its name in rows of axes: "eax_b", "eax_b_stn1" where it shares that axis, "eax_b_slide" where it slides."""
        return f"eax_{'abcdef'[self.eax]}{f'_{self.unit}' if self.shared else ''}{SLIDE if self.slides else ''}"


@dataclass(frozen=True, eq=False, kw_only=True)
class _Move:
    r"""What every move has.

    target: as written. extax: as the controller drives them, offsets included. duration: the programmed \T in s.
    optional: it may be dropped. settings: the modal state. events: what happens on the way. process: the instruction
    where it is none of the four plain moves. hold: why the rail must stand still from this move's start to its end,
    None where it may move. constant_speed: a line or an arc that should keep its programmed speed from end to end.
    units: positioners that turn meanwhile. detour: of a point that the plan adds on a way around bodies, their names.
    marked: the same of one that an export has added, as its comment says; it is a point of the program like any other.
    beside [s]: how long waits last that run beside it (\Conc), where the move from stop to stop may be shorter.
    identity: the \ID under which other robots move together with it (MultiMove), None for a move of this robot alone.
    partner: what those take for it at least [s], None where nothing says it; as_written: it is what this robot takes.
    """

    source: Source
    written: Written
    target: str
    speed: Speed
    zone: Zone
    extax: ExternalAxes
    duration: float | None = None
    optional: bool = False
    settings: Settings = DEFAULT_SETTINGS
    events: tuple[PathEvent, ...] = ()
    process: Process | None = None
    hold: Hold | None = None
    constant_speed: bool = False
    units: tuple[UnitMove, ...] = ()
    detour: tuple[str, ...] = ()
    marked: tuple[str, ...] = ()
    beside: float = 0.0
    identity: int | None = None
    partner: float | None = None
    as_written: bool = False

    @property
    def least(self) -> float:
        """Least time [s] that positioners, waits beside it and other robots leave the move."""
        return max([self.beside, self.partner or 0.0, *(unit.least for unit in self.units)])

    @property
    def works(self) -> bool:
        """Whether a tool works where it ends (SpotL): every axis stands there, however short that is."""
        return self.process is not None and self.process.instruction.startswith("Spot")

    @property
    def searches(self) -> bool:
        """Whether it ends where a signal comes (SearchL), which nobody knows before."""
        return self.process is not None and self.process.instruction.startswith("Search")

    @property
    def waits_for(self) -> str:
        """Whose time is the least one."""
        if self.partner is not None and self.partner >= self.least:
            return "time as written" if self.as_written else "partner"
        return "wait beside it" if self.beside and self.beside >= self.least else "positioner"


@dataclass(frozen=True, eq=False, kw_only=True)
class PoseMove(_Move):
    """To a pose of the tool: MoveJ, MoveL, MoveC and what else is written so.

    X_WO: the frame in which the target is written, program displacement included, so X_WT = X_WO X_OT; shared by
    the motions that have the same one. None where there is none (a work object that the robot holds). via: names of the
    arguments before ToPoint. free: how the tool may be turned, at its end and on a line or an arc on its way to it;
    None where it may not. turn [rad]: how far it is turned already from as taught, in X_WT."""

    via: ClassVar[tuple[str, ...]] = ()

    X_WT: Array
    conf: ConfData
    tool: Tool
    wobj: str = "wobj0"
    X_WO: Array | None = None
    free: FreeTurn | None = None
    turn: float = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "X_WT", readonly(self.X_WT))
        if self.X_WO is not None and self.X_WO.flags.writeable:  # a copy for each motion would be most of its memory
            object.__setattr__(self, "X_WO", readonly(self.X_WO))


@dataclass(frozen=True, eq=False, kw_only=True)
class MoveJ(PoseMove):
    """To the pose X_WT, axes free on the way."""


@dataclass(frozen=True, eq=False, kw_only=True)
class PathMove(PoseMove):
    """To a pose on a path of the tool that the instruction gives: the axes follow."""


@dataclass(frozen=True, eq=False, kw_only=True)
class MoveL(PathMove):
    """To the pose X_WT, the TCP on a straight line, orientation by slerp."""


@dataclass(frozen=True, eq=False, kw_only=True)
class MoveC(PathMove):
    """To the pose X_WT on the arc through X_WV's position; how the tool turns, settings.circle says."""

    via: ClassVar[tuple[str, ...]] = ("CirPoint",)

    X_WV: Array

    def __post_init__(self) -> None:
        super().__post_init__()
        object.__setattr__(self, "X_WV", readonly(self.X_WV))


@dataclass(frozen=True, eq=False, kw_only=True)
class MoveAbsJ(_Move):
    r"""To arm joints q (6,) in rad, axes free on the way. wobj: named by \WObj, without effect on the joints."""

    q: Array
    tool: Tool
    wobj: str | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "q", readonly(self.q))


@dataclass(frozen=True, eq=False, kw_only=True)
class MoveExtJ(_Move):
    """External axes alone; the arm's joints hold."""


@dataclass(frozen=True, kw_only=True)
class Wait:
    r"""Standing still. duration [s]: exact when condition is None; else the least time until the condition holds.

    in_position: the robot comes to rest first, however short the wait is (\InPos, \ZeroSpeed). hold: why the rail must
    stand still as well, None where it may move. beside [s]: the programmed time of a wait that runs beside the move
    before it (\Conc), None where it begins behind it; duration is then what is left of it, once the program is read.
    """

    source: Source
    written: Written
    duration: float
    condition: str | None = None
    in_position: bool = False
    hold: Hold | None = None
    beside: float | None = None

    @property
    def settles(self) -> bool:
        """Whether no statement stands for it: the axes settle at the stop before it, see scenario.Settling."""
        return self.hold is Hold.SETTLING

    @property
    def stops(self) -> bool:
        """Whether the point before it is a stop; a wait of no time without a condition is none."""
        return self.duration > 0 or self.in_position or self.ends_at_rest

    @property
    def ends_at_rest(self) -> bool:
        """Whether every axis stands when it ends: where a condition ends it, and the robot stands for it."""
        return self.condition is not None and (self.beside is None or self.in_position)

    @property
    def programmed(self) -> float:
        """Its time as the program has it [s]."""
        return self.duration if self.beside is None else self.beside


@dataclass(frozen=True, kw_only=True)
class SignalEvent:
    """An output set between two motions; delay [s]: how long after the instruction it changes. drives_rail: it says no
    more than where the rail goes (rail_at in the cell file), which is the plan's."""

    source: Source
    written: Written
    signal: str
    value: float
    delay: float = 0.0
    drives_rail: bool = False


Move = PoseMove | MoveAbsJ | MoveExtJ
Motion = Move | Wait | SignalEvent


def turned_under(motion: Motion) -> tuple[UnitMove, ...]:
    """The axes, from the floor on, that turn the work object under a line or an arc while it is drawn there."""
    return tuple(unit for unit in motion.units if unit.carries) if isinstance(motion, PathMove) else ()


def instruction_name(motion: Motion) -> str:
    """The instruction as the program spells it: MoveL, or ArcL where a line is written so."""
    process = motion.process if isinstance(motion, Move) else None
    return process.instruction if process else type(motion).__name__


def motion_name(motion: Motion) -> str:
    """A motion in messages: "MoveL p_in"."""
    return f"{instruction_name(motion)} {motion.target}" if isinstance(motion, Move) else type(motion).__name__


@dataclass(frozen=True)
class TextFile:
    """A program file as read: decoded text, the encoding it came in, and its exact bytes' length for the record."""

    path: str
    text: str
    encoding: str


class Refusal(NamedTuple):
    """One thing that one statement asks for and no plan keeps. kind: in one word or two; message: with advice."""

    kind: str
    source: Source
    message: str


@dataclass(frozen=True, eq=False)
class Program:
    """A program run once: its motions in order, the files they came from, and what the user should know.

    passes: of a loop that never ends in the motions, 0 without one. before: what runs before that loop's steady cycle,
    which the motions are then: they begin at rest where the last move of them ends. None: they begin where the cell
    says. beyond: what runs behind the cycle until the passes repeat, where they differ. entry: the procedure that was
    run. ignored: instructions without effect on motion, with how often they ran. uncalled: the routines that never ran,
    with their kind: "PROC Reset". refusals: what no motion stands for.
    """

    name: str
    motions: tuple[Motion, ...]
    files: Mapping[str, TextFile]
    warnings: tuple[ProgramWarning, ...] = field(default=())
    entry: str = "main"
    ignored: Mapping[str, int] = field(default_factory=dict)
    uncalled: tuple[str, ...] = ()
    refusals: tuple[Refusal, ...] = ()
    before: tuple[Motion, ...] | None = None
    beyond: tuple[Motion, ...] = ()
    passes: int = 0

    @property
    def entrance(self) -> Move | None:
        """The move at whose end a steady cycle begins: its own last one; None for a program that runs once."""
        if self.before is None:
            return None
        return next(motion for motion in reversed(self.motions) if isinstance(motion, Move))

    @property
    def from_start(self) -> Program:
        """The program from where the cell says, with what runs before its steady cycle."""
        return replace(self, motions=(*(self.before or ()), *self.motions), before=None, beyond=())

    @property
    def without_effect(self) -> tuple[str, ...]:
        """A line that names what is ignored; none where nothing is."""
        counted = ", ".join(f"{instruction} {count}" for instruction, count in self.ignored.items())
        return (f"no effect on motion: {counted}",) if counted else ()


def as_written(program: Program, motion: Motion) -> tuple[str, str]:
    """The name of a motion's instruction and what stands behind it, as the program spells them."""
    file, start, end = motion.written.statement
    words = " ".join(program.files[file].text[start:end].rstrip(";").split())
    name = re.match(r"\w*", words)
    return (name[0], words[name.end() :].strip()) if name else ("", words)


def without_name(condition: str, name: str) -> str:
    """What a wait's condition says behind the name of its instruction, "" for nothing."""
    named = condition.lower().split()[:1] == [name.lower()]
    return condition[len(name) :].strip() if named else condition
