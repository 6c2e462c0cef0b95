"""Blocks of statements, and how reading goes on where their words do not match.

A block that nobody closes is reported once, where it opens; the word that shows it is left to the block around it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from trajopt_cli.errors import InputError
from trajopt_cli.rapid.language.cursor import HANDLERS, RESTARTS
from trajopt_cli.rapid.language.expressions import ExpressionParser
from trajopt_cli.rapid.language.fast_path import whole_statement
from trajopt_cli.rapid.language.lexer import Whole
from trajopt_cli.rapid.language.syntax import Block, DataDeclaration, Expression, If, Label, Statement

ROUTINES = ("PROC", "FUNC", "TRAP")
# What belongs to each kind of block: its parts and its end.
PARTS = {
    "IF": ("ELSEIF", "ELSE", "ENDIF"),
    "FOR": ("ENDFOR",),
    "WHILE": ("ENDWHILE",),
    "TEST": ("CASE", "DEFAULT", "ENDTEST"),
    **{kind: (*HANDLERS, f"END{kind}") for kind in ROUTINES},
    "RECORD": ("ENDRECORD",),
}
_OWNERS = {part: [kind for kind, all_ in PARTS.items() if part in all_] for parts in PARTS.values() for part in parts}
_ENDS_OF_ROUTINES = frozenset(f"END{kind}" for kind in ROUTINES)
_ENDS_ROUTINE = frozenset({*ROUTINES, "RECORD", "ALIAS", "MODULE", "ENDMODULE", "end"})
ENDS_BLOCK = frozenset({*_OWNERS, *_ENDS_ROUTINE, "LOCAL", "TASK"})
_NEAR = 100  # statements that are looked through for the IF that a stray ENDIF belongs to
_T = TypeVar("_T")


class BlockParser(ExpressionParser):
    """Reads blocks of statements; what a statement is its heir knows."""

    def __init__(self, text: str, file: str, whole: Whole | None = whole_statement):
        super().__init__(text, file, whole)
        self._open: list[tuple[str, int, str]] = []  # the blocks around the current token: kind, start, name
        self._unclosed: list[tuple[str, int, str]] = []  # blocks that the file ends in, the innermost first
        self._labels: dict[str, int] = {}  # of the routine so far, in lower case, with where they start
        self._crossed: set[str] = set()  # kinds of block that were reported unclosed before the end of another

    def statement(self) -> Statement:
        """One statement, up to and including what ends it."""
        raise NotImplementedError

    def branches(self) -> tuple[list[tuple[Expression, Block]], Block, int | None]:
        """ELSEIF and ELSE with their blocks, and where the IF of an `ELSE IF` stands."""
        raise NotImplementedError

    def open_block(self, kind: str, start: int, name: str = "") -> None:
        """Enter a block; close_block leaves it."""
        if kind in ROUTINES:
            self._labels = {}
        self._open.append((kind, start, name))

    def close_block(self, end: str, advice: str = "") -> None:
        """Step over what ends the innermost block, or say where it opens that it is not closed."""
        kind, start, name = self._open.pop()
        title = f"{kind} {name}" if name else kind
        if self.accept(end):
            return
        if self.kind == "end":
            self._unclosed.append((title, start, end))
            if not self._open:
                self._file_ends()
            return
        if self._is_misspelt(kind, start):
            self.note(self.here, self.sentence(f"{end} for {title} of line {self.places.line(start)}", f"write {end}"))
            self.i += 1
            return
        if self.kind not in _ENDS_ROUTINE:
            self._crossed.add(kind)
        found = f"{self.found()} of line {self.places.line(self.here)}"
        advice = advice or f"write {end} where it ends"
        self.note(start, f"{title} is not closed: expected {end} before {found}; {advice}")

    def _file_ends(self) -> None:
        (title, start, end), *around = self._unclosed
        ends = " ".join((end, *(word for _, _, word in around)))
        advice = "the file seems to be cut off" if around else f"write {end} where it ends"
        self.note(start, f"{title} is not closed: expected {ends} before the end of the file; {advice}")

    def _is_misspelt(self, kind: str, start: int) -> bool:
        """Whether the current word is meant to end the block that opens at start, although it is another block's."""
        word = self.kind
        if kind in ROUTINES or word in _ENDS_OF_ROUTINES:
            return kind in ROUTINES and word in _ENDS_OF_ROUTINES
        if word not in _OWNERS or not word.startswith("END") or self._is_open(word):
            return False
        return self.places.source(start).column == self.places.source(self.here).column

    def block(self, stops: tuple[str, ...]) -> Block:
        """Statements up to (not including) one of stops, or the word that shows that stops are missing."""
        statements: list[Statement] = []
        while (kind := self.kinds[self.i]) not in stops:
            if kind == "whole":
                node = self.wholes[self.i]
                if isinstance(node, DataDeclaration) and node.scope is not None:
                    self._misplaced(node.scope)
                statements.append(node)
                self.i += 1
            elif kind == ";":  # tolerated after THEN, DO, ENDIF ...
                self.i += 1
            elif kind not in ENDS_BLOCK:
                self._try(statements)
            elif self._is_ours(kind):
                break
            else:
                self._stray(kind, statements)
        return tuple(statements)

    def _try(self, statements: list[Statement]) -> None:
        before, depth, blocks = self.i, self.depth, len(self._open)
        try:
            node = self.statement()
            statements.append(node)
            if type(node) is Label:
                self._label_once(node)
        except InputError as error:
            self.keep(error)
            self.depth = depth
            del self._open[blocks:]
            if self.i == before:
                self.i += 1
            self.skip()

    def _label_once(self, node: Label) -> None:
        first = self._labels.setdefault(node.name.lower(), node.start)
        if first != node.start:
            line = self.places.line(first)
            self.note(
                node.start, f"label {node.name} stands in line {line} of this routine already; rename one of them"
            )

    def _is_ours(self, kind: str) -> bool:
        """Whether the current word belongs to a block around this one, or to the module."""
        if kind in ("LOCAL", "TASK"):
            return self.kinds[self.i + 1] in _ENDS_ROUTINE
        if kind in _ENDS_ROUTINE:
            return True
        if self._is_open(kind):
            return True
        return bool(self._open) and self._is_misspelt(*self._open[-1][:2])

    def _is_open(self, part: str) -> bool:
        """Whether a block is open that a word is a part of."""
        owners = ROUTINES if part in _ENDS_OF_ROUTINES else _OWNERS[part]
        return any(opened in owners for opened, _, _ in self._open)

    def _stray(self, kind: str, before: list[Statement]) -> None:
        """Say what is wrong with a word that belongs to no open block, and step over it."""
        here = self.here
        if kind in ("LOCAL", "TASK"):
            self._misplaced(kind)
            self.i += 1
            return
        self.i += 1
        owners = _OWNERS[kind]
        if kind.startswith("END") and owners[0] in self._crossed:
            self._crossed.discard(owners[0])
            return
        unfinished = self._without_then(before, kind) if owners == ["IF"] else None
        if unfinished is not None:
            line = self.places.line(here)
            message = (
                f"expected THEN after the condition of IF, which {kind} of line {line} belongs to; write THEN here"
            )
            self.note(unfinished.branches[0][0].end, message)
        else:
            title = " or ".join(owners)
            advice = "remove it, or look for one closed too early"
            self.note(here, f"{kind} without {title}: no {title} is open here; {advice}")
        if owners == ["IF"] and kind != "ENDIF":
            self.i -= 1
            self.open_block("IF", here)
            self.branches()
            self.close_block("ENDIF")
        elif owners == ["TEST"] and self.reach(":"):
            self.i += 1

    def _misplaced(self, scope: str) -> None:
        advice = "only a module's declarations have it, so remove it"
        self.note(self.here, f"expected a statement, found '{scope}'; {advice}")

    def _without_then(self, before: list[Statement], kind: str) -> If | None:
        """The last IF just before the current word that was read as a compact one but seems to lack its THEN."""
        for node in reversed(before[-_NEAR:]):
            if isinstance(node, If) and node.compact:
                condition, (only, *_) = node.branches[0]
                return node if kind != "ENDIF" or self.new_line_between(condition.end, only.start) else None
        return None

    def header(self, read: Callable[[], _T], closing: str, where: str) -> _T | None:
        """What stands before the word that begins a body, which is stepped over; None where that went wrong."""
        depth = self.depth
        try:
            value = read()
            if self.accept(closing):
                return value
            shown = closing if closing.isalpha() else f"'{closing}'"
            self.fail(f"{shown} {where}", self.behind, self.advice("") or f"write {shown} here")
        except InputError as error:
            self.keep(error)
            self.depth = depth
            if self.reach(closing):
                self.i += 1
            else:
                while not self.new_line() and self.kind not in RESTARTS:
                    self.i += 1
        return None

    def reach(self, word: str) -> bool:
        """Go to a word that stands before the end of this statement, or stay."""
        i = self.i
        while (kind := self.kinds[i]) != word:
            if kind in RESTARTS or kind in (";", "unclosed", "THEN", "DO"):
                return False
            i += 1
        self.i = i
        return True
