"""`trajopt study show FOLDER` and `trajopt study optimize STUDY.yaml`: what the points of a study say together."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from trajopt_cli.cli.options import AsJson, Jobs, Quiet, TimeLimit, patience_of
from trajopt_cli.cli.process import wrote
from trajopt_cli.cli.study import Output, Scheduler, StudyFile, app, client_for, study_extra
from trajopt_cli.errors import InputError

__all__ = ["app"]


@app.command("show", short_help="The best points of a study, what matters most, and its page.")
def show(
    folder: Annotated[Path, typer.Argument(metavar="FOLDER", help="Results folder of trajopt study.")],
    by: Annotated[
        str | None,
        typer.Option("--by", metavar="COLUMN", help="The answer that counts; default: the first of them, as rapid_s."),
    ] = None,
    against: Annotated[
        str | None,
        typer.Option(
            "--against", metavar="COLUMN", help="The Pareto front of both; default: price, where it is known."
        ),
    ] = None,
    as_json: AsJson = False,
    quiet: Quiet = False,
) -> None:
    """Show the best points of a study, what matters most, and the front of two answers; and draw its page.

    A study that is not done yet is shown as far as it is. Exit code 1: no point has an answer, and why.

    \b
    Example:
      trajopt study show results/which_rail --by saved_s
    """
    from dataclasses import asdict

    from trajopt_cli.cli.console import no, print_json, result, stdout, tell, told
    from trajopt_cli.cli.console import show as show_table
    from trajopt_cli.parameter_study.analysis import StudyRows, variance_shares
    from trajopt_cli.parameter_study.kept_plan import PLANS
    from trajopt_cli.parameter_study.study_page import BEST, front, reasons, study_page, summary_lines, tables
    from trajopt_cli.runs import REPORT
    from trajopt_cli.runs.files import write_file

    with study_extra():
        from trajopt_cli.parameter_study.results import open_study
    study = open_study(folder)
    rows = StudyRows(study.rows().to_pydict(), {one.name: one.unit for one in study.columns})
    if not rows.answers:
        no(["no point of the study has an answer", *reasons(rows)], as_json)
    name = rows.chosen(by)
    other = rows.chosen(against) if against else "price" if "price" in rows.answers and name != "price" else None
    shares = variance_shares(rows, name)
    plans = {int(page.parts[-2]): page.relative_to(folder).as_posix() for page in folder.glob(f"{PLANS}/*/{REPORT}")}
    lines = summary_lines(rows, name, study.points)
    if as_json:
        record = {"by": name, "points": study.points, "summary": lines, "best": rows.records(rows.best(name)[:BEST])}
        record |= {"front": rows.records(front(rows, name, other)) if other else None, "against": other}
        print_json({**record, "shares": None if shares is None else asdict(shares)})
    elif quiet:
        result("; ".join(lines[:2]))
    else:
        console = stdout()
        for made in tables(rows, name, other, shares).values():
            show_table(console, made)
            console.print()
        if shares is not None:
            tell(console, [shares.in_words])
        tell(console, ["", *lines])
    write_file(folder / REPORT, study_page(folder.resolve().name, rows, name, other, study.points, shares, plans))
    wrote(folder / REPORT)
    told([f"written to {folder / REPORT}: open it in a browser"], as_json, quiet)


@app.command("plan", short_help="Plan points of a study wholly, and keep the plans with their pages.")
def plan(
    study: StudyFile,
    points: Annotated[list[int], typer.Argument(metavar="POINT...", help="Their numbers, as 'study show' has them.")],
    time_limit: TimeLimit = None,
    output: Output = None,
    quiet: Quiet = False,
) -> None:
    """Plan points of a study as trajopt optimize does, into plans/POINT of its results; 'study show' links to them.

    Exit code 1: one of them cannot be done, and why.

    \b
    Example:
      trajopt study plan programs/studies/which_rail.yaml 21 --time-limit 60
    """
    from trajopt_cli.cli.console import no, stdout, tell
    from trajopt_cli.parameter_study.kept_plan import PLANS, keep_plan
    from trajopt_cli.parameter_study.study_file import read_study
    from trajopt_cli.table import seconds

    patience_of(time_limit)
    asked, folder, bad = read_study(study), output or Path("results") / study.stem, list[str]()
    for point in points:
        row = keep_plan(asked, point, folder, [] if time_limit is None else ["--time-limit", f"{time_limit:g}"])
        if row["status"] != "ok":
            bad.append(f"point {point}: {row['reason']}")
            continue
        wrote(folder / PLANS / str(point))
        line = f"point {point}: {seconds(row['as_written_s'], 'not known')} s → {seconds(row['rapid_s'])} s"
        tell(stdout(quiet), [f"{line}, in {folder / PLANS / str(point)}"])
    if bad:
        no(bad, False)


@app.command("optimize", short_help="Search for the best point of what a study varies.")
def optimize(
    study: StudyFile,
    by: Annotated[str, typer.Option("--by", metavar="COLUMN", help="The answer to make best.")] = "rapid_s",
    constraint: Annotated[
        list[str] | None,
        typer.Option(
            "--constraint",
            metavar="TEXT",
            help="What the best point keeps, as 'price <= 20000' or 'limits.rail.velocity <= 2', SI; may be repeated.",
            show_default=False,
        ),
    ] = None,
    points: Annotated[int, typer.Option("--points", min=1, metavar="N", help="Points that are tried.")] = 100,
    seed: Annotated[int, typer.Option("--seed", min=0, metavar="N", help="Of the search's random numbers.")] = 0,
    at_once: Annotated[
        int, typer.Option("--at-once", min=1, metavar="N", help="Points tried before the search learns from them.")
    ] = 8,
    scheduler: Scheduler = None,
    jobs: Jobs = None,
    output: Annotated[
        Path | None, typer.Option("--output", metavar="FOLDER", help="Results folder; default: results/STUDY_best.")
    ] = None,
    quiet: Quiet = False,
) -> None:
    """Search for the best point of what a study varies, within constraints, instead of trying all of them.

    The answer depends on --seed, --points and --at-once, not on the cluster. A search that was stopped goes on. Exit
    code 1: no point that was tried can be done and keeps the constraints.

    \b
    Example:
      trajopt study optimize programs/studies/which_rail.yaml --points 12
    """
    from trajopt_cli.cli.console import no, result, stdout, tell
    from trajopt_cli.cli.progress import ProgressView
    from trajopt_cli.parameter_study.study_file import read_study

    asked = read_study(study)
    with study_extra():
        from trajopt_cli.parameter_study.search import Goal, search
    answers = [f"{one}_s" for one in (*asked.inputs.answers, "saved")] + ["price"] * (asked.inputs.price is not None)
    if by not in answers:
        raise InputError(f"--by {by}: this study's answers are {', '.join(answers)}", file=str(study))
    goal = Goal(by, tuple(constraint or ()), points, seed, at_once)
    folder = output or Path("results") / f"{study.stem}_best"
    with client_for(scheduler, jobs, asked.inputs.memory) as client, ProgressView(quiet=quiet) as view:
        best = search(asked, goal, folder, client, view.show)
    wrote(folder)
    if best is None:
        said = f"none of {points} points can be done and keeps the constraints; column reason in {folder} says more"
        no([said], False)
    names = [one.name for one in asked.inputs.columns if one.meaning.startswith(("offset: ", "cell file: "))]
    varied = (f"{name} {f'{best[name]:.6g}' if isinstance(best[name], float) else best[name]}" for name in names)
    line = f"best of {points} points: {by} {best[by]:.3f} at {', '.join(varied)}"
    result(line) if quiet else tell(stdout(), [line, f"written to {folder}; 'trajopt study show {folder}' shows all"])
