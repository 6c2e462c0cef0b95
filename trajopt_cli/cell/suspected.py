"""Numbers without a unit that look like another one: 30 as an angle is 30 rad, and was hardly meant."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from trajopt_cli.errors import InputError, InputErrorGroup
from trajopt_cli.units import DEG, MM
from trajopt_cli.warnings import ProgramWarning, WarningKind
from trajopt_cli.yaml_file import line_of


@dataclass(frozen=True)
class Kind:
    """What a bare number is read as and may have been meant as, the latter's size in the former, and two sizes: beyond
    odd somebody may have meant the other unit, beyond absurd nothing else is possible."""

    unit: str
    other: str
    factor: float
    odd: float
    absurd: float


ANGLE = Kind("rad", "deg", DEG, 7, 4 * math.pi + 1e-3)  # ranges of 400 deg are common, two turns are the most
TURN_RATE = Kind("rad/s", "deg/s", DEG, 20, 1e3)  # the fastest wrists turn with 10
TURN_ACCELERATION = Kind("rad/s2", "deg/s2", DEG, 500, 1e5)
LENGTH = Kind("m", "mm", MM, 20, 100)
SPEED = Kind("m/s", "mm/s", MM, 12, 1e3)
ACCELERATION = Kind("m/s2", "mm/s2", MM, 200, 1e5)

TABLE = Kind("rad", "deg", DEG, 7, 1e4)  # turning tables go round and round

# By the path of the key, * for any name.
_BODY: dict[tuple[str, ...], Kind] = {
    ("*", "position"): LENGTH,
    ("*", "size"): LENGTH,
    ("*", "rpy"): ANGLE,
    ("capsule", "*"): LENGTH,
    ("fence", "*"): LENGTH,
}
_AXIS: dict[tuple[str, ...], Kind] = {
    ("frame", "position"): LENGTH,
    ("frame", "rpy"): ANGLE,
    ("range",): TABLE,
    ("start",): TABLE,
    ("velocity",): TURN_RATE,
    ("acceleration",): TURN_ACCELERATION,
}
CELL: dict[tuple[str, ...], Kind] = {
    ("start", "joints"): ANGLE,
    ("rail", "stroke"): LENGTH,
    ("rail", "frame", "position"): LENGTH,
    ("rail", "frame", "rpy"): ANGLE,
    ("base", "position"): LENGTH,
    ("base", "rpy"): ANGLE,
    ("limits", "rail", "velocity"): SPEED,
    ("limits", "rail", "acceleration"): ACCELERATION,
    ("limits", "*", "lower"): ANGLE,
    ("limits", "*", "upper"): ANGLE,
    ("limits", "*", "velocity"): TURN_RATE,
    ("limits", "*", "acceleration"): TURN_ACCELERATION,
    ("tcp", "speed"): SPEED,
    ("tcp", "acceleration"): ACCELERATION,
    ("clearance",): Kind("m", "mm", MM, 1, 100),
    ("tool_radius",): Kind("m", "mm", MM, 1, 100),
    ("rail", "track", "*"): Kind("m", "mm", MM, 3, 100),
    **{("positioners", "*", *several, *path): kind for several in ((), ("*",)) for path, kind in _AXIS.items()},
    **{(of, "*", *path): kind for of in ("obstacles", "attached") for path, kind in _BODY.items()},
}
TASK: dict[tuple[str, ...], Kind] = {
    ("start", "joints"): ANGLE,
    ("v_max",): SPEED,
    ("omega_max",): TURN_RATE,
    ("a_max",): ACCELERATION,
    ("epsilon_max",): TURN_ACCELERATION,
}


def suspected(
    content: Any, rules: Mapping[tuple[str, ...], Kind], lines: Mapping[str, int], file: str
) -> tuple[ProgramWarning, ...]:
    """A word on every bare number that is odd for what it stands for. content: a file's, as YAML gives it.

    Raises InputError where one is absurd.
    """
    odd: list[ProgramWarning] = []
    absurd: list[InputError] = []
    for path, value in _values(content, ()):
        kind = next((kind for rule, kind in rules.items() if _fits(rule, path)), None)
        if kind is None:
            continue
        numbers = [one for one in (value if isinstance(value, list) else [value]) if _is_number(one)]
        most = max(numbers, key=abs, default=0)
        if abs(most) <= kind.odd:
            continue
        key = ".".join(path)
        line = line_of(key, lines)
        said = _said(key, value, most, kind)
        if abs(most) > kind.absurd:
            absurd.append(InputError(said, file=file, line=line))
        else:
            odd.append(ProgramWarning(WarningKind.DOUBTFUL, said, f"{file}:{line}"))
    if absurd:
        raise absurd[0] if len(absurd) == 1 else InputErrorGroup(absurd)
    return tuple(odd)


def _said(key: str, value: Any, most: float, kind: Kind) -> str:
    """The value as written, what it is, and how the other unit is written: "[0, 30] deg"."""
    written = f"[{', '.join(f'{one:g}' for one in value)}]" if isinstance(value, Sequence) else f"{value:g}"
    is_ = f"{most:g} without a unit is {most:g} {kind.unit}, {most / kind.factor:.6g} {kind.other}"
    return f'{key}: {is_}; if {kind.other} are meant, write "{written} {kind.other}"'


def _values(content: Any, path: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], Any]]:
    """Numbers and lists of nothing else, by their path."""
    if isinstance(content, dict):
        for key, value in content.items():
            yield from _values(value, (*path, str(key)))
    elif isinstance(content, list) and any(isinstance(one, dict) for one in content):
        for i, one in enumerate(content):
            yield from _values(one, (*path, str(i)))
    elif _is_number(content) or (isinstance(content, list) and content and all(map(_is_number, content))):
        yield path, content


def _fits(rule: Sequence[str], path: Sequence[str]) -> bool:
    return len(rule) == len(path) and all(a in ("*", b) for a, b in zip(rule, path, strict=True))


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)
