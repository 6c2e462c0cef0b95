"""`trajopt optimize PROGRAM`: the main job."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from trajopt_cli.cli import options as opt
from trajopt_cli.cli.process import job_of, wrote
from trajopt_cli.errors import InputError

if TYPE_CHECKING:
    from trajopt_cli.table import TextTable


def optimize(
    program: opt.ProgramPaths,
    cell: opt.CellPath = None,
    entry: opt.Entry = None,
    assume_identity: opt.AssumeIdentity = None,
    target: opt.ChosenTarget = None,
    loops: opt.LoopsOption = "keep",
    output: Annotated[Path | None, opt.results_at("results/PROGRAM")] = None,
    export: Annotated[
        Path | None,
        opt.given(
            "--export", "FILE.mod", "Write the program with the rapid plan in it, too; a folder for several modules."
        ),
    ] = None,
    plots: Annotated[
        bool, typer.Option("--plots", help="Draw the chosen plan as well: SVG and PNG in the folder's plots/.")
    ] = False,
    jobs: opt.Jobs = None,
    time_limit: opt.TimeLimit = None,
    cycle_time: Annotated[
        float | None,
        opt.given(
            "--cycle-time",
            "S",
            "The gentlest motion that takes S seconds, instead of the fastest: least acceleration effort.",
        ),
    ] = None,
    gentle: Annotated[
        bool, typer.Option("--gentle", help="The gentlest motion that takes at most 0.01 % longer than the fastest.")
    ] = False,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
    verbose: opt.Verbose = False,
) -> None:
    """Find the fastest legal motion for PROGRAM, check it, and write it as joint CSV and as RAPID.

    Both targets are solved in every run: what the RAPID controller can drive, and what a joint stream (EGM) would add.
    Exit code 1: the program cannot be done, or not in the time given, and why; or, with --target rapid or --export, its
    text cannot carry the plan.

    \b
    Example:
      trajopt optimize programs/hinge_cell.mod --time-limit 60
      trajopt optimize programs/hinge_cell.mod --quiet --export faster.mod
    """
    from trajopt_cli.cli.console import answer_no, print_answer, warn
    from trajopt_cli.cli.export import rapid_places, write_rapid
    from trajopt_cli.cli.progress import ProgressView
    from trajopt_cli.cli.remarks import told_first
    from trajopt_cli.cli.tables import motions_table, optimized_lines, optimized_record, saving_line
    from trajopt_cli.pipeline.folder import rapid_export
    from trajopt_cli.pipeline.optimize import OptimizedJob, optimize_job
    from trajopt_cli.problem.editable import Loops
    from trajopt_cli.problem.objective import GENTLE, LEAST_TIME, LeastEffort
    from trajopt_cli.problem.plan import Target
    from trajopt_cli.runs.results import distinct_names

    patience = opt.patience_of(time_limit)
    if cycle_time is not None and not 0 < cycle_time < math.inf:
        raise InputError(f"--cycle-time: needs a time of more than 0 s, not {cycle_time:g}")
    if cycle_time is not None and gentle:
        raise InputError("--cycle-time and --gentle: give one of them; both are the gentlest plan, within other times")
    if quiet and verbose:
        raise InputError("--quiet and --verbose: give one of them")
    objective = GENTLE if gentle else LEAST_TIME if cycle_time is None else LeastEffort(cycle_time)
    job = job_of(program, cell, entry, assume_identity)
    folder = output or Path("results") / job.program.name
    if export is not None:
        own = list(job.program.files)
        names = [Path(name) for name in distinct_names(own).values()]
        rapid_places(export, folder, names, map(Path, own), "--export")
    with ProgressView(patience, quiet) as view:
        answer = optimize_job(
            job, Target(target) if target else None, folder, view.show, plots, Loops(loops), patience, jobs, objective
        )
    if not isinstance(answer, OptimizedJob):
        answer_no(answer, as_json)
    wrote(answer.folder)
    exported = []
    if export is not None and answer.no_rapid is None:
        exported = write_rapid(rapid_export(answer.folder), export, answer.folder, "--export")
        wrote(export)
    before, said = told_first(answer.job.program.warnings)[0], [saving_line(answer), answer.summary.verdict]
    sure, cycle = answer.summary.uncertainty, answer.summary.plans.rapid.cycle_time_s
    parts: list[TextTable | str] = [*before]
    parts += [*said, *sure.intervals(answer.lead.first, answer.summary.passes), "", motions_table(answer)]
    parts += [*optimized_lines(answer, verbose), *(f"wrote {one} (RAPID plan, {cycle:.3f} s)" for one in exported)]
    record = {**optimized_record(answer, patience.interrupted), "exported": exported}
    print_answer(as_json, quiet, lambda: record, "; ".join([*said, *before]), parts)
    if patience.interrupted:
        best = answer.summary.plans.of(answer.lead).cycle_time_s
        warn(f"interrupted: the best plan so far, {best:.3f} s, was completed, judged and written to {answer.folder}")
    if answer.no_rapid is not None and (answer.summary.target is Target.RAPID or export is not None):
        warn(f"no RAPID text: {answer.no_rapid}")
        raise typer.Exit(1)
