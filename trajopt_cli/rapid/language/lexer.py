"""RAPID text to tokens, by one regular expression.

A literal aggregate of plain numbers, `[[500,200,450],[0,0,1,0]]`, is ONE token: targets make up most of a large
program, and nobody looks inside them but the interpreter (which asks the json module) and the export.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

_KEYWORDS = """
    ALIAS AND BACKWARD CASE CONNECT CONST DEFAULT DIV DO ELSE ELSEIF ENDFOR ENDFUNC ENDIF ENDMODULE ENDPROC ENDRECORD
    ENDTEST ENDTRAP ENDWHILE ERROR EXIT FALSE FOR FROM FUNC GOTO IF INOUT LOCAL MOD MODULE NOSTEPIN NOT NOVIEW OR PERS
    PROC RAISE READONLY RECORD RETRY RETURN STEP SYSMODULE TASK TEST THEN TO TRAP TRUE TRYNEXT UNDO VAR VIEWONLY WHILE
    WITH XOR
"""
KEYWORDS = frozenset(_KEYWORDS.split())

_BLANK = r"[\s\x00\ufeff]*+"  # some generators leave NUL bytes between tokens
_NUMBER = r"(?:\d++(?:\.\d*+)?+|\.\d++)(?:[eE][+-]?\d++)?+"
_ITEM = rf"\s*+[+-]?{_NUMBER}\s*+"


def _aggregate(depth: int) -> str:
    item = _ITEM if depth == 0 else rf"(?:{_ITEM}|\s*+{_aggregate(depth - 1)}\s*+)"
    return rf"\[{item}(?:,{item})*+\]"


NUMBER = re.compile(_NUMBER)
_TOKEN = re.compile(
    rf"""{_BLANK}(?:
      (?P<name>[^\W\d]\w*+)
    | (?P<aggregate>{_aggregate(2)})
    | (?P<number>0[xX][0-9a-fA-F]++|0[oO][0-7]++|0[bB][01]++|{_NUMBER})
    | (?P<string>"(?:[^"\r\n]|"")*+")
    | (?P<comment>![^\r\n]*+)
    | (?P<placeholder><(?:SMT|EXP|VAR|ID|ARG|PAR|ALT|DIM|EIT|CSE|DDN|RDN|TDN)>)
    | (?P<header>%%%[\s\S]*?%%%)
    | (?P<symbol>:=|<=|>=|<>|[-+*/=<>()\[\]{{}},;:.\\?|%])
    | (?P<end>\Z)
    | (?P<stray>.)
    )""",
    re.VERBOSE,
)


@dataclass(frozen=True, slots=True)
class Tokens:
    """Parallel lists, one entry per token: kind, text, where it starts. The last one has kind "end".

    kind is a keyword in upper case, a symbol itself, or name, number, string, aggregate, placeholder, stray, end.
    comments: where each `!` comment starts and ends.
    """

    kinds: list[str] = field(default_factory=list)
    texts: list[str] = field(default_factory=list)
    starts: list[int] = field(default_factory=list)
    comments: list[tuple[int, int]] = field(default_factory=list)


def scan(text: str) -> Tokens:
    """All tokens of a text. Never fails: a character that fits nothing becomes a "stray" token."""
    tokens = Tokens()
    kinds, texts, starts = tokens.kinds, tokens.texts, tokens.starts
    known: dict[str, str] = {}
    for match in _TOKEN.finditer(text):
        kind = match.lastgroup
        assert kind is not None  # every alternative of _TOKEN is a group
        if kind == "comment":
            tokens.comments.append(match.span(kind))
            continue
        if kind == "header":
            continue
        word = match[kind]
        if kind == "name":
            upper = known.get(word)
            if upper is None:
                upper = word.upper()
                upper = known[word] = upper if upper in KEYWORDS else "name"
            kind = upper
        elif kind == "symbol":
            kind = word
        kinds.append(kind)
        texts.append(word)
        starts.append(match.end() - len(word))
        if kind == "end":
            break
    return tokens
