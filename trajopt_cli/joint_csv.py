"""Joint trajectories as CSV: one row per instant, the unit in every column's head, 17 digits.

`t [s],rail [m],joint_1 [rad],...,joint_6 [rad]`, then, if the file has them, the speeds in the same order:
`rail speed [m/s],joint_1 speed [rad/s],...`. A file of somebody else may also use mm and deg, and the forms of
`sheet`. Behind the robot's axes stand those of positioners that turn, by their external axes: `eax_b [rad]`. Text in,
nouns out; where the text lives is the caller's business.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, TextIO

import numpy as np
from numpy.typing import NDArray

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.print_resolution import Digits
from trajopt_cli.sheet import TIME, TIMES, Head, Sheet
from trajopt_cli.trajectory import Trajectory
from trajopt_cli.units import DEG, MM, slides

_TIME = "t [s]"
_SI = {"m": 1.0, "mm": MM, "rad": 1.0, "deg": DEG}
_POSITION = re.compile(r"(?P<name>\w+) \[(?P<unit>m|mm|rad|deg)\]")
_SPEED = re.compile(r"(?P<name>\w+) speed \[(?P<unit>m|mm|rad|deg)/s\]")
FARTHEST = 1e9  # s, m, rad, m/s, rad/s: of any axis; more than thirty years
NEAREST = 1e-9  # s between rows
ABSURD = 100  # times its range: axes that are told beyond are no motion but a slip, or the end of a sensor's range
Decimals = NDArray[np.int8]
_ROWS = 4096  # that are printed, or looked at, at once
_SPELLED = {"°": "deg", "degrees": "deg"}


@dataclass(frozen=True, eq=False)
class Resolution:
    """The step between neighbouring printed values, in SI: a printed value is off by at most half of it.

    t (n,) [s]: per row, 0 where a row stands on an exact grid. q, qd (n, k): per row and axis, rad or m; qd is 0
    without speed columns. A row of one entry, or a number, stands for all rows. tables: of the positioners' axes, None
    where there are none. lines (n,): of the file, on which the rows stand.
    """

    t: Array | float
    q: Array
    qd: Array
    tables: Resolution | None = None
    lines: IndexArray | None = None

    def __post_init__(self) -> None:
        for name, dimensions in (("t", 1), ("q", 2), ("qd", 2)):
            table = np.array(getattr(self, name), ndmin=dimensions, copy=None)
            table.setflags(write=False)
            object.__setattr__(self, name, table)


def header(names: Sequence[str], speeds: bool) -> list[str]:
    """Column heads for axes in order; the rail is in m, every other axis in rad."""
    units = ["m" if slides(name) else "rad" for name in names]
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
    """The trajectory of a CSV text in SI, and how finely it is printed. file is for messages. What is read is told in
    `sheet`; text: or a file whose lines end as they stand (newline="\\n"), which is read from its beginning, part by
    part.

    Raises InputError with file, line and column (in characters) for an unknown or missing head, a row of another
    length, anything that is not a finite number, times that do not increase, and fewer than two rows.
    """
    sheet = Sheet(text, file)
    time, heads = _heads(sheet)
    names, factors, speeds = _read_header(sheet, heads)
    k, width, rows = len(names), len(factors), sheet.rows
    t, q, qd = np.empty(rows), np.empty((rows, k)), np.empty((rows, width - 1 - k))
    per, order, numbers = TIMES[time.unit or "s"], [time.number, *(head.number for head, _ in heads)], np.arange(rows)
    digits, first = Digits(rows, width), 0
    for lines, rowed, raw, table in sheet.parts(order):
        part = slice(first, first + len(rowed))
        digits.add(rowed, table, first)
        table[:, 1:] *= factors[1:]
        table[:, 0] /= per
        if (far := np.abs(table) > FARTHEST).any():
            i, j = (int(x) for x in np.argwhere(far)[0])
            what = f"'{rowed[i].split(',')[j]}' is no time, position or speed of a robot"
            raise sheet.place(lines[i], raw[i], order[j], f"{what}: at most {FARTHEST:g} in s, m or rad")
        t[part], q[part], qd[part], numbers[part] = table[:, 0], table[:, 1 : 1 + k], table[:, 1 + k :], lines
        first += len(rowed)
    if rows < 2:
        raise InputError(f"{rows} rows; a motion needs at least 2", file=file, line=rows + 1)
    sheet.check_times(t, numbers, time, NEAREST, None if time.unit else "taken as s, for its head names no unit")
    last = digits.last()
    resolution = Resolution(
        t=_off_grid(t * per, last[0]) / per,
        q=_steps(last[1 : 1 + k], factors[1 : 1 + k]),
        qd=_steps(last[1 + k :], factors[1 + k :]) if speeds else np.zeros((1, k)),
        lines=numbers,
    )
    for array in (t, q, qd):
        array.setflags(write=False)
    trajectory = Trajectory(names, t, q, qd if speeds else None).apart
    if trajectory.tables is not None:
        own, its = slice(0, len(trajectory.names)), slice(len(trajectory.names), k)
        tables = replace(resolution, q=resolution.q[:, its], qd=resolution.qd[:, its])
        resolution = replace(resolution, q=resolution.q[:, own], qd=resolution.qd[:, own], tables=tables)
    return trajectory, resolution


@of_kind(ErrorKind.RESULTS)
def check_reach(
    trajectory: Trajectory, lower: Array, upper: Array, velocity: Array, file: str, lines: IndexArray | None = None
) -> None:
    """Raise InputError for a position that is no robot's, more than ABSURD times the range (k,) beside it [rad or m],
    and for a speed more than ABSURD times its limit (k,). lines (n,): of the file, None for rows from its second on.
    Axes behind the first k are not looked at.

    What lies outside by less is a motion that is not legal, and for the judge to say.
    """
    far, fast = ABSURD * (upper - lower), ABSURD * velocity
    lines = np.arange(len(trajectory.t)) + 2 if lines is None else lines
    for first in range(0, len(trajectory.t), _ROWS):
        part = slice(first, first + _ROWS), slice(len(lower))
        q, qd = trajectory.q[part], np.empty((0, len(lower))) if trajectory.qd is None else trajectory.qd[part]
        for what, per, values, wrong in (
            ("", "", q, (q < lower - far) | (q > upper + far)),
            ("the speed of ", "/s", qd, np.abs(qd) > fast),
        ):
            for i, k in np.argwhere(wrong)[:1].tolist():
                name, unit = trajectory.names[k], f"{'m' if slides(trajectory.names[k]) else 'rad'}{per}"
                bound = f"limit {velocity[k]:.6g}" if per else f"range [{lower[k]:.6g}, {upper[k]:.6g}]"
                message = f"{what}{name} is {values[i, k]:.6g} {unit}, its {bound} {unit}: more than {ABSURD} times the"
                message += f" {'limit' if per else 'range beside it'} is no trajectory; see the value, and the column's"
                raise InputError(f"{message} unit", file=file, line=int(lines[first + i]))


def _heads(sheet: Sheet) -> tuple[Head, list[tuple[Head, str]]]:
    """The head of the times, and all others in their order with their text as joint CSV has it."""
    if sheet.headless:
        raise sheet.wrong(f"the first line holds numbers; write heads above it, '{_TIME},joint_1 [rad],...'")
    times = [head for head in sheet.heads if head.name == TIME]
    if len(times) != 1:
        found = " and ".join(f"'{head.text}'" for head in times)
        what = f"{found} could both be the time; leave one out" if times else f"no column is the time, '{_TIME}'"
        raise sheet.wrong(f"{what}; the first column is '{sheet.heads[0].text}'", sheet.heads[0])
    if times[0].unit not in (None, *TIMES):
        raise sheet.wrong(f"column '{times[0].text}' is a time in '{times[0].unit}'; wanted s, ms, us or ns", times[0])
    out = []
    for head in sheet.heads:
        if head is times[0]:
            continue
        text = head.text
        if head.name is not None and not (text.startswith("eax_") and head.unit in ("rad", "deg", "m", "mm")):
            if head.unit is None:
                ways = " or ".join(
                    f"'{head.name} [{one}]'" for one in (("m", "mm") if slides(head.name) else ("rad", "deg"))
                )
                raise sheet.wrong(f"column '{text}' names no unit; write {ways}, as its values are", head)
            text = f"{head.name} [{_SPELLED.get(head.unit, head.unit)}]"
        out.append((head, text))
    return times[0], out


def _read_header(sheet: Sheet, heads: Sequence[tuple[Head, str]]) -> tuple[tuple[str, ...], Array, bool]:
    """Axis names, factor to SI per column, and whether speeds follow the positions."""
    positions: list[re.Match[str]] = []
    speeds: list[re.Match[str]] = []
    for head, text in heads:
        position, speed = _POSITION.fullmatch(text), _SPEED.fullmatch(text)
        match = position or speed
        if match and match["name"].startswith("eax_") and slides(match["name"]) != (match["unit"] in ("m", "mm")):
            what, wanted = ("slides", "m or mm") if slides(match["name"]) else ("turns", "rad or deg")
            raise sheet.wrong(f"column '{head.text}' is of an axis that {what}; wanted its values in {wanted}", head)
        if position and not speeds:
            positions.append(position)
        elif speed and len(speeds) < len(positions) and speed["name"] == positions[len(speeds)]["name"]:
            speeds.append(speed)
        else:
            wish = "'<axis> [m|mm|rad|deg]' for every axis, then all or none of '<axis> speed [unit/s]' in that order"
            raise sheet.wrong(f"unknown column '{head.text}'; wanted {wish}", head)
    names = tuple(match["name"] for match in positions)
    if not names or len(set(names)) < len(names):
        raise sheet.wrong(f"axes are '{', '.join(names)}'; wanted each axis once")
    if speeds and len(speeds) < len(positions):
        missing = names[len(speeds)]
        raise sheet.wrong(f"the speed of {missing} is missing: give speeds of all axes or of none")
    return names, np.array([1.0, *(_SI[match["unit"]] for match in positions + speeds)]), bool(speeds)


def _steps(decimals: list[Decimals], factors: Array) -> Array:
    """Steps (n, k) in SI of columns with so many decimals (n,) each; (1, k) where no column's change."""
    if all((column == column[0]).all() for column in decimals):
        return np.array([[10.0 ** -int(column[0]) for column in decimals]]) * factors
    table: Any = np.empty((len(decimals[0]), len(decimals)), dtype=np.float32)  # half the memory
    for j, column in enumerate(decimals):
        table[:, j] = 10.0 ** -column.astype(np.float64) * factors[j]
    return np.asarray(table)


