"""Errors that a RAPID program can handle itself: those with an ERR_ number of their own."""

from __future__ import annotations

from trajopt_cli.errors import InputError


class Fault(InputError):
    """A run-time error of the controller, such as a division by zero. Unhandled it is the user's InputError.

    number: what ERRNO is while it is handled. name: the ERR_ constant, or the number in words.
    """

    def __init__(self, message: str, name: str, number: float, *, file: str, line: int, column: int):
        super().__init__(message, file=file, line=line, column=column)
        self.name, self.number = name, number
