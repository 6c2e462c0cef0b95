"""Where robots are found, and what their YAML files hold: validated, with the line of every mistake."""

from __future__ import annotations

import re
import warnings
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any, Literal, Self

from pydantic import BaseModel, ConfigDict, Field, ValidationError, model_validator
from ruamel.yaml import YAML
from ruamel.yaml.error import ReusedAnchorWarning, YAMLError

from trajopt_cli.errors import InputError, InputErrorGroup
from trajopt_cli.limits import SPREADS
from trajopt_cli.quantity import complain
from trajopt_cli.robot.structure import Structure
from trajopt_cli.shapes import ATTACHED
from trajopt_cli.validation import hint, json_schema, short
from trajopt_cli.yaml_file import read_text, remembered

_PACKAGE = Path(__file__).parents[1]
# In a checkout the files stand beside the package, a wheel carries them inside it. What stands beside an installed
# package is not ours, hence the look for the project file.
_FOLDERS = (_PACKAGE.parent / "robots" if (_PACKAGE.parent / "pyproject.toml").is_file() else _PACKAGE / "robots",)

Positive = Annotated[float, Field(gt=0, allow_inf_nan=False)]


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class Origin(_Strict):
    """Where a number comes from and how far to trust it."""

    source: str
    grade: Literal["A", "B", "C", "D"]

    def __str__(self) -> str:
        return f"{self.source} (grade {self.grade})"

    def spread(self, kind: str) -> tuple[float, float]:
        """Between which shares of a number from here the true one is; kind: one of SPREADS."""
        return SPREADS[kind].get(self.grade, (1.0, 1.0))


class Number(Origin):
    """A positive number with its origin; low, high: between which the true one is, None where its grade says it."""

    value: Positive
    low: Positive | None = None
    high: Positive | None = None

    @model_validator(mode="after")
    def _around_value(self) -> Self:
        if (self.low is None) != (self.high is None):
            raise complain(f"has {'high' if self.low is None else 'low'} alone: give both, or leave it out")
        if self.low is not None and self.high is not None and not self.low <= self.value <= self.high:
            raise complain(f"low {self.low:g}, value {self.value:g}, high {self.high:g}: wanted in this order")
        return self

    def spread(self, kind: str) -> tuple[float, float]:
        """See Origin."""
        if self.low is None or self.high is None:
            return super().spread(kind)
        return self.low / self.value, self.high / self.value


class Rate(Number):
    """An acceleration or a jerk that some drive could have."""

    value: Annotated[float, Field(ge=1e-3, le=1e9, allow_inf_nan=False)]


class ConfRule(Origin):
    """Which rule turns joints into RAPID confdata."""

    rule: Literal["abb_six_axis", "none"]


class AxisOrigins(_Strict):
    """Origins of an axis' range and speed, whose numbers stand in the URDF; torque: of its effort there [Nm, N for a
    rail], what the drive gives at most. rotor_inertia [kg m2, kg for a rail]: of the drive, as the axis feels it (the
    motor's times the square of the gear ratio). Both None where nobody says."""

    position: Origin
    velocity: Origin
    torque: Origin | None = None
    rotor_inertia: Number | None = None


class SrsAxisOrigins(AxisOrigins):
    """With the origin of the motor's limit and the torque sensor's range, the URDF's effort; damping [Nm s/rad] and
    Coulomb friction [Nm] of the joint, None where nobody has an idea of them."""

    torque: Origin
    damping: Number | None = None
    friction: Number | None = None


class Caps(_Strict):
    """Documented caps on the TCP: speed [m/s], acceleration [m/s2]."""

    speed: Number
    acceleration: Number


class PostureTable(Origin):
    """Accelerations by posture, see acceleration_table. file: in the robot file's folder or below it. load: what the
    flange carried when they were found; they are not scaled for another."""

    file: str
    load: str


class StopTime(Number):
    """What the axes may take to settle [s]."""

    value: Annotated[float, Field(gt=0, le=5)]


class StopTimes(_Strict):
    """How long the axes settle at a stop that is waited for, see scenario.Settling; inpos None: as fine."""

    fine: StopTime
    inpos: StopTime | None = None


class Profile(_Strict):
    """Accelerations [rad/s2 or m/s2] by axis name and, where anybody has an idea of them, jerks [rad/s3 or m/s3]."""

    about: str
    acceleration: dict[str, Rate]
    jerk: dict[str, Rate] | None = None


class SixAxisProfile(Profile):
    """by_posture: accelerations of the axes that have none by name."""

    by_posture: PostureTable | None = None


Finite = Annotated[float, Field(allow_inf_nan=False)]
Point = tuple[Finite, Finite, Finite]


