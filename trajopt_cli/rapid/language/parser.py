"""RAPID modules to a syntax tree, by recursive descent.

Written by hand instead of generated from a grammar: what a user gets wrong (an IF that is never closed, a missing
semicolon) needs a sentence of its own at the right place, which a table-driven parser cannot give; a literal aggregate
is one token here, which keeps programs of a hundred thousand targets cheap; and it is shorter than grammar plus tree
building. Statement instructions are procedure calls, so no instruction is known to this file.
"""

from __future__ import annotations

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.rapid.language import syntax
from trajopt_cli.rapid.language.cursor import HANDLERS, STORAGE
from trajopt_cli.rapid.language.statements import ROUTINES, StatementParser

_ATTRIBUTES = ("SYSMODULE", "NOVIEW", "NOSTEPIN", "VIEWONLY", "READONLY")


@of_kind(ErrorKind.PROGRAM)
def parse_module(text: str, file: str) -> syntax.ModuleFile:
    """The syntax tree of one file: usually one module, sometimes several, or loose declarations.

    file: the name for messages. Raises InputError with file, line and column, what was expected and what was found; an
    InputErrorGroup where there is more than one mistake.
    """
    return Parser(text, file).file()


def parse_statement(text: str, file: str) -> syntax.Statement:
    """The syntax tree of one statement with its semicolon. Raises InputError."""
    parser = Parser(text, file)
    statement = parser.statement()
    parser.finish()
    return statement


