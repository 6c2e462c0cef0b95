"""Which statement around a motion ran exactly once: the one that an export may write out anew."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Optional

from trajopt_cli.motion import Motion, Span, Written
from trajopt_cli.rapid.language.syntax import Statement

# A statement that runs, those around it up to the entry procedure (None there), and the file it stands in.
Link = tuple[Statement, Optional["Link"], str]


def fill_once(motions: Sequence[Motion], links: Sequence[Link | None], counts: Mapping[int, int]) -> None:
    """Fill Written.once of every motion. links: the statement that made each; counts: how often it ran, by its id.

    The motions are still the run's own, so they are filled in place: made anew, a hundred thousand of them would take
    as long as the rest of the run.
    """
    known: dict[int, Span | None] = {}
    filled: dict[int, Written] = {}
    for motion, link in zip(motions, links, strict=True):
        written = motion.written
        own = written.statement
        if link is not None and counts[id(link[0])] == 1 and link[0].start == own.start and link[2] == own.file:
            object.__setattr__(written, "once", own)  # nearly always
            continue
        once = _once(link, counts, known)
        if id(written) in filled and written.once != once:  # one Written for several runs of a statement
            object.__setattr__(motion, "written", replace(written, once=once))
            continue
        object.__setattr__(written, "once", once)
        filled[id(written)] = written


def _once(link: Link | None, counts: Mapping[int, int], known: dict[int, Span | None]) -> Span | None:
    passed = []
    span: Span | None = None
    while link is not None:
        if id(link) in known:
            span = known[id(link)]
            break
        node, outer, file = link
        if counts[id(node)] == 1:
            span = known[id(link)] = Span(file, node.start, node.end)
            break
        passed.append(id(link))
        link = outer
    for key in passed:
        known[key] = span
    return span