def _off_grid(t: Array, decimals: Decimals) -> Array:
    """The steps (n,) of times with so many decimals (n,), 0 for rows on a grid: there the times between them are whole
    multiples of the usual one. That is two printed units at least where rows are missing: in steps of one unit, rows
    that were rounded look alike, and so do rows between those of a grid. The first and the last one may always be off
    the grid, also where they are printed as if they were not: it may begin and end anywhere.

    Where all rows between those of a grid have more decimals than it, so has the format, which leaves zeros out."""
    steps = _steps([decimals], np.ones(1))[:, 0] + np.zeros(len(t))
    if _even(np.diff(np.rint(t * 10.0 ** int(decimals.max())))):
        steps[1:-1] = 0.0
        return steps
    sizes = np.floor(np.log10(np.maximum(np.abs(t), NEAREST)))
    sizes[0] = sizes[-1] = np.nan
    alike = {size: np.flatnonzero(sizes == size) for size in np.unique(sizes[1:-1])}  # rows of one power of ten
    least = {int(decimals[rows].min()) for rows in alike.values()}
    if len(least) != 1:  # significant digits: fewer decimals of larger numbers
        return steps
    fine = decimals > min(least)
    grid = np.flatnonzero(~fine)
    held = np.diff(np.cumsum(fine)[grid]) > 0  # gaps with finer rows in them
    units = np.diff(np.rint(t[grid] * 10.0 ** min(least)))
    if _even(units) or (units[~held] == 1).sum() == (~held).sum() > 1:
        known = {size: np.median(steps[rows[fine[rows]]]) for size, rows in alike.items() if fine[rows].any()}
        for size, rows in alike.items():  # a step grows with the number at most as significant digits let it
            step = min((one * 10.0 ** max(size - other, 0.0) for other, one in known.items()), default=np.inf)
            steps[rows] = np.minimum(steps[rows], step)
    return steps


def _even(gaps: Array) -> bool:
    """Whether gaps (n,), in printed units, are those of a grid; the first and the last one do not count."""
    inner = gaps[1:-1] if len(gaps) > 2 else gaps
    usual = np.median(inner) if len(inner) else 0.0
    return len(gaps) > 1 and bool(np.ptp(inner) == 0 or (usual >= 2 and not (inner % usual).any()))
