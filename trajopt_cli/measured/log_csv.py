"""Logs of joints as controllers and their tools write them: any of three delimiters, any order of columns, units in the
heads.

A head is a name with a unit: `J1 [deg]`, `joint_1 (rad)`, `Axis 1 deg`, `rail_mm`, `Time [ms]`. What a head leaves open
is asked for, never guessed: --units for units, --columns for names.
"""

from __future__ import annotations

import io
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.geometry import Array
from trajopt_cli.limits import JointLimits
from trajopt_cli.trajectory import Trajectory
from trajopt_cli.units import DEG, MM

TIME = "time"
_UNITS = {
    "time": {"s": 1.0, "sec": 1.0, "ms": 1e-3, "us": 1e-6, "µs": 1e-6},
    "turning": {"rad": 1.0, "deg": DEG, "°": DEG, "degrees": DEG},
    "sliding": {"m": 1.0, "mm": MM},
}
_SHOWN = {"time": "s, ms, us", "turning": "rad, deg", "sliding": "m, mm"}
_HEAD = re.compile(r"(?P<name>.*?)[\s_]*[\[(](?P<unit>[^\])]*)[\])]")
_BARE = re.compile(r"(?P<name>.+?)[\s_](?P<unit>sec|ms|us|µs|s|rad|deg|degrees|°|mm|m)")
_TIMES = {"t", "time", "timestamp", "zeit", "elapsed", "elapsedtime", "timesec", "clock"}
_JOINT = re.compile(
    r"(?:robot)?(?:joint|j|axis|rax|q)(?:position|pos|angle)?(?P<number>\d)(?:position|pos|angle|actual|measured)?"
)
_RAILS = {"rail", "track", "railposition", "eaxa", "e1", "linearaxis"}
_LONGEST, _SHORTEST = 0.5, 5e-4  # s between rows: beyond, the times are in another unit or the rows are too few
_FEWEST = 20  # rows
_BEYOND = 0.2  # of an axis' range: a position farther out is in another unit


@dataclass(frozen=True)
class _Column:
    number: int
    head: str
    unit: str | None


@of_kind(ErrorKind.RESULTS)
def read_log(
    path: Path, limits: JointLimits, units: str | None = None, columns: str | None = None
) -> tuple[Trajectory, tuple[str, ...]]:
    """A log's times and positions in SI, axes in the order of limits, and the heads that were not used.

    units: for columns whose head names none, "deg,mm" or "s,rad". columns: which column an axis is in where its head
    does not tell, "time=Timestamp,joint_1=#3"; # counts from 1.

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
    if "\r" in text and "\n" not in text:
        raise InputError("its lines end in CR alone; save the log with LF or CRLF", file=file)
    first, _, _ = text.partition("\n")
    if not first.strip():
        raise InputError("the file is empty or begins with an empty line; wanted a line of heads", file=file)
    delimiter = max((";", "\t", ","), key=first.count)
    heads = [head.strip().strip('"').strip() for head in first.rstrip("\r").split(delimiter)]
    if len(heads) < 2:
        raise InputError(
            f"the first line is '{first.strip()[:60]}'; wanted heads divided by , ; or tab", file=file, line=1
        )
    headless = all(_is_number(head, delimiter) for head in heads)
    if headless and columns is None:
        raise InputError(
            "the first line holds numbers; say which column is which by --columns time=#1,joint_1=#2,...",
            file=file,
            line=1,
        )
    known = [_Column(i, head, None) if headless else _parsed(i, head) for i, head in enumerate(heads)]
    chosen = _chosen(known, limits.names, _named(columns, known, limits.names, file), file)
    factors = _factors(chosen, units, file)
    wanted = [TIME, *limits.names]
    table = _numbers(text, delimiter, [chosen[name] for name in wanted], 0 if headless else 1, len(heads), file)
    table *= np.array([factors[name] for name in wanted])
    _check(table, chosen, limits, 0 if headless else 1, text, file)
    used = {column.number for column in chosen.values()}
    unused = () if headless else tuple(column.head for column in known if column.number not in used)
    return Trajectory(limits.names, table[:, 0], table[:, 1:]), unused


def _is_number(text: str, delimiter: str) -> bool:
    try:
        float(text.replace(",", ".") if delimiter != "," else text)
    except ValueError:
        return False
    return True


def _parsed(number: int, head: str) -> _Column:
    match = _HEAD.fullmatch(head) or _BARE.fullmatch(head)
    return _Column(number, head, None) if match is None else _Column(number, head, match["unit"].strip())


def _plain(column: _Column) -> str:
    """A head's name without its unit, in lower case, letters and digits alone."""
    match = _HEAD.fullmatch(column.head) or _BARE.fullmatch(column.head)
    return re.sub(r"[^a-z0-9]", "", (match["name"] if match else column.head).lower())


