"""Keys of a cell file by their dotted path: the units of a number there, of an offset, too; its value, and the file
with another one."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Annotated, Any, get_args, get_origin, get_type_hints

from pydantic import BaseModel, BeforeValidator

from trajopt_cli.cell.document import CellDocument
from trajopt_cli.quantity import ANGLE, LENGTH, Reader, number, numbers
from trajopt_cli.study.places import YAW

Data = dict[str, Any]
"""A cell file as yaml_file.parse gives it."""

PLACE, TARGET = "place", "target"
SOURCE = "varied by a study"
"""The source of a limit that the cell file does not give itself."""
_ITEMS = {"low": 0, "high": 1, "x": 0, "y": 1, "z": 2}
_ENDS, _AXES = ("low", "high"), ("x", "y", "z")


def is_offset(path: str) -> bool:
    """Whether a key names an offset, not a key of the cell file."""
    return path.split(".")[0] in (PLACE, TARGET)


def units_at(path: str) -> Mapping[str, float]:
    """The units that a number at a key may have, by factor; empty where no number with a unit belongs."""
    if is_offset(path):
        return ANGLE if path.split(".")[-1] == YAW else LENGTH
    kinds: list[Any] = [CellDocument]
    for part in path.split("."):
        inner = [one for kind in kinds for one in _inside(kind, part)]
        kinds = inner or (kinds if _item(part) is not None else [])
    return next((reader.units for kind in kinds for reader in _readers(kind)), {})


def si_unit(units: Mapping[str, float]) -> str:
    """The SI unit among units; empty for none."""
    return next((name for name, factor in units.items() if factor == 1.0), "")


def in_si(value: Any, units: Mapping[str, float]) -> Any:
    """A value with its numbers in SI; as it is where it is no number with one of these units."""
    if isinstance(value, str) and units and any(sign.isdigit() for sign in value):
        return list(numbers(units)(value)) if value.lstrip().startswith("[") else number(units)(value)
    return value


def value_at(data: Data, path: str) -> Any:
    """What stands at a key, numbers in SI; None where nothing does."""
    value: Any = data
    parts = path.split(".")
    for i, part in enumerate(parts):
        value = in_si(value, units_at(".".join(parts[:i]))) if isinstance(value, str) else value
        item = _item(part)
        if isinstance(value, dict):
            value = value.get(part)
        elif isinstance(value, list) and item is not None and item < len(value):
            value = value[item]
        else:
            return None
    return in_si(value, units_at(path))


def put(data: Data, path: str, value: Any) -> None:
    """Change what stands at a key; sections on the way are made, a limit's with its source."""
    parts, inner = path.split("."), data
    for i, part in enumerate(parts[:-1]):
        here = ".".join(parts[: i + 1])
        key: Any = part if isinstance(inner, dict) else _item(part)
        known = inner.get(key) if isinstance(inner, dict) else inner[key]
        known = in_si(known, units_at(here)) if isinstance(known, str) else known
        empty: Any = [0.0] * 3 if parts[i + 1] in _AXES else {}
        inner[key] = known if isinstance(known, dict | list) else empty
        inner = inner[key]
    if isinstance(inner, list):
        inner[_item(parts[-1]) or 0] = value
        return
    inner[parts[-1]] = value
    if parts[0] == "limits" and len(parts) == 3:
        inner.setdefault("source", SOURCE)


def leaves(path: str, value: Any) -> Iterator[tuple[str, str, Any]]:
    """The single values of a section or a list at a key: the name of each one's column, its SI unit, the value."""
    units = units_at(path)
    value = in_si(value, units)
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from leaves(f"{path}.{key}", inner)
    elif isinstance(value, list):
        names = {2: _ENDS, 3: _AXES}.get(len(value), tuple(str(i + 1) for i in range(len(value))))
        for name, inner in zip(names, value, strict=True):
            yield f"{path}_{name}", si_unit(units), inner
    else:
        head, _, last = path.rpartition(".")
        item = _item(last) is not None and not is_offset(path)
        yield (f"{head}_{last}" if item else path), si_unit(units), value


def _item(part: str) -> int | None:
    return int(part) if part.isdecimal() else _ITEMS.get(part)


def _inside(kind: Any, part: str) -> Iterator[Any]:
    """The types of what may stand at a key of a value of this type."""
    if isinstance(kind, type) and issubclass(kind, BaseModel):
        fields = {field.alias or name: field for name, field in kind.model_fields.items()}
        if part in fields:
            yield tuple[Annotated[(fields[part].annotation, *fields[part].metadata, None)]]  # type: ignore[misc]
        elif extra := get_type_hints(kind, include_extras=True).get("__pydantic_extra__"):
            yield get_args(extra)[1]
    elif get_origin(kind) is dict:
        yield get_args(kind)[1]
    else:
        for one in get_args(kind):
            yield from _inside(one, part)


def _readers(kind: Any) -> Iterator[Reader[Any]]:
    """The readers of numbers with units that a value of this type may meet."""
    if isinstance(kind, BeforeValidator):
        if isinstance(kind.func, Reader) and kind.func.units:
            yield kind.func
        yield from _readers(kind.json_schema_input_type)
    for one in get_args(kind) if get_origin(kind) is not dict else ():
        yield from _readers(one)
