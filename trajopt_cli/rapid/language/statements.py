"""Recursive descent over RAPID statements and blocks, and how reading goes on where their words do not match.

A block that nobody closes is reported once, where it opens; the word that shows it is left to the block around it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from trajopt_cli.errors import InputError
from trajopt_cli.rapid.language import syntax
from trajopt_cli.rapid.language.cursor import HANDLERS, OTHER_LANGUAGES, RESTARTS, STORAGE, WRONG
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


class StatementParser(ExpressionParser):
    """Reads statements and blocks of them; each method leaves the current token behind what it read."""

    def __init__(self, text: str, file: str, whole: Whole | None = whole_statement):
        super().__init__(text, file, whole)
        self._open: list[tuple[str, int, str]] = []  # the blocks around the current token: kind, start, name
        self._unclosed: list[tuple[str, int, str]] = []  # blocks that the file ends in, the innermost first
        self._labels: dict[str, int] = {}  # of the routine so far, in lower case, with where they start
        self._crossed: set[str] = set()  # kinds of block that were reported unclosed before the end of another

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
            self._put_back(error, before, depth, blocks)
            self.skip()

    def _put_back(self, error: InputError, before: int, depth: int, blocks: int) -> bool:
        """Keep the error and close what it left open; whether it came before anything was read."""
        self.keep(error)
        self.depth = depth
        del self._open[blocks:]
        stuck = self.i == before
        self.i += stuck
        return stuck

    def _label_once(self, node: Label) -> None:
        first = self._labels.setdefault(node.name.lower(), node.start)
        if first != node.start:
            line = self.places.line(first)
            what = f"label {node.name} stands in line {line} of this routine already; rename one of them"
            self.note(node.start, what)

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

    # ----------------------------------------------------------------------------------------------- the statements

    def statement(self) -> Statement:
        """One statement, up to and including what ends it."""
        kind, start = self.kinds[self.i], self.here
        if kind == "name":
            return self._name_first()
        if kind == "whole":
            self.i += 1
            return self.wholes[self.i - 1]
        self.deeper()
        read = _STATEMENTS.get(kind)
        if read is None:
            self.fail("a statement")
        statement = read(self, start)
        self.depth -= 1
        return statement

    def _name_first(self) -> Statement:
        start, name = self.here, self.texts[self.i]
        follows = self.kinds[self.i + 1]
        if follows == ":":
            self.new_name("a label")
            self.i += 1
            return syntax.Label(start, self.behind, name)
        if follows in (":=", ".", "{"):
            target = self._suffixes(self._name(), start)
            self._assigning()
            return self._assigned(start, target)
        self.i += 1
        if follows in ("=", "=="):
            self._assigning()
        if follows == "(" and self.kinds[self.i + 1] == ")":
            self.fail(f"arguments or ';' after {name}", advice=f"a procedure is called without parentheses: {name};")
        first, broken = self.i, self.new_line()
        args = self.arguments(";", "")
        if broken and len(args) == 1 and args[0].parameter is not None:  # `StopMove`, and an assignment below it
            self.i = first
            args = ()
        self.semicolon(f"after {name}" if not args else f"after the arguments of {name}", "',' or " if args else "")
        return syntax.ProcedureCall(start, self.behind, name, args)

    def _assigning(self) -> None:
        if not self.accept(":="):
            self.fail("':=' in the assignment")

    def _assigned(self, start: int, target: Expression) -> syntax.Assign:
        if not isinstance(syntax.base_of(target), (syntax.Name, syntax.Placeholder)):
            raise self.error(start, "only data can be assigned to, and this is a value")
        value = self.expression()
        self.semicolon("after the assignment")
        return syntax.Assign(start, self.behind, target, value)

    def placeholder(self) -> syntax.Placeholder:
        """Step over a placeholder."""
        start = self.here
        self.i += 1
        return syntax.Placeholder(start, self.behind, self.texts[self.i - 1])

    def _placeholder_statement(self, start: int) -> Statement:
        if self.kinds[self.i + 1] == ":=":
            name = self.placeholder()
            self.i += 1
            return self._assigned(start, name)
        placeholder = self.placeholder()
        self.accept(";")
        return placeholder

    def data(self, start: int, scope: str | None = None) -> syntax.DataDeclaration:
        """`VAR num n{2} := ...;` from its VAR, PERS or CONST on."""
        storage = self.kinds[self.i]
        self.i += 1
        type_ = self.identifier(f"a data type after {storage}")
        name = self.new_name(f"a name after {storage} {type_}")
        sizes = self.indices() if self.kinds[self.i] == "{" else ()
        value = self.expression() if self.accept(":=") else None
        self.semicolon(f"after the declaration of {name}")
        return syntax.DataDeclaration(start, self.behind, scope, storage, type_, name, sizes, value)

    def _late_call(self, start: int) -> Statement:
        self.i += 1
        name = self.expression()
        self.expect("%", "after the name of a late-bound procedure")
        args = self.arguments(";", "")
        self.semicolon("after the late-bound call", "',' or " if args else "")
        return syntax.LateCall(start, self.behind, name, args)

    def _if(self, start: int) -> Statement:
        self.i += 1
        depth = self.depth
        try:
            condition = self.expression()
            if not self.accept("THEN"):
                if self._may_follow_condition():
                    only = self.statement()
                    return If(start, self.behind, ((condition, (only,)),), (), compact=True)
                self.fail("THEN after the condition of IF, or a statement", self.behind)
        except InputError as error:
            if self.reach("THEN"):
                self.i += 1
            elif self.kind not in PARTS["IF"] and not self.odd_comment():
                raise
            self.keep(error)
            self.depth = depth
            condition = _MISSING
        self.open_block("IF", start)
        first = self.block(PARTS["IF"])
        branches, otherwise, second = self.branches()
        advice = ""
        if second is not None:
            line = self.places.line(second)
            advice = f"'ELSE IF' of line {line} opens an IF of its own, so write ELSEIF there or one more ENDIF"
        self.close_block("ENDIF", advice)
        return If(start, self.behind, ((condition, first), *branches), otherwise)

    def _may_follow_condition(self) -> bool:
        """Whether the current token may begin the statement of a compact IF."""
        wrong = self.kind in ENDS_BLOCK or self.kind in (";", *STORAGE, *WRONG)
        return not wrong and self.texts[self.i] not in OTHER_LANGUAGES and not self.odd_comment()

    def branches(self) -> tuple[list[tuple[Expression, Block]], Block, int | None]:
        """ELSEIF and ELSE with their blocks, and where the IF of an `ELSE IF` stands."""
        branches: list[tuple[Expression, Block]] = []
        otherwise: Block = ()
        second = None
        while self.kind in ("ELSEIF", "ELSE"):
            if self.accept("ELSEIF"):
                condition = self.header(self.expression, "THEN", "after the condition of ELSEIF")
                branches.append((condition or _MISSING, self.block(PARTS["IF"])))
                continue
            self.i += 1
            if self.kind == "IF" and not self.new_line():
                second = self.here
            otherwise = self.block(PARTS["IF"])
            if self.kind in ("ELSEIF", "ELSE"):
                self.note(self.here, self.sentence("ENDIF", "ELSE comes last, and once"))
        return branches, otherwise, second

    def _for(self, start: int) -> Statement:
        self.i += 1
        name, first, last, step = self.header(self._range, "DO", "before the body of FOR") or _NO_RANGE
        self.open_block("FOR", start)
        body = self.block(PARTS["FOR"])
        self.close_block("ENDFOR")
        return syntax.For(start, self.behind, name, first, last, step, body)

    def _range(self) -> tuple[str, Expression, Expression, Expression | None]:
        name = self.new_name("the loop variable after FOR")
        if not self.accept("FROM"):
            self.fail(f"FROM after FOR {name}", advice=f"write 'FOR {name} FROM first TO last DO'")
        first = self.expression()
        if not self.accept("TO"):
            self.fail("TO after the first value of FOR", self.behind)
        last = self.expression()
        step = self.expression() if self.accept("STEP") else None
        return name, first, last, step

    def _while(self, start: int) -> Statement:
        self.i += 1
        condition = self.header(self.expression, "DO", "after the condition of WHILE")
        self.open_block("WHILE", start)
        body = self.block(PARTS["WHILE"])
        self.close_block("ENDWHILE")
        return syntax.While(start, self.behind, condition or _MISSING, body)

    def _test(self, start: int) -> Statement:
        self.i += 1
        depth, parts = self.depth, PARTS["TEST"]
        try:
            subject = self.expression()
        except InputError as error:
            self.keep(error)
            self.depth, subject = depth, _MISSING
            while self.kind not in RESTARTS and not self.new_line():
                self.i += 1
        self.open_block("TEST", start)
        while self.kind in (";", "placeholder"):
            self.i += 1
        if self.kind not in ENDS_BLOCK:
            self.note(self.here, self.sentence("CASE, DEFAULT or ENDTEST after TEST", "a statement belongs to a CASE"))
            self.block(parts)
        cases: list[tuple[tuple[Expression, ...], Block]] = []
        default: Block | None = None
        while self.kind in ("CASE", "DEFAULT"):
            if self.accept("CASE"):
                values = self.header(self.values, ":", "after the values of CASE")
                cases.append((values or (), self.block(parts)))
            else:
                self.i += 1
                self.header(lambda: None, ":", "after DEFAULT")
                default = self.block(parts)
        self.close_block("ENDTEST")
        return syntax.Test(start, self.behind, subject, tuple(cases), default)

    def _goto(self, start: int) -> Statement:
        self.i += 1
        label = self.identifier("a label after GOTO")
        self.semicolon("after GOTO")
        return syntax.Goto(start, self.behind, label)

    def _with_value(self, start: int) -> Statement:
        word = self.kind
        self.i += 1
        bare = self.kind == ";" or (self.new_line() and self.kind in RESTARTS)
        value = None if bare else self.expression()
        self.semicolon(f"after {word}")
        return (syntax.Return if word == "RETURN" else syntax.Raise)(start, self.behind, value)

    def _simple(self, start: int) -> Statement:
        word = self.kinds[self.i]
        self.i += 1
        self.semicolon(f"after {word}")
        return syntax.Simple(start, self.behind, word)

    def _connect(self, start: int) -> Statement:
        self.i += 1
        interrupt = self.expression()
        if not self.accept("WITH"):
            self.fail("WITH after the interrupt of CONNECT", self.behind)
        trap = self.identifier("the name of a TRAP")
        self.semicolon("after CONNECT")
        return syntax.Connect(start, self.behind, interrupt, trap)


_MISSING = syntax.Placeholder(0, 0, "<EXP>")  # in a tree that nobody will see, because errors were noted
_NO_RANGE = ("", _MISSING, _MISSING, None)
_STATEMENTS = {
    **dict.fromkeys(STORAGE, StatementParser.data),
    "IF": StatementParser._if,
    "FOR": StatementParser._for,
    "WHILE": StatementParser._while,
    "TEST": StatementParser._test,
    "GOTO": StatementParser._goto,
    **dict.fromkeys(("RETURN", "RAISE"), StatementParser._with_value),
    **dict.fromkeys(("EXIT", "RETRY", "TRYNEXT"), StatementParser._simple),
    "CONNECT": StatementParser._connect,
    "%": StatementParser._late_call,
    "placeholder": StatementParser._placeholder_statement,
}
