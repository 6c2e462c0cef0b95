"""What a robot program asks for, as flat data: moves, waits and signals in program order, each with its place.

SI units. Frames: W world, F flange (tool0), T tool centre point, O work object; X_AB is frame B seen from A, (4, 4).
Floor 1: no project imports but geometry.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from trajopt_cli.geometry import Array, readonly


@dataclass(frozen=True)
class Source:
    """A place in a program: file as the user gave it, line and column counted from 1."""

    file: str
    line: int
    column: int

    def __str__(self) -> str:
        return f"{self.file}:{self.line}:{self.column}"


@dataclass(frozen=True)
class Span:
    """A stretch of one file's decoded text, [start, end) in characters."""

    file: str
    start: int
    end: int


@dataclass(frozen=True)
class Written:
    """Where an instruction's parts stand in the text, so that an export can edit them in place.

    statement reaches from the instruction's name to its semicolon. target, speed: the argument in the statement.
    aggregate: the literal `[...]` that gives the target's value, in the statement or in a declaration. declaration: the
    whole data declaration that holds it. None where the value is computed or given elsewhere.
    """

    statement: Span
    target: Span | None = None
    speed: Span | None = None
    aggregate: Span | None = None
    declaration: Span | None = None


@dataclass(frozen=True)
class Speed:
    """Programmed caps: TCP speed [m/s], reorientation [rad/s], linear [m/s] and rotary [rad/s] external axes."""

    name: str
    v_tcp: float
    v_ori: float
    v_leax: float
    v_reax: float


@dataclass(frozen=True)
class Zone:
    """Programmed accuracy: a stop point, or a fly-by of radius [m] around the target."""

    name: str
    stop: bool
    radius: float = 0.0


@dataclass(frozen=True, eq=False)
class Tool:
    """A tool by name; X_FT is its centre point in the flange frame."""

    name: str
    X_FT: Array

    def __post_init__(self) -> None:
        object.__setattr__(self, "X_FT", readonly(self.X_FT))


@dataclass(frozen=True)
class ConfData:
    """RAPID confdata: quadrants of axes 1, 4 and 6 and the branch number cfx (0..7)."""

    cf1: int
    cf4: int
    cf6: int
    cfx: int


# External axes eax_a..eax_f as RAPID states them, in mm or degrees (only the cell knows which); None for 9E9.
ExternalAxes = tuple[float | None, float | None, float | None, float | None, float | None, float | None]
NO_EXTERNAL_AXES: ExternalAxes = (None, None, None, None, None, None)


@dataclass(frozen=True, eq=False, kw_only=True)
class _Move:
    """What every move has. target: as written. duration: the programmed \\T in s. optional: it may be dropped."""

    source: Source
    written: Written
    target: str
    speed: Speed
    zone: Zone
    extax: ExternalAxes
    duration: float | None = None
    optional: bool = False


@dataclass(frozen=True, eq=False, kw_only=True)
class _PoseMove(_Move):
    X_WT: Array
    conf: ConfData
    tool: Tool
    wobj: str = "wobj0"

    def __post_init__(self) -> None:
        object.__setattr__(self, "X_WT", readonly(self.X_WT))


@dataclass(frozen=True, eq=False, kw_only=True)
class MoveJ(_PoseMove):
    """To the pose X_WT, axes free on the way."""


@dataclass(frozen=True, eq=False, kw_only=True)
class MoveL(_PoseMove):
    """To the pose X_WT, the TCP on a straight line, orientation by slerp."""


@dataclass(frozen=True, eq=False, kw_only=True)
class MoveAbsJ(_Move):
    """To arm joints q (6,) in rad, axes free on the way."""

    q: Array
    tool: Tool

    def __post_init__(self) -> None:
        object.__setattr__(self, "q", readonly(self.q))


@dataclass(frozen=True, eq=False, kw_only=True)
class MoveExtJ(_Move):
    """External axes alone; the arm's joints hold."""


@dataclass(frozen=True, kw_only=True)
class Wait:
    """Standing still. duration [s]: exact when condition is None; else the least time until the condition holds."""

    source: Source
    written: Written
    duration: float
    condition: str | None = None


@dataclass(frozen=True, kw_only=True)
class SignalEvent:
    """An output set between two motions."""

    source: Source
    written: Written
    signal: str
    value: float


Move = MoveJ | MoveL | MoveAbsJ | MoveExtJ
Motion = Move | Wait | SignalEvent


@dataclass(frozen=True)
class TextFile:
    """A program file as read: decoded text, the encoding it came in, and its exact bytes' length for the record."""

    path: str
    text: str
    encoding: str


@dataclass(frozen=True, eq=False)
class Program:
    """A program run once: its motions in order, the files they came from, and what the user should know."""

    name: str
    motions: tuple[Motion, ...]
    files: Mapping[str, TextFile]
    warnings: tuple[str, ...] = field(default=())
