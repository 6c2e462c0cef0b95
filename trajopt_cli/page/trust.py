"""How far to trust a page: what the judge found, what is estimated and how sure, what the page was made from."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from trajopt_cli.findings import Report
from trajopt_cli.page.encode import text
from trajopt_cli.page.tables import drawn, points, table
from trajopt_cli.problem.plant import Plant
from trajopt_cli.table import figure, findings_table
from trajopt_cli.units import DEG, MM, slides

GRADES = "Grades: A several sources agree, B one good source, C a weak one or inferred, D an estimate."


def judged(name: str, report: Report, opened: bool) -> str:
    """The verdict and the tightest case of each check. opened: as the page is first shown."""
    bad = sum(not one.passed for one in report.findings)
    word, kind = ("legal", "good") if report.legal else (f"not legal: {bad} checks failed", "bad")
    verdict = f'<h3>{text(name)}: <span class="verdict {kind}">{word}</span></h3>'
    shown = drawn(findings_table(f"{name}: {len(report.findings)} checks", report.findings))
    return f"<details{' open' if opened else ''}><summary>{verdict}</summary>{shown}</details>"


def limits(plant: Plant) -> str:
    """Every limit in force, with the grade of its source."""
    given, rows = plant.limits, []
    accelerations = given.acceleration, given.most_acceleration
    for k, name in enumerate(given.names):
        scale, unit = (MM, "mm") if slides(name) else (DEG, "deg")
        ends = [figure(one[k] / scale, 6) for one in (given.lower, given.upper)]
        speed = figure(given.velocity[k] / scale, 5)
        rates = " to ".join(dict.fromkeys(figure(one[k] / scale, 5) for one in accelerations))
        source = given.sources.get(f"{name}.acceleration", "")
        rows.append((name.replace("_", " "), *ends, unit, speed, f"{unit}/s", rates, f"{unit}/s²", source))
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
