"""RAPID modules to a syntax tree, by recursive descent.

Written by hand instead of generated from a grammar: what a user gets wrong (an IF that is never closed, a missing
semicolon) needs a sentence of its own at the right place, which a table-driven parser cannot give; a literal aggregate
is one token here, which keeps programs of a hundred thousand targets cheap; and it is shorter than grammar plus tree
building. Statement instructions are procedure calls, so no instruction is known to this file.
"""

from __future__ import annotations

from trajopt_cli.rapid.language.expressions import ExpressionParser
from trajopt_cli.rapid.language.syntax import (
    AliasDeclaration,
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
    Handler,
    If,
    Item,
    Label,
    LateCall,
    Module,
    ModuleFile,
    Name,
    Parameter,
    Placeholder,
    ProcedureCall,
    Raise,
    RecordDeclaration,
    Return,
    Routine,
    Simple,
    Statement,
    Test,
    While,
)

_ATTRIBUTES = ("SYSMODULE", "NOVIEW", "NOSTEPIN", "VIEWONLY", "READONLY")
_STORAGE = ("VAR", "PERS", "CONST")
_HANDLERS = ("ERROR", "UNDO", "BACKWARD")
_CLOSES_FILE = ("ENDMODULE", "MODULE", "end")


def parse_module(text: str, file: str) -> ModuleFile:
    """The syntax tree of one file: usually one module, sometimes several, or loose declarations.

    file: the name for messages. Raises InputError with file, line and column, what was expected and what was found.
    """
    return Parser(text, file).file()


def parse_statement(text: str, file: str) -> Statement:
    """The syntax tree of one statement with its semicolon. Raises InputError."""
    return Parser(text, file).statement()


