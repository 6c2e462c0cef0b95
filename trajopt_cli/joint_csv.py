"""Joint trajectories as CSV: one row per instant, the unit in every column's head, 17 digits.

`t [s],rail [m],joint_1 [rad],...,joint_6 [rad]`, then, if the file has them, the speeds in the same order:
`rail speed [m/s],joint_1 speed [rad/s],...`. A file of somebody else may also use mm and deg. Behind the robot's axes
stand those of positioners that turn, by their external axes: `eax_b [rad]`. Text in, nouns out; where the text lives is
the caller's business.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import islice
from typing import Any, TextIO

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.geometry import Array
from trajopt_cli.printed import Digits
from trajopt_cli.trajectory import Trajectory
from trajopt_cli.units import DEG, MM

_TIME = "t [s]"
_SI = {"m": 1.0, "mm": MM, "rad": 1.0, "deg": DEG}
_POSITION = re.compile(r"(?P<name>\w+) \[(?P<unit>m|mm|rad|deg)\]")
_SPEED = re.compile(r"(?P<name>\w+) speed \[(?P<unit>m|mm|rad|deg)/s\]")
FARTHEST = 1e9  # s, m, rad, m/s, rad/s: of any axis; more than thirty years
NEAREST = 1e-9  # s between rows
ABSURD = 100  # times its range: axes that are told beyond are no motion but a slip, or the end of a sensor's range
Decimals = NDArray[np.int8]
_ROWS = 4096  # that are text and numbers at once
_CHARACTERS = 300 * _ROWS  # of about as many


@dataclass(frozen=True, eq=False)
class Resolution:
    """The step between neighbouring printed values, in SI: a printed value is off by at most half of it.

    t (n,) [s]: per row, 0 where a row stands on an exact grid. q, qd (n, k): per row and axis, rad or m; qd is 0
    without speed columns. A row of one entry, or a number, stands for all rows. tables: of the positioners' axes, None
    where there are none.
    """

    t: Array | float
    q: Array
    qd: Array
    tables: Resolution | None = None

    def __post_init__(self) -> None:
        for name, dimensions in (("t", 1), ("q", 2), ("qd", 2)):
            table = np.array(getattr(self, name), ndmin=dimensions, copy=None)
            table.setflags(write=False)
            object.__setattr__(self, name, table)


def header(names: Sequence[str], speeds: bool) -> list[str]:
    """Column heads for axes in order; the rail is in m, every other axis in rad."""
    units = ["m" if name == "rail" else "rad" for name in names]
    heads = [_TIME] + [f"{name} [{unit}]" for name, unit in zip(names, units, strict=True)]
    if speeds:
        heads += [f"{name} speed [{unit}/s]" for name, unit in zip(names, units, strict=True)]
    return heads


def write_csv_text(trajectory: Trajectory) -> str:
    """The file's text: header and rows, every number with 17 significant digits, so that reading gives it back."""
    return "".join(csv_parts(trajectory))


def csv_parts(trajectory: Trajectory) -> Iterator[str]:
    """The file's text in parts, some thousand rows at a time."""
    trajectory = trajectory.whole
    columns = [trajectory.t[:, None], trajectory.q] + ([] if trajectory.qd is None else [trajectory.qd])
    yield ",".join(header(trajectory.names, trajectory.qd is not None)) + "\n"
    row = ",".join(["%.17g"] * sum(column.shape[1] for column in columns)) + "\n"
    for first in range(0, len(trajectory.t), _ROWS):
        table = np.hstack([column[first : first + _ROWS] for column in columns])
        yield "".join([row % tuple(values) for values in table.tolist()])


