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
from trajopt_cli.runs.summary import NOT_TIMED, Judged, Summary
from trajopt_cli.table import seconds, signed

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
    told: Summary,
    plans: Mapping[Target, Judged],
    written: Plan | str,
    made: Provenance,
    kept_speed: Mapping[Target, Sequence[Stretch]] | None = None,
) -> bytes:
    """The page's bytes, the same for the same arguments. told: its target's plan is shown; the other one can be chosen.

    title: the program's name for people. plans, written: the motions of told, with all their rows. kept_speed: the
    stretches that should keep their speed, if any. Raises ValueError for a trajectory without speeds.
    """
    target = told.target
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
        *_saving(told),
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
            doubts(told.limits, told.unchecked, told.warnings, told.notes) + limits(plant),
            f"Estimated, unchecked and assumed. {GRADES}",
        ),
        Section("provenance", "Provenance", facts(made.made) + hashes(made.files)),
    ]
    head = _head(title, plant, told, other)
    return document(f"{title} · trajopt", head, sections, data, SCRIPTS_OF_CELL)


def _head(title: str, plant: Plant, told: Summary, other: Target) -> str:
    target, before = told.target, told.as_written
    chosen, second = told.plans.of(target), told.plans.of(other)
    if before.why_not is None:
        tiles = [tile("before", WRITTEN, f"{seconds(before.cycle_time_s)} s", "the program under the same limits")]
    else:
        why = before.why_not if before.why_not == NOT_TIMED else f"cannot be driven: {before.why_not}"
        tiles = [tile("before", WRITTEN, "–", why)]
    changed = f"{told.change(target)}, for {_MACHINES[target]}".removeprefix(", ")
    tiles.append(tile("after", f"{target} plan", f"{seconds(chosen.cycle_time_s)} s", changed))
    if chosen.gap is not None:
        gap = f"no legal motion is faster; gap {100 * chosen.gap:.1f} %"
        gap += "" if chosen.suspicious is None else f"; suspicious: {chosen.suspicious}"
        tiles.append(tile("bound", f"lower bound, {target}", f"{seconds(chosen.lower_bound_s)} s", gap))
    gap = "" if second.gap is None else f", gap {100 * second.gap:.1f} %"
    changed = f"{told.change(other)}, for {_MACHINES[other]}{gap}".removeprefix(", ")
    tiles.append(tile("", f"{other} plan", f"{seconds(second.cycle_time_s)} s", changed))
    verdicts = " · ".join(
        f'{one} plan <span class="verdict {"good" if plan.judge.legal else "bad"}">'
        f"{'legal' if plan.judge.legal else 'not legal'}</span>, {len(plan.judge.findings)} checks"
        for one, plan in ((target, chosen), (other, second))
    )
    return (
        f'<h1>{text(title)}</h1><p class="sub">{text(plant.robot.name)} · {verdicts}</p>'
        f'<dl class="tiles">{"".join(tiles)}</dl>'
    )


def _saving(told: Summary) -> list[Section]:
    plan, before = told.plans.of(told.target), told.as_written.cycle_time_s
    if before is None:
        return []
    times = told.written_times
    saved = [(one.name, one.place, times.get(one.index, 0.0) - one.time_s) for one in plan.motions]
    drawn = waterfall(
        Bar(WRITTEN, before, total=True, cycle="before"),
        by_motion(saved, before, plan.cycle_time_s),
        Bar(f"{told.target} plan", plan.cycle_time_s, total=True, cycle="after"),
        plan.lower_bound_s,
        "Saving by motion",
    )
    changed = told.change(told.target)
    share = changed.capitalize()
    if changed != "unchanged":
        share = f"{signed(plan.cycle_time_s - before)} s, {changed}"
    least = plan.lower_bound_s
    bound = "" if least is None else f" The dashed line is the lower bound, {seconds(least)} s."
    lead = f"{share}, by motion.{bound} trajopt compare baseline tells it by cause."
    return [Section("saving", "Saving", drawn, lead)]


def tile(kind: str, name: str, big: str, small: str) -> str:
    """A number above all sections. kind: "before", "after", "bound" or none of them."""
    return (
        f'<div class="tile {kind}"><dt>{text(name)}</dt><dd class="big">{text(big)}</dd>'
        f'<dd class="small">{text(small)}</dd></div>'
    )