class Parser(ExpressionParser):
    """Reads one file's tokens from left to right; each method leaves the current token behind what it read."""

    # ------------------------------------------------------------------------------------------ files and modules

    def file(self) -> ModuleFile:
        """All modules of the file."""
        modules: list[Module] = []
        leftovers: list[tuple[int, int]] = []
        while self.kinds[self.i] != "end":
            if self.kinds[self.i] == "MODULE":
                modules.append(self._module())
            elif not modules:
                start = self.here
                modules.append(Module(start, self.behind, "", (), self._items(None)))
            else:
                start = self.here
                while self.kinds[self.i] not in ("MODULE", "end"):
                    self.i += 1
                leftovers.append((start, self.behind))
        return ModuleFile(0, len(self.places.text), tuple(modules), tuple(leftovers), self.comments)

    def _module(self) -> Module:
        start = self.here
        self.i += 1
        name = self.identifier("the module's name")
        attributes: list[str] = []
        if self.accept("("):
            while True:
                if self.kinds[self.i] not in _ATTRIBUTES:
                    self.fail(f"a module attribute ({', '.join(_ATTRIBUTES)})")
                attributes.append(self.kinds[self.i])
                self.i += 1
                if not self.accept(","):
                    break
            self.expect(")", "after the module's attributes")
        items = self._items((name, start))
        self.i += 1
        return Module(start, self.behind, name, tuple(attributes), items)

    def _items(self, module: tuple[str, int] | None) -> tuple[Item, ...]:
        items: list[Item] = []
        while True:
            kind = self.kinds[self.i]
            if kind == ";":
                self.i += 1
            elif kind == "placeholder":
                items.append(self._placeholder())
            elif kind in _CLOSES_FILE and (module is None or kind == "ENDMODULE"):
                if kind == "ENDMODULE" and module is None:
                    self.fail("MODULE before it")
                return tuple(items)
            elif module is not None and kind in _CLOSES_FILE:
                name, start = module
                self.fail(f"ENDMODULE for MODULE {name} of line {self.places.line(start)}")
            else:
                items.append(self._item())

    def _item(self) -> Item:
        start = self.here
        scope = self.kinds[self.i] if self.kinds[self.i] in ("LOCAL", "TASK") else None
        if scope:
            self.i += 1
        kind = self.kinds[self.i]
        if kind in _STORAGE:
            return self._data(start, scope)
        if kind in ("PROC", "FUNC", "TRAP"):
            return self._routine(start, scope)
        if kind == "RECORD":
            return self._record(start, scope)
        if kind == "ALIAS":
            self.i += 1
            type_ = self.identifier("a data type after ALIAS")
            name = self.identifier("the new type's name")
            self.expect(";", "after the ALIAS declaration")
            return AliasDeclaration(start, self.behind, scope, type_, name)
        note = " (instructions belong in a PROC)" if kind == "name" else ""
        self.fail(f"a declaration (VAR, PERS, CONST, PROC, FUNC, TRAP, RECORD, ALIAS) or ENDMODULE{note}")

    def _record(self, start: int, scope: str | None) -> RecordDeclaration:
        self.i += 1
        name = self.identifier("the record's name")
        self.accept(";")
        components: list[tuple[str, str]] = []
        while not self.accept("ENDRECORD"):
            if self.kinds[self.i] != "name":
                self.fail(f"a component or ENDRECORD for RECORD {name} of line {self.places.line(start)}")
            type_ = self.identifier("a component's type")
            components.append((type_, self.identifier("a component's name")))
            self.expect(";", "after the component")
        return RecordDeclaration(start, self.behind, scope, name, tuple(components))

    def _data(self, start: int, scope: str | None) -> DataDeclaration:
        storage = self.kinds[self.i]
        self.i += 1
        type_ = self.identifier(f"a data type after {storage}")
        name = self.identifier(f"a name after {storage} {type_}")
        sizes = self.indices() if self.kinds[self.i] == "{" else ()
        value = self.expression() if self.accept(":=") else None
        self.expect(";", f"after the declaration of {name}")
        return DataDeclaration(start, self.behind, scope, storage, type_, name, sizes, value)

    # --------------------------------------------------------------------------------------------------- routines

    def _routine(self, start: int, scope: str | None) -> Routine:
        kind = self.kinds[self.i]
        self.i += 1
        type_ = self.identifier("the type that the FUNC returns") if kind == "FUNC" else None
        name = self.identifier(f"the name of the {kind}")
        parameters: tuple[Parameter, ...] = ()
        if kind != "TRAP":
            self.expect("(", f"after {kind} {name}")
            parameters = self._parameters(name)
        opener, end = f"{kind} {name} of line {self.places.line(start)}", f"END{kind}"
        body = self._block((*_HANDLERS, end), opener, end)
        handlers = []
        while self.kinds[self.i] in _HANDLERS:
            handlers.append(self._handler(opener, end))
        self.expect(end, f"for {opener}")
        return Routine(start, self.behind, scope, kind, type_, name, parameters, body, tuple(handlers))

    def _handler(self, opener: str, end: str) -> Handler:
        start, kind = self.here, self.kinds[self.i]
        self.i += 1
        numbers: list[Expression] = []
        if kind == "ERROR" and self.accept("("):
            numbers.append(self.expression())
            while self.accept(","):
                numbers.append(self.expression())
            self.expect(")", "after the error numbers")
        body = self._block((*_HANDLERS, end), opener, end)
        return Handler(start, self.behind, kind, tuple(numbers), body)

    def _parameters(self, routine: str) -> tuple[Parameter, ...]:
        parameters: list[Parameter] = []
        alternative = False
        while not self.accept(")"):
            if parameters and not alternative and self.kinds[self.i] != "\\":
                self.expect(",", f"or ')' after a parameter of {routine}")
            parameters.append(self._parameter(alternative))
            alternative = self.accept("|")
        return tuple(parameters)

    def _parameter(self, alternative: bool) -> Parameter:
        start = self.here
        if self.kinds[self.i] == "placeholder":
            place = self._placeholder()
            return Parameter(start, place.end, None, "", place.name)
        optional = self.accept("\\") or alternative
        mode = self.kinds[self.i] if self.kinds[self.i] in ("INOUT", "VAR", "PERS") else None
        if mode:
            self.i += 1
        type_ = self.identifier("a parameter's type")
        name = self.identifier(f"a parameter's name after {type_}")
        dimensions = 0
        if self.accept("{"):
            self.expect("*", "for each dimension of an array parameter")
            dimensions = 1
            while self.accept(","):
                self.expect("*", "for each dimension of an array parameter")
                dimensions += 1
            self.expect("}", "after the dimensions")
        return Parameter(start, self.behind, mode, type_, name, dimensions, optional, alternative)

    # ------------------------------------------------------------------------------------------------- statements

    def _block(self, stops: tuple[str, ...], opener: str, end: str) -> Block:
        """Statements up to (not including) a token whose kind is in stops."""
        statements: list[Statement] = []
        while (kind := self.kinds[self.i]) not in stops:
            if kind == ";":  # tolerated after THEN, DO, ENDIF ...
                self.i += 1
                continue
            if kind == "end" or kind.startswith("END") or kind in ("ELSE", "ELSEIF", "CASE", "DEFAULT", *_HANDLERS):
                self.fail(f"{end} for {opener}")
            statements.append(self.statement())
        return tuple(statements)

    def statement(self) -> Statement:
        """One statement, up to and including what ends it."""
        kind, start = self.kinds[self.i], self.here
        if kind == "name":
            return self._name_first()
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
            self.i += 2
            return Label(start, self.behind, name)
        if follows in (":=", ".", "{"):
            target = self._suffixes(self._name())
            self.expect(":=", "in the assignment")
            return self._assigned(start, target)
        self.i += 1
        args = self.arguments(";", f"after the arguments of {name}")
        self.expect(";", f"after {name}")
        return ProcedureCall(start, self.behind, name, args)

    def _assigned(self, start: int, target: Expression) -> Assign:
        base = target
        while isinstance(base, (Component, Element)):
            base = base.base
        if isinstance(base, Call) or not isinstance(base, (Name, Placeholder)):
            raise self.places.error(start, "only data can be assigned to, and this is a value")
        value = self.expression()
        self.expect(";", "after the assignment")
        return Assign(start, self.behind, target, value)

    def _placeholder(self) -> Placeholder:
        start = self.here
        self.i += 1
        return Placeholder(start, self.behind, self.texts[self.i - 1])

    def _placeholder_statement(self, start: int) -> Statement:
        if self.kinds[self.i + 1] == ":=":
            name = self._placeholder()
            self.i += 1
            return self._assigned(start, name)
        placeholder = self._placeholder()
        self.accept(";")
        return placeholder

    def _declaration(self, start: int) -> Statement:
        return self._data(start, None)

    def _late_call(self, start: int) -> Statement:
        self.i += 1
        name = self.expression()
        self.expect("%", "after the name of a late-bound procedure")
        args = self.arguments(";", "after the arguments of the late-bound procedure")
        self.expect(";", "after the late-bound call")
        return LateCall(start, self.behind, name, args)

    def _if(self, start: int) -> Statement:
        self.i += 1
        condition = self.expression()
        if not self.accept("THEN"):
            if self.kinds[self.i] in (";", "end", "ELSE", "ELSEIF", "ENDIF") or self.kinds[self.i] in _STORAGE:
                self.fail("THEN, or a statement to run under the condition")
            only = self.statement()
            return If(start, self.behind, ((condition, (only,)),), (), compact=True)
        opener, stops = f"IF of line {self.places.line(start)}", ("ELSEIF", "ELSE", "ENDIF")
        branches = [(condition, self._block(stops, opener, "ENDIF"))]
        while self.accept("ELSEIF"):
            condition = self.expression()
            self.expect("THEN", "after the condition of ELSEIF")
            branches.append((condition, self._block(stops, opener, "ENDIF")))
        otherwise = self._block(("ENDIF",), opener, "ENDIF") if self.accept("ELSE") else ()
        self.expect("ENDIF", f"for {opener}")
        return If(start, self.behind, tuple(branches), otherwise)

    def _for(self, start: int) -> Statement:
        self.i += 1
        name = self.identifier("the loop variable after FOR")
        self.expect("FROM", f"after FOR {name}")
        first = self.expression()
        self.expect("TO", "after the first value of FOR")
        last = self.expression()
        step = self.expression() if self.accept("STEP") else None
        self.expect("DO", "before the body of FOR")
        body = self._block(("ENDFOR",), f"FOR of line {self.places.line(start)}", "ENDFOR")
        self.i += 1
        return For(start, self.behind, name, first, last, step, body)

    def _while(self, start: int) -> Statement:
        self.i += 1
        condition = self.expression()
        self.expect("DO", "after the condition of WHILE")
        body = self._block(("ENDWHILE",), f"WHILE of line {self.places.line(start)}", "ENDWHILE")
        self.i += 1
        return While(start, self.behind, condition, body)

    def _test(self, start: int) -> Statement:
        self.i += 1
        subject = self.expression()
        opener, stops = f"TEST of line {self.places.line(start)}", ("CASE", "DEFAULT", "ENDTEST")
        cases: list[tuple[tuple[Expression, ...], Block]] = []
        default: Block | None = None
        while not self.accept("ENDTEST"):
            if self.accept("CASE"):
                values = [self.expression()]
                while self.accept(","):
                    values.append(self.expression())
                self.expect(":", "after the values of CASE")
                cases.append((tuple(values), self._block(stops, opener, "ENDTEST")))
            elif self.accept("DEFAULT"):
                self.expect(":", "after DEFAULT")
                default = self._block(stops, opener, "ENDTEST")
            elif self.kinds[self.i] in (";", "placeholder"):
                self.i += 1
            else:
                self.fail(f"CASE, DEFAULT or ENDTEST for {opener}")
        return Test(start, self.behind, subject, tuple(cases), default)

    def _goto(self, start: int) -> Statement:
        self.i += 1
        label = self.identifier("a label after GOTO")
        self.expect(";", "after GOTO")
        return Goto(start, self.behind, label)

    def _value(self, word: str) -> Expression | None:
        self.i += 1
        value = None if self.kinds[self.i] == ";" else self.expression()
        self.expect(";", f"after {word}")
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
        self.expect(";", f"after {word}")
        return Simple(start, self.behind, word)

    def _connect(self, start: int) -> Statement:
        self.i += 1
        interrupt = self.expression()
        self.expect("WITH", "after the interrupt of CONNECT")
        trap = self.identifier("the name of a TRAP")
        self.expect(";", "after CONNECT")
        return Connect(start, self.behind, interrupt, trap)


_STATEMENTS = {
    "VAR": Parser._declaration,
    "CONST": Parser._declaration,
    "PERS": Parser._declaration,
    "IF": Parser._if,
    "FOR": Parser._for,
    "WHILE": Parser._while,
    "TEST": Parser._test,
    "GOTO": Parser._goto,
    "RETURN": Parser._return,
    "RAISE": Parser._raise,
    "EXIT": Parser._simple,
    "RETRY": Parser._simple,
    "TRYNEXT": Parser._simple,
    "CONNECT": Parser._connect,
    "%": Parser._late_call,
    "placeholder": Parser._placeholder_statement,
}
