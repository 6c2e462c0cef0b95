"""The cell file's shape: every key it may have, its type, its unit and its default."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import MISSING, dataclass, fields
from itertools import pairwise
from math import pi
from pathlib import PurePath
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import (
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    PlainValidator,
    RootModel,
    StrictBool,
    StrictStr,
    create_model,
    model_validator,
)

from trajopt_cli.cell.model import TOOL_RADIUS
from trajopt_cli.limits import AXIS_LIMITS, TcpCaps
from trajopt_cli.quantity import (
    ACCELERATION,
    ANGLE,
    LENGTH,
    RATIO,
    SPEED,
    TIME,
    TURN_ACCELERATION,
    TURN_RATE,
    Reader,
    above_zero,
    complain,
    from_zero,
    number,
    numbers,
    positive,
    shown,
    takes_number,
    units_of,
)
from trajopt_cli.scenario import LONGEST_WAIT, NUM_LIMIT, Lines, Scenario
from trajopt_cli.shapes import Cue

FARTHEST = 1e4  # m from the world's origin; beyond, numbers lose what a robot moves by
MOST_TURNED = 1e4  # rad of an axis of a positioner, 1600 turns
THICKEST = 1.0  # m of a tool's radius
MOST_AXES = 3  # linear ones under the base: a fourth goes nowhere that three do not
LONGEST_RAIL = 100.0  # m of stroke; beyond, somebody wrote millimetres
MAX_SEQUENCE = 10_000  # values of one signal or answer; a program that polls reads a few dozen


def _signal(value: Any) -> float:
    read = float(value) if isinstance(value, bool) else number(RATIO)(value)
    if abs(read) > NUM_LIMIT:
        raise complain(f"{read:g} is too large for a num")
    return read


def _answer(value: Any) -> float | bool | str:
    if isinstance(value, str | bool):
        return value
    if not isinstance(value, int | float):
        raise complain(f"needs a number, true or false, or a text, not {shown(value)}")
    return number(RATIO)(value)


def _word(value: Any) -> str:
    """A text that is one word, in lower case; empty for anything else."""
    return value.strip().lower() if isinstance(value, str) and value.strip().isalpha() else ""


def _share(value: Any) -> float | None:
    if _word(value) == "never":
        return None
    if _word(value):
        raise complain(f"needs a share of the way from 0 to 1, or never, not {shown(value)}")
    share = number(RATIO)(value)
    if not 0 <= share <= 1:
        raise complain(f"needs a share of the way from 0 to 1, or never, not {share:g}")
    return share


@dataclass(frozen=True)
class FreeRail:
    """In which waits the rail may move: all, none, or by line and by name of a procedure or of what is waited for."""

    waits: bool | tuple[str | Lines, ...]


def _least(value: Any) -> float | FreeRail | None:
    if _word(value) == "timeout":
        return None
    if _word(value) in ("free", "hold"):
        return FreeRail(_word(value) == "free")
    if isinstance(value, dict) and list(value) == ["free"] and isinstance(value["free"], list) and value["free"]:
        return FreeRail(tuple(_lines(one) or _wait_name(one) for one in value["free"]))
    if isinstance(value, dict):
        raise complain("needs the waits in which the rail may move, {free: [Handover, diPart, 41]}")
    if _word(value):
        raise complain(f"needs seconds, timeout or, of the rail, free, not {shown(value)}")
    return _time(value)


def _time(value: Any) -> float:
    seconds = from_zero(TIME)(value)
    if seconds > LONGEST_WAIT:
        raise complain(f"{seconds:g} s is more than {LONGEST_WAIT:,} s (11 days); check the value")
    return seconds


def _each(one: Callable[[Any], Any], *kinds: str) -> Reader[Any]:
    """A validator: a value that one takes, or a list of them. kinds: what one takes, as JSON schema names it."""

    def validate(value: Any) -> Any:
        if not isinstance(value, list):
            return one(value)
        if not 0 < len(value) <= MAX_SEQUENCE:
            raise complain(f"needs 1 to {MAX_SEQUENCE} values in its list, not {len(value)}")
        return tuple(one(item) for item in value)

    item = {"type": list(kinds)}
    several = {"type": "array", "items": item, "minItems": 1, "maxItems": MAX_SEQUENCE}
    return Reader(validate, {"anyOf": [item, several]})


def _or(word: str, units: dict[str, float]) -> dict[str, Any]:
    """JSON schema of a number from zero or a word, which may have capitals."""
    letters = "".join(f"[{letter}{letter.upper()}]" for letter in word)
    words = [{"const": word}, {"type": "string", "pattern": rf"^\s*{letters}\s*$"}]
    return {"anyOf": [*takes_number(units, minimum=0)["anyOf"], *words]}


def _said(value: str) -> str:
    if not value.strip():
        raise complain("is empty; say where the number comes from")
    return value.strip()


def _wait_name(value: Any) -> str:
    if not isinstance(value, str) or not value.strip():
        raise complain(f"needs a line, a procedure or what is waited for, not {shown(value)}")
    return value.strip()


_FREE = {"type": "array", "items": {"type": ["string", "integer"]}}
_WAIT = [
    *_or("timeout", TIME)["anyOf"],
    *({"const": word} for word in ("free", "hold")),
    {"type": "object", "properties": {"free": _FREE}, "required": ["free"], "additionalProperties": False},
]

Length = Annotated[float, BeforeValidator(number(LENGTH))]
Angle = Annotated[float, BeforeValidator(number(ANGLE))]
Triple = tuple[float, float, float]
SourceText = Annotated[StrictStr, BeforeValidator(lambda value: _said(value) if isinstance(value, str) else value)]


class _Section(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class FrameSection(_Section):
    """A frame in the world: position [m] and one of wxyz (quaternion, scalar first) or rpy (URDF: Rz Ry Rx) [rad]."""

    position: Annotated[Triple, BeforeValidator(numbers(LENGTH, 3))] = (0.0, 0.0, 0.0)
    wxyz: Annotated[tuple[float, float, float, float], BeforeValidator(numbers(RATIO, 4))] | None = None
    rpy: Annotated[Triple, BeforeValidator(numbers(ANGLE, 3))] | None = None

    @model_validator(mode="after")
    def _one_rotation(self) -> FrameSection:
        if abs(far := max(self.position, key=abs)) > FARTHEST:
            raise complain(f"position reaches {far:g} m, at most {FARTHEST:g} m; check the value and its unit")
        if self.wxyz is not None and self.rpy is not None:
            raise complain("has both wxyz and rpy; keep one")
        if self.wxyz is not None and abs(sum(part * part for part in self.wxyz) ** 0.5 - 1) > 2e-3:
            norm = sum(part * part for part in self.wxyz) ** 0.5
            raise complain(f"wxyz has norm {norm:.6g}; a rotation needs a unit quaternion")
        return self


class TrackSection(_Section):
    """The rail as a body: width and height [m] of the beam under the base, from end to end of the stroke."""

    width: Annotated[float, BeforeValidator(positive(LENGTH))]
    height: Annotated[float, BeforeValidator(positive(LENGTH))]


def _direction(value: Any) -> Triple:
    x, y, z = numbers(RATIO, 3)(value)
    length = (x * x + y * y + z * z) ** 0.5
    if length < 1e-6:
        raise complain(f"[{x:g}, {y:g}, {z:g}] points nowhere; give a direction, [1, 0, 0]")
    return x / length, y / length, z / length


def _stroke(value: Any) -> tuple[float, float]:
    low, high = numbers(LENGTH, 2)(value)
    if not low < high:
        raise complain(f"goes from {low:g} to {high:g}; the lower end comes first")
    if high - low > LONGEST_RAIL:
        raise complain(
            f"is {high - low:g} m long, no rail is longer than {LONGEST_RAIL:g} m; if these are millimetres,"
            f" write [{low / 1e3:g}, {high / 1e3:g}] or [{low:g} mm, {high:g} mm]"
        )
    return low, high


Stroke = Annotated[tuple[float, float], BeforeValidator(Reader(_stroke, numbers(LENGTH, 2).takes, LENGTH))]
Direction = Annotated[Triple, BeforeValidator(Reader(_direction, numbers(RATIO, 3).takes, RATIO))]


class RailSection(_Section):
    """The rail: the external axis that drives it, its travel [m], its zero in the world, its direction in the frame of
    the arm's base, None for the robot file's; fixed keeps its positions. unit: what ActUnit and DeactUnit call it."""

    eax: Literal["a", "b", "c", "d", "e", "f"]
    stroke: Stroke
    frame: FrameSection = FrameSection()
    direction: Direction | None = None
    fixed: StrictBool = False
    unit: StrictStr | None = None
    track: TrackSection | None = None


_SLOWEST = 1e-3
"""rad/s, m/s, rad/s2, m/s2: less is no drive's, and a plan would take for ever."""


