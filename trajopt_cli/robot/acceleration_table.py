"""Reads a table of accelerations by posture: a CSV file beside the robot's file.

    joint_2 [rad],joint_3 [rad],joint_1 negative [rad/s2],joint_1 positive [rad/s2],joint_2 [rad/s2]
    -1.1,-3.1,10.6,10.6,6.1

The first columns are the posture, the others what axes may have there: of each sign, or of both at once. The rows are
all places of a grid, in any order.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from itertools import product
from pathlib import Path

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array
from trajopt_cli.limits import AccelerationTable
from trajopt_cli.units import DEG
from trajopt_cli.validation import short
from trajopt_cli.yaml_file import read_text

_HEAD = re.compile(r"(?P<axis>\w+)(?: (?P<sign>negative|positive))? \[(?P<unit>[a-z]+)(?P<rate>/s2)?\]")
_UNITS = {"rad": 1.0, "m": 1.0, "deg": DEG}
_WANTED = "wanted 'joint_2 [rad]' of the posture, then 'joint_1 negative [rad/s2]' and 'joint_1 positive [rad/s2]'"


def read_acceleration_table(path: Path, rails: Mapping[str, bool]) -> AccelerationTable:
    """The table in a file. rails: of each axis by name whether it is one. Raises InputError with the line of what is
    wrong."""
    file, lines = str(path), enumerate(read_text(path, "table").split("\n"), 1)
    rows = [(i, line.split(",")) for i, line in lines if line.strip()]
    if len(rows) < 2:
        raise InputError(f"the table has no rows; {_WANTED}", file=file, line=1)
    (line, head), *body = rows
    over, limited, factors = list[str](), dict[tuple[str, str], int](), list[float]()
    for k, title in enumerate(head):
        found = _HEAD.fullmatch(title.strip())
        if found is None or found["unit"] not in _UNITS or not (found["rate"] or not (found["sign"] or limited)):
            raise InputError(f"column '{short(title)}' is not one of a table; {_WANTED}", file=file, line=line)
        axis = found["axis"]
        if axis not in rails:
            known = ", ".join(rails)
            raise InputError(f"column '{short(title)}': no such axis; wanted {known}", file=file, line=line)
        if rails[axis] != (found["unit"] == "m"):
            wanted = "m" if rails[axis] else "rad or deg"
            raise InputError(f"column '{short(title)}': wanted {wanted} of this axis", file=file, line=line)
        keys = [(axis, sign) for sign in ([found["sign"]] if found["sign"] else ["negative", "positive"])]
        if axis in over if not found["rate"] else any(key in limited for key in keys):
            raise InputError(f"column '{short(title)}' stands twice; remove one", file=file, line=line)
        if found["rate"]:
            limited.update(dict.fromkeys(keys, k))
        else:
            over.append(axis)
        factors.append(_UNITS[found["unit"]])
    axes = tuple(dict.fromkeys(axis for axis, _ in limited))
    lacks = [f"{axis} {sign}" for axis in axes for sign in ("negative", "positive") if (axis, sign) not in limited]
    if lacks or not axes or not over:
        raise InputError(f"the table lacks {', '.join(lacks) or 'columns'}; {_WANTED}", file=file, line=line)
    values = _numbers(body, len(head), file) * factors
    if np.any(bad := ~(values[:, len(over) :] > 0)):
        row, column = (int(at[0]) for at in np.nonzero(bad))
        value = values[row, len(over) + column]
        raise InputError(f"acceleration {value:g}, wanted one above 0", file=file, line=body[row][0])
    postures = [tuple(row) for row in values[:, : len(over)].tolist()]
    seen = dict[tuple[float, ...], int]()
    for posture, (at_line, _) in zip(postures, body, strict=True):
        if (before := seen.setdefault(posture, at_line)) != at_line:
            raise InputError(f"the posture of line {before} again; remove one of them", file=file, line=at_line)
    places = [np.unique(values[:, k]) for k in range(len(over))]
    shape = tuple(map(len, places))
    lacking = next((one for one in product(*places) if one not in seen), None)
    if min(shape) < 2 or lacking is not None:
        message = f"{len(values)} rows are no grid of {' x '.join(map(str, shape))} places; wanted two or more of each"
        if lacking is not None:
            where = ", ".join(f"{title.strip()} {x / k:g}" for title, x, k in zip(head, lacking, factors, strict=False))
            message += f" and every pair of them, here also {where}"
        raise InputError(message, file=file, line=line)
    at = tuple(np.searchsorted(one, values[:, k]) for k, one in enumerate(places))
    sides = list[Array]()
    for sign in ("negative", "positive"):
        side = np.empty((*shape, len(axes)))
        side[at] = values[:, [limited[axis, sign] for axis in axes]]
        sides.append(side)
    return AccelerationTable(axes, tuple(over), tuple(places), sides[0], sides[1], path)


def _numbers(body: list[tuple[int, list[str]]], columns: int, file: str) -> Array:
    out = np.empty((len(body), columns))
    for k, (line, row) in enumerate(body):
        if len(row) != columns:
            raise InputError(f"{len(row)} values, wanted {columns}", file=file, line=line)
        for j, text in enumerate(row):
            try:
                out[k, j] = float(text)
            except ValueError:
                out[k, j] = np.nan
            if not np.isfinite(out[k, j]) or "_" in text or not text.isascii():
                raise InputError(f"'{short(text)}' is not a number", file=file, line=line)
    return out