class LinkPart(_Strict):
    """A body around a link or a part of one, in the link's frame. A capsule: the segment's ends a and b, its radius
    [m]. Or polytope (26,) [m]: how far it reaches in the directions of shapes.DIRECTIONS."""

    a: Point | None = None
    b: Point | None = None
    radius: Positive | None = None
    polytope: Annotated[tuple[Finite, ...], Field(min_length=26, max_length=26)] | None = None

    @model_validator(mode="after")
    def _one_body(self) -> Self:
        given = [name for name in type(self).model_fields if getattr(self, name) not in (None, ())]
        if given not in (["a", "b", "radius"], ["polytope"], ["parts"]):
            raise complain(f"gives {', '.join(given) or 'no body'}: give a, b and radius, or polytope")
        return self


class LinkBody(LinkPart):
    """The same around a whole link; parts: several bodies, for a link that is hollow or bent."""

    parts: tuple[LinkPart, ...] | None = None


class Collision(Origin):
    """Bodies by link name, and the pairs of links that are held against each other."""

    links: dict[str, LinkBody]
    self_pairs: tuple[tuple[str, str], ...]


class Coupled(Origin):
    """A sum of axes, as the linkage of a parallel arm has it. With lower and upper its range [rad]: lower <= factors .
    axes <= upper. With axis: this axis of the controller is the sum of the URDF's joints; its range, speed and the rest
    are those given to the joint of that name."""

    axes: tuple[str, ...]
    factors: tuple[Finite, ...]
    lower: Finite | None = None
    upper: Finite | None = None
    axis: str | None = None

    @property
    def range(self) -> tuple[float, float] | None:
        """lower and upper, None where axis is the sum."""
        return None if self.lower is None or self.upper is None else (self.lower, self.upper)


class RobotFile(_Strict):
    """A robot's YAML file: what every structure has. payload [kg]: as its maker names it. colour: of its paint, as
    "#rrggbb", for pictures."""

    name: str
    title: str
    urdf: str
    structure: Structure = Structure.SIX_AXIS
    payload: Number | None = None
    colour: Annotated[str, Field(pattern="#[0-9a-f]{6}$", max_length=7)] | None = None
    geometry: Origin
    axes: Mapping[str, AxisOrigins]
    profiles: Mapping[str, Profile]
    collision: Collision | None = None


class SixAxisFile(RobotFile):
    """A six-axis arm and RAPID's confdata; inertia: where the URDF's masses and inertias come
    from, None where it has none. profile: the one that cells have by default."""

    profiles: Mapping[str, SixAxisProfile]
    profile: str = "default"

    inertia: Origin | None = None
    confdata: ConfRule
    tcp: Caps
    coupled: tuple[Coupled, ...] = ()
    settle: StopTimes | None = None


class SrsFile(RobotFile):
    """A seven-axis arm with torque sensors; inertia: where the URDF's masses and inertias come from."""

    axes: Mapping[str, SrsAxisOrigins]
    inertia: Origin


_FILES: dict[str, type[RobotFile]] = {Structure.SIX_AXIS.value: SixAxisFile, Structure.SRS.value: SrsFile}


def robot_schema() -> dict[str, Any]:
    """What a robot's YAML file may hold, of either structure, as JSON schema for editors."""
    return json_schema(SixAxisFile | SrsFile, "trajopt robot file")


def _shipped() -> dict[str, Path]:
    """The files of the robots that ship, by name."""
    return {path.stem: path for folder in _FOLDERS for path in folder.glob("*.yaml")}


def robot_names(structure: Structure | None = None) -> tuple[str, ...]:
    """The robots that ship, sorted; those of one structure where it is given."""
    paths = _shipped()
    if structure is None:
        return tuple(sorted(paths))
    return tuple(name for name in sorted(paths) if read_head(paths[name]).structure is structure)


class Head(BaseModel):
    """The lines of a robot's YAML file that a list of robots shows."""

    model_config = ConfigDict(extra="ignore", frozen=True)

    title: str
    urdf: str
    structure: Structure = Structure.SIX_AXIS
    payload: Number | None = None


def read_head(path: Path) -> Head:
    """The head of a file that ships. A whole file takes a tenth of a second, and there are many."""
    lines = (line for line in path.read_text(encoding="utf-8").splitlines() if line.split(":")[0] in Head.model_fields)
    return Head.model_validate(YAML(typ="safe").load("\n".join(lines)))