def _drives(**limits: float | None) -> None:
    """Raise where a velocity or an acceleration is none of a drive."""
    for name, value in limits.items():
        if value is not None and value < _SLOWEST:
            raise complain(f"{name} {value:g} is less than any drive has, at least {_SLOWEST:g}; check the value")


class AxisSection(_Section):
    """A linear axis under the arm's base: its direction in the world, or the axis that it follows at ratio and offset
    [m]; stroke [m], limits [m/s, m/s2, m/s3] and where these come from."""

    axis: Direction | None = None
    follows: StrictStr | None = None
    ratio: Annotated[float, BeforeValidator(number(RATIO))] = 1.0
    offset: Length = 0.0
    stroke: Stroke | None = None
    velocity: Annotated[float, BeforeValidator(positive(units_of("m/s")))] | None = None
    acceleration: Annotated[float, BeforeValidator(positive(units_of("m/s2")))] | None = None
    jerk: Annotated[float, BeforeValidator(positive(units_of("m/s3")))] | None = None
    source: SourceText | None = None

    @model_validator(mode="after")
    def _one_kind(self) -> AxisSection:
        if (self.axis is None) == (self.follows is None):
            raise complain("needs either axis, its direction ([1, 0, 0]), or follows, the axis that leads it (eax_a)")
        if self.axis is not None and self.stroke is None:
            raise complain("needs its travel in m, 'stroke: [0, 2]'")
        if self.axis is not None and {"ratio", "offset"} & self.model_fields_set:
            raise complain("has a ratio or an offset and follows no axis; remove it or say which, 'follows: eax_a'")
        if self.ratio == 0:
            raise complain("ratio 0 lets it stand; give how far it goes for a metre of the axis that leads it")
        _drives(velocity=self.velocity, acceleration=self.acceleration)
        if self.source is None and (self.velocity or self.acceleration or self.jerk):
            raise complain("says a limit: add its source, where the number comes from")
        return self


