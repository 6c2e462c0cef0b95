"""Which files are programs: lists of modules (.pgf), and what is named like a module and is something else.

A program list is the XML file in which a controller notes the modules of a program.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import NamedTuple
from xml.parsers import expat

from trajopt_cli.errors import InputError
from trajopt_cli.rapid.language.text import read_text


class Listed(NamedTuple):
    """A module file that a program list names, and the line that does (from 1)."""

    name: str
    line: int


def read_list(path: Path) -> tuple[Listed, ...]:
    """The modules of a program list, in its order.

    Raises InputError with the line: broken XML, another root than Program, no modules, a name with a folder in it, and
    document types or entities, which controllers never write and which can blow up a reader.
    """
    file = str(path)
    text = read_text(path).text.lstrip("\ufeff")
    # What the file says of its own encoding does not count: the text is decoded as every program file is.
    parser = expat.ParserCreate("utf-8")
    found: list[Listed] = []
    open_tags: list[str] = []
    parts: list[str] = []

    def refuse(message: str) -> InputError:
        return InputError(message, file=file, line=parser.CurrentLineNumber)

    def start(tag: str, _: dict[str, str]) -> None:
        if not open_tags and tag.lower() != "program":
            raise refuse(f"is not a program list: it begins with <{tag}>, a list begins with <Program>")
        open_tags.append(tag.lower())
        parts.clear()

    def end(_: str) -> None:
        if open_tags.pop() == "module":
            name = "".join(parts).strip()
            if not name or set(name) & set("/\\\0") or name == "..":
                raise refuse(f"'{name}' is not the name of a module file; a list names files beside it")
            found.append(Listed(name, parser.CurrentLineNumber))
        parts.clear()

    def refuse_declaration(*_: object) -> None:
        raise refuse("declares a document type or an entity, which controllers never write; remove the declaration")

    parser.StartElementHandler = start
    parser.EndElementHandler = end
    parser.CharacterDataHandler = parts.append
    parser.StartDoctypeDeclHandler = refuse_declaration
    parser.EntityDeclHandler = refuse_declaration
    try:
        parser.Parse(text.encode("utf-8", "surrogatepass"), True)
    except expat.ExpatError as error:
        message = f"is not a readable program list: {expat.ErrorString(error.code)}"
        raise InputError(message, file=file, line=error.lineno, column=error.offset + 1) from error
    if not found:
        raise InputError("lists no modules: a list holds <Program><Module>Name.mod</Module></Program>", file=file)
    return tuple(found)


_FLAGS = re.IGNORECASE | re.MULTILINE
_RAPID = re.compile(r"\b(ENDMODULE|ENDPROC|ENDFUNC|ENDTRAP)\b", re.IGNORECASE)
_GZIP = ("\x1f\x8b", "\x1f\u2039")  # in Latin-1 and in cp1252
_CONTROL = re.compile(r"[\x01-\x08\x0e-\x19\x1b-\x1f\x7f]")  # NUL and Ctrl-Z do stand in RAPID files
_NEAR = 4096  # characters at either end that tell most files
_LOOKS = (
    ("Modula-2 or Oberon", re.compile(r"^\s*((IMPLEMENTATION|DEFINITION)\s+MODULE\b|END\s+\w+\s*\.\s*\Z)", _FLAGS)),
    ("Fortran", re.compile(r"^\s*(END\s+MODULE\b|IMPLICIT\s+NONE\b|SUBROUTINE\s+\w+)|\AGFORTRAN module", _FLAGS)),
    ("a GNU MathProg or AMPL model", re.compile(r"^\s*(MAXIMI[ZS]E|MINIMI[ZS]E|SET|PARAM)\s+\w+[^;:]*[;:{]", _FLAGS)),
    ("a Go module file", re.compile(r"\A(\s*//.*\n)*\s*module\s+\S+\s*$", re.MULTILINE)),
)


def foreign(text: str) -> str | None:
    """What a file is, as the end of a sentence "it ...", where it is certainly no RAPID; None where it may be RAPID."""
    body = text.lstrip("\ufeff").strip("\x00\x1a \t\r\n\f\v")
    if not body:
        return "is empty"
    if body.startswith(_GZIP):
        return "is compressed (Fortran compilers write such .mod files)"
    if body.startswith("<") and not body.startswith("<SMT>"):
        return "is XML or HTML"
    if len(_CONTROL.findall(body, 0, _NEAR)) > 0.02 * min(len(body), _NEAR):
        return "is binary"
    if _RAPID.search(body, max(0, len(body) - _NEAR)) or _RAPID.search(body):  # it mostly ends so: look there first
        return None
    return next((f"looks like {name}" for name, sign in _LOOKS if sign.search(body)), None)
