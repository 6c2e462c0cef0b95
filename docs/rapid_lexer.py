"""RAPID in the manual's colours."""

from __future__ import annotations

from pygments.lexer import RegexLexer, words
from pygments.token import Comment, Keyword, Name, Number, Operator, Punctuation, String, Text

_KEYWORDS = (
    *("MODULE", "ENDMODULE", "SYSMODULE", "PROC", "ENDPROC", "FUNC", "ENDFUNC", "TRAP", "ENDTRAP", "LOCAL", "TASK"),
    *(
        "CONST",
        "VAR",
        "PERS",
        "ALIAS",
        "RECORD",
        "ENDRECORD",
        "INOUT",
        "SWITCH",
        "IF",
        "THEN",
        "ELSE",
        "ELSEIF",
        "ENDIF",
    ),
    *("FOR", "FROM", "TO", "STEP", "DO", "ENDFOR", "WHILE", "ENDWHILE", "TEST", "CASE", "DEFAULT", "ENDTEST", "GOTO"),
    *("RETURN", "ERROR", "UNDO", "RAISE", "RETRY", "TRYNEXT", "EXIT", "AND", "OR", "NOT", "XOR", "DIV", "MOD"),
    *("TRUE", "FALSE"),
)


class RapidLexer(RegexLexer):
    """Comments, texts, numbers, keywords, switches such as \\WObj; all else is a name."""

    name = "RAPID"
    aliases = ("rapid",)
    flags = 0
    tokens = {  # noqa: RUF012  as Pygments wants it
        "root": [
            (r"!.*", Comment),
            (r'"([^"\\]|\\.|"")*"', String),
            (words(_KEYWORDS, prefix=r"\b", suffix=r"\b"), Keyword),
            (r"\\\w+", Name.Attribute),
            (r"\b\d+(\.\d*)?([eE][-+]?\d+)?\b", Number),
            (r"\b[^\W\d]\w*", Name),
            (r":=|<>|<=|>=|[-+*/=<>]", Operator),
            (r"[\[\](){},;:]", Punctuation),
            (r"\s+", Text),
            (r".", Text),
        ]
    }