_SLIDES = {"velocity": SPEED, "acceleration": ACCELERATION, "start": LENGTH}
_TURNS = {"velocity": TURN_RATE, "acceleration": TURN_ACCELERATION, "start": ANGLE}


class PositionerSection(_Section):
    """One axis of a positioner: the external axis that drives it, the frame (in the world, or on the axis before it)
    about whose z it turns, by range and start [rad], velocity [rad/s] and acceleration [rad/s2], or along whose z it
    slides, by stroke and start [m], velocity [m/s], acceleration [m/s2]; and where they come from."""

    eax: Literal["a", "b", "c", "d", "e", "f"]
    frame: FrameSection = FrameSection()
    range: Annotated[tuple[float, float], BeforeValidator(numbers(ANGLE, 2))] | None = None
    stroke: Annotated[tuple[float, float], BeforeValidator(numbers(LENGTH, 2))] | None = None
    velocity: Annotated[float, BeforeValidator(positive(TURN_RATE | SPEED))]
    acceleration: Annotated[float, BeforeValidator(positive(TURN_ACCELERATION | ACCELERATION))]
    start: Annotated[float, BeforeValidator(number(ANGLE | LENGTH))] = 0.0
    source: SourceText

    @model_validator(mode="before")
    @classmethod
    def _of_one_kind(cls, given: Any) -> Any:
        """Units fit what the axis does."""
        for name, units in (_SLIDES if isinstance(given, dict) and "stroke" in given else _TURNS).items():
            if isinstance(given, dict) and isinstance(given.get(name), str):
                try:
                    number(units)(given[name])
                except ValueError as error:
                    raise complain(f"{name} {error}") from error
        return given

    @model_validator(mode="after")
    def _ordered(self) -> PositionerSection:
        if (self.range is None) == (self.stroke is None):
            raise complain("needs one of range, of an axis that turns, and stroke, of one that slides")
        turns, (low, high) = self.stroke is None, self.reach
        name, unit, most = ("range", "rad", MOST_TURNED) if turns else ("stroke", "m", LONGEST_RAIL)
        _drives(velocity=self.velocity, acceleration=self.acceleration)
        if not low < high:
            raise complain(f"{name} goes from {low:g} to {high:g}; the lower end comes first")
        if max(-low, high) > most:
            raise complain(f"{name} goes from {low:g} to {high:g} {unit}, at most {most:g} {unit}; check the value")
        if not low <= self.start <= high:
            raise complain(f"start {self.start:g} {unit} is not in the {name} {low:g}..{high:g} {unit}")
        return self

    @property
    def reach(self) -> tuple[float, float]:
        """Range or stroke."""
        return self.range or self.stroke or (0.0, 0.0)


