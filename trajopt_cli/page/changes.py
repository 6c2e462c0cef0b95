"""What the plan changes in the program's text: its diff, and beside each new line the motions that it changes."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from trajopt_cli.page.document import Section
from trajopt_cli.page.encode import text
from trajopt_cli.page.tables import points
from trajopt_cli.runs.summary import SETTLING, MotionRow, Summary
from trajopt_cli.table import seconds

MOST = 1_500
"""Lines of a diff on a page; `trajopt export rapid --diff` prints all of any."""
_HUNK = re.compile(r"@@ -(\d+)\S* \+(\d+)\S* @@")
_FIGURE = re.compile(r"[\w.+-]+$")
_NAME = re.compile(r"\w+")
_ROW = (
    '<div class="src{kind}"><span class="number">{number}</span><span class="text">{text}</span>'
    '<span class="saved">{motions}</span></div>'
)


def changes_section(diff: str, told: Summary) -> Section:
    """diff: as `trajopt export rapid` prints it; a sentence that is none says why there is none."""
    lines = diff.split("\n")[:-1]
    if not diff.startswith("--- "):
        why = [f"No RAPID text: {diff}."] if diff else [*told.kept, "The plan needs no change to the program."]
        return Section("changes", "RAPID", points(why))
    more = f"; the first {MOST} of {len(lines)} lines" if len(lines) > MOST else ""
    lead = (
        f"What the rapid plan changes in the program{more}; beside each line the motions it changes, as written → as "
        "planned. trajopt export rapid writes it as one file, over the program, or as a patch."
    )
    shown = "".join(_rows(lines[:MOST], told))
    box = f'<div class="scroll own-keys diff" id="changes" role="region" aria-label="RAPID" tabindex="0">{shown}</div>'
    return Section("changes-of-text", "RAPID", box, lead)


def _rows(lines: Sequence[str], told: Summary) -> Iterator[str]:
    """The diff's lines as HTML."""
    named, placed = dict[str, list[MotionRow]](), dict[tuple[str, str], list[MotionRow]]()
    for one in told.plans.rapid.motions:
        if one.instruction == SETTLING:
            continue
        named.setdefault(one.target.lower(), []).append(one)
        file, line, _ = f"::{one.source}".rsplit(":", 2)
        placed.setdefault((file.removeprefix("::"), line), []).append(one)
    file, old, new, gone = "", 0, 0, list[tuple[int, str]]()
    for k, line in enumerate(lines):
        sign, rest = line[:1], line[1:].rstrip("\r")
        if line.startswith("--- ") and lines[k + 1 : k + 2] and lines[k + 1].startswith("+++ "):
            file = line[4:].rstrip("\t").removeprefix("a/")
        elif line.startswith("+++ ") and lines[k - 1].startswith("--- "):
            yield f"<h3>{text(line[4:].rstrip().removeprefix('b/'))}</h3>"
        elif found := _HUNK.match(line):
            old, new, gone = int(found[1]), int(found[2]), []
            yield '<div class="gap">⋯</div>' if k > 2 else ""
        elif sign == "-":
            gone.append((old, rest))
            yield _ROW.format(kind=" del", number=f"− {old}", text=text(rest), motions="")
            old += 1
        elif sign == "+":
            at, was = max(gone, key=lambda one: _common(one[1], rest), default=(0, ""))
            names = dict.fromkeys(name.lower() for name in _NAME.findall(rest))
            meant = placed.get((file, str(at))) or [one for name in names for one in named.get(name, ())]
            chips = "".join(_chips(meant, told))
            yield _ROW.format(kind=" add", number=f"+ {new}", text=_marked(was, rest), motions=chips)
            new += 1
        elif sign == " ":
            yield _ROW.format(kind="", number=new, text=text(rest), motions="")
            old, new, gone = old + 1, new + 1, []


def _common(one: str, other: str) -> int:
    """How many characters two texts begin alike with."""
    pairs = enumerate(zip(one, other, strict=False))
    return next((i for i, (a, b) in pairs if a != b), min(len(one), len(other)))


def _marked(was: str, now: str) -> str:
    """A new line with what differs from the old one in bold, where both declare or do the same."""
    first = len(_FIGURE.sub("", now[: _common(was, now)]))
    if not now[:first].strip() or ":=" in now[first:].split(",")[0]:
        return text(now)
    end = len(_FIGURE.sub("", now[: first - 1 : -1][: _common(was[first:][::-1], now[first:][::-1])]))
    end = len(now) - end
    return f"{text(now[:first])}<b>{text(now[first:end])}</b>{text(now[end:])}" if first < end else text(now)


def _chips(motions: Sequence[MotionRow], told: Summary) -> Iterator[str]:
    """A button per motion of a line, its passes together: what it took and what it takes."""
    groups: dict[tuple[str, str], list[MotionRow]] = {}
    for one in motions:
        groups.setdefault((one.place, one.name), []).append(one)
    before = told.written_times
    for (_, name), passes in groups.items():
        was = [before[one.index] for one in passes if one.index in before]
        old = f"{seconds(sum(was))} → " if was else ""
        often = f"{len(passes)} × " if len(passes) > 1 else ""
        took = f"{old}{seconds(sum(one.time_s for one in passes))} s"
        yield f'<button type="button" data-motion="{passes[0].index}">{often}{text(name)} {took}</button>'
