"""Texts and bytes with a few things wrong, from a seed alone."""

from __future__ import annotations

import random
import re
from collections.abc import Sequence


def words(text: str) -> tuple[str, ...]:
    """Its words, for lists of them."""
    return tuple(text.split())


NUMBERS = (
    *words("0 -1 1 2 0.5 -0.0 9E9 1e38 1e308 1e309 -1e400 1E-45 nan inf -inf 8388609 0x10 1. .5 1_000 99999 180"),
    *words("3.14159265358979 ٣ ½ 1e 0b1 007 1,5 true null ~ ''"),
    *("9" * 30, "-9" * 20),
)
SIGNS = (
    *("\x00", "\x07", "\x1b[31m", "\r", "\x85", "\u2028", "\u202e", "\u3000", "\ufeff", "\t", " ", "\n", "\n\n"),
    *words("ß İ \U0001f916 \" ' \\ %s {} {0} $x ` & < > / // .. ../ ~ : ; , . # ! [ ] ( ) { } * - + = | ? @"),
)
BYTES = (
    b"\x00",
    b"\xff",
    b"\xfe\xff",
    b"\xef\xbb\xbf",
    b"\xed\xa0\x80",
    b"\xc0\x80",
    b"\x80",
    b"\x1a",
    b"\xf4\x90\x80\x80",
)
_WORD = re.compile(r"-?\d[\w.+-]*|\w+|[^\w\s]")
_NUMBER = re.compile(r"-?\d+\.?\d*(?:[eE][+-]?\d+)?")
LONGEST = 60_000  # bytes of a case: longer ones take their time without new behaviour


def mutated(rng: random.Random, seeds: Sequence[bytes], known: Sequence[str] = ()) -> bytes:
    """One of seeds with one to six things wrong; known: words of the format."""
    data = rng.choice(seeds)
    if rng.random() < 0.1:
        return _raw(rng, data)[:LONGEST]
    text = data.decode("utf-8", "surrogateescape")
    for _ in range(rng.choice((1, 1, 1, 2, 3, 6))):
        text = _changed(rng, text, seeds, known)
    return text.encode("utf-8", "surrogateescape" if rng.random() < 0.99 else "surrogatepass")[:LONGEST]


def _raw(rng: random.Random, data: bytes) -> bytes:
    raw = bytearray(data)
    for _ in range(rng.choice((1, 1, 2, 5, 20))):
        at = rng.randrange(len(raw) + 1)
        kind = rng.randrange(4)
        if kind == 0:
            raw[at:at] = rng.choice(BYTES)
        elif kind == 1 and at < len(raw):
            raw[at] = rng.randrange(256)
        elif kind == 2 and at < len(raw):
            raw[at] ^= 1 << rng.randrange(8)
        else:
            del raw[at : at + rng.choice((1, 4, 30))]
    return bytes(raw)


def _changed(rng: random.Random, text: str, seeds: Sequence[bytes], known: Sequence[str]) -> str:
    i = rng.randrange(len(text) + 1)
    j = min(len(text), i + rng.choice((1, 3, 10, 60, 400)))
    kind = rng.randrange(14)
    if kind == 0:
        return text[:i] + text[j:]
    if kind == 1:
        return text[:j] + text[i:j] * rng.choice((1, 2, 30)) + text[j:]
    if kind == 2:
        return text[:i] + rng.choice(SIGNS) + text[i:]
    if kind == 3:
        other = rng.choice(seeds).decode("utf-8", "surrogateescape")
        k = rng.randrange(len(other) + 1)
        return text[:i] + other[k : k + rng.choice((5, 40, 300))] + text[i:]
    if kind == 4 and rng.random() < 0.3:
        return text[:i]
    if kind in (5, 6):
        lines = text.split("\n")
        a, b = rng.randrange(len(lines)), rng.randrange(len(lines))
        if kind == 5:
            lines[a], lines[b] = lines[b], lines[a]
        elif rng.random() < 0.5:
            del lines[a]
        else:
            lines.insert(b, lines[a])
        return "\n".join(lines)
    if kind in (7, 8, 9):
        return _at(rng, text, _NUMBER, lambda old: _number(rng, old))
    return _at(rng, text, _WORD, lambda old: _word(rng, text, known))


def _at(rng: random.Random, text: str, what: re.Pattern[str], new: object) -> str:
    """text with one match of a pattern replaced; looked for from a random place on, which costs less than all."""
    match = what.search(text, rng.randrange(len(text) + 1)) or what.search(text)
    return text if match is None else text[: match.start()] + new(match[0]) + text[match.end() :]  # type: ignore[operator]


def _number(rng: random.Random, old: str) -> str:
    kind = rng.randrange(5)
    if kind < 2:
        return rng.choice(NUMBERS)
    try:
        value = float(old)
    except ValueError:
        return rng.choice(NUMBERS)
    if kind == 2:
        return repr(-value)
    if kind == 3:
        return repr(value * rng.choice((1e-9, 0.5, 1.0001, 2, 10, 1e3, 1e9)))
    return repr(value + rng.choice((-1, 1, 1e-7, 360)))


def _word(rng: random.Random, text: str, known: Sequence[str]) -> str:
    if known and rng.random() < 0.6:
        return rng.choice(known)
    if rng.random() < 0.5:
        return rng.choice(NUMBERS)
    match = _WORD.search(text, rng.randrange(len(text) + 1))
    return match[0] if match else "x"
