"""What a task file's values mean in SI: numbers, texts with a unit, lists of them, read anew for the judge."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import Any

from trajopt_cli.errors import InputError
from trajopt_cli.motion import Source
from trajopt_cli.yaml_file import line_of, parse, read_text

_DEG = math.pi / 180
METRE = {"m": 1.0, "cm": 1e-2, "mm": 1e-3}
RADIAN = {"rad": 1.0, "deg": _DEG, "°": _DEG}
SECOND = {"s": 1.0, "ms": 1e-3}
PLAIN = {"": 1.0}
_MOST = 1e9  # more than any number of a task
_TEXT = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*?)\s*", re.DOTALL)
_LIST = re.compile(r"\s*\[(.*)\]\s*(.*?)\s*", re.DOTALL)


def rate(units: Mapping[str, float], power: int) -> dict[str, float]:
    """Units per s, s2 or s3."""
    ends = ("/s",) if power == 1 else tuple(f"/s{sign}" for sign in (f"{power}", f"^{power}", "²³"[power - 2]))
    return {unit + end: factor for unit, factor in units.items() for end in ends}


class Written:
    """A YAML file as the judge reads it. Raises InputError with file, line and key for what it cannot use."""

    def __init__(self, path: str, what: str):
        self.file = path
        self.content, self._lines = parse(read_text(path, what), path, f"a {what} is needed")

    def refused(self, key: str, message: str) -> InputError:
        """The error about a key."""
        return InputError(f"{key}: {message}", file=self.file, line=self.line(key))

    def line(self, key: str) -> int:
        """Where a key stands."""
        return line_of(key, self._lines)

    def place(self, key: str) -> Source:
        """The same as a place."""
        return Source(self.file, self.line(key), 1)

    def at(self, key: str, default: Any = None) -> Any:
        """What stands at a dotted key."""
        value: Any = self.content
        for part in key.split("."):
            if isinstance(value, list) and part.isdigit() and int(part) < len(value):
                value = value[int(part)]
            elif isinstance(value, Mapping) and part in value:
                value = value[part]
            else:
                return default
        return value

    def section(self, key: str) -> Mapping[str, Any]:
        """A section, empty where there is none."""
        value = self.at(key, {})
        if not isinstance(value, Mapping):
            raise self.refused(key, f"needs a section, not {value!r}")
        return value

    def choice(self, key: str, *words: str) -> str:
        """One of these words, the first where the key is not given."""
        value = self.at(key, words[0])
        if value not in words:
            raise self.refused(key, f"needs {' or '.join(words)}, not {value!r}")
        return str(value)

    def number(self, key: str, value: Any, units: Mapping[str, float]) -> float:
        """A number in SI, or a text with a unit."""
        if isinstance(value, str) and (match := _TEXT.fullmatch(value)) and match[2] in units:
            value = float(match[1]) * units[match[2]]
        if isinstance(value, bool) or not isinstance(value, int | float) or not abs(value) < _MOST:
            known = ", ".join(unit for unit in units if unit)
            wanted = f"a number, or a text with one of {known}" if known else "a number"
            raise self.refused(key, f"needs {wanted}, not {value!r}")
        return float(value)

    def numbers(self, key: str, value: Any, units: Mapping[str, float], count: int) -> list[float]:
        """A list of them, or a text `"[...] unit"`."""
        if isinstance(value, str) and (match := _LIST.fullmatch(value)):
            value = [f"{item} {match[2]}" for item in match[1].split(",")]
        if not isinstance(value, list) or len(value) != count:
            raise self.refused(key, f"needs a list of {count} numbers, not {value!r}")
        return [self.number(key, item, units) for item in value]
