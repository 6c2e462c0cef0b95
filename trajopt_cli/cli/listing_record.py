"""A program's motions as plain data, as `trajopt parse --json` prints them; docs/parse-json.md documents every field.

Rounded so that the float32 numbers of RAPID show no noise: 0.1 is 0.1 and not 0.10000000149.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from trajopt_cli.geometry import Array
from trajopt_cli.motion import PathEvent, Program
from trajopt_cli.rapid.listing import Listing, Row
from trajopt_cli.units import MM

if TYPE_CHECKING:
    from trajopt_cli.problem.configurations import ConfigurationFinding

SCHEMA = 1
_MM, _QUATERNION, _DEG = 4, 7, 5  # digits behind the point


def listing_record(
    program: Program,
    listing: Listing,
    found: Sequence[ConfigurationFinding] | None = None,
    notes: Sequence[str] = (),
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
    return {
        "index": row.index,
        "source": str(row.source),
        "instruction": row.instruction,
        "kind": row.kind,
        "target": row.target,
        "position": _rounded(row.position, _MM),
        "orientation": _rounded(row.orientation, _QUATERNION),
        "via": _rounded(row.via, _MM),
        "joints": _rounded(row.joints, _DEG),
        "speed": row.speed,
        "v_tcp": _figure(row.v_tcp),
        "v_ori": _figure(row.v_ori),
        "v_leax": _figure(row.v_leax),
        "v_reax": _figure(row.v_reax),
        "zone": row.zone,
        "stop": row.stop,
        "criterion": row.criterion,
        "radius": _figure(row.radius),
        "effective_radius": _figure(row.effective_radius),
        "effective_angle": _figure(row.effective_angle),
        "stop_reason": row.stop_reason,
        "tool": row.tool,
        "wobj": row.wobj,
        "extax": _rounded(row.extax, _DEG),
        "extax_kept": _rounded(row.extax_kept, _DEG),
        "conf": None if row.conf is None else [*row.conf.numbers],
        "duration": _figure(row.duration),
        "value": _figure(row.value),
        "length": None if row.length is None else _round(row.length, _MM),
        "optional": row.optional,
        "settings": {word: _setting(value) for word, value in row.settings.items()},
        "events": [_event(event) for event in row.events],
        "process": dict(row.process),
        "hold": None if row.hold is None else row.hold.value,
        "constant_speed": row.constant_speed,
        "detour": list(row.detour),
        "beside": _figure(row.beside),
    }


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


def _rounded(values: Iterable[float | None] | None, digits: int) -> list[float | None] | None:
    return None if values is None else [None if value is None else _round(value, digits) for value in values]


def _figure(value: float | None) -> float | None:
    """To the seven digits a RAPID num has."""
    return None if value is None else float(f"{value:.7g}") + 0.0
