"""The tables a person reads, and the records behind them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from trajopt_cli.cli.listing import shortened
from trajopt_cli.cli.remarks import remarks
from trajopt_cli.findings import Report
from trajopt_cli.judge.clearance import least_clearance
from trajopt_cli.pipeline.optimize import OptimizedJob
from trajopt_cli.problem.constant_speed import DIP, Dip, Stretch, Why
from trajopt_cli.problem.detours import way_told
from trajopt_cli.problem.plan import Target
from trajopt_cli.runs.summary import NOT_TIMED, SETTLING, MotionRow, Plans, cycle_line, finding_record
from trajopt_cli.table import TextTable, by_name, place, seconds, tabulate
from trajopt_cli.units import MM
from trajopt_cli.warnings import WarningKind

_NAME = 50  # characters of a motion's name: many targets are written in numbers
_DIPS = 10  # of constant speed, in text; summary.json has them all


def saving_line(answer: OptimizedJob) -> str:
    """The answer in one line: as written, and what the plans make of it."""
    told, names = answer.summary, {Target.RAPID: "by the RAPID controller", Target.STREAM: "as a joint stream"}
    changes = {one: f" ({changed})" if (changed := told.change(one)) else "" for one in names}
    plans = ", ".join(
        f"{told.plans.of(one).cycle_time_s / told.passes:.3f} s{changes[one]} {names[one]}" for one in answer.lead.first
    )
    plans += f", per pass of {told.passes}" if told.passes > 1 else ""
    before = told.as_written
    if before.cycle_time_s is not None:
        return f"as written {before.cycle_time_s / told.passes:.3f} s → {plans}"
    place = re.match(r"\S+:\d+(?=: )", before.why_not or "")  # the reason itself is a line below the table
    why = f"was {NOT_TIMED}" if before.why_not == NOT_TIMED else f"cannot be driven{f' ({place[0]})' if place else ''}"
    return f"as written it {why} → {plans}"


def optimized_lines(answer: OptimizedJob, verbose: bool = False) -> Iterator[str]:
    """What stands below the table of motions: cycle times, clearance, remarks, the files. verbose: grids, too."""
    job, told = answer.job, answer.summary
    files = (*job.program.files, str(job.cell_path))
    for one in answer.lead.first:
        yield cycle_line(one.value, told.plans.of(one), verbose)
    if (why := told.as_written.why_not) and why != NOT_TIMED:
        yield by_name(f"as written it cannot be driven: {why}", files)
    yield from speed_lines(answer.lead.value, answer.kept_speed[answer.lead])
    for one in answer.lead.first:
        nearest = least_clearance(answer.judged[one].report.findings)
        if nearest is not None:
            yield f"{one.value}: {by_name(nearest.message, files)}"
    yield from job.program.without_effect
    first = {str(one) for one in job.program.warnings if one.kind is WarningKind.NOT_CHECKED}
    warnings = [one for one in told.warnings if one not in first]
    said = (("warning", warnings), ("limits", told.limits), ("note", told.notes))
    for label, lines in said:
        yield from remarks(label, lines, files, "all in summary.json")
    rapid = [f"{', '.join(answer.rapid_files)} (the rapid plan)"] if answer.no_rapid is None else []
    plots = ["plots/"] if (answer.folder / "plots").is_dir() else []
    tables = [f"{one}.csv{' (for EGM)' * (one is Target.STREAM)}" for one in answer.lead.first]
    named = [*rapid, "report.html (open it in a browser)", *tables, f"trajectory.csv (the {told.target} plan)"]
    yield f"written to {answer.folder}: {', '.join([*named, 'summary.json', 'run.json', *plots])}"


def optimized_record(answer: OptimizedJob, interrupted: bool) -> dict[str, Any]:
    """The answer in short as plain data, SI; all of it is in the folder's summary.json. interrupted: by
    Ctrl-C."""
    told, before = answer.summary, answer.summary.as_written.cycle_time_s
    plans = {}
    for one in answer.lead.first:
        plan = told.plans.of(one)
        plans[one.value] = {
            **plan.model_dump(include={"cycle_time_s", "lower_bound_s", "gap", "grid", "suspicious"}),
            "saving": 1 - plan.cycle_time_s / before if before else None,
            "legal": plan.judge.legal,
            "checks": len(plan.judge.findings),
        }
    return {
        "feasible": True,
        "program": str(answer.job.program_path),
        "target": told.target.value,
        "as_written": told.as_written.model_dump(include={"cycle_time_s", "why_not"}),
        "plans": plans,
        "folder": str(answer.folder),
        "files": sorted(
            path.relative_to(answer.folder).as_posix() for path in answer.folder.rglob("*") if path.is_file()
        ),
        "no_rapid": answer.no_rapid,
        "interrupted": interrupted,
        **told.model_dump(include={"warnings", "limits", "uncertainty", "unchecked", "undriven", "notes", "settling"}),
    }


def speed_lines(label: str, stretches: Sequence[Stretch]) -> Iterator[str]:
    """How well a plan keeps the programmed speed where it should: one line in all, and one for each place where it does
    not, the same in several passes said once."""
    if not stretches:
        return
    dips = [dip for stretch in stretches for dip in stretch.dips]
    far = f"{sum(stretch.length for stretch in stretches) / MM:.1f} mm"
    found = f"constant speed ({label}): {far} in {_count(len(stretches), 'stretch', 'es')}"
    if not dips:
        yield f"{found}, kept within {100 * DIP:g} %"
        return
    short = f"{sum(dip.length for dip in dips) / MM:.1f} mm and {sum(dip.duration for dip in dips):.3f} s"
    yield f"{found}, kept within {100 * DIP:g} % but for {_count(len(dips), 'dip')} of {short}"
    groups: dict[tuple[object, ...], list[Dip]] = {}
    for dip in dips:
        groups.setdefault((dip.source, dip.why, dip.detail), []).append(dip)
    for group in list(groups.values())[:_DIPS]:
        yield f"  {_dip(max(group, key=lambda dip: dip.duration), len(group) - 1)}"
    if more := len(dips) - sum(len(group) for group in list(groups.values())[:_DIPS]):
        yield f"  and {more} more, all in summary.json"


def _dip(dip: Dip, others: int) -> str:
    low = f"reaches {dip.highest / MM:.4g}" if dip.why is Why.SHORT else f"{dip.lowest / MM:.4g}"
    speed = f"{low} of {dip.programmed / MM:.4g} mm/s"
    depth = "" if dip.why is Why.SHORT else f" (−{dip.depth:.0%})".replace("%", " %")
    more = f" ({others} more times)" if others > 1 else " (once more)" if others else ""
    where = f"{place(dip.source)} {shortened(dip.name, _NAME)} at {dip.along / MM:.1f} mm"
    return f"{where}: {speed}{depth}, for {dip.duration:.3f} s and {dip.length / MM:.1f} mm: {dip.cause}{more}"


def _count(number: int, what: str, plural: str = "s") -> str:
    return f"{number} {what}{plural if number > 1 else ''}"


def motions_table(answer: OptimizedJob) -> TextTable:
    """Every motion as written and on both targets; binding limits are those of the plan that leads."""
    told, lead = answer.summary, answer.lead
    written, ways = told.written_times, ways_told(told.plans)
    plans = {one: {row.index: row for row in told.plans.of(one).motions} for one in Target}

    def name(row: MotionRow) -> str:
        return f"{row.target} ({ways[row.index]})" if row.index in ways else row.target

    def time(target: Target) -> Callable[[MotionRow], str]:
        def cell(row: MotionRow) -> str:
            return "dropped" if plans[target][row.index].dropped else seconds(plans[target][row.index].time_s)

        return cell

    made = tabulate(
        f"{answer.job.program_path} on {answer.job.plant.robot.name}",
        [row for row in told.plans.of(lead).motions if row.instruction != SETTLING],
        {
            "~place": lambda row: row.place,
            "instruction": lambda row: row.instruction,
            "~target": name,
            ">written [s]": lambda row: seconds(written.get(row.index), "-"),
            **{f">{one} [s]": time(one) for one in lead.first},
            f"what limits the {lead} plan": lambda row: row.binding,
        },
        (
            *("cycle", "", "", seconds(told.as_written.cycle_time_s, "-")),
            *(seconds(told.plans.of(one).cycle_time_s) for one in lead.first),
            "",
        ),
    )
    if told.settling is None:
        return made
    times = [seconds(told.settling.seconds)] * 3
    return replace(made, rows=(*made.rows[:-1], (SETTLING, "", told.settling.how, *times, ""), made.rows[-1]))


def ways_told(plans: Plans) -> dict[int, str]:
    """The ways around by motion, in words; with the target where the plans of both do not go alike."""
    found: dict[int, dict[Target, str]] = {}
    for target in Target:
        for way in plans.of(target).detours:
            found.setdefault(way.motion, {})[target] = way_told(len(way.points), way.around)
    return {
        motion: words.pop()
        if len(by_target) == len(Target) and len(words := {*by_target.values()}) == 1
        else "; ".join(f"{target.value} {way}" for target, way in by_target.items())
        for motion, by_target in found.items()
    }


def reports_record(reports: Mapping[str, Report], unchecked: Sequence[str]) -> dict[str, Any]:
    """What the judge says of every file as plain data, each case of each check."""
    return {
        "legal": all(report.legal for report in reports.values()),
        "files": {
            name: {
                "legal": report.legal,
                "checks": [finding_record(one) for one in report.findings],
                "advice": [finding_record(one) for one in report.advice],
                "too_coarse": report.too_coarse,
                "rows_per_second": report.grid.rate if report.grid else None,
                "missing_rows": report.missing or None,
            }
            for name, report in reports.items()
        },
        "unchecked": list(unchecked),
    }


def verdict(name: str, report: Report, unchecked: Sequence[str] = ()) -> str:
    """One line: legal or not, by how many findings, and what was not looked at; of a file on a bare grid also what its
    rate leaves open."""
    bad = sum(not finding.passed for finding in report.findings)
    lost = f"; {report.missing}" if report.missing else ""
    if report.too_coarse:
        return f"{name}: TOO COARSE to be judged ({bad} checks cannot be made){lost}"
    if bad:
        return f"{name}: ILLEGAL ({bad} checks failed){lost}"
    return "; ".join([f"{name}: legal{_granted(report)} ({len(report.findings)} checks){lost}", *unchecked])


def _granted(report: Report) -> str:
    """What rows on a bare grid leave open, as " at 250 Hz: dwell known to 8 ms, ..."; empty for others."""
    if (grid := report.grid) is None:
        return ""
    stops = f"stops to {grid.stop / MM:.2g} mm and {grid.rest:.2g} m/s"
    return f" at {grid.rate:.4g} Hz: dwell known to {grid.dwell * 1e3:.3g} ms, {stops}"
