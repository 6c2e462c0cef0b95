"""`trajopt check PROGRAM`: one traffic light, for people in a hurry and commit hooks."""

from __future__ import annotations

import typer

from trajopt_cli.cli import options as opt
from trajopt_cli.cli.process import job_of


def check(
    program: opt.ProgramPaths,
    cell: opt.CellPath = None,
    entry: opt.Entry = None,
    assume_identity: opt.AssumeIdentity = None,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
) -> None:
    """Does PROGRAM read, reach, keep its limits and touch nothing, as it is written? Nothing is optimised or written.

    Exit code 0: yes. 1: no, and the worst line. 2: it cannot be read. As a commit hook: trajopt check PROGRAM --quiet

    \b
    Example:
      trajopt check programs/hinge_cell.mod
    """
    from dataclasses import asdict

    from trajopt_cli.cli.console import print_answer
    from trajopt_cli.cli.remarks import told_first
    from trajopt_cli.runs.uncertainty import WRITTEN
    from trajopt_cli.study.check import check
    from trajopt_cli.table import Bad, Good, tabulate

    job = job_of(program, cell, entry, assume_identity)
    answer = check(job)
    unsure = answer.unsure
    took = "" if answer.cycle is None or unsure is None else f", {answer.cycle:.3f} s{unsure.around(WRITTEN)}"
    verdict = f"{job.title}: {'OK' if answer.ok else 'NO'}{took}"
    line = "; ".join([verdict, answer.worst, *job.plant.unchecked, *told_first(job.program.warnings)[0]])
    record = {"ok": answer.ok, "program": str(job.program_path), "cycle_time_s": answer.cycle,
              "uncertainty": unsure and unsure.model_dump(),
              "worst": answer.worst, "checks": [asdict(one) for one in answer.lights]}  # fmt: skip
    columns = {
        "check": lambda one: one.check,
        "": lambda one: (Bad if one.state == "NO" else Good)(one.state),
        "what": lambda one: one.said,
    }
    table = tabulate(f"{job.title} on {job.plant.robot.name}, as written", answer.lights, columns)
    print_answer(as_json, quiet, lambda: record, line, [table, line])
    if not answer.ok:
        raise typer.Exit(1)
