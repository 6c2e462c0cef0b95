"""Packages that can be called: a room of this house is also the one function that people come for."""

from __future__ import annotations

import sys
from collections.abc import Callable
from importlib import import_module
from types import ModuleType
from typing import Any


class _Room(ModuleType):
    """A package with a door; that a module may take another class is in Python's data model, 3.3.2.1."""

    _door: str

    def __call__(self, *arguments: Any, **options: Any) -> Any:
        return self._function()(*arguments, **options)

    @property
    def __signature__(self) -> Any:  # what help() and inspect.signature() show
        from inspect import signature

        return signature(self._function())

    def _function(self) -> Callable[..., Any]:
        module, name = self._door.split(":")
        function: Callable[..., Any] = getattr(import_module(module), name)
        return function


def open_door(room: str, door: str) -> None:
    """Let the package room be called as the function door, "module:function", imported on the first call.

    trajopt_cli.verify is a package and a step of the data's journey. As a plain function of that name it would hide the
    package, or be hidden by it, whichever is imported last.
    """
    package = sys.modules[room]
    package.__class__ = _Room
    assert isinstance(package, _Room)
    package._door = door