def _one_or_more(value: Any) -> Any:
    return [value] if isinstance(value, dict) else value


Positioner = Annotated[
    tuple[PositionerSection, ...],
    Field(min_length=1, max_length=6),
    BeforeValidator(_one_or_more, json_schema_input_type=PositionerSection | tuple[PositionerSection, ...]),
]


class LimitSection(_Section):
    """One axis' own limits, in SI or with a unit; source says where they come from."""

    if TYPE_CHECKING:
        source: str

    @model_validator(mode="after")
    def _ordered(self) -> LimitSection:
        given = {name: getattr(self, name) for name in ("lower", "upper", *AXIS_LIMITS, "acceleration_factor")}
        _drives(**{name: given[name] for name, units in AXIS_LIMITS.items() if "/s" in units["rail"]})
        low, high = given["lower"], given["upper"]
        if low is not None and high is not None and not low < high:
            raise complain(f"lower {low:g} is not below upper {high:g}")
        if given["acceleration"] is not None and given["acceleration_factor"] is not None:
            raise complain("gives acceleration and acceleration_factor: keep one")
        if set(given.values()) == {None}:
            *names, last = given
            raise complain(f"names no limit: {', '.join(names)} or {last}")
        return self


def _positive(unit: str, default: Any = None) -> Any:
    """A field: a quantity above zero in this unit, None for the default; ... for one that has to be given."""
    read = Annotated[float, BeforeValidator(positive(units_of(unit)))]
    return (read, ...) if default is ... else (read | None, None)


def _limit_section(axis: str, end: Any, about: str) -> type[LimitSection]:
    """The section of an axis, turning or rail; end: the type of both ends of its range."""
    given: dict[str, Any] = {"lower": (end, None), "upper": (end, None)}
    given |= {name: _positive(units[axis]) for name, units in AXIS_LIMITS.items()}
    given["acceleration_factor"] = Annotated[float, BeforeValidator(positive(RATIO))] | None, None
    name = "JointLimitSection" if axis == "turning" else "RailLimitSection"
    return create_model(name, __base__=LimitSection, __doc__=about, **given, source=(SourceText, ...))


def _elsewhere() -> None:
    raise complain("the rail's range is rail.stroke; give it there")