def find_robot(name_or_path: str, structure: Structure | None = None) -> Path:
    """The YAML file of a shipped robot, or a path to one (anything that ends in .yaml or .yml). InputError if none.

    Names are read as people write them: IRB 140 and irb-140 are irb140.
    structure: the robots the message shall list, all for None; whether the file has it is not looked at.
    """
    if name_or_path.endswith((".yaml", ".yml")):
        path = Path(name_or_path)
        if not path.is_file():
            raise InputError(f"robot file '{name_or_path}' does not exist")
        return path
    bare = {re.sub(r"\W|_", "", name): path for name, path in _shipped().items()}
    if shipped := bare.get(re.sub(r"\W|_", "", name_or_path.lower())):
        return shipped
    advice = hint(name_or_path, robot_names(structure))
    more = "'trajopt robot list' shows all, or give the path of a robot's .yaml file"
    raise InputError(f"unknown robot '{name_or_path}'; {advice}{' ' if advice.endswith('?') else '; '}{more}")


def read_robot_file(path: Path) -> tuple[RobotFile, Mapping[str, Any]]:
    """The validated file and the raw YAML it came from (for line_of). Raises InputError with file, line and key."""
    return _read(str(path), read_text(path, "robot file"))


def _read(file: str, text: str) -> tuple[RobotFile, Mapping[str, Any]]:
    try:
        raw = _loaded(text)
    except YAMLError as error:
        mark, problem = getattr(error, "problem_mark", None), getattr(error, "problem", None) or str(error)
        line = mark.line + 1 if mark is not None else None
        raise InputError(f"not YAML: {short(problem.splitlines()[0])}", file=file, line=line) from error
    except (TypeError, ValueError, OverflowError) as error:  # a section as a key, an escape that is no character
        raise InputError(f"not YAML that a robot file may hold: {short(str(error))}", file=file) from error
    if not isinstance(raw, Mapping):
        raise InputError("a robot file is a YAML mapping; this one is not", file=file, line=1)
    structure = raw.get("structure", Structure.SIX_AXIS.value)
    if not isinstance(structure, str) or structure not in _FILES:
        message = f"'structure': {structure} is none; known are {', '.join(_FILES)}"
        raise InputError(message, file=file, line=line_of(raw, ("structure",)))
    try:
        return _valid(text, structure), raw
    except ValidationError as error:
        found = [
            InputError(_say(item["type"], item["loc"], item["msg"]), file=file, line=line_of(raw, item["loc"]))
            for item in error.errors()
        ]
        raise (found[0] if len(found) == 1 else InputErrorGroup(found)) from error


@remembered(64)
def _valid(text: str, structure: str) -> RobotFile:
    return _FILES[structure].model_validate(_loaded(text))


@remembered(64)
def _loaded(text: str) -> Any:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ReusedAnchorWarning)  # legal, and it would go to stderr
        return YAML().load(text)


def check_axes(
    data: RobotFile, raw: Mapping[str, Any], names: tuple[str, ...], file: str, tables: Mapping[str, frozenset[str]]
) -> None:
    """Hold the axes the file speaks of against the URDF's; tables: those of profiles' tables. Raises InputError for one
    too many or too few."""
    groups: list[tuple[tuple[str, ...], frozenset[str]]] = [(("axes",), frozenset(data.axes))]
    groups += [
        (("profiles", n, "acceleration"), frozenset(p.acceleration) | tables.get(n, frozenset()))
        for n, p in data.profiles.items()
    ]
    groups += [(("profiles", n, "jerk"), frozenset(p.jerk)) for n, p in data.profiles.items() if p.jerk is not None]
    for keys, found in groups:
        # A misspelt name is both unknown and missing; the line of the misspelling helps more.
        for name in (*sorted(found - set(names)), *sorted(set(names) - found)):
            what = "is missing" if name in names else "is no axis of the URDF"
            message = f"'{'.'.join((*keys, name))}' {what}: wanted {', '.join(names)}"
            raise InputError(message, file=file, line=line_of(raw, (*keys, name)))
    for name, profile in data.profiles.items():
        for axis in sorted(tables.get(name, frozenset()) & {*profile.acceleration}):
            keys = ("profiles", name, "acceleration", axis)
            raise InputError(f"'{'.'.join(keys)}': the table gives it; remove one", file=file, line=line_of(raw, keys))
    default = data.profile if isinstance(data, SixAxisFile) else "default"
    if default not in data.profiles:
        raise InputError(f"'profiles.{default}' is missing", file=file, line=line_of(raw, ("profiles",)))


