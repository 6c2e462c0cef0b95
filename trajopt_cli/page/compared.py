"""report.html of `trajopt compare baseline`: all rows, the saving by cause, any two rows beside each other."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from trajopt_cli.motion import Program
from trajopt_cli.page.cell import SCRIPTS_OF_CELL, cell_data, chart_sections, motion_section, program_section
from trajopt_cli.page.cycles import Shown
from trajopt_cli.page.document import Section, document
from trajopt_cli.page.encode import text
from trajopt_cli.page.optimized import Provenance
from trajopt_cli.page.tables import Tile, facts, head, table
from trajopt_cli.page.trust import GRADES, doubts, hashes, judged, limits
from trajopt_cli.page.waterfall import Bar, waterfall
from trajopt_cli.problem.plant import Plant
from trajopt_cli.runs.uncertainty import within
from trajopt_cli.table import Bad, Good, percent, seconds, signed, tabulate

Record = Mapping[str, Any]


def compared_page(
    title: str,
    program: Program,
    plant: Plant,
    record: Record,
    motions: Sequence[Shown | None],
    notices: Sequence[str],
    made: Provenance,
) -> bytes:
    """The page's bytes, the same for the same arguments. title: the program's name. record: comparison.json. motions:
    of each of its rows, judged; None for a row that cannot be driven.

    Savings count from the first legal row, which stands beside the fastest legal one at first.
    """
    rows = record["rows"]
    moving = [(row, one) for row, one in zip(rows, motions, strict=True) if one is not None]
    shown = [one for _, one in moving]
    legal = [i for i, (row, _) in enumerate(moving) if row["legal"]]
    fastest = min(legal, key=lambda i: shown[i].plan.duration, default=len(shown) - 1)
    at_first = list(dict.fromkeys((legal[0] if legal else 0, fastest))) if shown else []
    beside = [moving[i] for i in at_first]
    sections = [Section("rows", "Rows", _rows(rows), _LEAD), _saving(record["saving_by_cause"], beside)]
    data = {}
    if shown:
        own = next((one.plan for one in reversed(shown) if one.program is program and one.plan.motions), None)
        data = cell_data(plant, program, shown, at_first, own)
        sections += [motion_section(), program_section(program, shown, at_first), *chart_sections(plant, data, shown)]
        said = "".join(judged(one.name, one.report, False) for one in shown if one.report)
        sections.append(Section("judge", "Judge", said, "Tightest case of each check, row by row."))
    sure = doubts(plant.notes, plant.unchecked, notices, ()) + limits(plant)
    sections += [
        Section("trust", "Assumptions", sure, f"Estimated, unchecked and assumed. {GRADES}"),
        Section("provenance", "Provenance", facts(made.made) + hashes(made.files)),
    ]
    top = _head(title, plant, beside)
    return document(f"{title}, compared · trajopt", top, sections, data, SCRIPTS_OF_CELL if shown else ())


_LEAD = (
    "The same work by today's practice, by textbook methods and by trajopt, each judged. Savings are relative to the "
    "first legal row, and count for legal rows only."
)


def _head(title: str, plant: Plant, beside: Sequence[tuple[Record, Shown]]) -> str:
    tiles = []
    for kind, (row, one) in zip(("before", "after"), beside, strict=False):
        saved = percent(row["saving"])
        said = row["title"] if saved in ("", "0.0 %") else f"{signed(-100 * row['saving'], 1)} %, {row['title']}"
        tiles.append(Tile(one.name, f"{seconds(one.plan.duration)} s", said, kind))
    if beside and (bound := beside[-1][0]["lower_bound_s"]) is not None:
        said = f"no legal motion for the {beside[-1][0]['target']} target is faster"
        tiles.append(Tile("lower bound", f"{seconds(bound)} s", said, "bound"))
    return head(title, f"{plant.robot.name} · compare baseline", tiles, plant.unchecked)


def _rows(rows: Sequence[Record]) -> str:
    longest = max((row["cycle_time_s"] for row in rows if "cycle_time_s" in row), default=1.0)

    def legal(row: Record) -> str:
        if "why" in row:
            return text(row["why"])
        return Good("yes") if row["legal"] else Bad(f"no: {text(row['breaks'])}")

    def bar(row: Record) -> str:
        if "why" in row:
            return ""
        return (
            f'<svg class="time {"legal" if row["legal"] else "illegal"}" viewBox="0 0 100 10" aria-hidden="true" '
            f'preserveAspectRatio="none"><rect x="0" y="1" width="{100 * row["cycle_time_s"] / longest:.2f}" '
            'height="8"/></svg>'
        )

    columns: dict[str, Callable[[Record], str]] = {
        "row": lambda row: f"<b>{text(row['name'])}</b>",
        "target": lambda row: row["target"],
        ">cycle time [s]": lambda row: within(seconds(row.get("cycle_time_s"), "–"), row.get("cycle_time_range_s")),
        "": bar,
        ">saving": lambda row: within(percent(row.get("saving")), row.get("saving_range"), 100),
        ">bound [s]": lambda row: seconds(row.get("lower_bound_s")),
        "legal": legal,
    }
    shown = tabulate("All rows", rows, columns)
    notes = "".join(
        f"<li><b>{text(row['name'])}</b>: {text(row['title'])}; may move: {text(row['moves'])}"
        f"{''.join(f'<br>{text(note)}' for note in row.get('notes', ()))}</li>"
        for row in rows
    )
    return table(shown.title, shown.heads, shown.rows, html=True) + f"<ul>{notes}</ul>"


def _saving(causes: Record, beside: Sequence[tuple[Record, Shown]]) -> Section:
    heading = "Saving by cause"
    if "steps" not in causes:
        why = f"<p>Not available, there is no plan to start from: {text(causes['why_not'])}</p>"
        return Section("saving", heading, why)
    first, *steps = causes["steps"]
    last = steps[-1] if steps else first
    bounds = [row["lower_bound_s"] for row, _ in reversed(beside) if row["lower_bound_s"] is not None]
    bound = bounds[0] if bounds else None
    drawn = waterfall(
        Bar(first["name"], first["cycle_time_s"], total=True, detail=first["why_not"] or "", cycle="before"),
        [Bar(one["name"], one["saved_s"], detail=one["why_not"] or "") for one in steps],
        Bar("all together", last["cycle_time_s"], total=True, cycle="after"),
        bound,
        heading,
    )
    line = "" if bound is None else f" The dashed line is the lower bound, {seconds(bound)} s."
    lead = f"Each step frees one more thing and is solved and judged again; the steps add up to the whole.{line}"
    return Section("saving", heading, drawn, lead)