@of_kind(ErrorKind.RESULTS)
def read_csv_text(text: str | TextIO, file: str) -> tuple[Trajectory, Resolution]:
    """The trajectory of a CSV text in SI, and how finely it is printed. file is for messages. A byte-order mark, as
    spreadsheets write one, is no part of the header. text: or a file whose lines end as they stand (newline="\\n"),
    which is read from its beginning, part by part.

    Raises InputError with file, line and column (in characters) for an unknown or missing head, a row of another
    length, anything that is not a finite number, times that do not increase, and fewer than two rows.
    """
    end, first_line = 0, ""
    for number, line in enumerate(_lines(text)):
        first_line = first_line if number else line
        if line.strip():  # there may be empty lines at the end
            end = number + 1
    if not end:
        raise InputError("the file is empty; its first line must be the header t [s],<axis> [unit],...", file=file)
    names, factors, speeds = _read_header(first_line.removeprefix("\ufeff").rstrip("\r"), file)
    k, width, rows = len(names), len(factors), end - 1
    t, q, qd = np.empty(rows), np.empty((rows, k)), np.empty((rows, width - 1 - k))
    digits = Digits(rows, width)
    lines, first = islice(_lines(text), 1, end), 0
    while rowed := [line.rstrip("\r") for line in islice(lines, _ROWS)]:
        for number, row in enumerate(rowed, start=first + 2):
            if (values := row.count(",") + 1) != width:
                raise InputError(f"{values} values, the header has {width} columns", file=file, line=number)
        table, part = _numbers(rowed, file, first + 2, width), slice(first, first + len(rowed))
        digits.add(rowed, table, first)
        table *= factors
        if (far := np.abs(table) > FARTHEST).any():
            i, j = (int(x) for x in np.argwhere(far)[0])
            fields = rowed[i].split(",")
            message = f"'{fields[j]}' is no time, position or speed of a robot: at most {FARTHEST:g} in s, m or rad"
            raise InputError(message, file=file, line=first + i + 2, column=1 + sum(len(one) + 1 for one in fields[:j]))
        t[part], q[part], qd[part] = table[:, 0], table[:, 1 : 1 + k], table[:, 1 + k :]
        first += len(rowed)
    if rows < 2:
        raise InputError(f"{rows} rows; a motion needs at least 2", file=file, line=rows + 1)
    late = np.flatnonzero(np.diff(t) < NEAREST)
    if late.size:
        i = int(late[0])
        message = f"time {t[i + 1]:.17g} s follows {t[i]:.17g} s; times must increase"
        if t[i + 1] > t[i]:
            message = f"times {t[i + 1] - t[i]:.3g} s apart, at {t[i]:g} s; rows are {NEAREST:g} s apart at least:"
            message += " see their unit"
        if t[i + 1] == t[i]:
            message += "; where both were rounded to this, print more digits of them"
        raise InputError(message, file=file, line=i + 3, column=1)
    last = digits.last()
    resolution = Resolution(
        t=_off_grid(t, last[0]),
        q=_steps(last[1 : 1 + k], factors[1 : 1 + k]),
        qd=_steps(last[1 + k :], factors[1 + k :]) if speeds else np.zeros((1, k)),
    )
    for array in (t, q, qd):
        array.setflags(write=False)
    trajectory = Trajectory(names, t, q, qd if speeds else None).apart
    if trajectory.tables is not None:
        own, its = slice(0, len(trajectory.names)), slice(len(trajectory.names), k)
        whole, tables = resolution, replace(resolution, q=resolution.q[:, its], qd=resolution.qd[:, its])
        resolution = Resolution(whole.t, whole.q[:, own], whole.qd[:, own], tables)
    return trajectory, resolution


@of_kind(ErrorKind.RESULTS)
def check_reach(trajectory: Trajectory, lower: Array, upper: Array, velocity: Array, file: str) -> None:
    """Raise InputError for a position that is no robot's, more than ABSURD times the range (k,) beside it [rad or m],
    and for a speed more than ABSURD times its limit (k,).

    What lies outside by less is a motion that is not legal, and for the judge to say.
    """
    far, fast = ABSURD * (upper - lower), ABSURD * velocity
    for first in range(0, len(trajectory.t), _ROWS):
        q = trajectory.q[first : first + _ROWS]
        wrong = np.argwhere((q < lower - far) | (q > upper + far))
        if len(wrong):
            i, k = (int(x) for x in wrong[0])
            name, unit = trajectory.names[k], "m" if trajectory.names[k] == "rail" else "rad"
            message = f"{name} is {q[i, k]:.6g} {unit}, its range [{lower[k]:.6g}, {upper[k]:.6g}] {unit}: more than"
            message += f" {ABSURD} times the range beside it is no trajectory; see the value, and the column's unit"
            raise InputError(message, file=file, line=first + i + 2)
        if trajectory.qd is None:
            continue
        wrong = np.argwhere(np.abs(qd := trajectory.qd[first : first + _ROWS]) > fast)
        if len(wrong):
            i, k = (int(x) for x in wrong[0])
            name, unit = trajectory.names[k], "m/s" if trajectory.names[k] == "rail" else "rad/s"
            message = f"the speed of {name} is {qd[i, k]:.6g} {unit}, its limit {velocity[k]:.6g} {unit}: more than"
            message += f" {ABSURD} times the limit is no trajectory; see the value, and the column's unit"
            raise InputError(message, file=file, line=first + i + 2)


