"""The task file's shape: every key it may have, its type, its unit and its default."""

from __future__ import annotations

from collections.abc import Callable
from importlib.resources import files
from pathlib import PurePath
from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, StrictBool, StrictStr, model_validator

from trajopt_cli.cell.document import BoxSection, CapsuleSection, FrameSection
from trajopt_cli.quantity import (
    ACCELERATION,
    ANGLE,
    JERK,
    LENGTH,
    RATIO,
    SPEED,
    TIME,
    TURN_ACCELERATION,
    TURN_JERK,
    TURN_RATE,
    Reader,
    above_zero,
    complain,
    not_a_list,
    not_negative,
    number,
    numbers,
    shown,
    takes_number,
)
from trajopt_cli.units import DEG
from trajopt_cli.validation import json_schema

FORCE, TORQUE = {"N": 1.0}, {"Nm": 1.0}
STIFFNESS, TURN_STIFFNESS = {"N/m": 1.0, "N/mm": 1e3}, {"Nm/rad": 1.0}
DAMPING, TURN_DAMPING = {"N s/m": 1.0, "Ns/m": 1.0}, {"N m s/rad": 1.0, "Nms/rad": 1.0}
MASS, INERTIA = {"kg": 1.0, "g": 1e-3}, {"kg m2": 1.0}
FREQUENCY = {"Hz": 1.0}

Six = tuple[float, float, float, float, float, float]


# What no cell comes near: beyond it a unit slipped, or the arithmetic would.
_MOST: tuple[tuple[dict[str, float], float], ...] = (
    (LENGTH, 1e3), (ANGLE, 1e3), (TIME, 1e5), (SPEED, 1e3), (TURN_RATE, 1e3), (ACCELERATION, 1e6),
    (TURN_ACCELERATION, 1e6), (JERK, 1e9), (TURN_JERK, 1e9), (FORCE, 1e6), (TORQUE, 1e6), (STIFFNESS, 1e9),
    (TURN_STIFFNESS, 1e9), (DAMPING, 1e9), (TURN_DAMPING, 1e9), (MASS, 1e6), (INERTIA, 1e6), (FREQUENCY, 1e6),
    (RATIO, 1e3),
)  # fmt: skip
_LEAST = 1e-9  # in SI: a cap, a mass or a stiffness below it is no number anybody meant
_PERIOD = (1e-5, 1.0)  # s
_LONGEST_NAME = 100
_FINEST = 1e-6  # m, rad: nearer poses are better taken as stops


def _sane(units: dict[str, float], rule: Callable[[float], float] | None = None, **bounds: float) -> Reader[float]:
    """As quantity.number, within what a cell can have; rule holds it besides, and then nothing but 0 is tiny. bounds:
    as of takes_number."""
    most = next(bound for kind, bound in _MOST if kind is units)

    def validate(value: Any) -> float:
        out = number(units)(value)
        if abs(out) > most:
            unit = next(iter(units))
            raise complain(f"{out:g} is beyond anything a cell has (at most {most:g} {unit}); check the unit")
        if rule is not None and 0 < abs(rule(out)) < _LEAST:
            raise complain(f"{out:g} is below anything a cell has (at least {_LEAST:g}, or 0 where that is allowed)")
        return out

    return Reader(validate, takes_number(units, **bounds or {"minimum": -most, "maximum": most}))


def _above(units: dict[str, float]) -> BeforeValidator:
    return BeforeValidator(_sane(units, above_zero, exclusiveMinimum=0))


def _from_zero(units: dict[str, float]) -> BeforeValidator:
    return BeforeValidator(_sane(units, not_negative, minimum=0))


def _period(value: Any) -> float:
    out = above_zero(_sane(TIME)(value))
    if not _PERIOD[0] <= out <= _PERIOD[1]:
        raise complain(f"needs a period between {1e3 * _PERIOD[0]:g} ms and {_PERIOD[1]:g} s, not {out:g} s")
    return out


def _list_of(units: dict[str, float], count: int) -> BeforeValidator:
    def validate(value: Any) -> tuple[float, ...]:
        return tuple(_sane(units)(item) for item in numbers(units, count)(value))

    return BeforeValidator(Reader(validate, numbers(units, count).takes))


def _line(value: Any) -> Any:
    """Text for a message on one line: no control characters, no halves of a character."""
    if isinstance(value, str) and not value.isprintable():
        raise complain("holds a character that cannot be printed; give it a plain name")
    if isinstance(value, str) and not 0 < len(value.strip()) <= _LONGEST_NAME:
        raise complain(f"needs a name of 1 to {_LONGEST_NAME} characters")
    return value


