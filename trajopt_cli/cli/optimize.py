"""`trajopt optimize PROGRAM`: the main job."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated

import typer

from trajopt_cli.cli.options import (
    AsJson,
    AssumeIdentity,
    CellPath,
    Entry,
    Jobs,
    LoopsOption,
    ProgramPaths,
    Quiet,
    TargetOption,
    TimeLimit,
    patience_of,
)
from trajopt_cli.cli.process import reading, wrote
from trajopt_cli.errors import InputError


def optimize(
    program: ProgramPaths,
    cell: CellPath = None,
    entry: Entry = None,
    assume_identity: AssumeIdentity = None,
    target: TargetOption = "stream",
    loops: LoopsOption = "keep",
    output: Annotated[
        Path | None, typer.Option(metavar="FOLDER", help="Results folder; default: results/PROGRAM.")
    ] = None,
    plots: Annotated[
        bool, typer.Option("--plots", help="Draw the chosen plan as well: SVG and PNG in the folder's plots/.")
    ] = False,
    jobs: Jobs = None,
    time_limit: TimeLimit = None,
    cycle_time: Annotated[
        float | None,
        typer.Option(
            "--cycle-time",
            metavar="S",
            help="The gentlest motion that takes S seconds, instead of the fastest: least acceleration effort.",
            show_default=False,
        ),
    ] = None,
    gentle: Annotated[
        bool, typer.Option("--gentle", help="The gentlest motion that takes at most 0.01 % longer than the fastest.")
    ] = False,
    as_json: AsJson = False,
    quiet: Quiet = False,
) -> None:
    """Find the fastest legal motion for PROGRAM, check it, and write it as joint CSV and as RAPID.

    Both targets are solved in every run; trajectory.csv carries the plan of --target. Exit code 1: the program cannot
    be done, or not in the time given, and why; or, with --target rapid, its text cannot carry the plan.

    \b
    Example:
      trajopt optimize programs/hinge_cell.mod --time-limit 60
      trajopt optimize programs/hinge_cell.mod --target rapid --quiet
    """
    from trajopt_cli.cli.console import answer_no, print_json, result, show, stdout, tell, warn
    from trajopt_cli.cli.progress import ProgressView
    from trajopt_cli.cli.remarks import told_first
    from trajopt_cli.cli.tables import motions_table, optimized_lines, optimized_record, saving_line
    from trajopt_cli.job import MAIN, read_job
    from trajopt_cli.pipeline.optimize import OptimizedJob, optimize_job
    from trajopt_cli.problem.editable import Loops
    from trajopt_cli.problem.objective import GENTLE, LEAST_TIME, LeastEffort
    from trajopt_cli.problem.plan import Target

    patience = patience_of(time_limit)
    if cycle_time is not None and not 0 < cycle_time < math.inf:
        raise InputError(f"--cycle-time: needs a time of more than 0 s, not {cycle_time:g}")
    if cycle_time is not None and gentle:
        raise InputError("--cycle-time and --gentle: give one of them; both are the gentlest plan, within other times")
    objective = GENTLE if gentle else LEAST_TIME if cycle_time is None else LeastEffort(cycle_time)
    with reading(program):
        job = read_job(program, cell, entry or MAIN, assume_identity or ())
    folder = output or Path("results") / job.program.name
    with ProgressView(patience, quiet) as view:
        answer = optimize_job(job, Target(target), folder, view.show, plots, Loops(loops), patience, jobs, objective)
    if not isinstance(answer, OptimizedJob):
        answer_no(answer, as_json)
    wrote(answer.folder)
    if as_json:
        print_json(optimized_record(answer, patience.interrupted))
    elif quiet:
        result(saving_line(answer.summary))
        for line in answer.summary.warnings:
            warn(f"warning: {line}")
    else:
        console = stdout()
        tell(console, [*told_first(answer.job.program.warnings)[0], saving_line(answer.summary), ""])
        show(console, motions_table(answer))
        tell(console, optimized_lines(answer))
    if patience.interrupted:
        best = answer.summary.plans.of(answer.summary.target).cycle_time_s
        warn(f"interrupted: the best plan so far, {best:.3f} s, was completed, judged and written to {answer.folder}")
    if answer.no_rapid is not None and answer.summary.target is Target.RAPID:
        warn(f"no RAPID text: {answer.no_rapid}")
        raise typer.Exit(1)
