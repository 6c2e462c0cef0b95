"""Logs of joints as controllers and their tools write them, in the forms of `sheet`: any order of columns, others
between them, units in the heads. What a head leaves open is asked for, never guessed: --units for units, --columns for
names. Times alone are seconds where nothing says another unit.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from itertools import pairwise
from pathlib import Path

import numpy as np

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.geometry import Array, IndexArray
from trajopt_cli.limits import JointLimits
from trajopt_cli.sheet import TIME, TIMES, Head, Sheet, missing_rows
from trajopt_cli.trajectory import Trajectory
from trajopt_cli.units import DEG, MM, slides

_UNITS = {
    "time": {unit: 1 / many for unit, many in TIMES.items()},
    "turning": {"rad": 1.0, "deg": DEG, "°": DEG, "degrees": DEG},
    "sliding": {"m": 1.0, "mm": MM},
}
_SHOWN = {"time": "s, ms, us, ns", "turning": "rad, deg", "sliding": "m, mm"}
_FEWEST = 20  # rows
_LONG = 3.0  # of the usual time between rows: that there are none for so long is told
_TURN = 300 * DEG  # from one row to the next: an angle that was wrapped
_BEYOND = 0.2  # of an axis' range: a position farther out is in another unit


@of_kind(ErrorKind.RESULTS)
def read_log(
    path: Path, limits: JointLimits, units: str | None = None, columns: str | None = None
) -> tuple[Trajectory, tuple[str, ...]]:
    """A log's times and positions in SI, axes in the order of limits, and the heads that were not used.

    units: for columns whose head names none, "deg,mm" or "s,rad". columns: which column an axis is in where its head
    does not tell, "time=Timestamp,joint_1=#3"; # counts from 1; a name alone, "ROB_1", is that of the robot whose
    columns are meant in a file of several.

    Raises InputError, one line, with the file and the column or line, for what is missing, ambiguous or no number, for
    times that do not increase, and for positions far outside the axes' ranges.
    """
    file = str(path)
    if path.exists() and not path.is_file():
        raise InputError("is not a regular file; save the log in one", file=file)
    try:
        text = path.read_bytes().decode("utf-8-sig", errors="replace")
    except FileNotFoundError:
        raise InputError("no such log", file=file) from None
    except OSError as error:
        raise InputError(f"cannot read: {error.strerror}", file=file) from error
    if "\0" in text[:1000]:
        raise InputError("holds NUL bytes, as UTF-16 and binary files do; save the log as UTF-8 text", file=file)
    sheet = Sheet(text if "\n" in text else text.replace("\r", "\n"), file)
    if len(sheet.heads) < 2:
        found = sheet.heads[0].text[:60]
        raise InputError(f"the first line is '{found}'; wanted heads divided by , ; or tab", file=file, line=sheet.line)
    if sheet.headless and columns is None:
        raise sheet.wrong("the first line holds numbers; say which column is which by --columns time=#1,joint_1=#2,...")
    given, robot = _named(columns, sheet, limits.names)
    chosen = _chosen(sheet, limits.names, given, robot)
    factors = _factors(chosen, units, sheet)
    if sheet.rows < _FEWEST:
        what = f"{sheet.rows} rows; a log needs at least {_FEWEST} below its heads"
        raise InputError(what, file=file, line=sheet.last_line)
    wanted = [TIME, *limits.names]
    parts = [(lines, table) for lines, _, _, table in sheet.parts([chosen[name].number for name in wanted])]
    lines, table = np.concatenate([one for one, _ in parts]), np.vstack([one for _, one in parts])
    table *= np.array([factors[name] for name in wanted])
    time = chosen[TIME]
    how = f"the head says {time.unit}" if time.unit else "as --units says" if units else "taken as s"
    sheet.check_times(table[:, 0], lines, time, 0.0, how)
    _check(table, chosen, limits, sheet, lines)
    used = {column.number for column in chosen.values()}
    unused = () if sheet.headless else tuple(head.text for head in sheet.heads if head.number not in used)
    return Trajectory(limits.names, table[:, 0], table[:, 1:]), unused


def _named(columns: str | None, sheet: Sheet, names: Sequence[str]) -> tuple[dict[str, Head], str]:
    """What --columns says: columns by name, and the robot that heads name."""
    out: dict[str, Head] = {}
    robot = ""
    for part in (columns or "").split(",") if columns else []:
        name, equals, head = (piece.strip() for piece in part.partition("="))
        if not equals and not robot and any(one.without(name) in names for one in sheet.heads):
            robot = name
            continue
        if not equals or name not in (TIME, *names):
            what = (
                f"--columns has '{part.strip()}'; wanted NAME=HEAD or NAME=#3, NAME one of {TIME}, {', '.join(names)}"
            )
            robots = _robots(sheet)
            raise InputError(
                f"{what}, or one of the robots that the heads name: {', '.join(robots)}" if robots else what
            )
        found = [one for one in sheet.heads if head in (one.text, f"#{one.number + 1}")]
        if len(found) != 1:
            heads = ", ".join(one.text for one in sheet.heads)
            raise sheet.wrong(f"--columns: {len(found) or 'no'} columns are '{head}'; the heads are {heads}")
        out[name] = found[0]
    return out, robot


def _robots(sheet: Sheet) -> list[str]:
    """Names before or behind those of axes in the heads."""
    parts = [(one, part) for one in sheet.heads if one.name is None for cut in re.finditer("[^A-Za-z0-9]+", one.bare)
             for part in (one.bare[: cut.start()], one.bare[cut.end() :])]  # fmt: skip
    return [*dict.fromkeys(part for one, part in parts if part and (one.without(part) or TIME) != TIME)]


def _chosen(sheet: Sheet, names: Sequence[str], given: Mapping[str, Head], robot: str) -> dict[str, Head]:
    """The column of the time and of every axis; time and rail may be common to robots."""
    out = dict(given)
    for name in (TIME, *names):
        if name in given:
            continue
        free = [] if sheet.headless else [one for one in sheet.heads if one not in given.values()]
        columns = [one for one in free if one.without(robot) == name]
        if robot and not columns and name in (TIME, "rail"):
            columns = [one for one in free if one.name == name]
        if len(columns) > 1:
            both = " and ".join(f"'{one.text}'" for one in columns)
            how = columns[0].text if columns[0].text != columns[1].text else f"#{columns[0].number + 1}"
            raise sheet.wrong(f"{both} could both be {name}; say which by --columns '{name}={how}'")
        if not columns:
            heads = ", ".join(f"'{one.text}'" for one in sheet.heads)
            robots = [] if robot else _robots(sheet)
            how = f"'{robots[0]}', which names a robot in them" if robots else f"'{name}=HEAD'"
            raise sheet.wrong(f"no column is {name}; the heads are {heads}; say which by --columns {how}")
        out[name] = columns[0]
    return out


def _kind(name: str) -> str:
    return "time" if name == TIME else "sliding" if slides(name) else "turning"


def _factors(chosen: Mapping[str, Head], units: str | None, sheet: Sheet) -> dict[str, float]:
    """To SI, per column: by its head, else by --units."""
    given: dict[str, float] = {}
    for unit in (units or "").split(",") if units else []:
        kinds = [kind for kind, table in _UNITS.items() if unit.strip() in table]
        if not kinds:
            raise InputError(
                f"--units has '{unit.strip()}'; wanted one each of s|ms|us|ns, rad|deg, m|mm, as in --units s,deg,mm"
            )
        given[kinds[0]] = _UNITS[kinds[0]][unit.strip()]
    out = {}
    for name, column in chosen.items():
        kind = _kind(name)
        if column.unit is None or sheet.headless:
            if kind not in given and (kind != "time" or column.name != TIME):
                word = {"time": "s", "turning": "deg", "sliding": "mm"}[kind]
                how = f"write it into the head, or say it by --units {word}"
                raise sheet.wrong(f"column '{column.text}' names no unit; {how}")
            out[name] = given.get(kind, 1.0)
        elif column.unit in _UNITS[kind]:
            out[name] = _UNITS[kind][column.unit]
        else:
            raise sheet.wrong(f"column '{column.text}' is {name} in '{column.unit}'; wanted one of {_SHOWN[kind]}")
    return out


def _check(table: Array, chosen: Mapping[str, Head], limits: JointLimits, sheet: Sheet, lines: IndexArray) -> None:
    for k, name in enumerate(limits.names):
        low, high = float(limits.lower[k]), float(limits.upper[k])
        values = table[:, k + 1]
        room = _BEYOND * (high - low)
        if values.min() < low - room or values.max() > high + room:
            worst = float(values.max() if values.max() > high + room else values.min())
            unit = "m" if slides(name) else "rad"
            raise sheet.wrong(
                f"column '{chosen[name].text}': {name} reaches {worst:.4g} {unit}, "
                f"its range is {low:.4g} to {high:.4g}: is the unit right?"
            )
        steps = np.abs(np.diff(values))
        wrapped = (steps > _TURN) & (steps > 2 * limits.velocity[k] * np.diff(table[:, 0])) & (not slides(name))
        if wrapped.any():
            i = int(np.argmax(wrapped))
            what = f"{name} jumps by {(values[i + 1] - values[i]) / DEG:.1f} deg after t = {table[i, 0]:.6g} s"
            raise InputError(f"{what}; log angles that go on beyond a turn", file=sheet.file, line=int(lines[i + 1]))


def long_gaps(t: Array) -> IndexArray:
    """The rows of a log, times t (n,) [s], behind which none came for longer than is usual: _LONG medians, and twice
    what 19 of 20 gaps stay under."""
    gaps = np.diff(t)
    return np.flatnonzero(gaps > max(_LONG * float(np.median(gaps)), 2 * float(np.quantile(gaps, 0.95))))


def lost_rows(t: Array) -> str:
    """Where a log lost rows, and for how long; empty where it lost none. t (n,): times [s]."""
    if even := missing_rows(t):
        return even
    gaps, at = np.diff(t), long_gaps(t)
    usual = float(np.median(gaps))
    where = ", ".join(f"t = {t[i]:.6g} and {t[i + 1]:.6g} s ({1e3 * gaps[i]:.3g} ms)" for i in at[:3])
    more = f" and {len(at) - 3} more" if len(at) > 3 else ""
    return f"no rows between {where}{more}; usually they are {1e3 * usual:.3g} ms apart" if at.size else ""


def logs_of(paths: Sequence[Path]) -> list[Path]:
    """The logs that are named; of a folder all of its files that end in .csv and are not hidden, by name.

    Raises InputError for a folder without any, and for a log that is named twice.
    """
    out: list[Path] = []
    for path in paths:
        found = sorted(path.glob("[!.]*.[cC][sS][vV]")) if path.is_dir() else [path]
        if not found:
            raise InputError("is a folder without logs: no file in it ends in .csv", file=str(path))
        out += found
    for one, other in pairwise(sorted(path.resolve() for path in out)):
        if one == other:
            raise InputError("is named twice; its motions would count twice", file=str(one))
    return out
