"""Tables as controllers, spreadsheets and scripts write them, read as one form: commas between fields, decimal points.

Read alike: `,` `;` or tab between fields, of which the heads have most; decimal commas where that is no comma; quotes;
a byte-order mark; CRLF; lines that are empty or begin with # % ! or //. Digits are those of ASCII. Times may be of a
clock (ISO 8601) or count from long ago, as from 1970: then they count from the first row's full second. A head is a
name with a unit: `J1 [deg]`, `joint_1 (rad)`, `Axis 1 deg`, `rail_mm`, `Time [ms]`, `t_ms`; what a file of several
robots calls one of them may stand before or behind the name: `ROB_1_J1 [deg]`, `J1 ROB_1 [deg]`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from datetime import datetime
from decimal import Decimal, InvalidOperation
from itertools import islice
from typing import TextIO

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.geometry import Array, IndexArray

TIME = "time"
TIMES = {"s": 1.0, "sec": 1.0, "ms": 1e3, "us": 1e6, "\u00b5s": 1e6, "\u03bcs": 1e6, "ns": 1e9}
"""Units of times, as many of them as make a second."""
_HEAD = re.compile(r"(?P<name>.*?)[\s_]*[\[(](?P<unit>[^\])]*)[\])]")
_BARE = re.compile(r"(?P<name>.+?)[\s_](?P<unit>sec|ms|us|\u00b5s|\u03bcs|ns|s|rad|deg|degrees|°|mm|m)")
_TIMES = {
    "t", "time", "timestamp", "zeit", "elapsed", "elapsedtime", "timesec", "clock", "epoch", "unixtime", "datetime",
    "stamp",
}  # fmt: skip
_JOINT = re.compile(
    r"(?:robot)?(?:joint|j|axis|rax|q)(?:position|pos|angle)?(?P<number>\d)(?:position|pos|angle|actual|measured)?"
)
_RAILS = {"rail", "track", "railposition", "eaxa", "e1", "linearaxis"}
_LONGEST, _SHORTEST = 0.5, 5e-4  # s between rows: beyond, the times are in another unit or the rows are too few
_DATE = re.compile(r"(\d{4}-\d\d-\d\d[T ])?(\d\d:\d\d:\d\d)(?:\.(\d+))?(Z|[+-]\d\d:?\d\d)?", re.ASCII)
_NUMBER = re.compile(r"\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\s*", re.ASCII)
_COMMENTS = ("#", "%", "!", "//")
_LONG_AGO = 1e8  # of any unit of time: floats are too coarse for the digits behind
_USUAL = 0.8  # of all gaps are as long as the usual one, where the others are said to miss rows
_ROWS = 4096  # that are text and numbers at once
_CHARACTERS = 300 * _ROWS  # of about as many


@dataclass(frozen=True)
class Head:
    """One head: which column, counted from 0, its text and the unit in it."""

    number: int
    text: str
    unit: str | None

    @classmethod
    def parsed(cls, number: int, text: str) -> Head:
        """Of a head's text."""
        match = _HEAD.fullmatch(text) or _BARE.fullmatch(text)
        return cls(number, text, None if match is None else match["unit"].strip())

    @property
    def bare(self) -> str:
        """The text without the unit."""
        match = _HEAD.fullmatch(self.text) or _BARE.fullmatch(self.text)
        return match["name"] if match else self.text

    @property
    def name(self) -> str | None:
        """TIME, or the axis that it names; None for any other column, as speeds and torques."""
        return self.without("")

    def without(self, robot: str) -> str | None:
        """The same where a robot's name stands before or behind it, set off by a divider; None where it does not."""
        if self.unit is not None and "/" in self.unit:
            return None
        text = self.bare.lower()
        if robot:
            name = re.escape(robot.lower())
            bare = re.fullmatch(rf"{name}[^a-z0-9]+(.+)|(.+?)[^a-z0-9]+{name}[^a-z0-9]*", text)
            text = bare[1] or bare[2] if bare else ""
        plain = re.sub(r"[^a-z0-9]", "", text)
        if plain in _TIMES:
            return TIME
        if plain in _RAILS:
            return "rail"
        joint = _JOINT.fullmatch(plain)
        return f"joint_{joint['number']}" if joint else None


