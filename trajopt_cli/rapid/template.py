"""What a cell file must still say, as text to paste into it."""

from __future__ import annotations

from collections.abc import Sequence

from trajopt_cli.scenario import NAME_LISTS, Missing, yaml_name

_SECTIONS = ("signals", "answers", "data", "searches", *NAME_LISTS)


def template(missing: Sequence[Missing]) -> str:
    """YAML for what the scenario does not say, by key of the cell file, each entry with the place that asked first.

    The values are such as to begin with; a key that the cell file already has takes the new entries itself. Entries
    stand in the order of the program's run, "" where nothing is missing.
    """
    lines: list[str] = []
    for section in _SECTIONS:
        found = [one for one in missing if one.section == section]
        if not found:
            continue
        lines.append(f"{section}:")
        for one in found:
            name = yaml_name(one.name)
            entry = f"- {name}" if section in NAME_LISTS else f"{name}: {one.value}"
            lines.append(f"  {entry}{_comment(one)}")
    return "".join(f"{line}\n" for line in lines)


def _comment(one: Missing) -> str:
    """On one line, of signs that YAML takes in a comment."""
    meant = "" if one.close is None else f"; did you mean '{one.close}'?"
    text = " ".join(f"{one.source}, {one.reason}{meant}".split())
    return "  # " + "".join(sign if sign.isprintable() else "?" for sign in text)
