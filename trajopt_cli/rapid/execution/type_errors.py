"""The error for a value of another type than its place asks for, and how it learns what that place is called."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.errors import InputError
from trajopt_cli.rapid.data.datatypes import Type, Value
from trajopt_cli.rapid.language.syntax import Expression

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Execution

_SHOWN = 40  # characters of an expression in a message


class Mismatch(InputError):
    """A value of another type than its place asks for. node: the expression. claim: "needs a num, found bool TRUE".

    Who knows what the place is called says so: the nearest one.
    """

    def __init__(self, node: Expression, claim: str, place: InputError):
        super().__init__(f"needs {claim}", file=place.file, line=place.line, column=place.column, excerpt=place.excerpt)
        self.node, self._claim, self._said = node, claim, False

    def about(self, node: Expression | None, subject: str) -> Mismatch:
        """Itself, with what needs the value where that is the place of node."""
        if node is self.node and not self._said:
            self.message, self._said = f"{subject} needs {self._claim}", True
            self.args = (self.message,)
        return self


def mismatch(run: Execution, node: Expression, wanted: Type, found: Value | None) -> Mismatch:
    """The error for an expression that is not of the type its place asks for. found: its value; None: an aggregate."""
    text = run.text(node)
    shown = text if len(text) <= _SHOWN else f"{text[:_SHOWN]}..."
    claim = f"{_article(wanted.name)} {wanted.name}, found {f'{found.type.name} {shown}' if found else 'an aggregate'}"
    return Mismatch(node, claim, run.error(node, ""))


def _article(name: str) -> str:
    return "an" if name[0] in "aeio" else "a"
