"""Offsets from where things stand: `place.base.x`, `place.rail.height`, `place.TABLE.yaw`, `target.P10.z` [m, rad]."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.exporters.rapid_text import plain
from trajopt_cli.job import Job
from trajopt_cli.motion import TextFile
from trajopt_cli.parameter_study.cell_keys import PLACE, TARGET
from trajopt_cli.quantity import complain
from trajopt_cli.rapid.language.parser import parse_module
from trajopt_cli.rapid.language.syntax import Aggregate, DataDeclaration
from trajopt_cli.study.places import Range, What, site_of
from trajopt_cli.units import MM
from trajopt_cli.validation import hint

_AXES = ("x", "y", "z")


def check_offset(key: str) -> None:
    """Raise PydanticCustomError for a key that is none."""
    kind, *name, axis = key.split(".")
    if len(name) != 1 or (kind == TARGET and axis not in (*_AXES, "*")):
        known = "place.base.x, place.rail.height, place.WORK_OBJECT.yaw, target.ROBTARGET.z"
        raise complain(f"is no offset; write it as in {known}")


def target_names(files: Sequence[TextFile]) -> list[str]:
    """The robtargets that are declared with their position in numbers."""
    return [declared.name for file in files for declared, _ in _targets(file)]


def shifted(files: Sequence[TextFile], values: Mapping[str, float]) -> list[TextFile]:
    """Program texts with robtargets elsewhere. values: by key, along the axes of each one's work object [m].

    Raises InputError for a robtarget that no text declares.
    """
    wanted = {tuple(key.lower().split(".")[1:]): value for key, value in values.items() if key.startswith(TARGET)}
    out, found = [], set()
    for file in files if wanted else ():
        text = file.text
        for declared, position in reversed([*_targets(file)]):
            name = declared.name.lower()
            off = [wanted.get((name, axis), 0.0) for axis in _AXES]
            found.add(name)
            if any(off):
                moved = np.array(position.numbers, dtype=float) + np.array(off) / MM
                text = f"{text[: position.start]}[{','.join(map(plain, moved))}]{text[position.end :]}"
        out.append(replace(file, text=text))
    for name, _ in wanted:
        if name not in found:
            raise InputError(f"no module declares robtarget {name} in numbers; {hint(name, target_names(files))}")
    return out or [*files]


def placed(job: Job, values: Mapping[str, float]) -> Job:
    """A job with its base, rail and work objects elsewhere. values: by key. Raises InputError as site_of does."""
    ranges: dict[str, list[Range]] = {}
    for key, value in values.items():
        kind, name, axis = key.split(".")
        if kind == PLACE:
            what = name if name in (What.BASE, What.RAIL) else f"{What.STATION}:{name}"
            ranges.setdefault(what, []).append(Range(axis, value, value))
    for what, some in ranges.items():
        job = site_of(job, what, tuple(some)).at(tuple(one.low for one in some))
    return job


def _targets(file: TextFile) -> Iterator[tuple[DataDeclaration, Aggregate]]:
    """Robtargets of a text with their positions in it, in its order."""
    for module in parse_module(file.text, file.path).modules:
        for item in module.items:
            if isinstance(item, DataDeclaration) and item.type.lower() == "robtarget":
                position = item.value.items[0] if isinstance(item.value, Aggregate) and item.value.items else None
                if isinstance(position, Aggregate) and len(position.numbers or ()) == len(_AXES):
                    yield item, position
