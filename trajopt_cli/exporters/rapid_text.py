"""Edits of program texts: replacements that leave every other character alone."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Mapping

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.motion import Source, Span, TextFile
from trajopt_cli.rapid.data.predefined import VARIABLES, predefined
from trajopt_cli.rapid.language.lexer import scan
from trajopt_cli.rapid.marks import DROPPED

NAME_LIMIT = 32  # characters in a RAPID name
PLACE = 3  # decimals of a place in mm: 0.001 mm, a thirtieth of the robot's repeatability
TURN = 3  # decimals of a turn in deg: 0.001 deg, whole multiples of which plans have


class Edits:
    """Replacements by file, made all at once; two that overlap are a mistake in the caller."""

    def __init__(self, files: Mapping[str, TextFile]):
        self._texts = {path: file.text for path, file in files.items()}
        self._edits: dict[str, list[tuple[int, int, str]]] = defaultdict(list)

    def replace(self, span: Span, text: str) -> None:
        """Put text where span is; an empty span inserts, in the order of the calls."""
        self._edits[span.file].append((span.start, span.end, text))

    def insert(self, file: str, offset: int, text: str) -> None:
        """Put text before the character at offset."""
        self._edits[file].append((offset, offset, text))

    def text(self, span: Span) -> str:
        """What stands there now, before any edit."""
        return self._texts[span.file][span.start : span.end]

    def line_end(self, file: str) -> str:
        """The file's own line end: that of its first line."""
        match = re.search(r"\r\n|\r|\n", self._texts[file])
        return match[0] if match else "\n"

    def line_of(self, file: str, offset: int) -> tuple[int, int]:
        """Start and end of the line that an offset is on, without its line end."""
        text = self._texts[file]
        start = max(text.rfind("\n", 0, offset), text.rfind("\r", 0, offset)) + 1
        end = re.compile(r"[\r\n]|\Z").search(text, offset)
        assert end is not None  # \Z always matches
        return start, end.start()

    def before(self, span: Span) -> str:
        """What stands on span's first line before it."""
        return self._texts[span.file][self.line_of(span.file, span.start)[0] : span.start]

    def behind(self, span: Span) -> str:
        """What stands on span's last line behind it."""
        return self._texts[span.file][span.end : self.line_of(span.file, span.end)[1]]

    def indentation(self, span: Span) -> str:
        """The blanks that span's first line begins with."""
        line = self._texts[span.file][self.line_of(span.file, span.start)[0] : span.start]
        return line[: len(line) - len(line.lstrip())]

    def put_behind(self, span: Span, text: str) -> None:
        """A statement or declaration on a line of its own behind span's; on the same line if more code is there."""
        behind = self.behind(span)
        if behind.strip() and not behind.strip().startswith("!"):
            self.insert(span.file, span.end, f" {text}")
        else:
            end = self.line_of(span.file, span.end)[1]
            self.insert(span.file, end, f"{self.line_end(span.file)}{self.indentation(span)}{text}")

    def put_before(self, span: Span, text: str) -> None:
        """A statement on a line of its own before span's; on the same line if span does not begin it."""
        alone = not self.before(span).strip()
        gap = f"{self.line_end(span.file)}{self.indentation(span)}" if alone else " "
        self.insert(span.file, span.start, text + gap)

    def comment_out(self, span: Span) -> None:
        """Make a statement a comment, line by line; code behind it on its last line moves to a line of its own."""
        for i, match in enumerate(re.finditer(r"(?m)^[ \t]*(?=\S)", self.text(span).replace("\r", "\n"))):
            self.insert(span.file, span.start + match.end(), DROPPED if i == 0 else "! ")
        behind = self.behind(span)
        if behind.strip() and not behind.strip().startswith("!"):
            gap = len(behind) - len(behind.lstrip())
            where = Span(span.file, span.end, span.end + gap)
            self.replace(where, self.line_end(span.file) + self.indentation(span))

    def remove(self, span: Span) -> None:
        """Take a declaration out, with its lines where it has them for itself."""
        text, end = self._texts[span.file], self.line_of(span.file, span.end)[1]
        if self.before(span).strip() or self.behind(span).strip():
            self.replace(span, "")
        else:
            end += len(self.line_end(span.file)) * (end < len(text))
            self.replace(Span(span.file, self.line_of(span.file, span.start)[0], end), "")

    def result(self) -> dict[str, str]:
        """All texts with the edits made."""
        out = {}
        for path, text in self._texts.items():
            parts, at = [], 0
            for start, end, new in sorted(self._edits[path], key=lambda edit: edit[:2]):
                if start < at:
                    raise ValueError(f"two edits of {path} overlap at character {start}")
                parts += [text[at:start], new]
                at = end
            out[path] = "".join(parts) + text[at:]
        return out


class Names:
    """Every name a program uses, and new ones that it does not."""

    def __init__(self, files: Mapping[str, TextFile]):
        self._used = {*predefined(), *VARIABLES}
        for file in files.values():
            tokens = scan(file.text)
            self._used |= {
                text.lower() for kind, text in zip(tokens.kinds, tokens.texts, strict=True) if kind == "name"
            }

    def take(self, name: str) -> bool:
        """Let nobody else have a name that is given to something; whether nobody had it."""
        new = name.lower() not in self._used
        self._used.add(name.lower())
        return new

    def new(self, base: str) -> str:
        """base, or base_2, base_3 and so on, whichever nobody uses; at most 32 characters."""
        number = 1
        while True:
            tail = f"_{number}" if number > 1 else ""
            name = base[: NAME_LIMIT - len(tail)] + tail
            if name.lower() not in self._used:
                self._used.add(name.lower())
                return name
            number += 1


def refusal(source: Source, message: str) -> InputError:
    """An InputError at a place of the program."""
    return InputError(message, file=source.file, line=source.line, column=source.column)


def plain(value: float, digits: int = 6) -> str:
    """A number as RAPID takes it, with at most so many decimals, without needless zeros."""
    text = f"{value:.{digits}f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def num(value: float, digits: int) -> str:
    """A value that the controller holds as a num of 24 bits: the shortest number that it reads as the same."""
    text = np.format_float_positional(np.float32(value), unique=True, trim="-")
    return plain(value, digits) if len(text.partition(".")[2]) > digits else "0" if text == "-0" else text