def check_coupled(
    coupled: Sequence[Coupled],
    raw: Mapping[str, Any],
    ranges: Mapping[str, tuple[float, float]],
    alike: float,
    file: str,
) -> None:
    """Hold the coupled sums against the arm's joints; ranges: of each by its name [rad]. alike: 1 where joints 2 and 3
    of the URDF turn about the same direction, -1 where about opposite ones. Raises InputError for one that is none, one
    factor too many or too few, a range that is empty or out of the axes' reach, and an axis that no parallelogram
    makes."""
    _, second, third, *_ = ranges
    for i, one in enumerate(coupled):

        def wrong(key: str, message: str, i: int = i) -> InputError:
            return InputError(f"'coupled.{i}.{key}': {message}", file=file, line=line_of(raw, ("coupled", i, key)))

        for name in one.axes:
            if name not in ranges:
                raise wrong("axes", f"{name} is no joint of the arm: known are {', '.join(ranges)}")
        if len(one.axes) < 2 or len(set(one.axes)) < len(one.axes):
            raise wrong("axes", f"[{', '.join(one.axes)}], wanted two joints or more, each once")
        if len(one.factors) != len(one.axes):
            raise wrong("factors", f"{len(one.factors)} for {len(one.axes)} axes: give one for each")
        if 0.0 in one.factors:
            raise wrong("factors", "0 leaves its axis out: remove both, or give another number")
        if one.axis is not None:
            if one.lower is not None or one.upper is not None:
                raise wrong("axis", f"its range is that of joint {one.axis} in the URDF: leave lower and upper out")
            if i != min(k for k, other in enumerate(coupled) if other.axis is not None):
                raise wrong("axis", "stands twice; an arm has one parallel linkage: keep one")
            given = dict(zip(one.axes, one.factors, strict=True))
            if one.axis != third or given != {second: alike, third: 1.0}:
                message = f"a parallelogram makes axis {third} of axes [{second}, {third}] with factors [{alike:g}, 1]"
                raise wrong("axis", f"{message}, by the URDF's directions: write that, or leave the entry out")
            continue
        if one.lower is None or one.upper is None:
            missing = "lower" if one.lower is None else "upper"
            message = (
                f"'coupled.{i}.{missing}' is missing: give lower and upper of a range, or the axis that the sum is"
            )
            raise InputError(message, file=file, line=line_of(raw, ("coupled", i)))
        if not one.lower < one.upper:
            raise wrong("lower", f"{one.lower:g} is not below upper {one.upper:g}")
        ends = [[f * end for end in ranges[name]] for name, f in zip(one.axes, one.factors, strict=True)]
        low, high = (sum(pick(pair) for pair in ends) for pick in (min, max))
        if one.upper < low or one.lower > high:
            message = f"{one.lower:g}..{one.upper:g} rad is out of reach: their ranges give {low:g}..{high:g}"
            raise wrong("lower", message)


def check_links(collision: Collision, raw: Mapping[str, Any], names: tuple[str, ...], file: str) -> None:
    """Hold the collision section against the chain's links, base first. Raises InputError for a link that is none, and
    for a pair that names a link without a body or not the one nearer the base first."""
    for name in collision.links:
        if name not in names:
            message = f"'collision.links.{name}' is no link of the arm: known are {', '.join(names)}"
            raise InputError(message, file=file, line=line_of(raw, ("collision", "links", name)))
    order = [*(name for name in names if name in collision.links), ATTACHED]
    for pair in collision.self_pairs:
        place = line_of(raw, ("collision", "self_pairs"))
        for name in pair:
            if name not in order:
                message = f"'collision.self_pairs': {name} has no body: known are {', '.join(order)}"
                raise InputError(message, file=file, line=place)
        if order.index(pair[0]) >= order.index(pair[1]):
            message = f"'collision.self_pairs': {', '.join(pair)}: wanted two links, the one nearer the base first"
            raise InputError(message, file=file, line=place)


def line_of(raw: Mapping[str, Any], keys: tuple[int | str, ...]) -> int:
    """The line, from 1, of the key at this path, or of the nearest one above it that stands in the file."""
    line = 1
    node: Any = raw
    for key in keys:
        places: Any = node  # ruamel keeps the lines on its mappings and lists as .lc
        if isinstance(node, list) and isinstance(key, int) and key < len(node):
            line = places.lc.item(key)[0] + 1
            node = node[key]
            continue
        if not isinstance(node, Mapping) or key not in node:
            break
        if key in places.lc.data:  # a merged key has no place of its own
            line = places.lc.key(key)[0] + 1
        node = node[key]
    return line


def _say(kind: str, keys: tuple[int | str, ...], message: str) -> str:
    name = ".".join(str(key) for key in keys)
    if kind == "extra_forbidden":
        return f"unknown key '{name}': remove it or mend its spelling"
    if kind == "missing":
        return f"'{name}' is missing: give it a value"
    return f"'{name}': {message[0].lower()}{message[1:]}"