JointLimitSection = _limit_section("turning", Angle | None, "Limits of a turning axis: rad, rad/s, rad/s2, rad/s3, Nm.")
RailLimitSection = _limit_section(
    "rail",
    Annotated[None, BeforeValidator(lambda _: _elsewhere())],
    "Limits of the rail: m/s, m/s2, m/s3, N; its range is rail.stroke.",
)


class LimitsSection(BaseModel):
    """Overrides by axis name; which names exist only the robot knows."""

    model_config = ConfigDict(extra="allow", frozen=True)
    __pydantic_extra__: dict[str, JointLimitSection]  # type: ignore[valid-type]
    rail: RailLimitSection | None = None  # type: ignore[valid-type]

    def by_axis(self) -> dict[str, LimitSection]:
        """Every override in file order but the rail's first."""
        rail: dict[str, LimitSection] = {"rail": self.rail} if self.rail else {}
        return rail | dict(self.__pydantic_extra__)


_TOOL: dict[str, Any] = {
    one.name: _positive(one.metadata["unit"], ... if one.default is MISSING else None) for one in fields(TcpCaps)
}
_UNITS = ", ".join(one.metadata["unit"] for one in fields(TcpCaps))
TcpSection = create_model(
    "TcpSection",
    __base__=_Section,
    __doc__=f"Caps on the tool centre point in the world: {_UNITS}.",
    **_TOOL,
    source=(SourceText, ...),
)


SLOWEST_SETTLING = 5.0  # s; beyond, somebody wrote milliseconds


def _settling(value: Any) -> float:
    seconds = from_zero(TIME)(value)
    if seconds > SLOWEST_SETTLING:
        least = f"{seconds:g} s is no time to settle, at most {SLOWEST_SETTLING:g} s"
        raise complain(f"{least}; if these are milliseconds, write {seconds:g} ms")
    return seconds


SettlingTime = Annotated[float, BeforeValidator(Reader(_settling, from_zero(TIME).takes, TIME))]


class SettleSection(_Section):
    """How long the axes settle at a stop that is waited for [s]: at an ordinary one, and at one with \\Inpos."""

    fine: SettlingTime | None = None
    inpos: SettlingTime | None = None


def _settle(value: Any) -> Any:
    return value if isinstance(value, dict) else {"fine": _settling(value)}


_EACH = _each(number(LENGTH), "number", "string")
_START_RAIL = Reader(lambda value: _EACH(value if isinstance(value, list) else [value]), _EACH.takes, LENGTH)


class StartSection(_Section):
    """Where the cycle begins, at rest: arm joints [rad] in order, rail [m], of several axes a list in the order of
    their letters. units: mechanical units that are active."""

    joints: Annotated[tuple[float, ...], BeforeValidator(numbers(ANGLE))]
    rail: Annotated[tuple[float, ...], BeforeValidator(_START_RAIL)] | None = None
    units: tuple[StrictStr, ...] | None = None


Length3 = Annotated[Triple, BeforeValidator(numbers(LENGTH, 3))]


class BoxSection(FrameSection):
    """A box: size along its own axes [m], its centre's frame."""

    size: Annotated[tuple[float, ...], BeforeValidator(Reader(_sizes, numbers(LENGTH, 3).takes, LENGTH))]


class CapsuleSection(_Section):
    """All points within radius of the way from one point to another [m]; a sphere where both are one."""

    start: Length3 = Field(alias="from")
    end: Length3 = Field(alias="to")
    radius: Annotated[float, BeforeValidator(positive(LENGTH))]


class _NamedSection(FrameSection):
    """What has a file's or a folder's name: a name alone is told how to write it."""

    @model_validator(mode="before")
    @classmethod
    def _no_name_alone(cls, value: Any) -> Any:
        if isinstance(value, str):
            key = "file" if "file" in cls.model_fields else "path"
            raise complain(f"needs a section, '{{{key}: {value}}}', not '{value}' alone")
        return value


