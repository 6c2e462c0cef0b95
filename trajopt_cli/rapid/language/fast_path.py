r"""The two statements that large programs are made of, each read at once instead of token by token.

`CONST robtarget p10:=[[...],...];` and `MoveL p10,v100,z10,tool0\WObj:=wobj0;`, with names, numbers and plain numeric
aggregates only. Whatever else there is, a comment inside or a mistake, is left to the parser: this is a short cut, and
gives the same tree or none.
"""

from __future__ import annotations

import re
from math import inf

from trajopt_cli.rapid.language.lexer import KEYWORDS, NAME
from trajopt_cli.rapid.language.syntax import (
    NUMBER,
    Aggregate,
    Argument,
    DataDeclaration,
    Expression,
    Name,
    Number,
    ProcedureCall,
)

NAME_LIMIT = 32  # characters in a RAPID name

_GAP, _BLANK = r"[ \t\r\n]++", r"[ \t\r\n]*+"
_ITEM = rf"{_BLANK}-?+[0-9]++\.?+[0-9]*+(?:[eE][+-]?+[0-9]++)?+{_BLANK}"
_ROW = rf"\[{_ITEM}(?:,{_ITEM})*+\]"
_AGGREGATE = rf"\[(?:{_BLANK}{_ROW}{_BLANK}|{_ITEM})(?:,(?:{_BLANK}{_ROW}{_BLANK}|{_ITEM}))*+\]"
_STATEMENT = re.compile(
    rf"""{_BLANK}(?:
      (?:(?P<scope>(?i:LOCAL|TASK)){_GAP})?+
      (?P<storage>(?i:CONST|PERS|VAR)){_GAP}(?P<type>{NAME}){_GAP}(?P<data>{NAME}){_BLANK}:={_BLANK}
      (?P<value>{_AGGREGATE}){_BLANK};
    | (?P<call>{NAME})(?:{_GAP}(?P<literal>{_AGGREGATE})?+|(?=\\))(?P<args>[\w\ \t\r\n,.\\:=+-]*+);
    )""",
    re.VERBOSE,
)
_NUMBER = re.compile(rf"([+-]?){NUMBER}")


def whole_statement(text: str, at: int) -> tuple[ProcedureCall | DataDeclaration, int] | None:
    """The statement that begins at an offset (blanks before it aside) and where it ends; None for all others."""
    match = _STATEMENT.match(text, at)
    if match is None:
        return None
    scope, storage, type_, name, _, call, _, _ = match.groups()
    end = match.end()
    if call is None:
        if type_.upper() in KEYWORDS or name.upper() in KEYWORDS or len(name) > NAME_LIMIT:
            return None
        first, last = match.span("value")
        start = match.start("scope" if scope else "storage")
        literal = Aggregate(first, last, text)
        data = DataDeclaration(start, end, scope and scope.upper(), storage.upper(), type_, name, (), literal)
        return data, end
    if call.upper() in KEYWORDS:
        return None
    args = _arguments(match)
    return None if args is None else (ProcedureCall(match.start("call"), end, call, args), end)


def _arguments(match: re.Match[str]) -> tuple[Argument, ...] | None:
    args: list[Argument] = []
    literal, pieces = match["literal"], match["args"].split(",")
    at = match.start("args")
    if literal is not None:
        start, end = match.span("literal")
        args.append(Argument(start, end, None, Aggregate(start, end, match.string)))
        rest = pieces.pop(0)
        if rest.strip(_WHITE) and not (rest.lstrip(_WHITE).startswith("\\") and _piece(rest, at, args)):
            return None
        at += len(rest) + 1
    elif len(pieces) == 1 and "\\" not in pieces[0] and not _NUMBER.fullmatch(pieces[0]):
        return None  # `num count;` is a component where it stands in a RECORD
    for piece in pieces:
        if piece.isidentifier() and piece.upper() not in KEYWORDS:
            end = at + len(piece)
            args.append(Argument(at, end, None, Name(at, end, piece)))
        elif not _piece(piece, at, args):
            return None
        at += len(piece) + 1
    return tuple(args)


def _piece(piece: str, at: int, args: list[Argument]) -> bool:
    r"""Append what stands between two commas: a value, `\name` or `\name:=value`, and more of those with it."""
    first, *options = piece.split("\\")
    value = _value(first, at)
    if value is not None:
        args.append(Argument(value.start, value.end, None, value))
    elif first.strip(_WHITE) or not options:
        return False
    at += len(first)
    for option in options:
        name, assigned, rest = option.partition(":=")
        start, word = at, name.strip(_WHITE)
        if not word.isidentifier() or word.upper() in KEYWORDS:
            return False
        if assigned:
            value = _value(rest, at + 1 + len(name) + 2)
            if value is None:
                return False
            args.append(Argument(start, value.end, word, value))
        else:
            end = at + 1 + len(name.rstrip(_WHITE))
            args.append(Argument(start, end, word, None))
        at += 1 + len(option)
    return True


_WHITE = " \t\r\n"


def _value(piece: str, at: int) -> Expression | None:
    """A name or a number with blanks around it."""
    word = piece.strip(_WHITE)
    start = at + len(piece) - len(piece.lstrip(_WHITE))
    end = start + len(word)
    if word.isidentifier():
        return None if word.upper() in KEYWORDS else Name(start, end, word)
    number = float(word) if _NUMBER.fullmatch(word) else inf
    return Number(start, end, number) if abs(number) != inf else None
