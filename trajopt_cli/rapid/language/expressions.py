"""Recursive descent over RAPID expressions and argument lists.

Priorities, high to low: `* / DIV MOD`, `+ -`, comparisons, `AND`, `XOR OR NOT`; all left associative. NOT is lowest, so
`NOT a AND b` is NOT (a AND b), `NOT a OR b` is (NOT a) OR b, and `a AND NOT b` still reads as it looks.
"""

from __future__ import annotations

import re
from math import inf

from trajopt_cli.rapid.language import syntax
from trajopt_cli.rapid.language.cursor import Cursor, short
from trajopt_cli.rapid.language.syntax import Expression

PRIORITY = {
    **dict.fromkeys(("OR", "XOR"), 0),
    "AND": 1,
    **dict.fromkeys(("<", ">", "<=", ">=", "=", "<>"), 2),
    **dict.fromkeys(("+", "-"), 3),
    **dict.fromkeys(("*", "/", "DIV", "MOD"), 4),
}

_LONGEST = 200  # characters of a number in base 16, 8 or 2
_ESCAPE = re.compile(r'""|\\\\|\\([0-9a-fA-F]{2})')


def unescape(literal: str) -> str:
    r"""The value of a string literal with its quotes: `""` is a quote, `\\` a backslash, `\0A` a character code."""
    return _ESCAPE.sub(lambda m: chr(int(m[1], 16)) if m[1] else m[0][0], literal[1:-1])