class Parser(StatementParser):
    """Reads one file's tokens from left to right; each method leaves the current token behind what it read."""

    # ------------------------------------------------------------------------------------------ files and modules

    def file(self) -> syntax.ModuleFile:
        """All modules of the file."""
        modules: list[syntax.Module] = []
        leftovers: list[tuple[int, int]] = []
        while self.kind != "end":
            if self.kind == "MODULE":
                modules.append(self._module())
            elif not modules:
                start, behind = self.here, self.behind
                if items := self._items(loose=True):
                    modules.append(syntax.Module(start, behind, "", (), items))
            else:
                leftovers.append(self._leftover())
        self.finish()
        if (nul := self.text.find("\x00")) >= 0:
            strings = [start for start, text in zip(self.starts, self.texts, strict=True) if "\x00" in text]
            self.warnings += [(start, "NUL bytes inside a string stay in it") for start in strings[:1]]
            if self.text.count("\x00") > sum(text.count("\x00") for text in self.texts):
                self.warnings.append((nul, "NUL bytes between the tokens are read as blanks"))
        warnings = tuple(sorted(self.warnings))
        return syntax.ModuleFile(0, len(self.text), tuple(modules), tuple(leftovers), self.comments, warnings)

    def _leftover(self) -> tuple[int, int]:
        start = self.here
        while self.kind not in ("MODULE", "end"):
            self.i += 1
        end = self.behind
        lines = sum(1 for line in self.text[start:end].splitlines() if line.strip() and line.strip()[0] != "!")
        counted = f"{lines} line{'s' if lines > 1 else ''}"
        self.warnings.append((start, f"text after ENDMODULE ({counted}) is not part of the program and does not run"))
        return start, end

    def _module(self) -> syntax.Module:
        start = self.here
        self.i += 1
        attributes: list[str] = []
        name = ""
        try:
            name = self.new_name("the module's name", inside=("number",))
            if self.accept("("):
                attributes = self._attributes()
        except InputError as error:
            self.keep(error)
            self.next_line()
        self.open_block("MODULE", start, name)
        items = self._items()
        self.close_block("ENDMODULE")
        return syntax.Module(start, self.behind, name, tuple(attributes), items)

    def _attributes(self) -> list[str]:
        attributes: list[str] = []
        while True:
            if self.kind not in _ATTRIBUTES:
                self.fail(f"a module attribute ({', '.join(_ATTRIBUTES)})")
            attributes.append(self.kind)
            self.i += 1
            if not self.accept(","):
                break
        self.expect(")", "after the module's attributes")
        return attributes

    def _items(self, loose: bool = False) -> tuple[syntax.Item, ...]:
        """Declarations up to ENDMODULE, to the next MODULE or to the end of the file. loose: there is no MODULE."""
        items: list[syntax.Item] = []
        while (kind := self.kinds[self.i]) not in ("MODULE", "end"):
            whole = self.wholes.get(self.i) if kind == "whole" else None
            if isinstance(whole, syntax.DataDeclaration):
                items.append(whole)
                self.i += 1
            elif kind == ";":
                self.i += 1
            elif kind == "placeholder":
                items.append(self.placeholder())
            elif kind == "ENDMODULE" and not loose:
                break
            else:
                self._try_item(items)
        return tuple(items)

    def _try_item(self, items: list[syntax.Item]) -> None:
        before, depth, blocks = self.i, self.depth, len(self._open)
        try:
            items.append(self._item())
        except InputError as error:
            if self._put_back(error, before, depth, blocks):
                self.skip_to_declaration()
            else:
                self.skip()

    def _item(self) -> syntax.Item:
        start = self.here
        scope = self.kind if self.kind in ("LOCAL", "TASK") else None
        if scope:
            self.i += 1
            if scope == "LOCAL" and self.kind == "TASK" and self.kinds[self.i + 1] == "PERS":
                self.i += 1  # LOCAL TASK PERS stands in real programs; a LOCAL one is the task's own anyway
        kind = self.kind
        if kind in STORAGE:
            return self.data(start, scope)
        if kind in ROUTINES:
            return self._routine(start, scope)
        if kind == "RECORD":
            return self._record(start, scope)
        if kind == "ALIAS":
            self.i += 1
            type_ = self.identifier("a data type after ALIAS")
            name = self.new_name("the new type's name")
            self.semicolon("after the ALIAS declaration")
            return syntax.AliasDeclaration(start, self.behind, scope, type_, name)
        if kind == "ENDMODULE":
            self.fail("a declaration", advice="no MODULE is open here")
        if kind.startswith("END") and kind[3:] in (*ROUTINES, "RECORD", "IF", "FOR", "WHILE", "TEST"):
            word = kind[3:]
            advice = f"no {word} is open here; remove it, or look for one closed too early"
            raise self.error(self.here, f"{kind} without {word}: {advice}")
        advice = "instructions belong in a PROC" if kind in ("name", "whole") else ""
        self.fail("a declaration (VAR, PERS, CONST, PROC, FUNC, TRAP, RECORD, ALIAS) or ENDMODULE", advice=advice)

    def _record(self, start: int, scope: str | None) -> syntax.RecordDeclaration:
        self.i += 1
        name = self.new_name("the record's name")
        self.accept(";")
        self.open_block("RECORD", start, name)
        components: list[tuple[str, str]] = []
        while self.kind == "name":
            type_ = self.identifier("a component's type")
            components.append((type_, self.new_name("a component's name")))
            self.semicolon("after the component")
        self.close_block("ENDRECORD")
        return syntax.RecordDeclaration(start, self.behind, scope, name, tuple(components))

    # --------------------------------------------------------------------------------------------------- routines

    def _routine(self, start: int, scope: str | None) -> syntax.Routine:
        kind = self.kind
        self.i += 1
        type_, name, parameters = self._head(kind)
        self._crossed.clear()
        self.open_block(kind, start, name)
        stops = (*HANDLERS, f"END{kind}")
        body = self.block(stops)
        handlers = []
        while self.kind in HANDLERS:
            handlers.append(self._handler(stops))
        self.close_block(f"END{kind}")
        return syntax.Routine(start, self.behind, scope, kind, type_, name, parameters, body, tuple(handlers))

    def _head(self, kind: str) -> tuple[str | None, str, tuple[syntax.Parameter, ...]]:
        """A routine's type, name and parameters. After a mistake reading goes on in the next line."""
        type_, name, start = None, "", self.here
        parameters: tuple[syntax.Parameter, ...] = ()
        try:
            type_ = self.identifier("the type that the FUNC returns") if kind == "FUNC" else None
            start = self.here
            name = self.new_name(f"the name of the {kind}")
            if kind != "TRAP":
                if not self.accept("("):
                    self.fail(f"'(' after {kind} {name}", self.behind, f"write '{kind} {name}()'")
                parameters = self._parameters(name)
        except InputError as error:
            self.keep(error)
            self.next_line()
            name = name or self.text[start : self.behind].partition("(")[0]
        return type_, name, parameters

    def _handler(self, stops: tuple[str, ...]) -> syntax.Handler:
        start, kind = self.here, self.kind
        self.i += 1
        numbers: tuple[syntax.Expression, ...] | None = ()
        if kind == "ERROR" and self.accept("("):
            numbers = self.header(self.values, ")", "after the error numbers")
        body = self.block(stops)
        return syntax.Handler(start, self.behind, kind, numbers or (), body)

    def _parameters(self, routine: str) -> tuple[syntax.Parameter, ...]:
        parameters: list[syntax.Parameter] = []
        alternative = False
        while not self.accept(")"):
            if parameters and not alternative and self.kinds[self.i] != "\\" and not self.accept(","):
                self.fail(f"',' or ')' after a parameter of {routine}", self.behind)
            parameters.append(self._parameter(alternative))
            alternative = self.accept("|")
        return tuple(parameters)

    def _parameter(self, alternative: bool) -> syntax.Parameter:
        start = self.here
        if self.kinds[self.i] == "placeholder":
            place = self.placeholder()
            return syntax.Parameter(start, place.end, None, "", place.name)
        optional = self.accept("\\") or alternative
        mode = self.kinds[self.i] if self.kinds[self.i] in ("INOUT", "VAR", "PERS") else None
        if mode:
            self.i += 1
        type_ = self.identifier("a parameter's type")
        name = self.new_name(f"a parameter's name after {type_}")
        dimensions = 0
        if self.accept("{"):
            self.expect("*", "for each dimension of an array parameter")
            dimensions = 1
            while self.accept(","):
                self.expect("*", "for each dimension of an array parameter")
                dimensions += 1
            self.expect("}", "after the dimensions")
        return syntax.Parameter(start, self.behind, mode, type_, name, dimensions, optional, alternative)