def _lines(text: str | TextIO) -> Iterator[str]:
    """The lines of a text without their ends, or of a file from its beginning."""
    if isinstance(text, str):
        begin = 0
        while begin < len(text):
            end = text.find("\n", begin + _CHARACTERS)
            end = len(text) if end < 0 else end
            yield from text[begin:end].split("\n")
            begin = end + 1
    else:
        text.seek(0)
        yield from (line.removesuffix("\n") for line in text)


def _read_header(line: str, file: str) -> tuple[tuple[str, ...], Array, bool]:
    """Axis names, factor to SI per column, and whether speeds follow the positions."""
    heads = line.split(",")
    if heads[0] != _TIME:
        raise InputError(f"the first column is '{heads[0]}', wanted '{_TIME}'", file=file, line=1, column=1)
    positions: list[re.Match[str]] = []
    speeds: list[re.Match[str]] = []
    column = len(heads[0]) + 2
    for head in heads[1:]:
        position, speed = _POSITION.fullmatch(head), _SPEED.fullmatch(head)
        if (match := position or speed) and match["name"].startswith("eax_") and match["unit"] in ("m", "mm"):
            message = f"column '{head}' is of an axis that turns; wanted its values in rad or deg"
            raise InputError(message, file=file, line=1, column=column)
        if position and not speeds:
            positions.append(position)
        elif speed and len(speeds) < len(positions) and speed["name"] == positions[len(speeds)]["name"]:
            speeds.append(speed)
        else:
            wish = "'<axis> [m|mm|rad|deg]' for every axis, then all or none of '<axis> speed [unit/s]' in that order"
            raise InputError(f"unknown column '{head}'; wanted {wish}", file=file, line=1, column=column)
        column += len(head) + 1
    names = tuple(match["name"] for match in positions)
    if not names or len(set(names)) < len(names):
        raise InputError(f"axes are '{', '.join(names)}'; wanted each axis once", file=file, line=1)
    if speeds and len(speeds) < len(positions):
        missing = names[len(speeds)]
        raise InputError(f"the speed of {missing} is missing: give speeds of all axes or of none", file=file, line=1)
    return names, np.array([1.0, *(_SI[match["unit"]] for match in positions + speeds)]), bool(speeds)


def _numbers(rows: list[str], file: str, line: int, width: int) -> Array:
    """Rows of so many fields that begin at a line, as float64; raises InputError at the first field that is not a
    finite number."""
    with suppress(ValueError):  # numbers in other letters and with underscores are read below
        table = np.loadtxt(rows, delimiter=",", comments=None, ndmin=2)
        if table.shape == (len(rows), width) and np.isfinite(table).all():
            return table
    fields = [row.split(",") for row in rows]
    with suppress(ValueError):
        table = np.array(fields, dtype=np.float64)
        if np.isfinite(table).all():
            return table
    for number, row in enumerate(fields, start=line):
        for i, field in enumerate(row):
            try:
                finite = bool(np.isfinite(float(field)))
            except ValueError:
                finite = False
            if not finite:
                column = 1 + sum(len(other) + 1 for other in row[:i])
                raise InputError(f"'{field}' is not a finite number", file=file, line=number, column=column)
    raise InputError("the table holds a number that cannot be read", file=file)


def _steps(decimals: list[Decimals], factors: Array) -> Array:
    """Steps (n, k) in SI of columns with so many decimals (n,) each; (1, k) where no column's change."""
    if all((column == column[0]).all() for column in decimals):
        return np.array([[10.0 ** -int(column[0]) for column in decimals]]) * factors
    table: Any = np.empty((len(decimals[0]), len(decimals)), dtype=np.float32)  # half the memory
    for j, column in enumerate(decimals):
        table[:, j] = 10.0 ** -column.astype(np.float64) * factors[j]
    return np.asarray(table)


def _off_grid(t: Array, decimals: Decimals) -> Array:
    """The steps (n,) of times with so many decimals (n,), 0 for rows on a grid: there the times between them are the
    same whole number of printed units. The first and the last one may always be off it, also where they are printed as
    if they were not: a grid may begin and end anywhere."""
    h = np.diff(np.rint(t * 10.0 ** int(decimals.max())))
    if len(h) > 1 and np.ptp(h[1:-1] if len(h) > 2 else h) == 0:
        ends = np.isin(np.arange(len(t)), (0, len(t) - 1))
        return np.where(ends, 10.0 ** -decimals.astype(np.float64), 0.0)
    return _steps([decimals], np.ones(1))[:, 0]