class Sheet:
    """A table in a text, or in a file whose lines end as they stand (newline="\\n"), which is read part by part.

    file: for messages. heads: of all columns. line: theirs. rows: how many there are below, ended by last_line.
    """

    def __init__(self, source: str | TextIO, file: str):
        self.file, self._source = file, source
        content = self._content()
        self.line, text = next(content, (0, ""))
        if not self.line:
            raise InputError("the file is empty; its first line must be the header t [s],<axis> [unit],...", file=file)
        self.divider = max((",", ";", "\t"), key=text.count)
        parts = text.rstrip().removesuffix(self.divider).split(self.divider)  # one may end a line, too
        self.heads = [Head.parsed(i, part.strip().strip('"').strip()) for i, part in enumerate(parts)]
        self.rows, self.last_line = 0, self.line
        for self.last_line, _ in content:
            self.rows += 1
        self.headless = all(_is_number(head.text.replace(",", ".")) for head in self.heads)
        self.rows += self.headless

    def wrong(self, message: str, head: Head | None = None) -> InputError:
        """What is wrong with the heads, or with one; names the divider where it is none that joint CSV has."""
        divider = {",": "", ";": "; the heads are divided by semicolons", "\t": "; the heads are divided by tabs"}[
            self.divider
        ]
        column = None if head is None else 1 + sum(len(one.text) + 1 for one in self.heads[: head.number])
        return InputError(message + divider, file=self.file, line=self.line, column=column)

    def parts(self, order: Sequence[int]) -> Iterator[tuple[list[int], list[str], list[str], Array]]:
        """Some thousand rows at a time: their lines, the text of the columns of order (the time first) with commas
        between, the lines' own text, and the numbers (n, len(order)).

        Raises InputError at the first row of another length and at the first field that is not a finite number.
        """
        content = islice(self._content(), 1 - self.headless, None)
        width = len(self.heads)
        spell: Callable[[str], str] | None = None
        while batch := list(islice(content, _ROWS)):
            lines, raw = [number for number, _ in batch], [text for _, text in batch]
            for number, text in batch:
                values = text.count(self.divider) + 1
                if values != width and not (values == width + 1 and text.endswith(self.divider)):
                    message = f"{values} values, the header has {width} columns"
                    raise InputError(message, file=self.file, line=number)
            spell = spell or self._speller(order, raw[0])
            rows = [spell(text) for text in raw]
            yield lines, rows, raw, self._numbers(lines, rows, raw, order)

    def place(self, line: int, raw: str, number: int, message: str) -> InputError:
        """What is wrong with the field of a column, counted from 0, on a line with this text."""
        column = 1 + sum(len(field) + 1 for field in raw.split(self.divider)[:number])
        return InputError(message, file=self.file, line=line, column=column)

    def check_times(self, t: Array, lines: IndexArray, head: Head, least: float, how: str | None = None) -> None:
        """Raise InputError where times t (n,) [s] of rows on lines (n,) do not go on by more than least [s]; and where
        rows are so far apart that their unit must be another. how: how that is known, None where the head says it."""
        late = np.flatnonzero(~(np.diff(t) > least))
        if late.size:
            i = int(late[0])
            message = f"time {float(t[i + 1])} s follows {float(t[i])} s; times must increase"
            if t[i + 1] > t[i]:
                message = f"times {t[i + 1] - t[i]:.3g} s apart, at {t[i]:g} s; rows are {least:g} s apart at least:"
                message += " see their unit"
            if t[i + 1] == t[i]:
                message += f" (the row on line {lines[i]} has it, too): remove one of two equal rows; where both were"
                message += " rounded to this, print more digits of them"
            raise InputError(message, file=self.file, line=int(lines[i + 1]), column=1)
        period = float(np.median(np.diff(t))) if len(t) > 1 else _LONGEST
        if how is not None and not _SHORTEST <= period <= _LONGEST:
            wanted = f"wanted {_SHORTEST:g} to {_LONGEST:g} s: is the unit right?"
            raise self.wrong(f"column '{head.text}': a row every {period:.3g} s ({how}); {wanted}")

    def _content(self) -> Iterator[tuple[int, str]]:
        """Lines that hold anything, by their number from 1."""
        for number, text in enumerate(self._lines(), start=1):
            if (begun := text.lstrip()) and not begun.startswith(_COMMENTS):
                yield number, text.rstrip("\r")

    def _lines(self) -> Iterator[str]:
        """The lines of the text without their ends, or of the file from its beginning."""
        source = self._source
        if isinstance(source, str):
            begin = int(source.startswith("\ufeff"))
            while begin < len(source):
                end = source.find("\n", begin + _CHARACTERS)
                end = len(source) if end < 0 else end
                yield from source[begin:end].split("\n")
                begin = end + 1
        else:
            source.seek(0)
            yield from (line.removesuffix("\n").removeprefix("\ufeff") for line in source)

    def _fields(self, text: str) -> list[str]:
        text = text if self.divider == "," else text.replace(",", ".")
        return [field.strip().strip('"').strip() for field in text.split(self.divider)]

    def _speller(self, order: Sequence[int], first: str) -> Callable[[str], str]:
        """How a line is spelled as one of joint CSV; first: the first one's text."""
        zero = _zero_of(self._fields(first)[order[0]])
        as_it_is = zero is None and self.divider == "," and [*order] == [*range(len(self.heads))]
        plain = len(order) - 1 if as_it_is else -1
        per = round(np.log10(TIMES.get(self.heads[order[0]].unit or "s", 1.0)))

        def spell(text: str) -> str:
            if text.count(",") == plain and '"' not in text:
                return text
            fields = self._fields(text)
            time, *rest = (fields[i] for i in order)
            return ",".join([time if zero is None else _since(zero, time, per), *rest])

        return spell

    def _numbers(self, lines: list[int], rows: list[str], raw: list[str], order: Sequence[int]) -> Array:
        with suppress(ValueError):
            table = np.loadtxt(rows, delimiter=",", comments=None, ndmin=2)
            if table.shape == (len(rows), len(order)) and np.isfinite(table).all():
                return table
        for number, row, text in zip(lines, rows, raw, strict=True):
            for i, field in zip(order, row.split(","), strict=True):
                if not _is_number(field):
                    what = f"'{field}' is not a finite number"
                    if i == order[0] and any(mark in field for mark in ":/"):
                        what += " nor a date and time like 2026-03-04 11:00:00.123"
                    if len(order) < len(self.heads) or self.divider != ",":
                        what += f", in column '{self.heads[i].text}'"
                    raise self.place(number, text, i, what)
        raise InputError("the table holds a number that cannot be read", file=self.file)


