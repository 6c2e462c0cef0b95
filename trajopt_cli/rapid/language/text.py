"""Program files as text: their encodings, and the line and column of an offset."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Sequence
from contextlib import suppress
from functools import cached_property
from pathlib import Path
from unicodedata import combining, east_asian_width

from trajopt_cli.errors import InputError
from trajopt_cli.file_kinds import refuse_other
from trajopt_cli.motion import Source, Span, TextFile

_LINE_END = re.compile(r"\r\n|\r|\n")


def decode(data: bytes) -> tuple[str, str]:
    """Text and the encoding that gives the bytes back: UTF-8 with or without a mark, else cp1252, else Latin-1.

    UTF-16 is known by its mark, or by the zero that every second byte is in a text that is mostly ASCII.
    Latin-1 differs from cp1252 only where cp1252 has no character at all, and takes every byte.
    """
    encoding = "utf-8"
    zeros = [data[half:2000:2].count(0) * 4 > len(data[half:2000:2]) * 3 for half in (0, 1)]
    if data.startswith(b"\xef\xbb\xbf"):
        encoding = "utf-8-sig"
    elif data.startswith((b"\xff\xfe", b"\xfe\xff")):
        # The mark stays in the text as U+FEFF (a blank to the scanner), so that it is written back.
        encoding = "utf-16-le" if data[0] == 0xFF else "utf-16-be"
    elif any(zeros):
        encoding = "utf-16-le" if zeros[1] else "utf-16-be"
    for known in (encoding, "cp1252"):
        with suppress(UnicodeDecodeError):
            return data.decode(known), known
    return data.decode("latin-1"), "latin-1"


def read_text(path: str | Path) -> TextFile:
    """The file's text. Raises InputError when there is no such file."""
    file = Path(path)
    if file.is_dir():
        raise InputError("is a folder: give one RAPID module file", file=str(path))
    try:
        data = file.read_bytes()
    except OSError as error:
        raise InputError(f"cannot be read: {error.strerror}", file=str(path)) from error
    refuse_other(file, "program")
    text, encoding = decode(data)
    return TextFile(path=str(path), text=text, encoding=encoding)


class Places:
    """Turns offsets of one file's text into places a person can find."""

    def __init__(self, text: str, file: str):
        self.text, self.file = text, file

    @cached_property
    def _starts(self) -> list[int]:
        return [0, *(match.end() for match in _LINE_END.finditer(self.text))]

    def line(self, offset: int) -> int:
        """Line of an offset, from 1."""
        return bisect_right(self._starts, offset)

    def source(self, offset: int) -> Source:
        """File, line and column of an offset, both from 1; a tab is one column."""
        starts = self._starts
        line = bisect_right(starts, offset)
        return Source(self.file, line, offset - starts[line - 1] + 1)

    def span(self, start: int, end: int) -> Span:
        """The stretch [start, end) of this file."""
        return Span(self.file, start, end)

    def error(self, offset: int, message: str) -> InputError:
        """An InputError placed at an offset, with its line of text."""
        place = self.source(offset)
        excerpt = self.excerpt(offset)
        return InputError(message, file=place.file, line=place.line, column=place.column, excerpt=excerpt)

    def offset(self, line: int, column: int) -> int:
        """Offset of a place as source() gives it."""
        return self._starts[line - 1] + column - 1

    def excerpt(self, offset: int) -> str | None:
        """The line around an offset, indented, and a caret below the character; of a long line only what is near.

        None on an empty line.
        """
        line = self.line(offset) - 1
        start = self._starts[line]
        stop = self._starts[line + 1] if line + 1 < len(self._starts) else len(self.text)
        before = _plain(self.text[max(start, offset - _BEFORE) : offset])
        before = f"...{before}" if offset - start > _BEFORE else before.lstrip()
        behind = _plain(self.text[offset : min(stop, offset + _BEHIND + 1)].rstrip("\r\n"))
        behind = f"{behind[:-4]}..." if len(behind) > _BEHIND else behind.rstrip()
        if not (before + behind).strip():
            return None
        return f"{_MARGIN}{before}{behind}\n{_MARGIN}{' ' * sum(map(_columns, before))}^"


def listed(names: Sequence[str], most: int) -> str:
    """Names in a sentence, of many the first and how many more there are."""
    return ", ".join(names[:most]) + (f" and {len(names) - most} more" if len(names) > most else "")


_BEFORE, _BEHIND = 70, 50  # characters of a long line that are shown before and behind the place
_MARGIN = "    "


def _plain(text: str) -> str:
    """Every character a visible one or a blank, so that no terminal obeys it and the caret stands below its place."""
    return "".join(" " if c.isspace() or c in "\x00\ufeff" else c if c.isprintable() else "?" for c in text)


def _columns(character: str) -> int:
    """How many columns of a terminal a character takes."""
    if combining(character):
        return 0
    return 2 if east_asian_width(character) in "WF" else 1
