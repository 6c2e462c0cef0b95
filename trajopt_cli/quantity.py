"""Numbers with units as cell files write them: a plain number is SI, a text carries its unit, `"30 deg"`."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Generic, TypeVar

from pydantic_core import PydanticCustomError

from trajopt_cli.errors import InputError
from trajopt_cli.units import DEG, MM

FARTHEST = 1e12  # m: lengths beyond it overflow where they are multiplied a few times
LENGTH = {"m": 1.0, "cm": 1e-2, "mm": MM}
ANGLE = {"deg": DEG, "rad": 1.0, "°": DEG}  # people write degrees: what a message names first
FORCE = {"N": 1.0, "kN": 1e3}
MOMENT = {"Nm": 1.0}
TIME = {"s": 1.0, "ms": 1e-3}
RATIO = {"": 1.0}


def _per(base: Mapping[str, float], *endings: str) -> dict[str, float]:
    return {unit + ending: factor for unit, factor in base.items() for ending in endings}


SPEED = _per(LENGTH, "/s")
TURN_RATE = _per(ANGLE, "/s")
ACCELERATION = _per(LENGTH, "/s2", "/s^2", "/s²")
TURN_ACCELERATION = _per(ANGLE, "/s2", "/s^2", "/s²")
JERK = _per(LENGTH, "/s3", "/s^3", "/s³")
TURN_JERK = _per(ANGLE, "/s3", "/s^3", "/s³")


def units_of(unit: str) -> dict[str, float]:
    """The units in which a quantity of this SI unit may be written, by their factors."""
    every = (SPEED, TURN_RATE, ACCELERATION, TURN_ACCELERATION, JERK, TURN_JERK, FORCE, MOMENT)
    return next(units for units in every if unit in units)


_LIST = re.compile(r"\[(?P<items>[^\[\]]*)\]\s*(?P<unit>.*)", re.DOTALL)
# DOTALL: a match that a line break ends would be tried anew for every digit before it
_SCALAR = re.compile(r"(?P<number>[-+]?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][-+]?[0-9]+)?)\s*(?P<unit>.*)", re.DOTALL)


_Read = TypeVar("_Read")


@dataclass(frozen=True, eq=False)
class Reader(Generic[_Read]):
    """A validator that also says what it takes, as JSON schema for editors, who look before it is read; units: of the
    number or numbers that it reads, by factor, empty where it reads something else."""

    read: Callable[[Any], _Read]
    takes: dict[str, Any]
    units: Mapping[str, float] = field(default_factory=dict)

    def __call__(self, value: Any) -> _Read:
        """What read makes of value; raises its PydanticCustomError."""
        return self.read(value)


def takes_number(units: Mapping[str, float], **bounds: float) -> dict[str, Any]:
    """JSON schema of what number(units) takes. bounds: JSON schema's own, held for plain numbers alone."""
    return {"anyOf": [{"type": "number", **bounds}, {"type": "string", "pattern": f"^\\s*{_DIGITS}{_unit(units)}$"}]}


_DIGITS = r"[-+]?(\d+(\.\d*)?|\.\d+)([eE][-+]?\d+)?"


def _unit(units: Mapping[str, float]) -> str:
    names = "|".join(unit.replace("^", r"\^") for unit in units)
    return f"\\s*({names})\\s*"


def complain(text: str) -> PydanticCustomError:
    """A validation error whose message is text, word for word."""
    return PydanticCustomError("cell", "{text}", {"text": text})


def shown(value: object) -> str:
    """A value that a file gave, in words or as YAML writes it: nothing, true, a section, a list, "text", 1.5."""
    match value:
        case None:
            return "nothing"
        case bool():
            return str(value).lower()
        case dict():
            return "a section"
        case list():
            return "a list"
        case str():
            return json.dumps(_short(value), ensure_ascii=False)
        case int() if value.bit_length() > 64:  # Python prints no more than 4300 digits, a line takes fewer
            return f"a number of about {math.ceil(value.bit_length() * math.log10(2))} digits"
    return str(value)


def not_a_list(value: object, wanted: str) -> PydanticCustomError:
    """The error of a value where wanted ("a list of 6 values") is; a list in quotes is told so."""
    quoted = isinstance(value, str) and value.strip().startswith("[")
    return complain(f"needs {wanted}, not {shown(value)}{'; remove the quotes' if quoted else ''}")


def _short(text: str) -> str:
    return text if len(text) <= 60 else f"{text[:57]}..."


def _bare_word(text: str) -> str:
    return f"'{_short(' '.join(text.split()))}'"


