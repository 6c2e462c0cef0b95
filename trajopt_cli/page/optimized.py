"""report.html of `trajopt optimize`: the program as it stands and both plans."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from trajopt_cli.motion import Program
from trajopt_cli.page.cell import SCRIPTS_OF_CELL, cell_data, chart_sections, motion_section, program_section
from trajopt_cli.page.cycles import Shown
from trajopt_cli.page.document import Section, document
from trajopt_cli.page.encode import text
from trajopt_cli.page.tables import facts
from trajopt_cli.page.trust import GRADES, doubts, hashes, judged, limits
from trajopt_cli.page.waterfall import Bar, by_motion, waterfall
from trajopt_cli.problem.constant_speed import Stretch
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.runs.results import NOT_TIMED, Judged, motion_label
from trajopt_cli.table import change, place, seconds, signed

WRITTEN = "as written"
_MACHINES = {Target.STREAM: "a joint stream", Target.RAPID: "the RAPID controller"}


@dataclass(frozen=True)
class Provenance:
    """What a page was made from. made: name and value, as lines. files: the SHA-256 of each file read, by its path."""

    made: Sequence[tuple[str, str]]
    files: Mapping[str, str]


def optimized_page(
    title: str,
    program: Program,
    plant: Plant,
    target: Target,
    plans: Mapping[Target, Judged],
    written: Plan | str,
    warnings: Sequence[str],
    notes: Sequence[str],
    made: Provenance,
    kept_speed: Mapping[Target, Sequence[Stretch]] | None = None,
) -> bytes:
    """The page's bytes, the same for the same arguments. target: the plan that is shown; the other one can be chosen.

    title: the program's name for people. written: the program as it stands, with all its rows, or why it cannot be
    driven so. warnings, notes: as printed. kept_speed: the stretches that should keep their speed, if any. Raises
    ValueError for a trajectory without speeds.
    """
    other = next(one for one in Target if one is not target)
    before = [Shown(WRITTEN, program, written)] if isinstance(written, Plan) else []
    kept = kept_speed or {}
    shown = [
        *before,
        *(
            Shown(f"{one} plan", program, plans[one].plan, plans[one].report, kept.get(one, ()))
            for one in (target, other)
        ),
    ]
    at_first = [0, 1] if before else [1, 0]  # the plan that is shown comes last
    chosen = plans[target].plan
    data = cell_data(plant, program, shown, at_first, chosen)
    sections = [
        motion_section(),
        *_saving(program, target, chosen, written),
        program_section(program, shown, at_first),
        *chart_sections(plant, data, shown),
        Section(
            "judge",
            "Judge",
            "".join(judged(f"{one} plan", plans[one].report, one is target) for one in (target, other)),
            "An independent judge, with kinematics and geometry of its own, read the rows that were written. Of every "
            "check the case nearest to its limit.",
        ),
        Section(
            "trust",
            "Assumptions",
            doubts(plant.notes, plant.unchecked, warnings, notes) + limits(plant),
            f"Estimated, unchecked and assumed. {GRADES}",
        ),
        Section("provenance", "Provenance", facts(made.made) + hashes(made.files)),
    ]
    head = _head(title, plant, target, other, plans, written)
    return document(f"{title} · trajopt", head, sections, data, SCRIPTS_OF_CELL)


def _head(
    title: str, plant: Plant, target: Target, other: Target, plans: Mapping[Target, Judged], written: Plan | str
) -> str:
    chosen, second = plans[target].plan, plans[other].plan
    tiles = []
    if isinstance(written, Plan):
        tiles.append(tile("before", WRITTEN, f"{seconds(written.duration)} s", "the program under the same limits"))
    else:
        tiles.append(tile("before", WRITTEN, "–", written if written == NOT_TIMED else f"cannot be driven: {written}"))
    changed = f"{_change(written, chosen)}, for {_MACHINES[target]}".removeprefix(", ")
    tiles.append(tile("after", f"{target} plan", f"{seconds(chosen.duration)} s", changed))
    if chosen.lower_bound is not None and chosen.gap is not None:
        gap = f"no legal motion is faster; gap {100 * chosen.gap:.1f} %"
        gap += "" if chosen.suspicion is None else f"; suspicious: {chosen.suspicion}"
        tiles.append(tile("bound", f"lower bound, {target}", f"{seconds(chosen.lower_bound)} s", gap))
    gap = "" if second.gap is None else f", gap {100 * second.gap:.1f} %"
    told = f"{_change(written, second)}, for {_MACHINES[other]}{gap}".removeprefix(", ")
    tiles.append(tile("", f"{other} plan", f"{seconds(second.duration)} s", told))
    verdicts = " · ".join(
        f'{one} plan <span class="verdict {"good" if plans[one].report.legal else "bad"}">'
        f"{'legal' if plans[one].report.legal else 'not legal'}</span>, {len(plans[one].report.findings)} checks"
        for one in (target, other)
    )
    return (
        f'<h1>{text(title)}</h1><p class="sub">{text(plant.robot.name)} · {verdicts}</p>'
        f'<dl class="tiles">{"".join(tiles)}</dl>'
    )


def _saving(program: Program, target: Target, plan: Plan, written: Plan | str) -> list[Section]:
    if isinstance(written, str):
        return []
    times = {motion.index: motion.t_1 - motion.t_0 for motion in written.motions}
    saved = [
        (" ".join(motion_label(program, m.index)), place(m.source), times.get(m.index, 0.0) - (m.t_1 - m.t_0))
        for m in plan.motions
    ]
    drawn = waterfall(
        Bar(WRITTEN, written.duration, total=True, cycle="before"),
        by_motion(saved, written.duration, plan.duration),
        Bar(f"{target} plan", plan.duration, total=True, cycle="after"),
        plan.lower_bound,
        "Saving by motion",
    )
    changed = _change(written, plan)
    share = changed.capitalize()
    if changed != "unchanged":
        share = f"{signed(plan.duration - written.duration)} s, {changed}"
    bound = "" if plan.lower_bound is None else f" The dashed line is the lower bound, {seconds(plan.lower_bound)} s."
    lead = f"{share}, by motion.{bound} trajopt compare baseline tells it by cause."
    return [Section("saving", "Saving", drawn, lead)]


def tile(kind: str, name: str, big: str, small: str) -> str:
    """A number above all sections. kind: "before", "after", "bound" or none of them."""
    return (
        f'<div class="tile {kind}"><dt>{text(name)}</dt><dd class="big">{text(big)}</dd>'
        f'<dd class="small">{text(small)}</dd></div>'
    )


def _change(before: Plan | str, after: Plan) -> str:
    """What becomes of a time, in per cent; nothing where there is none to begin with."""
    return "" if isinstance(before, str) or before.duration <= 0 else change(before.duration, after.duration)
