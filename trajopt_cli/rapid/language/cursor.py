"""A file's tokens under a moving finger, what is said when they are not the expected ones, and how reading goes on."""

from __future__ import annotations

import re
from typing import NoReturn

from trajopt_cli.errors import InputError, InputErrorGroup
from trajopt_cli.rapid.language.fast_path import NAME_LIMIT
from trajopt_cli.rapid.language.lexer import KEYWORDS, Whole, scan
from trajopt_cli.rapid.language.syntax import DataDeclaration
from trajopt_cli.rapid.language.text import Places

ERROR_LIMIT = 20  # errors that one run tells of a file
NESTING_LIMIT = 60  # no program nests deeper; each level costs a dozen Python frames

STORAGE = ("VAR", "PERS", "CONST")
HANDLERS = ("ERROR", "UNDO", "BACKWARD")
# What a statement, a part of one, or a declaration begins or ends with: where reading can go on after a mistake.
_DECLARATIONS = frozenset({"LOCAL", "TASK", *STORAGE, "PROC", "FUNC", "TRAP", "RECORD", "ALIAS", "MODULE", "ENDMODULE"})
_ROUTINE_WORDS = frozenset({"PROC", "FUNC", "TRAP", "MODULE", *(word for word in KEYWORDS if word.startswith("END"))})
RESTARTS = frozenset(
    {"IF", "FOR", "WHILE", "TEST", "GOTO", "RETURN", "RAISE", "EXIT", "RETRY", "TRYNEXT", "CONNECT", "ELSE", "ELSEIF"}
    | {"CASE", "DEFAULT", "whole", "end", *HANDLERS, *_DECLARATIONS}
    | {word for word in KEYWORDS if word.startswith("END")}
)
_ODD_NAME = re.compile(r"[\w.-]*+(?:\([\w.-]*+\))?+[\w.-]*+")
OTHER_LANGUAGES = {"&": "AND", "|": "OR"}


