"""report.html of `trajopt optimize`: the program as it stands and both plans."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from trajopt_cli.motion import Program
from trajopt_cli.page.cell import SCRIPTS_OF_CELL, cell_data, chart_sections, motion_section, program_section
from trajopt_cli.page.changes import changes_section
from trajopt_cli.page.cycles import Shown
from trajopt_cli.page.document import Section, document
from trajopt_cli.page.encode import text
from trajopt_cli.page.tables import Tile, facts, head, points
from trajopt_cli.page.trust import GRADES, doubts, hashes, judged, limits
from trajopt_cli.page.waterfall import Bar, by_motion, waterfall
from trajopt_cli.problem.constant_speed import Stretch
from trajopt_cli.problem.plan import Plan, Target
from trajopt_cli.problem.plant import Plant
from trajopt_cli.runs.summary import NOT_TIMED, Judged, Summary, cycle_line
from trajopt_cli.table import seconds, signed, told_gap

WRITTEN = "as written"
_NAMES = {Target.RAPID: "rapid plan", Target.STREAM: "stream plan (EGM)"}


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
    told: Summary,
    plans: Mapping[Target, Judged],
    written: Plan | str,
    made: Provenance,
    kept_speed: Mapping[Target, Sequence[Stretch]] | None = None,
    changed: str = "",
) -> bytes:
    """The page's bytes, the same for the same arguments. target: whose plan is shown; the other one can be chosen.

    title: the program's name for people. plans, written: the motions of told, with all their rows. kept_speed: the
    stretches that should keep their speed, if any. changed: the RAPID text with its plan as a diff, or why there is
    none. Raises ValueError for a trajectory without speeds.
    """
    before = [Shown(WRITTEN, program, written)] if isinstance(written, Plan) else []
    kept = kept_speed or {}
    shown = [
        *before,
        *(Shown(f"{one} plan", program, plans[one].plan, plans[one].report, kept.get(one, ())) for one in target.first),
    ]
    at_first = [0, 1] if before else [1, 0]  # the plan that is shown comes last
    chosen = plans[target].plan
    settling = [] if told.settling is None else [told.settling.line]
    known = [*told.uncertainty.intervals(target.first), *told.limits, *settling]
    sure = doubts(known, told.unchecked, told.warnings, told.notes)
    data = cell_data(plant, program, shown, at_first, chosen)
    sections = [
        motion_section(),
        changes_section(changed, told),
        *_saving(told, target),
        program_section(program, shown, at_first),
        *chart_sections(plant, data, shown),
        Section(
            "judge",
            "Judge",
            points(cycle_line(f"{one} plan", told.plans.of(one)) for one in target.first)
            + "".join(judged(f"{one} plan", plans[one].report, one is target) for one in target.first),
            "An independent judge, with kinematics and geometry of its own, read the rows that were written. Of every "
            "check the case nearest to its limit.",
        ),
        Section("trust", "Assumptions", sure + limits(plant), f"Estimated, unchecked and assumed. {GRADES}"),
        Section("provenance", "Provenance", facts(made.made) + hashes(made.files)),
    ]
    top = _head(title, plant, told, target)
    return document(f"{title} · trajopt", top, sections, data, SCRIPTS_OF_CELL)


def _head(title: str, plant: Plant, told: Summary, target: Target) -> str:
    before = told.as_written
    if before.why_not is None:
        about = "; ".join(told.uncertainty.times("as_written")) or "the program under the same limits"
        tiles = [Tile(WRITTEN, f"{seconds(before.cycle_time_s)} s", about, "before")]
    else:
        why = before.why_not if before.why_not == NOT_TIMED else f"cannot be driven: {before.why_not}"
        tiles = [Tile(WRITTEN, "–", why, "before")]
    for one, kind in zip(target.first, ("after", "other"), strict=True):
        plan, said = told.plans.of(one), [*told.uncertainty.times(one.value), told.change(one)]
        if plan.gap is not None:
            said.append(f"bound {seconds(plan.lower_bound_s)} s, {told_gap(plan.gap).partition(':')[0]}")
        if plan.suspicious is not None:
            said.append(f"suspicious: {plan.suspicious}")
        tiles.append(Tile(_NAMES[one], f"{seconds(plan.cycle_time_s)} s", "; ".join(filter(None, said)), kind))
    word, *unchecked = told.verdict.split("; ")
    kind = "good" if word == "legal" else "bad"
    counts = " and ".join(str(len(told.plans.of(one).judge.findings)) for one in target.first)
    about = f'{text(plant.robot.name)} · both plans <span class="verdict {kind}">{text(word)}</span>, {counts} checks'
    return head(title, about, tiles, unchecked, html=True)


def _saving(told: Summary, target: Target) -> list[Section]:
    plan, before = told.plans.of(target), told.as_written.cycle_time_s
    if before is None:
        return []
    times = told.written_times
    saved = [(one.name, one.place, times.get(one.index, 0.0) - one.time_s) for one in plan.motions]
    drawn = waterfall(
        Bar(WRITTEN, before, total=True, cycle="before"),
        by_motion(saved, before, plan.cycle_time_s),
        Bar(f"{target} plan", plan.cycle_time_s, total=True, cycle="after"),
        plan.lower_bound_s,
        "Saving by motion",
    )
    changed = told.change(target)
    share = changed.capitalize()
    if changed != "unchanged":
        share = f"{signed(plan.cycle_time_s - before)} s, {changed}"
    least = plan.lower_bound_s
    bound = "" if least is None else f" The dashed line is the lower bound, {seconds(least)} s."
    lead = f"{share}, by motion.{bound} trajopt compare baseline tells it by cause."
    return [Section("saving", "Saving", drawn, lead)]
