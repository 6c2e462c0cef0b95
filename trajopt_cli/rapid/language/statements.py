"""Recursive descent over RAPID statements."""

from __future__ import annotations

from trajopt_cli.errors import InputError
from trajopt_cli.rapid.language.blocks import ENDS_BLOCK, PARTS, BlockParser
from trajopt_cli.rapid.language.cursor import OTHER_LANGUAGES, RESTARTS, STORAGE, WRONG
from trajopt_cli.rapid.language.syntax import (
    Assign,
    Block,
    Call,
    Component,
    Connect,
    DataDeclaration,
    Element,
    Expression,
    For,
    Goto,
    If,
    Label,
    LateCall,
    Name,
    Placeholder,
    ProcedureCall,
    Raise,
    Return,
    Simple,
    Statement,
    Test,
    While,
)


class StatementParser(BlockParser):
    """Reads statements; each method leaves the current token behind what it read."""

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
            return Label(start, self.behind, name)
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
        return ProcedureCall(start, self.behind, name, args)

    def _assigning(self) -> None:
        if not self.accept(":="):
            self.fail("':=' in the assignment")

    def _assigned(self, start: int, target: Expression) -> Assign:
        base = target
        while isinstance(base, (Component, Element)):
            base = base.base
        if isinstance(base, Call) or not isinstance(base, (Name, Placeholder)):
            raise self.error(start, "only data can be assigned to, and this is a value")
        value = self.expression()
        self.semicolon("after the assignment")
        return Assign(start, self.behind, target, value)

    def placeholder(self) -> Placeholder:
        """Step over a placeholder."""
        start = self.here
        self.i += 1
        return Placeholder(start, self.behind, self.texts[self.i - 1])

    def _placeholder_statement(self, start: int) -> Statement:
        if self.kinds[self.i + 1] == ":=":
            name = self.placeholder()
            self.i += 1
            return self._assigned(start, name)
        placeholder = self.placeholder()
        self.accept(";")
        return placeholder

    def data(self, start: int, scope: str | None = None) -> DataDeclaration:
        """`VAR num n{2} := ...;` from its VAR, PERS or CONST on."""
        storage = self.kinds[self.i]
        self.i += 1
        type_ = self.identifier(f"a data type after {storage}")
        name = self.new_name(f"a name after {storage} {type_}")
        sizes = self.indices() if self.kinds[self.i] == "{" else ()
        value = self.expression() if self.accept(":=") else None
        self.semicolon(f"after the declaration of {name}")
        return DataDeclaration(start, self.behind, scope, storage, type_, name, sizes, value)

    def _late_call(self, start: int) -> Statement:
        self.i += 1
        name = self.expression()
        self.expect("%", "after the name of a late-bound procedure")
        args = self.arguments(";", "")
        self.semicolon("after the late-bound call", "',' or " if args else "")
        return LateCall(start, self.behind, name, args)

    def _if(self, start: int) -> Statement:
        self.i += 1
        depth = self.depth
        try:
            condition = self.expression()
            if not self.accept("THEN"):
                if self._may_follow_condition():
                    return self._compact(start, condition)
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

    def _compact(self, start: int, condition: Expression) -> If:
        only = self.statement()
        return If(start, self.behind, ((condition, (only,)),), (), compact=True)

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
        return For(start, self.behind, name, first, last, step, body)

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
        return While(start, self.behind, condition or _MISSING, body)

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
        return Test(start, self.behind, subject, tuple(cases), default)

    def values(self) -> tuple[Expression, ...]:
        """Expressions with commas between them."""
        values = [self.expression()]
        while self.accept(","):
            values.append(self.expression())
        return tuple(values)

    def _goto(self, start: int) -> Statement:
        self.i += 1
        label = self.identifier("a label after GOTO")
        self.semicolon("after GOTO")
        return Goto(start, self.behind, label)

    def _value(self, word: str) -> Expression | None:
        self.i += 1
        bare = self.kind == ";" or (self.new_line() and self.kind in RESTARTS)
        value = None if bare else self.expression()
        self.semicolon(f"after {word}")
        return value

    def _return(self, start: int) -> Statement:
        value = self._value("RETURN")
        return Return(start, self.behind, value)

    def _raise(self, start: int) -> Statement:
        value = self._value("RAISE")
        return Raise(start, self.behind, value)

    def _simple(self, start: int) -> Statement:
        word = self.kinds[self.i]
        self.i += 1
        self.semicolon(f"after {word}")
        return Simple(start, self.behind, word)

    def _connect(self, start: int) -> Statement:
        self.i += 1
        interrupt = self.expression()
        if not self.accept("WITH"):
            self.fail("WITH after the interrupt of CONNECT", self.behind)
        trap = self.identifier("the name of a TRAP")
        self.semicolon("after CONNECT")
        return Connect(start, self.behind, interrupt, trap)


_MISSING = Placeholder(0, 0, "<EXP>")  # in a tree that nobody will see, because errors were noted
_NO_RANGE = ("", _MISSING, _MISSING, None)
_STATEMENTS = {
    **dict.fromkeys(STORAGE, StatementParser.data),
    "IF": StatementParser._if,
    "FOR": StatementParser._for,
    "WHILE": StatementParser._while,
    "TEST": StatementParser._test,
    "GOTO": StatementParser._goto,
    "RETURN": StatementParser._return,
    "RAISE": StatementParser._raise,
    **dict.fromkeys(("EXIT", "RETRY", "TRYNEXT"), StatementParser._simple),
    "CONNECT": StatementParser._connect,
    "%": StatementParser._late_call,
    "placeholder": StatementParser._placeholder_statement,
}