class Cursor:
    """Reads the tokens of one file. Mistakes are kept, so that one run can report several."""

    def __init__(self, text: str, file: str, whole: Whole | None = None):
        self.places = Places(text, file)
        self.text = text
        tokens = scan(text, whole)
        self.comments = tuple(tokens.comments)
        self.kinds, self.texts, self.starts, self.wholes = tokens.kinds, tokens.texts, tokens.starts, tokens.wholes
        self.i = 0
        self.depth = 0
        self.warnings: list[tuple[int, str]] = []
        self._errors: dict[tuple[int, int], InputError] = {}  # by line and column
        self._more = 0
        self._given_up = False
        for start, end in tokens.foreign:
            wrong = "/*" if text.startswith("/*", start) else "//"
            inside = " on each of its lines" if "\n" in text[start:end] else ""
            self.note(start, f"expected '!' before a comment, found '{wrong}'; write '!'{inside}")

    # ------------------------------------------------------------------------------------------------- the tokens

    @property
    def kind(self) -> str:
        """The kind of the current token."""
        return self.kinds[self.i]

    @property
    def here(self) -> int:
        """Where the current token starts."""
        return self.starts[self.i]

    @property
    def behind(self) -> int:
        """Where the previous token ends."""
        if not self.i:
            return 0
        whole = self.wholes.get(self.i - 1)
        return whole.end if whole is not None else self.starts[self.i - 1] + len(self.texts[self.i - 1])

    def new_line(self) -> bool:
        """Whether the current token stands on a later line than the previous one."""
        return self.kinds[self.i] == "end" or self.new_line_between(self.behind, self.here)

    def new_line_between(self, start: int, end: int) -> bool:
        """Whether a line ends between two offsets."""
        return self.text.find("\n", start, end) >= 0 or self.text.find("\r", start, end) >= 0

    def accept(self, kind: str) -> bool:
        """Step over the current token if it is of this kind."""
        if self.kinds[self.i] == kind:
            self.i += 1
            return True
        return False

    def expect(self, kind: str, where: str, advice: str = "") -> None:
        """Step over a token of this kind; where completes "expected ')' ..."."""
        if self.kinds[self.i] != kind:
            self.fail(f"'{kind}' {where}", advice=advice)
        self.i += 1

    def semicolon(self, where: str, also: str = "") -> None:
        """Step over a semicolon. A missing one at a line's end is noted and reading goes on in the next line."""
        if self.accept(";"):
            return
        if not self.new_line() or self.kind in WRONG:
            self.fail(f"{also}';' {where}", self.behind)
        self.note(self.behind, self.sentence(f"';' {where}", "write ';' here"))
        if self.kind == "name" and self.kinds[self.i + 1] in (",", ";", ")"):
            self.skip()  # the rest of the same statement

    def identifier(self, what: str) -> str:
        """Step over a name (or a placeholder for one); what says which kind of name."""
        kind, text = self.kinds[self.i], self.texts[self.i]
        if kind not in ("name", "placeholder"):
            if kind in KEYWORDS:
                message = self.sentence(what, "that is a reserved word, so choose another name")
                self.i += 1  # it begins no statement here
                raise self.error(self.starts[self.i - 1], message)
            self.fail(what)
        self.i += 1
        return text

    def new_name(self, what: str, inside: tuple[str, ...] = ("number", "name")) -> str:
        """As identifier, for a name that is given here; too long a one is worth a warning.

        inside: kinds of token that in parentheses behind the name are taken as a part of it, which is a mistake.
        """
        start = self.here
        name = self.identifier(what)
        follows = self.kinds[self.i : self.i + 3]
        if follows[0] in ("-", ".") or (follows[0] == "(" and follows[1] in inside and follows[2] == ")"):
            self.odd_name(start)
        if len(name) > NAME_LIMIT:
            message = f"'{name}' has {len(name)} characters; a controller takes at most {NAME_LIMIT} in a name"
            self.warnings.append((start, message))
        return name

    def odd_name(self, start: int) -> NoReturn:
        """Say that what stands at start cannot be a name."""
        match = _ODD_NAME.match(self.text, start)
        assert match is not None  # it matches nothing at all, too
        message = f"expected a name, found '{short(match[0])}'; "
        message += "a name begins with a letter and has only letters, digits and '_', so rename it wherever it is used"
        raise self.error(start, message)

    def deeper(self) -> None:
        """Count one level of nesting; the caller takes it back."""
        self.depth += 1
        if self.depth > NESTING_LIMIT:
            error = self.error(self.here, f"nested deeper than {NESTING_LIMIT} levels: split it up")
            self.keep(error)
            self._given_up = True
            self.i = len(self.kinds) - 1
            raise error

    # ------------------------------------------------------------------------------------------------- the mistakes

    def found(self) -> str:
        """The current token in words."""
        kind, text = self.kinds[self.i], self.texts[self.i]
        if kind == "end":
            return "the end of the file"
        if kind == "unclosed":
            return "a string that is not closed on its line"
        if kind == "whole":
            text = self.text[self.here : self.wholes[self.i].end].split()[0]
        elif text in OTHER_LANGUAGES and self.text.startswith(2 * text, self.here):
            text *= 2
        shown = short(text)
        return f"'{shown}'" if shown.isprintable() else repr(shown)

    def sentence(self, expected: str, advice: str = "") -> str:
        """What was expected, what was found, what to do."""
        return f"expected {expected}, found {self.found()}{'; ' if advice else ''}{advice}"

    def error(self, offset: int, message: str) -> InputError:
        """An InputError at an offset; of those beyond the limit nobody will see the place."""
        return InputError(message) if len(self._errors) >= ERROR_LIMIT else self.places.error(offset, message)

    def fail(self, expected: str, offset: int | None = None, advice: str = "") -> NoReturn:
        """Raise the InputError at the current token (or at offset). Frequent mistakes have advice of their own."""
        before, at = self.behind, self.here
        if (odd := self.odd_comment()) is not None:
            raise self.error(odd, "expected '<>' for 'not equal', found '!='; '!' begins a comment, so write '<>'")
        if self.kind == "name" and self.i and self.kinds[self.i - 1] == "number" and before == at:
            self.odd_name(self.starts[self.i - 1])
        last = at + len(self.texts[self.i])
        if self.kind == "number" and self.text[last : last + 1].isalpha():
            self.odd_name(at)
        if offset is None or self.kind in WRONG or self.texts[self.i] in OTHER_LANGUAGES:
            offset = at
        raise self.error(offset, self.sentence(expected, advice or self.advice(expected)))

    def odd_comment(self) -> int | None:
        """Where a comment before the current token begins with `!=`, as other languages write `<>`."""
        gap = self.text[self.behind : self.here].lstrip()
        return self.here - len(gap) if gap.startswith("!=") else None

    def advice(self, expected: str) -> str:
        """What to do about a frequent mistake at the current token."""
        kind = self.kind
        if kind == "unclosed":
            return "close it with '\"'"
        if kind == ")" and not expected.startswith("an "):
            return "no '(' opens it, so remove it"
        if kind in ("=", "==", ":="):
            return "':=' assigns, '=' compares"
        if self.texts[self.i] in OTHER_LANGUAGES:
            return f"write {OTHER_LANGUAGES[self.texts[self.i]]}"
        return ""

    def note(self, offset: int, message: str) -> None:
        """Keep a mistake, and read on."""
        self.keep(self.error(offset, message))

    def keep(self, error: InputError) -> None:
        """Keep an error that was raised, and read on. Of two at one place the second is a consequence."""
        if self._given_up:
            return
        if error.line is None:
            self._more += 1
        else:
            self._errors.setdefault((error.line, error.column or 0), error)

    def finish(self) -> None:
        """Raise all that was kept: InputError for one, InputErrorGroup for several, in the order of the text."""
        errors = [self._errors[key] for key in sorted(self._errors)]
        if self._more:
            mistakes = "mistakes" if self._more > 1 else "mistake"
            errors.append(InputError(f"and {self._more} more {mistakes}", file=self.places.file))
        if errors:
            raise errors[0] if len(errors) == 1 else InputErrorGroup(errors)

    def skip(self) -> None:
        """Go behind the next semicolon, or to the next word that a statement or a declaration begins or ends with."""
        while (kind := self.kinds[self.i]) not in RESTARTS:
            self.i += 1
            if kind in (";", "unclosed"):
                return

    def next_line(self) -> None:
        """Go to the first token of the next line, or to a word before it that ends or begins a routine or a module."""
        while not self.new_line() and self.kind not in _ROUTINE_WORDS:
            self.i += 1

    def skip_to_declaration(self) -> None:
        """Go to the next declaration or the end of the module."""
        while (kind := self.kinds[self.i]) not in _DECLARATIONS and kind != "end":
            if kind == "whole" and isinstance(self.wholes[self.i], DataDeclaration):
                return
            self.i += 1


WRONG = (")", "unclosed", "=", "==", ":=")


def short(text: str) -> str:
    """A piece of the file as it may stand in a message."""
    return text if len(text) <= 40 else text[:37] + "..."