def _program(value: Any) -> Any:
    if isinstance(value, str):
        path = PurePath(value.strip())
        if path.is_absolute() or ".." in path.parts or not path.name:
            raise complain(
                f"needs a file in the task file's folder or below it, which results can keep, not {shown(value)}"
            )
    return value


def _six_values(
    first: dict[str, float], last: dict[str, float], rule: Callable[[float], float] | None = None
) -> Reader[tuple[float, ...]]:
    """A validator: three values in the first units, three in the last; rule holds each."""

    def validate(value: Any) -> tuple[float, ...]:
        if not isinstance(value, list):
            raise not_a_list(value, "a list of 6 values")
        if len(value) != 6:
            raise complain(f"needs 6 values, not {len(value)}")
        return tuple(kind(item) for kind, item in zip(kinds, value, strict=True))

    kinds = [_sane(first, rule)] * 3 + [_sane(last, rule)] * 3
    items = [kind.takes for kind in kinds]
    return Reader(validate, {"type": "array", "prefixItems": items, "items": False, "minItems": 6})


def _per_segment(units: dict[str, float]) -> BeforeValidator:
    """One value for all segments, or a list of one each. What it must be above, the segments say."""

    def validate(value: Any) -> float | tuple[float, ...]:
        return tuple(one(item) for item in value) if isinstance(value, list) else one(value)

    one = _sane(units, float)
    takes = {"anyOf": [*one.takes["anyOf"], {"type": "array", "items": one.takes}]}
    return BeforeValidator(Reader(validate, takes))


PoseValues = Annotated[Six, BeforeValidator(_six_values(LENGTH, ANGLE))]


def _pose_or_start(value: Any) -> Any:
    if isinstance(value, str) and value != "start":
        raise complain(f"needs [x, y, z, alpha, beta, gamma] or 'start', not {shown(value)}")
    return value if value == "start" else _pose_values(value)


_pose_values = _six_values(LENGTH, ANGLE)
PlaceValues = Annotated[
    Six | Literal["start"], BeforeValidator(_pose_or_start, json_schema_input_type=PoseValues | Literal["start"])
]
ForceValue = Annotated[float, _from_zero(FORCE)]
ForceValues = Annotated[Six, BeforeValidator(_six_values(FORCE, TORQUE))]
Angles = Annotated[tuple[float, float, float], _list_of(ANGLE, 3)]
Speed = Annotated[float | tuple[float, ...], _per_segment(SPEED)]
TurnRate = Annotated[float | tuple[float, ...], _per_segment(TURN_RATE)]
Acceleration = Annotated[float | tuple[float, ...], _per_segment(ACCELERATION)]
TurnAcceleration = Annotated[float | tuple[float, ...], _per_segment(TURN_ACCELERATION)]
Jerk = Annotated[float | tuple[float, ...], _per_segment(JERK)]
TurnJerk = Annotated[float | tuple[float, ...], _per_segment(TURN_JERK)]
Stiffness = Annotated[Six, BeforeValidator(_six_values(STIFFNESS, TURN_STIFFNESS, not_negative))]
Damping = Annotated[Six, BeforeValidator(_six_values(DAMPING, TURN_DAMPING, not_negative))]
Inertia = Annotated[Six, BeforeValidator(_six_values(MASS, INERTIA, above_zero))]
Instant = Annotated[float, _from_zero(TIME)]


class Section(BaseModel):
    """A part of the file; unknown keys are mistakes."""

    model_config = ConfigDict(extra="forbid", frozen=True)


class ForceSection(Section):
    """How hard the tool presses, and along what: its own z axis, the normal of the path, or an axis of the world."""

    value: ForceValue | None = None
    along: Literal["tool", "normal", "x", "-x", "y", "-y", "z", "-z"] | None = None


class TaskForceSection(ForceSection):
    """The same of all poses that say nothing else; by: a shifted equilibrium, or a wrench that the controller takes;
    lead: the equilibrium runs ahead of the path so that the tool does not lag; settle: the dwell at the first pose of a
    path in a file, where the force comes."""

    by: Literal["offset", "wrench"] = "offset"
    lead: StrictBool = False
    settle: Annotated[float, _from_zero(TIME)] = 0.0


def _force(value: Any) -> Any:
    return value if value is None or isinstance(value, dict) else {"value": value}


PoseForce = Annotated[ForceSection, BeforeValidator(_force, json_schema_input_type=ForceSection | ForceValue)]
TaskForce = Annotated[TaskForceSection, BeforeValidator(_force, json_schema_input_type=TaskForceSection | ForceValue)]


