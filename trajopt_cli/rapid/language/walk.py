"""Every node of a syntax tree."""

from __future__ import annotations

from dataclasses import fields, is_dataclass

from trajopt_cli.rapid.language.syntax import Node


def walk(node: object) -> list[Node]:
    """A node of a syntax tree and all nodes under it, in no particular order."""
    stack, found = [node], []
    while stack:
        thing = stack.pop()
        if isinstance(thing, tuple):
            stack += thing
        elif isinstance(thing, Node):
            found.append(thing)
            if is_dataclass(thing):
                stack += [getattr(thing, part.name) for part in fields(thing)]
    return found
