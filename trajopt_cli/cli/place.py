"""`trajopt place PROGRAM`: where the robot's base, its rail or a work object should stand."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from trajopt_cli.cli import options as opt
from trajopt_cli.cli.process import job_of, wrote
from trajopt_cli.cli.study import Scheduler, tasks_on

if TYPE_CHECKING:
    from trajopt_cli.table import TextTable


def place(
    program: opt.ProgramPaths,
    what: Annotated[
        str, opt.given("--what", "base|rail|station:NAME", "What stands elsewhere; NAME is a work object's (wobjdata).")
    ],
    range_: Annotated[
        list[str],
        opt.given(
            "--range",
            "KEY=LOW..HIGH",
            "How far from where it stands now: x, y, z of the world [m] or yaw [rad], as in x=-300mm..300mm, "
            "yaw=-30deg..30deg; of a rail also along, across, height. One to four of them.",
        ),
    ],
    cell: opt.CellPath = None,
    entry: opt.Entry = None,
    assume_identity: opt.AssumeIdentity = None,
    target: opt.TargetOption = "stream",
    points: Annotated[
        int | None, opt.given("--points", "N", "Places of the coarse search; default: 30 per range.", min=4)
    ] = None,
    apply: Annotated[
        Path | None, opt.given("--apply", "FILE.yaml", "Write a copy of the cell file with the best place in it.")
    ] = None,
    output: Annotated[Path | None, opt.results_at("results/PROGRAM_place")] = None,
    as_json: opt.AsJson = False,
    quiet: opt.Quiet = False,
    jobs: opt.Jobs = None,
    scheduler: Scheduler = None,
    time_limit: opt.TimeLimit = None,
) -> None:
    """Find where the base, the rail or a work object should stand for the shortest cycle, and draw the map.

    All of PROGRAM's targets stay where they are, except those in the work object that is moved; obstacles stay.
    Every place is planned under the same limits and checked. Exit code 1: nothing in the ranges can be done, and why.

    \b
    Example:
      trajopt place programs/hinge_cell.mod --what rail --range height=-10cm..0
    """
    from trajopt_cli.cli.console import no, print_answer, told
    from trajopt_cli.cli.progress import ProgressView
    from trajopt_cli.problem.plan import Target
    from trajopt_cli.runs.files import check_file, write_file
    from trajopt_cli.runs.folder import check_replaceable
    from trajopt_cli.study.place import place
    from trajopt_cli.study.place_record import impossible_lines, place_record, place_table, said, write_place
    from trajopt_cli.study.places import parse_ranges, site_of
    from trajopt_cli.table import Verbatim, by_name

    ranges = parse_ranges(range_)
    patience = opt.patience_of(time_limit)
    job = job_of(program, cell, entry, assume_identity)
    site = site_of(job, what, ranges)
    folder = output or Path("results") / f"{job.program.name}_place"
    check_replaceable(folder)
    if apply is not None:
        site.check_apply(apply)
        check_file(apply, "--apply")
    with ProgressView(patience, quiet) as view, tasks_on(scheduler, patience):
        answer = place(site, Target(target), view.show, patience, jobs, points)
    best, files = answer.best, (*job.program.files, str(job.cell_path))
    if best is None:
        nearest = answer.impossible[0]
        why = by_name(f"{said(site, nearest)}: {nearest.why}", files)
        line = f"{site.in_words}: none of {len(answer.places)} places can be done; {why}"
        no([line], as_json, answer="infeasible", tried=len(answer.places))
    table = place_table(program[0].name or job.title, answer)
    lines = [by_name(line, files) for line in (*impossible_lines(answer), *answer.remarks)]
    count = write_place(folder, answer, table, lines)
    wrote(folder)
    where = "the program" if apply is None and site.name else str(job.cell_path)
    paste = [] if best is answer.present else [Verbatim(text) for text in site.to_paste(best.offset).splitlines()]
    pasted = ["", f"to paste into {where}:", *paste] if paste else []
    parts: list[TextTable | str] = [table, *lines, *pasted, "", answer.in_words]
    print_answer(as_json, quiet, lambda: place_record(answer), answer.in_words, parts)
    if apply is not None:
        write_file(apply, site.changed_cell(best.offset, str(apply)).encode())
        wrote(apply)
    written = [f"written to {folder}: report.html, place.json, its map in plots, and {count - 3} files more"]
    written += [] if apply is None else [f"written to {apply}: the cell file with the best place"]
    told(written, as_json, quiet)