class PoseSection(Section):
    """One pose: at (a pose, or "start": where the tool is at the start) or by (added to the pose before); dwell."""

    name: Annotated[StrictStr, BeforeValidator(_line)] | None = None
    at: PlaceValues | None = None
    by: PoseValues | None = None
    dwell: Annotated[float, _from_zero(TIME)] = 0.0
    force: PoseForce | None = None

    @model_validator(mode="after")
    def _one_place(self) -> PoseSection:
        if (self.at is None) == (self.by is None):
            raise complain("needs one of 'at' and 'by': a pose, or what to add to the pose before")
        return self


def _pose(value: Any) -> Any:
    return {"at": value} if isinstance(value, list | str) else value


class PassingSection(Section):
    """How near poses are passed that are no stops."""

    tolerance: Annotated[float, _above(LENGTH)] = 1e-4
    turn_tolerance: Annotated[float, _above(ANGLE)] = 0.5 * DEG

    @model_validator(mode="after")
    def _not_too_fine(self) -> PassingSection:
        if self.tolerance < _FINEST or self.turn_tolerance < _FINEST:
            raise complain(f"needs tolerances of at least {_FINEST:g} m and rad; where no tolerance is left, 'stop'")
        return self


def _passing(value: Any) -> Any:
    if isinstance(value, str) and value != "stop":
        raise complain(f"needs 'stop' or a section with tolerance and turn_tolerance, not {shown(value)}")
    return None if value == "stop" else value


class LoadSection(Section):
    """What the flange carries: mass [kg], com [m] in the flange frame, inertia [kg m2] about it, as a diagonal."""

    mass: Annotated[float, _above(MASS)]
    com: Annotated[tuple[float, float, float], _list_of(LENGTH, 3)] = (0.0, 0.0, 0.0)
    inertia: Annotated[tuple[float, float, float], _list_of(INERTIA, 3)] = (0.0, 0.0, 0.0)


class ToolSection(FrameSection):
    """The tool centre point and the tool's body in the flange frame, and its load."""

    load: LoadSection | None = None
    capsule: CapsuleSection | None = None


class StartSection(Section):
    """Where the controller is switched on."""

    joints: Annotated[tuple[float, ...], _list_of(ANGLE, 7)]


class ArmAngleSection(Section):
    """A fixed arm angle instead of the one at the start."""

    value: Annotated[float, BeforeValidator(_sane(ANGLE))]
    definition: Literal["faria", "swivel"] = "faria"


Component = Literal["fx", "fy", "fz", "mx", "my", "mz"]


class ZeroSection(Section):
    """Components of the force that the controller is blind to, in a frame turned by three angles."""

    components: tuple[Component, ...] = ()
    frame: Angles = (0.0, 0.0, 0.0)


class ClampSection(Section):
    """Bounds: torque of every joint before the mapping, force and moment after it."""

    torque: Annotated[tuple[float, ...], _list_of(TORQUE, 7)] | None = None
    force: ForceValues | None = None


class ChangeSection(Section):
    """What is different from a time on."""

    at: Annotated[Instant | StrictStr, Field(union_mode="left_to_right")]
    K: Stiffness | None = None
    D: Damping | None = None
    M: Inertia | None = None
    zero: ZeroSection | None = None
    clamps: ClampSection | None = None
    tool: FrameSection | None = None
    base: FrameSection | None = None
    restart: StrictBool = False


class PushSection(Section):
    """A simulated force on the tool for a while."""

    start: Instant = Field(alias="from")
    end: Instant = Field(alias="to")
    force: ForceValues

    @model_validator(mode="after")
    def _ordered(self) -> PushSection:
        if not self.start < self.end:
            raise complain(f"goes from {self.start:g} s to {self.end:g} s; 'from' comes first")
        return self


class RippleSection(Section):
    """One oscillation of the measured torques."""

    frequency: Annotated[float, _above(FREQUENCY)]
    amplitude: Annotated[float, _from_zero(TORQUE)]


class SensorSection(Section):
    """Errors of the measured joint torques: bias as a share of each joint's range, ripples, the model's inertia."""

    bias: Annotated[float, _from_zero(RATIO)] = 0.02
    ripple: tuple[RippleSection, ...] = (
        RippleSection(frequency=8.0, amplitude=0.3),
        RippleSection(frequency=17.0, amplitude=0.2),
    )
    rigid: StrictBool = True
    seed: Annotated[int, Field(strict=True, ge=0)] = 1


class ObstacleSection(Section):
    """A box or a capsule that pushes back."""

    box: BoxSection | None = None
    capsule: CapsuleSection | None = None
    stiffness: Annotated[float, _above(STIFFNESS)]
    damping: Annotated[float, _from_zero(DAMPING)] = 0.0
    friction: Annotated[float, _from_zero(RATIO)] = 0.0

    @model_validator(mode="after")
    def _one_shape(self) -> ObstacleSection:
        if (self.box is None) == (self.capsule is None):
            raise complain("needs one of 'box' and 'capsule'")
        return self