def _named(columns: str | None, known: Sequence[_Column], names: Sequence[str], file: str) -> dict[str, _Column]:
    """What --columns says."""
    out: dict[str, _Column] = {}
    for part in (columns or "").split(",") if columns else []:
        name, equals, head = (piece.strip() for piece in part.partition("="))
        if not equals or name not in (TIME, *names):
            raise InputError(
                f"--columns has '{part.strip()}'; wanted NAME=HEAD or NAME=#3, NAME one of {TIME}, {', '.join(names)}"
            )
        found = [one for one in known if one.head == head or head == f"#{one.number + 1}"]
        if len(found) != 1:
            heads = ", ".join(one.head for one in known)
            raise InputError(
                f"--columns: {len(found) or 'no'} columns are '{head}'; the heads are {heads}", file=file, line=1
            )
        out[name] = found[0]
    return out


def _chosen(
    known: Sequence[_Column], names: Sequence[str], given: Mapping[str, _Column], file: str
) -> dict[str, _Column]:
    """The column of the time and of every axis."""
    found: dict[str, list[_Column]] = {name: [] for name in (TIME, *names)}
    for column in known:
        name = _name_of(column, names)
        if name is not None and name not in given and column not in given.values():
            found[name].append(column)
    out = dict(given)
    for name, columns in found.items():
        if name in given:
            continue
        if len(columns) > 1:
            both = " and ".join(f"'{one.head}'" for one in columns)
            raise InputError(
                f"{both} could both be {name}; say which by --columns '{name}={columns[0].head}'", file=file, line=1
            )
        if not columns:
            heads = ", ".join(f"'{one.head}'" for one in known)
            raise InputError(
                f"no column is {name}; the heads are {heads}; say which by --columns '{name}=HEAD'", file=file, line=1
            )
        out[name] = columns[0]
    return out


def _name_of(column: _Column, names: Sequence[str]) -> str | None:
    """The axis that a head names, or the time; None for any other column, as speeds and torques."""
    if column.unit is not None and "/" in column.unit:
        return None
    plain = _plain(column)
    if plain in _TIMES:
        return TIME
    if "rail" in names and plain in _RAILS:
        return "rail"
    match = _JOINT.fullmatch(plain)
    name = f"joint_{match['number']}" if match else None
    return name if name in names else None


def _kind(name: str) -> str:
    return "time" if name == TIME else "sliding" if name == "rail" else "turning"


def _factors(chosen: Mapping[str, _Column], units: str | None, file: str) -> dict[str, float]:
    """To SI, per column: by its head, else by --units."""
    given: dict[str, float] = {}
    for unit in (units or "").split(",") if units else []:
        kinds = [kind for kind, table in _UNITS.items() if unit.strip() in table]
        if not kinds:
            raise InputError(
                f"--units has '{unit.strip()}'; wanted one each of s|ms|us, rad|deg, m|mm, as in --units s,deg,mm"
            )
        given[kinds[0]] = _UNITS[kinds[0]][unit.strip()]
    out = {}
    for name, column in chosen.items():
        kind = _kind(name)
        if column.unit is None:
            if kind not in given:
                word = {"time": "s", "turning": "deg", "sliding": "mm"}[kind]
                raise InputError(
                    f"column '{column.head}' names no unit; write it into the head, or say it by --units {word}",
                    file=file,
                    line=1,
                )
            out[name] = given[kind]
        elif column.unit in _UNITS[kind]:
            out[name] = _UNITS[kind][column.unit]
        else:
            message = f"column '{column.head}' is {name} in '{column.unit}'; wanted one of {_SHOWN[kind]}"
            raise InputError(message, file=file, line=1)
    return out