class ExpressionParser(Cursor):
    """Reads expressions from the current token on; each method leaves the current token behind what it read."""

    # -------------------------------------------------------------------------------------------- the expressions

    def expression(self, level: int = 0) -> Expression:
        """An expression whose operators have at least the priority level."""
        start = self.here
        left = self._not() if self.kinds[self.i] == "NOT" else self._factor(level)
        while True:
            operator = self.kinds[self.i]
            if operator == "==":
                self.note(self.here, self.sentence("'=' to compare", "write '='"))
                operator = "="
            priority = PRIORITY.get(operator, -1)
            if priority < level:
                return left
            self.i += 1
            right = self.expression(priority + 1)
            left = syntax.Binary(start, self.behind, operator, left, right)

    def _not(self) -> Expression:
        start = self.here
        self.i += 1
        self.deeper()
        operand = self.expression(PRIORITY["AND"])
        self.depth -= 1
        return syntax.Unary(start, self.behind, "NOT", operand)

    def _factor(self, level: int) -> Expression:
        kind = self.kinds[self.i]
        if kind not in ("-", "+"):
            return self._primary()
        start = self.here
        self.i += 1
        if self.kinds[self.i] == "number":
            number = self._number()
            return syntax.Number(start, number.end, -number.value if kind == "-" else number.value)
        self.deeper()
        # By RAPID's grammar a leading sign stands before a whole term: -a*b is -(a*b).
        operand = self.expression(max(level, PRIORITY["*"]))
        self.depth -= 1
        return syntax.Unary(start, self.behind, kind, operand)

    def _number(self) -> syntax.Number:
        start, text = self.here, self.texts[self.i]
        self.i += 1
        based = text[:2].lower() in ("0x", "0o", "0b")
        # 0x1FF...F of 300 digits has no float either
        value = inf if based and len(text) > _LONGEST else float(int(text, 0)) if based else float(text)
        if value == inf:
            raise self.error(start, f"number {short(text)} is too large")
        return syntax.Number(start, self.behind, value)

    def _primary(self) -> Expression:
        kind, start = self.kinds[self.i], self.here
        if kind == "name":
            return self._suffixes(self._name(), start)
        if kind == "aggregate":
            self.i += 1
            return syntax.Aggregate(start, self.behind, self.text)
        if kind == "number":
            return self._number()
        if kind == "string":
            self.i += 1
            return syntax.String(start, self.behind, unescape(self.texts[self.i - 1]))
        if kind in ("TRUE", "FALSE"):
            self.i += 1
            return syntax.Boolean(start, self.behind, kind == "TRUE")
        if kind in ("placeholder", "*"):
            self.i += 1
            return syntax.Placeholder(start, self.behind, self.texts[self.i - 1])
        if kind in ("(", "["):
            self.i += 1
            self.deeper()
            inside = self.expression() if kind == "(" else self._aggregate(start)
            self.depth -= 1
            if kind == "(":
                if not self.accept(")"):
                    self.fail(f"')' to close the '(' of column {self.places.source(start).column}", self.behind)
                return self._suffixes(inside, start)
            return inside
        self.fail("an expression", advice=self._trailing())

    def _trailing(self) -> str:
        """What to do about a comma that nothing follows."""
        alone = self.i and self.kinds[self.i - 1] == "," and self.kind in (",", ";", ")", "]", "}")
        return "one ',' is too many" if alone else ""

    def values(self) -> tuple[Expression, ...]:
        """Expressions with commas between them."""
        values = [self.expression()]
        while self.accept(","):
            values.append(self.expression())
        return tuple(values)

    def _aggregate(self, start: int) -> syntax.Aggregate:
        items = self.values()
        if not self.accept("]"):
            self.fail("']' or ',' in the aggregate", self.behind)
        return syntax.Aggregate(start, self.behind, given=items)

    def _name(self) -> Expression:
        start, name = self.here, self.texts[self.i]
        self.i += 1
        if self.accept("("):
            self.deeper()
            args = self.arguments(")", f"after the arguments of {name}")
            self.depth -= 1
            self.expect(")", f"or ',' after the arguments of {name}")
            return syntax.Call(start, self.behind, name, args)
        return syntax.Name(start, self.behind, name)

    def _suffixes(self, base: Expression, start: int) -> Expression:
        while True:
            if self.accept("."):
                name = self.identifier("the name of a component after '.'")
                base = syntax.Component(start, self.behind, base, name)
            elif self.kinds[self.i] == "{":
                indices = self.indices()
                base = syntax.Element(start, self.behind, base, indices)
            else:
                return base

    def indices(self) -> tuple[Expression, ...]:
        """`{a, b, c}`: up to three expressions."""
        opened = self.here
        self.expect("{", "before the indices")
        self.deeper()
        indices = self.values()
        self.depth -= 1
        self.expect("}", "after the indices")
        if len(indices) > 3:
            raise self.error(opened, f"{len(indices)} dimensions; RAPID has at most 3")
        return indices

    # ---------------------------------------------------------------------------------------------- the arguments

    def arguments(self, closing: str, where: str) -> tuple[syntax.Argument, ...]:
        r"""Arguments up to (not including) the closing token. The comma before a `\name` is optional."""
        args: list[syntax.Argument] = []
        while self.kinds[self.i] != closing:
            if args and self.kinds[self.i] != "\\":
                if not self.accept(","):
                    if closing == ";":
                        return tuple(args)  # whoever asks for the semicolon says so
                    self.fail(f"',' or '{closing}' {where}", self.behind)
                if self.kinds[self.i] == closing:
                    self.fail("an argument after ','", advice=self._trailing())
            args.append(self._optional() if self.kinds[self.i] == "\\" else self._required())
        return tuple(args)

    def _required(self) -> syntax.Argument:
        """`[ <ident> ':=' ] <expression>`: a value, with its parameter's name where that is written."""
        if self.kinds[self.i] == "name" and self.kinds[self.i + 1] in (",", ";", "\\"):  # nearly always
            start = self.here
            self.i += 1
            return syntax.Argument(start, self.behind, None, syntax.Name(start, self.behind, self.texts[self.i - 1]))
        parameter = None
        if self.kinds[self.i] == "name" and self.kinds[self.i + 1] == ":=":
            parameter = self.texts[self.i]
            self.i += 2
        start = self.here
        value = self.expression()
        return syntax.Argument(start, self.behind, None, value, parameter=parameter)

    def _optional(self) -> syntax.Argument:
        start = self.here
        self.i += 1
        name = self.identifier("the name of an optional argument after '\\'")
        if self.accept(":="):
            value = self.expression()
            return syntax.Argument(start, self.behind, name, value)
        if self.accept("?"):
            at = self.here
            parameter = self.identifier("the name of an optional parameter after '?'")
            return syntax.Argument(start, self.behind, name, syntax.Name(at, self.behind, parameter), forward=True)
        if self.kinds[self.i] in ("=", "=="):
            self.fail(f"':=' after \\{name}")
        return syntax.Argument(start, self.behind, name, None)


def parse_expression(text: str, file: str) -> Expression:
    """The syntax tree of one expression that is all of text. Raises InputError."""
    parser = ExpressionParser(text, file)
    node = parser.expression()
    if parser.kinds[parser.i] != "end":
        parser.fail("the end of the expression")
    parser.finish()
    return node