class FileSection(_NamedSection):
    """A file beside the cell file, and the frame it is seen from."""

    file: Annotated[StrictStr, BeforeValidator(lambda value: _beside(value) if isinstance(value, str) else value)]


class MeshSection(FileSection):
    """A mesh file, what its coordinates are worth in m, and its frame."""

    scale: Annotated[float, BeforeValidator(positive(RATIO))] = 1.0


class ListedBody(MeshSection):
    """A body of a list in a file of its own; the mesh lies beside that or below."""

    ignore: tuple[StrictStr, ...] = ()
    on: StrictStr | None = None


class BodyList(RootModel[dict[StrictStr, ListedBody]]):
    """A list of bodies, by name."""


class FolderSection(_NamedSection):
    """A folder of meshes beside the cell file, what their coordinates are worth in m, and their common frame."""

    path: Annotated[StrictStr, BeforeValidator(lambda value: _beside(value) if isinstance(value, str) else value)]
    scale: Annotated[float, BeforeValidator(positive(RATIO))] = 1.0


class FenceSection(_Section):
    """A wall on the floor along a line of points [x, y] in the world, its height and thickness [m]."""

    points: Annotated[
        tuple[Annotated[tuple[float, ...], BeforeValidator(numbers(LENGTH, 2))], ...], Field(min_length=2)
    ]
    height: Annotated[float, BeforeValidator(positive(LENGTH))]
    thickness: Annotated[float, BeforeValidator(positive(LENGTH))] = 0.05
    floor: Length = 0.0

    @model_validator(mode="after")
    def _some_way(self) -> FenceSection:
        for a, b in pairwise(self.points):
            if a == b:
                raise complain(f"has the point [{a[0]:g}, {a[1]:g}] twice in a row; remove one")
        return self


def _sizes(value: Any) -> tuple[float, ...]:
    return tuple(above_zero(item) for item in numbers(LENGTH, 3)(value))


def _beside(value: str) -> str:
    path = PurePath(value.strip())
    if path.is_absolute() or ".." in path.parts or not path.name:
        raise complain(f"needs a file in the cell file's folder or below it, which results can keep, not '{value}'")
    return str(path)


_SHAPES = ("box", "capsule", "mesh", "fence", "urdf", "folder", "list")


class SolidSection(_Section):
    """A body: one of box, capsule, mesh or fence; or many: of a urdf, a folder or a list. ignore names the links that
    may touch it. on: a positioner that carries it, STN1, or one of its axes from the floor on, STN1.1, whose frame it
    is then placed in."""

    box: BoxSection | None = None
    capsule: CapsuleSection | None = None
    mesh: MeshSection | None = None
    fence: FenceSection | None = None
    urdf: FileSection | None = None
    folder: FolderSection | None = None
    list: FileSection | None = None
    ignore: tuple[StrictStr, ...] = ()
    on: StrictStr | None = None

    @model_validator(mode="after")
    def _one_shape(self) -> SolidSection:
        given = [name for name in _SHAPES if getattr(self, name) is not None]
        if len(given) != 1:
            known = f"{', '.join(_SHAPES[:-1])} or {_SHAPES[-1]}"
            raise complain(f"has {' and '.join(given) or 'no shape'}; give one of {known}")
        return self

    @property
    def many(self) -> bool:
        """Whether it may be several bodies."""
        return bool(self.fence or self.urdf or self.folder or self.list)


def _pair(value: Any) -> Any:
    if not isinstance(value, list) or len(value) != 2 or not all(isinstance(name, str) for name in value):
        raise complain(f"needs two names, '[link_1, link_4]', not {value}")
    return value


_LINES = re.compile(r"(?:(.*):)?\s*([1-9]\d*)(?:\s*-\s*([1-9]\d*))?", re.DOTALL)
_NAME = re.compile(r"[^\W\d]\w*")


