"""RAPID text to tokens, by one regular expression.

A literal aggregate of plain numbers, `[[500,200,450],[0,0,1,0]]`, is ONE token: targets make up most of a large
program, and nobody looks inside them but the interpreter (which asks the json module) and the export. All repetitions
are possessive, so that no text makes the scanner look at a character more than a few times.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field

from trajopt_cli.rapid.language.syntax import NUMBER, DataDeclaration, ProcedureCall

_KEYWORDS = """
    ALIAS AND BACKWARD CASE CONNECT CONST DEFAULT DIV DO ELSE ELSEIF ENDFOR ENDFUNC ENDIF ENDMODULE ENDPROC ENDRECORD
    ENDTEST ENDTRAP ENDWHILE ERROR EXIT FALSE FOR FROM FUNC GOTO IF INOUT LOCAL MOD MODULE NOSTEPIN NOT NOVIEW OR PERS
    PROC RAISE READONLY RECORD RETRY RETURN STEP SYSMODULE TASK TEST THEN TO TRAP TRUE TRYNEXT UNDO VAR VIEWONLY WHILE
    WITH XOR
"""
KEYWORDS = frozenset(_KEYWORDS.split())

# Some generators leave NUL bytes between tokens; old editors end a file with Ctrl-Z.
BLANK = r"[\s\x00\x1a\ufeff\u200b]*+"
NAME = r"[^\W\d]\w*+"
_ITEM = rf"\s*+[+-]?+{NUMBER}\s*+"


def _aggregate(depth: int) -> str:
    item = _ITEM if depth == 0 else rf"(?:{_ITEM}|\s*+{_aggregate(depth - 1)}\s*+)"
    return rf"\[{item}(?:,{item})*+\]"


_TOKEN = re.compile(
    rf"""{BLANK}(?:
      (?P<name>{NAME})
    | (?P<aggregate>{_aggregate(3)})
    | (?P<number>0[xX][0-9a-fA-F]++|0[oO][0-7]++|0[bB][01]++|{NUMBER})
    | (?P<string>"(?:[^"\r\n]|"")*+")
    | (?P<unclosed>"[^\r\n]*+)
    | (?P<comment>![^\r\n]*+)
    | (?P<placeholder><(?:SMT|EXP|VAR|ID|ARG|PAR|ALT|DIM|EIT|CSE|DDN|RDN|TDN)>)
    | (?P<header>%%%(?:{BLANK}\w++{BLANK}:{BLANK}[\w.-]++)*+{BLANK}%%%)
    | (?P<foreign>//[^\r\n]*+|/\*)
    | (?P<symbol>:=|<=|>=|<>|==|[-+*/=<>()\[\]{{}},;:.\\?|%])
    | (?P<end>\Z)
    | (?P<stray>[\s\S])
    )""",
    re.VERBOSE,
)
Whole = Callable[
    [str, int], tuple[ProcedureCall | DataDeclaration, int] | None
]  # a statement or declaration, and where it ends


@dataclass(frozen=True, slots=True)
class Tokens:
    """Parallel lists, one entry per token: kind, text, where it starts. The last one has kind "end".

    kind is a keyword in upper case, a symbol itself, or name, number, string, aggregate, placeholder, end; "unclosed"
    for a string without its end, "stray" for a character that RAPID does not have, "whole" for a statement that was
    read at once: its tree is in wholes, by the token's number. comments: where each `!` comment starts and ends.
    foreign: the same of comments as other languages write them, which are no tokens either.
    """

    kinds: list[str] = field(default_factory=list)
    texts: list[str] = field(default_factory=list)
    starts: list[int] = field(default_factory=list)
    wholes: dict[int, ProcedureCall | DataDeclaration] = field(default_factory=dict)
    comments: list[tuple[int, int]] = field(default_factory=list)
    foreign: list[tuple[int, int]] = field(default_factory=list)


def scan(text: str, whole: Whole | None = None) -> Tokens:
    """All tokens of a text. Never fails.

    whole: asked behind each semicolon for a statement and where it ends; None where it does not know the one there.
    """
    tokens = Tokens()
    kinds, texts, starts = tokens.kinds, tokens.texts, tokens.starts
    known: dict[str, str] = {}
    shared: dict[str, str] = {}  # of words that are alike one text is kept
    at, unclosed = 0, False
    while True:
        if whole is not None and kinds and kinds[-1] in (";", "whole"):
            while (found := whole(text, at)) is not None:
                node, at = found
                tokens.wholes[len(kinds)] = node
                kinds.append("whole")
                texts.append("")
                starts.append(node.start)
        for match in _TOKEN.finditer(text, at):
            kind = match.lastgroup
            assert kind is not None  # every alternative of _TOKEN is a group
            word = match[kind]
            start = at = match.end()
            start -= len(word)
            if kind == "name":
                upper = known.get(word)
                if upper is None:
                    upper = word.upper()
                    upper = known[word] = upper if upper in KEYWORDS else "name"
                kind = upper
            elif kind == "symbol":
                kind = word
            elif kind == "comment":
                tokens.comments.append((start, at))
                if whole is not None and kinds and kinds[-1] in (";", "whole"):
                    break
                continue
            elif kind == "header":
                continue
            elif kind == "foreign":
                if word == "/*":
                    close = -1 if unclosed else text.find("*/", at)
                    unclosed = close < 0  # looked for once only
                    at = close + 2 if close >= 0 else at
                tokens.foreign.append((start, at))
                break
            kinds.append(kind)
            texts.append(shared.setdefault(word, word))
            starts.append(start)
            if kind == ";" and whole is not None:
                break
            if kind == "end":
                return tokens