def _factor(unit: str, units: Mapping[str, float], text: str) -> float:
    if unit in units:
        return units[unit]
    if unit.startswith("_"):
        raise complain(f"{shown(text)} has '_' in a number; leave it out")
    if not any(units):
        raise complain(f"{shown(text)} has a unit; needs a plain number")
    if unit:
        known = ", ".join(name for name in units if name)
        raise complain(f"unit {_bare_word(unit)} of {shown(text)} is not one of {known}")
    raise lacks_unit(text, units)


def lacks_unit(text: str, units: Mapping[str, float]) -> PydanticCustomError:
    """The error of a text without a unit: how it is written with the first of units, and the others."""
    first, *others = (name for name in units if name)
    others_too = f" ({', '.join(others)} are read, too)" if others else ""
    return complain(f"{shown(text)} lacks a unit: write {shown(f'{text.strip()} {first}')}{others_too}")


def _finite(value: float, given: object) -> float:
    if not math.isfinite(value):
        raise complain(f"needs a finite number, not {given if isinstance(given, float) else shown(given)}")
    return value


def number(units: Mapping[str, float]) -> Reader[float]:
    """A validator: a finite number in SI, or a text with one of units (name to factor), to a float in SI."""

    def within(length: float) -> float:
        if units is LENGTH and abs(length) > FARTHEST:
            raise complain(f"needs a length within {FARTHEST:g} m, not {length:g} m; check its digits and unit")
        return length

    def validate(value: Any) -> float:
        if isinstance(value, str):
            match = _SCALAR.fullmatch(value.strip())
            if match is None:
                raise complain(f"needs a number, not {shown(value)}")
            return within(_finite(float(match["number"]) * _factor(match["unit"].strip(), units, value), value))
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise complain(f"needs a number, not {shown(value)}")
        try:
            return within(_finite(float(value), value))
        except OverflowError:
            raise complain(f"needs a finite number, not {shown(value)}") from None

    return Reader(validate, takes_number(units), units)


def numbers(units: Mapping[str, float], count: int | None = None) -> Reader[tuple[float, ...]]:
    """A validator: a list whose items number(units) takes, or a text `"[..] unit"`; count items where given."""
    one = number(units)

    def validate(value: Any) -> tuple[float, ...]:
        items: list[Any]
        if isinstance(value, str) and (match := _LIST.fullmatch(value.strip())):
            unit = match["unit"].strip()
            if not unit and "" not in units:
                raise lacks_unit(value, units)
            factor = _factor(unit, units, value)
            items = [_bare(item, value) * factor for item in match["items"].split(",")]
        elif isinstance(value, list):
            items = value
        else:
            raise not_a_list(value, f"a list of {count} numbers" if count else "a list of numbers")
        if count is not None and len(items) != count:
            raise complain(f"needs {count} numbers, not {len(items)}")
        return tuple(one(item) for item in items)

    length = {} if count is None else {"minItems": count, "maxItems": count}
    text = {"type": "string", "pattern": f"^\\s*\\[[^\\[\\]]*\\]{_unit(units)}$"}
    return Reader(validate, {"anyOf": [{"type": "array", "items": one.takes, **length}, text]}, units)


def above_zero(value: float) -> float:
    """A validator: the number itself, which has to be above zero."""
    if value <= 0:
        raise complain(f"needs a number above zero, not {value:g}")
    return value


def not_negative(value: float) -> float:
    """A validator: the number itself, which may be zero."""
    if value < 0:
        raise complain(f"cannot be negative: {value:g}")
    return value


def positive(units: Mapping[str, float]) -> Reader[float]:
    """A validator: as number, above zero."""
    return Reader(lambda value: above_zero(number(units)(value)), takes_number(units, exclusiveMinimum=0), units)


def from_zero(units: Mapping[str, float]) -> Reader[float]:
    """A validator: as number, zero or more."""
    return Reader(lambda value: not_negative(number(units)(value)), takes_number(units, minimum=0), units)


def option_value(text: str, units: Mapping[str, float], option: str) -> float:
    """A command line's number with one of units, above zero, in SI. Raises InputError naming the option."""
    try:
        value = number(units)(text)
    except PydanticCustomError as error:
        raise InputError(f"{option}: {error.message()}") from error
    if value <= 0:
        raise InputError(f"{option}: needs a number above zero, not {_short(text)}")
    return value


def option_number(text: str, units: Mapping[str, float], option: str) -> float:
    """A command line's number in SI: with one of units, or plain. Raises InputError naming the option."""
    plain = _SCALAR.fullmatch(text.strip())
    try:
        return number(units)(float(text) if plain is not None and not plain["unit"] else text)
    except PydanticCustomError as error:
        raise InputError(f"{option}: {error.message()}") from error


def _bare(item: str, text: str) -> float:
    match = _SCALAR.fullmatch(item.strip())
    if match is None or match["unit"]:
        said = f"{shown(text)} holds {_bare_word(item)}"
        raise complain(f"{said}, not a number; the unit stands once, after the list")
    return float(match["number"])
