"""What a cell file must still say, as text to paste into it."""

from __future__ import annotations

from collections.abc import Sequence

from trajopt_cli.scenario import NAME_LISTS, Lack, yaml_name

_SECTIONS = ("signals", "answers", "data", "searches", "endless_passes", *NAME_LISTS)


def template(lacks: Sequence[Lack]) -> str:
    """YAML for what the scenario lacks, grouped by key of the cell file, each entry with the place that asked first.

    The values are such as to begin with; a key that the cell file already has takes the new entries itself. Entries
    stand in the order of the program's run, "" for no lacks.
    """
    lines: list[str] = []
    for section in _SECTIONS:
        found = [lack for lack in lacks if lack.section == section]
        if not found:
            continue
        if section == "endless_passes":  # one number for all loops
            lines.append(f"endless_passes: {found[0].value}{_comment(found[0])}")
            continue
        lines.append(f"{section}:")
        for lack in found:
            entry = f"- {yaml_name(lack.name)}" if section in NAME_LISTS else _pair(lack)
            lines.append(f"  {entry}{_comment(lack)}")
    return "".join(f"{line}\n" for line in lines)


def _pair(lack: Lack) -> str:
    return f"{yaml_name(lack.name)}: {lack.value}"


def _comment(lack: Lack) -> str:
    """On one line, of signs that YAML takes in a comment."""
    meant = "" if lack.close is None else f"; did you mean '{lack.close}'?"
    text = " ".join(f"{lack.source}, {lack.reason}{meant}".split())
    return "  # " + "".join(sign if sign.isprintable() else "?" for sign in text)
