"""Numbers with units as cell files write them: a plain number is SI, a text carries its unit, `"30 deg"`."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Mapping
from typing import Any

from pydantic_core import PydanticCustomError

from trajopt_cli.errors import InputError
from trajopt_cli.units import DEG, MM

LENGTH = {"m": 1.0, "cm": 1e-2, "mm": MM}
ANGLE = {"rad": 1.0, "deg": DEG, "°": DEG}
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

_LIST = re.compile(r"\[(?P<items>[^\[\]]*)\]\s*(?P<unit>.*)", re.DOTALL)
# DOTALL: a match that a line break ends would be tried anew for every digit before it
_SCALAR = re.compile(r"(?P<number>[-+]?(\d+(\.\d*)?|\.\d+)([eE][-+]?\d+)?)\s*(?P<unit>.*)", re.DOTALL)


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
    if not any(units):
        raise complain(f"{shown(text)} has a unit; needs a plain number")
    known = ", ".join(name for name in units if name)
    if unit:
        raise complain(f"unit {_bare_word(unit)} of {shown(text)} is not one of {known}")
    raise complain(f"{shown(text)} lacks a unit: {known}")


def _finite(value: float, given: object) -> float:
    if not math.isfinite(value):
        raise complain(f"needs a finite number, not {given if isinstance(given, float) else shown(given)}")
    return value


def number(units: Mapping[str, float]) -> Callable[[Any], float]:
    """A validator: a finite number in SI, or a text with one of units (name to factor), to a float in SI."""

    def validate(value: Any) -> float:
        if isinstance(value, str):
            match = _SCALAR.fullmatch(value.strip())
            if match is None:
                raise complain(f"needs a number, not {shown(value)}")
            return _finite(float(match["number"]) * _factor(match["unit"].strip(), units, value), value)
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise complain(f"needs a number, not {shown(value)}")
        try:
            return _finite(float(value), value)
        except OverflowError:
            raise complain(f"needs a finite number, not {shown(value)}") from None

    return validate


def numbers(units: Mapping[str, float], count: int | None = None) -> Callable[[Any], tuple[float, ...]]:
    """A validator: a list whose items number(units) takes, or a text `"[..] unit"`; count items where given."""
    one = number(units)

    def validate(value: Any) -> tuple[float, ...]:
        items: list[Any]
        if isinstance(value, str) and (match := _LIST.fullmatch(value.strip())):
            unit = match["unit"].strip()
            if not unit and "" not in units:
                known = ", ".join(units)
                raise complain(f"{shown(value)} lacks a unit: {known}; without one, remove the quotes")
            factor = _factor(unit, units, value)
            items = [_bare(item, value) * factor for item in match["items"].split(",")]
        elif isinstance(value, list):
            items = value
        else:
            raise not_a_list(value, f"a list of {count} numbers" if count else "a list of numbers")
        if count is not None and len(items) != count:
            raise complain(f"needs {count} numbers, not {len(items)}")
        return tuple(one(item) for item in items)

    return validate


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


def positive(units: Mapping[str, float]) -> Callable[[Any], float]:
    """A validator: as number, above zero."""
    return lambda value: above_zero(number(units)(value))


def from_zero(units: Mapping[str, float]) -> Callable[[Any], float]:
    """A validator: as number, zero or more."""
    return lambda value: not_negative(number(units)(value))


def option_value(text: str, units: Mapping[str, float], option: str) -> float:
    """A command line's number with one of units, above zero, in SI. Raises InputError naming the option."""
    try:
        value = number(units)(text)
    except PydanticCustomError as error:
        raise InputError(f"{option}: {error.message()}") from error
    if value <= 0:
        raise InputError(f"{option}: needs a number above zero, not {_short(text)}")
    return value


def _bare(item: str, text: str) -> float:
    match = _SCALAR.fullmatch(item.strip())
    if match is None or match["unit"]:
        said = f"{shown(text)} holds {_bare_word(item)}"
        raise complain(f"{said}, not a number; the unit stands once, after the list")
    return float(match["number"])
