"""Files that are named like RAPID modules and are something else: .mod and .sys belong to many."""

from __future__ import annotations

import re

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