def _numbers(text: str, delimiter: str, columns: Sequence[_Column], skip: int, width: int, file: str) -> Array:
    body = text if not skip else text.partition("\n")[2]
    if delimiter != "," and "," in body:
        body = body.replace(",", ".")  # decimal commas
    if not body.strip():
        raise InputError(f"no rows below the heads; a log needs at least {_FEWEST}", file=file, line=1)
    use = [column.number for column in columns]
    try:
        table = np.loadtxt(io.StringIO(body), delimiter=delimiter, usecols=use, comments=None, ndmin=2, quotechar='"')
    except ValueError:
        raise _first_mistake(body, delimiter, columns, skip, width, file) from None
    long = any(len(more := line.split(delimiter)) > width and more[width:] != [""] for line in body.splitlines())
    if long or not np.isfinite(table).all():
        raise _first_mistake(body, delimiter, columns, skip, width, file)
    return np.asarray(table)


def _first_mistake(
    body: str, delimiter: str, columns: Sequence[_Column], skip: int, width: int, file: str
) -> InputError:
    for number, line in enumerate(io.StringIO(body), start=skip + 1):
        if not line.strip():
            continue
        fields = line.rstrip("\r\n").split(delimiter)
        if len(fields) > width and fields[width:] != [""]:
            return InputError(f"{len(fields)} values, the first line has {width}", file=file, line=number)
        for column in columns:
            if column.number >= len(fields):
                return InputError(f"{len(fields)} values, the first line has {width}", file=file, line=number)
            field = fields[column.number].strip().strip('"')
            try:
                good = bool(np.isfinite(float(field)))
            except ValueError:
                good = False
            if not good:
                return InputError(
                    f"'{field[:40]}' in column '{column.head}' is not a finite number", file=file, line=number
                )
    return InputError("the table cannot be read", file=file)


def _check(table: Array, chosen: Mapping[str, _Column], limits: JointLimits, skip: int, text: str, file: str) -> None:
    if len(table) < _FEWEST:
        raise InputError(f"{len(table)} row{'' if len(table) == 1 else 's'}; a log needs at least {_FEWEST}", file=file)
    t = table[:, 0]
    late = np.flatnonzero(np.diff(t) <= 0)
    if late.size:
        i = int(late[0])
        line = _line_of_row(text, i + 1, skip)
        if t[i + 1] == t[i]:
            raise InputError(
                f"time {t[i]:.9g} s stands in two rows; times must increase, so write more digits or drop one",
                file=file,
                line=line,
            )
        raise InputError(f"time {t[i + 1]:.9g} s follows {t[i]:.9g} s; times must increase", file=file, line=line)
    period = float(np.median(np.diff(t)))
    if not _SHORTEST <= period <= _LONGEST:
        unit = chosen[TIME].unit
        how = f"the head says {unit}" if unit else "as --units says"
        raise InputError(
            f"column '{chosen[TIME].head}': a row every {period:.3g} s ({how}); "
            f"wanted {_SHORTEST:g} to {_LONGEST:g} s: is the unit right?",
            file=file, line=1,
        )  # fmt: skip
    for k, name in enumerate(limits.names):
        low, high = float(limits.lower[k]), float(limits.upper[k])
        values = table[:, k + 1]
        room = _BEYOND * (high - low)
        if values.min() < low - room or values.max() > high + room:
            worst = float(values.max() if values.max() > high + room else values.min())
            unit = "m" if name == "rail" else "rad"
            raise InputError(
                f"column '{chosen[name].head}': {name} reaches {worst:.4g} {unit}, "
                f"its range is {low:.4g} to {high:.4g}: is the unit right?",
                file=file, line=1,
            )  # fmt: skip


def _line_of_row(text: str, row: int, skip: int) -> int:
    """The line on which a row stands, empty lines counted."""
    seen = -1 - skip
    for number, line in enumerate(io.StringIO(text), start=1):
        seen += bool(line.strip())
        if seen == row:
            return number
    return row + skip + 1


def periods(log: Trajectory) -> tuple[float, int]:
    """The usual time between rows [s], and how many rows are missing by it."""
    steps = np.diff(log.t)
    period = float(np.median(steps))
    return period, int(np.sum(np.maximum(np.rint(steps / period) - 1, 0)))


def in_order(logs: Sequence[Path]) -> None:
    """Refuse a log that is named twice."""
    for one, other in pairwise(sorted(path.resolve() for path in logs)):
        if one == other:
            raise InputError("is named twice; its motions would count twice", file=str(one))
