"""How far to trust a page: what the judge found, what is estimated and how sure, what the page was made from."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from trajopt_cli.findings import Report, good_side, nearest
from trajopt_cli.page.cycles import place
from trajopt_cli.page.encode import text
from trajopt_cli.page.tables import points, table
from trajopt_cli.problem.plant import Plant
from trajopt_cli.units import DEG, MM

GRADES = "Grades: A several sources agree, B one good source, C a weak one or inferred, D an estimate."


def judged(name: str, report: Report, opened: bool) -> str:
    """The verdict and the tightest case of each check. opened: as the page is first shown."""
    bad = sum(not one.passed for one in report.findings)
    word, kind = ("legal", "good") if report.legal else (f"not legal: {bad} checks failed", "bad")
    rows = []
    for one, cases in nearest(report.findings):
        rows.append(
            (
                text(one.check),
                str(cases),
                text(one.subject),
                _figure(one.value, 6),
                _figure(one.limit, 6),
                _figure(good_side(one), 3),
                text(one.unit),
                "" if one.time is None else f"{one.time:.3f}",
                text(place(one.source)),
                '<span class="good">passed</span>' if one.passed else '<span class="bad">failed</span>',
            )
        )
    heads = ("check", ">cases", "nearest case", ">value", ">limit", ">margin", "unit", ">at [s]", "place", "")
    verdict = f'<h3>{text(name)}: <span class="verdict {kind}">{word}</span></h3>'
    shown = table(f"{name}: {len(report.findings)} checks", heads, rows, html=True)
    return f"<details{' open' if opened else ''}><summary>{verdict}</summary>{shown}</details>"


def limits(plant: Plant) -> str:
    """Every limit in force, with the grade of its source."""
    given, rows = plant.limits, []
    for k, name in enumerate(given.names):
        scale, unit = (MM, "mm") if name == "rail" else (DEG, "deg")
        rows.append(
            (
                name.replace("_", " "),
                _figure(given.lower[k] / scale, 6),
                _figure(given.upper[k] / scale, 6),
                unit,
                _figure(given.velocity[k] / scale, 5),
                f"{unit}/s",
                _figure(given.acceleration[k] / scale, 5),
                f"{unit}/s²",
                given.sources.get(f"{name}.acceleration", ""),
            )
        )
    heads = ("axis", ">from", ">to", "unit", ">speed", "unit", ">acceleration", "unit", "acceleration from")
    return table("Limits in force", heads, rows)


def doubts(lines: Sequence[str], unchecked: Sequence[str], warnings: Sequence[str], notes: Sequence[str]) -> str:
    """Estimated, unchecked and assumed; what the plans changed in the program."""
    parts = (
        ("Limits", lines),
        ("Not checked", unchecked),
        ("Warnings", warnings),
        ("Notes on the plans and their RAPID text", notes),
    )
    return "".join(f"<h3>{heading}</h3>{points(said)}" for heading, said in parts if said)


def hashes(files: Mapping[str, str]) -> str:
    """The SHA-256 of each file, by its name."""
    return table("Files that were read", ("file", "SHA-256"), [(name, digits) for name, digits in files.items()])


def _figure(value: float, digits: int) -> str:
    return f"{value:.{digits}g}".replace("-", "−") if math.isfinite(value) else "–"
