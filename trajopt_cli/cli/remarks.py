"""What is said below an answer, kept short: files by name as in the tables, of many remarks alike the first ones."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator

from trajopt_cli.table import by_name
from trajopt_cli.warnings import ProgramWarning, WarningKind

_MOST = 6  # remarks of one kind
_OWN = re.compile(r"\S*[\d_()\[\]'\"]\S*")  # what names one thing: places, names with figures, numbers, quoted words


def remarks(label: str, lines: Iterable[str], files: Iterable[str], rest: str) -> Iterator[str]:
    """Lines in their order, with a label before each; of those that differ only in names, places and figures the first
    few, and how many more there are. rest: where all of them are, `all in summary.json`."""
    texts = [by_name(line, files) for line in lines]
    kinds = [_OWN.sub("#", text) for text in texts]
    count, told = Counter(kinds), Counter[str]()
    before = f"{label}: " if label else ""
    for text, kind in zip(texts, kinds, strict=True):
        told[kind] += 1
        if told[kind] <= _MOST:
            yield f"{before}{text}"
        if told[kind] == _MOST < count[kind]:
            yield f"{before}and {count[kind] - _MOST} more of this kind, {rest}"


def told_first(notices: Iterable[ProgramWarning]) -> tuple[list[str], list[str]]:
    """The lines that stand over an answer, because it does not hold what they speak of; and the other notices."""
    notices = list(notices)
    head = [f"WARNING: {one}" for one in notices if one.kind is WarningKind.NOT_CHECKED]
    return head, [str(one) for one in notices if one.kind is not WarningKind.NOT_CHECKED]
