"""Frozen dataclasses made in bulk.

Their own constructor sets field by field through object.__setattr__, which is most of the time that a motion costs. A
program has a hundred thousand motions, each with its places in the text.
"""

from __future__ import annotations

from typing import Any, TypeVar

_Thing = TypeVar("_Thing")
_new = object.__new__


def made(kind: type[_Thing], parts: dict[str, Any]) -> _Thing:
    """An instance of a frozen dataclass without slots from its fields; arrays among them must be read-only.

    A field that is left out must be set before anybody else sees the instance.
    """
    thing = _new(kind)
    thing.__dict__.update(parts)
    return thing
