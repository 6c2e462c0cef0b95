"""A program's motions as plain data, as `trajopt parse --json` prints them; docs/parse-json.md documents every field.

Rounded so that the float32 numbers of RAPID show no noise: 0.1 is 0.1 and not 0.10000000149.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import fields
from typing import TYPE_CHECKING, Any

from trajopt_cli.geometry import Array
from trajopt_cli.motion import ConfData, Hold, PathEvent, Program, Source
from trajopt_cli.rapid.listing import Listing, Row
from trajopt_cli.units import MM

if TYPE_CHECKING:
    from trajopt_cli.problem.configurations import ConfigurationFinding

SCHEMA = 1
_MM, _QUATERNION, _DEG = 4, 7, 5  # digits behind the point
_DIGITS = {
    **dict.fromkeys(("position", "via", "length"), _MM),
    **dict.fromkeys(("joints", "extax", "extax_kept"), _DEG),
    "orientation": _QUATERNION,
}


def listing_record(
    program: Program, listing: Listing, found: Sequence[ConfigurationFinding] | None = None, notes: Sequence[str] = ()
) -> dict[str, Any]:
    """The listing as plain data without NaN; mm, deg, mm/s, s, quaternions scalar first.

    found: what the robot cannot do as confdata says, None where nobody asked a robot. notes: what the text below the
    table says.
    """
    return {
        "schema": SCHEMA,
        "program": program.name,
        "files": list(program.files),
        "entry": program.entry,
        "motions": [row_record(row) for row in listing.rows],
        "line_length": _round(listing.line_length, _MM),
        "arc_length": _round(listing.arc_length, _MM),
        "unmeasured": listing.unmeasured,
        "fly_by_zones": listing.fly_by,
        "ignored": dict(program.ignored),
        "uncalled": list(program.uncalled),
        "notes": list(notes),
        "warnings": [str(warning) for warning in program.warnings],
        "configurations": None if found is None else [_finding(one) for one in found],
    }


def json_text(record: Mapping[str, Any]) -> str:
    """A record as JSON with a line for each motion and finding, so that it can be searched and compared by lines."""
    parts = []
    for key, value in record.items():
        objects = isinstance(value, list) and value and isinstance(value[0], dict)
        lines = ",\n    ".join(_dumps(one) for one in value) if objects else ""
        parts.append(f"  {_dumps(key)}: " + (f"[\n    {lines}\n  ]" if objects else _dumps(value)))
    return "{\n" + ",\n".join(parts) + "\n}"


def _dumps(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def row_record(row: Row) -> dict[str, Any]:
    """One motion; every key is always there, null where the motion has no such part."""
    parts = {one.name: _plain(getattr(row, one.name), _DIGITS.get(one.name)) for one in fields(row)}
    return parts | {
        "index": row.index,
        "settings": {word: _setting(value) for word, value in row.settings.items()},
        "events": [_event(event) for event in row.events],
        "process": dict(row.process),
    }


def _plain(value: Any, digits: int | None) -> Any:
    """A part of a motion; numbers to so many digits behind the point, None: to the seven that a RAPID num has."""
    match value:
        case Source():  # a tuple, too
            return str(value)
        case tuple():
            return [_plain(one, digits) for one in value]
        case ConfData():
            return [*value.numbers]
        case Hold():
            return value.value
        case float() | int() if not isinstance(value, bool):
            return _figure(value) if digits is None else _round(value, digits)
    return value


def _rails(d: Array) -> float | list[float]:
    """Rail positions (r,) in mm: of one a number, of several a list."""
    each = [_round(value / MM, _MM) for value in d.tolist()]
    return each[0] if len(each) == 1 else each


def _finding(one: ConfigurationFinding) -> dict[str, Any]:
    return {
        "index": one.index,
        "source": str(one.source),
        "motion": one.motion,
        "misfit": one.misfit.value,
        "conf": [*one.programmed.numbers],
        "reachable": [[*conf.numbers] for conf in one.reachable],
        "rail": None if one.rail is None else _rails(one.rail),
        "message": one.message,
    }


def _event(event: PathEvent) -> dict[str, Any]:
    return {
        "kind": event.kind.value,
        "name": event.name,
        "value": _figure(event.value),
        "distance": _figure(event.distance / MM),
        "time": _figure(event.time),
        "from_start": event.from_start,
    }


def _setting(value: Any) -> Any:
    if isinstance(value, Sequence) and not isinstance(value, str):
        return [_setting(one) for one in value]
    return _figure(value) if isinstance(value, float) else value


def _round(value: float, digits: int) -> float:
    return round(value, digits) + 0.0  # takes the sign off a zero


def _figure(value: float | None) -> float | None:
    """To the seven digits a RAPID num has."""
    return None if value is None else float(f"{value:.7g}") + 0.0