def _lines(value: Any) -> Lines | None:
    """Lines of the program: a number, or a text `first-last`, `file:line`, `file:first-last`; None for others."""
    match = _LINES.fullmatch(str(value).strip()) if isinstance(value, int | str) else None
    if match is None or isinstance(value, bool):
        return None
    file = match[1].strip() or None if match[1] else None
    return Lines(file, int(match[2]), int(match[3] or match[2]))


def _place(value: Any) -> Lines:
    """One line of the program."""
    lines = _lines(value)
    if lines is None or lines.first != lines.last:
        raise complain(f"needs a line of the program, 41 or 'hinge.mod:41', not {shown(value)}")
    return lines


def _part(value: Any) -> Lines | str:
    """A procedure, or lines of the program."""
    if isinstance(value, str) and _NAME.fullmatch(value.strip()):
        return value.strip()
    lines = _lines(value)
    if lines is None:
        raise complain(f"needs a procedure or lines of the program, weld, 41 or 'glue.mod:35-48', not {shown(value)}")
    if lines.last < lines.first:
        raise complain(f"goes from line {lines.first} to line {lines.last}; the first one comes first")
    return lines


_SET = re.compile(r"\s*([^\W\d]\w*)\s*=\s*(-?[\d.]+)\s*")


def _cue(value: Any) -> Cue:
    """One line of the program, or an output and its value."""
    if isinstance(value, str) and (match := _SET.fullmatch(value)):
        return Cue(signal=match[1].lower(), value=number(RATIO)(float(match[2])))
    lines = _lines(value)
    if lines is None or lines.first != lines.last:
        raise complain(f"needs a line of the program or an output's value, 41 or 'doGrip = 1', not {shown(value)}")
    return Cue(lines.file, lines.first)


CueText = Annotated[Cue, PlainValidator(_cue, json_schema_input_type=int | str)]


class AttachSection(_Section):
    """An obstacle that the flange takes on the way: part is its name; at and detach say when it takes and leaves it."""

    part: StrictStr
    at: CueText
    detach: CueText | None = None

    @model_validator(mode="after")
    def _two(self) -> AttachSection:
        if self.at == self.detach:
            raise complain(f"takes and leaves the part at the same moment, {self.at}")
        return self


Part = Annotated[Lines | str, PlainValidator(_part, json_schema_input_type=int | str)]


class FreeSection(_Section):
    """The tool may be turned about an axis of its own by an angle in within [rad]. parts (in): procedures,
    instructions, tools and lines; none for everywhere."""

    axis: Literal["x", "y", "z"]
    within: Annotated[tuple[float, float], BeforeValidator(numbers(ANGLE, 2))] = (-pi, pi)
    parts: tuple[Part, ...] | None = Field(alias="in", default=None, min_length=1)

    @model_validator(mode="after")
    def _around_taught(self) -> FreeSection:
        low, high = self.within
        if not -pi - 1e-9 <= low <= 0 <= high <= pi + 1e-9:
            degrees = f"; if these are degrees, write '[{low:g}, {high:g}] deg'" if max(-low, high) > 2 * pi else ""
            raise complain(
                f"within goes from {low:g} to {high:g} rad; it holds 0, as taught, and at most half a turn to each"
                f" side, -180 to 180 deg{degrees}"
            )
        if low == high:
            raise complain("within leaves the tool no turn; widen it, or remove the section")
        return self


class HoldRailSection(_Section):
    """Where the rail stands still: procedures by name, lines, all waits; gripper: waits right after an output. None: as
    waits.rail says."""

    procedures: tuple[StrictStr, ...] = ()
    lines: tuple[Annotated[Lines, PlainValidator(_place, json_schema_input_type=int | str)], ...] = ()
    waits: StrictBool | None = None
    gripper: StrictBool | None = None


def _thickness(value: Any) -> float:
    radius = from_zero(LENGTH)(value)
    if radius > THICKEST:
        raise complain(
            f"{radius:g} m is no tool's, at most {THICKEST:g} m; if these are millimetres, write {radius:g} mm"
        )
    return radius


