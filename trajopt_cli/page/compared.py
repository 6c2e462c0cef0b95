"""report.html of `trajopt compare baseline`: all rows, the saving by cause, any two rows beside each other."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from trajopt_cli.motion import Program
from trajopt_cli.page.cell import SCRIPTS_OF_CELL, cell_data, chart_sections, motion_section, program_section, seconds
from trajopt_cli.page.cycles import Shown
from trajopt_cli.page.document import Section, document
from trajopt_cli.page.encode import text
from trajopt_cli.page.optimized import Provenance, tile
from trajopt_cli.page.tables import facts, table
from trajopt_cli.page.trust import GRADES, doubts, hashes, judged, limits
from trajopt_cli.page.waterfall import Bar, waterfall
from trajopt_cli.problem.plant import Plant


@dataclass(frozen=True, eq=False)
class Compared:
    """A row. moves: what may move in it. shown: its motion, judged; None where why says what is in the way. saving:
    share of the reference's cycle time, None where none counts. bound [s]: below every plan of its target. notes: what
    a reader must know to compare it."""

    name: str
    target: str
    title: str
    moves: str
    shown: Shown | None
    why: str = ""
    saving: float | None = None
    bound: float | None = None
    notes: Sequence[str] = ()

    @property
    def legal(self) -> bool:
        """Whether there is a motion and the judge allows it."""
        return self.shown is not None and self.shown.report is not None and self.shown.report.legal


@dataclass(frozen=True)
class Cause:
    """One step of the saving: the cycle time with all freed up to it, what the step saves [s], and what became of its
    own plan where that is not the plan that counts."""

    name: str
    cycle: float
    saved: float
    why_not: str = ""


def compared_page(
    title: str,
    program: Program,
    plant: Plant,
    rows: Sequence[Compared],
    causes: Sequence[Cause] | str,
    notices: Sequence[str],
    made: Provenance,
) -> bytes:
    """The page's bytes, the same for the same arguments. causes: or why there is none. title: the program's name.

    Savings count from the first legal row, which stands beside the fastest legal one at first.
    """
    moving = [row for row in rows if row.shown is not None]
    shown = [row.shown for row in moving if row.shown is not None]
    legal = [i for i, row in enumerate(moving) if row.legal]
    fastest = min(legal, key=lambda i: shown[i].plan.duration, default=len(shown) - 1)
    at_first = list(dict.fromkeys((legal[0] if legal else 0, fastest))) if shown else []
    sections = [Section("rows", "Rows", _rows(rows), _LEAD), *_saving(causes, moving, at_first)]
    data = {}
    if shown:
        own = next((one.plan for one in reversed(shown) if one.program is program and one.plan.motions), None)
        data = cell_data(plant, program, shown, at_first, own)
        sections += [motion_section(), program_section(program, shown, at_first), *chart_sections(plant, data, shown)]
        said = "".join(
            judged(row.name, one.report, False) for row, one in zip(moving, shown, strict=True) if one.report
        )
        sections.append(Section("judge", "Judge", said, "Tightest case of each check, row by row."))
    sure = doubts(plant.notes, plant.unchecked, notices, ()) + limits(plant)
    sections += [
        Section("trust", "Assumptions", sure, f"Estimated, unchecked and assumed. {GRADES}"),
        Section("provenance", "Provenance", facts(made.made) + hashes(made.files)),
    ]
    head = _head(title, plant, moving, at_first)
    return document(f"{title}, compared · trajopt", head, sections, data, SCRIPTS_OF_CELL if shown else ())


_UNCHANGED = 5e-4  # share of a cycle time: printed as 0.0 %, and its sign may be rounding
_LEAD = (
    "The same work in the ways people would drive it, each judged. Savings are relative to the first legal row, and "
    "count for legal rows only."
)


def _head(title: str, plant: Plant, moving: Sequence[Compared], at_first: Sequence[int]) -> str:
    tiles = []
    for kind, i in zip(("before", "after"), at_first, strict=False):
        row = moving[i]
        assert row.shown is not None
        unchanged = row.saving is None or abs(row.saving) < _UNCHANGED
        said = row.title if unchanged else f"{-100 * (row.saving or 0.0):+.1f} %, {row.title}"
        tiles.append(tile(kind, row.name, f"{seconds(row.shown.plan.duration)} s", said.replace("-", "−", 1)))
    last = moving[at_first[-1]] if at_first else None
    if last is not None and last.bound is not None:
        said = f"no legal motion for the {last.target} target is faster"
        tiles.append(tile("bound", "lower bound", f"{seconds(last.bound)} s", said))
    return (
        f'<h1>{text(title)}</h1><p class="sub">{text(plant.robot.name)} · compare baseline</p>'
        f'<dl class="tiles">{"".join(tiles)}</dl>'
    )


def _rows(rows: Sequence[Compared]) -> str:
    times = [row.shown.plan.duration for row in rows if row.shown is not None]
    longest = max(times, default=1.0)
    cells = []
    for row in rows:
        if row.shown is None:
            cells.append((_named(row), text(row.target), "–", "", "", "", text(row.why)))
            continue
        time, kind = row.shown.plan.duration, "legal" if row.legal else "illegal"
        bar = (
            f'<svg class="time {kind}" viewBox="0 0 100 10" preserveAspectRatio="none" aria-hidden="true">'
            f'<rect x="0" y="1" width="{100 * time / longest:.2f}" height="8"/></svg>'
        )
        report = row.shown.report
        breaks = "" if report is None else next((one.check for one in report.findings if not one.passed), "")
        word = '<span class="good">yes</span>' if row.legal else f'<span class="bad w">no: {text(breaks)}</span>'
        saving = "" if row.saving is None else f"{100 * row.saving:.1f} %".replace("-", "−")
        saving = "0.0 %" if row.saving is not None and abs(row.saving) < _UNCHANGED else saving
        bound = "" if row.bound is None else seconds(row.bound)
        cells.append((_named(row), text(row.target), seconds(time), bar, saving, bound, word))
    heads = ("row", "target", ">cycle time [s]", "", ">saving", ">bound [s]", "legal")
    notes = "".join(
        f"<li><b>{text(row.name)}</b>: {text(row.title)}; may move: {text(row.moves)}"
        f"{''.join(f'<br>{text(note)}' for note in row.notes)}</li>"
        for row in rows
    )
    return table("All rows", heads, cells, html=True) + f"<ul>{notes}</ul>"


def _named(row: Compared) -> str:
    return f'<span class="w">{text(row.name)}</span>'


def _saving(causes: Sequence[Cause] | str, moving: Sequence[Compared], at_first: Sequence[int]) -> list[Section]:
    if isinstance(causes, str):
        return [
            Section(
                "saving", "Saving by cause", f"<p>Not available, there is no plan to start from: {text(causes)}</p>"
            )
        ]
    first, last = causes[0], causes[-1]
    bound = next((row.bound for row in (moving[i] for i in reversed(at_first)) if row.bound is not None), None)
    drawn = waterfall(
        Bar(first.name, first.cycle, total=True, detail=first.why_not, cycle="before"),
        [Bar(one.name, one.saved, detail=one.why_not) for one in causes[1:]],
        Bar("all together", last.cycle, total=True, cycle="after"),
        bound,
        "Saving by cause",
    )
    line = "" if bound is None else f" The dashed line is the lower bound, {seconds(bound)} s."
    lead = f"Each step frees one thing more, is solved and judged anew, and the steps add up to the whole.{line}"
    return [Section("saving", "Saving by cause", drawn, lead)]
