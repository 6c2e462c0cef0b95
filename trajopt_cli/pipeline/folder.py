"""What is done with a results folder or a CSV file: judged again, resampled, its modules put together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from trajopt_cli.errors import ErrorKind, InputError, of_kind
from trajopt_cli.job import Job, read_results_job
from trajopt_cli.motion import TextFile
from trajopt_cli.pipeline.planning import judge
from trajopt_cli.problem.detours import held_against, quoted
from trajopt_cli.problem.plan import Plan, PlannedMotion, Target
from trajopt_cli.runs.results import CHOSEN, CSV, RapidModule, read_results
from trajopt_cli.runs.summary import DetourRow, MotionRow

if TYPE_CHECKING:
    from trajopt_cli.findings import Report


@dataclass(frozen=True)
class RapidFiles:
    """The optimised modules of a results folder. patch: their difference from the program as given, for patch -p1;
    difference: the same to read. kept: what the plan had to leave as programmed, and why. cycle: of the rapid plan [s].
    ways: which moves go around what, a line each.
    """

    modules: tuple[RapidModule, ...]
    patch: bytes
    difference: str
    kept: tuple[str, ...]
    cycle: float
    ways: tuple[str, ...] = ()


@of_kind(ErrorKind.RESULTS)
def verify_results(folder: Path, advice: bool = True) -> tuple[Job, dict[str, Report]]:
    """Judge the CSV files of a results folder against the program and cell inside it; reports by file name."""
    results = read_results(folder, judged=True)
    job = read_results_job(folder, judged=True)
    texts = {CSV[target]: (target, results.texts[CSV[target]]) for target in Target}
    if results.texts[CHOSEN] != results.texts[CSV[results.target]]:
        texts[CHOSEN] = (results.target, results.texts[CHOSEN])
    reports = {}
    for name, (target, text) in texts.items():
        detours, left_out = results.detours(target), results.dropped(target)
        program, dropped = held_against(job.program, job.plant, target, detours, left_out)
        reports[name] = judge(job.plant, program, text, str(folder / name), dropped, target, advice)
    return job, reports


@of_kind(ErrorKind.RESULTS)
def plans_of_results(folder: Path, job: Job) -> dict[Target, Plan]:
    """The plans of a results folder, whose job this is, without bound, grid and notes."""
    from trajopt_cli.joint_csv import read_csv_text

    results, plans = read_results(folder), {}
    if results.cycle_time is not None:
        text = "its plans are the gentlest in a given time, and sensitivity asks about the least time; give the program"
        raise InputError(text, file=str(folder))
    if len(results.summary.plans.rapid.motions) != len(job.program.motions):
        text = "its plans have other motions than this version reads in its program; run trajopt optimize again"
        raise InputError(text, file=str(folder))
    for target in Target:
        rows, _ = read_csv_text(results.texts[CSV[target]], str(folder / CSV[target]))
        trajectory = rows.of(job.plant.limits.names)
        motions, q = [], trajectory.q[0]
        for row in results.summary.plans.of(target).motions:
            motion, end = job.program.motions[row.index], np.array(row.axes_at_end)
            t_1 = row.start_s + row.time_s
            via = results.passings(target, row.index)
            motions.append(PlannedMotion(row.index, motion.source, row.start_s, t_1, q, end, "", row.dropped, via))
            q = end
        plans[target] = Plan(target, trajectory, tuple(motions), None, "", detours=results.detours(target))
    return plans


def verify_file(path: Path, job: Job, advice: bool = True) -> Report:
    """Judge a CSV file that anybody wrote against a program and its cell."""
    return judge(job.plant, job.program, _text(path), str(path), advice=advice)


@of_kind(ErrorKind.RESULTS)
def rapid_export(folder: Path) -> RapidFiles:
    """The optimised modules of a results folder. Raises InputError where the plan could not be written as RAPID."""
    from trajopt_cli.exporters.rapid_diff import patch, unified_diff
    from trajopt_cli.rapid.language.text import decode

    results = read_results(folder)
    if results.no_rapid is not None:
        raise InputError(f"holds no RAPID text: {results.no_rapid}", file=str(folder))
    given, texts = dict[str, TextFile](), dict[str, str]()
    for one in results.rapid:
        path = str(one.path)
        given[path] = TextFile(path, *decode(one.given))
        try:
            texts[path] = one.content.decode(given[path].encoding)
        except UnicodeDecodeError as error:
            why = f"byte {error.start} of the optimised {one.place} is no {given[path].encoding}, as the program is"
            raise InputError(f"{why}; make the folder again", file=str(folder)) from error
    rapid = results.summary.plans.rapid
    cycle = max((row.start_s + row.time_s for row in rapid.motions), default=0.0)
    lines = (_way_line(way, rapid.motions) for way in rapid.detours)
    ways = tuple(dict.fromkeys(lines))  # passes of one text say the same
    difference = unified_diff(given, texts)
    return RapidFiles(results.rapid, patch(given, texts), difference, tuple(results.summary.kept), cycle, ways)


def _way_line(way: DetourRow, motions: Sequence[MotionRow]) -> str:
    """A way around obstacles and its points, in words."""
    own = next(row for row in motions if row.index == way.motion)
    names = ", ".join(point.target for point in way.points)
    return f"{own.source}: {own.instruction} {own.target} goes around {quoted(way.around)} by {names}"


def _text(path: Path) -> str:
    if path.exists() and not path.is_file():
        raise InputError("is not a regular file; save the rows in one", file=str(path))
    try:
        return path.read_text(encoding="utf-8")
    except OSError as error:
        raise InputError(f"cannot read: {error.strerror}", file=str(path)) from error
    except UnicodeDecodeError as error:
        raise InputError(f"byte {error.start} is not UTF-8 text; save the rows as UTF-8", file=str(path)) from error