def _is_number(text: str) -> bool:
    return _NUMBER.fullmatch(text) is not None and bool(np.isfinite(float(text)))


def _zero_of(first: str) -> datetime | Decimal | None:
    """What times count from where the first one is a date or from long ago: its full second."""
    if date := _DATE.fullmatch(first):
        with suppress(ValueError):
            return _second(date)
    if _is_number(first) and abs(float(first)) >= _LONG_AGO:
        with suppress(InvalidOperation):
            return Decimal(int(Decimal(first)))
    return None


def _second(date: re.Match[str]) -> datetime:
    """The full second of a date and time; without a date of any day."""
    return datetime.fromisoformat((date[1] or "2000-01-01T") + date[2] + (date[4] or ""))


def _since(zero: datetime | Decimal, time: str, per: int) -> str:
    """A time since zero, as finely as it is printed; as it stands where it is none. per: of the times' unit make a
    second, as a power of ten."""
    with suppress(ValueError, TypeError, InvalidOperation):
        if isinstance(zero, Decimal):
            return str(Decimal(time) - zero) if _is_number(time) else time
        if date := _DATE.fullmatch(time):
            whole = _second(date) - zero
            return str((whole.days * 86400 + whole.seconds + Decimal(f"0.{date[3] or 0}")).scaleb(per))
    return time


def missing_rows(t: Array, gaps: Array | None = None) -> str:
    """A clause on where an even table lost rows; empty where none are missing, or the table is not even.

    t (n,): times [s]; gaps (n-1,): between them, those that say nothing made shorter. Even: _USUAL of the gaps are as
    long as their median, within a quarter of it, and but for the first and the last no other is shorter than that.
    """
    gaps = np.diff(t) if gaps is None else gaps
    period = float(np.median(gaps)) if len(gaps) > 2 else 0.0
    if not period > 0:
        return ""
    times = gaps / period
    if np.mean(np.abs(times - 1) <= 0.25) < _USUAL or times[1:-1].min() < 0.75:
        return ""
    lost = np.where(np.abs(times - np.rint(times)) <= 0.25, np.rint(times) - 1, 0).astype(int)
    at = np.flatnonzero(lost > 0)
    if not at.size:
        return ""
    where = ", ".join(f"t = {t[i]:.6g} and {t[i + 1]:.6g} s" for i in at[:3])
    more = f" and at {len(at) - 3} more places" if len(at) > 3 else ""
    return f"{lost[at].sum()} of {len(t) + lost[at].sum()} rows are missing, between {where}{more}"
