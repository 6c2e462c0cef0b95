"""`trajopt verify RESULTS|FILE.csv`: the judge's word on files, whoever wrote them."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from trajopt_cli.cli import options as opt
from trajopt_cli.cli.process import job_of, reading
from trajopt_cli.errors import InputError
from trajopt_cli.file_kinds import refuse_other

if TYPE_CHECKING:
    from trajopt_cli.table import TextTable


def verify(
    what: Annotated[Path, typer.Argument(metavar="RESULTS|FILE.csv", help="A results folder, or a joint CSV file.")],
    program: Annotated[
        list[Path] | None,
        typer.Option(metavar="PROGRAM", help="The program a CSV file executes; repeat it for several modules."),
    ] = None,
    cell: opt.CellPath = None,
    entry: opt.Entry = None,
    assume_identity: opt.AssumeIdentity = None,
    task: Annotated[Path | None, opt.given("--task", "FILE.yaml", "The iiwa task a CSV file executes.")] = None,
    arm: Annotated[str | None, opt.given("--robot", "NAME", "The iiwa whose limits a CSV file shall keep.")] = None,
    everything: Annotated[
        bool, typer.Option("--all", help="List every case, not only the worst of each check.")
    ] = False,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
) -> None:
    """Check trajectories against program or task, and limits. Exit code 0: legal, 1: not, or too coarse to tell.

    \b
    Example:
      trajopt optimize programs/hinge_cell.mod
      trajopt verify results/hinge_cell
    """
    from trajopt_cli.cli.console import print_answer, warn
    from trajopt_cli.cli.remarks import told_first
    from trajopt_cli.cli.tables import reports_record, verdict
    from trajopt_cli.findings import failures
    from trajopt_cli.pipeline.folder import verify_file, verify_results
    from trajopt_cli.runs.folder import TASK, kind_of
    from trajopt_cli.table import findings_table

    unchecked: tuple[str, ...] = ()  # of an iiwa's files
    bodies: tuple[str, ...] = ()  # of a cell: said with the verdict
    advice = as_json or not quiet  # of which a line alone says nothing
    head: list[str] = []
    of_program = bool(program) or cell is not None or entry is not None or bool(assume_identity)
    if what.is_file():
        refuse_other(what, "joint CSV")
    if what.is_dir():
        for given, its, options in (
            (program or cell, "program and cell", "--program and --cell"),
            (entry is not None or assume_identity, "entry and assumptions", "--entry and --assume-identity"),
            (task or arm is not None, "task and robot", "--task and --robot"),
        ):
            if given:
                raise typer.BadParameter(f"a results folder holds its own {its}; leave {options} out")
        if kind_of(what) == TASK:
            from trajopt_cli.iiwa import verify_folder

            judged = verify_folder(what)
            reports, unchecked = judged.reports, judged.unchecked
        else:
            with reading():
                job, reports = verify_results(what, advice)
            bodies = job.plant.unchecked
            head = told_first(job.program.warnings)[0]
    elif not what.exists():
        raise InputError("no such file or folder", file=str(what))
    elif task is not None or arm is not None:
        if of_program or (task is not None and arm is not None):
            raise typer.BadParameter("give one of --program, --task and --robot; --cell and the like go with --program")
        from trajopt_cli.iiwa import verify_joints

        judged = verify_joints(what, task, arm)
        reports, unchecked = judged.reports, judged.unchecked
    elif not program:
        raise typer.BadParameter(f"{what} is a file: say which --program it executes; of an iiwa --task or --robot")
    else:
        job = job_of(program, cell, entry, assume_identity)
        reports, bodies = {what.name: verify_file(what, job, advice)}, job.plant.unchecked
        head = told_first(job.program.warnings)[0]
    for line in head if quiet and not as_json else ():
        warn(line)
    parts: list[TextTable | str] = [*head]
    for name, report in reports.items():
        parts.append(findings_table(f"{name}: legality", report.findings, everything))
        if report.advice:
            title = f"{name}: advice, which does not affect the verdict"
            parts.append(findings_table(title, report.advice, everything))
    parts += [f"not checked: {line}" for line in unchecked]
    verdicts = {name: verdict(name, report, bodies) for name, report in reports.items()}
    for name, report in reports.items():
        parts += [f"advice: {line}" for line in failures(report.advice)]
        parts += [verdicts[name], *(f"  {line}" for line in failures(report.findings))]
    record = partial(reports_record, reports, (*bodies, *unchecked))
    print_answer(as_json, quiet, record, "\n".join(verdicts.values()), parts)
    if not all(report.legal for report in reports.values()):
        raise typer.Exit(1)