class ContactSection(Section):
    """What the tool may run into; tip is the radius of the ball at its end."""

    obstacles: dict[Annotated[StrictStr, BeforeValidator(_line)], ObstacleSection]
    tip: Annotated[float, _above(LENGTH)]


class ContactDocument(BaseModel):
    """The contact section of a file whose other keys are somebody else's business."""

    model_config = ConfigDict(extra="ignore", frozen=True)
    contact: ContactSection


def _ratios(value: Any) -> tuple[float, ...]:
    out = numbers(RATIO, 6)(value if isinstance(value, list) else [value] * 6)
    if not all(0 < one <= 2 for one in out):
        raise complain(f"needs damping ratios above 0 and at most 2, not {shown(value)}")
    return tuple(out)


class ImpedanceSection(Section):
    """The impedance controller's damping ratios, and its null space: as Sunrise's CartesianImpedanceControlMode."""

    damping_ratio: (
        Annotated[
            tuple[float, ...],
            BeforeValidator(_ratios, json_schema_input_type=Annotated[float | list[float], Field()]),
        ]
        | None
    ) = None
    null_stiffness: Annotated[float, _from_zero(TURN_STIFFNESS)] = 10.0
    null_damping: Annotated[float, _from_zero(RATIO)] = 0.7


class TaskDocument(Section):
    """The whole file."""

    robot: StrictStr = "iiwa7"
    limits: StrictStr = "default"
    base: FrameSection = FrameSection()
    tool: ToolSection = ToolSection()
    start: StartSection
    h: Annotated[float, BeforeValidator(Reader(_period, takes_number(TIME, exclusiveMinimum=0)))] = 0.001
    profile: Literal["thesis", "trapezoid", "s-curve"] | None = None
    rotation: Literal["tait-bryan", "slerp"] = "tait-bryan"
    angles: Literal["relative", "absolute"] = "relative"
    poses: (
        tuple[
            Annotated[
                PoseSection, BeforeValidator(_pose, json_schema_input_type=PoseSection | PoseValues | Literal["start"])
            ],
            ...,
        ]
        | None
    ) = None
    program: Annotated[StrictStr, BeforeValidator(_program)] | None = None
    approach: Literal["line", "joint", "none"] = "line"
    passing: Annotated[
        PassingSection | None, BeforeValidator(_passing, json_schema_input_type=PassingSection | Literal["stop"])
    ] = None
    timing: Literal["poses", "joints"] = "poses"
    v_max: Speed | None = None
    omega_max: TurnRate | None = None
    force: TaskForce | None = None
    a_max: Acceleration | None = None
    epsilon_max: TurnAcceleration | None = None
    jerk: Jerk | None = None
    angular_jerk: TurnJerk | None = None
    controller: Literal["admittance", "impedance"] = "admittance"
    impedance: ImpedanceSection = ImpedanceSection()
    K: Stiffness
    D: Damping
    M: Inertia
    integration: Literal["euler", "exact"] = "euler"
    arm_angle: ArmAngleSection | None = None
    zero: ZeroSection = ZeroSection()
    clamps: ClampSection = ClampSection()
    changes: tuple[ChangeSection, ...] = ()
    pushes: tuple[PushSection, ...] = ()
    sensor: SensorSection | None = None
    contact: ContactSection | None = None

    @model_validator(mode="after")
    def _one_path(self) -> TaskDocument:
        if (self.poses is None) == (self.program is None):
            raise complain("give one of 'poses' (a list) and 'program' (a RAPID file with MoveL motions)")
        return self


def task_schema() -> dict[str, Any]:
    """What a task file may hold, with a description of every key."""
    keys = files("trajopt_cli.iiwa.task").joinpath("keys.md").read_text(encoding="utf-8")
    schema = json_schema(TaskDocument, "trajopt iiwa task file", keys)
    schema["required"] = [
        name for name in schema["required"] if name not in ("K", "D", "M")
    ]  # what a controller has itself
    kinds = schema["properties"]["controller"]
    kinds["anyOf"] = [
        {name: kinds.pop(name) for name in ("enum", "type")},
        {"type": "string", "pattern": r"\.ya?ml(:\w+)?$"},
    ]
    # a path in a file of its own stands where the loader looks before the document does
    schema["properties"]["poses"]["anyOf"].append({"type": "string", "pattern": r"\.[cC][sS][vV]\s*$"})
    schema["properties"]["pushes"]["anyOf"] = [
        {name: schema["properties"]["pushes"].pop(name) for name in ("type", "items")},
        schema["properties"]["poses"]["anyOf"][-1],
    ]
    return schema