Solids = dict[StrictStr, SolidSection]
SignalValues = Annotated[float | tuple[float, ...], BeforeValidator(_each(_signal, "number", "boolean", "string"))]
Answers = Annotated[
    StrictBool | float | StrictStr | tuple[StrictBool | float | StrictStr, ...],
    BeforeValidator(_each(_answer, "number", "boolean", "string")),
]


class DataSection(_Section):
    """Data that no file declares or that somebody outside writes. type: RAPID's name for it, where it must be said."""

    value: Answers
    type: StrictStr | None = None


def _data(value: Any) -> Any:
    return value if isinstance(value, dict) else {"value": value}


MAX_ENDLESS_PASSES = 10_000  # a cycle has its motions once per pass


class CellDocument(_Section):
    """The whole file."""

    robot: StrictStr
    profile: StrictStr = "default"
    rail: RailSection | None = None
    axes: dict[StrictStr, AxisSection] = Field(default_factory=dict)
    base: FrameSection | None = None
    positioners: dict[StrictStr, Positioner] = Field(default_factory=dict)
    limits: LimitsSection = Field(default_factory=lambda: LimitsSection.model_validate({}))
    tcp: TcpSection | None = None  # type: ignore[valid-type]
    start: StartSection
    obstacles: Solids = Field(default_factory=dict)
    attached: Solids = Field(default_factory=dict)
    attach: tuple[AttachSection, ...] = ()
    may_touch: tuple[Annotated[tuple[str, str], BeforeValidator(_pair)], ...] = ()
    clearance: Annotated[float, BeforeValidator(from_zero(LENGTH))] = 0.0
    tool_radius: Annotated[float, BeforeValidator(Reader(_thickness, from_zero(LENGTH).takes, LENGTH))] = TOOL_RADIUS
    signals: dict[StrictStr, SignalValues] = Field(default_factory=dict)
    answers: dict[StrictStr, Answers] = Field(default_factory=dict)
    data: dict[
        StrictStr, Annotated[DataSection, BeforeValidator(_data, json_schema_input_type=DataSection | Answers)]
    ] = Field(default_factory=dict)
    waits: dict[
        StrictStr, Annotated[float | FreeRail | None, BeforeValidator(Reader(_least, {"anyOf": _WAIT}, TIME))]
    ] = Field(default_factory=dict)
    partner: dict[
        Annotated[int, Field(ge=0)], Annotated[float, BeforeValidator(Reader(_time, from_zero(TIME).takes, TIME))]
    ] = Field(default_factory=dict)
    searches: dict[StrictStr, Annotated[float | None, BeforeValidator(Reader(_share, _or("never", RATIO)))]] = Field(
        default_factory=dict
    )
    endless_passes: Annotated[int, Field(strict=True, gt=0, le=MAX_ENDLESS_PASSES)] | None = None
    settle: Annotated[SettleSection, BeforeValidator(_settle, json_schema_input_type=SettleSection | SettlingTime)] = (
        SettleSection()
    )
    optional: tuple[StrictStr, ...] = ()
    hold_rail: HoldRailSection = HoldRailSection()
    rail_at: dict[StrictStr, Length] = Field(default_factory=dict)
    constant_speed: tuple[Part, ...] = ()
    free: Annotated[
        tuple[FreeSection, ...],
        BeforeValidator(_one_or_more, json_schema_input_type=FreeSection | tuple[FreeSection, ...]),
    ] = ()
    order: dict[StrictStr, Annotated[tuple[Part, ...], Field(min_length=2)]] = Field(default_factory=dict)
    free_speed: StrictBool = False
    jerk_limits: StrictBool = False
    torque_limits: StrictBool = False
    pass_limit: Annotated[int, Field(strict=True, gt=0)] = Scenario.pass_limit
    statement_limit: Annotated[int, Field(strict=True, gt=0)] = Scenario.statement_limit
    assume_identity: tuple[StrictStr, ...] = ()
    stubs: tuple[StrictStr, ...] = ()
