"""URDF text to elements: bounded, without document types, and with one line for what is no XML or is still xacro."""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree import ElementTree
from xml.parsers import expat

from trajopt_cli.errors import InputError

MAX_BYTES = 20_000_000
"""Of a URDF: a hundred times the longest ones that are written by hand or by CAD, which keep their meshes beside."""
MAX_DEPTH, MAX_ELEMENTS = 50, 200_000
_XACRO = re.compile(rb"<xacro:([\w.-]+)|(\$[{(][^})\n]{0,40}[})])")
_NAMESPACE = re.compile(r"\{[^}]*xacro[^}]*\}(.*)")


class _RefusedError(Exception):
    """What no URDF needs; its text says what to do."""


def read_robot_element(path: Path) -> ElementTree.Element:
    """The <robot> element of a URDF. Raises InputError for a file that cannot be read, and as robot_element does."""
    return robot_element(read_bytes(path), str(path))


def read_bytes(path: Path) -> bytes:
    """A URDF's bytes. Raises InputError for a file that cannot be read."""
    try:
        with open(path, "rb") as opened:
            return opened.read(MAX_BYTES + 1)  # no more of it: a device may have no end
    except OSError as error:
        raise InputError(f"cannot read the URDF: {error.strerror}", file=str(path)) from error


def robot_element(text: bytes, file: str) -> ElementTree.Element:
    """The <robot> element of a URDF's text; file is for messages. Raises InputError for a text that is too big, is no
    XML, has a document type (its entities could grow without bound), is xacro, or whose root is another element."""
    if len(text) > MAX_BYTES:
        raise InputError(f"is larger than {MAX_BYTES // 10**6} MB: keep meshes in files of their own", file=file)
    try:
        _refuse_bombs(text)
        root = ElementTree.fromstring(text)
    except _RefusedError as error:
        raise InputError(str(error), file=file) from error
    except (ElementTree.ParseError, expat.ExpatError, LookupError, ValueError) as error:
        _refuse_xacro(text, None, file)
        raise InputError(f"not a URDF: {error}", file=file) from error
    _refuse_xacro(text, root, file)
    if root.tag != "robot":
        raise InputError(f"not a URDF: its root is <{root.tag}>, wanted <robot>", file=file)
    return root


def _refuse_bombs(text: bytes) -> None:
    """Look for what would take memory without bound, before anything is kept."""
    parser = expat.ParserCreate()
    depth = count = 0

    def document_type(*_: object) -> None:
        raise _RefusedError("has a document type (<!DOCTYPE ...>): a URDF needs none; remove it")

    def opened(*_: object) -> None:
        nonlocal depth, count
        depth, count = depth + 1, count + 1
        if depth > MAX_DEPTH or count > MAX_ELEMENTS:
            what = f"elements {depth} deep" if depth > MAX_DEPTH else f"more than {MAX_ELEMENTS:,} elements"
            raise _RefusedError(f"has {what}: no robot has; give the URDF of one robot")

    def closed(*_: object) -> None:
        nonlocal depth
        depth -= 1

    parser.StartDoctypeDeclHandler = document_type
    parser.StartElementHandler, parser.EndElementHandler = opened, closed
    parser.Parse(text, True)


def _refuse_xacro(text: bytes, root: ElementTree.Element | None, file: str) -> None:
    what = None
    if root is None:
        match = _XACRO.search(text)
        what = match and (f"<xacro:{match[1].decode()}>" if match[1] else match[2].decode("utf-8", "replace"))
    else:
        for element in root.iter():
            tag = _NAMESPACE.fullmatch(str(element.tag))
            values = [value for value in element.attrib.values() if "${" in value or "$(" in value]
            if tag or values:
                what = f"<xacro:{tag[1]}>" if tag else values[0]
                break
    if what:
        place = text.find(what.rstrip(">").encode())
        line = text[:place].count(b"\n") + 1 if place >= 0 else None
        message = f"is xacro, not yet a URDF ({what}): expand it first with 'xacro {Path(file).name} > robot.urdf'"
        raise InputError(message, file=file, line=line)
